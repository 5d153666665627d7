/* States of worlds that go on with versions to come.
 *   kept_states write FOLDER   saves a few, with the numbers that follow from them (./dev freeze does it for a version)
 *   kept_states check FOLDER   loads them, and finds those numbers again: at once exactly, later to rounding
 *   kept_states go FROM N TO [N TO...]   loads them, goes on for N steps, and saves them; tools/elsewhere.py moves them
 * so
 */
#include "support/capi.h"

enum { STEPS = 30, FURTHER = 20, MOST = 1 << 16, NUMBERS = 512 };

static const char* const kNames[] = {"free", "reach", "limited"};

/* An infant whose senses and left arm are late and noisy. */
static mimo_env* limited_env(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_limits limits;
  mimo_env* env = NULL;
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.delay = 0.05;
  limits.noise = 0.01;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "proprioception", &limits));
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "vestibular", &limits));
  CHECK_OK(mimo_scene_limit_motor(scene, 0, "left_arm", &limits));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  return env;
}

static mimo_env* env_of(const char* name) {
  mimo_env* env = NULL;
  if (strcmp(name, "free") == 0) return blind_env("free", NULL);
  if (strcmp(name, "limited") == 0) return limited_env();
  CHECK_OK(mimo_env_make(name, &env));
  return env;
}

static void step(mimo_env* env, int count) {
  float action[256];
  size_t actions = 0, i;
  actions = sizes_of(env).actions;
  while (count-- > 0) {
    for (i = 0; i < actions; ++i) action[i] = 0.3f * (float)((int)(i * 7 + (size_t)count * 3) % 5 - 2);
    CHECK_OK(mimo_env_step(env, action, actions, NULL, 0, NULL));
  }
}

/* Where everything is, the time, and what is sensed: the sum of all floats of the block. */
static size_t look(mimo_env* env, double* numbers) {
  int32_t ids[128];
  size_t joints = 0, width = 0, bytes = 0, i;
  float* block;
  CHECK_OK(mimo_env_count(env, MIMO_JOINT, &joints));
  for (i = 0; i < joints; ++i) ids[i] = (int32_t)i;
  CHECK_OK(mimo_env_width(env, MIMO_JOINT_POSITION, ids, joints, &width));
  CHECK(width + 3 <= NUMBERS);
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, ids, joints, numbers, width));
  CHECK_OK(mimo_env_time(env, &numbers[width]));
  bytes = sizes_of(env).block_bytes;
  block = malloc(bytes);
  if (block == NULL) exit(1);
  CHECK_OK(mimo_env_observe(env, block, bytes));
  numbers[width + 1] = 0;
  for (i = 0; i < bytes / sizeof *block; ++i) numbers[width + 1] += fabs((double)block[i]);
  free(block);
  return width + 2;
}

static FILE* open_file(const char* folder, const char* name, const char* end, const char* how) {
  char path[500];
  FILE* file;
  snprintf(path, sizeof path, "%s/%s.%s", folder, name, end);
  file = fopen(path, how);
  if (file == NULL) {
    fprintf(stderr, "%s cannot be opened\n", path);
    exit(1);
  }
  return file;
}

static void write_numbers(FILE* file, mimo_env* env) {
  double numbers[NUMBERS];
  const size_t count = look(env, numbers);
  size_t i;
  for (i = 0; i < count; ++i) fprintf(file, "%.17g\n", numbers[i]);
}

static void save(mimo_env* env, const char* folder, const char* name) {
  static uint8_t state[MOST];
  size_t bytes = 0;
  FILE* file;
  CHECK_OK(mimo_env_state_size(env, &bytes));
  CHECK(bytes <= sizeof state);
  CHECK_OK(mimo_env_state_save(env, state, sizeof state));
  file = open_file(folder, name, "state", "wb");
  CHECK(fwrite(state, 1, bytes, file) == bytes);
  fclose(file);
}

static void load(mimo_env* env, const char* folder, const char* name) {
  static uint8_t state[MOST];
  mimo_load_report report;
  FILE* file = open_file(folder, name, "state", "rb");
  const size_t bytes = fread(state, 1, sizeof state, file);
  fclose(file);
  report.struct_size = sizeof report;
  CHECK_OK(mimo_env_state_load(env, state, bytes, &report));
  CHECK(report.fresh == 0 && report.ignored == 0);
}

static void write_state(const char* folder, const char* name) {
  mimo_env* env = env_of(name);
  FILE* file;
  CHECK_OK(mimo_env_reset(env, SEED(5), NULL, 0));
  step(env, STEPS);
  save(env, folder, name);
  file = open_file(folder, name, "txt", "w");
  write_numbers(file, env);
  step(env, FURTHER);
  write_numbers(file, env);
  fclose(file);
  mimo_env_destroy(env);
}

static void check_numbers(FILE* file, mimo_env* env, double tolerance) {
  double numbers[NUMBERS], expected = 0;
  const size_t count = look(env, numbers);
  size_t i;
  for (i = 0; i < count; ++i) {
    CHECK(fscanf(file, "%lf", &expected) == 1);
    CHECK_NEAR(expected, numbers[i], tolerance * (1 + fabs(expected)));
  }
}

static void check_state(const char* folder, const char* name) {
  mimo_env* env = env_of(name);
  FILE* file;
  load(env, folder, name);
  file = open_file(folder, name, "txt", "r");
  check_numbers(file, env, 1e-12);
  step(env, FURTHER);
  check_numbers(file, env, 1e-6);
  fclose(file);
  mimo_env_destroy(env);
}

static void go_on(const char* name, char** from, int count) {
  mimo_env* env = env_of(name);
  int i;
  load(env, from[0], name);
  for (i = 1; i + 1 < count; i += 2) {
    step(env, atoi(from[i]));
    save(env, from[i + 1], name);
  }
  mimo_env_destroy(env);
}

int main(int argc, char** argv) {
  size_t i;
  const char* what = argc > 2 ? argv[1] : "";
  const int goes = strcmp(what, "go") == 0, writes = strcmp(what, "write") == 0;
  if (!goes && !writes && strcmp(what, "check") != 0) {
    fprintf(stderr, "usage: %s write|check FOLDER, or go FROM STEPS TO...\n", argv[0]);
    return 2;
  }
  for (i = 0; i < sizeof kNames / sizeof *kNames; ++i) {
    if (goes)
      go_on(kNames[i], argv + 2, argc - 2);
    else if (writes)
      write_state(argv[2], kNames[i]);
    else
      check_state(argv[2], kNames[i]);
  }
  return failures();
}
