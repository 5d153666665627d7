/*
 * One scenario a scene: seed 7, a hundred steps of fixed actions. Prints a hash over all blocks and the sum of rewards,
 * which ./dev test compares between builds and languages. Here a second world has to give the same; what the numbers
 * themselves should be is the business of tests/golden.
 */
#include "support/capi.h"

enum { kSteps = 100 };

static uint64_t hash_of(uint64_t hash, const uint8_t* bytes, size_t count) { /* FNV-1a */
  size_t i;
  for (i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
  return hash;
}

/* Tenths from -1 to 1: in single precision the same everywhere. */
static float action_of(size_t step, size_t i) { return (float)((int)((7 * step + 3 * i) % 21) - 10) / 10.0f; }

typedef struct {
  uint64_t hash;
  double rewards;
} outcome;

static outcome play(const char* scene, int fill) {
  const uint64_t seed = 7;
  mimo_env* env = NULL;
  size_t bytes = 0, fields = 0, count = 0, step, i;
  outcome all = {UINT64_C(14695981039346656037), 0};
  CHECK_OK(mimo_env_make(scene, &env));
  CHECK_OK(mimo_env_observation_size(env, &bytes, &fields));
  CHECK_OK(mimo_env_action_size(env, &count));
  uint8_t* block = malloc(bytes);
  float* actions = malloc(count * sizeof *actions);
  memset(block, fill, bytes);
  CHECK_OK(mimo_env_reset(env, &seed, block, bytes));
  all.hash = hash_of(all.hash, block, bytes);
  for (step = 0; step < kSteps; ++step) {
    double reward = 0;
    uint8_t terminated = 0, truncated = 0;
    for (i = 0; i < count; ++i) actions[i] = action_of(step, i);
    memset(block, fill, bytes);
    CHECK_OK(mimo_env_step(env, actions, count, block, bytes, &reward, &terminated, &truncated, 1));
    all.hash = hash_of(all.hash, block, bytes);
    all.rewards += reward;
  }
  free(actions);
  free(block);
  mimo_env_destroy(env);
  return all;
}

int main(void) {
  const char* const scenes[] = {"reach", "standup", "selfbody", "benchmark"};
  size_t i;
  for (i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
    const outcome first = play(scenes[i], 0x00), second = play(scenes[i], 0xff);
    printf("%s %016llx %.6f\n", scenes[i], (unsigned long long)first.hash, first.rewards);
    CHECK(second.hash == first.hash && second.rewards == first.rewards);
  }
  return failures();
}
