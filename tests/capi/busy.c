/* Two threads on one handle: one works, the other gets MIMO_E_BUSY. Neither call is disturbed.
 */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <time.h>

#include "support/capi.h"

enum { TRIES = 100000, STEPS = 60, MOST = 400 };

static void sleep_ms(long ms) {
  const struct timespec time = {0, ms * 1000000};
  nanosleep(&time, NULL);
}

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static void set(int* flag, int value) {
  pthread_mutex_lock(&lock);
  *flag = value;
  pthread_mutex_unlock(&lock);
}

static int get(const int* flag) {
  int value;
  pthread_mutex_lock(&lock);
  value = *flag;
  pthread_mutex_unlock(&lock);
  return value;
}

static void await(const int* flag) {
  while (!get(flag)) sleep_ms(1);
}

/* ---- Hammering: whichever calls of two threads come through, they come through whole. */

typedef struct hammer {
  mimo_env* env;
  int* met; /* whether a call was told that the other thread is at work */
  int done, busy, other;
} hammer;

/* Steps until both threads have met, however late the system starts one of them. */
static void* step_often(void* argument) {
  hammer* it = argument;
  int i;
  for (i = 0; i < TRIES && (it->done < STEPS || !get(it->met)); ++i) {
    const mimo_status status = mimo_env_step(it->env, NULL, 0, NULL, 0, NULL);
    it->done += status == MIMO_OK;
    it->busy += status == MIMO_E_BUSY;
    it->other += status != MIMO_OK && status != MIMO_E_BUSY;
    if (status == MIMO_E_BUSY && strstr(mimo_last_error(), "env is in use by another thread") == NULL) ++it->other;
    if (status == MIMO_E_BUSY) {
      set(it->met, 1);
      sleep_ms(1);
    }
  }
  return NULL;
}

static void check_that_refused_calls_change_nothing(void) {
  static double state[MOST], expected[MOST];
  mimo_env *env = blind_env("free", NULL), *alone = blind_env("free", NULL);
  int met = 0;
  hammer one = {env, &met, 0, 0, 0}, two = {env, &met, 0, 0, 0};
  pthread_t thread;
  size_t count = 0;
  double time = 0, expected_time = 0;
  int i;
  CHECK(pthread_create(&thread, NULL, step_often, &one) == 0);
  step_often(&two);
  pthread_join(thread, NULL);
  CHECK(one.other == 0 && two.other == 0);
  CHECK(one.busy + two.busy > 0);
  for (i = 0; i < one.done + two.done; ++i) CHECK_OK(mimo_env_step(alone, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_env_time(env, &time));
  CHECK_OK(mimo_env_time(alone, &expected_time));
  CHECK(time == expected_time);
  CHECK_OK(mimo_env_width(env, MIMO_JOINT_POSITION, NULL, 0, &count));
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, NULL, 0, state, count));
  CHECK_OK(mimo_env_get(alone, MIMO_JOINT_POSITION, NULL, 0, expected, count));
  CHECK(memcmp(state, expected, count * sizeof *state) == 0);
  mimo_env_destroy(env);
  mimo_env_destroy(alone);
}

/* ---- A task that waits within a step, so that the world is at work for as long as a test likes. */

typedef struct gate {
  int inside, open;
  mimo_recorder* recorder;
  mimo_status nested[8];
} gate;

static mimo_status wait_inside(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  gate* it = user;
  double time = 0;
  (void)verdict;
  if (moment->world != 0) return MIMO_OK;
  set(&it->inside, 1);
  await(&it->open);
  /* The thread that is at work in the world uses it as before. */
  it->nested[0] = mimo_env_time(env, &time);
  it->nested[1] = mimo_env_random(env, &time, 1);
  it->nested[2] = mimo_env_step(env, NULL, 0, NULL, 0, NULL);
  it->nested[3] = mimo_env_reset(env, NULL, NULL, 0);
  it->nested[4] = it->recorder == NULL ? MIMO_E_BUSY : mimo_recorder_close(it->recorder);
  return MIMO_OK;
}

static mimo_scene* waiting_scene(gate* user) {
  mimo_scene* scene = blind_scene("free");
  mimo_task task;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = wait_inside;
  task.user = user;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  return scene;
}

typedef struct job {
  mimo_env* env;
  mimo_batch* batch;
  mimo_recording* recording;
  mimo_status status;
} job;

static void* work(void* argument) {
  job* it = argument;
  if (it->recording != NULL) {
    it->status = mimo_recording_step(it->recording, it->env, NULL, 0, NULL);
  } else if (it->batch != NULL) {
    it->status = mimo_batch_step(it->batch, NULL, 0, NULL, 0, NULL);
  } else {
    it->status = mimo_env_step(it->env, NULL, 0, NULL, 0, NULL);
  }
  return NULL;
}

static pthread_t begin(job* it, gate* user) {
  pthread_t thread;
  set(&user->inside, 0);
  set(&user->open, 0);
  CHECK(pthread_create(&thread, NULL, work, it) == 0);
  await(&user->inside);
  return thread;
}

