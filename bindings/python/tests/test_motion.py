"""First tries of a wheel's motion: the right force, or a sentence. S1002 on 60E1 at 1:40, 80 kN, 20 m/s, nose 5 mrad to the right."""
import numpy as np
import pytest

import wrc

YAW, ROLLING = 5e-3, -20 / 0.46
R = np.array([[np.cos(YAW), -np.sin(YAW), 0], [np.sin(YAW), np.cos(YAW), 0], [0, 0, 1]])  # track = R @ body


@pytest.fixture(scope="module")
def contact():
    return wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}).contact()


def wrench(contact, rail=None, **wheel):
    given = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3, friction={"coefficient": 0.35},
                           wheel={"velocity": (20, 0, 0), **wheel}, rail=rail or {})
    return contact.wrench(given)


def is_right(found):
    return found.force[1] == pytest.approx(24.84e3, abs=10) and found.power == pytest.approx(2779, abs=1)


def test_a_vector_of_no_axes_is_refused(contact):
    with pytest.raises(wrc.Error, match=r"WRC_AXES_TRACK \(components along x, y, z of the track\) or WRC_AXES_BODY"):
        wrench(contact, yaw=YAW, angular_velocity=(0, ROLLING, 0))
    assert is_right(wrench(contact, yaw=YAW, angular_velocity=(0, ROLLING, 0), angular_axes="BODY"))
    assert is_right(wrench(contact, yaw=YAW, angular_velocity=R @ (0, ROLLING, 0), angular_axes="TRACK"))


def test_the_pitch_rate_is_about_the_axle(contact):
    assert is_right(wrench(contact, yaw=YAW, pitch_rate=ROLLING))
    with pytest.raises(wrc.Error, match="not both"):
        wrench(contact, yaw=YAW, pitch_rate=ROLLING, angular_velocity=(0, ROLLING, 0), angular_axes="BODY")


def test_a_rotation_says_its_order(contact):
    with pytest.raises(wrc.Error, match="WRC_ORIENTATION_ROWS"):
        wrench(contact, rotation=R, pitch_rate=ROLLING)
    assert is_right(wrench(contact, rotation=R, orientation="ROWS", pitch_rate=ROLLING))
    assert is_right(wrench(contact, rotation=R.T, orientation="COLUMNS", pitch_rate=ROLLING))
    turning = {"angular_velocity": R @ (0, ROLLING, 0), "angular_axes": "TRACK"}
    assert contact.status == 0
    wrench(contact, rotation=R.T, orientation="ROWS", **turning)
    assert contact.status == wrc.Status.FLAG_ROTATION_TRANSPOSED


def test_a_rail_aslant_is_at_rest(contact):
    straight, aslant = wrench(contact, pitch_rate=ROLLING), wrench(contact, {"y_slope": 1e-3}, pitch_rate=ROLLING)
    assert aslant.force[1] == pytest.approx(straight.force[1], abs=50)
    moved = wrench(contact, {"y_velocity": 20e-3}, pitch_rate=ROLLING)  # another thing: its material moves
    assert moved.force[1] > straight.force[1] + 10e3
