"""The Python package's module of the interface: enumerations, structs, prototypes, and a method for each call on a contact,
a model or plain numbers whose arguments say what they are."""
import re

import fortran
import grammar

NUMBERS = {"int32_t": "c.c_int32", "uint32_t": "c.c_uint32", "uint64_t": "c.c_uint64", "int64_t": "c.c_int64",
           "double": "c.c_double"}
HANDLES = ("wrc_contact", "wrc_model", "wrc_exact_transient", "wrc_rail_faces", "wrc_section_file")
# Written by hand, where a Python caller wants something else than the C arguments.
BY_HAND = {"wrc_contact_field": "Contact.field", "wrc_contact_stresses": "Contact.stresses", "wrc_contact_accumulate": "Contact.accumulate",
           "wrc_contact_wrench_batch": "Batch.wrench", "wrc_contact_save": "Contact.save", "wrc_contact_restore": "Contact.restore",
           "wrc_contact_last_error": "Contact.message", "wrc_model_profile": "Model.profile", "wrc_model_arc_places": "Model.arc_places",
           "wrc_profile_wheelset_geometry": "Model.wheelset_geometry", "wrc_equivalent_conicity": "conicity", "wrc_config_use": "use",
           "wrc_damage_values": "Bins.values", "wrc_damage_merge": "Bins.merge", "wrc_profile_remove_wear": "remove_wear",
           "wrc_flange_dimensions": "flange_dimensions", "wrc_rail_faces_create": "rail_faces", "wrc_rail_faces_found": "rail_faces",
           "wrc_rail_faces_outline": "rail_faces", "wrc_section_file_read": "read_sections", "wrc_section_file_line": "read_sections",
           "wrc_section_file_write": "write_sections", "wrc_flash_temperature": "flash_temperature",
           "wrc_whole_life_damage": "whole_life_damage", "wrc_exact_gap": "Contact.exact_gap", "wrc_exact_normal": "exact.normal",
           "wrc_exact_rolling": "exact.rolling", "wrc_exact_transient_step": "exact.Transient.step", "wrc_exact_stress": "exact.stresses",
           "wrc_exact_largest_stresses": "exact.largest_stresses", "wrc_surface_laws_use": "surface_laws",
           "wrc_surface_friction": "surface_friction", "wrc_surface_pass": "surface_pass", "wrc_surface_add": "Band.add",
           "wrc_surface_values": "Band.values", "wrc_surface_rest": "Band.rest", "wrc_surface_merge": "Band.merge"}
# double* that is one number; any other may be an array, and such calls are left to the raw functions.
ONE_NUMBER = ("load_factor",)
CALLBACKS = ("wrc_progress",)  # with a Python type of their own, s.Progress


def written(interface, described, mark):
    """{path in the tree: text}"""
    return {"bindings/python/wrc/_interface.py": Writer(interface, described).module(mark)}


def class_name(name):
    """wrc_wheel_input: WheelInput"""
    return "".join(word[:1].upper() + word[1:] for word in name[len("wrc_"):].split("_"))


def enumerator_names(enumeration):
    """{C name: Python name}: without what all share; PROFILE_60E1 where a digit would be first."""
    full = [each.name for each in enumeration.values]
    words = [name.split("_") for name in full]
    shared = 1  # WRC
    while all(len(each) > shared + 1 and each[shared] == words[0][shared] for each in words) and len(words) > 1:
        shared += 1
    short = {}
    for name, each in zip(full, words):
        kept = "_".join(each[shared:])
        short[name] = "_".join(each[shared - 1:]) if kept[0].isdigit() else kept
    return short


def items(text):
    """Lines of a text and of the list in it."""
    first, *others = re.split(r"(?<=[.:;]) - (?=\S)", text)
    return [first, *(f"  - {each}" for each in others)]


