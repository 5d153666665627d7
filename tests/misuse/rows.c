/* The table itself, and what its rows do beyond changing one member. */
#include "misuse/world.h"
#include "support/capi.h"

#define CHECKED(condition) ((condition) ? MIMO_OK : MIMO_E_INTERNAL)

/* ---- Functions without a status ---- */

static int is_version(const char* text) {
  int major, minor, patch;
  return sscanf(text, "%d.%d.%d", &major, &minor, &patch) == 3;
}

static mimo_status check_status_names(void) {
  int32_t status;
  for (status = MIMO_E_INTERNAL; status < 0; ++status) {
    if (strncmp(mimo_status_name(status), "MIMO_E_", 7) != 0) return MIMO_E_INTERNAL;
  }
  if (strcmp(mimo_status_name(MIMO_OK), "MIMO_OK") != 0) return MIMO_E_INTERNAL;
  for (status = 1; status < 4; ++status) {
    if (strcmp(mimo_status_name(status), "MIMO_E_UNKNOWN") != 0) return MIMO_E_INTERNAL;
  }
  if (strcmp(mimo_status_name(INT32_MIN), "MIMO_E_UNKNOWN") != 0) return MIMO_E_INTERNAL;
  return CHECKED(strcmp(mimo_status_name(INT32_MAX), "MIMO_E_UNKNOWN") == 0);
}

/* Memory that is long enough, but holds no struct of MuJoCo's. */
static const void* not_a_model(void) {
  static double junk[10000];
  return junk;
}

/* Of a handle of its own: those of the table are refused by a function for their kind, this one takes any. */
static mimo_status last_error_of(args* a) {
  static mimo_scene* scene = NULL;
  if (scene == NULL && mimo_scene_create(NULL, &scene) != MIMO_OK) return MIMO_E_INTERNAL;
  return mimo_last_error_of(scene, a->text, a->capacity, a->count);
}

static mimo_status check_list(const char* (*entry)(size_t)) {
  size_t count = 0;
  while (count < 100 && entry(count) != NULL) ++count;
  return CHECKED(count > 0 && count < 100 && entry(SIZE_MAX) == NULL);
}

/* Destroying what is none of the function's own does nothing, says nothing and breaks nothing. */
static mimo_status check_destroy_scene(args* a) {
  char before[512];
  snprintf(before, sizeof before, "%s", mimo_last_error());
  mimo_scene_destroy(NULL);
  mimo_scene_destroy(retired_scene());
  mimo_scene_destroy((mimo_scene*)a->env);
  mimo_scene_destroy((mimo_scene*)a->batch);
  mimo_scene_destroy(no_handle());
  mimo_scene_destroy(a->scene);
  mimo_scene_destroy(a->scene);
  return CHECKED(strcmp(before, mimo_last_error()) == 0);
}

static mimo_status check_destroy_env(args* a) {
  char before[512];
  size_t count = 0;
  snprintf(before, sizeof before, "%s", mimo_last_error());
  mimo_env_destroy(NULL);
  mimo_env_destroy(retired_env());
  mimo_env_destroy((mimo_env*)a->scene);
  mimo_env_destroy((mimo_env*)a->batch);
  mimo_env_destroy(no_handle());
  return CHECKED(strcmp(before, mimo_last_error()) == 0 && mimo_batch_size(a->batch, &count, NULL) == MIMO_OK);
}

static mimo_status check_destroy_batch(args* a) {
  char before[512];
  snprintf(before, sizeof before, "%s", mimo_last_error());
  mimo_batch_destroy(NULL);
  mimo_batch_destroy(retired_batch());
  mimo_batch_destroy((mimo_batch*)a->scene);
  mimo_batch_destroy((mimo_batch*)a->env);
  mimo_batch_destroy(no_handle());
  return CHECKED(strcmp(before, mimo_last_error()) == 0);
}

static mimo_status check_destroy_senses(args* a) {
  char before[512];
  size_t count = 0;
  snprintf(before, sizeof before, "%s", mimo_last_error());
  mimo_senses_destroy(NULL);
  mimo_senses_destroy(retired_senses());
  mimo_senses_destroy((mimo_senses*)a->scene);
  mimo_senses_destroy((mimo_senses*)a->env);
  mimo_senses_destroy((mimo_senses*)a->batch);
  mimo_senses_destroy(no_handle());
  return CHECKED(strcmp(before, mimo_last_error()) == 0 && mimo_senses_state_size(a->senses, &count) == MIMO_OK);
}

