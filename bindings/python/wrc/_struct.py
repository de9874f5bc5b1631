"""What the generated structs are made of: C memory with Python's manners.

A struct is its C memory and nothing else: numbers are ctypes fields, arrays numpy views of that memory, choices members of
an enumeration. Unknown names are refused, defaults are the library's own."""
from __future__ import annotations

import ctypes as c
import difflib
import enum
import html
import inspect
import os
import sys
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterable, List, Optional, Protocol, Sequence, Tuple, Type, TypeVar, Union

import numpy as np

from ._renamed import current, since

S = TypeVar("S", bound="Struct")
K = TypeVar("K", bound="Choice")
Floats = Union[Sequence[float], Sequence[Sequence[float]], np.ndarray]
Path = Union[str, "os.PathLike[str]"]
_C_DOUBLES = c.POINTER(c.c_double)
_DTYPES = {c.c_int32: "<i4", c.c_uint32: "<u4", c.c_uint64: "<u8", c.c_int64: "<i8", c.c_double: "<f8"}


class AsStruct(Protocol):
    """Goes where a wrc.Profile does."""

    def as_struct(self) -> Any:
        """The wrc.Profile."""


if TYPE_CHECKING:
    class _Memory:
        """ctypes.Structure without its claim that it has every attribute."""

        _fields_: Any
        from_buffer: Any
        from_buffer_copy: Any
        from_address: Any
else:
    _Memory = c.Structure


class Choice(enum.IntEnum):
    """An enumeration of the interface: its members are numbers, and a name does where a member is asked for. The docstring of
    a member says what it is."""

    def __new__(cls, value: int, text: str = "") -> Any:
        made = int.__new__(cls, value)
        made._value_, made.__doc__ = value, text
        return made

    @classmethod
    def of(cls: Type[K], value: Any) -> K:
        """The member of that number or name; a number the enumeration does not know stays a number."""
        return _choice(cls, value)  # type: ignore[no-any-return]

    def __str__(self) -> str:
        return self.name


def _choice(kind: Any, value: Any) -> Any:
    if isinstance(value, str):
        names = kind.__members__
        wanted = value.strip().upper().replace(" ", "_").replace("-", "_")
        for name, member in names.items():
            if wanted == name or name.endswith("_" + wanted) and wanted[:1].isdigit():
                return member
        shown = [name.removeprefix("PROFILE_") for name in names]
        near, now = difflib.get_close_matches(wanted, shown, 1), since(kind.__name__, wanted)
        raise ValueError(f"{value!r} is no {kind.__name__}: " + (now or (f"did you mean {near[0]!r}?" if near else
                         f"choose {', '.join(map(repr, shown))}")) +
                         (" (wrc.shape() has other standard profiles)" if kind.__name__ == "ProfileKind" else ""))
    try:
        return kind(value)
    except ValueError:
        return int(value)


def _told(owner: Any, name: str) -> str:
    """A member as messages say it: "WheelState.velocity [m/s]"."""
    unit = type(owner)._units_.get(name)
    return f"{type(owner).__name__}.{name}" + (f" [{unit}]" if unit else "")


class Member:
    """A member of a struct that is more than a number; its C field has the same name behind an underscore."""

    def __init__(self, name: str):
        self.name, self.field = name, "_" + name


class Chosen(Member):
    """One of an enumeration, or bits of it: set by member, number or name."""

    def __init__(self, name: str, kind: Any):
        super().__init__(name)
        self.kind = kind

    def __get__(self, owner: Any, _: Any = None) -> Any:
        return self if owner is None else _choice(self.kind, getattr(owner, self.field))

    def __set__(self, owner: Any, value: Any) -> None:
        setattr(owner, self.field, int(_choice(self.kind, value)))


