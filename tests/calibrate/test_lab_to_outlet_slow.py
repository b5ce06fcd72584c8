"""The calibrations, the shear test and the rusty chutes of docs/howto/from-lab-report-to-outlet.md, with what they print: some ten
minutes of processor time."""

import os
import re
import shlex
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import page
from test_lab_to_outlet import SLOW

PAGE = "docs/howto/from-lab-report-to-outlet.md"
CARD = clod.source("cases/lab-to-outlet/card.yaml")
CLOCK = re.compile(r"[0-9]+ s of wall-clock time")  # of the day


class Page(page.Case):

    def shown(self, command, text, told):
        super().shown(command, CLOCK.sub("", text), CLOCK.sub("", told))

    def test_dear_runs_print_what_the_page_shows(self):
        self.assertEqual(clod.run("new", "lab-to-outlet", "hopper.yaml", cwd=self.folder).returncode, 0)
        shutil.copy(CARD, self.folder)
        begun = [slow for step in page.steps(PAGE) for slow in SLOW if shlex.split(step[0])[:len(slow)] == slow]
        self.assertTrue(all(slow in begun for slow in SLOW), begun)
        runs = [step for step in page.steps(PAGE) if any(shlex.split(step[0])[:len(slow)] == slow for slow in SLOW)]
        for command, text in runs:
            self.follow(command, text)


if __name__ == "__main__":
    clod.unittest.main()
