/* Requested fields: their values, times and frames of reference, and what is refused. */
#include "support/capi.h"

static const double kTimestep = 0.005, kSpin = 2, kGravity = 9.81;

/* A table that turns about the vertical through (1, 0, 0), a mark half a metre beside it that stands still, a ball that
 * falls, and a slide; a sensor for how fast the table turns. An environment step has two physics steps of 5 ms. */
static const char kModel[] =
    "<mujoco><option timestep='0.005'/><worldbody>"
    "<site name='mark' pos='1.5 0 0'/><site name='centre'/>"
    "<body name='table' pos='1 0 0'><joint name='turn' axis='0 0 1'/><geom size='0.1'/></body>"
    "<body name='ball' pos='0 0 2'><freejoint name='ball'/><geom size='0.1'/></body>"
    "<body name='cart' pos='0 3 0'><joint name='slide' type='slide' axis='1 0 0'/><geom size='0.1'/></body>"
    "</worldbody><sensor><jointvel name='speed' joint='turn'/></sensor></mujoco>";

static mimo_scene* scene_of(const char* xml) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.xml = xml;
  CHECK_OK(mimo_scene_create(&config, &scene));
  return scene;
}

static mimo_field_config field_for(const char* name, int32_t quantity, const char* const* elements, size_t count,
                                   const char* relative_to) {
  mimo_field_config config;
  CHECK_OK(mimo_field_config_init(&config, sizeof config));
  CHECK(config.quantity == MIMO_BODY_POSITION && config.name == NULL && config.element_count == 0);
  config.name = name;
  config.quantity = quantity;
  config.elements = elements;
  config.element_count = count;
  config.relative_to = relative_to;
  return config;
}

static void add(mimo_scene* scene, const char* name, int32_t quantity, const char* element, const char* relative_to) {
  const mimo_field_config config = field_for(name, quantity, &element, 1, relative_to);
  CHECK_OK(mimo_scene_add_field(scene, &config));
}

