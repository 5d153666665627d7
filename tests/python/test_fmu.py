"""Units of FMI: checked and simulated by FMPy, and compared with a world that takes the same steps."""

import ctypes
import shutil
import subprocess
import sys
import zipfile

import numpy as np
import pytest
from recorded import program

import mimo

fmpy = pytest.importorskip("fmpy", reason="FMPy is not installed")
from fmpy import fmi2, fmi3  # noqa: E402
from fmpy.validation import validate_fmu  # noqa: E402

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="units are made on Linux")
STEP = 0.01  # s, of the scene reach
SEED = 5
JOINTS = "proprioception/position"


def export(path, *options, code=0):
    done = subprocess.run([program(), "export", "--fmu", str(path), *options], capture_output=True, text=True)
    assert done.returncode == code, done.stderr
    return done.stderr


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """The same scene in both versions."""
    folder = tmp_path_factory.mktemp("fmu")
    options = ["--scene", "reach", "--seed", str(SEED), "--vision", "8", "--outputs", "proprioception,vision"]
    for version in (2, 3):
        export(folder / f"infant{version}.fmu", *options, "--fmi", str(version))
    return {version: folder / f"infant{version}.fmu" for version in (2, 3)}


def world():
    made = mimo.World("reach", vision=True, vision_width=8, vision_height=8)
    made.reset(seed=SEED)
    return made


def actions_at(step, names):
    return 0.5 * np.sin(0.3 * step + np.arange(len(names)))


class Running:
    """An instance of a unit."""

    def __init__(self, file, version):
        self.folder = fmpy.extract(str(file))
        self.told = fmpy.read_model_description(self.folder, validate=False)
        kind = {2: fmi2.FMU2Slave, 3: fmi3.FMU3Slave}[version]
        token = self.told.guid if version == 2 else self.told.instantiationToken
        self.unit = kind(guid=token, modelIdentifier="mimo_unit", unzipDirectory=self.folder, instanceName="infant")
        self.number = {it.name: it.valueReference for it in self.told.modelVariables}
        self.version = version
        self.unit.instantiate()

    def start(self, seed=None):
        if self.version == 2:
            self.unit.setupExperiment(startTime=0.0)
        if seed is not None and self.version == 2:
            self.unit.setInteger([self.number["seed"]], [seed])
        if seed is not None and self.version == 3:
            self.unit.setUInt64([self.number["seed"]], [seed])
        self.unit.enterInitializationMode()
        self.unit.exitInitializationMode()
        return self

    def act(self, names, actions):
        numbers = [self.number[name] for name in names]
        (self.unit.setReal if self.version == 2 else self.unit.setFloat64)(numbers, [float(it) for it in actions])

    def step(self, time, seconds=STEP):
        self.unit.doStep(currentCommunicationPoint=time, communicationStepSize=seconds)

    def field(self, name, labels):
        if self.version == 3:
            return np.array(self.unit.getFloat32([self.number[name]], nValues=len(labels)), np.float32)
        return np.array(self.unit.getReal([self.number[f"{name}/{label}"] for label in labels]), np.float32)

    def close(self):
        self.unit.terminate()
        self.unit.freeInstance()
        shutil.rmtree(self.folder)


@pytest.fixture(params=[2, 3])
def running(request, files):
    made = Running(files[request.param], request.param)
    yield made
    made.close()


@pytest.mark.parametrize("version", [2, 3])
def test_fmpy_finds_no_problems(files, version):
    assert validate_fmu(str(files[version])) == []


@pytest.mark.parametrize("version", [2, 3])
def test_fmpy_simulates_it(files, version):
    result = fmpy.simulate_fmu(str(files[version]), stop_time=0.2, output=["reward"])
    assert result["time"][-1] == pytest.approx(0.2)
    assert np.isfinite(result["reward"]).all()


def test_a_unit_needs_nothing_outside(files):
    with zipfile.ZipFile(files[3]) as unit:
        assert unit.testzip() is None
        names = unit.namelist()
    (binary,) = [name for name in names if name.startswith("binaries/")]
    assert binary.split("/")[1] in ("x86_64-linux", "aarch64-linux")
    assert binary.endswith("/mimo_unit.so")
    assert {"modelDescription.xml", "resources/mimo.txt"} < set(names)
    assert any(name.startswith("resources/libmimo") for name in names)
    assert any(name.startswith("resources/libmujoco") for name in names)


def test_steps_are_those_of_a_world(running):
    with world() as reference:
        names, labels = list(reference.action_names), reference.layout.fields[JOINTS].labels
        running.start()
        np.testing.assert_array_equal(running.field(JOINTS, labels), reference.observation[JOINTS])
        for step in range(30):
            given = actions_at(step, names)
            running.act(names, given)
            running.step(step * STEP)
            reference.step(given)
            np.testing.assert_array_equal(running.field(JOINTS, labels), reference.observation[JOINTS])


def test_one_long_step_is_several(running):
    with world() as reference:
        names, labels = list(reference.action_names), reference.layout.fields[JOINTS].labels
        running.start()
        running.act(names, actions_at(0, names))
        running.step(0.0, 7 * STEP)
        for _ in range(7):
            reference.step(actions_at(0, names))
        np.testing.assert_array_equal(running.field(JOINTS, labels), reference.observation[JOINTS])


