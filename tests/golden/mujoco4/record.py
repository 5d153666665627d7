"""Records trajectories and motors' responses with MuJoCo 4.0.1 alone: record.py SCENE.xml VERSION FOLDER

SCENE.xml is what mimo_scene_save writes for scene "benchmark" with a mitten-handed (VERSION v1) or a five-fingered
infant (v2); FOLDER has what was recorded with MuJoCo 2.2.2, of which the controls and the names of motors are taken,
and gets the recordings in its folder mujoco4. Needs the packages mujoco-core and numpy.
"""

import csv
import json
import sys
from pathlib import Path

import mujoco
import numpy as np


def key(model, joint):
    body = model.body(model.joint(joint).bodyid[0]).name
    return model.joint(joint).name or f"free:{body}"


def by_joint(model, values, addresses, widths):
    return {
        key(model, joint): [float(x) for x in values[addresses[joint] :][: widths[model.jnt_type[joint]]]]
        for joint in range(model.njnt)
    }


FREE, SLIDE, HINGE = (
    int(x) for x in (mujoco.mjtJoint.mjJNT_FREE, mujoco.mjtJoint.mjJNT_SLIDE, mujoco.mjtJoint.mjJNT_HINGE)
)


def positions(model, data):
    return by_joint(model, data.qpos, model.jnt_qposadr, {FREE: 7, SLIDE: 1, HINGE: 1})


def velocities(model, data):
    return by_joint(model, data.qvel, model.jnt_dofadr, {FREE: 6, SLIDE: 1, HINGE: 1})


def model_of(path, floating, jacobian=mujoco.mjtJacobian.mjJAC_DENSE):
    model = mujoco.MjModel.from_xml_path(path)
    model.opt.jacobian = jacobian
    if floating:
        model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)
    return model


def trajectory(model, controls, steps=200, every=20):
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    states = []
    for step in range(steps + 1):
        if step % every == 0:
            state = {
                "step": step,
                "qpos": positions(model, data),
                "qvel": velocities(model, data),
                "ncon": int(data.ncon),
            }
            states.append(state)
        if controls is not None and step < steps:
            data.ctrl[:] = controls[step]
        mujoco.mj_step(model, data)
    return states


def response(model, motor, control):
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    data.ctrl[motor] = control
    for _ in range(10):
        mujoco.mj_step(model, data)
    joint = model.actuator_trnid[motor][0]
    position, dof = model.jnt_qposadr[joint], model.jnt_dofadr[joint]
    return {
        "joint": model.joint(joint).name,
        "qvel": float(data.qvel[dof]),
        "qpos": float(data.qpos[position]),
        "torque": float(data.qfrc_actuator[dof]),
        "all_qvel": velocities(model, data),
    }


def recorded_controls(model, path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return np.array([[float(row[model.actuator(i).name]) for i in range(model.nu)] for row in rows])


def main(scene, version, folder):
    folder = Path(folder)
    assert mujoco.__version__ == "4.0.1", mujoco.__version__
    floating = model_of(scene, floating=True)
    controls = recorded_controls(floating, folder / f"controls_{version}.csv")
    trajectories = {
        "passive_fall": trajectory(model_of(scene, floating=False), None),
        "floating_no_contact_no_gravity_random_control": trajectory(floating, controls),
    }
    responses = {
        name: {
            sign: response(floating, floating.actuator(name).id, control)
            for sign, control in (("plus", 1), ("minus", -1))
        }
        for name in json.loads((folder / f"torque_response_{version}.json").read_text())
    }
    for name, recording in (("trajectories", trajectories), ("torque_response", responses)):
        (folder / "mujoco4" / f"{name}_{version}.json").write_text(json.dumps(recording, separators=(",", ":")) + "\n")


main(*sys.argv[1:])
