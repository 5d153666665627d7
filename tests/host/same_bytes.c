/* The host simulates MIMo's own scene with its own MuJoCo: attached senses give exactly the bytes of an environment,
 * also where they are late, noisy and weak. */

#include "repository_paths.h"
#include "support/mujoco.h"

enum { STEPS = 120, FRAME_SKIP = 2 };

static float random_share(uint32_t* state) {
  *state = *state * 1664525u + 1013904223u;
  return (float)(*state >> 8) / 16777216.0f;
}

/* An infant that senses all that there is, with a second vestibular organ by another agent in its trunk. */
static void request(mimo_scene* scene, const char* name, int32_t quantity, const char* element, const char* body) {
  mimo_field_config config;
  CHECK_OK(mimo_field_config_init(&config, sizeof config));
  config.name = name;
  config.quantity = quantity;
  config.elements = &element;
  config.element_count = 1;
  config.relative_to = body;
  CHECK_OK(mimo_scene_add_field(scene, &config));
}

static mimo_scene* make_scene(const char* name, uint32_t vision) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_camera_config camera;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = name;
  room.model_dir = MIMO_MODELS; /* so that the document names its textures by their paths */
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.name = "anna";
  agent.proprioception |= MIMO_PROPRIOCEPTION_JOINT_TORQUE; /* all but the effort of commands, which the host gives */
  agent.touch = MIMO_TOUCH_FORCE | MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE;
  agent.vision = vision;
  agent.vision_width = agent.vision_height = 32;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.name = "trunk";
  agent.body = "scene";
  agent.root = "anna/upper_body";
  agent.vestibular_at = "anna/upper_body";
  agent.acts = MIMO_ACT_NONE;
  agent.touch = agent.vision = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_camera_config_init(&camera, sizeof camera));
  camera.name = "door";
  camera.placed = 1;
  camera.outputs = MIMO_VISION_DEPTH;
  camera.width = camera.height = 16;
  if (vision != 0) CHECK_OK(mimo_scene_add_camera(scene, &camera));
  request(scene, "hand/now", MIMO_BODY_POSE | MIMO_NOW, "anna/left_hand", "anna/head");
  request(scene, "hand/velocity", MIMO_BODY_VELOCITY, "anna/left_hand", "anna/head");
  request(scene, "elbow", MIMO_JOINT_VELOCITY, "anna/robot:left_elbow", NULL);
  return scene;
}

static mjModel* load(const mimo_scene* scene) {
  static char xml[1 << 20];
  size_t length = 0;
  CHECK_OK(mimo_scene_xml(scene, xml, sizeof xml, &length));
  return host_model_of(xml, length);
}

static uint8_t* new_block(size_t bytes) {
  uint8_t* block = malloc(bytes);
  if (block == NULL) exit(1);
  memset(block, 0xa5, bytes);
  return block;
}

/* Every limit that there is, on senses of all kinds. */
static void limit(mimo_scene* scene) {
  static const struct {
    const char* path;
    double delay, gain, noise, blur;
  } all[] = {{"proprioception", 0.05, 0.9, 0.02, 0},
             {"proprioception/velocity", 0, 1, 0.1, 0},
             {"touch", 0.12, 1, 0.5, 0},
             {"vestibular", 0.01, 1, 0, 0},
             {"vision", 0.03, 0.8, 4, 1}};
  const size_t count = sizeof all / sizeof *all;
  mimo_limits limits;
  size_t i;
  for (i = 0; i < count; ++i) {
    CHECK_OK(mimo_limits_init(&limits, sizeof limits));
    limits.delay = all[i].delay;
    limits.gain = all[i].gain;
    limits.noise = all[i].noise;
    limits.blur = all[i].blur;
    if (i + 1 < count) CHECK_OK(mimo_scene_limit_sense(scene, 0, all[i].path, &limits));
    if (i + 1 == count) CHECK_OK(mimo_scene_limit_sense(scene, 0, "vision/eye_left", &limits));
  }
}

/* Which field differs, for people. */
static void compare(const mimo_env* env, const uint8_t* expected, const uint8_t* actual, int step) {
  const size_t bytes = sizes_of(env).block_bytes, fields = sizes_of(env).fields;
  size_t i;
  if (memcmp(expected, actual, bytes) == 0) return;
  for (i = 0; i < fields; ++i) {
    const mimo_field field = field_at(layout_of(env), i);
    if (memcmp(expected + field.offset, actual + field.offset, field.bytes) == 0) continue;
    fprintf(stderr, "step %d: %s\n", step, field.name);
    check(0, "a field differs", __LINE__);
  }
}

static void check_layouts(const mimo_env* env, const mimo_senses* senses) {
  const mimo_layout *worlds = layout_of(env), *own = NULL;
  const mimo_layout_info sizes = sizes_of(env);
  mimo_layout_info own_sizes = {.struct_size = sizeof own_sizes};
  size_t i;
  CHECK_OK(mimo_senses_layout(senses, &own));
  CHECK_OK(mimo_layout_describe(own, &own_sizes));
  CHECK(sizes.block_bytes == own_sizes.block_bytes && sizes.fields == own_sizes.fields && sizes.fields > 10);
  for (i = 0; i < sizes.fields; ++i) {
    const mimo_field a = field_at(worlds, i), b = field_at(own, i);
    const char *label_a = NULL, *label_b = NULL;
    CHECK_TEXT(a.name, b.name);
    CHECK(a.offset == b.offset && a.bytes == b.bytes && a.dtype == b.dtype && a.receptors == b.receptors);
    CHECK(a.start == b.start && a.end == b.end && a.period == b.period);
    CHECK_OK(mimo_layout_label(worlds, i, 0, &label_a));
    CHECK_OK(mimo_layout_label(own, i, 0, &label_b));
    CHECK_TEXT(label_a, label_b);
  }
}

