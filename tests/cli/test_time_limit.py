"""What a queue of a cluster needs of one process: a run that stops before its time is over, and none that several
processes would each compute whole. On ranks: tests/parallel/test_mpirun_limits.py."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
from rank_kills import LONG, SLIT

SMALL = clod.source("tests/support/small.yaml")


class TimeLimit(clod.Case):

    def test_times_that_are_none_are_refused(self):
        for text in ("", "0 s", "-3 h", "5", "3 days", "12:61", "1-00:00:60", "inf s", "2:00:00x"):
            done = clod.run("run", SLIT, "-o", self.path("out"), "--time-limit", text)
            self.assertEqual(done.returncode, 2, text)
            self.assertIn(f"--time-limit {text}: a time above 0 is needed", done.stderr)

    def test_times_of_batch_systems_are_read(self):
        for text in ("9 s", "1.5min", "2 h", "1 d", "10:00", "100:00:00", "1-12:00:00", "1-12:30"):
            done = clod.run("run", SMALL, "-o", self.path(text), "--time-limit", text)
            self.assertEqual(done.returncode, 0, done.stderr)

    @clod.quick_only
    def test_fields_are_days_hours_minutes_seconds(self):
        for text in ("0:01", "0:00:01", "0-00:00:01"):
            done = clod.run("run", SLIT, "-o", self.path(text), *LONG, "--set", "time.step=1e-7 s",
                            "--time-limit", text)
            self.assertEqual(done.returncode, 143, done.stderr)
            self.assertIn("before the time limit of 1 s;", done.stderr)

    @clod.quick_only
    def test_stops_in_time_and_goes_on(self):
        one, out = self.path("one"), self.path("out")
        self.assertEqual(clod.run("run", SLIT, "-o", one, "-t", "1", *LONG).returncode, 0)
        done = clod.run("run", SLIT, "-o", out, "-t", "1", *LONG, "--time-limit",
                        "0.25 s")
        self.assertEqual(done.returncode, 143, done.stderr)
        self.assertIn("before the time limit of 0.25 s; the same command goes on", done.stderr)
        self.assertTrue(clod.checkpoints(out, "run"))
        done = clod.run("run", SLIT, "-o", out, "-t", "1", *LONG, "--time-limit",
                        "2:00:00")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(one, out, ["run"])


@clod.quick_only
class Launchers(clod.Case):
    """Processes that do not see each other, each with the same command: as one that the mpirun of
    another MPI starts, or where clod knows no MPI."""

    def assert_refused(self, reason, **environment):
        out = self.path("out")
        done = clod.run("run", SMALL, "-o", out, env={**os.environ, **environment})
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(reason, done.stderr)
        self.assertIn("each would compute all: ", done.stderr)
        self.assertFalse(os.path.exists(out))

    def test_several_that_do_not_see_each_other_are_refused(self):
        for name in ("OMPI_COMM_WORLD_SIZE", "PMI_SIZE"):
            self.assert_refused("4 processes were started together", **{name: "4"})

    def test_an_unknown_number_is_refused(self):
        self.assert_refused("several processes may have been started together", PMIX_RANK="0")
        self.assert_refused("4 processes were started", PMIX_RANK="2", SLURM_STEP_NUM_TASKS="4")

    def test_one_alone_runs(self):
        done = clod.run("run", SMALL, "-o", self.path("out"),
                        env={**os.environ, "OMPI_COMM_WORLD_SIZE": "1"})
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    clod.main()
