"""Parts of a test on groups of ranks, compared with one process."""

import re

import clod
import mpirun


def without_clock(report):
    return re.sub(r"\d+ s of wall-clock time", "", report)


def run(ranks, *arguments):
    return mpirun.run(ranks, clod.BINARY, "run", *arguments)


class Groups(clod.Case):

    def alone(self, case, *options):
        out = self.path("one")
        done = clod.run("run", case, "-o", out, "--threads", "1", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out, done

    def assert_same(self, numbers, parts, case, *options):
        """The files, report and events of one process on so many ranks each."""
        one, alone = self.alone(case, *options)
        for ranks in numbers:
            out = self.path(f"ranks-{ranks}")
            done = run(ranks, case, "-o", out, *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(without_clock(done.stdout), without_clock(alone.stdout))
            self.assert_same_end(one, out, parts)
            self.assert_same_events(one, out)

    def assert_same_events(self, one, other):
        """The log has the events of every part, whoever had them; that checkpoints take long depends on
        the clock."""
        def events(folder):
            return sorted((event["event"], event.get("part", ""), event.get("step", 0),
                           event.get("contacts", 0), event.get("text", ""))
                          for event in clod.log(folder)
                          if "part" in event and "a checkpoint took" not in event.get("text", ""))
        self.assertEqual(events(one), events(other))
