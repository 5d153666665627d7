/* Batches: arguments, views of worlds, handles. Unit tests check what batches compute. */
#include <pthread.h>

#include "support/capi.h"

enum { WORLDS = 4 };

static size_t bytes, actions;

static mimo_batch* make(int32_t autoreset, uint32_t max_steps) {
  mimo_scene* scene = blind_scene("free");
  mimo_env_config env;
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  CHECK_OK(mimo_env_config_init(&env, sizeof env));
  env.max_steps = max_steps;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 2;
  config.autoreset = autoreset;
  CHECK_OK(mimo_batch_create(scene, &env, &config, &batch));
  mimo_scene_destroy(scene);
  if (batch == NULL) exit(failures());
  return batch;
}

static void check_batch_configs(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  size_t worlds = 0, threads = 0;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  CHECK(config.worlds == 1 && config.threads == 0 && config.autoreset == MIMO_AUTORESET_NONE);
#define NO_BATCH(status, part, field, value, good)                              \
  do {                                                                          \
    config.field = (value);                                                     \
    CHECK_FAILS(status, part, mimo_batch_create(scene, NULL, &config, &batch)); \
    config.field = (good);                                                      \
  } while (0)
  NO_BATCH(MIMO_E_INVALID_ARGUMENT, "worlds is 0, expected 1 to", worlds, 0, 1);
  NO_BATCH(MIMO_E_INVALID_ARGUMENT, "worlds is 4294967295", worlds, UINT32_MAX, 1);
  NO_BATCH(MIMO_E_INVALID_ARGUMENT, "threads is 5000", threads, 5000, 0);
  NO_BATCH(MIMO_E_UNSUPPORTED, "autoreset is 3", autoreset, 3, 0);
  NO_BATCH(MIMO_E_UNSUPPORTED, "restart_failed is 2", restart_failed, 2, 0);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "batch is NULL", mimo_batch_create(scene, NULL, &config, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "scene is NULL", mimo_batch_create(NULL, NULL, &config, &batch));
  CHECK(batch == NULL);
  CHECK_OK(mimo_batch_create(scene, NULL, NULL, &batch));
  CHECK_OK(mimo_batch_size(batch, &worlds, &threads));
  CHECK(worlds == 1 && threads == 1);
  mimo_batch_destroy(batch);
  mimo_batch_destroy(batch);
  mimo_batch_destroy(NULL);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "batch is a mimo_batch that has been destroyed",
              mimo_batch_size(batch, &worlds, NULL));
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "not a mimo_batch", mimo_batch_size((const mimo_batch*)scene, &worlds, NULL));
  mimo_scene_destroy(scene);
}

static void check_views(mimo_batch* batch) {
  mimo_env *view = NULL, *again = NULL, *twin = NULL;
  double time = -1;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "world is 4, but there are 4", mimo_batch_world(batch, WORLDS, &view));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "env is NULL", mimo_batch_world(batch, 0, NULL));
  CHECK_OK(mimo_batch_world(batch, 2, &view));
  CHECK_OK(mimo_batch_world(batch, 2, &again));
  CHECK(view == again);
  bytes = sizes_of(view).block_bytes;
  actions = sizes_of(view).actions;
  mimo_env_destroy(view); /* is the batch's */
  CHECK_OK(mimo_env_step(view, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_time(view, &time));
  CHECK_NEAR(0.01, time, 1e-12);
  CHECK_OK(mimo_env_clone(view, &twin));
  CHECK_OK(mimo_env_time(twin, &time));
  CHECK_NEAR(0.01, time, 1e-12);
  mimo_env_destroy(twin);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_env_time(twin, &time));
}

