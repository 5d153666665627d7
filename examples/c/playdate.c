/* Two infants: Anna smiles and Ben sees it; their hands meet and both feel it.
 *
 *   cc playdate.c -lm $(pkg-config --cflags --libs mimo) && ./a.out
 *
 * They sit face to face, as the scene "playdate" has them. Ben looks at Anna's head; two pictures of his left eye,
 * before and after her smile, differ on her head and hardly anywhere else. Then her right hand and his left one are led
 * to each other. What her skin feels of his hand and his of hers is opposite: the sum of all these forces is zero.
 */
#include <math.h>
#include <mimo/experimental.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PIXELS (128 * 128)
#define PARTS 2
#define MAX_RECEPTORS 8192

enum { ANNA, BEN };
static const char* const names[] = {"anna", "ben"};
static const char* const hands[] = {"right", "left"}; /* across the toy from each other */

typedef struct {
  mimo_env* env;
  const mimo_layout* layout;
  unsigned char* block;
  size_t bytes;
} world;

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(1);
}

static void insist(int condition, const char* what) {
  if (condition) return;
  fprintf(stderr, "not so: %s\n", what);
  exit(1);
}

/* Both infants of the scene, with the same senses. */
static world make_world(void) {
  mimo_scene_config room;
  mimo_agent_config infant;
  mimo_scene* scene;
  mimo_layout_info sizes;
  world w;

  check(mimo_scene_config_init(&room, sizeof room));
  room.name = "playdate";
  check(mimo_scene_create(&room, &scene));
  check(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.vision = MIMO_VISION_RGB | MIMO_VISION_SEGMENTATION;
  infant.vision_width = infant.vision_height = 128;
  infant.touch_frame = MIMO_FRAME_WORLD; /* so that forces on different bodies can be added */
  check(mimo_scene_add_agents(scene, &infant, NULL));
  check(mimo_env_create(scene, NULL, &w.env));
  mimo_scene_destroy(scene);
  check(mimo_env_layout(w.env, &w.layout));
  sizes.struct_size = sizeof sizes;
  check(mimo_layout_describe(w.layout, &sizes));
  w.bytes = sizes.block_bytes;
  w.block = malloc(w.bytes);
  return w;
}

static size_t index_of(const world* w, const char* field) {
  size_t index;
  check(mimo_layout_find(w->layout, field, &index));
  return index;
}

/* Where a field of the observation starts. */
static const void* field(const world* w, const char* name) {
  mimo_field f;
  f.struct_size = sizeof f;
  check(mimo_layout_field(w->layout, index_of(w, name), &f));
  return w->block + f.offset;
}

static int32_t find(const world* w, int32_t kind, const char* name) {
  int32_t id;
  check(mimo_env_find(w->env, kind, name, &id));
  return id;
}

/* ---- A smile ---- */

static void smile(world* w) {
  const int32_t head = find(w, MIMO_GEOM, "anna/head");
  const unsigned char* picture = field(w, "ben/vision/eye_left");
  const int32_t* geoms = field(w, "ben/vision/eye_left_segmentation");
  unsigned char* before = malloc(3 * PIXELS);
  const double enjoyment = find(w, MIMO_FACE, "enjoyment");
  const int32_t anna = ANNA;
  double place[3];
  int i, on_head = 0, changed = 0, elsewhere = 0;

  check(mimo_env_get(w->env, MIMO_GEOM_POSITION, &head, 1, place, 3));
  check(mimo_env_look_at(w->env, BEN, place, MIMO_LOOK_HEAD, NULL));
  check(mimo_env_observe(w->env, w->block, w->bytes));
  memcpy(before, picture, 3 * PIXELS);
  check(mimo_env_set(w->env, MIMO_AGENT_FACE, &anna, 1, &enjoyment, 1));
  check(mimo_env_observe(w->env, w->block, w->bytes));
  for (i = 0; i < PIXELS; ++i) {
    const int differs = memcmp(picture + 3 * i, before + 3 * i, 3) != 0;
    if (geoms[i] == head) ++on_head;
    if (geoms[i] == head && differs) ++changed;
    if (geoms[i] != head && differs) ++elsewhere;
  }
  printf("Anna's head fills %d of the %d pixels of Ben's left eye.\n", on_head, PIXELS);
  printf("Her smile changes %d of them, and %d elsewhere.\n", changed, elsewhere);
  insist(geoms[64 * 128 + 64] == head, "Ben looks at Anna's head");
  insist(on_head > 500 && changed > 50, "Ben sees the smile");
  insist(elsewhere * 20 < changed, "nothing but her face has changed"); /* pixels at its edge are mixed */
  free(before);
}

/* ---- A touch ---- */

/* What an infant's hand and fingers feel, all receptors together, N. */
static void felt_by_hand(const world* w, int infant, double* sum) {
  static double bodies[MAX_RECEPTORS];
  int32_t parts[PARTS];
  char name[64];
  const float* force;
  size_t receptors, i;
  snprintf(name, sizeof name, "%s/%s_hand", names[infant], hands[infant]);
  parts[0] = find(w, MIMO_BODY, name);
  snprintf(name, sizeof name, "%s/%s_fingers", names[infant], hands[infant]);
  parts[1] = find(w, MIMO_BODY, name);
  snprintf(name, sizeof name, "%s/touch/force", names[infant]);
  force = field(w, name);
  check(mimo_layout_receptor_width(w->layout, index_of(w, name), MIMO_RECEPTOR_BODY, &receptors));
  insist(receptors <= MAX_RECEPTORS, "there is room for all receptors");
  check(mimo_layout_receptors(w->layout, index_of(w, name), MIMO_RECEPTOR_BODY, bodies, receptors));
  sum[0] = sum[1] = sum[2] = 0;
  for (i = 0; i < receptors; ++i) {
    if ((int32_t)bodies[i] != parts[0] && (int32_t)bodies[i] != parts[1]) continue;
    sum[0] += force[3 * i], sum[1] += force[3 * i + 1], sum[2] += force[3 * i + 2];
  }
}

/* Angles of an arm that is stretched out over the toy. */
static const struct {
  const char* joint;
  double angle;
} stretched[] = {{"shoulder_horizontal", 1.18},
                 {"shoulder_ad_ab", 0.88},
                 {"shoulder_rotation", -0.43},
                 {"elbow", -0.5},
                 {"hand1", -0.02},
                 {"hand2", 0.3},
                 {"hand3", 0.07}};
enum { JOINTS = sizeof stretched / sizeof *stretched };

static void touch(world* w) {
  int32_t joints[2][JOINTS];
  double start[2][JOINTS], anna[3], ben[3], size, sum = 0;
  int infant, j, step, i;
  for (infant = ANNA; infant <= BEN; ++infant) {
    for (j = 0; j < JOINTS; ++j) {
      char name[64];
      snprintf(name, sizeof name, "%s/robot:%s_%s", names[infant], hands[infant], stretched[j].joint);
      joints[infant][j] = find(w, MIMO_JOINT, name);
    }
    check(mimo_env_get(w->env, MIMO_JOINT_POSITION, joints[infant], JOINTS, start[infant], JOINTS));
  }
  /* In one second, joint by joint, as one would lead them by the hand. */
  for (step = 1; step <= 120; ++step) {
    const double share = step < 100 ? step / 100.0 : 1;
    for (infant = ANNA; infant <= BEN; ++infant) {
      for (j = 0; j < JOINTS; ++j) {
        const double angle = start[infant][j] + share * (stretched[j].angle - start[infant][j]);
        const double lock[2] = {1, angle}; /* held there */
        check(mimo_env_set(w->env, MIMO_JOINT_LOCK, &joints[infant][j], 1, lock, 2));
      }
    }
    check(mimo_env_step(w->env, NULL, 0, w->block, w->bytes, NULL));
  }
  felt_by_hand(w, ANNA, anna);
  felt_by_hand(w, BEN, ben);
  size = sqrt(anna[0] * anna[0] + anna[1] * anna[1] + anna[2] * anna[2]);
  for (i = 0; i < 3; ++i) sum = fmax(sum, fabs(anna[i] + ben[i]));
  printf("Anna's hand feels (%.2f, %.2f, %.2f) N, Ben's (%.2f, %.2f, %.2f) N.\n", anna[0], anna[1], anna[2], ben[0],
         ben[1], ben[2]);
  insist(size > 0.1 && anna[0] < 0, "Ben's hand pushes Anna's back");
  insist(sum < 1e-5 * size, "what they feel is opposite"); /* forces are float32 */
}

int main(void) {
  world w = make_world();
  const mimo_reset_config seeded = {.struct_size = sizeof seeded, .seeded = 1, .seed = 1};
  check(mimo_env_reset(w.env, &seeded, w.block, w.bytes));
  smile(&w);
  touch(&w);
  mimo_env_destroy(w.env);
  free(w.block);
  return 0;
}
