"""Films on rail and wheel: bands, their books, and the example's stories."""
import pathlib
import pickle
import re

import numpy as np
import pytest

import wrc

EXAMPLE = pathlib.Path(__file__).parents[1] / "examples" / "low_adhesion"
PRINTED = pathlib.Path(__file__).parents[3] / "tests" / "examples"


def passed():
    rail, tread = wrc.Band(50, 1.0, first=-5.0), wrc.Band(24, 2.89 / 24, closed=True)
    rail.add("FILM", 0.01, 0.0, 30.0).add("WATER", 0.02, 0.0, 40.0)
    laws = wrc.surface_laws("low adhesion", ambient=5.0)
    moved = wrc.surface_pass(rail, tread, laws, wrc.SurfacePassage(rail_from=1.0, rail_to=21.0, wheel_from=0.0, wheel_to=18.0, energy=9e3))
    return rail, tread, laws, moved


def test_books_balance():
    rail, tread, laws, moved = passed()
    for quantity in wrc.SurfaceQuantity:
        gone = sum(rail.total(quantity, book) for book in ("REMOVED", "SQUEEZED", "EVAPORATED", "CARRIED"))
        assert rail.total(quantity) + gone == pytest.approx(rail.total(quantity, "PUT_ON"), rel=1e-12, abs=1e-300)
        assert rail.total(quantity, "CARRIED") == -tread.total(quantity, "CARRIED")
    assert moved.rail_energy + moved.wheel_energy == pytest.approx(9e3, rel=1e-12)
    assert rail.total("FILM") == pytest.approx(rail.values("FILM").sum() * rail.struct.length * rail.struct.width, rel=1e-12)
    assert rail.places[0] == -4.5 and laws.ambient == 5.0
    tread.rest(laws, 1e6)
    assert tread.total("HEAT") < 1e-3


def test_bands_are_pickled_and_merged():
    rail, *_ = passed()
    copy = pickle.loads(pickle.dumps(rail))
    assert bytes(copy._bins) == bytes(rail._bins) and "50 x 1 m" in repr(copy)
    copy.merge(rail)
    assert copy.total("FILM") == 2.0 * rail.total("FILM")


def test_rows_across():
    rail, tread = wrc.Band(6, 1.0, width=6e-3, rows=10, row_first=-0.037), wrc.Band(24, 2.89 / 24, width=6e-3, closed=True, rows=10, row_first=-0.043)
    rail.row(0).add("LUBRICANT", 0.05, 1.0, 5.0)
    grease = rail.values("LUBRICANT")
    assert grease.shape == (10, 6) and grease[0, 2] == pytest.approx(0.05) and not grease[1:].any()
    assert pickle.loads(pickle.dumps(rail)).values("LUBRICANT")[0, 2] == grease[0, 2]
    with pytest.raises(IndexError, match="row 10 of 10"):
        rail.row(10)
    contact, laws = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}).contact(), wrc.surface_laws()
    data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=60e3, wheel={"velocity": (20.0, 0.0, 0.0), "pitch_rate": -20.0 / 0.46 * 0.95})
    step, friction = wrc.SurfacePassage(rail_from=3.0, rail_to=3.5, wheel_to=0.5), {}
    for shift in (0.0, 6.8e-3):  # tread and flange
        data.wheel.y = shift
        data.friction = wrc.surface_friction(rail, tread, laws, step)
        wrench = contact.wrench(data)
        friction[shift] = -wrench.force[0] / wrench.normal_force
    assert friction[0.0] == pytest.approx(0.3, abs=1e-3) and 0.08 < friction[6.8e-3] < 0.2
    with pytest.raises(wrc.Error, match="contact"):
        wrc.surface_pass(rail, tread, laws, step)
    step.energy = 100.0
    wrc.surface_pass(rail, tread, laws, step, contact)
    assert tread.total("LUBRICANT") > 0.0 and rail.total("LUBRICANT", "CARRIED") == -tread.total("LUBRICANT", "CARRIED")


