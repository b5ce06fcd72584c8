"""clod hopper as a user meets it: template, files, same bytes, and whether a hopper flows."""

import json
import math
import os
import re
import sys
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import CASE, QUICK, ROWS, clod


class Hopper(hopper_case.Case):

    def test_template_runs_and_writes_its_files(self):
        self.assertEqual(clod.run("new", "hopper", cwd=self.folder).returncode, 0)
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["flow-function.csv", "hopper.yaml", "wall.csv"])
        told = self.hopper("hopper.yaml", "-o", "design").stdout
        figures = [name for name in os.listdir(self.folder) if re.fullmatch("design-.*[.]svg", name)]
        self.assertGreater(len(figures), 4)
        wrote = "wrote NAME.json\nwrote NAME.svg\nwrote NAME.html\nwrote NAME-FIGURE.svg, the page's {} figures\n".format(len(figures))
        self.assertTrue(told.endswith("\n" + wrote.replace("NAME", "design")), told)
        as_json = self.hopper("hopper.yaml", "-o", "again", "--json")
        json.loads(as_json.stdout)
        self.assertEqual(as_json.stderr, wrote.replace("NAME", "again"))
        with open(self.path("design.json")) as file:
            found = json.load(file)
        self.assertEqual(found["cone"]["outcome"], "flows")
        for shape in ("cone", "wedge"):
            for key, scale, digits in (("outlet_m", 1e3, 1), ("half_angle_deg", 1, 1),
                                       ("flow_factor", 1, 3), ("sigma_1_Pa", 1e-3, 3)):
                for end in ("value", "low", "high"):
                    self.assertIn(f"{scale * found[shape][key][end]:.{digits}f}", told)
        self.check_chart("design.svg", found)
        again = clod.run("new", "hopper", cwd=self.folder)
        self.assertEqual(again.returncode, 2)
        self.assertIn("File exists", again.stderr)

    def test_a_table_that_is_there_keeps_the_template_from_being_written(self):
        self.write("wall.csv", "mine\n")
        done = clod.run("new", "hopper", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("wall.csv: File exists, and nothing was written", done.stderr)
        self.assertIn("another folder", done.stderr)
        self.assertEqual(os.listdir(self.folder), ["wall.csv"])
        with open(self.path("wall.csv")) as file:
            self.assertEqual(file.read(), "mine\n")

    def check_chart(self, name, found):
        """A picture of well-formed XML, every place in it inside its frame, its numbers those of
        the result."""
        root = xml.etree.ElementTree.parse(self.path(name)).getroot()
        width, height = float(root.get("width")), float(root.get("height"))
        texts = [node.text for node in root.iter("{http://www.w3.org/2000/svg}text")]
        for shape in ("cone", "wedge"):
            factor = found[shape]["flow_factor"]["value"]
            self.assertIn(f"{shape}, ff = {factor:.2f}", texts)
        for mark in root.iter("{http://www.w3.org/2000/svg}circle"):
            self.assertTrue(0 < float(mark.get("cx")) < width)
            self.assertTrue(0 < float(mark.get("cy")) < height)
        for path in root.iter("{http://www.w3.org/2000/svg}path"):
            numbers = [float(x) for x in re.findall(r"-?[0-9.]+", path.get("d"))]
            self.assertTrue(numbers and min(numbers) > 0 and max(numbers) < width)

        for shape, colour in (("cone", "#0072B2"), ("wedge", "#D55E00")):
            self.check_bars(root, colour, found[shape], 70, ("sigma_1_Pa", "strength_Pa"), 1e-3)
            self.check_bars(root, colour, found[shape], 560, ("half_angle_deg", "design_phi_w_deg"), 1)

    def check_bars(self, root, colour, found, left, keys, scale):
        """The bars of the panel whose frame begins at `left` end where the intervals do: read by
        the numbers at the panel's ticks, to a quarter of a pixel at either end."""
        def ticks(across, place):
            return [(float(node.get(across)), float(node.text))
                    for node in root.iter("{http://www.w3.org/2000/svg}text")
                    if place(float(node.get("x")), float(node.get("y")))
                    and re.fullmatch(r"[0-9.e+-]+", node.text)]
        lines = [{end: float(node.get(end)) for end in ("x1", "x2", "y1", "y2")}
                 for node in root.iter("{http://www.w3.org/2000/svg}line")
                 if node.get("stroke") == colour and node.get("stroke-width") is None]
        lines = [line for line in lines if left <= line["x1"] <= left + 400]
        across = next(line for line in lines if line["y1"] == line["y2"])
        upright = next(line for line in lines if line["x1"] == line["x2"])
        below = ticks("x", lambda x, y: y == 394 and left <= x <= left + 400)
        beside = ticks("y", lambda x, y: x == left - 8)
        for marks, ends, key, shift in ((below, (across["x1"], across["x2"]), keys[0], 0),
                                        (beside, (upright["y1"], upright["y2"]), keys[1], -4)):
            (pixel, value), (last_pixel, last_value) = marks[0], marks[-1]
            slope = (last_value - value) / (last_pixel - pixel)
            for end, word in zip(ends, ("low", "high")):
                self.assertAlmostEqual(value + slope * (end - pixel - shift),
                                       scale * found[key][word], delta=0.25 * abs(slope))

    @clod.quick_only
    def test_same_bytes_on_one_processor_and_on_all(self):
        self.start()
        first = self.hopper("case.yaml", "--json").stdout
        one = min(os.sched_getaffinity(0))
        done = clod.run("hopper", "case.yaml", "--json", *QUICK, cwd=self.folder,
                        preexec_fn=lambda: os.sched_setaffinity(0, {one}))
        self.assertEqual(done.stdout, first)
        other = self.found("--set", "interval.seed=2")
        self.assertNotEqual(other["cone"]["outlet_m"]["low"],
                            json.loads(first)["cone"]["outlet_m"]["low"])
        self.assertEqual(other["cone"]["outlet_m"]["value"],
                         json.loads(first)["cone"]["outlet_m"]["value"])

    def test_units_do_not_matter(self):
        self.start()
        first = self.found()["cone"]["outlet_m"]["value"]
        self.write("flow.csv", "sigma_1 (Pa);f_c (mbar);phi_e (rad);rho_b (g/cm3)\n" + "".join(
            f"{1e3 * s};{10 * f};{math.radians(p)};{r / 1000}\n"
            for s, f, p, r in ((2, 1.4, 48, 1250), (4, 1.9, 47, 1300), (8, 2.9, 46, 1350))))
        self.assertAlmostEqual(self.found()["cone"]["outlet_m"]["value"], first, delta=1e-7 * first)

    def test_what_was_said_in_place_of_the_case_is_kept(self):
        self.start()
        found = self.found("--set", "margin=2 deg")
        self.assertEqual(found["overrides"], ["margin=2 deg", QUICK[1]])
        self.assertRegex(found["version"], r"^clod \d")

    def test_a_title_with_control_characters_makes_a_good_picture(self):
        self.start('title: "Ore\\x01 \\e[1m<A> & B"\n' + CASE)
        self.hopper("case.yaml", "-o", "design")
        root = xml.etree.ElementTree.parse(self.path("design.svg")).getroot()
        self.assertEqual(next(root.iter("{http://www.w3.org/2000/svg}text")).text,
                         "Ore [1m<A> & B")

    def drawn(self, *rows):
        """Measured points that the chart has, and its words."""
        self.start(rows="".join(rows))
        self.hopper("case.yaml", "-o", "design")
        root = xml.etree.ElementTree.parse(self.path("design.svg")).getroot()
        marks = [node for node in root.iter("{http://www.w3.org/2000/svg}circle") if node.get("fill") == "#222222"]
        return len(marks), " ".join(node.text for node in root.iter("{http://www.w3.org/2000/svg}text"))

    def test_the_chart_has_the_measured_points_or_tells_of_them(self):
        rows = ROWS.splitlines(keepends=True)
        self.start()
        critical = self.found()
        near = max(3e-3 * max(critical[shape]["sigma_1_Pa"]["value"] for shape in ("cone", "wedge")), 4.0)
        self.assertLess(near, 8.0)
        self.assertGreater(2.0 * near, 8.0)  # to show 8 kPa less than doubles the axis
        count, words = self.drawn(*rows)
        self.assertEqual(count, 3)
        self.assertNotIn("outside", words)
        count, words = self.drawn(*rows, "40,10.9,0.3,45,39,1400\n")  # on the line through the first two
        self.assertEqual(count, 3 if near > 8 else 2)
        self.assertIn(f"{4 - count} of 4 measured points outside; measured up to 40 kPa", words)

    def test_smaller_outlets_arch_and_larger_do_not(self):
        self.start()
        critical = self.found()["cone"]["outlet_m"]["value"]
        shares = []
        for part in (0.5, 1.0, 2.0):
            cone = self.found("--set", f"cone.outlet={part * critical} m")["cone"]
            margin = cone["arching_margin"]["value"]
            self.assertTrue((margin > 1.0) == (part > 1.0) or part == 1.0)
            shares.append(cone["planned_outlet_arching_share"])
        self.assertEqual((shares[0], shares[2]), (1.0, 0.0))
        self.assertTrue(0.2 < shares[1] < 0.8)

    def test_no_arch_says_what_decides(self):
        self.start(CASE + "largest_particle: 10 mm\n", "2,0.1,0,45,40,1250\n8,0.4,0,45,40,1350\n")
        told = self.hopper("case.yaml").stdout
        self.assertIn("no cohesive arch at any outlet", told)
        self.assertRegex(told, r"outlet by particles, 8 times +80\.0 +mm")
        found = self.found()
        self.assertEqual(found["cone"]["outcome"], "no_arch")
        self.assertEqual(found["cone"]["outlet_m"]["value"], 0.0)
        self.assertIsNone(found["cone"]["sigma_1_Pa"]["value"])

    def test_a_solid_that_cannot_flow(self):
        self.start(CASE, "2,3.0,0,45,40,1250\n8,9.0,0,45,40,1350\n")
        self.assertIn("cannot flow by gravity", " ".join(self.hopper("case.yaml").stdout.split()))
        self.assertEqual(self.found()["cone"]["outlet_m"]["value"], "infinite")

    def test_rough_walls_are_funnel_flow_with_a_rathole(self):
        self.start(CASE.replace("angle: 20 deg", "angle: 46 deg"))
        told = self.hopper("case.yaml", "-o", "rough").stdout
        self.assertIn("Funnel flow: the solid does not slide along this wall", told)
        self.assertRegex(told, r"diameter, emptying \(least\) +[0-9]+\.[0-9]")
        self.assertRegex(told, r"critical outlet of mass flow +none +none +none  mm")
        with open(self.path("rough.html")) as file:
            self.assertRegex(file.read(), r"critical outlet of mass flow \[mm\]</th><td>none</td><td>none</td><td>none<")
        with open(self.path("rough.svg")) as file:
            self.assertIn("cone: funnel flow", file.read())

    def test_a_slot_in_funnel_flow(self):
        """f_c = 0.9 kPa + sigma_1/4 meets sigma_1/1.7 at 2.6609 kPa, f_c 1.5652; rho_b is 1266.5 there, between 1250 at 2 and
        1300 at 4 kPa; 1.15 f_c/(rho g) = 144.93 mm. Errors of f_c alone: the width moves by those of f_c there over 1 - 1.7/4."""
        self.start(CASE.replace("angle: 20 deg", "angle: 46 deg"))
        told = self.hopper("case.yaml", "-o", "rough").stdout
        cone, wedge = told.split("\nWedge, slot")
        self.assertIn("otherwise only an outlet wider than the rathole empties.", " ".join(cone.split()))
        self.assertIn("otherwise only a slot empties that is wider than the width in funnel flow, and whose diagonal is longer than "
                      "the rathole's diameter.", " ".join(wedge.split()))
        with open(self.path("rough.json")) as file:
            found = json.load(file)["rathole"]["slot_width_m"]
        stress = 900.0 / (1 / 1.7 - 0.25)
        width = 1.15 * stress / 1.7 / ((1250.0 + 25.0 * (stress / 1e3 - 2.0)) * 9.80665)
        self.assertAlmostEqual(found["value"], width, delta=1e-9)
        self.assertTrue(0.9 * width < found["low"] < 0.98 * width and 1.02 * width < found["high"] < 1.1 * width, found)
        row = re.search(r"  width of a slot in funnel flow +([0-9.]+) +([0-9.]+) +([0-9.]+)  mm\n", wedge)
        self.assertEqual(row.groups(), tuple(f"{1e3 * found[key]:.1f}" for key in ("value", "low", "high")))
        self.assertNotIn("width of a slot", cone)
        self.assertNotIn("for a slot in funnel flow sigma_1", wedge)  # 2.66 kPa is between 2 and 8
        with open(self.path("rough.html")) as file:
            page = file.read()
        self.assertIn(f"width of the slot to build, at least, if it stays funnel flow; its diagonal must be longer than the rathole&#39;s "
                      f"diameter. As measured {1e3 * width:.1f}, within the errors", page.replace("rathole's", "rathole&#39;s"))

    def test_a_wedge_flatter_than_a_cone_may_be_is_not_called_mass_flow(self):
        """The field has a solution for 60 deg, far beyond any chart; headline, shares, warning, JSON and
        chart say that mass flow is not known."""
        self.start(CASE.replace("20 deg", "25 deg") + "wedge: {half_angle: 60 deg, outlet: 1 m}\n")
        told = self.hopper("case.yaml", "-o", "flat").stdout
        cone, wedge = told.split("\nWedge, slot")
        self.assertIn("  Mass flow, and no cohesive arch", cone)
        self.assertNotIn("Mass flow, and", wedge)
        found = self.found()["wedge"]
        limit = found["limit_deg"]["value"]
        self.assertTrue(10.0 < limit < 25.0)
        words = " ".join(wedge.split())
        self.assertIn(f"Not known to be mass flow: a wedge steeper than {limit:.1f} deg is, this one has 60.0 deg.",
                      words)
        self.assertIn(f"half angle of 60.0 deg is {60 - limit:.1f} deg flatter than the limit of mass flow in a "
                      f"cone, {limit:.1f} deg.", words)
        self.assertIn("Outlet of 1000.0 mm, if it is mass flow", wedge)
        self.assertEqual(found["outcome"], "mass_flow_unknown")
        self.assertEqual(found["sample_shares"]["flows"], 0.0)
        self.assertGreater(found["sample_shares"]["mass_flow_unknown"], 0.9)
        with open(self.path("flat.svg")) as file:
            chart = file.read()
        self.assertRegex(chart, r">wedge, ff = [0-9.]+ \(not known to be mass flow\)<")
        self.assertRegex(chart, r">cone, ff = [0-9.]+<")
        # a wedge that is mass flow as measured, and not in some of the samples
        told = self.hopper("case.yaml", "--set", f"wedge.half_angle={limit - 0.1:.2f} deg").stdout
        self.assertRegex(told.split("\nWedge, slot")[1], r"samples .*% not known to be mass flow")
        self.assertRegex(told, r"samples that do not flow +0.0 %\n  perhaps no mass flow +[0-9.]+ %\n")

    def test_a_half_angle_inside_the_margin_is_warned_of(self):
        self.start()
        limit = self.found()["cone"]["limit_deg"]["value"]
        for shape, more in (("cone", ""), ("wedge", " A wedge may be flatter, see docs/theory/hopper.md.")):
            told = self.hopper("case.yaml", "--set", f"{shape}.half_angle={limit - 2} deg").stdout
            warned = " ".join(told.partition("Warnings")[2].split())
            self.assertRegex(warned, rf"{shape.capitalize()}: the half angle of [0-9.]+ deg is steeper than the limit of "
                             rf"mass flow in a cone, [0-9.]+ deg, by less than the margin of 3\.0 deg\.{more} - ")
            told = self.hopper("case.yaml", "--set", f"{shape}.half_angle={limit - 6} deg").stdout
            self.assertNotIn("by less than the margin", " ".join(told.split()))


if __name__ == "__main__":
    clod.unittest.main()
