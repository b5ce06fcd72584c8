"""Plans whose tests set keys of their case, and whose parameters move several keys: what is run and written."""

import json
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import bounce
import clod

LAB = clod.source("cases/lab-to-outlet")

# Grains at v keep e^2 of their energy, so at twice the speed they have four times as much left.
PLAN = f"""points: 9
tests:
  slow: {{case: bounce.yaml}}
  fast: {{case: bounce.yaml, set: {{grains.0.velocity: [0 m/s, 0 m/s, -2 m/s]}}}}
parameters:
  e:
    key: contacts.default.restitution
    from: 0.2
    to: 0.8
    multiples: {{contacts.default.friction: 0.5}}
  k: {{key: contacts.default.k1, from: 1e5 N/m, to: 2e5 N/m}}
targets:
  - {{test: slow, number: kinetic_energy_J, value: {bounce.BEFORE * 0.36:.6g}, error: 4e-6}}
  - {{test: fast, number: kinetic_energy_J, value: {4.0 * bounce.BEFORE * 0.36:.6g}, error: 16e-6}}
sampling: {{samples: 1000}}
"""


class Settings(bounce.Bounce):

    def test_runs_and_card_have_what_the_plan_sets(self):
        self.calibrate(PLAN, "-o", "out")
        for row in self.rows():
            point = f"p{int(row['point']):03}-1"
            for test, speed in (("slow", "-1"), ("fast", "-2")):
                with open(self.path(f"out/runs/{point}-{test}/case-complete.yaml")) as file:
                    case = file.read()
                self.assertIn(f"velocity: [0 m/s, 0 m/s, {speed} m/s]", case)
                friction = float(re.search(r" friction: ([0-9.e-]+)", case)[1])
                self.assertAlmostEqual(friction, 0.5 * float(row["e [1]"]), 6)
        found = self.found()["parameters"]["e"]
        self.assertLess(abs(found["mean"] - 0.6), 0.04)
        self.assertEqual(found["multiples"], {"contacts.default.friction": 0.5})
        with open(self.path("out/card.yaml")) as file:
            card = file.read()
        self.assertRegex(card, r"(?m)^#   fast: .*bounce.yaml, with the set of plan.yaml$")
        values = {key: float(value) for key, value in re.findall(r"(?m)^    (\w+): ([0-9.e+-]+)", card)}
        self.assertAlmostEqual(values["friction"], 0.5 * values["restitution"], 3)
        self.assertIn("# 0.5 times contacts.default.restitution", card)
        # the same command goes on; another setting is another design
        self.calibrate(PLAN, "-o", "out")
        told = self.calibrate(PLAN.replace("-2 m/s", "-3 m/s"), "-o", "out", code=2).stderr
        self.assertIn("design.txt", told)

    @clod.quick_only
    def test_calibrated_case_runs_with_the_card(self):
        """The case has the card's key: included it is refused, by --set the card's value replaces it."""
        self.calibrate(bounce.PLAN, "-o", "out")
        with open(self.path("out/card.yaml")) as file:
            calibrated = float(re.search(r"(?m)^    restitution: ([0-9.]+)", file.read())[1])
        self.assertNotEqual(calibrated, 0.5)  # of bounce.yaml
        done = clod.run("run", "bounce.yaml", "--set", "include=out/card.yaml", "-o", "one", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("one/case-complete.yaml")) as file:
            self.assertEqual(float(re.search(r"restitution: ([0-9.]+)", file.read())[1]), calibrated)
        with open(bounce.CASE) as file:
            self.write("with.yaml", "include: out/card.yaml\n" + file.read())
        done = clod.run("check", "with.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("keep one of them, or name that file by --set include=FILE", done.stderr)

    def test_ratio_in_the_card(self):
        """k2/k1 is free: the card has the product of both means."""
        with open(bounce.CASE) as file:
            text = file.read()
        self.write("bounce.yaml", text.replace("law: hooke, k1: 1e5 N/m",
                                               "law: luding, k1: 1e5 N/m, k2: 4e6 N/m, plasticity_depth: 0.05"))
        plan = PLAN.replace("  k: {key: contacts.default.k1, from: 1e5 N/m, to: 2e5 N/m}",
                            "  k: {key: contacts.default.k1, from: 1e5 N/m, to: 2e5 N/m}\n"
                            "  r: {key: contacts.default.k2, times: k, from: 1.2, to: 3}")
        self.calibrate(plan, "-o", "out")
        found = self.found()["parameters"]
        self.assertEqual((found["r"]["times"], found["r"]["unit"]), ("k", ""))
        with open(self.path("out/card.yaml")) as file:
            card = file.read()
        k2, times = re.search(r"    k2: ([0-9.e+]+) N/m # ([0-9.]+) times contacts.default.k1; 90 %: ", card).groups()
        self.assertAlmostEqual(float(times) / found["r"]["mean"], 1.0, 3)
        self.assertAlmostEqual(float(k2) / (found["r"]["mean"] * found["k"]["mean"]), 1.0, 3)

    def test_worked_plan_of_the_how_to(self):
        """It is the file of cases/lab-to-outlet; three specimens serve both of its loci."""
        with open(os.path.join(LAB, "plan-loci.yaml")) as file:
            plan = file.read()
        with open(clod.source("docs/howto/calibrate.md")) as file:
            self.assertIn("```yaml\n" + plan + "```\n", file.read())
        shutil.copytree(LAB, self.path("lab"))
        done = clod.run("calibrate", "plan-loci.yaml", "--check", cwd=self.path("lab"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("The plan, its cases and tables are in order.", done.stdout)
        self.assertIn("specimens 101, 102, 103 of this table serve targets of the tests ring and low.", done.stderr)
        # a setting of one test is a key of the plan as any other
        done = clod.run("calibrate", "plan-loci.yaml", "--check", "--set", "tests.low.set.ring_shear.preshear_stress=0.6 s",
                        cwd=self.path("lab"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("tests.low.set.ring_shear.preshear_stress: 0.6 s is not a pressure", done.stderr)


if __name__ == "__main__":
    clod.unittest.main()
