// Point cache PC2 with its mesh, for Blender, Houdini, 3ds Max.
#pragma once

#include <optional>

#include "io/cache_companions.h"
#include "io/output_file.h"
#include "io/point_writer.h"
#include "weft/recorder.h"

namespace weft {

/// NAME.pc2, NAME.obj, open_in_blender.py. The cache is little-endian: a head of 32 bytes, then for
/// each frame every particle's x, y, z as floats [m]; 32 + 12 * particles * frames bytes in all.
class Pc2Recorder final : public Recorder {
public:
    [[nodiscard]] FrameNeeds needs() const override { return rounded_positions_alone; }
    void begin(const RecordingPlan& plan) override;
    void frame(const Frame& frame) override;
    std::vector<std::filesystem::path> finish() override;

private:
    void write_head();

    std::size_t particles_ = 0, frames_ = 0;
    std::optional<OutputFile> cache_;
    PointWriter points_{std::endian::little};
    std::optional<CacheCompanions> companions_;
};

}  // namespace weft
