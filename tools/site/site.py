#!/usr/bin/python3
"""The manuals as a site, build/docs/html: doxygen over all pages with links between them; fails on a warning of doxygen, a link that
leads nowhere, and a public function without an example. Formulas (```math, in TeX as matplotlib sets it) become pictures
beside the pages, one for each part between \\qquad, so that they break on a phone.

    tools/site/site.py        from the project's root or anywhere"""
import hashlib
import html
import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/interface"))
import notebook
import python_api
import headers  # which header is of which class of stability

NO_PAGE = "wrc_status.h"  # a list by macros, which doxygen does not read: a table in embedding.md
WORK, OUT = ROOT / "build/site", ROOT / "build/docs/html"
# The manuals in the order of a reader; pages that are not here go to the last entry, decisions into one of their own.
TABS = [
    ("First hour", [("Tutorial", "tutorial.md"), ("Which call do I want", "which_call.md"), ("From other programs", "from_other_programs.md")]),
    ("Embedding", "embedding.md"), ("Frames and signs", "frames.md"), ("Theory", "theory.md"),
    ("Accuracy", [("Results", "accuracy.md"), ("The source paper", "paper.md"), ("How the figures are made", "accuracy_method.md")]),
    ("Real time, speed", "realtime.md"),
    ("Callers", [("Side by side", "languages.md"), ("C++", "in_bindings_cpp.md"), ("Python", "python.md"), ("Python reference", "python_api.md"), ("Python package", "in_bindings_python.md"),
                 ("Exudyn", "in_bindings_python_examples_exudyn.md"), ("scipy", "in_bindings_python_examples_scipy.md"),
                 ("Sweeps", "in_bindings_python_examples_sweep.md"),
                 ("Wear over a network", "in_bindings_python_examples_wear.md"), ("Fortran", "in_bindings_fortran.md"), ("FMI", "in_bindings_fmi.md"),
                 ("Other programs", "in_bindings_hosts.md"), ("Simbody", "in_bindings_hosts_simbody.md"), ("Simulink", "in_bindings_hosts_simulink.md"),
                 ("Modelica", "in_bindings_hosts_modelica.md"), ("User forces", "user_forces.md"), ("A wheelset in hosts", "hosts.md")]),
    ("Gallery", "gallery.md"),
    ("More", [("Members of structs", "members.md"), ("What is promised", "abi.md"), ("From 0.2 to 0.9", "interface_0_9.md"),
              ("Packages", "in_tools_packages.md"), ("Security, support", "SECURITY.md"), ("Changes", "CHANGELOG.md"),
              ("Architecture", "architecture.md"), ("Pressure solver", "surface_solver.md"), ("Decisions", "in_docs_decisions.md"),
              ("Contributing", "CONTRIBUTING.md"), ("Code of others", "third_party.md")]),
]
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")


def pages():
    """{path in the tree: its name in the site}"""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", "*.md"], capture_output=True, text=True).stdout.split()
    if not listed:  # no history
        listed = [str(each.relative_to(ROOT)) for each in ROOT.rglob("*.md") if "build" not in each.parts]
    wanted = [each for each in listed if re.match(r"(README|CHANGELOG|CONTRIBUTING|docs/(decisions/)?\w+|(bindings|tools/packages)/(.*/)?README)\.md$", each)]
    names = {}
    for each in wanted:
        name = re.sub("^docs/", "", each).replace("/", "_") if "README" not in each else "in_" + each.removesuffix("/README.md").replace("/", "_") + ".md"
        names[each] = "start.md" if each == "README.md" else name
    return names


def rewritten(path, names):
    """The page's text with links as they are in the site."""
    def link(found):
        picture, text, target = found.groups()
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            return found[0]
        if target.endswith(".ipynb"):  # made of the page of that name
            return f'<a href="{target}" download="{target}">{text}</a>'
        target, _, anchor = target.partition("#")
        place = os.path.normpath(os.path.join(os.path.dirname(path), target))
        if picture:
            return f"![{text}]({os.path.basename(place)})"
        for page in (place, place + "/README.md"):
            if page in names:
                return f"[{text}]({names[page]}{'#' + anchor if anchor else ''})"
        name = os.path.basename(place)
        if place.startswith("include_c/"):
            return text if name == NO_PAGE else f"[{text}]({of_header(name)})"
        if place.startswith("examples_c/") and name in examples():
            return f"[{text}]({name.replace('.', '_8')}-example.html)"
        assert (ROOT / place).exists(), f"{path}: {place} is not there"
        return text  # of the sources, which the site does not have
    return LINK.sub(link, (ROOT / path).read_text())


