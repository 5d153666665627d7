/* Worlds of other ages: batches of several, and resets that bring another one. */
#include "support/capi.h"

enum { WORLDS = 6, STEPS = 8 };

static mimo_growth aged(double months) {
  mimo_growth growth;
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.age = months;
  return growth;
}

#define AGED(...)                                                               \
  SIZED(mimo_reset_config, .growth = (const mimo_growth* const[]){__VA_ARGS__}, \
        .growth_count = sizeof((const mimo_growth* const[]){__VA_ARGS__}) / sizeof(const mimo_growth*))

static mimo_scene* scene_with(const mimo_growth* growth) {
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "reach"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  agent.growth = growth;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  return scene;
}

static mimo_env* env_of(mimo_scene* scene) {
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static double value_of(const mimo_env* env, int32_t quantity) {
  const int32_t first = 0;
  double value = -1;
  CHECK_OK(mimo_env_get(env, quantity, &first, 1, &value, 1));
  return value;
}

static double mass_of(const mimo_env* env) {
  mimo_agent_info info = {.struct_size = sizeof info};
  CHECK_OK(mimo_env_agent(env, 0, &info));
  return info.mass;
}

/* What a world observes, how it is rewarded, and its state after some steps: for comparing two worlds to the bit. */
typedef struct course {
  uint8_t *blocks, *state;
  size_t block_bytes, state_bytes;
  double rewards[STEPS];
} course;

static course run(mimo_env* env) {
  course it;
  const mimo_layout_info sizes = sizes_of(env);
  float* action = calloc(sizes.actions, sizeof *action);
  size_t i, k;
  it.block_bytes = STEPS * sizes.block_bytes;
  it.blocks = malloc(it.block_bytes);
  for (i = 0; i < STEPS; ++i) {
    for (k = 0; k < sizes.actions; ++k) action[k] = (float)sin(0.7 * (double)i + (double)k);
    CHECK_OK(mimo_env_step(env, action, sizes.actions, it.blocks + i * sizes.block_bytes, sizes.block_bytes,
                           RESULTS(.reward = &it.rewards[i], .agent_count = 1)));
  }
  CHECK_OK(mimo_env_state_size(env, &it.state_bytes));
  it.state = malloc(it.state_bytes);
  CHECK_OK(mimo_env_state_save(env, it.state, it.state_bytes));
  free(action);
  return it;
}

static void forget(course* it) {
  free(it->blocks);
  free(it->state);
}

static int same(const course* a, const course* b) {
  return a->block_bytes == b->block_bytes && a->state_bytes == b->state_bytes &&
         memcmp(a->blocks, b->blocks, a->block_bytes) == 0 && memcmp(a->state, b->state, a->state_bytes) == 0 &&
         memcmp(a->rewards, b->rewards, sizeof a->rewards) == 0;
}

/* From now on both do the same to the bit. */
#define CHECK_ALIKE(a, b)                \
  do {                                   \
    course of_a = run(a), of_b = run(b); \
    CHECK(same(&of_a, &of_b));           \
    forget(&of_a);                       \
    forget(&of_b);                       \
  } while (0)

/* A life: to six months and back, each time like a world that was made so. */
static void check_that_a_world_ages_and_rejuvenates(void) {
  const mimo_growth six = aged(6), eighteen = aged(18);
  mimo_env *env = env_of(scene_with(NULL)), *young = env_of(scene_with(&six)), *usual = env_of(scene_with(NULL));
  const double mass = mass_of(env);
  CHECK(value_of(env, MIMO_AGENT_AGE) == 18 && value_of(env, MIMO_AGENT_PHYSIOLOGICAL_AGE) == 18);
  CHECK(value_of(young, MIMO_AGENT_AGE) == 6 && value_of(young, MIMO_AGENT_PHYSIOLOGICAL_AGE) == 6);
  CHECK(mass_of(young) < 0.9 * mass);

  mimo_reset_config config = *AGED(&six);
  config.seeded = 1;
  config.seed = 5;
  CHECK_OK(mimo_env_reset(env, &config, NULL, 0));
  CHECK_OK(mimo_env_reset(young, SEED(5), NULL, 0));
  CHECK(value_of(env, MIMO_AGENT_AGE) == 6);
  CHECK(mass_of(env) == mass_of(young));
  CHECK_ALIKE(env, young);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0)); /* stays so */
  CHECK_OK(mimo_env_reset(young, NULL, NULL, 0));
  CHECK_ALIKE(env, young);

  config.growth = (const mimo_growth* const[]){&eighteen};
  CHECK_OK(mimo_env_reset(env, &config, NULL, 0));
  CHECK_OK(mimo_env_reset(usual, SEED(5), NULL, 0));
  CHECK(mass_of(env) == mass && value_of(env, MIMO_AGENT_AGE) == 18);
  CHECK_ALIKE(env, usual);
  mimo_env_destroy(env);
  mimo_env_destroy(young);
  mimo_env_destroy(usual);
}

