// Which frames of a long recording are kept: even spacing, rounded to whole frames.
#include "io/frame_selection.h"

#include <algorithm>

namespace weft {

FrameSelection::FrameSelection(std::size_t planned, std::size_t most)
    : planned_(std::max<std::size_t>(planned, 1)), kept_(std::min(planned_, most)) {}

bool FrameSelection::keep(std::size_t index) {
    if (next_ == kept_) return false;
    const std::size_t gaps = std::max<std::size_t>(kept_ - 1, 1);
    const std::size_t wanted = (next_ * (planned_ - 1) + gaps / 2) / gaps;
    if (index != wanted) return false;
    ++next_;
    return true;
}

}  // namespace weft
