"""The grammar of a struct member's comment, which README.md tells in words: what a member is allowed to be.

    sizeof this struct, FIRST or more        struct_size; FIRST: bytes of the first published version
    0                                        a member kept for later
    see NAME                                 as the member NAME before it
    enum NAME ... [ENUMERATOR]               one of an enumeration
    ... RANGE UNIT ... [DEFAULT]
    ... [UNIT] ...                           not checked: a result

    RANGE      LOW..HIGH, 0 or LOW..HIGH, LOW..config.NAME; one for each element of an array, or one for all
    UNIT       one of UNITS; none: a pure number
    DEFAULT    a number, an enumerator, NULL, or "required" of a pointer
    `NAME` of them                           a pointer to as many numbers as the member NAME says

Where a member is read and likely causes of wrong values stand in members.toml.
"""
import dataclasses
import re

UNITS = ("m", "rad", "N", "Pa", "Pa/m", "m/s", "rad/s", "s/m", "1/m", "W", "N m", "m^2", "m^2/m", "m/m", "W/m^2", "W/m", "N/m",
         "kg/m^3", "W/(m K)", "J/(kg K)", "K", "degC", "mm^3/(km N)", "mm^3/km", "N/mm^2", "microgram/(m N)", "kg/J", "s",
         "J", "m^3", "s m", "kg", "kg/m^2", "J/m^2", "m^2/J", "J/kg", "J/(m^2 K)", "-")
NUMBER = r"-?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?"
RANGE = re.compile(rf"(?P<or_zero>0 or )?(?P<low>{NUMBER})\.\.(?P<high>{NUMBER}|config\.\w+(?:\.\w+)*)(?![\w.])")
BRACKET = re.compile(r"(?:^|(?<=\s))\[(?P<inside>[^\]]*)\]")
CAUSES = ("negative", "too_small", "too_large", "either", "otherwise")  # keys of members.toml; of "either" both ends


@dataclasses.dataclass
class Range:
    low: str
    high: str       # a number, or config.NAME: that member of the model says
    or_zero: bool


@dataclasses.dataclass
class Description:
    """One member, described."""
    member: object              # headers.Member
    role: str                   # "struct_size", "reserved", "enumeration", "input", "result"
    sentence: str = ""          # for people: the comment without what is told apart below
    first_size: int = 0
    ranges: tuple = ()          # none, one for all elements, or one for each
    unit: str = ""
    default: str = ""           # as in the comment
    enumeration: str = ""
    condition: str = ""         # an enumerator, or a member of the same struct
    state: str = ""             # of that member: "NULL", "0", or "" for not 0
    by_hand: bool = False       # the condition is more than one
    zero_else: bool = False
    counted_by: str = ""        # a member of the same struct
    hints: dict = dataclasses.field(default_factory=dict)

    @property
    def required(self):
        return self.default == "required"


def describe(struct, interface):
    """The Descriptions of a struct's members, in order; headers.Refused where one does not conform."""
    described = {}
    for member in struct.members:
        described[member.name] = _describe(member, described, interface)
        if not member.comment.startswith("see "):
            _add_hints(described[member.name], interface.hints.get(struct.name, {}).get(member.name, {}))
    for each in described.values():
        _check(each, described, interface)
    return list(described.values())


def _describe(member, before, interface):
    text = member.comment
    refuse = member.place.refuse
    name = f"the comment of {member.name}"
    if not text:
        refuse(f"{member.name} has no comment /**< ... */")
    if member.name == "struct_size":
        first = re.fullmatch(r"sizeof this struct, (\d+) or more", text)
        if not first:
            refuse(f"{name} must be: sizeof this struct, FIRST or more")
        return Description(member, "struct_size", text, first_size=int(first.group(1)))
    if text == "0":
        return Description(member, "reserved", text)
    if member.name.startswith("reserved") and not (member.type.base in interface.structs):
        refuse(f"{name} must be: 0")
    if text.startswith("see "):
        like = before.get(text[4:])
        if like is None:
            refuse(f"{name}: there is no member {text[4:]} before it")
        return dataclasses.replace(like, member=member, sentence=text)
    if member.type.base in interface.structs and not member.type.pointers:
        return Description(member, "struct", text)

    brackets = list(BRACKET.finditer(text))
    units = [each for each in brackets if each.group("inside") in UNITS]
    defaults = [each for each in brackets if each not in units]
    for each in defaults:
        inside = each.group("inside")
        if not (re.fullmatch(NUMBER, inside) or inside in ("NULL", "required") or interface.enumerator(inside)):
            refuse(f"{name}: [{inside}] is neither a unit (tools/interface/grammar.py lists them) nor a default")
    if len(defaults) > 1:
        refuse(f"{name} has two defaults")
    told = Description(member, "result", text)
    if defaults:
        told.role, told.default = "input", defaults[0].group("inside")
        if text[defaults[0].end():].strip():
            refuse(f"{name}: the default ends it; likely causes stand in members.toml")
        text = text[:defaults[0].start()].rstrip()
    found = _ranges(text, refuse, name)
    if found:
        told.ranges, told.unit, cut = found
        told.sentence = _without(text, cut)
        if units:
            refuse(f"{name} has a unit in brackets beside its range: write it behind the range")
    else:
        told.sentence = text
        if len(units) > 1 and not member.type.extents:
            refuse(f"{name} has two units")
        if len(units) == 1:
            told.unit = units[0].group("inside")
            told.sentence = _without(text, (units[0].start(), units[0].end()))
    counted = re.search(r"`(\w+)` of them", text)
    if counted:
        told.counted_by = counted.group(1)
    one_of = re.match(r"enum (\w+)", text)
    if one_of:
        if one_of.group(1) not in interface.enumerations:
            refuse(f"{name}: there is no enum {one_of.group(1)}")
        told.enumeration = one_of.group(1)
        told.role = "enumeration" if told.default else "result"
    return told


