"""What the machine is and can do, and what the kernel asks of it."""

import json
import os
import platform

import count
from programs import call

SOURCE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "packings",
                      "pack_4k")


def name():
    """Processor with its family and model, which tell generations apart; cores and memory."""
    found = {}
    with open("/proc/cpuinfo") as file:
        for line in file:
            key, _, value = line.partition(":")
            found.setdefault(key.strip(), value.strip())
    model = found.get("model name", platform.machine())
    if "cpu family" in found:
        model += f" (family {found['cpu family']}, model {found['model']})"
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{model}, {os.cpu_count()} cores, {memory:.0f} GiB"


def _take(book, version, record, ask):
    record = {"program": "clod", "version": version, "machine": name(), **record}
    if not book.has(record):
        print(f"{record['kind']} ...", flush=True)
        book.add({**record, "found": ask()})


def measure(bench, book, version, run):
    """Limits of the machine (bench_machine), once a round."""
    _take(book, version, {"kind": "machine", "run": run},
          lambda: json.loads(call([os.path.join(bench, "bench_machine")])[0]))


def operations(bench, book, version, grains):
    """Operations of the kernel (count.py)."""
    step = os.path.join(bench, "bench_step")
    _take(book, version, {"kind": "count"},
          lambda: count.kernel(step, [SOURCE + ".csv", SOURCE + ".box"], grains))


def best(found):
    """The best of what several rounds found of one machine, number by number."""
    kept = {**found[0], "sets": [dict(s) for s in found[0]["sets"]],
            "bandwidth": [dict(b) for b in found[0]["bandwidth"]]}
    for other in found[1:]:
        for mine, its in zip(kept["sets"], other["sets"]):
            for key in ("multiply_add", "fused", "divide", "root"):
                mine[key] = max(mine[key], its[key])
        for mine, its in zip(kept["bandwidth"], other["bandwidth"]):
            mine["bytes_per_s"] = max(mine["bytes_per_s"], its["bytes_per_s"])
    return kept
