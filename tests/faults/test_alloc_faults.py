"""Every verb when memory ends: the k-th call for memory fails, or all from the k-th on.

A call of clod itself that fails must end in exit status 1 with a text that names memory, or change
nothing. Nothing half-written may be left, and a results folder must serve the next run. Libraries
may do worse: docs/known-crashes.md lists what they do.

This looks at some calls of each verb; test_alloc_faults_slow.py at all of them up to 2 000.
"""

import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import threading

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

SHIM = os.path.join(os.path.dirname(clod.BINARY), "alloc_faults.so")
SMALL = clod.source("tests/support/small.yaml")
BENCH = clod.source("cases/contact-bench/case.yaml")
POINTS = clod.source("tests/analysis/seeds/two_groups.csv")
MESH = clod.source("tests/mesh/seeds/faults.stl")
HOPPER = ["hopper", clod.source("cases/hopper-design/hopper.yaml"), "--set", "interval.samples=100"]
RUN = ["run", SMALL, "-o", "run", "-t", "1", "--no-report"]
RING = ["run", clod.source("tests/faults/ring.yaml"), "-o", "run", "-t", "1", "--no-report"]
UNIAXIAL = ["run", clod.source("tests/faults/uniaxial.yaml"), "-o", "run", "-t", "1", "--no-report"]
JENIKE = ["run", clod.source("tests/restart/jenike.yaml"), "-o", "run", "-t", "1", "--no-report",
          *(word for change in ("preshear_max=1.9mm", "block_displacement=0.2mm", "shear_max=1mm", "beyond_peak=0.2mm",
                                "twist_angle=2deg")
            for word in ("--set", f"jenike.{change}"))]
WALL = ["run", clod.source("tests/cli/wall_friction.yaml"), "-o", "run", "-t", "1", "--no-report",
        *(word for change in ("grain_count=60", "outer_radius=14mm", "block_displacement=0.3mm",
                              "steady_blocks=3", "shear_min=1mm", "shear_max=1.2mm")
          for word in ("--set", f"wall_friction.{change}"))]
CALIBRATE = ["calibrate", clod.source("tests/faults/plan.yaml"), "-o", "run"]
# What differs between two runs: the rate, when a calibration was written, and, of check, the lines that follow from it.
CLOCK = re.compile(r"[0-9.e+-]+ grain-steps/s|[0-9]+ s of wall-clock time|"
                   r"^(rate|wall-clock|WARNING| .*( with one| free)$).*\n|"
                   r"^ .*(slowest of five|other programs|beside these|while these).*\n|"
                   r'^  "(rate_(one|per|slow)|wall_clock|machine|processor_share|disk_free|written).*\n',
                   re.M)
# What check says when there is no memory for the packing that it times, and calibrate for the summary of a run: the rest is as ever.
LEFT_OUT = re.compile(r"are not estimated: .*no memory|no summary\.json that can be read: what it warned of is not known")
TIMED = re.compile(r"(log\.jsonl|report\.html|summary\.json|restart.*_[ab]\.h5|\.clod-lock)$")
MOST = 2000

# name: arguments
VERBS = {
    "help": ["--help"],
    "help of run": ["run", "--help"],
    "schema": ["schema"],
    "explain": ["explain"],
    "explain a key": ["explain", "k1", "seed"],
    "manual": ["explain", "--manual"],
    "new": ["new", "free-run", "new.yaml"],
    "new to standard output": ["new", "free-run", "-"],
    "new with tables": ["new", "hopper"],
    "check": ["check", SMALL, "-t", "1"],
    "check of a plate with ridges": ["check", clod.source("tests/cli/wall_roughness.yaml"), "-t", "1"],
    "check as JSON": ["check", "--json", SMALL, "-t", "1"],
    "run": RUN,
    "run with its page": RUN[:-1],
    "run again": RUN,
    "run afresh": [*RUN, "--fresh"],
    "run from another": ["run", SMALL, "--from", "before", "-o", "run", "-t", "1", "--no-report"],
    "ring shear test": RING,
    "ring shear test from another": [*RING, "--from", "before"],
    "Jenike test": JENIKE,
    "uniaxial test": UNIAXIAL,
    "uniaxial test again": UNIAXIAL,
    "wall friction test": WALL,
    "contact": ["contact", BENCH],
    "contact into a file": ["contact", BENCH, "-o", "contact.csv"],
    "locus": ["locus", POINTS],
    "wall yield locus": ["locus", clod.source("cases/hopper-design/wall.csv"), "--json"],
    "locus of standard input": ["locus", "-"],
    "locus as JSON": ["locus", "--json", POINTS, "-o", "locus.json"],
    "locus as CSV": ["locus", "--csv", POINTS, "-o", "locus.csv"],
    "hopper": [*HOPPER, "-o", "design"],
    "hopper as JSON": [*HOPPER, "--json"],
    "calibrate again": CALIBRATE, # its runs are there: those that it starts would fail, too
    "compare": ["compare", "run", "other", "-o", "both.html"],
    "mesh": ["mesh", MESH, "--unit=mm", "--grain-radius=3mm"],
    "mesh as JSON": ["mesh", MESH, "--unit=mm", "--json"],
    "verify": ["verify", "chung-ooi-2", "-o", "verify"],
    "wrong case": ["run", SMALL, "--set", "sede=1", "--set", "gravty=2"],
}
LONG = ("ring shear test", "ring shear test from another", "Jenike test",
        "uniaxial test", "wall friction test")  # up to a second a run
