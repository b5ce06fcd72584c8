"""output.surfaces: how grains hit surfaces: classes of angle and energy, means, seams, same bytes."""

import csv
import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

# A level plate of two parts, each of four facets, and a sheet of another file behind a crack of
# 0.02 mm, 1/250 of the grain's radius; a box goes on from there, of another wall.
PLATE = """\
o near
v 0 -100 0
v 50 -100 0
v 100 -100 0
v 0 100 0
v 50 100 0
v 100 100 0
f 1 2 5
f 1 5 4
f 2 3 6
f 2 6 5
o far
v 150 -100 0
v 200 -100 0
v 150 100 0
v 200 100 0
f 3 7 9
f 3 9 6
f 7 8 10
f 7 10 9
"""
SHEET = "v 200.02 -100 0\nv 250 -100 0\nv 250 100 0\nv 200.02 100 0\nf 1 2 3\nf 1 3 4\n"
CASE = """\
materials: {{ore: {{density: 2500 kg/m3}}}}
contacts: {{default: {{law: hooke, k1: 1e5 N/m, restitution: {restitution}, friction: 0.5}}}}
gravity: [0 m/s2, 0 m/s2, -{gravity} m/s2]
time: {{step: 1e-5 s, design_stress: 100 Pa}}
domain: {{min: [-0.5 m, -0.2 m, -0.1 m], max: [0.5 m, 0.2 m, 0.2 m]}}
grains: [{{material: ore, file: grains.csv}}]
walls:
  plate:
    material: ore
    shapes: [{{mesh: {{file: plate.obj, unit: 1 mm}}}}, {{mesh: {{file: sheet.obj, unit: 1 mm}}}}]
  box: {{material: ore, shapes: [{{box: {{center: [0.3 m, 0 m, -0.01 m], size: [0.1 m, 0.2 m, 20 mm]}}}}]}}
stages: [{{name: run, duration: {duration} s}}]
output: {{series_interval: 2 ms, surfaces: true, steady_since: {since} s}}
"""
# A floor, and a ramp that goes up from its end at x = 0: of one file, or of another wall.
FLOOR = "o floor\nv -100 -50 0\nv 0 -50 0\nv 0 50 0\nv -100 50 0\nf 1 2 3\nf 1 3 4\n"
RAMP = "o ramp\nv 0 -50 0\nv {x} -50 {z}\nv {x} 50 {z}\nv 0 50 0\nf {a} {b} {c}\nf {a} {c} {d}\n"
BENT = """\
materials: {{ore: {{density: 2500 kg/m3}}}}
contacts: {{default: {{law: hooke, k1: 1e5 N/m, restitution: 0.5, friction: 0}}}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {{step: 1e-6 s, design_stress: 100 Pa}}
domain: {{min: [-0.5 m, -0.2 m, -0.1 m], max: [0.5 m, 0.2 m, 0.2 m]}}
grains: [{{material: ore, file: grains.csv}}]
walls: {{floor: {{material: ore, shapes: [{{mesh: {{file: floor.obj, unit: 1 mm}}}}]}}{others}}}
stages: [{{name: run, duration: {duration} s}}]
output: {{series_interval: 1 ms, surfaces: true}}
"""
RADIUS = 5e-3
MASS = 2500 * 4 / 3 * math.pi * RADIUS ** 3
HEADER = ["surface", "angle_from [deg]", "angle_to [deg]", "normal_energy_from [J]",
          "normal_energy_to [J]", "impacts [1]", "energy [J]", "normal_energy [J]"]