static mimo_env* env_of(mimo_scene* scene) {
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static float block[1 << 16];

static const float* values(const mimo_env* env, const char* name) {
  return (const float*)(const void*)((const char*)block + field_of(env, name).offset);
}

static void reset(mimo_env* env, uint64_t seed) { CHECK_OK(mimo_env_reset(env, SEED(seed), block, sizeof block)); }

static void step(mimo_env* env) { CHECK_OK(mimo_env_step(env, NULL, 0, block, sizeof block, NULL)); }

static void check_values(const mimo_env* env, const char* name, const double* expected, size_t count) {
  const float* actual = values(env, name);
  size_t i;
  CHECK(field_of(env, name).bytes == count * sizeof(float));
  for (i = 0; i < count; ++i) {
    if (fabs((double)actual[i] - expected[i]) <= 2e-6) continue;
    check(0, name, __LINE__);
    fprintf(stderr, "  [%zu] is %.9g, expected %.9g\n", i, (double)actual[i], expected[i]);
  }
}

/* In n physics steps of h a ball falls by g h^2 n (n + 1) / 2. */
static double height_after(double n) { return 2 - kGravity * kTimestep * kTimestep * n * (n + 1) / 2; }

/* How the mark is seen from the table when that has turned by an angle, as a rotating frame sees what stands still. */
static void check_seen(const mimo_env* env, const char* position, const char* velocity, double angle) {
  const double c = 0.5 * cos(angle), s = 0.5 * sin(angle);
  const double place[3] = {c, -s, 0}, motion[6] = {-kSpin * s, -kSpin * c, 0, 0, 0, -kSpin};
  check_values(env, position, place, 3);
  check_values(env, velocity, motion, 6);
}

static void check_when_requested_fields_are_true(void) {
  static const char* const both[] = {"turn", "slide"};
  mimo_scene* scene = scene_of(kModel);
  const mimo_field_config joints = field_for("joints", MIMO_JOINT_POSITION, both, 2, NULL);
  mimo_env* env;
  int32_t turn, n;
  add(scene, "then", MIMO_BODY_POSITION, "ball", NULL);
  add(scene, "now", MIMO_BODY_POSITION | MIMO_NOW, "ball", NULL);
  add(scene, "seen/then", MIMO_SITE_POSITION, "mark", "table");
  add(scene, "seen/now", MIMO_SITE_POSITION | MIMO_NOW, "mark", "table");
  add(scene, "moves/then", MIMO_SITE_VELOCITY, "mark", "table");
  add(scene, "moves/now", MIMO_SITE_VELOCITY | MIMO_NOW, "mark", "table");
  add(scene, "turned", MIMO_SITE_POSE | MIMO_NOW, "mark", "table");
  add(scene, "speed", MIMO_SENSOR_VALUE, "speed", NULL);
  CHECK_OK(mimo_scene_add_field(scene, &joints));
  env = env_of(scene);
  turn = find(env, MIMO_JOINT, "turn");
  reset(env, 1);
  CHECK_OK(mimo_env_set(env, MIMO_JOINT_VELOCITY, &turn, 1, &kSpin, 1));
  for (n = 2; n <= 40; n += 2) { /* physics steps */
    const double now = kSpin * kTimestep * n, then = now - kSpin * kTimestep;
    const double fallen[3] = {0, 0, height_after(n)}, before[3] = {0, 0, height_after(n - 1)};
    const double pose[7] = {0.5 * cos(now), -0.5 * sin(now), 0, cos(now / 2), 0, 0, -sin(now / 2)};
    const double angles[2] = {now, 0};
    step(env);
    check_values(env, "now", fallen, 3);
    check_values(env, "then", before, 3);
    check_seen(env, "seen/now", "moves/now", now);
    check_seen(env, "seen/then", "moves/then", then);
    check_values(env, "turned", pose, 7);
    check_values(env, "speed", &kSpin, 1);
    check_values(env, "joints", angles, 2);
  }
  mimo_env_destroy(env);
}

static void check_times_of(const mimo_env* env, const char* name, double time) {
  const mimo_field field = field_of(env, name);
  CHECK(field.start == time && field.end == time && field.period == 2 * kTimestep && field.receptors == 0);
  CHECK(field.dtype == MIMO_F32 && isinf(field.low) && isinf(field.high));
}

static void check_descriptions_of_requested_fields(void) {
  static const char* const mixed[] = {"turn", "ball"};
  static const char* const hinge[] = {"turn"};
  static const char* const bodies[] = {"ball", "cart"};
  mimo_scene* scene = scene_of(kModel);
  const mimo_field_config fields[] = {
      field_for("mixed", MIMO_JOINT_POSITION, mixed, 2, NULL), field_for("hinge", MIMO_JOINT_POSITION, hinge, 1, NULL),
      field_for("toys", MIMO_BODY_POSITION, bodies, 2, "table"), field_for("mass", MIMO_BODY_MASS, bodies, 2, NULL),
      field_for("pull", MIMO_WORLD_GRAVITY, NULL, 0, NULL)};
  const char* label = NULL;
  mimo_env* env;
  size_t i;
  for (i = 0; i < sizeof fields / sizeof *fields; ++i) CHECK_OK(mimo_scene_add_field(scene, &fields[i]));
  add(scene, "now", MIMO_BODY_POSE | MIMO_NOW, "ball", NULL);
  env = env_of(scene);
  CHECK(sizes_of(env).fields == 6 && sizes_of(env).agents == 0);
  CHECK(field_of(env, "mixed").ndim == 1 && field_of(env, "mixed").shape[0] == 8); /* 1 and 7: they lie in one row */
  CHECK_TEXT("", field_of(env, "mixed").unit);
  CHECK(field_of(env, "hinge").ndim == 1 && field_of(env, "hinge").shape[0] == 1);
  CHECK_TEXT("rad", field_of(env, "hinge").unit);
  CHECK_TEXT("joint", field_of(env, "hinge").frame);
  CHECK(field_of(env, "toys").ndim == 2 && field_of(env, "toys").shape[0] == 2 && field_of(env, "toys").shape[1] == 3);
  CHECK_TEXT("m", field_of(env, "toys").unit);
  CHECK_TEXT("table", field_of(env, "toys").frame);
  CHECK(field_of(env, "mass").ndim == 1 && field_of(env, "mass").shape[0] == 2);
  CHECK(field_of(env, "pull").ndim == 1 && field_of(env, "pull").shape[0] == 3);
  CHECK_TEXT("world", field_of(env, "pull").frame);
  CHECK_TEXT("world", field_of(env, "now").frame);
  check_times_of(env, "hinge", 0);
  check_times_of(env, "toys", -kTimestep);
  check_times_of(env, "now", 0);
  CHECK_OK(mimo_layout_find(layout_of(env), "toys", &i));
  CHECK_OK(mimo_layout_label(layout_of(env), i, 4, &label));
  CHECK_TEXT("cart", label);
  mimo_env_destroy(env);
}

/* Where a hand is and how it moves, as the head sees it. */
static mimo_env* swinging(void) {
  mimo_scene* scene = blind_scene("benchmark");
  mimo_env_config config;
  mimo_env* env = NULL;
  add(scene, "hand/position", MIMO_BODY_POSITION | MIMO_NOW, "left_hand", "head");
  add(scene, "hand/velocity", MIMO_BODY_VELOCITY | MIMO_NOW, "left_hand", "head");
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.frame_skip = 1;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

/* In a physics step joints go from where they are with the velocities of its end. So the hand's velocity, in the middle
 * between the poses of then and of now, is how far it came, divided by the step. */
static void check_velocities_against_differences(void) {
  mimo_env* env = swinging();
  double then[200], now[200], fastest = 0, worst = 0;
  float action[44], place[3], velocity[3];
  size_t joints = 0;
  int n, i;
  CHECK_OK(mimo_env_width(env, MIMO_JOINT_POSITION, NULL, 0, &joints));
  CHECK(joints <= 200);
  reset(env, 1);
  for (n = 0; n < 100; ++n) {
    double error = 0, speed = 0;
    memcpy(place, values(env, "hand/position"), sizeof place);
    CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, NULL, 0, then, joints));
    for (i = 0; i < 44; ++i) action[i] = (float)sin(0.05 * n + i);
    CHECK_OK(mimo_env_step(env, action, 44, block, sizeof block, NULL));
    for (i = 0; i < 3; ++i) place[i] = values(env, "hand/position")[i] - place[i];
    memcpy(velocity, values(env, "hand/velocity"), sizeof velocity);
    CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, NULL, 0, now, joints));
    CHECK_OK(mimo_env_set(env, MIMO_JOINT_POSITION, NULL, 0, then, joints));
    CHECK_OK(mimo_env_observe(env, block, sizeof block));
    for (i = 0; i < 3; ++i) {
      const double mean = 0.5 * ((double)velocity[i] + (double)values(env, "hand/velocity")[i]);
      error += pow((double)place[i] / kTimestep - mean, 2);
      speed += mean * mean;
    }
    worst = fmax(worst, sqrt(error));
    fastest = fmax(fastest, sqrt(speed));
    CHECK_OK(mimo_env_set(env, MIMO_JOINT_POSITION, NULL, 0, now, joints));
    CHECK_OK(mimo_env_observe(env, block, sizeof block));
  }
  CHECK(fastest > 1);
  CHECK(worst < 0.01 * fastest);
  mimo_env_destroy(env);
}

