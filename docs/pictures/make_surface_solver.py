"""Draws the pictures of surface_solver.md: surface_strip.png, one strip with its symbols, and surface_solver_flow.png, a
solve. Nothing is read: the strip is one of Hertz's contact, its axes beside those of the strip.

    python3 docs/pictures/make_surface_solver.py docs/pictures
"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import FancyBboxPatch

FOLDER = sys.argv[1] if len(sys.argv) > 1 else "docs/pictures"
WIDTH = 170 / 25.4  # of the page [inch]
plt.rcParams.update({"font.size": 9, "mathtext.fontset": "cm", "axes.linewidth": 0.8})
INK, BLUE, RED, GREY, GREEN = "#222222", "#1f5fa8", "#c03a2b", "#8a8a8a", "#2f7d4f"


def arrow(axis, start, end, text="", at=None, both=True, colour=INK, **more):
    axis.annotate("", end, start, arrowprops=dict(arrowstyle="<->" if both else "->", color=colour, lw=0.9, shrinkA=0, shrinkB=0))
    if text:
        at = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2) if at is None else at
        axis.text(*at, text, color=colour, **{"ha": "center", "va": "center", "fontsize": 10, **more})


def draw_section(axis):
    """The rail's strips, seen along x."""
    radius, wheel_radius, deep = 10.0, 16.0, 0.55
    turn = np.linspace(-0.62, 0.62, 200)
    axis.plot(radius * np.sin(turn), radius * (np.cos(turn) - 1), color=INK, lw=1.4)
    tilt = 0.12  # the wheel touches beside the top
    middle = np.array([np.sin(tilt), np.cos(tilt)])
    lowest = np.array([0, -radius]) + (radius - deep) * middle
    centre = lowest + wheel_radius * middle
    turn = np.linspace(-0.34, 0.34, 200) + tilt
    axis.plot(centre[0] - wheel_radius * np.sin(turn), centre[1] - wheel_radius * np.cos(turn), color=BLUE, lw=1.4)
    borders = np.arange(-0.55, 0.56, 0.1)
    for a in borders:
        n = np.array([np.sin(a), np.cos(a)])
        foot = np.array([0, -radius]) + radius * n
        axis.plot(*zip(foot - 0.12 * n, foot + 0.12 * n), color=INK, lw=0.7)
    for k, a in enumerate(0.5 * (borders[1:] + borders[:-1])):
        n = np.array([np.sin(a), np.cos(a)])
        foot = np.array([0, -radius]) + radius * n
        ray = foot - 1.5 * n
        # the wheel's circle on the ray below the rail
        off = foot - centre
        b = off @ n
        t = -b - np.sqrt(max(b * b - off @ off + wheel_radius**2, 0))
        if t < 0:
            axis.plot(*zip(foot, foot + t * n), color=RED, lw=3 if k == 7 else 1.2, solid_capstyle="butt")
        if k == 7:
            arrow(axis, foot + 2.2 * n, foot + 0.15 * n, r"$n_i$", foot + 2.5 * n, both=False)
            axis.annotate(r"depth $d_i$", foot + 0.5 * t * n, foot + np.array([2.6, -2.0]), fontsize=9, color=RED, ha="center",
                          arrowprops=dict(arrowstyle="-", color=RED, lw=0.7))
        if k == 4:
            arrow(axis, foot + 2.2 * n, foot + 0.15 * n, r"$n_j$", foot + 2.5 * n, both=False)
    def on_rail(a, out):
        return (radius + out) * np.sin(a), (radius + out) * np.cos(a) - radius
    inside = np.linspace(borders[5], borders[6], 10)
    axis.plot(*on_rail(inside, -1.0), color=INK, lw=0.8)
    for a in (borders[5], borders[6]):
        axis.plot(*zip(on_rail(a, -0.85), on_rail(a, -1.15)), color=INK, lw=0.8)
    axis.text(*on_rail(0.5 * (borders[5] + borders[6]), -1.55), r"$w$", ha="center", va="center", fontsize=10)
    axis.text(-6.1, -2.9, "rail, cut into strips\nat arc lengths $s$", fontsize=9, ha="left", va="center", color=INK)
    axis.text(-4.6, 2.3, "wheel's outline", fontsize=9, color=BLUE, ha="center")
    axis.annotate("", (6.1, -1.55), (4.6, -0.65), arrowprops=dict(arrowstyle="->", color=INK, lw=0.9))
    axis.text(5.75, -0.85, r"$s$", fontsize=10)
    axis.set(xlim=(-6.3, 6.6), ylim=(-3.7, 3.1), aspect="equal")
    axis.set_title("(a) section of the rail, seen along $x$", fontsize=9.5, loc="left")
    axis.axis("off")


