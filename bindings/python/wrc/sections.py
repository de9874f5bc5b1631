"""Measured sections of a rail that changes along the track: a turnout, a crossing, a joint.

Each section is one line from the gauge side to the field side, with gaps, as an instrument or a drawing has it. rail_faces() parts
the lines into faces (blade, stock, wing, nose, check), follows them along the track, finds marks and makes the sections of a
model. read_sections() and write_sections() know .slcs of CONTACT, a table of places with a file of points for each, and columns
of x, y, z. Errors name the section by its number, counted from 1, and its distance."""
from __future__ import annotations

import dataclasses
import os
import re
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _interface as i
from .profiles import UNITS, _columns, _simpack

FACES = 4  # that a model holds
_STRETCH = 7.0  # of a part between marks over that of the first section; a model refuses 8
_STEEP = np.pi / 4  # inclination at which a head's corner is marked
_LEAST_WIDTH = 20.5e-3  # of a profile, a little more than the library asks for [m]


class SectionError(ValueError):
    """A section that cannot be used: its number, counted from 1, and its distance stand in the text."""

    __module__ = "wrc"

    def __init__(self, number: int, distance: float, why: str):
        self.number, self.distance, self.why = number, distance, why
        super().__init__(f"section {number} at {distance:.5g} m: {why}")

    def __reduce__(self) -> Any:
        return type(self), (self.number, self.distance, self.why)


@dataclasses.dataclass
class MeasuredSection:
    """One line across the track [m]: y to the field side, z down, 0 at the rail's top; NaN where nothing was measured."""

    distance: float
    y: np.ndarray
    z: np.ndarray
    name: str = ""


@dataclasses.dataclass
class Face:
    """A surface that a wheel may roll on: its kind, and its outline in each of the measured sections it is in.

    kind: "blade", "stock", "wing", "nose", "check" or "rail", by its place beside the others
    numbers: of the measured sections, counted from 0
    distances [m], outlines: y, z of each [m]; marks: y of the corners that belong together, as many in each [m]
    spacing_errors: how far each outline is from the mean of its neighbours [m]; 0 of the first and the last
    """

    kind: str
    numbers: List[int]
    distances: List[float]
    outlines: List[Tuple[np.ndarray, np.ndarray]]
    marks: List[List[float]]
    spacing_errors: List[float]


@dataclasses.dataclass
class RailFaces:
    """The faces of a rail, from the gauge side. `rail_sections` goes into wrc.Model(rail_sections=...).

    notes: what was left out or joined; thin: where sections are too far apart, or a face begins or ends under a wheel
    """

    faces: List[Face]
    notes: List[str]
    thin: List[str]

    def part(self, first: float, last: float) -> "RailFaces":
        """The faces from one place along the track to another [m], with a section beyond on either side."""
        made = []
        for face in self.faces:
            at = np.array(face.distances)
            low = max(int(np.searchsorted(at, first, "right")) - 1, 0)
            high = min(int(np.searchsorted(at, last, "left")), len(at) - 1)
            if at[0] < last and at[-1] > first:
                made.append(Face(face.kind, *(getattr(face, each.name)[low:high + 1] for each in dataclasses.fields(Face)[1:])))
        return RailFaces(made, self.notes, [each for each in self.thin if not re.match(r"\d+ faces: ", each)])

    @property
    def rail_sections(self) -> List[Dict[str, Any]]:
        """Sections as members of wrc.RailSection, those of a face side by side. Check rails are left out: config.check_rail guides
        the flange's back, the same all along the track."""
        made = []
        for surface, face in enumerate([each for each in self.faces if each.kind != "check"]):
            for distance, (y, z), marks in zip(face.distances, face.outlines, face.marks):
                top = float(z.min())
                y, z = _wide_enough(y, z - top)
                made.append({"distance": distance, "surface": surface, "z": top, "marks": marks,
                             "profile": {"kind": "POINTS", "y": y, "z": z}})
        return made

    def __repr__(self) -> str:
        rows = [f"wrc.RailFaces, {len(self.faces)} from the gauge side"]
        rows += [f"  {face.kind:6} {len(face.distances):4} sections {face.distances[0]:.4f} .. {face.distances[-1]:.4f} m, "
                 f"{len(face.marks[0])} marks" for face in self.faces]
        return "\n".join(rows + [f"  note   {each}" for each in self.notes] + [f"  thin   {each}" for each in self.thin])


