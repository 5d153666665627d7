/* Senses written as C functions: what they are given and write. With frame_skip, threads, states, clones, limits and
 * recordings they behave as the library's own senses do. */
#include "support/capi.h"

enum { WORLDS = 5, STEPS = 12 };

/* Of each world and agent. */
typedef struct memory {
  uint64_t ticks;
  double angles; /* the sum of an elbow's, over all ticks */
} memory;

/* What open looks up. */
typedef struct looked_up {
  int32_t elbow;
  size_t balance;
} looked_up;

static int opened = 0, closed = 0, released = 0;

static mimo_status open_elbow(void* user, const mimo_env* env, const mimo_sense_moment* moment,
                              mimo_sense_needs* needs) {
  static const char* const labels[2] = {"ticks", "angles"};
  const size_t shape[1] = {2}, balance_shape[1] = {3};
  char name[80];
  mimo_sense_field field;
  looked_up* mine = malloc(sizeof *mine);
  (void)user;
  needs->own = mine;
  needs->memory_bytes = sizeof(memory);
  needs->sensors = 1;
  snprintf(name, sizeof name, "%srobot:left_elbow", moment->prefix);
  if (mimo_env_find(env, MIMO_JOINT, name, &mine->elbow) != MIMO_OK) return MIMO_E_NOT_FOUND;
  snprintf(name, sizeof name, "%svestibular/acceleration", moment->prefix);
  if (mimo_layout_find(layout_of(env), name, &mine->balance) != MIMO_OK) return MIMO_E_NOT_FOUND;
  if (moment->memory != NULL || moment->fields != NULL || moment->tick != 0) return MIMO_E_INTERNAL;
  CHECK_OK(mimo_sense_field_init(&field, sizeof field));
  field.dtype = MIMO_F64;
  field.unit = "rad";
  field.shape = shape;
  field.ndim = 1;
  field.labels = labels;
  field.label_count = 2;
  CHECK_OK(mimo_sense_add_field(env, &field));
  field.dtype = MIMO_F32;
  field.name = "balance";
  field.shape = balance_shape;
  field.labels = NULL;
  field.label_count = 0;
  CHECK_OK(mimo_sense_add_field(env, &field));
  ++opened;
  return MIMO_OK;
}

static void close_elbow(void* user, void* own) {
  (void)user;
  free(own);
  ++closed;
}

static mimo_status reset_elbow(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  const memory* it = moment->memory;
  (void)user, (void)env;
  return it->ticks == 0 && it->angles == 0 && moment->tick == 0 ? MIMO_OK : MIMO_E_INTERNAL;
}

static mimo_status advance_elbow(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  const looked_up* mine = moment->own;
  memory* it = moment->memory;
  double angle;
  (void)user;
  if (mimo_env_get(env, MIMO_JOINT_POSITION, &mine->elbow, 1, &angle, 1) != MIMO_OK) return MIMO_E_INTERNAL;
  it->angles += moment->parameters[0] * angle;
  return ++it->ticks == moment->tick ? MIMO_OK : MIMO_E_INTERNAL;
}

static mimo_status write_elbow(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  const looked_up* mine = moment->own;
  const memory* it = moment->memory;
  double* values = moment->fields[0];
  const void* felt = NULL;
  (void)user;
  values[0] = (double)it->ticks;
  values[1] = it->angles;
  if (mimo_sense_feel(env, mine->balance, &felt) != MIMO_OK) return MIMO_E_INTERNAL;
  memcpy(moment->fields[1], felt, 3 * sizeof(float));
  return MIMO_OK;
}

static void release_elbow(void* user) {
  (void)user;
  ++released;
}

static const mimo_parameter parameters[1] = {
    {.struct_size = sizeof(mimo_parameter), .name = "gain", .description = "1", .standard = 1, .low = 0, .high = 5}};

static mimo_sense elbow_sense(void) {
  mimo_sense sense;
  CHECK_OK(mimo_sense_init(&sense, sizeof sense));
  sense.interface_version = MIMO_SENSE_INTERFACE;
  sense.name = "elbow";
  sense.parameters = parameters;
  sense.parameter_count = 1;
  sense.open = open_elbow;
  sense.close = close_elbow;
  sense.reset = reset_elbow;
  sense.advance = advance_elbow;
  sense.write = write_elbow;
  sense.release = release_elbow;
  return sense;
}

static mimo_scene* scene_with(const mimo_sense* sense) {
  mimo_scene* scene = blind_scene("free");
  CHECK_OK(mimo_scene_add_sense(scene, 0, sense));
  return scene;
}

static mimo_env* env_of(mimo_scene* scene, uint32_t frame_skip) {
  mimo_env_config config;
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.frame_skip = frame_skip;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  if (env == NULL) exit(failures());
  return env;
}

