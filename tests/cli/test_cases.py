"""cases/: every case is accepted, scripts write the meshes that are there, tables measure rightly."""

import argparse
import glob
import importlib.machinery
import importlib.util
import json
import math
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASES = clod.source("cases")
# What cases/rotating-drum/run writes beside its case, with two grains.
DRUM_GRAINS = ("id,material,radius [m],x [m],y [m],z [m]\n"
               "0,M1,0.001,0,0,-0.05\n1,M2,0.002,0.01,0,-0.05\n")
BENCH = "contact-bench"  # drives one contact: nothing to run
INCLUDED = "chute.yaml"  # keys of other cases, no case
NO_CASES = ("transfer-chute/chute.yaml", "lab-to-outlet/card.yaml", "lab-to-outlet/laboratory/truth.yaml")


def script(path):
    """A script of a case as a module."""
    loader = importlib.machinery.SourceFileLoader(path.replace("/", "_"), os.path.join(CASES, path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class Cases(clod.Case):
    @clod.quick_only
    def test_check_accepts_every_case(self):
        found = sorted(path for path in glob.glob(os.path.join(CASES, "**", "*.yaml"), recursive=True)
                       if os.path.relpath(path, CASES) not in NO_CASES)
        self.assertGreater(len(found), 15)
        for path in found:
            folder, name = os.path.split(os.path.relpath(path, CASES))
            with self.subTest(case=f"{folder}/{name}"):
                if folder == "rotating-drum":
                    shutil.copy(path, self.folder)
                    with open(self.path("grains.csv"), "w") as file:
                        file.write(DRUM_GRAINS)
                    path = self.path(name)
                verb = {"hopper.yaml": ["hopper", "--set", "interval.samples=100"], "plan.yaml": ["calibrate", "--check"],
                        "plan-8.yaml": ["calibrate", "--check"], "plan-friction.yaml": ["calibrate", "--check"], "plan-wall.yaml": ["calibrate", "--check"],
                        "plan-loci.yaml": ["calibrate", "--check"]}.get(
                    name, ["check", "-t", "1", "--json"])
                done = clod.run(*verb, path)
                self.assertEqual(done.returncode, 0, done.stderr)
                if "--json" in verb:
                    said = json.loads(done.stdout)
                    for text in said.get("warnings", []) + said.get("notes", []):
                        self.assertLess(len(text.encode()), 511, "cut short")  # CLOD_CHECK_WARNING_TEXT

    def test_geometry_is_what_the_scripts_write(self):
        scripts = glob.glob(os.path.join(CASES, "*", "geometry"))
        self.assertGreaterEqual(len(scripts), 6)
        for path in scripts:
            folder = os.path.dirname(path)
            with self.subTest(case=os.path.basename(folder)):
                made = self.path(os.path.basename(folder))
                os.mkdir(made)
                subprocess.run([sys.executable, path], cwd=made, check=True)
                kept = sorted(name for name in os.listdir(folder)
                              if name.endswith(".obj") or name == INCLUDED)
                self.assertEqual(sorted(os.listdir(made)), kept)
                for name in kept:
                    self.assertTrue(clod.read(os.path.join(made, name))
                                    == clod.read(os.path.join(folder, name)), name)

    def test_the_chute_is_laid_out_by_closed_forms(self):
        """Speeds along the stream by docs/theory/belts-and-chutes.md; the stream meets each plate."""
        geometry = script("transfer-chute/geometry")
        parser = argparse.ArgumentParser()
        geometry.add_arguments(parser)
        given = parser.parse_args(["--stream", "25", "--hood-to", "70"])
        chute = geometry.Chute(given)
        at = dict(chute.stations)
        mu, g = 0.4, 9.81
        # free flight, and a hit
        self.assertAlmostEqual(at["meets the hood"].speed, 1.8 * math.sqrt(2.0), places=9)
        self.assertAlmostEqual(at["on the hood"].speed, at["meets the hood"].speed
                               * (math.cos(math.radians(10)) - mu * math.sin(math.radians(10))), places=9)
        fall = at["leaves the hood"].z - at["meets the spoon"].z
        self.assertAlmostEqual(at["meets the spoon"].speed**2,
                               at["leaves the hood"].speed**2 + 2.0 * g * fall, places=9)

        def hood(radius, p):
            return 2.0 * g * radius / (1 + 4 * mu**2) * (3 * mu * math.sin(p) + (2 * mu**2 - 1) * math.cos(p))

        radius = 0.4 - at["on the hood"].thickness / 2
        start, end = math.radians(55), math.radians(70)
        k = (at["on the hood"].speed**2 - hood(radius, start)) * math.exp(2 * mu * start)
        self.assertAlmostEqual(at["leaves the hood"].speed,
                               math.sqrt(hood(radius, end) + k * math.exp(-2 * mu * end)), places=4)

        def spoon(radius, t):
            return 2.0 * g * radius / (1 + 4 * mu**2) * ((1 - 2 * mu**2) * math.sin(t) + 3 * mu * math.cos(t))

        radius = 0.4 - at["on the spoon"].thickness / 2
        start, end = math.pi / 2 - at["on the spoon"].angle, math.radians(60)
        k = (at["on the spoon"].speed**2 - spoon(radius, start)) * math.exp(2 * mu * start)
        self.assertAlmostEqual(at["leaves the spoon"].speed,
                               math.sqrt(spoon(radius, end) + k * math.exp(-2 * mu * end)), places=4)
        # the middle of the stream meets the arc of the spoon where that has turned by the angle of the hit
        points = chute.plate
        nearest = min(math.dist(point, (at["meets the spoon"].x, at["meets the spoon"].z))
                      for point in points)
        self.assertLess(nearest, 0.5 * 0.4 * math.radians(3.0) + 1e-6)
        self.assertAlmostEqual(points[-1][1], 0.25, places=6)

    def geometry(self, words):
        return subprocess.run([sys.executable, os.path.join(CASES, "transfer-chute/geometry"), *words],
                              cwd=self.folder, capture_output=True, text=True)

    def test_a_chute_that_cannot_be_is_refused(self):
        for words, text in ((["--hood-to", "50"], "--hood-to: 50 degrees"),
                            # acos(cos 10 deg - 6 mm / sqrt 2 / 400 mm) - 10 deg = 3.04 deg, by hand
                            (["--hood-to", "56"], "the lower side meets it 3.04 degrees behind"),
                            (["--stream", "400"], "a stream of 283 mm is too thick for the hood"),
                            (["--lip", "700"], "no room below the hood"),
                            (["--friction", "3"], "too slow to follow the hood"),
                            (["--spoon-behind", "300"], "the stream has 14.5 where it meets the spoon"),
                            (["--spoon-to", "80"], "--spoon-to: 80 degrees; the stream has 69.6"),
                            (["--lip", "90"], "--receiving: 100 mm must be below"),
                            (["--output", "nowhere"], "there is no folder nowhere"),
                            (["--width", "0"], "--width: 0 is out of range; allowed are 10 to 10000"),
                            (["--speed", "nan"], "--speed: nan is out of range"),
                            (["--width", "100"], "narrower than the stream; at least --stream-width, 120 mm"),
                            (["--lip", "5000"], "--lip: 5000 mm; the hood ends at 810 mm"),
                            # 220/0.3 = 733 strips, 600 + 400 rows and 12 + 14 or so of arcs: 1.5 million
                            (["--facet", "0.3"], "--facet: 0.3 mm makes 1.51e+06 facets of the chute; at most 200000"),
                            (["--facet", "0.01"], "at least some 0.89 mm"),
                            (["--side-facet", "0.5"], "--side-facet: 0.5 mm makes"),
                            # the hood ends at x = 404 mm, z = 810 mm, so it is a circle about x = 4 mm: at x = 377 mm the lower side
                            # of its stream is at 810 + (395.4^2 - 373^2)^(1/2) = 941 mm, and the upright part begins at 596 mm
                            (["--spoon-up", "5000"], "--spoon-up: 5000 mm; at most 345 mm"),
                            # the middle of the stream on the pulley: (9.81 m/s2 (400 + 3) mm)^(1/2)
                            (["--pulley-radius", "400", "--sides-from", "500"], "--speed: 1.8 m/s; at least 1.99 m/s"),
                            (["--pulley-radius", "165"], "the chute begins at 165 mm and would stand in the pulley"),
                            # 330 mm at the hood less 400 mm cos 55 deg
                            (["--hood-lead", "400"], "the chute begins at 102 mm"),
                            (["--top", "1200", "--receiving", "240", "--pulley-radius", "480", "--sides-from", "500", "--speed", "2.2",
                              "--hood-meets", "50", "--hood-radius", "300", "--spoon-radius", "200", "--hood-lead", "100"],
                             "less than 480 mm, half of what lies between --top and --receiving"),
                            (["--feed-length", "600", "--pulley-radius", "220", "--sides-from", "225"],
                             "--feed-length: 600 mm; at least three times --pulley-radius, 660 mm"),
                            (["--feed-skirts", "119"], "--feed-skirts: 119 mm; at least --stream-width, 120 mm"),
                            (["--feed-skirts", "251"], "at most --feed-width, 250 mm"),
                            (["--receiving-skirts", "220"], "--receiving-skirts: 220 mm; more than --width, 220 mm"),
                            (["--receiving-skirts", "401"], "at most --receiving-width, 400 mm"),
                            (["--receiving-from", "779"], "the stream meets the receiving belt at 778 mm: less than that"),
                            (["--receiving-length", "1177"], "its skirts end at 777 mm: at least 1178 mm"),
                            (["--receiving-speed", "0"], "--receiving-speed: 0 is out of range; allowed are 0.1 to 20")):
            done = self.geometry(words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(text, done.stderr)
            self.assertEqual(os.listdir(self.folder), [])

    def complete(self, words, case):
        """The complete case of a layout in SI units, from a run that does not begin to pour; what stands in `walls`, and before."""
        self.assertEqual(self.geometry(words).returncode, 0)
        shutil.copy(os.path.join(CASES, "transfer-chute", case), self.folder)
        done = clod.run("run", case, "-f", "-o", "out", "-t", "1", "--set", "stages.0.duration=10 us",
                        "--set", "output.steady_since=0 s", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return clod.read(self.path("out/case-complete.yaml")).decode().split("\nwalls:\n")

    def test_belts_of_the_chute_are_those_of_its_keys(self):
        """Every number of belts, inlet, outlets, domain and gauges that hangs on a key, in SI units; all by hand from the keys."""
        words = {"speed": 2.5, "top": 1500, "pulley-radius": 120, "feed-length": 2000, "feed-width": 300, "feed-skirts": 200,
                 "stream-width": 160, "flow": 9, "receiving": 200, "receiving-speed": 3, "receiving-from": 300,
                 "receiving-length": 2500, "receiving-width": 500, "receiving-skirts": 280}
        seen, walls = self.complete([word for key, value in words.items() for word in (f"--{key}", str(value))], "dry.yaml")
        feed, receiving = walls[:walls.index("\n  chute:")].split("\n  receiving:")
        for text, lines in (
                (feed, ("from: [-2 m, 0 m, 1.5 m]", "- length: 2 m", "width: 0.3 m", "speed: 2.5 m/s", "radius: 0.12 m",
                        "return: 0.24 m", "to: 1.8 m", "distance: 0.2 m")),
                (receiving, ("from: [0.3 m, 0 m, 0.2 m]", "- length: 2.5 m", "width: 0.5 m", "speed: 3 m/s", "to: 1.9 m",
                             "distance: 0.28 m")),
                (seen, ("mass_flow: 2.5 kg/s", "min: [-1.9 m, -0.08 m, 1.56 m]", "max: [-1.6 m, 0.08 m, 1.64 m]",  # inlet
                        "min: [-2.2 m, -0.3 m, -0.1 m]", "max: [2.75 m, 0.3 m, 1.9 m]",  # domain
                        "min: [2.65 m, -0.3 m, 0.15 m]", "max: [2.75 m, 0.3 m, 0.6 m]",  # delivered
                        # carried back: from 1/8 to 5/8 of the 1260 - 200 mm between both belts
                        "min: [-2.2 m, -0.3 m, 0.3325 m]", "max: [-0.04 m, 0.3 m, 0.8625 m]",
                        # the pulley's stream: up to 90 mm before it meets the hood, v^2 tan(45 deg) / g = 637 mm
                        "min: [0 m, -0.175 m, 1.05 m]", "max: [0.547 m, 0.175 m, 1.7 m]",
                        "min: [0.3 m, -0.25 m, 0.15 m]", "max: [2.65 m, 0.25 m, 0.5 m]",  # all of the receiving belt
                        "min: [2.4 m, -0.25 m, 0.15 m]", "max: [2.42 m, 0.25 m, 0.5 m]"))):  # load
            for line in lines:
                self.assertRegex(text, r"\n *" + re.escape(line) + r"\n")

    def test_what_is_carried_back_falls_into_its_outlet(self):
        """A faster belt throws farther what it carries to the end of its way back; domain and outlet reach so far."""
        self.assertEqual(self.geometry(["--speed", "2.5", "--top", "1500", "--receiving", "200"]).returncode, 0)
        # by hand: from x = 150 mm (sin 200 deg + 2 cos 200 deg) = -333.2 mm, z = 1311.6 mm, with 2.5 m/s up at 20 deg, down to z = 325 mm:
        # (0.8551 + (0.8551^2 + 2 x 9.81 x 0.9866)^(1/2)) / 9.81 = 0.5441 s at 2.3492 m/s, and 50 mm more
        text = clod.read(self.path("chute.yaml")).decode()
        self.assertIn("domain: {min: [-1661 mm, -250 mm, -100 mm]", text)
        self.assertIn("carried_back: {spillage: true, region: {box: {min: [-1661 mm, -250 mm, 325 mm], max: [-50 mm, 250 mm, 825 mm]}}}", text)

    def test_the_chute_as_it_is_laid_out_is_that_of_the_results(self):
        """Belts, inlet and domain as they were written by hand for docs/results/transfer-chute.md, in both cases."""
        for case in ("case.yaml", "dry.yaml"):
            seen, walls = self.complete([], case)
            self.assertRegex(walls, r"(?s)^  feed:.*\n  receiving:.*\n  chute:")  # the order of walls decides bits
            self.assertEqual(re.findall(r"\n {10}(?:from|speed|width): (.*)", walls),
                             ["[-1 m, 0 m, 1.2 m]", "0.25 m", "1.8 m/s", "[0.2 m, 0 m, 0.1 m]", "0.4 m", "1.8 m/s"])
            for line in ("min: [-1.2 m, -0.25 m, -0.2 m]", "max: [1.95 m, 0.25 m, 1.6 m]", "mass_flow: 0.8333333333333334 kg/s",
                         "min: [-0.9 m, -0.06 m, 1.26 m]", "max: [-0.6 m, 0.06 m, 1.34 m]", "min: [1.85 m, -0.25 m, 0.05 m]",
                         "max: [-0.05 m, 0.25 m, 0.6 m]", "max: [0.24 m, 0.15 m, 1.4 m]", "min: [1.6 m, -0.2 m, 0.05 m]"):
                self.assertIn(line, seen)

    def test_numbers_of_the_chute_stand_in_one_file(self):
        """A case that has a number of its own beside that of the layout is refused, and both places are told."""
        self.assertEqual(self.geometry([]).returncode, 0)
        with open(os.path.join(CASES, "transfer-chute", "dry.yaml")) as file:
            text = file.read().replace("  - material: ore\n", "  - material: ore\n    inlet: {mass_flow: 40 t/h}\n")
        with open(self.path("own.yaml"), "w") as file:
            file.write(text)
        done = clod.run("check", "own.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"mass_flow: is given in \S*chute.yaml too, in line \d+; keep one of them")

    def test_facets_of_the_chute_are_counted(self):
        """The number that is printed is that of the file, and a finer --facet makes more of them."""
        for words in ([], ["--facet", "5"], ["--facet", "30", "--side-facet", "40"], ["--spoon-up", "235"]):
            done = self.geometry(words)
            self.assertEqual(done.returncode, 0, done.stderr)
            facets = clod.read(self.path("chute.obj")).count(b"\nf ")
            self.assertTrue(done.stdout.endswith(f"chute.obj has {facets} facets\n"), done.stdout)

    def test_the_chute_is_a_template(self):
        """clod new writes the case, the dry one, all that they include, and the script that lays it out, as they are in cases/."""
        self.assertEqual(clod.run("new", "transfer-chute", cwd=self.folder).returncode, 0)
        names = {"transfer-chute.yaml": "case.yaml", "dry.yaml": "dry.yaml", "chute.yaml": "chute.yaml",
                 "chute.obj": "chute.obj", "geometry": "geometry", "chute.py": "chute.py", "mesh.py": "mesh.py",
                 "belts.py": "belts.py"}
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(names))
        for name, kept in names.items():
            self.assertTrue(clod.read(self.path(name)) == clod.read(os.path.join(CASES, "transfer-chute", kept)), name)
            self.assertEqual(os.access(self.path(name), os.X_OK), name == "geometry", name)
        # the script needs only what lies beside it, and writes nothing but the layout
        os.mkdir(self.path("made"))
        user = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        subprocess.run([sys.executable, self.path("geometry"), "--output", "made"], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL, env=user)
        self.assertEqual(sorted(os.listdir(self.folder)), sorted([*names, "made"]))
        self.assertEqual(sorted(os.listdir(self.path("made"))), ["chute.obj", "chute.yaml"])
        for name in os.listdir(self.path("made")):
            self.assertTrue(clod.read(self.path("made/" + name)) == clod.read(os.path.join(CASES, "transfer-chute", name)), name)
        told = clod.run("new").stdout
        help_text = clod.run("new", "--help").stdout
        for line in told.splitlines():
            self.assertIn(line, help_text)

    def test_sides_of_the_chute_in_facets(self):
        """The same area, in facets no longer than the diagonal of 50 mm squares."""
        meshes = []
        for words in ([], ["--side-facet", "50"]):
            self.assertEqual(self.geometry(words).returncode, 0)
            told = clod.run("mesh", "chute.obj", "--unit", "mm", "--json", cwd=self.folder).stdout
            meshes.append(json.loads(told))
        whole, cut = meshes
        self.assertAlmostEqual(whole["area_m2"], cut["area_m2"], delta=1e-6)
        self.assertGreater(cut["facets"], whole["facets"] + 500)
        self.assertLess(cut["edge_length_m"]["longest"], 0.0708)

    def test_a_chute_that_may_fail_is_warned_of(self):
        """A hood as long as one that missed in a simulation, a stream that is not that of the flow."""
        for words, text in ((["--hood-to", "75"], ""), (["--hood-to", "90"], ""), (["--stream", "25", "--flow", "40"], ""),
                            (["--hood-to", "60"], "1.6 times as long as it takes"),
                            (["--hood-to", "66"], "3.6 times as long as it takes"),
                            # (1.8^2 - 1^2) m2/s2 / (2 x 0.6 x 9.81 m/s2) = 190 mm; 591 mm with the 400 mm of the inlet
                            (["--feed-length", "590"], "from the inlet to the pulley are 190 mm: at least 591 mm"),
                            (["--feed-length", "591"], ""),
                            # as much as a quarter of a grain thick: one layer of grains, about which 6 mm are right
                            (["--flow", "1"], ""),
                            (["--speed", "2.5", "--top", "1500", "--receiving", "200"], ""),
                            (["--stream", "2"], "thinner than a grain, 6.35 mm"),
                            # 3 t/h / (1.8 m/s x 120 mm x 1500 kg/m3) = 2.6 mm
                            (["--stream", "25"], "are 2.6 mm thick")):
            done = self.geometry(words)
            self.assertEqual(done.returncode, 0)
            self.assertIn(text, done.stderr)
            self.assertEqual(done.stderr == "", text == "")

    def test_screw_feeder_begins(self):
        """50 ms: mass by the inlet's flow to half a grain, angle by the speed of the screw."""
        done = clod.run("run", os.path.join(CASES, "screw-feeder/case.yaml"), "-o",
                        self.path("out"), "-t", "1", "--set", "stages.0.duration=50 ms")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("out/summary.json")) as file:
            summary = json.load(file)
        time = summary["time_s"]
        heaviest = 2481.3 * 4.0 / 3.0 * math.pi * 3.49e-3**3
        came = summary["inlets"][0]
        self.assertAlmostEqual(came["mass_kg"], 6000.0 / 3600.0 * time,
                               delta=heaviest + 6000.0 / 3600.0 * 1e-3)  # put in every millisecond
        self.assertEqual(came["grains"], summary["grains"])  # none has left
        angle = {wall["name"]: wall["angle_rad"] for wall in summary["walls"]}
        self.assertAlmostEqual(angle["screw"], -1.5 * 2.0 * math.pi * time, delta=1e-9)
        self.assertEqual(angle["trough"], 0.0)
        self.assertLess(summary["max_overlap"], 0.05)

    def test_spread_of_a_pile(self):
        """Of grains along a line nine tenths lie within nine tenths of it."""
        spread = script("pile/table").spread([(1e-3 * k, 0.0, 0.0) for k in range(100)])
        self.assertAlmostEqual(spread, 0.09, places=9)

    def test_closed_form_of_the_conveyor(self):
        """Where the parabola of the flight meets the tray; a block as fast for endless friction."""
        conveyor = script("vibrating-plate/table")
        omega, rise = 2.0 * math.pi * 10.0, 5.739e-3 * math.sin(math.radians(60.0))
        start = math.asin(9.81 / (rise * omega**2)) / omega
        land = start + conveyor.flight()
        fallen = (rise * math.sin(omega * start) + rise * omega * math.cos(omega * start)
                  * (land - start) - 0.5 * 9.81 * (land - start)**2)
        self.assertAlmostEqual(fallen, rise * math.sin(omega * land), delta=1e-8)
        self.assertGreater(land, start + 0.05)
        speed = 10.0 * 0.5 * 9.81 * conveyor.flight()**2 / math.tan(math.radians(60.0))
        self.assertAlmostEqual(conveyor.block(1e4), speed, delta=0.01 * speed)

    def test_closed_forms_of_flow(self):
        """By hand: Johanson's rates and Roberts' efficiency for numbers without units of ours."""
        hopper = script("hopper-cone/table")
        # 1000 kg/m3, 50 mm, no empty ring: 1.9635 kg/m * sqrt(0.05 * 9.81 / (4 * 0.363970))
        self.assertAlmostEqual(hopper.johanson(1000.0, False, 0.0), 1.9635 * 0.580432, places=3)
        # slot of 38 mm by 50 mm: 1.9 kg/m * sqrt(0.038 * 9.81 / (2 * 0.363970))
        self.assertAlmostEqual(hopper.johanson(1000.0, True, 0.0), 1.9 * 0.715613, places=3)
        screw = script("screw-feeder/table")
        # radius 21.12 mm, flight 16.77 deg, wall 16.70 deg: tan(56.53) = 1.5127, tan(16.77) = 0.3014
        self.assertAlmostEqual(screw.roberts(), 1.5127 / (1.5127 + 0.3014), places=3)


if __name__ == "__main__":
    clod.main()
