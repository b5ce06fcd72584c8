"""Tables of `rising`: what contacts and bed are like as preshear goes on."""
import math
import os

import inside
import numpy

WAYS = [0, 2, 5, 10, 15, 20, 25, 30, 38, 48]  # mm
SINCE = [5, 10, 20]  # mm, from where on lives are counted
LATER = [1, 2, 5, 10, 20]  # mm
AGES = [(0, 1), (1, 2), (2, 5), (5, 10), (10, 20), (20, 50)]  # mm
RISES = [(2, 10), (10, 20), (20, 50)]  # mm; the last one to the end
BLOCK = 1e-3  # m


class Bed(inside.Preshear):
    """A preshear with what is told of it."""

    def __init__(self, folder):
        super().__init__(folder)
        self.keys = [inside.keys_of(self.contacts(k)["id"]) for k in range(len(self.way))]
        self.told = [self.numbers(k) for k in range(len(self.way))]

    def at(self, millimetres):
        """Number of the snapshot there; None beyond the end."""
        k = self.nearest(1e-3 * millimetres)
        return k if abs(1e3 * self.way[k] - millimetres) < 0.6 else None

    def blocks(self, column, low, high):
        """Middles of blocks of 1 mm of the way [m], and means of a column over them."""
        way, values = self.series["displacement"], self.series[column]
        edges = numpy.arange(low, high + 0.5 * BLOCK, BLOCK)
        inner = [(way >= a) & (way < b) for a, b in zip(edges, edges[1:])]
        kept = [(0.5 * (a + b), values[some].mean()) for a, b, some in zip(edges, edges[1:], inner) if some.any()]
        return numpy.array(kept).T

    def rise(self, low, high):
        """How fast the shear stress rises [Pa/m], and the standard error of a line through blocks."""
        return inside.slope(*self.blocks("shear_stress", 1e-3 * low, 1e-3 * high))

    def life(self, since):
        """Way in which a share 1/e of the contacts is left [m], from what is left after 10 mm."""
        begin, end = self.at(since), self.at(since + 10)
        if begin is None or end is None:
            return math.nan
        left = inside.survival(self.keys, begin)[end - begin]
        return -(self.way[end] - self.way[begin]) / math.log(left)


def read(folder, tests):
    """{name: Bed} of the tests that have come to the end of their preshear."""
    return {name: Bed(os.path.join(folder, name)) for name in tests
            if os.path.exists(os.path.join(folder, name, "reverse.csv"))}


def put(cells):
    print("| " + " | ".join(cells) + " |")


def head(*cells):
    print()
    put(cells)
    print("|---" * len(cells) + "|")


def print_course(beds):
    """Shear stress as means over 5 mm."""
    edges = range(0, 50, 5)
    head("test", *(f"{low}-{low + 5} mm" for low in edges))
    for name, bed in beds.items():
        way, tau = (bed.series[key] for key in ("displacement", "shear_stress"))
        inside_of = [(way >= 1e-3 * low) & (way < 1e-3 * (low + 5)) for low in edges]
        put([name, *(f"{1e-3 * tau[some].mean():.1f}" if way[-1] > 1e-3 * (low + 2.5) else "-"
                     for low, some in zip(edges, inside_of))])


def print_contacts(beds):
    head("test", "way [mm]", "tau [kPa]", "height [mm]", "contacts of a grain", "pull-off: mean, median, 99 % [N]",
         "share that pull", "pressure of pushes, of pulls, of the whole bed [kPa]", "tau / pushes")
    for name, bed in beds.items():
        for way in WAYS:
            k = bed.at(way)
            if k is not None:
                n = bed.told[k]
                put([name, f"{1e3 * n['way']:.1f}", f"{1e-3 * n['tau']:.1f}", f"{1e3 * n['height']:.2f}",
                     f"{n['coordination']:.2f}", f"{n['pull_off']:.2f}, {n['median']:.2f}, {n['most']:.1f}",
                     f"{n['pulling']:.2f}", f"{1e-3 * n['push']:.1f}, {1e-3 * n['pull']:.1f}",
                     f"{n['tau'] / n['push']:.2f}"])


def print_lives(beds):
    head("test", "since [mm]", *(f"left after {way} mm" for way in LATER), "life (1/e) [mm]")
    for name, bed in beds.items():
        for since in SINCE:
            begin = bed.at(since)
            if begin is None:
                continue
            left = inside.survival(bed.keys, begin)
            ends = [bed.at(since + way) for way in LATER]
            put([name, f"{since}", *("-" if end is None else f"{left[end - begin]:.3f}" for end in ends),
                 "-" if bed.at(since + 10) is None else f"{1e3 * bed.life(since):.1f}"])


def by_age(bed, k):
    """[(share, mean pull-off)] of the contacts of snapshot k by AGES, and last of those from before the shear."""
    age, pull = inside.ages(bed.keys[:k + 1], bed.way[:k + 1]), bed.contacts(k)["pull_off"]
    groups = [(age >= 1e-3 * low) & (age < 1e-3 * high) for low, high in AGES] + [numpy.isnan(age)]
    return [(some.mean(), pull[some].mean() if some.any() else math.nan) for some in groups]


