/* A refused call changes nothing, and numbers that are not finite are refused. */
#include <float.h>

#include "support/capi.h"

enum { WORLDS = 2, MOST = 4096 };

/* Poses belong to the start of the last physics step until somebody asks for new ones. */
static void check_that_looking_waits_for_an_update(void) {
  mimo_env* env = blind_env("free", NULL);
  const double point[3] = {1, 0, 0.5};
  const int32_t head = find(env, MIMO_BODY, "head");
  double before[3], after[3], angles[8];
  int32_t joints[8];
  size_t count = 77;
  int i;
  for (i = 0; i < 20; ++i) CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &head, 1, before, 3));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "capacity is 7, but there are 8 joints",
              mimo_env_look_angles(env, 0, point, MIMO_LOOK_HEAD, joints, angles, 7, &count, NULL));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "capacity is 5, but there are 6 joints",
              mimo_env_look_angles(env, 0, point, MIMO_LOOK_EYES, joints, angles, 5, &count, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "capacity has",
              mimo_env_look_angles(env, 0, point, MIMO_LOOK_EYES, joints, NULL, (size_t)-1, &count, NULL));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "how is 2", mimo_env_look_angles(env, 0, point, 2, joints, angles, 8, &count, NULL));
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &head, 1, after, 3));
  CHECK(memcmp(before, after, sizeof before) == 0 && count == 77);
  CHECK_OK(mimo_env_look_angles(env, 0, point, MIMO_LOOK_HEAD, joints, angles, 8, &count, NULL));
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &head, 1, after, 3));
  CHECK(count == 8 && memcmp(before, after, sizeof before) == 0); /* looking changes nothing when it is done, either */
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION | MIMO_NOW, &head, 1, after, 3));
  CHECK(memcmp(before, after, sizeof before) != 0); /* else the above proves nothing */
  mimo_env_destroy(env);
}

static void check_results_of_a_batch(int32_t autoreset) {
  mimo_scene* scene = blind_scene("free");
  mimo_batch_config config;
  mimo_batch_results results;
  mimo_batch* batch = NULL;
  mimo_env* view = NULL;
  size_t bytes = 0, actions = 0, i;
  float action[MOST] = {0};
  uint8_t *blocks, ends[WORLDS], cuts[WORLDS], was_reset[WORLDS], written[WORLDS];
  double reward[WORLDS], time;
  mimo_status status[WORLDS];
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.autoreset = autoreset;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  CHECK_OK(mimo_batch_world(batch, 1, &view));
  bytes = sizes_of(view).block_bytes;
  actions = sizes_of(view).actions;
  CHECK(WORLDS * actions <= MOST);
  blocks = malloc(WORLDS * bytes);
  if (blocks == NULL) exit(1);
  memset(blocks, 0x5a, WORLDS * bytes);
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = reward;
  results.terminated = ends;
  results.truncated = cuts;
  results.was_reset = was_reset;
  results.final_written = written;
  results.status = status;
  results.agent_count = results.worlds = WORLDS;
  for (i = 0; i < WORLDS; ++i) {
    reward[i] = 7;
    ends[i] = cuts[i] = was_reset[i] = written[i] = 0x5a;
  }
  action[actions + 3] = NAN;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "world 1: action[3] is not a number",
              mimo_batch_step(batch, action, WORLDS * actions, blocks, WORLDS * bytes, &results));
  CHECK(status[0] == MIMO_OK && status[1] == MIMO_E_INVALID_ARGUMENT);
  CHECK(reward[0] == 0 && !ends[0] && !cuts[0] && !was_reset[0] && !written[0]);
  CHECK(reward[1] == 7 && ends[1] == 0x5a && cuts[1] == 0x5a && was_reset[1] == 0x5a && written[1] == 0x5a);
  for (i = 0; i < bytes && blocks[bytes + i] == 0x5a; ++i) continue;
  CHECK(i == bytes);
  CHECK_OK(mimo_env_time(view, &time));
  CHECK(time == 0);
  free(blocks);
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
}

