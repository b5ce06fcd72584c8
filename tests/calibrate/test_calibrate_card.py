"""The material card says what its values belong to, and a case that includes it is compared with that."""

import json
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import bounce
import clod

# Of bounce.yaml: what is written there, and the defaults of docs/manual.md.
WITH = {"density": "2500 kg/m3", "soften": "1", "law": "hooke", "exponent": "1", "k1": "100000 N/m", "friction": "0",
        "coulomb": "adhesive", "tangential": "tangent", "rolling": "none"}
MISSES = "the included card misses "
NAME = "it's a \"$HOME\" `bounce`.yaml" # a file of a user who does not know shells
DIFFERS = "the included card was calibrated with another solid than ore is here: "


class Card(bounce.Bounce):

    def section(self):
        """Keys and values of calibrated_with."""
        with open(self.path("out/card.yaml")) as file:
            below = file.read().split("calibrated_with:")[1].split("\n")
        self.assertIn("ore in the test bounce", below[0])
        return dict(line.strip().split(": ") for line in below[1:] if line)

    def warnings(self, case, *arguments):
        done = clod.run("check", case, "--json", "-t", "1", *arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout).get("warnings", [])

    def test_card_has_the_rest_of_the_solid_and_cases_are_compared_with_it(self):
        self.calibrate(bounce.PLAN, "-o", "out")
        found = self.section()
        for key, value in WITH.items():
            self.assertEqual(found.get(key), value, key)
        self.assertNotIn("restitution", found)  # calibrated: it stands above
        self.assertEqual(found["targets"], "met")
        self.assertNotIn("held_back", found)
        card = ("--set", "include=out/card.yaml")
        none = self.warnings("bounce.yaml", *card)
        self.assertEqual([text for text in none if DIFFERS in text or MISSES in text], [])
        # another unit is no other value
        same = self.warnings("bounce.yaml", *card, "--set", "contacts.default.k1=100 kN/m")
        self.assertEqual([text for text in same if DIFFERS in text], [])
        other = self.warnings("bounce.yaml", *card, "--set", "contacts.default.friction=0.9", "--set", "contacts.soften=5",
                              "--set", "materials.ore.density=2600 kg/m3")
        told = [text for text in other if DIFFERS in text]
        self.assertEqual(len(told), 1, other)
        for words in ("density 2600 kg/m3 (card: 2500 kg/m3)", "soften 5 (card: 1)", "friction 0.9 (card: 0)"):
            self.assertIn(words, told[0])
        # clod run says so in its log
        done = clod.run("run", "bounce.yaml", *card, "--set", "contacts.default.friction=0.9", "-o", "one", "-t", "1",
                        cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning: " + DIFFERS + "friction 0.9 (card: 0).", " ".join(done.stderr.split()))
        with open(self.path("one/case-complete.yaml")) as file:
            self.assertNotIn("calibrated_with", file.read())

    def words(self, command):
        """Arguments of clod in a command of the report, as a shell takes them."""
        line = command.replace("clod", "printf '%s\\n'", 1).replace("FOLDER", self.path("out"))
        return subprocess.run(["sh", "-c", line], capture_output=True, text=True, check=True).stdout.splitlines()

    def test_card_that_misses_its_targets_is_warned_of(self):
        """Its energy is above that of restitution 0.9, the end of the range."""
        self.calibrate(bounce.PLAN, "--set", f"targets.0.value={bounce.BEFORE:.6g} J", "-o", "out")
        self.assertEqual(self.section()["targets"], "missed")
        card = ("--set", "include=out/card.yaml")
        told = [text for text in self.warnings("bounce.yaml", *card) if "the included card" in text]
        self.assertEqual(len(told), 1, told)
        self.assertIn(MISSES + "the targets that it was calibrated with (calibrated_with.targets: missed)", told[0])
        done = clod.run("run", "bounce.yaml", *card, "-o", "one", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning: " + told[0].rstrip("."), " ".join(done.stderr.split()))
        with open(self.path("one/summary.json")) as file:
            self.assertEqual(json.load(file)["warnings"], [told[0].rstrip(".")])
        self.assertEqual(clod.run("report", "one", cwd=self.folder).returncode, 0)
        with open(self.path("one/report.html")) as file:
            self.assertIn("<li>" + told[0].rstrip("."), file.read())

    def test_card_that_misses_what_was_held_back_is_warned_of(self):
        untold = "whether the included card "
        for targets, held_back, words in (("met", "met", []), ("met", "missed", [MISSES + "measurements that were held back"]),
                                          ("untold", "missed", [untold + "meets the targets that it was calibrated with is not told"]),
                                          ("missed", "untold", [MISSES + "the targets that it was calibrated with"]),
                                          ("met", "untold", [untold + "predicts the measurements that were held back"])):
            self.write("card.yaml", f"calibrated_with: {{targets: {targets}, held_back: {held_back}}}\n")
            told = [text for text in self.warnings("bounce.yaml", "--set", "include=card.yaml") if "the included card" in text]
            self.assertEqual(len(told), len(words), told)
            self.assertTrue(all(text.startswith(word) for text, word in zip(told, words)), told)

    def test_card_of_surrogates_that_tell_nothing_is_warned_of(self):
        """Friction moves no energy, and packings of twelve grains scatter by 5 %, thirty times the laboratory's error: p is far above
        0.05. The command of the report runs the card."""
        plan = bounce.PLAN.replace("contacts.default.restitution, from: 0.2, to: 0.9", "contacts.default.friction, from: 0.1, to: 0.5")
        plan = plan.replace(f"value: {bounce.BEFORE * bounce.TRUTH**2:.6g}, error: 4e-6", f"value: {bounce.BEFORE * 0.25:.6g}, error: 2e-7")
        plan = plan.replace("{case: bounce.yaml}", "{case: bounce.yaml, set: {contacts.soften: 2}}")
        done = self.calibrate(plan, "-o", "out")
        self.assertEqual(self.section()["targets"], "untold", done.stdout)
        self.assertEqual(self.found()["card_targets"], "untold")
        self.assertIsNone(self.found()["card_held_back"])
        self.assertGreater(self.found()["p_value"], 0.05)
        self.assertIn("Whether the card meets its targets is not told (targets: untold)", " ".join(done.stdout.split()))
        command = next(line for line in done.stdout.split("\n") if line.startswith("  clod run "))
        arguments = self.words(command)
        self.assertEqual(arguments[2:4], ["--set", "contacts.soften=2"])
        run = clod.run(*arguments, "-t", "1", cwd=self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("warning: whether the included card meets the targets", " ".join(run.stderr.split()))
        with open(self.path("out/card-bounce/case-complete.yaml")) as file:
            self.assertIn(f"friction: {self.found()['parameters']['e']['card']:.4g}", file.read())

    def test_command_keeps_what_a_case_includes_itself(self):
        """By --set include the card would stand in place of the case's own file, and the grains would fall."""
        rest = "gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n"
        with open(self.path("bounce.yaml")) as file:
            case = file.read()
        self.assertIn(rest, case)
        self.write("rest.yaml", rest)
        self.write(NAME, case.replace(rest, ""))
        self.write("another.yaml", case.replace(rest, "include: rest.yaml\n"))
        tests = ("{case: %s, set: {include: rest.yaml}}" % json.dumps(NAME), "{case: another.yaml}")
        for test in tests[:1] if clod.SANITIZED else tests:
            done = self.calibrate(bounce.PLAN.replace("{case: bounce.yaml}", test), "-o", "out")
            lines = done.stdout.split("\n")
            at = next(k for k, line in enumerate(lines) if line.startswith("  clod run "))
            self.assertRegex(" ".join(lines[at - 2 : at]), r"test bounce includes .*rest.yaml, and one file only .* into +FOLDER/card-bounce.yaml")
            with open(self.path("out/card.yaml")) as file:
                self.write("out/card-bounce.yaml", file.read() + rest)
            run = clod.run(*self.words(lines[at]), "-t", "1", cwd=self.folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(self.path("out/card-bounce/case-complete.yaml")) as file:
                complete = file.read()
            self.assertIn(f"restitution: {self.found()['parameters']['e']['card']:.4g}", complete)
            self.assertIn("gravity: [0 m/s2, 0 m/s2, 0 m/s2]", complete)
            shutil.rmtree(self.path("out"))

    def test_summary_of_a_tester_has_the_warning(self):
        self.write("card.yaml", "calibrated_with: {targets: missed}\n")
        done = clod.run("run", clod.source("tests/cli/uniaxial.yaml"), "--set", f"include={self.path('card.yaml')}", "--set",
                        "uniaxial.consolidation_stresses=[20 kPa]", "-o", "out", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("out/summary.json")) as file:
            told = [text for text in json.load(file)["warnings"] if text.startswith(MISSES)]
        self.assertEqual(len(told), 1)

    @clod.quick_only
    def test_calibrated_keys_are_not_compared(self):
        plan = bounce.PLAN.replace("from: 0.2, to: 0.9", "from: 0.2, to: 0.9, multiples: {contacts.default.friction: 0.5}")
        self.calibrate(plan.replace("parameters:", "parameters:\n  s: {key: contacts.soften, from: 1, to: 2}"), "-o", "out")
        found = self.section()
        for key in ("restitution", "friction", "soften"):
            self.assertNotIn(key, found)
        self.assertEqual(found["k1"], WITH["k1"])

    def test_card_of_cases_lab_to_outlet(self):
        """It belongs to the case of its plan."""
        lab = clod.source("cases/lab-to-outlet")
        with open(os.path.join(lab, "card.yaml")) as file:
            self.assertRegex(file.read(), r"(?m)^  k1: 3000000 N/m\^1.5$")
        for case in ("ring.yaml", "chute.yaml", "wall.yaml"):
            arguments = ("--set", f"include={lab}/card.yaml") if case == "ring.yaml" else ()
            texts = self.warnings(os.path.join(lab, case), *arguments)
            self.assertEqual([text for text in texts if "the included card" in text], [], case)


if __name__ == "__main__":
    clod.unittest.main()
