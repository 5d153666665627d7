/*
 * The gateway from MATLAB and Octave to libmimo: mimo_mex('command', arguments...). The .m files beside it are what
 * one calls. It compiles with MATLAB's mex and with mkoctfile --mex.
 *
 * Worlds are numbered; a number is what MATLAB holds. They live in a table of this file, which is locked in memory
 * while there are any, so that "clear all" does not lose them.
 */
#include <math.h>
#include <mex.h>
#include <mimo/mimo.h>
#include <stdlib.h>
#include <string.h>

typedef struct world {
  mimo_env* env; /* NULL: free for another */
  void* block;
  float* actions;
  size_t bytes, fields, action_count, agents;
} world;

enum { kWorlds = 256 };
static world worlds[kWorlds];
static size_t living;

/* Errors carry the identifier mimo:NAME of the status: mimo:NOT_FOUND. */
static void check(mimo_status status) {
  char id[64] = "mimo:";
  if (status == MIMO_OK) return;
  strncat(id, mimo_status_name(status) + strlen("MIMO_E_"), sizeof id - strlen(id) - 1);
  mexErrMsgIdAndTxt(id, "%s", mimo_last_error());
}

static void need(int good, const char* message) {
  if (!good) mexErrMsgIdAndTxt("mimo:INVALID_ARGUMENT", "%s", message);
}

static void free_world(world* w) {
  mimo_env_destroy(w->env);
  free(w->block);
  free(w->actions);
  memset(w, 0, sizeof *w);
}

static void free_all(void) {
  size_t i;
  for (i = 0; i < kWorlds; ++i)
    if (worlds[i].env != NULL) free_world(&worlds[i]);
}

static world* world_of(const mxArray* number) {
  double value;
  need(mxIsDouble(number) && mxGetNumberOfElements(number) == 1, "a world is a number that mimo_create gave");
  value = mxGetScalar(number);
  if (!(value >= 1 && value <= kWorlds) || value != floor(value) || worlds[(int)value - 1].env == NULL)
    mexErrMsgIdAndTxt("mimo:BAD_HANDLE", "there is no world %g; it was closed, or never made", value);
  return &worlds[(int)value - 1];
}

/* Asks what the world needs; leaves nothing behind when it fails. */
static mimo_status prepare(world* w) {
  mimo_status status = mimo_env_observation_size(w->env, &w->bytes, &w->fields);
  if (status == MIMO_OK) status = mimo_env_action_size(w->env, &w->action_count);
  if (status == MIMO_OK) status = mimo_env_agent_count(w->env, &w->agents);
  if (status != MIMO_OK) return status;
  w->block = calloc(1, w->bytes + 1);
  w->actions = calloc(w->action_count + 1, sizeof *w->actions);
  return w->block != NULL && w->actions != NULL ? MIMO_OK : MIMO_E_OUT_OF_MEMORY;
}

/* number = create(scene) */
static void create(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  char* name;
  mimo_status status;
  size_t i;
  (void)nout;
  need(nin == 1 && mxIsChar(in[0]), "expected the name of a scene");
  for (i = 0; i < kWorlds && worlds[i].env != NULL; ++i) continue;
  need(i < kWorlds, "there are 256 worlds already; close some");
  name = mxArrayToString(in[0]);
  need(name != NULL, "expected the name of a scene");
  status = mimo_env_make(name, &worlds[i].env);
  mxFree(name);
  if (status == MIMO_OK) {
    status = prepare(&worlds[i]);
    if (status != MIMO_OK) free_world(&worlds[i]);
  }
  check(status);
  if (living++ == 0) mexLock();
  out[0] = mxCreateDoubleScalar((double)(i + 1));
}

/* close(number) */
static void close_world(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)out;
  need(nin == 1, "expected a world");
  free_world(world_of(in[0]));
  if (--living == 0) mexUnlock();
}

/* reset(number, seed or []) */
static void reset(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  world* w;
  uint64_t seed = 0;
  (void)nout;
  (void)out;
  need(nin == 2, "expected a world and a seed or []");
  w = world_of(in[0]);
  if (!mxIsEmpty(in[1])) {
    const double value = mxIsDouble(in[1]) ? mxGetScalar(in[1]) : -1;
    need(value >= 0 && value <= 9007199254740992.0 && value == floor(value), "a seed is a whole number from 0 to 2^53");
    seed = (uint64_t)value;
  }
  check(mimo_env_reset(w->env, mxIsEmpty(in[1]) ? NULL : &seed, w->block, w->bytes));
}

/* Actions may be double or single; the library has single precision. */
static size_t read_actions(world* w, const mxArray* actions) {
  const size_t count = mxGetNumberOfElements(actions);
  size_t i;
  if (count == 0) return 0;
  need((mxIsDouble(actions) || mxIsSingle(actions)) && !mxIsComplex(actions), "actions are real numbers, double or single");
  if (count != w->action_count)
    mexErrMsgIdAndTxt("mimo:INVALID_ARGUMENT", "%d actions, expected %d", (int)count, (int)w->action_count);
  for (i = 0; i < count; ++i)
    w->actions[i] = mxIsSingle(actions) ? ((const float*)mxGetData(actions))[i] : (float)mxGetPr(actions)[i];
  return count;
}

