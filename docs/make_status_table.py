#!/usr/bin/env python3
"""Writes the table of statuses into docs/embedding.md from the registry in wrc_status.h.

    docs/make_status_table.py           renews the table
    docs/make_status_table.py --check   exits with 1 if it is out of date
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADER = ROOT / "include_c/wrc/wrc_status.h"
PAGE = ROOT / "docs/embedding.md"
BEGIN, END = "<!-- statuses: begin -->\n", "<!-- statuses: end -->\n"


def table():
    rows = re.findall(r'X\((WRC_\w+),\s*(-?\d+),\s*"([^"]*)"\)', HEADER.read_text())
    if not rows:
        sys.exit(f"{HEADER.name}: no X(name, value, text) rows found")
    lines = ["| value | status | meaning |", "|---:|---|---|"]
    lines += [f"| {value} | `{name}` | {text} |" for name, value, text in rows]
    return "\n".join(lines) + "\n"


def main():
    page = PAGE.read_text()
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    renewed = before + BEGIN + table() + END + after
    if sys.argv[1:] == ["--check"]:
        if renewed != page:
            sys.exit("docs/embedding.md: the table of statuses is out of date; run docs/make_status_table.py")
    else:
        PAGE.write_text(renewed)


if __name__ == "__main__":
    main()
