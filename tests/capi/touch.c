/* Touch: config, spacing per body, description of the sensors, what is refused; and a fuzzed config. */
#include "support/capi.h"

typedef struct {
  mimo_env* env;
  size_t sensors, channels, offset, block_bytes;
  unsigned char* block;
} world;

static mimo_scene* empty_scene(void) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.name = "benchmark";
  CHECK_OK(mimo_scene_create(&config, &scene));
  return scene;
}

static mimo_agent_config feeling_agent(void) {
  mimo_agent_config config;
  CHECK_OK(mimo_agent_config_init(&config, sizeof config));
  config.vision = config.proprioception = config.vestibular = 0;
  return config;
}

static mimo_scene* scene_with(const mimo_agent_config* config) {
  mimo_scene* scene = empty_scene();
  CHECK_OK(mimo_scene_add_agent(scene, config, NULL));
  return scene;
}

static world open_world(const mimo_scene* scene) {
  world w;
  memset(&w, 0, sizeof w);
  CHECK_OK(mimo_env_create(scene, NULL, &w.env));
  if (w.env == NULL) exit(failures());
  w.block_bytes = sizes_of(w.env).block_bytes;
  w.block = malloc(w.block_bytes + 1);
  if (sizes_of(w.env).fields > 0) {
    const mimo_field field = field_at(layout_of(w.env), 0);
    w.sensors = field.receptors;
    w.offset = field.offset;
    w.channels = field.ndim > 1 ? field.shape[1] : 1; /* rates of receptors are one number each */
    CHECK(field.shape[0] == w.sensors);
  }
  return w;
}

static void close_world(world* w) {
  mimo_env_destroy(w->env);
  free(w->block);
}

static void check_default_configs(void) {
  const mimo_agent_config config = feeling_agent();
  CHECK(config.touch == MIMO_TOUCH_FORCE);
  CHECK(config.touch_response == MIMO_RESPONSE_LINEAR);
  CHECK(config.touch_frame == MIMO_FRAME_BODY);
  CHECK_NEAR(1, config.touch_scale, 0);
}

/* A quantity of all receptors of the first field; to be freed. */
static double* receptors(const mimo_env* env, int32_t quantity, size_t width) {
  const size_t expected = width * field_at(layout_of(env), 0).receptors;
  double* values = malloc(expected * sizeof *values);
  size_t count = 0;
  CHECK_OK(mimo_layout_receptor_width(layout_of(env), 0, quantity, &count));
  CHECK(count == expected);
  CHECK_OK(mimo_layout_receptors(layout_of(env), 0, quantity, values, count));
  return values;
}

/* Normal, first and second tangent are right-handed unit vectors. */
static void check_frame(const double* f) {
  CHECK_NEAR(1, f[0] * f[0] + f[1] * f[1] + f[2] * f[2], 1e-9);
  CHECK_NEAR(0, f[0] * f[3] + f[1] * f[4] + f[2] * f[5], 1e-9);
  CHECK_NEAR(f[6], f[1] * f[5] - f[2] * f[4], 1e-9);
  CHECK_NEAR(f[7], f[2] * f[3] - f[0] * f[5], 1e-9);
  CHECK_NEAR(f[8], f[0] * f[4] - f[1] * f[3], 1e-9);
}

