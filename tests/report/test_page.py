"""clod report: numbers on the pages of tests are those in the files, their heads; what is refused."""

import html
import json
import os
import re
import sys
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod


class Report(pages.PageCase):

    def test_ring_shear(self):
        """A real test: the run itself writes the page; laboratory points come over it later."""
        case = clod.source("tests/restart/ring.yaml")
        done = self.made("run", case, "-o", "ring", "-t", "1", page=True)
        self.assertIn("ring/report.html", done.stderr)
        page = self.page("ring/report.html")
        with open(self.path("ring/summary.json")) as file:
            summary = json.load(file)
        with open(self.path("ring/report.txt")) as file:
            told = file.read()
        self.assertTrue(summary["warnings"])
        shared = {item.split(": ", 1)[1]: item.split(": ", 1)[0].split(", ") for item in page.items if ": " in item}
        for warning in summary["warnings"] + summary["locus"]["loci"][0]["warnings"]:
            part, _, rest = warning.partition(": ")
            self.assertTrue(warning in page.items or part in shared.get(rest, []), warning)  # itself, or one for several parts
        self.assertLess(page.text.index('id="warnings"'), page.text.index('id="results"'))
        # the results of report.txt, up to the second digit of their errors
        found = re.findall(r"^  (\S.*?)\s+(?:sigma_|tau_|phi_|c |rho_)\S*\s+([-0-9.]+) ± +([0-9.]+)", told, re.M)
        self.assertGreater(len(found), 5)
        for name, value, error in found:
            row = next(row for table in page.tables for row in table if re.match(re.escape(name) + r"( \[|$)", row[0]))
            shown = re.match(r"([-0-9.]+)(?: ± ([0-9.]+))?", row[2])
            if shown[2] is not None:
                self.assertEqual(len(shown[2].replace(".", "").lstrip("0")), 2, row)
                self.assertAlmostEqual(float(shown[1]), float(value), delta=0.06 * float(error) + 0.001)
                self.assertAlmostEqual(float(shown[2]), float(error), delta=0.06 * float(error) + 0.001)
            else:
                self.assertEqual(shown[1], value)
        self.assert_titles(page.text, summary["locus"]["loci"][0])
        preshear = pages.cells(self.path("ring"), "preshear.csv")
        first = max(k for k, text in enumerate(preshear["displacement"]) if float(text) == 0.0)
        self.assertLess(len(preshear["time"]) - first, 2000)  # else rows would be left out
        self.assert_curve(page.figures["Shear-stress--preshear"], 0, preshear, "displacement",
                          "shear_stress", first)
        self.assert_curve(page.figures["Height-of-the-specimen--preshear"], 0, preshear,
                          "displacement", "height", first)
        locus = page.figures["yield-locus"]
        self.assertEqual(locus["equal"], True)
        points = summary["locus"]["loci"][0]["points"]
        self.assertEqual([float(x) for x in locus["curves"][1]["x"]], [p["sigma_s_Pa"] for p in points])
        self.assertEqual([float(y) for y in locus["curves"][1]["y"]], [p["prorated_Pa"] for p in points])
        self.assertIn("one specimen: scatter between specimens not included", " ".join(page.words))
        self.lab_points(locus)

    def assert_titles(self, text, locus):
        """Behind each result stands its whole number, as the summary has it."""
        told = text[text.index('class="results'):text.index('id="points-table"')]
        titles = [html.unescape(title) for title in re.findall(r'<td title="([^"]*)">', told)]
        found = 0
        for key, unit in (("tau_p_Pa", "Pa"), ("rho_b_kg_m3", "kg/m3"), ("phi_e_deg", "deg"), ("phi_sf_deg", "deg"), ("sigma_1_Pa", "Pa")):
            number = locus[key]
            if number["value"] is not None:
                wanted = pages.text(number["value"]) + (f" ± {pages.text(number['error'])}" if number["error"] else "") + f" {unit}"
                self.assertIn(wanted, titles)
                found += 1
        self.assertGreater(found, 2)

    def lab_points(self, before):
        with open(self.path("lab.csv"), "w") as file:
            file.write(pages.LAB)
        self.made("report", "ring", "--lab", "lab.csv", "-o", "with.html")
        curves = self.page("with.html").figures["yield-locus"]["curves"]
        self.assertEqual(curves[:len(before["curves"])], before["curves"])
        hollow = [curve for curve in curves if curve["style"] == "hollow"]
        self.assertEqual([[float(x) for x in curve["x"]] for curve in hollow], [[3000, 5000, 7500], [10000]])
        # prorated with a tau_pre that all share: as measured, but for the last bit
        for y, wanted in zip(hollow[0]["y"], [3250, 4500, 5750]):
            self.assertAlmostEqual(float(y), wanted, delta=1e-9)
        figures = sorted(name for name in os.listdir(self.folder) if name.startswith("with-"))
        self.assertIn("with-yield-locus.svg", figures)
        for name in figures:
            root = xml.etree.ElementTree.parse(self.path(name)).getroot()
            self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        said = self.made("report", "ring", "--lab", "none.csv", code=2).stderr
        self.assertIn("none.csv", said)
        with open(self.path("falling.csv"), "w") as file:
            file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n10,7.6,3,5\n10,7.6,5,4\n10,7.6,7,3\n")
        said = self.made("report", "ring", "--lab", "falling.csv", code=2).stderr  # atan(-0.5)
        self.assertIn("falling.csv:2, 3, 4: the yield locus at a preshear stress of 10.000 kPa has phi_lin = -26.57 deg", said)
        with open(self.path("above.csv"), "w") as file:
            file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n10,7.6,3,3.1\n10,7.6,5,4.5\n10,7.6,12,9\n")
        said = self.made("report", "ring", "--lab", "above.csv", code=2).stderr
        self.assertIn("above.csv:4: shear at 12.000 kPa after a preshear at 10.000 kPa", said)

    def test_a_laboratory_of_several_preshear_stresses(self):
        """Columns of one name are told apart by the preshear stress, as curves are."""
        pages.shear(self.path("ring"))
        points = "".join(f"{s},{0.72 * s},{k * s},{(0.1375 + 0.625 * k) * s},1650\n" for s in (5, 10) for k in (0.3, 0.5, 0.75))
        with open(self.path("lab.csv"), "w") as file:
            file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n" + points)
        self.made("report", "ring", "--lab", "lab.csv")
        self.assertEqual(self.page("ring/report.html").row("quantity")[2:],
                         ["simulation", "laboratory, 5\xa0kPa", "laboratory, 10\xa0kPa"])

    def test_fresh_removes_the_page(self):
        box = [clod.source("tests/restart/box.yaml"), *pages.SHORT]
        self.made("run", *box, "-o", "box", page=True)
        self.assertIn("report.html", os.listdir(self.path("box")))
        self.assertIn("report-kinetic-energy.svg", os.listdir(self.path("box")))
        self.made("run", *box, "-o", "box", "--fresh")
        self.assertEqual([name for name in os.listdir(self.path("box")) if name.startswith("report")],
                         ["report.txt"])

    def test_nothing_from_outside(self):
        """A browser loads nothing but the file: no addresses in what it would fetch."""
        pages.free_run(self.path("run"))
        self.assertEqual(self.made("report", "run").stdout, "run/report.html\n")
        page = self.page("run/report.html")
        markup = re.sub(r"<script>.*?</script>", "", page.text, flags=re.S)
        self.assertIsNone(re.search(r"\b(src|href)\s*=|<link|@import|url\(\s*[\"']?http", markup))

    def test_uniaxial(self):
        pages.uniaxial(self.path("run"))
        self.made("report", "run")
        page = self.page("run/report.html")
        stress = pages.cells(self.path("run"), "stress-1.csv")
        self.assert_curve(page.figures["axial-stress"], 0, stress, "strain", "axial_stress", 2)
        flow = page.figures["flow-function"]["curves"][0]
        self.assertEqual([flow[key] for key in ("x", "y", "error")], [["10076.6"], ["11677.46"], ["59.87"]])
        self.assertEqual(page.items, ["stress-1: only 7.2 grain diameters"])
        self.assertEqual(page.row("unconfined yield strength [kPa]")[1:], ["σc", "11.677 ± 0.060"])
        self.assertEqual(page.row("quantity")[2:], ["10 kPa"])
        self.assertNotIn("bulk density away from walls", page.text)  # nobody has it
        with open(self.path("run/summary.json")) as file:
            summary = json.load(file)
        summary["flow_function"][0]["inside_density_kg_m3"] = 1283.6
        pages.write(self.path("run"), summary__json=summary)
        self.made("report", "run")
        self.assertEqual(self.page("run/report.html").row("bulk density away from walls [kg/m³]")[1:], ["ρinside", "1284"])
        self.assertEqual(page.row("computing time [s]")[1:], ["62.75"])  # of both parts
        self.assertEqual(page.row("time step [s]")[1:], ["1e-05 to 1.25e-05"])
        self.assertEqual(page.row("seed")[1:], ["4"])
        self.assertFalse([row for table in page.tables for row in table if row[0] == "steps"])
        self.assertIn('<b title="11677.46 &plusmn; 59.87 Pa">11.677 <small>&plusmn; 0.060 kPa</small></b>', page.text)

    def test_fields_of_a_wall_friction_test(self):
        """Means over regions: components as rows, along the axes that the case asks for, and their curves over the way of the plate."""
        means = lambda *numbers: {"mean": list(numbers), "deviation": [0.1 * number for number in numbers]}
        fields = {"low": {"phase": "shear", "velocity_m_per_s": means(0.5, 0.25, 2)},
                  "mid": {"phase": "shear", "contact_stress_Pa": means(10, 20, 30, 40, 50, 60, 70, 80, 90)}}
        parts = [{**pages.WALL["parts"][0], "fields": {name: {**field, "phase": "fill"} for name, field in fields.items()}},
                 {**pages.WALL["parts"][1], "fields": fields}]
        pages.wall(self.path("run"), parts=parts)
        head, *rows = pages.SLIP.splitlines()
        columns = "field_low.velocity_x [m/s],field_mid.contact_stress_tz [Pa],field_low.density [kg/m3],field_mid.density [kg/m3]"
        text = pages.text
        pages.write(self.path("run"), wall__csv="\n".join([f"{head},{columns}"] + [
            f"{row},{text(0.5 * k)},{text(60 + k)},{text(1000 + k)},{text(900 - k)}" for k, row in enumerate(rows)]) + "\n")
        with open(self.path("run/case-complete.yaml"), "a") as file:
            file.write("fields:\n  low:\n    interval: 0.01 s\n  mid:\n    components: cylindrical\n")
        self.made("report", "run")
        page = self.page("run/report.html")
        self.assertEqual(page.row("velocity y [m/s]")[1:], ["0.250 ± 0.025"] * 2)
        self.assertEqual(page.row("contact stress tz [Pa]")[1:], ["60.0 ± 6.0"] * 2)
        self.assertNotIn("contact stress yz [Pa]", page.words)
        self.assertIn("More curves: fields in wall", page.words)
        series = {name: column[2:] for name, column in pages.cells(self.path("run"), "wall.csv").items()}  # till then the plate stands
        for name, number, column in (("velocity-x", 0, "field_low.velocity_x"), ("contact-stress-tz", 0, "field_mid.contact_stress_tz"),
                                     ("density", 0, "field_low.density"), ("density", 1, "field_mid.density")):
            self.assert_curve(page.figures[name], number, series, "displacement", column)
        density = page.figures["density"]
        self.assertEqual((density["title"], [curve["name"] for curve in density["curves"]]), ("Density: fields", ["field low", "field mid"]))

    def test_wall_friction(self):
        """Laboratory points, here on tau = 0.25 sigma + 0.5 kPa, stand beside those of the run."""
        pages.wall(self.path("run"))
        with open(self.path("lab.csv"), "w") as file:
            file.write("sigma_w [kPa],tau_w [kPa],tau_w_error [kPa],steady\n8,2.5,0.1,1\n4,1.5,0.1,0\n")
        self.made("report", "run", "--lab", "lab.csv")
        page = self.page("run/report.html")
        self.assertEqual(page.items[0], "wall: inertial number 0.0031")
        self.assertEqual([item[:31] for item in page.items[1:]], ["1 of 2 points was not steady: t"])
        line = page.figures["wall-yield-locus"]
        self.assertTrue(line["equal"])
        points, fit, lab, lab_fit = line["curves"]
        self.assertEqual([points[key] for key in ("x", "y", "error")],
                         [["10001.5", "5000.25"], ["3361.25", "1711.75"], ["12.5", "6.25"]])
        self.assertEqual((fit["y"][0], lab["style"], lab_fit["style"]), ("62.5", "hollow", "dashed"))
        self.assertEqual(lab["y"], ["2500", "1500"])
        self.assertAlmostEqual(float(lab_fit["y"][0]), 500.0, places=6)
        angle, lab = page.figures["wall-friction-angle"]["curves"]
        self.assertEqual(angle["y"], ["18.576", "18.898"])
        slip = pages.cells(self.path("run"), "wall.csv")
        for column in ("shear_stress", "normal_stress", "height", "bulk_density"):
            self.assert_curve(page.figures[column.replace("_", "-")], 0, slip, "displacement", column, 2)
        # errors of the laboratory's line, by hand: tan 14.04 +- 0.1 sqrt(2)/4; 0.5 +- 0.1 sqrt(5)
        self.assertEqual(page.row("kinematic angle of wall friction [deg]")[1:], ["φw", "18.25 ± 0.13", "14.0 ± 1.9"])
        self.assertEqual(page.row("wall adhesion [kPa]")[1:], ["τad", "0.062 ± 0.031", "0.50 ± 0.22"])
        for text in ("10.0015 ± 0.0035", "3.361 ± 0.013", "18.576 ± 0.065", "not steady"):
            self.assertTrue(any(text in cell for table in page.tables for row in table for cell in row), text)

    def test_a_run_that_goes_on(self):
        pages.free_run(self.path("run"))
        os.remove(self.path("run/report.txt"))
        os.remove(self.path("run/summary.json"))
        with open(self.path("run/series.csv"), "a") as file:
            file.write("2.6,0.7")  # a row that is just being written
        self.made("report", "run")
        page = self.page("run/report.html")
        self.assertEqual(page.items, ["The run is not complete: this page shows what there is so far."])
        self.assertEqual(len(page.figures["kinetic-energy"]["curves"][0]["x"]), 26)

    def test_a_test_that_goes_on(self):
        """Its parts are those of the log, with the curves that they have so far."""
        pages.uniaxial(self.path("run"))
        for name in ("report.txt", "summary.json"):
            if os.path.exists(self.path("run/" + name)):
                os.remove(self.path("run/" + name))
        with open(self.path("run/log.jsonl"), "w") as file:
            file.write('{"time":"2026-11-28T06:54:04.090Z","event":"start","version":"clod 9.9"}\n'
                       '{"time":"2026-11-28T06:57:46.322Z","event":"phase","part":"stress-1","from":"fill","to":"lower"}\n'
                       '{"time":"2026-11-28T06:58:46.322Z","event":"phase","part":"stress-1","from":"lower","to":"crush"}\n')
        self.made("report", "run")
        page = self.page("run/report.html")
        stress = pages.cells(self.path("run"), "stress-1.csv")
        self.assert_curve(page.figures["axial-stress"], 0, stress, "strain", "axial_stress", 2)
        self.assertEqual(len(page.figures["axial-stress"]["curves"]), 1)
        self.assertEqual(page.row("computed by")[1:], ["clod 9.9"])

    def test_a_title_with_quotes(self):
        """While there is no summary the title is that of the case, read as YAML."""
        pages.free_run(self.path("run"))
        os.remove(self.path("run/summary.json"))
        case = pages.COMPLETE % (r'A \"quoted\" <b> & \u00e9', "2500")
        pages.write(self.path("run"), **{"case_HYPHEN_complete__yaml": case})
        self.made("report", "run")
        heading = re.search(r"<h1>(.*?)</h1>", self.page("run/report.html").text)[1]
        self.assertEqual(html.unescape(heading), 'A "quoted" <b> & \u00e9')
        self.assertNotIn("<", heading)

    def test_a_half_written_line_of_the_log(self):
        """Only whole times are told; with none there is no time at all."""
        whole = '{"time":"2026-01-31T12:34:56Z","event":"begin"}\n'
        for log, told in ((whole + '{"time":"', True), (whole + '{"time":"2026-02-0', True),
                          (whole + '{"time":"2026-02-01"}\n', True), ('{"time":""}\n', False), ("", False)):
            pages.free_run(self.path("run"))
            pages.write(self.path("run"), log__jsonl=log)
            self.made("report", "run")
            page = self.page("run/report.html")
            self.assertEqual("run, computed until 2026-01-31 12:34 UTC" in "".join(page.words), told, log)
            self.assertEqual("computed until" in "".join(page.words), told, log)
            self.assertEqual(page.row("last entry of the log")[1], "2026-01-31T12:34:56Z" if told else "not known")

    def test_a_laboratory_at_another_preshear_stress(self):
        """Strengths belong to the preshear stress: a warning names both; within a twentieth they are the same."""
        pages.shear(self.path("ring"))  # 10 kPa
        told = "The laboratory's points are at a preshear stress of %s kPa, the run's at 10.000 kPa: "
        for stress, warned in ((5, "5.000"), (10.4, None), (10.6, "10.600"), (9.4, "9.400")):
            shear = "".join(f"{stress},{0.72 * stress},{k * stress},{(0.1375 + 0.625 * k) * stress},1650\n" for k in (0.3, 0.5, 0.75))
            with open(self.path("lab.csv"), "w") as file:
                file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n" + shear)
            self.made("report", "ring", "--lab", "lab.csv")
            found = [item for item in self.page("ring/report.html").items if "points are at a preshear stress of" in item]
            self.assertEqual([item.startswith(told % warned) for item in found], [True] if warned else [], stress)
        pages.shear(self.path("other"))
        with open(self.path("lab.csv"), "w") as file:
            file.write(pages.LAB.replace("\n10,7.2", "\n20,7.2"))
        self.made("compare", "ring", "other", "--lab", "lab.csv")
        found = [item for item in self.page("compare.html").items if "points are at a preshear stress of" in item]
        self.assertEqual([item.startswith("All 2 runs: " + told % "20.000") for item in found], [True])

    def test_a_locus_without_class_of_flow(self):
        """Without strength there is no flowability, and no class of it."""
        points = [{"sigma_s_Pa": 3000.0, "prorated_Pa": 1500.0}, {"sigma_s_Pa": 5000.0, "prorated_Pa": 2500.0}]
        locus = {"sigma_p_Pa": 10000.0, "tau_p_Pa": 5000.0, "c_Pa": 0.0, "phi_lin_deg": 26.565, "points": points}
        complete = pages.COMPLETE % ("Ring", "2500") + "ring_shear:\n  seeds: 1\n"
        for name in ("one", "two"):
            pages.write(self.path(name), summary__json={"title": "Ring", "locus": {"loci": [locus]}},
                        **{"case_HYPHEN_complete__yaml": complete})
        self.made("report", "one")
        self.assertEqual(self.page("one/report.html").row("flow (Jenike)")[2], "-")
        self.made("compare", "one", "two")
        self.assertEqual(self.page("compare.html").row("flow (Jenike)")[2:], ["-", "-"])

    def test_refusals(self):
        pages.free_run(self.path("run"))
        pages.uniaxial(self.path("other"))
        os.mkdir(self.path("empty"))
        pages.write(self.path("fitted"), calibration__json={})
        with open(self.path("lab.csv"), "w") as file:
            file.write(pages.LAB)
        with open(self.path("design.json"), "w") as file:
            file.write("{}")
        pages.shear(self.path("ring"))
        pages.write(self.path("."), wall__csv="sigma_w [kPa],tau_w [kPa]\n2,0.5\n",
                    strength__csv="sigma_1 [kPa],sigma_c [kPa]\n2,0.5\n")
        for arguments, text in ((["report"], "which run?"),
                                (["report", "empty"], "empty is not the results folder of a run: it has no file "
                                 "case-complete.yaml. Name one, e.g. run/first."),
                                (["report", "none"], "none does not exist. Name the results folder of a run"),
                                (["report", "lab.csv"], "lab.csv is a file, not the results folder of a run. Name a "
                                 "folder, e.g. run/first."),
                                (["report", "design.json"], "design.json is a file, not the results folder of a run. "
                                 "Name a folder, e.g. run/first; clod hopper -o writes the page of a design itself."),
                                (["compare", "run", "lab.csv"], "lab.csv is a file, not"),
                                (["compare", "run", "fitted"], "fitted is the results folder of a calibration, not of a "
                                 "run: clod report makes a page of it; clod compare takes runs"),
                                (["report", "run", "other", "-o", "a.html"], "there are several runs"),
                                (["report", "run", "--lab", "lab.csv"], "is no shear or wall friction test"),
                                (["report", "ring", "--lab", "wall.csv"], "--lab wall.csv: is a table of wall friction "
                                 "(sigma_w, tau_w); the page of ring (Ring shear test) takes shear points"),
                                (["report", "ring", "--lab", "strength.csv"], "is a table of a flow function or bulk"),
                                (["compare", "run", "other"], "is of another kind")):
            self.assertIn(text, self.made(*arguments, code=2).stderr)
        with open(self.path("run/series.csv"), "a") as file:
            file.write("1,2\n")
        said = self.made("report", "run", code=2).stderr
        self.assertIn("series.csv:28: 2 cells, but the header has 5 columns", said)
        with open(self.path("run/summary.json"), "w") as file:
            file.write("{")
        self.assertIn("summary.json is damaged", self.made("report", "run", code=2).stderr)
        self.assertFalse(os.path.exists(self.path("run/report.html")))


if __name__ == "__main__":
    clod.unittest.main()
