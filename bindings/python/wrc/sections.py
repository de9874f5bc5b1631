"""Measured sections of a rail that changes along the track: a turnout, a crossing, a joint.

Each section is one line from the gauge side to the field side, with gaps, as an instrument or a drawing has it. rail_faces() parts
the lines into faces (blade, stock, wing, nose, check), follows them along the track, finds marks and makes the sections of a
model. read_sections() and write_sections() know .slcs of CONTACT, a table of places with a file of points for each, and columns
of x, y, z. Errors name the section by its number, counted from 1, and its distance."""
from __future__ import annotations

import ctypes as c
import dataclasses
import os
import re
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _interface as i
from . import _library as _l
from .profiles import UNITS, _columns, _simpack

_SENTENCE = 1024  # bytes


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
    sections: each outline as members of wrc.RailSection but for the surface; none of a check rail
    """

    kind: str
    numbers: List[int]
    distances: List[float]
    outlines: List[Tuple[np.ndarray, np.ndarray]]
    marks: List[List[float]]
    spacing_errors: List[float]
    sections: List[Dict[str, Any]]


@dataclasses.dataclass
class RailFaces:
    """The faces of a rail, from the gauge side. `rail_sections` goes into wrc.Model(rail_sections=...).

    notes: what was left out or joined; thin: where sections are too far apart, or faces more than a model holds
    """

    faces: List[Face]
    notes: List[str]
    thin: List[str]
    _found_in: Callable[[Dict[str, float]], "RailFaces"] = dataclasses.field(repr=False)

    def part(self, first: float, last: float) -> "RailFaces":
        """The faces from one place along the track to another [m], with a section beyond on either side."""
        return self._found_in({"first": first, "last": last})

    @property
    def rail_sections(self) -> List[Dict[str, Any]]:
        """Sections as members of wrc.RailSection, those of a face side by side. Check rails are left out: config.check_rail guides
        the flange's back, the same all along the track."""
        running = [face for face in self.faces if face.kind != "check"]
        return [{**section, "surface": surface} for surface, face in enumerate(running) for section in face.sections]

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


def rail_faces(sections: Sequence[MeasuredSection], **limits: Any) -> RailFaces:
    """Parts sections into faces that a wheel may roll on, and follows these along the track.

    limits: members of wrc.RailFacesProblem: interruptions, depth, gap, kink, least_width, tolerance; first and last, the part of the
        track that is wanted [m]
    """
    given = []
    for number, each in enumerate(sections, 1):
        y, z = (np.asarray(values, float) for values in (each.y, each.z))
        if y.shape != z.shape or y.ndim != 1:
            raise SectionError(number, each.distance, f"{y.size} values of y and {z.size} of z")
        given.append(i.SectionLine(distance=each.distance, y=y, z=z))
    problem = i.RailFacesProblem(sections=given, **limits)
    handle, text = c.c_void_p(), c.create_string_buffer(_SENTENCE)
    status = i._wrc_rail_faces_create(problem, c.byref(handle), text, _SENTENCE)
    unsound = re.search(r"problem\.sections\[(\d+)\]: [^:]*: (.*?)( \(section \d+ at \S+ m\))?$", text.value.decode())
    if status == i.Status.ERROR_PROFILE and unsound:
        number = int(unsound.group(1))
        raise SectionError(number + 1, sections[number].distance, unsound.group(2))
    _l.check(status, text)
    try:
        return _faces(handle, sections, limits)
    finally:
        i._wrc_rail_faces_destroy(handle)


def _faces(handle: c.c_void_p, sections: Sequence[MeasuredSection], limits: Dict[str, Any]) -> RailFaces:
    """What a handle of the library holds, copied."""
    found = i.FoundFaces._new()
    _l.check(i._wrc_rail_faces_found(handle, found))
    faces: List[Face] = []
    taken = 0  # of the model's sections, which check rails have none of
    for index in range(found.outline_count):
        outline = i.FaceOutline._new()
        _l.check(i._wrc_rail_faces_outline(handle, index, outline))
        if outline.face == len(faces):
            faces.append(Face(outline.kind.name.lower(), [], [], [], [], [], []))
        face = faces[-1]
        marks = [] if outline.marks is None else outline.marks.tolist()
        face.numbers.append(outline.number)
        face.distances.append(outline.distance)
        face.outlines.append((outline.y.copy(), outline.z.copy()))
        face.marks.append(marks)
        face.spacing_errors.append(outline.spacing_error)
        if face.kind != "check":
            section = found._rail_sections[taken]
            taken += 1
            face.sections.append({"distance": section.distance, "z": section.z, "marks": marks,
                                  "profile": {"kind": "POINTS", "y": section.profile.y.copy(), "z": section.profile.z.copy()}})
    return RailFaces(faces, found.notes.splitlines(), found.thin.splitlines(), lambda part: rail_faces(sections, **{**limits, **part}))
