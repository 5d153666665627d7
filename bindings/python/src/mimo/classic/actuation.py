"""The original's actuation models: the argument of an environment selects one, and its member has one."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Type

import numpy as np
from gymnasium import spaces
from numpy.typing import ArrayLike, NDArray

from ..arguments import whole_number
from ..constants import Actuation
from ..spaces import action_box
from .live import PAGE

Numbers = NDArray[Any]
# Lengths of a muscle at the ends of its joint's range, of the original; the last keeps divisions safe.
_SHORTEST, _LONGEST, _TINY = 0.75, 1.05, 1e-10


class ActuationModel:
    """How actions move motors. Scripts may derive their own: `action` and `substep_update` set `env.data.ctrl`."""

    actuation: Actuation = Actuation.TORQUE  # the library's, which does the work for the classes below

    def __init__(self, env: Any = None, actuators: Any = ()) -> None:
        self.env, self.actuators = env, np.asarray(actuators)
        self._given: Any = None  # the last action

    @property
    def control_input(self) -> Any:
        """The last action, within its bounds; None before the action space is made."""
        if self._given is None or np.shape(self._given) != np.shape(self.env.world.action_low):
            return self._given
        return self._clipped(self._given)

    @control_input.setter
    def control_input(self, action: Any) -> None:
        self._given = None if action is None else np.array(action, np.float64)

    @property
    def n_actuators(self) -> int:
        """The number of motors."""
        return len(self.actuators)

    def get_action_space(self) -> spaces.Box:
        """The space of actions."""
        world = self.env.world
        if self.control_input is None:
            self.control_input = np.zeros(len(world.action_low))
        return action_box(world.action_low, world.action_high)

    @property
    def action_space(self) -> Any:
        """The space of actions."""
        return self.get_action_space()

    def action(self, action: ArrayLike) -> None:
        """Sets the action of the next physics steps."""
        raise NotImplementedError

    def substep_update(self) -> None:
        """Called before each physics step."""

    def observations(self) -> Numbers:
        """The part `actuation` of the observation."""
        fields = self.env.observer.actuation_fields
        seen = self.env.seen()
        return np.concatenate([np.ravel(seen[name]) for name in fields], dtype=np.float64) if fields else np.zeros(0)

    def cost(self) -> float:
        """What the current action costs."""
        raise NotImplementedError

    def reset(self) -> None:
        """Called at the beginning of an episode."""
        raise NotImplementedError

    def _clipped(self, action: ArrayLike) -> Numbers:
        space = getattr(self.env, "action_space", None)
        values = np.array(action, np.float64)
        return values if space is None else np.clip(values, space.low, space.high)


class SpringDamperModel(ActuationModel):
    """Actions are shares of the motors' largest torques; joints have springs and dampers."""

    actuation = Actuation.TORQUE

    @property
    def max_torque(self) -> Numbers:
        """The motors' largest torques, Nm."""
        return np.array(self.env.model.actuator_gear[self.actuators, 0])

    def action(self, action: ArrayLike) -> None:
        """Sets the motors' controls."""
        self.control_input = self._clipped(action)
        self.env.data.ctrl[self.actuators] = self.control_input

    def simulation_torque(self) -> Numbers:
        """The motors' torques, Nm."""
        return np.array(self.max_torque * self.env.data.ctrl[self.actuators])

    def observations(self) -> Numbers:
        """Controls, then torques."""
        return np.concatenate([self.control_input, self.simulation_torque()])

    def cost(self) -> float:
        """The mean squared control, by torque: sum(u^2 T) / (n sum(T))."""
        torque = self.max_torque
        return float(np.abs(self.control_input**2 * torque).sum() / (self.n_actuators * torque.sum()))

    def reset(self) -> None:
        """Sets all controls to 0."""
        self.action(np.zeros(len(self.actuators)))


class PositionalModel(ActuationModel):
    """Actions are target angles of joints, rad."""

    actuation = Actuation.POSITION

    def action(self, action: ArrayLike) -> None:
        """Sets the angles, for the next physics step."""
        self.control_input = self._clipped(action)
        self.env.act_next(self.control_input)

    def observations(self) -> Numbers:
        """The angles."""
        return np.array(self.control_input, np.float64)

    def cost(self) -> float:
        """Nothing."""
        return 0.0

    def reset(self) -> None:
        """Sets all angles to 0."""
        self.action(np.zeros_like(self.control_input))


