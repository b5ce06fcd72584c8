"""What cases/copper-ore-study/rising reads out of snapshots: numbers worked out by hand, and a small ring."""

import math
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "support"))
sys.path.insert(0, os.path.join(HERE, "..", "..", "cases", "copper-ore-study"))
import clod as program  # noqa: E402  runs the command line
import inside  # noqa: E402
import numpy  # noqa: E402

try:
    import h5py  # noqa: F401
except ImportError:
    h5py = None

TOOL = program.source("cases/copper-ore-study/rising")
RING = program.source("tests/cli/ring_shear.yaml")


class ByHand(unittest.TestCase):

    def test_a_contact_is_its_grains(self):
        one, other, third = inside.keys_of([[3, 70000], [70000, 3], [3, 70001]])
        self.assertEqual(one, other)
        self.assertNotEqual(one, third)

    def test_ages_and_lives(self):
        """Contact 1 is there all the time, 2 opens at 2 mm and is new at 3 mm, 3 comes at 1 mm, 4 at 3 mm; 5 goes."""
        keys = [numpy.array(k) for k in ([1, 2, 5], [1, 2, 3, 5], [1, 3], [1, 2, 3, 4])]
        ways = numpy.array([0.0, 1.0, 2.0, 3.0])
        numpy.testing.assert_equal(inside.ages(keys, ways), [math.nan, 0.0, 2.0, 0.0])
        numpy.testing.assert_allclose(inside.survival(keys, 0), [1.0, 1.0, 1 / 3, 1 / 3])
        numpy.testing.assert_allclose(inside.survival(keys, 1), [1.0, 0.5, 0.5])

    def test_the_budget_adds_up(self):
        """Mean 4 N; contact 1 gains 2 N, 2 loses 1 N, 3 with 6 N opens, 4 comes with 1 N: 8/3 N = 4 + 2/3 - 1/3 - 5/3."""
        told = inside.budget((numpy.array([1, 2, 3]), numpy.array([1.0, 5.0, 6.0])),
                             (numpy.array([2, 4, 1]), numpy.array([4.0, 1.0, 3.0])))
        for key, value in (("gained", 2 / 3), ("lost", -1 / 3), ("turnover", -5 / 3), ("opened", 1 / 3), ("new", 1 / 3),
                           ("opened_pull", 6.0), ("new_pull", 1.0)):
            self.assertAlmostEqual(told[key], value)

    def test_the_force_is_that_of_the_law(self):
        """docs/theory/mepa.md: 3 um pressed, then 0.90 of it: 0.667921 N; the largest pull -1.285924 N at 2.354201 um."""
        law = {"k2": 2.37e9, "n": 1.5, "pull": 0.0}
        plastic = (1 - 4.75e8 / 2.37e9) * 3e-6 ** 1.5
        for overlap, force in ((3e-6, 2.468172), (2.7e-6, 0.667921), (2.354201e-6, -1.285924)):
            self.assertAlmostEqual(inside.normal_force(law, overlap, plastic), force, delta=2e-6)
        self.assertAlmostEqual(inside.normal_force({**law, "pull": 5.0}, 3e-6, plastic), 2.468172 - 5.0, delta=2e-6)

    def test_spheres_in_slices(self):
        """A sphere about the plane z = 1 has half of itself on each side; a cap of height h has pi h^2 (3 r - h)/3."""
        edges = numpy.array([0.0, 1.0, 1.5, 4.0])
        below, cap, above = inside.sphere_slices(numpy.array([1.0, 3.0]), numpy.array([1.0, 0.5]), edges)
        whole, small, height = 4 / 3 * math.pi, 4 / 3 * math.pi / 8, 0.5
        upper = math.pi * height ** 2 * (3 - height) / 3
        self.assertAlmostEqual(below, whole / 2)
        self.assertAlmostEqual(cap, whole / 2 - upper)
        self.assertAlmostEqual(above, upper + small)

    def test_turning_is_told_across_the_seam(self):
        before, after = ([[math.cos(a), math.sin(a), 0.0]] for a in (3.1, -3.1))
        self.assertAlmostEqual(inside.turned(numpy.array(before), numpy.array(after))[0], 2 * math.pi - 6.2)

    def test_a_line(self):
        """Through (0, 0), (1, 3), (2, 3): slope 1.5, rest -0.5, 1, -0.5: s2 = 1.5/1, error sqrt(1.5/2)."""
        found, error = inside.slope([0.0, 1.0, 2.0], [0.0, 3.0, 3.0])
        self.assertAlmostEqual(found, 1.5)
        self.assertAlmostEqual(error, math.sqrt(0.75))


