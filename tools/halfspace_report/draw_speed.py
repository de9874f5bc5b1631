#!/usr/bin/env python3
"""Draws cost against grid size from the numbers of halfspace_report.

    halfspace_report speed --json | tools/halfspace_report/draw_speed.py docs/pictures/halfspace_speed.png
"""
import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# CONTACT 25.2 on the same kind of machine, milliseconds, by cells along a side.
CONTACT = {32: 1060.0, 64: 29000.0}


def main():
    report = json.loads(sys.stdin.read().splitlines()[-1])
    cells = [grid["cells"] for grid in report["grids"]]
    figure, axes = plt.subplots(figsize=(8.6, 4.6), layout="constrained")
    for k, case in enumerate(report["grids"][0]["cases"]):
        times = [grid["cases"][k]["ms"] for grid in report["grids"]]
        axes.loglog(cells, times, "o-", label=case["case"])
    axes.loglog(cells, [grid["product_ms"] for grid in report["grids"]], "k:", label="one FFT product")
    axes.loglog(list(CONTACT), list(CONTACT.values()), "rs--", label="CONTACT 25.2")
    middle = [grid["median_ms"] for grid in report["grids"]]
    axes.text(cells[2], middle[2] * 2.5, f"median ~ cells$^{{{report['exponent']:.2f}}}$", ha="right")
    axes.plot([cells[1]], [300.0], "v", color="grey", linestyle="none", label="aim: 30 ms and 0.3 s")
    axes.plot([cells[0]], [30.0], "v", color="grey")
    axes.set_xticks(cells, [f"{n} x {n}" for n in cells])
    axes.minorticks_off()
    axes.set_xlabel("cells")
    axes.set_ylabel("processor time per solution [ms]")
    axes.set_title("Steady rolling, exact half-space solver, one core")
    axes.grid(True, which="major", alpha=0.3)
    axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    figure.savefig(sys.argv[1], dpi=130)


if __name__ == "__main__":
    main()
