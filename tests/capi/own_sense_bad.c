/* Wrong senses: incomplete tables, impossible fields, functions that fail, write past their memory, or change what they
 * may not. The message names each fault, and the world goes on or is not made. */
#define _XOPEN_SOURCE 700 /* setenv */
#include "support/capi.h"

/* What the sense does wrong. */
enum fault {
  NO_FAULT,
  OPEN_FAILS,
  NO_FIELD,
  FIELD_TWICE,
  FIELD_OF_OTHERS,
  SHAPE_OF_0,
  STRANGE_TYPE,
  STRANGE_BOUNDS,
  FEW_LABELS,
  STRANGE_RECEPTOR,
  STRANGE_SKIN,
  MUCH_MEMORY,
  RESET_FAILS,
  ADVANCE_FAILS,
  WRITE_FAILS,
  WRITES_NAN,
  WRITES_TOO_MUCH,
  PAST_FIELD,
  BEFORE_FIELD,
  PAST_MEMORY,
  CHANGES_MEMORY,
  CHANGES_WORLD,
  ADDS_LATE,
  FEELS_NOTHING
};

typedef struct rules {
  enum fault fault;
  const mimo_env* kept; /* for after the function */
} rules;

static mimo_status add(const mimo_env* env, const char* name, size_t size, const char* skin) {
  mimo_sense_field field;
  CHECK_OK(mimo_sense_field_init(&field, sizeof field));
  field.name = name;
  field.shape = &size;
  field.ndim = 1;
  field.low = 0;
  field.high = 10;
  field.skin = skin;
  return mimo_sense_add_field(env, &field);
}

/* Of two numbers, with something wrong. */
static mimo_status add_strange(const mimo_env* env, enum fault fault) {
  static const char* const labels[1] = {"left"};
  static const int32_t receptors[2] = {0, 1000000};
  const size_t size = 2;
  mimo_sense_field field;
  CHECK_OK(mimo_sense_field_init(&field, sizeof field));
  field.shape = &size;
  field.ndim = 1;
  if (fault == STRANGE_TYPE) field.dtype = 17;
  if (fault == STRANGE_BOUNDS) field.low = field.high = 1;
  if (fault == FEW_LABELS) {
    field.labels = labels;
    field.label_count = 1;
  }
  if (fault == STRANGE_RECEPTOR) {
    field.skin = "touch/force";
    field.receptors = receptors;
    field.receptor_count = 2;
  }
  return mimo_sense_add_field(env, &field);
}

static mimo_status open_bad(void* user, const mimo_env* env, const mimo_sense_moment* moment, mimo_sense_needs* needs) {
  rules* rule = user;
  (void)moment;
  rule->kept = env;
  needs->memory_bytes = rule->fault == MUCH_MEMORY ? 16777217 : 8;
  switch (rule->fault) {
    case OPEN_FAILS: return mimo_fail(MIMO_E_NOT_FOUND, "no nose");
    case NO_FIELD: return MIMO_OK;
    case FIELD_OF_OTHERS: return add(env, "position", 2, NULL);
    case SHAPE_OF_0: return add(env, "a", 0, NULL);
    case STRANGE_TYPE:
    case STRANGE_BOUNDS:
    case FEW_LABELS:
    case STRANGE_RECEPTOR: return add_strange(env, rule->fault);
    case STRANGE_SKIN: return add(env, "a", 2, "touch/fur");
    default: break;
  }
  if (rule->fault == FIELD_TWICE && add(env, "a", 2, NULL) != MIMO_OK) return MIMO_E_INTERNAL;
  return add(env, "a", 2, NULL);
}

static mimo_status reset_bad(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  const rules* rule = user;
  (void)env, (void)moment;
  return rule->fault == RESET_FAILS ? mimo_fail(MIMO_E_MODEL, "not today") : MIMO_OK;
}

