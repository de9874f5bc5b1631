#!/usr/bin/env python3
"""Draws the source paper's figures from the CSV files paper_cases writes.

    draw_paper_figures.py [directory]

Reads and writes in that directory (default: the current one) and prints the names of the pictures. Frame: x is the
rolling direction, y lateral with the origin at the initial contact point, on the profiles negative towards the flange.

Paper: B. Liu, S. Bruni, Application of the extended FASTSIM for non-Hertzian contacts towards the prediction of wear and
rolling contact fatigue of wheel/rail systems, Proc. IMechE Part F 238(4) (2024) 427-436. Its figures 2 to 9.

Files of a variant called "exact", from the half-space solver, are drawn as the reference where they exist.
"""
import csv
import math
import sys
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MultipleLocator

# ------------------------------------------------------------------------------------------------------ what is drawn


@dataclass(frozen=True)
class Variant:
    key: str  # in the file names
    profile_label: str
    ellipse_label: str
    colour: str  # Okabe and Ito: distinct for every kind of colour vision
    line: str


@dataclass(frozen=True)
class Case:
    key: str
    title: str
    short: str


@dataclass(frozen=True)
class Part:
    key: str
    name: str
    title: str
    lateral_label: str
    cases: tuple


EXACT = Variant("exact", "half-space (exact)", "half-space (exact)", "black", "-")
VARIANTS = (
    Variant("sdec", "EKP+FASTSIM-SDEC", "FASTSIM-SDEC", "#0072B2", "-"),
    Variant("eql", "EKP+FASTSIM-EQ.L", "FASTSIM-EQ.L", "#D55E00", "--"),
    Variant("eqe", "HZ+FASTSIM-EQ.E", "FASTSIM-EQ.E", "#009E73", "-."),
    Variant("strips", "half-space strips+strip FASTSIM", "strip FASTSIM", "#CC79A7", ":"),
)
COMBINED = r"Case 2, combined: $\nu_x = -0.49\cdot10^{-3}$, $\nu_y = -0.22\cdot10^{-3}$, $\phi = 0.29$ 1/m"
PROFILES = Part(
    "profiles", "S1002/UIC60", "S1002 on UIC60, 80 kN", "y [mm]  (flange side: y < 0)",
    (Case("case1", r"Case 1, pure spin: $\phi = -0.5$ 1/m", "Case 1"), Case("case2", COMBINED, "Case 2")))
ELLIPSE = Part(
    "ellipse", "double ellipse", r"exact double ellipse, $\psi = 0.4$, 17 kN", "y [mm]",
    # Case 1 twice: the paper's spin and the paper's power do not belong together (see paper_cases.c).
    (Case("case1_printed", r"Case 1 as printed, pure spin: $\phi = 1.0$ 1/m", "Case 1 as printed"),
     Case("case1", r"Case 1 at the spin of the printed 10.3 W: $\phi = 0.585$ 1/m", "Case 1 of 10.3 W"),
     Case("case2", COMBINED, "Case 2")))

STRIP_COLUMNS = ("y_m", "width_m", "x_trail_m", "x_lead_m", "peak_pressure_Pa", "power_W_per_m")
CELL_COLUMNS = ("y_m", "width_m", "x_m", "pressure_Pa", "power_W_per_m2", "fatigue_index")
SUMMARY_COLUMNS = ("part", "case", "model", "utilisation", "load_factor")

CASE_MARKERS = "osD^v"  # of the shakedown map: two profile cases, three of the double ellipse

ADHESION_GREY = "#D4D4D4"
POWER_COLOURS = LinearSegmentedColormap.from_list("power", plt.get_cmap("magma_r")(np.linspace(0.08, 0.95, 256)))
POWER_COLOURS.set_bad(ADHESION_GREY)  # cells that stick are masked

MILLI = 1e3  # m to mm
MEGA = 1e-6  # Pa to MPa, W/m^2 to W/mm^2

# -------------------------------------------------------------------------------------------------------------- input


class BadInput(Exception):
    """One line for the user: which file, and what is wrong with it."""


