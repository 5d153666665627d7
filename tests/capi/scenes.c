/* Scenes: by name, from a file, from text, empty; agents and objects; what is refused, and with which message. */
#include "repository_paths.h"
#include "support/capi.h"

static const char* const kMimo =
    "<mujoco><include file='mimo/mitten.xml'/><worldbody><geom type='plane' size='0 0 1'/></worldbody></mujoco>";

static size_t bodies_of(const mimo_scene* scene) {
  mimo_env* env = NULL;
  size_t count = 0;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  if (env != NULL) CHECK_OK(mimo_env_count(env, MIMO_BODY, &count));
  mimo_env_destroy(env);
  return count;
}

static mimo_scene* create(const char* name, const char* file, const char* xml) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.name = name;
  config.file = file;
  config.xml = xml;
  CHECK_OK(mimo_scene_create(&config, &scene));
  return scene;
}

static void check_names_files_and_texts(void) {
  mimo_scene* scene;
  mimo_scene_config config;
  CHECK_TEXT("benchmark", mimo_scene_name(0));
  CHECK_TEXT("free", mimo_scene_name(1));
  CHECK_TEXT("selfbody", mimo_scene_name(4));
  CHECK_TEXT("rollover", mimo_scene_name(6));
  CHECK_TEXT("showroom", mimo_scene_name(7));
  CHECK_TEXT("playdate", mimo_scene_name(8));
  CHECK_TEXT("babybench-base", mimo_scene_name(9));
  CHECK_TEXT("babybench-crib", mimo_scene_name(10));
  CHECK_TEXT("babybench-cubes", mimo_scene_name(11));
  CHECK_TEXT("head-lift", mimo_scene_name(12));
  CHECK_TEXT("mobile", mimo_scene_name(36));
  CHECK(mimo_scene_name(37) == NULL);
  CHECK(mimo_scene_name((size_t)-1) == NULL);
  scene = create("benchmark", NULL, NULL);
  CHECK(bodies_of(scene) == 3);
  mimo_scene_destroy(scene);
  scene = create(NULL, MIMO_MODELS "/benchmark.xml", NULL);
  CHECK(bodies_of(scene) == 3);
  mimo_scene_destroy(scene);
  scene = create("", "", kMimo);
  CHECK(bodies_of(scene) == 24);
  mimo_scene_destroy(scene);
  CHECK_OK(mimo_scene_create(NULL, &scene));
  CHECK(bodies_of(scene) == 1);
  mimo_scene_destroy(scene);

  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  scene = NULL;
  config.name = "castle";
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no scene named \"castle\"; there are: benchmark, free",
              mimo_scene_create(&config, &scene));
  config.file = "x.xml";
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "\"castle\", file \"x.xml\" and xml exclude each other",
              mimo_scene_create(&config, &scene));
  config.name = NULL;
  CHECK_FAILS(MIMO_E_NOT_FOUND, "file x.xml cannot be read", mimo_scene_create(&config, &scene));
  config.file = NULL;
  config.xml = "<mujoco>";
  CHECK_FAILS(MIMO_E_MODEL, "xml text, line 1", mimo_scene_create(&config, &scene));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "scene is NULL", mimo_scene_create(NULL, NULL));
  CHECK(scene == NULL);
}

static void ignore(void* user, const mimo_log_record* record) {
  CHECK(record->level == MIMO_LOG_WARNING && record->in_world == 0 &&
        strstr(record->text, "MuJoCo 2.2.2 does not know") != NULL);
  ++*(int*)user;
}

/* What documents may ask for, and what is not as their authors meant it. */
static void check_limits_of_documents(void) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  int warnings = 0;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  CHECK(config.max_pixels == 0 && config.confined == 0);
  config.xml = "<mujoco>\n<option iterations='60' ls_iterations='9'/></mujoco>";
  config.max_iterations = 59;
  config.log = ignore;
  config.log_user = &warnings;
  CHECK_OK(mimo_scene_create(&config, &scene));
  CHECK(warnings == (strncmp(mimo_mujoco_version(), "4.", 2) == 0 ? 0 : 1)); /* which knows ls_iterations */
  CHECK_FAILS(MIMO_E_MODEL, "xml text, line 2: iterations=\"60\" is more than max_iterations (59)",
              mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  config.max_iterations = 60;
  CHECK_OK(mimo_scene_create(&config, &scene));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);

  /* 49 million pixels each, at 20 ns. */
  config.xml =
      "<mujoco>\n<asset><texture name='a' type='2d' builtin='flat' width='7000' height='7000'/>\n"
      "<texture name='b' type='2d' builtin='flat' width='7000' height='7000'/></asset></mujoco>";
  config.max_compile_ms = 1500;
  CHECK_OK(mimo_scene_create(&config, &scene));
  CHECK_FAILS(MIMO_E_MODEL,
              "xml text, line 3: with this <texture>, compiling the document would take about 1.96 s, more than "
              "max_compile_ms (1500)",
              mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);

  config.xml = "<mujoco><include file='/dev/null'/></mujoco>";
