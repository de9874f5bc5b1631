"""Models and contacts: what owns memory, and the calls that Python gives another shape than C."""
from __future__ import annotations

import concurrent.futures
import ctypes as c
import os
import threading
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Sequence, Tuple, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import _interface as i
from . import _library as _l
from ._renamed import current
from .damage import Bins
from .profiles import results

if TYPE_CHECKING:
    from typing_extensions import Unpack

_SENTENCE = 1024  # bytes
_SHARED: Dict[str, "Model"] = {}
_SHARED_LOCK = threading.Lock()


def _view(view: i.View, memory: Any) -> NDArray[np.float64]:
    """A wrc_view as a read-only numpy array in the memory of its model, which it keeps alive."""
    offset = c.cast(view._data, c.c_void_p).value - c.addressof(memory)  # type: ignore[operator,attr-defined]
    array = np.ndarray((view.count,), np.float64, memory, offset)
    array.flags.writeable = False
    return array


def force_table() -> str:
    """The force table that comes with the package: for config.tangential.force_table with the method FORCE_TABLE."""
    return str(_l.FOLDER / "force_table.bin")


def presets() -> List[str]:
    """Published names of tangential methods: of wrc.Model(preset=) and wrc.use()."""
    return list(i.PRESETS)


def methods() -> Dict[str, Dict[str, str]]:
    """Every normal and tangential method by its name, with its description: of config.normal.method, config.tangential.method."""
    return {"normal": {each.name: each.__doc__ or "" for each in i.NormalMethod},
            "tangential": {each.name: each.__doc__ or "" for each in i.TangentialMethod}}


def frictions() -> Dict[str, Tuple[str, str]]:
    """Friction and layers by name, of wrc.use(): source, and how far it is confirmed."""
    return dict(i.FRICTIONS)


@overload
def use(struct: i.Config, name: i.PresetName) -> i.Config: ...
@overload
def use(struct: i.Friction, name: i.FrictionName) -> i.Friction: ...
def use(struct: Any, name: Any) -> Any:
    """Makes a configuration that of a published tangential method ("FASTSIM-SDEC", see wrc.presets()), or friction that of a name
    ("Polach wet", see wrc.frictions()); gives the struct. Upper and lower case, blanks and hyphens do not count."""
    names, function = (i.FRICTIONS, i._wrc_friction_use) if isinstance(struct, i.Friction) else (i.PRESETS, i._wrc_config_use)
    plain = {"".join(filter(str.isalnum, each)).lower(): each for each in names}
    name = plain.get("".join(filter(str.isalnum, name)).lower(), name)
    text = c.create_string_buffer(_SENTENCE)
    _l.check(function(struct, name.encode(), text, _SENTENCE), text)
    return struct


