/* How the library starts threads: with the host's signals blocked, which are as before afterwards, but for those of
 * runtimes; with stacks that suffice; and what it says when there are none to be had. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <signal.h>

#include "support/capi.h"

typedef int (*creator)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);

static int started, let = 1000; /* threads */
static size_t least_stack = (size_t)-1;

/* In place of the C library's. */
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  creator real;
  size_t stack = 0;
  sigset_t blocked;
  *(void**)&real = dlsym(RTLD_NEXT, "pthread_create");
  if (started >= let) return EAGAIN;
  ++started;
  pthread_sigmask(SIG_SETMASK, NULL, &blocked);
  CHECK(sigismember(&blocked, SIGTERM) && sigismember(&blocked, SIGUSR1) && sigismember(&blocked, SIGCHLD));
  CHECK(!sigismember(&blocked, SIGSEGV) && !sigismember(&blocked, SIGFPE));
  CHECK(!sigismember(&blocked, SIGRTMIN + 2) && !sigismember(&blocked, SIGPWR)); /* collectors stop threads by these */
  if (attributes != NULL && pthread_attr_getstacksize(attributes, &stack) == 0 && stack < least_stack) {
    least_stack = stack;
  }
  return real(thread, attributes, run, argument);
}

static mimo_status make(uint32_t threads, uint32_t render_threads, mimo_batch** batch) {
  mimo_env_config config;
  mimo_batch_config many;
  mimo_scene* scene = blind_scene("free");
  mimo_status status;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  CHECK_OK(mimo_batch_config_init(&many, sizeof many));
  config.render_threads = render_threads;
  many.worlds = 4;
  many.threads = threads;
  status = mimo_batch_create(scene, &config, &many, batch);
  mimo_scene_destroy(scene);
  return status;
}

int main(void) {
  mimo_batch* batch = NULL;
  sigset_t mask;
  CHECK_OK(make(4, 1, &batch));
  CHECK(started == 3);
  CHECK(least_stack >= 512 * 1024 && least_stack != (size_t)-1);
  pthread_sigmask(SIG_SETMASK, NULL, &mask);
  CHECK(!sigismember(&mask, SIGTERM) && !sigismember(&mask, SIGUSR1));

  let = 3; /* send needs one more, because the caller goes its own way */
  CHECK_FAILS(MIMO_E_OUT_OF_MEMORY,
              "thread 4 of 4 cannot be started, ask for fewer: the system cannot start a thread: ",
              mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL)); /* it is as it was */
  let = 4;
  CHECK_OK(mimo_batch_send(batch, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_receive(batch));
  mimo_batch_destroy(batch);

  batch = NULL;
  for (let = 0; let < 3; ++let) {
    char expected[100];
    started = 0;
    snprintf(expected, sizeof expected, "thread %d of 4 cannot be started", let + 1);
    CHECK_FAILS(MIMO_E_OUT_OF_MEMORY, expected, make(4, 1, &batch));
    CHECK(batch == NULL);
    CHECK(started == let);
  }
  started = 0;
  CHECK_OK(make(4, 1, &batch));
  mimo_batch_destroy(batch);
  return failures();
}
