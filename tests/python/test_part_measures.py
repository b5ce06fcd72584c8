"""Grids and mixing indices of a ring shear test: integrals of the files, which h5py reads, are those of means over
regions, and an index is that of the grains in a snapshot."""

import json
import os
import re
import shutil
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "report"))
import pages  # noqa: E402
from pages import clod  # noqa: E402

try:
    import h5py
    import numpy
except ImportError:
    h5py = None

# The box reaches a width and more beyond all grains, so that no part of a kernel is cut off.
LOW, HIGH, CELL, MIXED = (-0.06, -0.06, -0.02), (0.06, 0.06, 0.12), 0.005, 0.01  # m
VOLUME = 0.12 * 0.12 * 0.14
BOX = "{box: {min: [-60 mm, -60 mm, -20 mm], max: [60 mm, 60 mm, 120 mm]}}"
MEASURES = f"""
fields:
  whole: {{region: {BOX}, interval: 1 us}}
  grid: {{region: {BOX}, cell: 5 mm, width: 15 mm, interval: 1 us}}
mixing:
  number: {{region: {BOX}, cell: 10 mm, above: 2.5 mm}}
  mass: {{region: {BOX}, cell: 10 mm, above: 2.5 mm, by: mass}}
"""
# Short: a sample of the grid takes as long as a thousand steps, and there is one in each row of a last phase.
SHORT = (("preshear_max: 30 mm", "preshear_max: 4 mm"), ("shear_max: 2.5 mm", "shear_max: 1.2 mm"),
         ("preshear_stress: 10 kPa", "preshear_min: 2 mm\n  preshear_stress: 10 kPa"),
         ("block_displacement: 2 mm", "block_displacement: 0.5 mm"), ("beyond_peak: 1 mm", "beyond_peak: 0.3 mm"),
         ("[3 kPa, 5 kPa, 7 kPa]", "[3 kPa, 7 kPa]"))
LAST = {"preshear": "preshear", "reverse": "reverse", "point-1": "shear", "point-2": "shear"}


def lacey(position, first, weight):
    """Index and share of grains that are counted (weight 1) or weighed, by the formulas of docs/mixing.md."""
    place = numpy.floor((position - numpy.array(LOW)) / MIXED).astype(int)
    _, sample = numpy.unique(place, axis=0, return_inverse=True)
    sample = sample.ravel()
    every = numpy.bincount(sample, weights=weight)
    share = numpy.bincount(sample, weights=weight * first) / every
    count, cells, whole = len(first), len(every), weight.sum()
    p = (weight * first).sum() / whole
    variance = (every * (share - p) ** 2).sum() / whole
    squares = [(weight[kind] ** 2).sum() for kind in (first, ~first)]
    random = count / (count - 1) * (cells - 1) * ((1 - p) ** 2 * squares[0] + p ** 2 * squares[1]) / whole ** 2
    return (p * (1 - p) - variance) / (p * (1 - p) - random), p


