"""The original's actuation models, by its names: which one an environment is given says how actions move the body."""

from __future__ import annotations

from typing import Any, Type

from ..arguments import whole_number
from ..constants import Actuation


class ActuationModel:
    """What an action is. The classes are only names here: the library does the work."""

    actuation: Actuation


class SpringDamperModel(ActuationModel):
    """Actions are shares of the motors' largest torques; joints have springs and dampers."""

    actuation = Actuation.TORQUE


class PositionalModel(ActuationModel):
    """Actions are angles, to which joints are held; rad."""

    actuation = Actuation.POSITION


class MuscleModel(ActuationModel):
    """Actions are activations of two muscles a motor, 0 to 1: all that pull one way, then all that pull the other."""

    actuation = Actuation.MUSCLE


MODELS = (SpringDamperModel, PositionalModel, MuscleModel)


def model_of(given: Any) -> Type[ActuationModel]:
    """The class that is meant: one of these, an object of one, or the name of a member of mimo.Actuation."""
    kind = given if isinstance(given, type) else type(given)
    if issubclass(kind, ActuationModel) and hasattr(kind, "actuation"):
        return kind
    if isinstance(given, (str, int)):
        number = whole_number("actuation_model", given, Actuation)
        return next((model for model in MODELS if model.actuation == number), _another(Actuation(number)))
    names = ", ".join(model.__name__ for model in MODELS)
    raise TypeError(f"actuation_model is {given!r}, expected {names}, or a member of mimo.Actuation")


def _another(actuation: Actuation) -> Type[ActuationModel]:
    """A class for what the original does not have, such as MuJoCo's own muscles."""
    return type("OtherModel", (ActuationModel,), {"actuation": actuation})
