"""The manual's pieces of Python, one after the other, as they stand there."""
import pathlib
import re

import numpy as np
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


def test_the_packages_own_page(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for each in pieces("bindings/python/README.md"):
        exec(compile(each, "README.md", "exec"), {})
    assert pathlib.Path("contact.png").exists()
