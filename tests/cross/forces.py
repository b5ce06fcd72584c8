"""
Part 1: forces and torques of one configuration, grain by grain, and of the same grains some
hundred steps later.

Where the law is the same the difference is rounding. Where a definition differs, either the
parameters are chosen so that the definition does not matter, which the text of a case says, or
the case stands under DIFFERENCES and the number is shown.
"""

import os
import re

import numpy

import arrangement
import laws
import peers
import programs

TOLERANCE = 1e-10  # of the mean force, of the mean force times the radius
FAULT_SEEN = 1e-6  # of the mean force: ten thousand times what rounding is allowed

# Loose: some neighbours touch, some do not. Closed: all touch, so that no new contact, whose
# dash-pot is stronger than friction allows, comes into being.
LOOSE = {"overlap": 0.004, "scatter": 0.01}
CLOSED = {"overlap": 0.03, "scatter": 0.005, "spread": 0.004}
K = 2e3  # N/m, about the Hertz tangent at these overlaps
K_FROZEN = 1e-16  # N/m: grains feel forces, and nothing moves
STEP = 1e-5  # s, 1/100 of a collision


def _dense(speed, spin, bed, seed=1, **more):
    return arrangement.dense(seed, speed=speed, spin=spin, **bed, **more)


def _equal(speed, spin):
    """A closed bed of equal grains, and the mass of one."""
    grains = _dense(speed, spin, {**CLOSED, "spread": 0.0})
    return grains, grains.mass()


class Case:
    """One comparison: what, with whom, grains, law, steps, and what the peer is given instead."""

    def __init__(self, name, peer, grains, law, steps=1, dt=STEP, spin=1.0, torque=1.0):
        self.name, self.peer, self.grains, self.law = name, peer, grains, law
        self.steps, self.dt = steps, dt
        self.spin = spin  # factor of the peer's spins
        self.torque = torque  # factor of the peer's torques before they are compared

    def run(self, folder):
        """Differences of force and torque, relative; and the mean forces [N]."""
        here = os.path.join(folder, re.sub("[^a-z0-9]+", "-", f"{self.peer} {self.name}"))
        ours = programs.clod(os.path.join(here, "clod"), self.grains, self.law, self.steps,
                             self.dt)
        theirs = peers.peer(self.peer, os.path.join(here, self.peer),
                            self.grains.with_spin(self.spin), self.law, self.steps, self.dt)
        theirs.torque *= self.torque
        force = numpy.linalg.norm(theirs.force, axis=1).mean()
        lever = force * arrangement.RADIUS
        return {"force": abs(ours.force - theirs.force).max() / force,
                "torque": abs(ours.torque - theirs.torque).max() / lever,
                "mean_force": force,
                "own_force": numpy.linalg.norm(ours.force, axis=1).mean()}