/* A recording of an earlier call would be in the way. */
static mimo_status open_recorder(args* a) {
  if (a->new_run != NULL) remove(a->new_run);
  return mimo_recorder_open(a->env, a->new_run, a->recorder_config, a->made_recorder);
}

/* An agent has one sense of a name: world.c has room for a number in it. */
static mimo_status add_sense(args* a) {
  static int number = 1000;
  if (a->sense != NULL && a->sense->name != NULL) snprintf((char*)a->sense->name, 12, "%d", ++number);
  return mimo_scene_add_sense(a->scene, a->agent_index, a->sense);
}

static mimo_status describe_sense(args* a) {
  add_sense(a);
  return mimo_scene_sense_parameter(a->scene, a->index, a->parameter);
}

/* What can only be refused here: there is no library, no function of a sense, no recording with a sense. */
static mimo_status refused(mimo_status status, const char* words) {
  return status != MIMO_OK && strstr(mimo_last_error(), words) != NULL ? MIMO_OK : status;
}

static mimo_status check_close_recorder(args* a) {
  char before[512];
  snprintf(before, sizeof before, "%s", mimo_last_error());
  CHECK_OK(mimo_recorder_close(NULL));
  CHECK_OK(mimo_recorder_close(retired_recorder()));
  CHECK_OK(mimo_recorder_close((mimo_recorder*)a->env));
  CHECK_OK(mimo_recorder_close(no_handle()));
  return CHECKED(strcmp(before, mimo_last_error()) == 0 && mimo_recorder_flush(a->recorder) == MIMO_OK);
}

static mimo_status check_destroy_recording(args* a) {
  char before[512];
  size_t count = 0;
  snprintf(before, sizeof before, "%s", mimo_last_error());
  mimo_recording_close(NULL);
  mimo_recording_close(retired_recording());
  mimo_recording_close((mimo_recording*)a->env);
  mimo_recording_close(no_handle());
  return CHECKED(strcmp(before, mimo_last_error()) == 0 &&
                 mimo_recording_size(a->recording, "time", &count, NULL) == MIMO_OK);
}

static mimo_status check_destroy_stage(args* a) {
  char before[512];
  const mimo_stage_view* none = NULL;
  snprintf(before, sizeof before, "%s", mimo_last_error());
  mimo_stage_destroy(NULL);
  mimo_stage_destroy(retired_stage());
  mimo_stage_destroy((mimo_stage*)a->env);
  mimo_stage_destroy(no_handle());
  return CHECKED(strcmp(before, mimo_last_error()) == 0 &&
                 mimo_stage_draw(a->stage, (const mimo_stage_poses* const*)&a->stage_poses, 1, &none, 0) == MIMO_OK);
}

static mimo_status draw_stage(args* a) {
  const mimo_stage_poses* poses = a->stage_poses;
  const mimo_stage_view* view = a->stage_view;
  return mimo_stage_draw(a->stage, &poses, a->stage_pose_count, &view, 1);
}

static mimo_status seek_and_step(args* a) {
  const mimo_status status = mimo_recording_seek(a->recording, a->env, 0, 0, NULL);
  return status != MIMO_OK ? status
                           : mimo_recording_step(a->recording, a->env, a->block, a->block_bytes, a->env_results);
}

static int send_first = 1;

static mimo_status send_and_receive(args* a) {
  const int send = send_first;
  mimo_status status;
  send_first = 1;
  if (send) {
    status = mimo_batch_send(a->batch, a->actions, a->actions_count, a->blocks, a->blocks_bytes, a->results);
    if (status != MIMO_OK) return status;
  }
  return mimo_batch_receive(a->batch);
}

/* ---- Faults beyond one member ---- */

static void nothing_sent(args* a) { (void)a, send_first = 0; }
static void nothing_to_receive_from(args* a) { a->batch = retired_batch(), send_first = 0; }

static void keeps_wings(args* a) { a->recorder_config->keep = "wings"; }
static void no_run(args* a) { a->run = "/no_such_run.h5"; }
static void no_dataset(args* a) { a->dataset = "wings"; }