# ------------------------------------------------------------------------------------------------------------- files


def read_sections(path: Union[str, "os.PathLike[str]"], *, unit: Optional[str] = None, mirror_y: bool = False,
                  mirror_z: bool = False) -> List[MeasuredSection]:
    """Reads measured sections; the file's ending and content say what it is.

    .slcs: slices of CONTACT: places and a file of points each, .prr as Simpack has them, any other in columns y, z
    columns x, y, z: a point a line, those of a section together
    columns number, place: the table of a benchmark; the points of section 7 are in NAME_7.txt, where SectionPositionNAME.txt
        is the table's name, beside it or in a folder of that name
    unit: of the points, "mm", "m", "cm", "um", "in"; None: the one of m and mm that fits. Distances of .slcs and of the table
        are in the file's own unit (S_SCALE; m)
    mirror_y, mirror_z: turn that axis: the gauge side must be at y < 0 and z point down
    """
    path = os.fspath(path)
    if unit is not None and unit not in UNITS:
        raise ValueError(f"there is no unit {unit!r}: choose {', '.join(UNITS)}")
    with open(path, encoding="utf-8", errors="replace") as file:
        rows = file.read().splitlines()
    if path.lower().endswith(".slcs"):
        found = _read_slcs(path, rows)
    else:
        table = np.array([[float(each) for each in re.split(r"[,;\s]+", text)] for row in rows
                          for text in [re.split(r"[#!%]", row)[0].strip(" ,;\t")] if text and re.match(r"[-+.\d]", text)])
        if table.ndim != 2 or table.shape[1] not in (2, 3):
            raise ValueError(f"{path}: neither columns x, y, z nor number and place")
        found = _read_cloud(path, table) if table.shape[1] == 3 else _read_table(path, table)
    scale = UNITS[unit] if unit else _fitting(found)
    for each in found:
        each.y, each.z = each.y * (-scale if mirror_y else scale), each.z * (-scale if mirror_z else scale)
        if mirror_y:
            each.y, each.z = each.y[::-1], each.z[::-1]
    if path.lower().endswith("slcs") or table.shape[1] == 2:
        return found
    for each in found:
        each.distance *= scale
    return found


def _fitting(sections: Sequence[MeasuredSection]) -> float:
    width = float(np.median([np.ptp(each.y[np.isfinite(each.y)]) for each in sections]))
    for name in ("mm", "m"):
        if 0.02 <= width * UNITS[name] <= 1.0:
            return UNITS[name]
    raise ValueError(f"sections are {width:g} wide, which is a rail neither in mm nor in m: pass unit=")


def _points(path: str) -> Tuple[np.ndarray, np.ndarray]:
    with open(path, encoding="utf-8", errors="replace") as file:
        rows = file.read().splitlines()
    if path.lower().endswith(".prr"):
        points, _, _, said = _simpack(path, rows, "rail", [])
        scale = said * 1e3 if isinstance(said, float) else 1.0  # to mm, in which other files of .prr are
        return points[:, 0] * scale, points[:, 1] * scale
    miniprof = path.lower().endswith(".ban")
    points = _columns(path, rows, miniprof, None if miniprof else (0, 1), [])[0]
    return points[:, 0], points[:, 1]


def _read_slcs(path: str, rows: List[str]) -> List[MeasuredSection]:
    """Offset and scale, number of slices, of features, kind of interpolation; then places with names of files. Features that
    follow are not read: the faces are found anew."""
    lines = [(at, text) for at, row in enumerate(rows, 1) for text in [row.split("%")[0].strip()] if text]
    try:
        offset, scale = (float(each) for each in lines[0][1].split()[:2])
        count = int(lines[1][1].split()[0])
    except (IndexError, ValueError):
        raise ValueError(f"{path}: no heading of slices: offset and scale, then their number") from None
    named = [(at, re.match(r"([-+.\deEdD]+)\s+'([^']+)'", text)) for at, text in lines[2:]]
    slices = [(at, float(each.group(1)), each.group(2)) for at, each in named if each]
    if len(slices) != count:
        raise ValueError(f"{path}: {count} slices are promised, {len(slices)} named: is the file whole?")
    found = []
    for at, place, name in slices:
        file = os.path.join(os.path.dirname(path), name.replace("\\", "/"))
        if not os.path.exists(file):
            raise ValueError(f"{path}:{at}: there is no file {file}")
        y, z = _points(file)
        found.append(MeasuredSection(1e-3 * (offset + place) * scale, y, z, name))
    return found


