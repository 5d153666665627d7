/* Recordings: the recorder writes what a program does with a world, and a replay repeats it bit for bit. */
#define _XOPEN_SOURCE 700 /* truncate */
#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/capi.h"

enum { ACTIONS = 100, RATE = 16000, HEARD = 160 }; /* samples of a step of 10 ms */

static char path[256], other[300];
static float action[ACTIONS];

static mimo_env* world_of(const char* name, uint32_t hearing) {
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_agent_config agent;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = name), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = agent.touch = 0;
  agent.hearing = hearing;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  if (hearing != 0) CHECK_OK(mimo_scene_set_sources(scene, 1, 0.05));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

/* What an earlier test left is replaced. */
static mimo_recorder* record(mimo_env* env, const char* keep) {
  mimo_recorder* recorder = NULL;
  mimo_recorder_config config;
  CHECK_OK(mimo_recorder_config_init(&config, sizeof config));
  config.keep = keep;
  config.state_seconds = 0.1;
  config.configuration = "{\"who\": \"a test\"}";
  config.seed = 7;
  config.replace = 1;
  CHECK_OK(mimo_recorder_open(env, path, &config, &recorder));
  if (recorder == NULL) exit(failures());
  return recorder;
}

static mimo_recording* open_it(void) {
  mimo_recording* recording = NULL;
  CHECK_OK(mimo_recording_open(path, NULL, &recording));
  if (recording == NULL) exit(failures());
  return recording;
}

static mimo_recording_info info_of(const mimo_recording* recording) {
  mimo_recording_info info = {.struct_size = sizeof info};
  CHECK_OK(mimo_recording_describe(recording, &info));
  return info;
}

static void go(mimo_env* env, int steps) {
  const size_t count = sizes_of(env).actions;
  for (int i = 0; i < steps; ++i) {
    for (size_t k = 0; k < count; ++k) action[k] = sinf((float)(i + 1) * (float)(k + 1));
    CHECK_OK(mimo_env_step(env, action, count, NULL, 0, NULL));
  }
}

static mimo_replay_report replay(mimo_recording* recording, mimo_env* env, size_t from) {
  mimo_replay_report report = {.struct_size = sizeof report};
  CHECK_OK(mimo_recording_seek(recording, env, from, 1, NULL));
  while (mimo_recording_step(recording, env, NULL, 0, NULL) == MIMO_OK) continue;
  CHECK(strstr(mimo_last_error(), "ends at step") != NULL);
  CHECK_OK(mimo_recording_report(recording, &report));
  return report;
}

static void check_identical(mimo_env* like, size_t steps) {
  mimo_recording* recording = open_it();
  for (size_t from = 0; from <= steps; from += 1 + steps / 3) {
    const mimo_replay_report report = replay(recording, like, from);
    CHECK(report.identical == 1 && report.largest_difference == 0 && report.next == steps);
    CHECK_TEXT("", report.differs_most_in);
    CHECK(report.steps <= steps - from + 10); /* states are 10 steps apart */
  }
  mimo_recording_close(recording);
}

static mimo_status find_nothing(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  (void)env, (void)verdict;
  return moment->step == *(const uint64_t*)user ? MIMO_E_NOT_FOUND : MIMO_OK;
}

/* The status by which a recording ends, given by a task: a replay goes on behind that step. */
static void no_task_ends_a_replay(void) {
  const size_t steps = 10;
  uint64_t failing = UINT64_MAX;
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  mimo_recorder* recorder;
  mimo_recording* recording;
  mimo_task task;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = find_nothing;
  task.user = &failing;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_reset(env, SEED(1), NULL, 0));
  recorder = record(env, NULL);
  go(env, (int)steps);
  CHECK_OK(mimo_recorder_close(recorder));
  recording = open_it();
  CHECK_OK(mimo_recording_seek(recording, env, 0, 1, NULL));
  failing = 4;
  for (size_t step = 1; step <= steps; ++step) {
    const mimo_status status = mimo_recording_step(recording, env, NULL, 0, NULL);
    CHECK(status == (step == failing ? MIMO_E_TASK : MIMO_OK));
  }
  CHECK_FAILS(MIMO_E_END, "ends at step", mimo_recording_step(recording, env, NULL, 0, NULL));
  mimo_recording_close(recording);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* Everything that a program may do between two steps. */
