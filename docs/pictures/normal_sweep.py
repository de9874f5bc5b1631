"""Draws normal_sweep.png from the rows of `normal_report sweep --rows rows.csv`.

    python3 docs/pictures/normal_sweep.py rows.csv docs/pictures/normal_sweep.png
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

with open(sys.argv[1], newline="") as source:
    rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(source)]

panels = [
    ("area_mm2", "area [mm$^2$]"),
    ("approach_um", "approach [µm]"),
    ("peak_MPa", "peak pressure [MPa]"),
    ("patches", "patches"),
]
figure, axes = plt.subplots(len(panels), 1, figsize=(8, 10), sharex=True)
for axis, (name, label) in zip(axes, panels):
    for yaw in (-20, 0, 20):
        path = [row for row in rows if row["yaw_mrad"] == yaw]
        axis.plot([row["lateral_mm"] for row in path], [row[name] for row in path], lw=1, label=f"yaw {yaw} mrad")
    axis.set_ylabel(label)
    axis.grid(alpha=0.3)
axes[2].set_yscale("log")
axes[3].set_yticks([1, 2, 3])
axes[0].legend()
axes[0].set_title("S1002 on UIC60, right wheel, 80 kN along the contact normal, strip half-space solver")
axes[-1].set_xlabel("lateral shift of the wheelset [mm], towards the flange positive")
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=90)
