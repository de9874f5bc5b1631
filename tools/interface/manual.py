"""The manual's tables: statuses, and what every member of every struct that is read may be."""
import cpp

BEGIN, END = "<!-- statuses: begin -->\n", "<!-- statuses: end -->\n"


def with_statuses(interface, page):
    """The page with its table of statuses renewed."""
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    lines = ["| value | status | meaning |", "|---:|---|---|"]
    lines += [f"| {value} | `{name}` | {text} |" for name, value, text in interface.statuses]
    return before + BEGIN + "\n".join(lines) + "\n" + END + after


def members(interface, described, mark):
    """docs/members.md"""
    lines = ["# Members of structs", "", f"<!-- {mark} -->", "",
             "What each member that is read may be, as the comments in the headers say it. Structs within structs have their own table;",
             "results are not listed. A range holds for each element of an array or of what a pointer points to.", ""]
    for name, told in described.items():
        rows = [row(each, interface, described) for each in told if each.role in ("input", "enumeration", "struct")]
        if not any(each.role in ("input", "enumeration") for each in told) and not is_read(name, told, described):
            continue
        lines += [f"## {name}", "", "| member | unit | range | default | |", "|---|---|---|---|---|"] + rows + [""]
    return "\n".join(lines)


def is_read(name, told, described):
    """Does a struct hold others that are read?"""
    inner = [described[each.member.type.base] for each in told if each.role == "struct"]
    return any(each.role in ("input", "enumeration") for one in inner for each in one)


def row(told, interface, described):
    kind = told.member.type
    name = told.member.name + "".join(f"[{extent}]" for extent in kind.extents)
    if told.role == "struct":
        return f"| `{name}` | | [{kind.base}](#{kind.base}) | | {cell(told.sentence)} |"
    if told.enumeration:
        allowed = ", ".join(f"`{each.name}`" for each in interface.enumerations[told.enumeration].values)
    else:
        allowed = ", ".join(("0 or " if each.or_zero else "") + f"{each.low} .. {cpp.highest(each, described)}" for each in told.ranges)
    if told.condition and not told.by_hand:
        state = {"NULL": " NULL", "0": " 0"}.get(told.state, "")
        allowed += f" with `{told.condition}{state}`" + (", 0 else" if told.zero_else else "")
    default = f"`{told.default}`" if told.enumeration or told.default == "NULL" else told.default
    return f"| `{name}` | {told.unit if told.unit != '-' else ''} | {allowed} | {default} | {cell(told.sentence)} |"


def cell(text):
    return text.replace("|", "\\|")
