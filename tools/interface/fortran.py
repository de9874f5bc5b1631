"""The Fortran module of the interface: statuses, parameters, types, functions, initialisers, and a test of the layout."""
NUMBERS = {"uint32_t": "integer(c_int32_t)", "int32_t": "integer(c_int32_t)", "uint64_t": "integer(c_int64_t)",
           "double": "real(c_double)"}
HANDLES = ("wrc_model", "wrc_contact", "wrc_exact_transient", "wrc_rail_faces", "wrc_section_file")
# These get the suffix _c: wrc.f90 has them with Fortran strings, and the last is a parameter's name, too, to a language
# that knows no case.
SUFFIXED = ("wrc_config_check", "wrc_model_create", "wrc_contact_create", "wrc_contact_last_error", "wrc_abi_version")
ARRAYS = ("gap", "statuses")  # arguments of that name are arrays of numbers, and see is_array()


def written(interface, mark):
    """{file name in bindings/fortran: text}"""
    return {"wrc_status.inc": statuses(interface, mark), "wrc_interface.inc": module(interface, mark),
            "wrc_pointers.inc": with_null(interface, dummy, mark), "wrc_optional.inc": with_null(interface, optional_dummy, mark),
            "wrc_initialisers.inc": initialisers(interface, mark), "layout_test.f90": layout_fortran(interface, mark),
            "layout_test.c": layout_c(interface, mark)}


def initialised(interface):
    """Structs that have an init function."""
    return [each for each in interface.structs.values() if each.name + "_init" in interface.functions]


def component(type):
    """(Fortran type, extent) of a member."""
    # The last index of C is the first of Fortran.
    extent = f"({', '.join(str(each) for each in reversed(type.extents))})" if type.extents else ""
    if type.pointers:
        return "type(c_ptr)", extent
    if type.base == "function":
        return "type(c_funptr)", extent
    return NUMBERS.get(type.base) or f"type({type.base})", extent


def at_first(struct, member):
    """What a member is before anything is assigned, as of {sizeof s} in C: its struct's size, or nothing."""
    if member.name == "struct_size":
        return f" = {struct.size}"
    kind = component(member.type)[0]
    if kind in ("type(c_ptr)", "type(c_funptr)"):
        return f" = c_null_{kind[7:-1]}"
    return " = 0" if member.type.base in NUMBERS else ""  # a struct's own members have theirs


def parameter_text(comment, name):
    """What a comment says about the parameter `name`."""
    for piece in comment.split("@"):
        command, _, told = piece.partition(" ")
        if command.split("[")[0] == "param" and told.split(" ")[0] == name:
            return told
    return ""


def optional(function, name):
    """Does NULL mean something else than a mistake?"""
    return any(not meaning.startswith("WRC_ERROR")
               for meaning in (piece.strip() for piece in parameter_text(function.comment, name).split("NULL:")[1:]))


def is_array(function, name, type):
    """Is a pointer to numbers one to several? What is only read is, and what is written where a count is given or told."""
    counted = (any(other == "count" for other, _ in function.arguments)
               or any(word in parameter_text(function.comment, name) for word in (" of them", "count", "nx * ny")))
    return type.base in NUMBERS and type.pointers == 1 and (type.const or counted or name in ARRAYS)


def dummy(function, name, type):
    """The Fortran declaration of one argument."""
    if type.base in HANDLES and type.pointers == 2:
        # wrc_contact* const* is an array of handles, wrc_contact** a handle to be written.
        return f"type(c_ptr), intent(in) :: {name}(*)" if type.const else f"type(c_ptr), intent(out) :: {name}"
    if type.base in HANDLES or type.base == "void":
        return f"type(c_ptr), value :: {name}"
    if type.base == "function":
        return f"type(c_funptr), value :: {name}"
    if type.base == "char":
        return f"character(kind=c_char), intent({'in' if type.const else 'out'}) :: {name}(*)"
    if type.base in NUMBERS:
        if not type.pointers:
            return f"{NUMBERS[type.base]}, value :: {name}"
        extent = "(*)" if is_array(function, name, type) else ""
        return f"{NUMBERS[type.base]}, intent({'in' if type.const else 'out'}) :: {name}{extent}"
    if not type.pointers:
        return f"type({type.base}), value :: {name}"
    if type.const:
        return f"type(c_ptr), value :: {name}" if optional(function, name) else f"type({type.base}), intent(in) :: {name}"
    return f"type({type.base}), intent(inout) :: {name}"


def optional_dummy(function, name, type):
    """The same, optional where C may be given NULL for it."""
    declared = dummy(function, name, type)
    if not may_be_absent(function, name, type):
        return declared
    if declared.startswith("type(c_ptr), value"):
        declared = f"type({type.base}), intent(in) :: {name}"
    return declared.replace(" ::", ", optional ::")


def may_be_absent(function, name, type):
    """What a Fortran argument may stand for that C may be given NULL for."""
    return optional(function, name) and (type.base.startswith("wrc_") or type.base in NUMBERS or type.base == "char")


def takes_null(function):
    """Is it declared twice, in module wrc and in module wrc_optional?"""
    return function.name not in SUFFIXED and any(may_be_absent(function, name, type) for name, type in function.arguments)


def procedure(function, name, of):
    """The interface body of a function under this name; of: dummy() or optional_dummy()."""
    names = ", ".join(each for each, _ in function.arguments)
    bound = f"bind(C, name='{function.name}')"
    returned = function.returned
    nothing = returned.base == "void" and not returned.pointers
    lines = [f"  subroutine {name}({names}) {bound}"] if nothing else [f"  function {name}({names}) &", f"      {bound} result(answer)"]
    lines.append("    import")
    lines += [f"    {of(function, each, type)}" for each, type in function.arguments]
    return lines + (["  end subroutine"] if nothing else [f"    {component(returned)[0]} :: answer", "  end function"])


