"""The page in a browser: its scripts run without an error and draw; it fits a phone.

Skipped where there is no browser, or clod was built without the scripts of its pages.
"""

import html
import json
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod

BROWSER = next(filter(None, map(shutil.which, ("chromium-headless-shell", "chromium", "google-chrome"))), None)
# a note of the driver's about speed, no error of the page
IGNORED = "GL Driver Message"


@clod.unittest.skipIf(BROWSER is None, "no browser: Debian's chromium-headless-shell shows the pages")
class Browser(clod.Case):

    def show(self, name, width=1200):
        """The page after its scripts ran: attributes of its root element, and the whole text."""
        done = subprocess.run(
            [BROWSER, "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             f"--user-data-dir={self.path('profile')}", "--virtual-time-budget=20000",
             f"--window-size={width},900", "--enable-logging=stderr", "--dump-dom", f"file://{self.path(name)}"],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=600)
        said = [line for line in done.stderr.splitlines() if ":CONSOLE" in line and IGNORED not in line]
        self.assertEqual(said, [])
        root = re.search(r"<html([^>]*)>", done.stdout)[1]
        seen = {key: html.unescape(value) for key, value in re.findall(r'data-(\w+)="([^"]*)"', root)}
        self.assertEqual(seen.get("ready"), "yes", done.stderr[-2000:])
        self.assertEqual(json.loads(seen["errors"]), [])
        self.assertLessEqual(int(seen["overflow"]), 0, "wider than the window")
        return seen, done.stdout

    def need_scripts(self, done):
        if "built without the scripts" in done.stderr:
            self.skipTest("no scripts: clod was built without npm or a network")

    def test_free_run_with_grains(self):
        done = clod.run("run", clod.source("tests/restart/box.yaml"), "-o", self.path("box"),
                        *pages.SHORT)
        self.assertEqual(done.returncode, 0, done.stderr)
        made = clod.run("report", self.path("box"))
        self.need_scripts(made)
        with open(self.path("box/summary.json")) as file:
            summary = json.load(file)
        seen, _ = self.show("box/report.html")
        view, = json.loads(seen["views"])
        self.assertEqual(view["grains"], summary["grains"])
        self.assertGreater(view["coverage"], 0.05)  # of the canvas
        self.assertGreater(view["colours"], 50)     # spheres have shades
        self.assertGreater(int(seen["figures"]), 1)

    def test_numbers_and_width(self):
        pages.uniaxial(self.path("run"))
        self.need_scripts(clod.run("report", self.path("run")))
        for width in (1200, 390):
            seen, dom = self.show("run/report.html", width)
            self.assertEqual(seen["figures"], "3")
            # plotly has drawn: its own elements hold the curves
            self.assertEqual(dom.count('class="main-svg"') >= 3, True)
            self.assertIn("11677", dom)
        pages.free_run(self.path("one"))
        pages.free_run(self.path("two"), density="2600")
        clod.run("compare", self.path("one"), self.path("two"), "-o", self.path("both.html"))
        seen, _ = self.show("both.html", 390)
        self.assertGreater(int(seen["figures"]), 1)


if __name__ == "__main__":
    clod.unittest.main()