def _read_table(path: str, table: np.ndarray) -> List[MeasuredSection]:
    stem = re.sub(r"^SectionPosition", "", os.path.splitext(os.path.basename(path))[0])
    folder = os.path.dirname(path)
    found = []
    for number, place in table:
        name = f"{stem}_{int(number)}.txt"
        file = next((each for each in (os.path.join(folder, name), os.path.join(folder, stem, name)) if os.path.exists(each)), None)
        if file is None:
            raise ValueError(f"{path}: section {int(number)} at {place:g} m has no file {name}")
        found.append(MeasuredSection(float(place), *_points(file), name))
    return found


def _read_cloud(path: str, table: np.ndarray) -> List[MeasuredSection]:
    starts = np.flatnonzero(np.r_[True, np.diff(table[:, 0]) != 0.0])
    return [MeasuredSection(float(part[0, 0]), part[:, 1], part[:, 2], path) for part in np.split(table, starts[1:])]


def write_sections(path: Union[str, "os.PathLike[str]"], sections: Sequence[MeasuredSection]) -> None:
    """Writes sections as .slcs of CONTACT, with their points [mm] in a folder of the same name; as columns x, y, z [m] where the
    name ends otherwise. Places of .slcs are in m."""
    path = os.fspath(path)
    stem, ending = os.path.splitext(path)
    if ending.lower() != ".slcs":
        np.savetxt(path, np.vstack([np.column_stack([np.full(len(each.y), each.distance), each.y, each.z]) for each in sections]),
                   fmt="%.9g", header="x [m] y [m] z [m]")
        return
    os.makedirs(stem, exist_ok=True)
    rows = ["% sections of a rail", "   0.0   1000.0   U_OFFSET [usr], U_SCALE [mm/usr],  usr = m", f"   {len(sections)}   NSLC",
            "   0   0   0   NFEAT, NKINK, NACCEL", "   1   U_INTPOL (1=intpol, 2=approx)", ""]
    for number, each in enumerate(sections, 1):
        name = f"{os.path.basename(stem)}/section_{number}.txt"
        there = np.isfinite(each.y) & np.isfinite(each.z)
        np.savetxt(os.path.join(stem, f"section_{number}.txt"), 1e3 * np.column_stack([each.y, each.z])[there], fmt="%.7f")
        rows.append(f"  {each.distance:.7f}   '{name}'")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(rows) + "\n")


# ------------------------------------------------------------------------------------------------------------- faces


@dataclasses.dataclass
class _Piece:
    """An outline between two cuts of a section."""

    number: int
    y: np.ndarray
    z: np.ndarray

    @property
    def width(self) -> float:
        return float(self.y[-1] - self.y[0])


