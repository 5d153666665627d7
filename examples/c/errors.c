/* What errors look like, and how to live with them: nothing is lost, nothing crashes. */
#include <math.h>
#include <mimo/mimo.h>
#include <stdio.h>

static void explain(const char* what, mimo_status status) {
  printf("%s\n  %s: %s\n", what, mimo_status_name(status), status == MIMO_OK ? "done" : mimo_last_error());
}

int main(void) {
  mimo_scene_config config;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  float action[44] = {0};
  double push[6] = {0};
  int32_t head;
  mimo_status status;

  mimo_scene_config_init(&config, sizeof config);
  config.name = "benchmarc";
  explain("A scene that is not there:", mimo_scene_create(&config, &scene));
  config.name = "benchmark";
  explain("One that is:", mimo_scene_create(&config, &scene));
  if (scene == NULL) return 1;

  mimo_agent_config_init(&agent, sizeof agent);
  agent.vision = 0;
  explain("An infant:", mimo_scene_add_agent(scene, &agent, NULL));
  explain("A world:", mimo_env_create(scene, NULL, &env));
  if (env == NULL) return 1;

  action[7] = (float)NAN;
  explain("An action that is not a number is refused, and nothing happens:",
          mimo_env_step(env, action, 44, NULL, 0, NULL));
  action[7] = 0;

  /* A push of a hundred thousand tons: the simulation diverges, which is reported and not hidden. */
  if (mimo_env_find(env, MIMO_BODY, "head", &head) != MIMO_OK) return 1;
  push[0] = 1e12;
  mimo_env_set(env, MIMO_BODY_FORCE, &head, 1, push, 6);
  status = mimo_env_step(env, action, 44, NULL, 0, NULL);
  explain("A simulation that diverges:", status);
  if (status != MIMO_E_SIMULATION) return 1;
  explain("The world then wants a reset:", mimo_env_step(env, action, 44, NULL, 0, NULL));
  explain("Reset:", mimo_env_reset(env, NULL, NULL, 0));
  explain("And all is well:", mimo_env_step(env, action, 44, NULL, 0, NULL));

  mimo_env_destroy(env);
  explain("A handle that was destroyed is recognised:", mimo_env_reset(env, NULL, NULL, 0));
  mimo_scene_destroy(scene);
  return 0;
}
