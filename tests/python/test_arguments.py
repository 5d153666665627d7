"""What callers mistype, and what they are told: the argument, its value, what was expected."""

import os

import numpy as np
import pytest

import mimo
from mimo._library import LIB, raise_error


class Silent(mimo.Task):
    """Forgets to judge."""

    def __init__(self, answer=0.5):
        self.answer = answer

    def evaluate(self, world):
        return self.answer


def scene():
    return mimo.Scene("free")


def set_gravity(value):
    mimo.World("reach").gravity = value


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (
            lambda: scene().add_object("ball", siez=3),
            TypeError,
            "argument 'siez'; did you mean 'size'? There are: fixed",
        ),
        (lambda: scene().add_agent(touch_scael=3), TypeError, "argument 'touch_scael'; did you mean 'touch_scale'?"),
        (lambda: scene().add_camera("wall", lookat=(0, 0, 1)), TypeError, "argument 'lookat'; did you mean 'look_at'?"),
        (lambda: scene().add_model("cup", fiel="cup.xml"), TypeError, "argument 'fiel'; did you mean 'file'?"),
        (lambda: mimo.World("reach").render(widht=3), TypeError, "argument 'widht'; did you mean 'width'?"),
        (lambda: mimo.make("reach", frameskip=3), TypeError, "argument 'frameskip'; did you mean 'frame_skip'?"),
        (lambda: mimo.make("reach", rendermode=3), TypeError, "argument 'rendermode'; did you mean 'render_mode'?"),
        (lambda: mimo.make_vec("reach", autoreset=3), TypeError, "'autoreset'; did you mean 'autoreset_mode'?"),
        (lambda: mimo.ParallelEnv("reach", flat=3), TypeError, "argument 'flat'; did you mean 'flatten'?"),
        (lambda: mimo.Batch("reach", thread=3), TypeError, "argument 'thread'; did you mean 'threads'?"),
        (lambda: mimo.World("reach", xyzzy=3), TypeError, "keyword argument 'xyzzy'. There are: absolute, acts"),
        (lambda: mimo.Batch("reach", 2).world(2**70), ValueError, f"world is {2**70}, expected 0 to 1"),
        (lambda: mimo.Batch("reach", 2).world(-1), ValueError, "world is -1, expected 0 to 1"),
        (lambda: mimo.Batch("reach", 2).world(0.5), TypeError, "world is 0.5, expected a whole number"),
        (lambda: mimo.Batch("reach", 2).contacts(2**64), ValueError, f"world is {2**64}, expected 0 to 1"),
        (lambda: mimo.Batch("reach", 2).error(2**64), ValueError, f"world is {2**64}, expected 0 to 1"),
        (lambda: mimo.Batch("reach", 2).set_face("fear", 2**64), ValueError, f"agent is {2**64}, expected 0"),
        (lambda: mimo.Batch("reach", 2).random(2**64), ValueError, f"count is {2**64}, expected 0 to 2^32 - 1"),
        (lambda: mimo.Batch("reach", 2**32), ValueError, f"worlds is {2**32}, expected 0 to 2^32 - 1"),
        (lambda: mimo.Batch("reach", 2, threads=2**32), ValueError, f"threads is {2**32}, expected 0 to"),
        (lambda: mimo.World("reach").gaze(2**64), ValueError, f"agent is {2**64}, expected 0"),
        (lambda: mimo.World("reach").face(-1), ValueError, "agent is -1, expected 0"),
        (lambda: mimo.World("reach").layout.receptors(3), TypeError, "name is 3, expected a string"),
        (lambda: mimo.World("reach").reset(2**64), ValueError, f"seed is {2**64}, expected 0 to 2^64 - 1"),
        (lambda: mimo.World("reach").reward_terms(2**64), ValueError, f"agent is {2**64}, expected 0"),
        (lambda: mimo.World("reach").physics_step(2**64 + 1), ValueError, f"count is {2**64 + 1}, expected 0 to"),
        (lambda: mimo.World("reach").name("body", 2**32), ValueError, f"number is {2**32}, expected 0 to"),
        (lambda: mimo.World("reach").find(2**32 + 1, "head"), TypeError, f"kind is {2**32 + 1}, expected mimo.Kind"),
        (lambda: scene().set_touch("head", 0.1, agent=2**64), ValueError, f"agent is {2**64}, expected 0 to"),
        (lambda: scene().limit_sense("touch", delay="soon"), TypeError, "delay is 'soon', expected a number"),
        (lambda: scene().add_object("ball", shape="cube"), ValueError, "shape is 'cube', expected mimo.Shape or"),
        (lambda: scene().add_object("ball", size="big"), TypeError, "size is 'big', expected a number"),
        (lambda: scene().add_object("ball", size=[1, 2, 3, 4]), ValueError, "expected 1 to 3 numbers"),
        (
            lambda: scene().add_field("x", "body_place", "head"),
            ValueError,
            "quantity is 'body_place', expected mimo",
        ),
        (lambda: scene().add_field("x", "body_mass", 3), TypeError, "elements is 3, expected names"),
        (lambda: scene().add_field("x", "body_mass", ["head", 3]), TypeError, "elements is ['head', 3], expected na"),
        (lambda: scene().add_field("x", "body_mass", "head", relative_to=3), TypeError, "relative_to is 3, expected a"),
        (lambda: scene().add_agent(actuation="muscel"), ValueError, "torque, position, muscle, mujoco_muscle"),
        (lambda: scene().add_agent(touch=3.5), TypeError, "touch is 3.5, expected mimo.Touch or a name"),
        (lambda: scene().add_agent(vision_width=3.5), TypeError, "vision_width is 3.5, expected a whole number"),
        (lambda: scene().add_agent(position=3), ValueError, "position is 3, expected 3 numbers"),
        (lambda: scene().add_agent(touch_scale="fine"), TypeError, "touch_scale is 'fine', expected a number"),
        (lambda: scene().add_agent(name=3), TypeError, "name is 3, expected a string"),
        (lambda: scene().lock("robot:left_knee", "bent"), TypeError, "value is 'bent', expected a number"),
        (lambda: mimo.World("reach").look_at([0, 0, 1], how="neck"), ValueError, "how is 'neck', expected mimo.Look"),
        (lambda: mimo.World("reach").look_at(1), ValueError, "point is 1, expected 3 numbers"),
        (lambda: mimo.Batch("reach", 2, autoreset="never"), ValueError, "none, next_step, same_step"),
        (lambda: set_gravity(-9.81), ValueError, "gravity is -9.81, expected 3 numbers"),
        (lambda: set_gravity([0, -9.81]), ValueError, "gravity is [0, -9.81], expected 3 numbers"),
        (lambda: mimo.World("reach").reset("a"), TypeError, "seed is 'a', expected a whole number"),
        (lambda: mimo.Batch("reach", 2).reset("a"), TypeError, "seed is 'a', expected a whole number"),
        (lambda: mimo.Batch("reach", 2).reset([1, 2.5]), TypeError, "seed is 2.5, expected a whole number"),
        (lambda: mimo.World("reach", task=Silent()), TypeError, "make, make_vec and ParallelEnv take"),
        (lambda: mimo.Batch("reach", task=Silent()), TypeError, "make, make_vec and ParallelEnv take"),
        (lambda: mimo.World("reach").contacts(1), ValueError, "world is 1, expected 0"),
        (lambda: mimo.make(scene()), ValueError, "no infant; add one with its add_agent()"),
        (lambda: mimo.make_vec(scene()), ValueError, "no infant; add one with its add_agent()"),
        (lambda: mimo.ParallelEnv(scene()), ValueError, "no infant; add some with its add_agent()"),
        (lambda: mimo.make_vec("playdate"), ValueError, "2 infants, expected one; for several use mimo.ParallelEnv"),
    ],
)
def test_delays_are_reported(call, kind, message):
    with pytest.raises(kind) as caught:
        call()
    assert message in str(caught.value)


