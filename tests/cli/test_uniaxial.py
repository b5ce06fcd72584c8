"""A small uniaxial test from the case file to the flow function.

The bounds are those of mechanics, not of the material: forces balance at rest, mass is kept, and
the programme runs in its order. The case is too small and too fast for a result worth having.
"""

import csv
import json
import math
import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = clod.source("tests/cli/uniaxial.yaml")
GRAVITY = 9.81
# CASE
STRESSES, SPEED, CRUSH_MAX = [10e3, 20e3], 0.080, 0.08
AREA = math.pi * 0.018 ** 2
DENSITY = 2481.3
PARTS = ["stress-1", "stress-2"]
FILL, LOWER, CONSOLIDATE, UNLOAD, FREE, CRUSH = range(6)


class Uniaxial(clod.TesterCase):

    CASE, OPTIONS, POINTS = CASE, ("-t", "1"), "flow_function.csv"

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        done = clod.run("check", CASE, "--json", "--threads", "1")
        assert done.returncode == 0, done.stderr
        cls.check = json.loads(done.stdout)

    def rows(self, part, phase):
        return [row for row in self.series[part] if row["phase"] == phase]

    def test_phases_come_in_order(self):
        self.assertEqual({row["phase"] for row in self.series["fill"]}, {FILL})
        for part in PARTS:
            phases = [row["phase"] for row in self.series[part]]
            self.assertEqual(phases, sorted(phases))
            self.assertEqual(set(phases),
                             {LOWER, CONSOLIDATE, UNLOAD, FREE, CRUSH})
            times = [self.series["fill"][-1]["time"]] + [row["time"] for row in
                                                         self.series[part]]
            self.assertEqual(times, sorted(set(times)))

    def test_mass_is_kept(self):
        mass = self.check["mass_kg"]
        for rows in self.series.values():
            for row in rows:
                self.assertAlmostEqual(row["bulk_density"] * AREA * row["height"] / mass, 1.0,
                                       delta=1e-9)
                self.assertAlmostEqual(row["solid_fraction"] * DENSITY / row["bulk_density"],
                                       1.0, delta=1e-9)

    def test_forces_balance_at_rest(self):
        """Base and mould carry lid and weight; the mould has no friction here."""
        weight = self.check["mass_kg"] * GRAVITY / AREA
        for part, stress in zip(PARTS, STRESSES):
            last = self.rows(part, CONSOLIDATE)[-1]
            self.assertAlmostEqual(last["axial_stress"] / stress, 1.0, delta=0.02)
            self.assertAlmostEqual(last["axial_stress_base"],
                                   last["axial_stress"] + weight, delta=0.02 * stress)
            self.assertAlmostEqual(last["mould_force"], 0.0, delta=1e-9)

    def test_unloading_ends_without_stress(self):
        for part in PARTS:
            stresses = [row["axial_stress"] for row in self.rows(part, UNLOAD)]
            self.assertLessEqual(stresses[-1], 0.0)
            self.assertGreater(min(stresses[:-1]), 0.0)

    def test_strain_counts_from_the_unloaded_height(self):
        for part in PARTS:
            zero = self.rows(part, UNLOAD)[-1]["height"]
            for row in self.rows(part, FREE):
                self.assertEqual(row["strain"], 0.0)
                self.assertEqual(row["speed"], 0.0)
            for row in self.rows(part, CRUSH):
                self.assertAlmostEqual(row["strain"], 1.0 - row["height"] / zero, delta=1e-12)
            speeds = [row["speed"] for row in self.rows(part, CRUSH)]
            self.assertEqual(speeds, sorted(speeds))
            self.assertGreater(speeds[-1], 0.5 * SPEED)
            self.assertLessEqual(speeds[-1], SPEED)

    def test_results_are_those_of_the_series(self):
        for part, stress, point, found in zip(PARTS, STRESSES, self.points,
                                              self.summary["flow_function"]):
            rested = self.rows(part, CONSOLIDATE)[-1]
            crushed = self.rows(part, CRUSH)
            most = max(row["axial_stress"] for row in crushed)
            self.assertEqual(point["consolidation_stress"], stress)
            self.assertAlmostEqual(point["sigma_1"] / rested["axial_stress"], 1.0, delta=1e-8)
            self.assertAlmostEqual(point["rho_b"] / rested["bulk_density"], 1.0, delta=1e-8)
            self.assertAlmostEqual(point["void_ratio"], 1.0 / rested["solid_fraction"] - 1.0,
                                   delta=1e-8)
            # the smoothed peak: below the largest sample, and the mean of what is averaged: 16
            # bins, which are as wide as samples are apart where that is more than a 16th of the
            # window of 0.002 (the lid still speeds up: measure/peak.h)
            self.assertLess(point["sigma_c"], most)
            strains = [row["strain"] for row in crushed]
            after = next(k for k, s in enumerate(strains) if s > point["strain_at_peak"])
            half = max(1e-3, 8 * (strains[after] - strains[after - 1]))
            near = [row["axial_stress"] for row in crushed
                    if abs(row["strain"] - point["strain_at_peak"]) < half]
            self.assertAlmostEqual(point["sigma_c"] / (sum(near) / len(near)), 1.0, delta=0.005)
            self.assertLess(point["strain_at_peak"], CRUSH_MAX)
            self.assertAlmostEqual(point["ffc"] * point["sigma_c"] / point["sigma_1"], 1.0,
                                   delta=1e-8)
            for key, column in (("sigma_1_Pa", "sigma_1"), ("sigma_c_Pa", "sigma_c"),
                                ("ffc", "ffc"), ("strain_at_peak", "strain_at_peak")):
                self.assertAlmostEqual(found[key] / point[column], 1.0, delta=1e-8)
            self.assertIn(f"{1e-3 * point['sigma_1']:.3f}", self.report)
            self.assertIn(f"{1e-3 * point['sigma_c']:.3f} ±", self.report)

    def test_warnings(self):
        """Small and fast, so those are told, each once."""
        self.assertIn("Warnings of the simulation", self.report)
        for text in ("stress-1: inertial number", "stress-2: inertial number",
                     "grain diameters across the specimen"):
            self.assertEqual(self.report.count(text), 1, self.report)
        self.assertNotIn("the mould carried", self.report)

    def test_check(self):
        self.assertEqual(self.check["kind"], "uniaxial")
        self.assertEqual(self.check["grains"], 250)
        self.assertEqual(self.check["stress_Pa"], 20e3)
        self.assertEqual(self.check["lowest_stress_Pa"], 10e3)
        self.assertAlmostEqual(self.check["step_s"], self.part["fill"]["dt_s"], delta=1e-15)
        steps = sum(part["steps"] for part in self.summary["parts"]) - 2 * self.part["fill"][
            "steps"]  # the parts go on counting where filling ended
        self.assertLess(steps, self.check["steps_most"])
        for text in ("inertial number", "grain diameters across"):
            self.assertTrue([w for w in self.check["warnings"] if text in w], text)

    def test_whatever_a_test_writes_protects_a_folder_of_the_user(self):
        for name in os.listdir(self.out):
            if name == ".clod-lock":
                continue
            mine = self.path(f"mine-{name}")
            os.mkdir(mine)
            shutil.copy(os.path.join(self.out, name), mine)
            done = clod.run("run", CASE, "-o", mine, "--fresh")
            self.assertEqual(done.returncode, 2, name)


