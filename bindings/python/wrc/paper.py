"""The source paper, table by table and figure by figure, beside its own values and CONTACT's.

    python -m wrc.paper [FOLDER] [--formats png pdf] [--dpi 300] [--no-figures]

Liu and Bruni, "Application of the extended FASTSIM for non-Hertzian contacts towards the prediction of wear and rolling contact fatigue
of wheel/rail systems", Proc. IMechE Part F 238(4) (2024) 427-436. Prints tables 1 and 2 with both traction bounds, the readings of EKP
that were tried, and where the paper contradicts itself. Draws figures 1 to 9 into the folder [out] (pip install wrc[plot]).

EKP's text (Liu, Bruni, Vollebregt, VSD 54 (2016)) was not at hand: EKP is our reading of it everywhere here.
"""
from __future__ import annotations

import argparse
import dataclasses
import pathlib
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple

import numpy as np

import wrc

# ----------------------------------------------------------------------------------------------- the paper's numbers

SHEAR_MODULUS, POISSON, YIELD, FRICTION, LOAD = 80e9, 0.25, 250e6, 0.35, 80e3  # Pa, -, Pa (k), -, N
STEEL: Any = {"shear_modulus": SHEAR_MODULUS, "poisson": POISSON, "shear_yield": YIELD}
SEMI_AXES, SHAPE, PEAK = (4.25e-3, 6.375e-3), 0.4, 300e6  # of the exact double ellipse [m], psi, p0 [Pa], which is not printed
PAPER_PATCH = "a = 5.8 mm, b = 10.3 mm, psi = -0.30"
BOUNDS = {"parabola": wrc.TractionBound.PARABOLIC, "pressure": wrc.TractionBound.ELLIPTIC}  # paper eq. 9; friction x pressure


@dataclasses.dataclass(frozen=True)
class Case:
    """Creepages at 1 m/s and total powers [W]: CONTACT's (25.2, run for this project), the paper's of CONTACT, SDEC, EQ.L, EQ.E."""

    name: str
    longitudinal: float
    lateral: float
    spin: float
    contact: float
    paper: Tuple[float, ...] = ()

    def creepage(self) -> wrc.Creepage:
        return wrc.Creepage(longitudinal=self.longitudinal, lateral=self.lateral, spin=self.spin)


PROFILE_CASES = (Case("Case 1, pure spin", 0, 0, -0.5, 68.68, (68.6, 71.1, 76.5, 62.5)),
                 Case("Case 2, combined", -0.49e-3, -0.22e-3, 0.29, 30.60, (30.4, 32.5, 40.5, 26.6)))
ELLIPSE_CASES = (Case("Case 1 as printed, spin 1.0", 0, 0, 1.0, 19.1),
                 Case("Case 1 of 10.3 W, spin 0.585", 0, 0, 0.585, 10.31, (10.3, 11.5, 14.4, 15.4)),
                 Case("Case 2, combined", -0.49e-3, -0.22e-3, 0.29, 6.04, (5.99, 6.65, 7.34, 7.55)))
METHODS: Tuple[Tuple[str, wrc.NormalMethod, Any], ...] = (
    ("FASTSIM-SDEC", wrc.NormalMethod.EKP, "FASTSIM-SDEC"), ("FASTSIM-EQ.L", wrc.NormalMethod.EKP, "FASTSIM-EQ.L"),
    ("FASTSIM-EQ.E", wrc.NormalMethod.EKP, "FASTSIM-EQ.E"))  # EQ.E: the paper's HZ, on the ellipse equivalent to EKP's patch
OWN = ("strip FASTSIM", wrc.NormalMethod.STRIP_HALFSPACE, "strip FASTSIM")  # the library's default, not of the paper

INCONSISTENT = (
    "Table 1, Case 1: spin 1.0 1/m and 10.3 W do not belong together. CONTACT gives 19.1 W there, and 10.3 W at 0.585 1/m.",
    "Table 1: the watts of all three methods are nearer to those of the bound friction x pressure than to those of eq. 9's parabola.",
    "Figure 4: EQ.E cannot reach the shakedown limit. The load factor of 300 MPa is 1.2, the limit there 3.1; the peak pressure is not "
    "printed, and 300 MPa give the watts of Case 2.",
    "Eq. 9 taken by the letter, mu 2 N (x_l^2 - x^2) / (pi a^3 b), integrates over the patch on S1002/UIC60 to {literal:.3f} mu N. Here the "
    "parabola is scaled to mu N.",
    "Figures 7 and 9: with eq. 9 powers do not depend on how the pressure spreads over the strips. EKP's pressure cannot be behind the "
    "agreement at the flange side then.")


