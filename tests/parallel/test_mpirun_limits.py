"""What a queue of a cluster needs: runs that stop before their time is over, alone and on ranks; who
runs where; and a warning when ranks share processors."""

import os
import socket
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import rank_kills

SLIT = clod.source("tests/parallel/slit.yaml")
SMALL = clod.source("tests/support/small.yaml")
# beyond the limits by several times
LONG = ("--set", "stages.1.duration=40 ms", "--set", "time.step=8e-7 s")


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


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
@clod.quick_only
class Ranks(clod.Case):

    def test_stop_in_time_on_ranks_and_go_on(self):
        one, out = self.path("one"), self.path("out")
        self.assertEqual(clod.run("run", SLIT, "-o", one, "-t", "1", *LONG).returncode, 0)
        done = rank_kills.run(2, "run", SLIT, "-o", out, *LONG, "--time-limit", "0.6 s")
        self.assertEqual(done.returncode, 143, done.stderr)
        self.assertEqual(done.stderr.count("before the time limit of 0.6 s"), 1, done.stderr)
        done = rank_kills.run(3, "run", SLIT, "-o", out, *LONG)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_work_was_compared(clod.log(out))
        self.assert_same_end(one, out, ["run"])

    def assert_work_was_compared(self, log):
        """At each rebuild of the last process: how even it was is of the machine's moment."""
        even = [event for event in log if event["event"] == "balance of ranks"][-1]
        end = [event for event in log if event["event"] == "finished"][-1]
        self.assertGreater(end["rebuilds"], 0)
        self.assertEqual(even["rebuilds"], end["rebuilds"])
        self.assertTrue(1 <= even["most_over_mean"] <= even["most_over_mean_at_most"], even)

    def test_places_are_logged_and_shared_processors_told(self):
        processors = len(os.sched_getaffinity(0))
        out = self.path("out")
        done = rank_kills.run(processors + 1, "run", SMALL, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = (f"warning: {processors + 1} ranks on {socket.gethostname()} have "
                f"{processors} processor")
        self.assertEqual(done.stderr.count(text), 1, done.stderr)
        events = [event for event in clod.log(out) if event["event"] == "ranks"]
        self.assertEqual(len(events), 1)
        self.assertEqual(events[0]["ranks"], processors + 1)
        self.assertEqual(events[0]["threads_each"], 1)
        starts = [event["threads"] for event in clod.log(out) if event["event"] == "start"]
        self.assertEqual(starts, [1])
        self.assertEqual(events[0]["hosts"], [{"host": socket.gethostname(),
                                               "ranks": processors + 1,
                                               "processors": processors}])
        with open("/proc/self/status") as status:
            own = [line.split()[1] for line in status if line.startswith("Cpus_allowed_list")][0]
        self.assertEqual(events[0]["binding"],
                         [{"rank": rank, "host": socket.gethostname(), "processors": own}
                          for rank in range(processors + 1)])


if __name__ == "__main__":
    clod.main()
