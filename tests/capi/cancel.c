/* A thread that is cancelled within a call finishes the call first, callbacks included, and ends at its next
 * cancellation point. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <time.h>

#include "support/capi.h"

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static int started, judged, finished, state_after;

static void sleep_ms(long ms) {
  const struct timespec time = {0, ms * 1000000};
  nanosleep(&time, NULL); /* a cancellation point */
}

static mimo_status judge(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  int i;
  (void)user, (void)env, (void)moment, (void)verdict;
  pthread_mutex_lock(&mutex);
  started = 1;
  pthread_cond_signal(&changed);
  pthread_mutex_unlock(&mutex);
  for (i = 0; i < 20; ++i) sleep_ms(2);
  judged = 1;
  return MIMO_OK;
}

static void* step_batch(void* batch) {
  finished = mimo_batch_step(batch, NULL, 0, NULL, 0, NULL) == MIMO_OK;
  pthread_testcancel();
  finished = -1; /* not reached */
  return NULL;
}

static void* destroy_sent(void* batch) {
  mimo_batch_destroy(batch);
  finished = 1;
  pthread_testcancel();
  finished = -1; /* not reached */
  return NULL;
}

static void* off_before(void* batch) {
  pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, NULL);
  finished = mimo_batch_step(batch, NULL, 0, NULL, 0, NULL) == MIMO_OK;
  pthread_setcancelstate(PTHREAD_CANCEL_ENABLE, &state_after);
  return NULL;
}

static void cancel(void* (*run)(void*), mimo_batch* batch) {
  pthread_t thread;
  void* result = NULL;
  started = judged = finished = 0;
  if (run == destroy_sent) CHECK_OK(mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
  CHECK(pthread_create(&thread, NULL, run, batch) == 0);
  pthread_mutex_lock(&mutex);
  while (!started) pthread_cond_wait(&changed, &mutex);
  pthread_mutex_unlock(&mutex);
  if (run == destroy_sent) sleep_ms(5);
  if (run != off_before) CHECK(pthread_cancel(thread) == 0);
  pthread_join(thread, &result);
  CHECK(judged == 1 && finished == 1);
  CHECK((result == PTHREAD_CANCELED) == (run != off_before));
}

int main(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_batch_config config;
  mimo_task task;
  mimo_batch* batch = NULL;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = judge;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.threads = 1;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  mimo_scene_destroy(scene);
  if (batch == NULL) return failures();
  cancel(step_batch, batch);
  cancel(off_before, batch);
  CHECK(state_after == PTHREAD_CANCEL_DISABLE); /* as the host had it */
  cancel(step_batch, batch);                    /* the batch is as good as before */
  cancel(destroy_sent, batch);
  return failures();
}