def same_liggghts():
    """Laws that clod and LIGGGHTS share."""
    peer = "liggghts"
    sheet = arrangement.sheet(3, speed=0.0, spin=50.0, **CLOSED)
    frozen = {"steps": 300, "dt": 4e-7}
    equal, mass = _equal(0.01, 5.0)
    yield Case("hertz, sliding friction", peer, _dense(0.1, 50.0, LOOSE), laws.hertz(0.2))
    yield Case("hertz, dash-pots", peer, _dense(0.01, 5.0, CLOSED), laws.hertz(10.0, 0.5))
    yield Case("hertz, dash-pots, no friction", peer, _dense(0.1, 0.0, LOOSE),
               laws.hertz(0.0, 0.5, tangential_damping=False), steps=300)
    yield Case("hooke, sliding friction", peer, _dense(0.1, 50.0, LOOSE), laws.hooke(K, 0.2))
    yield Case("hooke, dash-pots", peer, equal, laws.hooke(K, 10.0, 0.5, mass))
    yield Case("hooke, friction of grains that spin in place", peer, sheet,
               laws.hooke(K_FROZEN, 0.2), **frozen)
    yield Case("rolling epsd, dash-pots", peer, _equal(0.01, 0.0)[0],
               laws.hooke(K, 10.0, 0.5, mass, rolling="epsd", mu_r=1.0))
    for rolling in ("cdt", "epsd2"):
        yield Case(f"rolling {rolling} of grains that spin in place", peer, sheet,
                   laws.hooke(K_FROZEN, 0.2, rolling=rolling, mu_r=0.1), **frozen)
    yield Case("mepa n = 1, sliding friction", peer, _dense(0.1, 50.0, LOOSE),
               laws.mepa(1, K, 5 * K, 2 * K, 0.2))
    yield Case("mepa n = 1, dash-pots", peer, _dense(0.01, 5.0, CLOSED),
               laws.mepa(1, K, 5 * K, 2 * K, 10.0, 0.5))
    yield Case("mepa n = 1, all branches, no friction", peer, _dense(0.1, 0.0, LOOSE),
               laws.mepa(1, K, 5 * K, 2 * K, 0.0), steps=300)
    yield Case("mepa n = 3/2, sliding friction", peer, _dense(0.1, 50.0, LOOSE),
               laws.mepa(1.5, 5e5, 25e5, 10e5, 0.2))
    yield Case("eepa n = 1, constant pull, sliding friction", peer, _dense(0.1, 50.0, LOOSE),
               laws.eepa(1, K, 5 * K, 2 * K, 0.05, 0.2))
    yield Case("eepa n = 1, constant pull, all branches, no friction", peer,
               _dense(0.1, 0.0, LOOSE), laws.eepa(1, K, 5 * K, 2 * K, 0.05, 0.0), steps=300)
    yield Case("eepa n = 3/2, constant pull, sliding friction", peer, _dense(0.1, 50.0, LOOSE),
               laws.eepa(1.5, 5e5, 25e5, 10e5, 0.05, 0.2))
    yield Case("luding, sliding friction", peer, _dense(0.1, 50.0, LOOSE),
               laws.luding(K, 5 * K, 2 * K, 0.01, 0.2))
    yield Case("luding, dash-pots", peer, _dense(0.01, 5.0, CLOSED),
               laws.luding(K, 5 * K, 2 * K, 0.01, 10.0, 0.5))
    yield Case("luding, all branches, no friction", peer, _dense(0.1, 0.0, LOOSE),
               laws.luding(K, 5 * K, 2 * K, 0.01, 0.0), steps=300)


def same_lammps():
    """Laws that clod and LAMMPS share."""
    peer = "lammps"
    slow = arrangement.layers(0.01, (0.12, 0.07))
    square = arrangement.square(4, 0.01, 50.0)
    arm = 1.0 - 0.01 / 2.0  # (R - d/2)/R, d = 0.01 R
    yield Case("hertz, sliding friction", peer, _dense(0.1, 0.0, LOOSE), laws.hertz(0.2))
    yield Case("hertz, dash-pots", peer, _dense(0.01, 0.0, CLOSED), laws.hertz(10.0, 0.5),
               dt=1e-15)
    yield Case("hertz, dash-pots, no friction", peer, _dense(0.1, 0.0, LOOSE),
               laws.hertz(0.0, 0.5, tangential_damping=False), steps=300)
    yield Case("hertz, layers that slide and swing back", peer, slow, laws.hertz(0.5), steps=300)
    yield Case("hertz, layers with dash-pots", peer, slow, laws.hertz(10.0, 0.5), steps=300)
    yield Case("hooke, sliding friction", peer, _dense(0.1, 0.0, LOOSE), laws.hooke(K, 0.2))
    yield Case("hooke, layers that slide and swing back", peer, slow, laws.hooke(K, 0.5),
               steps=300)
    yield Case("hooke, layers with dash-pots", peer, slow, laws.hooke(K, 10.0, 0.5), steps=300)
    yield Case("rolling epsd2 of grains that spin in place", peer, square,
               laws.hooke(K_FROZEN, 0.2, rolling="epsd2", mu_r=0.1, stretch=1.0 / arm),
               steps=300, dt=4e-7, spin=arm)
    yield Case("gran/hooke/history, grains that spin in place", peer, square,
               laws.gran("hooke", K_FROZEN, 0.8 * K_FROZEN, 0.2, laws.hooke(K_FROZEN, 0.2)),
               steps=300, dt=4e-7, spin=arm, torque=arm)


