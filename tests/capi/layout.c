/* The layout: the times of fields, the agents of actions and terms, and that threads may read it at any time. */
#include "support/capi.h"

/* What was asked of a layout while its batch was at work. */
typedef struct asked {
  const mimo_layout* expected; /* NULL: nothing is to be asked */
  int answers, wrong;
} asked;

static mimo_status ask(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  asked* it = user;
  const mimo_layout* layout = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  (void)verdict;
  if (it->expected == NULL || moment->world != 0) return MIMO_OK;
  ++it->answers;
  it->wrong += mimo_env_layout(env, &layout) != MIMO_OK || layout != it->expected;
  it->wrong += mimo_layout_describe(layout, &info) != MIMO_OK || info.block_bytes != moment->block_bytes;
  return MIMO_OK;
}

/* A delay is kept in whole time steps: 32 ms are six of 5 ms. */
static void check_when_fields_are_true(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  mimo_limits late;
  mimo_field field;
  CHECK_OK(mimo_limits_init(&late, sizeof late));
  late.delay = 0.032;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "touch", &late));
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "proprioception/position", &late));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  field = field_of(env, "touch/force");
  CHECK_NEAR(-0.035, field.start, 1e-12);
  CHECK_NEAR(-0.035, field.end, 1e-12);
  field = field_of(env, "proprioception/position");
  CHECK_NEAR(-0.03, field.start, 1e-12);
  CHECK_NEAR(-0.03, field.end, 1e-12);
  CHECK_NEAR(0.03, delay_of(env, "proprioception/position", 46), 1e-12);
  CHECK(delay_of(env, "proprioception/velocity", 46) == 0);
  CHECK_NEAR(0.01, field.period, 1e-12);
  field = field_of(env, "proprioception/velocity");
  CHECK(field.start == 0 && field.end == 0);
  field = field_of(env, "vestibular/acceleration");
  CHECK(field.start == -0.005 && field.end == -0.005);
  mimo_env_destroy(env);
}

/* Anna's actions are angles, Ben's shares; the lower of the two joints that bend the hip goes from -17 to 30.5
 * degrees, as in the original's model. */
static void check_descriptions_of_actions(void) {
  mimo_scene_config room;
  mimo_agent_config infant;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_action first, last;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "playdate";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.vision = 0;
  infant.name = "anna";
  infant.acts = MIMO_ACT_TRUNK;
  infant.actuation = MIMO_ACTUATION_POSITION;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  CHECK_OK(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.vision = 0;
  infant.name = "ben";
  infant.acts = MIMO_ACT_TRUNK;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  CHECK(sizes_of(env).agents == 2 && sizes_of(env).actions == 6);
  first = action_at(env, 0);
  last = action_at(env, 5);
  CHECK_TEXT("anna/act:hip_bend", first.name);
  CHECK_TEXT("rad", first.unit);
  CHECK(first.agent == 0 && last.agent == 1);
  CHECK_NEAR(-17 * 3.14159265358979 / 180, first.low, 1e-6);
  CHECK_NEAR(30.5 * 3.14159265358979 / 180, first.high, 1e-6);
  CHECK_TEXT("", last.unit);
  mimo_env_destroy(env);
}

/* All worlds answer with the batch's layout, also from within a task; and so does it while they are at work. */
static void check_the_layout_of_a_batch(void) {
  asked it = {NULL, 0, 0};
  mimo_scene* scene = blind_scene("free");
  mimo_batch_config config;
  mimo_task task;
  mimo_batch* batch = NULL;
  mimo_env* view = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  const mimo_layout *layout = NULL, *again = NULL;
  uint8_t* blocks;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = ask;
  task.user = &it;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 3;
  config.threads = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  mimo_scene_destroy(scene);
  if (batch == NULL) exit(failures());
  CHECK_OK(mimo_batch_layout(batch, &layout));
  CHECK_OK(mimo_batch_world(batch, 2, &view));
  CHECK(layout_of(view) == layout);
  CHECK_OK(mimo_layout_describe(layout, &info));
  CHECK(info.terms == 1 && info.agents == 1);
  CHECK_TEXT("reward", term_name(view, 0));

  it.expected = layout;
  blocks = malloc(3 * info.block_bytes);
  CHECK_OK(mimo_batch_send(batch, NULL, 0, blocks, 3 * info.block_bytes, NULL));
  CHECK_OK(mimo_batch_layout(batch, &again));
  CHECK(again == layout);
  CHECK_TEXT("proprioception/position", field_at(layout, 0).name);
  CHECK_OK(mimo_batch_receive(batch));
  CHECK(it.answers == 1 && it.wrong == 0);
  mimo_batch_destroy(batch);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "layout is a mimo_layout that has been destroyed",
              mimo_layout_describe(layout, &info));
  free(blocks);
}

/* A clone has a layout of its own, which outlives that of the original. */
static void check_the_layout_of_a_clone(void) {
  mimo_env *env = blind_env("free", NULL), *twin = NULL;
  CHECK_OK(mimo_env_clone(env, &twin));
  CHECK(layout_of(twin) != layout_of(env));
  CHECK(sizes_of(twin).block_bytes == sizes_of(env).block_bytes);
  mimo_env_destroy(env);
  CHECK_TEXT("proprioception/position", field_at(layout_of(twin), 0).name);
  mimo_env_destroy(twin);
}

/* A step of three physics steps of 5 ms: of a world, a batch and its worlds. */
static void check_step_seconds(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env_config config;
  mimo_batch_config many;
  mimo_layout_info info = {.struct_size = sizeof info};
  const mimo_layout* layout = NULL;
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  double seconds = 0;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.frame_skip = 3;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  CHECK_NEAR(0.015, sizes_of(env).step_seconds, 1e-15);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_time(env, &seconds));
  CHECK_NEAR(0.015, seconds, 1e-15);
  mimo_env_destroy(env);
  CHECK_OK(mimo_batch_config_init(&many, sizeof many));
  CHECK_OK(mimo_batch_create(scene, &config, &many, &batch));
  CHECK_OK(mimo_batch_layout(batch, &layout));
  CHECK_OK(mimo_layout_describe(layout, &info));
  CHECK_NEAR(0.015, info.step_seconds, 1e-15);
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
}

int main(void) {
  check_step_seconds();
  check_when_fields_are_true();
  check_descriptions_of_actions();
  check_the_layout_of_a_batch();
  check_the_layout_of_a_clone();
  return failures();
}
