// NumPy arrays of positions, velocities and times.
#pragma once

#include <optional>

#include "io/output_file.h"
#include "io/point_writer.h"
#include "weft/recorder.h"

namespace weft {

/// NAME.positions.npy and NAME.velocities.npy, [frame, particle, 3] in the run's precision [m],
/// [m/s]; NAME.times.npy, [frame] in double [s]. Little-endian, NumPy format 1.0.
class NpyRecorder final : public Recorder {
public:
    [[nodiscard]] FrameNeeds needs() const override { return {.normals = false}; }
    void begin(const RecordingPlan& plan) override;
    void frame(const Frame& frame) override;
    std::vector<std::filesystem::path> finish() override;

private:
    void write_heads();
    void write_vectors(OutputFile& file, std::span<const Vec3d> vectors);

    std::size_t particles_ = 0, frames_ = 0;
    Precision precision_ = Precision::f32;
    PointWriter points_{std::endian::little};
    std::optional<OutputFile> positions_, velocities_, times_;
};

}  // namespace weft