/* ---- Goals ---- */

static mimo_scene* task_scene(const char* name, const char* const* elements) {
  mimo_scene_config room;
  mimo_scene* scene = NULL;
  const mimo_field_config goal = field_for("goal", MIMO_AGENT_GOAL, elements, 1, NULL);
  const mimo_field_config achieved = field_for("achieved", MIMO_AGENT_ACHIEVED, elements, 1, NULL);
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = name;
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_scene_add_agents(scene, NULL, NULL));
  CHECK_OK(mimo_scene_add_field(scene, &goal));
  CHECK_OK(mimo_scene_add_field(scene, &achieved));
  return scene;
}

static const char* const sole[] = {""};

/* A field is what named access reads, in a block of a reset, of a step and of an observation alike. */
static void check_read(const mimo_env* env, const char* name, int32_t quantity) {
  double read[8] = {0};
  size_t count = 0;
  CHECK_OK(mimo_env_width(env, quantity, NULL, 0, &count));
  CHECK_OK(mimo_env_get(env, quantity, NULL, 0, read, count));
  check_values(env, name, read, count);
}

static void check_place(const mimo_env* env, const float* place, const char* body) {
  const int32_t id = find(env, MIMO_BODY, body);
  double expected[3];
  int i;
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &id, 1, expected, 3));
  for (i = 0; i < 3; ++i) CHECK_NEAR(expected[i], (double)place[i], 1e-6);
}

