"""A disk that is full, or a file at its size limit: a clear error, nothing lost, and on it goes."""

import os
import re
import resource
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")


class Disk(clod.Case):

    # Series and checkpoints grow; pictures would fill the disk before there is any checkpoint.
    OPTIONS = ["-t", "1", "--set", "output.snapshot_interval=0 s", "--set",
               "output.checkpoint_interval=" + ("0.05 s" if clod.SANITIZED else "0.02 s"), "--set",
               "output.series_interval=" + ("0.08 ms" if clod.SANITIZED else "0.25 ms"), *clod.SHORT_BOX]

    def run_case(self, folder, **more):
        return clod.run("run", BOX, "-o", folder, *self.OPTIONS, **more)

    def whole(self):
        folder = self.path("whole")
        done = clod.run("run", BOX, "-o", folder, *self.OPTIONS)
        self.assertEqual(done.returncode, 0, done.stderr)
        return folder

    def fails(self, folder, reason, **more):
        done = self.run_case(folder, **more)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count(reason), 1, done.stderr)
        self.assertIn(folder, done.stderr)
        self.assertIn("the run goes on from its last checkpoint", done.stderr)

    def goes_on(self, folder):
        before = len(clod.log(folder))
        done = self.run_case(folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [event["event"] for event in clod.log(folder)[before:]]

    def test_size_limit(self):
        whole = self.whole()
        folder = self.path("limit")
        # between the size of a checkpoint and that of the whole series
        limit = os.path.getsize(os.path.join(whole, "series.csv")) // 2
        set_limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        self.fails(folder, "File too large", preexec_fn=set_limit)
        self.fails(folder, "File too large", preexec_fn=set_limit)  # again: nothing is lost
        self.assertGreater(len(clod.checkpoints(folder, "run")), 0)
        self.assertIn("resume", self.goes_on(folder))
        self.assert_same_end(whole, folder, ["run"])

    @clod.quick_only
    def test_slow_disk(self):
        """The first checkpoint takes 2 s on its way to the disk: that is said once, and the run goes on."""
        whole, folder = self.whole(), self.path("slow")
        part = os.path.join(os.path.realpath(self.folder), "slow", "restart_a.h5.part")
        done = self.run_case(folder, env={**os.environ, "LD_PRELOAD": clod.IO_FAULTS, "CLOD_FAULT_AT": "1",
                                          "CLOD_FAULT_ONLY": f"fsync {part}", "CLOD_FAULT_SLOW": "2"})
        self.assertEqual(done.returncode, 0, done.stderr)
        text = f"and there is one every 0.02 s: the file system of {folder} is slow"
        self.assertEqual(done.stderr.count(text), 1, done.stderr)
        took = re.search(r"warning: run: a checkpoint took ([\d.]+) s to write", done.stderr)
        self.assertGreaterEqual(float(took[1]), 2.0)  # and what the disk takes by itself
        self.assert_same_end(whole, folder, ["run"])

    @clod.quick_only
    def test_full_disk(self):
        disk = self.path("disk")
        os.mkdir(disk)
        whole = self.whole()
        size = sum(os.path.getsize(os.path.join(whole, name)) for name in os.listdir(whole))
        mount = ["mount", "-t", "tmpfs", "-o", f"size={6 * size // 10 // 1024}k", "none", disk]
        can = os.geteuid() == 0 and shutil.which("mount") is not None
        if not can or subprocess.run(mount, capture_output=True).returncode != 0:
            self.skipTest("a small disk needs mount and the right to do it; see test_size_limit")
        try:
            folder = os.path.join(disk, "run")
            self.fails(folder, "No space left on device")
            self.assertGreater(len(clod.checkpoints(folder, "run")), 0)
            self.fails(folder, "No space left on device")
            subprocess.run(["mount", "-o", f"remount,size={2 * size // 1024}k", disk], check=True)
            self.assertIn("resume", self.goes_on(folder))
            self.assert_same_end(whole, folder, ["run"])
        finally:
            subprocess.run(["umount", disk], check=True)


if __name__ == "__main__":
    clod.main()
