/* Commands for scenes, and how worlds are made from them. */
#include "mimo_scenes.h"

#include <ctype.h>
#include <string.h>

#include "mimo_messages.h"
#include "mimo_options.h"
#include "mimo_words.h"

/* Adds a thing with its options to a scene. Returns the thing's number, or 0 for things without a number. */
typedef double (*adder)(mimo_scene* scene, properties* given);

/* Agents are counted from 1; the default is the first. */
static size_t take_agent(properties* given) {
  const mxArray* value = mimo_take(given, "agent");
  return value == NULL ? 0 : (size_t)mimo_whole(value, "agent", 1, 2147483647.0) - 1;
}

/* The growth, if any of its options is given. */
static const mimo_growth* take_growth(properties* given, mimo_growth* growth) {
  mimo_check(mimo_growth_init(growth, sizeof *growth));
  if (!mimo_has_any(given, mimo_growth_options)) return NULL;
  growth->matures_apart = mimo_has(given, "physiological_age");
  mimo_set_known(growth, mimo_growth_options, given);
  return growth;
}

/* The library uses a position only with a place, so a given position sets the place. The config points to `growth`. */
static mimo_agent_config take_agent_config(mimo_scene* scene, properties* given, mimo_growth* growth) {
  const int is_placed = mimo_has(given, "position") || mimo_has(given, "orientation");
  mimo_agent_config config;
  mimo_check(mimo_scene_default_agent(scene, &config, sizeof config));
  mimo_set_known(&config, mimo_agent_options, given);
  if (is_placed && config.place == MIMO_PLACE_SCENE) config.place = MIMO_PLACE_ROOT;
  config.growth = take_growth(given, growth);
  return config;
}

static double add_agent(mimo_scene* scene, properties* given) {
  mimo_growth growth;
  const mimo_agent_config config = take_agent_config(scene, given, &growth);
  size_t agent = 0;
  mimo_no_more(given, "an agent");
  mimo_check(mimo_scene_add_agent(scene, &config, &agent));
  return (double)agent + 1;
}

static double add_agents(mimo_scene* scene, properties* given) {
  mimo_growth growth;
  const mimo_agent_config config = take_agent_config(scene, given, &growth);
  size_t count = 0;
  mimo_no_more(given, "agents");
  mimo_check(mimo_scene_add_agents(scene, &config, &count));
  return (double)count;
}

static double add_object(mimo_scene* scene, properties* given) {
  mimo_object_config config;
  mimo_check(mimo_object_config_init(&config, sizeof config));
  mimo_set_all(&config, mimo_object_options, given, "an object");
  mimo_check(mimo_scene_add_object(scene, &config));
  return 0;
}

static double add_model(mimo_scene* scene, properties* given) {
  mimo_model_config config;
  mimo_check(mimo_model_config_init(&config, sizeof config));
  mimo_set_all(&config, mimo_model_options, given, "a model");
  mimo_check(mimo_scene_add_model(scene, &config));
  return 0;
}

/* A camera with look_at is a new one. */
static double add_camera(mimo_scene* scene, properties* given) {
  mimo_camera_config config;
  mimo_check(mimo_camera_config_init(&config, sizeof config));
  config.placed = mimo_has(given, "look_at");
  mimo_set_all(&config, mimo_camera_options, given, "a camera");
  mimo_check(mimo_scene_add_camera(scene, &config));
  return 0;
}

static double add_field(mimo_scene* scene, properties* given) {
  const mxArray* quantity = mimo_take(given, "quantity");
  const mxArray* elements = mimo_take(given, "elements");
  mimo_field_config config;
  mimo_check(mimo_field_config_init(&config, sizeof config));
  mimo_set_all(&config, mimo_field_options, given, "a field");
  if (quantity != NULL) config.quantity = mimo_quantity_of(quantity).number;
  config.elements = mimo_texts(elements, &config.element_count, "elements");
  mimo_check(mimo_scene_add_field(scene, &config));
  return 0;
}

static double add_room(mimo_scene* scene, properties* given) {
  const char* name = mimo_take_text(given, "name");
  mimo_no_more(given, "a room");
  mimo_check(mimo_scene_set_room(scene, name));
  return 0;
}

static double add_weld(mimo_scene* scene, properties* given) {
  const char* body = mimo_take_text(given, "body");
  const mxArray* other = mimo_take(given, "other");
  const mxArray* place = mimo_take(given, "pose");
  double pose[7];
  if (place != NULL) mimo_read_numbers(pose, 7, "pose", place);
  mimo_no_more(given, "a weld");
  mimo_check(
      mimo_scene_weld(scene, body, other == NULL ? NULL : mimo_text(other, "other"), place == NULL ? NULL : pose));
  return 0;
}