static mimo_field field_named(const mimo_env* env, const char* name) {
  mimo_field field = {.struct_size = sizeof field};
  size_t index = 0;
  CHECK_OK(mimo_layout_find(layout_of(env), name, &index));
  CHECK_OK(mimo_layout_field(layout_of(env), index, &field));
  return field;
}

static size_t block_bytes(const mimo_env* env) {
  mimo_layout_info info = {.struct_size = sizeof info};
  CHECK_OK(mimo_layout_describe(layout_of(env), &info));
  return info.block_bytes;
}

static void read_elbow(const mimo_env* env, const unsigned char* block, double* values) {
  memcpy(values, block + field_named(env, "elbow").offset, 2 * sizeof(double));
}

/* Four physics steps, one or four to an environment step: the sum of four angles both times. */
static void check_frame_skip(mimo_scene* scene) {
  mimo_env *slow = env_of(scene, 4), *fast = env_of(scene, 1);
  const size_t bytes = block_bytes(slow);
  unsigned char* block = malloc(bytes);
  double expected = 0, angle, values[2];
  const int32_t elbow = find(fast, MIMO_JOINT, "robot:left_elbow");
  int step;
  CHECK_OK(mimo_env_reset(slow, SEED(1), NULL, 0));
  CHECK_OK(mimo_env_reset(fast, SEED(1), block, bytes));
  read_elbow(fast, block, values);
  CHECK(values[0] == 0 && values[1] == 0);
  for (step = 0; step < 4; ++step) {
    CHECK_OK(mimo_env_step(fast, NULL, 0, block, bytes, NULL));
    CHECK_OK(mimo_env_get(fast, MIMO_JOINT_POSITION, &elbow, 1, &angle, 1));
    expected += angle;
  }
  read_elbow(fast, block, values);
  CHECK(values[0] == 4 && values[1] == expected && expected != 0);
  CHECK_OK(mimo_env_step(slow, NULL, 0, block, bytes, NULL));
  read_elbow(slow, block, values);
  CHECK(values[0] == 4 && values[1] == expected);
  free(block);
  mimo_env_destroy(slow);
  mimo_env_destroy(fast);
}

static void check_description(const mimo_env* env, unsigned char* block, size_t bytes) {
  const mimo_field elbow = field_named(env, "elbow"), balance = field_named(env, "elbow/balance");
  const mimo_field vestibular = field_named(env, "vestibular/acceleration");
  const char* label = NULL;
  size_t index = 0;
  CHECK(elbow.dtype == MIMO_F64 && elbow.ndim == 1 && elbow.shape[0] == 2 && balance.dtype == MIMO_F32);
  CHECK_TEXT("rad", elbow.unit);
  CHECK_OK(mimo_layout_find(layout_of(env), "elbow", &index));
  CHECK_OK(mimo_layout_label(layout_of(env), index, 1, &label));
  CHECK_TEXT("angles", label);
  CHECK(balance.offset > vestibular.offset);
  CHECK(memcmp(block + balance.offset, block + vestibular.offset, 3 * sizeof(float)) == 0);
  (void)bytes;
}

/* A state holds the memory: what was loaded, and a clone, go on as the world that was saved. */
static void check_states(mimo_scene* scene) {
  mimo_env *env = env_of(scene, 2), *other = env_of(scene, 2), *clone = NULL;
  const size_t bytes = block_bytes(env);
  unsigned char *block = malloc(bytes), *second = malloc(bytes), *third = malloc(bytes);
  size_t state_bytes = 0;
  void* state;
  mimo_load_report report = {.struct_size = sizeof report};
  int step;
  CHECK_OK(mimo_env_reset(env, SEED(7), NULL, 0));
  for (step = 0; step < 3; ++step) CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, NULL));
  check_description(env, block, bytes);
  CHECK_OK(mimo_env_state_size(env, &state_bytes));
  state = malloc(state_bytes);
  CHECK_OK(mimo_env_state_save(env, state, state_bytes));
  CHECK_OK(mimo_env_state_load(other, state, state_bytes, &report));
  CHECK(report.fresh == 0);
  CHECK_OK(mimo_env_clone(env, &clone));
  for (step = 0; step < 3; ++step) {
    CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, NULL));
    CHECK_OK(mimo_env_step(other, NULL, 0, second, bytes, NULL));
    CHECK_OK(mimo_env_step(clone, NULL, 0, third, bytes, NULL));
    CHECK(memcmp(block, second, bytes) == 0 && memcmp(block, third, bytes) == 0);
  }
  free(state);
  free(block);
  free(second);
  free(third);
  mimo_env_destroy(env);
  mimo_env_destroy(other);
  mimo_env_destroy(clone);
}

