/* Options, by the names that the members of mimo.h's structs have. */
#include "mimo_options.h"

#include <stdint.h>
#include <string.h>

#define OPTION(type, member, kind) \
  { #member, kind, offsetof(type, member) }

const option mimo_scene_options[] = {
    OPTION(mimo_scene_config, model_dir, kText),
    OPTION(mimo_scene_config, max_file_bytes, kWide),
    OPTION(mimo_scene_config, max_pixels, kWide),
    OPTION(mimo_scene_config, max_vertices, kWide),
    OPTION(mimo_scene_config, max_elements, kWide),
    OPTION(mimo_scene_config, max_keyframes, kWide),
    OPTION(mimo_scene_config, max_iterations, kWide),
    OPTION(mimo_scene_config, max_world_bytes, kWide),
    OPTION(mimo_scene_config, confined, kUnsigned),
    OPTION(mimo_scene_config, max_compile_ms, kWide),
    {NULL, kText, 0},
};

const option mimo_agent_options[] = {
    OPTION(mimo_agent_config, name, kText),
    OPTION(mimo_agent_config, body, kText),
    OPTION(mimo_agent_config, face, kText),
    OPTION(mimo_agent_config, root, kText),
    OPTION(mimo_agent_config, vestibular_at, kText),
    OPTION(mimo_agent_config, place, kSigned),
    OPTION(mimo_agent_config, position, kThree),
    OPTION(mimo_agent_config, orientation, kFour),
    OPTION(mimo_agent_config, proprioception, kUnsigned),
    OPTION(mimo_agent_config, vestibular, kUnsigned),
    OPTION(mimo_agent_config, hearing, kUnsigned),
    OPTION(mimo_agent_config, voice, kUnsigned),
    OPTION(mimo_agent_config, limit_threshold, kNumber),
    OPTION(mimo_agent_config, vision, kUnsigned),
    OPTION(mimo_agent_config, vision_height, kUnsigned),
    OPTION(mimo_agent_config, vision_width, kUnsigned),
    OPTION(mimo_agent_config, vision_fovy, kNumber),
    OPTION(mimo_agent_config, vision_foveation, kNumber),
    OPTION(mimo_agent_config, actuation, kSigned),
    OPTION(mimo_agent_config, acts, kUnsigned),
    OPTION(mimo_agent_config, normalize_actions, kUnsigned),
    OPTION(mimo_agent_config, touch, kUnsigned),
    OPTION(mimo_agent_config, touch_response, kSigned),
    OPTION(mimo_agent_config, touch_frame, kSigned),
    OPTION(mimo_agent_config, touch_scale, kNumber),
    OPTION(mimo_agent_config, touch_slip_threshold, kNumber),
    OPTION(mimo_agent_config, reflexes, kUnsigned),
    {NULL, kText, 0},
};

/* The member model is the option "growth". */
const option mimo_growth_options[] = {
    OPTION(mimo_growth, sex, kSigned),
    OPTION(mimo_growth, age, kNumber),
    OPTION(mimo_growth, physiological_age, kNumber),
    OPTION(mimo_growth, z_length, kNumber),
    OPTION(mimo_growth, z_weight, kNumber),
    OPTION(mimo_growth, z_head, kNumber),
    OPTION(mimo_growth, percentile, kNumber),
    OPTION(mimo_growth, strength_exponent, kNumber),
    OPTION(mimo_growth, neck_strength, kNumber),
    OPTION(mimo_growth, birth_tone, kNumber),
    OPTION(mimo_growth, contracture, kNumber),
    OPTION(mimo_growth, absolute, kUnsigned),
    OPTION(mimo_growth, keep_spacing, kUnsigned),
    OPTION(mimo_growth, maturity, kMaturity),
    {"growth", kSigned, offsetof(mimo_growth, model)},
    {NULL, kText, 0},
};

const option mimo_env_options[] = {
    OPTION(mimo_env_config, frame_skip, kUnsigned),     OPTION(mimo_env_config, jacobian, kSigned),
    OPTION(mimo_env_config, disable, kUnsigned),        OPTION(mimo_env_config, renderer, kText),
    OPTION(mimo_env_config, max_steps, kUnsigned),      OPTION(mimo_env_config, task, kText),
    OPTION(mimo_env_config, render, kUnsigned),         OPTION(mimo_env_config, samples, kUnsigned),
    OPTION(mimo_env_config, render_threads, kUnsigned), OPTION(mimo_env_config, step_contacts, kUnsigned),
    OPTION(mimo_env_config, timing, kUnsigned),         {NULL, kText, 0},
};

const option mimo_batch_options[] = {
    OPTION(mimo_batch_config, worlds, kUnsigned),
    OPTION(mimo_batch_config, threads, kUnsigned),
    OPTION(mimo_batch_config, autoreset, kSigned),
    OPTION(mimo_batch_config, restart_failed, kUnsigned),
    {NULL, kText, 0},
};

const option mimo_object_options[] = {
    OPTION(mimo_object_config, shape, kSigned),
    OPTION(mimo_object_config, name, kText),
    OPTION(mimo_object_config, size, kThree),
    OPTION(mimo_object_config, position, kThree),
    OPTION(mimo_object_config, orientation, kFour),
    OPTION(mimo_object_config, mass, kNumber),
    OPTION(mimo_object_config, rgba, kFour),
    OPTION(mimo_object_config, fixed, kUnsigned),
    {NULL, kText, 0},
};

const option mimo_model_options[] = {
    OPTION(mimo_model_config, name, kText),
    OPTION(mimo_model_config, file, kText),
    OPTION(mimo_model_config, xml, kText),
    OPTION(mimo_model_config, fixed, kUnsigned),
    OPTION(mimo_model_config, position, kThree),
    OPTION(mimo_model_config, orientation, kFour),
    {NULL, kText, 0},
};

const option mimo_camera_options[] = {
    OPTION(mimo_camera_config, outputs, kUnsigned), OPTION(mimo_camera_config, name, kText),
    OPTION(mimo_camera_config, height, kUnsigned),  OPTION(mimo_camera_config, width, kUnsigned),
    OPTION(mimo_camera_config, fovy, kNumber),      OPTION(mimo_camera_config, placed, kUnsigned),
    OPTION(mimo_camera_config, body, kText),        OPTION(mimo_camera_config, position, kThree),
    OPTION(mimo_camera_config, look_at, kThree),    {NULL, kText, 0},
};

const option mimo_recorder_options[] = {
    OPTION(mimo_recorder_config, keep, kText),
    OPTION(mimo_recorder_config, state_seconds, kNumber),
    OPTION(mimo_recorder_config, flush_seconds, kNumber),
    OPTION(mimo_recorder_config, compression, kUnsigned),
    OPTION(mimo_recorder_config, configuration, kText),
    OPTION(mimo_recorder_config, seed, kWide),
    OPTION(mimo_recorder_config, hdf5, kText),
    OPTION(mimo_recorder_config, replace, kUnsigned),
    {NULL, kText, 0},
};

const option mimo_field_options[] = {
    OPTION(mimo_field_config, name, kText),
    OPTION(mimo_field_config, relative_to, kText),
    {NULL, kText, 0},
};

const option mimo_limit_options[] = {
    OPTION(mimo_limits, delay, kNumber),        OPTION(mimo_limits, gain, kNumber),
    OPTION(mimo_limits, noise, kNumber),        OPTION(mimo_limits, blur, kNumber),
    OPTION(mimo_limits, signal_noise, kNumber), {NULL, kText, 0},
};

const option mimo_maturity_options[] = {
    OPTION(mimo_maturity, acuity, kNumber),
    OPTION(mimo_maturity, peak_contrast, kNumber),
    OPTION(mimo_maturity, chroma, kNumber),
    OPTION(mimo_maturity, flicker, kNumber),
    OPTION(mimo_maturity, contrast_threshold, kUnsigned),
    OPTION(mimo_maturity, conduction_speed, kNumber),
    OPTION(mimo_maturity, sensory_delay, kNumber),
    OPTION(mimo_maturity, motor_delay, kNumber),
    OPTION(mimo_maturity, vision_delay, kNumber),
    OPTION(mimo_maturity, vestibular_delay, kNumber),
    OPTION(mimo_maturity, hearing_delay, kNumber),
    {NULL, kText, 0},
};

const option mimo_picture_options[] = {
    OPTION(mimo_picture_config, camera, kText),      OPTION(mimo_picture_config, look_at, kThree),
    OPTION(mimo_picture_config, distance, kNumber),  OPTION(mimo_picture_config, azimuth, kNumber),
    OPTION(mimo_picture_config, elevation, kNumber), OPTION(mimo_picture_config, fovy, kNumber),
    OPTION(mimo_picture_config, foveation, kNumber), {NULL, kText, 0},
};

const option mimo_no_options[] = {{NULL, kText, 0}};

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
  while ((i = place_of(given, name)) < given->count) { /* of several the last one counts */
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

/* What of an infant is as old as it: one of these words, several, or bits. */
static uint32_t maturity(const char* name, const mxArray* value) {
  static const struct word {
    const char* text;
    uint32_t bit;
  } words[] = {{"body", MIMO_MATURITY_BODY},       {"eyes", MIMO_MATURITY_EYES},
               {"delays", MIMO_MATURITY_DELAYS},   {"threshold", MIMO_MATURITY_THRESHOLD},
               {"flicker", MIMO_MATURITY_FLICKER}, {"all", MIMO_MATURITY_ALL}};
  const size_t known = sizeof words / sizeof words[0];
  uint32_t bits = 0;
  const char** texts;
  size_t count, i, word;
  if (mxIsNumeric(value)) return (uint32_t)mimo_whole(value, name, 0, 4294967295.0);
  texts = mimo_texts(value, &count, name);
  for (i = 0; i < count; ++i) {
    for (word = 0; word < known && strcmp(words[word].text, texts[i]) != 0; ++word) continue;
    if (word == known)
      mimo_refuse("%s is \"%s\", expected body, eyes, delays, threshold, flicker or all", name, texts[i]);
    bits |= words[word].bit;
  }
  return bits;
}

static void set_option(void* config, const option* option, const mxArray* value) {
  char* member = (char*)config + option->offset;
  switch (option->kind) {
    case kUnsigned: *(uint32_t*)member = (uint32_t)mimo_whole(value, option->name, 0, 4294967295.0); break;
    case kWide: *(uint64_t*)member = (uint64_t)mimo_whole(value, option->name, 0, 9007199254740992.0); break;
    case kSigned: *(int32_t*)member = (int32_t)mimo_whole(value, option->name, -2147483648.0, 2147483647.0); break;
    case kMaturity: *(uint32_t*)member = maturity(option->name, value); break;
    case kNumber: *(double*)member = mimo_number(value, option->name); break;
    case kThree: mimo_read_numbers((double*)member, 3, option->name, value); break;
    case kFour: mimo_read_numbers((double*)member, 4, option->name, value); break;
    default: *(const char**)member = mimo_text(value, option->name); break;
  }
}

int mimo_has_any(const properties* given, const option* options) {
  const option* one;
  for (one = options; one->name != NULL; ++one)
    if (mimo_has(given, one->name)) return 1;
  return 0;
}

void mimo_set_known(void* config, const option* options, properties* given) {
  const option* found;
  for (found = options; found->name != NULL; ++found) {
    const mxArray* value = mimo_take(given, found->name);
    if (value != NULL) set_option(config, found, value);
  }
}

void mimo_set_all(void* config, const option* options, properties* given, const char* of) {
  mimo_set_known(config, options, given);
  if (given->count > 0) mimo_refuse("no option %s of %s", given->names[0], of);
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
