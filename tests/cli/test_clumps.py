"""clumps, build_up, history_map: what a free run tells of the graph of its contacts."""

import csv
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

DENSITY = 2500.0
RADIUS = 5e-3
MASS = DENSITY * 4 / 3 * math.pi * RADIUS**3
K_ADH = 2e6
# Grains that lie where they were put: pressed together by 10 um in rows of two, three and one.
# k_adh is beyond sticking, so those that were pressed hang together; without it none do.
ROWS = """\
materials: {{ore: {{density: 2500 kg/m3}}}}
contacts:
  default: {{law: mepa, exponent: 1, k1: 1e5 N/m, k2: 5e5 N/m, k_adh: {k_adh} N/m,
            restitution: 0.1, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, {gravity} m/s2]
time: {{step: 1e-6 s}}
domain: {{min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.1 m], open: delete}}
grains: [{{file: grains.csv, material: ore}}]
stages: [{{name: run, duration: {duration}}}]
clumps:{clumps}
history_map: {{cell: 20 mm}}
output: {{series_interval: 1 ms, snapshot_interval: 5 ms}}
"""
PRESSED = 10e-6
# Cohesive grains rain onto a floor and grow a heap there; some fall beside it and out.
RAIN = """\
materials: {{ore: {{density: 2500 kg/m3}}}}
contacts:
  default: {{law: mepa, exponent: 1.5, k1: 1e6 N/m^1.5, k2: 5e6 N/m^1.5,
            k_adh: {k_adh} N/m^1.5, restitution: 0.3, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {{step: 1e-5 s, design_stress: 1 kPa}}
domain: {{min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.15 m], open: delete}}
grains:
  - material: ore
    radius: {{distribution: uniform, min: 4.5 mm, max: 5.5 mm}}
    inlet: {{number_flow: 2000 1/s, end: 0.25 s}}
    region: {{box: {{min: [-50 mm, -50 mm, 80 mm], max: [50 mm, 50 mm, 110 mm]}}}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
walls:
  floor: {{material: ore, shapes: [{{box: {{center: [0 m, 0 m, 0 m], size: [60 mm, 60 mm, 10 mm]}}}}]}}
  side: {{material: ore, shapes: [{{box: {{center: [-35 mm, 0 m, 0 m], size: [8 mm, 60 mm, 30 mm]}}}}]}}
outlets:
  below: {{region: {{box: {{min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, -60 mm]}}}}}}
stages: [{{name: run, duration: 0.4 s}}]
clumps: {{counts: {{flight: {{free: true}}, low: {{region: {{box: {{min: [-0.1 m, -0.1 m, -0.1 m],
          max: [0.1 m, 0.1 m, 75 mm]}}}}}}}}}}
build_up: {{}}
history_map: {{cell: 10 mm}}
output: {{series_interval: 10 ms, snapshot_interval: 0.1 s, contacts: true}}
"""