/* Another version of the memory, and a world without the sense: the state fits, the memory starts afresh. */
static void check_states_with_another_memory(void) {
  mimo_sense sense = elbow_sense();
  mimo_scene *scene = scene_with(&sense), *newer, *without = blind_scene("free");
  mimo_env *env = env_of(scene, 2), *fresh, *plain = env_of(without, 2);
  const size_t bytes = block_bytes(env);
  unsigned char* block = malloc(bytes);
  double values[2];
  size_t state_bytes = 0;
  void* state;
  mimo_load_report report = {.struct_size = sizeof report};
  sense.version = 2;
  newer = scene_with(&sense);
  fresh = env_of(newer, 2);
  CHECK_OK(mimo_env_reset(env, SEED(7), NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_state_size(env, &state_bytes));
  state = malloc(state_bytes);
  CHECK_OK(mimo_env_state_save(env, state, state_bytes));
  CHECK_OK(mimo_env_state_load(fresh, state, state_bytes, &report));
  CHECK(report.fresh == 1);
  CHECK_TEXT("receptors/sense/elbow", report.fresh_names);
  CHECK_OK(mimo_env_observe(fresh, block, bytes));
  read_elbow(fresh, block, values);
  CHECK(values[0] == 0);
  CHECK_OK(mimo_env_step(fresh, NULL, 0, block, bytes, NULL));
  read_elbow(fresh, block, values);
  CHECK(values[0] == 1); /* the first physics step begins it, the second one counts */
  CHECK_OK(mimo_env_state_load(plain, state, state_bytes, &report));
  CHECK(report.fresh == 0 && report.ignored == 1);
  free(state);
  free(block);
  mimo_env_destroy(env);
  mimo_env_destroy(fresh);
  mimo_env_destroy(plain);
  mimo_scene_destroy(scene);
  mimo_scene_destroy(newer);
  mimo_scene_destroy(without);
}

static void check_batch(mimo_scene* scene) {
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  mimo_env* env = NULL;
  uint64_t seeds[WORLDS];
  size_t bytes, world;
  unsigned char *blocks, *block;
  int step;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 3;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  bytes = block_bytes(env);
  blocks = malloc(WORLDS * bytes);
  block = malloc(bytes);
  for (world = 0; world < WORLDS; ++world) seeds[world] = 40 + world;
  CHECK_OK(mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = WORLDS), blocks, WORLDS * bytes));
  for (step = 0; step < STEPS; ++step) CHECK_OK(mimo_batch_step(batch, NULL, 0, blocks, WORLDS * bytes, NULL));
  for (world = 0; world < WORLDS; ++world) {
    CHECK_OK(mimo_env_reset(env, SEED(seeds[world]), NULL, 0));
    for (step = 0; step < STEPS; ++step) CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, NULL));
    CHECK(memcmp(block, blocks + world * bytes, bytes) == 0);
  }
  free(blocks);
  free(block);
  mimo_batch_destroy(batch);
  mimo_env_destroy(env);
}

/* What is 3 physics steps late was the value of 3 physics steps ago: the number of ticks tells. */
static void check_a_delayed_own_sense(void) {
  const mimo_sense sense = elbow_sense();
  mimo_scene* scene = scene_with(&sense);
  mimo_limits limits;
  mimo_env* env;
  double timestep = 0, values[2];
  size_t bytes;
  unsigned char* block;
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  env = env_of(scene, 2);
  CHECK_OK(mimo_env_timestep(env, &timestep));
  mimo_env_destroy(env);
  limits.delay = 3 * timestep;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "elbow", &limits));
  env = env_of(scene, 2);
  bytes = block_bytes(env);
  block = malloc(bytes);
  CHECK_OK(mimo_env_reset(env, SEED(1), block, bytes));
  CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, NULL));
  CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, NULL));
  CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, NULL));
  read_elbow(env, block, values);
  CHECK(values[0] == 3);
  free(block);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void check_parameters_of_own_senses(void) {
  const mimo_sense sense = elbow_sense();
  mimo_scene* scene = scene_with(&sense);
  mimo_parameter parameter = {.struct_size = sizeof parameter};
  mimo_env *one = env_of(scene, 2), *three;
  const size_t bytes = block_bytes(one);
  unsigned char* block = malloc(bytes);
  double value = 0, first[2], second[2];
  CHECK_OK(mimo_scene_sense_parameter(scene, 0, &parameter));
  CHECK_TEXT("elbow/gain", parameter.name);
  CHECK(parameter.standard == 1 && parameter.low == 0 && parameter.high == 5);
  CHECK_FAILS(MIMO_E_NOT_FOUND, "there are 1 parameters", mimo_scene_sense_parameter(scene, 1, &parameter));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "elbow/gain is 6, expected 0 to 5",
              mimo_scene_set_parameter(scene, "elbow/gain", 6));
  CHECK_FAILS(MIMO_E_NOT_FOUND,
              "no parameter named \"elbow/grain\"; did you mean \"elbow/gain\"? there are: elbow/gain, reach/",
              mimo_scene_set_parameter(scene, "elbow/grain", 1));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "did you mean \"elbow/gain\"?", mimo_scene_get_parameter(scene, "elbow/grain", &value));
  CHECK_OK(mimo_scene_set_parameter(scene, "elbow/gain", 4));
  CHECK_OK(mimo_scene_get_parameter(scene, "elbow/gain", &value));
  CHECK(value == 4);
  three = env_of(scene, 2);
  CHECK_OK(mimo_env_reset(one, SEED(1), NULL, 0));
  CHECK_OK(mimo_env_reset(three, SEED(1), NULL, 0));
  CHECK_OK(mimo_env_step(one, NULL, 0, block, bytes, NULL));
  read_elbow(one, block, first);
  CHECK_OK(mimo_env_step(three, NULL, 0, block, bytes, NULL));
  read_elbow(three, block, second);
  CHECK(second[1] == 4 * first[1] && first[1] != 0); /* powers of 2 are exact */
  free(block);
  mimo_env_destroy(one);
  mimo_env_destroy(three);
  mimo_scene_destroy(scene);
}

