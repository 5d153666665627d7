/*
 * Errors, arguments, and the tables of worlds, scenes and stages. MATLAB holds their numbers; tables in this file have
 * the handles. While there are any, the gateway is locked in memory, so that "clear all" does not lose them. Numbers of
 * scenes follow those of worlds, and numbers of stages those of scenes.
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
static mimo_stage* stages[kTable];
static size_t living; /* in all of them */
static mimo_scene* making;

void mimo_making(mimo_scene* scene) {
  if (making != scene) mimo_scene_destroy(making);
  making = scene;
}

/* Whether the text up to `at` ends with a word whose number the library counts from 0: "world 0". */
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

/* A message of the library in MATLAB's counting: "world 0: action[1] is 2" becomes "world 1: action(2) is 2". Quoted
 * names stay unchanged. */
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

void mimo_need_first(int done, const char* message) {
  if (!done) mexErrMsgIdAndTxt("mimo:BUSY", "%s", message);
}

char* mimo_text(const mxArray* text, const char* what) {
  if (text == NULL || !mxIsChar(text)) mimo_refuse("%s: expected a text", what);
  if (mxGetNumberOfElements(text) > 0 && mxGetM(text) != 1)
    mimo_refuse("%s: expected a text in one row, not in %.0f rows", what, (double)mxGetM(text));
  return mxArrayToString(text); /* MATLAB frees it at the end of the call */
}

const char** mimo_texts(const mxArray* texts, size_t* count, const char* what) {
  const int many = texts != NULL && mxIsCell(texts);
  const char** all;
  size_t i;
  *count = 0;
  if (texts == NULL || (!many && !mxIsChar(texts) && mxIsEmpty(texts))) return NULL;
  *count = many ? mxGetNumberOfElements(texts) : 1;
  all = mxCalloc(*count + 1, sizeof *all);
  for (i = 0; i < *count; ++i) all[i] = mimo_text(many ? mxGetCell(texts, i) : texts, what);
  return all;
}

const mxArray* mimo_full(const mxArray* values) {
  mxArray* copy = NULL;
  if (!mxIsSparse(values)) return values;
  if (mexCallMATLAB(1, &copy, 1, (mxArray**)&values, "full") != 0) mimo_refuse("a sparse array cannot be made full");
  return copy; /* MATLAB frees it at the end of the call */
}

double mimo_number(const mxArray* number, const char* what) {
  if (number == NULL || (!mxIsNumeric(number) && !mxIsLogical(number)) || mxGetNumberOfElements(number) != 1)
    mimo_refuse("%s: expected a number", what);
  if (mxIsComplex(number)) mimo_refuse("%s: expected a real number, not a complex one", what);
  return mxGetScalar(mimo_full(number));
}

double mimo_whole(const mxArray* number, const char* what, double low, double high) {
  const double value = mimo_number(number, what);
  if (!(value >= low && value <= high) || value != floor(value))
    mimo_refuse("%s is %g, expected a whole number from %.0f to %.0f", what, value, low, high);
  return value;
}

const double* mimo_numbers(const mxArray* values, const char* what) {
  const size_t count = values == NULL ? 0 : mxGetNumberOfElements(values);
  const float* from;
  double* wide;
  size_t i;
  if (values == NULL || (!mxIsDouble(values) && !mxIsSingle(values)))
    mimo_refuse("%s: expected numbers, double or single", what);
  if (mxIsComplex(values)) mimo_refuse("%s: expected real numbers, not complex ones", what);
  values = mimo_full(values);
  if (mxIsDouble(values)) return mxGetPr(values);
  from = mxGetData(values);
  wide = mxCalloc(count + 1, sizeof *wide); /* MATLAB frees it at the end of the call */
  for (i = 0; i < count; ++i) wide[i] = from[i];
  return wide;
}

/* "2 x 3", with all dimensions. */
static const char* size_of(const mxArray* values) {
  static char text[128];
  const mwSize* sizes = mxGetDimensions(values);
  size_t used = 0, i;
  for (i = 0; i < (size_t)mxGetNumberOfDimensions(values) && used + 24 < sizeof text; ++i)
    used += (size_t)snprintf(text + used, sizeof text - used, i == 0 ? "%.0f" : " x %.0f", (double)sizes[i]);
  return text;
}

int mimo_is_vector(const mxArray* values) {
  return mxGetNumberOfDimensions(values) == 2 && (mxGetM(values) == 1 || mxGetN(values) == 1);
}

