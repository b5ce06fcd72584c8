"""The closed model: time of a step as a sum of parts, and the job around the steps."""

import math
import statistics
from dataclasses import dataclass

import evenness
import geometry

NANO = 1e-9
MOST = 1e6   # grains a rank
SMALL = 64  # ranks, for which every box is looked at


def missed(rows, bytes_of_row, cache):
    """The part of some rows that does not stay in a cache."""
    return max(0.0, 1.0 - cache / (rows * bytes_of_row)) if rows > 0 else 0.0


def row_time(c, rows, ranks):
    """Seconds of an own row: the processor's, more beyond its own cache, and more from memory, at most as fast as
    memory serves all cores of the node that work."""
    workers = min(ranks, c.cores)
    near = missed(rows, c.row_footprint, c.cache)
    others = max(c.cores // workers, 1)  # where few work, they have the caches of all
    deep = missed(rows, c.row_footprint, others * c.cache_all) * c.row_bytes
    return max((c.row + near * c.far) * NANO + deep / c.memory_core, deep * workers / c.memory)


def ghost_time(c, row):
    """Seconds of a ghost, dearer by as much as rows are."""
    return row * c.ghost / c.row


def merge_time(c, ranks, count):
    """A merge of so many bytes: its rounds, of which those between ranks of a node are faster."""
    if ranks < 2:
        return 0.0
    power = 1 << (ranks.bit_length() - 1)
    spare = 0 if power == ranks else 2
    long = 2 * (c.overhead_long + c.latency_node) if count > c.eager else 0.0
    inside = c.latency_node + count / c.bandwidth_node + long
    outside = c.latency + count / c.bandwidth + long
    near = min(int(math.log2(min(ranks, c.cores))), int(math.log2(power)))
    return (near + spare) * inside + (int(math.log2(power)) - near) * outside


def call_time(c, neighbours, count):
    """Processor time of the calls for messages to neighbours, and from as many, of so many bytes each."""
    if neighbours < 1:
        return 0.0
    long = neighbours * c.overhead_long if count > c.eager else 0.0
    return 2.0 * ((neighbours - 1) * c.overhead + long)


def flight_time(c, shape, count):
    """From the last call until ghosts of so many bytes each are there: copies within the node, one after the
    other, and all that comes to the node through its adapter."""
    if shape.neighbours < 1:
        return 0.0
    latency = c.latency if shape.node_ghosts > 0.0 else c.latency_node
    inside = max(0.0, shape.ghosts - shape.node_ghosts / min(shape.ranks, c.cores))
    adapter = shape.node_ghosts * count / c.bandwidth + shape.node_messages * c.gap
    asks = 3 if shape.ghosts * count / shape.neighbours > c.eager else 1
    return asks * latency + max(inside * count / c.bandwidth_node, adapter)


@dataclass
class Shape:
    """Numbers of the bed on the ranks that the closed model needs."""

    ranks: int
    own: float
    ghosts: float       # of the rank that has most
    neighbours: float   # of the rank that has most
    node_ghosts: float  # that come from other nodes, of the node that gets most
    node_messages: float


def shape_of(c, bed):
    """Of a bed of geometry.py."""
    rows, messages = bed.between_nodes(c.cores)
    return Shape(bed.ranks, bed.own, bed.most_ghosts(), bed.most_neighbours(), rows, messages)


def regular_shape(c, grains, ranks):
    """The same without a look at each rank: all are cubes with others on all sides, nodes too."""
    own, node = grains / ranks, min(ranks, c.cores)
    edge, reach, across = own ** (1.0 / 3.0), c.ghost_layers, node ** (1.0 / 3.0)
    ghosts = (edge + 2.0 * reach) ** 3 - own
    within = (across * edge + 2.0 * reach * (across - 1.0)) ** 3  # own rows and ghosts of the node
    outside = max(0.0, node * (own + ghosts) - within)
    messages = 26.0 * node - ((3.0 * across - 2.0) ** 3 - node)
    if ranks <= c.cores:
        outside = messages = 0.0
    return Shape(ranks, own, ghosts, 26, outside, messages)


def shape_for(c, grains, ranks):
    """An even cube of grains on some ranks."""
    if ranks <= SMALL:
        return shape_of(c, geometry.Bed(grains, ranks, c.ghost_layers))
    return regular_shape(c, grains, ranks)


def most_of(ranks):
    """The largest of so many normal numbers, in standard deviations: the median of the largest is at the root of
    1/2; 0.5264 in place of it is near the mean (Chen and Tyler 1999, doi:10.1080/03610919908813542)."""
    return statistics.NormalDist().inv_cdf(0.5264 ** (1.0 / ranks)) if ranks > 1 else 0.0


def step_parts(c, shape):
    """Seconds of the parts of a mean step of the slowest rank."""
    own, ghosts, ranks = shape.own, shape.ghosts, shape.ranks
    row = row_time(c, own + ghosts, ranks)
    each = ghost_time(c, row)  # a ghost: pack, unpack, and the contacts that both owners compute
    compute = own * row
    parts = {"own rows": compute, "ghosts": ghosts * each}
    busy = compute + ghosts * each * (1.0 - c.pack_share)
    parts["imbalance"] = 0.0 if ranks == 1 else (compute + ghosts * each) * (c.imbalance - 1.0)
    parts["noise"] = busy * c.noise * most_of(ranks)
    merge = merge_time(c, ranks, c.code_merge)
    parts["merge"] = merge
    calls = call_time(c, shape.neighbours, ghosts * c.code_ghost / max(shape.neighbours, 1))
    parts["calls"] = calls + (c.meeting if ranks > 1 else 0.0)
    parts["on their way"] = max(0.0, flight_time(c, shape, c.code_ghost) - merge)
    parts["rebuilds"] = rebuild_time(c, shape) / c.rebuild_steps
    return parts


def rebuild_time(c, shape):
    """Seconds of a rebuild, and its share of cuts."""
    ranks = shape.ranks
    rows = shape.own * c.rebuild * NANO
    if ranks == 1:
        return rows
    merges = c.code_rebuild_merges * merge_time(c, ranks, c.code_small_merge)
    swaps = c.code_rebuild_swaps * merge_time(c, ranks, 4 * ranks)
    moved = flight_time(c, shape, c.code_grain_record) + call_time(
        c, shape.neighbours, shape.ghosts * c.code_grain_record / max(shape.neighbours, 1))
    return rows + merges + swaps + moved + c.cuts * merge_time(
        c, ranks, evenness.blocks_for(ranks) * c.code_cut_block)


def step_time(c, shape):
    return sum(step_parts(c, shape).values())


def efficiency(c, shape):
    """Of a rank: what its own rows take when all cores of the node work on as many, over the step."""
    return (shape.own * row_time(c, shape.own, shape.ranks)
            + shape.own * c.rebuild * NANO / c.rebuild_steps) / step_time(c, shape)


def checkpoint_time(c, grains, ranks):
    """Seconds of a checkpoint: bytes through rank 0, numbers of each slab from each rank, merges."""
    slabs = grains / c.code_slab
    return grains * c.code_checkpoint / c.write + slabs * (
        c.code_slab_messages * (ranks - 1) * c.overhead
        + c.code_slab_merges * merge_time(c, ranks, 8))


def deal_time(c, grains, ranks):
    """Seconds until the bed is dealt: rank 0 makes all grains, and their records leave it, and go on to their owners."""
    made = grains * c.code_make
    if ranks == 1:
        return made
    bandwidth = c.bandwidth if ranks > c.cores else c.bandwidth_node
    return made + grains * c.code_grain_record * (1.0 + 1.0 / ranks) / bandwidth + ranks * c.overhead


def grains_for(c, ranks, wanted):
    """Least grains a rank for an efficiency, to 3 %; infinite where more than MOST do not have it. It does not
    only rise: rows leave the cache."""
    grains = 10.0
    while grains < MOST:
        if efficiency(c, shape_for(c, grains * ranks, ranks)) >= wanted:
            return grains
        grains *= 1.03
    return math.inf
