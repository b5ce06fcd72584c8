"""Rows and snapshots at their intervals, as many as `clod check` says; when a stage ends early."""

import json
import os
import signal
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

RING = clod.source("tests/restart/ring.yaml")
# Two grains that fall 20 mm onto a floor and bounce; no time step that divides an interval.
FALL = """\
materials: {{ore: {{density: 2500 kg/m3}}, steel: {{}}}}
contacts:
  default: {{law: mepa, k1: 4.75e5 N/m^1.5, k2: 2.37e6 N/m^1.5, restitution: 0.3, friction: 0.35}}
time: {{step: 3e-6 s}}
domain: {{min: [-1 m, -1 m, -10 mm], max: [1 m, 1 m, 100 mm]}}
grains:
  - material: ore
    count: 2
    radius: {{distribution: uniform, min: 3 mm, max: 3.1 mm}}
    region: {{box: {{min: [0 mm, 0 mm, 20 mm], max: [40 mm, 40 mm, 40 mm]}}}}
walls:
  floor: {{material: steel, shapes: [{{plane: {{point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}}}]}}
stages: {stages}
output: {{series_interval: {series}, snapshot_interval: {snapshots}}}
"""
TENTH = "[{name: fall, duration: 0.1 s}]"


class Outputs(clod.Case):

    def write(self, stages=TENTH, series="1 ms", snapshots="1 ms"):
        with open(self.path("fall.yaml"), "w") as file:
            file.write(FALL.format(stages=stages, series=series, snapshots=snapshots))

    def go(self, folder="out", *options):
        done = clod.run("run", "fall.yaml", "-o", folder, "-t", "1", *options, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def times(self, folder="out", part="run"):
        with open(self.path(f"{folder}/{part}.hdf.series")) as file:
            entries = json.load(file)["files"]
        for number, entry in enumerate(entries):
            self.assertIn(f"snap_{number:06d}.hdf", entry["name"])
            self.assertTrue(os.path.exists(self.path(f"{folder}/{entry['name']}")))
        return [entry["time"] for entry in entries]

    def rows(self, folder="out"):
        return [row["time"] for row in clod.table(self.path(f"{folder}/series.csv"))]

    def expect(self, rows, snapshots):
        """What is there is what there should be, and what check has said."""
        self.go()
        self.assertEqual((len(self.rows()), len(self.times())), (rows, snapshots))
        done = clod.run("check", "fall.yaml", "--json", cwd=self.folder)
        report = json.loads(done.stdout)
        self.assertEqual((report["rows_most"], report["snapshots_most"]), (rows, snapshots))

    def expect_every(self, times, interval, count):
        for number, time in enumerate(times[:count], 1):
            self.assertAlmostEqual(time, number * interval, delta=1.5e-6)

    @clod.quick_only
    def test_equal_intervals(self):
        self.write()
        self.expect(100, 100)
        self.expect_every(self.times(), 1e-3, 100)
        self.expect_every(self.rows(), 1e-3, 100)

    @clod.quick_only
    def test_snapshots_between_rows(self):
        self.write(series="10 ms")
        self.expect(10, 100)
        self.expect_every(self.times(), 1e-3, 100)

    def test_each_interval_on_its_own(self):
        self.write(series="0.7 ms", snapshots="3.1 ms")
        self.expect(143, 33)  # and one at the end of the stage
        self.expect_every(self.times(), 3.1e-3, 32)

    def test_stages_do_not_shift_snapshots(self):
        """The end of a stage has a snapshot of its own, and the others stay where they were."""
        self.write("[{name: a, duration: 10.5 ms}, {name: b, duration: 9.5 ms}]")
        self.expect(11 + 10, 21)
        times = self.times()
        self.assertAlmostEqual(times.pop(10), 10.5e-3, delta=1.5e-6)
        self.expect_every(times, 1e-3, 20)

    def test_interval_shorter_than_a_step(self):
        self.write("[{name: fall, duration: 60 us}]", snapshots="1 us")
        done = self.go()
        self.assertIn("output.snapshot_interval (1e-06 s) is shorter than a time step", done.stderr)
        self.assertEqual(len(self.times()), 20)
        done = clod.run("check", "fall.yaml", cwd=self.folder)
        self.assertIn("output.snapshot_interval (1e-06 s) is shorter than a time step", done.stdout)

    def test_interrupted(self):
        """Killed anywhere, the pictures are those of a run that was not."""
        self.write("[{name: fall, duration: 0.2 s}]", series="10 ms", snapshots="1 ms")
        self.go("whole")
        kills = 0
        while True:
            process = clod.start("run", self.path("fall.yaml"), "-o", self.path("out"), "-t", "1",
                                 "--set", "output.checkpoint_interval=0.01 s")
            seen = len(os.listdir(self.path("out"))) if kills else 0
            clod.wait_until(lambda: os.path.exists(self.path("out")) and
                            len(os.listdir(self.path("out"))) > seen + 60, process)
            process.kill()
            process.communicate()
            if process.returncode == 0:
                break
            self.assertEqual(process.returncode, -signal.SIGKILL)
            kills += 1
        self.assertGreater(kills, 0)
        for name in os.listdir(self.path("whole")):
            if name.endswith((".hdf", ".csv", ".hdf.series")):
                self.assertEqual(clod.read(self.path(f"out/{name}")),
                                 clod.read(self.path(f"whole/{name}")), name)

    @clod.quick_only
    def test_tester(self):
        """Between the looks of the procedure too: each part counts from the test's beginning."""
        done = clod.run("run", RING, "-o", self.path("out"), "--set", "output.contacts=false",
                        "--set", "output.snapshot_interval=7 ms")
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in ("preshear", "point-1"):
            rows = [row["time"] for row in clod.table(self.path(f"out/{part}.csv"))]
            dt = json.loads(clod.read(self.path("out/summary.json")))["parts"][0]["dt_s"]
            first, last = int(rows[0] / 7e-3) + 1, int(rows[-1] / 7e-3)
            times = self.times(part=part)
            for number in range(first, last + 1):
                self.assertTrue(any(abs(time - 7e-3 * number) <= dt for time in times), number)

    # When a stage ends early.

    def ends(self, folder="out"):
        with open(self.path(f"{folder}/summary.json")) as file:
            stages = json.load(file)["stages"]
        logged = [(event["from"], event["reason"]) for event in clod.log(self.path(folder))
                  if event["event"] == "phase"]
        self.assertEqual(logged, [(stage["name"], stage["reason"]) for stage in stages])
        return {stage["name"]: (stage["reason"], stage["end_s"]) for stage in stages}

    def test_rest_needs_contacts(self):
        """Not before anything has fallen, whatever is written how often."""
        ends = set()
        for series in ("1 ms",) if clod.SANITIZED else ("0.1 ms", "1 ms", "0.1 s"):
            self.write("[{name: settle, duration: 1 s, rest: 20 mm/s}]", series, "0 s")
            done = self.go("out", "--fresh")
            reason, end = self.ends()["settle"]
            self.assertEqual(reason, "at rest")
            self.assertIn(f"ended at {end:.6g} s: at rest", done.stdout)
            self.assertGreater(end, (2 * 0.017 / 9.81) ** 0.5)  # it has fallen 17 mm at least
            summary = json.loads(clod.read(self.path("out/summary.json")))
            self.assertLess(summary["walls"][0]["force_N"][2], -5e-3)  # their weight
            ends.add(end)
        self.assertEqual(len(ends), 1)

    @clod.quick_only
    def test_rest_is_not_the_top_of_a_bounce(self):
        """Both grains are slower than this at first, and again at the top of each bounce."""
        self.write("[{name: settle, duration: 0.2 s, rest: 0.2 m/s}]")
        self.go()
        _, end = self.ends()["settle"]
        self.assertGreater(end, (2 * 0.017 / 9.81) ** 0.5)

    def test_no_rest_without_load(self):
        """Nothing moves and nothing touches: without gravity that is no rest."""
        self.write("[{name: settle, duration: 50 ms, rest: 1 mm/s}]")
        with open(self.path("fall.yaml"), "a") as file:
            file.write("gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n")
        self.go()
        reason, end = self.ends()["settle"]
        self.assertEqual(reason, "its duration is over")
        self.assertAlmostEqual(end, 50e-3, delta=1.5e-6)

    def test_rest_of_the_second_stage(self):
        self.write("[{name: a, duration: 1 s, rest: 20 mm/s}, {name: b, duration: 1 s, "
                   "rest: 20 mm/s}, {name: c, duration: 10 ms}]")
        self.go()
        ends = self.ends()
        self.assertEqual([reason for reason, _ in ends.values()],
                         ["at rest", "at rest", "its duration is over"])
        self.assertGreater(ends["b"][1], ends["a"][1] + 5 * 200 * 2.9e-6)


if __name__ == "__main__":
    clod.main()
