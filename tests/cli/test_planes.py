"""Planes of gauges: counts with known answers, balance at an outlet, same bytes, wrong cases."""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

G = 9.81
DENSITY = 2500.0
HEAD = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 1, friction: 0}}
gravity: [0 m/s2, 0 m/s2, GRAVITY m/s2]
time: {step: STEP s, design_stress: 100 Pa}
grains: [{material: ore, file: grains.csv}]
"""
# Grains at rest that fall through two planes; the second gauge has one half of them.
FALL = HEAD.replace("GRAVITY", "-9.81").replace("STEP", "1e-4") + """\
domain: {min: [-0.1 m, -0.1 m, -2 m], max: [0.1 m, 0.1 m, 1.1 m], open: delete}
gauges:
  all:
    region: {box: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.1 m]}}
    direction: [0.1, 0, -2]
    plane: {at: 0 m}
  half:
    region: {box: {min: [-0.1 m, -0.1 m, -0.3 m], max: [0 m, 0.1 m, 0.1 m]}}
    direction: [0, 0, 1]
    plane: {at: -0.2 m}
stages: [{name: run, duration: 0.5 s}]
output: {series_interval: 10 ms}
"""
# A lattice of 40 grains 10 mm apart along x that moves along x, through a periodic box of 100 mm.
FLIGHT = HEAD.replace("GRAVITY", "0").replace("STEP", "1e-4") + """\
domain: {min: [0 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.1 m], periodic: [true, false, false]}
gauges:
GAUGES
stages: [{name: run, duration: 0.6 s}]
output: {series_interval: 20 ms, steady_since: 0.2 s}
"""
GAUGE = """\
  NAME:
    region: {box: {min: [0 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.1 m]}}
    direction: [SIGN, 0, 0]
    plane: {at: AT}
"""
# One grain that bounces from a floor without loss.
BOUNCE = HEAD.replace("GRAVITY", "-9.81").replace("STEP", "5e-6") + """\
domain: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.2 m]}
walls: {floor: {material: ore, shapes: [{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}]}}
gauges:
  down:
    region: {box: {min: [-0.1 m, -0.1 m, 0.05 m], max: [0.1 m, 0.1 m, 0.06 m]}}
    direction: [0, 0, -1]
    plane: {at: 55 mm}
stages: [{name: run, duration: 1.4 s}]
output: {series_interval: 10 ms}
"""
# A stream that falls past a bar, from which some of it springs back, and into an outlet.
STREAM = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.9, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {step: 1e-4 s, design_stress: 100 Pa}
domain: {min: [-0.1 m, -0.1 m, -0.3 m], max: [0.1 m, 0.1 m, 0.1 m], periodic: [true, true, false],
  open: delete}
grains:
  - material: ore
    radius: {distribution: uniform, min: 4.5 mm, max: 5.5 mm}
    inlet: {mass_flow: 1 kg/s, end: 0.3 s}
    region: {box: {min: [-80 mm, -80 mm, -20 mm], max: [80 mm, 80 mm, 20 mm]}}
    velocity: [0.3 m/s, 0 m/s, -1 m/s]
walls:
  bar: {material: ore, shapes: [{box: {center: [0 m, 0 m, -0.17 m], size: [40 mm, 0.2 m, 10 mm]}}]}
outlets:
  bin: {region: {box: {min: [-0.1 m, -0.1 m, -0.3 m], max: [0.1 m, 0.1 m, -0.25 m]}}}
gauges:
  below:
    region: {box: {min: [-0.1 m, -0.1 m, -0.4 m], max: [0.1 m, 0.1 m, -0.15 m]}}
    direction: [0, 0, -1]
    plane: {at: -0.15 m}
  mouth:
    region: {box: {min: [-0.1 m, -0.1 m, -0.25 m], max: [0.1 m, 0.1 m, -0.24 m]}}
    direction: [0, 0, -1]
    plane: {at: -0.25 m}
stages: [{name: run, duration: 0.8 s}]
output: {series_interval: 1 ms, steady_since: 0.1 s}
"""


