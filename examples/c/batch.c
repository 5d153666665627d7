/* 64 infants at once: each one acts at random, on all cores of the machine, and starts anew when its time is up.
 *
 *   cc batch.c $(pkg-config --cflags --libs mimo) && ./a.out
 */
#include <mimo/mimo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORLDS = 64, STEPS = 60 };

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

static mimo_batch* make_batch(void) {
  mimo_scene_config scene_config;
  mimo_agent_config agent;
  mimo_env_config env_config;
  mimo_batch_config batch_config;
  mimo_scene* scene;
  mimo_batch* batch;

  check(mimo_scene_config_init(&scene_config, sizeof scene_config));
  scene_config.name = "reach";
  check(mimo_scene_create(&scene_config, &scene));
  check(mimo_scene_default_agent(scene, &agent, sizeof agent)); /* what the scene's task needs; no eyes */
  check(mimo_scene_add_agent(scene, &agent, NULL));

  check(mimo_env_config_init(&env_config, sizeof env_config));
  env_config.max_steps = 25;
  check(mimo_batch_config_init(&batch_config, sizeof batch_config));
  batch_config.worlds = WORLDS;
  batch_config.autoreset = MIMO_AUTORESET_SAME_STEP;
  batch_config.restart_failed = 1;
  check(mimo_batch_create(scene, &env_config, &batch_config, &batch));
  mimo_scene_destroy(scene);
  return batch;
}

int main(void) {
  mimo_batch* batch = make_batch();
  const mimo_layout* layout;
  mimo_layout_info sizes;
  mimo_batch_results results;
  uint64_t seeds[WORLDS];
  mimo_batch_reset_config start;
  double reward[WORLDS], sum = 0;
  uint8_t terminated[WORLDS], truncated[WORLDS], *blocks;
  float* actions;
  size_t block_bytes, action_count, threads, i;
  int step, episodes = 0;

  check(mimo_batch_layout(batch, &layout)); /* what each of the worlds observes and does */
  sizes.struct_size = sizeof sizes;
  check(mimo_layout_describe(layout, &sizes));
  block_bytes = sizes.block_bytes;
  action_count = sizes.actions;
  check(mimo_batch_size(batch, NULL, &threads));
  blocks = malloc(WORLDS * block_bytes);
  actions = malloc(WORLDS * action_count * sizeof *actions);
  if (blocks == NULL || actions == NULL) return 1;

  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = reward;
  results.terminated = terminated;
  results.truncated = truncated;
  results.agent_count = WORLDS;

  for (i = 0; i < WORLDS; ++i) seeds[i] = i;
  memset(&start, 0, sizeof start);
  start.struct_size = sizeof start;
  start.seeds = seeds;
  start.worlds = WORLDS;
  check(mimo_batch_reset(batch, &start, blocks, WORLDS * block_bytes));
  for (step = 0; step < STEPS; ++step) {
    for (i = 0; i < WORLDS * action_count; ++i) actions[i] = (float)rand() / (float)RAND_MAX * 2 - 1;
    check(mimo_batch_step(batch, actions, WORLDS * action_count, blocks, WORLDS * block_bytes, &results));
    for (i = 0; i < WORLDS; ++i) {
      sum += reward[i];
      episodes += terminated[i] || truncated[i];
    }
  }
  printf("%d worlds, %u threads: %d steps, %d episodes ended, mean reward %.3f\n", WORLDS, (unsigned)threads,
         WORLDS * STEPS, episodes, sum / (WORLDS * STEPS));

  free(actions);
  free(blocks);
  mimo_batch_destroy(batch);
  return episodes >= 2 * WORLDS ? 0 : 1;
}
