#!/usr/bin/env python3
"""One hanging sheet in weft, in Bullet's deformable body and in Blender's cloth: milliseconds a
frame, and how far it sags.

    tools/compare_cloth.py build/release/weft [--sizes 40 100] [--blender PATH]
                            [--repeats N] [--json FILE]

The sheet: 1 m x 1 m, 0.2 kg, hung by its two upper corners, unstretched at first. Structural springs
along the edges and shear springs across the cells have 1000 N/m each; almost nothing resists
bending. Drag of 10/s leaves it hanging still after two seconds of 60 frames. The sag is how far the
middle of the lower edge hangs below its unstretched place: a solver that stops early sags more.
Blender's shear springs resist lengthening alone, so that it sags a twentieth more at any quality.

weft and Bullet run on one thread through `weft bench --filter hanging` (bench/suite/scenes.cpp,
hanging_sheet()): medians of the repeats. Blender runs this file, on one thread as far as it lets
itself be told; its time for the same frames can be many times longer in one run than in the next, so
the fastest of the repeats counts. Prints a table in Markdown.
"""

import argparse
import json
import shutil
import subprocess
import sys
import time

SIZE = 1.0          # [m]
MASS = 0.2          # of the sheet [kg]
STIFFNESS = 1000.0  # of a structural or shear spring [N/m]
DRAG_RATE = 10.0    # [1/s]
FRAME = 1.0 / 60.0  # [s]
FRAMES = 120
RESULT = "compare_cloth: "  # begins the line that Blender answers with

# Blender's cloth has gravity in m/s2 times 0.001 in its own unit of time, so that the unit is
# sqrt(0.001) s and a force there is a thousandth of one in newtons. A frame is one unit of time
# multiplied by `time_scale`; a spring has its stiffness setting over the mean edge length; drag has
# a hundredth of `air_damping` (source/blender/simulation/intern/, version 3.4). With masses in
# grammes all settings are of the size of Blender's defaults; the motion is the same.
BLENDER_TIME = 0.001 ** 0.5  # [s]
BLENDER_MASS = 0.001         # [kg]


def simulate_in_blender(size, quality):
    """Runs inside Blender. -> (milliseconds a frame, sag [m])"""
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.gravity = (0.0, 0.0, -9.81)
    scene.frame_start, scene.frame_end = 1, FRAMES + 1
    cell = SIZE / (size - 1)
    places = [(i * cell, 0.0, -j * cell) for j in range(size) for i in range(size)]
    faces = [(j * size + i, (j + 1) * size + i, (j + 1) * size + i + 1, j * size + i + 1)
             for j in range(size - 1) for i in range(size - 1)]
    mesh = bpy.data.meshes.new("sheet")
    mesh.from_pydata(places, [], faces)
    sheet = bpy.data.objects.new("sheet", mesh)
    scene.collection.objects.link(sheet)
    sheet.vertex_groups.new(name="pins").add([0, size - 1], 1.0, "REPLACE")
    cloth = sheet.modifiers.new("cloth", "CLOTH")
    cloth.point_cache.frame_start, cloth.point_cache.frame_end = 1, FRAMES + 1
    cloth.collision_settings.use_collision = False
    cloth.collision_settings.use_self_collision = False
    settings = cloth.settings
    settings.vertex_group_mass = "pins"
    settings.quality = quality
    settings.time_scale = FRAME / BLENDER_TIME
    settings.mass = MASS / BLENDER_MASS / size ** 2
    settings.air_damping = 100.0 * DRAG_RATE * BLENDER_TIME * settings.mass
    stiffness = STIFFNESS / BLENDER_MASS * BLENDER_TIME ** 2 * cell
    settings.tension_stiffness = settings.compression_stiffness = stiffness
    settings.shear_stiffness = stiffness
    settings.bending_stiffness = 0.0
    settings.tension_damping = settings.compression_damping = settings.shear_damping = 0.0
    settings.bending_damping = 0.0

    def show(frame):
        scene.frame_set(frame)
        return sheet.evaluated_get(bpy.context.evaluated_depsgraph_get())

    show(1)
    began = time.perf_counter()
    for frame in range(2, FRAMES + 2):
        evaluated = show(frame)
    seconds = time.perf_counter() - began
    middle = (size - 1) * size + size // 2
    sag = places[middle][2] - evaluated.data.vertices[middle].co[2]
    return 1e3 * seconds / FRAMES, sag


