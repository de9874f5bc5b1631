#!/usr/bin/env python3
"""Draws the creep curves and friction laws from the CSV files creep_curves writes.

    draw_creep_curves.py [directory]

Reads and writes in that directory (default: the current one) and prints the names of the pictures. Creepages are in units
of what saturates the patch in linear theory, mu N / (G c^2 C); forces over friction times load, positive against the
creepage.
"""
import csv
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

EXACT = "exact"
# Okabe and Ito: distinct for every kind of colour vision.
GROUPS = (
    ("what the flexibilities and the bound do", (
        ("FASTSIM-SDEC, parabolic", "#0072B2", "-"),
        ("FASTSIM-SDEC, elliptic", "#D55E00", "-"),
        ("FASTSIM-SDEC, blended", "#009E73", "--"),
        ("FASTSIM-SDEC, single", "#CC79A7", ":"))),
    ("what the patch does", (
        ("FASTSIM", "#999999", "-"),
        ("FASTSIM-EQ.E", "#009E73", "-."),
        ("FASTSIM-EQ.L", "#D55E00", "--"),
        ("FASTSIM-SDEC, parabolic", "#0072B2", "-"))),
    ("strip theory", (
        ("FaStrip", "#999999", "-"),
        ("FaStrip, modified", "#D55E00", "--"),
        ("FaStrip-SDEC", "#0072B2", "-"),
        ("strip FASTSIM", "#CC79A7", ":"))),
)
SWEEPS = (
    ("longitudinal", "fx", r"$\nu_x$", r"$-F_x / \mu N$"),
    ("lateral", "fy", r"$\nu_y$", r"$-F_y / \mu N$"),
    ("spin", "fy", r"$\phi$", r"$-F_y / \mu N$"),
    ("spin", "fx", r"$\phi$", r"$-F_x / \mu N$"),
    ("lateral with spin", "fy", r"$\nu_y$  at $\phi = 1$", r"$-F_y / \mu N$"),
)
LAW_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#999999")


def read(path, curve, x, values):
    """Curves of a file: {key: {column: [numbers]}}, key the columns named in `curve`."""
    curves = defaultdict(lambda: defaultdict(list))
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            key = tuple(row[name] for name in curve)
            for name in (x, *values):
                curves[key][name].append(float(row[name]))
    return curves


def save(figure, directory, name):
    path = directory / name
    figure.savefig(path, dpi=130)
    plt.close(figure)
    print(path)


def draw_creep_curves(directory):
    curves = read(directory / "creep_curves.csv", ("sweep", "variant"), "creepage", ("fx", "fy"))
    figure, axes = plt.subplots(len(GROUPS), len(SWEEPS), figsize=(17, 9.6), layout="constrained")
    for row, (title, variants) in zip(axes, GROUPS):
        for axis, (sweep, force, x_label, y_label) in zip(row, SWEEPS):
            exact = curves[sweep, EXACT]
            axis.plot(exact["creepage"], [-f for f in exact[force]], "ko", markersize=3.5, zorder=5)
            for name, colour, line in variants:
                curve = curves[sweep, name]
                axis.plot(curve["creepage"], [-f for f in curve[force]], color=colour, linestyle=line, linewidth=1.6)
            axis.set_xlabel(x_label)
            axis.set_ylabel(y_label)
            axis.grid(alpha=0.3)
        handles = [plt.Line2D([], [], color=c, linestyle=l, label=n) for n, c, l in variants]
        handles.append(plt.Line2D([], [], color="k", marker="o", linestyle="", markersize=4, label="half-space (exact)"))
        row[0].legend(handles=handles, fontsize=8, loc="lower right", title=title, title_fontsize=8)
    figure.suptitle("Creep curves on the double ellipse of S1002/UIC60 (a = 5.8 mm, b = 10.3 mm, "
                    r"$\psi$ = -0.3, 80 kN, $\mu$ = 0.35); creepages in units of saturation in linear theory")
    save(figure, directory, "creep_curves.png")


def draw_friction_laws(directory):
    curves = read(directory / "friction_laws.csv", ("law",), "creepage", ("adhesion",))
    figure, (whole, start) = plt.subplots(1, 2, figsize=(12, 4.6), layout="constrained")
    for axis, limit in ((whole, 0.15), (start, 0.012)):
        for ((law,), curve), colour in zip(curves.items(), LAW_COLOURS):
            axis.plot([100 * c for c in curve["creepage"]], curve["adhesion"], color=colour, linewidth=1.7, label=law)
        axis.set_xlim(0.0, 100 * limit)
        axis.set_ylim(0.0, 0.38)
        axis.set_xlabel("longitudinal creepage [%]")
        axis.set_ylabel(r"$-F_x / N$")
        axis.grid(alpha=0.3)
    whole.legend(fontsize=9)
    figure.suptitle(r"Friction laws at 20 m/s ($\mu_0$ = 0.36)")
    save(figure, directory, "friction_laws.png")


def main():
    directory = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    draw_creep_curves(directory)
    draw_friction_laws(directory)


if __name__ == "__main__":
    main()
