"""Numbers of a free run as targets: names of the summary that a case has, and the units in which they are given."""

import json
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import bounce
import clod
from bounce import CASE, PLAN

TARGET = "number: kinetic_energy_J, value"
# Everything that a summary may have: two stages of 1 ms.
FULL = """repose: {heap: {region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 100 mm]}}, cell: 7 mm}}
clumps: {}
"""
# What measures tell in the shapes that they have: bins, alarms, a belt, a grid.
MEASURED = FULL + """fields:
  bed: {region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 20 mm]}}, cell: 10 mm, width: 20 mm, interval: 1 ms}
  zone: {region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 20 mm]}}, interval: 1 ms}
mixing: {pot: {region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 40 mm]}}, cell: 10 mm, above: 2 mm}}
outlets: {bin: {region: {box: {min: [0 mm, 0 mm, 150 mm], max: [60 mm, 60 mm, 180 mm]}}}}
gauges:
  fall:
    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 40 mm]}}
    direction: [0, 0, -2]
    across: [0, 1, 0]
    plane: {at: 20 mm}
    profile: {bins: 3}
    trajectory: {bins: 2}
    blocked: {mass_above: 1 g, speed_below: 1 mm/s, for: 0.05 s}
  ride:
    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 40 mm]}}
    direction: [1, 0, 0]
    belt: feed
"""
BELT = """  feed:
    material: ore
    shapes: [{belt: {from: [10 mm, 30 mm, 100 mm], heading: [1, 0, 0], runs: [{length: 30 mm}], width: 20 mm, speed: 1 m/s}}]
"""
# Two plates, of which one is an outlet; two shapes of one wall, of which the plane has no area.
SHEET = """\
o left
v -100 -100 -200
v 0 -100 -200
v 0 100 -200
v -100 100 -200
f 1 2 3
f 1 3 4
o right side
v 0 -100 -200
v 100 -100 -200
v 100 100 -200
v 0 100 -200
f 5 6 7
f 5 7 8
"""
# Every measure that has more than a list of numbers: cohesive grains come, clump, rest on a mesh and leave.
STREAM = """materials: {ore: {density: 2500 kg/m3, hardness: 1 GPa, archard: 1e-3, finnie: 1e-3}}
contacts: {default: {law: luding, k1: 1e4 N/m, k2: 5e4 N/m, k_adh: 2e4 N/m, plasticity_depth: 0.05, friction: 0.5}}
time: {step: 5e-5 s, design_stress: 100 Pa}
domain: {min: [-0.2 m, -0.2 m, -0.3 m], max: [0.2 m, 0.2 m, 0.1 m], open: delete}
grains:
  - material: ore
    radius: {distribution: uniform, min: 4 mm, max: 5 mm}
    inlet: {mass_flow: 0.5 kg/s, start: 5 ms, end: 0.2 s}
    region: {box: {min: [-80 mm, -80 mm, -20 mm], max: [80 mm, 80 mm, 20 mm]}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
  - material: ore
    radius: {distribution: uniform, min: 3.9 mm, max: 4 mm}
    inlet: {number_flow: 200 1/s, start: 5 ms, end: 0.2 s}
    region: {box: {min: [100 mm, -80 mm, -20 mm], max: [150 mm, 80 mm, 20 mm]}}
    velocity: [3 m/s, 0 m/s, -1 m/s]
  - material: ore
    count: 100
    radius: {distribution: uniform, min: 3.9 mm, max: 4 mm}
    region: {box: {min: [-100 mm, -50 mm, -180 mm], max: [100 mm, 50 mm, -100 mm]}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
walls:
  floor:
    material: ore
    shapes: [{plane: {point: [0 m, 0 m, -250 mm], normal: [0, 0, 1]}}, {box: {center: [0 m, 0 m, -0.245 m], size: [0.3 m, 0.3 m, 10 mm]}}]
  sheet: {material: ore, shapes: [{mesh: {file: sheet.obj, unit: 1 mm}}]}
outlets:
  way: {wall: sheet, part: left}
  gap: {region: {box: {min: [-50 mm, -50 mm, -30 mm], max: [-40 mm, 50 mm, -20 mm]}}, spillage: true}
build_up: {}
clumps: {counts: {low_kg: {region: {box: {min: [-100 mm, -100 mm, -200 mm], max: [100 mm, 100 mm, -150 mm]}}}}}
history_map: {cell: 100 mm}
stages: [{name: run, duration: 0.25 s}]
output: {series_interval: 10 ms, surfaces: true, steady_since: 0.05 s}
"""
# What a run has only if something happened in it, by the names before: not in this one.
SOME_RUNS = {"balance.out": {"left_x_min", "left_y_min", "left_y_max", "left_z_min", "left_z_max"},
             "inlets.0": {"blocked_since_s"}, "inlets.1": {"blocked_since_s"},
             "surfaces.0": {"impact_angle_deg"},
             "surfaces.0.impacts": {"angle_deg", "speed_m_per_s", "each_normal_energy_J"}}


