"""A calibration of a known truth: grains that meet a floor at 1 m/s, whose energy tells restitution.

Grains that meet a floor keep restitution squared of their kinetic energy, so its mean over packings is
N m v^2/2 e^2 with the mean mass of uniform radii from a to b, (b^4 - a^4)/(4 (b - a)) 4/3 pi rho.
"""

import csv
import json
import math
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = clod.source("tests/calibrate/bounce.yaml")
A, B, RHO, GRAINS = 1.8e-3, 2.2e-3, 2500.0, 12
BEFORE = GRAINS * 0.5 * RHO * 4.0 / 3.0 * math.pi * (B**4 - A**4) / (4.0 * (B - A))
TRUTH = 0.6
PLAN = f"""title: bounce
points: 9
seeds: 2
tests:
  bounce: {{case: bounce.yaml}}
parameters:
  e: {{key: contacts.default.restitution, from: 0.2, to: 0.9}}
targets:
  - {{test: bounce, number: kinetic_energy_J, value: {BEFORE * TRUTH**2:.6g}, error: 4e-6}}
sampling: {{samples: 1000}}
"""
RESULTS = ("calibration.json", "card.yaml", "posterior.csv", "runs.csv", "report.txt")


class Bounce(clod.Case):
    """A folder with the case, and a plan that is calibrated in it."""

    def setUp(self):
        super().setUp()
        shutil.copy(CASE, self.folder)

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

    def found(self, folder="out"):
        with open(self.path(folder, "calibration.json")) as file:
            return json.load(file)

    def result(self, name, folder="out"):
        """Bytes of a file of results; without the time at which calibration.json was written."""
        text = clod.read(self.path(folder, name))
        if name != "calibration.json":
            return text
        lines = text.splitlines(keepends=True)
        kept = [line for line in lines if not line.startswith(b'  "written": "')]
        self.assertEqual(len(kept), len(lines) - 1)
        return b"".join(kept)

    def rows(self, folder="out"):
        with open(self.path(folder, "runs.csv")) as file:
            return list(csv.DictReader(file))

    def row(self, run, folder="out"):
        """The row of a run's file, by the beginning of its name: p003-1."""
        with open(self.path(folder, f"runs/{run}-bounce.json")) as file:
            return json.load(file)

    def change_row(self, run, **keys):
        row = {**self.row(run), **keys}
        self.write(f"out/runs/{run}-bounce.json", json.dumps(row))

    def restitution_run(self, run, folder="out"):
        """Restitution in the complete case of a run."""
        with open(self.path(folder, f"runs/{run}-bounce/case-complete.yaml")) as file:
            return float(re.search(r"restitution: ([0-9.e-]+)", file.read())[1])

    def ended(self, run, folder="out"):
        """Whether a run is there and done."""
        return os.path.exists(self.path(folder, f"runs/{run}-bounce.json")) and \
            self.row(run, folder)["state"] == "done"
