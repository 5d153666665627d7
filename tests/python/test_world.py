"""Worlds: senses as views, errors as exceptions, names, states."""

import gc
import logging
import weakref

import numpy as np
import pytest

import mimo
from mimo.frames import placed


def test_the_infant_is_the_paper_s(reach):
    # Mass and height of MIMo, and the paper's sizes of reach: 47 positions, velocities and limits, 16 control inputs
    # and torques of 8 motors, 21 three-axis torque sensors.
    (infant,) = reach.agents
    assert infant.mass == pytest.approx(10.905, abs=5e-4)
    assert infant.height == pytest.approx(0.778, abs=5e-4)
    shapes = {name: field.shape for name, field in reach.layout.fields.items()}
    assert shapes["proprioception/position"] == shapes["proprioception/limit"] == (47,)
    assert shapes["proprioception/torque"] == (21, 3)
    assert sum(int(np.prod(shape)) for shape in shapes.values()) == 220
    assert len(reach.action_names) == 8


def test_fields_describe_themselves(reach):
    field = reach.layout.fields["proprioception/position"]
    assert field.unit == "rad"
    assert field.offset % 64 == 0
    assert "robot:right_elbow" in field.labels


def test_observations_are_views_of_the_block(reach):
    observation = reach.reset(seed=1)
    for name, field in observation.items():
        assert np.shares_memory(field, reach.block), name
    at = reach.layout.fields["proprioception/position"].offset
    assert observation["proprioception/position"].ctypes.data == reach.block.ctypes.data + at
    assert reach.block.ctypes.data % 64 == 0


def test_a_field_holds_what_named_access_reads(reach):
    reach.reset(seed=1)
    observation = reach.step(np.ones(8)).observation
    field = reach.layout.fields["proprioception/position"]
    joints = reach.joints(*field.labels)
    np.testing.assert_array_equal(observation["proprioception/position"], joints.position.astype(np.float32))


def test_views_outlive_the_world():
    world = mimo.World("reach")
    field = world.reset(seed=1)["proprioception/position"]
    kept = field.copy()
    world.close()
    del world
    gc.collect()
    np.testing.assert_array_equal(field, kept)


def test_worlds_are_freed_with_their_last_reference():
    world = mimo.World("reach")
    handle = weakref.ref(world._handle)
    gone = weakref.ref(world)
    del world
    gc.collect()
    assert gone() is None
    assert handle() is None


def test_reach_rewards_minus_the_distance(reach):
    reach.reset(seed=3)
    pair = reach.bodies("right_fingers", "target")
    result = reach.step(np.zeros(8))
    # Positions and rewards are both of the start of the last physics step.
    hand, ball = pair.position
    assert result.reward[0] == pytest.approx(-np.linalg.norm(hand - ball), abs=1e-12)
    assert reach.reward_terms() == {"distance": pytest.approx(result.reward[0]), "success": 0}
    assert reach.outcome.tolist() == [mimo.Outcome.NONE]


def test_parameters_change_the_task():
    scene = mimo.Scene("reach")
    scene.add_agent()
    assert scene.parameters["reach/episode_steps"] == 1000
    scene.parameters["reach/episode_steps"] = 2
    assert "default 1000" in scene.parameters.describe("reach/episode_steps")
    world = mimo.World(scene)
    world.reset(seed=1)
    assert [bool(world.step().truncated[0]) for _ in range(2)] == [False, True]
    with pytest.raises(mimo.NotFoundError):
        scene.parameters["reach/nothing"] = 1
    assert "reach/episode_steps" in scene.parameters
    assert "reach/nothing" not in scene.parameters
    assert (scene.parameters.get("reach/episode_steps"), scene.parameters.get("reach/nothing", 7)) == (2, 7)


@pytest.mark.parametrize(
    ("make", "kind", "message"),
    [
        (lambda: mimo.World("raech"), mimo.NotFoundError, "raech"),
        (lambda: mimo.World("reach", frame_skip=1001), ValueError, "frame_skip is 1001"),
        (lambda: mimo.World("reach", frame_skip=-1), ValueError, "frame_skip is -1"),
        (lambda: mimo.World("reach", frame_skip="two"), TypeError, "frame_skip is 'two'"),
        (lambda: mimo.World("reach", frameskip=1), TypeError, "argument 'frameskip'; did you mean 'frame_skip'?"),
        (lambda: mimo.World("reach", task="rech"), mimo.NotFoundError, "rech"),
        (lambda: mimo.Scene(xml="<mujoco><worldbody><geom/>"), mimo.ModelError, ""),
        (lambda: mimo.Scene(file="/nowhere/x.xml"), mimo.NotFoundError, "/nowhere/x.xml"),
        (lambda: mimo.Scene("re\0ach"), ValueError, "zero byte"),
    ],
)
def test_errors_name_the_argument(make, kind, message):
    with pytest.raises(kind) as caught:
        make()
    assert message in str(caught.value)


