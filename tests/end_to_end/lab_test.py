"""weft lab, from outside: the report, its numbers, going on after an interrupt, refusals."""

import csv
import json
import re
import signal
import subprocess
import threading

from weft_command import COMMAND, SMALL_SCENE, CommandTest, unittest

STILL_SCENE = SMALL_SCENE.replace('select = "left-edge"', "select = { particles = [%s] }" % ", ".join(
    str(n) for n in range(60)))


def is_of_time(name):
    return "varies" in name


def numbers(section):
    """All that a section says but times, as text."""
    kept = []
    for block in section["blocks"]:
        if block["kind"] == "table":
            for row in block["rows"]:
                kept.append([cell for name, cell in zip(block["columns"], row, strict=True)
                             if not is_of_time(name)])
        elif block["kind"] == "plot" and not is_of_time(block["x"]["label"] + block["y"]["label"]):
            kept.append([(series["name"], series["points"]) for series in block["series"]])
    kept.append([finding for finding in section["findings"] if not is_of_time(finding["unit"])])
    return json.dumps(kept, indent=1)


class LabCommandTest(CommandTest):
    def lab(self, *words, out="out", **options):
        return self.weft("lab", *words, "-o", out, "--quick", "--quiet", timeout=600, **options)

    def results(self, out="out"):
        return json.loads((self.place / out / "lab.json").read_text())

    def trials(self, out="out"):
        return {path: path.stat().st_mtime_ns
                for path in (self.place / out / "trials").rglob("*.json")}


class ReportTest(LabCommandTest):
    METHODS = ("--methods", "symplectic-euler,rk4,implicit-euler")

    def test_writes_a_page_and_every_number_beside_it(self):
        self.lab("order", "stability", self.small_scene(), *self.METHODS)
        page = (self.place / "out" / "report.html").read_text()
        study = self.results()
        sections = study["sections"]
        self.assertEqual([s["experiment"] for s in sections], ["order", "stability"])
        for section in sections:
            self.assertIn("weft lab " + section["experiment"], section["command"])
            self.assertTrue(section["answer"].endswith("."), section["answer"])
            for block in section["blocks"]:
                if "id" not in block:
                    continue
                files = self.listing(f"out/{section['experiment']}")
                self.assertIn(block["id"] + ".csv", files)
                if block["kind"] == "plot":
                    self.assertIn(block["id"] + ".svg", files)
                    self.assertIn(block["id"] + ".png", files)
        self.assertNotRegex(page, r"(src|href)=[\"']https?://")
        self.assertIn("Small", page)

    def test_measures_the_orders_that_methods_state(self):
        self.lab("order", self.small_scene(), *self.METHODS)
        findings = self.results()["sections"][0]["findings"]
        for method, order in (("symplectic-euler", 1), ("rk4", 4), ("implicit-euler", 1)):
            fitted = [f["value"] for f in findings if method in f["name"]]
            self.assertTrue(fitted, findings)
            self.assertAlmostEqual(fitted[0], order, delta=0.1)

    def test_the_same_scene_gives_the_same_numbers_on_any_number_of_threads(self):
        scene = self.small_scene()
        words = ("order", "stability", "energy", "sensitivity", "work-precision", scene, *self.METHODS)
        self.lab(*words, "--threads", 1, out="one")
        self.lab(*words, "--threads", 2, out="two")
        one, two = (self.results(out)["sections"] for out in ("one", "two"))
        for a, b in zip(one, two, strict=True):
            self.assertEqual(numbers(a), numbers(b), a["experiment"])

    def test_json_is_the_studys_file(self):
        done = self.weft("lab", "sensitivity", self.small_scene(), "-o", "out", "--quick", "--json")
        self.assertEqual(json.loads(done.stdout), self.results())

    def test_tables_are_csv_with_a_heading(self):
        self.lab("stability", self.small_scene(), *self.METHODS)
        for block in self.results()["sections"][0]["blocks"]:
            if block["kind"] != "table":
                continue
            with open(self.place / "out" / "stability" / (block["id"] + ".csv"), newline="") as file:
                rows = list(csv.reader(file))
            self.assertEqual(rows[0], block["columns"])
            self.assertEqual(len(rows) - 1, len(block["rows"]))

    def test_two_scenes_stand_side_by_side(self):
        soft = self.small_scene("soft")
        stiff = self.small_scene("stiff", SMALL_SCENE.replace("40.0", "160.0"))
        self.weft("lab", "compare", "stability", soft, stiff, "-o", "out", "--quick", "--quiet", *self.METHODS)
        sections = self.results()["sections"]
        self.assertEqual([section["scene"] for section in sections], ["soft", "stiff"])
        limits = [{f["name"]: f["value"] for f in section["findings"]} for section in sections]
        shared = [name for name in limits[0] if "rk4" in name and "limit" in name and name in limits[1]]
        self.assertTrue(shared, limits)
        self.assertGreater(limits[0][shared[0]], limits[1][shared[0]])


