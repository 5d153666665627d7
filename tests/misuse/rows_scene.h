/* Versions, configs, scenes, agents, objects, tasks. See table.h. */

ROW(mimo_abi_version, 0, CHECKED(mimo_abi_version() == MIMO_ABI_VERSION), NONE)
ROW(mimo_api_version, 0, CHECKED(mimo_api_version() == MIMO_API_VERSION), NONE)
ROW(mimo_supports, 0,
    CHECKED(mimo_supports(NULL) == 0 && mimo_supports("") == 0 && mimo_supports("mimo_supports") == 1), NONE)
ROW(mimo_version, 0, CHECKED(is_version(mimo_version())), NONE)
ROW(mimo_mujoco_version, 0, CHECKED(is_version(mimo_mujoco_version())), NONE)
ROW(mimo_status_name, 0, check_status_names(), NONE)
ROW(mimo_last_error, 0, CHECKED(mimo_last_error() != NULL), NONE)
ROW(mimo_last_error_of, 0, last_error_of(a), NO_NULL(text, "text"), BAD_SIZE(capacity, -1, "text"), NULL_OK(count))
ROW(mimo_fail, 0, CHECKED(mimo_fail(MIMO_E_RENDER, "why") == MIMO_E_RENDER), NONE)
ROW(mimo_scene_name, 0, check_list(mimo_scene_name), NONE)
ROW(mimo_room_name, 0, check_list(mimo_room_name), NONE)
ROW(mimo_task_name, 0, check_list(mimo_task_name), NONE)
ROW(mimo_face_name, 0, check_list(mimo_face_name), NONE)

ROW(mimo_scene_config_init, 0, mimo_scene_config_init(a->scene_config, sizeof *a->scene_config + a->more_bytes),
    INIT(scene_config, mimo_scene_config, "config"))
ROW(mimo_agent_config_init, 0, mimo_agent_config_init(a->agent_config, sizeof *a->agent_config + a->more_bytes),
    INIT(agent_config, mimo_agent_config, "config"))
ROW(mimo_object_config_init, 0, mimo_object_config_init(a->object_config, sizeof *a->object_config + a->more_bytes),
    INIT(object_config, mimo_object_config, "config"))
ROW(mimo_env_config_init, 0, mimo_env_config_init(a->env_config, sizeof *a->env_config + a->more_bytes),
    INIT(env_config, mimo_env_config, "config"))
ROW(mimo_batch_config_init, 0, mimo_batch_config_init(a->batch_config, sizeof *a->batch_config + a->more_bytes),
    INIT(batch_config, mimo_batch_config, "config"))
ROW(mimo_picture_config_init, 0, mimo_picture_config_init(a->picture_config, sizeof *a->picture_config + a->more_bytes),
    INIT(picture_config, mimo_picture_config, "config"))
ROW(mimo_camera_config_init, 0, mimo_camera_config_init(a->camera_config, sizeof *a->camera_config + a->more_bytes),
    INIT(camera_config, mimo_camera_config, "config"))
ROW(mimo_model_config_init, 0, mimo_model_config_init(a->model_config, sizeof *a->model_config + a->more_bytes),
    INIT(model_config, mimo_model_config, "config"))
ROW(mimo_task_field_init, 0, mimo_task_field_init(a->task_field, sizeof *a->task_field + a->more_bytes),
    INIT(task_field, mimo_task_field, "field"))
ROW(mimo_task_init, 0, mimo_task_init(a->task, sizeof *a->task + a->more_bytes), INIT(task, mimo_task, "task"))

ROW(mimo_growth_init, 0, mimo_growth_init(a->growth, sizeof *a->growth + a->more_bytes),
    INIT(growth, mimo_growth, "growth"))
ROW(mimo_limits_init, 0, mimo_limits_init(a->limits, sizeof *a->limits + a->more_bytes),
    INIT(limits, mimo_limits, "limits"))
