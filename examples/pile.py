"""Grains fall onto a floor between periodic sides and come to rest: the floor carries their weight,
and the heap's profile is read from the positions."""

import sys

import numpy

import clod

CASE = """
materials: {glass: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}}
contacts: {default: {law: hertz, restitution: 0.3, friction: 0.2}}
domain: {min: [0 mm, 0 mm, -1 mm], max: [20 mm, 20 mm, 200 mm], periodic: [true, true, false]}
stages: [{name: all, duration: 1 s}]  # a case needs one; this program decides instead
walls: {floor: {material: glass, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}}
grains:
  - {material: glass, count: 100, radius: {distribution: uniform, min: 1.8 mm, max: 2.2 mm},
     region: {box: {min: [0 mm, 0 mm, 0 mm], max: [20 mm, 20 mm, 60 mm]}}}
"""

with clod.Simulation(text=CASE) as sim:
    sim.advance(int(0.5 / sim.dt))
    sim.reset_wall_means()
    sim.advance(int(0.1 / sim.dt))
    carried = -sim.walls["floor"].mean_force[2]
    weight = 9.81 * sim.mass.sum()
    layers, _ = numpy.histogram(sim.position[:, 2], bins=numpy.arange(0, 0.03, 0.004))
    print("grains in layers of 4 mm:", *layers)
    print(f"the floor carries {carried:.5f} N, the grains weigh {weight:.5f} N")
sys.exit(int(abs(carried / weight - 1) > 0.01))
