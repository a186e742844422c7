// The dialogs about saving: where to, and what to do with changes that were not.
#pragma once

#include <optional>
#include <string>

namespace weft::viewer {

struct SaveChoice {
    std::string file;
    bool with_state = false;  ///< begin with what is on the screen
};

class SaveDialog {
public:
    /// @param may_keep_state whether what is on the screen differs from a fresh flight.
    void open(const std::string& suggested, bool may_keep_state);
    [[nodiscard]] bool is_open() const { return is_open_; }
    void close() { is_open_ = false; }
    void complain(const std::string& why) { complaint_ = why; }

    std::optional<SaveChoice> draw();

private:
    bool is_open_ = false;
    bool may_keep_state_ = false, with_state_ = true, replace_ = false;
    std::string file_, complaint_, allowed_to_replace_;
};

enum class UnsavedAnswer { none, save, discard, cancel };
/// Asks about changes that opening or quitting would lose.
UnsavedAnswer unsaved_dialog(bool is_open, const std::string& name);

}  // namespace weft::viewer