/* [reward, terminated, truncated] = step(number, actions): one row per agent */
static void step(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  world* w;
  size_t count;
  mxArray *reward, *terminated, *truncated;
  need(nin == 2, "expected a world and its actions");
  w = world_of(in[0]);
  count = read_actions(w, in[1]);
  reward = mxCreateDoubleMatrix(w->agents, 1, mxREAL);
  terminated = mxCreateLogicalMatrix(w->agents, 1);
  truncated = mxCreateLogicalMatrix(w->agents, 1);
  check(mimo_env_step(w->env, count > 0 ? w->actions : NULL, count, w->block, w->bytes, mxGetPr(reward),
                      (uint8_t*)mxGetLogicals(terminated), (uint8_t*)mxGetLogicals(truncated), w->agents));
  out[0] = reward;
  if (nout > 1) out[1] = terminated;
  if (nout > 2) out[2] = truncated;
}

static double element(const void* field, int32_t dtype, size_t i) {
  switch (dtype) {
    case MIMO_U8: return ((const uint8_t*)field)[i];
    case MIMO_I32: return ((const int32_t*)field)[i];
    case MIMO_F32: return ((const float*)field)[i];
    default: return ((const double*)field)[i];
  }
}

/* Where the i-th element of an array in C order lies in column-major order. */
static size_t column_major(const mimo_field* field, size_t i) {
  size_t place = 0, stride = 1, d;
  size_t index[4];
  for (d = field->ndim; d-- > 0;) {
    index[d] = i % field->shape[d];
    i /= field->shape[d];
  }
  for (d = 0; d < field->ndim; ++d) {
    place += index[d] * stride;
    stride *= field->shape[d];
  }
  return place;
}

/* Bytes stay bytes (pictures are for imshow); everything else becomes double or single. Vectors are columns. */
static mxArray* array_of(const mimo_field* field, const void* data, int single) {
  mwSize shape[4] = {1, 1, 1, 1};
  size_t count = 1, d, i;
  mxArray* array;
  const int bytes = field->dtype == MIMO_U8;
  for (d = 0; d < field->ndim; ++d) {
    shape[d] = field->shape[d];
    count *= field->shape[d];
  }
  array = mxCreateNumericArray(field->ndim < 2 ? 2 : field->ndim, shape,
                               bytes ? mxUINT8_CLASS : single ? mxSINGLE_CLASS : mxDOUBLE_CLASS, mxREAL);
  for (i = 0; i < count; ++i) {
    const double value = element(data, field->dtype, i);
    const size_t place = column_major(field, i);
    if (bytes) ((uint8_t*)mxGetData(array))[place] = (uint8_t)value;
    else if (single) ((float*)mxGetData(array))[place] = (float)value;
    else mxGetPr(array)[place] = value;
  }
  return array;
}

/* "touch/force" becomes touch_force: names of MATLAB's fields have no slashes. */
static void field_name(const char* path, char* name, size_t capacity) {
  size_t i;
  for (i = 0; path[i] != '\0' && i + 1 < capacity; ++i) {
    const char c = path[i];
    const int plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name[i] = plain ? c : '_';
  }
  name[i] = '\0';
}

/* struct = observation(number, 'double' or 'single') */
static void observation(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  world* w;
  size_t i;
  char precision[8] = "";
  (void)nout;
  need(nin == 2 && mxIsChar(in[1]), "expected a world and 'double' or 'single'");
  w = world_of(in[0]);
  mxGetString(in[1], precision, sizeof precision);
  need(strcmp(precision, "double") == 0 || strcmp(precision, "single") == 0, "the precision is 'double' or 'single'");
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  for (i = 0; i < w->fields; ++i) {
    char name[128];
    mimo_field field;
    memset(&field, 0, sizeof field);
    field.struct_size = sizeof field;
    check(mimo_env_observation_field(w->env, i, &field));
    field_name(field.name, name, sizeof name);
    mxSetFieldByNumber(out[0], 0, mxAddField(out[0], name),
                       array_of(&field, (const char*)w->block + field.offset, precision[0] == 's'));
  }
}

/* bytes = block(number): the observation as the library wrote it */
static void block(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  world* w;
  (void)nout;
  need(nin == 1, "expected a world");
  w = world_of(in[0]);
  out[0] = mxCreateNumericMatrix(w->bytes, 1, mxUINT8_CLASS, mxREAL);
  memcpy(mxGetData(out[0]), w->block, w->bytes);
}

/* [low, high] = bounds(number) */
static void bounds(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  world* w;
  size_t i;
  mxArray* low;
  mxArray* high;
  float* values;
  need(nin == 1, "expected a world");
  w = world_of(in[0]);
  values = mxCalloc(2 * w->action_count + 1, sizeof *values);
  check(mimo_env_action_bounds(w->env, values, values + w->action_count, w->action_count));
  low = mxCreateDoubleMatrix(w->action_count, 1, mxREAL);
  high = mxCreateDoubleMatrix(w->action_count, 1, mxREAL);
  for (i = 0; i < w->action_count; ++i) {
    mxGetPr(low)[i] = values[i];
    mxGetPr(high)[i] = values[w->action_count + i];
  }
  mxFree(values);
  out[0] = low;
  if (nout > 1) out[1] = high;
}

typedef void (*command_fn)(int nout, mxArray* out[], int nin, const mxArray* in[]);
static const struct {
  const char* name;
  command_fn run;
} commands[] = {{"create", create}, {"reset", reset}, {"step", step},     {"observation", observation},
                {"block", block},   {"bounds", bounds}, {"close", close_world}};

void mexFunction(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  char name[16] = "";
  size_t i;
  mexAtExit(free_all);
  need(nin > 0 && mxIsChar(in[0]), "expected a command");
  mxGetString(in[0], name, sizeof name);
  for (i = 0; i < sizeof commands / sizeof *commands; ++i)
    if (strcmp(name, commands[i].name) == 0) {
      commands[i].run(nout, out, nin - 1, in + 1);
      return;
    }
  mexErrMsgIdAndTxt("mimo:INVALID_ARGUMENT", "no command %s", name);
}
