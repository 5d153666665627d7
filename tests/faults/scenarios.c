#include "faults/scenarios.h"

#include <mujoco/mujoco.h>

#include "repository_paths.h"
#include "support/capi.h"

enum { WORLDS = 3, ROOM = 1 << 22, PICTURE = 16 };

/* A world of few allocations. */
static const char* const kSmall =
    "<mujoco><worldbody><geom type='plane' size='1 1 .1'/><body name='a' pos='0 0 1'><freejoint/><geom size='.1'/>"
    "</body></worldbody></mujoco>";

static mimo_scene *small_scene, *infant_scene, *scene;
static mimo_env *infant, *env, *made_env;
static mimo_batch *batch, *made_batch;
static unsigned char block[ROOM], state[ROOM];
static size_t block_bytes, batch_bytes, state_bytes, senses_bytes;

/* A model of the host's, and senses on its gripper. */
static mjModel* host_model;
static mjData* host_data;
static mimo_scene* gripper_scene;
static mimo_senses *senses, *made_senses;

static mimo_status make_scene(const char* name, const char* xml) {
  mimo_scene_config config;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.name = name;
  config.xml = xml;
  return mimo_scene_create(&config, &scene);
}

/* All that nerves tell. */
static const unsigned kNervesOfSkin = MIMO_TOUCH_SA1 | MIMO_TOUCH_RA | MIMO_TOUCH_PC | MIMO_TOUCH_SA2 |
                                      MIMO_TOUCH_TEMPERATURE | MIMO_TOUCH_COLD | MIMO_TOUCH_WARM |
                                      MIMO_TOUCH_NOCICEPTION_FAST | MIMO_TOUCH_NOCICEPTION_SLOW | MIMO_TOUCH_UNITS;

static mimo_status add_infant(mimo_scene* to) {
  mimo_agent_config agent;
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.touch |= kNervesOfSkin;
  agent.vestibular |= MIMO_VESTIBULAR_CANALS | MIMO_VESTIBULAR_OTOLITHS | MIMO_VESTIBULAR_GRAVITY;
  agent.proprioception = MIMO_PROPRIOCEPTION_ALL;
  agent.hearing = MIMO_HEARING_EARS | MIMO_HEARING_BANDS;
  agent.voice = 1;
  agent.vision_width = agent.vision_height = PICTURE;
  agent.touch_scale = 0.3;
  return mimo_scene_add_agent(to, &agent, NULL);
}

static void make_batch_of(const mimo_scene* of, mimo_batch** made) {
  mimo_batch_config config;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 2;
  config.autoreset = MIMO_AUTORESET_SAME_STEP;
  CHECK_OK(mimo_batch_create(of, NULL, &config, made));
}

static mimo_senses_config host_config(void) {
  mimo_senses_config config;
  CHECK_OK(mimo_senses_config_init(&config, sizeof config));
  config.mujoco_version = mj_version();
  config.model_size = sizeof(mjModel);
  config.data_size = sizeof(mjData);
  return config;
}

static mimo_status attach_to(mimo_senses** made) {
  const mimo_senses_config config = host_config();
  return mimo_senses_attach(gripper_scene, host_model, &config, made);
}

static void begin_host(void) {
  const mimo_layout* layout = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  mimo_agent_config agent;
  mimo_limits limits;
  char error[200] = "";
  host_model = mj_loadXML(MIMO_TEST_MODELS "/gripper.xml", NULL, error, sizeof error);
  if (host_model == NULL) {
    fprintf(stderr, "%s\n", error);
    exit(1);
  }
  host_data = mj_makeData(host_model);
  mj_forward(host_model, host_data);
  CHECK_OK(make_scene(NULL, NULL));
  gripper_scene = scene;
  scene = NULL;
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.body = "scene";
  agent.root = "world";
  agent.vestibular = agent.vision = 0;
  agent.touch |= kNervesOfSkin;
  agent.proprioception |= MIMO_PROPRIOCEPTION_JOINT_RECEPTOR | MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY |
                          MIMO_PROPRIOCEPTION_SPINDLE_SECONDARY | MIMO_PROPRIOCEPTION_TENDON_ORGAN;
  CHECK_OK(mimo_scene_add_agent(gripper_scene, &agent, NULL));
  CHECK_OK(mimo_scene_set_touch(gripper_scene, 0, NULL, 0.02));
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.delay = limits.noise = 0.1;
  CHECK_OK(mimo_scene_limit_sense(gripper_scene, 0, "proprioception", &limits));
  CHECK_OK(attach_to(&senses));
  CHECK_OK(mimo_senses_layout(senses, &layout));
  CHECK_OK(mimo_layout_describe(layout, &info));
  senses_bytes = info.block_bytes;
  CHECK(senses_bytes <= ROOM);
}