def test_enums_by_the_names_of_their_members():
    muscles = mimo.World("free", actuation="muscle", vision=False, touch="Slip")
    assert len(muscles.action_names) == 88  # two for each of the 44 motors
    assert "touch/slip" in muscles.layout.fields
    room = scene()
    room.add_object("cube", shape="BOX", size=np.array([0.01, 0.02, 0.03]))
    np.testing.assert_allclose(mimo.World(room).geoms("cube").size[0], [0.01, 0.02, 0.03])
    assert muscles.count("camera") == muscles.count(mimo.Kind.CAMERA) == 2


def test_a_missing_judgement_is_refused():
    one = mimo.make("benchmark", task=Silent(), vision=False, touch=False)
    one.reset(seed=0)
    with pytest.raises(TypeError, match=r"Silent\.evaluate returned an object of type float; return a mimo\.Judgement"):
        one.step(one.action_space.sample())
    many = mimo.make_vec("benchmark", num_envs=2, task=Silent(None), vision=False, touch=False)
    many.reset(seed=0)
    with pytest.raises(TypeError, match="returned None; return a"):
        many.step(many.action_space.sample())


def test_the_scene_supplies_a_missing_place():
    quarter = [np.sqrt(0.5), 0, 0, np.sqrt(0.5)]
    infant = mimo.World("free", orientation=quarter, vision=False, touch=False).bodies("mimo_location")
    np.testing.assert_array_equal(infant.position[0], [0, 0, 0.4])  # mimo:place of models/free.xml
    np.testing.assert_allclose(infant.orientation[0], quarter)
    lying = mimo.World("selfbody", position=[0, 0, 1]).bodies("mimo_location")
    np.testing.assert_allclose(lying.orientation[0][0], 0.8922939087000012)  # that of models/selfbody.xml
    two = scene()
    two.add_agent(name="anna", orientation=quarter)
    with pytest.raises(ValueError, match="no place for infant number 2; give position"):
        two.add_agent(name="ben", orientation=quarter)