ROW(mimo_maturity_init, 0, mimo_maturity_init(a->maturity, sizeof *a->maturity + a->more_bytes),
    INIT(maturity, mimo_maturity, "maturity"))
ROW(mimo_maturity_at, 0, mimo_maturity_at(a->growth->age, a->maturity, sizeof *a->maturity + a->more_bytes),
    INIT(maturity, mimo_maturity, "maturity"), UNREAL(growth, mimo_growth, age, "age"),
    BAD_REAL(growth, mimo_growth, age, -0.01, "age"), BAD_REAL(growth, mimo_growth, age, 24.01, "age"))

ROW(mimo_scene_create, 0, mimo_scene_create(a->scene_config, a->made_scene), NULL_OK(scene_config),
    NO_NULL(made_scene, "scene"), CONFIG(scene_config, mimo_scene_config, "config"),
    UNKNOWN_FIELD(scene_config, mimo_scene_config, reserved, 1, "reserved"),
    UNKNOWN_FIELD(scene_config, mimo_scene_config, confined, 2, "confined"),
    UNKNOWN_FIELD(scene_config, mimo_scene_config, limits_reserved, 1, "limits_reserved"),
    DO(unknown_scene, MIMO_E_NOT_FOUND, "nowhere"), DO(two_sources, E_ARG, "exclude each other"),
    DO(no_file, MIMO_E_NOT_FOUND, "no_such_file"), DO(no_xml, MIMO_E_MODEL, "xml text"),
    DO(not_mjcf, MIMO_E_MODEL, "root element"), DO(deep_xml, MIMO_E_MODEL, "nested"),
    DO(no_model_dir, MIMO_E_NOT_FOUND, "model_dir"))
ROW(mimo_scene_destroy, ON_SCENE | ON_ENV | ON_BATCH | DESTROYS, check_destroy_scene(a), NONE)

#define AGENT_REAL(f, ...) BAD_REAL(agent_config, mimo_agent_config, f, __VA_ARGS__)
#define AGENT(f, n) BAD_FIELD(agent_config, mimo_agent_config, f, n, #f)
#define AGENT_UNKNOWN(f, n) UNKNOWN_FIELD(agent_config, mimo_agent_config, f, n, #f)
#define GROWTH_REAL(f, n) BAD_REAL(growth, mimo_growth, f, n, #f)
#define GROWTH_RANGE(f, low, high) UNREAL(growth, mimo_growth, f, #f), GROWTH_REAL(f, low), GROWTH_REAL(f, high)
#define GROWTH_UNKNOWN(f, n) UNKNOWN_FIELD(growth, mimo_growth, f, n, #f)
#define GROWTH                                                                                                     \
  CONFIG(growth, mimo_growth, "growth"), GROWTH_RANGE(age, -0.01, 24.01), GROWTH_UNKNOWN(sex, 3),                  \
      GROWTH_UNKNOWN(sex, -1), GROWTH_UNKNOWN(matures_apart, 2), GROWTH_UNKNOWN(model, 2),                         \
      GROWTH_RANGE(z_length, -3.01, 3.01), GROWTH_RANGE(z_weight, -3.01, 3.01), GROWTH_RANGE(z_head, -3.01, 3.01), \
      GROWTH_RANGE(percentile, 0.13, 99.87), GROWTH_RANGE(strength_exponent, -0.1, 5.1),                           \
      GROWTH_RANGE(neck_strength, -0.1, 10.1), GROWTH_RANGE(birth_tone, 0.09, 10.1),                               \
      GROWTH_RANGE(contracture, -0.1, 1.1), GROWTH_UNKNOWN(absolute, 2), GROWTH_UNKNOWN(keep_spacing, 2),          \
      GROWTH_UNKNOWN(maturity, 0x20), BAD_FIELD(growth, mimo_growth, maturity, 8, "maturity"),                     \
      GROWTH_UNKNOWN(maturity, -1), GROWTH_UNKNOWN(reserved, 1)
ROW(mimo_scene_default_agent, ON_SCENE,
    mimo_scene_default_agent(a->scene, a->agent_config, sizeof *a->agent_config + a->more_bytes),
    INIT(agent_config, mimo_agent_config, "config"))
