/* Eyes and nerves as old as the infant. Numbers are those of docs/guide/maturity.md. */
#include "support/capi.h"

static mimo_env* world(uint32_t maturity, const mimo_maturity* numbers, const mimo_limits* touch) {
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_agent_config agent;
  mimo_growth growth;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "benchmark"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.matures_apart = 1; /* the body stays, so that pictures are of the same things */
  growth.physiological_age = 0;
  growth.maturity = maturity;
  agent.vision_width = agent.vision_height = 32;
  agent.growth = &growth;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  if (numbers != NULL) CHECK_OK(mimo_scene_set_maturity(scene, 0, numbers));
  if (touch != NULL) CHECK_OK(mimo_scene_limit_sense(scene, 0, "touch", touch));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static mimo_field field_named(const mimo_env* env, const char* name, size_t* index) {
  const mimo_layout* layout = NULL;
  mimo_field field = {.struct_size = sizeof field};
  CHECK_OK(mimo_env_layout(env, &layout));
  CHECK_OK(mimo_layout_find(layout, name, index));
  CHECK_OK(mimo_layout_field(layout, *index, &field));
  return field;
}

static void numbers_of_an_age(void) {
  mimo_maturity at;
  mimo_growth growth;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_maturity_at(0, &at, sizeof at));
  CHECK_NEAR(at.acuity, 0.70, 1e-12);
  CHECK_NEAR(at.peak_contrast, 2, 1e-12);
  CHECK_NEAR(at.chroma, 0, 1e-12);
  CHECK_NEAR(at.conduction_speed, 24.5, 1e-12);
  CHECK_NEAR(at.sensory_delay, 0.026, 1e-12);
  CHECK_NEAR(at.motor_delay, 0.022, 1e-12);
  CHECK_NEAR(at.vision_delay, 0.153, 1e-3);
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.maturity = 0x40;
  CHECK_OK(mimo_scene_create(NULL, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.growth = &growth;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "this one knows bits of 0x8000001f", mimo_scene_add_agent(scene, &agent, NULL));
  mimo_scene_destroy(scene);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "age is -1", mimo_maturity_at(-1, &at, sizeof at));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "age is 25", mimo_maturity_at(25, &at, sizeof at));
  CHECK_OK(mimo_maturity_init(&at, sizeof at));
  CHECK(at.acuity == 0 && at.chroma == 1 && at.conduction_speed == 0 && at.vision_delay == 0);
}

static void nerves_follow_the_age(void) {
  mimo_env *usual = world(MIMO_MATURITY_BODY, NULL, NULL), *late = world(MIMO_MATURITY_DELAYS, NULL, NULL);
  size_t index;
  const mimo_field touch = field_named(late, "touch/force", &index), eye = field_named(late, "vision/eye_left", &index);
  CHECK(delay_of(usual, "touch/force", 0) == 0 && delay_of(usual, "vision/eye_left", 0) == 0);
  CHECK_NEAR(delay_of(late, "vision/eye_left", 77), 0.155, 1e-9); /* 153 ms in steps of 5 */
  CHECK_NEAR(delay_of(late, "vestibular/acceleration", 2), 0.005, 1e-9);
  CHECK_NEAR(eye.end, -0.005 - 0.155, 1e-9);
  CHECK(touch.start < touch.end - 0.02 && touch.end < -0.025); /* from face to toes */
  mimo_env_destroy(usual);
  mimo_env_destroy(late);
}

/* What a limit says of a field counts instead of its nerves, also where it says that it is not late. */
static void limits_have_the_last_word(void) {
  mimo_limits prompt;
  mimo_env* env;
  CHECK_OK(mimo_limits_init(&prompt, sizeof prompt));
  env = world(MIMO_MATURITY_DELAYS, NULL, &prompt);
  CHECK(delay_of(env, "touch/force", 0) == 0);
  CHECK(delay_of(env, "proprioception/position", 0) > 0.025);
  mimo_env_destroy(env);
}

