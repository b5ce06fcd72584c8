"""A flow function that crosses the flow factor more than once: outlets above the critical one have no arch.

Pieces of f_c [kPa] over sigma_1: 0.6 + 0.25 x up to 2, -1.9 + 1.5 x up to 3, then 2.125581 + 0.158140 x. With phi_e and wall of
one angle the flow factor ff is one number, and the crossings are a/(1/ff - b); an outlet has sigma_1/ff H/(rho g).
"""

import math

import hopper_case
from hopper_case import clod

CASE = """flow_function: {file: flow.csv, curve: points}
wall_friction: {angle: 20 deg, error: 1 deg}
effective_friction: {angle: 50 deg}
bulk_density: {value: 1300 kg/m3}
cone: {half_angle: 20 deg}
"""
HEAD = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_t [deg]\n"
KINKED = HEAD + "1,0.85,0.02,40\n2,1.1,0.02,40\n3,2.6,0.02,40\n24.5,6,0.2,40\n"
STRAIGHT = HEAD + "1,0.85,0.02,40\n2,1.1,0.02,40\n3,1.35,0.02,40\n24.5,6.725,0.2,40\n"
H = 150.0 / 65.0  # 20 deg
WEIGHT = 1300.0 * 9.80665


def crossings(ff):
    """Outlets at the three crossings [m]."""
    stress = (0.6 / (1 / ff - 0.25), 1.9 / (1.5 - 1 / ff), 2.125581 / (1 / ff - 0.158140))
    return [1e3 * x / ff * H / WEIGHT for x in stress]


class Kinked(hopper_case.Case):

    def begin(self, table):
        self.write("case.yaml", CASE)
        self.write("flow.csv", table)

    def words(self, *arguments):
        return " ".join(self.hopper("case.yaml", *arguments).stdout.split())

    def test_the_last_crossing_is_the_critical_one(self):
        self.begin(KINKED)
        cone = self.found()["cone"]
        first, low, last = crossings(cone["flow_factor"]["value"])
        self.assertAlmostEqual(cone["outlet_m"]["value"] / last, 1.0, delta=1e-5)
        self.assertEqual(len(cone["smaller_outlets_without_arch_m"]), 1)
        for value, expected in zip(cone["smaller_outlets_without_arch_m"][0], (first, low)):
            self.assertAlmostEqual(value / expected, 1.0, delta=1e-5)
        told = self.words()
        self.assertIn(f"critical outlet {1e3 * last:.1f}", told)
        self.assertIn(f"Cone: no arch stands over outlets of {1e3 * first:.1f} to {1e3 * low:.1f} mm either, but one "
                      "does above them, where the hopper is wider", told)

    def test_an_outlet_that_is_given_is_judged_by_it(self):
        """300 mm lie where none stands over the outlet, 420 mm where one does, 600 mm above all."""
        self.begin(KINKED)
        told = self.words("--set", "cone.outlet=300 mm")
        self.assertRegex(told, r"the outlet of 300 mm is below the critical one, [^:]*: no arch stands over it, but one "
                               r"does above it, where the hopper is wider\. 100\.0 % of the samples do not flow")
        found = self.found("--set", "cone.outlet=300 mm")["cone"]
        self.assertGreater(found["arching_margin"]["low"], 1.1)
        self.assertEqual(found["planned_outlet_arching_share"], 1.0)
        found = self.found("--set", "cone.outlet=420 mm")["cone"]
        self.assertLess(found["arching_margin"]["value"], 1.0)
        self.assertGreater(found["outlet_m"]["value"], 0.42)
        self.assertIn(": it arches.", self.words("--set", "cone.outlet=420 mm"))
        found = self.found("--set", "cone.outlet=600 mm")["cone"]
        self.assertGreater(found["arching_margin"]["value"], 1.0)
        self.assertEqual(found["planned_outlet_arching_share"], 0.0)

    def test_a_line_that_misses_is_compared_with_the_last_crossing(self):
        self.begin(KINKED)
        last = crossings(self.found()["cone"]["flow_factor"]["value"])[2]
        told = self.words("--set", "flow_function.curve=line")
        self.assertIn(f"With flow_function.curve: points the critical outlet is {1e3 * last:.1f} mm (cone)", told)

    def test_a_curve_that_ends_above_has_no_outlet(self):
        """From 6 kPa on 1.7 x - 4.1 rises above any ray; 0.775 + 0.075 x up to 3 is crossed before."""
        self.begin(HEAD + "1,0.85,0.02,40\n3,1.0,0.02,40\n3.5,1.85,0.02,40\n")
        cone = self.found("--set", "cone.outlet=200 mm")["cone"]
        ff = cone["flow_factor"]["value"]
        size = 1e3 / ff * H / WEIGHT
        self.assertEqual(cone["outcome"], "arches")
        self.assertEqual(cone["outlet_m"]["value"], "infinite")
        low, high = cone["smaller_outlets_without_arch_m"][0]
        self.assertAlmostEqual(low / (size * 0.775 / (1 / ff - 0.075)), 1.0, delta=1e-5)
        self.assertAlmostEqual(high / (size * 4.1 / (1.7 - 1 / ff)), 1.0, delta=1e-5)
        told = self.words("--set", "cone.outlet=200 mm")
        self.assertIn("rests on an extrapolation beyond the largest sigma_1, 3.500 kPa", told)
        self.assertIn("the outlet of 200 mm is not large enough, as none is: no arch stands over it, but one does above",
                      told)

    def test_ratholes_too(self):
        """phi_e 50, phi_t 40: ff_p = (1 + s)/(4 s) G, G(40) = 3.593; four digits. Pieces as in tests/hopper/test_ranges.c."""
        self.begin(HEAD + "2,1.4,0.02,40\n4,1.5,0.02,40\n6,3.5,0.02,40\n20,5,0.2,40\n")
        sine = math.sin(math.radians(50.0))
        ff = (1 + sine) / (4 * sine) * 3.593
        size = 1e3 / ff * 3.593 / WEIGHT
        rathole = self.found()["rathole"]
        self.assertAlmostEqual(rathole["emptying_m"]["value"] / (size * 2.857143 / (1 / ff - 0.107143)), 1.0, delta=1e-3)
        first, low = rathole["smaller_diameters_without_rathole_m"][0]
        self.assertAlmostEqual(first / (size * 1.3 / (1 / ff - 0.05)), 1.0, delta=1e-3)
        self.assertAlmostEqual(low / (size * 2.5 / (1 - 1 / ff)), 1.0, delta=1e-3)
        self.assertIn(f"Rathole, emptying: of {1e3 * first:.1f} to {1e3 * low:.1f} mm none stands either, but wider ones do",
                      self.words())

    def test_a_straight_one_has_nothing_to_tell(self):
        """0.6 + 0.25 x from point to point: 0.6/(1/ff - 0.25)."""
        self.begin(STRAIGHT)
        found = self.found()
        cone = found["cone"]
        self.assertAlmostEqual(cone["outlet_m"]["value"] / crossings(cone["flow_factor"]["value"])[0], 1.0, delta=1e-5)
        self.assertEqual(cone["smaller_outlets_without_arch_m"], [])
        self.assertEqual(found["rathole"]["smaller_diameters_without_rathole_m"], [])
        self.assertNotIn("more than once", self.words())

    def test_the_page_warns(self):
        self.begin(KINKED)
        self.hopper("case.yaml", "-o", "page")
        with open(self.path("page.html")) as file:
            self.assertIn("crosses the flow factor more than once", file.read())


if __name__ == "__main__":
    clod.unittest.main()