static void unknown_scene(args* a) { a->scene_config->name = "nowhere"; }
static void two_sources(args* a) { a->scene_config->xml = "<mujoco/>"; }
static void no_file(args* a) { a->scene_config->name = NULL, a->scene_config->file = "/no_such_file.xml"; }
static void no_xml(args* a) { a->scene_config->name = NULL, a->scene_config->xml = "no XML"; }
static void not_mjcf(args* a) { a->scene_config->name = NULL, a->scene_config->xml = "<robot/>"; }
static void no_model_dir(args* a) { a->scene_config->model_dir = "/no_such_folder"; }

/* Readers of XML that work by recursion run out of stack. */
static void deep_xml(args* a) {
  enum { DEPTH = 100000 };
  static char text[32 + 7 * DEPTH];
  char* at = text + sprintf(text, "<mujoco>");
  int i;
  for (i = 0; i < DEPTH; ++i, at += 3) memcpy(at, "<a>", 3);
  for (i = 0; i < DEPTH; ++i, at += 4) memcpy(at, "</a>", 4);
  strcpy(at, "</mujoco>");
  a->scene_config->name = NULL;
  a->scene_config->xml = text;
}

static void no_orientation(args* a) { memset(a->agent_config->orientation, 0, sizeof a->agent_config->orientation); }
static void bad_agent_name(args* a) { a->agent_config->name = "an na"; }
static void unknown_body(args* a) { a->agent_config->body = "centaur"; }
static void apart(args* a) {
  a->growth->matures_apart = 1;
  a->growth->physiological_age = 25;
}
static void two_measures(args* a) {
  a->growth->percentile = 10;
  a->growth->z_head = 1;
}
/* An age that is good or not, in all that resets and batches are given. */
static void become(args* a, size_t count) {
  static const mimo_growth* all[16];
  size_t i;
  for (i = 0; i < 16; ++i) all[i] = a->growth;
  a->reset_config->growth = a->batch_config->cohort = a->batch_reset->growth = all;
  a->reset_config->growth_count = a->batch_config->cohort_count = count;
}
static void too_old(args* a) { become(a, 1), a->growth->age = 25; }
static void too_many_ages(args* a) { become(a, 16); }
static void no_ages(args* a) { a->reset_config->growth_count = a->batch_config->cohort_count = 1; }
static void no_positions(args* a) { a->movement->positions = NULL; }
static void taken_agent(args* a) { CHECK_OK(mimo_scene_add_agent(a->room, NULL, NULL)); }
static void unknown_part(args* a) { a->part = "tail"; }
static void bad_model_name(args* a) { a->model_config->name = "te/a"; }
static void taken_model(args* a) { a->model_config->name = "toy"; }
static void two_models(args* a) { a->model_config->file = "cup.xml"; }
static void no_model_file(args* a) { a->model_config->xml = NULL, a->model_config->file = "/no_such_file.xml"; }
static void two_bodies(args* a) { a->model_config->xml = "<mujoco><worldbody><body/><body/></worldbody></mujoco>"; }
static void folder_in_a_file(args* a) { a->folder = "/proc/version/below"; }
static void unknown_room(args* a) { a->room_name = "attic"; }
static void second_room(args* a) { CHECK_OK(mimo_scene_set_room(a->room, a->room_name)); }
static void unknown_other(args* a) { a->other = "ghost"; }
static void weld_to_itself(args* a) { a->other = a->part; }
static void pose_of_nan(args* a) { ((double*)a->pose)[6] = NAN; }
static void pose_of_zeros(args* a) { ((double*)a->pose)[3] = 0; }
static void unknown_joint(args* a) { a->joint_name = "tail"; }
static void taken_object(args* a) { a->object_config->name = "toy"; }
static void no_text(args* a) { a->text = NULL, a->capacity = 0; }
static void unknown_parameter(args* a) { a->parameter_name = "mood"; }
static void no_evaluate(args* a) { a->task->evaluate = NULL; }
static void no_open(args* a) { a->sense->open = NULL; }
static void no_write(args* a) { a->sense->write = NULL; }
static void unknown_renderer(args* a) { a->env_config->renderer = a->senses_config->renderer = "crayons"; }
static void no_renderer(args* a) { a->env_config->renderer = "none"; }
static void unknown_task(args* a) { a->env_config->task = "homework"; }
static void no_custom_task(args* a) { a->env_config->task = "custom"; }
static void unknown_scene_name(args* a) { a->scene_name = "nowhere"; }
static void no_scene_name(args* a) { a->scene_name = ""; }

