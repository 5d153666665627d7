/* Commands for making, stepping and observing worlds. */
#include "mimo_worlds.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "mimo_layout.h"
#include "mimo_options.h"
#include "mimo_scenes.h"

/* Fields "a_b" and "a/b" would be the same member of an observation. */
static void refuse_ambiguous(worlds* all) {
  const char* field = mimo_ambiguous_field(all);
  char name[128];
  if (field == NULL) return;
  snprintf(name, sizeof name, "%s", field);
  mimo_close_worlds(all);
  mimo_refuse("field \"%s\" has the same name in MATLAB as another field", name);
}

/* number = create(scene, name, value, ...) */
static void create(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all = mimo_new_worlds();
  mimo_batch_config config;
  (void)nout;
  all->batch = mimo_create_batch(nin, in, mimo_number_of(all), &config, &all->usual);
  mimo_keep_worlds(all, config.autoreset == MIMO_AUTORESET_SAME_STEP);
  refuse_ambiguous(all);
  out[0] = mxCreateDoubleScalar(mimo_number_of(all));
}

/* close(number): of worlds, or of a scene */
static void close_number(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)out;
  mimo_need(nin == 1, "expected a world or a scene");
  mimo_close_number(in[0]);
}

/* Doubles are exact up to 2^53; uint64 has all seeds. */
static uint64_t seed_of(double value) {
  mimo_need(value >= 0 && value <= 9007199254740992.0 && value == floor(value),
            "seed: expected a whole number from 0 to 2^53, or a uint64");
  return (uint64_t)value;
}

/* One seed for each world; a single seed stands for itself and the numbers after it. */
static uint64_t* read_seeds(const worlds* all, const mxArray* given) {
  const size_t count = mxGetNumberOfElements(given);
  const uint64_t* wide = mxIsUint64(given) && !mxIsComplex(given) ? mxGetData(given) : NULL;
  const double* numbers;
  uint64_t* seeds;
  size_t i;
  if (count == 0) return NULL;
  mimo_need(!mxIsSingle(given), "seed: expected a double or a uint64; single is exact only up to 2^24");
  numbers = wide == NULL ? mimo_numbers(given, "seeds") : NULL;
  mimo_need(count == 1 || (count == all->count && mimo_is_vector(given)),
            "seed: expected one number, or one for each world");
  seeds = mxCalloc(all->count, sizeof *seeds);
  for (i = 0; i < all->count; ++i) {
    const size_t at = count == 1 ? 0 : i;
    seeds[i] = (wide != NULL ? wide[at] : seed_of(numbers[at])) + (count == 1 ? i : 0);
  }
  return seeds;
}

/* A byte for each world, or NULL for all worlds. */
static uint8_t* read_mask(const worlds* all, const mxArray* given) {
  uint8_t* mask;
  size_t i;
  if (mxIsEmpty(given)) return NULL;
  mimo_need(mxIsLogical(given) && mxGetNumberOfElements(given) == all->count && mimo_is_vector(given),
            "mask: expected a logical value for each world");
  mask = mxCalloc(all->count, 1);
  for (i = 0; i < all->count; ++i) mask[i] = mxGetLogicals(mimo_full(given))[i];
  return mask;
}

/* reset(number, seeds or [], mask or [], ages or []) */
static void reset(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_batch_reset_config config = {0};
  worlds* all;
  size_t ages = 0;
  (void)nout;
  (void)out;
  mimo_need(nin == 4, "expected a world, seeds or [], a mask or [], and ages or []");
  all = mimo_worlds_of(in[0]);
  config.struct_size = sizeof config;
  config.seeds = read_seeds(all, in[1]);
  config.mask = read_mask(all, in[2]);
  config.growth = mimo_ages(in[3], &all->usual, &ages);
  if (config.growth != NULL && ages != all->count)
    mimo_refuse("%d ages, expected %d, one for each world", (int)ages, (int)all->count);
  config.worlds = config.seeds != NULL || config.mask != NULL || config.growth != NULL ? all->count : 0;
  mimo_check(mimo_batch_reset(all->batch, &config, all->blocks, all->count * all->sizes.block_bytes));
}

