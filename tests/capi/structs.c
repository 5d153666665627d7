/* Structs of other versions: smaller, larger, with zeros or something else behind the known members. */
#include "support/capi.h"

/* Room for a struct of a later version, 16 bytes longer than ours. */
#define LATER(type)                         \
  union {                                   \
    type now;                               \
    unsigned char bytes[sizeof(type) + 16]; \
  }

/* init fills all of a longer struct; shorter, absurd and NULL ones are refused and left alone. */
#define CHECK_INIT(type, init)                                                             \
  do {                                                                                     \
    LATER(type) config;                                                                    \
    size_t i;                                                                              \
    memset(&config, 0xab, sizeof config);                                                  \
    CHECK_OK(init(&config.now, sizeof config));                                            \
    CHECK(config.now.struct_size == sizeof config);                                        \
    for (i = sizeof(type); i < sizeof config; ++i) CHECK(config.bytes[i] == 0);            \
    memset(&config, 0xab, sizeof config);                                                  \
    CHECK_FAILS(MIMO_E_STRUCT_SIZE, "config: struct_size is ", init(&config.now, 8));      \
    CHECK_FAILS(MIMO_E_STRUCT_SIZE, "struct_size is 0", init(&config.now, 0));             \
    CHECK_FAILS(MIMO_E_STRUCT_SIZE, "struct_size is 1000000", init(&config.now, 1000000)); \
    for (i = 0; i < sizeof config; ++i) CHECK(config.bytes[i] == 0xab);                    \
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "config is NULL", init(NULL, sizeof(type)));      \
  } while (0)

/* A reader takes a longer struct with a zero tail and refuses one with anything in it. `use` gets &config.now. */
#define CHECK_READ(type, init, use)                                                \
  do {                                                                             \
    LATER(type) config;                                                            \
    CHECK_OK(init(&config.now, sizeof config));                                    \
    CHECK_OK(use(&config.now));                                                    \
    config.bytes[sizeof config - 1] = 1;                                           \
    CHECK_FAILS(MIMO_E_UNSUPPORTED, "config: it has members", use(&config.now));   \
    config.bytes[sizeof config - 1] = 0;                                           \
    config.now.struct_size = 8;                                                    \
    CHECK_FAILS(MIMO_E_STRUCT_SIZE, "config: struct_size is", use(&config.now));   \
    config.now.struct_size = 0;                                                    \
    CHECK_FAILS(MIMO_E_STRUCT_SIZE, "config: struct_size is 0", use(&config.now)); \
  } while (0)

/* A struct that is read and filled keeps the caller's size: what is set beyond ours is seen also the second time. */
#define CHECK_READ_AND_FILLED(type, ask)                                                \
  do {                                                                                  \
    LATER(type) both;                                                                   \
    memset(&both, 0, sizeof both);                                                      \
    ask##_init(&both.now, sizeof both);                                                 \
    CHECK_OK(ask(&both.now));                                                           \
    CHECK(both.now.struct_size == sizeof both);                                         \
    both.bytes[sizeof(type)] = 1;                                                       \
    CHECK_FAILS(MIMO_E_UNSUPPORTED, "it has members beyond its first", ask(&both.now)); \
  } while (0)

/* A description fills a longer struct, with zeros behind what it knows, and says how much that is. */
#define CHECK_DESCRIBED(type, argument, describe)                                      \
  do {                                                                                 \
    LATER(type) info;                                                                  \
    size_t i;                                                                          \
    memset(&info, 0xab, sizeof info);                                                  \
    info.now.struct_size = sizeof info;                                                \
    CHECK_OK(describe(&info.now));                                                     \
    CHECK(info.now.struct_size == sizeof(type));                                       \
    for (i = sizeof(type); i < sizeof info; ++i) CHECK(info.bytes[i] == 0);            \
    memset(&info, 0xab, sizeof info);                                                  \
    info.now.struct_size = 8;                                                          \
    CHECK_FAILS(MIMO_E_STRUCT_SIZE, argument ": struct_size is", describe(&info.now)); \
    for (i = 4; i < sizeof info; ++i) CHECK(info.bytes[i] == 0xab);                    \
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, argument " is NULL", describe(NULL));         \
  } while (0)

static mimo_scene* scene;
static mimo_env *env, *rewarded;

static mimo_status create_scene(const mimo_scene_config* config) {
  mimo_scene* made = NULL;
  const mimo_status status = mimo_scene_create(config, &made);
  CHECK((status == MIMO_OK) == (made != NULL));
  mimo_scene_destroy(made);
  return status;
}

static mimo_status create_env(const mimo_env_config* config) {
  mimo_env* made = NULL;
  const mimo_status status = mimo_env_create(scene, config, &made);
  CHECK((status == MIMO_OK) == (made != NULL));
  mimo_env_destroy(made);
  return status;
}