static mimo_status advance_bad(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  const rules* rule = user;
  double* memory = moment->memory;
  size_t count = 0;
  (void)env;
  memory[0] += 1;
  if (rule->fault == ADVANCE_FAILS && moment->tick == 2) return mimo_fail(MIMO_E_SIMULATION, "dizzy");
  if (rule->fault == PAST_MEMORY) memory[1] = 1;
  if (rule->fault == CHANGES_WORLD) {
    mimo_env* mine = (mimo_env*)env;
    const double value = 1;
    CHECK_FAILS(MIMO_E_BUSY, "may only read", mimo_env_set(mine, MIMO_WORLD_GRAVITY, NULL, 0, &value, 1));
    CHECK_FAILS(MIMO_E_BUSY, "may only read", mimo_env_step(mine, NULL, 0, NULL, 0, NULL));
    CHECK_FAILS(MIMO_E_BUSY, "may only read", mimo_env_reset(mine, NULL, NULL, 0));
    CHECK_FAILS(MIMO_E_BUSY, "may only read", mimo_env_random(mine, &memory[0], 1));
    CHECK_FAILS(MIMO_E_BUSY, "may only read", mimo_env_clone(env, &mine));
    mimo_env_destroy((mimo_env*)env); /* does nothing */
    CHECK_OK(mimo_env_count(env, MIMO_BODY, &count));
    CHECK(count > 10);
  }
  if (rule->fault == ADDS_LATE)
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "another function of the sense \"bad\"", add(env, "late", 2, NULL));
  return MIMO_OK;
}

static mimo_status write_bad(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  const rules* rule = user;
  float* values = moment->fields[0];
  double* memory = moment->memory;
  const void* felt = NULL;
  values[0] = 1;
  switch (rule->fault) {
    case WRITE_FAILS: return mimo_fail(MIMO_E_FILE, "out of ink");
    case WRITES_NAN: values[1] = NAN; break;
    case WRITES_TOO_MUCH: values[1] = 11; break;
    case PAST_FIELD: values[2] = 1; break;
    case BEFORE_FIELD: values[-1] = 1; break;
    case CHANGES_MEMORY: memory[0] += 1; break;
    case FEELS_NOTHING: return mimo_sense_feel(env, 1000, &felt);
    default: break;
  }
  return MIMO_OK;
}

static mimo_sense bad_sense(rules* rule) {
  mimo_sense sense;
  CHECK_OK(mimo_sense_init(&sense, sizeof sense));
  sense.interface_version = MIMO_SENSE_INTERFACE;
  sense.name = "bad";
  sense.user = rule;
  sense.open = open_bad;
  sense.reset = reset_bad;
  sense.advance = advance_bad;
  sense.write = write_bad;
  return sense;
}

static void check_incomplete_tables(void) {
  rules rule = {NO_FAULT, NULL};
  const mimo_sense good = bad_sense(&rule);
  mimo_scene* scene = blind_scene("free");
  mimo_parameter parameters[2] = {{.struct_size = sizeof(mimo_parameter), .name = "a", .standard = 1, .high = 2},
                                  {.struct_size = sizeof(mimo_parameter), .name = "a", .standard = 1, .high = 2}};
  mimo_sense sense = good;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "sense is NULL", mimo_scene_add_sense(scene, 0, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "agent is 1", mimo_scene_add_sense(scene, 1, &good));
  sense.interface_version = 2;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "interface_version is 2, but this library knows 1",
              mimo_scene_add_sense(scene, 0, &sense));
  sense.interface_version = 0;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "interface_version is 0", mimo_scene_add_sense(scene, 0, &sense));
  sense = good;
  sense.struct_size = 16;
  CHECK_FAILS(MIMO_E_STRUCT_SIZE, "struct_size is 16", mimo_scene_add_sense(scene, 0, &sense));
  sense = good;
  sense.name = NULL;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "name is NULL", mimo_scene_add_sense(scene, 0, &sense));
  sense.name = "Nose/left";
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "name is \"Nose/left\"", mimo_scene_add_sense(scene, 0, &sense));
  sense = good;
  sense.open = NULL;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "open is NULL", mimo_scene_add_sense(scene, 0, &sense));
  sense = good;
  sense.write = NULL;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "write is NULL", mimo_scene_add_sense(scene, 0, &sense));
  sense = good;
  sense.host_fills = 1;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "host_fills is 1, and reset", mimo_scene_add_sense(scene, 0, &sense));
  sense.host_fills = 2;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "host_fills is 2", mimo_scene_add_sense(scene, 0, &sense));
  sense = good;
  sense.parameters = parameters;
  sense.parameter_count = 2;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "two parameters \"a\"", mimo_scene_add_sense(scene, 0, &sense));
  sense.parameter_count = 1;
  parameters[0].standard = 3;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "standard is 3, expected 0 to 2", mimo_scene_add_sense(scene, 0, &sense));
  parameters[0].high = NAN;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "low is 0 and high is nan", mimo_scene_add_sense(scene, 0, &sense));
  sense.parameters = NULL;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "parameters is NULL", mimo_scene_add_sense(scene, 0, &sense));
  parameters[0].name = "success_reward";
  parameters[0].standard = parameters[0].high = 1;
  sense.name = "reach";
  sense.parameters = parameters;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "a task has a parameter \"reach/success_reward\" already",
              mimo_scene_add_sense(scene, 0, &sense));
  CHECK_FAILS(MIMO_E_FILE, "/none/lib.so", mimo_scene_load_sense(scene, 0, "/none/lib.so"));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "path is \"\"", mimo_scene_load_sense(scene, 0, ""));
  CHECK_OK(mimo_scene_add_sense(scene, 0, &good)); /* after all these */
  mimo_scene_destroy(scene);
}

