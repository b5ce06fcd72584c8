"""
Part 2: a sheared bed. Grains fall into a trough whose floor moves along x, where everything
repeats, between two walls at rest that hold the bed back: a steady flow with stresses that only
the grains decide. Trajectories of different programs part within milliseconds, so means over
time are compared, and their scatter between seeds says how well they must agree.
"""

import os

import h5py
import numpy

import arrangement
import laws
import peers
import programs

SEEDS = range(1, 7)
T_LIMIT = 4.587  # Student's t, 10 degrees of freedom, two-sided 0.1 %: one false alarm in 70 runs
GRAINS = (8, 9)  # along x and y; 14 layers
LAYERS = 14
LENGTH, WIDTH = 0.050, 0.060  # m
SIDE_HEIGHT = 0.040  # m, nominal height of the area of the side walls
FLOOR_SPEED = 0.3  # m/s
GRAVITY = 9.81  # m/s2
FRICTION, RESTITUTION = 0.4, 0.5
STEP = 1.5e-5  # s, 8 % of the Rayleigh time of the smallest grain
START, END = 0.3, 1.05  # s, of the means
FRAME = 0.015  # s between two snapshots
SLAB = (0.010, 0.030)  # m, height over which the solid fraction is measured

QUANTITIES = {  # name: unit
    "stress on the floor, normal": "Pa", "stress on the floor, shear": "Pa",
    "stress on the side walls, normal": "Pa", "coordination number": "1",
    "solid fraction": "1", "mean velocity of the grains along x": "m/s",
    "root mean square of the spins": "rad/s"}


def grains_of(seed):
    """Loose layers above the floor, disturbed."""
    rng = numpy.random.RandomState(seed)
    counts = numpy.array([*GRAINS, LAYERS])
    spacing = numpy.array([LENGTH / GRAINS[0], WIDTH / GRAINS[1], 6.6e-3])
    place = numpy.stack(numpy.meshgrid(*map(numpy.arange, counts), indexing="ij"), -1)
    place = (place.reshape(-1, 3) + 0.5) * spacing
    n = len(place)
    radius = arrangement.RADIUS * rng.uniform(0.7, 1.0, n)  # wide enough not to crystallise
    velocity = rng.uniform(-0.2, 0.2, (n, 3))
    return arrangement.Arrangement([LENGTH, WIDTH, 2.0 * LAYERS * spacing[2]], place, radius,
                                   velocity, periodic=(True, False, False))


# ---- from snapshots and wall forces to quantities

def contacts(place, radius):
    """Pairs of grains that overlap."""
    apart = place[:, None, :] - place[None, :, :]
    apart[..., 0] -= LENGTH * numpy.round(apart[..., 0] / LENGTH)
    reach = (radius[:, None] + radius[None, :]) ** 2
    return (numpy.count_nonzero((apart**2).sum(-1) < reach) - len(radius)) // 2


def below(height, place, radius):
    """Volume of the grains below a height."""
    h = numpy.clip(height - place[:, 2] + radius, 0.0, 2.0 * radius)
    return (numpy.pi * h**2 * (radius - h / 3.0)).sum()


def frame_means(frames):
    """Means over snapshots: frames of (place, radius, velocity, spin), in any order of rows."""
    volume = LENGTH * WIDTH * (SLAB[1] - SLAB[0])
    rows = [[2.0 * contacts(place, radius) / len(radius),
             (below(SLAB[1], place, radius) - below(SLAB[0], place, radius)) / volume,
             velocity[:, 0].mean(), numpy.sqrt((spin**2).sum(1).mean())]
            for place, radius, velocity, spin in frames]
    return list(numpy.mean(rows, axis=0))


def wall_means(floor_x, floor_z, low_y, high_y):
    """Stresses from the mean forces of the grains on the walls [N]."""
    area = LENGTH * WIDTH
    return [-floor_z / area, floor_x / area, 0.5 * (high_y - low_y) / (LENGTH * SIDE_HEIGHT)]


# ---- clod

WALLS = """walls:
  floor: {{material: grain, surface_velocity: [{speed} m/s, 0, 0],
          shapes: [{{plane: {{point: [0, 0, 0], normal: [0, 0, 1]}}}}]}}
  low: {{material: grain, shapes: [{{plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}}}]}}
  high: {{material: grain,
         shapes: [{{plane: {{point: [0, {width} m, 0], normal: [0, -1, 0]}}}}]}}"""


