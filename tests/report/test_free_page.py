"""The page of a free run: its figures, warnings of streams, numbers as cards and tables."""

import html
import os
import re
import sys
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod


class FreePage(pages.PageCase):

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
        self.assertIn("± standard deviation of the means of ten blocks of time; the error of the mean is this over √10", " ".join(page.words))
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
        pages.free_run(self.path("run"), **{"time_s": 1.0, "inlets": inlets, "gauges": gauges, "balance": balance, **changes})
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
        doubt = "Balance: what is inside grows by 1 kg/s & more."
        self.assertEqual(self.plugged(warnings=[doubt], inlets=[], gauges={}, balance={}).items, [doubt])
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
        pages.free_run(self.path("run"), gauges=gauges, time_s=2.0)
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

    def test_cards_of_what_was_measured(self):
        """Angle of repose with its error, mixing, mass flow of gauges; then no kinetic energy of grains at rest."""
        repose = {"heap": {"angle_deg": 28.159265, "error_deg": 0.9116774, "mean_deg": 28.159265, "deviation_deg": 7e-9, "height_m": 0.0457, "strips": 7},
                  "none": {"angle_deg": None, "error_deg": None, "mean_deg": None, "deviation_deg": None, "height_m": None, "strips": 0}}
        mixing = {"drum": {"by": "number", "lacey": 0.8731, "mean": 0.85, "deviation": 0.012, "share": 0.5}}
        gauges = {"head": {**pages.FREE["gauges"]["head"], "passed_forward": 421, "passed_back": 0, "mass_forward_kg": 1.2345678,
                           "flow_through_kg_per_s": {"mean": 0.8212345, "deviation": 0.0312}}}
        pages.free_run(self.path("run"), repose=repose, mixing=mixing, gauges=gauges, outlets=None)
        self.made("report", "run")
        page = self.page("run/report.html")
        cards = re.findall(r'<div class="card"><b(?: title="([^"]*)")?>(.*?)</b><span>(.*?)</span>', page.text)
        plain = [(html.unescape(title), html.unescape(re.sub("<[^>]*>", "", number)), caption) for title, number, caption in cards]
        self.assertEqual(plain[:4], [("28.159265 ± 0.9116774 deg", "28.16 ± 0.91 deg", "angle of repose: heap"),
                                     ("0.8731", "0.873", "mixing index (Lacey): drum"),
                                     ("0.8343702206 ± 0.0204139 kg/s", "0.834 ± 0.020 kg/s", "mass flow, mean and deviation: head"),
                                     ("0.8212345 ± 0.0312 kg/s", "0.821 ± 0.031 kg/s", "flow through the plane, mean and deviation: head")])
        self.assertEqual(page.row("passed forward")[1], "421")
        self.assertEqual(page.row("flow through [kg/s]")[1], "0.821 ± 0.031")
        self.assertNotIn("kinetic energy", [caption for *_, caption in plain])
        self.assertEqual(page.row("angle [deg]")[1], "28.16 ± 0.91")
        self.assertEqual(page.row("mean [deg]")[1], "28.16")  # its deviation is below what is told
        notes = [html.unescape(note) for note in re.findall(r'</table></div>\n<p class="note">([^<]*)</p>', page.text)]
        blocks = "± standard deviation of the means of ten blocks of time; the error of the mean is this over √10 if the blocks are independent."
        self.assertEqual(notes, [blocks, f"mean {blocks}", f"angle ± standard error of the line through the flank at the end; mean {blocks}"])
        pages.free_run(self.path("bed"), gauges={}, outlets=None)
        self.made("report", "bed")
        self.assertIn("<span>kinetic energy</span>", self.page("bed/report.html").text)

    def test_what_residence_times_scatter_by(self):
        """Their ± is of grains, and no error; a run without a spread needs no note."""
        for spread, notes in ((0.25, 1), (0.0, 0)):
            pages.free_run(self.path("run"), gauges={}, residence={"grains": 12, "mean_s": 1.3156, "deviation_s": spread, "classes": []})
            self.made("report", "run")
            page = self.page("run/report.html")
            self.assertEqual(page.text.count("± standard deviation of the times of the grains that left"), notes)
            self.assertNotIn("ten blocks", page.text)

    def test_more_outlets_than_a_table_holds(self):
        one = pages.FREE["outlets"]["delivered"]
        pages.free_run(self.path("run"), outlets={f"lip{k}": one for k in range(70)})
        self.made("report", "run")
        self.assertIn("6 more of them, and 0 more numbers of these, are in summary.json.", self.page("run/report.html").text)


if __name__ == "__main__":
    clod.unittest.main()