const double* mimo_vector(const mxArray* values, const char* what, size_t count) {
  const double* numbers = mimo_numbers(values, what);
  if (mxGetNumberOfElements(values) != count || !mimo_is_vector(values))
    mimo_refuse("%s is %s, expected %.0f numbers in a row or a column", what, size_of(values), (double)count);
  return numbers;
}

const double* mimo_matrix(const mxArray* values, const char* what, size_t rows, size_t columns, const char* meaning) {
  const double* numbers = mimo_numbers(values, what);
  const int is_so = mxGetNumberOfDimensions(values) == 2 && mxGetM(values) == rows && mxGetN(values) == columns;
  if (!is_so && !(mimo_is_vector(values) && mxGetNumberOfElements(values) == rows * columns))
    mimo_refuse("%s is %s, expected %.0f x %.0f: %s", what, size_of(values), (double)rows, (double)columns, meaning);
  return numbers;
}

/* Index in a table whose numbers start with `first`, or -1. */
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

static mimo_stage** find_stage(double number) {
  const int place = place_of(number, 2 * kTable + 1);
  return place >= 0 && stages[place] != NULL ? &stages[place] : NULL;
}

static void refuse_handle(const char* expected, double number) {
  const char* what = find_worlds(number) != NULL  ? "a world"
                     : find_scene(number) != NULL ? "a scene"
                     : find_stage(number) != NULL ? "a stage"
                                                  : NULL;
  if (what != NULL) mexErrMsgIdAndTxt("mimo:BAD_HANDLE", "%g is %s, expected a %s", number, what, expected);
  mexErrMsgIdAndTxt("mimo:BAD_HANDLE", "there is no %s %g; it was closed or never existed", expected, number);
}

worlds* mimo_any_worlds_of(const mxArray* number) {
  const double value = mimo_number(number, "world");
  worlds* all = find_worlds(value);
  if (all == NULL) refuse_handle("world", value);
  return all;
}

worlds* mimo_worlds_of(const mxArray* number) {
  worlds* all = mimo_any_worlds_of(number);
  mimo_need_first(!all->sent, "a step was sent; mimo_receive waits for it");
  return all;
}

mimo_scene* mimo_scene_of(const mxArray* number) {
  const double value = mimo_number(number, "scene");
  mimo_scene** scene = find_scene(value);
  if (scene == NULL) refuse_handle("scene", value);
  return *scene;
}

mimo_stage* mimo_stage_of(const mxArray* number) {
  const double value = mimo_number(number, "stage");
  mimo_stage** stage = find_stage(value);
  if (stage == NULL) refuse_handle("stage", value);
  return *stage;
}

static size_t index_at(size_t count, const char* what, int nin, const mxArray* in[], int at) {
  return nin > at ? (size_t)mimo_whole(in[at], what, 1, (double)count) - 1 : 0;
}

mimo_env* mimo_world_at(worlds* all, int nin, const mxArray* in[], int at) {
  mimo_env* env = NULL;
  mimo_check(mimo_batch_world(all->batch, index_at(all->count, "index", nin, in, at), &env));
  return env;
}

size_t mimo_agent_at(const worlds* all, int nin, const mxArray* in[], int at) {
  return index_at(all->sizes.agents, "agent", nin, in, at);
}

mxArray* mimo_name_of(const worlds* all, int32_t kind, int32_t id) {
  const char* name = NULL;
  mimo_check(mimo_env_name(all->first, kind, id, &name));
  return mxCreateString(name);
}

void mimo_add(mxArray* to, const char* name, mxArray* value) { mxSetFieldByNumber(to, 0, mxAddField(to, name), value); }

void mimo_add_text(mxArray* to, const char* name, const char* text) { mimo_add(to, name, mxCreateString(text)); }

void mimo_add_number(mxArray* to, const char* name, double value) { mimo_add(to, name, mxCreateDoubleScalar(value)); }

void mimo_add_numbers(mxArray* to, const char* name, const double* values, size_t rows, size_t columns) {
  mxArray* array = mxCreateDoubleMatrix(rows, columns, mxREAL);
  memcpy(mxGetPr(array), values, rows * columns * sizeof *values);
  mimo_add(to, name, array);
}

static void free_worlds(worlds* all) {
  mimo_batch_destroy(all->batch);
  mimo_recorder_close(all->recorder);
  free(all->blocks);
  free(all->finals);
  free(all->actions);
  free(all->results.reward);
  free(all->results.terminated);
  free(all->results.truncated);
  free(all->results.outcome);
  free(all->results.terms);
  free(all->results.was_reset);
  free(all->results.final_written);
  memset(all, 0, sizeof *all);
}

