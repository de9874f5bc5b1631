#!/usr/bin/env python3
"""Draws one contact: pressure and where it slips on the left, tractions on the right.

    ./run.sh --wheel S1002 --rail 60E1 --inclination 0.025 ... --csv fields.csv
    examples_c/draw_contact.py fields.csv picture.png
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def read(path):
    """{column: array (strips, cells)}; cells run from the leading edge backwards."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    strips = len(np.unique(columns["y_m"]))
    return {name: values.reshape(strips, -1) for name, values in columns.items()}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    field = read(sys.argv[1])
    x, y = 1e3 * field["x_m"], 1e3 * field["y_m"]
    slips = np.hypot(field["slip_x"], field["slip_y"]) > 1e-9
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6), sharex=True, sharey=True, layout="constrained")
    shown = left.pcolormesh(y, x, 1e-6 * field["pressure_Pa"], shading="gouraud", cmap="viridis")
    figure.colorbar(shown, ax=left, label="pressure [MPa]")
    left.contour(y, x, slips.astype(float), levels=[0.5], colors="white", linewidths=1.5)
    left.set_title("pressure; the white line parts adhesion (ahead) from slip")
    shown = right.pcolormesh(y, x, 1e-6 * np.hypot(field["traction_x_Pa"], field["traction_y_Pa"]), shading="gouraud",
                             cmap="magma")
    figure.colorbar(shown, ax=right, label="traction [MPa]")
    every = (slice(None, None, 3), slice(1, None, 3))
    right.quiver(y[every], x[every], field["traction_y_Pa"][every], field["traction_x_Pa"][every], color="white",
                 width=2.5e-3, pivot="middle")
    right.set_title("traction on the wheel")
    for axes in (left, right):
        edge = np.concatenate([x[:, 0], x[::-1, -1], x[:1, 0]])
        axes.plot(np.concatenate([y[:, 0], y[::-1, -1], y[:1, 0]]), edge, color="black", linewidth=1)
        axes.set_xlabel("y, to the field side [mm]")
        axes.set_aspect("equal")
    left.set_ylabel("x, rolling direction [mm]")
    figure.savefig(sys.argv[2], dpi=80)
    print(sys.argv[2])


main()
