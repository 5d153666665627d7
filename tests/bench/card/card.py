#!/usr/bin/env python3
"""A graphics card tried: MIMo by mujoco_warp, and own kernels for its eyes and skin (docs/adr/0023-graphics-card.md).

    tests/bench/card/card.py same     the pictures of eyes.cu beside libmimo's (without a card, by the processor)
    tests/bench/card/card.py step     steps of mujoco_warp beside MuJoCo's, and the same run twice
    tests/bench/card/card.py speed    worlds a second of physics, eyes, skin and all (a card only)
    tests/bench/card/card.py graph FOLDER    a captured step of 1024 worlds, for player.c (2 worlds without a card)

Needs MuJoCo's Python package, libmimo for the same version of it, and for all but `same` mujoco_warp; nvcc or c++:

    PYTHONPATH=bindings/python/src MIMO_LIBRARY=build-mujoco4/lib/libmimo-mujoco4.so tests/bench/card/card.py same
"""

import ctypes
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import drawn
import mujoco
import numpy as np

import mimo

HERE = pathlib.Path(__file__).resolve().parent
SCENE, PIXELS, EYES = "benchmark", 64, ("eye_left", "eye_right")
SIZES = (1, 256, 1024, 4096, 8192)
CONTACTS, CONSTRAINTS = 64, 384  # for each world: where a world has more constraints, mujoco_warp loses it
SKIP = 2  # physics steps of a step
WORK = tempfile.TemporaryDirectory()


def model_of(scene=SCENE):
    described = mimo.Scene(scene)
    described.add_agents()
    folder = os.path.join(WORK.name, scene)
    if not os.path.exists(folder):
        described.save(folder)
    return mujoco.MjModel.from_xml_path(os.path.join(folder, "scene.xml"))


def built(name):
    """A library of eyes.cu or skin.cu, for the card or for the processor."""
    to = os.path.join(WORK.name, name + ".so")
    card = ["nvcc", "-O3", "-arch=native", "--shared", "-Xcompiler", "-fPIC"]
    processor = ["c++", "-x", "c++", "-O2", "-shared", "-fPIC"]
    subprocess.run([*(card if CARD else processor), HERE / (name + ".cu"), "-o", to], check=True)
    return ctypes.CDLL(to)


def put(array):
    """Bytes on the card where there is one, else on the host."""
    copied = np.frombuffer(array.tobytes(), np.uint8).copy()
    return wp.array(copied, dtype=wp.uint8) if CARD else copied


def taken(array):
    return array.numpy() if CARD else array


def at(array):
    if array is None:
        return None
    return ctypes.c_void_p(array.ptr if hasattr(array, "ptr") else array.ctypes.data)


def stream():
    return ctypes.c_void_p(wp.get_stream().cuda_stream if CARD else None)


class Eyes:
    def __init__(self, model, effects, library):
        self._library, self._model = library, model
        self._scene, *arrays = drawn.scene(model, PIXELS, effects)
        self._arrays = [put(a) for a in arrays]

    def __call__(self, worlds, poses, rgb, ids=None):
        model = self._model
        arrays = [at(a) for a in (*self._arrays, *poses)]
        sizes = worlds, model.ngeom, model.ncam, model.nlight
        error = self._library.see(at(self._scene), *arrays, *sizes, at(rgb), at(ids), stream())
        assert error == 0, error


# ---- The same pictures? ------------------------------------------------------------------------------------------


def played(effects, count):
    """Pictures and geoms that both eyes see while the infant moves at random, and the joints' positions."""
    bits = {"none": 0, "shadows": mimo.Render.SHADOWS, "all": mimo.Render.SHADOWS | mimo.Render.SKY | mimo.Render.HAZE}
    world = mimo.World(SCENE, vision_width=PIXELS, vision_height=PIXELS, render=bits[effects])
    world.reset(seed=1)
    random = np.random.default_rng(1)
    pictures, geoms, joints = [], [], []
    for _ in range(count):
        for _ in range(10):
            world.step(random.uniform(-1, 1, len(world.layout.actions)).astype(np.float32))
        seen = [world.draw(camera=eye, width=PIXELS, height=PIXELS) for eye in EYES]
        pictures.append([picture.rgb for picture in seen])
        geoms.append([picture.segmentation for picture in seen])
        joints.append(world.get(mimo.Quantity.JOINT_POSITION).ravel())
    return np.array(pictures), np.array(geoms), np.array(joints)


