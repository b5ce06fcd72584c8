"""What the snapshots of a preshear tell of the inside of its bed, for `rising`; needs numpy and h5py.

Everything is by the way of the trough at the mean radius, in metres. A contact is known by the ids of its grains. One
that opens and closes again between two snapshots is taken for the same: lives are upper bounds, by less than the way
between snapshots (0.5 mm) for all that open once.
"""
import math
import os
import re
import sys

import numpy

# not the package: arrays of a results folder need no libclod
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python", "clod"))
import _results

PRESHEAR = 3  # phase of the series
NEAR = 1e-3  # m, by which a mean at a place reaches to both sides


def law_of(text):
    """Numbers of the contacts between grains in a case-complete.yaml: k2 as it acts [N/m^n], n, constant pull [N]."""
    pair = text[text.index("  ore-ore:"):text.index("  ore-side:")]

    def number(key, otherwise):
        found = re.search(rf"^ +{key}: ([-+.0-9e]+)", pair, re.M)
        return float(found.group(1)) if found else otherwise

    soften = float(re.search(r"^  soften: ([-+.0-9e]+)", text, re.M).group(1))
    return {"k2": number("k2", math.nan) / soften, "n": number("exponent", 1.5),
            "pull": number("pull_off_force", 0.0)}


def normal_force(law, overlap, plastic):
    """Push of a contact, below 0 a pull, without its dash-pot [N]: k2 (d^n - P) - f0 (docs/theory/mepa.md, eepa.md)."""
    return law["k2"] * (overlap ** law["n"] - plastic) - law["pull"]


def keys_of(ids):
    """One number for each pair of ids, whichever comes first."""
    pairs = numpy.sort(numpy.asarray(ids, dtype=numpy.int64), axis=1)
    return (pairs[:, 0] << 32) | pairs[:, 1]


def ages(keys, ways):
    """Age of each contact of the last list: way since the first of an unbroken row of lists that have it; nan when all
    have it. `keys` is one array for each of the ways."""
    last = keys[-1]
    born = numpy.full(len(last), math.nan)
    alive = numpy.ones(len(last), bool)
    for k in range(len(keys) - 2, -1, -1):
        here = numpy.isin(last, keys[k])
        born[alive & ~here] = ways[k + 1]
        alive &= here
    return ways[-1] - born


def survival(keys, begin):
    """Share of the contacts of list `begin` that are in it and in all lists from it up to each later one."""
    alive, told = keys[begin], []
    for later in keys[begin:]:
        alive = alive[numpy.isin(alive, later)]
        told.append(len(alive) / max(1, len(keys[begin])))
    return numpy.array(told)


def budget(before, after):
    """What changes the mean pull-off between two lists of (keys, pull-offs), as parts of it: what contacts that stay gain, and
    lose; what those that open and come do to it. Then shares that open and come, with their mean pull-offs."""
    _, a, b = numpy.intersect1d(before[0], after[0], return_indices=True)
    change = after[1][b] - before[1][a]
    opened, new = numpy.delete(before[1], a), numpy.delete(after[1], b)
    mean, count = before[1].mean(), len(after[0])
    turnover = (new - mean).sum() - (opened - mean).sum()
    return {"gained": change[change > 0].sum() / count, "lost": change[change < 0].sum() / count,
            "turnover": turnover / count, "opened": len(opened) / len(before[0]), "new": len(new) / count,
            "opened_pull": opened.mean() if len(opened) else math.nan, "new_pull": new.mean() if len(new) else math.nan}


def sphere_slices(z, radius, edges):
    """Volume of all spheres within each slice between level planes [m3]."""
    reach = numpy.clip(edges[None, :] - z[:, None], -radius[:, None], radius[:, None])
    below = math.pi * (radius[:, None] ** 2 * reach - reach ** 3 / 3)  # from the middle up to the plane
    return numpy.diff(below, axis=1).sum(axis=0)


def turned(before, after):
    """Angles by which places turned about z between two snapshots, each less than half a turn."""
    angle = numpy.arctan2(after[:, 1], after[:, 0]) - numpy.arctan2(before[:, 1], before[:, 0])
    return (angle + math.pi) % (2 * math.pi) - math.pi


def slope(x, y):
    """Slope of the straight line through points, and its standard error."""
    x, y = numpy.asarray(x), numpy.asarray(y)
    dx = x - x.mean()
    found = (dx * y).sum() / (dx ** 2).sum()
    rest = y - y.mean() - found * dx
    return found, math.sqrt((rest ** 2).sum() / (len(x) - 2) / (dx ** 2).sum())


