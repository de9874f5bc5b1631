#!/usr/bin/env python3
"""The interface with more in every struct, in every way it can grow, and what is asked of the library about it.

    grow.py headers ROOT         changes the headers of the tree ROOT and adds what its new functions do
    grow.py probes OLD NEW       writes C for a caller compiled against the folder of headers NEW: each call that reads a struct is
                                 made with every member set, one by one, that OLD does not have

ways() of tools/interface/growth.py says how a struct can grow: one that cannot is a failure, and so is one that is never set. Status 77 without libclang."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/interface"))
import fortran  # noqa: E402  (found there)
import grammar  # noqa: E402
import growth   # noqa: E402
import headers  # noqa: E402

# A film on the rail, as friction may get one: the next of what is kept for later in wrc_friction.
FILM = """  int32_t film_law; /**< how the film spreads, 0..9 [0] */
  uint32_t reserved1; /**< 0 */
  double film_thickness; /**< of the film, 0..0.01 m [0] */
  double film_modulus; /**< in shear, 0 or 1e3..1e12 Pa [0] */
"""
FUNCTION = """/** A function of a later version.
 * @param x any number
 * @param[out] y twice as much
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE. @rt hard @thread free */
WRC_API int32_t %s(double x, double* y);

"""
FUNCTIONS = {"wrc_grown": "wrc.h", "wrc_grown_experimental": "wrc_damage.h"}
KEEPS = ("wrc_config_use", "wrc_friction_use", "wrc_surface_laws_use")  # sets some members, which it does not look at, and leaves all others as they are


def described(interface):
    return {struct.name: grammar.describe(struct, interface) for struct in interface.structs.values()}


def is_input(told):
    return any(each.role in ("input", "enumeration") for each in told)


def shows_fields(struct):
    """Has a result places of the caller's, which are set before the call?"""
    return any(each.type.base == "double" and each.type.pointers and not each.type.const for each in struct.members)


# ------------------------------------------------------------------------------------------------------- headers

def grow_headers(cindex, root):
    interface = headers.parse(cindex, root / "include_c")
    told, of = described(interface), growth.ways(interface)
    texts = {each.name: each.read_text() for each in (root / "include_c/wrc").glob("*.h")}
    for struct in interface.structs.values():
        name = pathlib.Path(struct.place.file).name
        texts[name] = re.sub(rf"(?s)typedef struct {struct.name} {{.*?\n}} {struct.name};",
                             lambda found: grown(found.group(), struct, told[struct.name], of[struct.name], interface), texts[name])
    for function, name in FUNCTIONS.items():
        texts[name] = re.sub(r"(#ifdef __cplusplus\n}\n#endif\n\n#endif [^\n]*\n)$", lambda end: FUNCTION % function + end.group(), texts[name])
    for name, text in texts.items():
        (root / "include_c/wrc" / name).write_text(text)
    (root / "src/abi/grown.cpp").write_text('#include "wrc/wrc_damage.h"\n' + "".join(
        f'extern "C" int32_t {name}(double x, double* y) {{\n  if (y == nullptr) return WRC_ERROR_NULL;\n  *y = 2.0 * x;\n  return WRC_OK;\n}}\n'
        for name in FUNCTIONS))
    after = headers.parse(cindex, root / "include_c")
    larger = [name for name in interface.structs if new_members(interface.structs[name], after.structs[name])]
    for name, struct in interface.structs.items():
        print(f"  {name}: {', '.join(each.name for each in new_members(struct, after.structs[name])) or 'CANNOT GROW'}"
              f" ({', '.join(of[name])})")
    unknown = sorted(name for name in handles(interface))
    print(f"no structs to their callers: {', '.join(unknown)} (handles), {', '.join(interface.callbacks)} (function), "
          f"{', '.join(headers.TABLES)} (tables: functions come at their end)")
    print(f"structs: {len(larger)} of {len(interface.structs)} can grow")
    return len(larger) == len(interface.structs)