def rail_faces(sections: Sequence[MeasuredSection], *, interruptions: Sequence[float] = (), depth: float = 0.03, gap: float = 5e-3,
               kink: float = 0.7, least: float = 3e-3, tolerance: float = 2e-4) -> RailFaces:
    """Parts sections into faces that a wheel may roll on, and follows these along the track.

    interruptions: places along the track over which no face goes on, between two sections: the gap of a joint [m]
    depth: below the rail's top, z = 0, from which on nothing is a face: the bottom of a flangeway lies deeper [m]
    gap: from one point to the next at which the line is parted [m]
    kink: turn of the line at a concave corner, within 3 mm, at which it is parted: a blade at its stock rail [rad]
    least: narrower pieces are left out [m]
    tolerance: a section this far from the mean of its neighbours is told in `thin` [m]
    """
    lines = _checked(sections)
    notes: List[str] = []
    pieces = []
    for number, (each, (y, z)) in enumerate(zip(sections, lines)):
        found = _pieces(number, y, z, depth, gap, kink)
        for piece in found:
            _refuse_overhang(each, piece)
        narrow = [piece for piece in found if len(piece.y) < 4 or piece.width < least]
        if narrow:
            notes.append(f"section {number + 1} at {each.distance:.5g} m: left out, narrower than {1e3 * least:g} mm: y = "
                         + ", ".join(f"{1e3 * piece.y.mean():.1f}" for piece in narrow) + " mm")
        pieces.append([piece for piece in found if piece not in narrow])
        if not pieces[-1]:
            raise SectionError(number + 1, each.distance, f"nothing lies above z = {1e3 * depth:g} mm: is z = 0 the rail's top, and z down?")
    runs = []
    for run in _followed(pieces, sections, interruptions, notes):
        if len(run) > 1:
            runs.append(run)
        else:
            notes.append(f"section {run[0].number + 1} at {sections[run[0].number].distance:.5g} m: a face at y = {1e3 * run[0].y.mean():.1f} mm "
                         "is in no other section and is left out: data are thin there")
    runs.sort(key=lambda run: float(np.mean([piece.y[0] for piece in run])))
    made = [face for run in runs for face in _faces(run, sections, _kind(run, runs), notes)]
    thin = [sentence for face in made for sentence in _thin(face, tolerance)]
    running = sum(face.kind != "check" for face in made)
    if running > FACES:
        thin.append(f"{running} faces: a model holds {FACES}. Give a shorter part of the track, or leave faces out of `faces`")
    return RailFaces(made, notes, thin)


def _checked(sections: Sequence[MeasuredSection]) -> List[Tuple[np.ndarray, np.ndarray]]:
    """Lines from gauge to field, where they are sound: order along the track, unit, direction, no crossing of themselves."""
    if len(sections) < 2:
        raise ValueError(f"{len(sections)} sections: two make a rail along the track")
    lines = []
    for number, each in enumerate(sections, 1):
        if not np.isfinite(each.distance):
            raise SectionError(number, each.distance, "its distance is no finite number")
        y, z = (np.asarray(values, float) for values in (each.y, each.z))
        if y.shape != z.shape or y.ndim != 1 or np.isfinite(y).sum() < 4:
            raise SectionError(number, each.distance, f"{y.size} values of y and {z.size} of z: a section has 4 points or more")
        if number > 1:
            before = sections[number - 2].distance
            if each.distance == before:
                raise SectionError(number, each.distance, f"it lies where section {number - 1} does: was it measured twice?")
            if each.distance < before:
                raise SectionError(number, each.distance, f"it lies before section {number - 1} at {before:.5g} m: sections cross, or are out of order")
            if each.distance - before < 1e-3:
                raise SectionError(number, each.distance, f"{1e3 * (each.distance - before):.3g} mm beyond section {number - 1}: "
                                   "sections of a model are 1 mm apart at least")
        lines.append((y, z))
    widths = np.array([np.ptp(y[np.isfinite(y)]) for y, _ in lines])
    usual = float(np.median(widths))
    for number, (each, (y, z), width) in enumerate(zip(sections, lines, widths), 1):
        if not 0.01 <= width <= 2.0 or max(width / usual, usual / width) > 20.0:
            raise SectionError(number, each.distance, f"it is {width:.4g} m wide, most are {usual:.4g} m: is it in another unit?")
        finite = np.isfinite(y) & np.isfinite(z)
        if np.nanmin(z) < -0.1 or np.nanmin(z) > 0.06 or (np.nanmax(z) < 0.01 and np.nanmin(z) < -0.02):
            raise SectionError(number, each.distance, f"z is {np.nanmin(z):.4g} .. {np.nanmax(z):.4g} m, and must be 0 at the rail's top and "
                               "point down: turn its sign, or move it")
        if y[finite][-1] < y[finite][0]:
            raise SectionError(number, each.distance, "its points run from the field side to the gauge side: turn them, or y, round")
        crossing = _crossing(y[finite], z[finite])
        if crossing is not None:
            raise SectionError(number, each.distance, f"the line crosses itself at y = {1e3 * crossing[0]:.2f}, z = {1e3 * crossing[1]:.2f} mm: are "
                               "points out of order, or two measurements in one?")
    return lines


