#!/usr/bin/env python3
"""Long sentences in the comments of the C headers: they are read twice.

    tools/interface/sentences.py [HEADER...]    prints each of more than 25 words, and counts them; exits with 1 where
                                                wrc.h or wrc_planar.h has one

A sentence ends with . ! ? or ; and where a paragraph, an item of a list or a tag (@param, @return) begins. Code is left
out."""
import pathlib
import re
import sys

MOST = 25
STRICT = ("wrc.h", "wrc_planar.h")  # frozen from 1.0 on
INCLUDE = pathlib.Path(__file__).resolve().parents[2] / "include_c/wrc"


def comments(text):
    """(line, text of one comment), with its line breaks."""
    for found in re.finditer(r"/\*\*?<?(.*?)\*/", text, re.S):
        yield text.count("\n", 0, found.start()) + 1, found.group(1)


def sentences(comment):
    """(line within the comment, sentence)."""
    comment = re.sub(r"@code.*?@endcode|@cond|@endcond|@[{}]", lambda code: "\n" * code.group(0).count("\n"), comment, flags=re.S)
    part, begun = "", 0
    for number, line in enumerate(comment.split("\n") + [""]):
        stripped = re.sub(r"^\s*\*(?=\s|$)", "", line)
        picture = stripped.startswith("     ")  # drawings and formulas
        begins = not stripped.strip() or picture or re.match(r"\s*(- |@)", stripped)
        if begins and part:
            yield from split(begun, part)
            part = ""
        if picture or not stripped.strip():
            continue
        if not part:
            begun = number
        part += " " + stripped.strip()
    if part:
        yield from split(begun, part)


def split(line, part):
    for each in re.split(r"(?<=[.!?;])\s+|\s(?=@)", part):
        yield line, each.strip()


def main():
    names = sys.argv[1:] or sorted(path.name for path in INCLUDE.glob("*.h"))
    strict = 0
    for name in names:
        found = [(line + within, sentence) for line, comment in comments((INCLUDE / name).read_text())
                 for within, sentence in sentences(comment) if len(sentence.split()) > MOST]
        for line, sentence in found:
            print(f"include_c/wrc/{name}:{line}: {len(sentence.split())} words: {sentence}")
        print(f"{name}: {len(found)} sentences of more than {MOST} words")
        strict += len(found) if name in STRICT else 0
    return 1 if strict else 0


if __name__ == "__main__":
    sys.exit(main())
