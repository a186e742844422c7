// The script that opens a point cache in Blender: Python text with the recording's facts in front.
#include "io/blender_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace weft {

namespace {

/// What does the work. OBJ and cache hold the same y-up co-ordinates. Blender's OBJ import leaves
/// the vertices as the file has them and turns the object, so the cache needs no axes of its own:
/// with the modifier's axes at Blender's (forward +Y, up +Z) cached points overwrite vertices
/// unchanged.
constexpr std::string_view script_body = R"py(

def import_mesh(path):
    """The OBJ as an object: vertices as in the file, the object turned so that its y is up."""
    for selected in list(bpy.context.selected_objects):
        selected.select_set(False)
    bpy.ops.wm.obj_import(filepath=path, forward_axis="NEGATIVE_Z", up_axis="Y")
    cloth = bpy.context.selected_objects[0]
    if len(cloth.data.vertices) != POINTS:
        raise SystemExit(f"{path}: {len(cloth.data.vertices)} vertices, expected {POINTS}")
    cloth.name = TITLE
    cloth.data.polygons.foreach_set("use_smooth", [True] * len(cloth.data.polygons))
    cloth.data.update()
    return cloth


def add_cache(cloth, path):
    """Frame 0 of the cache stands at scene frame 1."""
    cache = cloth.modifiers.new("Cloth cache", "MESH_CACHE")
    cache.cache_format = CACHE.rsplit(".", 1)[1].upper()
    cache.filepath = path
    cache.deform_mode = "OVERWRITE"
    cache.interpolation = "LINEAR"
    cache.play_mode = "SCENE"
    cache.time_mode = "FRAME"
    cache.frame_start = 1
    cache.frame_scale = 1
    cache.forward_axis = "POS_Y"
    cache.up_axis = "POS_Z"


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    for name in (MESH, CACHE):
        if not os.path.isfile(os.path.join(folder, name)):
            raise SystemExit(f"{os.path.join(folder, name)} is missing")

    startup_cube = bpy.data.objects.get("Cube")
    if startup_cube is not None and not bpy.data.filepath:
        bpy.data.objects.remove(startup_cube)

    cloth = import_mesh(os.path.join(folder, MESH))
    add_cache(cloth, os.path.join(folder, CACHE))

    scene = bpy.context.scene
    scene.render.fps = FPS
    scene.render.fps_base = FPS_BASE
    scene.frame_start = 1
    scene.frame_end = FRAMES
    scene.frame_set(1)


main()
)py";

/// A JSON string is also a Python string.
std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

BlenderFrameRate blender_frame_rate(double frames_per_second) {
    const double whole = std::clamp(std::ceil(frames_per_second - 1e-9), 1.0, 32767.0);
    return {.fps = static_cast<int>(whole), .base = whole / frames_per_second};
}

std::string blender_script(const BlenderScene& scene) {
    const BlenderFrameRate rate = blender_frame_rate(scene.frames_per_second);
    std::string text = fmt::format(
        "# Opens a cloth recording in Blender 3.4 or later:\n"
        "#     blender --python open_in_blender.py\n"
        "import os\n\nimport bpy\n\n"
        "TITLE = {}\nMESH = {}\nCACHE = {}\nPOINTS = {}\nFRAMES = {}\n"
        "FPS = {}  # frames per second: FPS / FPS_BASE\nFPS_BASE = {}\n",
        quoted(scene.title), quoted(scene.mesh), quoted(scene.cache), scene.points, scene.frames,
        rate.fps, rate.base);
    return text.append(script_body);
}

}  // namespace weft