class Model(i.ModelCalls):
    """Profiles, materials, methods: what does not change. Any number of threads and contacts may use one model.

    wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK")
    wrc.Model(config)                       a wrc.Config; changed later it changes nothing in the model
    wrc.Model(..., preset="FASTSIM-SDEC")   with a published tangential method

    wheel, rail: the name of a built-in shape, a wrc.Profile, or what wrc.read_profile() gives. All members of wrc.Config may
    be given by name, groups as dicts: track={"rail_inclination": 1 / 40}. The method FORCE_TABLE takes the package's own table
    where none is named. Raises wrc.Error with the library's sentence. A model is pickled as its configuration.
    status: of the making: Status.OK or Status.FLAG_DISSIMILAR_MATERIALS.
    """

    __slots__ = ("config",)

    config: i.Config

    def __init__(self, config: Optional[i.Config] = None, *, preset: Optional[i.PresetName] = None, **values: Unpack[i.ConfigDict]):
        config = i.Config() if config is None else config.copy()
        if preset is not None:
            use(config, preset)
        config.set(**values)
        if config.tangential.method == i.TangentialMethod.FORCE_TABLE and config.tangential.force_table is None:
            config.tangential.force_table = force_table()
        size, alignment, handle = c.c_uint64(), c.c_uint64(), c.c_void_p()
        text = c.create_string_buffer(_SENTENCE)
        memory, status = None, i._wrc_model_size(config, c.byref(size), c.byref(alignment))
        if status >= 0:
            memory, address = _l.aligned(size.value, alignment.value)
            status = i._wrc_model_init(config, address, size.value, c.byref(handle), text, _SENTENCE)
        else:
            i._wrc_config_check(config, text, _SENTENCE)
        _l.check(status, text)
        self._take(memory, handle, status)
        self.config = config

    @classmethod
    def shared(cls, **values: Unpack[i.ConfigDict]) -> "Model":
        """Model(**values), made once in a process for the same values: for the workers of a sweep."""
        told = repr(sorted(values.items()))
        with _SHARED_LOCK:
            if told not in _SHARED:
                _SHARED[told] = cls(**values)
            return _SHARED[told]

    def __reduce__(self) -> Any:
        return Model, (self.config,)

    def contact(self, side: i.SideLike = i.Side.RIGHT) -> "Contact":
        """A contact of this model: of the right wheel, or of the left one (side="LEFT")."""
        return Contact(self, side)

    def profile(self, body: i.BodyLike = "WHEEL", side: i.SideLike = i.Side.RIGHT) -> Tuple[NDArray[np.float64], NDArray[np.float64], float]:
        """A profile as the model uses it, smoothed and placed: y [m], z [m], the largest deviation from its points [m].
        Of a wheel y counts from the wheelset's middle, of a rail from the track's. The arrays are the model's memory."""
        y, z, deviation = i.View(), i.View(), c.c_double()
        with self._lock:
            status = i._wrc_model_profile(self._handle, int(i.Side.of(side)), int(i.Body.of(body)), y, z, c.byref(deviation))
            if status < 0:
                raise self._error(status)
            return _view(y, self._memory), _view(z, self._memory), deviation.value

    def arc_places(self, arc: Any, body: i.BodyLike = "WHEEL") -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """y and z of the profile [m] at arc lengths [m], 0 at its origin, as wrc.Bins count them; beyond an end: the end."""
        arc = np.ascontiguousarray(np.atleast_1d(arc), np.float64)
        y, z = np.zeros(arc.size), np.zeros(arc.size)
        with self._lock:
            status = i._wrc_model_arc_places(self._handle, int(i.Body.of(body)), arc.size, arc, y, z)
            if status < 0:
                raise self._error(status)
        return y.reshape(arc.shape), z.reshape(arc.shape)

    def wheelset_geometry(self, lateral: Any, wheel_load: float = 0.0) -> Dict[str, NDArray[np.float64]]:
        """Where a wheelset without yaw touches both rails, over its lateral displacement: the members of
        wrc.WheelsetGeometry as arrays. EN 15302.

        lateral: of the wheelset, to the right [m]
        wheel_load: 0: the bodies touch undeformed; of each wheel, vertical: elastic [N]
        """
        problem = i.WheelsetGeometryProblem(lateral=np.atleast_1d(lateral), wheel_load=wheel_load)
        found, arrays = results(i.WheelsetGeometry, problem.count)
        text = c.create_string_buffer(_SENTENCE)
        with self._lock:
            status = i._wrc_profile_wheelset_geometry(self._handle, problem, found, text, _SENTENCE)
        _l.check(status, text)
        return arrays

    def __repr__(self) -> str:
        if self._handle is None:
            return "wrc.Model, closed"
        config = self.config
        return (f"wrc.Model\n  wheel       {config.wheel.kind!s}\n  rail        {config.rail.kind!s}\n"
                f"  normal      {config.normal.method!s}\n  tangential  {config.tangential.method!s}\n"
                f"  memory      {len(self._memory)} bytes")


