"""The Fortran module of the interface: statuses, parameters, types, functions, initialisers, and a test of the layout."""
NUMBERS = {"uint32_t": "integer(c_int32_t)", "int32_t": "integer(c_int32_t)", "uint64_t": "integer(c_int64_t)",
           "double": "real(c_double)"}
HANDLES = ("wrc_model", "wrc_contact", "wrc_exact_transient")
# These get the suffix _c: wrc.f90 has the first two with Fortran strings, and the third is a parameter's name, too,
# to a language that knows no case.
SUFFIXED = ("wrc_config_check", "wrc_contact_last_error", "wrc_abi_version")
ARRAYS = ("gap", "statuses")  # arguments of that name are arrays of numbers, and see is_array()


def written(interface, mark):
    """{file name in bindings/fortran: text}"""
    return {"wrc_status.inc": statuses(interface, mark), "wrc_interface.inc": module(interface, mark),
            "wrc_optional.inc": with_optional(interface, mark), "wrc_initialisers.inc": initialisers(interface, mark), "layout_test.f90": layout_fortran(interface, mark),
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
            lines.append(f"  {kind} :: {member.name}{extent}")
        lines.append("end type")
    lines += ["", "interface"]
    for function in interface.functions.values():
        if not function.exported:
            continue
        fortran = function.name + "_c" if function.name in SUFFIXED else function.name
        names = ", ".join(name for name, _ in function.arguments)
        bound = f"bind(C, name='{function.name}')"
        returned = function.returned
        if returned.base == "void" and not returned.pointers:
            lines.append(f"  subroutine {fortran}({names}) {bound}")
        else:
            lines += [f"  function {fortran}({names}) &", f"      {bound} result(answer)"]
        lines.append("    import")
        lines += [f"    {dummy(function, name, type)}" for name, type in function.arguments]
        if returned.base == "void" and not returned.pointers:
            lines.append("  end subroutine")
        else:
            lines += [f"    {component(returned)[0]} :: answer", "  end function"]
    lines.append("end interface")
    lines += ["", "! Sets struct_size and the defaults of any wrc type. status: WRC_OK, or WRC_ERROR_STRUCT_SIZE if the library is older",
              "! than this module and knows the type by a smaller size; calls with it are refused then.", "interface wrc_init"]
    lines += [f"  module procedure init_{struct.name[4:]}" for struct in initialised(interface)]
    lines.append("end interface")
    return "\n".join(lines) + "\n"


def with_optional(interface, mark):
    """The functions once more under their names without wrc_, with what C may be given NULL for as optional arguments."""
    lines = ["! " + mark, "", "interface"]
    for function in interface.functions.values():
        if not function.exported or function.returned.base != "int32_t" or function.name.endswith("_init"):
            continue
        names = ", ".join(name for name, _ in function.arguments)
        lines += [f"  function {function.name[4:]}({names}) &", f"      bind(C, name='{function.name}') result(answer)", "    import"]
        for name, type in function.arguments:
            declared = dummy(function, name, type)
            if optional(function, name) and (type.base.startswith("wrc_") or type.base in NUMBERS or type.base == "char"):
                if declared.startswith("type(c_ptr), value"):
                    declared = f"type({type.base}), intent(in) :: {name}"
                declared = declared.replace(" ::", ", optional ::")
            lines.append(f"    {declared}")
        lines += ["    integer(c_int32_t) :: answer", "  end function"]
    return "\n".join(lines + ["end interface"]) + "\n"


def initialisers(interface, mark):
    lines = ["! " + mark, ""]
    for struct in initialised(interface):
        lines += [f"subroutine init_{struct.name[4:]}(this, status)", f"  type({struct.name}), intent(out) :: this",
                  "  integer(c_int32_t), intent(out), optional :: status", "  integer(c_int32_t) :: answer"]
        if struct.members[0].name == "struct_size":
            lines.append("  this%struct_size = int(c_sizeof(this), c_int32_t)")
        lines += [f"  answer = {struct.name}_init(this)", "  if (present(status)) status = answer", "end subroutine"]
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
    has_init = {struct.name for struct in initialised(interface)}
    for struct in interface.structs.values():
        lines += [f"  subroutine test_{struct.name}()", f"    type({struct.name}), target :: a"]
        if struct.name in has_init:
            lines.append("    call wrc_init(a)")
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
    lines = ["/* clang-format off */", f"/* {mark} See layout_test.f90. */", "#include <stddef.h>", "", '#include "wrc/wrc_offline.h"', ""]
    for struct in interface.structs.values():
        offsets = "".join(f", offsetof({struct.name}, {member.name})" for member in struct.members)
        lines += [f"extern const size_t layout_{struct.name}[];",
                  f"const size_t layout_{struct.name}[] = {{sizeof({struct.name}){offsets}}};"]
    return "\n".join(lines) + "\n"
