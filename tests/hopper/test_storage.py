"""A solid that was stored at rest: its strength and static friction angle from time yield loci, everything else as it flows."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import CASE, FLOW, clod

STORED = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_t [deg]\n"
DAY = "2,2.0,0.05,44\n4,2.7,0.05,43\n8,4.1,0.08,42\n"
MERGED = "2,2.0,0.05,48,44,1250\n4,2.7,0.05,47,43,1300\n8,4.1,0.08,46,42,1350\n"  # f_c and phi_t of DAY, the rest of ROWS
AFTER = ("--set", "flow_function.after_storage=day.csv")
BUILT = "cone: {half_angle: 15 deg, outlet: 500 mm}\nwedge: {half_angle: 15 deg}\nsilo: {diameter: 3 m, height: 8 m}\n"


class Storage(hopper_case.Case):

    def stored(self, rows=DAY, *more):
        self.write("day.csv", STORED + rows)
        return self.found(*AFTER, *more)

    def test_strength_and_static_angle_are_those_after_storage(self):
        """As if they had stood in the flow function, beside the sigma_1, phi_e and density of the solid that flows."""
        self.start(CASE + BUILT)
        stored = self.stored()
        self.start(CASE + BUILT, MERGED)
        merged = self.found()
        for shape in ("cone", "wedge"):
            for key, told in stored[shape].items():
                if isinstance(told, dict) and "value" in told:
                    self.assertEqual(told["value"], merged[shape][key]["value"], (shape, key))
        for key, told in stored["rathole"].items():
            if isinstance(told, dict) and "value" in told:
                self.assertEqual(told["value"], merged["rathole"][key]["value"], key)
        self.assertEqual(os.path.basename(stored["after_storage"]), "day.csv")
        self.assertIsNone(merged["after_storage"])

    def test_outlet_by_hand(self):
        """One phi_e, one wall angle and a given half angle have one ff, and the strength after storage is 1.3 kPa + 0.35 sigma_1, so
        it meets sigma_1/ff at f_c = 1.3/(1 - 0.35 ff), and the outlet is f_c H/(rho g), H = (130 + 15)/65."""
        case = CASE + BUILT + "effective_friction: {angle: 48 deg}\nbulk_density: {value: 1300 kg/m3}\n"
        self.start(case)
        plain, stored = self.found()["cone"], self.stored()["cone"]
        ff = plain["flow_factor"]["value"]
        self.assertAlmostEqual(stored["flow_factor"]["value"], ff, delta=1e-6)
        outlet = 1300 / (1 - 0.35 * ff) * 145 / 65 / (1300 * 9.80665)
        self.assertAlmostEqual(stored["outlet_m"]["value"] / outlet, 1.0, delta=1e-4)
        self.assertGreater(outlet, 1.5 * plain["outlet_m"]["value"])

    def test_static_friction_of_its_own_stays(self):
        self.start(CASE + BUILT + "static_friction: {angle: 35 deg}\n")
        self.assertEqual(self.stored()["measured"]["phi_t"][0]["phi_t_deg"], self.found()["measured"]["phi_t"][0]["phi_t_deg"])

    def test_strength_that_falls_by_storage_is_told(self):
        words = "No solid gets weaker by storage"
        self.start(CASE + BUILT)
        told = self.stored("2,1.0,0.05,44\n4,1.9,0.05,43\n8,4.1,0.08,42\n")["warnings"]
        self.assertEqual([text.startswith("After storage: f_c is 1 kPa at sigma_1 2 kPa, where it is 1.4") for text in told if words in text],
                         [True])
        self.assertEqual([text for text in self.stored()["warnings"] if words in text], [])

    def test_after_shear_tests_of_several_specimens(self):
        """Strength has no specimens then, and what else they share still has."""
        rows = "".join(f"{seed},{p},{t + 0.02 * seed},{s},{y + 0.02 * seed},{1250 + 5 * seed}\n" for seed in (1, 2, 3)
                       for p, t, points in ((2.4, 1.8, ((0.6, 0.9), (1.2, 1.25), (1.8, 1.6))), (1.2, 0.9, ((0.3, 0.5), (0.6, 0.65), (0.9, 0.8))))
                       for s, y in points)
        self.write("shear.csv", "seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n" + rows)
        self.write("case.yaml", "flow_function: {shear_tests: [{points: shear.csv}]}\nwall_friction: {angle: 20 deg, error: 1 deg}\n")
        plain = self.found()
        stored = self.stored("1.5,2.0,0.05,44\n5,3.7,0.05,43\n")
        self.assertEqual(len(plain["specimens"]), 3)
        self.assertEqual(stored["specimens"], [])
        self.assertEqual(stored["measured"]["phi_e"], plain["measured"]["phi_e"])
        self.assertGreater(stored["cone"]["outlet_m"]["value"], plain["cone"]["outlet_m"]["value"])

    def test_what_it_says(self):
        self.start(CASE + BUILT)
        self.write("day.csv", STORED + DAY)
        told = self.hopper("case.yaml", *AFTER, "-o", "design").stdout
        self.assertIn("After storage: f_c of ", told.splitlines()[2])
        with open(self.path("design.html")) as file:
            self.assertIn("flow function after storage", file.read())

    def test_bad_tables(self):
        self.start(CASE + BUILT)
        done = self.hopper("case.yaml", *AFTER, code=2)
        self.assertIn("day.csv", done.stderr)
        self.write("day.csv", "sigma_1 [kPa],phi_t [deg]\n2,44\n")
        self.assertIn("f_c", self.hopper("case.yaml", *AFTER, code=2).stderr)
        self.write("day.csv", STORED + "2,2.0,0.05,44\n")
        self.assertIn("measure at two consolidation stresses", self.hopper("case.yaml", *AFTER, code=2).stderr)


if __name__ == "__main__":
    clod.unittest.main()
