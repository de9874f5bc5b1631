"""Models, contacts, batches, errors: through the installed package."""
import concurrent.futures
import gc
import subprocess
import sys
import threading

import numpy as np
import pytest
import wrc

LOADED = dict(load={"normal_force": 80e3}, creepage={"longitudinal": 0.5e-3, "speed": 40.0}, friction={"coefficient": 0.35})


@pytest.fixture(scope="module")
def model():
    return wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK")


def test_the_readmes_program(model):
    output = model.contact().step(wrc.Input(**LOADED))
    assert round(output.forces.fx) == -7464 and round(output.forces.power) == 149
    assert output.forces.available == wrc.Available.TRACTIONS


def test_stages_are_the_step(model):
    one, other = model.contact(), model.contact()
    data = wrc.Input(pose={"lateral": 2e-3}, **LOADED)
    whole = one.step(data)
    point = other.geometry(data.pose)
    normal = other.normal(data.load)
    forces = other.tangential(data.creepage, data.friction)
    assert point == whole.point and normal == whole.normal and forces == whole.forces and other.damage() == whole.damage
    assert sum(each.forces.fx for each in one.patches()) == pytest.approx(forces.fx)
    assert one.wear().largest_depth_rate > 0
    assert one.sensitivities().forces[0, 0] < 0


def test_fields_are_read_only_views_that_outlive_the_contact(model):
    contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()
    normal = contact.step(wrc.Input(**LOADED)).normal
    pressure = contact.field("PRESSURE")
    again = contact.field(wrc.FieldId.PRESSURE)
    assert np.shares_memory(pressure, again) and pressure.shape == (32, 60)
    with pytest.raises(ValueError):
        pressure[0, 0] = 1
    x, width, half = contact.field("X"), contact.field("STRIP_WIDTH"), contact.field("STRIP_HALF")
    assert np.sum(pressure * width * 2 * half / 32) == pytest.approx(80e3, rel=0.02)
    assert (np.diff(x, axis=0) < 0).all()  # cell 0 leads
    before = pressure.copy()
    contact.close()
    del contact
    gc.collect()
    np.zeros(10 ** 6)
    assert (pressure == before).all() and normal.peak_pressure > pressure.max() * 0.99


def test_sentences(model):
    contact = model.contact()
    with pytest.raises(wrc.Error, match=r"input.load.normal_force = 80 N is outside 100 .. 1e\+06 N: did you pass kN\?") as told:
        contact.step(wrc.Input(load={"normal_force": 80}))
    assert told.value.status is wrc.Status.ERROR_RANGE and contact.status is wrc.Status.ERROR_RANGE and "did you pass kN" in contact.message
    with pytest.raises(wrc.Error, match="did you pass mm"):
        wrc.Model(wheel="S1002", rail="60E1", wheelset={"wheel_radius": 460})
    with pytest.raises(wrc.Error, match="WRC_PROFILE|wheel.kind|rail"):
        wrc.Model(wheel="S1002")
    with pytest.raises(wrc.Error, match="FASTSIM-SDEC"):
        wrc.Model(wheel="S1002", rail="60E1", preset="FASTSIM-SDECK")
    with pytest.raises(wrc.Error, match="PRESSURE.*stage was called before"):
        model.contact().field("PRESSURE")
    with pytest.raises(wrc.Error, match="ERROR_RANGE"):
        wrc.shakedown_limit(-1.0)
    with pytest.raises(ValueError, match="is no Side"):
        wrc.Contact(model, "MIDDLE")
    assert contact.step(wrc.Input(**LOADED)).forces.fx < 0 and contact.message == ""
    lifted = contact.wrench(wrc.WheelInput(wheel={"z": -0.01}))
    assert contact.status is wrc.Status.FLAG_NO_CONTACT and not lifted.force.any()


def test_closed_handles_refuse(model):
    with wrc.Model(wheel="S1002", rail="60E1") as own:
        contact = own.contact()
    assert contact.step(wrc.Input(**LOADED)).forces.fn == pytest.approx(80e3)  # it keeps its model's memory
    contact.close()
    with pytest.raises(wrc.Error, match="this Contact is closed"):
        contact.step(wrc.Input(**LOADED))
    with pytest.raises(wrc.Error, match="closed"):
        own.contact()
    assert "closed" in repr(contact) and "closed" in repr(own)


