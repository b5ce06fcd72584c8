"""Lines of bench_ranks, bench_step and bench_messages beside what the model says of them."""

import json
import os
import statistics
import sys

import constants
import geometry
import lattice
import model
import simulate
import tables

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "peers"))
import plan  # noqa: E402

MICRO, NANO = 1e6, 1e9
FITTED = 8  # ranks of a run, at most, that constants are fitted to


def read(path):
    """All JSON values of a file, one behind the other; other text between them is left out."""
    with open(path) as file:
        text = file.read()
    decoder, at, found = json.JSONDecoder(), text.find("{"), []
    while at >= 0:
        try:
            value, at = decoder.raw_decode(text, at)
            found.append(value)
        except json.JSONDecodeError:
            at += 1
        at = text.find("{", at)
    return found


def counts(values, c):
    """Those of bench_ranks, which the lattice gives exactly."""
    out = tables.head(["ranks", "grains", "", "imbalance", "ghosts a grain", "messages a rank and step",
                       "bytes a rank and step", "messages of a merge", "messages of a rebuild"])
    bytes_of = {"ghost": c.code_ghost, "order": c.code_order, "state": c.code_state}
    for said in values:
        edge = round(said["grains"] ** (1.0 / 3.0))
        if said["ranks"] < 2:
            continue
        guess = lattice.predict(edge, said["ranks"], bytes_of)
        merges = said["messages_of_collectives_a_step"] / said["collectives_a_step"]
        out.append(tables.line([
            said["ranks"], edge ** 3, "counted", said["imbalance"], said["ghosts_a_grain"],
            said["step"]["messages_a_rank"], said["step"]["bytes_a_rank"], f"{merges:.2f}",
            said["rebuild"]["messages_a_rank"]]))
        out.append(tables.line([
            "", "", "predicted", f"{guess['imbalance']:.3f}", f"{guess['ghosts']:.3f}",
            f"{guess['messages_a_rank']:.1f}", f"{guess['bytes_a_rank']:.0f}",
            f"{guess['messages_of_a_merge']:.2f}",
            f"{guess['rebuild_messages_least']:.0f} and those of contacts"]))
    return out


class Run:
    """One run of bench_step: its line, and those of its other ranks."""

    def __init__(self, said):
        self.said = said
        self.ranks, self.threads = said["ranks"], said["threads"]
        self.grains, self.step = said["grains"], said["seconds"] / said["steps"]
        self.own = said.get("own_rows", [self.grains])
        self.watched = [said["watched"]] if "watched" in said else []

    def each(self, name):
        return [some[name] / some["steps"] for some in self.watched]


def runs_of(values):
    """Runs of bench_step in a file, in order: lines of other ranks come behind or before the first's."""
    runs, loose = [], []
    for said in values:
        if "grain_steps_per_s" in said:
            runs.append(Run(said))
            while loose and len(runs[-1].watched) < runs[-1].ranks:
                runs[-1].watched.append(loose.pop(0))
            loose = []
        elif "watched" in said and runs and len(runs[-1].watched) < runs[-1].ranks:
            runs[-1].watched.append(said["watched"])
        elif "watched" in said:
            loose.append(said["watched"])
    return [run for run in runs if run.ranks == 1 or len(run.watched) == run.ranks]


def lengths_of(grains):
    """The box of a packing of bench/peers/plan.py, in grains; a cube where it is none."""
    edge = (plan.SOURCE_GRAINS) ** (1.0 / 3.0)
    for copies, _ in plan.SIZES.values():
        if round(plan.SOURCE_GRAINS * copies[0] * copies[1] * copies[2]) == grains:
            return [edge * n for n in copies]
    return [grains ** (1.0 / 3.0)] * 3


def predict(c, run):
    """Closed model and simulation of a run: us a step, us of work, ghosts of the rank that has most."""
    bed = geometry.Bed(run.grains, run.ranks, c.ghost_layers, lengths=lengths_of(run.grains))
    threads = max(run.threads, 1)
    workers = run.ranks * threads
    c = c.but(row=c.row / threads, ghost=c.ghost / threads, rebuild_steps=float("inf"),
              code_skin_merges=0.0, cores=c.cores)
    crowd = max(1.0, workers / c.cores)  # they take turns
    shared = c.but(row=c.row * crowd, ghost=c.ghost * crowd)
    shape = model.shape_of(shared, bed)
    step = model.step_time(shared, shape)
    row = model.row_time(c, shape.own + shape.ghosts, workers)
    work = shape.own * row + bed.mean_ghosts() * row * c.ghost / c.row
    return step, simulate.run(shared, bed, 10), work, bed


