#!/usr/bin/env python3
"""Counts the instructions that weft executes for a particle and step, under valgrind.

Timings move with the machine and with what else it does; a count of instructions does not. Each case
is a small run of `weft run`, made twice with different numbers of steps in its one frame: the
difference is that of the steps alone, without start-up, building and reading the scene. AVX2 is the
widest set that valgrind knows.

    tools/count_instructions.py WEFT             print the counts
    tools/count_instructions.py WEFT --check     fail where one rose by more than 2 % over the baseline
    tools/count_instructions.py WEFT --update    make them the baseline, bench/instructions.json

WEFT is the command of a Release build. Another compiler gives other counts: the baseline names its own.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BASELINE = pathlib.Path(__file__).resolve().parent.parent / "bench" / "instructions.json"
COLUMNS, ROWS = 256, 64
FEW, MANY = 8, 40  # steps of the two runs
ALLOWED_RISE = 0.02
INSTRUCTION_SET = "avx2"

# The sheet of bench/peers/plain_sheet.h, and the shipped flag.
SHEET = f"""version = 1
[cloth]
size = [{0.025 * (COLUMNS - 1)}, {0.025 * (ROWS - 1)}]
resolution = [{COLUMNS}, {ROWS}]
[material]
particle_mass = 1e-4
stiffness_per = "spring"
structural = {{ stiffness = 200.0, damping = 0.02 }}
shear = {{ stiffness = 100.0, damping = 0.01 }}
bend = {{ stiffness = 20.0, damping = 0.002 }}
[[pins]]
select = "top-left"
[[pins]]
select = "top-right"
[forces]
damping = 1e-5
"""
FLAG = f'version = 1\n[cloth]\nresolution = [{COLUMNS}, {ROWS}]\n[wind]\n[[pins]]\nselect = "left-edge"\n'

CASES = {
    "symplectic-euler single": (SHEET, "symplectic-euler", "single", 5e-5),
    "symplectic-euler double": (SHEET, "symplectic-euler", "double", 5e-5),
    "velocity-verlet single": (SHEET, "velocity-verlet", "single", 5e-5),
    "rk4 double": (SHEET, "rk4", "double", 5e-5),
    "flag with wind single": (FLAG, "velocity-verlet", "single", 1e-5),
}


def fail(message):
    sys.exit(f"count_instructions.py: {message}")


def instructions(weft, scene, directory):
    """Executed by a run of the scene's one frame."""
    path = directory / "scene.toml"
    path.write_text(scene)
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", weft, "run", path,
               "--frames", "1", "--threads", "1", "--quiet", "-o", directory / "out"]
    done = subprocess.run([*map(str, command)], capture_output=True, text=True,
                          env={**os.environ, "WEFT_SIMD": INSTRUCTION_SET})
    collected = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not collected:
        fail(f"the run failed with status {done.returncode}:\n{done.stderr}")
    return int(collected[1])


def count(weft, case):
    """Instructions for a particle and step."""
    scene, method, precision, step = CASES[case]
    totals = []
    with tempfile.TemporaryDirectory(prefix="weft-count-") as directory:
        for steps in (FEW, MANY):
            text = scene + (f'[integrator]\nmethod = "{method}"\nprecision = "{precision}"\n'
                            f"time_step = {step!r}\n[output]\nformats = []\n"
                            f"frames_per_second = {1 / (step * steps)!r}\n")
            totals.append(instructions(weft, text, pathlib.Path(directory)))
    return (totals[1] - totals[0]) / ((MANY - FEW) * COLUMNS * ROWS)


def compiler_of(weft):
    """As the build itself says it."""
    done = subprocess.run([weft, "bench", "--quick", "--json", "--filter", "textbook 40x40"],
                          capture_output=True, text=True)
    if done.returncode != 0:
        fail(f"{weft} bench failed:\n{done.stderr}")
    return json.loads(done.stdout)["machine"]["compiler"]


def check(counts, compiler):
    """Prints each case beside the baseline; the names of those that rose."""
    try:
        baseline = json.loads(BASELINE.read_text())
    except FileNotFoundError:
        fail(f"there is no baseline yet, {BASELINE}: make one with --update")
    if baseline["compiler"] != compiler:
        print(f"note: the baseline was made with {baseline['compiler']}, this is {compiler}")
    rose = []
    for case, value in counts.items():
        before = baseline["instructions_per_particle_step"].get(case)
        if before is None:
            print(f"{case:<26} {value:9.2f}   new: not in the baseline")
            rose.append(case)
            continue
        change = value / before - 1
        print(f"{case:<26} {value:9.2f}   {100 * change:+6.2f} % of {before:.2f}")
        if change > ALLOWED_RISE:
            rose.append(case)
    return rose


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("weft", metavar="WEFT", help="the weft command of a Release build")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true", help="compare with the baseline")
    what.add_argument("--update", action="store_true", help="write the baseline")
    arguments = parser.parse_args()
    if not shutil.which("valgrind"):
        fail("needs the program valgrind (tools/bench-packages.txt)")
    if not shutil.which(arguments.weft):
        fail(f"{arguments.weft}: no such program")

    counts = {case: count(arguments.weft, case) for case in CASES}
    if arguments.check:
        rose = check(counts, compiler_of(arguments.weft))
        if rose:
            fail(f"more than {100 * ALLOWED_RISE:.0f} % above the baseline: {', '.join(rose)}")
        return
    for case, value in counts.items():
        print(f"{case:<26} {value:9.2f}")
    if arguments.update:
        BASELINE.write_text(json.dumps(
            {"compiler": compiler_of(arguments.weft), "instruction_set": INSTRUCTION_SET,
             "columns": COLUMNS, "rows": ROWS,
             "instructions_per_particle_step": {case: round(value, 2)
                                                for case, value in counts.items()}},
            indent=2) + "\n")


if __name__ == "__main__":
    main()