@unittest.skipIf(h5py is None, "no h5py")
class PartMeasures(clod.Case):

    def setUp(self):
        super().setUp()
        with open(clod.source("tests/cli/ring_shear.yaml")) as file:
            text = file.read() + MEASURES
        for before, after in SHORT:
            self.assertIn(before, text)
            text = text.replace(before, after)
        with open(self.path("case.yaml"), "w") as file:
            file.write(text)
        self.go("out")
        self.parts = {part["part"]: part for part in self.summary("out")["parts"]}
        self.assertEqual(set(self.parts), set(LAST))

    def snapshots(self, part):
        with open(self.path(f"out/{part}.hdf.series")) as file:
            return [one["name"] for one in json.load(file)["files"]]

    def check_grid(self, part, mass):
        told = self.parts[part]["fields"]["grid"]
        self.assertEqual((told["file"], told["phase"]), (f"{part}_field_grid.hdf", LAST[part]))
        self.assertEqual(told["cells"], [24, 24, 28])
        rows = clod.table(self.path(f"out/{part}.csv"))
        rows = [row for row in rows if row["time"] > told["since_s"]]
        self.assertEqual(len({row["phase"] for row in rows}), 1)  # all of one phase
        self.assertEqual(told["samples"], len(rows))
        with h5py.File(self.path("out/" + told["file"])) as file:
            cells = {name: column[:] for name, column in file["VTKHDF/CellData"].items()}
        self.assertEqual(len(cells["density"]), told["used_cells"])
        total = {name: column.sum(axis=0) * CELL ** 3 for name, column in cells.items()}
        mean = lambda name: VOLUME * clod.mean(rows, f"field_whole.{name}")
        # docs/fields.md: with three cells a width the sum over cells has an integral within 0.3 %
        self.assertLess(abs(total["density"] - mass), 3e-3 * mass)
        self.assertLess(abs(total["solid_fraction"] - mass / 2481.3), 3e-3 * mass / 2481.3)
        stress = [mean(f"contact_stress_{a}{b}") for a in "xyz" for b in "xyz"]
        scale = max(stress)
        self.assertGreater(scale, 0.1)
        for one, other in zip(total["contact_stress"], stress):
            self.assertLess(abs(one - other), 3e-3 * scale)
        for one, axis in zip(total["wall_force"], "xyz"):
            self.assertLess(abs(one - mean(f"wall_force_{axis}")), 1.0)  # N, of some 40 N that the lid presses with
        momentum = numpy.nan_to_num(cells["density"][:, None] * cells["velocity"]).sum(axis=0) * CELL ** 3
        for one, axis in zip(momentum, "xyz"):
            expected = sum(row["field_whole.density"] * row[f"field_whole.velocity_{axis}"] for row in rows)
            self.assertLess(abs(one - VOLUME * expected / len(rows)), 3e-3 * mass * 0.080)  # all at the speed of shear

    def check_mixing(self, part):
        row = clod.table(self.path(f"out/{part}.csv"))[-1]
        with h5py.File(self.path("out/" + self.snapshots(part)[-1])) as file:
            self.assertLess(abs(file.attrs["time_s"] - row["time"]), 1e-9)
            position = file["VTKHDF/Points"][:].astype(float)
            radius = file["VTKHDF/PointData/radius"][:].astype(float)
        first = radius > 2.5e-3
        for name, weight in (("number", numpy.ones(len(radius))), ("mass", radius ** 3)):
            index, share = lacey(position, first, weight)
            self.assertTrue(0.1 < share < 0.9)
            self.assertAlmostEqual(row[f"mixing_{name}.share"], share, delta=1e-6)
            self.assertAlmostEqual(row[f"mixing_{name}.lacey"], index, delta=1e-5)

    def check_means(self, part):
        """Those of the rows in the last third of the last phase, and deviations of ten blocks (docs/fields.md, docs/mixing.md)."""
        table = clod.table(self.path(f"out/{part}.csv"))
        first = len(table)
        while first > 0 and table[first - 1]["phase"] == table[-1]["phase"]:
            first -= 1
        began, end = table[max(first - 1, 0)]["time"], table[-1]["time"]
        since = end - (end - began) / 3
        rows = [row for row in table if row["time"] > since - 1e-9]
        blocks = numpy.minimum([(row["time"] - since) / (end - since) * 10 + 1e-6 for row in rows], 9).astype(int)
        self.assertGreater(len(rows), 5)

        def check(told, column):
            values = numpy.array([row[column] for row in rows])
            each = [values[blocks == b].mean() for b in range(10) if (blocks == b).any()]
            self.assertAlmostEqual(told["mean"], values.mean(), delta=1e-12 * abs(values.mean()))
            self.assertAlmostEqual(told["deviation"], numpy.std(each, ddof=1), delta=1e-9 * abs(values.mean()))

        told = self.parts[part]
        for one in (told["fields"]["whole"], told["mixing"]["number"], told["mixing"]["mass"]):
            self.assertAlmostEqual(one["since_s"], since, delta=1e-9)
            self.assertEqual((one["phase"], one["rows"]), (LAST[part], len(rows)))
        whole = told["fields"]["whole"]
        self.assertAlmostEqual(whole["volume_m3"], VOLUME, delta=1e-12)
        check(whole["density_kg_per_m3"], "field_whole.density")
        check(whole["pressure_Pa"], "field_whole.pressure")
        for c, name in enumerate(("xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz")):
            check({key: whole["contact_stress_Pa"][key][c] for key in ("mean", "deviation")}, f"field_whole.contact_stress_{name}")
        for name in ("number", "mass"):
            one = told["mixing"][name]
            check(one, f"mixing_{name}.lacey")
            for key in ("lacey", "variance", "random_variance", "share", "grains_per_cell"):
                self.assertEqual(one[key], table[-1][f"mixing_{name}.{key}"])
            self.assertEqual(one["by"], name)

    def check_tables(self, page):
        """A table for each field and index, a column for each part; a grid has none."""
        tables = {title: pages.titled(text) for title, text in re.findall(r"<h3>([^<]*)</h3>\s*(<div class=\"scroll\"><table.*?</table>)", page, re.S)}
        self.assertEqual({title for title in tables if re.match("Field|Mixing", title)}, {"Field whole", "Mixing number", "Mixing mass"})
        for title, number in (("Field whole", lambda part: part["fields"]["whole"]["pressure_Pa"]["mean"]),
                              ("Mixing mass", lambda part: part["mixing"]["mass"]["mean"])):
            rows = {row[0][1]: row[1:] for row in tables[title][""]}
            self.assertEqual([text for _, text in rows[""]], list(self.parts))
            self.assertEqual([text for _, text in rows["phase"]], [LAST[part] for part in self.parts])
            cells = rows["pressure [Pa]" if title == "Field whole" else "mean"]
            for (whole, text), part in zip(cells, self.parts.values()):
                self.assertAlmostEqual(float(whole.split()[0]), number(part), delta=1e-6 * abs(number(part)))
                self.assertIn("±", text)
        rows = {row[0][1]: row[1:] for row in tables["Field whole"][""]}
        for key, name, unit in (("velocity_m_per_s", "velocity", "m/s"), ("contact_stress_Pa", "contact stress", "Pa"),
                                ("kinetic_stress_Pa", "kinetic stress", "Pa"), ("wall_force_N_per_m3", "wall force", "N/m3")):
            several = len(self.parts["preshear"]["fields"]["whole"][key]["mean"])
            for c, axes in enumerate([a + b for a in "xyz" for b in "xyz"] if several == 9 else "xyz"):
                for (whole, _), part in zip(rows[f"{name} {axes} [{unit}]"], self.parts.values()):
                    told = part["fields"]["whole"][key]
                    numbers = [told["mean"][c]] + [told["deviation"][c]] * (told["deviation"][c] > 0)
                    self.assertEqual([float(word) for word in whole.removesuffix(" " + unit).split(" &plusmn; ")], numbers)

    def test_grids_and_mixing(self):
        mass = json.loads(clod.run("check", self.path("case.yaml"), "--json").stdout)["mass_kg"]
        for part in LAST:
            with self.subTest(part):
                self.check_grid(part, mass)
                self.check_mixing(part)
                self.check_means(part)
        done = clod.run("report", self.path("out"))
        self.assertEqual(done.returncode, 0, done.stderr)
        page = clod.read(self.path("out/report.html")).decode()
        told = self.parts["preshear"]["fields"]["grid"]
        self.assertEqual(page.count("Slices of the fields, preshear</h2>"), 1)
        self.assertIn("Plane y = -2.5 mm: layer 12 of 24 of the grid's cells across y", page)
        self.assertIn(f"Mean of {told['samples']} samples from {told['since_s']:.6g} s on; cells of 5 mm", page)
        self.assertTrue(os.path.exists(self.path("out/report-field-grid-speed.svg")))
        self.check_compared(page)
        self.check_tables(page)

    def check_compared(self, page):
        """Beside itself: the numbers of its own page, twice, and what is shown."""
        shutil.copytree(self.path("out"), self.path("again"))
        done = clod.run("compare", "out", "again", "-o", "both.html", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        both, own = pages.load(self.path("both.html")), pages.Page(page).figures
        self.assertIn("Means over the phase preshear, with which the part ends: preshear. All runs have one scale", "".join(both.words))
        for name in ("density", "pressure", "speed", "coordination"):
            for run in ("out", "again"):
                self.assertEqual(both.figures[f"field-grid-{name}-{run}"]["map"], own[f"field-grid-{name}"]["map"])


if __name__ == "__main__":
    clod.main()
