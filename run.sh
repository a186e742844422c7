#!/usr/bin/env bash
# From a fresh machine to a flying flag: installs what is missing, builds weft, runs the main job.
set -euo pipefail
cd "$(dirname "$0")"

tools/install_packages.sh tools/packages.txt
cmake --preset release >/dev/null
cmake --build --preset release

out=weft-out/flag
./build/release/weft run flag -o "$out" "$@"
./build/release/weft render flag -o "$out/flag.png" --frame 140 --quiet

cat <<TEXT

Look at these:
  $out/flag.mp4                 the flag as a video
  $out/flag.png                 a picture of it
  $out/flag.glb                 the animation for a web page, or any glTF viewer
  $out/open_in_blender.py       blender --python $out/open_in_blender.py
  $out/summary.json             what was run, and what came of it
Then try: ./build/release/weft view flag     (where there is a display), or ./build/release/weft --help
TEXT
