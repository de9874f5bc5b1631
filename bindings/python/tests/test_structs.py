"""The generated structs: C memory with Python's manners."""
import copy
import gc
import pathlib
import pickle
import re

import numpy as np
import pytest
import wrc
from wrc import _interface, _renamed


def test_comes_from_the_installed_wheel():
    assert "site-packages" in wrc.__file__
    assert pathlib.Path(wrc.force_table()).stat().st_size > 1e6
    assert pathlib.Path(wrc.__file__).with_name("py.typed").exists()


def test_defaults_are_the_headers_and_the_librarys():
    config = wrc.Config()
    assert config.wheel_material.shear_modulus == 82e9 and config.normal.method is wrc.NormalMethod.STRIP_HALFSPACE
    assert wrc.PlanarInput().friction.coefficient == 0.3
    assert wrc.ConfigTrack(rail_inclination=0.025).gauge == 1.435 and wrc.HeatProperties().conductivity == 50  # without a C function
    initialised = 0
    for name, kind in _interface.STRUCTS.items():
        function = getattr(wrc.raw, name + "_init", None)
        if function is not None:
            one = kind.from_buffer(bytearray(len(bytes(kind()))))
            if hasattr(kind, "_struct_size"):
                one._struct_size = kind()._struct_size
            assert function(one) == 0 and bytes(one) == bytes(kind()), name
            initialised += 1
    assert initialised >= 15
    assert wrc.PlanarForces().fx == 0.0


@pytest.mark.parametrize("name", sorted(_interface.STRUCTS))
def test_every_struct_is_told_shown_copied_and_an_array(name):
    kind = _interface.STRUCTS[name]
    one = kind()
    assert "Members:" in kind.__doc__ and all(each in kind.__doc__ for each in kind.members())
    assert repr(one).startswith(f"wrc.{kind.__name__}")
    assert one.copy() == one
    array = kind.array(3)
    assert array.shape == (3,) and bytes(array[1].tobytes()) == bytes(one)
    columns = kind.table(array)
    for shown in (kind.__doc__, repr(one), str(one.as_dict()), " ".join(dir(one)), " ".join(columns)):
        assert not re.search(r"\breserved|struct_size|_size\b", shown)
    assert all(column.shape == (3,) for column in columns.values())
    assert all(each in dir(one) for each in kind.members())
    if name not in ("wrc_allocator",):
        assert pickle.loads(pickle.dumps(one)) == one


def test_docstrings_have_units_ranges_and_python_names():
    assert "lateral [m]: shift of the wheelset to the right (-0.1 .. 0.1; default 0)" in wrc.PlanarPose.__doc__
    assert not re.search(r"\bwrc_planar_step\b", wrc.Contact.planar_step.__doc__)
    assert "Contact.planar_geometry" in wrc.Contact.planar_creepages.__doc__


def test_unknown_members_are_refused():
    load = wrc.PlanarLoad()
    with pytest.raises(AttributeError):
        load.normal_forse = 1.0
    with pytest.raises(AttributeError, match="did you mean normal_force"):
        wrc.PlanarLoad(normal_forse=1.0)
    with pytest.raises(TypeError, match="wrc.PlanarLoad or a dict"):
        wrc.PlanarInput(load=80e3)


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
    assert str(wrc.Side.LEFT) == "LEFT" and wrc.PlanarForces(available=1).available == wrc.Available.TRACTIONS


def test_arrays_are_views():
    wheel = wrc.WheelInput().wheel
    velocity = wheel.velocity
    velocity[0] = 40.0
    assert wheel.velocity[0] == 40.0
    wheel.angular_velocity = (0, -87, 0)
    assert wheel.angular_velocity.tolist() == [0, -87, 0]
    assert wrc.WrenchDerivatives().wrench.shape == (6, 32) and wrc.WRENCH_INPUTS == len(wrc.WrenchInput)