/* A newborn sees grey. Numbers that are given count instead of its age. */
static void eyes_follow_the_age(void) {
  mimo_maturity colourful;
  int kind;
  CHECK_OK(mimo_maturity_at(0, &colourful, sizeof colourful));
  colourful.chroma = 1;
  for (kind = 0; kind < 3; ++kind) {
    mimo_env* env = kind == 0   ? world(MIMO_MATURITY_BODY, NULL, NULL)
                    : kind == 1 ? world(MIMO_MATURITY_BODY | MIMO_MATURITY_EYES, NULL, NULL)
                                : world(MIMO_MATURITY_ALL, &colourful, NULL);
    size_t index, i;
    const mimo_field eye = field_named(env, "vision/eye_left", &index);
    const size_t bytes = sizes_of(env).block_bytes;
    uint8_t* block = malloc(bytes);
    int colour = 0;
    CHECK_OK(mimo_env_reset(env, NULL, block, bytes));
    for (i = 0; i < eye.bytes; i += 3) {
      const uint8_t* pixel = block + eye.offset + i;
      if (pixel[0] != pixel[1] || pixel[1] != pixel[2]) colour = 1;
    }
    CHECK(colour == (kind != 1));
    free(block);
    mimo_env_destroy(env);
  }
}

static void only_infants_have_nerves(void) {
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  mimo_maturity newborn;
  CHECK_OK(mimo_maturity_at(0, &newborn, sizeof newborn));
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .xml = "<mujoco><worldbody><body name='arm'><joint name='hinge'/>"
                                                             "<geom size='.1'/></body></worldbody></mujoco>"),
                             &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.body = "scene";
  agent.root = "arm";
  agent.vision = agent.vestibular = agent.touch = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "maturity: agent 0 is body \"arm\"",
              mimo_scene_set_maturity(scene, 0, &newborn));
  CHECK_OK(mimo_scene_set_maturity(scene, 0, NULL));
  mimo_scene_destroy(scene);
}

