/* Eight worlds of one scene whose infants' arms weigh differently: the same actions, other movements. Halfway all are
 * saved; a second future from there is the first one again, to the last bit. */
#include <mimo/mimo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORLDS = 8, STEPS = 50 };

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

static void step(mimo_batch* batch, size_t actions, int steps) {
  float* action = calloc(WORLDS * actions, sizeof *action);
  size_t i;
  for (i = 0; i < WORLDS * actions; ++i) action[i] = 0.2f;
  while (steps-- > 0) check(mimo_batch_step(batch, action, WORLDS * actions, NULL, 0, NULL));
  free(action);
}

int main(void) {
  mimo_scene_config room;
  mimo_agent_config infant;
  mimo_batch_config many;
  mimo_layout_info sizes = {.struct_size = sizeof sizes};
  const mimo_layout* layout = NULL;
  mimo_scene* scene = NULL;
  mimo_batch* batch = NULL;
  mimo_env* first = NULL; /* ids are the same in all worlds */
  int32_t arm = 0, hand = 0;
  double mass[WORLDS], there[3 * WORLDS], again[3 * WORLDS];
  size_t bytes = 0, i;
  void* states;

  check(mimo_scene_config_init(&room, sizeof room));
  room.name = "free";
  check(mimo_scene_create(&room, &scene));
  check(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.vision = 0;
  check(mimo_scene_add_agent(scene, &infant, NULL));
  check(mimo_batch_config_init(&many, sizeof many));
  many.worlds = WORLDS;
  check(mimo_batch_create(scene, NULL, &many, &batch));
  mimo_scene_destroy(scene);
  check(mimo_batch_layout(batch, &layout));
  check(mimo_layout_describe(layout, &sizes));
  check(mimo_batch_world(batch, 0, &first));
  check(mimo_env_find(first, MIMO_BODY, "left_lower_arm", &arm));
  check(mimo_env_find(first, MIMO_BODY, "left_hand", &hand));

  /* A mask of NULL means all worlds; `worlds` is then their number, or 0. */
  check(mimo_batch_get(batch, MIMO_BODY_MASS, &arm, 1, NULL, 0, mass, WORLDS));
  for (i = 0; i < WORLDS; ++i) mass[i] *= 0.8 + 0.4 * (double)i / (WORLDS - 1);
  check(mimo_batch_set(batch, MIMO_BODY_MASS, &arm, 1, NULL, 0, mass, WORLDS));
  check(mimo_batch_reset(batch, NULL, NULL, 0)); /* what was set stays */

  step(batch, sizes.actions, STEPS);
  check(mimo_batch_state_size(batch, &bytes));
  states = malloc(WORLDS * bytes);
  check(mimo_batch_state_save(batch, NULL, 0, states, WORLDS * bytes));
  step(batch, sizes.actions, STEPS);
  check(mimo_batch_get(batch, MIMO_BODY_POSITION | MIMO_NOW, &hand, 1, NULL, 0, there, 3 * WORLDS));
  check(mimo_batch_state_load(batch, NULL, 0, states, WORLDS * bytes, NULL));
  step(batch, sizes.actions, STEPS);
  check(mimo_batch_get(batch, MIMO_BODY_POSITION | MIMO_NOW, &hand, 1, NULL, 0, again, 3 * WORLDS));

  for (i = 0; i < WORLDS; ++i)
    printf("lower arm %.3f kg: the hand at %.4f, %.4f, %.4f m\n", mass[i], there[3 * i], there[3 * i + 1],
           there[3 * i + 2]);
  printf("the second future is %s\n", memcmp(there, again, sizeof there) == 0 ? "the same" : "another one");
  free(states);
  mimo_batch_destroy(batch);
  return memcmp(there, again, sizeof there) != 0;
}
