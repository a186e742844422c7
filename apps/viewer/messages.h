// What the window says for a while: refusals, errors, files written.
#pragma once

#include <string>
#include <vector>

#include "viewer/frame_times.h"

namespace weft::viewer {

enum class MessageKind { done, trouble };

struct Message {
    MessageKind kind = MessageKind::done;
    std::string text;
    Clock::time_point until;
};

class Messages {
public:
    /// Shown for some seconds; the same text again only prolongs the first.
    void add(MessageKind kind, const std::string& text);
    /// Those that are to be seen now; others are forgotten.
    const std::vector<Message>& present();
    /// Only for the report: it is shown elsewhere.
    void note(const std::string& text) { all_.push_back(text); }
    void dismiss();
    /// All that ever were, for the report.
    [[nodiscard]] const std::vector<std::string>& all() const { return all_; }

private:
    std::vector<Message> present_;
    std::vector<std::string> all_;
};

}  // namespace weft::viewer
