#!/usr/bin/env python3
"""Figures of the house: how src is built and commented.

    figures.py [--check]        a table by module; --check fails where a limit is passed

Comments in bodies: lines that are only comment, in the bodies of functions, over the lines of these bodies that
are not blank. Functions: lines, parameters (lizard counts both). Includes: cycles, and arrows against the order of
modules. Words: comments that begin with "What" or "Of", and lines of comment with "what".
"""
import collections
import os
import re
import subprocess
import sys

import lizard

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
MOST_LINES, MOST_PARAMETERS, LEAST_COMMENTS = 90, 8, 8.0
COMMENTED = ("surface", "contact", "normal", "tangential", "halfspace")

# A module reads those before it. Those of one line do not read each other but as `ALLOWED` says.
ORDER = [["base"], ["kernels"], ["theory", "patch"], ["geometry"], ["normal", "tangential"], ["damage"], ["surface"],
         ["contact"], ["halfspace", "profiles"], ["abi"]]
STAGES = ["geometry", "pressure", "rolling", "wrench"]  # of surface, each reads those before it


def sources():
    names = subprocess.run(["git", "ls-files", "src"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return [name for name in names.split() if name.endswith((".cpp", ".hpp")) and "generated" not in name]


def module(name):
    return name.split("/")[1]


def comment_lines(lines):
    return sum(line.strip().startswith("//") for line in lines)


class Functions:
    """Functions by module, as lizard finds them."""

    def __init__(self, names):
        self.all = []
        for name in names:
            with open(os.path.join(ROOT, name)) as file:
                text = file.read().split("\n")
            for function in lizard.analyze_file(os.path.join(ROOT, name)).function_list:
                body = text[function.start_line - 1:function.end_line]
                opening = next((k for k, line in enumerate(body) if "{" in line), 0)
                body = [line for line in body[opening + 1:-1] if line.strip()]
                self.all.append((name, function, body))

    def share(self, of):
        lines = comments = 0
        for name, _, body in self.all:
            if of(name):
                lines += len(body)
                comments += comment_lines(body)
        return 100.0 * comments / max(lines, 1), comments, lines

    def too_long(self):
        return [(name, function.name, function.end_line - function.start_line + 1) for name, function, _ in self.all
                if function.end_line - function.start_line + 1 > MOST_LINES and "/simd/" not in name]

    def too_many_parameters(self):
        return [(name, function.name, function.parameter_count) for name, function, _ in self.all
                if function.parameter_count > MOST_PARAMETERS and "/simd/" not in name]


def includes(names):
    graph = collections.defaultdict(list)
    known = {name[len("src/"):] for name in names}
    for name in names:
        with open(os.path.join(ROOT, name)) as file:
            for target in re.findall(r'^#include "([^"]+)"', file.read(), re.M):
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


def words(names):
    counts = collections.Counter()
    for name in names:
        with open(os.path.join(ROOT, name)) as file:
            lines = file.read().split("\n")
        previous = False
        for line in lines:
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


def main():
    names = sources()
    functions = Functions(names)
    failed = []
    print(f"{'module':12} {'comments in bodies':>20}")
    for room in sorted({module(name) for name in names}):
        share, comments, lines = functions.share(lambda name: module(name) == room)
        print(f"{room:12} {share:8.1f} % {comments:5} of {lines}")
        if room in COMMENTED and share < LEAST_COMMENTS:
            failed.append(f"{room}: {share:.1f} % comments in bodies")
    print("\nfunctions:", len(functions.all))
    for name, function, lines in functions.too_long():
        failed.append(f"{name}: {function} has {lines} lines")
    for name, function, parameters in functions.too_many_parameters():
        failed.append(f"{name}: {function} has {parameters} parameters")
    graph = includes(names)
    for cycle in cycles(graph):
        failed.append("cycle: " + " -> ".join(cycle))
    for node, target in arrows_back(graph):
        failed.append(f"arrow back: {node} reads {target}")
    for what, count in sorted(words(names).items()):
        print(f"comments, {what}: {count}")
    print("\nbeyond the limits:", len(failed))
    for line in failed:
        print("  " + line)
    return 1 if failed and "--check" in sys.argv[1:] else 0


if __name__ == "__main__":
    sys.exit(main())
