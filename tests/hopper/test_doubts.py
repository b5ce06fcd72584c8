"""Measured properties that no solid has are warned of, and those that errors allow are not: by hand."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import CASE, ROWS, clod

HEAD = ("sigma_1 [kPa],sigma_1_error [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],phi_e_error [deg],phi_t [deg],"
        "rho_b [kg/m3],rho_b_error [kg/m3]\n")


class Doubts(hopper_case.Case):

    def told(self, *rows, words, more="", arguments=()):
        """Warnings that have these words."""
        self.write("flow.csv", HEAD + "".join(f"{row}\n" for row in rows))
        self.write("case.yaml", CASE + more)
        return [text for text in self.found(*arguments)["warnings"] if words in text]

    def test_strengths_above_those_of_a_straight_locus_with_that_angle(self):
        """sin 30 is 1/2, and 2 (1/2)/(1 + 1/2) is 2/3: at most 2 kPa at 3 kPa. Without errors 1 % is allowed."""
        words = "no straight yield locus has more"

        def strength(f_c, errors=(0, 0, 0), **more):
            sigma_1_error, f_c_error, phi_e_error = errors
            return self.told(f"3,{sigma_1_error},{f_c},{f_c_error},30,{phi_e_error},28,1250,0",
                             "12,0,4,0,30,0,28,1350,0", words=words, **more)

        self.assertEqual(strength(2.019), [])
        told = strength(2.03)
        self.assertEqual(len(told), 1)
        self.assertIn("Flow function: f_c is 2.03 kPa at sigma_1 3 kPa, where phi_e is 30 deg: no straight yield locus "
                      "has more than sigma_1 2 sin(phi_e)/(1 + sin(phi_e)), 2 kPa", told[0])
        # two of 0.3 kPa
        self.assertEqual(strength(2.59, (0, 0.3, 0)), [])
        self.assertEqual(len(strength(2.61, (0, 0.3, 0))), 1)
        # two of 2/3 of 0.3 kPa
        self.assertEqual(strength(2.39, (0.3, 0, 0)), [])
        self.assertEqual(len(strength(2.41, (0.3, 0, 0))), 1)
        # two of 3 kPa 2 cos 30/(3/2)^2 = 2.3094 kPa/rad, times 5 deg: 0.2015 kPa
        self.assertEqual(strength(2.39, (0, 0, 5)), [])
        self.assertEqual(len(strength(2.42, (0, 0, 5))), 1)
        # strength above sigma_1 has words of its own
        self.assertEqual(strength(3.1), [])
        # an angle of its own: sin 50 is 0.76604, and 3 kPa 1.53209/1.76604 is 2.603 kPa
        self.assertEqual(strength(2.6, more="effective_friction: {angle: 50 deg}\n"), [])
        self.assertEqual(len(strength(2.64, more="effective_friction: {angle: 50 deg}\n")), 1)

    def test_the_worst_of_several_strengths_is_told(self):
        """2.5 kPa are 1.25 times the 2 kPa that are possible at 3 kPa, which the error allows; 5 of 4 kPa and 6.4 of 4.33 kPa are
        1.25 and 1.48 times, by more than the errors."""
        told = self.told("3,0,2.5,1,30,0,28,1250,0", "6,0,5,0.1,30,0,28,1260,0", "6.5,0,6.4,0.1,30,0,28,1270,0",
                         words="no straight yield locus has more")
        self.assertEqual(len(told), 1)
        self.assertIn("f_c is 6.4 kPa at sigma_1 6.5 kPa", told[0])

    def test_strength_after_storage_may_be_larger(self):
        """Its sigma_1 and phi_e are those of the solid that flows, so nothing bounds it."""
        rows = ("3,0,1,0,30,0,28,1250,0", "12,0,3,0,30,0,28,1350,0")
        self.write("day.csv", "sigma_1 [kPa],f_c [kPa]\n3,2.5\n12,6\n")
        after = ("--set", "flow_function.after_storage=day.csv")
        self.assertEqual(self.told(*rows, words="no straight yield locus", arguments=after), [])
        self.assertEqual(len(self.told("3,0,2.5,0,30,0,28,1250,0", "12,0,6,0,30,0,28,1350,0",
                                       words="no straight yield locus")), 1)

    def test_effective_angles_that_no_bulk_solid_has(self):
        words = "Effective friction: phi_e is"

        def angles(low, high, more=""):
            return self.told(f"3,0,0.1,0,{low},0,,1250,0", f"12,0,0.2,0,{high},0,,1350,0", words=words, more=more)

        self.assertEqual(angles(20.1, 21), [])
        told = angles(21, 19.9)
        self.assertEqual(len(told), 1)
        self.assertIn("phi_e is 19.9 deg at sigma_1 12 kPa. Bulk solids have 25 to 70 deg", told[0])
        told = angles(0.83, 0.80)  # rad
        self.assertEqual(len(told), 1)
        self.assertIn("phi_e is 0.8 deg at sigma_1 12 kPa. Bulk solids", told[0])
        self.assertIn("rad under a header in deg", told[0])
        told = angles(40, 40, "effective_friction: {angle: 15 deg}\n")
        self.assertEqual(len(told), 1)
        self.assertIn("phi_e is 15 deg. Bulk solids", told[0])

    def test_densities_that_fall_with_consolidation(self):
        """1 % of 1300 kg/m3 is 13; two of hypot(15, 20) = 25 kg/m3 are 50."""
        words = "Bulk density: rho_b falls"

        def densities(low, high, errors=(0, 0)):
            return self.told(f"3,0,1,0,48,0,38,{low},{errors[0]}", f"12,0,3,0,48,0,38,{high},{errors[1]}", words=words)

        self.assertEqual(densities(1300, 1288), [])
        told = densities(1300, 1286)
        self.assertEqual(len(told), 1)
        self.assertIn("rho_b falls from 1300 kg/m3 at sigma_1 3 kPa to 1286 kg/m3 at 12 kPa, by more than its errors "
                      "tell. No solid gets looser by consolidation", told[0])
        self.assertEqual(densities(1300, 1251, (15, 20)), [])
        self.assertEqual(len(densities(1300, 1249, (15, 20))), 1)
        self.assertEqual(densities(1210, 1350), [])
        self.assertEqual(len(self.told(*("3,0,1,0,48,0,38,1210,0", "6,0,2,0,48,0,38,1265,0", "12,0,3,0,48,0,38,900,0"),
                                       words="rho_b falls from 1265 kg/m3 at sigma_1 6 kPa to 900 kg/m3 at 12 kPa")), 1)

    def test_stresses_and_angles_in_other_units(self):
        """3 and 12 kPa under a header in MPa or Pa, wall stresses of kPa under one in Pa, and an angle that hardly a wall has."""
        usual = "3,0,1,0,48,0,38,1250,0", "12,0,3,0,48,0,38,1350,0"
        large = "3000,0,1000,0,48,0,38,1250,0", "12000,0,3000,0,48,0,38,1350,0"
        words = "Flow function: all its sigma_1 are above 1 MPa"
        self.assertEqual(len(self.told(*large, words=words)), 1)
        self.assertEqual(self.told(*usual, words=words), [])

        def walls(unit, words):
            self.write("wall.csv", f"sigma_w [{unit}],tau_w [{unit}]\n1,0.3\n4,1.2\n16,4.8\n")
            self.write("flow.csv", HEAD + "".join(f"{row}\n" for row in usual))
            self.write("case.yaml", "flow_function: {file: flow.csv}\nwall_friction: {file: wall.csv}\n")
            return [text for text in self.found()["warnings"] if words in text]

        self.assertEqual(len(walls("Pa", "Wall friction: all its sigma_w are below 100 Pa, less than testers can do")), 1)
        self.assertEqual(len(walls("MPa", "Wall friction: sigma_w of 1000 to 1.6e+04 kPa lie far from sigma_1 of the flow function, 3 to 12 kPa")), 1)
        self.assertEqual(walls("kPa", "Wall friction: "), [])
        told = self.told(*usual, words="Wall friction: the angle", arguments=("--set", "wall_friction={angle: 2.9 deg}"))
        self.assertEqual(len(told), 1)
        self.assertIn("the angle is 2.9 deg. The smoothest liners have some 6 deg", told[0])

    def test_mass_flow_that_half_of_the_samples_do_not_have(self):
        """A wall of 41 deg, the limit of a solid whose phi_e is 48 deg, with an error of 5 deg: the mean slides, samples beyond do not."""
        rows = "3,0,1,0,48,0,38,1250,0", "12,0,3,0,48,0,38,1350,0"
        told = self.told(*rows, words="mass flow is what the means of the measured properties say",
                         arguments=("--set", "wall_friction={angle: 36 deg, error: 5 deg}"))
        self.assertTrue(told)
        self.assertRegex(told[0], r"Samples: .*[0-9.]+ % in funnel flow")
        self.assertEqual(self.told(*rows, words="mass flow is what the means"), [])

    def test_a_half_angle_of_zero_is_not_auto(self):
        self.refuse(CASE + "cone: {half_angle: 0 deg}\n", ["cone.half_angle", "above 0"])

    def test_a_usual_solid_has_none_of_these(self):
        self.start(CASE, ROWS)
        for text in self.found()["warnings"]:
            for words in ("no straight yield locus", "Effective friction: ", "falls from", "Wall friction: ", "mass flow is what"):
                self.assertNotIn(words, text)


    def test_sections_that_replace_columns(self):
        rows = ("3,0,1,0,50,0,40,1250,0", "12,0,3,0,48,0,39,1350,0")
        self.assertEqual(self.told(*rows, words="replaces"), [])
        told = self.told(*rows, words="replaces", more="bulk_density: {value: 900 kg/m3}\nstatic_friction: {angle: 38 deg}\n"
                         "effective_friction: {angle: 49 deg}\n")
        for key, column in (("bulk_density", "rho_b"), ("static_friction", "phi_t"), ("effective_friction", "phi_e")):
            found = [text for text in told if text.startswith(f"{key} replaces the column {column} of ")
                     and text.endswith("flow.csv.")]
            self.assertEqual(len(found), 1, told)
        measured = self.found()["measured"]
        self.assertEqual([point["rho_b_kg_m3"] for point in measured["rho_b"]], [900.0])
        self.write("flow.csv", "sigma_1 [kPa],f_c [kPa],phi_e [deg]\n3,1,50\n12,3,48\n")
        self.write("case.yaml", CASE + "bulk_density: {value: 900 kg/m3}\nstatic_friction: {angle: 38 deg}\n")
        self.assertEqual([text for text in self.found()["warnings"] if "replaces" in text], [])
        self.write("day.csv", "sigma_1 [kPa],f_c [kPa],phi_t [deg]\n3,1.5,44\n12,4,43\n")
        told = self.found("--set", "flow_function.after_storage=day.csv")["warnings"]
        self.assertTrue([text for text in told if "static_friction replaces the column phi_t of " in text
                         and "day.csv" in text], told)

    def test_a_wall_friction_angle_is_doubted_as_an_angle(self):
        rows = ("3,0,1,0,50,0,40,1250,0", "12,0,3,0,48,0,39,1350,0")
        wall = ("--set", "wall_friction={angle: 5 deg, error: 10 deg}")
        self.assertEqual(self.told(*rows, words="tau_w", arguments=wall), [])
        told = self.told(*rows, words="Wall friction: the angle is 5 deg with a standard error of 10 deg", arguments=wall)
        self.assertEqual(len(told), 1)

    def test_densities_that_hardly_a_bulk_solid_has(self):
        """0.64 of 7850 kg/m3 is 5024."""
        words = "Bulk density: rho_b is"
        self.assertEqual(self.told("3,0,1,0,50,0,40,4900,0", "12,0,3,0,48,0,39,5020,0", words=words), [])
        told = self.told("3,0,1,0,50,0,40,4900,0", "12,0,3,0,48,0,39,12100,0", words=words)
        self.assertEqual(len(told), 1)
        self.assertIn("12100 kg/m3 at sigma_1 12 kPa", told[0])


if __name__ == "__main__":
    clod.unittest.main()
