"""Pages on paper: a browser prints them as PDF; every figure is drawn, nothing is cut off, no figure or row of a table is torn.

Skipped where there is no browser, or no pdftotext and pdftoppm (Debian's poppler-utils).
"""

import collections
import html
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from browser import BrowserCase
from pages import clod

MARGIN = 14 / 25.4 * 72  # points, as the style's @page has it
SCALE = 2                # pixels of a point
ROW = 60.0               # points: no row of a table is higher


class Paper:
    """The pages of a PDF: size, words with their boxes [points from the top left], and pixels."""

    def __init__(self, pdf):
        told = subprocess.run(["pdftotext", "-bbox", pdf, "-"], stdout=subprocess.PIPE, text=True, check=True).stdout
        self.sheets = []
        for width, height, inside in re.findall(r'<page width="([\d.]+)" height="([\d.]+)">(.*?)</page>', told, re.S):
            words = [(html.unescape(word).casefold(), *map(float, box)) for *box, word in re.findall(
                r'<word xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)">(.*?)</word>', inside)]
            self.sheets.append((float(width), float(height), words))
        self.pdf = pdf

    def pixels(self, number):
        """Rows of (red, green, blue) of a page, each the bytes of its pixels; pages are counted from 0."""
        ppm = subprocess.run(["pdftoppm", "-r", str(72 * SCALE), "-f", str(number + 1), "-l", str(number + 1), self.pdf],
                             stdout=subprocess.PIPE, check=True).stdout
        _, width, height, _, data = re.match(rb"(P6)\s(\d+) (\d+)\s(\d+)\s(.*)", ppm, re.S).groups()
        width = int(width)
        rows = [data[3 * y * width:3 * (y + 1) * width] for y in range(int(height))]
        return [(row[0::3], row[1::3], row[2::3]) for row in rows]


def words_of(markup):
    """Words of a piece of the page, as a reader sees them."""
    return html.unescape(re.sub(r"<[^>]*>", " ", markup)).casefold().split()


def lines_of(sheet, wanted):
    """Where words follow each other in a line of a page: (left, top, bottom) of each place."""
    words = sorted(sheet[2], key=lambda word: (round(word[2]), word[1]))
    row = [word for word, *_ in words]
    return [(words[k][1], words[k][2], words[k][4]) for k in range(len(row)) if row[k:k + len(wanted)] == wanted]


def rgb(colour):
    return [int(colour[k:k + 2], 16) for k in (1, 3, 5)]


def letters(words):
    """All of them in one text: where lines and words end differs between page and paper."""
    return "".join(words)


@clod.unittest.skipIf(shutil.which("pdftotext") is None or shutil.which("pdftoppm") is None,
                      "no pdftotext: Debian's poppler-utils has it")
