"""A bed on ranks, simulated step by step by engine.py: how long steps take, and how long ranks wait."""

import random
import statistics

import engine
import geometry
import model
import program

NANO = 1e-9


def plan_of(steps, rebuilds):
    """Words for the steps of program.run."""
    words = ["step"] * steps
    for k in range(rebuilds):
        words[(k + 1) * steps // (rebuilds + 1)] = "rebuild"
    return words


def works(c, bed, seed):
    """What each rank has to do; imbalance is spread evenly about 1, and noise is normal."""
    roll = random.Random(seed)
    spread = c.imbalance - 1.0
    outs = [[] for _ in range(bed.ranks)]
    for rank, some in enumerate(bed.ghosts):
        for other, count in some.items():
            outs[other].append((rank, count))
    found = []
    for rank, some in enumerate(bed.ghosts):
        ghosts = sum(some.values())
        row = model.row_time(c, bed.own + ghosts, bed.ranks)
        each = model.ghost_time(c, row)
        factor = 1.0 + roll.uniform(-spread, spread) if bed.ranks > 1 else 1.0
        noise = random.Random(roll.random())
        found.append(program.Work(
            outs=outs[rank], ins=list(some.items()),
            pack=factor * ghosts * each * c.pack_share / 2.0,
            unpack=factor * ghosts * each * c.pack_share / 2.0,
            rest=factor * (bed.own * row + ghosts * each * (1.0 - c.pack_share)),
            rebuild=factor * bed.own * c.rebuild * NANO,
            noise=lambda noise=noise: max(0.0, noise.gauss(1.0, c.noise))))
    return found


class Result:
    def __init__(self, simulation, ends, steps):
        self.step = max(ends) / steps  # s, mean
        self.waited = statistics.mean(rank.waited for rank in simulation.ranks) / steps
        self.inside = statistics.mean(end - rank.worked  # s in calls, waiting and all
                                      for end, rank in zip(ends, simulation.ranks)) / steps
        self.messages = simulation.messages / len(ends) / steps
        self.bytes = simulation.bytes / len(ends) / steps


def run(c, bed, steps=20, rebuilds=0, seed=1):
    """Seconds of a step and more, of a bed of geometry.py."""
    plan = plan_of(steps, rebuilds)
    programs = [program.run(rank, bed.ranks, c, work, plan)
                for rank, work in enumerate(works(c, bed, seed))]
    simulation = engine.Simulation(c, programs)
    ends = simulation.run()
    return Result(simulation, ends, steps)


def bed_of(c, grains, ranks, lengths=None):
    return geometry.Bed(grains, ranks, c.ghost_layers, lengths=lengths)
