/* A body map: which parts of MIMo felt what in one episode.
 *
 *   cc body_map.c -lm $(pkg-config --cflags --libs mimo) && ./a.out
 *
 * MIMo falls to the floor and struggles. For each part of the body we add up how hard it was pressed (the impulse, in
 * newton seconds), and draw that as bars and as a map of the body.
 */
#include <math.h>
#include <mimo/mimo.h>
#include <stdio.h>
#include <stdlib.h>

#define MAX_BODIES 256
#define STEPS 300 /* of 10 ms */

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

/* One infant whose skin gives the normal force alone; the whole eyeballs are left out. */
static mimo_env* make_world(void) {
  mimo_scene_config scene_config;
  mimo_agent_config agent;
  mimo_scene* scene;
  mimo_env* env;
  size_t number;

  check(mimo_scene_config_init(&scene_config, sizeof scene_config));
  scene_config.name = "benchmark";
  check(mimo_scene_create(&scene_config, &scene));
  check(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  agent.touch = MIMO_TOUCH_NORMAL_FORCE;
  check(mimo_scene_add_agent(scene, &agent, &number));
  check(mimo_scene_set_touch(scene, number, "left_eye", 0)); /* no skin there */
  check(mimo_scene_set_touch(scene, number, "right_eye", 0));
  check(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  return env;
}

/* Adds the forces of this moment, times its length, to the parts that felt them. */
static void add_up(const float* force, const double* bodies, size_t receptors, double* impulse) {
  size_t i;
  for (i = 0; i < receptors; ++i) impulse[(int)bodies[i]] += (double)force[i] * 0.01;
}

static char shade(const mimo_env* env, const double* impulse, double most, const char* body) {
  static const char kShades[] = ".:-=+*#%@";
  int32_t id;
  check(mimo_env_find(env, MIMO_BODY, body, &id));
  return kShades[(int)ceil(8 * sqrt(impulse[id] / most))];
}

/* Seen from the front: MIMo's right is on the left. */
static void print_map(const mimo_env* env, const double* impulse, double most) {
  static const char* const kParts[] = {"head",
                                       "right_upper_arm",
                                       "right_lower_arm",
                                       "right_hand",
                                       "right_fingers",
                                       "left_upper_arm",
                                       "left_lower_arm",
                                       "left_hand",
                                       "left_fingers",
                                       "upper_body",
                                       "lower_body",
                                       "hip",
                                       "right_upper_leg",
                                       "right_lower_leg",
                                       "right_foot",
                                       "right_toes",
                                       "left_upper_leg",
                                       "left_lower_leg",
                                       "left_foot",
                                       "left_toes"};
  static const char* const kMap[] = {"          AAAA          ", "         AAAAAA         ", "          AAAA          ",
                                     "       BJJJJJJJJF       ", "      BB JJJJJJ FF      ", "     CC  JJJJJJ  GG     ",
                                     "    CC   KKKKKK   GG    ", "   DD    KKKKKK    HH   ", "  EE     LLLLLL     II  ",
                                     "         MMM QQQ        ", "         MMM QQQ        ", "         NN   RR        ",
                                     "         NN   RR        ", "        POO   SST       "};
  size_t row, column;
  for (row = 0; row < sizeof kMap / sizeof *kMap; ++row) {
    for (column = 0; kMap[row][column] != '\0'; ++column) {
      const char part = kMap[row][column];
      putchar(part == ' ' ? ' ' : shade(env, impulse, most, kParts[part - 'A']));
    }
    putchar('\n');
  }
}

static void print_bars(const mimo_env* env, const double* impulse, double most) {
  int32_t body;
  for (body = 0; body < MAX_BODIES; ++body) {
    const char* name;
    int bar;
    if (impulse[body] == 0) continue;
    check(mimo_env_name(env, MIMO_BODY, body, &name));
    printf("%-16s %7.2f Ns ", name, impulse[body]);
    for (bar = 0; bar < (int)(40 * impulse[body] / most); ++bar) putchar('#');
    putchar('\n');
  }
}

int main(void) {
  mimo_env* env = make_world();
  const mimo_reset_config seeded = {.struct_size = sizeof seeded, .seeded = 1, .seed = 1};
  double impulse[MAX_BODIES] = {0}, most = 0;
  const mimo_layout* layout;
  mimo_layout_info sizes;
  size_t touch, i;
  unsigned char* block;
  double* bodies;
  float* action;
  mimo_field force;
  int step;

  sizes.struct_size = sizeof sizes;
  force.struct_size = sizeof force;
  check(mimo_env_layout(env, &layout));
  check(mimo_layout_describe(layout, &sizes));
  check(mimo_layout_find(layout, "touch/force", &touch));
  check(mimo_layout_field(layout, touch, &force));
  block = malloc(sizes.block_bytes);
  bodies = malloc(force.receptors * sizeof *bodies);
  action = malloc(sizes.actions * sizeof *action);
  if (block == NULL || bodies == NULL || action == NULL) return 1;
  check(mimo_layout_receptors(layout, touch, MIMO_RECEPTOR_BODY, bodies, force.receptors));

  check(mimo_env_reset(env, &seeded, block, sizes.block_bytes));
  for (step = 0; step < STEPS; ++step) {
    for (i = 0; i < sizes.actions; ++i) action[i] = (float)rand() / (float)RAND_MAX * 2 - 1;
    check(mimo_env_step(env, action, sizes.actions, block, sizes.block_bytes, NULL));
    add_up((const float*)(const void*)(block + force.offset), bodies, force.receptors, impulse);
  }
  for (i = 0; i < MAX_BODIES; ++i) most = fmax(most, impulse[i]);

  printf("%zu receptors; what they felt in %.1f s:\n\n", force.receptors, STEPS * 0.01);
  print_bars(env, impulse, most);
  putchar('\n');
  print_map(env, impulse, most);

  free(action);
  free(bodies);
  free(block);
  mimo_env_destroy(env);
  return most > 0 ? 0 : 1; /* somebody who lies on the floor feels it */
}
