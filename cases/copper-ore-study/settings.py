"""The ring shear tests of the study: their names, and the keys of the cases that each of them changes."""

CASES = {"ore5": "cases/copper-ore-5/case.yaml", "ore8": "cases/copper-ore-8/case.yaml"}
SEEDS = list(range(1, 13))
STIFFNESS = {"ore5": (4.75e8, 2.37e9, 3.56e8), "ore8": (4.75e8, 2.37e9, 5.93e8)}  # k1, k2, k_adh of Table 1, N/m^1.5
SPEED = {"ore5": 40.0, "ore8": 36.0}  # mm/s
WAYS = (5, 10, 20, 40)  # of preshear, mm, in the names of tests: it ends 0.73 (8 % ore: 0.78) mm before
PACKINGS = 6  # of each test of a set


def sizes(factor):
    """Grains of another size in the same cell: 8 mean diameters across the annulus over factor."""
    radii = {"mean": 3.175, "sd": 0.16, "min": 2.85, "max": 3.49}
    return [f"ring_shear.radius.{key}={factor * radius:g} mm" for key, radius in radii.items()]


def softer(ore, factor):
    return [f"contacts.default.{key}={value / factor:.4g} N/m^1.5"
            for key, value in zip(("k1", "k2", "k_adh"), STIFFNESS[ore])]


def twice_as_fast(ore):
    """In half the time. It moves no number of the 5 % ore beyond its error, but phi_sf of the 8 % ore by 1 deg
    (docs/results/faster-test.md): compare with BEFORE, not with the case."""
    return [f"ring_shear.speed={2 * SPEED[ore]:g} mm/s"]


def over(way):
    return f"preshear over {way - 0.7:g} mm"


def preshear(ore, way):
    """Preshear to the last block of 1 mm from full speed on that fits into so many mm, steady or not."""
    end = way - 1 + (SPEED[ore] / 1000) ** 2 / (2 * 3.0) * 1000
    return [f"ring_shear.preshear_min={end:.2f} mm", f"ring_shear.preshear_max={end:.2f} mm",
            "ring_shear.block_displacement=1 mm", "ring_shear.steady_blocks=4"]


LITERAL = ["contacts.default.tangential=literal", "time.safety=0.2"]
NO_ROLLING = ["contacts.default.rolling_friction=0"]
COULOMB = {limit: [f"contacts.default.coulomb={limit}"] for limit in ("force", "adhesive")}
LONG = ["ring_shear.preshear_max=120 mm"]
BEYOND = "10 mm beyond the peak"  # only the points differ: its tests go on from the preshear of those of BEFORE
BEFORE = "speed x 2"
LITERAL_FAST = "literal, speed x 2"
BASES = {BEYOND: BEFORE, LITERAL_FAST: BEFORE}  # what a choice is compared with, where it is not the case
FAR = ["ring_shear.beyond_peak=10 mm", "ring_shear.shear_max=25 mm"]


