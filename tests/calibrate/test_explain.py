"""clod explain: the keys of all kinds of file, and the manual in docs/."""

import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

PLAN = ", in the plan of a calibration (clod calibrate)\n"
HOPPER = ", in the case of a hopper (clod hopper)\n"


class Explain(clod.Case):

    def explain(self, *keys, code=0):
        done = clod.run("explain", *keys, cwd=self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_keys_of_plans_and_hoppers_say_where_they_are(self):
        self.assertTrue(self.explain("budget").stdout.startswith("budget" + PLAN))
        self.assertIn("targets.N.discrepancy" + PLAN, self.explain("targets.0.discrepancy").stdout)
        told = self.explain("parameters.k_adh.scale").stdout
        self.assertIn("parameters.NAME.scale" + PLAN, told)
        self.assertIn("one of linear, log", told)
        told = self.explain("cone.half_angle").stdout
        self.assertIn("cone.half_angle" + HOPPER, told)
        self.assertIn("allowed  above 0 deg and at most 60 deg", told)

    def test_a_key_of_several_files_is_explained_for_each(self):
        told = self.explain("title").stdout
        for where in ("title\n", "title" + HOPPER, "title" + PLAN):
            self.assertEqual(told.count(where), 1, told)

    def test_a_key_at_the_top_of_one_file_hides_none_within_others(self):
        told = self.explain("seeds").stdout
        for where in ("ring_shear.seeds\n", "wall_friction.seeds\n", "seeds" + PLAN):
            self.assertEqual(told.count(where), 1, told)

    def test_a_verb_lists_the_topmost_keys_of_its_file(self):
        """Each as often as the manual's first table of that kind of file has it, in its order."""
        with open(clod.source("docs/manual.md")) as file:
            manual = file.read()
        for verb, title, top in (("run", "a case file", "The case"), ("hopper", "the case of a hopper", "The hopper"),
                                 ("calibrate", "the plan of a calibration", "The plan")):
            told = self.explain(verb).stdout.splitlines()
            self.assertEqual(told[0], f"Keys of {title}, read by clod {verb}: the topmost. clod explain KEY tells more.")
            keys = re.findall(r"^\| `(\w+)`", manual.partition(f"## {top}\n")[2].partition("\n## ")[0], re.MULTILINE)
            self.assertGreater(len(keys), 5)
            self.assertEqual([line.split()[0] for line in told[2:]], keys)

    def test_a_verb_before_a_key_chooses_its_file(self):
        told = self.explain("hopper.wall_friction").stdout
        self.assertTrue(told.startswith("wall_friction" + HOPPER), told)
        self.assertEqual(told.count("  kind "), 1)
        self.assertTrue(self.explain("calibrate.seeds").stdout.startswith("seeds" + PLAN))
        self.assertTrue(self.explain("run.seed").stdout.startswith("seed\n"))
        self.assertIn("there is no key hopper.wall_frictoin; did you mean wall_friction?",
                      self.explain("hopper.wall_frictoin", code=2).stderr)

    def test_wrong_keys_are_answered_with_the_nearest_of_all_files(self):
        for wrong, right in (("bugdet", "budget"), ("arch_thicknes", "arch_thickness"), ("kadh", "k_adh")):
            self.assertIn(f"there is no key {wrong}; did you mean {right}?", self.explain(wrong, code=2).stderr)

    def test_list_has_all_files(self):
        told = self.explain().stdout
        for title in ("Keys of a case file.", "Keys of the case of a hopper.", "Keys of the plan of a calibration."):
            self.assertEqual(told.count(title), 1)
        for key in ("  ring_shear.depth ", "  wedge.half_angle ", "  sampling.level "):
            self.assertIn(key, told)

    def test_manual_in_docs_is_up_to_date(self):
        with open(clod.source("docs/manual.md")) as file:
            self.assertTrue(file.read() == self.explain("--manual").stdout,
                            "write it again with: clod explain --manual > docs/manual.md")


if __name__ == "__main__":
    clod.unittest.main()
