"""The types of the Python package's module of the interface, for editors and type checkers: _interface.pyi.

ctypes knows any attribute and no keyword. Here every member of a struct has its type and its docstring, every choice the names
it takes, every constructor its keywords, every group of a configuration its dict."""
import re

import python

HEAD = """from typing import Any, Callable, Dict, List, Literal, Optional, Sequence, Tuple, Type, TypedDict, Union
import ctypes as c
import enum

import numpy as np
from numpy.typing import NDArray

from . import _library as _l
from . import _struct as s
"""


def written(interface, described, mark):
    """{path in the tree: text}"""
    return {"bindings/python/wrc/_interface.pyi": _Types(interface, described).module(mark)}


class _Types(python.Writer):
    def module(self, mark):
        lines = [f'"""{mark}"""', "# fmt: off", HEAD]
        lines += [f"{name[len('WRC_'):]}: int" for name, _ in self.interface.numbers]
        lines += ["STATUS_TEXTS: Dict[int, str]", "STRUCTS: Dict[str, Type[s.Struct]]", "FUNCTIONS: Dict[str, Callable[..., Any]]"]
        presets = [name for name, _ in self.interface.presets] + self.interface.resolutions
        lines += ["PRESETS: Tuple[str, ...]", f"PresetName = Literal{presets!r}"]
        lines += ["FRICTIONS: Dict[str, Tuple[str, str]]", f"FrictionName = Literal{[name for name, _, _ in self.interface.frictions]!r}"]
        statuses = [(name[len("WRC_"):], value, text) for name, value, text in self.interface.statuses]
        lines += self.choice("Status", "s.Choice", statuses)
        lines += self.choice("Flags", "enum.IntFlag", [(name[len("FLAG_"):], 1 << value, text) for name, value, text in statuses if value > 0])
        for each in self.interface.enumerations.values():
            names = python.enumerator_names(each)
            kind = "enum.IntFlag" if each.name in self.flags else "s.Choice"
            lines += self.choice(python.class_name(each.name), kind, [(names[one.name], one.value, self.text(one.comment)) for one in each.values])
        for each in self.interface.structs.values():
            lines += self.struct(each)
        lines += [""] + [f"_{each.name}: Callable[..., Any]" for each in self.interface.functions.values() if each.exported]
        lines += self.stubs()
        lines += ["", "__all__ = ["] + [f"    {name!r}," for name in self.public()] + ["]"]
        return "\n".join(lines) + "\n"

    def choice(self, name, kind, members):
        """An enumeration, and what is taken where one of its members is asked for."""
        lines = ["", f"class {name}({kind}):"]
        for member, value, text in members:
            lines += [f"    {member} = {value}"] + self.docstring([text], "    ") * bool(text)
        if kind == "enum.IntFlag":
            return lines + [f"{name}Like = Union[{name}, int]"]
        names = [member for member, _, _ in members] + [member.split("_", 1)[1] for member, _, _ in members if re.match(r"[A-Z]+_\d", member)]
        return lines + [f"{name}Like = Union[{name}, Literal{names!r}]"]

    def struct(self, struct):
        name = python.class_name(struct.name)
        told = self.described[struct.name]
        typed = [(each, *self.types(each, told)) for each in told if not self.hidden(each)]
        lines = ["", f"class {name}(s.Struct):"] + self.docstring([self.text(struct.comment)], "    ")
        for each, read, set_by, _ in typed:
            member, text = each.member.name, [self.member(each).strip(": ")]
            if read == set_by:
                lines += [f"    {member}: {read}"] + self.docstring(text, "    ")
                continue
            lines += ["    @property", f"    def {member}(self) -> {read}:"] + self.docstring(text, "        ")
            if set_by:
                lines += [f"    @{member}.setter", f"    def {member}(self, value: {set_by}) -> None: ..."]
        keywords = [(each.member.name, given) for each, _, _, given in typed if given]
        parameters = ", ".join(f"{member}: {given} = ..." for member, given in keywords)
        star = "*, " if keywords else ""
        lines += [f"    def __init__(self, {star}{parameters}) -> None:"] + self.docstring(["The defaults, and what is given."], "        ")
        lines += [f"    def set(self, {star}{parameters}) -> {name}:  # type: ignore[override]"]
        lines += self.docstring(["Sets members by name, nested structs by dicts of theirs, and gives the struct itself."], "        ")
        lines += ["", f"class {name}Dict(TypedDict, total=False):"] + self.docstring([f"Members of wrc.{name} as a dict."], "    ")
        return lines + [f"    {member}: {given}" for member, given in keywords]

    def types(self, told, beside):
        """(type when read, type when set or "", type as an argument or "") of one member."""
        _, _, annotation, descriptor = self.field(told, beside)
        kind = (descriptor or "").split("(")[0]
        base = told.member.type.base
        if kind == "s.Chosen":
            return annotation, f"{annotation}Like", f"{annotation}Like"
        if kind == "s.Array":
            return "NDArray[Any]", "s.Floats", "s.Floats"
        if kind == "s.Count":
            return "int", "", ""
        if kind == "s.Pointer":
            return "Optional[NDArray[np.float64]]", "Optional[s.Floats]", "Optional[s.Floats]"
        if kind == "s.Text":
            return "Optional[str]", "Optional[s.Path]", "Optional[s.Path]"
        if kind == "s.References":
            named = python.class_name(base)
            given = f"Optional[Sequence[Union[{named}, {named}Dict]]]"
            return f"List[{named}]", given, given
        if base in self.interface.structs and annotation != "Any" and not told.member.type.pointers:
            choices = [self.described[base][k].enumeration for k in range(len(self.described[base]))
                       if self.described[base][k].member.name == "kind" and self.described[base][k].enumeration]
            shapes = "".join(f", {python.class_name(each)}Like, s.AsStruct" for each in choices)  # a profile, by the name of its shape too
            return annotation, annotation, f"Union[{annotation}, {annotation}Dict{shapes}]"
        return annotation, annotation, annotation

    def stubs(self):
        """Classes ContactCalls and ModelCalls, and functions without a handle."""
        lines = []
        calls = [(each, found) for each in self.interface.functions.values() for found in [self.call(each) if each.exported else None] if found]
        for owner in ("Model", "Contact"):
            lines += ["", f"class {owner}Calls(_l.Handle):", f'    """What {owner} has of the C interface as it is."""']
            for function, found in calls:
                if found[0] == owner:
                    lines += [self.signature(function, found, "    "), *self.docstring(self.told(function, found[2], self.outs(found)), " " * 8)]
        for function, found in calls:
            if not found[0]:
                lines += [self.signature(function, found, ""), *self.docstring(self.told(function, found[2], self.outs(found)), " " * 4)]
        return lines

    @staticmethod
    def outs(found):
        return sum(role == "out" for _, _, role in found[2])

    def signature(self, function, found, indent):
        return self.method(function, found, indent)[0]
