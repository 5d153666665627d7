/* MJCF text of any kind, as a scene and as an object: refused with a message, or a world that can be stepped, watched
 * and felt. */
#include "fuzz/input.h"

static void use(const mimo_scene* scene) {
  mimo_env* env = NULL;
  int32_t bodies[1] = {0};
  double mass = 0;
  size_t bytes = 0;
  void* block;
  int i;
  if (CALL(mimo_env_create(scene, NULL, &env)) != MIMO_OK) {
    PROMISE(env == NULL);
    return;
  }
  CALL(mimo_env_get(env, MIMO_BODY_MASS, bodies, 1, &mass, 1));
  bytes = sizes_of(env).block_bytes;
  block = bytes < 100000000 ? malloc(bytes + 1) : NULL;
  for (i = 0; i < 3; ++i) CALL(mimo_env_step(env, NULL, 0, block, block ? bytes : 0, NULL));
  CALL(mimo_env_reset(env, NULL, block, block ? bytes : 0));
  free(block);
  mimo_env_destroy(env);
}

/* An infant whose body is part of the text, as far as it is there. */
static void add_agent(mimo_scene* scene) {
  mimo_agent_config config;
  if (CALL(mimo_scene_default_agent(scene, &config, sizeof config)) != MIMO_OK) return;
  config.body = "scene";
  config.vision = 0;
  CALL(mimo_scene_add_agent(scene, &config, NULL));
}

/* Small limits, so that what they let through is quick; and no file of this machine is anybody's business. */
static void limit(mimo_scene_config* config) {
  CALL(mimo_scene_config_init(config, sizeof *config));
  config->max_file_bytes = 1 << 20;
  config->max_pixels = 1 << 16;
  config->max_vertices = 10000;
  config->max_elements = 1000;
  config->max_keyframes = 100;
  config->max_iterations = 200;
  config->max_world_bytes = 1 << 28;
  config->max_compile_ms = 1000;
  config->confined = 1;
}

/* The text as an object of a scene that has an infant. */
static void add_model(const char* text) {
  mimo_scene_config config;
  mimo_model_config model;
  mimo_scene* scene = NULL;
  limit(&config);
  config.xml = "<mujoco><compiler angle='radian'/><default><geom size='.1'/></default></mujoco>";
  CALL(mimo_scene_create(&config, &scene));
  CALL(mimo_model_config_init(&model, sizeof model));
  model.name = "guest";
  model.xml = text;
  if (CALL(mimo_scene_add_model(scene, &model)) == MIMO_OK) use(scene);
  mimo_scene_destroy(scene);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  char* text = malloc(size + 1);
  if (text == NULL) return 0;
  memcpy(text, data, size);
  text[size] = '\0';
  limit(&config);
  config.xml = text;
  if (CALL(mimo_scene_create(&config, &scene)) == MIMO_OK) {
    use(scene);
    add_agent(scene);
    use(scene);
  }
  add_model(text);
  mimo_scene_destroy(scene);
  free(text);
  return 0;
}