# The runs without faults that go before, and the folders in which they lie then.
BEFORE = {
    "run again": {"run": RUN},
    "run afresh": {"run": RUN},
    "run from another": {"before": RUN},
    "ring shear test from another": {"before": RING},
    "uniaxial test again": {"run": UNIAXIAL},
    "calibrate again": {"run": CALIBRATE},
    "compare": {"run": RUN, "other": [*RUN, "--set", "seed=2"]},
}
LIBRARIES = ("libfyaml", "libudunits2,libexpat", "libhdf5", "libgomp", "libc.")
# Those that crash by themselves without memory: docs/known-crashes.md says where.
CRASHES = ("libhdf5", "libfyaml", "libudunits2")


def files_of(folder):
    """Contents by name, without what differs between two runs."""
    found = {}
    for at, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(at, name)
            found[os.path.relpath(path, folder)] = without_clock(path)
    return found


def without_clock(path):
    """The content of a file, without what differs between two runs."""
    name = os.path.basename(path)
    if TIMED.match(name):
        return b""
    content = clod.without_folder(*os.path.split(path))
    return CLOCK.sub("", content.decode()).encode() if name in ("report.txt", "calibration.json") else content


class Fault:
    """One run of a verb in which memory ends."""

    def __init__(self, test, verb, whose, number, all_from):
        self.folder = clod.make_folder()
        self.verb, self.whose, self.number, self.all_from = verb, whose, number, all_from
        self.arguments = VERBS[verb]
        try:
            self.start(test)
        finally:
            shutil.rmtree(self.folder)

    def start(self, test):
        for folder, arguments in BEFORE.get(self.verb, {}).items():
            shutil.copytree(test.complete(arguments), os.path.join(self.folder, folder))
        report = os.path.join(self.folder, "report")
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "LD_PRELOAD": SHIM,
                       "ALLOC_FAIL": str(self.number), "ALLOC_FROM": str(int(self.all_from)),
                       "ALLOC_WHOSE": self.whose, "ALLOC_REPORT": report}
        with open(POINTS, "rb") as points:  # for those that read standard input
            done = subprocess.run([clod.BINARY, *self.arguments], cwd=self.folder, stdin=points,
                                  env=environment, capture_output=True, timeout=600)
        self.status, self.out = done.returncode, done.stdout.decode(errors="replace")
        self.told = done.stderr.decode(errors="replace")
        with open(report) as file:
            lines = file.read().splitlines()
        os.remove(report)
        self.failed = [line[7:] for line in lines if line.startswith("failed ")]
        self.crash = [line[6:] for line in lines if line.startswith("crash ")]
        last = [line.split() for line in lines if line.startswith("calls ")]
        self.calls = int(last[0][1]) if last else 0
        self.files = files_of(self.folder)
        self.after = None
        if self.failed and self.arguments[0] in ("run", "calibrate") and self.verb != "wrong case":
            self.after = subprocess.run([clod.BINARY, *self.arguments], cwd=self.folder,
                                        capture_output=True, text=True, timeout=600)
            self.files_after = files_of(self.folder)

    def wrong(self, good):
        """What is wrong with the end of this run, beside one without faults; None if nothing."""
        if self.after is not None and self.after.returncode != 0:
            return f"the folder serves no more: {self.after.stderr}"
        if self.after is not None and self.files_after != good.files:
            other = [name for name in good.files.keys() | self.files_after.keys()
                     if good.files.get(name) != self.files_after.get(name)
                     and "-failed_" not in name]  # the state in which the run before broke down
            if other:
                return f"the next run in the folder leaves other results: {other}"
        if self.status < 0:
            by = next((line.split()[0] for line in self.crash if not line.startswith("libc.")), "")
            known = self.whose != "own" and by.startswith(CRASHES)
            return None if known else f"crashed, signal {-self.status}"
        if self.arguments[0] in ("check", "calibrate") and self.status == 0 and LEFT_OUT.search(self.out):
            return None # told beside the rest of the report
        if self.status == good.status and self.told_same(good):
            return None if self.files == good.files else "files differ, exit status is the same"
        if self.status == 0 and re.search("but its page report.html could not be written|There is no 3-D view", self.told):
            return None if self.results() == good.results() else "files differ, and not those of the page"
        if self.status not in (1, 2):
            return f"exit status {self.status}, not 1, but other output"
        if not re.sub(r"^clod[a-z ]*:", "", self.told.strip()).strip():
            return "failed without a text"
        if self.whose == "own" and "memory" not in self.told:
            return "the text does not name memory"
        # a step without memory leaves the state in which it broke down, as every broken step does
        half = [name for name, content in self.files.items() if "-failed_" not in name
                and (name not in good.files
                     or (os.path.dirname(name) == "" and content != good.files[name]))]
        return f"left behind: {half}" if half else None

    def results(self):
        """All files and their contents but for a page and its figures."""
        return {(name, content) for name, content in self.files.items()
                if not re.search(r"report(-[\w-]+)?\.(svg|html)(\.part)?$", name)}

    def told_same(self, good):
        return CLOCK.sub("", self.out + self.told) == CLOCK.sub("", good.out + good.told)

    def __str__(self):
        where = "\n    ".join(self.failed[:8])
        crash = "\n    ".join(["crash in", *self.crash[:8]] if self.crash else [])
        return (f"{self.verb}: call {self.number}{' and all after it' if self.all_from else ''} of "
                f"{self.whose}: status {self.status}, told {self.told[-300:]!r}\n    {where}\n"
                f"    {crash}")