/* The block of the reset is the new world's. Without a seed, random numbers and the noise of episodes go on. */
static void check_that_random_numbers_go_on(void) {
  const mimo_growth six = aged(6);
  mimo_env *env = env_of(scene_with(NULL)), *young = env_of(scene_with(&six));
  const size_t bytes = sizes_of(env).block_bytes;
  uint8_t *first = malloc(bytes), *second = malloc(bytes);
  CHECK_OK(mimo_env_reset(env, SEED(9), NULL, 0));
  CHECK_OK(mimo_env_reset(young, SEED(9), NULL, 0));
  CHECK_OK(mimo_env_reset(env, AGED(&six), first, bytes));
  CHECK_OK(mimo_env_reset(young, NULL, second, bytes));
  CHECK(memcmp(first, second, bytes) == 0);
  CHECK_ALIKE(env, young);
  free(first);
  free(second);
  mimo_env_destroy(env);
  mimo_env_destroy(young);
}

/* Gravity and faces stay. What belonged to the other body is as in a new world. */
static void check_what_a_new_age_keeps(void) {
  const mimo_growth six = aged(6);
  const double moon[3] = {0, 0, -1.62}, sad = 2, heavy = 9, hue[4] = {1, 0, 0, 1};
  mimo_env *env = env_of(scene_with(NULL)), *young = env_of(scene_with(&six));
  const int32_t first = 0, head = find(env, MIMO_BODY, "head"), ball = 0;
  double now[4], fresh[4];
  CHECK_OK(mimo_env_set(env, MIMO_WORLD_GRAVITY, &first, 1, moon, 3));
  CHECK_OK(mimo_env_set(env, MIMO_AGENT_FACE, &first, 1, &sad, 1));
  CHECK_OK(mimo_env_set(env, MIMO_BODY_MASS, &head, 1, &heavy, 1));
  CHECK_OK(mimo_env_set(env, MIMO_GEOM_COLOR, &ball, 1, hue, 4));
  CHECK_OK(mimo_env_reset(env, AGED(&six), NULL, 0));
  CHECK_OK(mimo_env_get(env, MIMO_WORLD_GRAVITY, &first, 1, now, 3));
  CHECK(memcmp(now, moon, sizeof moon) == 0);
  CHECK(value_of(env, MIMO_AGENT_FACE) == sad);
  CHECK_OK(mimo_env_get(env, MIMO_BODY_MASS, &head, 1, now, 1));
  CHECK_OK(mimo_env_get(young, MIMO_BODY_MASS, &head, 1, fresh, 1));
  CHECK(now[0] == fresh[0]);
  CHECK_OK(mimo_env_get(env, MIMO_GEOM_COLOR, &ball, 1, now, 4));
  CHECK_OK(mimo_env_get(young, MIMO_GEOM_COLOR, &ball, 1, fresh, 4));
  CHECK(memcmp(now, fresh, sizeof now) == 0);
  mimo_env_destroy(env);
  mimo_env_destroy(young);
}

static mimo_status keep_still(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  (void)user, (void)env, (void)moment, (void)verdict;
  return MIMO_OK;
}

