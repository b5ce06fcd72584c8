"""Slices of fields on a page: the numbers that h5py reads of field_NAME.hdf, in figures and in the SVG."""

import json
import math
import os
import re
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "report"))
import pages  # noqa: E402
from pages import clod  # noqa: E402

try:
    import h5py
    import numpy
except ImportError:
    h5py = None

G = 9.81
CELLS, CORNER, CELL = (6, 5, 4), (-0.01, 0.02, 0.005), 0.005
COMPLETE = 'title: "By hand"\ngravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n'
VALUES = {"density": 1, "pressure": 1, "velocity": 3, "coordination": 1}


def write_field(path, cells, **columns):
    """A file as clod writes it, of cells (i, j, k) of the grid."""
    corner = numpy.array(CORNER) + CELL * numpy.array(cells)
    steps = CELL * numpy.array([[bits >> a & 1 for a in range(3)] for bits in range(8)])
    with h5py.File(path, "w") as file:
        file.attrs["time_s"] = 1.0
        group = file.create_group("VTKHDF")
        group["Points"] = (corner[:, None, :] + steps[None]).reshape(-1, 3)
        group["Types"] = numpy.full(len(cells), 11, dtype="u1")
        data = group.create_group("CellData")
        for name, column in columns.items():
            data[name] = numpy.array(column, dtype="f8")


def shades(svg):
    """Colour of each cell (column, row) of the map of an SVG."""
    found = {}
    for colour, inside in re.findall(r'<path fill="(#\w{6})" stroke="#\w{6}" d="([^"]*)"', svg):
        for x, y, count in re.findall(r"M(\d+) (\d+)h(\d+)v1h-\d+z", inside):
            found.update({(int(x) + k, int(y)): colour for k in range(int(count))})
    return found


def colour_at(colours, share):
    """Red, green and blue of a place on a colour map, straight between its colours."""
    at = share * (len(colours) - 1)
    below = min(int(at), len(colours) - 2)
    one, other = ([int(c[k:k + 2], 16) for k in (1, 3, 5)] for c in colours[below:below + 2])
    return [a + (at - below) * (b - a) for a, b in zip(one, other)]


