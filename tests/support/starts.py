"""Random cases that begin well, badly, or just about, and what clod check and clod run say of
them. A case follows from a seed and its number.

Each has 100 steps in all, so that a run of it is its first 100 steps; a shear or uniaxial test,
whose length nobody chooses, is stopped by a signal once it has made as many.
"""

import json
import math
import os
import random
import re
import shutil
import signal
import time

import clod
from start_numbers import about, often, si, vector
from start_walls import Walls

STEPS = 100
MARGINS = (10.0, 10.0, 10.0, 10.0, 3.0, 1.0, 1.0, 0.3, 0.0, 0.0, 0.0, -0.4)  # radii
TESTERS = ("ring_shear", "jenike", "uniaxial")


class Start(Walls):
    """One random case; `case` is its tree, `files` are grain files by name."""

    def __init__(self, seed, number):
        self.dice = random.Random(f"{seed}-{number}")
        self.files = {}
        self.tester = self.dice.choice(TESTERS) if often(self.dice, 0.12) else None
        if self.tester is None:
            self.radius = about(self.dice, 2e-6, 2e-2)
            self.case = {"materials": self.materials(),
                         "contacts": {"default": self.law()}}
            self.add_grains()
            self.add_walls()
            self.add_rest()

    # ---- free runs

    def materials(self):
        dice = self.dice
        modulus = about(dice, 1e7, 1e11) if often(dice, 0.7) else about(dice, 1e3, 1e6)
        solid = {"density": si(about(dice, 500, 8000), "kg/m3"),
                 "youngs_modulus": si(modulus, "Pa"),
                 "poissons_ratio": round(dice.uniform(0.1, 0.45), 3)}
        return {"ore": solid, "side": dict(solid)}

    def law(self):
        dice = self.dice
        kind = dice.choice(("hertz", "hooke", "mepa", "luding", "eepa"))
        law = {"law": kind, "restitution": round(dice.uniform(0.05, 0.98), 3),
               "friction": round(dice.uniform(0.0, 1.0), 3)}
        if kind != "hertz":
            exponent = 1.5 if kind in ("mepa", "eepa") else 1
            unit = "N/m" if exponent == 1 else "N/m^1.5"
            # so stiff that a stress of E presses an overlap of the radius
            stiff = about(dice, 1e4, 1e9) * self.radius ** (2 - exponent)
            ratio = dice.uniform(1.0, 8.0)
            law["k1"] = si(stiff, unit)
            if kind != "hooke":
                law["k2"] = si(stiff * ratio, unit)
            if kind in ("mepa", "luding") and often(dice, 0.5):
                law["k_adh"] = si(stiff * dice.uniform(0.0, 0.9), unit)
            if kind == "luding":
                law["plasticity_depth"] = round(dice.uniform(0.02, 0.5), 3)
            if kind in ("mepa", "eepa"):
                law["exponent"] = exponent
            if kind == "eepa":
                self.add_pull(law, stiff)
        self.add_friction(law)
        return law

    def add_pull(self, law, stiff):
        """The constant pull of eepa, of up to a tenth of the force that presses an overlap of
        the radius, and a surface energy as large or k_adh."""
        dice = self.dice
        pull = stiff * self.radius ** 1.5 * about(dice, 1e-7, 0.1)
        if often(dice, 0.4):
            law["pull_off_force"] = si(pull, "N")
        if often(dice, 0.3):
            law["surface_energy"] = si(pull / self.radius, "J/m2")
        elif often(dice, 0.3):
            law["k_adh"] = si(stiff * dice.uniform(0.0, 0.9), "N/m^1.5")

    def add_friction(self, law):
        """How a contact slips and rolls."""
        dice = self.dice
        if often(dice, 0.3):
            law["coulomb"] = dice.choice(("adhesive", "force", "paper"))
        if law["law"] in ("mepa", "eepa") and often(dice, 0.2):
            law["tangential"] = "literal"
        elif law["law"] != "hertz" and often(dice, 0.2):
            law["tangential_ratio"] = si(about(dice, 0.05, 10.0), "").strip()
        if often(dice, 0.4):
            law["rolling"] = dice.choice(("cdt", "epsd", "epsd2"))
            law["rolling_friction"] = dice.choice((0.0, 0.01, 0.3, 3.0))
            if law["rolling"] == "epsd" and often(dice, 0.5):
                law["rolling_damping"] = round(dice.uniform(0.0, 2.0), 3)

    def add_grains(self):
        dice = self.dice
        self.count = dice.choice((1, 2, 10, 40, 120))
        self.side = self.radius * dice.uniform(6.0, 24.0)
        self.bottom = 0.0 if often(dice, 0.7) else about(dice, 1e-3, 30.0)
        self.height = self.side * dice.uniform(1.0, 3.0)
        if often(dice, 0.25):
            self.case["grains"] = [self.grain_file()]
        else:
            self.case["seed"] = dice.randrange(1000)
            self.case["grains"] = [self.group()]
            if often(dice, 0.2):
                self.case["grains"].append(self.group())

    def group(self):
        dice = self.dice
        spread = dice.choice((1.0, 1.2, 2.0))
        low, high = self.radius / spread, self.radius
        group = {"material": "ore", "region": self.region()}
        if often(dice, 0.2):
            group["sizes"] = {"sieve": [{"size": si(2 * low, "m"), "passing": "0 %"},
                                        {"size": si(2.2 * high, "m"), "passing": "100 %"}]}
        else:
            group["radius"] = {"distribution": "uniform", "min": si(low, "m"),
                               "max": si(high, "m")}
        solid = 4 / 3 * math.pi * high ** 3 * self.count
        density = float(self.case["materials"]["ore"]["density"].split()[0])
        amount = dice.random()
        if amount < 0.7:
            group["count"] = self.count
        elif amount < 0.85:
            group["mass"] = si(density * solid * about(dice, 1e-3, 1.0), "kg")
        elif amount < 0.97:
            group["fill_height"] = si(min(self.height, solid / self.side ** 2), "m")
        else:
            group["count"] = 10 ** 9  # more than memory holds
        if often(dice, 0.4):
            speed = about(dice, 1e-3, 300.0)
            group["velocity"] = vector([dice.uniform(-1, 1) * speed for _ in range(3)], "m/s")
        return group

    def box(self):
        return {"box": {"min": vector((0, 0, self.bottom), "m"),
                        "max": vector((self.side, self.side, self.bottom + self.height), "m")}}

    def region(self):
        """The box in which all is, or an upright ring or cylinder in it."""
        dice = self.dice
        if often(dice, 0.7):
            return self.box()
        outer = self.side * dice.choice((0.3, 0.49, 0.49, 0.49, 0.7))
        ring = {"center": vector((self.side / 2, self.side / 2, self.bottom), "m"),
                "outer_radius": si(outer, "m"), "height": si(self.height, "m")}
        if often(dice, 0.5):
            ring["inner_radius"] = si(outer * dice.choice((0.2, 0.4, 0.9)), "m")
        return {"annulus": ring}

    def grain_file(self):
        """Grains on a lattice that may overlap a little, coincide, or lie outside."""
        dice = self.dice
        pitch = self.radius * dice.choice((1.5, 1.7, 1.78, 1.82, 1.9, 2.0, 2.1))
        wide = max(1, round(self.count ** (1 / 3)))
        rows = []
        for k in range(self.count):
            cell = (k % wide, k // wide % wide, k // wide ** 2)
            place = [self.radius + pitch * c for c in cell]
            place[2] += self.bottom
            rows.append(place)
        if often(dice, 0.2):
            rows.append(list(rows[-1]))
        if often(dice, 0.2):
            rows[0][dice.randrange(3)] -= self.radius * dice.choice((1.5, 3.0, 10.0))
        speed = 0.0 if often(dice, 0.6) else about(dice, 1e-3, 100.0)
        spin = 0.0 if often(dice, 0.7) else about(dice, 1e-1, 1e5)
        lines = ["x [m],y [m],z [m],radius [m],vz [m/s],wx [rad/s]"]
        lines += [",".join(f"{v:.9g}" for v in (*row, self.radius, -speed, spin))
                  for row in rows]
        self.files["grains.csv"] = "\n".join(lines) + "\n"
        self.side = self.radius * 2 + pitch * wide
        return {"material": "ore", "file": "grains.csv"}

    def add_rest(self):
        dice = self.dice
        if often(dice, 0.3):
            self.case["gravity"] = dice.choice(([0, 0, 0], [0, 0, "-1000 m/s2"], [9.81, 0, 0],
                                                [0, 0, "-9.81 m/s2"]))
            self.case["gravity"] = vector([float(str(g).split()[0])
                                           for g in self.case["gravity"]], "m/s2")
        if often(dice, 0.5):
            self.add_domain()
        if often(dice, 0.25):
            self.case["time"] = {"step": si(about(dice, 1e-9, 1e-3) * self.radius / 1e-3, "s")}
        if often(dice, 0.25):
            self.case.setdefault("time", {})["overlap_limit"] = self.overlap_limit()
        if often(dice, 0.2):
            self.case["output"] = {"series_interval": si(1e-9, "s")}
        if often(dice, 0.25):
            self.case.setdefault("output", {})["energy"] = True
        self.case["stages"] = [{"name": "one", "duration": "1e-12 s"},
                               {"name": "two", "duration": "1e-12 s"}]
        for stage in self.case["stages"]:
            if often(dice, 0.25):
                stage["adhesion"] = dice.choice(("0 %", "10 %", "100 %"))
        self.add_changes(self.case["stages"][1])

    def overlap_limit(self):
        return si(100 * min(0.9, about(self.dice, 1e-3, 3.0)), "%")

    def add_domain(self):
        """Around the region, a little too small, or with a period that is too short."""
        dice = self.dice
        low = [0.0, 0.0, self.bottom]
        high = [self.side, self.side, self.bottom + self.height]
        periodic = [often(dice, 0.4) for _ in range(3)]
        for a in range(3):
            if not periodic[a] or often(dice, 0.3):
                low[a] -= dice.choice(MARGINS) * self.radius
                high[a] += dice.choice(MARGINS) * self.radius
            elif often(dice, 0.25):
                high[a] = low[a] + self.radius * dice.uniform(3.0, 6.0)
                for group in self.case["grains"]:
                    if "region" in group:
                        group["region"] = self.box()
                        group["region"]["box"]["max"][a] = si(high[a], "m")
        self.case["domain"] = {"min": vector(low, "m"), "max": vector(high, "m"),
                               "periodic": periodic}

    def write(self, folder):
        for name, text in self.files.items():
            with open(os.path.join(folder, name), "w") as file:
                file.write(text)
        path = os.path.join(folder, "case.yaml")
        with open(path, "w") as file:
            json.dump(self.case, file, indent=1)
        return path

    # ---- testers: a small test with some keys changed

    def changes(self):
        dice = self.dice
        scale = dice.choice((1.0, 1.0, 1.0, 0.4, 3e-4))
        radius = 2.5e-3 * scale
        name = self.tester
        changes = [f"{name}.radius={{mean: {radius} m, sd: {0.05 * radius} m, "
                   f"min: {0.9 * radius} m, max: {1.1 * radius} m}}",
                   f"{name}.grain_count={dice.choice((1, 20, 350, 350, 'auto'))}"]
        if often(dice, 0.3):
            changes.append(f"gravity={dice.choice(('[0, 0, 0 m/s2]', '[0, 0, -500 m/s2]'))}")
        if often(dice, 0.3):
            changes.append(f"time.step={about(dice, 1e-8, 1e-3) * scale:.3g} s")
        if often(dice, 0.3):
            stiff = about(dice, 1e4, 1e8)
            changes += [f"contacts.default.k1={stiff:.4g} N/m^1.5",
                        f"contacts.default.k2={4 * stiff:.4g} N/m^1.5",
                        f"contacts.default.k_adh={0.2 * stiff:.4g} N/m^1.5"]
        if often(dice, 0.25):
            changes += [f"contacts.default.rolling={dice.choice(('cdt', 'epsd', 'epsd2'))}",
                        f"contacts.default.rolling_friction={dice.uniform(0.0, 1.0):.3g}"]
        if often(dice, 0.25):
            changes.append(f"contacts.default.coulomb={dice.choice(('force', 'paper'))}")
        if often(dice, 0.2):
            changes.append(f"time.overlap_limit={self.overlap_limit()}")
        if often(dice, 0.2):
            changes.append("output.energy=true")
        if name != "uniaxial" and often(dice, 0.2):
            changes.append(f"{name}.seeds=2")
        return changes


def with_changes(changes):
    return [word for change in changes for word in ("--set", change)]


def last_step(text):
    """The step in a message; a run that could not be set up has none: 0."""
    found = re.search(r"step (\d+)", text)
    return int(found.group(1)) if found else 0


def run_free(start, folder):
    """(whether the first 100 steps go well, what was said)."""
    path = start.write(folder)
    out = os.path.join(folder, "probe")
    probe = clod.run("run", path, "-o", out, "-t", "1")
    if probe.returncode == 0:
        with open(os.path.join(out, "summary.json")) as file:
            step = json.load(file)["dt_s"]
        first = start.dice.choice((1, STEPS // 2, STEPS - 1))
        for stage, steps in zip(start.case["stages"], (first, STEPS - first)):
            stage["duration"] = f"{steps * step:.17g} s"
        start.write(folder)
    done = clod.run("run", path, "-o", os.path.join(folder, "out"), "-t", "1")
    return done.returncode == 0, done.stderr


def run_tester(start, folder, case, changes):
    """The same for a test: asked to stop, and to go on until it has made 100 steps."""
    out = os.path.join(folder, "out")
    arguments = ("run", case, "-o", out, "-t", "1", *with_changes(changes))
    for wait in (0.3, 0.6, 2.0, 10.0, 60.0):
        process = clod.start(*arguments)
        clod.wait_until(lambda: process.poll() is not None or any(
            event["event"] == "start" for event in clod.log(out)))
        time.sleep(wait)
        if process.poll() is None:
            process.send_signal(signal.SIGTERM)
        _, said = process.communicate(timeout=600)
        if process.returncode != 143 or last_step(said) >= STEPS:
            break
    good = process.returncode in (0, 143) or last_step(said) > STEPS
    return good, said


def compare(seed, number):
    """(check is content, run goes well, the two texts, the case) of one random case."""
    start = Start(seed, number)
    folder = clod.make_folder()
    try:
        if start.tester is None:
            changes = []
            good, said = run_free(start, folder)
            case = os.path.join(folder, "case.yaml")
            shown = json.dumps(start.case)
        else:
            case = clod.source(f"tests/cli/{start.tester}.yaml")
            changes = start.changes()
            good, said = run_tester(start, folder, case, changes)
            shown = f"{case} {changes}"
        check = clod.run("check", case, "-t", "1", "-o", os.path.join(folder, "out"),
                         *with_changes(changes), timeout=120)
        return check.returncode == 0, good, check.stderr, said, shown
    finally:
        shutil.rmtree(folder)


def differences(seed, numbers):
    """Texts of all cases in which check and run do not agree, and how many went well."""
    wrong = []
    well = 0
    for number in numbers:
        content, good, check, run, shown = compare(seed, number)
        well += good
        if content != good:
            wrong.append(f"case {number}: check {'passes' if content else 'refuses'}, run "
                         f"{'goes well' if good else 'fails'}\n  check: {check}\n  run: {run}\n"
                         f"  {shown}")
    return wrong, well
