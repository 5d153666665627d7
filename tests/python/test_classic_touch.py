"""Touch of one's own, in classes derived from those of the original's module mimoTouch.touch.

Forces are compared with the library's own touch and with its contacts. 7258 is the original's number of sensors before
those inside the body are left out; 5685 is this library's number without them (docs/differences.md).
"""

import copy

import numpy as np
import pytest

from mimo.classic import DEFAULT_TOUCH_PARAMS, MIMoDummyEnv
from mimo.classic.checking import examine
from mimo.classic.touch import GEOM_TYPES, DiscreteTouch, Touch, TrimeshTouch, scale_linear

BLIND = {"vision_params": None, "vestibular_params": None}


def env_with(make, steps=40, **params):
    """An environment whose touch `make` makes (None: the library), after some steps of random actions."""

    class Own(MIMoDummyEnv):
        def touch_setup(self, touch_params):
            self.touch = make(self, touch_params)

    kind = MIMoDummyEnv if make is None else Own
    env = kind(touch_params={**DEFAULT_TOUCH_PARAMS, **params}, **BLIND)
    env.action_space.seed(0)
    env.reset(seed=0)
    for _ in range(steps):
        env.step(env.action_space.sample())
    assert len(env.touch.get_contacts()) > 3
    return env


@pytest.mark.parametrize("function", ["force_vector", "force_vector_global"])
def test_forces_are_the_library_s(function):
    own, library = (env_with(make, touch_function=function).touch for make in (TrimeshTouch, None))
    assert own.get_total_sensor_count() == library.get_total_sensor_count() == 5685
    felt = 0
    for body, outputs in library.sensor_outputs.items():
        np.testing.assert_array_equal(own.sensor_positions[body], library.sensor_positions[body])
        # The library's distances run along the skin, these are straight: only the sums agree, to float32's rounding.
        np.testing.assert_allclose(own.sensor_outputs[body].sum(axis=0), outputs.sum(axis=0), rtol=1e-5, atol=1e-4)
        felt += bool(outputs.any())
    assert felt > 3


def test_the_nearest_sensors_are_the_library_s():
    own, library = (env_with(make, response_function="nearest").touch for make in (TrimeshTouch, None))
    for body, outputs in library.sensor_outputs.items():
        np.testing.assert_allclose(own.sensor_outputs[body], outputs, rtol=1e-5, atol=1e-4)


def test_sensors_on_geoms():
    env = env_with(DiscreteTouch)
    touch = env.touch
    assert touch.get_total_sensor_count() == 7258
    assert set(touch.sensing_geoms) <= set(range(env.model.ngeom))
    # In the geoms' frames; back in the world they are the contacts' forces.
    total = sum(
        outputs.sum(axis=0) @ env.data.geom_xmat[geom].reshape(3, 3).T for geom, outputs in touch.sensor_outputs.items()
    )
    expected = np.zeros(3)
    contacts = env.data.contact
    for number in range(len(contacts)):
        for sign, geom in ((-1, contacts[number].geom1), (1, contacts[number].geom2)):
            if touch.has_sensors(geom_id=geom):
                expected += sign * contacts.force(number)[:3] @ contacts[number].frame.reshape(3, 3)
    assert np.linalg.norm(expected) > 1
    np.testing.assert_allclose(total, expected, atol=1e-3)
    assert touch.get_raw_force(contact_id=0, geom_id=touch.get_contacts()[0][1]).shape == (3,)


def test_sensors_at_another_distance_lie_where_the_library_s_do():
    env = env_with(TrimeshTouch)
    for body, points in env.touch.sensor_positions.items():
        alike = env.touch._points(body, env.touch.sensor_scales[body])
        assert len(alike) == len(points), env.model.body(body).name
        near = np.linalg.norm(points[:, None] - alike, axis=2).min(axis=1)
        assert near.max() < 1e-6
    fewer = env.touch.add_body(body_name="head", scale=0.05)
    head = env.model.body("head").id
    assert 0 < fewer == env.touch.get_sensor_count(head) < 404  # 404: the original's, at 0.013 m
    assert len(env.touch.meshes[head].vertices) == fewer


class Seven(TrimeshTouch):
    """Seven numbers a sensor, spread by a Gaussian."""

    VALID_TOUCH_TYPES = {**TrimeshTouch.VALID_TOUCH_TYPES, "seven": 7}  # noqa: RUF012
    VALID_RESPONSE_FUNCTIONS = ["nearest", "spread_linear", "spread_gaussian"]  # noqa: RUF012

    def seven(self, contact_id, body_id):
        return np.concatenate([self.force_vector(contact_id, body_id), np.ones(3), self.normal(contact_id, body_id)])

    def spread_gaussian(self, contact_id, body_id, force):
        scale = self.sensor_scales[body_id]
        place = self.get_contact_position_relative(contact_id=contact_id, body_id=body_id)
        sensors, distances = self.get_sensors_within_distance(place, body_id, 3 * scale)
        weights = np.exp(-0.5 * (distances / (1.5 * scale)) ** 2)
        for sensor, weight in zip(sensors, weights / weights.sum() if len(sensors) else []):
            self.sensor_outputs[body_id][sensor] += force * weight