class Difference:
    """A definition that differs: its number, and why."""

    def __init__(self, why, where, *cases):
        self.why, self.where, self.cases = why, where, cases


class Fault(Difference):
    """A fault of a peer: cases that avoid it and must agree, and cases that must show it."""

    def __init__(self, why, where, agree, show):
        super().__init__(why, where, *agree, *show)
        self.show = show

    def judge(self, case, found):
        """What is asked of the force, and whether it is so: a peer that is mended is noticed."""
        if case in self.show:
            return f"> {FAULT_SEEN:.0e}: seen", found["force"] > FAULT_SEEN
        return f"<= {TOLERANCE:.0e}: agrees", found["force"] <= TOLERANCE


SRC_HISTORY = "LIGGGHTS src/tangential_model_history.h"
SRC_EDINBURGH = "LIGGGHTS src/normal_model_edinburgh_stiffness.h"
SRC_GRANULAR = "LAMMPS src/GRANULAR/pair_granular.cpp"


def _model(law, old, new):
    return {**law, "model": law["model"].replace(old, new)}


def differences():
    """Where definitions differ, with cases that show how much."""
    sheet = arrangement.sheet(3, speed=0.05, spin=25.0, **CLOSED)
    slow = arrangement.layers(0.01, (0.12, 0.07))
    closed = _dense(0.05, 25.0, CLOSED)
    yield Difference(
        "Spring in the tangent plane. LIGGGHTS projects it without restoring its length, so it "
        "wears down as the pair turns; in first order of the step: half the step, half the "
        "difference.", SRC_HISTORY + ":155-158",
        Case("hooke, sheet", "liggghts", sheet, laws.hooke(K, 0.2), 100),
        Case("hooke, sheet, half the step", "liggghts", sheet, laws.hooke(K, 0.2), 200,
             0.5 * STEP))
    yield Difference(
        "Twist. Neither peer turns the spring with the pair about the normal "
        "(docs/theory/tangential.md, step 1). No such contacts in a sheet.",
        SRC_HISTORY + ":155-158; " + SRC_GRANULAR + ":450-472",
        Case("hooke, bed", "liggghts", closed, laws.hooke(K, 0.2), 30))
    yield Difference(
        "Spring when the stiffness changes. LIGGGHTS, and LAMMPS with `mindlin`, keep its length "
        "even when k_t grows, which makes energy (ADR 0004). LAMMPS' `mindlin_rescale/force` is "
        "clod's rule, and agrees above.", SRC_HISTORY + ":166-171; " + SRC_GRANULAR + ":431-446",
        Case("hertz, sheet", "liggghts", sheet, laws.hertz(0.2), 30),
        Case("hertz, layers, mindlin", "lammps", slow, laws.hertz(0.5, tangential="mindlin"),
             300))
    yield Difference(
        "Dash-pots and sliding. clod and LIGGGHTS hold the spring alone to the limit first. clod then "
        "adds the dash-pot and cuts the sum (ADR 0025). LIGGGHTS adds the dash-pot only where the "
        "spring is below the limit, and cuts nothing more: there friction can exceed mu N, and a "
        "contact that slides has no dash-pot. LAMMPS cuts both together, but leaves -F/k_t less the "
        "dash-pot in the spring. Both peers take mu times the normal force with its dash-pot, clod "
        "without.",
        SRC_HISTORY + ":175,178,215-217; " + SRC_GRANULAR + ":419-421,518",
        Case("hertz, dash-pots and sliding", "liggghts", _dense(0.1, 50.0, LOOSE),
             laws.hertz(0.2, 0.5)),
        Case("hertz, layers, dash-pots and sliding", "lammps", slow, laws.hertz(0.2, 0.5), 100))
    yield Difference(
        "Arm of the spins. LAMMPS lets the surfaces move with R w, clod and LIGGGHTS with (R - "
        "d/2) w; `gran/*/history` takes R for the torque too.",
        SRC_GRANULAR + ":395-397; pair_gran_hertz_history.cpp:160-162,221-226",
        Case("hertz, sliding and spins", "lammps", _dense(0.1, 50.0, LOOSE), laws.hertz(0.2)),
        Case("gran/hertz/history, no spins", "lammps", _dense(0.1, 0.0, LOOSE),
             laws.gran("hertz", 4.0 / 3.0 * laws.YOUNG_STAR, 8.0 * laws.SHEAR_STAR, 0.2,
                       laws.hertz(0.2))))
    yield Difference(
        "Dash-pots that pull. `luding` and `edinburgh` of LIGGGHTS take them away from contacts "
        "without adhesion (limitForce, on by default), LAMMPS only when asked (limit_damping), "
        "clod never: they are what returns the restitution asked for.",
        "LIGGGHTS src/normal_model_luding.h:78,191-193; " + SRC_GRANULAR + ":377",
        *[Case(f"luding, dry, dash-pots, limitForce {switch}", "liggghts",
               _dense(0.1, 0.0, LOOSE),
               _model(laws.luding(K, 5 * K, 0.0, 0.01, 0.0, 0.5), "history",
                      f"history tangential_damping off limitForce {switch}"))
          for switch in ("off", "on")])
    yield Difference(
        "Rolling at the start. `epsd` and `epsd2` of LIGGGHTS add dt w k_r already to the forces "
        "of step 0, where no time has passed; the grains keep the kick.",
        "LIGGGHTS src/rolling_model_epsd2.h:195-199",
        Case("hooke, rolling epsd2", "liggghts", _dense(0.1, 50.0, LOOSE),
             laws.hooke(K, 0.2, rolling="epsd2", mu_r=10.0)))
    yield Difference(
        "Damping of `edinburgh/stiffness`. gamma = 2 z sqrt(m* k1) whatever n; for n = 3/2 k1 is "
        "in N/m^1.5, and the units of gamma are wrong.", SRC_EDINBURGH + ":195-196",
        Case("mepa n = 3/2, dash-pots", "liggghts", _dense(0.01, 0.0, CLOSED),
             laws.mepa(1.5, 5e5, 25e5, 10e5, 0.0, 0.5)))


