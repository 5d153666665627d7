/* Tasks as a C program uses them: parameters, an episode of each, reward terms, outcomes; acting parts, position
 * control, locks, gravity and gears. */
#include "support/capi.h"

static mimo_scene* scene_named(const char* name) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.name = name;
  CHECK_OK(mimo_scene_create(&config, &scene));
  return scene;
}

static mimo_env* env_of(mimo_scene* scene) {
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static void check_parameters_of_tasks(void) {
  mimo_scene* scene = scene_named("reach");
  mimo_parameter parameter;
  size_t count = 0, i;
  double value = 0;
  CHECK_OK(mimo_parameter_count(&count));
  CHECK(count > 20);
  for (i = 0; i < count; ++i) {
    parameter.struct_size = sizeof parameter;
    CHECK_OK(mimo_parameter_describe(i, &parameter));
    CHECK(strchr(parameter.name, '/') != NULL && strlen(parameter.description) > 5);
    CHECK(parameter.low <= parameter.standard && parameter.standard <= parameter.high);
    CHECK_OK(mimo_scene_get_parameter(scene, parameter.name, &value));
    CHECK(value == parameter.standard);
  }
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "index is", mimo_parameter_describe(count, &parameter));
  CHECK_OK(mimo_scene_set_parameter(scene, "reach/success_reward", 7));
  CHECK_OK(mimo_scene_get_parameter(scene, "reach/success_reward", &value));
  CHECK(value == 7);
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no parameter named \"reach/luck\"", mimo_scene_set_parameter(scene, "reach/luck", 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "name is NULL", mimo_scene_set_parameter(scene, NULL, 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "reach/original_rules is 3, expected 0 to 1",
              mimo_scene_set_parameter(scene, "reach/original_rules", 3));
  mimo_scene_destroy(scene);
  CHECK_TEXT("none", mimo_task_name(0));
  CHECK_TEXT("catch", mimo_task_name(4));
  CHECK_TEXT("rollover", mimo_task_name(5));
  CHECK_TEXT("selftouch", mimo_task_name(6));
  CHECK_TEXT("handregard", mimo_task_name(7));
  CHECK_TEXT("behaviour", mimo_task_name(8));
  CHECK(mimo_task_name(9) == NULL);
}

static void check_episode(const char* scene, const char* name, int limit, int frame_skip, int actions) {
  mimo_env* env = NULL;
  const char* task = NULL;
  uint32_t skip = 0;
  size_t action_count = 0, terms = 0;
  uint8_t terminated = 0, truncated = 0;
  int32_t outcome = 7;
  double reward = 0, values[8] = {1, 1, 1, 1, 1, 1, 1, 1}, sum;
  int steps = 0;
  CHECK_OK(mimo_env_make(scene, &env)); /* the task's senses: no eyes, so no renderer is needed */
  CHECK_OK(mimo_env_task(env, &task));
  CHECK_TEXT(name, task);
  CHECK_OK(mimo_env_frame_skip(env, &skip));
  CHECK(skip == (uint32_t)frame_skip);
  action_count = sizes_of(env).actions;
  CHECK(action_count == (size_t)actions);
  CHECK_OK(mimo_env_reset(env, SEED(4), NULL, 0));
  terms = sizes_of(env).terms;
  while (!terminated && !truncated) {
    size_t i;
    CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0,
                           RESULTS(.reward = &reward, .terminated = &terminated, .truncated = &truncated,
                                   .outcome = &outcome, .agent_count = 1, .terms = values, .term_count = terms)));
    for (i = 0, sum = 0; i < terms; ++i) sum += values[i];
    CHECK(sum == reward);
    ++steps;
  }
  CHECK(steps == limit && truncated && !terminated);
  CHECK(outcome == MIMO_OUTCOME_NONE);
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "but terms needs ",
              mimo_env_step(env, NULL, 0, NULL, 0, RESULTS(.terms = values, .term_count = terms - 1)));
  mimo_env_destroy(env);
}

