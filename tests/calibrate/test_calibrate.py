"""clod calibrate as a user meets it: runs of a known truth, interruption, failures, refusals."""

import datetime
import json
import math
import os
import re
import signal
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "report"))
import bounce
import clod
import pages
from bounce import A, B, BEFORE, CASE, GRAINS, PLAN, RESULTS, TRUTH


class Calibrate(bounce.Bounce):

    # ---- what comes out

    def test_truth_is_found_and_its_card_can_be_included(self):
        before = datetime.datetime.now(datetime.timezone.utc)
        told = self.calibrate(PLAN, "-o", "out").stdout
        found = self.found()
        e = found["parameters"]["e"]
        self.assertLess(abs(e["mean"] - TRUTH), 0.03)
        self.assertLess(e["low"], TRUTH)
        self.assertGreater(e["high"], TRUTH)
        self.assertEqual((found["points"], found["designed_points"], found["failed_runs"]), (9, 6, 0))
        self.assertEqual(e["identified"], "yes")
        self.assertGreater(found["p_value"], 0.05)
        self.assertIn(f"{e['mean']:.4g}", told)
        for target in found["targets"]:  # one parameter: the draws of its surrogates are nearly independent
            self.assertEqual(target["surrogate"]["draws"], 64)
            self.assertTrue(32 < target["surrogate"]["independent_draws"] <= 64)
        with open(self.path("out/report.txt")) as file:
            self.assertEqual(file.read(), told)
        self.check_rows()
        self.check_card(e["mean"])
        self.check_page(e)
        self.check_version_and_time(before)

    def check_version_and_time(self, before):
        """Of the clod that was called, and between the moments before and behind the call; the page has them,
        whatever the time of the file is."""
        found = self.found()
        self.assertEqual(found["version"], clod.run("--version").stdout.split("\n")[0])
        written = datetime.datetime.fromisoformat(found["written"].replace("Z", "+00:00"))
        shortly = datetime.timedelta(milliseconds=1)  # the text is cut to milliseconds
        self.assertTrue(before - shortly <= written <= datetime.datetime.now(datetime.timezone.utc))
        os.utime(self.path("out/calibration.json"), (0, 0))
        self.assertEqual(clod.run("report", "out", cwd=self.folder).returncode, 0)
        page = pages.load(self.path("out/report.html"))
        self.assertEqual(page.row("calibrated by")[1], found["version"])
        self.assertEqual(page.row("calibration.json written")[1], written.strftime("%Y-%m-%d %H:%M UTC"))

    def check_rows(self):
        """Every run by itself: the energy of its own restitution, but for the scatter of 12 masses."""
        rows = self.rows()
        self.assertEqual(len(rows), 18)
        left = [name for _, _, names in os.walk(self.path("out/runs")) for name in names]
        self.assertEqual(left.count("summary.json"), 18)
        self.assertEqual([name for name in left if name.startswith("report") and name != "report.txt"], [])  # no pages
        self.assertEqual([row["seed"] for row in rows], [str(k + 1) for k in range(18)])
        spread = 3.0 * (B - A) / math.sqrt(12.0) / (0.5 * (A + B)) / math.sqrt(GRAINS)
        for row in rows:
            expected = BEFORE * float(row["e [1]"])**2
            self.assertLess(abs(float(row["bounce: kinetic_energy_J [J]"]) / expected - 1.0),
                            4.0 * spread)
        # the points that were added lie where the answer is
        for row in rows[12:]:
            self.assertLess(abs(float(row["e [1]"]) - TRUTH), 0.15)

    def check_page(self, e):
        """Numbers of the page are those of the files, and its figure has every run."""
        self.assertEqual(clod.run("report", "out", cwd=self.folder).returncode, 0)
        page = pages.load(self.path("out/report.html"))
        self.assertAlmostEqual(float(page.row("e")[1]), e["mean"], delta=0.051 * (e["high"] - e["low"]))  # two digits of half the interval
        self.assertIn(f'<td title="{e["mean"]!r}">', page.text)
        figure = page.figures["target"]
        self.assertEqual(figure["title"], "bounce: kinetic_energy_J over e")
        points = [curve for curve in figure["curves"] if curve["name"] == "runs"][0]
        rows = self.rows()
        self.assertEqual([float(x) for x in points["x"]], [float(row["e [1]"]) for row in rows])
        self.assertEqual([float(y) for y in points["y"]],
                         [float(row["bounce: kinetic_energy_J [J]"]) for row in rows])
        self.assertTrue(os.path.exists(self.path("out/report-target.svg")))
        self.check_page_of_another_version()

    def check_page_of_another_version(self):
        """Without names of targets it is refused, not drawn without them."""
        other = self.found()
        del other["targets"][0]["name"]
        os.mkdir(self.path("other"))
        self.write("other/calibration.json", json.dumps(other))
        done = clod.run("report", "other", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("other/calibration.json: target 1 has no name, so another version of clod wrote it",
                      done.stderr)

    def check_card(self, mean):
        with open(CASE) as file:
            text = file.read()
        self.write("again.yaml", "include: out/card.yaml\n" + text.replace("restitution: 0.5, ", ""))
        done = clod.run("run", "again.yaml", "-o", "again", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("again/case-complete.yaml")) as file:
            self.assertIn(f"restitution: {mean:.4g}", file.read())

    def test_target_out_of_reach_identifies_nothing(self):
        """No restitution gives 6e-4 J, and no stiffness changes the energy: its samples lie where the surrogate is least sure.

        Nine points of two parameters make lines, which is said."""
        text = PLAN.replace("to: 0.9}\n", "to: 0.9}\n  k: {key: contacts.default.k1, from: 5e4 N/m, to: 2e5 N/m, scale: log}\n")
        text = re.sub("value: [^,]*, error: 4e-6", "value: 6e-4, error: 4e-6", text)
        told = self.calibrate(text, "-o", "out").stdout
        found = self.found()
        self.assertLess(found["p_value"], 1e-6)
        self.assertFalse(found["chains_apart"])
        for name in "ek":
            self.assertEqual(found["parameters"][name]["identified"], "missed")
        self.assertIn("and tell no parameter", " ".join(told.split()))
        self.assertIn("These targets do not tell k: over its range none changes", " ".join(told.split()))
        self.assertIn("has a linear surrogate, of 9 points: how else results may bend", " ".join(told.split()))
        self.assertIn("From 10 points on it is a Gaussian process.", " ".join(told.split()))
        self.assertNotIn("k wants to go beyond", told)
        self.assertIn("e wants to go beyond the upper end", told)
        with open(self.path("out/card.yaml")) as file:
            self.assertEqual(file.read().count("; not identified: the targets are missed\n"), 2)
        self.assertEqual(clod.run("report", "out", cwd=self.folder).returncode, 0)
        page = pages.load(self.path("out/report.html"))
        self.assertIn("missed", page.row("k [N/m]"))
        self.assertNotIn("identified: yes", page.text)

    @clod.quick_only
    def test_interrupted_it_goes_on_to_the_same_results(self):
        self.calibrate(PLAN, "-o", "whole", "-j", "2")
        for number, code in ((signal.SIGTERM, 143), (signal.SIGKILL, -signal.SIGKILL)):
            with self.subTest(signal=number):
                self.interrupt(f"part-{int(number)}", number, code)

    def interrupt(self, folder, number, code):
        """Stop it after some runs; the same command does only what is missing, to the same bytes."""
        process = clod.start("calibrate", self.path("plan.yaml"), "-o", self.path(folder), "-j", "2")
        clod.wait_until(lambda: self.ended("p003-1", folder), process)
        process.send_signal(number)
        told = process.communicate()[1]
        self.assertEqual(process.returncode, code, told)
        if number == signal.SIGTERM:
            self.assertIn("the same command goes on", told)
        self.assertFalse(os.path.exists(self.path(folder, "calibration.json")))
        kept = {name: os.stat(self.path(folder, "runs", name)).st_mtime_ns
                for name in os.listdir(self.path(folder, "runs"))
                if name.endswith("-bounce.json") and self.ended(name[:6], folder)}
        self.assertGreater(len(kept), 3)
        self.calibrate(PLAN, "-o", folder, "-j", "1")
        for name, time in kept.items():
            self.assertEqual(os.stat(self.path(folder, "runs", name)).st_mtime_ns, time, name)
        for name in RESULTS:
            self.assertTrue(self.result(name, "whole") == self.result(name, folder), name)

    def test_target_held_back_is_added_and_nothing_is_run_again(self):
        self.calibrate(PLAN, "-o", "out")
        before = os.stat(self.path("out/runs/p008-2-bounce.json")).st_mtime_ns
        other = PLAN.replace("error: 4e-6}", "error: 4e-6}\n  - {test: bounce, number: grains, value: 13, "
                             "error: 0.1, held_back: true}")
        told = self.calibrate(other, "-o", "out")
        self.assertNotIn("done after", told.stderr)
        self.assertEqual(os.stat(self.path("out/runs/p008-2-bounce.json")).st_mtime_ns, before)
        held = self.found()["targets"][1]
        self.assertTrue(held["held_back"])
        self.assertIn("held back, predicted\n", told.stdout)
        self.assertIn("bounce: grains was held back and is missed: measured 13, predicted 11.",
                      " ".join(told.stdout.split()))

    def test_runs_that_fail_are_told_and_not_used(self):
        plan = PLAN.replace("key: contacts.default.restitution, from: 0.2, to: 0.9",
                            "key: contacts.default.k1, from: 1e0 N/m, to: 1e8 N/m, scale: log")
        plan = plan.replace("seeds: 2", "seeds: 1").replace("points: 9", "points: 11").replace(
            "kinetic_energy_J", "time_s").replace("error: 4e-6", "error: 1e-4")
        told = self.calibrate(plan, "-o", "out")
        failed = [row for row in self.rows() if row["failed"] != ""]
        self.assertEqual(len(failed), self.found()["failed_runs"])
        self.assertGreater(len(failed), 0)
        for row in failed:
            self.assertLess(float(row["e [N/m]"]), 1e4)
            self.assertIn("overlap", row["failed"])
            self.assertEqual(row["bounce: time_s [s]"], "")
        self.assertIn(f"{len(failed)} run", told.stdout)
        self.assertIn("runs.csv has the reasons", told.stdout)
        self.assertIn(f"only {11 - len(failed)} of 11 runs have this number", " ".join(told.stdout.split()))

    @clod.quick_only
    def test_target_out_of_reach_is_told(self):
        plan = PLAN.replace(f"value: {BEFORE * TRUTH**2:.6g}", f"value: {BEFORE * 1.3:.6g}")
        told = self.calibrate(plan.replace("points: 9", "points: 6"), "-o", "out").stdout
        told = " ".join(told.split())
        self.assertLess(self.found()["p_value"], 0.05)
        self.assertIn("The targets contradict each other, or the model cannot reach them", told)
        self.assertIn("e wants to go beyond the upper end of its range", told)

    def test_check_estimates_points_and_warns_of_a_small_budget(self):
        told = self.calibrate(PLAN, "--check", "-j", "2").stderr
        self.assertRegex(told, "a point takes [0-9.e-]+ s with 2 runs side by side, and 9 points")
        refused = self.calibrate(PLAN.replace("points: 9", "budget: 1 us"), "--check", "-j", "1", code=2)
        self.assertIn("plan.yaml: the budget of 1e-06 s looks too small", refused.stderr)
        self.assertIn("so 0 fit, and 1 parameter needs at least 5", refused.stderr)
        self.assertEqual(refused.stdout, "")
        told = self.calibrate(PLAN.replace("points: 9", "budget: 1 d"), "--check").stderr
        self.assertRegex(told, r"a budget buys 256 points at most, which take [0-9.]+ s of its 24 h 00 min\. More seeds")
        told = self.calibrate(PLAN.replace("points: 9", "budget: 48 h"), "--check").stderr
        self.assertIn("of its 2.0 days", told)
        told = self.calibrate(PLAN.replace("points: 9", "budget: 25 min"), "--check").stderr
        self.assertIn("of its 25 min", told)
        self.assertNotIn("too small", told)
        self.assertFalse(os.path.exists(self.path("run")))

    def test_budget_that_is_too_small_says_how_many_fit_and_can_be_raised(self):
        small = PLAN.replace("points: 9", "budget: 1 ms")
        done = self.calibrate(small, "-o", "out", code=2)
        self.assertIn("the budget of", done.stderr)
        self.assertIn("is too small: the first point, 2 packings of each test, took", done.stderr)
        self.assertIn("so 0 points fit, and 1 parameter needs at least 5", done.stderr)
        # 40 s over two processes: 20 s a point, so 6 fit into 125 s; a third of them are added later
        self.change_row("p000-1", seconds=30.0)
        self.change_row("p000-2", seconds=10.0)
        done = self.calibrate(PLAN.replace("points: 9", "budget: 125 s"), "-o", "out", "-j", "2")
        self.assertIn("6 points fit into 125 s", done.stderr)
        self.assertEqual(self.found()["points"], 6)
        self.assertEqual(self.row("p000-1")["seconds"], 30.0)

    # ---- what is refused

    def refuse(self, *changes, words, files=()):
        text = PLAN
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        for name, content in files:
            self.write(name, content)
        done = self.calibrate(text, "--check", code=2)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(os.path.exists(self.path("run")))

    def test_wrong_plans_are_refused_with_their_places(self):
        self.assertIn("in order", self.calibrate(PLAN, "--check").stdout)
        self.refuse(("points: 9", "budget: 25"), words=["budget: 25 needs a unit of time, for instance 25 h\n"])
        self.refuse(("test: bounce", "test: bonce"),
                    words=["plan.yaml:9:12: targets.0.test: there is no test bonce; did you mean bounce?",
                           "            ^~~~~"])
        self.refuse(("to: 0.9", "to: 1.9"),
                    words=["plan.yaml:7:57: parameters.e.to: test bounce refuses it",
                           "restitution=1.9: contacts.default.restitution: 1.9 is out of range"])
        self.refuse(("contacts.default.restitution", "contacts.default.restitutio"),
                    words=["did you mean restitution?"])
        self.refuse(("to: 0.9", "to: 0.1"), words=["0.1 is not above from, 0.2"])
        self.refuse(("from: 0.2", "from: 20 %"), words=['has the unit "", but from has "%"'])
        self.refuse(("from: 0.2", "from: 0"), ("to: 0.9", "to: 0.9, scale: log"),
                    words=["a log scale begins above 0"])
        self.refuse(("points: 9", "points: 5\nbudget: 2 h"), words=["has a budget beside it"])
        self.refuse(("points: 9\n", ""), words=["needs the key budget, for instance budget: 2 h"])
        self.refuse(("error: 4e-6", "error: 0"), words=["0 is not above 0"])
        self.refuse((", error: 4e-6", ""), words=["needs the key error"])
        self.refuse(("error: 4e-6", "error: 4e-6, held_back: true"), words=["all held back"])
        self.refuse(("case: bounce.yaml", "case: none.yaml"), words=["none.yaml: cannot be opened"])

    def test_wrong_targets_of_shear_and_uniaxial_tests(self):
        ring = ("bounce.yaml", clod.source("cases/calibrate-kadh/ring.yaml"))
        key = ("contacts.default.restitution", "contacts.default.rolling_friction")
        target = f"number: kinetic_energy_J, value: {BEFORE * TRUTH**2:.6g}, error: 4e-6"

        def shear(new, *words, files=()):
            self.refuse(ring, key, (target, new), words=words, files=files)

        shear("number: phie, value: 40 deg, error: 1 deg", "has no number phie; did you mean phi_e?")
        shear("number: phi_x, value: 20 deg, error: 1 deg", "has no number phi_x, which is one of a wall friction test; it has phi_lin,")
        shear("number: repose.heap.angle_deg, value: 34 deg, error: 1 deg", "has no number repose.heap.angle_deg, which is one of a free run; it has")
        shear("number: xyzxyz, value: 40 deg, error: 1 deg", "it has phi_lin, phi_e, phi_sf, c, tau_p")
        shear("number: phi_e, value: 95 deg, error: 1 deg",
              "95 deg is impossible; allowed is 1 to 85 deg: check its unit")
        shear("number: phi_lin, value: 80.1 deg, error: 1 deg",  # as clod locus
              "80.1 deg is impossible; allowed is 1 to 80 deg")
        shear("number: phi_sf, value: 0.9 deg, error: 1 deg",
              "0.9 deg is impossible; allowed is 1 to 80 deg")
        shear("number: phi_e, value: 40 kPa, error: 1 deg", "targets.0.value: 40 kPa")
        shear("number: rho_b, value: 1.4 kg/m3, error: 0.1 kg/m3", "impossible")
        shear("number: phi_e, value: 40 deg, error: 2 rad",
              "targets.0.error: 2 rad is more than all that is possible, 1 to 85 deg")
        shear("number: tau, value: 9 kPa, error: 1 kPa", "tau needs the key normal_stress")
        shear("number: tau, value: 9 kPa, error: 1 kPa, normal_stress: 60 kPa",
              "60 kPa is outside the shear_stresses of test bounce")
        shear("number: phi_e, value: 9 deg, error: 1 deg, normal_stress: 60 kPa", "phi_e has none")
        shear("number: phi_e, value: 30 deg, error: 1 deg}\n  - {test: bounce, number: phi_lin, value: 40 "
              "deg, error: 1 deg", "no solid has all of this", "phi_e 30 deg in targets.0 (nearest 35, 5.0 errors away)")
        shear("number: c, value: 3 kPa, error: 0.1 kPa}\n  - {test: bounce, number: c, value: 4 kPa, "
              "error: 0.1 kPa", "bounce: c is there as 3 kPa in targets.0 and as 4 kPa in targets.1, 7.1 standard errors apart")
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
        points = "54.8,40,{0},20\n54.8,40,30,30\n54.8,40,40,35\n"
        shear("locus: lab.csv, error: 1 kPa", "5 kPa is outside the shear_stresses",
              files=[("lab.csv", head + points.format(5))])
        shear("locus: lab.csv", "the table has no tau_sh_error at 12 kPa",
              files=[("lab.csv", head + points.format(12))])
        shear("locus: lab.csv, error: 1 kPa",
              "no points with the preshear stress of test bounce, 54.8 kPa; it has 60 kPa: give the case one",
              files=[("lab.csv", head + points.format(12).replace("54.8", "60"))])
        uniaxial = ("bounce.yaml", clod.source("cases/copper-ore-uniaxial/case.yaml"))
        self.refuse(uniaxial, key, (target, "number: sigma_c, normal_stress: 30 kPa, value: 9 kPa, "
                                            "error: 1 kPa"),
                    words=["30 kPa is not among the consolidation_stresses"])

    def test_table_in_a_wrong_unit_is_told_before_anything_runs(self):
        """Shear stresses a hundred times too small, as of a column in bar with kPa above it."""
        table = ("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
                 "54.8,0.4,12,0.2\n54.8,0.4,30,0.3\n54.8,0.4,40,0.35\n")
        with open(self.path("lab.csv"), "w") as file:
            file.write(table)
        plan = PLAN.replace("bounce.yaml", clod.source("cases/calibrate-kadh/ring.yaml"))
        plan = plan.replace("contacts.default.restitution", "contacts.default.rolling_friction")
        target = f"number: kinetic_energy_J, value: {BEFORE * TRUTH**2:.6g}, error: 4e-6"
        plan = plan.replace(target, "locus: lab.csv, error: 1 kPa")
        said = self.calibrate(plan, "--check", code=2).stderr  # preshear: atan(0.4/54.8)
        self.assertRegex(said, r"lab\.csv:2, 3, 4: the yield locus at .* has phi_sf = 0\.42 deg; it must be 1 to 80 deg")
        # ten times too small: unusual, and no more than warned of. atan(1.5/28), as the points rise
        with open(self.path("lab.csv"), "w") as file:
            file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
                       "54.8,4,12,2\n54.8,4,30,3\n54.8,4,40,3.5\n")
        done = self.calibrate(plan, "--check")
        self.assertRegex(done.stderr, r"WARNING: .*lab\.csv: phi_lin = 3\.\d* deg is outside 5 to 65 deg; "
                                      "check the columns and units")
        self.assertIn("in order", done.stdout)

    def test_number_that_no_run_has_is_told_after_the_first_point(self):
        """No grain leaves, and so there is no residence time."""
        with open(self.path("bounce.yaml")) as file:
            case = file.read()
        self.write("bounce.yaml", case.replace("200 mm]}", "200 mm], open: delete}"))
        done = self.calibrate(PLAN.replace("error: 4e-6}", "error: 4e-6}\n  - {test: bounce, number: residence.p50_s, value: 1 s, "
                                           "error: 1 s, held_back: true}"), "-o", "out")
        self.assertIn("bounce: residence.p50_s is not defined in the middle of all ranges, in p000-1-bounce; if so few points have it "
                      "that it gets no surrogate, it is not predicted\n", done.stderr)
        self.assertEqual(done.stderr.count("is not defined"), 1, done.stderr)
        self.assertEqual(self.rows()[0]["bounce: residence.p50_s [s]"], "")
        self.assertIsNone(self.found()["targets"][1]["model"])

    def test_folder_of_another_plan_is_refused(self):
        self.calibrate(PLAN, "-o", "out")
        # title, clod and seed are above the parameter
        words = ("out has runs of another plan: line 4 of its design.txt is \"parameter contacts.default.restitution "
                 "0.20000000000000001 0.90000000000000002  linear\", and that of this plan \"parameter "
                 "contacts.default.restitution 0.20000000000000001 0.80000000000000004  linear\".")
        other = PLAN.replace("to: 0.9", "to: 0.8")
        self.assertIn(words, self.calibrate(other, "-o", "out", code=2).stderr)
        checked = self.calibrate(other, "-o", "out", "--check", code=2)
        self.assertIn(words, checked.stderr)
        self.assertNotIn("in order", checked.stdout)

        seeds = self.calibrate(PLAN.replace("seeds: 2", "seeds: 3"), "-o", "out", code=2).stderr
        self.assertIn("line 3 of its design.txt is \"seed 1, seeds 2\", and that of this plan \"seed 1, seeds 3\".", seeds)
        with open(self.path("bounce.yaml")) as file:
            case = file.read()
        self.write("bounce.yaml", case.replace("count: 12", "count: 11"))
        grains = self.calibrate(PLAN, "-o", "out", "--check", code=2).stderr
        self.assertRegex(grains, r"line \d+ of its design.txt is \"count: 12\", and that of this plan \"count: 11\"\.")
        self.write("bounce.yaml", case)

        # the same command, and other targets and points
        self.assertIn("in order", self.calibrate(PLAN, "-o", "out", "--check").stdout)
        same = PLAN.replace("points: 9", "points: 12").replace("error: 4e-6", "error: 8e-6")
        self.assertIn("in order", self.calibrate(same, "-o", "out", "--check").stdout)
        os.makedirs(self.path("empty"))
        self.assertIn("in order", self.calibrate(PLAN, "-o", "empty", "--check").stdout)
        self.assertEqual(os.listdir(self.path("empty")), [])

    @clod.quick_only
    def test_set_changes_keys_as_an_edit_of_the_plan_does(self):
        """The bytes are those of the edited plan; other ranges need another folder, other errors do not."""
        short = PLAN.replace("points: 9", "points: 6").replace("error: 4e-6", "error: 8e-6")
        self.calibrate(short, "-o", "edited")
        settings = ["--set", "points=6", "-S", "targets.0.error=8e-6"]
        self.calibrate(PLAN, "-o", "out", *settings)
        for name in RESULTS:
            self.assertEqual(self.result(name), self.result(name, "edited"), name)
        text = clod.read(self.path("out/plan.yaml")).decode()
        self.assertEqual(text, "# --set points=6\n# --set targets.0.error=8e-6\n" + PLAN)

        before = self.row("p000-1")
        done = self.calibrate(PLAN, "-o", "out", *settings, "--set", "parameters.e.to=0.8", code=2)
        self.assertIn("out has runs of another plan", done.stderr)
        self.calibrate(PLAN, "-o", "out", "--set", "points=6")
        self.assertEqual(self.row("p000-1"), before)
        width = {folder: self.found(folder)["parameters"]["e"] for folder in ("out", "edited")}
        self.assertLess(width["out"]["high"] - width["out"]["low"], width["edited"]["high"] - width["edited"]["low"])

        done = self.calibrate(PLAN, "--check", "--set", "targets.1.error=8e-6", code=2)
        self.assertIn("--set targets.1.error=8e-6: the list has no element \"1\"; it has 1, counted from 0", done.stderr)
        done = self.calibrate(PLAN, "--check", "--set", "targets.0.test=bonce", code=2)
        self.assertIn("--set targets.0.test=bonce: targets.0.test: there is no test bonce; did you mean bounce?", done.stderr)

    def test_case_that_fails_in_the_middle_ends_it(self):
        with open(CASE) as file:
            text = file.read()
        self.write("bounce.yaml", text.replace("k1: 1e5", "k1: 1e1"))
        done = self.calibrate(PLAN, "-o", "out", code=1)
        self.assertIn("Test bounce fails in the middle of all ranges", done.stderr)

    def test_template_is_in_order(self):
        self.assertEqual(clod.run("new", "calibrate", cwd=self.folder).returncode, 0)
        done = clod.run("calibrate", "calibrate.yaml", "--check", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        wrong = clod.run("run", "calibrate.yaml", cwd=self.folder)
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("clod calibrate reads it", wrong.stderr)
        wrong = clod.run("calibrate", "bounce.yaml", cwd=self.folder)
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("clod run reads it", wrong.stderr)


if __name__ == "__main__":
    clod.unittest.main()
