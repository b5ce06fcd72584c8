"""Columns of surfaces that share their names: each has one of its own, and Python reads what is below it."""

import csv
import json
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "support"), os.path.join(HERE, "..", "..", "cases")]
import clod as program  # noqa: E402  runs the command line
import reading  # noqa: E402
import same_names  # noqa: E402

sys.modules.pop("clod")
sys.path.insert(0, os.environ["CLOD_PYTHON"])
import clod  # noqa: E402


class SeriesNames(program.Case):

    def setUp(self):
        super().setUp()
        same_names.write(self.path)

    def assert_weights(self, row):
        """Each surface carries the weight of its grain, and no other."""
        for surface in same_names.GRAINS:
            weight = same_names.mass(surface) * same_names.GRAVITY
            self.assertAlmostEqual(row[f"surface_{surface}.force_z"] / weight, -1.0, 6, surface)

    def test_a_run(self):
        done = program.run("run", "case.yaml", "-o", "run", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("run/series.csv"), newline="") as file:
            header = next(csv.reader(file))
        self.assertEqual(len(set(header)), len(header))
        series = clod.results(self.path("run")).series()
        self.assertEqual(len(series), len(header))
        self.assert_weights({name: values[-1] for name, values in series.items()})
        self.assert_weights(reading.series(self.path("run"))[-1])
        for surface in list(same_names.GRAINS)[:4]:  # a belt of one part is weighed as a wall
            self.assertAlmostEqual(series[f"{surface}.resting_mass"][-1] / same_names.mass(surface), 1, 12)
        with open(self.path("run/summary.json")) as file:
            summary = json.load(file)
        self.assertEqual([face["name"] for face in summary["surfaces"]], list(same_names.GRAINS))
        for face in summary["surfaces"]:
            weight = same_names.mass(face["name"]) * same_names.GRAVITY
            self.assertAlmostEqual(face["press_N"] / weight, 1.0, 6, face["name"])
        self.assertEqual(list(summary["build_up"]), ["plates", "belts", *list(same_names.GRAINS)[:4]])

    def test_a_simulation(self):
        with clod.Simulation(self.path("case.yaml"), threads=1) as sim:
            sim.open_series()
            sim.advance(100)
            row = sim.series_row()
        self.assert_weights(row)
        self.assertEqual(list(sim.series_units), list(row))
        self.assertEqual(sim.series_units["surface_belts.2.run 1.press"], "N")

    def test_a_wall_that_is_called_as_a_column(self):
        """surface_b.force_x would be that of wall surface_b and that of the surface of wall b: the case is
        refused, and so is the row of a simulation to which such a wall was added."""
        plane = "{material: ore, shapes: [{plane: {point: [0 m, 0 m, -0.1 m]}}]}"
        text = same_names.CASE.replace("walls:\n", f"walls:\n  b: {plane}\n")
        with open(self.path("case.yaml"), "w") as file:
            file.write(text.replace("walls:\n", f"walls:\n  surface_b: {plane}\n"))
        done = program.run("run", "case.yaml", "-o", "run", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("case.yaml:8:3: walls.surface_b: with output.surfaces the columns of walls.b", done.stderr)
        with open(self.path("case.yaml"), "w") as file:
            file.write(text)
        with clod.Simulation(self.path("case.yaml"), threads=1) as sim:
            sim.add_wall("surface_b", f"{plane[1:-1]}".replace(", shapes", "\nshapes"))
            sim.change()
            sim.open_series()
            with self.assertRaisesRegex(ValueError, "have one name: surface_b.force_x, .*; rename a wall"):
                sim.series_row()

    def test_tables_of_before(self):
        """Where a name comes again the second column has a number, and none is lost."""
        os.mkdir(self.path("old"))
        with open(self.path("old/series.csv"), "w") as file:
            file.write("time [s],a.press [N],a.press [N],a.press [N]\n0,1,2,3\n")
        columns, units = clod.results(self.path("old")).table()
        self.assertEqual({name: list(values) for name, values in columns.items()},
                         {"time": [0], "a.press": [1], "a.press (2)": [2], "a.press (3)": [3]})
        self.assertEqual(units["a.press (3)"], "N")


if __name__ == "__main__":
    unittest.main()