class Array(Member):
    """Numbers within the struct, as a numpy view of them."""

    def __init__(self, name: str, offset: int, shape: Tuple[int, ...], kind: Any):
        super().__init__(name)
        self.offset, self.shape, self.count = offset, shape, int(np.prod(shape))
        self.dtype = np.dtype(_DTYPES[kind])

    def __get__(self, owner: Any, _: Any = None) -> Any:
        if owner is None:
            return self
        view = np.frombuffer(owner, self.dtype, self.count, self.offset)
        return view if len(self.shape) == 1 else view.reshape(self.shape)

    def __set__(self, owner: Any, value: Any) -> None:
        array = np.asarray(value)
        if array.size != self.count:
            raise ValueError(f"{_told(owner, self.name)} has {self.count} numbers, not {array.size}")
        try:
            self.__get__(owner)[...] = array.reshape(self.shape)
        except (TypeError, ValueError):
            raise ValueError(f"{_told(owner, self.name)} has {self.count} numbers, not {value!r}") from None


class Count(Member):
    """How many numbers the arrays beside have: it follows from them."""

    def __get__(self, owner: Any, _: Any = None) -> Any:
        return self if owner is None else getattr(owner, self.field)

    def __set__(self, owner: Any, value: Any) -> None:
        if value != getattr(owner, self.field):
            raise AttributeError(f"{type(owner).__name__}.{self.name} follows from the arrays it counts: set these")


class Pointer(Member):
    """A pointer to numbers: set by an array, which the struct keeps.

    counters: the members that say how many, two of a matrix: rows and columns; arrays of one counter have one length
    stride: the member that has the length of a matrix's row
    """

    def __init__(self, name: str, *counters: str, stride: str = ""):
        super().__init__(name)
        self.counters, self.stride = tuple("_" + each for each in counters), stride

    def __get__(self, owner: Any, _: Any = None) -> Any:
        if owner is None:
            return self
        pointer = getattr(owner, self.field)
        if not pointer:
            return None
        lengths = tuple(getattr(owner, each) for each in self.counters)
        if self.stride:
            return np.ctypeslib.as_array(pointer, (lengths[0], getattr(owner, self.stride)))[:, :lengths[1]]
        return np.ctypeslib.as_array(pointer, lengths) if lengths else pointer

    def __set__(self, owner: Any, value: Any) -> None:
        if value is None:
            setattr(owner, self.field, _C_DOUBLES())
            for counter in self.counters:
                if not self.beside(owner, counter):
                    setattr(owner, counter, 0)
            return
        array: Any = np.ascontiguousarray(value, np.float64)
        if len(self.counters) == 2 and array.ndim == 1:
            array = array[None, :]  # of one row
        if self.counters and array.ndim != len(self.counters):
            raise ValueError(f"{_told(owner, self.name)} is a {'row' if len(self.counters) == 1 else 'matrix'} of numbers, "
                             f"not an array of shape {array.shape}")
        for counter, size in zip(self.counters, array.shape):
            self.count(owner, counter, size, array.shape)
        if self.stride:
            setattr(owner, self.stride, array.shape[1])
        if not array.flags.writeable:
            array = array.copy()
        # a ctypes array over the same memory: the struct keeps that, as it would not a mere pointer's origin
        setattr(owner, self.field, (c.c_double * array.size).from_buffer(array) if array.size else (c.c_double * 1)())

    def beside(self, owner: Any, counter: str) -> List["Pointer"]:
        """Other arrays of that counter that are set."""
        return [each for each in vars(type(owner)).values()
                if isinstance(each, Pointer) and each is not self and counter in each.counters and getattr(owner, each.field)]

    def count(self, owner: Any, counter: str, size: int, shape: Tuple[int, ...]) -> None:
        """Sets a counter, where other arrays let it be."""
        there, others, kind = getattr(owner, counter), self.beside(owner, counter), type(owner).__name__
        rows = [each for each in others if len(each.counters) == 1]
        if size != there and len(self.counters) == 2 and (rows or self.stride):
            counters = tuple(each[1:] for each in self.counters)
            raise ValueError(f"{kind}.{self.name} has the shape {shape}, {' and '.join(counters)} are "
                             f"{tuple(getattr(owner, '_' + each) for each in counters)}: set the arrays beside it first")
        if size != there and rows:
            raise ValueError(f"{kind}.{self.name} has {size} numbers and {rows[0].name} has {there}: set both at once by "
                             f"set({self.name}=..., {rows[0].name}=...)")
        for each in others:
            if size != there:  # a matrix of other rows or columns does not stay
                setattr(owner, each.field, _C_DOUBLES())
        setattr(owner, counter, size)


