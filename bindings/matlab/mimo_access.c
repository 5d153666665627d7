/* Commands for names, states, faces, locks and gravity. */
#include "mimo_access.h"

#include <string.h>

#include "mimo_words.h"

/* A selection to read or write: a quantity of elements by name, one or a cell array of them; or of all, with ids NULL.
 */
typedef struct selection {
  worlds* all;
  int32_t quantity, *ids;
  size_t count, width; /* values of one world */
  size_t each;         /* of contacts, which have no names: the number of values of each; 0: elements have names */
} selection;

static int32_t find(const worlds* all, int32_t kind, const char* name) {
  int32_t id = 0;
  mimo_check(mimo_env_find(all->first, kind, name, &id));
  return id;
}

/* Without names: all elements. `world` knows their width. */
static selection select_by_name(worlds* all, const mimo_env* world, const mxArray* name, const mxArray* names) {
  const quantity quantity = mimo_quantity_of(name);
  selection chosen = {NULL, 0, NULL, 0, 0, 0};
  const char** found = mimo_texts(names, &chosen.count, "name");
  size_t i;
  chosen.all = all;
  chosen.quantity = quantity.number;
  chosen.each = quantity.each;
  if (found != NULL) chosen.ids = mxCalloc(chosen.count + 1, sizeof *chosen.ids);
  for (i = 0; i < chosen.count; ++i) chosen.ids[i] = find(all, quantity.kind, found[i]);
  mimo_check(mimo_env_width(world, chosen.quantity, chosen.ids, chosen.count, &chosen.width));
  return chosen;
}

/* A row for each contact. */
static mxArray* rows_of(const selection* chosen, const double* values) {
  const size_t rows = chosen->width / chosen->each;
  mxArray* array = mxCreateDoubleMatrix(rows, chosen->each, mxREAL);
  size_t i;
  for (i = 0; i < chosen->width; ++i) mxGetPr(array)[i % chosen->each * rows + i / chosen->each] = values[i];
  return array;
}

/* values = get(number, quantity, names or [], index): values x worlds, or the values of one world; contacts x values */
static void get(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  const mimo_env* world;
  selection chosen;
  mxArray* values;
  (void)nout;
  mimo_need(nin >= 2 && nin <= 4, "expected a world, a quantity, names or [], and the index of a world");
  all = mimo_worlds_of(in[0]);
  world = nin == 4 ? mimo_world_at(all, nin, in, 3) : all->first;
  chosen = select_by_name(all, world, in[1], nin > 2 ? in[2] : NULL);
  if (chosen.each > 0 && nin < 4 && all->count > 1)
    mimo_refuse("index: each of %.0f worlds has its own contacts; name one", (double)all->count);
  values = mxCreateDoubleMatrix(chosen.width, nin == 4 ? 1 : all->count, mxREAL);
  if (nin == 4 || all->count == 1) {
    mimo_check(mimo_env_get(world, chosen.quantity, chosen.ids, chosen.count, mxGetPr(values), chosen.width));
  } else {
    mimo_check(mimo_batch_get(all->batch, chosen.quantity, chosen.ids, chosen.count, NULL, 0, mxGetPr(values),
                              mxGetNumberOfElements(values)));
  }
  out[0] = chosen.each > 0 ? rows_of(&chosen, mxGetPr(values)) : values;
}

/* Values for each world, or the values of one for all. */
static void set_selected(const selection* chosen, const double* values, size_t given) {
  const size_t worlds = chosen->all->count;
  size_t world;
  if (worlds > 1 && given == chosen->width) {
    double* same = mxCalloc(worlds * given + 1, sizeof *same);
    for (world = 0; world < worlds; ++world) memcpy(same + world * given, values, given * sizeof *values);
    values = same;
    given *= worlds;
  }
  mimo_check(mimo_batch_set(chosen->all->batch, chosen->quantity, chosen->ids, chosen->count, NULL, 0, values, given));
}

/* set(number, quantity, names or [], values): values x worlds, or the same for all worlds */
static void set(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  selection chosen;
  const double* values;
  size_t columns;
  (void)nout;
  (void)out;
  mimo_need(nin == 4, "expected a world, a quantity, names or [], and values");
  all = mimo_worlds_of(in[0]);
  chosen = select_by_name(all, all->first, in[1], in[2]);
  columns = mxGetNumberOfElements(in[3]) == chosen.width ? 1 : all->count;
  values = mimo_matrix(in[3], "values", chosen.width, columns,
                       "as mimo_get gives them, a column for each world, or one for all");
  set_selected(&chosen, values, chosen.width * columns);
}

/* The same value for one element in all worlds. */
static void set_one(worlds* all, int32_t quantity, int32_t id, const double* values, size_t width) {
  selection chosen = {NULL, 0, NULL, 1, 0, 0};
  chosen.all = all;
  chosen.quantity = quantity;
  chosen.ids = &id;
  chosen.width = width;
  set_selected(&chosen, values, width);
}

/* names = names(number, kind): a cell array; "" if the model gives none */
static void names(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t count = 0, i;
  int32_t kind;
  (void)nout;
  mimo_need(nin == 2, "expected a world and a kind");
  all = mimo_worlds_of(in[0]);
  kind = (int32_t)mimo_value_of(in[1], "kind", &mimo_kind_words);
  mimo_check(mimo_env_count(all->first, kind, &count));
  out[0] = mxCreateCellMatrix(count, 1);
  for (i = 0; i < count; ++i) mxSetCell(out[0], i, mimo_name_of(all, kind, (int32_t)i));
}

