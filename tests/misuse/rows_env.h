/* Environments: stepping, named access, pictures, rewards, overrides, state. See table.h. */

ROW(mimo_env_destroy, ON_SCENE | ON_ENV | ON_BATCH | DESTROYS, check_destroy_env(a), NONE)
ROW(mimo_env_task, ON_ENV, mimo_env_task(a->env, a->string), NO_NULL(string, "name"))
ROW(mimo_env_frame_skip, ON_ENV, mimo_env_frame_skip(a->env, a->u32_out), NO_NULL(u32_out, "frame_skip"))
ROW(mimo_env_agent, ON_ENV, mimo_env_agent(a->env, a->index, a->info), BAD_SIZE(index, 1, "index"),
    BAD_INDEX(index, "index"), DESCRIPTION(info, mimo_agent_info, "info"))

#define SEEDED                                                              \
  NULL_OK(reset_config), CONFIG(reset_config, mimo_reset_config, "config"), \
      UNKNOWN_FIELD(reset_config, mimo_reset_config, seeded, 2, "seeded"),  \
      BAD_FIELD(reset_config, mimo_reset_config, seeded, 0, "seed is 5, but seeded is 0")
ROW(mimo_env_reset, ON_ENV | HEALS, mimo_env_reset(a->env, a->reset_config, a->block, a->block_bytes), SEEDED,
    DO(too_old, E_ARG, "age"), DO(too_many_ages, E_ARG, "growth_count"), DO(no_ages, E_ARG, "growth"),
    NO_NULL(block, "block"), SHORT(block_bytes, "block"))
ROW(mimo_env_step, ON_ENV | SIMULATES,
    mimo_env_step(a->env, a->action, a->action_count, a->block, a->block_bytes, a->env_results),
    NO_NULL(action, "action"), EXACT(action_count, "action"), DO(nan_action, E_ARG, "action[1]"),
    DO(infinite_action, MIMO_OK, NULL), NO_NULL(block, "block"), SHORT(block_bytes, "block"), NULL_OK(env_results),
    CONFIG(env_results, mimo_env_results, "results"),
    UNKNOWN_FIELD(env_results, mimo_env_results, reserved, 1, "reserved"),
    SHORT_FIELD(env_results, mimo_env_results, agent_count, "agent_count"),
    SHORT_FIELD(env_results, mimo_env_results, term_count, "term_count"))
ROW(mimo_env_follow, ON_ENV | SIMULATES, mimo_env_follow(a->env, a->movement, a->block, a->block_bytes),
    NO_NULL(movement, "movement"), CONFIG(movement, mimo_movement, "movement"),
    UNKNOWN_FIELD(movement, mimo_movement, reserved, 1, "reserved"),
    BAD_FIELD(movement, mimo_movement, position_count, 1, "position_count is 1"),
    DO(no_positions, E_ARG, "positions is NULL"), SHORT_FIELD(movement, mimo_movement, force_count, "forces"),
    NO_NULL(block, "block"), SHORT(block_bytes, "block"))
ROW(mimo_env_observe, ON_ENV | SIMULATES, mimo_env_observe(a->env, a->block, a->block_bytes), NO_NULL(block, "block"),
    SHORT(block_bytes, "block"), DO(no_block, E_ARG, "block"))
ROW(mimo_env_physics_step, ON_ENV | SIMULATES, mimo_env_physics_step(a->env, a->steps), BAD_SIZE(steps, -1, "count"),
    BAD_SIZE(steps, 1000001, "count"))
ROW(mimo_env_play, ON_ENV, mimo_env_play(a->env, a->part, a->action, a->action_count, a->rate), NO_NULL(part, "body"),
    NO_NULL(action, "samples"), DO(nan_action, E_ARG, "samples[1]"), NOT_FINITE(rate, "rate"),
    BAD_F64(rate, 44100, "rate is 44100"), BAD_SIZE(action_count, -1, "samples"))
ROW(mimo_env_time, ON_ENV, mimo_env_time(a->env, a->number), NO_NULL(number, "seconds"))
ROW(mimo_env_timestep, ON_ENV, mimo_env_timestep(a->env, a->number), NO_NULL(number, "seconds"))

#define KINDS \
  UNKNOWN(kind, 0, "kind"), UNKNOWNS(kind, MIMO_WARNING + 1, "kind"), BAD_I32(kind, MIMO_BODY_POSITION, "kind")