class MuscleModel(ActuationModel):
    """Actions are activations of two muscles per motor, 0 to 1: first all of one direction, then all of the other."""

    actuation = Actuation.MUSCLE
    lmax, lmin, fvmax, fpmax, tau = 1.6, 0.5, 1.2, 1.3, 0.01
    lce_min, lce_max = _SHORTEST, _LONGEST

    def action(self, action: ArrayLike) -> None:
        """Sets the muscles' targets, for the next physics step."""
        self.control_input = self._clipped(action)
        self.env.act_next(self.control_input)

    def cost(self) -> float:
        """The mean squared activation, by force: sum(a^2 F) / (2 n sum(F))."""
        force = self.fmax
        return float(np.abs(self.activity**2 * force).sum() / (2 * self.n_actuators * force.sum()))

    def reset(self) -> None:
        """Relaxes the muscles, as a reset of the environment does."""
        self.control_input = np.zeros(2 * self.n_actuators)
        if self.activity.any():
            raise NotImplementedError(f"muscles relax with env.reset() only, not with actuation_model.reset(); {PAGE}")

    @property
    def target_activity(self) -> Numbers:
        """The activation that each muscle goes to."""
        return np.array(self.control_input)

    @property
    def activity(self) -> Numbers:
        """Each muscle's activation."""
        return np.array(self.env.seen()["proprioception/activation"], np.float64).ravel()

    muscle_activations = activity

    @property
    def muscle_forces(self) -> Numbers:
        """Each muscle's force, 1 for its largest."""
        return np.array(self.env.seen()["proprioception/muscle_force"], np.float64).ravel() / self.fmax

    @property
    def muscle_lengths(self) -> Numbers:
        """Each muscle's length."""
        return np.concatenate([self.lce_1, self.lce_2])

    @property
    def muscle_velocities(self) -> Numbers:
        """Each muscle's velocity."""
        return np.concatenate([self.lce_dot_1, self.lce_dot_2])

    @cached_property
    def vmax(self) -> Numbers:
        """Each motor's fastest shortening."""
        return np.array(self.env.model.actuator_user[self.actuators, 0])

    @cached_property
    def fmax(self) -> Numbers:
        """Each muscle's largest force."""
        return np.array(self.env.model.actuator_user[self.actuators, 1:3]).T.ravel()

    @cached_property
    def mimo_actuated_joints(self) -> Numbers:
        """The motors' joints."""
        return np.array(self.env.model.actuator_trnid[self.actuators, 0])

    @cached_property
    def mimo_actuated_qpos(self) -> Numbers:
        """Where they are in qpos."""
        return np.array(self.env.model.jnt_qposadr[self.mimo_actuated_joints])

    @cached_property
    def mimo_actuated_qvel(self) -> Numbers:
        """Where they are in qvel."""
        return np.array(self.env.model.jnt_dofadr[self.mimo_actuated_joints])

    @cached_property
    def phi_min(self) -> Numbers:
        """The lower ends of the joints' ranges from their rest, rad."""
        return self.env.model.jnt_range[self.mimo_actuated_joints, 0] - self._rest

    @cached_property
    def phi_max(self) -> Numbers:
        """The upper ends."""
        return self.env.model.jnt_range[self.mimo_actuated_joints, 1] - self._rest

    @cached_property
    def _rest(self) -> Numbers:
        return np.array(self.env.model.qpos_spring[self.mimo_actuated_qpos])

    @property
    def moment_1(self) -> Numbers:
        """Lengths per angle of the muscles that pull to the negative side."""
        return (_LONGEST - _SHORTEST + _TINY) / (self.phi_max - self.phi_min + _TINY)

    @property
    def moment_2(self) -> Numbers:
        """... and to the positive side."""
        return -self.moment_1

    @property
    def lce_1(self) -> Numbers:
        """Lengths of the muscles that pull to the negative side."""
        return _SHORTEST + self.moment_1 * (self._angles - self.phi_min)

    @property
    def lce_2(self) -> Numbers:
        """... and to the positive side."""
        return _SHORTEST + self.moment_2 * (self._angles - self.phi_max)

    @property
    def lce_dot_1(self) -> Numbers:
        """Their velocities."""
        return self.moment_1 * self.env.data.qvel[self.mimo_actuated_qvel]

    @property
    def lce_dot_2(self) -> Numbers:
        """... and of the others."""
        return self.moment_2 * self.env.data.qvel[self.mimo_actuated_qvel]

    @property
    def force_muscles_1(self) -> Numbers:
        """Forces of the muscles that pull to the negative side."""
        return self.muscle_forces[: self.n_actuators]

    @property
    def force_muscles_2(self) -> Numbers:
        """... and to the positive side."""
        return self.muscle_forces[self.n_actuators :]

    @property
    def joint_torque(self) -> Numbers:
        """The muscles' torques, Nm."""
        fmax, n = self.fmax, self.n_actuators
        pulls = self.moment_1 * self.force_muscles_1 * fmax[:n] + self.moment_2 * self.force_muscles_2 * fmax[n:]
        return -pulls

    @property
    def _angles(self) -> Numbers:
        return self.env.data.qpos[self.mimo_actuated_qpos] - self._rest


MODELS = (SpringDamperModel, PositionalModel, MuscleModel)


def model_of(given: Any) -> Type[ActuationModel]:
    """The class of an argument: one of these, a derived one, an instance, or a name of mimo.Actuation."""
    kind = given if isinstance(given, type) else type(given)
    if issubclass(kind, ActuationModel):
        return kind
    if isinstance(given, (str, int)):
        number = whole_number("actuation_model", given, Actuation)
        return next((model for model in MODELS if model.actuation == number), _another(Actuation(number)))
    names = ", ".join(model.__name__ for model in MODELS)
    raise TypeError(f"actuation_model is {given!r}, expected {names}, or a member of mimo.Actuation")


def is_own(model: Type[ActuationModel]) -> bool:
    """Whether a script has derived the class, so that Python sets the motors in each physics step."""
    own = ("action", "substep_update", "get_action_space", "observations")
    return any(
        getattr(model, name) is not getattr(base, name)
        for base in [next((it for it in MODELS if issubclass(model, it)), ActuationModel)]
        for name in own
    ) and not getattr(model, "_library", False)


def _another(actuation: Actuation) -> Type[ActuationModel]:
    """A class for a model that the original does not have, such as MuJoCo's muscles."""
    return type("OtherModel", (MuscleModel,), {"actuation": actuation, "_library": True})
