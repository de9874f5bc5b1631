"""Measured sections: files, faces, marks, thin data, and what is wrong in them. Rails are those of examples/rails."""
import pathlib
import pickle
import sys

import numpy as np
import pytest
import wrc

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "examples/rails"))
import dipped_joint
import rails
import turnout


@pytest.mark.parametrize("name, kinds", [("crossing", {"nose", "wing"}), ("blade", {"blade", "stock"}), ("expansion", {"blade", "stock"}),
                                         ("insulated", {"rail"}), ("frog", {"blade", "stock"})])
def test_kinds_and_a_model_of_each(name, kinds):
    make, told = rails.RAILS[name]
    faces = wrc.rail_faces(make(), **told)
    assert {face.kind for face in faces.faces} == kinds and not faces.notes
    found = rails.rolled(rails.model_of(faces).contact("RIGHT"), [faces.faces[-1].distances[1] + 0.02])
    assert found[0, 1] == pytest.approx(60e3, rel=5e-3)  # plain rail there: the load and no more


def test_places_of_the_faces():
    nose, wing = wrc.rail_faces(rails.crossing()).faces
    assert (nose.distances[0], nose.distances[-1], wing.distances[0]) == pytest.approx((0.12, 0.95, -0.5))
    for face, first in ((nose, lambda x: -37e-3 + 2e-3 * min(1.0, max(0.0, (x - 0.12) / 0.06))), (wing, lambda x: -35e-3 + 0.1 * max(0.0, x + 0.4))):
        for x, (y, z), marks in zip(face.distances, face.outlines, face.marks):
            assert np.interp(first(x), y, z) - z.min() > 4e-3  # the gauge edge of the head, where its corner begins
            assert first(x) < marks[0] < first(x) + 6e-3  # 45 degrees
            assert z.max() <= 0.03 + 1e-12 and (np.diff(y) > 0).all()
    steepest = 24e-3 * (1.0 - np.cos(np.arctan(0.5)))  # an ellipse of 24 and 12 mm falls 1:1 there
    assert wing.marks[-1][0] == pytest.approx(-35e-3 + 0.1 * 1.35 + steepest, abs=1e-3)  # and the crown's own slope


def test_the_joint_is_two_faces():
    make, told = rails.RAILS["insulated"]
    one, two = sorted(wrc.rail_faces(make(), **told).faces, key=lambda face: face.distances[0])
    assert (one.distances[-1], two.distances[0]) == pytest.approx((-3e-3, 3e-3))
    assert two.outlines[0][1].min() - one.outlines[0][1].min() == pytest.approx(0.5e-3)
    assert len(wrc.rail_faces(make()).faces) == 1  # nobody can tell without being told


def test_check_rail():
    sections = [rails.section(x, rails.head(-150e-3, -80e-3, -20e-3, depth=65e-3), rails.head(-35e-3, 35e-3, 0.0, field_depth=15e-3)) for x in (0.0, 0.5, 1.0)]
    faces = wrc.rail_faces(sections)
    assert [face.kind for face in faces.faces] == ["check", "rail"]
    assert {each["surface"] for each in faces.rail_sections} == {0} and len(faces.rail_sections) == 3


def test_a_wider_rail_joins():
    sections = [rails.section(x, rails.head(-35e-3, 35e-3 if x < 0.5 else 70e-3, 0.0, field_depth=15e-3)) for x in np.arange(0.0, 1.01, 0.1)]
    faces = wrc.rail_faces(sections)
    one, two = sorted(faces.faces, key=lambda face: face.distances[0])
    assert one.distances[-1] == two.distances[0] == pytest.approx(0.5)  # both are there at one section
    assert one.outlines[-1][0][-1] < 40e-3 < two.outlines[0][0][-1]
    assert "joins or leaves" in faces.notes[0] and "section 6 at 0.5 m" in faces.notes[0]


