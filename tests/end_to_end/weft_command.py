"""Runs the weft command for the tests, each in a fresh directory of its own.

CTest says where the command is: WEFT_COMMAND, and WEFT_SOURCE_DIR for the source tree.
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import threading
import unittest

COMMAND = os.environ["WEFT_COMMAND"]
SOURCE = pathlib.Path(os.environ["WEFT_SOURCE_DIR"])
SCENES = SOURCE / "tests" / "end_to_end" / "scenes"
METHODS = ("forward-euler", "symplectic-euler", "verlet", "time-corrected-verlet", "velocity-verlet",
           "rk2", "rk3", "rk4", "yoshida4", "forest-ruth")
UNLIMITED = ("bosh3", "dopri5", "implicit-euler", "implicit-midpoint", "trapezoidal", "bdf2",
             "tr-bdf2", "sdirk2", "baraff-witkin", "projective-dynamics", "xpbd", "vbd")
ENDLESS = 10_000_000  # frames: hours, for runs that are to be interrupted

# A run of a few milliseconds: sixty particles, two steps a frame, arrays out.
SMALL_SCENE = """version = 1
name = "Small"
[cloth]
size = [1.0, 0.5]
resolution = [10, 6]
origin = [0.0, 2.0, 0.0]
[material]
particle_mass = 0.01
stiffness_per = "spring"
structural = { stiffness = 40.0, damping = 0.01 }
shear = { stiffness = 20.0 }
bend = { stiffness = 2.0 }
[[pins]]
select = "left-edge"
[integrator]
method = "velocity-verlet"
time_step = 0.005
precision = "double"
[output]
duration = 0.2
frames_per_second = 100.0
formats = ["npy"]
"""


def settings(**values):
    """--set options; a double underscore in a name stands for the dot of a key."""
    options = []
    for key, value in values.items():
        options += ["--set", f"{key.replace('__', '.')}={value}"]
    return options


class CommandTest(unittest.TestCase):
    """A test with a directory of its own, `self.place`, in which the command runs."""

    def setUp(self):
        self.place = pathlib.Path(tempfile.mkdtemp(prefix="weft-test-"))
        self.addCleanup(shutil.rmtree, self.place, ignore_errors=True)

    def weft(self, *arguments, expect=0, timeout=120, **options):
        """The finished process; the test fails where its exit status is not `expect`."""
        done = subprocess.run([COMMAND, *map(str, arguments)], cwd=self.place, timeout=timeout,
                              capture_output=True, text=True, **options)
        self.assertEqual(done.returncode, expect,
                         f"weft {' '.join(map(str, arguments))}\n{done.stdout}{done.stderr}")
        return done

    def small_scene(self, name="small", text=SMALL_SCENE):
        path = self.place / f"{name}.toml"
        path.write_text(text)
        return path

    def listing(self, directory="."):
        """Names in a directory below self.place, hidden ones too, sorted; none where it is not there."""
        path = self.place / directory
        return sorted(os.listdir(path)) if path.exists() else []

    def summary(self, directory):
        return json.loads((self.place / directory / "summary.json").read_text())

    def error_line(self, done):
        """The first line of the error; what was said before it is progress and warnings."""
        for line in done.stderr.splitlines():
            if line.startswith("weft: "):
                return line
            self.assertRegex(line, r"\A(frame \d|warning: |Small: )", done.stderr)
        return self.fail(f"no error on standard error: {done.stderr}")

    def interrupt(self, *arguments, group=False):
        """Starts a run and sends SIGINT after its first line of progress; as a terminal does, to the
        whole group of processes where `group` says so. Returns exit status and standard error."""
        process = subprocess.Popen([COMMAND, *map(str, arguments)], cwd=self.place, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   start_new_session=True)
        watchdog = threading.Timer(60, process.kill)
        watchdog.start()
        self.addCleanup(watchdog.cancel)
        said = ""
        for line in process.stderr:
            said += line
            if line.startswith("frame "):
                break
        (os.killpg if group else os.kill)(process.pid, signal.SIGINT)
        said += process.communicate()[1]
        return process.returncode, said
