/* Every function at a wrong time: in a world that has failed, on a batch that is at work, in the child of a fork, from
 * within a task. The documented status, and nothing written. */
#define _POSIX_C_SOURCE 200809L
#include <sys/wait.h>
#include <unistd.h>

#include "misuse/world.h"
#include "support/capi.h"

static void expect(const row* r, const char* when, mimo_status expected, mimo_status actual) {
  const int changed = expected != MIMO_OK && memory_changed();
  if (expected == actual && !changed) return;
  ++failed_checks;
  fprintf(stderr, "%s, %s: gave %s, expected %s%s; last error \"%s\"\n", r->name, when, mimo_status_name(actual),
          mimo_status_name(expected), changed ? ", and something was written" : "", mimo_last_error());
}

/* What only looks goes on working, what would simulate is refused, and what starts anew helps. (The results of a
 * batch's step are those of its other worlds too, so they are written.) */
static void in_failed_worlds(const row* r) {
  args a;
  mimo_status status;
  if (!(r->uses & (ON_ENV | ON_BATCH)) || (r->uses & DESTROYS)) return;
  break_worlds();
  a = good_args(r->uses);
  remember_memory();
  status = r->call(&a);
  if (r->uses & ON_BATCH) remember_memory();
  expect(r, "failed world", r->uses & SIMULATES ? MIMO_E_SIMULATION : MIMO_OK, status);
  destroy_made(&a);
  if (!(r->uses & HEALS)) mend_worlds();
  a = good_args(ON_ENV | ON_BATCH);
  if (r->uses & ON_ENV) expect(r, "mended world", MIMO_OK, mimo_env_physics_step(a.env, 1));
  if (r->uses & ON_BATCH) expect(r, "mended batch", MIMO_OK, mimo_batch_step(a.batch, NULL, 0, NULL, 0, NULL));
  mend_worlds();
}

/* Between send and receive; also through the handle of one of the batch's worlds. Layouts never change. */
static void while_at_work(const row* r) {
  args a = good_args(r->uses);
  mimo_env* view = NULL;
  if (!(r->uses & (ON_ENV | ON_BATCH | ON_LAYOUT)) || (r->uses & (DESTROYS | ANYTIME))) {
    destroy_made(&a);
    return;
  }
  CHECK_OK(mimo_batch_world(a.batch, 0, &view));
  if (r->uses & ON_ENV) a.env = view;
  CHECK_OK(mimo_batch_layout(a.batch, &a.layout));
  remember_memory();
  CHECK_OK(mimo_batch_send(a.batch, NULL, 0, NULL, 0, NULL));
  expect(r, "batch at work", r->uses & ON_LAYOUT ? MIMO_OK : MIMO_E_BUSY, r->call(&a));
  CHECK_OK(mimo_batch_receive(a.batch));
  expect(r, "batch done", MIMO_OK, r->uses & ON_ENV ? mimo_env_update(view) : MIMO_OK);
  destroy_made(&a);
}

static void in_the_child(const args* parents) {
  size_t i;
  for (i = 0; i < row_count; ++i) {
    const row* r = &all_rows[i];
    args a = good_args(0);
    if (!(r->uses & (ON_SCENE | ON_ROOM | ON_EMPTY | ON_BEHAVIOUR | ON_CART | ON_ENV | ON_BATCH | ON_SENSES |
                     ON_LAYOUT | ON_RECORDER | ON_RECORDING)))
      continue;
    a.scene = parents->scene;
    a.room = parents->room;
    remember_memory();
    if (!(r->uses & DESTROYS)) expect(r, "after fork", MIMO_E_FORKED, r->call(&a));
  }
  mimo_scene_destroy(parents->scene);
  mimo_env_destroy(parents->env);
  mimo_batch_destroy(parents->batch);
  mimo_senses_destroy(parents->senses);
  CHECK_OK(mimo_recorder_close(parents->recorder));
  mimo_recording_close(parents->recording);
}

static void after_fork(void) {
  args a = good_args(ON_SCENE | ON_ROOM);
  int status = -1;
  const pid_t child = fork();
  if (child == 0) {
    in_the_child(&a);
    _exit(failures() | rows_failures() | world_failures());
  }
  CHECK(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  CHECK_OK(mimo_env_physics_step(a.env, 1));
  CHECK_OK(mimo_batch_step(a.batch, NULL, 0, NULL, 0, NULL));
  destroy_made(&a);
}

/* A task must not pull away or move on the world that it judges. */
static mimo_status meddle(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  const args* a = user;
  double time = -1, later = -2;
  (void)moment, (void)verdict;
  CHECK_OK(mimo_env_time(env, &time));
  CHECK_FAILS(MIMO_E_BUSY, "a task may not", mimo_env_reset(env, NULL, NULL, 0));
  CHECK_FAILS(MIMO_E_BUSY, "a task may not", mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_BUSY, "a task may not", mimo_env_physics_step(env, 1));
  CHECK_FAILS(MIMO_E_BUSY, "a task may not", mimo_env_state_load(env, a->state, a->state_bytes, NULL));
  mimo_env_destroy(env);
  CHECK_OK(mimo_env_time(env, &later));
  CHECK(time == later);
  return MIMO_OK;
}

static void in_a_task(void) {
  args a = good_args(ON_SCENE);
  mimo_env* env = NULL;
  a.task->evaluate = meddle;
  a.task->user = &a;
  CHECK_OK(mimo_scene_set_task(a.scene, a.task));
  CHECK_OK(mimo_env_create(a.scene, NULL, &env));
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  mimo_env_destroy(env);
  destroy_made(&a);
}

int main(void) {
  size_t i;
  make_everything();
  for (i = 0; i < row_count; ++i) in_failed_worlds(&all_rows[i]);
  for (i = 0; i < row_count; ++i) while_at_work(&all_rows[i]);
  after_fork();
  in_a_task();
  destroy_everything();
  return failures() | rows_failures() | world_failures();
}