def print_ages(beds):
    head("test", "at [mm]", *(f"{low}-{high} mm" for low, high in AGES), "from before shear")
    for name, bed in beds.items():
        for way in (10, 20, 38, 48):
            k = bed.at(way)
            if k is not None:
                put([name, f"{way}", *("-" if share == 0 else f"{100 * share:.0f} %: {pull:.1f} N"
                                       for share, pull in by_age(bed, k))])


def print_rises(beds):
    head("test", *(f"rise over {low}-{high} mm [kPa/mm]" for low, high in RISES),
         "tau over mean pull-off from 10 mm on [kPa/N]", "tau / pushes of the whole bed, from 10 mm on")
    for name, bed in beds.items():
        cells = []
        for low, high in RISES:
            there = bed.way[-1] > 1e-3 * (low + 0.2 * (high - low))
            cells.append("{:+.2f} ± {:.2f}".format(*(1e-6 * value for value in bed.rise(low, high)))
                         if there else "-")
        late = [n for n in bed.told if n["way"] > 9.9e-3]
        pull, tau = (numpy.array([n[key] for n in late]) for key in ("pull_off", "tau"))
        cells.append("{:.2f} ± {:.2f}".format(*(1e-3 * value for value in inside.slope(pull, tau)))
                     if numpy.ptp(pull) > 0.1 else "-")
        ratio = numpy.array([n["tau"] / n["push"] for n in late])
        cells.append(f"{ratio.mean():.3f}, {inside.slope([n['way'] for n in late], ratio)[0] * 1e-2:+.3f} in 10 mm")
        put([name, *cells])


def print_stresses(beds):
    head("test", "way [mm]", "tau [kPa]", "pushes: rr, tt, zz [kPa]", "pulls: rr, tt, zz [kPa]",
         "shear of pushes [kPa]", "shear of pulls [kPa]", "rest of tau: friction [kPa]")
    for name, bed in beds.items():
        for way in WAYS[1:]:
            k = bed.at(way)
            if k is not None:
                push, pull = 1e-3 * bed.stress(bed.way[k])
                shear = [abs(push[3]), abs(pull[3])]
                tau = 1e-3 * bed.mean("shear_stress", bed.way[k])
                put([name, f"{way}", f"{tau:.1f}", ", ".join(f"{x:.1f}" for x in push[:3]),
                     ", ".join(f"{x:.1f}" for x in pull[:3]), *(f"{x:.1f}" for x in shear),
                     f"{tau - sum(shear):.1f}"])


def budget_over(bed, low, high):
    """Budget of the mean pull-off for each millimetre of a part of the way; pull-offs of what opens and comes as means."""
    rows = []
    for k in range(1, len(bed.way)):
        if low < 1e3 * bed.way[k] <= high:
            rows.append(inside.budget(*((bed.keys[j], bed.contacts(j)["pull_off"]) for j in (k - 1, k))))
    way = 1e3 * (bed.way[bed.way * 1e3 <= high][-1] - bed.way[bed.way * 1e3 <= low][-1])
    told = {key: sum(row[key] for row in rows) / way for key in ("gained", "lost", "turnover", "opened", "new")}
    for key in ("opened", "new"):
        told[key + "_pull"] = (sum(row[key] * row[key + "_pull"] for row in rows if row[key] > 0) /
                               max(1e-12, sum(row[key] for row in rows)))
    return told


def print_budget(beds):
    head("test", "over [mm]", "mean pull-off [N]", "contacts that stay gain [N/mm]", "and forget [N/mm]",
         "opening and coming [N/mm]", "open per mm, their pull-off", "come per mm, their pull-off")
    for name, bed in beds.items():
        for low, high in ((0, 2), (2, 5), (5, 10), (10, 20), (20, 30), (30, 38), (38, 48)):
            if 1e3 * bed.way[-1] > low + 0.7 * (high - low):
                b = budget_over(bed, low, high)
                mean = numpy.mean([n["pull_off"] for n in bed.told if low <= 1e3 * n["way"] <= high])
                put([name, f"{low}-{high}", f"{mean:.2f}", f"{b['gained']:+.3f}", f"{b['lost']:+.3f}",
                     f"{b['turnover']:+.3f}", f"{100 * b['opened']:.1f} %, {b['opened_pull']:.2f} N",
                     f"{100 * b['new']:.1f} %, {b['new_pull']:.2f} N"])


def print_profiles(beds):
    head("test", "at [mm]", "angle turned over the trough's, from below", "solid fraction", "mean pull-off [N]")
    for name, bed in beds.items():
        for way in (5, 10, 20, 38, 48):
            if bed.way[-1] > 1e-3 * way:
                told = bed.profile(1e-3 * way, 8)
                put([name, f"{way}", *(" ".join(f"{value:.{digits}f}" for value in told[key]) for key, digits in
                                       (("speed", 2), ("solid", 3), ("pull_off", 1)))])


def print_tables(beds):
    for table in (print_rises, print_course, print_contacts, print_stresses, print_budget, print_lives, print_ages, print_profiles):
        table(beds)
