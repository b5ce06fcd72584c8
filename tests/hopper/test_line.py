"""The line of a flow function: how its points weigh, where it misses them, and what rests on it."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from hopper_case import Case, clod

HEAD = "sigma_1 [kPa],f_c [kPa],sigma_1_error [kPa],f_c_error [kPa],phi_e [deg],phi_t [deg],rho_b [kg/m3]\n"
TEMPLATE = [(3.1, 1.45, 0.06, 0.08), (6.2, 2.20, 0.12, 0.10), (12.3, 3.65, 0.20, 0.15), (24.5, 6.40, 0.40, 0.25)]
POOR = TEMPLATE[:3] + [(24.5, 9.40, 0.40, 3)]
CURVED = [(3.1, 1.0, 0.03, 0.03), (6.2, 2.2, 0.05, 0.05), (12.3, 3.6, 0.1, 0.05), (24.5, 4.6, 0.2, 0.05)]
CASE = "flow_function: {file: flow.csv}\nwall_friction: {angle: 20 deg, error: 1 deg}\n"
REST = ["50,38,1210", "48,38,1265", "47,38,1320", "45,38,1385"]


def weighted(points):
    """Line by effective variances, from the slope without weights on: intercept, slope, chi-square."""
    slope, line = None, None
    for _ in range(30):
        weights = [1 if slope is None else 1 / (ey ** 2 + (slope * ex) ** 2) for _, _, ex, ey in points]
        total = sum(weights)
        x = sum(w * p[0] for w, p in zip(weights, points)) / total
        y = sum(w * p[1] for w, p in zip(weights, points)) / total
        slope = (sum(w * (p[0] - x) * (p[1] - y) for w, p in zip(weights, points))
                 / sum(w * (p[0] - x) ** 2 for w, p in zip(weights, points)))
        line = (y - slope * x, slope)
    return *line, sum(w * (p[1] - line[0] - line[1] * p[0]) ** 2 for w, p in zip(weights, points))


class Line(Case):

    def design(self, points, *arguments, rest=REST, case=CASE):
        self.write("case.yaml", case)
        rows = [",".join(map(str, point)) + f",{more}\n" for point, more in zip(points, rest)]
        self.write("flow.csv", HEAD + "".join(rows))
        return self.found(*arguments)

    def sampled(self, samples, *arguments):
        """The design of the files that are there, by so many samples."""
        done = clod.run("hopper", "case.yaml", "--json", "--set", f"interval.samples={samples}", *arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def said(self, found, *words):
        return [text for text in found["warnings"] if all(word in text for word in words)]

    def test_points_weigh_by_their_errors(self):
        for points in (TEMPLATE, POOR, CURVED):
            line = self.design(points)["flow_function_line"]
            a, b, chi_square = weighted(points)
            self.assertTrue(line["weighted"])
            self.assertAlmostEqual(line["f_c_at_0_Pa"] / 1e3, a, 6)
            self.assertAlmostEqual(line["slope"], b, 6)
            self.assertAlmostEqual(line["chi_square"] / chi_square, 1, 5)
            self.assertEqual(line["degrees_of_freedom"], 2)
            self.assertAlmostEqual(line["p_value"], math.exp(-chi_square / 2), 6)  # of two degrees of freedom
            self.assertAlmostEqual(line["errors_times"], max(1, math.sqrt(chi_square / 2)), 4)

    def test_an_honestly_poor_point_hardly_counts(self):
        """The last f_c is 9.4 +- 3 kPa in place of 6.40 +- 0.25, the same within its error."""
        good, poor = (self.design(points)["cone"]["outlet_m"] for points in (TEMPLATE, POOR))
        self.assertAlmostEqual(poor["value"], good["value"], delta=0.5 * (good["high"] - good["low"]) / 1.645)
        self.assertLess(good["low"], poor["value"])
        self.assertGreater(poor["low"], 0.5 * good["low"])

    def test_without_all_errors_points_weigh_alike(self):
        for errors in ((0, 0, 0, 0), (0.08, 0, 0.15, 0.25)):
            points = [(*point[:3], error) for point, error in zip(TEMPLATE, errors)]
            found = self.design(points)
            line = found["flow_function_line"]
            a, b, _ = weighted([(*point[:2], 0, 1) for point in points])
            self.assertFalse(line["weighted"])
            self.assertAlmostEqual(line["f_c_at_0_Pa"] / 1e3, a, 6)
            self.assertAlmostEqual(line["slope"], b, 6)
            self.assertIsNone(line["chi_square"])
            self.assertEqual(len(self.said(found, "f_c at sigma_1 6.2 kPa has no error")), 1 if sum(errors) else 0)
        text = " ".join(self.hopper("case.yaml").stdout.split())
        self.assertIn("all points alike, since not all points have errors of f_c.", text)

    def test_a_line_that_misses_its_points(self):
        found = self.design(CURVED)
        said = self.said(found, "the line misses its points by more than their errors tell")
        self.assertEqual(len(said), 1)
        chi_square = weighted(CURVED)[2]
        self.assertIn(f"chi-square {chi_square:.1f}, degrees of freedom 2, p below 0.001", said[0])
        self.assertIn(f"are taken as {math.sqrt(chi_square / 2):.1f} times as large", said[0])
        text = " ".join(self.hopper("case.yaml").stdout.split())
        self.assertIn(f"degrees of freedom 2, p below 0.001, errors of the line times {math.sqrt(chi_square / 2):.3g}.", text)
        other = self.found("--set", "flow_function.curve=points")
        outlets = {shape: other[shape]["outlet_m"]["value"] for shape in ("cone", "wedge")}
        told = {shape: f"{1e3 * value:.1f} mm" if value else "0 (no arch)" for shape, value in outlets.items()}
        self.assertIn(f"critical outlet is {told['cone']} (cone) and {told['wedge']} (wedge)", said[0])
        self.assertIsNone(other["flow_function_line"])
        self.assertEqual(self.said(other, "misses its points"), [])
        line = found["cone"]["outlet_m"]
        self.assertLess(line["low"], 0.5 * line["value"])  # unscaled, within 6 %
        self.assertGreater(line["high"], 1.5 * line["value"])
        self.assertEqual(self.said(self.design(TEMPLATE), "misses its points"), [])

    def test_no_arch_that_is_not_certain(self):
        """f_c = 0.3 (sigma_1 - 3 kPa): -0.9 kPa at 0, but errors of 0.8 kPa at each of four points."""
        points = [(x, round(0.3 * (x - 3), 3), 0.05, 0.8) for x in (4, 8, 16, 24)]
        self.design(points)
        found = self.sampled(400)
        for shape in ("cone", "wedge"):
            share = found[shape]["sample_shares"]
            arched = share["flows"] + share["arches"]
            self.assertEqual(found[shape]["outcome"], "no_arch")
            self.assertGreater(arched, 0.05)
            name = shape.capitalize()
            said = self.said(found, f"{name}: no arch is what the means say, but {100 * arched:.1f} % of the samples",
                             "the critical outlet of those is")
            self.assertEqual(len(said), 1, found["warnings"])
            said = self.said(found, f"{name}: no arch rests on an extrapolation: f_c falls to 0 at sigma_1 3.0",
                             "below the smallest that was measured, 4.000 kPa, where f_c is 0.3")
            self.assertEqual(len(said), 1, found["warnings"])
        text = " ".join(self.hopper("case.yaml").stdout.split())
        self.assertIn("As measured no cohesive arch stands at any outlet, but one does in", text)

    def test_no_arch_that_is_certain(self):
        """Nothing measured has a strength: nothing is extrapolated."""
        found = self.design([(x, 0, 0, 0) for x in (4, 8, 16, 24)])
        self.assertEqual(found["cone"]["outcome"], "no_arch")
        self.assertEqual(self.said(found, "no arch"), [])
        self.assertIn("no cohesive arch at any outlet.", " ".join(self.hopper("case.yaml").stdout.split()))

    def test_gaps_at_the_smallest_stress(self):
        for gap, what, value in (("50,38,", "rho_b", "1265 kg/m3"), ("50,,1210", "phi_t", "38 deg"),
                                 (",38,1210", "phi_e", "48 deg")):
            found = self.design(TEMPLATE, rest=[gap, *REST[1:]])
            said = self.said(found, f"{what} is missing at the smallest sigma_1, 3.1 kPa; at it, and below, that at the "
                             f"next, 6.2 kPa, is used: {value}.")
            self.assertEqual(len(said), 1, found["warnings"])
        for rest in (REST, ["50,38,1210", "48,38,", "47,,", "45,38,1385"]):
            self.assertEqual(self.said(self.design(TEMPLATE, rest=rest), "is missing at"), [])
        found = self.design(TEMPLATE, rest=["50,38,", *REST[1:]], case=CASE + "bulk_density: {value: 1250 kg/m3}\n")
        self.assertEqual(self.said(found, "is missing at"), [])

    @clod.quick_only
    def test_ends_and_what_their_number_leaves_open(self):
        """Four times the samples: half the errors. f_c alone is drawn, normal, whose 5 % quantile of n is known to
        sqrt(0.05 x 0.95/n)/0.1031 deviations; an estimate of that scatters by some tenths."""
        self.design(TEMPLATE)
        errors = []
        for samples in (1000, 4000):
            outlet = self.sampled(samples, "--set", "wall_friction.error=0 deg")["cone"]["outlet_m"]
            deviation = (outlet["high"] - outlet["low"]) / 2 / 1.645
            errors.append(0.5 * (outlet["low_error"] + outlet["high_error"]) / deviation)
            self.assertAlmostEqual(errors[-1] / (math.sqrt(0.0475 / samples) / 0.1031), 1, delta=0.4)
        self.assertLess(errors[1], 0.75 * errors[0])
        self.assertIn("ends, ± by number of samples", self.hopper("case.yaml").stdout)


if __name__ == "__main__":
    clod.unittest.main()
