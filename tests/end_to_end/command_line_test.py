"""What the weft command says of itself and of scenes, and how it refuses what it does not understand."""

import json
import re

from weft_command import METHODS, SOURCE, UNLIMITED, CommandTest, settings, unittest

FORMATS = {"pc2", "mdd", "glb", "npy", "obj", "ply", "png", "mp4", "webm", "gif"}
SHIPPED = ["banner", "curtain", "drape", "flag", "mesh-cape", "sheet"]


class HelpTest(CommandTest):
    def test_version(self):
        self.assertRegex(self.weft("--version").stdout, r"\Aweft \d+\.\d+\.\d+\n\Z")

    def test_help_names_every_command_and_the_exit_statuses(self):
        text = self.weft("--help").stdout
        for word in ("run", "render", "check", "list", "Exit status", "130"):
            self.assertIn(word, text)

    def test_every_command_explains_its_options(self):
        options = {"run": ["--output", "--set", "--frames", "--threads", "--quiet", "--json"],
                   "render": ["--output", "--frame", "--set", "--quiet"],
                   "check": ["--set", "--json"],
                   "list": ["--json", "integrators"]}
        for command, words in options.items():
            done = self.weft(command, "--help")
            self.assertEqual(done.stderr, "")
            for word in words:
                self.assertIn(word, done.stdout, command)


class ListTest(CommandTest):
    def listed(self, what):
        """Rows of the JSON object; the text has every name too."""
        text = self.weft("list", what)
        done = self.weft("list", what, "--json")
        self.assertEqual(text.stderr + done.stderr, "")
        rows = json.loads(done.stdout)[what]
        for row in rows:
            self.assertIn(row["name"], text.stdout)
        return rows

    def test_integrators(self):
        rows = {row["name"]: row for row in self.listed("integrators")}
        self.assertEqual(tuple(rows), METHODS + UNLIMITED)
        self.assertEqual([rows[name]["order"] for name in METHODS], [1, 1, 2, 2, 2, 2, 3, 4, 4, 4])
        self.assertEqual([rows[name]["order"] for name in UNLIMITED],
                         [3, 5, 1, 2, 2, 2, 2, 2, 1, 1, 1, 1])
        for name in UNLIMITED[2:]:
            self.assertEqual(rows[name]["imaginary_limit"], "any")
            self.assertGreater(rows[name]["auto_step"], 0)
        for row in rows.values():
            self.assertTrue(row["formula"] and row["reference"], row)

    def test_fabrics(self):
        rows = self.listed("fabrics")
        self.assertTrue({"flag", "cotton", "silk"} <= {row["name"] for row in rows})
        for row in rows:
            self.assertGreater(row["mass_per_area"], 0)
            self.assertGreater(row["structural"]["stiffness"], 0)

    def test_scenes(self):
        rows = self.listed("scenes")
        self.assertEqual([row["name"] for row in rows], SHIPPED)
        for row in rows:
            with open(row["path"]) as file:
                self.assertTrue(file.readline().startswith("# "))

    def test_formats(self):
        self.assertEqual({row["name"] for row in self.listed("formats")}, FORMATS)

    def test_keys(self):
        rows = {row["key"]: row for row in json.loads(
            self.weft("list", "keys", "--json").stdout)["keys"]}
        for key in ("version", "cloth.resolution", "wind.gust.spread", "output.formats"):
            self.assertIn(key, rows)
        text = self.weft("list", "keys").stdout
        for row in rows.values():
            self.assertTrue(row["type"] and row["allowed"] and row["meaning"], row)
            self.assertIn(row["meaning"], text)

    def test_unknown_list_is_refused(self):
        line = self.error_line(self.weft("list", "colours", expect=2))
        self.assertRegex(line, r'\Aweft: "colours".*integrators')


