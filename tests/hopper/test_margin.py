"""clod hopper with a margin of nothing: a hopper at its limit of mass flow is mass flow, since that is what the limit is."""

import os
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import ROWS, clod

CASE = "flow_function: {file: flow.csv}\nwall_friction: {file: wall.csv}\n"
WALL = "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n1,0.44,0.02\n2,0.83,0.03\n4,1.60,0.05\n8,3.15,0.08\n16,6.20,0.15\n"
NEAREST = 0.05  # deg: nearer to its limit no half angle is made, docs/theory/hopper.md


class Margin(hopper_case.Case):

    def design(self, margin, outlet):
        outlets = [word for shape in ("cone", "wedge") if outlet for word in ("--set", f"{shape}.outlet={outlet} mm")]
        return self.found("--set", f"margin={margin} deg", *outlets)

    def test_at_the_limit_it_is_mass_flow(self):
        self.start(CASE, ROWS)
        self.write("wall.csv", WALL)
        for outlet in (None, 300, 500, 2000):
            found = self.design(0, outlet)
            near = self.design(0.2, outlet)
            for shape in ("cone", "wedge"):
                self.assertEqual(found[shape]["outcome"], "flows", (outlet, shape))
                limit, angle = (found[shape][key]["value"] for key in ("limit_deg", "half_angle_deg"))
                self.assertAlmostEqual(limit - angle, NEAREST, delta=1e-6)
                # 0.15 deg further from it: the angle is as much smaller, and the limit, at nearly the same stress, hardly
                self.assertAlmostEqual(angle - near[shape]["half_angle_deg"]["value"], 0.2 - NEAREST, delta=0.1)
                # at the outlet that is built the solid slides, so the smallest one at which it does is not larger
                if outlet is not None and 1e3 * found[shape]["outlet_m"]["value"] <= outlet:
                    self.assertAlmostEqual(1e3 * found[shape]["design_state"]["outlet_m"], outlet, delta=1e-6)
                    self.assertIsNotNone(found[shape]["arching_margin"]["value"])

    def test_a_wall_that_roughens_with_stress(self):
        """A wider outlet has larger stresses, so a steeper cone; one slides at its outlet, and none of them is left without a state."""
        self.start(CASE, "1,0.7,0.05,47,40,1200\n2,1.1,0.05,46,40,1250\n4,1.8,0.05,45,39,1300\n")
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n0.3,0.06,0.001\n1.2,0.30,0.002\n2,0.6,0.003\n4,1.5,0.003\n")
        angles = []
        for outlet in (150, 250):
            cone = self.design(0, outlet)["cone"]
            self.assertEqual(cone["outcome"], "flows")
            self.assertEqual(cone["sample_shares"]["unsettled"], 0.0)
            self.assertGreater(cone["outlet_m"]["low"], 0.0)
            angles.append(cone["half_angle_deg"]["value"])
        self.assertGreater(angles[0], angles[1])

    def test_an_outlet_beyond_the_critical_one_breaks_arches(self):
        """Fines of three specimens on a wall that roughens with stress: at two ranges of stress the solid slides, not between."""
        shutil.copy(clod.source("cases/lab-to-outlet/shear.csv"), self.folder)
        self.write("case.yaml", "flow_function: {shear_tests: [{points: shear.csv}]}\nwall_friction: {file: wall.csv}\n")
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n0.3,0.06,0.001\n1.2,0.30,0.002\n2,0.6,0.003\n4,1.5,0.003\n")
        cone = self.found("--set", "margin=0 deg", "--set", "cone.outlet=190 mm")["cone"]
        self.assertLess(cone["outlet_m"]["value"], 0.19)
        self.assertGreater(cone["arching_margin"]["value"], 1.0)

    def wedge(self, outlet, how, margin=0):
        return self.found("--set", f"margin={margin} deg", "--set", f"wedge={{{how}, outlet: {outlet} mm}}")["wedge"]

    def test_a_wall_of_one_angle(self):
        self.start()
        for shape in ("cone", "wedge"):
            self.assertEqual(self.design(0, 600)[shape]["outcome"], "flows")

    def test_at_a_limit_that_is_given(self):
        """phi_e and the wall are those of all stresses, so if the solid slides at one it does at all: no outlet is the wall's."""
        self.start(rows=ROWS.replace("47,", "48,").replace("46,", "48,"))
        for outlet in (80, 600):
            far = self.wedge(outlet, "half_angle: 44.95 deg, limit: 50 deg")
            self.assertFalse(far["outlet_by_wall"])
            for margin, angle, half in ((0, "auto", 45 - NEAREST), (0.01, "auto", 45 - NEAREST), (0, "45 deg", 45), (1, "auto", 44)):
                found = self.wedge(outlet, f"half_angle: {angle}, limit: 45 deg", margin)
                self.assertEqual(found["outcome"], "flows")
                self.assertFalse(found["outlet_by_wall"], (outlet, margin, angle))
                self.assertAlmostEqual(found["half_angle_deg"]["value"], half, delta=1e-6)
                if half == 45 - NEAREST:
                    self.assertAlmostEqual(found["outlet_m"]["value"], far["outlet_m"]["value"], delta=1e-6)


if __name__ == "__main__":
    clod.unittest.main()
