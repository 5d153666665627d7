#!/usr/bin/env python3
"""Our tasks beside EnvPool's, Gymnasium's and MuJoCo's own batches, alone and within PPO (docs/benchmark.md).

    tests/bench/others.py [WORLDS [TURNS]]    16 worlds, 5 turns by default; some minutes

All take turns, with as many threads as there are cores; medians over turns. Steps are those of a world; physics steps
are the calls of mj_step, or what stands for it, that they consist of. Steps a second are those of the clock, and of the
processor's time on all threads, which other programs disturb less; threads that wait awake count there, too. PPO is
Stable-Baselines3's with its defaults (two layers of 64 units, parts of 64 steps, 10 passes), but for 2048 steps of all
worlds between updates.
Needs MuJoCo's Python package, EnvPool, Gymnasium with MuJoCo and Stable-Baselines3, and libmimo for the same MuJoCo:

    pip install envpool mujoco gymnasium stable-baselines3
    PYTHONPATH=bindings/python/src MIMO_LIBRARY=build-mujoco4/lib/libmimo-mujoco4.so tests/bench/others.py
"""
import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy and torch: products this small want one thread

import sys
import tempfile
import time

import envpool
import gymnasium
import mujoco
import mujoco.rollout
import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.vec_env import DummyVecEnv, VecEnv

import mimo
from mimo.sb3 import SB3VecEnv

THREADS = os.cpu_count() or 1
STEPS = 100  # of all worlds, a turn
ROLLOUT = 2048


class PoolVecEnv(VecEnv):
    """EnvPool for Stable-Baselines3. Worlds that ended are reset by the next step, whose reward does not count."""

    def __init__(self, name, worlds):
        self.pool = envpool.make(name, env_type="gymnasium", num_envs=worlds, num_threads=THREADS, seed=0)
        box = self.pool.observation_space
        spaces = gymnasium.spaces.Box(box.low, box.high, dtype=np.float64), self.pool.action_space
        super().__init__(worlds, *spaces)

    def reset(self):
        return self.pool.reset()[0]

    def step_async(self, actions):
        self.pool.send(actions.astype(np.float64))

    def step_wait(self):
        observation, reward, terminated, truncated, _ = self.pool.recv()
        done = terminated | truncated
        infos = [{} for _ in range(self.num_envs)]
        for index in np.flatnonzero(done):
            infos[index] = {"terminal_observation": observation[index],
                            "TimeLimit.truncated": bool(truncated[index] and not terminated[index])}
        return observation, reward, done, infos

    def close(self):
        self.pool.close()

    def get_attr(self, name, indices=None):
        return [None] * self.num_envs

    def set_attr(self, name, value, indices=None):
        raise NotImplementedError

    def env_method(self, name, *arguments, indices=None, **named):
        raise NotImplementedError

    def env_is_wrapped(self, wrapper, indices=None):
        return [False] * self.num_envs


def speed(steps, work):
    """How many steps a second of the clock and of the processor the work makes."""
    start = time.perf_counter(), time.process_time()
    work()
    return steps / (time.perf_counter() - start[0]), steps / (time.process_time() - start[1])


