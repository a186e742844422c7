// Point caches read back, each with the OBJ mesh beside it.
#pragma once

#include <filesystem>
#include <memory>

#include "io/recording_file.h"

namespace weft {

/// Opens NAME.pc2 and NAME.obj. @throws Error (file).
std::unique_ptr<RecordedMotion> open_pc2(const std::filesystem::path& path);

/// Opens NAME.mdd and NAME.obj. @throws Error (file).
std::unique_ptr<RecordedMotion> open_mdd(const std::filesystem::path& path);

}  // namespace weft
