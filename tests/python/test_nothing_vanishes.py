"""What a program assigns, passes or asks for counts, or is refused: nothing is ignored without a word."""

import copy
import pickle
import subprocess
import sys
import textwrap
import warnings

import numpy as np
import pytest

import mimo
from mimo._strict import Reading

# ---- Attributes ------------------------------------------------------------------------------------------------------


def everything():
    world = mimo.World("reach")
    batch = mimo.Batch("reach", 2)
    return {
        "world": world,
        "batch": batch,
        "world of a batch": batch.world(1),
        "scene": mimo.Scene("free"),
        "selection": world.bodies("head"),
        "joints of a batch": batch.joints("robot:left_elbow"),
        "agent": world.agents[0],
        "layout": world.layout,
        "parameters": mimo.Scene("reach").parameters,
        "field": next(iter(world.layout.fields.values())),
    }


@pytest.mark.parametrize("name", everything())
def test_an_unknown_attribute_is_refused(name):
    it = everything()[name]
    before = set(dir(it))
    for attribute in ("gravty", "masses", "anything"):
        with pytest.raises(AttributeError, match=attribute):
            setattr(it, attribute, 1.0)
    assert set(dir(it)) == before


@pytest.mark.parametrize(
    ("name", "attribute"),
    [
        ("world", "reward"),
        ("world", "observation"),
        ("world", "agents"),
        ("world", "time"),
        ("world", "step"),
        ("batch", "world_count"),
        ("batch", "blocks"),
        ("scene", "parameters"),
        ("selection", "ids"),
        ("selection", "center_of_mass"),
        ("agent", "mass"),
    ],
)
def test_impossible_assignments_are_refused(name, attribute):
    with pytest.raises(AttributeError):
        setattr(everything()[name], attribute, 1)


def test_the_message_suggests_the_nearest_name():
    world = mimo.World("reach")
    with pytest.raises(AttributeError, match="a World has no 'gravty' that can be assigned; did you mean 'gravity'"):
        world.gravty = [0, 0, 0]
    with pytest.raises(AttributeError, match="a Bodies has no 'masss' that can be assigned; did you mean 'mass'"):
        world.bodies("head").masss = 1
    with pytest.raises(AttributeError, match="a Scene has no 'room' that can be assigned, it has none"):
        mimo.Scene().room = "playroom"


def test_a_class_that_is_derived_has_attributes_of_its_own():
    class Counted(mimo.World):
        def __init__(self):
            super().__init__("reach")
            self.steps = 0

    counted = Counted()
    counted.steps += 1
    assert counted.steps == 1


def test_a_moment_takes_what_it_has():
    class Told(mimo.WorldTask):
        memory = 1

        def evaluate(self, world, moment):
            moment.memory[0] += 1
            moment.memory = moment.memory * 2
            with pytest.raises(AttributeError, match="did you mean 'memory'"):
                moment.memry = 3
            return mimo.Judgement(float(moment.memory[0]))

    scene = mimo.Scene("free")
    scene.add_agents(vision=False, touch=False)
    scene.set_task(Told())
    world = mimo.World(scene)
    world.reset(seed=1)
    assert [float(world.step().reward[0]) for _ in range(3)] == [2, 6, 14]  # (m + 1) 2


# ---- Arrays ----------------------------------------------------------------------------------------------------------


def arrays(world):
    return {
        "mass": world.bodies("head").mass,
        "position": world.joints("robot:left_elbow").position,
        "pose": world.bodies().pose,
        "gravity": world.gravity if isinstance(world, mimo.World) else world.world(0).gravity,
        "action": world.action,
        "action_low": world.action_low,
        "ids": world.bodies().ids,
    }


@pytest.mark.parametrize("kind", ["world", "batch"])
def test_copies_are_read_only(kind):
    world = mimo.World("reach") if kind == "world" else mimo.Batch("reach", 2)
    world.reset(1)
    world.step(np.zeros((8,) if kind == "world" else (2, 8)))
    for name, array in arrays(world).items():
        for write in (
            lambda array: array.__setitem__(0, 1),
            lambda array: array.__setitem__(slice(None), 1),
            lambda array: array[..., 0:1].__setitem__(Ellipsis, 1),
            lambda array: array.fill(1),
            lambda array: np.copyto(array, 1),
            lambda array: np.add(array, 1, out=array),
        ):
            with pytest.raises(ValueError, match=r"copy|read-only"):
                write(array)
        np.testing.assert_array_equal(array, arrays(world)[name])