/* A cart with two motors: one with bounds, one without. */
static const char kCart[] =
    "<mujoco><worldbody><body name='cart'><joint name='x' type='slide' axis='1 0 0'/><geom size='0.1' mass='1'/>"
    "</body></worldbody><actuator><motor name='free' joint='x' ctrllimited='false'/>"
    "<motor name='bound' joint='x' ctrllimited='true' ctrlrange='-1 1'/></actuator></mujoco>";

static mimo_scene* cart_scene(void) {
  mimo_scene_config config;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.xml = kCart;
  CHECK_OK(mimo_scene_create(&config, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.body = "scene";
  agent.root = "cart";
  agent.vision = agent.touch = agent.vestibular = 0;
  agent.proprioception = MIMO_PROPRIOCEPTION_POSITION | MIMO_PROPRIOCEPTION_VELOCITY;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  return scene;
}

static void check_that_actions_are_finite(void) {
  mimo_scene* scene = cart_scene();
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  float action[2] = {INFINITY, 0};
  double time = -1, control[2];
  const int32_t ids[2] = {0, 1};
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "action[0] is inf, expected a finite number: it has no bounds",
              mimo_env_step(env, action, 2, NULL, 0, NULL));
  action[0] = -INFINITY;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "action[0] is -inf", mimo_env_step(env, action, 2, NULL, 0, NULL));
  CHECK_OK(mimo_env_time(env, &time));
  CHECK(time == 0);
  CHECK_OK(mimo_batch_create(scene, NULL, NULL, &batch));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "world 0: action[0] is -inf", mimo_batch_step(batch, action, 2, NULL, 0, NULL));
  mimo_batch_destroy(batch);
  action[0] = 2;
  action[1] = INFINITY; /* clipped to its bounds, as any other */
  CHECK_OK(mimo_env_step(env, action, 2, NULL, 0, NULL));
  CHECK_OK(mimo_env_get(env, MIMO_ACTUATOR_CONTROL, ids, 2, control, 2));
  CHECK(control[0] == 2 && control[1] == 1);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* Gain and noise that no float holds are refused; with the largest ones what comes out is the largest float at most. */
static void check_refused_limits(void) {
  mimo_scene* scene = cart_scene();
  mimo_env* env = NULL;
  mimo_limits limits;
  uint64_t seed;
  size_t bytes = 0, i;
  float block[MOST / sizeof(float)];
  int largest = 0;
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.gain = 1e308;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "gain is 1e+308, expected a factor from 0 to 3.403e+38",
              mimo_scene_limit_sense(scene, 0, "proprioception", &limits));
  limits.gain = 1;
  limits.noise = 1e308;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "noise is 1e+308, expected a deviation from 0 to 3.403e+38",
              mimo_scene_limit_sense(scene, 0, "proprioception", &limits));
  limits.gain = limits.noise = FLT_MAX;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "proprioception", &limits));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  bytes = sizes_of(env).block_bytes;
  CHECK(bytes <= sizeof block);
  for (seed = 0; seed < 50; ++seed) {
    CHECK_OK(mimo_env_reset(env, SEED(seed), block, bytes));
    for (i = 0; i < bytes / sizeof(float); ++i) {
      CHECK(isfinite(block[i]));
      largest += fabsf(block[i]) == FLT_MAX;
    }
  }
  CHECK(largest > 0); /* a third of the numbers of a normal distribution lie beyond its deviation */
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* The message fits structs with and without an _init function. */
static void check_refused_struct_sizes(void) {
  mimo_env* env = blind_env("free", NULL);
  mimo_field field;
  memset(&field, 0, sizeof field);
  CHECK_FAILS(MIMO_E_STRUCT_SIZE, "field: struct_size is 0, expected 120, the struct's sizeof",
              mimo_layout_field(layout_of(env), 0, &field));
  CHECK(strstr(mimo_last_error(), "_init") == NULL);
  mimo_env_destroy(env);
}

int main(void) {
  check_that_looking_waits_for_an_update();
  check_results_of_a_batch(MIMO_AUTORESET_NONE);
  check_results_of_a_batch(MIMO_AUTORESET_NEXT_STEP);
  check_results_of_a_batch(MIMO_AUTORESET_SAME_STEP);
  check_that_actions_are_finite();
  check_refused_limits();
  check_refused_struct_sizes();
  return failures();
}