class Writer:
    def __init__(self, interface, described):
        self.interface, self.described = interface, described
        bits = {re.match(r"bits of enum (\w+)", member.comment).group(1) for struct in interface.structs.values()
                for member in struct.members if member.comment.startswith("bits of enum ")}
        self.flags = {name for name in interface.enumerations if name in bits}
        self.said = self.names()

    def hidden(self, told):
        """Is a member what the package itself sets: sizes of structs, and room for later versions, which stays 0?"""
        return told.role in ("struct_size", "reserved") or told.member.name.startswith("reserved") or told.member.comment.startswith("sizeof(")

    def names(self):
        """C name: what Python calls it, for texts."""
        said = {name: class_name(name) for name in self.interface.structs}
        said |= {name: class_name(name) for name in self.interface.enumerations}
        for each in self.interface.enumerations.values():
            said |= {c_name: f"{class_name(each.name)}.{name}" for c_name, name in enumerator_names(each).items()}
        said |= {name: f"Status.{name[len('WRC_'):]}" for name, _, _ in self.interface.statuses}
        said |= BY_HAND | {name: name[len("WRC_"):] for name, _ in self.interface.numbers}
        for name, function in self.interface.functions.items():
            if function.exported and self.call(function):
                owner, method, _ = self.call(function)
                said[name] = f"{owner}.{method}" if owner else method
        return said

    def text(self, comment):
        """A comment in Python's names, safe within a docstring."""
        comment = re.sub(r"\b(?:wrc|WRC)_\w+", lambda each: self.said.get(each.group(0), each.group(0)), comment)
        comment = re.sub(r"\bNULL\b", "None", re.sub(r"\benum ", "", comment)).replace("`", "")
        return comment.replace("\\", "\\\\").replace('"""', "'''").strip()

    def module(self, mark):
        lines = [f'"""{mark}', "", "The whole C interface: enumerations, structs, functions. Import from wrc, not from here.", '"""',
                 "# fmt: off", "from __future__ import annotations", "", "import ctypes as c", "import enum",
                 "from typing import Any, Callable, Optional, Sequence, Tuple", "", "import numpy as np", "",
                 "from . import _library as _l", "from . import _struct as s", ""]
        lines += [f"{name[len('WRC_'):]} = {value}" for name, value in self.interface.numbers]
        lines += ["", "", "class Status(s.Choice):", '    """What a call returns: 0 done, > 0 done but flagged, < 0 failed."""', ""]
        lines += [f"    {name[len('WRC_'):]} = {value}, {text!r}" for name, value, text in self.interface.statuses]
        lines += ["", "", "STATUS_TEXTS = {int(each): each.__doc__ for each in Status}",
                  f"PRESETS = {tuple(name for name, _ in self.interface.presets)!r}",
                  f"FRICTIONS = {({name: (source, status) for name, source, status in self.interface.frictions})!r}"]
        flags = [(name[len("WRC_FLAG_"):], value, text) for name, value, text in self.interface.statuses if value > 0]
        lines += ["", "", "class Flags(enum.IntFlag):"] + self.docstring(
            ["The flags of a result, a bit for each that was met: wrc.Flags.NO_CONTACT in wrench.flags.", ""]
            + [f"{name}: {text}" for name, _, text in flags], "    ") + [""]
        lines += [f"    {name} = 1 << {value}" for name, value, _ in flags]
        for each in self.interface.enumerations.values():
            lines += self.enumeration(each)
        for each in self.interface.structs.values():
            lines += self.struct(each)
        lines += self.prototypes()
        lines += self.calls()
        lines += ["", "", "STRUCTS = {"] + [f"    {name!r}: {class_name(name)}," for name in self.interface.structs] + ["}"]
        return "\n".join(lines + ["__all__ = ["] + [f"    {name!r}," for name in self.public()] + ["]"]) + "\n"

    def public(self):
        """Names that the package has of the module."""
        called = [found[1] for each in self.interface.functions.values() for found in [self.call(each) if each.exported else None]
                  if found and not found[0]]
        return (["Status", "Flags"] + [class_name(name) for name in (*self.interface.enumerations, *self.interface.structs)]
                + [name[len("WRC_"):] for name, _ in self.interface.numbers if "VERSION" not in name] + called)

    # ------------------------------------------------------------------------------------------- enumerations, structs

    def enumeration(self, enumeration):
        kind = "enum.IntFlag" if enumeration.name in self.flags else "s.Choice"
        names = enumerator_names(enumeration)
        lines = ["", "", f"class {class_name(enumeration.name)}({kind}):"] + self.docstring([self.text(enumeration.comment), ""] + [
            f"{names[each.name]}: {self.text(each.comment)}" for each in enumeration.values], "    ")
        told = kind == "s.Choice"
        return lines + [""] + [f"    {names[each.name]} = {each.value}" + f", {self.text(each.comment)!r}" * told for each in enumeration.values]

    def struct(self, struct):
        name = class_name(struct.name)
        told = self.described[struct.name]
        shown = [each for each in told if not self.hidden(each)]
        lines = ["", "", f"class {name}(s.Struct):"]
        lines += self.docstring([self.text(struct.comment), "", "Members:"] + ["  " + self.member(each) for each in shown], "    ")
        lines += ["", f"    _c_name_ = {struct.name!r}", "    __slots__ = ()"]
        fields, plain = [], []
        for each in told:
            field, kind, annotation, descriptor = self.field(each, told)
            fields.append(f"({field!r}, {kind})")
            if each not in shown:
                continue
            if descriptor:
                plain.append(f"    {each.member.name}: {annotation} = {descriptor}  # type: ignore[assignment]")
            else:
                plain.append(f"    {each.member.name}: {annotation}")
        units = {each.member.name: each.unit for each in shown if each.unit not in ("", "-")}
        lines += plain + [f"    {name} = {values!r}" for name, values in (("_units_", units), ("_defaults_", self.defaults(told))) if values]
        lines += ["    _fields_ = ["] + [f"        {each}," for each in fields] + ["    ]"]
        return lines + [f"assert c.sizeof({name}) == {struct.size}"]

    def defaults(self, told):
        """{field: number} of the defaults that are not 0."""
        found = {}
        for each in told:
            enumerator = self.interface.enumerator(each.default)
            value = enumerator[1].value if enumerator else float(each.default) if re.fullmatch(grammar.NUMBER, each.default) else 0
            if value:
                name = self.field(each, told)[0]
                found[name] = float(value) if each.member.type.base == "double" else int(value)
        return found

    def member(self, told):
        """One line of a struct's docstring."""
        unit = f" [{told.unit}]" if told.unit not in ("", "-") else ""
        sentence = self.text(told.sentence)
        allowed = ", ".join(("0 or " if each.or_zero else "") + f"{each.low} .. {each.high}" for each in told.ranges)
        default = self.text(told.default) if told.role in ("input", "enumeration") else ""
        tail = "; ".join(each for each in (allowed, f"default {default}" if default not in ("", "required") else default) if each)
        return f"{told.member.name}{unit}: {sentence}" + (f" ({tail})" if tail else "")

    def field(self, told, beside):
        """(name in _fields_, ctypes type, annotation, descriptor or None) of one member."""
        member = told.member
        name, kind = member.name, member.type
        if self.hidden(told):
            typed = class_name(kind.base) if kind.base in self.interface.structs else NUMBERS[kind.base]
            for extent in reversed(kind.extents):
                typed = f"{typed} * {extent}"
            return "_" + name, typed, "", None
        if kind.base == "function":
            known = kind.spelling in CALLBACKS
            return name, "s.Progress" if known else "c.c_void_p", "Any", None
        if kind.pointers:
            if kind.base == "double":
                product = re.match(r"(\w+) \* (\w+) of them", member.comment)
                stride = next((each.member.name for each in beside if each.member.name == "row_stride"), None)
                if told.counted_by:
                    arguments = f", {told.counted_by!r}"
                elif product:
                    arguments = f", {', '.join(map(repr, product.groups()))}"
                elif stride:
                    arguments = f", 'row_count', 'column_count', stride={stride!r}"
                else:
                    arguments = ""
                return "_" + name, "c.POINTER(c.c_double)", "Optional[np.ndarray]", f"s.Pointer({name!r}{arguments})"
            if kind.base in self.interface.structs and kind.pointers == 1:
                typed = class_name(kind.base)
                size = next((each.member.name for each in beside if each.member.comment.startswith(f"sizeof({kind.base})")), "")
                if told.counted_by:
                    return ("_" + name, f"c.POINTER({typed})", f"Sequence[{typed}]",
                            f"s.References({name!r}, {told.counted_by!r}, size={size!r})".replace(", size='')", ")"))
                return "_" + name, f"c.POINTER({typed})", f"Optional[{typed}]", f"s.Reference({name!r}, size={size!r})".replace(", size='')", ")")
            if kind.base == "char":
                return "_" + name, "c.c_char_p", "Optional[str]", f"s.Text({name!r})"
            return name, "c.c_void_p", "Any", None
        if kind.base in self.interface.structs:
            typed = class_name(kind.base)
            for extent in reversed(kind.extents):
                typed = f"{typed} * {extent}"
            return name, typed, class_name(kind.base) if not kind.extents else "Any", None
        typed = NUMBERS[kind.base]
        if kind.extents:
            for extent in reversed(kind.extents):
                typed = f"({typed} * {extent})"
            return "_" + name, typed[1:-1], "np.ndarray", f"s.Array({name!r}, {member.offset}, {kind.extents!r}, {NUMBERS[kind.base]})"
        if told.enumeration and told.enumeration not in self.flags:
            choice = class_name(told.enumeration)
            return "_" + name, typed, choice, f"s.Chosen({name!r}, {choice})"
        if member.comment.startswith("bit 1 << flag"):
            return "_" + name, typed, "Flags", f"s.Chosen({name!r}, Flags)"
        bits = re.match(r"bits of enum (\w+)", member.comment)
        if bits and bits.group(1) in self.flags:
            choice = class_name(bits.group(1))
            return "_" + name, typed, choice, f"s.Chosen({name!r}, {choice})"
        if any(each.counted_by == name for each in beside):
            return "_" + name, typed, "int", f"s.Count({name!r})"
        return name, typed, "float" if kind.base == "double" else "int", None

    # ------------------------------------------------------------------------------------------------------ functions

    def prototypes(self):
        lines = ["", "", "# The C functions, as ctypes calls them: without the GIL.", "FUNCTIONS: dict = {}"]
        for function in self.interface.functions.values():
            if function.exported:
                kinds = ", ".join(self.argument_type(name, kind) for name, kind in function.arguments)
                lines.append(f"_{function.name} = _l.function(FUNCTIONS, {function.name!r}, {self.result_type(function.returned)}, [{kinds}])")
        return lines

    def result_type(self, kind):
        if kind.base == "char" and kind.pointers:
            return "c.c_char_p"
        if kind.pointers:
            return "c.c_void_p"
        return "None" if kind.base == "void" else NUMBERS[kind.base]

    def argument_type(self, name, kind):
        if kind.base == "function":
            return "s.Progress" if kind.spelling in CALLBACKS else "c.c_void_p"
        if kind.base in HANDLES or kind.base == "void" or kind.pointers > 1:
            return "c.c_void_p"
        if kind.base == "char":
            return "c.c_char_p"
        if kind.base in self.interface.structs:
            return f"c.POINTER({class_name(kind.base)})" if kind.pointers else class_name(kind.base)
        return f"s.Numbers({NUMBERS[kind.base]})" if kind.pointers else NUMBERS[kind.base]

    def call(self, function):
        """(owner, name, what each argument is) of a function that gets a method, or None."""
        name, arguments = function.name, list(function.arguments)
        if name in BY_HAND or function.returned.base != "int32_t" or name.endswith(("_init", "_size")):
            return None
        owner = ""
        if arguments and arguments[0][1].base in HANDLES and arguments[0][1].pointers == 1:
            owner = class_name(arguments.pop(0)[1].base)
        roles = []
        while arguments:
            each, kind = arguments.pop(0)
            if kind.base == "function" and kind.spelling in CALLBACKS and arguments:
                arguments.pop(0)
                roles.append((each, kind, "progress"))
            elif kind.base in self.interface.structs and kind.pointers == 1:
                if not kind.const and self.has_arrays(kind.base):
                    return None
                roles.append((each, kind, "in" if kind.const else "out"))
            elif kind.base == "char" and not kind.const and len(arguments) == 1 and arguments[0][1].base == "uint64_t":
                arguments.pop()
                roles.append((each, kind, "sentence"))
            elif kind.base in NUMBERS and not kind.pointers:
                roles.append((each, kind, "number"))
            elif kind.base == "double" and each in ONE_NUMBER:
                roles.append((each, kind, "one number"))
            else:
                return None
        if not owner and not any(role in ("out", "one number") for _, _, role in roles):
            return None
        prefix = f"wrc_{owner.lower()}_" if owner else "wrc_"
        return owner, name[len(prefix):] if name.startswith(prefix) else name[len("wrc_"):], roles

    def has_arrays(self, struct):
        """Are results written to arrays of the caller? How long they must be is in words: such calls are left to the raw
        functions, and to what is written by hand."""
        return any(each.type.pointers and not each.type.const for each in self.interface.structs[struct].members)

    def watched(self, kind):
        """The member of a struct that is a progress function, which the method then has as an argument."""
        members = self.interface.structs[kind.base].members
        return next((each.name for each in members if each.type.base == "function" and each.type.spelling in CALLBACKS), None)

    def calls(self):
        """Classes ContactCalls and ModelCalls, and functions without a handle."""
        lines = []
        for owner in ("Model", "Contact"):
            lines += ["", "", f"class {owner}Calls(_l.Handle):", f'    """What {owner} has of the C interface as it is."""', "", "    __slots__ = ()"]
            for function in self.interface.functions.values():
                found = self.call(function) if function.exported else None
                if found and found[0] == owner:
                    lines += [""] + self.method(function, found, "    ")
        for function in self.interface.functions.values():
            found = self.call(function) if function.exported else None
            if found and not found[0]:
                lines += ["", ""] + self.method(function, found, "")
        return lines

    def method(self, function, found, indent):
        owner, name, roles = found
        outs = [(each, kind) for each, kind, role in roles if role == "out"]
        required, optional, before, passed = [], [], [], ["self._handle"] if owner else []
        for each, kind, role in roles:
            if role == "in":
                typed = class_name(kind.base)
                if fortran.optional(function, each):
                    optional.append(f"{each}: Optional[{typed}] = None")
                else:
                    required.append(f"{each}: {typed}")
            elif role == "number":
                required.append(f"{each}: {'float' if kind.base == 'double' else 'int'}")
            elif role == "progress":
                optional.append(f"{each}: s.ProgressArgument = None")
            passed.append(each)
        keywords = []
        for each, kind in outs:
            keyword = "out" if len(outs) == 1 else each
            keywords.append(f"{keyword}: Optional[{class_name(kind.base)}] = None")
            before += [f"if {keyword} is None:", f"    {keyword} = {class_name(kind.base)}._new()"]
            passed[passed.index(each)] = keyword
        answers = ["out" if len(outs) == 1 else each for each, _ in outs]
        kinds = [class_name(kind.base) for _, kind in outs]
        for each, kind, role in roles:
            if role == "one number":
                before.append(f"{each} = c.c_double()")
                passed[passed.index(each)] = f"c.byref({each})"
                answers.append(f"{each}.value")
                kinds.append("float")
        watched = next(((each, kind) for each, kind, role in roles if role == "in" and self.watched(kind)), None)
        if watched:
            optional.append("progress: s.ProgressArgument = None")
        arguments = (["self"] if owner else []) + required + optional + (["*"] + keywords if keywords else [])
        returned = f"Tuple[{', '.join(kinds)}]" if len(kinds) > 1 else kinds[0] if kinds else "None"
        lines = [f"{indent}def {name}({', '.join(arguments)}) -> {returned}:"]
        lines += self.docstring(self.told(function, roles, len(outs)), indent + "    ")
        body = before[:]
        progress = next((each for each, _, role in roles if role == "progress"), None)
        if progress:
            at = passed.index(progress)
            passed[at:at + 1] = ["_watch.c", "None"]
            body.append(f"_watch = s.Watch({progress})")
        if watched:
            each, kind = watched
            progress = "progress"
            body += ["_watch = s.Watch(progress)", "if progress:",
                     f"    {each} = {each}.copy() if {each} else {class_name(kind.base)}()", f"    {each}.{self.watched(kind)} = _watch.c"]
        sentence = next((each for each, _, role in roles if role == "sentence"), None)
        if sentence:
            at = passed.index(sentence)
            passed[at:at + 1] = ["_text", "len(_text)"]
            body.append("_text = c.create_string_buffer(1024)")
        call = f"_{function.name}({', '.join(passed)})"
        prepared = len(body)
        if owner and sentence:
            body += ["with self._lock:", f"    status = self._status = {call}", "_l.check_watched(status, _text, _watch)" if progress else
                     "_l.check(status, _text)"]
        elif owner:
            body += ["with self._lock:", f"    status = self._status = {call}", *["    _watch.end()"] * bool(progress),
                     "    if status < 0:",
                     f"        raise self._error(status{', _watch' if progress else ''})"]
        elif progress:
            body += [f"_l.check_watched({call}, {'_text' if sentence else 'None'}, _watch)"]
        else:
            body += [f"_l.check({call}{', _text' if sentence else ''})"]
        structs = [(each, kind) for each, kind, role in roles if role == "in"] + [(answers[k], kind) for k, (_, kind) in enumerate(outs)]
        given = ", ".join(f"{each}=({each}, {class_name(kind.base)})" for each, kind in structs)
        if given:
            body[prepared:] = ["try:", *[f"    {each}" for each in body[prepared:]], "except c.ArgumentError as _why:",
                               f"    raise _l.misfit(_why, {given}) from None"]
        if answers:
            body.append(f"return {', '.join(answers)}")
        return lines + [f"{indent}    {each}" for each in body]

    def told(self, function, roles, outs):
        """A function's comment as a docstring's lines."""
        pieces = function.comment.split("@")
        lines = [*items(self.text(pieces[0])), ""]
        watched = [each for each, kind, role in roles if role == "in" and self.watched(kind)]
        roles = {each: role for each, _, role in roles}
        for piece in pieces[1:]:
            command, _, rest = piece.partition(" ")
            command = command.split("[")[0]
            if command == "param":
                name, _, rest = rest.partition(" ")
                if name in roles and roles[name] != "sentence":
                    out = roles[name] == "out"
                    shown = "out" if out and outs == 1 else name
                    rest = re.sub(r";? NULL: not wanted", "", rest)
                    lines.append(f"{shown}: {self.text(rest)}" + ("; None: a new one" if out else ""))
                    if name in watched:
                        lines.append("progress: called with the fraction done; give something true to stop; None: none")
            elif command == "return":
                lines += [""] * bool(lines[-1]) + items("C status: " + self.text(rest))
        return lines

    def docstring(self, lines, indent):
        """Lines broken at 110 columns, as a docstring."""
        broken = []
        for line in lines:
            lead = " " * (len(line) - len(line.lstrip()))
            row = lead
            for word in line.split():
                if len(indent) + len(row) + len(word) > 110 and row.strip():
                    broken.append(row.rstrip())
                    row = lead + "    "
                row += word + " "
            broken.append(row.rstrip())
        while broken and not broken[-1]:
            broken.pop()
        if len(broken) == 1 and len(broken[0]) < 100:
            return [f'{indent}"""{broken[0]}"""']
        return [f'{indent}"""{broken[0]}'] + [(indent + each).rstrip() for each in broken[1:]] + [f'{indent}"""']
