#define _POSIX_C_SOURCE 200809L
#include "misuse/world.h"

#include "support/folder.h"
#include "support/mujoco.h"

enum { TAIL = 64, MOST_REGIONS = 104, MOST_BYTES = 1 << 21, LOOK_JOINTS = 8, MESH_ROOM = 1000 };

static struct {
  unsigned char *bytes, *kept;
  size_t size;
} regions[MOST_REGIONS];
static size_t region_count;

static args good;
static mimo_scene *dead_scene, *spare_scene;
static mimo_env* dead_env;
static mimo_batch* dead_batch;
static mimo_senses* dead_senses;
static mimo_recorder* dead_recorder;
static mimo_recording* dead_recording;
static mimo_stage* dead_stage;
static mimo_env* recorded; /* by the recorder */
static const mimo_layout* dead_layout;
static mjModel* host_model;
static mjData* host_data;
static char folder[] = "/tmp/mimo_misuse_XXXXXX"; /* of recordings and saved scenes */
static unsigned char not_a_handle[256];
static unsigned char foreign[MOST_BYTES], first_state[MOST_BYTES], first_memory[MOST_BYTES];

/* Memory of exactly this size, so that the address sanitizer sees what goes beyond it. */
static void* region(size_t size) {
  void* bytes = malloc(size);
  void* kept = malloc(size);
  CHECK(bytes != NULL && kept != NULL && region_count < MOST_REGIONS);
  if (failed_checks > 0) exit(failures());
  regions[region_count].bytes = bytes;
  regions[region_count].kept = kept;
  regions[region_count++].size = size;
  return bytes;
}

static mimo_scene* make_scene(const char* name, const char* body) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_object_config toy;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = name;
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_object_config_init(&toy, sizeof toy));
  toy.name = "toy";
  toy.position[1] = 1;
  CHECK_OK(mimo_scene_add_object(scene, &toy));
  if (body == NULL) return scene;
  CHECK_OK(mimo_scene_default_agent(scene, &agent, sizeof agent));
  agent.vision = MIMO_VISION_RGB;
  agent.vision_width = agent.vision_height = PICTURE_SIZE;
  agent.hearing = MIMO_HEARING_BANDS;
  agent.touch_scale = 0.3;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  return scene;
}

static mimo_batch* make_batch(const mimo_scene* scene, int32_t autoreset) {
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS_IN_BATCH;
  config.threads = 2;
  config.autoreset = autoreset;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  return batch;
}

/* The simulation of a host that senses are attached to. */
static void make_host(void) {
  static const char text[] =
      "<mujoco><worldbody><geom type='plane' size='1 1 1'/><body name='cart' pos='0 0 0.1'><freejoint/>"
      "<geom type='box' size='.2 .1 .1'/><body><joint name='mast'/><geom "
      "size='.1'/></body></body></worldbody></mujoco>";
  host_model = host_model_of(text, sizeof text - 1);
  host_data = mj_makeData(host_model);
  mj_step(host_model, host_data);
}

/* A scene that describes senses on it. */
static mimo_scene* make_cart(void) {
  mimo_agent_config agent;
  mimo_limits late;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_create(NULL, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.body = "scene";
  agent.root = agent.vestibular_at = "cart";
  agent.vision = 0;
  agent.hearing = MIMO_HEARING_EARS;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_scene_set_touch(scene, 0, NULL, 0.1));
  CHECK_OK(mimo_limits_init(&late, sizeof late));
  late.delay = 0.01;
  CHECK_OK(mimo_scene_limit_sense(scene, 0, "vestibular", &late));
  return scene;
}

static mimo_senses* make_senses(void) {
  mimo_scene* scene = make_cart();
  mimo_senses* senses = NULL;
  mimo_senses_config config;
  CHECK_OK(mimo_senses_config_init(&config, sizeof config));
  config.mujoco_version = mj_version();
  CHECK_OK(mimo_senses_attach(scene, host_model, &config, &senses));
  mimo_scene_destroy(scene);
  return senses;
}

