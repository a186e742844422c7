"""Opens a recording in Blender and compares every frame with the NumPy arrays of the same run:

    blender --background --factory-startup --python check_in_blender.py -- DIRECTORY/NAME

It runs open_in_blender.py as a user would, once for each point cache, then imports NAME.glb. Every
vertex of the evaluated mesh must stand within 2e-6 m of its particle (glb: 1e-5 m, as Blender keeps
keyframe times in float), where the world is z-up.
"""
import os
import re
import runpy
import sys

import numpy

# Blender 3.4's glTF importer still uses the old names of NumPy's types.
numpy.bool = bool

import bpy  # noqa: E402

TOLERANCE = 2e-6


def world_points(obj, frame):
    """[vertex, 3] of the mesh as drawn at a scene frame, in world co-ordinates."""
    bpy.context.scene.frame_set(int(frame), subframe=frame - int(frame))
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    points = numpy.empty(3 * len(mesh.vertices), dtype=numpy.float32)
    mesh.vertices.foreach_get("co", points)
    matrix = numpy.array(evaluated.matrix_world)
    evaluated.to_mesh_clear()
    return points.reshape(-1, 3).astype(float) @ matrix[:3, :3].T + matrix[:3, 3]


def z_up(points):
    """The run's y-up co-ordinates as Blender's world has them."""
    return numpy.stack([points[..., 0], -points[..., 2], points[..., 1]], axis=-1)


def check_cache(stem, extension, positions, rate):
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    folder, name = os.path.split(stem)
    script = os.path.join(folder, "open_in_blender.py")
    with open(script, encoding="utf-8") as file:
        text = file.read()
    other = os.path.join(folder, "open_in_blender_check.py")
    with open(other, "w", encoding="utf-8") as file:
        file.write(re.sub(r'CACHE = ".*"', f'CACHE = "{name}.{extension}"', text))
    runpy.run_path(other, run_name="__main__")
    os.remove(other)

    scene = bpy.context.scene
    cloth = next(o for o in scene.objects if o.type == "MESH")
    meshes = sum(o.type == "MESH" for o in scene.objects)
    assert meshes == 1, f"{meshes} meshes"
    assert all(p.use_smooth for p in cloth.data.polygons)
    assert (scene.frame_start, scene.frame_end) == (1, len(positions))
    assert abs(scene.render.fps / scene.render.fps_base - rate) < 1e-4
    greatest = max(numpy.abs(world_points(cloth, frame + 1) - z_up(p)).max()
                   for frame, p in enumerate(positions))
    print(f"{name}.{extension} in Blender {bpy.app.version_string}: {len(positions)} frames, "
          f"{len(cloth.data.vertices)} vertices, {len(cloth.data.polygons)} faces, "
          f"greatest difference {greatest:.3g} m")
    return greatest


def check_glb(stem, positions, times):
    """The importer puts keyframes at time x render.fps, from frame 0 on."""
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    scene = bpy.context.scene
    for obj in list(scene.objects):
        bpy.data.objects.remove(obj)
    scene.render.fps, scene.render.fps_base = 30, 1.0
    bpy.ops.import_scene.gltf(filepath=stem + ".glb", merge_vertices=False)
    cloth = next(o for o in scene.objects if o.type == "MESH")
    names = [key.name for key in cloth.data.shape_keys.key_blocks[1:]]
    kept = [0] + [int(name.split()[1]) for name in names]
    at_rest = z_up(positions[0])
    particle = [numpy.abs(at_rest - point).sum(axis=1).argmin() for point in world_points(cloth, 0)]
    greatest = max(numpy.abs(world_points(cloth, times[frame] * scene.render.fps)
                             - z_up(positions[frame])[particle]).max() for frame in kept)
    print(f"{os.path.basename(stem)}.glb in Blender: {len(kept)} keyframes, "
          f"{len(particle)} vertices, greatest difference {greatest:.3g} m")
    return greatest


def main():
    stem = os.path.abspath(sys.argv[sys.argv.index("--") + 1])
    positions = numpy.load(stem + ".positions.npy").astype(float)
    times = numpy.load(stem + ".times.npy")
    rate = (len(times) - 1) / (times[-1] - times[0])
    results = [check_cache(stem, extension, positions, rate) for extension in ("pc2", "mdd")]
    glb = check_glb(stem, positions, times)
    good = max(results) <= TOLERANCE and glb <= 1e-5
    print("good" if good else "NOT GOOD")
    sys.stdout.flush()
    os._exit(0 if good else 1)


try:
    main()
except BaseException as error:  # Blender would go on and leave with status 0
    print(f"NOT GOOD: {type(error).__name__}: {error}")
    sys.stdout.flush()
    os._exit(1)
