#include "worlds.h"

#include "repository_paths.h"

enum { WORLDS = 3, SEED_OF_ALL = 5 };

const char* const kept_names[] = {"free",      "reach",         "limited",    "standup",   "selfbody", "catch",
                                  "rollover",  "selftouch",     "handregard", "behaviour", "own_task", "muscle",
                                  "position",  "mujoco_muscle", "receptors",  "hearing",   "sight",    "two_infants",
                                  "overrides", "batch",         "attached",   NULL};

int wants_sizes, model_sizes[SIZES];

/* ---- Scenes and infants ----------------------------------------------------------------------------------- */

/* Where a host compiles its document, that names textures by paths. Elsewhere it also works where there are none. */
static mimo_scene* scene_of(const char* name, int for_hosts) {
  mimo_scene* scene = NULL;
  const char* models = for_hosts || wants_sizes ? MIMO_MODELS : NULL;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = name, .model_dir = models), &scene));
  return scene;
}

/* With an infant as the library has it by default, except that it sees nothing. */
static mimo_scene* free_infant(void) {
  mimo_scene* scene = scene_of("free", 0);
  mimo_agent_config infant;
  CHECK_OK(mimo_agent_config_init(&infant, sizeof infant));
  infant.vision = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  return scene;
}

/* The scene's infant, which sees nothing. */
static mimo_agent_config infant_of(const mimo_scene* scene) {
  mimo_agent_config infant;
  CHECK_OK(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.vision = 0;
  return infant;
}

static void keep_sizes(const mjModel* m) {
  const int sizes[SIZES] = {(int)m->nq,     (int)m->nv,     (int)m->nu,       (int)m->na,
                            (int)m->nbody,  (int)m->ngeom,  (int)m->neq,      (int)m->ntendon,
                            (int)m->nlight, (int)m->nmocap, (int)m->nuserdata};
  memcpy(model_sizes, sizes, sizeof sizes);
}

/* The model that a scene describes, as a host compiles it. */
static mjModel* model_of(const mimo_scene* scene) {
  static char xml[1 << 20];
  size_t length = 0;
  CHECK_OK(mimo_scene_xml(scene, xml, sizeof xml, &length));
  return host_model_of(xml, length);
}

static void look_up_sizes(const mimo_scene* scene) {
  mjModel* model;
  if (!wants_sizes) return;
  model = model_of(scene);
  keep_sizes(model);
  mj_deleteModel(model);
}

static mimo_env* env_of(mimo_scene* scene) {
  mimo_env* env = NULL;
  look_up_sizes(scene);
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  return env;
}

static mimo_env* env_with(mimo_scene* scene, const mimo_agent_config* infant) {
  CHECK_OK(mimo_scene_add_agent(scene, infant, NULL));
  return env_of(scene);
}

static mimo_growth aged(double months) {
  mimo_growth growth;
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.age = months;
  return growth;
}

/* Senses and left arm are late and noisy. */
static mimo_env* limited(void) {
  mimo_scene* scene = free_infant();
  mimo_limits limits;
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.delay = 0.05;
  limits.noise = 0.01;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "proprioception", &limits));
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "vestibular", &limits));
  CHECK_OK(mimo_scene_limit_motor(scene, 0, "left_arm", &limits));
  return env_of(scene);
}

/* Counts its steps, and asks for a random number in each. */
static mimo_status count(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  double number = 0;
  (void)user;
  if (mimo_env_random(env, &number, 1) != MIMO_OK) return MIMO_E_TASK;
  ((uint32_t*)moment->memory)[0] += 1;
  moment->fields[0] = (float)((uint32_t*)moment->memory)[0];
  verdict->reward = number;
  return MIMO_OK;
}

static mimo_env* own_task(void) {
  mimo_scene* scene = free_infant();
  mimo_task task;
  mimo_task_field field;
  CHECK_OK(mimo_task_field_init(&field, sizeof field));
  field.name = "count";
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = count;
  task.memory_bytes = 12;
  task.fields = &field;
  task.field_count = 1;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  return env_of(scene);
}

