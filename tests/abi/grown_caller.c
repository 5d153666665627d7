/* A program of the next minor version (make_grown): on the library of that version, and on today's, where what it
 * knows more is refused as unsupported, and what it does not use of that does no harm.
 *   grown_caller today|grown */
#include <dlfcn.h>

#include "support/capi.h"

static int grown;

/* What the library says where the caller uses something new. */
#define NEW(call)                                                         \
  do {                                                                    \
    if (grown)                                                            \
      CHECK_OK(call);                                                     \
    else                                                                  \
      CHECK_FAILS(MIMO_E_UNSUPPORTED, " an interface newer than ", call); \
  } while (0)

static void check_version(void) {
  CHECK(mimo_api_version() == (grown ? MIMO_API_VERSION : MIMO_API_VERSION - 1));
  CHECK(mimo_supports("mimo_env_step") == 1 && mimo_supports("mimo_env_results.terms") == 1);
  CHECK(mimo_supports("mimo_grown") == grown && mimo_supports("mimo_env_results.grown") == grown);
  CHECK(mimo_supports("MIMO_RENDER_GROWN") == grown && mimo_supports("MIMO_WORLD_GROWN") == grown);
  CHECK((dlsym(RTLD_DEFAULT, "mimo_grown") != NULL) == grown);
}

/* A struct of each sort is given with its new member at 0, then with another number there. */
#define BOTH(config, call) \
  do {                     \
    CHECK_OK(call);        \
    (config).grown = 1;    \
    NEW(call);             \
    (config).grown = 0;    \
  } while (0)

static void check_scene(void) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_limits limits;
  mimo_task task;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  CHECK(room.struct_size == sizeof room && room.grown == 0);
  BOTH(room, mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.grown = 1;
  NEW(mimo_scene_add_agent(scene, &agent, NULL));
  agent.grown = 0;
  if (!grown) CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  BOTH(limits, mimo_scene_limit_sense(scene, 0, "touch", &limits));
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.grown = 1;
  CHECK_FAILS(grown ? MIMO_E_INVALID_ARGUMENT : MIMO_E_UNSUPPORTED, "task", mimo_scene_set_task(scene, &task));
  mimo_scene_destroy(scene);
}

/* Structs that the library hands to functions: the new member is there, and 0 unless the library knows it. */
static int told = 0, asked = 0;
static uint64_t verdict_member = 0;

static void hear(void* user, const mimo_log_record* record) {
  (void)user;
  ++told;
  CHECK(record->struct_size == (grown ? sizeof *record : sizeof *record - sizeof record->grown));
  CHECK(record->grown == 0);
}

