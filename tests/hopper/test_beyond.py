"""What clod hopper says of stresses outside what was measured: at outlets, at their walls, and about ratholes."""

import math
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import clod

# f_c = 0.5 kPa + 0.2 sigma_1 of 2 to 8 kPa, and a wall of tan 20 deg, measured at 1.5 to 6 kPa
ROWS = "2,0.9,0.05,48,40,1250\n4,1.3,0.05,47,40,1300\n8,2.1,0.08,46,39,1350\n"
CASE = "flow_function: {file: flow.csv}\nwall_friction: {file: wall.csv}\n"
WALL = "sigma_w [kPa],tau_w [kPa]\n1.5,0.54596\n6,2.18382\n"
STRESSES = "outside what was measured, 2.000 to 8.000 kPa: an extrapolation."
WALLS = "outside what was measured, 1.500 to 6.000 kPa: an extrapolation."


class Beyond(hopper_case.Case):

    def beyond(self, *arguments, more=""):
        self.start(CASE + more, ROWS)
        self.write("wall.csv", WALL)
        found = self.found(*arguments)
        return found, [text for text in found["warnings"] if "extrapolation" in text or "times the largest" in text]

    def mine(self, told, name, words):
        return [text for text in told if text.startswith(name + ": ") and words in text]

    def test_the_outlet_that_is_given_beside_the_critical_one(self):
        """The critical state is below 2 kPa; sigma_1 at 2 m, 26 kPa of solid above 1 m/tan(theta), is beyond 8."""
        found, told = self.beyond("--set", "cone.outlet=2 m")
        cone = found["cone"]
        critical, built = cone["sigma_1_Pa"]["value"], cone["design_state"]["sigma_1_Pa"]
        self.assertTrue(critical < 1980.0 and 8080.0 < built < 80e3, (critical, built))
        self.assertEqual(self.mine(told, "Cone", STRESSES),
                         [f"Cone: at the critical outlet sigma_1 is {1e-3 * critical:.3f} kPa, and at the outlet of 2000 mm "
                          f"{1e-3 * built:.3f} kPa, {STRESSES}"])
        wall = cone["design_state"]["sigma_w_Pa"]
        self.assertTrue(wall > 6060.0)
        self.assertEqual(len(self.mine(told, "Cone", WALLS)), 1, told)
        self.assertIn(f"at the outlet of 2000 mm {1e-3 * wall:.3f} kPa", self.mine(told, "Cone", WALLS)[0])
        self.assertEqual(self.mine(told, "Cone", "times the largest"), [])

    def test_inside_nothing_is_said_of_it(self):
        found, told = self.beyond("--set", "cone.outlet=600 mm")
        self.assertTrue(2e3 < found["cone"]["design_state"]["sigma_1_Pa"] < 8e3)
        self.assertEqual([text for text in told if "600 mm" in text], [])

    def test_a_length_in_another_unit(self):
        """80 m for 80 mm: stresses are as the outlet, so far beyond ten times 8 kPa."""
        found, told = self.beyond("--set", "wedge.outlet=80 m")
        times = found["wedge"]["design_state"]["sigma_1_Pa"] / 8e3
        self.assertGreater(times, 10.0)
        self.assertIn(f"Wedge: at the outlet of 80000 mm sigma_1 is {times:.0f} times the largest that was measured. Is the unit of the "
                      "outlet another one?", told)

    def test_an_outlet_below_the_critical_one(self):
        """Its stress is that of (5) in docs/theory/hopper.md at the half angle of the critical one: as the outlets, but for rho_b, which is
        held below 2 kPa as phi_e and the wall friction angle are."""
        found, told = self.beyond()
        cone = found["cone"]
        length, critical = 0.9 * cone["outlet_m"]["value"], cone["sigma_1_Pa"]["value"]
        _, told = self.beyond("--set", f"cone.outlet={1e3 * length} mm")
        said, = self.mine(told, "Cone", STRESSES)
        stress = re.search(r"and at the outlet of [0-9.]+ mm ([0-9.]+) kPa", said)
        self.assertTrue(stress, said)
        self.assertAlmostEqual(float(stress[1]), 0.9e-3 * critical, delta=2e-3)

    def test_a_slot_in_funnel_flow(self):
        """f_c = 0.5 kPa + 0.2 sigma_1 meets sigma_1/1.7 at 1.2879 kPa, below 2; the wedge's own state is lower still."""
        _, told = self.beyond()
        self.assertTrue(self.mine(told, "Wedge", STRESSES)[0].endswith(f", and for a slot in funnel flow {0.5 / (1 / 1.7 - 0.2):.3f} kPa, {STRESSES}"),
                        told)
        _, told = self.beyond("--set", "wall_friction={angle: 60 deg}")
        self.assertEqual(self.mine(told, "Wedge", STRESSES), [f"Wedge: for a slot in funnel flow sigma_1 is 1.288 kPa, {STRESSES}"])

    def test_one_density_of_a_table(self):
        """Held at all stresses, as is that of several rows below the smallest; a value is of no stress."""
        density = "bulk_density: {file: rho.csv}\n"
        self.write("rho.csv", "sigma_1 [kPa],rho_b [kg/m3]\n8,1350\n")
        for more, many in ((density, 1), ("bulk_density: {value: 1350 kg/m3}\n", 0)):
            found, _ = self.beyond(more=more)
            self.assertEqual(found["cone"]["rho_b_kg_m3"]["value"], 1350.0)
            said = [text for text in found["warnings"] if text.startswith("Bulk density: ")]
            self.assertEqual(len(said), many)
            for text in said:
                self.assertIn("below the smallest at which it was measured, 8.000 kPa, whose 1350 kg/m3 is taken there", text)

    def test_ratholes(self):
        found, told = self.beyond("--set", "silo={diameter: 3 m, height: 8 m}")
        filling = found["rathole"]["filling_stress_Pa"]
        self.assertGreater(filling, 8080.0)
        said, = self.mine(told, "Rathole", STRESSES)
        self.assertIn(f"after filling {'' if 'as it empties' in said else 'sigma_1 is '}{1e-3 * filling:.3f} kPa", said)
        # as it empties: f_c = 0.5 kPa + 0.2 sigma_1 meets sigma_1/ff_p, ff_p = (1 + s)/(4 s) G, of phi_e 48 and phi_t 40 deg
        s = math.sin(math.radians(48.0))
        g = -6.86712 + 40.0 * (0.58911 + 40.0 * (-0.012966 + 40.0 * 1.1939e-4))
        stress = 0.5 / (4.0 * s / ((1.0 + s) * g) - 0.2)
        _, told = self.beyond()
        said = [re.match(r"Rathole: as it empties sigma_1 is ([0-9.]+) kPa, outside", text) for text in told if text.startswith("Rathole")]
        self.assertEqual(len(said), 1, told)
        self.assertAlmostEqual(float(said[0][1]), stress, delta=2e-3)


if __name__ == "__main__":
    clod.unittest.main()