/* Other senses that have loaded what these remember, as in another process. */
static mimo_senses* moved(const mimo_scene* scene, const mjModel* model, const mimo_senses_config* config,
                          mimo_senses* senses) {
  mimo_senses* twin = NULL;
  mimo_load_report report;
  size_t bytes = 0, again = 0;
  uint8_t* state;
  CHECK_OK(mimo_senses_attach(scene, model, config, &twin));
  CHECK_OK(mimo_senses_state_size(senses, &bytes));
  CHECK_OK(mimo_senses_state_size(twin, &again));
  CHECK(bytes == again);
  state = new_block(bytes);
  CHECK_OK(mimo_senses_state_save(senses, state, bytes));
  report.struct_size = sizeof report;
  ++state[8]; /* its version: of a newer library */
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "needs a newer library", mimo_senses_state_load(twin, state, bytes, &report));
  --state[8];
  CHECK_OK(mimo_senses_state_load(twin, state, bytes, &report));
  CHECK(report.fresh == 0 && report.ignored == 0);
  CHECK_TEXT("", report.fresh_names);
  mimo_senses_destroy(senses);
  free(state);
  return twin;
}

static void run(const char* name, uint32_t vision, int limited) {
  mimo_scene* scene = make_scene(name, vision);
  mimo_env_config config;
  mimo_senses_config attached;
  mimo_env* env = NULL;
  mimo_senses* senses = NULL;
  mjModel* model = load(scene);
  mjData* data = mj_makeData(model);
  mjData* other = mj_makeData(model);
  float low[64], high[64], action[64];
  size_t bytes = 0, actions = 0, i;
  uint32_t random = 7;
  uint8_t *expected, *actual, *before;
  int step, changed = 0, pressed = 0;
  if (limited) limit(scene);
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.disable = MIMO_DISABLE_OWN_SOLVER; /* the host calls mj_step */
  config.frame_skip = FRAME_SKIP;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  CHECK_OK(mimo_senses_config_init(&attached, sizeof attached));
  attached.mujoco_version = mj_version();
  attached.model_size = sizeof(mjModel);
  attached.data_size = sizeof(mjData);
  attached.step = FRAME_SKIP * model->opt.timestep;
  CHECK_OK(mimo_senses_attach(scene, model, &attached, &senses));
  if (env == NULL || senses == NULL) exit(failures());
  check_layouts(env, senses);
  bytes = sizes_of(env).block_bytes;
  actions = sizes_of(env).actions;
  CHECK(actions <= 64);
  for (i = 0; i < actions; ++i) {
    low[i] = (float)action_at(env, i).low;
    high[i] = (float)action_at(env, i).high;
  }
  expected = new_block(bytes);
  actual = new_block(bytes);
  before = new_block((size_t)data->nbuffer);
  CHECK_OK(mimo_env_reset(env, SEED(11), expected, bytes));
  mj_forward(model, data);
  CHECK_OK(mimo_senses_reset(senses, data, SEED(11)));
  CHECK_OK(mimo_senses_observe(senses, data, actual, bytes));
  compare(env, expected, actual, -1);
  for (step = 0; step < STEPS; ++step) {
    for (i = 0; i < actions; ++i) action[i] = low[i] + random_share(&random) * (high[i] - low[i]);
    CHECK_OK(mimo_env_step(env, action, actions, expected, bytes, NULL));
    CHECK((size_t)model->nu == actions);
    for (i = 0; i < actions; ++i) data->ctrl[i] = (double)action[i];
    for (i = 0; i < FRAME_SKIP; ++i) mj_step(model, data);
    memcpy(before, data->buffer, (size_t)data->nbuffer);
    CHECK_OK(mimo_senses_advance(senses, data));
    CHECK_OK(mimo_senses_observe(senses, data, actual, bytes));
    changed += memcmp(before, data->buffer, (size_t)data->nbuffer) != 0;
    compare(env, expected, actual, step);
    pressed += data->ncon > 0;
    if (step == STEPS / 2) senses = moved(scene, model, &attached, senses);
    /* The same senses look at other data in between, and see that. */
    if (step % 40 == 39) {
      mj_forward(model, other);
      CHECK_OK(mimo_senses_observe(senses, other, actual, bytes));
      CHECK(memcmp(expected, actual, bytes) != 0);
    }
  }
  CHECK(changed == 0);
  CHECK(pressed > 0);
  mimo_scene_destroy(scene);
  mimo_senses_destroy(senses);
  mimo_env_destroy(env);
  mj_deleteData(data);
  mj_deleteData(other);
  mj_deleteModel(model);
  free(expected);
  free(actual);
  free(before);
}

int main(void) {
  run("benchmark", MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION, 0);
  run("free", 0, 0);
  run("free", MIMO_VISION_RGB | MIMO_VISION_DEPTH, 1);
  return failures();
}
