/* What is to be known of worlds (what they are, times, failures, messages) and of the library (versions, names,
 * parameters). */
#include "mimo_report.h"

#include <string.h>

#include "mimo_messages.h"

static mxArray* agents_of(const worlds* all) {
  static const char* members[] = {"name", "mass", "height"};
  mxArray* agents = mxCreateStructMatrix(all->sizes.agents, 1, 3, members);
  size_t i;
  for (i = 0; i < all->sizes.agents; ++i) {
    mimo_agent_info one = {0};
    one.struct_size = sizeof one;
    mimo_check(mimo_env_agent(all->first, i, &one));
    mxSetFieldByNumber(agents, i, 0, mxCreateString(one.name));
    mxSetFieldByNumber(agents, i, 1, mxCreateDoubleScalar(one.mass));
    mxSetFieldByNumber(agents, i, 2, mxCreateDoubleScalar(one.height));
  }
  return agents;
}

/* struct = info(number) */
static void info(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const char* task = NULL;
  uint32_t frame_skip = 0;
  size_t threads = 0;
  double step = 0;
  worlds* all;
  (void)nout;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  mimo_check(mimo_env_task(all->first, &task));
  mimo_check(mimo_env_frame_skip(all->first, &frame_skip));
  mimo_check(mimo_env_timestep(all->first, &step));
  mimo_check(mimo_batch_size(all->batch, NULL, &threads));
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  mimo_add_text(out[0], "task", task);
  mimo_add_number(out[0], "timestep", step);
  mimo_add_number(out[0], "frame_skip", frame_skip);
  mimo_add_number(out[0], "worlds", (double)all->count);
  mimo_add_number(out[0], "threads", (double)threads);
  mimo_add(out[0], "agents", agents_of(all));
}

/* A row of a struct, a number for each world. */
static double* new_row(mxArray* to, const char* name, size_t worlds) {
  mxArray* row = mxCreateDoubleMatrix(1, worlds, mxREAL);
  mxSetFieldByNumber(to, 0, mxAddField(to, name), row);
  return mxGetPr(row);
}

/* struct = timing(number), or timing(number, 'reset') to count anew */
static void timing(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  static const char* names[] = {"steps",  "total",          "physics",    "touch",
                                "vision", "proprioception", "vestibular", "hearing"};
  double* rows[8];
  worlds* all;
  size_t world, i;
  (void)nout;
  mimo_need(nin == 1 || (nin == 2 && strcmp(mimo_text(in[1], "what"), "reset") == 0), "expected a world, and 'reset'");
  all = mimo_worlds_of(in[0]);
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  for (i = 0; i < 8; ++i) rows[i] = new_row(out[0], names[i], all->count);
  for (world = 0; world < all->count; ++world) {
    mimo_timing spent = {0};
    mimo_env* env = NULL;
    spent.struct_size = sizeof spent;
    mimo_check(mimo_batch_world(all->batch, world, &env));
    mimo_check(mimo_env_timing(env, &spent));
    rows[0][world] = (double)spent.steps;
    rows[1][world] = spent.total;
    rows[2][world] = spent.physics;
    rows[3][world] = spent.touch;
    rows[4][world] = spent.vision;
    rows[5][world] = spent.proprioception;
    rows[6][world] = spent.vestibular;
    rows[7][world] = spent.hearing;
    if (nin == 2) mimo_check(mimo_env_timing_reset(env));
  }
}

/* [messages, statuses] = failures(number): what became of each world in the last call; '' and 'OK' where all is well */
static void failures(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  mxArray* statuses;
  size_t i;
  mimo_need(nin == 1, "expected a world");
  all = mimo_worlds_of(in[0]);
  out[0] = mxCreateCellMatrix(1, all->count);
  statuses = mxCreateCellMatrix(1, all->count);
  for (i = 0; i < all->count; ++i) {
    mimo_status status = MIMO_OK;
    const char* message = NULL;
    mimo_check(mimo_batch_world_error(all->batch, i, &status, &message));
    mxSetCell(out[0], i, mxCreateString(mimo_counted(message)));
    mxSetCell(statuses, i, mxCreateString(mimo_status_word(status)));
  }
  if (nout > 1) out[1] = statuses;
}

/* structs = messages(): what was said since somebody asked last */
static void messages(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)in;
  mimo_need(nin == 0, "expected nothing");
  out[0] = mimo_take_messages();
}

