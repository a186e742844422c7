// The table of recording formats: what `weft list formats` shows and output.formats may name.
#include <fmt/format.h>

#include <array>
#include <string>

#include "io/glb_recorder.h"
#include "io/mdd_recorder.h"
#include "io/npy_recorder.h"
#include "io/obj_sequence_recorder.h"
#include "io/pc2_recorder.h"
#include "io/picture_recorder.h"
#include "io/ply_sequence_recorder.h"
#include "weft/error.h"
#include "weft/recorder.h"

namespace weft {

namespace {

template <typename SomeRecorder>
std::unique_ptr<Recorder> make(std::string_view) {
    return std::make_unique<SomeRecorder>();
}

struct Row {
    FormatInfo info;
    std::unique_ptr<Recorder> (*make)(std::string_view format);
};

constexpr std::array rows{
    Row{{"glb", "NAME.glb", "animated mesh with texture, glTF 2.0, for viewers and web pages"},
        make<GlbRecorder>},
    Row{{"pc2", "NAME.pc2, NAME.obj, open_in_blender.py",
         "point cache with its mesh, for Blender, Houdini, 3ds Max"},
        make<Pc2Recorder>},
    Row{{"mdd", "NAME.mdd, NAME.obj, open_in_blender.py",
         "point cache with its mesh, for LightWave, Blender, Modo"},
        make<MddRecorder>},
    Row{{"npy", "NAME.positions.npy, NAME.velocities.npy, NAME.times.npy",
         "NumPy arrays [frame, particle, 3] in the run's precision"},
        make<NpyRecorder>},
    Row{{"obj", "NAME.obj-frames/", "a Wavefront OBJ mesh for each frame"},
        make<ObjSequenceRecorder>},
    Row{{"ply", "NAME.ply-frames/", "a binary PLY mesh for each frame"}, make<PlySequenceRecorder>},
    Row{{"png", "NAME.png-frames/", "a picture for each frame"}, make_picture_recorder},
    Row{{"mp4", "NAME.mp4", "H.264 video, through ffmpeg"}, make_picture_recorder},
    Row{{"webm", "NAME.webm", "VP9 video, through ffmpeg"}, make_picture_recorder},
    Row{{"gif", "NAME.gif", "looping picture, through ffmpeg"}, make_picture_recorder},
};

constexpr auto infos = [] {
    std::array<FormatInfo, rows.size()> result{};
    for (std::size_t i = 0; i < rows.size(); ++i) result[i] = rows[i].info;
    return result;
}();

}  // namespace

std::span<const FormatInfo> format_catalogue() {
    return infos;
}

std::unique_ptr<Recorder> make_recorder(std::string_view format) {
    std::string known;
    for (const Row& row : rows) {
        if (row.info.name == format) return row.make(format);
        known += fmt::format("{}{}", known.empty() ? "" : ", ", row.info.name);
    }
    throw scene_error("output.formats", fmt::format("\"{}\"", format), "one of " + known);
}

}  // namespace weft
