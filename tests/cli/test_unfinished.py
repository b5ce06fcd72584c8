"""A part of a test fails: what the finished parts measured is written, with the reason."""

import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = clod.source("tests/restart/ring.yaml")


class Unfinished(clod.Case):

    def summary(self):
        with open(self.path("out/summary.json")) as file:
            return json.load(file)

    def test_results_of_finished_parts(self):
        run = clod.start("run", CASE, "-o", self.path("out"), "-t", "1")
        self.assertTrue(clod.wait_until(
            lambda: os.path.exists(self.path("out/restart-preshear_a.h5")), run))
        os.mkdir(self.path("out/point-2.csv"))  # where the second point's table has to go
        out, told = run.communicate(timeout=1000)
        self.assertEqual(run.returncode, 1, told)
        self.assertEqual(out, "")
        self.assertIn(f"clod: what is known of the 3 finished parts is in {self.path('out')}/"
                      "points.csv and summary.json", told)
        summary = self.summary()
        self.assertEqual([part["part"] for part in summary["parts"]],
                         ["preshear", "reverse", "point-1"])
        self.assertIsNone(summary["locus"])
        self.assertIn("point-2.csv", summary["incomplete"])
        self.assertIn(summary["incomplete"], told)
        points = clod.table(self.path("out/points.csv"))
        self.assertEqual([point["sigma_sh"] for point in points], [300.0])

        os.rmdir(self.path("out/point-2.csv"))
        done = clod.run("run", CASE, "-o", "out", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = self.summary()
        self.assertNotIn("incomplete", summary)
        self.assertEqual(len(summary["parts"]), 4)
        self.assertEqual(len(summary["locus"]["loci"]), 1)
        self.assertEqual(len(clod.table(self.path("out/points.csv"))), 2)


if __name__ == "__main__":
    clod.main()
