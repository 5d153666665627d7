"""Stages of plain arrays in Python: what they show, and what they refuse. Numbers are from geometry."""

import logging

import numpy as np
import pytest

import mimo

BALL = {"forms": [mimo.Form.SPHERE], "sizes": [[0.5, 0, 0]], "colors": [[1, 0, 0, 1]], "object_type": 5}
FLAT = {"ambient": [1, 1, 1], "diffuse": [0, 0, 0], "specular": [0, 0, 0]}  # colours as they are painted
PLACE = {"geom_positions": [[0, 0, 0]], "geom_quaternions": [[1, 0, 0, 0]]}


def above(height=3.0, **settings):
    return mimo.StageView(position=[0, 0, height], rotation=np.eye(3), width=33, height=33, **settings)


@pytest.fixture
def stage():
    with mimo.Stage(geoms=BALL, air=FLAT) as made:
        yield made


def test_a_ball(stage):
    picture = stage.draw(PLACE, above(depth=True, segmentation=True))
    assert picture.rgb[16, 16].tolist() == [255, 0, 0]
    assert picture.depth[16, 16] == pytest.approx(2.5, rel=1e-5)
    assert picture.segmentation[16, 16].tolist() == [0, 5]
    assert picture.segmentation[0, 0].tolist() == [-1, -1]
    assert stage.draw(PLACE, above()).depth is None


def test_focal_lengths_and_a_principal_point(stage):
    """A ball 3 m away and 1 m right of the axis: 30 pixels of focal length put it 10 pixels right of that."""
    view = above(focal=[30, 30], center=[10.5, 20.5], rgb=False, segmentation=True)
    objects = stage.draw({**PLACE, "geom_positions": [[1, 0, 0]]}, view).segmentation
    rows, columns = np.nonzero(objects[..., 0] == 0)
    assert rows.mean() + 0.5 == pytest.approx(20.5, abs=0.1)
    assert columns.mean() + 0.5 == pytest.approx(20.5, abs=0.4)  # its outline is a little longer outwards


def test_an_orthographic_camera(stage):
    """33 pixels of 3.3 m: a ball of .5 m fills a circle of a radius of 5 pixels, wherever the camera is."""
    for height in (3, 30):
        picture = stage.draw(PLACE, above(height, ortho_height=3.3, rgb=False, depth=True, segmentation=True))
        seen = picture.segmentation[..., 0] == 0
        x, y = np.meshgrid(np.arange(33) - 16, np.arange(33) - 16)
        squares = (x * x + y * y) * 0.01
        assert (seen == (squares < 0.25))[np.abs(squares - 0.25) > 1e-3].all()  # but for the outline itself
        expected = height - np.sqrt(np.maximum(0.25 - squares, 0))
        np.testing.assert_allclose(picture.depth[squares < 0.2], expected[squares < 0.2], atol=1e-4)
    with pytest.raises(mimo.ArgumentError, match="ortho_height is -1, expected metres above 0"):
        stage.draw(PLACE, above(ortho_height=-1))


def test_many_poses_and_views(stage):
    poses = [{**PLACE, "geom_positions": [[0, 0, z]]} for z in (0, 1)]
    views = [above(rgb=False, depth=True, pose=i) for i in (1, 0)]
    assert [one.depth[16, 16] for one in stage.draw(poses, views)] == pytest.approx([1.5, 2.5], rel=1e-5)


def test_parts_are_replaced(stage):
    stage.update(geoms={**BALL, "colors": [[0, 1, 0, 1]]})
    assert stage.draw(PLACE, above()).rgb[16, 16].tolist() == [0, 255, 0]


def test_textures_begin_in_the_middle_or_at_a_corner():
    """Black and white, laid twice over a plane 2 m wide: in its middle a repetition is half over, or begins."""
    pixels = np.repeat(np.array([[0, 255]], np.uint8), 3, axis=1)
    plane = {"forms": [mimo.Form.PLANE], "sizes": [[1, 1, 1]], "colors": [[0.5, 0.5, 0.5, 1]], "materials": [0]}
    textures = {"types": [mimo.TextureType.FLAT], "widths": [2], "heights": [1], "pixels": pixels}
    shown = []
    for corner in (0, 1):
        paint = {"colors": [[1, 1, 1, 1]], "textures": [0], "repeats": [[2, 2]], "from_corner": corner}
        with mimo.Stage(geoms=plane, materials=paint, textures=textures, air=FLAT) as stage:
            row = stage.draw(PLACE, above(fovy=30)).rgb[16, :, 0].astype(int)
        shown.append([row[16 + 5] > 127, row[16 - 5] > 127])  # a quarter of a metre right and left of the middle
    assert shown == [[True, False], [False, True]]


