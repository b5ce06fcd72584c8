"""The row in docs/howto/own-law.md has every function that each row of the laws has."""

import os
import re
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod


def text(path):
    return clod.read(clod.source(path)).decode()


class OwnLaw(unittest.TestCase):

    def test_the_row(self):
        functions = set(re.findall(r"\(\*(\w+)\)\(", text("src/law/law_kinds.h")))
        rows = text("src/law/law_kinds.c").split("static const clod_law_kind_row LAWS[")[1]
        rows = [set(re.findall(r"\.(\w+) =", row)) for row in rows.split("[CLOD_LAW_")[1:]]
        everywhere = functions.intersection(*rows)
        self.assertLess({"make", "stiffest", "unloading"}, everywhere)
        told = set(re.findall(r"\.(\w+) =", text("docs/howto/own-law.md").split("[CLOD_LAW_TACKY] = {")[1]))
        self.assertEqual(everywhere - told, set())


if __name__ == "__main__":
    clod.main()
