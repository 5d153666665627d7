/* What every program does: make a world, read its fields and actions, reset, step, observe; and buffers one too short.
 */
#include "support/capi.h"

static mimo_env* env;
static size_t bytes, fields;

static uint8_t* new_block(uint8_t fill) {
  uint8_t* block = malloc(bytes);
  memset(block, fill, bytes);
  return block;
}

static int is_filled(const uint8_t* block, uint8_t fill) {
  size_t i;
  for (i = 0; i < bytes; ++i) {
    if (block[i] != fill) return 0;
  }
  return 1;
}

static void check_making_worlds(void) {
  mimo_env* made = NULL;
  mimo_scene* scene = blind_scene("free");
  mimo_env_config config;
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no scene named \"castle\"", mimo_env_make("castle", &made));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "scene_name is NULL", mimo_env_make(NULL, &made));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "env is NULL", mimo_env_make("free", NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "env is NULL", mimo_env_create(scene, NULL, NULL));
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  CHECK(config.frame_skip == 0 && config.jacobian == MIMO_JACOBIAN_MODEL && config.disable == 0 &&
        config.max_steps == 0);
#define NO_ENV(status, part, field, value, good)                       \
  do {                                                                 \
    config.field = (value);                                            \
    CHECK_FAILS(status, part, mimo_env_create(scene, &config, &made)); \
    config.field = (good);                                             \
  } while (0)
  NO_ENV(MIMO_E_INVALID_ARGUMENT, "frame_skip is 1001, expected 1 to 1000, or 0", frame_skip, 1001, 0);
  NO_ENV(MIMO_E_UNSUPPORTED, "jacobian is 3", jacobian, 3, 0);
  NO_ENV(MIMO_E_UNSUPPORTED, "disable is 0x8", disable, 8, 0);
  NO_ENV(MIMO_E_INVALID_ARGUMENT, "renderer is \"paper\"", renderer, "paper", NULL); /* NULL: the default */
  NO_ENV(MIMO_E_UNSUPPORTED, "timing is 2", timing, 2, 0);
  config.task = "fly";
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no task named \"fly\"; there are: none, reach",
              mimo_env_create(scene, &config, &made));
  CHECK(made == NULL);
  mimo_scene_destroy(scene);
}

static void check_fields(void) {
  const mimo_layout* layout = layout_of(env);
  mimo_field field = field_of(env, "proprioception/torque");
  const char* label = NULL;
  size_t limit = 0;
  CHECK(field.dtype == MIMO_F32 && field.ndim == 2 && field.shape[0] == 21 && field.shape[1] == 3);
  CHECK(field.bytes == 63 * 4 && field.offset % 64 == 0 && field.receptors == 0);
  CHECK(field.start == -0.005 && field.end == -0.005 && field.period == 0.01); /* the last of two physics steps */
  CHECK_TEXT("Nm", field.unit);
  CHECK_TEXT("site", field.frame);
  CHECK(isinf(field.low) && field.low < 0 && isinf(field.high) && field.high > 0);
  CHECK_OK(mimo_layout_find(layout, "proprioception/limit", &limit));
  field = field_at(layout, limit);
  CHECK(field.low == 0 && field.start == 0 && field.end == 0 && field.shape[0] == 47);
  CHECK_OK(mimo_layout_label(layout, limit, 0, &label));
  CHECK_TEXT("robot:hip_lean1", label);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "element is 47", mimo_layout_label(layout, limit, 47, &label));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "field is 99", mimo_layout_label(layout, 99, 0, &label));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "label is NULL", mimo_layout_label(layout, limit, 0, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "index is 9, but there are 9 fields", mimo_layout_field(layout, 9, &field));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no field named \"smell\"; there are: proprioception/position",
              mimo_layout_find(layout, "smell", &limit));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "name is NULL", mimo_layout_find(layout, NULL, &limit));
}

static void check_descriptions_of_actions(void) {
  mimo_action action = action_at(env, 0);
  CHECK(sizes_of(env).actions == 44 && sizes_of(env).agents == 1 && sizes_of(env).terms == 0);
  CHECK(action.low == -1 && (float)action.high == 0.765f && action.agent == 0); /* hip_bend: -10.58 to 8.09 Nm */
  CHECK_TEXT("act:hip_bend", action.name);
  CHECK_TEXT("", action.unit);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "index is 44, but there are 44 actions",
              mimo_layout_action(layout_of(env), 44, &action));
  action.struct_size = 0;
  CHECK_FAILS(MIMO_E_STRUCT_SIZE, "action: struct_size is 0", mimo_layout_action(layout_of(env), 0, &action));
}

