"""What cases/copper-ore-study/run makes of tests: settings by name, angles and chances worked out by hand."""

import importlib.machinery
import importlib.util
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "support"))
sys.path.insert(0, os.path.join(HERE, "..", "..", "cases", "copper-ore-study"))
import clod as program  # noqa: E402  runs the command line
import closing  # noqa: E402
import doubtful  # noqa: E402
import loci  # noqa: E402
import records  # noqa: E402
import settings  # noqa: E402

TOOL = program.source("cases/copper-ore-study/run")
LOADER = importlib.machinery.SourceFileLoader("study", TOOL)
study = importlib.util.module_from_spec(importlib.util.spec_from_loader("study", LOADER))
LOADER.exec_module(study)
STRESSES = (10.96e3, 21.92e3, 32.88e3, 43.84e3)  # Pa
NORMAL = 54.8e3
TAU = 35e3
NOISE = 500.0  # Pa: by so much the highest row of a point lies above its smoothed peak


def write_test(folder, name, degrees):
    """A test whose points lie on 8 kPa + sigma tan(degrees), and the highest rows 500 Pa above."""
    path = os.path.join(folder, name)
    os.makedirs(path)
    slope, seed = math.tan(math.radians(degrees)), name[-1] if name[-1].isdigit() else 1
    with open(os.path.join(path, "points.csv"), "w") as file:
        file.write("seed,sigma_pre [Pa],tau_pre [Pa],sigma_sh [Pa],tau_sh [Pa],rho_b [kg/m3]\n")
        for stress in STRESSES:
            file.write(f"{seed},{NORMAL},{TAU},{stress},{8e3 + stress * slope},1200\n")
    for number, stress in enumerate(STRESSES, 1):
        tau = 8e3 + stress * slope
        write_series(path, f"point-{number}", 6, [(0.0, 0.0), (1e-3, tau), (2e-3, tau + NOISE), (3e-3, tau - NOISE)])
    write_series(path, "preshear", 3, [(1e-3 * mm, TAU * mm / 15) for mm in range(16)])
    with open(os.path.join(path, "summary.json"), "w") as file:
        json.dump({"version": "9.9", "parts": [{"part": "preshear", "normal_stress_Pa": NORMAL, "steady": True, "wall_clock_s": 60}]}, file)


def write_series(path, part, phase, rows):
    with open(os.path.join(path, part + ".csv"), "w") as file:
        file.write("phase [1],displacement [m],shear_stress [Pa]\n")
        file.writelines(f"{phase},{way},{stress}\n" for way, stress in rows)