static void check_descriptions_of_sensors(void) {
  const mimo_agent_config config = feeling_agent();
  mimo_scene* scene = scene_with(&config);
  world w = open_world(scene);
  double *bodies = receptors(w.env, MIMO_RECEPTOR_BODY, 1), *geoms = receptors(w.env, MIMO_RECEPTOR_GEOM, 1);
  double *positions = receptors(w.env, MIMO_RECEPTOR_POSITION, 3), *frames = receptors(w.env, MIMO_RECEPTOR_FRAME, 9);
  const mimo_layout* layout = layout_of(w.env);
  size_t i, count = 77;
  CHECK(w.sensors == 5685);
  CHECK(w.channels == 3);
  for (i = 0; i < w.sensors; ++i) {
    const double* n = frames + 9 * i;
    int32_t body = -1;
    CHECK_OK(mimo_env_body_of(w.env, MIMO_GEOM, (int32_t)geoms[i], &body));
    CHECK(body == (int32_t)bodies[i]);
    CHECK(i == 0 || bodies[i] >= bodies[i - 1]);
    check_frame(n);
    if (body == find(w.env, MIMO_BODY, "head")) { /* a sphere */
      const double* p = positions + 3 * i;
      CHECK_NEAR(0.0735, (p[0] - 0.01) * n[0] + p[1] * n[1] + (p[2] - 0.0735) * n[2], 1e-9);
    }
  }
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "value_count is 5684, but 5685 are needed",
              mimo_layout_receptors(layout, 0, MIMO_RECEPTOR_BODY, bodies, w.sensors - 1));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "quantity is 0x2005", mimo_layout_receptor_width(layout, 0, 0x2005, &count));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "quantity is 0x0", mimo_layout_receptors(layout, 0, 0, bodies, w.sensors));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "field is 1, but there are 1 fields",
              mimo_layout_receptor_width(layout, 1, MIMO_RECEPTOR_BODY, &count));
  CHECK(count == 77);
  free(bodies);
  free(geoms);
  free(positions);
  free(frames);
  close_world(&w);
  mimo_scene_destroy(scene);
}

static void check_spacing_by_body(void) {
  const mimo_agent_config config = feeling_agent();
  mimo_scene* scene = scene_with(&config);
  double* bodies;
  size_t i;
  world w;
  CHECK_OK(mimo_scene_set_touch(scene, 0, NULL, 0));
  w = open_world(scene);
  CHECK(w.sensors == 0);
  CHECK(w.block_bytes == 0);
  close_world(&w);
  CHECK_OK(mimo_scene_set_touch(scene, 0, "left_hand", 0.007));
  w = open_world(scene);
  CHECK(w.sensors == 160);
  bodies = receptors(w.env, MIMO_RECEPTOR_BODY, 1);
  for (i = 0; i < w.sensors; ++i) CHECK((int32_t)bodies[i] == find(w.env, MIMO_BODY, "left_hand"));
  free(bodies);
  close_world(&w);
  CHECK_OK(mimo_scene_set_touch(scene, 0, "left_hand", 0));
  w = open_world(scene);
  CHECK(w.sensors == 0);
  close_world(&w);

  CHECK_FAILS(MIMO_E_NOT_FOUND, "no body \"left_wing\"; the infant has: mimo_location, hip, lower_body",
              mimo_scene_set_touch(scene, 0, "left_wing", 0.01));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "spacing of body \"head\" is -1", mimo_scene_set_touch(scene, 0, "head", -1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "spacing of body \"head\" is nan", mimo_scene_set_touch(scene, 0, "head", NAN));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "spacing of body \"(every)\" is 11", mimo_scene_set_touch(scene, 0, NULL, 11));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "agent is 1, but there are 1 agents",
              mimo_scene_set_touch(scene, 1, "head", 0.01));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "agent is 99", mimo_scene_set_touch(scene, 99, "head", 0.01));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "scene is NULL", mimo_scene_set_touch(NULL, 0, "head", 0.01));
  mimo_scene_destroy(scene);
}

static void check_refused(mimo_status status, const char* part, mimo_agent_config config) {
  mimo_scene* scene = empty_scene();
  CHECK_FAILS(status, part, mimo_scene_add_agent(scene, &config, NULL));
  mimo_scene_destroy(scene);
}

static void check_refused_configs(void) {
  mimo_agent_config config = feeling_agent();
  config.touch = 0x8000;
  check_refused(MIMO_E_UNSUPPORTED, "touch is 0x8000", config);
  config.touch = MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE;
  check_refused(MIMO_E_INVALID_ARGUMENT, "exclude each other", config);
  config = feeling_agent();
  config.touch_response = 0;
  check_refused(MIMO_E_UNSUPPORTED,
                "touch_response is 0, which needs an interface newer than 1.0: this one knows 1 to 3", config);
  config = feeling_agent();
  config.touch_frame = 4;
  check_refused(MIMO_E_UNSUPPORTED, "touch_frame is 4", config);
  config = feeling_agent();
  config.touch_scale = 0;
  check_refused(MIMO_E_INVALID_ARGUMENT, "touch_scale is 0", config);
  config.touch_scale = NAN;
  check_refused(MIMO_E_INVALID_ARGUMENT, "touch_scale is nan", config);
  config = feeling_agent();
  config.touch_slip_threshold = -1;
  check_refused(MIMO_E_INVALID_ARGUMENT, "touch_slip_threshold is -1", config);
}

