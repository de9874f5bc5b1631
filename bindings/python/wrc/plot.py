"""Pictures with matplotlib (pip install wrc[plot]). Each function gives the Figure, and saves it where a path is given. Those of
one panel draw on axes= of the caller's instead."""
from __future__ import annotations

import io
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _interface as i
from ._library import Error
from .contact import Contact, Model
from .creep import CreepCurveFit
from .profiles import ProfileFile
from .sections import RailFaces

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#999999")  # Okabe and Ito
SLIDES = 1e-9  # a sliding velocity over the rolling speed that is none


def figure(**options: Any) -> Any:
    """A matplotlib Figure that no window and no global list holds. A notebook shows it."""
    try:
        from matplotlib.figure import Figure
    except ImportError as why:
        raise ImportError("pictures need matplotlib: pip install wrc[plot]") from why

    class Picture(Figure):
        def _repr_png_(self) -> bytes:
            file = io.BytesIO()
            self.savefig(file, format="png", dpi=100, bbox_inches="tight")
            return file.getvalue()

    return Picture(layout="compressed", **options)


def _panel(axes: Any, size: Tuple[float, float]) -> Tuple[Any, Any]:
    """The caller's axes and their figure, or new ones."""
    if axes is not None:
        return axes.figure, axes
    made = figure(figsize=size)
    return made, made.subplots()


def _done(made: Any, path: Any) -> Any:
    if path is not None:
        made.savefig(path, dpi=100, bbox_inches="tight")
    return made


_PANELS = (("pressure [MPa]", "PRESSURE", 1e-6, "viridis"), ("traction on the wheel [MPa]", "TRACTION", 1e-6, "magma"),
           ("stick and slip: sliding velocity / rolling speed [1e-3]", "SLIP", 1e3, "cividis"),
           ("frictional power [W/mm²]", "POWER_DENSITY", 1e-6, "inferno"))


