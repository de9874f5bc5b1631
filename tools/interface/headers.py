"""What the C headers declare, as libclang reads them: numbers, statuses, enumerations, structs, functions, in their order.

The headers are parsed for one fixed target and with the standard headers they need given here, so that the outcome
does not depend on the machine. Needs libclang 14 or newer with its Python binding (Debian: python3-clang-14, or
libclang of the Python package index)."""
import dataclasses
import pathlib
import sys
import tomllib

STABLE = ("wrc.h", "wrc_methods.h", "wrc_status.h", "wrc_planar.h")  # frozen from 1.0 on
EXPERIMENTAL = ("wrc_damage.h", "wrc_offline.h", "wrc_profiles.h", "wrc_surface.h")    # may change in a minor version
HEADERS = tuple(f"wrc/{name}" for name in ("wrc.h", "wrc_planar.h") + EXPERIMENTAL)
TABLES = {"wrc_api": "wrc/wrc_api.h", "wrc_experimental_api": "wrc/wrc_experimental_api.h"}  # made of the others
HINTS = "tools/interface/members.toml"
STANDARD_HEADERS = {
    "stddef.h": "typedef unsigned long size_t;\n#define NULL ((void*)0)\n",
    "stdint.h": "typedef int int32_t;\ntypedef unsigned int uint32_t;\ntypedef unsigned long uint64_t;\n"
                "typedef long int64_t;\n",
    "string.h": "void* memset(void*, int, unsigned long);\n",
}


class Refused(Exception):
    """Something in a header that cannot be described: the text begins with file:line."""


@dataclasses.dataclass
class Place:
    """Where something is declared."""
    file: str
    line: int

    def refuse(self, why):
        raise Refused(f"{self.file}:{self.line}: {why}")


@dataclasses.dataclass
class Type:
    """A type as far as the interface uses types.

    base     int32_t, uint32_t, uint64_t, double, char, void, the name of a struct or handle, or "function"
    pointers levels of indirection;  const  something that is pointed to is;  extents  of an array in the struct
    spelling as C writes it
    """
    base: str
    pointers: int
    const: bool
    extents: tuple
    spelling: str


@dataclasses.dataclass
class Member:
    name: str
    type: Type
    offset: int
    size: int
    comment: str
    place: Place


@dataclasses.dataclass
class Struct:
    name: str
    size: int
    members: list
    comment: str
    place: Place


@dataclasses.dataclass
class Enumerator:
    name: str
    value: int
    comment: str


@dataclasses.dataclass
class Enumeration:
    name: str
    values: list
    comment: str


@dataclasses.dataclass
class Function:
    name: str
    returned: Type
    arguments: list  # of (name, Type)
    comment: str
    header: str
    exported: bool   # False: static inline


@dataclasses.dataclass
class Interface:
    numbers: list     # of (name, value): macros that are integers
    statuses: list    # of (name, value, text)
    presets: list     # of (published name, tangential method)
    resolutions: list # names
    frictions: list   # of (name, source, status)
    enumerations: dict
    structs: dict
    functions: dict
    callbacks: dict   # typedefs of function pointers, and what they stand for
    hints: dict       # {struct: {member: {key: text}}} of HINTS
    experimental: set # names that EXPERIMENTAL headers declare

    def enumerator(self, name):
        """(enumeration, enumerator) of that name, or None."""
        for enumeration in self.enumerations.values():
            for each in enumeration.values:
                if each.name == name:
                    return enumeration, each
        return None


def libclang():
    """The binding, from the running Python or from where Debian puts it."""
    try:
        import clang.cindex
    except ImportError:
        sys.path.append("/usr/lib/python3/dist-packages")
        try:
            import clang.cindex
        except ImportError:
            return None
    try:
        clang.cindex.Index.create()
    except clang.cindex.LibclangError:
        return None
    return clang.cindex


def parse(cindex, include):
    """The Interface of the headers in the folder `include`."""
    include = pathlib.Path(include).resolve()
    unit = translation_unit(cindex, include, HEADERS)
    for each in unit.diagnostics:
        if each.severity >= cindex.Diagnostic.Warning:
            raise Refused(str(each))
    found = _Reader(cindex, include).read(unit)
    with open(include.parent / HINTS, "rb") as file:
        found.hints = tomllib.load(file)
    for struct, members in found.hints.items():
        for member in members:
            if struct not in found.structs or member not in [each.name for each in found.structs[struct].members]:
                raise Refused(f"{HINTS}: there is no {struct}.{member}")
    return found


def table_order(cindex, include):
    """{table: names of its functions} of the tables for dlopen as they are, in their order; types may be out of date."""
    include = pathlib.Path(include).resolve()
    return {table: _members(cindex, include, table, header) for table, header in TABLES.items()}


def _members(cindex, include, table, header):
    if not (include / header).exists():
        return []
    for cursor in translation_unit(cindex, include, (header,)).cursor.get_children():
        if cursor.kind == cindex.CursorKind.STRUCT_DECL and cursor.spelling == table and cursor.is_definition():
            return [each.spelling for each in cursor.get_children() if each.kind == cindex.CursorKind.FIELD_DECL][2:]
    return []


