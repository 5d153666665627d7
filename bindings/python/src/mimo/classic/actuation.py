"""The original's actuation models by name; the argument of an environment selects one."""

from __future__ import annotations

from typing import Any, Type

from ..arguments import whole_number
from ..constants import Actuation


class ActuationModel:
    """Base of actuation models. The classes are only names; the library does the work."""

    actuation: Actuation


class SpringDamperModel(ActuationModel):
    """Actions are shares of the motors' largest torques; joints have springs and dampers."""

    actuation = Actuation.TORQUE


class PositionalModel(ActuationModel):
    """Actions are target angles of joints, rad."""

    actuation = Actuation.POSITION


class MuscleModel(ActuationModel):
    """Actions are activations of two muscles per motor, 0 to 1: first all of one direction, then all of the other."""

    actuation = Actuation.MUSCLE


MODELS = (SpringDamperModel, PositionalModel, MuscleModel)


def model_of(given: Any) -> Type[ActuationModel]:
    """The class of an argument: one of these, an instance, or the name of a member of mimo.Actuation."""
    kind = given if isinstance(given, type) else type(given)
    if issubclass(kind, ActuationModel) and hasattr(kind, "actuation"):
        return kind
    if isinstance(given, (str, int)):
        number = whole_number("actuation_model", given, Actuation)
        return next((model for model in MODELS if model.actuation == number), _another(Actuation(number)))
    names = ", ".join(model.__name__ for model in MODELS)
    raise TypeError(f"actuation_model is {given!r}, expected {names}, or a member of mimo.Actuation")


def _another(actuation: Actuation) -> Type[ActuationModel]:
    """A class for a model that the original does not have, such as MuJoCo's muscles."""
    return type("OtherModel", (ActuationModel,), {"actuation": actuation})
