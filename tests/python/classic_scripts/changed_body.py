"""Changes masses, frictions, strengths and gravity by name and in place, and reads them back."""

import gymnasium as gym
import mimoEnv  # noqa: F401
import numpy as np

env = gym.make("MIMoBench-v0", touch_params=None, vision_params=None).unwrapped
env.reset(seed=0)
model, data = env.model, env.data
before = model.body_subtreemass[model.body("hip").id].copy()
model.body("hip").mass = 5
model.body("head").mass[:] *= 2
model.geom("floor").friction = [0.2, 0.01, 0.001]
model.geom_friction[3:6, 0] = 0.3
model.actuator_gear[env.mimo_actuators, 0] *= 0.5
model.dof_damping[model.joint("robot:left_elbow").dofadr] = 0.25
model.opt.gravity[2] = -1.62
data.joint("robot:left_elbow").qpos = -1.0
data.joint("robot:left_elbow").qvel[0] = 0.5
data.qpos[model.joint("robot:right_elbow").qposadr] = -0.7
data.actuator("act:left_elbow").ctrl = 0.3
data.xfrc_applied[model.body("head").id, 2] = 2.0
env.init_qpos[:] = data.qpos
world = env.world
print("mass", world.bodies("hip").mass[0], round(float(model.body_subtreemass[model.body("hip").id] - before), 3))
print("friction", world.geoms("floor").friction.ravel().tolist(), model.geom_friction[4, 0])
print(
    "elbow",
    world.joints("robot:left_elbow").position[0],
    world.joints("robot:left_elbow").velocity[0],
    world.joints("robot:right_elbow").position[0],
    world.joints("robot:left_elbow").damping[0],
)
print("control", world.actuators("act:left_elbow").control[0], "gravity", world.gravity.tolist())
print("force", world.bodies("head").force.ravel()[2])
kept = data.qpos
old = kept.copy()
env.step(np.zeros(env.action_space.shape))
print("kept arrays follow", bool((kept != old).any()), np.array_equal(kept, data.qpos))
