"""A full disk under mpirun: one error, the last whole checkpoint is there, and any number of ranks goes on."""

import errno
import os
import shutil
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import io_faults as faults
from io_faults import clod
import mpirun

FREE = clod.source("tests/faults/free.yaml")
WALL_FRICTION = clod.source("tests/parallel/wall_friction.yaml")
FULL = os.strerror(errno.ENOSPC)


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
class Ranks(faults.FaultCase):

    def preloaded(self, ranks, *arguments, **variables):
        """Run clod on so many ranks, the library of faults in each, and not in mpirun."""
        settings = [f"LD_PRELOAD={clod.IO_FAULTS}", f"CLOD_FAULT_UNDER={self.work}",
                    *(f"CLOD_FAULT_{name}={value}" for name, value in variables.items())]
        return mpirun.run(ranks, "env", *settings, clod.BINARY, "run", *arguments)

    def assert_told_once(self, done, file):
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stderr.count(FULL), 1, done.stderr)
        self.assertIn(file, done.stderr)

    def test_a_disk_that_becomes_full(self):
        """All that could be written fails from two thirds of the way on."""
        case, out, one = os.path.join(self.work, "free.yaml"), os.path.join(self.work, "out"), self.path("one")
        self.assertEqual(clod.run("run", FREE, "-o", one, "-t", "1").returncode, 0)
        os.mkdir(self.work)
        shutil.copy(FREE, case)
        alone = ":", "-n", "1", clod.BINARY, "run", case, "-o", out  # rank 1, whose calls are not logged
        done = self.preloaded(1, case, "-o", out, *alone, LOG=self.log)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(one, out, ["run"])
        calls = faults.read_log(self.log)
        rows = [at for at, call in enumerate(calls, 1)
                if (call.name, call.file) == ("write", "series.csv")]
        shutil.rmtree(out)
        done = self.preloaded(2, case, "-o", out, AT=rows[2 * len(rows) // 3], ERROR=errno.ENOSPC, ON=1)
        self.assert_told_once(done, "series.csv")
        self.assertEqual(len(clod.checkpoints(out, "run")), 2)
        done = mpirun.run(3, clod.BINARY, "run", case, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("resume", [event["event"] for event in clod.log(out)])
        self.assert_same_end(one, out, ["run"])

    def test_a_file_of_another_group(self):
        """Rank 1 writes the second seed: rank 0 tells what went wrong there."""
        out, one = os.path.join(self.work, "out"), self.path("one")
        seeds = WALL_FRICTION, "--set", "wall_friction.seeds=2"
        self.assertEqual(clod.run("run", *seeds, "-o", one, "-t", "1").returncode, 0)
        os.mkdir(self.work)
        done = self.preloaded(2, *seeds, "-o", out, AT=3, ERROR=errno.ENOSPC, ON=1,
                              ONLY=f"write {out}/seed-4-wall.csv")
        self.assert_told_once(done, "seed-4-wall.csv")
        self.assertTrue(clod.checkpoints(out, "seed-4-wall"))
        done = mpirun.run(2, clod.BINARY, "run", *seeds, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(one, out, [f"seed-{seed}-{part}" for seed in (3, 4)
                                        for part in ("fill", "wall")])


if __name__ == "__main__":
    clod.main()