def draw_strip(axis, below):
    """One strip along x: overlap, displacement, pressure."""
    W, shift, kappa, d = 0.0, 0.36, 0.55, 0.95
    c = W + shift
    d_c = d - kappa / 2 * shift**2
    l = 1.2
    x = np.linspace(-3.1, 3.7, 600)
    overlap = d - kappa / 2 * (x - W) ** 2
    # beyond the edges a decay with their values and slopes: a sketch
    at = {side: d - kappa / 2 * (c + side * l - W) ** 2 for side in (-1, 1)}
    slope = {side: kappa * abs(c + side * l - W) for side in (-1, 1)}
    away = np.maximum(np.abs(x - c) - l, 0)
    side = np.where(x > c, 1, -1)
    value, steep = np.where(side > 0, at[1], at[-1]), np.where(side > 0, slope[1], slope[-1])
    u = np.where(away > 0, value / (1 + steep * away / value), overlap)
    axis.axhline(0, color=GREY, lw=0.7)
    axis.plot(x, np.where(overlap > -0.75, overlap, np.nan), color=BLUE, lw=1.3, ls=(0, (5, 2)))
    axis.plot(x, u, color=RED, lw=1.6)
    axis.text(2.24, -0.26, r"overlap $d-\frac{\kappa}{2}(x-W)^2$", color=BLUE, fontsize=9.5, ha="left", va="center")
    axis.text(-3.05, 0.56, "displacement $u$", color=RED, fontsize=9.5, ha="left")
    for side, name in ((-1, r"$u^-$"), (1, r"$u^+$")):
        axis.plot([c + side * l], [at[side]], "o", color=RED, ms=4)
        axis.plot([c + side * l] * 2, [-0.95, at[side]], color=GREY, lw=0.7, ls=":")
    axis.text(c - l - 0.08, at[-1] + 0.10, r"$u^-$", color=RED, fontsize=10, ha="right")
    axis.text(c + l + 0.08, at[1] + 0.09, r"$u^+$", color=RED, fontsize=10, ha="left")
    axis.plot([c - l, c + l], [at[-1], at[1]], color=GREY, lw=0.8)
    axis.plot([c], [d_c], "o", color=INK, ms=4)
    mean = 0.5 * (at[-1] + at[1])
    arrow(axis, (c, d_c), (c, mean), "drop", (c + 0.10, 0.5 * (d_c + mean)), ha="left", fontsize=9)
    axis.plot([W, W], [-0.95, d + 0.25], color=BLUE, lw=0.7, ls=":")
    axis.plot([c, c], [d_c, d + 0.25], color=GREY, lw=0.7, ls=":")
    axis.plot([c, c], [-0.95, mean], color=GREY, lw=0.7, ls=":")
    arrow(axis, (W, d + 0.18), (c, d + 0.18), "shift", (W + shift / 2, d + 0.32), fontsize=9)
    arrow(axis, (W - 0.12, 0), (W - 0.12, d), r"$d$", (W - 0.26, 0.45), colour=BLUE)
    axis.plot([c, 3.0], [d_c, d_c], color=GREY, lw=0.7, ls=":")
    arrow(axis, (2.95, 0), (2.95, d_c), r"$d_c$", (3.2, 0.5 * d_c))
    axis.set(xlim=(-3.1, 3.7), ylim=(-0.85, d + 0.45), yticks=[], xticks=[])
    axis.set_ylabel("along $n_i$", fontsize=9)
    axis.set_title("(b) strip $i$ along $x$: overlap and displacement", fontsize=9.5, loc="left")
    # pressure
    inside = np.linspace(-1, 1, 300)
    p = np.sqrt(1 - inside**2)
    below.fill_between(c + l * inside, 0, p, color="#dbe7f4")
    below.plot(c + l * inside, p, color=INK, lw=1.4)
    below.axhline(0, color=GREY, lw=0.7)
    for place in (W, c, c - l, c + l):
        below.plot([place] * 2, [0, 1.42], color=GREY if place != W else BLUE, lw=0.7, ls=":")
    arrow(below, (c, 0), (c, 1), r"$\lambda\, l$", (c + 0.28, 0.42))
    arrow(below, (c, 0.12), (c - l, 0.12), r"$l=\sqrt{L}$", (c - l / 2 - 0.05, 0.29))
    below.text(2.05, 0.95, r"$p=\lambda\sqrt{L-(x-c)^2}$", fontsize=10, ha="left")
    below.text(2.05, 0.60, r"$q=\lambda L,\quad N=\frac{\pi}{2}\, w\, q$", fontsize=10, ha="left")
    for place, name in ((W, "$W$"), (c, "$c$"), (c - l, "$c-l$"), (c + l, "$c+l$")):
        below.text(place, -0.17, name, ha="center", va="center", fontsize=10)
    below.annotate("", (3.7, 0), (3.3, 0), arrowprops=dict(arrowstyle="->", color=INK, lw=0.9))
    below.text(3.58, -0.17, "$x$", ha="center", va="center", fontsize=10)
    below.set(xlim=(-3.1, 3.7), ylim=(-0.3, 1.42), yticks=[], xticks=[])
    below.set_ylabel("pressure", fontsize=9)
    for each in (axis, below):
        for side in each.spines.values():
            side.set_visible(False)