/* The world is not made. */
static void check_refused(enum fault fault, mimo_status status, const char* part) {
  rules rule = {fault, NULL};
  mimo_sense sense = bad_sense(&rule);
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  if (fault == FIELD_OF_OTHERS) sense.name = "proprioception";
  CHECK_OK(mimo_scene_add_sense(scene, 0, &sense));
  CHECK_FAILS(status, part, mimo_env_create(scene, NULL, &env));
  CHECK(env == NULL);
  rule.fault = NO_FAULT;
  if (fault != FIELD_OF_OTHERS) CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* The first step fails and has happened: its field is 0, and results are there. Without the fault the next one
 * succeeds. */
static void check_step(enum fault fault, const char* part) {
  rules rule = {NO_FAULT, NULL};
  const mimo_sense sense = bad_sense(&rule);
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  mimo_field field = {.struct_size = sizeof field};
  size_t index = 0, bodies = 0;
  double time = 0, timestep = 0;
  unsigned char* block;
  float values[2];
  double reward = 7;
  const mimo_env_results results = {.struct_size = sizeof results, .agent_count = 1, .reward = &reward};
  CHECK_OK(mimo_scene_add_sense(scene, 0, &sense));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_FAILS(MIMO_E_BUSY, "which has returned", mimo_env_count(rule.kept, MIMO_BODY, &bodies));
  CHECK_OK(mimo_layout_describe(layout_of(env), &info));
  CHECK_OK(mimo_layout_find(layout_of(env), "bad/a", &index));
  CHECK_OK(mimo_layout_field(layout_of(env), index, &field));
  CHECK_OK(mimo_env_timestep(env, &timestep));
  block = malloc(info.block_bytes);
  CHECK_OK(mimo_env_reset(env, SEED(1), block, info.block_bytes));
  rule.fault = fault;
  if (part != NULL)
    CHECK_FAILS(MIMO_E_TASK, part, mimo_env_step(env, NULL, 0, block, info.block_bytes, &results));
  else
    CHECK_OK(mimo_env_step(env, NULL, 0, block, info.block_bytes, &results));
  CHECK(reward == 0); /* without a task */
  CHECK_OK(mimo_env_time(env, &time));
  CHECK_NEAR(2 * timestep, time, 1e-12);
  memcpy(values, block + field.offset, sizeof values);
  CHECK(values[0] == (part == NULL ? 1 : 0) && values[1] == 0);
  rule.fault = NO_FAULT;
  CHECK_OK(mimo_env_step(env, NULL, 0, block, info.block_bytes, NULL));
  memcpy(values, block + field.offset, sizeof values);
  CHECK(values[0] == 1);
  free(block);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* In a batch only the world with the fault fails; here all do, each with its message. */
static void check_faults_in_a_batch(void) {
  rules rule = {NO_FAULT, NULL};
  const mimo_sense sense = bad_sense(&rule);
  mimo_scene* scene = blind_scene("free");
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  mimo_status status = MIMO_OK;
  const char* message = NULL;
  CHECK_OK(mimo_scene_add_sense(scene, 0, &sense));
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 3;
  config.threads = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  CHECK_OK(mimo_batch_reset(batch, NULL, NULL, 0));
  rule.fault = ADVANCE_FAILS;
  CHECK_FAILS(MIMO_E_TASK, "dizzy", mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_world_error(batch, 2, &status, &message));
  CHECK(status == MIMO_E_TASK && strstr(message, "dizzy") != NULL);
  rule.fault = NO_FAULT;
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
}

static void check_fields_that_the_host_fills(void) {
  rules rule = {NO_FAULT, NULL};
  mimo_sense sense = bad_sense(&rule);
  mimo_scene* scene = blind_scene("free");
  mimo_limits limits;
  mimo_env* env = NULL;
  sense.host_fills = 1;
  sense.reset = sense.advance = sense.write = NULL;
  CHECK_OK(mimo_scene_add_sense(scene, 0, &sense));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  mimo_env_destroy(env);
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.noise = 1;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "bad", &limits));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "\"bad/a\"", mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
}

