"""A case whose surfaces share their names, with one grain of a mass of its own at rest on each of six.

Two meshes of one wall from two files with the parts `left` and `right`, and two belts of another wall, which stand
still. What a surface carries is the weight of its grain.
"""

import math

STIFFNESS, GRAVITY, DENSITY = 1e4, 10.0, 2500.0
# A plate of two parts of 100 by 100 mm side by side.
PLATE = """\
o left
v 0 0 0
v 100 0 0
v 100 100 0
v 0 100 0
f 1 2 3 4
o right
v 200 0 0
v 200 100 0
f 2 5 6 3
"""
CASE = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0}}
gravity: [0 m/s2, 0 m/s2, -10 m/s2]
time: {step: 2e-5 s, design_stress: 100 Pa}
domain: {min: [-0.1 m, -0.1 m, -0.2 m], max: [0.9 m, 0.4 m, 0.2 m], open: delete}
grains: [{material: ore, file: grains.csv}]
walls:
  plates:
    material: ore
    shapes:
      - mesh: {file: one.obj, unit: 1 mm}
      - mesh: {file: two.obj, unit: 1 mm, move: [0 m, 200 mm, 0 m]}
  belts:
    material: ore
    shapes:
      - belt: {from: [300 mm, 50 mm, 0 m], runs: [{length: 100 mm}], width: 100 mm, speed: 0 m/s}
      - belt: {from: [500 mm, 50 mm, 0 m], runs: [{length: 100 mm}], width: 100 mm, speed: 0 m/s}
build_up: {}
stages: [{name: run, duration: 4 ms}]
output: {series_interval: 2 ms, snapshot_interval: 2 ms, surfaces: true}
"""
# Surface, then place [mm] and radius [mm] of its grain.
GRAINS = {"plates.1.left": (50, 50, 4), "plates.1.right": (150, 50, 5), "plates.2.left": (50, 250, 6),
          "plates.2.right": (150, 250, 7), "belts.1.run 1": (350, 50, 8), "belts.2.run 1": (550, 50, 9)}


def mass(surface):
    """kg, of the grain on a surface."""
    return DENSITY * 4 / 3 * math.pi * (1e-3 * GRAINS[surface][2]) ** 3


def write(path, text=CASE, plate=PLATE):
    """The case with its files; path(name) is where a file goes."""
    for name, content in (("case.yaml", text), ("one.obj", plate), ("two.obj", plate)):
        with open(path(name), "w") as file:
            file.write(content)
    with open(path("grains.csv"), "w") as file:
        file.write("x [mm],y [mm],z [mm],radius [mm]\n")
        for surface, (x, y, radius) in GRAINS.items():
            sunk = 1e3 * mass(surface) * GRAVITY / STIFFNESS  # where the contact carries the weight
            file.write(f"{x},{y},{radius - sunk!r},{radius}\n")
