"""The tables of docs/scaling.md, in Markdown."""

import constants
import evenness
import model
import simulate

GRAINS = (1e6, 1e8, 1e9)
RANKS = (128, 512, 2048, 8192)
WEAK = (1000, 10000, 100000)  # grains a core
LEAST = 100                   # grains a core, below which nobody runs
WANTED = (0.8, 0.5)           # efficiencies
SEEDS, MANY = (1, 2, 3), 1024  # of simulations; ranks, of more of which one is enough
MICRO = 1e6


def number(value):
    """Three digits, without an exponent where it is short."""
    if value == float("inf"):
        return "never"
    text = f"{value:.3g}"
    return f"{value:.0f}" if "e" in text and value < 1e6 else text


def spread(values):
    """The first (least - most)."""
    low, high = min(values), max(values)
    if low == high:
        return number(low)
    return f"{number(values[0])} ({number(low)} - {number(high)})"


def cases(machine):
    """Constants: the likely ones, and all pairs of best and worst of computing and of the rest."""
    return [constants.load(machine)] + [constants.mixed(machine, compute, rest)
                                        for compute in ("low", "high") for rest in ("low", "high")]


def largest(parts):
    """The largest part beside own rows, and its share."""
    name = max((key for key in parts if key != "own rows"), key=lambda key: parts[key])
    return f"{name} {100 * parts[name] / sum(parts.values()):.0f} %"


def row(machine, grains, ranks):
    """Cells: grains a core, us a step, efficiency, largest part."""
    many = cases(machine)
    shapes = [model.shape_for(c, grains, ranks) for c in many]
    times = [MICRO * model.step_time(c, s) for c, s in zip(many, shapes)]
    shares = [100 * model.efficiency(c, s) for c, s in zip(many, shapes)]
    return [number(grains / ranks), spread(times), spread(shares),
            largest(model.step_parts(many[0], shapes[0]))]


def line(cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def head(names):
    return [line(names), "|" + "---|" * len(names)]


def strong(machine):
    out = head(["grains", "cores", "grains a core", "us a step", "efficiency, %",
                "largest part beside own rows"])
    for grains in GRAINS:
        for ranks in RANKS:
            if grains / ranks >= LEAST:
                out.append(line([f"{grains:.0e}".replace("e+0", "e"), ranks,
                                 *row(machine, grains, ranks)]))
    return out


def weak(machine):
    out = head(["grains a core", "cores", "us a step", "efficiency, %",
                "largest part beside own rows"])
    for each in WEAK:
        for ranks in RANKS:
            out.append(line([each, ranks, *row(machine, each * ranks, ranks)[1:]]))
    return out


def parts(machine, each=10000):
    """Where the time of a step goes."""
    c = constants.load(machine)
    names = list(model.step_parts(c, model.shape_for(c, 1e4, 1)))
    out = head(["us of a step", *names])
    for ranks in (1, *RANKS):
        some = model.step_parts(c, model.shape_for(c, each * ranks, ranks))
        out.append(line([f"{ranks} core{'s' if ranks > 1 else ''}, {each} grains each",
                         *(number(MICRO * some[name]) for name in names)]))
    return out


def grains_a_core(machine):
    out = head(["cores", *(f"grains a core for {100 * wanted:.0f} %" for wanted in WANTED)])
    for ranks in RANKS:
        out.append(line([ranks, *(spread([model.grains_for(c, ranks, wanted)
                                          for c in cases(machine)]) for wanted in WANTED)]))
    return out


def job(machine):
    """What happens beside the steps."""
    many = cases(machine)
    c = many[0]
    out = head(["grains", "cores", "GB a rank, while made", "of its node", "s to make (in layers) and deal",
                "s a checkpoint through rank 0", "of the run, one an hour, %"])
    for grains in GRAINS:
        for ranks in RANKS:
            if grains / ranks < LEAST:
                continue
            writes = [model.checkpoint_time(some, grains, ranks) for some in many]
            share = 100 * writes[0] / (writes[0] + c.checkpoint_every)
            held = grains / ranks * c.code_deal
            out.append(line([f"{grains:.0e}".replace("e+0", "e"), ranks, number(held / 1e9),
                             f"{100 * held * min(ranks, c.cores) / c.memory_node:.0f} %",
                             number(model.deal_time(c, grains, ranks)), spread(writes),
                             number(share)]))
    return out


def simulated(machine, each, many_ranks, steps=5):
    """Closed model beside the simulation, without rebuilds."""
    c = constants.load(machine).but(rebuild_steps=float("inf"))
    out = head(["cores", "grains a core", "us a step, model", "with boxes as cut", "simulation",
                "of it waiting"])
    for ranks in many_ranks:
        bed = simulate.bed_of(c, each * ranks, ranks)
        seeds = SEEDS if ranks <= MANY else SEEDS[:1]
        runs = [simulate.run(c, bed, steps, seed=seed) for seed in seeds]
        step = sorted(run.step for run in runs)
        out.append(line([ranks, each,
                         number(MICRO * model.step_time(c, model.shape_for(c, each * ranks, ranks))),
                         number(MICRO * model.step_time(c, model.shape_of(c, bed))),
                         spread([MICRO * step[len(step) // 2], MICRO * step[0], MICRO * step[-1]]),
                         f"{100 * runs[0].waited / runs[0].step:.0f} %"]))
    return out


def heap(count, many_ranks):
    points = evenness.heap(count)
    out = head(["ranks", "points a rank", "most over mean", "with 16 384 blocks"])
    for ranks in many_ranks:
        out.append(line([ranks, number(len(points) / ranks),
                         *(f"{evenness.most_over_mean(points, ranks, blocks):.2f}"
                           for blocks in (None, evenness.LEAST))]))
    return out