/* The one task function that fails where it finds an age that it does not like. */
static mimo_status adults_only(void* user, mimo_env* env, const mimo_task_moment* moment) {
  (void)moment;
  const double age = value_of(env, MIMO_AGENT_AGE);
  *(double*)user = age;
  return age < 12 ? mimo_fail(MIMO_E_INVALID_ARGUMENT, "too young") : MIMO_OK;
}

static void check_unchanged(mimo_env* env, mimo_status status, const char* part, const mimo_reset_config* config) {
  size_t bytes = 0;
  uint8_t *before, *after;
  const double mass = mass_of(env), age = value_of(env, MIMO_AGENT_AGE);
  CHECK_OK(mimo_env_state_size(env, &bytes));
  before = malloc(bytes);
  after = malloc(bytes);
  CHECK_OK(mimo_env_state_save(env, before, bytes));
  CHECK_FAILS(status, part, mimo_env_reset(env, config, NULL, 0));
  CHECK_OK(mimo_env_state_save(env, after, bytes));
  CHECK(memcmp(before, after, bytes) == 0);
  CHECK(mass_of(env) == mass && value_of(env, MIMO_AGENT_AGE) == age);
  free(before);
  free(after);
}

static void check_refused_ages(void) {
  const mimo_growth old = aged(24.5), six = aged(6);
  mimo_growth heavy = aged(6), newer = aged(6);
  mimo_env* env = env_of(scene_with(NULL));
  course ran = run(env);
  heavy.z_weight = 4;
  newer.struct_size = 4;
  check_unchanged(env, MIMO_E_INVALID_ARGUMENT, "age", AGED(&old));
  check_unchanged(env, MIMO_E_INVALID_ARGUMENT, "z_weight", AGED(&heavy));
  check_unchanged(env, MIMO_E_STRUCT_SIZE, "growth: struct_size is 4", AGED(&newer));
  check_unchanged(env, MIMO_E_INVALID_ARGUMENT, "growth_count is 2, expected 0, 1", AGED(&six, &six));
  check_unchanged(env, MIMO_E_INVALID_ARGUMENT, "growth is NULL", SIZED(mimo_reset_config, .growth_count = 1));
  CHECK_OK(mimo_env_reset(env, AGED(NULL), NULL, 0));
  CHECK(value_of(env, MIMO_AGENT_AGE) == 18);
  forget(&ran);
  mimo_env_destroy(env);
}

/* A task of the user's own sees the new world while it is reset; where it refuses that, the old one is back. */
static void check_that_own_tasks_see_the_new_world(void) {
  const mimo_growth six = aged(6), twenty = aged(20);
  mimo_scene* scene = scene_with(NULL);
  mimo_task task;
  double seen = 0;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.reset = adults_only;
  task.evaluate = keep_still;
  task.user = &seen;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  mimo_env* env = env_of(scene);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK(seen == 18);
  check_unchanged(env, MIMO_E_TASK, "too young", AGED(&six));
  CHECK(seen == 6);
  CHECK_OK(mimo_env_reset(env, AGED(&twenty), NULL, 0));
  CHECK(seen == 20 && value_of(env, MIMO_AGENT_AGE) == 20);
  mimo_env_destroy(env);
}

