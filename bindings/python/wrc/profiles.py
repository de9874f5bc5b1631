"""Profile files: Simpack .prw and .prr, MiniProf .whl and .ban, GENSYS .wheel and .rail, plain columns y, z (CONTACT's). Conicity, wear, flange dimensions.

read_profile() gives points in the library's convention [m]: y strictly increasing, z down; of a wheel y = 0 at the running
circle, where z = 0, and the flange at y < 0; of a rail z = 0 at the top and the gauge side at y < 0. What it had to do to a
file for that stands in `notes`. Errors name file, line and likely cause."""
from __future__ import annotations

import ctypes as c
import dataclasses
import os
import re
import warnings
from typing import Any, Dict, List, Literal, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _interface as i
from . import _library as _l

_SENTENCE = 1024  # bytes
_POINTS = 20000  # of a profile at most
UNITS = {"mm": 1e-3, "m": 1.0, "cm": 1e-2, "um": 1e-6, "in": 25.4e-3}
NARROWEST, WIDEST = 0.020, 0.500  # m: what the library takes for a profile
BODIES = {".prw": "wheel", ".prr": "rail", ".whl": "wheel", ".ban": "rail", ".wheel": "wheel", ".rail": "rail"}
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d+)?$")
_ALL_COMMAS = re.compile(r"[-+]?\d+,\d{3,}\s*,\s*[-+]?\d+,\d{3,}$")
_DECIMAL_COMMAS = re.compile(r"[-+]?\d+,\d+(\s+[-+]?\d+,\d+)+$")
_SIMPACK_NUMBERS = ("approx.smooth", "point.dist.min", "shift.y", "shift.z", "rotate", "bound.y.min", "bound.y.max", "bound.z.min",
                    "bound.z.max", "mirror.y", "mirror.z", "inversion", "units.len.f", "units.ang.f")


class ProfileWarning(UserWarning):
    """A profile that was read and looks odd: a spike, a hole."""

    __module__ = "wrc"


class ProfileError(ValueError):
    """A profile file that cannot be used: its text begins with file and line."""

    __module__ = "wrc"

    def __init__(self, path: Any, line: Optional[int], why: str):
        self.path, self.line, self.why = str(path), line, why
        super().__init__(f"{path}:{line}: {why}" if line else f"{path}: {why}")

    def __reduce__(self) -> Any:
        return type(self), (self.path, self.line, self.why)


@dataclasses.dataclass
class ProfileFile:
    """A profile that was read: y, z [m], the body it is of, and what was done to it. Goes where a wrc.Profile does."""

    y: NDArray[np.float64]
    z: NDArray[np.float64]
    body: str
    path: str = ""
    smoothing: float = 0.0
    notes: List[str] = dataclasses.field(default_factory=list)
    header: Dict[str, str] = dataclasses.field(default_factory=dict)
    lines: Optional[NDArray[np.int64]] = None

    def as_struct(self) -> i.Profile:
        """As wrc.Profile: config.wheel = file.as_struct()"""
        return i.Profile(kind="POINTS", y=self.y, z=self.z, smoothing=self.smoothing)

    def mirrored(self) -> "ProfileFile":
        """The same with its sides exchanged: y becomes -y."""
        lines = None if self.lines is None else self.lines[::-1]
        return dataclasses.replace(self, y=-self.y[::-1], z=self.z[::-1].copy(), lines=lines, notes=self.notes + ["mirrored: y is -y"])

    def check(self) -> "ProfileFile":
        """Raises ProfileError with the library's sentence where no model can be made of these points. The other body is a
        built-in shape."""
        config = i.Config()
        shapes: Dict[str, Any] = {"wheel": "S1002", "rail": "60E1", self.body: self.as_struct()}
        config.set(**shapes)
        text = c.create_string_buffer(_SENTENCE)
        if i._wrc_config_check(config, text, _SENTENCE) < 0:
            sentence = text.value.decode(errors="replace")
            if self.body == "rail" and "upside down" in sentence:
                sentence += "; or is it a wheel, read as a rail?"
            at = re.search(r"\[(\d+)\]", sentence)
            line = int(self.lines[int(at.group(1))]) if at and self.lines is not None and int(at.group(1)) < len(self.lines) else None
            raise ProfileError(self.path, line, sentence)
        return self

    def __repr__(self) -> str:
        rows = [f"wrc.ProfileFile {self.path}", f"  body    {self.body}, {len(self.y)} points",
                f"  y       {1e3 * self.y[0]:.3f} .. {1e3 * self.y[-1]:.3f} mm", f"  z       {1e3 * self.z.min():.3f} .. {1e3 * self.z.max():.3f} mm"]
        return "\n".join(rows + [f"  note    {each}" for each in self.notes])


