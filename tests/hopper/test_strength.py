"""Strengths without errors: their scatter about a line is the error, or nothing tells it. Repeats, and tables of uniaxial tests."""

import json
import math
import os
import random
import statistics
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import clod

HEAD = "sigma_1 [kPa],f_c [kPa]\n"
NINE = [(2, 0.8), (2, 1.0), (2, 1.2), (4, 1.3), (4, 1.6), (4, 1.9), (8, 2.0), (8, 2.5), (8, 3.0)]
FOUR = [(2, 1.0), (4, 1.7), (8, 2.3), (16, 4.2)]
TWO = [(2, 1.0), (8, 2.5)]
REST = """wall_friction: {angle: 20 deg}
effective_friction: {angle: 45 deg}
static_friction: {angle: 40 deg}
bulk_density: {value: 800 kg/m3}
silo: {diameter: 3 m, height: 8 m}
"""
CASE = "flow_function: {file: flow.csv}\n" + REST
MANY = ("--set", "interval.samples=4000")
UNKNOWN = "How much wider than the critical outlet, or the rathole, to build is not known"


def line_of(points):
    slope, start = statistics.linear_regression(*zip(*points))
    return start, slope


def scatter_of(points):
    """Standard deviation about the line of least squares."""
    start, slope = line_of(points)
    return math.sqrt(sum((y - start - slope * x) ** 2 for x, y in points) / (len(points) - 2))


