// A folder with one PLY file a frame.
#pragma once

#include <optional>

#include "io/output_folder.h"
#include "weft/recorder.h"

namespace weft {

/// NAME.ply-frames/NAME.0000.ply and so on, binary little-endian: for every surface vertex x, y, z
/// [m], the normal nx, ny, nz and the texture co-ordinates s, t (t upward); quads and triangles.
class PlySequenceRecorder final : public Recorder {
public:
    [[nodiscard]] FrameNeeds needs() const override { return {.velocities = false}; }
    void begin(const RecordingPlan& plan) override;
    void frame(const Frame& frame) override;
    std::vector<std::filesystem::path> finish() override;

private:
    RecordingPlan plan_;
    std::vector<std::string> names_;
    std::optional<OutputFolder> folder_;
};

}  // namespace weft
