"""Ranks are killed at random moments; the same command goes on to the same end."""

import contextlib
import os
import random
import re
import signal
import subprocess
import time
import unittest

import clod
from mpirun import MPIRUN

SLIT = clod.source("tests/parallel/slit.yaml")
# beyond a time limit by several times
LONG = ("--set", "stages.1.duration=40 ms", "--set", "time.step=8e-7 s")
OFTEN = ("--set", "output.checkpoint_interval=0.05 s")
SEED = int(os.environ.get("CLOD_TEST_SEED", time.time_ns() % 1000000))


def run(ranks, *arguments):
    """Run clod on so many ranks to its end; stdout and stderr as text."""
    return subprocess.run([*MPIRUN, str(ranks), *clod.without_page([clod.BINARY, *arguments])], text=True, timeout=1000,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)


def ranks_of(mpirun):
    """Process numbers of the ranks that an mpirun has started, rank 0 first."""
    found = subprocess.run(["ps", "-o", "pid=,comm=", "--ppid", str(mpirun.pid)], text=True,
                           stdout=subprocess.PIPE, check=False).stdout
    return [int(line.split()[0]) for line in found.splitlines() if line.split()[1] == "clod"]


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
class Kills(clod.Case):

    def command(self, out):
        return clod.without_page([clod.BINARY, "run", SLIT, "-o", out, *OFTEN])

    def start(self, ranks, out):
        return subprocess.Popen([*MPIRUN, str(ranks), *self.command(out)], text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def strike(self, dice, process):
        """Kill one of the ranks, if they still run."""
        alive = ranks_of(process)
        if alive:
            with contextlib.suppress(ProcessLookupError):  # the run has ended since
                os.kill(dice.choice(alive), signal.SIGKILL)

    def assert_killed(self, process, text):
        """mpirun says so, and has ended the other ranks."""
        self.assertRegex(text, re.compile("signal 9|Killed"))

    def kill(self, dice, out):
        """Strike when another checkpoint is there, and some time after it. False: the run was faster."""
        ranks = dice.choice((2, 3, 4))
        before = clod.checkpoints(out, "run") if os.path.exists(out) else []
        ages = [os.stat(path).st_mtime_ns for path in before]
        process = self.start(ranks, out)
        fresh = lambda: os.path.exists(out) and ages != [
            os.stat(path).st_mtime_ns for path in clod.checkpoints(out, "run")]
        came = clod.wait_until(fresh, process)
        time.sleep(dice.uniform(0.0, 0.12))
        if came:
            self.strike(dice, process)
        _, text = process.communicate(timeout=1000)
        if process.returncode == 0:
            return False
        self.assert_killed(process, text)
        return True

    def go_on_after(self, kills):
        """Kill and go on so often, then to the end, with the bytes of an undisturbed run."""
        dice = random.Random(SEED)
        one = self.path("one")
        done = clod.run("run", SLIT, "-o", one, "-t", "1", *OFTEN)
        self.assertEqual(done.returncode, 0, done.stderr)
        left = kills
        for run in range(4 * kills):
            if left == 0:
                break
            out = self.path(f"run-{run}")
            before = left
            while left > 0 and self.kill(dice, out):
                left -= 1
                self.assertTrue(clod.checkpoints(out, "run"), f"seed {SEED}")
            done = clod.run("run", SLIT, "-o", out, "-t", "1", *OFTEN)
            self.assertEqual(done.returncode, 0, f"seed {SEED}: {done.stderr}")
            self.assert_same_end(one, out, ["run"])
            resumed = [event for event in clod.log(out) if event["event"] == "resume"]
            self.assertGreaterEqual(len(resumed), before - left, f"seed {SEED}")
        self.assertEqual(left, 0, f"seed {SEED}: the runs ended before they could be killed")
