"""Files of the user in the results folder: never written over, never deleted."""

import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
RING = clod.source("tests/restart/ring.yaml")
LOCK = ".clod-lock"
MINE = b"mine, \x00 not a result\n"


class Folder(clod.Case):

    def put(self, folder, *names):
        os.makedirs(self.path(folder), exist_ok=True)
        for name in names:
            with open(self.path(f"{folder}/{name}"), "wb") as file:
                file.write(MINE)

    def run_into(self, folder, case, *options):
        done = clod.run("run", case, "-o", folder, "-t", "1", *options, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return set(os.listdir(self.path(folder)))

    def refused(self, folder, name, *options):
        """Exit status 2, the name of the file, and nothing has changed or come."""
        before = {file: clod.read(self.path(f"{folder}/{file}"))
                  for file in os.listdir(self.path(folder))}
        done = clod.run("run", BOX, "-o", folder, "-t", "1", *options, cwd=self.folder)
        self.assertEqual(done.returncode, 2, f"{name}: {done.stderr}")
        self.assertEqual(done.stdout, "")
        self.assertIn(f"{folder}/{name} is in the way", done.stderr)
        self.assertIn("-o", done.stderr)
        self.assertEqual(set(os.listdir(self.path(folder))), set(before))
        for file, content in before.items():
            self.assertEqual(clod.read(self.path(f"{folder}/{file}")), content, file)

    def test_files_in_the_way(self):
        for name in ("case.yaml", "case-complete.yaml", "summary.json", "points.csv",
                     "series.csv", "log.jsonl", "snap_000000.hdf"):
            self.put(name, name, "notes.txt")
            self.refused(name, name)
            self.refused(name, name, "--fresh")

    def test_a_folder_that_holds_its_own_case(self):
        os.mkdir(self.path("own"))
        shutil.copy(BOX, self.path("own/case.yaml"))
        self.refused("own", "case.yaml")

    @clod.quick_only
    def test_whatever_a_run_writes(self):
        """Each file that a run leaves protects a folder of the user, and --fresh removes it."""
        names = self.run_into("out", RING, "--set", "ring_shear.seeds=2", "--set",
                              "output.snapshot_interval=0 s") - {LOCK}
        self.assertIn("seed-7-point-1.csv", names)
        for name in names:
            self.put("user", name)
            self.refused("user", name, "--fresh")
            os.remove(self.path(f"user/{name}"))
        fresh = self.run_into("out", BOX, "--fresh")
        self.assertEqual(fresh, self.run_into("other", BOX))

    def test_other_files_stay(self):
        """A folder with other files is fine, and --fresh leaves them."""
        mine = ["notes.txt", "my.hdf.series", "my_snap_000001.hdf", "points.csv.bak"]
        self.put("out", *mine)
        self.run_into("out", BOX)
        shutil.copy(self.path("out/restart_a.h5"), self.path("out/kept_a.h5"))
        kept = clod.read(self.path("out/kept_a.h5"))
        self.run_into("out", BOX, "--fresh")
        self.assertEqual(clod.read(self.path("out/kept_a.h5")), kept)
        for name in mine:
            self.assertEqual(clod.read(self.path(f"out/{name}")), MINE)

    def test_empty_folder(self):
        os.mkdir(self.path("empty"))
        self.run_into("empty", BOX)

    def test_copy_of_a_results_folder(self):
        self.run_into("out", BOX)
        shutil.copytree(self.path("out"), self.path("copy"))
        self.run_into("copy", BOX)  # with the lock: goes on, here to report only
        os.remove(self.path("copy/" + LOCK))
        self.refused("copy", "case-complete.yaml")


if __name__ == "__main__":
    clod.main()
