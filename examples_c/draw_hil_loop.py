#!/usr/bin/env python3
"""Draws what hil_loop wrote: when the forces were there, on one thread and on two, and fixed arithmetic as long.

    draw_hil_loop.py FILE.csv [PICTURE.png]

Left: histogram of the cycles' ends. Right: the share of cycles that ended later than a given time, which shows the tail
that a histogram hides. Both from the moment the cycle was due; the line at 500 us is when the next one is.
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

PERIOD = 500.0  # us
# By kind of cycle, in the colours of Okabe and Ito.
COLOURS = {"one thread": "#0072B2", "arithmetic as long as one": "#56B4E9", "two threads": "#E69F00",
           "arithmetic as long as two": "#F0E442"}


def read(path):
    ends = {name: [] for name in COLOURS}
    with open(path, newline="", encoding="ascii") as file:
        for row in csv.DictReader(file):
            ends[list(COLOURS)[int(row["kind"])]].append(float(row["ended_us"]))
    return {name: np.sort(np.array(values)) for name, values in ends.items()}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    picture = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(sys.argv[1]).with_suffix(".png")
    ends = read(sys.argv[1])
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.8))
    figure.subplots_adjust(left=0.07, right=0.98, bottom=0.12, top=0.84)
    latest = max(values[-1] for values in ends.values())
    bins = np.geomspace(1.0, max(latest, 1.2 * PERIOD), 90)
    for name, values in ends.items():
        p50, p99, p999 = np.quantile(values, [0.5, 0.99, 0.999])
        label = f"{name}: p50 {p50:.0f}, p99 {p99:.0f}, p99.9 {p999:.0f}, max {values[-1]:.0f} us"
        left.hist(np.maximum(values, 1.0), bins, color=COLOURS[name], alpha=0.75, label=label)
        right.step(values, 1.0 - np.arange(len(values)) / len(values), where="post", color=COLOURS[name])
    left.set(ylabel="cycles", yscale="log")
    right.set(ylabel="share of cycles that ended later", yscale="log")
    for axes in (left, right):
        axes.axvline(PERIOD, color="#D55E00", linestyle="--", linewidth=1)
        axes.set(xlabel="end of the cycle's work after it was due [us]", xscale="log")
        axes.grid(alpha=0.3)
    figure.legend(loc="upper center", frameon=False)
    figure.savefig(picture, dpi=130)
    print(picture)


main()