class Preshear:
    """The preshear of a test with snapshots of its contacts."""

    def __init__(self, folder):
        self.run = _results.results(folder)
        with open(os.path.join(folder, "case-complete.yaml")) as file:
            text = file.read()
        self.law = law_of(text)
        size = {key: float(value) for key, value in
                re.findall(r"^  (inner_radius|outer_radius|bar_height|preshear_stress): ([-+.0-9e]+)", text, re.M)}
        self.inner, self.outer, self.bar = size["inner_radius"], size["outer_radius"], size["bar_height"]
        self.sigma = size["preshear_stress"]
        self.radius = float(re.search(r"^    mean: ([-+.0-9e]+)", text[text.index("\nring_shear:"):], re.M).group(1))
        self.area = math.pi * (self.outer ** 2 - self.inner ** 2)
        self.middle = 2 / 3 * (self.outer ** 3 - self.inner ** 3) / (self.outer ** 2 - self.inner ** 2)
        table = self.run.series("preshear")
        sheared = table["phase"] == PRESHEAR
        self.series = {key: values[sheared] for key, values in table.items()}
        self.begin = table["time"][~sheared][-1]
        self.number, self.way = [], []  # of the snapshots of preshear, among those of all parts
        for number, path in enumerate(self.run.snapshots("contacts")):
            time = self.time_of(path)
            if not os.path.basename(path).startswith("preshear_"):
                continue
            if time >= self.begin - 1e-9 and (not self.way or self.way_at(time) > self.way[-1] + 1e-6):
                self.number.append(number)
                self.way.append(self.way_at(time))
        self.way = numpy.array(self.way)

    @staticmethod
    def time_of(path):
        import h5py
        with h5py.File(path, "r") as file:
            return float(file.attrs["time_s"])

    def way_at(self, time):
        return float(numpy.interp(time, self.series["time"], self.series["displacement"], left=0.0))

    def nearest(self, way):
        """Number of the snapshot nearest to a way, among those of preshear."""
        return int(numpy.argmin(abs(self.way - way)))

    def contacts(self, k):
        return self.run.snapshot(self.number[k], "contacts")

    def grains(self, k):
        return self.run.snapshot(self.number[k])

    def mean(self, column, way, reach=NEAR):
        """Mean of a column of the series about a way."""
        near = abs(self.series["displacement"] - way) <= reach
        return float(self.series[column][near].mean())

    def numbers(self, k):
        """What contacts are like in snapshot k."""
        contacts, grains = self.contacts(k), self.grains(k)
        force = normal_force(self.law, contacts["overlap"], contacts["plastic"])
        ends = contacts["position"].reshape(-1, 2, 3)
        length = numpy.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
        way = self.way[k]
        reach = max(NEAR, 1e-4) if way > NEAR else 1e-4
        volume = self.volume(way, reach, grains)
        pressure = force * length / 3 / volume
        pull = contacts["pull_off"]
        return {"way": way, "tau": self.mean("shear_stress", way, reach) if way > 0 else 0.0,
                "height": self.mean("height", way, reach) if way > 0 else math.nan,
                "contacts": len(force), "coordination": 2 * len(force) / len(grains["id"]),
                "pull_off": pull.mean(), "median": numpy.median(pull), "most": numpy.percentile(pull, 99),
                "plastic": contacts["plastic"].mean(), "push": pressure[force > 0].sum(),
                "pull": -pressure[force < 0].sum(), "pulling": (force < 0).mean()}

    def volume(self, way, reach, grains):
        """Volume of the bed [m3]: mass over bulk density."""
        density = self.mean("bulk_density", way, reach) if way > 0 else self.series["bulk_density"][0]
        return grains["mass"].sum() / density

    def stress(self, way, snapshots=2):
        """Stresses of the normal forces in the bed between the bars, a grain's radius away from them [Pa]: rows of those
        that push and those that pull, columns rr, tt, zz, tz; compression is positive. Mean of the snapshots around."""
        middle, found = self.nearest(way), []
        for k in range(max(0, middle - snapshots), min(len(self.way), middle + snapshots + 1)):
            contacts = self.contacts(k)
            ends = contacts["position"].reshape(-1, 2, 3)
            branch, place = ends[:, 0] - ends[:, 1], ends.mean(axis=1)
            height = self.mean("height", max(self.way[k], 1e-4))
            low, high = self.bar + self.radius, height - self.bar - self.radius
            radius = numpy.hypot(place[:, 0], place[:, 1])
            r = (branch[:, :2] * place[:, :2]).sum(axis=1) / radius
            t = (place[:, 0] * branch[:, 1] - place[:, 1] * branch[:, 0]) / radius
            z = branch[:, 2]
            force = normal_force(self.law, contacts["overlap"], contacts["plastic"])
            scale = force / numpy.linalg.norm(branch, axis=1) / (self.area * (high - low))
            inside = (place[:, 2] > low) & (place[:, 2] < high)
            found.append([[(scale * product)[inside & some].sum() for product in (r * r, t * t, z * z, t * z)]
                          for some in (force > 0, force < 0)])
        return numpy.mean(found, axis=0)

    def profile(self, way, slices, reach=2e-3):
        """Over the height at a way: middle of each slice [m], solid fraction, turning over that of the trough, grains
        with their contacts, mean pull-off of the contacts; from the snapshots within `reach`."""
        low, high = self.nearest(way - reach), self.nearest(way + reach)
        edges = numpy.linspace(0.0, self.mean("height", min(way, self.way[-1]), reach), slices + 1)
        volume = self.area * numpy.diff(edges)
        solid, speed, partners, pull = [], [], [], []
        for k in range(low, high + 1):
            grains, contacts = self.grains(k), self.contacts(k)
            z = grains["position"][:, 2]
            solid.append(sphere_slices(z, grains["radius"], edges) / volume)
            partners.append(in_slices(z, grains["coordination"], edges))
            height = contacts["position"].reshape(-1, 2, 3)[:, :, 2].mean(axis=1)
            pull.append(in_slices(height, contacts["pull_off"], edges))
        first, last = self.grains(low), self.grains(high)
        a, b = numpy.argsort(first["id"]), numpy.argsort(last["id"])
        angle = turned(first["position"][a], last["position"][b])
        z = 0.5 * (first["position"][a][:, 2] + last["position"][b][:, 2])
        speed = in_slices(z, angle, edges) / ((self.way[high] - self.way[low]) / self.middle)
        return {"z": 0.5 * (edges[1:] + edges[:-1]), "solid": numpy.mean(solid, axis=0), "speed": abs(speed),
                "coordination": numpy.mean(partners, axis=0), "pull_off": numpy.mean(pull, axis=0)}


def in_slices(z, values, edges):
    """Mean of values in each slice; nan in an empty one."""
    which = numpy.digitize(z, edges) - 1
    return numpy.array([values[which == s].mean() if (which == s).any() else math.nan
                        for s in range(len(edges) - 1)])
