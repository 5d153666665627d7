/* Several infants in one scene: each behaves as it would alone, and they see and feel each other. */
#include "support/capi.h"

enum { TEN = 10, JOINTS = 47, MOTORS = 44, SIZE = 33, PIXELS = SIZE * SIZE };

static mimo_scene* room(const char* name, const char* xml) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.name = name;
  config.xml = xml;
  CHECK_OK(mimo_scene_create(&config, &scene));
  if (scene == NULL) exit(failures());
  return scene;
}

static void add(mimo_scene* scene, const char* name, double x, double y, double z) {
  mimo_agent_config config;
  CHECK_OK(mimo_agent_config_init(&config, sizeof config));
  config.name = name;
  config.vision = 0;
  config.place = MIMO_PLACE_ROOT;
  config.position[0] = x;
  config.position[1] = y;
  config.position[2] = z;
  CHECK_OK(mimo_scene_add_agent(scene, &config, NULL));
}

static mimo_env* env_of(mimo_scene* scene) {
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

/* How deep an infant is in the floor and by which of its bodies, as MuJoCo's collisions say; 0 where it is not. */
static double depth(mimo_env* env, int32_t* body) {
  double bodies[2 * 64], distances[64], deepest = 0;
  size_t i, count = 0;
  CHECK_OK(mimo_env_count(env, MIMO_CONTACT, &count));
  CHECK_OK(mimo_env_get(env, MIMO_CONTACT_BODIES, NULL, 0, bodies, 2 * count));
  CHECK_OK(mimo_env_get(env, MIMO_CONTACT_DISTANCE, NULL, 0, distances, count));
  for (i = 0; i < count; ++i) {
    if ((bodies[2 * i] != 0 && bodies[2 * i + 1] != 0) || distances[i] >= deepest) continue;
    deepest = distances[i];
    *body = (int32_t)(bodies[2 * i] + bodies[2 * i + 1]);
  }
  return -deepest;
}

/* An infant in a room with a floor, placed by one of its points. */
static mimo_env* placed(int32_t place, double x, double y, double z, const double* orientation) {
  mimo_scene* scene = NULL;
  mimo_scene_config scene_config;
  mimo_agent_config config;
  CHECK_OK(mimo_scene_config_init(&scene_config, sizeof scene_config));
  CHECK_OK(mimo_scene_create(&scene_config, &scene));
  CHECK_OK(mimo_scene_set_room(scene, "playroom"));
  CHECK_OK(mimo_agent_config_init(&config, sizeof config));
  config.vision = config.touch = 0;
  config.place = place;
  config.position[0] = x;
  config.position[1] = y;
  config.position[2] = z;
  if (orientation != NULL) memcpy(config.orientation, orientation, sizeof config.orientation);
  CHECK_OK(mimo_scene_add_agent(scene, &config, NULL));
  return env_of(scene);
}

static void check_where_infants_are_placed(void) {
  static const double on_its_back[4] = {0.70710678118654752, 0, -0.70710678118654752, 0};
  const char* feet[2] = {"left_foot", "right_foot"};
  double left[3], right[3], root[3];
  int32_t body = 0, ids[2];
  int i;
  mimo_env* env = placed(MIMO_PLACE_SOLES, 0.5, -0.25, 0.001, NULL);
  CHECK(depth(env, &body) == 0);
  for (i = 0; i < 2; ++i) ids[i] = find(env, MIMO_BODY, feet[i]);
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, ids, 1, left, 3));
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, ids + 1, 1, right, 3));
  CHECK_NEAR((left[0] + right[0]) / 2, 0.5, 1e-12);
  CHECK_NEAR((left[1] + right[1]) / 2, -0.25, 1e-12);
  mimo_env_destroy(env);

  env = placed(MIMO_PLACE_SOLES, 0, 0, -0.002, NULL);
  CHECK_NEAR(depth(env, &body), 0.002, 1e-9);
  for (i = 0; i < 4 && body != ids[0] && body != ids[1]; ++i) CHECK_OK(mimo_env_body_of(env, MIMO_BODY, body, &body));
  CHECK(body == ids[0] || body == ids[1]); /* toes hang on the feet */
  mimo_env_destroy(env);

  env = placed(MIMO_PLACE_LOWEST, 1, 2, 0.001, on_its_back);
  CHECK(depth(env, &body) == 0);
  ids[0] = find(env, MIMO_BODY, "mimo_location");
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, ids, 1, root, 3));
  CHECK(root[0] == 1 && root[1] == 2);
  mimo_env_destroy(env);
  env = placed(MIMO_PLACE_LOWEST, 1, 2, -0.002, on_its_back);
  CHECK_NEAR(depth(env, &body), 0.002, 1e-9);
  mimo_env_destroy(env);
}

