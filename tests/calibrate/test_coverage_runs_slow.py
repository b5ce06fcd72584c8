"""How often intervals of `clod calibrate` hold the truth where the tests are simulations, as of a user: grains that bounce once.

Each repeat has a restitution of its own, drawn between 0.3 and 0.8 and unknown to the plan, a laboratory that measures the energy
after the bounce with a known error, and packings of its own. REPEATS=24 of the environment takes more than ten, a second of processor time each.
"""

import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import bounce
from bounce import BEFORE, clod

REPEATS = int(os.environ.get("REPEATS", "10"))
ERROR = 8e-6  # J, of the laboratory; the energy is 5e-5 to 3e-4 J
PLAN = """title: bounce
points: 9
seeds: 2
seed: {seed}
tests: {{bounce: {{case: bounce.yaml}}}}
parameters:
  e: {{key: contacts.default.restitution, from: 0.2, to: 0.9}}
targets:
  - {{test: bounce, number: kinetic_energy_J, value: {value:.6g}, error: {error}}}
"""


class Coverage(bounce.Bounce):

    def test_intervals_hold_the_truth(self):
        """Of ten 90 % intervals at least eight, as 93 of 100 such tests of ten would; and none is as wide as half of the range."""
        dice = random.Random(7)
        inside, width = 0, 0.0
        for k in range(REPEATS):
            truth = dice.uniform(0.3, 0.8)
            value = BEFORE * truth**2 + dice.gauss(0.0, ERROR)
            self.calibrate(PLAN.format(seed=1 + 1000 * k, value=value, error=ERROR), "-o", f"out-{k}")
            e = self.found(f"out-{k}")["parameters"]["e"]
            held = e["low"] <= truth <= e["high"]
            inside += held
            width += (e["high"] - e["low"]) / REPEATS
            self.assertLess(e["high"] - e["low"], 0.35)
            print(f"truth {truth:.3f}, 90 % interval {e['low']:.3f} to {e['high']:.3f}{'' if held else ': missed'}")
        print(f"{inside} of {REPEATS} intervals hold the truth, mean width {width:.3f}")
        self.assertGreaterEqual(inside, 0.8 * REPEATS)


if __name__ == "__main__":
    clod.unittest.main()