#ifdef _WIN32
  CHECK_FAILS(MIMO_E_NOT_FOUND, "included file /dev/null cannot be read", mimo_scene_create(&config, &scene));
#else
  CHECK_FAILS(MIMO_E_MODEL, "file /dev/null is a device", mimo_scene_create(&config, &scene));
#endif
  config.confined = 1;
  CHECK_FAILS(MIMO_E_MODEL, "file /dev/null lies outside the document's folder", mimo_scene_create(&config, &scene));
  config.confined = 2;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "confined is 2, which needs an interface newer than 1.0: this one knows 0 to 1",
              mimo_scene_create(&config, &scene));
  config.confined = 0;
  config.limits_reserved = 1;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "limits_reserved is 1", mimo_scene_create(&config, &scene));
}

static void check_agents(void) {
  mimo_scene* scene = create("free", NULL, NULL);
  mimo_agent_config config;
  mimo_env* env = NULL;
  mimo_agent_info info;
  size_t agent = 99;
  size_t count = 0;
  const uint32_t defaults = MIMO_PROPRIOCEPTION_ACTUATION | MIMO_PROPRIOCEPTION_VELOCITY | MIMO_PROPRIOCEPTION_TORQUE |
                            MIMO_PROPRIOCEPTION_LIMIT | MIMO_PROPRIOCEPTION_POSITION;
  CHECK_OK(mimo_agent_config_init(&config, sizeof config));
  CHECK(config.proprioception == defaults && config.vestibular == 3 && config.vision == MIMO_VISION_RGB);
  CHECK(config.vision_width == 256 && config.vision_height == 256 && config.limit_threshold == 0.035);
  CHECK(config.place == MIMO_PLACE_SCENE && config.orientation[0] == 1);
  config.vision = 0;

#define REFUSED(status, part, field, value, good)                            \
  do {                                                                       \
    config.field = (value);                                                  \
    CHECK_FAILS(status, part, mimo_scene_add_agent(scene, &config, &agent)); \
    config.field = (good);                                                   \
  } while (0)
  REFUSED(MIMO_E_NOT_FOUND, "no body named \"octopus\"; there are: mitten, fingers", body, "octopus", "mitten");
  REFUSED(MIMO_E_INVALID_ARGUMENT, "name is \"a/b\"", name, "a/b", "anna");
  REFUSED(MIMO_E_UNSUPPORTED, "proprioception is 0x800", proprioception, 0x800, defaults);
  REFUSED(MIMO_E_UNSUPPORTED, "vestibular is 0x20", vestibular, 0x20, 3);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "limit_threshold is 0", limit_threshold, 0, 0.035);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "limit_threshold is nan", limit_threshold, (double)NAN, 0.035);
  REFUSED(MIMO_E_UNSUPPORTED, "vision is 0x8", vision, 8, MIMO_VISION_RGB);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "vision_width is 0", vision_width, 0, 256);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "vision_height is 4097", vision_height, 4097, 256);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "vision_fovy is 0.5", vision_fovy, 0.5, 0);
  REFUSED(MIMO_E_UNSUPPORTED, "place is 7", place, 7, MIMO_PLACE_ROOT);
  REFUSED(MIMO_E_UNSUPPORTED, "place is -1", place, -1, MIMO_PLACE_ROOT);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "position[1] is inf", position[1], (double)INFINITY, 1);
  REFUSED(MIMO_E_INVALID_ARGUMENT, "orientation is zero", orientation[0], 0, 2);
  config.vision = 0;
  CHECK(agent == 99);

  /* Two infants; each has its actions and its names. */
  CHECK_OK(mimo_scene_add_agent(scene, &config, &agent));
  CHECK(agent == 0);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "\"anna\"", mimo_scene_add_agent(scene, &config, &agent));
  REFUSED(MIMO_E_INVALID_ARGUMENT, "name is \"\"", name, "", "ben");
  config.position[1] = -1;
  CHECK_OK(mimo_scene_add_agent(scene, &config, &agent));
  CHECK(agent == 1);
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  count = sizes_of(env).agents;
  CHECK(count == 2);
  info.struct_size = sizeof info;
  CHECK_OK(mimo_env_agent(env, 1, &info));
  CHECK_TEXT("ben", info.name);
  CHECK(info.action_offset == 44 && info.action_count == 44);
  CHECK_NEAR(10.90487, info.mass, 1e-8); /* the tables of the original */
  CHECK_NEAR(0.778, info.height, 1e-8);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "index is 2, but there are 2 agents", mimo_env_agent(env, 2, &info));
  CHECK(find(env, MIMO_JOINT, "anna/robot:left_knee") < find(env, MIMO_JOINT, "ben/robot:left_knee"));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);

  /* The body is part of the document already. */
  scene = create(NULL, NULL, kMimo);
  CHECK_OK(mimo_agent_config_init(&config, sizeof config));
  config.vision = 0;
  config.body = "scene";
  CHECK_OK(mimo_scene_add_agent(scene, &config, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  count = sizes_of(env).actions;
  CHECK(count == 44);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  /* It is not: known once the scene is compiled. */
  scene = create("free", NULL, NULL);
  CHECK_OK(mimo_scene_add_agent(scene, &config, NULL));
  env = NULL;
  CHECK_FAILS(MIMO_E_NOT_FOUND, "mimo_location", mimo_env_create(scene, NULL, &env));
  CHECK(env == NULL);
  mimo_scene_destroy(scene);
}

static void check_objects(void) {
  mimo_scene* scene = create("free", NULL, NULL);
  mimo_object_config config;
  mimo_env* env = NULL;
  double mass = 0;
  int32_t id;
  CHECK_OK(mimo_object_config_init(&config, sizeof config));
  CHECK(config.shape == MIMO_SHAPE_SPHERE && config.size[0] == 0.04 && config.mass == 0.1 && config.fixed == 0);
#define NO_OBJECT(status, part, field, value, good)                   \
  do {                                                                \
    config.field = (value);                                           \
    CHECK_FAILS(status, part, mimo_scene_add_object(scene, &config)); \
    config.field = (good);                                            \
  } while (0)
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "name is empty", mimo_scene_add_object(scene, &config));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "config is NULL", mimo_scene_add_object(scene, NULL));
  config.name = "toy";
  NO_OBJECT(MIMO_E_UNSUPPORTED, "shape is 0", shape, 0, MIMO_SHAPE_SPHERE);
  NO_OBJECT(MIMO_E_UNSUPPORTED, "shape is 6", shape, 6, MIMO_SHAPE_BOX);
  NO_OBJECT(MIMO_E_INVALID_ARGUMENT, "size[1] is 0", size[1], 0, 0.02);
  config.size[2] = 0.03;
  NO_OBJECT(MIMO_E_INVALID_ARGUMENT, "size[2] is nan", size[2], (double)NAN, 0.03);
  NO_OBJECT(MIMO_E_INVALID_ARGUMENT, "mass is -1", mass, -1, 0.5);
  NO_OBJECT(MIMO_E_INVALID_ARGUMENT, "rgba[3] is 1.5", rgba[3], 1.5, 1);
  NO_OBJECT(MIMO_E_UNSUPPORTED, "fixed is 3", fixed, 3, 0);
  NO_OBJECT(MIMO_E_INVALID_ARGUMENT, "position[0] is inf", position[0], (double)INFINITY, 1);
  NO_OBJECT(MIMO_E_INVALID_ARGUMENT, "\"floor\"", name, "floor", "toy");
  CHECK_OK(mimo_scene_add_object(scene, &config));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "\"toy\"", mimo_scene_add_object(scene, &config));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  id = find(env, MIMO_BODY, "toy");
  CHECK_OK(mimo_env_get(env, MIMO_BODY_MASS, &id, 1, &mass, 1));
  CHECK_NEAR(0.5, mass, 1e-15);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* What is too long for its room ends at a word, or in a very long one between two letters, and says so. */
