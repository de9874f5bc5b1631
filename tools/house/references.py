#!/usr/bin/env python3
"""Comments of src that send the reader elsewhere: is it there?

    references.py [ROOT]

A file that a comment names exists; `f() of file.cpp`, `f() in file.cpp` and `f() (file.cpp)` are functions that stand
in that file, in its code, not in its comments; any other `f()` is in some file's code. Fails on one that is not, and if
there was nothing to look at."""
import pathlib
import re
import sys

FILE = r"(?<![\w/.>*-])[\w/.-]*\w\w\w\.(?:hpp|cpp|h|c|py|sh|md|toml|bin)\b"
IN_FILE = re.compile(rf"(\w+)\(\)(?:,? (?:and|or) (\w+)\(\))? (?:of |in |\()({FILE})")
CALL = re.compile(r"\b([A-Za-z_]\w*)\(\)")
COMMENT = re.compile(r"[ \t]*//[/<]*(.*)")
SOURCES = (".cpp", ".hpp", ".c", ".h", ".py")


def comments(text):
    """[(line, text)] of comments; lines of one that follow each other are one."""
    found, joined = [], False
    for number, line in enumerate(text.split("\n"), 1):
        alone = re.match(r"[ \t]*//", line)
        comment = COMMENT.search(line) if "//" in line else None
        if comment and joined and alone:
            found[-1][1] += " " + comment[1].strip()
        elif comment:
            found.append([number, comment[1].strip()])
        joined = comment is not None
    return found


def code(text):
    return re.sub(r"//[^\n]*", "", text)


def wrong_references(root):
    """(sentences on references that lead nowhere, how many there are)"""
    every = [each for each in root.rglob("*") if each.is_file() and not {"build", ".git", "out"} & set(each.relative_to(root).parts)]
    places = ["/" + str(each.relative_to(root)) for each in every]
    texts = {each: each.read_text(errors="replace") for each in every if each.suffix in SOURCES}
    calls = set(re.findall(r"\b([A-Za-z_]\w*)\s*(?:<[^;(){}]*>)?\(", "\n".join(map(code, texts.values()))))

    def named(file):
        return [each for each, place in zip(every, places) if place.endswith("/" + file.removeprefix("./"))]

    wrong, looked_at = [], 0
    for path in sorted(each for each in texts if each.is_relative_to(root / "src") and "generated" not in each.parts):
        for line, text in comments(texts[path]):
            place = f"{path.relative_to(root)}:{line}"
            for file in re.findall(FILE, text):
                looked_at += 1
                if not named(file):
                    wrong.append(f"{place}: there is no {file}")
            for *functions, file in IN_FILE.findall(text):
                for function in filter(None, functions):
                    looked_at += 1
                    if named(file) and not any(re.search(rf"\b{function}\s*(<[^;(){{}}]*>)?\(", code(texts.get(each, ""))) for each in named(file)):
                        wrong.append(f"{place}: {function}() is not in {file}")
            for function in CALL.findall(text):
                looked_at += 1
                if function not in calls:
                    wrong.append(f"{place}: there is no {function}()")
    return wrong, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__ + "/../../..").resolve()
    wrong, looked_at = wrong_references(root)
    print(*wrong, f"{looked_at} references, {len(wrong)} of them lead nowhere", sep="\n")
    return 1 if wrong or not looked_at else 0


if __name__ == "__main__":
    sys.exit(main())
