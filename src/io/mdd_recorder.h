// Point cache MDD with its mesh, for LightWave, Blender, Modo.
#pragma once

#include <optional>

#include "io/cache_companions.h"
#include "io/output_file.h"
#include "io/point_writer.h"
#include "weft/recorder.h"

namespace weft {

/// NAME.mdd, NAME.obj, open_in_blender.py. The cache is big-endian: int32 frames, int32 particles,
/// a float time [s] for each frame, then for each frame every particle's x, y, z as floats [m].
class MddRecorder final : public Recorder {
public:
    [[nodiscard]] FrameNeeds needs() const override { return rounded_positions_alone; }
    void begin(const RecordingPlan& plan) override;
    void frame(const Frame& frame) override;
    std::vector<std::filesystem::path> finish() override;

private:
    void write_head(std::size_t time_slots);

    RecordingPlan plan_;
    std::size_t planned_ = 0;
    std::vector<float> times_;
    std::optional<OutputFile> cache_;
    PointWriter points_{std::endian::big};
    std::optional<CacheCompanions> companions_;
};

}  // namespace weft
