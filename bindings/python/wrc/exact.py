"""Kalker's exact half-space theory, offline: the yardstick. wrc.Contact.exact_check() and exact_wrench() are of the contact."""
from __future__ import annotations

import ctypes as c
import threading
import weakref
from typing import Any, Callable, Dict, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _interface as i
from . import _library as _l
from ._struct import ProgressArgument, Watch

_SENTENCE = 1024


def grid(nx: int, ny: int, dx: float, dy: Optional[float] = None) -> i.Grid:
    """A grid of nx by ny cells of dx by dy [m] about the origin of the contact frame."""
    dy = dx if dy is None else dy
    return i.Grid(nx=nx, ny=ny, dx=dx, dy=dy, x0=-0.5 * (nx - 1) * dx, y0=-0.5 * (ny - 1) * dy)


def cells(grid: i.Grid) -> Tuple[NDArray[Any], NDArray[Any]]:
    """x and y of the cells' centres [m], both of shape (ny, nx)."""
    x, y = grid.x0 + grid.dx * np.arange(grid.nx), grid.y0 + grid.dy * np.arange(grid.ny)
    return np.meshgrid(x, y)


def _field(name: str, values: Any, grid: i.Grid) -> NDArray[Any]:
    array = np.ascontiguousarray(values, np.float64)
    if array.shape != (grid.ny, grid.nx):
        raise ValueError(f"{name} has the shape {array.shape}, its grid ny, nx = {grid.ny, grid.nx}")
    return array


def normal(grid: i.Grid, gap: NDArray[Any], *, progress: ProgressArgument = None,
           **problem: Any) -> Tuple[i.ExactNormalSolution, NDArray[Any]]:
    """Pressure between two half-spaces pressed together: the solution, and the pressure [Pa] of shape (ny, nx).

    gap: undeformed, shape (ny, nx) [m]
    progress: called with the fraction done; give something true to stop, or True for a bar on the terminal
    problem: members of wrc.ExactNormalProblem: normal_force [N], or prescribed="APPROACH" and approach [m]; wheel_material, ...
    """
    told = i.ExactNormalProblem(grid=grid, gap=_field("gap", gap, grid), **problem)
    pressure = np.zeros((grid.ny, grid.nx))
    solution = i.ExactNormalSolution(pressure=pressure)
    watch, text = Watch(progress), c.create_string_buffer(_SENTENCE)
    told.progress = watch.c
    _l.check_watched(i._wrc_exact_normal(told, solution, text, _SENTENCE), text, watch)
    return solution, pressure


def _roll(function: Callable[..., int], grid: i.Grid, pressure: NDArray[Any], friction: Union[float, NDArray[Any], None],
          progress: ProgressArgument, problem: Dict[str, Any]) -> Tuple[i.ExactRollingSolution, Dict[str, NDArray[Any]]]:
    told = i.ExactRollingProblem(grid=grid, pressure=_field("pressure", pressure, grid), **problem)
    if friction is not None and np.ndim(friction) == 0:
        told.coefficient = float(friction)
    elif friction is not None:
        told.friction = _field("friction", friction, grid)
    fields: Dict[str, Any] = {name: np.zeros((grid.ny, grid.nx)) for name in ("traction_x", "traction_y", "slip_x", "slip_y")}
    solution = i.ExactRollingSolution(**fields)
    watch, text = Watch(progress), c.create_string_buffer(_SENTENCE)
    told.progress = watch.c
    _l.check_watched(function(told, solution, text, _SENTENCE), text, watch)
    return solution, fields


def rolling(grid: i.Grid, pressure: NDArray[Any], *, friction: Union[float, NDArray[Any], None] = None,
            progress: ProgressArgument = None, **problem: Any) -> Tuple[i.ExactRollingSolution, Dict[str, NDArray[Any]]]:
    """Steady rolling under a given pressure: the solution, and its fields of shape (ny, nx): traction_x, traction_y [Pa],
    slip_x, slip_y [-].

    pressure: shape (ny, nx) [Pa]
    friction: one number, or shape (ny, nx)
    progress: as of normal()
    problem: members of wrc.ExactRollingProblem: creepage={"longitudinal": 1e-3}, wheel_material, rail_material, tolerance, ...
    """
    return _roll(i._wrc_exact_rolling, grid, pressure, friction, progress, problem)


class Transient:
    """Two bodies that roll on cell by cell and remember their tractions; at first they have not rolled and have none.

    grid: of every step; a step goes grid.dx, either way, or rests
    wheel_material, rail_material: None: the defaults
    """

    def __init__(self, grid: i.Grid, wheel_material: Optional[i.Material] = None, rail_material: Optional[i.Material] = None):
        self.grid, self._lock = grid.copy(), threading.Lock()
        self.materials = {"wheel_material": (wheel_material or i.Material()).copy(), "rail_material": (rail_material or i.Material()).copy()}
        self._handle, text = c.c_void_p(), c.create_string_buffer(_SENTENCE)
        _l.check(i._wrc_exact_transient_create(self.grid, *self.materials.values(), c.byref(self._handle), text, _SENTENCE), text)
        weakref.finalize(self, i._wrc_exact_transient_destroy, c.c_void_p(self._handle.value))

    def step(self, pressure: NDArray[Any], *, friction: Union[float, NDArray[Any], None] = None, progress: ProgressArgument = None,
             **problem: Any) -> Tuple[i.ExactRollingSolution, Dict[str, NDArray[Any]]]:
        """Rolls on by one cell: as rolling(), with pressure and friction at the step's end and creepages of its middle. The sign of
        creepage.speed is the way; 0 is a shift at rest by creepages times dx. A step that fails or is stopped leaves the bodies where
        they were."""
        with self._lock:
            return _roll(lambda *told: i._wrc_exact_transient_step(self._handle, *told), self.grid, pressure, friction, progress,
                         {**self.materials, **problem})


def _loads(grid: i.Grid, pressure: Any, traction_x: Any, traction_y: Any, problem: Dict[str, Any]) -> i.ExactLoads:
    given = {"pressure": pressure, "traction_x": traction_x, "traction_y": traction_y}
    loads: Dict[str, Any] = {name: _field(name, each, grid) for name, each in given.items() if each is not None}
    return i.ExactLoads(grid=grid, **loads, **problem)


def stresses(grid: i.Grid, points: Any, pressure: Any, traction_x: Any = None, traction_y: Any = None, **problem: Any) -> NDArray[Any]:
    """Stresses at points x, y, depth [m] of a body under loads on its surface [Pa] of shape (ny, nx): one row xx, yy, zz, xy,
    yz, zx a point, tension positive.

    problem: body, poisson of wrc.ExactLoads
    """
    places = np.ascontiguousarray(points, np.float64)
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError(f"points have the shape (n, 3), not {places.shape}")
    found, text = np.zeros((len(places), 6)), c.create_string_buffer(_SENTENCE)
    _l.check(i._wrc_exact_stress(_loads(grid, pressure, traction_x, traction_y, problem), places, len(places), found, text, _SENTENCE), text)
    return found


def largest_stresses(grid: i.Grid, pressure: Any, traction_x: Any = None, traction_y: Any = None, progress: ProgressArgument = None,
                     **problem: Any) -> i.Stresses:
    """Largest stresses in a body under loads on its surface: as stresses(), over the whole body."""
    found, watch, text = i.Stresses._new(), Watch(progress), c.create_string_buffer(_SENTENCE)
    loads = _loads(grid, pressure, traction_x, traction_y, problem)
    _l.check_watched(i._wrc_exact_largest_stresses(loads, None, 0, None, found, watch.c, None, text, _SENTENCE), text, watch)
    return found
