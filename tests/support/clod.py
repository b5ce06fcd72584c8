"""Runs the program as a user does, and compares what two runs left behind.

CTest gives the program in CLOD_BINARY and, in a tree with sanitizers, CLOD_SANITIZED=1.
"""

import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

BINARY = os.environ.get("CLOD_BINARY", "clod")
IO_FAULTS = os.path.join(os.path.dirname(os.path.abspath(BINARY)), "io_faults.so")  # support/preload/io_faults.c
SANITIZED = os.environ.get("CLOD_SANITIZED", "") == "1"
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Stages of tests/restart/box.yaml: with sanitizers a third as long, which runs the same code.
BOX_END = 0.07 if SANITIZED else 0.22  # s
SHORT_BOX = [word for k, duration in enumerate(("25 ms", "25 ms", "20 ms") if SANITIZED else ())
             for word in ("--set", f"stages.{k}.duration={duration}")]
# In memory where there is such a folder: some thousand files are brought to the disk.
MEMORY = "/dev/shm"
TEMPORARY = MEMORY if os.access(MEMORY, os.W_OK) else None
HEAD = 512  # bytes of text in front of the HDF5 data of a checkpoint
CLOCK = 32  # most bytes by which two checkpoints of one moment differ: clock time and checksum


def source(path):
    """Absolute path of a file of the repository."""
    return os.path.join(SOURCE, path)


def without_page(command):
    """The command, each `clod run` in it without its page: that is for tests/report to look at."""
    made = []
    for word in command:
        made += [word, "--no-report"] if made[-1:] == [BINARY] and word == "run" else [word]
    return made


def run(*arguments, timeout=1000, page=False, **more):
    """Run clod to its end; stdout and stderr as text. `page`: as a user does, with the page of a complete run."""
    more = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more}
    command = [BINARY, *arguments]
    return subprocess.run(command if page else without_page(command), text=True, timeout=timeout, **more)


def start(*arguments):
    """Start clod and return at once."""
    return subprocess.Popen(without_page([BINARY, *arguments]), text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE)


def log(folder):
    """Events of a results folder; none before there is a log."""
    path = os.path.join(folder, "log.jsonl")
    if not os.path.exists(path):
        return []
    with open(path) as lines:
        return [json.loads(line) for line in lines if line.endswith("\n")]


def checkpoints(folder, part):
    """Paths of the checkpoints of a part, `run` for a free run; the newest first."""
    stem = "restart" if part == "run" else f"restart-{part}"
    found = []
    for letter in "ab":
        path = os.path.join(folder, f"{stem}_{letter}.h5")
        if os.path.exists(path):
            with open(path, "rb") as file:
                lines = file.read(HEAD).decode().splitlines()
            sequence = [line for line in lines if line.startswith("sequence ")]
            found.append((int(sequence[0].split()[1]), path))
    return [path for _, path in sorted(found, reverse=True)]


def wait_until(condition, process=None, seconds=1000):
    """Wait for a condition; false when the process ended first."""
    end = time.monotonic() + seconds
    while not condition():
        if process is not None and process.poll() is not None:
            return False
        if time.monotonic() > end:
            raise TimeoutError("waited in vain")
        time.sleep(0.003)
    return True


def read(path):
    with open(path, "rb") as file:
        return file.read()


def table(path, gaps=("rho_inside",)):
    """A CSV file as a list of rows of numbers by name, units cut off the names; cells of columns in `gaps`, which narrow cells do not have, may be empty: nan."""
    with open(path, newline="") as file:
        rows = csv.reader(file)
        names = [name.split(" [")[0] for name in next(rows)]
        return [{name: float("nan" if cell == "" and name in gaps else cell) for name, cell in zip(names, row)} for row in rows]


def mean(rows, name):
    return sum(row[name] for row in rows) / len(rows)


def without_clock(summary):
    """A summary without its time on the clock."""
    table = json.loads(summary)
    for part in table.get("parts", [table]):
        del part["wall_clock_s"]
    return table


# Ten times slower with sanitizers, and nothing that other tests do not run as well.
quick_only = unittest.skipIf(SANITIZED, "left out in a tree with sanitizers")


def make_folder():
    return tempfile.mkdtemp(prefix="clod-", dir=TEMPORARY)


