"""Friction by name, and fits of creep curves."""
import math

import numpy as np
import pytest
import wrc

ELLIPSE = wrc.Ellipse(a=6e-3, b=5e-3, normal_force=80e3)


@pytest.fixture(scope="module")
def polach():
    return wrc.Model(preset="Polach").contact()


def curve(contact, law, slip, speed):
    forces = [contact.planar_tangential(wrc.Creepage(longitudinal=s, speed=v), law, ELLIPSE) for s, v in zip(slip, speed)]
    return np.array([-each.fx / each.fn for each in forces])


def test_friction_by_name():
    assert len(wrc.frictions()) == 7 and all(source and status for source, status in wrc.frictions().values())
    wet = wrc.use(wrc.Friction(), "polach WET")
    assert (wet.coefficient, wet.fall_rate, wet.adhesion_reduction, wet.slip_reduction) == (0.3, 0.2, 0.3, 0.1)
    assert wrc.use(wrc.Friction(), "MoS2").layer_yield == 20e6
    with pytest.raises(wrc.Error, match='"Polach dry" "Polach wet"'):
        wrc.use(wrc.Friction(), "snow")


def test_a_noisy_curve_gives_the_law_back_within_its_spread(polach, tmp_path):
    slip, speed = np.tile(np.geomspace(5e-4, 0.4, 16), 3), np.repeat([2.0, 10.0, 30.0], 16)
    wet = wrc.use(wrc.Friction(), "Polach wet")
    exact = curve(polach, wet, slip, speed)
    names = ("coefficient", "kinetic_ratio", "fall_rate", "adhesion_reduction", "slip_reduction")
    told = []
    fit = wrc.fit_creep_curve(polach, slip, exact * np.random.default_rng(3).normal(1.0, 0.05, 48), speed, 80e3, ellipse=ELLIPSE,
                              friction="Polach dry", parameters=names, progress=told.append)
    assert fit.status is wrc.Status.OK and told == sorted(told) and list(fit.parameters) == list(names)
    for name, each in fit.parameters.items():
        assert each.determined and each.low < each.value < each.high
        assert abs(each.value - getattr(wet, name)) < 3 * each.deviation and getattr(fit.friction, name) == each.value
    assert fit.covariance.shape == (5, 5) and fit.covariance[0, 0] == pytest.approx(fit.parameters["coefficient"].deviation ** 2)
    assert 0.04 < fit.scatter < 0.065
    assert fit.adhesion(slip[:2], 2.0) == pytest.approx(fit.fitted[:2])
    figure = wrc.plot.figure()
    axes = figure.subplots()
    assert wrc.plot.creep_fit(fit, axes=axes) is figure and len(axes.lines) == 6
    wrc.plot.creep_fit(fit, path=tmp_path / "fit.png")
    assert (tmp_path / "fit.png").stat().st_size > 10000


def test_parameters_that_the_curve_does_not_determine(polach):
    slip = np.geomspace(1e-4, 1e-3, 12)  # nothing slides fast: no fall of friction to be seen
    measured = curve(polach, wrc.Friction(), slip, np.full(12, 1.0)) * np.random.default_rng(1).normal(1.0, 0.05, 12)
    fit = wrc.fit_creep_curve(polach, slip, measured, 1.0, 80e3, ellipse=ELLIPSE,
                              friction="Polach dry", parameters=("coefficient", "kinetic_ratio", "slip_reduction", "adhesion_reduction"))
    assert not fit.parameters["kinetic_ratio"].determined and math.isinf(fit.parameters["kinetic_ratio"].deviation)
    assert "not determined" in repr(fit)


def test_sentences(polach):
    fit = {"speed": 10.0, "load": 80e3, "ellipse": ELLIPSE, "friction": "Polach wet", "parameters": ("coefficient",)}
    slip, adhesion = np.geomspace(5e-4, 0.4, 16), np.full(16, 0.2)
    for changed, words in (((slip[:3], adhesion[:3]), "three points more"), ((100 * slip, adhesion), "per cent"),
                           ((-slip, adhesion), "amounts"), ((np.where(slip > 0.1, np.nan, slip), adhesion), "slip")):
        with pytest.raises(wrc.Error, match=words):
            wrc.fit_creep_curve(polach, *changed, **fit)
    with pytest.raises(wrc.Error, match="WRC_CREEP_LAYER_YIELD"):
        wrc.fit_creep_curve(polach, slip, adhesion, **{**fit, "parameters": ("layer_yield",)})
    with pytest.raises(wrc.Cancelled):
        wrc.fit_creep_curve(polach, slip, adhesion, **fit, progress=lambda fraction: True)
    with pytest.raises(ValueError):
        wrc.fit_creep_curve(polach, slip, adhesion[:5], **fit)
