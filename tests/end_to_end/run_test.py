"""weft run: what it writes, where, and what it says of it."""

import json

import numpy as np

from reference_cloth import Cloth, read_scene
from weft_command import SCENES, CommandTest, settings, unittest


class OutputTest(CommandTest):
    def test_default_directory_is_named_after_the_scene_file(self):
        self.weft("run", self.small_scene("my-towel"))
        self.assertEqual(self.listing("weft-out/my-towel"),
                         ["my-towel.positions.npy", "my-towel.times.npy", "my-towel.velocities.npy",
                          "summary.json"])

    def test_frames_are_recorded_beside_the_initial_state(self):
        self.weft("run", self.small_scene(), "-o", "out", "--frames", 7)
        shapes = {kind: np.load(self.place / "out" / f"small.{kind}.npy").shape
                  for kind in ("positions", "velocities", "times")}
        self.assertEqual(shapes, {"positions": (8, 60, 3), "velocities": (8, 60, 3), "times": (8,)})
        times = np.load(self.place / "out" / "small.times.npy")
        np.testing.assert_allclose(times, np.arange(8) / 100, rtol=1e-12)

    def test_duration_gives_the_frames_where_none_are_asked_for(self):
        self.weft("run", self.small_scene(), "-o", "out")
        self.assertEqual(len(np.load(self.place / "out" / "small.times.npy")), 21)

    def test_no_frames_record_the_initial_state(self):
        self.weft("run", self.small_scene(), "-o", "out", "--frames", 0)
        places = np.load(self.place / "out" / "small.positions.npy")
        rest = Cloth(read_scene(self.small_scene())).grid.rest
        np.testing.assert_allclose(places, [rest], rtol=0, atol=1e-15)

    def test_single_precision_writes_single_precision(self):
        self.weft("run", self.small_scene(), "-o", "out", *settings(integrator__precision="single"))
        self.assertEqual(np.load(self.place / "out" / "small.positions.npy").dtype, np.float32)

    def test_no_formats_leave_the_summary_alone(self):
        self.weft("run", self.small_scene(), "-o", "out", *settings(output__formats="[]"))
        self.assertEqual(self.listing("out"), ["summary.json"])

    def test_a_second_run_replaces_the_first(self):
        for frames in (9, 4):
            self.weft("run", self.small_scene(), "-o", "out", "--frames", frames)
        self.assertEqual(len(np.load(self.place / "out" / "small.positions.npy")), 5)
        self.assertEqual(len(self.listing("out")), 4)

    def test_settled_is_at_rest_and_alone(self):
        self.weft("run", self.small_scene(), "-o", "out", "--settle")
        places = np.load(self.place / "out" / "small.positions.npy")
        self.assertEqual(len(places), 1)
        self.assertFalse(np.load(self.place / "out" / "small.velocities.npy").any())
        found = self.summary("out")["settle"]
        self.assertTrue(found["converged"])
        self.assertLessEqual(found["relative_residual"], 1e-6)
        # From rest nothing moves: neither by an explicit method nor by an implicit one.
        for method in ("velocity-verlet", "tr-bdf2"):
            self.weft("run", self.small_scene(), "-o", "out", "--settle", "--frames", 20,
                      *settings(integrator__method=method))
            self.assertLess(np.abs(np.load(self.place / "out" / "small.positions.npy")
                                   - places).max(), 1e-4, method)

    def test_the_automatic_method_says_why(self):
        done = self.weft("run", self.small_scene(), "-o", "out",
                         *settings(integrator__method="auto", integrator__time_step="auto"))
        self.assertEqual(self.summary("out")["method"], "velocity-verlet")
        self.assertRegex(done.stderr, "velocity-verlet because .* cost less than")
        self.assertEqual(self.summary("out")["scene"]["integrator"]["method"], "auto")
        self.weft("run", self.small_scene(), "-o", "out", *settings(
            integrator__method="auto", integrator__time_step="auto",
            material__structural__stiffness=1e8))
        found = self.summary("out")
        self.assertEqual((found["method"], found["linear_solver"]), ("tr-bdf2", "multigrid"))
        self.assertRegex(found["method_reason"], "cost more than")
        self.assertGreater(found["solver"]["newton_iterations"], 0)

    def test_quiet_says_nothing(self):
        done = self.weft("run", self.small_scene(), "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_json_is_the_summary_and_nothing_else(self):
        done = self.weft("run", self.small_scene(), "-o", "out", "--json")
        self.assertEqual(done.stderr, "")
        self.assertEqual(json.loads(done.stdout), self.summary("out"))

    def test_words_name_every_file(self):
        done = self.weft("run", self.small_scene(), "-o", "out")
        for name in self.listing("out"):
            self.assertIn(f"out/{name}\n", done.stdout)

    def test_recordings_that_share_files_name_them_once(self):
        done = self.weft("run", self.small_scene(), "-o", "out", "--frames", 2,
                         *settings(output__formats='["pc2", "mdd"]'))
        files = self.summary("out")["files"]
        self.assertEqual(sorted(files), [f"out/{name}" for name in self.listing("out")])
        self.assertEqual(done.stdout.splitlines()[1:], files)

    def test_a_step_beyond_the_limit_is_warned_of_before_the_start(self):
        done = self.weft("run", self.small_scene(), "--frames", 1, *settings(
            integrator__time_step=0.02, output__frames_per_second=50))
        self.assertRegex(done.stderr, r"warning: the step of 0.02 s is beyond the stable 0\.01267 s")


class SummaryTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.weft("run", SCENES / "swung_7x5.toml", "-o", "out", "--frames", 12)
        self.found = self.summary("out")

    def test_counts_and_times(self):
        found = self.found
        self.assertRegex(found["weft"], r"\d+\.\d+\.\d+")
        self.assertEqual(found["status"], "done")
        self.assertEqual((found["particles"], found["frames"], found["steps"]), (35, 12, 144))
        self.assertEqual(found["springs"], {"structural": 58, "shear": 48, "bend": 16})
        self.assertAlmostEqual(found["mass"], 0.9 * 0.5 * 0.3)
        self.assertAlmostEqual(found["time_step"], 1 / 128 / 12, places=15)
        self.assertAlmostEqual(found["simulated_time"], 12 / 128)
        self.assertGreaterEqual(found["threads"], 1)
        self.assertGreater(found["particle_steps_per_second"], 0)
        self.assertRegex(found["state_hash"], r"\A[0-9a-f]{16}\Z")
        self.assertTrue(found["kernel"])
        self.assertTrue({"system", "processor", "hardware_threads"} <= set(found["machine"]))
        for seconds in found["wall_seconds"].values():
            self.assertGreaterEqual(seconds, 0)

    def test_scene_as_run_has_every_default(self):
        scene = self.found["scene"]
        self.assertEqual(scene["cloth"]["resolution"], [7, 5])
        self.assertEqual(scene["integrator"]["on_divergence"], "stop")
        self.assertEqual(scene["material"]["bend"]["layout"], "border")
        self.assertIn("texture", scene["render"])

    def test_files_are_those_in_the_directory(self):
        names = sorted(path.rsplit("/", 1)[1] for path in self.found["files"])
        self.assertEqual(names, self.listing("out"))

    def test_energies_are_those_of_the_recorded_states(self):
        cloth = Cloth(read_scene(SCENES / "swung_7x5.toml"))
        x = np.load(self.place / "out" / "swung_7x5.positions.npy")
        v = np.load(self.place / "out" / "swung_7x5.velocities.npy")
        for moment, frame in (("start", 0), ("end", -1)):
            energy = self.found["energy"][moment]
            length = np.linalg.norm(x[frame][cloth.q] - x[frame][cloth.p], axis=1)
            springs = np.sum(cloth.stiffness * (length - cloth.length) ** 2) / 2
            # Held particles have no say in the motion, so their kinetic energy may count or not.
            moving = np.setdiff1d(np.arange(35), cloth.pinned)
            kinetic = [np.sum(cloth.mass[of] * np.sum(v[frame][of] ** 2, axis=1)) / 2
                       for of in (moving, np.arange(35))]
            gravity = -np.sum(cloth.mass * (x[frame] @ cloth.gravity))
            self.assertAlmostEqual(energy["structural"] + energy["shear"] + energy["bend"], springs,
                                   delta=1e-9 * springs)
            self.assertAlmostEqual(energy["gravity"], gravity, delta=1e-9 * abs(gravity))
            self.assertTrue(np.any(np.isclose(energy["kinetic"], kinetic, rtol=1e-9, atol=1e-15)),
                            (energy["kinetic"], kinetic))

    def test_largest_strain_and_its_spring(self):
        cloth = Cloth(read_scene(SCENES / "swung_7x5.toml"))
        x = np.load(self.place / "out" / "swung_7x5.positions.npy")
        strains = np.linalg.norm(x[:, cloth.q] - x[:, cloth.p], axis=2) / cloth.length - 1
        frame, spring = np.unravel_index(np.argmax(np.abs(strains)), strains.shape)
        found = self.found["largest_strain"]
        self.assertAlmostEqual(found["strain"], strains[frame, spring], places=9)
        self.assertEqual(found["frame"], frame)
        self.assertEqual(sorted(found["particles"]),
                         sorted([cloth.p[spring], cloth.q[spring]]))


class DeterminismTest(CommandTest):
    """The state hash is the same for any number of threads, and for any recording."""

    def hashes(self, *arguments):
        found = []
        for threads in (1, 2, 7):
            done = self.weft("run", *arguments, "--json", "--threads", threads)
            result = json.loads(done.stdout)
            self.assertEqual(result["threads"], threads)
            found.append(result["state_hash"])
        return found

    def assert_all_same(self, *arguments):
        self.assertEqual(len(set(self.hashes(*arguments))), 1)

    def test_large_sheet(self):
        for method in ("velocity-verlet", "rk4", "tr-bdf2", "dopri5", "vbd"):
            self.assert_all_same("sheet", "--frames", 3, *settings(
                cloth__resolution="[210,140]", integrator__method=method, output__formats="[]"))

    def test_flag_in_gusts(self):
        self.assert_all_same("flag", "--frames", 2, *settings(
            cloth__resolution="[130,90]", integrator__time_step=0.00015,
            output__frames_per_second=500, output__formats="[]"))

    def test_automatic_step(self):
        """Ten frames, so that the step is estimated anew on the way."""
        self.assert_all_same("flag", "--frames", 10, *settings(output__formats="[]"))

    def test_mesh(self):
        self.assert_all_same("mesh-cape", "--frames", 2, *settings(output__formats="[]"))

    def test_recording_changes_nothing(self):
        found = set()
        for formats in ("[]", '["npy"]', '["pc2", "glb"]'):
            done = self.weft("run", self.small_scene(), "--json", *settings(output__formats=formats))
            found.add(json.loads(done.stdout)["state_hash"])
        self.assertEqual(len(found), 1)


if __name__ == "__main__":
    unittest.main()
