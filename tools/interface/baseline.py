"""The interface as it was last agreed on, as lists of macros that tests/abi/gate holds today's headers and library against."""
import re
import textwrap

import growth

FILE, CALLER = "tests/abi/gate/baseline.h", "tests/abi/gate/caller_x86_64.s"
# Numbers that say how much of something this version has.
COUNTS = ("WRC_WRENCH_INPUTS", "WRC_DAMAGE_SUMS")


def text(interface, described, order, because):
    """Members that are kept for later are not in it: others may come in their place. Places of those behind, and the size of a
    struct that grows in no other way, hold what they take."""
    stable, experimental = [], []
    of = growth.ways(interface)

    def add(name, *lines):
        (experimental if name in interface.experimental else stable).extend(lines)

    for name, value in interface.numbers:
        if not name.startswith("WRC_VERSION_") and name != "WRC_EXPERIMENTAL_VERSION":
            add(name, f"{'COUNT' if name in COUNTS else 'NUMBER'}({name}, {value})")
    for name, value, _ in interface.statuses:
        add(name, f"NUMBER({name}, {value})")
    for enumeration in interface.enumerations.values():
        add(enumeration.name, *(f"NUMBER({each.name}, {each.value})" for each in enumeration.values))
    for name, spelling in interface.callbacks.items():
        add(name, f"CALLBACK({name}, {spelling})")
    for struct in interface.structs.values():
        grows = of[struct.name] != ("reserved",)
        add(struct.name, f"{'GROWING' if grows else 'FIXED'}({struct.name}, {struct.size})")
        if "struct_size" in of[struct.name] and struct.name + "_init" in interface.functions:
            add(struct.name + "_init", f"INITIALISED({struct.name}, {described[struct.name][0].first_size}, {struct.size})")
        add(struct.name, *(f"MEMBER({struct.name}, {each.name}, {each.offset}, {each.type.spelling})"
                           for each in struct.members if not each.name.startswith("reserved")))
    for function in interface.functions.values():
        if function.exported:
            arguments = ", ".join(type.spelling for _, type in function.arguments) or "void"
            add(function.name, f"FUNCTION({function.returned.spelling}, {function.name}, ({arguments}))")
    for table, names in order.items():
        lines = [f"IN_TABLE({table}, {name}, {8 + 8 * i})" for i, name in enumerate(names)]
        (experimental if table == "wrc_experimental_api" else stable).extend(lines)
    version = dict(interface.numbers)["WRC_EXPERIMENTAL_VERSION"]
    head = ["/* clang-format off */", "/* The interface that today's is held against; tests/abi/gate/baseline.c reads it. Renewed by",
            "     tools/interface/describe.py --renew-baseline \"what changed, in a sentence for CHANGELOG.md\"",
            f"   BECAUSE: {because} */"]
    return "\n".join(head + stable + [f"#if WRC_EXPERIMENTAL_VERSION == {version}"] + experimental + ["#endif"]) + "\n"


def with_line(changelog, because):
    """CHANGELOG.md with the sentence as the first of the newest version's changes, unless it is there."""
    if because in " ".join(changelog.split()):
        return changelog
    line = textwrap.fill(f"- {because}", 118, subsequent_indent="  ")
    return re.sub(r"(### Changed[^\n]*\n\n)", lambda heading: f"{heading[1]}{line}\n", changelog, count=1)
