// Animated meshes as binary glTF 2.0.
#pragma once

#include <optional>

#include "io/byte_order.h"
#include "io/frame_selection.h"
#include "io/glb_document.h"
#include "io/output_file.h"
#include "weft/recorder.h"

namespace weft {

/// NAME.glb: the cloth at frame 0 with one morph target for each further frame, a linear animation
/// of their weights, normals, texture co-ordinates and the scene's texture. Frames go to the file
/// as they come; the JSON before them gets room for the planned ones and is written at the end.
/// Beyond 250 targets, or 4 GiB, frames are thinned evenly; the first and the last stay.
class GlbRecorder final : public Recorder {
public:
    static constexpr std::size_t most_targets = 250;

    [[nodiscard]] FrameNeeds needs() const override { return {.velocities = false}; }

    /// @throws Error (file) also where the texture cannot be read, or one frame is beyond 4 GiB.
    void begin(const RecordingPlan& plan) override;
    void frame(const Frame& frame) override;
    std::vector<std::filesystem::path> finish() override;
    [[nodiscard]] std::vector<std::string> warnings() const override;

private:
    /// A copy of a frame that was left out.
    struct HeldFrame {
        std::size_t number = 0;
        double time = 0.0;
        std::vector<Vec3d> positions;
        std::vector<Vec3f> normals;
    };

    [[nodiscard]] std::size_t frames_that_fit(std::size_t picture_bytes) const;
    void reserve_json();
    void write_constant_part(std::span<const std::uint8_t> picture);
    /// @param number of the frame in the recording.
    void write_shape(const Frame& frame, std::size_t number);
    void write_positions(std::span<const Vec3d> positions);
    void write_normals(std::span<const Vec3f> normals);
    void write_animation();
    void write_binary(const Bytes& bytes);

    RecordingPlan plan_;
    GlbContent content_;
    std::optional<FrameSelection> selection_;
    std::optional<OutputFile> file_;
    std::uint64_t json_room_ = 0, binary_bytes_ = 0;
    std::size_t frames_seen_ = 0;
    std::optional<HeldFrame> held_;  ///< the newest frame, if left out; the last one is written
    std::vector<Vec3f> rest_positions_, rest_normals_;  ///< [particle], as written
    std::vector<float> times_;                          ///< [shape], [s]
};

}  // namespace weft
