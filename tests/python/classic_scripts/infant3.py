"""For the package of version 3: ages, eyesight, foveae, delays."""

import gymnasium as gym
import mimo_infant
import mimo_infant.simulation
import numpy as np
from mimo_infant import MIMoRollOverEnv, mimo_utils
from mimo_infant.simulation.envs.mimo_env import DEFAULT_VISION_PARAMS

print("version", mimo_infant.__version__)
env = gym.make("MIMoRollOver-v0", age=7)
obs, info = env.reset(seed=0)
print("spaces", sorted(env.observation_space.spaces), "goal", info["desired_goal"], env.unwrapped.age)
obs, reward, *_ = env.step(np.zeros(env.action_space.shape))
print("on the back", bool(reward < 0.1))

late = MIMoRollOverEnv(sensory_delay=3, motor_delay=1)
first, _ = late.reset(seed=0)
seen = [late.step(late.action_space.sample())[0]["observation"] for _ in range(3)]
print(
    "late",
    np.array_equal(seen[0], first["observation"]),
    np.array_equal(seen[1], first["observation"]),
    np.array_equal(seen[2], first["observation"]),
)

eyes = {name: {**eye, "width": 48, "height": 48} for name, eye in DEFAULT_VISION_PARAMS.items()}
sharp = gym.make("MIMoBench-v0", touch_params=None, vision_params=eyes)
soft = {name: {**eye, "acuity": 2} for name, eye in eyes.items()}
blurred = gym.make("MIMoBench-v0", touch_params=None, vision_params=soft)
centred = gym.make(
    "MIMoBench-v0", touch_params=None, vision_params={"eye_left": {**eyes["eye_left"], "foveation": True}}
)
a, b, c = (it.reset(seed=0)[0]["eye_left"].astype(float) for it in (sharp, blurred, centred))
print("blurred", bool(np.abs(np.diff(b, axis=1)).max() < 0.5 * np.abs(np.diff(a, axis=1)).max()))
print("centre", np.abs(c[24, 24] - a[24, 24]).max() <= 2, "edge differs", bool(np.abs(c - a).max() > 10))
print("head", round(float(mimo_utils.get_body_position(env.unwrapped.data, "head")[2]), 2) < 0.2)
