"""How evenly a bed of uneven shape is cut: blocks are few, and taken to be even inside (src/step/partition.c).

The bed is a heap, a cone in its box of 2 x 2 x 1, of one point somewhere in each cell of a cubic lattice: no layers,
within which nothing can be cut. Ranks that get more than the mean
make all others wait."""

import math
import random

EACH, LEAST, MOST, ACROSS, GROWTH = 64, 16384, 1 << 20, 64, 1.26  # partition.h, partition.c


def heap(count):
    """Some `count` points of a cone on its base."""
    edge = (math.pi / 3.0 / count) ** (1.0 / 3.0)
    steps = int(1.0 / edge) + 1
    roll = random.Random(1)
    points = []
    for k in range(steps):
        for i in range(-steps, steps):
            for j in range(-steps, steps):
                x, y, z = ((n + roll.random()) * edge for n in (i, j, k))
                if math.hypot(x, y) <= 1.0 - z:
                    points.append((x, y, z))
    return points


def blocks_for(ranks):
    """Most blocks of a cut."""
    return min(max(EACH * ranks, LEAST), MOST)


def grid(low, high, most):
    """Blocks along each axis of a box, `most` of them at most, and their widths."""
    length = [b - a for a, b in zip(low, high)]
    across = int(ACROSS * (most / LEAST) ** (1.0 / 3.0) + 1e-9)
    width = max(length) / across
    while True:
        count = [min(max(int(x / width), 1), across) for x in length]
        if math.prod(count) <= most:
            return count, [x / n if x > 0.0 else 1.0 for x, n in zip(length, count)]
        width *= GROWTH


def _slices(weights, count, low, high, axis):
    """Weight of each slice of a piece across an axis."""
    parts = []
    for a in range(3):
        parts.append([(k, min(high[a], k + 1) - max(low[a], k))
                      for k in range(int(low[a]), math.ceil(high[a]))])
    slices = [0.0] * count[axis]
    for k, z in parts[2]:
        for j, y in parts[1]:
            row = (k * count[1] + j) * count[0]
            for i, x in parts[0]:
                slices[(i, j, k)[axis]] += weights[row + i] * x * y * z
    return slices


def _cut(slices, low, high, share):
    wanted, below = share * sum(slices), 0.0
    for k in range(int(low), math.ceil(high)):
        if slices[k] > 0.0 and below + slices[k] >= wanted:
            begin = max(low, k)
            return begin + (min(high, k + 1) - begin) * (wanted - below) / slices[k]
        below += slices[k]
    return high


def most_over_mean(points, ranks, blocks=None):
    """The most points of a rank over the mean; None: with the blocks that clod takes."""
    low = [min(p[a] for p in points) for a in range(3)]
    high = [max(p[a] for p in points) for a in range(3)]
    count, width = grid(low, high, blocks or blocks_for(ranks))
    places = [[(p[a] - low[a]) / width[a] for a in range(3)] for p in points]
    weights = [0.0] * math.prod(count)
    for place in places:
        at = [min(int(x), n - 1) for x, n in zip(place, count)]
        weights[(at[2] * count[1] + at[1]) * count[0] + at[0]] += 1.0
    open_pieces = [([0.0] * 3, [float(n) for n in count], ranks, places)]
    most = 0
    while open_pieces:
        low, high, of, mine = open_pieces.pop()
        if of == 1:
            most = max(most, len(mine))
            continue
        axis = max(range(3), key=lambda a: ((high[a] - low[a]) * width[a], -a))
        at = _cut(_slices(weights, count, low, high, axis), low[axis], high[axis], (of // 2) / of)
        lower, upper = list(high), list(low)
        lower[axis] = upper[axis] = at
        open_pieces.append((low, lower, of // 2, [p for p in mine if p[axis] < at]))
        open_pieces.append((upper, high, of - of // 2, [p for p in mine if p[axis] >= at]))
    return most * ranks / len(points)