class Reference(Member):
    """A pointer to another struct, or to the first of a ctypes array of them, which this one keeps; size: the member that has
    the bytes of one."""

    def __init__(self, name: str, size: str = ""):
        super().__init__(name)
        self.size = "_" + size if size else ""

    def __get__(self, owner: Any, _: Any = None) -> Any:
        if owner is None:
            return self
        pointer = getattr(owner, self.field)
        return pointer.contents if pointer else None

    def __set__(self, owner: Any, value: Any) -> None:
        pointer = self.kind(type(owner))
        setattr(owner, self.field, pointer() if value is None else value if isinstance(value, c.Array) else c.pointer(value))
        if self.size:
            setattr(owner, self.size, 0 if value is None else c.sizeof(pointer._type_))

    def kind(self, owner: Any) -> Any:
        """The ctypes pointer type of this member."""
        return next(each[1] for each in owner._fields_ if each[0] == self.field)


class References(Reference):
    """A pointer to several structs, given as structs or as dicts of their members; it counts them itself."""

    def __init__(self, name: str, count: str, size: str = ""):
        super().__init__(name, size)
        self.count = "_" + count

    def __get__(self, owner: Any, _: Any = None) -> Any:
        if owner is None:
            return self
        pointer = getattr(owner, self.field)
        return [pointer[k] for k in range(getattr(owner, self.count))]

    def __set__(self, owner: Any, value: Any) -> None:
        pointer = self.kind(type(owner))
        made = [each if isinstance(each, Struct) else pointer._type_(**each) for each in value or ()]
        super().__set__(owner, (pointer._type_ * len(made))(*made) if made else None)
        setattr(owner, self.count, len(made))


class Text(Member):
    """A name: str, or a path."""

    def __get__(self, owner: Any, _: Any = None) -> Any:
        if owner is None:
            return self
        value = getattr(owner, self.field)
        return None if value is None else value.decode()

    def __set__(self, owner: Any, value: Any) -> None:
        setattr(owner, self.field, None if value is None else str(value).encode())


class _Signature:
    """What inspect.signature() says of a struct's class: its members as keywords, which notebooks complete."""

    def __get__(self, _: Any, kind: Any) -> inspect.Signature:
        empty = inspect.Parameter.empty
        return inspect.Signature([inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=..., annotation=empty)
                                  for name in kind.members() if not isinstance(getattr(kind, name, None), Count)])


