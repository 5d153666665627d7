/* Options, named like the members of mimo.h's structs. */
#include "mimo_options.h"

#include <stdint.h>
#include <string.h>

#include "mimo_words.h"

static void refuse(const char* name, const char* expected) { mimo_refuse("%s: expected %s", name, expected); }

static properties room_for(size_t count) {
  properties given;
  given.count = 0;
  given.names = mxCalloc(count + 1, sizeof *given.names); /* MATLAB frees them at the end of the call */
  given.values = mxCalloc(count + 1, sizeof *given.values);
  return given;
}

static void give(properties* given, const char* name, const mxArray* value) {
  given->names[given->count] = name;
  given->values[given->count++] = value;
}

properties mimo_pairs(int count, const mxArray* in[]) {
  properties given = room_for((size_t)count);
  int i;
  mimo_need(count % 2 == 0, "expected names and values of options");
  for (i = 0; i < count; i += 2) give(&given, mimo_text(in[i], "option"), in[i + 1]);
  return given;
}

properties mimo_members(const mxArray* things, size_t index) {
  const int count = mxGetNumberOfFields(things);
  properties given = room_for((size_t)count);
  int i;
  for (i = 0; i < count; ++i) {
    const mxArray* value = mxGetFieldByNumber(things, index, i);
    if (value != NULL && !mxIsEmpty(value)) give(&given, mxGetFieldNameByNumber(things, i), value);
  }
  return given;
}

static size_t place_of(const properties* given, const char* name) {
  size_t i;
  for (i = 0; i < given->count && strcmp(given->names[i], name) != 0; ++i) continue;
  return i;
}

int mimo_has(const properties* given, const char* name) { return place_of(given, name) < given->count; }

const mxArray* mimo_take(properties* given, const char* name) {
  const mxArray* value = NULL;
  size_t i;
  while ((i = place_of(given, name)) < given->count) { /* if it is given twice, the last value counts */
    value = given->values[i];
    for (--given->count; i < given->count; ++i) {
      given->names[i] = given->names[i + 1];
      given->values[i] = given->values[i + 1];
    }
  }
  return value;
}

const char* mimo_take_text(properties* given, const char* name) {
  const mxArray* value = mimo_take(given, name);
  if (value == NULL) refuse(name, "a text");
  return mimo_text(value, name);
}

double mimo_take_number(properties* given, const char* name) {
  const mxArray* value = mimo_take(given, name);
  if (value == NULL) refuse(name, "a number");
  return mimo_number(value, name);
}

void mimo_read_numbers(double* to, size_t count, const char* name, const mxArray* value) {
  memcpy(to, mimo_vector(value, name, count), count * sizeof *to);
}

/* A single number may have any class, several are double or single. */
static void set_numbers(double* to, size_t count, const char* name, const mxArray* value) {
  if (count == 1)
    *to = mimo_number(value, name);
  else
    mimo_read_numbers(to, count, name, value);
}

static void set_floats(float* to, size_t count, const char* name, const mxArray* value) {
  const double* numbers = mimo_vector(value, name, count);
  size_t i;
  for (i = 0; i < count; ++i) to[i] = (float)numbers[i];
}

static void set_option(void* config, const member* option, const mxArray* value) {
  char* to = (char*)config + option->offset;
  const char* name = option->name;
  if (option->words != NULL) {
    const int64_t words = mimo_value_of(value, name, option->words);
    if (option->kind == kSigned)
      *(int32_t*)to = (int32_t)words;
    else
      *(uint32_t*)to = (uint32_t)words;
    return;
  }
  switch (option->kind) {
    case kSwitch:
    case kUnsigned: *(uint32_t*)to = (uint32_t)mimo_whole(value, name, 0, 4294967295.0); break;
    case kWide: *(uint64_t*)to = (uint64_t)mimo_whole(value, name, 0, 9007199254740992.0); break;
    case kSigned: *(int32_t*)to = (int32_t)mimo_whole(value, name, -2147483648.0, 2147483647.0); break;
    case kNumbers: set_numbers((double*)to, option->count, name, value); break;
    case kFloats: set_floats((float*)to, option->count, name, value); break;
    default: *(const char**)to = mimo_text(value, name); break;
  }
}

int mimo_has_any(const properties* given, const member* options) {
  const member* one;
  for (one = options; one->name != NULL; ++one)
    if (mimo_has(given, one->name)) return 1;
  return 0;
}

void mimo_set_known(void* config, const member* options, properties* given) {
  const member* found;
  for (found = options; found->name != NULL; ++found) {
    const mxArray* value = mimo_take(given, found->name);
    if (value != NULL) set_option(config, found, value);
  }
}

void mimo_no_more(const properties* given, const char* of) {
  if (given->count > 0) mimo_refuse("no option %s of %s", given->names[0], of);
}

void mimo_set_all(void* config, const member* options, properties* given, const char* of) {
  mimo_set_known(config, options, given);
  mimo_no_more(given, of);
}

const mimo_growth* const* mimo_ages(const mxArray* months, const mimo_growth* usual, size_t* count) {
  const mimo_growth** ages;
  const double* numbers;
  mimo_growth* growths;
  size_t i;
  *count = mxGetNumberOfElements(months);
  if (*count == 0) return NULL;
  numbers = mimo_vector(months, "ages", *count);
  ages = mxCalloc(*count, sizeof *ages);
  growths = mxCalloc(*count, sizeof *growths);
  for (i = 0; i < *count; ++i) {
    if (mxIsNaN(numbers[i])) continue;
    growths[i] = *usual;
    growths[i].age = numbers[i];
    ages[i] = &growths[i];
  }
  return ages;
}
