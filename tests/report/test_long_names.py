"""Pages of a run whose parts have long names that differ at their end, in one of them no letter of a single byte."""

import glob
import html
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod
import same_names

LONG = "liner of the upper chute with exchangeable tiles of chromium carbide on its inner side: second row from the outlet "
NAMES = [LONG[:114] + "1", LONG[:114] + "2", "ä" * 100, "b" + "ö" * 99]
SURFACES = [f"plates.{name}" for name in NAMES]
SVG_MOST = 53  # letters: 480 pixels less 72 to the left and 46 for a line, 6.8 for each


def strict(path):
    with open(path, "rb") as file:
        return file.read().decode("utf-8")  # strict: an error where a character is cut


class LongNames(clod.Case):

    def go(self):
        same_names.write(self.path)
        for file, (left, right) in (("one.obj", NAMES[:2]), ("two.obj", NAMES[2:])):
            with open(self.path(file), "w") as out:
                out.write(same_names.PLATE.replace("o left", f"o {left}").replace("o right", f"o {right}"))
        done = clod.run("run", "case.yaml", "-o", "run", cwd=self.folder, page=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def legends(self, pattern):
        """Names of parts in the legends of the figures that are drawn beside a page."""
        texts = [re.findall(r"<text[^>]*>(surface plates[.].*?)</text>", strict(path)) for path in glob.glob(self.path(pattern))]
        return [[html.unescape(text) for text in one] for one in texts if one]

    def test_a_page(self):
        """Headings and the numbers behind the figures have the whole names; a legend has their ends."""
        self.assertEqual([len(name.encode()) for name in NAMES], [115, 115, 200, 199])
        self.go()
        page = pages.Page(strict(self.path("run/report.html")))
        heads = [set(table[0]) | {row[0] for row in table} for table in page.tables]
        self.assertEqual(sum(set(SURFACES) <= head for head in heads), 2)  # surfaces, and what rests on them
        wanted = {f"surface {surface}" for surface in SURFACES}
        found = [set(curve["name"] for curve in figure["curves"]) for figure in page.figures.values()]
        self.assertTrue(any(wanted <= names for names in found))
        legends = self.legends("run/report-*.svg")
        self.assertTrue(legends)
        for legend in legends:
            self.assertEqual(len(legend), 4)
            for name, shown in zip(NAMES, legend):
                self.assertTrue(name.endswith(shown.split("...")[1]), shown)
                self.assertGreater(len(shown.split("...")[1]), SVG_MOST // 2)
                self.assertLessEqual(len(shown), SVG_MOST)
            self.assertEqual(len(set(legend)), 4)
        self.compared(wanted)

    def compared(self, wanted):
        """Runs side by side: a figure for each force, its whole name above it."""
        shutil.copytree(self.path("run"), self.path("again"))
        done = clod.run("compare", "run", "again", "-o", "both.html", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = pages.Page(strict(self.path("both.html")))
        titles = {figure["title"] for figure in page.figures.values()}
        self.assertTrue({f"Force z: {name}" for name in wanted} <= titles, titles)
        for path in glob.glob(self.path("both-*.svg")):
            self.assertIn("</svg>", strict(path))


if __name__ == "__main__":
    clod.main()
