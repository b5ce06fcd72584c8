"""docs/howto/hopper.md, as a new user follows it: its commands print what it shows, and its text tells their numbers."""

import json
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import page

PAGE = "docs/howto/hopper.md"


class Page(page.Case):

    @clod.quick_only
    def test_commands_print_what_the_page_shows_and_the_text_tells(self):
        steps = page.steps(PAGE)
        self.assertGreater(len(steps), 3)
        for command, text in steps:
            self.follow(command, text)
        with open(self.path("design.json")) as file:
            found = json.load(file)
        with open(clod.source(PAGE)) as file:
            text = " ".join(file.read().partition("## 4. Read it")[2].split())
        cone, holes = found["cone"], found["rathole"]
        outlet, margin = cone["outlet_m"], cone["arching_margin"]
        slot = [f"{1e3 * holes['slot_width_m'][end]:.0f}" for end in ("value", "low", "high")]
        points = [point["sigma_1_Pa"] for point in found["measured"]["flow_function"]]
        for told in (f"Its lower end, {cone['half_angle_deg']['low']:.1f} deg here",
                     f"**Critical outlet**: {1e3 * outlet['value']:.0f} mm, and with the errors of these "
                     f"measurements up to {1e3 * outlet['high']:.0f} mm.",
                     f"**Outlet of {1e3 * cone['planned_outlet_m']:.0f} mm**: the stress in an arch is "
                     f"{margin['value']:.1f} times what the solid can bear, and at least {margin['low']:.1f} times in "
                     f"95 % of the samples; it flows in {100 * (1 - cone['planned_outlet_arching_share']):.1f} % of them.",
                     f"It empties only down to a hole of {holes['emptying_m']['value']:.1f} to "
                     f"{holes['filling_m']['value']:.0f} m.",
                     f"`width of a slot in funnel flow` of the wedge block, {slot[0]} mm here ({slot[1]} to {slot[2]})",
                     f"the critical states lie at {cone['sigma_1_Pa']['value'] / 1e3:.1f} kPa, the smallest test at "
                     f"{min(points) / 1e3:.1f} kPa"):
            self.assertIn(told, text)
        with open(clod.source("cases/hopper-design/README.md")) as file:
            text = " ".join(file.read().split())
        cone, slot = ([f"{1e3 * shape['outlet_m'][end]:.0f}" for end in ("value", "low", "high")]
                      for shape in (found["cone"], found["wedge"]))
        self.assertIn(f"a cone of {found['cone']['half_angle_deg']['value']:.1f} deg with a critical outlet of {cone[0]} mm "
                      f"({cone[1]} to {cone[2]}), a slot of {slot[0]} mm ({slot[1]} to {slot[2]}), and mass flow in both",
                      text)

    def test_the_refusal_on_the_page(self):
        """Its block begins with the program's name."""
        with open(clod.source(PAGE)) as file:
            block = re.search(r"```\n(clod hopper: .*?)```", file.read(), re.DOTALL).group(1)
        with open(self.path("hopper.yaml"), "w") as file:
            file.write("flow_function: {file: flow-function.csv}\nwall_friction: {angle: 22}\n")
        done = clod.run("hopper", "hopper.yaml", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (2, block))


if __name__ == "__main__":
    clod.unittest.main()