def drawn(points, critical, seed=1, samples=20000):
    """5 and 95 % of the critical strength over its value, by Student's t; at it sigma_1 = ff f_c, so f_c = a/(1 - b ff) of the line."""
    source = random.Random(seed)
    s, m = scatter_of(points), len(points) - 2
    ff = critical["flow_factor"]["value"]
    start, slope = line_of(points)
    ratios = []
    for _ in range(samples):
        k = math.sqrt(m / sum(source.gauss(0, 1) ** 2 for _ in range(m)))
        a, b = line_of([(x, max(0, y + s * k * source.gauss(0, 1))) for x, y in points])
        strength = a / (1 - b * ff) if b * ff < 1 else math.inf
        ratios.append(strength / (start / (1 - slope * ff)))
    ratios.sort()
    return ratios[samples // 20], ratios[-samples // 20]


class Strength(hopper_case.Case):

    def design(self, points, *arguments, head=HEAD, case=CASE):
        self.write("case.yaml", case)
        self.write("flow.csv", head + "".join(",".join(map(str, point)) + "\n" for point in points))
        return self.found(*arguments)

    def said(self, found, *words):
        return [text for text in found["warnings"] if all(word in text for word in words)]

    def is_untold(self, found):
        """No interval of what hangs on the strength, no shares."""
        for shape in ("cone", "wedge"):
            for key in ("outlet_m", "flow_factor", "sigma_1_Pa", "strength_Pa"):
                self.assertGreater(found[shape][key]["value"], 0.0)
                self.assertEqual([found[shape][key][end] for end in ("low", "high", "low_error", "high_error")], 4 * [None], key)
            shares = found[shape]["sample_shares"]
            self.assertEqual({shares[key] for key in ("flows", "no_arch", "arches")}, {None})
            self.assertEqual(set(found[shape]["outlet_percentiles_m"]), {None})
            self.assertEqual(set(found[shape]["outlet_variance_shares"].values()), {None})
        for key in ("emptying_m", "filling_m"):
            self.assertGreater(found["rathole"][key]["value"], 0.0)
            self.assertEqual([found["rathole"][key][end] for end in ("low", "high")], 2 * [None], key)
        self.assertEqual(len(self.said(found, UNKNOWN)), 1)
        self.assertEqual(len(self.said(found, "Without errors, and so not part of the intervals: flow function")), 1)

    def test_the_scatter_is_the_error(self):
        found = self.design(NINE)
        s = scatter_of(NINE)
        said, = self.said(found, "points without an error, or with a smaller one, get")
        self.assertIn(f"what the 9 points scatter by about their line, {s:.3g} kPa, drawn from Student's t of 7 degrees of freedom", said)
        self.assertEqual(self.said(found, UNKNOWN), [])
        self.assertEqual(len(self.said(found, "Without errors", "flow function")), 0)
        start, slope = line_of(NINE)
        line = found["flow_function_line"]
        self.assertAlmostEqual(line["f_c_at_0_Pa"] / 1e3, start, 6)
        self.assertAlmostEqual(line["slope"], slope, 6)
        self.assertFalse(line["weighted"])
        self.assertIsNone(line["chi_square"])  # it would be 7 of 7
        self.assertEqual(line["errors_times"], 1)

    def test_intervals_are_those_of_a_line_by_students_t(self):
        """All things but f_c are exact and constant, so the outlet is in proportion to the critical strength."""
        for points in (NINE, FOUR):
            self.design(points)
            done = clod.run("hopper", "case.yaml", "--json", *MANY, cwd=self.folder)
            for shape in ("cone", "wedge"):
                found = json.loads(done.stdout)[shape]
                outlet = found["outlet_m"]
                for end, ratio in zip(("low", "high"), drawn(points, found)):
                    self.assertAlmostEqual(outlet[end] / outlet["value"], ratio, delta=3.5 * outlet[end + "_error"] / outlet["value"], msg=end)
                self.assertAlmostEqual(found["outlet_variance_shares"]["flow_function"], 1, delta=0.02)

    def test_an_error_of_sigma_1_tells_none_of_f_c(self):
        whole = self.design(NINE)["cone"]["outlet_m"]
        also = self.design([(*point, 0.001) for point in NINE], head=HEAD.strip() + ",sigma_1_error [kPa]\n")["cone"]["outlet_m"]
        for end in ("low", "high"):
            self.assertAlmostEqual(also[end] / whole[end], 1, delta=0.02)
        self.is_untold(self.design([(*point, 0.1) for point in TWO], head=HEAD.strip() + ",sigma_1_error [kPa]\n"))

    def test_some_errors_alone(self):
        """Points that state more than the scatter of all keep it; the others have that: one empty cell makes no interval narrower."""
        for stated in (0.05, 0.5):
            points = [(x, y, stated if x == 2 else 0) for x, y in NINE]
            found = self.design(points, head=HEAD.strip() + ",f_c_error [kPa]\n")
            errors = [point["y_error"] for point in found["measured"]["flow_function"]]
            self.assertGreater(scatter_of(NINE), 0.05)
            self.assertLess(scatter_of(NINE), 0.5)
            for (x, _), error in zip(NINE, errors):
                self.assertAlmostEqual(error, 500 if x == 2 and stated == 0.5 else 1e3 * scatter_of(NINE), 3)
            self.assertEqual(len(self.said(found, "f_c at sigma_1 4 kPa has no error, others have one")), int(stated == 0.5))

    def test_repeats_of_a_curve_of_points(self):
        found = self.design(NINE, "--set", "flow_function.curve=points")
        points = found["measured"]["flow_function"]
        self.assertEqual([point["sigma_1_Pa"] for point in points], [2000, 4000, 8000])
        for point, strength in zip(points, (1000, 1600, 2500)):
            self.assertAlmostEqual(point["f_c_Pa"], strength, 6)
            self.assertAlmostEqual(point["y_error"], 1e3 * scatter_of(NINE) / math.sqrt(3), 3)
        self.assertIn(f"what the 9 points scatter by about their line, {scatter_of(NINE):.3g} kPa", " ".join(found["warnings"]))
        self.assertLess(found["cone"]["outlet_m"]["low"], 0.9 * found["cone"]["outlet_m"]["value"])

    def test_repeats_of_which_some_state_an_error(self):
        """The mean of one known to 0.2 and one off the line by s: by Student's t of 2 degrees, and nothing of the 0.15 they happen to scatter by."""
        rows = [(2, 1.0), (2, 1.1), (8, 2.3), (8, 2.6)]
        points = ("--set", "flow_function.curve=points")
        s = scatter_of(rows)
        mixed = [(*row, 0.2 * (k % 2 == 0)) for k, row in enumerate(rows)]
        mean_error = math.hypot(s, 0.2) / 2
        found = self.design(mixed, *points, head=HEAD.strip() + ",f_c_error [kPa]\n")
        for point in found["measured"]["flow_function"]:
            self.assertAlmostEqual(point["y_error"], 1e3 * mean_error, 3)
        self.assertEqual(len(self.said(found, f"about their line, {s:.3g} kPa, drawn from Student's t of 2 degrees of freedom")), 1)
        outlet = json.loads(clod.run("hopper", "case.yaml", "--json", *points, *MANY, cwd=self.folder).stdout)["cone"]["outlet_m"]
        both = [(2, 1.05), (8, 2.45)]
        source = random.Random(1)
        ff = found["cone"]["flow_factor"]["value"]
        start, slope = line_of(both)
        ratios = []
        for _ in range(20000):
            k = mean_error * math.sqrt(2 / sum(source.gauss(0, 1) ** 2 for _ in range(2)))
            a, b = line_of([(x, max(0, y + k * source.gauss(0, 1))) for x, y in both])
            ratios.append((max(0, a) / (1 - b * ff) if b * ff < 1 else math.inf) / (start / (1 - slope * ff)))
        ratios.sort()
        for end, ratio in zip(("low", "high"), (ratios[1000], ratios[-1000])):
            self.assertAlmostEqual(outlet[end] / outlet["value"], ratio, delta=4 * outlet[end + "_error"] / outlet["value"], msg=end)

    def test_stated_errors_of_repeats(self):
        """Of three at 4 kPa: their own, 0.1/sqrt(3), or where their scatter is larger that, 0.3/sqrt(3)."""
        head = HEAD.strip() + ",f_c_error [kPa]\n"
        for low, high, error in ((1.55, 1.65, 100 / math.sqrt(3)), (1.3, 1.9, 300 / math.sqrt(3))):
            rows = [(2, 1, 0.1), (4, low, 0.1), (4, 1.6, 0.1), (4.05, high, 0.1), (8, 2.5, 0.1)]
            found = self.design(rows, "--set", "flow_function.curve=points", head=head)
            point = found["measured"]["flow_function"][1]
            self.assertAlmostEqual(point["sigma_1_Pa"], 1e3 * 12.05 / 3, 3)
            self.assertAlmostEqual(point["f_c_Pa"], 1600, 3)
            self.assertAlmostEqual(point["y_error"], error, 3)

    def test_nothing_tells_an_error(self):
        for points, advice in ((TWO, "Give f_c_error, or strengths at three consolidation stresses or more"),
                               ([(2, 1.0), (4, 1.5), (8, 2.5)], "lie on a line to the last digit, as fitted, not as measured")):
            found = self.design(points)
            self.is_untold(found)
            self.assertEqual(len(self.said(found, UNKNOWN, advice)), 1)
            self.assertIsNone(found["cone"]["sample_shares"]["funnel_flow"])  # which the wall decides, whose error is not told either

    def test_a_wall_on_a_line_to_the_last_digit(self):
        for rows, advice in (("2,0.8\n8,2.5\n", "Give tau_w_error, or points at three normal stresses or more"),
                             ("2,1\n4,1.5\n8,2.5\n", "lie on a line to the last digit, as fitted, not as measured: give what was measured, or tau_w_error.")):
            self.write("wall.csv", "sigma_w [kPa],tau_w [kPa]\n" + rows)
            found = self.design(NINE, case=CASE.replace("{angle: 20 deg}", "{file: wall.csv}"))
            self.assertEqual(len(self.said(found, "How far the limit of mass flow may be off is not known", advice)), 1, rows)

    def test_a_rough_wall_is_told_all_the_same(self):
        """Of 100 samples with a wall of 32 +- 4 deg some have no mass flow."""
        found = self.design(TWO, case=CASE.replace("{angle: 20 deg}", "{angle: 32 deg, error: 4 deg}"))
        share = found["cone"]["sample_shares"]["funnel_flow"]
        self.assertGreater(share, 0.05)
        self.assertLess(share, 0.95)
        self.assertEqual(len(self.said(found, "Cone: mass flow is what the means", f"Samples: {100 * share:.1f} % in funnel flow; of the others it "
                                              "is not known whether they flow: nothing tells the errors of the flow function.")), 1)

    def test_tables_and_pages_print_a_dash(self):
        self.design(TWO)
        told = self.hopper("case.yaml", "-o", "design", "--set", "cone.outlet=500 mm").stdout
        self.assertRegex(told, r"critical outlet +[0-9.]+ +- +-  mm\n")
        self.assertRegex(told, r"diameter, emptying \(least\) +[0-9.]+ +- +-  mm\n")
        self.assertRegex(told, r"stress over strength +[0-9.]+ +- +-\n")
        self.assertRegex(told, r"samples that do not flow +- %\n")
        self.assertIn("samples -: nothing tells the errors of wall friction, of the limit that is given, or of the flow function", " ".join(told.split()))
        with open(self.path("design.html")) as file:
            page = file.read()
        self.assertIn("diameter of the outlet as measured: how much wider to build is not known", page)
        self.assertNotIn("to build, at least", page)
        for text in (told, page):
            self.assertNotIn("nan ", text)

    def test_after_storage(self):
        """The strength after storage decides, and its own points tell its error."""
        case = CASE.replace("flow.csv", "flow.csv, after_storage: stored.csv")
        self.write("stored.csv", HEAD + "2,1.6\n8,4.0\n")
        self.is_untold(self.design(NINE, case=case))
        stored = [(2, 1.6), (4, 2.6), (8, 4.0), (12, 5.9)]
        self.write("stored.csv", HEAD + "".join(f"{x},{y}\n" for x, y in stored))
        said, = self.said(self.design(TWO, case=case), "points without an error, or with a smaller one, get")
        self.assertIn(f"what the 4 points scatter by about their line, {scatter_of(stored):.3g} kPa", said)
        self.write("stored.csv", HEAD + "2,1.6\n8,4.0\n8,6.0\n")
        found = self.design(NINE, case=case)
        self.assertEqual(len(self.said(found, "Flow function after storage: 2 repeats at a sigma_1 of 8 kPa have f_c from 4 to 6 kPa")), 1)
        self.assertEqual(len(self.said(found, "Flow function: 3 repeats at a sigma_1 of 8 kPa")), 1)
        self.write("stored.csv", HEAD.strip() + ",strain_at_peak [1]\n2,1.6,0.1\n8,4.0,0.1\n")
        self.assertEqual(len(self.said(self.design(NINE, case=case), "Flow function after storage: ", "stored.csv has columns of a uniaxial test")), 1)

    def test_repeats_after_storage_are_not_weaker(self):
        """Their mean is that without storage, or lies further below than twice all errors."""
        case = CASE.replace("flow.csv", "flow.csv, after_storage: stored.csv")
        words = "No solid gets weaker by storage"
        for way in ("line", "points"):
            for low, high, told in ((0.9, 1.1, 0), (0.7, 0.72, 1)):
                self.write("stored.csv", HEAD.strip() + f",f_c_error [kPa]\n2,{low},0.01\n2,{high},0.01\n8,2.6,0.01\n")
                found = self.design([(2, 1.0, 0.01), (8, 2.5, 0.01)], "--set", f"flow_function.curve={way}", head=HEAD.strip() + ",f_c_error [kPa]\n", case=case)
                self.assertEqual(len(self.said(found, words)), told, (way, low))
        self.write("stored.csv", HEAD + "2,0.9\n4,1.4\n8,2.6\n")  # by 0.1 and 0.2, of a scatter of 0.3
        self.assertEqual(self.said(self.design(NINE, case=case), words), [])

    def test_yield_loci_of_two_points(self):
        """Two of them tell nothing; three scatter about a line of strengths."""
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
        case = CASE.replace("{file: flow.csv}", "{shear_tests: [{points: flow.csv}]}")
        two = [(3, 2.0, 1, 1.15), (3, 2.0, 2, 1.62), (6, 3.9, 2, 2.1), (6, 3.9, 4, 3.02)]
        found = self.design(two, head=head, case=case)
        self.is_untold(found)
        self.assertEqual(len(self.said(found, UNKNOWN, "three shear points or more to each yield locus")), 1)
        found = self.design(two + [(12, 7.6, 4, 3.7), (12, 7.6, 8, 5.6)], head=head, case=case)
        self.assertEqual(self.said(found, UNKNOWN), [])
        strengths = [(point["sigma_1_Pa"] / 1e3, point["f_c_Pa"] / 1e3) for point in found["measured"]["flow_function"]]
        self.assertEqual(len(self.said(found, f"what the 3 points scatter by about their line, {scatter_of(strengths):.3g} kPa")), 1)

    def test_repeats_that_differ(self):
        head = HEAD.strip() + ",f_c_error [kPa]\n"
        for points, told in (([(2, 1.0, 0), (4, 1.7, 0), (4.05, 2.9, 0)], "have f_c from 1.7 to 2.9 kPa, which is more than testers scatter by"),
                             ([(2, 1.0, 0), (4, 1.7, 0), (4.05, 1.9, 0)], ""),
                             ([(2, 1.0, 0), (4, 1.7, 0), (4.2, 2.9, 0)], ""),  # 5 % apart
                             ([(2, 1.0, 0.1), (4, 1.7, 0.05), (4.05, 1.9, 0.05)], "from 1.7 to 1.9 kPa, which is more than their errors tell"),
                             ([(2, 1.0, 0.1), (4, 1.7, 0.1), (4.05, 1.9, 0.1)], "")):  # chi-square 2 of 1, p 0.16
            found = self.design(points, head=head)
            self.assertEqual(len(self.said(found, "2 repeats at a sigma_1 of 4 kPa", told)), 1 if told else 0, points)
        head = head.strip() + ",seeds\n"  # of three specimens each: t = 0.3/(0.08 sqrt(2)) of 2 degrees, chance 0.12; of 1000 known
        for seeds in (3, 1000):
            found = self.design([(2, 1.0, 0.08, seeds), (2, 1.3, 0.08, seeds), (8, 2.5, 0.2, seeds)], head=head)
            self.assertEqual(len(self.said(found, "2 repeats at a sigma_1 of 2 kPa")), seeds // 1000)
        found = self.design(NINE)
        self.assertEqual(len(self.said(found, "3 repeats at a sigma_1 of 8 kPa have f_c from 2 to 3 kPa", "and so it is at 2 others")), 1)
        self.assertEqual(self.said(found, "falls from"), [])

    def test_few_repeats_are_no_specimens(self):
        words = "the intervals rest on the scatter of 2"
        points = ("--set", "flow_function.curve=points")
        head = HEAD.strip() + ",f_c_error [kPa]\n"
        rows = [(2, 1.0, 0.01), (2, 1.1, 0.01), (8, 2.3, 0.01), (8, 2.5, 0.01)]
        said, = self.said(self.design(rows, *points, head=head), words)
        self.assertTrue(said.startswith(f"Flow function: {words} repeats, "), said)
        head = head.strip() + ",seeds\n"
        said, = self.said(self.design([(2, 1.0, 0.1, 2), (8, 2.4, 0.1, 2)], head=head), words)
        self.assertTrue(said.startswith(f"Yield loci: {words} specimens, "), said)
        self.assertEqual(self.said(self.design([(2, 1.0, 0.1, 2), (8, 2.4, 0, 2)], head=head), words), [])  # without intervals

    def test_a_scatter_of_testers(self):
        """Three of 1 -+ d have a chi-square of 2 (d/0.1)^2, which is 5.99 of 2 degrees at 0.173; two 5 % below 0.277 apart."""
        for row, told in (([1, 0.84, 1.16], 0), ([1, 0.82, 1.18], 1), ([0.865, 1.135], 0), ([0.855, 1.145], 1),
                          ([0.87, 1, 1.01, 1.05, 1.07, 1.15, 0.85, 1], 0)):
            found = self.design([*((2, y) for y in row), (8, 2.5)])
            self.assertEqual(len(self.said(found, f"{len(row)} repeats at a sigma_1 of 2 kPa")), told, row)

    def test_repeats_do_not_fall(self):
        """The largest at one stress is above the smallest at the next; their means rise, or fall within their errors."""
        for rows in ([(2, 1.2), (2, 0.8), (4, 1.1), (4, 1.3)], [(2, 1.2), (2, 1.0), (4, 0.98), (4, 1.18)]):
            self.assertEqual(self.said(self.design(rows), "falls from"), [])
        for mode in ("line", "points"):
            way = ("--set", f"flow_function.curve={mode}")
            self.assertEqual(len(self.said(self.design([(2, 1.2), (2, 1.22), (4, 0.8), (4, 0.82)], *way), "f_c falls from 1.21 kPa")), 1, mode)
            rows = [(2, 1.0), (2, 1.02), (4, 1.6), (4, 1.62), (6, 1.3), (6, 1.32), (8, 2.6), (8, 2.62)]  # 0.3, of errors of 0.32/sqrt(2)
            self.assertGreater(2 * scatter_of(rows), 0.3)
            self.assertEqual(self.said(self.design(rows, *way), "falls from"), [], mode)

    def test_the_number_of_a_specimen(self):
        self.design([(*point, 101) for point in NINE], head=HEAD.strip() + ",seed\n")

    def test_a_uniaxial_test_is_told(self):
        for column in ("strain_at_peak [1]", "sigma_c_base [kPa]", "consolidation_stress [kPa]"):
            found = self.design([(*point, 0.05) for point in NINE], head=HEAD.strip() + f",{column}\n")
            self.assertEqual(len(self.said(found, "flow.csv has columns of a uniaxial test", "usually below")), 1)
        self.assertEqual(self.said(self.design(NINE), "uniaxial"), [])

    def test_points_have_no_unit_of_a_table(self):
        """Sand that has next to no strength, f_c of 0.16 kPa at 21 kPa."""
        rows = [(5, 3.15, 1, 0.66), (5, 3.15, 2, 1.29), (5, 3.15, 4, 2.53), (10, 6.28, 2, 1.29), (10, 6.28, 4, 2.54), (10, 6.28, 8, 5.03)]
        found = self.design(rows, head="sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n",
                            case=CASE.replace("{file: flow.csv}", "{shear_tests: [{points: flow.csv}]}"))
        said = self.said(found, "No tester tells so little strength.")
        self.assertTrue(said)
        self.assertNotIn("unit", "".join(said))
        found = self.design([(20, 0.15), (40, 0.2), (60, 0.3)])
        self.assertTrue(self.said(found, "No tester tells so little strength. Is its unit another one"))


if __name__ == "__main__":
    clod.unittest.main()