def steps(runs, c):
    """Those of bench_step."""
    out = tables.head(["grains", "ranks", "threads", "", "us a step", "simulation",
                       "work of a rank, us", "most over mean", "waiting, %", "ghosts of a rank, most",
                       "us without waiting and work"])
    for run in runs:
        step, simulation, work, bed = predict(c, run)
        cells = [tables.number(MICRO * run.step), "", "", "", "", "", ""]
        if run.watched:
            worked = run.each("worked_s")
            waited = statistics.mean(w["waited_s"] / w["wall_s"] for w in run.watched)
            left = statistics.mean((w["wall_s"] - w["waited_s"] - w["worked_s"]) / w["steps"]
                                   for w in run.watched)
            cells = [tables.number(MICRO * run.step), "",
                     tables.number(MICRO * statistics.mean(worked)),
                     f"{max(worked) / statistics.mean(worked):.3f}", f"{100 * waited:.0f}",
                     max(round(w["ghost_bytes_in"] / c.code_ghost) for w in run.watched),
                     tables.number(MICRO * left)]
        out.append(tables.line([run.grains, run.ranks, run.threads, "measured", *cells]))
        out.append(tables.line(["", "", "", "predicted", tables.number(MICRO * step),
                                tables.number(MICRO * simulation.step), tables.number(MICRO * work),
                                f"{c.imbalance:.3f}" if run.ranks > 1 else "",
                                f"{100 * simulation.waited / simulation.step:.0f}",
                                round(bed.most_ghosts()), ""]))
    return out


def messages(values, c):
    """Those of bench_messages."""
    out = tables.head(["test", "ranks", "pairs", "peers", "bytes", "measured, us (quartiles)",
                       "predicted, us"])
    for said in values:
        guess = message_guess(c, said)
        if guess is not None:
            out.append(tables.line([said["test"], said["ranks"], said["pairs"], said["peers"],
                                    said["bytes"],
                                    spread_of(said), tables.number(MICRO * guess)]))
    return out


def spread_of(said):
    return tables.spread([said["lower"], said["median"], said["upper"]])


def message_guess(c, said):
    """Seconds of a call on one node; None: the model says nothing of it."""
    one = c.latency_node + said["bytes"] / c.bandwidth_node
    if said["test"] == "pingpong":
        return one
    if said["test"] == "kept":
        return one + 2 * c.overhead
    if said["test"] == "merge":
        return model.merge_time(c, said["ranks"], said["bytes"])
    if said["test"] in ("halo", "meeting"):
        halo = one + 2 * said["peers"] * c.overhead
        merge = model.merge_time(c, said["ranks"], c.code_merge)
        return halo if said["test"] == "halo" else max(halo, merge + 2 * said["peers"] * c.overhead)
    return None


def fit(values):
    """Constants of a machine from runs of bench_step on a few ranks, and bench_messages on 2."""
    runs = [run for run in runs_of(values) if run.ranks <= FITTED and run.threads == 1]
    found = {}
    points = [(own, w["ghost_bytes_in"] / 72.0, w["worked_s"] / w["steps"])
              for run in runs for own, w in zip(run.own, run.watched)]
    if len(points) >= 2:
        found["row"], found["ghost"] = (NANO * x for x in least_squares(points))
    tests = {(s["test"], s["pairs"], s["bytes"]): s["median"] * 1e-6
             for s in values if s.get("ranks") == 2 and "median" in s}
    small, large = ("pingpong", "near", 8), ("pingpong", "near", 1 << 20)
    if small in tests and large in tests:
        found["latency_node"] = tests[small]
        found["bandwidth_node"] = large[2] / (tests[large] - tests[small])
        found["overhead"] = max(0.0, tests["kept", "near", 8] - tests[small]) / 2.0
    noise = [(s["upper"] - s["lower"]) / s["median"] / 1.349 for s in values
             if s.get("test") == "work" and s["ranks"] == 2]
    if noise:
        found["noise"] = noise[0]
    return found


def least_squares(points):
    """a and b of time = a own + b ghosts, each point weighed by its inverse time."""
    saa = sab = sbb = sat = sbt = 0.0
    for own, ghosts, time in points:
        a, b = own / time, ghosts / time
        saa, sab, sbb, sat, sbt = saa + a * a, sab + a * b, sbb + b * b, sat + a, sbt + b
    det = saa * sbb - sab * sab
    return (sat * sbb - sbt * sab) / det, (saa * sbt - sab * sat) / det


def report(path, machine):
    """All tables that a file has lines for."""
    values = read(path)
    c = constants.load(machine)
    parts = [("Counts of bench_ranks", counts([v for v in values if "ghosts_a_grain" in v], c)),
             ("bench_step", steps(runs_of(values), c)),
             ("bench_messages", messages([v for v in values if "median" in v], c))]
    return "\n\n".join("\n".join([f"{title}, machine `{machine}`:", "", *table])
                       for title, table in parts if len(table) > 2)
