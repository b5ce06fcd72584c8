"""Pages in a headless browser, for the tests that look at what their scripts do.

One browser for all pages of a class, driven by the Chrome DevTools Protocol over a pipe: it reads commands from its
file 3 and writes answers and events into its file 4, each of them JSON with a zero byte behind it.
"""

import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from pages import clod

BROWSER = next(filter(None, map(shutil.which, ("chromium-headless-shell", "chromium", "google-chrome"))), None)
# done when the page's own scripts are through, or have failed
THROUGH = """new Promise(done => {
  const look = () => document.documentElement.dataset.errors === undefined ? setTimeout(look, 10) : done();
  look();
})"""
FIGURES = '[...document.querySelectorAll("figure")].map(figure => figure.outerHTML).join("\\n")'
# a note of the driver's about speed, no error of the page
IGNORED = "GL Driver Message"
SECONDS = 600  # only end what hangs


class Browser:
    """A headless browser with one page."""

    def __init__(self, profile):
        theirs, mine = [[fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in os.pipe()] for _ in range(2)]

        def join():
            os.dup2(theirs[0], 3)
            os.dup2(mine[1], 4)

        self.process = subprocess.Popen(
            [BROWSER, "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             "--disable-gpu-compositing", "--hide-scrollbars", f"--user-data-dir={profile}", "--remote-debugging-pipe"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=join, close_fds=False)
        os.close(theirs[0])
        os.close(mine[1])
        self.out, self.back = theirs[1], mine[0]
        self.unread, self.number, self.session, self.events = b"", 0, None, []
        target = self.do("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.do("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.do(domain + ".enable")

    def close(self):
        for end in (self.out, self.back):
            os.close(end)
        self.process.terminate()
        self.process.wait()

    def message(self):
        """The next answer or event."""
        end = time.monotonic() + SECONDS
        while b"\0" not in self.unread:
            if not select.select([self.back], [], [], max(0.0, end - time.monotonic()))[0]:
                raise TimeoutError("the browser says nothing")
            piece = os.read(self.back, 1 << 20)
            if piece == b"":
                raise EOFError("the browser has ended")
            self.unread += piece
        text, _, self.unread = self.unread.partition(b"\0")
        return json.loads(text)

    def do(self, method, **parameters):
        """Result of a command; events that come meanwhile are kept."""
        self.number += 1
        command = {"id": self.number, "method": method, "params": parameters}
        if self.session is not None:
            command["sessionId"] = self.session
        left = json.dumps(command).encode() + b"\0"
        while left:
            left = left[os.write(self.out, left):]
        while True:
            told = self.message()
            if told.get("id") == self.number:
                assert "error" not in told, (method, told["error"])
                return told["result"]
            self.events.append(told)

    def value(self, expression):
        """What an expression of the page's scripts is."""
        told = self.do("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in told, told["exceptionDetails"]
        return told["result"].get("value")

    def open(self, path, width, height):
        """Load a page in a window of this size."""
        self.do("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.events = []
        self.do("Page.navigate", url=f"file://{path}")
        while not any(event["method"] == "Page.loadEventFired" for event in self.events):
            self.events.append(self.message())
        if not self.said():  # else the scripts may be none, which never come through
            self.value(THROUGH)

    def said(self):
        """What the page's scripts have written on the console, and their errors."""
        heard = ("Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded")
        return [text for text in (json.dumps(event["params"]) for event in self.events if event["method"] in heard)
                if IGNORED not in text]


@clod.unittest.skipIf(BROWSER is None, "no browser: Debian's chromium-headless-shell shows the pages")
class BrowserCase(clod.Case):

    @classmethod
    def setUpClass(cls):
        profile = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, profile, ignore_errors=True)
        cls.browser = Browser(profile)
        cls.addClassCleanup(cls.browser.close)

    def show(self, name, width=1200, height=900, then=None):
        """The page after its scripts ran: attributes of its root element, and its figures. `then`: the
        body of a function of a user's; what it returns is the attribute `tried`."""
        self.browser.open(self.path(name), width, height)
        self.assertEqual(self.browser.said(), [])
        self.assertEqual(self.browser.value("document.documentElement.clientWidth"), width)
        seen = self.browser.value("({...document.documentElement.dataset})")
        if then is not None:
            seen["tried"] = self.browser.value("JSON.stringify((() => {%s})())" % then)
        self.assertEqual(json.loads(seen["errors"]), [])
        self.assertEqual(seen.get("ready"), "yes")
        self.assertLessEqual(int(seen["overflow"]), 0, "wider than the window")
        figures = self.browser.value(FIGURES)
        self.assertEqual(self.browser.said(), [])
        return seen, figures

    def print(self, name, pdf):
        """Print a page as its style says."""
        self.browser.open(self.path(name), 1200, 900)
        told = self.browser.do("Page.printToPDF", printBackground=True, preferCSSPageSize=True, displayHeaderFooter=False)
        with open(pdf, "wb") as file:
            file.write(base64.b64decode(told["data"]))

    def need_scripts(self, done):
        if "built without the scripts" in done.stderr:
            self.skipTest("no scripts: clod was built without npm or a network")