static int32_t find_of(const mimo_env* env, int32_t kind, const char* infant, const char* name) {
  char text[96];
  snprintf(text, sizeof text, "%s%s", infant, name);
  return find(env, kind, text);
}

/* Numbers from -1 to 1, the same everywhere. */
static double noise(uint32_t* state) {
  *state = *state * 1664525u + 1013904223u;
  return (double)(*state >> 8) / (1 << 23) - 1;
}

/* ---- Alone and together ---- */

static void joint_ids(const mimo_env* env, const char* infant, int32_t* ids) {
  const size_t length = strlen(infant);
  size_t count = 0, found = 0, i;
  const char* name;
  CHECK_OK(mimo_env_count(env, MIMO_JOINT, &count));
  for (i = 0; i < count; ++i) {
    CHECK_OK(mimo_env_name(env, MIMO_JOINT, (int32_t)i, &name));
    if (strncmp(name, infant, length) == 0 && strncmp(name + length, "robot:", 6) == 0 && found < JOINTS) {
      ids[found++] = (int32_t)i;
    }
  }
  CHECK(found == JOINTS);
}

static double farthest(const mimo_env* one, const int32_t* ones, const mimo_env* two, const int32_t* twos) {
  double a[JOINTS], b[JOINTS], far = 0;
  int i;
  CHECK_OK(mimo_env_get(one, MIMO_JOINT_POSITION, ones, JOINTS, a, JOINTS));
  CHECK_OK(mimo_env_get(two, MIMO_JOINT_POSITION, twos, JOINTS, b, JOINTS));
  for (i = 0; i < JOINTS; ++i) far = fmax(far, fabs(a[i] - b[i]));
  return far;
}

/* They fall to the floor ten metres apart. One solver works for both, so it is not the same to the bit. */
static void check_that_distant_infants_equal_single_ones(void) {
  static const char* const names[2] = {"anna", "ben"};
  static const char* const prefixes[2] = {"anna/", "ben/"};
  mimo_scene* both = room("free", NULL);
  mimo_env *together, *alone[2];
  int32_t ids[2][JOINTS], own[2][JOINTS];
  float action[2 * MOTORS];
  uint32_t state = 1;
  double still = 0;
  size_t count = 0;
  int i, step;
  for (i = 0; i < 2; ++i) {
    mimo_scene* scene = room("free", NULL);
    add(both, names[i], 0, 10 * i, 0.4);
    add(scene, "", 0, 10 * i, 0.4);
    alone[i] = env_of(scene);
    joint_ids(alone[i], "", own[i]);
  }
  together = env_of(both);
  for (i = 0; i < 2; ++i) joint_ids(together, prefixes[i], ids[i]);
  for (step = 0; step < 50; ++step) { /* of two physics steps */
    for (i = 0; i < 2 * MOTORS; ++i) action[i] = (float)noise(&state);
    CHECK_OK(mimo_env_step(together, action, 2 * MOTORS, NULL, 0, NULL));
    for (i = 0; i < 2; ++i) {
      CHECK_OK(mimo_env_step(alone[i], action + MOTORS * i, MOTORS, NULL, 0, NULL));
      CHECK_NEAR(0, farthest(together, ids[i], alone[i], own[i]), 1e-6);
    }
  }
  CHECK_OK(mimo_env_count(together, MIMO_CONTACT, &count));
  CHECK(count > 5); /* they have fallen */
  still = farthest(together, ids[0], together, ids[1]);
  CHECK(still > 0.1); /* and do not all do the same */
  mimo_env_destroy(together);
  for (i = 0; i < 2; ++i) mimo_env_destroy(alone[i]);
}

