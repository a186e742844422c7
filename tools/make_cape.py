#!/usr/bin/env python3
"""Writes scenes/cape.obj, the cape of the scene mesh-cape.

The cape is a cone around the y axis, from a neckline of radius 0.12 m at y = 1.5 m to a hem of radius
0.55 m at y = 0.5 m, open by 60 degrees at the front (+z). It is cut from two panels that meet at the
back: each has its own vertices and texture co-ordinates, so the back seam has every vertex twice.
Quads throughout, save for two rows where the number of columns doubles, so that edges stay near
25 mm from the neck to the hem; those rows are triangles. All faces show outward.

The neckline, and nothing else, lies in the box [[-0.2, 1.49, -0.2], [0.2, 1.51, 0.2]].

Usage: make_cape.py [FILE]
"""

import math
import pathlib
import sys

NECK_RADIUS, HEM_RADIUS = 0.12, 0.55      # [m]
NECK_HEIGHT, HEM_HEIGHT = 1.5, 0.5        # [m]
HALF_ANGLE = math.radians(150.0)          # of one panel, from the back to the front edge
ROWS = 43                                 # strips of faces from neck to hem
NECK_COLUMNS = 14                         # columns of faces of one panel, at the neck
DOUBLING_ROWS = (7, 26)                   # strips below which there are twice as many columns
SEAM_ALLOWANCE = 0.01                     # [1] of the texture's width, on each side of the seam


def columns_of(line):
    """Columns of faces below the line of vertices `line`, 0 at the neck."""
    return NECK_COLUMNS * 2 ** sum(line > row for row in DOUBLING_ROWS)


def number(value):
    """Six decimals, and no minus before a zero."""
    text = f"{value:.6f}"
    return "0.000000" if float(text) == 0.0 else text


def panel_vertices(side):
    """Positions and texture co-ordinates of one panel, line by line from the neck, each line in the
    direction of rising angle. `side` is -1 (ends at the back) or 1 (begins there)."""
    for line in range(ROWS + 1):
        down = line / ROWS
        radius = NECK_RADIUS + (HEM_RADIUS - NECK_RADIUS) * down
        height = NECK_HEIGHT + (HEM_HEIGHT - NECK_HEIGHT) * down
        columns = columns_of(line)
        for column in range(columns + 1):
            across = column / columns
            angle = HALF_ANGLE * (across - 1.0 if side < 0 else across)
            half = 0.5 - SEAM_ALLOWANCE
            u = half * across if side < 0 else 1.0 - half * (1.0 - across)
            yield ((radius * math.sin(angle), height, -radius * math.cos(angle)), (u, 1.0 - down))


def panel_faces(first):
    """Faces of one panel whose vertices are numbered from `first`, counter-clockwise from outside."""
    upper = first
    for row in range(ROWS):
        columns = columns_of(row)
        lower = upper + columns + 1
        for column in range(columns):
            a, b = upper + column, upper + column + 1
            if columns_of(row + 1) == columns:
                yield a, b, lower + column + 1, lower + column
            else:
                c = lower + 2 * column
                yield a, c + 1, c
                yield a, b, c + 1
                yield b, c + 2, c + 1
        upper = lower


def cape():
    """The OBJ file, line by line."""
    yield "# A cape of two panels with a seam down the back; made by tools/make_cape.py."
    yield "# Metres, y upward. The neckline is the line of vertices at y = 1.5."
    panels = [list(panel_vertices(side)) for side in (-1, 1)]
    for vertices in panels:
        for position, _ in vertices:
            yield "v " + " ".join(number(x) for x in position)
    for vertices in panels:
        for _, uv in vertices:
            yield "vt " + " ".join(number(x) for x in uv)
    first = 1
    for name, vertices in zip(("left", "right"), panels):
        yield f"g {name}"
        for face in panel_faces(first):
            yield "f " + " ".join(f"{vertex}/{vertex}" for vertex in face)
        first += len(vertices)


def main():
    shipped = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "cape.obj"
    path = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else shipped
    path.write_text("\n".join(cape()) + "\n", encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()