def formulas(text):
    """The page's text with its formulas as pictures, which are written to WORK."""
    import matplotlib
    from matplotlib import mathtext
    matplotlib.rcParams.update({"mathtext.fontset": "stix", "svg.fonttype": "path", "svg.hashsalt": "wrc"})

    def picture(tex):
        name = f"formula_{hashlib.sha256(tex.encode()).hexdigest()[:12]}.svg"
        depth = mathtext.math_to_image("$" + tex.replace("\\frac", "\\dfrac") + "$", WORK / name, format="svg", dpi=72,
                                       prop=matplotlib.font_manager.FontProperties(size=10))
        width = float(re.search(r'<svg [^>]*?width="([\d.]+)pt"', (WORK / name).read_text(), re.S)[1])
        return (f'<img src="{name}" alt="{html.escape(tex)}" '
                f'style="width:{width / 9:.2f}em;vertical-align:{-depth / 9:.2f}em"/>')

    def block(found):
        lines = (" ".join(picture(part.strip()) for part in line.split("\\qquad")) for line in found[1].splitlines())
        return "\n".join(f'<div class="formula">{line}</div>' for line in lines) + "\n"
    return re.sub(r"^```math\n(.*?)^```\n", block, text, flags=re.M | re.S)


GREEK = {"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "eps": "ε", "epsilon": "ε", "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ",
         "nu": "ν", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "psi": "ψ", "omega": "ω", "Sigma": "Σ", "Lambda": "Λ"}
CODE = re.compile(r"(^```[\s\S]*?^```$|^ {4,}.*$|^#.*$|<[^>\n]*>|`[^`\n]*`|\]\([^)]*\)|\[[^\]\n]*\]\(|\b[a-z]+://\S+)", re.M)


def letters(text):
    """The page's text with quantities in prose as the formulas have them: Greek letters, indices, powers. Code, headings and links
    stay."""
    def symbols(part):
        part = re.sub(r"\b(%s|[A-Za-z]{1,2}'?)_(\{\w+\}|[A-Za-z0-9]{1,6})\b" % "|".join(GREEK),
                      lambda found: f"<em>{found[1]}</em><sub>{found[2].strip('{}')}</sub>", part)
        part = re.sub(r"\b(height|curvature|centre|peak|width|length)_([a-z0-9])\b", r"<em>\1</em><sub>\2</sub>", part)
        part = re.sub(r"\b([CLK])(11|22|23|33)\b", r"<em>\1</em><sub>\2</sub>", part)
        part = re.sub(r"(?<=[\w)>])\^(-?\d+(?:[./]\d+)?|\([^()\s]+\)|[a-z])(?![\w^])", lambda found: f"<sup>{found[1].strip('()')}</sup>", part)
        part = re.sub(r"\bsqrt(?=\()", "√", re.sub(r"\bInt(?= )", "∫", part))
        return re.sub(r"(?<![\w./-])(%s)(?!\w|[./-]\w)" % "|".join(GREEK), lambda found: GREEK[found[1]], part)
    return "".join(part if k % 2 else symbols(part) for k, part in enumerate(CODE.split(text)))


def languages():
    """The page that shows one task, a wheelset under yaw, in each language: the pieces of the manuals and the bindings."""
    def first(path, language):
        return re.search(rf"^```{language}\n(.*?)^```", (ROOT / path).read_text(), re.M | re.S)[1]
    pieces = [("Python", "py", first("docs/python.md", "python")), ("C", "c", first("README.md", "c")),
              ("C++", "cpp", (ROOT / "bindings/cpp/first_step.cpp").read_text()), ("Fortran", "f90", (ROOT / "bindings/fortran/main_case.f90").read_text())]
    return ("# One wheelset, four languages {#page_languages}\n\nA wheelset stands on its rails under 80 kN on each wheel. Then it rolls at 20 m/s with "
            "a yaw of 2 mrad, and the forces on both wheels are printed.\n\n" +
            "".join(f"## {title}\n\n\\code{{.{ending}}}\n{code}\\endcode\n\n" for title, ending, code in pieces))


def named(text, name):
    """The page with an identifier of its own, whatever the folder it was in; doxygen knows no code in headings."""
    text = re.sub(r"^#.*$", lambda found: found[0].replace("`", ""), text, flags=re.M)
    if len(re.findall(r"^##+ ", text, re.M)) > 7 and name != "start.md":  # a long page has its contents at its side
        text = re.sub(r"^(# .*\n)", r"\1\n[TOC]\n", text, count=1)
    return text if name == "start.md" else re.sub(r"^# (.*)$", lambda found: f"# {found[1]} {{#{identifier(name)}}}", text, count=1, flags=re.M)


def identifier(name):
    return "page_" + name.removesuffix(".md")


def of_header(name):
    """The page of a header."""
    return f"{name.replace('_', '__').replace('.', '_8')}.html"


def interface():
    """The headers as tabs, by class of stability."""
    def group(title, names):
        return f'<tab type="usergroup" title="{title}">' + "".join(
            f'<tab type="user" title="{name}" url="@ref {name}"/>' for name in names if name != NO_PAGE) + "</tab>"
    tables = [pathlib.Path(name).name for name in headers.TABLES.values()]
    return ('<tab type="usergroup" title="Interface">' + group("Frozen from 1.0 on", headers.STABLE) +
            group("May change in a minor version", headers.EXPERIMENTAL) + group("Tables for dlopen", tables) +
            '<tab type="globals" visible="yes" title="All names"/></tab>')


