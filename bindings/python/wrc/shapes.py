"""Standard profiles beside those built into the library: wrc.Model(wheel="S1002", rail=wrc.shape("60E2")).

Dimensions are those of EN 13674-1:2017 (rails) and EN 13715:2020 (wheel, flange 28 mm high and 32.5 mm wide, 1:15 outside), as two
public programs have them (EN13674 and EN13715 of A. Rohrbeck). The standards themselves were not at hand."""
from __future__ import annotations

from typing import Dict, List, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _interface as i
from .profiles import ProfileFile

Points = Tuple[NDArray[np.float64], NDArray[np.float64]]
_DEPTH, _SIDE = 22.0, 20.0  # mm below the top; slope of a rail's side, 1:20

# Head of a rail from its middle: radius of each arc and y of its end [mm]; the last arc ends in the side of that slope.
_HEADS: Dict[str, Tuple[List[Tuple[float, float]], float, float]] = {
    "46E1": ([(300.0, 18.881 / 2), (80.0, 43.881 / 2)], 13.0, _SIDE),  # its side is upright: the arc is cut at a slope of 20
    "49E1": ([(300.0, 15.267 / 2), (80.0, 46.835 / 2)], 13.0, 17.2),
    "54E1": ([(300.0, 20.024 / 2), (80.0, 49.727 / 2)], 13.0, _SIDE),
    "60E1": ([(300.0, 20.456 / 2), (80.0, 52.053 / 2)], 13.0, _SIDE),
    "60E2": ([(200.0, 23.778 / 2), (70.0, 48.913 / 2), (16.0, 70.774 / 2)], 8.0, _SIDE),
}
WIDTHS = {"46E1": 65.0, "49E1": 67.0, "54E1": 70.0, "60E1": 72.0, "60E2": 72.0}  # of the head, 14 mm below its top [mm]

NAMES = {**{name: "rail" for name in _HEADS if name != "60E1"}, "1:40": "wheel"}


def _arc(radius: float, centre: Tuple[float, float], first: float, last: float, step: float, sign: float) -> Points:
    """Points of an arc between two y, equal angles apart [mm]; sign 1: the lower half of the circle, z pointing down."""
    ends = np.arcsin((np.array([first, last]) - centre[0]) / radius)
    angle = np.linspace(ends[0], ends[1], 2 + int(abs(np.ptp(ends)) * radius / step))
    return centre[0] + radius * np.sin(angle), centre[1] + sign * radius * np.cos(angle)


def _joined(pieces: List[Points]) -> Points:
    """Pieces one behind the other, their common ends once."""
    y, z = (np.concatenate(each) for each in zip(*pieces))
    keep = np.concatenate([[True], np.diff(y) > 1e-9])
    return y[keep], z[keep]


def _head(name: str) -> Points:
    """Half a rail's head and its mirror image: arcs with a common tangent where they meet [mm]."""
    arcs, corner, side = _HEADS[name]
    pieces: List[Points] = []
    y, z, angle = 0.0, 0.0, 0.0
    for radius, end in [*arcs, (corner, np.inf)]:
        centre = y - radius * np.sin(angle), z + radius * np.cos(angle)
        angle = float(np.arctan(side)) if end == np.inf else float(np.arcsin((end - centre[0]) / radius))
        pieces.append(_arc(radius, centre, y, centre[0] + radius * np.sin(angle), min(0.5, radius / 60), -1.0))
        y, z = (float(each[-1]) for each in pieces[-1])
    if _DEPTH > z:
        down = np.linspace(0.0, 1.0, 9)
        pieces.append((y + down * (_DEPTH - z) / side, z + down * (_DEPTH - z)))
    y_half, z_half = _joined(pieces)
    return np.concatenate([-y_half[:0:-1], y_half]), np.concatenate([z_half[:0:-1], z_half])


def _line(y0: float, z0: float, y1: float, z1: float) -> Points:
    part = np.linspace(0.0, 1.0, 2 + int(abs(y1 - y0) / 0.5))
    return y0 + part * (y1 - y0), z0 + part * (z1 - z0)


def _flange() -> Points:
    """Back, top, outside and root of a flange 28 mm high and 32.5 mm wide, that of the S1002, down to D1 (y = -35) [mm]."""
    outside = _line(-39.764473993, 15.675122, -38.426669071, 11.999533)
    return _joined([_arc(20.5, (-49.5, 9.519259302), -69.5, -62.764705882, 0.3, 1.0), _arc(12.0, (-55.0, 16.0), -62.764705882, -49.662510381, 0.2, 1.0),
                    _arc(20.0, (-58.558326413, 8.834924130), -49.662510381, -39.764473993, 0.3, 1.0), outside,
                    _arc(13.0, (-26.210665, 16.446), -38.426669071, -35.0, 0.2, -1.0)])


def _wheel() -> Points:
    """The profile 1:40: flange of the S1002, arcs of 13 and 36 mm, 1:40 to y = 35, 1:15 beyond [mm]."""
    return _joined([_flange(), _arc(13.0, (-26.210665, 16.446), -35.0, -32.696, 0.2, -1.0),
                    _arc(36.0, (-14.740, 36.38), -32.696, -15.640, 0.3, -1.0), _line(-15.640, 0.391, 0.0, 0.0),
                    _line(0.0, 0.0, 35.0, -0.875), _line(35.0, -0.875, 60.0, -0.875 - 25.0 / 15.0)])


def shape(name: str) -> ProfileFile:
    """A standard profile by its name: the rails 46E1, 49E1, 54E1, 60E2, the wheel 1:40 (also as GV 1/40)."""
    name = name.upper().replace("GV", "").replace("/", ":").strip()
    if name not in NAMES:
        raise ValueError(f"there is no shape {name!r}: S1002, 60E1, UIC60_BENCHMARK are the library's, {', '.join(NAMES)} the package's; others come "
                         "from files, wrc.read_profile()")
    body = NAMES[name]
    y, z = _head(name) if body == "rail" else _wheel()
    source = "EN 13674-1:2017" if body == "rail" else "EN 13715:2020, flange 28 x 32.5 mm"
    return ProfileFile(1e-3 * y, 1e-3 * z, body, name, notes=[f"dimensions of {source}"])
