"""weft render and the picture formats: scenes and recordings to pictures and videos."""

import os
import struct
import subprocess

import numpy as np

from weft_command import ENDLESS, CommandTest, settings, unittest

TINY = settings(render__size="[64,48]")


class PictureTest(CommandTest):
    def decoded(self, name, frames=1):
        """Pixels [frame, row, column, 3] of a picture or video, decoded by ffmpeg."""
        raw = subprocess.run(["ffmpeg", "-v", "error", "-i", self.place / name, "-f", "rawvideo",
                              "-pix_fmt", "rgb24", "-fps_mode", "passthrough", "-"],
                             check=True, capture_output=True).stdout
        pixels = np.frombuffer(raw, np.uint8).reshape(-1, 48, 64, 3).astype(float)
        self.assertEqual(len(pixels), frames, name)
        return pixels

    def assert_shows_something(self, pixels):
        self.assertGreater(pixels.std(), 5.0, "a picture of one colour")

    def test_picture_of_a_scene(self):
        done = self.weft("render", self.small_scene(), "-o", "last.png", "--frames", 5, *TINY)
        self.assertEqual(done.stdout, "last.png\n")
        data = (self.place / "last.png").read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", data[16:24]), (64, 48))
        self.assert_shows_something(self.decoded("last.png"))
        self.assertEqual(self.listing(), ["last.png", "small.toml"])

    def test_frame_chooses_the_moment(self):
        for frame in (0, 20):
            self.weft("render", self.small_scene(), "-o", f"{frame}.png", "--frame", frame,
                      "--quiet", *TINY, *settings(render__camera="[0.5,1.7,3]",
                                                  render__target="[0.5,1.7,0]"))
        difference = np.abs(self.decoded("0.png") - self.decoded("20.png")).mean()
        self.assertGreater(difference, 1.0)

    def test_videos_of_a_scene(self):
        for name in ("a.mp4", "a.webm", "a.gif"):  # a gif has at most 50 frames a second
            self.weft("render", self.small_scene(), "-o", name, "--frames", 5, "--quiet", *TINY,
                      *settings(output__frames_per_second=50))
            pixels = self.decoded(name, frames=6)
            self.assert_shows_something(pixels)
            self.assertGreater(np.abs(pixels[0] - pixels[-1]).mean(), 0.2, "nothing moves")

    def test_recordings_as_pictures(self):
        self.weft("run", self.small_scene(), "-o", "out", "--frames", 8,
                  *settings(output__formats='["pc2", "mdd", "glb"]'))
        view = [*TINY, *settings(render__camera="[0.5,1.7,3]", render__target="[0.5,1.7,0]")]
        self.weft("render", self.small_scene(), "-o", "scene.png", "--frame", 6, *view,
                  *settings(render__texture="linen", render__mast="false"))
        expected = self.decoded("scene.png")
        for ending in ("pc2", "mdd", "glb"):
            self.weft("render", f"out/small.{ending}", "-o", f"{ending}.png", "--frame", 6, *view)
            difference = np.abs(self.decoded(f"{ending}.png") - expected).mean()
            self.assertLess(difference, 1.0, ending)

    def test_recordings_as_videos(self):
        self.weft("run", self.small_scene(), "-o", "out", "--frames", 4,
                  *settings(output__formats='["pc2", "glb"]'))
        for ending in ("pc2", "glb"):
            self.weft("render", f"out/small.{ending}", "-o", f"{ending}.mp4", *TINY)
            self.assert_shows_something(self.decoded(f"{ending}.mp4", frames=5))

    def test_run_records_pictures(self):
        self.weft("run", self.small_scene(), "-o", "out", "--frames", 3, *TINY,
                  *settings(output__formats='["mp4", "png"]'))
        self.decoded("out/small.mp4", frames=4)
        files = self.summary("out")["files"]
        self.assertEqual(sum(path.endswith(".png") for path in files), 4, files)


