"""The wall friction test against its own contacts, which h5py reads of the last checkpoint and the snapshots.

On a flat plate every contact slips and bears its Coulomb limit mu N. So the torque on the plate of a ring is the
sum of mu N r over its contacts, each N worked out here by the contact law of the case; and a constant pull f
of N contacts raises the shear stress of a straight plate by mu N f/A, if the Coulomb limit counts the pull.
"""

import json
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "report"))
import pages  # noqa: E402,F401
from pages import clod  # noqa: E402

try:
    import h5py
    import numpy
except ImportError:
    h5py = None

FRICTION = 0.2       # of the plate in both cases
PLATE, SHEAR = 0, 4  # first wall of the cell; phase of the series
PULL = 0.1           # N
AREA = math.pi * 0.030 ** 2


@unittest.skipIf(h5py is None, "no h5py")
class Lever(clod.TesterCase):
    """One specimen in a ring whose load lies 12 % further out than an even one."""

    CASE, POINTS = clod.source("tests/cli/wall_friction_ring.yaml"), "wall_friction.csv"
    OPTIONS = ("-t", "1", "--set", "seed=4", "--set", "wall_friction.seeds=1")
    K2, EXPONENT, INNER, OUTER = 1e8, 1.5, 0.020, 0.040  # of CASE

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        files = [h5py.File(os.path.join(cls.out, f"restart-wall_{letter}.h5")) for letter in "ab"]
        cls.last = max(files, key=lambda file: file["state/step"][0])
        cls.addClassCleanup(lambda: [file.close() for file in files])

    def contacts(self):
        """Force [N] and radius [m] of each contact with the plate: f = k2 (overlap^n - plastic overlap^n)."""
        walls = int(self.last["state/wall_contact_count"][0])
        partners = self.last["contacts/partners"][-walls:].astype(int)
        of_plate = partners[:, 1] == PLATE
        row = {number: k for k, number in enumerate(self.last["grains/id"][:])}
        rows = [row[number] for number in partners[of_plate, 0]]
        place = self.last["grains/position"][:][rows]
        overlap = self.last["grains/radius"][:][rows] - place[:, 2]
        plastic = self.last["contacts/plastic"][-walls:][of_plate]
        return self.K2 * (overlap ** self.EXPONENT - plastic), numpy.hypot(place[:, 0], place[:, 1])

    def test_shear_stress_is_the_torque_of_its_contacts(self):
        row = self.series["wall"][-1]
        self.assertEqual(row["phase"], SHEAR)
        self.assertAlmostEqual(row["time"], self.last["state/time"][0], delta=1e-9)
        area = math.pi * (self.OUTER ** 2 - self.INNER ** 2)
        mean_radius = 2 / 3 * (self.OUTER ** 3 - self.INNER ** 3) / (self.OUTER ** 2 - self.INNER ** 2)
        force, radius = self.contacts()
        self.assertGreater(len(force), 50)
        self.assertAlmostEqual(force.sum() / area / row["normal_stress"], 1.0, delta=1e-3)
        torque = FRICTION * (force * radius).sum()
        self.assertAlmostEqual(torque / (area * mean_radius) / row["shear_stress"], 1.0, delta=1e-3)
        # not so by an even load: what is tested is the lever
        self.assertGreater((force * radius).sum() / force.sum() / mean_radius, 1.1)
        self.assertAlmostEqual(self.points[-1]["tau_w"] / row["shear_stress"], 1.0, delta=2e-3)


@unittest.skipIf(h5py is None, "no h5py")
class Adhesion(clod.Case):
    """law eepa with a constant pull of grains and plate, whatever the overlap; a straight cell."""

    def sheared(self, coulomb):
        """The points, and how many grains touch the plate at the end of each of them."""
        done = clod.run("run", clod.source("tests/cli/wall_friction.yaml"), "-o", self.path(coulomb), "-t", "1",
                        "--set", "contacts.default.law=eepa", "--set", f"contacts.ore-plate.coulomb={coulomb}",
                        "--set", f"contacts.ore-plate.pull_off_force={PULL} N")
        self.assertEqual(done.returncode, 0, done.stderr)
        ends = [event["time_s"] for event in clod.log(self.path(coulomb))
                if event["event"] == "phase" and event["part"] == "wall" and event["from"] == "shear"]
        with open(self.path(f"{coulomb}/wall.hdf.series")) as file:
            name = {snapshot["time"]: snapshot["name"] for snapshot in json.load(file)["files"]}
        touch = []
        for end in ends:
            with h5py.File(self.path(f"{coulomb}/{name[end]}")) as file:
                grains = file["VTKHDF"]
                touch.append(int((grains["Points"][:, 2] < grains["PointData/radius"][:]).sum()))
        return clod.table(self.path(f"{coulomb}/wall_friction.csv")), touch

    def test_the_pull_of_the_contacts_is_wall_adhesion(self):
        """tau_w = mu (sigma_w + N f/A); at the largest stress the last contacts slip after 1 % less."""
        points, touch = self.sheared("adhesive")
        self.assertEqual([point["wall_stress"] for point in points], [20e3, 10e3, 5e3])
        for point, count, tolerance in zip(points, touch, (0.015, 0.005, 0.005)):
            pull = count * PULL / AREA
            self.assertGreater(pull, 2e3)
            self.assertAlmostEqual(point["tau_w"] / (FRICTION * (point["sigma_w"] + pull)), 1.0, delta=tolerance)
        with open(self.path("adhesive/summary.json")) as file:
            adhesion = json.load(file)["wall_locus"]["tau_ad_Pa"]["value"]
        self.assertAlmostEqual(adhesion / (FRICTION * touch[-1] * PULL / AREA), 1.0, delta=0.05)

    def test_other_limits_have_no_wall_adhesion(self):
        """The forces add up to the load, with or without a pull, and friction goes with the force; few contacts pull."""
        for coulomb in ("force", "paper"):
            points, _ = self.sheared(coulomb)
            for point in points:
                slips = point["tau_w"] / (FRICTION * point["sigma_w"])
                self.assertGreater(slips, 0.997)
                self.assertLess(slips, 1.02)  # adhesive: 1.13 to 1.58
            with open(self.path(f"{coulomb}/summary.json")) as file:
                self.assertLess(abs(json.load(file)["wall_locus"]["tau_ad_Pa"]["value"]), 20.0)  # adhesive: 580 Pa


if __name__ == "__main__":
    clod.main()
