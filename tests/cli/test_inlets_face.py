"""Inlets through a disc or a rectangle: rate, no contact, blocking, wrong ones."""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = """\
materials: {{ore: {{density: 2500 kg/m3}}}}
contacts: {{default: {{law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}}}
gravity: [0 m/s2, 0 m/s2, 0 m/s2]
time: {{step: 1e-4 s, design_stress: 100 Pa}}
domain: {{min: [-0.3 m, -0.3 m, -0.05 m], max: [0.3 m, 0.3 m, 0.3 m], open: delete}}
grains:
  - material: ore
    radius: {{distribution: uniform, min: 3 mm, max: 4 mm}}
    {inlet}
    velocity: {velocity}
    region: {region}
{walls}
stages: [{{name: run, duration: {duration} s}}]
output: {{series_interval: 20 ms}}
"""
DISC = "{disc: {center: [0 m, 0 m, 0.1 m], radius: 60 mm, normal: [1, 0, -2]}}"
RECTANGLE = ("{rectangle: {center: [0 m, 0 m, 0.1 m], edge_1: [0 mm, 120 mm, 0 mm], "
             "edge_2: [80 mm, 0 mm, 60 mm]}}")
BALL = 2500.0 * 4 / 3 * math.pi * 4e-3**3


class Face(clod.Case):

    def write(self, region, inlet="inlet: {mass_flow: 5 kg/s}", velocity="[1 m/s, 0 m/s, -2 m/s]",
              walls="", duration=1.2):
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(region=region, inlet=inlet, velocity=velocity, walls=walls,
                                   duration=duration))

    def stream(self, region, flow, area):
        """A stream near the limit of room keeps its rate, and no grain touches another one."""
        self.write(region, f"inlet: {{mass_flow: {flow} kg/s}}")
        self.go("out")
        rows = self.rows("out")
        at = {round(row["time"], 3): row for row in rows}
        self.assertLess(abs(at[1.2]["inlet_1.mass"] - at[0.2]["inlet_1.mass"] - flow),
                        1e-3 * flow)
        for row in rows:
            self.assertEqual(row["inlet_1.backlog"], 0.0)
            inside = row["inlet_1.mass"] - sum(row[f"left_{side}.mass"] for side in
                                               ("x_min", "x_max", "y_min", "y_max", "z_min",
                                                "z_max"))
            # all as fast as they came: nothing has pushed them
            self.assertAlmostEqual(row["kinetic_energy"], 0.5 * inside * 5.0,
                                   delta=1e-10 * (1.0 + inside))
        self.assertEqual(self.summary("out")["contacts"], 0)

    @clod.quick_only
    def test_a_disc(self):
        area = math.pi * 0.06**2
        # the normal is along the velocity: solid fraction 0.2 at sqrt(5) m/s
        self.stream(DISC, 0.2 * area * math.sqrt(5.0) * 2500.0, area)

    @clod.quick_only
    def test_a_rectangle(self):
        # normal (0.6, 0, -0.8): 2.2 m/s along it through 120 x 100 mm
        self.stream(RECTANGLE, 0.2 * 0.012 * 2.2 * 2500.0, 0.012)

    @clod.quick_only
    def test_the_same_bytes_on_threads(self):
        self.write(RECTANGLE, duration=0.2)
        self.go("one")
        self.go("two", "2")
        for name in ("series.csv", "snap_000000.hdf"):
            self.assertEqual(clod.read(self.path("one/" + name)),
                             clod.read(self.path("two/" + name)))

    def test_a_blocked_face_says_so(self):
        """A plate 30 mm before the face: what comes rests there, and soon the rest waits."""
        self.write("{disc: {center: [0 m, 0 m, 0 m], radius: 60 mm, normal: [0, 0, -1]}}",
                   "inlet: {mass_flow: 5 kg/s}", "[0 m/s, 0 m/s, -1 m/s]",
                   "walls: {box: {material: ore, shapes: [{plane: {point: [0 m, 0 m, -30 mm]}}, "
                   "{cylinder: {foot: [0 m, 0 m, -30 mm], radius: 65 mm, length: 60 mm}}]}}", 0.4)
        done = self.go("out")
        self.assertIn("was blocked at ", done.stdout)
        inlet = self.summary("out")["inlets"][0]
        self.assertGreater(inlet["blocked_since_s"], 0.03)
        last = self.rows("out")[-1]
        self.assertLess(abs(last["inlet_1.mass"] + last["inlet_1.backlog"] - 2.0), 5.1e-3)

    def test_wrong_faces_are_explained(self):
        for region, inlet, velocity, words in (
                (DISC, "inlet: {mass_flow: 5 kg/s}", "[-1 m/s, 0 m/s, 2 m/s]",
                 "must lead through the face"),
                (DISC, "inlet: {mass_flow: 5 kg/s}", "[0 m/s, 0 m/s, 0 m/s]",
                 "must lead through the face"),
                (DISC, "count: 10", "[1 m/s, 0 m/s, -2 m/s]", "only grains of an inlet"),
                (DISC, "inlet: {mass_flow: 20 kg/s}", "[1 m/s, 0 m/s, -2 m/s]",
                 "solid fraction of 0.32"),  # 20/2500/(pi 0.06^2 sqrt(5))
                (RECTANGLE.replace("[0 mm, 120", "[9 mm, 120"), "inlet: {mass_flow: 5 kg/s}",
                 "[1 m/s, 0 m/s, -2 m/s]", "at a right angle to edge_1")):
            self.write(region, inlet, velocity)
            done = clod.run("check", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 2, region)
            self.assertIn(words, done.stderr)
        self.write(DISC)
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        # only grains come through faces
        with open(self.path("case.yaml"), "a") as file:
            file.write("outlets: {o: {region: " + DISC + "}}\n")
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("disc", done.stderr)


if __name__ == "__main__":
    clod.main()