/* A hand that is told of 0.1 s later, whatever the age; other parts stay as they were. */
static void parts_are_late_as_told(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no body \"paw\"", mimo_scene_set_sensory_delay(scene, 0, "paw", 0.1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "seconds is -0.1", mimo_scene_set_sensory_delay(scene, 0, "left_hand", -0.1));
  CHECK_OK(mimo_scene_set_sensory_delay(scene, 0, NULL, 0.02));
  CHECK_OK(mimo_scene_set_sensory_delay(scene, 0, "left_hand", 0.1));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  if (env != NULL) {
    const mimo_field touch = field_of(env, "touch/force");
    const int32_t hand = find(env, MIMO_BODY, "left_hand");
    double* bodies = malloc(touch.receptors * sizeof *bodies);
    size_t index = 0, i, of_hand = 0;
    CHECK_OK(mimo_layout_find(layout_of(env), "touch/force", &index));
    CHECK_OK(mimo_layout_receptors(layout_of(env), index, MIMO_RECEPTOR_BODY, bodies, touch.receptors));
    for (i = 0; i < touch.receptors; i += 50) {
      const int is_hand = (int32_t)bodies[i] == hand;
      of_hand += is_hand != 0;
      CHECK_NEAR(is_hand ? 0.1 : 0.02, delay_of(env, "touch/force", 3 * i + 1), 1e-12);
    }
    CHECK(of_hand > 1);
    CHECK_NEAR(0.02, delay_of(env, "proprioception/position", 0), 1e-12);
    CHECK(delay_of(env, "vestibular/acceleration", 0) == 0);
    free(bodies);
  }
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* Sees with a foveation of 10. */
static mimo_env* foveated_world(uint32_t width, uint32_t height) {
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_agent_config agent;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "benchmark"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision_width = width;
  agent.vision_height = height;
  agent.vision_foveation = 10;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

/* A point of the world lies in a foveated picture where the directions of its pixels say. */
static void foveated_pictures_tell_directions(void) {
  mimo_env* env = foveated_world(32, 48);
  mimo_picture_config eye;
  mimo_gaze gaze = {.struct_size = sizeof gaze};
  double point[3], pixel[3], plain[3];
  float* directions = malloc(48 * 32 * 3 * sizeof *directions);
  size_t index = 0, i, left, right;
  CHECK_OK(mimo_layout_find(layout_of(env), "vision/eye_left", &index));
  CHECK_OK(mimo_layout_directions(layout_of(env), index, directions, 48 * 32 * 3));
  left = (24 * 32 + 15) * 3; /* beside the middle, above the middle of the lower half */
  right = (24 * 32 + 31) * 3;
  CHECK(directions[left] < 0 && directions[right] > 0 && directions[right + 1] < 0 && directions[right + 2] < 0);
  /* Along the eye's axis and a little to a side, by hand: x of 1 m ahead is the tangent. */
  CHECK_OK(mimo_env_gaze(env, 0, &gaze));
  CHECK_OK(mimo_picture_config_init(&eye, sizeof eye));
  eye.camera = "eye_left";
  eye.width = 32;
  eye.height = 48;
  for (i = 0; i < 3; ++i) point[i] = gaze.left_position[i] + gaze.left_direction[i] + (i == 2 ? 0.1 : 0);
  CHECK_OK(mimo_env_project(env, &eye, point, 1, plain));
  eye.foveation = 10;
  CHECK_OK(mimo_env_project(env, &eye, point, 1, pixel));
  /* r' = R ln(1 + 10 r / R) / ln 11, from the picture's middle */
  {
    const double corner = hypot(15.5, 23.5), dx = plain[0] - 16, dy = plain[1] - 24, r = hypot(dx, dy);
    const double far = corner * log1p(10 * r / corner) / log(11);
    CHECK(r > 3);
    CHECK_NEAR(16 + dx / r * far, pixel[0], 1e-9);
    CHECK_NEAR(24 + dy / r * far, pixel[1], 1e-9);
    CHECK(pixel[2] == plain[2]);
  }
  CHECK_OK(mimo_layout_find(layout_of(env), "touch/force", &index));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "expected a picture",
              mimo_layout_directions(layout_of(env), index, directions, 3));
  free(directions);
  mimo_env_destroy(env);
}

/* What eyes see of a picture as drawn: what a fovea makes of it is the same as for a picture for people. */
static void eyes_see_as_pictures_are(void) {
  mimo_env* env = foveated_world(32, 32);
  mimo_picture_config eye;
  uint8_t picture[32 * 32 * 3], *block;
  mimo_picture to = {.struct_size = sizeof to, .rgb = picture, .rgb_bytes = sizeof picture};
  mimo_field field;
  size_t bytes;
  bytes = sizes_of(env).block_bytes;
  block = malloc(bytes);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK_OK(mimo_env_observe(env, block, bytes));
  CHECK_OK(mimo_picture_config_init(&eye, sizeof eye));
  eye.camera = "eye_left";
  eye.width = eye.height = 32;
  field = field_of(env, "vision/eye_left");
  CHECK_OK(mimo_env_render(env, &eye, &to));
  CHECK(memcmp(picture, block + field.offset, sizeof picture) != 0);
  eye.foveation = 10;
  CHECK_OK(mimo_env_render(env, &eye, &to));
  CHECK(memcmp(picture, block + field.offset, sizeof picture) == 0);
  free(block);
  mimo_env_destroy(env);
}

/* Options of the eyes need the eyes. */
static void options_need_eyes(void) {
  mimo_scene* scene = NULL;
  mimo_agent_config agent;
  mimo_growth growth;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "benchmark"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  agent.growth = &growth;
  growth.maturity = MIMO_MATURITY_BODY | MIMO_MATURITY_FLICKER;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "need MIMO_MATURITY_EYES", mimo_scene_add_agent(scene, &agent, NULL));
  growth.maturity |= MIMO_MATURITY_EYES | MIMO_MATURITY_THRESHOLD;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  mimo_scene_destroy(scene);
}

int main(void) {
  numbers_of_an_age();
  parts_are_late_as_told();
  foveated_pictures_tell_directions();
  eyes_see_as_pictures_are();
  options_need_eyes();
  nerves_follow_the_age();
  limits_have_the_last_word();
  eyes_follow_the_age();
  only_infants_have_nerves();
  return failures();
}
