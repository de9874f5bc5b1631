#!/usr/bin/env python3
"""Runs a program and compares what it prints with a file.

    check_output.py EXPECTED PROGRAM [ARGUMENT...]

Words must be equal, blanks apart. Numbers may differ by one unit of the last digit the file has: results are the same bits
everywhere, but for the exact solver's, which use the C library's functions. In the file * stands for any number, and a
line of three dots for any number of lines. The program must end with status 0. Where results moved on purpose, the file is
written anew with what the program prints.
"""
import re
import subprocess
import sys
from pathlib import Path

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w])|(?<!\S)\*(?!\S)")


def unit(number):
    """Of its last digit."""
    mantissa, _, exponent = number.lower().partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def same(expected, printed):
    """Whether two lines are: the text between the numbers, then the numbers."""
    found = NUMBER.findall(printed)
    wanted = NUMBER.findall(expected)
    if len(found) != len(wanted) or NUMBER.sub("0", expected).split() != NUMBER.sub("0", printed).split():
        return False
    return all(want == "*" or abs(float(want) - float(have)) <= 1.001 * unit(want)
               for want, have in zip(wanted, found))


def difference(expected, printed):
    """The first line that is not as expected, as a sentence; None if all are."""
    at = 0
    anywhere = False
    for line in expected:
        if line == "...":
            anywhere = True
            continue
        start = at
        while at < len(printed) and anywhere and not same(line, printed[at]):
            at += 1
        if at == len(printed) or not same(line, printed[at]):
            return f"expected: {line}\nprinted:  {printed[start] if start < len(printed) else 'nothing more'}"
        at += 1
        anywhere = False
    return None if at == len(printed) or anywhere else f"printed beyond what is expected: {printed[at]}"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    expected = Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()
    run = subprocess.run(sys.argv[2:], stdout=subprocess.PIPE, text=True, check=False)
    print(run.stdout, end="")
    wrong = difference(expected, run.stdout.splitlines())
    if wrong:
        sys.exit(f"{sys.argv[1]}:\n{wrong}")
    sys.exit(run.returncode)


if __name__ == "__main__":
    main()