def read_profile(path: Union[str, "os.PathLike[str]"], body: Optional[Literal["wheel", "rail"]] = None, *,
                 unit: Optional[Literal["mm", "m", "cm", "um", "in"]] = None,
                 mirror_y: Optional[bool] = None, mirror_z: Optional[bool] = None, running_circle: float = 0.0,
                 keep_origin: bool = False, smoothing: float = 0.0, columns: Optional[Tuple[int, int]] = None) -> ProfileFile:
    """Reads a profile. The file's ending says what it is: .prw .prr Simpack, .whl .ban MiniProf, .wheel .rail GENSYS, any other plain
    columns, as CONTACT has them. A point
    that leaves its neighbours and a hole between points are told by a wrc.ProfileWarning, and stay.

    body: "wheel" or "rail"; must be given where the ending does not say it
    unit: of the points, "mm", "m", "cm", "um", "in"; None: as the file says, or the one of mm and m that fits
    mirror_y, mirror_z: turn that axis or do not; None: z is turned down; y of a wheel such that its flange is at y < 0, while
        of a rail nobody can tell, and it stays as it is
    running_circle: y of a wheel's running circle in the file's axes, before any mirroring [m]
    keep_origin: leave the heights as they are, for config.track.placement ORIGIN; else a wheel gets z = 0 at y = 0, a rail
        z = 0 at its top
    smoothing: as wrc.Profile.smoothing, for measured points [m]
    columns: of plain columns those with y and z, (0, 1) for the first two
    """
    path = os.fspath(path)
    notes: List[str] = []
    with open(path, "rb") as file:  # before questions about a file that is not there
        rows = _text(path, file.read(), notes).splitlines()
    ending = os.path.splitext(path)[1].lower()
    body = body or BODIES.get(ending)  # type: ignore[assignment]
    if body not in ("wheel", "rail"):
        raise ProfileError(path, None, f"is it of a wheel or a rail? Its ending does not say: pass body=\"wheel\" or \"rail\"" + (f", not {body!r}" if body else ""))
    if unit is not None and unit not in UNITS:
        raise ProfileError(path, None, f"there is no unit {unit!r}: choose {', '.join(UNITS)}")
    if ending in (".prw", ".prr"):
        points, lines, header, said = _simpack(path, rows, body, notes)
    else:
        points, lines, header, said = _columns(path, rows, ending in (".whl", ".ban"), columns, notes)
    if len(points) < 4:
        raise ProfileError(path, len(rows) or None, f"{len(points)} points; a profile has at least 4")
    if ending == ".rail" and mirror_y is None:  # GENSYS: y towards the middle of the track
        mirror_y = True
        notes.append("GENSYS: y is taken to point to the middle of the track, as it does for wheels")
    y, z = _in_metres(path, points, unit, said, notes)
    if body == "wheel" and running_circle:
        y = y - running_circle
    y, z, lines = _along(path, y, z, lines, notes)
    y, z, lines = _turned(path, body, y, z, lines, mirror_y, mirror_z, notes)
    y, z, lines = _single_valued(path, body, y, z, lines, notes)
    for each in _oddities(y, z, lines):
        notes.append(each)
        warnings.warn(f"{path}: {each}", ProfileWarning, stacklevel=2)
    if body == "wheel":
        if not y[0] < 0.0 < y[-1]:
            raise ProfileError(path, None, f"y = 0, the running circle, is outside {1e3 * y[0]:.1f} .. {1e3 * y[-1]:.1f} mm: pass running_circle=")
        origin = float(np.interp(0.0, y, z))
    else:
        origin = float(z.min())
    if origin != 0.0 and not keep_origin:
        z = z - origin
        if abs(origin) > 1e-6:
            notes.append(f"z moved by {-1e3 * origin:.4f} mm: " + ("0 at the running circle" if body == "wheel" else "0 at the top"))
    return ProfileFile(y, z, body, path, smoothing, notes, header, lines).check()


