/* Looking ahead: from where it is, the infant tries five futures, each with another constant action, and takes the one
 * in which its right hand ends up nearest to the ball. The futures are tried in the world itself: its state is saved
 * before, and loaded again after each of them.
 *
 *   cc plan.c $(pkg-config --cflags --libs mimo) -lm && ./a.out
 */
#include <math.h>
#include <mimo/mimo.h>
#include <stdio.h>
#include <stdlib.h>

enum { FUTURES = 5, AHEAD = 10, DECISIONS = 20 };

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

static double distance(mimo_env* env, const int32_t bodies[2]) {
  double at[6];
  check(mimo_env_get(env, MIMO_BODY_POSITION, bodies, 2, at, 6));
  return sqrt((at[0] - at[3]) * (at[0] - at[3]) + (at[1] - at[4]) * (at[1] - at[4]) +
              (at[2] - at[5]) * (at[2] - at[5]));
}

static void act(mimo_env* env, const float* action, size_t count, int steps) {
  while (steps-- > 0) check(mimo_env_step(env, action, count, NULL, 0, NULL));
}

int main(void) {
  mimo_env* env;
  void* present;
  float *actions, *best;
  size_t count, bytes, i;
  int32_t hand_and_ball[2];
  double nearest, first, reached;
  const mimo_reset_config seeded = {.struct_size = sizeof seeded, .seeded = 1, .seed = 1};
  const mimo_layout* layout;
  mimo_layout_info sizes;
  int decision, future;

  check(mimo_env_make("reach", &env));
  check(mimo_env_reset(env, &seeded, NULL, 0));
  check(mimo_env_find(env, MIMO_BODY, "right_fingers", &hand_and_ball[0]));
  check(mimo_env_find(env, MIMO_BODY, "target", &hand_and_ball[1]));
  sizes.struct_size = sizeof sizes;
  check(mimo_env_layout(env, &layout));
  check(mimo_layout_describe(layout, &sizes));
  count = sizes.actions;
  check(mimo_env_state_size(env, &bytes));
  present = malloc(bytes);
  actions = malloc(FUTURES * count * sizeof *actions);
  if (present == NULL || actions == NULL) return 1;

  first = distance(env, hand_and_ball);
  for (decision = 0; decision < DECISIONS; ++decision) {
    check(mimo_env_state_save(env, present, bytes));
    nearest = HUGE_VAL;
    best = actions;
    for (future = 0; future < FUTURES; ++future) {
      float* action = actions + future * count;
      for (i = 0; i < count; ++i) action[i] = (float)rand() / (float)RAND_MAX * 2 - 1;
      act(env, action, count, AHEAD);
      if (distance(env, hand_and_ball) < nearest) {
        nearest = distance(env, hand_and_ball);
        best = action;
      }
      check(mimo_env_state_load(env, present, bytes, NULL)); /* as if nothing had happened, to the last bit */
    }
    act(env, best, count, AHEAD);
    reached = distance(env, hand_and_ball);
    if (reached != nearest) return 1; /* the future came as foreseen */
  }
  printf("from %.3f m to %.3f m in %.1f s\n", first, reached, DECISIONS * AHEAD * 0.01);

  free(actions);
  free(present);
  mimo_env_destroy(env);
  return 0;
}
