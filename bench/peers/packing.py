"""
Beds of any size: copies of the packing side by side, in the formats of clod's bench_step and of
its peers. A periodic packing fits its own copies, so contacts per grain stay the same; a column cut
from it does not quite.
"""

import itertools
import math
import os

DENSITY = 2481.3  # kg/m3, as in bench/bed.h


def read(csv, box):
    """Rows (x, y, z, r, vx, vy, vz) and the three periods, in m and m/s."""
    with open(csv) as file:
        rows = [tuple(map(float, line.split(",")[1:])) for line in list(file)[1:]]
    with open(box) as file:
        return rows, tuple(map(float, file.read().split()))


def tiled(rows, period, copies):
    """The rows of nx * ny * nz copies, one by one."""
    nx, ny, nz = copies
    for shift in ((i, j, k) for i in range(nx) for j in range(ny) for k in range(nz)):
        dx, dy, dz = (n * length for n, length in zip(shift, period))
        for x, y, z, *rest in rows:
            yield (x + dx, y + dy, z + dz, *rest)


def _overlap(a, b, period):
    """Overlap of two grains or their nearest images, over the smaller radius; < 0 apart."""
    apart = (p - q - length * round((p - q) / length) for p, q, length in zip(a, b, period))
    return (a[3] + b[3] - math.hypot(*apart)) / min(a[3], b[3])


def cut(rows, period, share):
    """
    A column: the grains in the first `share` of each side, and its periods. Its new borders would
    bring grains together that were not: whoever would overlap one before it more than any two do
    in the packing is left out. So it is a bed with gaps and loose grains at two seams.
    """
    lengths = [part * length for part, length in zip(share, period)]
    inside = [row for row in rows if all(x < length for x, length in zip(row, lengths))]
    most = max(_overlap(a, b, period) for a, b in itertools.combinations(inside, 2))
    kept = []
    for row in inside:
        if all(_overlap(row, other, lengths) <= most for other in kept):
            kept.append(row)
    return kept, lengths


def write_clod(stem, rows, lengths):
    """STEM.csv and STEM.box."""
    with open(stem + ".csv", "w") as file:
        file.write("id,x [m],y [m],z [m],r [m],vx [m/s],vy [m/s],vz [m/s]\n")
        for number, row in enumerate(rows, 1):
            file.write(f"{number}," + ",".join(map(repr, row)) + "\n")
    with open(stem + ".box", "w") as file:
        file.write(" ".join(map(repr, lengths)) + "\n")


def write_peers(path, rows, lengths, count):
    """A data file of LIGGGHTS and LAMMPS; velocities are a second pass, so rows is a function."""
    with open(path, "w") as file:
        file.write(f"packing\n\n{count} atoms\n1 atom types\n\n")
        for axis, length in zip("xyz", lengths):
            file.write(f"0.0 {length!r} {axis}lo {axis}hi\n")
        file.write("\nAtoms\n\n")
        for number, (x, y, z, r, *_) in enumerate(rows(), 1):
            file.write(f"{number} 1 {2.0 * r!r} {DENSITY!r} {x!r} {y!r} {z!r}\n")
        file.write("\nVelocities\n\n")
        for number, (_, _, _, _, vx, vy, vz) in enumerate(rows(), 1):
            file.write(f"{number} {vx!r} {vy!r} {vz!r} 0.0 0.0 0.0\n")


def make(stem, source, copies, for_peers):
    """Write STEM.csv, STEM.box and, for peers, STEM.data where they are absent; grains."""
    rows, period = read(source + ".csv", source + ".box")
    if min(copies) < 1:
        rows, period = cut(rows, period, copies)
        copies = (1, 1, 1)
    lengths = [n * length for n, length in zip(copies, period)]
    count = len(rows) * copies[0] * copies[1] * copies[2]
    os.makedirs(os.path.dirname(stem), exist_ok=True)
    part = stem + ".part"
    if not os.path.exists(stem + ".csv"):
        write_clod(part, tiled(rows, period, copies), lengths)
        os.replace(part + ".box", stem + ".box")
        os.replace(part + ".csv", stem + ".csv")
    if for_peers and not os.path.exists(stem + ".data"):
        write_peers(part, lambda: tiled(rows, period, copies), lengths, count)
        os.replace(part, stem + ".data")
    return count
