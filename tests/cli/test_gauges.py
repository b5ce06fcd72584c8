"""Gauges, balance and belts of a free run: streams with known answers, alarm, same bytes."""

import html
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

G = 9.81
DENSITY = 2500.0
# A stream that falls from 0 m through a gauge between -0.1 m and -0.2 m, half of it into a bin.
FALL = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {step: 1e-4 s, design_stress: 100 Pa}
domain: {min: [-0.1 m, -0.1 m, -0.3 m], max: [0.1 m, 0.1 m, 0.1 m], open: delete}
grains:
  - material: ore
    radius: {distribution: uniform, min: 4.5 mm, max: 5.5 mm}
    inlet: {mass_flow: 1 kg/s}
    region: {box: {min: [-80 mm, -80 mm, -20 mm], max: [80 mm, 80 mm, 20 mm]}}
    velocity: [0 m/s, 0 m/s, -1 m/s]
outlets:
  left: {region: {box: {min: [-0.1 m, -0.1 m, -0.3 m], max: [0 m, 0.1 m, -0.25 m]}}}
  low: {spillage: true, region: {box: {min: [0 m, -0.1 m, -0.3 m], max: [50 mm, 0.1 m, -0.25 m]}}}
gauges:
  fall:
    region: {box: {min: [-0.1 m, -0.1 m, -0.2 m], max: [0.1 m, 0.1 m, -0.1 m]}}
    direction: [0, 0, -2]
    across: [0, 1, 0]
    profile: {bins: 10}
    trajectory: {bins: 4}
stages: [{name: run, duration: DURATION}]
output: {series_interval: 50 ms, steady_since: 0.4 s}
"""
# Ore that comes at 0.5 m/s onto a belt of 2 m/s and leaves with it. Grains hardly roll.
BELT = """\
materials: {ore: {density: 2500 kg/m3}}
contacts:
  default: {law: hooke, k1: 5e3 N/m, restitution: 0.2, friction: 0.5, rolling: epsd2,
            rolling_friction: 1}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {design_stress: 100 Pa}
domain: {min: [-0.1 m, -0.3 m, -0.1 m], max: [1.2 m, 0.3 m, 0.2 m], open: delete}
grains:
  - material: ore
    radius: {distribution: uniform, min: 4.9 mm, max: 5.1 mm}
    inlet: {mass_flow: 0.3 kg/s}
    region: {box: {min: [10 mm, -150 mm, 10 mm], max: [60 mm, 150 mm, 30 mm]}}
    velocity: [0.5 m/s, 0 m/s, -0.5 m/s]
walls:
  feed:
    material: ore
    shapes:
      - belt: {from: [0 m, 0 m, 0 m], runs: [{length: 1.1 m}], width: 400 mm, speed: 2 m/s}
outlets:
  head: {region: {box: {min: [0.9 m, -0.3 m, -0.1 m], max: [1.1 m, 0.3 m, 0.2 m]}}}
gauges:
  all:
    region: {box: {min: [0 m, -0.3 m, -0.1 m], max: [0.9 m, 0.3 m, 0.2 m]}}
    direction: [1, 0, 0]
    belt: feed
  end:
    region: {box: {min: [0.7 m, -0.3 m, -0.1 m], max: [0.9 m, 0.3 m, 0.2 m]}}
    direction: [1, 0, 0]
    profile: {bins: 12}
stages: [{name: run, duration: 2.5 s}]
output: {series_interval: 50 ms, steady_since: 1 s}
"""
# Two grains that fly through the gauge at 0.5 m/s: within it from 0.2 s to 0.6 s and from 1 s on.
ALARM = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 1e4 N/m}}
gravity: [0 m/s2, 0 m/s2, 0 m/s2]
time: {step: 1e-4 s, design_stress: 100 Pa}
domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}
grains: [{material: ore, file: grains.csv}]
gauges:
  slot:
    region: {annulus: {center: [0.2 m, 0 m, -0.1 m], outer_radius: 0.1 m, height: 0.2 m}}
    blocked: {mass_above: 1 g, speed_below: SPEED, for: 0.05 s}
stages: [{name: run, duration: 1.2 s}]
output: {series_interval: 100 ms}
"""


