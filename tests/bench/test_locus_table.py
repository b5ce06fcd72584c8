"""bench/locus-table from a small log made by hand."""

import json
import os
import subprocess
import tempfile
import unittest

TOOL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench", "locus-table")


def event(second, name, part="", **more):
    return {"time": f"2026-01-02T03:04:{second:06.3f}Z", "event": name, "part": part, **more}


def phase(second, part, left, to, step):
    return event(second, "phase", part, **{"from": left, "to": to, "step": step})


def finished(second, part, step, clock, threads):
    return event(second, "finished", part, step=step, wall_clock_s=clock, threads=threads)


# preshear 8 s, back 2 s; then point 1 for 4 s and, when that has ended, point 2 for 3 s
LOG = [event(0, "start"),
       phase(5, "preshear", "fill", "preshear", 1000),
       phase(8, "preshear", "preshear", "done", 3000),
       finished(8, "preshear", 3000, 8.0, 2),
       phase(10, "reverse", "reverse", "done", 3500),
       finished(10, "reverse", 3500, 2.0, 2),
       phase(11, "point-1", "reduce", "shear", 3700),
       phase(14, "point-1", "shear", "done", 4500),
       finished(14, "point-1", 4500, 4.0, 1),
       phase(15, "point-2", "reduce", "shear", 3700),
       phase(17, "point-2", "shear", "done", 4100),
       finished(17, "point-2", 4100, 3.0, 1)]
ROWS = [["preshear", "2", "fill", "1000", "5.0"], ["preshear", "2", "preshear", "2000", "3.0"],
        ["reverse", "2", "reverse", "500", "2.0"], ["point-1", "1", "reduce", "200", "1.0"],
        ["point-1", "1", "shear", "800", "3.0"], ["point-2", "1", "reduce", "200", "1.0"],
        ["point-2", "1", "shear", "400", "2.0"], ["all", "", "", "5100", "17"]]


class LocusTable(unittest.TestCase):

    def table(self, log, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "log.jsonl"), "w") as file:
                file.writelines(json.dumps(row) + "\n" for row in log)
            return subprocess.run([TOOL, folder, *arguments], capture_output=True, text=True)

    def test_parts_begin_where_the_one_before_has_ended(self):
        done = self.table(LOG, "1000", "1e5=peer")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [[cell.strip() for cell in line.split("|")[1:-1]]
                for line in done.stdout.splitlines() if line.startswith("| ")]
        found = [row[:4] + [row[5]] for row in rows if row[0] in {part for part, *_ in ROWS}]
        self.assertEqual(found, ROWS)
        # 5100 steps of 1000 grains at 1e5 a second: 51 s, on two cores half of it
        self.assertEqual(rows[-1], ["peer", "0.10", "1 min", "0 min"])
        # preshear and both shears: 3200 of 5100
        self.assertIn("Of all steps 63 % are shearing", done.stdout)

    def test_unfinished_runs_are_refused(self):
        done = self.table(LOG[:-1], "1000", "1e5=peer")
        self.assertEqual(done.returncode, 2)
        self.assertIn("is not finished", done.stderr)


if __name__ == "__main__":
    unittest.main()