def _crossing(y: np.ndarray, z: np.ndarray) -> Optional[Tuple[float, float]]:
    """Where a line crosses itself. One whose y increases does not."""
    if (np.diff(y) > 0.0).all():
        return None
    p = np.column_stack([y, z])
    d = np.diff(p, axis=0)
    for k in np.flatnonzero(d[:, 0] <= 0.0).tolist():  # a crossing has a segment that goes back, within or beside it
        for a in range(max(k - 1, 0), min(k + 2, len(d))):
            apart = p[:-1] - p[a]
            determinant = d[a, 0] * d[:, 1] - d[a, 1] * d[:, 0]
            with np.errstate(divide="ignore", invalid="ignore"):
                s = (apart[:, 0] * d[:, 1] - apart[:, 1] * d[:, 0]) / determinant
                t = (apart[:, 0] * d[a, 1] - apart[:, 1] * d[a, 0]) / determinant
            hit = (s > 1e-9) & (s < 1 - 1e-9) & (t > 1e-9) & (t < 1 - 1e-9) & (np.abs(np.arange(len(d)) - a) > 1)
            if hit.any():
                return tuple(p[a] + s[np.argmax(hit)] * d[a])
    return None


def _refuse_overhang(section: MeasuredSection, piece: _Piece) -> None:
    back = np.diff(piece.y)
    if len(back) and back.min() <= -2e-5:
        at = int(np.argmin(back))
        raise SectionError(piece.number + 1, section.distance, f"it overhangs: y goes back from {1e3 * piece.y[at]:.3f} to {1e3 * piece.y[at + 1]:.3f} mm at "
                           f"z = {1e3 * piece.z[at]:.2f} mm; a face must be seen from above")
    keep = np.r_[True, np.hypot(np.diff(piece.y), np.diff(piece.z)) > 1e-6]
    steps = 1e-6 * np.arange(np.sum(keep))  # a flank that is upright leans by a micrometre from point to point
    piece.y, piece.z = np.maximum.accumulate(piece.y[keep] - steps) + steps, piece.z[keep]


def _pieces(number: int, y: np.ndarray, z: np.ndarray, depth: float, gap: float, kink: float) -> List[_Piece]:
    """The parts of a line above a depth, cut at gaps and concave corners; ends are at the depth itself."""
    made: List[_Piece] = []
    whole = np.isfinite(y) & np.isfinite(z)
    cuts = np.flatnonzero(~whole[1:] | ~whole[:-1] | (np.hypot(np.diff(y), np.diff(z)) > gap)) + 1
    for part in np.split(np.arange(len(y)), cuts):
        part = part[whole[part]]
        if len(part) < 2:
            continue
        py, pz = y[part], z[part]
        above = pz < depth
        edges = np.flatnonzero(np.diff(np.r_[False, above, False].astype(int)))
        for first, last in zip(edges[::2], edges[1::2]):
            ly, lz = list(py[first:last]), list(pz[first:last])
            for side, inner, outer in ((0, first, first - 1), (1, last - 1, last)):
                if 0 <= outer < len(py):  # the line goes on below: end it at the depth
                    share = (depth - pz[inner]) / (pz[outer] - pz[inner])
                    if share > 1e-6:
                        ly.insert(0 if side == 0 else len(ly), py[inner] + share * (py[outer] - py[inner]))
                        lz.insert(0 if side == 0 else len(lz), depth)
            line_y, line_z = np.array(ly), np.array(lz)
            s, corners = _arc(line_y, line_z), _corners(line_y, line_z, kink)
            for cut in np.split(np.arange(len(line_y)), corners):
                cut = cut[np.abs(s[cut][:, None] - s[corners]).min(axis=1, initial=1.0) > 1e-3]  # no wheel reaches the corner itself
                made.append(_Piece(number, line_y[cut], line_z[cut]))
    return made


def _arc(y: np.ndarray, z: np.ndarray) -> np.ndarray:
    return np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])


def _inclination(y: np.ndarray, z: np.ndarray, s: np.ndarray, at: np.ndarray, behind: float, ahead: float) -> np.ndarray:
    """Of the chord from `behind` before to `ahead` beyond places of the arc [rad]."""
    low, high = np.clip(at - behind, 0.0, s[-1]), np.clip(at + ahead, 0.0, s[-1])
    return np.asarray(np.arctan2(np.interp(high, s, z) - np.interp(low, s, z), np.interp(high, s, y) - np.interp(low, s, y)))


