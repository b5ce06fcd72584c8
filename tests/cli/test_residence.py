"""How long grains were in: known times, which grains count, and leavers.csv."""

import csv
import os
import statistics
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

# Without gravity: grains fly 2 m/s from a region whose middle is 0.3 m from the open side.
CASE = """\
materials: {{ore: {{density: 2500 kg/m3}}, steel: {{density: 7800 kg/m3}}}}
contacts: {{default: {{law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}}}
gravity: [0 m/s2, 0 m/s2, 0 m/s2]
time: {{step: 1e-4 s, design_stress: 100 Pa}}
domain: {{min: [-0.1 m, -0.1 m, -0.3 m], max: [0.1 m, 0.1 m, 0.1 m], open: delete}}
grains:
{groups}
{outlets}
stages: [{{name: run, duration: {duration} s}}]
output: {{series_interval: 20 ms{output}}}
"""
OUTLETS = """\
outlets: {side: {region: {box: {min: [0.07 m, -0.1 m, -0.3 m], max: [0.1 m, 0.1 m, -0.2 m]}}}}
"""
INLET = """\
  - material: {material}
    radius: {{distribution: uniform, min: 3 mm, max: 3.0001 mm}}
    inlet: {{{inlet}}}{amount}
    region: {{box: {{min: [-90 mm, -90 mm, -{half} mm], max: [90 mm, 90 mm, {half} mm]}}}}
    velocity: [0 m/s, 0 m/s, -{speed} m/s]
"""
THERE = """\
  - material: ore
    radius: {distribution: uniform, min: 3 mm, max: 3.0001 mm}
    count: 5
    region: {box: {min: [-90 mm, -90 mm, 40 mm], max: [90 mm, 90 mm, 60 mm]}}
    velocity: [0 m/s, 0 m/s, -4 m/s]
"""


def inlet(flow, amount="", material="ore", half=23, speed=2):
    return INLET.format(inlet=flow, amount=amount, material=material, half=half, speed=speed)