class Contact(i.ContactCalls):
    """One wheel on one rail: the results of the last call. One thread at a time; a second one waits.

    status: of the last call, a wrc.Status; message: the library's sentence behind it. Failures raise wrc.Error, flags do not.
    What a call gives is a new struct; out= takes one to be filled instead. A contact is pickled and copied with its state.
    """

    __slots__ = ("model", "side", "_fields")

    model: Model
    side: i.Side

    def __init__(self, model: Model, side: i.SideLike = i.Side.RIGHT):
        size, alignment, handle = c.c_uint64(), c.c_uint64(), c.c_void_p()
        side, text = i.Side.of(side), c.create_string_buffer(_SENTENCE)
        status = i._wrc_contact_size(model._handle, c.byref(size), c.byref(alignment))
        if status < 0:
            raise model._error(status)
        memory, address = _l.aligned(size.value, alignment.value)
        status = _l.check(i._wrc_contact_init(model._handle, int(side), address, size.value, c.byref(handle), text, _SENTENCE), text)
        self._take((memory, model._memory), handle, status)  # the model's memory lives as long as the contact
        self.model, self.side = model, side

    def __reduce__(self) -> Any:
        return _contact, (self.model, self.side, self.save(portable=True))

    @property
    def message(self) -> str:
        """The sentence behind the last status; empty after Status.OK."""
        return self._sentence() if self._status else ""

    def _sentence(self) -> str:
        text = c.create_string_buffer(_SENTENCE)
        i._wrc_contact_last_error(self._handle, text, _SENTENCE)
        return text.value.decode(errors="replace")

    def field(self, field: i.FieldLike, region: int = 0) -> NDArray[np.float64]:
        """A field of one region of the last solution, of wrench() or of the planar stages: a new array. Over cells it has the
        shape (strips, cells), cell 0 at the leading edge; over strips, or rows of a gap, one number each. Strips go from the
        gauge side to the field side of a rail, on a contact plane by increasing y.

        field: a wrc.Field or its name, "PRESSURE"; its docstring has units
        """
        which, counts = int(i.Field.of(field)), (c.c_uint64 * 2)()
        with self._lock:
            status = self._status = i._wrc_contact_field(self._handle, region, which, None, 0, counts)
            if status >= 0:
                cells, strips = counts
                values = np.empty((strips, cells) if cells > 1 else strips)
                status = self._status = i._wrc_contact_field(self._handle, region, which, values, values.size, None)
            if status < 0:
                raise self._error(status)
        return values

    def fields(self, region: int = 0) -> Dict[str, NDArray[np.float64]]:
        """All fields that the last solution has of a region, by name."""
        with self._lock:
            self.region(region)  # raises where there is none
            found = {}
            for each in i.Field:
                try:
                    found[each.name] = self.field(each, region)
                except _l.Error:  # not of this method, or of a wheel
                    pass
            self._status = 0
        return found

    def regions(self) -> List[i.Region]:
        """Every region of the last solution, of wrench() or of the planar stages: as many as its result counts, from the gauge
        side to the field side of a rail, on a contact plane by increasing y."""
        found: List[i.Region] = []
        with self._lock:
            while True:
                one = i.Region._new()
                status = i._wrc_contact_region(self._handle, len(found), one)
                if status == i.Status.ERROR_RANGE:  # there are no more
                    self._status = 0
                    return found
                self._status = status
                if status < 0:
                    raise self._error(status)
                found.append(one)

    def accumulate(self, wheel: Optional[Bins] = None, rail: Optional[Bins] = None, *, out: Optional[i.DamageTotals] = None,
                   **accumulation: Unpack[i.AccumulationDict]) -> i.DamageTotals:
        """Adds what the last solution does in a duration to wrc.Bins of the wheel's and of the rail's profile: what was added.

        accumulation: members of wrc.Accumulation: duration [s], distance [m], wear, fatigue
        """
        told, totals = i.Accumulation(**accumulation), i.DamageTotals._new() if out is None else out
        with self._lock:
            status = self._status = i._wrc_contact_accumulate(self._handle, told, wheel and wheel.struct, rail and rail.struct, totals)
            if status < 0:
                raise self._error(status)
        return totals

    def stresses(self, index: int, depths: Any, body: i.BodyLike = "RAIL") -> Tuple[i.Stresses, List[i.StressPeaks]]:
        """Largest stresses in one body under a region of the last solution, or under all patches of a contact plane
        (wrc.ALL_REGIONS): as a whole, and at each of the depths [m]. See wrc_damage.h."""
        depths = np.ascontiguousarray(np.atleast_1d(depths), np.float64)
        kind: Any = i.StressPeaks
        levels, found = (kind * max(1, depths.size))(), i.Stresses._new()
        with self._lock:
            status = self._status = i._wrc_contact_stresses(self._handle, index, int(i.Body.of(body)), depths, depths.size, levels[0], found)
            if status < 0:
                raise self._error(status)
        return found, list(levels)[:depths.size]

    def save(self, portable: bool = False) -> bytes:
        """The whole state, for restore() on a contact of the same model and side in this process; portable: on one of an
        equal configuration in any process, to be kept in files."""
        size = c.c_uint64()
        with self._lock:
            _l.check((i._wrc_contact_portable_size if portable else i._wrc_contact_state_size)(self.model._handle, c.byref(size)))
            buffer = c.create_string_buffer(size.value)
            status = (i._wrc_contact_save_portable if portable else i._wrc_contact_save)(self._handle, buffer, size.value)
            if status < 0:
                raise self._error(status)
        return buffer.raw

    def restore(self, state: bytes) -> None:
        """Puts a saved state back, bit for bit, of either kind."""
        with self._lock:
            function = i._wrc_contact_restore_portable if state[:8] == b"wrcstate" else i._wrc_contact_restore
            status = function(self._handle, state, len(state))
            if status < 0:
                raise self._error(status)

    def exact_gap(self, grid: i.Grid) -> NDArray[np.float64]:
        """The gap of the last planar_geometry() between the true surfaces at a grid's cells [m], shape (ny, nx)."""
        gap = np.zeros((grid.ny, grid.nx))
        with self._lock:
            status = i._wrc_exact_gap(self._handle, grid, gap)
            if status < 0:
                raise self._error(status)
        return gap

    def __repr__(self) -> str:
        return f"wrc.Contact of the {i.Side.of(self.side)!s} wheel, " + (
            "closed" if self._handle is None else f"last call: {self.status!s}")