def same(count=64):
    model, library = model_of(), built("eyes")
    shape = count, len(EYES), PIXELS, PIXELS
    for effects in drawn.EFFECTS:
        pictures, geoms, joints = played(effects, count)
        worlds = []
        for qpos in joints:
            worlds.append(mujoco.MjData(model))
            worlds[-1].qpos[:] = qpos
            mujoco.mj_forward(model, worlds[-1])
        rgb, ids = put(np.zeros((*shape, 3), np.uint8)), put(np.zeros(shape, np.int32))
        Eyes(model, effects, library)(count, [put(a) for a in drawn.poses(worlds)], rgb, ids)
        got = taken(rgb).reshape(*shape, 3).astype(int)
        apart = np.abs(got - pictures).max(-1)
        other = (taken(ids).view(np.int32).reshape(shape) != geoms).sum()
        print(f"effects {effects}: of {apart.size} pixels {other} show another geom,")
        print(f"  {(apart > 1).sum()} differ by more than 1 of 255, by {apart.max()} at most; mean {apart.mean():.4f}")


# ---- Physics -----------------------------------------------------------------------------------------------------


def made(model, worlds):
    warped = mjw.put_model(model)
    return warped, mjw.make_data(model, nworld=worlds, nconmax=CONTACTS, njmax=CONSTRAINTS)


def controls(model, worlds, random):
    low, high = model.actuator_ctrlrange.T
    return wp.array(random.uniform(low, high, size=(worlds, model.nu)).astype(np.float32), dtype=float)


def beside_mujoco(scene, steps=100):
    """One step from each state that MuJoCo comes to."""
    model = model_of(scene)
    warped, one = made(model, 1)
    data, random = mujoco.MjData(model), np.random.default_rng(0)
    errors, other = [], 0
    for i in range(steps):
        if i % SKIP == 0:
            data.ctrl[:] = random.uniform(*model.actuator_ctrlrange.T)
        for name in ("qpos", "qvel", "ctrl", "qacc_warmstart"):
            getattr(one, name).assign(getattr(data, name)[None].astype(np.float32))
        before = data.qvel.copy()
        mujoco.mj_step(model, data)
        mjw.step(warped, one)
        errors.append(np.linalg.norm(one.qvel.numpy()[0] - data.qvel) / np.linalg.norm(data.qvel - before))
        other += data.ncon != int(one.nacon.numpy()[0])
    median, most = statistics.median(errors), max(errors)
    print(f"{scene}: change of velocity differs by {median:.1e} of it (median), {most:.1e} (largest)")
    print(f"  other contacts in {other} of {steps} steps", flush=True)


def step():
    for scene in (SCENE, "reach"):
        beside_mujoco(scene)
    runs, worlds = [], 256 if CARD else 2
    for _ in range(2):
        model, random = model_of(), np.random.default_rng(3)
        warped, data = made(model, worlds)
        for _ in range(100):
            data.ctrl = controls(model, worlds, random)
            mjw.step(warped, data)
        runs.append(data.qpos.numpy())
    print(f"the same run twice: {(runs[0] == runs[1]).all(1).sum()} of {worlds} worlds have the same bytes")


# ---- Speed -------------------------------------------------------------------------------------------------------


class Skin:
    """Sensors of libmimo's skin, and forces on them."""

    class Sensors(ctypes.Structure):
        NAMES = "position frame geom_first geom_count body_first body_count body_of spacing"
        _fields_ = [*((name, ctypes.c_void_p) for name in NAMES.split()), ("sensors", ctypes.c_int)]

    class Contacts(ctypes.Structure):
        _fields_ = [(name, ctypes.c_void_p) for name in ("count", "pos", "frame", "dist", "geom", "world", "force")]

    def __init__(self, model, library):
        world = mimo.World(SCENE, vision=0)
        receptors = world.layout.receptors("touch/force")
        bodies, geoms, position = (np.asarray(a) for a in (receptors.bodies, receptors.geoms, receptors.position))
        spacing = np.ones(model.nbody, np.float32)
        for body in np.unique(bodies):
            places = position[bodies == body][:400]
            apart = np.linalg.norm(places[:, None] - places, axis=-1)
            spacing[body] = np.median(np.where(apart > 0, apart, np.inf).min(1)) if len(places) > 1 else 0.01

        def ranges(ids, count):
            counts = np.bincount(ids, minlength=count)
            firsts = [np.argmax(ids == i) if counts[i] else 0 for i in range(count)]
            return np.array(firsts, np.int32), counts.astype(np.int32)

        arrays = [position.astype(np.float32), np.asarray(receptors.frame, np.float32), *ranges(geoms, model.ngeom)]
        arrays += [*ranges(bodies, model.nbody), model.geom_bodyid.astype(np.int32), spacing]
        self._arrays, self.count, self._library = [put(a) for a in arrays], len(position), library
        self._sensors = self.Sensors(*(a.ptr for a in self._arrays), self.count)

    def __call__(self, warped, data, ids, force, felt):
        mjw.contact_force(warped, data, ids, False, force)
        c = data.contact
        arrays = data.nacon, c.pos, c.frame, c.dist, c.geom, c.worldid, force
        contacts = self.Contacts(*(a.ptr for a in arrays))
        sensors, places = ctypes.byref(self._sensors), (at(data.xpos), at(data.xmat))
        sizes = warped.nbody, data.nworld
        error = self._library.feel(sensors, ctypes.byref(contacts), *places, *sizes, at(felt), stream())
        assert error == 0, error


