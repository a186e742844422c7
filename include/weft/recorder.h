// Recorders: frames in, files out.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// What a recorder is told before the first frame.
struct RecordingPlan {
    std::filesystem::path directory;   ///< exists
    std::string stem;                  ///< files are named after it: "flag" -> "flag.pc2"
    std::string title;                 ///< the scene's name
    const Surface* surface = nullptr;  ///< outlives the recorder
    std::size_t frame_count = 0;       ///< frames to come, frame 0 included; fewer may come
    double frames_per_second = 30.0;
    Precision precision = Precision::f32;  ///< of the run
    RenderDescription render;
    std::vector<ObstacleDescription> obstacles{};  ///< drawn in pictures
};

/// Takes frames in order. Files stand under temporary names until finish() renames them; a recorder
/// destroyed before finish() removes what it wrote.
class Recorder {
public:
    virtual ~Recorder() = default;

    /// What frame() looks at; frames may come without the rest. A recorder that asks for rounded
    /// positions takes positions instead where a frame has only those.
    [[nodiscard]] virtual FrameNeeds needs() const { return {}; }
    /// @throws Error (file).
    virtual void begin(const RecordingPlan& plan) = 0;
    /// @throws Error (file).
    virtual void frame(const Frame& frame) = 0;
    /// Ends the recording with the frames seen so far (one at least) and puts the files in place.
    /// @return the files written.  @throws Error (file).
    virtual std::vector<std::filesystem::path> finish() = 0;
    /// Things a user should know, one line each (e.g. "flag.glb: 300 frames thinned to 250").
    [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
};

/// A row of `weft list formats`.
struct FormatInfo {
    std::string_view name;   ///< key in output.formats: "pc2"
    std::string_view files;  ///< "NAME.pc2, NAME.obj, open_in_blender.py"
    std::string_view description;
};
std::span<const FormatInfo> format_catalogue();

/// @throws Error (usage) where no such format exists.
std::unique_ptr<Recorder> make_recorder(std::string_view format);

}  // namespace weft