/* body = body_of(number, kind, name) */
static void body_of(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  int32_t kind, body = 0;
  (void)nout;
  mimo_need(nin == 3, "expected a world, a kind and a name");
  all = mimo_worlds_of(in[0]);
  kind = (int32_t)mimo_value_of(in[1], "kind", &mimo_kind_words);
  mimo_check(mimo_env_body_of(all->first, kind, find(all, kind, mimo_text(in[2], "name")), &body));
  out[0] = mimo_name_of(all, MIMO_BODY, body);
}

/* update(number): poses follow the joints, in all worlds */
static void update(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t i;
  (void)nout;
  (void)out;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  for (i = 0; i < all->count; ++i) {
    mimo_env* env = NULL;
    mimo_check(mimo_batch_world(all->batch, i, &env));
    mimo_check(mimo_env_update(env));
  }
}

/* seconds = time(number): a column for each world */
static void seconds(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t i;
  (void)nout;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  out[0] = mxCreateDoubleMatrix(1, all->count, mxREAL);
  for (i = 0; i < all->count; ++i) {
    mimo_env* env = NULL;
    mimo_check(mimo_batch_world(all->batch, i, &env));
    mimo_check(mimo_env_time(env, mxGetPr(out[0]) + i));
  }
}

/* states = save(number): uint8, a column for each world */
static void save(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t bytes = 0;
  (void)nout;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  mimo_check(mimo_batch_state_size(all->batch, &bytes));
  out[0] = mxCreateNumericMatrix(bytes, all->count, mxUINT8_CLASS, mxREAL);
  mimo_check(mimo_batch_state_save(all->batch, NULL, 0, mxGetData(out[0]), bytes * all->count));
}

/* struct = load(number, states): a column for each world, or one for all; returns names of fresh and ignored memories
 */
static void load(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  mimo_load_report report = {0};
  (void)nout;
  mimo_need(nin == 2 && mxIsUint8(in[1]) && !mxIsComplex(in[1]), "expected a world and bytes of mimo_save");
  all = mimo_worlds_of(in[0]);
  if (!mimo_is_vector(in[1]) && mxGetN(in[1]) != all->count)
    mimo_refuse("states has %.0f columns, expected one, or one for each of %.0f worlds", (double)mxGetN(in[1]),
                (double)all->count);
  report.struct_size = sizeof report;
  mimo_check(mimo_batch_state_load(all->batch, NULL, 0, mxGetData(in[1]), mxGetNumberOfElements(in[1]), &report));
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  mimo_add_text(out[0], "fresh", report.fresh_names);
  mimo_add_text(out[0], "ignored", report.ignored_names);
}

/* name = face(number), or face(number, name): of the first agent, in all worlds */
static void face(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const int32_t agent = 0;
  const char* name = "";
  double shown = -1;
  worlds* all;
  (void)nout;
  mimo_need(nin == 1 || nin == 2, "expected a world, and the name of a face");
  all = mimo_worlds_of(in[0]);
  if (nin == 2) {
    shown = find(all, MIMO_FACE, mimo_text(in[1], "name"));
    set_one(all, MIMO_AGENT_FACE, 0, &shown, 1);
  }
  mimo_check(mimo_env_get(all->first, MIMO_AGENT_FACE, &agent, 1, &shown, 1));
  if (shown >= 0) mimo_check(mimo_env_name(all->first, MIMO_FACE, (int32_t)shown, &name));
  out[0] = mxCreateString(name);
}

/* lock(number, joint, angle or []): in all worlds; [] releases it */
static void lock(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  int32_t joint;
  double values[2] = {0, 0};
  (void)nout;
  (void)out;
  mimo_need(nin == 3, "expected a world, a joint, and an angle or []");
  all = mimo_worlds_of(in[0]);
  joint = find(all, MIMO_JOINT, mimo_text(in[1], "joint"));
  if (mxIsEmpty(in[2])) {
    mimo_check(mimo_env_get(all->first, MIMO_JOINT_LOCK, &joint, 1, values, 2));
    values[0] = 0;
  } else {
    values[0] = 1;
    values[1] = mimo_number(in[2], "angle");
  }
  set_one(all, MIMO_JOINT_LOCK, joint, values, 2);
}

/* angle = locked(number, joint): of the first world; [] if it is not locked */
static void locked(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  int32_t joint;
  double lock[2];
  (void)nout;
  mimo_need(nin == 2, "expected a world and a joint");
  all = mimo_worlds_of(in[0]);
  joint = find(all, MIMO_JOINT, mimo_text(in[1], "joint"));
  mimo_check(mimo_env_get(all->first, MIMO_JOINT_LOCK, &joint, 1, lock, 2));
  out[0] = lock[0] != 0 ? mxCreateDoubleScalar(lock[1]) : mxCreateDoubleMatrix(0, 0, mxREAL);
}

/* gravity = gravity(number), or gravity(number, xyz): in all worlds */
static void gravity(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  (void)nout;
  mimo_need(nin == 1 || nin == 2, "expected a world, and three numbers");
  all = mimo_worlds_of(in[0]);
  if (nin == 2) set_one(all, MIMO_WORLD_GRAVITY, 0, mimo_vector(in[1], "xyz", 3), 3);
  out[0] = mxCreateDoubleMatrix(3, 1, mxREAL);
  mimo_check(mimo_env_get(all->first, MIMO_WORLD_GRAVITY, NULL, 0, mxGetPr(out[0]), 3));
}

const mimo_command mimo_access_commands[] = {
    {"get", get},       {"set", set},         {"names", names}, {"body_of", body_of}, {"update", update},
    {"time", seconds},  {"save", save},       {"load", load},   {"face", face},       {"lock", lock},
    {"locked", locked}, {"gravity", gravity}, {NULL, NULL}};
