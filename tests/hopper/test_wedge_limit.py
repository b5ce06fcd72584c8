"""A limit of mass flow of a wedge that is given, from a chart: half angle, verdict, margin, samples, refusals."""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import CASE, clod


def wedge(text):
    return CASE + f"wedge: {{{text}}}\n"


class WedgeLimit(hopper_case.Case):

    def warnings(self, *arguments):
        return [text for text in self.found(*arguments)["warnings"] if text.startswith(("Wedge", "Without"))]

    def test_the_half_angle_is_the_limit_less_the_margin(self):
        """35 deg, some 10 deg beyond the limit of a cone; H = (200 + theta)/200."""
        self.start(wedge("limit: 35 deg, outlet: 1 m"))
        design = self.found()
        found, cone = design["wedge"], design["cone"]
        self.assertLess(cone["limit_deg"]["value"], 30.0)
        self.assertEqual((found["limit_given"], cone["limit_given"]), (True, False))
        self.assertAlmostEqual(found["limit_deg"]["value"], 35.0, places=12)
        self.assertAlmostEqual(found["half_angle_deg"]["value"], 32.0, places=12)
        self.assertEqual([found[key]["low"] for key in ("limit_deg", "half_angle_deg", "arch_thickness")], 3 * [None])  # no limit_error
        self.assertAlmostEqual(found["arch_thickness"]["value"], 232.0 / 200.0, places=12)
        self.assertEqual(found["outcome"], "flows")
        self.assertEqual(found["sample_shares"]["flows"], 1.0)
        self.assertGreater(found["arching_margin"]["value"], 1.0)
        told = self.hopper("case.yaml").stdout.split("\nWedge, slot")[1]
        self.assertIn("  Mass flow, and no cohesive arch above the critical outlet.", told)
        self.assertRegex(told, r"limit of mass flow, given +35\.0 +- +-  deg\n  half angle +32\.0 +- +-  deg")
        self.assertNotIn("ot known to be mass flow", told)
        self.assertIn("Without errors, and so not part of the intervals:", " ".join(self.warnings()))
        self.assertIn("limit of the wedge.", " ".join(self.warnings()))
        same = self.found("--set", "wedge={half_angle: 32 deg, outlet: 1 m}")["wedge"]  # the same field, not known to flow
        self.assertEqual(same["outcome"], "mass_flow_unknown")
        self.assertAlmostEqual(same["outlet_m"]["value"], found["outlet_m"]["value"], delta=1e-7)
        self.assertAlmostEqual(self.found("--set", "margin=5 deg")["wedge"]["half_angle_deg"]["value"], 30.0, places=12)

    def test_a_half_angle_beside_the_limit(self):
        """Steeper by the margin: nothing to say; within it: a warning; flatter: funnel flow. The limit is all but exact."""
        for angle, outcome in ((31.9, "flows"), (33.0, "flows"), (35.5, "funnel_flow")):
            self.start(wedge(f"limit: 35 deg, limit_error: 0.01 deg, half_angle: {angle} deg, outlet: 1 m"))
            found = self.found()["wedge"]
            self.assertEqual(found["outcome"], outcome)
            self.assertEqual(found["sample_shares"][outcome], 1.0)
            self.assertEqual(found["planned_outlet_arching_share"], 0.0 if outcome == "flows" else 1.0)
            near = [text for text in self.warnings() if "by less than the margin" in text]
            self.assertEqual(near, [f"Wedge: the half angle of {angle} deg is steeper than the limit of mass flow that is "
                                    "given, 35.0 deg, by less than the margin of 3.0 deg."] if angle == 33.0 else [])
            told = " ".join(self.hopper("case.yaml").stdout.split("\nWedge, slot")[1].split())
            beyond = "Funnel flow: the half angle of 35.5 deg is flatter than the limit of mass flow that is given, 35.0 deg."
            self.assertEqual(beyond in told, outcome == "funnel_flow")

    def test_samples_draw_the_limit_from_its_error(self):
        """Normal, 35 +- 2 deg: 90 % within 1.645 errors; a given 33 deg is beyond it in 15.9 %. 2000 samples tell that
        share to 0.8 %, a quantile at 5 % to 0.047 errors (sqrt(0.05 x 0.95/n)/0.1031): three times these."""
        self.start(wedge("limit: 35 deg, limit_error: 2 deg, outlet: 1 m"))
        more = ("--set", f"interval.samples={100 if clod.SANITIZED else 2000}")
        text = clod.run("hopper", "case.yaml", "--json", *more, cwd=self.folder).stdout
        found = hopper_case.json.loads(text)["wedge"]
        for key, middle in (("limit_deg", 35.0), ("half_angle_deg", 32.0)):
            self.assertAlmostEqual(found[key]["value"], middle, places=12)
            if clod.SANITIZED:
                return
            self.assertAlmostEqual(found[key]["low"], middle - 1.645 * 2.0, delta=0.29)
            self.assertAlmostEqual(found[key]["high"], middle + 1.645 * 2.0, delta=0.29)
        self.assertNotIn("limit of the wedge", " ".join(self.warnings()))
        self.start(wedge("limit: 35 deg, limit_error: 2 deg, half_angle: 33 deg, outlet: 1 m"))
        found = hopper_case.json.loads(clod.run("hopper", "case.yaml", "--json", *more, cwd=self.folder).stdout)["wedge"]
        share = 0.5 * math.erfc(1.0 / math.sqrt(2.0))
        self.assertAlmostEqual(found["sample_shares"]["funnel_flow"], share, delta=0.025)
        self.assertEqual(found["planned_outlet_arching_share"], found["sample_shares"]["funnel_flow"])

    def test_a_limit_below_that_of_a_cone(self):
        """Charts for wedges allow more than for cones: 10 deg are doubtful where a cone has more than 20; not within two errors."""
        for text, doubtful in (("limit: 10 deg", True), ("limit: 35 deg", False), ("limit: 18 deg, limit_error: 6 deg", False)):
            self.start(wedge(text))
            design = self.found()
            self.assertGreater(design["cone"]["limit_deg"]["value"], 20.0)
            said = [one for one in self.warnings() if one.startswith("Wedge: the limit that is given, 10.0 deg, is below that of a cone")]
            self.assertEqual(len(said), 1 if doubtful else 0)

    def test_what_is_refused(self):
        self.refuse(wedge("limit: 35"), ["case.yaml:3:16: wedge.limit: 35 needs a unit of angle", "^"])
        self.refuse(wedge("limit: 61 deg"), ["wedge.limit", "is out of range", "at most 60 deg"])
        self.refuse(wedge("limit: 0 deg"), ["wedge.limit", "is out of range"])
        self.refuse(wedge("limit: 35 deg, limit_error: 31 deg"), ["wedge.limit_error", "is out of range"])
        self.refuse(wedge("limit_error: 1 deg"), ["case.yaml:3:9: wedge.limit_error: is the error of wedge.limit, which is not given"])
        self.refuse(wedge("limit: 3 deg"), ["case.yaml:3:9: wedge.limit: leaves no half angle below it: margin is 3 deg"])
        self.refuse(CASE + "cone: {limit: 20 deg}\n", ["cone.limit: this key is not known"])  # a cone's is solved


if __name__ == "__main__":
    clod.unittest.main()