/* Sets a number of something that has a name. */
static double set_named(mimo_scene* scene, properties* given, const char* name, const char* number, const char* what,
                        mimo_status (*set)(mimo_scene*, const char*, double)) {
  const char* text = mimo_take_text(given, name);
  const double value = mimo_take_number(given, number);
  mimo_no_more(given, what);
  mimo_check(set(scene, text, value));
  return 0;
}

static double add_lock(mimo_scene* scene, properties* given) {
  return set_named(scene, given, "joint", "value", "a lock", mimo_scene_lock);
}

static double add_pose(mimo_scene* scene, properties* given) {
  return set_named(scene, given, "joint", "value", "a pose", mimo_scene_set_pose);
}

static double add_temperature(mimo_scene* scene, properties* given) {
  return set_named(scene, given, "body", "celsius", "a temperature", mimo_scene_set_temperature);
}

static double add_parameter(mimo_scene* scene, properties* given) {
  return set_named(scene, given, "name", "value", "a parameter", mimo_scene_set_parameter);
}

/* Sets a number for a part of the body, or for all of it. */
static double set_part(mimo_scene* scene, properties* given, const char* number, const char* what,
                       mimo_status (*set)(mimo_scene*, size_t, const char*, double)) {
  const size_t agent = take_agent(given);
  const mxArray* body = mimo_take(given, "body");
  const double value = mimo_take_number(given, number);
  mimo_no_more(given, what);
  mimo_check(set(scene, agent, body == NULL ? NULL : mimo_text(body, "body"), value));
  return 0;
}

static double add_skin(mimo_scene* scene, properties* given) {
  return set_part(scene, given, "spacing", "a skin", mimo_scene_set_touch);
}

static double add_sensory_delay(mimo_scene* scene, properties* given) {
  return set_part(scene, given, "seconds", "a sensory delay", mimo_scene_set_sensory_delay);
}

static double set_sources(mimo_scene* scene, properties* given) {
  const mxArray* bodies = mimo_take(given, "count");
  const double seconds = mimo_take_number(given, "seconds");
  double count;
  mimo_need(bodies != NULL, "count: expected a number");
  mimo_no_more(given, "sources");
  count = mimo_whole(bodies, "count", 1, 64);
  mimo_check(mimo_scene_set_sources(scene, (size_t)count, seconds));
  return 0;
}

static double add_source_direction(mimo_scene* scene, properties* given) {
  const char* body = mimo_take_text(given, "body");
  const mxArray *from = mimo_take(given, "place"), *along = mimo_take(given, "axis");
  const double directivity = mimo_take_number(given, "directivity");
  double place[3], axis[3];
  mimo_need(from != NULL && along != NULL, "place, axis: expected three numbers each");
  mimo_read_numbers(place, 3, "place", from);
  mimo_read_numbers(axis, 3, "axis", along);
  mimo_no_more(given, "a source direction");
  mimo_check(mimo_scene_direct_source(scene, body, place, axis, directivity));
  return 0;
}

static double add_joint(mimo_scene* scene, properties* given) {
  const size_t agent = take_agent(given);
  const char* joint = mimo_take_text(given, "joint");
  mimo_no_more(given, "a joint");
  mimo_check(mimo_scene_read_joint(scene, agent, joint));
  return 0;
}

/* Limits a sense or a motor. */
static double limit(mimo_scene* scene, properties* given,
                    mimo_status (*set)(mimo_scene*, size_t, const char*, const mimo_limits*)) {
  const size_t agent = take_agent(given);
  const char* path = mimo_take_text(given, "path");
  mimo_limits limits;
  mimo_check(mimo_limits_init(&limits, sizeof limits));
  mimo_set_all(&limits, mimo_limits_options, given, "limits");
  mimo_check(set(scene, agent, path, &limits));
  return 0;
}

static double add_limits(mimo_scene* scene, properties* given) { return limit(scene, given, mimo_scene_limit_sense); }

static double add_motor_limits(mimo_scene* scene, properties* given) {
  return limit(scene, given, mimo_scene_limit_motor);
}

