/*
 * One scenario a scene: seed 7, a hundred steps of fixed actions, a hash over all blocks. Prints the hashes, which are
 * the same for every build and every language on one machine (./dev test compares builds), and checks the sums of
 * rewards, which are the same on every machine to a tolerance.
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

static void run(const char* scene, double rewards) {
  const uint64_t seed = 7;
  mimo_env* env = NULL;
  size_t bytes = 0, fields = 0, count = 0, step, i;
  uint64_t hash = UINT64_C(14695981039346656037);
  double sum = 0;
  CHECK_OK(mimo_env_make(scene, &env));
  CHECK_OK(mimo_env_observation_size(env, &bytes, &fields));
  CHECK_OK(mimo_env_action_size(env, &count));
  uint8_t* block = malloc(bytes);
  float* actions = malloc(count * sizeof *actions);
  CHECK_OK(mimo_env_reset(env, &seed, block, bytes));
  hash = hash_of(hash, block, bytes);
  for (step = 0; step < kSteps; ++step) {
    double reward = 0;
    uint8_t terminated = 0, truncated = 0;
    for (i = 0; i < count; ++i) actions[i] = action_of(step, i);
    CHECK_OK(mimo_env_step(env, actions, count, block, bytes, &reward, &terminated, &truncated, 1));
    hash = hash_of(hash, block, bytes);
    sum += reward;
  }
  printf("%s %016llx %.6f\n", scene, (unsigned long long)hash, sum);
  CHECK_NEAR(rewards, sum, 1e-3);
  free(actions);
  free(block);
  mimo_env_destroy(env);
}

/* Sums of rewards as this library gave them on x86-64 with MuJoCo 2.2.2, November 2026. */
int main(void) {
  run("reach", -33.734464);
  run("standup", 10.351069);
  run("selfbody", 5934.463914);
  run("benchmark", 0);
  return failures();
}
