/* Commands for recordings and their replay. */
#include "mimo_recordings.h"

#include <math.h>

#include "mimo_arrays.h"
#include "mimo_options.h"
#include "mimo_words.h"

/* record(number, file, index, name, value, ...) */
static void record(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_recorder_config config;
  properties given;
  worlds* all;
  (void)nout, (void)out;
  mimo_need(nin >= 3, "expected a world and a file");
  all = mimo_worlds_of(in[0]);
  mimo_need_first(all->recorder == NULL, "one of these worlds is being recorded; mimo_record_end ends the recording");
  given = mimo_pairs(nin - 3, in + 3);
  mimo_check(mimo_recorder_config_init(&config, sizeof config));
  mimo_set_all(&config, mimo_recorder_options, &given, "a recording");
  mimo_check(mimo_recorder_open(mimo_world_at(all, nin, in, 2), mimo_text(in[1], "file"), &config, &all->recorder));
}

/* The only argument: worlds one of which is being recorded. */
static worlds* being_recorded(int nin, const mxArray* in[]) {
  worlds* all;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  mimo_need_first(all->recorder != NULL, "this world is not being recorded; mimo_record starts a recording");
  return all;
}

/* flush(number) */
static void flush(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout, (void)out;
  mimo_check(mimo_recorder_flush(being_recorded(nin, in)->recorder));
}

/* endrecord(number) */
static void end_record(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all = being_recorded(nin, in);
  mimo_recorder* recorder = all->recorder;
  (void)nout, (void)out;
  all->recorder = NULL;
  mimo_check(mimo_recorder_close(recorder));
}

/* The open recording. Errors close it. */
static mimo_recording* open_recording;

static void check(mimo_status status) {
  if (status == MIMO_OK) return;
  mimo_recording_close(open_recording);
  open_recording = NULL;
  mimo_check(status);
}

static void open_file(const mxArray* file) {
  check(mimo_recording_open(mimo_text(file, "file"), NULL, &open_recording));
}

static void close_file(void) {
  mimo_recording_close(open_recording);
  open_recording = NULL;
}

static mimo_recording_info described(void) {
  mimo_recording_info info = {0};
  info.struct_size = sizeof info;
  check(mimo_recording_describe(open_recording, &info));
  return info;
}

/* struct = recording(file) */
static void recording(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_recording_info info;
  (void)nout;
  mimo_need(nin == 1, "expected a file");
  open_file(in[0]);
  info = described();
  out[0] = mimo_struct(&info, mimo_recording_members);
  close_file();
}

/* A world of the file's own, that errors do not leave open either. */
static mimo_env* own_world;

static void close_own_world(void) {
  mimo_env_destroy(own_world);
  own_world = NULL;
}

/* struct = replay(number or [], file, first, last, how): from the state before step `first` to behind step `last`, in a
   world, or in one that is made of the file */
static void replay(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_replay_report report = {0};
  size_t at = 0, last, steps;
  double first, end;
  worlds* all;
  mimo_env* env;
  (void)nout;
  mimo_need(nin == 5, "expected a world or [], a file, steps and how they are played");
  all = mxIsEmpty(in[0]) ? NULL : mimo_worlds_of(in[0]);
  first = mimo_whole(in[2], "first", 0, 9007199254740992.0);
  end = mimo_number(in[3], "last");
  if (!(end >= 0) || end != floor(end)) mimo_refuse("last is %g, expected a whole number from 0, or inf", end);
  open_file(in[1]);
  report.struct_size = sizeof report;
  steps = described().steps;
  last = end < (double)steps ? (size_t)end : steps;
  close_own_world();
  if (all == NULL) check(mimo_recording_env(open_recording, NULL, NULL, &own_world));
  env = all == NULL ? own_world : all->first;
  check(mimo_recording_seek(open_recording, env, (size_t)first,
                            (uint32_t)mimo_value_of(in[4], "how", &mimo_replay_words), &at));
  for (; at < last; ++at) {
    check(mimo_recording_step(open_recording, env, all == NULL ? NULL : all->blocks,
                              all == NULL ? 0 : all->sizes.block_bytes, NULL));
  }
  check(mimo_recording_report(open_recording, &report));
  out[0] = mimo_struct(&report, mimo_replay_report_members);
  close_own_world();
  close_file();
}

const mimo_command mimo_recording_commands[] = {{"record", record},       {"flush", flush},   {"endrecord", end_record},
                                                {"recording", recording}, {"replay", replay}, {NULL, NULL}};