static mimo_status add_agent(mimo_agent_config* config) {
  mimo_scene* made = NULL;
  mimo_status status;
  CHECK_OK(mimo_scene_create(NULL, &made));
  status = mimo_scene_add_agent(made, config, NULL);
  mimo_scene_destroy(made);
  return status;
}

static mimo_status add_object(mimo_object_config* config) {
  static int number = 0;
  char name[16];
  sprintf(name, "toy%d", ++number);
  config->name = name;
  return mimo_scene_add_object(scene, config);
}

/* To a scene of its own each time, as a camera can be observed only once. */
static mimo_status add_camera(mimo_camera_config* config) {
  mimo_scene* made = NULL;
  mimo_status status;
  CHECK_OK(mimo_scene_create(NULL, &made));
  config->name = "anywhere";
  status = mimo_scene_add_camera(made, config);
  mimo_scene_destroy(made);
  return status;
}

static mimo_status add_field(mimo_field_config* config) {
  static int number = 0;
  char name[16];
  sprintf(name, "pull%d", ++number);
  config->name = name;
  config->quantity = MIMO_WORLD_GRAVITY;
  return mimo_scene_add_field(scene, config);
}

static mimo_status describe_agent(mimo_agent_info* info) { return mimo_env_agent(env, 0, info); }
static mimo_status describe_field(mimo_field* field) { return mimo_layout_field(layout_of(env), 0, field); }
static mimo_status describe_layout(mimo_layout_info* info) { return mimo_layout_describe(layout_of(env), info); }
static mimo_status describe_action(mimo_action* action) { return mimo_layout_action(layout_of(env), 0, action); }
static mimo_status describe_term(mimo_term* term) { return mimo_layout_term(layout_of(rewarded), 0, term); }
static mimo_status describe_gaze(mimo_gaze* gaze) { return mimo_env_gaze(env, 0, gaze); }
static mimo_status describe_appearance(mimo_appearance* to) { return mimo_env_appearance(env, 0, to); }
static mimo_status describe_timing(mimo_timing* timing) { return mimo_env_timing(env, timing); }

static void ask_mesh_init(mimo_mesh* mesh, size_t size) { CHECK_OK(mimo_mesh_init(mesh, size)); }
static mimo_status ask_mesh(mimo_mesh* mesh) { return mimo_env_mesh(env, 0, mesh); }
static void ask_texture_init(mimo_texture* texture, size_t size) { texture->struct_size = (uint32_t)size; }
static mimo_status ask_texture(mimo_texture* texture) { return mimo_env_texture(env, 0, texture); }
static void ask_light_init(mimo_light* light, size_t size) { light->struct_size = (uint32_t)size; }
static mimo_status ask_light(mimo_light* light) { return mimo_env_light(env, MIMO_HEADLIGHT, light); }

int main(void) {
  scene = blind_scene("free");
  env = blind_env("free", NULL);
  rewarded = blind_env("standup", NULL);
  CHECK_INIT(mimo_scene_config, mimo_scene_config_init);
  CHECK_INIT(mimo_agent_config, mimo_agent_config_init);
  CHECK_INIT(mimo_object_config, mimo_object_config_init);
  CHECK_INIT(mimo_env_config, mimo_env_config_init);
  CHECK_INIT(mimo_picture_config, mimo_picture_config_init);
  CHECK_INIT(mimo_camera_config, mimo_camera_config_init);
  CHECK_INIT(mimo_field_config, mimo_field_config_init);
  CHECK_READ(mimo_scene_config, mimo_scene_config_init, create_scene);
  CHECK_READ(mimo_agent_config, mimo_agent_config_init, add_agent);
  CHECK_READ(mimo_object_config, mimo_object_config_init, add_object);
  CHECK_READ(mimo_env_config, mimo_env_config_init, create_env);
  CHECK_READ(mimo_camera_config, mimo_camera_config_init, add_camera);
  CHECK_READ(mimo_field_config, mimo_field_config_init, add_field);
  CHECK_DESCRIBED(mimo_agent_info, "info", describe_agent);
  CHECK_DESCRIBED(mimo_field, "field", describe_field);
  CHECK_DESCRIBED(mimo_layout_info, "info", describe_layout);
  CHECK_DESCRIBED(mimo_action, "action", describe_action);
  CHECK_DESCRIBED(mimo_term, "term", describe_term);
  CHECK_DESCRIBED(mimo_timing, "timing", describe_timing);
  CHECK_DESCRIBED(mimo_gaze, "gaze", describe_gaze);
  CHECK_DESCRIBED(mimo_appearance, "appearance", describe_appearance);
  CHECK_READ_AND_FILLED(mimo_mesh, ask_mesh);
  CHECK_READ_AND_FILLED(mimo_texture, ask_texture);
  CHECK_READ_AND_FILLED(mimo_light, ask_light);
  mimo_env_destroy(rewarded);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return failures();
}