class AllocFaults(clod.Case):

    def setUp(self):
        super().setUp()
        self.lock = threading.Lock()

    def complete(self, arguments):
        """The results of a run without faults, which is made once."""
        at = self.path("-".join(os.path.basename(word) for word in arguments))
        with self.lock:
            if not os.path.exists(at):
                done = subprocess.run([clod.BINARY, *arguments, "-o", at], capture_output=True,
                                      text=True, timeout=600)
                self.assertEqual(done.returncode, 0, done.stderr)
        return at

    def numbers(self, verb, calls):
        """Of some calls: the first ones, and about five of the rest, never the same distance."""
        first, parts = (1, 3) if verb in LONG else (2, 5)
        step = max(1, calls // parts)
        return sorted({*range(1, min(calls, first) + 1), *range(first + 1, calls + 1, step),
                       calls} - {0})

    def look(self, verb, whose):
        """Let calls fail one by one; every wrong end."""
        good = Fault(self, verb, whose, 0, False)
        self.assertIn(good.status, (0, 2), good.told)
        calls = min(good.calls, MOST)
        wrong = []
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            runs = [pool.submit(Fault, self, verb, whose, k, all_from)
                    for k in self.numbers(verb, calls) for all_from in (False, True)]
            for run in concurrent.futures.as_completed(runs):
                fault = run.result()
                what = fault.wrong(good)
                if what is not None:
                    wrong.append(f"{what}\n  {fault}")
        return len(runs), wrong

    def check(self, verbs, whose):
        for verb in verbs:
            with self.subTest(verb=verb, whose=whose):
                count, wrong = self.look(verb, whose)
                print(f"{verb}, {whose}: {count} runs, {len(wrong)} wrong", flush=True)
                self.assertEqual(wrong, [], "\n".join(wrong[:20]))

    def test_own_calls(self):
        self.check(VERBS, "own")

    def test_calls_of_libraries(self):
        for library in LIBRARIES:
            self.check(("run", "run again"), library)


if __name__ == "__main__":
    clod.main()
