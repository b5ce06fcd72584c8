"""Points in, loci out, as a user pipes them: standard input, CSV with its warnings, refusals."""

import json
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

HEAD = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
GOOD = HEAD + "10,7.6,3,3.1,1650\n10,7.6,5,4.5,1650\n10,7.6,7.5,6.25,1650\n"
# a slip of a bulk density, and a point outside 20 to 80 % of preshear
WRONG = HEAD + "10,7.6,3,3.1,1650\n10,7.6,5,4.5,1560\n10,7.6,9,7.3,1650\n"


class Locus(clod.Case):

    def locus(self, *arguments, code=0, **more):
        done = clod.run("locus", *arguments, cwd=self.folder, **more)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def write(self, name, text, **more):
        with open(self.path(name), "w", **more) as file:
            file.write(text)

    def test_help_has_every_column(self):
        """All columns that a table may have, as its complaint of an unknown one lists them."""
        told = " ".join(self.locus("--help").stdout.split())
        for head, row in (("sigma_w [kPa],tau_w [kPa],place\n", "4,1,2\n"), ("sigma_sh [kPa],tau_sh [kPa],place\n", "4,1,2\n")):
            said = self.locus("-", input=head + row, code=2).stderr
            known = re.search(r"Known are (.*)\.", said)[1]
            names = [name for name in re.findall(r"\w+", re.sub(r"\(or [^)]*\)", "", known))]
            self.assertGreater(len(names), 7)
            for name in names:
                self.assertIn(name, told)

    def test_a_header_that_is_not_known(self):
        """Kinds of table are told, each with columns that make one, where no column says which it is."""
        for head in ("\u03c3_w [kPa],\u03c4_w [kPa]", "normal stress [kPa];shear stress [kPa]", "Probe", "10,7.6,3,3.1"):
            said = self.locus("-", input="# laboratory\n" + head + "\n1,1\n", code=2).stderr
            self.assertIn("standard input: none of the columns in its header says what the table is", said)
        told = re.search(r"that it needs: (.*)\. clod locus --help", said)[1]
        self.assertEqual([kind.split(": ")[0] for kind in told.split("; ")],
                         ["table of shear points", "wall yield locus", "table of bulk densities", "table of angles of repose"])
        for kind in told.split("; "):
            head = re.sub(r" or .*", "", kind.split(": ")[1]).replace(", ", ",")
            rows = {1: "30\n", 2: "10,30\n20,40\n", 4: "10,8,3,3\n10,8,6,5\n"}[head.count(",") + 1]
            self.locus("-", input=head + "\n" + rows)
        for head, words in (("sigma_p [kPa],tau_p [kPa],x", 'no column "x"'), ("Sigma_sh [kPa]", "did you mean sigma_sh?"),
                            ("# nothing", "there is no header in it"), ("\0", "this is no text file")):
            self.assertIn(words, self.locus("-", input=head + "\n1,1\n" * (head[0] != "#"), code=2).stderr)

    def test_densities_of_one_preshear(self):
        """A slip of a factor of 10 is refused, in every form; what a laboratory may see is not."""
        for form in ([], ["--json"], ["--csv"]):
            done = self.locus("-", *form, input=GOOD.replace("6.25,1650", "6.25,165"), code=2)
            self.assertEqual(done.stdout, "")
            self.assertIn("standard input:4: column rho_b: 165 kg/m3, but line 2 has 1650 kg/m3 at the same preshear stress",
                          done.stderr)
        self.assertIn("standard input:2: column rho_b: 1.65 kg/m3 is outside 10 to 15000 kg/m3",
                      self.locus("-", input=GOOD.replace("1650", "1.65"), code=2).stderr)
        self.assertEqual(self.locus("-", "--csv", input=GOOD.replace("6.25,1650", "6.25,1600")).stderr, "")

    def test_standard_input_and_output(self):
        self.write("points.csv", GOOD)
        for form in ([], ["--json"], ["--csv"]):
            told = self.locus("points.csv", *form).stdout
            self.assertGreater(len(told), 100)
            self.assertEqual(self.locus("-", *form, input=GOOD).stdout, told)
            self.assertEqual(self.locus("-", "-o", "-", *form, input=GOOD).stdout, told)
        self.assertEqual(os.listdir(self.folder), ["points.csv"])
        said = self.locus("-", input=GOOD + "10,7.6\n", code=2).stderr
        self.assertIn("clod locus: standard input:5: 2 cells, but the header has 5 columns", said)

    def test_a_pipe_is_read_to_its_end(self):
        """A pipe tells no size, and hands over 64 KiB at a time."""
        long = "".join(f"# remark {k}\n" for k in range(50000)) + GOOD
        self.write("points.csv", GOOD)
        told = self.locus("points.csv").stdout
        self.assertEqual(self.locus("-", input=long).stdout, told)
        self.assertEqual(self.locus("/dev/stdin", input=long).stdout, told)

    def test_a_point_above_its_preshear_is_refused(self):
        """A slip of a digit, 12 for 7.2 kPa, with its line, in every form; 1 % is forgiven."""
        for form in ([], ["--json"], ["--csv"]):
            said = self.locus("-", *form, input=HEAD + "10,7.6,3,3.1,1650\n10,7.6,5,4.5,1650\n10,7.6,12,9.4,1650\n", code=2).stderr
            self.assertIn("standard input:4: shear at 12.000 kPa after a preshear at 10.000 kPa: above its preshear stress a solid "
                          "consolidates anew", said)
        told = self.locus("-", input=HEAD + "10,7.6,3,3.1,1650\n10,7.6,5,4.5,1650\n10,7.6,10.05,8.0,1650\n").stdout
        self.assertIn("Shear at 10.050 kPa is above the preshear stress", told)

    def test_csv_says_its_warnings(self):
        self.write("points.csv", WRONG)
        done = self.locus("points.csv", "--csv")
        self.assertEqual(len(done.stdout.splitlines()), 2)
        wanted = json.loads(self.locus("points.csv", "--json").stdout)["loci"][0]["warnings"]
        self.assertGreaterEqual(len(wanted), 2)
        self.assertEqual(done.stderr.splitlines(),
                         [f"clod locus: preshear at 10.000 kPa: {text}" for text in wanted])
        for text in ("Bulk densities from 1560 to 1650 kg/m3", "is outside 20 to 80 % of the preshear stress"):
            self.assertIn(text, done.stderr)
        self.write("points.csv", GOOD)
        self.assertEqual(self.locus("points.csv", "--csv").stderr, "")

    def test_csv_remarks_on_the_flow_function(self):
        twice = GOOD + "20,15.2,6,4.9,1650\n20,15.2,10,7.7,1650\n20,15.2,15,11.2,1650\n"
        said = self.locus("-", "--csv", input=twice).stderr
        self.assertRegex(said, r"clod locus: sigma_c falls from \S+ to \S+ kPa while")

    def test_angles_that_no_solid_has(self):
        """tau_sh in Pa with kPa above it, a falling line, a steep one; and preshear in Pa. Angles by hand."""
        rows = ((3, 3.1), (5, 4.5), (7.5, 6.25))
        for table, columns, angle in (
                ([(10, 7.6, s, 1e-3 * t) for s, t in rows], "sigma_sh and tau_sh", "phi_lin = 0.04"),  # atan(0.7e-3)
                ([(10, 7.6, s, 8 - 0.5 * s) for s, _ in rows], "sigma_sh and tau_sh", "phi_lin = -26.57"),
                ([(10, 7.6, s, 19 * s - 57) for s, _ in rows], "sigma_sh and tau_sh", "phi_lin = 86.99"),  # atan(19)
                ([(10, 7600, s, t) for s, t in rows], "sigma_pre and tau_pre", "phi_sf = 89.92")):  # atan(760)
            points = HEAD + "".join(",".join(map(str, row)) + ",1650\n" for row in table)
            for form in ([], ["--json"], ["--csv"]):
                done = self.locus("-", *form, input=points, code=2)
                self.assertEqual(done.stdout, "")
                self.assertEqual(done.stderr, "clod locus: standard input:2, 3, 4: the yield locus at a preshear stress of "
                                 f"10.000 kPa has {angle} deg; it must be 1 to 80 deg. Spheres without friction have 6 deg, "
                                 f"and no solid is beyond 80 deg. Have {columns} been exchanged, or has one another unit?\n")

    def test_a_preshear_point_far_below_its_line(self):
        """tau = 2.5 kPa + sigma/2 by hand. In psi with kPa beside it, sigma_pre is 6.894757 times as large."""
        head = "sigma_pre [{}],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n10,{},3,4\n10,{},5,5\n10,{},7,6\n"
        done = self.locus("-", input=head.format("psi", 6.9, 6.9, 6.9), code=2)
        self.assertEqual(done.stdout, "")
        self.assertIn("standard input:2, 3, 4: the yield locus at a preshear stress of 68.948 kPa has tau_pre = 6.900 kPa, 0.187 of "
                      "the 36.974 kPa that the line through its points has there; it must be 0.40 of it or more", done.stderr)
        for tau_pre, told in ((6.9, False), (5.64, False), (5.61, True)):  # 0.75 of 7.5 kPa are 5.625 kPa
            said = self.locus("-", "--csv", input=head.format("kPa", tau_pre, tau_pre, tau_pre)).stderr
            self.assertEqual("lies far below the line (7.500 kPa there; steady flow has 0.75 of it or more)" in said, told)

    def test_names_of_columns(self):
        """Every name that the error tells is taken."""
        said = self.locus("-", input=HEAD.replace("tau_sh", "tua"), code=2).stderr
        self.assertIn("sigma_sh (or sigma_s, sigma), tau_sh (or tau_s, tau)", said)
        told = self.locus("-", input=GOOD).stdout
        for name, others in re.findall(r"(\w+) \(or ([^)]*)\)", said):
            for other in others.split(", "):
                self.assertEqual(self.locus("-", input=GOOD.replace(name + " ", other + " ")).stdout, told)

    def test_two_forms_are_refused(self):
        self.write("points.csv", GOOD)
        for form in (["--json", "--csv"], ["--csv", "--json"]):
            done = self.locus("points.csv", *form, code=2)
            self.assertEqual(done.stdout, "")
            self.assertIn("give either --json or --csv, not both", done.stderr)

    def test_option_beside_a_full_column(self):
        self.write("points.csv", GOOD)
        done = self.locus("points.csv", "--sigma-pre=12kPa", code=2)
        self.assertEqual(done.stdout, "")
        self.assertIn('so --sigma-pre="12kPa" would change nothing', done.stderr)

    def test_files_that_cannot_be_read(self):
        self.write("points.csv", GOOD)
        os.chmod(self.path("points.csv"), 0)
        drop = []
        if os.geteuid() == 0:  # root may read everything
            if shutil.which("setpriv") is None:
                self.skipTest("root may read everything, and setpriv is missing, which takes that right away")
            drop = ["setpriv", "--bounding-set=-dac_override,-dac_read_search"]
        for verb in ("locus", "run", "contact", "check"):
            done = subprocess.run([*drop, clod.BINARY, verb, "points.csv"], text=True,
                                  cwd=self.folder, capture_output=True, timeout=60)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr, f"clod {verb}: points.csv: cannot be opened: "
                             "Permission denied; you have no right to read it, ls -l shows "
                             "whose it is and what is allowed\n")
            done = clod.run(verb, ".", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr, f"clod {verb}: .: cannot be read: Is a directory; "
                             "name a file in it\n")

    def test_wall_friction_and_density_tables(self):
        """By hand: tau_w = 0.6 sigma_w + 0.5 kPa, off by 0.1 and 0.3 kPa; 1000 kg/m3 (s/kPa)^log10(1.1)."""
        wall = "sigma_w [kPa],tau_w [kPa]\n1,1\n2,2\n3,2\n4,3\n"
        told = self.locus("-", input=wall).stdout
        for text in ("phi_w        30.96 ±     5.96  deg", "tau_ad       0.500 ±    0.387  kPa",
                     "     4.000     3.000 ±      -     36.87"):
            self.assertIn(text, told)
        found = json.loads(self.locus("-", "--json", input=wall).stdout)
        self.assertAlmostEqual(found["phi_w_deg"]["value"], 30.9637565, places=6)
        again = self.locus("-", "--csv", input=wall).stdout
        self.assertEqual(self.locus("-", input=again).stdout, told)
        rho = "sigma_1 [kPa],rho_b [g/cm3]\n1,1\n10,1.1\n100,1.21\n"
        self.assertIn("rho_1       1000.0", self.locus("-", input=rho).stdout)
        self.assertAlmostEqual(json.loads(self.locus("-", "--json", input=rho).stdout)
                               ["compressibility"]["value"], 0.0413926852, places=9)
        self.assertIn("clod locus: The points do not follow the law",
                      self.locus("-", "--csv", input="sigma_1 [kPa],rho_b [kg/m3]\n2,1000\n4,100\n8,1400\n").stderr)
        again = self.locus("-", "--csv", input=rho).stdout
        self.assertEqual(self.locus("-", input=again).stdout, self.locus("-", input=rho).stdout)

    def test_angles_of_repose(self):
        """30, 32 and 34 deg: a standard deviation of 2 deg, of the mean 2/sqrt(3)."""
        heaps = "heap,angle_of_repose [deg]\n1,30\n2,34\n3,32\n"
        told = self.locus("-", input=heaps).stdout
        self.assertIn("Angle of repose: 3 heaps", told)
        self.assertIn("     32.00 ±     1.15      2.00  deg", told)
        found = json.loads(self.locus("-", "--json", input=heaps).stdout)
        self.assertAlmostEqual(found["angle_of_repose_deg"]["error"], 2 / 3 ** 0.5, places=9)
        self.assertEqual([heap["angle_of_repose_error_deg"] for heap in found["heaps"]], [None] * 3)
        again = self.locus("-", "--csv", input=heaps).stdout
        self.assertEqual(self.locus("-", input=again).stdout, told)
        self.assertIn("clod locus: angle_of_repose is 30.00 deg with a stated standard error of 40.00 deg",
                      self.locus("-", "--csv", input="angle_of_repose [deg],angle_of_repose_error [deg]\n30,40\n").stderr)
        self.assertIn("a table of angles of repose has no preshear; leave out --tau-pre",
                      self.locus("-", "--tau-pre", "1kPa", input=heaps, code=2).stderr)

    def test_wall_friction_tables_that_are_wrong(self):
        for text, said in (("sigma_w [kPa],tau_w [deg]\n1,1\n", "deg"),
                           ("sigma_w [kPa],phi [deg]\n1,1\n", "phi"),
                           ("sigma_w [Pa],tau_w [kPa]\n1,1\n", "a wall friction angle of 89.9 deg"),
                           ("sigma_w [kPa],tau_w [kPa]\n1,1\n", "at least two points")):
            self.assertIn(said, self.locus("-", input=text, code=2).stderr)
        wall = "sigma_w [kPa],tau_w [kPa]\n1,1\n2,2\n"
        self.assertIn("standard input: a wall yield locus has no preshear; leave out --sigma-pre",
                      self.locus("-", "--sigma-pre", "1 kPa", input=wall, code=2).stderr)
        for text, said in (("sigma_w [kPa],tau_w [kPa]\n1,1\n", "standard input: A wall yield locus needs"),
                           ("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n10,8,3,4\n",
                            "standard input: Preshear at 10.000 kPa"),
                           ("sigma_1 [kPa],rho_b [kg/m3]\n1,1000\n", "standard input: Bulk density over stress"),
                           ("sigma_w [kPa],tau_w [kPa],sigma_1 [kPa],rho_b [kg/m3]\n1,1,1,1000\n",
                            "standard input: two tables are mixed"),
                           ("sigma_1 [kPa],f_c [kPa],rho_b [kg/m3]\n1,1,1000\n", "clod hopper reads it"),
                           ("Sigma_w [kPa],Tau_w [kPa]\n1,1\n", "did you mean sigma_w?")):
            self.assertIn(said, self.locus("-", input=text, code=2).stderr)
        for form in ([], ["--json"], ["--csv"]):  # atan(-0.5)
            done = self.locus("-", *form, input="sigma_w [kPa],tau_w [kPa]\n1,1\n2,0.5\n", code=2)
            self.assertEqual(done.stdout, "")
            self.assertIn("clod locus: standard input: the wall yield locus falls: its line has phi_w = -26.6 deg.", done.stderr)
        simulated = "sigma_w [kPa],tau_w [kPa],wall_stress [kPa]\n1,1,1\n2,0.5,2\n"
        self.assertIn("clod locus: The shear stress falls", self.locus("-", "--csv", input=simulated).stderr)

    def test_densities_over_the_preshear_stress(self):
        """As laboratories print them: said with what to do, not taken for shear points without their columns."""
        for head in ("sigma_pre [kPa],rho_b [kg/m3]", "rho [kg/m3],sigma_p [kPa]", "seed,sigma_pre [kPa],rho_b [kg/m3],rho_b_error [kg/m3]"):
            said = self.locus("-", input=head + "\n" + ",".join("1" * len(head.split(","))) + "\n", code=2).stderr
            self.assertIn("standard input: is a table of bulk densities over the preshear stress (sigma_pre, rho_b). A table of bulk "
                          "densities needs sigma_1, the major principal stress of consolidation, in place of sigma_pre", said)
            self.assertIn("which clod locus prints for its shear points", said)
        self.assertIn("has no column sigma_sh", self.locus("-", input="sigma_pre [kPa],tau_sh [kPa],rho_b [kg/m3]\n1,1,1\n", code=2).stderr)


