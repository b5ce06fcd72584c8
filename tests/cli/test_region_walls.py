"""clod check and clod run warn of a wall through the region of an inlet, and refuse a region that no grain can reach.

The plate cuts the region in the middle; moved up by half the region's height less than a grain's diameter it does not.
"""

import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}
walls:
  hood:
    material: ore
    shapes:
      - plane: {point: [0 m, 0 m, -0.5 m], normal: [0, 0, 1]}
      - mesh: {file: plate.obj, unit: 1 mm, move: [0 m, 0 m, HEIGHT]}
grains:
  - material: ore
    radius: {distribution: uniform, min: 5 mm, max: 6 mm}
    region: {box: {min: [-50 mm, -50 mm, -50 mm], max: [50 mm, 50 mm, 50 mm]}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
    inlet: {mass_flow: 1 kg/s}
stages: [{name: run, duration: 2 ms}]
time: {step: 1e-5 s, design_stress: 1 kPa}
output: {series_interval: 1 ms, snapshot_interval: 1 ms}
"""
TOLD = "case.yaml:14:5: grains.0.region: walls.hood.shapes.1, part plate reaches through it, at "


class RegionWalls(clod.Case):

    def case(self, height, old="", new=""):
        with open(self.path("plate.obj"), "w") as file:
            file.write("o plate\nv -200 -200 0\nv 200 -200 0\nv 200 200 0\nv -200 200 0\nf 1 2 3\nf 1 3 4\n")
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.replace("HEIGHT", height).replace(old, new))

    def told(self):
        """What check and run say of the region."""
        done = clod.run("check", "--json", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        checked = [text for text in json.loads(done.stdout)["warnings"] if "reaches through" in text]
        done = clod.run("run", "--fresh", "-o", "out", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        ran = [line for line in done.stderr.splitlines() if "reaches through" in line]
        self.assertEqual(ran, ["clod: warning: " + text for text in checked])
        return checked

    def test_a_plate_through_an_inlet(self):
        self.case("0 m")
        told = self.told()
        self.assertEqual(len(told), 1)
        self.assertTrue(told[0].startswith(TOLD), told)
        self.assertIn("grains come on both sides of it", told[0])

    def test_a_plate_near_the_side(self):
        """41 mm of 50: less than a grain of 10 mm is left above it."""
        self.case("41 mm")
        self.assertEqual(self.told(), [])

    def test_a_region_behind_a_plane(self):
        self.case("0 m", "[0 m, 0 m, -0.5 m], normal: [0, 0, 1]", "[0 m, 0 m, -0.5 m], normal: [0, 0, -1]")
        for verb in (["check"], ["run", "--fresh", "-o", "out"]):
            done = clod.run(*verb, "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr.rstrip("\n").splitlines(), [
                f"clod {verb[0]}: case.yaml:14:5: grains.0.region: all of it lies behind the plane walls.hood.shapes.0, "
                "where no grain can be. Move the region, or turn the normal of the plane to it",
                "      region: {box: {min: [-50 mm, -50 mm, -50 mm], max: [50 mm, 50 mm, 50 mm]}}",
                "      ^~~~~~"])


if __name__ == "__main__":
    clod.main()
