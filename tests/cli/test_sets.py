"""The same bytes on every instruction set: a rain of grains through an inlet onto a mesh in two
files with named parts and a belt, a conveyor, with what surfaces feel, out through an outlet."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

UPPER = """\
o hood
v -.05 -100 0
v -0.05 100 0
v 60 100 -30
v 60 -100 -30
f 1 2 3
f 1 3 4
o liner
v 100 100 -60
v 100 -100 -60
f 4 3 5
f 4 5 6
"""
LOWER = "v 100.02 -100 -60\nv 100.02 100 -60\nv 150 100 -80\nv 150 -100 -80\nf 1 2 3\nf 1 3 4\n"
CASE = """\
materials: {ore: {density: 2500 kg/m3}, steel: {hardness: 2 GPa, archard: 1e-3, finnie: 1e-4}}
contacts:
  default: {law: mepa, exponent: 1.5, k1: 4.75e5 N/m^1.5, k2: 2.37e6 N/m^1.5, k_adh: 5e4 N/m^1.5,
            restitution: 0.3, friction: 0.2, rolling: epsd2, rolling_friction: 0.02}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {step: 4e-5 s, design_stress: 1 kPa}
domain: {min: [-0.2 m, -0.2 m, -0.4 m], max: [0.6 m, 0.2 m, 0.2 m], open: delete}
grains:
  - material: ore
    radius: {distribution: uniform, min: 4 mm, max: 5 mm}
    inlet: {number_flow: 400 1/s}
    region: {box: {min: [0 mm, -80 mm, 30 mm], max: [80 mm, 80 mm, 60 mm]}}
walls:
  chute:
    material: steel
    oscillation: {direction: [0, 0, 1], amplitude: 0.1 mm, frequency: 50 Hz}
    shapes:
      - mesh: {file: upper.obj, unit: 1 mm, parts: {liner: {material: ore, speed: 0.2 m/s, direction: [0, 1, 0]}}}
      - mesh: {file: lower.obj, unit: 1 mm}
  belt:
    material: ore
    start_up: {at: 0.05 s, duration: 0.1 s}
    shapes:
      - belt: {from: [0.05 m, 0 m, -0.16 m], runs: [{length: 0.3 m}], width: 200 mm, idler_angle: 20 deg,
               transition: 0.1 m, speed: 1 m/s, pulley: {radius: 40 mm}}
outlets: {bin: {region: {box: {min: [0.36 m, -0.2 m, -0.4 m], max: [0.6 m, 0.2 m, 0.2 m]}}}}
stages: [{name: run, duration: DURATION}]
output: {series_interval: 10 ms, snapshot_interval: 0.35 s, surfaces: true, contacts: true, energy: true}
"""


# Long enough for grains to go out.
DURATION, LEAST_OUT = ("0.55 s", 1) if clod.SANITIZED else ("0.7 s", 6)


class Sets(clod.Case):

    def run_on(self, simd, threads):
        out = self.path(f"{simd}-{threads}")
        done = clod.run("run", "case.yaml", "-o", out, "--simd", simd, "--threads", threads,
                        cwd=self.folder)
        if done.returncode == 2 and "not in this machine" in done.stderr:
            return None
        self.assertEqual(done.returncode, 0, done.stderr)
        return out

    def test_sets_agree(self):
        for name, text in (("upper.obj", UPPER), ("lower.obj", LOWER), ("case.yaml", CASE)):
            with open(self.path(name), "w") as file:
                file.write(text.replace("DURATION", DURATION))
        first = self.run_on("scalar", "1")
        rows = clod.table(os.path.join(first, "series.csv"))
        for wall in ("chute", "belt"):
            self.assertLess(min(row[f"{wall}.force_z"] for row in rows), -0.1)
        self.assertGreaterEqual(rows[-1]["outlet_bin.grains"], LEAST_OUT, list(rows[-1]))
        compared = 0
        for simd, threads in (("avx512", "2"), ("avx2", "1"), ("neon", "2")):
            other = self.run_on(simd, threads) if compared == 0 or not clod.SANITIZED else None
            if other is not None:
                self.assert_same_end(first, other, ["run"])
                compared += 1
        if compared == 0:
            self.skipTest("this machine has no set of vectors to compare with")


if __name__ == "__main__":
    clod.main()
