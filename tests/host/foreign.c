/* Senses on models that know nothing of infants: what they give, checked by MuJoCo's own numbers; what is refused. */
#include <mujoco/mujoco.h>

#include "repository_paths.h"
#include "support/capi.h"

typedef struct host {
  mjModel* model;
  mjData* data;
} host;

static host load(const char* name) {
  char path[500], error[500] = "";
  host h;
  snprintf(path, sizeof path, "%s/%s.xml", MIMO_TEST_MODELS, name);
  h.model = mj_loadXML(path, NULL, error, sizeof error);
  if (h.model == NULL) {
    fprintf(stderr, "%s: %s\n", path, error);
    exit(1);
  }
  h.data = mj_makeData(h.model);
  return h;
}

static void unload(host h) {
  mj_deleteData(h.data);
  mj_deleteModel(h.model);
}

static mimo_agent_config part_of(const char* root) {
  mimo_agent_config config;
  CHECK_OK(mimo_agent_config_init(&config, sizeof config));
  config.body = "scene";
  config.root = root;
  config.vestibular = config.touch = config.vision = 0;
  return config;
}

static mimo_scene* scene_of(const mimo_agent_config* agent) {
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_create(NULL, &scene));
  CHECK_OK(mimo_scene_add_agent(scene, agent, NULL));
  return scene;
}

static mimo_senses_config host_config(void) {
  mimo_senses_config config;
  CHECK_OK(mimo_senses_config_init(&config, sizeof config));
  config.mujoco_version = mj_version();
  config.model_size = sizeof(mjModel);
  config.data_size = sizeof(mjData);
  return config;
}

static mimo_status attach(const mimo_scene* scene, host h, mimo_senses** senses) {
  const mimo_senses_config config = host_config();
  return mimo_senses_attach(scene, h.model, &config, senses);
}

static const mimo_layout* of_senses(const mimo_senses* senses) {
  const mimo_layout* layout = NULL;
  CHECK_OK(mimo_senses_layout(senses, &layout));
  return layout;
}

static mimo_field sensed_field(const mimo_senses* senses, const char* name) {
  size_t index = 0;
  CHECK_OK(mimo_layout_find(of_senses(senses), name, &index));
  return field_at(of_senses(senses), index);
}

static uint8_t block[1 << 20];

static const float* values(const mimo_senses* senses, const char* name) {
  return (const float*)(const void*)(block + sensed_field(senses, name).offset);
}

static void observe(mimo_senses* senses, host h) {
  mimo_layout_info info = {.struct_size = sizeof info};
  CHECK_OK(mimo_layout_describe(of_senses(senses), &info));
  CHECK(info.block_bytes <= sizeof block && info.actions == 0 && info.terms == 0);
  CHECK_OK(mimo_senses_observe(senses, h.data, block, sizeof block));
}

