#!/usr/bin/env python3
"""Pictures of what low_adhesion computes.

    draw_low_adhesion.py stop WITHOUT.csv WITH_SAND.csv PICTURE.png
    draw_low_adhesion.py traction FILE.csv PICTURE.png
    draw_low_adhesion.py start WITHOUT.csv WITH_SAND.csv PICTURE.png
    draw_low_adhesion.py curve FILE.csv PICTURE.png
"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402


def read(name):
    """Columns: time, speed, place, then slip and adhesion of each axle."""
    table = np.loadtxt(name, delimiter=",")
    return {"time": table[:, 0], "speed": 3.6 * table[:, 1], "place": table[:, 2], "slip": 100 * table[:, 3::2], "adhesion": table[:, 4::2]}


def smooth(values, count=200):
    """Mean over 2 s of lines that are 10 ms apart."""
    return np.array([np.convolve(each, np.ones(count) / count, "valid") for each in values.T]).T


def stop(without, with_sand):
    figure, axes = plt.subplots(2, 2, figsize=(11, 7.5))
    for name, label, panel in ((without, "without sand", axes[0, 1]), (with_sand, "with sand at axle 3", axes[1, 1])):
        run = read(name)
        axes[0, 0].plot(run["place"], run["speed"], label=f"{label}: {run['place'][-1]:.0f} m")
        axes[1, 0].plot(np.arange(1, 17), np.abs(run["adhesion"]).mean(axis=0), "o-", label=label)
        mean = smooth(-run["adhesion"])
        for axle in (0, 1, 2, 3, 7, 15):
            panel.plot(run["place"][:len(mean)], mean[:, axle], label=f"axle {axle + 1}")
        panel.set(xlabel="place of the train [m]", ylabel="adhesion, mean over 2 s [-]", title=label, ylim=(0, 0.16))
        panel.legend(ncol=2, fontsize=8)
    axes[0, 0].set(xlabel="distance [m]", ylabel="speed [km/h]")
    axes[1, 0].set(xlabel="axle", ylabel="adhesion, mean over the stop [-]", ylim=(0, None))
    for each in axes[:, 0]:
        each.legend()
    return figure


def traction(name):
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2))
    run = read(name)
    left.plot(run["time"], run["slip"][:, 0], label="slip of axle 1 [%]")
    left.plot(run["time"], 100 * run["adhesion"].mean(axis=1), label="mean adhesion [% of the load]")
    left.set(xlabel="time [s]")
    for axle in range(run["slip"].shape[1]):
        right.plot(run["slip"][:, axle], run["adhesion"][:, axle], ".", ms=2, label=f"axle {axle + 1}")
    right.set(xlabel="slip [%]", ylabel="adhesion [-]", xlim=(0, None), ylim=(0, None))
    left.legend()
    right.legend(markerscale=5)
    return figure


def start(without, with_sand):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2))
    for name, label, style in ((without, "without sand", "o-"), (with_sand, "with sand at axles 1 and 4", "s-")):
        run = read(name)
        axes[0].plot(run["time"], run["speed"], label=label)
        axes[1].plot(np.arange(1, 7), run["adhesion"][100:].mean(axis=0), style, label=label)
    axes[0].set(xlabel="time [s]", ylabel="speed [km/h]")
    axes[1].set(xlabel="axle", ylabel="adhesion, mean over time [-]", ylim=(0, None))
    for each in axes:
        each.legend()
    return figure


def curve(name):
    figure, axes = plt.subplots(figsize=(7, 4.8))
    _, slip, adhesion = np.loadtxt(name, delimiter=",").T
    quarter = len(slip) // 4
    for branch, label in enumerate(("up", "down", "up again", "down again")):
        part = slice(branch * quarter, (branch + 1) * quarter)
        axes.plot(100 * slip[part], adhesion[part], label=label)
    axes.set(xlabel="slip [%]", ylabel="adhesion [-]", xlim=(0, None), ylim=(0, None))
    axes.legend()
    return figure


def main():
    stories = {"stop": stop, "traction": traction, "start": start, "curve": curve}
    if len(sys.argv) < 4 or sys.argv[1] not in stories:
        sys.exit(__doc__)
    figure = stories[sys.argv[1]](*sys.argv[2:-1])
    figure.tight_layout()
    figure.savefig(sys.argv[-1], dpi=110)


if __name__ == "__main__":
    main()