/* The maturity of an age, or perfect eyes and nerves, with the given numbers. Without options the growth decides. */
static double add_maturity(mimo_scene* scene, properties* given) {
  const size_t agent = take_agent(given);
  const int is_given = given->count > 0;
  mimo_maturity maturity;
  if (mimo_has(given, "age"))
    mimo_check(mimo_maturity_at(mimo_take_number(given, "age"), &maturity, sizeof maturity));
  else
    mimo_check(mimo_maturity_init(&maturity, sizeof maturity));
  mimo_set_all(&maturity, mimo_maturity_options, given, "maturity");
  mimo_check(mimo_scene_set_maturity(scene, agent, is_given ? &maturity : NULL));
  return 0;
}

static double add_room_temperature(mimo_scene* scene, properties* given) {
  const double celsius = mimo_take_number(given, "celsius");
  mimo_no_more(given, "a room temperature");
  mimo_check(mimo_scene_set_room_temperature(scene, celsius));
  return 0;
}

static double add_material(mimo_scene* scene, properties* given) {
  const char* body = mimo_take_text(given, "body");
  const char* name = mimo_take_text(given, "name");
  mimo_no_more(given, "a material");
  mimo_check(mimo_scene_set_material(scene, body, name));
  return 0;
}

static double add_sense(mimo_scene* scene, properties* given) {
  const size_t agent = take_agent(given);
  const char* path = mimo_take_text(given, "path");
  mimo_no_more(given, "a sense");
  mimo_check(mimo_scene_load_sense(scene, agent, path));
  return 0;
}

static const struct thing {
  const char* name;
  adder add;
} things[] = {
    {"agent", add_agent},
    {"agents", add_agents},
    {"object", add_object},
    {"model", add_model},
    {"camera", add_camera},
    {"room", add_room},
    {"weld", add_weld},
    {"lock", add_lock},
    {"pose", add_pose},
    {"skin", add_skin},
    {"joint", add_joint},
    {"limits", add_limits},
    {"parameter", add_parameter},
    {"motor_limits", add_motor_limits},
    {"field", add_field},
    {"maturity", add_maturity},
    {"sensory_delay", add_sensory_delay},
    {"sources", set_sources},
    {"source_direction", add_source_direction},
    {"room_temperature", add_room_temperature},
    {"temperature", add_temperature},
    {"material", add_material},
    {"sense", add_sense},
};

/* number = scene_add(scene, what, name, value, ...) */
static void scene_add(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const char* what;
  properties given;
  mimo_scene* scene;
  size_t i;
  (void)nout;
  mimo_need(nin >= 2, "expected a scene, the kind of thing to add, and names and values");
  scene = mimo_scene_of(in[0]);
  what = mimo_text(in[1], "what");
  given = mimo_pairs(nin - 2, in + 2);
  for (i = 0; i < sizeof things / sizeof *things && strcmp(things[i].name, what) != 0; ++i) continue;
  if (i == sizeof things / sizeof *things)
    mimo_refuse("what is \"%s\"; help mimo_scene_add lists the things that can be added", what);
  out[0] = mxCreateDoubleScalar(things[i].add(scene, &given));
}

/* The name of a built-in scene, the path of a file that ends with .xml, or a document. */
static void set_start(mimo_scene_config* config, const char* start) {
  const size_t length = strlen(start);
  const char* first = start;
  mimo_need(length > 0,
            "scene is '', expected a built-in scene, an MJCF file or MJCF text; mimo_scene() is an empty world");
  while (isspace((unsigned char)*first)) ++first;
  if (*first == '<')
    config->xml = start;
  else if (length > 4 && strcmp(start + length - 4, ".xml") == 0)
    config->file = start;
  else
    config->name = start;
}

/* Opens a scene, with `start` NULL an empty world, and takes its options out of `given`. Its messages get the number.
 */
static mimo_scene* open_scene(const mxArray* start, properties* given, double number) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  mimo_check(mimo_scene_config_init(&config, sizeof config));
  config.log = mimo_keep_message;
  config.log_user = mimo_teller(number);
  mimo_set_known(&config, mimo_scene_options, given);
  if (start != NULL) set_start(&config, mimo_text(start, "scene"));
  mimo_check(mimo_scene_create(&config, &scene));
  mimo_making(scene);
  return scene;
}

/* number = scene(), or scene(name, file or document, option, value, ...) */
static void new_scene(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  properties given = mimo_pairs(nin > 0 ? nin - 1 : 0, in + (nin > 0));
  const double number = mimo_new_scene();
  mimo_scene* scene;
  (void)nout;
  scene = open_scene(nin > 0 ? in[0] : NULL, &given, number);
  mimo_no_more(&given, "a scene");
  mimo_keep_scene(number, scene);
  out[0] = mxCreateDoubleScalar(number);
}