def _corners(y: np.ndarray, z: np.ndarray, kink: float) -> np.ndarray:
    """Points at which a line that rises and falls turns back up: a head is convex, so two meet there."""
    window = 1.5e-3
    s = _arc(y, z)
    if s[-1] < 4.0 * window:
        return np.array([], int)
    turn = _inclination(y, z, s, s, window, 0.0) - _inclination(y, z, s, s, 0.0, window)
    turn[(s < window) | (s > s[-1] - window)] = 0.0
    found = []
    while turn.max() > kink:
        at = int(np.argmax(turn))
        near = np.flatnonzero(np.abs(s - s[at]) < window)
        found.append(int(near[np.argmax(z[near])]))  # the lowest point between both
        turn[np.abs(s - s[at]) < 2.0 * window] = 0.0
    return np.array(sorted(found), int)


def _followed(pieces: List[List[_Piece]], sections: Sequence[MeasuredSection], interruptions: Sequence[float],
              notes: List[str]) -> List[List[_Piece]]:
    """Runs of pieces of neighbouring sections that are one face: those that lie over each other most. Where a piece is much wider
    than the one before, another rail joins or leaves: one face ends and another begins, with the common part in both sections."""
    done: List[List[_Piece]] = []
    open_runs = [[piece] for piece in pieces[0]]
    for here in pieces[1:]:
        low, high = (sections[here[0].number - back].distance for back in (1, 0))
        if any(low <= each <= high for each in interruptions):
            done, open_runs = done + open_runs, [[piece] for piece in here]
            continue
        pairs = []
        for run in open_runs:
            for piece in here:
                over = min(run[-1].y[-1], piece.y[-1]) - max(run[-1].y[0], piece.y[0])
                if over > 0.3 * min(run[-1].width, piece.width):
                    pairs.append((over, run, piece))
        pairs.sort(key=lambda each: -each[0])
        went_on: List[List[_Piece]] = []
        taken: List[_Piece] = []
        for _, run, piece in pairs:
            if any(run is each or run is each[:-1] for each in went_on) or any(piece is each for each in taken) or run in done:
                continue
            taken.append(piece)
            before = run[-1]
            if abs(piece.width - before.width) > max(10e-3, 0.2 * max(piece.width, before.width)):
                narrow, wide = (before, piece) if before.width < piece.width else (piece, before)
                cropped = _cropped(wide, narrow)
                notes.append(f"section {piece.number + 1} at {sections[piece.number].distance:.5g} m: a face is {1e3 * piece.width:.0f} mm wide, "
                             f"{1e3 * before.width:.0f} mm in the section before: another rail joins or leaves; the face ends and a new one begins")
                if wide is piece:  # the old face ends with the common part of this section
                    done.append(run + [cropped])
                    went_on.append([piece])
                else:  # the new face begins with the common part of the section before
                    done.append(run)
                    went_on.append([cropped, piece])
            else:
                run.append(piece)
                went_on.append(run)
        done += [run for run in open_runs if not any(run is each for each in went_on) and run not in done
                 and not any(run is each[:len(run)] for each in done) and not any(each[:len(run)] == run for each in done)]
        open_runs = went_on + [[piece] for piece in here if not any(piece is each for each in taken)]
    return done + open_runs


def _cropped(wide: _Piece, narrow: _Piece) -> _Piece:
    """The part of a piece that lies over another, ends that agree within 5 mm kept."""
    low = wide.y[0] if abs(wide.y[0] - narrow.y[0]) < 5e-3 else narrow.y[0]
    high = wide.y[-1] if abs(wide.y[-1] - narrow.y[-1]) < 5e-3 else narrow.y[-1]
    inside = (wide.y > low) & (wide.y < high)
    y = np.r_[low, wide.y[inside], high]
    return _Piece(wide.number, y, np.interp(y, wide.y, wide.z))


