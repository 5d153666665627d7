/* Worlds of one batch that several threads draw and step at the same time: each thread its own world, between the
 * batch's own calls; and a task that draws a world of another batch. They get what one thread alone gets. */
#include <pthread.h>

#include "support/capi.h"

enum { WORLDS = 4, ROUNDS = 6, SIDE = 24, PIXELS = SIDE * SIDE * 3 };

typedef struct painter {
  mimo_env* world;
  uint64_t seed;
  uint8_t pictures[ROUNDS][PIXELS];
  int wrong;
} painter;

static void draw(painter* it, int round) {
  mimo_picture_config config;
  it->wrong += mimo_picture_config_init(&config, sizeof config) != MIMO_OK;
  config.width = config.height = SIDE;
  config.azimuth = 60.0 * round;
  it->wrong += mimo_env_render(it->world, &config, PICTURE(.rgb = it->pictures[round], .rgb_bytes = PIXELS)) != MIMO_OK;
}

/* Steps sense, too, which draws the eyes' pictures. */
static void* paint(void* argument) {
  painter* it = argument;
  size_t bytes = 0, i;
  uint8_t* block;
  int round;
  bytes = sizes_of(it->world).block_bytes;
  block = malloc(bytes);
  if (block == NULL) exit(1);
  it->wrong += mimo_env_reset(it->world, SEED(it->seed), block, bytes) != MIMO_OK;
  for (round = 0; round < ROUNDS; ++round) {
    for (i = 0; i < 2; ++i) {
      it->wrong += mimo_env_step(it->world, NULL, 0, block, bytes, NULL) != MIMO_OK;
    }
    draw(it, round);
  }
  free(block);
  return NULL;
}

static mimo_scene* seeing_scene(void) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "reach";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision_width = agent.vision_height = SIDE;
  agent.touch = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  return scene;
}

static mimo_batch* batch_of(const mimo_scene* scene) {
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  if (batch == NULL) exit(failures());
  return batch;
}

static void check_threads(const mimo_scene* scene) {
  static painter alone[WORLDS], together[WORLDS];
  pthread_t threads[WORLDS];
  mimo_batch* batch = batch_of(scene);
  size_t i;
  for (i = 0; i < WORLDS; ++i) {
    CHECK_OK(mimo_batch_world(batch, i, &together[i].world));
    together[i].seed = i;
    alone[i] = together[i];
    paint(&alone[i]);
  }
  for (i = 0; i < WORLDS; ++i) CHECK(pthread_create(&threads[i], NULL, paint, &together[i]) == 0);
  for (i = 0; i < WORLDS; ++i) pthread_join(threads[i], NULL);
  for (i = 0; i < WORLDS; ++i) {
    CHECK(alone[i].wrong == 0 && together[i].wrong == 0);
    CHECK(memcmp(alone[i].pictures, together[i].pictures, sizeof alone[i].pictures) == 0);
    CHECK(i == 0 || memcmp(alone[i].pictures[0], alone[0].pictures[0], PIXELS) != 0);
  }
  mimo_batch_destroy(batch);
}

/* Each world's task draws the other batch's world of the same number, which no other thread touches. */
static mimo_status draw_another(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  painter* painters = user;
  (void)env;
  draw(&painters[moment->world], 0);
  verdict->reward = 1;
  return MIMO_OK;
}

static void check_task(mimo_scene* scene) {
  static painter painters[WORLDS];
  static uint8_t expected[WORLDS][PIXELS];
  mimo_batch *drawn = batch_of(scene), *drawing;
  mimo_task task;
  size_t i;
  int round;
  CHECK_OK(mimo_batch_reset(drawn, NULL, NULL, 0));
  for (i = 0; i < WORLDS; ++i) {
    CHECK_OK(mimo_batch_world(drawn, i, &painters[i].world));
    draw(&painters[i], 0);
    memcpy(expected[i], painters[i].pictures[0], PIXELS);
  }
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = draw_another;
  task.user = painters;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  drawing = batch_of(scene);
  for (round = 0; round < ROUNDS; ++round) {
    for (i = 0; i < WORLDS; ++i) memset(painters[i].pictures[0], 0, PIXELS);
    CHECK_OK(mimo_batch_step(drawing, NULL, 0, NULL, 0, NULL));
    for (i = 0; i < WORLDS; ++i) CHECK(memcmp(expected[i], painters[i].pictures[0], PIXELS) == 0);
  }
  for (i = 0; i < WORLDS; ++i) CHECK(painters[i].wrong == 0);
  mimo_batch_destroy(drawing);
  mimo_batch_destroy(drawn);
}

int main(void) {
  mimo_scene* scene = seeing_scene();
  check_threads(scene);
  check_task(scene);
  mimo_scene_destroy(scene);
  return failures();
}
