"""Pages of shear tests: what was read from the curves and how well it is known, lines of the yield locus, a laboratory's density."""

import html
import math
import os
import re
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

    def lab_page(self, table, **changes):
        """The page of a run with a laboratory's table, and what it says."""
        with open(self.path("lab.csv"), "w") as file:
            file.write(table)
        self.ring("ring", **changes)
        self.made("report", "ring", "--lab", "lab.csv")
        page = self.page("ring/report.html")
        return page, " ".join(" ".join(page.words).split())

    def densities(self, page):
        return [page.row(f"bulk density{more} [kg/m³]")[2:] for more in ("", " away from walls")]

    def test_density_of_a_laboratory(self):
        """It stands beside both of the run, with how far each is off: 1206.4/1410 - 1 = -14.4 %, 1380.7/1410 - 1 = -2.1 %."""
        page, told = self.lab_page(LAB)
        self.assertEqual(self.densities(page), [["1206.4", "1410.0 (simulation -14.4 %)"], ["1380.7", "1410.0 (simulation -2.1 %)"]])
        self.assertTrue(any("away from walls" in caption for *_, caption in pages.cards(page.text)))
        self.assertIn("The laboratory's bulk density stands beside both of the simulation", told)
        self.assertIn("If its grains are far smaller than its cell , as those of a powder, that is ρ inside", told)
        self.made("report", "ring")
        self.assertNotIn("laboratory's", " ".join(self.page("ring/report.html").words))

    def test_errors_of_densities(self):
        """Specimens of 1400 and 1420 have a mean of 1410 with an error of 10; the run 12: sqrt(12^2 + (0.856 10)^2)/1410 = 1.0 %."""
        rows = [f"{seed},12,7,{sigma},{tau},{density}\n" for seed, density in ((1, 1400), (2, 1420)) for sigma, tau in ((3, 2.8), (5, 4.1), (8, 5.8))]
        page, _ = self.lab_page("seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n" + "".join(rows),
                                rho_b_kg_m3=pages.value(1206.4, 12.0), rho_inside_kg_m3=pages.value(None, None))
        self.assertEqual(page.row("bulk density [kg/m³]")[2:], ["1206 ± 12", "1410 ± 10 (s 14) (simulation -14.4 ± 1.0 %)"])

    def test_a_run_without_a_density_inside(self):
        """Its cell is too narrow: the page says when the densities can be compared."""
        page, told = self.lab_page(LAB, rho_inside_kg_m3=pages.value(None, None))
        self.assertEqual(page.row("bulk density [kg/m³]")[2:], ["1206.4", "1410.0 (simulation -14.4 %)"])
        self.assertFalse(any("away from walls" in caption for *_, caption in pages.cards(page.text)))
        self.assertIn("compare it with the laboratory's only if that is of a cell with as few grains across", told)
        self.assertNotIn("beside both", told)

    def test_a_table_with_both_densities(self):
        """Each is compared with that of its name."""
        both = LAB.replace("rho_b [kg/m3]", "rho_b [kg/m3],rho_inside [kg/m3]").replace(",1410", ",1230,1395")
        page, told = self.lab_page(both)
        self.assertEqual(self.densities(page), [["1206.4", "1230.0 (simulation -1.9 %)"], ["1380.7", "1395.0 (simulation -1.0 %)"]])
        self.assertIn("each stands beside the simulation's of the same name", told)

    def test_density_at_another_preshear_stress(self):
        """At 6 kPa the run has no density to be off."""
        page, _ = self.lab_page(LAB.split("\n")[0] + "\n6,4,2,2.1,1410\n6,4,3,2.7,1410\n6,4,4,3.2,1410\n")
        self.assertEqual(self.densities(page), [["1206.4", "1410.0"], ["1380.7", "1410.0"]])

    def test_density_of_a_laboratory_beside_runs(self):
        with open(self.path("lab.csv"), "w") as file:
            file.write(LAB)
        self.ring("one")
        self.ring("two", rho_inside_kg_m3=pages.value(1390.5, None))
        self.made("compare", "one", "two", "--lab", "lab.csv")
        page = self.page("compare.html")
        self.assertEqual(self.densities(page), [["1206.4", "1206.4", "1410.0"], ["1380.7", "1390.5", "1410.0"]])
        self.assertIn("The laboratory's bulk density stands beside both", " ".join(page.words))

    def test_which_points_are_the_laboratorys(self):
        """Rows and warnings have their preshear stress, and of several specimens the specimen."""
        rows = "".join(f"{seed},{pre},{0.6 * pre},{share * pre},{tau * pre},{0.003 * pre}\n" for pre in (4, 8) for seed in (101, 102)
                       for share, tau in ((0.3, 0.25), (0.5, 0.45), (0.7, 0.46)))
        page, _ = self.lab_page("seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],tau_sh_error [kPa]\n" + rows)
        names = [row[0] for row in page.tables[1] if row[0].startswith("laboratory")]
        self.assertEqual(names, [f"laboratory, {pre} kPa, specimen {seed}" for pre in (4, 8) for seed in (101, 102) for _ in range(3)])
        warnings = [item for item in page.items if "kPa: " in item]
        for pre in ("4.000", "8.000"):  # the three points are on no line
            self.assertTrue(any(item.startswith(f"Yield locus at a preshear stress of {pre} kPa: Seed 101: ") for item in warnings), page.items)
        page, _ = self.lab_page(LAB)
        self.assertEqual([row[0] for row in page.tables[1]][-1], "laboratory, 12 kPa")

    def test_warnings_that_differ_by_the_part(self):
        """They are one, with the names of the parts, in the order in which they come; those about other things are not."""
        slow = "inertial number 0.0034: not quasi-static"
        self.ring("ring")
        summary = pages.load_json(self.path("ring/summary.json"))
        summary["warnings"] = [f"preshear: {slow}", "point-2: no peak", f"point-1: {slow}", f"point-2: {slow.replace('34', '35')}", "Gauge 1 is blocked.",
                               "Gauge 2 is blocked."]
        pages.write(self.path("ring"), summary__json=summary)
        self.made("report", "ring")
        page = self.page("ring/report.html")
        told = [html.unescape(re.sub(r"<[^>]*>", "", item)) for item in
                re.findall(r"<li>(.*?)</li>\n", page.text[page.text.index('id="warnings"'):page.text.index("</section>")])]
        self.assertEqual(told, [
            f"preshear, point-1, point-2: {slow} (as preshear has it)the numbers of eachpreshear: {slow}point-1: {slow}point-2: {slow.replace('34', '35')}",
            "point-2: no peak", "Gauge 1 is blocked.", "Gauge 2 is blocked."])
        summary["warnings"] = [f"preshear: {slow}", f"point-1: {slow}"]
        pages.write(self.path("ring"), summary__json=summary)
        self.made("report", "ring")
        self.assertEqual(self.page("ring/report.html").items, [f"preshear, point-1: {slow}"])

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
