"""On a terminal the progress line overwrites itself and shows rate and remaining time."""

import os
import pty
import re
import signal
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
CLEAR = "\r\033[K"


class Terminal(clod.Case):

    def on_terminal(self, *arguments, stop=None, at=r"(?s)(\r\033\[K.*){3}"):
        """Run with standard error on a terminal, and send a signal to `stop` when it shows a
        text like `at`; returns exit status, what was shown, stdout."""
        control, terminal = pty.openpty()
        process = subprocess.Popen([clod.BINARY, *arguments], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=terminal)
        os.close(terminal)
        shown = b""
        while True:
            try:
                shown += os.read(control, 65536)
            except OSError:  # the other end is closed
                break
            if stop is not None and re.search(at, shown.decode()):
                process.send_signal(stop)
                stop = None
        out = process.stdout.read()
        process.stdout.close()
        os.close(control)
        return process.wait(), shown.decode(), out

    # long enough for some progress lines, which come twice a second
    LONG = ["run", BOX, "-o", "out", "-t", "1", "--set", "stages.1.duration=100 s",
            "--set", "output.series_interval=10 ms", "--set", "output.snapshot_interval=0 s"]

    def test_overwrites_itself(self):
        code, shown, out = self.on_terminal(*self.LONG, stop=signal.SIGINT)
        self.assertEqual(code, 130, shown)
        self.assertEqual(out, "")
        lines = shown.split(CLEAR)
        self.assertEqual(lines[0], "")
        said = "clod: stopping after a checkpoint; again to stop at once\r\n"
        self.assertEqual(lines.count(said), 1, shown)
        lines.remove(said)
        for line in lines[1:-1]:  # each overwritten by the next: no line ends
            self.assertNotIn("\n", line)
            self.assertRegex(line, r"^run +\w+ +\d+\.\d{4} s, step \d+, \S+ grain-steps/s"
                                   r"(, at most \d+:\d\d:\d\d left of this part)?$")
        times = [float(re.search(r"([\d.]+) s,", line)[1]) for line in lines[1:-1]]
        self.assertEqual(times, sorted(set(times)))
        self.assertRegex(lines[-1], r"^clod run: stopped at step \d+; the same command goes on from "
                                    r"here\r\n$")

    def test_remaining_time(self):
        # the second stage is at rest at once: more than the 2 % from which it is estimated
        code, shown, _ = self.on_terminal(
            "run", BOX, "-o", "out", "-t", "1", "--set", "stages.2.duration=100 s",
            "--set", "stages.1.duration=90 s", "--set", "output.snapshot_interval=0 s",
            "--set", "stages.1.rest=1 m/s", stop=signal.SIGTERM, at=" left")
        self.assertEqual(code, 143, shown)
        self.assertRegex(shown, r"grain-steps/s, at most \d+:\d\d:\d\d left")

    def test_last_line_stays(self):
        code, shown, out = self.on_terminal("run", BOX, "-o", "out", "-t", "1")
        self.assertEqual(code, 0, shown)
        self.assertRegex(shown.split(CLEAR)[-1],
                         r"^run +drag +0\.22\d* s, step \d+, \S+ grain-steps/s\r\n"
                         r"clod: figures and tables for the browser: out/report.html\r\n"
                         r"(clod: This clod was built without .*\r\n)?$")
        ended = re.match(r"time (\S+) s, ", out)
        self.assertAlmostEqual(float(ended[1]), 0.22, delta=2e-5, msg=out)  # two steps


if __name__ == "__main__":
    clod.main()
