#!/usr/bin/env python3
"""Writes everything that is made of the C headers, or says what of it is out of date.

    tools/interface/describe.py            writes the files
    tools/interface/describe.py --check    names those that differ; exits with 1 if any does, 77 without libclang
    tools/interface/describe.py --renew-baseline SENTENCE
                                           writes the files and the interface that tests/abi/gate holds today's against;
                                           the sentence goes into CHANGELOG.md
    --root FOLDER                          another tree than the one this program lies in

Building the library does not need this program: what it writes is committed."""
import argparse
import pathlib
import subprocess
import sys

import baseline
import calls
import cpp
import cpp_header
import dlopen
import fortran
import grammar
import growth
import headers
import manual
import python
import python_types

MARK = "Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit."


def files(interface, table_order, root):
    """{path in the tree: text}"""
    growth.check(interface)
    calls.check(interface)
    described = {struct.name: grammar.describe(struct, interface)
                 for struct in interface.structs.values()}
    made = cpp.written(interface, described, MARK) | dlopen.written(interface, table_order, MARK)
    made |= {f"bindings/fortran/{name}": text for name, text in fortran.written(interface, MARK).items()}
    made |= cpp_header.written(interface, MARK) | python.written(interface, described, MARK)
    made |= python_types.written(interface, described, MARK)
    made["docs/members.md"] = manual.members(interface, described, MARK)
    made["docs/embedding.md"] = manual.with_statuses(interface, (root / "docs/embedding.md").read_text())
    return made


def renew_baseline(cindex, root, because):
    """The baseline, the caller compiled against today's headers, the sentence in the changelog."""
    include = root / "include_c"
    interface = headers.parse(cindex, include)
    described = {struct.name: grammar.describe(struct, interface) for struct in interface.structs.values()}
    because = " ".join(because.split())
    (root / baseline.FILE).write_text(
        baseline.text(interface, described, headers.table_order(cindex, include), because))
    changelog = root / "CHANGELOG.md"
    changelog.write_text(baseline.with_line(changelog.read_text(), because))
    subprocess.run(["cc", "-std=c99", "-O1", "-fPIC", "-S", "-fno-asynchronous-unwind-tables", "-Iinclude_c",
                    "tests/abi/gate/caller.c", "-o", baseline.CALLER], cwd=root, check=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--check", action="store_true")
    arguments.add_argument("--renew-baseline", metavar="SENTENCE")
    arguments.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    asked = arguments.parse_args()
    cindex = headers.libclang()
    if cindex is None:
        print("skipped: no libclang for Python (Debian: python3-clang-14): whether generated files are current is not known")
        return 77
    try:
        include = asked.root / "include_c"
        made = files(headers.parse(cindex, include), headers.table_order(cindex, include), asked.root)
    except headers.Refused as why:
        print(why)
        return 1
    stale = [name for name, text in made.items()
             if not (asked.root / name).exists() or (asked.root / name).read_text() != text]
    for name in stale:
        if asked.check:
            print(f"{name} is out of date: run tools/interface/describe.py")
        else:
            (asked.root / name).parent.mkdir(parents=True, exist_ok=True)
            (asked.root / name).write_text(made[name])
            print(f"{name} written")
    if asked.check and stale:
        return 1
    if asked.renew_baseline:
        renew_baseline(cindex, asked.root, asked.renew_baseline)
    print(f"{len(made)} files current")
    return 0


if __name__ == "__main__":
    sys.exit(main())
