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
from .profiles import UNITS

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
    if unit is not None and unit not in UNITS:
        raise ValueError(f"there is no unit {unit!r}: choose {', '.join(UNITS)}")
    handle, text = c.c_void_p(), c.create_string_buffer(_SENTENCE)
    _l.check(i._wrc_section_file_read(os.fsencode(path), UNITS[unit] if unit else 0.0, mirror_y, mirror_z, c.byref(handle), text, _SENTENCE), text)
    found: List[MeasuredSection] = []
    try:
        line = i.SectionLine()
        while i._wrc_section_file_line(handle, len(found), line) == i.Status.OK:
            found.append(MeasuredSection(line.distance, np.array(line.y), np.array(line.z)))
    finally:
        i._wrc_section_file_destroy(handle)
    return found


def write_sections(path: Union[str, "os.PathLike[str]"], sections: Sequence[MeasuredSection]) -> None:
    """Writes sections as .slcs of CONTACT, with their points [mm] in NAME_1.txt and so on beside it; as columns x, y, z [m] where the
    path ends otherwise. Places of .slcs are in m."""
    lines, text = _lines(sections), c.create_string_buffer(_SENTENCE)
    line: Any = i.SectionLine
    _l.check(i._wrc_section_file_write(os.fsencode(path), (line * len(lines))(*lines), len(lines), text, _SENTENCE), text)


# ------------------------------------------------------------------------------------------------------------- faces


def rail_faces(sections: Sequence[MeasuredSection], **limits: Any) -> RailFaces:
    """Parts sections into faces that a wheel may roll on, and follows these along the track.

    limits: members of wrc.RailFacesProblem: interruptions, depth, gap, kink, least_width, tolerance; first and last, the part of the
        track that is wanted [m]
    """
    problem = i.RailFacesProblem(sections=_lines(sections), **limits)
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


def _lines(sections: Sequence[MeasuredSection]) -> List[i.SectionLine]:
    """Sections as the library reads them."""
    made = []
    for number, each in enumerate(sections, 1):
        y, z = (np.asarray(values, float) for values in (each.y, each.z))
        if y.shape != z.shape or y.ndim != 1:
            raise SectionError(number, each.distance, f"{y.size} values of y and {z.size} of z")
        made.append(i.SectionLine(distance=each.distance, y=y, z=z))
    return made


def _faces(handle: c.c_void_p, sections: Sequence[MeasuredSection], limits: Dict[str, Any]) -> RailFaces:
    """What a handle of the library holds, copied."""
    found: Any = i.FoundFaces._new()
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
        face.outlines.append((np.array(outline.y), np.array(outline.z)))
        face.marks.append(marks)
        face.spacing_errors.append(outline.spacing_error)
        if face.kind != "check":
            section = found._rail_sections[taken]
            taken += 1
            face.sections.append({"distance": section.distance, "z": section.z, "marks": marks,
                                  "profile": {"kind": "POINTS", "y": section.profile.y.copy(), "z": section.profile.z.copy()}})
    return RailFaces(faces, found.notes.splitlines(), found.thin.splitlines(), lambda part: rail_faces(sections, **{**limits, **part}))
