"""Files that the window reads and writes: scenes, recordings, screenshots, what it remembers."""

import json
import subprocess

import numpy as np

from weft_command import SMALL_SCENE
from window_change_test import ACCENT, RECORD, ChangeTest
from window_picture import NOISE, boxes_of, difference, read_png


class SceneFileTest(ChangeTest):
    def test_a_saved_scene_runs_to_the_same_state(self):
        for name in ("sheet", "flag"):
            window = self.window(name)
            window.step(6)
            window.see("ctrl+s")
            file = self.place / f"{name}-edited.toml"
            window.hold("Return", file.exists, "file of the proposed name")
            window.settle()
            report = window.close()
            self.assertIn(str(file), [str(self.place / f) for f in report["files"]])
            self.assertTrue(report["pristine"])
            self.assertEqual(report["simulation_frame"], 6)
            self.assertEqual(set(self.listing()) & {file.name, "sheet-edited.start.npy"}, {file.name})
            self.assertEqual(self.run_state(file, 6)["state_hash"], report["state_hash"])

    def test_what_stands_is_replaced_only_when_told_to(self):
        path = self.small_scene()
        window = self.window(path)
        window.key("5")
        window.wait_title("rk4")
        asking = window.see("ctrl+s")
        window.keep("asks")
        window.key("Return")
        window.settle()
        self.assertLess(difference(asking, window.picture()), 0.02, "the dialog stays")
        self.assertEqual(path.read_text(), SMALL_SCENE)
        window.see("Escape")
        self.assertEqual(path.read_text(), SMALL_SCENE)
        window.close(by="interrupt")

    def test_unsaved_changes_are_asked_about(self):
        window = self.window(self.small_scene())
        window.key("5")
        window.wait_title("rk4")
        window.settle()
        for _ in range(2):
            window.see("ctrl+q")
            window.keep("asks")
            window.see("Escape")
        self.saved(window)
        window.close()

    def test_other_scenes_are_opened(self):
        self.small_scene("other", SMALL_SCENE.replace("Small", "Other"))
        window = self.window(self.small_scene())
        window.see("ctrl+o")
        window.keep("open")
        window.type("other.toml")
        window.keep("typed")
        window.hold("Return", lambda: window.title.startswith("Other - "), "other scene")
        window.key("space")
        window.wait_title("paused$")
        report = window.close()
        self.assertEqual(report["state_hash"],
                         self.run_state("other.toml", report["simulation_frame"])["state_hash"])