def _faces(run: List[_Piece], sections: Sequence[MeasuredSection], kind: str, notes: List[str]) -> List[Face]:
    """The face of a run; several, each from the section with which the one before ends, where outlines grow too long for one."""
    face = _face(run, sections, kind)
    lengths = np.array([np.diff([0.0, *np.interp(marks, y, _arc(y, z)), _arc(y, z)[-1]]) for (y, z), marks in zip(face.outlines, face.marks)])
    stretch = np.max(np.maximum(lengths / lengths[0], lengths[0] / lengths), axis=1)
    last = int(np.argmax(stretch > _STRETCH)) - 1
    if stretch.max() <= _STRETCH or last < 1:
        return [face]
    notes.append(f"{kind}: at section {run[last].number + 1}, {face.distances[last]:.5g} m, its outline is {stretch[last]:.1f} times as long between marks "
                 "as at its beginning: it goes on as another face")
    return [_face(run[:last + 1], sections, kind), *_faces(run[last:], sections, kind, notes)]


def _face(run: List[_Piece], sections: Sequence[MeasuredSection], kind: str) -> Face:
    """Outlines whose steep sides end equally deep below their top, as shares of length would shift otherwise, and marks. The gauge
    side is a wheel's down to 18 mm."""
    outlines = [(piece.y, piece.z) for piece in run]
    for end, whole in ((0, 18e-3), (-1, 1e-3)):
        least = min(float(z[end] - z.min()) for _, z in outlines)
        if least > whole:
            outlines = [_shortened(y, z, end, float(z.min()) + least) for y, z in outlines]
    marks = _marks(outlines)
    distances = [sections[piece.number].distance for piece in run]
    errors = [0.0] * len(run)
    for k in range(1, len(run) - 1):
        errors[k] = _spacing_error(distances[k - 1:k + 2], outlines[k - 1:k + 2], marks[k - 1:k + 2])
    return Face(kind, [piece.number for piece in run], distances, outlines, marks, errors)


def _shortened(y: np.ndarray, z: np.ndarray, end: int, depth: float) -> Tuple[np.ndarray, np.ndarray]:
    """An outline without what lies deeper on its steep side, at the first or the last point."""
    if end == 0:
        turned = _shortened(-y[::-1], z[::-1], -1, depth)
        return -turned[0][::-1], turned[1][::-1]
    last = len(y) - 1
    while last > 3 and z[last - 1] > depth and z[last] - z[last - 1] > 0.6 * (y[last] - y[last - 1]):
        last -= 1
    if z[last] <= depth or z[last - 1] > depth:
        return y[:last + 1], z[:last + 1]
    share = (depth - z[last - 1]) / (z[last] - z[last - 1])
    if share < 1e-2:  # no points on top of each other
        return y[:last], z[:last]
    return np.r_[y[:last], y[last - 1] + share * (y[last] - y[last - 1])], np.r_[z[:last], depth]


def _marks(outlines: List[Tuple[np.ndarray, np.ndarray]]) -> List[List[float]]:
    """y of the corners on the gauge and the field side, where every outline has them, 1.5 mm from the ends and from each other."""
    found: List[List[float]] = []
    for sign in (-1, 1):
        corner = [_corner(y, z, sign) for y, z in outlines]
        if any(each is None for each in corner):
            continue
        from_end = np.array([float(y[-1 if sign > 0 else 0]) - each for each, (y, _) in zip(corner, outlines)])  # type: ignore[operator]
        if np.abs(np.diff(from_end)).max(initial=0.0) < 5e-3:  # else another corner is met on the way
            found.append([float(each) for each in corner if each is not None])
    if len(found) == 2 and any(right - left < 1.5e-3 for left, right in zip(*found)):
        found.pop()
    return [[corner[k] for corner in found] for k in range(len(outlines))]


def _corner(y: np.ndarray, z: np.ndarray, sign: int) -> Optional[float]:
    """y at which a head, followed from its top, first reaches 45 degrees on the gauge (-1) or the field side (1)."""
    s = _arc(y, z)
    at = np.arange(0.0, s[-1], 1e-4)
    steep = sign * _inclination(y, z, s, at, 7.5e-4, 7.5e-4) > _STEEP
    top = s[np.argmin(z)]
    side = np.flatnonzero(steep & (sign * (at - top) > 0.0))
    if not len(side):
        return None
    place = float(np.interp(at[side[0] if sign > 0 else side[-1]], s, y))
    return place if y[0] + 1.5e-3 < place < y[-1] - 1.5e-3 else None


