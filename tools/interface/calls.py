"""What the comment of an exported function must say, for a reader who knows nothing else of it.

    @param    each of its parameters, by name
    @return   with a status: WRC_ERROR_NULL where there are pointers, _STRUCT_SIZE where one is to a struct that begins with its
              size and not else, _RANGE and _NOT_FINITE where a number is passed; or "as wrc_x()"
    @rt       hard, "hard, long" or init; one that is hard returns no WRC_ERROR_MEMORY
    @thread   free or contact

Defaults, wrc_x_init(), have the comment of their group.
"""
import re

from headers import Refused


def check(interface):
    sized = {struct.name for struct in interface.structs.values() if struct.members[0].name == "struct_size"}
    for function in interface.functions.values():
        is_default = len(function.arguments) == 1 and function.name == f"{function.arguments[0][1].base}_init"
        if function.exported and not is_default:
            for missing in lacks(function, sized):
                raise Refused(f"{function.header}: the comment of {function.name}() lacks {missing}")


def lacks(function, sized):
    """What is missing."""
    comment = function.comment
    for name, _ in function.arguments:
        if not re.search(rf"@param(\[[a-z,]+\])? {name}\b", comment):
            yield f"@param {name}"
    real_time = re.search(r"@rt (hard(, long)?|init)\b", comment)
    if not real_time:
        yield "@rt hard or @rt init"
    if not re.search(r"@thread (free|contact)\b", comment):
        yield "@thread free or @thread contact"
    if function.returned.base == "void" and not function.returned.pointers:
        return
    returned = comment.partition("@return")[2]
    if not returned:
        yield "@return"
    elif function.returned.base == "int32_t" and not re.search(r"\bas wrc_\w+|gravest", returned):
        yield from lacks_statuses(function, returned, real_time, sized)


def lacks_statuses(function, returned, real_time, sized):
    types = [type for _, type in function.arguments]
    has_size = any(type.pointers == 1 and type.base in sized for type in types)
    if any(type.pointers for type in types) and "_NULL" not in returned:
        yield "WRC_ERROR_NULL"
    if has_size != ("_STRUCT_SIZE" in returned):
        yield "WRC_ERROR_STRUCT_SIZE" if has_size else "a struct that begins with its size, for WRC_ERROR_STRUCT_SIZE"
    for status in ("_RANGE", "_NOT_FINITE"):
        if status not in returned and any(type.base == "double" and not type.pointers for type in types):
            yield f"WRC_ERROR{status}"
    if "_MEMORY" in returned and real_time and real_time.group(1) != "init":
        yield "@rt init, for WRC_ERROR_MEMORY"