static void make_dead_handles(void) {
  dead_scene = make_scene("free", NULL);
  CHECK_OK(mimo_env_create(dead_scene, NULL, &dead_env));
  CHECK_OK(mimo_env_layout(dead_env, &dead_layout));
  dead_batch = make_batch(dead_scene, MIMO_AUTORESET_NONE);
  mimo_scene_destroy(dead_scene);
  mimo_env_destroy(dead_env);
  mimo_batch_destroy(dead_batch);
  dead_senses = make_senses();
  mimo_senses_destroy(dead_senses);
}

static void make_foreign_state(void) {
  mimo_scene* scene = make_scene("free", NULL);
  mimo_env* env = NULL;
  size_t bytes = 0;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_state_size(env, &bytes));
  CHECK(bytes <= sizeof foreign);
  CHECK_OK(mimo_env_state_save(env, foreign, sizeof foreign));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static const char* const toys[1] = {"toy"};
static const char* const task_terms[1] = {"one"};
static const size_t task_shape[1] = {3};

static char sense_name[12] = "1000";
static const mimo_parameter sense_parameter = {
    .struct_size = sizeof(mimo_parameter), .name = "keen", .description = "1", .standard = 1, .high = 2};

static mimo_status open_nose(void* user, const mimo_env* env, const mimo_sense_moment* moment,
                             mimo_sense_needs* needs) {
  mimo_sense_field field;
  (void)user, (void)moment, (void)needs;
  CHECK_OK(mimo_sense_field_init(&field, sizeof field));
  return mimo_sense_add_field(env, &field);
}

static mimo_status fill_nose(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  (void)user, (void)env, (void)moment;
  return MIMO_OK;
}

static mimo_status judge(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  (void)user, (void)env, (void)moment;
  verdict->terms[0] = 1;
  return MIMO_OK;
}

static void find_things(void) {
  static int32_t ids[1];
  CHECK_OK(mimo_env_find(good.env, MIMO_JOINT, "toy", &ids[0]));
  good.ids = ids;
  good.id_count = 1;
}

/* Bytes of the first texture. */
static size_t size_of_texture(const mimo_env* env) {
  mimo_texture texture;
  memset(&texture, 0, sizeof texture);
  texture.struct_size = sizeof texture;
  CHECK_OK(mimo_env_texture(env, 0, &texture));
  return (size_t)4 * texture.width * texture.height;
}

static void make_arrays(void) {
  const size_t worlds = WORLDS_IN_BATCH;
  size_t actions = 0, state = 0, text = 0;
  actions = sizes_of(good.env).actions;
  good.block_bytes = sizes_of(good.env).block_bytes;
  CHECK_OK(mimo_env_state_size(good.env, &state));
  CHECK_OK(mimo_layout_find(good.layout, "touch/force", &good.field_index));
  CHECK_OK(mimo_layout_receptor_width(good.layout, good.field_index, MIMO_RECEPTOR_FRAME, &good.receptor_count));
  good.term_count = sizes_of(good.env).terms;
  good.delay_count = good.receptor_count / 3; /* a frame has nine numbers, a force three */
  CHECK_OK(mimo_layout_find(good.layout, "vision/eye_left", &good.picture_index));
  good.direction_count = 3 * PICTURE_SIZE * PICTURE_SIZE;
  CHECK_OK(mimo_scene_xml(spare_scene, NULL, 0, &text));
  CHECK(actions > 1 && good.receptor_count > 0 && good.term_count > 0);
  good.blocks_bytes = worlds * good.block_bytes;
  good.action_count = actions;
  good.actions_count = worlds * actions;
  good.own_moves = region(actions * sizeof(float));
  good.all_moves = region(good.actions_count * sizeof(float));
  good.state_bytes = state;
  good.states_bytes = worlds * state;
  good.worlds = worlds;
  good.agents = AGENTS;
  good.value_count = VALUES_PER_WORLD;
  good.values_count = worlds * VALUES_PER_WORLD;
  good.number_count = 4;
  good.point_count = 2;
  good.capacity = text + 1;
  good.depth_count = good.segmentation_count = PICTURE_SIZE * PICTURE_SIZE;
  good.rgb_bytes = 3 * good.depth_count;

  good.seeds = region(worlds * sizeof(uint64_t));
  good.mask = region(worlds);
  good.action = region(actions * sizeof(float));
  good.actions = region(worlds * actions * sizeof(float));
  good.points = region(3 * good.point_count * sizeof(double));
  good.pose = region(7 * sizeof(double));
  good.to_write = region(good.value_count * sizeof(double));
  good.all_to_write = region(good.values_count * sizeof(double));
  good.state = region(state);
  good.states = region(worlds * state);
  good.block = region(good.block_bytes);
  good.blocks = region(good.blocks_bytes);
  good.state_out = region(state);
  good.states_out = region(worlds * state);
  CHECK_OK(mimo_senses_state_size(good.senses, &good.memory_bytes));
  good.memory = region(good.memory_bytes);
  good.memory_out = region(good.memory_bytes);
  good.text = region(good.capacity);
  good.reward = region(AGENTS * sizeof(double));
  good.values = region(good.value_count * sizeof(double));
  good.all_values = region(good.values_count * sizeof(double));
  good.numbers = region((worlds * good.term_count > 4 ? worlds * good.term_count : 4) * sizeof(double));
  good.outcome = region(worlds * AGENTS * sizeof(int32_t));
  good.pixels = region(3 * good.point_count * sizeof(double));
  good.statuses = region(worlds * sizeof(mimo_status));
  good.receptors = region(good.receptor_count * sizeof(double));
  good.delays = region(good.delay_count * sizeof(double));
  good.directions = region(good.direction_count * sizeof(float));
  CHECK_OK(mimo_env_count(good.env, MIMO_BODY, &good.pose_count));
  good.pose_count *= 7;
  good.poses = region(good.pose_count * sizeof(float));
  good.positions = region(3 * MESH_ROOM * sizeof(float));
  good.corners = region(MESH_ROOM * sizeof(uint32_t));
  good.texture_bytes = size_of_texture(good.env);
  good.texels = region(good.texture_bytes);
  good.look_capacity = LOOK_JOINTS;
  good.look_joints = region(LOOK_JOINTS * sizeof(int32_t));
  good.look_angles = region(LOOK_JOINTS * sizeof(double));
  good.terminated = region(AGENTS);
  good.truncated = region(AGENTS);
  good.rgb = region(good.rgb_bytes);
  good.depth = region(good.depth_count * sizeof(float));
  good.segmentation = region(good.segmentation_count * sizeof(int32_t));
}