static void check_the_goal_of_reach(void) {
  mimo_env* env = env_of(task_scene("reach", sole));
  const float action[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  int n;
  reset(env, 3);
  for (n = 0; n < 30; ++n) {
    check_place(env, values(env, "goal"), "target");
    check_place(env, values(env, "achieved"), "right_fingers");
    check_read(env, "goal", MIMO_AGENT_GOAL);
    check_read(env, "achieved", MIMO_AGENT_ACHIEVED);
    CHECK_OK(mimo_env_step(env, action, 8, block, sizeof block, NULL));
  }
  CHECK_OK(mimo_env_observe(env, block, sizeof block));
  check_place(env, values(env, "achieved"), "right_fingers");
  mimo_env_destroy(env);
}

static void check_the_goal_of_standup(void) {
  mimo_env* env = env_of(task_scene("standup", sole));
  const int32_t head = find(env, MIMO_BODY, "head");
  double place[3];
  reset(env, 3);
  step(env);
  CHECK(values(env, "goal")[0] == 0.5f); /* the paper's height */
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &head, 1, place, 3));
  CHECK_NEAR(place[2], (double)values(env, "achieved")[0], 1e-6);
  mimo_env_destroy(env);
}

static int in_contact(mimo_env* env, int32_t body) {
  double bodies[2 * 64];
  size_t count = 0, i;
  CHECK_OK(mimo_env_count(env, MIMO_CONTACT, &count));
  CHECK(count <= 64);
  CHECK_OK(mimo_env_get(env, MIMO_CONTACT_BODIES, NULL, 0, bodies, 2 * count));
  for (i = 0; i < 2 * count && bodies[i] != body; ++i) continue;
  return i < 2 * count;
}

/* The body that the infant is told. A ball put into it is felt, and what else it lies on; one far away is not. */
static void check_told(mimo_env* env, int felt) {
  const int32_t ball = find(env, MIMO_BODY, "ball");
  const float *told = values(env, "task/target"), *goal = values(env, "goal");
  const double place[3] = {(double)goal[1], (double)goal[2], (double)goal[3]}, away[3] = {5, 5, 5};
  const char *label = NULL, *name = NULL;
  size_t field = 0, i;
  uint8_t ended = 0;
  for (i = 0; told[i] == 0; ++i) continue;
  CHECK_OK(mimo_layout_find(layout_of(env), "task/target", &field));
  CHECK_OK(mimo_layout_label(layout_of(env), field, i, &label));
  CHECK_OK(mimo_env_name(env, MIMO_BODY, (int32_t)goal[0], &name));
  CHECK_TEXT(label, name);
  CHECK(values(env, "achieved")[0] == -1);
  CHECK_OK(mimo_env_set(env, MIMO_BODY_POSITION, &ball, 1, felt ? place : away, 3));
  CHECK_OK(mimo_env_step(env, NULL, 0, block, sizeof block, RESULTS(.terminated = &ended, .agent_count = 1)));
  felt = felt || in_contact(env, (int32_t)goal[0]);
  check_place(env, goal + 1, label);
  check_place(env, values(env, "achieved") + 1, "right_fingers");
  CHECK(ended == felt && values(env, "achieved")[0] == (felt ? goal[0] : -1));
}

