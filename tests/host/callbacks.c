/* MuJoCo's callbacks belong to the process. Those of a host that simulates by itself are kept from our worlds: a call
 * is refused, by name and with nothing changed, while one is set that would act on them; senses that only look go on.
 */

#include "repository_paths.h"
#include "support/mujoco.h"

static int asked; /* how often a callback was */

static void touch_all(const mjModel* m, mjData* d) {
  (void)m;
  ++asked;
  d->qfrc_applied[0] += 1;
}
static int no_contacts(const mjModel* m, mjData* d, int geom1, int geom2) {
  (void)m;
  (void)d;
  (void)geom1;
  (void)geom2;
  ++asked;
  return 1;
}
static void sense(const mjModel* m, mjData* d, int stage) {
  (void)m;
  (void)d;
  (void)stage;
  ++asked;
}
static mjtNum act(const mjModel* m, const mjData* d, int id) {
  (void)m;
  (void)d;
  ++asked;
  return id;
}
static mjtNum clock_of_the_host(void) { return 0; }
static int no_collision(const mjModel* m, host_collision_data* d, host_contact* con, int g1, int g2, mjtNum margin) {
  (void)m;
  (void)d;
  (void)con;
  (void)g1;
  (void)g2;
  (void)margin;
  ++asked;
  return 0;
}

static uint8_t block[1 << 20], before[1 << 20], after[1 << 20];

static size_t state_of(mimo_env* env, uint8_t* state) {
  size_t bytes = 0;
  CHECK_OK(mimo_env_state_size(env, &bytes));
  CHECK(bytes <= sizeof before);
  CHECK_OK(mimo_env_state_save(env, state, bytes));
  return bytes;
}

static void check_refused(const char* name, mimo_scene* scene, mimo_env* env, mimo_batch* batch) {
  const float ones[200] = {1, 1, 1};
  mimo_env* other = NULL;
  size_t bytes = 0, count = 0, size;
  bytes = sizes_of(env).block_bytes;
  count = sizes_of(env).actions;
  CHECK(bytes <= sizeof block && count <= 200);
  size = state_of(env, before);
  asked = 0;
  if (scene != NULL) CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_env_create(scene, NULL, &other));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_env_reset(env, SEED(9), block, bytes));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_env_step(env, ones, count, block, bytes, NULL));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_env_physics_step(env, 1));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_env_observe(env, block, bytes));
  if (batch != NULL) {
    CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_batch_reset(batch, NULL, NULL, 0));
    CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
    CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
    CHECK_FAILS(MIMO_E_UNSUPPORTED, name, mimo_batch_observe(batch, NULL, 0, block, sizeof block));
  }
  CHECK(asked == 0 && other == NULL);
  CHECK(state_of(env, after) == size && memcmp(before, after, size) == 0);
}

static void check_infant(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = blind_env("free", NULL);
  mimo_batch_config many;
  mimo_batch* batch = NULL;
  mjfCollision capsules;
  CHECK_OK(mimo_batch_config_init(&many, sizeof many));
  many.worlds = many.threads = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &many, &batch));
  mjcb_control = touch_all;
  check_refused("has set MuJoCo's global mjcb_control", scene, env, batch);
  mjcb_control = NULL;
  mjcb_passive = touch_all;
  check_refused("has set MuJoCo's global mjcb_passive", scene, env, batch);
  mjcb_passive = NULL;
  mjcb_contactfilter = no_contacts;
  check_refused("has set MuJoCo's global mjcb_contactfilter", scene, env, batch);
  mjcb_contactfilter = NULL;
  capsules = mjCOLLISIONFUNC[mjGEOM_PLANE][mjGEOM_CAPSULE];
  mjCOLLISIONFUNC[mjGEOM_PLANE][mjGEOM_CAPSULE] = no_collision;
  check_refused("has changed MuJoCo's global mjCOLLISIONFUNC", scene, env, batch);
  mjCOLLISIONFUNC[mjGEOM_PLANE][mjGEOM_CAPSULE] = capsules;
  /* None of these has anything to say in a model without user-defined elements. */
  mjcb_time = clock_of_the_host;
  mjcb_sensor = sense;
  mjcb_act_dyn = mjcb_act_gain = mjcb_act_bias = act;
  asked = 0;
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  CHECK(asked == 0);
  mjcb_time = NULL;
  mjcb_sensor = NULL;
  mjcb_act_dyn = mjcb_act_gain = mjcb_act_bias = NULL;
  mimo_batch_destroy(batch);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static const char kUserDefined[] =
    "<mujoco><worldbody><body name='arm'><joint name='hinge'/><geom size='.1'/></body></worldbody>"
    "<actuator><general joint='hinge' %s/></actuator><sensor>%s</sensor></mujoco>";

static void check_user_defined(const char* actuator, const char* sensor, mjfAct* act_callback, const char* name) {
  char text[500];
  mimo_scene_config room;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  snprintf(text, sizeof text, kUserDefined, actuator, sensor);
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.xml = text;
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  if (env == NULL) exit(failures());
  if (act_callback != NULL) {
    *act_callback = act;
  } else {
    mjcb_sensor = sense;
  }
  check_refused(name, NULL, env, NULL);
  if (act_callback != NULL) *act_callback = NULL;
  mjcb_sensor = NULL;
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* The host's own simulation keeps its callback, and our senses look at what it does. */
static void check_senses(void) {
  char path[500], error[500] = "";
  mimo_agent_config config;
  mimo_senses_config attached;
  mimo_scene* scene = NULL;
  const mimo_layout* layout = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  mimo_senses* senses = NULL;
  size_t bytes = 0;
  mjModel* model;
  mjData* data;
  snprintf(path, sizeof path, "%s/humanoid.xml", MIMO_TEST_MODELS);
  model = mj_loadXML(path, NULL, error, sizeof error);
  if (model == NULL) exit(1);
  data = mj_makeData(model);
  CHECK_OK(mimo_agent_config_init(&config, sizeof config));
  config.body = "scene";
  config.root = "torso";
  config.vestibular = config.touch = config.vision = 0;
  CHECK_OK(mimo_scene_create(NULL, &scene));
  CHECK_OK(mimo_scene_add_agent(scene, &config, NULL));
  mjcb_control = touch_all;
  CHECK_OK(mimo_senses_config_init(&attached, sizeof attached));
  attached.mujoco_version = mj_version();
  CHECK_OK(mimo_senses_attach(scene, model, &attached, &senses));
  CHECK_OK(mimo_senses_layout(senses, &layout));
  CHECK_OK(mimo_layout_describe(layout, &info));
  bytes = info.block_bytes;
  asked = 0;
  mj_step(model, data);
  CHECK(asked == 1);
  CHECK_OK(mimo_senses_observe(senses, data, block, bytes));
  CHECK(asked == 1 && mjcb_control == touch_all);
  mjcb_control = NULL;
  mimo_senses_destroy(senses);
  mimo_scene_destroy(scene);
  mj_deleteData(data);
  mj_deleteModel(model);
}

int main(void) {
  check_infant();
  check_user_defined("", "<user objtype='body' objname='arm' datatype='real' needstage='pos' dim='1'/>", NULL,
                     "global mjcb_sensor");
  check_user_defined("dyntype='user'", "", &mjcb_act_dyn, "global mjcb_act_dyn");
  check_user_defined("gaintype='user'", "", &mjcb_act_gain, "global mjcb_act_gain");
  check_user_defined("biastype='user'", "", &mjcb_act_bias, "global mjcb_act_bias");
  check_senses();
  return failures();
}
