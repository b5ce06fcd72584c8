"""clod hopper with an outlet that is given: what is said where it arches, and why it has no margin."""

import json
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from hopper_case import FLOW, ROWS, clod

SMOOTH = "wall_friction: {angle: 20 deg, error: 1 deg}\n"
ADHESIVE = "wall_friction: {file: wall.csv}\n"  # tau_w = 0.3 kPa + 0.3 sigma_w: sticks at small stresses
KINDS = ("below the critical one", "inside the interval", "do not flow through", "not large enough, as none is")


class Outlet(clod.Case):

    def start(self, wall=SMOOTH, rows=ROWS, more=""):
        for name, text in (("flow.csv", FLOW + rows),
                           ("wall.csv", "sigma_w [kPa],tau_w [kPa]\n1,0.6\n4,1.5\n16,5.1\n"),
                           ("case.yaml", "flow_function: {file: flow.csv}\n" + wall + more)):
            with open(self.path(name), "w") as file:
                file.write(text)

    def design(self, *arguments):
        """What is on the terminal, in one line, and in design.json; both and the page have the same warnings."""
        done = clod.run("hopper", "case.yaml", "-o", "design", "--set", "interval.samples=200", *arguments,
                        cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("design.json")) as file:
            found = json.load(file)
        with open(self.path("design.html")) as file:
            page = file.read()
        told = " ".join(done.stdout.split())
        for text in found["warnings"]:
            self.assertIn("- " + text, told)
            self.assertIn(f"<li>{text}</li>", page.replace("&#39;", "'"))
        return found

    def outlet(self, shape, length, *arguments):
        """The design, and what is said of the outlet of a shape: [(kind, text)], and why it has no margin."""
        found = self.design("--set", f"{shape}.outlet={1e3 * length:.6g} mm", *arguments)
        mine = [text for text in found["warnings"] if text.startswith(shape.capitalize() + ": ") and "outlet of" in text]
        kinds = [(kind, text) for text in mine for kind in KINDS if kind in text]
        why = [text.partition("has no stress over strength: ")[2] for text in mine if "has no stress" in text]
        return found[shape], kinds, why

    def test_below_inside_and_above_the_interval(self):
        self.start()
        design = self.design()
        for shape in ("cone", "wedge"):
            critical = design[shape]["outlet_m"]
            low, value, high = (critical[end] for end in ("low", "value", "high"))
            numbers = f"{1e3 * value:.1f} mm ({1e3 * low:.1f} to {1e3 * high:.1f}): "
            for length, kind, words in ((0.9 * low, KINDS[0], numbers + "it arches. "),
                                        (0.5 * (low + value), KINDS[0], numbers + "as measured it arches. "),
                                        (0.5 * (value + high), KINDS[1], numbers[:-2] + ". ")):
                found, said, why = self.outlet(shape, length)
                self.assertEqual(([one for one, _ in said], why), ([kind], []), said)
                share = 100.0 * found["planned_outlet_arching_share"]
                self.assertTrue(share > 5.0)
                self.assertIn(f"{shape.capitalize()}: the outlet of {1e3 * length:.6g} mm is ", said[0][1])
                why = ": an arch stands" if kind == KINDS[1] else ""
                self.assertTrue(said[0][1].endswith(words + f"{share:.1f} % of the samples do not flow{why}."), said)
            self.assertEqual(self.outlet(shape, 1.5 * high)[1:], ([], []))

    def test_an_outlet_that_is_not_given_is_not_spoken_of(self):
        self.start(more="largest_particle: 100 mm\n")
        self.assertFalse([text for text in self.design()["warnings"] if "the outlet of" in text])

    def test_a_wall_that_holds_the_solid_at_low_stresses(self):
        """The design has a margin, a small outlet none: there the wall friction angle is too large."""
        self.start(wall=ADHESIVE)
        critical = self.design()["cone"]["outlet_m"]["value"]
        self.assertGreater(self.outlet("cone", 2.0 * critical)[0]["arching_margin"]["value"], 1.0)
        found, said, why = self.outlet("cone", 0.05 * critical)
        self.assertEqual(found["outcome"], "flows")
        self.assertIsNone(found["arching_margin"]["value"])
        self.assertEqual([kind for kind, _ in said], [KINDS[0]])
        self.assertEqual(len(why), 1)
        told = re.match(r"the solid would have to slide along a wall of (?P<wall>[0-9.]+) deg where sigma_1 is (?P<stress>[0-9.]+) kPa, and "
                        r"does not; so it does not flow\.$", why[0])
        self.assertTrue(told, why)
        self.assertLess(float(told["stress"]), 1e-3 * found["sigma_1_Pa"]["value"])
        self.assertEqual(told["wall"], f"{found['half_angle_deg']['value']:.1f}")

    def test_a_half_angle_that_is_given_at_the_outlet_where_the_wall_decides(self):
        """The wall holds the solid at outlets below the critical one, whose limit is the half angle: nothing is near its
        limit there, and the half angle is as given, with no interval."""
        self.start(wall=ADHESIVE)
        found = self.design("--set", "cone={half_angle: 20 deg, outlet: 10 mm}")
        self.assertTrue(found["cone"]["outlet_by_wall"])
        self.assertEqual(found["cone"]["half_angle_deg"], {"value": 20.0, "low": 20.0, "high": 20.0, "low_error": 0.0, "high_error": 0.0})
        self.assertFalse([text for text in found["warnings"] if "by less than the margin" in text])
        found = self.design("--set", "cone={half_angle: 26 deg, outlet: 1000 mm}", "--set", "wall_friction={angle: 20 deg}")
        self.assertTrue([text for text in found["warnings"] if "by less than the margin" in text])

    def test_funnel_flow_has_no_margin(self):
        """The slot is as wide as in test_a_slot_in_funnel_flow of test_hopper.py."""
        self.start(wall="wall_friction: {angle: 46 deg}\n")
        width = self.design()["rathole"]["slot_width_m"]
        ends = f"144.9 mm ({1e3 * width['low']:.1f} to {1e3 * width['high']:.1f})"
        for shape, words in (("cone", "a rathole decides in place of an arch."),
                             ("wedge", f"a slot must be wider than {ends}, and its diagonal longer than the rathole's diameter.")):
            found, said, why = self.outlet(shape, 0.5)
            self.assertEqual((found["outcome"], said), ("funnel_flow", []))
            self.assertEqual(why, ["it is funnel flow, where " + words])
            done = clod.run("hopper", "case.yaml", "--set", "interval.samples=200", "--set", f"{shape}.outlet=500 mm", cwd=self.folder)
            self.assertRegex(done.stdout, r"samples without mass flow +100.0 %\n")  # a slot may empty in funnel flow
            self.assertNotIn("samples that do not flow", done.stdout)

    def test_a_solid_that_cannot_flow(self):
        self.start(rows="2,3.0,0,45,40,1250\n8,9.0,0,45,40,1350\n")
        found, said, _ = self.outlet("cone", 0.5)
        self.assertEqual(found["outlet_m"]["value"], "infinite")
        self.assertEqual([kind for kind, _ in said], [KINDS[3]])

    def test_a_half_angle_at_the_limit(self):
        """A hundredth of a degree below the limit of the values as measured: in about half of the samples the wall
        is too rough for it. Half of 200, to three standard errors: 0.5 +- 0.11."""
        self.start(more="margin: 0.01 deg\n")
        high = self.design()["cone"]["outlet_m"]["high"]
        found, said, _ = self.outlet("cone", 3.0 * high)
        share = found["planned_outlet_arching_share"]
        self.assertAlmostEqual(share, 0.5, delta=0.15)
        self.assertEqual([kind for kind, _ in said], [KINDS[2]])
        self.assertIn(f"Cone: {100 * share:.1f} % of the samples do not flow through the outlet of", said[0][1])

    def test_a_wall_that_samples_do_not_slide_along(self):
        """A wall of 20 deg with an error of 5: the limit of a cone with phi_e 46 to 48 deg is 26 deg there, and falls by some 1.7 deg
        for each of the wall, so 23 deg are too flat where the wall is drawn some 0.35 errors too rough, in a third. No solid of
        these arches over 1 m, where 260 mm are critical."""
        self.start(wall="wall_friction: {angle: 20 deg, error: 5 deg}\n")
        found, said, _ = self.outlet("cone", 1.0, "--set", "cone.half_angle=23 deg")
        share = 100.0 * found["planned_outlet_arching_share"]
        self.assertTrue(15.0 < share < 50.0, share)
        self.assertEqual(len(said), 1, said)
        self.assertTrue(said[0][1].endswith(f"{share:.1f} % of the samples do not flow: the solid does not slide along the wall."), said)
        told = self.design("--set", "cone={half_angle: 23 deg, outlet: 1 m}")
        funnel = 100.0 * told["cone"]["sample_shares"]["funnel_flow"]
        self.assertTrue([text for text in told["warnings"] if text.startswith("Cone: mass flow is what the means") and
                         f"{funnel:.1f} % in funnel flow" in text], told["warnings"])
        page = " ".join(clod.run("hopper", "case.yaml", "--set", "interval.samples=200", "--set", "cone={half_angle: 23 deg, outlet: 1 m}",
                                 cwd=self.folder).stdout.split())
        self.assertIn(f"But {funnel:.1f} % of the samples are in funnel flow: see the warnings.", page)

    def test_most_samples_without_mass_flow(self):
        """The worked case's wall as it rusts holds the solid in more than half of the samples, which differ by the scatter of three
        specimens: the headline of its cone is no mass flow, though the measured values alone make one."""
        for name in ("hopper.yaml", "shear.csv", "wall-rust.csv"):
            shutil.copy(clod.source(f"cases/lab-to-outlet/{name}"), self.folder)
        done = clod.run("hopper", "hopper.yaml", "--set", "wall_friction.file=wall-rust.csv", "--set", "interval.samples=400", "-o", "rust",
                        cwd=self.folder)
        with open(self.path("rust.json")) as file:
            cone = json.load(file)["cone"]
        share = cone["sample_shares"]["funnel_flow"] + cone["sample_shares"]["mass_flow_unknown"]
        self.assertEqual(cone["outcome"], "flows")
        self.assertGreater(share, 0.5)
        headline = f"Mass flow is less likely than not: {100 * share:.1f} % of the samples have none."
        self.assertIn("Cone, round outlet " + headline, " ".join(done.stdout.split()))
        with open(self.path("rust.html")) as file:
            self.assertIn(f'<p class="verdict">{headline}', file.read())

    def test_samples_that_arch_and_samples_that_stick(self):
        """Over an outlet near the critical one both happen, and the two shares make the whole."""
        self.start(wall="wall_friction: {angle: 20 deg, error: 5 deg}\n")
        critical = self.design("--set", "cone.half_angle=23 deg")["cone"]["outlet_m"]["value"]
        _, said, _ = self.outlet("cone", 1.01 * critical, "--set", "cone.half_angle=23 deg")
        told = re.search(r"(?P<all>[0-9.]+) % of the samples do not flow: an arch stands in (?P<arch>[0-9.]+) %, and in "
                         r"(?P<wall>[0-9.]+) % the solid does not slide along the wall\.$", said[0][1])
        self.assertTrue(told, said)
        self.assertAlmostEqual(float(told["all"]), float(told["arch"]) + float(told["wall"]), delta=0.11)
        self.assertTrue(float(told["arch"]) > 5.0 and float(told["wall"]) > 5.0, said)

    def test_an_outlet_that_flows_in_all_samples_may_not_arch(self):
        """Particles of 3 m make the samples' own half angles so flat that the wall's outlets reach up to a metre and more; with the one
        angle of the design all of them flow."""
        self.start(wall=ADHESIVE, more="largest_particle: 3 m\n")
        with open(self.path("wall.csv"), "w") as file:
            file.write("sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n1,0.44,0.02\n2,0.83,0.03\n4,1.60,0.05\n8,3.15,0.08\n16,6.20,0.15\n")
        length = 0.95 * self.design()["cone"]["outlet_m"]["high"]
        found, said, _ = self.outlet("cone", length)
        self.assertTrue(found["outlet_m"]["value"] < length < found["outlet_m"]["high"])
        self.assertEqual((found["planned_outlet_arching_share"], said), (0.0, []))

    def test_large_particles(self):
        """8 times the largest in a cone, 4 times in a wedge (Marinelli): 800 and 400 mm."""
        self.start(more="largest_particle: 100 mm\n")
        for shape, times, least in (("cone", 8, 0.8), ("wedge", 4, 0.4)):
            words = f"is below {times} times the largest particle, {1e3 * least:.1f} mm: particles may lock over it"
            for length in (0.99 * least, 1.01 * least):
                told = " ".join(self.design("--set", f"{shape}.outlet={length} m")["warnings"])
                self.assertEqual(words in told, length < least, told)


if __name__ == "__main__":
    clod.unittest.main()
