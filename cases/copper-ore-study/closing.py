"""Angles of the study's packings beside those of the paper and the laboratory, and what chance would do."""

import math

import loci
import records
import settings

PAPER = {"ore5": 44.6, "ore8": 44.8}  # deg, the paper's DEM
LABORATORY = {"ore5": 47.3, "ore8": 46.7}  # deg, Jenike tester
NEAR = 2.0  # deg
READINGS = ("phi_lin", "phi_e", "phi_sf", "highest points")  # columns of records
COUNTED = READINGS[:3]  # the highest points follow phi_lin: no reading of their own where chance is told
AGAIN = {(settings.BEYOND, "phi_sf")}  # of the preshears of settings.BEFORE, which are counted there


def student(x, freedom):
    """Distribution function of Student's t (Abramowitz & Stegun 26.7.3 and 26.7.4)."""
    angle = math.atan(x / math.sqrt(freedom))
    term, total = (1.0, 0.0) if freedom % 2 == 0 else (math.cos(angle), 0.0)
    for k in range(freedom % 2, freedom - 1, 2):  # of cos^k
        total += term
        term *= (k + 1) / (k + 2) * math.cos(angle) ** 2
    inside = math.sin(angle) * total
    return 0.5 + 0.5 * inside if freedom % 2 == 0 else 0.5 + (angle + inside) / math.pi


def share_near(low, high, target, near=NEAR):
    """Share of the range [low, high] that lies within `near` of a target."""
    inside = min(high, target + near) - max(low, target - near)
    return max(inside, 0.0) / (high - low) if high > low else float(abs(low - target) <= near)


def any_of(share, count):
    """Probability that at least one of `count` independent readings is near, each with the probability `share`."""
    return 1.0 - (1.0 - share) ** count


def chance_near(value, error, freedom, target, near=NEAR):
    """Probability that a mean with this standard error, known with so many degrees of freedom, lies within `near` of a
    target."""
    if math.isnan(error):
        return math.nan
    if error == 0.0:
        return float(abs(value - target) <= near)
    return student((target + near - value) / error, freedom) - student((target - near - value) / error, freedom)


def packings_of(clod, folder, kept):
    """{(choice, ore): {reading: angles [deg] of its tests, None where one has none}}, of all tests that have ended in
    the folder or are kept. A reading that no test has is left out."""
    rows = kept | records.of_folder(clod, folder)
    found = {}
    for choice in ["", *settings.CHOICES]:
        for ore in settings.CASES:
            names = [settings.name_of(choice, seed, ore) for seed in settings.SEEDS]
            tests = [rows[name] for name in names if name in rows]
            if tests:
                angles = {reading: [test[reading] for test in tests] for reading in READINGS}
                found[choice, ore] = {reading: all_of for reading, all_of in angles.items()
                                      if any(angle is not None for angle in all_of)}
    return found


def is_whole(angles):
    """Whether every packing has the reading; a mean of the others would leave out the largest angles, where sigma_2 is tension."""
    return None not in angles


def probability(value):
    return "-" if math.isnan(value) else f"{value:.3f}" if value >= 0.001 else "below 0.001"


def rows_of(found):
    """Cells of each reading of each setting; the last but one tells whether it is near."""
    for (choice, ore), readings in found.items():
        for reading, angles in readings.items():
            if not is_whole(angles):
                known = [angle for angle in angles if angle is not None]
                yield [choice or "the case", f"{ore[3:]} %", reading, f"{len(known)} of {len(angles)}", *["-"] * 5]
                continue
            middle, error = loci.mean(angles), loci.error(angles)
            near = abs(middle - PAPER[ore]) <= NEAR
            yield [
                choice or "the case", f"{ore[3:]} %", reading, str(len(angles)), loci.told(angles),
                f"{middle - PAPER[ore]:+.1f}", f"{middle - LABORATORY[ore]:+.1f}", "yes" if near else "no",
                probability(chance_near(middle, error, len(angles) - 1, PAPER[ore]))]


def print_rows(rows):
    print("| setting | ore | reading | packings | angle [deg] | - paper | - laboratory | near the paper | "
          "probability that its mean is |")
    print("|---" * 9 + "|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


def print_near(found):
    """Those that are near, then all."""
    rows = list(rows_of(found))
    near = [row for row in rows if row[7] == "yes"]
    print(f"Near the paper's angle: {len(near)} of {len(rows)}\n")
    print_rows(near)
    print("\nAll:\n")
    print_rows(rows)


def chance(found, readings):
    """How likely readings that mean nothing are near: independent, uniform over the span of the means of both ores.
    (lowest, highest mean [deg], {ore: (means, share of the span near the paper's angle, probability that one is near)})."""
    means = {ore: {(choice, reading): loci.mean(angles)
                   for (choice, of), known in found.items() if of == ore
                   for reading, angles in known.items()
                   if reading in readings and (choice, reading) not in AGAIN and is_whole(angles)} for ore in settings.CASES}
    values = [angle for angles in means.values() for angle in angles.values()]
    low, high = min(values), max(values)
    shares = {ore: share_near(low, high, PAPER[ore]) for ore in means}
    return low, high, {ore: (angles, shares[ore], any_of(shares[ore], len(angles))) for ore, angles in means.items()}


def print_chance(found):
    """The chance of all readings that are counted, and of those but phi_lin, which is near in no setting."""
    print("\n| readings | span of all means [deg] | ore | N | nearest to the paper's [deg] | p: share of the span near it "
          "| 1 - (1 - p)^N |")
    print("|---" * 7 + "|")
    for title, readings in (("all", COUNTED), ("phi_e, phi_sf", COUNTED[1:])):
        low, high, ores = chance(found, readings)
        for ore, (angles, share, likely) in ores.items():
            if angles:
                nearest = min(angles, key=lambda key, a=angles, target=PAPER[ore]: abs(a[key] - target))
                print(f"| {title} | {low:.1f} to {high:.1f} | {ore[3:]} % | {len(angles)} | {angles[nearest]:.1f}, "
                      f"{nearest[1]} of {nearest[0] or 'the case'} | {share:.3f} | {likely:.3f} |")
    _, _, ores = chance(found, COUNTED)
    both = [key for key in ores["ore5"][0] if key in ores["ore8"][0]]
    near = [f"{key[1]} of {key[0] or 'the case'}" for key in both
            if all(abs(ores[ore][0][key] - PAPER[ore]) <= NEAR for ore in ores)]
    by_chance = any_of(math.prod(share for _, share, _ in ores.values()), len(both))
    print(f"\nNear both angles with the same reading of the same setting: {', '.join(near) or 'none'} of {len(both)}; at "
          f"least one by chance in {by_chance:.3f} of cases.")


def print_table(clod, folder, kept):
    """Which reading of which setting is within NEAR of the paper's angle."""
    found = packings_of(clod, folder, kept)
    if found:
        print_near(found)
        print_chance(found)
