"""weft bench: what it prints, and what it refuses. Not how fast anything is."""

import json
import math
import os
import re
import signal
import subprocess
import threading

from weft_command import COMMAND, CommandTest, unittest

KEYS = {"case", "columns", "rows", "precision", "threads", "ns_per_particle_step",
        "ratio_to_textbook", "gflops", "fraction_of_peak"}


class TableTest(CommandTest):
    def rows(self, *words, more=()):
        done = self.weft("bench", "--quick", "--json", "--filter", " ".join(words), *more)
        self.assertEqual(done.stderr, "")
        found = json.loads(done.stdout)
        self.assertEqual(set(found), {"machine", "rows"})
        return found["machine"], found["rows"]

    def positive(self, *values):
        for value in values:
            self.assertIsInstance(value, float)
            self.assertTrue(math.isfinite(value) and value > 0, value)

    def test_rows_have_the_fixed_keys(self):
        machine, rows = self.rows("symplectic-euler", "40x40", "1 thread")
        self.assertEqual([(row["case"], row["precision"]) for row in rows],
                         [("symplectic-euler", "single"), ("symplectic-euler", "double")])
        for row in rows:
            self.assertLessEqual(KEYS, set(row))
            self.assertEqual((row["columns"], row["rows"], row["threads"]), (40, 40, 1))
            self.positive(*(row[key] for key in ("ns_per_particle_step", "ratio_to_textbook",
                                                 "gflops", "fraction_of_peak")))
            peak = machine["peak_gflops"][row["precision"]]
            self.assertAlmostEqual(row["fraction_of_peak"], row["gflops"] / peak)
            # 40 x 40: 9 202 springs of 32 operations, 1 600 particles of 24.
            operations = (9202 * 32 + 1600 * 24) / 1600
            self.assertAlmostEqual(row["gflops"], operations / row["ns_per_particle_step"])

    def test_machine_says_what_it_can_do_and_what_was_built_with_what(self):
        machine, _ = self.rows("textbook", "40x40")
        self.assertEqual(machine["hardware_threads"], len(os.sched_getaffinity(0)))
        for key in ("processor", "instruction_set", "compiler"):
            self.assertTrue(machine[key])
        self.positive(*machine["peak_gflops"].values())
        self.assertEqual([level["where"] for level in machine["update_bandwidth"]],
                         ["first-level cache", "second-level cache", "8 MiB", "128 MiB"])
        self.positive(*(level["gb_per_s"] for level in machine["update_bandwidth"]))
        self.assertEqual(set(machine["peers"]), {"boost", "bullet"})

    def test_the_textbook_is_the_unit_of_its_own_ratio(self):
        _, rows = self.rows("textbook", "40x40")
        self.assertEqual([row["case"] for row in rows], ["textbook"])
        self.assertEqual(rows[0]["ratio_to_textbook"], 1.0)
        self.assertEqual(rows[0]["precision"], "double")

    def test_a_peer_has_numbers_or_says_that_it_is_not_built_in(self):
        machine, rows = self.rows("odeint", "40x40")
        self.assertEqual({row["case"] for row in rows}, {"odeint rk4", "odeint velocity_verlet"})
        for row in rows:
            if machine["peers"]["boost"]:
                self.positive(row["ns_per_particle_step"], row["ratio_to_textbook"])
                self.assertIsNone(row["note"])
            else:
                self.assertIsNone(row["ns_per_particle_step"])
                self.assertIn("not built in", row["note"])

    def test_bullet_and_weft_are_compared_by_the_frame(self):
        machine, rows = self.rows("60 Hz", "40x40")
        rows = {row["case"]: row for row in rows}
        weft = rows["velocity-verlet at 60 Hz"]
        self.positive(weft["ms_per_frame"], weft["sag"], weft["ns_per_particle_step"])
        self.assertIsNone(weft["ratio_to_textbook"])
        if machine["peers"]["bullet"]:
            bullet = rows["bullet soft body at 60 Hz"]
            self.positive(bullet["ms_per_frame"], bullet["sag"])
            self.assertIsNone(bullet["ns_per_particle_step"])

    def test_the_hanging_sheet_sags_alike_in_weft_and_bullet(self):
        machine, rows = self.rows("hanging", "40x40")
        rows = {row["case"].removeprefix("hanging "): row for row in rows}
        self.assertEqual(set(rows), {"auto", "tr-bdf2", "implicit-euler", "bullet-deformable"})
        if not machine["peers"]["bullet"]:
            self.assertIn("not built in", rows.pop("bullet-deformable")["note"])
        for row in rows.values():
            self.positive(row["ms_per_frame"], row["sag"])
            self.assertAlmostEqual(row["sag"], rows["auto"]["sag"], delta=2e-5)

    def test_implicit_frames(self):
        _, rows = self.rows("implicit", "41x41")
        rows = {row["case"].removeprefix("implicit frame "): row for row in rows}
        self.assertEqual(set(rows), {"multigrid", "aggregation", "jacobi", "cholesky",
                                     "projective-dynamics"})
        for name, row in rows.items():
            self.assertEqual((row["columns"], row["precision"], row["threads"], row["note"]),
                             (41, "double", 1, None))
            near = row["to_1_mm"]
            self.positive(near["ms"], near["ratio_to_cholesky"], near["ns_per_particle"],
                          near["explicit_steps"])
            self.assertAlmostEqual(near["ns_per_particle"], 1e6 * near["ms"] / 41 ** 2)
            self.assertGreaterEqual(near["iterations"], 1)
            self.assertIn("to_0.1_mm", row)
        for name in ("multigrid", "cholesky"):
            self.assertGreaterEqual(rows[name]["to_0.1_mm"]["ms"], rows[name]["to_1_mm"]["ms"])
        self.assertEqual(rows["cholesky"]["to_1_mm"]["ratio_to_cholesky"], 1.0)

    def test_motion(self):
        _, rows = self.rows("motion", "33x33", "tr-bdf2")
        self.assertEqual([row["case"] for row in rows],
                         ["motion tr-bdf2 1", "motion tr-bdf2 2", "motion tr-bdf2 4"])
        for row in rows:
            self.positive(row["rms_error"], row["ms_per_frame"], row["kinetic_energy"])
            self.assertLess(abs(row["energy_change"]), row["kinetic_energy"])
            self.assertIsNone(row["note"])
        self.assertEqual([row["steps_per_frame"] for row in rows], [1.0, 2.0, 4.0])
        self.assertLess(rows[2]["rms_error"], rows[0]["rms_error"])

    def test_studies_have_tables_of_their_own(self):
        done = self.weft("bench", "--quick", "--filter", "implicit multigrid 41x41")
        self.assertRegex(done.stdout, r"(?m)^implicit frame multigrid +41x41( +[\d.]+){10}$")
        done = self.weft("bench", "--quick", "--filter", "motion baraff-witkin")
        self.assertRegex(done.stdout, r"(?m)^motion baraff-witkin 1 +33x33 +1.0 +[\d.]+ +[+-][\d.]+ ")
        self.assertNotIn("GFLOP/s of peak", done.stdout)
        self.assertEqual(done.stderr, "")

    def test_the_table_has_a_line_a_row(self):
        done = self.weft("bench", "--quick", "--filter", "rk4 40x40 double 1 thread")
        lines = done.stdout.splitlines()
        self.assertIn("GFLOP/s", lines[1])
        rows = [line for line in lines if re.match(r"(odeint )?rk4 +40x40 double +1 ", line)]
        self.assertEqual(len(rows), 2, done.stdout)
        self.assertRegex(rows[0], r"\Ark4 +40x40 double +1( +[\d.]+){4}\Z")
        self.assertEqual(done.stderr, "")  # progress is for terminals

    def test_help(self):
        self.assertIn("bench", self.weft("--help").stdout)
        text = self.weft("bench", "--help").stdout
        for option in ("--json", "--quick", "--large", "--filter", "--repeats", "--output"):
            self.assertIn(option, text)

    def test_repeats(self):
        self.rows("textbook", "40x40", more=("--repeats", 3))