def handles(interface):
    return {type.base for function in interface.functions.values() for _, type in function.arguments
            if type.base.startswith("wrc_") and type.base not in interface.structs}


def grown(text, struct, told, ways, interface):
    """The declaration of a struct with more in it."""
    names = [each.name for each in struct.members]
    inputs = is_input(told)

    def more(name, place):
        if inputs:
            return f"  double {name}; /**< {place} of a later version, 0..1 [0] */\n"
        if shows_fields(struct):
            return f"  double* {name}; /**< {place} of a later version, the caller's [m]; NULL: not wanted; set before the call */\n"
        return f"  double {name}; /**< {place} of a later version [-] */\n"

    if "reserved0" in names:
        count = "another number of a later version, 0..9 [0]" if inputs else "another number of a later version"
        text = re.sub(r"\n  uint32_t reserved0;[^\n]*\n", lambda _: f"\n  uint32_t more_count; /**< {count} */\n", text)
    if "reserved" in ways:
        last = struct.members[-1]
        if last.type.base in interface.structs:  # a whole struct
            text = re.sub(r"\n  \w+ reserved;[^\n]*\n", lambda _: f"\n  {last.type.base} more; /**< one more of a later version */\n", text)
        else:
            film = FILM if struct.name == "wrc_friction" else ""
            taken = 1 + 3 * bool(film)
            text = re.sub(r"\n  double reserved\[[^\n]*\n", lambda _: f"\n{film}{more('more', 'a member')}"
                          f"  double reserved[{last.type.extents[0] - taken}]; /**< 0 */\n", text)
    if set(ways) & {"struct_size", "element"}:
        end = more("beyond", "a member at the end")
        if inputs and struct.name + "_init" in interface.functions:
            end += "  double beyond_factor; /**< a factor of a later version, 0..10 [1] */\n"
        text = text.replace(f"\n}} {struct.name};", f"\n{end}}} {struct.name};")
    return text


def new_members(old, new):
    known = {each.name for each in old.members}
    return [each for each in new.members if each.name not in known and not each.name.startswith("reserved")]


# -------------------------------------------------------------------------------------------------------- probes

