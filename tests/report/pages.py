"""Results folders made by hand, and what stands in a page, for the tests of this folder."""

import base64
import html
import html.parser
import json
import os
import re
import struct
import sys
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

# tests/restart/box.yaml in a fraction of a second
SHORT = [word for key, value in (("stages.0.duration", "10 ms"), ("stages.1.duration", "10 ms"),
                                 ("stages.2.duration", "10 ms"), ("output.snapshot_interval", "5 ms"))
         for word in ("--set", f"{key}={value}")]

# shear points of a laboratory at 10 kPa
LAB = ("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
       "10,7.2,3,3.25,1650\n10,7.2,5,4.5,1650\n10,7.2,7.5,5.75,1650\n")

COMPLETE = "# clod\ntitle: \"%s\"\nmaterials:\n  ore:\n    density: %s kg/m3\n"

FREE = {
    "title": "A <chute> & more", "version": "clod 9", "time_s": 2.5, "dt_s": 1e-5, "steps": 250000,
    "grains": 120, "contacts": 300, "coordination": 5.0, "max_overlap": 0.0125, "kinetic_energy_J": 0.5,
    "wall_clock_s": 61.5,
    "outlets": {"delivered": {"grains": 166083, "mass_kg": 0.12345678, "kinetic_energy_J": 0.0}},
    "left": {"x_min": {"grains": 0, "mass_kg": 0.0}, "x_max": {"grains": 0, "mass_kg": 0.0}},
    "gauges": {"head": {"mass_flow_kg_per_s": {"mean": 0.8343702206, "deviation": 0.0204139}, "alarms": 2,
                        "blocked_at_end": True}},
    "residence": {"mean_s": 1.6437, "classes": []},
}
def text(number):
    """A number as clod prints it: with as few digits as read back exactly."""
    return repr(float(number)).removesuffix(".0")


SERIES = "time [s],kinetic_energy [J],gauge_head.mass_flow [kg/s],feed.power [W],feed.angle [rad]\n" + "".join(
    f"{text(0.1 * k)},{text(0.01 * k * k)},{'nan' if k < 3 else text(0.5 + 0.001 * k)},{-k},0\n" for k in range(26))

# grains fall on a floor; the region of the grid is wider than the bed
FIELD = """title: A bed
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 2e3 N/m, restitution: 0.1, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {design_stress: 500 Pa}
domain: {min: [-10 mm, 0 mm, -12 mm], max: [40 mm, 36 mm, 200 mm], periodic: [false, true, false]}
grains: [{material: ore, count: 150, radius: {distribution: uniform, min: 2.7 mm, max: 3.3 mm}, region: {box: {min: [3 mm, 0 mm, 3 mm], max: [33 mm, 36 mm, 60 mm]}}}]
walls: {base: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}}
fields: {bed: {region: {box: {min: [-4 mm, 0 mm, -12 mm], max: [36 mm, 36 mm, 52 mm]}}, cell: 4 mm, width: 8 mm}}
stages: [{name: fall, duration: 60 ms}]
output: {series_interval: 20 ms}
"""

UNIAXIAL = {
    "title": "Two stresses", "version": "clod 9",
    "parts": [{"part": "fill", "seed": 4, "grains": 250, "dt_s": 1e-5, "steps": 1000, "wall_clock_s": 2.5},
              {"part": "stress-1", "seed": 4, "grains": 250, "dt_s": 1.25e-5, "steps": 5000, "wall_clock_s": 60.25}],
    "flow_function": [{"part": "stress-1", "errors_note": "one specimen: scatter between specimens not included",
                       "consolidation_stress_Pa": 10000.0, "sigma_1_Pa": 10076.6, "sigma_c_Pa": 11677.46,
                       "sigma_c_error_Pa": 59.87, "ffc": 0.862911}],
    "warnings": ["stress-1: only 7.2 grain diameters"],
}
STRESS = "time [s],strain [1],axial_stress [Pa],bulk_density [kg/m3]\n0,0,1,900\n0.1,0,9000,1000\n" + "".join(
    f"{text(0.2 + 0.1 * k)},{text(0.001 * k)},{text(1000.5 * k)},{1000 + k}\n" for k in range(10))


