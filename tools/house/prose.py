#!/usr/bin/env python3
"""Prose of the manuals: proselint (PyPI) over their text without code and tables, and words that a reader does not expect.

    tools/house/prose.py        prints each finding; status 1 if there is one, 77 without proselint

proselint's checks of typography (curly quotes, ellipses) are of no use in sources, and some of its others take terms of the field for
slips: CHECKS_OFF."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHECKS_OFF = ("typography", "lexical_illusions", "hedging", "misc.but")
WORDS = re.compile(r"\b(anew|leaps?|leaping|whilst|thereof|therein|utili[sz]e|whatsoever|heretofore)\b", re.I)


def prose(text):
    """The text with code, tables, formulas and targets of links blanked, line by line as it was."""
    def blank(found):
        return re.sub(r"[^\n]", " ", found[0])
    for pattern in (r"^```[\s\S]*?^```", r"^ {4,}\S.*$", r"^\|.*$", r"`[^`\n]*`", r"\]\([^)]*\)", r"\b\w+://\S+"):
        text = re.sub(pattern, blank, text, flags=re.M)
    return text


def main():
    program = ROOT / "build/venv/bin/proselint"
    program = str(program) if program.exists() else shutil.which("proselint")
    if program is None:
        print("skipped: there is no proselint")
        return 77
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "*.md"], capture_output=True, text=True, check=True).stdout.split()
    count = 0
    with tempfile.TemporaryDirectory() as folder:
        for name in listed:
            text = prose((ROOT / name).read_text(encoding="utf-8"))
            for number, line in enumerate(text.splitlines(), 1):
                for word in WORDS.findall(line):
                    print(f"{name}:{number}: {word}: say it with a common word")
                    count += 1
            path = pathlib.Path(folder) / name.replace("/", "_")
            path.write_text(text, encoding="utf-8")
        found = subprocess.run([program, "check", folder], capture_output=True, text=True).stdout
    for line in re.sub(r"\n {8,}", " ", found).splitlines():
        check = line.split(": ")[1] if line.count(": ") > 1 else ""
        if check and not check.startswith(CHECKS_OFF):
            print(line.replace(folder + "/", ""))
            count += 1
    print(f"{len(listed)} pages, {count} findings")
    return bool(count)


if __name__ == "__main__":
    sys.exit(main())