# ------------------------------------------------------------------------------------------------------- computing

@dataclasses.dataclass
class Result:
    """One solution: numbers, and fields over strips (rows) and cells [SI]."""

    name: str
    bound: str
    numbers: Dict[str, float]
    y: np.ndarray
    width: np.ndarray
    centre: np.ndarray
    half: np.ndarray
    x: np.ndarray  # of cells, as the next three; NaN: no pressure there
    pressure: np.ndarray
    power: np.ndarray
    index: np.ndarray
    length: np.ndarray  # of a strip's cells
    point: Tuple[float, float] = (0.0, 0.0)  # of the shakedown map: utilisation, load factor

    @property
    def strip_power(self) -> np.ndarray:
        """Frictional power per width [W/m]."""
        return np.asarray(np.nansum(self.power, axis=1) * self.length)


def contact_of(normal: wrc.NormalMethod, method: Any, bound: str) -> wrc.Contact:
    config = wrc.use(wrc.Config(wheel="S1002", rail="UIC60_BENCHMARK", wheel_material=STEEL, rail_material=STEEL), method)
    config.normal.method = normal
    if config.tangential.method == wrc.TangentialMethod.FASTSIM:  # others have friction x pressure
        config.tangential.bound = BOUNDS[bound]
    contact = wrc.Model(config).contact()
    contact.planar_geometry(wrc.PlanarPose())
    return contact


def solved(contact: wrc.Contact, name: str, bound: str, case: Case, ellipse: Optional[wrc.Ellipse] = None) -> Result:
    """The tangential problem on the contact's patch, or on that double ellipse."""
    forces = contact.planar_tangential(case.creepage(), wrc.Friction(coefficient=FRICTION), ellipse)
    found, damage, region = contact.fields(), contact.damage(wrc.ALL_REGIONS), contact.region(0)
    numbers = {"a": region.ellipse.a, "b": region.ellipse.b, "psi": region.ellipse.psi, "area": region.area, "peak": region.peak_pressure,
               "fx": forces.fx, "fy": forces.fy, "mz": forces.mz, "power": forces.power}
    half = found["STRIP_HALF_LENGTH"]
    return Result(name, bound, numbers, found["STRIP_Y"], found["STRIP_WIDTH"], found["STRIP_CENTRE"], half, found["X"], found["PRESSURE"],
                  found["POWER_DENSITY"], found["FATIGUE_INDEX"], 2.0 * half / found["X"].shape[1], (damage.utilisation, damage.load_factor))


def exact(grid: wrc.Grid, pressure: np.ndarray, case: Case) -> Result:
    """Kalker's exact theory under a given pressure, in CONTACT's collocation."""
    solution, found = wrc.exact.rolling(grid, pressure, friction=FRICTION, creepage=case.creepage(), collocation="REFERENCE",
                                        wheel_material=STEEL, rail_material=STEEL)
    x, y = wrc.exact.cells(grid)
    rows = (pressure > 0).any(axis=1)
    loaded = np.where(pressure > 0, 1.0, np.nan)[rows]
    x, y, tractions = x[rows], y[rows, 0], np.hypot(found["traction_x"], found["traction_y"])[rows]
    power = -(found["slip_x"] * found["traction_x"] + found["slip_y"] * found["traction_y"])[rows] * loaded
    with np.errstate(divide="ignore"):
        index = (tractions - YIELD) / pressure[rows] * loaded
    half = np.array([_half_length(each, row) for each, row in zip(x, pressure[rows])])
    load = float(np.sum(pressure) * grid.dx * grid.dy)
    b = 0.5 * (y[-1] - y[0] + grid.dy)
    area = float(np.sum(pressure > 0)) * grid.dx * grid.dy
    numbers = {"a": area / (np.pi * b), "b": b, "psi": 0.5 * (y[-1] + y[0]) / b, "area": area, "peak": float(pressure.max()),
               "fx": solution.fx, "fy": solution.fy, "mz": solution.mz, "power": solution.power}
    ones = np.ones(len(y))
    return Result("exact (wrc)", "pressure", numbers, y, grid.dy * ones, 0.0 * ones, half, x, pressure[rows] * loaded, power, index,
                  grid.dx * ones, (float(np.hypot(solution.fx, solution.fy)) / load, float(pressure.max()) / YIELD))


def _half_length(x: np.ndarray, pressure: np.ndarray) -> float:
    """Of a strip from its cells: p^2 is linear in x^2 under a semi-ellipse."""
    at = pressure > 0
    if at.sum() < 4:
        return float(np.ptp(x[at]) + x[1] - x[0]) / 2
    slope, top = np.polyfit(x[at] ** 2, pressure[at] ** 2, 1)
    return float(np.sqrt(-top / slope))