static void check_log(void) {
  mimo_scene_config room;
  mimo_env_config config;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "free";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.log = hear;
  CHECK_OK(mimo_env_create(scene, &config, &env)); /* a built-in room without its infants: that is told */
  CHECK(told > 0);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static mimo_status evaluate(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  (void)user;
  (void)env;
  ++asked;
  CHECK(moment->struct_size == (grown ? sizeof *moment : sizeof *moment - sizeof moment->grown));
  CHECK(moment->grown == 0 && verdict->grown == 0);
  verdict->grown = verdict_member;
  verdict->reward = 2;
  return MIMO_OK;
}

static void check_task(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_task_field goal;
  mimo_task task;
  mimo_env* env = NULL;
  CHECK_OK(mimo_task_field_init(&goal, sizeof goal));
  goal.name = "goal";
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = evaluate;
  task.fields = &goal;
  task.field_count = 1;
  BOTH(goal, mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_reset(env, SEED(1), NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  verdict_member = 1;
  if (grown)
    CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  else
    CHECK_FAILS(MIMO_E_TASK, "newer", mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  verdict_member = 0;
  CHECK(asked == 2);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void check_ages_and_batches(void) {
  static uint8_t states[1 << 16];
  mimo_scene* scene = blind_scene("free");
  mimo_growth growth;
  const mimo_growth* const one[1] = {&growth};
  mimo_reset_config older = {sizeof older, 1, 5, one, 1, 0};
  mimo_batch_config config;
  mimo_batch_reset_config start;
  mimo_batch_results results;
  mimo_load_report report;
  mimo_batch* batch = NULL;
  size_t bytes = 0;
  mimo_env* env = NULL;
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  BOTH(growth, mimo_env_reset(env, &older, NULL, 0));
  mimo_env_destroy(env);

  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.grown = 1;
  NEW(mimo_batch_create(scene, NULL, &config, &batch));
  if (batch != NULL) mimo_batch_destroy(batch);
  config.grown = 0;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  memset(&start, 0, sizeof start);
  start.struct_size = sizeof start;
  BOTH(start, mimo_batch_reset(batch, &start, NULL, 0));
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  BOTH(results, mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
  CHECK_OK(mimo_batch_state_size(batch, &bytes));
  CHECK(bytes <= sizeof states);
  CHECK_OK(mimo_batch_state_save(batch, NULL, 0, states, sizeof states));
  memset(&report, 0xab, sizeof report);
  report.struct_size = sizeof report;
  CHECK_OK(mimo_batch_state_load(batch, NULL, 0, states, bytes, &report));
  CHECK(report.struct_size == (grown ? sizeof report : sizeof report - sizeof report.grown) && report.grown == 0);
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
}

/* Structs that the library reads and fills keep the size that the caller gave. */
static void check_geometry(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  mimo_mesh mesh;
  mimo_texture texture;
  mimo_light light;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_mesh_init(&mesh, sizeof mesh));
  BOTH(mesh, mimo_env_mesh(env, 0, &mesh));
  memset(&texture, 0, sizeof texture);
  texture.struct_size = sizeof texture;
  BOTH(texture, mimo_env_texture(env, 0, &texture));
  memset(&light, 0, sizeof light);
  light.struct_size = sizeof light;
  BOTH(light, mimo_env_light(env, MIMO_HEADLIGHT, &light));
  CHECK(mesh.struct_size == sizeof mesh && texture.struct_size == sizeof texture && light.struct_size == sizeof light);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void check_world(void) {
  static uint8_t rgb[8 * 8 * 3];
  mimo_scene* scene = blind_scene("free");
  mimo_env_config config;
  mimo_reset_config reset = {sizeof reset, 1, 5, NULL, 0, 0};
  mimo_env_results results;
  mimo_picture_config view;
  mimo_picture picture;
  mimo_agent_info info;
  mimo_env* env = NULL;
  double reward = 7, value = 0;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.renderer = "ray";
  CHECK_OK(mimo_env_create(scene, &config, &env));
  config.render |= MIMO_RENDER_GROWN;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "render is 0x4000000f", mimo_env_create(scene, &config, &env));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "quantity is 0xdff", mimo_env_get(env, MIMO_WORLD_GROWN, NULL, 0, &value, 1));

  BOTH(reset, mimo_env_reset(env, &reset, NULL, 0));
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = &reward;
  results.agent_count = 1;
  BOTH(results, mimo_env_step(env, NULL, 0, NULL, 0, &results));
  CHECK(reward == 0);
  CHECK_OK(mimo_picture_config_init(&view, sizeof view));
  view.width = view.height = 8;
  memset(&picture, 0, sizeof picture);
  picture.struct_size = sizeof picture;
  picture.rgb = rgb;
  picture.rgb_bytes = sizeof rgb;
  BOTH(picture, mimo_env_render(env, &view, &picture));
  BOTH(view, mimo_env_render(env, &view, &picture));

  /* A description says how much of it was filled; the rest is 0. */
  memset(&info, 0xab, sizeof info);
  info.struct_size = sizeof info;
  CHECK_OK(mimo_env_agent(env, 0, &info));
  CHECK(info.struct_size == (grown ? sizeof info : sizeof info - sizeof info.grown) && info.grown == 0);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  grown = strcmp(argv[1], "grown") == 0;
  check_version();
  check_scene();
  check_log();
  check_task();
  check_ages_and_batches();
  check_geometry();
  check_world();
  return failures();
}
