/* Configs with anything in them: each is taken or refused with a status, and what is taken makes a world that steps. */
#include "fuzz/input.h"

#define NAME_BYTES 24

/* Strings that mean something, and else whatever the input holds. */
static const char* take_text(input* in, char* room) {
  static const char* const known_texts[] = {NULL,  "",     "free",   "mitten", "scene",  "anna",      "left_hand",
                                            "ray", "none", "osmesa", "auto",   "custom", "benchmark", "selfbody"};
  const uint8_t which = take_byte(in);
  if (which < sizeof known_texts / sizeof *known_texts) return known_texts[which];
  take(in, room, NAME_BYTES - 1);
  room[NAME_BYTES - 1] = '\0';
  return room;
}

static void add_agent(input* in, mimo_scene* scene) {
  mimo_agent_config config;
  char name[NAME_BYTES], body[NAME_BYTES], part[NAME_BYTES];
  int32_t agent = -7;
  CALL(mimo_scene_default_agent(scene, &config, sizeof config));
  if (take_byte(in) % 2 != 0) take(in, &config, sizeof config);
  config.name = take_text(in, name);
  config.body = take_text(in, body);
  /* Large pictures and dense skins are legal, and slow. */
  if (config.vision_width <= 4096) config.vision_width %= 9;
  if (config.vision_height <= 4096) config.vision_height %= 9;
  if (config.touch_scale > 2 && config.touch_scale <= 1000) config.touch_scale = 2;
  if (CALL(mimo_scene_add_agent(scene, &config, &agent)) != MIMO_OK) {
    PROMISE(agent == -7);
    return;
  }
  PROMISE(agent >= 0);
  if (take_byte(in) % 4 == 0) {
    const double spacing = take_double(in);
    if (!(spacing > 0 && spacing < 0.01)) CALL(mimo_scene_set_touch(scene, agent, take_text(in, part), spacing));
  }
}

static void add_object(input* in, mimo_scene* scene) {
  mimo_object_config config;
  char name[NAME_BYTES];
  CALL(mimo_object_config_init(&config, sizeof config));
  if (take_byte(in) % 2 != 0) take(in, &config, sizeof config);
  config.name = take_text(in, name);
  CALL(mimo_scene_add_object(scene, &config));
}

static void use(mimo_env* env) {
  size_t bytes = 0;
  void* block;
  CALL(mimo_env_observation_size(env, &bytes, NULL));
  block = malloc(bytes > 0 ? bytes : 1);
  if (block == NULL) return;
  if (CALL(mimo_env_reset(env, NULL, block, bytes)) == MIMO_OK) {
    CALL(mimo_env_step(env, NULL, 0, block, bytes, NULL, NULL, NULL, 0));
  }
  free(block);
}

static void make_env(input* in, const mimo_scene* scene) {
  mimo_env_config config;
  mimo_env* env = NULL;
  char renderer[NAME_BYTES], task[NAME_BYTES];
  CALL(mimo_env_config_init(&config, sizeof config));
  if (take_byte(in) % 2 != 0) take(in, &config, sizeof config);
  config.renderer = take_text(in, renderer);
  config.task = take_text(in, task);
  config.log = NULL;
  if (config.frame_skip <= 1000) config.frame_skip %= 4;
  if (CALL(mimo_env_create(scene, &config, &env)) == MIMO_OK) {
    use(env);
  } else {
    PROMISE(env == NULL);
  }
  mimo_env_destroy(env);
}

static void make_batch(input* in, const mimo_scene* scene) {
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  CALL(mimo_batch_config_init(&config, sizeof config));
  take(in, &config, sizeof config);
  if (config.worlds <= 1048576) config.worlds %= 3;
  if (config.threads <= 4096) config.threads %= 3;
  if (CALL(mimo_batch_create(scene, NULL, &config, &batch)) == MIMO_OK) {
    CALL(mimo_batch_reset(batch, NULL, NULL, 0, NULL, 0));
    CALL(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  } else {
    PROMISE(batch == NULL);
  }
  mimo_batch_destroy(batch);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  input in = {data, size};
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  char name[NAME_BYTES];
  const uint8_t plan = take_byte(&in);
  CALL(mimo_scene_config_init(&config, sizeof config));
  if (plan & 1) take(&in, &config, sizeof config);
  config.name = take_text(&in, name);
  config.file = config.xml = config.model_dir = NULL;
  config.log = NULL;
  if (CALL(mimo_scene_create(&config, &scene)) != MIMO_OK) {
    PROMISE(scene == NULL);
    return 0;
  }
  if (plan & 2) add_object(&in, scene);
  if (plan & 4) add_agent(&in, scene);
  if (plan & 8) add_agent(&in, scene);
  if (plan & 16) make_env(&in, scene);
  if (plan & 32) make_batch(&in, scene);
  mimo_scene_destroy(scene);
  return 0;
}
