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

    def test_ore_case_has_no_warning_of_its_inertia(self):
        done = clod.run("check", ORE, "--threads", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        warnings = [line for line in done.stdout.splitlines() if line.startswith("WARNING")]
        self.assertFalse([line for line in warnings if "inertial" in line])


if __name__ == "__main__":
    clod.main()
