"""Files of the user in the results folder: never written over, never deleted."""

import fnmatch
import json
import os
import shutil
import signal
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
RING = clod.source("tests/restart/ring.yaml")
FREE = clod.source("tests/faults/free.yaml")
SHEAR_TEST = ["preshear", "reverse", "point-1", "point-2"]
JENIKE = clod.source("tests/restart/jenike.yaml")
UNIAXIAL = clod.source("tests/cli/uniaxial.yaml")
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
        done = clod.run("run", FREE, "-o", folder, "-t", "1", *options, cwd=self.folder)
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
        shutil.copy(FREE, self.path("own/case.yaml"))
        self.refused("own", "case.yaml")

    def begin(self, folder):
        """A ring shear test on its way, with a checkpoint."""
        process = clod.start("run", RING, "-o", folder, "-t", "1")
        self.addCleanup(process.kill)
        self.assertTrue(clod.wait_until(lambda: clod.checkpoints(folder, "preshear"), process))
        return process

    @clod.quick_only
    def test_replaced_while_it_runs(self):
        """A run whose folder is moved away stops, and what takes its place belongs to another."""
        out, moved = self.path("out"), self.path("moved")
        process = self.begin(out)
        os.rename(out, moved)
        done = clod.run("run", FREE, "-o", out, "-t", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        _, err = process.communicate(timeout=1000)
        self.assertEqual(process.returncode, 1, err)
        self.assertIn(f"The folder {out} was moved away, removed or replaced", err)
        self.run_into(self.path("alone"), FREE)
        self.assert_same_end(self.path("alone"), out, ["run"])
        os.rename(out, self.path("other"))
        os.rename(moved, out)  # as the message says
        self.run_into(out, RING)
        self.run_into(self.path("whole"), RING)
        self.assert_same_end(self.path("whole"), out, SHEAR_TEST)

    @clod.quick_only
    def test_lock_removed_while_it_runs(self):
        """Without its lock another run could begin in the folder: the first one stops."""
        out = self.path("out")
        process = self.begin(out)
        os.remove(os.path.join(out, LOCK))
        _, err = process.communicate(timeout=1000)
        self.assertEqual(process.returncode, 1, err)
        self.assertIn(f"(or the {LOCK} in it was)", err)

    def test_links_are_not_written_through(self):
        """Lock, log and tables that are links to a file of the user."""
        mine = self.path("mine")
        for name in (LOCK, "log.jsonl", "series.csv", "energy.csv", "summary.json.part"):
            out = self.path(f"out-{name}")
            os.mkdir(out)
            self.put(f"out-{name}", LOCK)
            with open(mine, "wb") as file:
                file.write(MINE)
            path = os.path.join(out, name)
            if name == LOCK:
                os.remove(path)
            os.symlink(mine, path)
            done = clod.run("run", FREE, "-o", out, "-t", "1")
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(f"Cannot write {path}", done.stderr)
            self.assertIn("clod does not write through symbolic links", done.stderr)
            self.assertEqual(clod.read(mine), MINE)

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
        fresh = self.run_into("out", FREE, "--fresh")
        self.assertEqual(fresh, self.run_into("other", FREE))

    def test_other_files_stay(self):
        """A folder with other files is fine, and --fresh leaves them."""
        mine = ["notes.txt", "my.hdf.series", "my_snap_000001.hdf", "points.csv.bak"]
        self.put("out", *mine)
        self.run_into("out", FREE)
        shutil.copy(self.path("out/restart_a.h5"), self.path("out/kept_a.h5"))
        kept = clod.read(self.path("out/kept_a.h5"))
        self.run_into("out", FREE, "--fresh")
        self.assertEqual(clod.read(self.path("out/kept_a.h5")), kept)
        for name in mine:
            self.assertEqual(clod.read(self.path(f"out/{name}")), MINE)

    def test_empty_folder(self):
        os.mkdir(self.path("empty"))
        self.run_into("empty", FREE)

    def test_copy_of_a_results_folder(self):
        self.run_into("out", FREE)
        shutil.copytree(self.path("out"), self.path("copy"))
        self.run_into("copy", FREE)  # with the lock: goes on, here to report only
        os.remove(self.path("copy/" + LOCK))
        self.refused("copy", "case-complete.yaml")

    def content(self, folder, *but):
        """Bytes and times of all files of a folder."""
        paths = {name: self.path(f"{folder}/{name}") for name in os.listdir(self.path(folder))}
        return {name: (clod.read(path), os.stat(path).st_mtime_ns)
                for name, path in paths.items() if name not in but}

    def test_refused_fresh(self):
        """A case that cannot begin does not cost the results that are there."""
        self.run_into("out", BOX, *clod.SHORT_BOX)
        before = self.content("out")
        narrow = ["domain.max=[12 mm, 40 mm, 200 mm]", "grains.0.count=3",
                  "grains.0.region.box.max=[12 mm, 30 mm, 60 mm]"]
        for text, *changes in (("of 100000 grains fit", "grains.0.count=100000"),
                               ("time.step", "time.step=1 s"),
                               ("the period along x", *narrow)):
            sets = [word for change in changes for word in ("--set", change)]
            done = clod.run("run", BOX, "-o", "out", "-t", "1", "--fresh", *sets,
                            cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(text, done.stderr)
            self.assertEqual(self.content("out"), before)

    def test_refused_fresh_of_a_ring(self):
        self.run_into("out", FREE)
        before = self.content("out")
        done = clod.run("run", RING, "-o", "out", "-t", "1", "--fresh", "--set",
                        "time.step=1 s", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(self.content("out"), before)

    def test_another_case(self):
        """The message tells whose run lies there, and the way that loses nothing first."""
        self.run_into("out", FREE)
        before = self.content("out", LOCK)
        done = clod.run("run", FREE, "-o", "out", "--set", "seed=8", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn('since the run ("Few grains for faults") in out was begun', done.stderr)
        self.assertLess(done.stderr.index("with -o"), done.stderr.index("--fresh"))
        self.assertEqual(self.content("out", LOCK), before)

    def write_grains(self, height):
        with open(self.path("grains.csv"), "w") as file:
            file.write(f"x [mm],y [mm],z [mm],r [mm]\n10,10,{height},3\n20,20,{height},3\n")

    def test_changed_grain_file(self):
        with open(BOX) as file:
            lines = file.read().splitlines()
        lines.remove("seed: 3")  # nothing is at random
        group = lines.index("grains:")
        self.assertTrue(lines[group + 4].startswith("    region:"))
        lines[group + 2:group + 5] = ["    file: grains.csv"]
        with open(self.path("pack.yaml"), "w") as file:
            file.write("\n".join(lines))
        self.write_grains(5)
        self.run_into("out", "pack.yaml")
        before = self.content("out", LOCK, "log.jsonl")
        self.run_into("out", "pack.yaml")  # unchanged: only reports
        self.run_into("out", self.path("out/case-complete.yaml"))
        self.write_grains(6)
        done = clod.run("run", "pack.yaml", "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, r"The file \S*grains\.csv has changed since the run "
                                      r'\("Small box with lid"\) in out was begun')
        os.remove(self.path("grains.csv"))
        done = clod.run("run", "pack.yaml", "-o", "out", "--fresh", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("grains.csv", done.stderr)
        after = self.content("out", LOCK, "log.jsonl")
        for name in before:
            if not name.startswith("case"):  # written again by the runs that went on
                self.assertEqual(after[name][0], before[name][0], name)
        self.write_grains(6)
        self.run_into("out", "pack.yaml", "--fresh")

    # Checkpoints that are gone.

    def lose(self, folder, pattern):
        """Remove the checkpoints of some parts."""
        lost = fnmatch.filter(os.listdir(self.path(folder)), pattern)
        self.assertGreater(len(lost), 0)
        for name in lost:
            os.remove(self.path(f"{folder}/{name}"))

    def refused_without(self, folder, case, table):
        before = self.content(folder, LOCK)
        done = clod.run("run", case, "-o", folder, "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for text in (f"{folder}/{table} holds results", "checkpoints", "gone", "-o", "--fresh"):
            self.assertIn(text, done.stderr)
        self.assertEqual(self.content(folder, LOCK), before)

    def stop(self, folder, case, part, number=signal.SIGTERM):
        """A run that is interrupted in a part."""
        process = clod.start("run", case, "-o", self.path(folder), "-t", "1")
        table = self.path(f"{folder}/{part}.csv")
        self.assertTrue(clod.wait_until(
            lambda: os.path.exists(table) and clod.read(table).count(b"\n") > 3, process))
        process.send_signal(number)
        process.communicate()
        self.assertNotEqual(process.returncode, 0)

    def test_interrupted_run_without_its_checkpoints(self):
        for number in (signal.SIGKILL,) if clod.SANITIZED else (signal.SIGTERM, signal.SIGKILL):
            folder = f"out{number}"
            self.stop(folder, BOX, "series", number)
            self.lose(folder, "restart*")
            self.refused_without(folder, BOX, "series.csv")
            self.run_into(folder, BOX, "--fresh", "--set", "stages=[{name: a, duration: 1 ms}]")

    @clod.quick_only
    def test_interrupted_tests_without_their_checkpoints(self):
        for case, part in ((RING, "point-1"), (JENIKE, "preshear"), (UNIAXIAL, "stress-1")):
            name = os.path.splitext(os.path.basename(case))[0]
            self.stop(name, case, part)
            shutil.copytree(self.path(name), self.path(name + "-all"))
            self.lose(name, f"restart-{part}_*")  # of one part only
            self.refused_without(name, case, f"{part}.csv")
            self.lose(name + "-all", "restart*")
            first = sorted(table for table in os.listdir(self.path(name + "-all"))
                           if table.endswith(".csv"))
            done = clod.run("run", case, "-o", name + "-all", "-t", "1", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertTrue(any(f"/{table} holds" in done.stderr for table in first))

    def test_complete_run_without_its_checkpoints(self):
        """Its table is told again, and nothing is run."""
        cases = [FREE] if clod.SANITIZED else [FREE, RING]
        for case in cases:
            name = os.path.splitext(os.path.basename(case))[0]
            table = clod.run("run", case, "-o", name, "-t", "1", cwd=self.folder).stdout
            self.lose(name, "restart*")
            before = self.content(name, LOCK)
            done = clod.run("run", case, "-o", name, "-t", "1", cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (0, table), done.stderr)
            self.assertIn("the checkpoints are gone, but this run is complete", done.stderr)
            self.assertEqual(self.content(name, LOCK), before)
            done = clod.run("run", case, "-o", name, "--set", "seed=99", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("The case has changed", done.stderr)
            os.remove(self.path(f"{name}/report.txt"))
            done = clod.run("run", case, "-o", name, "-t", "1", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)

    def test_only_a_summary_is_left(self):
        self.run_into("out", FREE)
        self.lose("out", "restart*")
        self.lose("out", "report.txt")
        self.lose("out", "series.csv")
        self.lose("out", "snap_*")
        self.refused_without("out", FREE, "summary.json")

    def test_killed_before_the_first_row(self):
        """A table without rows has nothing to lose."""
        self.run_into("out", FREE)
        header = clod.read(self.path("out/series.csv")).split(b"\n")[0] + b"\n"
        for name in os.listdir(self.path("out")):
            if name not in (LOCK, "case.yaml", "case-complete.yaml", "log.jsonl"):
                os.remove(self.path(f"out/{name}"))
        with open(self.path("out/series.csv"), "wb") as file:
            file.write(header)
        self.run_into("out", FREE)

    def times(self, folder):
        with open(self.path(f"{folder}/run.hdf.series")) as file:
            return [entry["time"] for entry in json.load(file)["files"]]

    def test_other_snapshots_on_the_way(self):
        """Keys of output that change no bit may change: the run goes on, to the same rows."""
        self.run_into("whole", BOX, *clod.SHORT_BOX)
        process = clod.start("run", BOX, "-o", self.path("out"), "-t", "1", *clod.SHORT_BOX, "--set",
                             "output.snapshot_interval=10 s", "--set", "output.contacts=false")
        self.assertTrue(clod.wait_until(lambda: any(
            event.get("to") == "compress" for event in clod.log(self.path("out"))), process))
        process.send_signal(signal.SIGTERM)
        process.communicate()
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        stopped = clod.log(self.path("out"))[-1]["time_s"]
        self.run_into("out", BOX, *clod.SHORT_BOX, "--set", "output.checkpoint_interval=1 s", "--set",
                      "output.snapshot_interval=10 ms")
        self.assertEqual(clod.read(self.path("out/series.csv")),
                         clod.read(self.path("whole/series.csv")))
        self.assertEqual(clod.without_clock(clod.read(self.path("out/summary.json"))),
                         clod.without_clock(clod.read(self.path("whole/summary.json"))))
        times = [time for time in self.times("out") if time > stopped]
        self.assertGreaterEqual(len(times), int((clod.BOX_END - stopped) / 10e-3) - 1)
        for one, other in zip([stopped] + times, times):
            self.assertLess(other - one, 11e-3)  # and a row of the series, 0.5 ms
        with open(self.path("out/case-complete.yaml")) as file:
            self.assertIn("snapshot_interval: 0.01 s", file.read())

    def test_another_series_is_another_case(self):
        self.run_into("out", FREE)
        done = clod.run("run", FREE, "-o", "out", "--set", "output.series_interval=2 ms",
                        cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("The case has changed", done.stderr)


if __name__ == "__main__":
    clod.main()
