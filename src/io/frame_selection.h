// Which frames of a long recording are kept where a format has room for few.
#pragma once

#include <cstddef>

namespace weft {

/// Keeps frame 0, the last planned frame, and frames spread evenly between them. Frames are asked
/// for in order, so nothing need be held until the end.
class FrameSelection {
public:
    /// @param planned frames to come; @param most frames to keep, at least 2.
    FrameSelection(std::size_t planned, std::size_t most);

    /// Whether frame `index` is kept; indices rise from call to call.
    bool keep(std::size_t index);

    /// Frames kept when all planned ones have come.
    [[nodiscard]] std::size_t kept_of_all() const { return kept_; }

private:
    std::size_t planned_, kept_;
    std::size_t next_ = 0;
};

}  // namespace weft
