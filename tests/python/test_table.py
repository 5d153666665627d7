"""The table of functions, the structs and the constants are those of mimo.h."""

import ctypes
import json
import re

import pytest

from mimo import _abi, constants, errors

NUMBERS = {
    "int32_t": ctypes.c_int32,
    "uint32_t": ctypes.c_uint32,
    "uint64_t": ctypes.c_uint64,
    "size_t": ctypes.c_size_t,
    "double": ctypes.c_double,
    "float": ctypes.c_float,
    "mimo_status": ctypes.c_int32,
    "mimo_log_fn": _abi.LogFunction,
    "mimo_task_reset_fn": _abi.TaskReset,
    "mimo_task_evaluate_fn": _abi.TaskEvaluate,
}
STRUCTS = {
    "mimo_log_record": _abi.LogRecord,
    "mimo_scene_config": _abi.SceneConfig,
    "mimo_agent_config": _abi.AgentConfig,
    "mimo_growth": _abi.Growth,
    "mimo_limits": _abi.Limits,
    "mimo_maturity": _abi.Maturity,
    "mimo_object_config": _abi.ObjectConfig,
    "mimo_model_config": _abi.ModelConfig,
    "mimo_camera_config": _abi.CameraConfig,
    "mimo_gaze": _abi.Gaze,
    "mimo_mesh": _abi.Mesh,
    "mimo_appearance": _abi.Appearance,
    "mimo_texture": _abi.Texture,
    "mimo_light": _abi.Light,
    "mimo_load_report": _abi.LoadReport,
    "mimo_recorder_config": _abi.RecorderConfig,
    "mimo_recording_info": _abi.RecordingInfo,
    "mimo_replay_report": _abi.ReplayReport,
    "mimo_senses_config": _abi.SensesConfig,
    "mimo_parameter": _abi.Parameter,
    "mimo_env_config": _abi.EnvConfig,
    "mimo_agent_info": _abi.AgentInfo,
    "mimo_field_config": _abi.FieldConfig,
    "mimo_layout_info": _abi.LayoutInfo,
    "mimo_movement": _abi.Movement,
    "mimo_field": _abi.Field,
    "mimo_action": _abi.Action,
    "mimo_term": _abi.Term,
    "mimo_reset_config": _abi.ResetConfig,
    "mimo_env_results": _abi.EnvResults,
    "mimo_picture": _abi.Picture,
    "mimo_batch_reset_config": _abi.BatchResetConfig,
    "mimo_picture_config": _abi.PictureConfig,
    "mimo_timing": _abi.Timing,
    "mimo_batch_config": _abi.BatchConfig,
    "mimo_batch_results": _abi.BatchResults,
    "mimo_task_moment": _abi.TaskMoment,
    "mimo_task_verdict": _abi.TaskVerdict,
    "mimo_task_field": _abi.TaskField,
    "mimo_task": _abi.Task,
}


@pytest.fixture(scope="module")
def header(root):
    text = "".join(chapter.read_text() for chapter in sorted((root / "include/mimo").glob("*.h")))
    return re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)


def fits(declared, given):
    """Whether a ctypes type is what the C declaration of a parameter or member says."""
    declared = " ".join(declared.replace("const", " ").replace("*", " * ").split())
    if "*" not in declared:
        return given is NUMBERS[declared]
    if declared == "char *":
        return given is ctypes.c_char_p
    if declared == "char * *":
        return given is ctypes.POINTER(ctypes.c_char_p)
    target, stars = declared.split(" *", 1)
    if target in STRUCTS:
        pointer = ctypes.POINTER(STRUCTS[target])
        return given is (ctypes.POINTER(pointer) if "*" in stars else pointer)
    if "*" in stars:
        return given is ctypes.POINTER(ctypes.c_void_p)
    if given is ctypes.c_void_p:  # arrays, handles and anything
        return True
    return {"uint8_t": ctypes.c_uint8, **NUMBERS}.get(target) is getattr(given, "_type_", None)


