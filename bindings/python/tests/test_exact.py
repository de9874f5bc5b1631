"""The offline solver, with progress."""
import numpy as np
import pytest
import wrc


@pytest.fixture(scope="module")
def hertz():
    grid = wrc.exact.grid(32, 32, 4e-4)
    x, y = wrc.exact.cells(grid)
    return grid, (x ** 2 + y ** 2) / (2 * 0.25)  # two bodies of curvature 1 / 0.25 m together


def test_hertz(hertz):
    grid, gap = hertz
    solution, pressure = wrc.exact.normal(grid, gap, normal_force=20e3)
    steel = wrc.Material()
    stiffness = steel.shear_modulus / (1 - steel.poisson)  # E* of equal bodies: G / (1 - nu)
    a = (3 * 20e3 * 0.25 / (4 * stiffness)) ** (1 / 3)
    assert solution.peak_pressure == pytest.approx(1.5 * 20e3 / (np.pi * a * a), rel=0.02)
    assert pressure.sum() * grid.dx * grid.dy == pytest.approx(20e3, rel=1e-6) and pressure.max() == solution.peak_pressure


def test_rolling_with_progress(hertz):
    grid, gap = hertz
    _, pressure = wrc.exact.normal(grid, gap, normal_force=20e3)
    told = []
    solution, fields = wrc.exact.rolling(grid, pressure, friction=0.3, creepage={"longitudinal": 1e-3}, progress=told.append)
    assert told == sorted(told) and len(told) > 2 and 0 <= told[0] and told[-1] <= 1
    assert fields["traction_x"].sum() * grid.dx * grid.dy == pytest.approx(solution.fx) and solution.fx < 0
    assert (np.hypot(fields["traction_x"], fields["traction_y"]) <= 0.3 * pressure * (1 + 1e-3) + 1).all()
    spread, _ = wrc.exact.rolling(grid, pressure, friction=np.full((32, 32), 0.3), creepage={"longitudinal": 1e-3})
    assert spread.fx == solution.fx


def test_progress_stops_and_raises(hertz):
    grid, gap = hertz
    with pytest.raises(wrc.Cancelled):
        wrc.exact.normal(grid, gap, normal_force=20e3, progress=lambda fraction: True)

    def broken(fraction):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        wrc.exact.normal(grid, gap, normal_force=20e3, progress=broken)
    contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()
    contact.planar_step(wrc.PlanarInput(load={"normal_force": 80e3}, creepage={"longitudinal": 1e-3}))
    with pytest.raises(wrc.Cancelled):
        contact.exact_check(wrc.ExactCheckOptions(nx=16, ny=16), progress=lambda fraction: True)
    with pytest.raises(KeyError):
        contact.exact_check(wrc.ExactCheckOptions(nx=16, ny=16), progress=broken)
    assert abs(contact.exact_check(wrc.ExactCheckOptions(nx=16, ny=16)).force_error) < 0.05  # of a coarse grid


def test_the_bar(hertz, capfd):
    grid, gap = hertz
    wrc.exact.normal(grid, gap, normal_force=20e3, progress=True)
    told = capfd.readouterr().err
    assert "%" in told and told.endswith("\n")


def test_what_does_not_fit_is_refused(hertz):
    grid, gap = hertz
    with pytest.raises(ValueError, match=r"gap has the shape \(31, 32\), its grid"):
        wrc.exact.normal(grid, gap[1:], normal_force=20e3)
    with pytest.raises(wrc.Error, match="did you pass mN"):
        wrc.exact.normal(grid, gap, normal_force=1e9)
    with pytest.raises(AttributeError, match="did you mean normal_force"):
        wrc.exact.normal(grid, gap, normal_forces=1e3)


def test_materials_of_both_bodies(hertz):
    grid, gap = hertz
    soft = wrc.Material(shear_modulus=41e9)
    one, _ = wrc.exact.normal(grid, gap, normal_force=20e3, wheel_material=soft)
    other, _ = wrc.exact.normal(grid, gap, normal_force=20e3, rail_material={"shear_modulus": 41e9})
    steel, _ = wrc.exact.normal(grid, gap, normal_force=20e3)
    # Hertz: p0 as E*^(2/3), of which both bodies have their share: 1 / E* by 3 / 2
    assert one.peak_pressure == other.peak_pressure == pytest.approx(steel.peak_pressure * (2 / 3) ** (2 / 3), rel=0.01)


def test_a_wrench_exactly():
    contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()
    data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3, friction={"coefficient": 0})
    exact = contact.exact_wrench(data, wrc.ExactWrenchOptions(cell_x=8e-4, cell_s=8e-4))
    assert exact.force[2] == pytest.approx(-80e3, rel=1e-4) and exact.peak_pressure == pytest.approx(contact.wrench(data).peak_pressure, rel=0.1)
    with pytest.raises(wrc.Cancelled):
        contact.exact_wrench(data, progress=lambda fraction: True)
    contact.planar_geometry(wrc.PlanarPose())
    gap = contact.exact_gap(wrc.exact.grid(16, 16, 1e-3))
    assert gap.shape == (16, 16) and 0 <= gap.min() < 1e-6


def test_stresses(hertz):
    grid, gap = hertz
    solution, pressure = wrc.exact.normal(grid, gap, normal_force=20e3)
    centre = wrc.exact.stresses(grid, [[grid.dx / 2, grid.dy / 2, 1e-6]], pressure, body="RAIL")[0]
    assert centre[2] == pytest.approx(-solution.peak_pressure, rel=0.02)
    assert centre[0] == pytest.approx((0.5 + wrc.ExactLoads().poisson) * centre[2], rel=0.05)  # Hertz: (1 + 2 nu) / 2 of the pressure
    found = wrc.exact.largest_stresses(grid, pressure, progress=lambda fraction: None)
    assert found.below.shear.stress == pytest.approx(0.32 * solution.peak_pressure, rel=0.03)
    with pytest.raises(ValueError, match=r"shape \(n, 3\)"):
        wrc.exact.stresses(grid, [0, 0, 1e-3], pressure)


def test_stresses_under_a_step():
    contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()
    normal = contact.planar_step(wrc.PlanarInput(load={"normal_force": 80e3}, creepage={"longitudinal": 1e-3})).normal
    found, levels = contact.stresses(0, [1e-3, 3e-3])
    assert 0.2 < found.largest.shear.stress / normal.peak_pressure < 0.5 and len(levels) == 2
    whole, _ = contact.stresses(wrc.ALL_REGIONS, [1e-3, 3e-3])
    assert whole == found  # of one patch
    assert levels[1].shear.depth == 3e-3 and levels[1].shear.stress <= found.largest.shear.stress
