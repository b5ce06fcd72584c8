"""Beds of every shape on 1 to 16 ranks: the files of one process.

tests/sim/test_run_ranks.c has the same beds on 16 ranks that are threads, in seconds.
"""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import mpirun

RANKS = (1, 2, 3, 4, 7, 16)


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
@clod.quick_only
class Shapes(clod.Case):

    def assert_same(self, name):
        """Rows of the series of one process."""
        case, one = clod.source(f"tests/parallel/{name}.yaml"), self.path("one")
        alone = clod.run("run", case, "-o", one, "--threads", "1")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        for ranks in RANKS:
            out = self.path(f"ranks-{ranks}")
            done = mpirun.run(ranks, clod.BINARY, "run", case, "-o", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assert_same_end(one, out, ("run",))
        return clod.table(os.path.join(one, "series.csv"))

    def test_a_dense_cohesive_bed_that_is_sheared(self):
        self.assert_same("slit")
        self.assertGreater(self.summary("one")["contacts"], 100)

    def test_a_drum_of_a_mesh(self):
        self.assert_same("drum")
        self.assertGreater(self.summary("one")["contacts"], 50)

    def test_a_hopper_of_a_mesh_that_empties(self):
        grains = [row["grains"] for row in self.assert_same("hopper")]
        self.assertEqual((grains[0], grains[-1]), (60, 0))

    def test_a_chute_with_inlets_and_an_outlet_that_is_empty_between(self):
        grains = [row["grains"] for row in self.assert_same("chute")]
        self.assertIn(0, grains[30:])
        self.assertGreater(grains[-1], 10)


if __name__ == "__main__":
    clod.main()
