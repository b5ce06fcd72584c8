"""grains.N.inlet: grains that come during the run: rate, amount, residence, blocking, same bits."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

GRAVITY = 9.81
DENSITY = 2500.0
# A stream of grains that falls out of the domain, 0.3 m below the middle of where it comes in.
CASE = """\
materials: {{ore: {{density: 2500 kg/m3}}}}
contacts:
  default: {{law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {{step: 1e-4 s, design_stress: 100 Pa}}
domain: {{min: [-0.1 m, -0.1 m, -0.3 m], max: [0.1 m, 0.1 m, 0.1 m], open: delete}}
grains:
{groups}
{walls}
stages: [{{name: run, duration: {duration} s}}]
output: {{series_interval: 50 ms, energy: true, steady_since: 0 s}}
"""
GROUP = """\
  - material: ore
    radius: {{distribution: uniform, min: 4.5 mm, max: 5.5 mm}}
    inlet: {{{inlet}}}{amount}
    region: {{box: {{min: [{low} m, -80 mm, -20 mm], max: [{high} m, 80 mm, 20 mm]}}}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
"""
WALL = """\
walls:
  box:
    material: ore
    shapes:
      - box: {center: [0 m, 0 m, -40 mm], size: [0.2 m, 0.2 m, 20 mm]}
      - box: {center: [-90 mm, 0 m, 0 m], size: [10 mm, 0.2 m, 120 mm]}
      - box: {center: [90 mm, 0 m, 0 m], size: [10 mm, 0.2 m, 120 mm]}
      - box: {center: [0 m, -90 mm, 0 m], size: [0.2 m, 10 mm, 120 mm]}
      - box: {center: [0 m, 90 mm, 0 m], size: [0.2 m, 10 mm, 120 mm]}
"""
FILLED = 0.5  # s: a grain is out of the region after 0.1 s, and out of the domain after 0.25 s
SIDES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")


def group(inlet, amount="", low=-0.08, high=0.08):
    return GROUP.format(inlet=inlet, amount=amount, low=low, high=high)


class Inlets(clod.Case):

    def write(self, *groups, walls="", duration=1.5):
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(groups="".join(groups), walls=walls, duration=duration))

    def warnings(self, flow, velocity, gravity="-9.81 m/s2", streams=1):
        """Those of `clod check` about inlets at rest, of so many streams in one region."""
        self.write(streams * group(f"mass_flow: {flow} kg/s").replace("    velocity: [0 m/s, 0 m/s, -1 m/s]\n", velocity), duration=FILLED)
        text = clod.read(self.path("case.yaml")).decode().replace("0 m/s2, -9.81 m/s2", f"0 m/s2, {gravity}")
        with open(self.path("case.yaml"), "w") as file:
            file.write(text)
        done = clod.run("check", "--json", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [one for one in json.loads(done.stdout)["warnings"] if "velocity: is zero" in one]

    def test_grains_that_come_at_rest(self):
        """They fall out of the region, 40 mm high; at its bottom grains of all heights pass, and fill
        flow/density sqrt(2 h/g) over its 160 x 160 x 40 mm of it: a quarter at 7.09 kg/s."""
        most = 0.25 * DENSITY * 0.16 * 0.16 * 0.04 / math.sqrt(2 * 0.04 / GRAVITY)
        still = "    velocity: [0 m/s, 0 m/s, 0 m/s]\n"
        self.assertEqual(self.warnings(0.99 * most, still), [])
        said, = self.warnings(1.2 * most, still)
        self.assertIn("with all that come there they fill 0.3 of its bottom", said)
        self.assertIn(f"or at most {most:.4g} kg/s", said)
        said, = self.warnings(0.6 * most, still, streams=2)  # of a mix, each of which has room alone
        self.assertIn("grains.1.velocity: is zero", said)
        self.assertIn("they fill 0.3 of its bottom", said)
        # one at rest, and one that comes through the same region at next to no speed: refused together
        self.write(group(f"mass_flow: {0.6 * most} kg/s").replace("    velocity: [0 m/s, 0 m/s, -1 m/s]\n", still),
                   group(f"mass_flow: {0.6 * most} kg/s").replace("-1 m/s]", "-1e-6 m/s]"))
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("a solid fraction of 0.3 with the other in its region", done.stderr)
        self.assertEqual(self.warnings(0.999 * most, still), [])
        self.assertNotIn("blocked", self.go("most").stdout)  # there is room for that much
        # without gravity nothing ever leaves it; where a value stands, and a caret below
        said, = self.warnings(0.1, still, "0 m/s2")
        line, text, caret = said.split("\n")[:3]
        self.assertIn("case.yaml:12:5: grains.0.velocity: is zero, and there is no gravity", line)
        self.assertIn("velocity: [0 m/s, 0 m/s, 0 m/s]", text)
        self.assertEqual(caret.index("^"), text.index("velocity"))
        said, = self.warnings(0.1, "", "0 m/s2")  # zero when it is not given
        self.assertIn("Give a velocity that leads out of the region, or gravity", said)
        self.assertEqual(self.warnings(0.1, "    velocity: [0 m/s, 0 m/s, 1 m/s]\n", "0 m/s2"), [])

    def judged(self, flow, velocity):
        """What `clod check` says of an inlet with a velocity along z [m/s]."""
        self.write(group(f"mass_flow: {flow} kg/s").replace("0 m/s, 0 m/s, -1 m/s", f"0 m/s, 0 m/s, {velocity} m/s"), duration=FILLED)
        return clod.run("check", "--json", "case.yaml", cwd=self.folder)

    def test_slow_grains_are_judged_with_gravity(self):
        """Thrown down at 0.1 m/s they clear 40 mm in (sqrt(v^2 + 2 g h) - v)/g, not in h/v, which would allow a
        quarter of that flow; thrown up at 0.5 m/s in (v + sqrt(2 g h))/g, since they turn inside."""
        height, volume = 0.04, 0.16 * 0.16 * 0.04
        for v, time in ((-0.1, (math.sqrt(0.01 + 2 * GRAVITY * height) - 0.1) / GRAVITY),
                        (0.5, (0.5 + math.sqrt(2 * GRAVITY * height)) / GRAVITY)):
            most = 0.25 * DENSITY * volume / time
            done = self.judged(1.05 * most, v)
            self.assertEqual(done.returncode, 2)
            self.assertIn("at this velocity are a solid fraction of 0.26", done.stderr)
            self.assertIn(f"at most {most:.4g} kg/s", done.stderr)
            self.assertEqual("fall back into the region" in done.stderr, v > 0)
            self.assertEqual(self.judged(0.99 * most, v).returncode, 0)
            if v < 0:
                self.assertNotIn("blocked", self.go("most").stdout)  # there is room for that much

    def test_grains_that_fall_back_are_named(self):
        """v^2/(2 g) = 12.7 mm of 40 mm; sqrt(2 g h) = 0.8859 m/s does, and what does is not named."""
        warned = json.loads(self.judged(0.1, 0.5).stdout)["warnings"]
        said, = [one for one in warned if "fall back" in one]
        line, text, caret = said.split("\n")[:3]
        self.assertIn("case.yaml:12:5: grains.0.velocity: grains rise by 12.7 mm and fall back into the region, 40 mm "
                      "high; from 0.8859 m/s on in this direction they leave it before they turn. Or let it lead down", line)
        self.assertIn("velocity: [0 m/s, 0 m/s, 0.5 m/s]", text)
        self.assertEqual(caret.index("^"), text.index("velocity"))
        for v in (0.89, -0.5):
            self.assertNotIn("fall back", self.judged(0.1, v).stdout)

    @clod.quick_only
    def test_rate_amount_and_residence(self):
        """1 kg/s to half a grain; all that came is inside or left; time of fall by its formula."""
        self.write(group("mass_flow: 3.6 t/h, start: 0.1 s"))
        self.go("out")
        rows = self.rows("out")
        largest = DENSITY * 4 / 3 * math.pi * 5.5e-3**3
        for row in rows:
            due = max(0.0, row["time"] - 0.1) * 1.0
            # an insertion has been at most 1 ms before
            self.assertLess(row["inlet_1.mass"], due + 0.5 * largest + 1e-12)
            self.assertGreater(row["inlet_1.mass"], due - 0.5 * largest - 1e-3 - 1e-12)
            left = sum(row[f"left_{side}.grains"] for side in SIDES)
            self.assertEqual(row["grains"] + left, row["inlet_1.grains"])
        at = {round(row["time"], 3): row["inlet_1.mass"] for row in rows}
        self.assertLess(abs(at[1.4] - at[0.4] - 1.0), 1e-3)  # over a second
        # grains come at random heights, whole in a region of 40 mm, and leave when their centre
        # is 0.3 m below the origin
        mean, steps = 0.0, 1000
        for k in range(steps):
            fall = 0.3 + (k + 0.5) / steps * 0.03 - 0.015
            mean += (math.sqrt(1.0 + 2.0 * GRAVITY * fall) - 1.0) / GRAVITY / steps
        residence = self.summary("out")["residence"]
        self.assertEqual(residence["grains"], rows[-1]["left_z_min.grains"])
        # half of an insertion's way, and the scatter of 900 grains, 4 ms each
        self.assertLess(abs(residence["mean_s"] - mean), 1e-3)
        self.assertLess(residence["p10_s"], residence["p50_s"])
        self.assertLess(residence["p50_s"], residence["p90_s"])
        self.assertEqual(sum(c["grains"] for c in residence["classes"]), residence["grains"])
        for row in clod.table(self.path("out/energy.csv")):
            self.assertLess(abs(row["residual_of_flow"]), 1e-3)

    def test_two_inlets_with_amounts_fill_and_empty(self):
        """By number and by mass, until there is enough; empty, full, empty, full, empty."""
        self.write(group("number_flow: 200 1/s, end: 0.2 s", low=-0.08, high=0.0),
                   group("mass_flow: 1 kg/s, start: 0.6 s", "\n    mass: 0.1 kg", 0.0, 0.08),
                   duration=1.0)
        done = self.go("out")
        rows = self.rows("out")
        at = {round(row["time"], 3): row for row in rows}
        self.assertEqual(at[0.2]["inlet_1.grains"], 40)
        self.assertEqual(rows[-1]["inlet_1.grains"], 40)
        self.assertEqual(at[0.55]["grains"], 0)
        self.assertGreater(at[0.65]["grains"], 0)
        self.assertEqual(rows[-1]["grains"], 0)
        largest = DENSITY * 4 / 3 * math.pi * 5.5e-3**3
        self.assertLess(abs(rows[-1]["inlet_2.mass"] - 0.1), 0.5 * largest)
        self.assertIn("inlet 2", done.stdout)

    def test_a_blocked_inlet_waits_and_says_so(self):
        self.write(group("mass_flow: 4 kg/s"), walls=WALL, duration=0.5)
        done = self.go("out")
        self.assertIn("WARNING", done.stdout)
        self.assertIn("was blocked at ", done.stdout)
        inlet = self.summary("out")["inlets"][0]
        self.assertGreater(inlet["blocked_insertions"], 10)
        self.assertGreater(inlet["blocked_since_s"], 0.05)
        last = self.rows("out")[-1]
        # what is due at the last insertion, at most 1 ms before
        self.assertLess(abs(last["inlet_1.mass"] + last["inlet_1.backlog"] - 4.0 * 0.5), 4.1e-3)

    def write_lid(self, step="1e-4 s"):
        """A solid lid where grains are to come, which is lifted after 0.1 s."""
        self.write(group("number_flow: 100 1/s"), walls="""\
walls: {lid: {material: ore, shapes: [{box: {center: [0 m, 0 m, 0 m], size: [0.158 m, 0.158 m, 38 mm]}}]}}
""")
        with open(self.path("case.yaml")) as file:
            text = file.read()
        stages = ("stages: [{name: shut, duration: 0.1 s}, {name: open, duration: 0.15 s, "
                  "walls: {lid: {velocity: [0 m/s, 0 m/s, 1 m/s]}}}]\n")
        lines = [stages if line.startswith("stages:") else line.replace("1e-4 s", step)
                 for line in text.splitlines(True)]
        with open(self.path("case.yaml"), "w") as file:
            file.writelines(lines)

    def blocked(self, folder):
        """Events of blocked inlets in the log, without the time on the clock."""
        return [{key: event[key] for key in event if key != "time"}
                for event in clod.log(self.path(folder)) if event["event"].startswith("inlet")]

    def test_a_blocked_inlet_is_said_when_it_begins_and_ends(self):
        """The first grain is due after 5 ms; it is said 10 ms later, when a second one waits. The
        lid, 1 mm above the bottom, leaves room for a grain when it is lifted by 8 to 10 mm."""
        self.write_lid()
        done = self.go("out")
        begins, ends = self.blocked("out")
        self.assertEqual(begins["event"], "inlet blocked begins")
        self.assertEqual(ends["event"], "inlet blocked ends")
        for event in (begins, ends):
            self.assertEqual(event["inlet"], 1)
            self.assertAlmostEqual(event["time_s"], event["step"] * 1e-4, 9)
        self.assertLess(abs(begins["since_s"] - 0.005), 1.01e-3)
        self.assertLess(abs(begins["time_s"] - 0.015), 2.01e-3)
        self.assertLess(abs(begins["backlog_grains"] - 1.5), 0.21)
        self.assertEqual(ends["backlog_grains"], 0.0)
        self.assertGreater(ends["time_s"], 0.107)
        self.assertLess(ends["time_s"], 0.125)
        self.assertEqual(done.stderr.count("inlet 1 is blocked since 0.00"), 1)
        self.assertEqual(done.stderr.count("inlet 1 is not blocked any more"), 1)
        self.assertNotIn("blocked_since_s", self.summary("out")["inlets"][0])

    @clod.quick_only
    def test_a_blocked_inlet_is_logged_once_when_a_run_is_killed(self):
        self.write_lid("1e-6 s")
        self.go("out")
        whole = self.blocked("out")
        self.assertEqual(len(whole), 2)
        process = clod.start("run", self.path("case.yaml"), "-o", self.path("cut"), "-t", "1")
        clod.wait_until(lambda: os.path.exists(self.path("cut/log.jsonl")) and
                        len(self.blocked("cut")) > 0, process)
        process.kill()
        process.communicate()
        self.go("cut")
        self.assertTrue(any(event["event"] == "resume" for event in clod.log(self.path("cut"))))
        self.assertEqual(self.blocked("cut"), whole)

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        self.write(group("mass_flow: 1 kg/s", low=-0.08, high=0.0),
                   group("number_flow: 300 1/s", low=-0.02, high=0.08), walls=WALL,
                   duration=0.3)
        self.go("one")
        self.go("two", "2")
        self.stop_after(2, "cut")
        self.go("cut")
        whole = clod.read(self.path("one/series.csv"))
        self.assertEqual(whole, clod.read(self.path("two/series.csv")))
        self.assertEqual(whole, clod.read(self.path("cut/series.csv")))
        self.assertEqual(clod.read(self.path("one/snap_000000.hdf")),
                         clod.read(self.path("cut/snap_000000.hdf")))

    def test_a_run_goes_on_from_another(self):
        """Flow and books begin with the run; grains of before keep their age."""
        self.write(group("mass_flow: 1 kg/s"), duration=0.2)
        self.go("first")
        self.go("second", "1", "--from", "first")
        rows = self.rows("second")
        largest = DENSITY * 4 / 3 * math.pi * 5.5e-3**3
        self.assertLess(abs(rows[-1]["inlet_1.mass"] - 0.2), 0.5 * largest + 1.1e-3)
        before = self.rows("first")[-1]["grains"]
        left = sum(rows[-1][f"left_{side}.grains"] for side in SIDES)
        self.assertEqual(rows[-1]["grains"] + left, before + rows[-1]["inlet_1.grains"])
        # the first that leave came 0.16 s before, most of it in the other run
        residence = self.summary("second")["residence"]
        self.assertGreater(residence["p10_s"], 0.12)
        self.assertLess(residence["p90_s"], 0.2)

    def test_outlets_remove_and_count(self):
        """What comes at the left goes through a box, at the right through a ring, rest below."""
        outlets = """outlets:
  left: {region: {box: {min: [-0.1 m, -0.1 m, -0.2 m], max: [0 m, 0.1 m, -0.17 m]}}}
  ring: {region: {annulus: {center: [0.045 m, 0 m, -0.2 m], inner_radius: 20 mm,
                            outer_radius: 60 mm, height: 30 mm}}}
"""
        self.write(group("number_flow: 300 1/s, end: 0.3 s", low=-0.08, high=-0.01),
                   group("number_flow: 300 1/s, end: 0.3 s", low=0.01, high=0.08),
                   walls=outlets, duration=0.6)
        done = self.go("out")
        last = self.rows("out")[-1]
        self.assertEqual(last["outlet_left.grains"], last["inlet_1.grains"])
        self.assertAlmostEqual(last["outlet_left.mass"], last["inlet_1.mass"], delta=1e-9)
        self.assertGreater(last["outlet_ring.grains"], 10)
        self.assertGreater(last["left_z_min.grains"], 5)  # through the hole of the ring
        self.assertEqual(last["outlet_ring.grains"] + last["left_z_min.grains"],
                         last["inlet_2.grains"])
        self.assertEqual(last["grains"], 0)
        # they fall at 1 m/s from 0 on the mean, and are seen within a ms below -0.17 m
        fall = 0.5 * 1.0 + GRAVITY * 0.17
        self.assertLess(abs(last["outlet_left.energy"] / last["outlet_left.mass"] - fall),
                        0.03 * fall)
        summary = self.summary("out")
        self.assertEqual(summary["outlets"]["left"]["grains"], last["outlet_left.grains"])
        self.assertEqual(summary["residence"]["grains"], 180)
        self.assertIn("outlet left", done.stdout)
        for row in clod.table(self.path("out/energy.csv")):
            self.assertLess(abs(row["residual_of_flow"]), 1e-3)
        if not clod.SANITIZED:
            self.go("two", "2")
            self.assertEqual(clod.read(self.path("out/series.csv")),
                             clod.read(self.path("two/series.csv")))

    def test_wrong_outlets_are_explained(self):
        thin = "outlets: {thin: {region: {box: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 5 mm]}}}}"
        self.write(group("number_flow: 300 1/s"), walls=thin)
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("thicker than that of the largest, 0.0055 m", done.stderr)
        many = "".join(f"  o{k}: {{region: {{box: {{min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 1 m]}}}}}}\n"
                       for k in range(9))
        self.write(group("number_flow: 300 1/s"), walls="outlets:\n" + many)
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("has 9 outlets; at most 8", done.stderr)

    def test_wrong_inlets_are_explained(self):
        for inlet, amount, words in (
                ("start: 1 s", "", "must have exactly one of mass_flow, number_flow"),
                ("mass_flow: 1 kg/s, start: 1 s, end: 0.5 s", "", "must be later than start"),
                ("mass_flow: 900 t/h", "", "solid fraction"),
                ("mass_flow: 1 kg/s", "\n    fill_height: 1 m", "remove this key"),
                ("mass_flow: 1 kg/s", "\n    mass: 1 kg\n    count: 3", "amount is given twice")):
            self.write(group(inlet, amount))
            done = clod.run("check", "case.yaml", cwd=self.folder)
            self.assertEqual(done.returncode, 2, inlet)
            self.assertIn(words, done.stderr)
        self.write(group("mass_flow: 1 kg/s"))
        done = clod.run("check", "case.yaml", "--set", "time={step: 1e-4 s}", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("design_stress", done.stderr)
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("grains come during the run", done.stdout)


if __name__ == "__main__":
    clod.main()
