// A folder with one OBJ file a frame.
#pragma once

#include <optional>

#include "io/output_folder.h"
#include "weft/recorder.h"

namespace weft {

/// NAME.obj-frames/NAME.0000.obj and so on: a v and a vn line for every particle [m], a vt line for
/// every surface vertex, quads and triangles.
class ObjSequenceRecorder final : public Recorder {
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
