// Undo and redo of changes to a scene.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "weft/scene.h"

namespace weft::viewer {

class EditHistory {
public:
    explicit EditHistory(SceneDescription scene);

    /// @param what one could say after "Undo": "wind velocity". Changes of the same thing are one
    ///             until end_gesture(), so that a slider's drag is undone at once.
    void edit(SceneDescription scene, std::string what);
    void end_gesture() { in_gesture_ = false; }

    [[nodiscard]] const SceneDescription& scene() const { return states_[present_].scene; }
    [[nodiscard]] bool can_undo() const { return present_ > 0; }
    [[nodiscard]] bool can_redo() const { return present_ + 1 < states_.size(); }
    [[nodiscard]] const std::string& undo_what() const;  ///< @pre can_undo()
    [[nodiscard]] const std::string& redo_what() const;  ///< @pre can_redo()
    void undo();
    void redo();
    /// Whether the present scene is the one last given to mark_saved(), or the first.
    [[nodiscard]] bool saved() const { return present_ == saved_; }
    void mark_saved() { saved_ = present_; }

private:
    struct State {
        SceneDescription scene;
        std::string what;  ///< changed to come here
    };
    std::vector<State> states_;  ///< 200 at most: older ones are forgotten
    std::size_t present_ = 0, saved_ = 0;
    bool in_gesture_ = false;
};

}  // namespace weft::viewer
