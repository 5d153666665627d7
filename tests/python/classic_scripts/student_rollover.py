"""A student's own environment: turns over on a scene beside the script; writes to MuJoCo's arrays in place."""

import os

import mujoco
import numpy as np
from mimoActuation.actuation import SpringDamperModel
from mimoEnv.envs.mimo_env import DEFAULT_PROPRIOCEPTION_PARAMS, DEFAULT_VESTIBULAR_PARAMS, MIMoEnv

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "scenes", "mat.xml")


class TurnEnv(MIMoEnv):
    def __init__(self, model_path=SCENE, frame_skip=2, age=None, **kwargs):
        super().__init__(
            model_path=model_path,
            frame_skip=frame_skip,
            age=age,
            proprio_params=DEFAULT_PROPRIOCEPTION_PARAMS,
            vestibular_params=DEFAULT_VESTIBULAR_PARAMS,
            actuation_model=SpringDamperModel,
            goals_in_observation=True,
            done_active=True,
            show_sensors=False,
            print_space_sizes=False,
            **kwargs,
        )
        self.init_position = self.data.qpos.copy()
        self.lie_down()

    def lie_down(self):
        free = self.model.joint("mimo_location").id
        adr = int(self.model.jnt_qposadr[free])
        quat = np.zeros(4)
        mujoco.mju_euler2Quat(quat, np.array([0, -np.pi / 2, 0]), "xyz")
        qpos = self.init_position.copy()
        qpos[adr : adr + 3] = 0, 0, 0.2
        qpos[adr + 3 : adr + 7] = quat
        self.data.qpos = qpos
        mujoco.mj_forward(self.model, self.data)
        lowest = min(self.data.geom(i).xpos[2] - self.model.geom_rbound[i] for i in self.own_geoms())
        self.data.qpos[adr + 2] -= lowest - 0.01
        self.set_state(self.data.qpos, np.zeros(self.data.qvel.shape))
        self._set_action(np.zeros(self.action_space.shape))
        mujoco.mj_step(self.model, self.data, nstep=100)
        self.lain = self.data.qpos.copy()

    def own_geoms(self):
        return [i for i in range(self.model.ngeom) if self.model.body(self.model.geom(i).bodyid).name != "world"]

    def is_success(self, achieved_goal, desired_goal):
        return bool(achieved_goal >= desired_goal)

    def is_failure(self, achieved_goal, desired_goal):
        return False

    def is_truncated(self):
        return False

    def sample_goal(self):
        return 0.95

    def get_achieved_goal(self):
        xmat = self.data.body("hip").xmat.reshape(3, 3)
        return (1 - xmat[2, 0]) / 2

    def compute_reward(self, achieved_goal, desired_goal, info):
        return achieved_goal - 0.01 * np.square(self.data.ctrl).sum()

    def reset_model(self):
        qpos = self.lain.copy()
        qpos[7:] += self.np_random.uniform(low=-0.01, high=0.01, size=len(qpos[7:]))
        self.set_state(qpos, np.zeros(self.data.qvel.shape))
        self.model.opt.gravity[2] = 0
        mujoco.mj_step(self.model, self.data, nstep=5)
        self.model.opt.gravity[2] = -9.81
        return self._get_obs()


env = TurnEnv()
obs, _ = env.reset(seed=2)
print("goal", obs["desired_goal"], "height", round(float(env.data.body("hip").xpos[2]), 3))
total = 0
for _ in range(20):
    obs, reward, terminated, truncated, info = env.step(env.action_space.sample() * 0.1)
    total += reward
print(
    "rewards",
    np.isfinite(total),
    "achieved below",
    bool(obs["achieved_goal"] < 0.2),
    "gravity",
    env.model.opt.gravity[2],
)
