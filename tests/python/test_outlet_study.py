"""cases/lab-to-outlet/run with a clod that only writes down what it is asked, and cases/inside-density with lattices."""
import os
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py
    import numpy as np
except ImportError:
    h5py = None

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.join(HERE, "..", "..", "cases")
STUDY = os.path.join(CASES, "lab-to-outlet")
TRUTH = os.path.join(STUDY, "laboratory", "truth.yaml")


class Study(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.clod = os.path.join(self.folder.name, "clod")
        with open(self.clod, "w") as file:
            file.write(f'#!/bin/sh\necho "$@" >> {self.folder.name}/asked\n')
        os.chmod(self.clod, 0o755)

    def tearDown(self):
        self.folder.cleanup()

    def call(self, *arguments):
        return subprocess.run([sys.executable, os.path.join(STUDY, "run"), "--clod", self.clod, "--folder",
                               os.path.join(self.folder.name, "out"), "--card", TRUTH, *arguments],
                              text=True, capture_output=True)

    def asked(self, *arguments):
        done = self.call(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder.name, "asked")) as file:
            return file.read().splitlines()

    def test_bad_numbers_are_refused(self):
        for arguments, text in ((["--critical", "nan"], "--critical nan"), (["--critical", "-5"], "--critical -5"),
                                (["--critical", "101"], "at most 100 mm"), ([], "which critical width"),
                                (["--critical", "44", "--periods", "0"], "--periods 0"),
                                (["--critical", "44", "--cone", "--periods", "4"], "a cone has none"),
                                (["--critical", "44", "--height", "60"], "--height 60"),
                                (["--critical", "98", "--cone", "--height", "nan"], "--height nan"),
                                (["--critical", "98", "--cone", "--height", "198"], "at most 197.5 mm"),
                                (["--critical", "44", "--card", "none.yaml"], "none.yaml: there is no such file")):
            done = self.call(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(text, done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder.name, "asked")))

    def test_a_folder_is_of_one_outlet_and_one_card(self):
        self.assertEqual(self.call("--critical", "43.5").returncode, 0)
        self.assertEqual(self.call("--critical", "43.5").returncode, 0)  # goes on
        self.assertEqual(self.call("--critical", "98.1", "--cone").returncode, 0)  # beside it
        other = os.path.join(self.folder.name, "other.yaml")
        with open(TRUTH) as file, open(other, "w") as copy:
            copy.write(file.read() + "# another\n")
        for words in (["--critical", "43.6"], ["--critical", "43.5", "--card", other]):
            done = self.call(*words)
            self.assertEqual(done.returncode, 2)
            self.assertIn("its runs are of another critical width or card", done.stderr)

    def test_runs_of_each_shape(self):
        for arguments, count in ((["--critical", "43.5"], 15), (["--critical", "43.5", "--periods", "4"], 9),
                                 (["--critical", "98.1", "--cone"], 24),
                                 (["--critical", "98.1", "--cone", "--height", "60"], 18)):
            asked = os.path.join(self.folder.name, "asked")
            if os.path.exists(asked):
                os.remove(asked)
            names = [re.search(r"-o (\S+)", line).group(1) for line in self.asked(*arguments)]
            self.assertEqual((len(names), len(set(names))), (count, count), arguments)

    def test_specimens_of_the_laboratory(self):
        """As the study's README has them sheared at 0.3 kPa by hand."""
        subprocess.run([sys.executable, os.path.join(STUDY, "laboratory", "run"), "--clod", self.clod, "--folder",
                        os.path.join(self.folder.name, "out"), "--seed", "104", "--specimens", "6", "--low"],
                       capture_output=True, check=False)  # this clod writes no points
        with open(os.path.join(self.folder.name, "asked")) as file:
            asked = {re.search(r"-o \S+/lab-(\S+)", line).group(1): line for line in file}
        self.assertEqual(sorted(asked), ["0.3", "0.6", "1.2", "2.4"])
        for line in asked.values():
            self.assertIn(f"--set include={os.path.normpath(TRUTH)} --set seed=104 --set ring_shear.seeds=6 ", line)
        self.assertIn("--set ring_shear.preshear_stress=0.3 kPa --set ring_shear.shear_stresses=[0.12 kPa, 0.165 kPa, 0.21 kPa] "
                      "--set ring_shear.speed=7.5 mm/s --set ring_shear.lid_mass=0.05 kg\n", asked["0.3"])
        self.assertNotIn("speed", asked["0.6"])

    def test_the_critical_cone_is_that_of_the_case(self):
        with open(os.path.join(STUDY, "cone.yaml")) as file:
            case = file.read()
        line = next(line for line in self.asked("--critical", "98.1", "--cone") if "cone-1-seed1 " in line)
        for key in ("count", "foot_radius", "top_radius", "outer_radius"):
            self.assertEqual(re.search(rf"{key}=([\d.]+)", line).group(1), re.search(rf"{key}: ([\d.]+)", case).group(1))

    def test_a_long_slot_is_longer_everywhere(self):
        line = next(line for line in self.asked("--critical", "40", "--periods", "3") if "outlet-0.5-periods3-seed2 " in line)
        for change in ("domain.max=[150 mm, 90 mm, 460 mm]", "grains.0.count=8400", "max=[65 mm, 90 mm, 450 mm]",
                       "center=[0 mm, 45 mm, -5.6 mm]", "size=[130 mm, 110 mm, 10 mm]", "0.mesh.move=[10 mm, 0 mm, 0 mm]",
                       "1.mesh.move=[-10 mm, 90 mm, 0 mm]", "seed=2"):
            self.assertIn(change, line)
        with open(os.path.join(self.folder.name, "out", "layout-periods3", "side.obj")) as file:
            vertices = [line.split()[1:] for line in file if line.startswith("v ")]
        self.assertEqual({float(y) for _, y, _ in vertices}, {-10.0, 100.0})
        self.assertEqual({float(x) for x, _, _ in vertices}, {0.0, 50.0})


