"""The tables of functions for hosts that load the library at run time, and the list of exported functions for Windows."""
import headers

# The beginning of a table says what these do, or they give the tables.
NOT_IN_TABLE = ("wrc_get_api", "wrc_get_experimental_api", "wrc_abi_version")
VERSIONS = {"wrc_api": ("WRC_ABI_VERSION", "abi_version"), "wrc_experimental_api": ("WRC_EXPERIMENTAL_VERSION", "experimental_version")}
INCLUDES = {"wrc_api": ("wrc_planar.h",), "wrc_experimental_api": ("wrc_offline.h", "wrc_profiles.h", "wrc_surface.h")}


def written(interface, order, mark):
    """{path in the tree: text}. `order`: names of the present tables' members; new functions come behind them."""
    made = {}
    for table, present in order.items():
        functions = {name[4:]: each for name, each in interface.functions.items()
                     if each.exported and name not in NOT_IN_TABLE
                     and (each.header in headers.EXPERIMENTAL) == (table == "wrc_experimental_api")}
        members = [name for name in present if name in functions] + [name for name in functions if name not in present]
        made[f"include_c/{headers.TABLES[table]}"] = header(table, functions, members, mark)
        made[f"src/abi/generated/{table[4:]}_functions.inc"] = f"// {mark}\n// clang-format off\n" + "".join(f"wrc_{name},\n" for name in members)
    exports = "".join(f"  {name}\n" for name, each in interface.functions.items() if each.exported)
    numbers = dict(interface.numbers)
    dll = f"wrc-{numbers['WRC_VERSION_MAJOR']}.{numbers['WRC_VERSION_MINOR']}.dll"
    made["src/abi/generated/wrc.def"] = f'; {mark}\nLIBRARY "{dll}"\nEXPORTS\n{exports}'
    return made


def header(table, functions, members, mark):
    number, member = VERSIONS[table]
    of = "wrc.h and wrc_planar.h" if table == "wrc_api" else "wrc_damage.h, wrc_offline.h, wrc_profiles.h and wrc_surface.h"
    lines = [f"/** @file {table}.h", f" * Every function of {of} as a table, for hosts that load the library at run time: wrc_get_{table[4:]}().",
             f" * {mark}", " */", f"#ifndef {table.upper()}_H", f"#define {table.upper()}_H", ""]
    lines += [f'#include "{name}"' for name in INCLUDES[table]] + [""]
    if table == "wrc_api":
        lines += ["/** Has a table this function? Of a library that is older than the header it may lack the last ones. */",
                  "#define WRC_API_HAS(api, function)                                                              \\",
                  "  ((size_t)((const char*)&(api)->function - (const char*)(api)) + sizeof (api)->function <= (api)->struct_size)", ""]
    lines += ["/** The functions, each under its name without wrc_. New ones are added at the end alone. */" if table == "wrc_api" else
              "/** The functions, each under its name without wrc_. */", f"struct {table} {{",
              "  uint32_t struct_size; /**< sizeof this struct, of the library */", f"  uint32_t {member}; /**< {number} of the library */"]
    for name in members:
        declared, told = f"  {pointer(name, functions[name])};", f"/**< wrc_{name}() */"
        lines += [f"{declared} {told}"] if len(declared) + len(told) < 120 else [declared, f"    {told}"]
    return "\n".join(lines + ["};", "", f"#endif /* {table.upper()}_H */"]) + "\n"


def pointer(name, function):
    """int32_t (*model_size)(const wrc_config*, uint64_t*, uint64_t*)"""
    arguments = ", ".join(spelled(type) for _, type in function.arguments) or "void"
    return f"{spelled(function.returned)} (*{name})({arguments})"


def spelled(type):
    return type.spelling.replace(" *", "*").replace("*const", "* const")