def _number(text: str) -> Optional[float]:
    return float(text.replace("d", "e").replace("D", "e")) if _NUMBER.match(text) else None


def _text(path: str, content: bytes, notes: List[str]) -> str:
    """A file's text, in UTF-8 or, as a mark or every other byte says, UTF-16."""
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        encoding = "utf-16"
    elif b"\0" in content[:200]:
        encoding = "utf-16-le" if content[1:2] == b"\0" else "utf-16-be"
    else:
        if content[:3] == b"\xef\xbb\xbf":
            notes.append("begins with a byte order mark, which is no part of its first number")
        return content.decode("utf-8-sig", errors="replace")
    try:
        text = content.decode(encoding)
    except UnicodeDecodeError:
        raise ProfileError(path, None, "is neither text in UTF-8 nor in UTF-16: is it a table of a spreadsheet? Save it as CSV") from None
    notes.append("read as UTF-16")
    return text


def _row_counter(path: str, points: List[List[float]], heading: str, notes: List[str]) -> Tuple[int, int]:
    """Columns of y and z where the first may count rows, as pandas' index does."""
    first = [each[0] for each in points]
    if min(map(len, points)) < 3 or first != list(range(len(first))):
        return 0, 1
    if heading.startswith((",", ";")):
        notes.append("the first column counts rows and has no heading, as pandas' index: left out")
        return 1, 2
    raise ProfileError(path, None, f"the first of its columns counts 0 .. {len(first) - 1}: is it pandas' index, which to_csv(index=False) "
                       "leaves out? columns=(1, 2) has y and z behind it, columns=(0, 1) takes it for y")


def _columns(path: str, rows: List[str], miniprof: bool, columns: Optional[Tuple[int, int]],
             notes: List[str]) -> Tuple[np.ndarray, np.ndarray, Dict[str, str], str]:
    """Columns of numbers behind a heading; MiniProf's heading is lines NAME=value, of which ColumnDef and XYPoints are
    read. Commas are decimal where semicolons part the numbers, or where blanks alone do."""
    header: Dict[str, str] = {}
    points: List[List[float]] = []
    first, second = columns or (0, 1)
    lines: List[int] = []
    for at, row in enumerate(rows, 1):
        text = re.split(r"[#!%]", row)[0].strip()
        if not text:
            continue
        if "=" in text and not points:
            name, value = text.split("=", 1)
            header[name.strip()] = value.strip()
            if name.strip().lower() == "columndef":
                names = [each.split("=")[0].strip().upper() for each in value.split(",")]
                if "X" not in names or "Y" not in names:
                    raise ProfileError(path, at, f"ColumnDef has no columns X and Y: {value.strip()}")
                first, second = names.index("X"), names.index("Y")
            continue
        if ";" in text:
            cells = [each.strip().replace(",", ".") for each in text.split(";") if each.strip()]
        elif _ALL_COMMAS.match(text) and not columns:
            raise ProfileError(path, at, "commas are decimal and part the numbers, too: part these by semicolons or blanks")
        elif _DECIMAL_COMMAS.match(text):
            cells = text.replace(",", ".").split()
        else:
            cells = text.replace(",", " ").split()
        numbers = [_number(each) for each in cells]
        if None in numbers:
            if points or numbers[0] is not None:
                raise ProfileError(path, at, f"'{cells[numbers.index(None)]}' is no number")
            header.setdefault("heading", text)
            continue
        if len(numbers) <= max(first, second):
            raise ProfileError(path, at, f"{len(numbers)} number{'s' if len(numbers) != 1 else ''} in this line; y and z are columns "
                               f"{first + 1} and {second + 1}")
        points.append(numbers)  # type: ignore[arg-type]
        lines.append(at)
    if points and not columns and not miniprof:
        first, second = _row_counter(path, points, header.get("heading", ""), notes)
    promised = next((value for name, value in header.items() if name.lower() == "xypoints"), "")
    if promised.isdigit() and int(promised) != len(points):
        raise ProfileError(path, len(rows), f"XYPoints promises {promised} points, {len(points)} are there: is the file whole?")
    chosen = [(each[first], each[second]) for each in points]
    return np.array(chosen, float).reshape(-1, 2), np.array(lines), header, "mm" if miniprof else ""


