"""clod compare: runs side by side, their names, means over seeds, warnings and provenance of every run."""

import html
import math
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod

RISING = "preshear: shear stress still rising by %s kPa/mm after 14.3 mm of shear"


class Compare(pages.PageCase):

    def shear(self, name, seed, shift=0.0, density="2500", warnings=(), **changes):
        """A ring shear test whose cohesion is 1.375 kPa and `shift`."""
        pages.shear(self.path(name), shift)
        summary = pages.load_json(self.path(f"{name}/summary.json"))
        summary.update({"warnings": list(warnings), "seed": seed, "wall_clock_s": 61.5, **changes})
        pages.write(self.path(name), summary__json=summary,
                    log__jsonl='{"time":"2026-01-31T12:34:56Z","event":"begin"}\n',
                    **{"case_HYPHEN_complete__yaml": pages.COMPLETE % (name, density) + f"seed: {seed}\nring_shear:\n  seeds: 1\n"})

    def compare(self, *names):
        done = clod.run("compare", *names, "-o", "page.html", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.shown = done.stdout
        return pages.load(self.path("page.html"))

    def assert_shown(self, page):
        """The terminal has the warnings of the page first, each a line, and then an empty one; the lines."""
        told = page.text[page.text.index('id="warnings"'):page.text.index("</section>")].replace("the numbers of each", "")
        told = re.split("<li>|(?=<h3>)", told)[1:]
        shown = self.shown[:self.shown.index("\n\n  quantity")].split("\n")
        self.assertEqual(shown[0], "Warnings")
        self.assertEqual([re.sub("^(- |    )", "", line) for line in shown[1:] if line],
                         [html.unescape(re.sub("<[^>]*>", "", text)).strip() for text in told])
        return shown

    def column(self, page, head):
        """Cells of a column of the table of results, by the first cell of each row."""
        table = page.tables[0]
        at = table[0].index(head)
        return {row[0]: row[at] for row in table[1:]}

    def test_mean_of_seeds(self):
        """Cohesions of 1.3, 1.4 and 1.5 kPa: mean 1.4, deviation 0.1, standard error 0.1/sqrt(3) kPa."""
        for seed, shift in ((1, -75.0), (2, 25.0), (3, 125.0)):
            self.shear(f"seed{seed}", seed, shift)
        self.shear("dense", 4, 900.0, density="2600")  # another case
        self.shear("again", 2, 25.0)                   # nothing new
        self.shear("early", 5, 5000.0)
        os.remove(self.path("early/report.txt"))       # not complete
        page = self.compare("seed1", "seed2", "seed3", "dense", "again", "early")
        means = self.column(page, "mean, n = 3")
        self.assertEqual(means["cohesion [kPa]"], "1.400 ± 0.058 (s 0.100)")
        self.assertEqual(means["flow (Jenike)"], "-")
        titles = [html.unescape(title) for title in re.findall(r'<td title="([^"]*)"', page.text)]
        whole = [title for title in titles if title.startswith("1400 ± ")]
        self.assertEqual(len(whole), 1)
        self.assertAlmostEqual(float(whole[0].split()[2]), 100.0 / math.sqrt(3.0), places=9)
        note = "".join(page.words)
        self.assertIn("of 3 runs whose cases differ in nothing but seed and title: seed1, seed2, seed3.", note)
        self.assertIn("again has the case of seed2 and a seed of it: they have a packing in common", note)

    def preshear(self, name, seed, way, rate, error):
        return {"part": name, "seed": seed, "steady": True, "displacement_m": way, "shear_stress_rate_Pa_per_m": rate,
                "shear_stress_rate_error_Pa_per_m": error}

    def test_how_preshear_ended(self):
        """Way and slope with its error; of the specimens of one test their mean: of 0.1 and 0.3 kPa/mm 0.2 with an error of 0.1, of 10 and
        14 mm 12 with 2. Of both tests 16 and 0.02 kPa/mm; nothing of a test whose clod told no slope but its way."""
        self.shear("one", 1, parts=[self.preshear("preshear", 1, 20e-3, -0.16e6, 0.04e6), {"part": "point-1", "seed": 1, "displacement_m": 1e-3}])
        self.shear("two", 3, parts=[self.preshear("preshear-1", 3, 10e-3, 0.1e6, 0.9e6), self.preshear("preshear-2", 4, 14e-3, 0.3e6, 0.9e6)])
        self.shear("old", 5, density="2600", parts=[{"part": "preshear", "seed": 5, "steady": True, "displacement_m": 8e-3}])
        page = self.compare("one", "two", "old")
        way = page.row("way of preshear at its end [mm]")
        self.assertEqual(way[2:], ["20.0", "12.0 ± 2.0", "8.0", "16.0 ± 4.0 (s 5.7)"])
        slope = page.row("slope of the shear stress there [kPa/mm]")
        self.assertEqual(slope[2:], ["-0.160 ± 0.040", "0.20 ± 0.10", "", "0.02 ± 0.18 (s 0.25)"])
        self.shear("none", 6, density="2700")
        self.shear("nothing", 7, density="2700")
        page = self.compare("none", "nothing")
        self.assertNotIn("way of preshear", "".join(page.words))

    def test_a_case_and_a_copy_of_it(self):
        """One packing, and not two, unless they began from other grains."""
        same = "are 2 runs of one packing"
        for name, origins in (("free", (None, None)), ("moved", ("/runs/a", "/runs/a")), ("other", ("/runs/a", "/runs/b")), ("either", ("/runs/a", None))):
            for number, origin in enumerate(origins):
                pages.free_run(self.path(f"{name}{number}"), **({} if origin is None else {"from": origin}))
            note = "".join(self.compare(f"{name}0", f"{name}1").words)
            equal = origins[0] == origins[1]
            self.assertEqual(same in note, equal, name)
            self.assertEqual("began from other grains" in note, not equal, name)
            self.assertEqual(f"{name}1 has the case of {name}0 and a seed of it: they have a packing in common" in note, equal, name)
            self.assertNotIn("mean, n", note)
        self.shear("one", 1)
        shutil.copytree(self.path("one"), self.path("copy"))
        self.shear("another", 2)
        self.assertIn(same, "".join(self.compare("one", "copy").words))
        note = "".join(self.compare("one", "copy", "another").words)
        self.assertNotIn("of one packing", note)  # not all of them
        self.assertIn("copy has the case of one and a seed of it", note)
        self.assertNotIn("a seed of it", "".join(self.compare("one", "another").words))

    def test_a_run_named_twice(self):
        pages.free_run(self.path("run"))
        pages.free_run(self.path("last"))
        os.symlink("run", self.path("link"))
        for again in ("run", "./run/", self.path("run"), "link"):
            done = self.made("compare", "run", "last", again, code=2)
            self.assertIn(f"run and {again} are the same folder: name each run once.", done.stderr)

    def test_packings_in_common_are_no_repeats(self):
        """With two seeds a test has the packings seed and seed + 1: those of 1 and 2 have one in common, those of 1 and 3 none."""
        for seed in (1, 2, 3):
            parts = [{"part": f"{part}{packing}", "seed": packing} for packing in (seed, seed + 1) for part in ("preshear", "point")]
            self.shear(f"seed{seed}", seed, 104.0 * seed, parts=parts)
        page = self.compare("seed1", "seed2", "seed3")
        self.assertEqual(self.column(page, "mean, n = 2")["cohesion [kPa]"], "1.58 ± 0.10 (s 0.15)")  # 1.479 and 1.687
        self.assertIn("seed2 has the case of seed1 and a seed of it: they have a packing in common", "".join(page.words))
        self.assertNotIn("no part in means", "".join(self.compare("seed1", "seed3").words))

    def test_many_runs_are_rows(self):
        """The mean of nine is the last row; cohesions of 1.375 to 2.175 kPa: deviation 0.1 sqrt(60/8), error a third of it."""
        for seed in range(1, 10):
            self.shear(f"seed{seed}", seed, 100.0 * (seed - 1))
        table = self.compare(*(f"seed{seed}" for seed in range(1, 10))).tables[0]
        self.assertEqual([row[0] for row in table], ["run", *(f"seed{seed}" for seed in range(1, 10)), "mean, n = 9"])
        mean = dict(zip(table[0], table[-1]))
        self.assertEqual(mean["c [kPa]"], "1.775 ± 0.091 (s 0.274)")

    def test_few_runs_are_columns(self):
        self.shear("one", 1)
        self.shear("two", 2, 100.0)
        page = self.compare("one", "two")
        self.assertEqual(page.tables[0][0], ["quantity", "", "one", "two", "mean, n = 2"])
        # by hand: 1375 and 1475 Pa; deviation 100/sqrt(2), error 50 Pa
        self.assertEqual(page.row("cohesion [kPa]")[2:], ["1.375", "1.475", "1.425 ± 0.050 (s 0.071)"])

    def test_two_groups(self):
        """Each case that was repeated has its own mean."""
        for name, seed, density in (("dry1", 1, "2500"), ("dry2", 2, "2500"), ("wet1", 1, "2600"), ("wet2", 2, "2600"), ("wet3", 3, "2600")):
            self.shear(name, seed, 10.0 * seed + (500.0 if density == "2600" else 0.0), density)
        page = self.compare("dry1", "wet1", "dry2", "wet2", "wet3")
        table = page.tables[0]
        self.assertEqual([cell for cell in table[0] if "mean" in cell], ["mean 1, n = 2", "mean 2, n = 3"])
        told = page.row("cohesion [kPa]")[-2:]
        self.assertEqual(told, ["1.3900 ± 0.0050 (s 0.0071)", "1.8950 ± 0.0058 (s 0.0100)"])

    def test_none_without_other_seeds(self):
        self.shear("one", 1)
        self.shear("two", 2, density="2600")
        page = self.compare("one", "two")
        self.assertNotIn("mean, n", "".join(page.words))

    def test_means_of_every_kind(self):
        """Strengths, walls and free runs have them, too."""
        for seed, (strength, angle) in enumerate(((11000.0, 18.0), (12000.0, 19.0)), 1):
            pages.uniaxial(self.path(f"u{seed}"))
            flow = [{**pages.UNIAXIAL["flow_function"][0], "sigma_c_Pa": strength}]
            self.seeded(f"u{seed}", seed, {**pages.UNIAXIAL, "flow_function": flow})
            pages.wall(self.path(f"w{seed}"))
            locus = {**pages.WALL["wall_locus"], "phi_w_deg": pages.value(angle, 0.1)}
            self.seeded(f"w{seed}", seed, {**pages.WALL, "wall_locus": locus})
            pages.free_run(self.path(f"f{seed}"))
            self.seeded(f"f{seed}", seed, {**pages.FREE, "coordination": 4.0 + seed})
        # the error of two numbers is half of what is between them
        self.assertEqual(self.compare("u1", "u2").row("unconfined yield strength [kPa]")[-1], "11.50 ± 0.50 (s 0.71)")
        self.assertEqual(self.compare("w1", "w2").row("kinematic angle of wall friction [deg]")[-1], "18.50 ± 0.50 (s 0.71)")
        self.assertEqual(self.compare("f1", "f2").row("coordination")[-1], "5.50 ± 0.50 (s 0.71)")

    def test_what_free_runs_measured(self):
        """Each number of any run has a row: with the ± of its run, and a mean: angles of 28 to 32 deg, indices of 0.8 and 0.9; one run has no drum."""
        for seed, (angle, lacey) in enumerate(((28.0, 0.8), (30.0, 0.9), (32.0, None)), 1):
            pages.free_run(self.path(f"f{seed}"))
            gauges = {"head <b>": {"mass_flow_kg_per_s": {"mean": 0.8 + 0.01 * seed, "deviation": 0.02},
                                   "flow_through_kg_per_s": {"mean": 0.9 + 0.01 * seed, "deviation": 0.034}}}
            mixing = {} if lacey is None else {"drum": {"by": "number", "lacey": lacey}}
            self.seeded(f"f{seed}", seed, {**pages.FREE, "repose": {"heap": {"angle_deg": angle, "error_deg": 0.9}}, "mixing": mixing, "gauges": gauges})
        page = self.compare("f1", "f2", "f3")
        # deviations 2, 0.1/sqrt(2) and 0.01, errors 2/sqrt(3), 0.05 and 0.01/sqrt(3)
        self.assertEqual(page.row("heap: angle [deg]")[1:], ["28.00 ± 0.90", "30.00 ± 0.90", "32.00 ± 0.90", "30.0 ± 1.2 (s 2.0)"])
        self.assertEqual(page.row("drum: lacey")[1:], ["0.8", "0.9", "-", "0.850 ± 0.050 (s 0.071) (n 2)"])
        self.assertEqual(page.row("drum: by")[1:], ["number", "number", "-", "-"])
        self.assertEqual(page.row("head <b>: mass flow [kg/s]")[1:], ["0.810 ± 0.020", "0.820 ± 0.020", "0.830 ± 0.020", "0.8200 ± 0.0058 (s 0.0100)"])
        self.assertEqual(page.row("head <b>: flow through [kg/s]")[1:], ["0.910 ± 0.034", "0.920 ± 0.034", "0.930 ± 0.034", "0.9200 ± 0.0058 (s 0.0100)"])
        self.assertIn('<td title="28 &plusmn; 0.9 deg">', page.text)

    # two runs of a chute: what one has stuck to it; a gauge of the other with alarms
    CHUTE = {"balance": {"since_s": 1.0, "start": {"grains": 0, "mass_kg": 0.0},
                         "in": {"grains": 166083, "mass_kg": 1.11, "flow_kg_per_s": {"mean": 0.555, "deviation": 0.0055}},
                         "out": {"left_x_max": {"grains": 0, "mass_kg": 0.0, "spillage": False},
                                 "left_z_min": {"grains": 5, "mass_kg": 0.8, "flow_kg_per_s": {"mean": 0.4557, "deviation": 0.26}, "spillage": False}},
                         "spillage": {"grains": 0, "mass_kg": 0.0}, "inside": {"grains": 9, "mass_kg": 0.25}, "lost": {"grains": 0, "mass_kg": 0.0}},
             "gauges": {"lip": {"alarms": 2, "blocked_at_end": True, "speed_m_per_s": {"mean": 1.5873, "deviation": 0.0112}}},
             "build_up": {"chute.floor": {"mass_kg": 0.0, "rate_kg_per_s": 0.0}},
             "residence": {"grains": 12, "mean_s": 1.3156, "deviation_s": 0.2514, "classes": []},
             "belts": {"feed": {"power_W": {"mean": 36.04, "deviation": 1.25}}},
             "fields": {"bed": {"velocity_m_per_s": {"mean": [0.5, 0.0, -2.0], "deviation": [0.25, 0.0, 0.5]}}},
             "walls": [{"name": "chute", "force_N": [0.25, 0.0, -8.72]}], "outlets": {}, "left": {}}

    def test_what_decides_about_a_chute(self):
        """Balance, gauges, resting mass and its rate, residence, belts, fields, alarms, as the page of one run has them."""
        pages.free_run(self.path("steel"), **self.CHUTE)
        rusty = {**self.CHUTE, "build_up": {"chute.floor": {"mass_kg": 0.1126, "rate_kg_per_s": 0.08555}},
                 "gauges": {"lip": {"alarms": 0, "blocked_at_end": False, "speed_m_per_s": {"mean": 0.3881, "deviation": 0.079}}}}
        pages.free_run(self.path("rust"), density="2600", **rusty)
        done = self.made("compare", "steel", "rust")
        page = self.page("compare.html")
        wanted = {"in: grains": ["166083", "166083"], "in: flow [kg/s]": ["0.5550 ± 0.0055"] * 2, "inside: mass [kg]": ["0.25"] * 2,
                  "spillage: grains": ["0", "0"], "lost: mass [kg]": ["0", "0"],
                  "left z min: flow [kg/s]": ["0.46 ± 0.26"] * 2, "lip: alarms": ["2", "0"], "lip: blocked at end": ["yes", "no"],
                  "lip: speed [m/s]": ["1.587 ± 0.011", "0.388 ± 0.079"], "chute.floor: mass [kg]": ["0", "0.1126"],
                  "chute.floor: rate [kg/s]": ["0", "0.08555"], "what left: mean [s]": ["1.32 ± 0.25"] * 2, "feed: power [W]": ["36.0 ± 1.2"] * 2,
                  "bed: velocity x [m/s]": ["0.50 ± 0.25"] * 2, "bed: velocity z [m/s]": ["-2.00 ± 0.50"] * 2, "chute: force z [N]": ["-8.72"] * 2}
        for name, cells in wanted.items():
            self.assertEqual(page.row(name)[1:], cells, name)
        told = [row[0] for table in page.tables for row in table]
        for name in ("left x max: grains", "left x max: spillage", "left z min: spillage", "bed: velocity y [m/s]", "chute: force y [N]"):
            self.assertNotIn(name, told)  # nothing in any run
        self.assertEqual([told.count(name) for name in wanted], [1] * len(wanted))
        words = " ".join(page.words)
        for note in ("± standard deviation of the means of ten blocks", "± standard deviation of the times of the grains that left"):
            self.assertIn(note, words)
            self.assertIn(note, done.stdout)
        # the terminal has the same rows
        shown = [re.split("  +", line.strip()) for line in done.stdout.split("\n")]
        for name, cells in wanted.items():
            self.assertIn([name, *cells], shown)
        self.assertEqual(done.stdout.split("\n")[-3:],
                         ["Curves, and what differs between the cases:", "compare.html", ""])

    def test_curves_of_free_runs_have_names_in_words(self):
        for name, density in (("one", "2500"), ("two", "2600")):
            pages.free_run(self.path(name), density=density)
            pages.write(self.path(name), series__csv="time [s],max_speed [m/s],left_x_max.grains [1],chute.floor.resting_mass [kg]\n0,1,0,0\n1,2,3,4\n")
        figures = self.compare("one", "two").figures.values()
        self.assertEqual([(figure["title"], figure["y"]["text"]) for figure in figures],
                         [("Max speed", "max speed"), ("Grains: left x max", "grains"), ("Resting mass: chute.floor", "resting mass")])

    def test_many_free_runs(self):
        """Of more than seven there are several tables of many quantities, each with seven runs at most."""
        gauge = {f"number_{k}": 0.5 + k for k in range(20)}
        for k in range(9):
            pages.free_run(self.path(f"run{k}"), density=str(2500 + k), gauges={"lip": gauge})
        page = self.compare(*(f"run{k}" for k in range(9)))
        heads = [table[0] for table in page.tables if any(row[0] == "lip: number 19" for row in table)]
        self.assertEqual(heads, [["quantity", *(f"run{k}" for k in range(7))], ["quantity", "run7", "run8"]])
        self.assertEqual(page.tables[0][0][:3], ["run", "time [s]", "grains"])

    def seeded(self, name, seed, summary):
        case = clod.read(self.path(f"{name}/case-complete.yaml")).decode()
        if "parts" in summary:
            summary = {**summary, "parts": [{**part, "seed": seed} for part in summary["parts"]]}
        pages.write(self.path(name), summary__json=summary, **{"case_HYPHEN_complete__yaml": f"{case}seed: {seed}\n"})

    def test_warnings_of_each_run(self):
        """Those that differ in their numbers are one, with the numbers of each; others have the names of their runs."""
        self.shear("a", 1, warnings=[RISING % "0.75 ± 0.2", "point-4: no peak"])
        self.shear("b", 2, warnings=[RISING % "1.5 ± 0.02"])
        self.shear("c", 3, warnings=[RISING % "1.5 ± 0.02", "point-4: no peak"])
        page = self.compare("a", "b", "c")
        self.assertLess(page.text.index('id="warnings"'), page.text.index('id="results"'))
        told = page.text[page.text.index('id="warnings"'):page.text.index('id="results"')]
        words = html.unescape(re.sub(r"<[^>]*>", "", told))
        self.assertIn("All 3 runs: " + RISING % "0.75 ± 0.2" + " (as a has it)", words)
        for name, number in (("a", "0.75 ± 0.2"), ("b", "1.5 ± 0.02"), ("c", "1.5 ± 0.02")):
            self.assertIn(f"{name}: " + RISING % number, words)
        self.assertIn("a, c: point-4: no peak", words)
        self.assertEqual(words.count("no peak"), 1)
        self.assertEqual(self.assert_shown(page),
                         ["Warnings", f"- All 3 runs: {RISING % '0.75 ± 0.2'} (as a has it)", f"    a: {RISING % '0.75 ± 0.2'}",
                          f"    b: {RISING % '1.5 ± 0.02'}", f"    c: {RISING % '1.5 ± 0.02'}", "- a, c: point-4: no peak"])

    def test_warnings_in_the_terminal(self):
        """They are grouped as on the page; those of a laboratory's points have a heading."""
        parts = [{"part": part, "seed": 1} for part in ("point-1", "point-2")]
        self.shear("one", 1, parts=parts, warnings=["point-1: overlap 3 %", "point-2: overlap 4 %", 'a <b> & "c" &lt;'])
        self.shear("two", 2)
        self.assertEqual(self.assert_shown(self.compare("one", "two")),
                         ["Warnings", "- one: point-1: overlap 3 % (the first of 2)", "    one: point-1: overlap 3 %",
                          "    one: point-2: overlap 4 %", '- one: a <b> & "c" &lt;'])
        with open(self.path("lab.csv"), "w") as file:
            file.write(pages.LAB.replace("10,7.2", "20,14.4"))  # a shear at 3 kPa is below a fifth of 20 kPa
        shown = self.assert_shown(self.compare("one", "two", "--lab", "lab.csv"))
        self.assertTrue(shown[5].startswith("- All 2 runs: The laboratory's points are at a preshear stress of 20.000 kPa"), shown)
        self.assertEqual(shown[6:8], ["", "Laboratory points"])
        self.assertTrue(shown[8].startswith("- Yield locus at a preshear stress of 20.000 kPa: Shear at 3.000 kPa is outside"), shown)

    def test_a_warning_does_not_spoil_the_terminal(self):
        pages.free_run(self.path("one"), gauges={}, warnings=["odd \x1b[31m\tname\n"])
        pages.free_run(self.path("two"), gauges={})
        self.compare("one", "two")
        self.assertTrue(self.shown.startswith("Warnings\n- one: odd ?[31m?name?\n\n  quantity "), self.shown)

    def test_where_it_comes_from(self):
        self.shear("one", 1)
        self.shear("two", 7, version="clod 10")
        page = self.compare("one", "two")
        rows = next(table for table in page.tables if table[0][0] == "results folder")
        at = [rows[0].index(head) for head in ("computed by", "until", "seed")]
        self.assertEqual([[row[k] for k in at] for row in rows[1:]],
                         [["clod 9", "2026-01-31 12:34 UTC", "1"], ["clod 10", "2026-01-31 12:34 UTC", "7"]])
        version = clod.run("--version").stdout.split("\n")[0].split(",")[0]
        self.assertIn(f"This page was written by {version}", "".join(page.words))

    def test_a_run_that_is_not_complete(self):
        self.shear("one", 1)
        self.shear("two", 2)
        os.remove(self.path("two/report.txt"))
        page = self.compare("one", "two")
        self.assertEqual(page.items[0], "two: The run is not complete: this page shows what there is so far.")

    def test_no_warnings(self):
        self.shear("one", 1)
        self.shear("two", 2)
        self.assertIn("No warnings.", "".join(self.compare("one", "two").words))
        self.assertTrue(self.shown.startswith("No warnings.\n\n  quantity "), self.shown)
        for name in ("three", "four"):
            pages.free_run(self.path(name), gauges={})  # nothing was checked
        self.assertNotIn("No warnings", "".join(self.compare("three", "four").words))
        self.assertTrue(self.shown.startswith("  quantity "), self.shown)

    def test_more_measures_than_the_table_has(self):
        """A table has 64 objects of each run: of 70 gauges those are named, and the page says that there are more."""
        gauge = pages.FREE["gauges"]["head"]
        for name, first, last in (("one", 0, 64), ("two", 10, 64), ("three", 0, 70)):
            pages.free_run(self.path(name), outlets=None, gauges={f"g{k}": gauge for k in range(first, last)}, density=str(2500 + last + first))
        for names, more in ((("one", "two"), False), (("one", "three"), True)):
            page = self.compare(*names)
            rows = [row[0] for table in page.tables for row in table if "mass flow" in row[0]]
            self.assertEqual(rows, [f"g{k}: mass flow [kg/s]" for k in range(64)])
            self.assertEqual("Not all that the runs measured has a place" in "".join(page.words), more)

    def test_compare(self):
        pages.free_run(self.path("one"))
        pages.free_run(self.path("two"), density="2600", grains=7)
        pages.free_run(self.path("three"), grains=8)
        self.made("compare", "one", "two", "three")
        page = self.page("compare.html")
        self.assertEqual(page.tables[0][0], ["quantity", "one", "two", "three"])
        self.assertEqual(page.row("grains")[1:], ["120", "7", "8"])
        self.assertEqual(page.row("materials.ore.density"),
                         ["materials.ore.density", "2500 kg/m3", "2600 kg/m3", "2500 kg/m3"])
        series = pages.cells(self.path("one"), "series.csv")
        figure = page.figures["kinetic-energy"]
        self.assertEqual([curve["name"] for curve in figure["curves"]], ["one", "two", "three"])
        for number in range(3):
            self.assert_curve(figure, number, series, "time", "kinetic_energy")
        self.assertTrue(os.path.exists(self.path("compare-kinetic-energy.svg")))

    def test_names_of_compared_runs(self):
        """As many parts of the path as it takes to tell the runs apart, and no more."""
        for folders, names in ((["a/run", "b/run"], ["a/run", "b/run"]),
                               (["a/run", "c/a/run", "b/last"], ["a/run", "c/a/run", "last"]),
                               (["run", "a/run/"], ["run", "a/run"]),
                               (["b//run", self.path("a/run")], ["b//run", "a/run"])):
            for number, folder in enumerate(folders):
                pages.free_run(self.path(folder), density=str(2500 + number))
            self.made("compare", *folders)
            page = self.page("compare.html")
            self.assertEqual([curve["name"] for curve in page.figures["kinetic-energy"]["curves"]], names)
            self.assertEqual(page.tables[0][0][1:], names)
            self.assertEqual(page.row("key")[1:], names)

    def test_wall_friction_tests_side_by_side(self):
        pages.wall(self.path("one"))
        pages.wall(self.path("two"))
        self.made("compare", "one", "two", "-o", "both.html")
        page = self.page("both.html")
        self.assertEqual([curve["name"] for curve in page.figures["wall-yield-locus"]["curves"]], ["one", "", "two", ""])
        self.assertEqual(page.row("kinematic angle of wall friction [deg]")[1:], ["φw", "18.25 ± 0.13", "18.25 ± 0.13"])
        self.assertEqual(len(page.figures["Shear-stress--wall"]["curves"]), 2)

    def test_a_run_named_laboratory(self):
        """Hollow points are those of --lab, whatever the folders are called."""
        points = [{"sigma_s_Pa": 3000.0, "prorated_Pa": 3250.0}, {"sigma_s_Pa": 5000.0, "prorated_Pa": 4500.0}]
        locus = {"sigma_p_Pa": 10000.0, "tau_p_Pa": 7200.0, "c_Pa": 1375.0, "phi_lin_deg": 32.0, "points": points,
                 "flow": "free-flowing"}
        complete = pages.COMPLETE % ("Ring", "2500") + "ring_shear:\n  seeds: 1\n"
        for name in ("laboratory", "other"):
            pages.write(self.path(name), summary__json={"title": "Ring", "locus": {"loci": [locus]}},
                        **{"case_HYPHEN_complete__yaml": complete})
        with open(self.path("lab.csv"), "w") as file:
            file.write(pages.LAB)
        self.made("compare", "laboratory", "other")
        curves = self.page("compare.html").figures["yield-locus"]["curves"]
        self.assertEqual([curve["style"] for curve in curves], ["line", "points", "points"] * 2)
        self.made("compare", "laboratory", "other", "--lab", "lab.csv")
        with_lab = self.page("compare.html").figures["yield-locus"]["curves"]
        self.assertEqual(with_lab[:6], curves)
        self.assertEqual([curve["style"] for curve in with_lab[6:9]], ["dashed", "hollow", "hollow"])


if __name__ == "__main__":
    clod.unittest.main()
