"""Wear, fatigue and temperature beyond one contact: bins along a profile, heat of a strip, damage of a passage."""
from __future__ import annotations

import ctypes as c
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _interface as i
from . import _library as _l


class Bins:
    """Sums over the arc length of a profile, and of a rail along the track, in whole numbers: the same bits in whatever order
    contacts and other bins are added. Filled by wrc.Contact.accumulate().

    count, first, width: bins of a row, arc length [m] at which the first begins, their width [m]
    rows, row_first, row_length: along the track; row_length 0: one row for all distances
    """

    def __init__(self, count: int, first: float, width: float = 1e-3, rows: int = 1, row_first: float = 0.0, row_length: float = 0.0):
        self.shape = rows, count
        self._told = count, first, width, rows, row_first, row_length
        kind: Any = i.DamageBin
        self._bins = (kind * (rows * count + 1))()
        self.struct = i.DamageBins(first=first, width=width, row_first=row_first, row_length=row_length, count=count, row_count=rows,
                                   bins=self._bins)

    @property
    def arc(self) -> NDArray[np.float64]:
        """Arc length at the middle of each bin [m]; Model.arc_places() has the places."""
        return np.asarray(self.struct.first + self.struct.width * (np.arange(self.shape[1]) + 0.5), np.float64)

    def values(self, quantity: i.DamageQuantityLike) -> NDArray[np.float64]:
        """What the bins hold of a wrc.DamageQuantity or its name ("WORK"), shape (rows, count), in the units told there."""
        return self._values(quantity)[:-1].reshape(self.shape)

    def beside(self, quantity: i.DamageQuantityLike) -> float:
        """The same of all that fell beside the bins."""
        return float(self._values(quantity)[-1])

    def _values(self, quantity: i.DamageQuantityLike) -> NDArray[np.float64]:
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
                      rail: Optional[i.HeatProperties] = None) -> NDArray[np.float64]:
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
