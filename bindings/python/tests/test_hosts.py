"""The example hosts, run as a user runs them, with the installed package."""
import pathlib
import re
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
    told = run("exudyn/wheelset_exudyn.py", "--seconds", 0.06, "--full", "--most", 3, "--rows", rows)
    assert "reached the end" in told
    return np.genfromtxt(rows, delimiter=",", names=True)


@pytest.mark.parametrize("method", ["Radau", "BDF"])
def test_scipy_with_the_analytic_jacobian_and_exudyn_agree(method, exudyn, tmp_path):
    told = run("scipy/wheelset_scipy.py", "--method", method, "--seconds", 0.06, "--rows", tmp_path / "rows.csv", *["--check"] * (method == "Radau"))
    assert "reached the end" in told and "Jacobian analytic" in told
    if method == "Radau":
        assert float(re.search(r"differences: at most (\S+)", told).group(1)) < 3e-3
    rows = np.genfromtxt(tmp_path / "rows.csv", delimiter=",", names=True)
    assert rows["t"] == pytest.approx(exudyn["t"])
    assert np.abs(exudyn["y"]).max() > 1e-6
    assert rows["y"] == pytest.approx(exudyn["y"], abs=2e-8)
    assert rows["y_right"] == pytest.approx(exudyn["y_right"], abs=20.0)


@pytest.mark.parametrize("folder", ["exudyn", "scipy"])
def test_each_host_is_short_and_told(folder):
    files = list((EXAMPLES / folder).glob("*.py"))
    assert files and sum(len(each.read_text().splitlines()) for each in files) <= 100
    assert (EXAMPLES / folder / "README.md").exists()
