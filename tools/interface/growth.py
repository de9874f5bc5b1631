"""How each struct of the interface can grow while programs compiled before go on. tests/growth shows that every one does.

    struct_size  it begins with its size: members come at its end
    element      a member of another struct is its size, for arrays of it, FIRST bytes or more: members come at its end
    reserved     its last member is kept for later: members come in its place
"""
import re


def ways(interface):
    """{struct: how it can grow}"""
    elements = first_sizes(interface)
    return {struct.name: tuple(way for way, is_one in (("struct_size", struct.members[0].name == "struct_size"),
                                                       ("element", struct.name in elements),
                                                       ("reserved", struct.members[-1].name == "reserved")) if is_one)
            for struct in interface.structs.values()}


def first_sizes(interface):
    """{struct: bytes of it as first published} of those whose size a member of another struct is: "sizeof(wrc_x), 168..4096"."""
    return {found.group(1): int(found.group(2)) for struct in interface.structs.values() for member in struct.members
            if (found := re.match(r"sizeof\((\w+)\).*?\b(\d+)\.\.", member.comment))}


def check(interface):
    """No struct that grows at its end lies within another, and none has bytes that are no member's: what is kept for later must
    be 0, and only members are looked at."""
    of = ways(interface)
    for struct in interface.structs.values():
        end = 0
        for member in struct.members:
            if member.offset != end:
                member.place.refuse(f"{struct.name} has {member.offset - end} bytes of padding before {member.name}: give them a name")
            end = member.offset + member.size
            if not member.type.pointers and "struct_size" in of.get(member.type.base, ()):
                member.place.refuse(f"{struct.name}.{member.name}: {member.type.base} begins with struct_size and grows at its end")
        if end != struct.size:
            struct.place.refuse(f"{struct.name} has {struct.size - end} bytes of padding at its end: give them a name")