static void what_programs_do_is_replayed(void) {
  mimo_env *env = world_of("reach", 0), *twin = world_of("reach", 0);
  size_t bytes = 0;
  const int32_t first = 0;
  const double gravity[3] = {0, 0, -1};
  double value = 0.2;
  CHECK_OK(mimo_env_state_size(env, &bytes));
  uint8_t* state = malloc(bytes);
  CHECK_OK(mimo_env_reset(env, SEED(3), NULL, 0));
  go(env, 5); /* before the recording */
  mimo_recorder* recorder = record(env, NULL);
  go(env, 7);
  CHECK_OK(mimo_env_state_save(env, state, bytes));
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  go(env, 5);
  const int32_t elbow = find(env, MIMO_JOINT, "robot:left_elbow");
  CHECK_OK(mimo_env_set(env, MIMO_JOINT_POSITION, &elbow, 1, (const double[]){-0.5}, 1));
  go(env, 5);
  CHECK_OK(mimo_env_set(env, MIMO_WORLD_GRAVITY, &first, 1, gravity, 3));
  go(env, 5);
  CHECK_OK(mimo_env_physics_step(env, 3));
  go(env, 5);
  CHECK_OK(mimo_env_random(env, &value, 1));
  CHECK_OK(mimo_env_state_load(env, state, bytes, NULL));
  go(env, 5);
  CHECK_OK(mimo_env_set(env, MIMO_ACTUATOR_CONTROL, &first, 1, &value, 1));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL)); /* leaves the motors as they are */
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_recorder_flush(recorder));
  CHECK_OK(mimo_recorder_close(recorder));
  CHECK_OK(mimo_recorder_close(recorder)); /* again */
  CHECK_OK(mimo_recorder_close(NULL));
  go(env, 3); /* of which nobody is told */
  check_identical(twin, 34);
  mimo_recording* recording = open_it();
  const mimo_recording_info info = info_of(recording);
  CHECK(info.steps == 34 && info.agents == 1 && info.bodies == 1 && info.format_version == 3 && info.same_build == 1);
  CHECK(info.actions == sizes_of(env).actions && fabs(info.step_seconds - 0.01) < 1e-12);
  CHECK_TEXT("{\"who\": \"a test\"}", info.configuration);
  CHECK_TEXT("7", info.seed);
  /* Changes: the reset, the elbow, gravity, physics, the loaded state, the control; and every tenth step; the end. */
  uint8_t changed[16];
  size_t rows = 0;
  CHECK_OK(mimo_recording_size(recording, "states/given", &rows, NULL));
  CHECK(rows == info.states && rows <= 16);
  CHECK_OK(mimo_recording_read(recording, "states/given", 0, rows, changed, sizeof changed));
  size_t changes = 0;
  for (size_t i = 0; i < rows; ++i) changes += changed[i];
  CHECK(changes == 6);
  mimo_recording_close(recording);
  free(state);
  mimo_env_destroy(env);
  mimo_env_destroy(twin);
}

static mimo_growth aged(double months) {
  mimo_growth growth;
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.age = months;
  growth.maturity = MIMO_MATURITY_ALL; /* nerves too: states then have other lengths */
  return growth;
}

/* A career in one file. The world that replays it grows along, and back again. */
static void other_ages_are_replayed(void) {
  mimo_env *env = world_of("benchmark", 0), *twin = world_of("benchmark", 0);
  const mimo_growth young = aged(3), older = aged(9);
  double age = 0;
  mimo_recorder* recorder = record(env, NULL);
  go(env, 5);
  for (const mimo_growth* growth = &young; growth != NULL; growth = growth == &young ? &older : NULL) {
    CHECK_OK(mimo_env_reset(env, SIZED(mimo_reset_config, .growth = &growth, .growth_count = 1), NULL, 0));
    go(env, 12);
  }
  CHECK_OK(mimo_recorder_close(recorder));
  mimo_recording* recording = open_it();
  CHECK(info_of(recording).bodies == 3);
  mimo_recording_close(recording);
  check_identical(twin, 29);
  CHECK_OK(mimo_env_get(twin, MIMO_AGENT_AGE, NULL, 0, &age, 1));
  CHECK(age == 9);
  check_identical(twin, 29); /* from the oldest again */
  mimo_env_destroy(env);
  mimo_env_destroy(twin);
}

static mimo_env* env_of(const mimo_recording* recording) {
  mimo_env* env = NULL;
  CHECK_OK(mimo_recording_env(recording, NULL, NULL, &env));
  if (env == NULL) exit(failures());
  return env;
}

