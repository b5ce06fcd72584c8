"""The page of a calibration: cards, the posterior beside its prior, what it predicts, where it comes from."""

import json
import math
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from browser import BrowserCase
from pages import clod


class Calibration(BrowserCase):

    def setUp(self):
        super().setUp()
        pages.calibration(self.path("fit"))
        self.done = clod.run("report", "fit", cwd=self.folder)
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.page = pages.load(self.path("fit/report.html"))
        with open(self.path("fit/calibration.json")) as file:
            self.found = json.load(file)

    def curve(self, figure, name):
        curve = next(curve for curve in self.page.figures[figure]["curves"] if curve["name"] == name)
        return [[None if value is None else float(value) for value in curve[axis]] for axis in "xy"]

    def test_cards(self):
        """Means with the digits of half their intervals; whole numbers behind them."""
        cards = pages.cards(self.page.text)
        self.assertEqual([(title, number, unit) for title, number, unit, _ in cards],
                         [("0.523456 N/m^1.5", "0.52", "N/m^1.5"), ("0.0003 J", "3.00e-4", "J"), (None, "0.4", "")])
        self.assertIn("90 % interval 0.41\u00a0to\u00a00.63; identified: yes", cards[0][3])

    def test_p_that_tells_nothing(self):
        self.assertIn("below 0.05 the model does not reach them", pages.cards(self.page.text)[-1][3])
        with open(self.path("fit/calibration.json"), "w") as file:
            json.dump({**self.found, "card_targets": "untold"}, file)
        self.assertEqual(clod.run("report", "fit", cwd=self.folder).returncode, 0)
        self.assertIn("it does not tell whether the card meets them", pages.cards(pages.load(self.path("fit/report.html")).text)[-1][3])

    def test_posterior_and_prior(self):
        """Even from 0.4 to 0.65 of a range from 0 to 1: four times the prior. Of b even in the logarithm, over log 2 of log 10."""
        x, y = self.curve("Posterior-of-a", "posterior")
        self.assertLess(max(abs(value - 4.0) for value in y[1:-1]), 0.1)
        self.assertLess(max(abs(x[0] - 0.4), abs(x[-1] - 0.65)), 0.001)
        self.assertEqual(self.curve("Posterior-of-a", "prior"), [[0, 0, 1, 1], [0, 1, 1, 0]])
        self.assertEqual(self.curve("Posterior-of-a", "90 % interval")[0], [self.found["parameters"]["a"]["low"]] * 2)
        self.assertEqual(self.curve("Posterior-of-a", "mean")[0], [self.found["parameters"]["a"]["mean"]] * 2)
        x, y = self.curve("Posterior-of-b", "posterior")
        self.assertTrue(self.page.figures["Posterior-of-b"]["log_x"])
        self.assertLess(max(abs(value - 3.3219) for value in y[1:-1]), 0.1)  # log 10/log 2
        for figure in ("Posterior-of-a", "Posterior-of-b"):
            x, y = self.curve(figure, "posterior")
            about = self.found["parameters"][figure[-1]]
            place = (lambda value: value) if about["scale"] == "linear" else math.log
            area = sum((place(x[k + 1]) - place(x[k])) * y[k] for k in range(len(x) - 1) if x[k + 1] != x[k])
            self.assertAlmostEqual(area / (place(about["to"]) - place(about["from"])), 1.0, places=9)

    def test_pairs(self):
        """Samples of both, each of them a row of posterior.csv."""
        x, y = self.curve("Posterior-of-a-and-b", "samples of the posterior")
        rows = pages.cells(self.path("fit"), "posterior.csv")
        known = set(zip(map(float, rows["a"]), map(float, rows["b"])))
        self.assertTrue(200 < len(x) <= 400)
        self.assertLessEqual(set(zip(x, y)), known)
        self.assertEqual(self.curve("Posterior-of-a-and-b", "mean"), [[0.523456], [3e-4]])

    def test_predicted_over_measured(self):
        """One figure for each unit; what was held back is hollow; bars are the intervals."""
        figure = self.page.figures["predicted"]
        self.assertEqual((figure["x"]["unit"], self.page.figures["predicted-2"]["x"]["unit"]), ("deg", "kPa"))
        self.assertEqual(self.curve("predicted", "targets that were used"), [[33.5], [33.6]])
        self.assertEqual(self.curve("predicted", "held back"), [[30.25], [29.5]])
        self.assertEqual(next(curve["style"] for curve in figure["curves"] if curve["name"] == "held back"), "hollow")
        bars = [curve for curve in figure["curves"] if curve["name"] == ""]
        self.assertEqual([bar["y"] for bar in bars], [["32.5", "34.7", None], ["28", "31", None]])
        self.assertEqual([curve["name"] for curve in self.page.figures["predicted-2"]["curves"] if curve["name"]],
                         ["predicted as measured", "targets that were used"])

    def test_version_and_date(self):
        self.assertEqual(self.page.row("runs computed by")[1], "clod 9 (abc)")
        self.assertEqual(self.page.row("calibrated by")[1], "clod 10 (def)")
        self.assertEqual(self.page.row("calibration.json written")[1], "2001-02-03 04:05 UTC")
        self.assertIn(", computed until 2001-02-03 04:05 UTC</p>", self.page.text)
        version = clod.run("--version").stdout.split("\n")[0].split(",")[0]
        self.assertIn(version, self.page.row("page written by")[1])

    def test_time_of_an_older_folder(self):
        """Without version and time in the file, or with one that is none: the time of the file, and no version of it."""
        for written in ({}, {"written": "2001"}, {"written": 7}, {"written": "<b>2001-02-03T04:05</b>"}):
            with open(self.path("fit/calibration.json"), "w") as file:
                json.dump({**{key: value for key, value in self.found.items() if key not in ("version", "written")}, **written}, file)
            os.utime(self.path("fit/calibration.json"), (86400, 86400 + 3 * 3600 + 25 * 60))  # of the second day of 1970
            self.assertEqual(clod.run("report", "fit", cwd=self.folder).returncode, 0)
            page = pages.load(self.path("fit/report.html"))
            self.assertEqual(page.row("calibration.json written")[1], "1970-01-02 03:25 UTC")
            self.assertNotIn("calibrated by", page.text)

    def test_tables(self):
        self.assertEqual(self.page.row("a [N/m^1.5]")[1:], ["0.52", "0.41\u00a0to\u00a00.63", "0.53", "0\u00a0to\u00a01", "linear", "0.22", "yes", "1.001", "812"])
        self.assertEqual(self.page.row("ring: sigma_c [kPa]")[1:], ["7.50 ± 0.25", "0.5", "7.25", "6.50\u00a0to\u00a08.00", "7.50", "0.10"])

    def test_drawn(self):
        """All figures are drawn without an error, the samples are seen, and no axis says u for a millionth."""
        self.need_scripts(self.done)
        for width in (1280, 390):
            seen, dom = self.show("fit/report.html", width)
            self.assertEqual(int(seen["figures"]), len(self.page.figures))
            self.assertEqual(json.loads(seen["hidden"]), [])
            self.assertGreater(len(pages.Drawn(dom, "Posterior-of-a-and-b").marks()), 200)
            labels = re.findall(r'<g class="[xy]tick"><text[^>]*>([^<]*)</text>', dom)
            self.assertGreater(len(labels), 50)
            for label in labels:
                self.assertRegex(label.replace("\u2212", "-"), r"^-?[0-9.]+(e[-+]?\d+)?$")

    def test_chains_that_lie_apart(self):
        """No card and no figure of a parameter; the rest of the page, without numbers that there are not."""
        nothing = {"mean": None, "card": None, "low": None, "high": None, "relative_width": None, "identified": "apart"}
        parameters = {name: {**about, **nothing} for name, about in self.found["parameters"].items()}
        targets = [{**target, "model": None, "card": None, "low": None, "high": None, "off": None} for target in self.found["targets"]]
        with open(self.path("fit/calibration.json"), "w") as file:
            json.dump({**self.found, "chains_apart": True, "parameters": parameters, "targets": targets}, file)
        with open(self.path("fit/posterior.csv"), "w") as file:
            file.write("a [N/m^1.5],b [J]\n")
        done = clod.run("report", "fit", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = pages.load(self.path("fit/report.html"))
        self.assertEqual([card[1] for card in pages.cards(page.text)], ["no result", "0.4"])
        self.assertEqual(page.row("a [N/m^1.5]")[1:], ["", "", "", "0\u00a0to\u00a01", "linear", "", "apart", "1.001", "812"])
        self.assertNotRegex(page.text.split("clod-data")[0], r"\bnan\b")
        self.assertNotIn("Posterior-of-a", page.figures)
        self.assertNotIn("predicted", page.figures)
        self.assertIn("target", page.figures)

    def test_without_samples(self):
        """A folder without posterior.csv has the rest of its page."""
        os.remove(self.path("fit/posterior.csv"))
        self.assertEqual(clod.run("report", "fit", cwd=self.folder).returncode, 0)
        figures = pages.load(self.path("fit/report.html")).figures
        self.assertNotIn("Posterior-of-a", figures)
        self.assertIn("predicted", figures)


if __name__ == "__main__":
    clod.unittest.main()
