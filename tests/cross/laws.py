"""
One contact law in three languages: the text of a clod case, the model and properties of
LIGGGHTS, the pair style of LAMMPS. Symbols as in docs/theory.
"""

import math

from programs import number

YOUNG, POISSON = 1e7, 0.3  # Pa, -; LIGGGHTS takes nothing softer than 5e6 Pa
YOUNG_STAR = YOUNG / (2.0 * (1.0 - POISSON**2))
SHEAR_STAR = YOUNG / (4.0 * (2.0 - POISSON) * (1.0 + POISSON))


def ratio(restitution):
    """Damping ratio z of a restitution."""
    l = math.log(restitution)
    return -l / math.hypot(l, math.pi)


def restitution(z):
    """Restitution of a damping ratio."""
    return math.exp(-math.pi * z / math.sqrt(1.0 - z * z))


def tsuji(e):
    """LAMMPS' polynomial for Tsuji's alpha (src/GRANULAR/pair_granular.cpp, lines 990-992)."""
    return (1.2728 - 4.2783 * e + 11.087 * e**2 - 22.348 * e**3 + 27.467 * e**4
            - 18.022 * e**5 + 4.8218 * e**6)


def _clod(law, e, friction, rolling="", **keys):
    text = {"law": law, "restitution": number(e), "friction": number(friction),
            "coulomb": "force", **keys}
    return ", ".join(f"{key}: {value}" for key, value in text.items()) + rolling


def _liggghts(e, friction, **more):
    pair = " peratomtypepair 1"
    names = {"coefficientRestitution": e, "coefficientFriction": friction, **more}
    return {(key if " " in key else key + pair): value for key, value in names.items()}


def _granular(e, normal, tangential, friction, gamma_t, more=""):
    """e: None without dash-pots."""
    damping = "velocity" if e is None else "tsuji"
    first, last = normal
    return (f"pair_style granular\npair_coeff * * {first} {number(0.0 if e is None else e)} "
            f"{last} tangential {tangential} {number(gamma_t)} {number(friction)} {more} "
            f"damping {damping}")


def hertz(friction, e=None, tangential="mindlin_rescale/force", tangential_damping=True):
    """
    Hertz, Mindlin's k_t, sliding friction. e: what LAMMPS is asked for, None without dash-pots;
    the others are asked for what LAMMPS' polynomial makes of it, alpha = sqrt(5) z.
    """
    back = 1.0 if e is None else restitution(tsuji(e) / math.sqrt(5.0))
    gamma_t = math.sqrt(4.0 * SHEAR_STAR / YOUNG_STAR) if tangential_damping else 0.0
    switch = "" if tangential_damping else " tangential_damping off"
    return {"material": (YOUNG, POISSON), "clod": _clod("hertz", back, friction),
            "properties": _liggghts(back, friction),
            "model": "hertz tangential history" + switch,
            "pair": _granular(e, (f"hertz/material {number(YOUNG)}", number(POISSON)),
                              tangential + " NULL", friction, gamma_t),
            "restitution": back}




def hooke(stiffness, friction, e=None, mass=1.0, rolling=None, mu_r=0.0, zeta=0.8, stretch=1.0):
    """
    Linear springs. mass: of every grain, since the dash-pots of LIGGGHTS go with the mass alone.
    e as for `hertz`, with gamma = 2 z sqrt(m* k), so alpha = 2 z. stretch: factor by which the
    rolling angles of LAMMPS are too large (its spins are made smaller, see forces.py).
    """
    z = 0.0 if e is None else 0.5 * tsuji(e)
    back = 1.0 if e is None else restitution(z)
    k_t = zeta * stiffness
    text, properties, sds = "", {}, ""
    if rolling is not None:
        text = f", rolling: {rolling}, rolling_friction: {number(mu_r)}"
        properties = {"coefficientRollingFriction": mu_r}
        if rolling == "epsd":
            properties["coefficientRollingViscousDamping"] = 0.3  # clod's default as well
        sds = f"rolling sds {number(k_t * stretch)} 0.0 {number(mu_r)}"
    per_mass = math.sqrt(2.0 / mass)  # 1/sqrt(m*)
    properties.update({"kn": stiffness, "kt": k_t, "gamman": 2.0 * z * math.sqrt(stiffness)
                       * per_mass, "gammat": 2.0 * z * math.sqrt(k_t) * per_mass})
    model = f"hooke/stiffness tangential history{' rolling_friction ' + rolling if rolling else ''}"
    keys = {"k1": number(stiffness) + " N/m", "tangential_ratio": number(zeta)}
    return {"material": (YOUNG, POISSON), "clod": _clod("hooke", back, friction, text, **keys),
            "properties": _liggghts(back, friction, **properties), "model": model,
            "pair": _granular(e, (f"hooke {number(stiffness)}", ""),
                              f"linear_history {number(k_t)}", friction, math.sqrt(zeta), sds),
            "restitution": back}


def mepa(n, k1, k2, k_adh, friction, e=1.0):
    """MEPA and `edinburgh/stiffness` with fixKc on; e < 1 for n = 1 only (docs/cross-code.md)."""
    unit = f" N/m^{n:g}"
    keys = {"exponent": number(n), "k1": number(k1) + unit, "k2": number(k2) + unit,
            "k_adh": number(k_adh) + unit, "tangential": "tangent" if n == 1 else "literal"}
    properties = {"LoadingStiffness": k1, "UnloadingStiffness": k2 / k1,
                  "coefficientAdhesionStiffness": k_adh / k1, "pullOffForce": 0.0,
                  "overlapExponent scalar": n, "adhesionExponent scalar": n,
                  "surfaceEnergy": 1.0}  # not used with fixKc
    return {"material": (YOUNG, POISSON), "clod": _clod("mepa", e, friction, **keys),
            "properties": _liggghts(e, friction, **properties),
            "model": "edinburgh/stiffness tangential history fixKc on limitForce off"}


def eepa(n, k1, k2, k_adh, pull_off, friction, e=1.0):
    """EEPA with a constant pull [N]: mepa with f0, which LIGGGHTS wants below zero."""
    law = mepa(n, k1, k2, k_adh, friction, e)
    text = f"law: eepa, pull_off_force: {number(pull_off)} N"
    law["clod"] = law["clod"].replace("law: mepa", text)
    law["properties"]["pullOffForce peratomtypepair 1"] = -pull_off
    return law


def luding(k1, k2, k_adh, depth, friction, e=1.0):
    """Luding's law in clod and LIGGGHTS."""
    keys = {"exponent": "1", "k1": number(k1) + " N/m", "k2": number(k2) + " N/m",
            "k_adh": number(k_adh) + " N/m", "plasticity_depth": number(depth)}
    properties = {"LoadingStiffness": k1, "UnloadingStiffness": k2 / k1,
                  "coefficientAdhesionStiffness": k_adh / k1,
                  "coefficientPlasticityDepth": depth, "pullOffForce": 0.0}
    return {"material": (YOUNG, POISSON), "clod": _clod("luding", e, friction, **keys),
            "properties": _liggghts(e, friction, **properties),
            "model": "luding tangential history"}


def gran(style, k_n, k_t, friction, clod_law):
    """LAMMPS' older pair styles, without dash-pots; everything else as in `clod_law`."""
    return {**clod_law, "pair": f"pair_style gran/{style}/history {number(k_n)} {number(k_t)} "
                                f"0.0 0.0 {number(friction)} 0\npair_coeff * *"}