/* A newborn's nerves remember more than a toddler's: states of one batch differ in size, each in a row of its own. */
static void check_states_of_different_sizes(void) {
  mimo_growth toddler = aged(24), newborn = aged(0);
  const mimo_growth* const cohort[] = {&toddler, &newborn};
  const uint8_t second[] = {0, 1};
  mimo_scene* scene = scene_with(NULL);
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  mimo_env* worlds[2];
  size_t sizes[2], row = 0, i;
  uint8_t *states, *own, *later;
  toddler.maturity = newborn.maturity = MIMO_MATURITY_BODY | MIMO_MATURITY_DELAYS;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 2;
  config.cohort = cohort;
  config.cohort_count = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  for (i = 0; i < 2; ++i) {
    CHECK_OK(mimo_batch_world(batch, i, &worlds[i]));
    CHECK_OK(mimo_env_state_size(worlds[i], &sizes[i]));
  }
  CHECK_OK(mimo_batch_state_size(batch, &row));
  CHECK(sizes[0] < sizes[1] && row == sizes[1]);
  states = malloc(2 * row);
  own = malloc(row);
  later = malloc(2 * row);
  memset(states, 0xab, 2 * row);
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "states", mimo_batch_state_save(batch, NULL, 0, states, 2 * sizes[0]));
  CHECK(states[0] == 0xab);
  CHECK_OK(mimo_batch_state_save(batch, NULL, 0, states, 2 * row));
  for (i = 0; i < 2; ++i) {
    CHECK_OK(mimo_env_state_save(worlds[i], own, sizes[i]));
    CHECK(memcmp(states + i * row, own, sizes[i]) == 0);
  }
  for (i = sizes[0]; i < row; ++i) CHECK(states[i] == 0);
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_state_load(batch, NULL, 0, states, 2 * row, NULL));
  CHECK_OK(mimo_batch_state_save(batch, NULL, 0, later, 2 * row));
  CHECK(memcmp(later, states, 2 * row) == 0);

  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL)); /* rows that the mask leaves out are not looked at */
  memset(states, 0, row);
  CHECK_OK(mimo_batch_state_load(batch, second, 2, states, 2 * row, NULL));
  CHECK_OK(mimo_env_state_save(worlds[1], own, sizes[1]));
  CHECK(memcmp(own, later + row, sizes[1]) == 0);
  CHECK_OK(mimo_env_state_save(worlds[0], own, sizes[0]));
  CHECK(memcmp(own, later, sizes[0]) != 0);
  CHECK_FAILS(MIMO_E_FILE, "world 0: state", mimo_batch_state_load(batch, NULL, 0, states, 2 * row, NULL));
  memcpy(states, later, 2 * row); /* nothing but zeros follows a state, and no world loads where one cannot */
  states[row - 1] = 1;
  CHECK_FAILS(MIMO_E_FILE, "world 0: state: it has", mimo_batch_state_load(batch, NULL, 0, states, 2 * row, NULL));
  memcpy(states, later, 2 * row);
  states[row] ^= 1;
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_FILE, "world 1: state", mimo_batch_state_load(batch, NULL, 0, states, 2 * row, NULL));
  CHECK_OK(mimo_env_state_save(worlds[0], own, sizes[0]));
  CHECK(memcmp(own, later, sizes[0]) != 0);
  mimo_batch_destroy(batch);
  free(states);
  free(own);
  free(later);
}

static void check_other_agents_beside_infants(void) {
  const mimo_growth six = aged(6);
  const int32_t both[2] = {0, 1};
  double ages[2] = {0, 0};
  size_t width = 9;
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "free"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.name = "anna";
  agent.vision = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  agent.name = "thing";
  agent.body = "scene";
  agent.root = "anna/head";
  agent.touch = agent.vestibular = 0;
  agent.proprioception = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  mimo_env* env = env_of(scene);
  CHECK_OK(mimo_env_width(env, MIMO_AGENT_AGE, both, 2, &width));
  CHECK(width == 1);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "only infants grow", mimo_env_reset(env, AGED(&six, &six), NULL, 0));
  CHECK(value_of(env, MIMO_AGENT_AGE) == 18);
  CHECK_OK(mimo_env_reset(env, AGED(&six), NULL, 0)); /* all infants */
  CHECK_OK(mimo_env_get(env, MIMO_AGENT_AGE, both, 2, ages, 1));
  CHECK(ages[0] == 6);
  mimo_env_destroy(env);
}

