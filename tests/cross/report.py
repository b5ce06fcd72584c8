"""docs/cross-code.md: what was compared, with which versions, and what came out."""

import subprocess

import forces
import peers
import programs

INTRODUCTION = """# The same grains in other programs

Written by `tools/cross-check`; `make cross` runs it and renews this page.
{clod},
LIGGGHTS {liggghts} and LAMMPS {lammps}
(Debian packages, run as programs on one core) get the same grains, law and step. `tests/cross` has
the grains, laws and decks. The exit status is not 0 when anything below misses.

Lines of the peers' files are those of Debian's source packages of these versions.
"""

FORCES = """
## Forces and torques, grain by grain

The largest difference of any component of any grain after the given number of steps; of forces
over the mean force, of torques over the mean force times the radius. Where definitions differ
(next section), the parameters are such that the definition does not matter: no dash-pots where
grains slide, so much friction that none slides where there are dash-pots, no twist, layers that
slide without turning their grains, or grains so light in their springs that they spin in place.
"""

DIFFERENCES = """
## Where definitions differ

Each number is the largest difference of force and torque, as above, when it is not avoided.
"""

TEXT_ONLY = """
Restitution. LAMMPS' polynomial for `damping tsuji` does not return the restitution that it is asked
for. Asked for 0.5, a Hertz collision returned: {found}.
The comparisons ask clod and LIGGGHTS for what LAMMPS returns.

Source: LAMMPS src/GRANULAR/pair_granular.cpp:990-991

Arms at walls. LIGGGHTS turns a grain at a wall with R - d/2, LAMMPS with R, clod with R - d, the
distance of the wall's surface. Not compared grain by grain: it is d/R of the slip,
1e-3 in the bed below.

Source: LIGGGHTS src/surface_model_default.h:176;
LAMMPS src/GRANULAR/fix_wall_gran.cpp:1236-1243,1512
"""

FAULTS = """
## Faults of the peers

These we hold for faults, not for choices; each can be read at the lines that are named. The decks
of the comparisons above avoid them. Each must be seen: where it is avoided the forces agree, where
it is not they differ. So a peer that is mended misses here.
"""

PULL = """
## A cohesive bed, pressed and pulled apart

{grains} grains fly about in a box of {side:g} x {side:g} mm, no periods. Its lid comes down from {height:g} mm with
{fast} m/s and then {slow} m/s to {low:g} mm, rests for {hold:g} ms, and goes up with {gentle} m/s to {relieved:g} mm
and with {slow} m/s to {top:g} mm. The law is mepa with n = 1: k1 {k_1:g}, k2 {k_2:g}, k_adh {k_adh:g} N/m, friction
{friction}, restitution {restitution}, the same for lid, floor and sides; step {step} s. For LIGGGHTS that is
`edinburgh/stiffness` with fixKc on, limitForce off and atom_modify sort 0 0.0 (see the faults above).
{seeds} packings, the same starting places in both programs, and the tolerance as in the next section: Student's t
times the standard error from the scatter between packings. The laws differ in dash-pots of contacts that slide, in
springs that turn and in arms at walls (above); clod's lid is a plane, that of LIGGGHTS two triangles.
"""

BED = """
## A sheared bed

{grains} grains in a trough, periodic along x: the floor moves along x with {speed} m/s, the side
walls rest. Hertz, friction {friction}, restitution as LAMMPS makes it from {restitution}, step
{step} s; {seeds} seeds, the same starting places in every program; means from {start} s to {end} s.
The tolerance is Student's t (two-sided 0.1 %) times the standard error from the scatter between
seeds: what two sets of {seeds} runs of one program would rarely exceed.
"""


def _row(*cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def _head(*cells):
    return [_row(*cells), "|" + "---|" * len(cells)]


def _answer(good):
    return "yes" if good else "NO"


def header():
    asked = subprocess.run([programs.CLOD, "--version"], text=True, stdout=subprocess.PIPE,
                           check=True)
    return INTRODUCTION.format(clod=asked.stdout.strip(), liggghts=peers.version("liggghts"),
                               lammps=peers.version("lammps"))


def same(rows):
    """rows: (case, result, good)"""
    lines = _head("law and grains", "peer", "grains", "steps", "force", "torque", "tolerance",
                  "pass")
    for case, found, good in rows:
        lines.append(_row(case.name, case.peer, case.grains.count, case.steps,
                          f"{found['force']:.1e}", f"{found['torque']:.1e}",
                          f"{forces.TOLERANCE:.0e}", _answer(good)))
    return FORCES + "\n" + "\n".join(lines) + "\n"


SHOWN = ("law and grains", "peer", "steps", "force", "torque", "mean force, clod [N]", "peer [N]")


def _shown_cells(case, found):
    return (case.name, case.peer, case.steps, f"{found['force']:.1e}", f"{found['torque']:.1e}",
            f"{found['own_force']:.4g}", f"{found['mean_force']:.4g}")


def _about(group):
    return ["", group.why, "", f"Source: {group.where}", ""]


def _shown(groups):
    lines = []
    for group, results in groups:
        lines += _about(group) + _head(*SHOWN)
        lines += [_row(*_shown_cells(case, found)) for case, found in results]
    return "\n".join(lines) + "\n"


def differences(groups, order, good, rebounds):
    """order: difference over that with half the step; rebounds: restitution of each program."""
    found = ", ".join(f"{name} {e:.4f}" for name, e in rebounds.items())
    return (DIFFERENCES + _shown(groups) + TEXT_ONLY.format(found=found)
            + "\nThe first two numbers of this section, one over the other: "
            f"{order:.3f}; expected 2 within 0.1; pass: {_answer(good)}.\n")


def faults(groups):
    lines = []
    for group, results in groups:
        lines += _about(group) + _head(*SHOWN, "asked of the force", "pass")
        for case, found in results:
            asked, good = group.judge(case, found)
            lines.append(_row(*_shown_cells(case, found), asked, _answer(good)))
    return FAULTS + "\n".join(lines) + "\n"


def _means(rows):
    """rows: (peer, quantity, unit, clod, peer's, difference, limit)"""
    lines = _head("quantity", "peer", "clod", "its value", "difference", "tolerance", "pass")
    for peer, quantity, unit, ours, theirs, difference, limit in rows:
        name = quantity if unit == "1" else f"{quantity} [{unit}]"
        lines.append(_row(name, peer, f"{ours:.5g}", f"{theirs:.5g}", f"{difference:.2g}",
                          f"{limit:.2g}", _answer(difference <= limit)))
    return "\n" + "\n".join(lines) + "\n"


def pull(rows, settings):
    """rows as for `bed`"""
    above = sum(ours > theirs for _, _, _, ours, theirs, _, _ in rows)
    return (PULL.format(**settings) + _means(rows) +
            f"\nclod's value is the larger one in {above} of {len(rows)} rows.\n")


def bed(rows, settings):
    """rows: (peer, quantity, unit, clod, peer's, difference, limit)"""
    return BED.format(**settings) + _means(rows)
