"""Results as pandas tables (pip install pandas)."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Mapping, Sequence, Union

import numpy as np

from . import _interface as i
from . import _struct as s

if TYPE_CHECKING:
    import pandas


def to_frame(of: Union[s.Struct, Sequence[s.Struct], np.ndarray, Mapping[str, np.ndarray]]) -> pandas.DataFrame:
    """A pandas.DataFrame of results.

    of: a struct, a list of structs (Contact.regions()), an array of them (Batch.wrench(), wrc.Wrench.array(n)): a row each,
        columns as "wheel.y" and "force[0]", choices and flags by name.
        A dict of arrays (Contact.fields(), Model.wheelset_geometry()): a row for each place, a column for each name. Of fields
        over cells the index has strip and cell, and numbers of strips stand in every cell of theirs.
    """
    try:
        import pandas
    except ImportError as why:
        raise ImportError("tables need pandas: pip install pandas") from why
    if isinstance(of, Mapping):
        return _fields({name: np.asarray(each) for name, each in of.items()})
    if isinstance(of, s.Struct):
        of = [of]
    if isinstance(of, np.ndarray):
        kind: Any = next((each for each in i.STRUCTS.values() if of.dtype == each.dtype()), None)
        if kind is None:
            raise TypeError(f"this array has no structs of wrc, but {of.dtype}: wrc.Wrench.array(n) makes one that has")
        return pandas.DataFrame(_columns(kind, of.reshape(-1)))
    kinds = {type(each) for each in of}
    if not kinds:
        return pandas.DataFrame()
    if len(kinds) > 1 or not isinstance(of[0], s.Struct):
        raise TypeError(f"a table has structs of one kind, not {', '.join(sorted(each.__name__ for each in kinds))}")
    kind = kinds.pop()
    return pandas.DataFrame(_columns(kind, np.frombuffer(b"".join(map(bytes, of)), kind.dtype())))  # type: ignore[arg-type]


def _columns(kind: Any, array: np.ndarray) -> Dict[str, Any]:
    """Columns of an array of structs, choices by name."""
    found: Dict[str, Any] = {}
    for name, column in kind.table(array).items():
        inner, path = kind, name.split("[")[0].split(".")
        for each in path[:-1]:
            inner = s._nested(inner, each)
        member = getattr(inner, path[-1], None)
        if isinstance(member, s.Chosen):
            names: Dict[int, str] = {each: s._shown(s._choice(member.kind, each)) for each in np.unique(column).tolist()}
            found[name] = [names[each] for each in column.tolist()]
        else:
            found[name] = column.copy()
    return found


def _fields(arrays: Dict[str, np.ndarray]) -> pandas.DataFrame:
    """A table of arrays over places, or over strips and cells."""
    import pandas

    shape = max((each.shape for each in arrays.values()), key=len, default=(0,))
    if len(shape) == 1:
        return pandas.DataFrame(arrays)
    index = pandas.MultiIndex.from_product([range(shape[0]), range(shape[1])], names=["strip", "cell"])
    columns: Dict[str, np.ndarray] = {}
    for name, each in arrays.items():
        whole = each if each.shape == shape else each[:, None] if each.shape == shape[:1] else None
        if whole is not None:
            columns[name] = np.broadcast_to(whole, shape).reshape(-1)
    return pandas.DataFrame(columns, index=index)