def value(value, error):
    return {"value": value, "error": error, "scatter": None}


WALL = {
    "title": "On a liner", "version": "clod 9", "parts": [{"part": "fill", "seed": 4, "grains": 250}, {"part": "wall"}],
    "wall_locus": {
        "phi_w_deg": value(18.25, 0.13), "tau_ad_Pa": value(62.5, 31.25), "r_squared": 0.9987, "errors_from": "fit",
        "errors_note": "one specimen: scatter between specimens not included", "seed_count": 1, "warnings": [],
        "points": [{"seed": 4, "sigma_w_Pa": 10001.5, "sigma_w_error_Pa": 3.5, "tau_w_Pa": 3361.25,
                    "tau_w_error_Pa": 12.5, "phi_x_deg": 18.576, "phi_x_error_deg": 0.065, "line_Pa": 3360.0},
                   {"seed": 4, "sigma_w_Pa": 5000.25, "sigma_w_error_Pa": 1.5, "tau_w_Pa": 1711.75,
                    "tau_w_error_Pa": 6.25, "phi_x_deg": 18.898, "phi_x_error_deg": 0.065, "line_Pa": 1711.0}]},
    "warnings": ["wall: inertial number 0.0031"],
}
SLIP = ("time [s],displacement [m],normal_stress [Pa],shear_stress [Pa],height [m],bulk_density [kg/m3]\n"
        "0,0,1,0,0.03,900\n0.1,0,9000,10,0.025,1000\n" + "".join(
            f"{text(0.2 + 0.1 * k)},{text(0.001 * k)},{text(1000.5 * k)},{text(300.25 * k)},{text(0.025)},{1000 + k}\n"
            for k in range(10)))


def write(folder, **files):
    """Write files, given by name with __ for points; objects as JSON."""
    os.makedirs(folder, exist_ok=True)
    for name, content in files.items():
        with open(os.path.join(folder, name.replace("__", ".").replace("_HYPHEN_", "-")), "w") as file:
            file.write(content if isinstance(content, str) else json.dumps(content, indent=2))


def free_run(folder, density="2500", **changes):
    """A folder as a free run leaves it, with no snapshots."""
    summary = {**FREE, **changes}
    write(folder, summary__json=summary, series__csv=SERIES, report__txt="all of it\n", case__yaml="title: short\n",
          **{"case_HYPHEN_complete__yaml": COMPLETE % (summary["title"], density)})


def field_run(folder, *more):
    """A real run of a fraction of a second, with the grid of a field."""
    write(folder + "-case", case__yaml=FIELD)
    done = clod.run("run", os.path.join(folder + "-case", "case.yaml"), "-o", folder, "-t", "1", *more)
    clod.unittest.TestCase().assertEqual(done.returncode, 0, done.stderr)


def uniaxial(folder):
    write(folder, summary__json=UNIAXIAL, report__txt="all of it\n", fill__csv=STRESS,
          **{"stress_HYPHEN_1__csv": STRESS,
             "case_HYPHEN_complete__yaml": COMPLETE % (UNIAXIAL["title"], "2500") + "uniaxial:\n  seeds: 1\n"})


def wall(folder, **changes):
    write(folder, summary__json={**WALL, **changes}, report__txt="all of it\n", wall__csv=SLIP,
          **{"case_HYPHEN_complete__yaml": COMPLETE % (WALL["title"], "2500") + "wall_friction:\n  seeds: 1\n"})


FEW = ("--set", "interval.samples=100")  # samples of a hopper's design


def hopper(folder, *more):
    """The template's design, or that of another case in the folder, with fewer samples: design.html and design.json."""
    if not os.path.exists(os.path.join(folder, "hopper.yaml")):
        clod.unittest.TestCase().assertEqual(clod.run("new", "hopper", cwd=folder).returncode, 0)
    case = [] if more and more[0].endswith(".yaml") else ["hopper.yaml"]
    done = clod.run("hopper", *case, *more, *FEW, "-o", "design", cwd=folder)
    clod.unittest.TestCase().assertEqual(done.returncode, 0, done.stderr)
    return done


