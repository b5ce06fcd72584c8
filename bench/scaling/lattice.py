"""What ranks say to each other for the bed of bench_ranks, counted grain by grain without running it.

The bed is a periodic cubic lattice; its grains all but touch. Blocks and cuts are those of
src/step/partition.c, the reach that of src/step/spread.c, and bytes those of the constants."""

import math

ACROSS, BLOCKS, GROWTH = 64, 16384, 1.26  # partition.h, partition.c
PITCH = 2.000001  # radii, of the lattice of bench_ranks.c
SKIN = 0.3        # radii: neighbour.c, slow or not
MARGIN = 1.000001  # spread.c
WINDOW = 20       # steps between two looks of bench_ranks.c


def blocks_along(length):
    """How many blocks a cube has along each axis."""
    width = length / ACROSS
    while True:
        count = min(max(int(length / width), 1), ACROSS)
        if count ** 3 <= BLOCKS:
            return count
        width *= GROWTH


def _cut(weights, low, high, share):
    """Where an axis of blocks has a share of its weight below, between two places."""
    slices = [(k, max(min(high, k + 1) - max(low, k), 0.0)) for k in range(len(weights))]
    wanted = share * sum(part * weights[k] for k, part in slices)
    below = 0.0
    for k, part in slices:
        weight = part * weights[k]
        if weight > 0.0 and below + weight >= wanted:
            return max(low, k) + part * (wanted - below) / weight
        below += weight
    return high


def boxes(edge, ranks):
    """Boxes [low, high) of all ranks, in radii. The weights of a lattice are a product of those along
    each axis, so a cut across an axis needs those along it alone."""
    length = (edge - 1) * PITCH
    count = blocks_along(length)
    width = length / count
    weights = [0] * count
    for k in range(edge):
        weights[min(int(k * PITCH / width), count - 1)] += 1
    parts = [([0.0] * 3, [float(count)] * 3, ranks)]
    while any(part[2] > 1 for part in parts):
        halved = []
        for low, high, of in parts:
            if of == 1:
                halved.append((low, high, of))
                continue
            axis = 0
            for a in range(3):
                axis = a if high[a] - low[a] > high[axis] - low[axis] else axis
            at = _cut(weights, low[axis], high[axis], (of // 2) / of)
            lower, upper = list(high), list(low)
            lower[axis] = upper[axis] = at
            halved += [(low, lower, of // 2), (upper, high, of - of // 2)]
        parts = halved
    first = 0.5 * PITCH  # centre of the first layer
    return [([first + x * width for x in low], [first + x * width for x in high])
            for low, high, _ in parts]


def _layers(edge, low, high):
    """Numbers of layers whose centres are within reach of an interval on a circle of the bed."""
    reach = MARGIN * (2.0 + SKIN)
    middle, half, period = 0.5 * (low + high), 0.5 * (high - low), edge * PITCH
    near = set()
    for k in range(edge):
        off = ((k + 0.5) * PITCH - middle + 0.5 * period) % period - 0.5 * period
        if abs(off) - half <= reach:
            near.add(k)
    return near


def _own(edge, low, high, last):
    """Numbers of layers in an interval; the last one has those at its end."""
    return {k for k in range(edge)
            if (k + 0.5) * PITCH >= low and ((k + 0.5) * PITCH < high or last)}


def pairs(edge, ranks):
    """Grains of each rank, and ghosts {(from, to): grains}."""
    all_boxes = boxes(edge, ranks)
    top = [max(high[a] for _, high in all_boxes) for a in range(3)]
    own = [[_own(edge, low[a], high[a], high[a] == top[a]) for a in range(3)]
           for low, high in all_boxes]
    near = [[_layers(edge, low[a], high[a]) for a in range(3)] for low, high in all_boxes]
    ghosts = {}
    for to in range(ranks):
        for of in range(ranks):
            count = math.prod(len(own[of][a] & near[to][a]) for a in range(3))
            if of != to and count > 0:
                ghosts[of, to] = count
    return [math.prod(len(layers) for layers in some) for some in own], ghosts


def merge_messages(ranks):
    """Messages of all ranks in a merge: ranks.c."""
    power = 1 << (ranks.bit_length() - 1)
    return power * (power.bit_length() - 1) + 2 * (ranks - power)


def predict(edge, ranks, bytes_of):
    """What bench_ranks prints: of a rank and step where not said otherwise."""
    own, ghosts = pairs(edge, ranks)
    told = (ranks - 1) / WINDOW  # a window is a call: an order, and numbers of the state
    calls = 2 * told
    grains = edge ** 3
    return {"imbalance": max(own) * ranks / grains,
            "ghosts": sum(ghosts.values()) / grains,
            "messages_a_rank": (len(ghosts) + calls) / ranks,
            "bytes_a_rank": (sum(ghosts.values()) * bytes_of["ghost"]
                             + told * (bytes_of["order"] + bytes_of["state"])) / ranks,
            "messages_of_a_merge": merge_messages(ranks) / ranks,
            "rebuild_messages_least": 2 * math.ceil(math.log2(ranks)) + len(ghosts) / ranks}