class Clumps(clod.Case):

    def write_rows(self, k_adh=K_ADH, clumps=" {}", gravity=0.0, duration="5 ms", rows=(2, 3, 1)):
        with open(self.path("case.yaml"), "w") as file:
            file.write(ROWS.format(k_adh=k_adh, clumps=clumps, gravity=gravity,
                                   duration=duration))
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [m],y [m],z [m],radius [m]\n")
            for row, length in enumerate(rows):
                for k in range(length):
                    file.write(f"{k * (2 * RADIUS - PRESSED)},{0.02 * row},0,{RADIUS}\n")

    def write_rain(self, k_adh):
        with open(self.path("case.yaml"), "w") as file:
            file.write(RAIN.format(k_adh=k_adh))

    def go(self, folder, *options):
        done = clod.run("run", "case.yaml", "-o", folder, *options, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def sizes(self, folder):
        with open(self.path(folder + "/clumps.csv")) as file:
            return list(csv.DictReader(file))

    def test_rows_that_were_pressed_are_clumps(self):
        """A pair and a triple in every row of the series; 5 of 6 grains; sizes by hand."""
        self.write_rows()
        done = self.go("out")
        rows = self.rows("out")
        self.assertEqual(len(rows), 5)
        for row in rows:
            self.assertEqual(row["clumps.number"], 2)
            self.assertEqual(row["clumps.grains"], 5)
            self.assertAlmostEqual(row["clumps.mass"], 5 * MASS, delta=1e-12 * MASS)
            self.assertAlmostEqual(row["clumps.mass_share"], 5 / 6, delta=1e-12)
            self.assertAlmostEqual(row["clumps.mean_size"], 2.5, delta=1e-12)
            self.assertAlmostEqual(row["clumps.mass_mean_size"], 13 / 5, delta=1e-12)
            self.assertEqual(row["clumps.largest"], 3)
            self.assertAlmostEqual(row["clumps.d10"], 2 * RADIUS * 2**(1 / 3), delta=1e-12)
            self.assertAlmostEqual(row["clumps.d50"], 2 * RADIUS * 3**(1 / 3), delta=1e-12)
        clumps = self.summary("out")["clumps"]
        self.assertAlmostEqual(clumps["mean"]["number"], 2, delta=1e-12)
        self.assertEqual([s["number"] for s in clumps["sizes"]], [1, 1])
        self.assertEqual(clumps["time_in_clumps"], {"grains": 0})
        sizes = self.sizes("out")
        self.assertEqual([(s["count"], s["from [1]"], s["to [1]"]) for s in sizes],
                         [("all", "2", "2"), ("all", "3", "3")])
        self.assertAlmostEqual(float(sizes[1]["mass [kg]"]), 3 * MASS, delta=1e-12 * MASS)
        self.assertAlmostEqual(float(sizes[1]["share [1]"]), 0.6, delta=1e-12)
        self.assertIn("mean 2 clumps of 2.5 grains", done.stdout)

    def test_the_map_knows_what_they_were_pressed_with(self):
        """k1 10 um at the first step; they hang on, so the pull follows from P, by hand."""
        self.write_rows()
        self.go("out")
        strongest = self.summary("out")["history_map"]["strongest"]
        # the middle of a triple is pressed from both sides: all three contacts alike
        self.assertAlmostEqual(strongest["largest_past_force_N"], 1e5 * PRESSED, delta=1e-3)
        pull = K_ADH * 0.8 * PRESSED / (1 + K_ADH / 5e5)
        self.assertAlmostEqual(strongest["largest_pull_off_N"], pull, delta=1e-3 * pull)

    def test_the_map_knows_where_strength_is_gained(self):
        """Two grains meet at 20 mm/s on a soft contact, restitution 1: the overlap is 2 v/w sin(w t), the past force
        gains k1 2 v cos(w t) until w t = pi/2 and nothing later, in one cell, which begins at (0, 0, 0)."""
        k1, speed, rows = 10.0, 0.02, 20
        w = math.sqrt(k1 / (0.5 * MASS))
        self.write_rows()
        with open(self.path("case.yaml")) as file:
            text = file.read()
        text = text.replace("k1: 1e5 N/m, k2: 5e5 N/m", f"k1: {k1} N/m, k2: {5 * k1} N/m").replace("restitution: 0.1", "restitution: 1")
        text = text.replace(f"k_adh: {K_ADH} N/m", f"k_adh: {k1} N/m").replace("duration: 5 ms", f"duration: {rows} ms")
        with open(self.path("case.yaml"), "w") as file:
            file.write(text.replace("snapshot_interval: 5 ms", "snapshot_interval: 5 ms, steady_since: 0 s"))
        with open(self.path("grains.csv"), "w") as file:
            file.write(f"x [m],y [m],z [m],radius [m],vx [m/s]\n0.002,0.01,0.01,{RADIUS},{speed}\n"
                       f"{0.002 + 2 * RADIUS},0.01,0.01,{RADIUS},{-speed}\n")
        done = self.go("out")
        most = self.summary("out")["history_map"]["gains_most"]
        told = [k1 * 2 * speed * math.cos(w * 1e-3 * row) for row in range(1, rows + 1) if w * 1e-3 * row < math.pi / 2]
        self.assertEqual(len(told), 12)
        gained = sum(told) / self.summary("out")["history_map"]["samples"]
        self.assertAlmostEqual(most["past_force_N_per_s"], gained, delta=2e-3 * gained)
        pull = 0.8 / 1.2 # k_adh (1 - k1/k2)/(1 + k_adh/k2) over k1
        self.assertAlmostEqual(most["pull_off_N_per_s"], pull * gained, delta=2e-3 * gained)
        self.assertEqual([round(corner, 9) for corner in most["corner_m"]], [0, 0, 0])
        self.assertIn("; gains most, 0.1", done.stdout)

    def test_dry_grains_are_none(self):
        self.write_rows(k_adh=0)
        done = self.go("out")
        for row in self.rows("out"):
            self.assertEqual(row["clumps.number"], 0)
            self.assertEqual(row["clumps.mass_share"], 0)
        self.assertEqual(self.sizes("out"), [])
        self.assertIn("mean 0 clumps", done.stdout)

    def test_the_bond_number_counts(self):
        """Pull by hand over the weight at 10 m/s2: 1.6e0 N/5 over 1.3e-2 N."""
        pull = K_ADH * 0.8 * PRESSED / (1 + K_ADH / 5e5)
        number = pull / (MASS * 10)
        for factor, clumps in ((0.9, 2), (1.1, 0)):
            self.write_rows(clumps=f" {{bond: {factor * number}}}", gravity=-10)
            self.go("out", "--fresh")
            self.assertEqual(self.rows("out")[-1]["clumps.number"], clumps, factor)
        self.write_rows(clumps=" {least: 3}")
        self.go("out", "--fresh")
        self.assertEqual(self.rows("out")[-1]["clumps.number"], 1)

    def test_grains_that_leave_tell_their_clumps(self):
        """All fall out of the domain: two of a pair, three of a triple, one alone."""
        self.write_rows(gravity=-10, duration="0.16 s")
        self.go("out")
        left = self.summary("out")["clumps"]["left"]
        self.assertEqual(left["alone"], 1)
        self.assertEqual(left["in_clumps"], 5)
        self.assertEqual([(s["from"], s["grains"]) for s in left["sizes"]], [(2, 2), (3, 3)])

    def test_grains_that_come_off_tell_how_long(self):
        """Adhesion ends after the first stage: all five grains leave their clumps."""
        self.write_rows()
        with open(self.path("case.yaml")) as file:
            text = file.read()
        text = text.replace("[{name: run, duration: 5 ms}]",
                            "[{name: wet, duration: 20 ms}, "
                            "{name: dry, duration: 5 ms, adhesion: 0}]")
        with open(self.path("case.yaml"), "w") as file:
            file.write(text)
        done = self.go("out")
        at = {round(row["time"], 6): row for row in self.rows("out")}
        self.assertEqual(at[0.02]["clumps.grains"], 5)
        self.assertEqual(at[0.021]["clumps.grains"], 0)
        times = self.summary("out")["clumps"]["time_in_clumps"]
        # seen in one from the look at 1 ms to that at 20 ms, and in none at 21 ms
        self.assertEqual(times["grains"], 5)
        self.assertAlmostEqual(times["mean_s"], 0.02, delta=1e-12)
        self.assertLess(abs(math.log10(times["p50_s"] / 0.02)), 0.1)
        self.assertIn("time in clumps", done.stdout)

    def test_all_means_begin_where_the_steady_time_does(self):
        """Two clumps for 20 ms, none for 5 ms: the last third has them for 10/3 of 25/3 ms, from
        15 ms on for half of the time, from 20.5 ms on for none. Lives end at 21 ms."""
        self.write_rows()
        with open(self.path("case.yaml")) as file:
            text = file.read()
        text = text.replace("[{name: run, duration: 5 ms}]",
                            "[{name: wet, duration: 20 ms}, "
                            "{name: dry, duration: 5 ms, adhesion: 0}]")
        for key, since, number, lives, looks in (("", 50 / 3e3, 0.8, 5, 9),
                                                 (", steady_since: 15 ms", 0.015, 1, 5, 11),
                                                 (", steady_since: 20.5 ms", 0.0205, 0, 5, 5),
                                                 (", steady_since: 21.5 ms", 0.0215, 0, 0, 4)):
            with open(self.path("case.yaml"), "w") as file:
                file.write(text.replace("snapshot_interval: 5 ms", "snapshot_interval: 5 ms" + key))
            self.go("out", "--fresh")
            summary = self.summary("out")
            clumps = summary["clumps"]
            self.assertAlmostEqual(clumps["since_s"], since, delta=1e-12)
            self.assertAlmostEqual(clumps["mean"]["number"], number, delta=1e-9)
            self.assertEqual(clumps["time_in_clumps"]["grains"], lives)
            self.assertEqual(clumps["largest"], 3) # of all the run
            self.assertEqual(summary["history_map"]["samples"], looks)
            self.assertEqual(summary["history_map"]["since_s"], clumps["since_s"])

    @clod.quick_only
    def test_rain_wet_and_dry(self):
        """Wet grains that touch are clumps, dry ones are none; what rests is no more than is
        there, and most of what is on the floor at the end."""
        self.write_rain(k_adh=0)
        self.go("dry")
        self.write_rain(k_adh=2.5e6)
        done = self.go("wet")
        for row in self.rows("dry"):
            self.assertEqual(row["clumps.number"], 0)
        last = self.rows("wet")[-1]
        self.assertGreater(last["clumps.largest"], 20)
        self.assertGreater(last["clumps_low.grains"], 0.9 * last["clumps.grains"])
        self.assertLess(last["clumps_flight.grains"], 0.1 * last["clumps.grains"])
        kept = last["inlet_1.mass"] - last["outlet_below.mass"]
        resting = last["floor.resting_mass"] + last["side.resting_mass"]
        self.assertLessEqual(resting, kept * (1 + 1e-12))
        self.assertGreater(resting, 0.9 * kept)
        self.assertGreater(last["floor.resting_mass"], last["side.resting_mass"])
        build_up = self.summary("wet")["build_up"]["floor"]
        self.assertEqual(build_up["mass_kg"], last["floor.resting_mass"])
        masses = [row["floor.resting_mass"] for row in self.rows("wet")]
        self.assertEqual(build_up["largest_kg"], max(masses))
        # the last third of 0.4 s is that from row 27 on, a third of whose time is in it
        weight = [1 / 3] + 13 * [1]
        mean = sum(w * m for w, m in zip(weight, masses[26:])) / sum(weight)
        self.assertAlmostEqual(build_up["mean_kg"] / mean, 1, 9)
        self.assertIn("resting on floor", done.stdout)
        left = self.summary("wet")["clumps"]["left"]
        self.assertEqual(left["alone"] + left["in_clumps"], last["outlet_below.grains"])

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write_rain(k_adh=2.5e6)
        self.go("one", "-t", "1")
        self.go("two", "-t", "2")
        self.stop_after(15, "cut")
        self.go("cut", "-t", "2")
        self.assertGreater(len([e for e in clod.log(self.path("cut"))
                                if e["event"] == "resume"]), 0)
        names = ["series.csv", "clumps.csv", "history_map.hdf", "snap_000002.hdf",
                 "contacts_000003.hdf"]
        for name in names:
            whole = clod.read(self.path("one/" + name))
            self.assertEqual(whole, clod.read(self.path("two/" + name)), name)
            self.assertEqual(whole, clod.read(self.path("cut/" + name)), name)
        summaries = [self.summary(name) for name in ("one", "two", "cut")]
        for summary in summaries:
            del summary["wall_clock_s"]
        self.assertEqual(summaries[0], summaries[1])
        self.assertEqual(summaries[0], summaries[2])

    @clod.quick_only
    def test_measures_change_nothing(self):
        """Grains go the same ways with them and without."""
        self.write_rain(k_adh=2.5e6)
        self.go("with")
        with open(self.path("case.yaml")) as file:
            lines = file.read().splitlines()
        keep = [line for line in lines if not line.startswith(("clumps", "build_up", "history"))
                and "max: [0.1 m, 0.1 m, 75 mm]" not in line]
        with open(self.path("case.yaml"), "w") as file:
            file.write("\n".join(keep) + "\n")
        self.go("without")
        for a, b in zip(self.rows("with"), self.rows("without")):
            for key in b:
                self.assertEqual(a[key], b[key], key)
        self.assertNotIn("clumps", self.summary("without"))
        self.assertFalse(os.path.exists(self.path("without/clumps.csv")))

    def test_wrong_keys_are_explained(self):
        box = "{box: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, -1 m]}}"
        ring = "{annulus: {center: [0 m, 0 m, 0 m], outer_radius: 1 m, height: 1 m}}"
        for key, words in (
                ("clumps={bond: -1}", "clumps.bond"),
                ("clumps={least: 1}", "clumps.least"),
                ("clumps={counts: {some: {}}}", "give it a region, free: true or both"),
                ("clumps={counts: {all: {free: true}}}", "take another name"),
                (f"clumps={{counts: {{some: {{region: {box}}}}}}}", "must be larger than min"),
                ("clumps={counts: {" + ", ".join(f"c{k}: {{free: true}}" for k in range(9)) +
                 "}}", "has 9 counts; at most 8"),
                ("build_up={speed: 0 m/s}", "build_up.speed"),
                ("history_map={cell: 1 mm}", "at most 100000 are allowed"),
                (f"history_map={{cell: 20 mm, region: {ring}}}", "must be a box"),
                (f"history_map={{cell: 20 mm, region: {box}}}", "must be larger than min")):
            self.write_rows()
            done = clod.run("check", "case.yaml", "--set", key, cwd=self.folder)
            self.assertEqual(done.returncode, 2, key)
            self.assertIn(words, done.stderr, key)


if __name__ == "__main__":
    clod.main()