static void check_arguments(mimo_batch* batch) {
  uint8_t *blocks = malloc(WORLDS * bytes), mask[WORLDS] = {1, 0, 1, 0};
  float* action = calloc(WORLDS * actions, sizeof *action);
  uint64_t seeds[WORLDS] = {1, 2, 3, 4};
  double reward[WORLDS] = {9, 9, 9, 9}, value[WORLDS];
  mimo_status status[WORLDS] = {9, 9, 9, 9};
  int32_t id = 1;
  mimo_batch_results results;
  memset(&results, 0, sizeof results);
  memset(blocks, 0x77, WORLDS * bytes);

  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "worlds is 3, expected 4",
              mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = 3), NULL, 0));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "worlds is 0, expected 4",
              mimo_batch_reset(batch, SEEDS(.mask = mask), NULL, 0));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "blocks has a length",
              mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = WORLDS), blocks, WORLDS * bytes - 1));
  CHECK_OK(mimo_batch_reset(batch, SEEDS(.seeds = seeds, .mask = mask, .worlds = WORLDS), NULL, 0));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "action_count is 1, expected", mimo_batch_step(batch, action, 1, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "actions is NULL", mimo_batch_step(batch, NULL, 1, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_STRUCT_SIZE, "results", mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
  results.struct_size = sizeof results;
  results.reward = reward;
  results.agent_count = WORLDS - 1;
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "agent_count is 3", mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
  results.agent_count = WORLDS;
  results.status = status;
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "worlds is 0", mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
  results.worlds = WORLDS;
  results.final_blocks = blocks;
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "final_blocks", mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
  results.final_blocks = NULL;
  CHECK(reward[0] == 9 && status[0] == 9 && blocks[0] == 0x77);
  CHECK_OK(mimo_batch_step(batch, action, WORLDS * actions, blocks, WORLDS * bytes, &results));
  CHECK(reward[3] == 0 && status[3] == 0);

  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "blocks is NULL", mimo_batch_observe(batch, NULL, 0, NULL, 0));
  CHECK_OK(mimo_batch_observe(batch, mask, WORLDS, blocks, WORLDS * bytes));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "value_count is 3",
              mimo_batch_get(batch, MIMO_BODY_MASS, &id, 1, NULL, 0, value, 3));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "values is NULL",
              mimo_batch_get(batch, MIMO_BODY_MASS, &id, 1, NULL, 0, NULL, WORLDS));
  CHECK_OK(mimo_batch_get(batch, MIMO_BODY_MASS, &id, 1, NULL, 0, value, WORLDS));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "can only be read",
              mimo_batch_set(batch, MIMO_BODY_VELOCITY, &id, 1, NULL, 0, value, WORLDS));
  CHECK_FAILS(MIMO_E_BUSY, "receive without", mimo_batch_receive(batch));
  free(action);
  free(blocks);
}

/* States of a newer library, one for each world or one for all, of which only the version can be read. No world
 * changes. */
static void check_newer_states(mimo_batch* batch, const uint8_t* states, size_t size) {
  const size_t length = WORLDS * size;
  uint8_t *newer = malloc(length), *after = malloc(length), *last = newer + (WORLDS - 1) * size;
  memcpy(newer, states, length);
  ++last[8]; /* its version */
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "needs a newer library", mimo_batch_state_load(batch, NULL, 0, newer, length, NULL));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "needs a newer library", mimo_batch_state_load(batch, NULL, 0, last, size, NULL));
  memset(last + 16, 0x33, size - 16);
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "needs a newer library", mimo_batch_state_load(batch, NULL, 0, last, size, NULL));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "needs a newer library", mimo_batch_state_load(batch, NULL, 0, last, size - 1, NULL));
  CHECK_OK(mimo_batch_state_save(batch, NULL, 0, after, length));
  CHECK(memcmp(after, states, length) == 0);
  free(after);
  free(newer);
}

/* One row of many is damaged: no world loads its state, and the error of each world is kept. */
static void check_damaged_rows(mimo_batch* batch, const uint8_t* states, size_t size) {
  const size_t length = WORLDS * size;
  const char* message = NULL;
  mimo_status status = MIMO_OK;
  uint8_t *damaged = malloc(length), *before = malloc(length), *after = malloc(length);
  int i;
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_state_save(batch, NULL, 0, before, length));
  CHECK(memcmp(before, states, length) != 0);
  for (i = 0; i < WORLDS; ++i) {
    memcpy(damaged, states, length);
    damaged[(size_t)i * size + size / 2] ^= 1;
    CHECK_FAILS(MIMO_E_FILE, "damaged", mimo_batch_state_load(batch, NULL, 0, damaged, length, NULL));
    CHECK_OK(mimo_batch_world_error(batch, (size_t)i, &status, &message));
    CHECK(status == MIMO_E_FILE && strstr(message, "damaged") != NULL);
    CHECK_OK(mimo_batch_world_error(batch, (size_t)((i + 1) % WORLDS), &status, NULL));
    CHECK(status == MIMO_OK);
    CHECK_OK(mimo_batch_state_save(batch, NULL, 0, after, length));
    CHECK(memcmp(after, before, length) == 0);
  }
  CHECK_OK(mimo_batch_state_load(batch, NULL, 0, states, length, NULL));
  free(after);
  free(before);
  free(damaged);
}

