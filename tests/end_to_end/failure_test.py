"""Runs that cannot go on: divergence, and files that cannot be read or written. Nothing half-written
stays."""

import json
import resource
import shutil
import signal
import subprocess

import numpy as np

from weft_command import COMMAND, SMALL_SCENE, CommandTest, settings, unittest


class DivergenceTest(CommandTest):
    TOO_LONG = settings(integrator__time_step=0.02, output__frames_per_second=50,
                        output__duration=4)

    def test_message_names_step_time_place_and_advice(self):
        done = self.weft("run", self.small_scene(), "--quiet", *self.TOO_LONG, expect=1)
        first, advice = done.stderr.splitlines()[:2]
        self.assertRegex(first, r"\Aweft: velocity-verlet diverged in step \d+ at t = [\d.]+ s: "
                                r".*(particle|spring)")
        self.assertRegex(advice, r"0\.02 s.*0\.01267 s would have been stable.*time_step")

    def test_frames_so_far_are_recorded(self):
        self.weft("run", self.small_scene(), "-o", "out", *self.TOO_LONG, expect=1)
        found = self.summary("out")
        self.assertEqual(found["status"], "diverged")
        places = np.load(self.place / "out" / "small.positions.npy")
        self.assertEqual(len(places), found["frames"] + 1)
        self.assertTrue(np.all(np.isfinite(places)))
        divergence = found["divergence"]
        self.assertEqual(divergence["step"], found["frames"] + 1)  # one step a frame
        self.assertAlmostEqual(divergence["time"], divergence["step"] * 0.02)
        self.assertEqual(len(self.listing("out")), 4)

    def test_json_keeps_to_one_object_on_standard_output(self):
        done = self.weft("run", self.small_scene(), "--json", *self.TOO_LONG, expect=1)
        self.assertEqual(json.loads(done.stdout)["status"], "diverged")

    def test_halving_the_step_goes_on_to_the_end(self):
        self.weft("run", self.small_scene(), "-o", "out", *self.TOO_LONG,
                  *settings(integrator__on_divergence="halve-step"))
        found = self.summary("out")
        self.assertEqual((found["status"], found["frames"]), ("done", 200))
        self.assertGreaterEqual(found["halvings"], 1)
        places = np.load(self.place / "out" / "small.positions.npy")
        self.assertEqual(len(places), 201)
        self.assertTrue(np.all(np.isfinite(places)))


class FileTest(CommandTest):
    """Exit status 3: the first line names the file and the reason."""

    def fails(self, *arguments, says, **options):
        done = self.weft("run", *arguments, expect=3, **options)
        self.assertRegex(self.error_line(done), r"\Aweft: .*" + says)
        self.assertEqual(done.stdout, "")

    def test_missing_scene(self):
        self.fails("nowhere.toml", says="nowhere.toml.*No such file")
        self.fails("nowhere/flag", says="nowhere/flag.*No such file")
        self.assertEqual(self.listing(), [])

    def test_scene_is_a_directory(self):
        (self.place / "folder.toml").mkdir()
        self.fails("folder.toml", says="folder.toml")

    def test_directory_below_a_file(self):
        (self.place / "file").write_text("")
        self.fails(self.small_scene(), "-o", "file/out", says="file/out.*Not a directory")
        self.fails(self.small_scene(), "-o", "file", says="file")
        self.assertEqual(self.listing(), ["file", "small.toml"])

    def test_directory_that_nobody_can_make(self):
        self.fails(self.small_scene(), "-o", "/proc/weft-out", says="/proc/weft-out")

    def test_a_folder_stands_where_a_recording_goes(self):
        (self.place / "out" / "small.pc2").mkdir(parents=True)
        self.fails(self.small_scene(), "-o", "out", *settings(output__formats='["npy", "pc2"]'),
                   says="small.pc2.*Is a directory")
        self.assertEqual([name for name in self.listing("out") if name != "summary.json"],
                         ["small.pc2"])

    def test_standard_output_that_cannot_be_written(self):
        for arguments in (("list", "keys"), ("check", "sheet", "--json"),
                          ("run", self.small_scene(), "--json")):
            with self.subTest(command=arguments[0]), open("/dev/full", "w") as full:
                done = subprocess.run([COMMAND, *map(str, arguments)], cwd=self.place, stdout=full,
                                      stderr=subprocess.PIPE, text=True)
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertRegex(self.error_line(done), "No space left on device")

    def test_data_directory_without_scenes(self):
        self.fails("flag", says=r"holds no directory", env={"WEFT_DATA_DIR": str(self.place)})


class FullDiskTest(CommandTest):
    FORMATS = ("npy", "pc2", "mdd", "glb", "obj", "ply")
    LARGE = SMALL_SCENE.replace("[10, 6]", "[40, 24]")  # 960 particles, 20 frames

    def only_a_failed_summary_stays(self, directory):
        """summary.json may tell of the failure; no recording and no temporary file is there."""
        names = self.listing(directory)
        self.assertEqual([name for name in names if name != "summary.json"], [])
        if names:
            found = self.summary(directory)
            self.assertEqual(found["status"], "failed")
            self.assertEqual([path for path in found["files"] if "summary" not in path], [])

    def limited(self, format_, size):
        """A run in which no file may grow beyond `size` bytes."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # so that write() reports it
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        return self.weft("run", self.small_scene(text=self.LARGE), "-o", format_, "--quiet",
                         *settings(output__formats=f'["{format_}"]'), expect=3, preexec_fn=limit,
                         restore_signals=False)

    def test_file_too_large(self):
        for format_ in self.FORMATS:
            with self.subTest(format=format_):
                done = self.limited(format_, 8192)
                self.assertRegex(self.error_line(done), rf"\Aweft: {format_}/.*: .*[Ff]ile too")
                self.only_a_failed_summary_stays(format_)

    def test_disk_too_small(self):
        """A disk of 64 KiB of our own, in a mount namespace of our own, where the system allows it;
        elsewhere a limit on the size of files stands in for it."""
        small_disk = ["unshare", "--map-root-user", "--mount", "sh", "-c"]
        disk = self.place / "disk"
        disk.mkdir()
        mount = f"mount -t tmpfs -o size=64k weft-test '{disk}'"
        can_mount = shutil.which("unshare") and subprocess.run(
            [*small_disk, mount], capture_output=True).returncode == 0
        for format_ in self.FORMATS:
            with self.subTest(format=format_):
                if not can_mount:
                    self.limited(format_, 65536 if format_ in ("npy", "pc2", "mdd") else 8192)
                    self.only_a_failed_summary_stays(format_)
                    continue
                out = disk / "out"
                scene = self.small_scene(text=self.LARGE)
                script = (f"{mount} && '{COMMAND}' run '{scene}' -o '{out}' --quiet"
                          f" --set 'output.formats=[\"{format_}\"]'; echo $?; ls -A '{out}'")
                done = subprocess.run([*small_disk, script], capture_output=True, text=True)
                status, *names = done.stdout.split()
                self.assertEqual(status, "3", done.stderr)
                self.assertRegex(self.error_line(done), r"\Aweft: .*No space left on device")
                self.assertEqual([name for name in names if name != "summary.json"], [])


if __name__ == "__main__":
    unittest.main()