def layout(names):
    """Doxygen's own layout with the manuals as tabs."""
    def tab(title, name):
        return f'<tab type="user" title="{title}" url="@ref {identifier(name)}"/>'
    told = {"start.md"} | {name for _, entry in TABS for name in ([entry] if isinstance(entry, str) else [each for _, each in entry])}
    assert told - {"python_api.md", "languages.md"} <= set(names.values()), f"tabs without a page: {told - set(names.values())}"
    rest = [(re.search("^# (.*)$", (ROOT / path).read_text(), re.M)[1], path, name) for path, name in sorted(names.items()) if name not in told]
    decisions = [(title, name) for title, path, name in rest if path.startswith("docs/decisions/")]
    others = [(title, name) for title, path, name in rest if not path.startswith("docs/decisions/")]
    entries = TABS[:-1] + [(TABS[-1][0], TABS[-1][1] + others)] + ([("Decisions", decisions)] if decisions else [])
    tabs = ['<tab type="mainpage" visible="yes" title="Start"/>']
    for title, entry in entries:
        if isinstance(entry, str):
            tabs.append(tab(title, entry))
        else:
            tabs.append(f'<tab type="usergroup" title="{title}">' + "".join(tab(*each) for each in entry) + "</tab>")
    tabs += [interface(),
             '<tab type="structs" visible="yes" title="Structs"><tab type="structlist" visible="yes" title="List"/></tab>',
             '<tab type="examples" visible="yes" title="Examples"/>']
    subprocess.run(["doxygen", "-l", WORK / "layout.xml"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    whole = (WORK / "layout.xml").read_text()
    (WORK / "layout.xml").write_text(re.sub(r"<navindex>.*</navindex>", lambda _: "<navindex>" + "".join(tabs) + "</navindex>", whole, flags=re.S))


def examples():
    return re.findall(r"@example (\S+)", (ROOT / "tools/site/examples.dox").read_text())


class Links(html.parser.HTMLParser):
    """Links and anchors of a page."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value and tag != "link":
                self.links.append(value)
            if name in ("id", "name") and value:
                self.anchors.add(value)


def broken():
    """Links within the site that lead nowhere."""
    read = {page.name: Links(page.read_text(errors="replace")) for page in OUT.glob("*.html")}
    for name, page in sorted(read.items()):
        for link in page.links:
            if re.match(r"[a-z]+:", link):
                continue
            file, _, anchor = urllib.parse.unquote(link).partition("#")
            file = file or name
            if not (OUT / file).exists():
                yield f"{name}: {link}"
            elif anchor and file in read and anchor not in read[file].anchors:
                yield f"{name}: {link}"


def without_example():
    """Public functions that no example of the site calls; those that set defaults are called by wrc_X_default()."""
    functions = re.findall(r"^  (wrc_\w+)$", (ROOT / "src/abi/generated/wrc.def").read_text(), re.M)
    called = "".join((ROOT / "examples_c" / name).read_text() for name in examples())
    return [name for name in functions if (not name.endswith("_init") or name in ("wrc_model_init", "wrc_contact_init"))
            and not re.search(rf"\b{name}\b", called)]


def main():
    names = pages()
    shutil.rmtree(WORK, ignore_errors=True)
    shutil.rmtree(OUT, ignore_errors=True)
    WORK.mkdir(parents=True)
    for path, name in names.items():
        (WORK / name).write_text(named(formulas(letters(rewritten(path, names))), name))
    (WORK / "python_api.md").write_text(named(python_api.page(), "python_api.md"))
    (WORK / "languages.md").write_text(languages())
    layout(names)
    settings = (ROOT / "docs/Doxyfile").read_text() + f"""
INPUT = {WORK} tools/site/examples.dox include_c
EXAMPLE_PATH = examples_c
IMAGE_PATH = docs/pictures
USE_MDFILE_AS_MAINPAGE = {WORK}/start.md
STRIP_FROM_PATH = {WORK} .
HTML_EXTRA_STYLESHEET = tools/site/site.css
HTML_EXTRA_FILES = tools/site/site.js
LAYOUT_FILE = {WORK}/layout.xml
FILE_PATTERNS = *.h *.md *.dox
"""
    (WORK / "Doxyfile").write_text(settings)
    subprocess.run(["doxygen", WORK / "Doxyfile"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    (OUT / "tutorial.ipynb").write_text(notebook.notebook((ROOT / "docs/tutorial.md").read_text()))
    for each in OUT.glob("*.html"):
        each.write_text(each.read_text().replace("</head>", '<script src="site.js"></script></head>', 1))
    for each in WORK.glob("formula_*.svg"):
        shutil.copy(each, OUT)
    warnings = (ROOT / "build/doxygen-warnings.log").read_text().splitlines()
    nowhere, bare = list(broken()), without_example()
    for kind, lines in (("doxygen", warnings), ("leads nowhere", nowhere), ("no example", bare)):
        for line in lines:
            print(f"{kind}: {line}")
    print(f"{len(names)} manuals, {len(list(OUT.glob('*.html')))} pages, {len(warnings)} warnings, {len(nowhere)} broken links, "
          f"{len(bare)} functions without an example")
    return bool(warnings or nowhere or bare)


if __name__ == "__main__":
    sys.exit(main())
