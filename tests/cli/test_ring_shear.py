"""A small ring shear test from the case file to the yield locus.

The bounds are those of mechanics, not of the material: torque and force of lid and base balance
but for the inertia of the bed, mass is kept, and the programme runs in its order. The case is
too small and too fast for a result worth having.
"""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = clod.source("tests/cli/ring_shear.yaml")
TINY = clod.source("tests/restart/ring.yaml")
GRAVITY = 9.80665
# CASE
RI, RO = 0.020, 0.040
PRESHEAR, STRESSES, SPEED = 10e3, [3e3, 5e3, 7e3], 0.080
BARS, BAR_HEIGHT, BAR_WIDTH = 8, 0.004, 0.002
AREA = math.pi * (RO ** 2 - RI ** 2)
FILL, LOWER, CONSOLIDATE, SHEARED, REVERSE, REDUCE, SHEAR = range(7)


class RingShear(clod.TesterCase):

    CASE = CASE

    def steady(self):
        """Preshear at full speed, the last 8 mm: the blocks that the result is the mean of."""
        rows = [row for row in self.series["preshear"] if row["phase"] == SHEARED]
        return [row for row in rows if row["displacement"] > rows[-1]["displacement"] - 8e-3]

    def blocks(self, column):
        """Means over the last four or more blocks of 50 samples at full speed, of each number."""
        rows = [row for row in self.series["preshear"]
                if row["phase"] == SHEARED and abs(row["speed"] / SPEED - 1.0) < 1e-12]
        rows = rows[len(rows) % 50:]  # before the first block: on a way whose end makes the last end at preshear_max
        return [clod.mean(rows[-50 * blocks:], column) for blocks in range(4, len(rows) // 50 + 1)]

    def mass(self):
        """Mass of all grains, as the preflight counts them."""
        return json.loads(clod.run("check", CASE, "--json").stdout)["mass_kg"]

    def test_phases_come_in_order(self):
        phases = {name: [row["phase"] for row in rows] for name, rows in self.series.items()}
        self.assertEqual(sorted(set(phases["preshear"])), [FILL, LOWER, CONSOLIDATE, SHEARED])
        self.assertEqual(set(phases["reverse"]), {REVERSE})
        for point in ("point-1", "point-2", "point-3"):
            self.assertEqual(sorted(set(phases[point])), [REDUCE, SHEAR])
        for name, rows in self.series.items():
            self.assertEqual(phases[name], sorted(phases[name]), name)
            times = [row["time"] for row in rows]
            self.assertEqual(times, sorted(set(times)), name)

    def test_parts_begin_where_the_one_before_has_ended(self):
        for name, before in (("reverse", "preshear"), ("point-1", "reverse"),
                             ("point-2", "reverse"), ("point-3", "reverse")):
            last = self.series[before][-1]
            first = self.series[name][0]
            self.assertGreater(first["time"], last["time"])
            self.assertLess(first["time"] - last["time"], 2e-4)  # 50 steps of 2.5 us
            self.assertAlmostEqual(first["height"], last["height"], delta=2e-5)

    def test_the_step_is_below_the_largest_stable_one(self):
        """The step is a tenth of that of one contact; a bed of many takes at least that much of its
        own, and less than all of it. The log has it at the end of each phase, and of the last one
        what the summary has."""
        for part in self.summary["parts"]:
            self.assertLess(0.1 * part["stable_step_s"], part["dt_s"])
            self.assertLess(part["dt_s"], part["stable_step_s"])
            phases = [event for event in clod.log(self.out)
                      if event["event"] == "phase" and event["part"] == part["part"]]
            self.assertEqual(phases[-1]["stable_step_s"], part["stable_step_s"])
            for event in phases:
                self.assertLess(part["dt_s"], event["stable_step_s"])

    def test_speeds(self):
        self.assertEqual({row["speed"] for row in self.steady()}, {SPEED})
        for name, stress in zip(("point-1", "point-2", "point-3"), STRESSES):
            # the inertial number of preshear: speed ~ sqrt(stress)
            top = max(row["speed"] for row in self.series[name] if row["phase"] == SHEAR)
            self.assertAlmostEqual(top, SPEED * math.sqrt(stress / PRESHEAR), delta=1e-9)

        self.assertLess(min(row["speed"] for row in self.series["reverse"]), 0.0)

    def test_torques_balance(self):
        """No torque from outside but the two: they differ by the change of spin of the bed."""
        rows = self.steady()
        lid, base = clod.mean(rows, "shear_stress"), clod.mean(rows, "shear_stress_base")
        self.assertGreater(lid, 0.2 * PRESHEAR)
        self.assertAlmostEqual(lid / base, 1.0, delta=0.01)

    def test_normal_stress(self):
        rows = self.steady()
        plane, base = clod.mean(rows, "normal_stress"), clod.mean(rows, "normal_stress_base")
        self.assertAlmostEqual(plane / PRESHEAR, 1.0, delta=0.02)
        # the base carries the solid below the shear plane as well, h - h_bar of h
        height = clod.mean(rows, "height")
        below = self.mass() * GRAVITY / AREA * (1.0 - BAR_HEIGHT / height)
        self.assertAlmostEqual(base - plane, below, delta=0.25 * below)

    def test_normal_stress_of_the_points(self):
        for name, stress in zip(("point-1", "point-2", "point-3"), STRESSES):
            rows = [row for row in self.series[name] if row["phase"] == SHEAR]
            self.assertAlmostEqual(clod.mean(rows, "normal_stress") / stress, 1.0, delta=0.04)
            self.assertEqual(self.part[name]["normal_stress_Pa"], stress)
            # what is judged is the stress at the peak: 0.2 mm about it, give or take a bin
            peak = self.part[name]["displacement_m"]
            near = [row for row in rows if abs(row["displacement"] - peak) < 0.1e-3]
            self.assertAlmostEqual(self.part[name]["measured_normal_stress_Pa"],
                                   clod.mean(near, "normal_stress"), delta=0.01 * stress)

    def test_bulk_density_is_mass_over_volume(self):
        """Whatever the height: mass = density (A h - V) with one volume V, that of the bars."""
        mass = self.mass()
        volumes = [AREA * row["height"] - mass / row["bulk_density"]
                   for rows in self.series.values() for row in rows]
        most = 2 * BARS * BAR_HEIGHT * BAR_WIDTH * (RO - RI)  # bars from wall to wall
        self.assertLess(max(volumes) - min(volumes), 1e-9 * AREA * 0.02)
        self.assertLess(volumes[0], most)
        self.assertGreater(volumes[0], 0.8 * most)
        densities = [mass / (AREA * height - volumes[0]) for height in self.blocks("height")]
        result = self.part["preshear"]["bulk_density_kg_m3"]
        self.assertLess(min(abs(value / result - 1.0) for value in densities), 1e-6)

    def test_power_is_torque_times_spin(self):
        """The walls turn as one: power = tau A r_m * speed / r_m, whatever the mean radius."""
        rows = self.steady()
        work = clod.mean(rows, "shear_stress_base") * AREA * SPEED
        self.assertAlmostEqual(clod.mean(rows, "power") / work, 1.0, delta=1e-6)

    def test_reversal(self):
        rows = self.series["reverse"]
        self.assertGreater(rows[0]["shear_stress"], 0.0)
        self.assertGreater(min(row["shear_stress"] for row in rows[:-1]), 0.0)
        self.assertLessEqual(rows[-1]["shear_stress"], 0.0)

    def test_results_are_those_of_the_series(self):
        self.assertEqual(self.part["preshear"]["flags"], [])
        self.assertEqual(self.part["reverse"]["flags"], [])
        self.assertEqual(self.part["reverse"]["normal_stress_Pa"], PRESHEAR)
        self.assertNotIn("shear_stress_Pa", self.part["reverse"])
        means = self.blocks("shear_stress")
        result = self.part["preshear"]["shear_stress_Pa"]
        self.assertLess(min(abs(value / result - 1.0) for value in means), 1e-9)
        for name in ("point-1", "point-2", "point-3"):
            shear = [row["shear_stress"] for row in self.series[name] if row["phase"] == SHEAR]
            # the smoothed peak: below the largest sample, above the mean
            self.assertLess(self.part[name]["shear_stress_Pa"], max(shear))
            self.assertGreater(self.part[name]["shear_stress_Pa"], sum(shear) / len(shear))

    def test_points_file(self):
        self.assertEqual([row["sigma_sh"] for row in self.points], STRESSES)
        for row, name in zip(self.points, ("point-1", "point-2", "point-3")):
            self.assertEqual(row["seed"], 5)
            self.assertEqual(row["sigma_pre"], PRESHEAR)
            for column, value in (("tau_sh", self.part[name]["shear_stress_Pa"]),
                                  ("tau_pre", self.part["preshear"]["shear_stress_Pa"]),
                                  ("rho_b", self.part["preshear"]["bulk_density_kg_m3"])):
                self.assertAlmostEqual(row[column] / value, 1.0, delta=1e-8)

    def assert_same(self, left, right, where="locus"):
        """Equal but for numbers, which agree to 1e-6: points.csv has 9 digits."""
        self.assertIs(type(left), type(right), where)
        if isinstance(left, dict):
            self.assertEqual(left.keys(), right.keys(), where)
            for key in left:
                self.assert_same(left[key], right[key], f"{where}.{key}")
        elif isinstance(left, list):
            self.assertEqual(len(left), len(right), where)
            for at, pair in enumerate(zip(left, right)):
                self.assert_same(*pair, f"{where}[{at}]")
        elif isinstance(left, float):
            self.assertAlmostEqual(left, right, delta=1e-6 * abs(right), msg=where)
        else:
            self.assertEqual(left, right, where)

    def test_locus_of_the_points_file(self):
        path = os.path.join(self.out, "points.csv")
        done = clod.run("locus", path, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same(json.loads(done.stdout), self.summary["locus"])
        shown = clod.run("locus", path).stdout
        for line in shown.splitlines():
            self.assertIn(line, self.report)

    def test_locus_by_hand(self):
        """Least squares through the three points, and their one preshear (docs/theory/ring-shear.md).

        Prorating changes nothing: tau_pre is one measurement, the same in all rows. With x, y the
        points and x0, y0 their means: t = sum (x - x0)(y - y0)/sum (x - x0)^2, c = y0 - t x0,
        phi_lin = atan t; phi_sf = atan(tau_pre/sigma_pre), its error that of tau_pre once.
        """
        x = [row["sigma_sh"] for row in self.points]
        y = [row["tau_sh"] for row in self.points]
        tau_p, error = self.points[0]["tau_pre"], self.points[0]["tau_pre_error"]
        for row in self.points:
            self.assertEqual((row["tau_pre"], row["tau_pre_error"]), (tau_p, error))
        self.assertGreater(error, 0.0)
        x0, y0 = sum(x) / 3, sum(y) / 3
        slope = (sum((a - x0) * (b - y0) for a, b in zip(x, y)) /
                 sum((a - x0) ** 2 for a in x))
        ratio = tau_p / PRESHEAR
        (locus,) = self.summary["locus"]["loci"]
        for key, part, expected, accuracy in (
                ("c_Pa", "value", y0 - slope * x0, 1e-6),
                ("phi_lin_deg", "value", math.degrees(math.atan(slope)), 1e-6),
                ("tau_p_Pa", "value", tau_p, 1e-6),
                ("tau_p_Pa", "error", error, 1e-6),
                ("phi_sf_deg", "value", math.degrees(math.atan(ratio)), 1e-6),
                # the evaluation takes a difference, this is the slope: second order
                ("phi_sf_deg", "error",
                 math.degrees(error / PRESHEAR / (1.0 + ratio ** 2)), (error / tau_p) ** 2)):
            with self.subTest(key=key, part=part):
                self.assertAlmostEqual(locus[key][part] / expected, 1.0, delta=accuracy)

    def test_warnings(self):
        """Steady, so nothing about that; small and fast, so those are told, each once."""
        self.assertIn("Warnings of the simulation", self.report)
        rate, error = (1e-6 * self.part["preshear"][f"shear_stress_rate{key}_Pa_per_m"] for key in ("", "_error"))
        self.assertIn(f"preshear: shear stress steady after {1e3 * self.part['preshear']['displacement_m']:.3g} mm of shear, "
                      f"its slope {rate:+.2g} ± {error:.1g} kPa/mm\n", self.report)
        self.assertTrue(self.part["preshear"]["steady"])
        for text in ("preshear: inertial number", "point-1: inertial number",
                     "preshear: overlap up to",
                     "grain diameters across the specimen"):
            self.assertEqual(self.report.count(text), 1, self.report)
        for word in ("inertial", "normal stress", "mm per mm"):  # nothing is judged on the way back
            self.assertNotRegex(self.report, f"reverse: .*{word}")
        for warning in self.summary["warnings"]:
            self.assertIn("  - " + warning, self.report)
        self.assertGreater(len(self.summary["warnings"]), 3)


class Provoked(clod.Case):

    def report(self, *options):
        done = clod.run("run", TINY, "-o", self.path("out"), *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_warnings(self):
        text = self.report("--set", "ring_shear.preshear_min=5 mm", "--set",
                           "ring_shear.preshear_max=5 mm", "--set",
                           "ring_shear.lid_damping=20")
        # so much damping that the lid does not come down to the grains in time
        for warning in ("; tau_p is where a line through the last blocks ends. Raise ring_shear",
                        "preshear: filling or consolidation did not come to rest",
                        "preshear: the mean normal stress of the last blocks was",
                        "preshear: inertial number",
                        "point-1: the lid under the reduced load did not come to rest",
                        "grain diameters across the specimen"):
            self.assertEqual(text.count(warning), 1, text)

    def test_seeds(self):
        text = self.report("--set", "ring_shear.seeds=2")
        with open(self.path("out/summary.json")) as file:
            summary = json.load(file)
        names = [f"seed-{seed}-{part}" for seed in (7, 8)
                 for part in ("preshear", "reverse", "point-1", "point-2")]
        self.assertEqual(sorted(part["part"] for part in summary["parts"]), sorted(names))
        points = clod.table(self.path("out/points.csv"))
        self.assertEqual([row["seed"] for row in points], [7, 7, 8, 8])
        self.assertNotEqual(points[0]["tau_sh"], points[2]["tau_sh"])
        self.assertIn("2 seeds", text)
        # the first seed is the test of one seed, byte for byte
        done = clod.run("run", TINY, "-o", self.path("one"))
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in ("preshear", "reverse", "point-1", "point-2"):
            self.assertEqual(clod.read(self.path(f"out/seed-7-{part}.csv")),
                             clod.read(self.path(f"one/{part}.csv")))
            self.assertNotEqual(clod.read(self.path(f"out/seed-8-{part}.csv")),
                                clod.read(self.path(f"one/{part}.csv")))


if __name__ == "__main__":
    clod.main()
