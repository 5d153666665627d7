"""An actuation model of the script's own: torques that low-pass the actions, updated in each physics step."""

import numpy as np
from gymnasium import spaces
from mimoActuation.actuation import ActuationModel
from mimoEnv.envs.dummy import MIMoDummyEnv


class Filtered(ActuationModel):
    def __init__(self, env, actuators):
        super().__init__(env, actuators)
        self.goal = self.level = np.zeros(len(actuators))
        self.updates = 0

    def get_action_space(self):
        return spaces.Box(-1.0, 1.0, shape=(self.n_actuators,), dtype=np.float32)

    def action(self, action):
        self.goal = np.clip(action, -1, 1)

    def substep_update(self):
        self.updates += 1
        self.level = self.level + 0.25 * (self.goal - self.level)
        self.env.data.ctrl[self.actuators] = self.level

    def observations(self):
        return self.level.flatten()

    def cost(self):
        return float(np.square(self.level).mean())

    def reset(self):
        self.level = np.zeros(len(self.actuators))


class Counting(MIMoDummyEnv):
    substeps = 0

    def _substep_callback(self):
        self.substeps += 1


env = Counting(actuation_model=Filtered, touch_params=None, vision_params=None, frame_skip=3)
obs, _ = env.reset(seed=1)
print("observation", obs["observation"].shape[0])
for _ in range(4):
    obs, *_ = env.step(np.full(env.action_space.shape, 0.5))
print("level", round(float(obs["observation"][0]), 4), "cost", round(env.actuation_model.cost(), 4))
print("updates", env.actuation_model.updates, "substeps", env.substeps, "time", round(env.data.time, 3))
print("control", round(float(env.data.ctrl[0]), 4))
