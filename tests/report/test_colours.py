"""Curves of a figure are told apart by people with any colour vision: by colour, or by dash and mark.

Colours are those of the pages themselves, seen as H. M. Machado, M. M. Oliveira and L. A. F. Fernandes, "A physiologically-based
model for simulation of color vision deficiency", IEEE Trans. Vis. Comput. Graph. 15 (2009) 1291, tab. 1, severity 1.0 (in linear
sRGB), have protanopia, deuteranopia and tritanopia. Their distance is the Euclidean one in CIE Lab (D65).

Threshold 14: M. Stone, D. A. Szafir and V. Setlur, "An engineering model for color difference as a function of size", CIC 22
(2014) 253, measured which distance half of all people notice between marks of the size s [degrees]: 0.5 (10.16 + 1.50/s) in L,
0.5 (10.68 + 3.08/s) in a, 0.5 (10.70 + 5.74/s) in b. The smallest marks they had were of 1/3 degree, about the points and samples of the
legend here: 7.3, 10 and 14. The worst of the three is asked for, whatever the direction. (On large fields 2.3 is seen.)
"""

import itertools
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod

VISIONS = {
    "normal": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}
LEAST = 14.0
# sRGB to XYZ, and its white (IEC 61966-2-1)
XYZ = ((0.4124564, 0.3575761, 0.1804375), (0.2126729, 0.7151522, 0.0721750), (0.0193339, 0.1191920, 0.9503041))
WHITE = (0.95047, 1.0, 1.08883)


def times(matrix, vector):
    return [sum(a * b for a, b in zip(row, vector)) for row in matrix]


def lab(colour, vision):
    """CIE Lab of "#rrggbb" as a vision has it."""
    values = [int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in values]
    seen = [min(1.0, max(0.0, v)) for v in times(VISIONS[vision], linear)]
    x, y, z = (t ** (1 / 3) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29
               for t in (v / white for v, white in zip(times(XYZ, seen), WHITE)))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def distance(one, other, vision):
    return sum((a - b) ** 2 for a, b in zip(lab(one, vision), lab(other, vision))) ** 0.5


def between(colours, share):
    """A place on a map of colours, straight between them in sRGB."""
    at = share * (len(colours) - 1)
    below = min(int(at), len(colours) - 2)
    mixed = (round(int(one[k:k + 2], 16) + (at - below) * (int(other[k:k + 2], 16) - int(one[k:k + 2], 16)))
             for one, other in [colours[below:below + 2]] for k in (1, 3, 5))
    return "#" + "".join(f"{part:02x}" for part in mixed)


def look(curve):
    """What of a curve is told apart without colour: its dash, or its mark."""
    if curve["style"] in ("points", "hollow"):
        return curve["style"], curve["round"]
    return curve["dashes"]


class Colours(clod.Case):

    def test_distances_are_those_of_lab(self):
        """White and black are 100 apart, red and green of sRGB 170.6 (Lab 53.24, 80.09, 67.20 and 87.73, -86.18, 83.18),
        and a deuteranope sees both as shades of one yellow: their a is about 0."""
        self.assertAlmostEqual(distance("#ffffff", "#000000", "normal"), 100.0, places=2)
        self.assertAlmostEqual(distance("#ff0000", "#00ff00", "normal"), 170.58, places=1)
        for vision, matrix in VISIONS.items():
            for row in matrix:  # greys stay as they are
                self.assertAlmostEqual(sum(row), 1.0, places=5, msg=vision)

    def test_curves_of_every_page(self):
        seen = set()
        for name in pages.every(self.folder):
            for figure in pages.load(self.path(name)).figures.values():
                self.check_figure(name, figure)
                seen.update(curve["colour"] for curve in figure["curves"])
        self.assertEqual(len(seen), 8)  # all colours, and grey

    def check_figure(self, page, figure):
        named = [curve for curve in figure["curves"] if curve["name"] != ""]
        for one, other in itertools.combinations(named, 2):
            told = {vision: distance(one["colour"], other["colour"], vision) for vision in VISIONS}
            if look(one) == look(other):
                self.assertGreater(min(told.values()), LEAST, (page, figure["name"], one["name"], other["name"], told))

    def test_loci_of_a_laboratory(self):
        """Nine loci, two more than there are colours, beside a run's own: no two lines are alike, nor two marks."""
        pages.shear(self.path("ring"))
        with open(self.path("lab.csv"), "w") as file:
            file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n")
            for k in range(1, 10):
                file.writelines(f"{10 * k},{7 * k},{part * k},{(0.7 * part + 1) * k:.6g}\n" for part in (3, 5, 7))
        done = clod.run("report", "ring", "--lab", "lab.csv", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        figure = pages.load(self.path("ring/report.html")).figures["yield-locus"]
        lines = [curve for curve in figure["curves"] if curve["style"] == "dashed"]
        self.assertEqual(len(lines), 9)
        self.assertEqual(lines[0]["colour"], lines[7]["colour"])
        self.assertEqual(len({(curve["colour"], curve["dashes"]) for curve in figure["curves"] if curve["name"] != ""}), 10)
        self.check_figure("ring", figure)
        with open(self.path("ring/report-yield-locus.svg")) as file:
            drawn = file.read()
        for curve in lines:  # the line itself, and its sample in the legend
            self.assertEqual(drawn.count(f'stroke="{curve["colour"]}" stroke-width="2" stroke-dasharray="{curve["dashes"]}"'), 1)

    def test_palette(self):
        """Each colour beside each other one, grey too, and all of them on white paper."""
        pages.every(self.folder)
        colours = {curve["colour"] for figure in pages.load(self.path("packings.html")).figures.values() for curve in figure["curves"]}
        colours.add("#ffffff")
        self.assertEqual(len(colours), 9)
        for one, other in itertools.combinations(sorted(colours), 2):
            for vision in VISIONS:
                self.assertGreater(distance(one, other, vision), LEAST, (one, other, vision))

    def test_maps(self):
        """Colours of a map: lighter and lighter for any vision and in grey print, none looks like the paper of blank cells, and
        numbers that a fifth of the range parts are told apart."""
        pages.field_run(self.path("field"))
        self.assertEqual(clod.run("report", self.path("field")).returncode, 0)
        maps = [figure["map"] for figure in pages.load(self.path("field/report.html")).figures.values() if "map" in figure]
        self.assertEqual(len(maps), 4)
        colours = maps[0]["colours"]
        self.assertTrue(all(given["colours"] == colours for given in maps))
        with open(clod.source("src/report/web/view.js")) as file:
            self.assertIn(f"RAMP = {json.dumps(colours)};", file.read())  # those of the 3-D view
        fine = [between(colours, k / 50) for k in range(51)]
        for vision in VISIONS:
            lightness = [lab(colour, vision)[0] for colour in fine]
            self.assertTrue(all(b > a for a, b in zip(lightness, lightness[1:])), vision)
            for k, colour in enumerate(fine):
                self.assertGreater(distance(colour, "#ffffff", vision), LEAST, (colour, vision))
                for other in fine[k + 10:]:
                    self.assertGreater(distance(colour, other, vision), LEAST, (colour, other, vision))
        grey = [0.2126 * a + 0.7152 * b + 0.0722 * c for a, b, c in ([int(f[k:k + 2], 16) for k in (1, 3, 5)] for f in fine)]
        self.assertTrue(all(b > a for a, b in zip(grey, grey[1:])))


if __name__ == "__main__":
    clod.unittest.main()
