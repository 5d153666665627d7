/* Commands beside stepping: names, states, faces, gaze, locks, gravity, pictures. */
#include "mimo_access.h"

#include <math.h>
#include <string.h>

typedef struct quantity {
  const char* name;
  int32_t kind, number;
} quantity;

#define QUANTITY(kind, what, name) \
  { name, MIMO_##kind, MIMO_##kind##_##what }
static const quantity quantities[] = {
    QUANTITY(JOINT, POSITION, "joint_position"),
    QUANTITY(JOINT, VELOCITY, "joint_velocity"),
    QUANTITY(JOINT, FORCE, "joint_force"),
    QUANTITY(JOINT, ACCELERATION, "joint_acceleration"),
    QUANTITY(JOINT, RANGE, "joint_range"),
    QUANTITY(BODY, POSITION, "body_position"),
    QUANTITY(BODY, ORIENTATION, "body_orientation"),
    QUANTITY(BODY, VELOCITY, "body_velocity"),
    QUANTITY(BODY, FORCE, "body_force"),
    QUANTITY(BODY, MASS, "body_mass"),
    QUANTITY(BODY, CENTER_OF_MASS, "body_center_of_mass"),
    QUANTITY(GEOM, POSITION, "geom_position"),
    QUANTITY(GEOM, ORIENTATION, "geom_orientation"),
    QUANTITY(GEOM, SIZE, "geom_size"),
    QUANTITY(SITE, POSITION, "site_position"),
    QUANTITY(SITE, ORIENTATION, "site_orientation"),
    QUANTITY(CAMERA, POSITION, "camera_position"),
    QUANTITY(CAMERA, ORIENTATION, "camera_orientation"),
    QUANTITY(ACTUATOR, CONTROL, "actuator_control"),
    QUANTITY(ACTUATOR, FORCE, "actuator_force"),
    QUANTITY(ACTUATOR, GEAR, "actuator_gear"),
    QUANTITY(SENSOR, VALUE, "sensor_value"),
};

static const quantity* read_quantity(const mxArray* name) {
  const char* text = mimo_text(name, "quantity");
  size_t i;
  for (i = 0; i < sizeof quantities / sizeof *quantities; ++i)
    if (strcmp(text, quantities[i].name) == 0) return &quantities[i];
  mexErrMsgIdAndTxt("mimo:NOT_FOUND", "no quantity %s; see help mimo_get", text);
  return NULL;
}

/* What is read or written: a quantity of things that are named, one or a cell array of them. */
typedef struct selection {
  worlds* all;
  int32_t quantity, *ids;
  size_t count, width; /* values of one world */
} selection;

static int32_t find(worlds* all, int32_t kind, const mxArray* name) {
  int32_t id = 0;
  mimo_check(mimo_env_find(all->first, kind, mimo_text(name, "name"), &id));
  return id;
}

static selection select_by_name(const mxArray* in[]) {
  const quantity* quantity = read_quantity(in[1]);
  const int many = mxIsCell(in[2]);
  selection chosen;
  size_t i;
  chosen.all = mimo_worlds_of(in[0]);
  chosen.quantity = quantity->number;
  chosen.count = many ? mxGetNumberOfElements(in[2]) : 1;
  chosen.ids = mxCalloc(chosen.count + 1, sizeof *chosen.ids);
  for (i = 0; i < chosen.count; ++i)
    chosen.ids[i] = find(chosen.all, quantity->kind, many ? mxGetCell(in[2], i) : in[2]);
  mimo_check(mimo_env_width(chosen.all->first, chosen.quantity, chosen.ids, chosen.count, &chosen.width));
  return chosen;
}

/* values = get(number, quantity, names): values x worlds */
static void get(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  selection chosen;
  mxArray* values;
  (void)nout;
  mimo_need(nin == 3, "expected a world, a quantity and names");
  chosen = select_by_name(in);
  values = mxCreateDoubleMatrix(chosen.width, chosen.all->count, mxREAL);
  mimo_check(mimo_batch_get(chosen.all->batch, chosen.quantity, chosen.ids, chosen.count, NULL, 0, mxGetPr(values),
                            mxGetNumberOfElements(values)));
  out[0] = values;
}

/* set(number, quantity, names, values): values x worlds, or the same for all worlds */
static void set(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  selection chosen;
  double* values;
  size_t world, given;
  (void)nout;
  (void)out;
  mimo_need(nin == 4 && mxIsDouble(in[3]) && !mxIsComplex(in[3]),
            "expected a world, a quantity, names and real values");
  chosen = select_by_name(in);
  given = mxGetNumberOfElements(in[3]);
  values = mxGetPr(in[3]);
  if (chosen.all->count > 1 && given == chosen.width) {
    values = mxCalloc(chosen.all->count * given + 1, sizeof *values);
    for (world = 0; world < chosen.all->count; ++world)
      memcpy(values + world * given, mxGetPr(in[3]), given * sizeof *values);
    given *= chosen.all->count;
  }
  mimo_check(mimo_batch_set(chosen.all->batch, chosen.quantity, chosen.ids, chosen.count, NULL, 0, values, given));
}

static int32_t read_kind(const mxArray* kind) {
  static const char* kinds[] = {"body", "joint", "geom", "site", "camera", "actuator", "sensor"}; /* MIMO_BODY is 1 */
  const char* asked = mimo_text(kind, "kind");
  int32_t i = 0;
  while (i < 7 && strcmp(kinds[i], asked) != 0) ++i;
  if (i == 7) mimo_refuse("kind is \"%s\", expected body, joint, geom, site, camera, actuator or sensor", asked);
  return i + 1;
}

static mxArray* name_of(worlds* all, int32_t kind, int32_t id) {
  const char* name = NULL;
  mimo_check(mimo_env_name(all->first, kind, id, &name));
  return mxCreateString(name);
}

/* names = names(number, kind): a cell array; "" where the model gives none */
static void names(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t count = 0, i;
  int32_t kind;
  (void)nout;
  mimo_need(nin == 2, "expected a world and a kind");
  all = mimo_worlds_of(in[0]);
  kind = read_kind(in[1]);
  mimo_check(mimo_env_count(all->first, kind, &count));
  out[0] = mxCreateCellMatrix(count, 1);
  for (i = 0; i < count; ++i) mxSetCell(out[0], i, name_of(all, kind, (int32_t)i));
}

/* body = body_of(number, kind, name) */
static void body_of(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  int32_t kind, body = 0;
  (void)nout;
  mimo_need(nin == 3, "expected a world, a kind and a name");
  all = mimo_worlds_of(in[0]);
  kind = read_kind(in[1]);
  mimo_check(mimo_env_body_of(all->first, kind, find(all, kind, in[2]), &body));
  out[0] = name_of(all, MIMO_BODY, body);
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

/* seconds = time(number): a column a world */
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

/* states = save(number): uint8, a column a world */
static void save(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t bytes = 0;
  (void)nout;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  mimo_check(mimo_env_state_size(all->first, &bytes));
  out[0] = mxCreateNumericMatrix(bytes, all->count, mxUINT8_CLASS, mxREAL);
  mimo_check(mimo_batch_state_save(all->batch, NULL, 0, mxGetData(out[0]), bytes * all->count));
}

/* fresh = load(number, states): a column a world, or one for all; gives names of what started fresh */
static void load(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_load_report report;
  (void)nout;
  mimo_need(nin == 2 && mxIsUint8(in[1]), "expected a world and bytes that mimo_save gave");
  report.struct_size = sizeof report;
  mimo_check(mimo_batch_state_load(mimo_worlds_of(in[0])->batch, NULL, 0, mxGetData(in[1]),
                                   mxGetNumberOfElements(in[1]), &report));
  out[0] = mxCreateString(report.fresh_names);
}

/* name = face(number), or face(number, name): of the first agent, in all worlds */
static void face(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const char* name = NULL;
  worlds* all;
  (void)nout;
  mimo_need(nin == 1 || nin == 2, "expected a world, and the name of a face");
  all = mimo_worlds_of(in[0]);
  if (nin == 2) mimo_check(mimo_batch_set_face(all->batch, 0, mimo_text(in[1], "face"), NULL, 0));
  mimo_check(mimo_env_face(all->first, 0, &name));
  out[0] = mxCreateString(name);
}

/* struct = gaze(number, index, agent) */
static void gaze(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  mimo_gaze now;
  (void)nout;
  mimo_need(nin >= 1 && nin <= 3, "expected a world, its index, and an agent");
  all = mimo_worlds_of(in[0]);
  memset(&now, 0, sizeof now);
  now.struct_size = sizeof now;
  mimo_check(mimo_env_gaze(mimo_world_at(all, nin, in, 1), mimo_agent_at(all, nin, in, 2), &now));
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  mimo_add_numbers(out[0], "left_position", now.left_position, 3, 1);
  mimo_add_numbers(out[0], "left_direction", now.left_direction, 3, 1);
  mimo_add_numbers(out[0], "right_position", now.right_position, 3, 1);
  mimo_add_numbers(out[0], "right_direction", now.right_direction, 3, 1);
  mimo_add_numbers(out[0], "vergence", &now.vergence, 1, 1);
  mimo_add_numbers(out[0], "point", now.point, now.meets ? 3 : 0, 1);
  mimo_add_numbers(out[0], "miss", &now.miss, 1, 1);
}

/* Whose eyes are to look, at what, and how: (number, point, 'eyes' or 'head', index, agent). */
typedef struct look {
  mimo_env* env;
  size_t agent;
  const double* point;
  int32_t how;
} look;

static look read_look(int nin, const mxArray* in[]) {
  worlds* all;
  const char* how;
  look wanted;
  mimo_need(nin >= 3 && mxIsDouble(in[1]) && mxGetNumberOfElements(in[1]) == 3,
            "expected a world, a point of three numbers, and 'eyes' or 'head'");
  all = mimo_worlds_of(in[0]);
  how = mimo_text(in[2], "how");
  wanted.how = strcmp(how, "head") == 0 ? MIMO_LOOK_HEAD : MIMO_LOOK_EYES;
  mimo_need(wanted.how == MIMO_LOOK_HEAD || strcmp(how, "eyes") == 0, "what turns is 'eyes' or 'head'");
  wanted.env = mimo_world_at(all, nin, in, 3);
  wanted.agent = mimo_agent_at(all, nin, in, 4);
  wanted.point = mxGetPr(in[1]);
  return wanted;
}

/* errors = look_at(number, point, how, index, agent) */
static void look_at(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const look wanted = read_look(nin, in);
  (void)nout;
  out[0] = mxCreateDoubleMatrix(2, 1, mxREAL);
  mimo_check(mimo_env_look_at(wanted.env, wanted.agent, wanted.point, wanted.how, mxGetPr(out[0])));
}

/* [joints, angles, errors] = look_angles(number, point, how, index, agent) */
static void look_angles(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const look wanted = read_look(nin, in);
  worlds* all = mimo_worlds_of(in[0]);
  mxArray *angles, *errors = mxCreateDoubleMatrix(2, 1, mxREAL);
  size_t count = 0, i;
  int32_t* joints;
  mimo_check(mimo_env_look_angles(wanted.env, wanted.agent, wanted.point, wanted.how, NULL, NULL, 0, &count, NULL));
  joints = mxCalloc(count + 1, sizeof *joints);
  angles = mxCreateDoubleMatrix(count, 1, mxREAL);
  mimo_check(mimo_env_look_angles(wanted.env, wanted.agent, wanted.point, wanted.how, joints, mxGetPr(angles), count,
                                  &count, mxGetPr(errors)));
  out[0] = mxCreateCellMatrix(count, 1);
  for (i = 0; i < count; ++i) mxSetCell(out[0], i, name_of(all, MIMO_JOINT, joints[i]));
  if (nout > 1) out[1] = angles;
  if (nout > 2) out[2] = errors;
}

/* lock(number, joint, angle or []): in all worlds; [] lets it go */
static void lock(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  int32_t joint;
  size_t i;
  (void)nout;
  (void)out;
  mimo_need(nin == 3, "expected a world, a joint, and an angle or []");
  all = mimo_worlds_of(in[0]);
  joint = find(all, MIMO_JOINT, in[1]);
  for (i = 0; i < all->count; ++i) {
    mimo_env* env = NULL;
    mimo_check(mimo_batch_world(all->batch, i, &env));
    mimo_check(mxIsEmpty(in[2]) ? mimo_env_unlock(env, joint) : mimo_env_lock(env, joint, mimo_number(in[2], "angle")));
  }
}

/* angle = locked(number, joint): of the first world; [] if it is not held */
static void locked(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  uint8_t held = 0;
  double angle = 0;
  (void)nout;
  mimo_need(nin == 2, "expected a world and a joint");
  all = mimo_worlds_of(in[0]);
  mimo_check(mimo_env_lock_state(all->first, find(all, MIMO_JOINT, in[1]), &held, &angle));
  out[0] = held ? mxCreateDoubleScalar(angle) : mxCreateDoubleMatrix(0, 0, mxREAL);
}

/* gravity = gravity(number), or gravity(number, xyz): in all worlds */
static void gravity(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  size_t i;
  (void)nout;
  mimo_need(nin == 1 || (nin == 2 && mxIsDouble(in[1]) && mxGetNumberOfElements(in[1]) == 3),
            "expected a world, and three numbers");
  all = mimo_worlds_of(in[0]);
  for (i = 0; nin == 2 && i < all->count; ++i) {
    const double* xyz = mxGetPr(in[1]);
    mimo_env* env = NULL;
    mimo_check(mimo_batch_world(all->batch, i, &env));
    mimo_check(mimo_env_set_gravity(env, xyz[0], xyz[1], xyz[2]));
  }
  out[0] = mxCreateDoubleMatrix(3, 1, mxREAL);
  mimo_check(mimo_env_gravity(all->first, mxGetPr(out[0]), 3));
}

/* Checked before there is memory for so many pixels. */
static uint32_t read_size(const mxArray* number, const char* what) {
  const double pixels = mimo_number(number, what);
  mimo_need(pixels >= 1 && pixels <= 4096 && pixels == floor(pixels),
            "a picture has 1 to 4096 pixels in height and width");
  return (uint32_t)pixels;
}

/* rgb = picture(number, height, width, camera or '', index): height x width x 3, uint8 */
static void picture(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_picture_config config;
  mwSize shape[3] = {0, 0, 3};
  const char* camera;
  uint8_t* rgb;
  mwSize row, column, color;
  (void)nout;
  mimo_need(nin >= 4, "expected a world, height, width, and a camera or ''");
  mimo_check(mimo_picture_config_init(&config, sizeof config));
  config.height = read_size(in[1], "height");
  config.width = read_size(in[2], "width");
  shape[0] = (mwSize)config.height;
  shape[1] = (mwSize)config.width;
  camera = mimo_text(in[3], "camera");
  if (camera[0] != '\0') config.camera = camera;
  rgb = mxCalloc(3 * shape[0] * shape[1], 1);
  mimo_check(mimo_env_render(mimo_world_at(mimo_worlds_of(in[0]), nin, in, 4), &config, rgb, 3 * shape[0] * shape[1],
                             NULL, 0, NULL, 0));
  out[0] = mxCreateNumericArray(3, shape, mxUINT8_CLASS, mxREAL);
  for (row = 0; row < shape[0]; ++row)
    for (column = 0; column < shape[1]; ++column)
      for (color = 0; color < 3; ++color)
        ((uint8_t*)mxGetData(out[0]))[(color * shape[1] + column) * shape[0] + row] =
            rgb[(row * shape[1] + column) * 3 + color];
}

/* pixels = project(number, points, height, width, camera or '', index): of 3 x n points, 3 x n */
static void project(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_picture_config config;
  const char* camera;
  (void)nout;
  mimo_need(nin >= 5 && mxIsDouble(in[1]) && !mxIsComplex(in[1]) && mxGetM(in[1]) == 3,
            "expected a world, points (three rows), height, width, and a camera or ''");
  mimo_check(mimo_picture_config_init(&config, sizeof config));
  config.height = read_size(in[2], "height");
  config.width = read_size(in[3], "width");
  camera = mimo_text(in[4], "camera");
  if (camera[0] != '\0') config.camera = camera;
  out[0] = mxCreateDoubleMatrix(3, mxGetN(in[1]), mxREAL);
  mimo_check(mimo_env_project(mimo_world_at(mimo_worlds_of(in[0]), nin, in, 5), &config, mxGetPr(in[1]), mxGetN(in[1]),
                              mxGetPr(out[0])));
}

const mimo_command mimo_access_commands[] = {{"get", get},         {"set", set},         {"names", names},
                                             {"body_of", body_of}, {"update", update},   {"time", seconds},
                                             {"save", save},       {"load", load},       {"face", face},
                                             {"gaze", gaze},       {"look_at", look_at}, {"look_angles", look_angles},
                                             {"lock", lock},       {"locked", locked},   {"gravity", gravity},
                                             {"picture", picture}, {"project", project}, {NULL, NULL}};
