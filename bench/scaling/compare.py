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
FITTED = 2       # ranks of a run, at most, that constants are fitted to: more are predicted
CACHED = 4000    # grains of such a run, at most: in a core's own cache
LAW = "mepa"     # of the runs that are looked at


def values_of(text):
    """All JSON objects in a text, one behind the other; other text between them is left out. Of an object that
    holds the output of a program (`rows` as objects, `text`) come those of that output."""
    decoder, at, found = json.JSONDecoder(), text.find("{"), []
    while at >= 0:
        try:
            value, at = decoder.raw_decode(text, at)
        except json.JSONDecodeError:
            at += 1
            value = {}
        if "rows" in value:
            found += value["rows"]
        elif "text" in value:
            found += values_of(value["text"])
        else:
            found.append(value)
        at = text.find("{", at)
    return found


def read(paths):
    values = []
    for path in paths:
        try:
            with open(path) as file:
                values += values_of(file.read())
        except OSError as error:
            sys.exit(f"scaling-model: {path}: {error.strerror}")
    return values


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
        self.watched = []

    def each(self, name):
        return [some[name] / some["steps"] for some in self.watched]


def runs_of(values):
    """Runs of bench_step with ranks of one thread in a file, in order. Lines of other ranks come before or behind that of rank 0."""
    runs, loose = [], []
    for said in values:
        if "grain_steps_per_s" in said:
            runs.append(Run(said))
            runs[-1].watched = loose
            loose = []
        if "watched" in said:
            full = not runs or len(runs[-1].watched) >= runs[-1].ranks
            (loose if full else runs[-1].watched).append({"rank": said["rank"], **said["watched"]})
    return [run for run in runs if run.said["law"] == LAW and run.threads == 1 and
            (run.ranks == 1 or len(run.watched) == run.ranks)]


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
    crowd = max(1.0, run.ranks / c.cores)  # they take turns
    c = c.but(rebuild_steps=float("inf"))
    shared = c.but(row=c.row * crowd, far=c.far * crowd, ghost=c.ghost * crowd)
    shape = model.shape_of(shared, bed)
    step = model.step_time(shared, shape)
    row = model.row_time(c, shape.own + shape.ghosts, run.ranks)
    work = shape.own * row + bed.mean_ghosts() * model.ghost_time(c, row)
    return step, simulate.run(shared, bed, 10), work, bed


def measured(runs, c):
    """Medians of runs of one bed on as many ranks, with least and most: cells of a line."""
    def middle(values):
        return tables.spread([statistics.median(values), min(values), max(values)])

    cells = [f"measured, {len(runs)}", middle([MICRO * run.step for run in runs]), "", "", "", "", ""]
    if runs[0].watched:
        work = [statistics.mean(run.each("worked_s")) for run in runs]
        most = [max(run.each("worked_s")) / mean for run, mean in zip(runs, work)]
        inside = [statistics.mean(w["waited_s"] / w["wall_s"] for w in run.watched) for run in runs]
        cells[3:] = [middle([MICRO * mean for mean in work]), middle(most),
                     middle([100 * share for share in inside]),
                     max(round(w["ghost_bytes_in"] / c.code_ghost) for w in runs[0].watched)]
    return cells


def steps(runs, c):
    """Those of bench_step."""
    out = tables.head(["grains", "ranks", "", "us a step", "simulation", "work of a rank, us",
                       "most over mean", "in messages, %", "ghosts of a rank, most"])
    groups = {}
    for run in runs:
        groups.setdefault((run.grains, run.ranks), []).append(run)
    for (grains, ranks), some in sorted(groups.items()):
        step, simulation, work, bed = predict(c, some[0])
        out.append(tables.line([grains, ranks, *measured(some, c)]))
        out.append(tables.line(["", "", "predicted", tables.number(MICRO * step),
                                tables.number(MICRO * simulation.step), tables.number(MICRO * work),
                                f"{c.imbalance:.2f}" if ranks > 1 else "",
                                f"{100 * simulation.inside / simulation.step:.0f}",
                                round(bed.most_ghosts())]))
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
    return tables.spread([said["median"], said["lower"], said["upper"]])


def message_guess(c, said):
    """Seconds of a call on one node; None: the model says nothing of it."""
    size, peers, ranks = said["bytes"], said["peers"], said["ranks"]
    asks = 3 if size > c.eager else 1
    if said["test"] == "pingpong":
        return asks * c.latency_node + size / c.bandwidth_node
    if said["test"] == "merge":
        return model.merge_time(c, ranks, size)
    if said["test"] not in ("kept", "halo", "meeting"):
        return None
    calls = model.call_time(c, peers, size) + c.meeting
    flight = asks * c.latency_node + peers * size / c.bandwidth_node
    merge = model.merge_time(c, ranks, c.code_merge) if said["test"] == "meeting" else 0.0
    return calls + max(flight, merge)


def work_points(runs):
    """Own rows, ghosts and seconds of work a step, of ranks of one thread in beds that stay in the cache."""
    points = []
    for run in runs:
        if run.ranks > FITTED or run.grains > CACHED:
            continue
        if run.ranks == 1:
            points.append((run.grains, 0.0, run.said.get("processor_s", run.said["seconds"])
                           / run.said["steps"]))
        points += [(run.own[w["rank"]], w["ghost_bytes_in"] / 72.0, w["worked_s"] / w["steps"])
                   for w in run.watched]
    return points


def fit(values, c):
    """Constants of a machine from runs of bench_step on a few ranks, and bench_messages on 2."""
    runs = runs_of(values)
    points = work_points(runs)
    found = {}
    if len(points) >= 2 and len({ghosts / own for own, ghosts, _ in points}) > 1:
        found["row"], found["ghost"] = (NANO * x for x in least_squares(points))
    tests = {(s["test"], s["pairs"], s["bytes"]): s["median"] * 1e-6
             for s in values if s.get("ranks") == 2 and "median" in s}
    small, large = ("pingpong", "near", 8), ("pingpong", "near", 1 << 20)
    if small in tests and large in tests:
        found["latency_node"] = tests[small]
        found["meeting"] = max(0.0, tests["kept", "near", 8] - tests[small])
    halos = {(s["ranks"], s["bytes"]): (s["median"] * 1e-6, s["peers"]) for s in values
             if s.get("test") == "halo"}
    most = max((ranks for ranks, _ in halos), default=0)
    if most > 2:  # the slope over peers; longer ones ask first, and are copied
        short, peers = halos[most, 1 << 10]
        middle, long = halos[most, 1 << 13][0], halos[most, 1 << 16][0]
        found["overhead"] = (short - found["latency_node"] - found["meeting"]) / (2.0 * (peers - 1))
        found["bandwidth_node"] = peers * ((1 << 16) - (1 << 13)) / (long - middle)
        copy = peers * ((1 << 13) - (1 << 10)) / found["bandwidth_node"]
        found["overhead_long"] = max(0.0, middle - short - copy) / (2.0 * peers)
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


def report(paths, machine, fitted):
    """All tables that files have lines for; `fitted`: with the constants that they give themselves."""
    values = read(paths)
    c = constants.load(machine)
    if fitted:
        c = c.but(**fit(values, c))
    parts = [("Counts of bench_ranks", counts([v for v in values if "ghosts_a_grain" in v], c)),
             ("bench_step", steps(runs_of(values), c)),
             ("bench_messages", messages([v for v in values if "median" in v], c))]
    return "\n\n".join("\n".join([f"{title}, machine `{machine}`:", "", *table])
                       for title, table in parts if len(table) > 2)