worlds* mimo_new_worlds(void) {
  size_t i;
  for (i = 0; i < kTable && table[i].batch != NULL; ++i) continue;
  mimo_need(i < kTable, "there are already 256 worlds; close some");
  return &table[i];
}

double mimo_number_of(const worlds* all) { return (double)(all - table + 1); }

/* Asks the library about new worlds. */
static mimo_status describe(worlds* all) {
  mimo_status status = mimo_batch_world(all->batch, 0, &all->first);
  all->sizes.struct_size = sizeof all->sizes;
  if (status == MIMO_OK) status = mimo_batch_size(all->batch, &all->count, NULL);
  if (status == MIMO_OK) status = mimo_batch_layout(all->batch, &all->layout);
  if (status == MIMO_OK) status = mimo_layout_describe(all->layout, &all->sizes);
  return status;
}

/* Allocates one element more than needed, so that an empty array is not NULL. */
#define ROOM(member, count) ((member = calloc((count) + 1, sizeof *(member))) != NULL)

static int room_for_results(mimo_batch_results* results) {
  return ROOM(results->reward, results->agent_count) && ROOM(results->terminated, results->agent_count) &&
         ROOM(results->truncated, results->agent_count) && ROOM(results->outcome, results->agent_count) &&
         ROOM(results->terms, results->term_count) && ROOM(results->was_reset, results->worlds) &&
         ROOM(results->final_written, results->worlds);
}

static mimo_status prepare(worlds* all, int final_blocks) {
  const mimo_status status = describe(all);
  mimo_batch_results* results = &all->results;
  const size_t bytes = all->count * all->sizes.block_bytes;
  if (status != MIMO_OK) return status;
  results->struct_size = sizeof *results;
  results->agent_count = all->count * all->sizes.agents;
  results->term_count = all->count * all->sizes.terms;
  results->worlds = all->count;
  if (!room_for_results(results) || !ROOM(all->blocks, bytes) || !ROOM(all->actions, all->count * all->sizes.actions) ||
      (final_blocks && !ROOM(all->finals, bytes)))
    return MIMO_E_OUT_OF_MEMORY;
  results->final_blocks = all->finals;
  results->final_bytes = final_blocks ? bytes : 0;
  return MIMO_OK;
}

void mimo_keep_worlds(worlds* all, int final_blocks) {
  const mimo_status status = prepare(all, final_blocks);
  if (status != MIMO_OK) free_worlds(all);
  mimo_check(status);
  if (living++ == 0) mexLock();
}

double mimo_new_scene(void) {
  size_t i;
  for (i = 0; i < kTable && scenes[i] != NULL; ++i) continue;
  mimo_need(i < kTable, "there are already 256 scenes; close some");
  return (double)(kTable + 1 + i);
}

void mimo_keep_scene(double number, mimo_scene* scene) {
  scenes[place_of(number, kTable + 1)] = scene;
  making = NULL;
  if (living++ == 0) mexLock();
}

double mimo_new_stage(void) {
  size_t i;
  for (i = 0; i < kTable && stages[i] != NULL; ++i) continue;
  mimo_need(i < kTable, "there are already 256 stages; close some");
  return (double)(2 * kTable + 1 + i);
}

void mimo_keep_stage(double number, mimo_stage* stage) {
  stages[place_of(number, 2 * kTable + 1)] = stage;
  if (living++ == 0) mexLock();
}

static void one_less(void) {
  if (--living == 0) mexUnlock();
}

void mimo_close_worlds(worlds* all) {
  free_worlds(all);
  one_less();
}

void mimo_close_number(const mxArray* number) {
  mimo_scene** scene = find_scene(mimo_number(number, "world"));
  mimo_stage** stage = find_stage(mimo_number(number, "world"));
  if (scene == NULL && stage == NULL) {
    mimo_close_worlds(mimo_any_worlds_of(number));
    return;
  }
  if (scene != NULL) {
    mimo_scene_destroy(*scene);
    *scene = NULL;
  } else {
    mimo_stage_destroy(*stage);
    *stage = NULL;
  }
  one_less();
}

void mimo_close_all(void) {
  size_t i;
  for (i = 0; i < kTable; ++i) {
    free_worlds(&table[i]);
    mimo_scene_destroy(scenes[i]);
    scenes[i] = NULL;
    mimo_stage_destroy(stages[i]);
    stages[i] = NULL;
  }
  mimo_making(NULL);
}
