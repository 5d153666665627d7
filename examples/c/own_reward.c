/* A reward of one's own: MIMo is to bring its right hand to its mouth. The library simulates; what is rewarded is
 * computed here, from positions that are looked up by name once and read after every step.
 *
 *   cc own_reward.c $(pkg-config --cflags --libs mimo) -lm && ./a.out
 */
#include <math.h>
#include <mimo/mimo.h>
#include <stdio.h>
#include <stdlib.h>

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

/* The body and the room of the scene "reach", but no task: rewards of the library are 0 and nothing ends. The arm is
 * moved by target angles from -1 to 1. */
static mimo_env* make_world(void) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_env_config config;
  mimo_scene* scene;
  mimo_env* env;

  check(mimo_scene_config_init(&room, sizeof room));
  room.name = "reach";
  check(mimo_scene_create(&room, &scene));

  check(mimo_scene_default_agent(scene, &agent, sizeof agent));
  agent.acts = MIMO_ACT_RIGHT_ARM;
  agent.actuation = MIMO_ACTUATION_POSITION;
  agent.normalize_actions = 1;
  check(mimo_scene_add_agent(scene, &agent, NULL));

  check(mimo_env_config_init(&config, sizeof config));
  config.task = "none";
  check(mimo_env_create(scene, &config, &env));
  mimo_scene_destroy(scene);
  return env;
}

/* Minus the distance of hand and mouth, m. */
static double reward(const mimo_env* env, const int32_t bodies[2]) {
  const double mouth[3] = {0.075, 0, 0.045}; /* from the head's origin; the head looks ahead here */
  double place[6], square = 0;
  int axis;
  check(mimo_env_get(env, MIMO_BODY_POSITION, bodies, 2, place, 6));
  for (axis = 0; axis < 3; ++axis) {
    const double d = place[axis] - (place[3 + axis] + mouth[axis]);
    square += d * d;
  }
  return -sqrt(square);
}

/* The return of a second towards one posture of the arm. */
static double try_posture(mimo_env* env, const int32_t bodies[2], const float* posture, size_t count) {
  const mimo_reset_config seeded = {.struct_size = sizeof seeded, .seeded = 1, .seed = 1};
  double sum = 0;
  int step;
  check(mimo_env_reset(env, &seeded, NULL, 0));
  for (step = 0; step < 100; ++step) {
    check(mimo_env_step(env, posture, count, NULL, 0, NULL));
    sum += reward(env, bodies);
  }
  return sum;
}

/* Learning at its simplest: change the best posture a little, keep the change if it pays. */
int main(void) {
  mimo_env* env = make_world();
  float best[4] = {0, 0, 0, 0}, trial[4];
  double best_sum, first_sum;
  int32_t bodies[2];
  const mimo_layout* layout;
  mimo_layout_info sizes;
  size_t count, i;
  int round;

  sizes.struct_size = sizeof sizes;
  check(mimo_env_layout(env, &layout));
  check(mimo_layout_describe(layout, &sizes));
  count = sizes.actions;
  if (count != 4) return 1;
  check(mimo_env_find(env, MIMO_BODY, "right_fingers", &bodies[0]));
  check(mimo_env_find(env, MIMO_BODY, "head", &bodies[1]));

  first_sum = best_sum = try_posture(env, bodies, best, count);
  for (round = 0; round < 60; ++round) {
    double sum;
    for (i = 0; i < count; ++i) trial[i] = best[i] + 0.6f * ((float)rand() / (float)RAND_MAX - 0.5f);
    sum = try_posture(env, bodies, trial, count);
    if (sum <= best_sum) continue;
    best_sum = sum;
    for (i = 0; i < count; ++i) best[i] = trial[i];
  }
  printf("mean distance of hand and mouth: %.3f m at first, %.3f m after %d trials\n", -first_sum / 100,
         -best_sum / 100, round);
  mimo_env_destroy(env);
  return best_sum > first_sum ? 0 : 1;
}
