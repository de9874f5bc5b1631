"""Models, contacts, batches, errors: through the installed package."""
import concurrent.futures
import gc
import subprocess
import sys
import threading

import numpy as np
import pytest
import wrc

PAPERS_STEEL = {name: {"shear_modulus": 80e9, "poisson": 0.25} for name in ("wheel_material", "rail_material")}
LOADED = dict(load={"normal_force": 80e3}, creepage={"longitudinal": 0.5e-3, "speed": 40.0}, friction={"coefficient": 0.35})


@pytest.fixture(scope="module")
def model():
    return wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK")


def test_a_step_of_the_papers_steel():
    output = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK", **PAPERS_STEEL).contact().planar_step(wrc.PlanarInput(**LOADED))
    assert round(output.forces.fx) == -7464 and round(output.forces.power) == 149
    assert output.forces.available == wrc.Available.TRACTIONS and not output.flags


def test_stages_are_the_step(model):
    one, other = model.contact(), model.contact()
    data = wrc.PlanarInput(pose={"lateral": 2e-3}, **LOADED)
    whole = one.planar_step(data)
    point = other.planar_geometry(data.pose)
    normal = other.planar_normal(data.load)
    forces = other.planar_tangential(data.creepage, data.friction)
    assert point == whole.point and normal == whole.normal and forces == whole.forces and other.damage(wrc.ALL_REGIONS) == whole.damage
    assert sum(each.longitudinal_force for each in one.regions()) == pytest.approx(forces.fx)
    assert one.wear(0).largest_depth_rate > 0 and one.temperature(0).rise > 0
    assert one.planar_tangential_derivatives().forces[0, 0] < 0
    creepage = one.planar_creepages(wrc.PlanarMotion(speed=40.0, pitch_rate=-40.0 / point.rolling_radius))
    assert abs(creepage.longitudinal) < 1e-6 and creepage.speed == pytest.approx(40.0, rel=1e-3)


def test_patches_and_regions_have_one_api(model):
    """Of each: as many regions as the result counts, whose fields give its force, its extent and its power."""
    plane, wheel = model.contact(), model.contact("LEFT")
    rolling = wrc.WheelInput(wheel={"y": -5e-3, "z": 6e-4, "velocity": (40, 0, 0), "pitch_rate": -40 / 0.46})
    for contact, count in ((plane, plane.planar_step(wrc.PlanarInput(**LOADED)).normal.patch_count), (wheel, wheel.wrench(rolling).region_count)):
        regions = contact.regions()
        assert len(regions) == count >= 1 and contact.status is wrc.Status.OK and contact.message == ""
        for index, region in enumerate(regions):
            assert region == contact.region(index) and isinstance(region.creepage, wrc.Creepage)
            fields = contact.fields(index)
            cells = (region.strip_count, region.cell_count)
            assert {each.shape for name, each in fields.items() if name.split("_")[0] not in ("STRIP", "GAP")} == {cells}
            assert {each.shape for name, each in fields.items() if name.startswith("STRIP_")} == {cells[:1]}
            assert ("STRIP_PROFILE_Y" in fields) == (contact is wheel) and ("GAP_Y" in fields) == (contact is plane)
            area = fields["STRIP_WIDTH"][:, None] * 2 * fields["STRIP_HALF_LENGTH"][:, None] / region.cell_count
            assert np.sum(area) * region.cell_count == pytest.approx(region.area)
            assert np.sum(fields["TRACTION_X"] * area) == pytest.approx(region.longitudinal_force, rel=0.02)
            assert np.sum(fields["POWER_DENSITY"] * area) == pytest.approx(region.power, rel=0.02)
            assert (np.diff(fields["X"], axis=1) < 0).all()  # cell 0 leads
            assert np.ptp(fields["STRIP_Y"]) + fields["STRIP_WIDTH"][[0, -1]].mean() == pytest.approx(region.width)
        with pytest.raises(wrc.Error, match="wrc_contact_field: .*index"):
            contact.field("PRESSURE", count)
        with pytest.raises(wrc.Error):
            contact.fields(count)
    plane.wrench(rolling)  # the last solution counts
    assert plane.regions()[0].available & wrc.Available.TRACTIONS and "STRIP_PROFILE_Y" in plane.fields()
    with pytest.raises(wrc.Error, match="ALL_REGIONS|index"):
        plane.damage(wrc.ALL_REGIONS)