def test_the_seed_is_a_parameter(running):
    with world() as reference:
        labels = reference.layout.fields[JOINTS].labels
        reference.reset(seed=77)
        running.start(seed=77)
        np.testing.assert_array_equal(running.field(JOINTS, labels), reference.observation[JOINTS])


def test_a_state_is_gone_back_to(running):
    """The second run from a state equals the first, to the last bit, also from serialized bytes."""
    with world() as reference:
        names, labels = list(reference.action_names), reference.layout.fields[JOINTS].labels
    running.start()
    unit = running.unit
    get, put, free, pack, unpack = (
        (unit.getFMUState, unit.setFMUState, unit.freeFMUState, unit.serializeFMUState, unit.deserializeFMUState)
        if running.version == 3
        else (unit.getFMUstate, unit.setFMUstate, unit.freeFMUstate, unit.serializeFMUstate, unit.deSerializeFMUstate)
    )

    def go_on():
        rows = []
        for step in range(5, 15):
            running.act(names, actions_at(step, names))
            running.step(step * STEP)
            rows.append(running.field(JOINTS, labels))
        return np.array(rows)

    for step in range(5):
        running.act(names, actions_at(step, names))
        running.step(step * STEP)
    at, state = running.field(JOINTS, labels), get()
    packed = pack(state)
    first = go_on()
    put(state)
    np.testing.assert_array_equal(running.field(JOINTS, labels), at)
    np.testing.assert_array_equal(go_on(), first)
    again = unpack(packed)
    put(again)
    np.testing.assert_array_equal(go_on(), first)
    for it in (state, again):
        free(it)


def test_pictures_are_bytes_in_fmi_3_alone(files):
    assert not any("vision" in it.name for it in fmpy.read_model_description(str(files[2])).modelVariables)
    running = Running(files[3], 3).start()
    with world() as reference:
        sizes, values = (ctypes.c_size_t * 1)(), (ctypes.POINTER(ctypes.c_uint8) * 1)()
        numbers = (ctypes.c_uint32 * 1)(running.number["vision/eye_left"])
        running.unit.fmi3GetBinary(running.unit.component, numbers, 1, sizes, values, 1)
        seen = np.ctypeslib.as_array(values[0], (sizes[0],)).reshape(8, 8, 3)
        np.testing.assert_array_equal(seen, reference.observation["vision/eye_left"])
    running.close()


@pytest.mark.parametrize(
    ("time", "seconds", "message"),
    [
        (0.0, 0.015, "communicationStepSize is 0.015 s, expected a multiple of the step of 0.01 s"),
        (0.0, 0.0, "communicationStepSize is 0 s"),
        (0.0, float("nan"), "communicationStepSize is nan s"),
        (0.5, STEP, "currentCommunicationPoint is 0.5 s, expected 0 s"),
    ],
)
def test_wrong_steps_are_refused(running, capfd, time, seconds, message):
    running.start()
    with pytest.raises(Exception):  # noqa: B017, PT011 - FMPy's kinds differ
        running.step(time, seconds)
    assert message in capfd.readouterr().out
    running.step(0.0)  # it goes on


def test_what_is_not_in_order_is_refused(running, capfd):
    with pytest.raises(Exception):  # noqa: B017, PT011
        running.step(0.0)
    assert "a step before initialization has ended" in capfd.readouterr().out
    running.start()
    with pytest.raises(Exception):  # noqa: B017, PT011
        running.act(["reward"], [1.0])
    assert "reward is no input" in capfd.readouterr().out
    running.unit.reset()
    running.start()
    running.step(0.0)


def test_an_own_scene_goes_along(tmp_path):
    (tmp_path / "room.xml").write_text(
        """<mujoco><option timestep="0.005"/><worldbody><geom type="plane" size="1 1 .1"/>
        <body name="pole" pos="0 0 1"><joint name="swing" axis="0 1 0"/>
        <geom type="capsule" fromto="0 0 0 0 0 -.4" size=".02"/>
        </body></worldbody><actuator><motor name="push" joint="swing" ctrlrange="-1 1" ctrllimited="true"/></actuator>
        </mujoco>"""
    )
    export(tmp_path / "pole.fmu", "--scene", str(tmp_path / "room.xml"), "--outputs", "proprioception/position")
    (tmp_path / "room.xml").unlink()
    assert validate_fmu(str(tmp_path / "pole.fmu")) == []
    result = fmpy.simulate_fmu(
        str(tmp_path / "pole.fmu"), stop_time=0.5, start_values={"push": 1.0}, output=["proprioception/position"]
    )
    angles = np.array([np.ravel(it) for it in result["proprioception/position"]])
    assert abs(angles[-1, 0]) > 0.05


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--outputs", "smell"], "--outputs: the world has no 'smell'; it has proprioception/position"),
        (["--seconds", "3"], "--seconds has no effect with --fmu"),
        (["--gltf", "a.glb"], "--gltf and --fmu are two files"),
        (["--scene", "nowhere"], "nowhere"),
    ],
)
def test_refused(tmp_path, options, message):
    assert message in export(tmp_path / "a.fmu", *options, code=1)
    assert list(tmp_path.iterdir()) == []


def test_names_end_in_fmu(tmp_path):
    assert "expected a name that ends in .fmu" in export(tmp_path / "a.zip", code=2)