/* A wrong number of bytes: the message has the right one. */
static void check_state_bytes(mimo_batch* batch, const uint8_t* states, size_t size) {
  char right[64];
  snprintf(right, sizeof right, "expected %zu", WORLDS * size);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, right, mimo_batch_state_load(batch, NULL, 0, states, WORLDS * size - 1, NULL));
  CHECK_FAILS(MIMO_E_FILE, right, mimo_batch_state_load(batch, NULL, 0, states, WORLDS * size - WORLDS, NULL));
}

static void check_states(mimo_batch* batch) {
  mimo_env* view = NULL;
  size_t size = 0;
  uint8_t* states;
  CHECK_OK(mimo_batch_world(batch, 0, &view));
  CHECK_OK(mimo_env_state_size(view, &size));
  states = malloc(WORLDS * size);
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "states", mimo_batch_state_save(batch, NULL, 0, states, WORLDS * size - 1));
  CHECK_OK(mimo_batch_state_save(batch, NULL, 0, states, WORLDS * size));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "state_bytes is", mimo_batch_state_load(batch, NULL, 0, states, 2 * size, NULL));
  CHECK_OK(mimo_batch_state_load(batch, NULL, 0, states, WORLDS * size, NULL));
  check_newer_states(batch, states, size);
  check_damaged_rows(batch, states, size);
  check_state_bytes(batch, states, size);
  CHECK_OK(mimo_batch_state_load(batch, NULL, 0, states + size, size, NULL));
  free(states);
}

static void check_sending(mimo_batch* batch) {
  mimo_env* view = NULL;
  size_t worlds = 0;
  double time = 0;
  CHECK_OK(mimo_batch_world(batch, 0, &view));
  CHECK_OK(mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_BUSY, "at work", mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_BUSY, "at work", mimo_env_time(view, &time));
  CHECK_OK(mimo_batch_size(batch, &worlds, NULL));
  CHECK_OK(mimo_batch_receive(batch));
  CHECK_OK(mimo_env_time(view, &time));
}

static void check_failures(mimo_batch* batch) {
  mimo_env* view = NULL;
  mimo_status status = 9;
  const char* message = NULL;
  const double fast = 1e200;
  int32_t joint;
  CHECK_OK(mimo_batch_world(batch, 1, &view));
  joint = find(view, MIMO_JOINT, "robot:left_elbow");
  CHECK_OK(mimo_env_set(view, MIMO_JOINT_VELOCITY, &joint, 1, &fast, 1));
  CHECK_FAILS(MIMO_E_SIMULATION, "world 1: the simulation failed", mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_world_error(batch, 1, &status, &message));
  CHECK(status == MIMO_E_SIMULATION && strstr(message, "the simulation failed") != NULL);
  CHECK_OK(mimo_batch_world_error(batch, 0, &status, &message));
  CHECK(status == MIMO_OK);
  CHECK_TEXT("", message);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "world is 4", mimo_batch_world_error(batch, WORLDS, &status, &message));
  CHECK_OK(mimo_batch_reset(batch, NULL, NULL, 0));
}

/* Batches of their own in several threads. */
static void* use_one(void* unused) {
  mimo_batch* batch = make(MIMO_AUTORESET_SAME_STEP, 3);
  int i;
  for (i = 0; i < 10; ++i) CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  mimo_batch_destroy(batch);
  return unused;
}

static void check_two_batches_on_two_threads(void) {
  pthread_t threads[2];
  int i;
  for (i = 0; i < 2; ++i) CHECK(pthread_create(&threads[i], NULL, use_one, NULL) == 0);
  for (i = 0; i < 2; ++i) CHECK(pthread_join(threads[i], NULL) == 0);
}

int main(void) {
  mimo_batch* batch;
  mimo_env* view = NULL;
  double time;
  check_batch_configs();
  batch = make(MIMO_AUTORESET_NONE, 0);
  check_views(batch);
  check_arguments(batch);
  check_states(batch);
  check_sending(batch);
  check_failures(batch);
  check_two_batches_on_two_threads();
  CHECK_OK(mimo_batch_world(batch, 0, &view));
  CHECK_OK(mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
  mimo_batch_destroy(batch); /* waits */
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "env is a mimo_env that has been destroyed", mimo_env_time(view, &time));
  return failures();
}
