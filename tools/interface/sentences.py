#!/usr/bin/env python3
"""Long sentences in the comments of the C headers and in the pages that a newcomer reads: they are read twice.

    tools/interface/sentences.py [HEADER...]    prints each of more than 25 words, and counts them; exits with 1 where wrc.h or
                                                wrc_planar.h has one, or one of PAGES has one of more than 30

A sentence ends with . ! ? or ; and where a paragraph, an item of a list or a tag (@param, @return) begins. Code, tables and
targets of links are left out. Of the changelog what is not released counts."""
import pathlib
import re
import sys

MOST = 25
STRICT = ("wrc.h", "wrc_planar.h")  # frozen from 1.0 on
ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "include_c/wrc"
MOST_OF_PAGES = 30
PAGES = ("README.md", "CHANGELOG.md", "bindings/python/README.md", "docs/tutorial.md", "docs/python.md", "docs/which_call.md",
         "docs/from_other_programs.md", "docs/paper.md", "docs/gallery.md")


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


def of_page(text):
    """(line, sentence) of a page."""
    text = re.sub(r"^## \[(?!.*unreleased).*", "", text, flags=re.M | re.S)  # releases of the changelog
    text = re.sub(r"^```.*?^```$", lambda code: "\n" * code.group(0).count("\n"), text, flags=re.M | re.S)
    part, begun = "", 1
    for number, line in enumerate(text.split("\n") + [""], 1):
        left_out = re.match(r" {4}|\s*$|\s*[|#!<]", line) and not (part and re.match(r" {4}[^ ]", line) and part.startswith("- "))
        if part and (left_out or re.match(r"\s*(- |\d+\. )", line)):
            yield from split(begun, part)
            part = ""
        if not left_out:
            begun = begun if part else number
            part = (part + " " + re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", line.strip())).strip()


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
    for name in PAGES if not sys.argv[1:] else ():
        found = [(line, sentence) for line, sentence in of_page((ROOT / name).read_text()) if len(sentence.split()) > MOST_OF_PAGES]
        for line, sentence in found:
            print(f"{name}:{line}: {len(sentence.split())} words: {sentence}")
        print(f"{name}: {len(found)} sentences of more than {MOST_OF_PAGES} words")
        strict += len(found)
    return 1 if strict else 0


if __name__ == "__main__":
    sys.exit(main())