class ThePage(unittest.TestCase):

    def test_windows_follow_from_the_stresses(self):
        """Which part of the rise is the pushes': from the page's table of stresses."""
        with open(program.source("docs/results/why-stress-rises.md")) as file:
            rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in file if line.strip().startswith("|")]
        at = {(row[0].split("-seed")[0], row[1]): [float(row[2]), sum(map(float, row[3].split(","))), *map(float, row[5:])]
              for row in rows if len(row) == 8 and row[3].count(",") == 2 and row[1].isdigit()}
        windows = [row for row in rows if len(row) == 7 and "-" in row[1] and row[0] in ("base", "small")]
        self.assertEqual(len(windows), 8)
        for test, way, rise, share, *parts in windows:
            before, after = (at[test, end] for end in way.split("-"))
            logarithms = [math.log(b / a) for a, b in zip(before[:2], after[:2])]
            self.assertAlmostEqual(float(share), logarithms[1] / logarithms[0], delta=0.006)
            for number, a, b in zip([rise, *parts], [before[0], *before[2:]], [after[0], *after[2:]]):
                self.assertAlmostEqual(float(number), b - a, delta=1e-9)


class ARing(program.Case):

    @unittest.skipIf(h5py is None, "no h5py")
    def test_a_small_ring(self):
        """0 at the lid and 1 at the trough; what the series has; pushes outweigh pulls."""
        out = self.path("out")
        done = program.run("run", RING, "-o", out, "-t", "1", "--set", "output.contacts=true", "--set",
                           "output.snapshot_interval=6.25 ms", "--set", "ring_shear.preshear_min=10 mm", "--set",
                           "ring_shear.preshear_max=10 mm", "--set", "ring_shear.shear_stresses=[5 kPa, 7 kPa]")
        self.assertEqual(done.returncode, 0, done.stderr)
        bed = inside.Preshear(out)
        self.assertEqual(bed.law, {"k2": 1e8, "n": 1.5, "pull": 0.0})
        # 0.5 mm each at 80 mm/s but for the start, and the last is that of the end of preshear
        self.assertAlmostEqual(bed.way[-1], bed.series["displacement"][-1], delta=1e-9)
        numpy.testing.assert_allclose(numpy.diff(bed.way)[5:-1], 0.5e-3, atol=2e-6)
        told = bed.numbers(len(bed.way) - 2)
        grains = bed.grains(len(bed.way) - 2)
        self.assertEqual(told["contacts"], len(bed.contacts(len(bed.way) - 2)["id"]))
        self.assertLess(told["coordination"], grains["coordination"].mean())  # that one has walls too
        self.assertGreater(told["push"], told["pull"])
        self.assertGreater(told["push"] - told["pull"], 0.3 * bed.sigma)
        self.assertLess(told["push"] - told["pull"], 1.2 * bed.sigma)
        # normal forces carry the load but for what friction of contacts carries along z
        push, pull = bed.stress(8e-3)
        self.assertAlmostEqual((push[2] + pull[2]) / bed.sigma, 1.0, delta=0.15)
        self.assertLess(pull[2], 0.0)
        profile = bed.profile(6e-3, 4)
        # a straight line from floor to lid has 1 to 0.75 in the lowest slice, 0.25 to 0 in the highest
        self.assertGreater(profile["speed"][0], 0.75)
        self.assertLess(profile["speed"][0], 1.05)
        self.assertLess(profile["speed"][3], 0.25)
        self.assertTrue((numpy.diff(profile["speed"]) < 0).all())
        volume = bed.area * bed.mean("height", 6e-3, 2e-3) / 4
        mass = grains["mass"].sum()
        self.assertAlmostEqual(profile["solid"].sum() * volume * 2481.3 / mass, 1.0, delta=2e-3)

    def test_a_wrong_name_lists_all(self):
        done = program.subprocess.run([sys.executable, "-B", TOOL, "dry-seed9"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("base-seed1", done.stderr)


if __name__ == "__main__":
    program.main()