def _ranges(text, refuse, name):
    """(ranges, unit, part of the text), or None."""
    matches = list(RANGE.finditer(text))
    if not matches:
        return None
    for one, next_one in zip(matches, matches[1:]):
        if text[one.end():next_one.start()] != ", ":
            refuse(f"{name} has two ranges; those of an array's elements stand side by side: 0..1, 0..2 m")
    end = matches[-1].end()
    rest = text[end:]
    fitting = [unit for unit in UNITS if rest.startswith(" " + unit) and not re.match(r"[\w/^]", rest[len(unit) + 1:])]
    unit = max(fitting, key=len, default="")
    end += len(unit) + 1 if unit else 0
    if not re.match(r"$|[,;:.]| \(| with | of ", text[end:]):
        refuse(f"{name}: a unit or one of , ; : ( [ must follow the range, not '{text[end:].strip().split(' ')[0]}'")
    ranges = tuple(Range(each.group("low"), each.group("high"), bool(each.group("or_zero"))) for each in matches)
    return ranges, unit, (matches[0].start(), end)


def _add_hints(told, given):
    """What members.toml says of a member: where it is read, likely causes of wrong values."""
    refuse, name = told.member.place.refuse, told.member.name
    unknown = set(given) - set(CAUSES) - {"read_with", "zero_else", "by_hand"}
    if unknown:
        refuse(f"members.toml of {name}: {', '.join(sorted(unknown))} is no key")
    if given and told.role == "result":
        refuse(f"members.toml of {name}: a result is not checked")
    told.condition, _, told.state = given.get("read_with", "").partition(" ")
    told.zero_else, told.by_hand = given.get("zero_else", False), given.get("by_hand", False)
    told.hints = {key: given[key] for key in CAUSES if key in given}
    if "either" in told.hints:
        told.hints["too_small"] = told.hints["too_large"] = told.hints.pop("either")


def _without(text, cut):
    """The sentence without the part that is told apart."""
    before, after = text[:cut[0]].rstrip(" ,;:"), text[cut[1]:].strip()
    if not before:
        return after.lstrip(" ,;:")
    return before + (" " if after and after[0] not in ",;:.)" else "") + after


def _check(told, described, interface):
    """What a member is must fit its type and the members beside it."""
    member, refuse = told.member, told.member.place.refuse
    kind = member.type
    number = kind.base == "double" and not kind.pointers
    if told.role == "result" and number and not told.unit and not kind.extents:
        refuse(f"{member.name} has neither a range nor a unit in brackets ([-] for a pure number)")
    if told.ranges and not told.default:
        refuse(f"{member.name} has a range and no default in brackets")
    if number and told.role == "input" and not told.ranges:
        refuse(f"{member.name} has a default and no range")
    if told.ranges and len(told.ranges) not in (1, (kind.extents or (1,))[0]):
        refuse(f"{member.name} has {len(told.ranges)} ranges for {(kind.extents or (1,))[0]} elements")
    if (told.required or told.default == "NULL") and not kind.pointers and kind.base != "function":
        refuse(f"{member.name} is no pointer")
    if told.default and kind.pointers and told.default not in ("required", "NULL"):
        refuse(f"{member.name} is a pointer: its default is NULL or required")
    if kind.extents and told.default not in ("", "0"):
        refuse(f"{member.name} is an array: its default is 0")
    if told.enumeration and told.default:
        found = interface.enumerator(told.default)
        if not found or found[0].name != told.enumeration:
            refuse(f"{member.name}: its default is none of enum {told.enumeration}")
    if told.condition and told.condition not in described and not interface.enumerator(told.condition):
        refuse(f"{member.name}: there is no {told.condition}")
    if told.zero_else and not asked(told, described.values(), interface):
        refuse(f"{member.name}: no member of this struct says {told.condition}")
    if told.counted_by and (told.counted_by not in described or described[told.counted_by].member.type.base != "uint32_t"):
        refuse(f"{member.name}: there is no uint32_t {told.counted_by} that counts")
    for each in told.ranges:
        if not each.high.startswith("config.") and not float(each.low) < float(each.high):
            refuse(f"{member.name}: {each.low}..{each.high} is empty")
        if told.default and not (told.required or kind.pointers or told.condition or each.high.startswith("config.")):
            value = float(told.default)
            inside = float(each.low) <= value <= float(each.high) or (each.or_zero and value == 0)
            if not inside and value != 0:  # 0: must be set
                refuse(f"{member.name}: its default {told.default} is outside its range")


def asked(told, described, interface):
    """The member of the same struct whose value says whether this one is read; None: not in this struct."""
    for each in described:
        if each.member.name == told.condition:
            return each
    enumeration = interface.enumerator(told.condition)[0].name
    return next((each for each in described if each.enumeration == enumeration and each.role == "enumeration"), None)
