"""clod report and clod compare: numbers on the page are those in the files; what is refused."""

import html
import json
import os
import re
import sys
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod

LAB = ("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
       "10,7.2,3,3.25,1650\n10,7.2,5,4.5,1650\n10,7.2,7.5,5.75,1650\n")


class Report(clod.Case):

    def made(self, *arguments, code=0, page=False):
        done = clod.run(*arguments, cwd=self.folder, page=page)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def page(self, name):
        return pages.load(self.path(name))

    def assert_curve(self, figure, number, table, x, y, first=0):
        """The curve has the texts of these columns from row `first` on; nan is null."""
        curve = figure["curves"][number]
        self.assertEqual(curve["x"], table[x][first:])
        self.assertEqual(curve["y"], [None if text == "nan" else text for text in table[y][first:]])

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
        for warning in summary["warnings"] + summary["locus"]["loci"][0]["warnings"]:
            self.assertIn(warning, page.items)
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
        told = text[text.index('id="results-table"'):text.index('id="points-table"')]
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
            file.write(LAB)
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

    def test_free_run(self):
        pages.free_run(self.path("run"))
        self.made("report", "run/")
        page = self.page("run/report.html")
        series = pages.cells(self.path("run"), "series.csv")
        self.assert_curve(page.figures["kinetic-energy"], 0, series, "time", "kinetic_energy")
        self.assert_curve(page.figures["mass-flow"], 0, series, "time", "gauge_head.mass_flow")
        self.assertNotIn("angle", page.figures)  # it never changes
        self.assertEqual(page.row("mass flow [kg/s]")[1:], ["0.834 ± 0.020"])
        self.assertIn('<td title="0.8343702206 &plusmn; 0.0204139 kg/s">', page.text)
        self.assertEqual(page.row("grains")[1], "166083")
        self.assertEqual(page.row("mean [s]")[1:], ["1.644"])
        self.assertNotIn("x min", [row[1] for table in page.tables for row in table if len(row) > 1])
        self.assertEqual(page.items, ["Gauge head gave alarm of blocking 2 times, and is blocked at the end."])
        # names from the case are text, never markup
        self.assertIn("<h1>A &lt;chute&gt; &amp; more</h1>", page.text)
        for text in ("2.5 s", "1.2 %", "61.5"):
            self.assertIn(text, page.words)

    def plugged(self, **changes):
        """The page of a run that comes to a stand: inlets, an alarm, spillage."""
        inlets = [{"group": 0, "grains": 9, "mass_kg": 36.64, "backlog_kg": 18.9055, "most_backlog_kg": 18.9055,
                   "blocked_insertions": 1757, "blocked_since_s": 3.247},
                  {"group": 2, "grains": 9, "mass_kg": 4.0, "backlog_grains": 0.0, "most_backlog_grains": 12.0,
                   "blocked_insertions": 3},
                  {"group": 3, "grains": 9, "mass_kg": 4.0, "backlog_kg": 0.0, "most_backlog_kg": 0.0,
                   "blocked_insertions": 0}]
        gauges = {"chute": {"alarms": 2, "blocked_since_s": 1.18, "blocked_at_end": True, "blocked_at_end_since_s": 3.2},
                  "head": {"alarms": 1, "blocked_since_s": 2.5, "blocked_at_end": False, "blocked_at_end_since_s": None},
                  "exit": {"alarms": 0, "blocked_since_s": None, "blocked_at_end": False}}
        balance = {"in": {"grains": 27, "mass_kg": 40.0}, "inside": {"grains": 9, "mass_kg": 24.25},
                   "out": {"outlet_a": {"grains": 5, "mass_kg": 15.5}, "left_z_min": {"grains": 6, "mass_kg": 0.25}},
                   "spillage": {"grains": 6, "mass_kg": 0.25}, "lost": {"grains": 0, "mass_kg": 1e-14}}
        pages.free_run(self.path("run"), **{"inlets": inlets, "gauges": gauges, "balance": balance, **changes})
        pages.write(self.path("run"), series__csv=(
            "time [s],inlet_1.backlog [kg],gauge_a.mass_flow [kg/s],gauge_b.mass_flow [kg/s],balance.in [1],"
            "balance_in.mass_flow [kg/s],balance_out.mass_flow [kg/s],clumps.d10 [m],clumps_a.d10 [m],"
            "feed.power [W],gauge_a.power [W]\n0,1,1,1,1,1,1,1,1,1,1\n1,2,2,2,2,2,2,2,2,2,2\n"))
        self.made("report", "run")
        return self.page("run/report.html")

    def test_warnings_of_streams(self):
        page = self.plugged()
        self.assertEqual(page.items, [
            "Inlet 1 has been blocked since 3.247 s: 18.91 kg wait for a place.",
            "Inlet 2 was blocked for a time: up to 12 grains waited for a place; 0 wait at the end.",
            "Gauge chute gave alarm of blocking 2 times, the first from 1.18 s on, and is blocked at the end, since 3.2 s.",
            "Gauge head gave alarm of blocking 1 time from 2.5 s on.",
            "6 grains were spilled: 0.25 kg, 0.62 % of what came in."])
        self.assertLess(page.text.index('id="warnings"'), page.text.index('class="cards"'))
        # in, out, inside and lost in place of what a bed at rest has
        cards = re.findall(r'<div class="card"><b>([^<]*)</b><span>([^<]*)</span>', page.text)
        self.assertEqual(cards[-4:], [("40 kg", "came in"), ("15.75 kg", "went out"), ("24.25 kg", "inside at the end"),
                                      ("0", "grains lost")])
        self.assertNotIn("kinetic energy", [caption for _, caption in cards])
        free = {"alarms": 0}
        page = self.plugged(inlets=[], gauges={"chute": free}, balance={})
        self.assertEqual(page.items, [])
        self.assertNotIn('id="warnings"', page.text)

    def test_curves_are_named(self):
        """A title says whose the curves are: of one object, or of several of one kind."""
        titles = sorted(figure["title"] for figure in self.plugged().figures.values())
        self.assertEqual(titles, ["Backlog: inlet 1", "D10: clumps", "In: balance", "Mass flow", "Power"])

    def test_names_of_figures_are_unique(self):
        """Two figures that ask for one name: each has its place in the page, its file and its curve."""
        gauges = {name: pages.FREE["gauges"]["head"] for name in ("a_b", "a-b")}
        pages.free_run(self.path("run"), gauges=gauges)
        pages.write(self.path("run"), series__csv="time [s],belt.energy [J],clumps [1]\n0,1,4\n1,2,5\n2,4,9\n",
                    energy__csv="time [s],kinetic [J],heat [J]\n0,7,8\n1,6,9\n",
                    residence__csv="from [s],to [s],grains [1],share_up_to [1]\n1,1.5,1,0.25\n1.5,2,3,1\n",
                    clumps__csv="time [s],count,from,to,share [1]\n0,0,1,2,0.25\n0,0,3,4,0.75\n",
                    gauge_a_b_HYPHEN_profile__csv="x [m],lower [m],mean [m],upper [m]\n0,1,2,3\n1,2,3,4\n",
                    **{"gauge_a_HYPHEN_b_HYPHEN_profile__csv": "x [m],lower [m],mean [m],upper [m]\n0,5,6,7\n1,6,7,8\n"})
        self.made("report", "run")
        page = self.page("run/report.html")
        names = ["clumps", "clumps-2", "energy", "energy-ledger", "gauge-a-b-profile", "gauge-a-b-profile-2",
                 "residence"]
        ids = re.findall(r'<figure [^>]*id="figure-([^"]*)"', page.text)
        self.assertEqual(sorted(ids), names)
        self.assertEqual(sorted(re.findall(r'<clipPath id="clip-([^"]*)"', page.text)), names)
        self.assertEqual(sorted(page.figures), names)
        files = sorted(name for name in os.listdir(self.path("run")) if name.endswith(".svg"))
        self.assertEqual(files, sorted(f"report-{name}.svg" for name in names))
        for name, first in (("energy", ["1", "2", "4"]), ("energy-ledger", ["7", "6"]),
                            ("gauge-a-b-profile", ["1", "2"]), ("gauge-a-b-profile-2", ["5", "6"]),
                            ("residence", ["0.25", "1"]), ("clumps", ["0.25", "0.75"]), ("clumps-2", ["4", "5", "9"])):
            self.assertEqual(page.figures[name]["curves"][0]["y"], first, name)
            svg = xml.etree.ElementTree.parse(self.path(f"run/report-{name}.svg")).getroot()
            title = svg.find("{http://www.w3.org/2000/svg}title").text
            self.assertEqual(title, page.figures[name]["title"])

    def test_uniaxial(self):
        pages.uniaxial(self.path("run"))
        self.made("report", "run")
        page = self.page("run/report.html")
        stress = pages.cells(self.path("run"), "stress-1.csv")
        self.assert_curve(page.figures["axial-stress"], 0, stress, "strain", "axial_stress", 2)
        flow = page.figures["flow-function"]["curves"][0]
        self.assertEqual([flow[key] for key in ("x", "y", "error")], [["10076.6"], ["11677.46"], ["59.87"]])
        self.assertEqual(page.items, ["stress-1: only 7.2 grain diameters"])
        self.assertEqual(page.row("sigma c [Pa]")[1:], ["11677 ± 60"])
        self.assertIn('<b title="11677.46 &plusmn; 59.87 Pa">11.677 <small>&plusmn; 0.060 kPa</small></b>', page.text)

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

    def test_wall_friction_tests_side_by_side(self):
        pages.wall(self.path("one"))
        pages.wall(self.path("two"))
        self.made("compare", "one", "two", "-o", "both.html")
        page = self.page("both.html")
        self.assertEqual([curve["name"] for curve in page.figures["wall-yield-locus"]["curves"]], ["one", "", "two", ""])
        self.assertEqual(page.row("kinematic angle of wall friction [deg]")[1:], ["φw", "18.25 ± 0.13", "18.25 ± 0.13"])
        self.assertEqual(len(page.figures["Shear-stress--wall"]["curves"]), 2)

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

    def test_compare(self):
        pages.free_run(self.path("one"))
        pages.free_run(self.path("two"), density="2600", grains=7)
        pages.free_run(self.path("three"), grains=8)
        self.assertEqual(self.made("compare", "one", "two", "three").stdout, "compare.html\n")
        page = self.page("compare.html")
        self.assertEqual(page.tables[0][0], ["quantity", "one", "two", "three"])
        self.assertEqual(page.row("grains")[1:], ["120", "7", "8"])
        self.assertEqual(page.row("materials.ore.density"),
                         ["materials.ore.density", "2500 kg/m3", "2600 kg/m3", "2500 kg/m3"])
        series = pages.cells(self.path("one"), "series.csv")
        figure = page.figures["kinetic-energy"]
        self.assertEqual([curve["name"] for curve in figure["curves"]], ["one", "two", "three"])
        for number in range(3):
            self.assert_curve(figure, number, series, "time", "kinetic_energy")
        self.assertTrue(os.path.exists(self.path("compare-kinetic-energy.svg")))

    def test_names_of_compared_runs(self):
        """As many parts of the path as it takes to tell the runs apart, and no more."""
        for folders, names in ((["a/run", "b/run"], ["a/run", "b/run"]),
                               (["a/run", "c/a/run", "b/last"], ["a/run", "c/a/run", "last"]),
                               (["run", "a/run/"], ["run", "a/run"]),
                               (["b//run", self.path("a/run")], ["b//run", "a/run"]),
                               (["a/run", "a/run"], ["a/run", "a/run"])):
            for number, folder in enumerate(folders):
                pages.free_run(self.path(folder), density=str(2500 + number))
            self.made("compare", *folders)
            page = self.page("compare.html")
            self.assertEqual([curve["name"] for curve in page.figures["kinetic-energy"]["curves"]], names)
            self.assertEqual(page.tables[0][0][1:], names)
            if folders[0] != folders[1]:
                self.assertEqual(page.row("key")[1:], names)

    def test_a_run_named_laboratory(self):
        """Hollow points are those of --lab, whatever the folders are called."""
        points = [{"sigma_s_Pa": 3000.0, "prorated_Pa": 3250.0}, {"sigma_s_Pa": 5000.0, "prorated_Pa": 4500.0}]
        locus = {"sigma_p_Pa": 10000.0, "tau_p_Pa": 7200.0, "c_Pa": 1375.0, "phi_lin_deg": 32.0, "points": points,
                 "flow": "free-flowing"}
        complete = pages.COMPLETE % ("Ring", "2500") + "ring_shear:\n  seeds: 1\n"
        for name in ("laboratory", "other"):
            pages.write(self.path(name), summary__json={"title": "Ring", "locus": {"loci": [locus]}},
                        **{"case_HYPHEN_complete__yaml": complete})
        with open(self.path("lab.csv"), "w") as file:
            file.write(LAB)
        self.made("compare", "laboratory", "other")
        curves = self.page("compare.html").figures["yield-locus"]["curves"]
        self.assertEqual([curve["style"] for curve in curves], ["line", "points", "points"] * 2)
        self.made("compare", "laboratory", "other", "--lab", "lab.csv")
        with_lab = self.page("compare.html").figures["yield-locus"]["curves"]
        self.assertEqual(with_lab[:6], curves)
        self.assertEqual([curve["style"] for curve in with_lab[6:9]], ["dashed", "hollow", "hollow"])

    def test_a_laboratory_at_another_preshear_stress(self):
        """Strengths belong to the preshear stress: a warning names both; within a twentieth they are the same."""
        pages.shear(self.path("ring"))  # 10 kPa
        told = "The laboratory's points are at a preshear stress of %s kPa, the run's at 10.000 kPa: "
        for stress, warned in ((5, "5.000"), (10.4, None), (10.6, "10.600"), (9.4, "9.400")):
            shear = "".join(f"{stress},{0.72 * stress},{k * stress},{(0.1375 + 0.625 * k) * stress},1650\n" for k in (0.3, 0.5, 0.75))
            with open(self.path("lab.csv"), "w") as file:
                file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n" + shear)
            self.made("report", "ring", "--lab", "lab.csv")
            found = [item for item in self.page("ring/report.html").items if "preshear stress of" in item]
            self.assertEqual([item.startswith(told % warned) for item in found], [True] if warned else [], stress)
        pages.shear(self.path("other"))
        with open(self.path("lab.csv"), "w") as file:
            file.write(LAB.replace("\n10,7.2", "\n20,7.2"))
        self.made("compare", "ring", "other", "--lab", "lab.csv")
        found = [item for item in self.page("compare.html").items if "preshear stress of" in item]
        self.assertEqual([item.startswith("All 2 runs: " + told % "20.000") for item in found], [True])

    def test_cards_of_what_was_measured(self):
        """Angle of repose with its error, mixing, mass flow of gauges; then no kinetic energy of grains at rest."""
        repose = {"heap": {"angle_deg": 28.159265, "error_deg": 0.9116774, "mean_deg": 28.159265, "deviation_deg": 7e-9, "height_m": 0.0457, "strips": 7},
                  "none": {"angle_deg": None, "error_deg": None, "mean_deg": None, "deviation_deg": None, "height_m": None, "strips": 0}}
        mixing = {"drum": {"by": "number", "lacey": 0.8731, "mean": 0.85, "deviation": 0.012, "share": 0.5}}
        pages.free_run(self.path("run"), repose=repose, mixing=mixing, outlets=None)
        self.made("report", "run")
        page = self.page("run/report.html")
        cards = re.findall(r'<div class="card"><b(?: title="([^"]*)")?>(.*?)</b><span>(.*?)</span>', page.text)
        plain = [(html.unescape(title), html.unescape(re.sub("<[^>]*>", "", number)), caption) for title, number, caption in cards]
        self.assertEqual(plain[:3], [("28.159265 ± 0.9116774 deg", "28.16 ± 0.91 deg", "angle of repose: heap"),
                                     ("0.8731", "0.873", "mixing index (Lacey): drum"),
                                     ("0.8343702206 ± 0.0204139 kg/s", "0.834 ± 0.020 kg/s", "mass flow, mean and deviation: head")])
        self.assertNotIn("kinetic energy", [caption for *_, caption in plain])
        self.assertEqual(page.row("angle [deg]")[1], "28.16 ± 0.91")
        self.assertEqual(page.row("mean [deg]")[1], "28.16")  # its deviation is below what is told
        pages.free_run(self.path("bed"), gauges={}, outlets=None)
        self.made("report", "bed")
        self.assertIn("<span>kinetic energy</span>", self.page("bed/report.html").text)

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

    def test_more_outlets_than_a_table_holds(self):
        one = pages.FREE["outlets"]["delivered"]
        pages.free_run(self.path("run"), outlets={f"lip{k}": one for k in range(70)})
        self.made("report", "run")
        self.assertIn("6 more of them, and 0 more numbers of these, are in summary.json.", self.page("run/report.html").text)

    def test_refusals(self):
        pages.free_run(self.path("run"))
        pages.uniaxial(self.path("other"))
        os.mkdir(self.path("empty"))
        pages.write(self.path("fitted"), calibration__json={})
        with open(self.path("lab.csv"), "w") as file:
            file.write(LAB)
        with open(self.path("design.json"), "w") as file:
            file.write("{}")
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