class Small(clod.TesterCase):
    """With a ledger of the energy, which takes most of the time: few and soft grains."""

    OPTIONS, POINTS = ("-t", "1"), "flow_function.csv"

    @classmethod
    def setUpClass(cls):
        folder = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, folder)
        cls.CASE = os.path.join(folder, "case.yaml")
        with open(clod.source("tests/faults/uniaxial.yaml")) as file:
            text = file.read() + "output: {energy: true}\n"
        with open(cls.CASE, "w") as file:
            file.write(text)
        super().setUpClass()

    def test_energy_ledger_closes_over_all_phases(self):
        """Also where the mould is taken away with what its contacts store."""
        for name in self.part:
            with self.subTest(part=name):
                rows = list(csv.DictReader(open(os.path.join(self.out, f"{name}-energy.csv"))))
                self.assertGreater(len(rows), 20)
                self.assertGreater(float(rows[-1]["lost_friction [J]"]), 0.0)
                for row in rows:
                    self.assertLess(abs(float(row["residual_of_flow [1]"])), 1e-3)

    def test_what_the_mould_took_away_is_exchanged_and_not_missing(self):
        """It is a ten-thousandth of the flow: where it is booked, the residual may change by a tenth of it at most."""
        jumps = 0
        for name in self.part:
            with open(os.path.join(self.out, f"{name}-energy.csv")) as file:
                rows = list(csv.DictReader(file))
            for before, row in zip(rows, rows[1:]):
                exchanged, residual = (float(row[key]) - float(before[key]) for key in ("exchanged [J]", "residual [J]"))
                if exchanged != 0.0:
                    jumps += 1
                    self.assertLess(abs(residual), 0.1 * abs(exchanged), name)
        self.assertGreaterEqual(jumps, 2)

    @clod.quick_only
    def test_an_interrupted_test_ends_the_same(self):
        """Stopped while the mould goes, and again while the specimen is crushed."""
        self.assert_same_end_after_interruptions(("consolidate", "free", "crush"), ["fill", *PARTS])


if __name__ == "__main__":
    clod.main()
