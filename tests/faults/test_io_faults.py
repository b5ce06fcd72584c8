"""Files that cannot be read or written: every fault is told, nothing is lost, and on it goes.

A sample of all calls; test_io_faults_slow.py takes every one.
"""

import errno
import os
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import io_faults as faults
from io_faults import clod

HERE = os.path.dirname(os.path.abspath(__file__))
EVERY = 60
TABLES = ("series.csv", "energy.csv")
INTERRUPTED = ("openat", "read", "pread", "write", "pwrite", "fsync", "fdatasync", "flock",
               "ftruncate", "close")
FILES = ("out", ".clod-lock", *TABLES, "log", "run.hdf.series", "snap_000000", "restart_a")


class Run(faults.FaultCase):
    """A free run with all its files: begun, gone on with, begun anew."""

    EVERY = EVERY

    def setUp(self):
        super().setUp()
        self.case = os.path.join(self.work, "free.yaml")
        self.out = os.path.join(self.work, "out")
        self.command = ["run", self.case, "-o", self.out, "-t", "1"]
        self.stopped = self.path("stopped")

    def put_case(self, work):
        shutil.copy(os.path.join(HERE, "free.yaml"), work)

    def stop_half_way(self):
        """A folder whose run was stopped by a full disk, with two checkpoints."""
        calls = self.record(self.command, self.put_case)
        rows = [at for at, call in enumerate(calls, 1)
                if call.name == "write" and call.file == "series.csv"]
        self.begin(self.put_case)
        done = faults.run(self.work, *self.command, at=rows[2 * len(rows) // 3],
                          error=errno.ENOSPC)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(len(clod.checkpoints(self.out, "run")), 2)
        shutil.copytree(self.work, self.stopped)

    def put_stopped(self, work):
        shutil.copytree(self.stopped, work, dirs_exist_ok=True)

    def test_new_run(self):
        self.sweep(self.command, self.put_case, ["run"], self.EVERY)

    def test_going_on(self):
        self.stop_half_way()
        self.sweep(self.command, self.put_stopped, ["run"], self.EVERY)

    def test_fresh(self):
        self.stop_half_way()
        self.sweep([*self.command, "--fresh"], self.put_stopped, ["run"], 2 * self.EVERY)

    def test_disk_that_stays_full(self):
        """All calls that could write fail from one of them on, and so does the removing."""
        calls = self.record(self.command, self.put_case)
        for at in range(30, len(calls), 4 * self.EVERY):
            self.fail_at(self.command, self.put_case, at, errno.ENOSPC, ["run"], on=True)

    def test_order(self):
        """Nothing is renamed, and no checkpoint tells of rows, before it is on the disk."""
        calls = self.record(self.command, self.put_case)
        unsynced = set()  # paths with bytes that a loss of power would take
        renamed = 0
        for call in calls:
            if call.name in faults.WRITING:
                unsynced.add(call.path)
            elif call.name in ("fsync", "fdatasync"):
                unsynced.discard(call.path)
            elif call.name == "renameat":
                renamed += 1
                self.assertNotIn(call.path + ".part", unsynced, f"{call.file}: no fsync")
                self.assertNotIn(self.out, unsynced, "no fsync of the folder")
                if call.file.startswith("restart"):
                    for table in TABLES:
                        self.assertNotIn(os.path.join(self.out, table), unsynced,
                                         f"{table} is not on the disk, {call.file} is")
                unsynced.add(self.out)
        self.assertNotIn(self.out, unsynced, "no fsync of the folder")
        self.assertGreater(renamed, 20)

    def test_each_close(self):
        """A close that fails is told, of every kind of file that is written."""
        calls = self.record(self.command, self.put_case)
        last = {call.path: [c.name for c in calls if c.path == call.path].count("close")
                for at, call in enumerate(calls, 1)
                if call.name == "close" and not faults.is_harmless(calls, at)}
        for file in (*TABLES, "log.jsonl", "case.yaml.part", "summary.json.part",
                     "run.hdf.series.part", "snap_000000.hdf.part", "restart_a.h5.part"):
            path = os.path.join(self.out, file)
            self.assertIn(path, last)
            self.fail_at(self.command, self.put_case, last[path], errno.EIO, ["run"],
                         only=("close", path))

    def test_each_interruption(self):
        """Every kind of call that a signal may cut short is made again."""
        calls = self.record(self.command, self.put_case)
        kinds = sorted({(call.name, call.path) for call in calls
                        if call.name in INTERRUPTED and call.file.startswith(FILES)})
        self.assertGreater(len(kinds), 30)
        for kind in kinds:
            self.fail_at(self.command, self.put_case, 1, errno.EINTR, ["run"], only=kind)

    def test_each_interruption_of_going_on(self):
        self.stop_half_way()
        self.record(self.command, self.put_stopped)
        for call, file in (("pread", "log.jsonl"), *(("ftruncate", table) for table in TABLES)):
            self.fail_at(self.command, self.put_stopped, 1, errno.EINTR, ["run"],
                         only=(call, os.path.join(self.out, file)))

    def test_each_call_of_its_page(self):
        """The run is complete whatever happens to its page: it is told, and `clod run` writes it the next time."""
        calls = self.record(self.command, self.put_case, page=True)
        last = max(at for at, call in enumerate(calls, 1) if call.file.startswith("report.txt"))
        numbers = [at for at in range(last + 1, len(calls) + 1)
                   if calls[at - 1].name in (*faults.WRITING, "openat", "fsync", "renameat", "close")]
        self.assertGreater(len(numbers), 30)
        told = 0
        for at in numbers[::max(1, self.EVERY // 6)]:
            self.begin(self.put_case)
            done = faults.run(self.work, *self.command, at=at, error=errno.ENOSPC, page=True)
            self.assertEqual(done.returncode, 0, f"{calls[at - 1]}: {done.stderr}")
            told += "but its page report.html could not be written" in done.stderr
            done = clod.run(*self.command, page=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("report.html", os.listdir(self.out))
            self.assertEqual(sorted(os.listdir(self.out)), sorted(os.listdir(self.path("whole/out"))), calls[at - 1])
        self.assertGreater(told, 3)

    def test_newest_checkpoint_cannot_be_read(self):
        """The older one is used, which is told, and nothing is lost."""
        self.stop_half_way()
        newest, older = clod.checkpoints(self.out, "run")
        self.record(self.command, self.put_stopped)
        for call in ("openat", "fstat", "pread"):
            self.begin(self.put_stopped)
            done = faults.run(self.work, *self.command, at=1, only=(call, newest))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"{newest} cannot be used: it cannot be read: Input/output error",
                          done.stderr)
            self.assertIn(f"Going on from {older}", done.stderr)
            self.assert_whole(["run"], "the older checkpoint")

    def test_nothing_is_cut_before_all_is_verified(self):
        """The older of the checkpoints is damaged too, or a table: the folder stays as it is."""
        self.stop_half_way()
        newest, older = clod.checkpoints(self.out, "run")
        for victim in (older, *(os.path.join(self.out, table) for table in TABLES)):
            self.begin(self.put_stopped)
            content = bytearray(clod.read(victim))
            content[600] ^= 1
            with open(victim, "wb") as file:
                file.write(content)
            before = self.content()
            done = faults.run(self.work, *self.command, at=1, only=("openat", newest))
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(victim, done.stderr)
            self.assertEqual(self.content(), before)

    def content(self):
        """Every file of the results but the log and the number in the lock."""
        return {name: clod.read(os.path.join(self.out, name)) for name in os.listdir(self.out)
                if name not in ("log.jsonl", ".clod-lock")}


class Parts(faults.FaultCase):
    """A shear test of several parts."""

    def test_no_part_begins_after_a_failure(self):
        def put_case(work):
            shutil.copy(os.path.join(HERE, "ring.yaml"), work)

        out = os.path.join(self.work, "out")
        command = ["run", os.path.join(self.work, "ring.yaml"), "-o", out, "-t", "1"]
        self.record(command, put_case)
        self.begin(put_case)
        done = faults.run(self.work, *command, at=1, error=errno.ENOSPC,
                          only=("openat", os.path.join(out, "point-1.csv")))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("point-1.csv: No space left on device", done.stderr)
        self.assertNotIn("point-2.csv", os.listdir(out))
        done = clod.run(*command)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_whole(["preshear", "reverse", "point-1", "point-2"], "after a full disk")

    def test_a_finished_part_is_verified(self):
        """A bit that changed in a table of a part that is over is found when it is read back."""
        self.begin(lambda work: shutil.copy(os.path.join(HERE, "ring.yaml"), work))
        out = os.path.join(self.work, "out")
        command = ["run", os.path.join(self.work, "ring.yaml"), "-o", out, "-t", "1"]
        self.assertEqual(clod.run(*command).returncode, 0)
        for name in ("preshear.csv", "reverse-energy.csv", "point-2.csv"):
            path = os.path.join(out, name)
            whole = clod.read(path)
            with open(path, "wb") as file:
                file.write(whole[:700] + bytes([whole[700] ^ 2]) + whole[701:])
            done = clod.run(*command)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(f"Cannot go on with {path}", done.stderr)
            with open(path, "wb") as file:
                file.write(whole)
        self.assertEqual(clod.run(*command).returncode, 0)


class Other(faults.FaultCase):
    """The verbs that write a file of the user."""

    EVERY = 1

    def test_new(self):
        file = os.path.join(self.work, "new.yaml")
        self.sweep(["new", "ring-shear", file], lambda work: None, every=self.EVERY)

    def test_contact(self):
        case = os.path.join(self.work, "contact.yaml")
        self.sweep(["contact", case, "-o", os.path.join(self.work, "table.csv")],
                   lambda work: clod.run("new", "contact-bench", os.path.join(work, "contact.yaml")),
                   every=self.EVERY)

    def test_locus(self):
        def put_points(work):
            with open(os.path.join(work, "points.csv"), "w") as file:
                file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
                           "5,4.2,2,2.9\n5,4.1,3,3.4\n5,4.3,4,3.9\n")

        self.sweep(["locus", os.path.join(self.work, "points.csv"), "--json", "-o",
                    os.path.join(self.work, "locus.json")], put_points, every=self.EVERY)


    def test_verify(self):
        self.sweep(["verify", "-o", os.path.join(self.work, "verify"), "chung-ooi-1"],
                   lambda work: None, every=23 * self.EVERY)


if __name__ == "__main__":
    clod.main()