def test_fields_are_copies(model):
    contact = model.contact()
    contact.planar_step(wrc.PlanarInput(**LOADED))
    pressure, again = contact.field("PRESSURE"), contact.field(wrc.Field.PRESSURE)
    assert pressure.shape == (60, 32) and (pressure == again).all() and not np.shares_memory(pressure, again)
    before = pressure.copy()
    contact.planar_step(wrc.PlanarInput(**{**LOADED, "load": {"normal_force": 40e3}}))
    assert (pressure == before).all() and contact.field("PRESSURE").max() < before.max()
    contact.close()
    with pytest.raises(wrc.Error, match="closed"):
        contact.field("PRESSURE")
    assert model.contact().regions.__doc__
    with pytest.raises(wrc.Error, match="nothing has been solved yet"):
        model.contact().regions()


def test_sentences(model):
    contact = model.contact()
    with pytest.raises(wrc.Error, match=r"wrc_planar_step: input.load.normal_force = 80 N is outside 100 .. 1e\+06 N: did you pass kN\?") as told:
        contact.planar_step(wrc.PlanarInput(load={"normal_force": 80}))
    assert told.value.status is wrc.Status.ERROR_RANGE and contact.status is wrc.Status.ERROR_RANGE and "did you pass kN" in contact.message
    with pytest.raises(wrc.Error, match="did you pass mm"):
        wrc.Model(wheel="S1002", rail="60E1", wheelset={"wheel_radius": 460})
    with pytest.raises(wrc.Error, match="WRC_PROFILE|wheel.kind|rail"):
        wrc.Model(wheel="S1002")
    with pytest.raises(wrc.Error, match="FASTSIM-SDEC"):
        wrc.Model(wheel="S1002", rail="60E1", preset="FASTSIM-SDECK")
    with pytest.raises(wrc.Error, match="wrc_contact_field: .*nothing has been solved yet"):
        model.contact().field("PRESSURE")
    with pytest.raises(wrc.Error, match="ERROR_RANGE"):
        wrc.shakedown_limit(-1.0)
    with pytest.raises(ValueError, match="is no Side"):
        wrc.Contact(model, "MIDDLE")
    with pytest.raises(wrc.Error, match="wrc_contact_init|no side|side"):
        wrc.Contact(model, 7)
    assert contact.planar_step(wrc.PlanarInput(**LOADED)).forces.fx < 0 and contact.message == ""
    lifted = contact.wrench(wrc.WheelInput(wheel={"z": -0.01}))
    assert contact.status is wrc.Status.FLAG_NO_CONTACT and not lifted.force.any()
    assert wrc.Flags.NO_CONTACT in lifted.flags and lifted.clearance > 5e-3 and contact.regions() == []
    soft = wrc.Model(wheel="S1002", rail="60E1", rail_material={"shear_modulus": 70e9})
    assert soft.status is wrc.Status.FLAG_DISSIMILAR_MATERIALS and model.status is wrc.Status.OK


def test_closed_handles_refuse(model):
    with wrc.Model(wheel="S1002", rail="60E1") as own:
        contact = own.contact()
    assert contact.planar_step(wrc.PlanarInput(**LOADED)).forces.fn == pytest.approx(80e3)  # it keeps its model's memory
    contact.close()
    with pytest.raises(wrc.Error, match="this Contact is closed"):
        contact.planar_step(wrc.PlanarInput(**LOADED))
    with pytest.raises(wrc.Error, match="closed"):
        own.contact()
    assert "closed" in repr(contact) and "closed" in repr(own)


def test_wrenches_regions_and_their_derivatives(model):
    contact = model.contact("LEFT")
    data = wrc.WheelInput(wheel={"y": 1e-3, "z": 3e-4, "velocity": (40, 0, 0), "pitch_rate": -40 / 0.46})
    wrench, slopes = contact.wrench_derivatives(data)
    assert wrench == contact.wrench(data)
    step = 1e-6
    data.wheel.z += step
    ahead = contact.wrench(data)
    data.wheel.z -= 2 * step
    behind = contact.wrench(data)
    column = slopes.wrench[:, wrc.WrenchInput.Z]
    assert (ahead.force[2] - behind.force[2]) / (2 * step) == pytest.approx(column[2], rel=1e-3)
    assert len(contact.regions()) == ahead.region_count
    state = contact.save()
    contact.wrench(wrc.WheelInput(wheel={"z": -0.01}))
    contact.restore(state)
    region = contact.regions()[0]
    assert region.normal_force > 0
    fields = contact.fields()
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
    contact, mine = model.contact(), wrc.PlanarOutput()
    assert contact.planar_step(wrc.PlanarInput(**LOADED), out=mine) is mine
    assert mine.forces.fn == pytest.approx(80e3, rel=1e-12)


