"""The example hosts, run as a user runs them, with the installed package."""
import pathlib
import re
import runpy
import subprocess
import sys

import numpy as np
import pytest

EXAMPLES = pathlib.Path(__file__).parents[1] / "examples"


def run(program, *arguments):
    found = subprocess.run([sys.executable, EXAMPLES / program, *map(str, arguments)], capture_output=True, text=True)
    assert found.returncode == 0, found.stdout + found.stderr
    return found.stdout


@pytest.fixture(scope="module")
def exudyn(tmp_path_factory):
    pytest.importorskip("exudyn")
    rows = tmp_path_factory.mktemp("exudyn") / "rows.csv"
    told = run("exudyn/wheelset_exudyn.py", "--seconds", 0.06, "--full", "--rows", rows)
    assert float(re.search(r"(\S+) Newton iterations", told).group(1)) < 2.1
    return np.genfromtxt(rows, delimiter=",")


@pytest.mark.parametrize("method", ["Radau", "BDF"])
def test_scipy_with_the_analytic_jacobian_and_exudyn_agree(method, exudyn, tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["scipy", "--method", method, "--seconds", "0.06", "--rows", str(tmp_path / "rows.csv")])
    monkeypatch.syspath_prepend(str(EXAMPLES))
    scipy = runpy.run_path(str(EXAMPLES / "scipy/wheelset_scipy.py"))
    rows = np.genfromtxt(tmp_path / "rows.csv", delimiter=",")
    assert rows[:, 0] == pytest.approx(exudyn[:, 0])
    assert np.abs(exudyn[:, 2]).max() > 1e-6
    assert rows[:, 2] == pytest.approx(exudyn[:, 2], abs=2e-8)
    wheelset = scipy["wheelset"]
    lateral = [[(wheelset.forces(each[0], each[1:7], each[7:13]), wheelset.out["force"][0, 1])[1] for each in (host[10::10])]
               for host in (rows, exudyn)]
    assert lateral[0] == pytest.approx(lateral[1], abs=20.0)
    for row in rows[20::20] if method == "Radau" else []:  # the Jacobian against central differences
        exact = scipy["jacobian"](row[0], row[1:])
        steps = np.diag(np.repeat([1e-9, 1e-6], 6))
        differences = np.array([(scipy["rates"](row[0], row[1:] + h) - scipy["rates"](row[0], row[1:] - h)) / (2 * h.max()) for h in steps]).T
        assert np.max(np.abs(exact - differences) / np.abs(exact).max(axis=1, keepdims=True)) < 3e-3


@pytest.mark.parametrize("folder", ["exudyn", "scipy"])
def test_each_host_is_short_and_told(folder):
    files = [EXAMPLES / "wheelset.py", *(EXAMPLES / folder).glob("*.py")]
    assert len(files) == 2 and sum(len(each.read_text().splitlines()) for each in files) <= 100
    assert (EXAMPLES / folder / "README.md").exists()