/* text = scene_xml(scene) */
static void scene_xml(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  size_t length = 0;
  mimo_scene* scene;
  char* text;
  (void)nout;
  mimo_need(nin == 1, "expected a scene");
  scene = mimo_scene_of(in[0]);
  mimo_check(mimo_scene_xml(scene, NULL, 0, &length));
  text = mxCalloc(length + 1, 1);
  mimo_check(mimo_scene_xml(scene, text, length + 1, NULL));
  out[0] = mxCreateString(text);
}

/* scene_save(scene, folder) */
static void scene_save(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)out;
  mimo_need(nin == 2, "expected a scene and a folder");
  mimo_check(mimo_scene_save(mimo_scene_of(in[0]), mimo_text(in[1], "folder")));
}

/* Adds each element of a struct array. */
static void add_each(mimo_scene* scene, properties* given, const char* name, adder add) {
  const mxArray* all = mimo_take(given, name);
  size_t i;
  if (all == NULL) return;
  if (!mxIsStruct(all)) mimo_refuse("%s: expected a struct array", name);
  for (i = 0; i < mxGetNumberOfElements(all); ++i) {
    properties one = mimo_members(all, i);
    add(scene, &one);
  }
}

/* {'reach/success_reward', 5; ...} */
static void add_parameters(mimo_scene* scene, properties* given) {
  const mxArray* pairs = mimo_take(given, "parameters");
  size_t count, i;
  if (pairs == NULL) return;
  if (!mxIsCell(pairs) || mxGetN(pairs) != 2)
    mimo_refuse("parameters: expected a cell array of names and values, two columns");
  count = mxGetM(pairs);
  for (i = 0; i < count; ++i)
    mimo_check(mimo_scene_set_parameter(scene, mimo_text(mxGetCell(pairs, i), "parameters"),
                                        mimo_number(mxGetCell(pairs, count + i), "parameters")));
}

/* A scene with its own infants, which share the options. */
static mimo_scene* furnished_scene(const mxArray* name, properties* given, double number, mimo_growth* growth) {
  mimo_scene* scene = open_scene(name, given, number);
  const mimo_agent_config agent = take_agent_config(scene, given, growth);
  add_parameters(scene, given);
  mimo_check(mimo_scene_add_agents(scene, &agent, NULL));
  add_each(scene, given, "limits", add_limits);
  add_each(scene, given, "motor_limits", add_motor_limits);
  add_each(scene, given, "objects", add_object);
  add_each(scene, given, "models", add_model);
  add_each(scene, given, "cameras", add_camera);
  add_each(scene, given, "fields", add_field);
  return scene;
}

static mimo_env_config take_env_config(properties* given, double number) {
  mimo_env_config config;
  mimo_check(mimo_env_config_init(&config, sizeof config));
  config.log = mimo_keep_message;
  config.log_user = mimo_teller(number);
  mimo_set_known(&config, mimo_env_options, given);
  return config;
}

mimo_batch* mimo_create_batch(int nin, const mxArray* in[], double number, mimo_batch_config* config,
                              mimo_growth* usual) {
  mimo_env_config env;
  const mxArray* ages;
  mimo_batch* batch = NULL;
  mimo_scene* scene;
  properties given;
  mimo_need(nin % 2 == 1, "expected a scene, then names and values of options");
  given = mimo_pairs(nin - 1, in + 1);
  env = take_env_config(&given, number);
  mimo_check(mimo_batch_config_init(config, sizeof *config));
  mimo_set_known(config, mimo_batch_options, &given);
  mimo_check(mimo_growth_init(usual, sizeof *usual));
  ages = mimo_take(&given, "ages");
  scene = mxIsChar(in[0]) ? furnished_scene(in[0], &given, number, usual) : mimo_scene_of(in[0]);
  if (ages != NULL) config->cohort = mimo_ages(ages, usual, &config->cohort_count);
  mimo_no_more(&given,
               mxIsChar(in[0]) ? "mimo_create; see its help" : "mimo_create for a scene's number; see mimo_scene_add");
  mimo_check(mimo_batch_create(scene, &env, config, &batch));
  mimo_making(NULL);
  return batch;
}

const mimo_command mimo_scene_commands[] = {
    {"scene", new_scene}, {"scene_add", scene_add}, {"scene_xml", scene_xml}, {"scene_save", scene_save}, {NULL, NULL}};
