#!/usr/bin/env python3
"""Fails on an include that points up the layers of src/.

Dependencies flow one way (docs/architecture.md):
    public data < math < cloth < forces < contact < integrators < simulation < render < io < lab < apps
Headers of include/weft belong to the layer that implements them; those that are data alone belong
below all.
"""

import pathlib
import re
import sys

LAYERS = ["data", "math", "cloth", "forces", "contact", "integrators", "simulation", "render", "io",
          "lab", "apps"]
PUBLIC = {
    "vec3.h": "data", "error.h": "data", "scene.h": "data", "frame.h": "data",
    "measures.h": "data", "recorder.h": "data", "version.h": "data", "instruction_set.h": "data",
    "integrators.h": "integrators", "simulation.h": "simulation", "weft.h": "apps",
}
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]')


def layer_of_include(name):
    """The layer an include belongs to, or None where it is not ours."""
    parts = pathlib.PurePosixPath(name).parts
    if parts[0] == "weft" and len(parts) == 2:
        if parts[1] not in PUBLIC:
            sys.exit(f"include/weft/{parts[1]} is not in the table of {sys.argv[0]}")
        return PUBLIC[parts[1]]
    if parts[0] in ("cli", "viewer"):
        return "apps"
    return parts[0] if len(parts) > 1 and parts[0] in LAYERS else None


def upward_includes(root):
    files = [*root.glob("src/**/*.h"), *root.glob("src/**/*.cpp"), *root.glob("include/weft/*.h")]
    for path in sorted(files):
        relative = path.relative_to(root)
        own = PUBLIC[path.name] if relative.parts[0] == "include" else relative.parts[1]
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            other = layer_of_include(match[1]) if match else None
            if other and LAYERS.index(other) > LAYERS.index(own):
                yield f"{relative}:{number}: {own} must not include {match[1]} ({other})"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    found = list(upward_includes(root))
    print("\n".join(found) if found else "layers: no upward include")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
