"""Pictures: that each is drawn, of what it says."""
import pathlib
import subprocess
import sys

import numpy as np
import pytest
import wrc

ROOT = pathlib.Path(__file__).resolve().parents[3]
DATA = dict(load={"normal_force": 80e3}, creepage={"longitudinal": 1e-3, "spin": 0.3}, friction={"coefficient": 0.35})


@pytest.fixture(scope="module")
def contact():
    return wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()


def test_contact(contact, tmp_path):
    contact.planar_step(wrc.PlanarInput(**DATA))
    figure = wrc.plot.contact(contact, tmp_path / "contact.png")
    assert (tmp_path / "contact.png").stat().st_size > 20000
    titles = [each.get_title() for each in figure.axes[:4]]
    assert titles[0].startswith("pressure") and not any("not computed" in each for each in titles)


def test_nothing_to_draw_is_said(contact):
    contact.planar_step(wrc.PlanarInput(load={"prescribed": "APPROACH", "approach": -1e-3}))
    with pytest.raises(ValueError, match="nothing to draw: .*do not touch"):
        wrc.plot.contact(contact)
    with pytest.raises(ValueError, match="call wrench"):
        wrc.plot.contact(wrc.Model(wheel="S1002", rail="60E1").contact())


def test_profiles_and_curves(contact, tmp_path):
    y, z, _ = contact.model.profile("WHEEL")
    own = wrc.ProfileFile(y - 0.75, z, "wheel", "own")
    assert wrc.plot.profile(own, own.mirrored()).axes[0].lines[0].get_xydata()[0, 0] == pytest.approx(1e3 * (y[0] - 0.75))
    figure = wrc.plot.wheel_on_rail(contact, wrc.WheelInput(wheel={"y": 6.5e-3, "z": 8e-4}), tmp_path / "wheel.png")
    assert "kN" in figure.axes[0].get_title()
    contact.wrench(wrc.WheelInput(wheel={"y": 5e-3, "z": 8e-4, "velocity": (40, 0, 0), "pitch_rate": -40 / 0.46}))
    assert wrc.plot.regions(contact, tmp_path / "regions.png").axes[0].get_title() == "pressure [MPa]"
    rows = wrc.plot.regions(contact).axes[0].lines
    assert len(rows) == contact.wrench(wrc.WheelInput(wheel={"y": 5e-3, "z": 8e-4})).region_count
    rough = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK", preset="FASTSIM-SDEC").contact()
    figure = wrc.plot.creep_curves({"strip FASTSIM": contact, "FASTSIM-SDEC": rough}, wrc.PlanarInput(**DATA), path=tmp_path / "curves.png")
    first, second = (each.get_ydata() for each in figure.axes[0].lines[:2])
    assert 0.9 < first[-1] <= 1.0001 and abs(first - second).max() < 0.2
    with pytest.raises(ValueError, match="none of longitudinal"):
        wrc.plot.creep_curve(contact, "sideways", [0.0], wrc.PlanarInput(**DATA))
    wrc.plot.model(contact.model, tmp_path / "model.png")


def test_the_package_does_without_matplotlib():
    code = "import sys; sys.modules['matplotlib'] = None; import wrc\ntry: wrc.plot.figure()\nexcept ImportError as why: print(why)"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert "pip install wrc[plot]" in found.stdout, found.stderr


