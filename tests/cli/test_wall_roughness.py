"""A small wall friction test on a plate with ridges.

The bounds are those of mechanics: forces balance, mass is kept, and no contact drags more than its
flank and its friction let it. Where the surface is, and what a flank does to a single grain, is in
tests/setup/test_ridged_plate.c; how phi_x grows with the ridges is in docs/results/wall-roughness.md.
"""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = clod.source("tests/cli/wall_roughness.yaml")
FLAT = clod.source("tests/cli/wall_friction.yaml")
RING = clod.source("tests/cli/wall_friction_ring.yaml")
# CASE
RADIUS, HEIGHT, SPACING, FRICTION, STRESSES = 25e-3, 1e-3, 5e-3, 0.2, [20e3, 10e3]
AREA = math.pi * RADIUS ** 2
SHEAR = 4


def check(*options, case=CASE):
    done = clod.run("check", case, "--json", "-t", "1", *options)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def ridges(text):
    return "--set", "wall_friction.plate_ridges={" + text + "}"


class Ridges(clod.TesterCase):

    CASE, OPTIONS, POINTS = CASE, ("-t", "1"), "wall_friction.csv"

    def sheared(self, stress):
        return [row for row in self.series["wall"] if row["phase"] == SHEAR
                and abs(row["normal_stress_lid"] / stress - 1) < 0.2]

    def test_no_contact_drags_more_than_its_flank_and_its_friction(self):
        """Flanks of tan a = 2 height/spacing, and grains slip on them with atan(friction)."""
        steepest = math.atan(2 * HEIGHT / SPACING) + math.atan(FRICTION)
        rows = [row for row in self.series["wall"] if row["phase"] == SHEAR]
        self.assertGreater(len(rows), 200)
        for row in rows:
            self.assertLess(row["shear_stress"], math.tan(steepest) * row["normal_stress"])

    def test_ridges_are_rougher_than_the_friction_of_the_plate(self):
        for stress in STRESSES:
            rows = self.sheared(stress)
            ratio = clod.mean(rows, "shear_stress") / clod.mean(rows, "normal_stress")
            self.assertGreater(ratio, 1.25 * FRICTION)

    def test_forces_balance(self):
        for stress in STRESSES:
            rows = self.sheared(stress)
            drag, held = clod.mean(rows, "shear_stress"), clod.mean(rows, "shear_stress_held")
            self.assertAlmostEqual(drag / held, 1.0, delta=0.02)
            for column in ("normal_stress", "normal_stress_lid"):
                self.assertAlmostEqual(clod.mean(rows, column) / stress, 1.0, delta=0.02)

    def test_the_solid_fills_what_the_ridges_leave(self):
        """Triangles side by side take half of their height."""
        mass = check()["mass_kg"]
        for row in self.series["wall"]:
            room = AREA * (row["height"] - 0.5 * HEIGHT)
            self.assertAlmostEqual(row["bulk_density"] * room / mass, 1.0, delta=1e-9)

    def test_the_plate_moves_on_and_on(self):
        """Over several ridges, and never off its end: to where check says it reaches."""
        way = self.series["wall"][-1]["displacement"]
        self.assertGreater(way, 1.5 * SPACING)
        reaches = check()["plate_ridges"] * SPACING - 2 * RADIUS - 2 * SPACING
        self.assertLess(way, reaches + SPACING)

    def test_the_echo_is_the_case(self):
        echo = clod.read(os.path.join(self.out, "case-complete.yaml")).decode()
        for line in ("plate_ridges:", "height: 0.001 m", "spacing: 0.005 m", "width: auto",
                     "crest: 0 m"):
            self.assertIn(line, echo)
        again = self.path("again.yaml")
        with open(again, "w") as file:
            file.write(echo)
        self.assertEqual(check(case=again)["plate_ridges"], check()["plate_ridges"])

    def test_an_interrupted_test_ends_the_same(self):
        self.assert_same_end_after_interruptions(("consolidate", "shear"), ["fill", "wall"])

    def test_two_threads_give_the_same_bytes(self):
        out = self.path("threads")
        done = clod.run("run", CASE, "-o", out, "-t", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(self.out, out, ["fill", "wall"])

    def test_another_programme_begins_from_the_same_filling(self):
        out = self.path("from")
        other = ("--from", self.out, "--set", "wall_friction.wall_stresses=[8 kPa, 4 kPa]")
        done = clod.run("run", CASE, "-o", out, "-t", "1", *other)
        self.assertEqual(done.returncode, 0, done.stderr)
        points = clod.table(os.path.join(out, "wall_friction.csv"))
        self.assertEqual([point["wall_stress"] for point in points], [8e3, 4e3])

    def test_a_programme_that_needs_a_longer_plate_is_refused(self):
        done = clod.run("run", CASE, "-o", self.path("long"), "-t", "1", "--from", self.out,
                        "--set", "wall_friction.shear_max=100 mm")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("the plate with ridges there is not as long", done.stderr)


class Check(clod.Case):

    def test_numbers_of_the_plate(self):
        """Rmax within a grain's diameter of about 5 mm is all of the height."""
        told = check()
        self.assertAlmostEqual(told["ridge_spacing_m"], SPACING, delta=1e-12)
        self.assertAlmostEqual(math.tan(told["ridge_flank_rad"]), 0.4, delta=1e-9)
        self.assertAlmostEqual(told["plate_roughness"] * 2 * told["radius_mean_m"] / HEIGHT, 1.0,
                               delta=1e-9)
        self.assertNotIn("plate_ridges", check(case=FLAT))

    def test_a_spacing_that_does_not_divide_the_ring(self):
        """2 pi r_m = 195.5 mm, r_m = 2/3 (40^3 - 20^3)/(40^2 - 20^2) mm: 6.5 ridges of 30 mm."""
        told = check(*ridges("height: 2 mm, spacing: 30 mm, width: 5 mm"), case=RING)
        self.assertEqual(told["plate_ridges"], 7)
        self.assertAlmostEqual(told["ridge_spacing_m"], 2 * math.pi * 280e-3 / 9 / 7, delta=1e-9)
        self.assertEqual([w for w in told["warnings"] if "does not divide" in w][0][:24],
                         "a spacing of 30 mm does ")
        fits = check(*ridges("height: 2 mm, spacing: 3 mm"), case=RING)
        self.assertFalse([w for w in fits["warnings"] if "does not divide" in w])

    def test_ridges_that_no_grain_feels(self):
        told = check(*ridges("height: 0.1 mm, spacing: 0.5 mm"))
        self.assertEqual(len([w for w in told["warnings"] if "hardly feel them" in w]), 1)
        self.assertFalse([w for w in check()["warnings"] if "hardly feel them" in w])

    def test_ridges_finer_than_a_grain_are_told_as_it_feels_them(self):
        """A sphere on two edges 2 mm apart sinks r - sqrt(r^2 - 1 mm^2) below the crests, 4 mm high or 8 mm."""
        lines = lambda *options: clod.run("check", CASE, "-t", "1", *options).stdout
        for height in (4, 8):
            fine = ridges(f"height: {height} mm, spacing: 2 mm")
            told = check(*fine)
            radius = told["radius_mean_m"]
            sinks = (radius - math.sqrt(radius ** 2 - 1e-6)) / (2 * radius)
            self.assertAlmostEqual(told["ridge_sink_depth_diameters"], sinks, delta=1e-9)
            self.assertGreater(told["plate_roughness"], 15 * sinks)
            self.assertIn(f"the depth they sink, {sinks:.3g} d", lines(*fine))
        self.assertNotIn("the depth they sink", lines(*ridges("height: 1 mm, spacing: 6 mm")))


if __name__ == "__main__":
    clod.main()