def test_changes_by_their_attribute_count():
    world = mimo.World("reach")
    world.reset(seed=1)
    head, elbow = world.bodies("head"), world.joints("robot:left_elbow")
    mass, angle = float(head.mass[0]), float(elbow.position[0])
    head.mass *= 2
    elbow.position -= 0.1
    world.gravity = [0, 0, -9.81]
    world.gravity /= 2
    assert float(head.mass[0]) == pytest.approx(2 * mass)
    assert float(elbow.position[0]) == pytest.approx(angle - 0.1)
    assert world.gravity[2] == pytest.approx(-9.81 / 2)
    own = world.get(mimo.Quantity.JOINT_POSITION, ["robot:left_elbow"])  # asked for: one's own
    own[0] = -0.3
    world.set(mimo.Quantity.JOINT_POSITION, own, ["robot:left_elbow"])
    assert elbow.position == [-0.3]


def test_arrays_computed_from_copies_are_ordinary():
    position = mimo.World("reach").bodies().position
    assert isinstance(position, Reading)
    for computed in (
        position + 1,
        np.sin(position),
        position.mean(axis=0),
        np.asarray(position) * 2,
        position @ np.eye(3),
    ):
        assert type(computed) is np.ndarray
        computed[0] = 1
    assert type(position.sum()) is np.float64
    assert type(position[0, 0]) is np.float64
    assert type(np.linalg.norm(position)) is np.float64
    for own in (position.copy(), copy.copy(position), copy.deepcopy(position)):
        assert type(own) is np.ndarray
        own[0] = 1
    before = position
    position += 1
    assert position is not before
    loaded = pickle.loads(pickle.dumps(before))
    assert type(loaded) is np.ndarray
    np.testing.assert_array_equal(loaded, before)


# ---- Arguments -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("action", "line"),
    [
        (0.7, r"action of the shape \(\), expected \(8,\)"),
        (np.array([0.7], np.float32), r"action of the shape \(1,\), expected \(8,\)"),
        (np.zeros((1, 8)), r"action of the shape \(1, 8\), expected \(8,\)"),
        (np.zeros((8, 1)), r"action of the shape \(8, 1\), expected \(8,\)"),
        ({"arm": 1}, r"action: expected numbers of the shape \(8,\), not {'arm': 1}"),
        (np.zeros(8, complex), r"action: expected numbers of the shape \(8,\), not an object of type ndarray"),
        ("forward", "not 'forward'"),
        ([[1], [1, 2]], r"not \[\[1\], \[1, 2\]\]"),
    ],
)
def test_actions_of_another_shape(action, line):
    env = mimo.make("reach")
    env.reset(seed=1)
    for step in (env.step, env.world.step, lambda given: env.world.step_into(None, given)):
        with pytest.raises((TypeError, ValueError), match=line):
            step(action)
    assert env.world.time == 0
    env.step([0] * 8)  # whole numbers are numbers


def test_actions_of_several():
    envs = mimo.make_vec("reach", num_envs=2)
    envs.reset(seed=1)
    for action in (0.7, np.zeros((2, 1)), np.zeros((8, 2)), np.zeros(16)):
        with pytest.raises(ValueError, match=r"actions of the shape .*, expected \(2, 8\)"):
            envs.step(action)
    with pytest.raises(TypeError, match=r"actions: expected numbers of the shape \(2, 8\), not {'a': 1}"):
        envs.step({"a": 1})
    pytest.importorskip("pettingzoo")
    env = mimo.ParallelEnv("playdate", vision=False, touch=False)
    env.reset(seed=1)
    name = env.agents[0]
    with pytest.raises(ValueError, match=rf"actions\['{name}'\] of the shape \(\), expected"):
        env.step({name: 0.7})
    with pytest.raises(ValueError, match="actions has 'nobody', expected infants"):
        env.step({"nobody": env.action_space(name).sample()})


@pytest.mark.parametrize("kind", [np.int16, np.int32, np.uint8, bool, complex])
def test_samples_are_pascals(kind):
    world = mimo.World("free", vision=False, touch=False, hearing=True)
    with pytest.raises(TypeError, match=f"samples are {np.dtype(kind)}, expected pascals at 1 m as floating-point"):
        world.play("head", np.ones(16, kind))
    world.play("head", np.ones(16, np.float32))
    world.play("head", [])


def test_movements_by_rows():
    world = mimo.World("free", vision=False, touch=False, frame_skip=2)
    world.reset(seed=1)
    angles = world.get(mimo.Quantity.JOINT_POSITION)
    with pytest.raises(ValueError, match=rf"positions of the shape \({len(angles)}, 2\), expected 2 rows"):
        world.follow(np.stack([angles, angles], axis=1))
    world.follow(np.stack([angles, angles]))


