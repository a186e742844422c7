"""Ctrl-C, and what is said while a run goes on."""

import os
import pty
import re
import struct
import subprocess

import numpy as np

from weft_command import COMMAND, ENDLESS, CommandTest, settings, unittest


class InterruptTest(CommandTest):
    def test_recordings_end_whole_with_the_frames_so_far(self):
        status, said = self.interrupt("run", self.small_scene(), "-o", "out", "--frames", ENDLESS,
                                      *settings(output__formats='["npy", "pc2"]'))
        self.assertEqual(status, 130, said)
        found = self.summary("out")
        self.assertEqual(found["status"], "interrupted")
        frames = found["frames"] + 1
        self.assertLess(frames, ENDLESS)
        for kind in ("positions", "velocities"):
            self.assertEqual(np.load(self.place / "out" / f"small.{kind}.npy").shape,
                             (frames, 60, 3))
        self.assertEqual(np.load(self.place / "out" / "small.times.npy").shape, (frames,))
        cache = (self.place / "out" / "small.pc2").read_bytes()
        self.assertEqual(cache[:12], b"POINTCACHE2\0")
        _, points, _, _, samples = struct.unpack("<iiffi", cache[12:32])
        self.assertEqual((points, samples), (60, frames))
        self.assertEqual(len(cache), 32 + 12 * points * samples)
        self.assertEqual(self.listing("out"),
                         ["open_in_blender.py", "small.obj", "small.pc2", "small.positions.npy",
                          "small.times.npy", "small.velocities.npy", "summary.json"])

    def test_without_recordings(self):
        status, said = self.interrupt("run", self.small_scene(), "-o", "out", "--frames", ENDLESS,
                                      *settings(output__formats="[]"))
        self.assertEqual(status, 130, said)
        self.assertEqual(self.summary("out")["status"], "interrupted")


class ProgressTest(CommandTest):
    FRAMES = 500

    def test_plain_lines_where_there_is_no_terminal(self):
        done = self.weft("run", self.small_scene(), "--frames", self.FRAMES)
        lines = [line for line in done.stderr.splitlines() if line.startswith("frame ")]
        self.assertIn(len(lines), range(5, 15))
        self.assertRegex(lines[-1], rf"\Aframe {self.FRAMES}/{self.FRAMES}  t 5.00 s  "
                                    r"[\d.]+ ms/frame  .* left  strain [\d.]+ %  energy [-\d.e]+ J\Z")
        self.assertNotIn("\r", done.stderr)
        self.assertNotIn("\x1b", done.stderr)

    def test_one_updating_line_at_a_terminal(self):
        ours, theirs = pty.openpty()
        process = subprocess.Popen(
            [COMMAND, "run", self.small_scene(), "--frames", str(self.FRAMES),
             *settings(cloth__resolution="[60,40]", integrator__time_step=0.0005)],
            cwd=self.place, stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        said = b""
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError:  # the other end is closed
                break
            if not piece:
                break
            said += piece
        os.close(ours)
        self.assertEqual(process.wait(), 0)
        lines = said.decode().replace("\r\n", "\n").rstrip("\n").split("\n")
        progress = [line for line in lines if "frame " in line and "ms/frame" in line]
        self.assertEqual(len(progress), 1, lines)
        self.assertEqual(progress[0], lines[-1])
        updates = re.findall(r"\rframe (\d+)/500 ", progress[0])
        self.assertGreater(len(updates), 1, progress[0])
        self.assertEqual(updates[-1], "500")


if __name__ == "__main__":
    unittest.main()
