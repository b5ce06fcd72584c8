"""Constants of the scaling model, by machine."""

import json
import os

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "constants.json")
CASES = ("low", "value", "high")  # best, likely and worst
COMPUTE = ("row", "far", "ghost", "row_bytes", "memory", "memory_core", "cache", "cache_all")


class Constants:
    """Numbers of a machine, the bed and the code, as attributes."""

    def __init__(self, numbers):
        self.__dict__.update(numbers)

    def but(self, **numbers):
        """The same with some other numbers."""
        return Constants({**self.__dict__, **numbers})


def machines():
    with open(FILE) as file:
        return sorted(json.load(file)["machines"])


def load(machine, case="value"):
    """Those of a machine by its name; `case` is one of CASES."""
    with open(FILE) as file:
        parts = json.load(file)
    if machine not in parts["machines"]:
        raise SystemExit(f"scaling-model: machine '{machine}' is unknown; there are "
                         f"{', '.join(sorted(parts['machines']))} (bench/scaling/constants.json)")
    numbers = {}
    for prefix, part in (("code_", parts["code"]), ("", parts["bed"]),
                         ("", parts["machines"][machine])):
        for name, entry in part.items():
            numbers[prefix + name] = entry.get(case, entry["value"])
    return Constants(numbers)


def mixed(machine, compute, rest):
    """Constants of computing of one case, and all others of another."""
    some = load(machine, compute)
    return load(machine, rest).but(**{name: getattr(some, name) for name in COMPUTE})
