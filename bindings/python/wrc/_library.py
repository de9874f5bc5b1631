"""The shared library: loading it, its errors, and what Model and Contact share."""
from __future__ import annotations

import ctypes as c
import os
import pathlib
import sys
import threading
from typing import Any, Callable, Dict, List, Optional, Tuple

from ._renamed import current

NAMES = {"win32": "wrc-0.9.dll", "darwin": "libwrc.dylib"}
FOLDER = pathlib.Path(__file__).resolve().parent


class Error(ValueError):
    """A call of the library that failed; its text is the library's own sentence.

    status: a wrc.Status, for example wrc.Status.ERROR_RANGE
    """

    __module__ = "wrc"

    def __init__(self, status: int, text: str):
        from ._interface import Status

        self.status = Status.of(status)
        super().__init__(text)

    def __reduce__(self) -> Any:
        return type(self), (int(self.status), str(self))


class Cancelled(Error):
    """A progress function asked the exact solver to stop."""

    __module__ = "wrc"


def _load() -> c.CDLL:
    path = os.environ.get("WRC_LIBRARY") or str(FOLDER / NAMES.get(sys.platform, "libwrc.so"))
    try:
        return c.CDLL(path)
    except OSError as why:
        raise ImportError(f"{why}. The wrc package brings its library with it: install the wheel, "
                          "or name a library in the environment's WRC_LIBRARY") from why


_library = _load()


def function(table: Dict[str, Any], name: str, returned: Any, arguments: List[Any]) -> Callable[..., Any]:
    """One C function with its types, noted in the table."""
    try:
        found = getattr(_library, name)
    except AttributeError:
        raise ImportError(f"{_library._name} has no {name}: it is older than this package") from None
    found.restype, found.argtypes = returned, arguments
    table[name] = found
    return found  # type: ignore[no-any-return]


def check_version(abi: int, experimental: int) -> None:
    """Refuses a library that serves other interfaces than this package was made for."""
    text = _library.wrc_version_text
    text.restype = c.c_char_p
    if _library.wrc_abi_version() != abi:
        raise ImportError(f"{_library._name}: {text(c.c_uint32(abi)).decode()}")
    if not _library.wrc_get_experimental_api(c.c_uint32(experimental)):
        raise ImportError(f"{_library._name} has another version of wrc_damage.h, wrc_offline.h, wrc_profiles.h and wrc_surface.h than this package's "
                          f"{experimental}")


def fault(status: int, text: str = "") -> Error:
    """The exception for a status: the sentence, or where there is none the status' meaning."""
    from ._interface import STATUS_TEXTS, Status

    name = Status.of(status).name
    kind = Cancelled if status == Status.ERROR_CANCELLED else Error
    return kind(status, text or f"{name}: {STATUS_TEXTS.get(status, 'unknown status')}")


def check(status: int, text: Any = None) -> int:
    """Raises Error where a call without a handle failed."""
    if status < 0:
        raise fault(status, text.value.decode(errors="replace") if text is not None else "")
    return status


def misfit(why: Exception, **given: Tuple[Any, type]) -> TypeError:
    """The exception for an argument that is not the struct it should be: name=(what was given, the struct's class)."""
    for name, (value, kind) in given.items():
        if value is not None and not isinstance(value, kind):
            struct = f"wrc.{kind.__name__}"
            return TypeError(f"{name} is a {struct}, not a {type(value).__name__}: " + (
                f"{struct}(**values) makes one of a dict" if isinstance(value, dict) else f"{struct}(member=value, ...) makes one"))
    return TypeError(str(why))


def check_watched(status: int, text: Any, watch: Any) -> int:
    """As check(); what a progress function raised comes first."""
    watch.end()
    if watch.raised is not None:
        raise watch.raised
    return check(status, text)


class Handle:
    """What Model and Contact share: the C handle in memory that Python owns, and the last status."""

    __slots__ = ("_handle", "_memory", "_status", "_lock", "__weakref__")

    _handle: Optional[c.c_void_p]
    _memory: Any
    _status: int

    def _take(self, memory: Any, handle: c.c_void_p, status: int) -> None:
        self._memory, self._handle, self._status = memory, handle, status
        self._lock = threading.RLock()

    @property
    def status(self) -> Any:
        """A wrc.Status. Of the last call: 0 done, > 0 done but flagged; of a model its making."""
        from ._interface import Status

        return Status.of(self._status)

    __dir__ = current

    def close(self) -> None:
        """Gives the memory back as soon as nothing else uses it (views, contacts of a model). Later calls raise Error."""
        self._handle = self._memory = None

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _error(self, status: int, watch: Any = None) -> BaseException:
        if watch is not None and watch.raised is not None:
            return watch.raised  # type: ignore[no-any-return]
        if self._handle is None:
            return Error(status, f"this {type(self).__name__} is closed")
        return fault(status, self._sentence())

    def _sentence(self) -> str:
        return ""


def aligned(size: int, alignment: int) -> Tuple[Any, int]:
    """(memory that lives as long as it is referred to, address in it with that alignment)"""
    memory = c.create_string_buffer(size + alignment)
    address = c.addressof(memory)
    return memory, address + -address % alignment
