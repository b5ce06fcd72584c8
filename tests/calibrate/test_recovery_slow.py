"""Ring shear tests of a cohesive solid, calibrated on ten laboratories of ten truths (cases/lab-to-outlet/recovery): some
60 minutes of processor time; and on one of ten specimens, seven."""

import json
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod


class Recovery(clod.Case):

    def test_the_truth_is_in_eight_of_ten_intervals(self):
        """As 93 of 100 such tables of ten 90 % intervals would have; and they tell more than the range."""
        done = subprocess.run([clod.source("cases/lab-to-outlet/recovery"), "--clod", clod.BINARY, "--folder", self.path("out")],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        print(done.stdout)
        inside, of, width = re.search(r"(\d+) of (\d+) intervals hold the truth; their mean width is (\S+)", done.stdout).groups()
        self.assertEqual(int(of), 10)
        self.assertGreaterEqual(int(inside), 8)
        self.assertLess(float(width), 0.6)  # 0.9 is that of the range, whose interval would hold all ten
        z, error, blind = (float(number) for number in re.search(r"rms of z (\S+); of mean less truth (\S+) mN, of the range's "
                                                                 r"middle less truth (\S+) mN", done.stdout).groups())
        self.assertLess(z, 1.6)  # ten normal numbers have 1.5 or less in 99 of 100 tables: chi-square of 10, 23.2
        self.assertLess(error, 0.75 * blind)

    def test_ten_specimens_identify_the_force(self):
        """Of 15 mN, in the interval; and as the README of the case says it."""
        done = subprocess.run([clod.BINARY, "calibrate", clod.source("cases/lab-to-outlet/plan.yaml"), "-o", self.path("ten"),
                               "--set", "targets=[{test: ring, locus: laboratory/shear-ten.csv}]"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("ten/calibration.json"), encoding="utf-8") as file:
            found = json.load(file)["parameters"]["pull_off_force"]
        self.assertLess(found["low"], 15)
        self.assertGreater(found["high"], 15)
        with open(clod.source("cases/lab-to-outlet/README.md"), encoding="utf-8") as file:
            self.assertIn(f"gives {found['mean']:.1f} mN ({found['low']:.1f} to {found['high']:.1f}), "
                          f"{found['relative_width']:.2f} of the range, identified `{found['identified']}`", file.read())


if __name__ == "__main__":
    clod.main()
