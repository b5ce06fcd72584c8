"""Standard output and standard error that cannot be written, or came closed."""

import os
import shlex
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

POINTS = clod.source("tests/analysis/seeds/two_groups.csv")
BENCH = clod.source("cases/contact-bench/case.yaml")
MESH = clod.source("tests/mesh/seeds/faults.stl")
SMALL = clod.source("tests/support/small.yaml")
VERIFY = ["verify", "chung-ooi-2", "-o", "verify"]
RUN = ["run", SMALL, "-o", "run", "--threads", "1"]

VERBS = ["new", "run", "check", "contact", "locus", "mesh", "explain", "schema", "verify"]
SPEAKING = [["--help"], ["--version"], *([verb, "--help"] for verb in VERBS), ["new"],
            ["new", "free-run", "new.yaml"], ["contact", BENCH], ["contact", "-s", BENCH],
            ["locus", POINTS], ["locus", "--json", POINTS], ["locus", "--csv", POINTS],
            ["mesh", MESH, "--unit=mm"], ["mesh", MESH, "--unit=mm", "--json"],
            ["explain"], ["explain", "--manual"], ["explain", "k1"], ["schema"],
            ["verify", "--list"], ["check", SMALL], ["check", "--json", SMALL], RUN, VERIFY]


class Streams(clod.Case):

    def spoken(self, arguments, redirection):
        """Run clod through a shell, from an empty folder."""
        for name in os.listdir(self.folder):
            path = self.path(name)
            shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)
        line = shlex.join([clod.BINARY, *arguments]) + " " + redirection
        return subprocess.run(line, shell=True, cwd=self.folder, text=True, timeout=1000,
                              capture_output=True)

    def test_standard_output(self):
        for arguments in SPEAKING:
            for redirection, reason in ((">/dev/full", "No space left on device"),
                                        (">&-", "Bad file descriptor")):
                with self.subTest(arguments=arguments, to=redirection):
                    done = self.spoken(arguments, redirection)
                    self.assertEqual(done.returncode, 1, done.stderr)
                    told = [line for line in done.stderr.splitlines() if "writ" in line]
                    self.assertEqual(len(told), 1, done.stderr)
                    if arguments[0] != "run":
                        self.assertIn(reason, told[0])

    def test_standard_error(self):
        # verbs that say something there when all is well
        for arguments in (["contact", BENCH], RUN, VERIFY):
            for redirection in ("2>/dev/full", "2>&-"):
                with self.subTest(arguments=arguments, to=redirection):
                    done = self.spoken(arguments, redirection)
                    self.assertEqual(done.returncode, 1, done.stdout)
        for arguments in (["schema"], ["explain", "k1"], ["new"]):
            for redirection in ("2>/dev/full", "2>&-"):
                self.assertEqual(self.spoken(arguments, redirection).returncode, 0)

    def test_a_table_without_room(self):
        # no run, so nothing is promised that goes on
        for arguments in (["contact", BENCH], ["locus", POINTS], ["locus", "--csv", POINTS]):
            with self.subTest(arguments=arguments):
                done = self.spoken([*arguments, "-o", "/dev/full"], "")
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("Cannot write /dev/full: No space left on device. Free some space, "
                              "then give the same command again.", done.stderr)
                self.assertNotIn("checkpoint", done.stderr)

    def test_no_file_gets_the_number_of_a_closed_stream(self):
        # the table goes to FILE: nothing of what is said may end up in it
        table = self.path("table.csv")
        self.assertEqual(self.spoken(["contact", BENCH, "-o", "table.csv"], "").returncode, 0)
        expected = clod.read(table)
        for redirection in (">&-", "2>&-", "<&- >&- 2>&-"):
            self.spoken(["contact", BENCH, "-o", "table.csv"], redirection)
            self.assertEqual(clod.read(table), expected)


if __name__ == "__main__":
    clod.main()