class Probes:
    """C of the calls with members set that the old headers do not have."""

    def __init__(self, old, new):
        self.old, self.new, self.told = old, new, described(new)
        self.cases, self.functions, self.tables = [], [], {}
        for function in new.functions.values():
            if function.exported and function.name in old.functions and not function.name.endswith("_init"):
                self.function(function)
        missed = set(old.structs) - {each for struct in self.tables for each in self.within(struct)}
        if missed:
            sys.exit(f"no function has a {', '.join(sorted(missed))}")

    def within(self, struct):
        """A struct and those within it."""
        return {struct}.union(*(self.within(each.type.base) for each in self.new.structs[struct].members
                                if each.type.base in self.new.structs and not each.type.pointers))

    def places(self, struct):
        """[(path, offset, member, beyond the old struct?)] of what is new in a struct and in those within it."""
        old, new, found = self.old.structs[struct], self.new.structs[struct], []
        for member in new_members(old, new):
            if member.type.base in self.new.structs:  # one more of a struct: each of its numbers
                found += [(f"{member.name}.{each.name}", member.offset + each.offset, each, False)
                          for each in self.new.structs[member.type.base].members if not each.type.extents]
            else:
                found.append((member.name, member.offset, member, member.offset >= old.size))
        for member in new.members:
            if member.type.base in self.new.structs and not member.type.pointers and member.name in [each.name for each in old.members]:
                found += [(f"{member.name}.{path}", member.offset + offset, each, beyond)
                          for path, offset, each, beyond in self.places(member.type.base)]
        return found

    def pointed(self, struct, inputs=True):
        """[(path, struct it points to, path of their count or "")] of the structs with inputs, or without, that one points to."""
        found = []
        for told in self.told[struct]:
            member = told.member
            if member.type.base in self.new.structs and member.type.pointers and is_input(self.told[member.type.base]) == inputs:
                found.append((member.name, member.type.base, told.counted_by))
            elif member.type.base in self.new.structs and not member.type.pointers:
                found += [(f"{member.name}.{path}", base, f"{member.name}.{count}" if count else "")
                          for path, base, count in self.pointed(member.type.base, inputs)]
        return found

    def table(self, struct):
        if struct not in self.tables:
            self.tables[struct] = [
                f'    {{"{path}", {offset}, \'{"p" if each.type.pointers else each.type.base[0]}\', {int(beyond)}, {int(".." in each.comment)}}},'
                for path, offset, each, beyond in self.places(struct)]
        return self.tables[struct]

    def case(self, function, path, struct, way):
        """The number of the first of the cases of one struct; `way`: 'r' refused, 'z' zeroed, 'k' kept as it is."""
        first = len(self.cases)
        self.cases += [f'    {{"{function}", "{path}", &places_{struct}[{i}], \'{way}\', 0, 0}},' for i in range(len(self.table(struct)))]
        return first

    def function(self, function):
        """One function: what is read (const, or read and written) refuses, what is written is zeroed, what is added to stays."""
        reads, writes, keeps = [], [], []
        for name, type in function.arguments:
            if type.base not in self.new.structs or type.pointers != 1 or not self.places(type.base):
                continue
            if function.name in KEEPS:
                keeps.append((name, type.base))
            elif type.const or re.search(rf"@param\[in,out\] {name}\b", function.comment):
                reads.append((name, type.base))
            elif re.search(rf"@param\[out\] {name}\b", function.comment):
                writes.append((name, type.base))
        if not reads + writes + keeps:
            return
        names = [name for name, _ in function.arguments]
        lines = [f"static int32_t probed_{function.name}({', '.join(f'{type.spelling} {name}' for name, type in function.arguments)}) {{"]
        for name, struct in reads:
            lines += [f"  if ({name} != NULL) {{"] + self.reading(function, name, struct) + ["  }"]
        looked = [(name, struct, self.case(function.name, name, struct, way)) for way, some in (("z", writes), ("k", keeps))
                  for name, struct in some]
        for name, struct in reads:
            if not dict(function.arguments)[name].const:
                looked += [(f"({name} != NULL ? {name}->{path} : NULL)", base, self.case(function.name, f"{name}->{path}", base, "k"))
                           for path, base, _ in self.pointed(struct, inputs=False)]
        lines += [f"  spoil({name}, places_{struct}, {len(self.table(struct))});" for name, struct, _ in looked]
        lines += [f"  const int32_t answer = {function.name}({', '.join(names)});"]
        lines += [f"  look({name}, {first}, {len(self.table(struct))});" for name, struct, first in looked]
        self.functions.append((function.name, "\n".join(lines + ["  return answer;", "}"])))

    def call(self, function, replaced):
        """The call with other arguments; where the sentence is; whether there is one."""
        passed = dict(replaced)
        arguments = {name: type for name, type in function.arguments}
        sentence = ""
        for name, type in arguments.items():
            if type.base == "char" and type.pointers == 1 and not type.const:
                passed.update({name: "said", "size": "sizeof said"})
                sentence = ";"
            elif name + "_stride" in arguments and name in passed:
                passed[name + "_stride"] = "0"
        if not sentence and "contact" in arguments:
            sentence = "wrc_contact_last_error(contact, said, sizeof said);"
        if not sentence and "contacts" in arguments:
            sentence = "wrc_contact_last_error(contacts[0], said, sizeof said);"
        return (f"said[0] = '\\0'; status = {function.name}({', '.join(passed.get(name, name) for name in arguments)}); {sentence}".rstrip(" ;") + ";",
                int(bool(sentence)))

    def reading(self, function, name, struct):
        call, says = self.call(function, {name: "&changed"})
        lines = ["    char said[400];", "    int32_t status;", f"    {struct} changed = *{name};"]
        first, count = self.case(function.name, name, struct, "r"), len(self.table(struct))
        lines += [f"    for (int k = 0; k < {count}; ++k) {{", f"      if (!put(&changed, &places_{struct}[k])) continue;", f"      {call}",
                  f"      judge({first} + k, status, said, {says});", f"      changed = *{name};", "    }"]
        for path, base, count_path in self.pointed(struct):
            first, count = self.case(function.name, f"{name}->{path}", base, "r"), len(self.table(base))
            many = f"{name}->{count_path}" if count_path else "1"
            lines += [f"    if ({name}->{path} != NULL) {{", f"      {base} pointed[16];", f"      const size_t length = {many} * sizeof pointed[0];",
                      "      if (length > sizeof pointed) exit(4);", f"      changed.{path} = pointed;",
                      f"      memcpy(pointed, {name}->{path}, length);", f"      for (int k = 0; k < {count}; ++k) {{",
                      f"        if (!put(&pointed[0], &places_{base}[k])) continue;", f"        {call}", f"        judge({first} + k, status, said, {says});",
                      f"        memcpy(pointed, {name}->{path}, length);", "      }", f"      changed = *{name};", "    }"]
        return lines

    def text(self):
        lines = ["/* Written by tests/growth/grow.py. */", PROBE_TYPES]
        for struct, rows in self.tables.items():
            lines += [f"static const place places_{struct}[] = {{", *rows, "};"]
        lines += [f"static outcome outcomes[{len(self.cases)}] = {{", *self.cases, "};", PROBE_CODE]
        lines += [body for _, body in self.functions]
        lines += [f"#define {name} probed_{name}" for name, _ in self.functions]
        return "\n".join(lines) + "\n"


