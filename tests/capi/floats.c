/* A host whose threads calculate with traps, another rounding, or without denormals: it gets the same bytes as every
 * host, no signal, and finds its settings unchanged. */
#define _GNU_SOURCE /* feenableexcept */
#include <fenv.h>

#include "support/capi.h"

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

enum { WORLDS = 4, STEPS = 8, SIDE = 16 };

typedef void (*ways)(void);

static void by_the_book(void) { fesetenv(FE_DFL_ENV); }
static void trapping(void) { feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW | FE_INEXACT); }
static void downwards(void) { fesetround(FE_DOWNWARD); }
static void upwards(void) { fesetround(FE_UPWARD); }
static void towards_zero(void) { fesetround(FE_TOWARDZERO); }
#if defined(__x86_64__)
static void flushing(void) { _mm_setcsr(_mm_getcsr() | 0x8040); }
static void flushing_and_trapping(void) { _mm_setcsr((_mm_getcsr() | 0x8040) & ~0x1f80u); }
static void single_precision(void) {
  const unsigned short control = 0x007f; /* of the x87: what Direct3D 9 sets */
  __asm__ volatile("fldcw %0" : : "m"(control));
}
#endif

static const struct {
  const char* name;
  ways set;
} all_ways[] = {
    {"by the book", by_the_book},
    {"trapping", trapping},
    {"downwards", downwards},
    {"upwards", upwards},
    {"towards zero", towards_zero},
#if defined(__x86_64__)
    {"flushing", flushing},
    {"flushing and trapping", flushing_and_trapping},
    {"single precision", single_precision},
#endif
};
enum { WAYS = sizeof all_ways / sizeof all_ways[0] };

static ways own;         /* of the host */
static ways of_the_task; /* what the task's functions leave behind */

typedef struct registers {
  unsigned sse;
  unsigned x87[2];
} registers;

static registers look(void) {
  registers now = {0, {0, 0}};
#if defined(__x86_64__)
  unsigned short control, status;
  __asm__ volatile("fnstcw %0" : "=m"(control));
  __asm__ volatile("fnstsw %0" : "=m"(status));
  now.sse = _mm_getcsr();
  now.x87[0] = control;
  now.x87[1] = status;
#else
  now.sse = (unsigned)fegetround();
  now.x87[0] = (unsigned)fegetexcept();
  now.x87[1] = (unsigned)fetestexcept(FE_ALL_EXCEPT);
#endif
  return now;
}