class Struct(_Memory):
    """A struct of the interface. Members may be given by name; nested structs as such or as dicts.

    What the package sets itself, sizes of structs and room for later versions, has fields behind an underscore and no member.
    """

    __slots__ = ()
    _c_name_ = ""
    _units_: Dict[str, str] = {}
    _defaults_: Dict[str, Any] = {}  # of the fields whose default is not 0

    __signature__ = _Signature()

    def __init__(self, **values: Any):
        c.memmove(c.addressof(self), type(self)._default(), c.sizeof(self))  # type: ignore[arg-type]
        if values:
            self.set(**values)

    @classmethod
    def _default(cls) -> bytes:
        """The struct's bytes with the headers' defaults, which the C functions wrc_..._init() set too."""
        found = cls.__dict__.get("_default_bytes")
        if found is None:
            made = cls.from_buffer(bytearray(c.sizeof(cls)))  # type: ignore[arg-type]
            for each in cls._fields_:
                if issubclass(each[1], Struct):
                    setattr(made, each[0], each[1]._new())
            for name, value in cls._defaults_.items():
                setattr(made, name, value)
            if hasattr(cls, "_struct_size"):
                made._struct_size = c.sizeof(cls)  # type: ignore[arg-type]
            found = bytes(made)
            cls._default_bytes = found  # type: ignore[attr-defined]
        return found

    @classmethod
    def _new(cls: Type[S]) -> S:
        return cls.from_buffer_copy(cls.__dict__.get("_default_bytes") or cls._default())  # type: ignore[no-any-return]

    @classmethod
    def members(cls) -> Tuple[str, ...]:
        """Names of all members."""
        names = ((each[0], each[0].lstrip("_")) for each in cls._fields_)
        return tuple(name for field, name in names if field == name or isinstance(getattr(cls, name, None), Member))

    def __dir__(self) -> Iterable[str]:
        return [each for each in current(self) if not each.startswith("_")]

    def set(self: S, **values: Any) -> S:
        """Sets members by name; nested structs by a struct, by a dict of their members, or a profile by the name of its
        kind. Arrays that belong together (a profile's y and z) are set by one call. Gives the struct itself."""
        kind, members = type(self), type(self).members()
        if "y" in values and "kind" not in values and "kind" in members and values["y"] is not None:
            values["kind"] = "POINTS"  # of a profile
        arrays = [name for name in values if isinstance(getattr(kind, name, None), Pointer)]
        for name in arrays:
            setattr(self, name, None)
        matrices = [name for name in arrays if len(getattr(kind, name).counters) == 2]  # after what counts their rows and columns
        for name, value in sorted(values.items(), key=lambda each: each[0] in matrices):
            if name not in members:
                near, told = difflib.get_close_matches(name, members, 1), since(kind.__name__, name)
                raise AttributeError(f"{kind.__name__} has no {name}" + (f": {told}" if told else f": did you mean {near[0]}?" if near else
                                                                         f", only {', '.join(members)}"))
            now = None if name in arrays else getattr(self, name)
            if isinstance(now, Struct) and not isinstance(value, Struct):
                if isinstance(value, dict):
                    now.set(**value)
                elif hasattr(value, "as_struct"):
                    setattr(self, name, value.as_struct())
                elif isinstance(value, str) and hasattr(type(now), "kind"):
                    if "." in value or "/" in value:
                        body = f", body={name!r}" if name in ("wheel", "rail") else ""
                        raise ValueError(f"{value!r} is no built-in shape; a file is read by wrc.read_profile({value!r}{body})")
                    now.kind = value  # type: ignore[attr-defined]
                else:
                    raise TypeError(f"{kind.__name__}.{name} is a wrc.{type(now).__name__} or a dict of its members, "
                                    f"not {value!r}")
            else:
                try:
                    setattr(self, name, value)
                except TypeError as why:
                    raise TypeError(f"{_told(self, name)}: {str(why).replace('must be', 'is a')}") from None
        return self

    def copy(self: S) -> S:
        """A copy, which keeps the arrays this struct points to."""
        holder: Any = (type(self) * 1)()  # type: ignore[operator]
        holder[0] = self
        return holder[0]  # type: ignore[no-any-return]

    __copy__ = copy

    def __deepcopy__(self: S, _: Any) -> S:
        return self.copy()

    def as_dict(self) -> Dict[str, Any]:
        """Members by name, nested structs as dicts, arrays copied: for files, and to send to other processes."""
        told: Dict[str, Any] = {}
        for name in self.members():
            value = getattr(self, name)
            if isinstance(value, Struct):
                value = value.as_dict()
            elif isinstance(value, list):
                value = [each.as_dict() for each in value]
            elif isinstance(value, np.ndarray):
                value = value.copy()
            elif isinstance(value, enum.IntEnum) or isinstance(value, enum.IntFlag):
                value = int(value)
            elif isinstance(value, (c._Pointer, c._CFuncPtr)):  # type: ignore[attr-defined]
                value = None
            told[name] = value
        return told

    def __reduce__(self) -> Any:
        return _from_dict, (type(self), self.as_dict())

    def __eq__(self, other: Any) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return _same(self.as_dict(), other.as_dict())

    __hash__ = None  # type: ignore[assignment]

    # ------------------------------------------------------------------------------------------------------- arrays

    @classmethod
    def dtype(cls) -> np.dtype:
        """The struct as a numpy dtype: pointers are addresses."""
        found = cls.__dict__.get("_dtype")
        if found is None:
            found = _dtype(cls)
            cls._dtype = found  # type: ignore[attr-defined]
        return found

    @classmethod
    def array(cls: Type[S], count: int, like: Optional[S] = None) -> np.ndarray:
        """A numpy array of `count` structs, all as `like` or as the defaults: what batches take and give. Members are
        columns: inputs["wheel"]["y"] = np.linspace(0, 3e-3, count)."""
        memory: Any = (cls * count)()  # type: ignore[operator]
        first: Any = like if like is not None else cls()
        view = np.frombuffer(memory, cls.dtype(), count)
        view[:] = np.frombuffer(first, cls.dtype(), 1)
        memory._like = like.copy() if like is not None else None  # what its pointers show lives as long as the array
        return view

    @classmethod
    def table(cls, array: np.ndarray) -> Dict[str, np.ndarray]:
        """An array of these structs as columns of numbers by name, "pose.lateral" and "force[0]", for tables:
        pandas.DataFrame(wrc.Wrench.table(out)). Members that point elsewhere have none."""
        found: Dict[str, np.ndarray] = {}
        for name in cls.members():
            part, member = array[name], getattr(cls, name)
            if isinstance(member, (Pointer, Reference, Text)):
                continue
            nested = _nested(cls, name)
            if nested is not None:
                found.update({f"{name}.{inner}": column for inner, column in nested.table(part).items()})
            elif part.ndim == 1:
                found[name] = part
            else:
                found.update({name + "".join(f"[{k}]" for k in at): part[(slice(None), *at)] for at in np.ndindex(part.shape[1:])})
        return found

    @classmethod
    def of(cls: Type[S], array: np.ndarray, index: int) -> S:
        """Element `index` of an array of these structs, in the array's memory."""
        if array.dtype != cls.dtype() or array.ndim != 1:
            raise TypeError(f"wrc.{cls.__name__}.array() makes arrays of {cls.__name__}; this one has dtype {array.dtype}")
        return cls.from_buffer(array[index % len(array):].data.cast("B"))  # type: ignore[no-any-return]

    # -------------------------------------------------------------------------------------------------- for a person

    def __repr__(self) -> str:
        return "\n".join([f"wrc.{type(self).__name__}", *self._lines("  ")])

    def _repr_html_(self) -> str:
        """The struct in a notebook: members, values, units."""
        return f"<b>wrc.{type(self).__name__}</b><table>{''.join(self._rows(''))}</table>"

    def _rows(self, prefix: str) -> Iterable[str]:
        for name in self.members():
            value = getattr(self, name)
            if isinstance(value, Struct):
                yield from value._rows(f"{prefix}{name}.")
            else:
                cells = (prefix + name, _shown(value), self._units_.get(name, ""))
                yield "<tr>" + "".join(f'<td style="text-align:left">{html.escape(each)}</td>' for each in cells) + "</tr>"

    def _lines(self, indent: str) -> Iterable[str]:
        names = self.members()
        width = max((len(name) for name in names), default=0)
        for name in names:
            value = getattr(self, name)
            if isinstance(value, Struct):
                yield f"{indent}{name}"
                yield from value._lines(indent + "  ")
            else:
                unit = self._units_.get(name, "") if value is not None else ""
                yield f"{indent}{name:<{width}}  {_shown(value)}{' ' + unit if unit else ''}"


