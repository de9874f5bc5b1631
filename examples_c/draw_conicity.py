#!/usr/bin/env python3
"""Draws the contact functions that the example `conicity` writes.

    conicity conicity.csv; draw_conicity.py conicity.csv conicity.png
"""
import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

STYLE = {0.0: ("rigid", "#0072B2", "-"), 80e3: ("under 80 kN", "#D55E00", "--")}


def read(path):
    """Two tables of one file: {load: {column: [numbers]}} each."""
    tables, heading = [], None
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.reader(file):
            if row[0] == "load_N":
                heading = row
                tables.append(defaultdict(lambda: defaultdict(list)))
                continue
            for name, value in zip(heading[1:], row[1:]):
                tables[-1][float(row[0])][name].append(float(value))
    return tables


def main():
    functions, conicities = read(sys.argv[1])
    figure, axes = plt.subplots(2, 2, figsize=(10, 7), constrained_layout=True)
    for load, (label, colour, line) in STYLE.items():
        f, c = functions[load], conicities[load]
        axes[0, 0].plot(f["y_mm"], f["radius_difference_mm"], line, color=colour, label=label)
        axes[0, 1].plot(f["y_mm"], f["angle_right_mrad"], line, color=colour, label=f"right, {label}")
        axes[0, 1].plot(f["y_mm"], f["angle_left_mrad"], line, color=colour, alpha=0.45, label=f"left, {label}")
        axes[1, 0].plot(f["y_mm"], f["y_wheel_right_mm"], line, color=colour, label=f"on the wheel, {label}")
        axes[1, 0].plot(f["y_mm"], f["y_rail_right_mm"], line, color=colour, alpha=0.45, label=f"on the rail, {label}")
        axes[1, 1].plot(c["amplitude_mm"], c["by_wavelength"], line, color=colour, label=f"by wavelength, {label}")
        axes[1, 1].plot(c["amplitude_mm"], c["by_regression"], line, color=colour, alpha=0.45,
                        label=f"by regression, {label}")
    axes[0, 1].set_yscale("log")
    for axis, x, y in ((axes[0, 0], "lateral displacement [mm]", "rolling radius difference [mm]"),
                       (axes[0, 1], "lateral displacement [mm]", "contact angle [mrad]"),
                       (axes[1, 0], "lateral displacement [mm]", "contact of the right wheel [mm]"),
                       (axes[1, 1], "amplitude [mm]", "equivalent conicity [-]")):
        axis.set_xlabel(x)
        axis.set_ylabel(y)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    axes[1, 1].set_ylim(0, 0.8)
    figure.suptitle("S1002 on 60E1, 1:40, gauge 1435 mm")
    figure.savefig(sys.argv[2], dpi=110)
    print(sys.argv[2])


if __name__ == "__main__":
    main()