def rebounds(folder):
    """Restitution of a Hertz collision at 0.1 m/s in every program, each asked for 0.5."""
    asked = 0.5
    law = laws.hertz(0.0, asked)  # LAMMPS is asked for 0.5 here, the others for what it makes of it
    law["clod"] = law["clod"].replace(programs.number(law["restitution"]),
                                      programs.number(asked))
    law["properties"]["coefficientRestitution peratomtypepair 1"] = asked
    pair, steps, dt = arrangement.couple(0.0, 0.1), 3000, 2e-6
    here = os.path.join(folder, "rebound")
    ends = {"clod": programs.clod(os.path.join(here, "clod"), pair, law, steps, dt)}
    for name in peers.PROGRAMS:
        ends[name] = peers.peer(name, os.path.join(here, name), pair, law, steps, dt)
    return {name: (end.velocity[1, 0] - end.velocity[0, 0]) / 0.1 for name, end in ends.items()}


def faults():
    """What we hold for faults of the peers, with cases that show them."""
    loose = _dense(0.1, 0.0, LOOSE)
    k_1 = K / numpy.sqrt(0.01 * arrangement.RADIUS)
    couple = arrangement.couple(0.0, 0.1)
    sticks = [Case(f"mepa n = 3/2, two grains stick, step {s}", "liggghts", couple,
                   laws.mepa(1.5, k_1, 5 * k_1, 0.75 * k_1, 0.0), s) for s in (80, 100, 150, 200)]
    yield Fault(
        "Reset on the adhesive branch: d_max becomes (k2 + k_adh)/(k2 - k1) d, which is right for "
        "n = 1; the power 1/n is missing. With n = 3/2 the stored d_max is too large, the k2 line "
        "through it stays below the adhesive branch, and a contact that was once pulled never "
        "pushes again: it pulls the harder the deeper it is pressed. Below, two grains meet with "
        "0.1 m/s and stick; n = 1, and n = 3/2 before the first pull, are the controls.",
        SRC_EDINBURGH + ":286-287; src/normal_model_edinburgh.h:305-306",
        agree=[Case("mepa n = 1, two grains stick, step 100", "liggghts", couple,
                    laws.mepa(1, K, 5 * K, 0.75 * K, 0.0), 100), sticks[0]],
        show=sticks[1:])
    sticky = laws.mepa(1, K, 5 * K, 2 * K, 0.0)
    yield Fault(
        "Adhesion that is switched off: with fixKc on, `const double k_adh` hides the variable of "
        "the function, which stays 0, and limitForce, on by default, then takes every pull for an "
        "artefact of a dry contact. The decks here say limitForce off; below it is left on.",
        SRC_EDINBURGH + ":205,260,296; src/normal_model_edinburgh.h:224,279",
        agree=[Case("mepa n = 1, limitForce off", "liggghts", loose, sticky)],
        show=[Case("mepa n = 1, limitForce on", "liggghts", loose,
                   _model(sticky, " limitForce off", ""))])
    keeps = {"luding": laws.luding(K, 5 * K, 2 * K, 0.01, 0.0), "mepa n = 1": sticky}.items()
    yield Fault(
        "History of contacts that open: surfacesClose, which clears it, is called only where "
        "r < contact_distance_factor (Ri + Rj), and the factor is 1 by default, so never. A "
        "contact that closes again before the neighbour list is made anew has its old d_max and "
        "spring. The decks here say contact_distance_factor 1.1; below it is left out.",
        "LIGGGHTS src/pair_gran_base.h:414; src/neighbor.cpp:122",
        agree=[Case(f"{name}, history cleared", "liggghts", loose, law, 300)
               for name, law in keeps],
        show=[Case(f"{name}, history not cleared", "liggghts", loose, {**law, "clear": False}, 300)
              for name, law in keeps])
    turning, drifting = (arrangement.dumbbell(0.02, 0.3, drift) for drift in (0.0, 0.8))
    yield Fault(
        "Memory of pairs that change their order: `edinburgh` and `edinburgh/stiffness` register "
        "deltaMax as a quantity whose sign changes with the order of the two grains. When a list "
        "is made anew and finds a pair the other way round, deltaMax is below zero, the next step "
        "takes the overlap for it, and the contact is virgin: at the same overlap it pushes with "
        "k1 d where it pulled, which makes energy. Grains change their order when they are sorted "
        "in memory (every 1000 steps by default), when they cross a period, and when they go from "
        "one MPI process to another. The decks here say atom_modify sort 0 0.0 and run on one "
        "process; where all is periodic no pair that holds a memory crosses in the steps that are "
        "compared, as the agreement shows. So no comparison here was touched, nor the speeds of "
        "bench/results/peers.md, where no list is made anew. Below, two grains that stick turn about each other; left to itself the pair "
        "comes apart within 16 000 steps though nothing pulls at it. In the last row it also "
        "drifts across the period.",
        SRC_EDINBURGH + ":76-79,209-214; src/normal_model_edinburgh.h:79-82,228-233",
        agree=[Case("mepa n = 1, two grains turn, not sorted", "liggghts", turning, sticky, 8000),
               Case("mepa n = 1, two grains turn and drift, before the period", "liggghts",
                    drifting, sticky, 3000)],
        show=[Case("mepa n = 1, two grains turn, sorted", "liggghts", turning,
                   {**sticky, "sort": ""}, 8000),
              Case("mepa n = 1, two grains turn and drift, behind the period", "liggghts",
                   drifting, sticky, 4000)])
