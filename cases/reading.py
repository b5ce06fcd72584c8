"""Reads results folders of clod run for the tables of the cases; snapshots with h5py (python3-h5py)."""

import csv
import json
import os
import sys


def summary(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def series(folder):
    """Rows of the series as numbers by name; units are cut off the names."""
    with open(os.path.join(folder, "series.csv"), newline="") as file:
        return [{name.split(" [")[0]: float(value) for name, value in row.items()}
                for row in csv.DictReader(file)]


def times(folder):
    """Pairs (time [s], path) of all snapshots."""
    with open(os.path.join(folder, "run.hdf.series")) as file:
        return [(one["time"], os.path.join(folder, one["name"])) for one in json.load(file)["files"]]


def grains(path):
    """Grains of a snapshot: tuples (x, y, z, radius, mass) in SI units."""
    try:
        import h5py
    except ImportError:
        sys.exit("snapshots are read with h5py: install python3-h5py, and use the Python that has it "
                 f"(/usr/bin/python3 {sys.argv[0]} ...)")
    with h5py.File(path) as file:
        places = file["VTKHDF/Points"][:].tolist()
        radii = file["VTKHDF/PointData/radius"][:].ravel().tolist()
        masses = file["VTKHDF/PointData/mass"][:].ravel().tolist()
    return [(*place, radius, mass) for place, radius, mass in zip(places, radii, masses)]


def slope(points):
    """Of the straight line by least squares through points (x, y)."""
    n = len(points)
    x, y = (sum(p[i] for p in points) / n for i in (0, 1))
    return sum((p[0] - x) * (p[1] - y) for p in points) / sum((p[0] - x) ** 2 for p in points)


def mean_error(values, blocks=5):
    """Mean, and its standard error from the means of blocks one after the other."""
    size = len(values) // blocks
    means = [sum(values[k * size:(k + 1) * size]) / size for k in range(blocks)]
    mean = sum(means) / blocks
    return mean, (sum((m - mean) ** 2 for m in means) / (blocks - 1) / blocks) ** 0.5
