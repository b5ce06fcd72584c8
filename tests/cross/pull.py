"""
Part 3: a cohesive bed between two planes. Grains that fly about in a box are pressed together by
its lid, held, and pulled apart. No periods, for LIGGGHTS' law forgets there (docs/cross-code.md);
the lid is a plane in clod and two triangles in LIGGGHTS. Six packings, the same starting places
in both programs; their scatter says how well the means must agree.
"""

import os

import numpy

import arrangement
import bed
import laws
import peers
import programs

PEER = "liggghts"
SEEDS = range(1, 7)
GRAINS = (10, 10, 10)
SIDE = 0.060  # m, of the square base
HEIGHT = 0.060  # m, of the lid at the start
K_1, K_2, K_ADH = 2e3, 1e4, 2e3  # N/m
FRICTION, RESTITUTION = 0.3, 0.5
STEP = 1e-5  # s, 1/20 of a collision of the smallest grains on k2
FAST, SLOW, GENTLE = 0.4, 0.1, 0.01  # m/s, of the lid
MOTION = (  # of the lid: name, steps, speed upwards
    ("press", 5000, -FAST), ("slow", 2500, -SLOW), ("hold", 2000, 0.0),
    ("relieve", 1000, GENTLE), ("pull", 4000, SLOW))
ENDS = numpy.cumsum([count for _, count, _ in MOTION])  # steps
HEIGHTS = HEIGHT + STEP * numpy.cumsum([count * speed for _, count, speed in MOTION])  # m, then
PRESSED, HELD = ENDS[1], ENDS[2]
LEVELS = (0.0385, 0.038, 0.0376)  # m, heights at which the stress is compared
BAND = 1e-4  # m, above and below
MEAN = 50  # steps, over which forces are means
FRAME = 500  # steps between two snapshots; the end of the hold is one
RELIEF = 4e-5  # m, of the way up over which the slope is taken

QUANTITIES = {
    **{f"stress on the lid at {1e3 * level:g} mm": "Pa" for level in LEVELS},
    "stress on the lid while held": "Pa", "stress on the floor while held": "Pa",
    "coordination number while held": "1", "rise of stress per way of the lid when pressed": "MPa/m",
    "fall of stress per way of the lid when relieved": "MPa/m",
    "largest tension": "Pa", "work of tension over the base": "J/m2"}


def grains_of(seed):
    """Grains of a loose lattice that fly about."""
    rng = numpy.random.RandomState(seed)
    counts = numpy.array(GRAINS)
    place = numpy.stack(numpy.meshgrid(*map(numpy.arange, counts), indexing="ij"), -1)
    place = (place.reshape(-1, 3) + 0.5) * numpy.array([SIDE, SIDE, HEIGHT]) / counts
    n = len(place)
    radius = arrangement.RADIUS * rng.uniform(0.7, 0.999, n)  # wide enough not to crystallise
    velocity = rng.uniform(-0.5, 0.5, (n, 3))
    return arrangement.Arrangement([SIDE, SIDE, 1.1 * HEIGHT], place, radius, velocity,
                                   periodic=(False, False, False))


def law():
    return laws.mepa(1, K_1, K_2, K_ADH, FRICTION, RESTITUTION)


# ---- from the forces on lid and floor to quantities

def contacts(place, radius):
    """Pairs of grains that overlap."""
    apart = ((place[:, None, :] - place[None, :, :]) ** 2).sum(-1)
    return (numpy.count_nonzero(apart < (radius[:, None] + radius[None, :]) ** 2)
            - len(radius)) // 2


def quantities(step, lid, floor, place, radius):
    """
    step: [rows] at which the forces are known. lid, floor: [rows] stress, compression positive
    [Pa]. place: of the grains at the end of the hold.
    """
    height = numpy.interp(step, [0, *ENDS], [HEIGHT, *HEIGHTS])
    slow = (step > ENDS[0]) & (step <= PRESSED)
    found = [lid[slow & (abs(height - level) <= BAND)].mean() for level in LEVELS]
    held = (step > (PRESSED + HELD) / 2) & (step <= HELD)
    found += [lid[held].mean(), floor[held].mean(), 2.0 * contacts(place, radius) / len(radius)]
    up = step > HELD
    for part in (slow & (height <= max(LEVELS)), up & (height <= HEIGHTS[2] + RELIEF)):
        found.append(-1e-6 * numpy.polyfit(height[part], lid[part], 1)[0])
    tension = numpy.maximum(-lid, 0.0)[up]
    return found + [tension.max(), numpy.trapz(tension, height[up])]


# ---- clod

def _plane(point, normal):
    place = programs.vector(point, "m")
    return f"{{plane: {{point: {place}, normal: {list(normal)}}}}}"