/* ---- Each has its own ---- */

static mimo_status judge(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  (void)user, (void)env;
  verdict->reward = 1 + (double)moment->agent;
  if (moment->agent == 1) verdict->outcome = MIMO_OUTCOME_SUCCESS;
  return MIMO_OK;
}

static void check_what_each_infant_has_of_its_own(void) {
  mimo_scene* scene = room("playdate", NULL);
  mimo_task task;
  mimo_agent_config config;
  mimo_env* env;
  mimo_agent_info info;
  float* action;
  unsigned char* block;
  double reward[2], control = 0, fear, faces[2];
  uint8_t terminated[2], truncated[2];
  size_t bytes = 0, actions = 0, count = 0, i;
  const int32_t ben = 1;
  int32_t motor;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = judge;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_scene_default_agent(scene, &config, sizeof config));
  CHECK(config.vision == MIMO_VISION_RGB && config.touch == MIMO_TOUCH_FORCE);
  /* The place that the next infant would get, as models/playdate.xml has it. */
  CHECK(config.place == MIMO_PLACE_SCENE && config.position[0] == -0.28 && config.position[2] == 0.0431);
  CHECK(config.orientation[0] == 1);
  config.vision = 0;

  config.name = "carl";
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "names its infants", mimo_scene_add_agents(scene, &config, &count));
  config.name = "";
  config.place = MIMO_PLACE_ROOT;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "each of 2 infants", mimo_scene_add_agents(scene, &config, &count));
  config.place = MIMO_PLACE_SCENE;
  CHECK(count == 0);
  CHECK_OK(mimo_scene_add_agents(scene, &config, &count));
  CHECK(count == 2);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "\"anna\" already", mimo_scene_add_agents(scene, &config, NULL));
  CHECK_OK(mimo_scene_default_agent(scene, &config, sizeof config));
  CHECK(config.position[0] == 0 && config.position[2] == 0); /* both places are taken */
  config.vision = 0;
  CHECK_OK(mimo_scene_set_touch(scene, 1, NULL, 0.05));
  env = env_of(scene);

  bytes = sizes_of(env).block_bytes;
  actions = sizes_of(env).actions;
  CHECK(actions == 50); /* head 3, eyes 6, two arms of 4, two hands of 4: 25 each */
  block = malloc(bytes);
  action = calloc(actions, sizeof *action);
  for (i = 0; i < 2; ++i) {
    info.struct_size = sizeof info;
    CHECK_OK(mimo_env_agent(env, i, &info));
    CHECK_TEXT(i == 0 ? "anna" : "ben", info.name);
    CHECK(info.action_offset == 25 * i && info.action_count == 25);
  }
  for (i = 25; i < 50; ++i) action[i] = 0.25f;
  CHECK_OK(
      mimo_env_step(env, action, actions, block, bytes,
                    RESULTS(.reward = reward, .terminated = terminated, .truncated = truncated, .agent_count = 2)));
  CHECK(reward[0] == 1 && reward[1] == 2);
  CHECK(terminated[0] == 0 && terminated[1] == 1 && truncated[0] == 0 && truncated[1] == 0);
  motor = find(env, MIMO_ACTUATOR, "anna/act:left_elbow");
  CHECK_OK(mimo_env_get(env, MIMO_ACTUATOR_CONTROL, &motor, 1, &control, 1));
  CHECK(control == 0);
  motor = find(env, MIMO_ACTUATOR, "ben/act:left_elbow");
  CHECK_OK(mimo_env_get(env, MIMO_ACTUATOR_CONTROL, &motor, 1, &control, 1));
  CHECK(control == 0.25);

  fear = find(env, MIMO_FACE, "fear");
  CHECK_OK(mimo_env_set(env, MIMO_AGENT_FACE, &ben, 1, &fear, 1));
  CHECK_OK(mimo_env_get(env, MIMO_AGENT_FACE, NULL, 0, faces, 2));
  CHECK(faces[0] == find(env, MIMO_FACE, "neutral") && faces[1] == fear);
  for (i = 0; i < 2; ++i) {
    const mimo_field touch = field_of(env, i == 0 ? "anna/touch/force" : "ben/touch/force");
    CHECK(touch.shape[0] == touch.receptors);
    CHECK(i == 0 ? touch.receptors == 5685 : touch.receptors < 2000);
  }
  mimo_env_destroy(env);
  free(block);
  free(action);
}