def strip_picture():
    figure = plt.figure(figsize=(WIDTH, 7.0))
    grid = figure.add_gridspec(3, 1, height_ratios=(1.1, 1.25, 0.8), left=0.06, right=0.99, top=0.965, bottom=0.01, hspace=0.13)
    draw_section(figure.add_subplot(grid[0]))
    draw_strip(figure.add_subplot(grid[1]), figure.add_subplot(grid[2]))
    figure.savefig(f"{FOLDER}/surface_strip.png", dpi=200)


def box(axis, x, y, width, height, head, text="", where="", colour="#eef3f9", edge=BLUE):
    axis.add_patch(FancyBboxPatch((x - width / 2, y - height / 2), width, height, boxstyle="round,pad=0,rounding_size=1.2", fc=colour, ec=edge, lw=0.9))
    lines = [(head, dict(fontsize=9, fontweight="bold"))]
    lines += [(line, dict(fontsize=8.4)) for line in text.split("\n") if line]
    if where:
        lines.append((where, dict(fontsize=7.6, family="monospace", color="#555555")))
    step = 4.0
    top = y + step * (len(lines) - 1) / 2
    for i, (line, style) in enumerate(lines):
        axis.text(x, top - i * step, line, ha="center", va="center", **style)


def line(axis, points, text="", at=None, head=True, **more):
    xs, ys = zip(*points)
    axis.plot(xs[:-1] if head else xs, ys[:-1] if head else ys, color=INK, lw=0.9)
    if head:
        axis.annotate("", points[-1], points[-2], arrowprops=dict(arrowstyle="-|>", color=INK, lw=0.9, shrinkA=0, shrinkB=0))
    if text:
        axis.text(*at, text, fontsize=8.2, **{"ha": "left", "va": "center", "color": INK, **more})


