"""Type checkers on programs that use the package: mistakes are found where they stand, right programs pass."""
import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[3]
RIGHT = '''
from typing import List

import numpy as np
import wrc

config = wrc.Config()
config.normal.method = "EKP"
config.normal.method = wrc.NormalMethod.EKP
config.rail.kind = "60E1"
config.track.rail_inclination = 1 / 40
method: wrc.NormalMethod = config.normal.method
model = wrc.Model(config, preset="FASTSIM-SDEC", wheel="S1002", track={"rail_inclination": 0.025})
contact = model.contact("LEFT")
data = wrc.WheelInput(wheel={"z": 1e-3, "velocity": (20, 0, 0)}, prescribed="HEIGHT")
data.wheel.velocity = np.array([20.0, 0.0, 0.0])
wrench = contact.wrench(data)
force: float = float(wrench.force[1])
slender: bool = wrc.Flags.TABLE_RANGE in wrench.flags
regions: List[wrc.Region] = contact.regions()
pressure = contact.field("PRESSURE").max()
out = contact.planar_step(wrc.PlanarInput(load=wrc.PlanarLoad(normal_force=80e3), creepage={"longitudinal": 1e-3}))
total: float = out.forces.fx + out.damage.power
wheel = wrc.Model(wheel="S1002", preset="real time").contact()
data.friction = wrc.surface_friction(wrc.Band(9, 1.0).add("WATER", 0.02, 0.0, 9.0), None, wrc.surface_laws(), wrc.SurfacePassage())
'''
WRONG = '''config.normal.methd = "EKP"
config.normal.method = "EPK"
config.track.gauge = "1435"
out.forces.fxx
wrc.PlanarLoad(normalforce=80e3)
wrc.PlanarInput(creepge={})
wrc.PlanarInput(creepage={"longitudnal": 1e-3})
contact.field("PRESURE")
wrc.Model(wheel="S1002", track={"rail_inclinaton": 0.025})
wrc.Model(preset="FASTSIM-SDCE")
model.contact("MIDDLE")
data.wheel.velocity = 40.0
wrench.region_cout
regions[0].creepage.spinn
'''
CHECKERS = {"mypy": ["-m", "mypy", "--strict", "--no-error-summary", "--cache-dir"],
            "basedpyright": ["-m", "basedpyright", "--level", "error", "--pythonpath", sys.executable]}


def lines_found(checker, program):
    """Lines of a program that a checker has errors in, and what it prints."""
    pytest.importorskip(checker)
    options = CHECKERS[checker] + ([str(program.parent / "cache")] if checker == "mypy" else [])
    found = subprocess.run([sys.executable, *options, program], capture_output=True, text=True, cwd=program.parent)
    assert found.returncode in (0, 1), found.stdout + found.stderr
    return {int(each) for each in re.findall(rf"{program.name}:(\d+):.*error", found.stdout)}, found.stdout


@pytest.mark.parametrize("checker", CHECKERS)
def test_mistakes_are_found(checker, tmp_path):
    program = tmp_path / "program.py"
    program.write_text(RIGHT + WRONG)
    found, told = lines_found(checker, program)
    first = len(RIGHT.splitlines()) + 1
    assert found == set(range(first, first + len(WRONG.splitlines()))), told


@pytest.mark.parametrize("checker", CHECKERS)
def test_the_first_programs_pass(checker, tmp_path):
    pages = [ROOT / "bindings/python/README.md", ROOT / "docs/python.md"]
    pieces = [re.findall(r"^```python\n(.*?)^```", page.read_text(), re.M | re.S)[:2] for page in pages]
    program = tmp_path / "program.py"
    program.write_text("\n".join(pieces[0] + pieces[1]) + (ROOT / "bindings/python/examples/draw_contact.py").read_text())
    found, told = lines_found(checker, program)
    assert not found, told


def test_the_package_passes(tmp_path):
    pytest.importorskip("mypy")
    found = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path, ROOT / "bindings/python/wrc"], capture_output=True, text=True,
                           cwd=tmp_path)
    assert found.returncode == 0, found.stdout
