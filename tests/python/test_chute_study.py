"""Tables and figure of cases/transfer-chute-study, from runs that are made up."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py
except ImportError:
    h5py = None

HERE = os.path.dirname(os.path.abspath(__file__))
STUDY = os.path.join(HERE, "..", "..", "cases", "transfer-chute-study")
CASE = """walls:
  feed:
    shapes:
      - belt:
          from: [-1 m, 0 m, 1.5 m]
          speed: 1.6 m/s
          pulley: {radius: 0.2 m}
"""
# id: x on the belt at 1 s, x and z a quarter of a second later, grains that it touches
GRAINS = {1: (-0.05, (-0.1, 1.48), []),    # alone, at the pulley: carried round
          2: (-0.06, (0.9, 0.9), [3]),     # gone with the stream
          3: (-0.07, (-0.14, 1.443), [2]),  # carried round
          4: (-0.40, (-0.0, 1.5), [])}     # not yet beyond the pulley's top: not followed


def call(name, *arguments):
    return subprocess.run([sys.executable, os.path.join(STUDY, name), *arguments], text=True,
                          capture_output=True)


def write_run(folder):
    """Two snapshots, 1 s and 1.25 s, with contacts."""
    with open(os.path.join(folder, "case-complete.yaml"), "w") as file:
        file.write(CASE)
    with open(os.path.join(folder, "run.hdf.series"), "w") as file:
        json.dump({"files": [{"time": 1.0}, {"time": 1.25}]}, file)
    ids = list(GRAINS)
    places = ([[GRAINS[k][0], 0.0, 1.503] for k in ids],
              [[GRAINS[k][1][0], 0.0, GRAINS[k][1][1]] for k in ids])
    for number in (0, 1):
        with h5py.File(os.path.join(folder, f"snap_{number:06d}.hdf"), "w") as file:
            file["VTKHDF/Points"] = places[number]
            file["VTKHDF/PointData/id"] = ids
            file["VTKHDF/PointData/velocity"] = [[1.6, 0.0, 0.0]] * len(ids)
        with h5py.File(os.path.join(folder, f"contacts_{number:06d}.hdf"), "w") as file:
            file["VTKHDF/CellData/id"] = [[k, j] for k in ids for j in GRAINS[k][2] if k < j]


class ChuteStudy(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    @unittest.skipIf(h5py is None, "no h5py")
    def test_carry_back_counts_by_grains_touched(self):
        write_run(self.folder)
        done = call("carry-back", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = {row.split(" | ")[0].strip("| "): row.strip("| ").split(" | ")[1:]
                for row in done.stdout.splitlines()[2:]}
        self.assertEqual(rows["0"], ["50.0", "1", "100.0"])
        self.assertEqual(rows["1"], ["50.0", "2", "50.0"])
        self.assertEqual(rows["all"], ["100", "3", "66.7"])

    def test_carry_back_of_no_folder(self):
        done = call("carry-back", self.folder + "/nothing")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no such folder", done.stderr)

    @unittest.skipIf(h5py is None, "no h5py")
    def test_carry_back_needs_contacts(self):
        done = call("carry-back", self.folder)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("output.contacts", done.stderr)

    def write_clumps(self, name, masses):
        """A run with clumps of 2 and 4 to 5 grains in the chute [kg]."""
        sizes = [{"from": low, "to": high, "number": 1.0, "mass_kg": mass}
                 for (low, high), mass in zip(((2, 2), (4, 5)), masses)]
        os.mkdir(os.path.join(self.folder, name))
        with open(os.path.join(self.folder, name, "summary.json"), "w") as file:
            json.dump({"clumps": {"counts": {"chute": {"sizes": sizes}, "flight": {"sizes": sizes}}}}, file)

    def test_figure_and_sizes_have_means_of_packings(self):
        self.write_clumps("wet-seed1", (0.002, 0.010))
        self.write_clumps("wet-seed2", (0.004, 0.010))
        done = call("run", "--folder", self.folder, "--sizes", "wet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| 2 grains | 1 +- 0 | 3 +- 1 |", done.stdout)
        target = os.path.join(self.folder, "sizes.svg")
        done = call("run", "--folder", self.folder, "--figure", target, "wet")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(target) as file:
            text = file.read()
        self.assertIn("wet (2)", text)  # two packings
        for label in ("In the chute", "In flight", ">2<", ">4-5<"):
            self.assertIn(label, text)

    def test_lumps_are_falls_of_the_mass_in_the_chute(self):
        """The mass rises to 1 kg, falls to 0.4 in two steps, rises again, and falls by too little."""
        self.write_clumps("wet-seed1", (0.0, 0.0))
        with open(os.path.join(self.folder, "wet-seed1", "series.csv"), "w") as file:
            file.write("time [s],gauge_chute.mass [kg]\n")
            for time, mass in ((0, 0), (1, 1.0), (2, 0.7), (3, 0.4), (4, 0.9), (5, 0.75), (6, 0.8)):
                file.write(f"{time},{mass}\n")
        done = call("run", "--folder", self.folder, "--lumps", "wet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines()[2:], ["| wet-seed1 | 1.00 | 3.00 | 1.00 | 0.40 |"])

    def test_figure_of_nothing_is_refused(self):
        target = os.path.join(self.folder, "sizes.svg")
        done = call("run", "--folder", self.folder, "--figure", target, "wet")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("no run of wet has ended", done.stderr)
        self.assertFalse(os.path.exists(target))


if __name__ == "__main__":
    unittest.main()
