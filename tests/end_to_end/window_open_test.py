"""Opening the window: every shipped scene, its keys and panels, its size, and where there is none."""

import json
import re

import numpy as np

from weft_command import METHODS
from window_driver import WindowTest
from window_picture import difference, read_png


class SceneTest(WindowTest):
    """Each shipped scene stands on the screen under its name."""

    def shipped(self):
        return json.loads(self.weft("list", "scenes", "--json").stdout)["scenes"]

    def look_at(self, name):
        [shipped] = [s for s in self.shipped()
                     if s["name"] == name]
        window = self.window(name, panels=False)
        window.wait_title(re.escape(shipped["title"]) + " - [a-z0-9-]+ - weft - paused$")
        cloth = window.cloth()
        rows, columns = np.flatnonzero(cloth.any(axis=1)), np.flatnonzero(cloth.any(axis=0))
        self.assertGreater(cloth.sum(), 4000, "pixels of the wireframe")
        self.assertGreater(columns[-1] - columns[0], 200)
        self.assertGreater(rows[-1] - rows[0], 50)
        first = window.keep("first")
        self.assertGreater(first[cloth].std(axis=0).max(), 5.0, "a cloth of one colour")
        window.step(3)
        window.settle()
        self.assertGreater(difference(first, window.keep("third")), 0.0)
        report = window.close()
        self.assertEqual(report["simulation_frame"], 3)
        self.assertTrue(report["pristine"])
        self.assertEqual(report["state_hash"], self.run_state(name, 3)["state_hash"])

    def test_flag(self):
        self.look_at("flag")

    def test_banner(self):
        self.look_at("banner")

    def test_curtain(self):
        self.look_at("curtain")

    def test_drape(self):
        self.look_at("drape")

    def test_mesh_cape(self):
        self.look_at("mesh-cape")

    def test_sheet(self):
        self.look_at("sheet")

    def test_these_are_all(self):
        names = [s["name"] for s in self.shipped()]
        tested = {method[5:].replace("_", "-") for method in dir(self) if method.startswith("test_")}
        self.assertEqual(set(names), tested - {"these-are-all"})


