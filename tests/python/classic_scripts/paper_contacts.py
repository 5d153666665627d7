"""In the manner of a paper's code: poses, locks, contacts and their forces by MuJoCo's functions."""

import gymnasium as gym
import mimoEnv  # noqa: F401
import mimoEnv.utils as env_utils
import mujoco
import numpy as np

env = gym.make("MIMoBench-v0", touch_params=None, vision_params=None)
env.reset(seed=0)
model, data = env.unwrapped.model, env.unwrapped.data
for joint, angle in {"robot:left_elbow": -1.2, "robot:right_elbow": -1.2, "robot:head_tilt": 0.3}.items():
    env_utils.set_joint_qpos(model, data, joint, angle)
    env_utils.lock_joint(model, joint, angle)
mujoco.mj_forward(model, data)
for _ in range(60):
    env.step(np.zeros(env.action_space.shape))

floor = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, "floor")
hip = env_utils.get_body_id(model, body_name="hip")
own = [g for b in env_utils.get_child_bodies(model, hip) for g in env_utils.get_geoms_for_body(model, b)]
push = np.zeros(3)
for i in range(data.ncon):
    contact = data.contact[i]
    if floor not in (contact.geom1, contact.geom2):
        continue
    other = contact.geom2 if contact.geom1 == floor else contact.geom1
    if other not in own:
        continue
    forces = np.zeros(6, dtype=np.float64)
    mujoco.mj_contactForce(model, data, i, forces)
    rotated = env_utils.rotate_vector_transpose(forces[:3], np.reshape(contact.frame, (3, 3)))
    push += rotated if contact.geom2 == other else -rotated
weight = 9.81 * sum(model.body_mass[b] for b in env_utils.get_child_bodies(model, hip))
names = {
    mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, int(model.geom_bodyid[g])) for g in np.unique(data.contact.geom1)
}
elbow = data.qpos[env_utils.get_joint_qpos_addr(model, model.joint("robot:left_elbow").id)]
print(f"push {push[2] / weight:.2f} weight {weight:.1f}")
print("elbow held", bool(abs(elbow[0] + 1.2) < 0.1), "bodies", "world" in names)
jacp, jacr = np.zeros((3, model.nv)), np.zeros((3, model.nv))
mujoco.mj_jacBody(model, data, jacp, jacr, hip)
root = model.joint("mimo_location").dofadr[0]
print("root moves hip", np.allclose(jacp[:, root : root + 3], np.eye(3)))
