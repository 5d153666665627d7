/*
 * Steps many worlds of a task for a long time, and watches: does memory grow, does a world fail without saying so, do
 * episodes go on ending? Prints a line now and then; the exit status is 1 when something was wrong.
 *
 *   cmake --build build --target soak && build/bin/soak reach 10000000
 */
#define _POSIX_C_SOURCE 200809L
#include <mimo/mimo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { kWorlds = 64, kReports = 20 };

typedef struct counts {
  unsigned long long steps, episodes, successes, failed_worlds;
} counts;

static void check(mimo_status status, const char* what) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "soak: %s: %s\n", what, mimo_last_error());
  exit(1);
}

static long resident_kb(void) {
  long pages = 0, resident = 0;
  FILE* file = fopen("/proc/self/statm", "r");
  if (file == NULL) return 0;
  if (fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
  fclose(file);
  return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

static float random_action(unsigned* state) {
  *state = *state * 1664525u + 1013904223u;
  return (float)(*state >> 8) / 8388608.0f - 1.0f;
}

static mimo_batch* make_batch(const char* name, unsigned threads) {
  mimo_scene_config scene_config;
  mimo_batch_config batch_config;
  mimo_scene* scene = NULL;
  mimo_batch* batch = NULL;
  check(mimo_scene_config_init(&scene_config, sizeof scene_config), "config");
  scene_config.name = name;
  check(mimo_scene_create(&scene_config, &scene), "scene");
  check(mimo_scene_add_agent(scene, NULL, NULL), "agent");
  check(mimo_batch_config_init(&batch_config, sizeof batch_config), "config");
  batch_config.worlds = kWorlds;
  batch_config.threads = threads;
  batch_config.autoreset = MIMO_AUTORESET_SAME_STEP;
  batch_config.restart_failed = 1;
  check(mimo_batch_create(scene, NULL, &batch_config, &batch), "batch");
  mimo_scene_destroy(scene);
  return batch;
}

static void count(counts* all, const double* reward, const uint8_t* ended, const mimo_status* status) {
  for (int world = 0; world < kWorlds; ++world) {
    all->episodes += ended[world];
    all->successes += ended[world] != 0 && reward[world] > 0;
    all->failed_worlds += status[world] != MIMO_OK;
  }
  all->steps += kWorlds;
}

int main(int argc, char** argv) {
  if (argc < 3) {
    fprintf(stderr, "usage: soak SCENE STEPS [THREADS]\n");
    return 2;
  }
  const unsigned long long steps = strtoull(argv[2], NULL, 10);
  mimo_batch* batch = make_batch(argv[1], argc > 3 ? (unsigned)atoi(argv[3]) : 0);
  const mimo_layout* layout = NULL;
  mimo_layout_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  check(mimo_batch_layout(batch, &layout), "layout");
  check(mimo_layout_describe(layout, &info), "sizes");
  const size_t bytes = info.block_bytes, width = info.actions;
  void* blocks = malloc(kWorlds * bytes);
  float* actions = malloc(kWorlds * width * sizeof *actions);
  if (blocks == NULL || actions == NULL) return 1;

  double reward[kWorlds];
  uint8_t terminated[kWorlds], truncated[kWorlds], was_reset[kWorlds];
  mimo_status status[kWorlds];
  mimo_batch_results results;
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = reward;
  results.terminated = terminated;
  results.truncated = truncated;
  results.agent_count = kWorlds;
  results.status = status;
  results.was_reset = was_reset;
  results.worlds = kWorlds;

  counts all = {0, 0, 0, 0};
  unsigned random = 1;
  long settled_kb = 0;
  check(mimo_batch_reset(batch, NULL, blocks, kWorlds * bytes), "reset");
  for (unsigned long long report = 1; report <= kReports; ++report) {
    while (all.steps < steps * report / kReports) {
      for (size_t i = 0; i < kWorlds * width; ++i) actions[i] = random_action(&random);
      check(mimo_batch_step(batch, actions, kWorlds * width, blocks, kWorlds * bytes, &results), "step");
      count(&all, reward, was_reset, status);
    }
    if (report == 1) settled_kb = resident_kb();
    printf("%llu steps: %llu episodes, %llu successes, %llu failed worlds, %ld kB resident\n", all.steps, all.episodes,
           all.successes, all.failed_worlds, resident_kb());
    fflush(stdout);
  }
  const long growth_kb = resident_kb() - settled_kb;
  printf("grown by %ld kB since the first twentieth\n", growth_kb);
  mimo_batch_destroy(batch);
  free(blocks);
  free(actions);
  return growth_kb > 256 || all.episodes == 0;
}