/* BabyBench's score of an episode: entries above 0 over the sum of the goal, by the competition's rules and by ours. */
static void check_babybench_scores(void) {
  static double touched[4 * 36], wanted[4 * 36];
  static const double asked[4] = {34, 34, 32, 32};
  mimo_env* env = NULL;
  int32_t infant = 0;
  int who, geom, any = 0;
  CHECK_OK(mimo_env_make("babybench-crib", &env));
  CHECK_OK(mimo_env_reset(env, SEED(1), NULL, 0));
  for (geom = 0; geom < 200; ++geom) CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_get(env, MIMO_AGENT_GOAL, &infant, 1, wanted, 4 * 36));
  CHECK_OK(mimo_env_get(env, MIMO_AGENT_ACHIEVED, &infant, 1, touched, 4 * 36));
  for (who = 0; who < 4; ++who) {
    double sum = 0;
    for (geom = 0; geom < 36; ++geom) {
      sum += wanted[36 * who + geom];
      CHECK(touched[36 * who + geom] >= 0 && touched[36 * who + geom] <= 200);
      CHECK(touched[36 * who + geom] == 0 || wanted[36 * who + geom] == 1);
      any += touched[36 * who + geom] > 0;
    }
    CHECK(sum == asked[who]);
  }
  CHECK(any > 0);
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "value_count", mimo_env_get(env, MIMO_AGENT_GOAL, &infant, 1, wanted, 35));
  mimo_env_destroy(env);
}

static void check_term_names(void) {
  mimo_env* env = NULL;
  mimo_term term = {0};
  CHECK_OK(mimo_env_make("reach", &env));
  CHECK(sizes_of(env).terms == 2);
  CHECK_TEXT("distance", term_name(env, 0));
  CHECK_TEXT("success", term_name(env, 1));
  term.struct_size = sizeof term;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "index is 2, but there are 2 terms", mimo_layout_term(layout_of(env), 2, &term));
  mimo_env_destroy(env);
}

/* That of the original: all but JOINT_TORQUE and EFFORT. */
static const uint32_t kUsualProprioception = MIMO_PROPRIOCEPTION_ACTUATION | MIMO_PROPRIOCEPTION_VELOCITY |
                                             MIMO_PROPRIOCEPTION_TORQUE | MIMO_PROPRIOCEPTION_LIMIT |
                                             MIMO_PROPRIOCEPTION_POSITION;

static void check_acting_parts_and_position_control(void) {
  mimo_scene* scene = scene_named("standup");
  mimo_agent_config agent;
  mimo_env* env;
  CHECK_OK(mimo_scene_default_agent(scene, &agent, sizeof agent));
  CHECK(agent.vision == 0 && agent.vestibular == 3 && agent.proprioception == kUsualProprioception);
  CHECK(agent.acts == 0 && agent.actuation == MIMO_ACTUATION_TORQUE && agent.normalize_actions == 0);
  agent.acts = 0x800;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "acts is 0x800", mimo_scene_add_agent(scene, &agent, NULL));
  agent.acts = MIMO_ACT_RIGHT_LEG | MIMO_ACT_LEFT_LEG;
  agent.actuation = 4;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "actuation is 4", mimo_scene_add_agent(scene, &agent, NULL));
  agent.actuation = MIMO_ACTUATION_POSITION;
  agent.normalize_actions = 1;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  env = env_of(scene);
  CHECK(sizes_of(env).actions == 8);
  CHECK(action_at(env, 3).low == -1 && action_at(env, 3).high == 1 && strcmp(action_at(env, 3).unit, "") == 0);
  mimo_env_destroy(env);

  scene = scene_named("catch");
  CHECK_OK(mimo_scene_default_agent(scene, &agent, sizeof agent));
  CHECK(strcmp(agent.body, "fingers") == 0 && agent.actuation == MIMO_ACTUATION_MUSCLE && agent.vision == 0);
  agent.body = "mitten";
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "made for fingers only", mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_scene_add_agent(scene, NULL, NULL));
  env = env_of(scene);
  CHECK(sizes_of(env).actions == 40);
  mimo_env_destroy(env);

  scene = scene_named("free");
  CHECK_OK(mimo_scene_default_agent(scene, &agent, sizeof agent));
  CHECK(agent.vision == MIMO_VISION_RGB && strcmp(agent.body, "mitten") == 0);
  agent.vision = 0;
  agent.acts = MIMO_ACT_NONE;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  env = env_of(scene);
  CHECK(sizes_of(env).actions == 0);
  mimo_env_destroy(env);
}

