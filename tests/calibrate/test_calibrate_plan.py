"""Plans that clod calibrate refuses before the first run, and what its results say.

The plan is that of test_calibrate.py: grains that meet a floor, whose case loads in a millisecond.
"""

import json
import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOUNCE = clod.source("tests/calibrate/bounce.yaml")
PLAN = """points: 9
tests:
  bounce: {case: bounce.yaml}
parameters:
  e: {key: contacts.default.restitution, from: 0.2, to: 0.9}
targets:
  - {test: bounce, number: kinetic_energy_J, value: 1e-4, error: 4e-6}
sampling: {samples: 1000}
"""


class Plan(clod.Case):

    def setUp(self):
        super().setUp()
        shutil.copy(BOUNCE, self.folder)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def calibrate(self, text, *arguments, code=0):
        self.write("plan.yaml", text)
        done = clod.run("calibrate", "plan.yaml", *arguments, cwd=self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

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

    def two(self, k1, k2, points="9"):
        return (("points: 9", f"points: {points}"), ("  e: {key: contacts.default.restitution, from: 0.2, to: 0.9}",
                f"  k1: {{key: contacts.default.k1, {k1}}}\n  k2: {{key: contacts.default.k2, {k2}}}"))

    def test_combination_that_the_case_refuses_is_named(self):
        """k2 must not be below k1: each end goes with the middle of the other, but not all corners."""
        law = ("law: hooke, k1: 1e5 N/m", "law: luding, k1: 1e5 N/m, k2: 4e6 N/m, plasticity_depth: 0.05")
        with open(BOUNCE) as file:
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


if __name__ == "__main__":
    clod.unittest.main()
