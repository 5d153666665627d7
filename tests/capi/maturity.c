/* Eyes and nerves as old as the infant, as a user asks for them. Numbers are those of docs/guide/maturity.md. */
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

static double delay(const mimo_env* env, const char* name, size_t element) {
  const mimo_layout* layout = NULL;
  size_t index = 0;
  double seconds = -1;
  field_named(env, name, &index);
  CHECK_OK(mimo_env_layout(env, &layout));
  CHECK_OK(mimo_layout_delay(layout, index, element, &seconds));
  return seconds;
}

static void numbers_of_an_age(void) {
  mimo_maturity at;
  CHECK_OK(mimo_maturity_at(0, &at, sizeof at));
  CHECK_NEAR(at.acuity, 0.70, 1e-12);
  CHECK_NEAR(at.peak_contrast, 2, 1e-12);
  CHECK_NEAR(at.chroma, 0, 1e-12);
  CHECK_NEAR(at.conduction_speed, 24.5, 1e-12);
  CHECK_NEAR(at.sensory_delay, 0.026, 1e-12);
  CHECK_NEAR(at.motor_delay, 0.022, 1e-12);
  CHECK_NEAR(at.vision_delay, 0.153, 1e-3);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "age is -1", mimo_maturity_at(-1, &at, sizeof at));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "age is 25", mimo_maturity_at(25, &at, sizeof at));
  CHECK_OK(mimo_maturity_init(&at, sizeof at));
  CHECK(at.acuity == 0 && at.chroma == 1 && at.conduction_speed == 0 && at.vision_delay == 0);
}

static void nerves_follow_the_age(void) {
  mimo_env *usual = world(MIMO_MATURITY_BODY, NULL, NULL), *late = world(MIMO_MATURITY_DELAYS, NULL, NULL);
  size_t index;
  const mimo_field touch = field_named(late, "touch/force", &index), eye = field_named(late, "vision/eye_left", &index);
  CHECK(delay(usual, "touch/force", 0) == 0 && delay(usual, "vision/eye_left", 0) == 0);
  CHECK_NEAR(delay(late, "vision/eye_left", 77), 0.155, 1e-9); /* 153 ms in steps of 5 */
  CHECK_NEAR(delay(late, "vestibular/acceleration", 2), 0.005, 1e-9);
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
  CHECK(delay(env, "touch/force", 0) == 0);
  CHECK(delay(env, "proprioception/position", 0) > 0.025);
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

int main(void) {
  numbers_of_an_age();
  nerves_follow_the_age();
  limits_have_the_last_word();
  eyes_follow_the_age();
  only_infants_have_nerves();
  return failures();
}