@pytest.mark.parametrize("percentile", [0.5, 0.03, 0.97, -1, 99.9, 100, np.nan])
def test_a_percentile_is_in_percent(percentile):
    scene = mimo.Scene("free")
    with pytest.raises(mimo.ArgumentError, match=r"percentile is .*, expected percent, 1 to 99\.865, of which 50"):
        scene.add_agent(age=6, percentile=percentile)
    scene.add_agent(age=6, percentile=1)


# ---- Seeds -----------------------------------------------------------------------------------------------------------


def random_of(envs):
    return [envs.batch.world(i).random(2).tolist() for i in range(envs.num_envs)]


def test_some_seeds_may_be_none():
    envs, twin = mimo.make_vec("reach", num_envs=3), mimo.make_vec("reach", num_envs=3)
    envs.reset(seed=[1, 2, 3])
    twin.reset(seed=[1, 2, 3])
    observation, _ = envs.reset(seed=[5, None, 7])
    other, _ = twin.reset()  # nobody has a seed
    single, _ = mimo.make("reach").reset(seed=5)
    for name, field in observation.items():
        np.testing.assert_array_equal(field[0], single[name])
        np.testing.assert_array_equal(field[1], other[name][1])
    drawn, fresh = random_of(envs), random_of(twin)
    assert drawn[1] == fresh[1]
    assert drawn[0] != fresh[0]
    masked, _ = envs.reset(seed=[None, 5, 9], options={"reset_mask": np.array([True, True, False])})
    for name, field in masked.items():
        np.testing.assert_array_equal(field[1], single[name])
        np.testing.assert_array_equal(field[2], observation[name][2])
    with pytest.raises(ValueError, match="2 seeds, expected 3"):
        envs.reset(seed=[5, None])
    with pytest.raises(ValueError, match="seed is -1"):
        envs.reset(seed=[5, None, -1])


def test_worlds_without_a_seed_start_randomly():
    drawn = []
    for _ in range(2):
        envs = mimo.make_vec("reach", num_envs=2)
        envs.reset(seed=[5, None])
        drawn.append(random_of(envs))
    assert drawn[0][0] == drawn[1][0]
    assert drawn[0][1] != drawn[1][1]


# ---- What messages say -----------------------------------------------------------------------------------------------


class Empty(mimo.Task):
    pass


class EmptyInside(mimo.WorldTask):
    pass


def stepped(task):
    env = mimo.make("reach", task=task)
    env.reset(seed=1)
    env.step(np.zeros(8))


def stepped_inside(task):
    scene = mimo.Scene("reach")
    scene.add_agents()
    scene.set_task(task)
    mimo.World(scene).step()


def masses(world):
    world.bodies("head", "hip").mass = [1, 2, 3]


WORDS = {
    "no eyes": (
        lambda w, b: w.observation["vision/eye_left"],
        KeyError,
        "^no field 'vision/eye_left': vision is off here",
    ),
    "no field": (
        lambda w, b: b.observation["proprioception/postion"],
        KeyError,
        "did you mean 'proprioception/position'",
    ),
    "prefix": (
        lambda w, b: w.joints("left_elbow"),
        mimo.NotFoundError,
        'did you mean "robot:left_elbow"[?] there are: ',
    ),
    "motor": (lambda w, b: w.actuators("right_elbow"), mimo.NotFoundError, 'did you mean "act:right_elbow"'),
    "letters": (lambda w, b: b.bodies("haed"), mimo.NotFoundError, 'did you mean "head"'),
    "batch[0]": (lambda w, b: b[0], TypeError, r"a Batch has no \[0\]; a world of it is world\(0\)"),
    "bodies[0]": (lambda w, b: w.bodies()[0], TypeError, r"a selection has no \[0\]; its arrays have"),
    "for seeds": (lambda w, b: b.reset(seed=3), TypeError, "unexpected keyword argument 'seed'; did you mean 'seeds'"),
    "for seed": (lambda w, b: w.reset(seeds=3), TypeError, "unexpected keyword argument 'seeds'; did you mean 'seed'"),
    "file": (lambda w, b: mimo.World("my.xml"), mimo.NotFoundError, r"for a file use mimo\.Scene\(file='my\.xml'\)"),
    "masses": (lambda w, b: masses(w), ValueError, r"body_mass of the shape \(3,\), expected \(2,\), or one number"),
    "masses of many": (lambda w, b: masses(b), ValueError, r"body_mass of the shape \(3,\), expected \(2, 2\), or one"),
    "no mass": (
        lambda w, b: w.set("body_mass", "heavy", ["head"]),
        TypeError,
        "body_mass is 'heavy', expected numbers",
    ),
    "empty task": (lambda w, b: stepped(Empty()), NotImplementedError, r"Empty has no method evaluate\(self, world\)"),
    "empty inside": (lambda w, b: stepped_inside(EmptyInside()), mimo.TaskError, r"EmptyInside has no method evaluate"),
    "a task's class": (lambda w, b: stepped(Empty), TypeError, r"the class Empty, expected an object of it: Empty\("),
    "inside": (lambda w, b: stepped_inside(EmptyInside), TypeError, "the class EmptyInside, expected an object"),
    "box": (
        lambda w, b: mimo.Scene().add_object("box", shape="box", size=0.1),
        mimo.ArgumentError,
        r"size\[1\] is 0, expected metres above 0, for a box half of each of its three edges",
    ),
    "thick": (
        lambda w, b: mimo.Scene("free").add_agent(age=1, z_length=-3, z_weight=3),
        mimo.ArgumentError,
        r"the capsule of its \w*(body|arm|leg|head|hip)\w* would be|do not go together; expected",
    ),
}


