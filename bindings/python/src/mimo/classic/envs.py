"""The original's environments, with its defaults."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ..constants import Kind, Quantity
from .actuation import MuscleModel
from .env import MIMoEnv, Numbers
from .params import (
    DEFAULT_PROPRIOCEPTION_PARAMS,
    DEFAULT_TOUCH_PARAMS,
    DEFAULT_TOUCH_PARAMS_V2,
    DEFAULT_VESTIBULAR_PARAMS,
    DEFAULT_VISION_PARAMS,
)

# The original's files of scenes: names of built-in scenes; the second is the first with five fingers.
BENCHMARK_XML, BENCHMARK_XML_V2 = "benchmark", "benchmarkv2_scene.xml"
REACH_XML, STANDUP_XML, SELFBODY_XML, CATCH_XML = "reach", "standup", "selfbody", "catch"
SHOWROOM_XML = DEMO_XML = "showroom"
ROLL_OVER_XML = "rollover"

SELF_BODY_SCALES = {
    **dict.fromkeys(("hip", "lower_body", "upper_body", "head"), 0.1),
    "right_fingers": 0.01,
    **dict.fromkeys(("left_upper_arm", "left_lower_arm"), 0.01),
    **{f"{side}_{part}": 0.1 for side in ("left", "right") for part in ("upper_leg", "lower_leg")},
    **dict.fromkeys(("left_foot", "right_foot"), 0.05),
}
_RIGHT_ARM = ("right_upper_arm", "right_lower_arm", "right_hand", "right_ff", "right_mf", "right_rf", "right_lf")
CATCH_SCALES = {
    body: metres
    for body, metres in DEFAULT_TOUCH_PARAMS_V2["scales"].items()
    if body.startswith((*_RIGHT_ARM, "right_th"))
}


class MIMoReachEnv(MIMoEnv):
    """Standing before a floating ball, which the right hand should touch."""

    def __init__(self, model_path: Any = REACH_XML, **arguments: Any) -> None:
        standard = {"goals_in_observation": False, "done_active": True}
        super().__init__(model_path, **{**standard, **arguments})

    def compute_reward(self, achieved_goal: Any, desired_goal: Any, info: Any) -> Any:
        """Minus the distance (m); 100 for success. One goal, or rows of them with as many infos (HER)."""
        distance = np.linalg.norm(np.asarray(achieved_goal) - np.asarray(desired_goal), axis=-1)
        success = _flags(info, np.shape(distance))
        prize = self.scene.parameters["reach/success_reward"] * success
        subtracted = distance if self.scene.parameters["reach/original_rules"] else np.where(success, 0, distance)
        return prize - subtracted


class MIMoStandupEnv(MIMoEnv):
    """Squatting in a crib, hands on the rail; the head should rise as high as possible."""

    def __init__(self, model_path: Any = STANDUP_XML, **arguments: Any) -> None:
        standard = {"vestibular_params": DEFAULT_VESTIBULAR_PARAMS, "goals_in_observation": False}
        super().__init__(model_path, **{**standard, **arguments})


class MIMoRollOverEnv(MIMoEnv):
    """Lying on the back; the hip should turn over: 0 at the start, 1 on the belly, success at 0.8."""

    def __init__(self, model_path: Any = ROLL_OVER_XML, **arguments: Any) -> None:
        standard = {
            "proprio_params": DEFAULT_PROPRIOCEPTION_PARAMS,
            "vestibular_params": DEFAULT_VESTIBULAR_PARAMS,
            "goals_in_observation": False,
        }
        super().__init__(model_path, **{**standard, **arguments})

    def sample_goal(self) -> float:
        """The turn of the hip that counts as success."""
        return float(super().sample_goal()[0])

    def get_achieved_goal(self) -> float:
        """The turn of the hip."""
        return float(super().get_achieved_goal()[0])


class MIMoSelfBodyEnv(MIMoEnv):
    """Sitting; the right hand should touch the part of the body named `target_body`.

    desired_goal has 1 at the body's number; it is as long as the original's, which has one number per geom.
    achieved_goal is all 0, as in the original.
    """

    def __init__(self, model_path: Any = SELFBODY_XML, **arguments: Any) -> None:
        scales = {"scales": SELF_BODY_SCALES}
        standard = {"touch_params": scales, "frame_skip": 1, "goals_in_observation": True, "done_active": True}
        super().__init__(model_path, **{**standard, **arguments})

    @property
    def target_body(self) -> str:
        """Name of the target body."""
        return self.world.name(Kind.BODY, int(self.world.get(Quantity.AGENT_GOAL).flat[0]))

    def sample_goal(self) -> Numbers:
        """1 at the number of the target body."""
        goal = np.zeros(self.world.count(Kind.GEOM))
        goal[int(self.world.get(Quantity.AGENT_GOAL).flat[0])] = 1
        return goal

    def get_achieved_goal(self) -> Numbers:
        """All 0."""
        return np.zeros(self.world.count(Kind.GEOM))


class MIMoCatchEnv(MIMoEnv):
    """A ball falls into the right hand. Its radius (m) is the last number of `observation`."""

    torque_sensors = tuple(
        f"proprio:right_{joint}"
        for joint in (
            *("shoulder", "elbow", "wrist"),
            *(f"{finger}_{bone}" for finger in ("ff", "mf", "rf") for bone in ("knuckle", "middle", "distal")),
            *("lf_meta", "lf_knuckle", "lf_middle", "lf_distal"),
            *("th_base", "th_hub", "th_distal"),
        )
    )
    extra_fields = ("task/ball_radius",)

    def __init__(
        self,
        model_path: Any = CATCH_XML,
        jitter: bool = False,
        position_inaccurate: bool = False,
        action_penalty: bool = True,
        parameters: Optional[Any] = None,
        **arguments: Any,
    ) -> None:
        chosen = {
            "catch/jitter": 0.2 if jitter else 0.0,
            "catch/gaze_error": 0.005 if position_inaccurate else 0.0,
            **({} if action_penalty else {"catch/effort_weight": 0.0}),
            **(parameters or {}),
        }
        standard = {
            "touch_params": {"scales": CATCH_SCALES},
            "actuation_model": MuscleModel,
            "goals_in_observation": False,
            "done_active": True,
        }
        super().__init__(model_path, parameters=chosen, **{**standard, **arguments})


class MIMoDummyEnv(MIMoEnv):
    """All senses and no task: rewards are 0."""

    def __init__(self, model_path: Any = BENCHMARK_XML, **arguments: Any) -> None:
        standard = {
            "proprio_params": DEFAULT_PROPRIOCEPTION_PARAMS,
            "touch_params": DEFAULT_TOUCH_PARAMS,
            "vision_params": DEFAULT_VISION_PARAMS,
            "vestibular_params": DEFAULT_VESTIBULAR_PARAMS,
            "goals_in_observation": False,
        }
        super().__init__(model_path, **{**standard, **arguments})


class MIMoV2DummyEnv(MIMoDummyEnv):
    """The same with five fingers."""

    def __init__(self, model_path: Any = BENCHMARK_XML, **arguments: Any) -> None:
        standard = {"touch_params": DEFAULT_TOUCH_PARAMS_V2, "body": "fingers"}
        super().__init__(model_path, **{**standard, **arguments})


class MIMoShowroomEnv(MIMoV2DummyEnv):
    """A nursery with toys."""

    def __init__(self, model_path: Any = SHOWROOM_XML, **arguments: Any) -> None:
        super().__init__(model_path, **arguments)


class MIMoMuscleDummyEnv(MIMoV2DummyEnv):
    """Five fingers and muscles."""

    def __init__(self, model_path: Any = BENCHMARK_XML, **arguments: Any) -> None:
        super().__init__(model_path, **{"actuation_model": MuscleModel, **arguments})


def _flags(info: Any, shape: Any) -> Any:
    """Success, of one info or of as many as there are goals."""
    if isinstance(info, dict):
        return np.broadcast_to(bool(info.get("is_success", False)), shape)
    return np.array([bool(one.get("is_success", False)) for one in info]).reshape(shape)
