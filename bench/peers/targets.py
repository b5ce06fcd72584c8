"""The targets set in advance for clod on this class of machine, and whether they are reached."""

import plan
import table

# case, peer, how many times its speed on one core
RATIOS = [("plastic", "LIGGGHTS edinburgh/stiffness", 12.0),
          ("hertz", "LAMMPS gran/hertz/history", 5.0),
          ("rolling", "LAMMPS granular, sds", 8.0)]
TWO_THREADS = 1.85
LARGE = {"size": "300k", "beds": ("1M", "3M"), "share": 0.85}
BYTES_PER_GRAIN = 500.0


def bytes_per_grain(records, size, name):
    """
    Memory of a grain with its contacts, from the runs on one core, or None: clod's less that of
    its start; a peer's less that of the smallest bed, over the grains more.
    """
    keys = {"kind": "memory" if name == plan.CLOD else "speed", "case": plan.FULL,
            "program": name, "threads": 1}
    runs = table.chosen(records, size=size, **keys)
    small = table.chosen(records, size="4k", **keys)
    if not runs:
        return None
    if name == plan.CLOD:
        grown = [r["rss_kB"] - r["clod"]["rss_empty_kB"] for r in runs]
        return 1024.0 * max(grown) / runs[0]["grains"]
    if size == "4k" or not small:
        return None
    grown = max(r["rss_kB"] for r in runs) - max(r["rss_kB"] for r in small)
    return 1024.0 * grown / (runs[0]["grains"] - small[0]["grains"])


def _ratios(records):
    for case, peer, least in RATIOS:
        for size in plan.SIZES:
            ours, theirs = (table.chosen(records, kind="speed", case=case, size=size, program=name,
                                          threads=1)
                            for name in (plan.CLOD, peer))
            yield (f"case {plan.CASES[case][0][0]}: clod / {peer}", size,
                   table.ratio(ours, theirs), least)


def _own(records):
    runs = {(size, threads): table.chosen(records, kind="speed", case=plan.FULL, size=size,
                                          program=plan.CLOD, threads=threads)
            for size in plan.SIZES for threads in (1, 2)}
    for size in (size for size in plan.SIZES if not plan.cut(size)):
        yield ("case c: two threads / one", size, table.ratio(runs[size, 2], runs[size, 1]),
               TWO_THREADS)
    for size in LARGE["beds"]:
        yield (f"case c: rate / rate of {LARGE['size']}, one thread", size,
               table.ratio(runs[size, 1], runs[LARGE["size"], 1]), LARGE["share"])


def _verdict(what, value, least):
    """Two threads are at most twice as fast as one; beyond 10 % more the one-thread runs were
    disturbed."""
    if what.endswith("two threads / one") and value > 2.2:
        return "not judged: runs scatter"
    return "reached" if value >= least else "MISSED"


def text(records):
    """Table of targets, each bed by itself."""
    rows = [[what, size, f"at least {least:g}", f"{value:.2f}",
             _verdict(what, value, least)]
            for found in (_ratios, _own) for what, size, value, least in found(records)
            if value is not None]
    for size in (size for size in plan.SIZES if not plan.cut(size)):
        value = bytes_per_grain(records, size, plan.CLOD)
        if value is not None:
            rows.append(["case c: bytes per grain with its contacts", size,
                         f"at most {BYTES_PER_GRAIN:g}", f"{value:.0f}",
                         "reached" if value <= BYTES_PER_GRAIN else "MISSED"])
    return rows and "## Targets\n\n" + table.text(["target", "bed", "wanted", "measured", ""],
                                                   rows) or ""