def clod(folder, grains):
    law = laws.hertz(FRICTION, RESTITUTION)
    walls = WALLS.format(speed=programs.number(FLOOR_SPEED), width=programs.number(WIDTH))
    output = f", series_interval: 1 ms, snapshot_interval: {FRAME} s"
    text = programs.clod_case(grains, law, round(END / STEP), STEP, (0.0, 0.0, -GRAVITY), walls,
                              output)
    programs.clod_run(folder, text, grains)
    out = os.path.join(folder, "out")
    series = numpy.genfromtxt(os.path.join(out, "series.csv"), delimiter=",", names=True,
                              deletechars="")
    late = series[series["time_[s]"] > START]
    column = {wall: [late[f"{wall}.force_{axis}_[N]"].mean() for axis in "xyz"]
              for wall in ("floor", "low", "high")}
    walls = wall_means(column["floor"][0], column["floor"][2], column["low"][1],
                       column["high"][1])
    frames = []
    for name in sorted(os.listdir(out)):
        if name.startswith("snap_"):
            with h5py.File(os.path.join(out, name), "r") as file:
                if file.attrs["time_s"] > START:
                    data = file["VTKHDF/PointData"]
                    frames.append((file["VTKHDF/Points"][:], data["radius"][:].ravel(),
                                   data["velocity"][:], data["omega"][:]))
    return walls + frame_means(frames)


# ---- the peers

def walls_liggghts(law):
    model = f"wall/gran model {law['model']} primitive type 1"
    lines = [f"fix floor all {model} zplane 0.0 shear x {FLOOR_SPEED} store_force yes",
             f"fix low all {model} yplane 0.0 store_force yes",
             f"fix high all {model} yplane {WIDTH} store_force yes"]
    sums = {"floorx": "f_force_floor[1]", "floorz": "f_force_floor[3]",
            "lowy": "f_force_low[2]", "highy": "f_force_high[2]"}
    return lines, sums


def walls_lammps(law):
    model = "wall/gran granular " + law["pair"].split("* * ")[1]
    lines = [f"fix floor all {model} zplane 0.0 NULL shear x {FLOOR_SPEED} contacts",
             f"fix low all {model} yplane 0.0 NULL contacts",
             f"fix high all {model} yplane NULL {WIDTH} contacts"]
    sums = {"floorx": "f_floor[2]", "floorz": "f_floor[4]", "lowy": "f_low[3]",
            "highy": "f_high[3]"}
    return lines, sums


def peer(name, folder, grains):
    law = laws.hertz(FRICTION, RESTITUTION)
    lines, sums = (walls_liggghts if name == "liggghts" else walls_lammps)(law)
    lines += [f"compute {key} all reduce sum {what}" for key, what in sums.items()]
    names = " ".join("c_" + key for key in sums)
    lines += [f"fix gravity all gravity {GRAVITY} vector 0.0 0.0 -1.0",
              f"fix mean all ave/time 5 10 50 {names} file walls.txt"]
    peers.run(name, folder, grains, law, [([], round(END / STEP))], STEP, round(FRAME / STEP),
              lines)
    rows = numpy.loadtxt(os.path.join(folder, "walls.txt"))
    forces = -rows[rows[:, 0] * STEP > START, 1:].mean(axis=0)  # on the walls
    frames = [(s.place, grains.radius, s.velocity, s.spin) for time, s in
              peers.read_frames(os.path.join(folder, "state.dump")) if time * STEP > START]
    return wall_means(*forces) + frame_means(frames)


def run(folder, names):
    """Means of every quantity for clod, the named peers and every seed: [seed, quantity] each."""
    found = {name: [] for name in ("clod", *names)}
    for seed in SEEDS:
        grains = grains_of(seed)
        here = os.path.join(folder, f"bed-{seed}")
        found["clod"].append(clod(os.path.join(here, "clod"), grains))
        for name in names:
            found[name].append(peer(name, os.path.join(here, name), grains))
    return {name: numpy.array(rows) for name, rows in found.items()}


def compare(found, name, quantities=None):
    """Rows of (quantity, unit, clod, peer, difference, limit); quantities: unit by name."""
    ours, theirs = found["clod"], found[name]
    scatter = numpy.sqrt((ours.var(0, ddof=1) + theirs.var(0, ddof=1)) / len(ours))
    return [(quantity, unit, ours[:, k].mean(), theirs[:, k].mean(),
             abs(ours[:, k].mean() - theirs[:, k].mean()), T_LIMIT * scatter[k])
            for k, (quantity, unit) in enumerate((quantities or QUANTITIES).items())]
