/* Receptors of the skin, and the warmth of things. */
#include "support/capi.h"

static size_t elements(const mimo_env* env, const char* name, const char* unit) {
  mimo_field field = {.struct_size = sizeof field};
  size_t index, count = 1;
  CHECK_OK(mimo_layout_find(layout_of(env), name, &index));
  CHECK_OK(mimo_layout_field(layout_of(env), index, &field));
  CHECK(strcmp(field.unit, unit) == 0);
  for (size_t i = 0; i < field.ndim; ++i) count *= field.shape[i];
  return count;
}

static void receptors_are_fields(void) {
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_agent_config agent;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "benchmark"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  agent.touch = MIMO_TOUCH_SA1 | MIMO_TOUCH_SA2 | MIMO_TOUCH_TEMPERATURE | MIMO_TOUCH_NOCICEPTION_SLOW;
  agent.vestibular = MIMO_VESTIBULAR_CANALS | MIMO_VESTIBULAR_OTOLITHS | MIMO_VESTIBULAR_GRAVITY;
  agent.proprioception = MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY | MIMO_PROPRIOCEPTION_TENDON_ORGAN;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "celsius is 100", mimo_scene_set_room_temperature(scene, 100));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "-300", mimo_scene_set_temperature(scene, "head", -300));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "kryptonite", mimo_scene_set_material(scene, "head", "kryptonite"));
  CHECK_OK(mimo_scene_set_room_temperature(scene, 20));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  const size_t sensors = elements(env, "touch/sa1", "Hz");
  CHECK(sensors > 5000);
  CHECK(elements(env, "touch/sa2", "Hz") == 2 * sensors);
  CHECK(elements(env, "touch/temperature", "degC") == sensors);
  CHECK(elements(env, "vestibular/canals", "Hz") == 12);
  CHECK(elements(env, "vestibular/otoliths", "Hz") == 16);
  CHECK(elements(env, "vestibular/gravity", "m/s^2") == 3);
  CHECK(elements(env, "proprioception/spindle_primary", "Hz") == elements(env, "proprioception/tendon_organ", "Hz"));
  mimo_env_destroy(env);
  env = NULL;
  CHECK_OK(mimo_scene_set_temperature(scene, "cup", 10));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "cup", mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
}

int main(void) {
  receptors_are_fields();
  return failures();
}
