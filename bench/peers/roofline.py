"""How near the step comes to what the machine can do."""

import plan
import table
from machine import best

# Bytes that one step moves between the kernel and its arrays, and that lie there, by the layout
# of the arrays; all that is written has been read, as in the update of bench_machine. Of one
# thread: no contacts between parts. Rows of partners are counted once, as if they stayed in a
# cache until the last contact that needs them. THE ONE PLACE: change these with the arrays
# (src/state/contacts.h, src/state/grains.h, src/step/near.h).
# (what, moved per pair of the near list, moved per grain, kept per pair, kept per grain)
BYTES = [
    ("contact: rows of places, motion, turning, once (kernel_contact.h)", 0, 96, 0, 96),
    ("contact: two indices of a block, read (contacts.h)", 8, 0, 8, 0),
    ("contact: history, read and written (contacts.h)", 128, 0, 64, 0),
    ("contact: loads, read and written in place, once (kernel_contact.h)", 0, 128, 0, 64),
    ("drift and kick: all rows and loads, read and written (kernel_motion.h)", 0, 320, 0, 0),
]


def bytes_of(pairs, pair_column, grain_column):
    """Bytes per grain with so many pairs of the near list per grain."""
    return sum(row[pair_column] * pairs + row[grain_column] for row in BYTES)


def limits(operations, peaks, moved, bandwidth):
    """The shortest times that the units allow [ns per grain and step]."""
    sums = {kind: sum(f.get(kind, 0.0) for f in operations.values())
            for kind in ("flops", "divides", "roots")}
    return {"additions and multiplications": 1e9 * sums["flops"] / peaks["multiply_add"],
            "divides and roots": 1e9 * (sums["divides"] / peaks["divide"]
                                        + sums["roots"] / peaks["root"]),
            "bytes": 1e9 * moved / bandwidth}


def _home(machine, kept):
    """The smallest cache that holds so many bytes."""
    return ("L2" if kept <= machine["l2_bytes"] else
            "L3" if kept <= machine["l3_bytes"] else "memory")


def _machine_table(machine):
    rows = [[s["set"], *(f"{s[key] / 1e9:.1f}" for key in ("multiply_add", "fused")),
             *(f"{s[key] / 1e9:.2f}" for key in ("divide", "root"))] for s in machine["sets"]]
    levels = [[b["level"], f"{b['bytes'] / 2**20:.1f}", b["threads"],
               f"{b['bytes_per_s'] / 1e9:.1f}"] for b in machine["bandwidth"]]
    return (table.text(["set, one core", "10^9 multiplications and additions /s",
                        "the same fused", "10^9 divides /s", "10^9 roots /s"], rows)
            + table.text(["a = a + s b in", "MiB", "threads", "GB/s"], levels))


def _count_table(operations):
    rows = [[f"`{name}`", *(f"{kinds.get(kind, 0.0):.1f}" for kind in ("flops", "divides",
                                                                       "roots"))]
            for name, kinds in sorted(operations.items())]
    moved = [[what, pair, grain] for what, pair, grain, _, _ in BYTES]
    return (table.text(["function", "additions, multiplications, min, max per grain and step",
                        "divides", "roots"], rows)
            + table.text(["bytes moved in a step", "per pair of the near list", "per grain"],
                         moved))


def _share_rows(records, machine, operations):
    for size in plan.SIZES:
        runs = table.chosen(records, kind="speed", size=size, case=plan.FULL, program=plan.CLOD,
                            threads=1)
        peaks = [s for s in machine["sets"] if runs and s["set"] == runs[0]["clod"]["simd"]]
        if not peaks:
            continue
        pairs = runs[0]["clod"]["contacts_per_grain"] * runs[0]["clod"]["near_per_contact"]
        moved, kept = bytes_of(pairs, 1, 2), runs[0]["grains"] * bytes_of(pairs, 3, 4)
        home = _home(machine, kept)
        bandwidth = [b["bytes_per_s"] for b in machine["bandwidth"]
                     if b["level"] == home and b["threads"] == 1]
        found = limits(operations, peaks[0], moved, bandwidth[0])
        measured = 1e9 / table.median(runs, "rate")
        nearest = max(found, key=found.get)
        yield [size, f"{measured:.1f}", *(f"{t:.1f}" for t in found.values()), home,
               nearest, f"{100.0 * found[nearest] / measured:.0f} %"]


def _per_contact(records, operations):
    """What a contact alone asks for, in words: on the bed whose operations were counted."""
    runs = table.chosen(records, kind="speed", size="4k", case=plan.FULL, program=plan.CLOD)
    if not runs:
        return ""
    contacts = runs[0]["clod"]["contacts_per_grain"]
    near = runs[0]["clod"]["near_per_contact"]
    kinds = operations["kernel_contact"]
    pair = sum(row[1] for row in BYTES)
    return (f"A contact of the 4k bed ({contacts:.2f} a grain) asks for "
            f"{kinds['flops'] / contacts:.0f} additions, multiplications, minima and maxima, "
            f"{kinds['divides'] / contacts:.1f} divides and {kinds['roots'] / contacts:.1f} "
            f"roots,\nand moves {near * pair:.0f} bytes, and its part of its grains' "
            f"{sum(row[2] for row in BYTES)}.\n\n")


def text(records):
    """The section of the report, or nothing without measurements of the machine."""
    machine = [r["found"] for r in table.chosen(records, kind="machine")]
    operations = table.chosen(records, kind="count")
    if not machine or not operations:
        return ""
    machine, operations = best(machine), operations[-1]["found"]
    rows = list(_share_rows(records, machine, operations))
    return (f"""## Roofline

Measured by `bench_machine`, the best of several trials in each round; operations counted by valgrind instruction by
instruction (`bench/peers/count.py`; 4k bed, AVX2; all sets do the same arithmetic; comparisons,
selections and shuffles are not counted), bytes by the layout (`bench/peers/roofline.py`).

{_machine_table(machine)}{_count_table(operations)}"""
            + _per_contact(records, operations)
            + "Times are ns per grain and step of case c on one thread. A limit is what the step "
              "would take if\nonly these units worked, at their measured peak; the share is the "
              "largest limit over the measured time.\n\n"
            + table.text(["bed", "measured", "limit: additions, multiplications",
                          "limit: divides, roots", "limit: bytes", "bytes lie in",
                          "nearest limit", "attained"], rows))