/* ---- Playdate ---- */

static double height_and_place(const mimo_env* env, const char* infant, double* xyz) {
  const int32_t chest = find_of(env, MIMO_BODY, infant, "upper_body");
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &chest, 1, xyz, 3));
  return xyz[2];
}

/* Whatever head and arms do for five seconds, they stay seated; and the toy is within reach of both. */
static void check_that_seated_infants_stay_seated(void) {
  static const char* const prefixes[2] = {"anna/", "ben/"};
  mimo_env* env = NULL;
  mimo_scene* scene = room("playdate", NULL);
  mimo_agent_config config;
  double before[2][3], after[3], toy[3], shoulder[3];
  float action[50];
  uint32_t state = 7;
  int i, step;
  int32_t id;
  CHECK_OK(mimo_agent_config_init(&config, sizeof config));
  config.vision = config.touch = 0;
  CHECK_OK(mimo_scene_add_agents(scene, &config, NULL));
  env = env_of(scene);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  id = find(env, MIMO_BODY, "toy");
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &id, 1, toy, 3));
  for (i = 0; i < 2; ++i) {
    height_and_place(env, prefixes[i], before[i]);
    id = find_of(env, MIMO_BODY, prefixes[i], "left_upper_arm");
    CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &id, 1, shoulder, 3));
    /* Upper arm, lower arm, hand to the fingertips: 0.1076 + 0.087 + 0.0416 + 0.0414 m. */
    CHECK(hypot(hypot(toy[0] - shoulder[0], toy[1] - shoulder[1]), toy[2] + 0.088 - shoulder[2]) < 0.37);
  }
  CHECK_NEAR(0.5, before[1][0] - before[0][0], 0.1); /* face to face, half a metre apart */
  CHECK_NEAR(0, before[1][1] - before[0][1], 0.02);
  for (step = 0; step < 500; ++step) {
    for (i = 0; i < 50; ++i) action[i] = (float)noise(&state);
    CHECK_OK(mimo_env_step(env, action, 50, NULL, 0, NULL));
  }
  for (i = 0; i < 2; ++i) {
    height_and_place(env, prefixes[i], after);
    CHECK(hypot(hypot(after[0] - before[i][0], after[1] - before[i][1]), after[2] - before[i][2]) < 0.005);
  }
  mimo_env_destroy(env);
}

/* The same bytes for any number of threads, all senses on. */
static void check_that_threads_change_nothing(void) {
  enum { WORLDS = 4, STEPS = 10 };
  unsigned char* blocks[3] = {NULL, NULL, NULL};
  float actions[WORLDS * 50];
  size_t bytes = 0, i;
  int run, step;
  for (run = 0; run < 3; ++run) {
    mimo_scene* scene = room("playdate", NULL);
    const uint64_t seeds[WORLDS] = {1, 2, 3, 4};
    mimo_agent_config config;
    mimo_batch_config batch_config;
    mimo_batch* batch = NULL;
    mimo_env* env = NULL;
    uint32_t state = 3;
    CHECK_OK(mimo_scene_default_agent(scene, &config, sizeof config));
    config.vision_width = config.vision_height = 24;
    CHECK_OK(mimo_scene_add_agents(scene, &config, NULL));
    CHECK_OK(mimo_batch_config_init(&batch_config, sizeof batch_config));
    batch_config.worlds = WORLDS;
    batch_config.threads = (uint32_t)run + 1;
    CHECK_OK(mimo_batch_create(scene, NULL, &batch_config, &batch));
    mimo_scene_destroy(scene);
    CHECK_OK(mimo_batch_world(batch, 0, &env));
    bytes = sizes_of(env).block_bytes;
    blocks[run] = malloc(WORLDS * bytes);
    CHECK_OK(mimo_batch_reset(batch, SEEDS(.seeds = seeds, .worlds = WORLDS), NULL, 0));
    for (step = 0; step < STEPS; ++step) {
      for (i = 0; i < WORLDS * 50; ++i) actions[i] = (float)noise(&state);
      CHECK_OK(mimo_batch_step(batch, actions, WORLDS * 50, blocks[run], WORLDS * bytes, NULL));
    }
    mimo_batch_destroy(batch);
    CHECK(memcmp(blocks[run], blocks[0], WORLDS * bytes) == 0);
  }
  CHECK(memcmp(blocks[0], blocks[0] + bytes, bytes) != 0);
  for (run = 0; run < 3; ++run) free(blocks[run]);
}

