/*
 * Errors, arguments, and the tables of scenes and worlds.
 *
 * Both are numbered; a number is what MATLAB holds. They live in tables of this file, which is locked in memory while
 * there are any, so that "clear all" does not lose them. Scenes have the numbers after those of worlds.
 */
#include "mimo_base.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kTable = 256, kMessage = 1024 };
static worlds table[kTable];
static mimo_scene* scenes[kTable];
static size_t living; /* in both */
static mimo_scene* making;

void mimo_making(mimo_scene* scene) {
  if (making != scene) mimo_scene_destroy(making);
  making = scene;
}

/* Whether the text up to `at` ends with a word that is followed by a number counted from 0: "world 0". */
static int counts(const char* text, const char* at) {
  static const char* words[] = {"action", "actuator", "agent",  "body", "camera", "field",
                                "geom",   "joint",    "sensor", "site", "world"};
  size_t i;
  if (at == text || at[-1] != ' ') return 0;
  for (i = 0; i < sizeof words / sizeof *words; ++i) {
    const size_t length = strlen(words[i]);
    const char* word = at - 1 - length;
    if ((size_t)(at - text) > length && strncmp(word, words[i], length) == 0 &&
        (word == text || !isalpha((unsigned char)word[-1])))
      return 1;
  }
  return 0;
}

/* A message of the library's as MATLAB counts: "world 0: action[1] is 2" is "world 1: action(2) is 2". What is quoted
   is a name, and stays. */
static void count_from_one(const char* from, char* to, size_t capacity) {
  const char* text = from;
  size_t used = 0;
  int quoted = 0;
  while (*from != '\0' && used + 1 < capacity) {
    const int bracket = *from == '[' && isdigit((unsigned char)from[1]);
    if (!quoted && (bracket || (isdigit((unsigned char)*from) && counts(text, from)))) {
      char* end;
      const unsigned long number = strtoul(from + bracket, &end, 10) + 1;
      const int length = snprintf(to + used, capacity - used, bracket ? "(%lu)" : "%lu", number);
      used += length > 0 ? (size_t)length : 0;
      if (used >= capacity) used = capacity - 1;
      from = bracket && *end == ']' ? end + 1 : end;
    } else {
      quoted ^= *from == '"';
      to[used++] = *from++;
    }
  }
  to[used] = '\0';
}

const char* mimo_counted(const char* message) {
  static char counted[kMessage];
  count_from_one(message, counted, sizeof counted);
  return counted;
}

const char* mimo_status_word(mimo_status status) {
  return mimo_status_name(status) + strlen(status == MIMO_OK ? "MIMO_" : "MIMO_E_");
}

void mimo_check(mimo_status status) {
  char id[64] = "mimo:";
  if (status == MIMO_OK) return;
  mimo_making(NULL);
  strncat(id, mimo_status_word(status), sizeof id - strlen(id) - 1);
  mexErrMsgIdAndTxt(id, "%s", mimo_counted(mimo_last_error()));
}

void mimo_refuse(const char* format, ...) {
  char message[kMessage];
  va_list values;
  va_start(values, format);
  vsnprintf(message, sizeof message, format, values);
  va_end(values);
  mimo_making(NULL);
  mexErrMsgIdAndTxt("mimo:INVALID_ARGUMENT", "%s", message);
}

void mimo_need(int good, const char* message) {
  if (!good) mimo_refuse("%s", message);
}

char* mimo_text(const mxArray* text, const char* what) {
  if (!mxIsChar(text)) mimo_refuse("%s: expected a text", what);
  return mxArrayToString(text); /* MATLAB frees it at the end of the call */
}

double mimo_number(const mxArray* number, const char* what) {
  if ((!mxIsNumeric(number) && !mxIsLogical(number)) || mxIsComplex(number) || mxGetNumberOfElements(number) != 1)
    mimo_refuse("%s: expected a number", what);
  return mxGetScalar(number);
}

/* Where it stands in its table, or -1: a table's numbers follow the first. */
static int place_of(double number, int first) {
  return number >= first && number < first + kTable && number == floor(number) ? (int)number - first : -1;
}

static worlds* find_worlds(double number) {
  const int place = place_of(number, 1);
  return place >= 0 && table[place].batch != NULL ? &table[place] : NULL;
}

static mimo_scene** find_scene(double number) {
  const int place = place_of(number, kTable + 1);
  return place >= 0 && scenes[place] != NULL ? &scenes[place] : NULL;
}

static void refuse_handle(const char* expected, double number) {
  const char* what = find_worlds(number) != NULL ? "a world" : find_scene(number) != NULL ? "a scene" : NULL;
  if (what != NULL) mexErrMsgIdAndTxt("mimo:BAD_HANDLE", "%g is %s, expected a %s", number, what, expected);
  mexErrMsgIdAndTxt("mimo:BAD_HANDLE", "there is no %s %g; it was closed, or never made", expected, number);
}