def mass_of(radius):
    return DENSITY * 4.0 / 3.0 * math.pi * radius**3


class Planes(clod.Case):

    def write(self, text, name="case.yaml"):
        with open(self.path(name), "w") as file:
            file.write(text)

    def write_grains(self, rows):
        self.write("x [m],y [m],z [m],radius [m],vx [m/s]\n" +
                   "".join(",".join(repr(v) for v in row) + "\n" for row in rows), "grains.csv")

    def test_free_fall(self):
        """A grain at rest in a height h is below a plane when g t^2/2 > h."""
        heights = [0.05 + 0.043 * k for k in range(20)] + [-0.05, -0.15]  # two are below one already
        grains = [((-0.02, 0.03)[k % 2], 0.02 * (k // 2 % 5 - 2), h, 3e-3 + 1e-4 * k, 0.0)
                  for k, h in enumerate(heights)]
        self.write_grains(grains)
        self.write(FALL)
        done = self.go("out")
        for row in self.rows("out"):
            fallen = G * row["time"]**2 / 2
            passed = [g for g in grains if 0.0 < g[2] < fallen]
            self.assertEqual(row["gauge_all.passed_forward"], len(passed))
            self.assertAlmostEqual(row["gauge_all.mass_forward"],
                                   sum(mass_of(g[3]) for g in passed), delta=1e-15)
            self.assertEqual((row["gauge_all.passed_back"], row["gauge_all.mass_back"]), (0, 0))
            # forward is upwards here, and only the left half counts
            passed = [g for g in grains if g[2] + 0.2 < fallen and g[0] < 0]
            self.assertEqual(row["gauge_half.passed_back"], len(passed))
            self.assertEqual(row["gauge_half.passed_forward"], 0)
        self.assertGreater(len(passed), 8)
        gauges = self.summary("out")["gauges"]
        self.assertEqual(gauges["all"]["passed_forward"], 20)
        self.assertAlmostEqual(gauges["half"]["mass_back_kg"], sum(mass_of(g[3]) for g in passed),
                               delta=1e-15)
        self.assertIn("through z = -0.2 m: 0 grains, 0 kg forward; "
                      f"{len(passed)} grains, {sum(mass_of(g[3]) for g in passed):.6g} kg back",
                      done.stdout)

    def lattice(self):
        self.write_grains([(0.005 + 0.01 * i, 0.03 * j, 0.03 * k, 2e-3, 0.5)
                           for i in range(10) for j in (-1, 1) for k in (-1, 1)])

    def test_a_periodic_box(self):
        """n A v t: 40 grains in 0.1 m at 0.5 m/s are 200 in a second, in 20 ms four, through the side of the domain too."""
        self.lattice()
        places = {"low": "0 m", "inner": "33 mm", "high": "100 mm"}
        gauges = [GAUGE.replace("NAME", name).replace("AT", at).replace("SIGN", sign)
                  for name, at in places.items()
                  for name, sign in ((name, "1"), (name + "_against", "-1"))]
        self.write(FLIGHT.replace("GAUGES", "".join(gauges)))
        self.go("out")
        rows, mass = self.rows("out"), mass_of(2e-3)
        for row in rows:
            time = row["time"]
            # planes at the sides are 5 mm behind grains of the first row, the inner one 8 mm
            for name, off in (("low", 0.005), ("inner", 0.002), ("high", 0.005)):
                passed = 4 * math.floor((0.5 * time + off) / 0.01 + 1e-6)
                self.assertEqual(row[f"gauge_{name}.passed_forward"], passed, (name, time))
                self.assertEqual(row[f"gauge_{name}_against.passed_back"], passed)
                self.assertEqual(row[f"gauge_{name}.passed_back"], 0)
                self.assertEqual(row[f"gauge_{name}_against.passed_forward"], 0)
                self.assertAlmostEqual(row[f"gauge_{name}.mass_forward"], passed * mass, delta=1e-14)
            self.assertAlmostEqual(row["gauge_high.flow_through"], 200 * mass, delta=1e-12)
            self.assertAlmostEqual(row["gauge_high_against.flow_through"], -200 * mass, delta=1e-12)
        self.assertEqual(rows[-1]["gauge_low.passed_forward"], 120)  # three times round
        flow = self.summary("out")["gauges"]["inner"]["flow_through_kg_per_s"]
        self.assertAlmostEqual(flow["mean"], 200 * mass, delta=1e-12)
        self.assertLess(flow["deviation"], 1e-12)  # a block is 40 ms: eight grains

    def test_a_bouncing_grain(self):
        """Down and up by turns, at times of free fall and half an oscillation of the spring."""
        self.write_grains([(0.0, 0.0, 0.105, 5e-3, 0.0)])
        self.write(BOUNCE)
        self.go("out")
        contact = math.pi * math.sqrt(mass_of(5e-3) / 1e4)
        period = 2 * math.sqrt(2 * 0.1 / G) + contact
        down = math.sqrt(2 * 0.05 / G)
        seen = set()
        for row in self.rows("out"):
            turns = [(row["time"] - at) / period for at in (down, period - down)]
            if min(abs(t - round(t)) for t in turns) * period < 2e-3:
                continue  # a passage is due
            counts = tuple(math.floor(t) + 1 for t in turns)
            self.assertEqual((row["gauge_down.passed_forward"], row["gauge_down.passed_back"]),
                             counts, row["time"])
            seen.add(counts)
        self.assertEqual(len(seen), 11)  # nothing, and down and up five times

    def test_what_passes_is_below_or_has_left(self):
        """Net through a plane is what the outlet took and what is between, in every row."""
        self.write(STREAM)
        self.go("out")
        rows = self.rows("out")
        for row, after in zip(rows, rows[1:]):
            net = row["gauge_below.passed_forward"] - row["gauge_below.passed_back"]
            # a row of each millisecond has one sample of the gauge: that at the row before
            self.assertEqual(net, row["outlet_bin.grains"] + after["gauge_below.grains"], row["time"])
        last = rows[-1]
        self.assertGreater(last["gauge_below.passed_back"], 5)  # they spring back from the bar
        self.assertGreater(last["outlet_bin.grains"], 100)
        self.assertEqual(last["gauge_mouth.passed_forward"], last["outlet_bin.grains"])
        self.assertAlmostEqual(last["gauge_mouth.mass_forward"], last["outlet_bin.mass"], delta=1e-12)
        self.assertEqual(last["gauge_mouth.passed_back"], 0)
        # the flow since the last row, and over the blocks
        for before, row in zip(rows, rows[1:]):
            step = row["gauge_below.mass_forward"] - row["gauge_below.mass_back"] \
                - before["gauge_below.mass_forward"] + before["gauge_below.mass_back"]
            self.assertAlmostEqual(row["gauge_below.flow_through"] * 1e-3, step, delta=1e-12)
        begin = next(row for row in rows if abs(row["time"] - 0.1) < 1e-9)
        flow = self.summary("out")["gauges"]["mouth"]["flow_through_kg_per_s"]
        self.assertAlmostEqual(flow["mean"] * 0.7, last["gauge_mouth.mass_forward"]
                               - begin["gauge_mouth.mass_forward"], delta=1e-12)

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(STREAM.replace("1 ms", "3 ms"))
        self.go("one")
        self.go("two", "2")
        self.assert_same_end(self.path("one"), self.path("two"), ("run",))
        self.stop_after(30, "cut")
        self.go("cut", "2")
        self.assertTrue(any(event["event"] == "resume" for event in clod.log(self.path("cut"))))
        for name in ("series.csv", "report.txt"):
            self.assertTrue(os.path.exists(self.path("cut/" + name)))
        self.assertEqual(clod.read(self.path("one/series.csv")), clod.read(self.path("cut/series.csv")))
        self.assertEqual(clod.without_clock(clod.read(self.path("one/summary.json"))),
                         clod.without_clock(clod.read(self.path("cut/summary.json"))))

    def test_grains_of_another_run_begin_with_none(self):
        """They go on where they were; what they passed before does not count."""
        self.lattice()
        self.write(FLIGHT.replace("GAUGES", GAUGE.replace("NAME", "low").replace("AT", "0 m").replace("SIGN", "1")))
        self.go("out")
        self.assertEqual(self.rows("out")[-1]["gauge_low.passed_forward"], 120)
        self.go("next", "1", "--from", self.path("out"))
        rows = self.rows("next")
        self.assertEqual(rows[0]["gauge_low.passed_forward"], 4)  # in its first 20 ms
        self.assertEqual(rows[-1]["gauge_low.passed_forward"], 120)

    def test_wrong_planes(self):
        """Each is told with its place and what to do."""
        self.lattice()
        good = FLIGHT.replace("GAUGES", GAUGE.replace("NAME", "low").replace("AT", "50 mm").replace("SIGN", "1"))
        box = "{box: {min: [0 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.1 m]}}"
        for old, new, text in (
                ("at: 50 mm", "at: 101 mm", "case.yaml:11:17: gauges.low.plane.at: is outside of the region: along x, "
                 "the axis nearest to direction, that reaches from 0 m to 0.1 m; put the plane there"),
                ("at: 50 mm", "at: 50", "needs a unit of length"),
                ("{at: 50 mm}", "{}", "gauges.low.plane: needs the key at"),
                ("{at: 50 mm}", "{at: 50 mm, normal: [1, 0, 0]}", "normal: this key is not known"),
                ("    direction: [1, 0, 0]\n", "", "gauges.low.plane: needs the direction in which grains pass it "
                 "forward, for instance direction: [1, 0, 0]"),
                (box + "\n    direction: [1, 0, 0]\n    plane: {at: 50 mm}",
                 box.replace("-0.1 m]", "-0.4 m]") + "\n    direction: [0, 0, 1]\n    plane: {at: -0.3 m}",
                 "gauges.low.plane.at: is outside of the domain, so no grain passes it: along z, the axis nearest to "
                 "direction, the domain reaches from -0.1 m to 0.1 m")):
            self.assertIn(old, good)
            self.write(good.replace(old, new))
            done = clod.run("check", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(text, done.stderr)
        self.write(good)
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)


    def test_a_plane_behind_the_border_of_an_outlet(self):
        """It is warned of; on the border and beside the outlet it is not."""
        warning = ("case.yaml:25:5: gauges.mouth.plane: lies within outlets.bin, which removes grains at the next "
                   "neighbour list")
        beside = STREAM.replace("bin: {region: {box: {min: [-0.1 m, -0.1 m, -0.3 m]",
                                "bin: {region: {box: {min: [-0.1 m, 0.05 m, -0.3 m]")
        narrow = beside.replace("max: [0.1 m, 0.1 m, -0.24 m]", "max: [0.1 m, 0.05 m, -0.24 m]").replace(
            "min: [-0.1 m, -0.1 m, -0.25 m]", "min: [-0.1 m, -0.1 m, -0.27 m]")
        for text, at, warns in ((STREAM, "-0.25 m", False), (STREAM, "-0.2501 m", True),
                                (STREAM, "-0.24 m", False), (narrow, "-0.26 m", False)):
            self.write(text.replace("min: [-0.1 m, -0.1 m, -0.25 m]", "min: [-0.1 m, -0.1 m, -0.27 m]").replace(
                "plane: {at: -0.25 m}", f"plane: {{at: {at}}}"))
            done = clod.run("check", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(warning in done.stdout + done.stderr, warns, (at, done.stdout, done.stderr))


if __name__ == "__main__":
    clod.main()
