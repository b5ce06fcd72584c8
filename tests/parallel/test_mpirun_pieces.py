"""Messages that are cut into pieces, as those beyond 1 GiB are: here beyond 1021 bytes, so nearly all."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import mpirun

PIECES = os.environ.get("CLOD_PIECES")


@clod.quick_only
@unittest.skipUnless(PIECES, "clod was built without MPI")
class Pieces(clod.Case):

    def assert_same_on(self, ranks, name):
        case = clod.source(f"tests/parallel/{name}.yaml")
        one, several = self.path("one"), self.path("several")
        alone = clod.run("run", case, "-o", one, "--threads", "1")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        done = mpirun.run(ranks, PIECES, "run", case, "-o", several, "--no-report")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(one, several, ("run",))

    def test_grains_that_are_dealt_migrate_and_are_ghosts(self):
        self.assert_same_on(3, "slit")

    def test_sums_and_grains_that_come_and_go(self):
        self.assert_same_on(2, "rain")


if __name__ == "__main__":
    clod.main()