def _at_shares(outline: Tuple[np.ndarray, np.ndarray], marks: List[float], per_part: int = 60) -> np.ndarray:
    """Points at equal shares of the length between marks, as the model blends them."""
    y, z = outline
    s = _arc(y, z)
    ends = [0.0, *np.interp(marks, y, s), s[-1]]
    at = np.concatenate([np.linspace(low, high, per_part) for low, high in zip(ends, ends[1:])])
    return np.column_stack([np.interp(at, s, y), np.interp(at, s, z)])


def _spacing_error(x: List[float], outlines: List[Tuple[np.ndarray, np.ndarray]], marks: List[List[float]]) -> float:
    """Largest distance, along the normal and on the upper 15 mm, of an outline from the straight blend of its neighbours [m]."""
    before, here, after = (_at_shares(outline, each) for outline, each in zip(outlines, marks))
    share = (x[1] - x[0]) / (x[2] - x[0])
    away = here - ((1.0 - share) * before + share * after)
    along = np.gradient(here, axis=0)
    size = np.hypot(*along.T)
    upper = (here[:, 1] < here[:, 1].min() + 0.015) & (size > 0.0)
    normal = np.abs(away[:, 0] * along[:, 1] - away[:, 1] * along[:, 0])
    return float(np.max(normal[upper] / size[upper]))


def _thin(face: Face, tolerance: float) -> List[str]:
    said = [f"{face.kind}: section {face.numbers[k] + 1} at {face.distances[k]:.5g} m is {1e3 * error:.2f} mm off the mean of its neighbours, "
            f"{1e3 * (face.distances[k] - face.distances[k - 1]):.0f} and {1e3 * (face.distances[k + 1] - face.distances[k]):.0f} mm away: "
            "half the spacing leaves a quarter of that"
            for k, error in enumerate(face.spacing_errors) if error > tolerance]
    return said


def _kind(run: List[_Piece], runs: List[List[_Piece]]) -> str:
    """A face that begins or ends beside another, on its gauge side: a blade where it lies against it there, else a nose; the
    other is a stock or a wing rail. A face beside another over its whole length and as high is a check rail."""

    def beside(run: List[_Piece]) -> List[Tuple[_Piece, List[_Piece], _Piece]]:
        return [(piece, other, theirs) for piece in run for other in runs if other is not run for theirs in other
                if theirs.number == piece.number and (theirs.y[0] > piece.y[-1] - 2e-3 or piece.y[0] > theirs.y[-1] - 2e-3)]

    def kind_of_gauge_face(run: List[_Piece]) -> Optional[str]:
        both = [(piece, theirs) for piece, _, theirs in beside(run) if theirs.y[0] > piece.y[-1] - 2e-3]
        if not both:
            return None
        if all(piece.z.min() < theirs.z.min() + 5e-3 for piece, theirs in both) and len(both) == len(run):
            return "check"
        tip = run[0] if run[0].z.min() > run[-1].z.min() else run[-1]
        near = [theirs.y[0] - piece.y[-1] for piece, theirs in both if piece is tip]
        return "blade" if near and min(near) < 10e-3 else "nose"

    own = kind_of_gauge_face(run)
    if own is not None:
        return own
    names = [kind_of_gauge_face(other) for _, other, _ in beside(run)]
    for mine, theirs in (("stock", "blade"), ("wing", "nose")):
        if theirs in names:
            return mine
    return "rail"


def _wide_enough(y: np.ndarray, z: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """A narrow outline, or one whose highest point is its end, goes on downwards: the library wants 20 mm and a top within. Such
    flanks lie under a face beside it, or where no wheel comes."""
    missing = max(0.0, _LEAST_WIDTH - float(y[-1] - y[0]))
    sides = [side for side in (0, -1) if z[side] <= z.min() + 1e-6]
    for side, sign in ((0, -1.0), (-1, 1.0)):
        length = max(3e-3 if side in sides else 0.0, missing if side == -1 else 0.0)
        if length > 0.0:
            more = sign * np.linspace(0.0, length, max(4, int(length / 1e-3)))[1:]
            fall = np.abs(more) * 1.5
            y = np.r_[y[side] + more[::-1], y] if side == 0 else np.r_[y, y[side] + more]
            z = np.r_[z[side] + fall[::-1], z] if side == 0 else np.r_[z, z[side] + fall]
    return y, z
