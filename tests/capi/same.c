/*
 * One scenario a scene: seed 7, a hundred steps of fixed actions; and one with a task of its own. Prints a hash over
 * all blocks and the sum of rewards, which ./dev test compares between builds and languages. Here a second world has to
 * give the same; what the numbers themselves should be is the business of tests/golden. The last line is a picture of
 * plain arrays: a hash over colours, depths and objects, and the sum of the colours.
 */
#include "support/capi.h"

enum { kSteps = 100 };

static uint64_t hash_of(uint64_t hash, const uint8_t* bytes, size_t count) { /* FNV-1a */
  size_t i;
  for (i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
  return hash;
}

/* Tenths from -1 to 1: in single precision the same everywhere. */
static float action_of(size_t step, size_t i) { return (float)((int)((7 * step + 3 * i) % 21) - 10) / 10.0f; }

typedef struct {
  uint64_t hash;
  double rewards;
} outcome;

/*
 * The task of its own, "own": raise the left hand above a height that each episode draws anew, and spare your actions.
 * It declares two terms and two fields, remembers the height, and an episode goes on where the hand is up.
 */
static mimo_status draw_height(void* user, mimo_env* env, const mimo_task_moment* moment) {
  double share, *height = moment->memory;
  const mimo_status status = mimo_env_random(env, &share, 1);
  (void)user;
  *height = 0.2 + 0.2 * share;
  moment->fields[0] = (float)*height;
  return status;
}

static mimo_status judge_height(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  const int32_t* hand = user;
  const double* height = moment->memory;
  double place[3], effort = 0;
  size_t i;
  const mimo_status status = mimo_env_get(env, MIMO_BODY_POSITION, hand, 1, place, 3);
  for (i = 0; i < moment->action_count; ++i) effort += (double)moment->action[i] * moment->action[i];
  verdict->terms[0] = place[2] - *height;
  verdict->terms[1] = -0.01 * effort;
  moment->fields[1] = (float)place[2];
  verdict->outcome = place[2] > *height ? MIMO_OUTCOME_SUCCESS : MIMO_OUTCOME_NONE;
  verdict->goes_on = 1;
  return status;
}

static mimo_env* make_own(int32_t* hand) {
  static const char* const terms[2] = {"height", "effort"};
  mimo_scene_config room;
  mimo_agent_config infant;
  mimo_task task;
  mimo_task_field fields[2];
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  size_t i;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "benchmark";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_scene_default_agent(scene, &infant, sizeof infant));
  infant.vision = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &infant, NULL));
  for (i = 0; i < 2; ++i) {
    CHECK_OK(mimo_task_field_init(&fields[i], sizeof fields[i]));
    fields[i].name = i == 0 ? "desired_goal" : "achieved_goal";
    fields[i].unit = "m";
    fields[i].frame = "world";
  }
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.user = hand;
  task.memory_bytes = sizeof(double);
  task.reset = draw_height;
  task.evaluate = judge_height;
  task.terms = terms;
  task.fields = fields;
  task.term_count = task.field_count = 2;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  *hand = find(env, MIMO_BODY, "left_hand");
  mimo_scene_destroy(scene);
  return env;
}

static mimo_env* make(const char* scene) {
  static int32_t hand;
  mimo_env* env = NULL;
  if (strcmp(scene, "own") == 0) return make_own(&hand);
  CHECK_OK(mimo_env_make(scene, &env));
  return env;
}

static outcome play(const char* scene, int fill) {
  mimo_env* env = make(scene);
  size_t bytes = 0, count = 0, step, i;
  outcome all = {UINT64_C(14695981039346656037), 0};
  bytes = sizes_of(env).block_bytes;
  count = sizes_of(env).actions;
  uint8_t* block = malloc(bytes);
  float* actions = malloc(count * sizeof *actions);
  memset(block, fill, bytes);
  CHECK_OK(mimo_env_reset(env, SEED(7), block, bytes));
  all.hash = hash_of(all.hash, block, bytes);
  for (step = 0; step < kSteps; ++step) {
    double reward = 0;
    uint8_t terminated = 0, truncated = 0;
    for (i = 0; i < count; ++i) actions[i] = action_of(step, i);
    memset(block, fill, bytes);
    CHECK_OK(mimo_env_step(
        env, actions, count, block, bytes,
        RESULTS(.reward = &reward, .terminated = &terminated, .truncated = &truncated, .agent_count = 1)));
    all.hash = hash_of(all.hash, block, bytes);
    all.rewards += reward;
  }
  free(actions);
  free(block);
  mimo_env_destroy(env);
  return all;
}

