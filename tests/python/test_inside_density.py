"""Density away from the walls of a shear cell: that of the grains in the snapshot of the end of preshear, read by h5py."""

import json
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "report"))
import pages  # noqa: E402,F401
from pages import clod  # noqa: E402

try:
    import h5py
    import numpy
except ImportError:
    h5py = None

DENSITY, APART = 2481.3, 1.5  # of the grains [kg/m3]; mean diameters from the walls
LEAST = ("preshear_stress: 10 kPa", "preshear_min: 1 mm\n  preshear_stress: 10 kPa")
FINE = (("radius: {mean: 2.5 mm, sd: 0.15 mm, min: 2.2 mm, max: 2.8 mm}",
         "radius: {mean: 1.6 mm, sd: 0.1 mm, min: 1.4 mm, max: 1.8 mm}"), ("grain_count: 350", "grain_count: 1800"),
        LEAST)
RING = (("bar_height: 4 mm", "bar_height: 2 mm"), ("preshear_max: 30 mm", "preshear_max: 6 mm"), ("shear_max: 2.5 mm", "shear_max: 1.2 mm"),
        ("block_displacement: 2 mm", "block_displacement: 1 mm"), ("beyond_peak: 1 mm", "beyond_peak: 0.3 mm"),
        ("[3 kPa, 5 kPa, 7 kPa]", "[3 kPa, 7 kPa]"))
JENIKE = (("preshear_max: 6.1 mm", "preshear_max: 3.1 mm"), ("[3 kPa, 5 kPa, 7 kPa]", "[3 kPa, 7 kPa]"))
BARS = 0.002  # m, height of the bars of the ring's lid and trough
BASE = 0.012  # m, shear plane of the Jenike cell


