"""The C API as ctypes sees it: every struct and every function of mimo.h, in the header's order.

A test reads the header and compares; whoever changes mimo.h changes this table.
"""

from __future__ import annotations

import ctypes
from ctypes import c_char_p, c_double, c_float, c_int32, c_size_t, c_uint32, c_uint64, c_void_p
from typing import Any, Dict, List, Tuple

ABI_VERSION = 1

# Pointers to numbers are passed as addresses: numpy arrays own the memory, and the callers here check the types.
# Pointers to single results are typed, so that ctypes.byref() of the wrong thing is refused.
_Out_i32 = ctypes.POINTER(c_int32)
_Out_u32 = ctypes.POINTER(c_uint32)
_Out_size = ctypes.POINTER(c_size_t)
_Out_f64 = ctypes.POINTER(c_double)
_Out_text = ctypes.POINTER(c_char_p)
_Out_handle = ctypes.POINTER(c_void_p)
_Handle = c_void_p
_Array = c_void_p
_status = c_int32


class Struct(ctypes.Structure):
    """Begins with struct_size, which the constructor fills."""

    def __init__(self, **values: Any) -> None:
        super().__init__(struct_size=ctypes.sizeof(type(self)), **values)


class LogRecord(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("level", c_int32),
        ("code", c_int32),
        ("in_world", c_uint32),
        ("text", c_char_p),
        ("world", c_size_t),
        ("time", c_double),
    ]


LogFunction = ctypes.CFUNCTYPE(None, c_void_p, ctypes.POINTER(LogRecord))


class SceneConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("name", c_char_p),
        ("file", c_char_p),
        ("xml", c_char_p),
        ("model_dir", c_char_p),
        ("log", LogFunction),
        ("log_user", c_void_p),
        ("max_file_bytes", c_uint64),
        ("max_pixels", c_uint64),
        ("max_vertices", c_uint64),
        ("max_elements", c_uint64),
        ("max_keyframes", c_uint64),
        ("max_iterations", c_uint64),
        ("max_world_bytes", c_uint64),
        ("confined", c_uint32),
        ("limits_reserved", c_uint32),
        ("max_compile_ms", c_uint64),
    ]


class Growth(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("sex", c_int32),
        ("age", c_double),
        ("physiological_age", c_double),
        ("matures_apart", c_uint32),
        ("model", c_int32),
        ("z_length", c_double),
        ("z_weight", c_double),
        ("z_head", c_double),
        ("percentile", c_double),
        ("strength_exponent", c_double),
        ("neck_strength", c_double),
        ("birth_tone", c_double),
        ("contracture", c_double),
        ("absolute", c_uint32),
        ("keep_spacing", c_uint32),
        ("maturity", c_uint32),
        ("reserved", c_uint32),
    ]


class AgentConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("place", c_int32),
        ("name", c_char_p),
        ("body", c_char_p),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("proprioception", c_uint32),
        ("vestibular", c_uint32),
        ("limit_threshold", c_double),
        ("vision", c_uint32),
        ("vision_width", c_uint32),
        ("vision_height", c_uint32),
        ("actuation", c_int32),
        ("vision_fovy", c_double),
        ("vision_foveation", c_double),
        ("acts", c_uint32),
        ("normalize_actions", c_uint32),
        ("touch", c_uint32),
        ("touch_response", c_int32),
        ("touch_frame", c_int32),
        ("reflexes", c_uint32),
        ("touch_scale", c_double),
        ("touch_slip_threshold", c_double),
        ("face", c_char_p),
        ("root", c_char_p),
        ("vestibular_at", c_char_p),
        ("growth", ctypes.POINTER(Growth)),
        ("hearing", c_uint32),
        ("voice", c_uint32),
    ]


class Limits(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("delay", c_double),
        ("gain", c_double),
        ("noise", c_double),
        ("blur", c_double),
        ("signal_noise", c_double),
    ]


class Maturity(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("contrast_threshold", c_uint32),
        ("acuity", c_double),
        ("peak_contrast", c_double),
        ("chroma", c_double),
        ("flicker", c_double),
        ("conduction_speed", c_double),
        ("sensory_delay", c_double),
        ("motor_delay", c_double),
        ("vision_delay", c_double),
        ("vestibular_delay", c_double),
        ("hearing_delay", c_double),
    ]


class ObjectConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("shape", c_int32),
        ("name", c_char_p),
        ("size", c_double * 3),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("mass", c_double),
        ("rgba", c_double * 4),
        ("fixed", c_uint32),
        ("reserved", c_uint32),
    ]


class ModelConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("fixed", c_uint32),
        ("name", c_char_p),
        ("file", c_char_p),
        ("xml", c_char_p),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
    ]


class CameraConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("outputs", c_uint32),
        ("name", c_char_p),
        ("width", c_uint32),
        ("height", c_uint32),
        ("fovy", c_double),
        ("placed", c_uint32),
        ("reserved", c_uint32),
        ("body", c_char_p),
        ("position", c_double * 3),
        ("look_at", c_double * 3),
    ]


class Parameter(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("name", c_char_p),
        ("description", c_char_p),
        ("standard", c_double),
        ("low", c_double),
        ("high", c_double),
    ]


class FieldConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("quantity", c_int32),
        ("name", c_char_p),
        ("elements", _Out_text),
        ("element_count", c_size_t),
        ("relative_to", c_char_p),
    ]


class LayoutInfo(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("block_bytes", c_size_t),
        ("fields", c_size_t),
        ("actions", c_size_t),
        ("agents", c_size_t),
        ("terms", c_size_t),
    ]


class Field(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("dtype", c_int32),
        ("name", c_char_p),
        ("unit", c_char_p),
        ("frame", c_char_p),
        ("offset", c_size_t),
        ("bytes", c_size_t),
        ("shape", _Out_size),
        ("ndim", c_size_t),
        ("low", c_double),
        ("high", c_double),
        ("start", c_double),
        ("end", c_double),
        ("period", c_double),
        ("receptors", c_size_t),
        ("sample_rate", c_double),
    ]


class Action(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("name", c_char_p),
        ("unit", c_char_p),
        ("agent", c_size_t),
        ("low", c_double),
        ("high", c_double),
    ]


class Term(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("name", c_char_p),
        ("agent", c_size_t),
    ]


class EnvConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("frame_skip", c_uint32),
        ("jacobian", c_int32),
        ("disable", c_uint32),
        ("renderer", c_char_p),
        ("max_steps", c_uint32),
        ("timing", c_uint32),
        ("log", LogFunction),
        ("log_user", c_void_p),
        ("task", c_char_p),
        ("render", c_uint32),
        ("samples", c_uint32),
        ("render_threads", c_uint32),
        ("step_contacts", c_uint32),
    ]


class AgentInfo(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("action_offset", c_uint32),
        ("action_count", c_uint32),
        ("reserved", c_uint32),
        ("name", c_char_p),
        ("mass", c_double),
        ("height", c_double),
    ]


class ResetConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("seeded", c_uint32),
        ("seed", c_uint64),
        ("growth", ctypes.POINTER(ctypes.POINTER(Growth))),
        ("growth_count", c_size_t),
    ]


class Movement(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("positions", _Array),
        ("position_count", c_size_t),
        ("forces", _Array),
        ("force_count", c_size_t),
    ]


class EnvResults(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("reward", _Array),
        ("terminated", _Array),
        ("truncated", _Array),
        ("outcome", _Array),
        ("agent_count", c_size_t),
        ("terms", _Array),
        ("term_count", c_size_t),
    ]


class Gaze(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("meets", c_uint32),
        ("left_position", c_double * 3),
        ("left_direction", c_double * 3),
        ("right_position", c_double * 3),
        ("right_direction", c_double * 3),
        ("vergence", c_double),
        ("point", c_double * 3),
        ("miss", c_double),
    ]


class PictureConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("format", c_uint32),
        ("camera", c_char_p),
        ("look_at", c_double * 3),
        ("distance", c_double),
        ("azimuth", c_double),
        ("elevation", c_double),
        ("fovy", c_double),
        ("foveation", c_double),
    ]


