"""Files of the grids and mixing indices of tests: for each part, the same bytes on threads and when a run was cut off,
taken over by another run, and what they cost. Their numbers: tests/python/test_part_measures.py."""

import glob
import json
import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = "{box: {min: [-60 mm, -60 mm, -20 mm], max: [60 mm, 60 mm, 120 mm]}}"  # 12 x 12 x 14 cells of 10 mm
GRID = f"""
fields:
  grid: {{region: {BOX}, cell: 10 mm, width: 20 mm, interval: 1 ms, frames: true}}
mixing:
  size: {{region: {BOX}, cell: 10 mm, above: 2.8 mm}}
"""
POINTS = 12 * 12 * 14
RING = "tests/restart/ring.yaml"
PARTS = ("preshear", "reverse", "point-1", "point-2")
PLAIN = (", energy: true", "")  # RING without its ledger, which takes most of the time
SMALL_WALL = (("shear_min: 2.5 mm", "shear_min: 1 mm"), ("shear_max: 5 mm", "shear_max: 1.2 mm"),
              ("block_displacement: 0.5 mm", "block_displacement: 0.3 mm\n  steady_blocks: 3"),
              ("grain_count: 400", "grain_count: 60"), ("outer_radius: 30 mm", "outer_radius: 14 mm"))


