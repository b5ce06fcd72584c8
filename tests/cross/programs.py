"""
Runs clod and its peers on the same grains, with one core and the same step, and reads what every
grain feels at the end. Nothing is linked: the peers are the programs of the Debian packages
(peers.py), clod is the one in the environment variable CLOD_BINARY.
"""

import os
import subprocess

import h5py
import numpy

CLOD = os.environ.get("CLOD_BINARY", "clod")
MINUTES = 20  # only ends what hangs
HEAD = 512  # bytes of text in front of the HDF5 data of a checkpoint


class ProgramError(Exception):
    """A program did not do what it was asked for."""


def number(value):
    """A number with all its digits."""
    return repr(float(value))


def vector(values, unit):
    return "[" + ", ".join(f"{number(v)} {unit}" for v in values) + "]"


def call(command, folder):
    """Run a program to its end on one thread."""
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    done = subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=60 * MINUTES, env=environment)
    if done.returncode != 0:
        raise ProgramError(f"{' '.join(command)} in {folder}: exit status {done.returncode}\n"
                           + done.stdout[-2000:])


class State:
    """What the grains feel and do, sorted by id: force, torque, place, velocity, spin."""

    def __init__(self, table):
        order = numpy.argsort(table[:, 0])
        columns = table[order, 1:].reshape(len(order), 5, 3)
        self.force, self.torque, self.place, self.velocity, self.spin = (
            columns[:, k].copy() for k in range(5))


# ---- clod

def write_grains(path, grains):
    with open(path, "w") as file:
        file.write("id,x [m],y [m],z [m],radius [m],vx [m/s],vy [m/s],vz [m/s],"
                   "wx [rad/s],wy [rad/s],wz [rad/s]\n")
        for k in range(grains.count):
            row = [*grains.place[k], grains.radius[k], *grains.velocity[k], *grains.spin[k]]
            file.write(",".join([str(k + 1), *map(number, row)]) + "\n")


def clod_case(grains, law, steps, dt, gravity=(0.0, 0.0, 0.0), walls="", output="", stages=None):
    """
    Text of a case; law["clod"] stands under contacts.default. output: more keys of it. stages:
    their list, in place of one of `steps`.
    """
    young, poisson = law["material"]
    periodic = ", ".join("true" if p else "false" for p in grains.periodic)
    return f"""title: Comparison with other programs
materials:
  grain: {{density: {number(grains.density)} kg/m3, youngs_modulus: {number(young)} Pa,
          poissons_ratio: {number(poisson)}}}
contacts:
  default: {{{law["clod"]}}}
gravity: {vector(gravity, "m/s2")}
domain: {{min: [0, 0, 0], max: {vector(grains.box, "m")}, periodic: [{periodic}]}}
grains: [{{material: grain, file: grains.csv}}]
{walls}
stages: {stages or f"[{{name: all, duration: {number(steps * dt)} s}}]"}
time: {{step: {number(dt)} s}}
output: {{checkpoint_interval: 1000 s{output}}}
"""


def clod_run(folder, text, grains):
    """Run a case whose grains stand in grains.csv; results are in out."""
    os.makedirs(folder, exist_ok=True)
    write_grains(os.path.join(folder, "grains.csv"), grains)
    with open(os.path.join(folder, "case.yaml"), "w") as file:
        file.write(text)
    call([CLOD, "run", "case.yaml", "-o", "out", "--threads", "1", "--fresh", "--no-report"], folder)


def _sequence(path):
    """Number of a checkpoint in its run."""
    with open(path, "rb") as file:
        lines = file.read(HEAD).decode().splitlines()
    return int(next(line for line in lines if line.startswith("sequence ")).split()[1])


def clod(folder, grains, law, steps, dt):
    """State of the grains after some steps of clod."""
    interval = f", series_interval: {number(steps * dt)} s"
    clod_run(folder, clod_case(grains, law, steps, dt, output=interval), grains)
    paths = [os.path.join(folder, "out", f"restart_{letter}.h5") for letter in "ab"]
    with h5py.File(max(filter(os.path.exists, paths), key=_sequence), "r") as file:
        if file["state/step"][0] != steps:
            raise ProgramError(f"clod made {file['state/step'][0]} steps instead of {steps}")
        names = ("force", "torque", "position", "velocity", "angular_velocity")
        columns = [file[f"grains/{name}"][:].reshape(-1, 3) for name in names]
        return State(numpy.hstack([file["grains/id"][:].reshape(-1, 1), *columns]))
