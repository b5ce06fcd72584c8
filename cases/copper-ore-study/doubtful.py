"""How many tests of each setting have shear points that a laboratory would not use, from the table of all tests."""

import math

import loci
import records
import settings

SIGMA_P = {"ore5": 54.8, "ore8": 38.7}  # kPa
LAST = 0.8  # of sigma_p: the point with the largest normal stress
FAR = 0.1  # of sigma_p: farther right of the steady-state circle clod warns


def touch_of(phi_lin, c, sigma_p, tau_p):
    """Normal stress [kPa] where the steady-state circle touches the yield locus (docs/theory/yield-locus.md): the smaller circle
    through (sigma_p, tau_p) that touches the line of slope tan(phi_lin [deg]) and intercept c [kPa], or where the
    preshear point lies above the line, its parallel through that point."""
    slope = math.tan(math.radians(phi_lin))
    line = c + slope * sigma_p
    if tau_p > line:
        return sigma_p
    middle = sigma_p + slope * line - math.sqrt((1 + slope ** 2) * (line ** 2 - tau_p ** 2))
    radius = (c + slope * middle) / math.sqrt(1 + slope ** 2)
    return middle - radius * slope / math.sqrt(1 + slope ** 2)


def is_far_below(phi_lin, c, sigma_p, tau_p):
    """Whether the preshear point lies so far below the yield locus that clod warns of it (docs/theory/yield-locus.md)."""
    angle = math.radians(phi_lin)
    return tau_p < min(0.75, 0.9 * math.cos(angle)) * (c + math.tan(angle) * sigma_p)


def of_setting(tests, sigma_p):
    """(tests whose last point is far right, tests whose line is above tau_p there, tests whose preshear lies far below
    it, how fast tau_p of each still rose [kPa/mm], or None where one does not tell it)."""
    far = sum(LAST * sigma_p - touch_of(test["phi_lin"], test["c"], sigma_p, test["tau_p"]) > FAR * sigma_p for test in tests)
    above = sum(test["c"] + math.tan(math.radians(test["phi_lin"])) * LAST * sigma_p > test["tau_p"] for test in tests)
    below = sum(is_far_below(test["phi_lin"], test["c"], sigma_p, test["tau_p"]) for test in tests)
    rising = [test["rising"] for test in tests]
    return far, above, below, None if None in rising else rising


def print_table(clod, folder, kept):
    rows = records.read(kept) | records.of_folder(clod, folder)
    print("| setting | ore | packings | point at 80 % far right of the circle | line above tau_p at 80 % "
          "| preshear far below the line | tau_p still rising [kPa/mm] |")
    print("|---" * 7 + "|")
    for choice in ["", *settings.CHOICES]:
        for ore in settings.CASES:
            names = [settings.name_of(choice, seed, ore) for seed in settings.SEEDS]
            tests = [rows[name] for name in names if name in rows]
            if tests:
                far, above, below, rising = of_setting(tests, SIGMA_P[ore])
                told = "not kept" if rising is None else loci.told(rising, "+", 2)
                print(f"| {choice or 'the case'} | {ore[3:]} % | {len(tests)} | {far} | {above} | {below} | {told} |")