def clod(folder, grains):
    sides = ", ".join(_plane(point, normal) for point, normal in (
        ((0, 0, 0), (1, 0, 0)), ((SIDE, 0, 0), (-1, 0, 0)), ((0, 0, 0), (0, 1, 0)),
        ((0, SIDE, 0), (0, -1, 0))))
    walls = f"""walls:
  sides: {{material: grain, shapes: [{sides}]}}
  floor: {{material: grain, shapes: [{_plane((0, 0, 0), (0, 0, 1))}]}}
  lid: {{material: grain, velocity: [0, 0, {-FAST} m/s],
        shapes: [{_plane((0, 0, HEIGHT), (0, 0, -1))}]}}"""
    stages = "".join(
        f"\n  - {{name: {name}, duration: {programs.number(count * STEP)} s, "
        f"walls: {{lid: {{velocity: [0, 0, {speed} m/s]}}}}}}" for name, count, speed in MOTION)
    every = programs.number(MEAN / 10 * STEP)
    output = f", series_interval: {every} s, snapshot_interval: {programs.number(FRAME * STEP)} s"
    text = programs.clod_case(grains, law(), 0, STEP, walls=walls, output=output, stages=stages)
    programs.clod_run(folder, text, grains)
    out = os.path.join(folder, "out")
    rows = numpy.genfromtxt(os.path.join(out, "series.csv"), delimiter=",", names=True,
                            deletechars="")
    step = numpy.rint(rows["time_[s]"] / STEP)
    lid, floor = (sign * rows[f"{wall}.force_z_[N]"] / SIDE**2
                  for wall, sign in (("lid", 1.0), ("floor", -1.0)))
    ends = numpy.arange(MEAN, ENDS[-1] + 1, MEAN)
    window = numpy.ceil(step / MEAN) * MEAN
    means = [numpy.array([column[window == end].mean() for end in ends])
             for column in (lid, floor)]
    return ends, *means, _held_places(out, grains)


def _held_places(out, grains):
    """Places of clod's grains at the end of the hold, in the order of their ids."""
    time = HELD * STEP
    for name in sorted(os.listdir(out)):
        if name.startswith("snap_"):
            with bed.h5py.File(os.path.join(out, name), "r") as file:
                if abs(file.attrs["time_s"] - time) <= 2.5 * STEP:
                    order = numpy.argsort(file["VTKHDF/PointData/id"][:].ravel())
                    return file["VTKHDF/Points"][:][order]
    raise programs.ProgramError(f"{out}: no snapshot at the end of the hold, {time} s")


# ---- the peer

STL = """solid lid
{facets}endsolid lid
"""


def _write_lid(path):
    """Two triangles over the box and a little more, that look down."""
    low, high = -0.1 * SIDE, 1.1 * SIDE
    corners = [(low, low), (high, low), (high, high), (low, high)]
    facets = ""
    for picked in ((0, 2, 1), (0, 3, 2)):
        points = "".join(f"vertex {corners[k][0]} {corners[k][1]} {HEIGHT}\n" for k in picked)
        facets += f"facet normal 0 0 -1\nouter loop\n{points}endloop\nendfacet\n"
    with open(path, "w") as file:
        file.write(STL.format(facets=facets))


def peer(folder, grains):
    os.makedirs(folder, exist_ok=True)
    _write_lid(os.path.join(folder, "lid.stl"))
    model, settings = law()["model"].split(" fixKc ")
    model = f"wall/gran model {model}"
    settings = "fixKc " + settings  # behind what the wall is
    lines = ["fix plate all mesh/surface/stress file lid.stl type 1",
             f"fix lid all {model} mesh n_meshes 1 meshes plate {settings}",
             f"fix floor all {model} primitive type 1 zplane 0.0 store_force yes {settings}"]
    lines += [f"fix side{k} all {model} primitive type 1 {axis}plane {place} {settings}"
              for k, (axis, place) in enumerate((("x", 0.0), ("x", SIDE), ("y", 0.0),
                                                 ("y", SIDE)))]
    lines += ["compute floorz all reduce sum f_force_floor[3]",
              f"fix mean all ave/time {MEAN // 10} 10 {MEAN} f_plate[3] c_floorz "
              "file walls.txt"]

    moves = [[f"fix move all move/mesh mesh plate linear 0.0 0.0 {speed}"] if speed != 0.0 else []
             for _, _, speed in MOTION]
    stages = [([*old, *new], count) for old, new, (_, count, _) in
              zip([[], *(["unfix move"] if move else [] for move in moves)], moves, MOTION)]
    peers.run(PEER, folder, grains, law(), stages, STEP, FRAME, lines)
    rows = numpy.loadtxt(os.path.join(folder, "walls.txt"))
    place = next(state.place for step, state in
                 peers.read_frames(os.path.join(folder, "state.dump")) if step == HELD)
    return rows[:, 0], rows[:, 1] / SIDE**2, rows[:, 2] / SIDE**2, place


def run(folder):
    """Quantities of clod and the peer for every seed: [seed, quantity] each."""
    found = {"clod": [], PEER: []}
    for seed in SEEDS:
        grains = grains_of(seed)
        here = os.path.join(folder, f"pull-{seed}")
        for name, program in (("clod", clod), (PEER, peer)):
            result = program(os.path.join(here, name), grains)
            found[name].append(quantities(*result, grains.radius))
    return {name: numpy.array(rows) for name, rows in found.items()}


def compare(found):
    """Rows of (quantity, unit, clod, peer, difference, limit)."""
    return bed.compare(found, PEER, QUANTITIES)