static void check_two_infants_of_different_ages(void) {
  const mimo_growth two = aged(2), twenty = aged(20);
  const int32_t both[2] = {0, 1};
  double ages[2];
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  mimo_env* env = NULL;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "playdate"), &scene));
  CHECK_OK(mimo_scene_default_agent(scene, &agent, sizeof agent));
  agent.vision = 0;
  CHECK_OK(mimo_scene_add_agents(scene, &agent, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_reset(env, AGED(&two, &twenty), NULL, 0));
  CHECK_OK(mimo_env_reset(env, AGED(NULL, &two), NULL, 0));
  CHECK_OK(mimo_env_get(env, MIMO_AGENT_AGE, both, 2, ages, 2));
  CHECK(ages[0] == 2 && ages[1] == 2);
  CHECK_OK(mimo_env_reset(env, AGED(&twenty, NULL), NULL, 0));
  CHECK_OK(mimo_env_get(env, MIMO_AGENT_AGE, both, 2, ages, 2));
  CHECK(ages[0] == 20 && ages[1] == 2);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void read_receptors(const mimo_env* env, double* places, size_t count) {
  size_t field = 0;
  CHECK_OK(mimo_layout_find(layout_of(env), "touch/force", &field));
  CHECK_OK(mimo_layout_receptors(layout_of(env), field, MIMO_RECEPTOR_POSITION, places, count));
}

/* The layout is the same to the pointers; receptors are where they are on the new body. */
static void check_that_the_layout_stays(void) {
  const mimo_growth six = aged(6);
  mimo_env *env = env_of(scene_with(NULL)), *young = env_of(scene_with(&six));
  const mimo_layout* before = layout_of(env);
  const mimo_field field = field_of(env, "touch/force");
  const size_t count = 3 * field.receptors;
  double *places = malloc(count * sizeof *places), *expected = malloc(count * sizeof *places);
  CHECK(field_of(young, "touch/force").receptors == field.receptors);
  CHECK_OK(mimo_env_reset(env, AGED(&six), NULL, 0));
  CHECK(layout_of(env) == before);
  CHECK(field_of(env, "touch/force").name == field.name && strcmp(field.name, "touch/force") == 0);
  read_receptors(env, places, count);
  read_receptors(young, expected, count);
  CHECK(memcmp(places, expected, count * sizeof *places) == 0);
  mimo_env_destroy(young);
  free(places);
  free(expected);
  mimo_env_destroy(env);
}

static void check_states_across_ages(void) {
  const mimo_growth six = aged(6), eighteen = aged(18);
  mimo_env *env = env_of(scene_with(NULL)), *twin = NULL;
  course ran = run(env);
  CHECK_OK(mimo_env_reset(env, AGED(&six), NULL, 0));
  check_unchanged(env, MIMO_E_INVALID_ARGUMENT, "growth_count is 3", AGED(&six, &six, &six));
  CHECK_FAILS(MIMO_E_MISMATCH, "another age", mimo_env_state_load(env, ran.state, ran.state_bytes, NULL));
  CHECK_OK(mimo_env_clone(env, &twin));
  CHECK(value_of(twin, MIMO_AGENT_AGE) == 6);
  CHECK_ALIKE(env, twin);
  CHECK_OK(mimo_env_reset(env, AGED(&eighteen), NULL, 0));
  CHECK_OK(mimo_env_state_load(env, ran.state, ran.state_bytes, NULL));
  CHECK(value_of(twin, MIMO_AGENT_AGE) == 6); /* by itself */
  forget(&ran);
  mimo_env_destroy(env);
  mimo_env_destroy(twin);
}

static mimo_batch* batch_of(mimo_scene* scene, const mimo_growth* const* cohort, size_t count, uint32_t max_steps) {
  mimo_env_config env;
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  CHECK_OK(mimo_env_config_init(&env, sizeof env));
  env.max_steps = max_steps;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 2;
  config.autoreset = MIMO_AUTORESET_SAME_STEP;
  config.cohort = cohort;
  config.cohort_count = count;
  CHECK_OK(mimo_batch_create(scene, &env, &config, &batch));
  mimo_scene_destroy(scene);
  if (batch == NULL) exit(failures());
  return batch;
}

static mimo_env* view_of(mimo_batch* batch, size_t world) {
  mimo_env* view = NULL;
  CHECK_OK(mimo_batch_world(batch, world, &view));
  return view;
}

static void check_ages(const mimo_batch* batch, const double (*expected)[WORLDS]) {
  const int32_t first = 0;
  double ages[WORLDS];
  size_t i;
  CHECK_OK(mimo_batch_get(batch, MIMO_AGENT_AGE, &first, 1, NULL, 0, ages, WORLDS));
  for (i = 0; i < WORLDS; ++i) CHECK_NEAR((*expected)[i], ages[i], 0);
}

/* World i does what a single world of its age does. */
static void check_that_worlds_of_a_cohort_equal_single_ones(void) {
  const mimo_growth three = aged(3), twenty = aged(20);
  const mimo_growth* const cohort[] = {&three, NULL, &twenty};
  const uint64_t seeds[WORLDS] = {0, 1, 2, 3, 4, 5};
  mimo_batch* batch = batch_of(scene_with(NULL), cohort, 3, 0);
  size_t i;
  check_ages(batch, &(const double[WORLDS]){3, 18, 20, 3, 18, 20});
  CHECK_OK(mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = WORLDS), NULL, 0));
  for (i = 0; i < WORLDS; ++i) {
    mimo_env* single = env_of(scene_with(cohort[i % 3]));
    CHECK_OK(mimo_env_reset(single, SEED(seeds[i]), NULL, 0));
    CHECK(mass_of(view_of(batch, i)) == mass_of(single));
    CHECK(layout_of(view_of(batch, i)) == layout_of(view_of(batch, 0)));
    CHECK_ALIKE(view_of(batch, i), single);
    mimo_env_destroy(single);
  }
  mimo_batch_destroy(batch);
}

