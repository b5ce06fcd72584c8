"""Errors of one yield locus, which clod hopper draws together where the table of clod locus has their correlations."""

import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import clod

CASE = "flow_function: {%s}\nwall_friction: {angle: 18 deg, error: 0.5 deg}\n"
APART = "Errors of one yield locus (sigma_1, f_c, phi_e, phi_t) are drawn independently in %d of 2 rows"
TOGETHER = "Errors of one yield locus (sigma_1, f_c, phi_e, phi_t) are drawn together."
ONE = "Yield loci: errors of one specimen: scatter between specimens not included."
JENIKE = ONE.replace(".", ", unless each point has its own, as in a Jenike tester.")
HEAD = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],phi_e_error [deg],rho_b [kg/m3],correlation_f_c_phi_e [%s]\n"


class Joint(hopper_case.Case):

    def points(self):
        """Points of four stresses at two preshears, off a line by some 2 %."""
        rows = [f"{p},{0.99 * (c + 0.75 * p) * f:.4f},{k * p},{(c + 0.75 * k * p) * g:.4f},{1250 + 20 * p}"
                for p, c in ((3, 0.55), (10, 1.3))
                for k, f, g in ((0.3, 1.01, 1.02), (0.45, 0.98, 0.97), (0.6, 1.0, 0.99), (0.75, 1.02, 1.01))]
        self.write("points.csv", "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
                   + "\n".join(rows) + "\n")
        return clod.run("locus", "points.csv", "--csv", cwd=self.folder).stdout

    def test_a_preshear_without_an_error_is_not_exact(self):
        """A laboratory's printed report has one tau_pre for each locus. The points as such and their table say the same."""
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]%s\n"
        rows = [f"{p},{t},{k * p},{c + 0.7 * k * p * f:.4f},{r}" for p, t, c, r in ((3, 2.5, 0.6, 1250), (10, 7.9, 1.4, 1300))
                for k, f in ((0.3, 1.01), (0.45, 0.98), (0.6, 1.0), (0.75, 1.01))]
        words = "Without errors, and so not part of the intervals: "
        missing = "shear stress of preshear (tau_pre_error) in sigma_1 and phi_e"
        for more, cell, warned in (("", "", True), (",tau_pre_error [kPa]", ",0.1", False)):
            self.write("points.csv", head % more + "".join(row + cell + "\n" for row in rows))
            self.write("table.csv", clod.run("locus", "points.csv", "--csv", cwd=self.folder).stdout)
            for key in ("shear_tests: [{points: points.csv}]", "file: table.csv"):
                self.write("case.yaml", CASE % key)
                told = self.told()
                self.assertEqual(words + missing in told, warned, told)

    def told(self):
        return " ".join(self.hopper("case.yaml").stdout.split())

    def test_specimens_are_what_the_seed_numbers(self):
        """Of a preshear for each point nothing tells whether a specimen belongs to it, but a seed does; so it is in a table of loci."""
        self.points()
        with open(self.path("points.csv")) as file:
            head, *rows = file.read().splitlines()
        self.write("case.yaml", CASE % "shear_tests: [{points: points.csv}]")
        for seeds, told in (("1", [ONE]), ("12", [])):
            self.write("points.csv", f"seed,{head}\n" + "".join(f"{seed},{row}\n" for seed in seeds for row in rows))
            self.assertEqual([text for text in self.found()["warnings"] if "errors of one specimen" in text], told)
        self.write("table.csv", clod.run("locus", "points.csv", "--csv", cwd=self.folder).stdout)
        self.write("case.yaml", CASE % "file: table.csv")
        self.assertEqual([text for text in self.found()["warnings"] if "errors of one specimen" in text], [])

    def test_a_table_of_loci_gives_the_intervals_of_its_points(self):
        """To the ten digits of the table; without the correlations others."""
        table = self.points()
        self.write("case.yaml", CASE % "shear_tests: [{points: points.csv}]")
        points = self.found()
        self.assertIn(TOGETHER, self.told())
        self.assertIn(JENIKE, points["warnings"])
        self.write("table.csv", table)
        self.write("case.yaml", CASE % "file: table.csv")
        loci = self.found()
        self.assertIn(TOGETHER, self.told())
        self.assertIn(JENIKE, loci["warnings"])
        lines = [line.split(",") for line in table.splitlines()]
        self.assertEqual([cell.split(" ")[0] for cell in lines[0][-6:]], [
            "correlation_" + pair for pair in ("sigma_1_sigma_c", "sigma_1_phi_e", "sigma_1_phi_lin",
                                               "sigma_c_phi_e", "sigma_c_phi_lin", "phi_e_phi_lin")])
        self.write("table.csv", "".join(",".join(line[:-6]) + "\n" for line in lines))
        apart = self.found()
        self.assertIn(APART % 2, self.told())
        self.write("table.csv", "".join(",".join(line if k != 1 else line[:-6] + [""] * 6) + "\n"
                                        for k, line in enumerate(lines)))
        partly = self.found()
        self.assertIn(APART % 1, self.told())
        counts = [(of["interval"]["loci_drawn_together"], of["interval"]["loci_drawn_apart"])
                  for of in (points, loci, apart, partly)]
        self.assertEqual(counts, [(2, 0), (2, 0), (0, 2), (1, 1)])
        for shape in ("cone", "wedge"):
            for end in ("value", "low", "high"):
                self.assertAlmostEqual(loci[shape]["outlet_m"][end], points[shape]["outlet_m"][end], delta=1e-6)
            self.assertGreater(abs(apart[shape]["outlet_m"]["high"] - points[shape]["outlet_m"]["high"]), 1e-4)
        self.hopper("case.yaml", "-o", "design")
        with open(self.path("design.html")) as file:
            self.assertIn(APART % 1, file.read())

    def test_the_table_weighs_as_the_points_do(self):
        """One laboratory in two ways, three loci whose errors grow with the stress: all points of the flow function alike, and the same
        intervals to the ten digits of the table; also where it is of several specimens, and has no correlations."""
        rows = [f"{p},{0.99 * (c + 0.75 * p) * f:.4f},{k * p},{(c + 0.75 * k * p) * g:.4f},{1250 + 20 * p}"
                for p, c in ((2, 0.4), (5, 0.8), (12, 1.5))
                for k, f, g in ((0.3, 1.01, 1.02), (0.45, 0.98, 0.97), (0.6, 1.0, 0.99), (0.75, 1.02, 1.01))]
        self.write("points.csv", "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n" + "\n".join(rows) + "\n")
        self.write("case.yaml", CASE % "shear_tests: [{points: points.csv}]")
        points = self.found()
        self.write("table.csv", clod.run("locus", "points.csv", "--csv", cwd=self.folder).stdout)
        self.write("case.yaml", CASE % "file: table.csv")
        table = self.found()
        self.assertIs(points["flow_function_line"]["weighted"], False)
        self.assertIs(table["flow_function_line"]["weighted"], False)
        for path in (("cone", "outlet_m"), ("wedge", "outlet_m"), ("cone", "half_angle_deg"), ("rathole", "emptying_m")):
            one, other = (found[path[0]][path[1]] for found in (points, table))
            for end in ("value", "low", "high"):
                self.assertAlmostEqual(one[end], other[end], delta=1e-6 * other["value"], msg=path)
        self.write("table.csv", clod.run("locus", clod.source("cases/lab-to-outlet/shear.csv"), "--csv", cwd=self.folder).stdout)
        self.assertIs(self.found()["flow_function_line"]["weighted"], False)

    def test_three_seeds_tell_their_scatter_roughly(self):
        """5 % of Student's t of 2 lie above 2.920, of a normal distribution above 1.645; one error, so small that all is linear in it, and
        intervals are wider by that ratio, 1.775, as far as the samples tell."""
        self.write("case.yaml", "flow_function: {file: table.csv}\nwall_friction: {angle: 18 deg}\n")
        head = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],sigma_1_error [kPa],phi_e [deg],rho_b [kg/m3]%s\n"
        few = "the intervals rest on the scatter of 3 specimens"
        for error in ("0.01,0", "1e-6,0.01"):
            width = []
            for more, cell, told in (("", "", 0), (",seeds", ",3", 1), (",seeds", ",1", 0), (",seeds", ",1000000000000", 0)):
                self.write("table.csv", head % more + f"3,1.2,{error},45,1250{cell}\n10,2.6,1e-6,0,45,1350{cell}\n")
                found = json.loads(clod.run("hopper", "case.yaml", "--json", "--set", "interval.samples=4000", cwd=self.folder).stdout)
                outlet = found["cone"]["outlet_m"]
                width.append(outlet["high"] - outlet["low"])
                self.assertEqual(len([text for text in found["warnings"] if few in text]), told)
            self.assertAlmostEqual(width[1] / width[0], 2.920 / 1.645, delta=0.2)
            self.assertAlmostEqual(width[2], width[0])
            self.assertAlmostEqual(width[3], width[0])

    def test_the_json_of_loci_has_the_correlations(self):
        table = self.points().splitlines()
        loci = json.loads(clod.run("locus", "points.csv", "--json", cwd=self.folder).stdout)["loci"]
        for line, locus in zip(table[1:], loci):
            of = locus["error_correlations"]
            self.assertEqual(len(of), 6)
            for name, cell in zip(table[0].split(",")[-6:], line.split(",")[-6:]):
                self.assertAlmostEqual(of[name[len("correlation_"):-len(" [1]")]], float(cell), places=9)
        seeds = clod.run("locus", clod.source("cases/lab-to-outlet/shear.csv"), "--csv", cwd=self.folder).stdout
        self.assertEqual([line.split(",")[-6:] for line in seeds.splitlines()[1:]], 3 * [6 * [""]])

    def test_correlations_that_cannot_be_are_refused(self):
        rows = "2,1.4,0.1,48,1,1250,%s\n8,2.9,0.1,46,1,1350,0.5\n"
        self.write("case.yaml", CASE % "file: flow.csv")
        self.write("flow.csv", HEAD % "1" + rows % "-0.5")
        self.assertEqual(self.found()["interval"]["loci_drawn_together"], 2)
        self.write("flow.csv", HEAD % "%" + (rows % "-50").replace(",0.5\n", ",50\n"))
        self.assertEqual(self.found()["interval"]["loci_drawn_together"], 2)
        for cell in ("1.2", "-1.01"):
            self.write("flow.csv", HEAD % "1" + rows % cell)
            done = self.hopper("case.yaml", code=2)
            self.assertIn(f'flow.csv:2: column correlation_sigma_c_phi_e: "{cell}" must be -1 to 1.', done.stderr)
        head = HEAD.replace("rho_b [kg/m3]", "sigma_1_error [kPa],rho_b [kg/m3],correlation_sigma_1_f_c [1],correlation_sigma_1_phi_e [1]")
        self.write("flow.csv", head % "1" + "2,1.4,0.1,48,1,0.1,1250,0.9,0.9,-0.9\n")
        done = self.hopper("case.yaml", code=2)
        self.assertIn("flow.csv:2: no errors have these correlations together", done.stderr)

    def test_a_cell_that_is_looser_than_its_core_is_told(self):
        """Warned of, from points and from a table, unless the density is given; it changes nothing else."""
        self.points()
        self.write("case.yaml", CASE % "shear_tests: [{points: points.csv}]")
        before = self.found()
        with open(self.path("points.csv")) as file:
            head, *rows = file.read().splitlines()
        for times, told in ((1.02, 0), (1.3, 1)):
            self.write("points.csv", head + ",rho_inside [kg/m3]\n" + "".join(
                f"{row},{times * float(row.rsplit(',', 1)[1]):.1f}\n" for row in rows))
            text = self.told()
            self.assertEqual(text.count("Bulk density: away from the walls of the cell"), told)
            self.assertEqual(self.found()["cone"]["outlet_m"]["value"], before["cone"]["outlet_m"]["value"])
        self.assertRegex(text, r"it was (1703 kg/m3 at sigma_1 [\d.]+ kPa, 30 % above rho_b, 1310|1885 kg/m3 at "
                               r"sigma_1 [\d.]+ kPa, 30 % above rho_b, 1450) kg/m3, which is used here")
        self.write("case.yaml", CASE % "shear_tests: [{points: points.csv}]" + "bulk_density: {value: 1700 kg/m3}\n")
        self.assertNotIn("away from the walls", self.told())
        # a table of clod locus has the column, and rho_b is what counts there
        self.write("table.csv", clod.run("locus", "points.csv", "--csv", cwd=self.folder).stdout)
        self.write("case.yaml", CASE % "file: table.csv")
        self.assertAlmostEqual(self.found()["cone"]["outlet_m"]["value"], before["cone"]["outlet_m"]["value"],
                               delta=1e-6)
        self.assertIn("Bulk density: away from the walls of the cell", self.told())
        flow = "sigma_1 [kPa],f_c [kPa],phi_e [deg],rho_b [kg/m3],rho_inside [kg/m3]\n"
        self.write("table.csv", flow + "2,1.4,48,1250,1260\n8,2.9,46,1350,\n")  # one cell is empty
        self.assertNotIn("away from the walls", self.told())
        self.write("table.csv", flow + "2,1.4,48,1250,1500\n8,2.9,46,1350,1400\n")
        self.assertIn("it was 1500 kg/m3 at sigma_1 2.000 kPa, 20 % above rho_b, 1250 kg/m3", self.told())
        self.write("table.csv", flow + "2,1.4,48,1250,1.5\n8,2.9,46,1350,1400\n")
        self.assertIn("table.csv:2: column rho_inside: 1.5 kg/m3", self.hopper("case.yaml", code=2).stderr)


if __name__ == "__main__":
    clod.unittest.main()
