// How large a scene file may be.
#pragma once

#include <cstddef>

namespace weft {

/// [bytes]. The largest sensible scene lists particles to pin; a million of them take 8 MiB.
inline constexpr std::size_t largest_scene_file = std::size_t{16} * 1024 * 1024;

}  // namespace weft