def test_refused_arguments(reach):
    with pytest.raises(ValueError, match=r"action\[7\] is not a number"):
        reach.step([0, 0, 0, 0, 0, 0, 0, np.nan])
    with pytest.raises(ValueError, match=r"action of the shape \(7,\), expected \(8,\)"):
        reach.step(np.zeros(7))
    with pytest.raises(ValueError, match="seed is -1"):
        reach.reset(seed=-1)
    with pytest.raises(ValueError, match="block has a length of 64"):
        reach.step_into(np.zeros(64, np.uint8))
    with pytest.raises(ValueError, match="contiguous"):
        reach.step_into(np.zeros(2 * reach.layout.bytes, np.uint8)[::2])
    with pytest.raises(mimo.NotFoundError, match="hed"):
        reach.bodies("hed")
    with pytest.raises(AttributeError, match="cannot be written"):
        reach.bodies("head").velocity = 3


def test_a_closed_world_says_so():
    with mimo.World("reach") as world:
        head = world.bodies("head")
    assert world.closed
    world.close()
    for call in (world.reset, world.step, lambda: head.position, world.save):
        with pytest.raises(mimo.ClosedError):
            call()


def test_failed_simulation_and_recovery(reach):
    logging.getLogger("mimo").disabled = True
    try:
        reach.reset(seed=1)
        reach.joints("robot:right_elbow").velocity = 1e30
        with pytest.raises(mimo.SimulationError) as caught:
            reach.step()
        assert caught.value.status == -7
        reach.reset(seed=1)
        reach.step()
    finally:
        logging.getLogger("mimo").disabled = False


def test_names_read_and_write(reach):
    reach.reset(seed=1)
    elbow = reach.joints("robot:right_elbow")
    low, high = elbow.range[0]
    assert low < high
    elbow.position = (low + high) / 2
    assert elbow.position == pytest.approx([(low + high) / 2])
    ball = reach.bodies("target")
    ball.write("position", [[0.4, 0.1, 0.8]])
    np.testing.assert_allclose(ball.position, [[0.4, 0.1, 0.8]], atol=1e-12)
    assert reach.bodies("right_fingers", "head").velocity.shape == (2, 6)
    assert reach.joints().position.shape == (47 + 2 * 7,)  # hinges, and the free joints of infant and ball
    assert reach.bodies("head").names == ["head"]
    assert reach.actuators(*reach.action_names).control.shape == (8,)


def test_gravity_and_locks():
    world = mimo.World("benchmark", vision=False, touch=False)
    np.testing.assert_allclose(world.gravity, [0, 0, -9.81])
    world.gravity = [0, 0, 0]
    ball = world.bodies("mimo_location")
    world.reset(seed=1)
    before = ball.position.copy()
    for _ in range(10):
        world.step()
    np.testing.assert_allclose(ball.position, before, atol=5e-3)  # falls 4.9 cm otherwise
    world.lock("robot:left_elbow", -0.5)
    assert world.locked("robot:left_elbow") == -0.5
    world.unlock("robot:left_elbow")
    assert world.locked("robot:left_elbow") is None


def test_a_loaded_state_continues_bit_for_bit(reach):
    reach.reset(seed=5)
    rng = np.random.default_rng(0)
    actions = rng.uniform(-1, 1, (20, 8))
    for action in actions[:5]:
        reach.step(action)
    state = reach.save()
    first = [reach.step(action).observation["proprioception/velocity"].copy() for action in actions]
    reach.load(state)
    again = [reach.step(action).observation["proprioception/velocity"].copy() for action in actions]
    np.testing.assert_array_equal(first, again)
    with pytest.raises(mimo.FileError, match="state"):
        reach.load(state[:-1])


def test_seeds_decide_the_episode(reach):
    one = reach.reset(seed=1)["proprioception/position"].copy()
    other = reach.reset(seed=2)["proprioception/position"].copy()
    np.testing.assert_array_equal(reach.reset(seed=1)["proprioception/position"], one)
    assert not np.array_equal(one, other)


