"""All snapshots of a run through vtkHDFReader, the reader that ParaView has; left out by name where
VTK's Python package (Debian: python3-vtk9) is not installed."""

import glob
import json
import math
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

try:
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError:
    vtkHDFReader = None

VERTEX, LINE, TRIANGLE, VOXEL = 1, 3, 5, 11  # vtkCellType.h
CASE = """\
materials:
  ore: {density: 2500 kg/m3}
  steel: {density: 7800 kg/m3, hardness: 2 GPa, archard: 1e-4, finnie: 1e-4}
contacts:
  default: {law: mepa, exponent: 1.5, k1: 1e6 N/m^1.5, k2: 5e6 N/m^1.5,
            k_adh: 2.5e6 N/m^1.5, restitution: 0.3, friction: 0.5}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {step: 1e-5 s, design_stress: 1 kPa}
domain: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.15 m], open: delete}
grains:
  - material: ore
    radius: {distribution: uniform, min: 4.5 mm, max: 5.5 mm}
    inlet: {number_flow: 2000 1/s, end: 0.1 s}
    region: {box: {min: [-50 mm, -50 mm, 50 mm], max: [50 mm, 50 mm, 80 mm]}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
walls:
  floor: {material: steel, shapes: [{disc: {center: [0 m, 0 m, 0 m], radius: 80 mm}}, {cylinder: {foot: [0 m, 0 m, 0 m], radius: 80 mm, length: 50 mm}}]}
stages: [{name: run, duration: 0.2 s}]
clumps: {}
history_map: {cell: 20 mm}
output: {series_interval: 10 ms, snapshot_interval: 0.1 s, contacts: true, surfaces: true}
"""


@unittest.skipIf(vtkHDFReader is None, "VTK's Python package (python3-vtk9) is not installed")
class ParaView(clod.Case):

    def read(self, path):
        """Grid, and arrays by name as lists of tuples; they belong to points or to cells."""
        reader = vtkHDFReader()
        reader.SetFileName(path)
        reader.Update()
        grid = reader.GetOutput()
        arrays = {}
        for data in (grid.GetPointData(), grid.GetCellData()):
            for k in range(data.GetNumberOfArrays()):
                array = data.GetArray(k)
                arrays[array.GetName()] = [array.GetTuple(i)
                                           for i in range(array.GetNumberOfTuples())]
        return grid, arrays

    def kinds(self, grid):
        return {grid.GetCellType(k) for k in range(grid.GetNumberOfCells())}

    def test_all_files_of_a_run(self):
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE)
        done = clod.run("run", "case.yaml", "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("out/summary.json")) as file:
            summary = json.load(file)
        with open(clod.source("docs/howto/paraview.md")) as file:
            told = set(re.findall(r"`([a-z_]+)`", file.read()))
        files = sorted(glob.glob(self.path("out/*.hdf")))
        self.assertEqual(len(files), 3 * 2 + 1)
        last = {}
        for path in files:
            grid, arrays = self.read(path)
            name = os.path.basename(path)
            kind = name.split("_")[0]
            last[kind] = grid, arrays
            # every array is in the howto, has a value for each point or cell, and is a number
            self.assertEqual(set(arrays) - told, set(), name)
            for array, values in arrays.items():
                size = grid.GetNumberOfPoints() if kind == "snap" else grid.GetNumberOfCells()
                self.assertEqual(len(values), size, f"{name} {array}")
                self.assertTrue(all(math.isfinite(x) for value in values for x in value),
                                f"{name} {array}")
        grid, arrays = last["snap"]
        self.assertEqual(self.kinds(grid), {VERTEX})
        self.assertEqual(grid.GetNumberOfPoints(), summary["grains"])
        self.assertTrue(all(0.0045 < r < 0.0055 for r, in arrays["radius"]))
        for (r,), (m,) in zip(arrays["radius"], arrays["mass"]):
            self.assertLess(abs(m / (2500 * 4 / 3 * math.pi * r**3) - 1), 1e-6)  # 32 bits
        self.assertEqual({int(i) for i, in arrays["id"]}, set(range(1, summary["grains"] + 1)))
        low = grid.GetBounds()
        self.assertGreater(low[4], 0.003)  # above the floor
        grid, arrays = last["walls"]
        self.assertEqual(self.kinds(grid), {TRIANGLE})
        self.assertEqual({int(s) for s, in arrays["shape"]}, {1, 3})
        self.assertGreater(max(p for p, in arrays["pressure"]), 0.0)
        grid, arrays = last["contacts"]
        self.assertEqual(self.kinds(grid), {LINE})
        self.assertGreater(grid.GetNumberOfCells(), 50)
        self.assertTrue(all(one != other for one, other in arrays["id"]))
        grid, arrays = last["history"]
        self.assertEqual(self.kinds(grid), {VOXEL})
        self.assertGreater(grid.GetNumberOfCells(), 5)
        self.assertGreater(min(n for n, in arrays["contacts"]), 0.0)
        edge = grid.GetCell(0).GetBounds()
        self.assertLess(abs(edge[1] - edge[0] - 0.02), 1e-6)


if __name__ == "__main__":
    clod.main()
