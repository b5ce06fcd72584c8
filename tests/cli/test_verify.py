"""clod verify: names, files, exit status. A made-up miss is in tests/verify/test_report.c."""

import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

QUICK = "chung-ooi-2"


class Verify(clod.Case):
    def test_list(self):
        done = clod.run("verify", "--list")
        self.assertEqual(done.returncode, 0, done.stderr)
        names = [line.split()[0] for line in done.stdout.splitlines()]
        self.assertIn(QUICK, names)
        self.assertEqual(len(names), len(set(names)))
        for line in done.stdout.splitlines():
            self.assertGreater(len(line.split()), 2, "every test says what it looks at")
        slow = [line.split()[0] for line in done.stdout.splitlines() if line.endswith("(slow)")]
        for name in ("beverloo", "repose"):
            self.assertIn(name, slow, "a bed of minutes is not run unasked")
        self.assertNotIn(QUICK, slow)

    def test_unknown_name(self):
        done = clod.run("verify", "-o", self.path("out"), "chung-oi-2")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no test chung-oi-2; did you mean chung-ooi-2?", done.stderr)
        self.assertIn("there are chung-ooi-1, chung-ooi-2, ", done.stderr)
        self.assertIn("--list", done.stderr)
        self.assertFalse(os.path.exists(self.path("out")), "a wrong name leaves no folder")

    def test_a_name_of_the_other_kind(self):
        for words, message, exists in (
                (["--slow", QUICK], f"{QUICK} is no slow test: run it without --slow", "janssen"),
                (["--slow", "janssen", QUICK], f"{QUICK} is no slow test", "janssen"),
                (["janssen"], "janssen is a slow test: run it with --slow", QUICK)):
            done = clod.run("verify", "-o", self.path("out"), *words)
            self.assertEqual(done.returncode, 2, "nothing may pass for a test that is not run")
            self.assertIn(message, done.stderr)
            self.assertIn(exists, done.stderr.split("--slow there are ")[1])
            self.assertNotIn("quantities", done.stdout)
            self.assertFalse(os.path.exists(self.path("out")))

    def test_wrong_use(self):
        done = clod.run("verify", "--output=")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--output: the name of a folder is needed", done.stderr)
        with open(self.path("file"), "w") as file:
            file.write("mine")
        done = clod.run("verify", "-o", self.path("file/deep"), QUICK)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot be made", done.stderr)

    def test_report_of_someone_else(self):
        for text in ("", "# Verification\n\nof my own model\n"):
            with open(self.path("verification.md"), "w") as file:
                file.write(text)
            done = clod.run("verify", "-o", self.folder, QUICK)
            self.assertEqual(done.returncode, 2)
            self.assertIn("verification.md is in the way", done.stderr)
            self.assertIn("-o", done.stderr)
            self.assertEqual(os.listdir(self.folder), ["verification.md"])
            with open(self.path("verification.md")) as file:
                self.assertEqual(file.read(), text)

    def test_report_curves_and_cases(self):
        done = clod.run("verify", "-o", self.path("a/b"), QUICK)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(self.path("a/b/verification.md")) as file:
            text = file.read()
        rows = [line for line in text.splitlines() if line.startswith("| " + QUICK)]
        self.assertIn(f"{len(rows)} quantities, 0 missed;", text)
        self.assertIn(f"{len(rows)} quantities, 0 missed", done.stdout)
        self.assertTrue(any("peak force" in row for row in rows))
        with open(self.path(f"a/b/{QUICK}-al_alloy.csv")) as file:
            table = list(csv.reader(file))
        self.assertEqual(len(table[0]), 3)
        self.assertGreater(len(table), 20)
        again = clod.run("verify", "-o", self.path("a/b"), QUICK)
        self.assertEqual(again.returncode, 0, again.stderr)
        # what a reader would do: run the case that was tested
        case = self.path(f"a/b/cases/{QUICK}-al_alloy/case.yaml")
        again = clod.run("run", case, "-o", self.path("rerun"), "-t", "1")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertTrue(os.path.exists(self.path("rerun/series.csv")))


if __name__ == "__main__":
    clod.main()
