"""clod check is content with a case if and only if the first 100 steps of clod run go well:
random cases, some good, some bad, some just about (support/starts.py)."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import starts

CASES = 15 if clod.SANITIZED else 60


class CheckAsRun(clod.Case):

    def test_check_and_run_agree(self):
        wrong, well = starts.differences("few", range(CASES))
        self.assertEqual(wrong, [], "\n".join(wrong))
        self.assertGreater(well, CASES // 5)
        self.assertLess(well, CASES - CASES // 5)


if __name__ == "__main__":
    clod.main()
