/* Commands that describe worlds (info, timing, failures, messages) and the library (versions, names, parameters). */
#include "mimo_report.h"

#include <string.h>

#include "mimo_arrays.h"
#include "mimo_messages.h"

static mxArray* agents_of(const worlds* all) {
  mxArray* agents = mimo_structs(all->sizes.agents, mimo_agent_members);
  size_t i;
  for (i = 0; i < all->sizes.agents; ++i) {
    mimo_agent_info one = {0};
    one.struct_size = sizeof one;
    mimo_check(mimo_env_agent(all->first, i, &one));
    mimo_fill(agents, i, &one, mimo_agent_members);
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

/* struct = timing(number), or timing(number, 'reset') to start counting again */
static void timing(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const member* one;
  worlds* all;
  size_t world;
  (void)nout;
  mimo_need(nin == 1 || (nin == 2 && strcmp(mimo_text(in[1], "what"), "reset") == 0), "expected a world, and 'reset'");
  all = mimo_worlds_of(in[0]);
  out[0] = mimo_structs(1, mimo_timing_members);
  for (one = mimo_timing_members; one->name != NULL; ++one)
    mxSetField(out[0], 0, one->name, mxCreateDoubleMatrix(1, all->count, mxREAL));
  for (world = 0; world < all->count; ++world) {
    mimo_timing spent = {0};
    mimo_env* env = NULL;
    mxArray* its;
    spent.struct_size = sizeof spent;
    mimo_check(mimo_batch_world(all->batch, world, &env));
    mimo_check(mimo_env_timing(env, &spent));
    its = mimo_struct(&spent, mimo_timing_members);
    for (one = mimo_timing_members; one->name != NULL; ++one)
      mxGetPr(mxGetField(out[0], 0, one->name))[world] = mxGetScalar(mxGetField(its, 0, one->name));
    if (nin == 2) mimo_check(mimo_env_timing_reset(env));
  }
}

/* [messages, statuses] = failures(number): the result of each world's last call; '' and 'OK' without an error */
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

/* structs = messages(): the messages since the last call */
static void messages(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)in;
  mimo_need(nin == 0, "expected no arguments");
  out[0] = mimo_take_messages();
}

/* struct = version() */
static void version(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  (void)nout;
  (void)in;
  mimo_need(nin == 0, "expected no arguments");
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
    mimo_refuse(
        "kind is \"%s\", expected scene, room, task, face or material; other kinds need a world before the kind", kind);
  while (lists[list].name(count) != NULL) ++count;
  out[0] = mxCreateCellMatrix(count, 1);
  for (i = 0; i < count; ++i) mxSetCell(out[0], i, mxCreateString(lists[list].name(i)));
}

/* structs = parameters(), or parameters(scene) with their values in the scene */
static void parameters(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_scene* scene;
  size_t count = 0, i;
  (void)nout;
  mimo_need(nin <= 1, "expected no arguments, or a scene");
  scene = nin == 1 ? mimo_scene_of(in[0]) : NULL;
  mimo_check(mimo_parameter_count(&count));
  out[0] = mimo_structs(count, mimo_parameter_members);
  if (scene != NULL) mxAddField(out[0], "value");
  for (i = 0; i < count; ++i) {
    mimo_parameter one = {0};
    double value = 0;
    one.struct_size = sizeof one;
    mimo_check(mimo_parameter_describe(i, &one));
    mimo_fill(out[0], i, &one, mimo_parameter_members);
    if (scene == NULL) continue;
    mimo_check(mimo_scene_get_parameter(scene, one.name, &value));
    mxSetField(out[0], i, "value", mxCreateDoubleScalar(value));
  }
}

/* struct = behaviour(scene) */
static void behaviour(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_behaviour told = {0};
  (void)nout;
  mimo_need(nin == 1, "expected a scene");
  told.struct_size = sizeof told;
  mimo_check(mimo_scene_behaviour(mimo_scene_of(in[0]), &told));
  out[0] = mimo_struct(&told, mimo_behaviour_members);
}

/* struct = maturity(age) */
static void maturity(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_maturity at;
  (void)nout;
  mimo_need(nin == 1, "expected an age");
  mimo_check(mimo_maturity_at(mimo_number(in[0], "age"), &at, sizeof at));
  out[0] = mimo_struct(&at, mimo_maturity_options);
}

const mimo_command mimo_report_commands[] = {{"info", info},
                                             {"timing", timing},
                                             {"failures", failures},
                                             {"messages", messages},
                                             {"version", version},
                                             {"supports", supports},
                                             {"known", known},
                                             {"parameters", parameters},
                                             {"maturity", maturity},
                                             {"behaviour", behaviour},
                                             {NULL, NULL}};