def _simpack(path: str, rows: List[str], body: str, notes: List[str]) -> Tuple[np.ndarray, np.ndarray, Dict[str, str], Any]:
    """Simpack's sections header, spline, point; what the keys of spline ask for is done in the order of its own reader."""
    header: Dict[str, str] = {}
    values: Dict[str, float] = {}
    where: List[str] = []
    points: List[Tuple[float, float]] = []
    lines: List[int] = []
    for at, row in enumerate(rows, 1):
        text = row.split("!")[0].strip()
        if not text:
            continue
        section = re.match(r"(\w+)\.(begin|end)\b", text)
        if section:
            name, what = section.groups()
            if name not in ("header", "spline", "point"):
                raise ProfileError(path, at, f"there is no section {name}, only header, spline and point")
            if what == "begin":
                where.append(name)
            elif not where or where.pop() != name:
                raise ProfileError(path, at, f"{name}.end without {name}.begin")
            continue
        if "=" in text:
            if not where:
                raise ProfileError(path, at, f"'{text}' stands outside header and spline")
            name, value = (each.strip() for each in text.split("=", 1))
            header[name] = value.strip("'\"")
            if name in _SIMPACK_NUMBERS:
                number = _number(value)
                if number is None:
                    raise ProfileError(path, at, f"{name} = '{value}' is no number")
                values[name] = number
            continue
        if where[-1:] != ["point"]:
            raise ProfileError(path, at, f"'{text}' is neither NAME = value nor within point.begin, point.end")
        numbers = [_number(each) for each in text.split()]
        if len(numbers) < 2 or None in numbers[:2]:
            raise ProfileError(path, at, f"'{text}' is no point: y and z, and a weight if wanted")
        points.append((numbers[0], numbers[1]))  # type: ignore[arg-type]
        lines.append(at)
    if where:
        raise ProfileError(path, len(rows), f"{where[-1]}.end is missing: is the file whole?")
    told = header.get("type")
    if told in ("0", "1") and ("rail", "wheel")[int(told)] != body:
        raise ProfileError(path, None, f"its header says type = {told}, a {('rail', 'wheel')[int(told)]}, and it is read as a {body}")
    array, at_line = np.array(points, float).reshape(-1, 2), np.array(lines)
    if values.get("point.dist.min", 0.0) > 0.0 and len(array):
        kept = [0]
        for k in range(1, len(array)):
            if abs(array[k, 0] - array[kept[-1], 0]) > values["point.dist.min"]:
                kept.append(k)
        array, at_line = array[kept], at_line[kept]
    array = array + [values.get("shift.y", 0.0), values.get("shift.z", 0.0)]
    turn = values.get("rotate", 0.0) / values.get("units.ang.f", 1.0)
    if turn:
        array = array @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    low, high = values.get("bound.y.min", 0.0), values.get("bound.y.max", 0.0)
    if low < high:
        inside = (array[:, 0] >= low) & (array[:, 0] <= high)
        array, at_line = array[inside], at_line[inside]
    low, high = values.get("bound.z.min", 0.0), values.get("bound.z.max", 0.0)
    if low < high:
        array[:, 1] = np.clip(array[:, 1], low, high)
    for column, name in ((0, "mirror.y"), (1, "mirror.z")):
        if values.get(name) == 1:
            array[:, column] *= -1.0
    done = [name for name in ("shift.y", "shift.z", "rotate", "mirror.y", "mirror.z") if values.get(name)]
    if done:
        notes.append("done as the file asks: " + ", ".join(f"{name} = {values[name]:g}" for name in done))
    if values.get("approx.smooth"):
        notes.append(f"approx.smooth = {values['approx.smooth']:g} is not applied: wrc has smoothing=")
    factor = values.get("units.len.f")
    if factor is not None and factor <= 0.0:
        raise ProfileError(path, None, f"units.len.f = {factor:g}: how many of the file's units make a metre?")
    return array, at_line, header, 1.0 / factor if factor else ""