def test_thin_data():
    def bump(step):
        return [rails.section(x, rails.head(-35e-3, 35e-3, 4e-3 * np.exp(-(x / 0.1) ** 2), field_depth=15e-3)) for x in np.arange(-0.4, 0.41, step)]

    coarse, fine = (wrc.rail_faces(bump(step)) for step in (0.1, 0.05))
    worst = [max(each.faces[0].spacing_errors) for each in (coarse, fine)]
    assert worst[0] == pytest.approx(4e-3 * (1 - np.exp(-1)), rel=1e-3)
    assert worst[1] == pytest.approx(4e-3 * (1 - np.exp(-0.25)), rel=1e-3)
    assert any("section 5 at" in sentence and "mm off the mean" in sentence for sentence in coarse.thin)
    assert not wrc.rail_faces(bump(0.01), tolerance=1e-3).thin
    alone = rails.crossing()[:13]  # a nose in the last section alone
    alone.append(next(each for each in rails.crossing() if each.distance > 0.13))
    assert any("in no other section" in note for note in wrc.rail_faces(alone).notes)


def test_files(tmp_path):
    sections = rails.crossing()[10:20]
    for name in ("new.slcs", "cloud.txt"):
        wrc.write_sections(tmp_path / name, sections)
        again = wrc.read_sections(tmp_path / name, unit=None if name.endswith("slcs") else "m")
        assert [each.distance for each in again] == pytest.approx([each.distance for each in sections])
        for one, other in zip(sections, again):
            assert np.allclose(one.y, other.y, atol=1e-9) and np.allclose(one.z, other.z, atol=1e-9)
    (tmp_path / "SectionPositionRail.txt").write_text("".join(f" {k}  {each.distance:.6f}\n" for k, each in enumerate(sections, 1)))
    for k, each in enumerate(sections, 1):
        np.savetxt(tmp_path / f"Rail_{k}.txt", np.column_stack([each.y, each.z]))
    table = wrc.read_sections(tmp_path / "SectionPositionRail.txt")
    assert np.allclose(table[3].z, sections[3].z)
    turned = wrc.read_sections(tmp_path / "SectionPositionRail.txt", mirror_y=True)
    assert np.allclose(turned[3].y, -sections[3].y[::-1])
    text = (tmp_path / "new.slcs").read_text()
    (tmp_path / "new.slcs").write_text("\n".join(text.split("\n")[:-3]))
    with pytest.raises(ValueError, match="10 slices are promised, 8 named"):
        wrc.read_sections(tmp_path / "new.slcs")
    (tmp_path / "new_3.txt").unlink()
    with pytest.raises(wrc.Error, match="line 9: there is no file .*new_3.txt.*new.slcs"):
        wrc.read_sections(tmp_path / "new.slcs")


def changed(number, **members):
    sections = rails.crossing()[:6]
    for name, value in members.items():
        setattr(sections[number - 1], name, value(getattr(sections[number - 1], name)))
    return sections


@pytest.mark.parametrize("change, sentence", [
    (dict(distance=lambda x: -0.5), "section 3 at -0.5 m: it lies before section 2 at -0.45 m: sections cross"),
    (dict(distance=lambda x: -0.45), "section 3 at -0.45 m: it lies where section 2 does: was it measured twice"),
    (dict(distance=lambda x: -0.4499), "section 3 at -0.4499 m: 0.1 mm beyond section 2"),
    (dict(distance=lambda x: np.nan), "section 3 at nan m: its distance is no finite number"),
    (dict(y=lambda y: 1e3 * y, z=lambda z: 1e3 * z), "section 3 at -0.4 m: it is .* m wide, most are .* another unit"),
    (dict(z=lambda z: -z), "section 3 at -0.4 m: z is .* point down: turn its sign"),
    (dict(z=lambda z: z + 0.1), "section 3 at -0.4 m: z is .* 0 at the rail's top"),
    (dict(y=lambda y: y[::-1], z=lambda z: z[::-1]), "section 3 at -0.4 m: its points run from the field side"),
    (dict(y=lambda y: np.r_[y[:60], y[59] + np.array([4e-3, 2e-3, 2e-3]), y[60:]], z=lambda z: np.r_[z[:60], z[59] + np.array([0.0, -3e-3, 3e-3]), z[60:]]),
     "section 3 at -0.4 m: the line crosses itself at y = .* mm"),
    (dict(y=lambda y: y - 0.004 * np.exp(-((np.arange(len(y)) - 60) / 4.0) ** 2)), "section 3 at -0.4 m: it overhangs: y goes back from"),
    (dict(y=lambda y: y[:3], z=lambda z: z[:3]), "section 3 at -0.4 m: 3 points that were measured"),
    (dict(y=lambda y: y[:-1]), "section 3 at -0.4 m: .* values of y and .* of z"),
])
def test_unsound_sections(change, sentence):
    with pytest.raises(wrc.SectionError, match=sentence) as caught:
        wrc.rail_faces(changed(3, **change))
    assert caught.value.number == 3
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value)


