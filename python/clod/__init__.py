"""Discrete element simulation of cohesive bulk solids, from Python.

    import clod
    with clod.Simulation("case.yaml", threads=2) as sim:
        sim.advance(10000)
        print(sim.position[:, 2].max())     # m; NumPy views onto clod's own memory

    run = clod.results("run/copper-ore-5")  # a results folder, into arrays

    clod.on_ranks(program)                  # one simulation on all processes of mpirun

SI units throughout. docs/python.md tells the rest.
"""

from ._library import CONTACT_UNITS, Error
from ._ranks import Ranks, on_ranks, ranks
from ._results import Results, results
from ._simulation import Simulation
from ._wall import Wall

__all__ = ["CONTACT_UNITS", "Error", "Ranks", "Results", "Simulation", "Wall", "on_ranks", "ranks",
           "results"]
