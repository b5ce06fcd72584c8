"""clod under mpirun: the same files as one process writes, whatever the number of ranks.

Skipped where clod was built without MPI. A rank that waits keeps a processor busy: on two processors three
ranks take twice as long as two, seven ten times. So most tests here have two, and none more than four;
test_mpirun_shapes_slow.py goes to 16, and step/test_ranks*.c and sim/test_*ranks*.c do, with ranks that are threads.
"""

import glob
import os
import re
import shutil
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
from mpirun import MPIRUN

RAIN = clod.source("tests/parallel/rain.yaml")
STREAM = clod.source("tests/parallel/stream.yaml")
SLIT = clod.source("tests/parallel/slit.yaml")
CHUTE = clod.source("tests/parallel/chute.yaml")
LAYERS = clod.source("tests/parallel/layers.yaml")
SMALL = clod.source("tests/support/small.yaml")
RING = clod.source("tests/restart/ring.yaml")
UNIAXIAL = clod.source("tests/faults/uniaxial.yaml")
JENIKE = clod.source("tests/restart/jenike.yaml")
WALL_FRICTION = clod.source("tests/parallel/wall_friction.yaml")
NO_LEDGER = ("--set", "output.energy=false")  # it takes most of the time


def start(ranks, *arguments):
    return subprocess.Popen([*MPIRUN, str(ranks), *clod.without_page([clod.BINARY, *arguments])], text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def without_clock(report):
    return re.sub(r"\d+ s of wall-clock time", "", report)


def run(ranks, *arguments):
    process = start(ranks, *arguments)
    process.stdout_text, process.stderr_text = process.communicate(timeout=1000)
    return process


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
@clod.quick_only
class Mpirun(clod.Case):

    def assert_same_on(self, numbers, case, *options, parts=("run",)):
        one = self.path("one")
        alone = clod.run("run", case, "-o", one, "--threads", "1", *options)
        self.assertEqual(alone.returncode, 0, alone.stderr)
        for ranks in numbers:
            out = self.path(f"ranks-{ranks}")
            done = run(ranks, "run", case, "-o", out, *options)
            self.assertEqual(done.returncode, 0, done.stderr_text)
            self.assertEqual(without_clock(done.stdout_text), without_clock(alone.stdout))
            self.assert_same_end(one, out, parts)

    def test_a_sheared_cohesive_bed(self):
        self.assert_same_on((1, 2, 3), SLIT)

    def test_grains_come_and_go_and_hang_together_on_a_mesh(self):
        self.assert_same_on((3,), RAIN, "--set", "output.surfaces=true")

    def test_all_that_is_measured_without_a_gather(self):
        self.assert_same_on((2, 3), STREAM, "--set", "output.contacts=true")
        self.assertGreater(len(glob.glob(self.path("one/contacts_*.hdf"))), 3)
        last = clod.table(self.path("one/series.csv"))[-1]
        self.assertGreater(last["outlet_below.grains"], 10)
        self.assertGreater(last["gauge_all.grains"], 10)
        self.assertGreater(last["gauge_all.passed_forward"], 10)
        self.assertGreater(last["gauge_end.passed_forward"], 10)
        self.assertGreater(last["gauge_end.passed_back"], 5)
        self.assertGreater(last["clumps.grains"], 10)
        self.assertGreater(last["clumps_low.grains"], 2)
        self.assertGreater(last["belt.resting_mass"], 0)

    def test_groups_in_layers(self):
        self.assert_same_on((2, 3), LAYERS)
        self.assertGreater(clod.read(self.path("one/leavers.csv")).count(b"\n"), 10)
        again = run(2, "run", LAYERS, "-o", self.path("ranks-3"), "--fresh")
        self.assertEqual(again.returncode, 0, again.stderr_text)
        self.assert_same_end(self.path("one"), self.path("ranks-3"), ("run",))

    def test_groups_that_do_not_fit(self):
        options = ("--set", "grains.1.mass=100 g")
        alone = clod.run("run", LAYERS, "-o", self.path("one"), *options)
        done = run(2, "run", LAYERS, "-o", self.path("two"), *options)
        self.assertEqual((done.returncode, alone.returncode), (2, 2), alone.stderr)
        self.assertIn("grains.1: only ", alone.stderr)
        self.assertIn(alone.stderr, done.stderr_text)

    def test_a_uniaxial_test(self):
        self.assert_same_on((2,), UNIAXIAL, parts=("fill", "stress-1", "stress-2"))

    def test_a_wall_friction_test(self):
        self.assert_same_on((2,), WALL_FRICTION, parts=("fill", "wall"))
        points = clod.table(self.path("ranks-2/wall_friction.csv"))
        self.assertEqual([point["wall_stress"] for point in points], [1e3, 600.0])

    def assert_same_on_ridges(self, *options):
        self.assert_same_on((2,), WALL_FRICTION, *options, *NO_LEDGER, "--set",
                            "wall_friction.plate_ridges={height: 1 mm, spacing: 4 mm}",
                            parts=("fill", "wall"))

    def test_a_wall_friction_test_on_ridges(self):
        self.assert_same_on_ridges()

    def test_a_wall_friction_ring_on_ridges(self):
        self.assert_same_on_ridges("--set", "wall_friction.cell=ring",
                                   "--set", "wall_friction.inner_radius=7 mm",
                                   "--set", "wall_friction.bar_count=0")

    def test_a_shear_test_with_a_grid_and_a_mixing_index(self):
        with open(RING) as file:
            text = file.read()
        box = "{box: {min: [-50 mm, -50 mm, -20 mm], max: [50 mm, 50 mm, 60 mm]}}"
        with open(self.path("grids.yaml"), "w") as file:
            file.write(f"{text}\nfields: {{grid: {{region: {box}, cell: 5 mm, width: 10 mm, frames: true}}}}\n"
                       f"mixing: {{size: {{region: {box}, cell: 10 mm, above: 2.8 mm}}}}\n")
        parts = ("preshear", "reverse", "point-1", "point-2")
        self.assert_same_on((2,), self.path("grids.yaml"), *NO_LEDGER, "--set", "ring_shear.preshear_min=2 mm",
                            "--set", "ring_shear.preshear_max=5 mm", parts=parts)
        for part in parts:
            self.assertTrue(os.path.exists(self.path(f"ranks-2/{part}_field_grid.hdf")))

    def test_a_jenike_test(self):
        self.assert_same_on((3,), JENIKE, "--set", "jenike.preshear_max=2.5 mm",
                            "--set", "jenike.shear_max=1 mm",
                            parts=("preshear", "reverse", "point-1", "point-2"))
        phases = {row["phase"] for row in clod.table(self.path("ranks-3/preshear.csv"))}
        self.assertEqual(phases, {0, 1, 2, 8, 3})  # fill, lower, consolidate, twist, sheared

    def test_grains_of_another_run(self):
        first = self.path("first")
        self.assertEqual(clod.run("run", SMALL, "-o", first).returncode, 0)
        self.assert_same_on((3,), SMALL, "--from", first)

    def test_one_grain(self):
        self.assert_same_on((2,), SMALL, "--set", "grains.0.count=1")

    def test_more_ranks_than_grains(self):
        self.assert_same_on((4,), SMALL, "--set", "grains.0.count=2")

    def test_goes_on_with_another_number_of_ranks(self):
        one, out = self.path("one"), self.path("several")
        self.assertEqual(clod.run("run", SLIT, "-o", one).returncode, 0)
        process = start(3, "run", SLIT, "-o", out)
        clod.wait_until(lambda: len(clod.table(os.path.join(out, "series.csv"))) > 3
                        if os.path.exists(os.path.join(out, "series.csv")) else False, process)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=1000)
        self.assertNotEqual(process.returncode, 0)
        done = run(2, "run", SLIT, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr_text)
        self.assert_same_end(one, out, ["run"])

    def test_goes_on_from_a_checkpoint_without_a_grain(self):
        """The second burst comes late, so that there is time to stop a bed that is empty."""
        one, out, other = self.path("one"), self.path("several"), self.path("other")
        late = ("--set", "grains.1.inlet.start=700 ms", "--set", "grains.1.inlet.end=712 ms",
                "--set", "stages.0.duration=730 ms")
        self.assertEqual(clod.run("run", CHUTE, "-o", one, "-t", "1", *late).returncode, 0)
        grains = {round(row["time"], 6): row["grains"]
                  for row in clod.table(f"{one}/series.csv")}
        process = start(2, "run", CHUTE, "-o", out, *late)
        clod.wait_until(lambda: os.path.exists(f"{out}/series.csv") and
                        clod.read(f"{out}/series.csv").count(b"\n") > 70, process)
        with open(f"{out}/.clod-lock") as lock:
            os.kill(int(lock.read()), signal.SIGTERM)
        _, error = process.communicate(timeout=1000)
        self.assertEqual(process.returncode, 143, error)
        stopped = [event for event in clod.log(out) if event["event"] == "stopped"][-1]
        self.assertTrue(all(number == 0 for time, number in grains.items()
                            if abs(time - stopped["time_s"]) < 2e-3), stopped)
        shutil.copytree(out, other)
        for ranks, folder in ((2, out), (0, other)):
            done = run(ranks, "run", CHUTE, "-o", folder, *late) if ranks else \
                clod.run("run", CHUTE, "-o", folder, *late)
            self.assertEqual(done.returncode, 0)
            self.assertIn("resume", [event["event"] for event in clod.log(folder)])
            self.assert_same_end(one, folder, ["run"])

    def test_other_verbs_are_refused(self):
        for verb in (("check", SMALL), ("new", "ring-shear", "-")):
            done = subprocess.run([*MPIRUN, "2", clod.BINARY, *verb], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count("only clod run and clod verify share their work"), 1)
            self.assertEqual(done.stdout, "")

    def test_verify(self):
        """One report, that of one process; the others wait."""
        done = {}
        for ranks in (1, 2):
            folder = self.path(f"verify-{ranks}")
            done[ranks] = subprocess.run([*MPIRUN, str(ranks), clod.BINARY, "verify", "-o", folder, "chung-ooi-1"],
                                         capture_output=True, text=True)
            self.assertEqual(done[ranks].returncode, 0, done[ranks].stderr)
            self.assertIn(b"chung-ooi-1", clod.read(os.path.join(folder, "verification.md")))
        self.assertEqual(done[1].stdout.replace("verify-1", ""), done[2].stdout.replace("verify-2", ""))

    def test_one_message_for_a_mistake(self):
        done = run(3, "run", self.path("none.yaml"))
        self.assertEqual(done.returncode, 2, done.stderr_text)
        self.assertEqual(done.stderr_text.count("none.yaml"), 1, done.stderr_text)

    def test_a_lost_grain_is_named_as_one_process_does(self):
        options = ("--set", "grains.0.velocity=[0 m/s, 0 m/s, -9 m/s]",
                   "--set", "walls.floor.shapes.0.plane.point=[0 m, 0 m, -1 m]")
        alone = clod.run("run", SMALL, "-o", self.path("one"), *options)
        done = run(2, "run", SMALL, "-o", self.path("two"), *options)
        self.assertEqual((done.returncode, alone.returncode), (1, 1), alone.stderr)
        self.assertIn(alone.stderr.splitlines()[-1], done.stderr_text)


if __name__ == "__main__":
    clod.main()