class Settings(unittest.TestCase):

    def test_the_matrix_is_that_of_the_issue(self):
        """{paper, force, adhesive} x {5 %, 8 %} x {epsd2, none} and k_t read literally (at twice the speed), six packings each."""
        wanted = set()
        for ore in ("ore5", "ore8"):
            for choice in ("force", "adhesive", "no-rolling-resistance", "force-no-rolling-resistance",
                           "adhesive-no-rolling-resistance", "tangential-literal-speed-x-2"):
                wanted |= {f"{ore}-{choice}"} | {f"{ore}-{choice}-seed{seed}" for seed in range(2, 7)}
            wanted |= {f"{ore}-seed{seed}" for seed in range(1, 7)}
        self.assertEqual(len(wanted), 2 * 7 * 6)
        self.assertEqual(sorted(settings.SETS["matrix"]), sorted(wanted))
        self.assertLessEqual(wanted | set(settings.SETS["ways"]), settings.TESTS.keys())

    def test_a_name_changes_the_keys_that_it_tells(self):
        case, changes = settings.TESTS["ore8-adhesive-no-rolling-resistance-seed3"]
        self.assertEqual(case, "cases/copper-ore-8/case.yaml")
        self.assertEqual(sorted(changes), ["contacts.default.coulomb=adhesive",
                                           "contacts.default.rolling_friction=0", "seed=3"])
        softer = dict(key.split("=") for key in settings.TESTS["ore8-stiffness-10"][1])  # Table 1 over ten
        self.assertEqual({key[17:]: float(value.split()[0]) for key, value in softer.items()},
                         {"k1": 4.75e7, "k2": 2.37e8, "k_adh": 5.93e7})

    def test_clod_accepts_them(self):
        for name in ("ore8-preshear-over-5-mm", "ore5-preshear-over-40-mm-seed2", "ore8-force-no-rolling-resistance",
                     "ore8-speed-3"):
            case, changes = settings.TESTS[name]
            command = ["check", program.source(case)]
            for change in changes:
                command += ["--set", change]
            done = program.run(*command)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_folder_without_tests(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([TOOL, "--folder", folder, "--packings"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn(f"no test of the study has ended in {folder}: run some first", done.stderr)

    def test_a_program_that_is_not_there(self):
        with tempfile.TemporaryDirectory() as folder:
            write_test(folder, "ore5-seed1", 30)
            done = subprocess.run([TOOL, "--folder", folder, "--clod", "no/clod", "--closing"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(done.stderr, "there is no program no/clod; build it with make, or name it with --clod\n")

    def test_sets_and_wrong_names(self):
        done = subprocess.run([TOOL, "--list", "ways"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(done.stdout.splitlines()), 4 * 2 * 6)
        self.assertIn("ore8-preshear-over-20-mm-seed6 cases/copper-ore-8/case.yaml --set "
                      "'ring_shear.preshear_min=19.22 mm' --set 'ring_shear.preshear_max=19.22 mm'", done.stdout)
        done = subprocess.run([TOOL, "ore6-seed1"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no test called ore6-seed1; sets are matrix, ways, beyond; tests of the 5 % ore ore5-seed1, ore5-force", done.stderr)


class Chance(unittest.TestCase):

    def test_share_of_a_range_near_a_target(self):
        self.assertAlmostEqual(closing.share_near(20, 60, 40), 4 / 40)
        self.assertAlmostEqual(closing.share_near(20, 60, 59), 3 / 40)  # cut at the end of the range
        self.assertAlmostEqual(closing.share_near(20, 60, 61), 1 / 40)
        self.assertEqual(closing.share_near(20, 40, 44.8), 0.0)
        self.assertEqual(closing.share_near(43, 43, 44.8), 1.0)  # one reading, whatever its range
        self.assertEqual(closing.share_near(42, 42, 44.8), 0.0)

    def test_one_of_several(self):
        self.assertEqual(closing.any_of(0.25, 1), 0.25)
        self.assertAlmostEqual(closing.any_of(0.1, 4), 1 - 0.6561)
        self.assertEqual(closing.any_of(0.0, 9), 0.0)

    def test_it_is_what_random_readings_do(self):
        """20 000 drawings of five readings, of which the nearest to 59 counts: 0.323, the share of drawings +- 0.0033."""
        draw, trials = random.Random(5), 20000
        near = sum(min(abs(draw.uniform(20, 60) - 59) for _ in range(5)) <= 2 for _ in range(trials))
        self.assertAlmostEqual(near / trials, closing.any_of(closing.share_near(20, 60, 59), 5), delta=4 * 0.0033)

    def test_a_mean_with_an_error(self):
        """Of tables of Student's t: two-sided 90, 95 and 99 % points; half of it is below the mean; of one degree of
        freedom half lies within one standard error."""
        for freedom, points in ((1, (6.314, 12.706, 63.657)), (2, (2.920, 4.303, 9.925)), (5, (2.015, 2.571, 4.032)),
                                (11, (1.796, 2.201, 3.106)), (30, (1.697, 2.042, 2.750))):
            for share, point in zip((0.90, 0.95, 0.99), points):
                self.assertAlmostEqual(closing.chance_near(44.6, 2.0 / point, freedom, 44.6), share, delta=1.5e-4)
        self.assertAlmostEqual(closing.chance_near(44.6, 2.0, 1, 44.6), 0.5, places=9)
        self.assertAlmostEqual(closing.chance_near(46.6, 0.02, 11, 44.6), 0.5, places=9)
        self.assertEqual(closing.chance_near(46.0, 0.0, 3, 44.6), 1.0)
        self.assertTrue(math.isnan(closing.chance_near(44.6, math.nan, 0, 44.6)))


class Tables(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.join(folder.name, "tests")
        self.kept = os.path.join(folder.name, "kept.csv")
        for name, degrees in (("ore5-seed1", 30.0), ("ore5-seed2", 34.0), ("ore8-force", 44.0)):
            write_test(self.folder, name, degrees)

    def show(self, table):
        done = subprocess.run([TOOL, "--clod", program.BINARY, "--folder", self.folder, "--kept", self.kept,
                               "--" + table],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_mean_largest_over_a_window(self):
        rows = [(0.0, 0.0), (1.0, 1.0), (2.0, 3.0), (3.0, 1.0)]  # a row is the mean since the row before
        self.assertEqual(loci.largest_mean(rows, 1.0), 3.0)
        self.assertEqual(loci.largest_mean(rows, 2.0), 2.0)
        self.assertIsNone(loci.largest_mean(rows, 3.5))

    def test_highest_points(self):
        """All of them lie 500 Pa above the line: the same angle."""
        self.assertAlmostEqual(loci.angle_of_highest(self.folder, "ore5-seed2"), 34.0, places=9)

    def test_tests_of_older_and_newer_programs_are_joined(self):
        """Programs from 2026-11-28 on write one column more, which narrow cells leave empty."""
        before = loci.of_tests(program.BINARY, self.folder, ["ore5-seed1", "ore5-seed2"])
        path = os.path.join(self.folder, "ore5-seed2", "points.csv")
        with open(path) as file:
            head, *rows = file.read().splitlines()
        with open(path, "w") as file:
            file.write(head + ",rho_inside [kg/m3]\n" + "".join(row + ",1380\n" for row in rows))
        after = loci.of_tests(program.BINARY, self.folder, ["ore5-seed1", "ore5-seed2"])
        self.assertEqual(after.pop("rho_inside_kg_m3")["value"], 1380)
        self.assertIsNone(before.pop("rho_inside_kg_m3")["value"])
        self.assertEqual(after["c_Pa"], before["c_Pa"])
        self.assertEqual(after["rho_b_kg_m3"], before["rho_b_kg_m3"])

    def test_packings(self):
        """Mean of 30 and 34 degrees 32, standard error of two 2; the paper's 44.6, the laboratory's 47.3."""
        rows = [[cell.strip() for cell in row.strip("|").split("|")] for row in self.show("packings").splitlines()]
        rows = [row for row in rows if row[0] == "5 %, 2 packings"]
        self.assertEqual(len(rows), 2)
        self.assertEqual(rows[0][1], "32.0 ± 2.0")
        self.assertEqual([rows[1][1], rows[1][4]], ["-12.6 ± 2.0", "-15.3 ± 2.0"])

    def test_closing(self):
        text = self.show("closing")
        self.assertIn("| the case | 5 % | phi_lin | 2 | 32.0 ± 2.0 | -12.6 | -15.3 | no | 0.016 |", text)  # (atan 7.3 - atan 5.3)/pi
        self.assertIn("| the case | 5 % | highest points | 2 | 32.0 ± 2.0 |", text)
        self.assertIn("| coulomb: force | 8 % | phi_lin | 1 | 44.0 | -0.8 | -2.7 | yes | - |", text)
        self.assertIn("with the same reading of the same setting: none of 0;", text)

    def test_doubtful_points(self):
        """Where the circle touches is told by hand in test_what_makes_a_test_doubtful_is_kept. At 43.84 kPa a line of 30 deg has 33.3 kPa,
        one of 34 deg 37.6 kPa, above tau_p of 35."""
        self.assertAlmostEqual(doubtful.touch_of(30.0, 8.0, 54.8, 35.0), 38.69, delta=0.02)
        self.assertAlmostEqual(doubtful.touch_of(34.0, 8.0, 54.8, 35.0), 31.40, delta=0.02)
        self.assertEqual(doubtful.touch_of(20.0, 8.0, 54.8, 35.0), 54.8)  # 27.9 kPa on the line: its parallel
        self.assertTrue(doubtful.is_far_below(20.0, 0.0, 54.8, 0.749 * 54.8 * 0.36397))
        self.assertFalse(doubtful.is_far_below(20.0, 0.0, 54.8, 0.751 * 54.8 * 0.36397))  # below it, 0.9 cos would be 0.846
        self.assertTrue(doubtful.is_far_below(45.0, 5.2, 54.8, 0.636 * 60.0))  # 0.9 cos 45 deg = 0.6364
        self.assertFalse(doubtful.is_far_below(45.0, 5.2, 54.8, 0.637 * 60.0))
        text = self.show("doubtful")
        self.assertIn("| the case | 5 % | 2 | 1 | 1 | 0 | +0.00 ± 0.00 |", text)

    def test_choices(self):
        """30 and 34 degrees scatter by sqrt(8) = 2.8; force, 40 degrees once, is 8.0 ± 2.8 sqrt(1 + 1/2) = 3.5 above."""
        write_test(self.folder, "ore5-force", 40.0)
        text = self.show("choices")
        self.assertIn("| the case | 2 | - | 32.0 ± 2.0 | - |", text)
        self.assertIn("| coulomb: force | 1 | the case | 40.0 ± 2.8 | +8.0 ± 3.5 |", text)  # sqrt(2.0^2 + 2.8^2) is the same
        self.assertIn("phi_lin |\n", text)
        self.assertIn("8 %: nothing to compare with: run ore8-seed1", text)

    def test_choices_have_their_own_scatter(self):
        """40, 41 and 42 degrees: 41 ± 1/sqrt(3); of the difference to 32 ± 2 sqrt(4 + 1/3) = 2.08, with (4 + 1/3)^2/(16/1 + (1/9)/2) = 1.170
        degrees of freedom. Pooled it were sqrt(10/3 (1/2 + 1/3)) = 1.67."""
        for name, degrees in (("ore5-force", 40.0), ("ore5-force-seed2", 41.0), ("ore5-force-seed3", 42.0)):
            write_test(self.folder, name, degrees)
        self.assertIn("| coulomb: force | 3 | the case | 41.0 ± 0.6 | +9.0 ± 2.1 |", self.show("choices"))
        self.assertAlmostEqual(study.freedom_of((2.0, 1), (3 ** -0.5, 2)), 1.1696, places=4)
        self.assertAlmostEqual(study.freedom_of((1.0, 5), (1.0, 5)), 10.0)
        for freedom, share in ((1, 0.2952), (5, 0.1019), (11, 0.0708)):  # 1 - (2/pi) atan 2; tables of Student's t
            self.assertAlmostEqual(study.beyond_two(freedom), share, places=4)

    def test_choices_at_twice_the_speed_have_its_tests_to_compare_with(self):
        """10 mm beyond the peak, 38 degrees twice, is 38 - 36 = +2 ± 2 from 36 ± 2 of the same speed, not +6 from the case's 32;
        and its phi_sf, of the same preshears, is no reading of its own."""
        for name, degrees in (("ore5-speed-x-2", 34.0), ("ore5-speed-x-2-seed2", 38.0), ("ore5-10-mm-beyond-the-peak", 38.0),
                              ("ore5-10-mm-beyond-the-peak-seed2", 38.0)):
            write_test(self.folder, name, degrees)
        self.assertIn("| 10 mm beyond the peak | 2 | speed x 2 | 38.0 ± 0.0 | +2.0 ± 2.0 |", self.show("choices"))
        found = closing.packings_of(program.BINARY, self.folder, {})
        _, _, ores = closing.chance(found, closing.COUNTED)
        self.assertEqual([reading for choice, reading in ores["ore5"][0] if choice == "speed x 2"], ["phi_lin", "phi_e", "phi_sf"])
        self.assertEqual([reading for choice, reading in ores["ore5"][0] if choice == "10 mm beyond the peak"], ["phi_lin", "phi_e"])

    def test_peaks_further_on(self):
        """Of four points, the last rises on by a tenth of 8 kPa + 43.84 kPa tan 30 degrees, and has no peak."""
        name = "ore5-10-mm-beyond-the-peak"
        for test in ("ore5-speed-x-2", name):
            write_test(self.folder, test, 30.0)
        path = os.path.join(self.folder, name, "points.csv")
        with open(path) as file:
            *rows, last = file.read().splitlines()
        values = last.split(",")
        values[4] = repr(1.1 * float(values[4]))
        with open(path, "w") as file:
            file.write("\n".join([*rows, ",".join(values)]) + "\n")
        path = os.path.join(self.folder, name, "summary.json")
        with open(path) as file:
            summary = json.load(file)
        summary["parts"].append({"part": "point-4", "flags": ["no peak"]})
        with open(path, "w") as file:
            json.dump(summary, file)
        text = self.show("beyond")
        self.assertIn("| 5 % | 1 | 1 of 4 | 1 | +10.0 % | 30.0", text)
        self.assertNotIn("8 %", text)

    def test_tests_of_other_machines_count(self):
        """Kept are 30, 34 and 44 degrees; on another machine seed 2 has 36 in place of 34, seed 3 has 42: mean 36."""
        self.assertIn("3 tests", self.show("keep"))
        with open(self.kept) as file:
            rows = file.read().splitlines()
        self.assertEqual(rows[0], "test,clod,phi_lin [deg],phi_e [deg],phi_sf [deg],highest points [deg],c [kPa],"
                         "tau_p [kPa],sigma_1 [kPa],sigma_c [kPa],ffc [1],rho_b [kg/m3],rising [kPa/mm],rising error [kPa/mm],far right [1],"
                         "no peak [1],rho_inside [kg/m3]")
        self.assertEqual([row.split(",")[0] for row in rows[1:]], ["ore5-seed1", "ore5-seed2", "ore8-force"])
        self.assertEqual(rows[2].split(",")[1:3] + rows[2].split(",")[5:8], ["9.9", "34", "34", "8", "35"])
        with open(os.path.join(os.path.dirname(self.kept), "points.csv")) as file:
            points = file.read().splitlines()
        self.assertEqual(points[0], "test,sigma_pre [Pa],tau_pre [Pa],tau_pre_error [Pa],sigma_sh [Pa],tau_sh [Pa],tau_sh_error [Pa],"
                         "rho_b [kg/m3],rho_inside [kg/m3]")
        self.assertEqual([row.split(",")[0] for row in points[1:]], ["ore5-seed1"] * 4 + ["ore5-seed2"] * 4 + ["ore8-force"] * 4)
        self.assertEqual(points[1].split(",")[1:5], ["54800.0", "35000.0", "", "10960.0"])
        self.folder = os.path.join(self.folder, "other")
        write_test(self.folder, "ore5-seed2", 36.0)
        write_test(self.folder, "ore5-seed3", 42.0)
        text = self.show("closing")
        self.assertIn("| the case | 5 % | phi_lin | 3 | 36.0 ± 3.5 |", text)  # sqrt((36 + 0 + 36)/2/3) = 3.46
        self.assertIn("| coulomb: force | 8 % | phi_lin | 1 | 44.0 |", text)
        self.show("keep")  # of the other machine: its points take the place of seed 2's, those of the others stay
        with open(os.path.join(os.path.dirname(self.kept), "points.csv")) as file:
            points = [row.split(",") for row in file.read().splitlines()[1:]]
        self.assertEqual([row[0] for row in points], ["ore5-seed1"] * 4 + ["ore5-seed2"] * 4 + ["ore5-seed3"] * 4 + ["ore8-force"] * 4)
        self.assertAlmostEqual(float(points[4][5]), 8e3 + STRESSES[0] * math.tan(math.radians(36)), delta=1e-6)

    def test_what_makes_a_test_doubtful_is_kept(self):
        """A stress that rose by 0.8 kPa/mm. The circle of steady flow through (54.8, 35) kPa touches 8 kPa + sigma tan 30 deg at 38.7
        kPa, so the point at 43.84 kPa is 0.09 of 54.8 kPa to the right of that; a line of 34 deg at 31.4 kPa: 0.23."""
        path = os.path.join(self.folder, "ore5-seed1", "summary.json")
        with open(path) as file:
            summary = json.load(file)
        summary["parts"][0] |= {"steady": False, "shear_stress_rate_Pa_per_m": 0.8e6, "shear_stress_rate_error_Pa_per_m": 0.1e6}
        summary["parts"].append({"part": "point-4", "flags": ["no peak"]})
        with open(path, "w") as file:
            json.dump(summary, file)
        self.show("keep")
        with open(self.kept) as file:
            rows = [row.split(",") for row in file.read().splitlines()]
        self.assertEqual(rows[1][12:16], ["0.8", "0.1", "0", "1"])
        self.assertEqual(rows[2][12:16], ["0", "", "1", "0"])  # steady

    def test_a_number_that_is_not_there_stays_so(self):
        """tau_p 35 kPa at 54.8 kPa and a line of c 60 kPa: sigma_2 is tension, so there is no phi_e."""
        with open(os.path.join(self.folder, "ore5-seed1", "points.csv")) as file:
            text = file.read()
        head, *rows = text.splitlines()
        with open(os.path.join(self.folder, "ore5-seed1", "points.csv"), "w") as file:
            file.write(head + "\n")
            for row in rows:
                values = row.split(",")
                values[4] = str(float(values[4]) + 52e3)
                file.write(",".join(values) + "\n")
        self.show("keep")
        with open(self.kept) as file:
            self.assertEqual(file.read().splitlines()[1].split(",")[3], "")
        self.assertIn("| the case | 5 % | phi_e | 1 of 2 | - | - | - | - | - |", self.show("closing"))

    def test_pages_have_the_tables_of_today(self):
        """Those of docs/results are what the kept tests give, line by line."""
        for table, name in (("closing", "copper-ore.md"), ("doubtful", "copper-ore.md"), ("choices", "copper-ore-sensitivity.md")):
            done = subprocess.run([TOOL, "--clod", program.BINARY, "--folder", os.path.join(self.folder, "none"), "--kept",
                                   program.source("cases/copper-ore-study/tests.csv"), "--" + table], capture_output=True, text=True)
            with open(program.source("docs/results/" + name)) as file:
                self.assertIn(done.stdout.strip(), file.read())

    def test_texts_have_the_chances_of_today(self):
        """Percentages in words of README and page, from the spans and numbers of readings."""
        rows = program.source("cases/copper-ore-study/tests.csv")
        found = closing.packings_of(program.BINARY, self.folder + "-none", records.read(rows))
        counts, shares = zip(*(zip(*((len(angles), f"{likely:.0%}".replace("%", " %")) for angles, _, likely in ores.values()))
                               for _, _, ores in (closing.chance(found, closing.COUNTED), closing.chance(found, closing.COUNTED[1:]))))
        with open(program.source("docs/results/copper-ore.md")) as file:
            text = " ".join(file.read().split())
        self.assertIn(f"by chance in {shares[0][0]} (5 %) and {shares[0][1]} (8 %) of cases, and in {shares[1][0]} and {shares[1][1]} where only",
                      text)
        self.assertIn(f"Of the {sum(counts[0])} readings ({counts[0][0]} and {counts[0][1]},", text)
        with open(program.source("README.md")) as file:
            self.assertIn(f"one of the {counts[0][1]} angles read with 8 % comes within 2° of the paper's by chance in {shares[0][1]} of "
                          f"cases, without phi_lin in {shares[1][1]};", file.read())

    def test_kept_numbers_belong_together(self):
        """sigma_c = 2 c cos(phi_lin)/(1 - sin(phi_lin)), phi_sf = atan(tau_p/sigma_p), to the digits kept; and loci of kept points."""
        rows = records.read(program.source("cases/copper-ore-study/tests.csv"))
        for name, row in rows.items():
            digits = 1e-4 if len(row["clod"]) > 20 else 0.01  # ore8-seed1 to 10 are from a table of three digits
            angle = math.radians(row["phi_lin"])
            strength = 2 * row["c"] * math.cos(angle) / (1 - math.sin(angle))
            self.assertAlmostEqual(row["sigma_c"] / strength, 1, delta=digits, msg=name)
            steady = math.degrees(math.atan(row["tau_p"] / doubtful.SIGMA_P[name[:4]]))
            self.assertAlmostEqual(row["phi_sf"] / steady, 1, delta=digits, msg=name)
        points = {}
        with open(program.source("cases/copper-ore-study/points.csv")) as file:
            head, *lines = file.read().splitlines()
        for line in lines:
            points.setdefault(line.split(",")[0], []).append(line.split(",", 1)[1])
        os.makedirs(os.path.join(self.folder, "of-points"))
        for name, some in points.items():
            locus = loci.evaluated(program.BINARY, os.path.join(self.folder, "of-points"), "\n".join([head.split(",", 1)[1], *some, ""]))
            self.assertAlmostEqual(locus["phi_lin_deg"]["value"], rows[name]["phi_lin"], delta=1e-3, msg=name)
            self.assertAlmostEqual(1e-3 * locus["c_Pa"]["value"], rows[name]["c"], delta=1e-3, msg=name)

    def test_phi_sf_on_the_way(self):
        """tau is 35 kPa/15 mm; rows at 3 and 4 mm come before 5 mm: atan(3.5 * 35/15/54.8) = 8.47 degrees."""
        self.assertIn("| 5 %, 2 packings | 8.5 ± 0.0 | 19.9 ± 0.0 |", self.show("ways"))


if __name__ == "__main__":
    unittest.main()
