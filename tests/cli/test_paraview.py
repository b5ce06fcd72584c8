"""What clod writes for ParaView: the state file, and all snapshots of a run through vtkHDFReader, the reader
that ParaView has. The latter is left out by name where VTK's Python package (Debian: python3-vtk9) is not
installed, and so is ParaView's own view of the state file where its pvpython is not."""

import glob
import json
import math
import os
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

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


LOAD = """\
import sys
from paraview.simple import GetAnimationScene, GetRepresentations, GetSources, LoadState, UpdatePipeline
LoadState(sys.argv[1])
times = GetAnimationScene().TimeKeeper.TimestepValues
for (name, _), source in sorted(GetSources().items()):
    UpdatePipeline(times[-1], source)
    print(name, source.GetDataInformation().GetNumberOfPoints())
for (name, _), shown in sorted(GetRepresentations().items()):
    print(name, str(shown.Representation), shown.Visibility, shown.ColorArrayName[1])
print("times", len(times))
"""


def run_case(test, case, folder):
    with open(test.path("case.yaml"), "w") as file:
        file.write(case)
    done = clod.run("run", "case.yaml", "-o", folder, cwd=test.folder)
    test.assertEqual(done.returncode, 0, done.stderr)


class State(clod.Case):
    """STEM.pvsm, which opens everything at once."""

    def values(self, proxy, name):
        found = [p for p in proxy.iter("Property") if p.get("name") == name]
        self.assertEqual(len(found), 1, name)
        self.assertEqual(int(found[0].get("number_of_elements")), len(found[0]), name)
        return [element.get("value") for element in found[0]]

    def proxies(self, path):
        """By type or, of those known to the window, by collection and name."""
        root = ElementTree.parse(path).getroot().find("ServerManagerState")
        by_id = {p.get("id"): p for p in root.findall("Proxy")}
        for proxy in by_id.values():  # nothing points to what is not there
            self.assertEqual({p.get("value") for p in proxy.iter("Proxy") if p is not proxy} - set(by_id),
                             set())
        return {(c.get("name"), i.get("name")): by_id[i.get("id")]
                for c in root.findall("ProxyCollection") for i in c.findall("Item")}

    def test_state_names_films_colours_and_camera(self):
        folder = "R&D <1>"  # which XML must not have as it is
        run_case(self, CASE, folder)
        of = self.proxies(self.path(f"{folder}/run.pvsm"))
        with open(self.path(f"{folder}/summary.json")) as file:
            time = json.load(file)["time_s"]
        films = {name: self.values(of["sources", name], "FileName")[0]
                 for name in ("grains", "walls", "contacts")}
        for name, path in films.items():
            end = "" if name == "grains" else "_" + name
            self.assertEqual(path, os.path.realpath(self.path(f"{folder}/run{end}.hdf.series")))
            self.assertTrue(os.path.exists(path))
        grains = of["representations", "grains"]
        self.assertEqual(self.values(grains, "Representation"), ["Point Gaussian"])
        self.assertEqual(self.values(grains, "SetScaleArray")[3:], ["0", "radius"])
        self.assertEqual(self.values(of["representations", "walls"], "ColorArrayName")[3:], ["1", "pressure"])
        self.assertEqual(self.values(of["representations", "contacts"], "Visibility"), ["0"])
        self.assertAlmostEqual(float(self.values(of["timekeeper", "TimeKeeper1"], "Time")[0]), time, places=6)
        speeds = [float(x) for x in self.values(of["lookup_tables", "velocity.PVLookupTable"], "RGBPoints")][::4]
        self.assertEqual(speeds[0], 0)
        # grains fall from 50 to 80 mm at 1 m/s, so none is faster than 1 + 2 g h to the floor
        self.assertTrue(0.01 < speeds[2] < math.sqrt(1 + 2 * 9.81 * 0.08), speeds)
        view = of["views", "RenderView1"]
        middle = [float(x) for x in self.values(view, "CameraFocalPoint")]
        for value, expected in zip(middle, (0, 0, 0.025)):  # cylinder of 50 mm; grains may be higher
            self.assertLess(abs(value - expected), 0.02)
        away = math.dist(middle, [float(x) for x in self.values(view, "CameraPosition")])
        self.assertGreater(away, 0.08 / math.tan(math.radians(15)))  # sees the floor's radius at least

    def test_plain_run_has_no_pressure(self):
        case = CASE.replace(", surfaces: true", "").replace("contacts: true, ", "").replace(
            ", contacts: true", "")
        run_case(self, case, "out")
        of = self.proxies(self.path("out/run.pvsm"))
        self.assertEqual({name for collection, name in of if collection == "sources"}, {"grains", "walls"})
        self.assertEqual({name for collection, name in of if collection == "scalar_bars"}, {"velocity"})

    @unittest.skipIf(shutil.which("pvpython") is None, "ParaView's pvpython is not installed")
    def test_paraview_loads_it(self):
        run_case(self, CASE, "out")
        with open(self.path("load.py"), "w") as file:
            file.write(LOAD)
        done = subprocess.run(["pvpython", self.path("load.py"), self.path("out/run.pvsm")], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd="/", check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("out/summary.json")) as file:
            grains = json.load(file)["grains"]
        lines = done.stdout.splitlines()
        self.assertIn(f"grains {grains}", lines)
        for line in ("contacts 'Surface' 0 ", "grains 'Point Gaussian' 1 velocity", "walls 'Surface' 1 pressure",
                     "times 2"):
            self.assertIn(line, lines)


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
        run_case(self, CASE, "out")
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
