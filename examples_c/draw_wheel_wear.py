#!/usr/bin/env python3
"""Draws what the example `wheel_wear` writes into a folder.

    draw_wheel_wear.py FOLDER wheel_wear.png
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return dict(zip(rows[0], np.array(rows[1:], dtype=float).T))


def main():
    folder = Path(sys.argv[1])
    log = table(folder / "wheel_wear.csv")
    profiles = sorted(folder.glob("profile_*.csv"))
    figure, axes = plt.subplots(2, 2, figsize=(11, 8), constrained_layout=True)
    colours = plt.cm.viridis(np.linspace(0.0, 0.9, len(profiles)))
    first = table(profiles[0])
    for path, colour in zip(profiles, colours):
        p = table(path)
        label = f"{int(path.stem.split('_')[1]) // 1000}"
        axes[0, 0].plot(p["y_mm"], p["z_mm"], color=colour, lw=1, label=label)
        axes[0, 1].plot(p["y_mm"], np.interp(p["y_mm"], first["y_mm"], first["z_mm"]) - p["z_mm"], color=colour, lw=1)
    axes[0, 0].invert_yaxis()
    axes[0, 0].set_aspect("equal")
    axes[0, 0].legend(title="1000 km", fontsize=7, ncol=2)
    axes[0, 0].set_xlabel("y [mm]")
    axes[0, 0].set_ylabel("z [mm]")
    axes[0, 1].set_xlabel("y [mm]")
    axes[0, 1].set_ylabel("taken off, vertically [mm]")
    axes[0, 1].set_ylim(-0.2, None)
    distance = log["distance_km"] / 1e3
    for name, label in (("flange_height_mm", "flange height"), ("flange_thickness_mm", "flange thickness"),
                        ("qR_mm", "qR")):
        axes[1, 0].plot(distance, log[name] - log[name][0], marker=".", label=f"{label}, {log[name][0]:.1f} mm new")
    axes[1, 0].set_xlabel("1000 km")
    axes[1, 0].set_ylabel("change [mm]")
    axes[1, 0].legend(fontsize=8)
    axes[1, 1].plot(distance, log["conicity"], marker=".")
    axes[1, 1].set_xlabel("1000 km")
    axes[1, 1].set_ylabel("equivalent conicity at 3 mm [-]")
    axes[1, 1].set_ylim(0, None)
    for axis in axes.flat:
        axis.grid(alpha=0.3)
    figure.savefig(sys.argv[2], dpi=100)
    print(sys.argv[2])


if __name__ == "__main__":
    main()
