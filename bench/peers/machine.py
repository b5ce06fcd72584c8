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


def measure(bench, book, version, grains):
    """Limits of the machine (bench_machine) and operations of the kernel (count.py)."""
    step = os.path.join(bench, "bench_step")
    asked = {"machine": lambda: json.loads(call([os.path.join(bench, "bench_machine")])[0]),
             "count": lambda: count.kernel(step, [SOURCE + ".csv", SOURCE + ".box"], grains)}
    for kind, ask in asked.items():
        record = {"kind": kind, "program": "clod", "version": version, "machine": name()}
        if not book.has(record):
            print(f"{kind} ...", flush=True)
            book.add({**record, "found": ask()})
