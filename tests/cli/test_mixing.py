"""Mixing index and angle of repose of a free run: grains that were put, same bytes."""

import math
import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

# Grains of a file that lie still.
STILL = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m}}
gravity: [0 m/s2, 0 m/s2, 0 m/s2]
time: {step: 5e-6 s, design_stress: 100 Pa}
domain: {min: [-0.2 m, -0.2 m, -0.1 m], max: [0.2 m, 0.2 m, 0.3 m]}
grains: [{material: ore, file: grains.csv}]
MEASURE
stages: [{name: run, duration: 0.4 ms}]
output: {series_interval: 0.1 ms}
"""
MIXING = """\
mixing:
  size:
    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [120 mm, 120 mm, 120 mm]}}
    cell: 20 mm
    above: 0.95 mm
"""
REPOSE = """\
repose:
  heap: {region: {annulus: {center: [0 mm, 0 mm, 0 mm], outer_radius: 90 mm, height: 100 mm}}, cell: 4 mm}
"""
# Two ores of two sizes fall and roll in a rotating drum.
DRUM = """\
materials: {red: {density: 2500 kg/m3}, blue: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {design_stress: 500 Pa}
domain: {min: [-60 mm, 0 mm, -60 mm], max: [60 mm, 20 mm, 60 mm], periodic: [false, true, false]}
grains:
  - material: red
    count: 150
    radius: {distribution: uniform, min: 2.4 mm, max: 2.6 mm}
    region: {box: {min: [-35 mm, 0 mm, -30 mm], max: [0 mm, 20 mm, 30 mm]}}
  - material: blue
    count: 150
    radius: {distribution: uniform, min: 1.9 mm, max: 2.1 mm}
    region: {box: {min: [0 mm, 0 mm, -30 mm], max: [35 mm, 20 mm, 30 mm]}}
walls:
  drum:
    material: red
    shapes:
      - cylinder: {foot: [0 mm, -5 mm, 0 mm], axis: [0, 1, 0], radius: 50 mm, length: 30 mm, side: inside}
    spin: 60 rpm
    spin_axis: [0, 1, 0]
    spin_point: [0 mm, 0 mm, 0 mm]
mixing:
  ores:
    region: {box: {min: [-50 mm, 0 mm, -50 mm], max: [50 mm, 20 mm, 50 mm]}}
    cell: 12 mm
    material: red
  weighed:
    region: {box: {min: [-50 mm, 0 mm, -50 mm], max: [50 mm, 20 mm, 50 mm]}}
    cell: 12 mm
    material: red
    by: mass
repose:
  surface:
    region: {box: {min: [-50 mm, 0 mm, -50 mm], max: [50 mm, 20 mm, 50 mm]}}
    cell: 6 mm
    direction: [1, 0, 0]
    from: 0 %
    to: 100 %
stages: [{name: turn, duration: 0.6 s}]
output: {series_interval: 20 ms, steady_since: 0.2 s}
"""


class Mixing(clod.Case):

    def write(self, text, name="case.yaml"):
        with open(self.path(name), "w") as file:
            file.write(text)

    def put(self, grains, measure):
        """Run with grains (x, y, z, radius) in mm; the summary."""
        lines = [f"{x:.9g},{y:.9g},{z:.9g},{r:.9g}" for x, y, z, r in grains]
        self.write("\n".join(["x [mm],y [mm],z [mm],radius [mm]", *lines, ""]), "grains.csv")
        self.write(STILL.replace("MEASURE\n", measure))
        self.done = self.go("out", "1", "--fresh")
        return self.summary("out")

    def lattice(self, large):
        """30 x 30 x 30 grains, 125 to a cell; `large` says which."""
        places = [(2.0 + 4.0 * i, 2.0 + 4.0 * j, 2.0 + 4.0 * k)
                  for i in range(30) for j in range(30) for k in range(30)]
        return [(*place, 1.0 if large(place) else 0.9) for place in places]

    def test_segregated_and_random(self):
        """Layers: 0, with S^2 = p (1 - p). By chance: 1 within its scatter, and p (1 - p)/n."""
        layers = self.put(self.lattice(lambda place: place[2] < 40.0), MIXING)["mixing"]["size"]
        self.assertAlmostEqual(layers["share"], 1.0 / 3.0, delta=1e-12)
        self.assertAlmostEqual(layers["variance"], 2.0 / 9.0, delta=1e-12)
        self.assertAlmostEqual(layers["segregated_variance"], 2.0 / 9.0, delta=1e-12)
        self.assertAlmostEqual(layers["lacey"], 0.0, delta=1e-12)
        self.assertEqual(layers["grains_per_cell"], 125.0)
        source = random.Random(4)
        mixed = self.put(self.lattice(lambda place: source.random() < 0.4), MIXING)["mixing"]["size"]
        p = mixed["share"]
        self.assertLess(abs(p - 0.4), 0.02)
        self.assertAlmostEqual(mixed["random_variance"], p * (1 - p) / 125, delta=1e-2 * p / 125)
        # 216 samples: the variance scatters by sqrt(2/215) of itself
        self.assertLess(abs(mixed["variance"] / mixed["random_variance"] - 1.0), 4 * math.sqrt(2 / 215))
        self.assertLess(abs(mixed["lacey"] - 1.0), 4 * math.sqrt(2 / 215) / 124)
        last = clod.table(self.path("out/series.csv"))[-1]
        self.assertAlmostEqual(last["mixing_size.lacey"], mixed["lacey"], delta=1e-12)
        self.assertIn("mixing size", self.done.stdout)

    def test_by_mass(self):
        """Layers of grains of unequal mass: 0. By chance: shares and variances are those of masses, worked out here, 1 within the
        scatter of 216 samples. By number the same grains have other shares."""
        both = MIXING + MIXING.split("\n", 1)[1].replace("size:", "weight:").replace("above: 0.95 mm", "above: 0.95 mm\n    by: mass")
        layers = self.put(self.lattice(lambda place: place[2] < 40.0), both)["mixing"]
        heavy, light = 1.0, 0.9 ** 3
        self.assertEqual([layers[name]["by"] for name in ("size", "weight")], ["number", "mass"])
        self.assertAlmostEqual(layers["size"]["share"], 1 / 3, delta=1e-12)
        self.assertAlmostEqual(layers["weight"]["share"], heavy / (heavy + 2 * light), delta=1e-9)
        self.assertAlmostEqual(layers["weight"]["lacey"], 0.0, delta=1e-12)
        source = random.Random(4)
        grains = self.lattice(lambda place: source.random() < 0.4)
        mixed = self.put(grains, both)["mixing"]["weight"]
        cells, squares = {}, [0.0, 0.0]
        for x, y, z, r in grains:
            kind = 0 if r > 0.95 else 1
            cells.setdefault((x // 20, y // 20, z // 20), [0.0, 0.0])[kind] += r ** 3
            squares[kind] += r ** 6
        first, others = (sum(cell[kind] for cell in cells.values()) for kind in (0, 1))
        total = first + others
        p = first / total
        variance = sum(sum(cell) * (cell[0] / sum(cell) - p) ** 2 for cell in cells.values()) / total
        chance = ((1 - p) ** 2 * squares[0] + p ** 2 * squares[1]) / total ** 2 * 215 * 27000 / 26999
        for key, wanted in (("share", p), ("variance", variance), ("segregated_variance", p * (1 - p)), ("random_variance", chance),
                            ("lacey", (p * (1 - p) - variance) / (p * (1 - p) - chance)), ("grains_per_cell", 125.0)):
            self.assertAlmostEqual(mixed[key], wanted, delta=1e-9 * wanted, msg=key)
        self.assertLess(abs(mixed["lacey"] - 1.0), 4 * math.sqrt(2 / 215) / 124)
        last = clod.table(self.path("out/series.csv"))[-1]
        self.assertAlmostEqual(last["mixing_weight.lacey"], mixed["lacey"], delta=1e-12)
        self.assertRegex(self.done.stdout, "mixing weight +Lacey's index by mass ")
        self.assertRegex(self.done.stdout, "mixing size +Lacey's index [0-9]")

    def test_a_cone_of_grains(self):
        """A cone of 30 degrees, 40 mm high, its axis beside the origin: about its centre of mass."""
        grains = []
        for i in range(-75, 76):
            for j in range(-75, 76):
                top = 40.0 - math.tan(math.radians(30.0)) * math.hypot(i - 4.0, j + 3.0)
                if top > 2.0:
                    grains.append((i, j, top - 0.5, 0.49))
        heap = self.put(grains, REPOSE)["repose"]["heap"]
        self.assertLess(abs(heap["angle_deg"] - 30.0), 0.5)
        self.assertLess(abs(heap["height_m"] - 0.040), 2e-3)
        self.assertAlmostEqual(heap["mean_deg"], heap["angle_deg"], delta=1e-9)
        self.assertRegex(self.done.stdout, r"angle of repose [\d.]+ \+- \S+ deg at the end \(\+- standard error of the line\), "
                                           r"[\d.]+ \+- \S+ deg in the steady time \(\+- standard deviation of ten blocks\)")

    def test_words_where_there_is_no_value(self):
        """Why there is none; never nan, whose sign depends on the machine."""
        region = "region: {box: {min: [LOW mm, 0 mm, 0 mm], max: [120 mm, 120 mm, 120 mm]}}"
        here, beside = region.replace("LOW", "-5"), region.replace("LOW", "110")
        self.put([(0.0, 2.0, 2.0, 1.0), (30.0, 2.0, 2.0, 0.9), (60.0, 2.0, 2.0, 1.0)], f"""\
mixing:
  one_kind: {{{here}, cell: 20 mm, above: 0.5 mm}}
  one_cell: {{{here}, cell: 120 mm, above: 0.95 mm}}
  alone: {{{here}, cell: 20 mm, above: 0.95 mm}}
  empty: {{{beside}, cell: 5 mm, above: 0.95 mm}}
repose:
  few: {{{here}, cell: 4 mm}}
  none: {{{beside}, cell: 2 mm}}
fields:
  gone: {{{beside}, interval: 0.1 ms}}
""")
        report = clod.read(self.path("out/report.txt")).decode()
        self.assertNotIn("nan", report)
        lines = {" ".join(line.split()[:2]): " ".join(line.split()[2:]) for line in report.splitlines()}
        for name, reason in (("one_kind", "one kind of grains in the region"),
                             ("one_cell", "all grains in one cell"),
                             ("alone", "too few grains in a cell"), ("empty", "no grain in the region")):
            self.assertIn(f"none at the end ({reason}), none in the steady time", lines["mixing " + name])
        self.assertIn("none at the end (1 strip of the flank, 3 are needed), none in the steady", lines["repose few"])
        self.assertIn("none at the end (no grain in the region), none in the", lines["repose none"])
        self.assertIn("no velocity (no grain in the region), pressure 0", lines["field gone"])

    def warnings(self, text):
        self.write(text)
        done = clod.run("check", self.path("case.yaml"))
        self.assertEqual(done.returncode, 0, done.stderr)
        return " ".join(done.stdout.split())

    def test_check_warns_of_what_says_nothing(self):
        """One kind of grains; cells below a grain; a field that is sampled too seldom."""
        self.assertNotRegex(self.warnings(DRUM), "mixing\\.|repose\\.|fields\\.")
        self.assertIn("mixing.ores.material: all grains are of red",
                      self.warnings(DRUM.replace("material: blue", "material: red")))
        self.assertIn("mixing.ores.material: no grains are of gray",
                      self.warnings(DRUM.replace("blue: {", "gray: {density: 2500 kg/m3}, blue: {")
                                    .replace("cell: 12 mm\n    material: red", "cell: 12 mm\n    material: gray")))
        by_size = DRUM.replace("cell: 12 mm\n    material: red", "cell: 12 mm\n    above: ABOVE mm")
        self.assertNotIn("mixing.", self.warnings(by_size.replace("ABOVE", "2.2")))
        for above, share in (("2.7", "no"), ("1.8", "all")):
            self.assertIn(f"mixing.ores.above: {share} grains have a radius above",
                          self.warnings(by_size.replace("ABOVE", above)))
        self.assertIn("repose.surface.cell 0.004 m is less than the largest grain, 0.0052 m across",
                      self.warnings(DRUM.replace("cell: 6 mm", "cell: 4 mm")))
        field = """\
fields:
  all: {region: {box: {min: [-50 mm, 0 mm, -50 mm], max: [50 mm, 20 mm, 50 mm]}}, interval: LONG}
"""
        self.assertIn("fields.all.interval 0.5 s is longer than the steady time of 0.4 s",
                      self.warnings(DRUM + field.replace("LONG", "0.5 s")))
        self.assertNotIn("fields.", self.warnings(DRUM + field.replace("LONG", "0.3 s")))

    def test_check_warns_of_a_heap_without_room(self):
        """From the middle of 50 mm by 20 mm to a corner are 26.9 mm: two whole strips of 9 mm, three of 8.9 mm; from a corner 53.9 mm."""
        heap = """\
  heap: {region: {box: {min: [-25 mm, 0 mm, -25 mm], max: [25 mm, 20 mm, 25 mm]}}, cell: CELL, to: 90 %}
"""
        self.assertIn("repose.heap.cell 0.009 m: from the middle of the region, about which a heap has its axis, to its farthest point are "
                      "0.0269 m, fewer than the three strips that an angle needs. Make it 0.00889 m or less",
                      self.warnings(DRUM.replace("repose:\n", "repose:\n" + heap.replace("CELL", "9 mm"))))
        for cell in ("8.9 mm", "9 mm, center: [-25 mm, 0 mm]"):
            self.assertNotIn("repose.", self.warnings(DRUM.replace("repose:\n", "repose:\n" + heap.replace("CELL", cell))))

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(DRUM)
        self.go("one")
        self.go("two", "2")
        self.stop_after(5, "cut")
        self.go("cut")
        whole = clod.read(self.path("one/series.csv"))
        self.assertEqual(whole, clod.read(self.path("two/series.csv")))
        self.assertEqual(whole, clod.read(self.path("cut/series.csv")))
        summaries = [clod.without_clock(clod.read(self.path(name + "/summary.json")))
                     for name in ("one", "two", "cut")]
        self.assertEqual(summaries[0], summaries[1])
        self.assertEqual(summaries[0], summaries[2])
        rows = clod.table(self.path("one/series.csv"))
        # it turns by more than half: from nearly apart to mixed, and the surface stands askew
        self.assertLess(rows[0]["mixing_ores.lacey"], 0.35)
        self.assertGreater(rows[-1]["mixing_ores.lacey"], rows[0]["mixing_ores.lacey"] + 0.2)
        self.assertGreater(abs(rows[-1]["repose_surface.repose_angle"]), 10.0)


if __name__ == "__main__":
    clod.main()
