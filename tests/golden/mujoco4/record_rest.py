"""Records what MuJoCo 4.0.1 alone makes of infants at rest: record_rest.py GOLDEN_FOLDER

The scenes are written by the package mimo, on whichever MuJoCo: one that settles, held infants, and such under a ball,
as the tests make them. What they are compared with is MuJoCo's own: mj_step, mj_forward and mj_contactForce. Needs the
packages mimo, mujoco-core and numpy.
"""

import json
import sys
import tempfile
from pathlib import Path

import mujoco
import numpy as np

import mimo

GOLDEN = Path(sys.argv[1])
HOLD = "<equality><weld body1='mimo_location' solref='.01 1' solimp='.9999 .9999 .001 .5 1'/></equality>"


def read(name):
    return json.loads((GOLDEN / name).read_text())


def write(name, recording):
    (GOLDEN / "mujoco4" / name).write_text(json.dumps(recording, separators=(",", ":")) + "\n")


def model_of(scene):
    with tempfile.TemporaryDirectory() as folder:
        scene.save(folder)
        return mujoco.MjModel.from_xml_path(str(Path(folder) / "scene.xml"))


def held(xml, quat):
    scene = mimo.Scene(xml=xml)
    scene.add_agent(body="mitten", position=(0, 0, 1), orientation=quat)
    model = model_of(scene)
    model.eq_active0[:] = 1
    return model


def key(model, joint):
    return model.joint(joint).name or "free:" + model.body(model.joint(joint).bodyid[0]).name


def width(model, joint):
    return 7 if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE else 1


def set_positions(model, data, positions):
    for joint in range(model.njnt):
        first = model.jnt_qposadr[joint]
        data.qpos[first : first + width(model, joint)] = positions[key(model, joint)]


def settled():
    scene = mimo.Scene("selfbody")
    scene.add_agent(body="mitten")
    model = model_of(scene)
    data = mujoco.MjData(model)
    set_positions(model, data, read("poses.json")["selfbody"]["stored"])
    mujoco.mj_step(model, data, 25)
    return {
        key(model, joint): data.qpos[model.jnt_qposadr[joint] :][: width(model, joint)].tolist()
        for joint in range(model.njnt)
    }


def at_rest(recorded):
    options = "<include file='mimo/parts/options.xml'/><worldbody/>"
    model = held("<mujoco>" + options + HOLD + "</mujoco>", recorded["root_quat_wxyz"])
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 1500)
    return {
        "orientation": recorded["orientation"],
        "root_quat_wxyz": recorded["root_quat_wxyz"],
        "acc": data.sensor("vestibular_acc").data.tolist(),
        "gyro": data.sensor("vestibular_gyro").data.tolist(),
        "torque_sensors": {name: data.sensor(name).data.tolist() for name in recorded["torque_sensors"]},
    }


def contact_forces(model, data):
    """Of each body, in the world, as it feels them."""
    forces = {}
    for number in range(data.ncon):
        contact, force = data.contact[number], np.zeros(6)
        mujoco.mj_contactForce(model, data, number, force)
        acting = np.asarray(contact.frame).reshape(3, 3).T @ force[:3]  # on the second geom
        for geom, sign in ((contact.geom[0], -1), (contact.geom[1], 1)):
            name = model.body(model.geom_bodyid[geom]).name
            forces[name] = forces.get(name, np.zeros(3)) + sign * acting
    return forces


def under_a_ball(recorded):
    ball = recorded["ball"]
    xml = (
        "<mujoco><include file='mimo/benchmark.xml'/><worldbody>"
        f"<body pos='{ball['x']} {ball['y']} {ball['z']}'>"
        f"<joint name='ball_slide' type='slide' axis='0 0 1' damping='{ball['damping']}'/>"
        f"<geom name='ball' class='room' size='{ball['size']}' mass='{ball['mass']}' condim='3'/>"
        f"</body></worldbody>{HOLD}</mujoco>"
    )
    model = held(xml, recorded["root_quat_wxyz"])
    data = mujoco.MjData(model)
    set_positions(model, data, recorded["qpos"])
    mujoco.mj_forward(model, data)
    forces = contact_forces(model, data)
    return {name: {"force_world": forces[name].tolist()} for name in recorded["reference_from_mj_contactForce"]}


assert mujoco.__version__ == "4.0.1", mujoco.__version__
write("settled.json", settled())
write("vestibular.json", [at_rest(recorded) for recorded in read("vestibular.json")])
write("touch_static.json", [under_a_ball(recorded) for recorded in read("touch_static.json")])