/* A world with a bit of everything that a scene and its agents can be told, made anew of the file. */
static void a_file_alone_is_replayed(void) {
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  mimo_limits limits;
  mimo_env_config config;
  mimo_env* env = NULL;
  mimo_field_config field;
  const char* head = "head";
  const mimo_growth young = aged(4);
  const mimo_growth* growth = &young;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "reach"), &scene));
  CHECK_OK(mimo_scene_default_agent(scene, &agent, sizeof agent));
  agent.vision = 0;
  agent.proprioception = MIMO_PROPRIOCEPTION_ALL;
  agent.touch = MIMO_TOUCH_FORCE | MIMO_TOUCH_SA1;
  agent.vestibular = MIMO_VESTIBULAR_ACCELERATION;
  agent.reflexes = MIMO_REFLEX_ALL;
  agent.actuation = MIMO_ACTUATION_MUSCLE;
  agent.hearing = MIMO_HEARING_EARS;
  CHECK_OK(mimo_scene_add_agents(scene, &agent, NULL));
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.delay = 0.03;
  limits.noise = 0.01;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "vestibular", &limits));
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "proprioception/velocity", &limits));
  limits.noise = 0;
  CHECK_OK(mimo_scene_limit_motor(scene, 0, "", &limits));
  CHECK_OK(mimo_scene_set_sensory_delay(scene, 0, NULL, 0.01));
  CHECK_OK(mimo_scene_set_touch(scene, 0, "head", 0.05));
  CHECK_OK(mimo_scene_set_parameter(scene, "reach/episode_steps", 17));
  CHECK_OK(mimo_scene_set_temperature(scene, "target", 40));
  CHECK_OK(mimo_field_config_init(&field, sizeof field));
  field.name = "heads";
  field.quantity = MIMO_BODY_POSITION | MIMO_NOW;
  field.elements = &head;
  field.element_count = 1;
  CHECK_OK(mimo_scene_add_field(scene, &field));
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.frame_skip = 3;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_env_reset(env, SEED(5), NULL, 0));
  mimo_recorder* recorder = record(env, "all");
  go(env, 20); /* past the episode's end */
  CHECK_OK(mimo_env_reset(env, SIZED(mimo_reset_config, .growth = &growth, .growth_count = 1), NULL, 0));
  go(env, 5);
  CHECK_OK(mimo_recorder_close(recorder));
  mimo_recording* recording = open_it();
  mimo_env* twin = env_of(recording);
  mimo_replay_report report = replay(recording, twin, 0);
  CHECK(report.identical == 1 && report.steps == 25);
  report = replay(recording, twin, 3); /* back to the first age */
  CHECK(report.identical == 1);
  /* The limits of a sense or a field that the caller leaves out go with it. */
  mimo_agent_config senses;
  mimo_env* numb = NULL;
  CHECK_OK(mimo_agent_config_init(&senses, sizeof senses));
  senses.proprioception = senses.vision = senses.hearing = MIMO_AS_RECORDED;
  senses.touch_scale = 1e9;
  senses.touch = MIMO_TOUCH_FORCE;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "touch_scale", mimo_recording_env(recording, NULL, &senses, &numb));
  senses.touch = MIMO_AS_RECORDED;
  senses.vestibular_at = "nowhere"; /* members that belong to a sense come with it */
  CHECK_FAILS(MIMO_E_NOT_FOUND, "nowhere", mimo_recording_env(recording, NULL, &senses, &numb));
  senses.vestibular = 0;
  senses.proprioception = MIMO_PROPRIOCEPTION_TORQUE;
  CHECK_OK(mimo_recording_env(recording, NULL, &senses, &numb));
  CHECK_OK(mimo_recording_seek(recording, numb, 0, 0, NULL));
  CHECK_OK(mimo_recording_step(recording, numb, NULL, 0, NULL));
  CHECK_OK(mimo_recording_report(recording, &report));
  CHECK(report.identical == 1 && report.steps == 1);
  snprintf(other, sizeof other, "%s.2", path);
  CHECK(rename(path, other) == 0);
  recorder = record(numb, "all"); /* which is a recording like any other */
  go(numb, 2);
  CHECK_OK(mimo_recorder_close(recorder));
  mimo_recording* of_numb = open_it();
  mimo_env* numb_too = env_of(of_numb);
  mimo_recording_close(of_numb);
  check_identical(numb_too, 2);
  mimo_env_destroy(numb_too);
  CHECK(rename(other, path) == 0);
  mimo_env_destroy(numb);
  uint8_t truncated[25];
  CHECK_OK(mimo_recording_read(recording, "truncated", 0, 25, truncated, sizeof truncated));
  CHECK(truncated[15] == 0 && truncated[16] == 1); /* episode_steps */
  /* Ages that are not in the file cannot be made: its documents are those of infants who have grown already. */
  const mimo_growth older = aged(20);
  growth = &older;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "2 ages",
              mimo_env_reset(twin, SIZED(mimo_reset_config, .growth = &growth, .growth_count = 1), NULL, 0));
  /* The replay is recorded as well, and plays again. */
  CHECK_OK(mimo_recording_seek(recording, twin, 0, MIMO_REPLAY_FIELDS, NULL));
  mimo_recording_close(recording);
  snprintf(other, sizeof other, "%s.2", path);
  CHECK(rename(path, other) == 0);
  recorder = record(twin, "all");
  go(twin, 4);
  CHECK_OK(mimo_recorder_close(recorder));
  recording = open_it();
  mimo_env* third = env_of(recording);
  mimo_recording_close(recording); /* the world outlives it */
  check_identical(third, 4);
  unlink(other);
  mimo_env_destroy(third);
  mimo_env_destroy(twin);
  mimo_env_destroy(env);
}