class Case(unittest.TestCase):
    """A test with a folder of its own."""

    maxDiff = 4000

    def setUp(self):
        self.folder = make_folder()
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def go(self, folder, threads="1", *options):
        """Run case.yaml of the test's folder to its end."""
        done = run("run", "case.yaml", "-o", folder, "-t", threads, *options, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def rows(self, folder):
        return table(self.path(folder + "/series.csv"))

    def summary(self, folder):
        with open(self.path(folder + "/summary.json")) as file:
            return json.load(file)

    def stop_after(self, rows, folder, csv_name="series.csv", threads="1"):
        """Stop a run of case.yaml with a checkpoint when a table has more than so many rows."""
        path = self.path(f"{folder}/{csv_name}")
        process = start("run", self.path("case.yaml"), "-o", self.path(folder), "-t", threads)
        wait_until(lambda: os.path.exists(path) and read(path).count(b"\n") > rows + 1, process)
        process.send_signal(signal.SIGTERM)
        process.communicate()
        self.assertEqual(process.returncode, 143)
        self.assertFalse(os.path.exists(self.path(folder + "/summary.json")))

    def assert_same_state(self, one, other):
        """Two checkpoints hold the same bytes but for the clock."""
        a, b = read(one)[HEAD:], read(other)[HEAD:]
        self.assertEqual(len(a), len(b), f"{one} and {other}")
        differ = [k for k in range(len(a)) if a[k] != b[k]]
        width = differ[-1] - differ[0] + 1 if differ else 0
        self.assertLessEqual(width, CLOCK, f"{one} and {other} differ in {len(differ)} bytes")

    def assert_same_end(self, one, other, parts):
        """Two results folders hold the same tables, pictures, results and last states."""
        own = ("log.jsonl", ".clod-lock", "summary.json", "report.txt")  # with the clock
        names = [sorted(name for name in os.listdir(folder)
                        if name not in own and not name.startswith("restart"))
                 for folder in (one, other)]
        self.assertEqual(names[0], names[1])
        for name in names[0]:
            self.assertTrue(without_folder(one, name) == without_folder(other, name),
                            f"{name} differs in {one} and {other}")
        for part in parts:
            self.assert_same_state(checkpoints(one, part)[0], checkpoints(other, part)[0])
        if os.path.exists(os.path.join(one, "summary.json")):
            self.assertEqual(without_clock(read(os.path.join(one, "summary.json"))),
                             without_clock(read(os.path.join(other, "summary.json"))))


def without_folder(folder, name):
    """Bytes of a file of results; in ParaView's state file without the folders of its films."""
    content = read(os.path.join(folder, name))
    if name.endswith(".pvsm"):
        return re.sub(rb'"[^"]*/([^"/]*\.hdf\.series)"', rb'"\1"', content)
    return content


class TesterCase(Case):
    """Tests of what one run of a tester leaves: CASE is run once, with OPTIONS."""

    OPTIONS = ()
    POINTS = "points.csv"

    @classmethod
    def setUpClass(cls):
        cls.out = make_folder()
        cls.addClassCleanup(shutil.rmtree, cls.out)
        done = run("run", cls.CASE, "-o", cls.out, *cls.OPTIONS)
        assert done.returncode == 0, done.stderr
        cls.report = done.stdout
        with open(os.path.join(cls.out, "summary.json")) as file:
            cls.summary = json.load(file)
        cls.part = {part["part"]: part for part in cls.summary["parts"]}
        cls.series = {name: table(os.path.join(cls.out, f"{name}.csv")) for name in cls.part}
        cls.points = table(os.path.join(cls.out, cls.POINTS))

    def assert_same_end_after_interruptions(self, phases, parts):
        """Interrupted when each of these phases has begun, the run goes on to the end of `out`."""
        folder = self.path("cut")
        for phase in phases:
            ready = lambda: any({"event": "phase", "to": phase}.items() <= event.items()
                                for event in log(folder))
            process = start("run", self.CASE, "-o", folder, "-t", "1")
            self.assertTrue(wait_until(ready, process), "ended before it was interrupted")
            process.send_signal(signal.SIGINT)
            _, err = process.communicate(timeout=1000)
            self.assertEqual(process.returncode, 128 + signal.SIGINT, err)
        done = run("run", self.CASE, "-o", folder, "-t", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(self.out, folder, parts)


def main():
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]])
