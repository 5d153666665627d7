"""Leg movements of an infant that babbles, as inertial sensors at its ankles see them, beside those of infants.

    python kicks.py build/imu.so

Trujillo-Priego and Smith 2017 (PMC5565846) give length, mean and peak of movements of 12 infants of 1 to 12 months over
whole days, by the rule of Smith et al. 2015 (doi:10.3390/s150819006), which `movements` follows:

- Sensors keep 20 samples a second. From the length of each acceleration vector the median of all lengths is taken, which
  removes gravity. The same is done for the angular velocity.
- A movement is one cycle: the acceleration leaves rest in one direction and within 0.4 s in the other one, each time
  beyond a threshold and while the leg turns. It lasts from the crossing of zero before to the one behind. So each pause
  and each change of direction begins a new movement.
- A threshold is the mean of all peaks from 1 to 3.25 m/s^2 less their standard deviation, for each direction.
"""

import sys

import numpy as np

import mimo

RATE, KEPT = 100, 20  # samples a second, of which the study keeps so many
APART = 8  # samples between the two directions at most
LEAST, MOST = 1.0, 3.25  # m/s^2, of the peaks that give the threshold
LEGS = ("left", "right")
STUDY = {"length, s": (0.23, 0.33), "mean, m/s^2": (1.59, 3.88), "peak, m/s^2": (3.10, 8.83)}


def babble(library, seconds, age=6):
    """Acceleration, angular velocity (steps x legs x 3), and whether a leg touches something (steps x legs)."""
    scene = mimo.Scene("benchmark")
    scene.add_agents(vision=False, touch=["force"], age=age)
    scene.load_sense(library)
    world = mimo.World(scene)
    skin = world.layout.receptors("touch/force").bodies
    parts = ("lower_leg", "foot", "toes")
    of_leg = [np.isin(skin, [world.find("body", f"{leg}_{part}") for part in parts]) for leg in LEGS]
    random = np.random.default_rng(1)
    world.reset(seed=1)
    action, target = np.zeros(len(world.layout.actions)), np.zeros(len(world.layout.actions))
    accelerations, turns, touches = [], [], []
    for step in range(int(seconds * RATE)):
        if step % 50 == 0:  # new commands twice a second, half of the motors at rest, reached within 0.2 s
            target = random.uniform(-1, 1, action.size) * (random.random(action.size) < 0.5)
        action += (target - action) * 0.05
        sensed = world.step(action).observation
        accelerations.append(sensed["imu/acceleration"][: len(LEGS), -1].copy())
        turns.append(sensed["imu/angular_velocity"][: len(LEGS), -1].copy())
        touches.append([sensed["touch/force"][its].any() for its in of_leg])
    return np.array(accelerations), np.array(turns), np.array(touches)


def kept(samples):
    """20 a second: the mean of those in between, in place of the filter that sensors have."""
    return samples.reshape(-1, RATE // KEPT, *samples.shape[1:]).mean(axis=1)


def off_rest(vectors):
    """How much longer than usual the vectors are."""
    lengths = np.linalg.norm(vectors, axis=-1)
    return lengths - np.median(lengths)


def threshold(strength):
    """The threshold for positive values."""
    inner = np.where((strength > 0) & (strength < MOST), strength, 0)
    tops = (inner[1:-1] >= LEAST) & (inner[1:-1] > inner[:-2]) & (inner[1:-1] >= inner[2:])
    peaks = inner[1:-1][tops]
    return peaks.mean() - peaks.std() if peaks.size else np.inf


def movements(strength, turn):
    """First and last sample of each movement of a leg, from how far acceleration and angular velocity are off rest."""
    beyond = np.where(strength > threshold(strength), 1, np.where(strength < -threshold(-strength), -1, 0)) * (turn > 0)
    swings = []  # first and last sample, and direction
    for at in np.flatnonzero(beyond):
        if swings and swings[-1][1] == at - 1 and swings[-1][2] == beyond[at]:
            swings[-1][1] = at
        else:
            swings.append([at, at, beyond[at]])
    found = []
    for (start, last, way), (back, end, other) in zip(swings, swings[1:]):
        if other == way or back - last > APART:
            continue
        while start > 0 and np.sign(strength[start - 1]) == way:
            start -= 1
        while end + 1 < len(strength) and np.sign(strength[end]) == other:
            end += 1
        if not found or start >= found[-1][1]:
            found.append((int(start), int(end)))
    return found


def measured(library, seconds=120.0):
    """Length, mean and peak of each movement of both legs, and whether the leg touched something meanwhile."""
    acceleration, turn, touches = babble(library, seconds)
    acceleration, turn, touches = kept(acceleration), kept(turn), kept(touches) > 0
    rows = []
    for leg in range(len(LEGS)):
        strength = off_rest(acceleration[:, leg])
        for start, end in movements(strength, off_rest(turn[:, leg])):
            of_it = np.abs(strength[start : end + 1])
            touched = touches[max(start - 1, 0) : end + 2, leg].any()
            rows.append(((end - start) / KEPT, of_it.mean(), of_it.max(), touched))
    return np.array(rows)


def main(library):
    """Prints both side by side."""
    rows = measured(library)
    print(
        f"{len(rows)} movements of two legs in 120 s, {rows[:, 3].mean():.0%} of them with the leg touching something"
    )
    print(f"{'of a movement':16}{'study':>14}{'here, mean':>12}{'median':>8}{'touching':>10}{'free':>8}")
    for column, (name, (low, high)) in enumerate(STUDY.items()):
        values, touched = rows[:, column], rows[:, 3] > 0
        here = (values.mean(), np.median(values), values[touched].mean(), values[~touched].mean())
        print(
            f"{name:16}{low:>6} to {high:<4}"
            + "".join(f"{value:{width}.2f}" for value, width in zip(here, (12, 8, 10, 8)))
        )


if __name__ == "__main__":
    main(sys.argv[1])