static void check_locks_gravity_and_gears(void) {
  mimo_env* env = blind_env("free", NULL);
  const int32_t elbow = find(env, MIMO_JOINT, "robot:right_elbow");
  const int32_t motor = find(env, MIMO_ACTUATOR, "act:right_elbow");
  const int32_t root = find(env, MIMO_JOINT, "mimo_orientation"), none = -1;
  const double at[2] = {1, -1}, too_far[2] = {1, 3}, half[2] = {0.5, -1}, moon[3] = {0, 0, -1.62}, nan[3] = {0, NAN, 0};
  double angle = 0, lock[2], xyz[3], gear = 5;
  int i;
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_LOCK, &elbow, 1, lock, 2));
  CHECK(lock[0] == 0);
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_LOCK, &root, 1, lock, 2));
  CHECK(lock[0] == 0 && lock[1] == 0);
  CHECK_OK(mimo_env_set(env, MIMO_JOINT_LOCK, &elbow, 1, at, 2));
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_LOCK, &elbow, 1, lock, 2));
  CHECK(lock[0] == 1 && lock[1] == -1);
  for (i = 0; i < 200; ++i) CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, &elbow, 1, &angle, 1));
  CHECK_NEAR(-1, angle, 0.05);
  lock[0] = 0;
  CHECK_OK(mimo_env_set(env, MIMO_JOINT_LOCK, &elbow, 1, lock, 2));
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_LOCK, &elbow, 1, lock, 2));
  CHECK(lock[0] == 0 && lock[1] == -1); /* where it would hold */
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "ids[0] is -1", mimo_env_set(env, MIMO_JOINT_LOCK, &none, 1, at, 2));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "angle is 3", mimo_env_set(env, MIMO_JOINT_LOCK, &elbow, 1, too_far, 2));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "is 0.5, expected 0 or 1",
              mimo_env_set(env, MIMO_JOINT_LOCK, &elbow, 1, half, 2));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "no equality", mimo_env_set(env, MIMO_JOINT_LOCK, &root, 1, at, 2));

  CHECK_OK(mimo_env_get(env, MIMO_WORLD_GRAVITY, NULL, 0, xyz, 3));
  CHECK(xyz[0] == 0 && xyz[2] == -9.81);
  CHECK_OK(mimo_env_set(env, MIMO_WORLD_GRAVITY, NULL, 0, moon, 3));
  CHECK_OK(mimo_env_get(env, MIMO_WORLD_GRAVITY, NULL, 0, xyz, 3));
  CHECK(xyz[2] == -1.62);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "values[1]", mimo_env_set(env, MIMO_WORLD_GRAVITY, NULL, 0, nan, 3));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "value_count", mimo_env_get(env, MIMO_WORLD_GRAVITY, NULL, 0, xyz, 2));

  CHECK_OK(mimo_env_set(env, MIMO_ACTUATOR_GEAR, &motor, 1, &gear, 1));
  gear = 0;
  CHECK_OK(mimo_env_get(env, MIMO_ACTUATOR_GEAR, &motor, 1, &gear, 1));
  CHECK(gear == 5);
  mimo_env_destroy(env);
}

static void keep_text(void* user, const mimo_log_record* record) {
  if (record->level == MIMO_LOG_INFO) snprintf(user, 200, "%s", record->text);
}

/* Nobody does a task in a scene without agents. A room may be empty, which the log tells of a built-in one. */
static void check_tasks_without_agents(void) {
  const char* missing = "mimo_scene_add_agents adds its infants";
  mimo_scene *reach = scene_named("reach"), *room = scene_named("benchmark"), *empty = scene_named(NULL);
  mimo_env_config config;
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  char told[200] = "";
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.log = keep_text;
  config.log_user = told;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, missing, mimo_env_create(reach, NULL, &env));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, missing, mimo_batch_create(reach, NULL, NULL, &batch));
  CHECK_OK(mimo_env_create(empty, &config, &env));
  mimo_env_destroy(env);
  CHECK(told[0] == '\0');
  CHECK_OK(mimo_env_create(room, &config, &env));
  mimo_env_destroy(env);
  CHECK(strstr(told, missing) != NULL);
  config.task = "none";
  CHECK_OK(mimo_env_create(reach, &config, &env));
  mimo_env_destroy(env);
  mimo_scene_destroy(reach);
  mimo_scene_destroy(room);
  mimo_scene_destroy(empty);
}

int main(void) {
  check_parameters_of_tasks();
  check_tasks_without_agents();
  check_episode("reach", "reach", 1000, 2, 8);
  check_episode("standup", "standup", 500, 2, 27);
  check_episode("rollover", "rollover", 1000, 2, 38);
  check_episode("babybench-crib", "selftouch", 1000, 1, 30);
  check_babybench_scores();
  check_term_names();
  check_acting_parts_and_position_control();
  check_locks_gravity_and_gears();
  return failures();
}
