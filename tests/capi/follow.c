/* mimo_env_follow: the senses and forces of known movements, compared with a fall, with an infant that hangs still, and
 * with a simulated run whose joint positions are followed. */
#include <math.h>

#include "support/capi.h"

enum { MOST = 400, RUN = 40 };

static double positions[RUN + 1][MOST], velocities[RUN + 1][MOST], driven[RUN][MOST], forces[MOST];
static size_t nq, nv;

static mimo_env* make(const char* name) {
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_env_config config;
  mimo_agent_config agent;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = name), &scene));
  CHECK_OK(mimo_scene_default_agent(scene, &agent, sizeof agent));
  agent.vision = 0;
  agent.touch = MIMO_TOUCH_FORCE;
  agent.touch_scale = 0.3;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.frame_skip = 1;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_env_width(env, MIMO_JOINT_POSITION, NULL, 0, &nq));
  CHECK_OK(mimo_env_width(env, MIMO_JOINT_VELOCITY, NULL, 0, &nv));
  CHECK(nq <= MOST && nv <= MOST);
  return env;
}

static void look(const mimo_env* env, int moment) {
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, NULL, 0, positions[moment], nq));
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_VELOCITY, NULL, 0, velocities[moment], nv));
}

static void begin(mimo_env* env) {
  CHECK_OK(mimo_env_set(env, MIMO_JOINT_POSITION, NULL, 0, positions[0], nq));
  CHECK_OK(mimo_env_set(env, MIMO_JOINT_VELOCITY, NULL, 0, velocities[0], nv));
}

static void follow(mimo_env* env, const double* to, void* block, size_t bytes) {
  CHECK_OK(mimo_env_follow(
      env, SIZED(mimo_movement, .positions = to, .position_count = nq, .forces = forces, .force_count = nv), block,
      bytes));
}

static unsigned char* block_of(const mimo_env* env, size_t* bytes) {
  mimo_layout_info info = {.struct_size = sizeof info};
  CHECK_OK(mimo_layout_describe(layout_of(env), &info));
  *bytes = info.block_bytes;
  return calloc(1, info.block_bytes);
}

static double length(const float* vector) {
  return sqrt((double)vector[0] * (double)vector[0] + (double)vector[1] * (double)vector[1] +
              (double)vector[2] * (double)vector[2]);
}

/* Who falls feels no acceleration and is pulled by nothing; who hangs still feels 9.81 m/s2 and is held with its
 * weight. The root is the first joint: position z is its third number. */
static void falling_and_hanging(void) {
  const double step = 0.005, gravity = 9.81;
  size_t bytes = 0;
  mimo_env* env = make("free");
  unsigned char* block = block_of(env, &bytes);
  const float* felt = (const float*)(block + field_of(env, "vestibular/acceleration").offset);
  mimo_agent_info infant = {.struct_size = sizeof infant};
  double speed = 0;
  CHECK_OK(mimo_env_agent(env, 0, &infant));
  look(env, 0);
  memset(velocities[0], 0, sizeof velocities[0]);
  begin(env);
  for (int i = 0; i < 20; ++i) {
    speed -= gravity * step;
    positions[0][2] += speed * step;
    follow(env, positions[0], block, bytes);
    CHECK(length(felt) < 1e-6);
    for (int k = 0; k < 6; ++k) CHECK(fabs(forces[k]) < 1e-8);
  }
  follow(env, positions[0], block, bytes); /* it is stopped */
  CHECK(forces[2] > 10 * infant.mass * gravity);
  follow(env, positions[0], block, bytes);
  CHECK(fabs(forces[2] - infant.mass * gravity) < 1e-6 && fabs(forces[0]) < 1e-6 && fabs(forces[1]) < 1e-6);
  CHECK(fabs(length(felt) - gravity) < 1e-5);
  free(block);
  mimo_env_destroy(env);
}