static void make_single_results(void) {
  good.count = region(sizeof(size_t));
  good.count2 = region(sizeof(size_t));
  good.id_out = region(sizeof(int32_t));
  good.u32_out = region(sizeof(uint32_t));
  good.flag = region(1);
  good.flag2 = region(1);
  good.number = region(sizeof(double));
  good.string = region(sizeof(char*));
  good.status_out = region(sizeof(mimo_status));
  good.made_scene = region(sizeof(mimo_scene*));
  good.made_env = region(sizeof(mimo_env*));
  good.made_batch = region(sizeof(mimo_batch*));
  good.made_senses = region(sizeof(mimo_senses*));
  good.layout_out = region(sizeof(mimo_layout*));
}

/* The world's own positions, for a step of one physics step: selfbody's. */
static double own_positions[200], own_forces[200];
static size_t own_position_count, own_force_count;

static void make_movement(void) {
  CHECK_OK(mimo_env_width(good.env, MIMO_JOINT_POSITION, NULL, 0, &own_position_count));
  CHECK_OK(mimo_env_width(good.env, MIMO_JOINT_VELOCITY, NULL, 0, &own_force_count));
  CHECK(own_position_count <= 200 && own_force_count <= 200);
  CHECK_OK(mimo_env_get(good.env, MIMO_JOINT_POSITION, NULL, 0, own_positions, own_position_count));
}

