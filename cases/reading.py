"""Reads results folders of clod run for the tables of the cases; snapshots with h5py (python3-h5py).

What a folder lacks that a table needs is an Unfit, which main() and each() tell in one line, with exit status 2.
"""

import argparse
import csv
import json
import math
import os
import sys


class Unfit(Exception):
    """Why a folder is not a run that the table can read."""


class Named(dict):
    """Values by name, from a file; a name that is not there is an Unfit."""

    def __init__(self, values, file):
        super().__init__(values)
        self.file = file

    def __missing__(self, name):
        raise Unfit(f"its {self.file} has no {name}: it is a run of another case, or of another version of clod")


def summary(folder):
    """What summary.json of an ended run says."""
    if not os.path.isdir(folder):
        raise Unfit("there is no such folder")
    path = os.path.join(folder, "summary.json")
    if not os.path.exists(path):
        raise Unfit("it has no summary.json: the run has not ended, or this is not its results folder")
    try:
        with open(path) as file:
            found = json.load(file, object_pairs_hook=lambda pairs: Named(pairs, "summary.json"))
    except (OSError, ValueError) as error:
        raise Unfit(f"its summary.json cannot be read: {error}") from error
    if not isinstance(found, dict):
        raise Unfit("its summary.json is damaged: not an object")
    return found


def series(folder):
    """Rows of the series as numbers by name; units are cut off the names. Empty cells are no numbers (nan)."""
    try:
        with open(os.path.join(folder, "series.csv"), newline="") as file:
            return [Named({name.split(" [")[0]: float(value) if value else math.nan for name, value in row.items()},
                          "series.csv") for row in csv.DictReader(file)]
    except (OSError, ValueError, TypeError, AttributeError) as error:
        raise Unfit(f"its series.csv cannot be read: {error}") from error


def times(folder, name="run.hdf.series"):
    """Pairs (time [s], path) of all snapshots, or of those of the walls (run_walls.hdf.series)."""
    try:
        with open(os.path.join(folder, name)) as file:
            return [(one["time"], os.path.join(folder, one["name"])) for one in json.load(file)["files"]]
    except FileNotFoundError as error:
        raise Unfit(f"it has no snapshots ({name})") from error
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Unfit(f"its {name} is damaged: {error}") from error


def rows_after(folder, time, least=5):
    """Rows of the series later than a time [s], so many at least."""
    rows = series(folder)
    found = [row for row in rows if row["time"] > time]
    if len(found) < least:
        raise Unfit(f"its series has {len(found)} rows after {time:g} s, and {least} are needed: "
                    + (f"it ends at {rows[-1]['time']:.4g} s" if rows else "it is empty"))
    return found


def beds_after(folder, time, least=1):
    """Grains of all snapshots later than a time [s], so many at least."""
    paths = [path for at, path in times(folder) if at > time]
    if len(paths) < least:
        raise Unfit(f"it has {len(paths)} snapshots after {time:g} s, and {least} are needed")
    return [grains(path) for path in paths]


def columns(path, *names):
    """Columns of a snapshot, as lists."""
    try:
        import h5py
    except ImportError:
        sys.exit("snapshots are read with h5py: install python3-h5py, and use the Python that has it "
                 f"(/usr/bin/python3 {sys.argv[0]} ...)")
    try:
        with h5py.File(path) as file:
            return [file[f"VTKHDF/{name}"][:].tolist() for name in names]
    except (OSError, KeyError) as error:
        raise Unfit(f"its snapshot {os.path.basename(path)} cannot be read: {error}") from error


def corners(folder):
    """Corners (x, y, z) [m] of the facets of all walls, in the first snapshot."""
    snapshots = times(folder, "run_walls.hdf.series")
    if not snapshots:
        raise Unfit("it has no snapshots of its walls")
    return columns(snapshots[0][1], "Points")[0]


def grains(path):
    """Grains of a snapshot, one at least: tuples (x, y, z, radius, mass) in SI units."""
    places, radii, masses = columns(path, "Points", "PointData/radius", "PointData/mass")
    if not places:
        raise Unfit(f"its snapshot {os.path.basename(path)} has no grains")
    return [(*place, radius, mass) for place, radius, mass in zip(places, radii, masses)]


def each(look, folders, case=None):
    """What look(folder) returns of each results folder. One that is not a run of the case ends the program."""
    case = case or os.path.relpath(os.path.dirname(os.path.abspath(sys.argv[0])))
    found = []
    for folder in folders:
        try:
            found.append(look(folder))
        except Unfit as error:
            sys.stdout.flush()
            print(f"table: {folder}: {error}. This table is of runs of {case}. To make one, or to go on with one that "
                  f"has not ended:\n  clod run {os.path.join(case, 'case.yaml')} -o FOLDER", file=sys.stderr)
            sys.exit(2)
    return found


def main(look, text):
    """A table whose arguments are results folders: look at each. Text of --help."""
    parser = argparse.ArgumentParser(usage="table RUN...", description=text,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="RUN", help="results folder of clod run")
    return each(look, parser.parse_args().runs)


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
