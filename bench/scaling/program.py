"""What a rank does, in the order of the code: src/step/ghosts.c, src/parallel/ranks.c, src/step/migrate.c.

Programs are generators for engine.py. A message that is exchanged is started and finished at once."""


def exchange(outs, ins):
    key = yield ("start", outs, ins)
    return (yield ("finish", key))


def merge(rank, size, count):
    """Recursive doubling of so many bytes: merge_all of ranks.c."""
    power = 1 << (size.bit_length() - 1)
    spare = size - power
    paired = rank < 2 * spare
    sits = paired and rank % 2 == 1
    if paired:
        if sits:
            yield from exchange([(rank - 1, count)], [])
        else:
            yield from exchange([], [(rank + 1, count)])
    place = rank // 2 if paired else rank - spare
    bit = 1
    while bit < power and not sits:
        other = place ^ bit
        peer = 2 * other if other < spare else other + spare
        yield from exchange([(peer, count)], [(peer, count)])
        bit *= 2
    if paired:
        if sits:
            yield from exchange([], [(rank - 1, count)])
        else:
            yield from exchange([(rank + 1, count)], [])


def numbers(rank, size):
    """How many bytes come from whom: exchange_numbers of ranks.c (Bruck)."""
    bit = 1
    while bit < size:
        count = 8 * (size // (2 * bit) * bit + max(0, size % (2 * bit) - bit))  # with this bit
        yield from exchange([((rank + bit) % size, count)], [((rank - bit) % size, count)])
        bit *= 2


class Work:
    """What a rank has to do in each step, in seconds, and whom it sends ghosts."""

    def __init__(self, outs, ins, pack, unpack, rest, rebuild, noise):
        self.outs, self.ins = outs, ins    # [(rank, ghosts)]
        self.pack, self.unpack = pack, unpack
        self.rest = rest                   # drift, contacts
        self.rebuild = rebuild             # of lists
        self.noise = noise                 # () -> factor of a step


def step(rank, size, c, work):
    """A step from ghosts to ghosts."""
    factor = work.noise()
    yield ("work", work.pack + (c.meeting if size > 1 else 0.0))
    key = yield ("start", [(peer, count * c.code_ghost) for peer, count in work.outs],
                 [(peer, count * c.code_ghost) for peer, count in work.ins])
    if size > 1:
        yield from merge(rank, size, c.code_merge)
    yield ("finish", key)
    yield ("work", work.unpack + work.rest * factor)


def rebuild(rank, size, c, work):
    """Lists made anew: merges, numbers and grains. Contacts are few, and go with the grains here."""
    if size > 1:
        for _ in range(round(c.code_rebuild_merges)):
            yield from merge(rank, size, c.code_small_merge)
        for k in range(c.code_rebuild_swaps):
            yield from numbers(rank, size)
            if k == 0:
                yield from exchange([(peer, count * c.code_grain_record) for peer, count in work.outs],
                                    [(peer, count * c.code_grain_record) for peer, count in work.ins])
    yield ("work", work.rebuild)


def run(rank, size, c, work, plan):
    """Steps of a plan: a word for each, `step` or `rebuild`."""
    for word in plan:
        yield from step(rank, size, c, work)
        if word == "rebuild":
            yield from rebuild(rank, size, c, work)