def flow_picture():
    figure, axis = plt.subplots(figsize=(WIDTH, 8.0))
    figure.subplots_adjust(left=0, right=1, top=1, bottom=0)
    axis.set(xlim=(0, 170), ylim=(8, 211))
    axis.axis("off")
    box(axis, 85, 202, 70, 12, "Overlaps of the candidates", "depth, deepest point $W$, $\\kappa$, $n$", colour="white", edge=INK)
    box(axis, 42, 172, 74, 20, "Start from the last solution", "$L$ moved as the overlaps moved;\nnot if extrapolated already", "follow_overlaps()  start.cpp", "#eef7f0", GREEN)
    box(axis, 128, 172, 74, 20, "Start from the overlaps", "$L=d/\\kappa$, on pairs of strips, iterated to 0.1;\nthen interpolated", "start_from_overlaps()  start.cpp", "#eef7f0", GREEN)
    line(axis, [(72, 196), (52, 182)], "a solution is given", (33, 190))
    line(axis, [(98, 196), (118, 182)], "none", (112, 190))
    line(axis, [(79, 172), (91, 172)])
    axis.text(85, 167.6, "too far", fontsize=8.2, ha="center")

    axis.add_patch(FancyBboxPatch((8, 31), 122, 122, boxstyle="round,pad=0,rounding_size=2", fc="#fbfbfb", ec=GREY, lw=0.9, ls="--"))
    axis.text(127, 149.5, "iterate()  iteration.cpp", fontsize=8.4, ha="right", va="center", color="#555555", family="monospace")
    X, W, H = 63, 92, 15.6
    box(axis, X, 137, W, H, "1  Active set", r"$M q=d_c$;   $q<0$: leaves,   $u<d_c$: enters", "solve_contact()  active_set.cpp")
    box(axis, X, 117.5, W, H, "2  Edges, residual", r"$u^\pm\!\to\lambda$, shift, smoothed;  $f=(q/\lambda-L,\ \ldots)$", "edge_residual()  edge_condition.cpp")
    box(axis, X, 98, W, H, "3  Preconditioner", r"$f\to(f-0.45\,$smooth part$)\,/\,0.45$", "precondition()  iteration.cpp")
    box(axis, X, 78.5, W, H, "4  Anderson's acceleration", "mixes the last 5 iterates for the least step", "accelerate()  iteration.cpp")
    box(axis, X, 59, W, H, "5  Safeguard", "between half and twice of the plain L + f", "limited()  iteration.cpp")
    box(axis, X, 39.5, W, 12, "$L$, shift of iteration k + 1", "", "take_step()  iteration.cpp", "white", INK)
    for y in (137, 117.5, 98, 78.5):
        line(axis, [(X, y - H / 2), (X, y - 19.5 + H / 2)])
    line(axis, [(X, 59 - H / 2), (X, 45.5)])
    line(axis, [(42, 162), (42, 144.8)])
    line(axis, [(128, 162), (128, 157), (72, 157), (72, 144.8)])
    line(axis, [(X - W / 2, 39.5), (12, 39.5), (12, 137), (X - W / 2, 137)])
    axis.text(14.3, 88, "again", fontsize=8.2, rotation=90, va="center", ha="center")

    box(axis, 150, 117.5, 36, 24, "moved > 0.3 area", "in iteration 0 from\nthe last solution:\ngive it up", "", "#fdf1ef", RED)
    line(axis, [(X + W / 2, 117.5), (132, 117.5)])
    line(axis, [(152, 129.5), (152, 162)])
    box(axis, 150, 55, 36, 28, "moved < 1e-7 area", "and no far strip enters:\nthis step is the last,\n$q$ extrapolated\nover it", "", "#eef7f0", GREEN)
    line(axis, [(X + W / 2, 43), (132, 43)])
    line(axis, [(150, 41), (150, 18), (122, 18)])
    box(axis, 85, 18, 74, 14, "StripPressure", "$L$, $c$, $q$, $\\lambda=q/L$; start of the next solve", "finish(), store()", "white", INK)
    line(axis, [(30, 31), (30, 18), (48, 18)])
    axis.text(28, 24.5, "too many\niterations", fontsize=8.2, ha="right", va="center")
    figure.savefig(f"{FOLDER}/surface_solver_flow.png", dpi=200)


strip_picture()
flow_picture()
