/* A step under way by mimo_batch_send: tasks finish it when the batch is destroyed, and a task that would wait for its
 * own step is refused. */
#define _POSIX_C_SOURCE 200809L
#include <time.h>

#include "support/capi.h"

enum { WORLDS = 4 };

/* What all worlds' tasks share; each writes its own row. */
typedef struct shared {
  mimo_batch *own, *other;
  int slow;
  int done[WORLDS], wrong[WORLDS];
  mimo_status received[WORLDS];
  char message[WORLDS][256];
} shared;

static void sleep_ms(long ms) {
  const struct timespec time = {0, ms * 1000000};
  nanosleep(&time, NULL);
}

static mimo_status judge(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  shared* it = user;
  double time = 0;
  int i;
  (void)verdict;
  for (i = 0; i < it->slow; ++i) {
    sleep_ms(5);
    it->wrong[moment->world] += mimo_env_time(env, &time) != MIMO_OK;
  }
  if (it->own != NULL) {
    it->received[moment->world] = mimo_batch_receive(it->own);
    snprintf(it->message[moment->world], sizeof it->message[moment->world], "%s", mimo_last_error());
    mimo_batch_destroy(it->own); /* does nothing now */
  }
  if (it->other != NULL && moment->world == 0)
    it->wrong[moment->world] += mimo_batch_step(it->other, NULL, 0, NULL, 0, NULL) != MIMO_OK;
  ++it->done[moment->world];
  return MIMO_OK;
}

static mimo_batch* batch_with(shared* user) {
  mimo_scene* scene = blind_scene("free");
  mimo_batch_config config;
  mimo_task task;
  mimo_batch* batch = NULL;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = judge;
  task.user = user;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = WORLDS;
  config.threads = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  mimo_scene_destroy(scene);
  if (batch == NULL) exit(failures());
  return batch;
}

static void check_destroying_a_batch_that_steps(void) {
  shared user = {0};
  mimo_batch* batch = batch_with(&user);
  mimo_env* view = NULL;
  double time;
  size_t i;
  user.slow = 10;
  CHECK_OK(mimo_batch_world(batch, 0, &view));
  CHECK_OK(mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
  sleep_ms(5);
  mimo_batch_destroy(batch);
  for (i = 0; i < WORLDS; ++i) CHECK(user.done[i] == 1 && user.wrong[i] == 0);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "destroyed", mimo_env_time(view, &time));
}

static void check_tasks_that_wait_for_their_own_batch(void) {
  shared user = {0};
  mimo_batch* batch = batch_with(&user);
  size_t i;
  user.own = batch;
  user.slow = 4; /* so that the step has been sent when the first task asks */
  CHECK_OK(mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_receive(batch));
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  for (i = 0; i < WORLDS; ++i) {
    CHECK(user.done[i] == 2 && user.received[i] == MIMO_E_BUSY);
    CHECK(strstr(user.message[i], "a task cannot receive the step that it is part of") != NULL);
  }
  mimo_batch_destroy(batch);
}

/* A task steps another batch, whose tasks try to receive the first one: they are part of its step as well. */
static void check_tasks_that_wait_for_another_batch(void) {
  shared outer = {0}, inner = {0};
  mimo_batch *first = batch_with(&outer), *second = batch_with(&inner);
  size_t i;
  outer.other = second;
  outer.slow = 4;
  inner.own = first;
  CHECK_OK(mimo_batch_send(first, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_receive(first));
  for (i = 0; i < WORLDS; ++i) {
    CHECK(outer.wrong[i] == 0 && outer.done[i] == 1 && inner.done[i] == 1);
    CHECK(inner.received[i] == MIMO_E_BUSY);
  }
  CHECK_OK(mimo_batch_step(first, NULL, 0, NULL, 0, NULL)); /* it was not destroyed */
  mimo_batch_destroy(first);
  mimo_batch_destroy(second);
}

int main(void) {
  check_destroying_a_batch_that_steps();
  check_tasks_that_wait_for_their_own_batch();
  check_tasks_that_wait_for_another_batch();
  return failures();
}
