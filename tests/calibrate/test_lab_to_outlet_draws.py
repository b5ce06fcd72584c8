"""Outlets of twelve specimens, from the tables that cases/lab-to-outlet keeps: what its README and the page say."""

import csv
import os
import statistics
import unittest

import draws
from draws import PAGE, STUDY, clod


@unittest.skipIf(clod.SANITIZED, "three designs of five seconds each")
class Twelve(clod.Case):

    def test_pages_have_the_outlets_of_all_specimens(self):
        outlets = draws.load()
        rows = outlets.read_rows()
        found = [outlets.design(clod.BINARY, rows, outlets.DRAWS[outlets.ALL], known) for known in outlets.KNOWN]
        slots, cones = ([outlets.cell(one, shape) for one in found] for shape in ("wedge", "cone"))
        for cells in (slots, cones):
            self.assertIn(f"| {outlets.ALL} | {' | '.join(cells)} |\n", STUDY)
        self.assertIn(f"| {outlets.ALL} | {' | '.join([*slots, cones[2]])} |\n", PAGE)
        alone = [1e3 * specimen["wedge"]["outlet_m"] for specimen in found[0]["specimens"]]
        told = f"{statistics.mean(alone):.0f} ± {statistics.stdev(alone):.0f}"
        self.assertIn(f"| {outlets.ALL} | {slots[0]} | {told} |\n", PAGE)
        self.assertIn(f"the twelve alone ask for {min(alone):.0f} to {max(alone):.0f} mm, {told}", STUDY)

    def test_the_density_inside(self):
        """Mean and standard error of nine specimens, from the tables by other means."""
        told = {}
        for name in ("card", "more"):
            with open(clod.source(f"cases/lab-to-outlet/laboratory/shear-{name}.csv"), encoding="utf-8") as file:
                table = csv.reader(line for line in file if line[0] in "0123456789")
                told.update({row[0]: int(row[8]) for row in table if row[1] == "0.300"})
        self.assertEqual(len(told), 9)
        mean, error = statistics.mean(told.values()), statistics.stdev(told.values()) / 3
        outlets = draws.load()
        found = outlets.inside(outlets.read_rows())
        self.assertAlmostEqual(found[0], mean, delta=1e-9 * mean)
        self.assertAlmostEqual(found[1], error, delta=1e-9 * error)
        self.assertIn(f"The density inside is {mean:.0f} ± {error:.0f} kg/m3", STUDY)

    def test_tables_of_three_stresses_are_those_of_the_page(self):
        """shear-4.csv is shear.csv with nine rows more."""
        rows = {}
        for name in ("shear.csv", "laboratory/shear-4.csv"):
            with open(clod.source(os.path.join("cases/lab-to-outlet", name)), encoding="utf-8") as file:
                rows[name] = [line for line in file if line[0] in "0123456789"]
        self.assertEqual(rows["laboratory/shear-4.csv"][9:], rows["shear.csv"])


if __name__ == "__main__":
    clod.unittest.main()
