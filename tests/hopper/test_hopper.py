"""clod hopper as a user meets it: template, files, determinism, shear tests, refusals."""

import json
import math
import os
import re
import sys
import xml.etree.ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

QUICK = ["--set", "interval.samples=100"]
FLOW = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],phi_t [deg],rho_b [kg/m3]\n"
ROWS = "2,1.4,0.05,48,40,1250\n4,1.9,0.05,47,40,1300\n8,2.9,0.08,46,39,1350\n"
CASE = """flow_function: {file: flow.csv}
wall_friction: {angle: 20 deg, error: 1 deg}
"""


class Hopper(clod.Case):

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def hopper(self, *arguments, code=0):
        done = clod.run("hopper", *arguments, *QUICK, cwd=self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def found(self, *arguments):
        return json.loads(self.hopper("case.yaml", "--json", *arguments).stdout)

    def refuse(self, case, words, rows=ROWS, head=FLOW, more=()):
        """The case is refused with exit status 2 and these words."""
        self.write("case.yaml", case)
        self.write("flow.csv", head + rows)
        done = self.hopper("case.yaml", *more, code=2)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def start(self, case=CASE, rows=ROWS):
        self.write("case.yaml", case)
        self.write("flow.csv", FLOW + rows)

    # ---- what comes out

    def test_template_runs_and_writes_its_files(self):
        self.assertEqual(clod.run("new", "hopper", cwd=self.folder).returncode, 0)
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["flow-function.csv", "hopper.yaml", "wall.csv"])
        told = self.hopper("hopper.yaml", "-o", "design").stdout
        self.assertTrue(told.endswith("\nwrote design.json\nwrote design.svg\nwrote design.html\n"), told)
        as_json = self.hopper("hopper.yaml", "-o", "again", "--json")
        json.loads(as_json.stdout)
        self.assertEqual(as_json.stderr, "wrote again.json\nwrote again.svg\nwrote again.html\n")
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
            self.check_bars(root, colour, found[shape], 560, ("half_angle_deg", "phi_w_deg"), 1)

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

    def test_strengths_that_no_tester_gives_are_warned_of(self):
        def warned():
            return " ".join(self.hopper("case.yaml").stdout.split())

        self.start(CASE, "2,3.0,0,45,40,1250\n8,4.0,0,45,40,1350\n")
        self.assertIn("Flow function: f_c is 3 kPa at sigma_1 2 kPa", warned())
        self.write("flow.csv", FLOW + "2,1.4,0,48,40,1250\n8,2.9,0,46,40,1350\n")
        self.assertNotIn("Flow function:", warned())
        self.write("flow.csv", FLOW.replace("kPa", "Pa") + "2,1.4,0,48,40,1250\n8,2.9,0,46,40,1350\n")
        self.assertIn("all its sigma_1 are below 100 Pa", warned())

    def test_rough_walls_are_funnel_flow_with_a_rathole(self):
        self.start(CASE.replace("angle: 20 deg", "angle: 46 deg"))
        told = self.hopper("case.yaml", "-o", "rough").stdout
        self.assertIn("Funnel flow: the solid does not slide along this wall", told)
        self.assertRegex(told, r"diameter, emptying \(least\) +[0-9]+\.[0-9]")
        with open(self.path("rough.svg")) as file:
            self.assertIn("cone: funnel flow", file.read())

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

    def test_where_the_spread_comes_from(self):
        """The share of a measurement is the variance that is there with its errors alone, over that with all of
        them: other runs, other samples. 400 samples tell a variance to 7 % (sqrt(2/n)), so a share to 0.1."""
        head = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],phi_t [deg],rho_b [kg/m3],rho_b_error [kg/m3]\n"
        rows = [[2, 1.4, 0.05, 48, 40, 1250, 50], [4, 1.9, 0.05, 47, 40, 1300, 50], [8, 2.9, 0.08, 46, 39, 1350, 50]]
        samples = ("--set", "interval.samples=400")

        def outlets(strength, wall, density):
            self.write("case.yaml", CASE if wall else CASE.replace(", error: 1 deg", ""))
            self.write("flow.csv", head + "".join(
                ",".join(map(str, (a, b, c if strength else 0, d, e, f, g if density else 0))) + "\n"
                for a, b, c, d, e, f, g in rows))
            done = clod.run("hopper", "case.yaml", "--json", *samples, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads(done.stdout)

        def variance(found, shape):
            """From the 10 % and 90 % quantiles, as of a normal distribution."""
            of = found[shape]["outlet_percentiles_m"]
            self.assertEqual(of, sorted(of))
            return ((of[90] - of[10]) / 2.5631) ** 2

        every = outlets(True, True, True)
        alone = {"flow_function": outlets(True, False, False), "wall": outlets(False, True, False),
                 "rho_b": outlets(False, False, True)}
        for shape in ("cone", "wedge"):
            shares = every[shape]["outlet_variance_shares"]
            self.assertEqual(sorted(shares), ["flow_function", "phi_e", "rho_b", "wall"])
            self.assertEqual(shares["phi_e"], 0.0)  # it has no errors
            self.assertAlmostEqual(sum(shares.values()), 1.0, delta=0.1)
            for name, found in alone.items():
                self.assertAlmostEqual(shares[name], variance(found, shape) / variance(every, shape), delta=0.1, msg=name)
                self.assertGreater(found[shape]["outlet_variance_shares"][name], 0.98)
            low, high = every[shape]["outlet_m"]["low"], every[shape]["outlet_m"]["high"]
            self.assertEqual((low, high), tuple(every[shape]["outlet_percentiles_m"][at] for at in (5, 95)))

    def test_what_was_said_in_place_of_the_case_is_kept(self):
        self.start()
        found = self.found("--set", "margin=2 deg")
        self.assertEqual(found["overrides"], ["margin=2 deg", QUICK[1]])
        self.assertRegex(found["version"], r"^clod \d")

    def test_what_is_not_known_is_not_printed(self):
        """No state "there" without a critical outlet: 46 deg of the wall are not 90, and samples that have
        one do not make an interval of a number without a value."""
        self.start(CASE.replace("angle: 20 deg, error: 1 deg", "angle: 46 deg, error: 8 deg"))
        told = self.hopper("case.yaml").stdout
        for name in ("flow factor ff", "critical sigma_1", "phi_e there", "wall friction angle there",
                     "bulk density there", r"H\(theta\)"):
            self.assertEqual(len(re.findall(name + r" +- +- +- *(?:deg|kPa|kg/m3)?\n", told)), 2, (name, told))
        self.assertEqual(len(re.findall(r"half angle +none ", told)), 2)
        cone = self.found()["cone"]
        self.assertGreater(cone["sample_shares"]["flows"], 0.05)
        self.assertEqual(cone["phi_w_deg"], {"value": None, "low": None, "high": None})
        self.start(CASE, "2,0.1,0,45,40,1250\n8,0.4,0,45,40,1350\n")  # no arch at any outlet
        cone = self.found()["cone"]
        for key in ("phi_e_deg", "phi_w_deg", "rho_b_kg_m3"):
            self.assertIsNone(cone[key]["value"])
        self.assertIsNotNone(cone["flow_factor"]["value"])

    def test_ratholes_where_jenikes_function_is_not_known(self):
        """G is known from 30 to 70 deg. phi_t of 29 +- 4 deg has no rathole, and no interval of those samples
        that have; 31 +- 4 deg has one, and what its interval is from is said: P(normal < -0.25) = 40 %."""
        head = FLOW.replace("phi_t [deg]", "phi_t [deg],phi_t_error [deg]")
        more = CASE + "silo: {diameter: 3 m, height: 8 m}\n"
        self.start(more)
        self.write("flow.csv", head + "2,1.4,0.05,48,29,4,1250\n8,2.9,0.08,46,29,4,1350\n")
        told = self.hopper("case.yaml").stdout
        self.assertRegex(told, r"diameter, emptying \(least\) +- +- +- +mm\n")
        self.assertRegex(told, r"diameter, after filling \(most\) +- +- +- +mm\n")
        words = " ".join(told.split())
        for when in ("emptying", "after filling"):
            self.assertIn(f"No rathole diameter, {when}: Jenike's function G is known from 30 to 70 deg, and the "
                          "static angle of internal friction is 29.0 deg.", words)
        self.write("case.yaml", more + "static_friction: {angle: 31 deg, error: 4 deg}\n")
        told = " ".join(self.hopper("case.yaml").stdout.split())
        shares = self.found()["rathole"]["known_shares"]
        for when, key in (("emptying", "emptying"), ("after filling", "filling")):
            self.assertAlmostEqual(shares[key], 0.6, delta=0.15)  # of 100 samples: 3 x 0.049
            self.assertIn(f"Rathole, {when}: in {100 * (1 - shares[key]):.1f} % of the samples the static angle of "
                          "internal friction is outside 30 to 70 deg", told)

    def test_intervals_without_errors_are_the_value(self):
        """To the last printed digit, at an outlet that is nearly infinite."""
        self.start(CASE.replace(", error: 1 deg", ""), "2,2.5,0,48,40,1250\n8,6.85,0,46,40,1350\n")
        told = self.hopper("case.yaml").stdout
        rows = re.findall(r"^  [a-z].*?  +([0-9.]+) +([0-9.]+) +([0-9.]+)(?:  \S+)?$", told, re.MULTILINE)
        self.assertGreater(len(rows), 15)
        for value, low, high in rows:
            self.assertEqual((low, high), (value, value), told)

    def test_extrapolation_is_said(self):
        self.start(CASE, "20,4.2,0,45,40,1250\n40,7.2,0,45,40,1350\n")
        self.assertIn("outside what was measured, 20.000 to 40.000 kPa: an extrapolation",
                      " ".join(self.hopper("case.yaml").stdout.split()))

    def test_shear_tests_are_evaluated_as_by_locus(self):
        """Points, a results folder, and what clod locus --csv prints of all: the same design."""
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
        low = "".join(f"4,3.4,{s},{0.7 + 0.75 * s},1300\n" for s in (1.0, 2.0, 3.0))
        high = "".join(f"10,8.1,{s},{1.2 + 0.73 * s},1350\n" for s in (2.5, 5.0, 7.5))
        self.write("low.csv", head + low)
        os.mkdir(self.path("run"))
        self.write("run/points.csv", head + high)
        self.write("case.yaml", "flow_function: {shear_tests: [{points: low.csv}, {points: run}]}\n"
                   "wall_friction: {angle: 18 deg}\n")
        found = self.found()
        self.assertEqual(len(found["measured"]["flow_function"]), 2)
        self.assertGreater(len(found["measured"]["phi_t"]), 1)
        self.assertEqual(found["cone"]["outcome"], "flows")
        self.write("all.csv", head + low + high)
        loci = clod.run("locus", "all.csv", "--csv", cwd=self.folder).stdout
        self.write("loci.csv", loci)
        self.write("case.yaml", "flow_function: {file: loci.csv}\n"
                   "wall_friction: {angle: 18 deg}\n")
        table = self.found()
        for key in ("outlet_m", "half_angle_deg", "flow_factor"):
            self.assertAlmostEqual(table["cone"][key]["value"], found["cone"][key]["value"],
                                   delta=1e-6 * found["cone"][key]["value"])

    def test_warnings_of_yield_loci_are_handed_on(self):
        """Two points make a line without a scatter; clod locus says so, and so does the hopper."""
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
        self.write("low.csv", head + "".join(
            f"4,3.4,{s},{0.7 + 0.75 * s},1300\n" for s in (1.0, 3.0)))
        self.write("high.csv", head + "".join(
            f"10,8.1,{s},{1.2 + 0.73 * s},1350\n" for s in (2.5, 5.0, 7.5)))
        self.write("case.yaml", "flow_function: {shear_tests: [{points: low.csv}, "
                   "{points: high.csv}]}\nwall_friction: {angle: 18 deg}\n")
        locus = json.loads(clod.run("locus", "low.csv", "--json", cwd=self.folder).stdout)
        said = locus["loci"][0]["warnings"]
        self.assertTrue(any("two points" in text for text in said), said)
        found = self.found()["warnings"]
        for text in said:
            self.assertIn("Yield locus at a preshear stress of 4.000 kPa: " + text, found)

    def test_a_wall_of_several_specimens(self):
        """Three specimens of one friction angle, whose side walls carried more or less: the angle
        has no interval. Those of other friction have that of their mean: tan 0.20, 0.22, 0.24."""
        rows = [(seed, stress, stress * part, stress * part * 0.2) for seed, part in
                ((1, 0.96), (2, 0.91), (3, 0.87)) for stress in (20, 10, 5)]
        head = "seed,wall_stress [kPa],sigma_w [kPa],tau_w [kPa],steady [1]\n"
        wall = head + "".join(f"{a},{b},{c},{d},1\n" for a, b, c, d in rows)
        self.start(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: wall.csv}"))
        self.write("wall.csv", wall)
        cone = self.found("--set", "interval.samples=1000")["cone"]["phi_w_deg"]
        for end in ("value", "low", "high"):
            self.assertAlmostEqual(cone[end], math.degrees(math.atan(0.2)), places=4)
        self.write("wall.csv", head + "".join(
            f"{a},{b},{c},{d * (0.9 + 0.1 * a)},1\n" for a, b, c, d in rows))
        cone = self.found("--set", "interval.samples=1000")["cone"]["phi_w_deg"]
        tangents = [math.tan(math.radians(cone[end])) for end in ("low", "value", "high")]
        error = 0.02 / math.sqrt(3)
        for got, sign in zip(tangents, (-1, 0, 1)):
            self.assertAlmostEqual(got, 0.22 + sign * 1.645 * error, delta=0.3 * error)

    def test_a_run_that_is_not_finished(self):
        """Its folder has no table yet."""
        os.mkdir(self.path("run"))
        self.refuse(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: run}"),
                    ["run: the folder has no wall_friction.csv: its run is not finished"])
        self.refuse("flow_function: {shear_tests: [{points: run}]}\nwall_friction: {angle: 20 deg}\n",
                    ["run: the folder has no points.csv: its run is not finished"])

    def test_warnings_of_a_wall_yield_locus_are_handed_on(self):
        """clod locus and the hopper say the same of a bent one that was not steady."""
        self.start(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: wall.csv}"))
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa],steady [1]\n"
                   "1,0.7,0\n2,0.6,0\n4,2.4,0\n8,2.6,1\n")
        said = json.loads(clod.run("locus", "wall.csv", "--json", cwd=self.folder).stdout)
        self.assertEqual(len(said["warnings"]), 2, said["warnings"])
        found = self.found()["warnings"]
        for text in [*said["warnings"], f"errors of {said['errors_note']}."]:
            self.assertIn("Wall yield locus: " + text, found)

    def test_a_title_with_control_characters_makes_a_good_picture(self):
        self.start('title: "Ore\\x01 \\e[1m<A> & B"\n' + CASE)
        self.hopper("case.yaml", "-o", "design")
        root = xml.etree.ElementTree.parse(self.path("design.svg")).getroot()
        self.assertEqual(next(root.iter("{http://www.w3.org/2000/svg}text")).text,
                         "Ore [1m<A> & B")

    # ---- what is refused

    def test_cases_with_mistakes(self):
        bad = CASE.replace("angle: 20 deg", "angle: 20")
        self.refuse(bad, ["case.yaml:2:24: wall_friction.angle", "deg", "^"])
        self.refuse(CASE.replace("20 deg", "95 deg"), ["is out of range", "85 deg"])
        self.refuse(CASE + "marign: 2 deg\n", ["marign", "did you mean margin?"])
        self.refuse("wall_friction: {angle: 20 deg}\n", ["needs the key flow_function"])
        self.refuse("flow_function: {curve: line}\nwall_friction: {angle: 20 deg}\n",
                    ["case.yaml:1:1: flow_function", "needs file"])
        self.refuse("flow_function: {file: flow.csv}\nwall_friction: {error: 1 deg}\n",
                    ["case.yaml:2:1: wall_friction", "needs file or angle"])
        self.refuse(CASE.replace("angle:", "file: w.csv, angle:"),
                    ["has file and angle; keep one of them"])
        self.refuse(CASE, ["margin", "is out of range"], more=["--set", "margin=40 deg"])
        self.refuse("", ["is empty; clod new hopper writes an example"])
        self.refuse("- a\n", ["must be a section with keys"])

    def test_a_case_for_another_verb(self):
        clod.run("new", "hopper", cwd=self.folder)
        clod.run("new", "free-run", cwd=self.folder)
        done = self.hopper("free-run.yaml", code=2)
        self.assertIn("free-run.yaml:3:1: is a simulation's case, not a hopper's case; clod run",
                      done.stderr)
        self.assertNotIn("not known", done.stderr)
        self.write("card.yaml", "contacts:\n  default: {k_adh: 1e6 N/m^1.5}\n")
        self.write("plan.yaml", "tests: {}\ntargets: []\n")
        said = {"hopper.yaml": "is a hopper's case, not a simulation's case; clod hopper reads it",
                "plan.yaml": "is the plan of a calibration, not a simulation's case; clod calibrate",
                "card.yaml": "is a material card, not a simulation's case; a simulation's case takes "
                             "it in with include: FILE"}
        for verb in ("run", "check", "contact"):
            for name, text in said.items():
                done = clod.run(verb, name, cwd=self.folder)
                self.assertEqual(done.returncode, 2)
                self.assertIn(text, done.stderr)
                self.assertNotIn("not known", done.stderr)
        for name in ("plan.yaml", "card.yaml"):
            self.assertIn(said[name].replace("a simulation's case", "a hopper's case", 1),
                          self.hopper(name, code=2).stderr)
        done = clod.run("calibrate", "hopper.yaml", cwd=self.folder)
        if "without GSL" not in done.stderr:
            self.assertEqual(done.returncode, 2)
            self.assertIn("is a hopper's case, not the plan of a calibration", done.stderr)

    def test_shear_points_without_preshear(self):
        """Only clod locus has options for it."""
        tests = "flow_function: {shear_tests: [{points: p.csv}]}\nwall_friction: {angle: 18 deg}\n"
        self.write("p.csv", "sigma_sh [kPa],tau_sh [kPa]\n1,1.4\n2,2.1\n")
        self.refuse(tests, ["p.csv:1: the header has no column sigma_pre; add it."])
        self.write("p.csv", "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
                   "4,,1,1.4\n")
        self.refuse(tests, ['p.csv:2: column tau_pre: "" is empty; fill it in.'])
        self.assertNotIn("--tau-pre", self.hopper("case.yaml", code=2).stderr)

    def test_yield_loci_that_no_solid_has(self):
        """A falling one and one whose sigma_2 is tension say so, not that a column is missing. By hand, of the
        second: tau = 9 + 0.577 sigma, and the circle through the preshear point (4, 11) that touches it."""
        tests = "flow_function: {shear_tests: [{points: p.csv}, {points: q.csv}]}\nwall_friction: {angle: 18 deg}\n"
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
        for cohesion, slope, tau_pre, words in (
                (3.0, -0.5, 1.5, ["p.csv:2, 3, 4: the yield locus at a preshear stress of 4.000 kPa has phi_lin = -26.57 deg; "
                                  "it must be 1 to 80 deg.", "Have sigma_sh and tau_sh been exchanged"]),
                (9.0, 0.577, 11.0, ["phi_e is undefined in every yield locus, since sigma_2 is tension (-",
                                    "at a preshear stress of 4.000 kPa)", "give the key effective_friction."])):
            for name, times in (("p.csv", 1), ("q.csv", 2)):
                self.write(name, head + "".join(
                    f"{4 * times},{times * tau_pre},{times * s},{times * (cohesion + slope * s)},1300\n"
                    for s in (1.0, 2.0, 3.0)))
            self.refuse(tests, words)
            self.assertNotIn("neither the key", self.hopper("case.yaml", code=2).stderr)

    def test_shear_stresses_in_another_unit(self):
        """Of a results folder and a file, the second has tau_sh in Pa with kPa above it: by hand atan(0.00073)."""
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [{}],rho_b [kg/m3]\n"
        os.mkdir(self.path("run"))
        self.write("run/points.csv", head.format("kPa") + "".join(
            f"4,3.4,{s},{0.7 + 0.75 * s},1300\n" for s in (1.0, 2.0, 3.0)))
        self.write("high.csv", "# laboratory\n" + head.format("Pa") + "".join(
            f"10,8.1,{s},{1.2 + 0.73 * s},1350\n" for s in (2.5, 5.0, 7.5)))
        self.refuse("flow_function: {shear_tests: [{points: run}, {points: high.csv}]}\nwall_friction: {angle: 18 deg}\n",
                    ["high.csv:3, 4, 5: the yield locus at a preshear stress of 10.000 kPa has "
                     "phi_lin = 0.04 deg; it must be 1 to 80 deg."])

    def test_tables_with_mistakes(self):
        self.refuse(CASE, ["flow.csv:1: the header has no column f_c", "sigma_1 [kPa],f_c"],
                    head=FLOW.replace("f_c [kPa],", "", 1))
        self.refuse(CASE, ['flow.csv:1: there is no column "sigma1"', "sigma_1"],
                    head=FLOW.replace("sigma_1", "sigma1"))
        self.refuse(CASE, ["flow.csv:1: column f_c has no unit"],
                    head=FLOW.replace("f_c [kPa]", "f_c"))
        self.refuse(CASE, ["flow.csv:1: column phi_e [kPa]", "an angle"],
                    head=FLOW.replace("phi_e [deg]", "phi_e [kPa]"))
        self.refuse(CASE, ['flow.csv:2: column phi_e: "95" must be below 90'],
                    rows=ROWS.replace("48", "95"))
        self.refuse(CASE, ['flow.csv:2: column f_c: "-1.4" must be 0 or more'],
                    rows=ROWS.replace("1.4", "-1.4", 1))
        self.refuse(CASE, ["flow.csv:3: 5 cells, but the header has 6 columns"],
                    rows=ROWS.replace("1300", "").replace("40,\n4", "40\n4").replace(
                        "47,40,", "47,40"))
        self.refuse(CASE, ["flow.csv:2: column rho_b: 1.21 kg/m3 is outside 10 to 15000 kg/m3",
                           "[g/cm3]?"], rows="2,1.4,0,48,40,1.21\n8,2.9,0,46,39,1.3\n")
        self.write("rho.csv", "sigma_1 [kPa],rho_b [kg/m3]\n2,1210\n8,1.3\n")
        self.refuse(CASE + "bulk_density: {file: rho.csv}\n",
                    ["rho.csv:3: column rho_b: 1.3 kg/m3 is outside", "[g/cm3]?"])
        self.refuse(CASE + "bulk_density: {value: 1.21 kg/m3}\n",
                    ["bulk_density.value", "is out of range", "10"])
        self.refuse(CASE.replace("flow.csv", "none.csv"), ["none.csv", "No such file"])

    def test_measurements_that_cannot_be(self):
        self.refuse(CASE, ["static angle of internal friction", "above the effective one",
                           "interchanged?"], rows="2,1.4,0,40,48,1250\n8,2.9,0,39,46,1350\n")
        self.refuse(CASE, ["make no flow function"], rows="2,1.4,0,48,40,1250\n")
        self.refuse(CASE, ["phi_e is not known", "effective_friction"],
                    head="sigma_1 [kPa],f_c [kPa],rho_b [kg/m3]\n",
                    rows="2,1.4,1250\n8,2.9,1300\n")
        self.refuse(CASE, ["rho_b is not known", "bulk_density"],
                    head="sigma_1 [kPa],f_c [kPa],phi_e [deg]\n", rows="2,1.4,48\n8,2.9,47\n")
        self.refuse(CASE.replace("flow.csv", "flow.csv, curve: points"),
                    ["two points at nearly the same stress", "curve: line"],
                    rows="2,1.4,0,48,40,1250\n2.01,1.5,0,48,40,1250\n8,2.9,0,46,40,1350\n")

    def test_the_command_line(self):
        self.assertIn("which case?", self.hopper(code=2).stderr)
        self.start()
        self.assertIn("one case at a time", self.hopper("case.yaml", "case.yaml", code=2).stderr)
        self.assertIn("none.yaml", self.hopper("none.yaml", code=2).stderr)
        self.assertEqual(self.hopper("case.yaml", "-o", "no/folder", code=1).returncode, 1)


if __name__ == "__main__":
    clod.unittest.main()