/* Whatever a task of the program's own did is not there; what it said is. */
static mimo_status push(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  (void)user;
  if (moment->step == 4) {
    const double gravity[3] = {0, 0, -2};
    const mimo_status status = mimo_env_set(env, MIMO_WORLD_GRAVITY, NULL, 0, gravity, 3);
    if (status != MIMO_OK) return status;
  }
  *(uint8_t*)moment->memory = (uint8_t)moment->step;
  moment->fields[0] = (float)moment->step;
  verdict->terms[0] = 0.5 * (double)moment->step;
  verdict->outcome = moment->step == 6 ? MIMO_OUTCOME_SUCCESS : MIMO_OUTCOME_NONE;
  return MIMO_OK;
}

static void results_of_own_tasks_are_given(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  mimo_task task;
  mimo_task_field field;
  const char* term = "effort";
  const size_t one = 1;
  CHECK_OK(mimo_task_field_init(&field, sizeof field));
  field.name = "count";
  field.shape = &one;
  field.ndim = 1;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = push;
  task.memory_bytes = 3;
  task.terms = &term;
  task.term_count = 1;
  task.fields = &field;
  task.field_count = 1;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_reset(env, SEED(1), NULL, 0));
  mimo_recorder* recorder = record(env, "all");
  go(env, 8);
  CHECK_OK(mimo_recorder_close(recorder));
  mimo_recording* recording = open_it();
  mimo_env* twin = env_of(recording);
  double reward = 0;
  int32_t outcome = 0;
  uint8_t terminated = 0;
  mimo_env_results results = {.struct_size = sizeof results};
  results.reward = &reward;
  results.outcome = &outcome;
  results.terminated = &terminated;
  results.agent_count = 1;
  mimo_replay_report report = {.struct_size = sizeof report};
  CHECK_OK(mimo_recording_seek(recording, twin, 0, MIMO_REPLAY_FIELDS, NULL));
  for (int step = 1; step <= 8; ++step) {
    CHECK_OK(mimo_recording_step(recording, twin, NULL, 0, &results));
    CHECK(reward == 0.5 * step && outcome == (step == 6) && terminated == (step == 6));
  }
  CHECK_OK(mimo_recording_report(recording, &report));
  CHECK(report.identical == 1); /* gravity, too: a state is kept where the task changed the world */
  mimo_recording_close(recording);
  mimo_env_destroy(twin);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* Another model with the same joints: a replay says so, and what else can be done. */
static void joints_are_replayed_in_other_models(void) {
  mimo_env *env = world_of("benchmark", 0), *other_world = NULL;
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  mimo_replay_report report = {.struct_size = sizeof report};
  double recorded[100], now[100], reward = -1, kept = 0;
  size_t row_bytes = 0, count = 0;
  mimo_recorder* recorder = record(env, "none");
  go(env, 6);
  CHECK_OK(mimo_recorder_close(recorder));
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "benchmark"), &scene));
  CHECK_OK(mimo_scene_add_object(
      scene, SIZED(mimo_object_config, .name = "post", .shape = MIMO_SHAPE_BOX, .size = {0.1, 0.1, 0.1},
                   .position = {3, 3, 1}, .orientation = {1, 0, 0, 0}, .rgba = {1, 1, 1, 1}, .fixed = 1)));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = agent.touch = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &other_world));
  mimo_scene_destroy(scene);
  mimo_recording* recording = open_it();
  CHECK_FAILS(MIMO_E_MISMATCH, "was recorded with another model",
              mimo_recording_seek(recording, other_world, 0, 0, NULL));
  CHECK_FAILS(MIMO_E_MISMATCH, mimo_mujoco_version(), mimo_recording_seek(recording, other_world, 0, 0, NULL));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "how", mimo_recording_seek(recording, other_world, 0, 4, NULL));
  CHECK_OK(mimo_recording_seek(recording, other_world, 0, MIMO_REPLAY_JOINTS, NULL));
  const mimo_env_results results = {.struct_size = sizeof results, .reward = &reward, .agent_count = 1};
  for (size_t step = 0; step < 6; ++step) {
    CHECK_OK(mimo_recording_step(recording, other_world, NULL, 0, &results));
    CHECK_OK(mimo_recording_size(recording, "joints/position", NULL, &row_bytes));
    CHECK_OK(mimo_recording_read(recording, "joints/position", step, 1, recorded, sizeof recorded));
    CHECK_OK(mimo_recording_read(recording, "rewards", step, 1, &kept, sizeof kept));
    CHECK_OK(mimo_env_width(other_world, MIMO_JOINT_POSITION, NULL, 0, &count));
    CHECK(count * sizeof *now == row_bytes);
    CHECK_OK(mimo_env_get(other_world, MIMO_JOINT_POSITION, NULL, 0, now, count));
    for (size_t i = 0; i < count; ++i) CHECK(fabs(now[i] - recorded[i]) < 1e-12);
    CHECK(reward == kept);
  }
  CHECK_FAILS(MIMO_E_END, "ends at step 6", mimo_recording_step(recording, other_world, NULL, 0, NULL));
  CHECK_OK(mimo_recording_report(recording, &report));
  CHECK(report.identical == 1 && report.steps == 6);
  mimo_recording_close(recording);
  mimo_env_destroy(other_world);
  mimo_env_destroy(env);
}