class RefusalTest(CommandTest):
    def refused(self, status, says, *arguments, **options):
        before = self.listing()
        done = self.weft("render", *arguments, *TINY, expect=status, **options)
        self.assertRegex(self.error_line(done), r"\Aweft: .*" + says)
        self.assertEqual(self.listing(), before)

    def test_wrong_options(self):
        scene = self.small_scene()
        self.refused(2, "output", scene)
        self.refused(2, r'a\.bmp.*\.png', scene, "-o", "a.bmp")
        self.refused(2, "frame.*single picture", scene, "-o", "a.mp4", "--frame", 3)

    def test_recordings_that_cannot_be(self):
        self.weft("run", self.small_scene(), "-o", "out", "--frames", 4,
                  *settings(output__formats='["pc2"]'))
        self.refused(2, "99.*frames 0 to 4", "out/small.pc2", "-o", "a.png", "--frame", 99)
        self.refused(2, r"\[render\]", "out/small.pc2", "-o", "a.png", "--set",
                     "wind.velocity=[1,0,0]")
        self.refused(3, "gone.pc2", "out/gone.pc2", "-o", "a.png")
        whole = (self.place / "out" / "small.pc2").read_bytes()
        (self.place / "out" / "small.pc2").write_bytes(whole[:-5])
        self.refused(3, "small.pc2", "out/small.pc2", "-o", "a.png")

    def test_texture_that_is_none(self):
        (self.place / "text.png").write_text("not a picture")
        self.refused(3, "text.png", self.small_scene(), "-o", "a.png", "--frames", 1,
                     *settings(render__texture="text.png"))

    def test_place_that_cannot_be_written(self):
        self.refused(3, "nowhere/a.png: there is no directory", self.small_scene(), "-o", "nowhere/a.png",
                     "--frames", 1)
        self.refused(3, "nowhere/a.mp4", self.small_scene(), "-o", "nowhere/a.mp4", "--frames", 1)

    def test_ffmpeg_is_missing(self):
        path = {**os.environ, "PATH": str(self.place)}
        self.refused(3, "ffmpeg", self.small_scene(), "-o", "a.mp4", "--frames", 2, env=path)
        done = self.weft("run", self.small_scene(), "-o", "out", "--frames", 2, *TINY,
                         *settings(output__formats='["npy", "mp4"]'), expect=3, env=path)
        self.assertRegex(done.stderr, "weft: .*ffmpeg")
        self.assertEqual([name for name in self.listing("out") if name != "summary.json"], [])

    def test_divergence(self):
        done = self.weft("render", self.small_scene(), "-o", "a.mp4", "--frames", 200, "--quiet",
                         *TINY, *settings(integrator__time_step=0.02, output__frames_per_second=50),
                         expect=1)
        self.assertRegex(done.stderr, r"diverged in step \d+")
        self.assertEqual([name for name in self.listing() if ".part" in name], [])


class VideoInterruptTest(CommandTest):
    """Ctrl-C at a terminal reaches ffmpeg too; the video must be whole all the same."""

    def test_video_ends_whole(self):
        for ending in ("mp4", "webm"):
            status, said = self.interrupt(
                "run", self.small_scene(), "-o", ending, "--frames", ENDLESS, *TINY,
                *settings(output__formats=f'["{ending}"]'), group=True)
            self.assertEqual(status, 130, said)
            found = self.summary(ending)
            self.assertEqual(found["status"], "interrupted")
            counted = subprocess.run(
                ["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0",
                 "-show_entries", "stream=nb_read_frames", "-of", "csv=p=0",
                 self.place / ending / f"small.{ending}"], check=True, capture_output=True, text=True)
            self.assertEqual(int(counted.stdout.strip().strip(",")), found["frames"] + 1)
            self.assertEqual(self.listing(ending), [f"small.{ending}", "summary.json"])



if __name__ == "__main__":
    unittest.main()
