"""Errors found after a case was read, while walls and grains are made, tell file, line and column, and show the
line with a caret, as those of the reader do. Expected: places counted by hand in the text below."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
domain: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.1 m]}
walls:
  floor:
    material: ore
    shapes:
      - plane: {point: [0 m, 0 m, -50 mm], normal: [0, 0, 1]}
grains:
  - material: ore
    count: 10
    radius: {distribution: uniform, min: 5 mm, max: 6 mm}
    region: {box: {min: [-50 mm, -50 mm, -50 mm], max: [50 mm, 50 mm, 50 mm]}}
stages: [{name: run, duration: 1 ms}]
time: {step: 1e-5 s}
output: {series_interval: 1 ms, snapshot_interval: 1 ms}
"""


class SetupErrors(clod.Case):

    def refused(self, text, start, line, caret, *arguments):
        """clod check and clod run say the same: place and beginning, the line and the caret under it."""
        with open(self.path("case.yaml"), "w") as file:
            file.write(text)
        for verb in (["check"], ["run", "--fresh", "-o", "out"]):
            done = clod.run(*verb, *arguments, "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            said = done.stderr.splitlines()
            self.assertTrue(said[0].startswith(f"clod {verb[0]}: {start}"), done.stderr)
            self.assertEqual(said[1:3], [f"  {line}", f"  {caret}"] if line else [], done.stderr)

    def change(self, old, new):
        self.assertEqual(CASE.count(old), 1)
        return CASE.replace(old, new)

    def test_a_plane_that_cannot_turn(self):
        self.refused(self.change("floor:\n", "floor:\n    spin: 1 rad/s\n    spin_axis: [1, 0, 0]\n"),
                     "case.yaml:11:9: walls.floor.shapes.0: an endless plane can turn only about",
                     "      - plane: {point: [0 m, 0 m, -50 mm], normal: [0, 0, 1]}",
                     "        ^")

    def test_a_wall_that_oscillates_too_fast(self):
        """A period of 0.1 ms has 10 steps."""
        self.refused(self.change("floor:\n", "floor:\n    oscillation: {amplitude: 1 um, direction: [0, 0, 1], "
                                             "frequency: 1e4 Hz}\n"),
                     "case.yaml:7:69: walls.floor.oscillation.frequency: 10000 Hz is too fast",
                     "    oscillation: {amplitude: 1 um, direction: [0, 0, 1], frequency: 1e4 Hz}",
                     " " * 68 + "^~~~~~")

    def test_grains_that_do_not_fit(self):
        """3000 grains of 11 mm do not go into 0.1 m. The place is that of the group."""
        self.refused(self.change("count: 10\n", "count: 3000\n"), "case.yaml:11:5: grains.0: only ",
                     "  - material: ore", "    ^")

    def test_a_mass_below_that_of_a_grain(self):
        """The smallest grain has 1.3 g."""
        self.refused(self.change("count: 10\n", "mass: 1e-6 kg\n"), "case.yaml:12:11: grains.0.mass: asks for ",
                     "    mass: 1e-6 kg", "          ^~~~~~~")
        self.refused(CASE, "--set grains=", "", "",
                     "--set", "grains=[{material: ore, mass: 1e-6 kg, radius: {distribution: uniform, min: 5 mm, "
                     "max: 6 mm}, region: {box: {min: [0 m, 0 m, 0 m], max: [50 mm, 50 mm, 50 mm]}}}]")

    def test_a_period_that_is_too_short(self):
        """20 mm for grains of 11 mm; at least 4.6 largest radii are needed."""
        text = CASE.replace("min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m,", "min: [0 m, -0.1 m, -0.1 m], max: [20 mm,")
        text = text.replace("0.1 m, 0.1 m]}\nwalls", "0.1 m, 0.1 m], periodic: [true, false, false]}\nwalls")
        text = text.replace("box: {min: [-50 mm, -50 mm, -50 mm], max: [50 mm,",
                            "box: {min: [0 mm, -50 mm, -50 mm], max: [20 mm,")
        self.refused(text, "case.yaml:4:1: domain: the period along x is 0.02 m",
                     "domain: {min: [0 m, -0.1 m, -0.1 m], max: [20 mm, 0.1 m, 0.1 m], "
                     "periodic: [true, false, false]}", "^~~~~~")

    def test_a_mesh_of_an_included_file(self):
        """The place is in the file in which the mesh is named."""
        wall, rest = CASE.split("walls:\n")[1].split("grains:\n")
        with open(self.path("walls.yaml"), "w") as file:
            file.write("walls:\n" + wall + "      - mesh: {file: none.obj, unit: 1 mm}\n")
        name = self.path("walls.yaml")
        self.refused(CASE.split("walls:\n")[0] + "include: walls.yaml\ngrains:\n" + rest,
                     f"{name}:6:22: walls.floor.shapes.1.mesh.file: {self.path('none.obj')}: cannot be opened",
                     "      - mesh: {file: none.obj, unit: 1 mm}", " " * 21 + "^~~~~~~~")


if __name__ == "__main__":
    clod.main()
