/* Configs with anything in them: each is taken or refused with a status, and what is taken makes a world that steps. */
#include "fuzz/input.h"

#define NAME_BYTES 24

/* Strings that mean something, and else whatever the input holds. */
static const char* take_text(input* in, char* room) {
  static const char* const known_texts[] = {NULL,   "",          "free",   "mitten",    "scene",
                                            "anna", "left_hand", "ray",    "none",      "osmesa",
                                            "gl",   "auto",      "custom", "benchmark", "selfbody"};
  const uint8_t which = take_byte(in);
  if (which < sizeof known_texts / sizeof *known_texts) return known_texts[which];
  take(in, room, NAME_BYTES - 1);
  room[NAME_BYTES - 1] = '\0';
  return room;
}

static void add_agent(input* in, mimo_scene* scene) {
  char name[NAME_BYTES], body[NAME_BYTES], part[NAME_BYTES], face[NAME_BYTES], root[NAME_BYTES], organ[NAME_BYTES];
  size_t agent = 7; /* stays as it is where none was added */
  ROOMY(mimo_agent_config, given);
  CALL(mimo_scene_default_agent(scene, &given.config, sizeof given.config));
  if (take_byte(in) % 2 != 0) take(in, &given.config, sizeof given.config);
  given.config.name = take_text(in, name);
  given.config.body = take_text(in, body);
  given.config.face = take_text(in, face);
  given.config.root = take_text(in, root);
  given.config.vestibular_at = take_text(in, organ);
  /* Large pictures and dense skins are legal, and slow. */
  if (given.config.vision_width <= 4096) given.config.vision_width %= 9;
  if (given.config.vision_height <= 4096) given.config.vision_height %= 9;
  if (given.config.touch_scale > 2 && given.config.touch_scale <= 1000) given.config.touch_scale = 2;
  if (CALL(mimo_scene_add_agent(scene, &given.config, &agent)) != MIMO_OK) {
    PROMISE(agent == 7);
    return;
  }
  PROMISE(agent < 2);
  if (take_byte(in) % 4 == 0) {
    const double spacing = take_double(in);
    if (!(spacing > 0 && spacing < 0.01)) CALL(mimo_scene_set_touch(scene, agent, take_text(in, part), spacing));
  }
}

static void add_object(input* in, mimo_scene* scene) {
  char name[NAME_BYTES];
  ROOMY(mimo_object_config, given);
  CALL(mimo_object_config_init(&given.config, sizeof given.config));
  if (take_byte(in) % 2 != 0) take(in, &given.config, sizeof given.config);
  given.config.name = take_text(in, name);
  CALL(mimo_scene_add_object(scene, &given.config));
}

static void use(mimo_env* env) {
  size_t bytes = 0;
  void* block;
  bytes = sizes_of(env).block_bytes;
  block = malloc(bytes > 0 ? bytes : 1);
  if (block == NULL) return;
  if (CALL(mimo_env_reset(env, NULL, block, bytes)) == MIMO_OK) {
    CALL(mimo_env_step(env, NULL, 0, block, bytes, NULL));
  }
  free(block);
}

static void make_env(input* in, const mimo_scene* scene) {
  mimo_env* env = NULL;
  char renderer[NAME_BYTES], task[NAME_BYTES];
  ROOMY(mimo_env_config, given);
  CALL(mimo_env_config_init(&given.config, sizeof given.config));
  if (take_byte(in) % 2 != 0) take(in, &given.config, sizeof given.config);
  given.config.renderer = take_text(in, renderer);
  given.config.task = take_text(in, task);
  given.config.log = NULL;
  if (given.config.frame_skip <= 1000) given.config.frame_skip %= 4;
  if (CALL(mimo_env_create(scene, &given.config, &env)) == MIMO_OK) {
    use(env);
  } else {
    PROMISE(env == NULL);
  }
  mimo_env_destroy(env);
}

static void make_batch(input* in, const mimo_scene* scene) {
  mimo_batch* batch = NULL;
  ROOMY(mimo_batch_config, given);
  CALL(mimo_batch_config_init(&given.config, sizeof given.config));
  take(in, &given.config, sizeof given.config);
  if (given.config.worlds <= 1048576) given.config.worlds %= 3;
  if (given.config.threads <= 4096) given.config.threads %= 3;
  if (CALL(mimo_batch_create(scene, NULL, &given.config, &batch)) == MIMO_OK) {
    CALL(mimo_batch_reset(batch, NULL, NULL, 0));
    CALL(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  } else {
    PROMISE(batch == NULL);
  }
  mimo_batch_destroy(batch);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  input in = {data, size};
  mimo_scene* scene = NULL;
  char name[NAME_BYTES];
  const uint8_t plan = take_byte(&in);
  ROOMY(mimo_scene_config, given);
  CALL(mimo_scene_config_init(&given.config, sizeof given.config));
  if (plan & 1) take(&in, &given.config, sizeof given.config);
  given.config.name = take_text(&in, name);
  given.config.file = given.config.xml = given.config.model_dir = NULL;
  given.config.log = NULL;
  if (CALL(mimo_scene_create(&given.config, &scene)) != MIMO_OK) {
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