static void check_reset_and_steps(void) {
  uint8_t *first = new_block(0xab), *second = new_block(0xcd);
  float action[44] = {0};
  double reward = 7, time = 7, step = 0;
  uint8_t terminated = 7, truncated = 7;
  const mimo_field control = field_of(env, "proprioception/control");

  CHECK_OK(mimo_env_timestep(env, &step));
  CHECK(step == 0.005);
  CHECK_OK(mimo_env_reset(env, SEED(1), first, bytes));
  CHECK_OK(mimo_env_observe(env, second, bytes));
  CHECK(memcmp(first, second, bytes) == 0);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));

  action[3] = 9;
  CHECK_OK(
      mimo_env_step(env, action, 44, first, bytes,
                    RESULTS(.reward = &reward, .terminated = &terminated, .truncated = &truncated, .agent_count = 1)));
  CHECK(reward == 0 && terminated == 0 && truncated == 0);
  CHECK(((const float*)(const void*)(first + control.offset))[3] == 1); /* clipped */
  CHECK_OK(mimo_env_time(env, &time));
  CHECK_NEAR(0.01, time, 1e-15);

  /* NaN is refused and nothing happens: not even the first actions are taken. */
  memset(first, 0xab, bytes);
  reward = terminated = truncated = 7;
  action[0] = 0.5f;
  action[43] = (float)NAN;
  CHECK_FAILS(
      MIMO_E_INVALID_ARGUMENT, "action[43] is not a number",
      mimo_env_step(env, action, 44, first, bytes,
                    RESULTS(.reward = &reward, .terminated = &terminated, .truncated = &truncated, .agent_count = 1)));
  action[43] = 0;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "action_count is 43, expected 44",
              mimo_env_step(env, action, 43, first, bytes, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "action is NULL, but its length is 44",
              mimo_env_step(env, NULL, 44, first, bytes, NULL));
  CHECK_FAILS(
      MIMO_E_BUFFER_TOO_SMALL, " bytes, but ",
      mimo_env_step(env, action, 44, first, bytes - 1,
                    RESULTS(.reward = &reward, .terminated = &terminated, .truncated = &truncated, .agent_count = 1)));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "block is NULL", mimo_env_step(env, action, 44, NULL, bytes, NULL));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "agent_count is 0",
              mimo_env_step(env, action, 44, first, bytes, RESULTS(.reward = &reward)));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "block has", mimo_env_reset(env, SEED(1), first, bytes - 1));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "block has", mimo_env_observe(env, first, bytes - 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "block is NULL", mimo_env_observe(env, NULL, 0));
  CHECK(is_filled(first, 0xab) && reward == 7 && terminated == 7 && truncated == 7);
  CHECK_OK(mimo_env_time(env, &time));
  CHECK_NEAR(0.01, time, 1e-15);
  CHECK_OK(mimo_env_observe(env, first, bytes));
  CHECK(((const float*)(const void*)(first + control.offset))[0] == 0);

  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_physics_step(env, 3));
  CHECK_OK(mimo_env_physics_step(env, 0));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "count is 1000001", mimo_env_physics_step(env, 1000001));
  CHECK_OK(mimo_env_time(env, &time));
  CHECK_NEAR(0.035, time, 1e-15);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "seconds is NULL", mimo_env_time(env, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "seconds is NULL", mimo_env_timestep(env, NULL));
  free(first);
  free(second);
}

static void check_times_of_steps(void) {
  mimo_env_config config;
  mimo_env* timed;
  mimo_timing timing;
  int i;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.timing = 1;
  config.max_steps = 2;
  timed = blind_env("free", &config);
  timing.struct_size = sizeof timing;
  for (i = 1; i <= 3; ++i) {
    uint8_t truncated = 7;
    CHECK_OK(mimo_env_step(timed, NULL, 0, NULL, 0, RESULTS(.truncated = &truncated, .agent_count = 1)));
    CHECK(truncated == (i >= 2));
  }
  CHECK_OK(mimo_env_timing(timed, &timing));
  CHECK(timing.steps == 3 && timing.physics > 0 && timing.total >= timing.physics && timing.touch == 0 &&
        timing.vision == 0);
  CHECK_OK(mimo_env_timing_reset(timed));
  CHECK_OK(mimo_env_timing(timed, &timing));
  CHECK(timing.steps == 0 && timing.total == 0 && timing.physics == 0);
  mimo_env_destroy(timed);
  timed = blind_env("free", NULL); /* without timing = 1 */
  CHECK_OK(mimo_env_step(timed, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_timing(timed, &timing));
  CHECK(timing.steps == 0 && timing.total == 0);
  mimo_env_destroy(timed);
}

int main(void) {
  check_making_worlds();
  env = blind_env("benchmark", NULL);
  bytes = sizes_of(env).block_bytes;
  fields = sizes_of(env).fields;
  CHECK(bytes % 64 == 0 && fields == 9);
  check_fields();
  check_descriptions_of_actions();
  check_reset_and_steps();
  check_times_of_steps();
  mimo_env_destroy(env);
  return failures();
}
