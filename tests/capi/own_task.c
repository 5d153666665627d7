/* Tasks written as C functions: what they are given and may do, in single worlds and, with the same results, in
 * batches. */
#include "support/capi.h"

enum { WORLDS = 6, STEPS = 25 };

/* Of each world and agent. */
typedef struct memory {
  double target;
  uint64_t steps;
} memory;

typedef struct rules {
  int32_t joint;
  mimo_status reset_status, evaluate_status;
} rules;

static mimo_status start(void* user, mimo_env* env, const mimo_task_moment* moment) {
  const rules* rule = user;
  memory* it = moment->memory;
  double share;
  size_t count = 0;
  if (it->target != 0 || it->steps != 0 || moment->agent != 0) return MIMO_E_INTERNAL;
  if (mimo_env_reset(env, NULL, NULL, 0) != MIMO_E_BUSY) return MIMO_E_INTERNAL;
  if (mimo_env_step(env, NULL, 0, NULL, 0, NULL) != MIMO_E_BUSY) return MIMO_E_INTERNAL;
  mimo_env_destroy(env); /* does nothing now */
  if (mimo_env_count(env, MIMO_AGENT, &count) != MIMO_OK || count != 1) return MIMO_E_INTERNAL;
  if (mimo_env_random(env, &share, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  it->target = -share;
  if (mimo_env_set(env, MIMO_JOINT_POSITION, &rule->joint, 1, &it->target, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  return rule->reset_status;
}

static mimo_status judge(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  const rules* rule = user;
  memory* it = moment->memory;
  double angle;
  if (verdict->reward != 0 || verdict->outcome != MIMO_OUTCOME_NONE) return MIMO_E_INTERNAL;
  if (mimo_env_get(env, MIMO_JOINT_POSITION, &rule->joint, 1, &angle, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  verdict->reward = -fabs(angle - it->target);
  if (++it->steps == 10) verdict->outcome = it->target < -0.5 ? MIMO_OUTCOME_SUCCESS : MIMO_OUTCOME_FAILURE;
  return rule->evaluate_status;
}

/* Draws a new place for the elbow in every step, as a task does that goes on after a success. */
static mimo_status draw_on(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  const int32_t elbow = ((const rules*)user)->joint;
  double angle, share;
  (void)moment;
  if (mimo_env_get(env, MIMO_JOINT_POSITION, &elbow, 1, &angle, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  verdict->reward = angle;
  if (mimo_env_random(env, &share, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  angle = -share;
  return mimo_env_set(env, MIMO_JOINT_POSITION, &elbow, 1, &angle, 1);
}

/* What evaluate writes counts from the next step on: the step's observation and reward are as they were. */
static void check_writing_judges(void) {
  rules rule = {0, MIMO_OK, MIMO_OK};
  mimo_scene* scene = blind_scene("free");
  mimo_env *env = NULL, *twin = NULL;
  mimo_task task;
  double reward[2] = {1, 2}, drawn, angle[2];
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = draw_on;
  task.user = &rule;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  rule.joint = find(env, MIMO_JOINT, "robot:left_elbow");
  CHECK_OK(mimo_env_create(scene, NULL, &twin));
  CHECK_OK(mimo_env_reset(env, SEED(3), NULL, 0));
  CHECK_OK(mimo_env_reset(twin, SEED(3), NULL, 0));
  CHECK_OK(mimo_env_random(twin, &drawn, 1));
  CHECK_OK(mimo_env_reset(twin, SEED(3), NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, RESULTS(.reward = &reward[0], .agent_count = 1)));
  CHECK_OK(mimo_env_step(twin, NULL, 0, NULL, 0, RESULTS(.reward = &reward[1], .agent_count = 1)));
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, &rule.joint, 1, &angle[0], 1));
  CHECK_OK(mimo_env_get(twin, MIMO_JOINT_POSITION, &rule.joint, 1, &angle[1], 1));
  CHECK(reward[0] == reward[1] && angle[0] == -drawn && angle[1] == -drawn && reward[0] != angle[0]);
  mimo_env_destroy(env);
  mimo_env_destroy(twin);
  mimo_scene_destroy(scene);
}

static mimo_scene* scene_with(rules* rule) {
  mimo_scene* scene = blind_scene("free");
  mimo_task task;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "evaluate is NULL", mimo_scene_set_task(scene, &task));
  task.reset = start;
  task.evaluate = judge;
  task.user = rule;
  task.memory_bytes = 1048577;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "memory_bytes is", mimo_scene_set_task(scene, &task));
  task.memory_bytes = sizeof(memory);
  CHECK_OK(mimo_scene_set_task(scene, &task));
  return scene;
}

static void check_batch_equals_singles(mimo_scene* scene) {
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  mimo_batch_config config;
  mimo_batch_results results;
  double reward[WORLDS], expected[WORLDS][STEPS];
  uint8_t ends[WORLDS], end;
  uint64_t seeds[WORLDS], world;
  int step, outcomes = 0;

  CHECK_OK(mimo_env_create(scene, NULL, &env));
  for (world = 0; world < WORLDS; ++world) {
    seeds[world] = 40 + world;
    CHECK_OK(mimo_env_reset(env, SEED(seeds[world]), NULL, 0));
    for (step = 0; step < STEPS; ++step) {
      int32_t outcome = 7;
      CHECK_OK(mimo_env_step(
          env, NULL, 0, NULL, 0,
          RESULTS(.reward = &expected[world][step], .terminated = &end, .outcome = &outcome, .agent_count = 1)));
      CHECK(end == (step == 9));
      CHECK((outcome != MIMO_OUTCOME_NONE) == end);
      if (end) outcomes |= outcome == MIMO_OUTCOME_SUCCESS ? 1 : 2;
    }
  }
  CHECK(outcomes == 3); /* both were seen */
  mimo_env_destroy(env);

  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 3;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  CHECK_OK(mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = WORLDS), NULL, 0));
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = reward;
  results.terminated = ends;
  results.agent_count = WORLDS;
  for (step = 0; step < STEPS; ++step) {
    CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
    for (world = 0; world < WORLDS; ++world) {
      CHECK(reward[world] == expected[world][step]);
      CHECK(ends[world] == (step == 9));
    }
  }
  mimo_batch_destroy(batch);
}

static void check_state(mimo_scene* scene) {
  mimo_env *env = NULL, *twin = NULL;
  double first = 0, second = 0;
  int step;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_clone(env, &twin));
  for (step = 0; step < 12; ++step) {
    uint8_t end[2];
    CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, RESULTS(.reward = &first, .terminated = &end[0], .agent_count = 1)));
    CHECK_OK(
        mimo_env_step(twin, NULL, 0, NULL, 0, RESULTS(.reward = &second, .terminated = &end[1], .agent_count = 1)));
    CHECK(first == second && end[0] == end[1] && end[0] == (step == 8));
  }
  mimo_env_destroy(twin);
  mimo_env_destroy(env);
}

static void check_failing(mimo_scene* scene, rules* rule) {
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  rule->reset_status = MIMO_E_NOT_FOUND;
  CHECK_FAILS(MIMO_E_TASK, "the task's function reset returned -5 (MIMO_E_NOT_FOUND)",
              mimo_env_reset(env, NULL, NULL, 0));
  rule->reset_status = MIMO_OK;
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  rule->evaluate_status = 5;
  CHECK_FAILS(MIMO_E_TASK, "evaluate returned 5", mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_create(scene, NULL, NULL, &batch));
  CHECK_FAILS(MIMO_E_TASK, "world 0: the task's function", mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  rule->evaluate_status = MIMO_OK;
  mimo_batch_destroy(batch);
  mimo_env_destroy(env);
}

/* Whatever a task returns: the step has happened, so no status comes through that says otherwise. */
static void check_statuses(mimo_scene* scene, rules* rule) {
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  mimo_batch_config config;
  mimo_batch_results results;
  mimo_status status, each = MIMO_OK;
  uint8_t truncated = 7, was_reset = 7;
  double before, after;
  char said[64];
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 1;
  config.restart_failed = 1;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.worlds = results.agent_count = 1;
  results.status = &each;
  results.truncated = &truncated;
  results.was_reset = &was_reset;
  for (status = MIMO_E_BUSY - 1; status <= 1; ++status) { /* from an unknown one to one that will never be */
    if (status == MIMO_OK) continue;
    CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
    CHECK_OK(mimo_batch_reset(batch, NULL, NULL, 0));
    CHECK_OK(mimo_env_time(env, &before));
    rule->evaluate_status = status;
    snprintf(said, sizeof said, "the task's function evaluate returned %d (%s)", status, mimo_status_name(status));
    CHECK_FAILS(MIMO_E_TASK, said, mimo_env_step(env, NULL, 0, NULL, 0, NULL));
    CHECK_OK(mimo_env_time(env, &after));
    CHECK(after > before);
    CHECK_FAILS(MIMO_E_TASK, said, mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
    CHECK(each == MIMO_E_TASK && truncated == 0 && was_reset == 0);
    rule->evaluate_status = MIMO_OK;
    CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL)); /* the world has not failed */
    rule->reset_status = status;
    snprintf(said, sizeof said, "the task's function reset returned %d (%s)", status, mimo_status_name(status));
    CHECK_FAILS(MIMO_E_TASK, said, mimo_env_reset(env, NULL, NULL, 0));
    CHECK_FAILS(MIMO_E_TASK, said, mimo_batch_reset(batch, NULL, NULL, 0));
    rule->reset_status = MIMO_OK;
  }
  mimo_batch_destroy(batch);
  mimo_env_destroy(env);
}

static void check_name(mimo_scene* scene) {
  mimo_env* env = NULL;
  mimo_env_config config;
  const char* name = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_task(env, &name));
  CHECK_TEXT("custom", name);
  mimo_env_destroy(env);
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.task = "none";
  CHECK_OK(mimo_env_create(scene, &config, &env));
  CHECK_OK(mimo_env_task(env, &name));
  CHECK_TEXT("none", name);
  mimo_env_destroy(env);
  CHECK_OK(mimo_scene_set_task(scene, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_task(env, &name));
  CHECK_TEXT("none", name);
  mimo_env_destroy(env);
}

int main(void) {
  rules rule = {0, MIMO_OK, MIMO_OK};
  mimo_env* env = blind_env("free", NULL);
  mimo_scene* scene;
  rule.joint = find(env, MIMO_JOINT, "robot:left_elbow");
  mimo_env_destroy(env);
  scene = scene_with(&rule);
  check_batch_equals_singles(scene);
  check_state(scene);
  check_failing(scene, &rule);
  check_statuses(scene, &rule);
  check_name(scene);
  mimo_scene_destroy(scene);
  check_writing_judges();
  return failures();
}