class RecordingTest(ChangeTest):
    """What is recorded in the window: a frame for each that was shown since, read back by others."""

    FRAMES = 8

    def record(self, form, **options):
        """The report, and the file's frames as the window counts them."""
        window = self.window(self.small_scene(), recording_format=form, **options)
        window.step(2)
        window.bar_after("F9")
        window.step(self.FRAMES)
        window.keep("recording")
        window.key("F9")
        window.wait(lambda: self.files(f"*.{form}"), "recording in its place")
        window.settle()
        window.keep("recorded")
        report = window.close()
        [message] = [m for m in report["messages"] if m.startswith("Recorded ")]
        [path] = self.files(f"*.{form}")
        self.assertIn(path.name, message)
        self.assertIn(str(path), [str(self.place / f) for f in report["files"]])
        self.assertEqual(int(message.split()[1]), self.FRAMES + 1)
        self.assertFalse([n for n in self.listing() if "tmp" in n or n.startswith(".")])
        return path

    def picture_of(self, path):
        self.weft("render", path, "-o", "shown.png", "--set", "render.size=[320,180]")
        self.assertGreater(read_png(self.place / "shown.png").std(), 5.0)

    def test_mp4(self):
        path = self.record("mp4")
        found = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-of", "json",
                                "-show_streams", path], check=True, capture_output=True).stdout
        [stream] = json.loads(found)["streams"]
        self.assertEqual(stream["codec_type"], "video")
        self.assertEqual(int(stream["nb_read_frames"]), self.FRAMES + 1)

    def test_glb(self):
        path = self.record("glb")
        self.assertEqual(path.read_bytes()[:4], b"glTF")
        self.picture_of(path)

    def test_pc2(self):
        path = self.record("pc2")
        self.picture_of(path)
        data = path.read_bytes()
        particles, samples = np.frombuffer(data, "<i4", 1, 16)[0], np.frombuffer(data, "<i4", 1, 28)[0]
        self.assertEqual(samples, self.FRAMES + 1)
        found = np.frombuffer(data, "<f4", offset=32).reshape(samples, particles, 3)
        self.weft("run", "small.toml", "-o", "run", "--frames", self.FRAMES + 2)
        expected = np.load(self.place / "run" / "small.positions.npy").reshape(-1, particles, 3)
        np.testing.assert_allclose(found, expected[2:], atol=1e-6)

    def test_what_was_recorded_is_played_back(self):
        window = self.window(self.small_scene(), recording_format="pc2")
        window.bar_after("F9")
        window.step(self.FRAMES)
        window.key("F9")
        window.wait(lambda: self.files("*.pc2"), "recording in its place")
        window.settle()
        left, top, right, bottom = boxes_of(window.bar(), RECORD, smallest=40)[0]
        window.keep("button")
        height = window.picture().shape[0]
        window.click(right + 60, height - 40 + (top + bottom) // 2)
        window.wait_title(r"\.pc2 - weft")
        window.keep("played")
        window.close()


class PlaybackTest(ChangeTest):
    def recording(self, frames=20):
        self.weft("run", self.small_scene(), "-o", "out", "--frames", frames,
                  "--set", 'output.formats=["pc2"]')
        return "out/small.pc2"

    def test_steps_forward_and_back(self):
        window = self.window(self.recording())
        window.wait_title(r"^small\.pc2 - weft - paused$")
        first, bar = window.keep("first"), window.bar()
        self.assertGreater(window.cloth().sum(), 2000)
        window.step(10)
        window.settle()
        self.assertGreater(difference(first, window.keep("tenth")), 0.002)
        for _ in range(10):
            last = window.bar_after("Left")
        self.assertTrue(np.array_equal(bar, last), "the first again")
        window.close()

    def test_seeks(self):
        window = self.window(self.recording())
        # the timeline is the row above the buttons; its grip stands at the left
        timeline = window.picture()[-80:-40]
        left, top, right, bottom = boxes_of(timeline, ACCENT, smallest=40)[0]
        y = window.picture().shape[0] - 80 + (top + bottom) // 2
        bar = window.bar()
        window.drag(((left + right) // 2, y), (300, y), (600, y))
        window.settle()
        window.keep("sought")
        self.assertFalse(np.array_equal(bar, window.bar()), "another frame")
        grip = boxes_of(window.picture()[-80:-40], ACCENT, smallest=40)[0]
        self.assertLess(abs(grip[0] + grip[2] - 1200), 80, "the grip went along")
        window.key("r")
        window.wait(lambda: np.array_equal(bar, window.bar()), "first frame")
        window.close()

    def test_plays_and_can_be_closed(self):
        window = self.window(self.recording(), paused=False)
        window.wait_title(r"^small\.pc2 - weft$")
        bars = [window.bar()]
        for _ in range(4):
            window.wait(lambda: not np.array_equal(bars[-1], window.bar()), "next frame")
            bars.append(window.bar())
        window.key("5", "o", "ctrl+s", "F9")  # mean nothing to a recording
        window.key("space")
        window.wait_title("paused$")
        window.close()


class MemoryTest(ChangeTest):
    def test_a_screenshot_is_what_is_on_the_screen(self):
        window = self.window("flag")
        paths = [window.screenshot() for _ in range(2)]
        self.assertEqual([p.name for p in paths], ["weft-flag-0001.png", "weft-flag-0002.png"])
        window.settle()
        shown, written = window.picture(), read_png(paths[0])
        self.assertEqual(written.shape, shown.shape)
        self.assertLess(difference(written[:560], shown[:560]), 2 * NOISE)  # messages stand below
        report = window.close()
        self.assertEqual(len(report["files"]), 2)

    def test_a_screenshot_is_taken_of_a_dialog(self):
        window = self.window("flag")
        for key in ("ctrl+o", "ctrl+s"):
            plain = window.picture()
            asking = window.see(key)
            written = read_png(window.screenshot())
            self.assertLess(difference(written, asking), difference(written, plain))
            self.assertLess(difference(written[:560], asking[:560]), 2 * NOISE)
            window.see("Escape")
            window.key("Escape")
            window.settle()
        window.close()

    def test_what_was_set_is_there_the_next_time(self):
        window = self.window("flag")
        window.see("w")
        window.see("Tab")
        window.xdotool("windowsize", "--sync", window.number, 1000, 640)
        window.settle()
        window.close()
        remembered = json.loads(self.remembered.read_text())
        self.assertEqual(remembered["size"], [1000, 640])
        self.assertTrue(remembered["wireframe"])
        self.assertFalse(remembered["panels"])
        window = self.window("sheet")
        self.assertEqual(window.xdotool("getwindowgeometry", window.number).split()[-1], "1000x640")
        wires = window.keep("again")
        window.xdotool("windowsize", "--sync", window.number, 1280, 720)
        window.settle()
        window.see("w")
        window.close()
        remembered = json.loads(self.remembered.read_text())
        self.assertFalse(remembered["wireframe"])
        self.assertGreater(wires.std(), 5.0)
        self.assertEqual([f.rsplit("/", 1)[-1] for f in remembered["recent"]],
                         ["sheet.toml", "flag.toml"])

    def test_a_damaged_memory_is_forgotten(self):
        self.remembered.parent.mkdir(parents=True)
        for text in ("{", '{"size": [1e9, -3], "springs": "red", "recent": 5}', "\0"):
            self.remembered.write_text(text)
            window = self.window(self.small_scene())
            self.assertEqual(window.xdotool("getwindowgeometry", window.number).split()[-1],
                             "1280x720")
            window.close()
            json.loads(self.remembered.read_text())

    def test_an_interrupt_closes_it_properly(self):
        window = self.window(self.small_scene())
        window.step(3)
        report = window.close(by="interrupt")
        self.assertEqual(report["simulation_frame"], 3)
        self.assertTrue(self.remembered.exists())
