"""The page in a browser: its scripts run without an error and draw; it fits a phone.

Skipped where there is no browser, or clod was built without the scripts of its pages.
"""

import json
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "calibrate"))
import bounce
import pages
from browser import BrowserCase
from pages import clod

# on their way down, for ten steps
MANY = """title: A hundred thousand grains
materials: {ore: {density: 2500 kg/m3}, steel: {}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}}
time: {step: 1e-6 s}
grains:
  - {material: ore, count: 100000, radius: {distribution: uniform, min: 0.99 mm, max: 1.01 mm}, region: {box: {min: [0 mm, 0 mm, 2 mm], max: [150 mm, 150 mm, 152 mm]}}}
walls: {floor: {material: steel, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}}
stages: [{name: fall, duration: 1e-5 s}]
output: {snapshot_interval: 1e-5 s}
"""
# of each figure that is drawn: its box, and those of titles, labels and legend in it; left, top, right, bottom
BOXES = """
  const box = place => { const at = place.getBoundingClientRect(); return [at.left, at.top, at.right, at.bottom]; };
  const boxes = (live, what) => [...live.querySelectorAll(what)].filter(place => place.textContent !== "").map(box);
  return [...document.querySelectorAll("figure .live")].filter(live => live.querySelector(".main-svg")).map(live => ({
    name: live.parentElement.id, whole: box(live.querySelector(".main-svg")),
    x: boxes(live, ".xtitle"), y: boxes(live, ".ytitle"), bar: boxes(live, ".cbtitle text"), tools: [...live.querySelectorAll(".modebar-group")].map(box),
    labels: boxes(live, ".xtick text, .ytick text, .cbaxis text"), legend: boxes(live, ".legendtext"), maps: [...live.querySelectorAll(".hm image")].map(box),
  }));
"""
HEIGHT = {1280: 2600, 390: 1300}
# texts of cards that are wider than their place, how many cards there are, and how many of them stand beside others
CARDS = """
  const wide = place => place.scrollWidth > place.clientWidth;
  const cards = [...document.querySelectorAll(".card")];
  return {count: cards.length, wide: cards.filter(card => wide(card) || wide(card.querySelector("b"))).map(card => card.textContent),
    across: cards.length - new Set(cards.map(card => card.getBoundingClientRect().top)).size};
"""