def _in_metres(path: str, points: np.ndarray, unit: Optional[str], said: Any, notes: List[str]) -> Tuple[np.ndarray, np.ndarray]:
    width = float(np.ptp(points[:, 0]))
    fitting = [name for name in ("mm", "m") if NARROWEST <= width * UNITS[name] <= WIDEST]
    if unit:
        scale, why = UNITS[unit], f"unit=\"{unit}\""
    elif said:
        scale, why = (UNITS[said], "the format") if isinstance(said, str) else (said, "units.len.f")
    else:
        if not fitting:
            others = [name for name, scale in UNITS.items() if NARROWEST <= width * scale <= WIDEST]
            advice = " or ".join(f'"{name}" ({1e3 * width * UNITS[name]:.0f} mm)' for name in others)
            raise ProfileError(path, None, f"is {width:g} wide, which is a profile neither in mm nor in m: " +
                               (f"pass unit={advice}" if others else "is y its first column? columns=(1, 2) names others"))
        scale, why = UNITS[fitting[0]], ""
        notes.append(f"taken as {fitting[0]}, which fits its width")
    if not NARROWEST <= width * scale <= WIDEST:
        raise ProfileError(path, None, f"by {why} the profile is {1e3 * width * scale:g} mm wide, outside {1e3 * NARROWEST:g} .. {1e3 * WIDEST:g} mm"
                           + (f": is it in {fitting[0]}?" if fitting else ""))
    return points[:, 0] * scale, points[:, 1] * scale


def _along(path: str, y: np.ndarray, z: np.ndarray, lines: np.ndarray, notes: List[str]) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points by increasing y where they stand the other way round, each once."""
    if not (np.isfinite(y).all() and np.isfinite(z).all()):
        raise ProfileError(path, int(lines[np.argmin(np.isfinite(y) & np.isfinite(z))]), "not a finite number")
    if y[-1] < y[0]:
        y, z, lines = y[::-1], z[::-1], lines[::-1]
    twice = np.flatnonzero((np.diff(y) == 0.0) & (np.diff(z) == 0.0))
    if len(twice):
        notes.append(f"{len(twice)} points left out that stand twice, the first in line {max(lines[twice[0]], lines[twice[0] + 1])}")
    keep = np.delete(np.arange(len(y)), twice + 1)
    return y[keep], z[keep], lines[keep]


def _turned(path: str, body: str, y: np.ndarray, z: np.ndarray, lines: np.ndarray, mirror_y: Optional[bool], mirror_z: Optional[bool],
            notes: List[str]) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """z down, and a wheel's flange at y < 0."""
    upwards = _points_up(body, y, z)
    if mirror_z is None and upwards or mirror_z:
        z = -z
        notes.append("z turned: in the file it points up" if mirror_z is None else "z mirrored as asked")
    if _points_up(body, y, z):
        raise ProfileError(path, None, f"z points up, which no {body} of the library's does: leave mirror_z to None")
    if body == "wheel":
        right = _flange(y, z) > 0.5 * (y[0] + y[-1])
        if mirror_y is not None and right != mirror_y:
            raise ProfileError(path, None, f"with mirror_y={mirror_y} its flange is at y > 0: the library's are at y < 0, of left wheels too")
        mirror_y = bool(right)
    if mirror_y:
        y, z, lines = -y[::-1], z[::-1], lines[::-1]
        notes.append("y mirrored: the flange is at y < 0 now" if body == "wheel" else "y mirrored as asked")
    return y, z, lines


