"""Fields on request: quantities that are observed with everything else."""

import pickle

import numpy as np
import pytest

import mimo

# A ball that falls beside a table, which is turned by a quarter about z: its x axis is the world's y axis.
ROOM = """<mujoco><option timestep="0.005"/><worldbody>
<body name="ball" pos="1 2 3"><freejoint name="free"/><geom size="0.1" mass="2"/></body>
<body name="table" pos="3 0 0" quat="1 0 0 1"><geom type="box" size=".5 .5 .2" mass="7"/></body>
</worldbody></mujoco>"""
G, PHYSICS_STEP, STEPS = 9.81, 0.005, 4


def room(*fields, **options):
    scene = mimo.Scene(xml=ROOM)
    for name, quantity, elements in fields:
        scene.add_field(name, quantity, elements, **options)
    return scene


def fallen(steps):
    """How far a ball has fallen after physics steps: velocities first, then positions."""
    return G * PHYSICS_STEP**2 * steps * (steps + 1) / 2


def test_elements_and_their_values():
    both = ["ball", "table"]
    scene = room(("mass", mimo.Quantity.BODY_MASS, both), ("places", "body_position", both), ("pose", 0x0201, "free"))
    with mimo.World(scene) as world:
        seen = world.reset()
        assert seen["mass"].tolist() == [2, 7]
        assert seen["mass"].dtype == np.float32
        assert seen["places"].tolist() == [[1, 2, 3], [3, 0, 0]]
        assert seen["pose"].tolist() == [[1, 2, 3, 1, 0, 0, 0]]
        assert world.layout.fields["places"].unit == "m"


def test_fields_of_the_start_and_the_end_of_a_step():
    scene = room(("before", "body_position", "ball"))
    scene.add_field("now", "body_position", "ball", now=True)
    with mimo.World(scene, frame_skip=STEPS) as world:
        world.reset()
        seen = world.step().observation
        assert seen["before"][0, 2] == pytest.approx(3 - fallen(STEPS - 1))
        assert seen["now"][0, 2] == pytest.approx(3 - fallen(STEPS))
        assert world.layout.fields["before"].end == -PHYSICS_STEP
        assert world.layout.fields["now"].end == 0


def test_frames():
    scene = room(("ball", "body_position", "ball"), relative_to="table")
    scene.add_field("table", "body_velocity", "table", relative_to="ball", now=True)
    with mimo.World(scene, frame_skip=STEPS) as world:
        assert world.reset()["ball"][0] == pytest.approx([2, 2, 3])  # 2 m along the world's y, -2 m along its x
        seen = world.step().observation["table"][0]
        assert seen == pytest.approx([0, 0, G * PHYSICS_STEP * STEPS, 0, 0, 0])  # it comes towards what falls


def infant_and_toy():
    scene = mimo.Scene("free")
    scene.add_object("toy", position=[0.4, 0, 0.1])
    scene.add_agent(vision=False, touch=False)
    scene.add_field("toy/place", mimo.Quantity.BODY_POSITION, "toy", relative_to="head", now=True)
    return scene


@pytest.mark.parametrize("through", [lambda it: it, lambda it: it.copy(), lambda it: pickle.loads(pickle.dumps(it))])
def test_environments_show_them(through):
    envs = mimo.make_vec(through(infant_and_toy()), num_envs=2)
    observation, _ = envs.reset(seed=1)
    assert observation["toy/place"].shape == (2, 1, 3)
    assert observation in envs.observation_space
    toy, head = (envs.batch.bodies(name).position[0, 0] for name in ("toy", "head"))
    assert np.linalg.norm(observation["toy/place"][0, 0]) == pytest.approx(np.linalg.norm(toy - head), abs=1e-6)


def test_refused():
    with pytest.raises(mimo.NotFoundError, match=r"bell.*ball"):
        mimo.World(room(("x", "body_mass", "bell")))
    with pytest.raises(ValueError, match="x"):
        room(("x", "body_mass", "ball"), ("x", "body_mass", "table"))
    with pytest.raises(ValueError, match="relative_to"):
        room(("x", "body_mass", "ball"), relative_to="table")
    with pytest.raises(mimo.UnsupportedError, match="0x270f"):
        room(("x", 9999, "ball"))