class CheckTest(CommandTest):
    def test_sheet_in_words(self):
        done = self.weft("check", "sheet")
        self.assertEqual(done.stderr, "")
        for word in ("1600", "3120 structural", "3042 shear", "3040 bend", "omega_max",
                     "2 pinned", *METHODS):
            self.assertIn(word, done.stdout)
        self.assertEqual(self.listing(), [])

    def test_sheet_as_json(self):
        found = json.loads(self.weft("check", "sheet", "--json", *settings(
            integrator__time_step=0.0045, output__frames_per_second=50)).stdout)
        self.assertEqual(found["particles"], 1600)
        self.assertEqual(found["pinned"], 2)
        self.assertEqual(found["springs"], {"structural": 3120, "shear": 3042, "bend": 3040})
        self.assertEqual(found["triangles"], 2 * 39 * 39)
        self.assertAlmostEqual(found["mass"], 1600.0)
        self.assertEqual((found["time_step"], found["steps_per_frame"]), (0.004, 5))
        self.assertEqual(found["warnings"], [])

    def test_stable_steps_follow_from_omega_max(self):
        found = json.loads(self.weft("check", "sheet", "--json").stdout)
        limits = {"symplectic-euler": 2, "verlet": 2, "time-corrected-verlet": 2,
                  "velocity-verlet": 2, "rk3": 3**0.5, "rk4": 8**0.5, "yoshida4": 1.5734,
                  "forest-ruth": 1.5734}
        self.assertEqual(tuple(found["stable_step"]), METHODS + UNLIMITED)
        for method in UNLIMITED:
            self.assertEqual(found["stable_step"][method], "any")
        for method, limit in limits.items():
            self.assertAlmostEqual(found["stable_step"][method] * found["omega_max"], limit,
                                   delta=1e-3 * limit, msg=method)
        self.assertIsNone(found["stable_step"]["forward-euler"])
        self.assertIsNone(found["stable_step"]["rk2"])

    def test_a_step_beyond_the_limit_is_warned_of(self):
        done = self.weft("check", "sheet", "--json", *settings(
            integrator__time_step=0.032, output__frames_per_second=31.25))
        self.assertRegex(json.loads(done.stdout)["warnings"][0], "beyond the stable")

    def test_every_shipped_scene_is_in_order(self):
        for scene in SHIPPED:
            found = json.loads(self.weft("check", scene, "--json").stdout)
            self.assertGreater(found["omega_max"], 0)
            self.assertLessEqual(found["time_step"], found["stable_step"][found["method"]], scene)
            self.assertFalse([line for line in found["warnings"] if "stable" in line], scene)


class InvalidSceneTest(CommandTest):
    def test_each_is_refused_with_its_message(self):
        directory = SOURCE / "scenes" / "invalid"
        paths = sorted(directory.glob("*.toml"))
        self.assertGreaterEqual(len(paths), 30)
        self.place = directory  # the messages name files as they are given
        before = self.listing()
        for path in paths:
            with self.subTest(scene=path.name):
                expected = re.match("# expect: (.*)", path.read_text(errors="replace"))[1]
                # A mesh or texture that the scene names and nobody can read is a failure to read.
                unreadable = re.search(r"cannot be read: (no such file|not a file)", expected)
                done = self.weft("check", path.name, expect=3 if unreadable else 2)
                self.assertEqual(self.error_line(done), "weft: " + expected)
                self.assertEqual(done.stdout, "")
        self.assertEqual(self.listing(), before)


class UsageTest(CommandTest):
    """Exit status 2, one line that says what is wrong, and no file made."""

    def refused(self, *arguments, says):
        path = self.small_scene()
        done = self.weft(*[path if word == "SCENE" else word for word in arguments], expect=2)
        self.assertRegex(self.error_line(done), r"\Aweft: .*" + says)
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.listing(), ["small.toml"])

    def test_commands(self):
        self.refused(says="subcommand")
        self.refused("fly", "SCENE", says="fly|subcommand")

    def test_options(self):
        self.refused("run", says="SCENE")
        self.refused("run", "SCENE", "--frobnicate", says="--frobnicate")
        self.refused("run", "SCENE", "--frames", "-1", says="--frames")
        self.refused("run", "SCENE", "--frames", "many", says="--frames")
        self.refused("run", "SCENE", "--frames", "1e3", says="--frames")
        self.refused("run", "SCENE", "--threads", "0", says="--threads")
        self.refused("run", "SCENE", "-o", says="--output|-o")
        self.refused("run", "SCENE", "--quiet", "--json", says="--quiet|--json")
        self.refused("run", "SCENE", "another", says="another")

    def test_unknown_scene_gets_the_nearest_name(self):
        self.refused("run", "flga", says='"?flga"?.*flag')

    def test_settings(self):
        def setting(text, says):
            self.refused("run", "SCENE", "--set", text, says=says)

        setting("cloth.resolutoin=[4,4]", "cloth.resolutoin.*cloth.resolution")
        setting("intergator.method=rk4", "integrator")
        setting("integrator.method", "KEY=VALUE")
        setting("=rk4", "KEY=VALUE")
        setting("integrator.time_step=fast", "integrator.time_step.*fast.*number above 0")
        setting("integrator.time_step=0", "integrator.time_step.*0.*above 0")
        setting("integrator.method=rk5", "integrator.method.*rk5")
        setting("cloth.resolution=[1,4]", "cloth.resolution.*at least 2")
        setting("cloth.resolution=4", "cloth.resolution")
        setting("material.particle_mass=nan", "material.particle_mass.*nan")
        setting("output.formats=[\"avi\"]", "output.formats.*avi")
        setting("pins[3].select=top-edge", r"pins\[3\]")

    def test_automatic_step_of_a_method_that_has_none(self):
        self.refused("run", "SCENE", *settings(integrator__method="rk2", integrator__time_step="auto",
                                               material__structural__damping=0), says="rk2")

    def test_a_cloth_too_large_for_memory_is_refused_with_the_estimate(self):
        self.refused("run", "SCENE", "--set", "cloth.resolution=[60000,60000]",
                     says=r"cloth.resolution.*\d+(\.\d+)? [GTP]i?B")


if __name__ == "__main__":
    unittest.main()