class PlotTest(CommandTest):
    QUICK = ("bench", "--quick", "--filter", "symplectic-euler 1 thread 40x40")

    def test_svg_and_png(self):
        self.weft(*self.QUICK, "-o", "cost.svg")
        text = (self.place / "cost.svg").read_text()
        self.assertIn("<svg", text)
        self.assertIn("symplectic-euler, single", text)
        self.weft(*self.QUICK, "-o", "cost.png", "--json")
        self.assertEqual((self.place / "cost.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(self.listing(), ["cost.png", "cost.svg"])

    def test_a_file_that_cannot_be_written(self):
        for place in ("nowhere/cost.svg", "/proc/cost.svg"):
            done = self.weft(*self.QUICK, "-o", place, expect=3)
            self.assertRegex(self.error_line(done), rf"\Aweft: {place}: cannot write: ")
            self.assertEqual(done.stdout, "")  # it is refused before anything is timed
        self.assertEqual(self.listing(), [])

    def test_without_gnuplot(self):
        done = self.weft(*self.QUICK, "-o", "cost.svg", expect=3,
                         env={**os.environ, "PATH": str(self.place)})
        self.assertRegex(self.error_line(done), r"cost.svg: needs the program gnuplot")
        self.assertEqual(self.listing(), [])

    def test_a_gnuplot_that_fails(self):
        gnuplot = self.place / "gnuplot"
        gnuplot.write_text("#!/bin/sh\nread first\ncase $first in exit) exit 0;; esac\n"
                           "echo 'no terminal' >&2\nexit 1\n")
        gnuplot.chmod(0o755)
        done = self.weft(*self.QUICK, "-o", "cost.svg", "--json", expect=3,
                         env={**os.environ, "PATH": f"{self.place}:/usr/bin:/bin"})
        self.assertRegex(self.error_line(done), r"cost.svg: gnuplot failed")
        self.assertIn("no terminal", done.stderr)
        self.assertEqual(self.listing(), ["gnuplot"])


class RefusalTest(CommandTest):
    def refused(self, *arguments, says):
        done = self.weft("bench", *arguments, expect=2)
        self.assertRegex(self.error_line(done), says)
        self.assertEqual(done.stdout, "")

    def test_wrong_command_lines(self):
        self.refused("--filter", "rk5", says=r'--filter "rk5": no case has all of these words')
        self.refused("-o", "cost.pdf", says=r"cost.pdf: .*\.svg or \.png")
        self.refused("--repeats", "0", says=r"--repeats.*1 to 1000")
        self.refused("--quick", "--large", says=r"--quick excludes --large")

    def test_ctrl_c_ends_it_with_nothing_written(self):
        process = subprocess.Popen([COMMAND, "bench", "-o", "cost.svg"], cwd=self.place, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        watchdog = threading.Timer(60, process.kill)
        watchdog.start()
        self.addCleanup(watchdog.cancel)
        for line in process.stdout:
            if line.startswith("forward-euler"):
                break
        process.send_signal(signal.SIGINT)
        said = process.communicate()[1]
        self.assertEqual((process.returncode, said), (130, ""))
        self.assertEqual(self.listing(), [])


if __name__ == "__main__":
    unittest.main()