ROW(mimo_scene_add_agent, ON_ROOM, mimo_scene_add_agent(a->room, a->agent_config, a->count), NULL_OK(agent_config),
    NULL_OK(count), CONFIG(agent_config, mimo_agent_config, "config"), AGENT_UNKNOWN(place, 4),
    UNREAL(agent_config, mimo_agent_config, position[1], "position[1]"),
    UNREAL(agent_config, mimo_agent_config, orientation[2], "orientation[2]"), DO(no_orientation, E_ARG, "orientation"),
    AGENT_UNKNOWN(proprioception, 0x800), AGENT_UNKNOWN(proprioception, -1), AGENT_UNKNOWN(vestibular, 32),
    UNREAL(agent_config, mimo_agent_config, limit_threshold, "limit_threshold"),
    AGENT_REAL(limit_threshold, 0, "limit"), AGENT_UNKNOWN(vision, 8), AGENT(vision_width, 0),
    AGENT(vision_width, 4097), AGENT(vision_width, -1), AGENT(vision_height, 0), AGENT(vision_height, 4097),
    AGENT_UNKNOWN(actuation, 4), UNREAL(agent_config, mimo_agent_config, vision_fovy, "vision_fovy"),
    AGENT_REAL(vision_fovy, 171, "vision_fovy"), UNREAL(agent_config, mimo_agent_config, vision_foveation, "foveation"),
    AGENT_REAL(vision_foveation, 101, "vision_foveation"), AGENT_UNKNOWN(acts, 0x800), AGENT(acts, 0x40000001),
    AGENT_UNKNOWN(acts, 0x80000800), AGENT_UNKNOWN(normalize_actions, 2), AGENT_UNKNOWN(touch, 0x8000), AGENT(touch, 3),
    AGENT_UNKNOWN(touch_response, 0), AGENT_UNKNOWN(touch_response, 4), AGENT_UNKNOWN(touch_frame, 0),
    AGENT_UNKNOWN(touch_frame, -1), AGENT_UNKNOWN(hearing, 4), AGENT_UNKNOWN(voice, 2), AGENT_UNKNOWN(reflexes, 0x80),
    AGENT_UNKNOWN(reflexes, 0x80000080), DO(root_with_reflexes, E_ARG, "reflexes"),
    UNREAL(agent_config, mimo_agent_config, touch_scale, "touch_scale"), AGENT_REAL(touch_scale, -1, "touch_scale"),
    UNREAL(agent_config, mimo_agent_config, touch_slip_threshold, "touch_slip_threshold"),
    AGENT_REAL(touch_slip_threshold, -1, "touch_slip_threshold"),
    UNREAL(agent_config, mimo_agent_config, strength, "strength"), AGENT_REAL(strength, -1, "strength"),
    AGENT_REAL(strength, 101, "strength"), DO(bad_agent_name, E_ARG, "an na"),
    DO(unknown_body, MIMO_E_NOT_FOUND, "centaur"), DO(taken_agent, E_ARG, "name"),
    DO(root_and_body, E_ARG, "root is \"torso\""), DO(root_and_groups, E_ARG, "acts"), GROWTH,
    DO(apart, E_ARG, "physiological_age"), DO(two_measures, E_ARG, "percentile"))
ROW(mimo_scene_add_agents, ON_ROOM, mimo_scene_add_agents(a->room, a->agent_config, a->count), NULL_OK(agent_config),
    NULL_OK(count), CONFIG(agent_config, mimo_agent_config, "config"), AGENT_UNKNOWN(place, 4),
    AGENT_UNKNOWN(vision, 8), UNREAL(agent_config, mimo_agent_config, position[1], "position[1]"),
    DO(bad_agent_name, E_ARG, "an na"), DO(unknown_body, MIMO_E_NOT_FOUND, "centaur"), DO(taken_agent, E_ARG, "name"))