class Browser(BrowserCase):

    @classmethod
    def setUpClass(cls):
        """One page of each kind, in a folder that outlives the tests, and what a browser showed of it."""
        super().setUpClass()
        cls.shared = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, cls.shared)
        cls.names = pages.every(cls.shared)
        cls.kept = {}
        cls.asked = clod.run("report", os.path.join(cls.shared, "free"))

    def look(self, name, width):
        """show() of a shared page on a desk or a phone, high enough for every figure; once for all tests. `tried` has the boxes."""
        self.need_scripts(self.asked)
        if (name, width) not in self.kept:
            self.kept[name, width] = self.show(os.path.join(self.shared, name), width, HEIGHT[width], BOXES)
        return self.kept[name, width]

    def unfolded(self, name, folder=None):
        """Figures that are not folded away, and the names of their curves, as the file has them."""
        page = pages.load(os.path.join(folder or self.folder, name))
        open_parts = re.sub(r"<details.*?</details>", "", page.text, flags=re.S)
        return {figure: [curve["name"] for curve in page.figures[figure]["curves"] if curve["name"]]
                for figure in re.findall(r'<figure [^>]*id="figure-([^"]*)"', open_parts)}

    def assert_drawn(self, seen, dom, legends):
        """Plotly has drawn these figures, with these legends, and no other."""
        self.assertEqual(seen["figures"], str(len(legends)))
        drawn = [name for name in re.findall(r'<figure [^>]*id="figure-([^"]*)"', dom)
                 if "main-svg" in pages.Drawn(dom, name).live]
        self.assertEqual(sorted(drawn), sorted(legends))
        for name, legend in legends.items():
            self.assertEqual(pages.Drawn(dom, name).legend, legend, name)

    def test_free_run_with_grains(self):
        done = clod.run("run", clod.source("tests/restart/box.yaml"), "-o", self.path("box"),
                        *pages.SHORT)
        self.assertEqual(done.returncode, 0, done.stderr)
        made = clod.run("report", self.path("box"))
        self.need_scripts(made)
        with open(self.path("box/summary.json")) as file:
            summary = json.load(file)
        seen, dom = self.show("box/report.html")
        self.assert_drawn(seen, dom, self.unfolded("box/report.html"))
        view, = json.loads(seen["views"])
        self.assertEqual(view["grains"], summary["grains"])
        self.assertGreater(view["coverage"], 0.05)  # of the canvas
        self.assertGreater(view["colours"], 50)     # spheres have shades

    def test_numbers_and_width(self):
        for width in HEIGHT:
            seen, dom = self.look("uniaxial/report.html", width)
            self.assert_drawn(seen, dom, {
                "flow-function": ["simulation", "ffc = 1", "ffc = 2", "ffc = 4", "ffc = 10"],
                "axial-stress": ["stress-1"], "bulk-density": ["stress-1"]})
            self.assert_places(dom)
        pages.free_run(self.path("one"))
        pages.free_run(self.path("two"), density="2600")
        clod.run("compare", self.path("one"), self.path("two"), "-o", self.path("both.html"))
        seen, dom = self.show("both.html", 390)
        names = ["one", "two"]
        self.assert_drawn(seen, dom, {"kinetic-energy": names, "gauge-head-mass-flow": names, "feed-power": names})

    def test_long_names_on_a_phone(self):
        """Names that are wider than the page are told apart by their ends."""
        pages.free_run(self.path("run"))
        names = ["ä" * 120 + str(k) for k in range(2)]
        rows = "".join(f"{k},{k},{2 * k}\n" for k in range(1, 9))
        heads = ",".join(f"surface_liner.{name}.force_z [N]" for name in names)
        pages.write(self.path("run"), series__csv=f"time [s],{heads}\n{rows}")
        self.need_scripts(clod.run("report", self.path("run")))
        seen, dom = self.show("run/report.html", 390)
        legend = pages.Drawn(dom, "force-z").legend
        self.assertEqual([text[-1] for text in legend], ["0", "1"])
        self.assertLess(6.6 * max(map(len, legend)), 390 - 56)  # an ä of Helvetica has 0.556 of its 12 pixels; the line before it
        self.assertEqual(self.unfolded("run/report.html")["force-z"], [f"surface liner.{name}" for name in names])

    def assert_titles(self, figure, where, desk):
        """Titles of the axes and of the colour bar are whole in the figure's box, and on no label, no map and no name of a legend;
        on a desk they are clear of the tools."""
        left, top, right, bottom = figure["whole"]
        self.assertEqual((len(figure["x"]), len(figure["y"]), len(figure["bar"])), (1, 1, len(figure["maps"])), where)
        for title in figure["x"] + figure["y"] + figure["bar"]:
            self.assertTrue(left <= title[0] and top <= title[1] and title[2] <= right and title[3] <= bottom,
                            f"{where}: {title} is not in {figure['whole']}")
            for other in figure["labels"] + figure["legend"] + figure["maps"] + (figure["tools"] if desk else []):
                self.assertTrue(title[2] <= other[0] or other[2] <= title[0] or title[3] <= other[1]
                                or other[3] <= title[1], f"{where}: {title} is on {other}")

    def test_titles_of_axes(self):
        """On every kind of page."""
        found = 0
        for name in self.names:
            shown = [(where, *self.look(name, where)) for where in HEIGHT]
            if name == self.names[0]:
                shown += [(where, *self.show(os.path.join(self.shared, name), *where, BOXES)) for where in ((1200, 900), (390, 700))]
            for where, seen, _ in shown:
                for figure in json.loads(seen["tried"]):
                    found += 1
                    self.assert_titles(figure, f"{name} {figure['name']} {where}", where not in (390, (390, 700)))
        self.assertGreater(found, 60)

    def test_titles_of_colour_bars(self):
        """Of a map that is too flat for its longest title, and of one that is as high as wide, on desks and a phone."""
        flat = "fields.bed.region={box: {min: [-4 mm, 0 mm, 0 mm], max: [36 mm, 36 mm, 12 mm]}}"
        pages.field_run(self.path("flat"), "--set", flat)
        self.need_scripts(clod.run("report", self.path("flat")))
        for name in (self.path("flat"), os.path.join(self.shared, "field")):
            for width in (1280, 1000, 390):
                seen, _ = self.show(f"{name}/report.html", width, 2600, BOXES)
                maps = [figure for figure in json.loads(seen["tried"]) if figure["maps"]]
                self.assertEqual(len(maps), 4)
                for figure in maps:
                    self.assert_titles(figure, f"{name} {figure['name']} {width}", width > 1000)

    def test_tables_are_whole(self):
        """No table of any page hides a column: at 1280 pixels all have rows and columns, on a phone they may be stacked."""
        shared = lambda *names: [os.path.join(self.shared, name) for name in names]
        for name in ("packing0", "packing1"):  # few runs: columns
            pages.wall(self.path(f"wall-{name}"))
        for name in ("uniaxial", "free"):
            shutil.copytree(os.path.join(self.shared, name), self.path(name))
        clod.run("compare", *shared("packing0", "packing1", "packing2"), "-o", self.path("few.html"))
        clod.run("compare", *shared("uniaxial"), self.path("uniaxial"), "-o", self.path("strengths.html"))
        clod.run("compare", *map(self.path, ("wall-packing0", "wall-packing1")), "-o", self.path("walls.html"))
        clod.run("compare", *shared("free"), self.path("free"), "-o", self.path("frees.html"))
        with open(self.path("lab.csv"), "w") as file:
            file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
                       "10,7.2,3,3.25,1650\n10,7.2,5,4.61,1650\n10,7.2,7.5,5.75,1650\n")
        clod.run("report", *shared("ring"), "--lab", self.path("lab.csv"), "-o", self.path("lab.html"))
        pages.shear(self.path("jenike"), key="jenike")
        clod.run("report", self.path("jenike"), "-o", self.path("jenike.html"))
        for name in [*self.names, "few.html", "strengths.html", "walls.html", "frees.html", "lab.html", "jenike.html"]:
            for width in HEIGHT:
                seen, _ = self.look(name, width) if name in self.names else self.show(name, width)
                self.assertEqual(json.loads(seen["hidden"]), [], f"{name} at {width}")
                if width == 1280:
                    self.assertEqual(seen["stacked"], "0", name)

    def test_cards_are_whole(self):
        """No number, and no name, is wider than its card, on desks and phones: long ones wrap."""
        value = lambda number, error: {"value": number, "error": error, "scatter": None}
        long = {"phi_e_deg": value(123.4567, 10.123), "phi_lin_deg": value(23.8217, 0.8213), "c_Pa": value(273.4e3, 31.25), "sigma_c_Pa": value(-1234567.8, 125.0),
                "ffc": value(1234.567, 0.123), "rho_inside_kg_m3": value(12345.678, 1.25)}
        shutil.copytree(os.path.join(self.shared, "ring"), self.path("ring"))
        summary = pages.load_json(self.path("ring/summary.json"))
        summary["locus"]["loci"][0].update(long)
        pages.write(self.path("ring"), summary__json=summary)
        found, name = 0, "a_gauge_at_the_lip_of_the_chute_" * 3
        gauges = {name: {"mass_flow_kg_per_s": {"mean": -12345.678901, "deviation": 1.25}, "flow_through_kg_per_s": {"mean": 1.2345e-7, "deviation": 1.25e-12}}}
        pages.free_run(self.path("free"), gauges=gauges, kinetic_energy_J=-1.2345e-100, grains=123456789012)
        clod.run("report", *map(self.path, ("ring", "free")))
        for page in [self.path("ring/report.html"), self.path("free/report.html"), *(os.path.join(self.shared, name) for name in self.names)]:
            text = clod.read(page).decode()
            style, cards = re.search(r"<style>.*?</style>", text, re.S), re.search(r'<div class="cards">.*?</div>\n</div>', text, re.S)
            if cards is None:
                continue
            with open(self.path("cards.html"), "w") as file:  # no figures that take their time
                file.write(f"<!DOCTYPE html><meta charset=\"utf-8\">{style[0]}<main>{cards[0]}</main><script>document.documentElement.dataset.errors = 1</script>")
            for width in (360, 768, 1024, 1280, 1440):
                self.browser.open(self.path("cards.html"), width, 900)
                tried = self.browser.value("(() => {%s})()" % CARDS)
                self.assertEqual(tried["wide"], [], f"{page} at {width}")
                found += 1
                if page.startswith(self.folder):
                    self.assertGreater(tried["count"], 4)
                    self.assertGreater(tried["across"], 1)  # they still stand side by side
        self.assertGreaterEqual(found, 35)

    def assert_places(self, dom):
        """The strength, and both ends of the stress, stand where the labels of the axes say.

        Plotly rounds places to hundredths of a pixel: two points and two labels are off by 0.025 at most.
        """
        flow = pages.Drawn(dom, "flow-function")
        (x, y), = flow.marks()
        origin = flow.lines()[0][0]  # of the line ffc = 1
        self.assertAlmostEqual(x, origin[0] + 10.0766 * flow.pixels("x"), delta=0.03)
        self.assertAlmostEqual(y, origin[1] + 11.67746 * flow.pixels("y"), delta=0.03)
        stress = pages.Drawn(dom, "axial-stress")
        (first, last), = stress.lines()  # from 0 % and 0 kPa to 0.9 % and 9.0045 kPa
        self.assertAlmostEqual(last[0] - first[0], 0.9 * stress.pixels("x"), delta=0.03)
        self.assertAlmostEqual(last[1] - first[1], 9.0045 * stress.pixels("y"), delta=0.03)

    def test_ring_shear(self):
        """A real test: all figures are drawn, the yield locus at equal scale with its points in their places."""
        done = clod.run("run", clod.source("tests/restart/ring.yaml"), "-o", self.path("ring"), "-t", "1", page=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.need_scripts(clod.run("report", self.path("ring")))
        with open(self.path("ring/summary.json")) as file:
            points = json.load(file)["locus"]["loci"][0]["points"]
        for width in (1200, 390):
            seen, dom = self.show("ring/report.html", width)
            self.assert_drawn(seen, dom, self.unfolded("ring/report.html"))
            locus = pages.Drawn(dom, "yield-locus")
            across, up = locus.pixels("x"), -locus.pixels("y")  # of a kPa
            self.assertAlmostEqual(across / up, 1.0, delta=0.01)
            (x, y), (first, last) = locus.marks()[0], (points[0], points[-1])
            right, top = locus.marks()[len(points) - 1]
            self.assertAlmostEqual((right - x) / across, 1e-3 * (last["sigma_s_Pa"] - first["sigma_s_Pa"]), delta=0.1 / across)
            self.assertAlmostEqual((y - top) / up, 1e-3 * (last["prorated_Pa"] - first["prorated_Pa"]), delta=0.1 / up)

    def test_wall_friction(self):
        seen, dom = self.look("wall/report.html", 390)
        self.assert_drawn(seen, dom, self.unfolded("wall/report.html", self.shared))

    def test_slices_of_a_field(self):
        """Maps have the colours of their numbers, blank cells none, at equal scale; on a phone the bar is above."""
        figures = pages.load(os.path.join(self.shared, "field/report.html")).figures
        for width in HEIGHT:
            seen, dom = self.look("field/report.html", width)
            self.assert_drawn(seen, dom, self.unfolded("field/report.html", self.shared))
            for name, title in (("density", "bulk density [kg/m3]"), ("pressure", "pressure, contact + kinetic [Pa]"),
                                ("speed", "speed [m/s]"), ("coordination", "contacts of a grain")):
                drawn = pages.Drawn(dom, f"field-bed-{name}")
                self.assertAlmostEqual(-drawn.pixels("x") / drawn.pixels("y"), 1.0, delta=0.02)
                self.assertIn(title, drawn.texts('<text class="[^"]*title"'))
                self.assert_colours(drawn.map(), figures[f"field-bed-{name}"]["map"])

    def test_slices_of_two_runs(self):
        """Side by side on a desk, below each other on a phone; the colours of both are those of one range."""
        pages.field_run(self.path("slow"))
        pages.field_run(self.path("heavy"), "--set", "materials.ore.density=5000 kg/m3")
        self.need_scripts(clod.run("report", self.path("slow")))
        done = clod.run("compare", self.path("slow"), self.path("heavy"), "-o", self.path("both.html"))
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = pages.load(self.path("both.html")).figures
        for width in (1200, 390):
            seen, dom = self.show("both.html", width)
            self.assert_drawn(seen, dom, self.unfolded("both.html"))
            for name in ("density", "pressure", "speed", "coordination"):
                maps = [figures[f"field-bed-{name}-{run}"]["map"] for run in ("slow", "heavy")]
                self.assertEqual(maps[0]["range"], maps[1]["range"])
                for run, given in zip(("slow", "heavy"), maps):
                    self.assert_colours(pages.Drawn(dom, f"field-bed-{name}-{run}").map(), given)
            densest = [max(float(x) for x in figures[f"field-bed-density-{run}"]["map"]["numbers"] if x) for run in ("slow", "heavy")]
            self.assertGreater(densest[1], 1.8 * densest[0])  # twice as dense a material

    def assert_colours(self, pixels, given):
        colours = [[int(colour[k:k + 2], 16) for k in (1, 3, 5)] for colour in given["colours"]]
        low, high = map(float, given["range"])
        self.assertEqual((len(pixels[0]), len(pixels)), (int(given["columns"]), int(given["rows"])))
        blank = 0
        for k, number in enumerate(given["numbers"]):
            pixel = pixels[k // len(pixels[0])][k % len(pixels[0])]
            if number is None:
                self.assertEqual(pixel[3], 0)
                blank += 1
                continue
            at = (float(number) - low) / (high - low) * (len(colours) - 1)
            below = min(int(at), len(colours) - 2)
            wanted = [a + (at - below) * (b - a) for a, b in zip(*colours[below:below + 2])]
            self.assertLess(max(abs(a - b) for a, b in zip(pixel, wanted)), 1.5)
            self.assertEqual(pixel[3], 255)
        self.assertTrue(0 < blank < len(given["numbers"]) / 2)

    def test_hopper(self):
        """The page of a design, on a desk and on a phone; the critical state stands on the line of its flow factor."""
        for width in HEIGHT:
            seen, dom = self.look("design.html", width)
            self.assert_drawn(seen, dom, self.unfolded("design.html", self.shared))
            chart = pages.Drawn(dom, "design-chart")
            with open(os.path.join(self.shared, "design.json")) as file:
                cone = json.load(file)["cone"]
            origin = chart.lines()[2][0]  # of the cone's flow factor: flow function and bars are before it
            wanted = (origin[0] + 1e-3 * cone["sigma_1_Pa"]["value"] * chart.pixels("x"),
                      origin[1] + 1e-3 * cone["strength_Pa"]["value"] * chart.pixels("y"))
            off = min(max(abs(x - wanted[0]), abs(y - wanted[1])) for x, y in chart.marks())
            self.assertLess(off, 0.1)  # of a pixel

    def test_calibration(self):
        """The page of a calibration that is run here: targets, posterior and what was foretold."""
        shutil.copy(bounce.CASE, self.folder)
        with open(self.path("plan.yaml"), "w") as file:
            file.write(bounce.PLAN)
        done = clod.run("calibrate", "plan.yaml", "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.need_scripts(clod.run("report", self.path("out")))
        seen, dom = self.show("out/report.html")
        self.assert_drawn(seen, dom, self.unfolded("out/report.html"))

    def test_a_hundred_thousand_grains(self):
        """The view has all of them, and the scripts draw them."""
        with open(self.path("many.yaml"), "w") as file:
            file.write(MANY)
        done = clod.run("run", self.path("many.yaml"), "-o", self.path("many"), page=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.need_scripts(clod.run("report", self.path("many")))
        seen, _ = self.show("many/report.html")
        view, = json.loads(seen["views"])
        self.assertEqual(view["grains"], 100000)
        self.assertGreater(view["coverage"], 0.05)
        self.assertGreater(view["colours"], 50)

    def test_names_are_no_markup(self):
        """Folders, and units of columns, that plotly and a browser would read as markup."""
        names = ["a <b> & &lt; <i>", "two<br>lines & <sub>"]
        for name in names:
            pages.free_run(self.path(name))
            series = pages.SERIES.replace("kinetic_energy [J]", "kinetic_energy [<b>&lt;J]")
            pages.write(self.path(name), series__csv=series)
        done = clod.run("compare", *map(self.path, names), "-o", self.path("both.html"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.need_scripts(clod.run("report", self.path(names[0])))
        seen, dom = self.show("both.html")
        self.assert_drawn(seen, dom, {"kinetic-energy": names, "gauge-head-mass-flow": names, "feed-power": names})
        self.assertEqual(pages.Drawn(dom, "kinetic-energy").titles, ["time [s]", "kinetic energy [<b>&lt;J]"])


if __name__ == "__main__":
    clod.unittest.main()