def test_panels_on_axes_of_the_caller(tmp_path):
    model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40})
    contact = model.contact("LEFT")
    data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3, wheel={"y": -5.2e-3, "velocity": (20, 0, 0), "pitch_rate": -20 / 0.46})
    contact.wrench(data)
    figure = wrc.plot.figure(figsize=(14, 8))
    panels = figure.subplots(2, 2)
    assert wrc.plot.field(contact, "TEMPERATURE_RISE", axes=panels[0, 0]) is figure
    wrc.plot.subsurface(contact, axes=panels[0, 1])
    wrc.plot.wheel_on_rail(contact, data, axes=panels[1, 0])
    wrc.plot.scan(model, [-5.2e-3, 0.0], side="LEFT", axes=panels[1, 1])
    figure.savefig(tmp_path / "panels.png")
    fans = [each.get_xy() for each in panels[1, 0].patches if each.get_xy().shape[0] > 10]
    assert len(fans) == len(contact.regions()) == 2
    rail = panels[1, 0].lines[0].get_xydata()
    for fan in fans:  # their feet are on the rail, their tips below it
        feet = fan[:len(fan) // 2]
        assert abs(np.interp(feet[:, 0], *rail[np.argsort(rail[:, 0])].T) - feet[:, 1]).max() < 1e-3 and fan[:, 1].max() > feet[:, 1].max()
    offsets = panels[1, 1].collections[0].get_offsets()
    assert set(offsets[:, 1]) == {-5.2, 0.0} and offsets[:, 0].max() < 20
    deepest = panels[0, 1].lines[0].get_xydata()
    assert deepest[:, 0].max() > 500 and deepest[-1, 1] == pytest.approx(10.0)
    with pytest.raises(wrc.Error, match="nothing has been solved yet"):
        wrc.plot.field(model.contact(), "PRESSURE")


def test_an_animation(tmp_path):
    contact = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}).contact()
    inputs = [wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3, wheel={"y": each}) for each in (0.0, 3e-3, 6e-3)]
    wrc.plot.animation(contact, inputs, tmp_path / "scan.gif", titles=["0", "3", "6 mm"])
    from PIL import Image
    with Image.open(tmp_path / "scan.gif") as picture:
        assert picture.n_frames == 3


def test_smoothing_draws_differences():
    nominal = wrc.Model(wheel="S1002", rail="60E1")
    y, z, _ = nominal.profile("WHEEL")
    lower = wrc.Model(wheel=wrc.Profile(y=y - 0.75, z=z + 20e-6 * np.cos(100 * (y - 0.75))), rail="60E1")
    axes = wrc.plot.figure().subplots()
    wrc.plot.smoothing({"nominal": nominal, "waves": lower}, axes=axes)
    at, height = axes.lines[0].get_xydata().T
    assert np.abs(height - 20 * np.cos(0.1 * (at - 750))).max() < 1e-6
    with pytest.raises(ValueError, match="two or more"):
        wrc.plot.smoothing({"nominal": nominal})


def test_non_steady_rolling():
    contact = wrc.Model(wheel="S1002", rail="60E1", planar={"non_steady": 1}).contact()
    contact.planar_geometry(wrc.PlanarPose())
    contact.planar_normal(wrc.PlanarLoad(normal_force=80e3))
    axes = wrc.plot.figure().subplots()
    wrc.plot.non_steady(contact, [wrc.Creepage(longitudinal=1e-3)] * 60, 0.5e-3, axes=axes)
    distance, force = axes.lines[0].get_xydata().T
    assert distance[-1] == pytest.approx(30.0) and np.all(np.diff(force) <= 1e-6) and force[-1] < 5 * force[0] < 0


def test_signs(tmp_path):
    figure = wrc.plot.signs(path=tmp_path / "signs.png")
    longitudinal, lateral, _ = (each.get_title() for each in figure.axes[:3])
    assert "Fx -" in longitudinal and "Fy -" in lateral
    slide, traction = (each for each in figure.axes[0].collections)
    assert np.all(slide.V > 0) and np.all(traction.V < 0)


def test_a_wheelset_through_a_curve(tmp_path):
    sys.path.insert(0, str(ROOT / "bindings/python/examples/curve"))
    import curve
    states = curve.main(tmp_path / "curve.gif", 6)
    assert states[0][:2] == pytest.approx([0, 0], abs=2e-5)
    assert -7e-3 < states[-1][0] < -4e-3 and states[-1][1] < -1e-3  # its left flange guides, its nose points out of the curve
    from PIL import Image
    with Image.open(tmp_path / "curve.gif") as picture:
        assert picture.n_frames == 6