@unittest.skipUnless(h5py, "needs h5py")
class Density(unittest.TestCase):
    """Grains of 1 mm on a lattice of 2 mm: a sixth of pi of 2500 kg/m3, 1309 kg/m3, wherever there are some."""

    def tell(self, shape, keep, *numbers):
        line = np.arange(-99.0, 100.0, 2.0)
        x, y, z = (a.ravel() for a in np.meshgrid(line, line, np.arange(1.0, 160.0, 2.0), indexing="ij"))
        kept = keep(x, y, z)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "snap.hdf")
            with h5py.File(path, "w") as file:
                data = file.create_group("VTKHDF")
                data["Points"] = 1e-3 * np.stack([x[kept], y[kept], z[kept]], axis=1)
                data.create_group("PointData")["radius"] = np.full(kept.sum(), 1e-3)
            done = subprocess.run([sys.executable, os.path.join(CASES, "inside-density"), shape, *map(str, numbers), path],
                                  text=True, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [float(number) for number in re.findall(r"[\d.]+", done.stdout.partition(": ")[2])]

    def test_a_ring(self):
        """Nothing beside the walls, within a diameter: it must not count."""
        found = self.tell("ring", lambda x, y, z: (np.hypot(x, y) > 52) & (np.hypot(x, y) < 88) & (z < 60), 50, 90, 4, 2500)
        self.assertAlmostEqual(found[0] / 1309, 1, delta=0.01)

    def test_a_cone_and_a_slot(self):
        """Filled to 90 mm: the fourth layer is empty."""
        widen = 60 / 97.5
        found = self.tell("cone", lambda x, y, z: (np.hypot(x, y) < 36 + widen * z) & (z < 90), 40, 2500)
        for layer in found[:3]:
            self.assertAlmostEqual(layer / 1309, 1, delta=0.03)
        self.assertEqual(found[3], 0)
        self.assertEqual(found[-2:], [89, 89])
        found = self.tell("slot", lambda x, y, z: (abs(x) < 16 + 0.577 * z) & (y > -60) & (y < 60) & (z < 90), 20, 2500)
        for layer in found[:3]:
            self.assertAlmostEqual(layer / 1309, 1, delta=0.06)  # a few grains across

    def test_wrong_words_are_told(self):
        for words in ([], ["sphere", "1", "2", "x"], ["cone", "24", "2500"], ["ring", "50", "nan", "4", "2500", "x"]):
            done = subprocess.run([sys.executable, os.path.join(CASES, "inside-density"), *words], text=True, capture_output=True)
            self.assertEqual(done.returncode, 2)
            self.assertIn("usage: cases/inside-density", done.stderr)

    def test_a_file_that_is_no_snapshot_is_told(self):
        done = subprocess.run([sys.executable, os.path.join(CASES, "inside-density"), "cone", "24.5", "2500", TRUTH],
                              text=True, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("truth.yaml cannot be read", done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_a_ring_that_is_all_walls_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "snap.hdf")
            with h5py.File(path, "w") as file:
                data = file.create_group("VTKHDF")
                data["Points"] = [[0.051, 0.0, 0.0], [0.0, 0.052, 0.1]]
                data.create_group("PointData")["radius"] = [1e-3, 1e-3]
            done = subprocess.run([sys.executable, os.path.join(CASES, "inside-density"), "ring", "50", "56", "4", "2500", path],
                                  text=True, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("nothing of its bed is 3.0 mm from all walls", done.stderr)


if __name__ == "__main__":
    unittest.main()