class Impacts(clod.Case):

    def write(self, grains, duration, gravity=0.0, restitution=1.0, since=0.0):
        """Grains: x, y, z, vx, vy, vz."""
        for name, text in (("plate.obj", PLATE), ("sheet.obj", SHEET)):
            with open(self.path(name), "w") as file:
                file.write(text)
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(duration=duration, gravity=gravity, restitution=restitution,
                                   since=since))
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [m],y [m],z [m],radius [m],vx [m/s],vy [m/s],vz [m/s]\n")
            for grain in grains:
                x, y, z, *velocity = grain
                file.write(",".join(map(repr, (x, y, z, RADIUS, *velocity))) + "\n")

    def impacts(self, folder):
        return {face["name"]: face["impacts"] for face in self.summary(folder)["surfaces"]}

    def table(self, folder):
        with open(self.path(folder + "/impacts.csv"), newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], HEADER)
        return [(row[0], *map(float, row[1:])) for row in rows[1:]]

    def thrown(self):
        """Ten grains at 35 degrees and 2 m/s, six at 75 degrees and 3 m/s onto `near`; one onto `far`."""
        grains = []
        for k in range(10):
            grains.append((0.01, -0.07 + 0.015 * k, RADIUS + 1e-4, *self.velocity(35, 2.0)))
        for k in range(6):
            grains.append((0.06, -0.07 + 0.015 * k, RADIUS + 1e-4, *self.velocity(75, 3.0)))
        grains.append((0.12, 0.0, RADIUS + 1e-4, *self.velocity(5, 1.0)))
        return grains

    def velocity(self, angle, speed):
        angle = math.radians(angle)
        return speed * math.cos(angle), 0.0, -speed * math.sin(angle)

    def test_thrown_grains(self):
        self.write(self.thrown(), 4e-3)
        done = self.go("out")
        faces = self.impacts("out")
        low, high = 0.5 * MASS * 2.0 ** 2, 0.5 * MASS * 3.0 ** 2
        low_into = low * math.sin(math.radians(35)) ** 2
        high_into = high * math.sin(math.radians(75)) ** 2
        self.assertEqual([round(1e3 * e, 2) for e in (low_into, high_into)], [0.86, 5.5])
        near, far = faces["plate.near"], faces["plate.far"]
        self.assertEqual((near["number"], far["number"], faces["box"]["number"]), (16, 1, 0))
        into = 10 * low_into + 6 * high_into
        self.assertAlmostEqual(near["energy_J"] / (10 * low + 6 * high), 1.0, 9)
        self.assertAlmostEqual(near["normal_energy_J"] / into, 1.0, 9)
        # the mean of ten and six, and the root of 60/256 of their difference
        for key, few, many in (("angle_deg", 75.0, 35.0), ("speed_m_per_s", 3.0, 2.0),
                               ("each_normal_energy_J", high_into, low_into)):
            self.assertAlmostEqual(near[key]["mean"] / ((6 * few + 10 * many) / 16), 1.0, 9)
            self.assertAlmostEqual(near[key]["deviation"] / (math.sqrt(60) / 16 * (few - many)),
                                   1.0, 7)
        self.assertEqual([c["number"] for c in near["by_angle"]], [0, 0, 0, 10, 0, 0, 0, 6, 0])
        self.assertEqual([c["number"] for c in far["by_angle"]], [1] + 8 * [0])
        self.assertEqual([(c["from_J"], c["to_J"], c["number"]) for c in near["by_normal_energy"]],
                         [(5e-4, 1e-3, 10), (5e-3, 1e-2, 6)])
        self.assertNotIn("angle_deg", faces["box"])
        rows = {(name, angle): rest for name, angle, *rest in self.table("out")}
        self.assertEqual(set(rows), {("plate.near", 30.0), ("plate.near", 70.0), ("plate.far", 0.0)})
        for angle, energy, normal, count in ((30.0, low, low_into, 10), (70.0, high, high_into, 6)):
            row = rows["plate.near", angle]
            self.assertEqual(row[0], angle + 10.0)
            self.assertTrue(row[1] <= normal < row[2])
            self.assertEqual(row[3], count)
            self.assertAlmostEqual(row[4] / (count * energy), 1.0, 9)
            self.assertAlmostEqual(row[5] / (count * normal), 1.0, 9)
        # the report: number, then means and deviations of angle, speed, normal energy
        table = done.stdout.split("  impacts     ")[-1]
        line, = [line.split() for line in table.splitlines() if line.startswith("  plate.near ")]
        self.assertEqual([float(word) for word in line[1:] if word != "+-"],
                         [16.0, 50.0, 19.4, 2.375, 0.484, float(f"{into / 16:.4g}"),
                          float(f"{math.sqrt(60) / 16 * (high_into - low_into):.3g}")])
        # the series: every impact is in one row
        series = self.rows("out")
        hit = [row for row in series if row["surface_plate.near.impacts"] > 0.0]
        self.assertEqual(len(hit), 1)
        self.assertAlmostEqual(hit[0]["surface_plate.near.impact_angle"], 50.0, 9)
        self.assertAlmostEqual(hit[0]["surface_plate.near.impact_speed"], 2.375, 9)
        self.assertTrue(all(math.isnan(row["surface_plate.near.impact_angle"])
                            for row in series if row is not hit[0]))

    def test_they_begin_with_the_steady_time(self):
        """Ten hit at once, six after 3 ms."""
        grains = self.thrown()
        for k in range(10, 16):
            x, y, z, *velocity = grains[k]
            grains[k] = (x, y, z + 3.0 * math.sin(math.radians(75)) * 3e-3, *velocity)
        self.write(grains, 5e-3, since=2e-3)
        self.go("out")
        near = self.impacts("out")["plate.near"]
        self.assertEqual(near["number"], 6)
        self.assertEqual([c["number"] for c in near["by_angle"]], 7 * [0] + [6, 0])
        self.assertAlmostEqual(near["speed_m_per_s"]["mean"], 3.0, 9)

    def test_rolling_over_seams(self):
        """Over facets, from part to part, over a crack to another file, onto a box of another wall:
        the ball comes down once."""
        self.write([(0.02, 0.013, RADIUS + 1e-9, 2.0, 0.0, 0.0)], 0.15, gravity=9.81,
                   restitution=0.05)
        self.go("out")
        faces = {face["name"]: face for face in self.summary("out")["surfaces"]}
        self.assertEqual(len(faces), 4)
        self.assertEqual(faces["plate.near"]["impacts"]["number"], 1)
        for name, face in faces.items():
            self.assertGreater(face["press_N"], 0.02 * MASS * 9.81, name)  # it was there
            if name != "plate.near":
                self.assertEqual(face["impacts"]["number"], 0, name)
                self.assertEqual(face["impacts_per_s"], 0.0, name)

    def hits_of_a_ramp(self, bend, one_file):
        """A ball slides over the floor at 1 m/s and meets the ramp; the run ends 0.15 ms later, while it is
        pressed into it (half of the contact's time is 0.18 ms)."""
        angle = math.radians(bend)
        first = 5 if one_file else 1
        ramp = RAMP.format(x=100 * math.cos(angle), z=100 * math.sin(angle), a=first, b=first + 1,
                           c=first + 2, d=first + 3)
        files = {"floor.obj": FLOOR + ramp} if one_file else {"floor.obj": FLOOR, "ramp.obj": ramp}
        others = "" if one_file else (", ramp: {material: ore, "
                                      "shapes: [{mesh: {file: ramp.obj, unit: 1 mm}}]}")
        meeting = RADIUS * math.tan(angle / 2)  # so far before the bend the ball touches both
        files["case.yaml"] = BENT.format(others=others, duration=10e-3 - meeting + 0.15e-3)
        height = RADIUS - MASS * 9.81 / 1e5  # rests on the floor
        files["grains.csv"] = ("x [m],y [m],z [m],radius [m],vx [m/s],vy [m/s],vz [m/s]\n"
                               f"-0.01,0.013,{height!r},{RADIUS!r},1,0,0\n")
        for name, text in files.items():
            with open(self.path(name), "w") as file:
                file.write(text)
        done = clod.run("run", "case.yaml", "-o", "out", "--fresh", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        ramp, = [face for face in self.summary("out")["surfaces"] if face["name"].endswith("ramp")]
        self.assertGreater(ramp["press_N"], 0.01)  # it was there: the ball weighs 0.013 N
        return ramp["impacts"]["number"]

    def test_a_bend_of_20_degrees_is_where_impacts_begin(self):
        for one_file in (True, False):
            self.assertEqual([self.hits_of_a_ramp(bend, one_file) for bend in (5, 18, 22, 60)],
                             [0, 0, 1, 1], one_file)

    @clod.quick_only
    def test_same_bytes_on_two_threads_and_after_a_stop(self):
        """Grains that bounce on all surfaces; what was counted before the stop is still there."""
        grains = [(0.01 + 0.017 * (k % 17), -0.07 + 0.02 * (k // 17), RADIUS + 1e-4 + 1e-5 * k,
                   *self.velocity(20 + k / 2, 0.3 + 0.002 * k)) for k in range(17 * 7)]
        self.write(grains, 0.08, gravity=9.81, restitution=0.7, since=1e-3)
        self.go("one")
        self.go("two", threads="2")
        self.stop_after(12, "cut")
        self.go("cut", threads="2")
        self.assertGreater(self.impacts("one")["plate.near"]["number"], 100)
        for other in ("two", "cut"):
            for name in ("impacts.csv", "series.csv"):
                self.assertEqual(clod.read(self.path(f"one/{name}")),
                                 clod.read(self.path(f"{other}/{name}")), f"{other}/{name}")
            self.assertEqual(self.summary("one")["surfaces"], self.summary(other)["surfaces"])
        # with --fresh it is taken away
        done = clod.run("run", "case.yaml", "-o", "cut", "--fresh", "--set", "output.surfaces=false",
                        "--set", "stages.0.duration=2 ms", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse(os.path.exists(self.path("cut/impacts.csv")))


if __name__ == "__main__":
    clod.main()
