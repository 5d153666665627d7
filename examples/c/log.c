/* Messages of the library: it is silent unless a config brings a callback. */
#include <mimo/mimo.h>
#include <stdio.h>

/* `user` is what the config says; here it counts. */
static void on_message(void* user, const mimo_log_record* record) {
  ++*(int*)user;
  printf("%s: %s\n", record->level == MIMO_LOG_WARNING ? "warning" : "info", record->text);
  if (record->in_world) printf("  in world %zu after %g s\n", record->world, record->time);
}

int main(void) {
  /* Room for one contact only: MuJoCo complains when both balls lie on the floor, and goes on. */
  static const char* const kXml =
      "<mujoco><size nconmax='1' njmax='100'/><worldbody><geom type='plane' size='1 1 1'/>"
      "<body pos='-0.3 0 0.1'><freejoint/><geom size='0.1'/></body>"
      "<body pos='0.3 0 0.1'><freejoint/><geom size='0.1'/></body></worldbody></mujoco>";
  mimo_scene_config scene_config;
  mimo_env_config env_config;
  mimo_scene* scene;
  mimo_env* env;
  int messages = 0, step;

  mimo_scene_config_init(&scene_config, sizeof scene_config);
  scene_config.xml = kXml;
  mimo_env_config_init(&env_config, sizeof env_config);
  env_config.log = on_message;
  env_config.log_user = &messages;
  if (mimo_scene_create(&scene_config, &scene) != MIMO_OK || mimo_env_create(scene, &env_config, &env) != MIMO_OK) {
    fprintf(stderr, "%s\n", mimo_last_error());
    return 1;
  }
  for (step = 0; step < 10; ++step) mimo_env_step(env, NULL, 0, NULL, 0, NULL);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return messages > 0 ? 0 : 1;
}