def test_gaps_in_a_line():
    sections = rails.crossing()[:6]
    for each in sections:  # nothing measured for 8 mm of the head
        each.z[np.abs(each.y - 10e-3) < 4e-3] = np.nan
    faces = wrc.rail_faces(sections)
    assert len(faces.faces) == 2 and faces.faces[0].outlines[0][0][-1] < 6.1e-3 and faces.faces[1].outlines[0][0][0] > 13.9e-3


def test_faces_that_a_model_holds():
    def beside(count):  # the last is higher than the others, which are no check rails
        heads = [rails.head(60e-3 * k - 35e-3, 60e-3 * k - 5e-3, 7e-3 if k + 1 < count else 0.0, corner=5e-3) for k in range(count)]
        return wrc.rail_faces([rails.section(x, *heads) for x in (0.0, 0.5)])

    six = beside(6)
    assert not six.thin and {each["surface"] for each in six.rail_sections} == set(range(6))
    found = rails.rolled(rails.model_of(six).contact("RIGHT"), [0.25])
    assert found[0, 1] == pytest.approx(60e3, rel=0.05)
    assert beside(9).thin == ["9 faces: a model holds 8. Give a shorter part of the track, or leave faces out"]


def test_parts_and_pictures(tmp_path):
    faces = wrc.rail_faces(rails.crossing())
    part = faces.part(0.2, 0.5)
    for face in part.faces:
        assert face.distances[0] <= 0.2 and face.distances[-1] >= 0.5 and len(face.distances) == len(face.outlines) == len(face.marks)
    wrc.plot.rail(faces, 0.0, 0.5, path=tmp_path / "rail.png")
    assert (tmp_path / "rail.png").stat().st_size > 50_000


def test_a_bogie_through_the_crossing(monkeypatch):
    monkeypatch.setattr(turnout, "WAY", 1.9)
    faces = wrc.rail_faces(rails.crossing(way=True))
    most = []
    for step in (1e-3, 5e-4):
        bogie = turnout.Bogie(faces, "main", 40 / 3.6)
        told = turnout.stepped(bogie, step)
        assert bogie.failures == bogie.flagged == 0 and len(told) == int(1.9 / bogie.speed / step)
        vertical = -np.array([forces[0, 2] for _, _, forces in told])
        most.append(vertical.max())
        assert vertical.min() > 0.0 and abs(told[-1][1][1] - told[0][1][1]) < 2e-4  # it stays on the rail, and stands as before
    assert 100e3 < most[0] < 250e3 and most[1] == pytest.approx(most[0], rel=0.25)


def test_dipped_joint_beside_the_formula():
    contact = rails.model_of(wrc.rail_faces(dipped_joint.rail())).contact("RIGHT")
    spring = dipped_joint.rolled(contact, 160 / 3.6)[:, 2].max()
    assert spring == pytest.approx(dipped_joint.formula(160 / 3.6), rel=0.02)
