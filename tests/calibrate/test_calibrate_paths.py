"""Numbers of a free run as targets: names of the summary that a case has, and the units in which they are given."""

import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import bounce
import clod
from bounce import CASE, PLAN

TARGET = "number: kinetic_energy_J, value"
# Everything that a summary may have: two stages of 1 ms.
FULL = """repose: {heap: {region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 100 mm]}}, cell: 7 mm}}
clumps: {}
"""


class Paths(bounce.Bounce):

    def told(self, number, text=None):
        """What --check says of a target of this number; exit status 0 is in order."""
        self.write("plan.yaml", (text or PLAN).replace("kinetic_energy_J", number))
        return clod.run("calibrate", "plan.yaml", "--check", cwd=self.folder)

    def names_told(self):
        done = self.told("repoze.heap.nothing")
        self.assertEqual(done.returncode, 2)
        self.assertIn("plan.yaml:9:", done.stderr)
        self.assertIn("targets.0.number: test bounce has no number repoze.heap.nothing", done.stderr)
        line = next(line for line in done.stderr.splitlines() if "begins its paths with " in line)
        return done.stderr, line.split("begins its paths with ")[1].split(", ")

    def names_of_run(self):
        """Names at the top of a run's summary, but the texts and what only a run from another has."""
        done = clod.run("run", "bounce.yaml", "-o", "run", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("run/summary.json")) as file:
            return [name for name, value in json.load(file).items() if not isinstance(value, str)]

    def test_names_are_those_of_a_run(self):
        text, names = self.names_told()
        self.assertNotIn("repose", names)
        self.assertNotIn("did you mean", text)
        self.assertEqual(sorted(names), sorted(self.names_of_run()))

    def test_names_are_those_of_a_run_with_measures(self):
        with open(CASE) as file:
            case = file.read()
        self.write("bounce.yaml", case.replace("200 mm]}", "200 mm], open: delete}") + FULL)
        text, names = self.names_told()
        self.assertIn("did you mean repose?", text)
        missing = set(names) ^ set(self.names_of_run())
        self.assertEqual(missing, {"residence"})  # no grain has left
        self.assertEqual(self.told("repose.heap.angle_deg, value: 30 deg, error: 2 deg}  #").returncode, 0)

    def test_a_case_without_a_heap_is_refused_before_a_run_is_paid(self):
        done = self.told("repose.heap.angle_deg")
        self.assertEqual(done.returncode, 2)
        self.assertIn("has no number repose.heap.angle_deg", done.stderr)

    def test_units_of_names(self):
        with open(CASE) as file:
            case = file.read()
        self.write("bounce.yaml", case + FULL)
        for target, word in (
                ("repose.heap.angle_deg, value: 30 deg, error: 2 deg", None),
                ("repose.heap.angle_deg, value: 0.5 rad, error: 2", None),
                ("repose.heap.angle_deg, value: 30, error: 2", None),
                ("repose.heap.angle_deg, value: 30 kPa, error: 2", "targets.0.value: 30 kPa"),
                ("repose.heap.height_m, value: 40 mm, error: 2 mm", None),
                ("repose.heap.height_m, value: 40 deg, error: 2 mm", "targets.0.value: 40 deg"),
                ("walls.0.force_N.2, value: 1 kN, error: 1 N", None),
                ("grains, value: 12 mm, error: 1", "targets.0.value: 12 mm"),
                ("kinetic_energy_J, value: 1 J, error: 1", "targets.0.value: 1 J")):
            done = self.told(target + "}  #")
            self.assertEqual(done.returncode, 0 if word is None else 2, (target, done.stderr))
            self.assertIn(word or "", done.stderr)

    def test_values_are_shown_in_the_unit_of_the_name(self):
        """The stage lasts 9 ms to the last step, whatever the restitution: measured 9 ms, modelled 9 ms."""
        plan = PLAN.replace("error: 4e-6}", "error: 4e-6}\n  - {test: bounce, number: stages.0.end_s, value: 9 ms, "
                            "error: 1 ms, held_back: true}")
        self.calibrate(plan, "-o", "out")
        target = self.found()["targets"][1]
        self.assertEqual((target["unit"], target["measured"], target["error"]), ("s", 0.009, 0.001))
        self.assertAlmostEqual(target["model"], 0.009, delta=1e-4)
        for row in self.rows():
            self.assertAlmostEqual(float(row["bounce: stages.0.end_s [s]"]), 0.009, delta=1e-4)


if __name__ == "__main__":
    clod.unittest.main()
