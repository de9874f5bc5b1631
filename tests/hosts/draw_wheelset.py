"""Draws the rows of a host, and prints how far those of a second one are from them.

    draw_wheelset.py PICTURE.png ROWS.csv [OTHER.csv]
"""
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

picture, *files = sys.argv[1:]
rows = [np.genfromtxt(file, delimiter=",", names=True) for file in files]
first = rows[0]
if len(rows) > 1:
    other = rows[1]
    share = first["t"] <= other["t"][-1]
    for name, unit, scale in (("y", "mm", 1e3), ("yaw", "mrad", 1e3),
                              ("y_right", "kN", 1e-3), ("z_right", "kN", 1e-3)):
        difference = np.interp(first["t"], other["t"], other[name])[share] - first[name][share]
        print(f"{name}: largest {scale * np.max(np.abs(first[name])):.3g} {unit}, the second host differs by "
              f"{scale * np.sqrt(np.mean(difference ** 2)):.2g} rms, "
              f"{scale * np.max(np.abs(difference)):.2g} {unit} at most")
figure, panels = plt.subplots(3, 1, figsize=(9, 6.5), sharex=True)
panels[0].plot(first["t"], 1e3 * first["y"], label="wheelset")
panels[0].plot(first["t"], 1e3 * first["rail_y"], label="rails", lw=0.8)
panels[0].set_ylabel("lateral [mm]")
for panel, axis, sign in ((panels[1], "y", 1e-3), (panels[2], "z", -1e-3)):
    for side in ("right", "left"):
        panel.plot(first["t"], sign * first[f"{axis}_{side}"], label=side, lw=0.8)
panels[1].set_ylabel("lateral force\non a wheel [kN]")
panels[2].set_ylabel("vertical force\non a wheel [kN]")
panels[2].set_xlabel("time [s]")
for panel in panels:
    panel.legend(loc="upper left", ncol=2)
    panel.grid(alpha=0.3)
figure.tight_layout()
figure.savefig(picture, dpi=80)