/* Views are of the world that is there; whoever ends an episode keeps the age. */
static void check_new_ages_within_a_batch(void) {
  const mimo_growth three = aged(3), twenty = aged(20), none = aged(-1);
  const mimo_growth* becoming[WORLDS] = {&three, NULL, &three, &twenty, &twenty, NULL};
  const uint8_t mask[WORLDS] = {1, 1, 0, 1, 1, 1};
  uint8_t was_reset[WORLDS];
  size_t i;
  mimo_batch* batch = batch_of(scene_with(NULL), NULL, 0, STEPS / 2);
  mimo_env *view = view_of(batch, 0), *young = env_of(scene_with(&three)), *twin = NULL;
  CHECK_OK(mimo_batch_reset(batch, SEEDS(.mask = mask, .worlds = WORLDS, .growth = becoming), NULL, 0));
  check_ages(batch, &(const double[WORLDS]){3, 18, 18, 20, 20, 18});
  CHECK(mass_of(view) == mass_of(young));
  for (i = 0; i < STEPS / 2; ++i) {
    CHECK_OK(
        mimo_batch_step(batch, NULL, 0, NULL, 0, SIZED(mimo_batch_results, .was_reset = was_reset, .worlds = WORLDS)));
  }
  CHECK(was_reset[0] && was_reset[1] && was_reset[5]);
  check_ages(batch, &(const double[WORLDS]){3, 18, 18, 20, 20, 18});
  becoming[1] = &none;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "age",
              mimo_batch_reset(batch, SEEDS(.worlds = WORLDS, .growth = becoming), NULL, 0));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "worlds is 0, expected 6",
              mimo_batch_reset(batch, SEEDS(.growth = becoming), NULL, 0));
  check_ages(batch, &(const double[WORLDS]){3, 18, 18, 20, 20, 18});
  CHECK_OK(mimo_env_reset(view, AGED(&twenty), NULL, 0));
  check_ages(batch, &(const double[WORLDS]){20, 18, 18, 20, 20, 18});
  CHECK(view == view_of(batch, 0));
  CHECK_OK(mimo_env_clone(view_of(batch, 3), &twin));
  CHECK(value_of(twin, MIMO_AGENT_AGE) == 20);
  mimo_env_destroy(twin);
  mimo_env_destroy(young);
  mimo_batch_destroy(batch);
}

