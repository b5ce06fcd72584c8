"""Hang-ups, signals that come twice, and a second Ctrl-C while a checkpoint is being written."""

import json
import os
import re
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
RING = clod.source("tests/restart/ring.yaml")
# Goes on for minutes, and writes no checkpoint before it is asked to.
LONG = ["-t", "1", "--set", "stages.1.duration=100 s", "--set", "output.series_interval=10 ms",
        "--set", "output.snapshot_interval=0 s", "--set", "output.checkpoint_interval=1 h"]


class Signals(clod.Case):

    def begin(self, folder, hang_up=signal.SIG_DFL, **more):
        """A run in its second stage, whatever the tests themselves were started under."""
        set_signals = lambda: signal.signal(signal.SIGHUP, hang_up)
        process = subprocess.Popen([clod.BINARY, "run", BOX, "-o", folder, *LONG], text=True,
                                   stdout=subprocess.PIPE, preexec_fn=set_signals,
                                   **{"stderr": subprocess.PIPE, **more})
        begun = lambda: any(event["event"] == "phase" for event in clod.log(folder))
        self.assertTrue(clod.wait_until(begun, process), "ended at once")
        return process

    def expect_stopped(self, process, number, folder):
        _, err = process.communicate(timeout=1000)
        self.assertEqual(process.returncode, 128 + number, err)
        self.assertEqual(len(clod.checkpoints(folder, "run")), 2)  # of the beginning and the end
        return err

    def goes_on(self, process, folder):
        """It writes more rows of its series, each many steps after the other: what it heard would have stopped it."""
        rows = lambda: clod.read(os.path.join(folder, "series.csv")).count(b"\n")
        before = rows()
        self.assertTrue(clod.wait_until(lambda: rows() >= before + 3, process), "it stopped")

    def test_hang_up(self):
        folder = self.path("out")
        process = self.begin(folder)
        process.send_signal(signal.SIGHUP)
        self.expect_stopped(process, signal.SIGHUP, folder)

    def test_signals_that_come_often(self):
        for number in (signal.SIGHUP, signal.SIGTERM):
            folder = self.path(str(number))
            process = self.begin(folder)
            while process.poll() is None:
                process.send_signal(number)
                time.sleep(0.002)
            self.expect_stopped(process, number, folder)

    def test_no_hang_up(self):
        """As under nohup: an ignored hang-up stays ignored."""
        folder = self.path("out")
        process = self.begin(folder, hang_up=signal.SIG_IGN)
        process.send_signal(signal.SIGHUP)
        self.goes_on(process, folder)
        process.send_signal(signal.SIGTERM)
        self.expect_stopped(process, signal.SIGTERM, folder)

    def test_nobody_reads_the_progress(self):
        """The other end of standard error is closed, as a tee that the hang-up ended first."""
        folder = self.path("out")
        process = self.begin(folder)
        process.stderr.close()
        process.stderr = None
        process.send_signal(signal.SIGUSR1)  # told to nobody, in the log too
        told = lambda: any(event["event"] == "notice" for event in clod.log(folder))
        self.assertTrue(clod.wait_until(told, process), "it ended when it told of its checkpoint")
        self.goes_on(process, folder)
        process.send_signal(signal.SIGINT)
        self.expect_stopped(process, signal.SIGINT, folder)

    def test_second_interrupt(self):
        """While the checkpoint hangs, on its way to the disk."""
        folder = self.path("out")
        part = os.path.join(os.path.realpath(folder), "restart_b.h5.part")  # a: the beginning's
        calls = self.path("calls")
        process = self.begin(folder, env={**os.environ, "LD_PRELOAD": clod.IO_FAULTS, "CLOD_FAULT_AT": "1",
                                          "CLOD_FAULT_ONLY": f"fsync {part}", "CLOD_FAULT_UNDER": part,
                                          "CLOD_FAULT_LOG": calls, "CLOD_FAULT_HANG": "1"})
        process.send_signal(signal.SIGINT)
        shown = ""
        while "again to stop at once\n" not in shown:
            line = process.stderr.readline()
            self.assertNotEqual(line, "", f"ended: {shown}")
            shown += line
        self.assertIn("clod: stopping after a checkpoint", shown)
        hangs = lambda: os.path.exists(calls) and f"fsync {part}\n".encode() in clod.read(calls)
        self.assertTrue(clod.wait_until(hangs, process), "it ended without the checkpoint")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=1000)
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertEqual(len(clod.checkpoints(folder, "run")), 1)

    def saved(self, folder):
        return sorted(name for name in os.listdir(folder) if "-at-" in name)

    def test_save(self):
        """SIGUSR1, twice: kept checkpoints and pictures of those moments, and the run goes on."""
        folder = self.path("out")
        process = self.begin(folder)
        notices = lambda: [e for e in clod.log(folder) if e["event"] == "notice"]
        for count in (1, 2):
            process.send_signal(signal.SIGUSR1)
            self.assertTrue(clod.wait_until(lambda: len(notices()) == count, process))
        self.goes_on(process, folder)
        process.send_signal(signal.SIGTERM)
        err = self.expect_stopped(process, signal.SIGTERM, folder)
        names = self.saved(folder)
        self.assertEqual(len(names), 2)
        with open(os.path.join(folder, "run.hdf.series")) as file:
            pictures = [entry["time"] for entry in json.load(file)["files"]]
        for name in names:
            head = clod.read(os.path.join(folder, name))[:clod.HEAD].decode()
            moment = re.search(r"time (\S+) s", head)[1]
            self.assertEqual(re.search(r"step (\d+)", head)[1], re.search(r"\d+", name)[0])
            self.assertIn(float(moment), pictures)
            self.assertIn(f"{name} and a snapshot are written, time {float(moment):.9g} s", err)

    @clod.quick_only
    def test_save_changes_no_bit(self):
        """Parts side by side each save, and end as in a run that nobody disturbed."""
        options = ("-t", "2", "--set", "ring_shear.seeds=2")
        for name in ("whole", "out"):
            process = subprocess.Popen([clod.BINARY, "run", RING, "--no-report", "-o", self.path(name), *options],
                                       stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
            seeds = lambda: {part for part in ("seed-7", "seed-8") for file in self.saved(self.path(name)) if part in file}
            if name == "out":  # a part that begins just then does not save: once more, until both seeds have
                clod.wait_until(lambda: any(e.get("to") == "preshear" for e in clod.log(self.path(name))), process)
                while len(seeds()) < 2 and process.poll() is None:
                    process.send_signal(signal.SIGUSR1)
                    time.sleep(0.05)
            self.assertEqual(process.wait(1000), 0)
        self.assertEqual(seeds(), {"seed-7", "seed-8"})
        for name in os.listdir(self.path("whole")):
            if name.endswith(".csv"):
                self.assertEqual(clod.read(self.path(f"whole/{name}")),
                                 clod.read(self.path(f"out/{name}")), name)


if __name__ == "__main__":
    clod.main()
