"""A disk that is full or slow, as tests/cli/test_disk.py has it, under two ranks."""

import os
import sys
import unittest

for folder in ("support", "cli"):
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", folder))
import clod
import mpirun
import test_disk


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
@clod.quick_only
class DiskOfRanks(test_disk.Disk):

    OPTIONS = [*test_disk.Disk.OPTIONS, "--set", "stages.1.duration=20 ms", "--set", "stages.2.duration=10 ms"]

    def run_case(self, folder, **more):
        return mpirun.run(2, clod.BINARY, "run", test_disk.BOX, "-o", folder, *self.OPTIONS, **more)

    test_size_limit = None  # it would be one of MPI's own files, too


if __name__ == "__main__":
    clod.main()
