// A recorder for formats that must know how many frames will come, used where nobody does.
#pragma once

#include <memory>
#include <string_view>

#include "weft/recorder.h"

namespace weft::viewer {

/// Keeps the frames in a file without a name beside the recording to be, and writes the recording
/// itself when it ends.
std::unique_ptr<Recorder> make_spooled_recorder(std::string_view format);

/// A recorder of any format that may be told a frame count of 0: that it is not known.
/// @throws Error (usage) where no such format exists.
std::unique_ptr<Recorder> make_open_ended_recorder(std::string_view format);

}  // namespace weft::viewer