def _contact(model: Model, side: i.Side, state: bytes) -> Contact:
    made = Contact(model, side)
    made.restore(state)
    return made


class Batch:
    """Many contacts of any models, solved by one call of wrench(), without the GIL.

    statuses: of each contact in the last call, a numpy array.
    """

    def __init__(self, contacts: Sequence[Contact]):
        self.contacts = list(contacts)
        if len({id(each) for each in self.contacts}) != len(self.contacts):
            raise ValueError("a batch has each contact once")
        self._handles = (c.c_void_p * len(self.contacts))(*[each._handle for each in self.contacts])
        self._memory = [each._memory for each in self.contacts]
        self.statuses = np.zeros(len(self.contacts), np.int32)
        self._statuses = c.c_void_p(self.statuses.ctypes.data)
        self._last: Tuple[Any, ...] = (None, None)  # arrays of the last call, and what they are to C
        self._acquire = [each._lock.acquire for each in self.contacts]
        self._release = [each._lock.release for each in self.contacts]

    __dir__ = current

    def __len__(self) -> int:
        return len(self.contacts)

    def wrench(self, inputs: Union[i.WheelInput, NDArray[Any]], out: Optional[NDArray[Any]] = None, check: bool = True) -> NDArray[Any]:
        """Contact.wrench() of each contact.

        inputs: one wrc.WheelInput for all, or wrc.WheelInput.array(n) with an element for each
        out: wrc.Wrench.array(n) to be filled; None: a new one
        check: raise wrc.Error for the first contact that failed; False: look at statuses
        """
        count = len(self.contacts)
        if out is None:
            out = i.Wrench.array(count)
        if self._last[0] is not inputs or self._last[1] is not out:
            address, stride = _elements(inputs, i.WheelInput, count, "inputs")
            target, step = _elements(out, i.Wrench, count, "out")
            self._last = (inputs, out, (self._handles, count, i.WheelInput.from_address(address), stride,
                                        i.Wrench.from_address(target), step, self._statuses))
        for acquire in self._acquire:
            acquire()
        try:
            status = i._wrc_contact_wrench_batch(*self._last[2])
        finally:
            for release in self._release:
                release()
        for each, found in zip(self.contacts, self.statuses.tolist()):
            each._status = found
        if status < 0 and check:
            first = int(np.argmax(self.statuses < 0))
            raise _l.fault(int(self.statuses[first]), f"contact {first} of {count}: {self.contacts[first]._sentence()}")
        return out


