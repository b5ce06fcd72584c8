"""Inlets of one region: the mix of materials and sizes that comes, free and blocked; room."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = """\
materials: {{ore: {{density: 2500 kg/m3}}, steel: {{density: 7800 kg/m3}}}}
contacts: {{default: {{law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}}}
time: {{step: 1e-4 s, design_stress: 100 Pa}}
domain: {{min: [-0.1 m, -0.1 m, -0.3 m], max: [0.1 m, 0.1 m, 0.1 m], open: delete}}
grains:
{groups}
{walls}
stages: [{{name: run, duration: {duration} s}}]
output: {{series_interval: 20 ms}}
"""
GROUP = """\
  - material: {material}
    radius: {{distribution: uniform, min: {least} mm, max: {most} mm}}
    inlet: {{{inlet}}}
    region: {region}
    velocity: [0 m/s, 0 m/s, -1 m/s]
"""
BOX = "{box: {min: [-50 mm, -50 mm, -20 mm], max: [50 mm, 50 mm, 20 mm]}}"
# A tight box: what comes stays in it, and soon there is no room.
WALL = """\
walls:
  floor: {material: ore, shapes: [{plane: {point: [0 m, 0 m, -25 mm]}}]}
  sides:
    material: ore
    shapes:
      - plane: {point: [-55 mm, 0 m, 0 m], normal: [1, 0, 0]}
      - plane: {point: [55 mm, 0 m, 0 m], normal: [-1, 0, 0]}
      - plane: {point: [0 m, -55 mm, 0 m], normal: [0, 1, 0]}
      - plane: {point: [0 m, 55 mm, 0 m], normal: [0, -1, 0]}
"""
DENSITY = {"ore": 2500.0, "steel": 7800.0}


def group(material, inlet, least=3.0, most=3.5, region=BOX):
    return GROUP.format(material=material, inlet=inlet, least=least, most=most, region=region)


def ball(material, radius):
    """kg; radius in mm"""
    return DENSITY[material] * 4 / 3 * math.pi * (1e-3 * radius)**3


class Mix(clod.Case):

    def write(self, *groups, walls="", duration=1.2):
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(groups="".join(groups), walls=walls, duration=duration))

    def refused(self, *words):
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stdout)
        for word in words:
            self.assertIn(word, done.stderr)

    @clod.quick_only
    def test_the_mix_while_it_flows(self):
        """5 and 3 kg/s of two materials: each to half a grain and a ms, over a second 0.1 %."""
        self.write(group("ore", "mass_flow: 5 kg/s"),
                   group("steel", "mass_flow: 3 kg/s", least=3.0, most=4.0))
        self.go("out")
        at = {round(row["time"], 3): row for row in self.rows("out")}
        for k, (flow, heavy) in enumerate(((5.0, ball("ore", 3.5)), (3.0, ball("steel", 2.5)))):
            came = at[1.2][f"inlet_{k + 1}.mass"] - at[0.2][f"inlet_{k + 1}.mass"]
            self.assertLess(abs(came - flow), max(1e-3 * flow, heavy))
            for row in at.values():
                self.assertEqual(row[f"inlet_{k + 1}.backlog"], 0.0)
        # radii are uniform, so their numbers follow from the mean of r^3
        mean = ball("steel", 1.0) * (4.0**4 - 3.0**4) / 4.0
        count = at[1.2]["inlet_2.grains"]
        expected = 3.0 * 1.2 / mean
        # standard deviation of a mean of r^3, over its mean
        scatter = math.sqrt((4.0**7 - 3.0**7) / 7.0 / ((4.0**4 - 3.0**4) / 4.0)**2 - 1.0)
        self.assertLess(abs(count / expected - 1.0), 4.0 * scatter / math.sqrt(expected))

    def test_the_mix_while_it_waits(self):
        """What is in the box has the mix of the flows, by mass and by number, at every row."""
        self.write(group("ore", "mass_flow: 2 kg/s"), group("steel", "mass_flow: 4 kg/s"),
                   group("ore", "number_flow: 2000 1/s", least=3.0, most=3.2),
                   walls=WALL, duration=0.3)
        done = self.go("out")
        self.assertIn("was blocked at ", done.stdout)
        rows = self.rows("out")
        self.assertGreater(rows[-1]["inlet_2.backlog"], 0.3)
        heavy = ball("steel", 3.5)
        for row in rows:
            # one of them may be half a grain ahead of its flow, the other one behind
            self.assertLess(abs(2.0 * row["inlet_1.mass"] - row["inlet_2.mass"]),
                            2.0 * ball("ore", 3.5) + heavy)
            self.assertLess(abs(2000.0 * row["inlet_1.mass"] / 2.0 - row["inlet_3.grains"]),
                            2000.0 / 2.0 * ball("ore", 3.5) + 1.0)
        inlets = self.summary("out")["inlets"]
        for inlet in inlets:
            self.assertGreater(inlet["blocked_insertions"], 100)

    def summary(self, folder):
        with open(self.path(folder + "/summary.json")) as file:
            return json.load(file)

    def test_inlets_apart_do_not_wait_for_each_other(self):
        """The right one has a lid of its own in the way; the left one flows on."""
        left = "{box: {min: [-50 mm, -50 mm, -20 mm], max: [0 mm, 50 mm, 20 mm]}}"
        right = "{box: {min: [0 mm, -50 mm, -20 mm], max: [50 mm, 50 mm, 20 mm]}}"
        lid = ("walls: {lid: {material: ore, shapes: [{box: {center: [25 mm, 0 m, 0 m], "
               "size: [48 mm, 98 mm, 38 mm]}}]}}")
        self.write(group("ore", "mass_flow: 1 kg/s", region=left),
                   group("ore", "mass_flow: 1 kg/s", region=right), walls=lid, duration=0.1)
        self.go("out")
        last = self.rows("out")[-1]
        self.assertLess(abs(last["inlet_1.mass"] - 0.1), ball("ore", 3.5) + 1e-3)
        self.assertEqual(last["inlet_1.backlog"], 0.0)
        self.assertEqual(last["inlet_2.grains"], 0)
        self.assertLess(abs(last["inlet_2.backlog"] - 0.1), 1.1e-3)

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(group("ore", "mass_flow: 2 kg/s"), group("steel", "mass_flow: 4 kg/s"),
                   walls=WALL, duration=0.2)
        self.go("one")
        self.go("two", "2")
        self.stop_after(3, "cut")
        self.go("cut")
        for name in ("series.csv", "snap_000000.hdf"):
            whole = clod.read(self.path("one/" + name))
            self.assertEqual(whole, clod.read(self.path("two/" + name)))
            self.assertEqual(whole, clod.read(self.path("cut/" + name)))

    def test_the_room_of_all_that_share_a_region(self):
        """0.01 m2 at 1 m/s, faster as they fall through 40 mm: 7.3 kg/s of ore are a quarter of it, by any group or all."""
        time = (math.sqrt(1 + 2 * 9.81 * 0.04) - 1) / 9.81  # through the region
        quarter = 0.25 * 0.01 * 0.04 / time  # m3/s
        half = quarter * 2500 / 2

        def ore(flow, rest=""):
            return group("ore", f"mass_flow: {flow:.17g} kg/s{rest}")

        self.write(ore(1.99 * half))
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.write(ore(1.024 * half), ore(1.024 * half))
        self.refused("with the other in its region", f"at most {half:.4g} kg/s", "case.yaml:13:")
        self.write(ore(1.024 * half), ore(1.024 * half, ", start: 0.5 s, end: 0.6 s"))
        self.refused("with the other in its region", "case.yaml:13:")
        self.write(ore(1.024 * half, ", end: 0.5 s"), ore(1.024 * half, ", start: 0.5 s"))
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        # by number: mean volume of uniform radii
        volume = 4 / 3 * math.pi * 1e-9 * (3.5**4 - 3.0**4) / 4.0 / 0.5
        most = quarter / volume
        self.write(group("ore", f"number_flow: {0.99 * most} 1/s"))
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.write(group("ore", f"number_flow: {1.01 * most} 1/s"))
        self.refused("solid fraction", f"at most {most:.4g} grains/s", "inlet.number_flow")


if __name__ == "__main__":
    clod.main()
