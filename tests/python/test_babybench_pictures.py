"""Pictures and videos of evaluations, whose sizes and places are those of the competition's kit."""

import numpy as np
import pytest
from competition import logged, made

from mimo import babybench
from mimo.babybench import utils

TOUCHING = {"vision_active": False, "touch_scale": 5}


def where(picture, color):
    return np.argwhere((picture == color).all(axis=-1))


def test_a_frame_has_three_pictures():
    env = made("handregard", vision_active=False, touch_active=False, render_size=64)
    env.reset(seed=1)
    frame = utils.evaluation_img(env, up="binocular", down="closeup")
    assert (frame.shape, frame.dtype) == ((480, 720, 3), np.uint8)
    drawn = env.unwrapped.world.render
    np.testing.assert_array_equal(frame[:, :480], drawn(camera="corner", width=480, height=480))
    np.testing.assert_array_equal(frame[240:, 480:], drawn(camera="closeup", width=240, height=240))
    np.testing.assert_array_equal(frame[:240, 480:, 1], frame[:240, 480:, 2])  # the right eye in green and blue
    with pytest.raises(ValueError, match="touch_active"):
        utils.evaluation_img(env, up="touches_with_hands")


def test_touches_are_seen_from_above():
    env = made("selftouch", **TOUCHING)
    env.reset(seed=1)
    assert env.touch.sensor_outputs  # it lies on the mattress
    picture = utils.view_touches(env, contact_with="hands")
    assert (picture.shape, picture.dtype) == ((240, 240, 3), np.uint8)
    red, grey = where(picture, (255, 0, 0)), where(picture, (217, 217, 217))
    assert len(red) > 20
    assert len(grey) > 20
    # Its head points to -x, which is left; 0.9 m are 240 pixels, and the hip is in the middle.
    head = env.data.body("head").xpos - env.data.body("hip").xpos
    spot = (120 - 240 / 0.9 * head[1], 120 + 240 / 0.9 * head[0])
    assert spot[1] < 90
    assert np.min(np.linalg.norm(np.concatenate([red, grey]) - spot, axis=1)) < 20
    with pytest.raises(ValueError, match="contact_with is 'feet', expected 'hands' or None"):
        utils.view_touches(env, contact_with="feet")


def test_contacts_of_hands_are_yellow():
    env = made("selftouch", **TOUCHING, act_feet=False)
    env.action_space.seed(0)
    env.reset(seed=0)
    yellow = 0
    for _ in range(1000):  # random hands reach the head in each episode that was recorded with the kit
        _, _, _, _, info = env.step(env.action_space.sample())
        contacts = env.data.contact
        palms, body = [*env.right_hand_geoms, *env.left_hand_geoms], env.mimo_geoms
        pairs = zip(contacts.geom1.tolist(), contacts.geom2.tolist())
        touching = any((a in palms and b in body) or (b in palms and a in body) for a, b in pairs)
        if touching:
            yellow += len(where(utils.view_touches(env, contact_with="hands"), (255, 255, 0))) > 0
            assert yellow
            assert len(where(utils.view_touches(env), (255, 255, 0))) == 0
            break
    assert yellow == 1
    assert info["right_hand_touches"] or info["left_hand_touches"]


def test_videos_of_an_evaluation(tmp_path):
    av = pytest.importorskip("av", reason="PyAV (extra [video]) is not installed")
    pytest.importorskip("PIL")
    env = made("selftouch", **TOUCHING, save_dir=str(tmp_path))
    evaluation = babybench.EVALS["self_touch"](env=env, duration=5, render=True, save_dir=str(tmp_path))
    for episode in range(2):
        evaluation.reset()
        env.reset(seed=episode)
        for _ in range(5):
            evaluation.eval_step(env.step(env.action_space.sample())[4])
        evaluation.end(episode=episode)
    evaluation.eval_step(env.step(env.action_space.sample())[4])
    evaluation.reset()  # an episode that is given up
    assert len(logged(tmp_path, "evaluation_1.pkl")["qpos"]) == 5
    assert sorted(file.name for file in (tmp_path / "videos").iterdir()) == ["evaluation_0.avi", "evaluation_1.avi"]
    for episode in range(2):
        with av.open(str(tmp_path / f"videos/evaluation_{episode}.avi")) as file:
            (stream,) = file.streams.video
            assert (stream.width, stream.height, stream.average_rate) == (720, 480, 60)
            assert sum(1 for _ in file.decode(stream)) == 5


def test_videos_of_other_pictures(tmp_path):
    pytest.importorskip("av", reason="PyAV (extra [video]) is not installed")
    pytest.importorskip("PIL")
    film = tmp_path / "test.mp4"
    utils.evaluation_video([np.zeros((480, 480, 3), np.uint8)] * 3, save_name=film, resolution=(480, 480))
    assert film.stat().st_size > 0
    with pytest.raises(ValueError, match=r"shape \(480, 720, 3\), expected \(480, 480, 3\)"):
        utils.evaluation_video([np.zeros((480, 720, 3), np.uint8)], film, resolution=(480, 480))
    with pytest.raises(ValueError, match="save_name is None"):
        utils.evaluation_video([])
