#!/usr/bin/env python3
"""The library as one source file beside its headers, for those who build it with their own compiler.

    amalgamate.py OUT [SOURCES]     writes OUT/wrc.cpp and OUT/wrc/*.h:    c++ -O2 -c OUT/wrc.cpp

Headers come where they are first included, once; then the units. Names in a unit's unnamed namespace that another unit has, too,
get the unit's name behind them. Kernels are compiled once, for whatever the compiler's flags allow."""
import collections
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES, HEADERS = ROOT / "src", ROOT / "include_c/wrc"
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|\w+|\s+|.', re.S)
HEAD = """\
// wrc {version}, one source file: made by tools/amalgamate from commit {commit}. Do not edit.
//
//   c++ -O2 -c wrc.cpp          beside the folder wrc, which has its headers
//
// C++17; gcc 8, clang 10 or newer. The same bits as every other build. Kernels are compiled for what the compiler's flags allow,
// -mavx2 or -march=native makes them faster; the code is then for such processors alone.
#if defined(__FAST_MATH__)
#error "-ffast-math changes results: compile wrc without it"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "excess precision changes results: compile wrc for SSE2, for example with -msse2 -mfpmath=sse"
#endif
// Products and sums are not fused, whatever the flags; but for -ffp-contract=fast of clang, which disregards this.
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-math-errno", "no-tree-slp-vectorize")
#endif
#ifndef WRC_STATIC
#define WRC_STATIC
#endif
#define WRC_BASELINE_ALONE
#define WRC_SET baseline
#define WRC_COMMIT "{commit}"
#ifndef WRC_FLAGS
#define WRC_FLAGS "of wrc.cpp"
#endif
"""


def units():
    """In the order of the modules, for the reader."""
    return sorted(SOURCES.rglob("*.cpp"))


def local_names(text):
    """Names declared in the unnamed namespaces of a unit: (names)."""
    names = set()
    tokens = [token for token in TOKEN.findall(text) if not token.isspace() and not token.startswith(("//", "/*"))]
    i = 0
    while i < len(tokens) - 1:
        if tokens[i] == "namespace" and tokens[i + 1] == "{":
            i = read_block(tokens, i + 2, names)
        else:
            i += 1
    return names


def read_block(tokens, i, names):
    """Declarations from i to the end of the namespace; returns where that is."""
    while tokens[i] != "}":
        name, angle, last, kind = None, 0, None, None
        # up to the end of one declaration: ; or the } of a body
        while True:
            token = tokens[i]
            if token == "#":  # a directive is no declaration
                pass
            if token in ("struct", "class", "enum", "union", "using") and kind is None and angle == 0:
                kind = token
            if token == "template":
                i = skip(tokens, i + 1, "<", ">")
                continue
            if name is None and token == "<":
                i = skip(tokens, i, "<", ">")
                continue
            if name is None and token == "[" and tokens[i + 1] == "[":
                i = skip(tokens, i, "[", "]")
                continue
            if kind == "using" and token == ";" and name is None:  # a using-declaration
                name = "operator"
            if token == "static_assert":
                name = "operator"
            if name is None and ends_name(tokens, i, kind) and last and re.fullmatch(r"[A-Za-z_]\w*", last):
                of_class = tokens[i - 2] == ":" and tokens[i - 3] == ":"
                name = "operator" if of_class or last in ("operator", "noexcept") else last
            if token in ("(", "["):
                i = skip(tokens, i, token, {"(": ")", "[": "]"}[token])
                last = ")"
                continue
            if token == "{":
                i = skip(tokens, i, "{", "}")
                if tokens[i] == ";":
                    i += 1
                elif tokens[i] in ("(", ",") or tokens[i] == "{":
                    continue
                break
            if token == ";":
                i += 1
                break
            last = token
            i += 1
        if name and name != "operator":
            names.add(name)
    return i + 1


def ends_name(tokens, i, kind):
    """Does the declared name stand before this token?"""
    if tokens[i] == ":":  # of a base or an underlying type
        return kind in ("struct", "class", "enum") and tokens[i + 1] != ":" and tokens[i - 1] != ":"
    return tokens[i] in ("(", "=", "{", ";", "[")


def skip(tokens, i, opening, closing):
    """Behind the bracket that closes the one at i."""
    depth = 0
    while True:
        depth += (tokens[i] == opening) - (tokens[i] == closing)
        i += 1
        if depth == 0:
            return i


def renamed(text, names, suffix):
    """The unit with these identifiers renamed; members and names of classes stay."""
    modules = {path.name for path in SOURCES.iterdir()}
    out, before = [], ["", "", ""]
    for token in TOKEN.findall(text):
        qualified = before[1:] == [":", ":"] and before[0] not in modules
        member = before[2] == "." or before[1:] == ["-", ">"]
        if token in names and not qualified and not member:
            token += suffix
        if not token.isspace():
            before = before[1:] + [token]
        out.append(token)
    return "".join(out)


class Amalgam:
    def __init__(self):
        self.out, self.seen = [], set()

    def add(self, path, text=None):
        """A file, with what it includes before it."""
        text = path.read_text() if text is None else text
        self.out.append(f"// ---- {path.relative_to(SOURCES)}\n")
        for line in text.splitlines():
            ours = re.match(r'#include "([^"]+)"', line)
            if line.startswith("#pragma once"):
                continue
            if ours and (SOURCES / ours[1]).exists():
                if ours[1].endswith(".inc"):  # lists, wherever they are asked for
                    self.add(SOURCES / ours[1])
                elif ours[1] not in self.seen:
                    self.seen.add(ours[1])
                    self.add(SOURCES / ours[1])
            else:
                self.out.append(line + "\n")


def amalgam():
    texts = {path: path.read_text() for path in units()}
    count = collections.Counter(name for text in texts.values() for name in local_names(text))
    made = Amalgam()
    # headers first: a unit's renamed names are in no header
    for text in texts.values():
        for name in re.findall(r'^#include "([^"]+)"', text, re.M):
            if (SOURCES / name).exists() and name not in made.seen and not name.endswith(".inc"):
                made.seen.add(name)
                made.add(SOURCES / name)
    for path, text in texts.items():
        shared = {name for name in local_names(text) if count[name] > 1}
        stem = "_".join(path.relative_to(SOURCES).with_suffix("").parts)
        made.add(path, renamed(text, shared, f"_of_{stem}"))
        for macro in sorted(set(re.findall(r"^#define (\w+)", text, re.M))):
            made.out.append(f"#undef {macro}\n")
    return "".join(made.out)


def source():
    """wrc.cpp as text."""
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True, check=False).stdout.strip()
    version = re.search(r"project\(wrc VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    return HEAD.format(version=version, commit=commit or "unknown") + amalgam()


def main():
    global SOURCES
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    if len(sys.argv) == 3:
        SOURCES = pathlib.Path(sys.argv[2])
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    shutil.copytree(HEADERS, out / "wrc", dirs_exist_ok=True)
    (out / "wrc.cpp").write_text(source())


if __name__ == "__main__":
    main()
