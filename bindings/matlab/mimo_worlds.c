/* Making, stepping, observing. */
#include "mimo_worlds.h"

#include <math.h>
#include <string.h>

#include "mimo_scenes.h"

/* number = create(scene, name, value, ...) */
static void create(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all = mimo_new_worlds();
  (void)nout;
  all->batch = mimo_create_batch(nin, in);
  out[0] = mxCreateDoubleScalar(mimo_keep_worlds(all));
}

/* close(number): of worlds, or of a scene */
static void close_number(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)out;
  mimo_need(nin == 1, "expected a world or a scene");
  mimo_close_number(in[0]);
}

/* One seed for each world; a single one means it and those that follow it. */
static uint64_t* read_seeds(const worlds* all, const mxArray* given) {
  const size_t count = mxGetNumberOfElements(given);
  uint64_t* seeds;
  size_t i;
  if (count == 0) return NULL;
  mimo_need(mxIsDouble(given) && (count == 1 || count == all->count), "expected a seed, or one for each world");
  seeds = mxCalloc(all->count, sizeof *seeds);
  for (i = 0; i < all->count; ++i) {
    const double value = count == 1 ? mxGetPr(given)[0] + (double)i : mxGetPr(given)[i];
    mimo_need(value >= 0 && value <= 9007199254740992.0 && value == floor(value),
              "a seed is a whole number from 0 to 2^53");
    seeds[i] = (uint64_t)value;
  }
  return seeds;
}

/* A byte for each world, or NULL for all of them. */
static uint8_t* read_mask(const worlds* all, const mxArray* given) {
  uint8_t* mask;
  size_t i;
  if (mxIsEmpty(given)) return NULL;
  mimo_need(mxIsLogical(given) && mxGetNumberOfElements(given) == all->count,
            "a mask has a logical value for each world");
  mask = mxCalloc(all->count, 1);
  for (i = 0; i < all->count; ++i) mask[i] = mxGetLogicals(given)[i];
  return mask;
}

/* reset(number, seeds or [], mask or []) */
static void reset(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  uint64_t* seeds;
  uint8_t* mask;
  (void)nout;
  (void)out;
  mimo_need(nin == 3, "expected a world, seeds or [], and a mask or []");
  all = mimo_worlds_of(in[0]);
  seeds = read_seeds(all, in[1]);
  mask = read_mask(all, in[2]);
  mimo_check(mimo_batch_reset(all->batch, seeds, mask, seeds != NULL || mask != NULL ? all->count : 0, all->blocks,
                              all->count * all->bytes));
}

/* Actions may be double or single; the library has single precision. A column a world. */
static size_t read_actions(worlds* all, const mxArray* actions) {
  const size_t count = mxGetNumberOfElements(actions), expected = all->count * all->action_count;
  size_t i;
  if (count == 0) return 0;
  mimo_need((mxIsDouble(actions) || mxIsSingle(actions)) && !mxIsComplex(actions),
            "actions are real numbers, double or single");
  if (count != expected) mimo_refuse("%d actions, expected %d", (int)count, (int)expected);
  for (i = 0; i < count; ++i)
    all->actions[i] = mxIsSingle(actions) ? ((const float*)mxGetData(actions))[i] : (float)mxGetPr(actions)[i];
  return count;
}

/* [reward, terminated, truncated] = step(number, actions): agents x worlds */
static void step(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t count;
  mxArray *reward, *terminated, *truncated;
  mimo_batch_results results;
  mimo_need(nin == 2, "expected a world and its actions");
  all = mimo_worlds_of(in[0]);
  count = read_actions(all, in[1]);
  reward = mxCreateDoubleMatrix(all->agents, all->count, mxREAL);
  terminated = mxCreateLogicalMatrix(all->agents, all->count);
  truncated = mxCreateLogicalMatrix(all->agents, all->count);
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = mxGetPr(reward);
  results.terminated = (uint8_t*)mxGetLogicals(terminated);
  results.truncated = (uint8_t*)mxGetLogicals(truncated);
  results.agents = all->count * all->agents;
  mimo_check(mimo_batch_step(all->batch, count > 0 ? all->actions : NULL, count, all->blocks, all->count * all->bytes,
                             all->agents > 0 ? &results : NULL));
  out[0] = reward;
  if (nout > 1) out[1] = terminated;
  if (nout > 2) out[2] = truncated;
}

/* send(number, actions): a step that goes on while MATLAB does something else */
static void send(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t count;
  mimo_batch_results results;
  (void)nout;
  (void)out;
  mimo_need(nin == 2, "expected a world and its actions");
  all = mimo_worlds_of(in[0]);
  count = read_actions(all, in[1]);
  memset(&results, 0, sizeof results);
  results.struct_size = sizeof results;
  results.reward = all->reward;
  results.terminated = all->terminated;
  results.truncated = all->truncated;
  results.agents = all->count * all->agents;
  mimo_check(mimo_batch_send(all->batch, count > 0 ? all->actions : NULL, count, all->blocks, all->count * all->bytes,
                             all->agents > 0 ? &results : NULL));
  all->sent = 1;
}

static mxArray* flags(const worlds* all, const uint8_t* from) {
  mxArray* array = mxCreateLogicalMatrix(all->agents, all->count);
  memcpy(mxGetLogicals(array), from, all->count * all->agents);
  return array;
}

/* [reward, terminated, truncated] = receive(number): as step gives them */
static void receive(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  mimo_need(nin == 1, "expected a world");
  all = mimo_any_worlds_of(in[0]);
  mimo_need(all->sent, "no step was sent; mimo_send does");
  all->sent = 0;
  mimo_check(mimo_batch_receive(all->batch));
  out[0] = mxCreateDoubleMatrix(all->agents, all->count, mxREAL);
  memcpy(mxGetPr(out[0]), all->reward, all->count * all->agents * sizeof *all->reward);
  if (nout > 1) out[1] = flags(all, all->terminated);
  if (nout > 2) out[2] = flags(all, all->truncated);
}