void scenarios_begin(void) {
  begin_host();
  CHECK_OK(make_scene(NULL, kSmall));
  small_scene = scene;
  CHECK_OK(make_scene("free", NULL));
  infant_scene = scene;
  scene = NULL;
  CHECK_OK(add_infant(infant_scene));
  CHECK_OK(mimo_env_create(infant_scene, NULL, &infant));
  make_batch_of(infant_scene, &batch);
  if (infant == NULL || batch == NULL) exit(1);
  block_bytes = sizes_of(infant).block_bytes;
  CHECK_OK(mimo_env_state_size(infant, &state_bytes));
  batch_bytes = WORLDS * block_bytes;
  CHECK(batch_bytes <= ROOM && state_bytes <= ROOM);
  CHECK_OK(mimo_env_state_save(infant, state, state_bytes));
}

void scenarios_end(void) {
  mimo_senses_destroy(senses);
  mimo_scene_destroy(gripper_scene);
  mj_deleteData(host_data);
  mj_deleteModel(host_model);
  mimo_env_destroy(infant);
  mimo_batch_destroy(batch);
  mimo_scene_destroy(small_scene);
  mimo_scene_destroy(infant_scene);
}

int scenario_failures(void) { return failures(); }

static void nothing(void) {}

static void clean(void) {
  mimo_scene_destroy(scene);
  mimo_env_destroy(env);
  mimo_env_destroy(made_env);
  mimo_batch_destroy(made_batch);
  mimo_senses_destroy(made_senses);
  scene = NULL;
  made_senses = NULL;
  env = made_env = NULL;
  made_batch = NULL;
}

static mimo_status create_scene(void) { return make_scene("reach", NULL); }

static void prepare_scene(void) { CHECK_OK(make_scene("free", NULL)); }
static mimo_status add_agent(void) { return add_infant(scene); }

static mimo_status add_object(void) {
  mimo_object_config object;
  CHECK_OK(mimo_object_config_init(&object, sizeof object));
  object.name = "an object with a name that is too long to be kept in a short string";
  return mimo_scene_add_object(scene, &object);
}

static mimo_status add_camera(void) {
  mimo_camera_config camera;
  CHECK_OK(mimo_camera_config_init(&camera, sizeof camera));
  camera.name = "a camera with a name that is too long to be kept in a short string";
  camera.placed = 1;
  camera.position[1] = 0.123456789;
  return mimo_scene_add_camera(scene, &camera);
}

static void prepare_empty(void) { CHECK_OK(make_scene(NULL, NULL)); }
static mimo_status set_room(void) { return mimo_scene_set_room(scene, "playroom"); }

static void prepare_playdate(void) { CHECK_OK(make_scene("playdate", NULL)); }
static mimo_status add_agents(void) { return mimo_scene_add_agents(scene, NULL, NULL); }

static mimo_status add_model(void) {
  mimo_model_config model;
  CHECK_OK(mimo_model_config_init(&model, sizeof model));
  model.name = "a_model_with_a_name_that_is_too_long_to_be_kept_in_a_short_string";
  model.xml =
      "<mujoco><compiler eulerseq='zyx' autolimits='true' angle='radian'/><default><geom size='.1'/></default><asset>"
      "<material name='m'/></asset><worldbody><body name='b' euler='1 2 3'><joint name='j' range='0 1'/><geom "
      "material='m' euler='1 2 3'/></body></worldbody><actuator><motor joint='j'/></actuator></mujoco>";
  return mimo_scene_add_model(scene, &model);
}

