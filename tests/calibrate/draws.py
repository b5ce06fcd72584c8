"""cases/lab-to-outlet/laboratory/outlets as a module, and the pages that show what it finds."""

import importlib.machinery
import importlib.util
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

SCRIPT = clod.source("cases/lab-to-outlet/laboratory/outlets")


def load():
    """The script; without a trace of it beside the case."""
    sys.dont_write_bytecode = True
    loader = importlib.machinery.SourceFileLoader("outlets", SCRIPT)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("outlets", loader))
    loader.exec_module(module)
    return module


def text(page):
    with open(clod.source(page), encoding="utf-8") as file:
        return file.read()


STUDY = text("cases/lab-to-outlet/README.md")
PAGE = text("docs/howto/from-lab-report-to-outlet.md")
