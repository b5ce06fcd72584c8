"""A C program of the library under mpirun: the same numbers on any number of ranks, and an end for all."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import mpirun

EXAMPLE = os.path.join(os.path.dirname(clod.BINARY), "example_on_ranks")


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
@clod.quick_only
class MpirunLibrary(clod.Case):

    def test_the_example(self):
        alone = mpirun.run(0, EXAMPLE)
        self.assertEqual(alone.returncode, 0, alone.stderr)
        for ranks in (1, 2, 3):
            done = mpirun.run(ranks, EXAMPLE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout, alone.stdout, f"{ranks} ranks")

    def test_the_program_that_does_not_ask_for_ranks(self):
        done = mpirun.run(2, os.path.join(os.path.dirname(clod.BINARY), "example_pile"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("2 processes were started together", done.stderr)
        self.assertIn("clod_ranks_open", done.stderr)


if __name__ == "__main__":
    clod.main()