class Gauges(clod.Case):

    def write(self, text, name="case.yaml"):
        with open(self.path(name), "w") as file:
            file.write(text)

    def test_a_falling_stream(self):
        """Flow and hold-up of free fall, by its formulas; all grains are in the books."""
        self.write(FALL.replace("DURATION", "1.4 s"))
        done = self.go("out")
        gauge = self.summary("out")["gauges"]["fall"]
        # centres begin within 15 mm of 0, at 1 m/s; over that: speeds at -0.1 and -0.2 m, time
        steps, through, speed = 1000, 0.0, 0.0
        for k in range(steps):
            begin = (k + 0.5) / steps * 0.03 - 0.015
            first = math.sqrt(1.0 + 2.0 * G * (0.1 + begin))
            last = math.sqrt(1.0 + 2.0 * G * (0.2 + begin))
            through += (last - first) / G / steps
        speed = 0.1 / through
        self.assertLess(abs(gauge["mass_flow_kg_per_s"]["mean"] - 1.0), 0.01)
        self.assertLess(abs(gauge["mass_kg"]["mean"] - through), 0.01 * through)
        self.assertLess(abs(gauge["speed_m_per_s"]["mean"] - speed), 0.005 * speed)
        self.assertLess(abs(gauge["velocity_z_m_per_s"]["mean"] + speed), 0.005 * speed)
        self.assertLess(gauge["angle_deg"]["mean"], 0.1)
        # places across are uniform over 160 mm less a diameter
        self.assertLess(abs(gauge["width_m"]["mean"] - 0.15 / math.sqrt(12.0)), 2e-3)
        self.assertLess(abs(gauge["offset_m"]["mean"]), 5e-3)
        self.assertLess(abs(gauge["radius_ratio"]["mean"] - 1.0), 0.01)
        self.assertEqual(gauge["samples"], 1000)
        # the same on the way in the series; means there are over 50 ms
        rows = clod.table(self.path("out/series.csv"))
        late = [row["gauge_fall.mass_flow"] for row in rows if row["time"] > 0.42]
        self.assertLess(abs(sum(late) / len(late) - gauge["mass_flow_kg_per_s"]["mean"]), 1e-6)
        self.check_balance(done, rows)
        self.check_tables(gauge)
        self.assertNotIn("warnings", self.summary("out"))  # it is steady

    def warned(self, text):
        """Warnings of a run, which its report and its page have too."""
        self.write(text)
        done = self.go("out", "1", "--fresh")
        told = self.summary("out").get("warnings", [])
        self.assertEqual(clod.run("report", self.path("out")).returncode, 0)
        page = html.unescape(clod.read(self.path("out/report.html")).decode())
        for warning in told:
            self.assertIn("- " + warning, " ".join(done.stdout.split()))
            self.assertIn(f"<li>{warning}</li>", page)
        self.assertEqual("Warnings of the simulation" in done.stdout, bool(told))
        return told

    def test_means_from_the_beginning_are_not_steady(self):
        """The lowest grain begins 15.5 mm below 0: by its fall at 1 m/s it is in the gauge, 84.5 mm further down, after 62 ms,
        and 234.5 mm further down, where outlets begin, after 139 ms. Blocks are of 50 ms, in which 38 grains come."""
        gauge, balance = sorted(self.warned(FALL.replace("DURATION", "0.5 s").replace("0.4 s}", "0 s}")), reverse=True)
        self.assertIn("Gauge fall: the mass flow is 0 until 0.05 s, and its mean is taken from 0 s on:", gauge)
        self.assertRegex(balance, "^Balance: the flow out is 0 until 0.15? s, and its mean is taken from 0 s on:")
        for text in (gauge, balance):
            self.assertIn("Let the stages last longer, or give a later output.steady_since.", text)

    def test_a_filling_is_not_steady(self):
        """In the first 130 ms 1 kg/s comes in, in grains of 1.3 g, and nothing leaves. Of a domain without a way out nobody thinks it steady."""
        early = FALL.replace("DURATION", "0.13 s").replace("0.4 s}", "0 s}")
        told = [text for text in self.warned(early) if text.startswith("Balance")]
        self.assertEqual(len(told), 1)
        self.assertRegex(told[0], "^Balance: what is inside grows by (1|0.9[89][0-9]*|1.01) kg/s from 0 to 0.13 s, 100 % of what comes in")
        head, rest = early.split("outlets:")
        closed = head.replace(", open: delete", "") + "gauges:" + rest.split("gauges:")[1]
        self.assertFalse([text for text in self.warned(closed) if text.startswith("Balance")])

    def check_balance(self, done, rows):
        balance, last = self.summary("out")["balance"], rows[-1]
        self.assertEqual(balance["lost"]["grains"], 0)
        self.assertLess(abs(balance["lost"]["mass_kg"]), 1e-12)
        self.assertEqual(balance["in"]["grains"], last["inlet_1.grains"])
        self.assertEqual(balance["inside"]["grains"], last["grains"])
        self.assertEqual(balance["out"]["outlet_left"]["grains"], last["outlet_left.grains"])
        # what missed both outlets leaves below, and is spilled as what goes to the second one
        spilled = last["outlet_low.grains"] + last["left_z_min.grains"]
        self.assertEqual(balance["spillage"]["grains"], spilled)
        self.assertTrue(balance["out"]["outlet_low"]["spillage"])
        self.assertFalse(balance["out"]["outlet_left"]["spillage"])
        flows = [one["flow_kg_per_s"]["mean"] for one in balance["out"].values()]
        stored = balance["inside"]["flow_kg_per_s"]["mean"]
        came = balance["in"]["flow_kg_per_s"]["mean"]
        self.assertLess(abs(came - 1.0), 3e-3)
        self.assertLess(abs(sum(flows) + stored - came), 1e-12)
        left = balance["out"]["outlet_left"]["flow_kg_per_s"]["mean"]
        self.assertLess(abs(left - 0.5), 0.05)  # half of the width, to its left
        self.assertIn("spilled low", done.stdout)
        self.assertIn("lost ", done.stdout)
        self.assertIn("s, +- standard deviation of 10 blocks\n", done.stdout)

    def check_tables(self, gauge):
        path = clod.table(self.path("out/gauge_fall-trajectory.csv"))
        # along -z; the mass in a slice of 25 mm is flow times time there
        self.assertEqual([round(row["along"], 6) for row in path],
                         [0.1125, 0.1375, 0.1625, 0.1875])
        first = math.sqrt(1.0 + 2.0 * G * path[1]["along"])
        self.assertLess(abs(path[1]["mass"] - 0.025 / first), 0.03 * 0.025 / first)
        self.assertLess(path[1]["lower"], path[1]["mean"])
        self.assertLess(path[1]["mean"], path[1]["upper"])
        profile = clod.table(self.path("out/gauge_fall-profile.csv"))
        total = sum(row["mass"] for row in profile)
        self.assertLess(abs(total - gauge["mass_kg"]["mean"]), 1e-9)
        self.assertEqual(profile[0]["share"], 0.0)  # grains are within 80 mm
        self.assertAlmostEqual(gauge["profile"]["mass_kg"][4], profile[4]["mass"], delta=1e-9)

    def test_ore_is_brought_to_the_speed_of_a_belt(self):
        """Q (v - v0) is the belt's force; of its work half of Q (v - v0)^2 becomes heat."""
        self.write(BELT)
        done = self.go("out")
        summary = self.summary("out")
        q, v, v0, down = 0.3, 2.0, 0.5, 0.5
        height = 0.020 - 0.005  # from the middle of the inlet to a grain that lies
        belt = summary["belts"]["feed"]
        # in 1.5 s come 345 grains, and not one more or less
        self.assertLess(abs(belt["pull_N"]["mean"] - q * (v - v0)), 0.01 * q * (v - v0))
        self.assertLess(abs(belt["power_W"]["mean"] - q * (v - v0) * v), 0.01 * q * v)
        self.assertAlmostEqual(belt["speed_m_per_s"], v, delta=1e-9)
        gauge = summary["gauges"]["all"]
        self.assertAlmostEqual(gauge["belt_power_W"]["mean"], belt["power_W"]["mean"], delta=2e-3)
        # the report: along the belt, into it, and along less the belt's speed
        along, upward = (gauge[f"velocity_{axis}_m_per_s"]["mean"] for axis in "xz")
        self.assertIn(f"{along:.4g} m/s along its direction, {-upward:.4g} m/s into the belt; along less the belt's "
                      f"2 m/s: {along - v:.4g} m/s", done.stdout)
        for key, value in (("along_m_per_s", along), ("into_m_per_s", -upward), ("along_less_belt_m_per_s", along - v)):
            self.assertAlmostEqual(gauge["landing"][key], value, delta=1e-12)
        self.assertNotIn("landing", summary["gauges"]["end"])  # it has no belt
        self.assertIn("+- is the standard deviation of those of 10 blocks", done.stdout)
        self.assertIn(" N, +- standard deviation of ten blocks\n", done.stdout)
        gained = 0.5 * q * (v * v - v0 * v0 - down * down)
        heat = 0.5 * q * ((v - v0)**2 + down * down) + q * G * height
        # a grain is not seen in the millisecond in which it comes: 1 ms of 0.5 s
        self.assertLess(abs(gauge["acceleration_W"]["mean"] - gained), 0.02 * gained)
        self.assertLess(abs(gauge["lifting_W"]["mean"] + q * G * height), 0.05 * q * G * height)
        self.assertLess(abs(gauge["heat_W"]["mean"] - heat), 0.02 * heat)
        end = summary["gauges"]["end"]
        self.assertLess(abs(end["velocity_x_m_per_s"]["mean"] - v), 1e-3)
        self.assertLess(abs(end["mass_flow_kg_per_s"]["mean"] - q), 0.02 * q)
        self.assertLess(abs(end["mass_kg"]["mean"] - q * 0.2 / v), 0.02 * q * 0.2 / v)
        # one layer of grains on the belt
        for row in clod.table(self.path("out/gauge_end-profile.csv")):
            if row["share"] > 0.5:
                self.assertLess(row["upper"], 0.0102)
                self.assertGreater(row["lower"], -1e-4)
        self.assertIn("pull of the load", done.stdout)

    def test_a_belt_at_rest_and_starting_has_its_way(self):
        """Start-up: half of the speed on the mean; power over a belt that stands is none."""
        self.write(BELT.replace("    material: ore\n    shapes",
                                "    material: ore\n    start_up: {at: 0.1 s, duration: 0.1 s}"
                                "\n    shapes").replace("2.5 s", "0.3 s")
                   .replace("steady_since: 1 s", "steady_since: 0 s"))
        self.go("out")
        speeds = [row["feed.belt_speed"] for row in clod.table(self.path("out/series.csv"))]
        # rows of 50 ms: stands, and rises linearly from 0.1 s to 0.2 s
        for found, expected in zip(speeds, (0.0, 0.0, 0.5, 1.5, 2.0, 2.0)):
            self.assertLess(abs(found - expected), 0.02)
        pulls = [row["feed.pull"] for row in clod.table(self.path("out/series.csv"))]
        self.assertTrue(math.isnan(pulls[0]) and not math.isnan(pulls[-1]))

    def test_landing_takes_the_belts_speed_at_that_moment(self):
        """Grains fly through the gauge from 0.2 s to 0.6 s and from 1 s to 1.2 s, over a belt that rises to 2 m/s from
        0.1 s to 0.5 s: by time 0.375 + 0.2 + 0.4 m of belt pass in 0.6 s, 1.625 m/s, not 2."""
        self.write("x [m],y [m],z [m],radius [mm],vx [m/s]\n"
                   "0,0,0,10,0.5\n-0.4,0,0,10,0.5\n", "grains.csv")
        self.write(ALARM.replace("    blocked: {mass_above: 1 g, speed_below: SPEED, for: 0.05 s}\n", """\
    direction: [1, 0, 0]
    across: [0, 1, 0]
    belt: feed
walls:
  feed:
    material: ore
    start_up: {at: 0.1 s, duration: 0.4 s}
    shapes:
      - belt: {from: [-0.5 m, 0 m, -0.5 m], runs: [{length: 1 m}], width: 100 mm, speed: 2 m/s}
""").replace("annulus: {center: [0.2 m, 0 m, -0.1 m], outer_radius: 0.1 m, height: 0.2 m}",
             "box: {min: [0.1 m, -0.1 m, -0.1 m], max: [0.3 m, 0.1 m, 0.1 m]}")
                   .replace("100 ms}", "100 ms, steady_since: 0 s}"))
        done = self.go("out")
        landing = self.summary("out")["gauges"]["slot"]["landing"]
        self.assertAlmostEqual(landing["along_m_per_s"], 0.5, delta=1e-12)
        self.assertLess(abs(landing["along_less_belt_m_per_s"] - (0.5 - 0.975 / 0.6)), 0.01)  # samples are 1 ms apart
        self.assertIn("along less the belt's 1.62", done.stdout)

    def fly(self, speed, step="1e-4 s"):
        self.write("x [m],y [m],z [m],radius [mm],vx [m/s]\n"
                   "0,0,0,10,0.5\n-0.4,0,0,10,0.5\n", "grains.csv")
        self.write(ALARM.replace("SPEED", speed).replace("1e-4 s", step))
        done = self.go("out", "1", "--fresh")
        return done, self.summary("out")["gauges"]["slot"]

    def test_an_alarm_says_when_it_began(self):
        done, gauge = self.fly("0.6 m/s")
        self.assertEqual(gauge["alarms"], 2)
        self.assertLess(abs(gauge["blocked_since_s"] - 0.2), 1.5e-3)  # looks are 1 ms apart
        self.assertTrue(gauge["blocked_at_end"])
        self.assertIn("WARNING", done.stdout)
        self.assertIn("it was blocked, the first time from 0.2", done.stdout)
        rows = clod.table(self.path("out/series.csv"))
        # rows of 0.1 s; the alarm is from 0.25 s to 0.6 s, and from 1.05 s on
        for row, share in zip(rows, (0, 0, 0.5, 1, 1, 1, 0, 0, 0, 0, 0.5, 1)):
            self.assertLess(abs(row["gauge_slot.blocked"] - share), 0.021)
        _, gauge = self.fly("0.4 m/s")
        self.assertEqual(gauge["alarms"], 0)
        self.assertIsNone(gauge["blocked_since_s"])

    def alarms(self, folder):
        """Events of alarms in the log, without the time on the clock."""
        return [{key: event[key] for key in event if key != "time"}
                for event in clod.log(self.path(folder)) if event["event"].startswith("alarm")]

    def test_alarms_are_said_when_they_begin_and_end(self):
        """A grain at 0.5 m/s is in the slot of 0.2 m from 0.2 s to 0.6 s, another from 1 s on; an alarm
        begins after 50 ms."""
        done, gauge = self.fly("0.6 m/s")
        events = self.alarms("out")
        self.assertEqual([event["event"] for event in events],
                         ["alarm begins", "alarm ends", "alarm begins"])
        mass = 2500 * 4 / 3 * math.pi * 0.01**3
        for event, time in zip(events, (0.25, 0.6, 1.05)):
            self.assertEqual(event["gauge"], "slot")
            self.assertLess(abs(event["time_s"] - time), 2.5e-3)
            self.assertAlmostEqual(event["time_s"], event["step"] * 1e-4, 9)
        self.assertAlmostEqual(events[0]["mass_kg"], mass, 9)
        self.assertAlmostEqual(events[0]["since_s"], gauge["blocked_since_s"], 9)
        self.assertAlmostEqual(events[0]["speed_m_per_s"], 0.5, 6)
        self.assertEqual(events[1]["mass_kg"], 0.0)
        self.assertEqual(done.stderr.count("gauge slot is blocked since"), 2)
        self.assertEqual(done.stderr.count("gauge slot is not blocked any more"), 1)

    @clod.quick_only
    def test_alarms_are_logged_once_when_a_run_is_killed(self):
        """Killed after the first alarm it begins anew from its first checkpoint, before it."""
        self.fly("0.6 m/s", "2e-7 s")
        whole = self.alarms("out")
        process = clod.start("run", self.path("case.yaml"), "-o", self.path("cut"), "-t", "1")
        clod.wait_until(lambda: os.path.exists(self.path("cut/log.jsonl")) and
                        len(self.alarms("cut")) > 0, process)
        process.kill()
        process.communicate()
        self.go("cut")
        self.assertTrue(any(event["event"] == "resume" for event in clod.log(self.path("cut"))))
        self.assertEqual(self.alarms("cut"), whole)

    @clod.quick_only
    def test_the_same_bytes_on_threads_and_when_interrupted(self):
        text = FALL.replace("DURATION", "0.7 s").replace("steady_since: 0.4 s",
                                                         "steady_since: 0.1 s")
        self.write(text.replace("outlets:", """\
walls:
  feed:
    material: ore
    shapes:
      - belt: {from: [-80 mm, 0 m, -210 mm], runs: [{length: 90 mm}], width: 100 mm, speed: 1 m/s}
outlets:""").replace("    profile", "    belt: feed\n    profile"))
        self.go("one")
        self.go("two", "2")
        self.stop_after(5, "cut")
        self.go("cut", "2")
        for name in ("series.csv", "gauge_fall-profile.csv", "gauge_fall-trajectory.csv"):
            whole = clod.read(self.path("one/" + name))
            self.assertEqual(whole, clod.read(self.path("two/" + name)), name)
            self.assertEqual(whole, clod.read(self.path("cut/" + name)), name)
        whole = clod.without_clock(clod.read(self.path("one/summary.json")))
        self.assertEqual(whole, clod.without_clock(clod.read(self.path("two/summary.json"))))
        self.assertEqual(whole, clod.without_clock(clod.read(self.path("cut/summary.json"))))
        self.assertGreater(whole["gauges"]["fall"]["belt_power_W"]["mean"], 0.0)

    def test_the_balance_of_a_run_without_outlets(self):
        """Nothing is spilled where no way is the right one."""
        head, rest = FALL.replace("DURATION", "0.5 s").split("outlets:")
        self.write(head + "gauges:" + rest.split("gauges:")[1])
        done = self.go("out")
        balance, last = self.summary("out")["balance"], clod.table(self.path("out/series.csv"))[-1]
        self.assertEqual(balance["lost"]["grains"], 0)
        self.assertEqual(balance["spillage"]["grains"], 0)
        self.assertEqual(balance["out"]["left_z_min"]["grains"], last["left_z_min.grains"])
        self.assertGreater(last["left_z_min.grains"], 100)
        self.assertNotIn("spilled", done.stdout)

    def test_tables_of_before_go(self):
        self.write(FALL.replace("DURATION", "0.5 s"))
        self.go("out")
        self.assertTrue(os.path.exists(self.path("out/gauge_fall-profile.csv")))
        self.write(FALL.replace("DURATION", "0.5 s").replace("    profile: {bins: 10}\n", ""))
        self.go("out", "1", "--fresh")
        self.assertFalse(os.path.exists(self.path("out/gauge_fall-profile.csv")))
        self.assertTrue(os.path.exists(self.path("out/gauge_fall-trajectory.csv")))


if __name__ == "__main__":
    clod.main()
