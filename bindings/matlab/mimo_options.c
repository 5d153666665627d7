/* mimo_create's options, by the names that the members of mimo.h's structs have. */
#include "mimo_options.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* kArray: read later, by whoever knows what is in it. */
typedef enum kind { kUnsigned, kWide, kSigned, kNumber, kThree, kFour, kText, kArray } kind;

typedef struct option {
  const char* name;
  kind kind;
  size_t offset;
} option;

#define OPTION(type, member, kind) \
  { #member, kind, offsetof(type, member) }

static const option scene_options[] = {
    OPTION(mimo_scene_config, max_file_bytes, kWide),
    OPTION(mimo_scene_config, max_pixels, kWide),
    OPTION(mimo_scene_config, max_vertices, kWide),
    OPTION(mimo_scene_config, max_elements, kWide),
    OPTION(mimo_scene_config, max_keyframes, kWide),
    OPTION(mimo_scene_config, max_iterations, kWide),
    OPTION(mimo_scene_config, max_world_bytes, kWide),
    OPTION(mimo_scene_config, confined, kUnsigned),
    {NULL, kText, 0},
};

static const option agent_options[] = {
    OPTION(mimo_agent_config, body, kText),
    OPTION(mimo_agent_config, face, kText),
    OPTION(mimo_agent_config, root, kText),
    OPTION(mimo_agent_config, vestibular_at, kText),
    OPTION(mimo_agent_config, place, kSigned),
    OPTION(mimo_agent_config, position, kThree),
    OPTION(mimo_agent_config, orientation, kFour),
    OPTION(mimo_agent_config, proprioception, kUnsigned),
    OPTION(mimo_agent_config, vestibular, kUnsigned),
    OPTION(mimo_agent_config, limit_threshold, kNumber),
    OPTION(mimo_agent_config, vision, kUnsigned),
    OPTION(mimo_agent_config, vision_height, kUnsigned),
    OPTION(mimo_agent_config, vision_width, kUnsigned),
    OPTION(mimo_agent_config, vision_fovy, kNumber),
    OPTION(mimo_agent_config, actuation, kUnsigned),
    OPTION(mimo_agent_config, acts, kUnsigned),
    OPTION(mimo_agent_config, normalize_actions, kUnsigned),
    OPTION(mimo_agent_config, touch, kUnsigned),
    OPTION(mimo_agent_config, touch_response, kSigned),
    OPTION(mimo_agent_config, touch_frame, kSigned),
    OPTION(mimo_agent_config, touch_scale, kNumber),
    OPTION(mimo_agent_config, touch_slip_threshold, kNumber),
    {NULL, kText, 0},
};

static const option env_options[] = {
    OPTION(mimo_env_config, frame_skip, kUnsigned),
    OPTION(mimo_env_config, jacobian, kSigned),
    OPTION(mimo_env_config, disable, kUnsigned),
    OPTION(mimo_env_config, renderer, kText),
    OPTION(mimo_env_config, max_steps, kUnsigned),
    OPTION(mimo_env_config, task, kText),
    OPTION(mimo_env_config, render, kUnsigned),
    OPTION(mimo_env_config, samples, kUnsigned),
    OPTION(mimo_env_config, render_threads, kUnsigned),
    OPTION(mimo_env_config, step_contacts, kUnsigned),
    {NULL, kText, 0},
};

static const option batch_options[] = {
    OPTION(mimo_batch_config, worlds, kUnsigned),
    OPTION(mimo_batch_config, threads, kUnsigned),
    OPTION(mimo_batch_config, autoreset, kSigned),
    OPTION(mimo_batch_config, restart_failed, kUnsigned),
    {NULL, kText, 0},
};

static const option object_options[] = {
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

static const option camera_options[] = {
    OPTION(mimo_camera_config, outputs, kUnsigned), OPTION(mimo_camera_config, name, kText),
    OPTION(mimo_camera_config, height, kUnsigned),  OPTION(mimo_camera_config, width, kUnsigned),
    OPTION(mimo_camera_config, fovy, kNumber),      OPTION(mimo_camera_config, placed, kUnsigned),
    OPTION(mimo_camera_config, body, kText),        OPTION(mimo_camera_config, position, kThree),
    OPTION(mimo_camera_config, look_at, kThree),    {NULL, kText, 0},
};

/* A member of limits: mimo_limits, and what they are for. */
typedef struct limited_sense {
  mimo_limits limits; /* comes first: its members have the same offsets here */
  const char* path;
} limited_sense;

static const option limit_options[] = {
    OPTION(limited_sense, path, kText),  OPTION(mimo_limits, delay, kUnsigned), OPTION(mimo_limits, gain, kNumber),
    OPTION(mimo_limits, noise, kNumber), OPTION(mimo_limits, blur, kNumber),    {NULL, kText, 0},
};

/* What the call asks for, in the order in which a scene takes it. */
typedef struct request {
  mimo_agent_config agent;
  mimo_env_config env;
  mimo_batch_config batch;
  int is_placed; /* whether a position or orientation was given */
  const mxArray *objects, *cameras, *limits, *parameters;
} request;

static const option array_options[] = {
    OPTION(request, objects, kArray),
    OPTION(request, cameras, kArray),
    OPTION(request, limits, kArray),
    OPTION(request, parameters, kArray),
    {NULL, kText, 0},
};

static const option* find_option(const option* options, const char* name) {
  for (; options->name != NULL; ++options)
    if (strcmp(options->name, name) == 0) return options;
  return NULL;
}

static void refuse(const char* name, const char* expected) { mimo_refuse("%s: expected %s", name, expected); }

static void read_numbers(double* to, size_t count, const char* name, const mxArray* value) {
  if (!mxIsDouble(value) || mxIsComplex(value) || mxGetNumberOfElements(value) != count)
    refuse(name, count == 3 ? "three numbers" : "four numbers");
  memcpy(to, mxGetPr(value), count * sizeof *to);
}

/* Whole numbers of C that would not survive a conversion are refused here; ranges are the library's business. */
static double whole(const char* name, const mxArray* value, double low, double high) {
  const double number = mimo_number(value, name);
  if (!(number >= low && number <= high) || number != floor(number)) refuse(name, "a whole number");
  return number;
}

static void set_option(void* config, const option* option, const mxArray* value) {
  char* member = (char*)config + option->offset;
  switch (option->kind) {
    case kUnsigned: *(uint32_t*)member = (uint32_t)whole(option->name, value, 0, 4294967295.0); break;
    case kWide: *(uint64_t*)member = (uint64_t)whole(option->name, value, 0, 9007199254740992.0); break;
    case kSigned: *(int32_t*)member = (int32_t)whole(option->name, value, -2147483648.0, 2147483647.0); break;
    case kNumber: *(double*)member = mimo_number(value, option->name); break;
    case kThree: read_numbers((double*)member, 3, option->name, value); break;
    case kFour: read_numbers((double*)member, 4, option->name, value); break;
    case kArray: *(const mxArray**)member = value; break;
    default: *(const char**)member = mimo_text(value, option->name); break;
  }
}

/* The members of one struct of MATLAB's, which may leave out any. */
static void set_members(void* config, const option* options, const mxArray* things, size_t index) {
  int i;
  for (i = 0; i < mxGetNumberOfFields(things); ++i) {
    const char* name = mxGetFieldNameByNumber(things, i);
    const option* found = find_option(options, name);
    const mxArray* value = mxGetFieldByNumber(things, index, i);
    if (found == NULL) refuse(name, "a member of mimo.h's struct");
    if (value != NULL && !mxIsEmpty(value)) set_option(config, found, value);
  }
}

static void add_object(mimo_scene* scene, const mxArray* things, size_t index) {
  mimo_object_config config;
  mimo_check(mimo_object_config_init(&config, sizeof config));
  set_members(&config, object_options, things, index);
  mimo_check(mimo_scene_add_object(scene, &config));
}

static void add_camera(mimo_scene* scene, const mxArray* things, size_t index) {
  const mxArray* place = mxGetField(things, index, "look_at");
  mimo_camera_config config;
  mimo_check(mimo_camera_config_init(&config, sizeof config));
  config.placed = place != NULL && !mxIsEmpty(place);
  set_members(&config, camera_options, things, index);
  mimo_check(mimo_scene_add_camera(scene, &config));
}

/* struct('path', 'touch', 'noise', 0.1) */
static void limit_sense(mimo_scene* scene, const mxArray* things, size_t index) {
  limited_sense sense;
  sense.path = NULL;
  mimo_check(mimo_limits_init(&sense.limits, sizeof sense.limits));
  set_members(&sense, limit_options, things, index);
  if (sense.path == NULL) refuse("limits", "a path in each");
  mimo_check(mimo_scene_limit_sense(scene, 0, sense.path, &sense.limits));
}

/* One struct or an array of them; NULL is none. */
static void each(mimo_scene* scene, const char* name, const mxArray* things,
                 void (*add)(mimo_scene*, const mxArray*, size_t)) {
  size_t i;
  if (things == NULL) return;
  if (!mxIsStruct(things)) refuse(name, "a struct array");
  for (i = 0; i < mxGetNumberOfElements(things); ++i) add(scene, things, i);
}

/* {'reach/success_reward', 5; ...} */
static void set_parameters(mimo_scene* scene, const mxArray* pairs) {
  size_t i, count;
  if (pairs == NULL) return;
  count = mxGetM(pairs);
  if (!mxIsCell(pairs) || mxGetN(pairs) != 2) refuse("parameters", "a cell array of names and values, two columns");
  for (i = 0; i < count; ++i)
    mimo_check(mimo_scene_set_parameter(scene, mimo_text(mxGetCell(pairs, i), "parameters"),
                                        mimo_number(mxGetCell(pairs, count + i), "parameters")));
}

static void read_option(request* all, const char* name, const mxArray* value) {
  const struct {
    void* config;
    const option* options;
  } parts[] = {
      {&all->agent, agent_options}, {&all->env, env_options}, {&all->batch, batch_options}, {all, array_options}};
  size_t i;
  if (find_option(scene_options, name) != NULL) return; /* it had its turn when the scene was opened */
  for (i = 0; i < sizeof parts / sizeof *parts; ++i) {
    const option* found = find_option(parts[i].options, name);
    if (found == NULL) continue;
    set_option(parts[i].config, found, value);
    if (strcmp(name, "position") == 0 || strcmp(name, "orientation") == 0) all->is_placed = 1;
    return;
  }
  mimo_refuse("no option %s; see help mimo_create", name);
}

/* "reach", or "room.xml" for a file of one's own; the names and values of options follow. */
static mimo_scene* open_scene(const char* name, int count, const mxArray* options[]) {
  const size_t length = strlen(name);
  const int is_file = length > 4 && strcmp(name + length - 4, ".xml") == 0;
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  int i;
  mimo_check(mimo_scene_config_init(&config, sizeof config));
  for (i = 0; i + 1 < count; i += 2) {
    const option* found = find_option(scene_options, mimo_text(options[i], "option"));
    if (found != NULL) set_option(&config, found, options[i + 1]);
  }
  if (is_file)
    config.file = name;
  else
    config.name = name;
  mimo_check(mimo_scene_create(&config, &scene));
  mimo_making(scene);
  return scene;
}

mimo_batch* mimo_create_batch(int nin, const mxArray* in[]) {
  request all;
  mimo_scene* scene;
  mimo_batch* batch = NULL;
  int i;
  mimo_need(nin % 2 == 1, "expected the name of a scene, then names and values of options");
  scene = open_scene(mimo_text(in[0], "scene"), nin - 1, in + 1);
  memset(&all, 0, sizeof all);
  mimo_check(mimo_scene_default_agent(scene, &all.agent, sizeof all.agent));
  mimo_check(mimo_env_config_init(&all.env, sizeof all.env));
  mimo_check(mimo_batch_config_init(&all.batch, sizeof all.batch));
  for (i = 1; i < nin; i += 2) read_option(&all, mimo_text(in[i], "option"), in[i + 1]);
  if (all.is_placed && all.agent.place == MIMO_PLACE_SCENE) all.agent.place = MIMO_PLACE_ROOT;
  set_parameters(scene, all.parameters);
  mimo_check(mimo_scene_add_agents(scene, &all.agent, NULL));
  each(scene, "limits", all.limits, limit_sense);
  each(scene, "objects", all.objects, add_object);
  each(scene, "cameras", all.cameras, add_camera);
  mimo_check(mimo_batch_create(scene, &all.env, &all.batch, &batch));
  mimo_making(NULL);
  return batch;
}
