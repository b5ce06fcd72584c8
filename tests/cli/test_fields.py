"""Fields of a free run: a column at rest with the stresses of its weight, shear, same bytes."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

G = 9.81
# Grains settle on a floor between periodic sides.
COLUMN = """\
materials: {ore: {density: 2500 kg/m3}}
contacts:
  default: {law: hooke, k1: 2e3 N/m, restitution: 0.1, friction: 0.5, rolling: epsd2,
            rolling_friction: 0.2}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {design_stress: 500 Pa}
domain: {min: [0 m, 0 m, -10 mm], max: [40 mm, 40 mm, 200 mm], periodic: [true, true, false]}
grains:
  - material: ore
    count: 250
    radius: {distribution: uniform, min: 2.7 mm, max: 3.3 mm}
    region: {box: {min: [0 mm, 0 mm, 3 mm], max: [40 mm, 40 mm, 80 mm]}}
walls:
  base: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}
gauges:
  whole: {region: {box: {min: [0 mm, 0 mm, -10 mm], max: [40 mm, 40 mm, 200 mm]}}}
  upper: {region: {box: {min: [0 mm, 0 mm, 12 mm], max: [40 mm, 40 mm, 200 mm]}}}
fields:
  whole: {region: {box: {min: [0 mm, 0 mm, -10 mm], max: [40 mm, 40 mm, 200 mm]}}}
  upper: {region: {box: {min: [0 mm, 0 mm, 12 mm], max: [40 mm, 40 mm, 200 mm]}}}
  floor: {region: {box: {min: [0 mm, 0 mm, -10 mm], max: [40 mm, 40 mm, 1 mm]}}, interval: 2 ms}
  grid:
    region: {box: {min: [0 mm, 0 mm, -12 mm], max: [40 mm, 40 mm, 60 mm]}}
    cell: 4 mm
    width: 12 mm