def test_batches_and_sweeps_have_the_bits_of_single_calls(model):
    count = 150
    inputs = wrc.WheelInput.array(count, like=wrc.WheelInput(wheel={"velocity": (40, 0, 0), "pitch_rate": -40 / 0.46}))
    inputs["wheel"]["y"], inputs["wheel"]["z"] = np.linspace(-3e-3, 3e-3, count), np.linspace(4e-4, 2.5e-4, count)
    contact = model.contact()
    single = np.array([contact.wrench(wrc.WheelInput.of(inputs, k)).force for k in range(count)])
    batch = wrc.Batch([model.contact() for _ in range(8)])
    assert (batch.wrench(inputs[:8])["force"] == single[:8]).all() and not batch.statuses.any()
    assert (batch.wrench(wrc.WheelInput.of(inputs, 0))["force"] == single[0]).all()  # one for all
    for threads in (1, 3):
        out, statuses = wrc.sweep(model, inputs, threads=threads)
        assert out["force"].tobytes() == single.tobytes() and not statuses.any()
        inputs["start"] = wrc.Start.WARM  # a sweep has no last one


def test_a_sweep_of_planar_steps_has_the_bits_of_single_calls(model):
    count = 150
    inputs = wrc.PlanarInput.array(count, like=wrc.PlanarInput(**LOADED))
    inputs["creepage"]["longitudinal"] = np.linspace(-5e-3, 5e-3, count)
    inputs["load"]["normal_force"][70] = 80.0
    contact = model.contact()
    single = [contact.planar_step(wrc.PlanarInput.of(inputs, k)).forces.fx for k in range(count) if k != 70]
    for threads in (1, 3):
        out, statuses = wrc.sweep(model, inputs, threads=threads)
        assert statuses[70] == int(wrc.Status.ERROR_RANGE) and out["forces"]["fx"][70] == 0 and not np.delete(statuses, 70).any()
        assert np.delete(out["forces"]["fx"], 70).tolist() == single


def test_batches_refuse_what_does_not_fit(model):
    contacts = [model.contact() for _ in range(2)]
    with pytest.raises(ValueError, match="once"):
        wrc.Batch([contacts[0], contacts[0]])
    batch = wrc.Batch(contacts)
    with pytest.raises(TypeError, match=r"input is a wrc.PlanarInput, not a dict: wrc.PlanarInput\(\*\*values\)"):
        model.contact().planar_step({"load": {"normal_force": 80e3}})
    with pytest.raises(TypeError, match=r"wrc.WheelInput.array\(2\)"):
        batch.wrench(np.zeros(2))
    inputs = wrc.WheelInput.array(2, like=wrc.WheelInput(wheel={"z": 3e-4, "velocity": (40, 0, 0), "pitch_rate": -40 / 0.46}))
    inputs["wheel"]["z"][1] = 0.3
    with pytest.raises(wrc.Error, match="contact 1 of 2: wrc_contact_wrench.*: input.wheel.z = 0.3 m"):
        batch.wrench(inputs)
    out = batch.wrench(inputs, check=False)
    assert batch.statuses.tolist() == [0, int(wrc.Status.ERROR_RANGE)] and out["force"][1].tolist() == [0, 0, 0]
    assert contacts[1].status is wrc.Status.ERROR_RANGE and "input.wheel.z" in contacts[1].message and contacts[0].message == ""
    for name, value in (("start", "WARM"), ("non_steady", 1)):
        remembers = wrc.Model(wheel="S1002", rail="60E1", planar={name: value})
        with pytest.raises(ValueError, match=f"planar.{name}"):
            wrc.sweep(remembers, wrc.PlanarInput.array(2))


def test_threads_run_at_once_and_share_a_contact_in_turn(model):
    contact = model.contact()
    data = wrc.PlanarInput(**LOADED)
    expected = contact.planar_step(data)
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert all(each == expected for each in pool.map(lambda _: contact.planar_step(data), range(40)))
    ticks, gate, options = [], threading.Lock(), wrc.ExactCheckOptions(nx=24, ny=24)

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
            contact.exact_check(options)
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
    model = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK", tangential={"method": "FORCE_TABLE", "force_table": wrc.force_table()},
                      **PAPERS_STEEL)
    output = model.contact().planar_step(wrc.PlanarInput(**LOADED))
    assert output.forces.fx == pytest.approx(-7464, rel=0.02) and output.forces.available == 0


