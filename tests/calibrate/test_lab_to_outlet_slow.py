"""The shear test of docs/howto/from-lab-report-to-outlet.md, half a minute of processor time, with what it prints."""

import os
import re
import shlex
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import page

PAGE = "docs/howto/from-lab-report-to-outlet.md"
CARD = clod.source("cases/lab-to-outlet/card.yaml")
CLOCK = re.compile(r"[0-9]+ s of wall-clock time")  # of the day


class Page(page.Case):

    def shown(self, command, text, told):
        super().shown(command, CLOCK.sub("", text), CLOCK.sub("", told))

    def test_the_shear_test_prints_what_the_page_shows(self):
        self.assertEqual(clod.run("new", "lab-to-outlet", "hopper.yaml", cwd=self.folder).returncode, 0)
        shutil.copy(CARD, self.folder)
        runs = [step for step in page.steps(PAGE) if shlex.split(step[0])[:3] == ["clod", "run", "ring.yaml"]]
        self.assertEqual(len(runs), 1)
        for command, text in runs:
            self.follow(command, text)


if __name__ == "__main__":
    clod.unittest.main()
