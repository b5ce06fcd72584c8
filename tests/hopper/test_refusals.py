"""What clod hopper refuses: cases, tables, shear tests, measurements that cannot be, and the command line."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hopper_case
from hopper_case import CASE, FLOW, ROWS, clod


class Refusals(hopper_case.Case):

    def test_cases_with_mistakes(self):
        bad = CASE.replace("angle: 20 deg", "angle: 20")
        self.refuse(bad, ["case.yaml:2:24: wall_friction.angle", "deg", "^"])
        self.refuse(CASE.replace("20 deg", "95 deg"), ["is out of range", "85 deg"])
        self.refuse(CASE + "marign: 2 deg\n", ["marign", "did you mean margin?"])
        self.refuse("wall_friction: {angle: 20 deg}\n", ["needs the key flow_function"])
        self.refuse("flow_function: {curve: line}\nwall_friction: {angle: 20 deg}\n",
                    ["case.yaml:1:1: flow_function", "needs file"])
        self.refuse("flow_function: {file: flow.csv}\nwall_friction: {error: 1 deg}\n",
                    ["case.yaml:2:1: wall_friction", "needs file or angle"])
        self.refuse(CASE.replace("angle:", "file: w.csv, angle:"),
                    ["has file and angle; keep one of them"])
        self.refuse(CASE, ["margin", "is out of range"], more=["--set", "margin=40 deg"])
        self.refuse("", ["is empty; clod new hopper writes an example"])
        self.refuse("- a\n", ["must be a section with keys"])

    def test_a_test_that_is_named_twice(self):
        tests = "flow_function: {shear_tests: [{points: p.csv}, {points: q.csv}, {points: p.csv}]}\nwall_friction: {angle: 18 deg}\n"
        self.refuse(tests, ["case.yaml:1:17: flow_function.shear_tests", "p.csv twice; leave one out"])

    def test_a_design_without_a_name(self):
        for name in ("", "out/"):
            done = self.hopper("case.yaml", "-o", name, code=2)
            self.assertIn(f'-o "{name}" has no name; give one, e.g. -o design', done.stderr)

    def test_a_case_for_another_verb(self):
        clod.run("new", "hopper", cwd=self.folder)
        clod.run("new", "free-run", cwd=self.folder)
        done = self.hopper("free-run.yaml", code=2)
        self.assertIn("free-run.yaml:3:1: is a simulation's case, not a hopper's case; clod run",
                      done.stderr)
        self.assertNotIn("not known", done.stderr)
        self.write("card.yaml", "contacts:\n  default: {k_adh: 1e6 N/m^1.5}\n")
        self.write("plan.yaml", "tests: {}\ntargets: []\n")
        said = {"hopper.yaml": "is a hopper's case, not a simulation's case; clod hopper reads it",
                "plan.yaml": "is the plan of a calibration, not a simulation's case; clod calibrate",
                "card.yaml": "is a material card, not a simulation's case; a simulation's case takes "
                             "it in with include: FILE"}
        for verb in ("run", "check", "contact"):
            for name, text in said.items():
                done = clod.run(verb, name, cwd=self.folder)
                self.assertEqual(done.returncode, 2)
                self.assertIn(text, done.stderr)
                self.assertNotIn("not known", done.stderr)
        for name in ("plan.yaml", "card.yaml"):
            self.assertIn(said[name].replace("a simulation's case", "a hopper's case", 1),
                          self.hopper(name, code=2).stderr)
        done = clod.run("calibrate", "hopper.yaml", cwd=self.folder)
        if "without GSL" not in done.stderr:
            self.assertEqual(done.returncode, 2)
            self.assertIn("is a hopper's case, not the plan of a calibration", done.stderr)

    def test_a_run_that_is_not_finished(self):
        """Its folder has no table yet."""
        os.mkdir(self.path("run"))
        self.refuse(CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: run}"),
                    ["run: the folder has no wall_friction.csv: its run is not finished"])
        self.refuse("flow_function: {shear_tests: [{points: run}]}\nwall_friction: {angle: 20 deg}\n",
                    ["run: the folder has no points.csv: its run is not finished"])

    def test_shear_points_without_preshear(self):
        """Only clod locus has options for it."""
        tests = "flow_function: {shear_tests: [{points: p.csv}]}\nwall_friction: {angle: 18 deg}\n"
        self.write("p.csv", "sigma_sh [kPa],tau_sh [kPa]\n1,1.4\n2,2.1\n")
        self.refuse(tests, ["p.csv:1: the header has no column sigma_pre; add it."])
        self.write("p.csv", "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
                   "4,,1,1.4\n")
        self.refuse(tests, ['p.csv:2: column tau_pre: "" is empty; fill it in.'])
        self.assertNotIn("--tau-pre", self.hopper("case.yaml", code=2).stderr)

    def test_yield_loci_that_no_solid_has(self):
        """A falling one and one whose sigma_2 is tension say so, not that a column is missing. By hand, of the
        second: tau = 9 + 0.577 sigma, and the circle through the preshear point (4, 11) that touches it."""
        tests = "flow_function: {shear_tests: [{points: p.csv}, {points: q.csv}]}\nwall_friction: {angle: 18 deg}\n"
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
        for cohesion, slope, tau_pre, words in (
                (3.0, -0.5, 1.5, ["p.csv:2, 3, 4: the yield locus at a preshear stress of 4.000 kPa has phi_lin = -26.57 deg; "
                                  "it must be 1 to 80 deg.", "Have sigma_sh and tau_sh been exchanged"]),
                (9.0, 0.577, 11.0, ["phi_e is undefined in every yield locus, since sigma_2 is tension (-",
                                    "at a preshear stress of 4.000 kPa)", "give the key effective_friction."])):
            for name, times in (("p.csv", 1), ("q.csv", 2)):
                self.write(name, head + "".join(
                    f"{4 * times},{times * tau_pre},{times * s},{times * (cohesion + slope * s)},1300\n"
                    for s in (1.0, 2.0, 3.0)))
            self.refuse(tests, words)
            self.assertNotIn("neither the key", self.hopper("case.yaml", code=2).stderr)

    def test_preshear_in_another_unit(self):
        """tau = 0.7 kPa + 0.75 sigma has 3.7 kPa at 4 kPa; at 4 psi, 27.579 kPa, 21.384 kPa. Of a run it is a warning."""
        head = "sigma_pre [{}],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
        rows = "".join(f"4,3.4,{s},{0.7 + 0.75 * s},1300\n" for s in (1.0, 2.0, 3.0))
        other = head.format("kPa") + "".join(f"8,6.4,{s},{1.0 + 0.73 * s},1330\n" for s in (2.0, 4.0, 6.0))
        case = "flow_function: {shear_tests: [{points: other.csv}, {points: LAB}]}\nwall_friction: {angle: 18 deg}\n"
        self.write("other.csv", other)
        self.write("lab.csv", head.format("psi") + rows)
        self.refuse(case.replace("LAB", "lab.csv"),
                    ["lab.csv:2, 3, 4: the yield locus at a preshear stress of 27.579 kPa has tau_pre = 3.400 kPa, 0.159 of the 21.384 kPa"])
        self.write("lab.csv", head.format("kPa") + rows.replace("4,3.4", "4,2.6"))  # 0.70 of it, 0.9 cos(36.87 deg) are 0.72
        self.start(case.replace("LAB", "lab.csv"))
        self.assertTrue([text for text in self.found()["warnings"] if text.startswith(
            "Yield locus at a preshear stress of 4.000 kPa: The preshear point (4.000, 2.600) kPa lies far below the line (3.700 kPa there; "
            "steady flow has 0.72 of it or more)")])
        os.mkdir(self.path("run"))
        self.write("run/.clod-lock", "")
        self.write("run/points.csv", head.format("kPa") + rows.replace("4,3.4", "4,1.4"))  # 0.38 of it
        self.start(case.replace("LAB", "run"))
        self.assertTrue([text for text in self.found()["warnings"] if "lies far below the line (3.700 kPa there" in text])

    def test_shear_stresses_in_another_unit(self):
        """Of a results folder and a file, the second has tau_sh in Pa with kPa above it: by hand atan(0.00073)."""
        head = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [{}],rho_b [kg/m3]\n"
        os.mkdir(self.path("run"))
        self.write("run/points.csv", head.format("kPa") + "".join(
            f"4,3.4,{s},{0.7 + 0.75 * s},1300\n" for s in (1.0, 2.0, 3.0)))
        self.write("high.csv", "# laboratory\n" + head.format("Pa") + "".join(
            f"10,8.1,{s},{1.2 + 0.73 * s},1350\n" for s in (2.5, 5.0, 7.5)))
        self.refuse("flow_function: {shear_tests: [{points: run}, {points: high.csv}]}\nwall_friction: {angle: 18 deg}\n",
                    ["high.csv:3, 4, 5: the yield locus at a preshear stress of 10.000 kPa has "
                     "phi_lin = 0.04 deg; it must be 1 to 80 deg."])

    def test_tables_with_mistakes(self):
        self.refuse(CASE, ["flow.csv:1: the header has no column f_c", "sigma_1 [kPa],f_c"],
                    head=FLOW.replace("f_c [kPa],", "", 1))
        self.refuse(CASE, ['flow.csv:1: there is no column "sigma1"', "sigma_1"],
                    head=FLOW.replace("sigma_1", "sigma1"))
        self.refuse(CASE, ["flow.csv:1: column f_c has no unit"],
                    head=FLOW.replace("f_c [kPa]", "f_c"))
        self.refuse(CASE, ["flow.csv:1: column phi_e [kPa]", "an angle"],
                    head=FLOW.replace("phi_e [deg]", "phi_e [kPa]"))
        self.refuse(CASE, ['flow.csv:2: column phi_e: "95" must be below 90'],
                    rows=ROWS.replace("48", "95"))
        self.refuse(CASE, ['flow.csv:2: column f_c: "-1.4" must be 0 or more'],
                    rows=ROWS.replace("1.4", "-1.4", 1))
        self.refuse(CASE, ["flow.csv:3: 5 cells, but the header has 6 columns"],
                    rows=ROWS.replace("1300", "").replace("40,\n4", "40\n4").replace(
                        "47,40,", "47,40"))
        self.refuse(CASE, ["flow.csv:2: column rho_b: 1.21 kg/m3 is outside 10 to 15000 kg/m3",
                           "[g/cm3]?"], rows="2,1.4,0,48,40,1.21\n8,2.9,0,46,39,1.3\n")
        self.write("rho.csv", "sigma_1 [kPa],rho_b [kg/m3]\n2,1210\n8,1.3\n")
        self.refuse(CASE + "bulk_density: {file: rho.csv}\n",
                    ["rho.csv:3: column rho_b: 1.3 kg/m3 is outside", "[g/cm3]?"])
        self.refuse(CASE + "bulk_density: {value: 1.21 kg/m3}\n",
                    ["bulk_density.value", "is out of range", "10"])
        self.refuse(CASE.replace("flow.csv", "none.csv"), ["none.csv", "No such file"])

    def test_measurements_that_cannot_be(self):
        self.refuse(CASE, ["static angle of internal friction", "above the effective one",
                           "interchanged?"], rows="2,1.4,0,40,48,1250\n8,2.9,0,39,46,1350\n")
        self.refuse(CASE, ["make no flow function"], rows="2,1.4,0,48,40,1250\n")
        self.refuse(CASE, ["phi_e is not known", "effective_friction"],
                    head="sigma_1 [kPa],f_c [kPa],rho_b [kg/m3]\n",
                    rows="2,1.4,1250\n8,2.9,1300\n")
        self.refuse(CASE, ["rho_b is not known", "bulk_density"],
                    head="sigma_1 [kPa],f_c [kPa],phi_e [deg]\n", rows="2,1.4,48\n8,2.9,47\n")
        self.refuse(CASE.replace("flow.csv", "flow.csv, curve: points"),
                    ["two points at nearly the same stress", "curve: line"],
                    head="sigma_1 [kPa],sigma_1_error [kPa],f_c [kPa],phi_e [deg],rho_b [kg/m3]\n",
                    rows="2,0.06,1.4,48,1250\n2.1,0.06,1.5,48,1250\n8,0,2.9,46,1350\n")

    def test_walls_that_cannot_be(self):
        """Two standard errors of hypot(0.03, 0.04) = 0.05 kPa are 0.1; without errors a tenth of 0.6 kPa is allowed."""
        case = CASE.replace("{angle: 20 deg, error: 1 deg}", "{file: wall.csv}")
        head = "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n"

        def falls(points, expected):
            self.write("wall.csv", head + points)
            if expected:
                self.refuse(case, [f"wall.csv: the wall yield locus falls: tau_w is {expected}", "columns, their units"])
            else:
                self.start(case)
                self.found()

        falls("1,1.6,0\n4,0.6,0\n", "1.6 kPa at sigma_w 1 kPa, and 0.6 kPa at 4 kPa")
        falls("1,0.4,0\n4,1.6,0\n8,1.2,0\n", "1.6 kPa at sigma_w 4 kPa, and 1.2 kPa at 8 kPa")
        falls("1,0.6,0\n2,0.55,0\n4,1.6,0\n", "")
        falls("1,0.6,0\n2,0.53,0\n4,1.6,0\n", "0.6 kPa at sigma_w 1 kPa, and 0.53 kPa at 2 kPa")
        falls("1,0.6,0.03\n2,0.51,0.04\n4,1.6,0.1\n", "")
        falls("1,0.6,0.03\n2,0.49,0.04\n4,1.6,0.1\n", "0.6 kPa at sigma_w 1 kPa, and 0.49 kPa at 2 kPa")
        # stresses less than a tenth apart tell no slope: there points, and specimens of one place each, scatter
        falls("0.30,0.080,0\n0.32,0.071,0\n1.2,0.3,0\n", "")
        falls("0.30,0.080,0\n0.32,0.071,0\n0.34,0.070,0\n1.2,0.3,0\n", "0.08 kPa at sigma_w 0.3 kPa, and 0.07 kPa at 0.34 kPa")
        head = "seed," + head
        falls("1,0.30,0.095,0.001\n2,0.31,0.083,0.001\n1,1.2,0.30,0.002\n2,1.22,0.30,0.002\n1,2,0.5,0.002\n2,2.01,0.5,0.002\n", "")
        # specimens of 0.3 and 0.5 kPa at 1 kPa have a standard deviation of 0.14 kPa, 35 %, so those of 2 and 2.5 kPa may be
        # 2 hypot(0.34, 0.25) = 0.84 kPa apart; of 0.39 and 0.41 kPa it is 3.5 %, which leaves 0.084
        other = "2,2,0.95,0.01\n1,2.5,0.72,0.01\n"
        falls("1,1,0.3,0.01\n2,1,0.5,0.01\n" + other, "")
        falls("1,1,0.39,0.01\n2,1,0.41,0.01\n" + other, "0.95 kPa at sigma_w 2 kPa, and 0.72 kPa at 2.5 kPa")
        head = head.removeprefix("seed,")
        # 21.2 deg are 0.37 rad; of a table, tan(0.99 deg) is 0.01728
        self.refuse(CASE.replace("20 deg", "0.37 deg"), ["case.yaml: the wall friction angle is 0.37 deg. No wall is as smooth", "rad"])
        self.write("wall.csv", head + "1,0.01,0\n4,0.06912,0\n")
        self.refuse(case, ["wall.csv: the wall friction angle is 0.99 deg at most"])
        self.write("wall.csv", head + "1,0.01,0\n4,0.072,0\n")
        self.start(case)
        self.assertTrue([text for text in self.found()["warnings"] if "The smoothest liners have some 6 deg" in text])

    def test_tables_of_another_kind(self):
        """Each says what it is, and where it belongs."""
        self.write("shear.csv", "# laboratory\nsigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n5,3,2,1.7\n5,3,4,2.6\n")
        self.write("wall.csv", "sigma_w [kPa],tau_w [kPa]\n1,0.4\n4,1.6\n")
        shear = "shear points (sigma_pre, tau_pre, sigma_sh, tau_sh), which belongs in flow_function.shear_tests"
        wall = "wall friction (sigma_w, tau_w), which belongs in wall_friction.file"
        flow = "a flow function or bulk densities (sigma_1), which belongs in flow_function.file or bulk_density.file"
        self.start()
        for key, table, what in (("wall_friction", "shear", shear), ("wall_friction", "flow", flow),
                                 ("flow_function", "wall", wall), ("bulk_density", "wall", wall),
                                 ("effective_friction", "shear", shear), ("static_friction", "wall", wall)):
            done = self.hopper("case.yaml", "--set", f"{key}={{file: {table}.csv}}", code=2)
            self.assertIn(f"{table}.csv: is a table of {what}; {key}.file takes ", done.stderr)
        self.write("heaps.csv", "heap,angle_of_repose [deg]\n1,33\n2,34\n")  # with a column that its reader alone knows
        done = self.hopper("case.yaml", "--set", "wall_friction={file: heaps.csv}", code=2)
        self.assertIn("heaps.csv: is a table of angles of repose (angle_of_repose), which belongs in a target of clod calibrate; "
                      "wall_friction.file takes wall friction", done.stderr)
        done = self.hopper("case.yaml", "--set", "flow_function={shear_tests: [{points: wall.csv}]}", code=2)
        self.assertIn(f"wall.csv: is a table of {wall}; flow_function.shear_tests takes shear points", done.stderr)

        self.write("density.csv", "sigma_pre [kPa],rho_b [kg/m3]\n3,1200\n12,1300\n")
        done = self.hopper("case.yaml", "--set", "bulk_density={file: density.csv}", code=2)
        self.assertIn("density.csv: is a table of bulk densities over the preshear stress (sigma_pre, rho_b). A table of bulk densities needs "
                      "sigma_1", done.stderr)

    def test_the_command_line(self):
        self.assertIn("which case?", self.hopper(code=2).stderr)
        self.start()
        self.assertIn("one case at a time", self.hopper("case.yaml", "case.yaml", code=2).stderr)
        self.assertIn("none.yaml", self.hopper("none.yaml", code=2).stderr)
        self.assertEqual(self.hopper("case.yaml", "-o", "no/folder", code=1).returncode, 1)


if __name__ == "__main__":
    clod.unittest.main()