def test_objects_say_what_they_are():
    room = scene()
    room.add_agent(touch=False)
    assert repr(room) == "<mimo.Scene free: 1 infants>"
    assert repr(mimo.Scene(xml="<mujoco/>")) == "<mimo.Scene xml: 0 infants>"
    world = mimo.World("reach")
    assert repr(world).startswith("<mimo.World reach: 1 infants, 8 actions; proprioception/position (47,), ")
    assert repr(world.bodies("head", "hip")) == "<2 bodies: head, hip>"
    assert repr(world.joints()).endswith("robot:head_swivel, ...>")
    world.close()
    assert repr(world).startswith("<mimo.World reach: ")
    assert repr(mimo.Batch("reach", 3)).startswith("<mimo.Batch 3 x reach: 1 infants")


def test_messages_that_are_not_utf_8_are_logged(monkeypatch):
    monkeypatch.setattr(LIB, "mimo_last_error", lambda: "no body named \u00e4".encode()[:-1])  # cut inside a character
    with pytest.raises(mimo.ArgumentError, match="no body named \ufffd"):
        raise_error(-1)


def test_paths_that_are_not_utf_8(tmp_path):
    file = tmp_path / os.fsdecode(b"r\xe4um.xml")  # Latin-1, as old disks have it
    file.write_text("<mujoco><worldbody><body name='box'><geom size='.1'/></body></worldbody></mujoco>")
    assert mimo.World(mimo.Scene(file=file)).count("body") == 2
    with pytest.raises(mimo.NotFoundError):
        mimo.Scene(file=tmp_path / os.fsdecode(b"nichts\xe4.xml"))