/* Converts actions to the library's single precision: a column for each world. */
static size_t read_actions(worlds* all, const mxArray* actions) {
  const size_t count = mxGetNumberOfElements(actions);
  const double* numbers;
  size_t i;
  if (count == 0) return 0;
  numbers =
      mimo_matrix(actions, "actions", all->sizes.actions, all->count, "a row for each action, a column for each world");
  for (i = 0; i < count; ++i) all->actions[i] = (float)numbers[i];
  return count;
}

static mxArray* flags(const uint8_t* from, size_t rows, size_t columns) {
  mxArray* array = mxCreateLogicalMatrix(rows, columns);
  memcpy(mxGetLogicals(array), from, rows * columns);
  return array;
}

static mxArray* outcomes(const worlds* all) {
  mxArray* array = mxCreateDoubleMatrix(all->sizes.agents, all->count, mxREAL);
  size_t i;
  for (i = 0; i < all->results.agent_count; ++i) mxGetPr(array)[i] = all->results.outcome[i];
  return array;
}

static mxArray* further_results(const worlds* all) {
  mxArray* more = mxCreateStructMatrix(1, 1, 0, NULL);
  mimo_add(more, "outcome", outcomes(all));
  mimo_add_numbers(more, "terms", all->results.terms, all->sizes.terms, all->count);
  mimo_add(more, "was_reset", flags(all->results.was_reset, 1, all->count));
  mimo_add(more, "final_written", flags(all->results.final_written, 1, all->count));
  return more;
}

/* [reward, terminated, truncated, more]: agents x worlds, and a struct of further results */
static void give_results(const worlds* all, int nout, mxArray* out[]) {
  out[0] = mxCreateDoubleMatrix(all->sizes.agents, all->count, mxREAL);
  memcpy(mxGetPr(out[0]), all->results.reward, all->results.agent_count * sizeof *all->results.reward);
  if (nout > 1) out[1] = flags(all->results.terminated, all->sizes.agents, all->count);
  if (nout > 2) out[2] = flags(all->results.truncated, all->sizes.agents, all->count);
  if (nout > 3) out[3] = further_results(all);
}

/* Begins a step: mimo_batch_step, or mimo_batch_send. */
typedef mimo_status (*stepper)(mimo_batch*, const float*, size_t, void*, size_t, const mimo_batch_results*);

static worlds* begin_step(stepper begin, int nin, const mxArray* in[]) {
  worlds* all;
  size_t count;
  mimo_need(nin == 2, "expected a world and its actions");
  all = mimo_worlds_of(in[0]);
  count = read_actions(all, in[1]);
  mimo_check(begin(all->batch, count > 0 ? all->actions : NULL, count, all->blocks, all->count * all->sizes.block_bytes,
                   &all->results));
  return all;
}

/* [reward, terminated, truncated, more] = step(number, actions) */
static void step(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  give_results(begin_step(mimo_batch_step, nin, in), nout, out);
}

/* send(number, actions): a step that runs while MATLAB does something else */
static void send(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)out;
  begin_step(mimo_batch_send, nin, in)->sent = 1;
}

/* [reward, terminated, truncated, more] = receive(number): the results that step returns */
static void receive(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  mimo_need(nin == 1, "expected a world");
  all = mimo_any_worlds_of(in[0]);
  mimo_need_first(all->sent, "no step was sent; mimo_send sends one");
  all->sent = 0;
  mimo_check(mimo_batch_receive(all->batch));
  give_results(all, nout, out);
}

/* observe(number): writes the observation of the current state to its block */
static void observe(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  (void)nout;
  (void)out;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  mimo_check(mimo_batch_observe(all->batch, NULL, 0, all->blocks, all->count * all->sizes.block_bytes));
}

