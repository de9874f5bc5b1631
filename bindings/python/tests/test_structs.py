"""The generated structs: C memory with Python's manners."""
import copy
import gc
import pathlib
import pickle
import re

import numpy as np
import pytest
import wrc
from wrc import _interface


def test_comes_from_the_installed_wheel():
    assert "site-packages" in wrc.__file__
    assert pathlib.Path(wrc.force_table()).stat().st_size > 1e6
    assert pathlib.Path(wrc.__file__).with_name("py.typed").exists()


def test_defaults_are_the_librarys():
    config = wrc.Config()
    assert config.material.shear_modulus == 80e9 and config.normal.method is wrc.NormalMethod.STRIP_HALFSPACE
    assert wrc.Input().friction.coefficient == 0.3
    assert wrc.Forces().fx == 0.0


@pytest.mark.parametrize("name", sorted(_interface.STRUCTS))
def test_every_struct_is_told_shown_copied_and_an_array(name):
    kind = _interface.STRUCTS[name]
    one = kind()
    assert "Members:" in kind.__doc__ and all(each in kind.__doc__ for each in kind.members())
    assert repr(one).startswith(f"wrc.{kind.__name__}")
    assert one.copy() == one
    array = kind.array(3)
    assert array.shape == (3,) and bytes(array[1].tobytes()) == bytes(one)
    if name not in ("wrc_allocator",):
        assert pickle.loads(pickle.dumps(one)) == one


def test_docstrings_have_units_ranges_and_python_names():
    assert "lateral [m]: shift of the wheelset to the right (-0.1 .. 0.1; default 0)" in wrc.Pose.__doc__
    assert not re.search(r"\bwrc_contact_step\b", wrc.Contact.step.__doc__)
    assert "Contact.geometry" in wrc.Contact.creepages.__doc__


def test_unknown_members_are_refused():
    load = wrc.Load()
    with pytest.raises(AttributeError):
        load.normal_forse = 1.0
    with pytest.raises(AttributeError, match="did you mean normal_force"):
        wrc.Load(normal_forse=1.0)
    with pytest.raises(TypeError, match="wrc.Load or a dict"):
        wrc.Input(load=80e3)


def test_choices_by_member_number_and_name():
    config = wrc.Config()
    for given in (wrc.ProfileKind.PROFILE_60E1, 3, "60E1", "profile_60e1"):
        config.rail.kind = given
        assert config.rail.kind is wrc.ProfileKind.PROFILE_60E1
    with pytest.raises(ValueError, match="did you mean 'S1002'"):
        config.wheel.kind = "S1003"
    with pytest.raises(ValueError, match="choose 'NONE', 'POINTS'"):
        config.wheel.kind = "round"
    with pytest.raises(ValueError, match=r"read by wrc.read_profile\('worn.whl', body='wheel'\)"):
        config.set(wheel="worn.whl")
    assert wrc.Profile(y=[0.0, 1.0], z=[0.0, 0.0]).kind is wrc.ProfileKind.POINTS
    assert str(wrc.Side.LEFT) == "LEFT" and wrc.Forces(available=1).available == wrc.Available.TRACTIONS


def test_arrays_are_views():
    wheel = wrc.WheelInput().wheel
    velocity = wheel.velocity
    velocity[0] = 40.0
    assert wheel.velocity[0] == 40.0
    wheel.angular_velocity = (0, -87, 0)
    assert wheel.angular_velocity.tolist() == [0, -87, 0]
    assert wrc.WrenchSensitivities().wrench.shape == (6, len(wrc.WrenchInput))


def overwrite(size):
    """Gives memory of arrays of that size, where nothing holds it, to others."""
    gc.collect()
    for _ in range(200):
        np.full(size, 7.0)
    return [np.full(size, 7.0) for _ in range(200)]


def test_pointers_keep_their_arrays_and_count_them():
    config = wrc.Config()
    config.wheel.set(kind="POINTS", y=np.linspace(-0.06, 0.06, 50), z=np.zeros(50))
    overwrite(50)
    assert config.wheel.count == 50 and config.wheel.y[-1] == 0.06 and not config.wheel.z.any()
    other = copy.deepcopy(config)
    del config
    overwrite(50)
    assert other.wheel.y[0] == -0.06
    with pytest.raises(ValueError, match="set both at once"):
        other.wheel.y = np.zeros(3)
    with pytest.raises(ValueError, match="has 4 numbers and y has 3"):
        wrc.Profile(y=np.zeros(3), z=np.zeros(4))
    with pytest.raises(AttributeError, match="follows from the arrays"):
        other.wheel.count = 10 ** 6
    other.wheel.set(y=None, z=None)
    assert other.wheel.count == 0 and other.wheel.y is None
    with pytest.raises(ValueError, match="9 numbers, not 4"):
        wrc.WheelState(rotation=np.eye(2))
    for each in (lambda: [1.5], lambda: np.array([1.5]), lambda: np.array([[1.5, 2.5]]).T[:1, 0]):
        strips = wrc.Strips(y=each())
        overwrite(1)
        assert strips.y.tolist() == [1.5]
    frozen = np.zeros(9)
    frozen.flags.writeable = False
    assert wrc.WheelState(rotation=frozen).rotation.tolist() == 9 * [0]
    assert wrc.WheelState(rotation=np.eye(3)).rotation.tolist() == np.eye(3).ravel().tolist()


def test_arrays_of_structs_share_memory():
    inputs = wrc.Input.array(4, like=wrc.Input(load={"normal_force": 80e3}, friction={"zone_y": [0.0, 1e-3], "zone_coefficient": [0.1, 0.3]}))
    inputs["pose"]["lateral"] = [0, 1e-3, 2e-3, 3e-3]
    overwrite(2)
    second = wrc.Input.of(inputs, 2)
    assert second.pose.lateral == 2e-3 and second.load.normal_force == 80e3
    assert second.friction.zone_coefficients.tolist() == [0.1, 0.3]
    second.pose.lateral = 5e-3
    assert inputs["pose"]["lateral"][2] == 5e-3


def test_the_library_is_the_version_the_package_says():
    assert wrc.build_info().startswith(f"wrc {wrc.__version__},")


def test_errors_cross_processes():
    for error in (wrc.Error(-4, "too much"), wrc.Cancelled(-13, "stopped"), wrc.ProfileError("a.txt", 3, "is odd")):
        back = pickle.loads(pickle.dumps(error))
        assert type(back) is type(error) and str(back) == str(error) and vars(back) == vars(error)
        assert type(error).__module__ == "wrc"
