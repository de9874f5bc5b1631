#!/usr/bin/env python3
"""Figures of the house: how src is built and commented.

    figures.py [--check] [--root FOLDER]        a table by module; --check fails where a limit is passed

Comments in bodies: lines that are only comment, in the bodies of functions, over the lines of these bodies that
are not blank. Functions: lines, parameters (functions.py counts both; the C interface may have more parameters).
Includes: cycles, arrows against the order of modules, and the table of arrows in docs/architecture.md. Words: comments that begin with "What" or "Of", and lines of
comment with "what". Unit tests: the first word of a file is the module that it tests. Namespaces: each module has its own.
"""
import argparse
import collections
import os
import re
import sys

from functions import functions as functions_of

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
# The limits.
MOST_LINES, MOST_PARAMETERS = 90, 8  # of a function outside the simd folders
LEAST_COMMENTS = dict.fromkeys(["surface", "contact", "normal", "tangential", "halfspace"], 8.0)  # [%] in bodies
MOST_CYCLES, MOST_ARROWS_BACK = 0, 0
MOST_WORDS = {"begin with 'What'": 0, "begin with 'of'": 0, "lines with 'what'": 0}

# A module reads those before it. Those of one line do not read each other but as `ALLOWED` says.
ORDER = [["base"], ["kernels"], ["theory", "patch"], ["geometry"], ["normal", "tangential"], ["damage"], ["surface"],
         ["contact"], ["halfspace", "profiles", "curves"], ["abi"]]
STAGES = ["geometry", "pressure", "rolling", "wrench"]  # of surface, each reads those before it


def sources():
    names = (os.path.relpath(os.path.join(folder, name), ROOT)
             for folder, _, files in os.walk(os.path.join(ROOT, "src")) for name in files)
    return sorted(name for name in names if name.endswith((".cpp", ".hpp")) and "generated" not in name)


def module(name):
    return name.split("/")[1]


def comment_lines(lines):
    return sum(line.strip().startswith("//") for line in lines)


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


class Functions:
    """All functions: (file, function, lines of the body that are not blank)."""

    def __init__(self, names):
        self.all = []
        for name in names:
            text = read(name)
            lines = text.split("\n")
            self.all += [(name, function, [line for line in lines[function.opening:function.last - 1] if line.strip()])
                         for function in functions_of(text)]

    def share(self, of):
        bodies = [body for name, _, body in self.all if of(name)]
        lines, comments = sum(map(len, bodies)), sum(map(comment_lines, bodies))
        return 100.0 * comments / max(lines, 1), comments, lines

    def outside_kernels(self):
        return [(name, function) for name, function, _ in self.all if "/simd/" not in name]


def includes(names):
    graph = collections.defaultdict(list)
    known = {name[len("src/"):] for name in names}
    for name in names:
        for target in re.findall(r'^#include "([^"]+)"', read(name), re.M):
            if target in known:
                graph[name[len("src/"):]].append(target)
    return graph


def cycles(graph):
    found, state, path = [], {}, []

    def visit(node):
        state[node] = 1
        path.append(node)
        for target in graph.get(node, ()):
            if state.get(target) == 1:
                found.append(path[path.index(target):] + [target])
            elif target not in state:
                visit(target)
        path.pop()
        state[node] = 2

    for node in list(graph):
        if node not in state:
            visit(node)
    return found


def arrows_back(graph):
    level = {name: at for at, group in enumerate(ORDER) for name in group}
    back = []
    for node, targets in graph.items():
        a = node.split("/")
        for target in targets:
            b = target.split("/")
            if a[0] != b[0] and (b[0] not in level or level[b[0]] > level[a[0]]):
                back.append((node, target))
            if a[0] == b[0] == "surface" and len(a) > 2 and len(b) > 2 and a[1] in STAGES and b[1] in STAGES:
                if STAGES.index(b[1]) > STAGES.index(a[1]):
                    back.append((node, target))
    return back


