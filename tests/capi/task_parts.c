/* What an own task may declare and judge: terms, fields, an episode that goes on or is cut off; what the library shows
 * it; and what is refused. The task: hold the left elbow at an angle that each episode draws anew. */
#include "support/capi.h"

enum { HANDED = 256, WORLDS = 5, STEPS = 30, CUT = 20 };

/* Of each world and agent. */
typedef struct memory {
  double goal;
} memory;

enum mistake { NO_MISTAKE, NAN_TERM, REWARD_BESIDE, INFINITE_FIELD, OUT_OF_BOUNDS, OUTCOME, GOES_ON, TRUNCATED, NEWER };

typedef struct rules {
  int32_t elbow;
  size_t action; /* of the elbow's motor */
  float most;    /* that it can be told */
  size_t field;  /* where proprioception is in the block */
  int looks;     /* whether the caller has the senses written */
  enum mistake mistake;
} rules;

/* A program of a later version finds what this library does not know: zeros. */
static int has_room(const void* handed, size_t struct_size) {
  const unsigned char* bytes = handed;
  size_t i;
  for (i = struct_size; i < HANDED; ++i) {
    if (bytes[i] != 0) return 0;
  }
  return struct_size < HANDED;
}

static mimo_status start(void* user, mimo_env* env, const mimo_task_moment* moment) {
  memory* own = moment->memory;
  double share;
  (void)user;
  if (!has_room(moment, sizeof *moment)) return MIMO_E_INTERNAL;
  if (moment->struct_size != sizeof *moment || moment->step != 0 || own->goal != 0) return MIMO_E_INTERNAL;
  if (moment->action != NULL || moment->action_count != 0 || moment->block != NULL) return MIMO_E_INTERNAL;
  if (moment->fields[0] != 0 || moment->fields[1] != 0 || moment->fields[2] != 0) return MIMO_E_INTERNAL;
  if (mimo_env_random(env, &share, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  own->goal = -share;
  moment->fields[0] = (float)own->goal;
  moment->fields[1] = 7;
  return MIMO_OK;
}

static void err(const rules* rule, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  switch (rule->mistake) {
    case NO_MISTAKE: break;
    case NAN_TERM: verdict->terms[1] = NAN; break;
    case REWARD_BESIDE: verdict->reward = 0.5; break;
    case INFINITE_FIELD: moment->fields[2] = INFINITY; break;
    case OUT_OF_BOUNDS: moment->fields[0] = 4; break;
    case OUTCOME: verdict->outcome = 2; break;
    case GOES_ON: verdict->goes_on = 3; break;
    case TRUNCATED: verdict->truncated = 9; break;
    case NEWER: ((unsigned char*)verdict)[HANDED - 1] = 1; break;
  }
}

static mimo_status judge(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  const rules* rule = user;
  const memory* own = moment->memory;
  double angle;
  if (!has_room(moment, sizeof *moment) || !has_room(verdict, sizeof *verdict)) return MIMO_E_INTERNAL;
  if (verdict->struct_size != sizeof *verdict || verdict->reward != 0 || verdict->outcome != 0) return MIMO_E_INTERNAL;
  if (verdict->terms[0] != 0 || verdict->terms[1] != 0 || verdict->goes_on != 0) return MIMO_E_INTERNAL;
  if ((moment->block != NULL) != rule->looks || (moment->block_bytes > 0) != rule->looks) return MIMO_E_INTERNAL;
  if (mimo_env_get(env, MIMO_JOINT_POSITION, &rule->elbow, 1, &angle, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  verdict->terms[0] = -fabs(angle - own->goal);
  if (moment->action != NULL) verdict->terms[1] = -moment->action[rule->action];
  moment->fields[1] = (float)moment->step;
  moment->fields[2] = (float)angle;
  if (moment->step % 4 == 0) {
    verdict->outcome = MIMO_OUTCOME_SUCCESS;
    verdict->goes_on = moment->step != 8;
  }
  verdict->truncated = moment->step == CUT;
  err(rule, moment, verdict);
  return MIMO_OK;
}

/* ---- A scene with it ---- */

static const size_t one = 1, two = 2;

static mimo_task_field field(const char* name, const size_t* shape) {
  mimo_task_field it;
  CHECK_OK(mimo_task_field_init(&it, sizeof it));
  it.name = name;
  it.shape = shape;
  it.ndim = shape != NULL;
  return it;
}

static mimo_task task_of(rules* rule, const char* const* terms, const mimo_task_field* fields) {
  mimo_task task;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  CHECK(task.terms == NULL && task.term_count == 0 && task.fields == NULL && task.field_count == 0);
  task.user = rule;
  task.memory_bytes = sizeof(memory);
  task.reset = start;
  task.evaluate = judge;
  task.terms = terms;
  task.term_count = 2;
  task.fields = fields;
  task.field_count = 2;
  return task;
}

/* All that it is told is gone before there are worlds: it is copied. */
static mimo_scene* scene_with(rules* rule) {
  mimo_scene* scene = blind_scene("free");
  char names[2][8] = {"near", "lazy"}, goal[8] = "goal", unit[4] = "rad";
  const char* terms[2] = {names[0], names[1]};
  mimo_task_field fields[2];
  mimo_task task;
  fields[0] = field(goal, NULL);
  fields[0].unit = unit;
  fields[0].low = -1;
  fields[0].high = 0.5;
  fields[1] = field("reached", &two);
  task = task_of(rule, terms, fields);
  CHECK_OK(mimo_scene_set_task(scene, &task));
  memset(names, 'x', sizeof names);
  memset(goal, 'x', sizeof goal);
  memset(unit, 'x', sizeof unit);
  memset(fields, 0xff, sizeof fields);
  return scene;
}

static mimo_env* env_of(const mimo_scene* scene) {
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  if (env == NULL) exit(failures());
  return env;
}

static const float* floats(const uint8_t* block, mimo_field it) { return (const float*)(block + it.offset); }

/* ---- What it declares, and what comes of it ---- */

static void check_declared(const mimo_env* env) {
  mimo_field goal = field_of(env, "goal"), reached = field_of(env, "reached");
  CHECK(goal.dtype == MIMO_F32 && goal.ndim == 1 && goal.shape[0] == 1 && goal.bytes == 4);
  CHECK(goal.low == -1 && goal.high == 0.5);
  CHECK_TEXT("rad", goal.unit);
  CHECK_TEXT("", goal.frame);
  CHECK(reached.shape[0] == 2 && reached.low == -INFINITY && reached.high == INFINITY);
  CHECK(sizes_of(env).terms == 2);
  CHECK_TEXT("near", term_name(env, 0));
  CHECK_TEXT("lazy", term_name(env, 1));
}

/* The elbow's motor is told more than it can do, and the task is shown what it does. */
static void check_steps(mimo_env* env, rules* rule) {
  mimo_field goal = field_of(env, "goal"), reached = field_of(env, "reached");
  size_t bytes = 0, actions = 0, state_bytes = 0, step;
  double first[STEPS];
  uint8_t *block, *state;
  float* action;
  bytes = sizes_of(env).block_bytes;
  actions = sizes_of(env).actions;
  CHECK_OK(mimo_env_state_size(env, &state_bytes));
  block = malloc(bytes);
  state = malloc(state_bytes);
  action = calloc(actions, sizeof *action);
  action[rule->action] = 3;
  rule->looks = 1;
  CHECK_OK(mimo_env_reset(env, SEED(3), block, bytes));
  CHECK(floats(block, goal)[0] < 0 && floats(block, reached)[0] == 7 && floats(block, reached)[1] == 0);
  for (step = 1; step <= STEPS; ++step) {
    double reward = 0, angle, terms[2], target;
    uint8_t ends = 9, cut = 9;
    int32_t outcome = 9;
    CHECK_OK(mimo_env_step(env, action, actions, block, bytes,
                           RESULTS(.reward = &reward, .terminated = &ends, .truncated = &cut, .outcome = &outcome,
                                   .agent_count = 1, .terms = terms, .term_count = 2)));
    CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, &rule->elbow, 1, &angle, 1));
    target = floats(block, goal)[0];
    CHECK(reward == terms[0] + terms[1] && terms[1] == -rule->most);
    CHECK_NEAR(-fabs(angle - target), terms[0], 1e-7);
    CHECK(floats(block, reached)[0] == (float)step && floats(block, reached)[1] == (float)angle);
    CHECK(outcome == (step % 4 == 0 ? MIMO_OUTCOME_SUCCESS : MIMO_OUTCOME_NONE));
    CHECK(ends == (step == 8) && cut == (step == CUT));
    first[step - 1] = reward;
    if (step == 8) CHECK_OK(mimo_env_state_save(env, state, state_bytes));
  }
  CHECK_OK(mimo_env_state_load(env, state, state_bytes, NULL));
  CHECK_OK(mimo_env_observe(env, block, bytes));
  CHECK(floats(block, reached)[0] == 8);
  for (step = 9; step <= STEPS; ++step) {
    double reward = 0;
    CHECK_OK(mimo_env_step(env, action, actions, block, bytes, RESULTS(.reward = &reward, .agent_count = 1)));
    CHECK(reward == first[step - 1] && floats(block, reached)[0] == (float)step);
  }
  rule->looks = 0;
  free(action);
  free(state);
  free(block);
}

/* A batch starts episodes anew where the task ends or cuts them, and gives what single worlds give. */
static void check_batch(const mimo_scene* scene) {
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  mimo_batch_results results;
  double reward[WORLDS], expected;
  uint8_t ends[WORLDS], anew[WORLDS];
  uint64_t seeds[WORLDS];
  mimo_env* alone[WORLDS];
  size_t i;
  int step;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 2;
  config.autoreset = MIMO_AUTORESET_NEXT_STEP;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  for (i = 0; i < WORLDS; ++i) {
    seeds[i] = 90 + i;
    alone[i] = env_of(scene);
    CHECK_OK(mimo_env_reset(alone[i], SEED(seeds[i]), NULL, 0));
  }
  CHECK_OK(mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = WORLDS), NULL, 0));
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = reward;
  results.terminated = ends;
  results.was_reset = anew;
  results.agent_count = results.worlds = WORLDS;
  for (step = 1; step <= 3 * 9; ++step) { /* eight steps an episode, and one that begins the next */
    CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
    for (i = 0; i < WORLDS; ++i) {
      CHECK(anew[i] == (step % 9 == 0) && ends[i] == (step % 9 == 8));
      if (anew[i]) {
        CHECK_OK(mimo_env_reset(alone[i], NULL, NULL, 0));
      } else {
        CHECK_OK(mimo_env_step(alone[i], NULL, 0, NULL, 0, RESULTS(.reward = &expected, .agent_count = 1)));
        CHECK(reward[i] == expected);
      }
    }
  }
  for (i = 0; i < WORLDS; ++i) mimo_env_destroy(alone[i]);
  mimo_batch_destroy(batch);
}