/* Each of two infants has its own, with its own joints. */
static void check_an_own_sense_of_two_agents(void) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_sense sense = elbow_sense();
  mimo_parameter parameter = {.struct_size = sizeof parameter};
  unsigned char* block;
  size_t bytes;
  double values[2];
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "playdate";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  CHECK_OK(mimo_scene_add_agents(scene, &agent, NULL));
  CHECK_OK(mimo_scene_add_sense(scene, 0, &sense));
  CHECK_OK(mimo_scene_add_sense(scene, 1, &sense));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "agent 1 has a sense \"elbow\" already", mimo_scene_add_sense(scene, 1, &sense));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "agent is 2", mimo_scene_add_sense(scene, 2, &sense));
  CHECK_OK(mimo_scene_sense_parameter(scene, 1, &parameter));
  CHECK(strstr(parameter.name, "/elbow/gain") != NULL);
  CHECK_OK(mimo_scene_set_parameter(scene, parameter.name, 0));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  bytes = block_bytes(env);
  block = malloc(bytes);
  CHECK_OK(mimo_env_reset(env, SEED(1), NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, block, bytes, NULL));
  {
    char name[80];
    mimo_agent_info info = {.struct_size = sizeof info};
    CHECK_OK(mimo_env_agent(env, 1, &info));
    snprintf(name, sizeof name, "%s/elbow", info.name);
    memcpy(values, block + field_named(env, name).offset, sizeof values);
    CHECK(values[0] == 2 && values[1] == 0);
    CHECK_OK(mimo_env_agent(env, 0, &info));
    snprintf(name, sizeof name, "%s/elbow", info.name);
    memcpy(values, block + field_named(env, name).offset, sizeof values);
    CHECK(values[0] == 2 && values[1] != 0);
  }
  free(block);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* Normal numbers: of 10000 the mean is within 5/100 of 0 and the variance within 7 % of 1 (5 standard errors: 5/sqrt(n)
 * and 5 sqrt(2/n)). */
static void check_noise_of_own_senses(void) {
  double sum = 0, squares = 0;
  int i;
  for (i = 0; i < 10000; ++i) {
    const double one = mimo_sense_noise(3, (uint64_t)i / 7, (uint64_t)i % 7);
    sum += one;
    squares += one * one;
  }
  CHECK_NEAR(0, sum / 10000, 0.05);
  CHECK_NEAR(1, squares / 10000, 0.0708);
  CHECK(mimo_sense_noise(3, 1, 2) == mimo_sense_noise(3, 1, 2));
  CHECK(mimo_sense_noise(3, 1, 2) != mimo_sense_noise(3, 2, 1) &&
        mimo_sense_noise(3, 1, 2) != mimo_sense_noise(4, 1, 2));
}

int main(void) {
  const mimo_sense sense = elbow_sense();
  mimo_scene* scene = scene_with(&sense);
  check_frame_skip(scene);
  check_states(scene);
  check_batch(scene);
  mimo_scene_destroy(scene);
  CHECK(released == 1);
  check_states_with_another_memory();
  check_a_delayed_own_sense();
  check_parameters_of_own_senses();
  check_an_own_sense_of_two_agents();
  check_noise_of_own_senses();
  CHECK(opened == closed && opened > 10 && released == 7);
  return failures();
}
