"""clod check counts what meshes take, and says of them what the mesh doctor would, as a run does."""

import glob
import json
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = """
materials: {{ore: {{density: 2500 kg/m3}}}}
contacts: {{default: {{law: hooke, k1: 1e3 N/m, restitution: 0.5}}}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
domain: {{min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}}
walls: {{sheet: {{material: ore, shapes: [{{mesh: {{file: sheet.obj, unit: {unit}}}}}]{more}}}}}
grains: [{{material: ore, file: grains.csv}}]
stages: [{{name: run, duration: 1 ms}}]
time: {{step: 1e-5 s}}
output: {{series_interval: 1 ms, snapshot_interval: 1 ms}}
"""


class CheckMesh(clod.Case):

    def case(self, squares, unit="1 m", more=""):
        """A sheet of 0.4 units in squares of two facets, and two grains of 3 mm above it."""
        with open(self.path("sheet.obj"), "w") as file:
            for i in range(squares + 1):
                for j in range(squares + 1):
                    file.write(f"v {-0.2 + 0.4 * i / squares:.6f} "
                               f"{-0.2 + 0.4 * j / squares:.6f} 0\n")
            for i in range(squares):
                for j in range(squares):
                    a, b = 1 + i * (squares + 1) + j, 1 + (i + 1) * (squares + 1) + j
                    file.write(f"f {a} {b} {b + 1}\nf {a} {b + 1} {a + 1}\n")
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [m],y [m],z [m],radius [m]\n0,0,0.01,0.003\n0.05,0,0.01,0.003\n")
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(unit=unit, more=more))

    def check(self):
        done = clod.run("check", "--json", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def run_case(self):
        done = clod.run("run", "--fresh", "-o", "out", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def test_snapshots_and_memory(self):
        """The files that a run writes, and what 20 000 facets take beside 2."""
        for more in ("", ", spin: 10 rad/s"):
            self.case(100, more=more)
            told = self.check()
            self.run_case()
            files = glob.glob(self.path("out/walls_*.hdf"))
            found = sum(os.path.getsize(name) for name in files)
            self.assertEqual(len(files), told["snapshots_most"])
            self.assertGreater(told["disk_snapshots_bytes"], 0.5 * found, more)
            self.assertLess(told["disk_snapshots_bytes"], 2.0 * found, more)
        self.case(1)
        few = self.check()
        self.assertGreater(told["memory_bytes"] - few["memory_bytes"], 100 * 20000)
        self.assertLess(told["memory_bytes"] - few["memory_bytes"], 400 * 20000)
        self.assertGreater(told["memory_facets_bytes"], 100 * 20000)

    def test_doubts(self):
        """A unit that looks wrong is a warning of both, open edges are a note; a good one is quiet."""
        self.case(2, unit="1 um")
        told = self.check()
        run = self.run_case()
        self.assertIn("walls.sheet: sheet.obj: The mesh is 4e-07 m long", str(told["warnings"]))
        self.assertIn("walls.sheet: sheet.obj has 8 open edges", str(told["notes"]))
        self.assertIn("warning: walls.sheet: sheet.obj: The mesh is 4e-07 m long", run)
        self.assertIn("walls.sheet: sheet.obj has 8 open edges", run)
        self.case(2)
        self.assertNotIn("sheet.obj: ", str(self.check()["warnings"]))
        self.assertNotIn("warning: walls.sheet", self.run_case())

    def test_facets_over_others(self):
        """Back and front of a square, cut along other diagonals."""
        self.case(1)
        with open(self.path("sheet.obj"), "a") as file:
            file.write("f 2 3 4\nf 2 1 3\n")
        said = "2 facets over others in one plane; `clod mesh` says where"
        self.assertIn(said, str(self.check()["notes"]))
        self.assertIn(said, self.run_case())

    def test_wrong_files(self):
        """A message names the case's line, the file, and what there is instead."""
        self.case(1)
        with open(self.path("sheet.obj"), "a") as file:
            file.write("o lip\nf 1 2 3\n")
        for old, new, key, said in (
                ("sheet.obj", "none.obj", "55: walls.sheet.shapes.0.mesh.file: ", "none.obj: cannot be opened: No such file or directory; "
                                          "its path is taken from the folder of the case file"),
                ("sheet.obj", "grains.csv", "55: walls.sheet.shapes.0.mesh.file: ", "grains.csv: the name must end in .stl, .obj or .ply"),
                ("unit: 1 m", "unit: 1 m, parts: {hood: {material: ore}}",
                 "85: walls.sheet.shapes.0.mesh.parts.hood: ", "the mesh " + self.path("sheet.obj") + " has no part of this name; "
                 "its parts are lip")):
            with open(self.path("case.yaml"), "w") as file:
                file.write(CASE.format(unit="1 m", more="").replace(old, new))
            done = clod.run("check", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 2)
            self.assertIn("clod check: case.yaml:6:" + key, done.stderr)
            self.assertIn(said, done.stderr)


    def test_two_walls_with_one_face(self):
        """Both say it, in the same words; of one wall with both sheets, nobody."""
        shapes = "[{mesh: {file: sheet.obj, unit: 1 m}}]"
        for more, count in ((f"}}, lid: {{material: ore, shapes: {shapes}", 1), ("", 0)):
            self.case(2, more=more)
            told = [text for text in self.check()["warnings"] if "one plane" in text]
            self.assertEqual(len(told), count)
            for text in told:
                self.assertIn(": walls.lid: 8 of its facets lie in one plane with facets of walls.sheet", text)
            ran = [line for line in self.run_case().splitlines() if "one plane" in line]
            self.assertEqual(ran, ["clod: warning: " + text for text in told])


    def test_a_unit_alone_is_one_of_it(self):
        """As clod mesh --unit takes it; the editor's schema too."""
        for unit in ("um", "1 um"):
            self.case(2, unit=unit)
            self.assertIn("sheet.obj: The mesh is 4e-07 m long", str(self.check()["warnings"]), unit)
        wall = json.loads(clod.run("schema").stdout)["properties"]["walls"]["patternProperties"]
        shape = next(iter(wall.values()))["properties"]["shapes"]["items"]["properties"]
        pattern = shape["mesh"]["properties"]["unit"]["anyOf"][0]["pattern"]
        for text, fits in (("mm", True), ("25.4 mm", True), ("in", True), ("3", False), ("", False)):
            self.assertEqual(re.search(pattern, text) is not None, fits, text)
        for unit, words in (("kg", '"kg" is not a number; write for instance 1 mm'), ("mmm", '"mmm" is not a number')):
            self.case(2, unit=unit)
            done = clod.run("check", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    clod.main()