/* Two joints of its own choice, in its own order; a site that the model has no sensors at; skin on the feet. */
static void check_humanoid(void) {
  host h = load("humanoid");
  mimo_agent_config config = part_of("torso");
  mimo_scene* scene;
  mimo_senses* senses = NULL;
  const int site = mj_name2id(h.model, mjOBJ_SITE, "inner_ear");
  const int foot = mj_name2id(h.model, mjOBJ_BODY, "shin_left");
  const int knee = mj_name2id(h.model, mjOBJ_JOINT, "knee_left");
  double felt[3] = {0, 0, 0}, expected[3] = {0, 0, 0}, spin[6];
  size_t sensors = 0, i;
  double bodies[5000];
  int contact;
  const float* force;
  const char* label = NULL;
  config.vestibular = MIMO_VESTIBULAR_ACCELERATION | MIMO_VESTIBULAR_ANGULAR_VELOCITY;
  config.vestibular_at = "inner_ear";
  config.touch = MIMO_TOUCH_FORCE;
  config.touch_frame = MIMO_FRAME_WORLD;
  config.vision = MIMO_VISION_SEGMENTATION;
  config.vision_width = config.vision_height = 32;
  scene = scene_of(&config);
  CHECK_OK(mimo_scene_set_touch(scene, 0, "shin_left", 0.02));
  CHECK_OK(mimo_scene_read_joint(scene, 0, "knee_left"));
  CHECK_OK(mimo_scene_read_joint(scene, 0, "neck"));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "joint \"neck\" is read already", mimo_scene_read_joint(scene, 0, "neck"));
  CHECK_OK(attach(scene, h, &senses));
  mimo_scene_destroy(scene);

  while (h.data->time < 1.5) mj_step(h.model, h.data); /* it has fallen and lies there */
  mj_forward(h.model, h.data);
  observe(senses, h);
  CHECK(sensed_field(senses, "proprioception/position").shape[0] == 2);
  CHECK_OK(mimo_layout_label(of_senses(senses), 0, 1, &label));
  CHECK_TEXT("neck", label);
  CHECK(values(senses, "proprioception/position")[0] == (float)h.data->qpos[h.model->jnt_qposadr[knee]]);
  CHECK(sensed_field(senses, "proprioception/control").shape[0] == 7);

  mj_objectVelocity(h.model, h.data, mjOBJ_SITE, site, spin, 1);
  for (i = 0; i < 3; ++i) CHECK_NEAR(spin[i], (double)values(senses, "vestibular/angular_velocity")[i], 1e-6);
  mj_rnePostConstraint(h.model, h.data);
  mj_objectAcceleration(h.model, h.data, mjOBJ_SITE, site, spin, 1);
  for (i = 0; i < 3; ++i) CHECK_NEAR(spin[3 + i], (double)values(senses, "vestibular/acceleration")[i], 1e-5);

  sensors = sensed_field(senses, "touch/force").receptors;
  CHECK(sensors > 100 && sensors < 5000);
  CHECK_OK(mimo_layout_find(of_senses(senses), "touch/force", &i));
  CHECK_OK(mimo_layout_receptors(of_senses(senses), i, MIMO_RECEPTOR_BODY, bodies, sensors));
  for (i = 0; i < sensors; ++i) CHECK((int)bodies[i] == foot);
  force = values(senses, "touch/force");
  for (i = 0; i < 3 * sensors; ++i) felt[i % 3] += (double)force[i];
  for (contact = 0; contact < h.data->ncon; ++contact) {
    const mjContact* c = h.data->contact + contact;
    double local[6], world[3];
    const int first = h.model->geom_bodyid[c->geom1] == foot;
    if (!first && h.model->geom_bodyid[c->geom2] != foot) continue;
    mj_contactForce(h.model, h.data, contact, local);
    for (i = 0; i < 3; ++i) world[i] = c->frame[i] * local[0] + c->frame[3 + i] * local[1] + c->frame[6 + i] * local[2];
    for (i = 0; i < 3; ++i) expected[i] += first ? -world[i] : world[i];
  }
  CHECK(expected[2] > 1);
  for (i = 0; i < 3; ++i) CHECK_NEAR(expected[i], felt[i], 1e-4);
  CHECK(sensed_field(senses, "vision/sight_segmentation").bytes == sizeof(int32_t) * 32 * 32);
  mimo_senses_destroy(senses);
  unload(h);
}

/* Slides are in metres; an actuator works through a tendon; everything is one agent. */
static void check_gripper(void) {
  host h = load("gripper");
  mimo_agent_config config = part_of("world");
  mimo_scene* scene = scene_of(&config);
  mimo_senses* senses = NULL;
  CHECK_OK(attach(scene, h, &senses));
  h.data->ctrl[0] = -0.2;
  h.data->ctrl[1] = 0.9;
  mj_step(h.model, h.data);
  observe(senses, h);
  CHECK_TEXT("m", sensed_field(senses, "proprioception/position").unit);
  CHECK(values(senses, "proprioception/control")[1] == 0.9f);
  CHECK(values(senses, "proprioception/actuator_force")[1] == (float)h.data->actuator_force[1]);
  mimo_senses_destroy(senses);
  mimo_scene_destroy(scene);
  unload(h);
}

