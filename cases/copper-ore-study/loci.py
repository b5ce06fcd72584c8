"""Reads yield loci out of the results folders of ring shear tests."""

import csv
import json
import math
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import reading
import studies

PRESHEAR, SHEAR = 3, 6  # phases of the series


def summary(folder, name):
    """The summary of a test; None: it has not ended."""
    path = os.path.join(folder, name, "summary.json")
    if not os.path.exists(path):
        return None
    with open(path) as file:
        return json.load(file)


def has_ended(folder, name):
    return os.path.exists(os.path.join(folder, name, "points.csv"))


def evaluated(clod, folder, text):
    """The locus of a table of points, by clod locus. It is in a folder like that of a run: points of simulations have
    a locus whatever its angles are, measured ones are refused where no solid has them."""
    if not studies.is_there(clod):
        sys.exit(2)
    of_runs = os.path.join(folder, "joined")
    os.makedirs(of_runs, exist_ok=True)
    open(os.path.join(of_runs, ".clod-lock"), "w").close()
    path = os.path.join(of_runs, "points.csv")
    with open(path, "w") as file:
        file.write(text)
    done = subprocess.run([clod, "locus", path, "--json"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["loci"][0]


def of_tests(clod, folder, names):
    """One locus over the points of one or several tests; None when one has not ended."""
    rows = []
    for name in names:
        if not has_ended(folder, name):
            return None
        with open(os.path.join(folder, name, "points.csv"), newline="") as file:
            rows += csv.DictReader(file)
    columns = list(dict.fromkeys(name for row in rows for name in row))  # programs of before 2026-11-28 have no rho_inside
    lines = [columns, *([row.get(name, "") for name in columns] for row in rows)]
    return evaluated(clod, folder, "".join(",".join(line) + "\n" for line in lines))


def peaks(folder, name):
    """Peak of each point [Pa]."""
    with open(os.path.join(folder, name, "points.csv")) as file:
        return [float(row["tau_sh [Pa]"]) for row in csv.DictReader(file)]


def points_without_peak(folder, name):
    """Number of points whose stress rose until the longest shear."""
    return sum("no peak" in part.get("flags", []) for part in summary(folder, name)["parts"])


def rising(folder, name):
    """How fast the shear stress still rose where preshear ended, and its error [kPa/mm]; 0 and None where it was steady."""
    preshear = next(part for part in summary(folder, name)["parts"] if part["part"] == "preshear")
    if preshear["steady"]:
        return 0.0, None
    return 1e-6 * preshear["shear_stress_rate_Pa_per_m"], 1e-6 * preshear["shear_stress_rate_error_Pa_per_m"]


def rows_of(folder, name, part, phase):
    """Pairs (way [m], shear stress [Pa]) of a phase of a part."""
    with open(os.path.join(folder, name, part + ".csv")) as file:
        return [(float(row["displacement [m]"]), float(row["shear_stress [Pa]"]))
                for row in csv.DictReader(file) if float(row["phase [1]"]) == phase]


def largest_mean(rows, window):
    """Largest mean of the shear stress over `window` metres of way [Pa]; None: the way is shorter."""
    sums = [0.0]  # of stress times way
    for (before, _), (after, stress) in zip(rows, rows[1:]):
        sums.append(sums[-1] + stress * (after - before))
    largest, begin = None, 0
    for end, (place, _) in enumerate(rows):
        while begin + 1 < end and place - rows[begin + 1][0] >= window:
            begin += 1
        if place - rows[begin][0] >= window:
            mean = (sums[end] - sums[begin]) / (place - rows[begin][0])
            largest = mean if largest is None else max(largest, mean)
    return largest


def with_window(clod, folder, name, window):
    """The locus of a test whose peaks are those of another window; None when it is too wide."""
    with open(os.path.join(folder, name, "points.csv")) as file:
        table = list(csv.reader(file))
    column = table[0].index("tau_sh [Pa]")
    for number, row in enumerate(table[1:], 1):
        peak = largest_mean(rows_of(folder, name, f"point-{number}", SHEAR), window)
        if peak is None:
            return None
        row[column] = f"{peak:.9g}"
    return evaluated(clod, folder, "".join(",".join(row) + "\n" for row in table))


def angle_of_highest(folder, name):
    """Angle [deg] of the straight line through the highest shear stress recorded at each point, not smoothed."""
    with open(os.path.join(folder, name, "points.csv")) as file:
        stresses = [float(row["sigma_sh [Pa]"]) for row in csv.DictReader(file)]
    points = [(stress, max(tau for _, tau in rows_of(folder, name, f"point-{number}", SHEAR)))
              for number, stress in enumerate(stresses, 1)]
    return math.degrees(math.atan(reading.slope(points)))


def mean(values):
    return sum(values) / len(values)


def error(values):
    """Standard error of the mean of independent values; of a single one it is not known."""
    if len(values) < 2:
        return math.nan
    middle = mean(values)
    return math.sqrt(sum((value - middle) ** 2 for value in values) / (len(values) - 1) / len(values))


def told(values, sign="", digits=1):
    """Mean ± standard error."""
    text = f"{mean(values):{sign}.{digits}f}"
    return text if len(values) < 2 else f"{text} ± {error(values):.{digits}f}"


def cell(value, scale=1.0, digits=1):
    """A number of clod locus with its error."""
    if value is None or value["value"] is None:
        return "-"
    text = f"{value['value'] * scale:.{digits}f}"
    if value.get("error"):
        text += f" ± {value['error'] * scale:.{digits}f}"
    return text
