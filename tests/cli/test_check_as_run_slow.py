"""The comparison of test_check_as_run.py on 1000 random cases."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import starts

CASES = int(os.environ.get("CLOD_STARTS", "1000"))


class CheckAsRun(clod.Case):

    def test_check_and_run_agree(self):
        wrong, well = starts.differences("many", range(CASES))
        print(f"{CASES} cases: {well} went well, {CASES - well} were refused or went wrong")
        self.assertEqual(wrong, [], "\n".join(wrong))
        self.assertGreater(well, CASES // 4)
        self.assertLess(well, CASES - CASES // 4)


if __name__ == "__main__":
    clod.main()
