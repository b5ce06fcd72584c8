"""clod check --ranks: memory and time by the model of docs/scaling.md."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
TEST = clod.source("tests/cli/uniaxial.yaml")


class CheckRanks(clod.Case):

    def check(self, case, *arguments):
        done = clod.run("check", case, *arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def told(self, case, *arguments):
        return json.loads(self.check(case, "--json", *arguments))

    def test_wrong_numbers_are_refused(self):
        for number in ("0", "-1", "1000001", "2.5", "two", ""):
            done = clod.run("check", BOX, f"--ranks={number}", cwd=self.folder)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(f"--ranks {number}: a whole number from 1 to 1000000", done.stderr)

    def test_nothing_is_told_unless_asked(self):
        self.assertNotIn("ranks", self.check(BOX))
        self.assertFalse([key for key in self.told(BOX) if key.startswith("ranks")])

    def test_share_of_a_rank(self):
        """100 grains on 4 ranks: 25, and each rank sees all others, as a box has 2.3 grains across."""
        told = self.told(BOX, "--ranks", "4", "--threads", "1")
        self.assertEqual((told["ranks"], told["ranks_groups"], told["threads"]), (4, 1, 1))
        self.assertEqual((told["ranks_grains_each"], told["ranks_ghosts_each"]), (25, 75))
        # 25 rows, 75 ghosts at 0.7, calls of 2 messages after the first and a meeting, a merge of
        # 2 rounds, 0.1 us longer where they leave a machine of fewer processors: docs/scaling.md
        row = 1.3 / told["rate_one_thread_per_s"]
        between = {1: 2, 2: 1, 3: 1}.get(told["processors"], 0)
        merge = (2 - between) * 1.5e-6 + between * 1.6e-6
        step = (25 + 0.7 * 75) * row + (2 * 2 * 0.66e-6 + 1.2e-6) + merge
        # of two digits: 1.0e-4 is 0.95e-4 to 1.05e-4
        half = 0.05 * 10 ** math.floor(math.log10(told["ranks_step_s"]))
        self.assertLess(abs(told["ranks_step_s"] - step), 1.0001 * half)
        # 100 grains in layers take 0.1 ms, or a little more at random positions
        self.assertGreater(told["ranks_making_s"], 1e-4)
        self.assertLess(told["ranks_making_s"], 2e-3)
        self.assertGreater(told["ranks_checkpoint_s"], 0.0)
        self.assertIn(" s for each checkpoint", self.check(BOX, "--ranks", "4"))
        # beside the program of 35 MB little
        self.assertEqual(told["ranks_memory_all_bytes"], 140e6)

    def test_one_rank_is_one_process(self):
        told = self.told(BOX, "--ranks", "1")
        self.assertEqual((told["ranks_grains_each"], told["ranks_ghosts_each"]), (told["grains"], 0))
        self.assertEqual(told["ranks_memory_steps_other_bytes"], 0)
        self.assertNotIn("of another rank", self.check(BOX, "--ranks", "1"))

    def test_a_test_steps_its_parts_on_groups(self):
        told = self.told(TEST, "--ranks", "64")
        self.assertGreater(told["ranks_groups"], 1)
        each = 64 // told["ranks_groups"]
        self.assertAlmostEqual(told["ranks_grains_each"], told["grains"] / each)
        self.assertIn("groups step parts side by side", self.check(TEST, "--ranks", "64"))

    def test_more_than_the_machine_has(self):
        """A million ranks need 35 MB each at least."""
        text = self.check(BOX, "--ranks", "1000000")
        for words in ("1000000 ranks with 1 thread on ", "take turns", "all ranks together may need 3.5e+04 GB",
                      "1000000 ranks for 100 grains: some have none", "docs/scaling.md has the rest"):
            self.assertIn(words, text)
        self.assertNotIn("take turns", self.check(BOX, "--ranks", "1"))

    def test_a_bed_from_a_file_is_whole_on_rank_0(self):
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [mm], y [mm], z [mm], radius [mm]\n" + "".join(
                f"{x / 100}, {y / 100}, {z / 100}, 0.001\n" for x in range(500, 560) for y in range(500, 560) for z in range(500, 510)))
        with open(BOX) as file, open(self.path("case.yaml"), "w") as case:
            case.write(file.read().replace("seed: 3\n", ""))
        told = self.told("case.yaml", "--ranks", "2", "--set", "grains=[{material: ore, file: grains.csv}]")
        # 36 000 grains at 560 bytes, and at 1 500 for each of 18 000, beside 35 MB
        self.assertEqual(told["ranks_memory_start_rank_0_bytes"], 55e6)
        self.assertEqual(told["ranks_memory_start_other_bytes"], 62e6)


if __name__ == "__main__":
    clod.main()
