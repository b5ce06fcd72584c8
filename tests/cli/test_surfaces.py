"""output.surfaces: what grains do to facets and other surfaces: places, pictures, same bytes."""

import json
import math
import os
import shutil
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

# One grain on a level plate, of two halves of 100 by 200 mm, each of two facets.
LEVEL = """\
o near
v 0 -100 0
v 100 -100 0
v 100 100 0
v 0 100 0
f 1 2 3
f 1 3 4
o far
v 200 -100 0
v 200 100 0
f 2 5 6
f 2 6 3
"""
ALONE = """\
materials:
  ore: {{density: 2500 kg/m3}}
  steel: {{{wear}}}
contacts: {{default: {{law: hooke, k1: 1e5 N/m, restitution: {restitution}, friction: {friction}}}}}
gravity: [0 m/s2, 0 m/s2, -{gravity} m/s2]
time: {{step: {step} s}}
domain: {{min: [-0.5 m, -0.2 m, -0.1 m], max: [0.5 m, 0.2 m, 0.2 m]}}
grains: [{{material: ore, file: grain.csv}}]
walls: {{plate: {{material: steel, shapes: [{shape}]}}}}
stages: [{{name: run, duration: {duration} s}}]
output: {{series_interval: 10 ms, surfaces: true, steady_since: 0 s}}
"""
RADIUS, STIFFNESS, HARDNESS, ARCHARD, FINNIE = 5e-3, 1e5, 2e9, 1e-3, 1e-4
MASS = 2500 * 4 / 3 * math.pi * RADIUS ** 3