def test_contacts_carry_the_weight():
    # A ball of 1 kg rests on the floor: 9.81 N, from the standard gravity of the scene.
    scene = mimo.Scene(xml='<mujoco><worldbody><geom name="floor" type="plane" size="1 1 .1"/></worldbody></mujoco>')
    scene.add_object("ball", shape=mimo.Shape.SPHERE, size=0.1, position=[0, 0, 0.0999], mass=1.0)
    world = mimo.World(scene, frame_skip=1)
    world.reset()
    for _ in range(400):
        world.step()
    contacts = world.contacts()
    assert len(contacts.force) == 1
    up = contacts.force[0] @ contacts.frame[0]
    assert abs(up[2]) == pytest.approx(9.81, rel=1e-3)


def test_pictures(reach):
    reach.reset(seed=1)
    picture = reach.draw(width=64, height=48)
    assert picture.rgb.shape == (48, 64, 3)
    assert picture.rgb.std() > 5
    assert picture.depth.min() > 0
    # The point that the free camera looks at lies in the middle of the picture.
    pixels = reach.project([[0.1, 0.2, 0.3]], width=64, height=48, look_at=[0.1, 0.2, 0.3], distance=2)
    np.testing.assert_allclose(pixels[0], [32, 24, 2], atol=1e-6)


def test_messages_go_to_logging(caplog):
    assert logging.getLogger("mimo").level == logging.NOTSET
    from mimo import _abi, _library

    with caplog.at_level(logging.INFO, "mimo"):
        _library.log_to_python(None, _abi.LogRecord(level=2, text=b"worth knowing", world=3, time=1.5))
    (told,) = caplog.records
    assert (told.message, told.levelno, told.code) == ("worth knowing", logging.INFO, 0)
    assert (told.world, told.time) == (None, None)  # for it comes from none


def test_warnings_have_world_and_time(caplog):
    # A box on its face has four contacts, of which the model has room for one.
    crowded = """<mujoco><option timestep="0.005"/><size nconmax="1"/><worldbody><geom type="plane" size="1 1 .1"/>
        <body name="box" pos="0 0 1"><freejoint/><geom type="box" size=".1 .1 .1"/></body></worldbody></mujoco>"""
    with mimo.Batch(mimo.Scene(xml=crowded), 3, frame_skip=4) as batch:
        batch.reset(seeds=1)
        batch.step()
        batch.bodies("box").write("position", [0, 0, 0.1], np.array([False, True, False]))
        batch.step()
    (told,) = caplog.records
    assert (told.world, told.code) == (1, mimo.WarningCode.CONTACTS_DROPPED)
    assert told.levelno == logging.WARNING
    assert 0.02 <= told.time <= 0.04  # in the second step of 4 times 5 ms
    caplog.clear()


def test_timing_tells_where_time_goes():
    world = mimo.World("reach", timing=True)
    world.reset(seed=1)
    for _ in range(3):
        world.step()
    assert world.timing["steps"] == 3
    assert 0 < world.timing["physics"] < world.timing["total"]


@pytest.mark.parametrize("scene", ["benchmark", "free", "reach", "catch"])
def test_the_usual_picture_shows_the_infant_large_in_the_middle(scene):
    """Who stands takes two thirds of the height and more; nothing hides more of it than a hand's or a ball's size."""
    with mimo.World(scene, vision=False, touch=False) as world:
        world.reset(seed=1)
        own = [body for body, name in zip(world.joints().body_ids, world.joints().names) if name.startswith("robot:")]
        rows, columns = np.nonzero(np.isin(world.geoms().body_ids, own)[world.draw().segmentation])
        assert 0.65 < np.ptp(rows) / 480 < 0.95
        assert abs((rows.min() + rows.max()) / 2 / 480 - 0.5) < 0.1
        assert abs((columns.min() + columns.max()) / 2 / 640 - 0.5) < 0.1


@pytest.mark.parametrize("age", [0.0, 6.0, 18.0])
def test_infants_that_start_above_the_floor(age):
    """As the page on scenes says: 0.4 m, as in the original's scene, less the 0.329 m from there down to the soles."""
    with mimo.World("benchmark", age=age, vision=False, touch=False) as world:
        world.reset(seed=1)
        poses, names = world.poses("geom"), world.bodies().names
        feet = [
            geom for geom, body in enumerate(world.geoms().body_ids) if "foot" in names[body] or "toes" in names[body]
        ]
        lowest = min(
            placed(poses.positions[geom], poses.rotations[geom], world.mesh(geom).positions)[:, 2].min()
            for geom in feet
        )
        assert lowest == pytest.approx(0.07, abs=0.005)