/* A tone that a body plays reaches the left ear, in the file as in the block. */
static void what_is_heard_is_kept(void) {
  mimo_env *env = world_of("benchmark", MIMO_HEARING_EARS), *twin = world_of("benchmark", MIMO_HEARING_EARS);
  const mimo_field left = field_of(env, "hearing/ear_left");
  const size_t bytes = sizes_of(env).block_bytes;
  uint8_t* block = malloc(bytes);
  float tone[HEARD * 4], heard[HEARD], kept[5][HEARD], loudest = 0;
  size_t rows = 0, row_bytes = 0;
  for (int i = 0; i < HEARD * 4; ++i) tone[i] = 0.1f * sinf(6.2831853f * 500 * (float)i / RATE);
  mimo_recorder* recorder = record(env, "hearing/ear_left");
  CHECK_OK(mimo_env_play(env, "head", tone, HEARD * 4, RATE));
  for (int i = 0; i < 5; ++i) CHECK_OK(mimo_env_step(env, NULL, 0, i == 4 ? block : NULL, i == 4 ? bytes : 0, NULL));
  CHECK_OK(mimo_recorder_close(recorder));
  mimo_recording* recording = open_it();
  CHECK_OK(mimo_recording_size(recording, "fields/hearing/ear_left", &rows, &row_bytes));
  CHECK(rows == 5 && row_bytes == sizeof heard);
  CHECK_OK(mimo_recording_read(recording, "fields/hearing/ear_left", 0, 5, kept, sizeof kept));
  memcpy(heard, block + left.offset, sizeof heard);
  CHECK(memcmp(heard, kept[4], sizeof heard) == 0);
  for (int i = 0; i < 5 * HEARD; ++i) loudest = fmaxf(loudest, fabsf(kept[i / HEARD][i % HEARD]));
  CHECK(loudest > 0.05f); /* the ear is nearer than the metre at which it has 0.1 Pa */
  mimo_recording_close(recording);
  check_identical(twin, 5);
  free(block);
  mimo_env_destroy(env);
  mimo_env_destroy(twin);
}

/* Also where the batch starts episodes anew by itself; the worlds write beside each other. */
static void worlds_of_a_batch_are_recorded(void) {
  mimo_scene* scene = blind_scene("reach");
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  mimo_env* worlds[2] = {NULL, NULL};
  mimo_recorder* recorders[2] = {NULL, NULL};
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = config.threads = 2;
  config.autoreset = MIMO_AUTORESET_SAME_STEP;
  mimo_env_config settings;
  CHECK_OK(mimo_env_config_init(&settings, sizeof settings));
  settings.max_steps = 6;
  CHECK_OK(mimo_batch_create(scene, &settings, &config, &batch));
  unlink(path);
  unlink(other);
  for (size_t i = 0; i < 2; ++i) {
    CHECK_OK(mimo_batch_world(batch, i, &worlds[i]));
    CHECK_OK(mimo_recorder_open(worlds[i], i == 0 ? path : other, NULL, &recorders[i]));
  }
  const size_t count = sizes_of(worlds[0]).actions;
  float* actions = malloc(2 * count * sizeof *actions);
  for (size_t i = 0; i < 2 * count; ++i) actions[i] = sinf((float)i);
  for (int i = 0; i < 20; ++i) CHECK_OK(mimo_batch_step(batch, actions, 2 * count, NULL, 0, NULL));
  CHECK_OK(mimo_recorder_close(recorders[0]));
  mimo_batch_destroy(batch); /* closes the other's file */
  CHECK_OK(mimo_recorder_flush(recorders[1]));
  CHECK_OK(mimo_recorder_close(recorders[1]));
  mimo_env* twin = NULL;
  CHECK_OK(mimo_env_create(scene, &settings, &twin));
  check_identical(twin, 20);
  CHECK(rename(other, path) == 0);
  check_identical(twin, 20);
  mimo_env_destroy(twin);
  mimo_scene_destroy(scene);
  free(actions);
}

