"""A half angle that is given, beside a wall or a limit whose error nothing tells: samples do not make it sure. Errors of a wall that tell less than its points."""

import os
import statistics
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import CASE, clod

HEAD = "sigma_w [kPa],tau_w [kPa]\n"
FIVE = HEAD + "0.5,0.27\n1,0.44\n2,0.80\n4,1.51\n8,2.86\n"  # scatter about their line by 16 Pa
TWO = HEAD + "0.5,0.27\n4,1.51\n"  # two of them
GIVEN = ("--set", "cone={half_angle: 21.5 deg, outlet: 600 mm}")


class Untold(hopper_case.Case):

    def ends(self, found, key):
        return [found[key][end] for end in ("low", "high", "low_error", "high_error")]

    def wall(self, table):
        self.start(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: wall.csv}"))
        self.write("wall.csv", table)

    def test_two_points_are_not_surer_than_five(self):
        """Five points tell an error, and with it the outlet's; of two the half angle alone has an interval, as given."""
        self.wall(FIVE)
        five = self.found(*GIVEN)["cone"]
        self.assertLess(five["outlet_m"]["low"], five["outlet_m"]["value"])
        self.assertAlmostEqual(sum(five["sample_shares"].values()), 1.0)
        self.write("wall.csv", TWO)
        found = self.found(*GIVEN)
        cone = found["cone"]
        for key in ("limit_deg", "outlet_m", "flow_factor", "sigma_1_Pa", "f_c_Pa", "phi_w_deg", "arching_margin"):
            if key in cone:
                self.assertGreater(cone[key]["value"], 0.0, key)
                self.assertEqual(self.ends(cone, key), 4 * [None], key)
        self.assertEqual(self.ends(cone, "half_angle_deg"), [21.5, 21.5, 0.0, 0.0])
        self.assertIsNone(cone["planned_outlet_arching_share"])
        self.assertEqual(set(cone["sample_shares"].values()), {None})
        self.assertEqual(set(cone["outlet_percentiles_m"]), {None})
        self.assertEqual(set(cone["outlet_variance_shares"].values()), {None})
        self.assertGreater(found["wedge"]["outlet_m"]["high"], found["wedge"]["outlet_m"]["value"])
        said, = [text for text in found["warnings"] if text.startswith("How far the limit of mass flow may be off")]
        self.assertIn("it and the half angle that is not given have no interval", said)
        self.assertIn("The half angle of the cone is given, and is mass flow only below that limit: its outlet has no interval, and shares of "
                      "its samples are not known.", said)

    def test_tables_and_pages_print_a_dash(self):
        self.wall(TWO)
        told = self.hopper("case.yaml", "-o", "design", *GIVEN).stdout
        cone = told.split("\nWedge, slot")[0]
        self.assertRegex(cone, r"critical outlet +[0-9.]+ +- +-  mm\n")
        self.assertRegex(cone, r"stress over strength +[0-9.]+ +- +-\n")
        self.assertRegex(cone, r"samples that do not flow +- %\n")
        self.assertIn("  samples -: nothing tells the errors", cone)
        with open(self.path("design.html")) as file:
            page = file.read()
        self.assertIn("how far errors may move it is not known</span>", page)
        for text in (told, page):
            self.assertNotIn("nan ", text)
            self.assertNotIn("nan%", text)
        below = self.found("--set", "cone={half_angle: 21.5 deg, outlet: 20 mm}")
        said, = [text for text in below["warnings"] if text.startswith("Cone: the outlet of 20 mm is below")]
        self.assertRegex(said, r"^Cone: the outlet of 20 mm is below the critical one, [0-9.]+ mm: as measured [a-z ]+\.$")

    def test_an_error_of_the_normal_stress_tells_none_of_the_shear_stress(self):
        """Intervals as without it, but for what it adds, 0.36 of 1 Pa beside 16."""
        self.wall(FIVE)
        whole = self.found()["cone"]["limit_deg"]
        rows = FIVE.replace(HEAD, "").split()
        self.write("wall.csv", HEAD.strip() + ",sigma_w_error [kPa]\n" + "".join(f"{row},0.001\n" for row in rows))
        found = self.found()
        for end in ("value", "low", "high"):
            self.assertAlmostEqual(found["cone"]["limit_deg"][end], whole[end], delta=0.1)
        self.assertTrue([text for text in found["warnings"] if "points without an error, or with a smaller one, get" in text])

    def test_errors_of_a_reading_are_told(self):
        """The five points are off their line by -7, -10, 4, 23 and -11 Pa, s = 16: 1 Pa does not explain that, 20 Pa do."""
        rows = FIVE.replace(HEAD, "").split()
        for error, told in ((0.001, 1), (0.02, 0)):
            self.wall(HEAD.strip() + ",tau_w_error [kPa]\n" + "".join(f"{row},{error}\n" for row in rows))
            said = [text for text in self.found()["warnings"] if "lie further off a line than their errors tell" in text]
            self.assertEqual(len(said), told)
            for text in said:
                sigma = [float(row.split(",")[0]) for row in rows]
                tau = [float(row.split(",")[1]) for row in rows]
                slope, start = statistics.linear_regression(sigma, tau)
                off = [(y - start - slope * x) / error for x, y in zip(sigma, tau)]
                worst = max(range(5), key=lambda i: abs(off[i]))
                self.assertIn(f"most at sigma_w {sigma[worst]:g} kPa, by {abs(off[worst]):.1f} of them: "
                              f"chi-square {sum(x * x for x in off):.1f}, degrees of freedom 3, p below 0.001.", text)

    def test_a_limit_without_its_error(self):
        """A half angle just below a limit of a chart, which may be read wrongly; with its error samples tell how often."""
        self.start(CASE)
        wedge = "wedge={{limit: 35 deg{}, half_angle: 34 deg, outlet: 1 m}}"
        found = self.found("--set", wedge.format(""))
        self.assertIsNone(found["wedge"]["planned_outlet_arching_share"])
        self.assertEqual(self.ends(found["wedge"], "outlet_m"), 4 * [None])
        self.assertIn("The limit that is given has no limit_error. The half angle of the wedge is given", " ".join(found["warnings"]))
        found = self.found("--set", wedge.format(", limit_error: 1 deg"))
        self.assertGreater(found["wedge"]["planned_outlet_arching_share"], 0.0)
        self.assertNotIn("has no limit_error", " ".join(found["warnings"]))


if __name__ == "__main__":
    clod.unittest.main()