mimo_env* world_of_task(const char* task) {
  const char *name, *has = "";
  size_t i;
  if (strcmp(task, "custom") == 0) return own_task();
  if (strcmp(task, "none") == 0) return env_of(free_infant());
  for (i = 0; (name = mimo_scene_name(i)) != NULL; ++i) {
    mimo_scene* scene = scene_of(name, 0);
    const mimo_agent_config infant = infant_of(scene);
    mimo_env* env = NULL;
    CHECK_OK(mimo_scene_add_agents(scene, &infant, NULL));
    env = env_of(scene);
    CHECK_OK(mimo_env_task(env, &has));
    if (strcmp(has, task) == 0) return env;
    mimo_env_destroy(env);
  }
  return NULL;
}

mimo_env* world_of_actuation(int32_t actuation) {
  mimo_scene* scene = scene_of("free", 0);
  mimo_agent_config infant = infant_of(scene);
  infant.actuation = actuation;
  if (mimo_scene_add_agent(scene, &infant, NULL) == MIMO_OK) return env_of(scene);
  mimo_scene_destroy(scene);
  return NULL;
}

/* The bits of a member that the library takes. */
static void accept(mimo_agent_config* infant, uint32_t* member) {
  int bit;
  for (bit = 0; bit < 30; ++bit) {
    const uint32_t before = *member;
    mimo_scene* scene = scene_of("free", 0);
    *member |= (uint32_t)1 << bit;
    if (mimo_scene_add_agent(scene, infant, NULL) != MIMO_OK) *member = before;
    mimo_scene_destroy(scene);
  }
}

/* With few sensors, so that the state is short, and with fingers, which grasp by reflex. */
static void give_receptors(mimo_agent_config* infant) {
  infant->body = "fingers";
  infant->touch = 0;
  infant->touch_scale = 0.1;
  accept(infant, &infant->touch);
  accept(infant, &infant->proprioception);
  accept(infant, &infant->vestibular);
  accept(infant, &infant->reflexes);
}

static mimo_env* receptors(void) {
  mimo_scene* scene = scene_of("free", 0);
  mimo_agent_config infant = infant_of(scene);
  give_receptors(&infant);
  return env_with(scene, &infant);
}

/* Room for one sound, which still plays when the state is saved. */
static mimo_scene* with_little_sound(const char* name) {
  mimo_scene* scene = scene_of(name, 0);
  CHECK_OK(mimo_scene_set_sources(scene, 1, 0.4));
  return scene;
}

static mimo_env* hearing(void) {
  mimo_scene* scene = with_little_sound("free");
  mimo_agent_config infant = infant_of(scene);
  enum { SAMPLES = 6400 };
  static float samples[SAMPLES];
  int i;
  mimo_env* env;
  accept(&infant, &infant.hearing);
  env = env_with(scene, &infant);
  for (i = 0; i < SAMPLES; ++i) samples[i] = (float)((i % 16) - 8) / 400.0f;
  CHECK_OK(mimo_env_reset(env, SEED(SEED_OF_ALL), NULL, 0));
  CHECK_OK(mimo_env_play(env, "left_hand", samples, SAMPLES, 16000));
  return env;
}

/* Small pictures through the eyes of a month, which flicker slowly, on nerves of a month. */
static void give_eyes(mimo_agent_config* infant, mimo_growth* month) {
  *month = aged(1);
  month->maturity = MIMO_MATURITY_ALL;
  infant->growth = month;
  infant->vision = MIMO_VISION_RGB;
  infant->vision_width = infant->vision_height = 8;
}

static mimo_env* sight(void) {
  mimo_scene* scene = scene_of("free", 0);
  mimo_agent_config infant = infant_of(scene);
  mimo_growth month;
  give_eyes(&infant, &month);
  infant.touch = 0;
  return env_with(scene, &infant);
}