static void check_sensors_in_a_picture(void) {
  const mimo_agent_config agent = feeling_agent();
  mimo_scene* scene = scene_with(&agent);
  world w = open_world(scene);
  mimo_picture_config config;
  double points[6] = {0, 0, 1, 0, 0, 1}, pixels[6] = {0, 0, 0, 0, 0, 0};
  CHECK_OK(mimo_picture_config_init(&config, sizeof config));
  config.look_at[0] = config.look_at[1] = 0;
  config.look_at[2] = 1;
  config.distance = 2;
  config.azimuth = 90; /* looks along +y: right is +x */
  config.elevation = 0;
  config.fovy = 90;
  points[3] = 0.5;
  points[5] = 1.25;
  CHECK_OK(mimo_env_project(w.env, &config, points, 2, pixels));
  CHECK_NEAR(320, pixels[0], 1e-9);
  CHECK_NEAR(240, pixels[1], 1e-9);
  CHECK_NEAR(2, pixels[2], 1e-9);
  CHECK_NEAR(320 + 240 * 0.25, pixels[3], 1e-9);
  CHECK_NEAR(240 - 240 * 0.125, pixels[4], 1e-9);
  CHECK_NEAR(2, pixels[5], 1e-9);
  points[1] = -3; /* behind the camera */
  CHECK_OK(mimo_env_project(w.env, &config, points, 1, pixels));
  CHECK(pixels[2] < 0);
  config.camera = "eye_third";
  CHECK_FAILS(MIMO_E_NOT_FOUND, "eye_third", mimo_env_project(w.env, &config, points, 1, pixels));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "points is NULL", mimo_env_project(w.env, NULL, NULL, 1, pixels));
  close_world(&w);
  mimo_scene_destroy(scene);
}

static unsigned random_state = 12345;
static double uniform(void) {
  random_state = random_state * 1664525u + 1013904223u;
  return (double)(random_state >> 8) / (double)(1u << 24);
}
static double log_uniform(double low, double high) { return low * pow(high / low, uniform()); }

/* Whatever the config: it is refused with a message, or the world runs and gives finite numbers. */
static void check_random_configs(void) {
  static const char* const kBodies[] = {"head", "left_fingers", "hip", "right_foot", "left_eye", NULL, "tail", ""};
  int round;
  for (round = 0; round < 40; ++round) {
    mimo_agent_config config = feeling_agent();
    mimo_scene* scene = empty_scene();
    int step, i;
    config.touch = (uint32_t)(uniform() * 18);
    config.touch_response = (int32_t)(uniform() * 5);
    config.touch_frame = (int32_t)(uniform() * 5);
    config.touch_scale = log_uniform(1e-4, 5);
    config.touch_slip_threshold = uniform() * 0.02;
    if (mimo_scene_add_agent(scene, &config, NULL) != MIMO_OK) {
      CHECK(strlen(mimo_last_error()) > 0);
      mimo_scene_destroy(scene);
      continue;
    }
    for (i = 0; i < 3; ++i) {
      (void)mimo_scene_set_touch(scene, 0, kBodies[(int)(uniform() * 8)], uniform() < 0.3 ? 0 : log_uniform(0.002, 20));
    }
    {
      world w = open_world(scene);
      size_t k, floats = w.block_bytes / sizeof(float);
      for (step = 0; step < 60; ++step) {
        memset(w.block, 0xff, w.block_bytes); /* not a number, everywhere */
        CHECK_OK(mimo_env_step(w.env, NULL, 0, w.block, w.block_bytes, NULL));
      }
      for (k = 0; k < floats; ++k) {
        float value;
        memcpy(&value, w.block + k * sizeof value, sizeof value);
        if (!isfinite(value)) break;
      }
      CHECK(k == floats);
      close_world(&w);
    }
    mimo_scene_destroy(scene);
  }
}

int main(void) {
  check_default_configs();
  check_descriptions_of_sensors();
  check_spacing_by_body();
  check_refused_configs();
  check_sensors_in_a_picture();
  check_random_configs();
  return failures();
}
