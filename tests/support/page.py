"""Pages of docs that show commands with what they print.

A block of a page that begins with `$ ` is a command and what it prints; a line `...` stands for any lines.
"""

import re
import shlex
import shutil

import clod


def steps(page):
    """(command, what it prints) of all blocks of a page."""
    with open(clod.source(page)) as file:
        blocks = re.findall(r"```\n(\$ .*?)```", file.read(), re.DOTALL)
    return [step.partition("\n")[::2] for block in blocks
            for step in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]]


class Case(clod.Case):

    def shown(self, command, text, told):
        """What is printed is what the page shows."""
        pattern = "".join(r"(?s:.*?)" if line == "..." else re.escape(line) + "\n" for line in text.splitlines())
        if not re.fullmatch(pattern, told):
            self.fail(f"$ {command}\nprints\n{told}\nand the page shows\n{text}")

    def follow(self, command, text):
        """Do one step of a page in the test's folder: a clod that succeeds, cat or cp. Runs have the same bits with
        one thread, and take less of the processors with it."""
        words = shlex.split(command)
        words += ["--threads", "1"] if words[:2] == ["clod", "run"] else []
        if words[0] == "clod":
            told = clod.run(*words[1:], cwd=self.folder)
            self.assertEqual(told.returncode, 0, told.stderr)
            self.shown(command, text, told.stdout)
        elif words[0] == "cat":
            with open(self.path(words[1])) as file:
                self.shown(command, text, file.read())
        else:
            self.assertEqual(words[0], "cp", "pages have no other commands")
            shutil.copy(self.path(words[1]), self.path(words[2]))
