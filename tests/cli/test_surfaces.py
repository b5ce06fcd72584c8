"""output.surfaces: what grains do to facets and other surfaces: places, pictures, same bytes."""

import json
import os
import signal
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

# A stream falls onto a steep plate of two named halves, and slides from one to the other.
MESH = """\
o upper
v 0 -100 0
v 0 100 0
v 100 100 -100
v 100 -100 -100
f 1 2 3
f 1 3 4
o lower
v 200 100 -200
v 200 -100 -200
f 4 3 5
f 4 5 6
"""
CASE = """\
materials:
  ore: {density: 2500 kg/m3}
  steel: {hardness: 2 GPa, archard: 1e-3, finnie: 1e-4}
contacts:
  default: {law: hooke, k1: 1e4 N/m, restitution: 0.3, friction: 0.3}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {step: 5e-5 s, design_stress: 100 Pa}
domain: {min: [-0.1 m, -0.2 m, -0.3 m], max: [0.4 m, 0.2 m, 0.2 m], open: delete}
grains:
  - material: ore
    radius: {distribution: uniform, min: 4 mm, max: 5 mm}
    inlet: {number_flow: 200 1/s}
    region: {box: {min: [10 mm, -80 mm, 80 mm], max: [60 mm, 80 mm, 100 mm]}}
walls:
  plate: {material: steel, shapes: [{mesh: {file: plate.obj, unit: 1 mm}}]}
  floor: {material: ore, shapes: [{box: {center: [0.2 m, 0 m, -0.35 m], size: [0.6 m, 0.4 m, 20 mm]}}]}
stages: [{name: run, duration: 0.8 s}]
output: {series_interval: 50 ms, snapshot_interval: 0.4 s, surfaces: true, steady_since: 0.3 s}
"""


class Surfaces(clod.Case):

    def go(self, folder, threads="1"):
        for name, text in (("case.yaml", CASE), ("plate.obj", MESH)):
            with open(self.path(name), "w") as file:
                file.write(text)
        done = clod.run("run", "case.yaml", "-o", folder, "-t", threads, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_surfaces_are_told(self):
        report = self.go("run")
        with open(self.path("run/summary.json")) as file:
            faces = {face["name"]: face for face in json.load(file)["surfaces"]}
        self.assertEqual(list(faces), ["plate.upper", "plate.lower", "floor"])
        upper, lower = faces["plate.upper"], faces["plate.lower"]
        for name, face in (("upper", upper), ("lower", lower)):
            self.assertIn(f"plate.{name}", report)
            self.assertAlmostEqual(face["since_s"], 0.3, 9)
            self.assertAlmostEqual(face["area_m2"], 0.2 * 0.1 * 2 ** 0.5, 12)
            # friction is limited by mu N, and what slides wears: V = k F s/H
            self.assertGreater(face["press_N"], 0.0)
            self.assertLessEqual(face["shear_power_W"],
                                 0.3 * face["archard_m3_per_s"] * 2e9 / 1e-3 * 1.001)
        # grains fall onto the upper half alone, from 0.1 m and more: half of that along its normal
        self.assertGreater(upper["impact_power_W"], 2 * lower["impact_power_W"])
        self.assertGreater(lower["shear_power_W"], 0.0)
        # mean of the rows of the series since the sums began = the total
        rows = clod.table(self.path("run/series.csv"))
        late = [row for row in rows if row["time"] > 0.3 + 1e-9]
        times = [0.3] + [row["time"] for row in late]
        for column, key in (("press", "press_N"), ("shear_power", "shear_power_W"),
                            ("impacts", "impacts_per_s")):
            total = sum(row[f"surface_plate.upper.{column}"] * (times[k + 1] - times[k])
                        for k, row in enumerate(late))
            self.assertAlmostEqual(total / (times[-1] - times[0]) / upper[key], 1.0, 6)

    def test_sums_begin_with_a_run_that_goes_on(self):
        """Means are from 0.3 s after the beginning of the second run on, which is at 0.8 s."""
        self.go("first")
        done = clod.run("run", "case.yaml", "-o", "second", "-t", "1", "--from", "first",
                        cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("second/summary.json")) as file:
            faces = json.load(file)["surfaces"]
        press = {face["name"]: face["press_N"] for face in faces}
        self.assertAlmostEqual(faces[0]["since_s"], 1.1, 9)
        rows = [row for row in clod.table(self.path("second/series.csv"))
                if row["time"] > 1.1 + 1e-9]
        times = [1.1] + [row["time"] for row in rows]
        for name in ("plate.upper", "plate.lower"):
            total = sum(row[f"surface_{name}.press"] * (times[k + 1] - times[k])
                        for k, row in enumerate(rows))
            self.assertAlmostEqual(total / (times[-1] - times[0]) / press[name], 1.0, 6)

    def test_same_bytes_on_two_threads_and_after_a_stop(self):
        self.go("one")
        self.go("two", threads="2")
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE)
        process = clod.start("run", self.path("case.yaml"), "-o", self.path("cut"), "-t", "1")
        clod.wait_until(lambda: os.path.exists(self.path("cut/series.csv")) and
                        len(clod.table(self.path("cut/series.csv"))) > 8, process)
        process.send_signal(signal.SIGTERM)
        process.communicate()
        self.go("cut")
        for other in ("two", "cut"):
            for name in ("series.csv", "walls_000001.hdf"):
                self.assertEqual(clod.read(self.path(f"one/{name}")),
                                 clod.read(self.path(f"{other}/{name}")), f"{other}/{name}")


if __name__ == "__main__":
    clod.main()
