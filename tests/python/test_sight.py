"""Faces, gaze, further cameras, and what pictures show."""

import math
import multiprocessing
import pickle

import numpy as np
import pytest

import mimo

BLIND = {"vision": False, "touch": False}


@pytest.fixture
def free():
    with mimo.World("free", face="sadness", **BLIND) as world:
        world.reset(seed=1)
        yield world


def close_up(world):
    look_at = world.bodies("head").position[0] + [0, 0, 0.07]
    return world.render(width=64, height=64, look_at=look_at, distance=0.3, azimuth=180, elevation=0)


def test_faces(free):
    assert len(mimo.faces()) == 7  # no emotion, and the six basic ones
    assert free.face() == "sadness"
    sad = close_up(free)
    twin = free.clone()
    free.set_face("fear")
    assert (free.face(), twin.face()) == ("fear", "sadness")
    assert not np.array_equal(sad, close_up(free))
    free.reset(seed=1)
    assert free.face() == "fear"
    free.load(twin.save())
    np.testing.assert_array_equal(sad, close_up(free))
    with pytest.raises(mimo.NotFoundError, match=r"boredom.*surprise"):
        free.set_face("boredom")
    with pytest.raises(ValueError, match="agent is 1"):
        free.face(agent=1)
    with pytest.raises(mimo.NotFoundError, match="boredom"):
        mimo.make("free", face="boredom")


def test_faces_of_a_batch():
    with mimo.Batch("free", 3, **BLIND) as batch:
        batch.set_face("anger", mask=np.array([True, False, True]))
        assert [batch.world(i).face() for i in range(3)] == ["anger", "neutral", "anger"]
        batch.set_face("fear")
        assert [batch.world(i).face() for i in range(3)] == ["fear"] * 3
        with pytest.raises(ValueError, match="mask has the shape"):
            batch.set_face("fear", mask=np.array([True]))


def test_lines_of_sight_meet_where_it_looks(free):
    gaze = free.gaze()
    # The eyes' centres are 49 mm apart: 2 atan(0.0245 m / d) is the vergence at a distance d straight ahead.
    point = (gaze.left.position + gaze.right.position) / 2 + [0.4, 0, 0]
    planned = free.look_angles(point, mimo.Look.HEAD)
    assert len(planned.joints) == len(planned.angles) == 8
    assert planned.joints[2:] == free.look_angles(point).joints
    assert np.abs(free.look_at(point, mimo.Look.HEAD)).max() < 1e-6
    np.testing.assert_allclose(free.joints(*planned.joints).position, planned.angles, atol=1e-12)
    gaze = free.gaze()
    np.testing.assert_allclose(gaze.point, point, atol=1e-6)
    assert gaze.vergence == pytest.approx(2 * math.atan(0.0245 / 0.4), abs=0.02)
    assert np.linalg.norm(gaze.left.direction) == pytest.approx(1)
    behind = free.look_at(gaze.left.position - [1, 0, 0])
    assert behind.min() > 1  # 180 degrees, of which the eyes reach 45
    with pytest.raises(ValueError, match=r"point is \[1, 2\], expected 3 numbers"):
        free.look_at([1, 2])
    with pytest.raises(ValueError, match=r"point\[1\] is nan"):
        free.look_at([1, np.nan, 0])


def room():
    scene = mimo.Scene("free")
    scene.add_agent(**BLIND)
    scene.add_camera(
        "wall",
        width=32,
        height=24,
        outputs=mimo.Vision.RGB | mimo.Vision.DEPTH,
        position=[1.5, 0, 0.8],
        look_at=[0, 0, 0.4],
    )
    scene.add_camera("palm", width=8, height=8, body="left_hand", look_at=[0, 0, 1])
    scene.add_camera("eye_left", width=16, height=8, outputs=mimo.Vision.SEGMENTATION)
    return scene


@pytest.mark.parametrize("through", [lambda it: it, lambda it: it.copy(), lambda it: pickle.loads(pickle.dumps(it))])
def test_cameras_are_fields(through):
    world = mimo.World(through(room()))
    seen = world.reset(seed=1)
    shapes = {name: field.shape for name, field in seen.items() if name.startswith("vision/")}
    assert shapes == {
        "vision/wall": (24, 32, 3),
        "vision/wall_depth": (24, 32),
        "vision/palm": (8, 8, 3),
        "vision/eye_left_segmentation": (8, 16),
    }
    np.testing.assert_array_equal(seen["vision/wall"], world.render(camera="wall", width=32, height=24))
    # The middle of the picture is before the point that the camera looks at, sqrt(1.5^2 + 0.4^2) m away.
    assert 0.5 < seen["vision/wall_depth"][12, 16] < math.hypot(1.5, 0.4) + 0.2


def test_bad_cameras_are_refused():
    scene = room()
    with pytest.raises(ValueError, match="observed already"):
        scene.add_camera("wall", width=8, height=8)
    with pytest.raises(mimo.NotFoundError, match="nobody"):
        scene.add_camera("other", body="nobody", look_at=[0, 0, 1])
    scene.add_camera("periscope")
    with pytest.raises(mimo.NotFoundError, match="periscope"):
        mimo.World(scene)


def test_cameras_in_environments():
    env = mimo.make_vec(room(), num_envs=2)
    observation, _ = env.reset(seed=0)
    assert observation["vision/palm"].shape == (2, 8, 8, 3)
    assert env.single_observation_space["vision/wall_depth"].shape == (24, 32)
    env.close()


def test_effects_of_pictures():
    plain = mimo.World("benchmark", renderer="ray", render=mimo.Render(0), **BLIND)
    default = mimo.World("benchmark", renderer="ray", **BLIND)
    smooth = mimo.World("benchmark", renderer="ray", samples=16, render_threads=2, **BLIND)
    pictures = [world.render(width=64, height=48) for world in (plain, default, smooth)]
    assert not np.array_equal(pictures[0], pictures[1])
    assert not np.array_equal(pictures[1], pictures[2])
    same = mimo.World("benchmark", renderer="ray", samples=16, **BLIND).render(width=64, height=48)
    np.testing.assert_array_equal(pictures[2], same)
    with pytest.raises(ValueError, match="samples is 3"):
        mimo.World("benchmark", samples=3, **BLIND)


def drawn_by(renderer):
    """Of a process of its own: MuJoCo keeps to the first OpenGL that it draws with."""
    picture = mimo.World("benchmark", renderer=renderer, **BLIND).draw(width=128, height=128)
    return picture.rgb, picture.depth, picture.segmentation


def test_a_graphics_card_draws_what_osmesa_draws():
    with multiprocessing.get_context("spawn").Pool(1, maxtasksperchild=1) as pool:
        try:
            card, mesa = pool.map(drawn_by, ["gl", "osmesa"], chunksize=1)
        except mimo.UnsupportedError as missing:
            pytest.skip(str(missing))
    assert np.abs(card[0].astype(int) - mesa[0]).mean() < 0.25  # of 255; as tests/capi/gl.c
    assert np.isclose(card[1], mesa[1], rtol=1e-3, atol=1e-3).mean() > 0.999
    assert (card[2] == mesa[2]).mean() > 0.999
    assert len(np.unique(card[2])) > 5  # it shows something
