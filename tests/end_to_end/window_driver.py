"""Drives the window of `weft view` from outside, as a person does: by keys, mouse and what is on the
screen. The display is Xvfb's, without a window manager; xdotool presses.

Nothing here depends on how fast the machine is: what can be waited for is waited for, up to DEADLINE.
"""

import ctypes
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

import numpy as np

from weft_command import COMMAND, CommandTest
from window_picture import NOISE, changed, count_of, difference, framebuffer, write_png

DEADLINE = 90.0  # seconds that anything at all may take on a machine that is busy
GLANCE = 0.03    # seconds between two looks
IDLE = (900, 705)  # where a pointer touches nothing: in the bar below
DONE = (126, 201, 143)  # the colour of messages that something was done
PICTURES = pathlib.Path(os.environ["WEFT_BUILD_DIR"]) / "window-pictures"


class Display:
    """An X server of our own, whose screen is a file."""

    def __init__(self, place, width=1280, height=720):
        self.screen = place / "screen"
        self.screen.mkdir()
        ours, theirs = os.pipe()
        # Without -noreset it begins anew when a client goes and no other is there.
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(theirs), "-screen", "0", f"{width}x{height}x24",
             "-fbdir", str(self.screen), "-nolisten", "tcp", "-noreset"],
            pass_fds=[theirs], stderr=subprocess.DEVNULL, preexec_fn=end_with_parent)
        os.close(theirs)
        with os.fdopen(ours) as pipe:
            self.name = f":{pipe.readline().strip()}"
        if self.name == ":":
            self.close()
            raise RuntimeError("Xvfb does not start")

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], capture_output=True, text=True,
                              env={**os.environ, "DISPLAY": self.name}, timeout=DEADLINE)

    def picture(self):
        return framebuffer(self.screen / "Xvfb_screen0")

    def close(self):
        self.server.terminate()  # which takes its lock away, as a kill does not
        self.server.wait(DEADLINE)


