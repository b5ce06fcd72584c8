"""A program of a user that sees and changes all that it can; what it saw as lines of text, every bit.

It is run alone and under mpirun (test_ranks.py): the lines must be the same.
"""

import hashlib
import os
import tempfile

import numpy

import clod

CASE = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: mepa, k1: 4.75e5 N/m^1.5, k2: 2.37e6 N/m^1.5, k_adh: 1e5 N/m^1.5,
                     restitution: 0.3, friction: 0.35}}
time: {step: 2e-6 s}
domain: {min: [0 mm, 0 mm, -5 mm], max: [40 mm, 20 mm, 100 mm], periodic: [true, true, false]}
stages: [{name: fall, duration: 0.02 s}]
walls:
  floor: {material: ore, shapes: [{box: {center: [20 mm, 10 mm, -1 mm], size: [60 mm, 40 mm, 2 mm]}}]}
  bar: {material: ore, shapes: [{box: {center: [9 mm, 10 mm, 60 mm], size: [4 mm, 40 mm, 4 mm]}}]}
grains:
  - {material: ore, count: 120, radius: {distribution: uniform, min: 1.8 mm, max: 2 mm},
     region: {box: {min: [0 mm, 0 mm, 2 mm], max: [40 mm, 20 mm, 30 mm]}},
     velocity: [0 m/s, 0.1 m/s, -0.5 m/s]}
gauges: {low: {region: {box: {min: [0 mm, 0 mm, 0 mm], max: [40 mm, 20 mm, 8 mm]}}, direction: [0, 0, -1]}}
output: {energy: true}
"""
ARRAYS = ("position", "velocity", "angular_velocity", "force", "torque", "radius", "mass",
          "inverse_inertia", "id", "material")


def digest(array):
    return hashlib.sha256(numpy.ascontiguousarray(array).tobytes()).hexdigest()[:16]


def look(sim):
    yield f"step {sim.step}, {len(sim)} grains"
    for name in ARRAYS:
        yield f"{name} {sim.array(name).shape} {digest(sim.array(name))}"
    contacts = sim.contacts()
    yield f"contacts {len(contacts)} {digest(contacts)}"
    for contact in contacts[::17]:
        one = sim.contact_of(contact["id_2"], contact["id_1"]) if contact["wall"] < 0 \
            else sim.wall_contact_of(contact["id_1"], list(sim.walls)[contact["wall"]])
        yield f"contact {contact} {one}"
    for name, wall in sim.walls.items():
        yield f"wall {name} {digest(wall.force)} {digest(wall.torque)} {digest(wall.position)}"
    for numbers in (sim.energies(), sim.measure(), sim.exchange(), sim.ledger()):
        yield " ".join(f"{key} {float(value).hex()}" for key, value in numbers.items())


def row(sim):
    return " ".join(f"{key} {float(value).hex()}" for key, value in sim.series_row().items())


def file(folder):
    with open(os.path.join(folder, "restart_a.h5"), "rb") as content:
        return hashlib.sha256(content.read()).hexdigest()


def life(ranks=None, text=CASE):
    """The lines of it."""
    with tempfile.TemporaryDirectory() as folder, \
            clod.Simulation(text=text, ranks=ranks, threads=1) as sim:
        lines = list(look(sim))
        sim.open_series()
        sim.advance(4000)
        lines += [*look(sim), row(sim)]
        sim.velocity[sim.position[:, 2] > 0.006] *= 0.5
        sim.add_grain(90000, [0.01, 0.01, 0.05], 1.9e-3, velocity=[0, 0, -1])
        sim.remove_grain(int(sim.id[3]))
        sim.advance(1500)
        sim.walls["bar"].velocity = [0.2, 0, -3]
        sim.walls["floor"].set_belt(0, speed=0.3, direction=[1, 0, 0])
        sim.advance(1500)
        sim.walls["bar"].position = [0, 0, 0]
        sim.add_wall("lid", {"material": "ore", "shapes": [
            {"box": {"center": "20 10 50 mm", "size": "40 40 2 mm"}}]})
        sim.change()
        sim.set_radii(1.001 * sim.radius)
        lines += [*look(sim), row(sim)]
        sim.write_checkpoint(folder)
        sim.write_snapshot(folder, contacts=True)
        lines += [file(folder)]
        sim.remove_wall("bar")
        sim.advance(1000)
        lines += [*look(sim)]
        sim.read_checkpoint(folder)
        sim.advance(1000)
        lines += [*look(sim), row(sim)]
        return lines
