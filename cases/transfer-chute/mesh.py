"""Plates and sides of the chute in facets: chute.obj."""

import math
import os

from chute import arc, before

MOST_FACETS = 200000  # 10 MB; the layout of the case has a thousand


def straight(a, b, facet):
    """Points of a flat plate without its last one."""
    count = max(1, math.ceil(math.dist(a, b) / facet))
    return [(a[0] + (b[0] - a[0]) * k / count, a[1] + (b[1] - a[1]) * k / count)
            for k in range(count)]


def strips_of(given):
    """Facets across a plate."""
    return max(1, round(given.width / given.facet))


def side_counts(low, high, facet):
    """Columns and rows of a side's facets no larger than `facet`; 0: one."""
    return tuple(max(1, math.ceil((b - a) / facet)) if facet > 0 else 1 for a, b in zip(low, high))


class Writer:
    def __init__(self, path, given):
        self.file = open(path, "w")
        self.half = given.width / 2000
        self.strips = strips_of(given)
        self.count = 0

    def part(self, name):
        self.file.write(f"o {name}\n")

    def corner(self, x, y, z):
        self.file.write(f"v {1000 * x:.4f} {1000 * y:.4f} {1000 * z:.4f}\n")
        self.count += 1

    def plate(self, points):
        """A plate across the chute along points (x, z), of strips."""
        first = self.count + 1
        row = self.strips + 1
        for x, z in points:
            for k in range(row):
                self.corner(x, self.half * (2 * k / self.strips - 1), z)
        for i in range(len(points) - 1):
            for k in range(self.strips):
                a = first + i * row + k
                self.file.write(f"f {a} {a + row} {a + row + 1}\nf {a} {a + row + 1} {a + 1}\n")

    def side(self, y, low, high, facet):
        """A plate between two corners (x, z), of squares no larger than `facet`; 0: of one."""
        columns, rows = side_counts(low, high, facet)
        if (columns, rows) == (1, 1):
            first = self.count + 1
            for x, z in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])):
                self.corner(x, y, z)
            self.file.write(f"f {first} {first + 1} {first + 2}\nf {first} {first + 2} {first + 3}\n")
            return
        first = self.count + 1
        for i in range(rows + 1):
            for k in range(columns + 1):
                self.corner(low[0] + (high[0] - low[0]) * k / columns, y, low[1] + (high[1] - low[1]) * i / rows)
        for i in range(rows):
            for k in range(columns):
                a = first + i * (columns + 1) + k
                b = a + columns + 1
                self.file.write(f"f {a} {a + 1} {b + 1}\nf {a} {b + 1} {b}\n")


class Mesh:
    """Plates and sides of the chute in facets, of which there must not be too many."""

    def __init__(self, chute, given):
        self.given = given
        facet = given.facet / 1000
        lead = before(chute.at_hood, chute.hood_start, given.hood_lead / 1000)
        up = before(chute.plate[0], chute.spoon_start, given.spoon_up / 1000)
        bends = arc(chute.at_hood, given.hood_radius / 1000, chute.hood_start, chute.hood_end), chute.plate
        self.low = (min(given.sides_from / 1000, lead[0], up[0]), chute.plate[-1][1])
        self.high = (max(bends[0][-1][0], bends[1][-1][0]), max(lead[1], given.top / 1000 + 0.06))
        rows = sum(math.ceil(length / facet) for length in (given.hood_lead / 1000, given.spoon_up / 1000))
        columns, heights = side_counts(self.low, self.high, given.side_facet / 1000)
        plates = 2 * strips_of(given) * (rows + sum(len(bend) for bend in bends) - 2)
        self.facets = plates + 4 * columns * heights
        if self.facets > MOST_FACETS:
            key, size = ("facet", given.facet) if plates > self.facets / 2 else ("side-facet", given.side_facet)
            raise ValueError(f"--{key}: {size:g} mm makes {self.facets:.3g} facets of the chute; at most {MOST_FACETS}: at least "
                             f"some {1.1 * size * math.sqrt(self.facets / MOST_FACETS):.2g} mm")
        self.plates = (("hood", straight(lead, chute.at_hood, facet) + bends[0]),
                       ("spoon", straight(up, chute.plate[0], facet) + bends[1]))

    def write(self):
        out = Writer(os.path.join(self.given.output, "chute.obj"), self.given)
        for name, points in self.plates:
            out.part(name)
            out.plate(points)
        out.part("sides")
        for y in (-out.half, out.half):
            out.side(y, self.low, self.high, self.given.side_facet / 1000)
        out.file.close()
