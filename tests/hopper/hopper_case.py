"""A case of `clod hopper` in a folder of its own, the table it names, and what the design says."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

QUICK = ["--set", "interval.samples=100"]
FLOW = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],phi_t [deg],rho_b [kg/m3]\n"
ROWS = "2,1.4,0.05,48,40,1250\n4,1.9,0.05,47,40,1300\n8,2.9,0.08,46,39,1350\n"
CASE = """flow_function: {file: flow.csv}
wall_friction: {angle: 20 deg, error: 1 deg}
"""


def degrees(tau, sigma):
    return math.degrees(math.atan2(tau, sigma))


class Case(clod.Case):

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def hopper(self, *arguments, code=0):
        done = clod.run("hopper", *arguments, *QUICK, cwd=self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def found(self, *arguments):
        return json.loads(self.hopper("case.yaml", "--json", *arguments).stdout)

    def refuse(self, case, words, rows=ROWS, head=FLOW, more=()):
        """The case is refused with exit status 2 and these words."""
        self.write("case.yaml", case)
        self.write("flow.csv", head + rows)
        done = self.hopper("case.yaml", *more, code=2)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def start(self, case=CASE, rows=ROWS):
        self.write("case.yaml", case)
        self.write("flow.csv", FLOW + rows)