static void end(pthread_t thread, const job* it, gate* user) {
  set(&user->open, 1);
  pthread_join(thread, NULL);
  CHECK(it->status == MIMO_OK);
  CHECK(user->nested[0] == MIMO_OK && user->nested[1] == MIMO_OK);
  CHECK(user->nested[2] == MIMO_E_BUSY && user->nested[3] == MIMO_E_BUSY && user->nested[4] == MIMO_E_BUSY);
}

#define IN_USE(what, call) CHECK_FAILS(MIMO_E_BUSY, what " is in use by another thread", call)

static void check_a_stepping_world(void) {
  gate user = {0, 0, NULL, {0}};
  mimo_scene* scene = waiting_scene(&user);
  mimo_env *env = NULL, *other = NULL;
  job it = {NULL, NULL, NULL, MIMO_OK};
  mimo_layout_info info = {.struct_size = sizeof info};
  const mimo_layout* layout = NULL;
  char text[1024];
  double time = -1;
  pthread_t thread;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_layout(env, &layout));
  it.env = env;
  thread = begin(&it, &user);
  IN_USE("env", mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  IN_USE("env", mimo_env_reset(env, NULL, NULL, 0));
  IN_USE("env", mimo_env_update(env));
  IN_USE("env", mimo_env_time(env, &time));
  IN_USE("env", mimo_env_clone(env, &other));
  IN_USE("env", mimo_env_get(env, MIMO_JOINT_POSITION, NULL, 0, &time, 1));
  CHECK(time == -1 && other == NULL);
  /* What other threads may ask. */
  CHECK_OK(mimo_layout_describe(layout, &info));
  CHECK_OK(mimo_last_error_of(env, text, sizeof text, NULL));
  CHECK(strstr(text, "env is in use") != NULL);
  end(thread, &it, &user);
  CHECK_OK(mimo_env_time(env, &time));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* Who destroys what another thread uses takes it from everybody at once; it goes when that call returns. */
static void check_destroying_what_steps(void) {
  gate user = {0, 0, NULL, {0}};
  mimo_scene* scene = waiting_scene(&user);
  mimo_env* env = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  const mimo_layout* layout = NULL;
  job it = {NULL, NULL, NULL, MIMO_OK};
  double time;
  pthread_t thread;
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_layout(env, &layout));
  it.env = env;
  thread = begin(&it, &user);
  mimo_env_destroy(env);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_env_time(env, &time));
  mimo_env_destroy(env);
  CHECK_OK(mimo_layout_describe(layout, &info)); /* it is there still */
  set(&user.open, 1);
  pthread_join(thread, NULL);
  CHECK(it.status == MIMO_OK);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_env_time(env, &time));
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_layout_describe(layout, &info));
  mimo_scene_destroy(scene);
}

static void check_a_stepping_batch(void) {
  gate user = {0, 0, NULL, {0}};
  mimo_scene* scene = waiting_scene(&user);
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  mimo_env *first = NULL, *second = NULL;
  job it = {NULL, NULL, NULL, MIMO_OK};
  double time, gravity[6];
  size_t worlds;
  pthread_t thread;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = config.threads = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  CHECK_OK(mimo_batch_world(batch, 0, &first));
  CHECK_OK(mimo_batch_world(batch, 1, &second));
  it.batch = batch;
  thread = begin(&it, &user);
  IN_USE("batch", mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  IN_USE("batch", mimo_batch_receive(batch));
  IN_USE("batch", mimo_batch_size(batch, &worlds, NULL));
  IN_USE("batch", mimo_batch_get(batch, MIMO_WORLD_GRAVITY, NULL, 0, NULL, 0, gravity, 6));
  CHECK_FAILS(MIMO_E_BUSY, "env is a world of a batch that is at work", mimo_env_time(second, &time));
  CHECK_FAILS(MIMO_E_BUSY, "env is a world of a batch that is at work", mimo_env_update(first));
  end(thread, &it, &user);
  /* One world at work by itself: its batch waits, the other worlds do not. */
  it.batch = NULL;
  it.env = first;
  thread = begin(&it, &user);
  IN_USE("batch", mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  IN_USE("batch", mimo_batch_get(batch, MIMO_WORLD_GRAVITY, NULL, 0, NULL, 0, gravity, 6)); /* of all worlds */
  CHECK_OK(mimo_batch_size(batch, &worlds, NULL));
  CHECK_OK(mimo_batch_world(batch, 1, &second));
  IN_USE("env", mimo_env_time(first, &time));
  CHECK_OK(mimo_env_update(second));
  CHECK_OK(mimo_env_step(second, NULL, 0, NULL, 0, NULL));
  end(thread, &it, &user);
  /* The batch goes with the last call that uses one of its worlds. */
  thread = begin(&it, &user);
  mimo_batch_destroy(batch);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_env_time(second, &time));
  set(&user.open, 1);
  pthread_join(thread, NULL);
  CHECK(it.status == MIMO_OK);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_env_time(first, &time));
  mimo_scene_destroy(scene);
}

