/* A host that knows libmimo only by its path and does what hosts do: it has a locale with a decimal comma, it forks, it
 * has sixteen threads. loading_host locale|fork|threads libmimo.so */
#define _POSIX_C_SOURCE 200809L
#include <locale.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#include "loading/library.h"

enum { kSkipped = 77, kThreads = 16 };

static int has_comma(void) {
  char text[8];
  snprintf(text, sizeof text, "%.1f", 1.5);
  return strcmp(text, "1,5") == 0;
}

/* The original's infant weighs 10.905 kg; with commas it would not. */
static int with_comma_locale(const char* path) {
  library mimo;
  mimo_env* env = NULL;
  mimo_agent_info infant;
  if (setlocale(LC_ALL, "de_DE.UTF-8") == NULL || !has_comma()) return kSkipped;
  mimo = open_library(path);
  CHECK(mimo.env_make("reach", &env) == MIMO_OK);
  memset(&infant, 0, sizeof infant);
  infant.struct_size = sizeof infant;
  CHECK(mimo.env_agent(env, 0, &infant) == MIMO_OK);
  CHECK_NEAR(10.905, infant.mass, 5e-4);
  mimo.env_destroy(env);
  use_library(&mimo);
  CHECK(has_comma());
  return failures();
}

static int after_fork(const char* path) {
  const library mimo = open_library(path);
  mimo_env* env = NULL;
  int status = -1;
  pid_t child;
  CHECK(mimo.env_make("reach", &env) == MIMO_OK);
  child = fork();
  if (child == 0) {
    CHECK(mimo.env_step(env, NULL, 0, NULL, 0, NULL) == MIMO_E_FORKED);
    mimo.env_destroy(env);
    use_library(&mimo);
    _exit(failures());
  }
  CHECK(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0);
  CHECK(mimo.env_step(env, NULL, 0, NULL, 0, NULL) == MIMO_OK);
  mimo.env_destroy(env);
  use_library(&mimo);
  return failures();
}

typedef struct job {
  const library* mimo;
  uint64_t hash;
} job;

static void* live(void* argument) {
  job* mine = argument;
  mimo_env* env = NULL;
  if (mine->mimo->env_make("reach", &env) == MIMO_OK) mine->hash = hash_of_life(mine->mimo, env, 20);
  mine->mimo->env_destroy(env);
  return NULL;
}

static int on_threads(const char* path) {
  const library mimo = open_library(path);
  pthread_t threads[kThreads];
  job jobs[kThreads + 1];
  int i;
  for (i = 0; i <= kThreads; ++i) {
    jobs[i].mimo = &mimo;
    jobs[i].hash = 0;
  }
  for (i = 0; i < kThreads; ++i) CHECK(pthread_create(&threads[i], NULL, live, &jobs[i]) == 0);
  for (i = 0; i < kThreads; ++i) CHECK(pthread_join(threads[i], NULL) == 0);
  live(&jobs[kThreads]);
  CHECK(jobs[kThreads].hash != 0);
  for (i = 0; i < kThreads; ++i) CHECK(jobs[i].hash == jobs[kThreads].hash);
  return failures();
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  if (strcmp(argv[1], "locale") == 0) return with_comma_locale(argv[2]);
  if (strcmp(argv[1], "fork") == 0) return after_fork(argv[2]);
  return on_threads(argv[2]);
}
