/* Behaviours as a C program finds them, and infants that move by themselves. */
#include "support/capi.h"

static mimo_scene* scene_of(const char* name, const char* xml) {
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = name, .xml = xml), &scene));
  return scene;
}

/* WHO's window of sitting without support: 3.8 to 9.2 months, for ten seconds. */
static void check_a_built_in_behaviour(void) {
  mimo_scene* scene = scene_of("sit", NULL);
  mimo_behaviour sit = {.struct_size = sizeof sit};
  CHECK_OK(mimo_scene_behaviour(scene, &sit));
  CHECK_TEXT("sits without support", sit.about);
  CHECK_TEXT("tilt upper_body z", sit.measure);
  CHECK_TEXT("deg", sit.unit);
  CHECK(sit.at_most == 1 && sit.threshold == 45);
  CHECK(strstr(sit.conditions, "contacts hands,forearms ground at most 0 from 2 parts") != NULL);
  CHECK(sit.hold_seconds == 10 && sit.episode_seconds == 15);
  CHECK(sit.norm_early == 3.8 && sit.norm_late == 9.2);
  CHECK(strstr(sit.norm_source, "WHO") != NULL);
  mimo_scene_destroy(scene);
}

static void check_all_scenes(void) {
  const char* name;
  size_t i, found = 0;
  for (i = 0; (name = mimo_scene_name(i)) != NULL; ++i) {
    mimo_scene* scene = scene_of(name, NULL);
    mimo_behaviour it = {.struct_size = sizeof it};
    if (mimo_scene_behaviour(scene, &it) == MIMO_OK) {
      ++found;
      CHECK(it.about[0] != 0 && it.measure[0] != 0 && it.norm_source[0] != 0);
      CHECK((it.norm[0] != 0) == (it.norm_early + it.norm_age + it.norm_late > 0));
    }
    mimo_scene_destroy(scene);
  }
  CHECK(found >= 20);
}

/* "size" of a <numeric> is how many numbers it has; those that are not given are 0 (MuJoCo's reference of MJCF). */
static void check_numbers_as_the_compiler_reads_them(void) {
  mimo_behaviour it = {.struct_size = sizeof it};
  mimo_scene* scene = scene_of(NULL,
                               "<mujoco><custom><text name='mimo:reached' data='height head at least 0.5 m'/>"
                               "<numeric name='mimo:norm' size='3' data='4'/></custom></mujoco>");
  CHECK_OK(mimo_scene_behaviour(scene, &it));
  CHECK(it.norm_early == 4 && it.norm_age == 0 && it.norm_late == 0);
  mimo_scene_destroy(scene);
  scene = scene_of(NULL,
                   "<mujoco><custom><text name='mimo:reached' data='height head at least 0.5 m'/>"
                   "<numeric name='mimo:episode_seconds' size='2' data='5'/></custom></mujoco>");
  CHECK_FAILS(MIMO_E_MODEL, "mimo:episode_seconds: 2 numbers, 5 0, expected one time in s",
              mimo_scene_behaviour(scene, &it));
  mimo_scene_destroy(scene);
}

static void check_a_document_of_ones_own(void) {
  mimo_behaviour it = {.struct_size = sizeof it}, none = {.struct_size = 0};
  mimo_scene* scene = scene_of(NULL,
                               "<mujoco><custom><text name='mimo:reached' data='height head at least 0.5 from 0.2 m'/>"
                               "</custom></mujoco>");
  CHECK_OK(mimo_scene_behaviour(scene, &it));
  CHECK_TEXT("height head", it.measure);
  CHECK(it.at_most == 0 && it.threshold == 0.5 && it.hold_seconds == 0 && it.episode_seconds == 10);
  CHECK_TEXT("", it.about);
  CHECK_TEXT("", it.conditions);
  mimo_scene_destroy(scene);
  scene = scene_of(NULL, "<mujoco><custom><text name='mimo:reached' data='height head above 2 m'/></custom></mujoco>");
  CHECK_FAILS(MIMO_E_MODEL, "\"at least\" or \"at most\"", mimo_scene_behaviour(scene, &it));
  mimo_scene_destroy(scene);
  scene = scene_of(NULL,
                   "<mujoco><custom><text name='mimo:reached' data='height head at least 0.5 m;"
                   "  tilt head  z at most 12.3456789 from 90 deg; share (tilt head z at most 5 deg) at least 0.5'/>"
                   "<numeric name='mimo:episode_seconds' data='3'/></custom></mujoco>");
  CHECK_OK(mimo_scene_behaviour(scene, &it));
  CHECK_TEXT("tilt head z at most 12.3456789 from 90 deg; share (tilt head z at most 5 deg) at least 0.5",
             it.conditions);
  /* Whatever fails, texts of the call before are still there. */
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "behaviour is NULL", mimo_scene_behaviour(scene, NULL));
  CHECK_TEXT("tilt head z at most 12.3456789 from 90 deg; share (tilt head z at most 5 deg) at least 0.5",
             it.conditions);
  CHECK_FAILS(MIMO_E_STRUCT_SIZE, "behaviour", mimo_scene_behaviour(scene, &none));
  CHECK_TEXT("height head", it.measure);
  CHECK_TEXT("m", it.unit);
  mimo_scene_destroy(scene);
  scene = scene_of(NULL,
                   "<mujoco><custom><text name='mimo:reached' data='height head at least 0.5 m'/>"
                   "<numeric name='mimo:episode_seconds' data='-1'/></custom></mujoco>");
  CHECK_FAILS(MIMO_E_MODEL, "mimo:episode_seconds: -1 s, expected", mimo_scene_behaviour(scene, &it));
  mimo_scene_destroy(scene);
  check_numbers_as_the_compiler_reads_them();
  scene = scene_of("reach", NULL);
  CHECK_FAILS(MIMO_E_NOT_FOUND, "describes no behaviour", mimo_scene_behaviour(scene, &it));
  mimo_scene_destroy(scene);
}

