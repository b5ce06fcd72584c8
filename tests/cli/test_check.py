"""clod check and clod run refuse what cannot run, with the same words."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
ORE = clod.source("cases/copper-ore-8/case.yaml")


class Check(clod.Case):

    def refused(self, verb, case, change, *texts):
        done = clod.run(verb, case, "--set", change, cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for text in texts:
            self.assertIn(text, done.stderr)
        return done.stderr[done.stderr.index(texts[0]):]

    def test_step_beyond_the_critical_one(self):
        for case in (BOX, ORE):
            words = "time.step: 0.001 s is beyond the critical step"
            said = self.refused("check", case, "time.step=1 ms", words, "at most", "write auto")
            self.assertEqual(said, self.refused("run", case, "time.step=1 ms", words))

    def test_key_without_effect(self):
        words = ("--set output.series_interval=1 ms: output.series_interval: a tester "
                 "writes a row of its series whenever it looks at the walls; remove this key")
        for verb in ("check", "run"):
            self.refused(verb, ORE, "output.series_interval=1 ms", words)

    def test_one_is_not_many(self):
        one = ("grains.0.count=1", "stages=[{name: one, duration: 1e-9 s}]", "output={}")
        changes = [word for change in one for word in ("--set", change)]
        done = clod.run("run", BOX, "-o", self.path("out"), *changes)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(" 1 step, 1 grain, 0 contacts,", done.stdout)

    def box_with(self, rows):
        """The box with grains of a file, which need no seed."""
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [mm], y [mm], z [mm], radius [mm]\n" + rows)
        with open(BOX) as file, open(self.path("case.yaml"), "w") as case:
            case.write(file.read().replace("seed: 3\n", ""))
        return self.path("case.yaml"), "grains=[{material: ore, file: grains.csv}]"

    def test_coincident_grains(self):
        case, change = self.box_with(2 * "9, 9, 9, 2\n")
        said = []
        for verb in ("check", "run"):
            done = clod.run(verb, case, "--set", change, "-o", self.path("out"))
            self.assertEqual(done.returncode, 1, done.stderr)
            said.append(done.stderr.replace(f"clod {verb}: ", ""))
        self.assertIn("grain 1 overlaps grain 2 by 200.0 % of the radius of the smaller one", said[0])
        self.assertEqual(said[0], said[1])

    def test_grain_in_a_file_outside_the_domain(self):
        for place, allowed in (("-20, 9, 9", "x = -0.02 m, allowed 0 to 0.03 m"),
                               ("9, -11, 9", "y = -0.011 m, allowed -0.01 to 0.04 m")):
            case, change = self.box_with(f"{place}, 2\n")
            for verb in ("check", "run"):
                self.refused(verb, case, change, f"grain 1 is outside the domain: {allowed}")

    def test_ore_case_has_no_warning_of_its_inertia(self):
        done = clod.run("check", ORE, "--threads", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        warnings = [line for line in done.stdout.splitlines() if line.startswith("WARNING")]
        self.assertFalse([line for line in warnings if "inertial" in line])


if __name__ == "__main__":
    clod.main()