class GridsOfTests(clod.Case):

    @classmethod
    def setUpClass(cls):
        """An undisturbed run to compare with, in a folder that outlives the tests."""
        cls.whole = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, cls.whole)
        with open(clod.source(RING)) as file:
            text = file.read().replace(*PLAIN) + GRID
        with open(os.path.join(cls.whole, "case.yaml"), "w") as file:
            file.write(text)
        cls.one = os.path.join(cls.whole, "one")
        done = clod.run("run", os.path.join(cls.whole, "case.yaml"), "-o", cls.one, "-t", "1")
        assert done.returncode == 0, done.stderr

    def write(self, source, measures, *changes):
        with open(clod.source(source)) as file:
            text = file.read()
        for before, after in changes:
            self.assertIn(before, text)
            text = text.replace(before, after)
        with open(self.path("case.yaml"), "w") as file:
            file.write(text + measures)

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(RING, GRID, PLAIN)
        for part in PARTS:
            with open(os.path.join(self.one, f"{part}_field_grid.hdf.series")) as file:
                listed = [one["name"] for one in json.load(file)["files"]]
            snapshots = glob.glob(os.path.join(self.one, f"{part}_snap_*.hdf"))
            self.assertEqual(listed, [f"{part}_field_grid-{k:06d}.hdf" for k in range(len(snapshots))])
            self.assertIn(b"mixing_size.lacey [1]", clod.read(os.path.join(self.one, f"{part}.csv")))
        self.go("two", "2")
        self.assert_same_end(self.one, self.path("two"), PARTS)
        for rows, table in ((30, "preshear.csv"), (120, "preshear.csv"), (10, "point-1.csv")):
            self.stop_after(rows, "cut", table)
        self.go("cut")
        self.assert_same_end(self.one, self.path("cut"), PARTS)

    @clod.quick_only
    def test_behind_the_last_checkpoint(self):
        """As when a run was killed: what it had written after its checkpoint goes, and comes again."""
        self.write(RING, GRID, PLAIN)
        self.stop_after(40, "cut", "preshear.csv")
        kept = [(path, clod.read(path)) for path in clod.checkpoints(self.path("cut"), "preshear")]
        self.stop_after(140, "cut", "preshear.csv")
        for path, content in kept:
            with open(path, "wb") as file:
                file.write(content)
        self.go("cut")
        self.assert_same_end(self.one, self.path("cut"), PARTS)

    def test_a_file_that_was_lost_comes_again(self):
        """Killed when a part was finished and its file not yet there."""
        self.write(RING, GRID, PLAIN)
        shutil.copytree(self.one, self.path("one"))
        before = clod.read(self.path("one/reverse_field_grid.hdf"))
        for name in ("reverse_field_grid.hdf", "report.txt"):
            os.remove(self.path("one/" + name))
        self.go("one")
        self.assertEqual(clod.read(self.path("one/reverse_field_grid.hdf")), before)

    def test_taken_over(self):
        """Grids of preparations come with them; another grid or index is another specimen."""
        self.write(RING, GRID, PLAIN, ("[0.3 kPa, 0.6 kPa]", "[0.4 kPa, 0.7 kPa]"))
        self.go("alone")
        self.go("taken", "1", "--from", self.one)
        for part in PARTS:
            for name in (f"{part}.csv", f"{part}_field_grid.hdf"):
                self.assertEqual(clod.read(self.path("taken/" + name)), clod.read(self.path("alone/" + name)), name)
        self.write(RING, GRID.replace("above: 2.8 mm", "above: 2.7 mm"), PLAIN)
        done = clod.run("run", self.path("case.yaml"), "-o", self.path("refused"), "--from", self.one)
        self.assertEqual(done.returncode, 2)
        self.assertIn("mixing.size.above", done.stderr)

    def test_other_tests(self):
        """Each of them, every part of it, with the phase that it ended with; --fresh removes the files."""
        phases = {"preshear": "preshear", "reverse": "reverse", "point": "shear", "fill": "consolidate",
                  "stress": "crush", "wall": "shear"}
        for name, source, *changes in (("jenike", "tests/restart/jenike.yaml"),
                                       ("uniaxial", "tests/faults/uniaxial.yaml"),
                                       ("wall_friction", "tests/cli/wall_friction.yaml", *SMALL_WALL)):
            self.write(source, GRID, *changes)
            self.go(name)
            parts = self.summary(name)["parts"]
            self.assertGreater(len(parts), 1)
            for part in parts:
                told = part["fields"]["grid"]
                self.assertEqual(told["file"], part["part"] + "_field_grid.hdf")
                self.assertGreater(told["samples"], 0)
                self.assertGreater(told["used_cells"], 100)
                if part["part"] != "fill":
                    self.assertEqual(told["phase"], phases[part["part"].split("-")[0]])
                self.assertTrue(os.path.exists(self.path(f"{name}/{told['file']}")))
                self.assertIn("mixing_size.share", clod.table(self.path(f"{name}/{part['part']}.csv"))[0])
            self.write(source, "", *changes)
            self.go(name, "1", "--fresh")
            self.assertEqual(glob.glob(self.path(f"{name}/*field*")), [])

    def test_what_they_cost(self):
        """Sums of each cell: 26 numbers in every part and checkpoint; 832 bytes while a sample is taken."""
        self.write(RING, "")
        without = json.loads(clod.run("check", self.path("case.yaml"), "--json", "-t", "1").stdout)
        self.write(RING, GRID)
        told = json.loads(clod.run("check", self.path("case.yaml"), "--json", "-t", "1").stdout)
        sums = POINTS * 26 * 8
        self.assertEqual(told["fields_memory_bytes"], len(PARTS) * sums + POINTS * 832)
        self.assertEqual(told["disk_checkpoints_bytes"] - without["disk_checkpoints_bytes"], 3 * len(PARTS) * sums)
        self.assertGreater(told["disk_snapshots_bytes"], without["disk_snapshots_bytes"] + len(PARTS) * POINTS * 8)
        self.assertGreater(told["fields_clock_s"], 0.0)

    def test_warned_of_one_kind_and_a_narrow_kernel(self):
        self.write(RING, GRID.replace("2.8 mm", "3.2 mm").replace("cell: 10 mm, width: 20 mm", "cell: 3 mm, width: 5 mm"))
        text = " ".join(clod.run("check", self.path("case.yaml")).stdout.split())
        self.assertIn("mixing.size.above: no grains have a radius above 0.0032 m", text)
        self.assertIn("fields.grid.width 0.005 m is less than the largest grain", text)


if __name__ == "__main__":
    clod.main()
