"""Pages in a headless browser, for the tests that look at what their scripts do."""

import html
import json
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from pages import clod

BROWSER = next(filter(None, map(shutil.which, ("chromium-headless-shell", "chromium", "google-chrome"))), None)
# done when the page's own scripts are through
LATER = """
const waits = setInterval(() => {
  const root = document.documentElement;
  if (root.dataset.ready !== "yes") return;
  clearInterval(waits);
  root.dataset.tried = JSON.stringify((() => {%s})());
}, 20);
"""
# a note of the driver's about speed, no error of the page
IGNORED = "GL Driver Message"


@clod.unittest.skipIf(BROWSER is None, "no browser: Debian's chromium-headless-shell shows the pages")
class BrowserCase(clod.Case):

    def show(self, name, width=1200, height=900, then=None):
        """The page after its scripts ran: attributes of its root element, and the whole text. `then`: the
        body of a function of a user's; what it returns is the attribute `tried`."""
        if then is not None:
            page = clod.read(self.path(name)).decode().replace("</body></html>", f"<script>{LATER % then}</script></body></html>")
            name = os.path.join(os.path.dirname(name), "tried.html")
            with open(self.path(name), "w") as file:
                file.write(page)
        done = subprocess.run(
            [BROWSER, "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             f"--user-data-dir={self.path('profile')}", "--virtual-time-budget=20000",
             f"--window-size={width},{height}", "--enable-logging=stderr", "--dump-dom", f"file://{self.path(name)}"],
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