#define QUANTITIES                                                                                                   \
  UNKNOWN(quantity, 0, "quantity"), UNKNOWNS(quantity, 0x1ff, "quantity"), BAD_I32(quantity, MIMO_BODY, "quantity"), \
      BAD_I32(quantity, MIMO_NOW | MIMO_CONTACT_FORCE, "quantity")
#define IDS \
  NO_NULL(ids, "ids"), BAD_SIZE(id_count, -1, "ids"), DO(negative_id, E_ARG, "ids[0]"), DO(huge_id, E_ARG, "ids[0]")
#define VALUE_COUNTS(m, too_small)                                                                \
  SIZE_IS(m, 0, too_small, "value_count"), BAD_SIZE(m, -1, "value"),                              \
      {FAULT_LESS, #m " is one too small", MEMBER(m), 0, 1, 0, NULL, too_small, "value_count"}, { \
    FAULT_LESS, #m " is one too large", MEMBER(m), 0, -1, 0, NULL, E_ARG, "value_count"           \
  }
#define VALUES(m) VALUE_COUNTS(m, MIMO_E_BUFFER_TOO_SMALL)
#define GIVEN_VALUES(m) VALUE_COUNTS(m, E_ARG)
ROW(mimo_env_count, ON_ENV, mimo_env_count(a->env, a->kind, a->count), KINDS, NO_NULL(count, "count"))
ROW(mimo_env_find, ON_ENV, mimo_env_find(a->env, a->kind, a->name, a->id_out), KINDS, NO_NULL(name, "name"),
    NO_NULL(id_out, "id"), DO(unknown_name, MIMO_E_NOT_FOUND, "nobody"), DO(empty_name, MIMO_E_NOT_FOUND, "\"\""))
ROW(mimo_env_name, ON_ENV, mimo_env_name(a->env, a->kind, a->id, a->string), KINDS, BAD_IDS(id, "id"),
    NO_NULL(string, "name"))
ROW(mimo_env_body_of, ON_ENV, mimo_env_body_of(a->env, a->kind, a->id, a->id_out), KINDS, BAD_IDS(id, "id"),
    NO_NULL(id_out, "body"), BAD_I32(kind, MIMO_ACTUATOR, "actuator"))
ROW(mimo_env_width, ON_ENV, mimo_env_width(a->env, a->quantity, a->ids, a->id_count, a->count), QUANTITIES, IDS,
    NO_NULL(count, "value_count"))
ROW(mimo_env_get, ON_ENV, mimo_env_get(a->env, a->quantity, a->ids, a->id_count, a->values, a->value_count), QUANTITIES,
    IDS, NO_NULL(values, "values"), VALUES(value_count))
ROW(mimo_env_get_float, ON_ENV, mimo_env_get_float(a->env, a->quantity, a->ids, a->id_count, a->depth, a->value_count),
    QUANTITIES, IDS, NO_NULL(depth, "values"), VALUES(value_count))
ROW(mimo_env_set, ON_ENV | SIMULATES,
    mimo_env_set(a->env, a->quantity, a->ids, a->id_count, a->to_write, a->value_count), QUANTITIES, IDS,
    NO_NULL(to_write, "values"), GIVEN_VALUES(value_count), DO(nan_value, E_ARG, "values[0]"),
    DO(infinite_value, E_ARG, "values[0]"), BAD_I32(quantity, MIMO_JOINT_RANGE, "quantity"))
ROW(mimo_env_update, ON_ENV | SIMULATES, mimo_env_update(a->env), NONE)

#define VIEW(f, n) BAD_FIELD(picture_config, mimo_picture_config, f, n, #f)
#define VIEW_UNKNOWN(f, n) UNKNOWN_FIELD(picture_config, mimo_picture_config, f, n, #f)
#define VIEW_REAL(f, n) BAD_REAL(picture_config, mimo_picture_config, f, n, #f)
#define VIEW_UNREAL(f) UNREAL(picture_config, mimo_picture_config, f, #f)
#define VIEWS                                                                                                          \
  CONFIG(picture_config, mimo_picture_config, "config"), VIEW(width, 0), VIEW(width, 4097), VIEW(width, -1),           \
      VIEW(height, 0), VIEW(height, 4097), VIEW_UNKNOWN(format, 4), VIEW_UNREAL(look_at[2]), VIEW_UNREAL(distance),    \
      VIEW_REAL(distance, 0), VIEW_REAL(distance, -1), VIEW_UNREAL(azimuth), VIEW_UNREAL(elevation),                   \
      VIEW_UNREAL(fovy), VIEW_REAL(fovy, -1), VIEW_REAL(fovy, 171), VIEW_UNREAL(foveation), VIEW_REAL(foveation, 101), \
      DO(unknown_camera, MIMO_E_NOT_FOUND, "no camera named")