def read_columns(path, required, text=(), undefined=()):
    """Columns of a CSV file by name: numpy arrays of numbers, lists of strings for those named in text.

    Numbers must be finite, except in the columns named in undefined.
    """
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        reason = getattr(error, "strerror", None) or error
        raise BadInput(f"{path}: cannot be read ({reason}); run paper_cases first") from None
    if len(rows) < 2:
        raise BadInput(f"{path}: no data")
    missing = [name for name in required if name not in rows[0]]
    if missing:
        raise BadInput(f"{path}: column {missing[0]} is missing")
    for number, row in enumerate(rows[1:], start=2):
        if len(row) != len(rows[0]):
            raise BadInput(f"{path}:{number}: {len(row)} values instead of {len(rows[0])}")
    columns = {}
    for name in required:
        index = rows[0].index(name)
        values = [row[index] for row in rows[1:]]
        if name in text:
            columns[name] = values
            continue
        columns[name] = np.empty(len(values))
        for k, value in enumerate(values):
            try:
                columns[name][k] = float(value)
            except ValueError:
                raise BadInput(f"{path}:{k + 2}: {name} = '{value}' is not a number") from None
            if name not in undefined and not math.isfinite(columns[name][k]):
                raise BadInput(f"{path}:{k + 2}: {name} = {value} is not finite")
    return columns


class Fields:
    """One result: fields over the patch, cell by cell, and along y, strip by strip."""

    def __init__(self, directory, part, case, variant):
        self.variant = variant
        self.label = variant.profile_label if part is PROFILES else variant.ellipse_label
        stem = f"{part.key}_{case.key}_{variant.key}"
        if variant is EXACT:
            self.__read_rectangles(directory, stem)
        else:
            self.__read_strips(directory, stem)
        self.total_power = float(np.sum(self.strip_power * self.strip_width))

    def __read_strips(self, directory, stem):
        strips = read_columns(directory / f"{stem}_strips.csv", STRIP_COLUMNS)
        path = directory / f"{stem}_cells.csv"
        cells = read_columns(path, ("strip",) + CELL_COLUMNS)
        number_of, count = np.unique(cells["strip"], return_counts=True)
        if not np.array_equal(number_of, np.arange(len(strips["y_m"]))):
            raise BadInput(f"{path}: its strips are not those of {stem}_strips.csv")
        trail, lead = strips["x_trail_m"], strips["x_lead_m"]
        self.__set_cells(cells, ((lead - trail) / count)[cells["strip"].astype(int)])
        self.__set_strips(strips, trail, lead, strips["peak_pressure_Pa"])

    def __read_rectangles(self, directory, stem):
        strips = read_columns(directory / f"{stem}_strips.csv", ("y_m", "width_m", "power_W_per_m"))
        path = directory / f"{stem}_cells.csv"
        # Where nothing presses, the fatigue index is 0/0.
        cells = read_columns(path, CELL_COLUMNS + ("length_m",), undefined=("fatigue_index",))
        loaded = cells["pressure_Pa"] > 0.0
        cells = {name: values[loaded] for name, values in cells.items()}
        if not np.isfinite(cells["fatigue_index"]).all():
            raise BadInput(f"{path}: a fatigue_index under pressure is not finite")
        rows = [np.isclose(cells["y_m"], y, rtol=0.0, atol=0.25 * width)
                for y, width in zip(strips["y_m"], strips["width_m"])]
        touched = np.array([row.any() for row in rows])
        if not touched.any():
            raise BadInput(f"{path}: no cell under pressure lies in a strip of {stem}_strips.csv")
        rows = [row for row in rows if row.any()]
        strips = {name: values[touched] for name, values in strips.items()}
        half = 0.5 * cells["length_m"]
        trail = np.array([(cells["x_m"] - half)[row].min() for row in rows])
        lead = np.array([(cells["x_m"] + half)[row].max() for row in rows])
        self.__set_cells(cells, cells["length_m"])
        self.__set_strips(strips, trail, lead, np.array([cells["pressure_Pa"][row].max() for row in rows]))

    def __set_cells(self, cells, length):
        y0, y1 = cells["y_m"] - 0.5 * cells["width_m"], cells["y_m"] + 0.5 * cells["width_m"]
        x0, x1 = cells["x_m"] - 0.5 * length, cells["x_m"] + 0.5 * length
        self.corners = MILLI * np.stack([np.stack([y0, x0], 1), np.stack([y1, x0], 1),
                                         np.stack([y1, x1], 1), np.stack([y0, x1], 1)], 1)
        self.pressure = cells["pressure_Pa"]
        self.power_density = cells["power_W_per_m2"]
        self.fatigue_index = cells["fatigue_index"]

    def __set_strips(self, strips, trail, lead, peak):
        self.strip_y, self.strip_width = strips["y_m"], strips["width_m"]
        self.strip_power = strips["power_W_per_m"]
        self.strip_trail, self.strip_lead, self.strip_peak = trail, lead, peak

    @property
    def borders(self):
        """Lateral borders of the patch [m]."""
        return (self.strip_y[0] - 0.5 * self.strip_width[0], self.strip_y[-1] + 0.5 * self.strip_width[-1])

    @property
    def outline(self):
        """Border of the strips as (y, x) in mm: straight at their ends, so stepped."""
        left, right = self.strip_y - 0.5 * self.strip_width, self.strip_y + 0.5 * self.strip_width
        y = np.stack([left, right], 1).ravel()
        lead, trail = np.repeat(self.strip_lead, 2), np.repeat(self.strip_trail, 2)
        return (MILLI * np.concatenate([y, y[::-1], y[:1]]), MILLI * np.concatenate([lead, trail[::-1], lead[:1]]))

    @property
    def equivalent_double_ellipse(self):
        """a [m], b [m] and psi: the paper's criteria (1) equal area, (2b) equal width, (3) origin at first contact."""
        first, last = self.borders
        b = 0.5 * (last - first)
        a = np.sum((self.strip_lead - self.strip_trail) * self.strip_width) / (math.pi * b)
        return a, b, 0.5 * (first + last) / b