def _shown(value: Any) -> str:
    if value is None:
        return "None"
    if isinstance(value, enum.IntFlag):
        return " | ".join(each.name or "" for each in type(value) if each in value) or "none"
    if isinstance(value, enum.Enum):
        return value.name
    if isinstance(value, np.ndarray):
        if value.size > 9:
            return f"{' x '.join(str(each) for each in value.shape)} numbers, {value.min():.6g} .. {value.max():.6g}"
        return "[" + ", ".join(f"{each:.6g}" for each in value.flat) + "]"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, (int, str)):
        return str(value)
    if isinstance(value, list):
        return f"{len(value)} of wrc.{type(value[0]).__name__}" if value else "none"
    return "set" if value else "None"


def _nested(kind: Any, name: str) -> Any:
    """The struct that a member is, or None."""
    field = next((each[1] for each in kind._fields_ if each[0] == name), None)
    return field if field is not None and issubclass(field, Struct) else None


def _dtype(kind: Any) -> np.dtype:
    """Members by name. What is no member stays behind its underscore: numpy copies fields alone, and it must be copied."""
    names, formats, offsets = [], [], []
    for each in kind._fields_:
        name, field = each[0], each[1]
        names.append(name.lstrip("_") if name.lstrip("_") in kind.members() else name)
        offsets.append(getattr(kind, name).offset)
        formats.append(_format(field))
    return np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": c.sizeof(kind)})


