"""Strokes a forearm with a brush, at five speeds and three temperatures, and draws how C-tactile afferents fire.

    python stroke.py build/ct.so stroke.png

Needs matplotlib. ct.cpp says where the shape of the curve comes from.
"""

import sys

import matplotlib
import numpy as np

import mimo

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOREARM = """<mujoco><option timestep="0.002"/><worldbody>
<body name="left_lower_arm"><geom type="box" size="0.6 0.03 0.03"/></body>
<body name="brush" pos="-0.5 0 0.0495"><joint name="along" type="slide" axis="1 0 0"/>
<joint name="down" type="slide" axis="0 0 1"/><geom type="sphere" size="0.02" mass="0.05" friction="0.01 0 0"/></body>
</worldbody></mujoco>"""
SPEEDS = [0.003, 0.01, 0.03, 0.1, 0.3]  # m/s, those of Fairhurst et al. 2014 among them


def rate(library, speed, celsius, seconds):
    """The highest rate of the last tenth of a second, Hz."""
    scene = mimo.Scene(xml=FOREARM)
    senses = {"touch": ["slip", "temperature"], "touch_slip_threshold": 0.001}
    scene.add_agent(
        body="scene", root="left_lower_arm", acts="none", vision=False, vestibular=0, proprioception=0, **senses
    )
    scene.set_touch(None, 0.01)
    scene.set_temperature("brush", celsius)
    scene.load_sense(library)
    world = mimo.World(scene, frame_skip=5)
    world.reset(seed=1)
    rates = []
    for _ in range(int(seconds / 0.01)):
        world.set("joint_velocity", [speed], ["along"])
        rates.append(world.step().observation["ct"].max())
    return float(np.max(rates[-10:]))


def main(library, picture):
    """Prints the rates and draws them."""
    by_speed = [rate(library, speed, 32, 1) for speed in SPEEDS]
    by_warmth = {celsius: rate(library, 0.01, celsius, 3) for celsius in (18, 32, 42)}
    for speed, one in zip(SPEEDS, by_speed):
        print(f"{100 * speed:4.1f} cm/s: {one:4.1f} Hz")
    for celsius, one in by_warmth.items():
        print(f"{celsius} degrees, 1 cm/s: {one:4.1f} Hz")
    figure, axes = plt.subplots(figsize=(5, 3.2))
    axes.axvspan(1, 10, color="0.92", label="top in the literature")
    axes.semilogx(100 * np.array(SPEEDS), by_speed, "o-", color="C3", label="ct")
    axes.set(xlabel="speed of the stroke, cm/s", ylabel="Hz", ylim=(0, None))
    axes.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main(*sys.argv[1:3])