def read_part(directory, part):
    """All results of a part: {case: [exact if present, variants]}."""
    results = {}
    for case in part.cases:
        results[case] = [Fields(directory, part, case, variant) for variant in VARIANTS]
        stem = f"{part.key}_{case.key}_{EXACT.key}"
        if (directory / f"{stem}_cells.csv").exists():
            results[case].insert(0, Fields(directory, part, case, EXACT))
    return results


# ----------------------------------------------------------------------------------------------------------- drawing


def use_style():
    plt.rcParams.update({
        "font.size": 11, "axes.titlesize": 11, "axes.labelsize": 11, "legend.fontsize": 10, "figure.titlesize": 13,
        "figure.dpi": 100, "savefig.dpi": 160, "axes.linewidth": 0.8, "lines.linewidth": 1.8,
    })


def number(value, form):
    """Formatted with a minus sign, not a hyphen."""
    return format(value, form).replace("-", "\N{MINUS SIGN}")


def save(figure, directory, name):
    path = directory / f"{name}.png"
    figure.draw_without_rendering()  # the layout settles in the second pass: colour bars change with their ticks
    figure.savefig(path, metadata={"Software": None})
    plt.close(figure)
    return path


def draw_cells(axes, fields, values, colours, limits):
    """One quadrilateral per cell, and the outline of the patch."""
    cells = PolyCollection(fields.corners, array=values, cmap=colours, edgecolors="face", linewidths=0.25)
    cells.set_clim(*limits)
    axes.add_collection(cells)
    axes.plot(*fields.outline, color="black", linewidth=1.0)
    axes.plot(0.0, 0.0, "+", color="black", markersize=7, markeredgewidth=1.0)
    return cells


def patch_limits(results, room_for_arrow):
    """Common axis limits in mm of all patches, with a margin, and room for the arrow beside them."""
    outlines = [fields.outline for row in results.values() for fields in row]
    y = np.concatenate([outline[0] for outline in outlines])
    x = np.concatenate([outline[1] for outline in outlines])
    margin = 0.06 * np.ptp(x)
    return (y.min() - margin, y.max() + margin + room_for_arrow * np.ptp(x)), (x.min() - margin, x.max() + margin)


