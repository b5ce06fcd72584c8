"""The page of a hopper's design: warnings first, then what to build; every number is that of the design's JSON."""

import json
import os
import re
import shutil
import sys
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod

# of the page's tables: what JSON calls it, people's unit over JSON's, digits
ROWS = {"limit of mass flow in a cone [deg]": ("limit_deg", 1, 1), "half angle [deg]": ("half_angle_deg", 1, 1),
        "critical outlet [mm]": ("outlet_m", 1e3, 1), "flow factor ff": ("flow_factor", 1, 3),
        "critical sigma_1 [kPa]": ("sigma_1_Pa", 1e-3, 3), "critical strength f_c [kPa]": ("strength_Pa", 1e-3, 3),
        "phi_e there [deg]": ("phi_e_deg", 1, 1), "wall friction angle there [deg]": ("phi_w_deg", 1, 1),
        "bulk density there [kg/m3]": ("rho_b_kg_m3", 1, 0), "H(theta)": ("arch_thickness", 1, 3),
        "stress over strength": ("arching_margin", 1, 2)}
CURVES = {"f_c [kPa] over sigma_1": ("flow_function", "sigma_1_Pa", "f_c_Pa", "f_c", 1e-3, 3),
          "phi_e [deg] over sigma_1": ("phi_e", "sigma_1_Pa", "phi_e_deg", "phi-e", 1, 2),
          "phi_t [deg] over sigma_1": ("phi_t", "sigma_1_Pa", "phi_t_deg", "phi-t", 1, 2),
          "rho_b [kg/m3] over sigma_1": ("rho_b", "sigma_1_Pa", "rho_b_kg_m3", "bulk-density", 1, 1),
          "tau_w [kPa] over sigma_w": ("wall", "sigma_w_Pa", "tau_w_Pa", "wall-yield-locus", 1e-3, 3)}