class Residence(clod.Case):

    def write(self, *groups, duration=0.6, output="", outlets=""):
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(groups="".join(groups), duration=duration, output=output,
                                   outlets=outlets))

    def leavers(self, folder):
        with open(self.path(folder + "/leavers.csv"), newline="") as file:
            return list(csv.DictReader(file))

    def test_one_grain(self):
        """All of its percentiles are its time: (0.3 m +- 20 mm)/2 m/s, and what it is noticed
        late."""
        self.write(inlet("number_flow: 100 1/s", "\n    count: 1"),
                   output=", steady_since: 0 s, leavers: true")
        done = self.go("out")
        r = self.summary("out")["residence"]
        self.assertEqual(r["grains"], 1)
        for key in ("least_s", "p10_s", "p50_s", "p90_s", "most_s"):
            self.assertEqual(r[key], r["mean_s"])
        self.assertEqual(r["deviation_s"], 0.0)
        self.assertGreater(r["mean_s"], 0.14)
        self.assertLess(r["mean_s"], 0.161)
        self.assertIn("1 grain that came in left from 0 s on, after ", done.stdout)
        row, = self.leavers("out")
        self.assertEqual(float(row["left [s]"]) - float(row["born [s]"]), r["mean_s"])
        self.assertEqual((row["id [1]"], row["material"], row["way"]), ("1", "ore", "left_z_min"))

    def test_a_narrow_distribution(self):
        """Uniform times between 0.14 and 0.16 s: 10, 50, 90 % at 0.142, 0.15, 0.158 s."""
        self.write(inlet("number_flow: 1000 1/s"), duration=1.0, output=", leavers: true")
        self.go("out")
        r = self.summary("out")["residence"]
        # the last third of a second; a standard error of 20 ms/sqrt(12 330), looks 1 ms apart
        self.assertLess(abs(r["grains"] - 333), 10)
        self.assertLess(abs(r["mean_s"] - 0.1505), 1.5e-3)
        self.assertLess(abs(r["deviation_s"] - 0.02 / 12**0.5), 5e-4)
        for key, time in (("p10_s", 0.1425), ("p50_s", 0.1505), ("p90_s", 0.1585)):
            self.assertLess(abs(r[key] - time), 2.5e-3)
        # against the table: the grains are those that left from then on, percentiles to 1 %
        times = sorted(float(row["left [s]"]) - float(row["born [s]"])
                       for row in self.leavers("out")
                       if float(row["left [s]"]) >= r["since_s"])
        self.assertEqual(len(times), r["grains"])
        self.assertAlmostEqual(statistics.fmean(times), r["mean_s"], delta=1e-12)
        for key, share in (("p10_s", 0.1), ("p50_s", 0.5), ("p90_s", 0.9)):
            exact = times[int(share * len(times))]
            self.assertLess(abs(r[key] / exact - 1.0), 0.01)
        self.assertEqual(sum(c["grains"] for c in r["classes"]), r["grains"])
        for c in r["classes"]:
            self.assertLess(c["to_s"] / c["from_s"], 1.01)
        # residence.csv: the share up to a time, counted from the table
        with open(self.path("out/residence.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(sum(int(row["grains [1]"]) for row in rows), len(times))
        for row in rows:
            inside = sum(time < float(row["to [s]"]) for time in times)
            self.assertAlmostEqual(float(row["share_up_to [1]"]), inside / len(times), delta=1e-12)
        self.assertEqual(float(rows[-1]["share_up_to [1]"]), 1.0)

    def test_which_grains_count(self):
        """Not those that were there at the start, nor those that left before the steady time."""
        self.write(THERE, inlet("number_flow: 200 1/s", speed=2), output=", steady_since: 0.4 s")
        self.go("out")
        summary = self.summary("out")
        # those of the start are faster; 200/s from 0.4 s to 0.6 s
        self.assertLess(abs(summary["residence"]["grains"] - 40), 3)
        self.assertEqual(summary["residence"]["since_s"], 0.4)
        self.assertGreater(summary["residence"]["least_s"], 0.139)
        self.assertGreater(summary["left"]["z_min"]["grains"], 80)
        self.assertFalse(os.path.exists(self.path("out/leavers.csv")))
        self.write(THERE)
        self.go("none")
        self.assertNotIn("residence", self.summary("none"))
        self.assertFalse(os.path.exists(self.path("none/residence.csv")))

    def test_the_table_has_all_that_left(self):
        self.write(THERE, inlet("number_flow: 400 1/s"),
                   inlet("mass_flow: 0.5 kg/s", material="steel"), output=", leavers: true",
                   outlets=OUTLETS)
        self.go("one")
        rows = self.leavers("one")
        summary = self.summary("one")
        mass = {"ore": 2500.0, "steel": 7800.0}
        for way, told in (("left_z_min", summary["left"]["z_min"]),
                          ("outlet_side", summary["outlets"]["side"])):
            some = [row for row in rows if row["way"] == way]
            self.assertGreater(len(some), 10)
            self.assertEqual(len(some), told["grains"])
            self.assertAlmostEqual(sum(float(row["mass [kg]"]) for row in some),
                                   told["mass_kg"], delta=1e-12)
        self.assertEqual(sum(row["born [s]"] == "0" for row in rows), 5)
        for row in rows:
            ball = mass[row["material"]] * 4 / 3 * 3.141592653589793 * float(row["radius [m]"])**3
            self.assertAlmostEqual(float(row["mass [kg]"]) / ball, 1.0, delta=1e-14)
        times = [(float(row["left [s]"]), int(row["id [1]"])) for row in rows]
        self.assertEqual(times, sorted(times))
        self.assertEqual(len({id for _, id in times}), len(rows))

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(THERE, inlet("number_flow: 400 1/s"), output=", leavers: true")
        self.go("one")
        self.go("two", "2")
        self.stop_after(20, "cut", "leavers.csv")
        self.go("cut")
        whole = clod.read(self.path("one/leavers.csv"))
        self.assertGreater(len(whole), 5000)
        self.assertLess(len(whole) / whole.count(b"\n"), 110)  # the size that the key states
        self.assertEqual(whole, clod.read(self.path("two/leavers.csv")))
        self.assertEqual(whole, clod.read(self.path("cut/leavers.csv")))
        # with --fresh it is taken away
        self.write(THERE)
        done = clod.run("run", "case.yaml", "-o", "cut", "--fresh", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse(os.path.exists(self.path("cut/leavers.csv")))


if __name__ == "__main__":
    clod.main()