def translation_unit(cindex, include, names):
    standard = str(include / "standard")
    main = str(include / "all_headers.c")
    files = [(f"{standard}/{name}", text) for name, text in STANDARD_HEADERS.items()]
    files.append((main, "".join(f'#include "{name}"\n' for name in names)))
    return cindex.Index.create().parse(
        main, ["-x", "c", "-std=c99", "--target=x86_64-linux-gnu", "-nostdinc", "-isystem", standard, "-I", str(include)],
        files, cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)


class _Reader:
    def __init__(self, cindex, include):
        self.kinds, self.types = cindex.CursorKind, cindex.TypeKind
        self.include = include

    def read(self, unit):
        found = Interface([], [], [], [], [], {}, {}, {}, {}, {}, set())
        for cursor in unit.cursor.get_children():
            file = cursor.location.file
            if file is None or not file.name.startswith(str(self.include / "wrc")):
                continue
            if pathlib.Path(file.name).name in EXPERIMENTAL:
                found.experimental.add(cursor.spelling)
            kind = cursor.kind
            if kind == self.kinds.MACRO_DEFINITION:
                self.macro(cursor, found)
            elif kind == self.kinds.ENUM_DECL and cursor.spelling != "wrc_status":
                found.enumerations[cursor.spelling] = Enumeration(
                    cursor.spelling, [Enumerator(e.spelling, e.enum_value, plain(e.raw_comment)) for e in cursor.get_children()],
                    plain(cursor.raw_comment))
            elif kind == self.kinds.STRUCT_DECL and cursor.is_definition():
                found.structs[cursor.spelling] = self.struct(cursor)
            elif kind == self.kinds.TYPEDEF_DECL:
                if self.is_callback(cursor.underlying_typedef_type):
                    found.callbacks[cursor.spelling] = cursor.underlying_typedef_type.spelling
            elif kind == self.kinds.FUNCTION_DECL:
                found.functions[cursor.spelling] = self.function(cursor)
        return found

    def place(self, cursor):
        name = pathlib.Path(cursor.location.file.name)
        return Place(str(name.relative_to(self.include.parent)), cursor.location.line)

    def macro(self, cursor, found):
        name, tokens = cursor.spelling, [token.spelling for token in cursor.get_tokens()][1:]
        number = "".join(tokens).strip("()")
        if name.startswith("WRC_") and number.removeprefix("-").isdigit():
            found.numbers.append((name, int(number)))
        elif name == "WRC_STATUS_LIST":
            for first, value, text in self.rows(tokens, 2):
                found.statuses.append((first, int(value), text.strip('"')))
        elif name == "WRC_PRESET_LIST":
            found.presets = [(row[1].strip('"'), row[2]) for row in self.rows(tokens, 7)]
        elif name == "WRC_RESOLUTION_LIST":
            found.resolutions = [row[1].strip('"') for row in self.rows(tokens, 6)]
        elif name == "WRC_FRICTION_LIST":  # the last two are strings, which may hold commas
            found.frictions = [(row[1].strip('"'), *row[12].strip('"').split('","')) for row in self.rows(tokens, 12)]

    @staticmethod
    def rows(tokens, commas):
        """Rows of a macro's list, X(a, b, ...): their parts."""
        tokens = tokens[tokens.index(")") + 1:]  # of its parameter
        while tokens:  # X ( a , b )
            end = tokens.index(")")
            yield "".join(tokens[2:end]).split(",", commas)
            tokens = tokens[end + 1:]

    def is_callback(self, kind):
        kind = kind.get_canonical()
        return kind.kind == self.types.POINTER and kind.get_pointee().get_canonical().kind == self.types.FUNCTIONPROTO

    def type(self, kind):
        spelling, extents, pointers, const = kind.spelling, [], 0, False
        while kind.kind == self.types.CONSTANTARRAY:
            extents.append(kind.element_count)
            kind = kind.element_type
        if self.is_callback(kind):
            return Type("function", 0, False, tuple(extents), spelling)
        while kind.kind in (self.types.POINTER, self.types.INCOMPLETEARRAY):
            kind = kind.get_pointee() if kind.kind == self.types.POINTER else kind.element_type
            pointers, const = pointers + 1, const or kind.is_const_qualified()
        base = kind.get_declaration().spelling or kind.spelling.replace("const ", "")
        return Type(base, pointers, const, tuple(extents), spelling)

    def struct(self, cursor):
        members = []
        for field in cursor.get_children():
            if field.kind == self.kinds.FIELD_DECL:
                members.append(Member(field.spelling, self.type(field.type), field.get_field_offsetof() // 8,
                                      field.type.get_size(), plain(field.raw_comment), self.place(field)))
        return Struct(cursor.spelling, cursor.type.get_size(), members, plain(cursor.raw_comment), self.place(cursor))

    def function(self, cursor):
        arguments = [(each.spelling, self.type(each.type)) for each in cursor.get_arguments()]
        name = pathlib.Path(cursor.location.file.name).name
        return Function(cursor.spelling, self.type(cursor.result_type), arguments, plain(cursor.raw_comment), name,
                        cursor.storage_class.name != "STATIC")


def plain(comment):
    """The text of a comment in one line, without its marks."""
    if comment is None:
        return ""
    for mark in ("/**<", "/**", "/*", "*/"):
        comment = comment.replace(mark, " ")
    lines = [line.strip() for line in comment.splitlines()]
    return " ".join(" ".join(line[1:] if line.startswith("*") else line for line in lines).split())