def test_every_function_has_the_header_s_types(header):
    found = re.findall(r"MIMO_API\s+([\w\s*]+?)\s*(mimo_\w+)\(([^;]*?)\)\s*MIMO_NOEXCEPT;", header)
    assert {name for _, name, _ in found} == set(_abi.FUNCTIONS)
    for result, name, parameters in found:
        returned, given = _abi.FUNCTIONS[name]
        declared = [] if parameters.strip() == "void" else [re.sub(r"\w+\s*$", "", p) for p in parameters.split(",")]
        assert len(declared) == len(given), name
        assert all(fits(d, g) for d, g in zip(declared, given)), name
        assert returned is None if result == "void" else fits(result, returned), name


def test_the_table_is_what_the_library_exports(root):
    exported = re.findall(r"^ *(mimo_\w+);$", (root / "src/capi/exports.map").read_text(), re.MULTILINE)
    assert sorted(_abi.FUNCTIONS) == sorted(name for name in exported if name.startswith("mimo_"))


@pytest.mark.parametrize("name", STRUCTS)
def test_every_struct_has_the_header_s_members(header, name):
    body = re.search(rf"typedef struct {name} {{(.*?)}} {name};", header, flags=re.DOTALL).group(1)
    declared = [line.strip() for line in body.split(";") if line.strip()]
    members = STRUCTS[name]._fields_
    assert len(declared) == len(members)
    for line, (member, kind) in zip(declared, members):
        kind_text, written, count = re.fullmatch(r"(.*?)(\w+)(?:\[(\d+)\])?", line, flags=re.DOTALL).groups()
        assert written == member
        element = kind._type_ if count else kind
        assert fits(kind_text, element), line
        assert not count or kind._length_ == int(count)


def test_structs_lie_in_memory_as_c_has_them(root):
    listed = json.loads((root / "tests/abi/layout.json").read_text())
    assert set(STRUCTS) == set(listed)
    for name, struct in STRUCTS.items():
        members = {member: getattr(struct, member) for member, _ in struct._fields_}
        places = {member: [place.offset, place.size] for member, place in members.items()}
        assert listed[name] == {"size": ctypes.sizeof(struct), **places}, name


PREFIXES = {
    "MIMO_PROPRIOCEPTION_": constants.Proprioception,
    "MIMO_VISION_": constants.Vision,
    "MIMO_VESTIBULAR_": constants.Vestibular,
    "MIMO_SEX_": constants.Sex,
    "MIMO_GROWTH_": constants.GrowthModel,
    "MIMO_MATURITY_": constants.Mature,
    "MIMO_PLACE_": constants.Place,
    "MIMO_ACTUATION_": constants.Actuation,
    "MIMO_ACT_": constants.Act,
    "MIMO_FRAME_": constants.Frame,
    "MIMO_AXES_": constants.Axes,
    "MIMO_TEXTURE_": constants.TextureType,
    "MIMO_SHAPE_": constants.Shape,
    "MIMO_JACOBIAN_": constants.Jacobian,
    "MIMO_DISABLE_": constants.Disable,
    "MIMO_AUTORESET_": constants.Autoreset,
    "MIMO_RENDER_": constants.Render,
    "MIMO_TOUCH_": constants.Touch,
    "MIMO_RESPONSE_": constants.TouchResponse,
    "MIMO_OUTCOME_": constants.Outcome,
    "MIMO_RECEPTOR_": constants.Receptor,
    "MIMO_LOOK_": constants.Look,
}


@pytest.mark.parametrize("prefix", PREFIXES)
def test_constants_are_the_header_s(header, prefix):
    defined = re.findall(rf"#define {prefix}(\w+) (-?\w+?)u?\s", header)
    assert {name: int(value, 0) for name, value in defined} == {
        name: int(member) for name, member in PREFIXES[prefix].__members__.items()
    }


@pytest.mark.parametrize("prefixless", [constants.Kind, constants.Quantity])
def test_constants_without_a_prefix(header, prefixless):
    for name, member in prefixless.__members__.items():
        assert re.search(rf"#define MIMO_{name} {int(member)}\s", header), name


def test_codes_of_warnings(header):
    defined = dict(re.findall(r"#define MIMO_WARNING_(\w+) (\d+)\s", header))
    del defined["COUNT"]  # a quantity
    assert {name: str(int(code)) for name, code in constants.WarningCode.__members__.items()} == defined


def test_every_status_has_its_exception(header):
    defined = {int(value) for value in re.findall(r"#define MIMO_E_\w+ (-\d+)", header)}
    assert set(errors.BY_STATUS) == defined
