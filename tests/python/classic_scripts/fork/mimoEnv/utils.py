import mujoco
import numpy as np

SIZES = {mujoco.mjtJoint.mjJNT_FREE: 7, mujoco.mjtJoint.mjJNT_HINGE: 1}


def get_body_id(*unused, **unknown):
    raise RuntimeError("the package's own function was meant to be taken")


def itch_at(env, body_id):
    return np.abs(env.touch.sensor_outputs[body_id]).sum()


def joints_of_motors(model):
    return {model.actuator(i).name: model.joint(model.actuator_trnid[i, 0]).name for i in range(model.nu)}
