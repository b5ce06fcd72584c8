"""What clod hopper makes of what was measured: flow functions, shear tests, wall friction, and the spread of their errors."""

import json
import math
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import CASE, FLOW, clod


class Measured(hopper_case.Case):

    def test_strengths_that_no_tester_gives_are_warned_of(self):
        def warned():
            return " ".join(self.hopper("case.yaml").stdout.split())

        self.start(CASE, "2,3.0,0,45,40,1250\n8,4.0,0,45,40,1350\n")
        self.assertIn("Flow function: f_c is 3 kPa at sigma_1 2 kPa", warned())
        self.write("flow.csv", FLOW + "2,1.4,0,48,40,1250\n8,2.9,0,46,40,1350\n")
        self.assertNotIn("- Flow function:", warned())
        self.write("flow.csv", FLOW.replace("kPa", "Pa") + "2,1.4,0,48,40,1250\n8,2.9,0,46,40,1350\n")
        self.assertIn("all its sigma_1 are below 100 Pa", warned())

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

    def specimens(self, number=lambda seed, stress: seed, left_out=()):
        """A design from the shear points of cases/lab-to-outlet, specimens numbered anew."""
        with open(clod.source("cases/lab-to-outlet/shear.csv")) as file:
            lines = [line for line in file.read().splitlines() if line and not line.startswith("#")]
        rows = [line.split(",", 2) for line in lines[1:]]
        self.write("shear.csv", "\n".join([lines[0]] + [
            f"{number(int(seed), float(stress))},{stress},{rest}" for seed, stress, rest in rows
            if (int(seed), float(stress)) not in left_out]) + "\n")
        self.write("case.yaml", "flow_function: {shear_tests: [{points: shear.csv}]}\n"
                   "wall_friction: {angle: 14 deg, error: 0.1 deg}\nwedge: {half_angle: 30 deg}\n")
        return self.found()

    def test_specimens_of_shear_tests_are_designed_alone_too(self):
        """As from a file that has only their points; one that is not at all stresses has no design."""
        found = self.specimens()
        self.assertEqual([one["seed"] for one in found["specimens"]], [101, 102, 103])
        self.assertTrue([text for text in found["warnings"] if text.startswith(
            "Yield loci: the intervals rest on the scatter of 3 specimens")], found["warnings"])
        told = self.hopper("case.yaml").stdout
        for one in found["specimens"]:
            others = [(seed, stress) for seed in (101, 102, 103) for stress in (0.6, 1.2, 2.4) if seed != one["seed"]]
            alone = self.specimens(left_out=others)
            self.assertEqual(alone["specimens"], [])
            self.assertFalse([text for text in alone["warnings"] if "rest on the scatter" in text])
            for shape in ("cone", "wedge"):
                for key in ("outlet_m", "half_angle_deg"):
                    self.assertAlmostEqual(one[shape][key], alone[shape][key]["value"],
                                           delta=1e-9 * alone[shape][key]["value"])
                self.assertIn(f"{1e3 * one[shape]['outlet_m']:.1f} (seed {one['seed']})", " ".join(told.split()))
        self.specimens()
        self.hopper("case.yaml", "-o", "design")
        with open(self.path("design.html")) as file:
            page = file.read()
        for shape in ("cone", "wedge"):
            outlets = [f"{1e3 * one[shape]['outlet_m']:.1f}" for one in found["specimens"]]
            self.assertIn(f"; each specimen alone: {', '.join(outlets)} mm</span>", page)
        partly = self.specimens(left_out=[(102, 1.2)])
        self.assertEqual([one["seed"] for one in partly["specimens"]], [101, 103])

    @clod.quick_only
    def test_specimens_are_drawn_together(self):
        """Their outlets are 42 to 43 mm; in another order at one stress they are 0 to 69 mm. So is the interval.
        And the order at all stresses at once changes nothing but the random numbers."""
        def width(found):
            return 1e3 * (found["wedge"]["outlet_percentiles_m"][75] - found["wedge"]["outlet_percentiles_m"][25])

        def outlets(found):
            return [1e3 * one["wedge"]["outlet_m"] for one in found["specimens"]]

        found = self.specimens()
        self.assertLess(max(outlets(found)) - min(outlets(found)), 1.0)
        turned = self.specimens(lambda seed, stress: 101 + (seed - 100) % 3 if stress == 2.4 else seed)
        self.assertGreater(max(outlets(turned)) - min(outlets(turned)), 10.0)
        self.assertGreater(width(turned), 3.0 * width(found))
        self.assertAlmostEqual(width(self.specimens(lambda seed, stress: 300 - seed)), width(found), delta=0.4 * width(found))

    def test_a_wall_of_several_specimens(self):
        """Three specimens of one friction angle, whose side walls carried more or less: the angle
        has no interval. Those of other friction have that of their mean: tan 0.20, 0.22, 0.24. 5 % of
        Student's t of 2 lie above 2.920, which 1000 samples tell to sqrt(0.05 x 0.95/1000)/0.0293 = 0.235."""
        rows = [(seed, stress, stress * part, stress * part * 0.2) for seed, part in
                ((1, 0.96), (2, 0.91), (3, 0.87)) for stress in (20, 10, 5)]
        head = "seed,wall_stress [kPa],sigma_w [kPa],tau_w [kPa],steady [1]\n"
        wall = head + "".join(f"{a},{b},{c},{d},1\n" for a, b, c, d in rows)
        self.start(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: wall.csv}"))
        self.write("wall.csv", wall)
        cone = self.found()["cone"]["phi_w_deg"]
        for end in ("value", "low", "high"):
            self.assertAlmostEqual(cone[end], math.degrees(math.atan(0.2)), places=4)
        self.write("wall.csv", head + "".join(
            f"{a},{b},{c},{d * (0.9 + 0.1 * a)},1\n" for a, b, c, d in rows))
        done = clod.run("hopper", "case.yaml", "--json", "--set", "interval.samples=1000", cwd=self.folder)
        found = json.loads(done.stdout)
        cone = found["cone"]["phi_w_deg"]
        tangents = [math.tan(math.radians(cone[end])) for end in ("low", "value", "high")]
        error = 0.02 / math.sqrt(3)
        for got, sign in zip(tangents, (-1, 0, 1)):
            self.assertAlmostEqual(got, 0.22 + sign * 2.920 * error, delta=0.7 * error)
        self.assertTrue([text for text in found["warnings"] if text.startswith(
            "Wall yield locus: the intervals rest on the scatter of 3 specimens")], found["warnings"])

    def test_a_wall_without_errors_has_those_of_its_scatter(self):
        """Points off tau = 50 Pa + 0.4 sigma by 40, -40, -40, 40 Pa, which no line takes up: 56.6 Pa with 2 degrees of freedom, of
        which 5 % of Student's t are beyond 2.920; the wall friction angle between two points has the errors of both. 1000 samples
        tell the end to 0.235 (as above). A fall of tau_w is no scatter."""
        self.start(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: wall.csv}"))
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa]\n1.5,0.69\n3,1.21\n4.5,1.81\n6,2.49\n")
        done = clod.run("hopper", "case.yaml", "--json", "--set", "interval.samples=1000", "--set", "cone.outlet=800 mm",
                        cwd=self.folder)
        found = json.loads(done.stdout)
        cone, scatter = found["cone"], 40 * math.sqrt(2)
        stress = cone["design_state"]["sigma_w_Pa"]
        self.assertTrue(1.5e3 < stress < 6e3, stress)
        part = stress / 1.5e3 % 1
        error = scatter * math.hypot(part, 1 - part) / stress
        tangents = [math.tan(math.radians(cone["design_phi_w_deg"][end])) for end in ("low", "value", "high")]
        for k in (0, 2):
            self.assertAlmostEqual(abs(tangents[k] - tangents[1]) / error, 2.920, delta=0.7)
        for point in found["measured"]["wall"]:
            self.assertAlmostEqual(point["y_error"], scatter, delta=1e-9)
        said = " ".join(found["warnings"])
        self.assertIn("Wall yield locus: points without an error, or with a smaller one, get what the 4 points scatter by about their line, 0.0566 kPa, drawn "
                      "from Student's t of 2 degrees of freedom", said)
        self.assertIn("Wall yield locus: errors of one specimen", said)
        self.assertNotIn("wall friction", said[said.find("Without errors"):])
        self.assertIsNotNone(cone["outlet_variance_shares"]["wall"])
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa]\n1.5,0.69\n3,1.21\n4.5,0.7\n6,2.49\n")
        self.assertIn("the wall yield locus falls", self.hopper("case.yaml", code=2).stderr)

    def test_a_wall_of_which_nobody_knows_the_errors(self):
        """Two stresses, three on a line to the last digit, or an angle: limit and half angle have no interval, the wall no share, and
        no warning speaks of its errors as known. A half angle or a limit with its error that is given is none of the wall's."""
        wall = "sigma_w [kPa],tau_w [kPa]\n1,0.4\n4,1.6\n"
        for table in (wall, None) if clod.SANITIZED else (wall, wall + "6,2.4\n", None):
            self.start(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: wall.csv}" if table else "{angle: 21.8 deg}"))
            self.write("wall.csv", table or "")
            found = self.found()
            for shape in ("cone", "wedge"):
                for key in ("limit_deg", "half_angle_deg", "phi_w_deg", "design_phi_w_deg", "arch_thickness"):
                    of = found[shape][key]
                    self.assertGreater(of["value"], 0.0)
                    self.assertEqual([of[end] for end in ("low", "high", "low_error", "high_error")], 4 * [None], key)
                self.assertIsNone(found[shape]["outlet_variance_shares"]["wall"])
                self.assertGreater(found[shape]["outlet_m"]["high"], found[shape]["outlet_m"]["value"])
            said = found["warnings"]
            self.assertEqual(len([text for text in said if text.startswith("How far the limit of mass flow may be off is not known")]), 1)
            self.assertEqual(len([text for text in said if "Without errors" in text and "wall friction" in text]), 1, said)
            self.assertFalse([text for text in said if "errors of one specimen" in text], said)
            told = self.hopper("case.yaml", "-o", "design").stdout
            self.assertEqual(len(re.findall(r"half angle +[0-9.]+ +- +-  deg", told)), 2, told)
            with open(self.path("design.html")) as file:
                page = file.read()
            self.assertNotIn("right for", page)
            self.assertIn("half angle as measured, from the vertical, for the critical outlet: how much steeper to build is not known", page)
            self.assertIn("<tr><th>wall friction</th><td>-</td><td>-</td></tr>", page)
        wedge = self.found("--set", "wedge={half_angle: 15 deg}")["wedge"]
        self.assertEqual([wedge["half_angle_deg"]["low"], wedge["limit_deg"]["low"]], [wedge["half_angle_deg"]["value"], None])
        self.hopper("case.yaml", "-o", "design", "--set", "wall_friction.error=1 deg", "--set", "wedge={limit: 30 deg}")
        with open(self.path("design.html")) as file:
            page = file.read()
        self.assertEqual(page.count("right for"), 1)
        self.assertIn("how much steeper to build is not known, since the limit that is given has no limit_error", page)
        wedge = self.found("--set", "wedge={limit: 30 deg, limit_error: 1 deg}")["wedge"]
        self.assertLess(wedge["half_angle_deg"]["low"], 26.0)
        self.assertIsNone(wedge["design_phi_w_deg"]["low"])

    def test_a_loose_density(self):
        """At sigma_1 0, as every report has it, straight to the next point: 1000 + (1250 - 1000) sigma_1/2 kPa. Without it rho_b is
        held below 2 kPa, which a warning says. A table for clod locus has no such row."""
        self.start(CASE + "bulk_density: {file: rho.csv}\n", "2,0.9,0.05,48,40,1250\n4,1.3,0.05,47,40,1300\n8,2.1,0.08,46,39,1350\n")
        rows = "2,1250\n4,1300\n8,1350\n"
        self.write("rho.csv", "sigma_1 [kPa],rho_b [kg/m3]\n" + rows)
        held = self.found()
        said, = [text for text in held["warnings"] if text.startswith("Bulk density: ")]
        stress = 1e-3 * min(held[shape]["sigma_1_Pa"]["value"] for shape in ("cone", "wedge"))
        self.assertIn(f"sigma_1 is {stress:.3f} kPa, below the smallest at which it was measured, 2.000 kPa, whose 1250 kg/m3 is taken there", said)
        self.assertEqual(held["cone"]["rho_b_kg_m3"]["value"], 1250.0)
        self.write("rho.csv", "sigma_1 [kPa],rho_b [kg/m3]\n0,1000\n" + rows)
        found = self.found()
        self.assertEqual([text for text in found["warnings"] if text.startswith("Bulk density: ")], [])
        for shape in ("cone", "wedge"):
            of = found[shape]
            self.assertAlmostEqual(of["rho_b_kg_m3"]["value"], 1000 + 0.125 * of["sigma_1_Pa"]["value"], delta=1e-6)
            self.assertAlmostEqual(of["outlet_m"]["value"] * of["rho_b_kg_m3"]["value"], 1250 * held[shape]["outlet_m"]["value"],
                                   delta=1e-4 * 1250 * held[shape]["outlet_m"]["value"])
        self.write("rho.csv", "sigma_1 [kPa],rho_b [kg/m3]\n2,78\n4,81.2\n8,84.3\n")
        said, = [text for text in self.found()["warnings"] if "lb/ft3" in text]
        self.assertIn("rho_b is 78.0 kg/m3", said)
        self.assertIn("78.0 lb/ft3 are 1249 kg/m3", said)  # of 16.0185 kg/m3
        self.write("rho.csv", "sigma_1 [kPa],rho_b [kg/m3]\n0,1000\n" + rows)
        done = clod.run("locus", "rho.csv", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("rho.csv: a row has sigma_1 = 0, that of a loose density. Only clod hopper takes it", done.stderr)
        self.write("rho.csv", "sigma_1 [kPa],rho_b [kg/m3]\n-1,1000\n" + rows)
        self.assertIn("must be 0 or more", self.hopper("case.yaml", code=2).stderr)

    def test_warnings_of_a_wall_yield_locus_are_handed_on(self):
        """clod locus and the hopper say the same of a bent one that was not steady."""
        self.start(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: wall.csv}"))
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa],steady [1]\n"
                   "1,0.6,0\n2,0.6,0\n4,2.4,0\n8,2.6,1\n")
        said = json.loads(clod.run("locus", "wall.csv", "--json", cwd=self.folder).stdout)
        self.assertEqual(len(said["warnings"]), 2, said["warnings"])
        found = self.found()["warnings"]
        for text in [*said["warnings"], f"errors of {said['errors_note']}."]:
            self.assertIn("Wall yield locus: " + text, found)

    @clod.quick_only
    def test_where_the_spread_comes_from(self):
        """The share of a measurement is the variance that is there with its errors alone, over that with all of
        them: other runs, other samples. 400 samples tell a variance to 7 % (sqrt(2/n)), so a share to 0.1.
        All f_c have the same error, so their line is the same where theirs is next to nothing."""
        head = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],phi_t [deg],rho_b [kg/m3],rho_b_error [kg/m3]\n"
        rows = [[2, 1.4, 0.05, 48, 40, 1250, 50], [4, 1.9, 0.05, 47, 40, 1300, 50], [8, 2.9, 0.05, 46, 39, 1350, 50]]
        samples = ("--set", "interval.samples=400")

        def outlets(strength, wall, density):
            self.write("case.yaml", CASE if wall else CASE.replace(", error: 1 deg", ""))
            self.write("flow.csv", head + "".join(
                ",".join(map(str, (a, b, c if strength else 1e-7, d, e, f, g if density else 0))) + "\n"
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
            self.assertEqual(sorted(shares), ["flow_function", "not_told", "phi_e", "rho_b", "wall"])
            self.assertIsNone(shares["phi_e"])  # it has no errors: nobody knows
            self.assertAlmostEqual(sum(share for share in shares.values() if share is not None), 1.0, delta=0.1)
            for name, found in alone.items():
                self.assertAlmostEqual(shares[name], variance(found, shape) / variance(every, shape), delta=0.1, msg=name)
                self.assertGreater(found[shape]["outlet_variance_shares"][name], 0.98)
            low, high = every[shape]["outlet_m"]["low"], every[shape]["outlet_m"]["high"]
            self.assertEqual((low, high), tuple(every[shape]["outlet_percentiles_m"][at] for at in (5, 95)))

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
        self.assertEqual(cone["phi_w_deg"], {"value": None, "low": None, "high": None, "low_error": None, "high_error": None})
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
                          "static angle of internal friction is 29.0 deg. G grows with it, so the diameter is at most that of 30 deg, ", words)
        bounds = [float(text) for text in re.findall(r"that of 30 deg, ([0-9.]+) mm", words)]
        self.write("case.yaml", more + "static_friction: {angle: 30 deg}\n")
        of_30 = self.found()["rathole"]
        self.assertEqual(bounds, [round(1e3 * of_30[key]["value"], 1) for key in ("emptying_m", "filling_m")])
        self.write("case.yaml", more + "static_friction: {angle: 72 deg}\n")
        self.write("flow.csv", head + "2,1.4,0.05,78,72,0,1250\n8,2.9,0.08,78,72,0,1350\n")
        told = self.hopper("case.yaml").stdout
        self.assertIn("No rathole diameter, emptying", told)
        self.assertNotIn("at most that of", told)  # beyond 70 deg nothing bounds it
        self.write("flow.csv", head + "2,1.4,0.05,48,29,4,1250\n8,2.9,0.08,46,29,4,1350\n")
        self.write("case.yaml", more + "static_friction: {angle: 31 deg, error: 4 deg}\n")
        told = " ".join(self.hopper("case.yaml").stdout.split())
        shares = self.found()["rathole"]["known_shares"]
        for when, key in (("emptying", "emptying"), ("after filling", "filling")):
            self.assertAlmostEqual(shares[key], 0.6, delta=0.15)  # of 100 samples: 3 x 0.049
            self.assertIn(f"Rathole, {when}: in {100 * (1 - shares[key]):.1f} % of the samples the static angle of "
                          "internal friction is outside 30 to 70 deg", told)

    def test_intervals_without_errors_are_the_value(self):
        """To the last printed digit, at an outlet that is nearly infinite; f_c has errors far below that. Those of the wall's are not known."""
        self.start(CASE.replace(", error: 1 deg", ""), "2,2.5,1e-8,48,40,1250\n8,6.85,1e-8,46,40,1350\n")
        told = self.hopper("case.yaml").stdout
        rows = re.findall(r"^  [a-z].*?  +([0-9.]+) +([0-9.]+) +([0-9.]+)(?:  \S+)?$", told, re.MULTILINE)
        self.assertGreater(len(rows), 10)
        self.assertEqual(len(re.findall(r"half angle +[0-9.]+ +- +-  deg", told)), 2, told)
        for value, low, high in rows:
            self.assertEqual((low, high), (value, value), told)


if __name__ == "__main__":
    clod.unittest.main()
