"""A thesis: touch that hurts and fades, set up in an environment of its own."""

import mimoEnv.utils as env_utils
import mujoco
import numpy as np
from mimoEnv.envs.dummy import MIMoDummyEnv
from mimoEnv.envs.mimo_env import DEFAULT_TOUCH_PARAMS
from mimoTouch.touch import TrimeshTouch


class Hurt(TrimeshTouch):
    VALID_TOUCH_TYPES = {"hurt": 1}  # noqa: RUF012

    def __init__(self, *args, threshold=2.0, decay=0.5, soft=(), **kwargs):
        self.before = None
        self.threshold, self.decay = threshold, decay
        self.soft_geoms = {}
        super().__init__(*args, **kwargs)
        for name in soft:
            for geom in env_utils.get_geoms_for_body(self.m_model, body_id=self.m_data.body(name).id):
                self.soft_geoms[geom] = 0.5

    def get_raw_force(self, contact_id, body_id):
        forces = np.zeros(6, dtype=np.float64)
        mujoco.mj_contactForce(self.m_model, self.m_data, contact_id, forces)
        contact = self.m_data.contact[contact_id]
        other = contact.geom1
        if contact.geom1 in env_utils.get_geoms_for_body(self.m_model, body_id=body_id):
            forces *= -1
            other = contact.geom2
        return forces[:3] * self.soft_geoms.get(other, 1.0)

    def hurt(self, contact_id, body_id):
        return np.linalg.norm(self.normal_force(contact_id, body_id)).reshape((1,))

    def get_touch_obs(self):
        felt = super().get_touch_obs()
        if self.before is None:
            self.before = np.zeros_like(felt)
        self.before = np.maximum(np.maximum(felt - self.threshold, 0), self.decay * self.before)
        return self.before


class HurtEnv(MIMoDummyEnv):
    def touch_setup(self, touch_params):
        params = dict(touch_params, touch_function="hurt", response_function="nearest")
        self.touch = Hurt(self, params, soft=["left_upper_arm", "right_upper_arm"])


env = HurtEnv(touch_params=DEFAULT_TOUCH_PARAMS, vision_params=None, vestibular_params=None)
obs, _ = env.reset(seed=1)
print("touch", obs["touch"].shape, env.observation_space["touch"].shape, env.touch.touch_size)
worst = 0.0
for _ in range(60):
    obs, *_ = env.step(np.zeros(env.action_space.shape))
    worst = max(worst, float(obs["touch"].max()))
names = sorted(env.model.body(body).name for body, felt in env.touch.sensor_outputs.items() if felt.any())
print("hurts", worst > 0, "felt", len(names) > 0)