static void check_long_messages(void) {
  mimo_scene* scene = create("benchmark", NULL, NULL);
  mimo_scene_config config;
  mimo_agent_config agent;
  mimo_scene* other = NULL;
  char name[3001];
  const char* text;
  size_t i, length;
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.body = "fingers";
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no joint named \"elbow\"; there are: robot:hip_lean1, ",
              mimo_scene_lock(scene, "elbow", 0));
  text = mimo_last_error();
  length = strlen(text);
  CHECK(length > 900 && length < 1024);
  CHECK_TEXT(", ...", text + length - 5);
  mimo_scene_destroy(scene);

  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  for (i = 0; i < 3000; i += 2) memcpy(name + i, "\xc3\xa9", 2); /* e with an acute accent */
  name[3000] = '\0';
  config.name = name;
  for (i = 0; i < 2; ++i) { /* letters begin at odd and at even places of the message */
    CHECK_FAILS(MIMO_E_NOT_FOUND, "no scene named", mimo_scene_create(&config, &other));
    text = mimo_last_error();
    length = strlen(text);
    CHECK(length >= 1022 && length < 1024);
    CHECK_TEXT("\xc3\xa9 ...", text + length - 6);
    name[0] = 'e';
    memmove(name + 1, name + 2, 2999);
  }
}

