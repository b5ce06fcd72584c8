"""Figures of `rising`, by gnuplot as those of the verification (tools/plot-verification)."""
import os
import subprocess

import inside
import numpy
import rising_told

SHOWN = [0, 5, 10, 20, 38]  # mm
HISTOGRAM = numpy.geomspace(0.1, 100.0, 31)  # N
# Of Okabe and Ito, which colour-blind people tell apart.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#999999"]


def draw_curves(path, labels, curves, *more):
    """Curves [(title, style, x, y)] with gnuplot into an SVG."""
    blocks, parts = [], []
    for k, (title, style, x, y) in enumerate(curves):
        rows = "\n".join(f"{a:.9g} {b:.9g}" for a, b in zip(x, y) if not (numpy.isnan(a) or numpy.isnan(b)))
        blocks.append(f"$c{k} << END\n{rows}\nEND")
        parts.append(f'$c{k} using 1:2 with {style} title "{title}"')
    text = "\n".join(['set terminal svg size 720,400 font "sans,12" background "white"', f'set output "{path}"',
                      "set key outside right vertical noenhanced", "set grid", f'set xlabel "{labels[0]}" noenhanced',
                      f'set ylabel "{labels[1]}" noenhanced', *more, *blocks, "plot " + ", ".join(parts)])
    subprocess.run(["gnuplot"], input=text, text=True, check=True)


def draw_stress(beds, path):
    curves = []
    for number, (name, bed) in enumerate(beds.items()):
        way, tau = bed.blocks("shear_stress", 0.0, bed.series["displacement"][-1])
        curves.append((name, f"lines lw 1.5 lc rgb '{COLOURS[number]}'", 1e3 * way, 1e-3 * tau))
    draw_curves(path, ("way of the trough, mm", "shear stress, kPa"), curves, "set yrange [0:]")


def draw_feedback(beds, path):
    """Shear stress over what the pushes of the contacts sum up to."""
    curves = []
    for number, (name, bed) in enumerate(beds.items()):
        told = [n for n in bed.told if n["way"] > 2e-3]
        curves.append((name, f"points pt 7 ps 0.4 lc rgb '{COLOURS[number]}'", [1e-3 * n["push"] for n in told],
                       [1e-3 * n["tau"] for n in told]))
    most = max(max(x) for _, _, x, _ in curves)
    curves.append(("0.8 of the pushes", "lines dt 2 lc 'black'", [0.0, most], [0.0, 0.8 * most]))
    draw_curves(path, ("pressure of all contacts that push, kPa", "shear stress, kPa"), curves, "set yrange [0:]")


def draw_pull_off(beds, path):
    """Mean pull-off of the contacts as shear goes on."""
    curves = [(name, f"lines lw 1.5 lc rgb '{COLOURS[number]}'", [1e3 * n["way"] for n in bed.told],
               [n["pull_off"] for n in bed.told]) for number, (name, bed) in enumerate(beds.items())]
    draw_curves(path, ("way of the trough, mm", "mean pull-off, N"), curves, "set yrange [0:]")


def draw_histogram(bed, path):
    curves = []
    for number, way in enumerate(SHOWN):
        k = bed.at(way)
        if k is not None:
            pull = bed.contacts(k)["pull_off"]
            share = numpy.histogram(pull, HISTOGRAM)[0] / len(pull)
            curves.append((f"{way} mm", f"histeps lw 1.5 lc rgb '{COLOURS[number]}'",
                           numpy.sqrt(HISTOGRAM[1:] * HISTOGRAM[:-1]), share))
    draw_curves(path, ("pull-off of a contact, N", "share of the contacts in a class"), curves, "set logscale x")


def draw_lives(bed, path):
    curves = []
    for number, since in enumerate([0, *rising_told.SINCE]):
        begin = bed.at(since)
        if begin is not None:
            left = inside.survival(bed.keys, begin)
            curves.append((f"contacts of {since} mm", f"lines lw 1.5 lc rgb '{COLOURS[number]}'",
                           1e3 * (bed.way[begin:] - bed.way[begin]), left))
    draw_curves(path, ("further way, mm", "share that was never open since"), curves, "set yrange [0:1]")


def draw_profile(beds, key, label, path):
    curves = []
    for name, bed, dash in beds:
        for number, way in enumerate(SHOWN[1:]):
            if bed.way[-1] >= 1e-3 * way - 1e-3:
                told = bed.profile(1e-3 * way, 8)
                style = f"linespoints pt 6 ps 0.5 lc rgb '{COLOURS[number]}' dt {dash}"
                curves.append((f"{name}, {way} mm", style, told[key],
                               told["z"] / (told["z"][0] + told["z"][-1])))
    draw_curves(path, (label, "height over that of the bed"), curves, "set yrange [0:1]")


def draw(beds, folder):
    os.makedirs(folder, exist_ok=True)
    first = beds["base-seed1"]
    large = [("large", beds["large-seed1"], 2)] if "large-seed1" in beds else []

    def path(name):
        return os.path.join(folder, f"rising-{name}.svg")

    draw_stress(beds, path("stress"))
    draw_feedback(beds, path("pushes"))
    draw_pull_off(beds, path("pull-off"))
    draw_histogram(first, path("histogram"))
    draw_lives(first, path("lives"))
    draw_profile([("base", first, 1), *large], "speed", "angle turned over that of the trough", path("turning"))
    draw_profile([("base", first, 1)], "solid", "solid fraction", path("solid"))