def run(command, what):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"compare_cloth: {what} failed ({done.returncode}):\n{done.stderr or done.stdout}")
    return done.stdout


def rows_of_weft(weft, sizes, repeats):
    """weft's and Bullet's, from weft bench."""
    rows = []
    for size in sizes:
        answer = json.loads(run([weft, "bench", "--json", "--filter", f"hanging {size}x{size}",
                                 "--repeats", str(repeats)], "weft bench"))
        for row in answer["rows"]:
            name = row["case"].removeprefix("hanging ")
            bullet = answer["machine"]["peers"]["bullet"]
            by = f"Bullet {bullet}" if name.startswith("bullet") else "weft"
            name = "implicit, deformable body" if name.startswith("bullet") else name
            rows.append({"by": by, "method": name, "size": size, "note": row["note"],
                         "ms_per_frame": row["ms_per_frame"], "sag": row["sag"]})
    return rows


def answer_of_blender(blender, size, quality):
    text = run([blender, "--background", "--factory-startup", "--threads", "1", "--python-exit-code",
                "1", "--python", __file__, "--", "in-blender", str(size), str(quality)], "Blender")
    answer = [line for line in text.splitlines() if line.startswith(RESULT)]
    if not answer:
        sys.exit(f"compare_cloth: Blender said nothing of the sheet:\n{text}")
    return json.loads(answer[0].removeprefix(RESULT))


def row_of_blender(blender, version, size, quality, repeats):
    answers = [answer_of_blender(blender, size, quality) for _ in range(repeats)]
    return {"by": version, "method": f"cloth, quality {quality}", "size": size, "note": None,
            **min(answers, key=lambda answer: answer["ms_per_frame"])}


def table(rows):
    """In Markdown."""
    yield "| | sheet | ms a frame | sag |"
    yield "|---|---|---|---|"
    for row in rows:
        where = f"| {row['by']}, {row['method']} | {row['size']}x{row['size']} |"
        if row["note"]:
            yield f"{where} {row['note']} | |"
        else:
            yield f"{where} {row['ms_per_frame']:.2f} | {1e3 * row['sag']:.3f} mm |"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("weft", help="the weft command")
    parser.add_argument("--sizes", type=int, nargs="+", default=[40, 100], choices=[40, 100],
                        help="particles along an edge")
    parser.add_argument("--blender", default="blender", help="the blender command")
    parser.add_argument("--json", metavar="FILE", help="write the rows as JSON as well")
    parser.add_argument("--repeats", type=int, default=3, help="of each timing (default 3)")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    if shutil.which(arguments.weft) is None:
        sys.exit(f"compare_cloth: {arguments.weft}: no such command; build weft first")
    blender = shutil.which(arguments.blender)
    if blender is None:
        sys.exit(f"compare_cloth: {arguments.blender}: no such command. Install Blender "
                 "(apt install blender), or say where it is with --blender PATH.")
    version = run([blender, "--version"], "Blender").splitlines()[0]
    rows = rows_of_weft(arguments.weft, arguments.sizes, arguments.repeats)
    rows += [row_of_blender(blender, version, size, quality, arguments.repeats)
             for size in arguments.sizes for quality in (1, 5)]
    rows.sort(key=lambda row: row["size"])
    print("\n".join(table(rows)))
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump({"rows": rows}, file, indent=2)


def main_in_blender(size, quality):
    ms, sag = simulate_in_blender(int(size), int(quality))
    print(RESULT + json.dumps({"ms_per_frame": ms, "sag": sag}), flush=True)


if __name__ == "__main__":
    if "in-blender" in sys.argv:
        main_in_blender(*sys.argv[sys.argv.index("in-blender") + 1:])
    else:
        main()