/* An infant of six weeks, on its back, without a task. */
static mimo_scene* lying(void) {
  mimo_scene* scene = scene_of("rollover", NULL);
  mimo_agent_config infant;
  mimo_growth growth;
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.age = growth.physiological_age = 1.5;
  CHECK_OK(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.growth = &growth;
  infant.touch = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  return scene;
}

static void check_spontaneous_movements(void) {
  enum { MOST = 128 };
  mimo_scene* scene = lying();
  mimo_env* env = NULL;
  float one[MOST], same[MOST];
  mimo_agent_info agent = {.struct_size = sizeof agent};
  size_t count, i, moving = 0;
  mimo_env_config config;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.task = "none";
  CHECK_OK(mimo_env_create(scene, &config, &env));
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_env_agent(env, 0, &agent));
  count = agent.action_count;
  CHECK(count > 0 && count <= MOST);
  CHECK_OK(mimo_env_reset(env, SEED(7), NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_spontaneous(env, 0, MIMO_MOVEMENT_ALL, one, count));
  CHECK_OK(mimo_env_spontaneous(env, 0, 31, same, count)); /* all kinds, one by one */
  CHECK(memcmp(one, same, count * sizeof *one) == 0);
  for (i = 0; i < count; ++i) moving += one[i] != 0;
  CHECK(moving > 0);
  CHECK_OK(mimo_env_step(env, one, count, NULL, 0, NULL));
  CHECK_OK(mimo_env_spontaneous(env, 0, 0, same, count));
  for (i = 0; i < count; ++i) CHECK(same[i] == 0);
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "which", mimo_env_spontaneous(env, 0, 32, one, count));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "count is", mimo_env_spontaneous(env, 0, 0, one, count - 1));
  mimo_env_destroy(env);
}

static void check_agents_that_have_none(void) {
  mimo_scene* scene = scene_of("catch", NULL); /* it has muscles */
  mimo_env* env = NULL;
  float actions[40];
  CHECK_OK(mimo_scene_add_agents(scene, NULL, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "not moved by torques", mimo_env_spontaneous(env, 0, 0, actions, 40));
  mimo_env_destroy(env);
}

/* Where one of the agents has no such movements, nothing is written of the others either. */
static void check_a_batch_with_one_that_has_none(void) {
  enum { MOST = 512 };
  mimo_scene* scene = scene_of("playdate", NULL);
  mimo_agent_config infant;
  mimo_batch* batch = NULL;
  const mimo_layout* layout = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  float actions[MOST];
  size_t i;
  CHECK_OK(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.touch = infant.vision = 0;
  infant.name = "anna";
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  infant.name = "ben";
  infant.actuation = MIMO_ACTUATION_MUSCLE;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  CHECK_OK(mimo_batch_create(scene, NULL, SIZED(mimo_batch_config, .worlds = 2), &batch));
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_batch_layout(batch, &layout));
  CHECK_OK(mimo_layout_describe(layout, &info));
  CHECK(2 * info.actions <= MOST);
  for (i = 0; i < MOST; ++i) actions[i] = 7;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "agent 1 is not moved by torques",
              mimo_batch_spontaneous(batch, MIMO_MOVEMENT_ALL, actions, 2 * info.actions));
  for (i = 0; i < MOST; ++i) CHECK(actions[i] == 7);
  mimo_batch_destroy(batch);
}

int main(void) {
  check_a_built_in_behaviour();
  check_all_scenes();
  check_a_document_of_ones_own();
  check_spontaneous_movements();
  check_agents_that_have_none();
  check_a_batch_with_one_that_has_none();
  return failures();
}
