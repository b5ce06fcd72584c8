"""What is run: beds, cases, programs, steps."""

SOURCE_GRAINS = 3750  # bench/packings/pack_4k.csv
SLOWEST = 2e6  # grain-steps/s of the slowest program; only sets how many steps a run has

# name: copies along x, y, z; whether the peers run it and all cases are run. Less than one copy is
# a column cut from the packing (packing.cut), for the cost of a small bed only.
SIZES = {"1k": ((0.55, 0.55, 1), False), "4k": ((1, 1, 1), True), "11k": ((1, 1, 3), False), "30k": ((2, 2, 2), True),
         "101k": ((3, 3, 3), False), "300k": ((4, 4, 5), True), "1M": ((5, 6, 9), True),
         "3M": ((8, 10, 10), False)}

# case: text, clod's law, then its peers as (program, law in bench/peers, variables, name)
CASES = {
    "hertz": ("a: Hertz and tangential history", "hertz", [
        ("lammps", "hertz", (), "LAMMPS gran/hertz/history"),
        ("liggghts", "hertz", (), "LIGGGHTS hertz")]),
    "rolling": ("b: the same with rolling resistance", "hertz-rolling", [
        ("lammps", "rolling", (), "LAMMPS granular, sds"),
        ("liggghts", "rolling", (), "LIGGGHTS hertz, epsd2")]),
    "plastic": ("c: plastic-adhesive (MEPA, n = 3/2), friction, rolling resistance", "mepa", [
        ("liggghts", "plastic", (("limit", "on"),), "LIGGGHTS edinburgh/stiffness"),
        ("liggghts", "plastic", (("limit", "off"),),
         "LIGGGHTS edinburgh/stiffness, limitForce off")]),
}
CLOD = "clod"
FULL = "plastic"  # the case of sizes that only clod runs, of memory, stages and scaling


def cut(size):
    """Whether a bed is less than the packing: its seams are not at rest, no target is its own."""
    return min(SIZES[size][0]) < 1


def grains(size):
    """How many; about, where the packing is cut."""
    nx, ny, nz = SIZES[size][0]
    return round(SOURCE_GRAINS * nx * ny * nz)


def steps(size, seconds):
    """Steps before the clock runs, and steps it runs over; the slowest takes about `seconds`."""
    count = max(10, round(seconds * SLOWEST / grains(size)))
    return count // 5 + 5, count


def programs(size, case):
    """Names of the programs that run a case, in the order of their turns."""
    if not SIZES[size][1]:
        return [CLOD] if case == FULL else []
    return [CLOD] + [peer[3] for peer in CASES[case][2]]
