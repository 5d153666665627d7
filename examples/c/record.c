/* Keeps what a program does: every step of the world is recorded by itself, and the reset in between is found. Then the
 * run is played again in another world, from the middle, and compared to the last bit.
 *
 *   cc record.c $(pkg-config --cflags --libs mimo) -lm && ./a.out
 */
#include <math.h>
#include <mimo/experimental.h>
#include <stdio.h>
#include <stdlib.h>

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  fprintf(stderr, "%s: %s\n", mimo_status_name(status), mimo_last_error());
  exit(status == MIMO_E_UNSUPPORTED ? 77 : 1); /* the HDF5 library is missing */
}

/* What a lab's program does; it knows nothing of recordings. */
static void babble(mimo_env* env, int steps) {
  float action[100];
  const mimo_layout* layout;
  mimo_layout_info sizes = {.struct_size = sizeof sizes};
  check(mimo_env_layout(env, &layout));
  check(mimo_layout_describe(layout, &sizes));
  for (int step = 0; step < steps; ++step) {
    for (size_t i = 0; i < sizes.actions && i < 100; ++i) action[i] = sinf(0.1f * (float)step * (float)(i + 1));
    check(mimo_env_step(env, action, sizes.actions, NULL, 0, NULL));
  }
}

int main(void) {
  mimo_env *env, *twin;
  mimo_recorder* recorder;
  mimo_recorder_config config;
  mimo_recording* recording;
  mimo_recording_info info = {.struct_size = sizeof info};
  mimo_replay_report report = {.struct_size = sizeof report};
  size_t from;

  check(mimo_env_make("reach", &env));
  check(mimo_recorder_config_init(&config, sizeof config));
  config.keep = "proprioception";
  config.configuration = "{\"scene\": \"reach\", \"who\": \"examples/c/record.c\"}";
  check(mimo_recorder_open(env, "record_example.h5", &config, &recorder));
  babble(env, 120);
  check(mimo_env_reset(env, NULL, NULL, 0));
  babble(env, 60);
  check(mimo_recorder_close(recorder)); /* says so where the disk was full */
  mimo_env_destroy(env);

  check(mimo_recording_open("record_example.h5", NULL, &recording));
  check(mimo_recording_describe(recording, &info));
  printf("%s: %zu steps, %zu states\n", info.configuration, info.steps, info.states);
  check(mimo_env_make("reach", &twin));
  check(mimo_recording_seek(recording, twin, 110, MIMO_REPLAY_FIELDS, &from));
  for (; from < info.steps; ++from) check(mimo_recording_step(recording, twin, NULL, 0, NULL));
  check(mimo_recording_report(recording, &report));
  printf("%zu steps again: %s\n", report.steps, report.identical ? "identical" : report.differs_most_in);
  mimo_recording_close(recording);
  mimo_env_destroy(twin);
  remove("record_example.h5");
  return report.identical ? 0 : 1;
}
