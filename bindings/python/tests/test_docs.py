"""The manual's pieces of Python, one after the other, as they stand there."""
import json
import pathlib
import re
import time

import numpy as np
import pytest
import wrc
from test_sections import rails
from test_profiles import rows, shapes  # noqa: F401

ROOT = pathlib.Path(__file__).parents[3]


def pieces(page):
    return re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(), re.M | re.S)


def test_the_manual(shapes, tmp_path, monkeypatch):  # noqa: F811
    monkeypatch.chdir(tmp_path)
    wheel, rail = shapes
    pathlib.Path("worn.whl").write_text(rows(wheel * [1, -1]))
    pathlib.Path("rail.txt").write_text(rows(rail))
    wrc.write_sections("crossing.slcs", rails.crossing())
    x, y = wrc.exact.cells(wrc.exact.grid(64, 64, 2e-4))
    known = {"np": np, "gap": (x ** 2 + y ** 2) / 0.5}
    found = pieces("docs/python.md")
    assert len(found) >= 5
    for each in found:
        exec(compile(each.replace("100_000", "200"), "docs/python.md", "exec"), known)
    assert not known["statuses"].any() and pathlib.Path("contact.png").exists() and pathlib.Path("wheel.png").exists()


def test_readme_prints_what_it_says(capsys):
    program, = pieces("README.md")
    exec(compile(program, "README.md", "exec"), {})
    printed = capsys.readouterr().out.splitlines()
    assert len(printed) == 2 and all(f"    {each}\n" in (ROOT / "README.md").read_text() for each in printed)


def test_the_packages_own_page(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for each in pieces("bindings/python/README.md"):
        exec(compile(each, "README.md", "exec"), {})
    assert pathlib.Path("contact.png").exists()


def test_the_tutorial(tmp_path, monkeypatch):
    """Every piece in its order, within a minute; it draws the pictures that the page shows."""
    monkeypatch.chdir(tmp_path)
    known = {}
    start = time.monotonic()
    for each in pieces("docs/tutorial.md"):
        exec(compile(each, "docs/tutorial.md", "exec"), known)
    assert time.monotonic() - start < 60.0
    shown = set(re.findall(r"\(pictures/(tutorial_\w+\.png)\)", (ROOT / "docs/tutorial.md").read_text()))
    assert shown == {each.name for each in tmp_path.glob("tutorial_*.png")} and len(shown) >= 7
    assert all((ROOT / "docs/pictures" / each).exists() for each in shown)
    assert known["solution"].peak_pressure == pytest.approx(1.5 * 20e3 / (np.pi * known["radius"] ** 2), rel=1e-3)


def test_the_gallery(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    known = {}
    for each in pieces("docs/gallery.md"):
        exec(compile(each, "docs/gallery.md", "exec"), known)
    shown = set(re.findall(r"\(pictures/(gallery_\w+\.png)\)", (ROOT / "docs/gallery.md").read_text()))
    assert shown == {each.name for each in tmp_path.glob("gallery_*.png")} and len(shown) >= 4
    assert all((ROOT / "docs/pictures" / each).exists() for each in shown)


def test_the_notebook_has_the_tutorials_pieces(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "tools/site"))
    import notebook
    made = json.loads(notebook.notebook((ROOT / "docs/tutorial.md").read_text()))
    assert ["".join(each["source"]) + "\n" for each in made["cells"] if each["cell_type"] == "code"] == pieces("docs/tutorial.md")
    assert not any("pictures/" in line for each in made["cells"] for line in each["source"])
