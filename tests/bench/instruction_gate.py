#!/usr/bin/env python3
"""Instructions per step of fixed cases, counted by valgrind, against the committed counts: the speed's regression gate.

    instruction_gate.py GATE_CASES             compares; exit status 1 when a case takes over 5 % more
    instruction_gate.py GATE_CASES --renew     writes the counts found into instruction_counts.txt

GATE_CASES is the program of tests/bench/gate_cases.cpp. Counts do not depend on the machine's load, but on the compiler:
those committed are of Debian 12's gcc in the release build. Fewer instructions pass too, with a hint to renew. Exit
status 77 (skipped) without valgrind.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TOLERANCE = 0.05
STEPS = 32
COUNTS = Path(__file__).with_name("instruction_counts.txt")


def instructions(program, case):
    """Per step, all libraries included; creation and the first step are not counted."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        subprocess.run(
            ["valgrind", "--tool=callgrind", "--toggle-collect=measured_steps", f"--callgrind-out-file={out}", program,
             case, str(STEPS)], check=True, capture_output=True, text=True)
        total = re.search(r"^(?:totals|summary): (\d+)", out.read_text(encoding="ascii"), re.MULTILINE)
        return int(total.group(1)) / STEPS


def committed():
    if not COUNTS.exists():
        return {}
    lines = COUNTS.read_text(encoding="ascii").splitlines()
    return {name: int(count) for name, count in (line.split() for line in lines if line and line[0] != "#")}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if shutil.which("valgrind") is None:
        print("skipped: there is no valgrind")
        sys.exit(77)
    program = sys.argv[1]
    cases = subprocess.run([program], check=True, capture_output=True, text=True).stdout.split()
    found = {case: instructions(program, case) for case in cases}
    expected = committed()
    worse = 0
    print(f"{'instructions per step':34} {'committed':>10} {'found':>10} {'change':>8}")
    for case, count in found.items():
        if case not in expected:
            print(f"{case:34} {'-':>10} {count:10.0f}")
            worse += 1
            continue
        change = count / expected[case] - 1.0
        verdict = "SLOWER" if change > TOLERANCE else "faster: --renew" if change < -TOLERANCE else ""
        worse += change > TOLERANCE
        print(f"{case:34} {expected[case]:10} {count:10.0f} {100 * change:+7.1f}%  {verdict}")
    if "--renew" in sys.argv[2:]:
        head = "# Instructions per step; written by  tests/bench/instruction_gate.py build/release/tests/bench/gate_cases --renew\n"
        COUNTS.write_text(head + "".join(f"{case} {count:.0f}\n" for case, count in found.items()), encoding="ascii")
        print(f"written to {COUNTS.name}")
        return
    print(f"{len(found) - worse} passed, {worse} failed")
    sys.exit(1 if worse or not found else 0)


main()
