"""A small Jenike shear test from the case file to the yield locus.

The bounds are those of mechanics, not of the material: what pulls the ring and what holds the
base balance but for the inertia of the bed, mass is kept, and the programme runs in its order.
The case is too small and too fast for a result worth having. What the tester shares with the
ring shear tester is in test_ring_shear.py.
"""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = clod.source("tests/cli/jenike.yaml")
TINY = clod.source("tests/restart/jenike.yaml")
# CASE
PRESHEAR, STRESSES, SPEED = 10e3, [3e3, 5e3, 7e3], 0.080
PRESHEAR_MAX, SHEAR_MAX, BLOCK = 6.1e-3, 2.9e-3, 0.5e-3
AREA = math.pi * 0.025 ** 2
FILL, LOWER, CONSOLIDATE, SHEARED, REVERSE, REDUCE, SHEAR, DONE, TWIST = range(9)
POINTS = ("point-1", "point-2", "point-3")


class Jenike(clod.TesterCase):

    CASE = CASE

    def sheared(self):
        """Preshear at full speed, its last 4 mm."""
        rows = [row for row in self.series["preshear"] if row["phase"] == SHEARED]
        return [row for row in rows if row["displacement"] > rows[-1]["displacement"] - 4e-3]

    def test_phases_come_in_order(self):
        phases = {name: [row["phase"] for row in rows] for name, rows in self.series.items()}
        self.assertEqual(sorted(set(phases["preshear"])), [FILL, LOWER, CONSOLIDATE, SHEARED])
        self.assertEqual(set(phases["reverse"]), {REVERSE})
        for point in POINTS:
            self.assertEqual(sorted(set(phases[point])), [REDUCE, SHEAR])
        for name, rows in self.series.items():
            self.assertEqual(phases[name], sorted(phases[name]), name)
            times = [row["time"] for row in rows]
            self.assertEqual(times, sorted(set(times)), name)

    def test_way_is_that_of_the_cell(self):
        way = self.series["preshear"][-1]["displacement"]
        # whole blocks: the next one would have gone beyond
        self.assertLess(way, PRESHEAR_MAX)
        self.assertGreater(way, PRESHEAR_MAX - BLOCK)
        self.assertEqual({row["speed"] for row in self.sheared()}, {SPEED})
        for point, stress in zip(POINTS, STRESSES):
            rows = self.series[point]
            self.assertLess(rows[-1]["displacement"], SHEAR_MAX + 0.02e-3)
            top = max(row["speed"] for row in rows if row["phase"] == SHEAR)
            self.assertAlmostEqual(top, SPEED * math.sqrt(stress / PRESHEAR), delta=1e-9)

    def test_forces_balance(self):
        """Nothing else pulls along x: they differ by the change of momentum of the bed."""
        rows = self.sheared()
        top, base = clod.mean(rows, "shear_stress"), clod.mean(rows, "shear_stress_base")
        self.assertGreater(top, 0.2 * PRESHEAR)
        self.assertAlmostEqual(top / base, 1.0, delta=0.01)

    def test_normal_stress(self):
        self.assertAlmostEqual(clod.mean(self.sheared(), "normal_stress") / PRESHEAR, 1.0,
                               delta=0.02)
        for name, stress in zip(POINTS, STRESSES):
            rows = [row for row in self.series[name] if row["phase"] == SHEAR]
            self.assertAlmostEqual(clod.mean(rows, "normal_stress") / stress, 1.0, delta=0.04)

    def test_bulk_density_is_mass_over_volume(self):
        mass = json.loads(clod.run("check", CASE, "--json").stdout)["mass_kg"]
        for rows in self.series.values():
            for row in rows:
                volume = AREA * row["height"]
                self.assertAlmostEqual(row["bulk_density"] * volume / mass, 1.0, delta=1e-8)

    def test_power_is_force_times_speed(self):
        for row in self.sheared():
            power = row["shear_stress"] * AREA * SPEED
            self.assertAlmostEqual(row["power"], power, delta=1e-8 * abs(power) + 1e-12)

    def test_reversal(self):
        rows = self.series["reverse"]
        self.assertGreater(rows[0]["shear_stress"], 0.0)
        self.assertGreater(min(row["shear_stress"] for row in rows[:-1]), 0.0)
        self.assertLessEqual(rows[-1]["shear_stress"], 0.0)

    def test_points_file_gives_the_locus(self):
        self.assertEqual([row["sigma_sh"] for row in self.points], STRESSES)
        for row, name in zip(self.points, POINTS):
            self.assertAlmostEqual(row["tau_sh"] / self.part[name]["shear_stress_Pa"], 1.0,
                                   delta=1e-8)
            self.assertEqual(row["sigma_pre"], PRESHEAR)
        done = clod.run("locus", os.path.join(self.out, "points.csv"), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        (locus,) = json.loads(done.stdout)["loci"]
        (here,) = self.summary["locus"]["loci"]
        for key in ("phi_lin_deg", "c_Pa", "phi_sf_deg"):
            self.assertAlmostEqual(locus[key]["value"] / here[key]["value"], 1.0, delta=1e-6)

    def test_shear_stress_is_where_preshear_ended(self):
        """A line through the means of the last blocks, here four of 50 rows, drawn to their end."""
        rows = [row["shear_stress"] for row in self.sheared()][-200:]
        blocks = [sum(rows[50 * k:50 * k + 50]) / 50 for k in range(4)]
        slope = sum((k - 1.5) * blocks[k] for k in range(4)) / 5.0
        part = self.part["preshear"]
        self.assertAlmostEqual(part["shear_stress_Pa"], sum(blocks) / 4 + 2.0 * slope,
                               delta=1e-6 * blocks[-1])
        self.assertAlmostEqual(part["shear_stress_rate_Pa_per_m"], slope / BLOCK,
                               delta=1e-6 * slope / BLOCK)

    def test_warnings_name_the_tester(self):
        """Far too short a way to become steady, and far too fast."""
        part = self.part["preshear"]
        self.assertFalse(part["steady"])
        rate, error = (1e-6 * part[key] for key in ("shear_stress_rate_Pa_per_m",
                                                    "shear_stress_rate_error_Pa_per_m"))
        self.assertGreater(rate, 2.0 * error)
        told = (f"preshear: shear stress still rising by {rate:.2g} ± {error:.1g} kPa/mm after "
                f"{1e3 * part['displacement_m']:.3g} mm of shear")
        self.assertEqual(self.report.count(told), 2, self.report)  # above the table, in the box
        for text in (told + "; tau_p is where a line through the last blocks ends. By ASTM D6128 "
                     "it then gives no valid point of a yield locus. Set jenike.twists (or raise "
                     "them), or raise preshear_max with offset and rim",
                     "preshear: inertial number"):
            self.assertEqual(self.report.count(text), 1, self.report)
        self.assertIn("lower jenike.speed", self.report)
        self.assertNotIn("ring_shear", self.report)


class Twisted(clod.Case):

    def test_lid_is_twisted_before_preshear(self):
        """The torque on the lid works, so the way takes its time and the bed gets denser."""
        done = clod.run("run", TINY, "-o", self.path("out"))
        self.assertEqual(done.returncode, 0, done.stderr)
        phases = [row["phase"] for row in clod.table(self.path("out/preshear.csv"))]
        seen = [phase for k, phase in enumerate(phases) if k == 0 or phases[k - 1] != phase]
        self.assertEqual(seen, [FILL, LOWER, CONSOLIDATE, TWIST, SHEARED])
        rows = [row for row in clod.table(self.path("out/preshear.csv")) if row["phase"] == TWIST]
        # 5 degrees to each side and back, the edge of 20 mm radius at 60 mm/s
        took = 4.0 * math.radians(5.0) * 0.020 / 0.060
        self.assertGreater(rows[-1]["time"] - rows[0]["time"], took)
        self.assertLess(rows[-1]["time"] - rows[0]["time"], 2.5 * took)  # with its turning
        self.assertLess(rows[-1]["height"], rows[0]["height"])
        self.assertEqual({row["displacement"] for row in rows}, {0.0})

    def test_seeds(self):
        done = clod.run("run", TINY, "-o", self.path("two"), "--set", "jenike.seeds=2")
        self.assertEqual(done.returncode, 0, done.stderr)
        points = clod.table(self.path("two/points.csv"))
        self.assertEqual([row["seed"] for row in points], [7, 7, 8, 8])
        self.assertNotEqual(points[0]["tau_sh"], points[2]["tau_sh"])

    def test_clod_new_writes_the_ore_case(self):
        done = clod.run("new", "jenike", self.path("case.yaml"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(clod.read(self.path("case.yaml")),
                         clod.read(clod.source("cases/copper-ore-jenike/case.yaml")))


if __name__ == "__main__":
    clod.main()