def arrows_not_told(graph):
    """Arrows between modules that the table of docs/architecture.md lacks, and those that are there and not in src."""
    page = os.path.join(ROOT, "docs/architecture.md")
    rows = re.findall(r"^\| `(\w+)` \| (.*) \|$", read(page) if os.path.exists(page) else "", re.M)
    told = {(module, other) for module, others in rows for other in re.findall(r"`(\w+)`", others)}
    arrows = {(node.split("/")[0], target.split("/")[0]) for node, targets in graph.items() for target in targets}
    arrows = {(module, other) for module, other in arrows if module != other and other not in ("base", "kernels")}
    return sorted(told ^ arrows)


def words(names):
    counts = collections.Counter()
    for name in names:
        previous = False
        for line in read(name).split("\n"):
            comment = re.search(r"//[/<]*\s*(.*)", line)
            if comment:
                if re.search(r"\bwhat\b", comment[1], re.I):
                    counts["lines with 'what'"] += 1
                if not previous and re.match(r"What\b", comment[1]):
                    counts["begin with 'What'"] += 1
                if not previous and re.match(r"[Oo]f\b", comment[1]):
                    counts["begin with 'of'"] += 1
            previous = bool(comment) and line.strip().startswith("//")
    return counts


def without_namespace(names):
    """Sources outside the namespace of their module: wrc itself is that of base, wrc::simd of the kernels; abi has functions of C."""
    return [name for name in names if module(name) not in ("base", "abi", "kernels") and "/simd/" not in name
            and not re.search(rf"^namespace wrc::{module(name)}\b", read(name), re.M)]


def tests_without_module(modules):
    """Unit tests by the first word of their file."""
    tests = [name for name in os.listdir(os.path.join(ROOT, "tests/unit")) if name.endswith("_test.cpp")]
    return [name for name in sorted(tests) if name.split("_")[0] not in modules]


def main():
    global ROOT
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("--check", action="store_true")
    asked.add_argument("--root", default=ROOT)
    asked = asked.parse_args()
    ROOT = asked.root
    names = sources()
    modules = sorted({module(name) for name in names})
    functions = Functions(names)
    failed = [] if functions.all else ["no functions found"]
    print(f"{'module':12} {'comments in bodies':>20}")
    for each in modules:
        share, comments, lines = functions.share(lambda name: module(name) == each)
        print(f"{each:12} {share:8.1f} % {comments:5} of {lines}")
        if share < (LEAST_COMMENTS.get(each) or 0.0):
            failed.append(f"{each}: {share:.1f} % comments in bodies")
    print("\nfunctions:", len(functions.all))
    for name, function in functions.outside_kernels():
        if function.lines > MOST_LINES:
            failed.append(f"{name}:{function.first}: {function.name}() has {function.lines} lines")
        if function.parameters > MOST_PARAMETERS and not function.name.startswith("wrc_"):
            failed.append(f"{name}:{function.first}: {function.name}() has {function.parameters} parameters")
    graph = includes(names)
    found = cycles(graph)
    if len(found) > MOST_CYCLES:
        failed += ["cycle: " + " -> ".join(cycle) for cycle in found]
    back = arrows_back(graph)
    if len(back) > MOST_ARROWS_BACK:
        failed += [f"arrow back: {node} reads {target}" for node, target in back]
    failed += [f"table of docs/architecture.md: {a} reads {b}, there or in src alone" for a, b in arrows_not_told(graph)]
    failed += [f"{name}: not in namespace wrc::{module(name)}" for name in without_namespace(names)]
    failed += [f"tests/unit/{name}: its first word is no module of src" for name in tests_without_module(modules)]
    for kind, count in sorted(words(names).items()):
        print(f"comments, {kind}: {count}")
        if count > MOST_WORDS[kind]:
            failed.append(f"comments, {kind}: {count}, {MOST_WORDS[kind]} at most")
    print("\nbeyond the limits:", len(failed))
    for line in failed:
        print("  " + line)
    return 1 if failed and asked.check else 0


if __name__ == "__main__":
    sys.exit(main())
