"""The library's own tables: what each member of each struct may be, the init functions."""
import dataclasses
import os
import re

import grammar
import growth

TYPES = {"int32_t": "int32", "uint32_t": "uint32", "uint64_t": "uint64", "double": "real"}


def written(interface, described, mark):
    """{path in the tree: text}"""
    return {"src/abi/generated/members.hpp": members(interface, described, mark),
            "src/abi/generated/init_functions.inc": init_functions(interface, described, mark)}


def members(interface, described, mark):
    lines = [f"/// {mark}", "/// What every member of every struct may be, and what it is by default.", "#pragma once", "",
             "// clang-format off", '#include "abi/member.hpp"', '#include "wrc/wrc_offline.h"', '#include "wrc/wrc_profiles.h"', '#include "wrc/wrc_surface.h"', "",
             "namespace wrc::abi {", "", "namespace enumerations {", ""]
    for each in interface.enumerations.values():
        lines += [f"inline constexpr Enumerator {each.name}_values[] = {{"]
        lines += [f'    {{"{value.name}", {value.name}}},' for value in each.values]
        lines += ["};", f"inline constexpr Enumeration {each.name}{{{each.name}_values, {len(each.values)},",
                  f"    {text(names(each))}}};", ""]
    lines += ["}  // namespace enumerations", ""]
    for struct, told in described.items():
        lines += description(struct, told, interface, described)
    return "\n".join(lines + ["}  // namespace wrc::abi"]) + "\n"


def names(enumeration):
    """see enum wrc_side: WRC_SIDE_RIGHT (0), _LEFT (1)"""
    full = [value.name for value in enumeration.values]
    shared = len(os.path.commonprefix(full).rpartition("_")[0]) if len(full) > 1 else 0
    shown = [full[0]] + [name[shared:] for name in full[1:]]
    return f"see enum {enumeration.name}: " + ", ".join(f"{name} ({value.value})" for name, value in zip(shown, enumeration.values))


def text(words):
    return '"' + words.replace("\\", "\\\\").replace('"', '\\"') + '"' if words else "nullptr"


def description(struct, told, interface, described):
    versioned = told[0].role == "struct_size"
    first = told[0].first_size if versioned else growth.first_sizes(interface).get(struct, interface.structs[struct].size)
    rows = flat(told, "", described)
    lines = ["template <>", f"struct Description<{struct}> {{", f'  static constexpr const char* name = "{struct}";',
             f"  static constexpr bool versioned = {'true' if versioned else 'false'};",
             f"  static constexpr std::size_t first = first_size<{struct}>({first});",
             f"  static constexpr {struct} defaults = [] {{", f"    {struct} value{{}};"]
    for each in told:
        value = default(each, interface)
        if value:
            lines.append(f"    value.{each.member.name} = {value};")
    lines += ["    return value;", "  }();", "  static constexpr Member members[] = {"]
    lines += [f"      {row(struct, path, each, rows, interface, described)}," for path, each in rows]
    lines += ["  };", "};", f"static_assert(!pointers_of_64_bits || sizeof({struct}) == {interface.structs[struct].size}, "
              '"run tools/interface/describe.py");', ""]
    return lines


def lowest(one, told):
    """The lower end of a range; of a member that holds the size of a struct, that struct's first size."""
    struct = re.match(r"sizeof\((\w+)\)", told.sentence)
    return f"first_size<{struct.group(1)}>({one.low})" if struct else one.low


def default(told, interface):
    """The C++ expression of a default that is not zero; none for zero."""
    if told.role == "struct_size":
        return "sizeof value"
    if told.role == "struct":
        return f"Description<{told.member.type.base}>::defaults"
    if told.default in ("", "NULL", "required") or told.role == "result":
        return ""
    if told.enumeration:
        return told.default if interface.enumerator(told.default)[1].value != 0 else ""
    return told.default if float(told.default) != 0.0 else ""


