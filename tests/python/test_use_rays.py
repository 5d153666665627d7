"""mimo.gymnasium.use_rays: environments of Gymnasium, dm_control and robosuite that draw with rays."""

import os
import subprocess
import sys

import numpy as np
import pytest

import mimo
import mimo.gymnasium

pytest.importorskip("mujoco", reason="the package mujoco is not installed")


@pytest.fixture(autouse=True)
def _no_opengl(monkeypatch):
    """Whatever draws with OpenGL fails."""
    monkeypatch.setenv("MUJOCO_GL", "disabled")
    yield
    mimo.gymnasium.use_opengl()


def gymnasium_rendering():
    return pytest.importorskip(
        "gymnasium.envs.mujoco.mujoco_rendering", reason="Gymnasium's MuJoCo environments are not installed"
    )


def test_gymnasium_draws_with_rays():
    gymnasium_rendering()
    import gymnasium

    mimo.gymnasium.use_rays()
    env = gymnasium.make("InvertedPendulum-v5", render_mode="rgb_array", width=96, height=64)
    env.reset(seed=0)
    frame = env.render()
    assert (frame.shape, frame.dtype) == ((64, 96, 3), np.uint8)
    plain = env.unwrapped
    with mimo.Renderer(plain.model, 64, 96) as renderer:
        renderer.update_scene(plain.data, plain.mujoco_renderer.viewer.cam)
        np.testing.assert_array_equal(frame, renderer.render())
        renderer.enable_depth_rendering()
        metres = renderer.render().astype(float)
    depth = plain.mujoco_renderer.render("depth_array")
    near, far = (plain.model.stat.extent * one for one in (plain.model.vis.map.znear, plain.model.vis.map.zfar))
    np.testing.assert_allclose(near / (1 - depth * (1 - near / far)), metres, rtol=2e-3)  # as OpenGL's depth is read
    colours, again = plain.mujoco_renderer.render("rgbd_tuple")
    np.testing.assert_array_equal(colours, frame)
    np.testing.assert_array_equal(again, depth)
    env.close()


def test_gymnasium_s_markers_are_drawn():
    rendering = gymnasium_rendering()
    import mujoco

    mimo.gymnasium.use_rays()
    model = mujoco.MjModel.from_xml_string('<mujoco><worldbody><geom size=".1" rgba="0 0 1 1"/></worldbody></mujoco>')
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    viewer = rendering.OffScreenViewer(model, data, 33, 33)
    alone = viewer.render("rgb_array")
    kind, size = int(mujoco.mjtGeom.mjGEOM_SPHERE), np.full(3, 0.05)
    viewer.add_marker(type=kind, pos=np.zeros(3) + viewer.cam.lookat, size=size * 3, rgba=np.array([1, 0, 0, 1.0]))
    marked = viewer.render("rgb_array")
    assert alone[16, 16, 2] > alone[16, 16, 0]
    assert marked[16, 16, 0] > marked[16, 16, 2]
    np.testing.assert_array_equal(viewer.render("rgb_array"), alone)


def test_videos_are_recorded(tmp_path):
    gymnasium_rendering()
    pytest.importorskip("moviepy", reason="Gymnasium's RecordVideo needs moviepy")
    import gymnasium

    mimo.gymnasium.use_rays()
    env = gymnasium.make("InvertedPendulum-v5", render_mode="rgb_array", width=64, height=64)
    env = gymnasium.wrappers.RecordVideo(env, str(tmp_path), episode_trigger=lambda episode: True)
    env.reset(seed=0)
    for _ in range(3):
        env.step(env.action_space.sample())
    env.close()
    assert [file.stat().st_size > 500 for file in tmp_path.glob("*.mp4")] == [True]


def test_undo_gives_opengl_back():
    viewer = gymnasium_rendering().OffScreenViewer
    before = dict(vars(viewer))
    with mimo.gymnasium.use_rays(samples=4) as first:
        assert vars(viewer)["__init__"] is not before["__init__"]
        second = mimo.gymnasium.use_rays()
        first.undo()
        assert vars(viewer)["__init__"] is not before["__init__"]
        second.undo()
    assert dict(vars(viewer)) == before


