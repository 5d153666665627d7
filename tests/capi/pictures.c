/* Pictures by mimo_env_render, and the eyes in the observation. A sphere of 10 cm radius, 1 m before the camera. */
#include "support/capi.h"

/* Mesa itself forgets some 300 bytes a context. */
const char* __lsan_default_suppressions(void);
const char* __lsan_default_suppressions(void) { return "leak:libOSMesa\n"; }

enum { WIDTH = 64, HEIGHT = 48, PIXELS = WIDTH * HEIGHT, SKIPPED = 77 };

static uint8_t rgb[3 * PIXELS + 1];
static float depth[PIXELS + 1];
static int32_t segment[PIXELS + 1];

static mimo_env* room_with_ball(void) {
  mimo_scene_config room;
  mimo_object_config ball;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "free";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_object_config_init(&ball, sizeof ball));
  ball.name = "ball";
  ball.size[0] = 0.1;
  ball.position[2] = 1;
  ball.fixed = 1;
  CHECK_OK(mimo_scene_add_object(scene, &ball));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  return env;
}

static mimo_picture_config at_the_ball(void) {
  mimo_picture_config config;
  CHECK_OK(mimo_picture_config_init(&config, sizeof config));
  CHECK(config.width == 640 && config.height == 480 && config.camera == NULL && config.fovy == 0);
  config.width = WIDTH;
  config.height = HEIGHT;
  config.look_at[0] = config.look_at[1] = 0;
  config.look_at[2] = 1;
  config.distance = 1;
  config.azimuth = config.elevation = 0;
  return config;
}

static void fill_buffers(void) {
  size_t i;
  memset(rgb, 0xab, sizeof rgb);
  for (i = 0; i <= PIXELS; ++i) {
    depth[i] = -7;
    segment[i] = -7;
  }
}

static int buffers_are_untouched(void) {
  size_t i;
  for (i = 0; i <= PIXELS; ++i) {
    if (depth[i] != -7 || segment[i] != -7) return 0;
  }
  return rgb[0] == 0xab && memcmp(rgb, rgb + 1, sizeof rgb - 1) == 0;
}

static void check_refusals(mimo_env* env) {
  mimo_picture_config config = at_the_ball();
  fill_buffers();
#define REFUSED(status, part, field, value, good)                                                                   \
  do {                                                                                                              \
    config.field = (value);                                                                                         \
    CHECK_FAILS(status, part,                                                                                       \
                mimo_env_render(env, &config,                                                                       \
                                PICTURE(.rgb = rgb, .rgb_bytes = 3 * PIXELS, .depth = depth, .depth_count = PIXELS, \
                                        .segmentation = segment, .segmentation_count = PIXELS)));                   \
    config.field = (good);                                                                                          \
  } while (0)
  REFUSED(MIMO_E_INVALID_ARGUMENT, "width is 0", width, 0, WIDTH);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "height is 4097", height, 4097, HEIGHT);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "fovy is 171", fovy, 171, 0);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "distance is 0", distance, 0, 1);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "look_at[0] is nan", look_at[0], (double)NAN, 0);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "azimuth", azimuth, (double)INFINITY, 0);
  REFUSED(MIMO_E_NOT_FOUND, "no camera named \"periscope\"", camera, "periscope", NULL);
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "rgb has a length of",
              mimo_env_render(env, &config,
                              PICTURE(.rgb = rgb, .rgb_bytes = 3 * PIXELS - 1, .depth = depth, .depth_count = PIXELS)));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "depth has a length of",
              mimo_env_render(env, &config,
                              PICTURE(.rgb = rgb, .rgb_bytes = 3 * PIXELS, .depth = depth, .depth_count = PIXELS - 1)));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "segmentation has",
              mimo_env_render(env, &config,
                              PICTURE(.rgb = rgb, .rgb_bytes = 3 * PIXELS, .segmentation = segment,
                                      .segmentation_count = PIXELS - 1)));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "rgb is NULL", mimo_env_render(env, &config, PICTURE(.rgb_bytes = 1)));
  CHECK(buffers_are_untouched());
}