def titled(text):
    """Rows of the tables of a page, by the first cell of the head: (title or None, text) of each cell."""
    tables = {}
    for table in re.findall(r"<table.*?</table>", text, re.S):
        rows = [[(title or None, html.unescape(cell)) for title, cell in
                 re.findall(r'<t[hd](?: title="([^"]*)")?>(.*?)</t[hd]>', row, re.S)]
                for row in re.findall(r"<tr>.*?</tr>", table, re.S)]
        tables[rows[0][0][1]] = rows
    return tables


def cards(text):
    """(title or None, number, unit, caption) of the cards of a page."""
    found = re.findall(r'<div class="card"><b(?: title="([^"]*)")?>([^<]*)(?: <small>([^<]*)</small>)?</b><span>(.*?)</span>', text)
    return [(title or None, number.strip(), unit, html.unescape(caption)) for title, number, unit, caption in found]


LOCUS = {"sigma_p_Pa": 10000.0, "tau_p_Pa": 7200.0, "c_Pa": 1375.0, "phi_lin_deg": 32.0, "flow": "cohesive",
         "sigma_1_Pa": 21000.0, "sigma_c_Pa": {"value": 7100.0, "error": 90.0}, "steady_circle": {"centre_Pa": 14000.0, "radius_Pa": 7000.0},
         "points": [{"sigma_s_Pa": 3000.0, "prorated_Pa": 3250.0}, {"sigma_s_Pa": 5000.0, "prorated_Pa": 4500.0}]}
RUNS = "point,a [N/m^1.5],b [J],ring: phi_e [deg],ring: phi_sf [deg],ring: sigma_c [kPa]\n" + "".join(
    f"{k},{text(0.1 * k)},{text(1e-3 - 1e-4 * k)},{text(30 + k)},{text(28 + k)},{text(5 + k)}\n" for k in range(8))


def shear(folder, shift=0.0, key="ring_shear"):
    """A ring shear test, or a Jenike test; `shift` [Pa] moves its points."""
    locus = {**LOCUS, "tau_p_Pa": LOCUS["tau_p_Pa"] + shift, "c_Pa": LOCUS["c_Pa"] + shift,
             "points": [{**point, "prorated_Pa": point["prorated_Pa"] + shift} for point in LOCUS["points"]]}
    write(folder, summary__json={"title": "Ring", "version": "clod 9", "locus": {"loci": [locus]}}, report__txt="all of it\n",
          preshear__csv=SLIP,
          **{"case_HYPHEN_complete__yaml": COMPLETE % ("Ring", "2500") + f"{key}:\n  seeds: 1\n"})


