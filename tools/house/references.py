#!/usr/bin/env python3
"""Comments of src, and the pages for contributors, that send the reader elsewhere: is it there?

    references.py [ROOT]

A file that a comment or page names exists; `f() of file.cpp`, `f() in file.cpp` and `f() (file.cpp)` are functions that
stand in that file, in its code, not in its comments; any other `f()` is in some file's code, tests apart. In a page, folders (`name/`)
exist too, and a name in backticks is a word of the code or a file. docs/decisions/README.md lists every decision. Fails on
one that is not, and if there was nothing to look at."""
import pathlib
import re
import sys

FILE = r"(?<![\w/.>*-])[\w/.-]*\w\w\w\.(?:hpp|cpp|h|c|py|sh|md|toml|bin)\b"
IN_FILE = re.compile(rf"(\w+)\(\)(?:,? (?:and|or) (\w+)\(\))? (?:of |in |\()({FILE})")
CALL = re.compile(r"\b([A-Za-z_]\w*)\(\)")
COMMENT = re.compile(r"[ \t]*//[/<]*(.*)")
SOURCES = (".cpp", ".hpp", ".c", ".h", ".py")
PAGES = ("docs/architecture.md", "docs/surface_solver.md", "docs/theory.md", "docs/accuracy.md", "docs/accuracy_method.md", "docs/realtime.md",
         "docs/decisions/*.md", "CONTRIBUTING.md", "tests/README.md", "tools/README.md", "tools/*/README.md")
FOLDER = re.compile(r"(?<![\w/.:<>$-])((?:[\w.-]{3,}/)+)(?![\w*<])")
NAME = re.compile(r"`(?:\w+(?:\.|->|::))*([A-Za-z_]\w{2,})(?:\[\d*\])?`")


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


def paragraphs(text):
    """[(line, text)] of a page's paragraphs: lines up to an empty one. Lines of a table or list stand alone."""
    found, joined = [], False
    for number, line in enumerate(text.split("\n"), 1):
        if joined and line.strip() and not re.match(r" *(\||- |\d+\. )", line):
            found[-1][1] += " " + line.strip()
        elif line.strip():
            found.append([number, line.strip()])
        joined = bool(line.strip())
    return found


def code(text):
    return re.sub(r"//[^\n]*", "", text)


class Tree:
    def __init__(self, root):
        self.root = root
        self.files = [each for each in root.rglob("*") if each.is_file() and not {"build", ".git", "out"} & set(each.relative_to(root).parts)]
        self.places = ["/" + str(each.relative_to(root)) for each in self.files]
        self.texts = {each: each.read_text(errors="replace") for each in self.files if each.suffix in SOURCES}
        every = "\n".join(map(code, self.texts.values()))
        self.calls = set(re.findall(r"\b([A-Za-z_]\w*)\s*(?:<[^;(){}]*>)?\(", "\n".join(
            code(text) for each, text in self.texts.items() if each.relative_to(root).parts[0] != "tests")))
        built = "\n".join(each.read_text(errors="replace") for each in self.files if each.name == "CMakeLists.txt" or each.suffix in (".cmake", ".sh"))
        self.words = set(re.findall(r"\w+", every + "\n" + built)) | {part.split(".")[0] for place in self.places for part in place.split("/")}

    def named(self, file):
        return [each for each, place in zip(self.files, self.places) if place.endswith("/" + re.sub(r"^(\.\.?/)+", "", file))]

    def has(self, function, file):
        return any(re.search(rf"\b{function}\s*(<[^;(){{}}]*>)?\(", code(self.texts.get(each, ""))) for each in self.named(file))

    def references(self, text, page):
        """(sentence if it led nowhere, does it lead somewhere?) for each reference of a text."""
        for file in re.findall(FILE, text):
            yield f"there is no {file}", self.named(file)
        for *functions, file in IN_FILE.findall(text.replace("`", "")):
            for function in filter(None, functions):
                yield f"{function}() is not in {file}", not self.named(file) or self.has(function, file)
        for function in CALL.findall(text):
            yield f"there is no {function}()", function in self.calls
        for folder in FOLDER.findall(text) if page else ():
            yield f"there is no folder {folder}", any("/" + folder in place for place in self.places)
        for name in NAME.findall(re.sub(FILE, "", text)) if page else ():
            yield f"there is no `{name}`", name in self.words

    def passages(self):
        """(file, line, text, is it a page?) of comments and pages"""
        for path in sorted(each for each in self.texts if each.is_relative_to(self.root / "src") and "generated" not in each.parts):
            for line, text in comments(self.texts[path]):
                yield path, line, text, False
        for path in sorted(path for pattern in PAGES for path in self.root.glob(pattern)):
            for line, text in paragraphs(path.read_text()):
                yield path, line, text, True


def wrong_references(root):
    """(sentences on references that lead nowhere, how many there are)"""
    tree, wrong, looked_at = Tree(root), [], 0
    for path, line, text, page in tree.passages():
        for sentence, right in tree.references(text, page):
            looked_at += 1
            if not right:
                wrong.append(f"{path.relative_to(root)}:{line}: {sentence}")
    decisions = root / "docs/decisions"
    listed = (decisions / "README.md").read_text() if (decisions / "README.md").exists() else ""
    wrong += [f"docs/decisions/README.md: does not list {each.name}" for each in sorted(decisions.glob("*.md"))
              if each.name != "README.md" and f"({each.name})" not in listed]
    return wrong, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__ + "/../../..").resolve()
    wrong, looked_at = wrong_references(root)
    print(*wrong, f"{looked_at} references, {len(wrong)} of them lead nowhere", sep="\n")
    return 1 if wrong or not looked_at else 0


if __name__ == "__main__":
    sys.exit(main())
