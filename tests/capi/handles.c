/* Handles that are NULL, destroyed or of the wrong kind: every function refuses them, and writes nothing. */
#include "support/capi.h"

#define GUARD 1234567

/* Calls every function that takes an environment. */
static void check_env(mimo_env* env, mimo_status status, const char* part) {
  size_t size = GUARD;
  double value = GUARD, reward = GUARD;
  float depth = GUARD;
  int32_t id = GUARD, segment = GUARD, joint = 0;
  uint8_t flag = 77, rgb = 77, block[8192];
  const char* text = NULL;
  mimo_agent_info info;
  const mimo_layout* layout = NULL;
  mimo_timing timing;
  info.struct_size = sizeof info;
  timing.struct_size = sizeof timing;
  memset(block, 0xab, sizeof block);

  CHECK_FAILS(status, part, mimo_env_layout(env, &layout));
  CHECK_FAILS(status, part, mimo_env_agent(env, 0, &info));
  CHECK_FAILS(status, part, mimo_env_reset(env, SEED(1), block, sizeof block));
  CHECK_FAILS(status, part,
              mimo_env_step(env, NULL, 0, block, sizeof block,
                            RESULTS(.reward = &reward, .terminated = &flag, .truncated = &flag, .agent_count = 1)));
  CHECK_FAILS(status, part, mimo_env_observe(env, block, sizeof block));
  CHECK_FAILS(status, part, mimo_env_physics_step(env, 1));
  CHECK_FAILS(status, part, mimo_env_time(env, &value));
  CHECK_FAILS(status, part, mimo_env_timestep(env, &value));
  CHECK_FAILS(status, part, mimo_env_count(env, MIMO_BODY, &size));
  CHECK_FAILS(status, part, mimo_env_find(env, MIMO_BODY, "world", &id));
  CHECK_FAILS(status, part, mimo_env_name(env, MIMO_BODY, 0, &text));
  CHECK_FAILS(status, part, mimo_env_body_of(env, MIMO_BODY, 0, &id));
  CHECK_FAILS(status, part, mimo_env_width(env, MIMO_BODY_MASS, &joint, 1, &size));
  CHECK_FAILS(status, part, mimo_env_get(env, MIMO_BODY_MASS, &joint, 1, &value, 1));
  CHECK_FAILS(status, part, mimo_env_set(env, MIMO_ACTUATOR_CONTROL, &joint, 1, &value, 1));
  CHECK_FAILS(status, part, mimo_env_update(env));
  CHECK_FAILS(status, part, mimo_env_get_float(env, MIMO_BODY_MASS, &joint, 1, &depth, 1));
  CHECK_FAILS(status, part,
              mimo_env_render(env, NULL,
                              PICTURE(.rgb = &rgb, .rgb_bytes = 1, .depth = &depth, .depth_count = 1,
                                      .segmentation = &segment, .segmentation_count = 1)));
  CHECK_FAILS(status, part, mimo_env_timing(env, &timing));
  CHECK_FAILS(status, part, mimo_env_timing_reset(env));

  CHECK(size == GUARD && value == GUARD && reward == GUARD && depth == GUARD && layout == NULL);
  CHECK(id == GUARD && segment == GUARD && flag == 77 && rgb == 77 && text == NULL);
  CHECK(block[0] == 0xab && memcmp(block, block + 1, sizeof block - 1) == 0);
}

