"""Every method of the engine against the independent implementation, in double precision.

All frames of a run of at least 100 steps are compared: positions relative to the cloth's diagonal,
velocities relative to the largest speed in the run.
"""

import json
import sys

import numpy as np

from reference_cloth import Cloth, read_scene
from reference_integrators import METHODS, simulate, steps_a_frame
from weft_command import SCENES, SOURCE, CommandTest, unittest

TOLERANCE = 1e-9
STEPS = 100

# Undamped, forward-euler and rk2 amplify the stiffest waves, and with them the rounding errors in
# which two implementations differ: they take shorter steps.
SHORTER = {"forward-euler": 8, "rk2": 2}


class ReferenceTest(CommandTest):
    def differences(self, path, changes, frames):
        """Largest relative difference of positions and of velocities over all frames."""
        changes = {**changes, "integrator.precision": "double", "output.formats": ["npy"]}
        scene = read_scene(path, changes)
        method = scene["integrator"]["method"]
        options = []
        for key, value in changes.items():
            options += ["--set", f"{key}={json.dumps(value)}"]  # a JSON value is one of TOML too
        self.weft("run", path, "-o", method, "--frames", frames, "--quiet", *options)
        recorded = {kind: np.load(self.place / method / f"{path.stem}.{kind}.npy")
                    for kind in ("times", "positions", "velocities")}
        times, positions, velocities = map(np.array, simulate(scene, frames))
        self.assertEqual(recorded["positions"].dtype, np.dtype("<f8"))
        self.assertEqual(recorded["positions"].shape, positions.shape)
        self.assertEqual(recorded["velocities"].shape, velocities.shape)
        np.testing.assert_allclose(recorded["times"], times, rtol=1e-12, atol=0)
        self.assertTrue(np.all(np.isfinite(positions)), "the reference itself blew up")
        speed = np.abs(velocities).max()
        self.assertGreater(speed, 0.1, "hardly anything moves: nothing is compared")
        return (np.abs(recorded["positions"] - positions).max()
                / np.hypot(*scene["cloth"]["size"]),
                np.abs(recorded["velocities"] - velocities).max() / speed)

    def compare(self, path, methods=tuple(METHODS), **changes):
        """`changes` are keys of the scene, with two underscores for the dot."""
        changes = {key.replace("__", "."): value for key, value in changes.items()}
        scene = read_scene(path, changes)
        frame_length = 1 / scene["output"]["frames_per_second"]
        for method in methods:
            with self.subTest(method=method):
                time_step = scene["integrator"]["time_step"] / SHORTER.get(method, 1)
                frames = -(-STEPS // steps_a_frame(frame_length, time_step)) + 1
                in_x, in_v = self.differences(path, {
                    **changes, "integrator.method": method, "integrator.time_step": time_step},
                    frames)
                print(f"{path.stem:16} {method:22} dx {in_x:.1e}  dv {in_v:.1e}", file=sys.stderr)
                self.assertLess(in_x, TOLERANCE)
                self.assertLess(in_v, TOLERANCE)

    def test_sheet(self):
        self.compare(SOURCE / "scenes" / "sheet.toml")

    def test_sheet_in_long_steps(self):
        """Near the limit: the shortest waves turn by 1.44 radians a step, and the sheet falls far."""
        self.compare(SOURCE / "scenes" / "sheet.toml", integrator__time_step=0.016,
                     output__frames_per_second=31.25)

    def test_swung_7x5(self):
        self.compare(SCENES / "swung_7x5.toml")

    def test_tumbling_2x2(self):
        self.compare(SCENES / "tumbling_2x2.toml")

    def test_gusty_13x29(self):
        self.compare(SCENES / "gusty_13x29.toml")

    def test_ribbon_11x2(self):
        self.compare(SCENES / "ribbon_11x2.toml")

    def test_free_9x4(self):
        self.compare(SCENES / "free_9x4.toml")


class FrequencyTest(CommandTest):
    """The largest frequency that `weft check` finds, against the eigenvalues of a dense matrix."""

    def stiffness_over_mass(self, cloth):
        """M^-1 K of the free co-ordinates, linearised at the start."""
        x, _ = cloth.start()
        d = x[cloth.q] - x[cloth.p]
        length = np.linalg.norm(d, axis=1)
        matrix = np.zeros((3 * cloth.grid.count,) * 2)
        for n, (p, q) in enumerate(zip(cloth.p, cloth.q)):
            along = np.outer(d[n], d[n]) / length[n] ** 2
            # Over k l; none where the spring is compressed, since that only lowers frequencies.
            tension = max(0.0, 1 - cloth.length[n] / length[n])
            block = cloth.stiffness[n] * (along + tension * (np.eye(3) - along))
            for one, other in ((p, q), (q, p)):
                matrix[3 * one:3 * one + 3, 3 * one:3 * one + 3] += block
                matrix[3 * one:3 * one + 3, 3 * other:3 * other + 3] -= block
        free = np.setdiff1d(np.arange(cloth.grid.count), cloth.pinned)
        chosen = (3 * free[:, None] + np.arange(3)).ravel()
        return matrix[np.ix_(chosen, chosen)] / np.repeat(cloth.mass[free], 3)[:, None]

    def test_largest_frequency(self):
        for name in ("swung_7x5", "tumbling_2x2", "gusty_13x29", "ribbon_11x2", "free_9x4"):
            with self.subTest(cloth=name):
                path = SCENES / f"{name}.toml"
                matrix = self.stiffness_over_mass(Cloth(read_scene(path)))
                expected = np.sqrt(np.linalg.eigvals(matrix).real.max())
                found = json.loads(self.weft("check", path, "--json").stdout)["omega_max"]
                print(f"{name:16} omega_max {found:.9g}, dense {expected:.9g}", file=sys.stderr)
                self.assertAlmostEqual(found / expected, 1, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
