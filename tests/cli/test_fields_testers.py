"""Fields of tests: means over regions of the cell in the series of each part. What they must be follows from the
balance of forces and from the mass of the grains."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

RING = clod.source("tests/cli/ring_shear.yaml")
RI, RO = 0.020, 0.040  # m, of RING
R_MEAN = 2.0 / 3.0 * (RO ** 3 - RI ** 3) / (RO ** 2 - RI ** 2)
BAR_HEIGHT, SPEED = 0.004, 0.080
SHEARED = 3  # phase
SMALL_WALL = (("shear_min: 2.5 mm", "shear_min: 1 mm"), ("shear_max: 5 mm", "shear_max: 1.2 mm"),
              ("block_displacement: 0.5 mm", "block_displacement: 0.3 mm\n  steady_blocks: 3"),
              ("grain_count: 400", "grain_count: 60"), ("outer_radius: 30 mm", "outer_radius: 14 mm"))
SMALL_RING = clod.source("tests/restart/ring.yaml")
PLAIN = (", energy: true", "")  # SMALL_RING without its ledger, which takes most of the time
PHASES = {"preshear": "preshear", "reverse": "reverse", "point": "shear", "fill": "fill", "stress": "crush", "wall": "shear"}
ANNULUS = "{{annulus: {{center: [0 m, 0 m, {} m], inner_radius: 20 mm, outer_radius: 40 mm, height: {} m}}}}"


def ring_fields(*more):
    """Everything in the trough, the layer between its bars, and one well between both kinds of bars."""
    fields = {"whole": (-0.05, 0.2), "bars": (0.0, BAR_HEIGHT), "middle": (0.007, 0.006)}
    lines = [f"  {name}: {{region: {ANNULUS.format(*place)}, components: cylindrical, interval: 1 ms}}"
             for name, place in fields.items()]
    return "\n".join(["", "fields:", *lines, *more]) + "\n"


class FieldsOfTests(clod.Case):

    def write(self, source, fields, *changes):
        with open(source) as file:
            text = file.read() + fields
        for before, after in changes:
            self.assertIn(before, text)
            text = text.replace(before, after)
        with open(self.path("case.yaml"), "w") as file:
            file.write(text)

    def mass(self):
        """Mass of all grains, as the preflight counts them; it has nothing against fields."""
        told = json.loads(clod.run("check", self.path("case.yaml"), "--json").stdout)
        self.assertFalse([text for text in told["warnings"] if "fields" in text])
        return told["mass_kg"]

    def test_a_ring(self):
        self.write(RING, ring_fields())
        self.go("out")
        rows = clod.table(self.path("out/preshear.csv"))
        mass, volume = self.mass(), math.pi * (RO ** 2 - RI ** 2) * 0.2
        for row in rows:
            self.assertAlmostEqual(row["field_whole.density"] * volume / mass, 1.0, delta=1e-9)
        steady = [row for row in rows if row["phase"] == SHEARED and abs(row["speed"] / SPEED - 1.0) < 1e-9][-200:]
        # side walls are smooth: what passes a level plane lies between the loads of base and plane
        vertical = clod.mean(steady, "field_middle.contact_stress_zz")
        low, high = (clod.mean(steady, name) for name in ("normal_stress", "normal_stress_base"))
        self.assertGreater(vertical, 0.97 * low)
        self.assertLess(vertical, 1.03 * high)
        # the torque through the plane is that of the lid; r_m weighs radii as an even stress would
        shear = clod.mean(steady, "field_middle.contact_stress_tz")
        self.assertAlmostEqual(abs(shear) / clod.mean(steady, "shear_stress"), 1.0, delta=0.2)
        # what lies between the bars turns with them, above it is slower; nothing moves outwards
        turned = clod.mean(steady, "field_bars.velocity_t")
        radius = 2.0 / 3.0 * (RO ** 3 - RI ** 3) / (RO ** 2 - RI ** 2)
        self.assertAlmostEqual(abs(turned) / (SPEED * radius / R_MEAN), 1.0, delta=0.1)
        self.assertLess(abs(clod.mean(steady, "field_middle.velocity_t")), 0.9 * abs(turned))
        self.assertLess(abs(clod.mean(steady, "field_whole.velocity_r")), 0.02 * SPEED)
        for part in ("reverse", "point-1", "point-3"):
            for row in clod.table(self.path(f"out/{part}.csv")):
                self.assertAlmostEqual(row["field_whole.density"] * volume / mass, 1.0, delta=1e-9)

    def test_other_tests(self):
        """Each of them, and every part of it."""
        region = "{box: {min: [-0.1 m, -0.1 m, -0.05 m], max: [0.1 m, 0.1 m, 0.3 m]}}"
        for name, source, *changes in (("jenike", "tests/restart/jenike.yaml"),
                                       ("uniaxial", "tests/faults/uniaxial.yaml"),
                                       ("wall_friction", "tests/cli/wall_friction.yaml", *SMALL_WALL)):
            self.write(clod.source(source), f"\nfields: {{whole: {{region: {region}}}}}\n", *changes)
            self.go(name)
            mass, volume = self.mass(), 0.2 * 0.2 * 0.35
            parts = {part["part"]: part["fields"]["whole"] for part in self.summary(name)["parts"]}
            self.assertGreater(len(parts), 1)
            for part, told in parts.items():
                self.assertAlmostEqual(told["density_kg_per_m3"]["mean"] * volume / mass, 1.0, delta=1e-9)
                self.assertLess(told["density_kg_per_m3"]["deviation"] * volume / mass, 1e-9)
                self.assertEqual(told["phase"], PHASES[part.split("-")[0]])
                for row in clod.table(self.path(f"{name}/{part}.csv")):
                    self.assertAlmostEqual(row["field_whole.density"] * volume / mass, 1.0, delta=1e-9)

    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(SMALL_RING, ring_fields(), PLAIN)
        self.go("one")
        self.go("two", "2")
        self.stop_after(60, "cut", "preshear.csv")
        self.go("cut")
        for part in ("preshear", "reverse", "point-1", "point-2"):
            whole = clod.read(self.path(f"one/{part}.csv"))
            self.assertIn(b"field_middle.contact_stress_tz [Pa]", whole)
            self.assertEqual(whole, clod.read(self.path(f"two/{part}.csv")), part)
            self.assertEqual(whole, clod.read(self.path(f"cut/{part}.csv")), part)
        self.write(SMALL_RING, "", PLAIN)
        self.check_fields_change_nothing("one")

    def check_fields_change_nothing(self, folder):
        self.go("without")
        self.assertEqual(clod.read(self.path(f"{folder}/points.csv")), clod.read(self.path("without/points.csv")))
        with_fields, without = (clod.table(self.path(f"{name}/preshear.csv")) for name in (folder, "without"))
        self.assertEqual([{name: row[name] for name in without[0]} for row in with_fields], without)


if __name__ == "__main__":
    clod.main()
