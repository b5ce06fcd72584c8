"""Grains at the start of a comparison: the same numbers for clod and its peers."""

import numpy

RADIUS = 3e-3  # m
DENSITY = 2500.0  # kg/m3


class Arrangement:
    """Grains in a box that is periodic in the directions that `periodic` names."""

    def __init__(self, box, place, radius, velocity=None, spin=None, density=DENSITY,
                 periodic=(True, True, True)):
        self.box = numpy.asarray(box, float)  # m, from the origin
        self.place = numpy.asarray(place, float)  # m
        self.radius = numpy.asarray(radius, float)  # m
        self.count = len(self.radius)
        zeros = numpy.zeros((self.count, 3))
        self.velocity = zeros if velocity is None else numpy.asarray(velocity, float)  # m/s
        self.spin = zeros if spin is None else numpy.asarray(spin, float)  # rad/s
        self.density = density  # kg/m3
        self.periodic = periodic

    def mass(self):
        """Mass of the first grain [kg]."""
        return self.density * 4.0 / 3.0 * numpy.pi * self.radius[0] ** 3

    def with_spin(self, factor):
        """The same grains with all spins multiplied."""
        return Arrangement(self.box, self.place, self.radius, self.velocity, factor * self.spin,
                           self.density, self.periodic)


def _lattice(cells, corners):
    """Corners of a unit cell, repeated; in lengths of the cell."""
    steps = numpy.stack(numpy.meshgrid(*[numpy.arange(c) for c in cells], indexing="ij"), -1)
    return (steps.reshape(-1, 1, 3) + numpy.asarray(corners)).reshape(-1, 3)


def dense(seed, overlap, scatter, speed, spin, spread=0.01, cells=4):
    """
    A disturbed face-centred cubic bed, periodic everywhere: 4 cells^3 grains, 12 neighbours each.

    overlap: of the undisturbed neighbours, over the radius. scatter: largest displacement along
    each axis, over the radius. spread: of the radii, to both sides. speed, spin: at most, m/s
    and rad/s.
    """
    rng = numpy.random.RandomState(seed)
    side = (2.0 - overlap) * RADIUS * numpy.sqrt(2.0)
    corners = [[0.25, 0.25, 0.25], [0.25, 0.75, 0.75], [0.75, 0.25, 0.75], [0.75, 0.75, 0.25]]
    place = side * _lattice([cells] * 3, corners)
    n = len(place)
    place += scatter * RADIUS * rng.uniform(-1.0, 1.0, (n, 3))
    radius = RADIUS * (1.0 + spread * rng.uniform(-1.0, 1.0, n))
    return Arrangement([cells * side] * 3, place, radius, speed * rng.uniform(-1.0, 1.0, (n, 3)),
                       spin * rng.uniform(-1.0, 1.0, (n, 3)))


def sheet(seed, overlap, scatter, speed, spin, spread=0.01, cells=(10, 6)):
    """
    A disturbed triangular lattice in the plane z = const: velocities lie in the plane and spins
    along z, so no contact ever twists about its own normal. Arguments as for `dense`.
    """
    rng = numpy.random.RandomState(seed)
    side = (2.0 - overlap) * RADIUS
    cell = numpy.array([side, numpy.sqrt(3.0) * side, 1.0])
    place = cell * _lattice([cells[0], cells[1], 1], [[0.25, 0.25, 0.0], [0.75, 0.75, 0.0]])
    n = len(place)
    place[:, :2] += scatter * RADIUS * rng.uniform(-1.0, 1.0, (n, 2))
    thick = 10.0 * RADIUS
    place[:, 2] = 0.5 * thick
    velocity = numpy.zeros((n, 3))
    velocity[:, :2] = speed * rng.uniform(-1.0, 1.0, (n, 2))
    turning = numpy.zeros((n, 3))
    turning[:, 2] = spin * rng.uniform(-1.0, 1.0, n)
    radius = RADIUS * (1.0 + spread * rng.uniform(-1.0, 1.0, n))
    return Arrangement([cells[0] * cell[0], cells[1] * cell[1], thick], place, radius, velocity,
                       turning)


def square(seed, overlap, spin, cells=10):
    """Equal grains on a square lattice at rest, spinning about z: every overlap is the same."""
    rng = numpy.random.RandomState(seed)
    side = (2.0 - overlap) * RADIUS
    place = side * _lattice([cells, cells, 1], [[0.5, 0.5, 0.0]])
    n = len(place)
    place[:, 2] = 5.0 * RADIUS
    turning = numpy.zeros((n, 3))
    turning[:, 2] = spin * rng.uniform(-1.0, 1.0, n)
    return Arrangement([cells * side, cells * side, 10.0 * RADIUS], place,
                       numpy.full(n, RADIUS), None, turning)


def layers(overlap, speed, cells=6):
    """
    A cubic lattice whose layers slide over each other, every second one the other way, with
    another radius. Each layer is a mirror plane, so friction turns no grain, while the normals
    turn and the overlaps change: history without spin.

    speed: of a layer along x and y [m/s]. Layers start half a tenth of a radius before the place
    where their grains face each other.
    """
    side = (2.0 - overlap) * RADIUS
    place = side * _lattice([cells] * 3, [[0.5, 0.5, 0.5]])
    odd = numpy.floor(place[:, 2] / side).astype(int) % 2
    sign = numpy.where(odd == 1, 1.0, -1.0)
    velocity = numpy.zeros_like(place)
    velocity[:, 0] = sign * speed[0]
    velocity[:, 1] = sign * speed[1]
    place -= 0.05 * RADIUS / numpy.hypot(*speed) * velocity
    # neighbours of a layer touch each other too, with the overlap that their radius leaves
    return Arrangement([cells * side] * 3, place, RADIUS * (1.0 - 0.1 * overlap * odd), velocity)


def couple(overlap, speed):
    """Two grains that touch and come together at `speed` [m/s]."""
    far = (2.0 - overlap) * RADIUS
    place = [[10.0 * RADIUS] * 3, [10.0 * RADIUS + far, 10.0 * RADIUS, 10.0 * RADIUS]]
    return Arrangement([20.0 * RADIUS] * 3, place, [RADIUS, RADIUS],
                       [[0.5 * speed, 0.0, 0.0], [-0.5 * speed, 0.0, 0.0]])


def dumbbell(overlap, speed, drift=0.0):
    """
    Two grains that overlap and turn about each other in the plane z = const, with `speed` each,
    while both move along x with `drift` [m/s].
    """
    pair = couple(overlap, 0.0)
    pair.velocity = numpy.array([[drift, -speed, 0.0], [drift, speed, 0.0]])
    return pair
