// Recordings read back, to draw them or to look at them again.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "weft/frame.h"

namespace weft {

/// What a recording holds, whatever its format: a surface and its particles' places over time. Each
/// format is a class of its own (point_cache_file.cpp, glb_file.cpp).
class RecordedMotion {
public:
    virtual ~RecordedMotion() = default;

    /// @param positions overwritten, [particle], [m].  @throws Error (file).
    virtual void read(std::size_t frame, std::vector<Vec3d>& positions) const = 0;

    Surface surface;
    std::size_t frame_count = 0;  ///< 1 at least
    double frames_per_second = 30.0;
};

/// A recording as frames. A glb that was thinned gives all its frames again, those left out blended
/// from their neighbours.
class RecordingFile {
public:
    /// Opens NAME.pc2 or NAME.mdd, with NAME.obj beside it, or NAME.glb with morph targets.
    /// @throws Error (file) where the file cannot be read, is cut off, has the wrong size,
    /// contradicts
    ///         itself or the mesh beside it, or is of another format.
    explicit RecordingFile(const std::filesystem::path& path);

    [[nodiscard]] const Surface& surface() const { return motion_->surface; }
    [[nodiscard]] std::size_t frame_count() const { return motion_->frame_count; }
    [[nodiscard]] double frames_per_second() const { return motion_->frames_per_second; }

    /// Frame `index`, valid until the next call; its velocities are zero, as recordings have none.
    /// @throws Error (file) for data that are not finite; Error (usage) for an index out of range.
    Frame frame(std::size_t index);

private:
    std::filesystem::path path_;
    std::unique_ptr<RecordedMotion> motion_;
    std::vector<Vec3d> positions_, velocities_;
    std::vector<Vec3f> normals_;
};

/// Whether the name ends like a recording's: .pc2, .mdd, .glb.
bool is_recording(const std::filesystem::path& path);

}  // namespace weft