/* Calls with the host's way of calculating; the test itself calculates by the book. */
#define AS_HOST(call)                                                       \
  do {                                                                      \
    mimo_status given_;                                                     \
    registers before_, after_;                                              \
    fesetenv(FE_DFL_ENV);                                                   \
    feraiseexcept(FE_OVERFLOW);                                             \
    own();                                                                  \
    before_ = look();                                                       \
    given_ = (call);                                                        \
    after_ = look();                                                        \
    fesetenv(FE_DFL_ENV);                                                   \
    check_status(MIMO_OK, "", given_, #call, __LINE__);                     \
    check(memcmp(&before_, &after_, sizeof before_) == 0, #call, __LINE__); \
  } while (0)

static mimo_status destroy_env(mimo_env* env) {
  mimo_env_destroy(env);
  return MIMO_OK;
}

static mimo_status destroy_batch(mimo_batch* batch) {
  mimo_batch_destroy(batch);
  return MIMO_OK;
}

/* Its reward is different for every rounding, and a trap. */
static mimo_status judge(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  volatile double ten = 10, tiny = 1e-310, one = 1;
  double time = 0;
  (void)user, (void)moment;
  if (mimo_env_time(env, &time) != MIMO_OK) return MIMO_E_INTERNAL;
  verdict->reward = time + one / ten + tiny / ten * 1e300 + -(one / ten) * 1e-17;
  of_the_task();
  return MIMO_OK;
}

static mimo_status start(void* user, mimo_env* env, const mimo_task_moment* moment) {
  (void)user, (void)env, (void)moment;
  of_the_task();
  return MIMO_OK;
}

static void say(void* user, const mimo_log_record* record) {
  (void)user;
  (void)record;
  of_the_task();
}

static uint64_t hash_of(uint64_t hash, const void* data, size_t count) { /* FNV-1a */
  const uint8_t* bytes = data;
  size_t i;
  for (i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
  return hash;
}

static mimo_scene* make_scene(void) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_task task;
  mimo_scene* scene = NULL;
  AS_HOST(mimo_scene_config_init(&room, sizeof room));
  room.name = "benchmark";
  AS_HOST(mimo_scene_create(&room, &scene));
  AS_HOST(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision_width = agent.vision_height = SIDE;
  AS_HOST(mimo_scene_add_agent(scene, &agent, NULL));
  AS_HOST(mimo_task_init(&task, sizeof task));
  task.reset = start;
  task.evaluate = judge;
  AS_HOST(mimo_scene_set_task(scene, &task));
  return scene;
}

static mimo_env_config config_for(const char* renderer) {
  mimo_env_config config;
  AS_HOST(mimo_env_config_init(&config, sizeof config));
  config.renderer = renderer;
  config.log = say;
  return config;
}

static void fill(float* actions, size_t count, size_t step) {
  size_t i;
  for (i = 0; i < count; ++i) actions[i] = (float)((int)((7 * step + 3 * i) % 21) - 10) / 10.0f;
}

/* One world, by itself. */
static uint64_t run_single(const mimo_scene* scene, const char* renderer) {
  const mimo_env_config config = config_for(renderer);
  uint64_t hash = UINT64_C(14695981039346656037);
  mimo_env* env = NULL;
  size_t bytes = 0, count = 0, step;
  uint8_t picture[3 * SIDE * SIDE];
  mimo_picture_config view;
  AS_HOST(mimo_env_create(scene, &config, &env));
  if (env == NULL) exit(failures());
  bytes = sizes_of(env).block_bytes;
  count = sizes_of(env).actions;
  uint8_t* block = malloc(bytes);
  float* actions = malloc(count * sizeof *actions);
  AS_HOST(mimo_env_reset(env, SEED(3), block, bytes));
  hash = hash_of(hash, block, bytes);
  for (step = 0; step < STEPS; ++step) {
    double reward = 0;
    fill(actions, count, step);
    AS_HOST(mimo_env_step(env, actions, count, block, bytes, RESULTS(.reward = &reward, .agent_count = 1)));
    hash = hash_of(hash_of(hash, block, bytes), &reward, sizeof reward);
  }
  AS_HOST(mimo_picture_config_init(&view, sizeof view));
  view.width = view.height = SIDE;
  AS_HOST(mimo_env_render(env, &view, PICTURE(.rgb = picture, .rgb_bytes = sizeof picture)));
  hash = hash_of(hash, picture, sizeof picture);
  AS_HOST(destroy_env(env));
  free(actions);
  free(block);
  return hash;
}

static uint64_t run_batch(const mimo_scene* scene, uint32_t threads, int sent) {
  const mimo_env_config config = config_for("ray");
  const uint64_t seeds[WORLDS] = {3, 4, 5, 6};
  uint64_t hash = UINT64_C(14695981039346656037);
  mimo_batch_config many;
  mimo_batch_results results = {0};
  mimo_batch* batch = NULL;
  mimo_env* first = NULL;
  size_t bytes = 0, count = 0, step;
  double rewards[WORLDS];
  AS_HOST(mimo_batch_config_init(&many, sizeof many));
  many.worlds = WORLDS;
  many.threads = threads;
  AS_HOST(mimo_batch_create(scene, &config, &many, &batch));
  if (batch == NULL) exit(failures());
  AS_HOST(mimo_batch_world(batch, 0, &first));
  bytes = sizes_of(first).block_bytes;
  count = sizes_of(first).actions;
  bytes *= WORLDS;
  count *= WORLDS;
  uint8_t* blocks = malloc(bytes);
  float* actions = malloc(count * sizeof *actions);
  results.struct_size = sizeof results;
  results.reward = rewards;
  results.agent_count = WORLDS;
  AS_HOST(mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = WORLDS), blocks, bytes));
  hash = hash_of(hash, blocks, bytes);
  for (step = 0; step < STEPS; ++step) {
    fill(actions, count, step);
    if (sent) {
      AS_HOST(mimo_batch_send(batch, actions, count, blocks, bytes, &results));
      AS_HOST(mimo_batch_receive(batch));
    } else {
      AS_HOST(mimo_batch_step(batch, actions, count, blocks, bytes, &results));
    }
    hash = hash_of(hash_of(hash, blocks, bytes), rewards, sizeof rewards);
  }
  AS_HOST(destroy_batch(batch));
  free(actions);
  free(blocks);
  return hash;
}

static void expect(uint64_t expected, uint64_t actual, const char* what, const char* way, const char* task_way) {
  if (expected == actual) return;
  ++failed_checks;
  fprintf(stderr, "%s: other bytes in a host that calculates \"%s\", its task \"%s\"\n", what, way, task_way);
}

int main(void) {
  uint64_t alone = 0, together = 0;
#ifndef MIMO_NO_OSMESA
  uint64_t drawn = 0;
#endif
  size_t way;
  for (way = 0; way < WAYS; ++way) {
    const size_t task_way = (way * 3) % WAYS;
    const char *name = all_ways[way].name, *task_name = all_ways[task_way].name;
    uint32_t threads;
    mimo_scene* scene;
    uint64_t hash;
    own = all_ways[way].set;
    of_the_task = all_ways[task_way].set;
    scene = make_scene();
    hash = run_single(scene, "ray");
    if (way == 0) alone = hash;
    expect(alone, hash, "a world", name, task_name);
#ifndef MIMO_NO_OSMESA
    hash = run_single(scene, "osmesa");
    if (way == 0) drawn = hash;
    expect(drawn, hash, "a world drawn by OSMesa", name, task_name);
#endif
    for (threads = 1; threads <= WORLDS; ++threads) {
      hash = run_batch(scene, threads, threads % 2 == 0);
      if (way == 0 && threads == 1) together = hash;
      expect(together, hash, "a batch", name, task_name);
    }
    mimo_scene_destroy(scene);
  }
  return failures();
}