def test_a_library_of_another_interface_is_refused(tmp_path):
    found = subprocess.run([sys.executable, "-c", "import wrc"], env={"WRC_LIBRARY": str(tmp_path / "none.so")}, capture_output=True, text=True)
    assert found.returncode and "ImportError" in found.stderr and "WRC_LIBRARY" in found.stderr


def test_wheelset_geometry_and_conicity(model):
    lateral = np.linspace(-5e-3, 5e-3, 41)
    found = model.wheelset_geometry(lateral)
    assert found["radius_difference"] == pytest.approx(-found["radius_difference"][::-1], abs=1e-9)
    coned = wrc.conicity(lateral, 2 * 0.1 * lateral, [1e-3, 2e-3])  # of cones
    assert coned["conicity"] == pytest.approx(0.1) and coned["wavelength"] == pytest.approx(2 * np.pi * np.sqrt(1.5 * 0.46 / 0.2))
    with pytest.raises(wrc.Error, match="did you pass mm"):
        model.wheelset_geometry([1.0])


def test_what_has_no_method_is_raw_only():
    """A call whose arguments do not say how long an array is gets no method; raw has every one."""
    import ctypes

    version = wrc.raw.wrc_version()
    assert version >> 16 == 0 and len(wrc.raw.__all__) > 80
    assert not hasattr(wrc, "exact_normal")
    assert wrc.raw.wrc_planar_geometry(None, wrc.PlanarPose(), None) == wrc.Status.ERROR_NULL
    with pytest.raises(ctypes.ArgumentError, match="contiguous numpy array of f8"):
        wrc.raw.wrc_exact_gap(None, None, np.zeros(3, np.float32))
    with pytest.raises(ctypes.ArgumentError):
        wrc.raw.wrc_planar_step(None, wrc.PlanarPose(), None)


def test_a_gap_of_the_caller(model):
    y, x = np.linspace(-0.01, 0.01, 41), np.linspace(-0.01, 0.01, 31)
    h = y[:, None] ** 2 / 0.6 + x[None, :] ** 2 / 0.92
    contact = model.contact()
    load = wrc.PlanarLoad(normal_force=80e3)
    by_rows = contact.planar_normal(load, wrc.PlanarGap(y=y, height=y ** 2 / 0.6, curvature=np.full(41, 2 / 0.92)))
    by_elements = contact.planar_normal(load, wrc.PlanarGap(h=h, y=y, x=x))
    assert by_elements.peak_pressure == pytest.approx(by_rows.peak_pressure, rel=1e-3)
    stepped = contact.planar_step(wrc.PlanarInput(gap=wrc.PlanarGap(y=y, x=x, h=h), load=load))
    assert stepped.normal == by_elements
    with pytest.raises(ValueError, match=r"Gap.h has the shape \(40, 31\), row_count and column_count are \(41, 31\)"):
        wrc.PlanarGap(y=y, x=x, h=h[1:])
    gap = wrc.PlanarGap(y=y, x=x, h=h)
    assert gap.h.tolist() == h.tolist()
    gap.set(y=np.linspace(-0.01, 0.01, 99))
    assert gap.h is None
    with pytest.raises(ValueError, match="set the arrays beside it first"):
        wrc.PlanarGap().h = h


def test_a_wheel_that_is_not_round():
    angles = np.linspace(0, 2 * np.pi, 33)
    polygon = wrc.ConfigRoundness(angles=angles, deviations=1e-4 * np.cos(4 * angles))
    assert (polygon.angle_count, polygon.row_count) == (33, 1) and polygon.deviations.shape == (1, 33)
    contact = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}, roundness=polygon).contact()
    load = [-contact.wrench(wrc.WheelInput(wheel={"z": 3e-4}, angle=angle)).force[2] for angle in (0.0, np.pi / 4)]
    assert load[0] > 1.2 * load[1] > 0  # a longer radius below
    crossed = wrc.ConfigRoundness(angles=angles, y=[-0.02, 0.03], deviations=np.zeros((2, 33)))
    assert crossed.row_count == 2
    with pytest.raises(ValueError, match=r"deviations has the shape \(3, 33\), row_count and angle_count are \(2, 33\)"):
        crossed.deviations = np.zeros((3, 33))