@pytest.fixture(scope="module")
def worlds():
    return mimo.World("reach"), mimo.Batch("reach", 2)


@pytest.mark.parametrize("case", WORDS)
def test_messages_of_wrong_calls(case, worlds):
    call, kind, line = WORDS[case]
    with pytest.raises(kind, match=line) as raised:
        call(*worlds)
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize("make", [mimo.make, mimo.make_vec])
def test_render_without_a_mode_warns(make):
    env = make("reach")
    with pytest.warns(
        UserWarning, match="draws nothing: this .* was made without render_mode; give it render_mode='rgb_array'"
    ):
        assert env.render() is None
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        make("reach", render_mode="rgb_array", width=8, height=8).render()


EXTRAS = {
    "mimo.ParallelEnv": ("pettingzoo", "mimo[pettingzoo]"),
    "mimo.sb3": ("stable_baselines3", "mimo[train]"),
    "mimo.ray": ("ray", "mimo[ray]"),
    "mimo.rerun": ("rerun", "mimo[rerun]"),
    "mimo.plot": ("matplotlib", "mimo[plot]"),
    "mimo.view.open()": ("viser", "mimo[view]"),
    "mimo.video.film(mimo.view.Live('reach'), 'a.mp4')": ("av", "mimo[video]"),
    "mimo.babybench.load('selftouch')": ("yaml", "mimo[babybench]"),
}


@pytest.mark.parametrize("used", EXTRAS)
def test_a_missing_extra_is_named(used):
    module, extra = EXTRAS[used]
    program = f"""
        import sys
        sys.modules[{module!r}] = None  # as if it were not installed
        import mimo
        try:
            {used}
        except (ImportError, mimo.UnsupportedError) as error:
            print(error)
        """
    told = subprocess.run([sys.executable, "-c", textwrap.dedent(program)], capture_output=True, text=True)
    assert f"pip install '{extra}'" in told.stdout, told.stderr


def test_every_module_is_there_after_import_mimo(root):
    modules = sorted((root / "bindings/python/src/mimo").glob("[a-z]*"))
    names = [path.stem for path in modules if path.suffix == ".py" or (path / "__init__.py").is_file()]
    assert {"sb3", "plot", "view", "motion"} <= set(names)
    program = f"""
        import mimo
        for name in {names!r}:
            try:
                assert getattr(mimo, name).__name__ in (f"mimo.{{name}}", name), name
            except ImportError as error:
                assert "pip install 'mimo[" in str(error), error
        assert not hasattr(mimo, "nothing")
        """
    told = subprocess.run([sys.executable, "-c", textwrap.dedent(program)], capture_output=True, text=True)
    assert told.returncode == 0, told.stderr


# ---- The end of Python -----------------------------------------------------------------------------------------------


@pytest.mark.skipif(sys.version_info >= (3, 12), reason="interpreters have locks of their own there, and numpy has not")
@pytest.mark.parametrize("kept", ["world", "closed", "scene", "batch"])
def test_a_second_interpreter_ends(kept):
    """As hosts embed Python. What lives in it at the end of the process is freed under Python's lock."""
    made = {
        "world": "it = mimo.World('free', vision=False)",
        "closed": "it = mimo.World('free', vision=False); it.close()",
        "scene": "it = mimo.Scene('free')",
        "batch": "it = mimo.Batch('free', 2, vision=False); it.reset(1); it.send()",
    }[kept]
    program = (
        f"import _xxsubinterpreters as s; i = s.create(); s.run_string(i, {f'import mimo; {made}'!r}); print('ran')"
    )
    told = subprocess.run([sys.executable, "-W", "ignore", "-c", program], capture_output=True, text=True, timeout=120)
    assert (told.returncode, told.stdout) == (0, "ran\n"), told.stderr
