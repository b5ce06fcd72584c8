"""Parts of a ring shear test side by side in threads: the same bits as one after the other.

Part of the ThreadSanitizer tree: the parts share the log, the folder, HDF5 and the terminal.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = clod.source("tests/restart/ring.yaml")


class SideBySide(clod.Case):

    def series(self, threads, energy):
        out = self.path(f"out-{threads}-{energy}")
        done = clod.run("run", CASE, "-o", out, "--threads", str(threads),
                        "--set", "ring_shear.preshear_min=5 mm",
                        "--set", "ring_shear.preshear_max=5 mm",
                        "--set", f"output.energy={energy}")
        self.assertEqual(done.returncode, 0, done.stderr)
        return {name: clod.read(os.path.join(out, name)) for name in
                ("preshear.csv", "reverse.csv", "point-1.csv", "point-2.csv", "points.csv")}

    def test_two_threads_give_the_bits_of_one(self):
        one = self.series(1, "true")
        self.assertEqual(self.series(2, "true"), one)
        if not clod.SANITIZED:
            self.assertEqual(self.series(2, "false"), one)  # as most runs are


if __name__ == "__main__":
    clod.main()