mimo_env* everything(void) {
  mimo_scene* scene = with_little_sound("free");
  mimo_agent_config infant = infant_of(scene);
  mimo_growth month;
  mimo_limits limits;
  give_receptors(&infant);
  accept(&infant, &infant.hearing);
  give_eyes(&infant, &month);
  accept(&infant, &infant.vision);
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.delay = 0.05;
  CHECK_OK(mimo_scene_limit_motor(scene, 0, "", &limits));
  return env_of(scene);
}

static mimo_env* two_infants(void) {
  mimo_scene* scene = scene_of("playdate", 0);
  mimo_agent_config infant = infant_of(scene);
  const mimo_growth young = aged(3), old = aged(12.5);
  infant.name = "anna";
  infant.growth = &young;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  infant.name = "ben";
  infant.growth = &old;
  infant.actuation = MIMO_ACTUATION_POSITION;
  return env_with(scene, &infant);
}

static void set(mimo_env* env, int32_t quantity, const char* name, const double* values, size_t count) {
  const int32_t id = name == NULL ? 0 : find(env, quantity >> 8, name);
  CHECK_OK(mimo_env_set(env, quantity, &id, 1, values, count));
}

/* What worlds of one model may differ in. */
static mimo_env* overrides(void) {
  static const double gravity[] = {0, 1, -5}, color[] = {0.2, 0.3, 0.4, 0.5}, lock[] = {1, -0.5},
                      slippery[] = {0.1, 0, 0};
  static const double two = 2, gear = 3, damping = 0.7, face = 2;
  mimo_env* env = env_of(free_infant());
  set(env, MIMO_WORLD_GRAVITY, NULL, gravity, 3);
  set(env, MIMO_BODY_MASS, "head", &two, 1);
  set(env, MIMO_GEOM_COLOR, "head", color, 4);
  set(env, MIMO_GEOM_FRICTION, "head", slippery, 3);
  set(env, MIMO_JOINT_LOCK, "robot:left_elbow", lock, 2);
  set(env, MIMO_JOINT_DAMPING, "robot:right_elbow", &damping, 1);
  set(env, MIMO_ACTUATOR_GEAR, "act:right_elbow", &gear, 1);
  set(env, MIMO_AGENT_FACE, NULL, &face, 1);
  return env;
}

static mimo_env* single(const char* name) {
  if (strcmp(name, "free") == 0) return env_of(free_infant());
  if (strcmp(name, "limited") == 0) return limited();
  if (strcmp(name, "own_task") == 0) return own_task();
  if (strcmp(name, "muscle") == 0) return world_of_actuation(MIMO_ACTUATION_MUSCLE);
  if (strcmp(name, "position") == 0) return world_of_actuation(MIMO_ACTUATION_POSITION);
  if (strcmp(name, "mujoco_muscle") == 0) return world_of_actuation(MIMO_ACTUATION_MUJOCO_MUSCLE);
  if (strcmp(name, "receptors") == 0) return receptors();
  if (strcmp(name, "hearing") == 0) return hearing();
  if (strcmp(name, "sight") == 0) return sight();
  if (strcmp(name, "two_infants") == 0) return two_infants();
  if (strcmp(name, "overrides") == 0) return overrides();
  return world_of_task(name);
}

/* ---- Owners ----------------------------------------------------------------------------------------------- */

/* Worlds of three ages, whose states differ in length: nerves of newborns keep values for longer. */
static mimo_batch* batch_of_ages(void) {
  mimo_scene* scene = scene_of("free", 0);
  mimo_agent_config infant = infant_of(scene);
  mimo_growth ages[WORLDS] = {aged(0), aged(6), aged(18)};
  const mimo_growth* cohort[WORLDS];
  const uint64_t seeds[WORLDS] = {SEED_OF_ALL, SEED_OF_ALL + 1, SEED_OF_ALL + 2};
  mimo_batch_config config;
  mimo_batch_reset_config start = {.struct_size = sizeof start, .seeds = seeds, .worlds = WORLDS};
  mimo_batch* batch = NULL;
  int i;
  for (i = 0; i < WORLDS; ++i) {
    ages[i].maturity = MIMO_MATURITY_BODY | MIMO_MATURITY_DELAYS;
    cohort[i] = &ages[i];
  }
  infant.touch = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.cohort = cohort;
  config.cohort_count = WORLDS;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  look_up_sizes(scene);
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_batch_reset(batch, &start, NULL, 0));
  return batch;
}

