"""The viewer: what is sent to the page, and the page in a real browser."""

import io
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.request

import gymnasium
import numpy as np
import pytest
from recorded import record, table_of

import mimo
from mimo import cubes, view
from mimo.constants import TextureType
from mimo.drawing import SEGMENTS, on_bodies
from mimo.frames import placed, turned
from mimo.geometry import Appearance, Texture
from mimo.view.clock import Clock
from mimo.view.motors import Motors
from mimo.view.pull import Pull
from mimo.view.senses_panel import line, others
from mimo.view.shapes import lit

STATUS = re.compile(r"([0-9.]+) s \(([^)]*)\)")


def viewer_or_skip(*arguments, **options):
    pytest.importorskip("viser", reason="viser is not installed")
    pytest.importorskip("PIL", reason="Pillow is not installed")
    return view.Viewer(*arguments, **options)


# ---- Without a page -------------------------------------------------------------------------------------------------


def test_the_clock_follows_the_wall(monkeypatch):
    """At double speed 0.05 s of the wall are 10 steps of 0.01 s."""
    now = [100.0]
    monkeypatch.setattr(time, "perf_counter", lambda: now[0])
    clock = Clock(0.01)
    clock.speed = 2.0
    now[0] += 0.0501
    assert clock.due() == 10
    clock.done(10, False)
    clock.paused = True
    now[0] += 5
    assert clock.due() == 0
    clock.step_once()
    assert (clock.due(), clock.due()) == (1, 0)
    clock.paused = False
    now[0] += 60.001
    assert clock.due() == 12000
    clock.done(3, True)
    assert clock.due() == 0  # what was missed is not run after


def test_random_actions_are_those_of_a_seed():
    with mimo.World("reach") as world:
        motors = Motors(world, 0.01)
        rows = []
        for _ in range(2):
            motors.restart(7)
            rows.append([motors.next() for _ in range(60)])
        np.testing.assert_array_equal(*rows)
        assert len(np.unique(rows[0], axis=0)) == 3  # held for 0.25 s
        assert (rows[0] >= world.action_low).all()
        assert (rows[0] <= world.action_high).all()
        motors.choice = "at rest"
        assert not motors.next().any()


def test_a_pull_holds_a_weight_where_a_spring_would():
    """A ball of 0.5 kg hangs m g / k below where it is pulled to."""
    scene = mimo.Scene()
    scene.add_object("ball", position=[0, 0, 1], mass=0.5)
    with mimo.World(scene) as world:
        pull = Pull(world)
        pull.choose("ball")
        pull.to([0.3, 0, 1])
        for _ in range(1000):
            pull.apply(world.timestep * world.frame_skip)
            world.step()
        np.testing.assert_allclose(pull.position, [0.3, 0, 1 - 0.5 * 9.81 / pull.stiffness], atol=1e-4)
        np.testing.assert_allclose(pull.force, [0, 0, 0.5 * 9.81], atol=1e-2)
        pull.release()
        for _ in range(10):
            world.step()
        assert pull.position[2] < 0.97  # it falls


def test_skin_in_much_light_stays_skin():
    """Skin of MuJoCo's (0.56, 0.47, 0.39) under 2.5 times the light would be (1.4, 1.175, 0.975): divided by 1.4."""
    skin = Appearance(True, 0, -1, (0.56, 0.47, 0.39, 1.0), 0.8, 0.0, 0.0, 0.0)
    np.testing.assert_allclose(lit(skin, 1.7).color, (1, 1.175 / 1.4, 0.975 / 1.4, 1), atol=1e-6)
    np.testing.assert_allclose(lit(skin, 0.2).color, (0.56, 0.47, 0.39, 1), atol=1e-6)  # what is not too bright stays


