"""Plans that clod calibrate refuses before the first run, and what its results say.

The case is that of bounce.py: grains that meet a floor, whose case loads in a millisecond.
"""

import csv
import json
import math
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import bounce
import clod
from bounce import CASE

PLAN = """points: 9
tests:
  bounce: {case: bounce.yaml}
parameters:
  e: {key: contacts.default.restitution, from: 0.2, to: 0.9}
targets:
  - {test: bounce, number: kinetic_energy_J, value: 1e-4, error: 4e-6}
sampling: {samples: 1000}
"""


class Plan(bounce.Bounce):

    def refuse(self, *changes, words):
        text = PLAN
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        told = self.calibrate(text, "--check", code=2).stderr
        for word in words:
            self.assertIn(word, told)
        return told

    # ---- parameters

    def test_keys_that_are_no_parameters(self):
        ends = "key: contacts.default.restitution, from: 0.2, to: 0.9"
        self.refuse((ends, "key: grains.0.count, from: 8, to: 16"),
                    words=["plan.yaml:5:12: parameters.e.key: grains.0.count takes whole numbers only"])
        self.refuse((ends, "key: seed, from: 1, to: 9"),
                    words=["parameters.e.key: seed is no parameter: every packing gets a seed of its own"])
        self.refuse((ends, "key: title, from: 1, to: 9"),
                    words=["plan.yaml:5:12: parameters.e.key: title is no parameter: it is the name of a run"])
        told = self.refuse((ends, "key: output.snapshot_interval, from: 1 ms, to: 9 ms"),
                           words=["plan.yaml:5:12: parameters.e.key: keys below output are no parameters"])
        self.assertEqual(told.count("no parameters"), 1)

        # at the key, not at a range that is as good as any
        self.refuse((ends, "key: contacts.default.restitutoin, from: 0.2, to: 0.9"),
                    words=["plan.yaml:5:12: parameters.e.key: test bounce refuses it", "did you mean restitution?"])
        self.refuse((ends, "key: contacts.default.restitution, from: -0.2, to: 0.9"),
                    words=["parameters.e.from: test bounce refuses it", "is out of range"])

    def test_decimal_commas(self):
        """In braces YAML ends a value at its comma: from is 0, and 25 another key."""
        ends = "key: contacts.default.restitution, from: 0.2, to: 0.9"
        for line, place in ((ends.replace("0.2", "0,25"), "5:48"), (ends.replace("0.9", "0,9"), "5:57")):
            told = self.refuse((ends, line), words=[f"plan.yaml:{place}: write the decimal point as a point, not a comma: "])
            self.assertEqual(len(told.splitlines()), 3, told)
        self.refuse(("value: 1e-4", "value: -3,5 J"), words=["not a comma: value: -3.5 J"])
        self.refuse((f"  e: {{{ends}}}", "  e:\n    key: contacts.default.restitution\n    from: 0,2\n    to: 0.9"),
                    words=["plan.yaml:7:11: parameters.e.from: 0,2: write the decimal point as a point, not a comma"])
        # a key of digits is one as long as it is not part of a number
        self.refuse((ends, ends + ", 5: 1"), words=["parameters.e.5: this key is not known"])

    def test_a_refused_key_is_told_at_its_own_parameter(self):
        """Not at the first one, whose ends are tried first."""
        ends = "to: 0.9}\n"
        second = ends + "  mu: {key: contacts.default.friction, from: 0.1, to: 0.5}\n"
        self.assertIn("in order", self.calibrate(PLAN.replace(ends, second), "--check").stdout)
        for key, word in (("contacts.ore-flor.friction", "there is no material flor"),
                          ("contacts.default.frictoin", "did you mean friction?"),
                          ("contacts.default.coulomb", "is not one of")):
            told = self.refuse((ends, second.replace("contacts.default.friction", key)),
                               words=["plan.yaml:6:13: parameters.mu.key: test bounce refuses it: --set " + key, word])
            self.assertEqual(told.count("refuses it"), 1)
        self.refuse((ends, second.replace("to: 0.5", "to: 1000")),
                    words=["plan.yaml:6:55: parameters.mu.to: test bounce refuses it", "1000 is out of range"])
        # refused at both ends, so that no end of the range is to blame
        self.refuse((ends, second.replace("{key", "{multiples: {contacts.default.frictoin: 2}, key")),
                    words=["plan.yaml:6:47: parameters.mu.multiples.contacts.default.frictoin: test bounce refuses it"])

    def test_a_test_without_targets_is_refused(self):
        """Its runs would tell nothing. A held-back target is enough."""
        other = ("  bounce: {case: bounce.yaml}\n", "  bounce: {case: bounce.yaml}\n  more: {case: bounce.yaml}\n")
        told = self.refuse(other, words=["plan.yaml:4:3: tests.more: no target names this test"])
        self.assertIn("with held_back: true if it is only to be predicted, or remove the test", told)
        plan = PLAN.replace(*other).replace(
            "sampling:", "  - {test: more, number: kinetic_energy_J, value: 1e-4, error: 4e-6, held_back: true}\nsampling:")
        self.assertIn("in order", self.calibrate(plan, "--check").stdout)
        # a name that is wrong is told by itself
        told = self.refuse(("test: bounce, number", "test: bonce, number"), words=["there is no test bonce"])
        self.assertNotIn("no target names", told)

    def test_a_case_that_is_refused_is_told_in_one_line(self):
        """Its excerpt has no place above that of the plan."""
        with open(CASE) as file:
            self.write("other.yaml", "include: card.yaml # none is there\n" + file.read())
        told = self.refuse(("bounce.yaml", "other.yaml"),
                           words=["card.yaml: cannot be opened", "clod calibrate writes a card.yaml into its results folder\n"])
        self.assertEqual(len(told.splitlines()), 3, told)

    def two(self, k1, k2, points="9"):
        return (("points: 9", f"points: {points}"), ("  e: {key: contacts.default.restitution, from: 0.2, to: 0.9}",
                f"  k1: {{key: contacts.default.k1, {k1}}}\n  k2: {{key: contacts.default.k2, {k2}}}"))

    def test_combination_that_the_case_refuses_is_named(self):
        """k2 must not be below k1: each end goes with the middle of the other, but not all corners."""
        law = ("law: hooke, k1: 1e5 N/m", "law: luding, k1: 1e5 N/m, k2: 4e6 N/m, plasticity_depth: 0.05")
        with open(CASE) as file:
            text = file.read()
        self.assertIn(law[0], text)
        self.write("bounce.yaml", text.replace(*law))
        told = self.refuse(*self.two("from: 1e5 N/m, to: 2e6 N/m", "from: 1.2e6 N/m, to: 4e6 N/m"),
                           words=["test bounce refuses k1 = 2e+06 N/m, k2 = 1.2e+06 N/m together"])
        self.assertEqual(told.count("refuses"), 1)
        plan = PLAN
        for old, new in self.two("from: 1e5 N/m, to: 2e6 N/m", "from: 2.1e6 N/m, to: 4e6 N/m"):
            plan = plan.replace(old, new)
        self.assertIn("in order", self.calibrate(plan, "--check").stdout)

    # ---- wall friction tests

    WALL = """points: 5
tests:
  wall: {case: wall.yaml}
parameters:
  mu: {key: contacts.ore-plate.friction, from: 0.05, to: 0.2}
targets:
  - {test: wall, number: phi_x, normal_stress: 10 kPa, value: 6.843 deg, error: 0.3 deg}
  - {test: wall, number: phi_w, value: 6.843 deg, error: 0.3 deg, held_back: true}
  - {test: wall, number: tau_ad, value: 0 kPa, error: 0.05 kPa, held_back: true}
  - {test: wall, number: rho_b, normal_stress: 5 kPa, value: 1200 kg/m3, error: 50 kg/m3, held_back: true}
sampling: {samples: 1000}
"""

    def write_wall(self):
        with open(clod.source("tests/cli/wall_friction.yaml")) as file:
            text = file.read()
        for old, new in (("outer_radius: 30 mm", "outer_radius: 22 mm"), ("grain_count: 400", "grain_count: 200"),
                         ("[5 kPa, 20 kPa, 10 kPa]", "[5 kPa, 10 kPa]"),
                         ("k1: 2e7", "k1: 2e6"), ("k2: 1e8", "k2: 1e7")):  # a third of the steps
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.write("wall.yaml", text)

    def test_wall_friction_test_tells_the_friction_of_its_plate(self):
        """Grains that slip on the plate: phi_x is atan(mu), and 6.843 deg that of 0.12."""
        self.write_wall()
        self.calibrate(self.WALL, "-o", "out")
        with open(self.path("out/calibration.json")) as file:
            mu = json.load(file)["parameters"]["mu"]
        self.assertLess(abs(mu["mean"] - 0.12), 0.004)
        # 0.3 deg is 0.3 pi/180 (1 + 0.12^2) = 0.0053 of mu: 90 % within 1.645 of it
        self.assertLess(abs(mu["high"] - mu["low"] - 2.0 * 1.645 * 0.0053), 0.004)
        with open(self.path("out/runs.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 5)
        for k, row in enumerate(rows):
            angle = math.degrees(math.atan(float(row["mu [1]"])))
            phi_x = float(row["wall: phi_x at 10 kPa [deg]"])
            self.assertLessEqual(phi_x, angle + 1e-3)  # Coulomb's bound
            self.assertGreater(phi_x, 0.98 * angle)  # a few of the 200 grains roll
            with open(self.path(f"out/runs/p{k:03}-1-wall/wall_friction.csv")) as file:
                at = {point["wall_stress [Pa]"]: point for point in csv.DictReader(file)}
            (s1, t1), (s2, t2) = ((float(at[stress]["sigma_w [Pa]"]), float(at[stress]["tau_w [Pa]"]))
                                  for stress in ("10000", "5000"))
            self.assertLess(abs(phi_x - math.degrees(math.atan(t1 / s1))), 1e-4)
            slope = (t1 - t2) / (s1 - s2)  # of the line through both points
            self.assertLess(abs(float(row["wall: phi_w [deg]"]) - math.degrees(math.atan(slope))), 1e-4)
            self.assertLess(abs(float(row["wall: tau_ad [kPa]"]) - 1e-3 * (t1 - slope * s1)), 1e-5)
            self.assertLess(abs(float(row["wall: rho_b at 5 kPa [kg/m3]"]) /
                                float(at["5000"]["rho_b [kg/m3]"]) - 1.0), 1e-6)
        self.check_warnings()

    def check_warnings(self):
        """What the runs warn of, by text without its numbers, and how many of them do."""
        first, runs = {}, {}
        for k in range(5):
            with open(self.path(f"out/runs/p{k:03}-1-wall/summary.json")) as file:
                summary = json.load(file)
            for text in summary["warnings"] + summary["wall_locus"]["warnings"]:
                kind = re.sub(r"\d+(\.\d+)?(e[-+]\d+)?", "#", text)
                first.setdefault(kind, (k, text))
                runs.setdefault(kind, set()).add(k)
        self.assertGreater(len(first), 0)  # or the case says nothing about them
        said = self.found()["warnings"]
        for kind, (k, text) in first.items():
            count = len(runs[kind])
            words = "1 run of test wall warns" if count == 1 else f"{count} runs of test wall warn"
            self.assertIn(f"{words}, the first of them p{k:03}-1-wall: {text}"[:300],
                          [one[:300] for one in said])

    def test_walls_that_carry_a_part_of_the_load_take_no_number_away(self):
        """Friction of the side takes some of the stress that was asked for: phi_x is still told at that one."""
        self.write_wall()
        with open(self.path("wall.yaml")) as file:
            text = file.read()
        self.assertIn("ore-side: {friction: 0,", text)
        self.write("wall.yaml", text.replace("ore-side: {friction: 0,", "ore-side: {friction: 0.1,"))
        self.calibrate(self.WALL, "-o", "out")
        with open(self.path("out/runs.csv")) as file:
            rows = list(csv.DictReader(file))
        far = 0
        for k, row in enumerate(rows):
            with open(self.path(f"out/runs/p{k:03}-1-wall/wall_friction.csv")) as file:
                point = [one for one in csv.DictReader(file) if one["wall_stress [Pa]"] == "10000"][0]
            sigma, tau = float(point["sigma_w [Pa]"]), float(point["tau_w [Pa]"])
            far += abs(sigma / 10e3 - 1.0) > 0.02
            self.assertLess(abs(float(row["wall: phi_x at 10 kPa [deg]"]) - math.degrees(math.atan(tau / sigma))),
                            1e-4)
        self.assertGreater(far, 0)  # or the case says nothing about it

    def test_doubts_about_the_case_of_a_test_are_told_before_its_runs(self):
        """What clod check warns of: adhesion to a flat plate that counts only where friction goes with the pull, too."""
        self.write_wall()
        self.assertNotIn("next to no wall adhesion", self.calibrate(self.WALL, "--check").stderr)
        with open(self.path("wall.yaml")) as file:
            text = file.read()
        self.assertIn("ore-plate: {friction: 0.2}", text)
        self.write("wall.yaml", text.replace("ore-plate: {friction: 0.2}", "ore-plate: {friction: 0.2, k_adh: 1e6 N/m^1.5, coulomb: force}"))
        done = self.calibrate(self.WALL, "--check")
        self.assertIn("in order", done.stdout)
        self.assertIn("WARNING: test wall, in the middle of all ranges: k_adh of ore and plate gives next to no wall adhesion",
                      done.stderr)

    def test_wrong_targets_of_wall_friction_tests(self):
        self.write_wall()

        def wall(old, new, word):
            self.assertIn(old, self.WALL)
            told = self.calibrate(self.WALL.replace(old, new), "--check", code=2).stderr
            self.assertIn(word, told)

        wall("number: phi_x", "number: phi_e", "test wall has no number phi_e, which is one of a ring shear or Jenike test; it has phi_x,")
        wall("number: phi_x", "number: rolling", "it has phi_x, phi_w, tau_ad, rho_b")
        wall(", normal_stress: 10 kPa", "", "phi_x needs the key normal_stress")
        wall("normal_stress: 10 kPa", "normal_stress: 7 kPa",
             "7 kPa is not among the wall_stresses of test wall; give it there")
        wall("phi_w,", "phi_w, normal_stress: 5 kPa,", "phi_w has none")
        self.assertIn("in order", self.calibrate(self.WALL, "--check").stdout)
        with open(self.path("wall.yaml"), "a") as file:
            file.write("  seeds: 2\n")
        told = self.calibrate(self.WALL, "--check", code=2).stderr
        self.assertIn("the case has seeds: 2; leave it out there, and give seeds here", told)

    # ---- tables over sigma_1

    CRUSH = """points: 5
tests:
  crush: {case: uniaxial.yaml}
parameters:
  mu: {key: contacts.default.friction, from: 0.2, to: 0.5}
targets:
  - {test: crush, locus: density.csv, error: 20 kg/m3}
  - {test: crush, locus: strength.csv, normal_stress: 20 kPa, discrepancy: 0.5 kPa}
sampling: {samples: 1000}
"""
    DENSITY = "sigma_1 [kPa],rho_b [kg/m3]\n10,1100\n20,1150\n"
    STRENGTH = "sigma_1 [kPa],sigma_c [kPa],sigma_c_error [kPa]\n10,4,0.3\n20,6,0.5\n40,9,0.6\n"

    def write_crush(self):
        with open(clod.source("tests/cli/uniaxial.yaml")) as file:
            text = file.read()
        for old, new in (("diameter: 36 mm", "diameter: 24 mm"), ("height: 36 mm", "height: 24 mm"),
                         ("grain_count: 250", "grain_count: 75"), ("speed: 80 mm/s", "speed: 150 mm/s")):
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.write("uniaxial.yaml", text)
        self.write("density.csv", self.DENSITY)
        self.write("strength.csv", self.STRENGTH)

    def test_tables_of_density_and_strength_are_targets_of_a_uniaxial_test(self):
        """Numbers of the runs are those of their own tables, moved along the measured ones to their stresses."""
        self.write_crush()
        self.calibrate(self.CRUSH, "-o", "out")
        names = ["crush: rho_b at 10 kPa", "crush: rho_b at 20 kPa", "crush: sigma_c at 20 kPa"]
        found = self.found()["targets"]
        self.assertEqual([one["name"] for one in found], names)
        self.assertEqual([(one["measured"], one["error"]) for one in found], [(1100, 20), (1150, 20), (6, 0.5)])
        rows = self.rows()
        self.assertEqual(len(rows), 5)
        for k, row in enumerate(rows):
            with open(self.path(f"out/runs/p{k:03}-1-crush/flow_function.csv")) as file:
                table = {float(one["consolidation_stress [Pa]"]): one for one in csv.DictReader(file)}
            for stress, name, column, factor, slope in (
                    (10e3, "rho_b at 10 kPa [kg/m3]", "rho_b [kg/m3]", 1.0, 50 / 10e3),
                    (20e3, "rho_b at 20 kPa [kg/m3]", "rho_b [kg/m3]", 1.0, 50 / 10e3),
                    (20e3, "sigma_c at 20 kPa [kPa]", "sigma_c [Pa]", 1e-3, None)):
                own = float(table[stress]["sigma_1 [Pa]"])
                if slope is None:  # the slope changes at 20 kPa
                    slope = 2 / 10 if own < 20e3 else 3 / 20
                moved = float(table[stress][column]) + slope * (stress - own)
                self.assertLess(abs(float(row[f"crush: {name}"]) / (factor * moved) - 1.0), 1e-6)

    def test_tables_that_do_not_fit_the_test_are_told_with_their_place(self):
        self.write_crush()

        def crush(old, new, word):
            self.assertIn(old, self.CRUSH)
            told = self.calibrate(self.CRUSH.replace(old, new), "--check", code=2).stderr
            self.assertIn(word, told)

        crush(", normal_stress: 20 kPa", "",
              "plan.yaml:8:26: targets.1.locus: 40 kPa is not among the consolidation_stresses of test crush")
        crush("normal_stress: 20 kPa", "normal_stress: 15 kPa",
              "targets.1.normal_stress: 15 kPa: the table has no such sigma_1; it has 10, 20, 40 kPa")
        crush(", error: 20 kg/m3", ", error: 20 kPa", "targets.0.error: 20 kPa")
        crush("discrepancy: 0.5 kPa}", "discrepancy: 0.5 kPa}\n  - {test: crush, number: ffc, normal_stress: 20 kPa, "
              "value: 5, error: 0.2}", "test crush: ffc 5 in targets.2 is not sigma_1/sigma_c = 20 kPa/6 kPa")
        crush("density.csv, error: 20 kg/m3", "high.csv, error: 20 kg/m3", "high.csv: cannot be opened")
        self.write("high.csv", self.DENSITY.replace("1150", "2500"))
        crush("density.csv", "high.csv", "rho_b 2500 kg/m3 in targets.0 is above the density of its grains, 2481 kg/m3")
        self.assertIn("in order", self.calibrate(self.CRUSH, "--check").stdout)

    def test_words_of_a_test_that_fails_end_with_one_stop(self):
        with open(CASE) as file:
            text = file.read()
        self.write("bounce.yaml", text.replace("k1: 1e5", "k1: 1e1"))
        told = self.calibrate(PLAN, "-o", "out", code=1).stderr
        self.assertIn("in the middle of all ranges. Mend the case or the ranges, and remove out. It said: ", told)
        self.assertNotIn(". .", told)
        self.assertNotIn("..", told)

    # ---- what comes out

    def table(self, told):
        """Rows of the targets by their names."""
        part = told[told.index("Targets that were used"):told.index("Surrogates")]
        return {" ".join(line.split()[:2]): line.split()[2:] for line in part.splitlines()
                if line.startswith("  bounce: ")}

    def test_small_numbers_keep_four_figures(self):
        told = self.calibrate(PLAN, "-o", "out").stdout
        row = self.table(told)["bounce: kinetic_energy_J"]
        self.assertEqual(row[:2], ["0.0001", "4e-06"])
        with open(self.path("out/calibration.json")) as file:
            model = json.load(file)["targets"][0]["model"]
        self.assertEqual(row[3], f"{model:.4g}")

    def test_one_number_measured_twice_has_two_names_everywhere(self):
        """Table, JSON, runs.csv and the page's figures, where one would stand for the other."""
        twice = "  - {test: bounce, number: kinetic_energy_J, value: 1.1e-4, error: 5e-6, held_back: true}\n"
        told = self.calibrate(PLAN.replace("sampling:", twice + "sampling:"), "-o", "out").stdout
        names = [f"bounce: kinetic_energy_J (targets.{k})" for k in (0, 1)]
        self.assertEqual([one["name"] for one in self.found()["targets"]], names)
        for name, value in zip(names, ("0.0001", "0.00011")):
            self.assertRegex(told, re.escape(name) + r" +" + re.escape(value) + " ")
            self.assertEqual(told.count(name), 2)  # in its table of targets and under Surrogates
            self.assertIn(f"{name} [J]", self.rows()[0])
        self.assertEqual(clod.run("report", "out", cwd=self.folder).returncode, 0)
        with open(self.path("out/report.html")) as file:
            page = file.read()
        for name in names:
            self.assertIn(f"{name} over e", page)

    def test_held_back_number_that_no_run_has_is_dropped_and_told(self):
        plan = PLAN.replace("points: 9", "points: 6")
        self.calibrate(plan, "-o", "out")
        with open(self.path("out/calibration.json")) as file:
            before = json.load(file)["parameters"]
        for k in range(6):
            path = self.path(f"out/runs/p{k:03}-1-bounce/summary.json")
            with open(path) as file:
                summary = json.load(file)
            summary["coordination"] = None
            with open(path, "w") as file:
                json.dump(summary, file)
        held = "  - {test: bounce, number: coordination, value: 4, error: 1, held_back: true}\n"
        done = self.calibrate(plan.replace("sampling:", held + "sampling:"), "-o", "out")
        self.assertIn("bounce: coordination is not defined in the middle of all ranges", done.stderr)
        self.assertIn("it is not predicted", done.stderr)
        self.assertIn("bounce: coordination was held back and cannot be predicted: 0 of 6 runs have this number",
                      " ".join(done.stdout.split()))
        self.assertEqual(self.table(done.stdout)["bounce: coordination"], ["4", "1", "0", "-", "-", "-", "-", "-", "-"])
        with open(self.path("out/calibration.json")) as file:
            found = json.load(file)
        self.assertEqual(found["parameters"], before)
        self.assertEqual([found["targets"][1][key] for key in ("model", "low", "surrogate")], [None] * 3)
        self.assertEqual(clod.run("report", "out", cwd=self.folder).returncode, 0)

    def test_title_of_two_lines_leaves_the_card_whole(self):
        """Line breaks of the title and of the plan's path stay inside the comment."""
        self.write("plan\nseed: 5.yaml", "title: |\n  Fines\n  7 percent\n" + PLAN.replace("points: 9", "points: 5"))
        done = clod.run("calibrate", "plan\nseed: 5.yaml", "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("out/card.yaml")) as file:
            card = file.read()
        self.assertIn("# Material card: Fines 7 percent", card.splitlines()[0])
        keys = [line for line in card.splitlines() if not line.startswith("#")]
        self.assertEqual([line.split(":")[0].strip() for line in keys][:4],
                         ["contacts", "default", "restitution", "calibrated_with"])


if __name__ == "__main__":
    clod.unittest.main()
