#!/usr/bin/env bash
# Pairs of places in src/ that are the same piece of code written twice, found by Debian's similarity-tester: runs of more
# than 6 lines that agree token by token whatever the names, if they are 60 tokens or more or their lines are the same.
# Generated files are left out, and lines that copy one member to another do not count. Fails on a pair that is not in the
# list below with its reason, and on a line of the list that no pair needs any more. Status 77 without the tester.
#   duplicates.sh [SOURCE_DIRECTORY]
set -euo pipefail
cd "${1:-$(dirname "$0")/..}"
command -v sim_c++ >/dev/null || { echo "skipped: Debian's similarity-tester is not there"; exit 77; }
# Two files (or one, twice), how many such pairs they have, and why one function cannot serve.
known='
src/base/pack.hpp                      src/base/pack.hpp                              2  an operation a line for each instruction set; two types, of numbers and of yes or no
src/tangential/simd/march_start.hpp    src/tangential/simd/strip_fastsim_start.hpp    1  two tasks with members of their own, loaded into vectors
src/surface/rolling/surface_calibration.hpp    src/tangential/methods/strip_calibration.hpp   1  two enumerations of fitted constants
src/contact/region.hpp                 src/contact/region.hpp                         1  a list of fields, a line each
'
python3 - "$known" $(find src -name '*.cpp' -o -name '*.hpp' -o -name '*.c' | grep -v generated | sort) <<'PYTHON'
import collections, re, subprocess, sys

fewest_tokens, sure_tokens, most_lines = 30, 60, 6
known, files = sys.argv[1], sys.argv[2:]
text = {file: open(file, encoding="utf-8").read().split("\n") for file in files}

plain = re.compile(r"#|[\w.\[\]>-]+ = -?[\w.\[\]>-]+;$|(const )?\w+(<\w+>)?[ *]+\w+( = [\w.]+)?;$")


def lines(file, first, last):
    """What is done there: no comments, braces, includes, declared members, members copied one by one."""
    stripped = (re.sub(r"//.*", "", line).strip() for line in text[file][first - 1 : last])
    return [line for line in stripped if re.search(r"\w", line) and not plain.match(line)]


def same(one, other):
    """How many lines stand in both."""
    return sum((collections.Counter(one) & collections.Counter(other)).values())


said = subprocess.run(["sim_c++", "-n", "-w", "400", "-r", str(fewest_tokens), *files], check=True,
                      capture_output=True, text=True).stdout
run = re.compile(r"^(\S+): line (\d+)-(\d+)\s*\|(\S+): line (\d+)-(\d+)\s*\[(\d+)\]$")
found = collections.defaultdict(list)
for row in filter(None, map(run.match, said.split("\n"))):
    one, other = (row[1], int(row[2]), int(row[3])), (row[4], int(row[5]), int(row[6]))
    here, there = lines(*one), lines(*other)
    if min(len(here), len(there)) <= most_lines:
        continue
    if int(row[7]) >= sure_tokens or same(here, there) > most_lines:
        found[one[0], other[0]].append(f"  lines {one[1]}-{one[2]} and {other[1]}-{other[2]}, {row[7]} tokens")
if not said.strip():
    sys.exit("the tester said nothing")

wrong = 0
allowed = {}
for entry in filter(None, known.split("\n")):
    one, other, count, _ = entry.split(None, 3)
    allowed[one, other] = int(count)
for pair, places in sorted(found.items()):
    if len(places) > allowed.get(pair, 0):
        print(*pair, f"{len(places)} pairs, {allowed.get(pair, 0)} of them known:", *places, sep="\n")
        wrong += 1
for pair, count in allowed.items():
    if len(found.get(pair, [])) < count:
        print(*pair, f"{len(found.get(pair, []))} pairs of {count} in the list: shorten it", sep="\n")
        wrong += 1
print(f"{len(files)} files, {sum(map(len, found.values()))} pairs, {sum(allowed.values())} of them known")
sys.exit(wrong > 0)
PYTHON