class KeyTest(WindowTest):
    def test_without_a_scene_the_flag_flies(self):
        window = self.window(paused=False)
        window.wait_title(r"^Flag in the wind - [a-z0-9-]+ - weft$")
        pictures = [window.picture()]
        for _ in range(8):
            window.wait(lambda: difference(pictures[-1], window.picture()) > 0.001, "movement")
            pictures.append(window.picture())
        window.key("space")
        window.wait_title("paused$")
        report = window.close()
        self.assertGreater(report["simulation_frame"], 0)
        self.assertEqual(report["state_hash"],
                         self.run_state("flag", report["simulation_frame"])["state_hash"])
        self.assertGreater(report["frames_drawn"], 8)
        self.assertGreater(report["frames_per_second"], 0.0)
        self.assertGreater(report["latency_ms"]["median"], 0.0)
        self.assertGreaterEqual(report["latency_ms"]["largest"], report["latency_ms"]["median"])
        self.assertGreater(report["seconds"], 0.0)

    def test_escape_never_quits(self):
        window = self.window(self.small_scene())
        plain = window.picture()
        window.key(*["Escape"] * 4)
        for key in ("F1", "ctrl+s", "ctrl+o"):
            window.see(key)
            window.keep(f"open-{key}")
            window.see("Escape", like=plain)
        window.key("5")
        window.wait_title("rk4")
        window.settle()
        changed = window.picture()
        window.see("ctrl+q")  # asks about the change
        window.keep("unsaved")
        window.see("Escape", like=changed)
        window.key(*["Escape"] * 4)
        window.settle()
        self.assertEqual(window.title, "Small - rk4 - weft - paused")
        window.close(by="interrupt")

    def test_help_names_keys_and_mouse(self):
        window = self.window(self.small_scene())
        plain = window.picture()
        overlay = window.see("F1", by=0.15)
        window.see("F1", like=plain)
        window.see("question", like=overlay)
        window.close()

    def test_numbers_choose_the_method(self):
        window = self.window(self.small_scene())
        names = {}
        for number in range(1, 10):
            before = window.title
            window.key(str(number))
            if number < 9:
                window.wait(lambda: window.title != before, "another method")
            window.settle()
            names[number] = re.search(r"^Small - ([a-z0-9-]+) - weft", window.title).group(1)
        self.assertEqual([names[n] for n in range(1, 9)],
                         ["forward-euler", "verlet", "velocity-verlet", "symplectic-euler", "rk4",
                          "implicit-euler", "tr-bdf2", "xpbd"])
        self.assertIn(names[9], METHODS)
        window.key("6")
        window.wait_title("implicit-euler")
        window.step(4)
        report = window.close(by="interrupt")
        self.assertTrue(report["pristine"], "a change at frame 0 is a change of the scene")
        expected = json.loads(self.weft("run", "small.toml", "--frames", 4, "--json", "--set",
                                        "integrator.method=implicit-euler").stdout)
        self.assertEqual(report["state_hash"], expected["state_hash"])

    def test_layers_and_panels_can_be_switched(self):
        window = self.window("flag", panels=False)
        for key, others in (("w", 1), ("s", 2), ("v", 1), ("m", 1), ("a", 1)):
            plain = window.picture()
            for number in range(others):
                window.see(key)
                window.keep(f"layer-{key}{number}")
            window.see(key, like=plain)
        window.see("Tab", by=0.2)
        window.see("Tab", like=plain)
        window.close()

    def test_mouse_turns_shifts_and_zooms(self):
        window = self.window("flag", panels=False)
        plain = window.picture()
        for button in (1, 3):
            window.drag((200, 200), (260, 230), (330, 260), button=button)
            self.assertGreater(difference(plain, window.keep(f"button-{button}")), 0.02)
            self.assertGreater(window.cloth().sum(), 4000)
            window.see("c")
            plain = window.picture()
        window.wheel(640, 340, 2)
        window.wait(lambda: difference(plain, window.picture()) > 0.02, "nearer view")
        near = np.flatnonzero(window.cloth().any(axis=0))
        window.see("c")
        far = np.flatnonzero(window.cloth().any(axis=0))
        self.assertGreater(near[-1] - near[0], far[-1] - far[0], "nearer, it is wider")
        report = window.close()
        self.assertTrue(report["pristine"], "looking changes nothing")

    def test_every_size_is_drawn(self):
        window = self.window("flag")
        for width, height in ((900, 600), (640, 480), (480, 320), (1280, 720)):
            window.xdotool("windowsize", "--sync", window.number, width, height)
            window.settle()
            picture = read_png(window.screenshot())
            window.keep(f"{width}x{height}")
            self.assertEqual(picture.shape, (height, width, 3))
            self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 200)
        window.close()


class NoWindowTest(WindowTest):
    """What `weft view` says where it cannot open."""

    def refused(self, *arguments, expect, display=None):
        return self.error_line(self.weft("view", *arguments, expect=expect,
                                         env=self.environment(display)))

    def test_no_display(self):
        for display in (None, ":6543"):
            line = self.weft("view", "flag", expect=3, env=self.environment(display)).stderr
            self.assertRegex(line, r"\Aweft: no display")
            self.assertIn("weft render SCENE -o FILE", line)

    def test_wrong_scenes(self):
        self.assertIn("no-such-scene", self.refused("no-such-scene", expect=2))
        wrong = self.small_scene("wrong", "version = 1\n[cloth]\nsize = [1.0, -1.0]\n")
        self.assertIn("cloth.size", self.refused(wrong, expect=2))
        self.assertIn("no.such", self.refused("flag", "--set", "no.such=1", expect=2))

    def test_recordings_that_cannot_be_read(self):
        self.assertIn("missing.pc2", self.refused("missing.pc2", expect=3,
                                                  display=self.display.name))
        (self.place / "broken.pc2").write_bytes(b"POINTCACHE2\0" + b"\xff" * 10)
        self.assertIn("broken.pc2", self.refused("broken.pc2", expect=3,
                                                 display=self.display.name))

    def test_wrong_comparisons(self):
        self.assertIn("ruby", self.refused("flag", "--compare", "ruby", expect=2))
        self.assertIn("at most 3", self.refused("flag", "--compare", "rk4,verlet,xpbd,rk2", expect=2))
        self.weft("run", self.small_scene(), "-o", "out", "--set", 'output.formats=["pc2"]')
        self.assertIn("--compare", self.refused("out/small.pc2", "--compare", "rk4", expect=2))

    def test_wrong_scenes_are_named_before_the_missing_display(self):
        self.assertNotIn("display", self.refused("no-such-scene", expect=2))
