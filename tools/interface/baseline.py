"""The interface as it was last agreed on, as lists of macros that tests/abi/gate holds today's headers and library against."""
import re
import textwrap

FILE, CALLER = "tests/abi/gate/baseline.h", "tests/abi/gate/caller_x86_64.s"


def text(interface, described, order, because):
    lines = ["/* clang-format off */", "/* The interface that today's is held against; tests/abi/gate/baseline.c reads it. Renewed by",
             "     tools/interface/describe.py --renew-baseline \"what changed, in a sentence for CHANGELOG.md\"",
             f"   BECAUSE: {because} */"]
    lines += [f"NUMBER({name}, {value})" for name, value in interface.numbers if not name.startswith("WRC_VERSION_")]
    lines += [f"NUMBER({name}, {value})" for name, value, _ in interface.statuses]
    for enumeration in interface.enumerations.values():
        lines += [f"NUMBER({each.name}, {each.value})" for each in enumeration.values]
    for name, spelling in interface.callbacks.items():
        lines.append(f"CALLBACK({name}, {spelling})")
    for struct in interface.structs.values():
        told = described[struct.name][0]
        if told.role == "struct_size":
            lines.append(f"GROWING({struct.name}, {told.first_size}, {struct.size})")
            if struct.name + "_init" in interface.functions:
                lines.append(f"INITIALISED({struct.name}, {told.first_size}, {struct.size})")
        else:
            lines.append(f"FIXED({struct.name}, {struct.size})")
        lines += [f"MEMBER({struct.name}, {each.name}, {each.offset}, {each.type.spelling})" for each in struct.members]
    for function in interface.functions.values():
        if function.exported:
            arguments = ", ".join(type.spelling for _, type in function.arguments) or "void"
            lines.append(f"FUNCTION({function.returned.spelling}, {function.name}, ({arguments}))")
    lines += [f"IN_TABLE({name}, {8 + 8 * i})" for i, name in enumerate(order)]
    return "\n".join(lines) + "\n"


def with_line(changelog, because):
    """CHANGELOG.md with the sentence as the first of the newest version's changes, unless it is there."""
    if because in " ".join(changelog.split()):
        return changelog
    line = textwrap.fill(f"- {because}", 118, subsequent_indent="  ")
    return re.sub(r"### Changed\n\n", lambda _: f"### Changed\n\n{line}\n", changelog, count=1)
