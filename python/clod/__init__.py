"""Discrete element simulation of cohesive bulk solids, from Python.

    import clod
    with clod.Simulation("case.yaml", threads=2) as sim:
        sim.advance(10000)
        print(sim.position[:, 2].max())     # m; NumPy views onto clod's own memory

    run = clod.results("run/copper-ore-5")  # a results folder, into arrays

SI units throughout. docs/python.md tells the rest.
"""

from ._library import CONTACT_UNITS, Error, Simulation, Wall
from ._results import Results, results

__all__ = ["CONTACT_UNITS", "Error", "Results", "Simulation", "Wall", "results"]
