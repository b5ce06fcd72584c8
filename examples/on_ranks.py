"""One simulation on all processes of mpirun: two clouds of grains fly into each other. Alone, without
mpirun, it gives the same numbers.

    mpirun -n 4 python3 on_ranks.py
"""

import sys

import clod

CASE = """
materials: {glass: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}}
contacts: {default: {law: hertz, restitution: 0.5, friction: 0.3}}
gravity: [0 m/s2, 0 m/s2, 0 m/s2]
time: {design_stress: 1 kPa}
domain: {min: [0 mm, 0 mm, 0 mm], max: [80 mm, 30 mm, 30 mm], periodic: [true, true, true]}
grains:
  - {material: glass, count: 500, radius: {distribution: uniform, min: 1 mm, max: 1.5 mm},
     region: {box: {min: [0 mm, 0 mm, 0 mm], max: [80 mm, 30 mm, 30 mm]}}}
stages: [{name: all, duration: 1 s}]  # a case needs one; this program decides instead
"""


def collide(ranks):
    """The whole program, in one process; the others compute for it."""
    with clod.Simulation(text=CASE, ranks=ranks) as sim:
        left = sim.position[:, 0] < 0.04
        sim.velocity[left, 0], sim.velocity[~left, 0] = 1.0, -1.5
        before, first = (sim.mass * sim.velocity[:, 0]).sum(), sim.energies()["translation"]
        sim.advance(int(0.02 / sim.dt))
        after, last = (sim.mass * sim.velocity[:, 0]).sum(), sim.energies()["translation"]
    print(f"momentum {after:.12g} kg m/s, before it was {before:.12g}; "
          f"of the energy {last / first:.12g} is left")
    return int(abs(after / before - 1) > 1e-9 or last > 0.8 * first)


sys.exit(clod.on_ranks(collide))
