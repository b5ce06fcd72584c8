"""The table of bench/run-peers from records made by hand; expected numbers are worked out here."""

import json
import os
import tempfile
import unittest

import peers_path  # noqa: F401
import report
import targets
from book import Book

CLOD = {"version": "clod 1", "machine": "box", "date": "2026-01-02T03:04:05"}
PEER = {**CLOD, "version": "liggghts 3"}
LIGGGHTS = "LIGGGHTS edinburgh/stiffness"


def speed(size, grains, program, rates, threads=1, coordination=5.8, rss=102400,
          **more):
    """Records of one program's runs."""
    base = PEER if program != "clod" else CLOD
    said = {"rss_empty_kB": 2400, "rss_stepped_kB": 52400, "contacts_per_grain": 2.9,
            "near_per_contact": 1.1, "simd": "avx2"}
    return [{"kind": "speed", "size": size, "case": "plastic", "program": program, "run": run,
             "threads": threads, "warm": 5, "steps": 10, "grains": grains, "rate": rate,
             "coordination": coordination, "kinetic_J": 2.0 if program == "clod" else 3.0,
             "lists": 0, "rss_kB": rss, "clod": said, **base, **more}
            for run, rate in enumerate(rates)]


def row(text, *starts):
    """Cells of the only row that has these cells."""
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines()
            if line.startswith("|")]
    found = [cells for cells in rows if all(start in cells for start in starts)]
    assert len(found) == 1, f"{starts}: {found}"
    return found[0]


class Report(unittest.TestCase):

    def test_medians_and_ratio(self):
        # medians 26e6 and 2e6; round by round 20, 13 and 8 times, so 13; 3 J / 2 J
        text = report.text(speed("4k", 3750, "clod", [30e6, 26e6, 20e6])
                           + speed("4k", 3750, LIGGGHTS, [1.5e6, 2e6, 2.5e6]), "Linux")
        self.assertEqual(row(text, LIGGGHTS)[3:], ["1", "10", "0", "3", "2.00 (1.50 - 2.50)",
                                                   "13.00", "5.800", "1.50"])
        self.assertEqual(row(text, "26.00 (20.00 - 30.00)")[:4], ["4k", "3750", "clod", "1"])
        self.assertEqual(row(text, "at least 12")[-2:], ["13.00", "reached"])
        for word in ("clod 1", "liggghts 3", "box", "2026-01-02T03:04:05", "Linux"):
            self.assertIn(word, text)

    def test_ratios_are_those_of_a_round(self):
        # the machine is half as fast in rounds 1 and 3: 10, 10, 14, 14 and 11 times, so 11, where
        # medians would give 20e6 / 2e6; round 5 has no partner; two threads in rounds 0 and 2:
        # 36 / 20 and 28 / 28, so 1.4
        text = report.text(speed("4k", 3750, "clod", [20e6, 10e6, 28e6, 14e6, 22e6])
                           + speed("4k", 3750, LIGGGHTS, [2e6, 1e6, 2e6, 1e6, 2e6, 9e6])
                           + speed("4k", 3750, "clod", [36e6], threads=2)
                           + speed("4k", 3750, "clod", [28e6], threads=2, run=2), "Linux")
        self.assertEqual(row(text, "at least 12")[-2:], ["11.00", "MISSED"])
        self.assertEqual(row(text, "at least 1.85")[-2:], ["1.40", "MISSED"])
        self.assertEqual(row(text, "2: 1.40")[0], "4k")

    def test_missed_targets_are_said(self):
        # 22e6 / 2e6 = 11 < 12; 40e6 / 22e6 = 1.818 < 1.85; 18e6 / 22e6 = 0.818 < 0.85
        records = (speed("300k", 300000, "clod", [22e6]) + speed("300k", 300000, LIGGGHTS, [2e6])
                   + speed("300k", 300000, "clod", [40e6], threads=2)
                   + speed("1M", 1012500, "clod", [18e6]))
        text = report.text(records, "Linux")
        for wanted, value in (("at least 12", "11.00"), ("at least 1.85", "1.82"),
                              ("at least 0.85", "0.82")):
            self.assertEqual(row(text, wanted)[-2:], [value, "MISSED"])

    def test_other_work_is_said(self):
        # 5.8 and 5.6: 3.4 %
        text = report.text(speed("4k", 3750, "clod", [2e7])
                           + speed("4k", 3750, LIGGGHTS, [2e6], coordination=5.6), "Linux")
        self.assertEqual(row(text, LIGGGHTS)[-2], "5.600 DIFFERS")

    def test_memory(self):
        # clod: (152400 - 2400) kB over 300000 grains is 512 bytes, 1024 * 50000 / 300000 before;
        # the peer: (650000 - 50000) kB over 296250 grains more
        records = (speed("300k", 300000, "clod", [2e7], rss=152400, kind="memory")
                   + speed("300k", 300000, LIGGGHTS, [2e6], rss=650000)
                   + speed("4k", 3750, LIGGGHTS, [2e6], rss=50000))
        self.assertEqual(targets.bytes_per_grain(records, "300k", "clod"), 512.0)
        self.assertEqual(targets.bytes_per_grain(records, "300k", LIGGGHTS),
                         1024.0 * 600000 / 296250)
        self.assertIsNone(targets.bytes_per_grain(records, "4k", LIGGGHTS))
        text = report.text(records, "Linux")
        self.assertEqual(row(text, "at most 500")[-2:], ["512", "MISSED"])
        self.assertEqual(row(text, "512", "171")[1], "clod")  # 1024 * 50000 / 300000 = 170.7

    def test_roofline(self):
        # operations 1000 at 1e11/s: 10 ns; 35 divides and 14 roots at 7e9 and 3.5e9: 9 ns;
        # bytes per grain, 2.9 * 1.1 pairs: 136 * 3.19 + 544 = 978 at 48.9e9/s: 20 ns of 40 ns
        machine = {"sets": [{"set": "avx2", "multiply_add": 1e11, "fused": 1e11, "divide": 7e9,
                             "root": 3.5e9}], "l2_bytes": 1e6, "l3_bytes": 32e6, "bandwidth": [
            {"level": "L3", "bytes": 16e6, "threads": 1, "bytes_per_s": 48.9e9},
            {"level": "memory", "bytes": 7e8, "threads": 1, "bytes_per_s": 1e9}]}
        # a round in which the machine was slower, but for its L3
        slower = {**machine, "sets": [{"set": "avx2", "multiply_add": 5e10, "fused": 5e10,
                                       "divide": 3e9, "root": 2e9}],
                  "bandwidth": [{**machine["bandwidth"][0]},
                                {**machine["bandwidth"][1], "bytes_per_s": 5e8}]}
        machine["bandwidth"][0] = {**machine["bandwidth"][0], "bytes_per_s": 40e9}
        operations = {"kernel_contact": {"flops": 900.0, "divides": 35.0, "roots": 14.0},
                      "kernel_drift": {"flops": 100.0}}
        records = (speed("4k", 3750, "clod", [25e6])
                   + [{"kind": "machine", "program": "clod", "found": machine, "run": 0, **CLOD},
                      {"kind": "machine", "program": "clod", "found": slower, "run": 1, **CLOD},
                      {"kind": "count", "program": "clod", "found": operations, **CLOD}])
        text = report.text(records, "Linux")
        self.assertEqual(row(text, "40.0", "10.0"),
                         ["4k", "40.0", "10.0", "9.0", "20.0", "L3", "bytes", "50 %"])
        # 900, 35 and 14 over 2.9 contacts; 136 bytes * 1.1
        self.assertIn("asks for 310 additions, multiplications, minima and maxima, 12.1 divides "
                      "and 4.8 roots,\nand moves 150 bytes", text)

    def test_nothing_measured(self):
        self.assertIn("make bench-peers", report.text([], "Linux"))


