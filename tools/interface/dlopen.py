"""The table of functions for hosts that load the library at run time, and the list of exported functions for Windows."""
NOT_IN_TABLE = ("wrc_get_api", "wrc_abi_version")  # the table's own beginning says what these do


def written(interface, order, mark):
    """{path in the tree: text}. `order`: names of the present table's members; new functions come behind them."""
    functions = {name[4:]: each for name, each in interface.functions.items()
                 if each.exported and name not in NOT_IN_TABLE}
    members = [name for name in order if name in functions] + [name for name in functions if name not in order]
    exports = "".join(f"  {name}\n" for name, each in interface.functions.items() if each.exported)
    return {"include_c/wrc/wrc_api.h": header(functions, members, mark),
            "src/abi/generated/api_functions.inc": f"// {mark}\n// clang-format off\n" + "".join(f"wrc_{name},\n" for name in members),
            "src/abi/generated/wrc.def": f"; {mark}\nLIBRARY wrc\nEXPORTS\n{exports}"}


def header(functions, members, mark):
    lines = ["/** @file wrc_api.h", " * Every function of wrc.h and wrc_offline.h as a table, so that one dlsym(\"wrc_get_api\") suffices.",
             f" * {mark}", " */", "#ifndef WRC_API_H", "#define WRC_API_H", "", '#include "wrc_offline.h"', "",
             "/** The functions, each under its name without wrc_. struct_size grows with the library: a table at least as large as the",
             " * sizeof(wrc_api) you compiled with has every member you know. */", "struct wrc_api {",
             "  uint32_t struct_size; /**< sizeof this struct */", "  uint32_t abi_version; /**< WRC_ABI_VERSION of the library */"]
    for name in members:
        declared, told = f"  {pointer(name, functions[name])};", f"/**< wrc_{name}() */"
        lines += [f"{declared} {told}"] if len(declared) + len(told) < 120 else [declared, f"    {told}"]
    return "\n".join(lines + ["};", "", "#endif /* WRC_API_H */"]) + "\n"


def pointer(name, function):
    """int32_t (*model_size)(const wrc_config*, uint64_t*, uint64_t*)"""
    arguments = ", ".join(spelled(type) for _, type in function.arguments) or "void"
    return f"{spelled(function.returned)} (*{name})({arguments})"


def spelled(type):
    return type.spelling.replace(" *", "*").replace("*const", "* const")