def _level(y: np.ndarray, z: np.ndarray) -> float:
    """Height of the middle of the tread: the median over the width."""
    order = np.argsort(y)
    return float(np.median(np.interp(np.linspace(y.min(), y.max(), 401), y[order], z[order])))


def _flange(y: np.ndarray, z: np.ndarray) -> float:
    return float(y[np.argmax(np.abs(z - _level(y, z)))])


def _points_up(body: str, y: np.ndarray, z: np.ndarray) -> bool:
    """A wheel's flange hangs down from its tread; a rail's sides from its top."""
    if body == "wheel":
        away = z - _level(y, z)
        return bool(away[np.argmax(np.abs(away))] < 0.0)
    low, high = np.quantile(y, [0.1, 0.9])
    outer = (y < low) | (y > high)
    return bool(np.mean(z[outer]) < np.mean(z[~outer]))


def _single_valued(path: str, body: str, y: np.ndarray, z: np.ndarray, lines: np.ndarray,
                   notes: List[str]) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The part with strictly increasing y about the tread or the top. Ends that turn back (the flange's back, the web) are
    cut off; a profile that goes back and forth in its middle is refused."""
    start = int(np.argmin(np.abs(y))) if body == "wheel" else int(np.argmin(z))
    ends = []
    for step in (-1, 1):
        at = start
        while 0 <= at + step < len(y) and step * (y[at + step] - y[at]) > 0.0:
            at += step
        rest = y[at + step:] if step > 0 else y[:at]
        if len(rest) and np.max(step * rest) > step * y[at] + 1e-9:
            line = int(lines[at + step])
            raise ProfileError(path, line, f"y goes back from {1e3 * y[at]:.4f} to {1e3 * y[at + step]:.4f} mm and on again later: points "
                               "must run along the profile")
        ends.append(at)
    first, last = ends
    cut = first + len(y) - 1 - last
    if cut:
        notes.append(f"{cut} points left out where the profile turns back beyond y = {1e3 * y[first]:.3f} and {1e3 * y[last]:.3f} mm")
    return y[first:last + 1].copy(), z[first:last + 1].copy(), lines[first:last + 1]


def cone(slope: float, tread: Tuple[float, float] = (-0.035, 0.060)) -> i.Profile:
    """A wheel that is a cone without a flange: slope 1/20 or 1/40, over that part of y [m]. Its equivalent conicity is some
    3 or 5 % more, as the wheelset rolls when it shifts."""
    y = np.linspace(*tread, 200)
    return i.Profile(y=y, z=-slope * y)


SPIKE, HOLE = 0.3e-3, 2e-3  # m: what is told of at least


def _oddities(y: np.ndarray, z: np.ndarray, lines: np.ndarray) -> List[str]:
    """Sentences about points further from the line between their neighbours than half of what these are apart, one to three in a
    row, and about places without points five times as wide as the steps beside them."""
    found: List[str] = []
    steps = np.diff(y)
    told = np.zeros(len(y), bool)
    for count in (1, 2, 3):
        for k in range(1, len(y) - count):
            last = k + count
            chord = float(np.hypot(y[last] - y[k - 1], z[last] - z[k - 1]))
            off = z[k:last] - np.interp(y[k:last], [y[k - 1], y[last]], [z[k - 1], z[last]])
            if chord < 5e-3 and np.min(np.abs(off)) > max(SPIKE, 0.5 * chord) and not told[k - 1:last + 1].any():
                told[k:last] = True
                worst = k + int(np.argmax(np.abs(off)))
                found.append(f"line {lines[worst]}: z leaves its neighbours by {1e3 * np.max(np.abs(off)):.2f} mm at y = {1e3 * y[worst]:.3f} mm"
                             ": a spike?")
    for k in np.flatnonzero(steps > HOLE).tolist():
        if steps[k] < 5.0 * max([*steps[max(0, k - 2):k], *steps[k + 1:k + 3]]):
            continue
        found.append(f"line {lines[k]}: no points for {1e3 * steps[k]:.1f} mm behind y = {1e3 * y[k]:.3f} mm: a hole? A spline bridges it")
    return found


def results(kind: Any, count: int) -> Tuple[Any, Dict[str, NDArray[np.float64]]]:
    """A struct whose results are arrays, with arrays of that many numbers."""
    arrays = {name: np.zeros(count) for name in kind.members()}
    return kind(**arrays), arrays


def conicity(lateral: Any, radius_difference: Any, amplitudes: Any, **problem: Any) -> Dict[str, NDArray[np.float64]]:
    """Equivalent conicity of a rolling radius difference over amplitudes [m], as Model.wheelset_geometry() gives it: the
    members of wrc.Conicity as arrays. UIC 519, EN 15302.

    problem: method, contact_distance, radius of wrc.ConicityProblem
    """
    told = i.ConicityProblem(lateral=lateral, radius_difference=radius_difference, amplitudes=np.atleast_1d(amplitudes), **problem)
    found, arrays = results(i.Conicity, told.amplitude_count)
    text = c.create_string_buffer(_SENTENCE)
    _l.check(i._wrc_equivalent_conicity(told, found, text, _SENTENCE), text)
    return arrays


def remove_wear(y: Any, z: Any, depth: Any, **wear: Any) -> Tuple[i.WornProfile, NDArray[np.float64], NDArray[np.float64]]:
    """A profile with wear removed along its normals: what was done (passages, depth, area), and y, z of the worn profile [m].

    y, z: of the profile as wrc.Profile has it [m]
    depth: of each bin for one passage [m]
    wear: members of wrc.ProfileWear: body="RAIL", first, width of the bins, passages, largest_depth, smoothing, spacing
    """
    told = i.ProfileWear(y=y, z=z, depth=depth, **wear)
    worn_y, worn_z = np.zeros(_POINTS), np.zeros(_POINTS)
    worn, text = i.WornProfile(capacity=_POINTS, y=worn_y, z=worn_z), c.create_string_buffer(_SENTENCE)
    _l.check(i._wrc_profile_remove_wear(told, worn, text, _SENTENCE), text)
    return worn, worn_y[:worn.count].copy(), worn_z[:worn.count].copy()


def flange_dimensions(y: Any, z: Any, flange_back_to_origin: float) -> i.Flange:
    """Height, thickness and slope of a wheel's flange, EN 15313.

    y, z: of the profile as wrc.Profile has it [m]
    flange_back_to_origin: along y from the flange's back to y = 0, 0.07 of most wheels [m]
    """
    y, z = (np.ascontiguousarray(each, np.float64) for each in (y, z))
    if y.shape != z.shape or y.ndim != 1:
        raise ValueError(f"y and z have the shapes {y.shape} and {z.shape}")
    found, text = i.Flange._new(), c.create_string_buffer(_SENTENCE)
    _l.check(i._wrc_flange_dimensions(y.size, y, z, flange_back_to_origin, found, text, _SENTENCE), text)
    return found
