"""What a queue of a cluster needs: runs on ranks that stop before their time is over; who runs where; and a
warning when ranks share processors. One process: tests/cli/test_time_limit.py."""

import os
import socket
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import rank_kills
from rank_kills import LONG, SLIT

SMALL = clod.source("tests/support/small.yaml")


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
