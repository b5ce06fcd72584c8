"""A small wall friction test from the case file to the wall yield locus.

The bounds are those of mechanics, not of the material: forces balance, mass is kept, no contact
bears more than its friction, and the programme runs in its order. The case is too small and too
fast for a result worth having of the solid; of a smooth plate it is exact.
"""

import json
import math
import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = clod.source("tests/cli/wall_friction.yaml")
RING = clod.source("tests/cli/wall_friction_ring.yaml")
# CASE
STRESSES, SPEED, FRICTION = [20e3, 10e3, 5e3], 0.100, 0.2
BLOCK, SHEAR_MIN, SHEAR_MAX = 0.5e-3, 2.5e-3, 5e-3
AREA = math.pi * 0.030 ** 2
FILL, LOWER, CONSOLIDATE, RUN_IN, SHEAR = range(5)


class Straight(clod.TesterCase):

    CASE, OPTIONS, POINTS = CASE, ("-t", "1"), "wall_friction.csv"

    def sheared(self):
        """The rows of shear at each stress in turn."""
        runs = []
        before = None
        for row in self.series["wall"]:
            if row["phase"] == SHEAR:
                if before != SHEAR:
                    runs.append([])
                runs[-1].append(row)
            before = row["phase"]
        return runs

    def test_phases_come_in_order(self):
        self.assertEqual({row["phase"] for row in self.series["fill"]}, {FILL})
        phases = [row["phase"] for row in self.series["wall"]]
        seen = [phase for k, phase in enumerate(phases) if k == 0 or phases[k - 1] != phase]
        self.assertEqual(seen, [LOWER, CONSOLIDATE, *[RUN_IN, SHEAR] * 3])
        times = [row["time"] for row in self.series["fill"] + self.series["wall"]]
        self.assertEqual(times, sorted(set(times)))

    def test_the_plate_never_stops_and_goes_slower_at_less_stress(self):
        rows = [row for row in self.series["wall"] if row["phase"] in (RUN_IN, SHEAR)][1:]
        self.assertGreater(min(row["speed"] for row in rows), 0.0)
        for rows, stress in zip(self.sheared(), STRESSES):
            self.assertAlmostEqual(rows[-1]["speed"], SPEED * math.sqrt(stress / STRESSES[0]),
                                   delta=1e-12)
            way = rows[-1]["displacement"] - rows[0]["displacement"]
            self.assertGreater(way, 0.9 * SHEAR_MIN)
            self.assertLess(way, SHEAR_MAX + 0.1 * BLOCK)

    def test_a_smooth_plate_has_the_friction_of_its_contacts(self):
        """No contact bears more than its friction times its normal force, of which a dash-pot's pull
        may be a part; and where the solid slips, each bears just that."""
        for rows in self.sheared():
            for row in rows:
                self.assertLess(row["shear_stress"], FRICTION * row["normal_stress"] * (1 + 1e-3))
        for point in self.points:
            self.assertAlmostEqual(point["tau_w"] / point["sigma_w"], FRICTION, delta=2e-3 * FRICTION)
            self.assertAlmostEqual(point["phi_x"], math.degrees(math.atan(FRICTION)), delta=0.03)
        locus = self.summary["wall_locus"]
        self.assertAlmostEqual(locus["phi_w_deg"]["value"], math.degrees(math.atan(FRICTION)),
                               delta=0.05)
        self.assertLess(abs(locus["tau_ad_Pa"]["value"]), 1e-3 * STRESSES[0])

    def test_forces_balance(self):
        """Lid and side hold what the plate drags, and the plate bears lid and weight."""
        for rows, stress in zip(self.sheared(), STRESSES):
            drag, held = clod.mean(rows, "shear_stress"), clod.mean(rows, "shear_stress_held")
            self.assertAlmostEqual(drag / held, 1.0, delta=0.01)
            for column in ("normal_stress", "normal_stress_lid"):
                self.assertAlmostEqual(clod.mean(rows, column) / stress, 1.0, delta=0.01)

    def test_mass_is_kept_and_power_is_force_times_speed(self):
        mass = json.loads(clod.run("check", CASE, "--json", "-t", "1").stdout)["mass_kg"]
        for row in self.series["wall"]:
            self.assertAlmostEqual(row["bulk_density"] * AREA * row["height"] / mass, 1.0, delta=1e-9)
        for row in self.sheared()[0][1:]:
            power = row["shear_stress"] * AREA * SPEED
            self.assertAlmostEqual(row["power"], power, delta=1e-8 * power)

    def test_results_are_the_means_of_the_series(self):
        """The blocks that agree are the last ones, five of 25 rows at least."""
        self.assertEqual([point["wall_stress"] for point in self.points], STRESSES)
        for point, rows, found in zip(self.points, self.sheared(),
                                      self.part["wall"]["stresses"]):
            blocks = len(rows) // 25
            means = [clod.mean(rows[25 * k:], "shear_stress") for k in range(blocks - 4)]
            self.assertTrue(any(abs(point["tau_w"] / mean - 1.0) < 1e-8 for mean in means))
            self.assertAlmostEqual(found["shear_stress_Pa"] / point["tau_w"], 1.0, delta=1e-8)
            self.assertTrue(found["steady"])
            self.assertIn(f"{1e-3 * point['tau_w']:.3f} ±", self.report)

    def test_locus_and_hopper_read_what_it_wrote(self):
        done = clod.run("locus", os.path.join(self.out, "wall_friction.csv"), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        again = json.loads(done.stdout)
        for key in ("phi_w_deg", "tau_ad_Pa"):
            self.assertAlmostEqual(again[key]["value"], self.summary["wall_locus"][key]["value"],
                                   delta=1e-4)  # the table has nine digits
        design = self.path("hopper")
        shutil.copytree(clod.source("cases/hopper-design"), design)
        few = ("hopper", "hopper.yaml", "--json", "--set", "interval.samples=100")
        done = clod.run(*few, "--set", f"wall_friction.file={self.out}", cwd=design)
        self.assertEqual(done.returncode, 0, done.stderr)
        by_folder = json.loads(done.stdout)
        done = clod.run(*few, "--set", f"wall_friction.file={self.out}/wall_friction.csv", cwd=design)
        by_table = json.loads(done.stdout)
        self.assertNotEqual(by_folder.pop("overrides"), by_table.pop("overrides"))
        self.assertEqual(by_folder, by_table)

    def test_warnings(self):
        self.assertEqual(self.report.count("wall: inertial number"), 1, self.report)
        self.assertNotIn("not steady", self.report)
        self.assertNotIn("side walls carry", self.report)

    @clod.quick_only
    def test_an_interrupted_test_ends_the_same(self):
        """Stopped in the run-in, while it is sheared, and at other stresses."""
        self.assert_same_end_after_interruptions(("consolidate", "run-in", "shear"), ["fill", "wall"])

    def test_another_programme_begins_from_the_same_filling(self):
        out = self.path("from")
        done = clod.run("run", CASE, "-o", out, "-t", "1", "--from", self.out,
                        "--set", "wall_friction.wall_stresses=[8 kPa, 4 kPa]",
                        "--set", "wall_friction.shear_min=2 mm", "--set", "wall_friction.shear_max=3 mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        points = clod.table(os.path.join(out, "wall_friction.csv"))
        self.assertEqual([point["wall_stress"] for point in points], [8e3, 4e3])
        self.assertEqual(clod.table(os.path.join(out, "fill.csv")), self.series["fill"])

    def test_whatever_a_test_writes_protects_a_folder_of_the_user(self):
        for name in os.listdir(self.out):
            if name != ".clod-lock":
                mine = self.path(f"mine-{name}")
                os.mkdir(mine)
                shutil.copy(os.path.join(self.out, name), mine)
                done = clod.run("run", CASE, "-o", mine, "--fresh")
                self.assertEqual(done.returncode, 2, name)


class Ring(clod.TesterCase):

    CASE, OPTIONS, POINTS = RING, ("-t", "1"), "wall_friction.csv"

    def test_each_seed_has_its_parts(self):
        self.assertEqual(sorted(self.part), ["seed-3-fill", "seed-3-wall", "seed-4-fill", "seed-4-wall"])
        self.assertEqual([(p["seed"], p["wall_stress"]) for p in self.points],
                         [(3, 20e3), (3, 10e3), (4, 20e3), (4, 10e3)])
        self.assertEqual(self.summary["wall_locus"]["errors_from"], "seeds")

    def test_friction_of_the_plate(self):
        """A torque: grains bear their friction at radii between those of the walls, less their
        own, 22.2 to 37.8 mm, where a uniform stress has r_m = 31.1 mm. To 0.1 % from the
        contacts of a checkpoint: tests/python/test_wall_contacts.py."""
        for p in self.points:
            self.assertGreater(p["tau_w"] / p["sigma_w"], FRICTION * 22.2 / 31.1)
            self.assertLess(p["tau_w"] / p["sigma_w"], FRICTION * 37.8 / 31.1)

    def test_torques_balance(self):
        for name in ("seed-3-wall", "seed-4-wall"):
            rows = [row for row in self.series[name] if row["phase"] == SHEAR]
            self.assertAlmostEqual(clod.mean(rows, "shear_stress")
                                   / clod.mean(rows, "shear_stress_held"), 1.0, delta=0.01)


class Check(clod.Case):

    def warnings(self, *changes, case=CASE):
        options = [word for change in changes for word in ("--set", change)]
        done = clod.run("check", case, "--json", "-t", "1", *options, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["warnings"]

    def test_the_template_is_one_that_its_check_does_not_warn_of(self):
        self.assertEqual(clod.run("new", "wall-friction", cwd=self.folder).returncode, 0)
        self.assertEqual(self.warnings(case="wall-friction.yaml"), [])
        ring = clod.source("cases/wall-friction/ring.yaml")
        self.assertEqual(self.warnings(case=ring), [])
        lever = self.warnings("wall_friction.seeds=1", case=ring)
        self.assertIn("an error of the lever", " ".join(lever))

    def test_a_plate_no_smoother_than_the_grains_needs_a_ring(self):
        """Grains of friction 0.5: a straight cell measures such a plate, a ring the solid on it."""
        told = lambda friction, case: [w for w in self.warnings(f"contacts.ore-plate.friction={friction}", case=case)
                                       if "not smoother than the grains" in w]
        self.assertEqual(told(0.45, CASE), [])
        said, = told(1, CASE)
        self.assertTrue(said.startswith("the plate (friction 1) is not smoother than the grains (0.5)"), said)
        self.assertIn("Use cell: ring", said)
        self.assertEqual(told(1, RING), [])

    def test_adhesion_that_the_coulomb_limit_does_not_count(self):
        """Of each law that pulls, in each way to say so; not of ridges, over which grains ride."""
        adhesion = "contacts.ore-plate.k_adh=3e6 N/m^1.5"
        told = lambda *changes: [w for w in self.warnings(*changes) if "next to no wall adhesion" in w]
        for coulomb in ("force", "paper"):
            limit = f"contacts.ore-plate.coulomb={coulomb}"
            self.assertEqual(told(limit), [])
            said, = told(limit, adhesion)
            self.assertTrue(said.startswith("k_adh of ore and plate "), said)
            self.assertIn(f"with coulomb: {coulomb} ", said)
            self.assertEqual(told(limit, adhesion, "wall_friction.plate_ridges={height: 1 mm, spacing: 5 mm}"), [])
            for key in ("pull_off_force=0.1 N", "surface_energy=1 J/m2"):
                said, = told(limit, "contacts.default.law=eepa", f"contacts.ore-plate.{key}")
                self.assertTrue(said.startswith(key.split("=")[0] + " of ore and plate "), said)
        self.assertEqual(told(adhesion), [])
        self.assertEqual(told("contacts.ore-plate.coulomb=adhesive", adhesion), [])
        # the grains' own adhesion is not the wall's
        self.assertEqual(told("contacts.default.k_adh=3e6 N/m^1.5", "contacts.default.coulomb=paper",
                              "contacts.ore-plate.k_adh=0 N/m^1.5"), [])


if __name__ == "__main__":
    clod.main()
