"""Profile files of every kind, written here, with what goes wrong in them."""
import numpy as np
import pytest
import wrc
from scipy.interpolate import CubicSpline


@pytest.fixture(scope="module")
def shapes():
    """Points of a wheel and a rail [mm], z down, as the library's own shapes have them."""
    model = wrc.Model(wheel="S1002", rail="60E1")
    found = []
    for body in ("WHEEL", "RAIL"):
        y, z, _ = model.profile(body)
        y = y - (0.75 if body == "WHEEL" else y[np.argmin(z)])
        s = np.concatenate([[0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
        at = np.arange(0, s[-1], 5e-4)
        found.append(1e3 * np.column_stack([CubicSpline(s, y)(at), CubicSpline(s, z)(at)]))
    wheel, rail = found
    wheel[:, 1] -= np.interp(0, *wheel.T)
    return wheel, rail


def rows(points, separator=" "):
    return "".join(f"{y:.6f}{separator}{z:.6f}\n" for y, z in points)


def simpack(points, keys="", kind=1):
    return (f"header.begin\n  version = 1\n  type = {kind}\nheader.end\nspline.begin\n  approx.smooth = 0.0\n  comment = 'of a test'\n"
            f"  units.len.f = 1000.\n{keys}  point.begin ! y, z\n{rows(points)}  point.end\nspline.end\n")


def same(file, points, within=2e-6):
    """Does the file's curve run through these points [mm]?"""
    order = np.argsort(points[:, 0])
    wanted = points[order] * 1e-3
    inside = (wanted[:, 0] >= file.y[0]) & (wanted[:, 0] <= file.y[-1])
    assert inside.mean() > 0.8
    wanted = wanted[inside]
    at = np.interp(wanted[:, 0], file.y, file.z)
    assert np.median(np.abs(at - wanted[:, 1])) < within


def write(folder, name, text):
    path = folder / name
    path.write_text(text)
    return path


def test_simpack(tmp_path, shapes):
    wheel, rail = shapes
    found = wrc.read_profile(write(tmp_path, "new.prw", simpack(wheel[::-1])))  # Simpack's wheels run from the field side
    same(found, wheel)
    assert found.body == "wheel" and found.header["comment"] == "of a test" and (np.diff(found.y) > 0).all()
    same(wrc.read_profile(write(tmp_path, "new.prr", simpack(rail, kind=0))), rail)
    turned = 0.02
    keys = f"  mirror.y = 1\n  shift.y = 3.0\n  rotate = {np.degrees(turned)}\n  units.ang.f = {180 / np.pi}\n"
    back = np.array([[np.cos(turned), np.sin(turned)], [-np.sin(turned), np.cos(turned)]])  # what the keys undo, in their order
    changed = rail * [-1, 1] @ back.T - [3, 0]
    found = wrc.read_profile(write(tmp_path, "changed.prr", simpack(changed, keys, 0)))
    same(found, rail, 5e-5)
    assert "mirror.y = 1" in " ".join(found.notes)


def test_miniprof(tmp_path, shapes):
    wheel, rail = shapes
    up = wheel * [1, -1]  # MiniProf's y points up
    body = "".join(f"{y:.4f} {z:.4f} 0.1 0.0\n" for y, z in up)
    head = f"FileName=x.whl\nProgramName=MINIPROF\nColumnDef=X,Y,A,C\nXYPoints={len(up)}\n\n"
    found = wrc.read_profile(write(tmp_path, "x.whl", head + body))
    same(found, wheel, 1e-4)
    assert any("points up" in each for each in found.notes) and found.header["ProgramName"] == "MINIPROF"
    same(wrc.read_profile(write(tmp_path, "x.ban", rows(rail * [1, -1]))), rail)
    with pytest.raises(wrc.ProfileError, match=rf"short.whl:{len(up) + 4}: XYPoints promises {len(up)} points, {len(up) - 1} are"):
        wrc.read_profile(write(tmp_path, "short.whl", head + body.rsplit("\n", 2)[0] + "\n"))
    with pytest.raises(wrc.ProfileError, match=r"odd.whl:3: ColumnDef has no columns X and Y"):
        wrc.read_profile(write(tmp_path, "odd.whl", head.replace("X,Y,A,C", "A,C") + body))


@pytest.mark.parametrize("text", [rows, lambda p: rows(p, ","), lambda p: "y;z\n" + rows(p, ";").replace(".", ","), lambda p: rows(p, "\t").replace(".", ","), lambda p: "# of a test\ny z\n" + rows(p),
                                  lambda p: rows(1e-3 * p)])
def test_columns(tmp_path, shapes, text):
    wheel, _ = shapes
    same(wrc.read_profile(write(tmp_path, "wheel.txt", text(wheel)), "wheel"), wheel, 1e-5 if text(wheel) == rows(1e-3 * wheel) else 2e-6)


def test_left_wheels_and_ends_that_turn_back(tmp_path, shapes):
    wheel, rail = shapes
    found = wrc.read_profile(write(tmp_path, "left.txt", rows(wheel * [-1, 1])), "wheel")
    same(found, wheel)
    assert any("mirrored" in each for each in found.notes)
    with pytest.raises(wrc.ProfileError, match="mirror_y=False its flange is at y > 0"):
        wrc.read_profile(tmp_path / "left.txt", "wheel", mirror_y=False)
    web = np.array([[rail[0, 0] + 2 * k, rail[0, 1] + 3 * k] for k in range(6, 0, -1)])
    found = wrc.read_profile(write(tmp_path, "web.txt", rows(np.vstack([web, rail]))), "rail")
    same(found, rail)
    assert any("6 points left out where the profile turns back" in each for each in found.notes)
    mirrored = found.mirrored()
    assert (mirrored.y == -found.y[::-1]).all() and mirrored.check() is mirrored


@pytest.mark.parametrize("name, change, match", [
    ("a.txt", lambda rows: rows[:20] + ["12.3 x"] + rows[20:], r"a.txt:21: 'x' is no number"),
    ("b.txt", lambda rows: rows[:20] + ["12.3"] + rows[20:], r"b.txt:21: 1 number in this line"),
    ("c.txt", lambda rows: rows[:25] + rows[22:], r"c.txt:2\d: y goes back from"),
    ("d.txt", lambda rows: rows[:2], r"d.txt:2: 2 points; a profile has at least 4"),
    ("e.txt", lambda rows: [], r"e.txt:1: 0 points"),
    ("f.txt", lambda rows: [f"{25 * k} {k}" for k in range(50)], r"f.txt: is 1225 wide, .* neither in mm nor in m: is y its first column"),
    ("u.txt", lambda rows: [f"{2500 * k} {k}" for k in range(30)], r"u.txt: is 72500 wide, .* neither in mm nor in m: pass unit="),
    ("v.txt", lambda rows: [f"{k},2500,{k},1250" for k in range(30)], r"v.txt:1: commas are decimal and part the numbers"),
    ("g.txt", lambda rows: rows[:30] + ["nan 1.0"] + rows[30:], r"g.txt:31: 'nan' is no number"),
    ("h.prw", lambda rows: ["header.begin", "header.end", "spline.begin", "point.begin"] + rows, "point.end is missing: is the file whole"),
    ("i.prw", lambda rows: ["header.begin", "  type = 0", "header.end", "spline.begin", "point.begin"] + rows + ["point.end", "spline.end"],
     "type = 0, a rail, and it is read as a wheel"),
    ("j.prw", lambda rows: ["splin.begin"] + rows, "j.prw:1: there is no section splin"),
    ("k.prw", lambda rows: ["spline.begin", " units.len.f = mm"], "k.prw:2: units.len.f = 'mm' is no number"),
])
def test_errors_name_file_and_line(tmp_path, shapes, name, change, match):
    text = "\n".join(change(rows(shapes[0]).splitlines())) + "\n"
    with pytest.raises(wrc.ProfileError, match=match):
        wrc.read_profile(write(tmp_path, name, text), "wheel")


def test_what_a_caller_gets_wrong(tmp_path, shapes):
    wheel, rail = shapes
    path = write(tmp_path, "wheel.txt", rows(wheel))
    with pytest.raises(FileNotFoundError):
        wrc.read_profile(tmp_path / "none.txt")
    with pytest.raises(wrc.ProfileError, match="is it of a wheel or a rail"):
        wrc.read_profile(path)
    with pytest.raises(wrc.ProfileError, match="is it in mm?"):
        wrc.read_profile(path, "wheel", unit="m")
    with pytest.raises(wrc.ProfileError, match="there is no unit 'furlong'"):
        wrc.read_profile(path, "wheel", unit="furlong")
    with pytest.raises(wrc.ProfileError, match="pass running_circle="):
        wrc.read_profile(write(tmp_path, "off.txt", rows(wheel + [200, 0])), "wheel")
    same(wrc.read_profile(tmp_path / "off.txt", "wheel", running_circle=0.2), wheel)
    shallow = rail[np.abs(rail[:, 0]) < 25]
    with pytest.raises(wrc.ProfileError, match="shallow.txt"):
        wrc.read_profile(write(tmp_path, "shallow.txt", rows(shallow)), "rail")


def test_read_profiles_make_the_model_of_the_built_in_ones(tmp_path, shapes):
    wheel, rail = shapes
    wheel = wrc.read_profile(write(tmp_path, "w.txt", rows(wheel)), "wheel")
    rail = wrc.read_profile(write(tmp_path, "r.txt", rows(rail)), "rail")
    data = wrc.PlanarInput(load={"normal_force": 80e3}, creepage={"longitudinal": 1e-3})
    own = wrc.Model(wheel=wheel, rail=rail).contact().planar_step(data)
    built_in = wrc.Model(wheel="S1002", rail="60E1").contact().planar_step(data)
    assert own.forces.fx == pytest.approx(built_in.forces.fx, rel=0.03)
    assert "w.txt" in repr(wheel) and wheel.as_struct().count == len(wheel.y)


@pytest.fixture
def wheel_rows():
    """y, z [mm] of S1002, a point every 0.3 mm."""
    y, z, _ = wrc.Model(wheel="S1002", rail="60E1").profile("WHEEL")
    at = np.arange(y[0] + 1e-3, y[-1] - 1e-3, 0.3e-3)
    return np.stack([1e3 * (at - 0.75), 1e3 * np.interp(at, y, z)], 1)


def test_what_is_odd_is_named(wheel_rows, tmp_path):
    """Byte order marks, UTF-16, pandas' index, spikes, holes."""
    text = "\n".join(f"{y:.4f},{z:.4f}" for y, z in wheel_rows) + "\n"
    path = tmp_path / "wheel.csv"

    def read(content, **options):
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return wrc.read_profile(path, "wheel", **options)

    plain = read(text)
    assert len(plain.y) == len(wheel_rows) and not any("?" in each for each in plain.notes)
    marked = read(b"\xef\xbb\xbf" + text.encode())
    assert len(marked.y) == len(wheel_rows) and (marked.y == plain.y).all() and "byte order mark" in marked.notes[0]
    for content in (text.encode("utf-16"), text.encode("utf-16-le"), text.encode("utf-16-be")):
        wide = read(content)
        assert (wide.z == plain.z).all() and "read as UTF-16" in wide.notes
    with pytest.raises(wrc.ProfileError, match="spreadsheet"):
        read(b"\xff\xfe\x00\xd8\x00")
    counted = "".join(f"{k},{y:.4f},{z:.4f}\n" for k, (y, z) in enumerate(wheel_rows))
    indexed = read(",y,z\n" + counted)
    assert (indexed.z == plain.z).all() and any("pandas' index: left out" in each for each in indexed.notes)
    with pytest.raises(wrc.ProfileError, match=r"counts 0 .. \d+: is it pandas' index"):
        read(counted)
    assert (read(counted, columns=(1, 2)).z == plain.z).all()
    for width in (1, 2, 3):
        spoilt = wheel_rows.copy()
        spoilt[200:200 + width, 1] += 1.0
        with pytest.warns(wrc.ProfileWarning, match=r"line 20\d: z leaves its neighbours by 1.\d\d mm at y = .*: a spike\?") as told:
            read("\n".join(f"{y:.4f} {z:.4f}" for y, z in spoilt))
        assert len(told) == 1
    spoilt = wheel_rows.copy()
    spoilt[200:203, 1] += 5.0
    with pytest.warns(wrc.ProfileWarning), pytest.raises(wrc.ProfileError, match=":201: .*jumps from the point before"):
        read("\n".join(f"{y:.4f} {z:.4f}" for y, z in spoilt))
    with pytest.warns(wrc.ProfileWarning, match=r"line 200: no points for 15.3 mm behind y = .*: a hole\?") as told:
        read("\n".join(f"{y:.4f} {z:.4f}" for y, z in np.delete(wheel_rows, range(200, 250), 0)))
    assert len(told) == 1


@pytest.mark.parametrize("every", [1, 5, 10])
def test_sound_profiles_are_not_odd(wheel_rows, tmp_path, every, recwarn):
    (tmp_path / "wheel.txt").write_text("\n".join(f"{y:.4f} {z:.4f}" for y, z in wheel_rows[::every]))
    wrc.read_profile(tmp_path / "wheel.txt", "wheel")
    y, z, _ = wrc.Model(wheel="S1002", rail="60E1").profile("RAIL")
    (tmp_path / "rail.txt").write_text("\n".join(f"{1e3 * a:.4f} {1e3 * b:.4f}" for a, b in zip(y[::every] - 0.75, z[::every])))
    wrc.read_profile(tmp_path / "rail.txt", "rail")
    assert not recwarn.list


@pytest.mark.parametrize("slope", [1 / 20, 1 / 40])
def test_a_cone_has_its_known_conicity(slope):
    """slope (l + R slope) / (l - r slope): l from the middle to the tape circle, R of the rail's head, r of the wheel."""
    lateral = np.linspace(-6e-3, 6e-3, 121)
    geometry = wrc.Model(wheel=wrc.cone(slope), rail="60E1", track={"rail_inclination": 1 / 40}).wheelset_geometry(lateral)
    found = wrc.conicity(lateral, geometry["radius_difference"], [1e-3, 3e-3], radius=0.46)["conicity"]
    assert found == pytest.approx(slope * (0.75 + 0.3 * slope) / (0.75 - 0.46 * slope), rel=1e-3)


def test_gensys_and_contact(tmp_path):
    """A wheel with y towards the track's middle; points from the flange back on, as CONTACT lists a wheel."""
    model = wrc.Model(wheel="S1002", rail="60E1")
    y, z, _ = model.profile("WHEEL")
    rows = list(zip(1e3 * (y - 0.75), 1e3 * z))
    (tmp_path / "s1002.wheel").write_text("# S1002\n" + "\n".join(f" {-a:.5f} {b:.5f}   # a comment" for a, b in rows[::-1]))
    (tmp_path / "s1002.txt").write_text("\n".join(f"{a:.5f} {b:.5f}" for a, b in rows[::-1]))
    gensys, contact = wrc.read_profile(tmp_path / "s1002.wheel"), wrc.read_profile(tmp_path / "s1002.txt", "wheel")
    assert np.allclose(gensys.y, contact.y) and np.allclose(gensys.z, contact.z) and np.allclose(gensys.y, y - 0.75, atol=1e-8)
    leaning = [(a, 2e-2 * a * a + (0.01 * a if a > 0 else 0.0)) for a in np.linspace(-35, 35, 71)]
    (tmp_path / "own.rail").write_text("\n".join(f"{a:.4f} {b:.5f}" for a, b in leaning))
    rail = wrc.read_profile(tmp_path / "own.rail")
    assert rail.body == "rail" and rail.z[0] > rail.z[-1] and any("GENSYS" in each for each in rail.notes)


def test_shapes():
    """Rail heads have the widths of their names 14 mm below the top; the arcs of 60E1 are the library's; the wheel is smooth to 1:15."""
    for name, width in wrc.shapes.WIDTHS.items():
        y, z = wrc.shapes._head(name)
        side = len(y) // 2
        assert 2 * np.interp(14.0, z[side:], y[side:]) == pytest.approx(width, abs=0.05)
    head = wrc.Profile(y=1e-3 * (own := wrc.shapes._head("60E1"))[0], z=1e-3 * own[1])
    at = dict(prescribed="VERTICAL_LOAD", vertical_load=80e3)
    forces = [wrc.Model(wheel="S1002", rail=rail).contact().wrench(wrc.WheelInput(**at, wheel={"y": 3e-3})) for rail in ("60E1", head)]
    assert forces[1].force == pytest.approx(forces[0].force, rel=1e-3, abs=20) and forces[1].z == pytest.approx(forces[0].z, abs=1e-6)
    wheel = wrc.shape("GV 1/40").check()
    inside = (wheel.y > -0.0345) & (wheel.y < 0.0345)
    slopes = np.gradient(wheel.z, wheel.y)[inside]
    assert np.abs(np.diff(np.arctan(slopes))).max() < np.radians(1.5) and slopes[-1] == pytest.approx(-1 / 40)
    with pytest.raises(ValueError, match="60E2.*read_profile"):
        wrc.shape("EPS")
    with pytest.raises(ValueError, match="wrc.shape"):
        wrc.Model(wheel="S1002", rail="60E2")


def test_a_wheel_for_a_rail_and_units_that_fit(tmp_path):
    y, z, _ = wrc.Model(wheel="S1002", rail="60E1").profile("WHEEL")
    np.savetxt(tmp_path / "own.txt", 1e3 * np.c_[y - 0.75, z])
    np.savetxt(tmp_path / "inches.txt", np.c_[y - 0.75, z] / 25.4e-3)
    with pytest.raises(wrc.ProfileError, match="is it a wheel, read as a rail"):
        wrc.read_profile(tmp_path / "own.txt", "rail")
    with pytest.raises(wrc.ProfileError, match=r'"in" \(129 mm\)'):
        wrc.read_profile(tmp_path / "inches.txt", "wheel")