def profile_results() -> Dict[Case, List[Result]]:
    """S1002 on UIC60 canted 1:40, centred, 80 kN."""
    found: Dict[Case, List[Result]] = {}
    grid = wrc.Grid(nx=50, ny=90, dx=0.3e-3, dy=0.3e-3, x0=-0.5 * 49 * 0.3e-3, y0=-16e-3)
    own = contact_of(OWN[1], OWN[2], "pressure")
    _, pressure = wrc.exact.normal(grid, own.exact_gap(grid), normal_force=LOAD, wheel_material=STEEL, rail_material=STEEL)
    for case in PROFILE_CASES:
        found[case] = [exact(grid, pressure, case)]
        for name, normal, method in METHODS:
            for bound in BOUNDS:
                contact = contact_of(normal, method, bound)
                contact.planar_normal(wrc.PlanarLoad(normal_force=LOAD))
                found[case].append(solved(contact, ("HZ+" if method == "FASTSIM-EQ.E" else "EKP+") + name, bound, case))
        own.planar_normal(wrc.PlanarLoad(normal_force=LOAD))
        found[case].append(solved(own, "half-space strips+" + OWN[0], "pressure", case))
    return found


def ellipse_results() -> Dict[Case, List[Result]]:
    """The exact double ellipse with semi-ellipsoidal pressure."""
    a, b = SEMI_AXES
    ellipse = wrc.Ellipse(a=a, b=b, psi=SHAPE, normal_force=2 / 3 * np.pi * a * b * PEAK)
    grid = wrc.Grid(nx=60, ny=60, dx=a / 30, dy=b / 30, x0=-a + a / 60, y0=-b * (1 - SHAPE) + b / 60)
    x, y = wrc.exact.cells(grid)
    pressure = PEAK * np.sqrt(np.clip(1 - (x / a) ** 2 - (y / (b * (1 + np.where(y > 0, SHAPE, -SHAPE)))) ** 2, 0, None))
    found: Dict[Case, List[Result]] = {}
    for case in ELLIPSE_CASES:
        found[case] = [exact(grid, pressure, case)]
        for name, normal, method in METHODS:
            found[case] += [solved(contact_of(normal, method, bound), name, bound, case, ellipse) for bound in BOUNDS]
        found[case].append(solved(contact_of(OWN[1], OWN[2], "pressure"), OWN[0], "pressure", case, ellipse))
    return found


# --------------------------------------------------------------------------------------------- readings of EKP's pressure