def timed(call, seconds=1.0):
    """Seconds of a call: the median of three stretches."""
    stretches = []
    for calls in (1, 1, 0, 0, 0):  # the first warms up, the second tells how many go into a stretch
        calls = calls or max(3, int(seconds / 3 / max(stretches[1], 1e-5)))
        start = time.perf_counter()
        for _ in range(calls):
            call()
        wp.synchronize()
        stretches.append((time.perf_counter() - start) / calls)
    return statistics.median(stretches[2:])


def of_size(worlds, eyes_library, skin_library):
    model, random = model_of(), np.random.default_rng(0)
    warped, data = made(model, worlds)
    bank = [controls(model, worlds, random) for _ in range(16)]
    mjw.step(warped, data)
    with wp.ScopedCapture() as capture:
        for _ in range(SKIP):
            mjw.step(warped, data)
    turn = iter(range(1 << 30))

    def physics():
        wp.copy(data.ctrl, bank[next(turn) % len(bank)])
        wp.capture_launch(capture.graph)

    for _ in range(200):
        physics()
    rgb = wp.zeros(worlds * len(EYES) * PIXELS * PIXELS * 3, dtype=wp.uint8)
    poses = [data.geom_xpos, data.geom_xmat, data.cam_xpos, data.cam_xmat, data.light_xpos, data.light_xdir]
    plain, eyes = (Eyes(model, effects, eyes_library) for effects in ("none", "all"))
    skin = Skin(model, skin_library)
    felt = wp.zeros(worlds * skin.count * 3, dtype=float)
    ids = wp.array(np.arange(data.naconmax, dtype=np.int32), dtype=int)
    force = wp.zeros(data.naconmax, dtype=wp.spatial_vector)
    drawing = mjw.create_render_context(
        model, worlds, (PIXELS, PIXELS), True, use_shadows=True, use_textures=True, render_skybox=True
    )

    def theirs():
        mjw.refit_bvh(warped, data, drawing)
        mjw.render(warped, data, drawing)

    def everything():
        physics()
        eyes(worlds, poses, rgb)
        skin(warped, data, ids, force, felt)

    calls = {
        "physics": physics,
        "eyes": lambda: eyes(worlds, poses, rgb),
        "eyes without shadows and sky": lambda: plain(worlds, poses, rgb),
        "skin": lambda: skin(warped, data, ids, force, felt),
        "all three": everything,
        "mujoco_warp's renderer": theirs,
    }
    for name, call in calls.items():
        seconds = timed(call)
        print(f"{worlds} worlds: {name} {1e6 * seconds:.0f} us, {worlds / seconds:.0f} worlds a second", flush=True)
    lost = (~np.isfinite(data.qpos.numpy()).all(1)).sum()
    print(f"  {int(data.nefc.numpy().max())} constraints at most, {lost} worlds lost", flush=True)


def speed():
    libraries = built("eyes"), built("skin")
    for worlds in SIZES:
        of_size(worlds, *libraries)


def graph(folder):
    os.makedirs(folder, exist_ok=True)
    model, worlds = model_of(), 1024 if CARD else 2
    warped, data = made(model, worlds)
    mjw.step(warped, data)
    mjw.reset_data(warped, data)
    with wp.ScopedCapture(apic=True) as capture:
        mjw.step(warped, data)
    inputs = {"ctrl": data.ctrl, "start": data.qpos, "speed": data.qvel}
    wp.capture_save(capture.graph, os.path.join(folder, "step"), inputs=inputs, outputs={"qpos": data.qpos})
    mjw.reset_data(warped, data)
    data.qpos.numpy().tofile(os.path.join(folder, "start.bin"))
    for _ in range(20):
        wp.capture_launch(capture.graph)
    data.qpos.numpy().tofile(os.path.join(folder, "after.bin"))
    player = f"player {os.path.dirname(wp.__file__)}/bin {folder} {'cuda' if CARD else 'cpu'}"
    print(f"{player} {worlds} {model.nq} {model.nv} 100")


COMMANDS = {"same": same, "step": step, "speed": speed, "graph": graph}

if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in COMMANDS or len(sys.argv) != 2 + (sys.argv[1] == "graph"):
        sys.exit(__doc__)
    CARD = shutil.which("nvcc") is not None
    if CARD or sys.argv[1] != "same":
        import mujoco_warp as mjw
        import warp as wp

        wp.config.log_level = wp.LOG_WARNING
        wp.init()
        CARD = wp.is_cuda_available()
    if sys.argv[1] == "speed" and not CARD:
        sys.exit("speed needs a graphics card of NVIDIA, and nvcc")
    COMMANDS[sys.argv[1]](*sys.argv[2:])