ROW(mimo_scene_set_touch, ON_SCENE, mimo_scene_set_touch(a->scene, a->agent_index, a->part, a->spacing), NULL_OK(part),
    BAD_SIZE(agent_index, 1, "agent"), BAD_INDEX(agent_index, "agent"), NOT_FINITE(spacing, "spacing"),
    BAD_F64(spacing, -1, "spacing"), DO(unknown_part, MIMO_E_NOT_FOUND, "tail"))
ROW(mimo_material_name, 0, check_list(mimo_material_name), NONE)
ROW(mimo_scene_set_room_temperature, ON_SCENE, mimo_scene_set_room_temperature(a->scene, a->spacing),
    NOT_FINITE(spacing, "celsius"), BAD_F64(spacing, -41, "celsius"), BAD_F64(spacing, 81, "celsius"))
ROW(mimo_scene_set_temperature, ON_SCENE, mimo_scene_set_temperature(a->scene, a->part, a->spacing),
    NO_NULL(part, "body"), NOT_FINITE(spacing, "celsius"), BAD_F64(spacing, -273.16, "celsius"),
    BAD_F64(spacing, 1001, "celsius"))
ROW(mimo_scene_set_material, ON_SCENE, mimo_scene_set_material(a->scene, a->part, "cork"), NO_NULL(part, "body"))
ROW(mimo_scene_set_sources, ON_SCENE, mimo_scene_set_sources(a->scene, a->steps, a->spacing),
    BAD_SIZE(steps, 65, "count"), BAD_SIZE(steps, -1, "count"), NOT_FINITE(spacing, "seconds"),
    BAD_F64(spacing, -1, "seconds"), BAD_F64(spacing, 601, "seconds"))
ROW(mimo_scene_direct_source, ON_SCENE,
    mimo_scene_direct_source(a->scene, a->part, a->pose, a->pose == NULL ? NULL : a->pose + 1, a->spacing),
    NO_NULL(part, "body"), NO_NULL(pose, "place"), NOT_FINITE(spacing, "directivity"),
    BAD_F64(spacing, -0.1, "directivity"), BAD_F64(spacing, 1.1, "directivity"))
ROW(mimo_scene_read_joint, ON_SCENE, mimo_scene_read_joint(a->scene, a->agent_index, a->name),
    BAD_SIZE(agent_index, 1, "agent"), BAD_INDEX(agent_index, "agent"), NO_NULL(name, "joint"),
    DO(empty_name, E_ARG, "joint"), DO(same_joint, E_ARG, "already"))
#define LIMITS_REAL(f, n) BAD_REAL(limits, mimo_limits, f, n, #f)
#define LIMITS                                                                                         \
  NULL_OK(limits), CONFIG(limits, mimo_limits, "limits"), UNREAL(limits, mimo_limits, delay, "delay"), \
      LIMITS_REAL(delay, -0.01), LIMITS_REAL(delay, 2.01), UNREAL(limits, mimo_limits, gain, "gain"),  \
      LIMITS_REAL(gain, -1), UNREAL(limits, mimo_limits, noise, "noise"), LIMITS_REAL(noise, -0.5),    \
      UNREAL(limits, mimo_limits, blur, "blur"), LIMITS_REAL(blur, -1), LIMITS_REAL(blur, 0.01),       \
      LIMITS_REAL(blur, 1001), UNREAL(limits, mimo_limits, signal_noise, "signal_noise"),              \
      LIMITS_REAL(signal_noise, -1), LIMITS_REAL(signal_noise, 1001),                                  \
      UNKNOWN_FIELD(limits, mimo_limits, reserved, 1, "reserved")
ROW(mimo_scene_limit_sense, ON_SCENE, mimo_scene_limit_sense(a->scene, a->agent_index, a->path, a->limits),
    BAD_SIZE(agent_index, 1, "agent"), BAD_INDEX(agent_index, "agent"), NO_NULL(path, "path"), LIMITS)