@unittest.skipIf(h5py is None, "no h5py")
class Slices(clod.Case):

    def by_hand(self, complete=COMPLETE, scale=1.0, name="run", speed=1.0, **changes):
        """A folder with a field: pressure falls with height, x moves down and to the right, y faster; two holes."""
        grid = {"since_s": 0.5, "samples": 21, "cells": list(CELLS), "corner_m": list(CORNER), "used_cells": 118,
                "cell_m": CELL, "width_m": 0.012}
        grid.update(changes)
        fields = {"bed": grid, "zone": {"since_s": 0.5, "samples": 21, "volume_m3": 1.0}}
        pages.free_run(self.path(name), fields=fields, **{key: changes[key] for key in ("time_s", "dt_s") if key in changes})
        pages.write(self.path(name), **{"case_HYPHEN_complete__yaml": complete})
        self.cells = [(i, j, k) for k in range(4) for j in range(5) for i in range(6)
                      if (i, j, k) not in ((2, 2, 3), (0, 2, 0))]
        # other layers than j = 2 would be seen at once
        self.pressure = [scale * 1500 * G * (0.03 - (CORNER[2] + (k + 0.5) * CELL)) * (1 if j == 2 else 1e6) for i, j, k in self.cells]
        self.write_bed(f"{name}/field_bed.hdf", speed)

    def write_bed(self, file, speed=1.0):
        coordination = [math.nan if (i, k) == (5, 3) else 4 + 0.1 * i for i, j, k in self.cells]
        write_field(self.path(file), self.cells, density=[1500.0 - 10 * i for i, j, k in self.cells],
                    pressure=self.pressure, velocity=[(0.3 * speed, 5.0 * speed, -0.4 * speed)] * len(self.cells), coordination=coordination)

    def report(self, code=0):
        self.done = clod.run("report", "run", cwd=self.folder)
        self.assertEqual(self.done.returncode, code, self.done.stderr)
        return pages.load(self.path("run/report.html")) if code == 0 else None

    def test_a_gradient_by_hand(self):
        self.by_hand()
        page = self.report()
        figure = page.figures["field-bed-pressure"]
        self.assertEqual(list(page.figures)[-4:], [f"field-bed-{name}" for name in ("density", "pressure", "speed", "coordination")])
        self.assertNotIn("field-zone", page.text)
        self.assertIn("Plane y = 32.5 mm: layer 3 of 5 of the grid's cells across y; gravity lies in it. Mean of 21 samples "
                      "from 0.5 s on; cells of 5 mm, kernel of 12 mm. Blank: nothing reached the cell.", page.words)
        self.assertEqual((figure["x"]["text"], figure["y"]["text"], figure["x"]["unit"]), ("x", "z", "mm"))
        given = figure["map"]
        self.assertEqual((given["columns"], given["rows"]), ("6", "4"))
        self.assertEqual([float(x) for x in given["low"]], [-0.01, 0.005])
        self.assertEqual([float(x) for x in given["step"]], [0.005, 0.005])
        for k, number in enumerate(given["numbers"]):
            i, level = k % 6, k // 6
            if (i, level) in ((2, 3), (0, 0)):
                self.assertIsNone(number)
            else:
                wanted = 1500 * G * (0.025 - (level + 0.5) * 0.005)
                self.assertAlmostEqual(float(number), wanted, delta=1e-6 * wanted)
        self.assert_svg("pressure", given)
        speed = page.figures["field-bed-speed"]
        self.assertEqual({number for number in speed["map"]["numbers"] if number is not None}, {"5.024938"})  # 0.3, 5, -0.4
        self.assert_arrows(speed)
        last = page.figures["field-bed-coordination"]["map"]["numbers"]
        self.assertEqual([k for k, number in enumerate(last) if number is None], [0, 20, 23])  # no grain, but contacts: blank

    def assert_svg(self, name, given, file="run/report-field-bed-%s.svg"):
        """Each cell has the colour of its number, blank ones none."""
        found = shades(clod.read(self.path(file % name)).decode())
        low, high = map(float, given["range"])
        columns = int(given["columns"])
        for k, number in enumerate(given["numbers"]):
            colour = found.get((k % columns, k // columns))
            if number is None:
                self.assertIsNone(colour)
                continue
            wanted = colour_at(given["colours"], (float(number) - low) / (high - low))
            off = max(abs(int(colour[1 + 2 * c:3 + 2 * c], 16) - wanted[c]) for c in range(3))
            self.assertLess(off, 4)  # 128 shades

    def assert_arrows(self, figure, told="0.5", long=0.9):
        """One in each cell that has a velocity, 3 to the right and 4 down, 0.9 of a cell long, its middle in that of the cell."""
        curve, = figure["curves"]
        self.assertEqual(curve["name"], f"velocity in the plane, longest arrow {told} m/s")
        x, y = ([number and float(number) for number in curve[axis]] for axis in "xy")
        self.assertEqual(len(x), 6 * 22)
        for k in range(0, len(x), 6):
            self.assertAlmostEqual(x[k + 1] - x[k], long * 0.6 * CELL, delta=1e-12)
            self.assertAlmostEqual(y[k + 1] - y[k], -long * 0.8 * CELL, delta=1e-12)
            self.assertIsNone(x[k + 5])
            middle = (x[k] + x[k + 1]) / 2 - CORNER[0], (y[k] + y[k + 1]) / 2 - CORNER[2]
            for place in middle:
                self.assertAlmostEqual(place / CELL % 1.0, 0.5, delta=1e-9)
            for barb in (2, 4):  # behind the tip, either side
                self.assertLess(math.hypot(x[k + barb] - x[k + 1], y[k + barb] - y[k + 1]), 0.5 * CELL)

    def test_large_pressures_are_in_kilopascal(self):
        self.by_hand(scale=100.0)
        value = self.report().figures["field-bed-pressure"]["map"]["value"]
        self.assertEqual((value["unit"], float(value["factor"])), ("kPa", 1e-3))

    def test_a_plane_that_nothing_reached(self):
        self.by_hand()
        write_field(self.path("run/field_bed.hdf"), [(0, 0, 0)], density=[1.0], pressure=[1.0], velocity=[(0.0, 0.0, 0.0)],
                    coordination=[1.0])
        page = self.report()
        self.assertFalse(any(name.startswith("field-") for name in page.figures))
        self.assertIn("Field bed: no cell of its slice was reached by anything. Plane y = 32.5 mm: layer 3 of 5 of the grid's "
                      "cells across y; gravity lies in it.", "".join(page.words))

    def test_a_large_slice_is_thinned(self):
        """Of 200 x 150 cells one of each 2 x 2 is shown, the second of both, as large as the four."""
        self.by_hand(cells=[200, 1, 150])
        cells = [(i, 0, k) for k in range(150) for i in range(200)]
        ones = [1.0] * len(cells)
        write_field(self.path("run/field_bed.hdf"), cells, density=[i + 1000.0 * k for i, j, k in cells], pressure=ones,
                    velocity=[(0.0, 0.0, 0.0)] * len(cells), coordination=ones)
        page = self.report()
        given = page.figures["field-bed-density"]["map"]
        self.assertEqual((given["columns"], given["rows"]), ("100", "75"))
        self.assertEqual([float(x) for x in given["step"]], [0.01, 0.01])
        self.assertEqual([float(x) for x in given["numbers"]], [2 * c + 1 + 1000.0 * (2 * r + 1) for r in range(75) for c in range(100)])
        self.assertIn("One cell of each 2 x 2 is shown, as large as they.", "".join(page.words))
        self.assertEqual(page.figures["field-bed-speed"]["curves"], [])  # nothing moves: no arrows

    def test_other_folders(self):
        """Of an older clod, or without the file: no slices. A file that is damaged or of another grid: an error."""
        self.by_hand()
        with open(self.path("run/summary.json")) as file:
            summary = json.load(file)
        del summary["fields"]["bed"]["corner_m"]
        pages.write(self.path("run"), summary__json=summary)
        self.assertNotIn("Slices of the fields", self.report().text)
        self.by_hand(corner_m=[0.0, 0.0, 0.0012])
        self.report(2)
        self.assertIn("run/field_bed.hdf is damaged, or is not the grid that summary.json tells of.", self.done.stderr)
        self.by_hand()
        with open(self.path("run/field_bed.hdf"), "wb") as file:
            file.write(b"no HDF5")
        self.report(2)
        self.assertIn("Remove it to have a page without it", self.done.stderr)
        os.remove(self.path("run/field_bed.hdf"))
        self.assertNotIn("Slices of the fields", self.report().text)

    def compare(self, *names):
        done = clod.run("compare", *names, "-o", "both.html", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return pages.load(self.path("both.html"))

    def said(self, page, field="bed"):
        """The paragraph on a field."""
        found = re.search(rf"<p class=\"note\"><strong>Field {field}.</strong> (.*?) *</p>", page.text)
        return found[1] if found else None

    def test_runs_on_one_scale(self):
        """Colours and arrows of both runs by the larger one's numbers, which are three times and twice those of the other."""
        self.by_hand(name="calm")
        calm = self.pressure
        self.by_hand(name="wild", scale=3.0, speed=2.0)
        page = self.compare("calm", "wild")
        self.assertEqual([name for name in page.figures if name.startswith("field-")],
                         [f"field-bed-{value}-{run}" for value in ("density", "pressure", "speed", "coordination")
                          for run in ("calm", "wild")])
        self.assertIn("<h3>wild: pressure in bed</h3>", page.text)
        self.assertEqual(self.said(page), "Means up to 2.5 s, when all ended. All runs have one scale of colours for each value, and one of arrows.")
        self.assertIsNone(self.said(page, "zone"))
        greatest = max(p for p, (i, j, k) in zip(self.pressure, self.cells) if j == 2)
        for run, pressure in (("calm", calm), ("wild", self.pressure)):
            given = page.figures[f"field-bed-pressure-{run}"]["map"]
            self.assertEqual(float(given["range"][0]), 0.0)
            self.assertAlmostEqual(float(given["range"][1]), greatest, delta=1e-9 * greatest)
            wanted = {i + 6 * k: p for p, (i, j, k) in zip(pressure, self.cells) if j == 2}
            found = {k: float(number) for k, number in enumerate(given["numbers"]) if number is not None}
            self.assertEqual(set(found), set(wanted))
            for k, number in found.items():
                self.assertAlmostEqual(number, wanted[k], delta=1e-6 * wanted[k])
            self.assert_svg(f"pressure-{run}", given, "both-field-bed-%s.svg")
        self.assert_arrows(page.figures["field-bed-speed-calm"], "0.5", 0.45)
        self.assert_arrows(page.figures["field-bed-speed-wild"], "1", 0.9)

    def test_units_are_common(self):
        """In kPa, as the larger needs it."""
        self.by_hand(name="calm")
        self.by_hand(name="wild", scale=100.0)
        page = self.compare("calm", "wild")
        for run in ("calm", "wild"):
            self.assertEqual(page.figures[f"field-bed-pressure-{run}"]["map"]["value"]["unit"], "kPa")

    def test_runs_that_are_left_out(self):
        """Those without the grid, or with other cells, another corner or another plane, each with the reason."""
        self.by_hand(name="one")
        self.by_hand(name="two")
        self.by_hand(name="larger", cells=[6, 5, 9])
        self.by_hand(name="moved", corner_m=[-0.02, 0.02, 0.005])
        self.by_hand(name="tilted", complete=COMPLETE.replace("[0 m/s2, 0 m/s2, -9.81 m/s2]", "[0 m/s2, -9.81 m/s2, 0 m/s2]"))
        self.by_hand(name="gone")
        os.remove(self.path("gone/field_bed.hdf"))
        pages.free_run(self.path("none"))
        names = ("none", "one", "larger", "two", "moved", "tilted", "gone")
        page = self.compare(*names)
        self.assertEqual([name for name in page.figures if name.startswith("field-bed-density")],
                         ["field-bed-density-one", "field-bed-density-two"])
        text = self.said(page)
        self.assertEqual(text[text.index("Left out"):],
                         "Left out: none (it has no field of this name). "
                         "Left out: larger (its grid is another, 6 x 5 x 9 cells of 5 mm from (-10, 20, 5) mm). "
                         "Left out: moved (its grid is another, 6 x 5 x 4 cells of 5 mm from (-20, 20, 5) mm). "
                         "Left out: tilted (its gravity leads to another plane). "
                         "Left out: gone (its file of the grid is not there).")
        page = self.compare("none", "two", "larger")
        self.assertFalse(any(name.startswith("field-") for name in page.figures))
        self.assertTrue(self.said(page).startswith("There are no two runs to compare. Left out: none"))
        pages.free_run(self.path("other"))
        self.assertNotIn("Slices of the fields", self.compare("none", "other").text)

    def test_many_runs(self):
        """Twelve of fourteen are shown, whose first has no field."""
        names = [f"run{k:02}" for k in range(14)]
        pages.free_run(self.path(names[0]))
        for name in names[1:]:
            self.by_hand(name=name)
        page = self.compare(*names)
        self.assertEqual([name for name in page.figures if name.startswith("field-bed-density")],
                         [f"field-bed-density-{name}" for name in names[1:13]])
        self.assertIn("Left out: run13 (the first runs alone are shown).", self.said(page))

    def frames(self, name, *moments):
        """Frames of a run at these times, whose speed is the number of the frame."""
        entries = [{"name": f"field_bed-{k:06}.hdf", "time": time} for k, time in enumerate(moments)]
        for k, entry in enumerate(entries):
            self.write_bed(f"{name}/{entry['name']}", k + 1.0)
        with open(self.path(f"{name}/field_bed.hdf.series"), "w") as file:
            json.dump({"file-series-version": "1.0", "files": entries}, file)

    def test_the_last_common_moment(self):
        """Runs that ended at different times: the last frame that both have, to a step, or else their own ends, which is said."""
        self.by_hand(name="short", time_s=0.4)
        self.by_hand(name="long", time_s=2.5, dt_s=4e-5)
        page = self.compare("short", "long")
        self.assertIn("No common time: the runs ended at different times (short at 0.4 s, long at 2.5 s), and each is shown as its "
                      "mean at its own end.", self.said(page))
        self.assertEqual(page.figures["field-bed-speed-long"]["curves"][0]["name"], "velocity in the plane, longest arrow 0.5 m/s")
        self.frames("short", 0.1, 0.2, 0.35, 0.4)
        self.frames("long", 0.2, 0.35003, 0.5)
        page = self.compare("short", "long")
        self.assertIn("The runs ended at different times (short at 0.4 s, long at 2.5 s); this is 0.35 s, the last moment of which all "
                      "have a frame.", self.said(page))
        self.assertIn("The moment 0.35003 s; cells of 5 mm, kernel of 12 mm.", page.text)
        for run, speed in (("short", 3), ("long", 2)):
            numbers = page.figures[f"field-bed-speed-{run}"]["map"]["numbers"]
            self.assertAlmostEqual(float(numbers[1]), speed * math.sqrt(0.3**2 + 5**2 + 0.4**2), delta=1e-5)
        self.frames("long", 0.15, 0.5)  # none of these
        self.assertIn("No common time", self.said(self.compare("short", "long")))
        with open(self.path("long/field_bed.hdf.series"), "w") as file:
            file.write("{}")
        done = clod.run("compare", "short", "long", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("long/field_bed.hdf.series is damaged: it is not the list of frames that clod writes.", done.stderr)

    def test_parts_of_tests(self):
        """Grids of the first part that shears or crushes, on one scale: 3 times the pressure and twice the speed; fill and points are not shown."""
        rest = {"part": "fill", "fields": {"bed": {"phase": "settle"}}}
        for kind, make, phase in (("ring", pages.shear, "preshear"), ("press", pages.uniaxial, "crush"), ("liner", pages.wall, "shear")):
            for name, scale, corner in (("one", 1.0, CORNER), ("two", 3.0, CORNER), ("moved", 1.0, (0.0, 0.0, 0.0))):
                folder = f"{kind}-{name}"
                make(self.path(folder))
                with open(self.path(f"{folder}/case-complete.yaml"), "a") as file:
                    file.write(COMPLETE.split("\n", 1)[1])  # gravity: the plane is vertical
                part = f"seed-{int(scale)}-{phase}"
                with open(self.path(f"{folder}/summary.json")) as file:
                    summary = json.load(file)
                grid = {"phase": phase, "since_s": 0.5 * scale, "samples": 21, "cells": list(CELLS), "corner_m": list(corner),
                        "used_cells": 118, "cell_m": CELL, "width_m": 0.012}
                summary["parts"] = [rest, {"part": part, "fields": {"bed": grid}}, {"part": "last", "fields": {"other": grid}}]
                pages.write(self.path(folder), summary__json=summary)
                self.cells = [(i, 2, k) for k in range(4) for i in range(6) if (i, k) != (2, 3)]
                self.pressure = [scale * (100.0 + 10 * i + k) for i, j, k in self.cells]
                self.write_bed(f"{folder}/{part}_field_bed.hdf", 1.0 if scale == 1.0 else 2.0)
            names = [f"{kind}-{name}" for name in ("one", "two", "moved")]
            page = self.compare(*names)
            self.assertEqual([name for name in page.figures if name.startswith("field-")],
                             [f"field-bed-{value}-{run}" for value in ("density", "pressure", "speed", "coordination") for run in names[:2]])
            self.assertEqual(self.said(page), f"Means over the phase {phase}, with which the part ends: seed-1-{phase} of {kind}-one, "
                             f"seed-3-{phase} of {kind}-two. All runs have one scale of colours for each value, and one of arrows. "
                             f"Left out: {kind}-moved (its grid is another, 6 x 5 x 4 cells of 5 mm from (0, 0, 0) mm).")
            self.assertIn("Mean of 21 samples from 1.5 s on", page.text)
            for run, scale in zip(names, (1.0, 3.0)):
                given = page.figures[f"field-bed-pressure-{run}"]["map"]
                self.assertEqual([float(x) for x in given["range"]], [0.0, 3.0 * 153.0])
                self.assertEqual([number and float(number) for number in given["numbers"]],
                                 [None if k == 20 else scale * (100.0 + 10 * (k % 6) + k // 6) for k in range(24)])
            for run, told in zip(names, ("0.5", "1")):
                self.assertEqual(page.figures[f"field-bed-speed-{run}"]["curves"][0]["name"], f"velocity in the plane, longest arrow {told} m/s")

    def test_a_run(self):
        """All numbers of a real run's slice are those of its file, at their places; blank cells are those that are not in it."""
        pages.field_run(self.path("run"))
        page = self.report()
        with open(self.path("run/summary.json")) as file:
            grid = json.load(file)["fields"]["bed"]
        self.assertEqual(grid["cells"], [10, 9, 16])
        with h5py.File(self.path("run/field_bed.hdf"), "r") as file:
            at = numpy.rint((file["VTKHDF/Points"][::8] - [-0.004, 0.0, -0.012]) / 0.004).astype(int)
            values = {name: file["VTKHDF/CellData"][name][:] for name in VALUES}
        values["speed"] = numpy.linalg.norm(values.pop("velocity"), axis=1)
        layer = [k for k in range(len(at)) if at[k][1] == 4]
        self.assertTrue(60 < len(layer) < 160)
        for name, column in values.items():
            given = page.figures[f"field-bed-{name}"]["map"]
            wanted = {(at[k][0], at[k][2]): column[k] for k in layer if not math.isnan(column[k])}
            found = {(k % 10, k // 10): float(number) for k, number in enumerate(given["numbers"]) if number is not None}
            self.assertEqual(set(found), set(wanted))
            for place, number in found.items():
                self.assertAlmostEqual(number, wanted[place], delta=1e-6 * abs(wanted[place]))
            self.assert_svg(name, given)


if __name__ == "__main__":
    clod.main()
