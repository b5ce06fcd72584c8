"""An error that nothing tells is null in JSON, an empty cell in CSV and "-" in tables: a 0 would be a measurement without
error. What clod wrote it reads again as not known."""

import csv
import io
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

WALL = "sigma_w [kPa],tau_w [kPa]%s\n10,4%s\n5,2.1%s\n3,1.2%s\n"
DENSITY = "sigma_1 [kPa],rho_b [kg/m3]%s\n3,1310%s\n5,1350%s\n10,1400%s\n"
SHEAR = "seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
ROWS = "{0},10,{1},3,3.2,1400\n{0},10,7.1,5,4.3,1400\n{0},10,7.2,7,5.4,1400\n"
PLAN = """points: 5
tests: {{wall: {{case: {case}}}}}
parameters: {{friction: {{key: contacts.ore-plate.friction, from: 0.1, to: 0.3}}}}
targets: [{{test: wall, locus: {table}{error}}}]
"""
KEYS = {"wall": ("tau_w_error", "_Pa", " [Pa]"), "density": ("rho_b_error", "_kg_m3", " [kg/m3]")}


class Unknown(clod.Case):

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def told(self, *arguments):
        done = clod.run(*arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def errors(self, name, key):
        """Of the points: in JSON, and the cells of the CSV."""
        base, unit, bracket = KEYS[key]
        points = json.loads(self.told("locus", name, "--json"))["points"]
        rows = list(csv.DictReader(io.StringIO(self.told("locus", name, "--csv"))))
        return [point[base + unit] for point in points], [row[base + bracket] for row in rows]

    def test_of_points(self):
        for key, text, column, error in (("wall", WALL, ",tau_w_error [kPa]", 0.1), ("density", DENSITY, ",rho_b_error [kg/m3]", 12)):
            self.write("without.csv", text % ("", "", "", ""))
            self.assertEqual(self.errors("without.csv", key), ([None] * 3, [""] * 3))
            stated = error * (1e3 if key == "wall" else 1)
            self.write("with.csv", text % ((column,) + (f",{error}",) * 3))
            self.assertEqual(self.errors("with.csv", key), ([stated] * 3, [f"{stated:g}"] * 3))
            self.write("one.csv", text % (column, f",{error}", ",", ","))
            self.assertEqual(self.errors("one.csv", key), ([stated, None, None], [f"{stated:g}", "", ""]))

    def test_of_the_stress_on_them(self):
        self.write("wall.csv", WALL % ("", "", "", ""))
        self.write("density.csv", DENSITY % ("", "", "", ""))
        wall, density = (json.loads(self.told("locus", name, "--json"))["points"] for name in ("wall.csv", "density.csv"))
        self.assertEqual({point["sigma_w_error_Pa"] for point in wall}, {None})
        self.assertEqual({point["sigma_1_error_Pa"] for point in density}, {None})
        rows = list(csv.DictReader(io.StringIO(self.told("locus", "wall.csv", "--csv"))))
        self.assertEqual({row["sigma_w_error [Pa]"] + row["wall_stress [Pa]"] for row in rows}, {""})
        rows = list(csv.DictReader(io.StringIO(self.told("locus", "density.csv", "--csv"))))
        self.assertEqual({row["sigma_1_error [Pa]"] for row in rows}, {""})

    def test_of_means_of_one_number(self):
        """sigma_p and rho_b are set or rounded numbers: that they do not scatter says nothing of their errors."""
        for rows in (ROWS.format(1, 7), ROWS.format(1, 7) + ROWS.format(2, 7.3)):
            self.write("shear.csv", SHEAR + rows)
            found = json.loads(self.told("locus", "shear.csv", "--json"))["loci"][0]
            self.assertIsNone(found["sigma_p_Pa"]["error"])
            self.assertIsNone(found["rho_b_kg_m3"]["error"])
            self.assertGreater(found["tau_p_Pa"]["error"], 0.0)
            row, = csv.DictReader(io.StringIO(self.told("locus", "shear.csv", "--csv")))
            self.assertEqual((row["sigma_p_error [Pa]"], row["rho_b_error [kg/m3]"]), ("", ""))
            table = self.told("locus", "shear.csv")
            self.assertRegex(table, r"sigma_p +10\.000 ± +-[ \n]")
            self.assertRegex(table, r"rho_b +1400\.0 ± +-[ \n]")

    def test_clod_reads_what_it_wrote(self):
        """clod locus evaluates it as before, and clod hopper designs by it as by the first table: errors are the scatter about the wall's
        line, sqrt(syy - sxy^2/sxx) = sqrt(4.086667 - 10.3^2/26) kPa, not what was stated."""
        for name, text in (("wall", WALL), ("density", DENSITY)):
            self.write(f"{name}.csv", text % ("", "", "", ""))
            self.told("locus", f"{name}.csv", "--csv", "-o", f"{name}2.csv")
            self.assertEqual(self.told("locus", f"{name}2.csv", "--json"), self.told("locus", f"{name}.csv", "--json"))
        self.write("flow.csv", "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],phi_t [deg]\n2,1.4,0.05,48,40\n8,2.9,0.08,46,39\n")
        designs = []
        for number in ("", "2"):
            self.write("hopper.yaml", f"flow_function: {{file: flow.csv}}\nwall_friction: {{file: wall{number}.csv}}\n"
                       f"bulk_density: {{file: density{number}.csv}}\n")
            designs.append(json.loads(self.told("hopper", "hopper.yaml", "--json", "--set", "interval.samples=100")))
        self.assertEqual(*designs)
        for point in designs[0]["measured"]["wall"]:
            self.assertAlmostEqual(point["y_error"], 79.259, delta=1e-2)
        self.assertEqual({point["y_error"] is None for point in designs[0]["measured"]["flow_function"]}, {False})

    def test_clod_calibrate_reads_what_it_wrote(self):
        """A table without errors needs one in the plan; what clod locus made of it, too."""
        self.write("wall.csv", WALL.replace("10,4", "20,4").replace("3,1.2", "10,2.1").replace("5,2.1", "5,1.1") % ("", "", "", ""))
        self.told("locus", "wall.csv", "--csv", "-o", "wall2.csv")
        for error, code in (("", 2), (", error: 0.5 deg", 0)):
            said = []
            for table in ("wall.csv", "wall2.csv"):
                self.write("plan.yaml", PLAN.format(case=clod.source("tests/cli/wall_friction.yaml"), table=table, error=error))
                done = clod.run("calibrate", "plan.yaml", "--check", cwd=self.folder)
                self.assertEqual(done.returncode, code, done.stderr)
                told = (done.stdout + done.stderr).replace(table, "TABLE").splitlines()
                said.append([line for line in told if "by the estimate of clod check" not in line])  # of now
            self.assertEqual(*said)
            self.assertEqual(sum("the table has no tau_w_error" in line for line in said[0]), 3 if code == 2 else 0, said[0])


if __name__ == "__main__":
    clod.main()
