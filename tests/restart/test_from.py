"""clod run --from: a run that begins with another run's grains, histories and walls."""

import errno
import json
import os
import re
import shutil
import signal
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
RING = clod.source("tests/restart/ring.yaml")
SMALL = clod.source("tests/faults/ring.yaml")
UNIAXIAL = clod.source("tests/faults/uniaxial.yaml")
SETTLE = "{name: settle, duration: 60 ms, adhesion: 10 %}"
STEP = "time.step=8e-6 s"  # what stages press with would change the automatic one
PRESS = "{name: press, duration: 10 ms, walls: {lid: {stress: 1 kPa}}}"


class FreeRun(clod.Case):

    @classmethod
    def setUpClass(cls):
        """One run through two stages, and the first of them alone."""
        cls.shared = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, cls.shared)
        for name, stages in (("whole", f"[{SETTLE}, {PRESS}]"), ("first", f"[{SETTLE}]")):
            done = clod.run("run", BOX, "-o", os.path.join(cls.shared, name), "-t", "1", "--set",
                            f"stages={stages}", "--set", STEP)
            assert done.returncode == 0, done.stderr
        cls.first = os.path.join(cls.shared, "first")
        cls.whole = os.path.join(cls.shared, "whole")

    def go(self, *changes, origin=None, stages=f"[{PRESS}]", folder="out", case=BOX, expect=0):
        sets = [word for change in (f"stages={stages}", STEP, *changes)
                for word in ("--set", change)]
        done = clod.run("run", case, "-o", self.path(folder), "-t", "1", "--from",
                        origin or self.first, *sets)
        self.assertEqual(done.returncode, expect, done.stderr)
        return done.stderr

    def refused(self, *changes, folder="out", **more):
        err = self.go(*changes, folder=folder, **more, expect=2)
        self.assertFalse(os.path.exists(self.path(folder)), err)
        return err

    def rows(self, folder):
        return [{name: value for name, value in row.items() if name != "stage"}
                for row in clod.table(os.path.join(folder, "series.csv"))]

    def test_same_bits(self):
        """Two runs, one after the other, are one run; the rows go on in time."""
        err = self.go()
        out = self.path("out")
        rows = self.rows(out)
        self.assertEqual(self.rows(self.whole)[-len(rows):], rows)
        self.assertEqual(len(self.rows(self.whole)), len(self.rows(self.first)) + len(rows))
        one, other = (json.loads(clod.read(os.path.join(folder, "summary.json")))
                      for folder in (out, self.whole))
        for key in ("time_s", "steps", "dt_s", "contacts", "max_overlap", "kinetic_energy_J",
                    "walls"):
            self.assertEqual(one[key], other[key], key)
        self.assertEqual(one["from"], os.path.realpath(self.first))
        self.assertNotIn("from", other)
        for text in ("100 grains", "wall box is where it was", "wall lid is where it was",
                     "as there", 'stages.0.name: "settle" there, "press" here'):
            self.assertIn(text, err)
        contacts = int(re.search(r"(\d+) contacts with their history", err)[1])
        first = json.loads(clod.read(os.path.join(self.first, "summary.json")))
        self.assertGreaterEqual(contacts, first["contacts"])
        self.assertTrue(any(event["event"] == "notice" and "taken over" in event["text"]
                            for event in clod.log(out)))

    def test_interrupted(self):
        """It goes on like any run, with --from or without; not as if from somewhere else."""
        self.go(folder="undisturbed")
        out = self.path("out")
        sets = ("--set", f"stages=[{PRESS}]", "--set", STEP)
        process = clod.start("run", BOX, "-o", out, "-t", "1", "--from", self.first, *sets)
        table = os.path.join(out, "series.csv")
        self.assertTrue(clod.wait_until(
            lambda: os.path.exists(table) and clod.read(table).count(b"\n") > 5, process))
        process.send_signal(signal.SIGTERM)
        process.communicate()
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        err = self.go(origin=self.whole, expect=2)
        self.assertIn("cannot go on from another one", err)
        shutil.copytree(out, self.path("again"))
        self.go()
        self.assert_same_end(self.path("undisturbed"), out, ["run"])
        done = clod.run("run", BOX, "-o", self.path("again"), "-t", "1", *sets)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_end(self.path("undisturbed"), self.path("again"), ["run"])

    def test_begun_without(self):
        self.go(folder="out", origin=self.first)
        done = clod.run("run", BOX, "-o", self.first, "--set", f"stages=[{SETTLE}]", "--set", STEP,
                        "--from", self.whole)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("was begun without --from", done.stderr)

    def test_other_friction(self):
        err = self.go("contacts.default.friction=0.1")
        self.assertIn("contacts.ore-ore.friction: 0.35 there, 0.1 here", err)
        self.assertRegex(err, r"\d+ contacts with their history\n")
        self.assertNotEqual(self.rows(self.path("out")), self.rows(self.whole)[-20:])

    def test_other_law(self):
        """What a contact of another law remembers means nothing: it is told and dropped."""
        err = self.go("contacts.default={law: hooke, k1: 1e4 N/m, restitution: 0.3, "
                      "friction: 0.35}")
        self.assertRegex(err, r" 0 contacts with their history; \d+ begin anew: their law")

    def test_denser_grains(self):
        self.go("materials.ore.density=4962.6 kg/m3", "contacts.default.k_adh=0 N/m^1.5",
                stages="[{name: on, duration: 60 ms}]")
        with_weight = self.rows(self.path("out"))[-20:]
        before = self.rows(self.whole)[80:120]
        self.assertAlmostEqual(clod.mean(with_weight, "box.force_z") /
                               clod.mean(before, "box.force_z"), 2.0, delta=0.5)

    def test_new_cell(self):
        """The bed keeps what it remembers of itself, and meets a wall that was not there."""
        with open(BOX) as file:
            text = file.read()
        text = text.replace("  box:\n", "  tray:\n").replace("box: {surface", "tray: {surface")
        with open(self.path("tray.yaml"), "w") as file:
            file.write(text)
        err = self.go(case=self.path("tray.yaml"))
        for words in ("wall box is gone", "wall tray stands as this case has it",
                      "begin anew: their wall is another one"):
            self.assertIn(words, err)
        # all else is as it was: the bed stays where it is, so the floor carries the same
        one, other = self.rows(self.path("out")), self.rows(self.whole)[-20:]
        self.assertAlmostEqual(clod.mean(one, "tray.force_z"), clod.mean(other, "box.force_z"),
                               delta=0.2 * abs(clod.mean(other, "box.force_z")))

    def test_wall_of_another_shape(self):
        err = self.go("walls.lid.shapes=[{plane: {point: [0 mm, 0 mm, 70 mm], "
                      "normal: [0, 0, -1]}}]")
        self.assertIn("wall lid has other shapes", err)

    def test_longer_step(self):
        """A step of the case's own: time goes on, and intervals are counted in its steps."""
        self.assertIn("time step 4e-06 s, that of this case", self.go("time.step=4e-6 s"))
        out = json.loads(clod.read(self.path("out/summary.json")))
        self.assertEqual(out["dt_s"], 4e-6)
        self.assertAlmostEqual(out["time_s"], 70e-3, delta=2e-5)

    def kept(self):
        """A run with a moment that SIGUSR1 kept, and what came after."""
        folder = self.path("kept")
        process = clod.start("run", BOX, "-o", folder, "-t", "1")
        table = os.path.join(folder, "series.csv")
        clod.wait_until(lambda: os.path.exists(table) and clod.read(table).count(b"\n") > 20,
                        process)
        process.send_signal(signal.SIGUSR1)
        self.assertTrue(clod.wait_until(
            lambda: any("-at-" in name for name in os.listdir(folder)), process))
        clod.wait_until(lambda: any("-at-" in e.get("text", "") for e in clod.log(folder)), process)
        process.kill()
        process.communicate()
        text = [event["text"] for event in clod.log(folder) if "-at-" in event.get("text", "")][0]
        return folder, re.search(r"time (\S+) s", text)[1]

    def test_kept_moment(self):
        folder, moment = self.kept()
        err = self.go(origin=f"{folder}@{moment}")
        self.assertIn(f"time {moment} s: 100 grains", err)
        times = [row["time"] for row in self.rows(self.path("out"))]
        self.assertAlmostEqual(times[0], float(moment) + 0.5e-3, delta=2e-5)
        err = self.go(origin=f"{folder}@9.5 s", folder="none", expect=2)
        self.assertIn("no checkpoint of that time", err)
        self.assertIn(f" {moment} s", err)
        err = self.go(origin=f"{folder}@soon", folder="none", expect=2)
        self.assertIn("a time in seconds is needed", err)

    def test_unreadable(self):
        """A checkpoint that cannot be looked at is not one that is not there."""
        copy = self.path("copy")
        shutil.copytree(self.first, copy)
        os.symlink("restart-at-1_a.h5", os.path.join(copy, "restart-at-1_a.h5"))
        err = self.refused(origin=f"{copy}@9.5")
        self.assertIn(os.strerror(errno.ELOOP), err)
        self.assertIn("restart-at-1_a.h5", err)

    def test_moved_away(self):
        """Who has begun needs the other folder no more, only its name."""
        copy = self.path("copy")
        shutil.copytree(self.first, copy)
        self.go(origin=copy)
        os.rename(copy, self.path("moved"))
        self.go(origin=copy)
        self.go(origin=copy + "/")
        err = self.go(origin=self.path("moved"), expect=2)
        self.assertIn("cannot go on from another one", err)
        self.refused(origin=copy, folder="new")

    def test_wrong_folders(self):
        os.mkdir(self.path("empty"))
        for origin in (self.path("nothing"), self.path("empty"), BOX):
            self.assertIn("The results folder of another run is needed",
                          self.refused(origin=origin))
        foreign = self.path("foreign")
        os.mkdir(foreign)
        with open(os.path.join(foreign, "case-complete.yaml"), "wb") as file:
            file.write(b"\x00 not a case: [\n")
        self.refused(origin=foreign)
        done = clod.run("run", BOX, "-o", self.first, "--from", self.first)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("the results folder of this run itself", done.stderr)

    def test_damaged_checkpoints(self):
        copy = self.path("copy")
        shutil.copytree(self.first, copy)
        newest, older = clod.checkpoints(copy, "run")
        for path in (newest, older):
            content = bytearray(clod.read(path))
            content[len(content) // 2] ^= 4
            with open(path, "wb") as file:
                file.write(content)
            err = self.go(origin=copy, folder=os.path.basename(path),
                          expect=0 if path == newest else 2)
            self.assertIn(f"{path} cannot be used", err)
            self.assertNotIn("--fresh", err)
        os.remove(newest)
        os.remove(older)
        err = self.refused(origin=copy)
        self.assertIn("There is no checkpoint", err)
        self.assertNotIn("--fresh", err)

    def test_what_cannot_be(self):
        text = clod.read(BOX).decode()
        with open(self.path("other.yaml"), "w") as file:
            file.write(re.sub(r"\bore\b", "sand", text))
        err = self.refused(case=self.path("other.yaml"))
        self.assertIn("its grains are of the material 'ore'", err)
        err = self.refused("domain.max=[30 mm, 40 mm, 12 mm]",
                           "grains.0.region.box.max=[30 mm, 30 mm, 12 mm]")
        self.assertRegex(err, r"its grain \d+ at z = 0.01\d* m is outside the domain")
        err = self.refused("walls.box.shapes=[{plane: {point: [0 mm, 0 mm, 6 mm], "
                           "normal: [0, 0, 1]}}]")
        self.assertRegex(err, r"--from \S+: .*overlap")
        self.assertIn("overlap", self.refused("time.overlap_limit=1e-6"))
        done = clod.run("run", RING, "-o", self.path("out"), "--from", self.first)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("only be taken over from a run of the same kind", done.stderr)


class Tests(clod.Case):
    """A test goes on from another one's preparation."""

    def run_case(self, case, folder, *changes, origin=None, expect=0):
        words = [word for change in changes for word in ("--set", change)]
        words += ["--from", self.path(origin)] if origin else []
        done = clod.run("run", case, "-o", self.path(folder), "-t", "1", *words)
        self.assertEqual(done.returncode, expect, done.stderr)
        return done

    def same_table(self, one, other):
        self.assertEqual(clod.read(self.path(one)), clod.read(self.path(other)))

    def assert_told(self, one, other, err):
        """On the screen and in the log: each part with the step at its end there, what differs."""
        steps = {event["part"]: event["step"] for event in clod.log(self.path(one))
                 if event["event"] == "finished"}
        notices = [event["text"] for event in clod.log(self.path(other))
                   if event["event"] == "notice"]
        for text in (err, "\n".join(notices)):
            for part in ("preshear", "reverse"):
                self.assertIn(f"{part} is taken over from {os.path.realpath(self.path(one))}, "
                              f"step {steps[part]}, ", text)
            self.assertEqual(text.count("what differs:\n"), 1)
            self.assertIn("\n  ring_shear.shear_stresses: [300 Pa, 600 Pa] there, "
                          "[300 Pa, 600 Pa, 450 Pa] here\n", text)

    @clod.quick_only
    def test_more_points(self):
        """The points that both have are the same, and the preparation is not run again."""
        self.run_case(RING, "few")
        stresses = "ring_shear.shear_stresses=[0.3 kPa, 0.6 kPa, 0.45 kPa]"
        done = self.run_case(RING, "more", stresses, origin="few")
        for part in ("preshear", "reverse", "point-1", "point-2"):
            self.same_table(f"few/{part}.csv", f"more/{part}.csv")
        parts = json.loads(clod.read(self.path("more/summary.json")))["parts"]
        self.assertEqual({part["from"] for part in parts}, {os.path.realpath(self.path("few"))})
        self.assertEqual(len(clod.table(self.path("more/points.csv"))), 3)
        self.assert_told("few", "more", done.stderr)
        began = {event["from"] for event in clod.log(self.path("more"))
                 if event["event"] == "phase"}
        self.assertEqual(began, {"reduce", "shear"})
        again = self.run_case(RING, "more", stresses, origin="few")
        self.assertEqual(again.stdout, done.stdout)
        self.run_case(RING, "whole", stresses)
        for part in ("point-1", "point-2", "point-3"):
            self.same_table(f"whole/{part}.csv", f"more/{part}.csv")
        self.run_case(RING, "further", "ring_shear.shear_max=1 mm", origin="few")
        self.run_case(RING, "alone", "ring_shear.shear_max=1 mm")
        self.same_table("further/point-1.csv", "alone/point-1.csv")

    @clod.quick_only
    def test_what_a_test_refuses(self):
        for change, text in (("ring_shear.preshear_stress=2 kPa", "preshear_stress differs"),
                             ("contacts.default.friction=0.2", "friction differs"),
                             ("seed=8", "seed differs")):
            process = clod.start("run", RING, "-o", self.path("begun"), "-t", "1")
            self.assertTrue(clod.wait_until(
                lambda: clod.checkpoints(self.path("begun"), "preshear") != [], process))
            process.kill()
            process.communicate()
            done = self.run_case(RING, "out", change, origin="begun", expect=2)
            self.assertIn(text, done.stderr)
            self.assertFalse(os.path.exists(self.path("out")))
        done = self.run_case(RING, "out", origin="begun", expect=2)
        self.assertIn("its preshear is not finished", done.stderr)
        done = self.run_case(RING, "out", origin="begun@0.1", expect=2)
        self.assertIn("is for free runs", done.stderr)

    def contents(self, folder):
        return {name: clod.read(os.path.join(self.path(folder), name))
                for name in os.listdir(self.path(folder)) if name != ".clod-lock"}

    @clod.quick_only
    def test_nothing_is_cleared(self):
        """A preparation that cannot be taken over is seen before --fresh removes anything."""
        self.run_case(SMALL, "old")
        before = self.contents("old")
        shutil.copytree(self.path("old"), self.path("bad"))
        with open(self.path("bad/reverse.csv"), "r+b") as file:
            file.seek(-3, os.SEEK_END)
            file.write(b"7")
        shutil.copytree(self.path("old"), self.path("begun"))
        for name in os.listdir(self.path("begun")):
            if re.match(r"restart-reverse_[ab]", name):
                os.remove(self.path(os.path.join("begun", name)))
        for origin in ("bad", "begun"):
            done = clod.run("run", SMALL, "-o", self.path("old"), "--fresh", "--from",
                            self.path(origin))
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("reverse", done.stderr)
            self.assertEqual(self.contents("old"), before)

    @clod.quick_only
    def test_killed_on_the_way(self):
        """Tables without the checkpoint of after: they are taken over again, or made again."""
        self.run_case(SMALL, "old")
        self.run_case(SMALL, "whole", origin="old")
        for name, origin in (("with", "old"), ("without", None)):
            shutil.copytree(self.path("whole"), self.path(name))
            for part in ("preshear", "reverse"):
                os.remove(clod.checkpoints(self.path(name), part)[0])
            os.remove(self.path(f"{name}/reverse.csv"))
            self.run_case(SMALL, name, origin=origin)
            for table in ("preshear.csv", "reverse.csv", "preshear-energy.csv", "points.csv"):
                self.same_table(f"whole/{table}", f"{name}/{table}")

    @clod.quick_only
    def test_with_and_without(self):
        """Points that were begun without --from know where their preparation comes from."""
        self.run_case(SMALL, "old")
        self.run_case(SMALL, "whole", origin="old")
        shutil.copytree(self.path("whole"), self.path("again"))
        points = sorted(name for name in os.listdir(self.path("whole"))
                        if re.match(r"point-\d+\.csv", name))
        for point, origin in ((points[0][:-4], None), (points[-1][:-4], "old")):
            for name in os.listdir(self.path("again")):
                if re.match(rf"(restart-)?{point}[_.-]", name):
                    os.remove(self.path(f"again/{name}"))
            self.run_case(SMALL, "again", origin=origin)
            self.assert_same_end(self.path("whole"), self.path("again"),
                                 ["preshear", "reverse", point])

    @clod.quick_only
    def test_more_consolidations(self):
        with open(UNIAXIAL) as file:
            stresses = re.search(r"consolidation_stresses: \[(.*?)\]", file.read())[1].split(", ")
        key = "uniaxial.consolidation_stresses"
        self.run_case(UNIAXIAL, "few", f"{key}=[{stresses[-1]}]")
        both = f"{key}=[{stresses[-1]}, {stresses[0]}]"
        self.run_case(UNIAXIAL, "more", both, origin="few")
        for part in ("fill", "stress-1"):
            self.same_table(f"few/{part}.csv", f"more/{part}.csv")
        self.assertEqual(len(clod.table(self.path("more/flow_function.csv"))), 2)


if __name__ == "__main__":
    clod.main()
