/* Commands for descriptions of observations, actions and rewards, and for the observations themselves. */
#include "mimo_layout.h"

#include <string.h>

#include "mimo_arrays.h"
#include "mimo_words.h"

enum { kName = 128 };

static mimo_field field_at(const worlds* all, size_t index) {
  mimo_field field = {0};
  field.struct_size = sizeof field;
  mimo_check(mimo_layout_field(all->layout, index, &field));
  return field;
}

static size_t index_of(const worlds* all, const mxArray* name) {
  size_t index = 0;
  mimo_check(mimo_layout_find(all->layout, mimo_text(name, "field"), &index));
  return index;
}

/* Independent of the locale. */
static int is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static int is_digit(char c) { return c >= '0' && c <= '9'; }

/* "touch/force" becomes touch_force: members in MATLAB start with a letter, and have letters, digits and _. */
static void member_name(const char* path, char name[kName]) {
  size_t used = 0;
  if (!is_letter(path[0])) name[used++] = 'x';
  for (; *path != '\0' && used + 1 < kName; ++path) name[used++] = is_letter(*path) || is_digit(*path) ? *path : '_';
  name[used] = '\0';
}

const char* mimo_ambiguous_field(const worlds* all) {
  mxArray* members = mxCreateStructMatrix(1, 1, 0, NULL);
  size_t i;
  for (i = 0; i < all->sizes.fields; ++i) {
    const mimo_field field = field_at(all, i);
    char name[kName];
    member_name(field.name, name);
    if (mxGetFieldNumber(members, name) >= 0) return field.name;
    mxAddField(members, name);
  }
  return NULL;
}

static const char* type_of(const mimo_field* field) {
  switch (field->dtype) {
    case MIMO_U8: return "uint8";
    case MIMO_I32: return "int32";
    case MIMO_F32: return "single";
    default: return "double";
  }
}

static mxArray* fields_of(const worlds* all) {
  mxArray* fields = mimo_structs(all->sizes.fields, mimo_field_members);
  size_t i;
  mxAddField(fields, "member");
  mxAddField(fields, "type");
  mxAddField(fields, "size");
  mxAddField(fields, "time");
  for (i = 0; i < all->sizes.fields; ++i) {
    const mimo_field field = field_at(all, i);
    mxArray* time = mxCreateDoubleMatrix(1, 2, mxREAL);
    char member[kName];
    member_name(field.name, member);
    mxGetPr(time)[0] = field.start;
    mxGetPr(time)[1] = field.end;
    mimo_fill(fields, i, &field, mimo_field_members);
    mxSetField(fields, i, "member", mxCreateString(member));
    mxSetField(fields, i, "type", mxCreateString(type_of(&field)));
    mxSetField(fields, i, "size", mimo_size_of(&field));
    mxSetField(fields, i, "time", time);
  }
  return fields;
}

/* Agents are counted from 1. */
static void set_agent(mxArray* to, size_t i, size_t agent) {
  mxSetField(to, i, "agent", mxCreateDoubleScalar((double)agent + 1));
}

static mxArray* actions_of(const worlds* all) {
  mxArray* actions = mimo_structs(all->sizes.actions, mimo_action_members);
  size_t i;
  for (i = 0; i < all->sizes.actions; ++i) {
    mimo_action action = {0};
    action.struct_size = sizeof action;
    mimo_check(mimo_layout_action(all->layout, i, &action));
    mimo_fill(actions, i, &action, mimo_action_members);
    set_agent(actions, i, action.agent);
  }
  return actions;
}

static mxArray* terms_of(const worlds* all) {
  mxArray* terms = mimo_structs(all->sizes.terms, mimo_term_members);
  size_t i;
  for (i = 0; i < all->sizes.terms; ++i) {
    mimo_term term = {0};
    term.struct_size = sizeof term;
    mimo_check(mimo_layout_term(all->layout, i, &term));
    mimo_fill(terms, i, &term, mimo_term_members);
    set_agent(terms, i, term.agent);
  }
  return terms;
}

/* struct = layout(number): of one world */
static void layout(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const worlds* all;
  (void)nout;
  mimo_need(nin == 1, "expected a world");
  all = mimo_any_worlds_of(in[0]);
  out[0] = mimo_struct(&all->sizes, mimo_layout_members);
  mimo_add(out[0], "fields", fields_of(all));
  mimo_add(out[0], "actions", actions_of(all));
  mimo_add(out[0], "terms", terms_of(all));
}

/* The field of the arguments (number, field). */
static mimo_field field_asked(int nin, const mxArray* in[], const worlds** all, size_t* index) {
  mimo_need(nin == 2, "expected a world and a field");
  *all = mimo_any_worlds_of(in[0]);
  *index = index_of(*all, in[1]);
  return field_at(*all, *index);
}

