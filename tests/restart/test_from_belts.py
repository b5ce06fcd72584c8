"""clod run --from and a belt that starts up: it counts from the beginning of the new run, as inlets do."""

import os
import shutil
import signal
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

# A grain that hardly rolls, on a belt that it does not slip on.
CASE = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 2e4 N/m, restitution: 0.2, friction: 1, rolling: epsd2, rolling_friction: 1}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
domain: {min: [-1 m, -1 m, -1 m], max: [2 m, 1 m, 1 m]}
grains: [{material: ore, file: grain.csv}]
walls:
  feed:
    material: ore
    start_up: {START}
    shapes: [{belt: {from: [0 m, 0 m, 0 m], runs: [{length: 1 m}], width: 400 mm, speed: 1 m/s}}]
stages: [{name: run, duration: 0.3 s}]
time: {step: 1e-5 s, design_stress: 1 kPa}
output: {series_interval: 20 ms, energy: true, steady_since: 0 s}
"""
MASS = 2500 * 4 / 3 * 3.141592653589793 * 0.005 ** 3


class FromBelts(clod.Case):

    def write(self, start_up):
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.replace("START", start_up))
        with open(self.path("grain.csv"), "w") as file:
            file.write("x [m],y [m],z [m],radius [mm]\n0.2,0,0.0049994,5\n")

    def test_it_starts_after_the_beginning_of_this_run(self):
        """Standing for 0.3 s; then, by a second case, it stands 0.05 s and rises to 1 m/s in 0.2 s more: the grain has
        v(t), so its energy is m v^2/2, and the belt's way to 0.3 s is 0.1 + 0.05 m."""
        self.write("at: 10 s, duration: 1 s")
        self.go("first")
        self.write("at: 0.05 s, duration: 0.2 s")
        told = self.go("second", "1", "--from", "first").stderr
        self.assertIn("wall feed: belts start at 0.35 s", told)
        rows = clod.table(self.path("second/series.csv"))
        self.assertAlmostEqual(rows[-1]["time"], 0.6, 9)
        for row in rows:
            speed = min(max(row["time"] - 0.35, 0.0) / 0.2, 1.0)
            self.assertLess(abs((2 * row["kinetic_energy"] / MASS) ** 0.5 - speed), 0.01, row)  # it swings on its spring
        way = sum(row["feed.belt_speed"] * 0.02 for row in rows if row["time"] > 0.3 + 1e-9)
        self.assertAlmostEqual(way, 0.15, 3)
        # stopped while it starts up it goes on with the same bytes, with --from or without
        for more in (["--from", "first"], []):
            process = clod.start("run", self.path("case.yaml"), "-o", self.path("cut"), "-t", "1",
                                 "--from", self.path("first"))
            table = self.path("cut/series.csv")
            self.assertTrue(clod.wait_until(lambda: os.path.exists(table) and len(clod.read(table).splitlines()) > 8,
                                            process))
            process.send_signal(signal.SIGTERM)
            process.communicate()
            self.assertEqual(process.returncode, 128 + signal.SIGTERM)
            self.go("cut", "1", *more)
            self.assert_same_end(self.path("second"), self.path("cut"), ["run"])
            shutil.rmtree(self.path("cut"))


if __name__ == "__main__":
    clod.main()
