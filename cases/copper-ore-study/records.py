"""Results of the study's tests in tables, so that tests of several machines come together: tests.csv, a row for each
test, and beside it points.csv, a row for each shear point, from which yield loci can be evaluated again.

A number that a test has not (phi_e where sigma_2 is tension) is empty. Tests of before 2026-11-28 have no points, and
none of the columns from `rising` on.
"""

import csv
import os

import loci
import settings

HIGHEST = "highest points"
SCALES = {"phi_lin": ("phi_lin_deg", 1.0), "phi_e": ("phi_e_deg", 1.0), "phi_sf": ("phi_sf_deg", 1.0),
          "c": ("c_Pa", 1e-3), "tau_p": ("tau_p_Pa", 1e-3), "sigma_1": ("sigma_1_Pa", 1e-3),
          "sigma_c": ("sigma_c_Pa", 1e-3), "ffc": ("ffc", 1.0), "rho_b": ("rho_b_kg_m3", 1.0),
          "rho_inside": ("rho_inside_kg_m3", 1.0)}
UNITS = {"phi_lin": "deg", "phi_e": "deg", "phi_sf": "deg", HIGHEST: "deg", "c": "kPa", "tau_p": "kPa",
         "sigma_1": "kPa", "sigma_c": "kPa", "ffc": "1", "rho_b": "kg/m3", "rising": "kPa/mm",
         "rising error": "kPa/mm", "far right": "1", "no peak": "1", "rho_inside": "kg/m3"}
HEADER = ["test", "clod"] + [f"{name} [{unit}]" for name, unit in UNITS.items()]


def of_test(clod, folder, name):
    """Numbers of a test that has ended, by their names, in the units of the table; None: it has no such number.
    rising: of the shear stress where preshear ended, 0 where it was steady. far right: points whose normal stress is above what
    the steady-state circle allows; no peak: points that rose to the end."""
    locus = loci.of_tests(clod, folder, [name])
    found = {key: None if locus[of]["value"] is None else scale * locus[of]["value"]
             for key, (of, scale) in SCALES.items()}
    found[HIGHEST] = loci.angle_of_highest(folder, name)
    found["rising"], found["rising error"] = loci.rising(folder, name)
    found["far right"] = sum("far right" in text for text in locus["warnings"])
    found["no peak"] = loci.points_without_peak(folder, name)
    found["clod"] = loci.summary(folder, name)["version"]
    return found


def of_folder(clod, folder):
    """{test: its numbers} of all tests that have ended in a folder."""
    return {name: of_test(clod, folder, name) for name in settings.TESTS if loci.has_ended(folder, name)}


def read(path):
    """{test: its numbers} of the table; empty without it."""
    if not os.path.exists(path):
        return {}
    with open(path, newline="") as file:
        return {row["test"]: {"clod": row["clod"]} |
                {name: float(row[f"{name} [{unit}]"]) if row.get(f"{name} [{unit}]") else None
                 for name, unit in UNITS.items()} for row in csv.DictReader(file)}


def write(path, rows):
    """The table, in the order of the study; six digits of each number."""
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(HEADER)
        for name in settings.TESTS:
            if name in rows:
                values = [rows[name][key] for key in UNITS]
                table.writerow([name, rows[name]["clod"]] + ["" if v is None else f"{v:.6g}" for v in values])


POINTS = ["test", "sigma_pre [Pa]", "tau_pre [Pa]", "tau_pre_error [Pa]", "sigma_sh [Pa]", "tau_sh [Pa]",
          "tau_sh_error [Pa]", "rho_b [kg/m3]", "rho_inside [kg/m3]"]


def points_beside(kept):
    """The table of points beside that of tests."""
    return os.path.join(os.path.dirname(os.path.abspath(kept)), "points.csv")


def write_points(path, folder):
    """Put the shear points of tests that have ended in a folder into a table, in place of those of the same tests."""
    rows = {}
    if os.path.exists(path):
        with open(path, newline="") as file:
            for row in csv.DictReader(file):
                rows.setdefault(row["test"], []).append(row)
    for name in settings.TESTS:
        if loci.has_ended(folder, name):
            with open(os.path.join(folder, name, "points.csv"), newline="") as file:
                rows[name] = [row | {"test": name} for row in csv.DictReader(file)]
    with open(path, "w", newline="") as file:
        table = csv.DictWriter(file, POINTS, restval="", extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        for name in settings.TESTS:
            table.writerows(rows.get(name, []))