ROW(mimo_scene_limit_motor, ON_SCENE, mimo_scene_limit_motor(a->scene, a->agent_index, a->motor_path, a->limits),
    BAD_SIZE(agent_index, 1, "agent"), BAD_INDEX(agent_index, "agent"), NO_NULL(motor_path, "path"), LIMITS,
    BAD_REAL(limits, mimo_limits, blur, 1, "blur"))
#define MATURITY_RANGE(f, low, high)                                                     \
  UNREAL(maturity, mimo_maturity, f, #f), BAD_REAL(maturity, mimo_maturity, f, low, #f), \
      BAD_REAL(maturity, mimo_maturity, f, high, #f)
ROW(mimo_scene_set_maturity, ON_SCENE, mimo_scene_set_maturity(a->scene, a->agent_index, a->maturity),
    BAD_SIZE(agent_index, 1, "agent"), BAD_INDEX(agent_index, "agent"), NULL_OK(maturity),
    CONFIG(maturity, mimo_maturity, "maturity"),
    UNKNOWN_FIELD(maturity, mimo_maturity, contrast_threshold, 2, "contrast_threshold"),
    MATURITY_RANGE(acuity, 0.04, 1001), MATURITY_RANGE(peak_contrast, 1, 1001), MATURITY_RANGE(chroma, -0.01, 1.01),
    MATURITY_RANGE(flicker, 0.009, 1001), MATURITY_RANGE(conduction_speed, 0.09, 201),
    MATURITY_RANGE(sensory_delay, -0.01, 2.01), MATURITY_RANGE(motor_delay, -0.01, 2.01),
    MATURITY_RANGE(vision_delay, -0.01, 2.01), MATURITY_RANGE(vestibular_delay, -0.01, 2.01),
    MATURITY_RANGE(hearing_delay, -0.01, 2.01))
ROW(mimo_scene_set_sensory_delay, ON_SCENE, mimo_scene_set_sensory_delay(a->scene, a->agent_index, a->part, a->spacing),
    NULL_OK(part), BAD_SIZE(agent_index, 1, "agent"), BAD_INDEX(agent_index, "agent"), NOT_FINITE(spacing, "seconds"),
    BAD_F64(spacing, -1, "seconds"), BAD_F64(spacing, 2.01, "seconds"), DO(unknown_part, MIMO_E_NOT_FOUND, "tail"))

#define OBJECT(f, n) BAD_FIELD(object_config, mimo_object_config, f, n, #f)
#define OBJECT_UNKNOWN(f, n) UNKNOWN_FIELD(object_config, mimo_object_config, f, n, #f)
#define OBJECT_REAL(f, n) BAD_REAL(object_config, mimo_object_config, f, n, #f)
#define OBJECT_UNREAL(f) UNREAL(object_config, mimo_object_config, f, #f)
ROW(mimo_scene_add_object, ON_SCENE, mimo_scene_add_object(a->scene, a->object_config),
    NO_NULL(object_config, "config"), CONFIG(object_config, mimo_object_config, "config"), OBJECT_UNKNOWN(shape, 0),
    OBJECT_UNKNOWN(shape, 6), OBJECT_UNKNOWN(shape, -1), OBJECT_UNREAL(size[0]), OBJECT_REAL(size[0], 0),
    OBJECT_REAL(size[0], -1), OBJECT_UNREAL(position[0]), OBJECT_UNREAL(orientation[3]), OBJECT_UNREAL(mass),
    OBJECT_REAL(mass, -1), OBJECT_UNREAL(rgba[3]), OBJECT_REAL(rgba[0], 2), OBJECT_REAL(rgba[0], -1),
    OBJECT_UNKNOWN(fixed, 2), OBJECT_UNKNOWN(reserved, 1),
    {FAULT_FIELD_NULL, "name is NULL", MEMBER(object_config), FIELD(mimo_object_config, name), 0, 0, NULL, E_ARG,
     "name"},
    DO(taken_object, E_ARG, "toy"))
#define MODEL_UNREAL(f) UNREAL(model_config, mimo_model_config, f, #f)
ROW(mimo_scene_add_model, ON_SCENE, mimo_scene_add_model(a->scene, a->model_config), NO_NULL(model_config, "config"),
    CONFIG(model_config, mimo_model_config, "config"),
    UNKNOWN_FIELD(model_config, mimo_model_config, fixed, 2, "fixed"), MODEL_UNREAL(position[2]),
    MODEL_UNREAL(orientation[0]),
    {FAULT_FIELD_NULL, "name is NULL", MEMBER(model_config), FIELD(mimo_model_config, name), 0, 0, NULL, E_ARG, "name"},
    {FAULT_FIELD_NULL, "xml is NULL", MEMBER(model_config), FIELD(mimo_model_config, xml), 0, 0, NULL, E_ARG, "xml"},
    DO(bad_model_name, E_ARG, "te/a"), DO(taken_model, E_ARG, "toy"), DO(two_models, E_ARG, "both"),
    DO(no_model_file, MIMO_E_NOT_FOUND, "no_such_file"), DO(two_bodies, MIMO_E_MODEL, "2 bodies"))
ROW(mimo_scene_set_room, ON_EMPTY, mimo_scene_set_room(a->room, a->room_name), NO_NULL(room_name, "name"),
    DO(unknown_room, MIMO_E_NOT_FOUND, "attic"), DO(second_room, E_ARG, "room already"))
ROW(mimo_scene_weld, ON_SCENE, mimo_scene_weld(a->scene, a->part, a->other, a->pose), NO_NULL(part, "body"),
    NULL_OK(other), NULL_OK(pose), DO(unknown_part, MIMO_E_NOT_FOUND, "tail"),
    DO(unknown_other, MIMO_E_NOT_FOUND, "ghost"), DO(weld_to_itself, E_ARG, "head"), DO(pose_of_nan, E_ARG, "pose[6]"),
    DO(pose_of_zeros, E_ARG, "orientation"))
#define JOINT_FAULTS                                                                                        \
  NO_NULL(joint_name, "joint"), NOT_FINITE(angle, "robot:head_tilt"), BAD_F64(angle, 9, "robot:head_tilt"), \
      DO(unknown_joint, MIMO_E_NOT_FOUND, "tail")
ROW(mimo_scene_lock, ON_SCENE, mimo_scene_lock(a->scene, a->joint_name, a->angle), JOINT_FAULTS)
ROW(mimo_scene_set_pose, ON_SCENE, mimo_scene_set_pose(a->scene, a->joint_name, a->angle), JOINT_FAULTS)
#define CAMERA(f, n) BAD_FIELD(camera_config, mimo_camera_config, f, n, #f)
#define CAMERA_UNKNOWN(f, n) UNKNOWN_FIELD(camera_config, mimo_camera_config, f, n, #f)
#define CAMERA_UNREAL(f) UNREAL(camera_config, mimo_camera_config, f, #f)
ROW(mimo_scene_add_camera, ON_SCENE, mimo_scene_add_camera(a->scene, a->camera_config),
    NO_NULL(camera_config, "config"), CONFIG(camera_config, mimo_camera_config, "config"), CAMERA(outputs, 0),
    CAMERA_UNKNOWN(outputs, 8), CAMERA_UNKNOWN(outputs, -1), CAMERA(width, 0), CAMERA(width, 4097), CAMERA(height, 0),
    CAMERA(height, 4097), CAMERA(height, -1), CAMERA_UNREAL(fovy),
    BAD_REAL(camera_config, mimo_camera_config, fovy, 171, "fovy"), CAMERA_UNKNOWN(placed, 2),
    CAMERA_UNKNOWN(reserved, 1), CAMERA_UNREAL(position[1]), CAMERA_UNREAL(look_at[2]),
    {FAULT_FIELD_NULL, "name is NULL", MEMBER(camera_config), FIELD(mimo_camera_config, name), 0, 0, NULL, E_ARG,
     "name"},
    DO(no_camera_body, MIMO_E_NOT_FOUND, "ghost"), DO(watched_already, E_ARG, "watcher"))
ROW(mimo_field_config_init, 0, mimo_field_config_init(a->field_config, sizeof *a->field_config + a->more_bytes),
    INIT(field_config, mimo_field_config, "config"))
#define QUANTITY_FIELD(n, status)                                                                                     \
  {                                                                                                                   \
    FAULT_FIELD_I32, "quantity is " #n, MEMBER(field_config), FIELD(mimo_field_config, quantity), n, 0, NULL, status, \
        "quantity"                                                                                                    \
  }
ROW(mimo_scene_add_field, ON_SCENE, mimo_scene_add_field(a->scene, a->field_config), NO_NULL(field_config, "config"),
    CONFIG(field_config, mimo_field_config, "config"), QUANTITY_FIELD(0, MIMO_E_UNSUPPORTED),
    QUANTITY_FIELD(-1, MIMO_E_UNSUPPORTED), QUANTITY_FIELD(0x1ff, MIMO_E_UNSUPPORTED), QUANTITY_FIELD(MIMO_BODY, E_ARG),
    QUANTITY_FIELD(MIMO_CONTACT_FORCE, E_ARG), QUANTITY_FIELD(MIMO_SENSOR_VALUE | MIMO_NOW, E_ARG),
    {FAULT_FIELD_NULL, "name is NULL", MEMBER(field_config), FIELD(mimo_field_config, name), 0, 0, NULL, E_ARG, "name"},
    {FAULT_FIELD_NULL, "elements is NULL", MEMBER(field_config), FIELD(mimo_field_config, elements), 0, 0, NULL, E_ARG,
     "elements"},
    {FAULT_FIELD_SIZE, "no elements", MEMBER(field_config), FIELD(mimo_field_config, element_count), 0, 0, NULL, E_ARG,
     "element_count"},
    {FAULT_FIELD_SIZE, "huge elements", MEMBER(field_config), FIELD(mimo_field_config, element_count), -1, 0, NULL,
     E_ARG, "elements"},
    DO(requested_already, E_ARG, "toy/place"), DO(no_frame, E_ARG, "relative_to"))
#undef QUANTITY_FIELD
ROW(mimo_scene_xml, ON_SCENE, mimo_scene_xml(a->scene, a->text, a->capacity, a->count), NULL_OK(count),
    NO_NULL(text, "text"), SHORT(capacity, "text"), DO(no_text, MIMO_OK, NULL))
ROW(mimo_scene_save, ON_SCENE, mimo_scene_save(a->scene, a->folder), NO_NULL(folder, "folder"),
    DO(folder_in_a_file, MIMO_E_FILE, "cannot be made"))
ROW(mimo_parameter_count, 0, mimo_parameter_count(a->count), NO_NULL(count, "count"))
ROW(mimo_parameter_describe, 0, mimo_parameter_describe(a->index, a->parameter), BAD_INDEX(index, "index"),
    DESCRIPTION(parameter, mimo_parameter, "parameter"))
ROW(mimo_scene_set_parameter, ON_SCENE, mimo_scene_set_parameter(a->scene, a->parameter_name, a->value),
    NO_NULL(parameter_name, "name"), NOT_FINITE(value, "reach/"), BAD_F64(value, 1e300, "reach/"),
    DO(unknown_parameter, MIMO_E_NOT_FOUND, "mood"))
ROW(mimo_scene_get_parameter, ON_SCENE, mimo_scene_get_parameter(a->scene, a->parameter_name, a->number),
    NO_NULL(parameter_name, "name"), NO_NULL(number, "value"), DO(unknown_parameter, MIMO_E_NOT_FOUND, "mood"))
ROW(mimo_scene_behaviour, ON_BEHAVIOUR, mimo_scene_behaviour(a->room, a->behaviour),
    DESCRIPTION(behaviour, mimo_behaviour, "behaviour"))
ROW(mimo_scene_set_task, ON_SCENE, mimo_scene_set_task(a->scene, a->task), NULL_OK(task),
    CONFIG(task, mimo_task, "task"), UNKNOWN_FIELD(task, mimo_task, reserved, 1, "reserved"),
    {FAULT_FIELD_SIZE, "memory", MEMBER(task), FIELD(mimo_task, memory_bytes), 1048577, 0, NULL, E_ARG, "memory_bytes"},
    {FAULT_FIELD_SIZE, "huge memory", MEMBER(task), FIELD(mimo_task, memory_bytes), -1, 0, NULL, E_ARG, "memory_bytes"},
    {FAULT_FIELD_SIZE, "many terms", MEMBER(task), FIELD(mimo_task, term_count), 1001, 0, NULL, E_ARG, "terms"},
    {FAULT_FIELD_SIZE, "huge terms", MEMBER(task), FIELD(mimo_task, term_count), -1, 0, NULL, E_ARG, "terms"},
    {FAULT_FIELD_SIZE, "many fields", MEMBER(task), FIELD(mimo_task, field_count), 1001, 0, NULL, E_ARG, "fields"},
    {FAULT_FIELD_SIZE, "huge fields", MEMBER(task), FIELD(mimo_task, field_count), -1, 0, NULL, E_ARG, "fields"},
    {FAULT_FIELD_NULL, "terms is NULL", MEMBER(task), FIELD(mimo_task, terms), 0, 0, NULL, E_ARG, "terms"},
    {FAULT_FIELD_NULL, "fields is NULL", MEMBER(task), FIELD(mimo_task, fields), 0, 0, NULL, E_ARG, "fields"},
    CONFIG(task_field, mimo_task_field, "fields[0]"), BAD_FIELD(task_field, mimo_task_field, ndim, 5, "ndim"),
    {FAULT_FIELD_NULL, "no name", MEMBER(task_field), FIELD(mimo_task_field, name), 0, 0, NULL, E_ARG, "name"},
    {FAULT_FIELD_NULL, "no shape", MEMBER(task_field), FIELD(mimo_task_field, shape), 0, 0, NULL, E_ARG, "shape"},
    BAD_REAL(task_field, mimo_task_field, low, NAN, "low"), BAD_REAL(task_field, mimo_task_field, high, NAN, "high"),
    BAD_REAL(task_field, mimo_task_field, low, 9, "low"), DO(no_evaluate, E_ARG, "evaluate"))

#define ENV(f, n) BAD_FIELD(env_config, mimo_env_config, f, n, #f)
#define ENV_UNKNOWN(f, n) UNKNOWN_FIELD(env_config, mimo_env_config, f, n, #f)
ROW(mimo_env_create, ON_SCENE, mimo_env_create(a->scene, a->env_config, a->made_env), NULL_OK(env_config),
    NO_NULL(made_env, "env"), CONFIG(env_config, mimo_env_config, "config"), ENV(frame_skip, 1001), ENV(frame_skip, -1),
    ENV_UNKNOWN(jacobian, 3), ENV_UNKNOWN(jacobian, -1), ENV_UNKNOWN(disable, 8), ENV_UNKNOWN(disable, -1),
    ENV_UNKNOWN(timing, 2), ENV_UNKNOWN(render, 32), ENV(samples, 2), ENV(samples, -1), ENV(render_threads, 65),
    ENV(render_threads, -1), ENV_UNKNOWN(step_contacts, 2), DO(unknown_renderer, E_ARG, "crayons"),
    DO(unknown_task, MIMO_E_NOT_FOUND, "homework"), DO(no_custom_task, MIMO_E_NOT_FOUND, "custom"),
    DO(no_renderer, E_ARG, "renderer"))
ROW(mimo_env_make, 0, mimo_env_make(a->scene_name, a->made_env), NO_NULL(scene_name, "scene_name"),
    NO_NULL(made_env, "env"), DO(unknown_scene_name, MIMO_E_NOT_FOUND, "nowhere"),
    DO(no_scene_name, E_ARG, "scene_name"))