static double actuator_on(const mimo_env* env, const char* actuator) {
  double gear = 0, force = 0;
  int32_t id = -1;
  CHECK_OK(mimo_env_find(env, MIMO_ACTUATOR, actuator, &id));
  CHECK_OK(mimo_env_get(env, MIMO_ACTUATOR_GEAR, &id, 1, &gear, 1));
  CHECK_OK(mimo_env_get(env, MIMO_ACTUATOR_FORCE, &id, 1, &force, 1));
  return gear * force;
}

/* Number of a joint's degree of freedom: it is counted as joints are. */
static size_t degree(const mimo_env* env, const char* joint) {
  int32_t id = -1;
  size_t before = 0, width = 0;
  CHECK_OK(mimo_env_find(env, MIMO_JOINT, joint, &id));
  for (int32_t i = 0; i < id; ++i) {
    CHECK_OK(mimo_env_width(env, MIMO_JOINT_VELOCITY, &i, 1, &width));
    before += width;
  }
  return before;
}

static void same_senses(const mimo_env* env, const char* name, const unsigned char* then, const unsigned char* now,
                        double tolerance) {
  const mimo_field it = field_of(env, name);
  const float *a = (const float*)(then + it.offset), *b = (const float*)(now + it.offset);
  double worst = 0;
  for (size_t i = 0; i < it.bytes / sizeof *a; ++i) worst = fmax(worst, fabs((double)a[i] - (double)b[i]));
  if (worst > tolerance) printf("%s: %g\n", name, worst);
  CHECK(worst <= tolerance);
}

/* The joint positions of a run of an infant that falls on a floor and moves, followed: the same senses, and at the
 * elbow the torque that its motor had, to rounding; contacts to the tolerance of the run's solver. */
static void a_simulated_run_is_followed(void) {
  static unsigned char* blocks[RUN];
  size_t bytes = 0, elbow = 0;
  mimo_env *env = make("benchmark"), *other = make("benchmark");
  float action[100] = {0};
  mimo_layout_info info = {.struct_size = sizeof info};
  CHECK_OK(mimo_layout_describe(layout_of(env), &info));
  CHECK(info.actions <= 100);
  elbow = degree(env, "robot:right_elbow");
  CHECK_OK(mimo_env_reset(env, SEED(3), NULL, 0));
  CHECK_OK(mimo_env_reset(other, SEED(3), NULL, 0));
  for (int i = 0; i < 100; ++i) CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL)); /* down to the floor */
  look(env, 0);
  for (int moment = 0; moment < RUN; ++moment) {
    for (size_t i = 0; i < info.actions; ++i) action[i] = 0.3f * sinf(0.2f * (float)moment + (float)i);
    blocks[moment] = block_of(env, &bytes);
    CHECK_OK(mimo_env_step(env, action, info.actions, blocks[moment], bytes, NULL));
    driven[moment][0] = actuator_on(env, "act:right_elbow");
    look(env, moment + 1);
  }
  begin(other);
  unsigned char* now = block_of(other, &bytes);
  for (int moment = 0; moment < RUN; ++moment) {
    follow(other, positions[moment + 1], now, bytes);
    CHECK(fabs(forces[elbow] - driven[moment][0]) < 1e-9);
    for (int k = 0; k < 6; ++k) CHECK(fabs(forces[k]) < 1e-6); /* nothing but the floor carries it */
    same_senses(env, "proprioception/position", blocks[moment], now, 0);
    same_senses(env, "proprioception/velocity", blocks[moment], now, 1e-6);
    same_senses(env, "vestibular/acceleration", blocks[moment], now, 1e-4);
    same_senses(env, "touch/force", blocks[moment], now, 1e-4);
    free(blocks[moment]);
  }
  free(now);
  mimo_env_destroy(env);
  mimo_env_destroy(other);
}

