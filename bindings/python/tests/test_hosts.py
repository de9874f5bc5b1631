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


def numbers(pattern, told):
    return [float(each) for each in re.search(pattern, told).groups()]


def test_a_wheelset_that_remembers_stops_rests_and_rolls_off():
    told = run("memory/parked.py", "--parked", 2)
    turns, = numbers(r"turns of its speed afterwards: (\d+)", told)
    force, weight, creeps = numbers(r"parked with (\S+) N \((\S+) N of weight\); creeps (\S+) um", told)
    off, stands = numbers(r"rolls off to (\S+) m/s, and stops again with (\S+) m/s", told)
    assert turns < 5 and creeps < 1e-3
    assert force == pytest.approx(weight, rel=1e-4)
    assert off < -0.5 and abs(stands) < 1e-9


def test_a_vehicle_that_remembers_rests_on_a_slope_and_its_energies_balance():
    told = run("memory/vehicle.py", "--short")
    drifts = []
    for name in ("memory", "without"):
        chatters, drift = numbers(rf"{name}: stop 1 .*, (\d+) chatters; .* it drifts (\S+) um", told)
        failed, most = numbers(rf"{name}: \d+ steps, (\d+) failed; .*, most (\d+);", told)
        work, heat, left = numbers(rf"{name}: kinetic .* contact (\S+) \(heat (\S+)\), .* left over (\S+) J", told)
        assert chatters == failed == 0 and most < 30 and abs(left) < 1e-8
        assert 0.0 < heat < -1.0001 * work  # friction takes no more than the contacts get; they store the rest
        drifts.append(abs(drift))
    assert drifts[0] < 0.02 and 0.5 < drifts[1]


def test_a_locked_wheel_draws_mindlins_loop():
    told = run("memory/parking_brake.py", "--cells", 20)
    rows = re.findall(r"loss of a loop +\S+ mJ, closed form +\S+ \((\S+) %\), exact cells +\S+ \((\S+) %\); first loading within (\S+) %", told)
    assert len(rows) == 3
    for loss, exact, loading in np.array(rows, float):
        assert abs(loss) < 10.0 and abs(exact) < 3.0 and loading < 1.0


def test_forces_on_corrugation_follow_as_exact_contact_does():
    told = run("memory/corrugation.py", "--short")
    remembered = numbers(r"creepage +200 km/h, wave +20.0 mm = +2.0 patches: force (\S+) of steady rolling .* lags by +(\S+) degrees", told)
    exact = numbers(r"exact .* force (\S+) of steady rolling .* lags by +(\S+) degrees", told)
    long, lag = numbers(r"height +200 km/h, wave 100.0 mm = 10.2 patches: force (\S+) of steady rolling .* lags by +(\S+) degrees", told)
    assert remembered[0] == pytest.approx(exact[0], abs=0.03) and remembered[1] == pytest.approx(exact[1], abs=4.0)
    assert 0.85 < long < 1.0 and 10.0 < lag < 30.0


def test_a_commit_for_each_step_that_cvode_accepts():
    pytest.importorskip("sksundae")
    for tolerance, within, most in ((1e-4, 2e-3, {"memory": 800, "without": 600}), (1e-7, 1e-4, {"memory": 6000, "without": 1000})):
        told = run("memory/cvode.py", "--seconds", 5, "--tolerance", tolerance)
        for name in most:
            steps, stops, back, newton = numbers(rf"(?m)^{name}: (\d+) steps, .* stops after (\S+) m.*\n  (\d+) steps taken back, (\d+) by Newton", told)
            assert steps < most[name] and stops == pytest.approx(2.4304, abs=within)
            assert back < 0.08 * steps and newton < 10
        rests, = numbers(r"(?m)^memory: .* in the last second it moves (\S+) um", told)
        jump, = numbers(r"largest jump of the force in them (\S+) of friction x load", told)
        assert abs(rests) < 1.0 and jump < 1e-5


@pytest.mark.parametrize("step", [0.9, 0.98, 1, 1.02])  # ms
def test_a_commit_before_each_step_of_exudyn(step):
    pytest.importorskip("exudyn")
    told = run("memory/exudyn_loop.py", "--seconds", 0.1, "--step", step)
    iterations, = numbers(r"memory: no step failed, (\S+) Newton iterations per step", told)
    assert iterations < 3.0