@unittest.skipIf(h5py is None, "no h5py")
class InsideDensity(clod.Case):

    def run_case(self, case, *changes):
        with open(clod.source(f"tests/cli/{case}")) as file:
            text = file.read()
        for before, after in changes:
            self.assertIn(before, text)
            text = text.replace(before, after)
        with open(self.path("case.yaml"), "w") as file:
            file.write(text)
        self.go("out")
        return self.summary("out")

    def grains_at_the_end(self, rows):
        with open(self.path("out/preshear.hdf.series")) as file:
            last = json.load(file)["files"][-1]
        self.assertAlmostEqual(last["time"], rows[-1]["time"], delta=1e-9)
        with h5py.File(self.path(f"out/{last['name']}")) as file:
            centre = file["VTKHDF/Points"][:]
            radius = file["VTKHDF/PointData/radius"][:]
        line = (numpy.arange(20) + 0.5) / 10 - 1  # 4200 points in each grain: within 0.1 % of the limit
        cube = numpy.stack(numpy.meshgrid(line, line, line), -1).reshape(-1, 3)
        ball = cube[(cube**2).sum(1) < 1]
        points = centre[:, None, :] + radius[:, None, None] * ball
        return numpy.moveaxis(points, -1, 0), 4 / 3 * math.pi * radius**3, 2 * radius.mean()

    def check_told(self, summary, counted):
        preshear = summary["parts"][0]
        self.assertEqual(preshear["part"], "preshear")
        inside = preshear["inside_density_kg_m3"]
        # 552 points in a grain, whose rows lie along the axes: a layer of a cell this small errs alike, by 0.3 %
        self.assertAlmostEqual(inside / counted, 1.0, delta=5e-3)
        self.assertGreater(inside, 1.02 * preshear["bulk_density_kg_m3"])  # a cell a few grains wide
        self.assertLess(inside, 0.7 * DENSITY)
        locus = summary["locus"]["loci"][0]
        self.assertAlmostEqual(locus["rho_inside_kg_m3"]["value"] / inside, 1.0, delta=1e-12)
        with open(self.path("out/points.csv")) as file:
            header, *rows = file.read().splitlines()
        self.assertTrue(header.endswith(",rho_inside [kg/m3]"))
        for row in rows:
            self.assertAlmostEqual(float(row.rsplit(",", 1)[1]) / inside, 1.0, delta=1e-8)
        with open(self.path("out/report.txt")) as file:
            self.assertIn(f"rho_inside{inside:10.1f} ±", file.read())
        again = clod.run("locus", self.path("out/points.csv"), "--json")
        self.assertEqual(json.loads(again.stdout)["loci"][0]["rho_inside_kg_m3"]["value"],
                         float(rows[0].rsplit(",", 1)[1]))

    def test_ring(self):
        summary = self.run_case("ring_shear.yaml", *FINE, *RING)
        rows = clod.table(self.path("out/preshear.csv"))
        (x, y, z), volume, diameter = self.grains_at_the_end(rows)
        lid = rows[-1]["height"]
        gap = APART * diameter
        r = numpy.hypot(x, y)
        low, high, inner, outer = BARS + gap, lid - BARS - gap, 0.020 + gap, 0.040 - gap
        inside = (r > inner) & (r < outer) & (z > low) & (z < high)
        self.assertGreater(inside.mean(1).sum(), 50)
        self.check_told(summary, DENSITY * (volume * inside.mean(1)).sum() /
                        (math.pi * (outer**2 - inner**2) * (high - low)))

    def test_jenike(self):
        summary = self.run_case("jenike.yaml", *FINE, *JENIKE)
        preshear = summary["parts"][0]
        rows = clod.table(self.path("out/preshear.csv"))
        (x, y, z), volume, diameter = self.grains_at_the_end(rows)
        moved = numpy.interp(rows[-1]["time"], [row["time"] for row in rows],
                             numpy.cumsum([0] + [0.5 * (a["speed"] + b["speed"]) * (b["time"] - a["time"])
                                                 for a, b in zip(rows, rows[1:])]))
        gap = APART * diameter
        radius, low, high = 0.025 - gap, gap, rows[-1]["height"] - gap
        r = numpy.hypot(numpy.where(z > BASE, x - (-0.004 + moved), x), y)
        inside = (r < radius) & (z > low) & (z < high)
        self.assertGreater(inside.mean(1).sum(), 100)
        told = DENSITY * (volume * inside.mean(1)).sum() / (math.pi * radius**2 * (high - low))
        self.check_told(summary, told)

    def test_uniaxial(self):
        """At the end of consolidation, of which there is no snapshot: denser than all, and the same in all files."""
        summary = self.run_case("uniaxial.yaml", FINE[0], ("grain_count: 250", "grain_count: 1300"),
                                ("crush_max: 8 %", "crush_max: 3 %"), ("[10 kPa, 20 kPa]", "[10 kPa]"))
        told = summary["flow_function"][0]
        inside = told["inside_density_kg_m3"]
        self.assertGreater(inside, 1.02 * told["bulk_density_kg_m3"])
        self.assertLess(inside, 0.7 * DENSITY)
        row = clod.table(self.path("out/flow_function.csv"))[0]
        self.assertAlmostEqual(row["rho_inside"] / inside, 1.0, delta=1e-8)
        with open(self.path("out/report.txt")) as file:
            self.assertIn(f"{row['rho_b']:.0f} {inside:7.0f} {row['solid_fraction']:9.3f}", file.read())

    def test_narrow_cell_tells_none(self):
        summary = self.run_case("ring_shear.yaml", LEAST, *RING)
        self.assertIsNone(summary["parts"][0]["inside_density_kg_m3"])
        self.assertIsNone(summary["locus"]["loci"][0]["rho_inside_kg_m3"]["value"])
        with open(self.path("out/points.csv")) as file:
            self.assertTrue(all(row.endswith(",") for row in file.read().splitlines()[1:]))
        with open(self.path("out/report.txt")) as file:  # as a laboratory's, which does not know it
            self.assertNotIn("rho_inside", file.read())


if __name__ == "__main__":
    clod.main()