def nodes(of, before=""):
    """Paths of all objects and lists with what they have; of a list its first and its last."""
    if isinstance(of, list):
        of = {str(k): of[k] for k in sorted({0, len(of) - 1}) if of}
    if isinstance(of, dict):
        yield before, of
        for key, value in of.items():
            yield from nodes(value, f"{before}.{key}" if before else key)


def leaves(of, before=""):
    """Paths of all that may be a number; null is one that the run did not define."""
    if isinstance(of, (dict, list)):
        for key, value in of.items() if isinstance(of, dict) else enumerate(of):
            yield from leaves(value, f"{before}.{key}" if before else str(key))
    elif not isinstance(of, (str, bool)):
        yield before


class Paths(bounce.Bounce):

    def plan_of(self, paths):
        """A plan with these numbers as targets beside the one that it has."""
        more = "".join(f"  - {{test: bounce, number: {path}, value: 7, error: 0.7, held_back: true}}\n" for path in paths)
        return PLAN.replace("error: 4e-6}\n", "error: 4e-6}\n" + more)

    def checked(self, paths):
        self.write("plan.yaml", self.plan_of(paths))
        return clod.run("calibrate", "plan.yaml", "--check", cwd=self.folder)

    def start_measured(self):
        with open(CASE) as file:
            case = file.read().replace("200 mm]}", "200 mm], open: delete}")
        self.write("bounce.yaml", case.replace("stages:\n", BELT + "stages:\n") + MEASURED + "output: {series_interval: 1 ms}\n")

    def test_all_numbers_of_a_run_are_paths(self):
        """A check that refused a number which a run has would be worse than none."""
        self.start_measured()
        self.assertEqual(clod.run("run", "bounce.yaml", "-o", "run", "-t", "1", cwd=self.folder).returncode, 0)
        with open(self.path("run/summary.json")) as file:
            summary = json.load(file)
        for name in ("left", "outlets", "walls", "belts", "gauges", "fields", "mixing", "repose", "clumps"):
            self.assertIn(name, summary)
        paths = [path for path in leaves(summary) if path != "kinetic_energy_J"]
        self.assertGreater(len(paths), 150)
        for first in range(0, len(paths), 100):
            done = self.checked(paths[first:first + 100])
            self.assertEqual(done.returncode, 0, done.stderr)

    def run_stream(self):
        """The summary of a run of STREAM, without its texts."""
        self.write("sheet.obj", SHEET)
        self.write("bounce.yaml", STREAM)
        done = clod.run("run", "bounce.yaml", "-o", "run", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("run/summary.json")) as file:
            summary = json.load(file)
        self.assertLessEqual({"inlets", "residence", "surfaces", "balance", "clumps", "build_up", "history_map"}, set(summary))
        return {name: value for name, value in summary.items() if not isinstance(value, str)}

    def test_all_numbers_of_a_stream_are_paths(self):
        paths = [path for path in leaves(self.run_stream()) if path != "kinetic_energy_J"]
        self.assertGreater(len(paths), 400)
        for some in ("residence.p50_s", "surfaces.1.area_m2", "surfaces.3.impacts.angle_deg.mean", "inlets.0.backlog_kg",
                     "inlets.1.backlog_grains", "build_up.sheet.right side.mean_kg", "clumps.counts.low_kg.mean.number",
                     "balance.out.left_x_max.grains", "clumps.left.sizes.0.grains", "history_map.strongest.corner_m.2"):
            self.assertIn(some, paths)
        for first in range(0, len(paths), 100):
            done = self.checked(paths[first:first + 100])
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_names_of_a_check_are_those_of_a_stream(self):
        """At every name of the summary a wrong one is refused, with those that the run has and no others."""
        summary = self.run_stream()
        for name in ("walls", "left", "outlets", "stages"):
            del summary[name]  # as above
        asked = [(path, of) for path, of in nodes(summary) if path != ""]
        self.assertGreater(len(asked), 60)
        seen = set()
        for first in range(0, len(asked), 50):
            some = asked[first:first + 50]
            done = self.checked([path + ".wrong" for path, _ in some])
            self.assertEqual(done.returncode, 2)
            lines = [line for line in done.stderr.splitlines() if ": test bounce has no number " in line]
            self.assertEqual(len(lines), len(some), done.stderr)
            for (path, of), line in zip(some, lines):
                words = line.split(f"has no number {path}.wrong; behind {path} it has ")
                self.assertEqual(len(words), 2, line)
                names = set(words[1].split(", "))
                if path == "build_up.sheet":
                    names -= {"left", "right side"}  # parts of its mesh: "sheet.left" beside it
                of = {name.split(".")[0] for name in of}
                if all(name.isdigit() for name in of):
                    continue  # of a list the message tells a range
                missing = SOME_RUNS.get(path, set())
                self.assertEqual(names - of, missing, line)
                self.assertEqual(of - names - {"name", "spillage"}, set(), line)
                seen |= {path} if missing else set()
        self.assertEqual(seen, set(SOME_RUNS))

    def test_every_name_that_ends_in_a_unit_takes_it(self):
        """A unit that none has is refused as a wrong one, but where the name has none: there as one too many."""
        ends = re.compile(r"_(deg|rad|J|W|N|Nm|Pa|kg|m|m2|m3|s|s2)$")
        every = {re.sub(r"\.\d+", ".0", path): path for path in leaves(self.run_stream()) if path != "kinetic_energy_J"}
        paths, lines = [path for path in every.values() if not path.startswith("clumps.counts.")], []
        for first in range(0, len(paths), 50):
            self.write("plan.yaml", self.plan_of(paths[first:first + 50]).replace("value: 7,", "value: 7 kg2,"))
            done = clod.run("calibrate", "plan.yaml", "--check", cwd=self.folder)
            lines += [line for line in done.stderr.splitlines() if ".value: 7 kg2" in line]
        self.assertEqual(len(lines), len(paths), lines)
        units = set()
        for path, line in zip(paths, lines):
            end = next((ends.search(name)[0] for name in reversed(path.split(".")) if ends.search(name)), "")
            self.assertEqual("takes a pure number" in line, end == "", (path, line))
            self.assertNotIn("is not a number", line)
            units.add(end)
        self.assertLessEqual({"", "_deg", "_J", "_W", "_N", "_Nm", "_Pa", "_kg", "_m", "_m2", "_s"}, units)

    def test_what_this_stream_will_not_have_is_refused(self):
        self.run_stream()
        for path, words in (
                ("surfaces.0.area_m2", "; behind surfaces.0 it has since_s,"),  # a plane
                ("surfaces.4.press_N", "; behind surfaces it has 0, 1 to 3"),
                ("surfaces.1.force_N.3", "; behind surfaces.1.force_N it has 0 to 2"),
                ("surfaces.3.impacts.by_angle.9.number", "; behind surfaces.3.impacts.by_angle it has 0 to 8"),
                ("inlets.2.grains", "; behind inlets it has 0, 1"),
                ("inlets.0.backlog_grains", "; behind inlets.0 it has group,"),
                ("inlets.1.backlog_kg", "; behind inlets.1 it has group,"),
                ("balance.out.way.grains", "; behind balance.out it has left_x_min,"),
                ("balance.out.removed.grains", "; behind balance.out it has left_x_min,"),
                ("balance.in.flow_kg_per_s.main", "did you mean mean?"),
                ("build_up.sheat.mass_kg", "did you mean sheet?; behind build_up it has floor, sheet"),
                ("build_up.sheet.right.mass_kg", "; behind build_up.sheet it has since_s,"),
                ("build_up.sheet.left.mas_kg", "did you mean mass_kg?; behind build_up.sheet.left it has since_s,"),
                ("clumps.counts.loose.largest", "; behind clumps.counts it has low_kg"),
                ("clumps.sinse_s", "did you mean since_s?"),
                ("clumps.sizes.20.number", "; behind clumps.sizes it has 0 to 19"),
                ("residence.classes.0.from", "did you mean from_s?"),
                ("history_map.strongest.corner_m", "; behind history_map.strongest.corner_m it has 0 to 2")):
            done = self.checked([path])
            self.assertEqual(done.returncode, 2, (path, done.stderr))
            self.assertIn(f"plan.yaml:10:28: targets.1.number: test bounce has no number {path}", done.stderr)
            self.assertIn(words, done.stderr)
            self.assertIn("\n" + " " * 29 + "^" + "~" * (len(path) - 1) + "\n", done.stderr + "\n")

    def test_a_negative_energy_is_refused(self):
        done = self.told("kinetic_energy_J", PLAN.replace("number: kinetic_energy_J, value: ", "number: kinetic_energy_J, value: -"))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("is impossible: kinetic_energy_J is never below 0", done.stderr)

    def test_a_mesh_that_is_not_there_is_told_by_a_check(self):
        self.write("bounce.yaml", STREAM)
        done = self.checked([])
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("plan.yaml:5:3: tests.bounce: ", done.stderr)
        self.assertIn("walls.sheet.shapes.0.mesh.file: ", done.stderr)

    def test_a_wrong_name_at_any_step_is_refused_with_its_place(self):
        self.start_measured()
        for path, words in (
                ("repose.heep.angle_deg", "did you mean heap?; behind repose it has heap"),
                ("repose.heap.angel_deg", "did you mean angle_deg?; behind repose.heap it has since_s, angle_deg, error_deg"),
                ("repose.heap", "has no number repose.heap; behind repose.heap it has since_s,"),
                ("repose.heap.angle_deg.mean", "; repose.heap.angle_deg is a number"),
                ("time_s.0", "; time_s is a number"),
                ("stages.bounce.end_s", "; behind stages it has 0"),
                ("walls.0.force_N.z", "; behind walls.0.force_N it has 0 to 2"),
                ("walls.2.angle_rad", "; behind walls it has 0 to 1"),
                ("fields.zone.velocity_m_per_s.mean.3", "; behind fields.zone.velocity_m_per_s.mean it has 0 to 2"),
                ("gauges.fall.trajectory.at_m.2", "; behind gauges.fall.trajectory.at_m it has 0 to 1"),
                ("left.y_max.gains", "did you mean grains?; behind left.y_max it has grains, mass_kg, kinetic_energy_J"),
                ("outlets.bun.grains", "did you mean bin?"),
                ("belts.feed.power_W.main", "did you mean mean?; behind belts.feed.power_W it has mean, deviation"),
                ("mixing.pot.lazy", "did you mean lacey?"),
                ("gauges.fall.profile.at_m.first", "; behind gauges.fall.profile.at_m it has 0 to 2"),
                ("gauges.ride.profile.at_m.0", "; behind gauges.ride it has"),
                ("gauges.ride.landing.long_m_per_s", "did you mean along_m_per_s?"),
                ("fields.zone.density_kg_per_m3.main", "did you mean mean?"),
                ("fields.bed.used_cell", "did you mean used_cells?"),
                ("gauges.full.samples", "did you mean fall?; behind gauges it has fall, ride")):
            done = self.checked([path])
            self.assertEqual(done.returncode, 2, (path, done.stderr))
            self.assertIn(f"plan.yaml:10:28: targets.1.number: test bounce has no number {path}", done.stderr)
            self.assertIn(words, done.stderr)
            self.assertIn("\n" + " " * 29 + "^" + "~" * (len(path) - 1) + "\n", done.stderr + "\n")

    def told(self, number, text=None):
        """What --check says of a target of this number; exit status 0 is in order."""
        self.write("plan.yaml", (text or PLAN).replace("kinetic_energy_J", number))
        return clod.run("calibrate", "plan.yaml", "--check", cwd=self.folder)

    def names_told(self):
        done = self.told("repoze.heap.nothing")
        self.assertEqual(done.returncode, 2)
        self.assertIn("plan.yaml:9:", done.stderr)
        self.assertIn("targets.0.number: test bounce has no number repoze.heap.nothing", done.stderr)
        line = next(line for line in done.stderr.splitlines() if "begins its paths with " in line)
        return done.stderr, line.split("begins its paths with ")[1].split(", ")

    def names_of_run(self):
        """Names at the top of a run's summary, but the texts and what only a run from another has."""
        done = clod.run("run", "bounce.yaml", "-o", "run", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("run/summary.json")) as file:
            return [name for name, value in json.load(file).items() if not isinstance(value, str)]

    def test_names_are_those_of_a_run(self):
        text, names = self.names_told()
        self.assertNotIn("repose", names)
        self.assertNotIn("did you mean", text)
        self.assertEqual(sorted(names), sorted(self.names_of_run()))

    def test_names_are_those_of_a_run_with_measures(self):
        with open(CASE) as file:
            case = file.read()
        self.write("bounce.yaml", case.replace("200 mm]}", "200 mm], open: delete}") + FULL)
        text, names = self.names_told()
        self.assertIn("did you mean repose?", text)
        missing = set(names) ^ set(self.names_of_run())
        self.assertEqual(missing, {"residence"})  # no grain has left
        self.assertEqual(self.told("repose.heap.angle_deg, value: 30 deg, error: 2 deg}  #").returncode, 0)

    def test_a_case_without_a_heap_is_refused_before_a_run_is_paid(self):
        done = self.told("repose.heap.angle_deg")
        self.assertEqual(done.returncode, 2)
        self.assertIn("has no number repose.heap.angle_deg", done.stderr)

    def test_units_of_names(self):
        with open(CASE) as file:
            case = file.read()
        self.write("bounce.yaml", case + FULL)
        for target, word in (
                ("repose.heap.angle_deg, value: 30 deg, error: 2 deg", None),
                ("repose.heap.angle_deg, value: 0.5 rad, error: 2", None),
                ("repose.heap.angle_deg, value: 30, error: 2", None),
                ("repose.heap.angle_deg, value: 30 kPa, error: 2", "targets.0.value: 30 kPa"),
                ("repose.heap.height_m, value: 40 mm, error: 2 mm", None),
                ("repose.heap.height_m, value: 40 deg, error: 2 mm", "targets.0.value: 40 deg"),
                ("walls.0.force_N.2, value: 1 kN, error: 1 N", None),
                ("grains, value: 12 mm, error: 1", "targets.0.value: 12 mm"),
                ("kinetic_energy_J, value: 1 mJ, error: 1e-4 N m", None),
                ("kinetic_energy_J, value: 1 W, error: 1", "targets.0.value: 1 W is not an energy; use a unit such as mJ"),
                ("walls.0.torque_Nm.2, value: 1 N m, error: 1", None),
                ("walls.0.torque_Nm.2, value: 1 N, error: 1", "1 N is not a torque")):
            done = self.told(target + "}  #")
            self.assertEqual(done.returncode, 0 if word is None else 2, (target, done.stderr))
            self.assertIn(word or "", done.stderr)

    def test_values_are_shown_in_the_unit_of_the_name(self):
        """The stage lasts 9 ms to the last step, whatever the restitution: measured 9 ms, modelled 9 ms."""
        plan = PLAN.replace("error: 4e-6}", "error: 4e-6}\n  - {test: bounce, number: stages.0.end_s, value: 9 ms, "
                            "error: 1 ms, held_back: true}")
        self.calibrate(plan, "-o", "out")
        target = self.found()["targets"][1]
        self.assertEqual((target["unit"], target["measured"], target["error"]), ("s", 0.009, 0.001))
        self.assertAlmostEqual(target["model"], 0.009, delta=1e-4)
        for row in self.rows():
            self.assertAlmostEqual(float(row["bounce: stages.0.end_s [s]"]), 0.009, delta=1e-4)


if __name__ == "__main__":
    clod.unittest.main()
