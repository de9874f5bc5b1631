#!/usr/bin/env bash
# Lines of the product by module: src/ without generated files, blank lines and lines that are only comment.
#   product_lines.sh [REVISION...]      of these instead of HEAD, in columns
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- HEAD
python3 - "$@" <<'PYTHON'
import collections, re, subprocess, sys


def git(*arguments):
    return subprocess.run(["git", *arguments], check=True, capture_output=True, text=True).stdout


def modules(revision):
    lines = collections.Counter()
    for name in git("ls-tree", "-r", "--name-only", revision, "src").split():
        if re.search(r"\.(c|cpp|hpp)$", name) and "generated" not in name:
            text = git("show", f"{revision}:{name}").split("\n")
            lines[name.split("/")[1]] += sum(bool(line.strip()) and not line.strip().startswith("//") for line in text)
    return lines


counted = [modules(revision) for revision in sys.argv[1:]]
print(f"{'':12}" + "".join(f"{revision[:12]:>13}" for revision in sys.argv[1:]))
for module in sorted(set().union(*counted)):
    print(f"{module:12}" + "".join(f"{each[module]:13}" for each in counted))
print(f"{'all':12}" + "".join(f"{sum(each.values()):13}" for each in counted))
PYTHON
