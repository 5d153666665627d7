import os

import numpy as np

from mimoEnv.envs.mimo_env import SCENE_DIRECTORY, MIMoEnv


class BabyBenchEnv(MIMoEnv):
    def __init__(self, config, training=True):
        scene = os.path.join(SCENE_DIRECTORY, "babybench_base.xml")
        super().__init__(scene, frame_skip=1, goals_in_observation=False)
        self.config, self.training = config, training
        self.settle(config["settle"])

    def settle(self, count):
        self._set_action(np.zeros(self.action_space.shape))
        for _ in range(count):
            self._single_mujoco_step()
        self.init_qpos, self.init_qvel = self.data.qpos.copy(), self.data.qvel.copy()

    def reset_model(self):
        self.set_state(self.init_qpos, self.init_qvel)
        self.naps = 0
        return self._get_obs()


class BabyBenchNapEnv(BabyBenchEnv):
    def step(self, action):
        self.do_simulation(action, self.frame_skip)
        self.naps += int(np.abs(self.data.qvel).max() < 0.1)
        return self._get_obs(), 0, False, False, {"naps": self.naps, "touching": len(self.data.contact.geom1)}
