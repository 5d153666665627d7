/* Recordings keep the fields of own senses. A replay needs the sense; without it, the message names it. A recording
 * never loads code. */
#include "support/capi.h"

enum { STEPS = 20 };

static mimo_status open_ticks(void* user, const mimo_env* env, const mimo_sense_moment* moment,
                              mimo_sense_needs* needs) {
  mimo_sense_field field;
  (void)user, (void)moment;
  needs->memory_bytes = sizeof(double);
  CHECK_OK(mimo_sense_field_init(&field, sizeof field));
  return mimo_sense_add_field(env, &field);
}

static mimo_status advance_ticks(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  double* sum = moment->memory;
  (void)user, (void)env;
  *sum += moment->parameters[0] * (1 + mimo_sense_noise(moment->seed, moment->tick, 0));
  return MIMO_OK;
}

static mimo_status write_ticks(void* user, const mimo_env* env, const mimo_sense_moment* moment) {
  (void)user, (void)env;
  *(float*)moment->fields[0] = (float)*(const double*)moment->memory;
  return MIMO_OK;
}

static const mimo_parameter parameters[1] = {
    {.struct_size = sizeof(mimo_parameter), .name = "gain", .description = "1", .standard = 1, .low = 0, .high = 5}};

static mimo_sense ticks_sense(const char* name) {
  mimo_sense sense;
  CHECK_OK(mimo_sense_init(&sense, sizeof sense));
  sense.interface_version = MIMO_SENSE_INTERFACE;
  sense.name = name;
  sense.parameters = parameters;
  sense.parameter_count = 1;
  sense.open = open_ticks;
  sense.advance = advance_ticks;
  sense.write = write_ticks;
  return sense;
}

/* Records, and gives what the field was in each step. */
static void record(const char* path, float* expected) {
  const mimo_sense sense = ticks_sense("ticks");
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  mimo_recorder* recorder = NULL;
  mimo_recorder_config config;
  mimo_layout_info info = {.struct_size = sizeof info};
  mimo_field field = {.struct_size = sizeof field};
  size_t index = 0;
  unsigned char* block;
  int step;
  CHECK_OK(mimo_scene_add_sense(scene, 0, &sense));
  CHECK_OK(mimo_scene_set_parameter(scene, "ticks/gain", 2));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_layout_describe(layout_of(env), &info));
  CHECK_OK(mimo_layout_find(layout_of(env), "ticks", &index));
  CHECK_OK(mimo_layout_field(layout_of(env), index, &field));
  block = malloc(info.block_bytes);
  CHECK_OK(mimo_env_reset(env, SEED(5), NULL, 0));
  CHECK_OK(mimo_recorder_config_init(&config, sizeof config));
  config.keep = "ticks";
  config.replace = 1;
  CHECK_OK(mimo_recorder_open(env, path, &config, &recorder));
  for (step = 0; step < STEPS; ++step) {
    CHECK_OK(mimo_env_step(env, NULL, 0, block, info.block_bytes, NULL));
    memcpy(&expected[step], block + field.offset, sizeof(float));
  }
  CHECK_OK(mimo_recorder_close(recorder));
  free(block);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

int main(void) {
  const char* const path = "own_sense_recording.h5";
  const mimo_sense sense = ticks_sense("ticks"), stranger = ticks_sense("stranger");
  float expected[STEPS], kept[STEPS];
  mimo_recording* recording = NULL;
  mimo_env* env = NULL;
  mimo_replay_report report = {.struct_size = sizeof report};
  int step;
  if (mimo_recording_open("nowhere.h5", NULL, &recording) == MIMO_E_UNSUPPORTED) return 77; /* there is no HDF5 */
  record(path, expected);
  CHECK_OK(mimo_recording_open(path, NULL, &recording));
  CHECK_OK(mimo_recording_read(recording, "fields/ticks", 0, STEPS, kept, sizeof kept));
  CHECK(memcmp(kept, expected, sizeof kept) == 0 && kept[0] != kept[1]);
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "the recording needs the sense \"ticks\": mimo_recording_add_sense",
              mimo_recording_env(recording, NULL, NULL, &env));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no sense \"stranger\" of its own; it has: ticks",
              mimo_recording_add_sense(recording, &stranger));
  CHECK_OK(mimo_recording_add_sense(recording, &sense));
  CHECK_OK(mimo_recording_env(recording, NULL, NULL, &env));
  CHECK_OK(mimo_recording_seek(recording, env, 0, MIMO_REPLAY_FIELDS, NULL));
  for (step = 0; step < STEPS; ++step) CHECK_OK(mimo_recording_step(recording, env, NULL, 0, NULL));
  CHECK_OK(mimo_recording_report(recording, &report));
  CHECK(report.identical == 1 && report.steps == STEPS);
  mimo_env_destroy(env);
  mimo_recording_close(recording);
  remove(path);
  return failures();
}
