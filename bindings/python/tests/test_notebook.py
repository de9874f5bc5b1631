"""What notebooks and tables have of the package: pickles, pandas, forms in HTML and PNG, keywords."""
import copy
import inspect
import pickle

import numpy as np
import pytest
import wrc
from wrc import _interface

ROLLING = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3, wheel={"velocity": (20, 0, 0), "pitch_rate": -20 / 0.46})


@pytest.fixture(scope="module")
def contact():
    one = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}).contact("LEFT")
    one.wrench(ROLLING)
    return one


def test_models_and_contacts_are_pickled(contact):
    for other in (pickle.loads(pickle.dumps(contact)), copy.deepcopy(contact), copy.copy(contact)):
        assert other.side == wrc.Side.LEFT and other.model.config == contact.model.config
        assert len(other.regions()) == len(contact.regions()) and (other.field("PRESSURE") == contact.field("PRESSURE")).all()
        assert bytes(other.wrench(ROLLING)) == bytes(pickle.loads(pickle.dumps(contact)).wrench(ROLLING))
    y, z, _ = contact.model.profile("WHEEL")
    model = pickle.loads(pickle.dumps(wrc.Model(wheel=wrc.Profile(y=y - 0.75, z=z), rail="60E1")))
    assert model.config.wheel.count == len(y) and model.contact().wrench(ROLLING).force[2] < 0


def test_presets_and_methods():
    assert len(wrc.presets()) == 11 and "FASTSIM-SDEC" in wrc.presets()
    for name in wrc.presets():
        assert wrc.Model(wheel="S1002", rail="60E1", preset=name).status == 0
    assert wrc.use(wrc.Config(), "Fastsim sdec").tangential.patch_model is wrc.PatchModel.PATCH_SDEC
    assert wrc.Model(wheel="S1002", rail="60E1", preset="KBTNH-type table").config.tangential.force_table == wrc.force_table()
    assert set(wrc.methods()["normal"]) == set(wrc.NormalMethod.__members__) and all(wrc.methods()["tangential"].values())
    with pytest.raises(wrc.Error, match="FASTSIM-SDEC"):
        wrc.use(wrc.Config(), "FASTSIM-SDCE")


def test_tables(contact):
    pandas = pytest.importorskip("pandas")
    regions = wrc.to_frame(contact.regions())
    assert len(regions) == len(contact.regions()) and regions["force[2]"].sum() == pytest.approx(contact.wrench(ROLLING).force[2], rel=1e-6)
    many = wrc.WheelInput.array(3, like=ROLLING)
    frame = wrc.to_frame(many)
    assert list(frame["prescribed"]) == 3 * ["VERTICAL_LOAD"] and frame["wheel.velocity[0]"].tolist() == [20, 20, 20]
    assert wrc.to_frame(wrc.Wrench()).loc[0, "flags"] == "none" and wrc.to_frame([]).empty
    assert wrc.to_frame(contact.model.wheelset_geometry([0.0, 1e-3])).shape[0] == 2
    fields = contact.fields()
    cells = wrc.to_frame(fields)
    assert cells["PRESSURE"].max() == fields["PRESSURE"].max() and cells.index.names == ["strip", "cell"]
    assert (cells["STRIP_PEAK"].to_numpy().reshape(fields["PRESSURE"].shape)[:, 0] == fields["STRIP_PEAK"]).all()
    for kind in _interface.STRUCTS.values():
        columns = wrc.to_frame(kind.array(2)).columns
        assert not any("reserved" in each or "struct_size" in each for each in columns)
    with pytest.raises(TypeError, match="one kind, not Ellipse, Wrench"):
        wrc.to_frame([wrc.Wrench(), wrc.Ellipse()])
    with pytest.raises(TypeError, match="no structs of wrc"):
        wrc.to_frame(np.zeros(3))
    assert isinstance(regions, pandas.DataFrame)


def test_forms_in_notebooks(contact):
    assert wrc.plot.regions(contact)._repr_png_().startswith(b"\x89PNG")
    shown = ROLLING._repr_html_()
    assert "<td" in shown and "wheel.velocity" in shown and "m/s" in shown and "reserved" not in shown
    assert "VERTICAL_LOAD" in shown


def test_keywords_are_told():
    assert "normal_force" in inspect.signature(wrc.PlanarLoad).parameters
    assert "count" not in inspect.signature(wrc.Profile).parameters and "y" in inspect.signature(wrc.Profile).parameters
    assert wrc.NormalMethod.EKP.__doc__.startswith("extended Kik-Piotrowski") and wrc.Status.OK.__doc__ == "done"


def test_wrong_numbers_say_member_and_unit():
    for make, told in ((lambda: wrc.WheelState(velocity=(40, 0)), r"WheelState.velocity \[m/s\] has 3 numbers, not 2"),
                       (lambda: wrc.WheelState(velocity="fast!"), r"WheelState.velocity \[m/s\] has 3 numbers, not 1"),
                       (lambda: wrc.WheelState(velocity=("a", 0, 0)), r"WheelState.velocity \[m/s\] has 3 numbers, not \('a', 0, 0\)"),
                       (lambda: wrc.WheelInput(vertical_load=[80e3]), r"WheelInput.vertical_load \[N\]: is a real number, not list"),
                       (lambda: wrc.Profile(y=np.zeros((2, 2))), r"Profile.y \[m\] is a row of numbers")):
        with pytest.raises((TypeError, ValueError), match=told):
            make()
