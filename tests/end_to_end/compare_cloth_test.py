"""tools/compare_cloth.py: weft, Bullet and Blender on one sheet, and what it says without them."""

import json
import os
import pathlib
import shutil
import subprocess
import sys

from weft_command import COMMAND, CommandTest, unittest

SCRIPT = pathlib.Path(os.environ["WEFT_SOURCE_DIR"]) / "tools" / "compare_cloth.py"


class CompareClothTest(CommandTest):
    def run_script(self, *arguments):
        return subprocess.run([sys.executable, SCRIPT, *arguments], cwd=self.place, text=True,
                              capture_output=True)

    def refused(self, *arguments, says):
        done = self.run_script(*arguments)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, says)
        self.assertEqual(self.listing(), [])

    def test_without_weft(self):
        self.refused("./no-weft", says=r"\Acompare_cloth: \./no-weft: no such command; build weft")

    def test_without_blender(self):
        self.refused(COMMAND, "--blender", "./no-blender", "--json", "rows.json",
                     says=r"\Acompare_cloth: \./no-blender: no such command\. Install Blender")

    def test_a_blender_that_fails(self):
        blender = self.place / "blender"
        blender.write_text("#!/bin/sh\necho 'cannot start' >&2\nexit 9\n")
        blender.chmod(0o755)
        done = self.run_script(COMMAND, "--blender", str(blender))
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"\Acompare_cloth: Blender failed \(9\):\ncannot start")

    def test_weft_sags_no_more_than_others_in_less_time(self):
        if shutil.which("blender") is None:
            self.refused(COMMAND, says="Install Blender")
            return
        done = self.run_script(COMMAND, "--sizes", "40", "--repeats", "1", "--json", "rows.json")
        self.assertEqual(done.stderr, "")
        self.assertEqual(done.returncode, 0)
        rows = json.loads((self.place / "rows.json").read_text())["rows"]
        self.assertEqual(len(done.stdout.splitlines()), 2 + len(rows))
        ours = [row for row in rows if row["by"] == "weft"]
        others = [row for row in rows if row["by"] != "weft" and row["note"] is None]
        self.assertEqual(len(ours), 3)
        self.assertEqual(sum(row["by"].startswith("Blender") for row in others), 2)
        for row in ours + others:
            self.assertEqual(row["size"], 40)
            self.assertAlmostEqual(row["sag"], 2.4e-3, delta=2e-4)
            self.assertGreater(row["ms_per_frame"], 0)
        # To a hundredth of a millimetre, which float leaves open.
        self.assertLess(max(row["sag"] for row in ours), min(row["sag"] for row in others) + 1e-5)


if __name__ == "__main__":
    unittest.main()