class ResumeTest(LabCommandTest):
    def test_goes_on_after_an_interrupt(self):
        scene = self.small_scene()
        command = [COMMAND, "lab", "order", "stability", "energy", str(scene), "--quick", "-o", "out",
                   "--threads", "1"]
        process = subprocess.Popen(command, cwd=self.place, text=True, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        watchdog = threading.Timer(600, process.kill)
        watchdog.start()
        self.addCleanup(watchdog.cancel)
        said = ""
        for line in process.stderr:
            said += line
            if re.match(r" *[1-9]\d* %", line):
                break
        process.send_signal(signal.SIGINT)
        said += process.communicate()[1]
        self.assertEqual(process.returncode, 130, said)
        self.assertIn("the same command goes on", said)
        self.assertNotIn("report.html", self.listing("out"))
        kept = self.trials()
        self.assertTrue(kept)
        self.lab("order", "stability", "energy", scene)
        after = self.trials()
        self.assertGreater(len(after), len(kept))
        for path, time in kept.items():
            self.assertEqual(after[path], time, path)

    def test_a_second_study_measures_nothing_again(self):
        scene = self.small_scene()
        self.lab("stability", scene)
        first = self.trials()
        self.lab("stability", scene)
        self.assertEqual(self.trials(), first)


class LabRefusalTest(LabCommandTest):
    def refused(self, *words, expect=2, **options):
        return self.weft("lab", *words, expect=expect, **options).stderr

    def test_a_misspelt_experiment(self):
        self.assertIn("did you mean stability?", self.refused("stabilty"))

    def test_a_scene_too_many(self):
        said = self.refused("order", "flag", "sheet")
        self.assertIn('takes one scene, not 2: "flag" and "sheet"', said)

    def test_a_scene_too_few_to_compare(self):
        self.assertIn("compare takes two scenes, not 1", self.refused("compare", "flag"))

    def test_a_method_that_is_none(self):
        self.assertIn('"rk5" is no method', self.refused("order", "--methods", "rk4,rk5"))

    def test_a_wrong_key(self):
        self.assertIn("cloth.resolutoin", self.refused("order", "--set", "cloth.resolutoin=[3,3]"))

    def test_a_file_in_the_place_of_the_directory(self):
        (self.place / "out").write_text("")
        self.assertIn("out", self.refused("order", "flag", "-o", "out", expect=3))
        self.assertEqual((self.place / "out").read_text(), "")

    def test_no_gnuplot_is_told_before_anything_is_measured(self):
        said = self.refused("order", "flag", "-o", "out", expect=3, env={"PATH": "/nowhere"})
        self.assertIn("gnuplot-nox", said)
        self.assertEqual(self.listing("out"), [])

    def test_what_does_not_apply_is_in_the_report_with_the_reason(self):
        self.lab("stability", "energy", self.small_scene("still", STILL_SCENE))
        for section in self.results()["sections"]:
            self.assertTrue(section["skipped"], section["experiment"])
        self.assertIn(section["skipped"], (self.place / "out" / "report.html").read_text())


if __name__ == "__main__":
    unittest.main()