static void check_the_goal_of_selfbody(void) {
  mimo_scene* scene = task_scene("selfbody", sole);
  mimo_object_config ball;
  mimo_env* env;
  uint64_t seed;
  CHECK_OK(mimo_object_config_init(&ball, sizeof ball));
  ball.name = "ball";
  ball.position[0] = 5;
  CHECK_OK(mimo_scene_add_object(scene, &ball));
  env = env_of(scene);
  for (seed = 0; seed < 20; ++seed) {
    reset(env, seed);
    check_told(env, seed % 2 == 0);
  }
  mimo_env_destroy(env);
}

/* Touches in a row, as the term of the reward has them. */
static void check_the_goal_of_catch(void) {
  mimo_env* env = env_of(task_scene("catch", sole));
  double terms[4] = {0, 0, 0, 0};
  const size_t term_count = sizes_of(env).terms;
  int n, row = 0, most = 0;
  reset(env, 1);
  CHECK(values(env, "goal")[0] == 100 && values(env, "achieved")[0] == 0);
  CHECK_TEXT("contact", term_name(env, 0));
  for (n = 0; n < 80; ++n) {
    CHECK_OK(mimo_env_step(env, NULL, 0, block, sizeof block, RESULTS(.terms = terms, .term_count = term_count)));
    row = terms[0] > 0 ? row + 1 : 0;
    most = row > most ? row : most;
    CHECK(values(env, "achieved")[0] == (float)row);
  }
  CHECK(most > 0);
  mimo_env_destroy(env);
}

/* ---- Many worlds ---- */

static void check_goals_in_a_batch(void) {
  mimo_scene* scene = task_scene("reach", sole);
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  mimo_env* env = NULL;
  const uint64_t seeds[2] = {4, 5};
  double goals[6];
  uint8_t* blocks;
  size_t bytes, i;
  add(scene, "hand", MIMO_BODY_POSE | MIMO_NOW, "left_hand", "head");
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 2;
  config.threads = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  env = env_of(scene);
  bytes = sizes_of(env).block_bytes;
  blocks = malloc(2 * bytes);
  CHECK_OK(mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = 2), blocks, 2 * bytes));
  CHECK_OK(mimo_batch_step(batch, NULL, 0, blocks, 2 * bytes, NULL));
  CHECK_OK(mimo_batch_get(batch, MIMO_AGENT_GOAL, NULL, 0, NULL, 0, goals, 6));
  for (i = 0; i < 2; ++i) {
    reset(env, seeds[i]);
    step(env);
    CHECK(memcmp(block, blocks + i * bytes, bytes) == 0);
    check_values(env, "goal", goals + 3 * i, 3);
  }
  CHECK(fabs(goals[0] - goals[3]) > 1e-6);
  mimo_env_destroy(env);
  mimo_batch_destroy(batch);
  free(blocks);
}

/* ---- What is refused ---- */

static void refuse(mimo_status status, const char* part, mimo_field_config config) {
  mimo_scene* scene = scene_of(kModel);
  CHECK_FAILS(status, part, mimo_scene_add_field(scene, &config));
  mimo_scene_destroy(scene);
}

static void refuse_world(mimo_status status, const char* part, mimo_scene* scene, mimo_field_config config) {
  mimo_env* env = NULL;
  CHECK_OK(mimo_scene_add_field(scene, &config));
  CHECK_FAILS(status, part, mimo_env_create(scene, NULL, &env));
  CHECK(env == NULL);
  mimo_scene_destroy(scene);
}