worlds* mimo_any_worlds_of(const mxArray* number) {
  const double value = mimo_number(number, "world");
  worlds* all = find_worlds(value);
  if (all == NULL) refuse_handle("world", value);
  return all;
}

worlds* mimo_worlds_of(const mxArray* number) {
  worlds* all = mimo_any_worlds_of(number);
  mimo_need(!all->sent, "a step was sent; mimo_receive waits for it");
  return all;
}

mimo_scene* mimo_scene_of(const mxArray* number) {
  const double value = mimo_number(number, "scene");
  mimo_scene** scene = find_scene(value);
  if (scene == NULL) refuse_handle("scene", value);
  return *scene;
}

static size_t index_at(size_t count, const char* what, int nin, const mxArray* in[], int at) {
  double index = 1;
  if (nin > at) index = mimo_number(in[at], what);
  if (!(index >= 1 && index <= (double)count) || index != floor(index))
    mimo_refuse("%s is %g, expected a whole number from 1 to %d", what, index, (int)count);
  return (size_t)index - 1;
}

mimo_env* mimo_world_at(worlds* all, int nin, const mxArray* in[], int at) {
  mimo_env* env = NULL;
  mimo_check(mimo_batch_world(all->batch, index_at(all->count, "index", nin, in, at), &env));
  return env;
}

size_t mimo_agent_at(const worlds* all, int nin, const mxArray* in[], int at) {
  return index_at(all->agents, "agent", nin, in, at);
}

void mimo_add_text(mxArray* to, const char* name, const char* text) {
  mxSetFieldByNumber(to, 0, mxAddField(to, name), mxCreateString(text));
}

void mimo_add_numbers(mxArray* to, const char* name, const double* values, size_t rows, size_t columns) {
  mxArray* array = mxCreateDoubleMatrix(rows, columns, mxREAL);
  memcpy(mxGetPr(array), values, rows * columns * sizeof *values);
  mxSetFieldByNumber(to, 0, mxAddField(to, name), array);
}

static void free_worlds(worlds* all) {
  mimo_batch_destroy(all->batch);
  free(all->blocks);
  free(all->actions);
  free(all->reward);
  free(all->terminated);
  free(all->truncated);
  memset(all, 0, sizeof *all);
}

worlds* mimo_new_worlds(void) {
  size_t i;
  for (i = 0; i < kTable && table[i].batch != NULL; ++i) continue;
  mimo_need(i < kTable, "there are 256 worlds already; close some");
  return &table[i];
}

/* Asks what the worlds need. */
static mimo_status prepare(worlds* all) {
  mimo_status status = mimo_batch_world(all->batch, 0, &all->first);
  if (status == MIMO_OK) status = mimo_batch_size(all->batch, &all->count, NULL);
  if (status == MIMO_OK) status = mimo_env_observation_size(all->first, &all->bytes, &all->fields);
  if (status == MIMO_OK) status = mimo_env_action_size(all->first, &all->action_count);
  if (status == MIMO_OK) status = mimo_env_agent_count(all->first, &all->agents);
  if (status != MIMO_OK) return status;
  all->blocks = calloc(all->count, all->bytes + 1);
  all->actions = calloc(all->count, (all->action_count + 1) * sizeof *all->actions);
  all->reward = calloc(all->count, (all->agents + 1) * sizeof *all->reward);
  all->terminated = calloc(all->count, all->agents + 1);
  all->truncated = calloc(all->count, all->agents + 1);
  return all->blocks != NULL && all->actions != NULL && all->reward != NULL && all->terminated != NULL &&
                 all->truncated != NULL
             ? MIMO_OK
             : MIMO_E_OUT_OF_MEMORY;
}

double mimo_keep_worlds(worlds* all) {
  const mimo_status status = prepare(all);
  if (status != MIMO_OK) free_worlds(all);
  mimo_check(status);
  if (living++ == 0) mexLock();
  return (double)(all - table + 1);
}

double mimo_keep_scene(mimo_scene* scene) {
  size_t i;
  for (i = 0; i < kTable && scenes[i] != NULL; ++i) continue;
  mimo_need(i < kTable, "there are 256 scenes already; close some");
  scenes[i] = scene;
  making = NULL;
  if (living++ == 0) mexLock();
  return (double)(kTable + 1 + i);
}

void mimo_close_number(const mxArray* number) {
  mimo_scene** scene = find_scene(mimo_number(number, "world"));
  if (scene != NULL) {
    mimo_scene_destroy(*scene);
    *scene = NULL;
  } else {
    free_worlds(mimo_any_worlds_of(number));
  }
  if (--living == 0) mexUnlock();
}

void mimo_close_all(void) {
  size_t i;
  for (i = 0; i < kTable; ++i) {
    free_worlds(&table[i]);
    mimo_scene_destroy(scenes[i]);
    scenes[i] = NULL;
  }
  mimo_making(NULL);
}
