"""A results folder (docs/results-folder.md) as arrays."""

import csv
import glob
import json
import os
import re

import numpy


class Results:
    """What a run has left behind.

    summary  the results, a dictionary; {} while the run is not complete
    tables   names of the CSV files, without the ending
    """

    def __init__(self, folder):
        self.folder = os.fspath(folder)
        if not os.path.isdir(self.folder):
            raise FileNotFoundError(f"{self.folder} is no folder")
        path = os.path.join(self.folder, "summary.json")
        self.summary = {}
        if os.path.exists(path):
            with open(path) as file:
                self.summary = json.load(file)
        self.tables = sorted(os.path.basename(name)[:-4]
                             for name in glob.glob(os.path.join(self.folder, "*.csv")))

    def table(self, name="series"):
        """Columns of a CSV file by their names; (columns, units).

        Should names come again (tables of clod before surfaces had names of their own do), the
        second column is called "NAME (2)". Empty cells of numbers are nan.
        """
        with open(os.path.join(self.folder, name + ".csv"), newline="") as file:
            rows = list(csv.reader(file))
        columns, units = {}, {}
        for index, head in enumerate(rows[0]):
            found = re.fullmatch(r"(.*?) \[(.*)\]", head)
            name, unit = found.groups() if found else (head, None)
            key, again = name, 1
            while key in columns:
                again += 1
                key = f"{name} ({again})"
            values = [row[index] for row in rows[1:]]
            try:
                columns[key] = numpy.array([value or "nan" for value in values], float)
            except ValueError:
                columns[key] = numpy.array(values)
            units[key] = unit
        return columns, units

    def series(self, name="series"):
        """Columns of a table by name, as arrays."""
        return self.table(name)[0]

    def frame(self, name="series"):
        """The same as a pandas.DataFrame; needs pandas."""
        import pandas
        return pandas.DataFrame(self.series(name))

    def snapshots(self, kind="snap"):
        """Paths of the snapshots, part by part in the order of time; kind: snap, walls or contacts."""
        paths = glob.glob(os.path.join(self.folder, f"*{kind}_[0-9]*.hdf"))
        split = {path: os.path.basename(path)[:-4].rsplit("_", 1) for path in paths}
        return sorted(paths, key=lambda path: (split[path][0], int(split[path][1])))

    def snapshot(self, number=-1, kind="snap"):
        """Fields of one snapshot by name, `position` among them, and `time`; needs h5py."""
        import h5py
        with h5py.File(self.snapshots(kind)[number], "r") as file:
            fields = {"position": file["VTKHDF/Points"][...], "time": float(file.attrs["time_s"])}
            for group in ("PointData", "CellData"):
                for name, data in file["VTKHDF"].get(group, {}).items():
                    fields[name] = data[...]
        return fields


def results(folder):
    """Open a results folder."""
    return Results(folder)
