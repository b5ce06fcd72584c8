"""Runs clod and its peers on one bed with one law, and says the same things of each."""

import hashlib
import json
import os
import re
import shutil
import subprocess

DECKS = os.path.dirname(os.path.abspath(__file__))
PEERS = {"liggghts": "liggghts", "lammps": "lmp"}  # Debian package: program


class ProgramError(Exception):
    """A program did not do what it was asked for."""


def missing():
    """Peers, and what starts their ranks, that are not installed."""
    return [name for name in [*PEERS.values(), "mpirun"] if shutil.which(name) is None]


def call(command, environment=None):
    """What a program prints, and the largest memory [kB] of it and its children."""
    started = subprocess.Popen(command, text=True, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                               env=dict(os.environ, **(environment or {})))
    text = started.stdout.read()
    started.stdout.close()
    _, status, usage = os.wait4(started.pid, 0)
    started.returncode = os.waitstatus_to_exitcode(status)
    if started.returncode != 0:
        raise ProgramError(f"{' '.join(command)}: exit status {started.returncode}\n"
                           + text[-2000:])
    return text, usage.ru_maxrss


def clod(program, stem, law, threads, warm, steps, more=()):
    """One run of bench_step; the answer has all that it prints under "clod"."""
    text, _ = call([program, stem + ".csv", stem + ".box", "--law", law, "--threads",
                    str(threads), "--warm", str(warm), "--steps", str(steps), *more])
    said = json.loads(text)
    return {"seconds": said["seconds"], "rate": said["grain_steps_per_s"],
            "coordination": 2.0 * said["contacts_per_grain"], "kinetic_J": said["kinetic_J"],
            "rotational_J": said["rotational_J"], "rss_kB": said["rss_peak_kB"],
            "lists": said["rebuilds"] + said["refreshes"], "clod": said}


def parse(text, grains, steps):
    """Loop time and last state of the bed from what a peer prints (bench/peers/in.*)."""
    times = re.findall(r"^Loop time of (\S+) on \d+ procs? for (\d+) steps", text, re.M)
    builds = re.findall(r"^Neighbor list builds = (\d+)", text, re.M)
    last = re.findall(r"^ *\d+ +(\d+) +(\S+) +(\S+) +(\S+) *$", text, re.M)
    if (len(times) < 2 or len(builds) < 2 or int(times[1][1]) != steps or not last
            or int(last[-1][0]) != grains):
        raise ProgramError("what a peer printed is not what bench/peers/in.* ask for:\n"
                           + text[-2000:])
    seconds = float(times[1][0])
    kinetic, rotational, coordination = map(float, last[-1][1:])
    return {"seconds": seconds, "rate": grains * steps / seconds, "coordination": coordination,
            "kinetic_J": kinetic, "rotational_J": rotational, "lists": int(builds[1])}


def peer(name, stem, law, ranks, warm, steps, grains, variables=()):
    """One run of a peer; law: the end of a file's name in bench/peers."""
    command = [PEERS[name], "-in", os.path.join(DECKS, "in." + name), "-log", "none"]
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks), *command]
    for key, value in [("data", stem + ".data"), ("law", os.path.join(DECKS, f"{name}.{law}")),
                       ("warm", warm), ("steps", steps), *variables]:
        command += ["-var", key, str(value)]
    text, rss = call(command, {"OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                               "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
    return {**parse(text, grains, steps), "rss_kB": rss}


def clod_version(program):
    """What bench_step says; with a digest of the file when no commit says what is in it."""
    said = call([program, "--version"])[0].strip()
    if "-dirty" in said or "(" not in said:
        with open(program, "rb") as file:
            said += f", file {hashlib.sha256(file.read()).hexdigest()[:12]}"
    return said


def version(package):
    """Version of a Debian package, or what can be said."""
    if shutil.which("dpkg-query") is None:
        return f"{package} of unknown version"
    asked = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], text=True,
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return f"{package} {asked.stdout if asked.returncode == 0 else 'of unknown version'}"
