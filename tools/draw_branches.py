#!/usr/bin/env python3
"""Draws where the strips on the rail's surface have two solutions, from the rows of wheel_report.

    wheel_report branches 6.6 23 58 74 | tools/draw_branches.py docs/pictures/branches.png
"""
import csv
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

WAYS = {"down": ("lowered, from the last solution", "C0-"), "up": ("raised, from the last solution", "C1-"),
        "anew": ("each height anew", "k:")}


def main():
    rows = list(csv.DictReader(sys.stdin))
    lines = {}
    for way in (*WAYS, "exact"):
        of_way = sorted((float(row["z_um"]), 1e-3 * float(row["vertical_N"]), 1e-3 * float(row["lateral_N"]))
                        for row in rows if row["way"] == way)
        lines[way] = np.array(of_way).T
    z, *exact = lines["exact"]
    top = z[0]
    figure, (force, off) = plt.subplots(2, 1, figsize=(8.0, 7.0), sharex=True, layout="constrained")
    force.plot(z - top, exact[0], "o", color="grey", markersize=4, label="exact")
    for way, (label, style) in WAYS.items():
        height, vertical, lateral = lines[way]
        force.plot(height - top, vertical, style, label=label)
        along = np.polyfit(z, exact[0], 3), np.polyfit(z, exact[1], 3)
        # the exact forces between their heights: a cubic, and straight lines for what it leaves
        wanted = [np.polyval(fit, height) + np.interp(height, z, component - np.polyval(fit, z))
                  for fit, component in zip(along, exact)]
        length = np.hypot(*wanted)
        error = np.hypot(vertical - wanted[0], lateral - wanted[1]) / length
        off.plot(height - top, 100.0 * np.sign(length - np.hypot(vertical, lateral)) * -error, style, label=label)
    force.set_ylabel("vertical force [kN]")
    off.set_ylabel("force, less the exact one [%]")
    off.set_xlabel("height, downwards [um]")
    off.axhline(0.0, color="grey", linewidth=0.8)
    for axes in (force, off):
        axes.grid(True, alpha=0.3)
        axes.legend(fontsize=8)
    figure.savefig(sys.argv[1], dpi=110)


if __name__ == "__main__":
    main()