/* A host that simulates the scene itself, with receptors and a delay. */
static owner attached(void) {
  owner it = {0};
  mimo_scene* scene = scene_of("free", 1);
  mimo_agent_config infant = infant_of(scene);
  mimo_senses_config config;
  mimo_limits limits;
  infant.touch = MIMO_TOUCH_FORCE | MIMO_TOUCH_SA1;
  infant.touch_scale = 0.1;
  infant.vestibular |= MIMO_VESTIBULAR_CANALS;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.delay = 0.05;
  limits.noise = 0.01;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "vestibular", &limits));
  it.model = model_of(scene);
  keep_sizes(it.model);
  it.data = mj_makeData(it.model);
  if (it.model->nkey > 0) mj_resetDataKeyframe(it.model, it.data, 0);
  mj_forward(it.model, it.data);
  CHECK_OK(mimo_senses_config_init(&config, sizeof config));
  config.mujoco_version = mj_version();
  CHECK_OK(mimo_senses_attach(scene, it.model, &config, &it.senses));
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_senses_reset(it.senses, it.data, SEED(SEED_OF_ALL)));
  return it;
}

owner make_owner(const char* name) {
  owner it = {0};
  if (strcmp(name, "attached") == 0) return attached();
  if (strcmp(name, "batch") == 0) {
    it.batch = batch_of_ages();
    return it;
  }
  it.env = single(name);
  if (it.env == NULL) exit(1);
  if (strcmp(name, "hearing") != 0) CHECK_OK(mimo_env_reset(it.env, SEED(SEED_OF_ALL), NULL, 0));
  return it;
}

void free_owner(owner* it) {
  mimo_env_destroy(it->env);
  mimo_batch_destroy(it->batch);
  mimo_senses_destroy(it->senses);
  if (it->data != NULL) mj_deleteData(it->data);
  if (it->model != NULL) mj_deleteModel(it->model);
}

static mimo_layout_info info_of(const owner* it) {
  const mimo_layout* layout = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  if (it->env != NULL) CHECK_OK(mimo_env_layout(it->env, &layout));
  if (it->batch != NULL) CHECK_OK(mimo_batch_layout(it->batch, &layout));
  if (it->senses != NULL) CHECK_OK(mimo_senses_layout(it->senses, &layout));
  CHECK_OK(mimo_layout_describe(layout, &info));
  return info;
}

void go_on(owner* it, int steps) {
  static float action[WORLDS * 512];
  const size_t worlds = it->batch == NULL ? 1 : WORLDS, actions = worlds * info_of(it).actions;
  size_t i;
  CHECK(actions <= sizeof action / sizeof *action);
  while (steps-- > 0) {
    for (i = 0; i < actions; ++i) action[i] = 0.3f * (float)((int)(i * 7 + (size_t)steps * 3) % 5 - 2);
    if (it->env != NULL) CHECK_OK(mimo_env_step(it->env, action, actions, NULL, 0, NULL));
    if (it->batch != NULL) CHECK_OK(mimo_batch_step(it->batch, action, actions, NULL, 0, NULL));
    if (it->senses == NULL) continue;
    mj_step(it->model, it->data);
    CHECK_OK(mimo_senses_advance(it->senses, it->data));
  }
}

size_t state_size(const owner* it) {
  size_t bytes = 0;
  if (it->env != NULL) CHECK_OK(mimo_env_state_size(it->env, &bytes));
  if (it->batch != NULL) CHECK_OK(mimo_batch_state_size(it->batch, &bytes));
  if (it->senses != NULL) CHECK_OK(mimo_senses_state_size(it->senses, &bytes));
  return it->batch == NULL ? bytes : bytes * WORLDS;
}