def test_wrenches_regions_and_their_derivatives(model):
    contact = model.contact("LEFT")
    data = wrc.WheelInput(start="ANEW", wheel={"y": 1e-3, "z": 3e-4, "velocity": (40, 0, 0), "angular_velocity": (0, -40 / 0.46, 0)})
    wrench, slopes = contact.wrench_sensitivities(data)
    assert wrench == contact.wrench(data)
    step = 1e-6
    data.wheel.z += step
    ahead = contact.wrench(data)
    data.wheel.z -= 2 * step
    behind = contact.wrench(data)
    column = slopes.wrench[:, wrc.WrenchInput.Z]
    assert (ahead.force[2] - behind.force[2]) / (2 * step) == pytest.approx(column[2], rel=1e-3)
    assert len(contact.regions()) == ahead.regions
    state = contact.save()
    contact.wrench(wrc.WheelInput(wheel={"z": -0.01}))
    contact.restore(state)
    region = contact.regions()[0]
    assert region.normal_force > 0
    fields = contact.region_fields(0)
    assert fields["PRESSURE"].shape == (region.cell_count, region.strip_count) and fields["STRIP_S"].shape == (region.strip_count,)
    assert fields["PRESSURE"].max() == pytest.approx(region.peak_pressure, rel=0.05) and np.isfinite(fields["SLIP_X"]).all()
    portable = contact.save(portable=True)
    other = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact("LEFT")  # another model of an equal configuration
    other.restore(portable)
    assert other.regions()[0] == region
    with pytest.raises(wrc.Error):
        other.restore(portable[:-1])
    with pytest.raises(wrc.Error):
        other.restore(state)


def test_an_output_given_is_filled(model):
    contact, mine = model.contact(), wrc.Output()
    assert contact.step(wrc.Input(**LOADED), out=mine) is mine
    assert mine.forces.fn == pytest.approx(80e3, rel=1e-12)


def test_batches_and_sweeps_have_the_bits_of_single_calls(model):
    count = 150
    inputs = wrc.WheelInput.array(count, like=wrc.WheelInput(start="ANEW", wheel={"velocity": (40, 0, 0), "angular_velocity": (0, -40 / 0.46, 0)}))
    inputs["wheel"]["y"], inputs["wheel"]["z"] = np.linspace(-3e-3, 3e-3, count), np.linspace(4e-4, 2.5e-4, count)
    contact = model.contact()
    single = np.array([contact.wrench(wrc.WheelInput.of(inputs, k)).force for k in range(count)])
    batch = wrc.Batch([model.contact() for _ in range(8)])
    assert (batch.wrench(inputs[:8])["force"] == single[:8]).all() and not batch.statuses.any()
    assert (batch.wrench(wrc.WheelInput.of(inputs, 0))["force"] == single[0]).all()  # one for all
    for threads in (1, 3):
        out, statuses = wrc.sweep(model, inputs, threads=threads)
        assert out["force"].tobytes() == single.tobytes() and not statuses.any()
        inputs["start"] = wrc.WheelStart.FROM_LAST  # a sweep has no last one


def test_a_sweep_of_steps_has_the_bits_of_single_calls(model):
    count = 150
    inputs = wrc.Input.array(count, like=wrc.Input(**LOADED))
    inputs["creepage"]["longitudinal"] = np.linspace(-5e-3, 5e-3, count)
    inputs["load"]["normal_force"][70] = 80.0
    contact = model.contact()
    single = [contact.step(wrc.Input.of(inputs, k)).forces.fx for k in range(count) if k != 70]
    for threads in (1, 3):
        out, statuses = wrc.sweep(model, inputs, threads=threads)
        assert statuses[70] == int(wrc.Status.ERROR_RANGE) and out["forces"]["fx"][70] == 0 and not np.delete(statuses, 70).any()
        assert np.delete(out["forces"]["fx"], 70).tolist() == single


def test_batches_refuse_what_does_not_fit(model):
    contacts = [model.contact() for _ in range(2)]
    with pytest.raises(ValueError, match="once"):
        wrc.Batch([contacts[0], contacts[0]])
    batch = wrc.Batch(contacts)
    with pytest.raises(TypeError, match=r"input is a wrc.Input, not a dict: wrc.Input\(\*\*values\)"):
        model.contact().step({"load": {"normal_force": 80e3}})
    with pytest.raises(TypeError, match=r"wrc.WheelInput.array\(2\)"):
        batch.wrench(np.zeros(2))
    inputs = wrc.WheelInput.array(2, like=wrc.WheelInput(wheel={"z": 3e-4, "velocity": (40, 0, 0), "angular_velocity": (0, -40 / 0.46, 0)}))
    inputs["wheel"]["z"][1] = 0.3
    with pytest.raises(wrc.Error, match="contact 1 of 2: input.wheel.z = 0.3 m"):
        batch.wrench(inputs)
    out = batch.wrench(inputs, check=False)
    assert batch.statuses.tolist() == [0, int(wrc.Status.ERROR_RANGE)] and out["force"][1].tolist() == [0, 0, 0]
    warm = wrc.Model(wheel="S1002", rail="60E1", normal={"warm_start": 1})
    with pytest.raises(ValueError, match="warm_start"):
        wrc.sweep(warm, inputs)


