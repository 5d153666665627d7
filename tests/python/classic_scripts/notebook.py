"""As in a notebook: installs first, imports later. Not run with python -m mimo.classic."""

import mimo.classic.install  # noqa: F401, I001
from mimoEnv.envs.reach import MIMoReachEnv
from mimoVision.vision import SimpleVision
import mujoco

env = MIMoReachEnv(vision_params={"eye_left": {"width": 16, "height": 12}})
env.reset(seed=1)
with mujoco.Renderer(env.model, height=30, width=40) as renderer:
    renderer.update_scene(env.data, camera="eye_left")
    picture = renderer.render()
print(isinstance(env.vision, SimpleVision), env.vision.get_vision_obs()["eye_left"].shape, picture.shape)
print(env.proprioception.get_proprioception_obs().shape, sorted(env.proprioception.sensor_outputs))