static void set_checks(int on) {
#ifdef _WIN32
  _putenv(on ? "MIMO_CHECK_PLUGINS=1" : "MIMO_CHECK_PLUGINS=");
#else
  if (on)
    setenv("MIMO_CHECK_PLUGINS", "1", 1);
  else
    unsetenv("MIMO_CHECK_PLUGINS");
#endif
}

int main(void) {
  const mimo_sense_field* no_field = NULL;
  mimo_env* env = blind_env("free", NULL);
  const void* felt = NULL;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "expected the handle that the library passes to a function of a sense",
              mimo_sense_feel(env, 0, &felt));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "expected the handle that the library passes to a function of a sense",
              mimo_sense_add_field(env, no_field));
  mimo_env_destroy(env);
  check_incomplete_tables();
  check_refused(OPEN_FAILS, MIMO_E_TASK, "the sense \"bad\"'s function open returned -5 (MIMO_E_NOT_FOUND): no nose");
  check_refused(NO_FIELD, MIMO_E_INVALID_ARGUMENT, "the sense \"bad\" declares no field");
  check_refused(FIELD_TWICE, MIMO_E_TASK, "there are two fields \"bad/a\"");
  check_refused(FIELD_OF_OTHERS, MIMO_E_INVALID_ARGUMENT, "there are two fields \"proprioception/position\"");
  check_refused(SHAPE_OF_0, MIMO_E_TASK, "shape[0] is 0");
  check_refused(STRANGE_TYPE, MIMO_E_TASK, "dtype is 17");
  check_refused(STRANGE_BOUNDS, MIMO_E_TASK, "low is 1 and high is 1, expected low < high");
  check_refused(FEW_LABELS, MIMO_E_TASK, "label_count is 1, expected 2");
  check_refused(STRANGE_RECEPTOR, MIMO_E_TASK, "receptors[1] is 1000000, expected 0 to ");
  check_refused(STRANGE_SKIN, MIMO_E_TASK, "skin is \"touch/fur\", expected a field of the agent's touch");
  check_refused(MUCH_MEMORY, MIMO_E_INVALID_ARGUMENT, "memory_bytes is 16777217");
  check_refused(RESET_FAILS, MIMO_E_TASK, "the sense \"bad\"'s function reset returned -6 (MIMO_E_MODEL): not today");
  check_step(ADVANCE_FAILS, "the sense \"bad\"'s function advance returned -7 (MIMO_E_SIMULATION): dizzy");
  check_step(WRITE_FAILS, "the sense \"bad\"'s function write returned -13 (MIMO_E_FILE): out of ink");
  check_step(FEELS_NOTHING, "field is 1000");
  check_step(CHANGES_WORLD, NULL);
  check_step(ADDS_LATE, NULL);
  check_faults_in_a_batch();
  check_fields_that_the_host_fills();
  set_checks(1);
  check_step(WRITES_NAN,
             "the sense \"bad\"'s function write gave bad/a[1] as nan, expected a finite number from 0 to 10");
  check_step(WRITES_TOO_MUCH, "bad/a[1] as 11");
  check_step(CHANGES_MEMORY, "changed its memory");
  check_step(PAST_FIELD, "the sense \"bad\"'s function write wrote past its field \"bad/a\" of 8 bytes");
  check_step(BEFORE_FIELD, "the sense \"bad\"'s function write wrote before its field \"bad/a\"");
  check_step(PAST_MEMORY, "the sense \"bad\"'s function advance wrote past the 8 bytes of its memory");
  check_step(CHANGES_WORLD, NULL);
  set_checks(0);
  return failures();
}
