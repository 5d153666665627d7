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
    QUANTITY(BODY, POSITION, "body_position"),
    QUANTITY(BODY, ORIENTATION, "body_orientation"),
    QUANTITY(BODY, VELOCITY, "body_velocity"),
    QUANTITY(BODY, FORCE, "body_force"),
    QUANTITY(BODY, MASS, "body_mass"),
    QUANTITY(BODY, CENTER_OF_MASS, "body_center_of_mass"),
    QUANTITY(BODY, POSE, "body_pose"),
    QUANTITY(JOINT, POSITION, "joint_position"),
    QUANTITY(JOINT, VELOCITY, "joint_velocity"),
    QUANTITY(JOINT, FORCE, "joint_force"),
    QUANTITY(JOINT, ACCELERATION, "joint_acceleration"),
    QUANTITY(JOINT, RANGE, "joint_range"),
    QUANTITY(JOINT, DAMPING, "joint_damping"),
    QUANTITY(JOINT, LOCK, "joint_lock"),
    QUANTITY(GEOM, POSITION, "geom_position"),
    QUANTITY(GEOM, ORIENTATION, "geom_orientation"),
    QUANTITY(GEOM, SIZE, "geom_size"),
    QUANTITY(GEOM, POSE, "geom_pose"),
    QUANTITY(GEOM, FRICTION, "geom_friction"),
    QUANTITY(GEOM, COLOR, "geom_color"),
    QUANTITY(SITE, POSITION, "site_position"),
    QUANTITY(SITE, ORIENTATION, "site_orientation"),
    QUANTITY(SITE, POSE, "site_pose"),
    QUANTITY(CAMERA, POSITION, "camera_position"),
    QUANTITY(CAMERA, ORIENTATION, "camera_orientation"),
    QUANTITY(CAMERA, POSE, "camera_pose"),
    QUANTITY(ACTUATOR, CONTROL, "actuator_control"),
    QUANTITY(ACTUATOR, FORCE, "actuator_force"),
    QUANTITY(ACTUATOR, GEAR, "actuator_gear"),
    QUANTITY(SENSOR, VALUE, "sensor_value"),
    QUANTITY(LIGHT, POSITION, "light_position"),
    QUANTITY(LIGHT, DIRECTION, "light_direction"),
    QUANTITY(LIGHT, COLOR, "light_color"),
    QUANTITY(CONTACT, GEOMS, "contact_geoms"),
    QUANTITY(CONTACT, BODIES, "contact_bodies"),
    QUANTITY(CONTACT, POSITION, "contact_position"),
    QUANTITY(CONTACT, FRAME, "contact_frame"),
    QUANTITY(CONTACT, DISTANCE, "contact_distance"),
    QUANTITY(CONTACT, FORCE, "contact_force"),
    QUANTITY(CONTACT, TORQUE, "contact_torque"),
    QUANTITY(STEP_CONTACT, GEOMS, "step_contact_geoms"),
    QUANTITY(STEP_CONTACT, BODIES, "step_contact_bodies"),
    QUANTITY(STEP_CONTACT, START, "step_contact_start"),
    QUANTITY(STEP_CONTACT, END, "step_contact_end"),
    QUANTITY(STEP_CONTACT, IMPULSE, "step_contact_impulse"),
    QUANTITY(STEP_CONTACT, PEAK_FORCE, "step_contact_peak_force"),
    QUANTITY(STEP_CONTACT, PEAK_POSITION, "step_contact_peak_position"),
    QUANTITY(AGENT, FACE, "agent_face"),
    QUANTITY(WORLD, GRAVITY, "world_gravity"),
    QUANTITY(WARNING, COUNT, "warning_count"),
};

/* By its name, which may end in "_now": then the quantity has MIMO_NOW. */
static quantity read_quantity(const mxArray* name) {
  const char* text = mimo_text(name, "quantity");
  const size_t length = strlen(text);
  const int now = length > 4 && strcmp(text + length - 4, "_now") == 0;
  const size_t rest = now ? length - 4 : length;
  quantity found = {"", 0, 0};
  size_t i;
  for (i = 0; i < sizeof quantities / sizeof *quantities; ++i) {
    found = quantities[i];
    if (strlen(found.name) != rest || strncmp(text, found.name, rest) != 0) continue;
    if (now) found.number |= MIMO_NOW;
    return found;
  }
  mexErrMsgIdAndTxt("mimo:NOT_FOUND", "no quantity %s; see help mimo_get", text);
  return found;
}

/* What is read or written: a quantity of things that are named, one or a cell array of them; or of all, with ids NULL.
 */
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

/* Without names: all. `world` tells how wide they are. */
static selection select_by_name(worlds* all, const mimo_env* world, const mxArray* name, const mxArray* names) {
  const quantity quantity = read_quantity(name);
  const int many = names != NULL && mxIsCell(names);
  selection chosen = {NULL, 0, NULL, 0, 0};
  size_t i;
  chosen.all = all;
  chosen.quantity = quantity.number;
  if (names != NULL && (many || !mxIsEmpty(names) || mxIsChar(names))) {
    chosen.count = many ? mxGetNumberOfElements(names) : 1;
    chosen.ids = mxCalloc(chosen.count + 1, sizeof *chosen.ids);
    for (i = 0; i < chosen.count; ++i)
      chosen.ids[i] = find(chosen.all, quantity.kind, many ? mxGetCell(names, i) : names);
  }
  mimo_check(mimo_env_width(world, chosen.quantity, chosen.ids, chosen.count, &chosen.width));
  return chosen;
}