def _format(field: Any) -> Any:
    if issubclass(field, Struct):
        return field.dtype()
    if issubclass(field, c.Array):
        inner = _format(field._type_)
        return (inner, (field._length_,))
    return _DTYPES.get(field, "<u8")


def _from_dict(kind: Type[S], values: Dict[str, Any]) -> S:
    counts, values = {name for name in values if isinstance(getattr(kind, name, None), Count)}, dict(values)
    made = kind()
    for name in set(values) - counts:
        value = values[name]
        described = getattr(kind, name, None)
        if isinstance(described, References):
            value = values[name] = [_from_dict(described.kind(kind)._type_, each) for each in value]
        if isinstance(value, dict):
            inner = described.kind(kind)._type_ if isinstance(described, Reference) else type(getattr(made, name))
            setattr(made, name, _from_dict(inner, value))
    return made.set(**{name: value for name, value in values.items() if name not in counts and not isinstance(value, dict)
                       and not (value is None and not isinstance(getattr(kind, name, None), (Pointer, Text)))})


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, dict):
        return all(_same(one[name], other[name]) for name in one)
    if isinstance(one, list):
        return len(one) == len(other) and all(map(_same, one, other))
    return np.array_equal(one, other) if isinstance(one, np.ndarray) else one == other


# ------------------------------------------------------------------------------------------------ arguments of functions

class _Numbers:
    """Type of an argument that points to numbers: numpy arrays of the right kind, ctypes' own, None."""

    kind: Any

    @classmethod
    def from_param(cls, value: Any) -> Any:
        if value is None or isinstance(value, c.c_void_p):
            return value
        if isinstance(value, np.ndarray):
            if value.dtype != np.dtype(_DTYPES[cls.kind]) or not value.flags.c_contiguous:
                raise TypeError(f"this argument is a contiguous numpy array of {_DTYPES[cls.kind][1:]}, not {value.dtype}")
            return c.c_void_p(value.ctypes.data)
        return c.POINTER(cls.kind).from_param(value)


_NUMBERS: Dict[Any, Any] = {}


def Numbers(kind: Any) -> Any:
    """The argument type of pointers to numbers of that ctypes kind."""
    return _NUMBERS.setdefault(kind, type(f"Numbers_{kind.__name__}", (_Numbers,), {"kind": kind}))


Progress = c.CFUNCTYPE(c.c_int32, c.c_double, c.c_void_p)
ProgressArgument = Union[None, bool, Callable[[float], Any]]


class Watch:
    """A progress function of Python as the exact solver calls it. It is called with the fraction done; it stops the solver
    by giving something true (wrc.Cancelled is raised) or by raising, which comes through. True: a bar on the terminal."""

    def __init__(self, progress: ProgressArgument):
        self.raised: Optional[BaseException] = None
        self.progress: Optional[Callable[[float], Any]] = _bar if progress is True else progress or None
        self.c = Progress(self.call) if self.progress else Progress(0)

    def call(self, fraction: float, _: Any) -> int:
        try:
            return 1 if self.progress(fraction) else 0  # type: ignore[misc]
        except BaseException as why:  # of ctypes' callbacks nothing gets through by itself
            self.raised = why
            return 1

    def end(self) -> None:
        """Ends the line of the bar."""
        if self.progress is _bar:
            sys.stderr.write("\n")


def _bar(fraction: float) -> None:
    done = int(40 * fraction)
    sys.stderr.write(f"\r[{'#' * done}{'.' * (40 - done)}] {100 * fraction:3.0f} %")
    sys.stderr.flush()
