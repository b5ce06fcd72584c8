"""bench/results/peers.md from the records of all runs."""

import plan
import roofline
import table
import targets

SAME_WORK = 0.02  # largest difference of the coordination number


def _versions(records):
    """One line for each program and build, with the beds that it was measured on last."""
    found = {}
    for record in records:
        sizes = found.setdefault(record["version"], set())
        if record["kind"] == "speed":
            sizes.add(record["size"])
    beds = {version: ", ".join(size for size in plan.SIZES if size in sizes)
            for version, sizes in found.items()}
    return "".join(f"- {version}" + (f": {beds[version]}" if beds[version] else "") + "\n"
                   for version in found)


def _header(records, system):
    dates = sorted(r["date"] for r in records)
    machines = "; ".join(sorted({r["machine"] for r in records}))
    return f"""# clod beside its peers

Command: `make bench-peers` (`bench/run-peers`; decks of the peers: `bench/peers`). Measured from
{dates[0]} to {dates[-1]} on: {machines}; {system}.

{_versions(records)}
Beds: copies of `bench/packings/pack_4k.csv` (3750 grains of copper ore, periodic); 1k is a column cut
from it, loose at its seams (`packing.cut`), for the cost of a small bed. Step 1e-7 s, double precision, gravity. Warm-up and
measured steps are the same ones in all programs, from the same grains. They take turns: a round
has every bed, case, program and number of threads once. Rates are medians (smallest - largest) over the
rounds; a ratio is the median of the ratios of each round, of runs that are seconds apart (a minute in large beds, minutes
between two beds), since the machine's speed changes from minute to minute; every second round goes the other way round. Threads are clod's threads and the peers' MPI ranks.
Times are those of the steps alone, as each program measures them. Rounds can be
added to those that are there.

"""


def _rows(records, case, size):
    """Rows of one bed: clod first, each peer with its ratio to clod of as many threads."""
    runs = table.chosen(records, kind="speed", case=case, size=size)
    for threads in sorted({r["threads"] for r in runs}):
        ours = table.chosen(runs, program=plan.CLOD, threads=threads)
        for name in plan.programs(size, case):
            some = table.chosen(runs, program=name, threads=threads)
            if not some:
                continue
            ratio = kinetic = "-"
            contacts = f"{some[0]['coordination']:.3f}"
            if ours and name != plan.CLOD:
                ratio = f"{table.ratio(ours, some):.2f}"
                kinetic = f"{some[0]['kinetic_J'] / ours[0]['kinetic_J']:.2f}"
                if abs(some[0]["coordination"] / ours[0]["coordination"] - 1.0) > SAME_WORK:
                    contacts += " DIFFERS"
            yield [size, some[0]["grains"], name, threads, some[0]["steps"], some[0]["lists"],
                   len(some), table.spread(some), ratio, contacts, kinetic]


def _speed(records):
    text = ""
    for case, (title, _, _) in plan.CASES.items():
        rows = [row for size in plan.SIZES for row in _rows(records, case, size)]
        if rows:
            text += f"## Case {title}\n\n" + table.text(
                ["bed", "grains", "program", "threads", "steps", "lists made anew", "runs",
                 "million grain-steps/s", "clod / it", "coordination", "kinetic energy / clod's"],
                rows)
    return text and text + f"""Same work: the coordination numbers at the end of a run differ by at
most {100 * SAME_WORK:.0f} %, else DIFFERS. Kinetic energies differ where the laws do (docs/cross-code.md).
LAMMPS: gran/hertz/history has constants in place of a restitution, `damping tsuji` gives another
one, sds takes a stiffness of its own. LIGGGHTS edinburgh/stiffness takes k1 for the tangential
stiffness and for the dash-pots whatever n is, so its grains come to rest sooner; it takes all
adhesion away unless it is told limitForce off. That stiffness is why its plastic bed has 0.04 of
clod's kinetic energy at 30k: without friction the 4k bed has 81 times as much after 325 steps
(limitForce off). The memory that it loses when pairs change their order (docs/cross-code.md) is
not: no list is made anew here, and with atom_modify sort 0 0.0 its energy is the same in all ten digits.

"""


def _cost(records):
    """Cost against N, memory and scaling of clod."""
    rows = []
    for size in plan.SIZES:
        runs = table.chosen(records, kind="speed", size=size, case=plan.FULL, program=plan.CLOD)
        single = table.chosen(runs, threads=1)
        if single:
            contacts = 0.5 * single[0]["coordination"]
            ns = 1e9 / table.median(single, "rate")
            ratios = {threads: table.ratio(table.chosen(runs, threads=threads), single)
                      for threads in sorted({r["threads"] for r in runs})}
            more = [f"{threads}: {ratio:.2f}" for threads, ratio in ratios.items()
                    if threads > 1]
            rows.append([size, single[0]["grains"], f"{ns:.1f}", f"{ns / contacts:.1f}",
                         ", ".join(more) or "-"])
    return rows and ("## Cost against the number of grains, and strong scaling\n\n"
                     "clod, case c, one thread; speed-up by the number of threads.\n\n"
                     + table.text(["bed", "grains", "ns per grain and step",
                                   "ns per contact and step", "threads: speed-up"], rows)) or ""


def _memory(records):
    rows = []
    for size in plan.SIZES:
        for name in plan.programs(size, plan.FULL):
            kind = "memory" if name == plan.CLOD else "speed"
            runs = table.chosen(records, kind=kind, size=size, case=plan.FULL, program=name,
                                threads=1)
            each = targets.bytes_per_grain(records, size, name)
            if each:
                contacts = 0.5 * runs[0]["coordination"]
                stepped = "-"
                if name == plan.CLOD:
                    said = runs[0]["clod"]
                    grown = said["rss_stepped_kB"] - said["rss_empty_kB"]
                    stepped = f"{1024 * grown / runs[0]['grains']:.0f}"
                rows.append([size, name, f"{runs[0]['rss_kB'] / 1024:.0f}", f"{each:.0f}",
                             f"{each / contacts:.0f}", stepped])
    return rows and ("## Memory\n\nLargest resident memory on one core, case c. clod: less that of "
                     "its start, with all lists made anew\nand all histories moved out as for a "
                     "checkpoint; the last column before that. Peers: less that of the\n4k bed, "
                     "over the grains more.\n\n"
                     + table.text(["bed", "program", "MiB", "bytes per grain with its contacts",
                                   "per contact", "bytes per grain, stepping only"], rows)) or ""


def _stages(records):
    rows = []
    for size in plan.SIZES:
        runs = table.chosen(records, kind="stages", size=size)
        if runs:
            times = [r["clod"]["ns_per_grain_step"] for r in runs]
            names = list(times[0])
            rows.append((names, [size, *(f"{table.median(times, n):.2f}" for n in names)]))
    return rows and ("## Time of each stage\n\nclod, case c, one thread, ns per grain and step; "
                     "medians. A clock around each stage (`bench_step --stages`).\n\n"
                     + table.text(["bed", *rows[0][0]], [row for _, row in rows])) or ""


def text(records, system):
    """The whole page."""
    if not records:
        return "# clod beside its peers\n\nNothing was measured yet: `make bench-peers`.\n"
    return (_header(records, system) + targets.text(records) + _speed(records) + _cost(records)
            + _memory(records) + _stages(records) + roofline.text(records)).rstrip() + "\n"