def test_a_sentence_says_why():
    rail, tread, laws, _ = passed()
    with pytest.raises(wrc.Error, match="a source puts on"):
        rail.add("WATER", -1.0, 0.0, 1.0)
    with pytest.raises(wrc.Error, match="low adhesion"):
        wrc.surface_laws("wet")
    with pytest.raises(wrc.Error, match="no area"):
        wrc.Band(3, 1.0, width=0.0).add("WATER", 1e-3, 0.0, 1.0)


@pytest.fixture
def example(monkeypatch):
    monkeypatch.syspath_prepend(str(EXAMPLE))
    import low_adhesion

    return low_adhesion


def printed(story):
    """Numbers that examples_c/low_adhesion.c prints of a story, as its test has them."""
    return [float(each) for each in re.findall(r"\d+\.?\d*", (PRINTED / f"low_adhesion_{story}.txt").read_text())]


def test_the_first_axles_clean_for_the_last(example, tmp_path):
    bare = example.stop(12.0, cars=1)
    mean = bare.mean_adhesions()
    assert mean[1] > 1.1 * mean[0] and mean[3] > 1.1 * mean[2] and 0.03 < mean[0] < 0.1  # in each bogie
    booked = bare.rail.total("HEAT", "PUT_ON") + sum(axle.tread.total("HEAT", "PUT_ON") for axle in bare.axles)
    assert booked == pytest.approx(sum(axle.energy for axle in bare.axles), rel=1e-12)
    example.draw_runs({"without sand": bare}).savefig(tmp_path / "stop.png")


def test_sand_helps_a_stop(example):
    train = example.stop(12.0, sand=True, cars=1)
    mean = train.mean_adhesions()  # the first bogie, without sand, stops on a way of its own
    assert train.place < train.axles[2].behind and mean[2] > 1.3 * mean[0] and mean[3] > 1.3 * mean[1]


def test_traction_climbs_to_more_adhesion(example, tmp_path):
    train, wishes, pulls = example.traction(seconds=4)
    assert 1e-3 * pulls[1] == pytest.approx(printed("traction")[0], abs=0.51)  # the numbers agree with those of C
    assert wishes == pytest.approx([0.04, 0.05, 0.06, 0.07]) and pulls[1] < pulls[2] < pulls[3]
    ends = [axle.force / train.load for axle in train.axles]
    assert ends == sorted(ends) and [train.slip(axle) for axle in train.axles] == pytest.approx([wishes[-1]] * 4, abs=0.01)
    example.draw_traction(train).savefig(tmp_path / "traction.png")


def test_sand_helps_a_start(example, tmp_path):
    bare, sanded = example.start(seconds=5.0), example.start(sand=True, seconds=5.0)  # 3 s on its brakes, sanders 0.3 m ahead
    adhesions = bare.mean_adhesions(), sanded.mean_adhesions()
    assert sanded.speed > bare.speed > 0.1
    assert (adhesions[1][::3] > 1.1 * adhesions[0][::3]).all()  # these have the sanders; no other axle has come to the sand
    assert adhesions[1][[1, 2, 4, 5]] == pytest.approx(adhesions[0][[1, 2, 4, 5]], rel=0.02)
    example.draw_runs({"without": bare, "with": sanded}).savefig(tmp_path / "start.png")


def test_the_curve_comes_back_higher(example, tmp_path):
    rig = example.curve()
    found = example.at_half(rig)
    assert found == pytest.approx(printed("curve")[1:], abs=0.00051)
    assert (np.diff(found) > 0.0).all()
    example.draw_curve(rig).savefig(tmp_path / "curve.png")


def test_grease_goes_from_the_gauge_corner_to_the_tread(example, tmp_path):
    rail, places, shifts, powers = example.lubricator(axles=9)
    grease = rail.values("LUBRICANT")
    assert (grease[1:3, 30] > 1e-6).all() and grease[1, 30] > grease[2, 30] > grease[4, 30] and grease[:, 0].max() < 1e-9
    assert powers[8, places > 35.0].mean() < 0.9 * powers[0, places > 35.0].mean()  # the ninth axle finds grease 30 m on
    example.draw_lubricator((rail, places, shifts, powers)).savefig(tmp_path / "lubricator.png")