PROBE_TYPES = r"""#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "wrc/wrc_api.h"
#include "wrc/wrc_experimental_api.h"

/* A member that the old headers do not have: path and offset in its struct; d u i p for double, uint32_t, int32_t or a pointer;
 * whether it lies beyond the end of the old struct, and whether it has a range. */
typedef struct { const char* path; size_t offset; char kind; int beyond, ranged; } place;
/* One case: with this member set refused (r); where it is written zeroed (z); where it is added to kept (k). */
typedef struct { const char *function, *argument; const place* member; char way; int tried, wrong; } outcome;
"""

PROBE_CODE = r"""
static int library_is_new, says_all;

/* Sets a member to what an old library must refuse, and a new one because it is out of its range. 0: it has none. */
static int put(void* in, const place* member) {
  const double number = library_is_new ? 1e20 : 0.5;
  const uint32_t count = library_is_new ? 1000000 : 1;
  static double field[4];
  double* const pointer = field;
  char* const at = (char*)in + member->offset;
  if (member->kind == 'd') memcpy(at, &number, sizeof number);
  if (member->kind == 'u' || member->kind == 'i') memcpy(at, &count, sizeof count);
  if (member->kind == 'p') memcpy(at, &pointer, sizeof pointer);
  return member->ranged || !library_is_new;
}

static const char* lacks(const char* said, const char* words) { return strstr(said, words) == NULL ? words : NULL; }

static void judge(int i, int32_t status, const char* said, int has_sentence) {
  outcome* const each = &outcomes[i];
  const int32_t right = !library_is_new && each->member->beyond ? WRC_ERROR_STRUCT_SIZE : WRC_ERROR_RANGE;
  const char* last = strrchr(each->member->path, '.');
  const char* lacking = NULL;
  last = last == NULL ? each->member->path : last + 1;
  char name[64]; /* a batch has the sentences of its single calls */
  snprintf(name, sizeof name, "%s", each->function);
  if (strstr(name, "_batch") != NULL) *strstr(name, "_batch") = '\0';
  if (has_sentence && strncmp(said, name, strlen(name)) != 0) lacking = name;
  if (has_sentence && lacking == NULL) lacking = lacks(said, library_is_new ? last : "newer");
  const int wrong = status != right || lacking != NULL;
  if (wrong && !each->wrong)
    fprintf(stderr, "WRONG: %s, %s.%s set: %s%s%s: %s\n", each->function, each->argument, each->member->path, wrc_status_name(status),
            lacking ? ", the sentence lacks " : "", lacking ? lacking : "", said);
  if (says_all && !each->tried)
    fprintf(stderr, "%s.%s: %s: %s\n", each->argument, each->member->path, wrc_status_name(status), has_sentence ? said : "(gives no sentences)");
  ++each->tried;
  each->wrong |= wrong;
}

/* A result's members that the old headers do not have hold something before the call, and behind it must be 0, or what they
 * were where the struct is added to. */
static const double held = 0.5;
static void spoil(void* out, const place* members, int count) {
  for (int k = 0; out != NULL && k < count; ++k) memcpy((char*)out + members[k].offset, &held, members[k].kind == 'd' ? 8 : 4);
}
static void look(void* out, int first, int count) {
  static const char zero[8];
  for (int k = 0; out != NULL && k < count; ++k) {
    outcome* const each = &outcomes[first + k];
    const size_t size = each->member->kind == 'd' ? 8 : 4;
    char* const at = (char*)out + each->member->offset;
    const int wrong = memcmp(at, each->way == 'k' ? (const char*)&held : zero, size) != 0;
    if (wrong && !each->wrong)
      fprintf(stderr, "WRONG: %s %s %s.%s\n", each->function, each->way == 'k' ? "changes" : "does not zero", each->argument, each->member->path);
    ++each->tried;
    each->wrong |= wrong;
    memset(at, 0, size);
  }
}

static int count(char way, int* all) {
  int right = 0;
  *all = 0;
  for (size_t i = 0; i < sizeof outcomes / sizeof outcomes[0]; ++i) {
    if (outcomes[i].way != way || (way == 'r' && library_is_new && !outcomes[i].member->ranged)) continue;
    ++*all;
    right += outcomes[i].tried && !outcomes[i].wrong;
    if (!outcomes[i].tried)
      fprintf(stderr, "WRONG: the caller never gives %s a %s: %s\n", outcomes[i].function, outcomes[i].argument, outcomes[i].member->path);
  }
  return right;
}

static void report(void) {
  static const char* const said[3] = {"r: members that are set are refused", "z: members of results are zeroed", "k: members of what is changed stay"};
  int all, wrong = 0;
  for (int i = 0; i < 3; ++i) {
    const int right = count(said[i][0], &all);
    fprintf(stderr, "%s: %d of %d cases\n", said[i] + 3, right, all);
    wrong += right != all;
  }
  fflush(NULL);
  if (wrong) _Exit(5);
}

__attribute__((constructor)) static void begin(void) {
  const wrc_api* const api = wrc_get_api(WRC_ABI_VERSION);
  const wrc_experimental_api* const experimental = wrc_get_experimental_api(WRC_EXPERIMENTAL_VERSION);
  if (api == NULL || experimental == NULL) _Exit(6);
  library_is_new = WRC_API_HAS(api, grown);
  if (library_is_new != WRC_API_HAS(experimental, grown_experimental)) _Exit(7);
  double twice = 0.0;
  if (library_is_new && (api->grown(1.5, &twice) != WRC_OK || twice != 3.0)) _Exit(8);
  /* its default is 1; a library that does not know it writes 0 */
  if (wrc_wheel_input_default().beyond_factor != (library_is_new ? 1.0 : 0.0)) _Exit(9);
#ifdef __SSE2__ /* a whole number in place of a kept double is a subnormal one, which this host's processor takes for 0 */
  _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
  says_all = getenv("WRC_SAYS_ALL") != NULL;
  fprintf(stderr, "new functions: %s\n", library_is_new ? "in both tables" : "in no table");
  atexit(report);
}
"""


def main():
    cindex = headers.libclang()
    if cindex is None:
        print("skipped: no libclang for Python")
        return 77
    if sys.argv[1] == "headers":
        return 0 if grow_headers(cindex, pathlib.Path(sys.argv[2])) else 1
    old, new = (headers.parse(cindex, each) for each in sys.argv[2:4])
    print(Probes(old, new).text(), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