class Picture(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("rgb", _Array),
        ("rgb_bytes", c_size_t),
        ("depth", _Array),
        ("depth_count", c_size_t),
        ("segmentation", _Array),
        ("segmentation_count", c_size_t),
    ]


class Mesh(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("axes", c_int32),
        ("segments", c_uint32),
        ("reserved", c_uint32),
        ("plane", c_double),
        ("positions", _Array),
        ("normals", _Array),
        ("texcoords", _Array),
        ("indices", _Array),
        ("vertex_capacity", c_size_t),
        ("index_capacity", c_size_t),
        ("vertex_count", c_size_t),
        ("index_count", c_size_t),
    ]


class Appearance(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("visible", c_uint32),
        ("group", c_int32),
        ("texture", c_int32),
        ("color", c_float * 4),
        ("emission", c_float),
        ("specular", c_float),
        ("shininess", c_float),
        ("reflectance", c_float),
    ]


class Texture(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("type", c_int32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("pixels", _Array),
        ("pixel_bytes", c_size_t),
    ]


class Light(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("axes", c_int32),
        ("active", c_uint32),
        ("directional", c_uint32),
        ("casts_shadow", c_uint32),
        ("cutoff", c_float),
        ("exponent", c_float),
        ("position", c_float * 3),
        ("direction", c_float * 3),
        ("ambient", c_float * 3),
        ("diffuse", c_float * 3),
        ("specular", c_float * 3),
        ("attenuation", c_float * 3),
        ("reserved", c_uint32),
    ]


class Timing(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("steps", c_uint64),
        ("total", c_double),
        ("physics", c_double),
        ("touch", c_double),
        ("vision", c_double),
        ("proprioception", c_double),
        ("vestibular", c_double),
        ("hearing", c_double),
    ]


class BatchConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("worlds", c_uint32),
        ("threads", c_uint32),
        ("autoreset", c_int32),
        ("restart_failed", c_uint32),
        ("reserved", c_uint32),
        ("cohort", ctypes.POINTER(ctypes.POINTER(Growth))),
        ("cohort_count", c_size_t),
    ]


class BatchResetConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("seeds", _Array),
        ("mask", _Array),
        ("worlds", c_size_t),
        ("growth", ctypes.POINTER(ctypes.POINTER(Growth))),
    ]


class BatchResults(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("reward", _Array),
        ("terminated", _Array),
        ("truncated", _Array),
        ("outcome", _Array),
        ("agent_count", c_size_t),
        ("terms", _Array),
        ("term_count", c_size_t),
        ("status", _Array),
        ("was_reset", _Array),
        ("final_written", _Array),
        ("worlds", c_size_t),
        ("final_blocks", c_void_p),
        ("final_bytes", c_size_t),
    ]


class TaskMoment(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("world", c_size_t),
        ("agent", c_size_t),
        ("step", c_uint64),
        ("memory", c_void_p),
        ("fields", _Array),
        ("action", _Array),
        ("action_count", c_size_t),
        ("block", c_void_p),
        ("block_bytes", c_size_t),
    ]


class TaskVerdict(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("outcome", c_int32),
        ("reward", c_double),
        ("terms", _Array),
        ("goes_on", c_uint32),
        ("truncated", c_uint32),
    ]


TaskReset = ctypes.CFUNCTYPE(c_int32, c_void_p, c_void_p, ctypes.POINTER(TaskMoment))
TaskEvaluate = ctypes.CFUNCTYPE(c_int32, c_void_p, c_void_p, ctypes.POINTER(TaskMoment), ctypes.POINTER(TaskVerdict))


class TaskField(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("ndim", c_uint32),
        ("name", c_char_p),
        ("unit", c_char_p),
        ("frame", c_char_p),
        ("shape", _Array),
        ("low", c_double),
        ("high", c_double),
    ]


class LoadReport(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("fresh", c_size_t),
        ("ignored", c_size_t),
        ("fresh_names", c_char_p),
        ("ignored_names", c_char_p),
    ]


class RecorderConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("compression", c_uint32),
        ("keep", c_char_p),
        ("state_seconds", c_double),
        ("flush_seconds", c_double),
        ("configuration", c_char_p),
        ("seed", c_uint64),
        ("hdf5", c_char_p),
        ("replace", c_uint32),
        ("reserved", c_uint32),
    ]


class RecordingInfo(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("format_version", c_uint32),
        ("same_build", c_uint32),
        ("reserved", c_uint32),
        ("steps", c_size_t),
        ("states", c_size_t),
        ("actions", c_size_t),
        ("agents", c_size_t),
        ("bodies", c_size_t),
        ("step_seconds", c_double),
        ("build", c_char_p),
        ("this_build", c_char_p),
        ("configuration", c_char_p),
        ("seed", c_char_p),
    ]


class ReplayReport(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("identical", c_uint32),
        ("next", c_size_t),
        ("steps", c_size_t),
        ("first_difference", c_size_t),
        ("largest_difference", c_double),
        ("differs_most_in", c_char_p),
    ]


class SensesConfig(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("mujoco_version", c_int32),
        ("model_size", c_size_t),
        ("data_size", c_size_t),
        ("step", c_double),
        ("renderer", c_char_p),
        ("log", LogFunction),
        ("log_user", c_void_p),
        ("render", c_uint32),
        ("samples", c_uint32),
        ("render_threads", c_uint32),
        ("reserved", c_uint32),
    ]


class Task(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("user", c_void_p),
        ("memory_bytes", c_size_t),
        ("reset", TaskReset),
        ("evaluate", TaskEvaluate),
        ("terms", _Out_text),
        ("term_count", c_size_t),
        ("fields", ctypes.POINTER(TaskField)),
        ("field_count", c_size_t),
    ]


def _config(struct: Any) -> Any:
    return ctypes.POINTER(struct)