def test_flags_are_a_set():
    wrench = wrc.Wrench(flags=1 << wrc.Status.FLAG_NO_CONTACT | 1 << wrc.Status.FLAG_CLIMBING)
    assert wrench.flags == wrc.Flags.NO_CONTACT | wrc.Flags.CLIMBING and wrc.Flags.BEYOND_GAP not in wrench.flags
    assert "flags           NO_CONTACT | CLIMBING" in repr(wrench) and "flags           none" in repr(wrc.Wrench())
    assert {each.name for each in wrc.Flags} == {each.name[5:] for each in wrc.Status if each > 0}
    assert all(each == 1 << wrc.Status.of("FLAG_" + each.name) for each in wrc.Flags)
    array = wrc.Wrench.array(2, like=wrench)
    assert (array["flags"] & wrc.Flags.CLIMBING).all() and wrc.Wrench.table(array)["flags"].tolist() == 2 * [int(wrench.flags)]


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
    for each in (lambda: [1.5], lambda: np.array([1.5]), lambda: np.array([[1.5, 2.5]]).T[:1, 0]):
        strips = wrc.PlanarStrips(y=each())
        overwrite(1)
        assert strips.y.tolist() == [1.5]
    frozen = np.ones(1)
    frozen.flags.writeable = False
    assert wrc.PlanarStrips(y=frozen).y.tolist() == [1.0]


def test_numbers_within_a_struct_have_their_count():
    with pytest.raises(ValueError, match="WheelState.rotation has 9 numbers, not 4"):
        wrc.WheelState(rotation=np.eye(2))
    assert wrc.WheelState(rotation=np.arange(9.0).reshape(3, 3).T).rotation.tolist() == [0, 3, 6, 1, 4, 7, 2, 5, 8]  # row by row
    with pytest.raises(ValueError, match=r"WheelState.velocity \[m/s\] has 3 numbers, not 1"):
        wrc.WheelState().velocity = 40.0


def test_sizes_of_elements_are_set():
    config = wrc.Config(rail_sections=[{"distance": 1.0, "marks": [0.0, 0.1]}])
    assert config._rail_section_size == len(bytes(wrc.RailSection())) and config.rail_sections[0].mark_count == 2
    config.rail_sections = []
    assert config == wrc.Config() and bytes(config) == bytes(wrc.Config())
    assert wrc.Bins(3, 0.0).struct._bin_size == len(bytes(wrc.DamageBin()))


def test_copies_of_arrays_stay_whole():
    """What numpy copies is accepted by the library: sizes and zeros where they must be."""
    inputs = wrc.WheelInput.array(6)
    inputs["wheel"]["z"] = np.arange(6)
    for copied in (inputs[[4, 2]], inputs[inputs["wheel"]["z"] > 3], np.concatenate([inputs, inputs])[2:4], np.repeat(inputs, 2)[4:6]):
        assert copied.dtype == inputs.dtype
        assert bytes(wrc.WheelInput.of(copied, 0)) == bytes(wrc.WheelInput(wheel={"z": copied["wheel"]["z"][0]}))


def test_a_table_of_an_array():
    inputs = wrc.PlanarInput.array(2, like=wrc.PlanarInput(load={"normal_force": 80e3}))
    table = wrc.PlanarInput.table(inputs)
    assert table["load.normal_force"].tolist() == [80e3, 80e3] and not any("zone_y" in name for name in table)
    assert wrc.Wrench.table(wrc.Wrench.array(2))["force[2]"].shape == (2,)


def test_names_of_before_are_told():
    assert len(_renamed.NAMES) > 80
    for each, now in _renamed.NAMES.items():
        owner, _, name = each.rpartition(".")
        kind = getattr(wrc, owner) if owner else wrc
        if name.isupper():
            assert name not in kind.__members__ and now.split(",")[0] in {*kind.__members__, "gone"}, each
            continue
        if owner in ("Contact", "Model", "Batch"):
            assert now.startswith("gone") or hasattr(kind, now.split("(")[0].split(".")[0]), each
            continue
        if owner:
            assert name not in kind.members() and f"{owner} has no {name}: since 0.9 it is {now}" == getattr(kind, name).text
            continue
        assert name not in wrc.__all__ and (now.startswith("gone") or hasattr(wrc, now[4:].split(",")[0].split(" ")[0])), each


def test_arrays_of_structs_share_memory():
    inputs = wrc.PlanarInput.array(4, like=wrc.PlanarInput(load={"normal_force": 80e3}, friction={"zone_y": [0.0, 1e-3], "zone_coefficients": [0.1, 0.3]}))
    inputs["pose"]["lateral"] = [0, 1e-3, 2e-3, 3e-3]
    overwrite(2)
    second = wrc.PlanarInput.of(inputs, 2)
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
