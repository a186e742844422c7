"""How much memory a run takes: its largest resident set, as the system counts it."""

import os
import re
import subprocess
import sys

from weft_command import COMMAND, ENDLESS, CommandTest, settings, unittest

MIB = 2**20


class MemoryTest(CommandTest):
    def command(self, resolution, formats, frames, method):
        """weft run sheet in single precision, one step a frame."""
        return [COMMAND, "run", "sheet", "-o", "out", "--frames", str(frames),
                *settings(cloth__resolution=f"[{resolution},{resolution}]", output__formats=formats,
                          output__frames_per_second=100, integrator__time_step=0.01,
                          integrator__method=method)]

    def peak(self, resolution, formats, frames, method="velocity-verlet"):
        """Largest resident set of a whole run [bytes]. Linux counts what Python had when it started the
        command as well, so this is for runs that take more than that."""
        process = subprocess.Popen(self.command(resolution, formats, frames, method),
                                   cwd=self.place, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return usage.ru_maxrss * 1024

    def base(self, method):
        """Largest resident set so far of a run of four particles, seen while it goes on [bytes]."""
        process = subprocess.Popen(self.command(2, "[]", ENDLESS, method), cwd=self.place, text=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        with process:
            while not process.stderr.readline().startswith("frame "):
                self.assertIsNone(process.poll())
            with open(f"/proc/{process.pid}/status") as status:
                kib = re.search(r"VmHWM:\s+(\d+) kB", status.read())[1]
            process.kill()
        return int(kib) * 1024

    def test_ten_frames_of_a_million_particles_within_a_gibibyte(self):
        peak = self.peak(1000, '["pc2"]', 10)
        print(f"1000 x 1000, pc2, 10 frames: {peak / MIB:.0f} MiB", file=sys.stderr)
        self.assertLess(peak, 1024 * MIB)
        self.assertEqual((self.place / "out" / "sheet.pc2").stat().st_size, 32 + 11 * 12 * 10**6)

    def test_bytes_a_particle_without_recording(self):
        """The resident set of 250 000 particles less that of four, over their number; for a method
        that keeps one acceleration, one that keeps two states, and one with four stages."""
        for method in ("velocity-verlet", "verlet", "rk4"):
            with self.subTest(method=method):
                base = self.base(method)
                bytes_each = (self.peak(500, "[]", 2, method) - base) / 500**2
                print(f"{method}: {base / MIB:.0f} MiB, then {bytes_each:.0f} bytes a particle",
                      file=sys.stderr)
                self.assertLess(bytes_each, 200)


if __name__ == "__main__":
    unittest.main()
