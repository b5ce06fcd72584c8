"""LIGGGHTS and LAMMPS: their data file, which is the same for both, their decks and dumps."""

import os
import shutil
import subprocess

import numpy

from programs import State, call, number

PROGRAMS = {"liggghts": "liggghts", "lammps": "lmp"}
COLUMNS = "id fx fy fz tqx tqy tqz x y z vx vy vz omegax omegay omegaz"


def missing():
    """Peers that are not installed."""
    return [name for name, program in PROGRAMS.items() if shutil.which(program) is None]


def version(package):
    """Version of a Debian package, or what can be said."""
    if shutil.which("dpkg-query") is None:
        return "of unknown version"
    asked = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], text=True,
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return asked.stdout if asked.returncode == 0 else "of unknown version"


def write_data(path, grains):
    with open(path, "w") as file:
        file.write(f"grains\n\n{grains.count} atoms\n1 atom types\n\n")
        for axis, length in zip("xyz", grains.box):
            file.write(f"0.0 {number(length)} {axis}lo {axis}hi\n")
        file.write("\nAtoms\n\n")
        for k in range(grains.count):
            row = [2.0 * grains.radius[k], grains.density, *grains.place[k]]
            file.write(" ".join([str(k + 1), "1", *map(number, row)]) + "\n")
        file.write("\nVelocities\n\n")
        for k in range(grains.count):
            row = [*grains.velocity[k], *grains.spin[k]]
            file.write(" ".join([str(k + 1), *map(number, row)]) + "\n")


def read_frames(path):
    """Frames of a dump: step and state."""
    with open(path) as file:
        for part in file.read().split("ITEM: TIMESTEP\n")[1:]:
            head, rows = part.split("ITEM: ATOMS ")
            table = [line.split() for line in rows.splitlines()[1:]]
            yield int(head.split()[0]), State(numpy.array(table, float))


def _liggghts(law):
    """What LIGGGHTS says in its own way: grains, neighbours, law, digits of a dump."""
    young, poisson = law["material"]
    properties = {"youngsModulus peratomtype": young, "poissonsRatio peratomtype": poisson,
                  **law["properties"]}
    model = [f"fix m{k} all property/global {key} {number(value)}"
             for k, (key, value) in enumerate(properties.items())]
    model += [f"pair_style gran model {law['model']}", "pair_coeff * *"]
    clears = law.get("clear", True)  # docs/cross-code.md, faults
    return {"grains": "atom_style granular\ncommunicate single vel yes",
            "neighbours": " contact_distance_factor 1.1" if clears else "",
            "law": "\n".join(model), "digits": '"%d' + 15 * " %.17g" + '"'}


def _lammps(law):
    """The same of LAMMPS."""
    return {"grains": "atom_style sphere\ncomm_modify vel yes", "neighbours": "",
            "law": law["pair"], "digits": "float %.17g"}


def run(name, folder, grains, law, stages, dt, frame, more=()):
    """
    Run a peer; data, deck and state.dump are in the folder.

    stages: lines and steps of each run. frame: steps between two frames of the dump. more: lines
    of gravity, walls and so on.
    """
    own = {"liggghts": _liggghts, "lammps": _lammps}[name](law)
    sort = law.get("sort", "sort 0 0.0")  # docs/cross-code.md, faults
    boundary = " ".join("p" if p else "f" for p in grains.periodic)
    deck = f"""units si
{own["grains"]}
atom_modify map array {sort}
boundary {boundary}
newton off
read_data data
neighbor {number(0.1 * grains.radius.max())} bin
neigh_modify delay 0 every 1 check yes{own["neighbours"]}
{own["law"]}
timestep {number(dt)}
fix integrate all nve/sphere
{chr(10).join(more)}
dump state all custom {frame} state.dump {COLUMNS}
dump_modify state sort id format {own["digits"]}
{chr(10).join(line for lines, count in stages for line in (*lines, f"run {count}"))}
"""
    os.makedirs(folder, exist_ok=True)
    write_data(os.path.join(folder, "data"), grains)
    with open(os.path.join(folder, "in." + name), "w") as file:
        file.write(deck)
    # not `-screen none`: LIGGGHTS prints to it when it reads a mesh, and crashes
    call([PROGRAMS[name], "-in", "in." + name, "-log", "log." + name, "-screen", "screen." + name],
         folder)


def peer(name, folder, grains, law, steps, dt):
    """State of the grains after some steps of a peer."""
    run(name, folder, grains, law, [([], steps)], dt, frame=steps)
    return list(read_frames(os.path.join(folder, "state.dump")))[-1][1]
