/*
 * A program of this version of the interface, and what such programs rely on: functions, structs and their sizes,
 * constants, errors, and that what they do not know of is as if it were not there. ./dev freeze keeps a copy together
 * with the header of its time; those never change, and go on running on the libraries that follow.
 */
#include <math.h>
#include <mimo/experimental.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failed = 0;

#define CHECK(condition)                                                                          \
  do {                                                                                            \
    if (!(condition)) {                                                                           \
      ++failed;                                                                                   \
      fprintf(stderr, "line %d: %s (last error: %s)\n", __LINE__, #condition, mimo_last_error()); \
    }                                                                                             \
  } while (0)
#define OK(call) CHECK((call) == MIMO_OK)

static int messages = 0;

static void count_message(void* user, const mimo_log_record* record) {
  CHECK(user == &messages && record->struct_size >= sizeof *record);
  CHECK(record->level >= MIMO_LOG_WARNING && record->text != NULL && record->code >= 0);
  ++messages;
}

static void versions(void) {
  mimo_env* none = NULL;
  CHECK(mimo_abi_version() == MIMO_ABI_VERSION);
  CHECK(strcmp(mimo_status_name(MIMO_E_NOT_FOUND), "MIMO_E_NOT_FOUND") == 0);
  CHECK(mimo_version()[0] != '\0' && mimo_mujoco_version()[0] != '\0');
  CHECK(mimo_env_make("nowhere", &none) == MIMO_E_NOT_FOUND && none == NULL);
  CHECK(strstr(mimo_last_error(), "nowhere") != NULL);
  CHECK(strcmp(mimo_face_name(0), "neutral") == 0 && mimo_scene_name(0) != NULL && mimo_task_name(0) != NULL);
}

/* An infant with small eyes, a ball and a camera in the room "free". What follows a struct in memory stays as it is. */
static mimo_scene* make_scene(void) {
  struct {
    mimo_agent_config config;
    uint64_t after;
  } agent;
  mimo_scene_config room;
  mimo_object_config ball;
  mimo_camera_config wall;
  mimo_limits limits;
  mimo_senses* senses = NULL;
  mimo_senses_config senses_config;
  mimo_scene* scene = NULL;
  size_t number = 9;
  double value = 0;
  OK(mimo_scene_config_init(&room, sizeof room));
  CHECK(room.struct_size == sizeof room && room.name == NULL && room.log == NULL);
  room.name = "free";
  room.log = count_message;
  room.log_user = &messages;
  OK(mimo_scene_create(&room, &scene));

  agent.after = 0x1234567890abcdefu;
  OK(mimo_agent_config_init(&agent.config, sizeof agent.config));
  CHECK(agent.after == 0x1234567890abcdefu && agent.config.struct_size == sizeof agent.config);
  CHECK(agent.config.vision == MIMO_VISION_RGB && agent.config.vision_width == 256);
  CHECK(agent.config.touch == MIMO_TOUCH_FORCE && agent.config.proprioception == 0x2f);
  agent.config.proprioception = MIMO_PROPRIOCEPTION_ALL;
  OK(mimo_scene_default_agent(scene, &agent.config, sizeof agent.config));
  CHECK(agent.after == 0x1234567890abcdefu);
  agent.config.vision_width = agent.config.vision_height = 16;
  agent.config.vision = MIMO_VISION_RGB | MIMO_VISION_DEPTH;
  agent.config.touch_scale = 0.5;
  agent.config.acts = MIMO_ACT_ALL;
  agent.config.face = "enjoyment";
  OK(mimo_scene_add_agent(scene, &agent.config, &number));
  CHECK(number == 0);
  OK(mimo_scene_set_touch(scene, 0, "left_hand", 0.01));

  OK(mimo_limits_init(&limits, sizeof limits));
  CHECK(limits.gain == 1 && limits.delay == 0);
  OK(mimo_scene_limit_sense(scene, 0, "touch", &limits));
  OK(mimo_scene_limit_motor(scene, 0, "left_arm", &limits));
  OK(mimo_senses_config_init(&senses_config, sizeof senses_config));
  senses_config.mujoco_version = 222;
  CHECK(mimo_senses_attach(scene, NULL, &senses_config, &senses) == MIMO_E_INVALID_ARGUMENT && senses == NULL);
  mimo_senses_destroy(senses);

  OK(mimo_object_config_init(&ball, sizeof ball));
  ball.name = "toy";
  ball.shape = MIMO_SHAPE_SPHERE;
  ball.position[0] = 1;
  ball.position[2] = 2;
  OK(mimo_scene_add_object(scene, &ball));
  OK(mimo_camera_config_init(&wall, sizeof wall));
  wall.name = "wall";
  wall.placed = 1;
  wall.width = wall.height = 8;
  OK(mimo_scene_add_camera(scene, &wall));
  OK(mimo_scene_set_parameter(scene, "reach/success_reward", 5));
  OK(mimo_scene_get_parameter(scene, "reach/success_reward", &value));
  CHECK(value == 5);
  return scene;
}

static const mimo_layout* layout_of(const mimo_env* env) {
  const mimo_layout* layout = NULL;
  OK(mimo_env_layout(env, &layout));
  return layout;
}

static mimo_layout_info sizes_of(const mimo_env* env) {
  mimo_layout_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  OK(mimo_layout_describe(layout_of(env), &info));
  return info;
}

static mimo_field field_named(const mimo_env* env, const char* name) {
  mimo_field field;
  size_t index = 0;
  memset(&field, 0, sizeof field);
  field.struct_size = sizeof field;
  OK(mimo_layout_find(layout_of(env), name, &index));
  OK(mimo_layout_field(layout_of(env), index, &field));
  return field;
}

/* A receptor lies on a body, and its normal is a unit vector. */
static void check_receptors(const mimo_env* env) {
  size_t index = 0, count = 0;
  double *bodies, *frames;
  OK(mimo_layout_find(layout_of(env), "touch/force", &index));
  OK(mimo_layout_receptor_width(layout_of(env), index, MIMO_RECEPTOR_BODY, &count));
  CHECK(count > 100 && count == field_named(env, "touch/force").receptors);
  bodies = calloc(count, sizeof *bodies);
  frames = calloc(9 * count, sizeof *frames);
  OK(mimo_layout_receptors(layout_of(env), index, MIMO_RECEPTOR_BODY, bodies, count));
  OK(mimo_layout_receptors(layout_of(env), index, MIMO_RECEPTOR_FRAME, frames, 9 * count));
  CHECK(bodies[count - 1] > 0);
  CHECK(fabs(frames[0] * frames[0] + frames[1] * frames[1] + frames[2] * frames[2] - 1) < 1e-9);
  free(bodies);
  free(frames);
}

static void check_fields(const mimo_env* env) {
  const mimo_field eye = field_named(env, "vision/eye_left"), depth = field_named(env, "vision/eye_left_depth"),
                   joints = field_named(env, "proprioception/position"), touch = field_named(env, "touch/force"),
                   wall = field_named(env, "vision/wall");
  const char* label = NULL;
  CHECK(eye.dtype == MIMO_U8 && eye.ndim == 3 && eye.shape[0] == 16 && eye.shape[2] == 3 && eye.bytes == 768);
  CHECK(depth.dtype == MIMO_F32 && depth.ndim == 2 && strcmp(depth.unit, "m") == 0);
  CHECK(joints.dtype == MIMO_F32 && joints.start == 0 && joints.end == 0 && joints.period > 0 &&
        joints.offset % 64 == 0);
  CHECK(touch.ndim == 2 && touch.shape[1] == 3 && touch.end == -0.005);
  CHECK(wall.bytes == 8 * 8 * 3);
  OK(mimo_layout_label(layout_of(env), 0, 0, &label));
}

/* Steps, states, names. A ball falls by g h^2 n (n + 1) / 2 in n steps of h = 5 ms. */
static void live(mimo_env* env) {
  mimo_reset_config seed;
  mimo_env_results results;
  int32_t outcome = 9;
  size_t bytes = 0, count = 0, agents = 0, state_bytes = 0, i;
  double reward = 9, seconds = 0, place[3], xyz[3];
  uint8_t terminated = 9, truncated = 9;
  const double lock[2] = {1, -0.5}, moon[3] = {0, 0, -1.6};
  float pose[7];
  int32_t toy = -1, elbow = -1, body = -1;
  mimo_agent_info infant;
  uint8_t *block, *again, *state;
  float* action;
  mimo_action first;
  mimo_env* twin = NULL;
  bytes = sizes_of(env).block_bytes;
  count = sizes_of(env).actions;
  CHECK(sizes_of(env).agents == 1 && bytes % 64 == 0 && count > 0);
  memset(&infant, 0, sizeof infant);
  infant.struct_size = sizeof infant;
  OK(mimo_env_agent(env, 0, &infant));
  CHECK(infant.action_count == count && fabs(infant.mass - 10.905) < 1e-3);
  block = malloc(bytes);
  again = malloc(bytes);
  action = calloc(count, sizeof *action);
  memset(&first, 0, sizeof first);
  first.struct_size = sizeof first;
  OK(mimo_layout_action(layout_of(env), 0, &first));
  CHECK(first.agent == 0 && first.low < first.high);
  memset(&seed, 0, sizeof seed);
  seed.struct_size = sizeof seed;
  seed.seeded = 1;
  seed.seed = 7;
  OK(mimo_env_reset(env, &seed, block, bytes));
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = &reward;
  results.terminated = &terminated;
  results.truncated = &truncated;
  results.outcome = &outcome;
  results.agent_count = 1;
  OK(mimo_env_state_size(env, &state_bytes));
  state = malloc(state_bytes);
  OK(mimo_env_state_save(env, state, state_bytes));
  for (i = 0; i < 10; ++i) {
    action[0] = 0.5f;
    OK(mimo_env_step(env, action, count, block, bytes, &results));
  }
  CHECK(reward == 0 && terminated == 0 && truncated == 0 && outcome == MIMO_OUTCOME_NONE);
  OK(mimo_env_time(env, &seconds));
  CHECK(fabs(seconds - 0.1) < 1e-12);

  OK(mimo_env_find(env, MIMO_BODY, "toy", &toy));
  OK(mimo_env_update(env));
  OK(mimo_env_get(env, MIMO_BODY_POSITION, &toy, 1, place, 3));
  CHECK(fabs(place[2] - (2 - 9.81 * 0.005 * 0.005 * 20 * 21 / 2)) < 1e-12);
  OK(mimo_env_clone(env, &twin));
  OK(mimo_env_state_load(env, state, state_bytes, NULL));
  for (i = 0; i < 10; ++i) OK(mimo_env_step(env, action, count, again, bytes, NULL));
  CHECK(memcmp(block, again, bytes) == 0);

  OK(mimo_env_find(env, MIMO_JOINT, "robot:left_elbow", &elbow));
  OK(mimo_env_body_of(env, MIMO_JOINT, elbow, &body));
  OK(mimo_env_set(twin, MIMO_JOINT_LOCK, &elbow, 1, lock, 2));
  OK(mimo_env_get(twin, MIMO_JOINT_LOCK, &elbow, 1, xyz, 2));
  CHECK(xyz[0] == 1 && fabs(xyz[1] + 0.5) < 1e-12);
  OK(mimo_env_get(env, MIMO_JOINT_LOCK, &elbow, 1, xyz, 2));
  CHECK(xyz[0] == 0);
  OK(mimo_env_set(twin, MIMO_WORLD_GRAVITY, NULL, 0, moon, 3));
  OK(mimo_env_get(twin, MIMO_WORLD_GRAVITY, NULL, 0, xyz, 3));
  CHECK(xyz[2] == -1.6);
  OK(mimo_env_get_float(env, MIMO_BODY_POSE | MIMO_NOW, &toy, 1, pose, 7));
  CHECK(fabs(pose[2] - place[2]) < 1e-6);
  mimo_env_destroy(twin);
  CHECK(mimo_env_time(twin, &seconds) == MIMO_E_BAD_HANDLE);
  free(state);
  free(action);
  free(again);
  free(block);
}

static void see(mimo_env* env) {
  static uint8_t rgb[8 * 8 * 4];
  const double point[3] = {1, 0, 0.5};
  double errors[2], pixels[3];
  const char* name = NULL;
  double face = -1;
  int32_t fear = -1;
  size_t contacts = 0;
  mimo_gaze gaze;
  mimo_timing timing;
  mimo_picture_config picture;
  mimo_picture colors;
  OK(mimo_env_get(env, MIMO_AGENT_FACE, NULL, 0, &face, 1));
  OK(mimo_env_name(env, MIMO_FACE, (int32_t)face, &name));
  CHECK(strcmp(name, "enjoyment") == 0);
  OK(mimo_env_find(env, MIMO_FACE, "fear", &fear));
  face = fear;
  OK(mimo_env_set(env, MIMO_AGENT_FACE, NULL, 0, &face, 1));
  memset(&gaze, 0, sizeof gaze);
  gaze.struct_size = sizeof gaze;
  OK(mimo_env_look_at(env, 0, point, MIMO_LOOK_HEAD, errors));
  OK(mimo_env_gaze(env, 0, &gaze));
  CHECK(gaze.meets == 1 && fabs(gaze.point[0] - 1) < 1e-6);
  OK(mimo_picture_config_init(&picture, sizeof picture));
  picture.camera = "wall";
  picture.width = picture.height = 8;
  picture.format = MIMO_PICTURE_RGBA;
  memset(&colors, 0, sizeof colors);
  colors.struct_size = sizeof colors;
  colors.rgb = rgb;
  colors.rgb_bytes = sizeof rgb;
  OK(mimo_env_render(env, &picture, &colors));
  CHECK(rgb[3] == 255);
  OK(mimo_env_project(env, &picture, point, 1, pixels));
  check_receptors(env);
  OK(mimo_env_count(env, MIMO_CONTACT, &contacts));
  memset(&timing, 0, sizeof timing);
  timing.struct_size = sizeof timing;
  OK(mimo_env_timing(env, &timing));
  CHECK(timing.steps == 20);
}

static mimo_status evaluate(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  double* steps = moment->memory;
  (void)env;
  *steps += 1;
  CHECK(moment->struct_size >= sizeof *moment && verdict->struct_size >= sizeof *verdict);
  CHECK(moment->step == (uint64_t)*steps && moment->action == NULL && moment->action_count == 0);
  CHECK(moment->block == NULL && moment->block_bytes == 0 && verdict->goes_on == 0 && verdict->truncated == 0);
  moment->fields[1] = (float)*steps;
  verdict->terms[0] = *steps + 10 * (double)moment->world + 100 * (double)moment->agent;
  verdict->terms[1] = *(const double*)user;
  verdict->outcome = *steps == 2 ? MIMO_OUTCOME_SUCCESS : MIMO_OUTCOME_NONE;
  return MIMO_OK;
}

/* Two worlds with a task of their own. */
static void live_together(mimo_scene* scene) {
  static double thousand = 1000;
  const uint64_t seeds[2] = {1, 2};
  double reward[2] = {0, 0}, parts[4] = {0, 0, 0, 0};
  int32_t outcome[2] = {9, 9};
  uint8_t terminated[2] = {9, 9}, was_reset[2] = {9, 9};
  mimo_status status[2] = {9, 9};
  const double masses[2] = {0.25, 0.5};
  float same_masses[2] = {0, 0};
  int32_t toy = -1;
  size_t worlds = 0;
  mimo_task task;
  mimo_batch_config config;
  mimo_batch_results results;
  mimo_batch_reset_config start;
  mimo_batch* batch = NULL;
  mimo_task_field goal;
  const size_t two = 2;
  const char* const terms[2] = {"steps", "thousand"};
  const mimo_layout* layout = NULL;
  mimo_term term;
  mimo_env* world = NULL;
  OK(mimo_task_field_init(&goal, sizeof goal));
  CHECK(goal.ndim == 0 && goal.low < -1e308 && goal.high > 1e308);
  goal.name = "goal";
  goal.unit = "m";
  goal.frame = "world";
  goal.shape = &two;
  goal.ndim = 1;
  OK(mimo_task_init(&task, sizeof task));
  task.terms = terms;
  task.term_count = 2;
  task.fields = &goal;
  task.field_count = 1;
  task.user = &thousand;
  task.memory_bytes = sizeof(double);
  task.evaluate = evaluate;
  OK(mimo_scene_set_task(scene, &task));
  OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 2;
  config.threads = 2;
  config.autoreset = MIMO_AUTORESET_NEXT_STEP;
  OK(mimo_batch_create(scene, NULL, &config, &batch));
  OK(mimo_batch_size(batch, &worlds, NULL));
  CHECK(worlds == 2);
  OK(mimo_batch_world(batch, 0, &world));
  OK(mimo_batch_layout(batch, &layout));
  CHECK(layout == layout_of(world));
  memset(&term, 0, sizeof term);
  term.struct_size = sizeof term;
  OK(mimo_layout_term(layout, 1, &term));
  CHECK(strcmp(term.name, "thousand") == 0 && term.agent == 0 && field_named(world, "goal").bytes == 8);
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = reward;
  results.terminated = terminated;
  results.outcome = outcome;
  results.agent_count = 2;
  results.terms = parts;
  results.term_count = 4;
  results.status = status;
  results.was_reset = was_reset;
  results.worlds = 2;
  memset(&start, 0, sizeof start);
  start.struct_size = sizeof start;
  start.seeds = seeds;
  start.worlds = 2;
  OK(mimo_batch_reset(batch, &start, NULL, 0));
  OK(mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
  CHECK(reward[0] == 1001 && reward[1] == 1011 && terminated[1] == 0 && status[1] == MIMO_OK);
  OK(mimo_batch_send(batch, NULL, 0, NULL, 0, &results));
  OK(mimo_batch_receive(batch));
  CHECK(reward[1] == 1012 && terminated[1] == 1 && was_reset[1] == 0);
  CHECK(parts[2] == 12 && parts[3] == 1000 && outcome[1] == MIMO_OUTCOME_SUCCESS);
  OK(mimo_batch_step(batch, NULL, 0, NULL, 0, &results));
  CHECK(reward[1] == 0 && was_reset[1] == 1 && outcome[1] == MIMO_OUTCOME_NONE && parts[3] == 0);
  OK(mimo_batch_world(batch, 0, &world));
  OK(mimo_env_find(world, MIMO_BODY, "toy", &toy));
  OK(mimo_batch_set(batch, MIMO_BODY_MASS, &toy, 1, NULL, 0, masses, 2));
  OK(mimo_batch_get_float(batch, MIMO_BODY_MASS, &toy, 1, NULL, 0, same_masses, 2));
  CHECK(same_masses[0] == 0.25F && same_masses[1] == 0.5F);
  mimo_batch_destroy(batch);
}

int main(void) {
  mimo_env_config config;
  mimo_scene* scene;
  mimo_env* env = NULL;
  versions();
  scene = make_scene();
  OK(mimo_env_config_init(&config, sizeof config));
  CHECK(config.struct_size == sizeof config && config.jacobian == MIMO_JACOBIAN_MODEL);
  CHECK((config.render & MIMO_RENDER_SHADOWS) != 0 && config.render_threads == 1);
  config.timing = 1;
  OK(mimo_env_create(scene, &config, &env));
  if (env == NULL) return 1;
  check_fields(env);
  live(env);
  see(env);
  live_together(scene);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return failed == 0 ? 0 : 1;
}
