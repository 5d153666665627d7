/* A task of one's own for many worlds at once: the infant is to bring its left hand down to a height that each episode
 * draws anew. The two functions below are the task; the library calls them while it steps, on all of its threads. The
 * height is a field of the observation, so that a learner sees what is wanted; the reward has two terms with names.
 *
 *   cc task_callback.c $(pkg-config --cflags --libs mimo) && ./a.out
 */
#include <mimo/mimo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORLDS = 16, STEPS = 200 };

/* Shared by all worlds; only read while they run. */
typedef struct lower {
  int32_t hand;
} lower;

enum { DESIRED, ACHIEVED, FIELDS }; /* one number each, m */
enum { HEIGHT, EFFORT, TERMS };

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

static mimo_status lower_reset(void* user, mimo_env* env, const mimo_task_moment* moment) {
  double share;
  mimo_status status =
      mimo_env_random(env, &share, 1); /* from the world's own stream: seeds it, and it is repeatable */
  (void)user;
  moment->fields[DESIRED] = (float)(0.02 + 0.2 * share);
  return status;
}

static mimo_status lower_evaluate(void* user, mimo_env* env, const mimo_task_moment* moment,
                                  mimo_task_verdict* verdict) {
  const lower* task = user;
  double hand[3];
  size_t i;
  mimo_status status = mimo_env_get(env, MIMO_BODY_POSITION, &task->hand, 1, hand, 3);
  if (status != MIMO_OK) return status;
  moment->fields[ACHIEVED] = (float)hand[2];
  verdict->terms[HEIGHT] = moment->fields[DESIRED] - hand[2];
  for (i = 0; i < moment->action_count; ++i) verdict->terms[EFFORT] -= 0.001 * moment->action[i] * moment->action[i];
  if (verdict->terms[HEIGHT] > 0) verdict->outcome = MIMO_OUTCOME_SUCCESS;
  verdict->truncated = moment->step == 100;
  return MIMO_OK;
}

static void give_task(mimo_scene* scene, lower* user) {
  const char* const terms[TERMS] = {"height", "effort"};
  mimo_task_field fields[FIELDS];
  mimo_task task;
  int i;
  for (i = 0; i < FIELDS; ++i) {
    check(mimo_task_field_init(&fields[i], sizeof fields[i]));
    fields[i].name = i == DESIRED ? "desired_goal" : "achieved_goal";
    fields[i].unit = "m";
    fields[i].frame = "world";
  }
  check(mimo_task_init(&task, sizeof task));
  task.user = user;
  task.reset = lower_reset;
  task.evaluate = lower_evaluate;
  task.terms = terms;
  task.term_count = TERMS;
  task.fields = fields;
  task.field_count = FIELDS;
  check(mimo_scene_set_task(scene, &task)); /* it copies terms and fields */
}

static mimo_batch* make_batch(lower* user) {
  mimo_scene_config scene_config;
  mimo_agent_config agent;
  mimo_batch_config batch_config;
  mimo_scene* scene;
  mimo_batch* batch;

  check(mimo_scene_config_init(&scene_config, sizeof scene_config));
  scene_config.name = "benchmark";
  check(mimo_scene_create(&scene_config, &scene));
  check(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  agent.touch = 0;
  check(mimo_scene_add_agent(scene, &agent, NULL));

  give_task(scene, user);

  check(mimo_batch_config_init(&batch_config, sizeof batch_config));
  batch_config.worlds = WORLDS;
  batch_config.autoreset = MIMO_AUTORESET_SAME_STEP;
  check(mimo_batch_create(scene, NULL, &batch_config, &batch));
  mimo_scene_destroy(scene);
  return batch;
}

int main(void) {
  lower user;
  mimo_batch* batch = make_batch(&user);
  mimo_batch_results results;
  mimo_env* first;
  uint64_t seeds[WORLDS];
  mimo_batch_reset_config start;
  uint8_t terminated[WORLDS], truncated[WORLDS];
  const mimo_layout* layout;
  mimo_layout_info sizes;
  float* actions;
  size_t count, i;
  int step, successes = 0, time_outs = 0;

  check(mimo_batch_world(batch, 0, &first));
  check(mimo_env_find(first, MIMO_BODY, "left_hand", &user.hand));
  sizes.struct_size = sizeof sizes;
  check(mimo_batch_layout(batch, &layout));
  check(mimo_layout_describe(layout, &sizes));
  count = sizes.actions;
  actions = malloc(WORLDS * count * sizeof *actions);
  if (actions == NULL) return 1;
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.terminated = terminated;
  results.truncated = truncated;
  results.agent_count = WORLDS;

  for (i = 0; i < WORLDS; ++i) seeds[i] = i;
  memset(&start, 0, sizeof start);
  start.struct_size = sizeof start;
  start.seeds = seeds;
  start.worlds = WORLDS;
  check(mimo_batch_reset(batch, &start, NULL, 0));
  for (step = 0; step < STEPS; ++step) {
    for (i = 0; i < WORLDS * count; ++i) actions[i] = (float)rand() / (float)RAND_MAX * 2 - 1;
    check(mimo_batch_step(batch, actions, WORLDS * count, NULL, 0, &results));
    for (i = 0; i < WORLDS; ++i) {
      successes += terminated[i];
      time_outs += truncated[i] && !terminated[i];
    }
  }
  printf("%d times low enough, %d times not in time\n", successes, time_outs);

  free(actions);
  mimo_batch_destroy(batch);
  return successes + time_outs > 0 ? 0 : 1;
}
