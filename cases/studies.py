"""Runs many cases side by side, for the scripts `run` of studies."""

import concurrent.futures
import os
import shutil
import subprocess
import sys


def run_one(clod, folder, name, case, changes, origin=None):
    """Run a case with keys changed into folder/name, or on from the run folder/origin; what it prints goes to files
    beside. An interrupted run goes on."""
    command = [clod, "run", case, "-o", os.path.join(folder, name), "--threads", "1", "--no-report"]
    for change in changes:
        command += ["--set", change]
    if origin is not None and not os.path.exists(os.path.join(folder, name)):
        command += ["--from", os.path.join(folder, origin)]
    with open(os.path.join(folder, name + ".txt"), "w") as out, \
            open(os.path.join(folder, name + ".err"), "w") as err:
        status = subprocess.run(command, stdout=out, stderr=err, check=False).returncode
    print(f"{name}: exit status {status}", flush=True)
    return status


def is_there(clod):
    """Whether there is such a program; says what to do if not."""
    if shutil.which(clod) is None:
        print(f"there is no program {clod}; build it with make, or name it with --clod", file=sys.stderr)
        return False
    return True


def run_all(clod, folder, jobs, runs):
    """Run {name: (case, changes) or (case, changes, origin)}, so many side by side, on one thread each: bits do not depend on it. Exit status."""
    if not is_there(clod):
        return 2
    os.makedirs(folder, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        statuses = list(pool.map(lambda name: run_one(clod, folder, name, *runs[name]), runs))
    return 1 if any(statuses) else 0