def test_faces_of_cubes_do_not_bleed():
    """An eighth of the size, as a mipmap has it: each place on a face has that face's colour and no other's."""
    edge = 64
    faces = np.repeat(np.arange(6, dtype=np.uint8) * 40, edge * edge).reshape(6 * edge, edge, 1)
    texture = Texture(TextureType.CUBE, np.repeat(faces, 4, axis=2))
    ends = np.array([0.5, edge / 2 + 0.5, edge - 0.5]) / edge  # the middles of the first pixel and of the last one
    given = np.array([(u, (face + v) / 6) for face in range(6) for v in ends for u in ends], np.float32)
    picture = cubes.picture(texture)[..., 0].astype(np.float64)
    small = picture.reshape(len(picture) // 8, 8, -1, 8).mean(axis=(1, 3))
    at = cubes.places(texture, given) * small.shape[::-1] - 0.5  # in pixels, between whose middles engines mix
    for (u, v), face in zip(at, np.repeat(range(6), 9)):
        around = small[int(v) : int(v) + 2, int(u) : int(u) + 2]
        assert (around == 40 * face).all()
    full = cubes.places(texture, given) * picture.shape[::-1]
    np.testing.assert_allclose(full % 1, 0.5, atol=1e-3)  # pixels stay pixels
    flat = Texture(TextureType.FLAT, texture.pixels)
    np.testing.assert_array_equal(cubes.places(flat, given), given)
    np.testing.assert_array_equal(cubes.picture(flat), texture.pixels[..., :3])


# ---- What is sent to the page ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def shown():
    with viewer_or_skip(view.Live("benchmark", vision_width=32, vision_height=32)) as viewer:
        viewer.clock.paused = True
        yield viewer


def advance(viewer, seconds):
    for _ in range(round(seconds / 0.01)):
        viewer.clock.step_once()
        viewer.frame()


def vertices(handle):
    """Of a shape that was sent, in its node's frame."""
    import trimesh

    made = trimesh.load(io.BytesIO(handle._impl.props.glb_data), file_type="glb", process=False)
    (mesh,) = made.geometry.values()
    return mesh


def turned_to_body(world, geom, vectors):
    return turned(on_bodies(world).rotations[geom], vectors)


def test_shapes_are_where_the_library_has_them(shown):
    advance(shown, 0.3)
    world, shapes = shown._source.world, shown._page.shapes
    geoms = world.poses("geom")
    for name in ("head", "left_uarm1", "floor"):
        geom = world.find("geom", name)
        mesh, node = vertices(shapes._shown[geom]), shapes._bodies[int(shapes._body_of[geom])]
        sent = placed(node.position, node.wxyz, mesh.vertices)
        ours = world.mesh(geom, segments=SEGMENTS, plane=5.0)
        there = placed(geoms.positions[geom], geoms.rotations[geom], ours.positions)
        np.testing.assert_allclose(sent, there, atol=5e-5)  # nodes that moved by less than 1e-5 stay
        np.testing.assert_array_equal(mesh.faces, ours.triangles)
        texcoords = cubes.places(world.texture(world.appearance(geom).texture), ours.texcoords)
        np.testing.assert_allclose(mesh.visual.uv[:, 1], 1 - texcoords[:, 1], atol=1e-6)
        np.testing.assert_allclose(mesh.vertex_normals, turned_to_body(world, geom, ours.normals), atol=1e-6)


def test_a_face_and_an_age_change_the_shapes(shown):
    world, shapes = shown._source.world, shown._page.shapes
    head, arm = world.find("geom", "head"), world.find("geom", "left_uarm1")
    before = shapes._shown[head], shapes._shown[arm]
    world.set_face("surprise")
    shown.frame()
    assert shapes._shown[head] is not before[0]
    assert shapes._shown[arm] is before[1]
    pixels = np.asarray(vertices(shapes._shown[head]).visual.material.baseColorTexture)
    np.testing.assert_array_equal(pixels[..., :3], cubes.picture(world.texture(world.appearance("head").texture)))
    tall = np.ptp(vertices(shapes._shown[head]).vertices[:, 2])
    shown._page.infants._given[0] = 1.0
    shown.restart()
    shown.frame()
    assert world.get(mimo.Quantity.AGENT_AGE)[0] == 1
    assert np.ptp(vertices(shapes._shown[head]).vertices[:, 2]) < 0.9 * tall
    shown._page.infants._given[0] = 18.0
    shown.restart()
    world.set_face("neutral")


def test_touch_and_contacts(shown):
    """What lies still is carried by the floor: the arrows together are its weight, at 3 mm for a newton."""
    shown._page.motors.choice = "at rest"
    shown.restart()
    advance(shown, 4)
    world = shown._source.world
    touch, contacts = shown._page._marks[:2]
    felt = np.linalg.norm(world.observation["touch/force"], axis=1) > 0
    assert len(touch._handle.points) - 1 == felt.sum() > 10
    floor = world.find("geom", "floor")
    both, points = world.contacts(), contacts._handle.points[1:]
    assert len(points) == len(both.geoms)
    on_floor = (both.geoms == floor).any(axis=1)
    up = (points[on_floor, 1] - points[on_floor, 0])[:, 2].sum() / 0.003
    others = world.bodies("test_object1", "test_object2").mass.sum()
    weight = 9.81 * (world.agents[0].mass + others)
    assert up == pytest.approx(weight, rel=0.1)  # it still moves a little
    shown._page.motors.choice = "random"


def test_joints_are_moved_by_sliders(shown):
    world, sliders = shown._source.world, shown._page._joints
    elbow = sliders._joints.names.index("robot:left_elbow")
    sliders._put(elbow, -1.0)
    assert world.joints("robot:left_elbow").position.item() == -1.0
    sliders.update()
    assert sliders._sliders[elbow].value == -1.0
    assert sliders._sliders[elbow].min == round(world.joints("robot:left_elbow").range.ravel()[0], 2)
    for slider in sliders._sliders:  # no more than two digits after the point
        for number in (slider.min, slider.max, slider.value, slider.step):
            assert number == round(number, 2)


def test_the_infant_stays_in_the_middle(shown):
    """However it moves: the world lies so that the middle of its bodies is at 0, which the camera looks at."""
    world, camera = shown._source.world, shown._page.camera
    advance(shown, 0.2)
    bodies = [body for body, name in enumerate(world.bodies().names) if name in ("hip", "head", "left_foot")]
    fly = world.get(mimo.Quantity.JOINT_POSITION, ["mimo_orientation"]).ravel()
    world.set(mimo.Quantity.JOINT_POSITION, [3, -2, *fly[2:]], ["mimo_orientation"])
    world.update()
    for _ in range(60):
        shown._page.update()
    seen = world.poses("body").positions[bodies] + camera._root.position
    assert np.abs(seen).max() < 0.55  # m; an infant is 0.8 m long
    assert tuple(shown._server.initial_camera.look_at) == (0, 0, 0)
    camera.follows, before = False, camera._root.position.copy()
    shown.restart()
    shown._page.update()
    np.testing.assert_array_equal(camera._root.position, before)
    camera.follows = True


@pytest.mark.parametrize("scene", ["benchmark", "playdate", "babybench-crib", "rollover"])
@pytest.mark.parametrize("aspect", [0.46, 1.0, 1.8])
def test_the_page_begins_close_to_the_infant(scene, aspect):
    """The whole infant is in the picture, and takes most of its narrower side."""
    with viewer_or_skip(view.Live(scene, vision=False)) as viewer:
        world, camera = viewer._source.world, viewer._page.camera
        away = np.array(camera._position(aspect))
        azimuth, above = np.arctan2(-away[1], -away[0]), -np.arcsin(away[2] / np.linalg.norm(away))
        picture = {"width": round(1000 * aspect), "height": 1000, "fovy": np.degrees(viewer._server.initial_camera.fov)}
        picture.update(look_at=camera._middle.tolist(), distance=float(np.linalg.norm(away)))
        picture.update(azimuth=float(np.degrees(azimuth)), elevation=float(np.degrees(above)))
        x, y, _ = world.project(world.poses("body").positions[camera._bodies], **picture).T
        assert x.min() >= 0
        assert x.max() <= picture["width"]
        assert y.min() >= 0
        assert y.max() <= 1000
        assert max(np.ptp(x), np.ptp(y)) > 0.45 * min(picture["width"], 1000)


def test_muscles_name_their_infant():
    with viewer_or_skip(view.Live("playdate", vision=False)) as viewer:
        advance_once(viewer)
        shown = [html.content for _, _, html in viewer._page._senses._bars]
        assert ["anna" in content for content in shown] == [True, False]
        assert ["ben" in content.replace("bend", "") for content in shown] == [False, True]


def test_fields_of_senses_of_ones_own_are_shown():
    scene = mimo.Scene("playdate")
    scene.add_agents(vision=False)
    scene.add_field("toy/position", "body_position", "toy")
    assert others(mimo.World(scene)) == ["toy/position"]
    with viewer_or_skip(view.Live(scene)) as viewer:
        advance_once(viewer)
        shown = viewer._page._senses._numbers.content
        x = viewer._source.world.observation["toy/position"][0, 0]
        assert "<b>toy/position</b>" in shown
        assert f"{x:.3g}" in shown
    assert line("ct", "Hz", np.arange(7)).endswith("0 to 6, mean 3 (7) Hz</div>")


def advance_once(viewer):
    viewer.clock.paused = True
    for _ in range(12):  # frames; bars are drawn in every sixth
        viewer.frame()


def test_every_scene_is_shown(shown):
    for scene in mimo.scenes():
        shown.change(scene, "")
        advance(shown, 0.05)
        world = shown._source.world
        assert world._scene.source == scene
        assert len(shown._page._senses._pictures) == len(world.agents)
        assert len(shown._page.infants._world.agents) == len(world.agents)
        assert shown._page.sound._switch is not None  # its infants hear
        assert sum(handle is not None for handle in shown._page.shapes._shown) > 20


def test_failed_calls_change_nothing(shown):
    shown.change("playdate", "")
    told = []
    shown._tell = told.append
    shown.ask(lambda: shown.change("playdate", "reach"))
    shown.frame()
    assert len(told) == 1
    assert "\n" not in told[0]
    assert (shown._source.scene, shown._page.scene._task.value) == ("playdate", "the scene's own")
    advance(shown, 0.02)


def test_an_environment_with_a_page(monkeypatch, capsys):
    pytest.importorskip("viser", reason="viser is not installed")
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    env = mimo.make("reach", render_mode="human")
    env.reset(seed=1)
    url = capsys.readouterr().out.split()[-1]
    assert urllib.request.urlopen(url).status == 200
    started = time.perf_counter()
    for _ in range(50):
        env.step(env.action_space.sample())
    assert time.perf_counter() - started == pytest.approx(0.5, abs=0.15)  # in real time
    elbow = env._viewer._page.shapes._bodies[env.world.find("body", "right_lower_arm")]
    env._viewer._page.update()
    there = env.world.poses("body").positions[env.world.find("body", "right_lower_arm")]
    np.testing.assert_allclose(elbow.position, there, atol=2e-5)
    env.close()


def test_shown_worlds_and_environments():
    """All that the page's function names: a world, an environment, a wrapped one; and nothing else."""
    pytest.importorskip("viser", reason="viser is not installed")
    small = {"vision": True, "vision_width": 16, "vision_height": 16}
    with mimo.World("reach", **small) as world:
        world.reset(1)
        with view.open(world) as viewer:
            assert viewer._source.world is world
            assert viewer._source.scene == "reach"
            world.step()
            viewer.show()
        with pytest.raises(TypeError, match="eyes"):
            view.open(world, eyes=3)
    env = gymnasium.make("mimo/Reach-v0", **small)
    env.reset(seed=1)
    with view.open(env) as viewer:
        assert viewer._source.world is env.unwrapped.world
    env.close()
    with pytest.raises(TypeError, match=r"expected a mimo\.World or an environment"):
        view.open(3)


def test_the_page_shows_what_the_infant_senses():
    """Of an environment: the eyes and the skin of the observation that it has just returned, from the reset on."""
    pytest.importorskip("viser", reason="viser is not installed")
    env = mimo.make("benchmark", vision_width=24, vision_height=24, touch=True)
    observation, _ = env.reset(seed=1)
    with view.open(env) as viewer:
        for _ in range(100):
            viewer.clock.speed = 1e6  # no waiting
            viewer._next_frame, viewer._page._frames = 0.0, 0  # everything is drawn
            viewer.show()
            both = viewer._page._senses._pictures[""].image
            np.testing.assert_array_equal(both[:, :24], observation["vision/eye_left"])
            np.testing.assert_array_equal(both[:, -24:], observation["vision/eye_right"])
            felt = (np.linalg.norm(observation["touch/force"], axis=1) > 0).sum()
            assert len(viewer._page._marks[0]._handle.points) - 1 == felt
            observation, *_ = env.step(np.zeros(env.action_space.shape, np.float32))
        assert felt > 0
    env.close()


def test_the_first_episode_follows_the_seed():
    """Its random actions are those of that seed, as after a reset."""
    with viewer_or_skip(view.Live("reach", vision=False), seed=7) as viewer:
        first = [viewer._page.motors.next() for _ in range(60)]
        viewer.restart()
        np.testing.assert_array_equal(first, [viewer._page.motors.next() for _ in range(60)])


def test_a_failed_simulation_begins_again(shown):
    shown.change("benchmark", "")
    told, world = [], shown._source.world
    shown._tell = told.append
    world.set(mimo.Quantity.JOINT_VELOCITY, 1e12, ["robot:left_elbow"])
    shown.clock.paused = False
    shown.clock._due = 3
    shown.frame()
    assert len(told) == 1
    assert "begins again" in told[0]
    assert shown.clock.paused
    assert world.time == 0
    advance(shown, 0.02)
    assert world.time == pytest.approx(0.02)
    assert len(told) == 1


# ---- Recordings and sound --------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """1.5 s of the showroom, in which things fall and knock."""
    options = ["--scene", "showroom", "--senses", "hearing", "--keep", "hearing", "--seconds", "1.5", "--seed", "3"]
    return record(tmp_path_factory.mktemp("view") / "run.h5", *options)


def test_a_recording_is_played(run):
    with viewer_or_skip(view.Recorded(run, eyes=16)) as viewer:
        source, clock = viewer._source, viewer.clock
        table = table_of(run, "joints/position")
        clock.paused = True
        advance(viewer, 0.1)
        assert source.at == 10
        np.testing.assert_array_equal(source.world.get(mimo.Quantity.JOINT_POSITION), table[9])
        viewer._page.time.update()
        assert viewer._page.time._place.value == pytest.approx(0.1)
        viewer.ask(lambda: source.seek(140))
        viewer.frame()
        np.testing.assert_array_equal(source.world.get(mimo.Quantity.JOINT_POSITION), table[139])
        clock.paused = False
        clock._due = 100
        for _ in range(400):
            if clock.paused:
                break
            viewer.frame()
            time.sleep(0.01)
        assert (source.at, clock.paused) == (150, True)  # the end
        advance(viewer, 0.01)
        assert source.at == 1  # and from the start again


def test_a_recording_has_no_handles(run):
    """What was recorded cannot be pulled at, reset or put elsewhere."""
    with viewer_or_skip(view.Recorded(run, eyes=0)) as viewer:
        assert viewer._page._handle is None
        assert viewer._page.time.seed is None
        assert all(slider.disabled for slider in viewer._page._joints._sliders)


# ---- The program ----------------------------------------------------------------------------------------------------


def program(*arguments, **options):
    return subprocess.Popen(
        [sys.executable, "-m", "mimo.view", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        **options,
    )


def refused(*arguments):
    output, errors = program(*arguments).communicate(timeout=120)
    assert output == ""
    assert errors.count("\n") == 1, errors
    return errors


def test_wrong_arguments():
    pytest.importorskip("viser", reason="viser is not installed")
    assert 'no scene named "nosuch"; there are: benchmark' in refused("--scene", "nosuch")
    assert 'no task named "fly"' in refused("--scene", "reach", "--task", "fly")
    assert "port is 70000, expected 0 to 65535" in refused("--port", "70000")
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        assert re.search("port [0-9]+ of 127.0.0.1 cannot be used", refused("--port", str(taken.getsockname()[1])))


def test_without_viser(monkeypatch):
    monkeypatch.setitem(sys.modules, "viser", None)
    with pytest.raises(mimo.UnsupportedError, match=re.escape("pip install 'mimo[view]'")):
        view.open("reach")
    with pytest.raises(mimo.UnsupportedError, match=re.escape("pip install 'mimo[view]'")):
        mimo.make("reach", render_mode="human").reset(seed=1)


@pytest.fixture
def served():
    pytest.importorskip("viser", reason="viser is not installed")
    running = program("--scene", "benchmark", "--port", "0", "--eyes", "64")
    yield re.search(r"http://[^;]*", running.stdout.readline()).group()
    running.send_signal(signal.SIGTERM)
    output, errors = running.communicate(timeout=60)
    assert (running.returncode, output, errors) == (0, "", "")


def status(page):
    seconds, state = STATUS.search(page.inner_text("body")).groups()
    return float(seconds), state


def eventually(what, seconds=60):
    """Software draws pages slowly."""
    deadline = time.monotonic() + seconds
    while not what():
        assert time.monotonic() < deadline
        time.sleep(0.2)


def picture(page, path):
    from PIL import Image

    page.screenshot(path=path)
    return np.asarray(Image.open(path).convert("RGB"), np.int32)


def test_in_a_browser(served, tmp_path):
    browser = pytest.importorskip("browser")
    with browser.page(1200, 560) as (page, wrong):
        page.goto(served)
        eventually(lambda: STATUS.search(page.inner_text("body")))
        page.get_by_role("button", name="Pause").click()
        eventually(lambda: status(page)[1] == "paused")
        halted = status(page)[0]
        page.get_by_role("button", name="Step", exact=True).click()
        eventually(lambda: status(page)[0] == pytest.approx(halted + 0.01))
        page.get_by_role("button", name="Reset").click()
        eventually(lambda: status(page)[0] == 0)
        time.sleep(5)
        drawn = picture(page, tmp_path / "page.png")
        middle = drawn[:, 300:900]
        assert page.title() == "MIMo"
        assert page.url == served.strip()  # with the token, and nothing more
        # A floor of many colours, the infant's skin, and its shirt; none of it is the page's white.
        assert (middle.min(axis=2) < 240).mean() > 0.5
        assert len(np.unique(middle.reshape(-1, 3), axis=0)) > 2000
        red, green, blue = np.moveaxis(middle, 2, 0)
        assert ((red > green + 15) & (green > blue + 5)).sum() > 300
        images = page.locator("img").evaluate_all("all => all.map(i => [i.naturalWidth, i.naturalHeight])")
        assert [64 + 4 + 64, 64] in images
        page.get_by_role("tab", name="Joints").click()
        eventually(lambda: "left_elbow" in page.inner_text("body"))
        page.get_by_role("tab", name="Actions").click()
        eventually(lambda: "head_swivel" in page.inner_text("body"))
    assert wrong == []


def scene_of(page):
    """How much of the page's width and height the scene takes."""
    box = page.locator("canvas").first.bounding_box()
    size = page.viewport_size
    return box["width"] / size["width"], box["height"] / size["height"]


def test_narrow_pages_leave_room_for_the_infant(shown):
    """In a notebook the senses begin collapsed; on a phone the controls do, and then share the height."""
    browser = pytest.importorskip("browser")
    with browser.page(880, 600) as (page, _):
        page.goto(shown.url)
        eventually(lambda: scene_of(page)[0] > 0.6)
        page.get_by_role("button", name="Expand column").or_(page.get_by_label("Expand panels")).first.wait_for()
    with browser.page(390, 844) as (page, _):
        page.goto(shown.url)
        eventually(lambda: 0.9 < scene_of(page)[1] < 0.95 and scene_of(page)[0] == 1)
        page.get_by_text("MIMo", exact=True).click()
        eventually(lambda: 0.39 < scene_of(page)[1] < 0.6)
        page.get_by_role("button", name="Reset").wait_for()


# What the page hands to its loudspeaker: when, and which samples of the left ear.
LISTEN = """
window.heard = [];
const start = AudioBufferSourceNode.prototype.start;
AudioBufferSourceNode.prototype.start = function (at) {
  const ears = [0, 1].map((ear) => Array.from(this.buffer.getChannelData(ear)));
  window.heard.push([at, this.buffer.sampleRate, ...ears]);
  return start.call(this, at);
};
"""


def test_the_page_plays_what_ears_hear(run):
    """All samples of both ears, none twice, one piece right after the other."""
    browser = pytest.importorskip("browser")
    viewer = viewer_or_skip(view.Recorded(run, eyes=0))
    slowly = 0.1  # a page that software draws may lag: what it has not taken 1 s of the infant's time later is lost
    viewer.clock.paused, viewer.clock.speed = True, slowly
    viewer.run_beside()
    with browser.page(700, 400) as (page, wrong):
        page.add_init_script(LISTEN)
        page.goto(viewer.url)
        eventually(lambda: STATUS.search(page.inner_text("body")))
        page.get_by_label("sound").check()
        eventually(lambda: viewer._page.sound.on)
        page.get_by_role("button", name="Go on").click()
        eventually(lambda: viewer.clock.paused and viewer._source.at == 150)
        eventually(lambda: sum(len(piece[2]) for piece in page.evaluate("window.heard")) >= 150 * 160)
        pieces = page.evaluate("window.heard")
    for ear, name in ((2, "ear_left"), (3, "ear_right")):
        played = np.concatenate([piece[ear] for piece in pieces])
        expected = np.clip(10 * table_of(run, f"fields/hearing/{name}").ravel(), -1, 1)  # 20 dB above 1 Pa full scale
        assert abs(expected).max() > 0.001
        np.testing.assert_allclose(played, expected, atol=1e-4)
    for one, next_one in zip(pieces, pieces[1:]):
        assert one[1] == 16000
        assert next_one[0] >= one[0] + len(one[2]) / 16000 / slowly - 1e-6
    viewer.close()
    assert wrong == []