def test_threads_run_at_once_and_share_a_contact_in_turn(model):
    contact = model.contact()
    data = wrc.Input(**LOADED)
    expected = contact.step(data)
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert all(each == expected for each in pool.map(lambda _: contact.step(data), range(40)))
    ticks, gate = [], threading.Lock()

    def count():
        with gate:
            ticks.append(1)

    gate.acquire()
    other = threading.Thread(target=count)
    other.start()
    interval = sys.getswitchinterval()
    sys.setswitchinterval(60.0)  # so that only a call that releases the GIL lets the other thread run
    try:
        gate.release()
        for _ in range(100):  # the other thread may wait for a processor, too
            contact.exact_check(24, 24)
            meanwhile = len(ticks)
            if meanwhile:
                break
    finally:
        sys.setswitchinterval(interval)
        other.join()
    assert meanwhile == 1


def test_profiles_as_used(model):
    y, z, deviation = model.profile("RAIL", "LEFT")
    assert (y < 0).all() and z.min() == pytest.approx(0, abs=1e-6) and deviation == 0 and not y.flags.writeable


def test_force_table():
    model = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK", tangential={"method": "FORCE_TABLE", "force_table": wrc.force_table()})
    output = model.contact().step(wrc.Input(**LOADED))
    assert output.forces.fx == pytest.approx(-7464, rel=0.02) and output.forces.available == 0


def test_a_library_of_another_interface_is_refused(tmp_path):
    found = subprocess.run([sys.executable, "-c", "import wrc"], env={"WRC_LIBRARY": str(tmp_path / "none.so")}, capture_output=True, text=True)
    assert found.returncode and "ImportError" in found.stderr and "WRC_LIBRARY" in found.stderr


def test_contact_functions_and_conicity(model):
    lateral = np.linspace(-5e-3, 5e-3, 41)
    found = model.contact_functions(lateral)
    assert found["radius_difference"] == pytest.approx(-found["radius_difference"][::-1], abs=1e-9)
    coned = wrc.conicity(lateral, 2 * 0.1 * lateral, [1e-3, 2e-3])  # of cones
    assert coned["conicity"] == pytest.approx(0.1) and coned["wavelength"] == pytest.approx(2 * np.pi * np.sqrt(1.5 * 0.46 / 0.2))
    with pytest.raises(wrc.Error, match="did you pass mm"):
        model.contact_functions([1.0])


def test_what_has_no_method_is_raw_only():
    """A call whose arguments do not say how long an array is gets no method; raw has every one."""
    import ctypes

    version = wrc.raw.wrc_version()
    assert version >> 16 == 0 and len(wrc.raw.__all__) > 80
    assert not hasattr(wrc, "exact_normal")
    assert wrc.raw.wrc_planar_geometry(None, wrc.Pose(), None) == wrc.Status.ERROR_NULL
    with pytest.raises(ctypes.ArgumentError, match="contiguous numpy array of f8"):
        wrc.raw.wrc_exact_gap(None, None, np.zeros(3, np.float32))
    with pytest.raises(ctypes.ArgumentError):
        wrc.raw.wrc_planar_step(None, wrc.Pose(), None)


def test_a_gap_of_the_caller(model):
    y, x = np.linspace(-0.01, 0.01, 41), np.linspace(-0.01, 0.01, 31)
    h = y[:, None] ** 2 / 0.6 + x[None, :] ** 2 / 0.92
    contact = model.contact()
    load = wrc.Load(normal_force=80e3)
    by_rows = contact.normal(load, wrc.Gap(y=y, height=y ** 2 / 0.6, curvature=np.full(41, 2 / 0.92)))
    by_elements = contact.normal(load, wrc.Gap(h=h, y=y, x=x))
    assert by_elements.peak_pressure == pytest.approx(by_rows.peak_pressure, rel=1e-3)
    stepped = contact.step(wrc.Input(gap=wrc.Gap(y=y, x=x, h=h), load=load))
    assert stepped.normal == by_elements
    with pytest.raises(ValueError, match=r"Gap.h has the shape \(40, 31\), rows and columns are \(41, 31\)"):
        wrc.Gap(y=y, x=x, h=h[1:])
    gap = wrc.Gap(y=y, x=x, h=h)
    assert gap.h.tolist() == h.tolist()
    gap.set(y=np.linspace(-0.01, 0.01, 99))
    assert gap.h is None
    with pytest.raises(ValueError, match="set y and x first"):
        wrc.Gap().h = h