stages: [{name: settle, duration: 0.5 s}]
output: {series_interval: 20 ms, steady_since: 0.4 s}
"""


class Fields(clod.Case):

    def write(self, text):
        with open(self.path("case.yaml"), "w") as file:
            file.write(text)

    def mean(self, field, key):
        return self.summary("out")["fields"][field][key]["mean"]

    def total(self, field, key):
        """Integral over the region of a field."""
        volume = self.summary("out")["fields"][field]["volume_m3"]
        mean = self.mean(field, key)
        return [volume * x for x in mean] if isinstance(mean, list) else volume * mean

    @clod.quick_only
    def test_a_column_at_rest(self):
        """At rest the force through a level plane is the weight of the grains with centres above it:
        stress integrated over z > z0 is sum m g (z - z0), which gauges know too."""
        self.write(COLUMN)
        done = self.go("out")
        gauges = self.summary("out")["gauges"]
        mass = gauges["whole"]["mass_kg"]["mean"]
        self.assertAlmostEqual(self.total("whole", "density_kg_per_m3"), mass, delta=1e-12)
        self.assertAlmostEqual(self.total("whole", "solid_fraction"), mass / 2500.0, delta=1e-14)
        for name, bottom in (("whole", 0.0), ("upper", 0.012)):
            gauge = gauges[name]
            lever = gauge["mass_kg"]["mean"] * G * (gauge["center_z_m"]["mean"] - bottom)
            self.assertGreater(lever, 4e-3)
            stress = self.total(name, "contact_stress_Pa")
            self.assertLess(abs(stress[8] - lever), 2e-4 * lever)
            self.assertLess(abs(stress[2]), 0.01 * lever)  # no shear on a level floor
            self.assertLess(abs(stress[5]), 0.01 * lever)
            self.assertGreater(min(stress[0], stress[4]), 0.2 * lever)
        self.assertEqual(self.total("upper", "wall_force_N_per_m3"), [0.0, 0.0, 0.0])
        # the floor carries all; its force is that of the wall, and both zones have all of it
        force = self.total("whole", "wall_force_N_per_m3")
        self.assertLess(abs(force[2] - mass * G), 1e-4 * mass * G)
        last = clod.table(self.path("out/series.csv"))[-1]
        self.assertLess(abs(force[2] + last["base.force_z"]), 1e-4 * mass * G)
        for one, other in zip(force, self.total("floor", "wall_force_N_per_m3")):
            self.assertLess(abs(one - other), 1e-4 * mass * G)
        self.assertLess(self.mean("whole", "temperature_m2_per_s2"), 1e-6)
        contacts = self.summary("out")["coordination"]
        self.assertLess(abs(self.mean("whole", "coordination") - contacts), 0.5)  # with the floor
        self.assertRegex(done.stdout, r"field whole .* Pa \(\+- standard deviation of ten blocks\)\n")
        self.assertIn("field_grid.hdf", done.stdout)
        self.assertTrue(os.path.exists(self.path("out/field_grid.hdf")))

    def test_check_warns_of_a_narrow_kernel(self):
        self.write(COLUMN.replace("cell: 4 mm", "cell: 2.5 mm").replace("width: 12 mm", "width: 5 mm"))
        done = clod.run("check", self.path("case.yaml"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("fields.grid.width 0.005 m is less than the largest grain, 0.006",
                      " ".join(done.stdout.split()))
        self.write(COLUMN)
        self.assertNotIn("fields.grid", clod.run("check", self.path("case.yaml")).stdout)

    def test_free_fall(self):
        """Before anything touches: the velocity is that of the fall, stresses are none."""
        self.write(COLUMN.replace("max: [40 mm, 40 mm, 80 mm]", "max: [40 mm, 40 mm, 180 mm]")
                   .replace("3 mm], max", "90 mm], max").replace("duration: 0.5 s", "duration: 60 ms")
                   .replace("steady_since: 0.4 s", "steady_since: 0 s"))
        self.go("out")
        rows = clod.table(self.path("out/series.csv"))
        # samples at 0, 10 and 20 ms, 30 and 40 ms, 50 and 60 ms: one at the moment of a row is in it
        for row, time in zip(rows, (0.010, 0.035, 0.055)):
            self.assertAlmostEqual(row["field_whole.velocity_z"], -G * time, delta=2e-3)
            self.assertEqual(row["field_whole.contact_stress_zz"], 0.0)
        self.assertTrue(math.isnan(rows[0]["field_floor.velocity_z"]))
        self.assertEqual(rows[0]["field_floor.density"], 0.0)
        self.assertEqual(self.summary("out")["fields"]["grid"]["samples"], 7)

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(COLUMN.replace("duration: 0.5 s", "duration: 0.3 s")
                   .replace("steady_since: 0.4 s", "steady_since: 0.05 s")
                   .replace("width: 12 mm", "width: 12 mm\n    frames: true")
                   .replace("series_interval: 20 ms", "series_interval: 20 ms, snapshot_interval: 50 ms"))
        self.go("one")
        self.go("two", "2")
        self.stop_after(5, "cut")
        self.go("cut")
        frames = sorted(name for name in os.listdir(self.path("one")) if "grid-" in name)
        self.assertEqual(frames, [f"field_grid-{k:06d}.hdf" for k in range(6)])
        with open(self.path("one/field_grid.hdf.series")) as file:
            listed = json.load(file)["files"]
        self.assertEqual([one["name"] for one in listed], frames)
        for one, time in zip(listed, (0.05, 0.1, 0.15, 0.2, 0.25, 0.3)):
            self.assertAlmostEqual(one["time"], time, delta=1e-4)
        for name in ("series.csv", "field_grid.hdf", "field_grid.hdf.series", *frames):
            whole = clod.read(self.path("one/" + name))
            self.assertEqual(whole, clod.read(self.path("two/" + name)), name)
            self.assertEqual(whole, clod.read(self.path("cut/" + name)), name)
        whole = clod.without_clock(clod.read(self.path("one/summary.json")))
        self.assertEqual(whole, clod.without_clock(clod.read(self.path("two/summary.json"))))
        self.assertEqual(whole, clod.without_clock(clod.read(self.path("cut/summary.json"))))

    def test_frames_behind_the_last_checkpoint_are_written_again(self):
        """As when a run was killed: what it had written after its checkpoint goes, and comes again."""
        self.write(COLUMN.replace("duration: 0.5 s", "duration: 0.3 s")
                   .replace("steady_since: 0.4 s", "steady_since: 0.05 s")
                   .replace("width: 12 mm", "width: 12 mm\n    frames: true")
                   .replace("series_interval: 20 ms", "series_interval: 20 ms, snapshot_interval: 30 ms"))
        self.go("one")
        self.stop_after(4, "cut")
        kept = [(path, clod.read(path)) for path in clod.checkpoints(self.path("cut"), "run")]
        self.stop_after(10, "cut")
        for path, content in kept:
            with open(path, "wb") as file:
                file.write(content)
        self.go("cut")
        frames = [name for name in sorted(os.listdir(self.path("one"))) if "field_grid" in name]
        self.assertEqual(len(frames), 12)
        self.assertEqual(frames, [n for n in sorted(os.listdir(self.path("cut"))) if "field_grid" in n])
        for name in frames:
            self.assertEqual(clod.read(self.path("one/" + name)), clod.read(self.path("cut/" + name)), name)

    def test_a_grid_of_before_goes(self):
        short = COLUMN.replace("duration: 0.5 s", "duration: 20 ms").replace("0.4 s", "0 s")
        self.write(short)
        self.go("out")
        self.write(short.replace("  grid:", "  other:"))
        self.go("out", "1", "--fresh")
        self.assertFalse(os.path.exists(self.path("out/field_grid.hdf")))
        self.assertTrue(os.path.exists(self.path("out/field_other.hdf")))


if __name__ == "__main__":
    clod.main()
