"""Boxes of ranks in an even bed, and how many ghosts each gets from each: as src/step/partition.c cuts."""


class Part:
    """Ranks [first, last) and their box; two halves where there are several."""

    def __init__(self, low, high, first, last):
        self.low, self.high, self.first, self.last = low, high, first, last
        self.halves = ()


def bisect(lengths, ranks):
    """The tree of recursive bisection of an even box; each cut is across the longest axis."""
    root = Part((0.0, 0.0, 0.0), tuple(lengths), 0, ranks)
    open_parts = [root]
    while open_parts:
        part = open_parts.pop()
        count = part.last - part.first
        if count == 1:
            continue
        length = [b - a for a, b in zip(part.low, part.high)]
        axis = max(range(3), key=lambda a: (length[a], -a))
        middle = part.first + count // 2
        at = part.low[axis] + length[axis] * (count // 2) / count
        lower, upper = list(part.high), list(part.low)
        lower[axis] = upper[axis] = at
        part.halves = (Part(part.low, tuple(lower), part.first, middle),
                       Part(tuple(upper), part.high, middle, part.last))
        open_parts += part.halves
    return root


def leaves(root):
    """Boxes of all ranks, in their order."""
    if not root.halves:
        return [root]
    return leaves(root.halves[0]) + leaves(root.halves[1])


def _shifts(low, high, lengths, periodic):
    """By how much a box is moved so that it meets the bed, with its images."""
    shifts = [()]
    for a in range(3):
        ways = [0.0]
        if periodic and low[a] < 0.0:
            ways.append(lengths[a])
        if periodic and high[a] > lengths[a]:
            ways.append(-lengths[a])
        shifts = [before + (way,) for before in shifts for way in ways]
    return shifts


def _meet(part, low, high, found):
    """Volumes that the boxes of ranks share with a box."""
    if any(part.low[a] >= high[a] or part.high[a] <= low[a] for a in range(3)):
        return
    if part.halves:
        _meet(part.halves[0], low, high, found)
        _meet(part.halves[1], low, high, found)
        return
    volume = 1.0
    for a in range(3):
        volume *= min(part.high[a], high[a]) - max(part.low[a], low[a])
    found[part.first] = found.get(part.first, 0.0) + volume


def ghosts(root, reach, density, periodic=True):
    """For each rank, which others it gets ghosts from, and how many: [{rank: grains}]."""
    lengths = root.high
    all_ghosts = []
    for box in leaves(root):
        low = [x - reach for x in box.low]
        high = [x + reach for x in box.high]
        for a in range(3):
            if periodic and high[a] - low[a] >= lengths[a]:  # all around: each grain counts once
                low[a], high[a] = 0.0, lengths[a]
        found = {}
        for shift in _shifts(low, high, lengths, periodic):
            _meet(root, [x + s for x, s in zip(low, shift)], [x + s for x, s in zip(high, shift)],
                  found)
        found.pop(box.first, None)
        all_ghosts.append({rank: volume * density for rank, volume in found.items()})
    return all_ghosts


class Bed:
    """An even cube of grains on some ranks: what each owns, and gets from whom."""

    def __init__(self, grains, ranks, reach, density=1.0, lengths=None, periodic=True):
        edge = (grains / density) ** (1.0 / 3.0)
        self.ranks = ranks
        self.own = grains / ranks
        self.ghosts = ghosts(bisect(lengths or (edge,) * 3, ranks), reach, density, periodic)

    def most_ghosts(self):
        return max((sum(some.values()) for some in self.ghosts), default=0.0)

    def mean_ghosts(self):
        return sum(sum(some.values()) for some in self.ghosts) / self.ranks

    def most_neighbours(self):
        return max(len(some) for some in self.ghosts)

    def mean_neighbours(self):
        return sum(len(some) for some in self.ghosts) / self.ranks

    def between_nodes(self, ranks_per_node):
        """Of the node that gets most: ghosts and messages that come from other nodes."""
        rows, messages = {}, {}
        for rank, some in enumerate(self.ghosts):
            node = rank // ranks_per_node
            for other, count in some.items():
                if other // ranks_per_node != node:
                    rows[node] = rows.get(node, 0.0) + count
                    messages[node] = messages.get(node, 0) + 1
        return max(rows.values(), default=0.0), max(messages.values(), default=0)
