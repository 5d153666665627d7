/* Saving, loading and cloning worlds. */
#include "support/capi.h"

static size_t bytes;

static uint8_t* state_of(const mimo_env* env) {
  uint8_t* state = malloc(bytes);
  memset(state, 0xaa, bytes);
  CHECK_OK(mimo_env_state_save(env, state, bytes));
  return state;
}

static int same(const mimo_env* env, const uint8_t* expected) {
  uint8_t* state = state_of(env);
  const int equal = memcmp(state, expected, bytes) == 0;
  free(state);
  return equal;
}

static void step(mimo_env* env, int count) {
  while (count-- > 0) CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
}

static void check_round_trip(mimo_env* env) {
  uint8_t *before, *after;
  step(env, 20);
  before = state_of(env);
  step(env, 10);
  after = state_of(env);
  CHECK(memcmp(before, after, bytes) != 0);
  CHECK_OK(mimo_env_state_load(env, before, bytes, NULL));
  CHECK(same(env, before));
  step(env, 10);
  CHECK(same(env, after));
  free(before);
  free(after);
}

static void check_refusals(mimo_env* env) {
  uint8_t *state = state_of(env), *copy = malloc(bytes + 1);
  size_t size = 0, i;
  memset(copy, 0x55, bytes + 1);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "bytes is NULL", mimo_env_state_size(env, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "env is NULL", mimo_env_state_size(NULL, &size));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "state is NULL", mimo_env_state_save(env, NULL, bytes));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "state is NULL", mimo_env_state_load(env, NULL, bytes, NULL));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "state has a length of", mimo_env_state_save(env, copy, bytes - 1));
  for (i = 0; i <= bytes; ++i) CHECK(copy[i] == 0x55);
  memcpy(copy, state, bytes);
  CHECK_FAILS(MIMO_E_FILE, "too few for a state", mimo_env_state_load(env, copy, 0, NULL));
  CHECK_FAILS(MIMO_E_FILE, "state: it has", mimo_env_state_load(env, copy, bytes - 1, NULL));
  CHECK_FAILS(MIMO_E_FILE, "state: it has", mimo_env_state_load(env, copy, bytes + 1, NULL));
  for (i = 0; i < bytes; i += 1 + i / 16) {
    const int in_version = i >= 8 && i < 16; /* a higher one: of a newer library */
    copy[i] ^= 0x10;
    CHECK_FAILS(in_version ? MIMO_E_UNSUPPORTED : MIMO_E_FILE, "state: ", mimo_env_state_load(env, copy, bytes, NULL));
    copy[i] ^= 0x10;
  }
  CHECK(same(env, state));
  CHECK_OK(mimo_env_state_load(env, copy, bytes, NULL));
  free(copy);
  free(state);
}

static void check_versions(mimo_env* env) {
  uint8_t* state = state_of(env);
  uint64_t version;
  memcpy(&version, state + 8, sizeof version); /* behind the magic number */
  ++version;
  memcpy(state + 8, &version, sizeof version);
  memset(state + 16, 0x33, bytes - 16); /* all else may be of another form */
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "needs a newer library", mimo_env_state_load(env, state, bytes, NULL));
  version -= 2;
  memcpy(state + 8, &version, sizeof version);
  CHECK_FAILS(MIMO_E_FILE, "its version is 1", mimo_env_state_load(env, state, bytes, NULL));
  free(state);
}

static void check_other_model(mimo_env* env) {
  uint8_t* state = state_of(env);
  mimo_env* other = blind_env("benchmark", NULL);
  CHECK_FAILS(MIMO_E_MISMATCH, "another model", mimo_env_state_load(other, state, bytes, NULL));
  mimo_env_destroy(other);
  free(state);
}

static void check_clone(mimo_env* env) {
  uint8_t *state = state_of(env), *later;
  mimo_env* twin = NULL;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "clone is NULL", mimo_env_clone(env, NULL));
  CHECK_OK(mimo_env_clone(env, &twin));
  CHECK(same(twin, state));
  step(twin, 7);
  CHECK(same(env, state));
  later = state_of(twin);
  mimo_env_destroy(twin);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_env_state_save(twin, later, bytes));
  step(env, 7);
  CHECK(same(env, later));
  free(later);
  free(state);
}

static void check_failed(mimo_env* env) {
  uint8_t *state = state_of(env), *room = malloc(bytes);
  mimo_env* twin = NULL;
  const int32_t joint = find(env, MIMO_JOINT, "robot:left_elbow");
  const double fast = 1e200;
  CHECK_OK(mimo_env_set(env, MIMO_JOINT_VELOCITY, &joint, 1, &fast, 1));
  CHECK_FAILS(MIMO_E_SIMULATION, "failed", mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_SIMULATION, "failed before", mimo_env_state_save(env, room, bytes));
  CHECK_FAILS(MIMO_E_SIMULATION, "failed before", mimo_env_clone(env, &twin));
  CHECK(twin == NULL);
  CHECK_OK(mimo_env_state_load(env, state, bytes, NULL));
  CHECK(same(env, state));
  step(env, 1);
  free(room);
  free(state);
}

static void check_random(mimo_env* env) {
  uint8_t* state = state_of(env);
  double first[5], again[5];
  size_t i;
  CHECK_OK(mimo_env_random(env, first, 5));
  for (i = 0; i < 5; ++i) CHECK(first[i] >= 0 && first[i] < 1 && (i == 0 || first[i] != first[i - 1]));
  CHECK_OK(mimo_env_state_load(env, state, bytes, NULL));
  CHECK_OK(mimo_env_random(env, again, 5));
  CHECK(memcmp(first, again, sizeof first) == 0);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "values is NULL", mimo_env_random(env, NULL, 1));
  CHECK_OK(mimo_env_random(env, NULL, 0));
  free(state);
}

int main(void) {
  mimo_env* env = blind_env("free", NULL);
  CHECK_OK(mimo_env_state_size(env, &bytes));
  check_round_trip(env);
  check_refusals(env);
  check_versions(env);
  check_other_model(env);
  check_clone(env);
  check_failed(env);
  check_random(env);
  mimo_env_destroy(env);
  return failures();
}
