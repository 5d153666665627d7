#!/usr/bin/env python3
"""Many worlds at once, beside MuJoCo's own batched rollout (docs/benchmark.md).

    tests/bench/rollout.py [WORLDS [TURNS]]    64 worlds, 7 turns by default; a minute or two

All take turns in one process, with the same random controls; a step is two physics steps (10 ms). Medians over turns, in
steps of a world a second. Needs MuJoCo's Python package, and libmimo for the same version of it:

    PYTHONPATH=bindings/python/src MIMO_LIBRARY=build-mujoco4/lib/libmimo-mujoco4.so tests/bench/rollout.py
"""
import os
import statistics
import sys
import tempfile
import time

import mujoco
import mujoco.rollout
import numpy as np

import mimo

SCENE = "benchmark"
STEPS = 25  # of each world, a turn
SKIP = 2
THREADS = os.cpu_count() or 1


class Controls:
    """Random ones for all steps of a turn, the same for all who are measured in it."""

    def __init__(self, worlds, count, low, high):
        self._random = np.random.default_rng(0)
        self._shape = (STEPS, worlds, count)
        self._bounds = low, high

    def next(self):
        return self._random.uniform(*self._bounds, size=self._shape)


class Rollout:
    """mujoco.rollout: physics alone, all steps in one call."""

    def __init__(self, model, worlds, threads):
        self._model = model
        self._rollout = mujoco.rollout.Rollout(nthread=threads)
        self._data = [mujoco.MjData(model) for _ in range(threads)]
        start = mujoco.MjData(model)
        state = np.zeros(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
        mujoco.mj_getState(model, start, state, mujoco.mjtState.mjSTATE_FULLPHYSICS)
        self._state = np.tile(state, (worlds, 1))

    def __call__(self, controls):
        wanted = np.repeat(controls.transpose(1, 0, 2), SKIP, axis=1)
        states, _ = self._rollout.rollout(self._model, self._data, self._state, wanted, skip_checks=False)
        self._state = states[:, -1].copy()


class Loop:
    """mj_step of one world after the other from Python, as loops around the original do, without any sense."""

    def __init__(self, model, worlds):
        self._model = model
        self._data = [mujoco.MjData(model) for _ in range(worlds)]

    def __call__(self, controls):
        for step in controls:
            for data, control in zip(self._data, step):
                data.ctrl[:] = control
                mujoco.mj_step(self._model, data, nstep=SKIP)


class Ours:
    """A batch, with all senses but the eyes, or with these as well; each step a call."""

    def __init__(self, worlds, threads, **senses):
        self._batch = mimo.Batch(SCENE, worlds, threads=threads, **senses)
        self._batch.reset(0)

    def __call__(self, controls):
        for step in controls:
            self._batch.step(step.astype(np.float32))


class Sent:
    """Two batches of half the worlds and threads, each under way while Python has the other, as loops around EnvPool do."""

    def __init__(self, worlds, threads):
        self._halves = [mimo.Batch(SCENE, worlds // 2, threads=threads // 2, vision=0) for _ in range(2)]
        for half in self._halves:
            half.reset(0)

    def __call__(self, controls):
        for number, step in enumerate(controls.astype(np.float32)):
            for half, actions in zip(self._halves, np.array_split(step, 2)):
                if number > 0:
                    half.receive()
                half.send(actions)
        for half in self._halves:
            half.receive()


def load():
    """MuJoCo's model of the scene, from the files that we write."""
    scene = mimo.Scene(SCENE)
    scene.add_agents()
    with tempfile.TemporaryDirectory() as folder:
        scene.save(folder)
        return mujoco.MjModel.from_xml_path(os.path.join(folder, "scene.xml"))


def main(worlds=64, turns=7):
    model = load()
    controls = Controls(worlds, model.nu, model.actuator_ctrlrange[:, 0], model.actuator_ctrlrange[:, 1])
    sides = {
        "a loop of mj_step": Loop(model, worlds),
        "mujoco.rollout, 1 thread": Rollout(model, worlds, 1),
        f"mujoco.rollout, {THREADS} threads": Rollout(model, worlds, THREADS),
        "ours without eyes, 1 thread": Ours(worlds, 1, vision=0),
        f"ours without eyes, {THREADS} threads": Ours(worlds, THREADS, vision=0),
        f"the same, sent and received, {THREADS} threads": Sent(worlds, THREADS),
        f"ours at V64, {THREADS} threads": Ours(worlds, THREADS, vision_width=64, vision_height=64),
    }
    speed = {name: [] for name in sides}
    for _ in range(turns):
        wanted = controls.next()
        for name, side in sides.items():
            start = time.perf_counter()
            side(wanted)
            speed[name].append(STEPS * worlds / (time.perf_counter() - start))
    print(f"MuJoCo {mujoco.__version__}, {SCENE}, {worlds} worlds, steps of 10 ms a second")
    for name, values in speed.items():
        print(f"{name:44} {statistics.median(values):8.0f}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
