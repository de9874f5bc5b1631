#!/usr/bin/env python3
"""Draws what the example `vehicle` writes: one picture for each run in the file.

    vehicle all vehicle.csv; draw_vehicle.py vehicle.csv FOLDER
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

STATIC = 70.0  # kN on a wheel
RIGHT, LEFT, LINE = "#1f5f9f", "#c8501e", "#444444"


def runs(path):
    """{run: {value: {column: array}}}, in the file's order."""
    found = {}
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            run, value = row.pop("run"), float(row.pop("value"))
            found.setdefault(run, {}).setdefault(value, []).append([float(each) for each in row.values()])
            names = list(row)
    return {run: {value: dict(zip(names, np.array(rows).T)) for value, rows in values.items()} for run, values in found.items()}


def panels(rows, height, title, columns=1, **options):
    figure, axes = plt.subplots(rows, columns, figsize=(9.5, height), constrained_layout=True, squeeze=False, **options)
    figure.suptitle(title, fontsize=12)
    for axis in axes.flat:
        axis.grid(alpha=0.3)
    return figure, axes


def of_wheels(axis, x, run, kind, sign, label, legend="upper right"):
    for side, colour in (("right", RIGHT), ("left", LEFT)):
        axis.plot(x, sign * 1e-3 * run[f"{kind}_{side}"], color=colour, lw=1.1, label=side)
    axis.set_ylabel(label)
    axis.legend(fontsize=8, loc=legend)


def klingel(all_runs):
    figure, axes = panels(2, 6.2, "A wheelset left to itself, 1 m/s, 140 kN: Klingel's motion")
    for axis, name, what in ((axes[0, 0], "klingel", "S1002 on 60E1 1:40"), (axes[1, 0], "cones", "cones of 1:20 on 60E1 1:20")):
        for (start, run), colour in zip(all_runs[name].items(), (RIGHT, LEFT, "#2b7a3b")):
            axis.plot(run["distance"], 1e3 * run["y"], color=colour, lw=1.2, label=f"from {1e3 * start:.0f} mm")
        waves = all_runs[f"{name}_wave"]
        text = "\n".join(f"amplitude {1e3 * a:.2f} mm: {w['time'][0]:.3f} m; slow rolling {w['distance'][0]:.3f} m, "
                         f"Klingel {w['y'][0]:.3f} m" for a, w in waves.items())
        axis.set_title(f"{what}\n{text}", fontsize=8.5, loc="left")
        axis.set_ylabel("lateral displacement [mm]")
        axis.set_ylim(top=1.4 * axis.get_ylim()[1])
        axis.legend(fontsize=8, loc="upper right", ncol=3)
    axes[1, 0].set_xlabel("distance [m]")
    return figure


def critical(all_runs):
    figure, axes = panels(1, 5.0, "Bogie on S1002 and 60E1: limit cycles")
    axis = axes[0, 0]
    stable, unstable = [], []
    for speed, rows in all_runs["cycle"].items():
        for branch, amplitude in zip(rows["time"], rows["y"]):
            (stable if branch == 1 else unstable).append((3.6 * speed, 1e3 * amplitude))
    linear = 3.6 * next(iter(all_runs["linear"]))
    stable, unstable = np.array(sorted(stable)), np.array(sorted([*unstable, (linear, 0.0)]))
    axis.plot(*stable.T, "o-", color=RIGHT, label="limit cycle, stable")
    axis.plot(*unstable.T, "o--", color=LEFT, label="left both ways: smaller motions die out, larger ones grow")
    for speed, rows in all_runs.get("none", {}).items():
        axis.axvline(3.6 * speed, color="#2b7a3b", lw=1, ls=":", label=f"no limit cycle at {3.6 * speed:.0f} km/h")
    axis.axvline(linear, color=LINE, lw=1, label=f"linear critical speed {linear:.0f} km/h")
    axis.plot([stable[0, 0] - 25.0, linear], [0.0, 0.0], color=RIGHT, lw=2)
    axis.set_xlim(stable[0, 0] - 25.0, stable[-1, 0] + 8.0)
    axis.set_ylim(-0.2, None)
    axis.set_xlabel("speed [km/h]")
    axis.set_ylabel("amplitude of the first wheelset [mm]")
    axis.legend(fontsize=8, loc="center right")
    return figure