class HopperPage(clod.Case):

    @classmethod
    def setUpClass(cls):
        cls.of_template = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, cls.of_template)
        pages.hopper(cls.of_template)

    def template(self):
        """The page of the template's design, which is made once, and its JSON."""
        return self.read(self.of_template)

    def read(self, folder):
        with open(os.path.join(folder, "design.json")) as file:
            return pages.load(os.path.join(folder, "design.html")), json.load(file)

    def design(self, *more):
        """The page of a design with other values or of another case, and its JSON."""
        pages.hopper(self.folder, *more)
        return self.read(self.folder)

    def cell(self, told, number, scale, digits):
        """A cell rounds a number of the JSON, which its title has whole."""
        title, text = told
        if number is None:
            self.assertEqual((title, text), (None, "-"))
        elif number == "infinite":
            self.assertEqual((title, text), (None, "infinite"))
        else:
            self.assertEqual(float(title), number)
            self.assertEqual(text, f"{scale * number:.{digits}f}")

    def assert_shape(self, table, found):
        rows = {row[0][1]: row[1:4] for row in table[1:]}
        for name, (key, scale, digits) in ROWS.items():
            self.assertEqual(name in rows, key in found)
            if name in rows:
                for told, end in zip(rows[name], ("value", "low", "high")):
                    self.cell(told, found[key][end], scale, digits)
        times = next(name for name in rows if name.startswith("outlet by particles"))
        self.assertRegex(times, r" times \[mm\]$")
        self.cell(rows[times][0], found["particle_outlet_m"], 1e3, 1)

    def test_numbers_are_those_of_the_design(self):
        page, found = self.template()
        tables = pages.titled(page.text)
        for head, shape in (("Cone, round outlet", "cone"), ("Wedge, slot at least 3 times as long", "wedge")):
            self.assert_shape(tables[head], found[shape])
        holes = {row[0][1]: row[1:4] for row in tables["Rathole"][1:]}
        for name, key in (("diameter, emptying (least) [mm]", "emptying_m"), ("diameter, after filling (most) [mm]", "filling_m")):
            for told, end in zip(holes[name], ("value", "low", "high")):
                self.cell(told, found["rathole"][key][end], 1e3, 1)
        self.cell(holes["vertical stress after filling [kPa]"][0], found["rathole"]["filling_stress_Pa"], 1e-3, 3)
        causes = {row[0][1]: row[1:3] for row in tables["share of the spread of the critical outlet [%]"][1:]}
        for name, key in (("flow function", "flow_function"), ("wall friction", "wall"),
                          ("effective angle phi_e", "phi_e"), ("bulk density", "rho_b"),
                          ("not told by all of them", "not_told")):
            for told, shape in zip(causes[name], ("cone", "wedge")):
                self.cell(told, found[shape]["outlet_variance_shares"][key], 100, 1)
        self.assertEqual([text for _, text in tables["curve"][0]], ["curve", "stress [kPa]", "error [kPa]", "value", "error"])
        measured = tables["curve"][1:]
        wanted = [(name, point) for name, of in CURVES.items() for point in found["measured"][of[0]]]
        self.assertEqual([row[0][1] for row in measured], [name for name, _ in wanted])
        for row, (name, point) in zip(measured, wanted):
            _, x, y, _, scale, digits = CURVES[name]
            for told, key, by, places in ((row[1], x, 1e-3, 3), (row[2], "x_error", 1e-3, 3), (row[3], y, scale, digits),
                                          (row[4], "y_error", scale, digits)):
                self.cell(told, point[key], by, places)

    def test_the_design_state(self):
        """The template's cone is for the outlet of 500 mm that it has, not for its critical one."""
        page, found = self.template()
        at = found["cone"]["design_state"]
        self.assertEqual(at["outlet_m"], 0.5)
        self.assertIn(f"Limit and half angle: at the outlet of 500.0 mm, where sigma_1 is {1e-3 * at['sigma_1_Pa']:.3f} kPa, phi_e "
                      f"{at['phi_e_deg']:.1f} and the wall friction angle {at['phi_w_deg']:.1f} deg.", page.text)

    def test_warnings_come_first_then_what_to_build(self):
        page, found = self.template()
        places = [page.text.index(f'id="{name}"') for name in ("warnings", "decision", "figures", "results", "interval",
                                                               "measured", "provenance")]
        self.assertEqual(places, sorted(places))
        self.assertEqual(page.items[:len(found["warnings"])], found["warnings"])
        cards = pages.cards(page.text)
        cone, wedge, hole = found["cone"], found["wedge"], found["rathole"]
        wanted = [(cone["half_angle_deg"]["low"], 1, 1, "deg"), (cone["outlet_m"]["high"], 1e3, 1, "mm"),
                  (cone["arching_margin"]["value"], 1, 2, ""), (wedge["half_angle_deg"]["low"], 1, 1, "deg"),
                  (wedge["outlet_m"]["high"], 1e3, 1, "mm"), (hole["emptying_m"]["high"], 1e3, 1, "mm"),
                  (hole["filling_m"]["high"], 1e3, 1, "mm")]
        self.assertGreater(cone["outlet_m"]["high"], cone["particle_outlet_m"])
        self.assertEqual(len(cards), len(wanted))
        for (title, text, unit, _), (number, scale, digits, of) in zip(cards, wanted):
            self.cell((title, text), number, scale, digits)
            self.assertEqual(unit, of)
        told = [caption for *_, caption in cards]
        angle, outlet, margin = cone["half_angle_deg"], cone["outlet_m"], cone["arching_margin"]
        for caption, words in ((told[0], f"right for 95 % of the samples. As measured {angle['value']:.1f}, within the errors "
                                f"{angle['low']:.1f} to {angle['high']:.1f} deg"),
                               (told[1], f"As measured {1e3 * outlet['value']:.1f}, within the errors {1e3 * outlet['low']:.1f} "
                                f"to {1e3 * outlet['high']:.1f} mm; 8 times the largest particle: 96.0 mm"),
                               (told[2], f"the outlet asked for, 500.0 mm: above 1 it breaks. As measured {margin['value']:.2f}, "
                                f"within the errors {margin['low']:.2f} to {margin['high']:.2f}; "
                                f"{100 * cone['planned_outlet_arching_share']:.1f} % of the samples do not flow"),
                               (told[6], f"{1e-3 * hole['filling_stress_Pa']:.3f} kPa below 8 m of solid in a silo of 3 m"),
                               (told[0], "from the vertical, for an outlet of 500.0 mm: right"),
                               (told[3], "from the vertical, for the critical outlet: right")):
            self.assertIn(words, caption)
        # the angle of 500 mm is none for the smaller outlet to build: that of a design with this outlet is
        _, smaller = self.design("--set", f"cone.outlet={1e3 * outlet['high']} mm")
        steeper = smaller["cone"]["half_angle_deg"]["value"]
        self.assertLess(steeper, angle["value"] - 0.5)
        self.assertTrue(told[1].endswith(f"With this outlet the half angle is {steeper:.1f} in place of {angle['value']:.1f} deg, as measured"), told[1])
        self.assertNotIn("With this outlet", told[4])
        # particles decide where they need more than cohesion
        page, found = self.design("--set", "largest_particle=50 mm")
        self.assertEqual(pages.cards(page.text)[1][:3], ("0.4", "400.0", "mm"))

    def test_figures_have_the_measured_points(self):
        page, found = self.template()
        chart = {curve["name"]: curve for curve in page.figures["design-chart"]["curves"] if curve["name"]}
        points = found["measured"]["flow_function"]
        shown = [float(x) for x in chart["measured"]["x"]]
        self.assertEqual(shown, [point["sigma_1_Pa"] for point in points[:len(shown)]])
        self.assertEqual([float(y) for y in chart["measured"]["y"]], [point["f_c_Pa"] for point in points[:len(shown)]])
        self.assertTrue(1 < len(shown) < len(points))
        self.assertIn(f"{len(shown)} of {len(points)} measured points lie within this figure", page.text)
        for shape in ("cone", "wedge"):
            factor = found[shape]["flow_factor"]["value"]
            ray = chart[f"{shape}, ff = {factor:.3f}"]
            self.assertAlmostEqual(float(ray["x"][1]) / float(ray["y"][1]), factor, places=9)
            state = chart[f"critical state, {shape}"]
            self.assertEqual([float(state[axis][0]) for axis in "xy"],
                             [found[shape][key]["value"] for key in ("sigma_1_Pa", "strength_Pa")])
        for of, x, y, name, _, _ in CURVES.values():
            name = "flow-function" if of == "flow_function" else name
            curve, = [curve for curve in page.figures[name]["curves"] if curve["name"] == "measured"]
            points = found["measured"][of]
            factor = float(page.figures[name]["y"]["factor"]) if y.endswith("_deg") else 1.0
            self.assertEqual([float(value) for value in curve["x"]], [point[x] for point in points])
            for value, error, point in zip(curve["y"], curve["error"], points):
                self.assertAlmostEqual(factor * float(value), point[y], delta=1e-12 * point[y])
                self.assertAlmostEqual(factor * float(error), point["y_error"], delta=1e-12 * point[y])
        for curve in page.figures["outlets"]["curves"]:
            if curve["name"]:
                self.assertEqual([float(x) for x in curve["x"]], found[curve["name"]]["outlet_percentiles_m"])
                self.assertEqual([round(100 * float(y)) for y in curve["y"]], list(range(101)))

    def test_other_outcomes(self):
        """Values in place of tables, no rathole, funnel flow, and a wedge that is not known to be mass flow."""
        with open(self.path("case.yaml"), "w") as file:
            file.write("flow_function: {file: flow.csv}\nwall_friction: {angle: 20 deg, error: 1 deg}\n"
                       "bulk_density: {value: 1250 kg/m3}\nwedge: {half_angle: 60 deg, outlet: 1 m}\n")
        with open(self.path("flow.csv"), "w") as file:
            file.write("sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg]\n2,1.4,0.05,48\n4,1.9,0.05,47\n8,2.9,0.08,46\n")
        page, found = self.design("case.yaml")
        wedge = found["wedge"]
        self.assertEqual(wedge["outcome"], "mass_flow_unknown")
        self.assertNotIn("Rathole", page.words)
        self.assertIn("Not known to be mass flow", page.text[page.text.index('id="decision"'):page.text.index('id="figures"')])
        self.assertTrue(any(item.startswith("Wedge: the half angle of 60.0 deg is") for item in page.items))
        cards = pages.cards(page.text)
        self.assertEqual((float(cards[2][0]), *cards[2][1:3]), (wedge["half_angle_deg"]["value"], "60.0", "deg"))
        self.assertIn("half angle that the case asks for", cards[2][3])
        self.assertIn("if a chart for wedges shows mass flow", cards[3][3])
        self.assertRegex(cards[4][3], r"do not flow; [0-9.]+ % are perhaps no mass flow$")
        rows = pages.titled(page.text)["curve"][-2:]
        self.assertEqual([[text for _, text in row] for row in rows],
                         [["rho_b [kg/m3]", "-", "-", "1250.0", "-"], ["phi_w [deg]", "-", "-", "20.00", "1.00"]])
        for name in ("bulk-density", "wall-yield-locus"):
            self.assertNotIn("measured", [curve["name"] for curve in page.figures[name]["curves"]])
        page, found = self.design("case.yaml", "--set", "wall_friction.angle=60 deg", "--set", "wedge.half_angle=auto")
        self.assertEqual(found["cone"]["outcome"], "funnel_flow")
        slot, = [card for card in pages.cards(page.text) if "to build" in card[3]]  # no other outlet, no half angle
        self.assertEqual((float(slot[0]), slot[2]), (found["rathole"]["slot_width_m"]["high"], "mm"))
        self.assertTrue(slot[3].startswith("width of the slot to build, at least, if it stays funnel flow"), slot)
        self.assertIn("Funnel flow: the solid does not slide along this wall.", page.text)
        self.assertIn("Why: where sigma_1 is 8.000 kPa, phi_e 46.0 deg, and the solid slides at no half angle.", page.text)
        said = [row[1] for row in page.tables[-1] if row[0] == "said in place of the case's value"]
        self.assertEqual(said, ["wall_friction.angle=60 deg", "wedge.half_angle=auto", "interval.samples=100"])

    def test_no_size_within_the_errors_is_no_size_to_build(self):
        """A wall that is too rough in many samples, and a strength that may rise faster than the stress around a rathole."""
        with open(self.path("case.yaml"), "w") as file:
            file.write("flow_function: {file: flow.csv}\nwall_friction: {angle: 30 deg, error: 8 deg}\n")
        with open(self.path("flow.csv"), "w") as file:
            file.write("sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],phi_t [deg],rho_b [kg/m3]\n"
                       "2,1.4,0.05,48,40,1250\n8,2.9,1.5,46,40,1350\n")
        page, found = self.design("case.yaml")
        cards = pages.cards(page.text)
        for of, key, card, words in (("cone", "outlet_m", 1, "outlet to build: no outlet of mass flow is known within the errors. "
                                      "Critical outlet: As measured"),
                                     ("rathole", "emptying_m", 4, "outlet to build in funnel flow: no diameter is known within the errors. "
                                      "As measured")):
            self.assertEqual(found[of][key]["high"], "infinite")
            self.assertEqual(cards[card][:3], (None, "not known", ""))
            self.assertTrue(cards[card][3].startswith(words), cards[card])
            self.assertTrue(cards[card][3].endswith("to infinite mm"), cards[card])
        self.assertNotIn("infinite</b>", page.text)

    def test_warnings_that_differ_in_numbers_alone_are_one(self):
        """The worked case's shear tests at three stresses: two loci have points that lie on no line."""
        for name in ("hopper.yaml", "shear.csv", "wall.csv"):
            shutil.copy(clod.source(f"cases/lab-to-outlet/{name}"), self.folder)
        page, found = self.design()
        kinds = {}
        for text in found["warnings"]:
            kinds.setdefault(re.sub(r"[0-9]+(\.[0-9]+)?", "#", text), []).append(text)
        joined = [texts for texts in kinds.values() if len(texts) > 1]
        self.assertGreater(len(joined), 0)
        self.assertIn("the points do not lie on a line", joined[0][0])
        box = page.text[page.text.index('id="warnings"'):page.text.index('id="decision"')]
        self.assertEqual([int(count) for count in re.findall(r"\(one of ([0-9]+) like it\)", box)],
                         [len(texts) for texts in joined])
        each = [item for texts in kinds.values() for item in (texts[:1] if len(texts) == 1 else [None, *texts])]
        items = page.items[:len(each)]
        self.assertEqual([item for item, of in zip(items, each) if of is not None], [of for of in each if of is not None])

    def test_the_angle_names_its_outlet_on_a_wall_that_holds_the_solid(self):
        """There the half angle is that of the smallest measured stress, not of the critical outlet."""
        for name in ("hopper.yaml", "shear.csv", "wall-rust.csv"):
            shutil.copy(clod.source(f"cases/lab-to-outlet/{name}"), self.folder)
        page, found = self.design("--set", "wall_friction.file=wall-rust.csv", "--set", "cone={half_angle: auto}")
        cone = found["cone"]
        of, critical = (f"{1e3 * value:.1f}" for value in (cone["design_state"]["outlet_m"], cone["outlet_m"]["value"]))
        self.assertNotEqual(of, critical)
        self.assertIn(f"for an outlet of {of} mm. As measured", pages.cards(page.text)[0][3])

    def test_nothing_from_outside_and_names_are_text(self):
        with open(clod.source("cases/hopper-design/hopper.yaml")) as file:
            case = file.read().replace("title: Cohesive solid on steel", "title: A <b> & solid")
        with open(self.path("other.yaml"), "w") as file:
            file.write(case)
        page, _ = self.design("other.yaml")
        self.assertIn("<h1>A &lt;b&gt; &amp; solid</h1>", page.text)
        markup = re.sub(r"<script>.*?</script>", "", page.text, flags=re.S)
        self.assertIsNone(re.search(r"\b(src|href)\s*=|<link|@import|url\(\s*[\"']?http", markup))
        self.assertIn(case, page.words)  # the case as it is
        self.assertEqual(page.row("case")[1], "other.yaml")
        files = sorted(name for name in os.listdir(self.folder) if name.startswith("design-"))
        self.assertEqual(files, sorted(f"design-{name}.svg" for name in page.figures))

    def test_figures_of_an_earlier_design_go_and_files_of_the_user_stay(self):
        self.design("hopper.yaml")
        with open(self.path("design-mine.svg"), "w") as file:
            file.write("<svg/>\n")
        with open(self.path("hopper.yaml")) as file:  # funnel flow has no critical outlet
            case = file.read().replace("wall_friction:\n  file: wall.csv #", "wall_friction: {angle: 60 deg, error: 1 deg} #")
        with open(self.path("rough.yaml"), "w") as file:
            file.write(case)
        page, _ = self.design("rough.yaml")
        self.assertNotIn("outlets", page.figures)
        for name in page.figures:  # the line behind them is XML
            xml.etree.ElementTree.parse(self.path(f"design-{name}.svg"))
        files = sorted(name for name in os.listdir(self.folder) if name.startswith("design-"))
        self.assertEqual(files, sorted(["design-mine.svg", *(f"design-{name}.svg" for name in page.figures)]))
        os.rename(self.path("design-mine.svg"), self.path("new-outlets.svg"))
        named = ["new.html", "new.json", "new.svg"]  # replaced, but not where a figure is refused
        for name in named:
            with open(self.path(name), "w") as file:
                file.write("mine\n")
        done = clod.run("hopper", "hopper.yaml", *pages.FEW, "-o", "new", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("clod hopper: ./new-outlets.svg is in the way of a figure of new.html", done.stderr)
        self.assertEqual(sorted(name for name in os.listdir(self.folder) if name.startswith("new")), ["new-outlets.svg", *named])
        self.assertEqual([clod.read(self.path(name)) for name in named], 3 * [b"mine\n"])
        os.remove(self.path("new-outlets.svg"))
        self.assertEqual(clod.run("hopper", "hopper.yaml", *pages.FEW, "-o", "new", cwd=self.folder).returncode, 0)
        self.assertNotIn(b"mine\n", [clod.read(self.path(name)) for name in named])


if __name__ == "__main__":
    clod.unittest.main()
