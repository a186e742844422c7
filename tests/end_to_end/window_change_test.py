"""What one does to a cloth in the window: grabbing, pinning, obstacles, numbers, methods, undoing; and
what becomes of it, read from the scene that the window saves."""

import json
import tomllib

import numpy as np

from weft_command import settings
from window_driver import WindowTest
from window_picture import boxes_of, changed, count_of, difference

ACCENT = (240, 180, 75)   # of the button that one most likely wants
FILL = (62, 91, 138)      # of sliders, up to their value
BEYOND = (86, 46, 51)     # of the slider of the step, beyond the stable one
BLUE = (65, 117, 145)     # of the sheet's squares, and of that in its nearest corner
NOTE = (255, 128, 116)    # of what has gone wrong with a cloth
RECORD = (255, 116, 97)   # of the button that records


class ChangeTest(WindowTest):
    def saved(self, window, name="saved.toml"):
        """The scene that the window saves, as tomllib reads it."""
        window.see("ctrl+s")
        window.keep("save")
        window.wait(lambda: boxes_of(window.picture(), FILL, smallest=200), "selected name")
        window.type(name)
        window.hold("Return", (self.place / name).exists, "saved scene")
        window.settle()
        return tomllib.loads((self.place / name).read_text())

    def corner(self, window):
        """A place on the sheet beside the corner that is nearest to the eye."""
        rows, columns = np.nonzero(~changed(window.picture(), np.array(BLUE), by=25))
        lowest = rows.max()
        return int(np.median(columns[rows == lowest])) + 2, int(lowest) - 8

    def buttons(self, window):
        """The middles of those buttons that one most likely wants."""
        return [((left + right) // 2, (top + bottom) // 2)
                for left, top, right, bottom in boxes_of(window.picture(), ACCENT, smallest=900)
                if 18 < bottom - top < 32 and right - left > 40]


class TouchTest(ChangeTest):
    def test_a_corner_is_dragged(self):
        window = self.window("sheet", panels=False)
        x, y = self.corner(window)
        before = window.keep("before")
        window.press(x, y)
        window.pull((x, y + 60), (x, y + 160))
        window.step(12)
        window.keep("held")
        window.release()
        window.step(1)
        after = window.keep("after")
        self.assertGreater(difference(before[y + 10:y + 80], after[y + 10:y + 80]), 0.01)
        scene = self.saved(window)
        self.assertEqual(scene["start"]["state"], "saved.start.npy")
        report = window.close()
        self.assertFalse(report["pristine"])
        self.assertEqual(report["simulation_frame"], 13)
        self.weft("run", "sheet", "-o", "free", "--frames", 13, *settings(output__formats='["npy"]'))
        held = np.load(self.place / "saved.start.npy")[0]
        free = np.load(self.place / "free" / "sheet.positions.npy")[13].reshape(-1, 3)
        shift = np.linalg.norm(held - free, axis=1).reshape(40, 40)
        self.assertGreater(shift.max(), 0.5, "metres")
        self.assertEqual(shift.max(), max(shift[-8:, :8].max(), shift[-8:, -8:].max()),
                         "where it was held")
        self.assertLess(shift[0].max(), 0.1 * shift.max(), "far from there")
        # and the saved scene begins with what was on the screen
        self.assertEqual(self.run_state("saved.toml", 0)["state_hash"], report["state_hash"])

    def test_clicks_pin_and_unpin(self):
        window = self.window(self.small_scene(), panels=False)
        cloth = window.cloth()
        rows, columns = np.nonzero(cloth)
        middle = int(np.median(columns)), int(np.median(rows))
        window.move(*middle)
        window.answered()
        window.xdotool("click", 1)
        window.answered()
        window.dismiss()
        pins = self.saved(window, "one.toml")["pins"]
        window.keep("pinned")
        self.assertEqual(len(pins), 2, pins)
        self.assertEqual(len(pins[1]["select"]["particles"]), 1, pins)
        window.move(*middle)
        window.answered()
        window.xdotool("click", 1)
        window.answered()
        window.dismiss()
        self.assertEqual(len(self.saved(window, "none.toml")["pins"]), 1)
        window.close()

    def test_pins_are_moved(self):
        window = self.window("sheet", panels=False)
        # The right corner at the back, under its mark.
        pins = boxes_of(window.picture(), (255, 190, 0), smallest=8, tolerance=25)
        x, y = max(((box[0] + box[2]) // 2, (box[1] + box[3]) // 2) for box in pins)
        window.drag((x, y), (x + 30, y + 40), (x + 60, y + 90))
        window.keep("moved")
        window.step(5)
        scene = self.saved(window)
        report = window.close()
        self.assertEqual(self.run_state("saved.toml", 5)["state_hash"], report["state_hash"])
        self.weft("run", "saved.toml", "-o", "run", "--frames", 5, *settings(output__formats='["npy"]'))
        moved = np.load(self.place / "run" / "saved.positions.npy")[5].reshape(40, 40, 3)
        self.assertGreater(np.abs(moved[0, -1] - [10.0, 36.0, 0.0]).max(), 0.5, scene["pins"])
        np.testing.assert_allclose(moved[0, 0], [-10.0, 36.0, 0.0], atol=1e-6)

    def test_obstacles_are_added_moved_and_taken_back(self):
        window = self.window(self.small_scene(), panels=False)
        plain = window.picture()
        window.see("o")
        with_ball = window.keep("sphere")
        rows, columns = np.nonzero(changed(plain, with_ball))
        x, y = int(np.median(columns)), int(np.median(rows))
        [dropped] = self.saved(window, "dropped.toml")["obstacles"]
        window.drag((x, y), (x + 30, y - 20), (x + 80, y - 50))
        window.keep("moved")
        [moved] = self.saved(window, "moved.toml")["obstacles"]
        shift = np.subtract(moved["sphere"]["centre"], dropped["sphere"]["centre"])
        self.assertGreater(shift[0], 0.0, "to the right")
        self.assertGreater(shift[1], 0.0, "and up")
        self.assertEqual(moved["sphere"]["radius"], dropped["sphere"]["radius"])
        window.see("ctrl+z")
        window.settle()
        window.key("p")
        window.settle()
        window.keep("sphere-and-plane")
        obstacles = self.saved(window, "two.toml")["obstacles"]
        self.assertEqual([sorted(o)[-1] for o in obstacles], ["sphere", "plane"], obstacles)
        window.key("ctrl+z")
        window.settle()
        [sphere] = self.saved(window, "one.toml")["obstacles"]
        self.assertEqual(sphere, dropped)
        window.see("ctrl+z", like=plain)
        self.assertNotIn("obstacles", self.saved(window, "none.toml"))
        window.close()


class NumberTest(ChangeTest):
    def slider_at(self, window, box):
        """Whether a slider is there and not the field that one types into."""
        return boxes_of(window.picture()[box[1]:box[3], :300], FILL, smallest=400)

    def test_sliders_take_numbers_from_the_keyboard(self):
        window = self.window("sheet")
        panel = window.picture()[:, :300]
        step, structural = sorted(boxes_of(panel, FILL, smallest=400), key=lambda box: box[1])[:2]
        window.move(structural[0] + 40, structural[1] + 10)
        window.answered()
        window.xdotool("keydown", "ctrl", "click", 1, "keyup", "ctrl")
        window.key("ctrl+a")
        window.type("400")
        window.keep("typed")
        window.hold("Return", lambda: self.slider_at(window, structural), "slider again")
        window.settle()
        self.assertLess(step[1], structural[1])
        window.step(5)
        scene = self.saved(window)
        self.assertEqual(scene["material"]["structural"]["stiffness"], 400)
        self.assertNotIn("start", scene)
        report = window.close()
        self.assertTrue(report["pristine"])
        self.assertEqual(report["simulation_frame"], 5)
        for run in (self.run_state("saved.toml", 5),
                    json.loads(self.weft("run", "sheet", "--frames", 5, "--json", *settings(
                        material__structural__stiffness=400)).stdout)):
            self.assertEqual(run["state_hash"], report["state_hash"])

    def test_what_is_not_allowed_is_refused_and_goes(self):
        window = self.window("sheet")
        step = sorted(boxes_of(window.picture()[:, :300], FILL, smallest=400),
                      key=lambda box: box[1])[0]
        window.move(step[0] + 40, step[1] + 10)
        window.answered()
        window.xdotool("keydown", "ctrl", "click", 1, "keyup", "ctrl")
        window.key("ctrl+a")
        window.type("-1")
        window.hold("Return", lambda: self.slider_at(window, step), "slider again")
        window.settle()
        window.keep("refused")
        scene = self.saved(window)
        self.assertEqual(scene["integrator"]["time_step"], 0.001)
        report = window.close()
        self.assertTrue([m for m in report["messages"] if "time_step" in m], report["messages"])

    def test_changes_are_undone_and_redone(self):
        window = self.window(self.small_scene())
        for key, method in (("5", "rk4"), ("6", "implicit-euler"), ("ctrl+z", "rk4"),
                            ("ctrl+z", "velocity-verlet"), ("ctrl+y", "rk4"),
                            ("ctrl+shift+z", "implicit-euler"), ("ctrl+z", "rk4")):
            window.key(key)
            window.wait_title(f"^Small - {method} - weft - paused$")
        window.step(2)
        scene = self.saved(window)
        self.assertEqual(scene["integrator"]["method"], "rk4")
        report = window.close()
        self.assertEqual(report["state_hash"], self.run_state("saved.toml", 2)["state_hash"])

    def test_a_change_in_flight_is_not_the_scene_s_own(self):
        window = self.window(self.small_scene())
        window.step(3)
        window.key("5")
        window.wait_title("rk4")
        window.step(3)
        self.saved(window)
        report = window.close()
        self.assertFalse(report["pristine"])
        self.assertEqual(report["simulation_frame"], 6)
        self.assertEqual(self.run_state("saved.toml", 0)["state_hash"], report["state_hash"])


class DivergenceTest(ChangeTest):
    TOO_LONG = settings(integrator__method="velocity-verlet", integrator__time_step=0.02)

    def diverge(self, window):
        """Until the message stands over the cloth."""
        window.key("space")
        window.wait(lambda: self.buttons(window), "button to go on")
        window.wait_title("paused$")
        window.keep("diverged")

    def recover(self, window):
        window.click(*self.buttons(window)[0])
        window.wait_title("weft$")
        before = window.picture()
        window.wait(lambda: np.abs(window.bar().astype(int) - before[-40:, :880]).max() > 60, "frames")
        window.key("space")
        window.wait_title("paused$")
        window.settle()
        window.keep("recovered")
        self.assertFalse(self.buttons(window), "the message is gone")

    def test_too_long_a_step(self):
        window = self.window("flag", *self.TOO_LONG)
        self.diverge(window)
        self.recover(window)
        scene = self.saved(window)
        self.assertEqual(scene["integrator"]["time_step"], "auto")
        report = window.close()
        self.assertTrue([m for m in report["messages"] if "diverged" in m], report["messages"])
        self.assertTrue(report["pristine"])
        self.assertEqual(self.run_state("saved.toml", report["simulation_frame"])["state_hash"],
                         report["state_hash"])

    def test_the_slider_shows_where_it_ends(self):
        window = self.window("flag", *settings(integrator__method="velocity-verlet"))
        left, top, right, bottom = boxes_of(window.picture()[:, :300], BEYOND, smallest=100)[0]
        y = (top + bottom) // 2
        window.drag((left - 20, y), (left + 5, y), (right - 2, y))
        window.keep("beyond")
        self.diverge(window)
        self.recover(window)
        window.close(by="interrupt")

    def test_a_method_without_a_stable_step(self):
        window = self.window("sheet", *settings(integrator__method="forward-euler"))
        for _ in range(7):
            window.key("equal")  # faster: it takes some seconds of its time
        self.diverge(window)
        self.recover(window)
        self.assertNotIn("forward-euler", window.title)
        window.close(by="interrupt")


class ComparisonTest(ChangeTest):
    def cloths(self, window):
        """The part that wires cover of the four quarters of the cloths' area."""
        cloth = window.cloth()[:680]
        return [float(part.mean()) for half in np.array_split(cloth, 2)
                for part in np.array_split(half, 2, axis=1)]

    def test_four_methods_side_by_side(self):
        window = self.window("flag", "--compare", "rk4,implicit-euler,xpbd", panels=False)
        self.assertGreater(min(self.cloths(window)), 0.01)
        before = window.keep("begin")
        window.step(10)
        window.settle()
        after = window.keep("later")
        for a, b in zip(np.array_split(before[:680], 2), np.array_split(after[:680], 2)):
            for left, right in zip(np.array_split(a, 2, axis=1), np.array_split(b, 2, axis=1)):
                self.assertGreater((np.abs(left.astype(int) - right).max(axis=2) > 40).mean(), 0.002)
        report = window.close()
        self.assertEqual(report["simulation_frame"], 10)
        self.assertEqual(report["state_hash"], self.run_state("flag", 10)["state_hash"],
                         "the others change nothing of it")

    def test_one_that_diverges_leaves_the_other(self):
        window = self.window("sheet", "--compare", "forward-euler", panels=False)
        for _ in range(4):
            window.key("equal")  # it takes 3.4 s of its time
        window.key("space")
        window.wait_title("weft$")
        window.wait(lambda: count_of(window.picture()[:680], NOTE) > 20, "red note")
        window.key("space")
        window.wait_title("paused$")
        window.settle()
        window.keep("one-diverged")
        report = window.close()
        self.assertGreater(report["simulation_frame"], 0)
        self.assertTrue([m for m in report["messages"] if "forward-euler" in m], report["messages"])

    def test_key_adds_and_takes_away(self):
        window = self.window("flag", panels=False)
        plain = window.picture()
        window.see("k", by=0.05)
        window.keep("two")
        window.see("k", like=plain)
        window.close()