static void check_scenes_of_text(void) {
  mimo_scene *scene = blind_scene("benchmark"), *again;
  char* text;
  size_t length = 0, second = 0;
  CHECK_OK(mimo_scene_xml(scene, NULL, 0, &length));
  CHECK(length > 1000);
  text = malloc(length + 1);
  memset(text, 'x', length + 1);
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, " bytes, but ", mimo_scene_xml(scene, text, length, &second));
  CHECK(text[0] == 'x' && text[length] == 'x' && second == 0);
  CHECK_OK(mimo_scene_xml(scene, text, length + 1, &second));
  CHECK(second == length && strlen(text) == length);
  again = create(NULL, NULL, text);
  CHECK(bodies_of(again) == 26);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "text is NULL, but its length is 5", mimo_scene_xml(scene, NULL, 5, NULL));
  CHECK_OK(mimo_scene_xml(scene, NULL, 0, NULL));
  mimo_scene_destroy(again);
  mimo_scene_destroy(scene);
  free(text);
}

static void check_saving_scenes(void) {
#ifdef _WIN32
  const char* const clean = "if exist saved_scene rmdir /s /q saved_scene";
#else
  const char* const clean = "rm -rf saved_scene";
#endif
  mimo_scene *scene = blind_scene("benchmark"), *again;
  char text[1024];
  CHECK(system(clean) == 0);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "folder is NULL", mimo_scene_save(scene, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "folder is \"\"", mimo_scene_save(scene, ""));
  CHECK_OK(mimo_scene_save(scene, "saved_scene"));
  again = create(NULL, "saved_scene/scene.xml", NULL);
  CHECK(bodies_of(again) == 26);
  mimo_scene_destroy(again);
  again = blind_scene("free");
  CHECK_FAILS(MIMO_E_FILE, "other content", mimo_scene_save(again, "saved_scene"));
  CHECK_OK(mimo_last_error_of(again, text, sizeof text, NULL));
  CHECK(strstr(text, "other content") != NULL);
  mimo_scene_destroy(again);
  mimo_scene_destroy(scene);
  CHECK(system(clean) == 0);
}

static void check_a_model_that_does_not_compile(void) {
  mimo_scene* scene = create(NULL, NULL, "<mujoco><worldbody><geom type='nonsense'/></worldbody></mujoco>");
  mimo_env* env = NULL;
  CHECK_FAILS(MIMO_E_MODEL, "nonsense", mimo_env_create(scene, NULL, &env));
  CHECK(env == NULL);
  mimo_scene_destroy(scene);
}

int main(void) {
  check_names_files_and_texts();
  check_limits_of_documents();
  check_agents();
  check_objects();
  check_scenes_of_text();
  check_saving_scenes();
  check_long_messages();
  check_a_model_that_does_not_compile();
  return failures();
}