def calibration(folder):
    """A finished calibration of two parameters and three targets, one of them held back. The posterior of a is even from 0.4 to 0.65."""
    about = {"mean": 0.523456, "card": 0.534567, "low": 0.412345, "high": 0.634567, "unit": "N/m^1.5", "from": 0.0, "to": 1.0, "scale": "linear",
             "relative_width": 0.22, "identified": "yes", "rhat": 1.0012, "effective_samples": 812.3}
    steep = {**about, "mean": 3e-4, "card": 3e-4, "low": 2.2e-4, "high": 3.8e-4, "unit": "J", "from": 1e-4, "to": 1e-3, "scale": "log"}
    at, small = [0.1 * k for k in range(11)], [1e-4 * (k + 1) for k in range(10)]
    sections = {"a": {"at": at, "mean": [30 + 7 * x for x in at], "deviation": [0.5] * 11},
                "b": {"at": small, "mean": [30 + 7e3 * x for x in small], "deviation": [0.5] * 10}}
    target = {"name": "ring: phi_e", "measured": 33.5, "error": 0.6, "discrepancy": 0.5, "model": 33.6, "card": 33.7, "low": 32.5, "high": 34.7,
              "unit": "deg", "off": 0.1, "held_back": False,
              "surrogate": {"kind": "gaussian process", "runs": 8, "packing_deviation": 0.4, "least_packing_deviation": 0.25,
                            "greatest_packing_deviation": 0.625, "left_out_error": 0.51, "q2": 0.93, "within_two_deviations": 0.95,
                            "sections": sections}}
    kept = {**target, "name": "ring: phi_sf", "measured": 30.25, "model": 29.5, "low": 28.0, "high": 31.0, "held_back": True}
    other = {**target, "name": "ring: sigma_c", "unit": "kPa", "measured": 7.5, "error": 0.25, "model": 7.25, "card": 7.5, "low": 6.5, "high": 8.0}
    write(folder, calibration__json={"version": "clod 10 (def)", "written": "2001-02-03T04:05:06.789Z",
                                     "title": "Two stiffnesses", "level": 0.9, "p_value": 0.4, "chi_square": 1.3, "warnings": ["none"],
                                     "plan": "plan.yaml", "points": 8, "packings": 1, "failed_runs": 0,
                                     "parameters": {"a": about, "b": steep}, "targets": [target, kept, other]}, runs__csv=RUNS,
          design__txt="Runs of a calibration: another plan needs another folder.\nclod clod 9 (abc)\nseed 1, seeds 1\n",
          posterior__csv="a [N/m^1.5],b [J]\n" + "".join(
              f"{text(0.4 + 0.25 * (k + 0.5) / 1200)},{text(2e-4 * 2 ** ((37 * k % 1200 + 0.5) / 1200))}\n" for k in range(1200)))


class PageCase(clod.Case):
    """A test of pages in a folder of its own."""

    def made(self, *arguments, code=0, page=False):
        done = clod.run(*arguments, cwd=self.folder, page=page)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def page(self, name):
        return load(self.path(name))

    def assert_curve(self, figure, number, table, x, y, first=0):
        """The curve has the texts of these columns from row `first` on; nan is null."""
        curve = figure["curves"][number]
        self.assertEqual(curve["x"], table[x][first:])
        self.assertEqual(curve["y"], [None if text == "nan" else text for text in table[y][first:]])


def every(folder):
    """One page of each kind, made by hand but for the design of a hopper and a field; names of their files in the folder."""
    at = lambda name: os.path.join(folder, name)
    free_run(at("free"), outlets={f"lip{k}": FREE["outlets"]["delivered"] for k in range(12)})
    uniaxial(at("uniaxial"))
    wall(at("wall"))
    shear(at("ring"))
    calibration(at("fit"))
    field_run(at("field"))
    made = [clod.run("report", *map(at, ("free", "uniaxial", "wall", "ring", "fit", "field")))]
    for k in range(9):  # more than there are colours
        shear(at(f"packing{k}"), 100.0 * k)
    made.append(clod.run("compare", *(at(f"packing{k}") for k in range(9)), "-o", at("packings.html")))
    for done in made:
        clod.unittest.TestCase().assertEqual(done.returncode, 0, done.stderr)
    hopper(folder)
    return [f"{name}/report.html" for name in ("free", "uniaxial", "wall", "ring", "fit", "field")] + ["packings.html", "design.html"]


class Page(html.parser.HTMLParser):
    """The tables, list items and texts of a page, and the numbers behind its figures.

    Numbers of the data block stay the texts that they are.
    """

    def __init__(self, text):
        super().__init__()
        self.text = text
        self.tables, self.items, self.words = [], [], []
        self.inside = []
        self.cell = None
        self.feed(text)
        block = re.search(r'<script type="application/json" id="clod-data">(.*?)</script>', text, re.S)[1]
        data = json.loads(block, parse_float=str, parse_int=str)
        self.figures = {figure["name"]: figure for figure in data["figures"]}
        self.views = data["views"]

    def handle_starttag(self, tag, attributes):
        self.inside.append(tag)
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            self.tables[-1][-1].append("")
        elif tag == "li":
            self.items.append("")

    def handle_endtag(self, tag):
        while self.inside and self.inside.pop() != tag:
            pass

    def handle_data(self, data):
        if "td" in self.inside or "th" in self.inside:
            self.tables[-1][-1][-1] += data
        elif "li" in self.inside:
            self.items[-1] += data
        if "script" not in self.inside and "style" not in self.inside:
            self.words.append(data)

    def row(self, name):
        """Cells of the first row of any table that begins with this."""
        return next(row for table in self.tables for row in table if row and row[0] == name)


