"""The functions of the C++ header: members of contact_calls and model_calls, and free functions, over those of C."""
import fortran
import headers

BY_HAND = ("wrc_model_create", "wrc_contact_create", "wrc_model_init", "wrc_contact_init", "wrc_model_profile", "wrc_contact_field")
NUMBERS = {"int32_t": "std::int32_t", "uint32_t": "std::uint32_t", "uint64_t": "std::uint64_t", "double": "double"}


def written(interface, mark):
    """{path in the tree: text}"""
    of = {"wrc_contact": [], "wrc_model": [], "": []}
    for function in interface.functions.values():
        if wanted(function):
            of[owner(function)] += declared(function)
    lines = [f"/// {mark}", "/// wrc.hpp, which includes this file, says what it is.", "#pragma once", "", "// clang-format off",
             "namespace wrc {", ""] + own_defaults(interface) + of[""] + ["", "namespace detail {", ""]
    for name, handle in (("model_calls", "const wrc_model* handle_"), ("contact_calls", "wrc_contact* handle_")):
        lines += [f"/** Functions of a {name.split('_')[0]}. */", f"class {name} {{", " public:"]
        lines += [f"  {line}" if not line.startswith("#") else line for line in of["wrc_" + name.split("_")[0]]]
        lines += ["", " protected:", f"  {handle} = nullptr;", "};", ""]
    return {"bindings/cpp/wrc/wrc_calls.hpp": "\n".join(lines + ["}  // namespace detail", "", "}  // namespace wrc"]) + "\n"}


def wanted(function):
    """All that return a status, but for defaults and what wrc.hpp itself has."""
    return (function.exported and function.returned.base == "int32_t" and function.name not in BY_HAND
            and not function.name.endswith("_init"))


def owner(function):
    if not function.arguments:
        return ""
    type = function.arguments[0][1]
    return type.base if type.base in ("wrc_contact", "wrc_model") and type.pointers == 1 else ""


def own_defaults(interface):
    """defaults<Struct>() of the structs whose defaults are not all zero."""
    lines = []
    for struct in fortran.initialised(interface):
        lines += ["template <>", f"inline {struct.name} defaults() noexcept {{ return {struct.name}_default(); }}"]
    return lines + [""]


class Parameter:
    """One parameter in C++, what stands for it in the call of C, and whether nullptr means something."""

    def __init__(self, text, passed, out=None, in_out=False, optional=False):
        self.text, self.passed, self.out, self.in_out, self.optional = text, passed, out, in_out, optional


def parameters(function):
    arguments = function.arguments[1:] if owner(function) else function.arguments
    outs = [name for name, type in arguments if is_out(function, name, type)]
    found, i = [], 0
    while i < len(arguments):
        name, type = arguments[i]
        following = arguments[i + 1][0] if i + 1 < len(arguments) else ""
        if type.base == "wrc_contact" and type.pointers == 2 and following == "count":
            found.append(Parameter(f"span<wrc_contact* const> {name}",
                                   f"{name}.data(), static_cast<std::uint32_t>({name}.size())"))
            i += 1
        elif following.endswith("_stride"):
            const = "const " if type.const else ""
            found.append(Parameter(f"span<{const}{type.base}> {name}", f"{name}.data(), detail::stride({name})"))
            i += 1
        elif name == "statuses":
            found.append(Parameter("span<std::int32_t> statuses", "statuses.data()"))
        elif type.base == "char" and following == "size":
            found.append(Parameter(f"span<char> {name}", f"{name}.data(), {name}.size()"))
            i += 1
        elif type.base == "void" and following in ("bytes", "size"):
            found.append(Parameter(f"span<{'const ' if type.const else ''}std::byte> {name}", f"{name}.data(), {name}.size()"))
            i += 1
        elif is_out(function, name, type):
            in_out = f"@param[in,out] {name} " in function.comment
            spelled = NUMBERS.get(type.base, type.base)
            if len(outs) > 1 and fortran.optional(function, name):
                found.append(Parameter(f"{spelled}* {name}", name))
            else:
                found.append(Parameter(f"{spelled}& {name}", f"&{name}", spelled, in_out))
        elif type.base.startswith("wrc_") and type.pointers == 1 and type.const and not fortran.optional(function, name):
            found.append(Parameter(f"const {type.base}& {name}", f"&{name}"))
        else:
            found.append(Parameter(f"{plain(type)} {name}", name, optional=type.pointers > 0 and fortran.optional(function, name)))
        i += 1
    return found


def is_out(function, name, type):
    """One struct or number that is written."""
    return (type.pointers == 1 and not type.const and not fortran.is_array(function, name, type)
            and (type.base in NUMBERS or type.base.startswith("wrc_")))


def plain(type):
    if type.base == "function":
        return type.spelling
    return ("const " if type.const else "") + NUMBERS.get(type.base, type.base) + "*" * type.pointers


def declared(function):
    """The lines of one function."""
    of, name = owner(function), function.name[4:]
    if of and function.name.startswith(of + "_"):
        name = function.name[len(of) + 1:]
    given = parameters(function)
    const = " const" if of and function.arguments[0][1].const else ""
    inline = "" if of else "inline "
    every = ", ".join(each.text for each in given)
    passed = ", ".join((["handle_"] if of else []) + [each.passed for each in given])
    sized = [each for each in given if "detail::stride" in each.passed]
    guard = "".join(f"if (!detail::fits({each.text.split()[-1]}, contacts.size(), "
                    f"{'true' if 'span<const' in each.text else 'false'})) return WRC_ERROR_BUFFER; " for each in sized)
    if sized:
        guard += "if (statuses.size() != 0 && statuses.size() < contacts.size()) return WRC_ERROR_BUFFER; "
    changes = "; may change in a minor version" if function.header in headers.EXPERIMENTAL else ""
    lines = [f"/** {function.name}(){changes} */",
             f"{inline}status {name}({every}){const} noexcept {{ {guard}return {function.name}({passed}); }}"]
    outs = [each for each in given if each.out]
    if len(outs) != 1 or outs[0].in_out or given[-1] is not outs[0]:
        return lines
    return lines + answers(of, name, given, const, inline)


def answers(of, name, given, const, inline):
    """The two forms that return what is found: expected, and throwing."""
    out = given[-1].out
    last = max((i for i, each in enumerate(given[:-1]) if not each.optional), default=-1)
    inputs = ", ".join(each.text + (" = nullptr" if i > last else "") for i, each in enumerate(given[:-1]))
    arguments = "".join(each.text.split()[-1] + ", " for each in given[:-1])
    this = "this->" if of else ""
    if out.startswith("wrc_"):
        kind, tried = f"answer<{out}>", f"attempt_struct<{out}>("
    else:
        kind, tried = out, f"attempt<{out}>({out}(), "
    call = f"[&]({out}& found_) {{ return {this}{name}({arguments}found_); }}"
    contact = ", handle_" if of == "wrc_contact" else ""
    return [f"{inline}expected<{kind}> try_{name}({inputs}){const} noexcept {{ return detail::{tried}{call}); }}",
            "#ifdef WRC_EXCEPTIONS",
            f"{inline}{kind} {name}({inputs}){const} "
            f"{{ return detail::value_or_throw(try_{name}({arguments.removesuffix(', ')}){contact}); }}", "#endif"]
