/* Faces, gaze and further cameras. See table.h. */

ROW(mimo_face_name, 0, check_list(mimo_face_name), NONE)
ROW(mimo_camera_config_init, 0, mimo_camera_config_init(a->camera_config, sizeof *a->camera_config + a->more_bytes),
    INIT(camera_config, mimo_camera_config, "config"))

#define CAMERA(f, n) BAD_FIELD(camera_config, mimo_camera_config, f, n, #f)
#define CAMERA_UNREAL(f) UNREAL(camera_config, mimo_camera_config, f, #f)
ROW(mimo_scene_add_camera, ON_SCENE, mimo_scene_add_camera(a->scene, a->camera_config),
    NO_NULL(camera_config, "config"), CONFIG(camera_config, mimo_camera_config, "config"), CAMERA(outputs, 0),
    CAMERA(outputs, 8), CAMERA(width, 0), CAMERA(width, 4097), CAMERA(height, 0), CAMERA(height, -1),
    CAMERA_UNREAL(fovy), CAMERA(placed, 2), CAMERA_UNREAL(position[0]), CAMERA_UNREAL(look_at[2]),
    {FAULT_FIELD_NULL, "name is NULL", MEMBER(camera_config), FIELD(mimo_camera_config, name), 0, 0, NULL, E_ARG,
     "name"},
    DO(unknown_carrier, MIMO_E_NOT_FOUND, "centaur"))

ROW(mimo_env_gaze, ON_ENV, mimo_env_gaze(a->env, a->agent_index, a->gaze), BAD_INDEX(agent_index, "agent"),
    DESCRIPTION(gaze, mimo_gaze, "gaze"))
#define LOOKS                                                                                                          \
  BAD_INDEX(agent_index, "agent"), NO_NULL(points, "point"), DO(nan_point, E_ARG, "point[0]"), BAD_I32(how, 2, "how"), \
      BAD_IDS(how, "how"), NULL_OK(numbers)
ROW(mimo_env_look_angles, ON_ENV | SIMULATES,
    mimo_env_look_angles(a->env, a->agent_index, a->points, a->how, a->contact_ids, a->contact_values, MIMO_LOOK_JOINTS,
                         a->count, a->numbers),
    LOOKS, NULL_OK(contact_ids), NULL_OK(contact_values), NULL_OK(count))
ROW(mimo_env_look_at, ON_ENV | SIMULATES, mimo_env_look_at(a->env, a->agent_index, a->points, a->how, a->numbers),
    LOOKS)

ROW(mimo_env_set_face, ON_ENV, mimo_env_set_face(a->env, a->agent_index, a->face), BAD_INDEX(agent_index, "agent"),
    NO_NULL(face, "name"), DO(unknown_face, MIMO_E_NOT_FOUND, "bored"))
ROW(mimo_env_face, ON_ENV, mimo_env_face(a->env, a->agent_index, a->string), BAD_INDEX(agent_index, "agent"),
    NO_NULL(string, "name"))
ROW(mimo_batch_set_face, ON_BATCH, mimo_batch_set_face(a->batch, a->agent_index, a->face, a->mask, a->worlds),
    BAD_INDEX(agent_index, "agent"), NO_NULL(face, "name"), WORLDS, DO(unknown_face, MIMO_E_NOT_FOUND, "bored"))