class Steps:
    """A VecEnv of Stable-Baselines3 in random play, and its training."""

    def __init__(self, env, degrees, physics_steps):
        self.env, self.degrees, self.physics_steps = env, degrees, physics_steps
        self.numbers = int(np.prod(env.observation_space.shape))
        self._random = np.random.default_rng(0)
        env.reset()
        self._model = PPO("MlpPolicy", env, n_steps=ROLLOUT // env.num_envs, device="cpu", seed=0)

    def play(self):
        space = self.env.action_space
        shape = (STEPS, self.env.num_envs, *space.shape)
        actions = self._random.uniform(space.low, space.high, shape).astype(np.float32)
        return speed(STEPS * self.env.num_envs, lambda: [self.env.step(action) for action in actions])

    def train(self):
        return speed(ROLLOUT, lambda: self._model.learn(ROLLOUT))


class Rollout:
    """mujoco.rollout: physics alone, all steps of a turn in one call."""

    def __init__(self, model, worlds, physics_steps, positions=None):
        self.degrees, self.physics_steps, self.numbers = model.nv, physics_steps, None
        self._model, self._rollout = model, mujoco.rollout.Rollout(nthread=THREADS)
        self._data = [mujoco.MjData(model) for _ in range(THREADS)]
        start = mujoco.MjData(model)
        start.qpos[:] = start.qpos if positions is None else positions
        state = np.zeros(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
        mujoco.mj_getState(model, start, state, mujoco.mjtState.mjSTATE_FULLPHYSICS)
        self._state = np.tile(state, (worlds, 1))
        self._random = np.random.default_rng(0)

    def play(self):
        (low, high), shape = self._model.actuator_ctrlrange.T, (len(self._state), STEPS, self._model.nu)
        controls = np.repeat(self._random.uniform(low, high, shape), self.physics_steps, axis=1)
        return speed(STEPS * len(self._state), lambda: self._step(controls))

    def _step(self, controls):
        states, _ = self._rollout.rollout(self._model, self._data, self._state, controls)
        self._state = states[:, -1].copy()


def ours(task, worlds):
    env = SB3VecEnv(task, worlds, flatten=True)
    side = Steps(env, saved(task).nv, env.envs.batch.world(0).frame_skip)
    positions = env.envs.batch.get(mimo.Quantity.JOINT_POSITION)[0]
    return side, Rollout(saved(task), worlds, side.physics_steps, positions)


def saved(scene):
    """MuJoCo's model of a scene, from the files that we write."""
    made = mimo.Scene(scene)
    made.add_agents()
    with tempfile.TemporaryDirectory() as folder:
        made.save(folder)
        return mujoco.MjModel.from_xml_path(os.path.join(folder, "scene.xml"))


def gymnasiums(name, worlds):
    env = DummyVecEnv([lambda: gymnasium.make(name)] * worlds)
    inner = env.envs[0].unwrapped
    return Steps(env, inner.model.nv, inner.frame_skip), inner.model


def sides(worlds):
    """Each by name."""
    reach, physics_of_reach = ours("reach", worlds)
    standup, physics_of_standup = ours("standup", worlds)
    humanoid, humanoids_model = gymnasiums("Humanoid-v5", worlds)
    ant, ants_model = gymnasiums("Ant-v5", worlds)
    return {
        "mimo reach": reach,
        "mimo standup": standup,
        "EnvPool Humanoid-v4": Steps(PoolVecEnv("Humanoid-v4", worlds), humanoid.degrees, humanoid.physics_steps),
        "EnvPool Ant-v4": Steps(PoolVecEnv("Ant-v4", worlds), ant.degrees, ant.physics_steps),
        "Gymnasium Humanoid-v5": humanoid,
        "Gymnasium Ant-v5": ant,
        "rollout of reach": physics_of_reach,
        "rollout of standup": physics_of_standup,
        "rollout of Humanoid": Rollout(humanoids_model, worlds, humanoid.physics_steps),
        "rollout of Ant": Rollout(ants_model, worlds, ant.physics_steps),
    }


def main(worlds=16, turns=5):
    torch.set_num_threads(1)
    measured = sides(worlds)
    played, trained = ({name: [] for name in measured} for _ in range(2))
    for turn in range(turns + 1):
        for name, side in measured.items():
            alone, learning = side.play(), side.train() if isinstance(side, Steps) else None
            if turn > 0:  # the first one warms up
                played[name].append(alone)
                trained[name] += [learning] if learning else []
    print(f"MuJoCo {mujoco.__version__} (ours {mimo.mujoco_version()}), EnvPool {envpool.__version__}, {worlds} worlds "
          f"on {THREADS} threads; steps of a world a second, of the clock and of the processor")
    print(f"{'':24} freedoms  numbers  physics steps     alone processor  within PPO processor")
    for name, side in measured.items():
        medians = [*np.median(played[name], axis=0), *(np.median(trained[name], axis=0) if trained[name] else ())]
        about = f"{name:24} {side.degrees:8} {side.numbers or '':>8} {side.physics_steps:14}"
        print(about, *(f"{each:10.0f}" for each in medians))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
