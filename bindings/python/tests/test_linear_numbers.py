"""Linear numbers of examples/linear_numbers: a cone on an arc, by the library and by hand."""
import pathlib
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "examples/linear_numbers"))
import linear_numbers


def test_a_cone_against_the_closed_form():
    found = linear_numbers.numbers(linear_numbers.contact_of("cone 1:20, 60E1 1:40").wrench)
    hand = linear_numbers.by_hand()
    klingel = 2.0 * np.pi * np.sqrt(linear_numbers.RADIUS * 0.75 / 0.05)
    assert hand["wave [m]"] == pytest.approx(klingel, rel=1e-3)
    assert found["wave [m]"] == pytest.approx(klingel, rel=0.03)
    for name in ("f11 [MN]", "f22 [MN]"):
        assert 0.85 * hand[name] < found[name] < hand[name]  # spin makes some slip
    assert found["bogie damping [1/s]"] == pytest.approx(hand["bogie damping [1/s]"], rel=0.1)
    assert found["gravity yaw [MN m]"] == pytest.approx(hand["gravity yaw [MN m]"], rel=0.05)


def test_derivatives_are_those_of_the_library():
    contact = linear_numbers.contact_of("S1002, 60E1 1:20")
    loaded = linear_numbers.state()
    loaded.prescribed, loaded.vertical_load = "VERTICAL_LOAD", linear_numbers.LOAD
    z = contact.wrench(loaded).z
    by = linear_numbers.derivatives(contact.wrench, z)
    _, slopes = contact.wrench_derivatives(linear_numbers.state(z))
    for name, column in (("y", 0), ("roll", 2), ("yaw", 3), ("vy", 5), ("vroll", 7), ("vpitch", 8), ("vyaw", 9)):
        wanted = slopes.wrench[:, column]
        assert np.allclose(by[name], wanted, atol=0.05 * np.abs(wanted).max()), name