static void a_difference_is_told(void) {
  mimo_env *env = world_of("benchmark", 0), *heavy = world_of("benchmark", 0);
  mimo_recorder* recorder = record(env, "none");
  const double gravity[3] = {0, 0, -3};
  mimo_replay_report report = {.struct_size = sizeof report};
  go(env, 5);
  CHECK_OK(mimo_recorder_close(recorder));
  mimo_recording* recording = open_it();
  CHECK_OK(mimo_recording_seek(recording, heavy, 3, 1, NULL));
  CHECK_OK(mimo_recording_step(recording, heavy, NULL, 0, NULL));
  CHECK_OK(mimo_env_set(heavy, MIMO_WORLD_GRAVITY, NULL, 0, gravity, 3));
  CHECK_OK(mimo_recording_step(recording, heavy, NULL, 0, NULL));
  CHECK_OK(mimo_recording_report(recording, &report));
  CHECK(report.identical == 0 && report.first_difference == 1 && report.next == 2);
  CHECK_TEXT("joints/velocity", report.differs_most_in);
  CHECK(report.largest_difference > 0.001);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "not the world", mimo_recording_step(recording, env, NULL, 0, NULL));
  mimo_recording_close(recording);
  mimo_env_destroy(env);
  mimo_env_destroy(heavy);
}

static int warnings;
static void count_warning(void* user, const mimo_log_record* record) {
  (void)user;
  warnings +=
      record->level == MIMO_LOG_WARNING && strstr(record->text, "the recording has ended: cannot write") != NULL;
}

/* A file that may not grow is a full disk. The steps go on. */
static void a_full_disk_fails_no_step(void) {
  mimo_env_config config;
  mimo_recorder* recorder = NULL;
  struct rlimit before, small;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.log = count_warning;
  mimo_env* env = blind_env("benchmark", &config);
  mimo_recorder_config settings;
  CHECK_OK(mimo_recorder_config_init(&settings, sizeof settings));
  settings.flush_seconds = 0;
  settings.compression = 0;
  settings.state_seconds = 0.01;
  settings.replace = 1;
  CHECK_OK(mimo_recorder_open(env, path, &settings, &recorder));
  go(env, 2);
  CHECK(getrlimit(RLIMIT_FSIZE, &before) == 0);
  small = before;
  small.rlim_cur = 64 * 1024;
  signal(SIGXFSZ, SIG_IGN);
  CHECK(setrlimit(RLIMIT_FSIZE, &small) == 0);
  go(env, 100);
  CHECK(warnings == 1);
  CHECK_FAILS(MIMO_E_FILE, path, mimo_recorder_flush(recorder));
  CHECK_FAILS(MIMO_E_FILE, "check the free space", mimo_recorder_close(recorder));
  CHECK(setrlimit(RLIMIT_FSIZE, &before) == 0);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_recorder_flush(recorder));
  recorder = record(env, NULL); /* the world can be recorded again */
  go(env, 2);
  mimo_env_destroy(env);
  CHECK_OK(mimo_recorder_close(recorder));
  mimo_recording* recording = open_it();
  CHECK(info_of(recording).steps == 2);
  mimo_recording_close(recording);
}

static void write_text(const char* text) {
  FILE* file = fopen(path, "w");
  fputs(text, file);
  fclose(file);
}

static size_t steps_there(void) {
  mimo_recording* recording = open_it();
  const size_t steps = info_of(recording).steps;
  mimo_recording_close(recording);
  return steps;
}

