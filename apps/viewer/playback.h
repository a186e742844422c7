// A recording on the window's timeline.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "io/recording_file.h"
#include "viewer/flight.h"

namespace weft::viewer {

class Playback {
public:
    /// @throws Error (file) as RecordingFile.
    explicit Playback(const std::filesystem::path& recording, const RenderDescription& render);

    /// Moves on by wall-clock seconds while it plays; at the end it begins again, or stops.
    void advance(double seconds);
    void play(bool playing);       ///< from the start again where it stands at the end
    void step(int frames);         ///< forward or back, and pause; stays within the recording
    void seek(std::size_t frame);  ///< frames beyond the last give the last
    void set_speed(double speed) { speed_ = speed; }
    void set_loop(bool loop) { loop_ = loop; }

    [[nodiscard]] bool playing() const { return playing_; }
    [[nodiscard]] bool loop() const { return loop_; }
    [[nodiscard]] double speed() const { return speed_; }
    [[nodiscard]] std::size_t frame_index() const { return index_; }
    [[nodiscard]] std::size_t frame_count() const { return file_.frame_count(); }
    [[nodiscard]] double frames_per_second() const { return file_.frames_per_second(); }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Without springs, pins and mass, which recordings do not tell.
    [[nodiscard]] const std::shared_ptr<const ClothShape>& shape() const { return shape_; }
    /// Valid until another function is called.  @throws Error (file).
    Frame frame();

private:
    std::filesystem::path path_;
    RecordingFile file_;
    std::shared_ptr<const ClothShape> shape_;
    double position_ = 0.0;  ///< in frames
    std::size_t index_ = 0;
    std::optional<Frame> frame_;  ///< read last
    double speed_ = 1.0;
    bool playing_ = true, loop_ = true;
};

}  // namespace weft::viewer
