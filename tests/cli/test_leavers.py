"""domain.open: delete: grains that cross an open side are removed and counted, by side."""

import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

# 40 grains roll off a plate of 20 mm x 20 mm and fall through the floor of the domain; the
# domain repeats itself along y.
CASE = """\
materials: {{ore: {{density: 2500 kg/m3}}, steel: {{}}}}
contacts:
  default: {{law: hooke, k1: 2e4 N/m, restitution: 0.6, friction: 0.2}}
time: {{step: 1e-5 s}}
domain: {{min: [-40 mm, -20 mm, -30 mm], max: [40 mm, 20 mm, 200 mm],
         periodic: [false, true, false]{open}}}
grains:
  - material: ore
    count: 40
    radius: {{distribution: uniform, min: 2 mm, max: 2 mm}}
    region: {{box: {{min: [-10 mm, -10 mm, 4 mm], max: [10 mm, 10 mm, 60 mm]}}}}
walls:
  plate: {{material: steel, shapes: [{{box: {{center: [0 mm, 0 mm, 0 mm], size: [20 mm, 20 mm, 4 mm]}}}}],
          velocity: [0.4 m/s, 0 m/s, 0 m/s]}}
stages: [{{name: fall, duration: 0.3 s}}]
output: {{series_interval: 10 ms, energy: true}}
"""
SIDES = ("x_min", "x_max", "z_min", "z_max")


# One grain falls from 0.1 m at 1 m/s, so it is below the floor of the domain at 73.8 ms: 1 m/s t +
# g t^2/2 = 0.1005 m. The other one stays.
FALL = """\
materials: {ore: {density: 2500 kg/m3}}
contacts:
  default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {step: 1e-5 s}
domain: {min: [-0.1 m, -0.1 m, 0 m], max: [0.1 m, 0.1 m, 0.2 m], open: delete}
grains:
  - material: ore
    count: 1
    radius: {distribution: uniform, min: 5 mm, max: 5.0001 mm}
    region: {box: {min: [-5.1 mm, -5.1 mm, 94.9 mm], max: [5.1 mm, 5.1 mm, 105.2 mm]}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
  - material: ore
    count: 1
    radius: {distribution: uniform, min: 5 mm, max: 5.0001 mm}
    region: {box: {min: [50 mm, 50 mm, 184 mm], max: [61 mm, 61 mm, 195 mm]}}
stages: [{name: run, duration: 73.8 ms}]
output: {series_interval: 1 ms}
"""


class Leavers(clod.Case):

    def write(self, mode):
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(open=mode))

    def go(self, folder, threads="1", *options):
        return clod.run("run", "case.yaml", "-o", folder, "-t", threads, *options,
                        cwd=self.folder)

    def test_counts(self):
        """All that went in is inside or left, in every row; the books of energy close."""
        self.write(", open: delete")
        done = self.go("out")
        self.assertEqual(done.returncode, 0, done.stderr)
        mass = 2500 * 4 / 3 * 3.141592653589793 * 2e-3**3
        rows = clod.table(self.path("out/series.csv"))
        for row in rows:
            left = sum(row[f"left_{side}.grains"] for side in SIDES)
            self.assertEqual(row["grains"] + left, 40)
            for side in SIDES:
                self.assertAlmostEqual(row[f"left_{side}.mass"] / mass,
                                       row[f"left_{side}.grains"], delta=1e-9)
            self.assertNotIn("left_y_min.grains", row)
        self.assertEqual(rows[-1]["grains"], 0)
        self.assertGreater(rows[-1]["left_z_min.energy"], 0)
        with open(self.path("out/summary.json")) as file:
            summary = json.load(file)
        self.assertEqual(sum(side["grains"] for side in summary["left"].values()), 40)
        self.assertEqual(set(summary["left"]), set(SIDES))
        self.assertEqual(summary["grains"], 0)
        self.assertIn("left at z_min", done.stdout)
        for row in clod.table(self.path("out/energy.csv")):
            self.assertLess(abs(row["residual_of_flow"]), 1e-3)

    @clod.quick_only
    def test_threads_change_no_byte(self):
        self.write(", open: delete")
        tables = []
        for threads in ("1", "2"):
            self.assertEqual(self.go("out" + threads, threads).returncode, 0)
            with open(self.path(f"out{threads}/series.csv"), "rb") as file:
                tables.append(file.read())
        self.assertEqual(*tables)

    def test_without_it_the_run_stops(self):
        self.write("")
        done = self.go("out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("has left the domain: ", done.stderr)
        self.assertIn("set domain.open: delete", done.stderr)

    def test_a_run_goes_on_with_a_grain_that_is_about_to_go(self):
        with open(self.path("case.yaml"), "w") as file:
            file.write(FALL)
        self.assertEqual(self.go("first").returncode, 0)
        self.assertEqual(clod.table(self.path("first/series.csv"))[-1]["grains"], 2)
        done = self.go("second", "1", "--from", "first")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(clod.table(self.path("second/series.csv"))[-1]["left_z_min.grains"], 1)

    def test_a_wrong_word_is_explained(self):
        self.write(", open: remove")
        done = self.go("out")
        self.assertEqual(done.returncode, 2)
        self.assertIn("stop", done.stderr)
        self.assertIn("delete", done.stderr)


if __name__ == "__main__":
    clod.main()