enum { kWidth = 64, kHeight = 48, kPixels = kWidth * kHeight };

/* A red ball on an endless floor with a texture in sRGB, under a sun. */
static mimo_stage* make_stage(void) {
  static const int32_t forms[2] = {MIMO_FORM_PLANE, MIMO_FORM_SPHERE}, materials[2] = {0, -1}, first = 0, two = 2;
  static const int32_t flat = MIMO_TEXTURE_FLAT, sun = MIMO_LAMP_SUN;
  static const double sizes[6] = {0, 0, 0, 0.5, 0, 0};
  static const float colors[8] = {1, 1, 1, 1, 0.9F, 0.2F, 0.1F, 1}, white[4] = {1, 1, 1, 1};
  static const uint8_t pixels[12] = {200, 30, 90, 20, 180, 60, 40, 80, 220, 250, 240, 130}, coded = 1;
  const mimo_stage_shapes geoms = {.struct_size = sizeof geoms,
                                   .object_type = 5,
                                   .count = 2,
                                   .forms = forms,
                                   .sizes = sizes,
                                   .colors = colors,
                                   .materials = materials};
  const mimo_stage_textures textures = {.struct_size = sizeof textures,
                                        .count = 1,
                                        .types = &flat,
                                        .widths = &two,
                                        .heights = &two,
                                        .pixels = pixels,
                                        .pixel_bytes = sizeof pixels,
                                        .srgb = &coded};
  const mimo_stage_materials paints = {.struct_size = sizeof paints, .count = 1, .colors = white, .textures = &first};
  const mimo_stage_lights lights = {.struct_size = sizeof lights, .count = 1, .types = &sun};
  const mimo_stage_config config = {
      .struct_size = sizeof config, .geoms = &geoms, .textures = &textures, .materials = &paints, .lights = &lights};
  mimo_stage* stage = NULL;
  CHECK_OK(mimo_stage_create(&config, &stage));
  return stage;
}

static void draw_stage(void) {
  static const double places[6] = {0, 0, 0, 0, 0, 0.5}, above[3] = {0, 0, 4}, lamp[3] = {0, 0, 5};
  static const double direction[3] = {0, 0.6, -0.8};
  static const double turns[18] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  static uint8_t rgb[3 * kPixels];
  static float depth[kPixels];
  static int32_t objects[2 * kPixels];
  const mimo_stage_poses poses = {.struct_size = sizeof poses,
                                  .geom_count = 2,
                                  .geom_positions = places,
                                  .geom_rotations = turns,
                                  .light_count = 1,
                                  .light_positions = lamp,
                                  .light_directions = direction};
  const mimo_stage_poses* const pose = &poses;
  mimo_stage_view view;
  const mimo_stage_view* const seen = &view;
  mimo_stage* const stage = make_stage();
  uint64_t hash = UINT64_C(14695981039346656037);
  double sum = 0;
  size_t i;
  CHECK_OK(mimo_stage_view_init(&view, sizeof view));
  view.width = kWidth;
  view.height = kHeight;
  view.position = above;
  view.rotation = turns;
  view.rgb = rgb;
  view.rgb_bytes = sizeof rgb;
  view.depth = depth;
  view.depth_count = kPixels;
  view.segmentation = objects;
  view.segmentation_count = 2 * kPixels;
  CHECK_OK(mimo_stage_draw(stage, &pose, 1, &seen, 1));
  mimo_stage_destroy(stage);
  hash = hash_of(hash, rgb, sizeof rgb);
  hash = hash_of(hash, (const uint8_t*)depth, sizeof depth);
  hash = hash_of(hash, (const uint8_t*)objects, sizeof objects);
  for (i = 0; i < sizeof rgb; ++i) sum += rgb[i];
  printf("stage %016llx %.6f\n", (unsigned long long)hash, sum);
}

int main(void) {
  const char* const scenes[] = {"reach", "standup", "selfbody", "benchmark", "own"};
  size_t i;
  for (i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
    const outcome first = play(scenes[i], 0x00), second = play(scenes[i], 0xff);
    printf("%s %016llx %.6f\n", scenes[i], (unsigned long long)first.hash, first.rewards);
    CHECK(second.hash == first.hash && second.rewards == first.rewards);
  }
  draw_stage();
  return failures();
}