static void nan_action(args* a) { ((float*)a->action)[1] = NAN; }
static void infinite_action(args* a) { ((float*)a->action)[1] = -INFINITY; }
static void no_block(args* a) { a->block = NULL, a->block_bytes = 0; }
static void no_pixels(args* a) { a->texture->pixels = NULL, a->texture->pixel_bytes = 0; }
static void no_blocks(args* a) { a->blocks = NULL, a->blocks_bytes = 0; }
static void no_final_blocks(args* a) { a->results->final_blocks = NULL; }

static void set_id(args* a, int32_t id) {
  static int32_t ids[1];
  ids[0] = id;
  a->ids = ids;
}
static void negative_id(args* a) { set_id(a, -1); }
static void huge_id(args* a) { set_id(a, INT32_MAX); }
static void unknown_name(args* a) { a->name = "nobody"; }
static void empty_name(args* a) { a->name = ""; }
static void write_value(args* a, double value) {
  ((double*)a->to_write)[0] = value;
  ((double*)a->all_to_write)[0] = value;
}
static void nan_value(args* a) { write_value(a, NAN); }
static void infinite_value(args* a) { write_value(a, INFINITY); }
static void no_model(args* a) { a->model = not_a_model(); }
static void no_data(args* a) { a->data = not_a_model(); }
static void unknown_field(args* a) { a->field_name = "smell"; }
static void unknown_camera(args* a) { a->picture_config->camera = "nobody's"; }
static void no_camera_body(args* a) { a->camera_config->body = "ghost"; }
static void requested_already(args* a) { CHECK_OK(mimo_scene_add_field(a->scene, a->field_config)); }
static void no_frame(args* a) { a->field_config->quantity = MIMO_BODY_MASS, a->field_config->relative_to = "head"; }
static void watched_already(args* a) { CHECK_OK(mimo_scene_add_camera(a->scene, a->camera_config)); }
static void nan_point(args* a) { ((double*)a->points)[0] = NAN; }

static void no_state(args* a) { memset((void*)a->state, 0, a->state_bytes); }
static void damaged_state(args* a) { ((unsigned char*)a->state)[a->state_bytes - 1] ^= 1; }
static void foreign_state_given(args* a) { memcpy((void*)a->state, foreign_state(), 64); }
#define foreign_state foreign_state_given
static void damaged_memory(args* a) { ((unsigned char*)a->memory)[a->memory_bytes - 1] ^= 1; }
static void state_as_memory(args* a) { a->memory = a->state, a->memory_bytes = a->state_bytes; }

static void same_joint(args* a) { CHECK_OK(mimo_scene_read_joint(a->scene, 0, a->name)); }
static void root_and_body(args* a) { a->agent_config->root = "torso"; }
static void root_and_groups(args* a) {
  a->agent_config->root = "torso";
  a->agent_config->body = "scene";
  a->agent_config->acts = MIMO_ACT_HEAD;
}

static void root_with_reflexes(args* a) {
  a->agent_config->root = "torso";
  a->agent_config->body = "scene";
  a->agent_config->reflexes = MIMO_REFLEX_MORO;
}

/* ---- The table ---- */

#define NONE \
  { FAULT_END, NULL, 0, 0, 0, 0, NULL, 0, NULL }
#define ALL_ROWS "misuse/all_rows.h"

#define ROW(name, uses, expression, ...)    \
  static mimo_status call_##name(args* a) { \
    (void)a;                                \
    return expression;                      \
  }
#include ALL_ROWS
#undef ROW

#define ROW(name, uses, expression, ...) static const fault faults_##name[] = {__VA_ARGS__, NONE};
#include ALL_ROWS
#undef ROW

#define ROW(name, uses, expression, ...) {#name, uses, call_##name, faults_##name},
const row all_rows[] = {
#include ALL_ROWS
};
#undef ROW

const size_t row_count = sizeof all_rows / sizeof *all_rows;

int rows_failures(void) { return failures(); }
