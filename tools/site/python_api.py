"""The reference of the Python package as a page, of the docstrings in bindings/python/wrc: classes, functions, structs with their members."""
import ast
import html
import pathlib

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "bindings/python/wrc"
# (heading, file, what stands before the names)
MODULES = (("Models and contacts", "contact.py", "wrc"), ("Profiles", "profiles.py", "wrc"), ("Damage", "damage.py", "wrc"), ("Tables", "tables.py", "wrc"),
           ("The exact solver", "exact.py", "wrc.exact"), ("Pictures", "plot.py", "wrc.plot"))
INHERITED = {"Model": "ModelCalls", "Contact": "ContactCalls"}


def page():
    """The page's text, with a section a module, and one for the structs."""
    calls, structs, functions = _interface()
    lines = ["# Reference of the Python package", "", "Written from the docstrings; `help(wrc.Contact.wrench)` says the same.", ""]
    for heading, name, prefix in MODULES:
        tree = ast.parse((PACKAGE / name).read_text())
        lines += [f"## {heading}", ""]
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                lines += [f"### {prefix}.{node.name}", "", *_text(node)]
                inherited = calls.get(INHERITED.get(node.name, ""), [])
                for each in sorted([*_methods(node), *inherited], key=lambda method: method.name):
                    lines += _function(each, f"{node.name}.")
            elif isinstance(node, ast.FunctionDef) and not node.name.startswith("_") and ast.get_docstring(node):
                lines += [f"### {prefix}.{node.name}", "", *_function(node, prefix + ".")]
    for each in functions:
        lines += _function(each, "wrc.")
    lines += ["## Structs and choices", ""]
    for node in structs:
        lines += [f"### wrc.{node.name}", "", *_text(node), *_members(node)]
    return "\n".join(lines) + "\n"


def _interface():
    tree = ast.parse((PACKAGE / "_interface.pyi").read_text())
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    calls = {node.name: _methods(node) for node in classes if node.name.endswith("Calls")}
    structs = [node for node in classes if not node.name.endswith(("Calls", "Dict"))]
    return calls, structs, [node for node in tree.body if isinstance(node, ast.FunctionDef)]


def _methods(node):
    return [each for each in node.body if isinstance(each, ast.FunctionDef) and not each.name.startswith("_") and ast.get_docstring(each)]


def _function(node, prefix):
    arguments = ast.unparse(node.args).replace("i.", "wrc.").replace("s.", "")
    for owner in ("self, ", "self", "cls, "):
        arguments = arguments.removeprefix(owner)
    shown = node.name if any(ast.unparse(each) == "property" for each in node.decorator_list) else f"{node.name}({arguments})"
    return [f"<b><code>{html.escape(prefix + shown, quote=False)}</code></b>", "", *_text(node)]


def _text(node):
    """A docstring as it stands."""
    return [*("    " + line for line in (ast.get_docstring(node) or "").splitlines()), ""]


def _members(node):
    rows, body = [], node.body
    for at, each in enumerate(body):
        text = ""
        if isinstance(each, (ast.AnnAssign, ast.Assign)) and at + 1 < len(body) and isinstance(body[at + 1], ast.Expr):
            text = body[at + 1].value.value
            name = each.target.id if isinstance(each, ast.AnnAssign) else each.targets[0].id
        elif isinstance(each, ast.FunctionDef) and ast.get_docstring(each) and each.name not in ("__init__", "set"):
            name, text = each.name, ast.get_docstring(each)
        if text:
            told = " ".join(text.split()).removeprefix(name).replace("|", "\\|").replace("<", "&lt;")
            rows.append(f"| `{name}` | {told.removeprefix(':').strip()} |")
    return ["| | |", "|---|---|", *rows, ""] if rows else []