class Drawn:
    """What plotly has drawn of a figure, from the document of a browser: nothing of the SVG before it."""

    def __init__(self, dom, name):
        figure = re.search(rf'<figure [^>]*id="figure-{re.escape(name)}".*?</figure>', dom, re.S)[0]
        self.live = figure[figure.index('<div class="live'):]
        self.legend = self.texts('<text class="legendtext"')
        self.titles = self.texts('<text class="xtitle"') + self.texts('<text class="ytitle"')

    def texts(self, start):
        """The texts as a reader sees them; elements within would stay markup."""
        found = re.findall(start + r'(?:"[^"]*"|[^">])*>(.*?)</text>', self.live, re.S)
        return [html.unescape(text) for text in found]

    def marks(self):
        """Places of the points in the plot."""
        found = re.findall(r'<path class="point"[^>]*transform="translate\(([-\d.]+),([-\d.]+)\)"', self.live)
        return [(float(x), float(y)) for x, y in found]

    def lines(self):
        """The first and the last place of each curve."""
        curves = re.findall(r'<g class="trace .*?</g></g>', self.live, re.S)
        paths = [re.search(r'class="js-line" d="M([^"]*)"', curve) for curve in curves]
        ends = [re.findall(r"[-\d.]+,[-\d.]+", path[1]) for path in paths if path]
        return [[tuple(map(float, places[k].split(","))) for k in (0, -1)] for places in ends]

    def map(self):
        """Red, green, blue and opacity of the cells of a map, rows upwards: the PNG that plotly lays below the curves."""
        data = re.search(r'<g class="hm"><image [^>]*href="data:image/png;base64,([^"]*)"', self.live)[1]
        return read_png(base64.b64decode(data))[::-1]

    def pixels(self, axis):
        """Pixels for one unit of an axis, from the labels of its first and its last tick."""
        ticks = re.findall(rf'<g class="{axis}tick"><text[^>]*translate\(([-\d.]+),([-\d.]+)\)[^>]*>([^<]*)</text>', self.live)
        first, last = ticks[0], ticks[-1]
        at = "xy".index(axis)
        number = [float(tick[2].replace("\u2212", "-")) for tick in (first, last)]
        return (float(last[at]) - float(first[at])) / (number[1] - number[0])


def read_png(data):
    """Rows from the top, of (r, g, b, a), of a PNG of four bytes a pixel. Filters: W3C, PNG Specification, 9.2."""
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            assert (depth, colour) == (8, 6)
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    raw, rows, above = zlib.decompress(packed), [], bytes(4 * width)
    for y in range(height):
        kind, *line = raw[y * (4 * width + 1):(y + 1) * (4 * width + 1)]
        for k in range(4 * width):
            left, up, corner = (line[k - 4], above[k], above[k - 4]) if k >= 4 else (0, above[k], 0)
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda value: abs(guess - value))
            line[k] = (line[k] + (0, left, up, (left + up) // 2, paeth)[kind]) % 256
        rows.append([tuple(line[4 * x:4 * x + 4]) for x in range(width)])
        above = line
    return rows


def load_json(path):
    with open(path) as file:
        return json.load(file)


def load(path):
    with open(path) as file:
        return Page(file.read())


def cells(folder, name):
    """Columns of a CSV file by name, as the texts that are there."""
    with open(os.path.join(folder, name)) as file:
        rows = [line.rstrip("\n").split(",") for line in file]
    return {head.split(" [")[0]: [row[k] for row in rows[1:]] for k, head in enumerate(rows[0])}