def contact(contact: Contact, path: Any = None) -> Any:
    """Regions of the last solution: pressure, tractions with their directions, stick and slip, frictional power. Across: of a
    contact plane y to the right, of a wheel the rail's arc from its gauge end, rolled out; rolling direction upwards [mm]."""
    message = contact.message
    try:
        regions = [contact.fields(each) for each in range(len(contact.regions()))]
    except Error:
        regions = []
    if not regions:
        raise ValueError(f"there is nothing to draw: {message or 'call wrench() or planar_step() first'}")
    edges = [np.array(_edge(fields)) for fields in regions]
    low, high = np.min([each.min(axis=1) for each in edges], axis=0), np.max([each.max(axis=1) for each in edges], axis=0)
    middle, half = 0.5 * (low + high), np.maximum(0.54 * (high - low), 0.25 * np.max(high - low))
    slender = half[1] > 1.3 * half[0]  # panels then stand side by side
    made = figure(figsize=(13, 4.6) if slender else (11, 8))
    panels = made.subplots(*((1, 4) if slender else (2, 2)), sharex=True, sharey=True, squeeze=False)
    for panel, (title, name, scale, colours) in zip(panels.flat, _PANELS):
        have = [(fields, each) for fields in regions for each in [_value(fields, name)] if each is not None]
        panel.set_title((title if have else f"{title}: not computed").replace(": ", ":\n") if slender else title if have else
                        f"{title}: not computed", fontsize=10)
        top = max((float(each.max()) for _, each in have), default=0.0) * scale
        mesh = None
        for fields, each in have:
            across, x, shown = _whole(fields, each)
            mesh = panel.pcolormesh(across, x, scale * shown, shading="gouraud", cmap=colours, vmin=0.0, vmax=top or 1.0)
            if name == "SLIP":
                sticks = (shown <= SLIDES).astype(float)
                if sticks.any():
                    panel.contourf(across, x, sticks, levels=[0.5, 1.5], colors=["#dddddd"])
                    panel.contour(across, x, sticks, levels=[0.5], colors="black", linewidths=1.2)
                    panel.text(0.98, 0.97, "grey: sticks", transform=panel.transAxes, fontsize=8, ha="right", va="top")
            if name == "TRACTION":
                every = tuple(slice(1, -1, max(1, size // wanted)) for size, wanted in zip(across.shape, (18, 11)))
                arrows = (_whole(fields, fields[name + direction])[2][every] for direction in ("_Y", "_X"))
                panel.quiver(across[every], x[every], *arrows, color="white", width=2.5e-3, pivot="middle", scale=22 * top / scale if top else None)
        if mesh is not None:
            made.colorbar(mesh, ax=panel, shrink=0.8)
        for edge in edges:
            panel.plot(*edge, color="black", linewidth=1)
        panel.set(aspect="equal", xlim=(middle[0] - half[0], middle[0] + half[0]), ylim=(middle[1] - half[1], middle[1] + half[1]))
    for panel in panels[-1]:
        panel.set_xlabel("along the rail's arc [mm]" if "STRIP_PROFILE_Y" in regions[0] else "y, to the right [mm]")
    for panel in panels[:, 0]:
        panel.set_ylabel("x, rolling direction [mm]")
    return _done(made, path)


regions = contact  # a wheel's are drawn by the same


def _value(fields: Dict[str, np.ndarray], name: str) -> Optional[np.ndarray]:
    if name in fields:
        return fields[name]
    if name + "_X" in fields:
        return np.asarray(np.hypot(fields[name + "_X"], fields[name + "_Y"]))
    return None


def _edge(fields: Dict[str, np.ndarray]) -> Tuple[np.ndarray, np.ndarray]:
    """The outline of a region from its strips, across and along [mm]."""
    across, middle, half = (1e3 * fields[name] for name in ("STRIP_Y", "STRIP_CENTRE", "STRIP_HALF_LENGTH"))
    ahead, behind = middle + half, middle - half
    return np.concatenate([across, across[::-1], across[:1]]), np.concatenate([ahead, behind[::-1], ahead[:1]])


def _whole(fields: Dict[str, np.ndarray], values: np.ndarray) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Values of cells, continued to both ends of each strip: across and x [mm], values."""
    ends = [(1e3 * (fields["STRIP_CENTRE"] + sign * fields["STRIP_HALF_LENGTH"]))[:, None] for sign in (1, -1)]
    x = 1e3 * fields["X"]
    if x[0, 0] < x[0, -1]:  # rolling backwards cell 0 is the rearmost
        ends.reverse()
    x = np.hstack([ends[0], x, ends[1]])
    return np.broadcast_to(1e3 * fields["STRIP_Y"][:, None], x.shape), x, np.hstack([values[:, :1], values, values[:, -1:]])


def field(contact: Contact, name: i.FieldLike, axes: Any = None, path: Any = None) -> Any:
    """One field over cells of all regions of the last solution, as contact() has it: "PRESSURE", "TEMPERATURE_RISE", ... [SI]."""
    made, panel = _panel(axes, (7, 4.5))
    which = i.Field.of(name)
    found = [(contact.fields(each), contact.field(which, each)) for each in range(len(contact.regions()))]
    if not found:
        raise ValueError(f"there is nothing to draw: {contact.message or 'call wrench() or planar_step() first'}")
    low, high = min(float(each.min()) for _, each in found), max(float(each.max()) for _, each in found)
    for fields, values in found:
        across, x, shown = _whole(fields, values)
        mesh = panel.pcolormesh(across, x, shown, shading="gouraud", cmap="viridis", vmin=min(low, 0.0), vmax=high if high > low else low + 1.0)
        panel.plot(*_edge(fields), color="black", linewidth=1)
    unit = (which.__doc__ or "").rpartition("[")[2].rstrip("]")
    made.colorbar(mesh, ax=panel, label=which.name.replace("_", " ").lower() + (f" [{unit}]" if unit != "-" else ""))
    panel.set(aspect="equal", ylabel="x, rolling direction [mm]",
              xlabel="along the rail's arc [mm]" if "STRIP_PROFILE_Y" in found[0][0] else "y, to the right [mm]")
    return _done(made, path)


def subsurface(contact: Contact, region: int = 0, body: i.BodyLike = "RAIL", depths: Optional[Iterable[float]] = None, axes: Any = None,
               path: Any = None) -> Any:
    """Largest stresses under a region over the depth: von Mises, shear, tension. depths: [m]; None: down to 10 mm."""
    made, panel = _panel(axes, (6, 4.5))
    at = np.linspace(1e-4, 10e-3, 60) if depths is None else np.asarray(list(depths), float)
    whole, levels = contact.stresses(region, at, body)
    for name, colour in (("von_mises", COLOURS[0]), ("shear", COLOURS[1]), ("tension", COLOURS[2])):
        panel.plot([1e-6 * getattr(each, name).stress for each in levels], 1e3 * at, color=colour, label=name.replace("_", " "))
        peak = getattr(whole.largest, name)
        panel.plot(1e-6 * peak.stress, 1e3 * peak.depth, "o", color=colour)
    panel.invert_yaxis()
    panel.set(xlabel=f"largest stress in the {i.Body.of(body).name.lower()} [MPa]", ylabel="depth [mm]")
    panel.grid(alpha=0.3)
    panel.legend(fontsize=8)
    return _done(made, path)


def scan(model: Model, lateral: Iterable[float], input: Optional[i.WheelInput] = None, side: i.SideLike = "RIGHT", axes: Any = None,
         path: Any = None) -> Any:
    """Where a wheel touches over the lateral shift of its wheelset [m]: every strip in contact at its place across the rail, coloured
    by its peak pressure. input: load and motion; None: 80 kN."""
    made, panel = _panel(axes, (8, 5))
    one = model.contact(side)
    data = i.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3) if input is None else input.copy()
    y: List[np.ndarray] = []
    shifts: List[np.ndarray] = []
    peaks: List[np.ndarray] = []
    for shift in lateral:
        data.wheel.y = float(shift)
        one.wrench(data)
        for region in range(len(one.regions())):
            y.append(one.field("STRIP_PROFILE_Y", region))
            peaks.append(one.field("STRIP_PEAK", region))
            shifts.append(np.full(len(y[-1]), shift))
    marks = panel.scatter(1e3 * np.concatenate(y), 1e3 * np.concatenate(shifts), c=1e-6 * np.concatenate(peaks), s=6, marker="s", cmap="viridis")
    made.colorbar(marks, ax=panel, label="peak pressure of the strip [MPa]")
    panel.set(xlabel="y of the rail's profile, gauge side negative [mm]", ylabel="lateral shift of the wheelset [mm]")
    panel.grid(alpha=0.3)
    return _done(made, path)


def profile(*files: ProfileFile, axes: Any = None, path: Any = None) -> Any:
    """Profiles as read, with z down as the library has it [mm]."""
    made, panel = _panel(axes, (9, 4.5))
    for each, colour in zip(files, COLOURS * (1 + len(files) // len(COLOURS))):
        panel.plot(1e3 * each.y, 1e3 * each.z, ".-", markersize=2, linewidth=1, color=colour, label=f"{each.body}: {each.path}")
    panel.invert_yaxis()
    panel.set(xlabel="y; flange and gauge side are at y < 0 [mm]", ylabel="z, down [mm]", aspect="equal")
    panel.grid(alpha=0.3)
    panel.legend(fontsize=8)
    return _done(made, path)


def wheel_on_rail(contact: Contact, input: Optional[i.WheelInput] = None, path: Any = None, axes: Any = None) -> Any:
    """The profiles of a contact in the track's axes, the wheel where the wrench of this input has it, with the regions in
    contact, their forces, and the peak pressure of every strip as a line into the rail. input: None: the wheel in the middle
    under 80 kN."""
    if input is None:
        input = i.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3)
    wrench = contact.wrench(input)
    config = contact.model.config
    made, panel = _panel(axes, (9, 5))
    y, z, _ = contact.model.profile("RAIL", contact.side)
    origin = y[np.argmin(np.abs(z))]
    rail = input.rail
    panel.plot(1e3 * (y + rail.y - rail.roll * z), 1e3 * (z + rail.z + rail.roll * (y - origin)), color="#555555", label="rail")
    _pressure_lines(contact, panel, y + rail.y - rail.roll * z, z + rail.z + rail.roll * (y - origin))
    y, z, _ = contact.model.profile("WHEEL", contact.side)
    radius = config.wheelset.wheel_radius
    middle = 0.0 if input.wheel.reference == i.WheelReference.WHEELSET else np.copysign(config.wheelset.tape_circle_distance / 2, y[0])
    roll = input.wheel.roll
    if input.wheel.orientation != i.Orientation.ANGLES:
        axle = input.wheel.rotation.reshape(3, 3, order="C" if input.wheel.orientation == i.Orientation.ROWS else "F")[:, 1]
        roll = np.arctan2(axle[2], axle[1])
    cos, sin = np.cos(roll), np.sin(roll)
    across, down = (y - middle), z + radius
    panel.plot(1e3 * (middle + input.wheel.y + cos * across - sin * down), 1e3 * (wrench.z - radius + sin * across + cos * down),
               color=COLOURS[0], label="wheel")
    regions = contact.regions()
    largest = max((np.hypot(*each.force[1:]) for each in regions), default=1.0)
    for region in regions:
        at, arrow = 1e3 * region.point[1:], 15.0 * region.force[1:] / largest
        panel.plot(*at, "o", color=COLOURS[1])
        panel.annotate("", xytext=at, xy=at + arrow, annotation_clip=False, arrowprops={"arrowstyle": "->", "color": COLOURS[1]})
    panel.set_ylim(panel.get_ylim()[1] + 1.0, -18.0)  # down is down, with room for arrows
    panel.set(xlabel="y, to the right [mm]", ylabel="z, down [mm]", aspect="equal",
              title=f"force on the wheel {wrench.force[1] / 1e3:.2f} kN to the right, {-wrench.force[2] / 1e3:.2f} kN upwards")
    panel.grid(alpha=0.3)
    panel.legend(fontsize=8)
    return _done(made, path)


def animation(contacts: Union[Contact, Sequence[Contact]], inputs: Iterable[i.WheelInput], path: Any, titles: Optional[Iterable[str]] = None,
              seconds: float = 0.1) -> Any:
    """wheel_on_rail() of each input in turn, as a moving picture (.gif). contacts: one, or several of one wheelset side by side,
    left to right; titles: of the frames; seconds: of a frame."""
    from matplotlib.animation import PillowWriter

    shown = [contacts] if isinstance(contacts, Contact) else list(contacts)
    made = figure(figsize=(8, 4.5) if len(shown) == 1 else (5.2 * len(shown), 3.4))
    panels = made.subplots(1, len(shown), squeeze=False)[0]
    made.set_layout_engine(None)  # frames have one size
    made.subplots_adjust(left=0.08, right=0.98, bottom=0.2, top=0.86)
    writer = PillowWriter(fps=1.0 / seconds)  # type: ignore[arg-type]
    limits: Dict[int, Any] = {}
    with writer.saving(made, str(path), 80):
        for each, title in zip(inputs, titles if titles is not None else iter(str, None)):
            for place, (one, panel) in enumerate(zip(shown, panels)):
                panel.clear()
                wheel_on_rail(one, each, axes=panel)
                panel.title.set_fontsize(9)
                limits.setdefault(place, (panel.get_xlim(), panel.get_ylim()))
                panel.set(xlim=limits[place][0], ylim=limits[place][1])
                if len(shown) > 1:  # one legend below all
                    panel.get_legend().remove()
                elif title:
                    panel.set_title(title)
            if len(shown) > 1:
                for each in made.legends:
                    each.remove()
                known = {name.partition(",")[0]: handle for handle, name in zip(*panels[0].get_legend_handles_labels())}
                made.legend(known.values(), known, loc="lower center", ncols=3, fontsize=8)
                made.suptitle(title or "", fontsize=10)
            writer.grab_frame()
    return made


def signs(model: Optional[Model] = None, path: Any = None) -> Any:
    """Signs of creepage, spin and yaw, seen from above: on a contact plane the sliding of the wheel's particles over the rail and
    the traction on the wheel; a wheelset turned by a positive yaw and the forces on it. All arrows are computed.

    model: None: S1002 on 60E1, canted 1:40
    """
    model = Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}) if model is None else model
    made = figure(figsize=(10, 7.4))
    panels = made.subplots(2, 2).ravel()
    plane = model.contact()
    given = (("longitudinal", 1e-3, "> 0: the wheel slides forward"), ("lateral", 1e-3, "> 0: it slides to the right"),
             ("spin", 0.5, "> 0: it turns from x to y"))
    for panel, (name, value, meaning) in zip(panels, given):
        creepage = i.Creepage()
        setattr(creepage, name, value)
        forces = plane.planar_step(i.PlanarInput(load={"normal_force": 80e3}, creepage=creepage, friction={"coefficient": 0.35})).forces
        fields = plane.fields(0)
        panel.fill(*_edge(fields), color="#eeeeee", edgecolor="black", linewidth=1)
        across, x, _ = _whole(fields, fields["PRESSURE"])
        every = tuple(slice(1 + (size - 2) // (2 * wanted), -1, max(1, (size - 2) // wanted)) for size, wanted in zip(across.shape, (6, 3)))
        y, ahead = 1e-3 * across[every], 1e-3 * x[every]
        slide = [creepage.lateral + creepage.spin * ahead, creepage.longitudinal - creepage.spin * y]
        traction = [_whole(fields, fields["TRACTION_" + each])[2][every] for each in "YX"]
        for arrows, colour in ((slide, COLOURS[0]), (traction, COLOURS[1])):
            largest = np.max(np.hypot(*arrows))
            panel.quiver(1e3 * y, 1e3 * ahead, *arrows, color=colour, angles="xy", scale_units="xy", scale=largest / 2.1, width=0.008)
        panel.set(title=f"{name} {meaning}\nFx {forces.fx / 1e3:.1f} kN, Fy {forces.fy / 1e3:.1f} kN, Mz {forces.mz:.0f} N m", aspect="equal")
        panel.set(xlabel="y, to the right [mm]", ylabel="x, rolling direction [mm]")
        panel.title.set_fontsize(10)
        panel.margins(0.1)
    _turned_wheelset(model, panels[3])
    panels[0].plot([], [], color=COLOURS[0], linewidth=2, label="sliding of the wheel over the rail")
    panels[0].plot([], [], color=COLOURS[1], linewidth=2, label="traction, force on the wheel")
    made.legend(loc="outside lower center", ncols=2, fontsize=9)
    return _done(made, path)


def _turned_wheelset(model: Model, panel: Any) -> None:
    """A wheelset from above under a yaw of 3 mrad, drawn as 9 degrees, with the creep forces on its wheels."""
    drawn, radius = np.radians(9.0), model.config.wheelset.wheel_radius
    half = model.config.wheelset.tape_circle_distance / 2
    ahead, right = np.array([np.sin(drawn), np.cos(drawn)]), np.array([np.cos(drawn), -np.sin(drawn)])  # in (y, x) of the picture
    panel.plot(*np.array([-half * right, half * right]).T, color="#555555", linewidth=3)
    for side in (1, -1):
        panel.axvline(side * half, color="#bbbbbb", linewidth=4, zorder=0)
        corners = [side * half * right + a * radius * ahead + b * 0.06 * right for a, b in ((1, 1), (1, -1), (-1, -1), (-1, 1))]
        panel.fill(*np.array(corners).T, facecolor="white", edgecolor="#555555", linewidth=1.5)
        wrench = model.contact("RIGHT" if side > 0 else "LEFT").wrench(i.WheelInput(
            prescribed="VERTICAL_LOAD", vertical_load=80e3, wheel={"yaw": 3e-3, "velocity": (20, 0, 0), "pitch_rate": -20 / radius}))
        at, arrow = side * half * right, wrench.force[1] / 1e3
        panel.annotate("", xytext=at, xy=at + [0.02 * arrow, 0.0], arrowprops={"arrowstyle": "-|>", "color": COLOURS[1], "linewidth": 2})
        panel.text(*(at + [0.0, -radius - 0.16]), f"Fy {arrow:.1f} kN", ha="center", fontsize=9, color=COLOURS[1])
    panel.annotate("", xytext=(0.0, 0.0), xy=(0.0, 0.72), arrowprops={"arrowstyle": "->", "color": "black", "linestyle": "--"})
    panel.annotate("", xytext=(0.0, 0.0), xy=0.72 * ahead, arrowprops={"arrowstyle": "->", "color": COLOURS[2]})
    panel.text(0.04, 0.78, "yaw > 0: the nose\nturns to the right", fontsize=9, color=COLOURS[2])
    panel.set(title="a wheelset from above, yaw 3 mrad at 20 m/s\n(turned 9 degrees in the picture)", xlim=(-1.7, 1.7), ylim=(-0.85, 1.05),
              aspect="equal", xlabel="y, to the right [m]", ylabel="x, forward [m]")
    panel.title.set_fontsize(10)


def smoothing(models: Dict[str, Model], body: i.BodyLike = "WHEEL", axes: Any = None, path: Any = None) -> Any:
    """Heights of the profiles of several models less those of the first [um], over the width of the narrowest: smoothing, wear,
    measured against nominal. models: by the name in the legend; right side."""
    made, panel = _panel(axes, (9, 4))
    which = i.Body.of(body)
    outlines = {name: each.profile(which) for name, each in models.items()}
    if len(outlines) < 2:
        raise ValueError("smoothing() draws the difference of models: pass two or more")
    low, high = max(each[0].min() for each in outlines.values()), min(each[0].max() for each in outlines.values())
    (first, (y, z, _)), *others = outlines.items()
    for (name, (other_y, other_z, _)), colour in zip(others, COLOURS * (1 + len(others) // len(COLOURS))):
        inside = (other_y >= low) & (other_y <= high)
        panel.plot(1e3 * other_y[inside], 1e6 * (other_z - np.interp(other_y, y, z))[inside], color=colour, linewidth=1, label=name)
    panel.axhline(0.0, color="black", linewidth=0.8, label=first)
    panel.invert_yaxis()
    panel.set(xlabel="y, from the middle of wheelset and track [mm]", ylabel=f"height over {first}, z down [µm]")
    panel.grid(alpha=0.3)
    panel.legend(fontsize=8)
    return _done(made, path)


def non_steady(contact: Contact, creepages: Iterable[i.Creepage], step: float, friction: Optional[i.Friction] = None, axes: Any = None,
               path: Any = None) -> Any:
    """Creep forces over the distance rolled while the creepage changes: Fx and Fy of each step.

    contact: of a model with planar={"non_steady": 1}, its planar_normal() done
    creepages: one for each step
    step: that is rolled before each [m]
    """
    made, panel = _panel(axes, (8, 4))
    law = i.Friction() if friction is None else friction
    forces, told = [], []
    for each in creepages:
        contact.planar_roll(step)
        found = contact.planar_tangential(each, law)
        forces.append((found.fx, found.fy))
        told.append((each.longitudinal, each.lateral))
    distance = 1e3 * step * np.arange(1, len(forces) + 1)
    beside = panel.twinx()
    for column, (force, creepage, colour) in enumerate((("Fx", "longitudinal", COLOURS[0]), ("Fy", "lateral", COLOURS[1]))):
        changes = bool(np.any(np.array(told)[:, column]))
        if changes:
            beside.plot(distance, 1e3 * np.array(told)[:, column], color=colour, linestyle=":", linewidth=1, drawstyle="steps-mid")
        panel.plot(distance, 1e-3 * np.array(forces)[:, column], color=colour, label=force + (f"; dotted: {creepage} creepage" if changes else ""))
    panel.set(xlabel="distance rolled [mm]", ylabel="force on the wheel [kN]")
    beside.set_ylabel("creepage [per mille]")
    panel.grid(alpha=0.3)
    panel.legend(fontsize=8)
    return _done(made, path)


def _pressure_lines(contact: Contact, panel: Any, y: np.ndarray, z: np.ndarray) -> None:
    """Peaks of the last solution's strips along the normals of the rail's outline, 12 mm for the largest."""
    order = 1 if abs(y[0]) < abs(y[-1]) else -1  # from the gauge end on
    y, z = y[::order], z[::order]
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    found = [(contact.field("STRIP_Y", each), contact.field("STRIP_PEAK", each)) for each in range(len(contact.regions()))]
    largest = max((float(peak.max()) for _, peak in found), default=1.0)
    for at, peak in found:
        foot = np.array([np.interp(at, arc, y), np.interp(at, arc, z)])
        ahead = np.array([np.interp(at + 1e-4, arc, y), np.interp(at + 1e-4, arc, z)]) - np.array([np.interp(at - 1e-4, arc, y), np.interp(at - 1e-4, arc, z)])
        normal = np.array([-ahead[1], ahead[0]]) / np.hypot(*ahead)
        tip = foot + normal * np.sign(normal[1]) * 12e-3 * peak / largest
        panel.fill(*(1e3 * np.hstack([foot, tip[:, ::-1]])), color=COLOURS[4], alpha=0.6, linewidth=0)
    if found:
        panel.plot([], [], color=COLOURS[4], linewidth=5, alpha=0.6, label=f"pressure, {1e-6 * largest:.0f} MPa at most")


def creep_curve(contact: Contact, direction: str, values: Iterable[float], input: i.PlanarInput) -> np.ndarray:
    """Forces fx, fy [N] over creepages in one direction, "longitudinal", "lateral" or "spin", others as in `input`; shape
    (number of values, 2). The patch is solved once."""
    if direction not in ("longitudinal", "lateral", "spin"):
        raise ValueError(f"{direction!r} is none of longitudinal, lateral, spin")
    contact.planar_step(input)
    creepage = input.creepage.copy()
    forces = []
    for each in values:
        setattr(creepage, direction, float(each))
        found = contact.planar_tangential(creepage, input.friction)
        forces.append((found.fx, found.fy))
    return np.array(forces)


def creep_curves(contacts: Dict[str, Contact], input: i.PlanarInput, values: Optional[Dict[str, Iterable[float]]] = None, path: Any = None) -> Any:
    """Creep curves of contacts of several models, over friction times load: longitudinal, lateral, spin.

    contacts: by the name in the legend; input: pose, load, friction; values: creepages by direction; None: up to saturation
    """
    default = {"longitudinal": np.linspace(0, 6e-3, 41), "lateral": np.linspace(0, 6e-3, 41), "spin": np.linspace(0, 1.2, 41)}
    made = figure(figsize=(13, 4.2))
    panels = made.subplots(1, 3)
    for panel, (direction, across) in zip(panels, default.items()):
        across = np.asarray(list((values or {}).get(direction, across)), float)
        component = 0 if direction == "longitudinal" else 1
        for (name, one), colour in zip(contacts.items(), COLOURS * (1 + len(contacts) // len(COLOURS))):
            forces = creep_curve(one, direction, across, input)
            limit = input.friction.coefficient * one.planar_tangential(input.creepage, input.friction).fn
            scale, unit = (1.0, "1/m") if direction == "spin" else (1e3, "per mille")
            panel.plot(scale * across, -forces[:, component] / limit, color=colour, label=name)
        panel.set(xlabel=f"{direction} creepage [{unit}]", ylabel=("-Fx" if component == 0 else "-Fy") + " / (friction x load)")
        panel.grid(alpha=0.3)
    panels[0].legend(fontsize=8)
    return _done(made, path)


def creep_fit(fit: CreepCurveFit, axes: Any = None, path: Any = None) -> Any:
    """Points of a measured creep curve, and the law fitted to them: a colour for each speed, with the parameters and their spread."""
    made, panel = _panel(axes, (8, 5))
    slip, speed, load = fit.points["slip"], fit.points["speed"], fit.points["load"]
    groups = np.unique(np.round(speed, 2))
    if len(groups) > len(COLOURS):  # speeds that were measured: a few between the ends
        groups = np.linspace(speed.min(), speed.max(), 4)
    nearest = np.argmin(np.abs(speed[:, None] - groups), axis=1)
    across = np.geomspace(slip.min(), slip.max(), 200)
    for k, (each, colour) in enumerate(zip(groups, COLOURS)):
        here = nearest == k
        if not here.any():
            continue
        panel.plot(100 * slip[here], fit.points["adhesion"][here], "o", color=colour, markersize=4, alpha=0.6)
        panel.plot(100 * across, fit.adhesion(across, float(each), float(np.mean(load[here]))), color=colour, label=f"{each:.3g} m/s")
    panel.set(xscale="log", xlabel="slip [%]", ylabel="adhesion [-]", ylim=(0, None))
    panel.grid(alpha=0.3)
    panel.legend(fontsize=8, loc="upper left")
    told = "\n".join(repr(each).replace("+-", "±").split(" (")[0] for each in fit.parameters.values())
    panel.text(0.98, 0.03, told, transform=panel.transAxes, ha="right", va="bottom", fontsize=8,
               bbox={"facecolor": "white", "alpha": 0.8, "edgecolor": "#cccccc"})
    return _done(made, path)


def model(model: Model, path: Any = None, axes: Any = None) -> Any:
    """The profiles of a model as it uses them, right side, in the track's axes [mm]."""
    made, panel = _panel(axes, (9, 4.5))
    for body, colour in ((i.Body.WHEEL, COLOURS[0]), (i.Body.RAIL, "#555555")):
        y, z, deviation = model.profile(body)
        panel.plot(1e3 * y, 1e3 * z, color=colour, label=body.name.lower() + (f", smoothed by up to {1e6 * deviation:.1f} µm" if deviation else ""))
    panel.invert_yaxis()
    panel.set(xlabel="y, from the middle of wheelset and track [mm]", ylabel="z, down [mm]", aspect="equal")
    panel.grid(alpha=0.3)
    panel.legend(fontsize=8)
    return _done(made, path)


def rail(faces: RailFaces, first: Optional[float] = None, last: Optional[float] = None, height: float = 3.0, path: Any = None) -> Any:
    """Faces of a rail in 3-D: sections as lines, marks as dots, each face in its colour, heights `height` times too large; from
    above and from the side as well. first, last: the part of the track that is drawn [m]; None: all."""
    made = figure(figsize=(13, 9))
    made.set_layout_engine("tight")  # "compressed" has no place for axes in space
    panels = made.subplot_mosaic([["space", "space"], ["above", "side"]], per_subplot_kw={"space": {"projection": "3d"}}, height_ratios=[2, 1])
    space, above, side = (panels[name] for name in ("space", "above", "side"))
    low = -np.inf if first is None else first
    high = np.inf if last is None else last
    for face, colour in zip(faces.faces, COLOURS * (1 + len(faces.faces) // len(COLOURS))):
        inside = [k for k, each in enumerate(face.distances) if low <= each <= high]
        if not inside:
            continue
        places = [1e3 * face.distances[k] for k in inside]
        for k, x in zip(inside, places):
            y, z = (1e3 * each for each in face.outlines[k])
            space.plot(np.full(len(y), x), y, z, color=colour, linewidth=0.6)
            for mark in face.marks[k]:
                space.plot([x], [1e3 * mark], [1e3 * np.interp(mark, *face.outlines[k])], ".", color="black", markersize=3)
        edges = np.array([[1e3 * face.outlines[k][0][0], 1e3 * face.outlines[k][0][-1]] for k in inside])
        above.fill_between(places, edges[:, 0], edges[:, 1], color=colour, alpha=0.3, linewidth=0)
        above.plot(places, 1e3 * np.array([face.marks[k] for k in inside]).reshape(len(inside), -1), "-", color=colour, linewidth=1)
        side.plot(places, [1e3 * face.outlines[k][1].min() for k in inside], ".-", markersize=3, color=colour, label=face.kind)
    space.set(xlabel="along the track [mm]", ylabel="y [mm]", zlabel="z, down [mm]")
    space.invert_zaxis()
    space.view_init(elev=28, azim=-62)
    across, down = np.ptp(space.get_ylim()), np.ptp(space.get_zlim())
    space.set_box_aspect((2.6, 1.0, min(1.0, height * down / across)), zoom=1.3)
    above.set(xlabel="along the track [mm]", ylabel="y [mm]", title="from above: faces, marks as lines")
    side.set(xlabel="along the track [mm]", ylabel="z, down [mm]", title="the highest point of each section")
    side.invert_yaxis()
    side.legend(fontsize=8)
    for panel in (above, side):
        panel.grid(alpha=0.3)
    return _done(made, path)