def elliptic(m: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Complete elliptic integrals K and E of the parameter m, by the arithmetic-geometric mean."""
    a, b, share, power = np.ones_like(m), np.sqrt(1 - m), m / 2, 0.5
    for _ in range(8):
        a, b, c = (a + b) / 2, np.sqrt(a * b), (a - b) / 2
        power *= 2
        share = share + power * c ** 2
    k = np.pi / (2 * a)
    return k, k * (1 - share)


def hertz_peak(along: np.ndarray, across: np.ndarray, approach: Any) -> np.ndarray:
    """Hertz's peak pressure of gaps along x^2 + across y^2 at an approach [Pa]."""
    ratio = np.maximum(along, across) / np.minimum(along, across)
    low, high = np.full_like(ratio, -12.0), np.full_like(ratio, -1e-9)  # logarithm of the shorter axis over the longer
    for _ in range(60):
        middle = (low + high) / 2
        k, e = elliptic(1 - np.exp(2 * middle))
        too_long = (e - np.exp(2 * middle) * k) / (np.exp(2 * middle) * (k - e)) > ratio
        low, high = np.where(too_long, middle, low), np.where(too_long, high, middle)
    k, e = elliptic(1 - np.exp(2 * low))
    shorter = np.sqrt(approach / np.maximum(along, across) * (e - np.exp(2 * low) * k) / ((1 - np.exp(2 * low)) * k))
    return np.asarray(approach * SHEAR_MODULUS / (1 - POISSON) / (shorter * k))


def readings() -> List[Tuple[str, List[Result]]]:
    """EKP's patch with peaks of its strips by several readings, and other normal methods; FASTSIM-SDEC, friction x pressure."""
    contact = contact_of(wrc.NormalMethod.EKP, "FASTSIM-SDEC", "pressure")
    solution = contact.planar_normal(wrc.PlanarLoad(normal_force=LOAD))
    at = contact.fields()
    y, half, width = at["STRIP_Y"], at["STRIP_HALF_LENGTH"], at["STRIP_WIDTH"]
    gap = np.interp(y, at["GAP_Y"], at["GAP_HEIGHT"])
    along = np.interp(y, at["GAP_Y"], at["GAP_CURVATURE"]) / 2
    edge = float(np.median(gap + along * half ** 2))  # the height of the gap at the patch's edge
    overlap = np.clip(solution.approach - gap, 1e-12, None)
    peaks = {"strip length (wrc's EKP)": half, "overlap inside the patch's edge": np.clip(edge - gap, 0, None), "overlap": overlap}
    for reach in (1e-3, 2e-3, 4e-3):
        across = np.array([np.polyfit(at["GAP_Y"][near] - each, at["GAP_HEIGHT"][near], 2)[0]
                           for each in y for near in [np.abs(at["GAP_Y"] - each) < reach]]).clip(1e-3)
        told = f", curvature over {1e3 * reach:g} mm"
        peaks["Hertz of the strip's overlap" + told] = hertz_peak(along, across, overlap)
        peaks["Hertz of the strip, by its length" + told] = hertz_peak(along, across, solution.approach) * half
    found = []
    for name, peak in peaks.items():
        scaled = peak * LOAD / np.sum(0.5 * np.pi * peak * half * width)
        contact.planar_regularise(wrc.PlanarStrips(y=y, width=width, centre=at["STRIP_CENTRE"], half_length=half, peak=scaled))
        found.append((name, [solved(contact, name, "pressure", case) for case in PROFILE_CASES]))
    for normal in (wrc.NormalMethod.KIK_PIOTROWSKI, wrc.NormalMethod.EKP_ELLIPSE, wrc.NormalMethod.ANALYN, wrc.NormalMethod.STRIPES,
                   wrc.NormalMethod.STRIP_HALFSPACE):
        contact = contact_of(normal, "FASTSIM-SDEC", "pressure")
        contact.planar_normal(wrc.PlanarLoad(normal_force=LOAD))
        found.append((f"method {normal}", [solved(contact, normal.name, "pressure", case) for case in PROFILE_CASES]))
    return found


def literal_bound(result: Result) -> float:
    """Integral of paper eq. 9 as it is printed, over mu N."""
    a, b = result.numbers["a"], result.numbers["b"]
    return float(8 / (3 * np.pi * a ** 3 * b) * np.sum(result.half ** 3 * result.width))


# --------------------------------------------------------------------------------------------------------- printing

def deviation(power: float, reference: float) -> str:
    return f"{100 * (power / reference - 1):+7.1f}"


def print_table(title: str, results: Dict[Case, List[Result]]) -> None:
    print(f"\n{title}\n{'case':30}{'model':34}{'bound':10}{'a':>6}{'b':>7}{'psi':>8}{'p_max':>7}{'Fx':>8}{'Fy':>8}{'Mz':>8}{'power':>8}{'dev.':>8}"
          f"{'paper':>8}{'dev.':>8}\n{'':74}{'mm':>6}{'mm':>7}{'':8}{'MPa':>7}{'N':>8}{'N':>8}{'N m':>8}{'W':>8}{'%':>8}{'W':>8}{'%':>8}")
    for case, rows in results.items():
        for k, each in enumerate(rows):
            told = each.numbers
            method = next((at for at, (name, _, _) in enumerate(METHODS) if each.name.endswith("+" + name) or each.name == name), None)
            paper = f"{case.paper[1 + method]:8.2f} {deviation(case.paper[1 + method], case.paper[0])}" if case.paper and method is not None else ""
            print(f"{'' if k else case.name:30}{each.name:34}{each.bound:10}{1e3 * told['a']:6.2f}{1e3 * told['b']:7.2f}{told['psi']:8.3f}"
                  f"{1e-6 * told['peak']:7.0f}{told['fx']:8.0f}{told['fy']:8.0f}{told['mz']:8.1f}{told['power']:8.2f} "
                  f"{deviation(told['power'], case.contact)}{paper}")
        print(f"{'':30}{'CONTACT':34}{'pressure':10}{'':52}{case.contact:8.2f}{'':8}" + (f"{case.paper[0]:8.2f}" if case.paper else ""))


def print_readings(found: Iterable[Tuple[str, List[Result]]], reference: List[Result]) -> None:
    """reference: the exact solution of both cases."""
    print(f"\nReadings of EKP: peaks of its strips, scaled to the load; FASTSIM-SDEC with friction x pressure\n{'reading':60}{'a':>6}{'b':>7}{'psi':>8}"
          f"{'p_max':>7}{'power':>8}{'':8}{'W/mm at most':>15}{'FI at most':>17}\n{'':60}{'mm':>6}{'mm':>7}{'':8}{'MPa':>7}"
          f"{'case 1':>8}{'case 2':>8}" + f"{'case 1':>8}{'case 2':>8}" + f"{'case 1':>9}{'case 2':>9}")
    for name, results in [*found, ("exact (wrc)", reference)]:
        told = results[0].numbers
        print(f"{name:60}{1e3 * told['a']:6.2f}{1e3 * told['b']:7.2f}{told['psi']:8.3f}{1e-6 * told['peak']:7.0f}"
              + "".join(f"{each.numbers['power']:8.2f}" for each in results) + "".join(f"{1e-3 * each.strip_power.max():8.2f}" for each in results)
              + "".join(f"{np.nanmax(each.index):+9.3f}" for each in results))
    print("Hertz needs a curvature above 0. Between the lobes it is below, and 0.001 1/m stand for it: the reading has no meaning there.")
    print(f"The paper: {PAPER_PATCH}; 71.1 and 32.5 W; peaks \"slightly underestimated\"; FI \"in very good agreement\" with CONTACT.")


# ---------------------------------------------------------------------------------------------------------- drawing

COLOURS = {"exact": "black", "SDEC": "#0072B2", "EQ.L": "#D55E00", "EQ.E": "#009E73", "strip": "#CC79A7"}
LINES = {"exact": "-", "SDEC": "-", "EQ.L": "--", "EQ.E": "-.", "strip": ":"}
SAYS = {"pressure": "friction × pressure", "parabola": "parabola, eq. 9"}
PAGE = 6.69  # inches: 170 mm


def key(result: Result) -> str:
    return next(each for each in COLOURS if each in result.name)


def chosen(results: Dict[Case, List[Result]], bound: str) -> Dict[Case, List[Result]]:
    """The paper's four: the exact solution, and its methods with that bound."""
    return {case: [each for each in rows if key(each) == "exact" or (each.bound == bound and key(each) != "strip")] for case, rows in results.items()}


class Pictures:
    """Draws into a folder, in every format."""

    def __init__(self, folder: pathlib.Path, formats: Sequence[str], dpi: int):
        import matplotlib
        from matplotlib.figure import Figure

        matplotlib.rcParams.update({"font.size": 7, "axes.titlesize": 7, "axes.labelsize": 7, "legend.fontsize": 6.5, "figure.titlesize": 8.5,
                                    "axes.linewidth": 0.6, "lines.linewidth": 1.2, "pdf.fonttype": 42, "svg.fonttype": "path", "svg.hashsalt": "wrc"})
        self.folder, self.formats, self.dpi, self.figure = folder, formats, dpi, Figure
        folder.mkdir(parents=True, exist_ok=True)

    def new(self, height: float, title: str) -> Any:
        made = self.figure(figsize=(PAGE, height), layout="constrained")
        made.suptitle(title)
        return made

    def save(self, figure: Any, name: str) -> None:
        nothing: Dict[str, Dict[str, Any]] = {"pdf": {"CreationDate": None}, "svg": {"Date": None}, "png": {"Software": None}}
        for each in self.formats:
            figure.savefig(self.folder / f"{name}.{each}", dpi=self.dpi, metadata=nothing.get(each))
        print(self.folder / f"{name}.{self.formats[0]}")

    def sketch(self) -> None:
        """Figure 1: a double ellipse."""
        figure = self.new(2.6, "Figure 1: a simple double-elliptic contact (SDEC)")
        axes = figure.subplots()
        angle = np.linspace(0, 2 * np.pi, 400)
        y, x = _double_ellipse(1.0, 1.5, -0.3, angle)
        axes.plot(y, x, color="black")
        left, right = -1.5 * 1.3, 1.5 * 0.7
        for at, label in ((0.0, "O: initial contact point"), (0.5 * (left + right), "mid-width")):
            axes.plot([at, at], [-1.25, 1.25], color="0.5", linewidth=0.6)
            side = 1 if at == 0 else -1
            axes.text(at + 0.04 * side, 1.12, label, ha="left" if side > 0 else "right")
        for start, end, height, label in ((left, 0.0, -1.15, "b(1 − ψ)"), (0.0, right, -1.15, "b(1 + ψ)"), (0.5 * (left + right), 0.0, 0.5, "−ψ b")):
            axes.annotate("", (end, height), (start, height), arrowprops={"arrowstyle": "<->", "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0})
            axes.text(0.5 * (start + end), height + 0.05, label, ha="center", bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5})
        axes.annotate("", (left - 0.15, 1.0), (left - 0.15, -1.0), arrowprops={"arrowstyle": "<->", "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0})
        axes.text(left - 0.2, 0.0, "2a", va="center", ha="right")
        axes.annotate("", (0.0, 0.9), (0.0, 0.0), arrowprops={"arrowstyle": "->", "shrinkA": 0})
        axes.annotate("", (right + 0.6, 0.0), (0.0, 0.0), arrowprops={"arrowstyle": "->", "shrinkA": 0})
        axes.text(0.05, 0.75, "x, rolling", ha="left")
        axes.text(right + 0.65, 0.0, "y", va="center")
        axes.set(aspect="equal", xlim=(left - 0.7, right + 0.9), ylim=(-1.35, 1.35))
        axes.axis("off")
        self.save(figure, "figure_1")

    def maps(self, name: str, title: str, results: Dict[Case, List[Result]], values: str, outlines: bool = False) -> None:
        """Fields over the patches: a row of panels for each case, one scale a row."""
        figure = self.new(0.45 + 1.3 * len(results), title)
        columns = len(next(iter(results.values())))
        panels = figure.subplots(len(results), columns, sharex=True, sharey=True, squeeze=False)
        for row, (case, solutions) in zip(panels, results.items()):
            have = [getattr(each, values) * (1e-6 if values == "power" else 1.0) for each in solutions]
            low, high, colours = _scale(values, have)
            for axes, each, shown in zip(row, solutions, have):
                mesh = _draw(axes, each, np.where(shown > 1e-3 * high, shown, np.nan) if values == "power" else shown, low, high, colours)
                total = f"{each.numbers['power']:.2f} W" if values == "power" else f"max {np.nanmax(each.index):+.3f}".replace("-", "−")
                axes.set_title(f"{each.name}\n{total}")
                if outlines and key(each) in ("SDEC", "EQ.L"):
                    angle = np.linspace(0, 2 * np.pi, 400)
                    a, b, psi = (each.numbers[name] for name in ("a", "b", "psi"))
                    y, x = _double_ellipse(a, b, psi if key(each) == "SDEC" else 0.0, angle)
                    axes.plot(1e3 * (y + (0.0 if key(each) == "SDEC" else psi * b)), 1e3 * x, color="red", linewidth=0.9)
            row[0].set_ylabel(case.name.replace(", ", "\n") + "\nx [mm]")
            bar = figure.colorbar(mesh, ax=list(row), aspect=14, pad=0.01, extend="neither" if values == "power" else "min")
            bar.set_label("W/mm²" if values == "power" else "FI [-]")
        for axes in panels[-1]:
            axes.set_xlabel("y [mm]")
        self.save(figure, name)

    def across(self, name: str, title: str, results: Dict[Case, List[Result]]) -> None:
        """Frictional power per width: both bounds side by side."""
        figure = self.new(0.35 + 1.7 * len(results), title)
        panels = figure.subplots(len(results), 2, sharex=True, sharey="row")
        for row, (case, rows) in zip(panels, results.items()):
            for axes, bound in zip(row, BOUNDS):
                for each in rows:
                    if key(each) in ("exact", "strip") or each.bound == bound:
                        ends = [each.y[0] - each.width[0] / 2, each.y[-1] + each.width[-1] / 2]
                        axes.plot(1e3 * np.array([ends[0], *each.y, ends[1]]), 1e-3 * np.array([0, *each.strip_power, 0]), LINES[key(each)],
                                  color=COLOURS[key(each)], label=f"{each.name}: {each.numbers['power']:.2f} W")
                axes.axvline(0, color="0.7", linewidth=0.6)
                axes.set_title(f"{case.name}; FASTSIM's bound: {SAYS[bound]}" if axes is row[0] else SAYS[bound])
                axes.legend()
            row[0].set_ylabel("W/mm")
            row[0].set_ylim(0, None)
        for axes in panels[-1]:
            axes.set_xlabel("y [mm]; flange side, where there is one: y < 0")
        self.save(figure, name)

    def shakedown(self, name: str, title: str, results: Dict[Case, List[Result]]) -> None:
        """The map of the line contact, and its part with the results beside."""
        figure = self.new(2.9, title)
        whole, near = figure.subplots(1, 2)
        utilisation = np.linspace(0, 0.6, 301)
        limit = [wrc.shakedown_limit(each) for each in utilisation]
        points = np.array([each.point for rows in results.values() for each in rows])
        for axes in (whole, near):
            axes.plot(utilisation, limit, color="black")
            axes.fill_between(utilisation, limit, 6, color="#F3E6DE", linewidth=0)
            for rows, marker in zip(results.values(), "osD"):
                for each in rows:
                    axes.plot(*each.point, marker, color=COLOURS[key(each)], markersize=5, markeredgewidth=1,
                              markerfacecolor="none" if each.bound == "parabola" else COLOURS[key(each)])
            axes.set(xlabel="utilisation $\\sqrt{F_x^2 + F_y^2}/N$", ylabel="load factor $p_0/k$")
        whole.set(xlim=(0, 0.45), ylim=(0, 6))
        whole.text(0.02, 5.3, "ratcheting")
        whole.text(0.02, 0.4, "shakedown")
        margin = 0.12 * np.ptp(points, axis=0) + [0.005, 0.05]
        near.set(xlim=(points[:, 0].min() - margin[0], points[:, 0].max() + margin[0]), ylim=(points[:, 1].min() - margin[1], points[:, 1].max() + margin[1]))
        models = {key(one): one for rows in results.values() for one in rows}
        if np.ptp(points[:, 1]) < 1e-2:  # one load factor: models one below the other
            near.clear()
            for rows, marker in zip(results.values(), "osD"):
                for each in rows:
                    near.plot(each.point[0], list(models).index(key(each)), marker, color=COLOURS[key(each)], markersize=5,
                              markerfacecolor="none" if each.bound == "parabola" else COLOURS[key(each)])
            near.set(yticks=range(len(models)), yticklabels=[each.name for each in models.values()], xlabel="utilisation $\\sqrt{F_x^2 + F_y^2}/N$",
                     ylim=(len(models) - 0.5, -0.5))
            near.grid(axis="x", alpha=0.4)
        near.set_title("the results: filled friction × pressure, open parabola")
        for each in models.values():
            whole.plot([], [], "s", color=COLOURS[key(each)], label=each.name, markersize=5)
        for case, marker in zip(results, "osD"):
            whole.plot([], [], marker, color="0.4", markerfacecolor="none", label=case.name, markersize=5)
        whole.legend(loc="upper right")
        self.save(figure, name)

    def ekp(self, found: List[Tuple[str, List[Result]]], reference: Result) -> None:
        """Readings of EKP: peaks and powers across the patch, Case 1."""
        figure = self.new(3.3, "Readings of EKP's pressure on its patch: S1002/UIC60, Case 1, FASTSIM-SDEC with friction × pressure")
        panels = figure.subplots(1, 2)
        shown = [("exact (wrc)", reference)] + [(name, results[0]) for name, results in found
                                                if "EKP)" in name or "edge" in name or "4 mm" in name or "STRIPES" in name or "STRIP_HALF" in name]
        for (name, each), colour in zip(shown, ("black", "#0072B2", "#56B4E9", "#D55E00", "#E69F00", "#009E73", "#CC79A7")):
            panels[0].plot(1e3 * each.y, 1e-6 * np.nanmax(each.pressure, axis=1), color=colour, linewidth=1.8 if colour == "black" else 1.1)
            panels[1].plot(1e3 * each.y, 1e-3 * each.strip_power, color=colour, label=name, linewidth=1.8 if colour == "black" else 1.1)
        panels[0].set(ylabel="largest pressure of a strip [MPa]", xlabel="y [mm]")
        panels[1].set(ylabel="W/mm", xlabel="y [mm]", ylim=(0, None))
        panels[1].legend(loc="upper right", bbox_to_anchor=(1.0, -0.16), ncol=2)
        self.save(figure, "ekp_readings")


def _double_ellipse(a: float, b: float, psi: float, angle: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    y = b * np.cos(angle)
    return y * np.where(y > 0, 1 + psi, 1 - psi), a * np.sin(angle)


def _scale(values: str, have: List[np.ndarray]) -> Tuple[float, float, Any]:
    """Ends of a row's scale, and its colours: of indices from where a third lies below, with white at 0 where damage begins."""
    from matplotlib import colormaps, colors

    highest = max(float(np.nanmax(each)) for each in have)
    if values == "power":
        colours = colors.LinearSegmentedColormap.from_list("power", colormaps["magma_r"](np.linspace(0.08, 0.95, 256)))
        return 0.0, highest, colours.with_extremes(bad="#D4D4D4")  # sticks: no power
    lowest = float(np.nanquantile(np.concatenate([each.ravel() for each in have]), 0.35))
    if highest < 0:
        return lowest, highest, colormaps["viridis"]
    share = -lowest / (highest - lowest)
    cold, warm = colormaps["Blues_r"](np.linspace(0.15, 1, 256)), colormaps["Reds"](np.linspace(0.25, 0.9, 256))
    first = int(round(256 * share))
    return lowest, highest, colors.ListedColormap(np.vstack([cold[np.linspace(0, 255, first).astype(int)], warm[np.linspace(0, 255, 256 - first).astype(int)]]))


def _draw(axes: Any, result: Result, values: np.ndarray, low: float, high: float, colours: Any) -> Any:
    """Cells, the outline of the patch, and a cross at the initial contact point."""
    from matplotlib.collections import PolyCollection

    at = ~np.isnan(result.pressure)
    y0, y1 = (np.broadcast_to((result.y + sign * result.width / 2)[:, None], result.x.shape)[at] for sign in (-1, 1))
    x0, x1 = (result.x[at] + sign * np.broadcast_to(result.length[:, None] / 2, result.x.shape)[at] for sign in (-1, 1))
    corners: Any = 1e3 * np.stack([np.stack(pair, 1) for pair in ((y0, x0), (y1, x0), (y1, x1), (y0, x1))], 1)
    cells = PolyCollection(corners, array=np.ma.masked_invalid(values[at]), cmap=colours, edgecolors="face", linewidths=0.2, rasterized=True)
    cells.set_clim(low, high)
    axes.add_collection(cells)
    ends = result.y[0] - result.width[0] / 2, result.y[-1] + result.width[-1] / 2
    y, lead, trail = np.array([ends[0], *result.y, ends[1]]), result.centre + result.half, result.centre - result.half
    closed = np.array([result.centre[0], *lead, result.centre[-1], *trail[::-1], result.centre[0]])
    axes.plot(1e3 * np.array([*y, *result.y[::-1], y[0]]), 1e3 * closed, color="black", linewidth=0.7)
    axes.plot(0, 0, "+", color="black", markersize=4, markeredgewidth=0.7)
    axes.set_aspect("equal")
    axes.margins(0.03)
    return cells


def draw(pictures: Pictures, ellipse: Dict[Case, List[Result]], profiles: Dict[Case, List[Result]],
         found: List[Tuple[str, List[Result]]]) -> None:
    pictures.sketch()
    for bound in BOUNDS:
        for number, results, values, what in ((2, ellipse, "power", "frictional power, SDEC"), (5, ellipse, "index", "local fatigue index, SDEC"),
                                              (6, profiles, "power", "frictional power, S1002/UIC60"),
                                              (9, profiles, "index", "local fatigue index, S1002/UIC60")):
            note = {2: "grey sticks", 6: "red: equivalent double ellipse, ellipse"}.get(number, "the scale's lower end is cut")
            pictures.maps(f"figure_{number}_{bound}", f"Figure {number}: {what}; bound: {SAYS[bound]}; {note}", chosen(results, bound), values, number == 6)
    pictures.across("figure_3", "Figure 3: frictional power across the patch, SDEC", ellipse)
    pictures.across("figure_7", "Figure 7: frictional power across the patch, S1002/UIC60", profiles)
    pictures.shakedown("figure_4", "Figure 4: shakedown map, SDEC, p₀ = 300 MPa", ellipse)
    pictures.shakedown("figure_8", "Figure 8: shakedown map, S1002/UIC60", profiles)
    pictures.ekp(found, profiles[PROFILE_CASES[0]][0])


def main(arguments: Optional[Sequence[str]] = None) -> None:
    parser = argparse.ArgumentParser(prog="python -m wrc.paper", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", default="out", type=pathlib.Path)
    parser.add_argument("--formats", nargs="+", default=["png", "pdf"], choices=["png", "pdf", "svg"])
    parser.add_argument("--dpi", default=300, type=int, help="of pixels, for 170 mm of width [300]")
    parser.add_argument("--no-figures", action="store_true")
    asked = parser.parse_args(arguments)
    ellipse, profiles, found = ellipse_results(), profile_results(), readings()
    print("EKP is our reading of it. Bounds: parabola, paper eq. 9 scaled to the load; pressure, friction x pressure. dev.: from CONTACT.")
    print_table("Table 1: exact double ellipse a = 4.25 mm, b = 6.375 mm, psi = 0.4, p0 = 300 MPa, 17.02 kN", ellipse)
    print_table("Table 2: S1002 on UIC60 canted 1:40, centred, 80 kN, R = 460 mm", profiles)
    print(f"The paper's EKP patch: {PAPER_PATCH}.")
    print_readings(found, [rows[0] for rows in profiles.values()])
    print("\nWhere the paper contradicts itself or is not reproduced")
    for each in INCONSISTENT:
        print(" - " + each.format(literal=literal_bound(profiles[PROFILE_CASES[0]][1])))
    if not asked.no_figures:
        draw(Pictures(asked.folder, asked.formats, asked.dpi), ellipse, profiles, found)


if __name__ == "__main__":
    main()
