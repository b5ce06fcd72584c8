"""Outlets that are surfaces: a plate, a moving plate, a part of a mesh; books; same bytes."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

# Grains fall from 20 mm above and below the origin with 1 m/s onto what is at -0.2 m.
CASE = """\
materials: {{ore: {{density: 2500 kg/m3}}}}
contacts: {{default: {{law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {{step: 1e-4 s, design_stress: 100 Pa}}
domain: {{min: [-0.2 m, -0.2 m, -0.3 m], max: [0.2 m, 0.2 m, 0.1 m], open: delete}}
grains:
  - material: ore
    radius: {{distribution: uniform, min: {least} mm, max: 5 mm}}
    inlet: {{mass_flow: 1 kg/s, end: {end} s}}
    region: {{box: {{min: [-80 mm, -80 mm, -20 mm], max: [80 mm, 80 mm, 20 mm]}}}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
walls:
{walls}
outlets: {outlets}
stages: [{{name: run, duration: {duration} s}}]
output: {{series_interval: 20 ms, energy: true, leavers: true, steady_since: 0 s}}
"""
PLATE = """\
  plate: {material: ore, shapes: [{box: {center: [0 m, 0 m, -0.205 m], size: [0.3 m, 0.3 m, 10 mm]}}]}
"""
# Two plates side by side, in one file; y is up to 0.1 m.
MESH = """\
o left
v -100 -100 -200
v 0 -100 -200
v 0 100 -200
v -100 100 -200
f 1 2 3
f 1 3 4
o right
v 10 -100 -220
v 110 -100 -220
v 110 100 -220
v 10 100 -220
f 5 6 7
f 5 7 8
"""
SHEET = """\
  sheet: {material: ore, shapes: [{mesh: {file: sheet.obj, unit: 1 mm}}]}
"""
BELT = """\
  feed:
    material: ore
    shapes:
      - belt: {from: [-0.15 m, 0 m, -0.2 m], runs: [{length: 0.15 m}], width: 0.1 m, speed: 1 m/s,
               pulley: {radius: 30 mm, wrap: 200 deg, return: 50 mm},
               skirts: {to: 0.1 m, distance: 80 mm, height: 20 mm, gap: 2 mm}}
"""
SIDES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")


class OutletWalls(clod.Case):

    def write(self, walls=PLATE, outlets="{plate: {wall: plate}}", duration=0.6, end=0.4,
              least=4.0):
        with open(self.path("sheet.obj"), "w") as file:
            file.write(MESH)
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(walls=walls, outlets=outlets, duration=duration, end=end,
                                   least=least))

    def balanced(self, folder, outlets):
        """Every grain is in the books at every row; returns the last row."""
        rows = self.rows(folder)
        before = {"time": 0}
        for row in rows:
            out = sum(row[f"outlet_{name}.grains"] for name in outlets)
            out += sum(row[f"left_{side}.grains"] for side in SIDES)
            self.assertEqual(row["balance.in"], row["inlet_1.grains"])
            self.assertEqual(row["balance.out"], out)
            self.assertEqual(row["balance.inside"], row["grains"])
            self.assertEqual(row["balance.in"], row["balance.out"] + row["balance.inside"])
            self.assertEqual(row["balance.lost"], 0)
            self.assertLess(abs(row["balance.lost_mass"]), 1e-12)
            self.check_flows(before, row, outlets)
            before = row
        return rows[-1]

    def check_flows(self, before, row, outlets):
        """Flows are what came and left since the row before, by the counters of inlet and outlets."""
        ways = [f"outlet_{name}" for name in outlets], [f"left_{side}" for side in SIDES]
        columns = {"in": ["inlet_1"], "out": ways[0] + ways[1], "spilled": ways[1]}
        for name, parts in columns.items():
            flow = row[f"balance_{name}.mass_flow"]
            gain = sum(row[part + ".mass"] - before.get(part + ".mass", 0) for part in parts)
            self.assertAlmostEqual(flow, gain / (row["time"] - before["time"]), delta=1e-10)

    def test_a_plate_takes_what_touches_it(self):
        """All that come; their energy is that of the fall until they touch, and a lag of less than
        a radius; nothing bounces or rests; energy and momentum books close."""
        self.write()
        done = self.go("out")
        last = self.balanced("out", ["plate"])
        self.assertEqual(last["outlet_plate.grains"], last["inlet_1.grains"])
        self.assertAlmostEqual(last["outlet_plate.mass"], last["inlet_1.mass"], delta=1e-12)
        self.assertGreater(last["outlet_plate.grains"], 300)
        # centres come at 0 m on the mean, and touch at -0.2 m + r
        low = 0.5 + 9.81 * (0.2 - 0.005 - 0.001)
        self.assertGreater(last["outlet_plate.energy"] / last["outlet_plate.mass"], low)
        self.assertLess(last["outlet_plate.energy"] / last["outlet_plate.mass"],
                        low + 9.81 * (0.0025 + 0.002))
        self.assertEqual(last["left_z_min.grains"], 0)
        self.assertEqual(last["plate.force_z"], 0.0)  # it pushes nothing
        for row in clod.table(self.path("out/energy.csv")):
            # no surface is touched; a few grains touch each other where they come in
            self.assertLess(abs(row["residual_of_flow"]), 1e-5)
        self.assertIn("outlet plate", done.stdout)
        with open(self.path("out/leavers.csv")) as file:
            ways = {line.rsplit(",", 1)[1].strip() for line in file.readlines()[1:]}
        self.assertEqual(ways, {"outlet_plate"})

    def test_fine_grains_do_not_pass_a_thin_moving_disc(self):
        """Grains from 0.3 mm to 5 mm in radius, and a disc without thickness that comes to meet
        them at 1 m/s."""
        self.write("  plate: {material: ore, velocity: [0 m/s, 0 m/s, 1 m/s], shapes: [{disc: "
                   "{center: [0 m, 0 m, -0.29 m], radius: 0.15 m}}]}\n", duration=0.15, end=0.12,
                   least=0.3)
        self.go("out", "1", "--set", "contacts.default.k1=1e3 N/m", "--set", "time.step=1e-5 s",
                "--set", "time.overlap_limit=60 %")
        last = self.balanced("out", ["plate"])
        self.assertGreater(last["outlet_plate.grains"], 20)
        for side in SIDES:
            self.assertEqual(last[f"left_{side}.grains"], 0)

    def test_a_part_of_a_mesh(self):
        """What falls at the left is taken, what falls at the right lies on the other part."""
        self.write(SHEET, "{left: {wall: sheet, part: left}}", end=0.2, duration=0.4)
        self.go("out")
        last = self.balanced("out", ["left"])
        self.assertGreater(last["outlet_left.grains"], 100)
        with open(self.path("out/summary.json")) as file:
            summary = json.load(file)
        self.assertGreater(summary["grains"], 30)  # on the right part, and on their way off it
        self.assertLess(last["sheet.force_z"], -0.3 * (last["inlet_1.mass"] -
                                                       last["outlet_left.mass"]) * 9.81)
        self.go("all", "1", "--set", "outlets={all: {wall: sheet}}")
        both = self.balanced("all", ["all"])
        # the gap between them is as wide as the largest grain
        self.assertGreater(both["outlet_all.grains"], 0.97 * both["inlet_1.grains"])
        self.assertGreater(both["outlet_all.grains"], last["outlet_left.grains"] + 50)

    def test_a_run_goes_on_with_other_outlets(self):
        """A plate that removes nothing at first, and all that touch it in the run from there."""
        self.write(outlets="{far: {region: {box: {min: [-0.2 m, -0.2 m, -0.3 m], max: [0.2 m, 0.2 m, "
                   "-0.29 m]}}}}", duration=0.3, end=0.2)
        self.go("first")
        there = self.rows("first")[-1]["grains"]
        self.assertGreater(there, 100)
        self.write(duration=0.4, end=0.0001)
        self.go("on", "1", "--from", "first")
        last = self.rows("on")[-1]
        self.assertEqual(last["outlet_plate.grains"] + last["grains"] +
                         sum(last[f"left_{side}.grains"] for side in SIDES),
                         there + last["inlet_1.grains"])
        self.assertGreater(last["outlet_plate.grains"], 0.9 * there)
        self.assertEqual(last["left_z_min.grains"], 0)
        self.write(outlets="{all: {region: {box: {min: [-0.2 m, -0.2 m, -0.3 m], max: [0.2 m, 0.2 m, "
                   "-0.03 m]}}}}", duration=0.35, end=0.0001)
        self.go("region", "1", "--from", "first")
        self.assertGreater(self.rows("region")[-1]["outlet_all.grains"], 0.9 * there)

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(SHEET, "{left: {wall: sheet, part: left}, low: {region: {box: {min: [-0.2 m, "
                   "-0.2 m, -0.3 m], max: [0.2 m, 0.2 m, -0.25 m]}}}}", duration=0.4)
        self.go("one")
        self.go("two", "2")
        self.stop_after(13, "cut")
        self.go("cut")
        self.assertGreater(self.rows("one")[-1]["outlet_low.grains"], 0)
        for name in ("series.csv", "leavers.csv", "snap_000000.hdf"):
            whole = clod.read(self.path("one/" + name))
            self.assertEqual(whole, clod.read(self.path("two/" + name)))
            self.assertEqual(whole, clod.read(self.path("cut/" + name)))

    def test_wrong_ones_are_explained(self):
        loaded = PLATE.replace("material: ore,", "material: ore, load: {axis: [0, 0, -1], "
                               "force: 1 N, mass: 1 kg},")
        for walls, outlets, words in (
                (PLATE, "{o: {wall: late}}", "'late' is not the name of a wall; did you mean plate?"),
                (PLATE, "{o: {wall: hopper}}", "'hopper' is not the name of a wall; walls are plate"),
                (BELT, "{o: {wall: feed, part: top}}",
                 "walls.feed has no part 'top'; its parts are run 1, pulley, return, skirts"),
                (PLATE, "{o: {}}", "must have exactly one of region, wall"),
                (PLATE, "{o: {spillage: true}}", "must have exactly one of region, wall"),
                (PLATE, "{o: {wall: plate, part: left}}", "walls.plate has no part 'left', and no named part at all"),
                (SHEET, "{o: {wall: sheet, part: up}}", "walls.sheet has no part 'up'; its parts are left, right"),
                (SHEET, "{a: {wall: sheet}, o: {wall: sheet, part: left}}",
                 "belongs to another outlet already"),
                (loaded, "{o: {wall: plate}}", "has a load")):
            self.write(walls, outlets)
            done = clod.run("check", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 2, outlets)
            self.assertIn(words, done.stderr)
            self.assertEqual(done.stderr.count("clod check: "), 1, done.stderr)


if __name__ == "__main__":
    clod.main()