class Surfaces(clod.Case):

    def go_alone(self, height, velocity, duration, **case):
        """Faces of the plate after one grain at x = 60 mm, y = -30 mm: above one facet."""
        with open(self.path("case.yaml"), "w") as file:
            wear = case.pop("wear", "hardness: 2 GPa, archard: 1e-3, finnie: 1e-4")
            shape = case.pop("shape", "{mesh: {file: plate.obj, unit: 1 mm}}")
            file.write(ALONE.format(duration=duration, wear=wear, shape=shape, **case))
        with open(self.path("plate.obj"), "w") as file:
            file.write(LEVEL)
        with open(self.path("grain.csv"), "w") as file:
            file.write("x [m],y [m],z [m],radius [m],vx [m/s],vz [m/s]\n"
                       f"0.06,-0.03,{height!r},{RADIUS},{velocity[0]!r},{velocity[1]!r}\n")
        done = clod.run("run", "case.yaml", "-o", "run", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.report = done.stdout
        with open(self.path("run/summary.json")) as file:
            return {face["name"]: face for face in json.load(file)["surfaces"]}

    def test_wear_without_a_coefficient_is_not_known(self):
        """A dash in the report and no number in the summary; with one of both, that one: not 0, which is a
        liner that does not wear."""
        for wear, given in (("", ""), ("hardness: 2 GPa, archard: 1e-3", "archard"),
                            ("hardness: 2 GPa, finnie: 1e-4", "finnie")):
            faces = self.go_alone(RADIUS, (0.2, -0.05), 2e-3, restitution=0.3, friction=0.3,
                                  gravity=9.81, step=1e-5, wear=wear)
            row = next(line for line in self.report.splitlines() if "plate.near" in line).split()
            for place, law in ((-2, "archard"), (-1, "finnie")):
                keys = (f"{law}_m3_per_s", f"{law}_depth_m_per_s")
                self.assertEqual([key in faces["plate.near"] for key in keys], [law == given] * 2, wear)
                if law == given:
                    self.assertGreater(float(row[place]), 0.0)
                else:
                    self.assertEqual(row[place], "-", wear)
            shutil.rmtree(self.path("run"))

    def test_archard_of_a_slide(self):
        """A sphere set down at speed v slips until it rolls at 5/7 v: the contact slips by
        v^2/(7 mu g) under m g, so V = k m v^2/(7 mu H), and friction takes m v^2/7."""
        speed, mu, duration = 0.3, 0.25, 0.06
        faces = self.go_alone(RADIUS - MASS * 9.81 / STIFFNESS, (speed, 0.0), duration,
                              restitution=0.3, friction=mu, gravity=9.81, step=1e-6)
        near, far = faces["plate.near"], faces["plate.far"]
        volume = ARCHARD * MASS * speed ** 2 / (7 * mu * HARDNESS)
        self.assertAlmostEqual(near["archard_m3_per_s"] * duration / volume, 1.0, 2)
        self.assertAlmostEqual(near["shear_power_W"] * duration / (MASS * speed ** 2 / 7), 1.0, 2)
        self.assertAlmostEqual(near["archard_depth_m_per_s"] * duration / (volume / 0.01), 1.0, 2)
        self.assertAlmostEqual(near["press_N"] / (MASS * 9.81), 1.0, 4)
        self.assertEqual(far["archard_m3_per_s"], 0.0)
        # nothing comes down on the plate: no cutting
        self.assertLess(near["finnie_m3_per_s"], 1e-3 * near["archard_m3_per_s"] * FINNIE / ARCHARD)

    def test_archard_of_a_belt(self):
        """A sphere put down at rest on a belt of speed v slips until it rolls, by v^2/(7 mu g) as above: the belt loses
        V = k m v^2/(7 mu H), wherever facets stand, and so no facet loses a depth. Skirts stand and have one."""
        speed, mu, duration = 0.3, 0.25, 0.06
        belt = ("{belt: {from: [0 m, 0 m, 0 m], runs: [{length: 0.2 m}, {length: 0.1 m}], width: 200 mm, speed: 0.3 m/s, "
                "skirts: {to: 0.3 m, distance: 150 mm, gap: 1 mm, height: 50 mm}}}")
        faces = self.go_alone(RADIUS - MASS * 9.81 / STIFFNESS, (0.0, 0.0), duration, restitution=0.3, friction=mu,
                              gravity=9.81, step=1e-6, shape=belt)
        volume = ARCHARD * MASS * speed ** 2 / (7 * mu * HARDNESS)
        self.assertAlmostEqual(faces["plate.run 1"]["archard_m3_per_s"] * duration / volume, 1.0, 2)
        self.assertEqual(faces["plate.run 2"]["archard_m3_per_s"], 0.0)
        for name, stands in (("run 1", False), ("run 2", False), ("skirts", True)):
            for law in ("archard", "finnie"):
                self.assertIn(f"{law}_m3_per_s", faces[f"plate.{name}"])
                self.assertEqual(f"{law}_depth_m_per_s" in faces[f"plate.{name}"], stands, name)

    def test_finnie_of_an_impact(self):
        """Without friction the speed along the plate, t, stays; that into it, n, falls from n0 to 0 as
        F dt = -m dn. V = k/H integral(2 m v f dn), v = (n^2 + t^2)^(1/2): with f = sin 2g - 3 sin^2 g
        below n = t/3 and cos^2 g/3 above, both have primitives."""
        for angle in (10, 30, 60):
            along = 0.5 * math.cos(math.radians(angle))
            into = 0.5 * math.sin(math.radians(angle))

            def shallow(n):
                v = math.hypot(n, along)
                return 2 * along * v - 1.5 * (n * v - along ** 2 * math.asinh(n / along))

            def steep(n):
                return along ** 2 / 3 * math.asinh(n / along)

            bend = min(into, along / 3)
            integral = 2 * MASS * (shallow(bend) - shallow(0) + steep(max(into, bend)) - steep(bend))
            duration = 5e-3
            faces = self.go_alone(RADIUS + 1e-6, (along, -into), duration, restitution=1.0,
                                  friction=0.0, gravity=0.0, step=2e-8)
            volume = faces["plate.near"]["finnie_m3_per_s"] * duration
            self.assertAlmostEqual(volume / (FINNIE * integral / HARDNESS), 1.0, 3, angle)
            self.assertAlmostEqual(faces["plate.near"]["impact_angle_deg"], angle, 6)
            self.assertEqual(faces["plate.far"]["finnie_m3_per_s"], 0.0)
            self.assertEqual(faces["plate.near"]["impacts_per_s"] * duration, 1.0)
            shutil.rmtree(self.path("run"))

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
            # friction is limited by mu N
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

    @clod.quick_only
    def test_same_bytes_on_two_threads_and_after_a_stop(self):
        self.go("one")
        self.go("two", threads="2")
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE)
        self.stop_after(8, "cut")
        self.go("cut")
        for other in ("two", "cut"):
            for name in ("series.csv", "walls_000001.hdf"):
                self.assertEqual(clod.read(self.path(f"one/{name}")),
                                 clod.read(self.path(f"{other}/{name}")), f"{other}/{name}")


if __name__ == "__main__":
    clod.main()
