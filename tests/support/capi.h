/* Checks for tests in C. A failed check is told and counted; main ends with `return failures();`. */
#ifndef MIMO_TESTS_SUPPORT_CAPI_H
#define MIMO_TESTS_SUPPORT_CAPI_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mimo/experimental.h"
#ifndef __cplusplus
#include "support/calls.h"
#endif

static int failed_checks = 0;

static inline int failures(void) {
  if (failed_checks > 0) fprintf(stderr, "%d checks failed\n", failed_checks);
  return failed_checks > 0;
}

static inline void check(int good, const char* what, int line) {
  if (good) return;
  ++failed_checks;
  fprintf(stderr, "line %d: %s\n", line, what);
}

static inline void check_status(mimo_status expected, const char* part, mimo_status actual, const char* what,
                                int line) {
  const char* text = mimo_last_error();
  if (expected == actual && (actual == MIMO_OK || strstr(text, part) != NULL)) return;
  ++failed_checks;
  fprintf(stderr, "line %d: %s\n  gave %s, last error \"%s\"\n  expected %s, \"%s\"\n", line, what,
          mimo_status_name(actual), text, mimo_status_name(expected), part);
}

static inline void check_near(double expected, double actual, double tolerance, const char* what, int line) {
  if (fabs(actual - expected) <= tolerance) return;
  ++failed_checks;
  fprintf(stderr, "line %d: %s is %.17g, expected %.17g\n", line, what, actual, expected);
}

#define CHECK(condition) check((condition) != 0, #condition, __LINE__)
#define CHECK_TEXT(expected, actual) check(strcmp((expected), (actual)) == 0, #actual " is not " #expected, __LINE__)
#define CHECK_NEAR(expected, actual, tolerance) check_near((expected), (actual), (tolerance), #actual, __LINE__)
#define CHECK_OK(call) check_status(MIMO_OK, "", (call), #call, __LINE__)
/* The call gives this status, and the message holds the text. */
#define CHECK_FAILS(status, part, call) check_status((status), (part), (call), #call, __LINE__)

/* A scene with one infant that sees nothing, as most tests need it. */
static inline mimo_scene* blind_scene(const char* name) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = name;
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  return scene;
}

/* An environment of it; config may be NULL. */
static inline mimo_env* blind_env(const char* name, const mimo_env_config* config) {
  mimo_scene* scene = blind_scene(name);
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_create(scene, config, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static inline const mimo_layout* layout_of(const mimo_env* env) {
  const mimo_layout* layout = NULL;
  CHECK_OK(mimo_env_layout(env, &layout));
  return layout;
}

/* How much an environment observes, acts with and is rewarded for. */
static inline mimo_layout_info sizes_of(const mimo_env* env) {
  mimo_layout_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_OK(mimo_layout_describe(layout_of(env), &info));
  return info;
}

static inline mimo_field field_at(const mimo_layout* layout, size_t index) {
  mimo_field field;
  memset(&field, 0, sizeof field);
  field.struct_size = sizeof field;
  CHECK_OK(mimo_layout_field(layout, index, &field));
  return field;
}

static inline mimo_field field_of(const mimo_env* env, const char* name) {
  size_t index = 0;
  CHECK_OK(mimo_layout_find(layout_of(env), name, &index));
  return field_at(layout_of(env), index);
}

/* How late one element of a field comes. */
static inline double delay_of(const mimo_env* env, const char* name, size_t element) {
  const mimo_field field = field_of(env, name);
  size_t index = 0, count = 1, i;
  double *all, seconds;
  for (i = 0; i < field.ndim; ++i) count *= field.shape[i];
  all = (double*)malloc(count * sizeof *all);
  CHECK_OK(mimo_layout_find(layout_of(env), name, &index));
  CHECK_OK(mimo_layout_delays(layout_of(env), index, all, count));
  seconds = all[element];
  free(all);
  return seconds;
}

static inline mimo_action action_at(const mimo_env* env, size_t index) {
  mimo_action action;
  memset(&action, 0, sizeof action);
  action.struct_size = sizeof action;
  CHECK_OK(mimo_layout_action(layout_of(env), index, &action));
  return action;
}

static inline const char* term_name(const mimo_env* env, size_t index) {
  mimo_term term;
  memset(&term, 0, sizeof term);
  term.struct_size = sizeof term;
  CHECK_OK(mimo_layout_term(layout_of(env), index, &term));
  return term.name;
}

static inline int32_t find(const mimo_env* env, int32_t kind, const char* name) {
  int32_t id = -1;
  CHECK_OK(mimo_env_find(env, kind, name, &id));
  return id;
}

#endif