# ------------------------------------------------------------------------------------------- what one tries at first

ROLLING = {"z": 2.5e-4, "yaw": 2e-3, "velocity": (20, 0, 0)}


def test_rates_by_name_are_the_angular_velocity_in_the_axes_of_the_body(model):
    contact = model.contact()
    named = contact.wrench(wrc.WheelInput(wheel={**ROLLING, "pitch_rate": -20 / 0.46}))
    body = contact.wrench(wrc.WheelInput(wheel={**ROLLING, "angular_axes": "BODY", "angular_velocity": (0, -20 / 0.46, 0)}))
    assert named.force == pytest.approx(body.force, rel=1e-9) and abs(named.force[1]) > 5e3  # 2 mrad of attack
    yawing = contact.wrench(wrc.WheelInput(wheel={**ROLLING, "pitch_rate": -20 / 0.46, "yaw_rate": 0.1}))
    assert yawing.force[0] != named.force[0]


def test_an_angular_velocity_without_axes_is_refused(model):
    contact = model.contact()
    with pytest.raises(wrc.Error, match="wrc_contact_wrench: input.wheel.angular_.*") as told:
        contact.wrench(wrc.WheelInput(wheel={**ROLLING, "angular_velocity": (0, -20 / 0.46, 0)}))
    assert "AXES" in str(told.value) or "axes" in str(told.value)
    with pytest.raises(ValueError, match=r"velocity \[m/s\] has 3 numbers, not 2"):
        wrc.WheelInput(wheel={"velocity": (20, 0)})
    with pytest.raises(ValueError, match=r"velocity \[m/s\] has 3 numbers, not 1"):
        wrc.WheelInput(wheel={"velocity": 20})


def test_rotations_are_numpy_matrices(model):
    contact, yaw, roll = model.contact(), 2e-3, 1e-3
    turn = np.array([[np.cos(yaw), -np.sin(yaw), 0], [np.sin(yaw), np.cos(yaw), 0], [0, 0, 1]])
    lean = np.array([[1, 0, 0], [0, np.cos(roll), -np.sin(roll)], [0, np.sin(roll), np.cos(roll)]])
    rates = {"z": 2.5e-4, "velocity": (20, 0, 0), "angular_axes": "BODY", "angular_velocity": (0, -20 / 0.46, 0)}
    angles = contact.wrench(wrc.WheelInput(wheel={**rates, "roll": roll, "yaw": yaw}))
    matrix = contact.wrench(wrc.WheelInput(wheel={**rates, "orientation": "ROWS", "rotation": lean @ turn}))
    assert matrix.force == pytest.approx(angles.force, rel=1e-6)
    fortran = contact.wrench(wrc.WheelInput(wheel={**rates, "orientation": "ROWS", "rotation": np.asfortranarray(lean @ turn)}))
    assert fortran.force.tolist() == matrix.force.tolist()
    with pytest.raises(wrc.Error, match="orientation|rotation"):
        contact.wrench(wrc.WheelInput(wheel={**rates, "rotation": lean @ turn}))


def test_names_of_before_say_the_new_one(model):
    contact = model.contact()
    for told, match in ((lambda: wrc.Input, "wrc has no Input: since 0.9 it is wrc.PlanarInput"), (lambda: contact.step, "planar_step"),
                        (lambda: contact.patches(), "regions"), (lambda: wrc.Batch([contact]).step, "wrc.sweep"),
                        (lambda: wrc.Config(material={"poisson": 0.3}), "Config has no material: since 0.9 it is wheel_material and rail_material"),
                        (lambda: setattr(wrc.Friction(), "kind", "FALLING"), "speed_law"), (lambda: wrc.Nothing, "wrc has no Nothing$")):
        with pytest.raises(AttributeError, match=match):
            told()
    with pytest.raises(ValueError, match="'FROM_LAST' is no Start: since 0.9 it is WARM"):
        wrc.WheelInput(start="FROM_LAST")
    assert not hasattr(contact, "step") and "step" not in dir(contact) and "planar_step" in dir(contact)
    assert "step" not in dir(wrc.Batch([contact])) and "kind" not in dir(wrc.Friction()) and "speed_law" in dir(wrc.Friction())