static void check_refused_cohorts(void) {
  const mimo_growth six = aged(6), old = aged(25);
  const mimo_growth *const cohort[] = {&six, &six, &six}, *const wrong[] = {&six, &old};
  mimo_scene* scene = scene_with(NULL);
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 2;
  config.cohort = cohort;
  config.cohort_count = 3;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "cohort_count is 3, but there are 2 worlds",
              mimo_batch_create(scene, NULL, &config, &batch));
  config.cohort = wrong;
  config.cohort_count = 2;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "age", mimo_batch_create(scene, NULL, &config, &batch));
  config.cohort = NULL;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "cohort is NULL", mimo_batch_create(scene, NULL, &config, &batch));
  CHECK(batch == NULL);
  mimo_scene_destroy(scene);
}

/* A world's mass can be set at any age, and its state fits a world that was made at that age. */
static void check_writing_and_states_at_any_age(void) {
  const mimo_growth three = aged(3), twenty = aged(20);
  const mimo_growth* const cohort[] = {&three, NULL, &twenty};
  mimo_batch* batch = batch_of(scene_with(NULL), cohort, 3, 0);
  const double heavy = 4;
  size_t i;
  for (i = 0; i < 3; ++i) {
    mimo_env *view = view_of(batch, i), *single = env_of(scene_with(cohort[i]));
    const int32_t head = find(view, MIMO_BODY, "head");
    double mass = 0;
    course ran;
    CHECK_OK(mimo_env_set(view, MIMO_BODY_MASS, &head, 1, &heavy, 1));
    ran = run(view);
    CHECK_OK(mimo_env_state_load(single, ran.state, ran.state_bytes, NULL));
    CHECK_OK(mimo_env_get(single, MIMO_BODY_MASS, &head, 1, &mass, 1));
    CHECK(mass == heavy);
    CHECK_ALIKE(view, single);
    forget(&ran);
    mimo_env_destroy(single);
  }
  mimo_batch_destroy(batch);
}

/* A batch's bounds are wide enough for all: an action is where a joint goes, and newborns do not reach as far. */
static void check_that_bounds_hold_for_all_ages(void) {
  const mimo_growth born = aged(0), two = aged(24);
  const mimo_growth* const cohort[] = {&two, &born};
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  mimo_batch* batch;
  mimo_env* young = NULL;
  size_t i, count;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "free"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  agent.actuation = MIMO_ACTUATION_POSITION;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &young));
  batch = batch_of(scene, cohort, 2, 0);
  count = sizes_of(young).actions;
  CHECK_OK(mimo_env_reset(young, AGED(&born), NULL, 0));
  for (i = 0; i < count; ++i) {
    const mimo_action all = action_at(view_of(batch, 0), i), own = action_at(young, i);
    CHECK(all.low <= own.low && all.high >= own.high);
  }
  mimo_env_destroy(young);
  mimo_batch_destroy(batch);
}

/* As many ages as nobody keeps models for. */
static void check_more_ages_than_models_are_kept(void) {
  mimo_env* env = env_of(scene_with(NULL));
  double month;
  for (month = 0; month <= 24; month += 2) {
    const mimo_growth growth = aged(month);
    CHECK_OK(mimo_env_reset(env, AGED(&growth), NULL, 0));
    CHECK(value_of(env, MIMO_AGENT_AGE) == month);
    CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  }
  mimo_env_destroy(env);
}

int main(void) {
  check_that_a_world_ages_and_rejuvenates();
  check_that_random_numbers_go_on();
  check_what_a_new_age_keeps();
  check_refused_ages();
  check_that_own_tasks_see_the_new_world();
  check_states_of_different_sizes();
  check_other_agents_beside_infants();
  check_two_infants_of_different_ages();
  check_that_the_layout_stays();
  check_states_across_ages();
  check_that_worlds_of_a_cohort_equal_single_ones();
  check_new_ages_within_a_batch();
  check_refused_cohorts();
  check_writing_and_states_at_any_age();
  check_that_bounds_hold_for_all_ages();
  check_more_ages_than_models_are_kept();
  return failures();
}