static void prepare_defaults(void) {
  CHECK_OK(make_scene(NULL,
                      "<mujoco><default><geom size='.1'/></default><worldbody><geom/><body name='a'><joint name='j'/>"
                      "<geom/></body></worldbody></mujoco>"));
}
static mimo_status weld(void) { return mimo_scene_weld(scene, "a", NULL, NULL); }
static mimo_status lock_scene(void) { return mimo_scene_lock(scene, "j", 0.5); }

static void prepare_infant(void) {
  prepare_scene();
  CHECK_OK(add_infant(scene));
}
static mimo_status limit_sense(void) {
  mimo_limits limits;
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.noise = 0.1;
  return mimo_scene_limit_sense(scene, 0, "proprioception/position", &limits);
}

static mimo_status limit_motor(void) {
  mimo_limits limits;
  CHECK_OK(mimo_limits_init(&limits, sizeof limits));
  limits.delay = 0.1;
  return mimo_scene_limit_motor(scene, 0, "act:left_elbow", &limits);
}

static mimo_status set_parameter(void) { return mimo_scene_set_parameter(scene, "reach/success_reward", 3); }
static mimo_status set_touch(void) { return mimo_scene_set_touch(infant_scene, 0, "left_hand", 0.01); }
static mimo_status set_temperature(void) { return mimo_scene_set_temperature(scene, "left_hand", 10); }
static mimo_status set_material(void) { return mimo_scene_set_material(scene, "left_hand", "copper"); }
static mimo_status print_scene(void) { return mimo_scene_xml(infant_scene, (char*)block, sizeof block, NULL); }

static mimo_status create_small(void) { return mimo_env_create(small_scene, NULL, &made_env); }
static mimo_status create_infant(void) { return mimo_env_create(infant_scene, NULL, &made_env); }
static mimo_status make_infant(void) { return mimo_env_make("standup", &made_env); }
static mimo_status clone_infant(void) { return mimo_env_clone(infant, &made_env); }

static mimo_status reset(void) { return mimo_env_reset(infant, SEED(3), block, block_bytes); }
static mimo_status step(void) { return mimo_env_step(infant, NULL, 0, block, block_bytes, NULL); }
/* What sounds: bands of silence are not worked out. The voice goes on in steps without actions. */
static void prepare_sound(void) {
  float samples[1600], actions[200] = {0};
  mimo_layout_info info = {.struct_size = sizeof info};
  const mimo_layout* layout = NULL;
  size_t i;
  CHECK_OK(mimo_env_layout(infant, &layout));
  CHECK_OK(mimo_layout_describe(layout, &info));
  CHECK(info.actions <= 200);
  actions[info.actions - 4] = actions[info.actions - 2] = actions[info.actions - 1] = 1;
  for (i = 0; i < 1600; ++i) samples[i] = i % 32 < 16 ? 0.02F : -0.02F;
  CHECK_OK(mimo_env_play(infant, "left_foot", samples, 1600, 16000));
  CHECK_OK(mimo_env_step(infant, actions, info.actions, block, block_bytes, NULL));
}
static mimo_status save(void) { return mimo_env_state_save(infant, block, sizeof block); }
static mimo_status load(void) { return mimo_env_state_load(infant, state, state_bytes, NULL); }
static mimo_status draw(void) {
  return mimo_env_render(made_env, NULL, PICTURE(.rgb = block, .rgb_bytes = 640 * 480 * 3));
}
static mimo_status lock(void) {
  const double held[2] = {1, -1};
  int32_t joint = -1;
  const mimo_status status = mimo_env_find(made_env, MIMO_JOINT, "robot:left_elbow", &joint);
  return status == MIMO_OK ? mimo_env_set(made_env, MIMO_JOINT_LOCK, &joint, 1, held, 2) : status;
}
static void prepare_env(void) { CHECK_OK(mimo_env_clone(infant, &made_env)); }
/* The first picture makes room for the poses of now. */
static void prepare_picture(void) {
  prepare_env();
  CHECK_OK(draw());
}

