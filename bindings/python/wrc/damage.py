"""Wear, fatigue and temperature beyond one contact: bins along a profile, profiles that wear, flange dimensions, heat of a strip."""
from __future__ import annotations

import ctypes as c
from typing import Any, Optional, Tuple

import numpy as np

from . import _interface as i
from . import _library as _l

_SENTENCE = 1024
_POINTS = 20000  # of a profile at most


class Bins:
    """Sums over the arc length of a profile, and of a rail along the track, in whole numbers: the same bits in whatever order
    contacts and other bins are added. Filled by wrc.Contact.accumulate().

    count, first, width: bins of a row, arc length [m] at which the first begins, their width [m]
    rows, row_first, row_length: along the track; row_length 0: one row for all distances
    """

    def __init__(self, count: int, first: float, width: float = 1e-3, rows: int = 1, row_first: float = 0.0, row_length: float = 0.0):
        self.shape = rows, count
        self._told = count, first, width, rows, row_first, row_length
        self._bins = (i.DamageBin * (rows * count + 1))()
        self.struct = i.DamageBins(first=first, width=width, row_first=row_first, row_length=row_length, count=count, row_count=rows)
        self.struct.bin_size = c.sizeof(i.DamageBin)
        self.struct._bins = c.cast(self._bins, c.POINTER(i.DamageBin))

    @property
    def arc(self) -> np.ndarray:
        """Arc length at the middle of each bin [m]; Model.arc_places() has the places."""
        return self.struct.first + self.struct.width * (np.arange(self.shape[1]) + 0.5)

    def values(self, quantity: Any) -> np.ndarray:
        """What the bins hold of a wrc.DamageQuantity or its name ("WORK"), shape (rows, count), in the units told there."""
        return self._values(quantity)[:-1].reshape(self.shape)

    def beside(self, quantity: Any) -> float:
        """The same of all that fell beside the bins."""
        return float(self._values(quantity)[-1])

    def _values(self, quantity: Any) -> np.ndarray:
        found = np.zeros(len(self._bins))
        status = _l.check(i._wrc_damage_values(self.struct, int(i.DamageQuantity.of(quantity)), found))
        if status == i.Status.FLAG_SUM_OVERFLOW:
            raise _l.fault(status)
        return found

    def merge(self, other: "Bins") -> "Bins":
        """Adds bins of the same places; gives these bins."""
        status = _l.check(i._wrc_damage_merge(self.struct, other.struct))
        if status == i.Status.FLAG_SUM_OVERFLOW:
            raise _l.fault(status)
        return self

    def __reduce__(self) -> Any:
        return _bins, (self._told, bytes(self._bins))

    def __repr__(self) -> str:
        return (f"wrc.Bins: {self.shape[0]} x {self.shape[1]}, arc length {1e3 * self.struct.first:g} .. "
                f"{1e3 * (self.struct.first + self.shape[1] * self.struct.width):g} mm")


def _bins(told: Tuple[Any, ...], content: bytes) -> Bins:
    made = Bins(*told)
    c.memmove(made._bins, content, len(content))
    return made


def whole_life_damage(t_gamma: float, laws: Optional[i.FatigueLaws] = None) -> float:
    """Damage of one passage by the Whole Life Rail Model; 1 is a crack.

    t_gamma: energy dissipated per metre by a patch [N]
    laws: None: the published ones
    """
    found = c.c_double()
    _l.check(i._wrc_whole_life_damage(laws, t_gamma, c.byref(found)))
    return found.value


def flash_temperature(power_density: Any, cell: float, speed: float, wheel: Optional[i.HeatProperties] = None,
                      rail: Optional[i.HeatProperties] = None) -> np.ndarray:
    """Rise of the temperature of the surfaces along strips [K], of the shape of power_density.

    power_density: the last axis along a strip from the leading edge on, at the middles of cells [W/m^2]
    cell: their length [m]; speed: of rolling [m/s]
    wheel, rail: how they take up heat; None: the defaults
    """
    rise = np.array(power_density, np.float64, order="C")
    wheel, rail = wheel or i.HeatProperties(), rail or i.HeatProperties()
    for strip in rise.reshape(-1, rise.shape[-1]):
        _l.check(i._wrc_flash_temperature(strip.size, cell, strip, speed, wheel, rail, strip))
    return rise


def remove_wear(y: Any, z: Any, depth: Any, **wear: Any) -> Tuple[i.WornProfile, np.ndarray, np.ndarray]:
    """A profile with wear taken off along its normals: what was done (passages, depth, area), and y, z of the worn profile [m].

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
    flange_back_to_origin: along y from the flange's back to y = 0 [m]; 0.07 of most wheels
    """
    y, z = (np.ascontiguousarray(each, np.float64) for each in (y, z))
    if y.shape != z.shape or y.ndim != 1:
        raise ValueError(f"y and z have the shapes {y.shape} and {z.shape}")
    found, text = i.Flange._new(), c.create_string_buffer(_SENTENCE)
    _l.check(i._wrc_flange_dimensions(y.size, y, z, flange_back_to_origin, found, text, _SENTENCE), text)
    return found