static void check_picture(mimo_env* env) {
  const size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2, top = WIDTH / 2, bottom = PIXELS - WIDTH / 2;
  const mimo_picture_config config = at_the_ball();
  const int32_t ball = find(env, MIMO_GEOM, "ball"), floor = find(env, MIMO_GEOM, "floor");
  static uint8_t again[3 * PIXELS];
  fill_buffers();
  CHECK_OK(mimo_env_render(env, &config,
                           PICTURE(.rgb = rgb, .rgb_bytes = 3 * PIXELS, .depth = depth, .depth_count = PIXELS,
                                   .segmentation = segment, .segmentation_count = PIXELS)));
  CHECK(rgb[3 * PIXELS] == 0xab && depth[PIXELS] == -7 && segment[PIXELS] == -7);
  /* Row 0 is the top, where there is sky; the floor is below. */
  CHECK(segment[middle] == ball && segment[top] == -1 && segment[bottom] == floor);
  CHECK_NEAR(0.9, depth[middle], 2e-3);
  CHECK(depth[top] > 10);
  /* The ball is red. */
  CHECK(rgb[3 * middle] > 2 * rgb[3 * middle + 1] && rgb[3 * middle] > 2 * rgb[3 * middle + 2]);
  CHECK_OK(mimo_env_render(env, &config, PICTURE(.rgb = again, .rgb_bytes = sizeof again)));
  CHECK(memcmp(rgb, again, sizeof again) == 0);
  CHECK_OK(mimo_env_render(env, &config, PICTURE()));
}

/* Two eyes of the size asked for; looking does not change where the infant goes. */
static void check_pictures_of_both_eyes(void) {
  mimo_scene* scene = NULL;
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_env_config none;
  mimo_env *env = NULL, *blind = blind_env("benchmark", NULL);
  mimo_field field;
  uint8_t *one, *two;
  int32_t ids[50], i;
  double here[68], there[68];
  size_t bytes = 0, fields = 0, k, pictures = 0;
  mimo_picture_config config;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "benchmark";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION;
  agent.vision_width = 30;
  agent.vision_height = 20;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_config_init(&none, sizeof none));
  none.renderer = "none";
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "renderer \"none\"", mimo_env_create(scene, &none, &env));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  bytes = sizes_of(env).block_bytes;
  fields = sizes_of(env).fields;
  for (k = 0; k < fields; ++k) {
    field = field_at(layout_of(env), k);
    if (strncmp(field.name, "vision/eye_", 11) != 0) continue;
    ++pictures;
    CHECK(field.shape[0] == 20 && field.shape[1] == 30 && field.end == -0.005 && field.receptors == 0);
    if (field.dtype == MIMO_U8)
      CHECK(field.ndim == 3 && field.shape[2] == 3 && field.bytes == 1800 && field.high == 255);
    if (field.dtype == MIMO_F32) CHECK(field.ndim == 2 && field.bytes == 2400 && field.low == 0);
    if (field.dtype == MIMO_I32) CHECK(field.ndim == 2 && field.bytes == 2400 && field.low == -1 && field.high == 38);
  }
  CHECK(pictures == 6);
  one = malloc(bytes);
  two = malloc(bytes);
  memset(one, 0xab, bytes);
  memset(two, 0xcd, bytes);
  CHECK_OK(mimo_env_reset(env, NULL, one, bytes));
  CHECK_OK(mimo_env_observe(env, two, bytes));
  CHECK(memcmp(one, two, bytes) == 0);
  CHECK_OK(mimo_picture_config_init(&config, sizeof config));
  config.width = config.height = 16;
  config.camera = "eye_left";
  for (i = 0; i < 10; ++i) {
    CHECK_OK(mimo_env_step(env, NULL, 0, one, bytes, NULL));
    CHECK_OK(mimo_env_observe(env, two, bytes));
    CHECK_OK(mimo_env_render(env, &config, PICTURE(.rgb = rgb, .rgb_bytes = 3 * 16 * 16)));
    CHECK_OK(mimo_env_step(blind, NULL, 0, NULL, 0, NULL));
  }
  for (i = 0; i < 50; ++i) ids[i] = i;
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, ids, 50, here, 68));
  CHECK_OK(mimo_env_get(blind, MIMO_JOINT_POSITION, ids, 50, there, 68));
  CHECK(memcmp(here, there, sizeof here) == 0);
  free(one);
  free(two);
  mimo_env_destroy(env);
  mimo_env_destroy(blind);
}

int main(void) {
  mimo_env* env = room_with_ball();
  const mimo_picture_config config = at_the_ball();
  if (mimo_env_render(env, &config, PICTURE(.rgb = rgb, .rgb_bytes = 3 * PIXELS)) == MIMO_E_UNSUPPORTED) {
    fprintf(stderr, "skipped: %s\n", mimo_last_error());
    return SKIPPED;
  }
  check_refusals(env);
  check_picture(env);
  mimo_env_destroy(env);
  check_pictures_of_both_eyes();
  return failures();
}
