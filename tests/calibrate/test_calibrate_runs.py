"""Runs of clod calibrate: each of its own place, of one case, counted once, and told when it goes wrong."""

import fcntl
import json
import os
import shutil
import signal
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import bounce
import clod
from bounce import BEFORE, PLAN, RESULTS, TRUTH

ENERGY = "bounce: kinetic_energy_J [J]"
SHORT = PLAN.replace("points: 9", "points: 5").replace("seeds: 2", "seeds: 1")
INTERRUPTED = 128 + signal.SIGTERM


class Runs(bounce.Bounce):

    def begin(self, text, *arguments, **more):
        """Start it and return at once."""
        self.write("plan.yaml", text)
        process = subprocess.Popen([clod.BINARY, "calibrate", "plan.yaml", "-o", "out", *arguments],
                                   cwd=self.folder, text=True, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, **more)
        self.addCleanup(process.wait)
        return process

    def wait_for(self, run, process):
        self.assertTrue(clod.wait_until(lambda: self.ended(run), process, 100), "it ended before")

    def end(self, process, code):
        told = process.communicate(timeout=100)[1]
        self.assertEqual(process.returncode, code, told)
        return told

    # ---- each of its own place

    def test_rows_are_of_their_own_places_when_targets_and_points_change(self):
        far = PLAN.replace(f"{BEFORE * TRUTH**2:.6g}", f"{BEFORE * 0.85**2:.6g}")
        moved = set()
        for text in (PLAN, far.replace("points: 9", "points: 6"), PLAN.replace("points: 9", "points: 12")):
            self.calibrate(text, "-o", "out")
            for row in self.rows():
                run = f"p{int(row['point']):03d}-{row['packing']}"
                self.assertAlmostEqual(float(row["e [1]"]), self.restitution_run(run), 8)
                with open(self.path(f"out/runs/{run}-bounce/summary.json")) as file:
                    self.assertAlmostEqual(float(row[ENERGY]), json.load(file)["kinetic_energy_J"], 12)
                if run == "p005-1":
                    moved.add(row["e [1]"])
        self.assertGreater(len(moved), 1)

    def test_copies_of_a_test_have_other_packings(self):
        """Grains of other masses, so other energies; those of the first are as without the copy. And a run that an older clod
        made with the seed of the first is done again."""
        copies = SHORT.replace("tests:\n", "tests:\n  twin: {case: bounce.yaml}\n").replace(
            "targets:\n", "targets:\n  - {test: twin, number: kinetic_energy_J, value: 1e-4, error: 1e-6}\n")
        self.calibrate(SHORT, "-o", "alone")
        self.calibrate(copies, "-o", "out")
        rows = self.rows()
        self.assertEqual([row["twin: seed"] for row in rows], [row["seed"] for row in self.rows("alone")])
        self.assertEqual([int(row["bounce: seed"]) for row in rows], [1000000001 + k for k in range(5)])
        self.assertEqual(rows[0]["e [1]"], "0.55")
        self.assertEqual(rows[0]["twin: kinetic_energy_J [J]"], self.rows("alone")[0][ENERGY])
        for row in rows:
            self.assertNotEqual(row["twin: kinetic_energy_J [J]"], row[ENERGY])
        before = self.row("p000-1")
        self.change_row("p000-1", settings=before["settings"].replace("seed=1000000001;", "seed=1;"), seconds=1e4)
        self.calibrate(copies, "-o", "out")
        self.assertEqual(self.row("p000-1")["settings"], before["settings"])
        self.assertLess(self.row("p000-1")["seconds"], 1e3)
        self.assertEqual(self.rows(), rows)

    def test_finished_run_keeps_its_results_and_nothing_that_shows_or_continues_it(self):
        self.calibrate(SHORT, "-o", "out")
        self.assertEqual(sorted(os.listdir(self.path("out/runs/p000-1-bounce"))),
                         [".clod-lock", "case-complete.yaml", "case.yaml", "log.jsonl", "report.txt", "series.csv",
                          "summary.json"])

    def test_half_done_folder_of_another_place_begins_anew(self):
        self.calibrate(SHORT, "-o", "whole")
        other = ("run", "bounce.yaml", "-t", "1", "--set", "contacts.default.restitution=0.3", "-o")
        self.assertEqual(clod.run(*other, "out/runs/p002-1-bounce", cwd=self.folder).returncode, 0)
        self.calibrate(SHORT, "-o", "out")
        for name in RESULTS:
            self.assertEqual(self.result(name, "whole"), self.result(name), name)

    def test_run_that_is_refused_ends_the_calibration(self):
        self.calibrate(SHORT, "-o", "out")
        shutil.rmtree(self.path("out/runs/p002-1-bounce"))
        other = ("run", "bounce.yaml", "-t", "1", "--set", "contacts.default.restitution=0.3", "-o")
        self.assertEqual(clod.run(*other, "out/runs/p002-1-bounce", cwd=self.folder).returncode, 0)
        self.change_row("p002-1", state="begun")
        done = self.calibrate(SHORT, "-o", "out", code=2)
        self.assertIn("clod run refuses out/runs/p002-1-bounce", done.stderr)
        self.assertIn("has changed", done.stderr)
        self.assertEqual(self.row("p002-1")["state"], "begun")

    # ---- of one case

    def test_case_and_its_included_file_that_change_end_the_calibration(self):
        text = clod.read(self.path("bounce.yaml")).decode()
        self.write("bounce.yaml", "include: part.yaml\n" + text.replace("    count: 12\n", ""))
        self.write("part.yaml", "grains: {0: {count: 12}}\n")
        self.calibrate(PLAN, "-o", "whole")
        for name, old, new in (("bounce.yaml", "max: 2.2 mm", "max: 2.1 mm"),
                               ("part.yaml", "12", "6")):
            with self.subTest(name=name):
                shutil.rmtree(self.path("out"), ignore_errors=True)
                before = clod.read(self.path(name)).decode()
                process = self.begin(PLAN, "-j", "1")
                self.wait_for("p001-1", process)
                self.write(name, before.replace(old, new))
                told = self.end(process, 2)
                self.assertIn("or a file that it names, has changed since the calibration began", told)
                told = self.calibrate(PLAN, "-o", "out", code=2).stderr
                self.assertIn("out has runs of another plan", told)
                self.write(name, before)
                self.calibrate(PLAN, "-o", "out")
                for result in RESULTS:
                    self.assertEqual(self.result(result, "whole"), self.result(result), result)

    def test_runs_of_another_clod_are_refused(self):
        self.calibrate(SHORT, "-o", "out")
        design = clod.read(self.path("out/design.txt")).decode()
        version = clod.run("--version").stdout.splitlines()[0]
        self.assertIn(f"clod {version}\n", design)
        self.write("out/design.txt", design.replace(f"clod {version}\n", "clod 0.0.1\n"))
        self.assertIn(f"line 2 of its design.txt is \"clod 0.0.1\", and that of this plan \"clod {version}\".",
                      self.calibrate(SHORT, "-o", "out", code=2).stderr)

    # ---- counted once

    def first_point(self):
        """A folder whose first point has run, and took 40 s."""
        self.calibrate(PLAN.replace("points: 9", "budget: 1 ms"), "-o", "out", code=2)
        self.change_row("p000-1", seconds=30.0)
        self.change_row("p000-2", seconds=10.0)

    def test_budget_does_not_follow_the_jobs_of_a_later_call(self):
        self.first_point()
        plan = PLAN.replace("points: 9", "budget: 125 s")
        self.calibrate(plan, "-o", "out", "-j", "2")
        before = {name: self.result(name) for name in RESULTS}
        told = self.calibrate(plan, "-o", "out", "-j", "1").stderr
        self.assertIn("6 points fit", told)
        for name, text in before.items():
            self.assertEqual(self.result(name), text, name)
        # another budget is counted anew: 40 s a point
        told = self.calibrate(plan.replace("125 s", "205 s"), "-o", "out", "-j", "1").stderr
        self.assertIn("5 points fit", told)

    def test_jobs_are_as_many_as_are_asked_for(self):
        self.first_point()
        told = self.calibrate(PLAN.replace("points: 9", "budget: 6.5 s"), "-o", "out", "-j", "40").stderr
        self.assertIn("the first point took 1 s: 6 points fit", told)

    def test_time_of_all_pieces_of_a_run_counts(self):
        self.first_point()
        row, log = (self.path("out/runs/p000-1-bounce" + ending) for ending in (".json", ".log"))
        self.change_row("p000-1", state="begun", seconds=30.0)
        os.utime(row, (1e9, 1e9))
        os.utime(log, (1e9 + 20.0, 1e9 + 20.0))  # 30 s before, and 20 s in the last piece
        self.calibrate(PLAN.replace("points: 9", "budget: 1 ms"), "-o", "out", code=2)
        self.assertEqual(self.row("p000-1")["state"], "done")
        self.assertGreaterEqual(self.row("p000-1")["seconds"], 50.0)
        self.assertLess(self.row("p000-1")["seconds"], 70.0)

    # ---- told when it goes wrong

    def test_runs_that_were_never_done_have_no_result(self):
        process = self.begin(PLAN, "-j", "1")
        self.wait_for("p001-2", process)
        process.send_signal(signal.SIGTERM)
        self.end(process, INTERRUPTED)
        rows = self.rows()
        done = [row for row in rows if row[ENERGY] != ""]
        self.assertGreaterEqual(len(done), 4)
        self.assertLess(len(done), len(rows))
        for row in rows:
            there = self.ended(f"p{int(row['point']):03d}-{row['packing']}")
            self.assertEqual(row[ENERGY] != "", there, row)
        for row in done:
            self.assertGreater(float(row[ENERGY]), 0.02 * BEFORE)

    def test_results_of_an_earlier_end_stay_when_more_is_interrupted(self):
        self.calibrate(SHORT, "-o", "out")
        before = {name: clod.read(self.path("out", name)) for name in RESULTS}
        process = self.begin(SHORT.replace("points: 5", "points: 30"), "-j", "1")
        self.wait_for("p006-1", process)
        process.send_signal(signal.SIGTERM)
        self.end(process, INTERRUPTED)
        for name, text in before.items():
            self.assertEqual(clod.read(self.path("out", name)), text, name)

    def test_caller_that_ignores_the_end_of_children(self):
        process = self.begin(SHORT, preexec_fn=lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN))
        self.addCleanup(process.kill)
        self.end(process, 0)

    def test_run_that_crashes_is_a_failed_run(self):
        text = clod.read(self.path("bounce.yaml")).decode()
        self.write("bounce.yaml", text.replace("9 ms", "150 ms"))
        process = self.begin(PLAN, "-j", "1")
        lock = self.path("out/runs/p002-1-bounce/.clod-lock")
        number = self.path("out/runs/p002-1-bounce/log.jsonl")
        self.assertTrue(clod.wait_until(lambda: os.path.exists(number), process, 100))
        with open(lock) as file:
            os.kill(int(file.read()), signal.SIGSEGV)
        self.end(process, 0)
        self.assertEqual(self.row("p002-1")["state"], "failed")
        self.assertEqual(self.found()["failed_runs"], 1)
        if not clod.SANITIZED:  # which take the signal themselves
            self.assertIn("clod crashed with signal 11", self.row("p002-1")["why"])

    def test_folder_of_someone_else_is_told_at_once(self):
        """When its turn comes, without another run begun: of those that come later there is nothing."""
        os.makedirs(self.path("out/runs/p001-1-bounce"))
        self.write("out/runs/p001-1-bounce/summary.json", "{}")
        done = self.calibrate(SHORT, "-o", "out", "-j", "1", code=2)
        self.assertIn("p001-1-bounce/summary.json is in the way", done.stderr)
        self.assertEqual(sorted(os.listdir(self.path("out/runs"))),
                         ["p000-1-bounce", "p000-1-bounce.json", "p000-1-bounce.log", "p001-1-bounce"])
        self.assertEqual(os.listdir(self.path("out/runs/p001-1-bounce")), ["summary.json"])

    def test_stop_is_heard_while_a_folder_is_in_use(self):
        os.makedirs(self.path("out/runs/p001-1-bounce"))
        with open(self.path("out/runs/p001-1-bounce/.clod-lock"), "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            calls = self.path("calls")  # on this lock
            process = self.begin(SHORT, "-j", "1", env={
                **os.environ, "LD_PRELOAD": clod.IO_FAULTS, "CLOD_FAULT_LOG": calls,
                "CLOD_FAULT_UNDER": os.path.realpath(lock.name)})
            looks = lambda: os.path.exists(calls) and clod.read(calls).count(b"flock ") > 1
            self.assertTrue(clod.wait_until(looks, process, 100), "it did not wait for the folder")
            process.send_signal(signal.SIGTERM)
            self.end(process, INTERRUPTED)  # what does not hear it is refused later: the folder stays in use

    def test_stop_is_heard_while_the_posterior_is_made(self):
        """All runs are there, and no point is added to five: behind the lock there is nothing but the fit, here
        with many samples of many targets."""
        target = SHORT[SHORT.index("  - {test"):SHORT.index("sampling")]
        self.calibrate(SHORT, "-o", "out")
        before = {name: clod.read(self.path("out", name)) for name in RESULTS}
        process = self.begin(SHORT.replace(target, 200 * target).replace("samples: 1000", "samples: 100000"))
        lock = self.path("out/.clod-lock")  # has the number of the process that holds it
        self.assertTrue(clod.wait_until(lambda: clod.read(lock).strip() == str(process.pid).encode(), process,
                                        100), "it ended before")
        process.send_signal(signal.SIGTERM)
        self.assertIn("the same command goes on", self.end(process, INTERRUPTED))
        for name, text in before.items():
            self.assertEqual(clod.read(self.path("out", name)), text, name)

    def test_damaged_rows_and_results_say_what_to_remove(self):
        self.calibrate(SHORT, "-o", "out")
        self.change_row("p001-1", state="dnoe")
        told = self.calibrate(SHORT, "-o", "out", code=2).stderr
        self.assertIn("out/runs/p001-1-bounce.json: damaged; remove it", told)
        os.remove(self.path("out/runs/p001-1-bounce.json"))
        self.write("out/runs/p002-1-bounce/summary.json", "{")
        told = self.calibrate(SHORT, "-o", "out", code=2).stderr
        self.assertIn("remove out/runs/p002-1-bounce.json and out/runs/p002-1-bounce, and the run is done again",
                      told)
        os.remove(self.path("out/runs/p002-1-bounce/summary.json"))
        told = self.calibrate(SHORT, "-o", "out", code=2).stderr
        self.assertIn("remove out/runs/p002-1-bounce.json", told)
        os.remove(self.path("out/runs/p002-1-bounce.json"))
        shutil.rmtree(self.path("out/runs/p002-1-bounce"))
        self.calibrate(SHORT, "-o", "out")


if __name__ == "__main__":
    clod.unittest.main()