class New(clod.Case):

    def test_template_on_standard_output(self):
        for name in ("ring-shear", "free-run", "contact-bench"):
            told = clod.run("new", name, "-", cwd=self.folder)
            self.assertEqual((told.returncode, told.stderr), (0, ""))
            self.assertEqual(os.listdir(self.folder), [])
            self.assertEqual(clod.run("new", name, "x.yaml", cwd=self.folder).returncode, 0)
            self.assertEqual(clod.read(self.path("x.yaml")).decode(), told.stdout)
            os.remove(self.path("x.yaml"))
        with open("/dev/full", "w") as full:
            done = clod.run("new", "jenike", "-", cwd=self.folder, stdout=full)
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output: cannot be written", done.stderr)

    def test_a_folder_that_is_not_there(self):
        done = clod.run("new", "ring-shear", "sub/x.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, "clod new: sub/x.yaml: there is no folder sub; make it first: mkdir -p sub\n")
        self.assertEqual(os.listdir(self.folder), [])


class Marks(clod.Case):

    def test_case_with_a_byte_order_mark(self):
        """Editors of another system put one before the first key; lines and columns stay."""
        case = clod.read(clod.source("cases/contact-bench/case.yaml"))
        with open(self.path("case.yaml"), "wb") as file:
            file.write(b"\xEF\xBB\xBF" + case)
        self.assertEqual(clod.run("contact", "case.yaml", cwd=self.folder).stdout,
                         clod.run("contact", clod.source("cases/contact-bench/case.yaml")).stdout)
        with open(self.path("case.yaml"), "wb") as file:
            file.write(b"\xEF\xBB\xBFwrong: 1\n" + case)
        said = clod.run("contact", "case.yaml", cwd=self.folder).stderr
        self.assertIn("case.yaml:1:1: wrong: this key is not known", said)


if __name__ == "__main__":
    clod.main()
