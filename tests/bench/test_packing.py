"""Copies of a periodic packing: nothing is lost or moved, and the seams are like its inside."""

import itertools
import math
import os
import tempfile
import unittest

import peers_path  # noqa: F401
import packing

# a cell of six grains: two neighbours across each of its sides
CSV = """id,x [m],y [m],z [m],r [m],vx [m/s],vy [m/s],vz [m/s]
7,0.1,0.5,0.5,0.11,1,2,3
8,0.9,0.5,0.5,0.12,-1,0,0
9,0.5,0.05,0.45,0.13,0,0,0.25
10,0.5,0.97,0.55,0.14,0,0,0
11,0.45,0.5,0.99,0.15,0,0,0
12,0.5,0.5,0.02,0.1,0,0,0
"""
BOX = "1.0 1.1 1.2\n"
REACH = 0.49  # m, less than half of the shortest period


def neighbours(rows, lengths):
    """Sorted distances of each row to all images of all others within reach."""
    found = []
    for a in rows:
        near = []
        for b in rows:
            d = [p - q - l * round((p - q) / l) for p, q, l in zip(a[:3], b[:3], lengths)]
            if 0.0 < math.hypot(*d) < REACH:
                near.append(math.hypot(*d))
        found.append(sorted(near))
    return found


class Packing(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.stem = os.path.join(folder.name, "made", "bed")
        self.source = os.path.join(folder.name, "source")
        for end, text in ((".csv", CSV), (".box", BOX)):
            with open(self.source + end, "w") as file:
                file.write(text)

    def make(self, copies, for_peers=True):
        count = packing.make(self.stem, self.source, copies, for_peers)
        rows, lengths = packing.read(self.stem + ".csv", self.stem + ".box")
        self.assertEqual(len(rows), count)
        return rows, lengths

    def test_one_copy_is_the_packing(self):
        self.assertEqual(self.make((1, 1, 1)), packing.read(self.source + ".csv",
                                                            self.source + ".box"))

    def test_count_and_box(self):
        rows, lengths = self.make((2, 1, 3))
        self.assertEqual(len(rows), 6 * 2 * 1 * 3)
        for length, expected in zip(lengths, (2.0, 1.1, 3.6)):
            self.assertAlmostEqual(length, expected, places=14)
        self.assertTrue(all(0.0 <= p < l for row in rows for p, l in zip(row, lengths)))
        self.assertEqual(sum(row[6] for row in rows), 6 * (3.0 + 0.25))  # vz of the copies

    def test_distances_across_the_seams(self):
        before = neighbours(*packing.read(self.source + ".csv", self.source + ".box"))
        self.assertTrue(all(before))  # every grain has neighbours, so this can fail
        for copies in itertools.product((1, 2), repeat=3):
            with self.subTest(copies=copies):
                os.path.exists(self.stem + ".csv") and os.remove(self.stem + ".csv")
                after = neighbours(*self.make(copies, for_peers=False))
                for number, near in enumerate(after):
                    expected = before[number % 6]
                    self.assertEqual(len(near), len(expected))
                    for one, other in zip(near, expected):
                        self.assertAlmostEqual(one, other, places=14)

    def test_a_column_leaves_out_what_would_overlap_across_its_border(self):
        def grain(x, y):
            return (x, y, 0.5, 0.05, 0.0, 0.0, 0.0)
        pair = [grain(0.2, 0.5), grain(0.29, 0.5)]  # these overlap by a fifth of a radius
        border = [grain(0.02, 0.2), grain(0.48, 0.2)]  # cut at 0.5: 0.04 apart, far too near
        fits = [grain(0.01, 0.8), grain(0.415, 0.8)]  # 0.095 apart: less than the pair
        beyond = [grain(0.7, 0.1)]
        kept, lengths = packing.cut(pair + border + fits + beyond, (1.0, 1.0, 1.0), (0.5, 1, 1))
        self.assertEqual(kept, pair + border[:1] + fits)
        self.assertEqual(lengths, [0.5, 1.0, 1.0])

    def test_peers_get_the_same_grains(self):
        rows, lengths = self.make((2, 2, 1))
        with open(self.stem + ".data") as file:
            head, atoms = file.read().split("\nAtoms\n\n")
        atoms, velocities = atoms.split("\nVelocities\n\n")
        self.assertIn("24 atoms\n", head)
        self.assertIn(f"0.0 {lengths[1]!r} ylo yhi\n", head)
        for number, (row, atom, velocity) in enumerate(
                zip(rows, atoms.splitlines(), velocities.splitlines(), strict=True), 1):
            _, _, diameter, density, *place = map(float, atom.split())
            self.assertEqual(atom.split()[0:2], [str(number), "1"])
            self.assertEqual((diameter, density), (2.0 * row[3], 2481.3))
            self.assertEqual(tuple(place), row[:3])
            self.assertEqual(velocity.split()[0], str(number))
            self.assertEqual(tuple(map(float, velocity.split()[1:])), (*row[4:], 0.0, 0.0, 0.0))


if __name__ == "__main__":
    unittest.main()
