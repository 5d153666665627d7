/* One episode: MIMo among two objects moves at random for a second, and we look at what its senses say.
 *
 *   cc hello.c $(pkg-config --cflags --libs mimo) && ./a.out
 */
#include <mimo/mimo.h>
#include <stdio.h>
#include <stdlib.h>

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

/* A field that no sense gives: where the left hand is, as the head sees it. */
static void watch_hand(mimo_scene* scene) {
  const char* hand = "left_hand";
  mimo_field_config field;
  check(mimo_field_config_init(&field, sizeof field));
  field.name = "hand/position";
  field.quantity = MIMO_BODY_POSITION;
  field.elements = &hand;
  field.element_count = 1;
  field.relative_to = "head";
  check(mimo_scene_add_field(scene, &field));
}

/* A scene with one infant. The eyes are off here: the example then also runs where there is no OSMesa. */
static mimo_env* make_world(void) {
  mimo_scene_config scene_config;
  mimo_agent_config agent_config;
  mimo_scene* scene;
  mimo_env* env;

  check(mimo_scene_config_init(&scene_config, sizeof scene_config));
  scene_config.name = "benchmark";
  check(mimo_scene_create(&scene_config, &scene));

  check(mimo_agent_config_init(&agent_config, sizeof agent_config));
  agent_config.vision = 0;
  check(mimo_scene_add_agent(scene, &agent_config, NULL));
  watch_hand(scene);

  check(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene); /* the environment does not need it any more */
  return env;
}

int main(void) {
  mimo_env* env = make_world();
  const mimo_reset_config seeded = {.struct_size = sizeof seeded, .seeded = 1, .seed = 42};
  const mimo_layout* layout;
  mimo_layout_info sizes;
  size_t i;
  unsigned char* block;
  float* action;
  double seconds;
  int step;

  sizes.struct_size = sizeof sizes;
  check(mimo_env_layout(env, &layout));
  check(mimo_layout_describe(layout, &sizes));
  block = malloc(sizes.block_bytes);
  action = malloc(sizes.actions * sizeof *action);
  if (block == NULL || action == NULL) return 1;

  check(mimo_env_reset(env, &seeded, block, sizes.block_bytes));
  for (step = 0; step < 100; ++step) { /* 100 steps of 10 ms */
    for (i = 0; i < sizes.actions; ++i) action[i] = (float)rand() / (float)RAND_MAX * 2 - 1;
    check(mimo_env_step(env, action, sizes.actions, block, sizes.block_bytes, NULL));
  }

  check(mimo_env_time(env, &seconds));
  printf("after %.2f s:\n", seconds);
  for (i = 0; i < sizes.fields; ++i) {
    mimo_field field;
    field.struct_size = sizeof field;
    check(mimo_layout_field(layout, i, &field));
    if (field.dtype == MIMO_F32) {
      printf("%-32s %4zu values, the first is %g %s\n", field.name, field.bytes / sizeof(float),
             (double)*(const float*)(const void*)(block + field.offset), field.unit);
    }
  }

  free(action);
  free(block);
  mimo_env_destroy(env);
  return 0;
}
