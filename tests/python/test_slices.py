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

    def by_hand(self, complete=COMPLETE, scale=1.0, **changes):
        """A folder with a field: pressure falls with height, x moves down and to the right, y faster; two holes."""
        grid = {"since_s": 0.5, "samples": 21, "cells": list(CELLS), "corner_m": list(CORNER), "used_cells": 118,
                "cell_m": CELL, "width_m": 0.012}
        grid.update(changes)
        pages.free_run(self.path("run"), fields={"bed": grid, "zone": {"since_s": 0.5, "samples": 21, "volume_m3": 1.0}})
        pages.write(self.path("run"), **{"case_HYPHEN_complete__yaml": complete})
        self.cells = [(i, j, k) for k in range(4) for j in range(5) for i in range(6)
                      if (i, j, k) not in ((2, 2, 3), (0, 2, 0))]
        # other layers than j = 2 would be seen at once
        self.pressure = [scale * 1500 * G * (0.03 - (CORNER[2] + (k + 0.5) * CELL)) * (1 if j == 2 else 1e6) for i, j, k in self.cells]
        coordination = [math.nan if (i, k) == (5, 3) else 4 + 0.1 * i for i, j, k in self.cells]
        write_field(self.path("run/field_bed.hdf"), self.cells, density=[1500.0 - 10 * i for i, j, k in self.cells],
                    pressure=self.pressure, velocity=[(0.3, 5.0, -0.4)] * len(self.cells), coordination=coordination)

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

    def assert_svg(self, name, given):
        """Each cell has the colour of its number, blank ones none."""
        found = shades(clod.read(self.path(f"run/report-field-bed-{name}.svg")).decode())
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

    def assert_arrows(self, figure):
        """One in each cell that has a velocity, 3 to the right and 4 down, 0.9 of a cell long, its middle in that of the cell."""
        curve, = figure["curves"]
        self.assertEqual(curve["name"], "velocity in the plane, longest arrow 0.5 m/s")
        x, y = ([number and float(number) for number in curve[axis]] for axis in "xy")
        self.assertEqual(len(x), 6 * 22)
        for k in range(0, len(x), 6):
            self.assertAlmostEqual(x[k + 1] - x[k], 0.9 * 0.6 * CELL, delta=1e-12)
            self.assertAlmostEqual(y[k + 1] - y[k], -0.9 * 0.8 * CELL, delta=1e-12)
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