void save_state(owner* it, uint8_t* state, size_t bytes) {
  if (it->env != NULL) CHECK_OK(mimo_env_state_save(it->env, state, bytes));
  if (it->batch != NULL) CHECK_OK(mimo_batch_state_save(it->batch, NULL, 0, state, bytes));
  if (it->senses != NULL) CHECK_OK(mimo_senses_state_save(it->senses, state, bytes));
}

mimo_status load_state(owner* it, const uint8_t* state, size_t bytes, mimo_load_report* report) {
  if (it->env != NULL) return mimo_env_state_load(it->env, state, bytes, report);
  if (it->batch != NULL) return mimo_batch_state_load(it->batch, NULL, 0, state, bytes, report);
  return mimo_senses_state_load(it->senses, state, bytes, report);
}

/* ---- Looking ---------------------------------------------------------------------------------------------- */

static double sum_of_field(const mimo_field* field, const uint8_t* block) {
  const size_t sizes[] = {0, 1, 4, 4, 8}, each = sizes[field->dtype];
  double sum = 0, real;
  int32_t whole;
  float single;
  size_t i;
  for (i = 0; i < field->bytes / each; ++i) {
    const uint8_t* at = block + field->offset + i * each;
    switch (field->dtype) {
      case MIMO_U8: real = *at; break;
      case MIMO_I32: memcpy(&whole, at, sizeof whole), real = whole; break;
      case MIMO_F32: memcpy(&single, at, sizeof single), real = (double)single; break;
      default: memcpy(&real, at, sizeof real); break;
    }
    sum += fabs(real);
  }
  return sum;
}

static double sum_of(const mimo_layout* layout, const uint8_t* block) {
  mimo_layout_info info = {.struct_size = sizeof info};
  double sum = 0;
  size_t i;
  CHECK_OK(mimo_layout_describe(layout, &info));
  for (i = 0; i < info.fields; ++i) {
    const mimo_field field = field_at(layout, i);
    sum += sum_of_field(&field, block);
  }
  return sum;
}

static size_t look_at_world(mimo_env* env, double* numbers, size_t room) {
  const size_t bytes = sizes_of(env).block_bytes;
  uint8_t* block = malloc(bytes);
  size_t width = 0;
  CHECK_OK(mimo_env_width(env, MIMO_JOINT_POSITION, NULL, 0, &width));
  CHECK(width + 2 <= room);
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, NULL, 0, numbers, width));
  CHECK_OK(mimo_env_time(env, &numbers[width]));
  CHECK_OK(mimo_env_observe(env, block, bytes));
  numbers[width + 1] = sum_of(layout_of(env), block);
  free(block);
  return width + 2;
}

static size_t look_at_host(const owner* it, double* numbers, size_t room) {
  const mimo_layout* layout = NULL;
  const size_t bytes = info_of(it).block_bytes, width = (size_t)it->model->nq;
  uint8_t* block = malloc(bytes);
  CHECK(width + 2 <= room);
  memcpy(numbers, it->data->qpos, width * sizeof *numbers);
  numbers[width] = it->data->time;
  CHECK_OK(mimo_senses_layout(it->senses, &layout));
  CHECK_OK(mimo_senses_observe(it->senses, it->data, block, bytes));
  numbers[width + 1] = sum_of(layout, block);
  free(block);
  return width + 2;
}

size_t look(owner* it, double* numbers, size_t room) {
  size_t count = 0, i;
  if (it->senses != NULL) return look_at_host(it, numbers, room);
  if (it->env != NULL) return look_at_world(it->env, numbers, room);
  for (i = 0; i < WORLDS; ++i) {
    mimo_env* world = NULL;
    CHECK_OK(mimo_batch_world(it->batch, i, &world));
    count += look_at_world(world, numbers + count, room - count);
  }
  return count;
}
