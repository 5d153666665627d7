"""Leg movements of an infant that babbles, as inertial sensors at the ankles see them.

    python kicks.py build/imu.so

A movement is a time in which the acceleration of an ankle is more than 1 m/s^2 off gravity's, and less for no longer
than 0.05 s in between. Studies with sensors at infants' ankles (PMC5565846) give, by age: 0.23 to 0.33 s a movement,
1.59 to 3.88 m/s^2 in the mean and 3.10 to 8.83 at the peak.
"""

import sys

import numpy as np

import mimo

RATE, THRESHOLD, PAUSE = 100, 1.0, 0.05


def movements(strength):
    """Start and end of each movement, in samples."""
    moving = strength > THRESHOLD
    found = []
    for sample in np.flatnonzero(moving):
        if found and sample - found[-1][1] <= PAUSE * RATE:
            found[-1][1] = int(sample) + 1
        else:
            found.append([int(sample), int(sample) + 1])
    return [(start, end) for start, end in found if end - start >= 3]


def main(library, seconds=120.0):
    """Prints how movements of both ankles last, and how strong they are."""
    scene = mimo.Scene("benchmark")
    scene.add_agents(vision=False, touch=False, age=6)
    scene.load_sense(library)
    world = mimo.World(scene)
    random = np.random.default_rng(1)
    world.reset(seed=1)
    action, target = np.zeros(len(world.layout.actions)), np.zeros(len(world.layout.actions))
    read = []
    for step in range(int(seconds * RATE)):
        if step % 50 == 0:  # new commands twice a second, half of the motors at rest, reached within 0.2 s
            target = random.uniform(-1, 1, action.size) * (random.random(action.size) < 0.5)
        action += (target - action) * 0.05
        read.append(world.step(action).observation["imu/acceleration"][:2, -1].copy())
    strength = np.abs(np.linalg.norm(read, axis=2) - 9.81)
    found = [(strength[start:end, leg]) for leg in range(2) for start, end in movements(strength[:, leg])]
    lengths = [len(one) / RATE for one in found]
    means, peaks = [one.mean() for one in found], [one.max() for one in found]
    print(f"{len(found)} movements in {seconds:g} s of two legs")
    for name, values, unit in (("length", lengths, "s"), ("mean", means, "m/s^2"), ("peak", peaks, "m/s^2")):
        low, middle, high = np.quantile(values, [0.25, 0.5, 0.75])
        print(f"{name}: {middle:.2f} {unit}, from {low:.2f} to {high:.2f}")


if __name__ == "__main__":
    main(sys.argv[1])