/* Calls every function that takes a layout. */
static void check_layout(const mimo_layout* layout, mimo_status status, const char* part) {
  mimo_layout_info info = {.struct_size = sizeof info, .block_bytes = GUARD};
  mimo_field field;
  mimo_action action;
  mimo_term term;
  size_t size = GUARD;
  double value = GUARD;
  const char* text = NULL;
  field.struct_size = sizeof field;
  action.struct_size = sizeof action;
  term.struct_size = sizeof term;
  CHECK_FAILS(status, part, mimo_layout_describe(layout, &info));
  CHECK_FAILS(status, part, mimo_layout_field(layout, 0, &field));
  CHECK_FAILS(status, part, mimo_layout_find(layout, "touch/force", &size));
  CHECK_FAILS(status, part, mimo_layout_label(layout, 0, 0, &text));
  CHECK_FAILS(status, part, mimo_layout_delays(layout, 0, &value, 1));
  CHECK_FAILS(status, part, mimo_layout_receptor_width(layout, 0, MIMO_RECEPTOR_BODY, &size));
  CHECK_FAILS(status, part, mimo_layout_receptors(layout, 0, MIMO_RECEPTOR_BODY, &value, 1));
  CHECK_FAILS(status, part, mimo_layout_action(layout, 0, &action));
  CHECK_FAILS(status, part, mimo_layout_term(layout, 0, &term));
  CHECK(info.block_bytes == GUARD && size == GUARD && value == GUARD && text == NULL);
}

/* Calls every function that takes a scene. */
static void check_scene(mimo_scene* scene, mimo_status status, const char* part) {
  mimo_env* env = NULL;
  mimo_object_config object;
  size_t agent = GUARD;
  size_t length = GUARD;
  char text[4] = "abc";
  CHECK_OK(mimo_object_config_init(&object, sizeof object));
  object.name = "toy";
  CHECK_FAILS(status, part, mimo_scene_add_agent(scene, NULL, &agent));
  CHECK_FAILS(status, part, mimo_scene_add_object(scene, &object));
  CHECK_FAILS(status, part, mimo_scene_xml(scene, text, sizeof text, &length));
  CHECK_FAILS(status, part, mimo_env_create(scene, NULL, &env));
  CHECK(agent == GUARD && length == GUARD && env == NULL);
  CHECK_TEXT("abc", text);
}

int main(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = blind_env("free", NULL);
  const mimo_layout* layout = layout_of(env);
  size_t count = 0;
  char kept[256];

  check_env(NULL, MIMO_E_INVALID_ARGUMENT, "env is NULL, expected a mimo_env");
  check_scene(NULL, MIMO_E_INVALID_ARGUMENT, "scene is NULL, expected a mimo_scene");
  check_env((mimo_env*)scene, MIMO_E_BAD_HANDLE, "env is not a mimo_env");
  check_scene((mimo_scene*)env, MIMO_E_BAD_HANDLE, "scene is not a mimo_scene");
  check_layout(NULL, MIMO_E_INVALID_ARGUMENT, "layout is NULL, expected a mimo_layout");
  check_layout((const mimo_layout*)env, MIMO_E_BAD_HANDLE, "layout is not a mimo_layout");
  check_env((mimo_env*)layout, MIMO_E_BAD_HANDLE, "env is not a mimo_env");

  /* Destroy ignores what is not its own, and leaves the last error alone. */
  memset(kept, 0, sizeof kept);
  strncpy(kept, mimo_last_error(), sizeof kept - 1);
  mimo_env_destroy((mimo_env*)scene);
  mimo_scene_destroy((mimo_scene*)env);
  mimo_env_destroy((mimo_env*)layout);
  mimo_env_destroy(NULL);
  mimo_scene_destroy(NULL);
  CHECK_TEXT(kept, mimo_last_error());
  CHECK(sizes_of(env).agents == 1);
  CHECK_OK(mimo_scene_xml(scene, NULL, 0, &count));

  mimo_env_destroy(env);
  check_env(env, MIMO_E_BAD_HANDLE, "env is a mimo_env that has been destroyed");
  check_layout(layout, MIMO_E_BAD_HANDLE, "layout is a mimo_layout that has been destroyed");
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  check_scene(scene, MIMO_E_BAD_HANDLE, "scene is a mimo_scene that has been destroyed");
  strncpy(kept, mimo_last_error(), sizeof kept - 1);
  mimo_scene_destroy(scene);
  CHECK_TEXT(kept, mimo_last_error());
  return failures();
}