class Print(BrowserCase):

    def printed(self, name):
        pdf = self.path("page.pdf")
        self.print(name, pdf)
        return Paper(pdf)

    def assert_inside(self, paper):
        """All words lie between the margins; a table that is too wide would reach beyond them."""
        for number, (width, height, words) in enumerate(paper.sheets):
            for word, left, top, right, bottom in words:
                inside = left > MARGIN - 2 and right < width - MARGIN + 2 and top > MARGIN - 4 and bottom < height - MARGIN + 4
                self.assertTrue(inside, (number + 1, word, left, top, right, bottom))

    def assert_text(self, paper, body):
        """What the page says is on the paper, to the letter: nothing is hidden behind an edge."""
        told = letters(word for _, _, words in paper.sheets for word, *_ in words)
        for cell in re.findall(r"<(?:td|th|li|p)\b[^>]*>(.*?)</(?:td|th|li|p)>", body, re.S):
            for word in re.findall(r"[^\s-]+-?|-", " ".join(words_of(cell))):  # a line may end behind a hyphen
                self.assertIn(word, told, cell)

    def assert_rows(self, paper, body):
        """All words of a row of a table are on one page, close to each other."""
        for row in re.findall(r"<tr>.*?</tr>", re.sub(r"<thead>.*?</thead>", "", body, flags=re.S), re.S):
            wanted = words_of(re.sub(r"</?small>", "", row))
            self.assertTrue(any(self.within(words, top, wanted) for _, _, words in paper.sheets
                                for word, _, top, *_ in words if wanted[0].startswith(word)), row)

    def within(self, words, top, wanted):
        near = letters(word for word, _, at, *_ in words if abs(at - top) < ROW)
        return all(word in near for word in wanted)

    def assert_figures(self, paper, page, body):
        """Each figure is on one page from its title to its last word, with its curves in their colours."""
        figures = re.findall(r'<figure [^>]*id="figure-([^"]*)">(.*?)</figure>', body, re.S)
        self.assertEqual([name for name, _ in figures], [name for name in page.figures if f'id="figure-{name}"' in body])
        for name, markup in figures:
            place = self.place_of(paper, markup)
            self.assertIsNotNone(place, f"{name} is torn, or not there")
            self.assert_curves(paper, page.figures[name], *place)

    def place_of(self, paper, markup):
        """Number of the page that has all words of a figure, and the box of its plot: left, right, from the title to the name of
        the x axis. Two figures may stand side by side: each has its words in its own half."""
        drawn = markup[markup.index("<svg"):]
        title = words_of(re.search(r"<h3>(.*?)</h3>", markup, re.S)[1])[:5]  # a long one has two lines
        axis = words_of(re.findall(r'<text [^>]*text-anchor="middle"[^>]*>([^<]*)</text>', re.sub(r"<text [^>]*rotate[^>]*>[^<]*</text>", "", drawn))[-1])
        wanted = words_of(re.sub(r"<title>.*?</title>", "", drawn, flags=re.S))
        for number, sheet in enumerate(paper.sheets):
            half = (sheet[0] - 2 * MARGIN) / 2
            for left, _, bottom in lines_of(sheet, title):
                for right in (left + half - 6, sheet[0]):
                    words = [word for word in sheet[2] if left - 4 <= word[1] and word[3] <= right]
                    below = [top for _, top, _ in lines_of((*sheet[:2], words), axis) if top > bottom]
                    told = letters(word for word, _, top, *_ in words if top >= bottom - 2)
                    if below and all(word in told for word in wanted):
                        return number, (left, bottom, right, min(below))
        return None

    def assert_curves(self, paper, figure, number, box):
        """Pixels of each colour are between title and axis, but for curves that lie below others with the same numbers."""
        left, top, right, bottom = (int(SCALE * edge) for edge in box)
        self.assertGreater(bottom - top, 200, figure["name"])
        if number not in self.drawn:
            self.drawn[number] = paper.pixels(number)
        seen = collections.Counter()
        for row in self.drawn[number][top:bottom]:
            seen.update(zip(*(colour[max(left, 0):right] for colour in row)))
        if "map" in figure:  # from the darkest to the lightest
            shades = [sum(count for pixel, count in seen.items() if max(abs(a - b) for a, b in zip(pixel, rgb(colour))) < 12)
                      for colour in figure["map"]["colours"]]
            self.assertGreater(min(shades), 20, (figure["name"], shades))
        last = {(tuple(curve["x"]), tuple(curve["y"])): curve["colour"] for curve in figure["curves"]}
        for colour in set(last.values()):
            near = sum(count for pixel, count in seen.items() if max(abs(a - b) for a, b in zip(pixel, rgb(colour))) < 24)
            self.assertGreater(near, 5, (figure["name"], colour))  # a ring of a hollow point that another covers has some 9

    def test_few_sheets(self):
        """A table goes on where its sheet ends, two figures stand side by side: the page of a ring shear test with six curves and a
        view is four sheets, and results begin below the cards of the first."""
        case = clod.source("tests/restart/ring.yaml")
        done = clod.run("run", case, "-o", self.path("ring"), "-t", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = pages.load_json(self.path("ring/summary.json"))
        summary["warnings"] = summary["locus"]["loci"][0]["warnings"] = []  # those of so small a test fill a sheet
        pages.write(self.path("ring"), summary__json=summary)
        self.assertEqual(clod.run("report", self.path("ring")).returncode, 0)
        paper = self.printed("ring/report.html")
        self.assertLessEqual(len(paper.sheets), 4)
        first = letters(word for word, *_ in paper.sheets[0][2])
        for text in ("results", "preshearnormalstress[kpa]", "cohesion[kpa]"):
            self.assertIn(text, first)
        beside = 0
        for sheet in paper.sheets:
            for title in ("Shear stress, preshear", "Height of the specimen, preshear"):
                beside += sum(left < sheet[0] / 2 for left, *_ in lines_of(sheet, words_of(title)))
                beside += 10 * sum(left > sheet[0] / 2 for left, *_ in lines_of(sheet, words_of(title)))
        self.assertEqual(beside, 11)  # one of them left, one right

    def test_letters_are_legible(self):
        """No letter of a figure that stands beside another is lower than that of 6 points."""
        pages.free_run(self.path("free"))
        self.assertEqual(clod.run("report", self.path("free")).returncode, 0)
        paper = self.printed("free/report.html")
        heights = [bottom - top for _, _, words in paper.sheets for word, _, top, _, bottom in words if word in ("time", "[s]")]
        self.assertGreater(len(heights), 3)
        self.assertGreater(min(heights), 6.0)

    def test_every_page(self):
        for name in pages.every(self.folder):
            with self.subTest(name):
                self.check(name)

    def test_rows_of_a_long_table(self):
        """Sixty rows of several lines, put into a page's table: each is on one sheet, the head on all of them."""
        pages.shear(self.path("ring"))
        self.assertEqual(clod.run("report", self.path("ring")).returncode, 0)
        rows = "".join(f"<tr><th>row{k}</th><td>{' '.join(f'w{k}x{n}' for n in range(150))}</td></tr>" for k in range(60))
        with open(self.path("ring/report.html")) as file:
            text = file.read()
        with open(self.path("long.html"), "w") as file:
            file.write(text.replace("</main>", f'<table class="facts"><thead><tr><th>head</th></tr></thead>{rows}</table></main>', 1))
        paper = self.printed("long.html")
        self.assert_inside(paper)
        on = [{word for word, *_ in words} for _, _, words in paper.sheets]
        self.assertGreater(sum("row0" in words or "row59" in words for words in on), 1)
        for k in range(60):
            wanted = {f"row{k}", *(f"w{k}x{n}" for n in range(150))}
            self.assertEqual(sum(bool(wanted & words) for words in on), 1, f"row {k} is torn")
            self.assertTrue(any(wanted <= words and "head" in words for words in on))

    def check(self, name):
        page = pages.load(self.path(name))
        body = re.sub(r"<details.*?</details>|<script.*?</script>", "", page.text[page.text.index("<main>"):], flags=re.S)
        paper = self.printed(name)
        self.drawn = {}
        self.assert_inside(paper)
        self.assert_text(paper, body)
        self.assert_rows(paper, body)
        self.assert_figures(paper, page, body)


if __name__ == "__main__":
    clod.unittest.main()
