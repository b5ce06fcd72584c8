"""Half angles are those at the outlet that is built, and a wall yield locus followed far below its points is told.

The solid flows freely: its flow function meets the flow factor at some 0.02 kPa, where a line through wall friction points of 1
to 16 kPa, whose intercept is 0.05 +- 0.04 kPa, says nothing."""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import CASE, FLOW, clod

FREE = "3.1,0.11,0.01,42,38,1210\n6.2,0.20,0.01,42,37.5,1265\n12.3,0.39,0.01,42,37,1320\n"
STRAIGHT = FREE.replace(",0.11,", ",0.10,").replace(",0.39,", ",0.40,")  # f_c/sigma_1 grows with sigma_1
WALL = "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n1.0,0.44,0.02\n2.0,0.83,0.03\n4.0,1.60,0.05\n8.0,3.15,0.08\n16.0,6.20,0.15\n"
BUILT = ("--set", "cone={half_angle: auto, outlet: 500 mm}")
GIVEN = ("--set", "cone={half_angle: 15 deg, outlet: 500 mm}")
INTERCEPT = "rests on the intercept of the wall yield locus"


class WallDecides(hopper_case.Case):

    def start(self, rows=FREE, wall="file: wall.csv", more=""):
        self.write("flow.csv", FLOW + rows)
        self.write("wall.csv", WALL)
        self.write("case.yaml", f"flow_function: {{file: flow.csv}}\nwall_friction: {{{wall}}}\n" + more)

    def limit(self, phi_w):
        """Limit of mass flow for a wall friction angle that does not depend on stress."""
        self.start(wall=f"angle: {phi_w} deg")
        return self.found()["cone"]["limit_deg"]["value"]

    def told(self, found, shape, words):
        return [text for text in found["warnings"] if text.startswith(shape + ": ") and words in text]

    @clod.quick_only
    def test_a_free_flowing_solid_is_mass_flow(self):
        """In all four variants: by the line, below a given half angle, by an angle, and with f_c in proportion to sigma_1."""
        for rows, wall, more in ((FREE, "file: wall.csv", BUILT), (FREE, "file: wall.csv", GIVEN),
                                 (FREE, "angle: 22 deg, error: 1 deg", BUILT), (STRAIGHT, "file: wall.csv", BUILT)):
            self.start(rows, wall)
            cone = self.found(*more)["cone"]
            self.assertIn(cone["outcome"], ("flows", "no_arch"))
            self.assertLess(cone["planned_outlet_arching_share"], 0.02)
            self.assertLess(cone["sample_shares"]["funnel_flow"], 0.02)
            # rho g B/H = 1225 9.81 0.5/2.32 = 2.59 kPa, over f_c at some 3.6 kPa, 0.1245 kPa
            self.assertAlmostEqual(cone["arching_margin"]["value"], 20.8, delta=1.5)
            self.assertLess(cone["outlet_m"]["value"], 0.5)

    @clod.quick_only
    def test_the_half_angle_is_that_at_the_outlet(self):
        """Of the friction angle at the wall of the outlet, whatever the flow function says at small stresses: the same limit as
        of a wall that has this angle at any stress. The wall there: tau_w from 1.60 kPa at 4 kPa and 0.83 at 2 kPa."""
        angles = []
        for rows in (FREE, STRAIGHT):
            self.start(rows)
            cone = self.found(*BUILT)["cone"]
            at = cone["design_state"]
            self.assertEqual(at["outlet_m"], 0.5)
            line = 830 + (at["sigma_w_Pa"] - 2000) * 0.385
            self.assertAlmostEqual(at["phi_w_deg"], hopper_case.degrees(line, at["sigma_w_Pa"]), delta=1e-6)
            angles.append(cone["half_angle_deg"]["value"])
            self.assertAlmostEqual(cone["limit_deg"]["value"], self.limit(at["phi_w_deg"]), delta=1e-3)
            self.assertAlmostEqual(angles[-1], cone["limit_deg"]["value"] - 3.0, delta=1e-9)
        self.assertAlmostEqual(angles[0], angles[1], delta=0.05)

    @clod.quick_only
    def test_the_critical_outlet_is_where_the_solid_begins_to_slide(self):
        """Where the limit of mass flow has come down to the half angle; below it the solid sticks."""
        self.start()
        cone = self.found(*BUILT)["cone"]
        self.assertTrue(cone["outlet_by_wall"])
        there, angle = cone["phi_w_deg"]["value"], cone["half_angle_deg"]["value"]
        self.assertAlmostEqual(self.limit(there), angle, delta=5e-3)
        for times, sticks in ((0.99, True), (1.01, False)):
            self.start()
            other = self.found("--set", f"cone={{half_angle: {angle} deg, outlet: {1e3 * times * cone['outlet_m']['value']} mm}}")
            self.assertEqual(other["cone"]["arching_margin"]["value"] is None, sticks)
            said = self.told(other, "Cone", "as measured the solid does not slide along the wall.")
            self.assertEqual(len(said), sticks, other["warnings"])

    def test_without_an_outlet_the_smallest_measured_stress_is_taken(self):
        self.start()
        found = self.found()
        for shape in ("cone", "wedge"):
            self.assertEqual(found[shape]["outcome"], "flows")
            self.assertAlmostEqual(found[shape]["design_state"]["sigma_1_Pa"], 3100.0, delta=1e-6)
        words = "for the smallest measured sigma_1, 3.100 kPa, and the critical outlet that of this half angle"
        self.assertEqual(len(self.told(found, "Cone", words)), 1)
        self.assertEqual(len(self.told(found, "Wedge", words)), 1)
        told = " ".join(self.hopper("case.yaml").stdout.split())
        self.assertEqual(told.count("limit and half angle: at the smallest measured stress, that of an outlet of"), 2)
        self.assertEqual(self.told(self.found(*BUILT), "Cone", "smallest measured sigma_1"), [])

    def test_an_intercept_that_decides_is_told(self):
        """A slot of 48 mm has some 0.5 kPa at its wall, half of what was measured; a cone of 500 mm has 2.8 kPa."""
        self.start(more="largest_particle: 12 mm\n")
        found = self.found(*BUILT)
        self.assertEqual(len(self.told(found, "Wedge", "the limit of mass flow " + INTERCEPT)), 1, found["warnings"])
        self.assertEqual(len(self.told(found, "Wedge", "the critical outlet " + INTERCEPT)), 1)
        self.assertEqual(self.told(found, "Cone", "the limit of mass flow " + INTERCEPT), [])
        self.start(wall="angle: 22 deg", more="largest_particle: 12 mm\n")
        self.assertNotIn(INTERCEPT, " ".join(self.found(*BUILT)["warnings"]))

    def test_a_limit_that_falls_upwards_is_told(self):
        """A wall that gets rougher with stress: 20 deg at the outlet, more above. It was measured up to 16 kPa, where it has
        26.6 deg: sigma_1 is larger there by (1 + s)/(1 + s cos 2 beta), s = sin 42 deg. By hand."""
        self.start()
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa]\n1,0.36\n4,1.46\n16,8.0\n")
        found = self.found(*BUILT)
        phi, s = math.atan(0.5), math.sin(math.radians(42))
        sigma_1 = 16 * (1 + s) / (1 + s * math.cos(phi + math.asin(math.sin(phi) / s)))
        words = f"higher in the hopper, where sigma_1 is {sigma_1:.3f} kPa, the limit of mass flow in a cone is "
        said = self.told(found, "Cone", words)
        self.assertEqual(len(said), 1, found["warnings"])
        self.assertAlmostEqual(float(said[0].partition(words)[2].split()[0]), self.limit(math.degrees(phi)), delta=0.051)
        self.start()
        self.assertEqual(self.told(self.found(*BUILT), "Cone", "higher in the hopper"), [])

    @clod.quick_only
    def test_a_line_that_meets_the_axis_below_zero(self):
        """Its intercept is -0.06 kPa: below 1 kPa the wall has the angle that it has there, and not none. An outlet whose wall
        feels less has the half angle of a wall with that angle at any stress, and so has a hopper without one."""
        least = self.limit(hopper_case.degrees(350, 1000))
        for built in (("--set", "cone={half_angle: auto, outlet: 20 mm}"),
                      ("--set", "cone={half_angle: auto, outlet: 100 mm}"), ()):
            self.start()
            self.write("wall.csv", "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n1,0.35,0.03\n2,0.76,0.03\n4,1.57,0.05\n8,3.15,0.08\n")
            cone = self.found(*built)["cone"]
            self.assertIn(cone["outcome"], ("flows", "no_arch"), built)
            self.assertAlmostEqual(cone["limit_deg"]["value"], least, delta=0.02)

    def test_flow_functions_of_no_solid(self):
        def warned(rows, more=(), case=CASE):
            hopper_case.Case.start(self, case, rows)
            return " ".join(self.found(*more)["warnings"])

        usual = "2,1.4,0.05,48,40,1250\n4,1.9,0.05,47,40,1300\n8,2.9,0.08,46,39,1350\n"
        told = warned("3.1,0.00145,0,48,38,1210\n6.2,0.0022,0,47,38,1265\n")  # Pa in place of kPa: 3100/1.45 = 2138
        self.assertIn("f_c is 0.00145 kPa at sigma_1 3.1 kPa, ffc 2138", told)
        self.assertIn("Pa under a header in kPa", told)
        self.assertNotIn("ffc", warned(FREE))  # 28 to 32
        told = warned("3.1,0.00145,0.08,48,38,1210\n6.2,0.0022,0.001,47,38,1265\n")  # the same, but for the errors
        self.assertIn("Flow function: f_c is 0.00145 kPa with a standard error of 0.08 kPa at 3.1 kPa: nothing was measured then", told)
        self.assertNotIn("nothing was measured", warned(FREE))
        single = CASE + "bulk_density: {value: 1000 kg/m3, error: 2000 kg/m3}\n"
        self.assertIn("Bulk density: rho_b is 1000 kg/m3 with a standard error of 2000 kg/m3: nothing", warned(FREE, case=single))
        told = warned("3,3,0,48,40,1250\n6,2,0,47,40,1300\n12,1,0,46,39,1350\n")
        self.assertIn("f_c falls from 3 kPa at sigma_1 3 kPa to 2 kPa at 6 kPa", told)
        self.assertIn("f_c falls from 2 kPa at sigma_1 6 kPa to 1 kPa at 12 kPa", told)
        self.assertNotIn("falls", warned("2,1.4,0.05,48,40,1250\n4,1.35,0.05,47,40,1300\n8,2.9,0.08,46,39,1350\n"))
        silo = CASE + "silo: {diameter: 0.1 m, height: 1 m}\n"
        told = warned(usual, ("--set", "cone.outlet=500 mm"), silo)
        self.assertIn("Cone: the outlet that is given, 500 mm, is wider than the silo, 100 mm", told)
        self.assertRegex(warned(usual, (), silo), "Cone: the critical outlet, [0-9.]+ mm, is wider than the silo, 100 mm")
        self.assertNotIn("wider than the silo, ", warned(usual, ("--set", "cone.outlet=500 mm"), silo.replace("0.1", "3")))
        self.assertIn("Cone: the outlet by particles, 104 mm, is wider than the silo, 100 mm", warned(FREE, (), silo + "largest_particle: 13 mm\n"))

    def test_friction_that_may_rise_below_the_measured_stresses_is_told(self):
        """phi_e falls by 3 deg/kPa from 46 deg at 4 kPa, and is held at 46 deg below: 52 deg at 2 kPa if it goes on. The limit is
        then that of a solid with that phi_e at all stresses."""
        rows = "4,1.2,0.05,{},30,1250\n8,2.4,0.05,{},30,1300\n16,4.0,0.08,{},30,1350\n"
        built = ("--set", "cone={half_angle: auto, outlet: 250 mm}")
        words = "phi_e rises towards small stresses"
        self.start(rows.format(46, 34, 33), "angle: 12 deg")
        found = self.found(*built)
        sigma_1, held = 1e-3 * found["cone"]["design_state"]["sigma_1_Pa"], found["cone"]["limit_deg"]["value"]
        self.assertLess(sigma_1, 2.5)
        on = 46 + 3 * (4 - sigma_1)
        self.start(rows.format(on, on, on), "angle: 12 deg")
        constant = self.found(*built)
        limit = constant["cone"]["limit_deg"]["value"]
        self.assertLess(limit, held - 0.5)
        self.assertEqual(self.told(constant, "Cone", words), [])
        said, = self.told(found, "Cone", words)
        self.assertIn("to 46.0 deg at the smallest measured sigma_1, 4.000 kPa, and is held there below it", said)
        self.assertIn(f"it is {on:.1f} deg at {sigma_1:.3f} kPa", said)
        self.assertIn(f"{limit:.1f} deg in place of {held:.1f} deg", said)
        self.assertIn(f"stay below {limit - 3:.1f} deg", said)
        for steep_or_wide in ("half_angle: 10 deg, outlet: 250 mm", "half_angle: auto, outlet: 1500 mm"):  # of stresses that were measured
            self.start(rows.format(46, 34, 33), "angle: 12 deg")
            self.assertEqual(self.told(self.found("--set", f"cone={{{steep_or_wide}}}"), "Cone", words), [])

    @clod.quick_only
    def test_funnel_flow_says_why(self):
        """A wall whose angle rises with stress, from 9 to 28 deg, and a strong solid: 30 deg slide at an outlet of 30 mm,
        but not at 16 kPa, the largest that was measured. There sigma_w = sigma_1 (1 + s cos 2 beta)/(1 + s), by hand."""
        s = math.sin(math.radians(46))
        phi = math.radians(25)
        for _ in range(200):
            double_beta = phi + math.asin(math.sin(phi) / s)
            sigma_w = 16 * (1 + s * math.cos(double_beta)) / (1 + s)
            phi = math.atan((4.2 + 0.6 * (sigma_w - 8)) / sigma_w)
        rows = "2,1.4,0.05,48,40,1250\n4,2.6,0.05,47,40,1300\n8,4.6,0.08,46,39,1350\n16,8.0,0.08,46,39,1350\n"
        self.start(rows, more="cone: {half_angle: 30 deg, outlet: 30 mm}\n")
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa]\n0.5,0.08\n1,0.16\n2,0.5\n4,1.8\n8,4.2\n")
        told = " ".join(self.hopper("case.yaml").stdout.split("Wedge")[0].split())
        self.assertIn("why: at the outlet of 30.0 mm, sigma_1 of 0.2", told)
        self.assertIn("kPa, the solid slides; at larger stresses above it, sigma_1 of 16.000 kPa, it does not: the wall "
                      f"friction angle is {math.degrees(phi):.1f} deg", told)
        self.start(rows, "angle: 60 deg")
        told = " ".join(self.hopper("case.yaml").stdout.split())
        self.assertEqual(told.count("why: where sigma_1 is 16.000 kPa, phi_e 46.0 deg, and the solid slides at no half angle"), 2)
        self.start()
        self.assertNotIn("why:", self.hopper("case.yaml").stdout)

    def test_a_page_without_a_rathole_says_why(self):
        """phi_t of 25 deg is outside 30 to 70 deg, where Jenike's G is known."""
        self.start(FREE.replace(",38,", ",25,").replace("37.5", "25").replace(",37,", ",25,"),
                   more="silo: {diameter: 3 m, height: 8 m}\n")
        self.hopper("case.yaml", "-o", "design")
        with open(self.path("design.html")) as file:
            page = file.read()
        part = page[page.index("Rathole, if it is funnel flow"):page.index('id="figures"')]
        self.assertEqual(part.count('class="card"'), 0)
        for when in ("emptying", "after filling"):
            self.assertIn(f"<p>No rathole diameter, {when}: ", part)


if __name__ == "__main__":
    clod.unittest.main()