static void check_refused_fields(void) {
  static const char* const ball[] = {"ball"};
  static const char* const ghost[] = {"ball", "ghost"};
  static const char* const nothing[] = {NULL};
  mimo_scene* scene = scene_of(kModel);
  mimo_field_config config = field_for("ball", MIMO_BODY_POSITION, ball, 1, NULL);
  mimo_limits limits;
  CHECK_OK(mimo_scene_add_field(scene, &config));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "there is a field \"ball\" already", mimo_scene_add_field(scene, &config));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "config is NULL", mimo_scene_add_field(scene, NULL));
  mimo_scene_destroy(scene);
  refuse(MIMO_E_INVALID_ARGUMENT, "name is NULL", field_for(NULL, MIMO_BODY_POSITION, ball, 1, NULL));
  refuse(MIMO_E_INVALID_ARGUMENT, "name is \"ball/\"", field_for("ball/", MIMO_BODY_POSITION, ball, 1, NULL));
  refuse(MIMO_E_INVALID_ARGUMENT, "element_count is 0, expected at least 1",
         field_for("ball", MIMO_BODY_POSITION, NULL, 0, NULL));
  refuse(MIMO_E_INVALID_ARGUMENT, "element_count is 1, expected 0",
         field_for("down", MIMO_WORLD_GRAVITY, ball, 1, NULL));
  refuse(MIMO_E_INVALID_ARGUMENT, "elements is NULL", field_for("ball", MIMO_BODY_POSITION, NULL, 1, NULL));
  refuse(MIMO_E_INVALID_ARGUMENT, "elements[0] is NULL", field_for("ball", MIMO_BODY_POSITION, nothing, 1, NULL));
  refuse(MIMO_E_INVALID_ARGUMENT, "MIMO_CONTACT_FORCE, of which worlds have different numbers",
         field_for("f", MIMO_CONTACT_FORCE, ball, 1, NULL));
  refuse(MIMO_E_INVALID_ARGUMENT, "MIMO_SENSOR_VALUE, which only physics steps compute",
         field_for("s", MIMO_SENSOR_VALUE | MIMO_NOW, ball, 1, NULL));
  refuse(MIMO_E_INVALID_ARGUMENT, "relative_to is \"table\", but MIMO_BODY_MASS has no frame",
         field_for("m", MIMO_BODY_MASS, ball, 1, "table"));
  refuse(MIMO_E_UNSUPPORTED, "quantity is 0x1ff", field_for("x", 0x1ff, ball, 1, NULL));
  refuse_world(MIMO_E_NOT_FOUND, "field \"two\": no body named \"ghost\"; there are: ", scene_of(kModel),
               field_for("two", MIMO_BODY_POSITION, ghost, 2, NULL));
  refuse_world(MIMO_E_NOT_FOUND, "field \"ball\": no body named \"desk\"", scene_of(kModel),
               field_for("ball", MIMO_BODY_POSITION, ball, 1, "desk"));
  refuse_world(MIMO_E_INVALID_ARGUMENT, "there are two fields \"touch/force\"", blind_scene("free"),
               field_for("touch/force", MIMO_WORLD_GRAVITY, NULL, 0, NULL));
  refuse_world(MIMO_E_UNSUPPORTED, "field \"goal\": agent goal, but the agent has none", blind_scene("free"),
               field_for("goal", MIMO_AGENT_GOAL, sole, 1, NULL));
  scene = blind_scene("free");
  config = field_for("scene/gravity", MIMO_WORLD_GRAVITY, NULL, 0, NULL);
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.gain = 2;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "scene", &limits));
  refuse_world(MIMO_E_INVALID_ARGUMENT, "\"scene/gravity\" is a field of the task or the scene", scene, config);
}

int main(void) {
  check_when_requested_fields_are_true();
  check_descriptions_of_requested_fields();
  check_velocities_against_differences();
  check_the_goal_of_reach();
  check_the_goal_of_standup();
  check_the_goal_of_selfbody();
  check_the_goal_of_catch();
  check_goals_in_a_batch();
  check_refused_fields();
  return failures();
}
