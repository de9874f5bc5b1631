"""Functions of a C++ source, by its braces: enough for code that clang-format has laid out, without a compiler.

A body is a `{` behind a list of parameters; a lambda belongs to the function that it stands in."""
import dataclasses
import re

NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![\w])\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#(?:\\\n|[^\n])*', re.S | re.M)
CONTROL = re.compile(r"\s*(if|for|while|switch|catch|do|else|return|namespace)\b")
HEAD = re.compile(r"(operator\s*(?:\(\)|[^\s(]+)|(?:~|\b)[\w:]+(?:<[\w:, ]*>::\w+)?)\s*\(")


@dataclasses.dataclass
class Function:
    name: str
    first: int  # line of its name's statement, from 1
    opening: int  # line of the body's brace
    last: int
    parameters: int

    @property
    def lines(self):
        return self.last - self.first + 1


def blanked(text):
    """The text with comments, strings and directives as blanks: places and lines stay."""
    return NOT_CODE.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def matching(code, at):
    """Where the bracket at `at` closes."""
    pairs, depth = {"(": ")", "{": "}"}, 0
    for place in range(at, len(code)):
        depth += (code[place] == code[at]) - (code[place] == pairs[code[at]])
        if depth == 0:
            return place
    return len(code) - 1


def count_parameters(inside):
    """Commas outside all brackets, of templates too."""
    depth, count = 0, 1
    for place, letter in enumerate(inside):
        depth += (letter in "([{<") - (letter in ")]}" or (letter == ">" and inside[place - 1] != "-"))
        count += letter == "," and depth == 0
    return count if inside.strip() and inside.strip() != "void" else 0


def head_of(statement):
    """(name, parameters) if the statement before a `{` declares a function; else None."""
    statement = re.sub(r"^(\s*(public|private|protected):)+", "", statement)
    start = re.match(r"\s*(template\s*<[^;{}]*?>\s*(?=[\w\[:~]))*", statement).end()
    found = HEAD.search(statement, start)
    if CONTROL.match(statement, start) or not found:
        return None
    before = statement[start:found.start()]
    if "=" in before or re.search(r"\b(struct|class|union|enum)\b[^()]*$", before) and "operator" not in found[1]:
        return None
    return found[1], statement[found.end():matching(statement, found.end() - 1)]


def functions(text):
    code = blanked(text)
    line_of = lambda place: code.count("\n", 0, place) + 1
    found, place, start = [], 0, 0  # start: of the statement
    while place < len(code):
        letter = code[place]
        if letter == "(":
            place = matching(code, place)
        elif letter in ";}":
            start = place + 1
        elif letter == "{":
            head = head_of(code[start:place])
            if head and re.search(r"[\w\])]\s*$", code[start:place]):
                # `Type() : member{1}, other(2) {`: braces of members come before that of the body
                end = matching(code, place)
                while re.match(r"\s*[,{]", code[end + 1:]) and re.search(r"\)\s*(noexcept\s*)?:[^:]", code[start:place]):
                    place = code.index("{", end + 1)
                    end = matching(code, place)
                first = start + len(code[start:place]) - len(code[start:place].lstrip())
                found.append(Function(head[0], line_of(first), line_of(place), line_of(end), count_parameters(head[1])))
                place = end
            elif "=" in code[start:place]:
                place = matching(code, place) + 1  # values: the statement goes on
                continue
            start = place + 1
        place += 1
    return found