class Records(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "new", "results.jsonl")

    def test_an_interrupted_bench_goes_on(self):
        first, second = speed("4k", 3750, "clod", [1e7, 2e7])
        Book(self.path).add(first)
        book = Book(self.path)
        self.assertTrue(book.has(first))
        self.assertFalse(book.has(second))
        for change in ({"version": "clod 2"}, {"steps": 11}, {"machine": "other"}):
            self.assertFalse(book.has({**first, **change}))
        book.add(second)
        with open(self.path) as file:
            self.assertEqual([json.loads(line) for line in file], [first, second])

    def test_peers_run_again_beside_another_clod(self):
        """Else a ratio would be one of runs that are hours apart."""
        old = speed("4k", 3750, "clod", [2e7], beside="clod 1") + speed(
            "4k", 3750, LIGGGHTS, [2e6], beside="clod 1")
        new = speed("4k", 3750, "clod", [3e7], beside="clod 2", version="clod 2")
        book = Book(self.path)
        for record in old + new:
            book.add(record)
        self.assertFalse(book.has({**old[1], "beside": "clod 2"}))
        self.assertTrue(book.has(old[1]))
        book.add({**old[1], "beside": "clod 2", "rate": 5e6})
        self.assertEqual(row(report.text(book.latest(), "Linux"), "at least 12")[-2:],
                         ["6.00", "MISSED"])

    def test_later_versions_count(self):
        book = Book(self.path)
        old, new = speed("4k", 3750, "clod", [1e7]), speed("4k", 3750, "clod", [2e7], threads=2,
                                                           version="clod 2")
        peer = speed("4k", 3750, LIGGGHTS, [3e6])
        for record in old + peer + new:
            book.add(record)
        self.assertEqual(book.latest(), peer + new)


if __name__ == "__main__":
    unittest.main()