class Window:
    """A running `weft view`; its keys, its mouse and its screen."""

    def __init__(self, test, display, arguments):
        self.test, self.display = test, display
        self.number = None
        self.process = subprocess.Popen(
            [COMMAND, "view", *map(str, arguments), "--json"], cwd=test.place,
            env=test.environment(display.name), text=True, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, preexec_fn=end_with_parent)
        self.wait(lambda: self.find(), "a window")
        self.wait(lambda: " - " in self.title, "the title of what is open")
        self.move(*IDLE)
        if "--paused" in arguments:
            self.settle()

    def find(self):
        found = self.xdotool("search", "--onlyvisible", "--pid", self.process.pid, check=False)
        self.number = found.split()[0] if found else None
        return self.number

    def xdotool(self, *arguments, check=True):
        done = self.display.xdotool(*arguments)
        if check:
            self.test.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.strip()

    @property
    def title(self):
        return self.xdotool("getwindowname", self.number, check=False)

    def wait(self, condition, what):
        """The first true value of the condition."""
        until = time.monotonic() + DEADLINE
        while time.monotonic() < until:
            if self.process.poll() is not None:
                said = "".join(self.process.communicate())
                self.test.fail(f"the window closed while waiting for {what}:\n{said}")
            value = condition()
            if value:
                return value
            time.sleep(GLANCE)
        self.keep("late")
        return self.test.fail(f"no {what} within {DEADLINE:.0f} s; title: {self.title}")

    def wait_title(self, pattern):
        self.wait(lambda: re.search(pattern, self.title), f"title like {pattern!r}")

    # -- the screen
    def picture(self):
        return self.display.picture()

    def settle(self):
        """Waits until the screen stays as it is for a while: only for a paused window."""
        before, since = self.picture(), time.monotonic()

        def still():
            nonlocal before, since
            now = self.picture()
            if not now.any() or not np.array_equal(now, before):
                before, since = now, time.monotonic()
            return time.monotonic() - since > 0.7  # after 0.3 s of rest it is drawn once more, well

        self.wait(still, "picture that stays")

    def see(self, key, like=None, by=2 * NOISE):
        """Presses a key whose answer is on the screen; the picture when it has come and stays. Only
        for a paused window.
        like: a picture as which it is to look again; by: how much is to change, else."""
        before = self.picture()
        self.key(key)
        if like is None:
            self.wait(lambda: difference(before, self.picture()) > by, f"answer to {key}")
        else:  # edges and shadows may have come or gone elsewhere
            there = changed(before, like)
            self.wait(lambda: changed(self.picture(), like)[there].mean() < 0.1, f"answer to {key}")
        self.settle()
        return self.picture()

    def step(self, frames=1):
        """Goes on by frames, one after the other: the bar below counts them."""
        for _ in range(frames):
            self.bar_after("n")

    def bar_after(self, key):
        """What the bar says when a key has changed it."""
        before = last = self.bar()

        def other():
            nonlocal last
            seen, last = last, self.bar()  # a look may fall into the middle of drawing
            return np.array_equal(seen, last) and not np.array_equal(before, last)

        self.key(key)
        self.wait(other, f"answer to {key} in the bar")
        return last

    def bar(self):
        """The bar below, without the buttons under the resting pointer."""
        return self.picture()[-40:, :IDLE[0] - 20]

    def cloth(self):
        """[height, width] of bool: what the cloth's wireframe covers. Only for a paused window."""
        self.settle()
        before, wires = self.picture(), self.see("w")
        after = self.see("w", like=before)
        return changed(before, wires, by=60) & changed(after, wires, by=60)

    def keep(self, name):
        """Puts the screen into the build directory, for people to look at."""
        picture = self.picture()
        write_png(PICTURES / self.test.id().split(".", 1)[-1] / f"{name}.png", picture)
        return picture

    def screenshot(self):
        """The file that F12 writes."""
        before = self.test.files("*.png")
        self.key("F12")
        [path] = self.wait(lambda: self.test.files("*.png") - before, "screenshot")
        return path

    def answered(self):
        """Waits until a frame has been drawn with all that was pressed before."""
        self.screenshot().unlink()

    def dismiss(self):
        """Takes the messages about screenshots away, when they have come."""
        self.wait(self.says_something, "message")
        self.key("Escape")
        self.wait(lambda: not self.says_something(), "end of the messages")

    def says_something(self):
        return count_of(self.picture()[-160:-40, 320:-320], DONE) > 20

    # -- keys and mouse
    def key(self, *names):
        for name in names:
            self.xdotool("key", "--delay", "20", name)

    def hold(self, key, condition, what):
        """Holds a key until it is answered."""
        self.xdotool("keydown", key)
        self.wait(condition, what)
        self.xdotool("keyup", key)

    def type(self, text):
        self.xdotool("type", "--delay", "20", "--", text)

    def move(self, x, y):
        self.xdotool("mousemove", int(x), int(y))

    def click(self, x, y, times=1, button=1):
        self.move(x, y)
        time.sleep(0.2)  # nothing tells that the pointer was seen there
        self.xdotool("click", "--repeat", times, "--delay", "60", button)

    def press(self, x, y, button=1):
        self.move(x, y)
        self.answered()
        self.xdotool("mousedown", button)
        self.answered()

    def pull(self, *way):
        for x, y in way:
            self.move(x, y)
            self.answered()

    def release(self, button=1):
        self.xdotool("mouseup", button)
        self.answered()
        self.dismiss()
        self.move(*IDLE)

    def drag(self, start, *way, button=1):
        self.press(*start, button)
        self.pull(*way)
        self.release(button)

    def wheel(self, x, y, clicks):
        self.move(x, y)
        self.xdotool("click", "--repeat", abs(clicks), "--delay", "30", 4 if clicks > 0 else 5)

    # -- the end
    def close(self, by="ctrl+q"):
        """Closes the window and returns what it says of itself."""
        if by == "interrupt":
            os.kill(self.process.pid, signal.SIGINT)
        else:
            self.key(by)
        try:
            output, said = self.process.communicate(timeout=DEADLINE)
        except subprocess.TimeoutExpired:
            self.keep("not-closed")
            raise
        self.test.assertEqual(self.process.returncode, 0, said)
        return json.loads(output)


class WindowTest(CommandTest):
    """A test with a display, a home and a directory of its own."""

    def setUp(self):
        super().setUp()
        self.remembered = self.place / "settings" / "weft" / "window.json"
        self.home = self.place / "home"
        self.home.mkdir()
        shutil.rmtree(PICTURES / self.id().split(".", 1)[-1], ignore_errors=True)
        self.display = Display(self.place)
        self.addCleanup(self.display.close)

    def environment(self, display):
        kept = {name: value for name, value in os.environ.items()
                if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        shown = {"DISPLAY": display} if display else {}
        return {**kept, **shown, "HOME": str(self.home), "XDG_CONFIG_HOME": str(self.place / "settings"),
                "LIBGL_ALWAYS_SOFTWARE": "1"}

    def window(self, *arguments, paused=True, **remembered):
        """A window on which nothing moves until it is told to; and what it is to remember from the
        time before."""
        if remembered:
            self.remembered.parent.mkdir(parents=True, exist_ok=True)
            self.remembered.write_text(json.dumps(remembered))
        window = Window(self, self.display, [*arguments, *(["--paused"] if paused else [])])
        self.addCleanup(end, window.process)
        return window

    def files(self, pattern):
        return set(self.place.glob(pattern))

    def run_state(self, scene, frames):
        """What `weft run` says after so many frames of the scene."""
        return json.loads(self.weft("run", scene, "--frames", frames, "--json").stdout)


def end_with_parent():
    """In a process about to begin: that it does not outlive a test that is killed."""
    set_parent_death_signal = 1  # PR_SET_PDEATHSIG
    ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)


def end(process):
    """Ends a process that we started."""
    if process.poll() is None:
        process.kill()
    process.wait()
    for pipe in (process.stdout, process.stderr):
        if pipe is not None:
            pipe.close()
