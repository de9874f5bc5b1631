#!/usr/bin/env python3
"""A page as a notebook: its pieces of Python are cells that run, its text the cells between them. Pictures are left out: cells draw them.

    tools/site/notebook.py docs/tutorial.md [tutorial.ipynb]"""
import json
import pathlib
import re
import sys


def notebook(text):
    """The page's text in the notebook format, 4.5."""
    cells = []
    for k, part in enumerate(re.split(r"^```python\n(.*?)^```\n", text, flags=re.M | re.S)):
        part = part if k % 2 else re.sub(r"^!\[.*\n+", "", part, flags=re.M)
        if not part.strip():
            continue
        cell = {"id": f"cell{len(cells)}", "cell_type": "code" if k % 2 else "markdown", "metadata": {}, "source": part.strip().splitlines(keepends=True)}
        cells.append(cell | ({"execution_count": None, "outputs": []} if k % 2 else {}))
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    return json.dumps({"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}, indent=1, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    page = pathlib.Path(sys.argv[1])
    target = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(page.stem + ".ipynb")
    target.write_text(notebook(page.read_text()))
    print(target)