/* ---- Ten of them ---- */

static int warnings = 0;

static void count_warnings(void* user, const mimo_log_record* record) {
  (void)user;
  fprintf(stderr, "%s\n", record->text);
  ++warnings;
}

enum { PREFIX = 16 };

static void name_of(int i, char* prefix) { snprintf(prefix, PREFIX, "i%d/", i); }

static mimo_env* ten_infants(void) {
  mimo_scene* scene = room("free", NULL);
  mimo_env_config config;
  mimo_env* env = NULL;
  char prefix[PREFIX];
  int i;
  for (i = 0; i < TEN; ++i) { /* two rows that touch each other while they fall */
    name_of(i, prefix);
    prefix[strlen(prefix) - 1] = '\0';
    add(scene, prefix, 0.15 * (i % 2), 0.4 * (i / 2), 0.4);
  }
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.log = count_warnings;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static void check_ten_run(mimo_env* env) {
  float action[TEN * MOTORS];
  size_t bytes = 0, count = 0;
  unsigned char* block;
  uint32_t state = 5;
  int i, step;
  bytes = sizes_of(env).block_bytes;
  block = malloc(bytes);
  for (step = 0; step < 100; ++step) {
    for (i = 0; i < TEN * MOTORS; ++i) action[i] = (float)noise(&state);
    CHECK_OK(mimo_env_step(env, action, TEN * MOTORS, block, bytes, NULL));
  }
  CHECK_OK(mimo_env_count(env, MIMO_CONTACT, &count));
  /* How many depends on all rounding before: 38 to 65, by build of MuJoCo, system and seed. Each lies on something. */
  CHECK(count >= 2 * TEN);
  CHECK(warnings == 0); /* every buffer is large enough */
  free(block);
}

/* A pose of the left arm of all infants: three angles of the shoulder, elbow, three of the wrist. */
static void pose_arms(mimo_env* env, const double* angles) {
  static const char* const joints[7] = {
      "shoulder_horizontal", "shoulder_ad_ab", "shoulder_rotation", "elbow", "hand1", "hand2", "hand3"};
  char prefix[PREFIX], name[64];
  int32_t ids[7];
  int i, j;
  for (i = 0; i < TEN; ++i) {
    name_of(i, prefix);
    for (j = 0; j < 7; ++j) {
      snprintf(name, sizeof name, "robot:left_%s", joints[j]);
      ids[j] = find_of(env, MIMO_JOINT, prefix, name);
    }
    CHECK_OK(mimo_env_set(env, MIMO_JOINT_POSITION, ids, 7, angles, 7));
  }
}

/* What an eye sees in the middle of its picture: the left hand of that infant, 5 cm away. */
static void check_sees(mimo_env* env, int i, const char* eye, int other) {
  static float depth[PIXELS];
  static int32_t geoms[PIXELS];
  const int middle = PIXELS / 2;
  mimo_picture_config config;
  char prefix[PREFIX], camera[64];
  int32_t body = -1;
  name_of(i, prefix);
  snprintf(camera, sizeof camera, "%s%s", prefix, eye);
  CHECK_OK(mimo_picture_config_init(&config, sizeof config));
  config.camera = camera;
  config.width = config.height = SIZE;
  CHECK_OK(mimo_env_render(
      env, &config,
      PICTURE(.depth = depth, .depth_count = PIXELS, .segmentation = geoms, .segmentation_count = PIXELS)));
  CHECK(geoms[middle] >= 0);
  if (geoms[middle] < 0) return;
  CHECK_OK(mimo_env_body_of(env, MIMO_GEOM, geoms[middle], &body));
  name_of(other, prefix);
  CHECK(body == find_of(env, MIMO_BODY, prefix, "left_hand"));
  CHECK_NEAR(0.05, (double)depth[middle], 0.005);
}

static void place_infants(mimo_env* env, const double* step) {
  char prefix[PREFIX];
  int i;
  for (i = 0; i < TEN; ++i) {
    double place[7] = {0, 0, 0.4, 1, 0, 0, 0};
    int32_t root, k;
    name_of(i, prefix);
    root = find_of(env, MIMO_JOINT, prefix, "mimo_orientation");
    for (k = 0; k < 3; ++k) place[k] += i * step[k];
    CHECK_OK(mimo_env_set(env, MIMO_JOINT_POSITION, &root, 1, place, 7));
  }
}

static void check_ten_see(mimo_env* env) {
  const double before_the_eye[7] = {1.326, 2.078, 0.058, -1.043, 0.601, 0.612, 0.096};
  const double to_the_side[7] = {0, 1.4, 0, 0, 0, 0, 0};
  const double far_apart[3] = {0, 3, 0};
  double eye[3], hand[3], step[3];
  int32_t id;
  int i;
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  place_infants(env, far_apart);
  pose_arms(env, before_the_eye);
  for (i = 0; i < TEN; ++i) check_sees(env, i, "eye_left", i);
  /* Each stretches its left hand sidewards and stands so that it is before its neighbour's right eye. The palm's box is
   * 0.005 m before the hand's origin and 0.0208 m along it, and reaches 0.0281 m to the face. */
  pose_arms(env, to_the_side);
  id = find(env, MIMO_CAMERA, "i0/eye_right");
  CHECK_OK(mimo_env_get(env, MIMO_CAMERA_POSITION, &id, 1, eye, 3));
  id = find(env, MIMO_BODY, "i0/left_hand");
  CHECK_OK(mimo_env_get(env, MIMO_BODY_POSITION, &id, 1, hand, 3));
  step[0] = eye[0] + 0.05 - (hand[0] + 0.005 - 0.0281);
  step[1] = eye[1] - (hand[1] + 0.0208);
  step[2] = eye[2] - hand[2];
  place_infants(env, step);
  for (i = 0; i + 1 < TEN; ++i) check_sees(env, i, "eye_right", i + 1);
}

/* What docs/tasks.md says of scenes: motors, and senses besides proprioception. */
static void check_the_defaults_of_scenes(void) {
  static const struct row {
    const char *scene, *body;
    size_t actions;
    int balance, touch, muscles;
  } rows[] = {{"reach", "mitten", 8, 0, 0, 0},
              {"standup", "mitten", 27, 1, 0, 0},
              {"selfbody", "mitten", 8, 0, 1, 0},
              {"catch", "fingers", 40, 0, 1, 1},
              {"rollover", "mitten", 38, 1, 1, 0}};
  mimo_agent_config config;
  size_t i;
  for (i = 0; i < sizeof rows / sizeof *rows; ++i) {
    const struct row* row = &rows[i];
    mimo_scene* scene = room(row->scene, NULL);
    mimo_env* env;
    CHECK_OK(mimo_scene_default_agent(scene, &config, sizeof config));
    CHECK(config.struct_size == sizeof config && config.proprioception != 0 && config.vision == 0);
    CHECK_TEXT(row->body, config.body);
    CHECK((config.vestibular != 0) == row->balance && (config.touch != 0) == row->touch);
    CHECK((config.actuation == MIMO_ACTUATION_MUSCLE) == row->muscles);
    CHECK_OK(mimo_scene_add_agent(scene, &config, NULL));
    env = env_of(scene);
    CHECK(sizes_of(env).actions == row->actions);
    mimo_env_destroy(env);
  }
}

int main(void) {
  check_the_defaults_of_scenes();
  check_where_infants_are_placed();
  mimo_env* ten;
  check_that_distant_infants_equal_single_ones();
  check_what_each_infant_has_of_its_own();
  check_that_seated_infants_stay_seated();
  check_that_threads_change_nothing();
  ten = ten_infants();
  check_ten_run(ten);
  check_ten_see(ten);
  mimo_env_destroy(ten);
  return failures();
}