def _elements(array: Any, kind: Any, count: int, name: str) -> Tuple[int, int]:
    """Address of the first element and bytes to the next."""
    if isinstance(array, kind) and name == "inputs":
        return c.addressof(array), 0
    if not isinstance(array, np.ndarray) or array.dtype != kind.dtype() or array.shape != (count,):
        raise TypeError(f"{name} is wrc.{kind.__name__}.array({count})" + (f" or one wrc.{kind.__name__}" if name == "inputs" else ""))
    return array.ctypes.data, array.strides[0]


def _steps(contact: Contact, inputs: NDArray[Any], out: NDArray[Any]) -> NDArray[np.int32]:
    """Contact.planar_step() of each input in turn; the statuses."""
    count = len(inputs)
    address, stride = _elements(inputs, i.PlanarInput, count, "inputs")
    target, step = _elements(out, i.PlanarOutput, count, "out")
    statuses = np.zeros(count, np.int32)
    with contact._lock:
        for k in range(count):
            statuses[k] = i._wrc_planar_step(contact._handle, i.PlanarInput.from_address(address + k * stride),
                                             i.PlanarOutput.from_address(target + k * step))
    return statuses


BLOCK = 64  # elements solved between two looks at what is left


def sweep(model: Model, inputs: NDArray[Any], side: i.SideLike = i.Side.RIGHT, threads: int = 1,
          progress: Optional[Callable[[float], Any]] = None) -> Tuple[NDArray[Any], NDArray[np.int32]]:
    """Solves any number of inputs of one model: the results (wrc.Wrench or wrc.PlanarOutput as an array), and their statuses.

    inputs: wrc.WheelInput.array(n) for wheels on rails, each of which starts cold; wrc.PlanarInput.array(n) for planar steps
    threads: 0: as many as there are processors. The bits are the same whatever their number
    progress: called with the fraction done; what it raises ends the sweep
    """
    planar, config = inputs.dtype == i.PlanarInput.dtype(), model.config.planar
    if planar and (config.start or config.non_steady):
        raise ValueError(f"with planar.{'start' if config.start else 'non_steady'} results depend on the order of calls: a sweep has none")
    if inputs.dtype == i.WheelInput.dtype() and (inputs["start"] != i.Start.COLD).any():
        inputs = inputs.copy()  # the caller's stays what it is
        inputs["start"] = i.Start.COLD
    out, statuses = (i.PlanarOutput if planar else i.Wrench).array(len(inputs)), np.zeros(len(inputs), np.int32)
    starts = range(0, len(inputs), BLOCK)
    workers = min(threads or os.cpu_count() or 1, max(1, len(starts)))

    def work(first: int) -> int:
        contacts = [Contact(model, side) for _ in range(1 if planar else min(BLOCK, len(inputs)))]
        done = 0
        for start in starts[first::workers]:
            part = slice(start, min(start + BLOCK, len(inputs)))
            if planar:
                statuses[part] = _steps(contacts[0], inputs[part], out[part])
            else:
                batch = Batch(contacts[:part.stop - part.start])
                batch.wrench(inputs[part], out[part], check=False)
                statuses[part] = batch.statuses
            done += part.stop - part.start
            if progress is not None and first == 0:
                progress(min(1.0, done * workers / len(inputs)))
        return done

    if workers == 1:
        work(0)
    else:
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            for each in [pool.submit(work, first) for first in range(workers)]:
                each.result()
    return out, statuses
