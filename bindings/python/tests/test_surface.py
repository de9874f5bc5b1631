"""Films on rail and wheel: bands, their books, and the example that stops on wet leaves."""
import pathlib
import pickle

import numpy as np
import pytest

import wrc

EXAMPLE = pathlib.Path(__file__).parents[1] / "examples" / "low_adhesion"


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


def test_a_sentence_says_why():
    rail, tread, laws, _ = passed()
    with pytest.raises(wrc.Error, match="a source puts on"):
        rail.add("WATER", -1.0, 0.0, 1.0)
    with pytest.raises(wrc.Error, match="low adhesion"):
        wrc.surface_laws("wet")
    with pytest.raises(wrc.Error, match="no area"):
        wrc.Band(3, 1.0, width=0.0).add("WATER", 1e-3, 0.0, 1.0)


def test_the_first_axles_clean_for_the_last(monkeypatch, tmp_path):
    monkeypatch.syspath_prepend(str(EXAMPLE))
    import low_adhesion

    place, time, energy, lines, rail, axles = low_adhesion.stop(14.0)
    mean = lines[:, 2:].mean(axis=0)
    assert mean[1] > 1.1 * mean[0] and mean[3] > 1.1 * mean[2] and 0.03 < mean[0] < 0.1  # in each bogie
    booked = rail.total("HEAT", "PUT_ON") + sum(axle.tread.total("HEAT", "PUT_ON") for axle in axles)
    assert booked == pytest.approx(0.5 * energy.sum(), rel=1e-12)
    with_sand = low_adhesion.stop(14.0, sand=True)
    assert with_sand[0] < place
    low_adhesion.draw({"without": (place, time, energy, lines, rail, axles)}, tmp_path / "stop.png")
    assert np.isfinite(lines).all()