def test_a_sun_with_a_reach_casts_shadows_from_its_place():
    """A ball above the sun's place has no shadow then, one below it has."""
    geoms = {
        "forms": [mimo.Form.PLANE, mimo.Form.SPHERE],
        "sizes": [[5, 5, 1], [0.2, 0, 0]],
        "colors": [[1, 1, 1, 1], [1, 0, 0, 1]],
    }
    air = {"ambient": [0.2] * 3, "diffuse": [0] * 3, "specular": [0] * 3}
    dark = []
    for reach in (0, 10):
        with mimo.Stage(geoms=geoms, lights={"types": [mimo.Lamp.SUN]}, air={**air, "sun_reach": reach}) as stage:
            for z in (1.0, 3.0):
                poses = {
                    "geom_positions": [[0, 0, 0], [0, 0, z]],
                    "geom_quaternions": [[1, 0, 0, 0]] * 2,
                    "light_positions": [[0, 0, 2]],
                    "light_directions": [[0.6, 0, -0.8]],
                }
                view = mimo.StageView([0.75 * z, 0, 0.5], np.eye(3), width=33, height=33)
                dark.append(bool(stage.draw(poses, view).rgb[16, 16, 0] < 128))
    assert dark == [True, True, True, False]


def test_what_is_wrong_is_named(stage):
    with pytest.raises(ValueError, match=r"geoms\['sizes'\] has 2 elements, expected 1, as geoms\['forms'\]"):
        mimo.Stage(geoms={**BALL, "sizes": [[1, 0, 0], [1, 0, 0]]})
    with pytest.raises(ValueError, match=r"geoms\['sizes'\] of the shape \(1, 2\), expected n x 3"):
        mimo.Stage(geoms={**BALL, "sizes": [[1, 0]]})
    with pytest.raises(TypeError, match=r"geoms\['forms'\]: expected whole numbers, not float64"):
        mimo.Stage(geoms={**BALL, "forms": [2.0]})
    with pytest.raises(ValueError, match=r"geoms\['forms'\] has 2147483648, expected -2147483648 to 2147483647"):
        mimo.Stage(geoms={**BALL, "forms": np.array([2**31])})
    with pytest.raises(TypeError, match=r"geoms: unexpected.*'colours'; did you mean 'colors'"):
        mimo.Stage(geoms={**BALL, "colours": [[1, 0, 0, 1]]})
    with pytest.raises(TypeError, match="unexpected keyword argument 'geom'"):
        mimo.Stage(geom=BALL)
    with pytest.raises(TypeError, match=r"air: unexpected.*'near'"):
        mimo.Stage(air={"near": 1})
    with pytest.raises(ValueError, match=r"geoms: materials\[0\] is 3"):
        mimo.Stage(geoms={**BALL, "materials": [3]})
    with pytest.raises(ValueError, match=r"geoms: sizes\[0, 0\] is -1"):
        mimo.Stage(geoms={**BALL, "sizes": [[-1, 0, 0]]})
    with pytest.raises(ValueError, match="materials: from_corner is 2, expected 0 or 1"):
        mimo.Stage(materials={"colors": [[1, 1, 1, 1]], "from_corner": 2})
    with pytest.raises(ValueError, match="air: sun_reach is -1, expected metres"):
        mimo.Stage(air={"sun_reach": -1})
    with pytest.raises(ValueError, match="geom_count is 2, expected 1, or 0"):
        stage.draw({"geom_positions": np.zeros((2, 3)), "geom_rotations": np.zeros((2, 9))}, above())
    with pytest.raises(ValueError, match=r"geom_positions\[0, 2\] is nan"):
        stage.draw({**PLACE, "geom_positions": [[0, 0, np.nan]]}, above())
    with pytest.raises(ValueError, match="pose is 1, but there are 1 poses"):
        stage.draw(PLACE, above(pose=1))
    for size in (0, 2**31):
        with pytest.raises(ValueError, match=f"width is {size}, expected 1 to 16384"):
            mimo.StageView([0, 0, 1], np.eye(3), width=size)
    with pytest.raises(ValueError, match=r"rotation of the shape \(2, 2\), expected \(3, 3\)"):
        mimo.StageView([0, 0, 1], np.eye(2))
    assert stage.draw(PLACE, above()).rgb[16, 16].tolist() == [255, 0, 0]


def test_what_is_not_drawn_is_told(caplog):
    with caplog.at_level(logging.WARNING, "mimo"):
        mimo.Stage(geoms={**BALL, "forms": [100]}).close()
    told = [record.message for record in caplog.records if record.name == "mimo"]
    caplog.clear()
    assert told == ["geom 0 is not drawn: its form is 100, expected 0 to 8"]


def test_a_closed_stage(stage):
    stage.close()
    with pytest.raises(mimo.ClosedError):
        stage.draw(PLACE, above())
