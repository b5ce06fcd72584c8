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

    def test_how_a_point_was_read(self):
        """Marks on the curves at the displacement and stress of the summary; errors and what had no peak in the table."""
        self.ring("ring")
        self.made("report", "ring")
        page = self.page("ring/report.html")
        rows = [table for table in page.tables if table[0][0] == "shear points [kPa]"][0]
        self.assertEqual(rows[1:], [["simulation, point-1", "12.000", "3.000", "3.00 ± 0.12", "3.30 ± 0.13", "2.887", ""],
                                    ["simulation, point-2", "12.000", "6.000", "4.400", "4.840", "4.619", "no peak"]])
        failure = page.figures["Shear-stress--shear-to-failure"]["curves"]
        self.assertEqual([(curve["name"], curve["style"]) for curve in failure],
                         [("point-1", "line"), ("point-2", "line"), ("", "read"), ("", "vague")])
        self.assertEqual([(curve["x"], curve["y"]) for curve in failure[2:]], [(["0.004"], ["3000"]), (["0.007"], ["4400"])])
        self.assertEqual([curve["colour"] for curve in failure[:2]], [curve["colour"] for curve in failure[2:]])
        self.assertEqual((failure[2]["error"], failure[3].get("error")), (["120"], None))
        line, mark = page.figures["Shear-stress--preshear"]["curves"]
        self.assertEqual((mark["x"], mark["y"], mark["error"], mark["style"]), (["0.012"], ["5500"], ["250"], "read"))
        self.assertIn("Marks: peak of the smoothed curve, or shear stress with which preshear ended", " ".join(page.words))
        self.assertEqual(len(page.figures["Height-of-the-specimen--preshear"]["curves"]), 1)
        self.ring("ring", [{**PARTS[0], "flags": ["not steady"]}] + PARTS[1:])
        self.made("report", "ring")
        self.assertEqual(self.page("ring/report.html").figures["Shear-stress--preshear"]["curves"][1]["style"], "vague")

    def test_errors_of_points_in_an_older_folder(self):
        """Its summary.json has none of them, but points.csv has."""
        bare = [{key: value for key, value in point.items() if key != "tau_s_error_Pa"} for point in LOCUS["points"]]
        self.ring("ring", points=bare)
        for text, shown in (("", ["3.000", "4.400"]), ("1,12000,5500,3000,3000,120\n1,12000,5500,6000,4400,\n", ["3.00 ± 0.12", "4.400"])):
            with open(self.path("ring/points.csv"), "w") as file:
                file.write("seed,sigma_pre [Pa],tau_pre [Pa],sigma_sh [Pa],tau_sh [Pa],tau_sh_error [Pa]\n" + text)
            self.made("report", "ring")
            rows = [table for table in self.page("ring/report.html").tables if table[0][0] == "shear points [kPa]"][0]
            self.assertEqual([row[3] for row in rows[1:]], shown)

    def test_lines_of_a_yield_locus(self):
        """Solid up to the circle of steady flow, dotted from there to preshear; the effective one thin; bars: 3300/3000 of 120 Pa."""
        self.ring("ring")
        self.made("report", "ring")
        line, points, preshear, steady, unconfined, beyond, effective = self.page("ring/report.html").figures["yield-locus"]["curves"]
        self.assertEqual([curve["style"] for curve in (line, points, preshear, steady, unconfined, beyond, effective)],
                         ["line", "points", "points", "line", "line", "dotted", "thin"])
        for curve, ends in ((line, (0.0, 7e3)), (beyond, (7e3, 12e3))):
            for x, y, end in zip(curve["x"], curve["y"], ends):
                self.assertAlmostEqual(float(x), end, delta=1e-6)
                self.assertAlmostEqual(float(y), COHESION + SLOPE * end, delta=1e-6)
        self.assertEqual((effective["x"][0], effective["y"][0]), ("0", "0"))
        self.assertAlmostEqual(float(effective["y"][1]) / float(effective["x"][1]), 0.75, places=9)  # 0.6/0.8
        self.assertGreater(float(effective["x"][1]), 6.4e3)
        self.assertAlmostEqual(float(points["error"][0]), 132.0, places=9)
        self.assertEqual((points["error"][1], preshear["error"]), (None, ["250"]))
        # preshear above the line: the circle touches a parallel line at the preshear stress, and nothing is dotted
        tau, t = 9e3, SLOPE
        self.ring("above", tau_p_Pa=pages.value(tau, None), steady_circle={"centre_Pa": 12e3 + t * tau, "radius_Pa": tau * math.hypot(1.0, t)})
        self.made("report", "above")
        curves = self.page("above/report.html").figures["yield-locus"]["curves"]
        self.assertAlmostEqual(float(curves[0]["x"][1]), 12e3, delta=1e-6)
        self.assertNotIn("error", curves[2])

    def test_shear_to_failure_of_several_runs(self):
        """A figure for each point with the curves of all runs and their marks; its stress, or stresses, in the title; height too."""
        self.ring("one")
        self.ring("two", PARTS[:2] + [PARTS[2], {**PARTS[3], "normal_stress_Pa": 7000.0}])
        self.made("compare", "one", "two")
        figures = self.page("compare.html").figures
        for point, title in (("point-1", "point-1, at 3 kPa"), ("point-2", "point-2, at 6 to 7 kPa")):
            figure = figures[f"Shear-stress--{point}"]
            self.assertEqual(figure["title"], f"Shear stress, {title}")
            vague = point == "point-2"
            self.assertEqual([(curve["name"], curve["style"]) for curve in figure["curves"]],
                             [("one", "line"), ("two", "line")] + [("", "vague" if vague else "read")] * 2)
            table = pages.cells(self.path("one"), f"{point}.csv")
            self.assert_curve(figure, 0, table, "displacement", "shear_stress", 2)
            height = figures[f"Height--{point}"]
            self.assertEqual((height["title"], height["y"]["unit"], len(height["curves"])), (f"Height, {title}", "mm", 2))
            self.assert_curve(height, 1, table, "displacement", "height", 2)
        self.assertEqual(len(figures["Height--preshear"]["curves"]), 2)
        self.assertEqual(len(figures["Bulk-density--preshear"]["curves"]), 2)
        self.assertEqual([curve["style"] for curve in figures["Shear-stress--preshear"]["curves"]], ["line", "line", "read", "read"])

    def test_more_than_nine_points(self):
        """Curves of point-10 are not those of point-1."""
        for name in ("one", "two"):
            self.ring(name, PARTS + [{**PARTS[2], "part": "point-10", "normal_stress_Pa": 9000.0}])
            pages.write(self.path(name), point_HYPHEN_10__csv=pages.SLIP)
        self.made("compare", "one", "two")
        figures = self.page("compare.html").figures
        self.assertEqual([len(figures[f"Height--point-{k}"]["curves"]) for k in (1, 10)], [2, 2])
        self.assertEqual(figures["Height--point-10"]["title"], "Height, point-10, at 9 kPa")


if __name__ == "__main__":
    clod.unittest.main()