/* A recording is replaced where that is asked for, also one of a program that knows nothing of the member. */
static void a_recording_stays_unless_asked(void) {
  mimo_env* env = blind_env("benchmark", NULL);
  mimo_recorder* recorder = NULL;
  mimo_recorder_config config;
  unlink(path);
  CHECK_OK(mimo_recorder_open(env, path, NULL, &recorder)); /* nothing is there */
  go(env, 3);
  CHECK_OK(mimo_recorder_close(recorder));
  recorder = NULL;
  CHECK_FAILS(MIMO_E_FILE, path, mimo_recorder_open(env, path, NULL, &recorder));
  CHECK_FAILS(MIMO_E_FILE, "only if `replace` is set", mimo_recorder_open(env, path, NULL, &recorder));
  CHECK_OK(mimo_recorder_config_init(&config, sizeof config));
  CHECK(config.replace == 0);
  CHECK_FAILS(MIMO_E_FILE, "only if `replace` is set", mimo_recorder_open(env, path, &config, &recorder));
  CHECK(recorder == NULL && steps_there() == 3);
  config.replace = 2;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "replace is 2", mimo_recorder_open(env, path, &config, &recorder));
  config.replace = 1;
  CHECK_OK(mimo_recorder_open(env, path, &config, &recorder));
  go(env, 2);
  CHECK_OK(mimo_recorder_close(recorder));
  CHECK(steps_there() == 2);
  unlink(path);
  write_text("two years of data");
  CHECK_FAILS(MIMO_E_FILE, "is not overwritten", mimo_recorder_open(env, path, &config, &recorder));
  unlink(path);
  mimo_env_destroy(env);
}

/* Not even with `replace` is anything else written over. */
static void files_of_others_stay(void) {
  char found[32] = "";
  mimo_env *env = blind_env("benchmark", NULL), *neighbour = blind_env("benchmark", NULL);
  mimo_recorder* recorder = NULL;
  mimo_recorder_config config;
  CHECK_OK(mimo_recorder_config_init(&config, sizeof config));
  config.replace = 1;
  write_text("two years of data");
  CHECK_FAILS(MIMO_E_FILE, "is not overwritten", mimo_recorder_open(env, path, &config, &recorder));
  FILE* file = fopen(path, "r");
  CHECK(fgets(found, sizeof found, file) != NULL);
  fclose(file);
  CHECK_TEXT("two years of data", found);
  CHECK(unlink(path) == 0 && mkfifo(path, 0600) == 0); /* at which opening would wait */
  CHECK_FAILS(MIMO_E_FILE, "not a plain file", mimo_recorder_open(env, path, &config, &recorder));
  mimo_recording* recording = NULL;
  CHECK_FAILS(MIMO_E_FILE, "not a plain file", mimo_recording_open(path, NULL, &recording));
  unlink(path);
  write_text(""); /* as mkstemp leaves it */
  recorder = record(env, NULL);
  go(env, 3);
  mimo_recorder* second = NULL;
  CHECK_FAILS(MIMO_E_FILE, "a program is using", mimo_recorder_open(neighbour, path, &config, &second));
  go(env, 1);
  CHECK_OK(mimo_recorder_close(recorder));
  recording = open_it();
  CHECK(info_of(recording).steps == 4);
  mimo_recording_close(recording);
  recorder = record(neighbour, NULL); /* now it may */
  go(neighbour, 2);
  CHECK_OK(mimo_recorder_close(recorder));
  recording = open_it();
  CHECK(info_of(recording).steps == 2);
  mimo_recording_close(recording);
  mimo_env_destroy(env);
  mimo_env_destroy(neighbour);
}

/* Whoever records learns that somebody else has taken the file away, or has cut it. */
static void what_is_taken_away_is_told(void) {
  mimo_env* env = blind_env("benchmark", NULL);
  for (int how = 0; how < 2; ++how) {
    mimo_recorder* recorder = record(env, NULL);
    go(env, 2);
    CHECK_OK(mimo_recorder_flush(recorder));
    CHECK((how == 0 ? unlink(path) : truncate(path, 10)) == 0);
    go(env, 2);
    CHECK_FAILS(MIMO_E_FILE, "another program has", mimo_recorder_flush(recorder));
    CHECK_FAILS(MIMO_E_FILE, "another program has", mimo_recorder_close(recorder));
    unlink(path);
  }
  mimo_env_destroy(env);
}

