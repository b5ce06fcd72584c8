"""Programs under mpirun. More ranks than processors are as good: they take turns."""

import os
import subprocess
import sys

import clod

MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "--mca",
          "mpi_yield_when_idle", "1", "--mca", "btl", "self,vader", "-n"]
PYTHON = "/usr/bin/python3"  # cffi, NumPy and mpi4py are packages of Debian's own Python


def run(ranks, *command, **more):
    """Run a command on so many ranks, 0: without mpirun, to its end; stdout and stderr as text."""
    before = [*MPIRUN, str(ranks)] if ranks > 0 else []
    return subprocess.run([*before, *clod.without_page(command)], text=True, timeout=600, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, **more)


def start(ranks, *command):
    """Start a command on so many ranks and return at once."""
    return subprocess.Popen([*MPIRUN, str(ranks), *clod.without_page(command)], text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE)


def python(ranks, *arguments):
    """Run Python, where the package clod of this build and tests/python can be imported."""
    here = os.path.dirname(os.path.abspath(__file__))
    path = os.pathsep.join([os.environ["CLOD_PYTHON"], os.path.join(here, "..", "python")])
    return run(ranks, PYTHON, "-B", *arguments, env={**os.environ, "PYTHONPATH": path})


def need(module):
    """End this test as skipped where a module is not installed."""
    found = subprocess.run([PYTHON, "-c", f"import {module}"], stderr=subprocess.PIPE)
    if found.returncode != 0:
        print(f"skipped: {module} is not installed (tools/packages.txt)")
        sys.exit(77)