/* values = get(number, quantity, names or [], index): values x worlds, or those of one world */
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
  values = mxCreateDoubleMatrix(chosen.width, nin == 4 ? 1 : all->count, mxREAL);
  if (nin == 4 || all->count == 1) {
    mimo_check(mimo_env_get(world, chosen.quantity, chosen.ids, chosen.count, mxGetPr(values), chosen.width));
  } else {
    mimo_check(mimo_batch_get(all->batch, chosen.quantity, chosen.ids, chosen.count, NULL, 0, mxGetPr(values),
                              mxGetNumberOfElements(values)));
  }
  out[0] = values;
}

/* Values of all worlds, or of one for all. */
static void set_selected(const selection* chosen, double* values, size_t given) {
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
  (void)nout;
  (void)out;
  mimo_need(nin == 4 && mxIsDouble(in[3]) && !mxIsComplex(in[3]),
            "expected a world, a quantity, names or [], and real values");
  all = mimo_worlds_of(in[0]);
  chosen = select_by_name(all, all->first, in[1], in[2]);
  set_selected(&chosen, mxGetPr(in[3]), mxGetNumberOfElements(in[3]));
}

/* The same value for one element in all worlds. */
static void set_one(worlds* all, int32_t quantity, int32_t id, double* values, size_t width) {
  selection chosen = {NULL, 0, NULL, 1, 0};
  chosen.all = all;
  chosen.quantity = quantity;
  chosen.ids = &id;
  chosen.width = width;
  set_selected(&chosen, values, width);
}

static int32_t read_kind(const mxArray* kind) {
  static const char* kinds[] = {"body",    "joint",        "geom",  "site", "camera", "actuator", "sensor", "light",
                                "contact", "step_contact", "agent", "face", "world",  "warning"}; /* MIMO_BODY is 1 */
  const int32_t most = sizeof kinds / sizeof *kinds;
  const char* asked = mimo_text(kind, "kind");
  int32_t i = 0;
  while (i < most && strcmp(kinds[i], asked) != 0) ++i;
  if (i == most) mimo_refuse("kind is \"%s\", expected body, joint, geom, ...; see help mimo_names", asked);
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
  const int32_t agent = 0;
  const char* name = "";
  double shown = -1;
  worlds* all;
  (void)nout;
  mimo_need(nin == 1 || nin == 2, "expected a world, and the name of a face");
  all = mimo_worlds_of(in[0]);
  if (nin == 2) {
    shown = find(all, MIMO_FACE, in[1]);
    set_one(all, MIMO_AGENT_FACE, 0, &shown, 1);
  }
  mimo_check(mimo_env_get(all->first, MIMO_AGENT_FACE, &agent, 1, &shown, 1));
  if (shown >= 0) mimo_check(mimo_env_name(all->first, MIMO_FACE, (int32_t)shown, &name));
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
  double values[2] = {0, 0};
  (void)nout;
  (void)out;
  mimo_need(nin == 3, "expected a world, a joint, and an angle or []");
  all = mimo_worlds_of(in[0]);
  joint = find(all, MIMO_JOINT, in[1]);
  if (mxIsEmpty(in[2])) {
    mimo_check(mimo_env_get(all->first, MIMO_JOINT_LOCK, &joint, 1, values, 2));
    values[0] = 0;
  } else {
    values[0] = 1;
    values[1] = mimo_number(in[2], "angle");
  }
  set_one(all, MIMO_JOINT_LOCK, joint, values, 2);
}

/* angle = locked(number, joint): of the first world; [] if it is not held */
static void locked(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  int32_t joint;
  double lock[2];
  (void)nout;
  mimo_need(nin == 2, "expected a world and a joint");
  all = mimo_worlds_of(in[0]);
  joint = find(all, MIMO_JOINT, in[1]);
  mimo_check(mimo_env_get(all->first, MIMO_JOINT_LOCK, &joint, 1, lock, 2));
  out[0] = lock[0] != 0 ? mxCreateDoubleScalar(lock[1]) : mxCreateDoubleMatrix(0, 0, mxREAL);
}

/* gravity = gravity(number), or gravity(number, xyz): in all worlds */
static void gravity(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  (void)nout;
  mimo_need(nin == 1 || (nin == 2 && mxIsDouble(in[1]) && mxGetNumberOfElements(in[1]) == 3),
            "expected a world, and three numbers");
  all = mimo_worlds_of(in[0]);
  if (nin == 2) set_one(all, MIMO_WORLD_GRAVITY, 0, mxGetPr(in[1]), 3);
  out[0] = mxCreateDoubleMatrix(3, 1, mxREAL);
  mimo_check(mimo_env_get(all->first, MIMO_WORLD_GRAVITY, NULL, 0, mxGetPr(out[0]), 3));
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