/* A recording of two steps of the environment, and a recorder of a world of its own. */
static void make_recordings(void) {
  good.run = "run.h5";
  good.new_run = "new_run.h5";
  CHECK_OK(mimo_recorder_open(good.env, good.run, NULL, &dead_recorder));
  for (int i = 0; i < 2; ++i) CHECK_OK(mimo_env_step(good.env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_recorder_close(dead_recorder));
  CHECK_OK(mimo_recording_open(good.run, NULL, &dead_recording));
  mimo_recording_close(dead_recording);
  CHECK_OK(mimo_recording_open(good.run, NULL, &good.recording));
  CHECK_OK(mimo_env_make("free", &recorded));
  CHECK_OK(mimo_recorder_open(recorded, "recorded.h5", NULL, &good.recorder));
  good.made_recorder = region(sizeof(mimo_recorder*));
  good.made_recording = region(sizeof(mimo_recording*));
  good.recorder_config = region(sizeof *good.recorder_config + TAIL);
  good.recording_info = region(sizeof *good.recording_info + TAIL);
  good.replay_report = region(sizeof *good.replay_report + TAIL);
}

/* A stage with one ball. */
static void fill_stage(void) {
  static const int32_t ball = MIMO_FORM_SPHERE;
  static const double size[3] = {0.1, 0, 0}, place[3] = {0, 0, -1}, turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  static const double eye[3] = {0, 0, 0};
  static const float color[4] = {1, 0, 0, 1};
  memset(good.shapes, 0, sizeof *good.shapes);
  good.shapes->struct_size = sizeof *good.shapes;
  good.shapes->count = 1;
  good.shapes->forms = &ball;
  good.shapes->sizes = size;
  good.shapes->colors = color;
  CHECK_OK(mimo_stage_air_init(good.air, sizeof *good.air));
  memset(good.stage_config, 0, sizeof *good.stage_config);
  good.stage_config->struct_size = sizeof *good.stage_config;
  good.stage_config->geoms = good.shapes;
  good.stage_config->air = good.air;
  memset(good.stage_poses, 0, sizeof *good.stage_poses);
  good.stage_poses->struct_size = sizeof *good.stage_poses;
  good.stage_poses->geom_count = 1;
  good.stage_poses->geom_positions = place;
  good.stage_poses->geom_rotations = turn;
  good.stage_pose_count = 1;
  CHECK_OK(mimo_stage_view_init(good.stage_view, sizeof *good.stage_view));
  good.stage_view->width = good.stage_view->height = PICTURE_SIZE;
  good.stage_view->position = eye;
  good.stage_view->rotation = turn;
  good.stage_view->rgb = good.rgb;
  good.stage_view->rgb_bytes = 3 * PICTURE_SIZE * PICTURE_SIZE;
  good.stage_view->depth = good.depth;
  good.stage_view->depth_count = PICTURE_SIZE * PICTURE_SIZE;
  good.stage_view->segmentation = good.stage_objects;
  good.stage_view->segmentation_count = 2 * PICTURE_SIZE * PICTURE_SIZE;
  *good.made_stage = NULL;
}

static void make_stage(void) {
  good.made_stage = region(sizeof(mimo_stage*));
  good.shapes = region(sizeof *good.shapes + TAIL);
  good.air = region(sizeof *good.air + TAIL);
  good.stage_config = region(sizeof *good.stage_config + TAIL);
  good.stage_poses = region(sizeof *good.stage_poses + TAIL);
  good.stage_view = region(sizeof *good.stage_view + TAIL);
  good.stage_objects = region(2 * PICTURE_SIZE * PICTURE_SIZE * sizeof *good.stage_objects);
  fill_stage();
  CHECK_OK(mimo_stage_create(good.stage_config, &good.stage));
  CHECK_OK(mimo_stage_create(good.stage_config, &dead_stage));
  mimo_stage_destroy(dead_stage);
}

static void make_structs(void) {
  good.scene_config = region(sizeof *good.scene_config + TAIL);
  good.agent_config = region(sizeof *good.agent_config + TAIL);
  good.object_config = region(sizeof *good.object_config + TAIL);
  good.env_config = region(sizeof *good.env_config + TAIL);
  good.batch_config = region(sizeof *good.batch_config + TAIL);
  good.picture_config = region(sizeof *good.picture_config + TAIL);
  good.task = region(sizeof *good.task + TAIL);
  good.task_field = region(sizeof *good.task_field + TAIL);
  good.sense = region(sizeof *good.sense + TAIL);
  good.sense_field = region(sizeof *good.sense_field + TAIL);
  good.results = region(sizeof *good.results + TAIL);
  good.env_results = region(sizeof *good.env_results + TAIL);
  good.movement = region(sizeof *good.movement + TAIL);
  good.reset_config = region(sizeof *good.reset_config + TAIL);
  good.batch_reset = region(sizeof *good.batch_reset + TAIL);
  good.picture = region(sizeof *good.picture + TAIL);
  good.parameter = region(sizeof *good.parameter + TAIL);
  good.info = region(sizeof *good.info + TAIL);
  good.layout_info = region(sizeof *good.layout_info + TAIL);
  good.field = region(sizeof *good.field + TAIL);
  good.described_action = region(sizeof *good.described_action + TAIL);
  good.term = region(sizeof *good.term + TAIL);
  good.timing = region(sizeof *good.timing + TAIL);
  good.camera_config = region(sizeof *good.camera_config + TAIL);
  good.field_config = region(sizeof *good.field_config + TAIL);
  good.model_config = region(sizeof *good.model_config + TAIL);
  good.gaze = region(sizeof *good.gaze + TAIL);
  good.behaviour = region(sizeof *good.behaviour + TAIL);
  good.mesh = region(sizeof *good.mesh + TAIL);
  good.appearance = region(sizeof *good.appearance + TAIL);
  good.texture = region(sizeof *good.texture + TAIL);
  good.light = region(sizeof *good.light + TAIL);
  good.growth = region(sizeof *good.growth + TAIL);
  good.limits = region(sizeof *good.limits + TAIL);
  good.maturity = region(sizeof *good.maturity + TAIL);
  good.senses_config = region(sizeof *good.senses_config + TAIL);
  good.report = region(sizeof *good.report + TAIL);
}

void make_everything(void) {
  if (!enter_folder(folder)) exit(1);
  memset(not_a_handle, 0x5a, sizeof not_a_handle);
  make_host();
  make_dead_handles();
  make_foreign_state();
  good.senses = make_senses();
  spare_scene = make_scene("selfbody", "mitten");
  CHECK_OK(mimo_env_create(spare_scene, NULL, &good.env));
  good.batch = make_batch(spare_scene, MIMO_AUTORESET_SAME_STEP);
  if (good.env == NULL || good.batch == NULL) exit(failures());
  good.layout = layout_of(good.env);
  find_things();
  make_arrays();
  make_single_results();
  make_structs();
  make_movement();
  make_recordings();
  make_stage();
  CHECK(good.state_bytes <= sizeof first_state);
  CHECK_OK(mimo_env_state_save(good.env, first_state, sizeof first_state));
  CHECK_OK(mimo_senses_state_save(good.senses, first_memory, sizeof first_memory));
}

static void remove_folder(void) {
  char command[100];
  snprintf(command, sizeof command, "rm -r %s", folder);
  CHECK(chdir("/") == 0 && system(command) == 0);
}

void destroy_everything(void) {
  size_t i;
  mimo_scene_destroy(spare_scene);
  mimo_env_destroy(good.env);
  mimo_batch_destroy(good.batch);
  mimo_senses_destroy(good.senses);
  CHECK_OK(mimo_recorder_close(good.recorder));
  mimo_recording_close(good.recording);
  mimo_stage_destroy(good.stage);
  mimo_env_destroy(recorded);
  mj_deleteData(host_data);
  mj_deleteModel(host_model);
  for (i = 0; i < region_count; ++i) {
    free(regions[i].bytes);
    free(regions[i].kept);
  }
  remove_folder();
}

static void fill_configs(void) {
  CHECK_OK(mimo_scene_config_init(good.scene_config, sizeof *good.scene_config));
  CHECK_OK(mimo_agent_config_init(good.agent_config, sizeof *good.agent_config));
  CHECK_OK(mimo_object_config_init(good.object_config, sizeof *good.object_config));
  CHECK_OK(mimo_env_config_init(good.env_config, sizeof *good.env_config));
  CHECK_OK(mimo_batch_config_init(good.batch_config, sizeof *good.batch_config));
  CHECK_OK(mimo_picture_config_init(good.picture_config, sizeof *good.picture_config));
  CHECK_OK(mimo_task_init(good.task, sizeof *good.task));
  CHECK_OK(mimo_task_field_init(good.task_field, sizeof *good.task_field));
  CHECK_OK(mimo_sense_init(good.sense, sizeof *good.sense));
  CHECK_OK(mimo_sense_field_init(good.sense_field, sizeof *good.sense_field));
  CHECK_OK(mimo_camera_config_init(good.camera_config, sizeof *good.camera_config));
  CHECK_OK(mimo_field_config_init(good.field_config, sizeof *good.field_config));
  CHECK_OK(mimo_growth_init(good.growth, sizeof *good.growth));
  good.growth->age = 6;
  good.agent_config->growth = good.growth;
  CHECK_OK(mimo_limits_init(good.limits, sizeof *good.limits));
  CHECK_OK(mimo_maturity_at(6, good.maturity, sizeof *good.maturity));
  CHECK_OK(mimo_senses_config_init(good.senses_config, sizeof *good.senses_config));
  CHECK_OK(mimo_model_config_init(good.model_config, sizeof *good.model_config));
  good.scene_config->name = "free";
  good.agent_config->place = MIMO_PLACE_ROOT;
  good.agent_config->vision_width = good.agent_config->vision_height = PICTURE_SIZE;
  good.object_config->name = "ball";
  good.env_config->max_steps = 1;
  good.batch_config->worlds = WORLDS_IN_BATCH;
  good.picture_config->width = good.picture_config->height = PICTURE_SIZE;
  good.task->evaluate = judge;
  good.task->memory_bytes = 8;
  good.task->terms = task_terms;
  good.task->term_count = 1;
  good.task->fields = good.task_field;
  good.task->field_count = 1;
  good.task_field->name = "goal";
  good.task_field->shape = task_shape;
  good.task_field->ndim = 1;
  good.task_field->high = 8;
  good.sense->interface_version = MIMO_SENSE_INTERFACE;
  good.sense->name = sense_name;
  good.sense->parameters = &sense_parameter;
  good.sense->parameter_count = 1;
  good.sense->open = open_nose;
  good.sense->write = fill_nose;
  good.parameter->struct_size = sizeof *good.parameter;
  good.info->struct_size = sizeof *good.info;
  good.layout_info->struct_size = sizeof *good.layout_info;
  good.field->struct_size = sizeof *good.field;
  good.described_action->struct_size = sizeof *good.described_action;
  good.term->struct_size = sizeof *good.term;
  good.timing->struct_size = sizeof *good.timing;
  good.gaze->struct_size = sizeof *good.gaze;
  good.behaviour->struct_size = sizeof *good.behaviour;
  good.appearance->struct_size = sizeof *good.appearance;
  good.report->struct_size = sizeof *good.report;
  good.senses_config->mujoco_version = mj_version();
  good.senses_config->model_size = sizeof *host_model;
  good.senses_config->data_size = sizeof *host_data;
  good.model_config->name = "cup";
  good.model_config->xml = "<mujoco><worldbody><body><geom size='0.1'/></body></worldbody></mujoco>";
  good.camera_config->name = "watcher";
  good.camera_config->placed = 1;
  good.field_config->name = "toy/place";
  good.field_config->elements = toys;
  good.field_config->element_count = 1;
}

static void fill_results(void) {
  mimo_batch_results* results = good.results;
  memset(results, 0, sizeof *results);
  results->struct_size = sizeof *results;
  results->reward = good.all_values;
  results->terminated = good.state_out;
  results->truncated = (uint8_t*)good.state_out + WORLDS_IN_BATCH;
  results->outcome = good.outcome;
  results->agent_count = WORLDS_IN_BATCH * AGENTS;
  results->terms = good.numbers;
  results->term_count = WORLDS_IN_BATCH * good.term_count;
  results->status = good.statuses;
  results->was_reset = (uint8_t*)good.state_out + 2 * WORLDS_IN_BATCH;
  results->final_written = (uint8_t*)good.state_out + 3 * WORLDS_IN_BATCH;
  results->worlds = WORLDS_IN_BATCH;
  results->final_blocks = good.states_out;
  results->final_bytes = good.blocks_bytes;
}

static void fill_env_results(void) {
  mimo_env_results* results = good.env_results;
  memset(results, 0, sizeof *results);
  results->struct_size = sizeof *results;
  results->reward = good.reward;
  results->terminated = good.terminated;
  results->truncated = good.truncated;
  results->outcome = good.outcome;
  results->agent_count = AGENTS;
  results->terms = good.numbers;
  results->term_count = good.term_count;
}

static void fill_movement(void) {
  memset(good.movement, 0, sizeof *good.movement);
  good.movement->struct_size = sizeof *good.movement;
  good.movement->positions = own_positions;
  good.movement->position_count = own_position_count;
  good.movement->forces = own_forces;
  good.movement->force_count = own_force_count;
}

static void fill_resets(void) {
  memset(good.reset_config, 0, sizeof *good.reset_config);
  good.reset_config->struct_size = sizeof *good.reset_config;
  good.reset_config->seeded = 1;
  good.reset_config->seed = 5;
  memset(good.batch_reset, 0, sizeof *good.batch_reset);
  good.batch_reset->struct_size = sizeof *good.batch_reset;
  good.batch_reset->seeds = good.seeds;
  good.batch_reset->mask = good.mask;
  good.batch_reset->worlds = WORLDS_IN_BATCH;
}

static void fill_picture(void) {
  memset(good.picture, 0, sizeof *good.picture);
  good.picture->struct_size = sizeof *good.picture;
  good.picture->rgb = good.rgb;
  good.picture->rgb_bytes = good.rgb_bytes;
  good.picture->depth = good.depth;
  good.picture->depth_count = good.depth_count;
  good.picture->segmentation = good.segmentation;
  good.picture->segmentation_count = good.segmentation_count;
}

/* Arrays that are read hold what is asked for: no actions, everything at the origin, the world's own state. */
static void fill_arrays(void) {
  size_t i;
  double* write = (double*)good.to_write;
  memset((void*)good.mask, 1, WORLDS_IN_BATCH);
  memset((void*)good.action, 0, good.action_count * sizeof(float));
  memset((void*)good.actions, 0, good.actions_count * sizeof(float));
  memset((void*)good.points, 0, 3 * good.point_count * sizeof(double));
  memset((void*)good.pose, 0, 7 * sizeof(double));
  ((double*)good.pose)[3] = 2;
  memset(write, 0, VALUES_PER_WORLD * sizeof(double));
  write[2] = write[3] = 1; /* a metre up, upright */
  for (i = 0; i < WORLDS_IN_BATCH; ++i) {
    memcpy((double*)good.all_to_write + i * VALUES_PER_WORLD, write, VALUES_PER_WORLD * sizeof(double));
  }
}

static void fill_states(void) {
  size_t i;
  memcpy((void*)good.state, first_state, good.state_bytes);
  memcpy((void*)good.memory, first_memory, good.memory_bytes);
  for (i = 0; i < WORLDS_IN_BATCH; ++i) {
    memcpy((unsigned char*)good.states + i * good.state_bytes, first_state, good.state_bytes);
  }
}

/* A geom, a texture and a light, and room for what is read of them. */
static void fill_geometry(void) {
  CHECK_OK(mimo_mesh_init(good.mesh, sizeof *good.mesh));
  good.mesh->segments = 4;
  good.mesh->positions = good.mesh->normals = good.mesh->texcoords = good.positions;
  good.mesh->indices = good.corners;
  good.mesh->vertex_capacity = good.mesh->index_capacity = MESH_ROOM;
  memset(good.texture, 0, sizeof *good.texture);
  good.texture->struct_size = sizeof *good.texture;
  good.texture->pixels = good.texels;
  good.texture->pixel_bytes = good.texture_bytes;
  memset(good.light, 0, sizeof *good.light);
  good.light->struct_size = sizeof *good.light;
}

args good_args(int uses) {
  size_t i;
  args a;
  for (i = 0; i < region_count; ++i) memset(regions[i].bytes, 0xab, regions[i].size);
  fill_configs();
  fill_results();
  fill_env_results();
  fill_movement();
  fill_resets();
  fill_picture();
  fill_geometry();
  fill_arrays();
  fill_states();
  fill_stage();
  *good.made_scene = NULL;
  *good.made_env = NULL;
  *good.made_batch = NULL;
  *good.made_senses = NULL;
  *good.made_recorder = NULL;
  *good.made_recording = NULL;
  CHECK_OK(mimo_recorder_config_init(good.recorder_config, sizeof *good.recorder_config));
  memset(good.recording_info, 0, sizeof *good.recording_info);
  good.recording_info->struct_size = sizeof *good.recording_info;
  memset(good.replay_report, 0, sizeof *good.replay_report);
  good.replay_report->struct_size = sizeof *good.replay_report;
  good.dataset = "time";
  good.row_count = 2;
  good.rows_bytes = 2 * sizeof(double);
  good.kind = MIMO_BODY;
  good.quantity = MIMO_JOINT_POSITION;
  good.receptor_quantity = MIMO_RECEPTOR_FRAME;
  good.steps = 1;
  good.axes = MIMO_AXES_UNITY;
  good.name = "toy";
  good.scene_name = "free";
  good.part = "head";
  good.other = "left_hand";
  good.room_name = "playroom";
  good.folder = "saved_scene";
  good.joint_name = "robot:head_tilt";
  good.path = "touch";
  good.field_name = "touch/force";
  good.motor_path = "right_arm";
  good.how = MIMO_LOOK_HEAD;
  good.parameter_name = "reach/success_reward";
  good.spacing = 0.05;
  good.rate = 16000;
  good.cart = "cart";
  good.model = host_model;
  good.data = host_data;
  a = good;
  /* Calls change scenes for good. */
  if (uses & ON_SCENE) a.scene = make_scene("selfbody", "mitten");
  if (uses & ON_CART) a.scene = make_cart();
  if (uses & ON_ROOM) a.room = make_scene("free", NULL);
  if (uses & ON_BEHAVIOUR) a.room = make_scene("sit", NULL);
  if (uses & ON_EMPTY) a.room = make_scene(NULL, NULL);
  return a;
}

void remember_memory(void) {
  size_t i;
  for (i = 0; i < region_count; ++i) memcpy(regions[i].kept, regions[i].bytes, regions[i].size);
}

int memory_changed(void) {
  size_t i;
  for (i = 0; i < region_count; ++i) {
    if (memcmp(regions[i].kept, regions[i].bytes, regions[i].size) != 0) return 1;
  }
  return 0;
}

int destroy_made(args* a) {
  int made = *good.made_scene != NULL || *good.made_env != NULL || *good.made_batch != NULL ||
             *good.made_senses != NULL || *good.made_recorder != NULL || *good.made_recording != NULL ||
             *good.made_stage != NULL;
  mimo_scene_destroy(*good.made_scene);
  mimo_env_destroy(*good.made_env);
  mimo_batch_destroy(*good.made_batch);
  mimo_senses_destroy(*good.made_senses);
  CHECK_OK(mimo_recorder_close(*good.made_recorder));
  mimo_recording_close(*good.made_recording);
  mimo_stage_destroy(*good.made_stage);
  mimo_scene_destroy(a->room);
  if (a->scene != spare_scene) mimo_scene_destroy(a->scene);
  return made;
}

mimo_scene* retired_scene(void) { return dead_scene; }
mimo_env* retired_env(void) { return dead_env; }
mimo_batch* retired_batch(void) { return dead_batch; }
mimo_senses* retired_senses(void) { return dead_senses; }
mimo_recorder* retired_recorder(void) { return dead_recorder; }
mimo_recording* retired_recording(void) { return dead_recording; }
mimo_stage* retired_stage(void) { return dead_stage; }
mimo_layout* retired_layout(void) { return (mimo_layout*)dead_layout; }
void* no_handle(void) { return not_a_handle; }
const void* foreign_state(void) { return foreign; }

/* A toy that flies at 1e200 m/s is beyond what MuJoCo takes for a velocity. */
void break_worlds(void) {
  double velocity[WORLDS_IN_BATCH * 6] = {0};
  size_t i;
  for (i = 0; i < WORLDS_IN_BATCH; ++i) velocity[6 * i] = 1e200;
  CHECK_OK(mimo_env_set(good.env, MIMO_JOINT_VELOCITY, good.ids, 1, velocity, 6));
  CHECK_OK(mimo_batch_set(good.batch, MIMO_JOINT_VELOCITY, good.ids, 1, NULL, 0, velocity, 6 * WORLDS_IN_BATCH));
  CHECK_FAILS(MIMO_E_SIMULATION, "QVEL", mimo_env_physics_step(good.env, 1));
  CHECK_FAILS(MIMO_E_SIMULATION, "QVEL", mimo_batch_step(good.batch, NULL, 0, NULL, 0, NULL));
}

void mend_worlds(void) {
  CHECK_OK(mimo_env_reset(good.env, NULL, NULL, 0));
  CHECK_OK(mimo_batch_reset(good.batch, NULL, NULL, 0));
}

int world_failures(void) { return failures(); }
