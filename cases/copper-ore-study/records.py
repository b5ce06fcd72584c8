"""Results of the study's tests in one table, so that tests of several machines come together: tests.csv.

A row is a test; a number that a test has not (phi_e where sigma_2 is tension) is empty.
"""

import csv
import os

import loci
import settings

HIGHEST = "highest points"
SCALES = {"phi_lin": ("phi_lin_deg", 1.0), "phi_e": ("phi_e_deg", 1.0), "phi_sf": ("phi_sf_deg", 1.0),
          "c": ("c_Pa", 1e-3), "tau_p": ("tau_p_Pa", 1e-3), "sigma_1": ("sigma_1_Pa", 1e-3),
          "sigma_c": ("sigma_c_Pa", 1e-3), "ffc": ("ffc", 1.0), "rho_b": ("rho_b_kg_m3", 1.0)}
UNITS = {"phi_lin": "deg", "phi_e": "deg", "phi_sf": "deg", HIGHEST: "deg", "c": "kPa", "tau_p": "kPa",
         "sigma_1": "kPa", "sigma_c": "kPa", "ffc": "1", "rho_b": "kg/m3"}
HEADER = ["test", "clod"] + [f"{name} [{unit}]" for name, unit in UNITS.items()]


def of_test(clod, folder, name):
    """Numbers of a test that has ended, by their names, in the units of the table; None: it has no such number."""
    locus = loci.of_tests(clod, folder, [name])
    found = {key: None if locus[of]["value"] is None else scale * locus[of]["value"]
             for key, (of, scale) in SCALES.items()}
    found[HIGHEST] = loci.angle_of_highest(folder, name)
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
                {name: float(row[f"{name} [{unit}]"]) if row[f"{name} [{unit}]"] else None
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