def statuses(interface, mark):
    lines = ["! " + mark]
    for name, value, meaning in interface.statuses:
        lines += [f"! {meaning}", f"integer(c_int32_t), parameter :: {name} = {value}_c_int32_t"]
    return "\n".join(lines) + "\n"


def module(interface, mark):
    lines = ["! " + mark, ""]
    lines += [f"integer(c_int32_t), parameter :: {name} = {value}" for name, value in interface.numbers]
    for enumeration in interface.enumerations.values():
        lines += [f"integer(c_int32_t), parameter :: {each.name} = {each.value}" for each in enumeration.values]
    for struct in interface.structs.values():
        lines += ["", f"type, bind(C) :: {struct.name}"]
        for member in struct.members:
            kind, extent = component(member.type)
            lines.append(f"  {kind} :: {member.name}{extent}{at_first(struct, member)}")
        lines.append("end type")
    lines += ["", "interface"]
    for function in interface.functions.values():
        if function.exported and not takes_null(function):
            lines += procedure(function, function.name + "_c" if function.name in SUFFIXED else function.name, dummy)
    lines.append("end interface")
    lines += ["", "! The library's defaults, of any type. status: that of the init function in C, where there is one.", "interface wrc_init"]
    lines += [f"  module procedure init_{struct.name[4:]}" for struct in interface.structs.values()]
    lines.append("end interface")
    return "\n".join(lines) + "\n"


def with_null(interface, of, mark):
    """The functions that C may be given NULL for an argument of, by pointers (dummy) or optional arguments (optional_dummy)."""
    lines = ["! " + mark, "", "interface"]
    for function in interface.functions.values():
        if function.exported and takes_null(function):
            lines += procedure(function, function.name, of)
    return "\n".join(lines + ["end interface"]) + "\n"


def initialisers(interface, mark):
    lines = ["! " + mark, ""]
    with_defaults = initialised(interface)
    for struct in interface.structs.values():
        lines += [f"subroutine init_{struct.name[4:]}(this, status)", f"  type({struct.name}), intent(out) :: this",
                  "  integer(c_int32_t), intent(out), optional :: status"]
        if struct in with_defaults:
            lines += ["  integer(c_int32_t) :: answer", f"  answer = {struct.name}_init(this)",
                      "  if (present(status)) status = answer", "end subroutine"]
        else:
            lines += [f"  this = {struct.name}()", "  if (present(status)) status = WRC_OK", "end subroutine"]
    return "\n".join(lines) + "\n"


def layout_fortran(interface, mark):
    """Sizes and offsets of every type, against those of the C compiler."""
    lines = ["! " + mark, "module layout", "  use, intrinsic :: iso_c_binding", "  implicit none"]
    for struct in interface.structs.values():
        lines.append(f"  integer(c_size_t), bind(C) :: layout_{struct.name}({len(struct.members) + 1})")
    lines += ["end module", "program layout_test", "  use wrc", "  use layout", "  implicit none",
              "  integer :: failures = 0"]
    lines += [f"  call test_{struct.name}()" for struct in interface.structs.values()]
    lines += [f"  print '(i0,a)', {len(interface.structs)}, ' types compared'", "  if (failures > 0) stop 1", "contains"]
    for struct in interface.structs.values():
        lines += [f"  subroutine test_{struct.name}()", f"    type({struct.name}), target :: a"]
        if struct.members[0].name == "struct_size":
            lines.append(f"    call same('{struct.name}', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))")
            lines.append("    a%struct_size = 0  ! of a variable that was used before")
        lines += ["    call wrc_init(a)"]
        if struct.members[0].name == "struct_size":
            lines.append(f"    call same('{struct.name}', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))")
        lines.append(f"    call same('{struct.name}', 'size', c_sizeof(a), layout_{struct.name}(1))")
        for i, member in enumerate(struct.members):
            lines += [f"    call same('{struct.name}', '{member.name}', &",
                      f"      distance(c_loc(a), c_loc(a%{member.name})), layout_{struct.name}({i + 2}))"]
        lines.append("  end subroutine")
    lines += ["  function distance(from, to) result(bytes)", "    type(c_ptr), intent(in) :: from, to",
              "    integer(c_size_t) :: bytes",
              "    bytes = transfer(to, bytes) - transfer(from, bytes)", "  end function",
              "  subroutine same(struct, member, here, there)", "    character(*), intent(in) :: struct, member",
              "    integer(c_size_t), intent(in) :: here, there", "    if (here == there) return",
              "    print '(4a,i0,a,i0)', struct, '%', member, ': Fortran ', here, ', C ', there",
              "    failures = failures + 1", "  end subroutine", "end program"]
    return "\n".join(lines) + "\n"


def layout_c(interface, mark):
    lines = ["/* clang-format off */", f"/* {mark} See layout_test.f90. */", "#include <stddef.h>", "", '#include "wrc/wrc_offline.h"', '#include "wrc/wrc_profiles.h"', ""]
    for struct in interface.structs.values():
        offsets = "".join(f", offsetof({struct.name}, {member.name})" for member in struct.members)
        lines += [f"extern const size_t layout_{struct.name}[];",
                  f"const size_t layout_{struct.name}[] = {{sizeof({struct.name}){offsets}}};"]
    return "\n".join(lines) + "\n"
