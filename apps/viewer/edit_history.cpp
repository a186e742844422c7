#include "viewer/edit_history.h"

#include <cassert>
#include <limits>
#include <utility>

namespace weft::viewer {

namespace {

constexpr std::size_t most_states = 200;
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

}  // namespace

EditHistory::EditHistory(SceneDescription scene) {
    states_.push_back({std::move(scene), {}});
}

void EditHistory::edit(SceneDescription scene, std::string what) {
    // What was saved is a state of its own, even in the middle of a gesture.
    if (in_gesture_ && states_[present_].what == what && !saved()) {
        states_[present_].scene = std::move(scene);
        return;
    }
    if (saved_ != nowhere && saved_ > present_) saved_ = nowhere;
    states_.resize(present_ + 1);
    states_.push_back({std::move(scene), std::move(what)});
    ++present_;
    in_gesture_ = true;
    if (states_.size() <= most_states) return;
    states_.erase(states_.begin());
    --present_;
    if (saved_ != nowhere) saved_ = saved_ == 0 ? nowhere : saved_ - 1;
}

const std::string& EditHistory::undo_what() const {
    assert(can_undo());
    return states_[present_].what;
}

const std::string& EditHistory::redo_what() const {
    assert(can_redo());
    return states_[present_ + 1].what;
}

void EditHistory::undo() {
    in_gesture_ = false;
    if (can_undo()) --present_;
}

void EditHistory::redo() {
    in_gesture_ = false;
    if (can_redo()) ++present_;
}

}  // namespace weft::viewer
