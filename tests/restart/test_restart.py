"""An interrupted run ends with the same bytes as one that was not, however it was stopped."""

import os
import random
import shutil
import signal
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

RING = clod.source("tests/restart/ring.yaml")
BOX = clod.source("tests/restart/box.yaml")
JENIKE = clod.source("tests/restart/jenike.yaml")
SHEAR_TEST = ["preshear", "reverse", "point-1", "point-2"]
PARTS = {RING: SHEAR_TEST, BOX: ["run"]}
if not clod.SANITIZED:
    PARTS[JENIKE] = SHEAR_TEST
PLAIN = os.path.join(clod.make_folder(), "plain.yaml")  # without the ledger, which takes three quarters of the time
SETS = ["scalar", "avx2", "avx512", "neon"]
SEED = int(os.environ.get("CLOD_TEST_SEED", time.time_ns() % 1000000))


def setUpModule():
    unittest.addModuleCleanup(shutil.rmtree, os.path.dirname(PLAIN))
    if clod.SANITIZED:
        return
    with open(RING) as ring, open(PLAIN, "w") as plain:
        plain.write(ring.read().replace(", energy: true", ""))
    PARTS[PLAIN] = SHEAR_TEST


class Restart(clod.Case):

    @classmethod
    def setUpClass(cls):
        """Undisturbed runs to compare with, in folders that outlive the tests."""
        cls.whole = {}
        cls.seconds = {}
        for case in PARTS:
            folder = clod.make_folder()
            cls.addClassCleanup(shutil.rmtree, folder)
            begin = time.monotonic()
            done = clod.run("run", case, "-o", folder, "-t", "1")
            assert done.returncode == 0, done.stderr
            cls.seconds[case] = time.monotonic() - begin
            cls.whole[case] = (folder, done.stdout)

    def assert_whole(self, case, folder):
        self.assert_same_end(self.whole[case][0], folder, PARTS[case])

    def go_on(self, case, folder, *options):
        """The same command to its end."""
        done = clod.run("run", case, "-o", folder, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_whole(case, folder)
        return done

    def interrupt(self, case, folder, number, ready, *options):
        """Send a signal when `ready`; returns stderr."""
        process = clod.start("run", case, "-o", folder, *options)
        self.assertTrue(clod.wait_until(ready, process), "ended before it was interrupted")
        process.send_signal(number)
        out, err = process.communicate(timeout=1000)
        self.assertEqual(process.returncode, 128 + number, err)
        self.assertEqual(out, "")
        self.assertIn("the same command goes on from here", err)
        return err

    def has(self, folder, **fields):
        """Whether the log has an event with these fields."""
        return lambda: any(fields.items() <= event.items() for event in clod.log(folder))

    def test_signals(self):
        moments = ((signal.SIGINT, "phase", {"to": "shear"}, "2"),
                   (signal.SIGTERM, "phase", {"to": "lower"}, "1"),
                   (signal.SIGINT, "finished", {"part": "reverse"}, "1"))
        for number, event, what, threads in moments[:1] if clod.SANITIZED else moments:
            with self.subTest(number=number, event=event, what=what, threads=threads):
                folder = self.path("-".join(what.values()))
                self.interrupt(RING, folder, number, self.has(folder, event=event, **what),
                               "-t", threads)
                self.go_on(RING, folder, "-t", "1")

    @clod.quick_only
    def test_signals_again_and_again(self):
        folder = self.path("often")
        for phase in ("lower", "consolidate", "preshear"):
            self.interrupt(PLAIN, folder, signal.SIGTERM,
                           self.has(folder, event="phase", to=phase), "-t", "1")
        for part in ("preshear", "reverse"):
            self.interrupt(PLAIN, folder, signal.SIGTERM,
                           self.has(folder, event="finished", part=part), "-t", "1")
        self.go_on(PLAIN, folder, "-t", "1")

    def test_free_run(self):
        moments = ((signal.SIGTERM, "drag", "2"), (signal.SIGINT, "compress", "1"))
        for number, stage, threads in moments[:1] if clod.SANITIZED else moments:
            with self.subTest(stage=stage):
                folder = self.path(stage)
                self.interrupt(BOX, folder, number, self.has(folder, event="phase", to=stage),
                               "-t", threads)
                done = self.go_on(BOX, folder, "-t", "1")
                self.assertEqual(done.stdout, self.whole[BOX][1])

    @clod.quick_only
    def test_jenike(self):
        folder = self.path("jenike")
        for phase in ("twist", "preshear", "shear"):
            self.interrupt(JENIKE, folder, signal.SIGTERM,
                           self.has(folder, event="phase", to=phase), "-t", "1")
        self.go_on(JENIKE, folder, "-t", "2")

    def test_finished_run_only_reports(self):
        for case in PARTS:
            folder = self.path(os.path.basename(case))
            shutil.copytree(self.whole[case][0], folder)
            before = {name: os.stat(os.path.join(folder, name)).st_mtime_ns
                      for name in os.listdir(folder) if name.startswith("restart")}
            done = self.go_on(case, folder, "-t", "1")
            self.assertEqual(done.stdout, self.whole[case][1])
            self.assertEqual(done.stderr, "")
            for name, moment in before.items():
                self.assertEqual(os.stat(os.path.join(folder, name)).st_mtime_ns, moment)

    @clod.quick_only
    def test_instruction_sets(self):
        """Every set to the same end; begun with one and finished with the next."""
        sets = [name for name in SETS if clod.run(
            "run", BOX, "-o", self.path("try"), "--fresh", "-i", name).returncode == 0]
        self.assertIn("scalar", sets)
        for k, name in enumerate(sets):
            folder = self.path(name)
            self.interrupt(BOX, folder, signal.SIGINT,
                           self.has(folder, event="phase", to="compress"), "-t", "1", "-i", name)
            self.go_on(BOX, folder, "-t", "1", "-i", sets[(k + 1) % len(sets)])

    def kill_until_done(self, case, folder, threads, seconds):
        """SIGKILL at random moments until a run comes to its end; returns how many kills."""
        dice = random.Random(f"{SEED} {threads} {case}")
        kills = 0
        while True:
            process = clod.start("run", case, "-o", folder, "-t", str(threads))
            try:
                # longer from time to time, so that slow machines get there too
                process.wait(seconds * dice.random() * (1.0 + 0.2 * kills))
            except clod.subprocess.TimeoutExpired:
                process.kill()
                kills += 1
            _, err = process.communicate()
            if process.returncode == 0:
                return kills
            self.assertEqual(process.returncode, -signal.SIGKILL, err)

    @clod.quick_only
    def test_killed(self):
        print(f"CLOD_TEST_SEED={SEED}")
        for case, threads in ((RING, 1), (PLAIN, 2), (BOX, 1)):
            with self.subTest(case=os.path.basename(case), threads=threads, seed=SEED):
                folder = self.path(f"{os.path.basename(case)}-{threads}")
                # on any machine: a part of what the whole run took just now
                kills = self.kill_until_done(case, folder, threads, 0.15 * self.seconds[case])
                print(f"{os.path.basename(case)}, {threads} threads: {kills} kills")
                self.assertGreaterEqual(kills, 2)
                went_on = [e for e in clod.log(folder) if e["event"] == "resume"]
                self.assertGreater(len(went_on), 0)
                self.assert_whole(case, folder)

    def damage(self, path, how):
        whole = clod.read(path)
        middle = len(whole) // 2
        damaged = {"cut": whole[:middle],
                   "empty": b"",
                   "bit": whole[:middle] + bytes([whole[middle] ^ 4]) + whole[middle + 1:],
                   "head": whole.replace(b"\nstep ", b"\nstep 1", 1)[:len(whole)]}[how]
        self.assertNotEqual(whole, damaged)
        with open(path, "wb") as file:
            file.write(damaged)

    def stopped(self, name):
        """A ring shear test stopped in preshear, with two checkpoints."""
        folder = self.path(name)
        for phase in ("lower", "preshear"):
            self.interrupt(PLAIN, folder, signal.SIGTERM,
                           self.has(folder, event="phase", to=phase), "-t", "1")
        self.assertEqual(len(clod.checkpoints(folder, "preshear")), 2)
        return folder

    @clod.quick_only
    def test_damaged_checkpoint(self):
        begun = self.stopped("begun")
        for how in ("cut", "bit"):
            with self.subTest(how=how):
                folder = self.path(how)
                shutil.copytree(begun, folder)
                newest, older = clod.checkpoints(folder, "preshear")
                self.damage(newest, how)
                done = self.go_on(PLAIN, folder, "-t", "1")
                self.assertEqual(done.stderr.count(f"{newest} cannot be used"), 1, done.stderr)
                self.assertIn(f"Going on from {older}", done.stderr)

    def forget(self, folder, part):
        """Take away the checkpoints of a part and its tables."""
        for path in clod.checkpoints(folder, part):
            os.remove(path)
        for name in (f"{part}.csv", f"{part}-energy.csv"):
            if os.path.exists(os.path.join(folder, name)):
                os.remove(os.path.join(folder, name))

    @clod.quick_only
    def test_damaged_presheared_state(self):
        """The end of preshear is lost before it is sheared back: preshear's end is run again."""
        folder = self.path("points")
        self.interrupt(RING, folder, signal.SIGTERM,
                       self.has(folder, event="finished", part="preshear"), "-t", "1")
        self.forget(folder, "reverse")
        newest = clod.checkpoints(folder, "preshear")[0]
        self.damage(newest, "bit")
        done = self.go_on(RING, folder, "-t", "1")
        self.assertEqual(done.stderr.count("cannot be used"), 1, done.stderr)

    @clod.quick_only
    def test_damaged_reversed_state(self):
        """A part without a whole checkpoint begins anew when its files are taken away."""
        folder = self.path("reversed")
        self.interrupt(PLAIN, folder, signal.SIGTERM,
                       self.has(folder, event="finished", part="reverse"), "-t", "1")
        for path in clod.checkpoints(folder, "reverse"):
            self.damage(path, "bit")
        done = clod.run("run", PLAIN, "-o", folder, "-t", "1")
        self.assertEqual(done.returncode, 1, done.stderr)
        for path in clod.checkpoints(folder, "reverse"):
            self.assertIn(f"{path}", done.stderr)
        self.forget(folder, "reverse")
        self.go_on(PLAIN, folder, "-t", "1")

    @clod.quick_only
    def test_both_checkpoints_damaged(self):
        folder = self.stopped("both")
        for path, how in zip(clod.checkpoints(folder, "preshear"), ("head", "empty")):
            self.damage(path, how)
        done = clod.run("run", PLAIN, "-o", folder, "-t", "1")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("cannot be used"), 2, done.stderr)
        self.assertIn("--fresh", done.stderr)
        self.go_on(PLAIN, folder, "-t", "1", "--fresh")

    @clod.quick_only
    def test_changed_case(self):
        self.changed(PLAIN, self.stopped("changed"))
        self.changed(BOX, self.copy_of_whole("box"))

    def copy_of_whole(self, name):
        folder = self.path(name)
        shutil.copytree(self.whole[BOX][0], folder)
        return folder

    def changed(self, case, folder):
        """Another case is refused and changes nothing; the case itself goes on."""
        before = {name: clod.read(os.path.join(folder, name)) for name in os.listdir(folder)
                  if name not in ("log.jsonl", ".clod-lock")}
        done = clod.run("run", case, "-o", folder, "-t", "1", "--set", "seed=8")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for text in ("The case has changed", "--fresh", "-o"):
            self.assertIn(text, done.stderr)
        for name, content in before.items():
            self.assertEqual(clod.read(os.path.join(folder, name)), content, name)
        self.go_on(case, folder, "-t", "1")

    @clod.quick_only
    def test_complete_case_is_the_same_case(self):
        """The copy with all defaults goes on where the case itself was stopped."""
        folder = self.stopped("complete")
        done = clod.run("run", os.path.join(folder, "case-complete.yaml"), "-o", folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        shutil.copy(PLAIN, os.path.join(folder, "case.yaml"))
        self.assert_whole(PLAIN, folder)

    def test_folder_in_use(self):
        folder = self.path("used")
        process = clod.start("run", RING, "-o", folder, "-t", "1")
        self.assertTrue(clod.wait_until(self.has(folder, event="start"), process))
        done = clod.run("run", RING, "-o", folder, "-t", "1", "--fresh")
        process.kill()
        process.communicate()
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(f"(process {process.pid})", done.stderr)
        if not clod.SANITIZED:
            self.go_on(RING, folder, "-t", "1")

    @clod.quick_only
    def test_fresh_keeps_what_is_not_ours(self):
        folder = self.copy_of_whole("fresh")
        with open(os.path.join(folder, "notes.txt"), "w") as file:
            file.write("mine")
        self.go_on_with_notes(folder)

    def go_on_with_notes(self, folder):
        done = clod.run("run", BOX, "-o", folder, "-t", "1", "--fresh")
        self.assertEqual(done.returncode, 0, done.stderr)
        notes = os.path.join(folder, "notes.txt")
        self.assertEqual(clod.read(notes), b"mine")
        os.remove(notes)
        self.assert_whole(BOX, folder)
        self.assertEqual(len([e for e in clod.log(folder) if e["event"] == "start"]), 1)


if __name__ == "__main__":
    clod.main()