static void check_lacks(void) {
  host h = load("humanoid");
  mimo_agent_config config = part_of("tail");
  mimo_scene* scene = scene_of(&config);
  mimo_senses* senses = NULL;
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no body named \"tail\"; there are: world, torso, skull", attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  config.root = "torso";
  config.vestibular = MIMO_VESTIBULAR_ACCELERATION | MIMO_VESTIBULAR_ANGULAR_VELOCITY;
  scene = scene_of(&config);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT,
              "set vestibular_at to the site or body that carries the organ, or vestibular to 0",
              attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  config.vestibular_at = "nose";
  scene = scene_of(&config);
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no site named \"nose\"; there are: inner_ear", attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  config.vestibular = 0;
  config.root = "thigh_left";
  config.vision = MIMO_VISION_RGB;
  scene = scene_of(&config);
  CHECK_FAILS(MIMO_E_NOT_FOUND, "carries no camera; vision = 0 switches eyes off; cameras elsewhere: gallery, sight",
              attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  config.vision = 0;
  scene = scene_of(&config);
  CHECK_OK(mimo_scene_read_joint(scene, 0, "neck"));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no hinge or slide joint \"neck\"; it has: hip_left, knee_left",
              attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  config.actuation = MIMO_ACTUATION_MUSCLE;
  scene = scene_of(&config);
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "effort and muscles", attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  config.actuation = MIMO_ACTUATION_POSITION;
  scene = scene_of(&config);
  CHECK_FAILS(
      MIMO_E_UNSUPPORTED,
      "position control: joint hip_left of swing_left has no equality constraint in the model that could hold it",
      attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  config.actuation = MIMO_ACTUATION_TORQUE;
  config.touch = MIMO_TOUCH_FORCE;
  scene = scene_of(&config);
  CHECK_OK(mimo_scene_set_touch(scene, 0, "skull", 0.01));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "touch: no body \"skull\" with a surface for skin; there are: thigh_left, shin_left",
              attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  config = part_of(NULL);
  scene = scene_of(&config);
  CHECK_FAILS(MIMO_E_NOT_FOUND, "mimo_location", attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  CHECK(senses == NULL);
  unload(h);
}

/* Fields on request that a host's model and data can fill, and those that only worlds can. */
static void check_requested(void) {
  static const char* const knees[] = {"knee_left", "knee_right"};
  static const char* const sole[] = {""};
  host h = load("humanoid");
  mimo_scene* scene = NULL;
  mimo_senses* senses = NULL;
  mimo_field_config field;
  const int knee = mj_name2id(h.model, mjOBJ_JOINT, "knee_right");
  CHECK_OK(mimo_scene_create(NULL, &scene));
  CHECK_OK(mimo_field_config_init(&field, sizeof field));
  field.name = "knees";
  field.quantity = MIMO_JOINT_POSITION;
  field.elements = knees;
  field.element_count = 2;
  CHECK_OK(mimo_scene_add_field(scene, &field));
  CHECK_OK(attach(scene, h, &senses));
  while (h.data->time < 0.5) mj_step(h.model, h.data);
  observe(senses, h);
  CHECK(values(senses, "knees")[1] == (float)h.data->qpos[h.model->jnt_qposadr[knee]]);
  mimo_senses_destroy(senses);
  field.name = "goal";
  field.quantity = MIMO_AGENT_GOAL;
  field.elements = sole;
  field.element_count = 1;
  CHECK_OK(mimo_scene_add_field(scene, &field));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "field \"goal\": attached senses have no agent", attach(scene, h, &senses));
  mimo_scene_destroy(scene);
  unload(h);
}

static mimo_status open_nose(void* user, const mimo_env* env, const mimo_sense_moment* moment,
                             mimo_sense_needs* needs) {
  mimo_sense_field field;
  (void)user, (void)moment, (void)needs;
  CHECK_OK(mimo_sense_field_init(&field, sizeof field));
  return mimo_sense_add_field(env, &field);
}

static mimo_status write_nose(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  (void)user, (void)env, (void)moment;
  return MIMO_OK;
}

/* Senses of one's own see worlds of the library's only. */
static void check_own_sense(void) {
  host h = load("humanoid");
  mimo_agent_config config = part_of("torso");
  mimo_scene* scene = scene_of(&config);
  mimo_senses* senses = NULL;
  mimo_sense sense;
  CHECK_OK(mimo_sense_init(&sense, sizeof sense));
  sense.interface_version = MIMO_SENSE_INTERFACE;
  sense.name = "nose";
  sense.open = open_nose;
  sense.write = write_nose;
  CHECK_OK(attach(scene, h, &senses));
  mimo_senses_destroy(senses);
  senses = NULL;
  CHECK_OK(mimo_scene_add_sense(scene, 0, &sense));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "sense \"nose\": attached senses have none of your own", attach(scene, h, &senses));
  CHECK(senses == NULL);
  mimo_scene_destroy(scene);
  unload(h);
}

static void check_foreign_memory(void) {
  host h = load("humanoid"), other = load("rubble");
  mimo_agent_config config = part_of("world");
  mimo_scene* scene = scene_of(&config);
  mimo_senses* senses = NULL;
  static uint8_t junk[sizeof(mjModel) + sizeof(mjData)];
  mimo_senses_config sensed = host_config();
  sensed.mujoco_version = 237;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "mujoco_version is 237, but libmimo runs on MuJoCo ",
              mimo_senses_attach(scene, h.model, &sensed, &senses));
  sensed = host_config();
  sensed.model_size += 8;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "model_size", mimo_senses_attach(scene, h.model, &sensed, &senses));
  sensed = host_config();
  sensed.data_size = 8;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "data_size", mimo_senses_attach(scene, h.model, &sensed, &senses));
  sensed = host_config();
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "model does not point to an mjModel",
              mimo_senses_attach(scene, junk, &sensed, &senses));
  memset(junk, 0x7f, sizeof junk);
  sensed.model_size = sensed.data_size = 0;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "model does not point to an mjModel",
              mimo_senses_attach(scene, junk, &sensed, &senses));
  CHECK(senses == NULL);
  CHECK_OK(mimo_senses_attach(scene, h.model, &sensed, &senses));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "data is NULL", mimo_senses_observe(senses, NULL, block, sizeof block));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "data does not point to an mjData of the model",
              mimo_senses_observe(senses, junk, block, sizeof block));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "data does not point to an mjData of the model",
              mimo_senses_observe(senses, other.data, block, sizeof block));
  observe(senses, h);
  mimo_senses_destroy(senses);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_senses_observe(senses, h.data, block, sizeof block));
  mimo_scene_destroy(scene);
  unload(h);
  unload(other);
}

int main(void) {
  check_humanoid();
  check_gripper();
  check_lacks();
  check_own_sense();
  check_foreign_memory();
  check_requested();
  return failures();
}