/* labels = labels(number, field): a cell array of the field's size */
static void labels(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const worlds* all;
  size_t index, i;
  const mimo_field field = field_asked(nin, in, &all, &index);
  (void)nout;
  out[0] = mimo_cells_of(&field);
  for (i = 0; i < mimo_elements(&field); ++i) {
    const char* label = NULL;
    mimo_check(mimo_layout_label(all->layout, index, i, &label));
    mxSetCell(out[0], mimo_place_of(&field, i), mxCreateString(label));
  }
}

/* seconds = delays(number, field): an array of the field's size */
static void delays(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const worlds* all;
  size_t index, i;
  const mimo_field field = field_asked(nin, in, &all, &index);
  const size_t count = mimo_elements(&field);
  double* seconds = mxCalloc(count, sizeof *seconds);
  (void)nout;
  out[0] = mimo_zeros_of(&field);
  mimo_check(mimo_layout_delays(all->layout, index, seconds, count));
  for (i = 0; i < count; ++i) mxGetPr(out[0])[mimo_place_of(&field, i)] = seconds[i];
}

/* vectors = directions(number, field): height x width x 3 */
static void directions(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const worlds* all;
  size_t index, pixel, axis;
  const mimo_field field = field_asked(nin, in, &all, &index);
  const size_t height = field.ndim < 2 ? 0 : field.shape[0], width = field.ndim < 2 ? 0 : field.shape[1];
  const mwSize size[] = {height, width, 3};
  float* rows = mxCalloc(height * width * 3 + 1, sizeof *rows);
  (void)nout;
  mimo_check(mimo_layout_directions(all->layout, index, rows, height * width * 3));
  out[0] = mxCreateNumericArray(3, size, mxDOUBLE_CLASS, mxREAL);
  for (pixel = 0; pixel < height * width; ++pixel)
    for (axis = 0; axis < 3; ++axis)
      mxGetPr(out[0])[axis * height * width + pixel % width * height + pixel / width] = rows[pixel * 3 + axis];
}

/* values = receptors(number, field, quantity): a row for each receptor */
static void receptors(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const worlds* all;
  int32_t quantity;
  size_t index, count, width = 0, i;
  double* values;
  (void)nout;
  mimo_need(nin == 3, "expected a world, a field and a quantity");
  all = mimo_any_worlds_of(in[0]);
  index = index_of(all, in[1]);
  quantity = (int32_t)mimo_value_of(in[2], "quantity", &mimo_receptor_words);
  mimo_check(mimo_layout_receptor_width(all->layout, index, quantity, &width));
  values = mxCalloc(width + 1, sizeof *values);
  mimo_check(mimo_layout_receptors(all->layout, index, quantity, values, width));
  count = field_at(all, index).receptors;
  if (count > 0) width /= count;
  out[0] = mxCreateDoubleMatrix(count, width, mxREAL);
  for (i = 0; i < count * width; ++i) mxGetPr(out[0])[i % width * count + i / width] = values[i];
}

/* struct = observation(number, 'double' or 'single', 'last' or 'final') */
static void observation(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const worlds* all;
  const char *precision, *which;
  stack blocks;
  size_t i;
  (void)nout;
  mimo_need(nin == 3, "expected a world, 'double' or 'single', and 'last' or 'final'");
  all = mimo_worlds_of(in[0]);
  precision = mimo_text(in[1], "precision");
  which = mimo_text(in[2], "which");
  mimo_need(strcmp(precision, "double") == 0 || strcmp(precision, "single") == 0,
            "precision: expected 'double' or 'single'");
  mimo_need(strcmp(which, "last") == 0 || strcmp(which, "final") == 0, "which: expected 'last' or 'final'");
  mimo_need(which[0] == 'l' || all->finals != NULL,
            "which is 'final', but only worlds with the option autoreset 'same_step' have final observations");
  blocks.data = which[0] == 'l' ? all->blocks : all->finals;
  blocks.bytes = all->sizes.block_bytes;
  blocks.count = all->count;
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  for (i = 0; i < all->sizes.fields; ++i) {
    const mimo_field field = field_at(all, i);
    char name[kName];
    member_name(field.name, name);
    mimo_add(out[0], name, mimo_array_of(&field, blocks, precision[0] == 's'));
  }
}

/* bytes = block(number): the observation as the library wrote it, a column for each world */
static void block(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const worlds* all;
  (void)nout;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  out[0] = mxCreateNumericMatrix(all->sizes.block_bytes, all->count, mxUINT8_CLASS, mxREAL);
  memcpy(mxGetData(out[0]), all->blocks, all->count * all->sizes.block_bytes);
}

const mimo_command mimo_layout_commands[] = {
    {"layout", layout},       {"labels", labels},           {"delays", delays}, {"directions", directions},
    {"receptors", receptors}, {"observation", observation}, {"block", block},   {NULL, NULL}};