/* Its own goal for each of two infants. */
static mimo_status own_number(void* user, mimo_env* env, const mimo_task_moment* moment) {
  (void)user, (void)env;
  moment->fields[0] = 10 + (float)moment->agent;
  return MIMO_OK;
}

static mimo_status no_verdict(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  (void)user, (void)env;
  verdict->reward = moment->memory == NULL && moment->action_count == 25;
  return MIMO_OK;
}

static void check_a_task_for_each_infant(void) {
  mimo_scene_config config;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  mimo_env* env;
  mimo_task task;
  mimo_task_field goal = field("goal", &one);
  size_t bytes = 0, count = 0;
  uint8_t* block;
  float action[50] = {0};
  double reward[2] = {0, 0};
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.name = "playdate";
  CHECK_OK(mimo_scene_create(&config, &scene));
  CHECK_OK(mimo_scene_default_agent(scene, &agent, sizeof agent));
  agent.vision = 0;
  CHECK_OK(mimo_scene_add_agents(scene, &agent, &count));
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.reset = own_number;
  task.evaluate = no_verdict;
  task.fields = &goal;
  task.field_count = 1;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  env = env_of(scene);
  bytes = sizes_of(env).block_bytes;
  block = malloc(bytes);
  CHECK_OK(mimo_env_reset(env, NULL, block, bytes));
  CHECK(floats(block, field_of(env, "anna/goal"))[0] == 10 && floats(block, field_of(env, "ben/goal"))[0] == 11);
  CHECK_OK(mimo_env_step(env, action, 50, block, bytes, RESULTS(.reward = reward, .agent_count = 2)));
  CHECK(reward[0] == 1 && reward[1] == 1);
  CHECK(floats(block, field_of(env, "ben/goal"))[0] == 11);
  free(block);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* What it is shown is this step's: the joint's angle as sensed is the joint's angle. */
static mimo_status look(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  const rules* rule = user;
  double angle;
  if (mimo_env_get(env, MIMO_JOINT_POSITION, &rule->elbow, 1, &angle, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  verdict->reward = ((const float*)((const char*)moment->block + rule->field))[0] == (float)angle;
  return MIMO_OK;
}

static void check_what_a_task_is_shown(void) {
  rules rule = {0};
  mimo_scene* scene = blind_scene("free");
  mimo_task task;
  mimo_env* env;
  size_t bytes = 0;
  uint8_t* block;
  double reward = 0;
  int step;
  CHECK_OK(mimo_scene_read_joint(scene, 0, "robot:left_elbow"));
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = look;
  task.user = &rule;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  env = env_of(scene);
  rule.elbow = find(env, MIMO_JOINT, "robot:left_elbow");
  rule.field = field_of(env, "proprioception/position").offset;
  bytes = sizes_of(env).block_bytes;
  block = malloc(bytes);
  for (step = 0; step < 5; ++step) {
    memset(block, 0xab, bytes);
    CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, RESULTS(.reward = &reward, .agent_count = 1)));
    CHECK(reward == 1);
  }
  free(block);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* ---- What is refused ---- */

static mimo_status step_once(mimo_env* env) { return mimo_env_step(env, NULL, 0, NULL, 0, NULL); }

static void check_mistakes(mimo_env* env, rules* rule) {
  size_t bytes = 0, state_bytes = 0;
  uint8_t *block, *state;
  bytes = sizes_of(env).block_bytes;
  CHECK_OK(mimo_env_state_size(env, &state_bytes));
  block = malloc(bytes);
  state = malloc(state_bytes);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK_OK(step_once(env));
  rule->mistake = NAN_TERM;
  CHECK_FAILS(MIMO_E_TASK, "gave agent 0 the term \"lazy\" as nan, expected a finite number", step_once(env));
  rule->mistake = REWARD_BESIDE;
  CHECK_FAILS(MIMO_E_TASK, "the reward 0.5 beside terms, expected 0", step_once(env));
  rule->mistake = INFINITE_FIELD;
  CHECK_FAILS(MIMO_E_TASK, "gave agent 0 reached[1] as inf, expected a finite number", step_once(env));
  rule->mistake = OUT_OF_BOUNDS;
  CHECK_FAILS(MIMO_E_TASK, "gave agent 0 goal[0] as 4, expected a finite number from -1 to 0.5", step_once(env));
  rule->mistake = OUTCOME;
  CHECK_FAILS(MIMO_E_TASK, "gave agent 0 outcome as 2, which needs an interface newer", step_once(env));
  rule->mistake = GOES_ON;
  CHECK_FAILS(MIMO_E_TASK, "gave agent 0 goes_on as 3, which needs an interface newer", step_once(env));
  rule->mistake = TRUNCATED;
  CHECK_FAILS(MIMO_E_TASK, "gave agent 0 truncated as 9, which needs an interface newer", step_once(env));
  rule->mistake = NEWER;
  CHECK_FAILS(MIMO_E_TASK, "gave agent 0 a verdict with a member at byte 255, which needs an interface newer",
              step_once(env));
  rule->mistake = NO_MISTAKE;
  CHECK_OK(mimo_env_state_save(env, state, state_bytes)); /* holds numbers only */
  CHECK_OK(mimo_env_state_load(env, state, state_bytes, NULL));
  CHECK_OK(mimo_env_observe(env, block, bytes));
  CHECK(floats(block, field_of(env, "reached"))[0] == 1); /* of the last step that was good */
  CHECK_OK(step_once(env));
  free(state);
  free(block);
}

static void refuse(mimo_scene* scene, const mimo_task* task, const char* why) {
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, why, mimo_scene_set_task(scene, task));
}

static void check_refused_descriptions(void) {
  rules rule = {0};
  mimo_scene* scene = blind_scene("free");
  const char* terms[2] = {"near", "lazy"};
  const size_t wide[2] = {1024, 1024}, none = 0;
  mimo_task_field fields[2];
  mimo_task task = task_of(&rule, terms, fields);
  mimo_env* env = NULL;
  mimo_limits limits;
  fields[0] = field("goal", &one);
  fields[1] = field("reached", &two);
  CHECK_OK(mimo_scene_set_task(scene, &task));

  terms[1] = "near";
  refuse(scene, &task, "task: there are two terms \"near\"");
  terms[1] = "";
  refuse(scene, &task, "task: terms[1] is \"\", expected a name");
  terms[1] = NULL;
  refuse(scene, &task, "task: terms[1] is NULL, expected a name");
  terms[1] = "lazy";
  task.terms = NULL;
  refuse(scene, &task, "task: terms is NULL, but its length is 2");
  task.terms = terms;
  task.term_count = 1001;
  refuse(scene, &task, "task: terms has a length of 1001, expected up to 1000");
  task.term_count = 2;

  task.fields = NULL;
  refuse(scene, &task, "task: fields is NULL, but its length is 2");
  task.fields = fields;
  task.field_count = (size_t)-1;
  refuse(scene, &task, "task: fields has a length of");
  task.field_count = 2;
  fields[1].name = "goal";
  refuse(scene, &task, "task: there are two fields \"goal\"");
  fields[1].name = NULL;
  refuse(scene, &task, "task: fields[1]: name is NULL");
  fields[1].name = "/goal";
  refuse(scene, &task, "task: fields[1]: name is \"/goal\", expected no / at its ends");
  fields[1].name = "reached";
  fields[1].low = fields[1].high;
  refuse(scene, &task, "task: fields[1]: low is inf and high is inf, expected low < high");
  fields[1].low = NAN;
  refuse(scene, &task, "task: fields[1]: low is nan");
  fields[1].low = 0;
  fields[1].ndim = 5;
  refuse(scene, &task, "task: fields[1]: ndim is 5, expected up to 4");
  fields[1].ndim = 1;
  fields[1].shape = NULL;
  refuse(scene, &task, "task: fields[1]: shape is NULL");
  fields[1].shape = &none;
  refuse(scene, &task, "task: fields[1]: shape[0] is 0, expected 1 to 262144");
  fields[1].shape = wide;
  fields[1].ndim = 2;
  refuse(scene, &task, "task: fields[1]: it has more than 262144 numbers");
  fields[1] = field("reached", &two);
  fields[1].struct_size = 3;
  CHECK_FAILS(MIMO_E_STRUCT_SIZE, "task: fields[1]: struct_size is 3", mimo_scene_set_task(scene, &task));
  fields[0].struct_size += 4; /* the next one would not be aligned */
  fields[1].struct_size = 0;
  refuse(scene, &task, "task: fields[0]: struct_size is 60, expected a multiple of 8");
  fields[0] = field("goal", &one);

  fields[1] = field("touch/force", &two);
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "there are two fields \"touch/force\"", mimo_env_create(scene, NULL, &env));
  fields[1].name = "reached";
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.delay = 1;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "goal", &limits));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "limits: \"goal\" is a field of the task", mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
}

int main(void) {
  rules rule = {0};
  mimo_env* env = blind_env("free", NULL);
  mimo_scene* scene;
  size_t count = 0, i;
  rule.elbow = find(env, MIMO_JOINT, "robot:left_elbow");
  count = sizes_of(env).actions;
  for (i = 0; i < count; ++i) {
    if (strcmp(action_at(env, i).name, "act:left_elbow") == 0) rule.action = i;
  }
  rule.most = (float)action_at(env, rule.action).high;
  CHECK(rule.most > 0 && rule.most < 3);
  mimo_env_destroy(env);
  scene = scene_with(&rule);
  env = env_of(scene);
  check_declared(env);
  check_steps(env, &rule);
  check_batch(scene);
  check_mistakes(env, &rule);
  check_a_task_for_each_infant();
  check_what_a_task_is_shown();
  check_refused_descriptions();
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return failures();
}
