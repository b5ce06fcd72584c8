"""clod check and clod run refuse what cannot run, with the same words."""

import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
ORE = clod.source("cases/copper-ore-8/case.yaml")


class Check(clod.Case):

    def refused(self, verb, case, change, *texts):
        done = clod.run(verb, case, "--set", change, cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for text in texts:
            self.assertIn(text, done.stderr)
        return done.stderr[done.stderr.index(texts[0]):]

    def test_step_beyond_the_critical_one(self):
        for case in (BOX, ORE):
            words = "time.step: 0.001 s is beyond the critical step"
            said = self.refused("check", case, "time.step=1 ms", words, "at most", "write auto")
            self.assertEqual(said, self.refused("run", case, "time.step=1 ms", words))

    def test_a_file_where_the_results_would_be(self):
        """That is for clod run to refuse: what a case costs can be told."""
        with open(self.path("run"), "w"):
            pass
        done = clod.run("check", BOX, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = clod.run("run", BOX, cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("run is there and is not a folder", done.stderr)

    def test_key_without_effect(self):
        words = ("--set output.series_interval=1 ms: output.series_interval: a tester "
                 "writes a row of its series whenever it looks at the walls; remove this key")
        for verb in ("check", "run"):
            self.refused(verb, ORE, "output.series_interval=1 ms", words)

    def test_one_is_not_many(self):
        one = ("grains.0.count=1", "stages=[{name: one, duration: 1e-9 s}]", "output={}")
        changes = [word for change in one for word in ("--set", change)]
        done = clod.run("run", BOX, "-o", self.path("out"), *changes)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(" 1 step, 1 grain, 0 contacts,", done.stdout)

    def box_with(self, rows):
        """The box with grains of a file, which need no seed."""
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [mm], y [mm], z [mm], radius [mm]\n" + rows)
        with open(BOX) as file, open(self.path("case.yaml"), "w") as case:
            case.write(file.read().replace("seed: 3\n", ""))
        return self.path("case.yaml"), "grains=[{material: ore, file: grains.csv}]"

    def test_coincident_grains(self):
        case, change = self.box_with(2 * "9, 9, 9, 2\n")
        said = []
        for verb in ("check", "run"):
            done = clod.run(verb, case, "--set", change, "-o", self.path("out"))
            self.assertEqual(done.returncode, 1, done.stderr)
            said.append(done.stderr.replace(f"clod {verb}: ", ""))
        self.assertIn("grain 1 overlaps grain 2 by 200.0 % of the radius of the smaller one", said[0])
        self.assertEqual(said[0], said[1])

    def test_grain_in_a_file_outside_the_domain(self):
        for place, allowed in (("-20, 9, 9", "x = -0.02 m, allowed 0 to 0.03 m"),
                               ("9, -11, 9", "y = -0.011 m, allowed -0.01 to 0.04 m")):
            case, change = self.box_with(f"{place}, 2\n")
            for verb in ("check", "run"):
                self.refused(verb, case, change, f"grain 1 is outside the domain: {allowed}")

    def test_streams_that_cannot_be_meant(self):
        """Too fast for the step; removed where they come in; walls and regions that no grain reaches."""
        base = ("grains=[{material: ore, radius: {distribution: uniform, min: 1 mm, max: 1 mm}, velocity: [SPEED, 0 m/s, 0 m/s], "
                "inlet: {mass_flow: 1 kg/s}, region: {box: {min: [0 mm, 0 mm, 0 mm], max: [20 mm, 20 mm, 20 mm]}}}]")
        with open(self.path("case.yaml"), "w") as file:
            file.write("""\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
domain: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.1 m], open: delete}
time: {step: 1e-5 s, design_stress: 100 Pa}
grains: []
walls:
  near: {material: ore, shapes: [{box: {center: [0 m, 0 m, -0.05 m], size: [50 mm, 50 mm, 10 mm]}}]}
  floor: {material: ore, shapes: [{plane: {point: [0 m, 0 m, -5 m], normal: [0, 0, 1]}}]}
  far: {material: ore, shapes: [{box: {center: [0 m, 0 m, -50 m], size: [50 mm, 50 mm, 10 mm]}}]}
  comes: {material: ore, velocity: [0 m/s, 0 m/s, 1 m/s], shapes: [{box: {center: [0 m, 0 m, -1 m], size: [50 mm, 50 mm, 10 mm]}}]}
outlets:
  below: {region: {box: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, -0.05 m]}}}
  there: {region: {box: {min: [-0.1 m, -0.1 m, 0.01 m], max: [0.1 m, 0.1 m, 0.05 m]}}}
  away: {region: {box: {min: [0.1001 m, -0.1 m, 0 m], max: [0.2 m, 0.1 m, 0.05 m]}}}
  rim: {region: {box: {min: [0.0999 m, -0.1 m, -0.1 m], max: [0.2 m, 0.1 m, -0.05 m]}}}
gauges: {lost: {region: {box: {min: [0 m, 0 m, 10 m], max: [0.1 m, 0.1 m, 11 m]}}}}
clumps: {counts: {gone: {region: {annulus: {center: [0 m, -1 m, 0 m], outer_radius: 0.5 m, height: 0.1 m}}}}}
history_map: {cell: 10 mm, region: {box: {min: [0 m, 0 m, -0.3 m], max: [0.1 m, 0.1 m, -0.2 m]}}}
stages: [{name: run, duration: 0.1 s}]
""")
        # 1 mm in a step of 1e-5 s are 100 m/s
        for speed, fast in (("99 m/s", False), ("101 m/s", True)):
            done = clod.run("check", "case.yaml", "--threads", "1", "--set", base.replace("SPEED", speed), cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            told = [line.split(None, 1)[1] for line in done.stdout.splitlines() if line.startswith("WARNING")]
            self.assertEqual([text[:33] for text in told if text.startswith("grains.0.velocity")],
                             ["grains.0.velocity: 101 m/s are 1."] * fast)
            self.assertIn("case.yaml:14:11: outlets.there.region: overlaps grains.0.region: grains are removed where they "
                          "come in. Move one of them\n    there: {region: ", done.stdout)
            self.assertEqual([text.split(" lies")[0] for text in told if "nothing of it" in text],
                             ["case.yaml:10:3: walls.far: nothing of it",
                              "case.yaml:15:10: outlets.away.region: nothing of it",
                              "case.yaml:17:17: gauges.lost.region: nothing of it",
                              "case.yaml:18:26: clumps.counts.gone.region: nothing of it",
                              "case.yaml:19:28: history_map.region: nothing of it"])
            self.assertIn("its y is -1.5 to -0.5 m, that of the domain -0.1 to 0.1 m", done.stdout)
            self.assertRegex(done.stdout, r"wall-clock +\S+ \w+ at this rate, at most \S+ \w+ in a dense fast stream\n")
            self.assertNotIn("ten times", done.stdout)
        done = clod.run("check", "--json", "case.yaml", "--threads", "1", "--set", base.replace("SPEED", "9 m/s"), cwd=self.folder)
        told = json.loads(done.stdout)
        self.assertAlmostEqual(told["wall_clock_most_s"], 10 * told["wall_clock_likely_s"], delta=1e-6 * told["wall_clock_most_s"])

    def test_a_belt_with_another_side_up(self):
        """Its z is up: gravity along -y needs a wall that is turned, one upside down is doubtful; 5 degrees or none are not."""
        with open(self.path("case.yaml"), "w") as file:
            file.write("""\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
domain: {min: [-1 m, -1 m, -1 m], max: [2 m, 1 m, 1 m]}
time: {step: 1e-5 s, design_stress: 100 Pa}
grains: [{material: ore, radius: {distribution: uniform, min: 5 mm, max: 5 mm}, count: 1, region: {box: {min: [0.1 m, 0 m, 0.1 m], max: [0.2 m, 0.1 m, 0.2 m]}}}]
walls:
  feed: {material: ore, shapes: [{belt: {from: [0 m, 0 m, 0 m], runs: [{length: 1 m}], width: 400 mm, speed: 1 m/s}}]}
stages: [{name: run, duration: 1e-4 s}]
""")
        turned = "walls.feed.rotate={axis: [1, 0, 0], angle: -90 deg, point: [0 m, 0 m, 0 m]}"
        for gravity, more, doubtful in (
                ("0 m/s2, 0 m/s2, -9.81 m/s2", (), False), ("0 m/s2, 0 m/s2, -9.81 m/s2", ("--set", turned), True),
                ("0 m/s2, 0 m/s2, -9.81 m/s2", ("--set", turned.replace("-90", "-59.9")), False),
                ("0 m/s2, 0 m/s2, -9.81 m/s2", ("--set", turned.replace("-90", "180")), True),
                ("0 m/s2, 0 m/s2, 0 m/s2", (), False), ("0 m/s2, -9.81 m/s2, 0 m/s2", (), True),
                ("0 m/s2, -9.81 m/s2, 0 m/s2", ("--set", turned), False), ("0 m/s2, 0 m/s2, 9.81 m/s2", (), True),
                ("0.855 m/s2, 0 m/s2, -9.773 m/s2", (), False)):
            change = ("--set", f"gravity=[{gravity}]", *more)
            done = clod.run("check", "case.yaml", "--threads", "1", *change, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            words = "case.yaml:8:3: walls.feed: its belt takes z as up, which leans by more than 60 deg from where gravity ["
            self.assertEqual(words in done.stdout, doubtful, f"{gravity} {more} {done.stdout}")
        done = clod.run("run", "case.yaml", "--threads", "1", "-o", "run", "--set",
                        "gravity=[0 m/s2, -9.81 m/s2, 0 m/s2]", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(words + "0, -9.81, 0] m/s2 comes: grains would not lie on it", done.stderr)

    def test_an_inlet_of_which_nothing_comes(self):
        """It opens when the run ends; or half of the smallest grain, 5.236 g of 10.472 g, is never due."""
        with open(self.path("case.yaml"), "w") as file:
            file.write("""\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
domain: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 1 m], open: delete}
time: {step: 1e-5 s, design_stress: 100 Pa}
grains:
  - material: ore
    radius: {distribution: uniform, min: 10 mm, max: 20 mm}
    region: {box: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 1 m]}}
    inlet: {mass_flow: 10.47 g/s, start: 2.5 s}
stages: [{name: run, duration: 1 s}, {name: on, duration: 2 s}]
""")
        self.refused("check", self.path("case.yaml"), "grains.0.inlet.start=3 s",
                     "grains.0.inlet.start: 3 s is not before the end of the run, 3 s")
        for change, told in (("grains.0.inlet.mass_flow=10.47 g/s", True), ("grains.0.inlet.mass_flow=10.48 g/s", False),
                             ("grains.0.inlet={number_flow: 10 1/s, end: 49 ms}", True),
                             ("grains.0.inlet={number_flow: 10 1/s, end: 51 ms}", False)):
            done = clod.run("check", "case.yaml", "--threads", "1", "--set", change, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("grains.0.inlet: nothing comes: until it ends, or the run does" in done.stdout, told, change)

    def test_ore_case_has_no_warning_of_its_inertia(self):
        done = clod.run("check", ORE, "--threads", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        warnings = [line for line in done.stdout.splitlines() if line.startswith("WARNING")]
        self.assertFalse([line for line in warnings if "inertial" in line])


if __name__ == "__main__":
    clod.main()