#define CHANNEL(f, count)                                                                            \
  {FAULT_FIELD_NULL, #f " is NULL", MEMBER(picture), FIELD(mimo_picture, f), 0, 0, NULL, E_ARG, #f}, \
      SHORT_FIELD(picture, mimo_picture, count, #f)
ROW(mimo_env_render, ON_ENV | SIMULATES, mimo_env_render(a->env, a->picture_config, a->picture), VIEWS,
    NO_NULL(picture, "picture"), CONFIG(picture, mimo_picture, "picture"),
    UNKNOWN_FIELD(picture, mimo_picture, reserved, 1, "reserved"), CHANNEL(rgb, rgb_bytes), CHANNEL(depth, depth_count),
    CHANNEL(segmentation, segmentation_count),
    {FAULT_NULL, "the picture is 640 x 480", MEMBER(picture_config), 0, 0, 0, NULL, MIMO_E_BUFFER_TOO_SMALL, "rgb"})
ROW(mimo_env_project, ON_ENV | SIMULATES,
    mimo_env_project(a->env, a->picture_config, a->points, a->point_count, a->pixels), VIEWS, NULL_OK(picture_config),
    NO_NULL(points, "points"), NO_NULL(pixels, "pixels"), BAD_SIZE(point_count, -1, "count"),
    BAD_SIZE(point_count, SIZE_MAX / 3 + 1, "count"), SIZE_IS(point_count, 0, MIMO_OK, NULL),
    DO(nan_point, E_ARG, "points[0]"))

#define LOOK                                                                                   \
  BAD_INDEX(agent_index, "agent"), NO_NULL(points, "point"), DO(nan_point, E_ARG, "point[0]"), \
      UNKNOWNS(how, 2, "how"), NULL_OK(numbers)
ROW(mimo_env_gaze, ON_ENV, mimo_env_gaze(a->env, a->agent_index, a->gaze), BAD_INDEX(agent_index, "agent"),
    DESCRIPTION(gaze, mimo_gaze, "gaze"))
ROW(mimo_env_spontaneous, ON_ENV,
    mimo_env_spontaneous(a->env, a->agent_index, MIMO_MOVEMENT_ALL, a->own_moves, a->action_count),
    BAD_INDEX(agent_index, "agent"), NO_NULL(own_moves, "actions"), SHORT(action_count, "count"))
ROW(mimo_env_look_angles, ON_ENV | SIMULATES,
    mimo_env_look_angles(a->env, a->agent_index, a->points, a->how, a->look_joints, a->look_angles, a->look_capacity,
                         a->count, a->numbers),
    LOOK, NULL_OK(look_joints), NULL_OK(look_angles), NULL_OK(count), SHORT(look_capacity, "capacity"))
ROW(mimo_env_look_at, ON_ENV | SIMULATES, mimo_env_look_at(a->env, a->agent_index, a->points, a->how, a->numbers), LOOK)

ROW(mimo_env_timing, ON_ENV, mimo_env_timing(a->env, a->timing), DESCRIPTION(timing, mimo_timing, "timing"))
ROW(mimo_env_timing_reset, ON_ENV, mimo_env_timing_reset(a->env), NONE)

ROW(mimo_env_state_size, ON_ENV, mimo_env_state_size(a->env, a->count), NO_NULL(count, "bytes"))
ROW(mimo_env_state_save, ON_ENV | SIMULATES, mimo_env_state_save(a->env, a->state_out, a->state_bytes),
    NO_NULL(state_out, "state"), SHORT(state_bytes, "state"))
ROW(mimo_env_state_load, ON_ENV | HEALS, mimo_env_state_load(a->env, a->state, a->state_bytes, a->report),
    NO_NULL(state, "state"), LOAD_REPORT, WHOLE_STATE(state_bytes), SIZE_IS(state_bytes, 47, MIMO_E_FILE, "state"),
    DO(no_state, MIMO_E_FILE, "not a state"), DO(damaged_state, MIMO_E_FILE, "damaged"),
    DO(foreign_state, MIMO_E_MISMATCH, "another"))
ROW(mimo_env_clone, ON_ENV | SIMULATES, mimo_env_clone(a->env, a->made_env), NO_NULL(made_env, "clone"))
ROW(mimo_env_random, ON_ENV, mimo_env_random(a->env, a->numbers, a->number_count), NO_NULL(numbers, "values"),
    BAD_SIZE(number_count, -1, "values"), SIZE_IS(number_count, 0, MIMO_OK, NULL))