/* struct = version() */
static void version(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)in;
  mimo_need(nin == 0, "expected nothing");
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  mimo_add_text(out[0], "library", mimo_version());
  mimo_add_text(out[0], "mujoco", mimo_mujoco_version());
  mimo_add_number(out[0], "api", mimo_api_version());
  mimo_add_number(out[0], "abi", mimo_abi_version());
}

/* known = supports(name) */
static void supports(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  mimo_need(nin == 1, "expected a name");
  out[0] = mxCreateLogicalScalar(mimo_supports(mimo_text(in[0], "name")) != 0);
}

/* names = known(kind): a cell column */
static void known(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  static const struct list {
    const char* kind;
    const char* (*name)(size_t);
  } lists[] = {{"scene", mimo_scene_name},
               {"room", mimo_room_name},
               {"task", mimo_task_name},
               {"face", mimo_face_name},
               {"material", mimo_material_name}};
  const char* kind;
  const size_t kinds = sizeof lists / sizeof *lists;
  size_t list, count = 0, i;
  (void)nout;
  mimo_need(nin == 1, "expected a kind");
  kind = mimo_text(in[0], "kind");
  for (list = 0; list < kinds && strcmp(lists[list].kind, kind) != 0; ++list) continue;
  if (list == kinds)
    mimo_refuse("kind is \"%s\", expected scene, room, task, face or material; or a world before it", kind);
  while (lists[list].name(count) != NULL) ++count;
  out[0] = mxCreateCellMatrix(count, 1);
  for (i = 0; i < count; ++i) mxSetCell(out[0], i, mxCreateString(lists[list].name(i)));
}

/* structs = parameters(), or parameters(scene) with the values that they have there */
static void parameters(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  static const char* members[] = {"name", "description", "standard", "low", "high", "value"};
  mimo_scene* scene;
  size_t count = 0, i;
  (void)nout;
  mimo_need(nin <= 1, "expected nothing, or a scene");
  scene = nin == 1 ? mimo_scene_of(in[0]) : NULL;
  mimo_check(mimo_parameter_count(&count));
  out[0] = mxCreateStructMatrix(count, 1, scene != NULL ? 6 : 5, members);
  for (i = 0; i < count; ++i) {
    mimo_parameter one = {0};
    double value = 0;
    one.struct_size = sizeof one;
    mimo_check(mimo_parameter_describe(i, &one));
    mxSetFieldByNumber(out[0], i, 0, mxCreateString(one.name));
    mxSetFieldByNumber(out[0], i, 1, mxCreateString(one.description));
    mxSetFieldByNumber(out[0], i, 2, mxCreateDoubleScalar(one.standard));
    mxSetFieldByNumber(out[0], i, 3, mxCreateDoubleScalar(one.low));
    mxSetFieldByNumber(out[0], i, 4, mxCreateDoubleScalar(one.high));
    if (scene == NULL) continue;
    mimo_check(mimo_scene_get_parameter(scene, one.name, &value));
    mxSetFieldByNumber(out[0], i, 5, mxCreateDoubleScalar(value));
  }
}

/* struct = maturity(age) */
static void maturity(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_maturity at;
  (void)nout;
  mimo_need(nin == 1, "expected an age");
  mimo_check(mimo_maturity_at(mimo_number(in[0], "age"), &at, sizeof at));
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  mimo_add_number(out[0], "acuity", at.acuity);
  mimo_add_number(out[0], "peak_contrast", at.peak_contrast);
  mimo_add_number(out[0], "chroma", at.chroma);
  mimo_add_number(out[0], "flicker", at.flicker);
  mimo_add_number(out[0], "contrast_threshold", at.contrast_threshold);
  mimo_add_number(out[0], "conduction_speed", at.conduction_speed);
  mimo_add_number(out[0], "sensory_delay", at.sensory_delay);
  mimo_add_number(out[0], "motor_delay", at.motor_delay);
  mimo_add_number(out[0], "vision_delay", at.vision_delay);
  mimo_add_number(out[0], "vestibular_delay", at.vestibular_delay);
  mimo_add_number(out[0], "hearing_delay", at.hearing_delay);
}

const mimo_command mimo_report_commands[] = {{"info", info},         {"timing", timing},
                                             {"failures", failures}, {"messages", messages},
                                             {"version", version},   {"supports", supports},
                                             {"known", known},       {"parameters", parameters},
                                             {"maturity", maturity}, {NULL, NULL}};