/* HDF5 would read a damaged beginning again and again, longer than anybody lives. */
static void damaged_beginnings_end(void) {
  enum { BEGINNING = 60 };
  mimo_env* env = blind_env("benchmark", NULL);
  mimo_recording* recording = NULL;
  mimo_recorder* recorder = record(env, "none");
  go(env, 1);
  CHECK_OK(mimo_recorder_close(recorder));
  FILE* file = fopen(path, "r+b");
  alarm(120);
  for (int i = 0; i < BEGINNING; ++i) {
    CHECK(fseek(file, i, SEEK_SET) == 0);
    const int byte = fgetc(file);
    for (int changed = 0; changed < 2; ++changed) {
      CHECK(fseek(file, i, SEEK_SET) == 0 && fputc(changed == 0 ? byte ^ 0x10 : byte, file) != EOF);
      CHECK(fflush(file) == 0);
      if (changed != 0) continue;
      if (mimo_recording_open(path, NULL, &recording) == MIMO_OK) mimo_recording_close(recording);
    }
  }
  fclose(file);
  mimo_recording_close(open_it()); /* whole again */
  for (int size = BEGINNING; size >= 0; --size) {
    CHECK(truncate(path, size) == 0);
    CHECK_FAILS(MIMO_E_FILE, "not a recording", mimo_recording_open(path, NULL, &recording));
  }
  alarm(0);
  unlink(path);
  mimo_env_destroy(env);
}

static void bad_input_is_refused(void) {
  mimo_env *env = world_of("benchmark", 0), *muscles = NULL;
  mimo_recorder *recorder = NULL, *second = NULL;
  mimo_recording* recording = NULL;
  mimo_recorder_config config;
  unlink(path);
  CHECK_OK(mimo_recorder_config_init(&config, sizeof config));
  config.keep = "touch";
  CHECK_FAILS(MIMO_E_NOT_FOUND, "\"touch\"", mimo_recorder_open(env, path, &config, &recorder));
  CHECK(access(path, F_OK) != 0); /* nothing was written */
  CHECK_FAILS(MIMO_E_NOT_FOUND, path, mimo_recording_open(path, NULL, &recording));
  CHECK_FAILS(MIMO_E_FILE, "cannot write /nowhere/", mimo_recorder_open(env, "/nowhere/run.h5", NULL, &recorder));
  recorder = record(env, NULL);
  CHECK_FAILS(MIMO_E_BUSY, "already", mimo_recorder_open(env, other, NULL, &second));
  go(env, 2);
  CHECK_OK(mimo_recorder_close(recorder));
  recording = open_it();
  CHECK_FAILS(MIMO_E_BUSY, "seek", mimo_recording_step(recording, env, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "ends at step 2", mimo_recording_seek(recording, env, 3, 1, NULL));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "wings", mimo_recording_size(recording, "wings", NULL, NULL));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "states", mimo_recording_size(recording, "states", NULL, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "2 rows", mimo_recording_read(recording, "time", 1, 2, action, sizeof action));
  mimo_env_config longer;
  CHECK_OK(mimo_env_config_init(&longer, sizeof longer));
  longer.frame_skip = 3;
  muscles = blind_env("benchmark", &longer);
  CHECK_FAILS(MIMO_E_MISMATCH, "0.015", mimo_recording_seek(recording, muscles, 0, 1, NULL));
  mimo_env_destroy(muscles);
  muscles = blind_env("reach", NULL);
  CHECK_FAILS(MIMO_E_MISMATCH, "joints", mimo_recording_seek(recording, muscles, 0, 1, NULL));
  mimo_recording_close(recording);
  write_text("not a recording");
  recording = NULL;
  CHECK_FAILS(MIMO_E_FILE, "is not a recording", mimo_recording_open(path, NULL, &recording));
  CHECK(recording == NULL);
  mimo_env_destroy(env);
  mimo_env_destroy(muscles);
}

int main(void) {
  const char* folder = getenv("TMPDIR");
  snprintf(path, sizeof path, "%s/mimo_recording_%d.h5", folder == NULL ? "/tmp" : folder, (int)getpid());
  snprintf(other, sizeof other, "%.250s.other", path);
  mimo_recording* none = NULL;
  /* What names no library is told before the system's is looked for. */
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "hdf5 is /nowhere.so", mimo_recording_open(path, "/nowhere.so", &none));
  if (mimo_recording_open(path, NULL, &none) == MIMO_E_UNSUPPORTED) {
    CHECK(strstr(mimo_last_error(), "libhdf5-103-1") != NULL);
    return failures() == 0 ? 77 : failures(); /* HDF5 is not installed */
  }
  what_programs_do_is_replayed();
  other_ages_are_replayed();
  a_file_alone_is_replayed();
  results_of_own_tasks_are_given();
  joints_are_replayed_in_other_models();
  no_task_ends_a_replay();
  what_is_heard_is_kept();
  worlds_of_a_batch_are_recorded();
  a_difference_is_told();
  a_full_disk_fails_no_step();
  a_recording_stays_unless_asked();
  files_of_others_stay();
  what_is_taken_away_is_told();
  damaged_beginnings_end();
  bad_input_is_refused();
  unlink(path);
  unlink(other);
  return failures();
}