# name: (result, arguments)
FUNCTIONS: Dict[str, Tuple[Any, List[Any]]] = {
    "mimo_abi_version": (c_uint32, []),
    "mimo_api_version": (c_uint32, []),
    "mimo_supports": (c_int32, [c_char_p]),
    "mimo_version": (c_char_p, []),
    "mimo_mujoco_version": (c_char_p, []),
    "mimo_status_name": (c_char_p, [_status]),
    "mimo_last_error": (c_char_p, []),
    "mimo_last_error_of": (_status, [c_void_p, c_char_p, c_size_t, _Out_size]),
    "mimo_fail": (_status, [_status, c_char_p]),
    "mimo_scene_config_init": (_status, [_config(SceneConfig), c_size_t]),
    "mimo_scene_name": (c_char_p, [c_size_t]),
    "mimo_scene_create": (_status, [_config(SceneConfig), _Out_handle]),
    "mimo_scene_destroy": (None, [_Handle]),
    "mimo_room_name": (c_char_p, [c_size_t]),
    "mimo_scene_set_room": (_status, [_Handle, c_char_p]),
    "mimo_agent_config_init": (_status, [_config(AgentConfig), c_size_t]),
    "mimo_scene_default_agent": (_status, [_Handle, _config(AgentConfig), c_size_t]),
    "mimo_scene_add_agent": (_status, [_Handle, _config(AgentConfig), _Out_size]),
    "mimo_scene_add_agents": (_status, [_Handle, _config(AgentConfig), _Out_size]),
    "mimo_scene_set_touch": (_status, [_Handle, c_size_t, c_char_p, c_double]),
    "mimo_scene_read_joint": (_status, [_Handle, c_size_t, c_char_p]),
    "mimo_growth_init": (_status, [_config(Growth), c_size_t]),
    "mimo_limits_init": (_status, [_config(Limits), c_size_t]),
    "mimo_scene_limit_sense": (_status, [_Handle, c_size_t, c_char_p, _config(Limits)]),
    "mimo_scene_limit_motor": (_status, [_Handle, c_size_t, c_char_p, _config(Limits)]),
    "mimo_maturity_init": (_status, [_config(Maturity), c_size_t]),
    "mimo_maturity_at": (_status, [c_double, _config(Maturity), c_size_t]),
    "mimo_scene_set_sources": (_status, [_Handle, c_size_t, c_double]),
    "mimo_scene_direct_source": (_status, [_Handle, c_char_p, _Array, _Array, c_double]),
    "mimo_env_play": (_status, [_Handle, c_char_p, c_void_p, c_size_t, c_double]),
    "mimo_senses_play": (_status, [_Handle, c_char_p, c_void_p, c_size_t, c_double]),
    "mimo_scene_set_room_temperature": (_status, [_Handle, c_double]),
    "mimo_scene_set_temperature": (_status, [_Handle, c_char_p, c_double]),
    "mimo_scene_set_material": (_status, [_Handle, c_char_p, c_char_p]),
    "mimo_scene_set_maturity": (_status, [_Handle, c_size_t, _config(Maturity)]),
    "mimo_scene_set_sensory_delay": (_status, [_Handle, c_size_t, c_char_p, c_double]),
    "mimo_object_config_init": (_status, [_config(ObjectConfig), c_size_t]),
    "mimo_scene_add_object": (_status, [_Handle, _config(ObjectConfig)]),
    "mimo_model_config_init": (_status, [_config(ModelConfig), c_size_t]),
    "mimo_scene_add_model": (_status, [_Handle, _config(ModelConfig)]),
    "mimo_scene_weld": (_status, [_Handle, c_char_p, c_char_p, _Array]),
    "mimo_scene_lock": (_status, [_Handle, c_char_p, c_double]),
    "mimo_scene_set_pose": (_status, [_Handle, c_char_p, c_double]),
    "mimo_material_name": (c_char_p, [c_size_t]),
    "mimo_face_name": (c_char_p, [c_size_t]),
    "mimo_camera_config_init": (_status, [_config(CameraConfig), c_size_t]),
    "mimo_scene_add_camera": (_status, [_Handle, _config(CameraConfig)]),
    "mimo_scene_xml": (_status, [_Handle, c_char_p, c_size_t, _Out_size]),
    "mimo_task_name": (c_char_p, [c_size_t]),
    "mimo_parameter_count": (_status, [_Out_size]),
    "mimo_parameter_describe": (_status, [c_size_t, _config(Parameter)]),
    "mimo_scene_save": (_status, [_Handle, c_char_p]),
    "mimo_field_config_init": (_status, [_config(FieldConfig), c_size_t]),
    "mimo_scene_add_field": (_status, [_Handle, _config(FieldConfig)]),
    "mimo_scene_set_parameter": (_status, [_Handle, c_char_p, c_double]),
    "mimo_scene_get_parameter": (_status, [_Handle, c_char_p, _Out_f64]),
    "mimo_layout_describe": (_status, [_Handle, _config(LayoutInfo)]),
    "mimo_layout_field": (_status, [_Handle, c_size_t, _config(Field)]),
    "mimo_layout_find": (_status, [_Handle, c_char_p, _Out_size]),
    "mimo_layout_label": (_status, [_Handle, c_size_t, c_size_t, _Out_text]),
    "mimo_layout_delays": (_status, [_Handle, c_size_t, _Array, c_size_t]),
    "mimo_layout_directions": (_status, [_Handle, c_size_t, _Array, c_size_t]),
    "mimo_layout_receptor_width": (_status, [_Handle, c_size_t, c_int32, _Out_size]),
    "mimo_layout_receptors": (_status, [_Handle, c_size_t, c_int32, _Array, c_size_t]),
    "mimo_layout_action": (_status, [_Handle, c_size_t, _config(Action)]),
    "mimo_layout_term": (_status, [_Handle, c_size_t, _config(Term)]),
    "mimo_env_config_init": (_status, [_config(EnvConfig), c_size_t]),
    "mimo_env_create": (_status, [_Handle, _config(EnvConfig), _Out_handle]),
    "mimo_env_make": (_status, [c_char_p, _Out_handle]),
    "mimo_env_destroy": (None, [_Handle]),
    "mimo_env_layout": (_status, [_Handle, _Out_handle]),
    "mimo_env_task": (_status, [_Handle, _Out_text]),
    "mimo_env_frame_skip": (_status, [_Handle, _Out_u32]),
    "mimo_env_agent": (_status, [_Handle, c_size_t, _config(AgentInfo)]),
    "mimo_env_reset": (_status, [_Handle, _config(ResetConfig), c_void_p, c_size_t]),
    "mimo_env_step": (
        _status,
        [_Handle, _Array, c_size_t, c_void_p, c_size_t, _config(EnvResults)],
    ),
    "mimo_env_follow": (_status, [_Handle, _config(Movement), c_void_p, c_size_t]),
    "mimo_env_observe": (_status, [_Handle, c_void_p, c_size_t]),
    "mimo_env_physics_step": (_status, [_Handle, c_size_t]),
    "mimo_env_time": (_status, [_Handle, _Out_f64]),
    "mimo_env_timestep": (_status, [_Handle, _Out_f64]),
    "mimo_env_count": (_status, [_Handle, c_int32, _Out_size]),
    "mimo_env_find": (_status, [_Handle, c_int32, c_char_p, _Out_i32]),
    "mimo_env_name": (_status, [_Handle, c_int32, c_int32, _Out_text]),
    "mimo_env_body_of": (_status, [_Handle, c_int32, c_int32, _Out_i32]),
    "mimo_env_width": (_status, [_Handle, c_int32, _Array, c_size_t, _Out_size]),
    "mimo_env_get": (_status, [_Handle, c_int32, _Array, c_size_t, _Array, c_size_t]),
    "mimo_env_get_float": (_status, [_Handle, c_int32, _Array, c_size_t, _Array, c_size_t]),
    "mimo_env_set": (_status, [_Handle, c_int32, _Array, c_size_t, _Array, c_size_t]),
    "mimo_env_update": (_status, [_Handle]),
    "mimo_env_gaze": (_status, [_Handle, c_size_t, _config(Gaze)]),
    "mimo_env_look_angles": (
        _status,
        [_Handle, c_size_t, _Array, c_int32, _Array, _Array, c_size_t, _Out_size, _Array],
    ),
    "mimo_env_look_at": (_status, [_Handle, c_size_t, _Array, c_int32, _Array]),
    "mimo_picture_config_init": (_status, [_config(PictureConfig), c_size_t]),
    "mimo_env_render": (_status, [_Handle, _config(PictureConfig), _config(Picture)]),
    "mimo_env_project": (_status, [_Handle, _config(PictureConfig), _Array, c_size_t, _Array]),
    "mimo_convert_points": (_status, [c_int32, _Array, c_size_t]),
    "mimo_convert_directions": (_status, [c_int32, _Array, c_size_t]),
    "mimo_env_poses": (_status, [_Handle, c_int32, c_int32, _Array, c_size_t]),
    "mimo_mesh_init": (_status, [_config(Mesh), c_size_t]),
    "mimo_env_mesh": (_status, [_Handle, c_int32, _config(Mesh)]),
    "mimo_env_appearance": (_status, [_Handle, c_int32, _config(Appearance)]),
    "mimo_env_texture_count": (_status, [_Handle, _Out_size]),
    "mimo_env_texture": (_status, [_Handle, c_int32, _config(Texture)]),
    "mimo_env_light": (_status, [_Handle, c_int32, _config(Light)]),
    "mimo_env_timing": (_status, [_Handle, _config(Timing)]),
    "mimo_env_timing_reset": (_status, [_Handle]),
    "mimo_env_state_size": (_status, [_Handle, _Out_size]),
    "mimo_env_state_save": (_status, [_Handle, c_void_p, c_size_t]),
    "mimo_env_state_load": (_status, [_Handle, c_void_p, c_size_t, _config(LoadReport)]),
    "mimo_env_clone": (_status, [_Handle, _Out_handle]),
    "mimo_recorder_config_init": (_status, [_config(RecorderConfig), c_size_t]),
    "mimo_recorder_open": (_status, [_Handle, c_char_p, _config(RecorderConfig), _Out_handle]),
    "mimo_recorder_flush": (_status, [_Handle]),
    "mimo_recorder_close": (_status, [_Handle]),
    "mimo_recording_open": (_status, [c_char_p, c_char_p, _Out_handle]),
    "mimo_recording_destroy": (None, [_Handle]),
    "mimo_recording_describe": (_status, [_Handle, _config(RecordingInfo)]),
    "mimo_recording_size": (_status, [_Handle, c_char_p, _Out_size, _Out_size]),
    "mimo_recording_read": (_status, [_Handle, c_char_p, c_size_t, c_size_t, _Array, c_size_t]),
    "mimo_recording_seek": (_status, [_Handle, _Handle, c_size_t, c_uint32, _Out_size]),
    "mimo_recording_step": (_status, [_Handle, _Handle, c_void_p, c_size_t, _config(EnvResults)]),
    "mimo_recording_report": (_status, [_Handle, _config(ReplayReport)]),
    "mimo_batch_config_init": (_status, [_config(BatchConfig), c_size_t]),
    "mimo_batch_create": (
        _status,
        [_Handle, _config(EnvConfig), _config(BatchConfig), _Out_handle],
    ),
    "mimo_batch_destroy": (None, [_Handle]),
    "mimo_batch_size": (_status, [_Handle, _Out_size, _Out_size]),
    "mimo_batch_layout": (_status, [_Handle, _Out_handle]),
    "mimo_batch_world": (_status, [_Handle, c_size_t, _Out_handle]),
    "mimo_batch_world_error": (_status, [_Handle, c_size_t, _Out_i32, _Out_text]),
    "mimo_batch_reset": (_status, [_Handle, _config(BatchResetConfig), c_void_p, c_size_t]),
    "mimo_batch_step": (
        _status,
        [_Handle, _Array, c_size_t, c_void_p, c_size_t, _config(BatchResults)],
    ),
    "mimo_batch_send": (
        _status,
        [_Handle, _Array, c_size_t, c_void_p, c_size_t, _config(BatchResults)],
    ),
    "mimo_batch_receive": (_status, [_Handle]),
    "mimo_batch_observe": (_status, [_Handle, _Array, c_size_t, c_void_p, c_size_t]),
    "mimo_batch_get": (
        _status,
        [_Handle, c_int32, _Array, c_size_t, _Array, c_size_t, _Array, c_size_t],
    ),
    "mimo_batch_get_float": (
        _status,
        [_Handle, c_int32, _Array, c_size_t, _Array, c_size_t, _Array, c_size_t],
    ),
    "mimo_batch_set": (
        _status,
        [_Handle, c_int32, _Array, c_size_t, _Array, c_size_t, _Array, c_size_t],
    ),
    "mimo_batch_state_size": (_status, [_Handle, _Out_size]),
    "mimo_batch_state_save": (_status, [_Handle, _Array, c_size_t, c_void_p, c_size_t]),
    "mimo_batch_state_load": (
        _status,
        [_Handle, _Array, c_size_t, c_void_p, c_size_t, _config(LoadReport)],
    ),
    "mimo_task_field_init": (_status, [_config(TaskField), c_size_t]),
    "mimo_task_init": (_status, [_config(Task), c_size_t]),
    "mimo_scene_set_task": (_status, [_Handle, _config(Task)]),
    "mimo_env_random": (_status, [_Handle, _Array, c_size_t]),
    "mimo_senses_config_init": (_status, [_config(SensesConfig), c_size_t]),
    "mimo_senses_attach": (_status, [_Handle, c_void_p, _config(SensesConfig), _Out_handle]),
    "mimo_senses_destroy": (None, [_Handle]),
    "mimo_senses_layout": (_status, [_Handle, _Out_handle]),
    "mimo_senses_reset": (_status, [_Handle, c_void_p, _config(ResetConfig)]),
    "mimo_senses_advance": (_status, [_Handle, c_void_p]),
    "mimo_senses_drive_spindles": (_status, [_Handle, _Array, c_size_t, _Array, c_size_t]),
    "mimo_senses_observe": (_status, [_Handle, c_void_p, c_void_p, c_size_t]),
    "mimo_senses_state_size": (_status, [_Handle, _Out_size]),
    "mimo_senses_state_save": (_status, [_Handle, c_void_p, c_size_t]),
    "mimo_senses_state_load": (_status, [_Handle, c_void_p, c_size_t, _config(LoadReport)]),
}
