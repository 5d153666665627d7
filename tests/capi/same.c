/*
 * One scenario a scene: seed 7, a hundred steps of fixed actions; and one with a task of its own. Prints a hash over
 * all blocks and the sum of rewards, which ./dev test compares between builds and languages. Here a second world has to
 * give the same; what the numbers themselves should be is the business of tests/golden.
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

/*
 * The task of its own, "own": raise the left hand above a height that each episode draws anew, and spare your actions.
 * It declares two terms and two fields, remembers the height, and an episode goes on where the hand is up.
 */
static mimo_status draw_height(void* user, mimo_env* env, const mimo_task_moment* moment) {
  double share, *height = moment->memory;
  const mimo_status status = mimo_env_random(env, &share, 1);
  (void)user;
  *height = 0.2 + 0.2 * share;
  moment->fields[0] = (float)*height;
  return status;
}

static mimo_status judge_height(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  const int32_t* hand = user;
  const double* height = moment->memory;
  double place[3], effort = 0;
  size_t i;
  const mimo_status status = mimo_env_get(env, MIMO_BODY_POSITION, hand, 1, place, 3);
  for (i = 0; i < moment->action_count; ++i) effort += (double)moment->action[i] * moment->action[i];
  verdict->terms[0] = place[2] - *height;
  verdict->terms[1] = -0.01 * effort;
  moment->fields[1] = (float)place[2];
  verdict->outcome = place[2] > *height ? MIMO_OUTCOME_SUCCESS : MIMO_OUTCOME_NONE;
  verdict->goes_on = 1;
  return status;
}

static mimo_env* make_own(int32_t* hand) {
  static const char* const terms[2] = {"height", "effort"};
  mimo_scene_config room;
  mimo_agent_config infant;
  mimo_task task;
  mimo_task_field fields[2];
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  size_t i;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "benchmark";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.vision = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  for (i = 0; i < 2; ++i) {
    CHECK_OK(mimo_task_field_init(&fields[i], sizeof fields[i]));
    fields[i].name = i == 0 ? "desired_goal" : "achieved_goal";
    fields[i].unit = "m";
    fields[i].frame = "world";
  }
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.user = hand;
  task.memory_bytes = sizeof(double);
  task.reset = draw_height;
  task.evaluate = judge_height;
  task.terms = terms;
  task.fields = fields;
  task.term_count = task.field_count = 2;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  *hand = find(env, MIMO_BODY, "left_hand");
  mimo_scene_destroy(scene);
  return env;
}

static mimo_env* make(const char* scene) {
  static int32_t hand;
  mimo_env* env = NULL;
  if (strcmp(scene, "own") == 0) return make_own(&hand);
  CHECK_OK(mimo_env_make(scene, &env));
  return env;
}

static outcome play(const char* scene, int fill) {
  mimo_env* env = make(scene);
  size_t bytes = 0, count = 0, step, i;
  outcome all = {UINT64_C(14695981039346656037), 0};
  bytes = sizes_of(env).block_bytes;
  count = sizes_of(env).actions;
  uint8_t* block = malloc(bytes);
  float* actions = malloc(count * sizeof *actions);
  memset(block, fill, bytes);
  CHECK_OK(mimo_env_reset(env, SEED(7), block, bytes));
  all.hash = hash_of(all.hash, block, bytes);
  for (step = 0; step < kSteps; ++step) {
    double reward = 0;
    uint8_t terminated = 0, truncated = 0;
    for (i = 0; i < count; ++i) actions[i] = action_of(step, i);
    memset(block, fill, bytes);
    CHECK_OK(mimo_env_step(
        env, actions, count, block, bytes,
        RESULTS(.reward = &reward, .terminated = &terminated, .truncated = &truncated, .agent_count = 1)));
    all.hash = hash_of(all.hash, block, bytes);
    all.rewards += reward;
  }
  free(actions);
  free(block);
  mimo_env_destroy(env);
  return all;
}

int main(void) {
  const char* const scenes[] = {"reach", "standup", "selfbody", "benchmark", "own"};
  size_t i;
  for (i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
    const outcome first = play(scenes[i], 0x00), second = play(scenes[i], 0xff);
    printf("%s %016llx %.6f\n", scenes[i], (unsigned long long)first.hash, first.rewards);
    CHECK(second.hash == first.hash && second.rewards == first.rewards);
  }
  return failures();
}
