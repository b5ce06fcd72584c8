"""Pages of shear tests: what was read from the curves and how well it is known, lines of the yield locus, a laboratory's density."""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod

# The circle of steady flow has its centre at 10 kPa and a radius of 6 kPa. A line of 30 deg touches it at 10 - 6/2 = 7 kPa and
# begins at c = 6/cos 30 - 10 tan 30 = 1.1547 kPa; that of phi_e, whose sine is 0.6, at 10 (1 - 0.36) = 6.4 kPa.
COHESION, SLOPE = 1e3 * (6 / math.cos(math.radians(30)) - 10 * math.tan(math.radians(30))), math.tan(math.radians(30))
LOCUS = {"sigma_p_Pa": pages.value(12000.0, 0.0), "tau_p_Pa": pages.value(5500.0, 250.0), "c_Pa": pages.value(COHESION, 100.0),
         "phi_lin_deg": pages.value(30.0, 1.0), "phi_e_deg": pages.value(math.degrees(math.asin(0.6)), 1.0), "flow": "cohesive",
         "steady_circle": {"centre_Pa": 10000.0, "radius_Pa": 6000.0}, "unconfined_circle": {"centre_Pa": 2000.0, "radius_Pa": 2000.0},
         "rho_b_kg_m3": pages.value(1206.4, None), "rho_inside_kg_m3": pages.value(1380.7, None), "errors_from": "fit", "seed_count": 1,
         "points": [{"seed": 1, "sigma_s_Pa": 3000.0, "tau_s_Pa": 3000.0, "tau_s_error_Pa": 120.0, "prorated_Pa": 3300.0, "line_Pa": 2886.75},
                    {"seed": 1, "sigma_s_Pa": 6000.0, "tau_s_Pa": 4400.0, "tau_s_error_Pa": None, "prorated_Pa": 4840.0, "line_Pa": 4618.8}]}
PARTS = [{"part": "preshear", "seed": 1, "flags": [], "shear_stress_Pa": 5500.0, "displacement_m": 0.012, "normal_stress_Pa": 12000.0},
         {"part": "reverse", "seed": 1, "flags": []},
         {"part": "point-1", "seed": 1, "flags": [], "shear_stress_Pa": 3000.0, "displacement_m": 0.004, "normal_stress_Pa": 3000.0},
         {"part": "point-2", "seed": 1, "flags": ["no peak"], "shear_stress_Pa": 4400.0, "displacement_m": 0.007, "normal_stress_Pa": 6000.0}]
# of the laboratory: its line is 1 kPa + 0.6 sigma
LAB = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n12,7,3,2.8,1410\n12,7,5,4.1,1410\n12,7,8,5.8,1410\n"


class Shear(pages.PageCase):

    def ring(self, name, parts=PARTS, **changes):
        pages.write(self.path(name), summary__json={"title": "Ring", "version": "clod 9", "parts": parts, "locus": {"loci": [{**LOCUS, **changes}]}},
                    report__txt="all of it\n", preshear__csv=pages.SLIP,
                    **{f"point_HYPHEN_{k}__csv": pages.SLIP for k in (1, 2)},
                    **{"case_HYPHEN_complete__yaml": pages.COMPLETE % ("Ring", "2500") + "ring_shear:\n  seeds: 1\n"})

    def lab(self):
        with open(self.path("lab.csv"), "w") as file:
            file.write(LAB)

    def test_density_of_a_laboratory(self):
        """It is compared with that away from the cell's walls, which is the card too; where the run has none, the page says so."""
        self.lab()
        for inside, row in ((1380.7, ["1380.7", "1410.0"]), (None, None)):
            self.ring("ring", rho_inside_kg_m3=pages.value(inside, None))
            self.made("report", "ring", "--lab", "lab.csv")
            page = self.page("ring/report.html")
            captions = [caption for *_, caption in pages.cards(page.text)]
            self.assertEqual(any("away from walls" in caption for caption in captions), inside is not None)
            self.assertEqual(page.row("bulk density [kg/m³]")[2:], ["1206.4", "-" if inside else "1410.0"])
            told = " ".join(" ".join(page.words).split())
            if inside:
                self.assertEqual(page.row("bulk density away from walls [kg/m³]")[2:], row)
                self.assertIn("The laboratory's bulk density stands beside ρ inside", told)
            else:
                self.assertIn("do not compare it with the laboratory's", told)
            self.made("report", "ring")
            self.assertNotIn("laboratory's", " ".join(self.page("ring/report.html").words))

    def test_density_of_a_laboratory_beside_runs(self):
        self.lab()
        self.ring("one")
        self.ring("two", rho_inside_kg_m3=pages.value(1390.5, None))
        self.made("compare", "one", "two", "--lab", "lab.csv")
        page = self.page("compare.html")
        self.assertEqual(page.row("bulk density away from walls [kg/m³]")[2:], ["1380.7", "1390.5", "1410.0"])
        self.assertEqual(page.row("bulk density [kg/m³]")[2:], ["1206.4", "1206.4", "-"])
        self.assertIn("The laboratory's bulk density stands beside", " ".join(page.words))


if __name__ == "__main__":
    clod.unittest.main()