def mark_rolling(axes):
    """An arrow along +x at the right border; particles enter the patch where it points."""
    y = axes.get_xlim()[1] - 0.11 * np.ptp(axes.get_ylim())
    low, high = axes.get_ylim()
    axes.annotate("", xy=(y, high - 0.08 * (high - low)), xytext=(y, low + 0.38 * (high - low)),
                  arrowprops={"arrowstyle": "-|>", "color": "black", "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0})
    axes.text(y, low + 0.34 * (high - low), "rolling", rotation=90, ha="center", va="top", fontsize=9)


def draw_maps(directory, part, results, name, title, note, bar_label, values_of, caption_of, colours, limits_of):
    """One row per case, one panel per variant, one colour scale per row."""
    columns = max(len(row) for row in results.values())
    y_limits, x_limits = patch_limits(results, 0.2)
    panel_width = 3.7 if part is PROFILES else 3.1
    row_height = panel_width * np.ptp(x_limits) / np.ptp(y_limits) + 1.15
    foot_height = 0.15 + 0.2 * len(note.splitlines())
    figure = plt.figure(figsize=(panel_width * columns + 1.7, row_height * len(results) + 0.3 + foot_height), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.06, h_pad=0.05)
    figure.suptitle(title)
    *rows, foot = figure.subfigures(len(results) + 1, 1, height_ratios=[row_height] * len(results) + [foot_height])
    foot.text(0.5, 0.5, note, ha="center", va="center", fontsize=10)
    for row, (case, fields_of_case) in zip(rows, results.items()):
        row.suptitle(case.title, fontsize=12)
        panels = np.atleast_1d(row.subplots(1, columns, sharex=True, sharey=True))
        limits, extend = limits_of(fields_of_case)
        for panel, fields in zip(panels, fields_of_case):
            cells = draw_cells(panel, fields, values_of(fields), colours, limits)
            panel.set(xlim=y_limits, ylim=x_limits, aspect="equal", title=f"{fields.label}\n{caption_of(fields)}")
            panel.set_xlabel(part.lateral_label)
            panel.xaxis.set_major_locator(MultipleLocator(5.0))
            panel.yaxis.set_major_locator(MultipleLocator(2.0))
            mark_rolling(panel)
        for panel in panels[len(fields_of_case):]:
            panel.set_visible(False)
        panels[0].set_ylabel("x [mm]")
        row.colorbar(cells, ax=list(panels), label=bar_label, extend=extend, shrink=0.95, aspect=14, pad=0.015)
    return save(figure, directory, name)


def draw_power_density(directory, part, results):
    def values(fields):
        return MEGA * np.ma.masked_less_equal(fields.power_density, 1e-3 * fields.power_density.max())

    def limits(fields_of_case):
        return (0.0, MEGA * max(fields.power_density.max() for fields in fields_of_case)), "neither"

    return draw_maps(directory, part, results, f"{part.key}_power_density",
                     f"Where the patch dissipates: {part.title}",
                     "Frictional power density at V = 1 m/s. Grey: adhesion, no power. Cross: initial contact point.\n"
                     "A strip's first slipping cell holds all slid since the onset, half a cell to one and a half:\n"
                     "hence single dark or light cells along the border of adhesion.",
                     "power density [W/mm²]", values, lambda fields: f"{fields.total_power:.2f} W in total",
                     POWER_COLOURS, limits)


def draw_fatigue_index(directory, part, results):
    # The index tends to minus infinity at the border of the patch, where the pressure vanishes and the yield limit does
    # not. The scale ends at the median, so that the half of the cells near damage are told apart.
    everything = [fields.fatigue_index for row in results.values() for fields in row]
    clip = max(-np.median(np.concatenate(everything)), max(values.max() for values in everything), 0.05)
    clip = math.ceil(10.0 * clip) / 10.0
    return draw_maps(directory, part, results, f"{part.key}_fatigue_index",
                     f"Local fatigue index: {part.title}",
                     f"Red: damage expected (FI > 0). Scale clipped at ±{clip:.1f}: FI tends to −∞ at the border, where "
                     "$p_n$ vanishes. Cross: initial contact point.",
                     "FI(x, y) [-]", lambda fields: fields.fatigue_index,
                     lambda fields: f"largest FI = {number(fields.fatigue_index.max(), '+.3f')}",
                     plt.get_cmap("RdBu_r"), lambda fields_of_case: ((-clip, clip), "min"))


def draw_power_per_width(directory, part, results):
    figure, panels = plt.subplots(len(results), 1, sharex=True, figsize=(8.0, 3.3 * len(results) + 0.6),
                                  layout="constrained")
    figure.suptitle(f"Frictional power across the patch: {part.title}, V = 1 m/s")
    for axes, (case, fields_of_case) in zip(panels, results.items()):
        for fields in fields_of_case:
            first, last = fields.borders
            y = np.concatenate([[first], fields.strip_y, [last]])
            power = np.concatenate([[0.0], fields.strip_power, [0.0]])
            axes.plot(MILLI * y, power / MILLI, fields.variant.line, color=fields.variant.colour,
                      zorder=3 if fields.variant is EXACT else 2, label=f"{fields.label}: {fields.total_power:.2f} W")
        axes.set(title=case.title, ylabel="power per width [W/mm]")
        axes.set_ylim(0.0, 1.12 * axes.dataLim.ymax)
        axes.axvline(0.0, color="0.6", linewidth=0.8, zorder=1)
        axes.grid(True, color="0.9", linewidth=0.7)
        axes.legend(loc="upper right" if part is PROFILES else "upper left", framealpha=0.9)
    panels[-1].set_xlabel(f"{part.lateral_label}; vertical line: initial contact point")
    return save(figure, directory, f"{part.key}_power_per_width")


def shakedown_curve(utilisation):
    """Load factor p0/k above which the surface ratchets: Hertz line contact in full slip, perfect plasticity (Melan).

    0.1 % fit of 1 / max|tau_xz / p0| inside the body up to mu = 0.367; beyond it the surface decides, p0/k = 1/mu.
    """
    inside = 1.0 / (0.25 + 0.3025 * utilisation + 0.045 * utilisation**2)
    return np.where(utilisation <= 0.367, inside, 1.0 / np.maximum(utilisation, 0.367))


def draw_shakedown_map(directory):
    path = directory / "summary.csv"
    summary = read_columns(path, SUMMARY_COLUMNS, text=("part", "case", "model"))
    variants = {variant.key: variant for variant in VARIANTS + (EXACT,)}
    cases = [(part, case) for part in (PROFILES, ELLIPSE) for case in part.cases]
    points = {}
    for part, case, model, utilisation, load_factor in zip(*(summary[name] for name in SUMMARY_COLUMNS)):
        points[(part, case, model)] = (utilisation, load_factor)
    for part, case in cases:
        for variant in VARIANTS:
            if (part.key, case.key, variant.key) not in points:
                raise BadInput(f"{path}: no line for {part.key},{case.key},{variant.key}")

    figure, axes = plt.subplots(figsize=(9.0, 6.8), layout="constrained")
    utilisation = np.linspace(0.0, 0.45, 451)
    limit = shakedown_curve(utilisation)
    axes.fill_between(utilisation, limit, 6.0, color="#F3E6DE", linewidth=0)
    axes.plot(utilisation, limit, color="black", linewidth=2.0)
    inside = utilisation[(utilisation > 1.0 / 6.0) & (utilisation <= 0.367)]
    axes.plot(inside, 1.0 / inside, color="black", linewidth=1.2, linestyle=":")
    axes.text(0.02, 5.0, "ratcheting", fontsize=14)
    axes.text(0.02, 0.4, "shakedown", fontsize=14)
    axes.annotate("shakedown limit", (0.03, float(shakedown_curve(np.array(0.03)))), (0.05, 4.25),
                  fontsize=10, arrowprops={"arrowstyle": "-", "linewidth": 0.8})
    axes.annotate("FI = 0:  $p_0/k = 1/\\mu_a$", (0.20, 5.0), (0.215, 5.2), fontsize=10,
                  arrowprops={"arrowstyle": "-", "linewidth": 0.8})

    case_handles = []
    for (part, case), marker in zip(cases, CASE_MARKERS):
        for key, variant in variants.items():
            if (part.key, case.key, key) in points:
                axes.plot(*points[(part.key, case.key, key)], marker, markerfacecolor="none", markersize=8.5,
                          markeredgewidth=1.7, markeredgecolor=variant.colour, zorder=3)
        case_handles.append(Line2D([], [], linestyle="", marker=marker, markerfacecolor="none", markeredgecolor="0.3",
                                   markersize=8, markeredgewidth=1.5, label=f"{part.name}: {case.short}"))
    present = [variant for key, variant in variants.items() if any(model == key for _, _, model in points)]
    variant_handles = [Patch(color=variant.colour, label=variant.profile_label.split("+")[-1]) for variant in present]
    axes.legend(handles=variant_handles + case_handles, loc="lower right")
    axes.set(xlim=(0.0, 0.45), ylim=(0.0, 6.0), xlabel="utilisation $\\mu_a = \\sqrt{F_x^2 + F_y^2}\\,/\\,N$ [-]",
             ylabel="load factor $p_0\\,/\\,k$ [-]", title="Shakedown map of the line contact, k = 250 MPa")
    return save(figure, directory, "shakedown_map")


def draw_normal_contact(directory, results):
    """Pressure of the profile patch, its strips, and the double ellipse that stands for it in the linear theory."""
    fields_of_case = next(iter(results.values()))
    fields = next(each for each in fields_of_case if each.variant is VARIANTS[0])
    a, b, psi = fields.equivalent_double_ellipse
    angle = np.linspace(0.0, 2.0 * math.pi, 721)
    y = b * np.cos(angle)
    y *= np.where(y > 0.0, 1.0 + psi, 1.0 - psi)
    x = a * np.sin(angle)

    figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(9.0, 8.0), layout="constrained",
                                          height_ratios=(1.45, 1.0))
    figure.suptitle("Normal contact: S1002 on UIC60, centred, 80 kN, method EKP")
    pressure = MEGA * fields.pressure
    cells = draw_cells(upper, fields, pressure, plt.get_cmap("viridis"), (0.0, pressure.max()))
    borders = np.append(fields.strip_y - 0.5 * fields.strip_width, fields.borders[1])
    trail = np.append(fields.strip_trail, fields.strip_trail[-1])
    lead = np.append(fields.strip_lead, fields.strip_lead[-1])
    upper.vlines(MILLI * borders, MILLI * trail, MILLI * lead, color="white", linewidth=0.5, alpha=0.6)
    ellipse, = upper.plot(MILLI * y, MILLI * x, "--", color="#D55E00", linewidth=2.0)
    upper.set(xlim=(MILLI * fields.borders[0] - 1.2, MILLI * fields.borders[1] + 2.6), ylabel="x [mm]")
    upper.set_aspect("equal", adjustable="datalim")  # the lateral axes of both panels stay aligned
    upper.legend([Line2D([], [], color="black", linewidth=1.0), ellipse],
                 ["patch", f"equivalent double ellipse: a = {MILLI * a:.2f} mm, b = {MILLI * b:.2f} mm, "
                 f"$\\psi$ = {number(psi, '.3f')}"],
                 loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    mark_rolling(upper)
    figure.colorbar(cells, ax=upper, label="pressure [MPa]", aspect=18, pad=0.015)

    for each in fields_of_case:
        if each.variant is not VARIANTS[1]:  # EQ.L has the pressure of SDEC: both are EKP's
            label = "EKP" if each.variant is VARIANTS[0] else each.label.split("+")[0]
            label = {"HZ": "HZ: semi-elliptic over the equivalent ellipse"}.get(label, label)
            border = each.borders
            lower.plot(MILLI * np.concatenate([border[:1], each.strip_y, border[1:]]),
                       MEGA * np.concatenate([[0.0], each.strip_peak, [0.0]]), each.variant.line,
                       color=each.variant.colour, label=label)
    lower.axvline(0.0, color="0.6", linewidth=0.8, zorder=1)
    lower.set(xlabel="y [mm]  (flange side: y < 0; vertical line, cross: initial contact point)",
              ylabel="largest pressure\nof the strip [MPa]")
    lower.set_ylim(0.0, 1.25 * lower.dataLim.ymax)
    lower.grid(True, color="0.9", linewidth=0.7)
    lower.legend(loc="upper right", ncols=2)
    return save(figure, directory, "normal_contact")


def main():
    directory = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    use_style()
    try:
        profiles, ellipse = read_part(directory, PROFILES), read_part(directory, ELLIPSE)
        written = [draw_normal_contact(directory, profiles)]
        for part, results in ((PROFILES, profiles), (ELLIPSE, ellipse)):
            written.append(draw_power_density(directory, part, results))
            written.append(draw_power_per_width(directory, part, results))
            written.append(draw_fatigue_index(directory, part, results))
        written.append(draw_shakedown_map(directory))
    except BadInput as error:
        sys.exit(f"draw_paper_figures: {error}")
    except OSError as error:
        sys.exit(f"draw_paper_figures: cannot write {error.filename}: {error.strerror}")
    for path in written:
        print(path)


if __name__ == "__main__":
    main()
