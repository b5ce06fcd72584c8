"""What is run: beds, cases, programs, steps."""

SOURCE_GRAINS = 3750  # bench/packings/pack_4k.csv
SLOWEST = 2e6  # grain-steps/s of the slowest program; only sets how many steps a run has

# name: copies along x, y, z; whether the peers run it and all cases are run. The packing is the
# smallest bed: cut smaller it would not be periodic any more.
SIZES = {"4k": ((1, 1, 1), True), "11k": ((1, 1, 3), False), "30k": ((2, 2, 2), True),
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


def grains(size):
    nx, ny, nz = SIZES[size][0]
    return SOURCE_GRAINS * nx * ny * nz


def steps(size, seconds):
    """Steps before the clock runs, and steps it runs over; the slowest takes about `seconds`."""
    count = max(10, round(seconds * SLOWEST / grains(size)))
    return count // 5 + 5, count


def programs(size, case):
    """Names of the programs that run a case, in the order of their turns."""
    if not SIZES[size][1]:
        return [CLOD] if case == FULL else []
    return [CLOD] + [peer[3] for peer in CASES[case][2]]
