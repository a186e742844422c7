"""cmake --install, and the command and the library as they work from there.

CTest gives the build directory, and the generator, compiler and flags it was made with.
"""

import json
import os
import shutil
import subprocess

from weft_command import COMMAND, SOURCE, CommandTest, settings, unittest

BUILD = os.environ["WEFT_BUILD_DIR"]


class InstallTest(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.without_data_dir = {name: value for name, value in os.environ.items()
                                if name != "WEFT_DATA_DIR"}

    def done(self, *arguments, **options):
        done = subprocess.run(list(map(str, arguments)), capture_output=True, text=True,
                              env=self.without_data_dir, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def setUp(self):
        super().setUp()
        self.prefix = self.place / "installed"
        self.done("cmake", "--install", BUILD, "--prefix", self.prefix)

    def test_a_project_of_somebody_else_builds_and_runs(self):
        """Its state hash is that of the command, run with the same scene."""
        build = self.place / "consumer"
        self.done("cmake", "-S", SOURCE / "tests" / "end_to_end" / "consumer", "-B", build,
                  "-G", os.environ["WEFT_GENERATOR"],
                  f"-DCMAKE_CXX_COMPILER={os.environ['WEFT_CXX_COMPILER']}",
                  f"-DCMAKE_CXX_FLAGS={os.environ['WEFT_CXX_FLAGS']}",
                  f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.done("cmake", "--build", build)
        found = self.done(build / "consumer", cwd=self.place)
        command = self.done(COMMAND, "run", "flag", "-o", self.place / "out", "--json", "--frames", 3,
                            *settings(cloth__resolution="[16,11]", output__formats="[]"))
        self.assertEqual(found, json.loads(command)["state_hash"] + "\n")

    def test_the_command_finds_its_scenes_wherever_it_is_moved(self):
        moved = self.place / "elsewhere"
        shutil.move(self.prefix, moved)
        (self.place / "work").mkdir()
        listed = json.loads(self.done(moved / "bin" / "weft", "list", "scenes", "--json",
                                      cwd=self.place / "work"))["scenes"]
        self.assertEqual([row["name"] for row in listed],
                         ["banner", "curtain", "drape", "flag", "mesh-cape", "sheet"])
        for row in listed:
            self.assertTrue(row["path"].startswith(str(moved) + os.sep), row)
        self.done(moved / "bin" / "weft", "run", "mesh-cape", "--frames", 1, "--quiet",
                  *settings(output__formats="[]"), cwd=self.place / "work")
        self.assertTrue((self.place / "work" / "weft-out" / "mesh-cape" / "summary.json").exists())

    def test_every_public_header_and_no_bad_scene_is_installed(self):
        headers = {path.name for path in (self.prefix / "include" / "weft").iterdir()}
        self.assertEqual(headers, {path.name for path in (SOURCE / "include" / "weft").glob("*.h")}
                         | {"version.h"})
        self.assertEqual(list(self.prefix.rglob("invalid")), [])


class HelloTest(CommandTest):
    """apps/hello, the smallest complete program."""

    def test_it_makes_its_files(self):
        done = subprocess.run([os.environ["WEFT_HELLO"]], cwd=self.place, capture_output=True,
                              text=True, timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.listing(), ["hello.obj", "hello.pc2", "open_in_blender.py"])
        self.assertEqual(sorted(os.path.basename(line) for line in done.stdout.split()),
                         self.listing())
        self.assertEqual((self.place / "hello.pc2").stat().st_size, 32 + 31 * 12 * 61 * 41)


if __name__ == "__main__":
    unittest.main()
