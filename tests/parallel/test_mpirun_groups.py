"""Parts of a test on groups of ranks: the files of one process, and one end for all.

What `clod run` does with seeds and points when there are several ranks (docs/ranks.md).
"""

import os
import signal
import socket
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import mpirun
import rank_groups
from rank_groups import run

RING = clod.source("tests/restart/ring.yaml")
UNIAXIAL = clod.source("tests/faults/uniaxial.yaml")
JENIKE = clod.source("tests/restart/jenike.yaml")
WALL_FRICTION = clod.source("tests/parallel/wall_friction.yaml")
SHORT = ("--set", "ring_shear.preshear_min=2 mm", "--set", "ring_shear.preshear_max=5 mm")
# Seconds of preshear, without the ledger, which would take most of them: a seed with a rank of its own is not at its end before the other, with two, has begun.
LONG = ("--set", "ring_shear.preshear_min=20 mm", "--set", "ring_shear.preshear_max=20 mm",
        "--set", "ring_shear.speed=20 mm/s", "--set", "output.energy=false")
SEEDS = ("--set", "ring_shear.seeds=2")
PARTS = [f"seed-{seed}-{part}" for seed in (7, 8)
         for part in ("preshear", "reverse", "point-1", "point-2")]


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
@clod.quick_only
class Groups(rank_groups.Groups):

    def test_seeds_and_points(self):
        self.assert_same((2, 3), PARTS, RING, *SHORT, *SEEDS)

    def start(self, ranks, out, *options):
        process = mpirun.start(ranks, clod.BINARY, "run", RING, "-o", out, *SEEDS, *options)

        def both_run():
            tables = [f"{out}/seed-{seed}-preshear.csv" for seed in (7, 8)]
            return all(os.path.exists(table) and clod.read(table).count(b"\n") > 3
                       for table in tables)
        self.assertTrue(clod.wait_until(both_run, process))
        return process

    def test_a_signal_to_rank_0_stops_all_parts(self):
        one, _ = self.alone(RING, *LONG, *SEEDS)
        out = self.path("several")
        process = self.start(3, out, *LONG)  # two of them on one seed
        with open(f"{out}/.clod-lock") as lock:
            os.kill(int(lock.read()), signal.SIGTERM)
        _, error = process.communicate(timeout=600)
        self.assertEqual(process.returncode, 143, error)
        self.assertIn("the same command goes on", error)
        stopped = [event["part"] for event in clod.log(out) if event["event"] == "stopped"]
        self.assertEqual(sorted(stopped), ["seed-7-preshear", "seed-8-preshear"])
        done = run(2, RING, "-o", out, *LONG, *SEEDS)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(one, out, PARTS)
        resumed = [event["part"] for event in clod.log(out) if event["event"] == "resume"]
        self.assertIn("seed-8-preshear", resumed)

    def test_a_request_to_save_reaches_all_parts(self):
        out = self.path("several")
        process = self.start(2, out, *LONG)
        with open(f"{out}/.clod-lock") as lock:
            rank = int(lock.read())
        os.kill(rank, signal.SIGUSR1)

        def saved():
            return {name.split("-at-")[0] for name in os.listdir(out) if "-at-" in name}
        self.assertTrue(clod.wait_until(lambda: len(saved()) == 2, process))
        os.kill(rank, signal.SIGTERM)
        process.communicate(timeout=600)
        self.assertEqual(saved(), {"restart-seed-7-preshear", "restart-seed-8-preshear"})

    def test_a_part_of_another_group_that_fails(self):
        """The second seed has its grains too near for its overlap limit; what is said is what one process
        says."""
        out, alone = self.path("several"), self.path("one")
        options = (*SHORT, *SEEDS, "--set", "time.overlap_limit=0.1 %")
        one = clod.run("run", RING, "-o", alone, "--threads", "1", *options)
        done = run(2, RING, "-o", out, *options)
        self.assertEqual((one.returncode, done.returncode), (1, 1), one.stderr)
        self.assertIn(one.stderr.splitlines()[-1], done.stderr)

    def test_a_folder_that_is_in_the_way(self):
        out = self.path("taken")
        with open(out, "w") as file:
            file.write("mine")
        done = run(3, RING, "-o", out, *SEEDS)
        self.assertEqual(done.returncode, 2, done.stderr)

    def test_a_group_that_cannot_begin_is_told_at_once(self):
        """Its host does not see the folder; nobody waits for the parts of the others, which take hours."""
        here, there = self.path("here"), self.path("there")
        os.mkdir(here)
        os.mkdir(there)
        command = [clod.BINARY, "run", RING, "-o", "out", *SEEDS,
                   "--set", "ring_shear.preshear_max=100 m"]
        done = subprocess.run([*mpirun.MPIRUN, "1", "--wdir", here, *command,
                               ":", "-n", "1", "--wdir", there, *command],
                              text=True, timeout=600, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 1, done.stderr)
        told = f"rank 1 on {socket.gethostname()}: Cannot open out: No such file or directory."
        self.assertEqual(done.stderr.count(told), 1, done.stderr)
        self.assertFalse(any(name.endswith(".csv") for name in os.listdir(f"{here}/out")))
        # a folder of the same name, in which an earlier run was
        os.mkdir(f"{there}/out")
        with open(f"{there}/out/.clod-lock", "w") as lock:
            lock.write("1\n")
        done = subprocess.run([*mpirun.MPIRUN, "1", "--wdir", here, *command,
                               ":", "-n", "1", "--wdir", there, *command],
                              text=True, timeout=600, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f"rank 1 on {socket.gethostname()}: out is another folder here", done.stderr)
        self.assertEqual(os.listdir(f"{there}/out"), [".clod-lock"])

    def test_a_time_limit(self):
        out = self.path("limited")
        done = run(2, RING, "-o", out, *SEEDS, "--time-limit", "2 s",
                   "--set", "ring_shear.preshear_min=1 m", "--set", "ring_shear.preshear_max=2 m",
                   "--set", "time.overlap_limit=90 %")  # so long a test presses grains deep
        self.assertEqual(done.returncode, 143, done.stderr)
        stopped = [event["part"] for event in clod.log(out) if event["event"] == "stopped"]
        self.assertEqual(sorted(stopped), ["seed-7-preshear", "seed-8-preshear"])

    def test_points_of_a_uniaxial_test(self):
        self.assert_same((2,), ("fill", "stress-1", "stress-2"), UNIAXIAL)

    def test_seeds_of_a_wall_friction_test(self):
        self.assert_same((2,), [f"seed-{seed}-{part}" for seed in (3, 4) for part in ("fill", "wall")],
                         WALL_FRICTION, "--set", "wall_friction.seeds=2")
        points = clod.table(self.path("ranks-2/wall_friction.csv"))
        self.assertEqual([point["seed"] for point in points], [3, 3, 4, 4])

    def test_seeds_and_points_of_a_jenike_test(self):
        self.assert_same((2,), PARTS, JENIKE, "--set", "jenike.seeds=2", "--set",
                         "jenike.preshear_max=2.5 mm", "--set", "jenike.shear_max=1 mm")


if __name__ == "__main__":
    clod.main()
