/* A thread of the host with a small stack: 128 KiB are enough; 256 for documents as deep as MuJoCo reads them. */
#include <pthread.h>

#include "support/capi.h"

enum { kDeepest = 600, kSide = 16 };

/* MuJoCo 2.2's reader ends at about a hundred levels, that of 4 at some hundreds; what is deeper is refused, but we
 * have read it by then. */
static void check_nested(size_t depth, int compiles) {
  static char text[64 * kDeepest + 200];
  mimo_scene_config room;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_status status;
  size_t used = (size_t)sprintf(text, "<mujoco><worldbody>"), level;
  for (level = 0; level < depth; ++level) used += (size_t)sprintf(text + used, "<body><geom size='.1'/>");
  for (level = 0; level < depth; ++level) used += (size_t)sprintf(text + used, "</body>");
  sprintf(text + used, "</worldbody></mujoco>");
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.xml = text;
  status = mimo_scene_create(&room, &scene);
  if (status == MIMO_OK) status = mimo_env_create(scene, NULL, &env);
  CHECK(status == (compiles ? MIMO_OK : MIMO_E_MODEL));
  if (compiles) CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void check_infant(const char* name, const char* renderer) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_env_config config;
  mimo_batch_config many;
  mimo_picture_config picture;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  uint8_t rgb[3 * kSide * kSide];
  size_t bytes = 0;
  uint8_t* block;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  CHECK_OK(mimo_batch_config_init(&many, sizeof many));
  CHECK_OK(mimo_picture_config_init(&picture, sizeof picture));
  room.name = name;
  agent.vision_width = agent.vision_height = kSide;
  config.renderer = renderer;
  many.worlds = many.threads = 2;
  picture.width = picture.height = kSide;
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_create(scene, &config, &env));
  if (env == NULL) exit(failures());
  bytes = sizes_of(env).block_bytes;
  block = malloc(2 * bytes);
  CHECK_OK(mimo_env_reset(env, NULL, block, bytes));
  CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, NULL));
  CHECK_OK(mimo_env_render(env, &picture, PICTURE(.rgb = rgb, .rgb_bytes = sizeof rgb)));
  mimo_env_destroy(env);
  CHECK_OK(mimo_batch_create(scene, &config, &many, &batch));
  CHECK_OK(mimo_batch_step(batch, NULL, 0, block, 2 * bytes, NULL));
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
  free(block);
}

static void* on_a_small_stack(void* unused) {
  check_nested(40, 1);
  if (mimo_mujoco_version()[0] == '2') check_nested(250, 0); /* MuJoCo 4 reads it */
  check_infant("showroom", "ray");
#ifndef MIMO_NO_OSMESA
  check_infant("benchmark", "osmesa");
#endif
  return unused;
}

static void* on_a_larger_stack(void* unused) {
  check_nested(90, 1);
  check_nested(kDeepest, 0);
  return unused;
}

static void run_on(size_t stack, void* (*run)(void*)) {
  pthread_attr_t attributes;
  pthread_t thread;
  CHECK(pthread_attr_init(&attributes) == 0);
  CHECK(pthread_attr_setstacksize(&attributes, stack) == 0);
  CHECK(pthread_create(&thread, &attributes, run, NULL) == 0);
  CHECK(pthread_join(thread, NULL) == 0);
  CHECK(pthread_attr_destroy(&attributes) == 0);
}

int main(void) {
  run_on(128 * 1024, on_a_small_stack);
  run_on(256 * 1024, on_a_larger_stack);
  return failures();
}