def flat(told, prefix, described):
    """(path, description) of every member, those of structs within included."""
    rows = []
    for each in told:
        path = prefix + each.member.name
        if each.role == "struct":
            rows += flat(described[each.member.type.base], path + ".", described)
        elif len(each.ranges) > 1:
            rows += [(f"{path}[{i}]", one_of(each, i)) for i in range(len(each.ranges))]
        else:
            rows.append((path, each))
    return rows


def one_of(told, i):
    """The description of one element of an array."""
    member = dataclasses.replace(told.member, type=dataclasses.replace(told.member.type, extents=()))
    return dataclasses.replace(told, member=member, ranges=(told.ranges[i],))


def highest(each, described):
    """The upper end of a range; config.NAME: the most that this may be."""
    if not each.high.startswith("config."):
        return each.high
    name = each.high[len("config."):]
    return next(told.ranges[0].high for path, told in flat(described["wrc_config"], "", described)
                if path == name)


def row(struct, path, told, rows, interface, described):
    """One Member, by its fields' names."""
    kind = told.member.type
    fields = [("name", f'"{path}"'), ("offset", f"offsetof({struct}, {path})"),
              ("type", "Type::" + ("pointer" if kind.pointers or kind.base == "function" else TYPES[kind.base]))]
    elements = 1
    for extent in kind.extents:
        elements *= extent
    if elements > 1:
        fields.append(("elements", str(elements)))
    rule = {"reserved": "zero", "enumeration": "one_of"}.get(told.role, "none")
    if told.ranges:
        rule = "range"
    fields.append(("rule", f"Rule::{rule}"))
    if told.required:
        fields.append(("required", "true"))
    here = path.rpartition(".")[0]
    beside = [each for other, each in rows if other.rpartition(".")[0] == here]
    if told.ranges:
        one = told.ranges[0]
        fields += [("low", lowest(one, told)), ("high", highest(one, described))]
        if one.or_zero:
            fields.append(("or_zero", "true"))
    unit = "" if told.unit == "-" else told.unit
    if unit:
        fields.append(("unit", text(unit)))
    for name in ("negative", "too_small", "too_large"):
        if name in told.hints:
            fields.append((name, text(told.hints[name])))
    asked = grammar.asked(told, beside, interface) if told.condition and not told.by_hand else None
    if told.required and asked and asked.enumeration:
        fields.append(("not_set", text(f"{told.condition} needs it")))
    if told.ranges and told.default == "0" and not kind.pointers and float(told.ranges[0].low) > 0 and not told.ranges[0].or_zero:
        needs = f"{told.condition} needs it, and its default is 0" if told.condition else "its default is 0"
        fields.append(("not_set", text(f"was it set? {needs}")))
    if told.enumeration:
        fields.append(("enumeration", f"&enumerations::{told.enumeration}"))
    if asked:
        prefix = here + "." if here else ""
        fields.append(("asked", f"offsetof({struct}, {prefix}{asked.member.name})"))
        if asked.member.name != told.condition:
            fields.append(("asked_for", told.condition))
        else:
            fields.append(("state", "State::" + {"NULL": "null", "0": "zero", "": "not_zero"}[told.state]))
        if told.zero_else:
            why, only = told.hints.get("otherwise"), f"it is read with {told.condition} only: leave it 0"
            chosen = asked.member.name != told.condition  # by an enumerator, which the hint need not name
            fields.append(("otherwise", text(f"{why}; {only}" if why and chosen else why or only)))
    if told.counted_by:
        prefix = here + "." if here else ""
        fields.append(("counted_by", f"offsetof({struct}, {prefix}{told.counted_by})"))
    if told.ranges and ((told.condition and not asked) or (kind.pointers and not told.counted_by)):
        fields.append(("by_caller", "true"))
    return "{" + ", ".join(f".{name} = {value}" for name, value in fields) + "}"


def init_functions(interface, described, mark):
    lines = [f"// {mark}", "// clang-format off"]
    for struct in described:
        function = interface.functions.get(struct + "_init")
        if function and function.exported:
            argument = function.arguments[0][0]
            lines.append(f"int32_t {struct}_init({struct}* {argument}) {{ return init({argument}); }}")
    return "\n".join(lines) + "\n"
