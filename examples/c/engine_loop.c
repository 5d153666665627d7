/* A game's loop with an infant in it: 60 pictures a second are drawn, and the infant lives in steps of its own.
 *
 *   cc engine_loop.c $(pkg-config --cflags --libs mimo) -lm && ./a.out
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

/* Where your engine draws a shape: its place and turn in your world, here with y up, as Unity has it. */
static void draw(size_t shape, const float pose[7]) {
  (void)shape;
  (void)pose;
}

/* What your game makes the infant do: here it waves its arms. */
static void think(double time, float* action, size_t actions) {
  for (size_t i = 0; i < actions; ++i) action[i] = 0.3f * (float)sin(6 * time + (double)i);
}

int main(void) {
  mimo_env* env;
  const mimo_layout* layout;
  mimo_layout_info sizes = {.struct_size = sizeof sizes};
  size_t shapes, touched = 0, touch;
  double lived = 0;
  mimo_field field = {.struct_size = sizeof field};

  /* Once, while your game loads: a world, memory for what the infant senses, and the number of shapes to draw. */
  check(mimo_env_make("benchmark", &env));
  check(mimo_env_layout(env, &layout));
  check(mimo_layout_describe(layout, &sizes));
  check(mimo_layout_find(layout, "touch/force", &touch));
  check(mimo_layout_field(layout, touch, &field));
  check(mimo_env_count(env, MIMO_GEOM, &shapes));
  unsigned char* block = malloc(sizes.block_bytes);
  float* action = malloc(sizes.actions * sizeof *action);
  float* poses = malloc(shapes * 7 * sizeof *poses);
  if (block == NULL || action == NULL || poses == NULL) return 1;
  check(mimo_env_reset(env, NULL, block, sizes.block_bytes));

  for (int frame = 1; frame <= 120; ++frame) { /* your loop: two seconds of it */
    for (; lived + sizes.step_seconds <= frame / 60.0 + 1e-9; lived += sizes.step_seconds) {
      think(lived, action, sizes.actions);
      check(mimo_env_step(env, action, sizes.actions, block, sizes.block_bytes, NULL));
    }
    check(mimo_env_poses(env, MIMO_GEOM, MIMO_AXES_UNITY, poses, shapes * 7));
    for (size_t shape = 0; shape < shapes; ++shape) draw(shape, poses + 7 * shape);
  }

  const float* force = (const float*)(const void*)(block + field.offset);
  for (size_t i = 0; i < field.bytes / sizeof *force; i += 3)
    touched += force[i] != 0 || force[i + 1] != 0 || force[i + 2] != 0;
  printf("lived %.2f s, drew %zu shapes 120 times\n", lived, shapes);
  printf("%zu of %zu sensors of its skin feel something\n", touched, field.bytes / sizeof *force / 3);
  free(poses);
  free(action);
  free(block);
  mimo_env_destroy(env);
  return 0;
}