def choices(ore):
    """What the paper leaves open (docs/theory/damping.md, tangential.md, rolling.md) and numbers, changed one at a time;
    and readings of eq. (6) with other rolling resistance and other ends of preshear."""
    return {
        "coulomb: force": COULOMB["force"],
        "coulomb: adhesive": COULOMB["adhesive"],
        "preshear to 25 mm": ["ring_shear.preshear_max=25 mm"],
        "preshear to 120 mm": LONG,
        "adhesive, preshear to 120 mm": COULOMB["adhesive"] + LONG,
        "dry": ["contacts.default.k_adh=0 N/m^1.5"],
        "no rolling resistance": NO_ROLLING,
        "force, no rolling resistance": COULOMB["force"] + NO_ROLLING,
        "adhesive, no rolling resistance": COULOMB["adhesive"] + NO_ROLLING,
        "rolling friction 0.1": ["contacts.default.rolling_friction=0.1"],
        "rolling epsd": ["contacts.default.rolling=epsd"],
        "rolling cdt": ["contacts.default.rolling=cdt"],
        "zeta 2/7": ["contacts.default.tangential_ratio=0.285714"],
        # seventeen times the steps at the automatic step: compare with "step x 2"
        "tangential literal": LITERAL,
        LITERAL_FAST: LITERAL + twice_as_fast(ore),
        "restitution 0.1": ["contacts.default.restitution=0.1"],
        "restitution 0.8": ["contacts.default.restitution=0.8"],
        "filled at full adhesion": ["ring_shear.fill_adhesion=1"],
        "stiffness / 3": softer(ore, 3),
        "stiffness / 10": softer(ore, 10),
        "soften 10": ["contacts.soften=10"],
        "soften 100": ["contacts.soften=100"],
        "grains x 1.5": sizes(1.5),
        "grains x 0.75": sizes(0.75),
        "bars 10": ["ring_shear.bar_count=10"],
        "bars 40": ["ring_shear.bar_count=40"],
        "speed x 2": twice_as_fast(ore),
        "speed / 3": [f"ring_shear.speed={SPEED[ore] / 3:.4g} mm/s"],
        "speed / 10": [f"ring_shear.speed={SPEED[ore] / 10:.4g} mm/s"],
        # over those of the usual step, time.safety 0.1
        "step x 2": ["time.safety=0.2"],
        "step x 3": ["time.safety=0.3"],
        "step / 3": ["time.safety=0.03333"],
        "1e-7": ["time={step: 1e-7 s}"],
        BEYOND: FAR + twice_as_fast(ore),
    } | {over(way): preshear(ore, way) for way in WAYS}


CHOICES = list(choices("ore5"))
MATRIX = ["", "coulomb: force", "coulomb: adhesive", "no rolling resistance", "force, no rolling resistance",
          "adhesive, no rolling resistance", LITERAL_FAST]
SHORT = {"coulomb: force": "force", "coulomb: adhesive": "adhesive", "preshear to 25 mm": "25-mm",
         "preshear to 120 mm": "long", LITERAL_FAST: "tangential-literal-speed-x-2",
         "adhesive, preshear to 120 mm": "adhesive-long",
         "force, no rolling resistance": "force-no-rolling-resistance",
         "adhesive, no rolling resistance": "adhesive-no-rolling-resistance"} | {
             over(way): f"preshear-over-{way}-mm" for way in WAYS}


def name_of(choice, seed=1, ore="ore5"):
    """Name of the test of a choice; "" is the case as it is."""
    if choice == "":
        return f"{ore}-seed{seed}"
    name = ore + "-" + SHORT.get(choice, choice.replace(" / ", "-").replace("/", "-")
                                 .replace(" ", "-"))
    return name if seed == 1 else f"{name}-seed{seed}"


def tests_of(ore, seed):
    """All tests of an ore with one packing."""
    seeds = [] if seed == 1 else [f"seed={seed}"]
    return {name_of(choice, seed, ore): (CASES[ore], changes + seeds)
            for choice, changes in ({"": []} | choices(ore)).items()}


TESTS = {}
for ORE in CASES:
    for SEED in SEEDS:
        TESTS |= tests_of(ORE, SEED)


def set_of(listed):
    """Names of the tests of choices, of both ores and PACKINGS packings."""
    return [name_of(choice, seed, ore) for choice in listed for ore in CASES
            for seed in SEEDS[:PACKINGS]]


SETS = {"matrix": set_of(MATRIX), "ways": set_of(map(over, WAYS)),
        "beyond": set_of([BEYOND])}
ORIGINS = {name_of(BEYOND, seed, ore): name_of(BEFORE, seed, ore) for ore in CASES for seed in SEEDS}


def groups(found):
    """{title: names} of the tests of one choice and ore that `found` tells to be there, where there are at least two."""
    titled = {}
    for ore in CASES:
        for choice in ["", *CHOICES]:
            names = [name for name in (name_of(choice, seed, ore) for seed in SEEDS) if found(name)]
            if len(names) > 1:
                titled[f"{ore[3:]} %{choice and ', '}{choice}, {len(names)} packings"] = names
    return titled