/* Compiling a world takes a while. */
static void* create_worlds(void* argument) {
  const mimo_scene* scene = argument;
  int i;
  for (i = 0; i < 5; ++i) {
    mimo_env* env = NULL;
    if (mimo_env_create(scene, NULL, &env) != MIMO_OK) return argument;
    mimo_env_destroy(env);
  }
  return NULL;
}

static void check_scenes_on_two_threads(void) {
  mimo_scene* scene = blind_scene("free");
  pthread_t thread, reader;
  void *failed = NULL, *also = NULL;
  int busy = 0, other = 0, i;
  CHECK(pthread_create(&thread, NULL, create_worlds, scene) == 0);
  CHECK(pthread_create(&reader, NULL, create_worlds, scene) == 0); /* who only reads shares it */
  for (i = 0; i < 100 && busy == 0; ++i) {
    const mimo_status status = mimo_scene_set_room_temperature(scene, 20);
    busy += status == MIMO_E_BUSY;
    other += status != MIMO_E_BUSY && status != MIMO_OK;
    sleep_ms(2);
  }
  pthread_join(thread, &failed);
  pthread_join(reader, &also);
  CHECK(failed == NULL && also == NULL && busy > 0 && other == 0);
  mimo_scene_destroy(scene);
}

/* ---- The log: whoever is told of a handle may read it. */

typedef struct listener {
  mimo_env* env;
  mimo_status read, written;
  char message[256];
} listener;

static void hear(void* user, const mimo_log_record* record) {
  listener* it = user;
  double time;
  (void)record;
  if (it->env == NULL) return;
  it->read = mimo_env_time(it->env, &time);
  it->written = mimo_env_step(it->env, NULL, 0, NULL, 0, NULL);
  snprintf(it->message, sizeof it->message, "%s", mimo_last_error());
  mimo_env_destroy(it->env); /* does nothing now */
}

static void check_calls_from_a_log_callback(void) {
  listener user = {NULL, 1, 1, ""};
  mimo_scene_config room;
  mimo_scene* scene = NULL;
  mimo_env_config config;
  mimo_env* env = NULL;
  const int32_t motor = 0;
  const double absurd = 1e300;
  double time = 0, step = 0;
  uint32_t skip = 0;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.xml =
      "<mujoco><worldbody><body><joint name='hinge'/><geom size='.1'/></body></worldbody>"
      "<actuator><motor joint='hinge'/></actuator></mujoco>";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.log = hear;
  config.log_user = &user;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  user.env = env;
  CHECK_OK(mimo_env_set(env, MIMO_ACTUATOR_CONTROL, &motor, 1, &absurd, 1));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK(user.read == MIMO_OK && user.written == MIMO_E_BUSY);
  CHECK(strstr(user.message, "env is in the call that runs this function") != NULL);
  user.env = NULL;
  CHECK_OK(mimo_env_timestep(env, &step));
  CHECK_OK(mimo_env_frame_skip(env, &skip));
  CHECK_OK(mimo_env_time(env, &time));
  CHECK_NEAR(skip * step, time, 1e-12);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* ---- Recorders and recordings. */

static void check_recordings(const char* folder) {
  gate user = {0, 0, NULL, {0}};
  mimo_scene* scene = waiting_scene(&user);
  mimo_env* env = NULL;
  mimo_recorder* recorder = NULL;
  mimo_recording* recording = NULL;
  mimo_recording_info info = {.struct_size = sizeof info};
  job it = {NULL, NULL, NULL, MIMO_OK};
  char path[512];
  pthread_t thread;
  snprintf(path, sizeof path, "%s/busy.h5", folder);
  remove(path);
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  if (mimo_recorder_open(env, path, NULL, &recorder) == MIMO_E_UNSUPPORTED) { /* no HDF5 here */
    mimo_env_destroy(env);
    mimo_scene_destroy(scene);
    return;
  }
  CHECK_FAILS(MIMO_E_BUSY, "being recorded already", mimo_recorder_open(env, path, NULL, &recorder));
  user.recorder = recorder;
  it.env = env;
  thread = begin(&it, &user);
  IN_USE("env", mimo_recorder_close(recorder)); /* which takes what the world is left with */
  CHECK_OK(mimo_recorder_flush(recorder));
  end(thread, &it, &user);
  CHECK_OK(mimo_recorder_close(recorder));
  user.recorder = NULL;
  CHECK_OK(mimo_recording_open(path, NULL, &recording));
  CHECK_FAILS(MIMO_E_BUSY, "seek", mimo_recording_step(recording, env, NULL, 0, NULL));
  CHECK_OK(mimo_recording_seek(recording, env, 0, 0, NULL));
  it.recording = recording;
  thread = begin(&it, &user);
  IN_USE("recording", mimo_recording_describe(recording, &info));
  IN_USE("env", mimo_env_update(env));
  end(thread, &it, &user);
  CHECK_OK(mimo_recording_describe(recording, &info));
  mimo_recording_close(recording);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  remove(path);
}

int main(void) {
  check_that_refused_calls_change_nothing();
  check_a_stepping_world();
  check_destroying_what_steps();
  check_a_stepping_batch();
  check_scenes_on_two_threads();
  check_calls_from_a_log_callback();
  check_recordings(".");
  return failures();
}
