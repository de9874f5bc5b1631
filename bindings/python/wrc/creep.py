"""Measured creep curves: friction, layers and Polach's factors that fit them."""
from __future__ import annotations

import math
from typing import Any, Dict, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _interface as i
from . import _struct as s
from .contact import Contact, use


class FittedParameter:
    """A fitted parameter: value, standard deviation, the ends of its 95 % interval, in the unit of the member of
    wrc.Friction. deviation is infinite where the curve does not determine it; at_limit: it ended at the end of its range."""

    __slots__ = ("name", "value", "deviation", "low", "high", "at_limit")

    def __init__(self, name: str, value: float, deviation: float, low: float, high: float, at_limit: bool):
        self.name, self.value, self.deviation, self.low, self.high, self.at_limit = name, value, deviation, low, high, at_limit

    @property
    def determined(self) -> bool:
        return math.isfinite(self.deviation)

    def __repr__(self) -> str:
        spread = f"+- {self.deviation:.2g} ({self.low:.4g} .. {self.high:.4g})" if self.determined else "not determined by the curve"
        return f"{self.name} = {self.value:.4g} {spread}" + (", at the end of its range" if self.at_limit else "")


class CreepCurveFit:
    """Result of wrc.fit_creep_curve().

    parameters: wrc.FittedParameter by name
    friction: the law that fits best, a wrc.Friction
    covariance: of the parameters in their order
    scatter: standard deviation of the points from the law, relative or of the adhesion
    points: the curve's arrays slip, adhesion, speed, load; fitted: adhesion of the law there
    status: Status.OK, or the flag that was met
    """

    def __init__(self, contact: Contact, ellipse: i.Ellipse, names: List[str], fit: i.CreepFit, points: Dict[str, NDArray[Any]],
                 fitted: NDArray[Any], status: i.Status):
        places = [int(i.CreepParameter.of(each.upper())) for each in names]
        self.parameters = {name: FittedParameter(name, fit.value[k], fit.deviation[k], fit.low[k], fit.high[k], bool(fit.at_limit >> k & 1))
                           for name, k in zip(names, places)}
        self.friction, self.scatter, self.iterations, self.status = fit.friction.copy(), fit.scatter, fit.iterations, status
        self.covariance = np.array(fit.covariance)[np.ix_(places, places)]
        self.points, self.fitted, self._contact, self._ellipse = points, fitted, contact, ellipse

    def adhesion(self, slip: Any, speed: float, load: Optional[float] = None) -> NDArray[Any]:
        """Adhesion of the fitted law over slips [-] at a rolling speed [m/s] and a load [N]; None: that of the ellipse."""
        ellipse = self._ellipse.copy()
        if load is not None:
            grown = (load / ellipse.normal_force) ** (1 / 3)
            ellipse.a, ellipse.b, ellipse.normal_force = grown * ellipse.a, grown * ellipse.b, load
        found = []
        for each in np.atleast_1d(slip):
            forces = self._contact.planar_tangential(i.Creepage(longitudinal=float(each), speed=speed), self.friction, ellipse)
            found.append(-forces.fx / forces.fn)
        return np.array(found)

    def __repr__(self) -> str:
        return "\n".join([f"fit of {len(self.fitted)} points, scatter {self.scatter:.3g}", *map(repr, self.parameters.values())])


def fit_creep_curve(contact: Contact, slip: Any, adhesion: Any, speed: Any, load: Any, *, ellipse: i.Ellipse,
                    friction: Union[i.Friction, i.FrictionName], parameters: Sequence[str], scatter: i.ScatterLike = "RELATIVE",
                    progress: s.ProgressArgument = None, **options: Any) -> CreepCurveFit:
    """Fits parameters of friction and of a layer to a measured creep curve, by the tangential method of a contact's model
    (preset="Polach" for his law). Theory manual, section 5.

    slip, adhesion: of the points [-], as amounts: 1.6 % is 0.016
    speed, load: of the points, or one number for all [m/s], [N]
    ellipse: the patch under ellipse.normal_force; under other loads its axes grow with their cube root
    friction: the law, whose values the fit begins with; or a name of wrc.frictions(), with the largest adhesion as coefficient
    parameters: what is looked for, by the names of wrc.CreepParameter: ("coefficient", "fall_rate")
    scatter: of the points, "RELATIVE" or "ABSOLUTE"
    progress: called with the fraction done; give something true to stop, or True for a bar on the terminal
    options: max_iterations of wrc.CreepCurve
    """
    given = np.broadcast_arrays(*(np.atleast_1d(np.asarray(each, float)) for each in (slip, adhesion, speed, load)))
    arrays: Dict[str, Any] = {name: np.array(each) for name, each in zip(("slip", "adhesion", "speed", "load"), given)}
    count = arrays["slip"].size
    if arrays["slip"].ndim != 1:
        raise ValueError("slip, adhesion, speed and load are lists of points, or one number for all")
    names = [each.lower() for each in parameters]
    if isinstance(friction, str):
        friction = use(i.Friction(), friction)
        friction.coefficient = min(max(1.1 * float(np.max(arrays["adhesion"])), 1e-3), 2.0)
    fitted, watch = np.zeros(count), s.Watch(progress)
    curve = i.CreepCurve(ellipse=ellipse, friction=friction, scatter=scatter, **arrays, **options)
    curve.parameters = sum(1 << int(i.CreepParameter.of(each.upper())) for each in set(names))
    curve.progress = watch.c
    fit = i.CreepFit()
    with contact._lock:
        status = contact._status = i._wrc_fit_creep_curve(contact._handle, curve, fit, fitted)
        watch.end()
        if status < 0:
            raise contact._error(status, watch)
    return CreepCurveFit(contact, curve.ellipse.copy(), names, fit, arrays, fitted, i.Status(status))
