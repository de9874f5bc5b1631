"""Films on rail and wheel: bands whose bins hold water, oxide, leaves, sand, lubricant and heat, which passing wheels change."""
from __future__ import annotations

import ctypes as c
from typing import Any, Callable, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _interface as i
from . import _library as _l
from .contact import Contact


def _call(function: Callable[..., int], *arguments: Any) -> int:
    """Calls a function; raises the sentence of a failure."""
    text = c.create_string_buffer(400)
    status = function(*arguments, text, len(text))
    if status < 0 or status == i.Status.FLAG_SUM_OVERFLOW:
        raise _l.fault(status, text.value.decode())
    return status


class Band:
    """Running band of a rail along the track, or of a wheel round its tread (closed): wrc_surface of the C interface.

    count, length, first: bins, the length of one [m], distance at which the first begins [m]
    width: of the band, or of each row [m]; closed: the last bin is beside the first
    rows: number of rows across; 1: one band, on which the whole contact lies
    row_first: y of the profile at which the first of several rows begins [m]
    """

    def __init__(self, count: int, length: float, first: float = 0.0, width: float = 0.02, closed: bool = False, rows: int = 1,
                 row_first: float = 0.0):
        self._told = count, length, first, width, closed, rows, row_first
        kind: Any = i.SurfaceBin
        self._bins = (kind * (count * rows))()
        self.struct = i.Surface(count=count, length=length, first=first, width=width, closed=int(closed), bins=self._bins, rows=rows, row_first=row_first)

    def row(self, number: int) -> "Band":
        """One row as a band over the same bins, for a source or to be read."""
        one, (count, length, first, width, closed, rows, _) = Band.__new__(Band), self._told
        if not 0 <= number < rows:
            raise IndexError(f"row {number} of {rows}")
        kind: Any = i.SurfaceBin
        one._told = count, length, first, width, closed, 1, 0.0
        one._bins = (kind * count).from_buffer(self._bins, number * count * c.sizeof(kind))
        one.struct = i.Surface(count=count, length=length, first=first, width=width, closed=int(closed), bins=one._bins)
        return one

    @property
    def places(self) -> NDArray[np.float64]:
        """Distance of the middle of each bin [m]."""
        return np.asarray(self.struct.first + self.struct.length * (np.arange(self.struct.count) + 0.5), np.float64)

    def add(self, quantity: i.SurfaceQuantityLike, amount: float, start: float, end: float) -> "Band":
        """A source: puts an amount per area of a wrc.SurfaceQuantity ("WATER", ...) on a stretch [kg/m^2, heat J/m^2]; gives this band."""
        _call(i._wrc_surface_add, self.struct, int(i.SurfaceQuantity.of(quantity)), amount, start, end)
        return self

    def values(self, quantity: i.SurfaceQuantityLike, book: i.SurfaceBookLike = "AMOUNT") -> NDArray[np.float64]:
        """One column of the books of each bin, by default the amount, per area [kg/m^2, heat J/m^2]; with several rows shape (rows, bins)."""
        found = np.zeros(len(self._bins))
        _call(i._wrc_surface_values, self.struct, int(i.SurfaceQuantity.of(quantity)), int(i.SurfaceBook.of(book)), found, None)
        return found.reshape(self.struct.rows, -1) if self.struct.rows > 1 else found

    def total(self, quantity: i.SurfaceQuantityLike, book: i.SurfaceBookLike = "AMOUNT") -> float:
        """The same, summed over all bins [kg, heat J]."""
        found = np.zeros(1)
        _call(i._wrc_surface_values, self.struct, int(i.SurfaceQuantity.of(quantity)), int(i.SurfaceBook.of(book)), None, found)
        return float(found[0])

    def rest(self, laws: i.SurfaceLaws, duration: float) -> None:
        """Lets all bins cool and dry for a time [s]."""
        _call(i._wrc_surface_rest, self.struct, laws, duration)

    def merge(self, other: "Band") -> "Band":
        """Adds bins of the same places; gives this band."""
        _call(i._wrc_surface_merge, self.struct, other.struct)
        return self

    def __reduce__(self) -> Any:
        return _band, (self._told, bytes(self._bins))

    def __repr__(self) -> str:
        return f"wrc.Band: {self.struct.count} x {self.struct.length:g} m from {self.struct.first:g} m" + (", closed" if self.struct.closed else "")


def _band(told: Tuple[Any, ...], content: bytes) -> Band:
    made = Band(*told)
    c.memmove(made._bins, content, len(content))
    return made


def surface_laws(name: str = "low adhesion", **members: Any) -> i.SurfaceLaws:
    """Constants of a named set, some members changed: surface_laws("low adhesion", ambient=5.0)."""
    laws = i.SurfaceLaws()
    _call(i._wrc_surface_laws_use, laws, name.encode())
    for member, value in members.items():
        setattr(laws, member, value)
    return laws


def surface_friction(rail: Band, wheel: Optional[Band], laws: i.SurfaceLaws, passage: i.SurfacePassage,
                     base: Optional[i.Friction] = None, out: Optional[i.Friction] = None) -> i.Friction:
    """Friction and layer at the beginning of a passage, for wrc.WheelInput.friction. base: of clean, dry bodies; it may have zones."""
    found = i.Friction() if out is None else out
    rows = [band.struct.rows for band in (rail, wheel) if band is not None]
    if max(rows) == 1 and (base is None or base.zone_count == 0):
        _call(i._wrc_surface_friction, rail.struct, wheel and wheel.struct, laws, passage, base, found)
        return found
    across = np.zeros(8 + 5 * int(np.prod(rows)))
    passage.film_rows, passage.film_numbers = across, across.size
    _call(i._wrc_surface_friction, rail.struct, wheel and wheel.struct, laws, passage, base, found)
    passage.film_rows, passage.film_numbers = None, 0
    found.film_rows = across  # keeps the array alive
    return found


def surface_pass(rail: Band, wheel: Optional[Band], laws: i.SurfaceLaws, passage: i.SurfacePassage,
                 contact: Optional[Contact] = None) -> i.SurfaceExchange:
    """A wheel passes and changes both bands. Gives the amounts and energies that were moved. contact: of the last wrench, for rows."""
    found = i.SurfaceExchange._new()
    passage.contact = None if contact is None else contact._handle
    _call(i._wrc_surface_pass, rail.struct, wheel and wheel.struct, laws, passage, found)
    passage.contact = None
    return found