def curve(all_runs):
    run = next(iter(all_runs["curve"].values()))
    figure, axes = panels(3, 7.5, "Bogie into a right-hand curve of 300 m, 54 km/h, canted for that", sharex=True)
    x = run["distance"]
    axes[0, 0].plot(x, 1e3 * run["y"], color=RIGHT, label="first wheelset")
    axes[0, 0].plot(x, 1e3 * run["y_second"], color=LEFT, label="second wheelset")
    axes[0, 0].set_ylabel("lateral displacement [mm]")
    axes[0, 0].legend(fontsize=8)
    axes[1, 0].plot(x, 1e3 * run["yaw"], color=RIGHT)
    axes[1, 0].set_ylabel("yaw of the first\nwheelset [mrad]")
    of_wheels(axes[2, 0], x, run, "lateral", 1.0, "lateral force on the\nfirst wheels [kN]", "center right")
    for axis in axes.flat:
        axis.axvspan(10.0, 40.0, color="#dddddd", alpha=0.5, lw=0)
    axes[1, 0].text(25.0, axes[1, 0].get_ylim()[0], "transition", ha="center", va="bottom", fontsize=8)
    axes[2, 0].set_xlabel("distance [m]")
    return figure


def turnout(all_runs):
    figure, axes = panels(3, 7.5, "Bogie through a turnout: stock rail and blade", sharex=True)
    for (speed, run), colour in zip(all_runs["turnout"].items(), (RIGHT, LEFT)):
        label = f"{speed:.0f} km/h"
        axes[0, 0].plot(run["distance"], -1e-3 * run["vertical_right"], color=colour, lw=1, label=label)
        axes[1, 0].plot(run["distance"], 1e-3 * run["lateral_right"], color=colour, lw=1, label=label)
        axes[2, 0].plot(run["distance"], 1e3 * run["y"], color=colour, lw=1.2, label=label)
    axes[0, 0].set_ylabel("vertical force, first\nright wheel [kN]")
    axes[1, 0].set_ylabel("lateral force, first\nright wheel [kN]")
    axes[2, 0].set_ylabel("lateral displacement of\nthe first wheelset [mm]")
    for axis in axes.flat:
        axis.axvspan(10.5, 13.5, color="#dddddd", alpha=0.5, lw=0)
        axis.legend(fontsize=8, loc="upper right")
    axes[0, 0].text(12.0, axes[0, 0].get_ylim()[0], "the blade rises", ha="center", va="bottom", fontsize=8)
    axes[2, 0].set_xlabel("distance [m]")
    return figure


def flat(all_runs):
    run = next(iter(all_runs["flat"].values()))
    figure, axes = panels(1, 4.2, "Wheel flat 0.5 mm deep, 90 mm long, worn, 60 km/h, on a rigid track")
    of_wheels(axes[0, 0], 1e3 * run["time"], run, "vertical", -1.0, "vertical force, first wheels [kN]")
    axes[0, 0].axhline(STATIC, color=LINE, lw=0.8, ls=":")
    axes[0, 0].set_xlabel("time [ms]")
    return figure


def irregular(all_runs):
    run = next(iter(all_runs["irregular"].values()))
    figure, axes = panels(3, 7.5, "Bogie on irregular track, 144 km/h: 40 waves of 3 to 60 m, 1.5 mm rms", sharex=True)
    x = run["distance"]
    axes[0, 0].plot(x, 1e3 * run["rail_y"], color=LINE, lw=1, ls="--", label="rails")
    axes[0, 0].plot(x, 1e3 * run["y"], color=RIGHT, label="first wheelset")
    axes[0, 0].plot(x, 1e3 * run["y_second"], color=LEFT, lw=1, label="second wheelset")
    axes[0, 0].set_ylabel("lateral displacement [mm]")
    axes[0, 0].legend(fontsize=8, loc="upper left")
    of_wheels(axes[1, 0], x, run, "lateral", 1.0, "lateral force,\nfirst wheels [kN]", "upper left")
    of_wheels(axes[2, 0], x, run, "vertical", -1.0, "vertical force,\nfirst wheels [kN]", "upper left")
    axes[2, 0].set_xlabel("distance [m]")
    return figure


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    all_runs, folder = runs(sys.argv[1]), Path(sys.argv[2])
    for name, draw, needed in (("klingel", klingel, "cones"), ("critical", critical, "cycle"), ("curve", curve, "curve"),
                               ("turnout", turnout, "turnout"), ("flat", flat, "flat"), ("irregular", irregular, "irregular")):
        if needed in all_runs:
            path = folder / f"vehicle_{name}.png"
            figure = draw(all_runs)
            figure.savefig(path, dpi=80)
            plt.close(figure)
            print(path)


if __name__ == "__main__":
    main()
