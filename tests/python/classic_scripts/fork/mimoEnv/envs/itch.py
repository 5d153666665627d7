import os

import numpy as np

import mimoEnv.utils as env_utils
from mimoEnv.envs.mimo_env import SCENE_DIRECTORY, MIMoEnv

ITCH_XML = os.path.join(SCENE_DIRECTORY, "itch_scene.xml")


class MIMoItchEnv(MIMoEnv):
    def __init__(self, model_path=ITCH_XML, **kwargs):
        super().__init__(
            model_path,
            initial_qpos={"robot:left_elbow": -2.5312, "mimo_location": [0, 0, 0.5, 1, 0, 0, 0]},
            touch_params={"scales": {"right_hand": 0.01, "left_lower_arm": 0.02}},
            goals_in_observation=False,
            **kwargs,
        )

    def sample_goal(self):
        return self.np_random.choice(list(self.touch.sensor_positions))

    def get_achieved_goal(self):
        return env_utils.itch_at(self, self.goal)

    def is_success(self, achieved_goal, desired_goal):
        return achieved_goal > 0

    def is_failure(self, achieved_goal, desired_goal):
        return False

    def is_truncated(self):
        return False

    def compute_reward(self, achieved_goal, desired_goal, info):
        return float(achieved_goal > 0) - 0.1 * np.square(self.data.ctrl).mean()

    def reset_model(self):
        self.set_state(self.init_qpos, self.init_qvel)
        return self._get_obs()
