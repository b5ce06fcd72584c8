"""Runs the program with io_faults.so: calls on files are recorded, or one of them fails."""

import errno
import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

SHORT = 0  # a read or write that does half of its work
KINDS = (errno.EIO, errno.ENOSPC, errno.EINTR, SHORT)
WRITING = "write", "pwrite", "ftruncate"
# Calls that may fail without harm: the number of the process in the lock file is only told to
# other runs, what was only read needs no good close, and a checkpoint that the disk cannot read
# when the next one is written is the one to be written over.
HARMLESS = (("ftruncate", ".clod-lock"), ("pwrite", ".clod-lock"))


class Call:
    """A line of the record: what was called, on which path."""

    def __init__(self, line):
        self.name, self.path = line.split(" ", 1)
        self.file = os.path.basename(self.path)

    def __repr__(self):
        return f"{self.name} {self.file}"


def read_log(path):
    """The calls of a record, which is removed."""
    with open(path) as lines:
        calls = [Call(line) for line in lines.read().splitlines()]
    os.remove(path)
    return calls


def run(under, *arguments, at=None, only=None, error=errno.EIO, on=False, log=None, page=False):
    """Run clod; call number `at` on a path under `under` fails (all from there with `on`).

    `only` is a pair of call and path: then such calls alone are numbered.
    """
    environment = {**os.environ, "LD_PRELOAD": clod.IO_FAULTS, "CLOD_FAULT_UNDER": under}
    if log is not None:
        environment["CLOD_FAULT_LOG"] = log
    if only is not None:
        environment["CLOD_FAULT_ONLY"] = " ".join(only)
    if at is not None:
        environment |= {"CLOD_FAULT_AT": str(at), "CLOD_FAULT_ERROR": str(error),
                        "CLOD_FAULT_ON": str(int(on))}
    return clod.run(*arguments, env=environment, page=page)


def is_harmless(calls, at):
    """Whether the run may go on when this call fails with EIO."""
    call = calls[at - 1]
    if (call.name, call.file) in HARMLESS:
        return True
    if call.name == "close":
        opened = at - 2
        while not (calls[opened].path == call.path and calls[opened].name.startswith("open")):
            opened -= 1
        written = [c for c in calls[opened:at] if c.path == call.path and c.name in WRITING]
        return not written
    return call.file.startswith("restart") and call.file.endswith(".h5") and \
        call.name in ("openat", "pread", "fstat")


def ends_of_rows(calls):
    """Numbers of the calls; of equal calls on one file in a row the first and the last only."""
    kinds = [None, *((call.name, call.path) for call in calls), None]
    return [at for at in range(1, len(calls) + 1)
            if not kinds[at - 1] == kinds[at] == kinds[at + 1]]


class FaultCase(clod.Case):
    """Tests that run the same command with one fault after the other."""

    def setUp(self):
        super().setUp()
        self.assertTrue(os.path.exists(clod.IO_FAULTS), clod.IO_FAULTS)
        self.work = self.path("work")
        self.log = self.path("calls")

    def record(self, arguments, prepare, page=False):
        """The calls of a run without faults; its results stay in `whole`."""
        self.begin(prepare)
        done = run(self.work, *arguments, log=self.log, page=page)
        self.assertEqual(done.returncode, 0, done.stderr)
        calls = read_log(self.log)
        whole = self.path("whole")
        shutil.rmtree(whole, ignore_errors=True)
        shutil.copytree(self.work, whole, symlinks=True)
        return calls

    def begin(self, prepare):
        shutil.rmtree(self.work, ignore_errors=True)
        os.mkdir(self.work)
        prepare(self.work)

    def assert_whole(self, parts, what):
        """The work folder is that of the run without faults."""
        self.assert_same_folders(self.path("whole"), self.work, parts, what)

    def assert_same_folders(self, one, other, parts, what):
        names = sorted(os.listdir(one))
        self.assertEqual(sorted(os.listdir(other)), names, what)
        for name in names:
            paths = os.path.join(one, name), os.path.join(other, name)
            if os.path.isdir(paths[0]) and os.path.exists(os.path.join(paths[0], "log.jsonl")):
                self.assert_same_end(*paths, parts)
            elif os.path.isdir(paths[0]):
                self.assert_same_folders(*paths, parts, what)
            else:
                self.assertEqual(clod.read(paths[0]), clod.read(paths[1]), f"{name}: {what}")

    def fail_at(self, arguments, prepare, at, error, parts=(), only=None, on=False):
        """One fault: told, or without harm; and the same command ends as if there was none."""
        self.begin(prepare)
        done = run(self.work, *arguments, at=at, error=error, only=only, on=on, log=self.log)
        calls = read_log(self.log)
        number = at
        if only is not None:
            number = [k for k, call in enumerate(calls, 1)
                      if (call.name, call.path) == only][at - 1]
        elif at > len(calls):
            return  # the run before had more calls: folders have no order
        what = f"call {number} of {len(calls)}, {calls[number - 1]}, " + (
            "short" if error == SHORT else errno.errorcode[error])
        self.assertIn(done.returncode, (0, 1, 2), f"{what}: {done.stderr}")
        if done.returncode == 0:
            self.assertTrue(error in (errno.EINTR, SHORT) or is_harmless(calls, number),
                            f"{what}: no error was told")
            self.assert_whole(parts, what)
            return
        self.assertNotIn(error, (errno.EINTR, SHORT), f"{what}: {done.stderr}")
        self.assertIn(os.strerror(error), done.stderr, what)
        inputs = ".yaml", ".csv"  # a case or a file of points that cannot be read
        self.assertTrue(done.returncode == 1 or calls[number - 1].file.endswith(inputs), what)
        done = clod.run(*arguments)
        self.assertEqual(done.returncode, 0, f"{what}, then: {done.stderr}")
        self.assert_whole(parts, what)

    def sweep(self, arguments, prepare, parts=(), every=1, kinds=KINDS):
        """Faults at every so many calls, each kind at others; returns how many.

        Of calls in a row (the pieces of a checkpoint) a sample takes the ends only.
        """
        calls = self.record(arguments, prepare)
        numbers = ends_of_rows(calls) if every > 1 else range(1, len(calls) + 1)
        count = 0
        for k, error in enumerate(kinds):
            for at in numbers[k * every // len(kinds)::every]:
                self.fail_at(arguments, prepare, at, error, parts)
                count += 1
        self.assertGreater(count, 0)
        return count
