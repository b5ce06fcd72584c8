"""docs/howto/from-lab-report-to-outlet.md, as a new user follows it: its cheap commands, with what they print.

A block of the page that begins with `$ ` is a command and what it prints; a line `...` stands for any
lines. Runs and the calibration are not repeated: the card that it found is put in its place.
"""

import os
import re
import shlex
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

PAGE = clod.source("docs/howto/from-lab-report-to-outlet.md")
CARD = clod.source("cases/lab-to-outlet/card.yaml")
DEAR = [["clod", "run"], ["clod", "calibrate", "plan.yaml", "-o"], ["clod", "report"], ["clod", "picture"]]


def steps():
    """(command, what it prints) of all blocks."""
    with open(PAGE) as file:
        blocks = re.findall(r"```\n(\$ .*?)```", file.read(), re.DOTALL)
    return [step.partition("\n")[::2] for block in blocks
            for step in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]]


def is_dear(words):
    return any(words[:len(dear)] == dear for dear in DEAR)


class Page(clod.Case):

    def shown(self, command, text, told):
        """What is printed is what the page shows."""
        pattern = "".join(r"(?s:.*?)" if line == "..." else re.escape(line) + "\n" for line in text.splitlines())
        if not re.fullmatch(pattern, told):
            self.fail(f"$ {command}\nprints\n{told}\nand the page shows\n{text}")

    def test_commands_print_what_the_page_shows(self):
        done = 0
        for command, text in steps():
            words = shlex.split(command)
            if words[:2] == ["clod", "calibrate"] and "-o" in words:
                os.makedirs(self.path("run/fines"))
                shutil.copy(CARD, self.path("run/fines"))
            if is_dear(words):
                continue
            if words[0] == "clod":
                told = clod.run(*words[1:], cwd=self.folder)
                self.assertEqual(told.returncode, 0, told.stderr)
                self.shown(command, text, told.stdout)
            elif words[0] == "cat":
                with open(self.path(words[1])) as file:
                    self.shown(command, text, file.read())
            else:
                self.assertEqual(words[0], "cp", "the page has no other commands")
                shutil.copy(self.path(words[1]), self.path(words[2]))
            done += 1
        self.assertGreater(done, 5)

    def test_the_calibration_on_the_page_is_that_of_the_card(self):
        """Mean and interval: the row of the table, the card in the case, and the plan's parameter."""
        with open(CARD) as file:
            card = re.search(r"pull_off_force: (\S+) mN # 90 %: (\S+) mN to (\S+) mN\n", file.read())
        told = [text for command, text in steps() if command.startswith("clod calibrate plan.yaml -o")]
        self.assertEqual(len(told), 1)
        row = re.search(r"^  pull_off_force +(\S+) +(\S+) +(\S+)  mN ", told[0], re.MULTILINE)
        self.assertEqual(row.groups(), card.groups())

    def test_dear_commands_are_in_order(self):
        """Their cases load, with the card of the page."""
        self.assertEqual(clod.run("new", "lab-to-outlet", "hopper.yaml", cwd=self.folder).returncode, 0)
        shutil.copy(CARD, self.folder)
        runs = [shlex.split(command) for command, _ in steps() if command.startswith("clod run")]
        self.assertGreater(len(runs), 2)
        for words in runs:
            case = words[2]
            changes = [word for k, word in enumerate(words) if word == "--set" or words[k - 1] == "--set"]
            told = clod.run("check", case, *changes, cwd=self.folder)
            self.assertEqual(told.returncode, 0, told.stderr)


if __name__ == "__main__":
    clod.unittest.main()