def test_functions_of_ones_own():
    env = env_with(Seven, touch_function="seven", response_function="spread_gaussian")
    touch = env.touch
    seen, *_ = env.step(np.zeros(env.action_space.shape))
    assert seen["touch"].shape == (7 * 5685,) == env.observation_space["touch"].shape
    contacts = touch.get_contacts()
    assert contacts
    ones = sum(outputs[:, 3].sum() for outputs in touch.sensor_outputs.values())
    assert ones == pytest.approx(len(contacts), rel=1e-5)  # each contact gave one, whole
    number, body, felt = contacts[0]
    index, distance = touch.get_nearest_sensor(touch.get_contact_position_relative(number, body), body)
    assert distance < 2 * touch.sensor_scales[body]
    assert touch.get_k_nearest_sensors(touch.get_contact_position_relative(number, body), body, 3)[0][0] == index
    np.testing.assert_array_equal(touch.get_force(number, body), felt)
    assert copy.deepcopy(env).touch.get_total_sensor_count() == 5685


def test_normal_forces():
    env = env_with(TrimeshTouch, touch_function="normal_force")
    touch = env.touch
    for number, body, felt in touch.get_contacts():
        assert np.linalg.norm(felt) == pytest.approx(abs(touch.get_raw_force(number, body)[0]))
        turn = env.data.xmat[body].reshape(3, 3)
        # Contacts push: along the normal that points to the body's own side.
        assert turn @ felt @ touch.get_contact_normal(number, body) > 0


def test_old_names():
    class Old(TrimeshTouch):
        VALID_ADJUSTMENTS = ("everywhere",)

        def everywhere(self, contact_id, body_id, force):
            self.sensor_outputs[body_id] += force

    class Env(MIMoDummyEnv):
        def touch_setup(self, touch_params):
            self.touch = Old(
                self, {"scales": {"head": 0.1}, "touch_function": "normal", "adjustment_function": "everywhere"}
            )

    env = Env(**BLIND)
    assert env.touch.adjustment_type == "everywhere"
    assert env.touch.touch_size == 1
    assert env.touch.sensor_body_names == ["head"]
    assert (scale_linear(np.ones(2), 1.0, 4.0), GEOM_TYPES["BOX"]) == (pytest.approx([0.75, 0.75]), 6)
    assert scale_linear(1.0, 5.0, 4.0) == 0


def test_members_of_the_library_s_touch():
    env = env_with(None)
    assert sorted(env.touch.meshes) == env.touch.sensing_bodies
    number, body, force = env.touch.get_contacts()[0]
    np.testing.assert_array_equal(force, env.touch.force_vector(number, body))


def test_what_cannot_be_is_refused():
    with pytest.raises(ValueError, match="touch_function'] is 'pain', expected 'force_vector'"):
        env_with(TrimeshTouch, touch_function="pain")
    with pytest.raises(ValueError, match="response_function'] is 'wide', expected 'nearest', 'spread_linear'"):
        env_with(TrimeshTouch, response_function="wide")
    with pytest.raises(NotImplementedError, match="Touch has no method get_touch_obs"):
        Touch.get_touch_obs(object.__new__(Touch))
    touch = env_with(TrimeshTouch).touch
    with pytest.raises(AttributeError, match="TrimeshTouch has no 'plot_force_body' here"):
        touch.plot_force_body()
    number = touch.get_contacts()[0][0]
    other = next(it for it in touch.sensing_bodies if it not in {owner for _, owner, _ in touch.get_contacts()})
    with pytest.raises(ValueError, match=f"contact {number} is not one of {other}: its geoms are"):
        touch.get_raw_force(number, other)


def test_checking_knows_the_members_of_touch():
    found = examine(
        """
import mimoEnv
from mimoTouch.touch import DiscreteTouch, TrimeshTouch


class Own(TrimeshTouch):
    def spread_wide(self, contact_id, body_id, force):
        self.wide = True


env = mimoEnv.make("MIMoBench-v0")
env.touch.get_contacts(), env.touch.sensor_scales, env.touch.meshes, env.touch.add_geom, env.touch.touch_size
env.touch.spread_wide, env.touch.wide
env.touch.plot_force_body
"""
    )
    assert found.missing == [(14, "touch.plot_force_body")]