static void bad_movements(void) {
  mimo_env* env = make("free");
  mimo_movement movement = {.struct_size = sizeof movement, .positions = positions[0], .position_count = nq};
  look(env, 0);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "movement is NULL", mimo_env_follow(env, NULL, NULL, 0));
  movement.position_count = nq - 1;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "position_count", mimo_env_follow(env, &movement, NULL, 0));
  movement.position_count = nq;
  movement.forces = forces;
  movement.force_count = nv - 1;
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "forces", mimo_env_follow(env, &movement, NULL, 0));
  movement.forces = NULL;
  movement.force_count = 0;
  positions[0][8] = NAN;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "positions[8] is nan", mimo_env_follow(env, &movement, NULL, 0));
  positions[0][8] = 0;
  for (int i = 3; i < 7; ++i) positions[0][i] = 0;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "positions[3]", mimo_env_follow(env, &movement, NULL, 0));
  movement.positions = NULL;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "positions is NULL", mimo_env_follow(env, &movement, NULL, 0));
  mimo_env_destroy(env);
}

static int all_are(const unsigned char* bytes, size_t count, unsigned char value) {
  for (size_t i = 0; i < count; ++i) {
    if (bytes[i] != value) return 0;
  }
  return 1;
}

/* Positions that are numbers, but that no step of MuJoCo takes (mjMAXVAL, 1e10), or that nothing could reach in a step:
 * the world fails, nothing is written, and a reset helps. */
static void absurd_movements(void) {
  const double absurd[] = {1e12, -1e12, 1e100, 1e300, 9e9, -1e8};
  size_t bytes = 0;
  mimo_env* env = make("free");
  unsigned char* block = block_of(env, &bytes);
  double position[7], felt[7];
  int32_t root = 0;
  for (size_t i = 0; i < sizeof absurd / sizeof *absurd; ++i) {
    for (size_t place = 0; place < nq; place += 7) {
      CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
      look(env, 0);
      positions[0][place] = absurd[i];
      memset(block, 0x55, bytes);
      memset(forces, 0x55, sizeof forces);
      CHECK_FAILS(MIMO_E_SIMULATION, "huge value in Q",
                  mimo_env_follow(env,
                                  SIZED(mimo_movement, .positions = positions[0], .position_count = nq,
                                        .forces = forces, .force_count = nv),
                                  block, bytes));
      CHECK(all_are(block, bytes, 0x55) && all_are((const unsigned char*)forces, sizeof forces, 0x55));
      CHECK_FAILS(MIMO_E_SIMULATION, "failed before", mimo_env_observe(env, block, bytes));
    }
    /* Set by hand, and then looked at. */
    CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
    CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, &root, 1, position, 7));
    memcpy(felt, position, sizeof felt);
    position[1] = absurd[i];
    CHECK_OK(mimo_env_set(env, MIMO_JOINT_POSITION, &root, 1, position, 7));
    memset(block, 0x55, bytes);
    if (fabs(absurd[i]) <= 1e10) {
      CHECK_OK(mimo_env_observe(env, block, bytes));
      continue;
    }
    CHECK_FAILS(MIMO_E_SIMULATION, "huge value in QPOS at 1", mimo_env_observe(env, block, bytes));
    CHECK(all_are(block, bytes, 0x55));
    CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
    memset(position, 0, sizeof position);
    position[4] = absurd[i];
    CHECK_OK(mimo_env_set(env, MIMO_JOINT_VELOCITY, &root, 1, position, 6));
    CHECK_FAILS(MIMO_E_SIMULATION, "huge value in QVEL at 4", mimo_env_observe(env, block, bytes));
    CHECK(all_are(block, bytes, 0x55));
    CHECK_OK(mimo_env_reset(env, NULL, block, bytes));
    CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, &root, 1, position, 7));
    CHECK(memcmp(position, felt, sizeof felt) == 0);
  }
  free(block);
  mimo_env_destroy(env);
}

int main(void) {
  absurd_movements();
  falling_and_hanging();
  a_simulated_run_is_followed();
  bad_movements();
  return failures();
}
