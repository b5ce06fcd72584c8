"""Points that begin with another run's preparations (clod run --from) on groups of ranks: the files and
log of one process, whatever goes wrong (docs/ranks.md).
"""

import os
import random
import shutil
import signal
import socket
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import mpirun
import rank_groups
import rank_kills
from rank_groups import run

RING = clod.source("tests/restart/ring.yaml")
UNIAXIAL = clod.source("tests/faults/uniaxial.yaml")
SEEDS = ("--set", "ring_shear.seeds=2", "--set", "ring_shear.preshear_min=2 mm",
         "--set", "ring_shear.preshear_max=5 mm",
         "--set", "output.energy=false")  # the ledger takes most of the time; tests/restart/test_from.py has it
STRESSES = ("--set", "ring_shear.shear_stresses=[0.3 kPa, 0.6 kPa, 0.45 kPa]")
PREPARED = [f"seed-{seed}-{part}" for part in ("preshear", "reverse") for seed in (7, 8)]
POINTS = [f"seed-{seed}-point-{point}" for seed in (7, 8) for point in (1, 2, 3)]
LONG = ("--set", "ring_shear.shear_max=20 mm", "--set", "ring_shear.beyond_peak=19 mm")


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
@clod.quick_only
class From(rank_groups.Groups):

    @classmethod
    def setUpClass(cls):
        """The other run: two seeds with two points each."""
        cls.shared = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, cls.shared)
        cls.old = os.path.join(cls.shared, "old")
        done = clod.run("run", RING, "-o", cls.old, "-t", "1", *SEEDS)
        assert done.returncode == 0, done.stderr
        cls.options = (*SEEDS, *STRESSES, "--from", cls.old)

    def copy_old(self):
        copy = self.path("old")
        shutil.copytree(self.old, copy)
        return copy

    def assert_events(self, out, event, parts):
        self.assertEqual([entry["part"] for entry in clod.log(out) if entry["event"] == event],
                         parts)

    def test_points_of_two_seeds(self):
        """Rank 0 takes all preparations over, in their order; the log has the points of a group
        together."""
        self.assert_same((2, 4), [*PREPARED, *POINTS], RING, *self.options)
        self.assert_events(self.path("one"), "taken over", PREPARED)
        for ranks, groups in ((2, 2), (4, 3)):
            out = self.path(f"ranks-{ranks}")
            self.assert_events(out, "taken over", PREPARED)
            self.assert_events(out, "finished", [point for group in range(groups)
                                                 for point in POINTS[group::groups]])
            told = [event["text"] for event in clod.log(out) if "what differs:" in
                    event.get("text", "")]
            self.assertEqual(len(told), 1)

    def test_consolidations_of_a_uniaxial_test(self):
        stresses = ("--set", "uniaxial.consolidation_stresses=[1.2 kPa]")
        old = self.path("old")
        self.assertEqual(clod.run("run", UNIAXIAL, "-o", old, *stresses).returncode, 0)
        self.assert_same((2,), ("fill", "stress-1", "stress-2"), UNIAXIAL, "--from", old)
        self.assert_events(self.path("ranks-2"), "taken over", ["fill"])

    def refused(self, ranks, text, *options):
        """Rank 0 says what one process says, before there is a folder."""
        out = self.path("refused")
        one = clod.run("run", RING, "-o", out, *options)
        done = run(ranks, RING, "-o", out, *options)
        self.assertEqual((one.returncode, done.returncode), (2, 2), one.stderr)
        self.assertIn(text, one.stderr)
        self.assertEqual(done.stderr.count(one.stderr), 1, done.stderr)
        self.assertEqual(done.stderr.count("clod run: "), 1, done.stderr)
        self.assertFalse(os.path.exists(out))

    def test_what_is_refused(self):
        self.refused(3, "No such file or directory", *SEEDS, "--from", self.path("none"))
        self.refused(2, "friction differs", *self.options, "--set",
                     "contacts.default.friction=0.2")
        old = self.copy_old()
        for path in clod.checkpoints(old, "seed-8-reverse"):
            os.remove(path)
        self.refused(4, "seed-8-reverse", *SEEDS, *STRESSES, "--from", old)

    def test_another_run_than_it_began_from(self):
        """Nothing goes on, on no group."""
        out, other = self.path("out"), self.copy_old()
        process = self.start(2, out, self.old)
        os.kill(rank_kills.ranks_of(process)[0], signal.SIGKILL)
        process.communicate(timeout=600)
        before = clod.read(clod.checkpoints(out, POINTS[0])[0])
        done = run(3, RING, "-o", out, *SEEDS, *STRESSES, *LONG, "--from", other)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count("cannot go on from another one"), 1, done.stderr)
        self.assertEqual(before, clod.read(clod.checkpoints(out, POINTS[0])[0]))

    def command(self, out, old):
        return clod.without_page([clod.BINARY, "run", RING, "-o", out, *SEEDS, *STRESSES, "--from", old])

    def on_two_hosts(self, here, there, command):
        """Ranks 0 and 1, each in a folder of its own."""
        return subprocess.run([*mpirun.MPIRUN, "1", "--wdir", here, *command, ":", "-n", "1",
                               "--wdir", there, *command], text=True, timeout=600,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def make_hosts(self):
        here, there = self.path("here"), self.path("there")
        os.mkdir(there)
        shutil.copytree(self.old, os.path.join(here, "old"))
        return here, there

    def test_only_rank_0_needs_the_other_run(self):
        here, there = self.make_hosts()
        out = self.path("out")
        done = self.on_two_hosts(here, there, self.command(out, "old"))
        self.assertEqual(done.returncode, 0, done.stderr)
        one = self.path("one")
        alone = clod.run(*self.command(one, "old")[1:], cwd=here)
        self.assertEqual(alone.returncode, 0, alone.stderr)
        self.assert_same_end(one, out, [*PREPARED, *POINTS])
        self.assert_events(out, "finished", [*POINTS[0::2], *POINTS[1::2]])

    def test_a_group_without_the_folder(self):
        """It is named before any point begins; what was taken over is kept, and the run goes on."""
        here, there = self.make_hosts()
        done = self.on_two_hosts(here, there, self.command("out", "old"))
        self.assertEqual(done.returncode, 1, done.stderr)
        told = f"rank 1 on {socket.gethostname()}: Cannot open out: No such file or directory."
        self.assertEqual(done.stderr.count(told), 1, done.stderr)
        out = os.path.join(here, "out")
        self.assert_events(out, "taken over", PREPARED)
        self.assertFalse(any("-point-" in name for name in os.listdir(out)))
        shutil.rmtree(os.path.join(here, "old"))  # it is not needed any more
        done = run(3, RING, "-o", out, *SEEDS, *STRESSES)
        self.assertEqual(done.returncode, 0, done.stderr)
        one, _ = self.alone(RING, *self.options)
        for name in [f"{part}.csv" for part in POINTS] + ["points.csv"]:
            self.assertEqual(clod.read(f"{out}/{name}"), clod.read(f"{one}/{name}"), name)

    def start(self, ranks, out, old):
        """Start long points, until two groups have written rows."""
        process = mpirun.start(ranks, clod.BINARY, "run", RING, "-o", out, *SEEDS, *STRESSES,
                               *LONG, "--from", old)

        def both_run():
            tables = [f"{out}/{part}.csv" for part in POINTS[:2]]
            return all(os.path.exists(table) and clod.read(table).count(b"\n") > 3
                       for table in tables)
        self.assertTrue(clod.wait_until(both_run, process))
        return process

    def test_stopped_killed_and_gone_on(self):
        """A signal to rank 0, then SIGKILL of a rank of another group; the other run is gone by then.
        It goes on with other numbers of ranks, to the same end."""
        old, out = self.copy_old(), self.path("several")
        one, _ = self.alone(RING, *SEEDS, *STRESSES, *LONG, "--from", old)
        process = self.start(4, out, old)
        with open(f"{out}/.clod-lock") as lock:
            os.kill(int(lock.read()), signal.SIGTERM)
        _, error = process.communicate(timeout=600)
        self.assertEqual(process.returncode, 143, error)
        stopped = [event["part"] for event in clod.log(out) if event["event"] == "stopped"]
        self.assertEqual(sorted(stopped), POINTS[:3])
        os.rename(old, self.path("moved"))
        process = self.start(2, out, old)
        # rows of before are there at once, ranks are not
        self.assertTrue(clod.wait_until(lambda: len(rank_kills.ranks_of(process)) == 2, process))
        print(f"CLOD_TEST_SEED={rank_kills.SEED}")
        time.sleep(random.Random(rank_kills.SEED).uniform(0.0, 0.5))
        os.kill(rank_kills.ranks_of(process)[-1], signal.SIGKILL)
        process.communicate(timeout=600)
        self.assertNotEqual(process.returncode, 0)
        done = run(3, RING, "-o", out, *SEEDS, *STRESSES, *LONG, "--from", old)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(one, out, [*PREPARED, *POINTS])

    def test_a_point_of_another_group_that_cannot_go_on(self):
        """One process and groups say the same of its damaged checkpoints; the others go on later."""
        out = self.path("out")
        process = self.start(2, out, self.old)
        with open(f"{out}/.clod-lock") as lock:
            os.kill(int(lock.read()), signal.SIGTERM)
        process.communicate(timeout=600)
        for path in clod.checkpoints(out, POINTS[1]):
            os.truncate(path, 600)
        options = (*SEEDS, *STRESSES, *LONG, "--from", self.old)
        one = self.path("one")
        shutil.copytree(out, one)
        alone = clod.run("run", RING, "-o", one, "-t", "1", *options)
        done = run(2, RING, "-o", out, *options)
        self.assertNotEqual(alone.returncode, 0)
        self.assertEqual(done.returncode, alone.returncode, done.stderr)
        said = alone.stderr[alone.stderr.index("clod run: "):].replace(one, out)
        self.assertIn(f"{POINTS[1]}_a.h5 cannot be used", said)
        self.assertEqual(done.stderr.count(said), 1, done.stderr)


if __name__ == "__main__":
    clod.main()
