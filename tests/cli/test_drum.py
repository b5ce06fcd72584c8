"""cases/rotating-drum/run: what it reads from a log of LIGGGHTS, zones, pairs of times."""

import importlib.machinery
import importlib.util
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

LOADER = importlib.machinery.SourceFileLoader("drum", clod.source("cases/rotating-drum/run"))
drum = importlib.util.module_from_spec(importlib.util.spec_from_loader("drum", LOADER))
LOADER.exec_module(drum)

LOG = """Setting up run at Sat Nov 21 17:02:36 2026
    Step  t  Atoms  a  b  c  d  KinEng  rke  CPU
       0  0  38000  0  0  15047  3963  0  0  0
   12500  0.01  38000  1  2  15040  3950  1e-05  1e-05  8.2
Loop time of 31.5 on 1 procs for 12500 steps with 38000 atoms
   25000  0.02  38000  9  9  9  9  9  9  9
    Step  t  Atoms  a  b  c  d  KinEng  rke  CPU
   37500  0.03  38000  3  4  15030  3940  1e-05  1e-05  8.2
   50000  0.04  38000  5  6  150"""


class Drum(clod.Case):
    def test_rows_of_a_log(self):
        """Rows below a header up to the end of the run; one that is being written is left out."""
        with open(self.path("log"), "w") as file:
            file.write(LOG)
        counts = drum.count_liggghts([self.path("log")])
        self.assertEqual([round(time, 6) for time in counts], [0, 0.01, 0.03])
        self.assertEqual(list(counts.values()),
                         [[0, 0, 15047, 3963], [1, 2, 15040, 3950], [3, 4, 15030, 3940]])
        self.assertEqual(drum.count_liggghts([]), {})

    def test_logs_of_an_interrupted_run(self):
        """A run that went on at a restart file has a log of its own, and may repeat a row."""
        first = LOG[:LOG.index("Loop time")]
        again = first[:first.index("       0")] + "   12500  0.01  38000  1  2  15040  3950  0  0  0\n" \
            "   25000  0.02  38000  7  8  15035  3945  0  0  0\n"
        for name, text in (("log", first), ("log.1", again)):
            with open(self.path(name), "w") as file:
                file.write(text)
        counts = drum.count_liggghts([self.path("log"), self.path("log.1")])
        self.assertEqual([round(time, 6) for time in counts], [0, 0.01, 0.02])
        self.assertEqual(counts[25000 * drum.STEP], [7, 8, 15035, 3945])

    def test_zones(self):
        types = [0, 1, 0, 1, 0, 1, 0]
        places = [(1, 0, 1), (1, 0, 1), (-1, 0, -1), (-1, 9, -2), (-3, 0, -1), (1, 0, -1),
                  (-1, 0, 1)]
        self.assertEqual(drum.zones(types, places), [1, 1, 2, 1])

    def test_pairs_of_times(self):
        """clod's snapshots lie within a step of LIGGGHTS's rows, and may be fewer or more."""
        clod_counts = {0.0100003: "a", 0.03: "b", 0.05: "c"}
        liggghts = {0.01: "A", 0.02: "B", 0.03: "C"}
        self.assertEqual(drum.pair(clod_counts, liggghts),
                         [(0.0100003, "a", "A"), (0.03, "b", "C")])
        self.assertEqual(drum.pair(clod_counts, {}), [])

    def test_data_that_are_absent(self):
        script = clod.source("cases/rotating-drum/run")
        done = subprocess.run([sys.executable, script, "--data", self.path("nothing"),
                               "--folder", self.path("out")],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("PartCoordinates.txt", done.stderr)
        self.assertIn("--data DIR", done.stderr)
        self.assertFalse(os.path.exists(self.path("out")))

    def test_table_without_results(self):
        """What to run, exit status 2, and no file of nothing."""
        script = clod.source("cases/rotating-drum/run")
        done = subprocess.run([sys.executable, script, "--table", "--folder", self.path("out")],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("run the drum first", done.stderr)
        self.assertFalse(os.path.exists(self.path("out")))


if __name__ == "__main__":
    clod.main()
