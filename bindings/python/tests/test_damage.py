"""Damage, wear, heat and rolling that is not steady, and members that are several structs."""
import pickle

import numpy as np
import pytest

import wrc

WHEEL = {"y": 3e-3, "z": 4e-4, "velocity": (20, 0, 0), "pitch_rate": -20 / 0.46}


@pytest.fixture(scope="module")
def model():
    return wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK")


def test_bins_hold_what_was_added_in_any_order(model):
    contact = model.contact()
    contact.wrench(wrc.WheelInput(wheel=WHEEL))
    wheel, rail = wrc.Bins(160, -0.08), wrc.Bins(140, -0.07, rows=2, row_length=10.0)
    totals = contact.accumulate(wheel, rail, duration=0.1, distance=12.0)
    work = wheel.values("WORK")
    assert work.shape == (1, 160) and work.sum() + wheel.beside("WORK") == pytest.approx(totals.sum[wrc.DamageQuantity.WORK]) and work.sum() > 0
    assert rail.values("WORK")[0].sum() == 0 and rail.values("WORK")[1].sum() == pytest.approx(work.sum())
    assert abs(wheel.arc[work[0].argmax()]) < 0.03  # on the tread
    again = pickle.loads(pickle.dumps(wheel))
    assert wheel.struct.as_dict()["bins"]["sum"].shape == (16, 2)
    assert (again.merge(wheel).values("WORK") == 2 * work).all() and (wheel.values("WORK") == work).all()
    y, z = model.arc_places(wheel.arc)
    assert (np.diff(y) >= 0).all() and y.shape == z.shape == (160,)
    with pytest.raises(wrc.Error):
        wheel.merge(rail)
    with pytest.raises(wrc.Error, match="duration"):
        contact.accumulate(wheel, duration=-1.0)
    with pytest.raises(AttributeError, match="duration"):
        contact.accumulate(wheel, durations=1.0)


def test_whole_life_damage():
    assert [wrc.whole_life_damage(each) for each in (10.0, 65.0)] == pytest.approx([0.0, 1e-5])
    assert wrc.whole_life_damage(200.0) < 0 < wrc.whole_life_damage(65.0, wrc.FatigueLaws(whole_life_peak=2e-5)) - 1e-5


def test_flash_temperature_of_even_heat():
    cells, cell, speed, power = 200, 5e-5, 10.0, 1e9
    rise = wrc.flash_temperature(np.full((3, cells), power), cell, speed)
    heat = wrc.HeatProperties()
    effusivity = np.sqrt(heat.conductivity * heat.density * heat.specific_heat)
    way = cell * (np.arange(cells) + 0.5)
    assert rise.shape == (3, cells) and (rise[0] == rise[2]).all()
    assert rise[0, 20:] == pytest.approx((power / effusivity * np.sqrt(way / (np.pi * speed)))[20:], rel=0.02)
    with pytest.raises(wrc.Error):
        wrc.flash_temperature([1.0], 1.0, 10.0)


def test_wear_is_taken_off_and_the_flange_measured(model):
    arc = np.linspace(-0.078, 0.05, 600)
    y, z = model.arc_places(arc)
    worn, new_y, new_z = wrc.remove_wear(y, z, np.full(40, 1e-6), first=-0.02, passages=100, smoothing=0.0)
    assert worn.passages == 100 and worn.depth == pytest.approx(1e-4, rel=1e-3) and worn.area == pytest.approx(4e-6, rel=0.05)
    middle = np.abs(y) < 0.015
    assert np.interp(y[middle], new_y, new_z) - z[middle] == pytest.approx(-1e-4, rel=0.05)
    flange = wrc.flange_dimensions(y, z, 0.07)
    assert flange.height == pytest.approx(28e-3, abs=1e-3) and 0.025 < flange.thickness < 0.04
    with pytest.raises(wrc.Error):
        wrc.flange_dimensions(y[::-1], z, 0.07)


def test_transient_rolling_begins_with_a_shift_and_ends_steady():
    grid = wrc.exact.grid(12, 12, 1e-3)
    x, y = wrc.exact.cells(grid)
    pressure = 1e9 * np.sqrt(np.clip(1 - (x ** 2 + y ** 2) / 25e-6, 0, None))
    told = {"friction": 0.3, "creepage": {"longitudinal": 2e-3}}
    steady, _ = wrc.exact.rolling(grid, pressure, **told)
    bodies = wrc.exact.Transient(grid, rail_material=wrc.Material())
    forces = [bodies.step(pressure, **told)[0].fx for _ in range(40)]
    assert abs(forces[0]) < 0.5 * abs(steady.fx) and (np.diff(np.abs(forces[:8])) > 0).all()
    assert forces[-1] == pytest.approx(steady.fx, rel=0.01)
    with pytest.raises(wrc.Cancelled):
        bodies.step(pressure, progress=lambda fraction: True, **told)
    assert bodies.step(pressure, **told)[0].fx == pytest.approx(forces[-1], rel=1e-3)


def test_a_contact_that_rolls():
    contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK", planar={"non_steady": 1}).contact()
    data = wrc.PlanarInput(load={"normal_force": 80e3}, creepage={"longitudinal": 1e-3})
    forces = []
    for _ in range(4):
        contact.planar_roll(2e-3)
        forces.append(contact.planar_step(data).forces.fx)
    assert (np.diff(np.abs(forces)) > 0).all()
    contact.planar_roll(1.0)
    assert abs(contact.planar_step(data).forces.fx) > abs(forces[-1])
    with pytest.raises(wrc.Error):
        wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact().planar_roll(1.0)


def test_sections_rollers_and_check_rails_by_dicts(model):
    level = {"profile": {"kind": "PROFILE_60E1"}}
    sections = [{"distance": 0.0, **level}, {"distance": 1.0, "z": 1e-4, **level}, {"distance": 2.0, "z": 1e-4, **level}]
    changing = wrc.Config(wheel="S1002", rail="PROFILE_60E1", rail_sections=sections)
    assert changing.rail_section_count == 3 and [each.distance for each in changing.rail_sections] == [0.0, 1.0, 2.0]
    assert pickle.loads(pickle.dumps(changing)) == changing == changing.copy() and "3 of wrc.RailSection" in repr(changing)
    contact = wrc.Model(changing).contact()
    load = [-contact.wrench(wrc.WheelInput(wheel={"z": 3e-4}, distance=at)).force[2] for at in (0.01, 1.5)]
    assert load[0] > 1.3 * load[1] > 0  # the rail lies 0.1 mm lower there
    changing.rail_sections = None
    assert changing.rail_section_count == 0 and changing.rail_sections == []
    flat = model.contact().wrench(wrc.WheelInput(wheel={"z": 3e-4}))
    roller = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK", roller_curvature=1.0).contact().wrench(wrc.WheelInput(wheel={"z": 3e-4}))
    assert 0 < -roller.force[2] < -flat.force[2]