static mimo_status create_batch(void) {
  mimo_batch_config config;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 2;
  return mimo_batch_create(small_scene, NULL, &config, &made_batch);
}
static mimo_status reset_batch(void) { return mimo_batch_reset(batch, NULL, block, batch_bytes); }
static mimo_status step_batch(void) { return mimo_batch_step(batch, NULL, 0, block, batch_bytes, NULL); }
static mimo_status load_batch(void) { return mimo_batch_state_load(batch, NULL, 0, state, state_bytes, NULL); }
static void prepare_batch(void) { make_batch_of(small_scene, &made_batch); }
static mimo_status view_world(void) { return mimo_batch_world(made_batch, 1, &env); }

static mimo_status attach(void) { return attach_to(&made_senses); }
static mimo_status observe(void) { return mimo_senses_observe(senses, host_data, block, senses_bytes); }
static mimo_status advance(void) { return mimo_senses_advance(senses, host_data); }
static mimo_status reset_senses(void) { return mimo_senses_reset(senses, host_data, NULL); }

const scenario all_scenarios[] = {
    {"scene_create", nothing, create_scene, clean, 1, 0, 400},
    {"scene_add_agent", prepare_scene, add_agent, clean, 0, 0, 110},
    {"scene_add_object", prepare_scene, add_object, clean, 0, 0, 400},
    {"scene_add_camera", prepare_scene, add_camera, clean, 0, 0, 400},
    {"scene_set_room", prepare_empty, set_room, clean, 0, 0, 400},
    {"scene_add_agents", prepare_playdate, add_agents, clean, 0, 0, 60},
    {"scene_add_model", prepare_defaults, add_model, clean, 0, 0, 3000},
    {"scene_weld", prepare_defaults, weld, clean, 0, 0, 400},
    {"scene_lock", prepare_defaults, lock_scene, clean, 0, 0, 400},
    {"scene_set_parameter", prepare_scene, set_parameter, clean, 0, 0, 400},
    {"scene_limit_sense", prepare_infant, limit_sense, clean, 0, 0, 400},
    {"scene_limit_motor", prepare_infant, limit_motor, clean, 0, 0, 400},
    {"scene_set_touch", nothing, set_touch, clean, 0, 0, 400},
    {"scene_set_temperature", prepare_infant, set_temperature, clean, 0, 0, 400},
    {"scene_set_material", prepare_infant, set_material, clean, 0, 0, 400},
    {"scene_xml", nothing, print_scene, clean, 0, 0, 400},
    {"env_create, small", nothing, create_small, clean, 1, 1, 3000},
    {"env_create", nothing, create_infant, clean, 1, 1, 20},
    {"env_make", nothing, make_infant, clean, 1, 1, 12},
    {"env_clone", nothing, clone_infant, clean, 1, 0, 16},
    {"env_reset", nothing, reset, clean, 0, 0, 0},
    {"env_step", nothing, step, clean, 0, 0, 0},
    {"env_step, sound", prepare_sound, step, clean, 0, 0, 0},
    {"env_state_save", nothing, save, clean, 0, 0, 0},
    {"env_state_load", nothing, load, clean, 0, 0, 0},
    {"env_render", prepare_picture, draw, clean, 0, 0, 0},
    {"env_lock", prepare_env, lock, clean, 0, 0, 400},
    {"batch_create", nothing, create_batch, clean, 1, 1, 150},
    {"batch_world", prepare_batch, view_world, clean, 1, 0, 100},
    {"batch_reset", nothing, reset_batch, clean, 0, 0, 0},
    {"batch_step", nothing, step_batch, clean, 0, 0, 0},
    {"batch_state_load", nothing, load_batch, clean, 0, 0, 0},
    {"senses_attach", nothing, attach, clean, 1, 0, 600},
    {"senses_observe", nothing, observe, clean, 0, 0, 0},
    {"senses_advance", nothing, advance, clean, 0, 0, 0},
    {"senses_reset", nothing, reset_senses, clean, 0, 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 1},
};
