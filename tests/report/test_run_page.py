"""The page that a complete run writes by itself: when, when not, and what becomes of the run if it cannot."""

import os
import shutil
import signal
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod
from mpirun import MPIRUN

SMALL = clod.source("tests/support/small.yaml")
BOX = clod.source("tests/restart/box.yaml")


def is_page(name):
    return name == "report.html" or name.startswith("report-")


class RunPage(clod.Case):

    def go_with(self, *arguments, case=SMALL, out="out", code=0):
        """Run a case as a user does."""
        done = clod.run("run", case, "-o", out, "-t", "1", *arguments, cwd=self.folder, page=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def names(self, out="out"):
        return sorted(os.listdir(self.path(out)))

    def assert_no_page(self, out="out"):
        self.assertEqual([name for name in self.names(out) if is_page(name)], [])

    def test_a_complete_run_has_one(self):
        """It is what `clod report` writes, and nothing else of the results is another."""
        done = self.go_with()
        self.assertIn("clod: figures and tables for the browser: out/report.html\n", done.stderr)
        page = clod.read(self.path("out/report.html"))
        made = clod.run("report", "out", "-o", "again.html", cwd=self.folder)
        self.assertEqual(page, clod.read(self.path("again.html")))
        for line in made.stderr.splitlines():  # without scripts: what is missing
            self.assertIn(line.split(": ", 1)[1], done.stderr)
        self.assertEqual(self.go_with("--no-report", out="without").stdout.splitlines()[:3], done.stdout.splitlines()[:3])
        self.assert_no_page("without")
        drawn = [name for name in self.names() if is_page(name)]
        self.assertIn("report-kinetic-energy.svg", drawn)
        self.assertEqual(self.names("without"), [name for name in self.names() if name not in drawn])
        for name in drawn:
            os.remove(self.path(f"out/{name}"))
        self.assert_same_end(self.path("out"), self.path("without"), ["run"])

    def test_a_run_that_ended_early_has_none(self):
        process = subprocess.Popen([clod.BINARY, "run", BOX, "-o", self.path("out"), "-t", "1"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        table = self.path("out/series.csv")
        self.assertTrue(clod.wait_until(lambda: os.path.exists(table) and clod.read(table).count(b"\n") > 9, process))
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(1000), 143)
        self.assert_no_page()
        self.go_with(case=BOX)
        self.assertIn("report.html", self.names())

    def test_physics_gone_wrong_has_none(self):
        said = self.go_with("--set", "time.step=0.4 ms", "--set", "time.design_stress=1 Pa", case=BOX, code=1).stderr
        self.assertIn("clod run: ", said)
        self.assertNotIn("browser", said)
        self.assert_no_page()

    def test_a_page_that_cannot_be_written(self):
        """The run is a success: its table is told, its results are there, and the reason is."""
        whole = self.go_with("--no-report").stdout
        before = {name: clod.read(self.path(f"out/{name}")) for name in self.names() if name.endswith((".csv", ".hdf"))}
        os.mkdir(self.path("out/report.html"))
        done = self.go_with()
        self.assertEqual(done.stdout, whole)
        self.assertIn("the run is complete and its results are safe, but its page report.html could not be written",
                      done.stderr)
        self.assertIn("out/report.html", done.stderr)
        self.assertNotIn("for the browser", done.stderr)
        self.assertEqual({name: clod.read(self.path(f"out/{name}")) for name in before}, before)
        os.rmdir(self.path("out/report.html"))
        self.go_with()  # the same command writes it
        self.assertTrue(os.path.isfile(self.path("out/report.html")))

    def test_a_page_stays_as_it_is(self):
        """Of a run that was complete: `clod report` may have laid more over it. --fresh begins anew."""
        self.go_with()
        page = clod.read(self.path("out/report.html"))
        with open(self.path("out/report.html"), "wb") as file:
            file.write(page + b"<!-- laid over -->")
        self.assertIn("the page of this run stays as it is: out/report.html", self.go_with().stderr)
        self.assertTrue(clod.read(self.path("out/report.html")).endswith(b"<!-- laid over -->"))
        self.assertIn("for the browser", self.go_with("--fresh").stderr)
        self.assertFalse(clod.read(self.path("out/report.html")).endswith(b"<!-- laid over -->"))

    def test_a_page_of_the_run_on_its_way_goes(self):
        """It said that the run was not complete."""
        self.go_with("--no-report")
        os.remove(self.path("out/report.txt"))
        os.remove(self.path("out/summary.json"))
        clod.run("report", "out", cwd=self.folder)
        unfinished = clod.read(self.path("out/report.html"))
        self.go_with()
        self.assertNotEqual(clod.read(self.path("out/report.html")), unfinished)
        self.assertIn("report.txt", self.names())

    def unfinished_page(self):
        """A page that somebody had made before the run was complete."""
        self.go_with("--no-report")
        os.remove(self.path("out/report.txt"))
        os.remove(self.path("out/summary.json"))
        clod.run("report", "out", cwd=self.folder)
        self.assertIn(b"not complete", clod.read(self.path("out/report.html")))

    def test_no_page_stays_that_calls_a_complete_run_unfinished(self):
        self.unfinished_page()
        self.go_with("--no-report")
        self.assertNotIn("report.html", self.names())
        self.assertIn("for the browser", self.go_with().stderr)

    def test_nor_where_the_new_one_cannot_be_written(self):
        self.unfinished_page()
        os.mkdir(self.path("out/report.html.part"))  # in the way
        self.assertIn("could not be written", self.go_with().stderr)
        self.assertNotIn("report.html", self.names())
        os.rmdir(self.path("out/report.html.part"))
        self.assertIn("for the browser", self.go_with().stderr)
        self.assertNotIn(b"not complete", clod.read(self.path("out/report.html")))

    def test_in_the_standard_folder(self):
        shutil.copy(SMALL, self.path("small.yaml"))
        done = clod.run("run", "small.yaml", cwd=self.folder, page=True)
        self.assertIn("for the browser: run/small/report.html\n", done.stderr)
        self.assertIn("report.html", self.names("run/small"))

    @clod.unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
    @clod.quick_only
    def test_of_ranks(self):
        """Rank 0 alone writes it: the other one is in a folder of its own."""
        here, there = self.path("here"), self.path("there")
        os.mkdir(here)
        os.mkdir(there)
        command = [clod.BINARY, "run", SMALL, "-o", "out", "-t", "1"]
        done = subprocess.run([*MPIRUN, "1", "--wdir", here, *command, ":", "-n", "1", "--wdir", there, *command],
                              text=True, timeout=600, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("for the browser: out/report.html"), 1, done.stderr)
        self.assertIn("report.html", self.names("here/out"))
        self.assertEqual(os.listdir(there), [])
        self.go_with("--no-report")
        for name in self.names("here/out"):
            if is_page(name):
                os.remove(self.path(f"here/out/{name}"))
        self.assert_same_end(self.path("here/out"), self.path("out"), ["run"])


if __name__ == "__main__":
    clod.main()