/* forces = follow(number, positions): a step of a known movement; a column for each physics step, in one world */
static void follow(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t degrees = 0, joints = 0;
  uint32_t steps = 0;
  mimo_env* env = NULL;
  mimo_movement movement = {0};
  (void)nout;
  mimo_need(nin == 2, "expected a world and positions");
  all = mimo_worlds_of(in[0]);
  if (all->count != 1) mimo_refuse("a known movement takes a single world, not %.0f", (double)all->count);
  mimo_check(mimo_batch_world(all->batch, 0, &env));
  mimo_check(mimo_env_width(env, MIMO_JOINT_VELOCITY, NULL, 0, &degrees));
  mimo_check(mimo_env_width(env, MIMO_JOINT_POSITION, NULL, 0, &joints));
  mimo_check(mimo_env_frame_skip(env, &steps));
  out[0] = mxCreateDoubleMatrix(degrees, steps, mxREAL);
  movement.struct_size = sizeof movement;
  movement.positions = mimo_matrix(in[1], "positions", joints, steps,
                                   "a row for each number of a joint, a column for each physics step");
  movement.position_count = joints * steps;
  movement.forces = mxGetPr(out[0]);
  movement.force_count = mxGetNumberOfElements(out[0]);
  mimo_check(mimo_env_follow(env, &movement, all->blocks, all->sizes.block_bytes));
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
  count = mimo_whole(in[1], "steps", 0, 1e6);
  for (i = 0; i < all->count; ++i) {
    mimo_env* env = NULL;
    mimo_check(mimo_batch_world(all->batch, i, &env));
    mimo_check(mimo_env_physics_step(env, (size_t)count));
  }
}

/* play(number, body, samples, rate): a column for all worlds, or a column for each */
static void play(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const char* body;
  const double* numbers;
  worlds* all;
  size_t count, columns, i, world;
  (void)nout;
  (void)out;
  mimo_need(nin == 4, "expected a world, a body, samples and a rate");
  all = mimo_worlds_of(in[0]);
  body = mimo_text(in[1], "body");
  numbers = mimo_numbers(in[2], "samples");
  count = mxGetM(in[2]);
  columns = mxGetN(in[2]);
  if (count == 1 && all->count == 1) count = columns, columns = 1; /* a row */
  if (mxIsEmpty(in[2])) count = 0, columns = 1;
  if (columns != 1 && columns != all->count)
    mimo_refuse("samples has %.0f columns, expected one, or one for each of %.0f worlds", (double)columns,
                (double)all->count);
  for (world = 0; world < all->count; ++world) {
    const double* from = numbers + (columns == 1 ? 0 : world * count);
    float* samples = (float*)mxMalloc((count + 1) * sizeof(float));
    mimo_env* env = NULL;
    for (i = 0; i < count; ++i) samples[i] = (float)from[i];
    mimo_check(mimo_batch_world(all->batch, world, &env));
    mimo_check(mimo_env_play(env, body, samples, count, mimo_number(in[3], "rate")));
    mxFree(samples);
  }
}

/* values = random(number, count): from each world's own stream, count x worlds */
static void random_numbers(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  double count;
  size_t i;
  (void)nout;
  mimo_need(nin == 2, "expected a world and a number of values");
  all = mimo_worlds_of(in[0]);
  count = mimo_whole(in[1], "count", 0, 1e8);
  out[0] = mxCreateDoubleMatrix((size_t)count, all->count, mxREAL);
  for (i = 0; i < all->count; ++i) {
    mimo_env* env = NULL;
    mimo_check(mimo_batch_world(all->batch, i, &env));
    mimo_check(mimo_env_random(env, mxGetPr(out[0]) + i * (size_t)count, (size_t)count));
  }
}

/* actions = spontaneous(number, which): actions x worlds */
static void spontaneous(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  double which;
  (void)nout;
  mimo_need(nin == 2, "expected a world and kinds of movements");
  all = mimo_worlds_of(in[0]);
  which = mimo_whole(in[1], "which", 0, 4294967295.0);
  out[0] = mxCreateNumericMatrix(all->sizes.actions, all->count, mxSINGLE_CLASS, mxREAL);
  mimo_check(
      mimo_batch_spontaneous(all->batch, (uint32_t)which, (float*)mxGetData(out[0]), all->sizes.actions * all->count));
}

const mimo_command mimo_world_commands[] = {
    {"create", create},   {"close", close_number},    {"reset", reset},     {"step", step},
    {"send", send},       {"receive", receive},       {"observe", observe}, {"follow", follow},
    {"physics", physics}, {"random", random_numbers}, {"play", play},       {"spontaneous", spontaneous},
    {NULL, NULL}};