/* observe(number): the senses of the current state go to its block */
static void observe(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  (void)nout;
  (void)out;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  mimo_check(mimo_batch_observe(all->batch, NULL, 0, all->blocks, all->count * all->bytes));
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

/* An array for a field of all worlds, which are its last dimension. Bytes stay bytes (pictures are for imshow);
   everything else becomes double or single. Vectors are columns. */
static mxArray* new_array(const worlds* all, const mimo_field* field, int single) {
  mwSize shape[5] = {1, 1, 1, 1, 1}, dimensions = field->ndim;
  size_t d;
  for (d = 0; d < field->ndim; ++d) shape[d] = field->shape[d];
  if (all->count > 1) shape[dimensions++] = all->count;
  return mxCreateNumericArray(dimensions < 2 ? 2 : dimensions, shape,
                              field->dtype == MIMO_U8 ? mxUINT8_CLASS
                              : single                ? mxSINGLE_CLASS
                                                      : mxDOUBLE_CLASS,
                              mxREAL);
}

static mxArray* array_of(const worlds* all, const mimo_field* field, int single) {
  mxArray* array = new_array(all, field, single);
  const size_t count = mxGetNumberOfElements(array) / all->count;
  size_t world, i;
  for (world = 0; world < all->count; ++world) {
    const char* data = all->blocks + world * all->bytes + field->offset;
    for (i = 0; i < count; ++i) {
      const double value = element(data, field->dtype, i);
      const size_t place = world * count + column_major(field, i);
      if (field->dtype == MIMO_U8)
        ((uint8_t*)mxGetData(array))[place] = (uint8_t)value;
      else if (single)
        ((float*)mxGetData(array))[place] = (float)value;
      else
        mxGetPr(array)[place] = value;
    }
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
  worlds* all;
  size_t i;
  char precision[8] = "";
  (void)nout;
  mimo_need(nin == 2 && mxIsChar(in[1]), "expected a world and 'double' or 'single'");
  all = mimo_worlds_of(in[0]);
  mxGetString(in[1], precision, sizeof precision);
  mimo_need(strcmp(precision, "double") == 0 || strcmp(precision, "single") == 0,
            "the precision is 'double' or 'single'");
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  for (i = 0; i < all->fields; ++i) {
    char name[128];
    mimo_field field;
    memset(&field, 0, sizeof field);
    field.struct_size = sizeof field;
    mimo_check(mimo_env_observation_field(all->first, i, &field));
    field_name(field.name, name, sizeof name);
    mxSetFieldByNumber(out[0], 0, mxAddField(out[0], name), array_of(all, &field, precision[0] == 's'));
  }
}

/* bytes = block(number): the observation as the library wrote it, a column a world */
static void block(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  (void)nout;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  out[0] = mxCreateNumericMatrix(all->bytes, all->count, mxUINT8_CLASS, mxREAL);
  memcpy(mxGetData(out[0]), all->blocks, all->count * all->bytes);
}

/* [low, high] = bounds(number) */
static void bounds(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t i;
  mxArray* low;
  mxArray* high;
  float* values;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  values = mxCalloc(2 * all->action_count + 1, sizeof *values);
  mimo_check(mimo_env_action_bounds(all->first, values, values + all->action_count, all->action_count));
  low = mxCreateDoubleMatrix(all->action_count, 1, mxREAL);
  high = mxCreateDoubleMatrix(all->action_count, 1, mxREAL);
  for (i = 0; i < all->action_count; ++i) {
    mxGetPr(low)[i] = values[i];
    mxGetPr(high)[i] = values[all->action_count + i];
  }
  mxFree(values);
  out[0] = low;
  if (nout > 1) out[1] = high;
}

/* physics(number, steps): bare physics, in all worlds */
static void physics(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  double count;
  size_t i;
  (void)nout;
  (void)out;
  mimo_need(nin == 2, "expected a world and a number of physics steps");
  all = mimo_worlds_of(in[0]);
  count = mimo_number(in[1], "steps");
  if (!(count >= 0 && count <= 1e6) || count != floor(count))
    mimo_refuse("steps is %g, expected a whole number from 0 to 1000000", count);
  for (i = 0; i < all->count; ++i) {
    mimo_env* env = NULL;
    mimo_check(mimo_batch_world(all->batch, i, &env));
    mimo_check(mimo_env_physics_step(env, (size_t)count));
  }
}

/* values = random(number, count): out of each world's own stream, count x worlds */
static void random_numbers(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  double count;
  size_t i;
  (void)nout;
  mimo_need(nin == 2, "expected a world and how many numbers");
  all = mimo_worlds_of(in[0]);
  count = mimo_number(in[1], "count");
  if (!(count >= 0 && count <= 1e8) || count != floor(count))
    mimo_refuse("count is %g, expected a whole number from 0 to 100000000", count);
  out[0] = mxCreateDoubleMatrix((size_t)count, all->count, mxREAL);
  for (i = 0; i < all->count; ++i) {
    mimo_env* env = NULL;
    mimo_check(mimo_batch_world(all->batch, i, &env));
    mimo_check(mimo_env_random(env, mxGetPr(out[0]) + i * (size_t)count, (size_t)count));
  }
}

const mimo_command mimo_world_commands[] = {
    {"create", create}, {"close", close_number}, {"reset", reset},     {"step", step},
    {"send", send},     {"receive", receive},    {"observe", observe}, {"observation", observation},
    {"block", block},   {"bounds", bounds},      {"physics", physics}, {"random", random_numbers},
    {NULL, NULL}};