def test_packages_may_be_imported_afterwards():
    gymnasium_rendering()
    code = (
        "import mimo.gymnasium, sys\n"
        "rays = mimo.gymnasium.use_rays()\n"
        "assert 'gymnasium' not in sys.modules\n"
        "from gymnasium.envs.mujoco import mujoco_rendering\n"
        "assert mujoco_rendering.OffScreenViewer.__init__.__module__ == 'mimo.takeover.gymnasium'\n"
        "rays.undo()\n"
        "assert mujoco_rendering.OffScreenViewer.__init__.__module__ != 'mimo.takeover.gymnasium'\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_dm_control_draws_with_rays():
    pytest.importorskip("dm_control", reason="dm_control is not installed")
    from dm_control import mujoco

    mimo.gymnasium.use_rays()
    xml = '<mujoco><worldbody><geom size=".1" rgba="1 0 0 1"/><camera name="a" pos="0 0 1"/></worldbody></mujoco>'
    try:
        physics = mujoco.Physics.from_xml_string(xml)
    except AttributeError as error:
        pytest.skip(f"this dm_control does not go with this MuJoCo: {error}")
    frame = physics.render(32, 48, camera_id="a")
    assert (frame.shape, frame.dtype) == ((32, 48, 3), np.uint8)
    assert frame[16, 24, 0] > 3 * frame[16, 24, 1]
    assert physics.render(32, 48, camera_id="a", depth=True)[16, 24] == pytest.approx(0.9, rel=1e-2)
    assert physics.render(32, 48, camera_id="a", segmentation=True)[16, 24].tolist() == [0, 5]
    assert physics.render(64, 64).shape == (64, 64, 3)
    with pytest.raises(ValueError, match="camera_id=3 is invalid"):
        physics.render(32, 48, camera_id=3)

    def add_ball(physics, scene):
        import mujoco as engine

        sphere, place, turn = int(engine.mjtGeom.mjGEOM_SPHERE), np.array([0, 0, 0.3]), np.eye(3).ravel()
        scene.ptr.ngeom += 1
        geom = scene.ptr.geoms[scene.ptr.ngeom - 1]
        engine.mjv_initGeom(geom, sphere, np.full(3, 0.1), place, turn, np.array([0, 1, 0, 1], np.float32))

    green = physics.render(32, 48, camera_id="a", scene_callback=add_ball)
    assert green[16, 24, 1] > 3 * green[16, 24, 0]


def test_robosuite_draws_with_rays():
    utils = pytest.importorskip("robosuite.utils.binding_utils", reason="robosuite is not installed")
    mimo.gymnasium.use_rays()
    xml = (
        '<mujoco><worldbody><geom size=".1" rgba="1 0 0 1" pos="0 .3 0"/>'
        '<camera name="a" pos="0 0 1"/></worldbody></mujoco>'
    )
    sim = utils.MjSim.from_xml_string(xml)
    utils.MjRenderContextOffscreen(sim, device_id=-1)
    colours, depth = sim.render(width=48, height=32, camera_name="a", depth=True)
    assert (colours.shape, depth.shape) == ((32, 48, 3), (32, 48))
    rows = np.nonzero(colours[:, 24, 0] > 100)[0]
    assert rows.min() > 16  # above the middle, and rows begin at the bottom
    assert 0 <= depth.min() < depth.max() == 1
    objects = sim.render(width=48, height=32, camera_name="a", segmentation=True)
    assert objects[rows[0], 24].tolist() == [5, 0]  # the type comes first


def test_an_alpha_below_0_hides():
    """robosuite hides its sites so."""
    import mujoco

    xml = (
        '<mujoco><worldbody><geom size=".1"/><site size=".2" rgba="1 0 0 -1"/>'
        '<camera name="a" pos="0 0 1"/></worldbody></mujoco>'
    )
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    pictures = []
    for alpha in (-1, 0):
        model.site_rgba[0, 3] = alpha
        with mimo.Renderer(model, 32, 32) as renderer:
            renderer.update_scene(data, "a")
            pictures.append(renderer.render())
    assert pictures[0][16, 16, 1] > 50
    np.testing.assert_array_equal(*pictures)


LIFT = """
import sys
import numpy as np
import robosuite
cameras = ["frontview", "birdview", "agentview", "sideview", "robot0_robotview", "robot0_eye_in_hand"]
env = robosuite.make(
    "Lift", robots="Panda", has_renderer=False, has_offscreen_renderer=True, camera_names=cameras,
    camera_heights=128, camera_widths=128, camera_depths=True, camera_segmentations="element", seed=0,
)
env.set_xml_processor(lambda xml: xml.replace("<visual>", '<visual><quality offsamples="0"/>', 1))  # edges not smooth
np.savez(sys.argv[1], **{name: value for name, value in env.reset().items() if name.startswith(tuple(cameras))})
"""


def lift(file, before, gl):
    """Camera observations of a program in a process of its own."""
    environment = {**os.environ, "MUJOCO_GL": gl}
    subprocess.run([sys.executable, "-c", before + LIFT, file], check=True, env=environment, capture_output=True)
    return np.load(file)


def test_the_whole_lift_of_robosuite_looks_as_with_opengl(tmp_path):
    pytest.importorskip("robosuite", reason="robosuite is not installed")
    ours = lift(tmp_path / "ours.npz", "import mimo.gymnasium\nmimo.gymnasium.use_rays()\n", "disabled")
    try:
        theirs = lift(tmp_path / "theirs.npz", "", "osmesa")
    except subprocess.CalledProcessError:
        pytest.skip("there is no OSMesa on this machine")
    assert sorted(ours) == sorted(theirs)
    assert len(theirs.files) == 6 * 3
    for name in theirs.files:
        one, other = ours[name].astype(float), theirs[name].astype(float)
        assert (ours[name].dtype, one.shape) == (theirs[name].dtype, other.shape)
        if name.endswith("image"):
            assert np.abs(one - other).mean() < 2, name  # of 255
        elif name.endswith("depth"):
            assert (np.abs(one - other) > 1e-3).mean() < 0.005, name
        else:
            assert (one != other).mean() < 0.005, name


def test_the_window_of_robosuite_shows_rays(monkeypatch):
    robosuite = pytest.importorskip("robosuite", reason="robosuite is not installed")
    from robosuite.renderers.viewer import opencv_renderer

    shown = []
    monkeypatch.setattr(opencv_renderer.cv2, "imshow", lambda window, picture: shown.append(picture))
    monkeypatch.setattr(opencv_renderer.cv2, "moveWindow", lambda *place: None)
    monkeypatch.setattr(opencv_renderer.cv2, "waitKey", lambda milliseconds: -1)
    monkeypatch.setattr(opencv_renderer.cv2, "destroyWindow", lambda window: None)
    mimo.gymnasium.use_rays()
    env = robosuite.make(
        "Lift", robots="Panda", has_renderer=True, renderer="mujoco", has_offscreen_renderer=True, use_camera_obs=False
    )
    env.reset()
    env.render()
    (picture,) = shown
    assert picture.shape == (800, 1280, 3)
    with mimo.Renderer(env.sim.model._model, 800, 1280) as renderer:
        context = env.sim._render_context_offscreen
        renderer.update_scene(env.sim.data._data, context.cam, context.vopt)
        np.testing.assert_array_equal(picture[..., ::-1], renderer.render())
    env.close()
