"""docs/howto/from-lab-report-to-outlet.md, as a new user follows it: its cheap commands, with what they print.

The calibrations, the shear test and the rusty chutes are repeated in test_lab_to_outlet_slow.py. Here the card that the first one found is put in
its place.
"""

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
SLOW = [["clod", "calibrate", "plan.yaml", "-o"], ["clod", "run", "ring.yaml"], ["clod", "run", "chute.yaml", "-o", "run/rust-35"],
        ["clod", "run", "chute.yaml", "-o", "run/rust-45"], ["clod", "calibrate", "plan-wall.yaml", "-o"],
        ["clod", "run", "chute.yaml", "-o", "run/card-35"],
        ["clod", "hopper", "hopper.yaml", "--set", "flow_function={shear_tests: [{points: run/ring-600}, {points: run/ring}, {points: run/ring-2400}]}"]]
DEAR = [*SLOW, ["clod", "report"], ["clod", "picture"],
        *([["clod", "run"], ["clod", "hopper"]] if clod.SANITIZED else [])]


def is_dear(words):
    return any(words[:len(dear)] == dear for dear in DEAR)


class Page(page.Case):

    def test_commands_print_what_the_page_shows(self):
        done = 0
        for command, text in page.steps(PAGE):
            words = shlex.split(command)
            if words[:4] == ["clod", "calibrate", "plan.yaml", "-o"]:
                os.makedirs(self.path("run/fines"))
                shutil.copy(CARD, self.path("run/fines"))
            if not is_dear(words):
                self.follow(command, text)
                done += 1
        self.assertGreater(done, 5)

    def test_the_calibration_on_the_page_is_that_of_the_card(self):
        """Mean and interval: the row of the table, the card in the case, and the plan's parameter."""
        with open(CARD) as file:
            card = re.search(r"pull_off_force: (\S+) mN # 90 %: (\S+) mN to (\S+) mN(?:;.*)?\n", file.read())
        told = [text for command, text in page.steps(PAGE) if command.startswith("clod calibrate plan.yaml -o")]
        self.assertEqual(len(told), 1)
        row = re.search(r"^  pull_off_force +(\S+) +(\S+) +(\S+) +\S+  mN ", told[0], re.MULTILINE)
        self.assertEqual(row.groups(), card.groups())

    def test_dear_commands_are_in_order(self):
        """Their cases load, with the card of the page."""
        self.assertEqual(clod.run("new", "lab-to-outlet", "hopper.yaml", cwd=self.folder).returncode, 0)
        shutil.copy(CARD, self.folder)
        runs = [shlex.split(command) for command, _ in page.steps(PAGE) if command.startswith("clod run")]
        self.assertGreater(len(runs), 2)
        for words in runs:
            case = words[2]
            changes = [word for k, word in enumerate(words) if word == "--set" or words[k - 1] == "--set"]
            told = clod.run("check", case, *changes, cwd=self.folder)
            self.assertEqual(told.returncode, 0, told.stderr)


if __name__ == "__main__":
    clod.unittest.main()
