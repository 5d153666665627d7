/* A handle made before fork() answers MIMO_E_FORKED in the child, which can make its own; the parent goes on. This
 * holds while another thread uses the library for the first time or compiles a model. The child of a process that has
 * drawn with OSMesa ends with its own exit code. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "support/capi.h"

/* Waits for a child and gives its exit status; -1 where a signal ended it. */
static int status_of(pid_t child) {
  int status = -1;
  CHECK(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void in_the_child(mimo_scene* scene, mimo_env* env) {
  mimo_env* own;
  size_t count = 77;
  CHECK_FAILS(MIMO_E_FORKED, "env was made before fork()", mimo_env_count(env, MIMO_AGENT, &count));
  CHECK_FAILS(MIMO_E_FORKED, "env was made before fork()", mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_FAILS(MIMO_E_FORKED, "scene was made before fork()", mimo_scene_xml(scene, NULL, 0, &count));
  CHECK(count == 77);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  CHECK_FAILS(MIMO_E_FORKED, "env was made before fork()", mimo_env_count(env, MIMO_AGENT, &count));
  own = blind_env("free", NULL);
  CHECK_OK(mimo_env_step(own, NULL, 0, NULL, 0, NULL));
  mimo_env_destroy(own);
}

static void check_handles_in_a_child(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = blind_env("free", NULL);
  const pid_t child = fork();
  if (child == 0) {
    in_the_child(scene, env);
    _exit(failures());
  }
  CHECK(status_of(child) == 0);
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_scene_xml(scene, NULL, 0, NULL));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

/* GCC's address sanitizer has an allocator whose locks stay closed in a child that is forked while another thread
 * allocates: the child hangs, whatever the library does. The C library's malloc opens its own. */
#ifdef __SANITIZE_ADDRESS__
enum { MALLOC_SURVIVES_FORK = 0 };
#else
enum { MALLOC_SURVIVES_FORK = 1 };
#endif

static void nap(long microseconds) {
  const struct timespec time = {0, 1000 * microseconds};
  nanosleep(&time, NULL);
}

/* For newer versions of MuJoCo: reading it needs all that the library knows of documents. */
static void read_a_newer_document(void) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.xml =
      "<mujoco><option ls_iterations='9'/><worldbody><body gravcomp='0'><geom size='1'/></body></worldbody>"
      "<sensor><e_kinetic/></sensor></mujoco>";
  CHECK_OK(mimo_scene_create(&config, &scene));
  mimo_scene_destroy(scene);
}

static void* read_on_a_thread(void* unused) {
  read_a_newer_document();
  return unused;
}

/* A process that has not used the library yet forks while a thread of its does so. What the library sets up at its
 * first use, the child must not find half done, and wait for the thread that it does not have. */
static void fork_at_first_use(long microseconds) {
  pthread_t reader;
  pid_t child;
  CHECK(pthread_create(&reader, NULL, read_on_a_thread, NULL) == 0);
  nap(microseconds);
  child = fork();
  if (child == 0) {
    alarm(20);
    read_a_newer_document();
    _exit(failures());
  }
  CHECK(status_of(child) == 0);
  CHECK(pthread_join(reader, NULL) == 0);
}

static void check_forks_during_first_use(void) {
  enum { TRIES = 60, STEP = 50 };
  int i;
  if (!MALLOC_SURVIVES_FORK) return;
  for (i = 0; i < TRIES && failed_checks == 0; ++i) {
    const pid_t fresh = fork();
    if (fresh == 0) {
      fork_at_first_use((long)i * STEP);
      _exit(failures());
    }
    CHECK(status_of(fresh) == 0);
  }
}

static void* make_worlds(void* unused) {
  int i;
  for (i = 0; i < 6; ++i) mimo_env_destroy(blind_env("free", NULL));
  return unused;
}

static void check_forks_while_compiling(void) {
  enum { CHILDREN = 8 };
  pid_t children[CHILDREN];
  pthread_t maker;
  int i;
  if (!MALLOC_SURVIVES_FORK) return;
  CHECK(pthread_create(&maker, NULL, make_worlds, NULL) == 0);
  for (i = 0; i < CHILDREN; ++i) {
    nap(7000);
    children[i] = fork();
    if (children[i] != 0) continue;
    alarm(100);
    mimo_env_destroy(blind_env("free", NULL));
    _exit(failures());
  }
  for (i = 0; i < CHILDREN; ++i) CHECK(status_of(children[i]) == 0);
  CHECK(pthread_join(maker, NULL) == 0);
}

/* A batch has threads, which the child has not. */
static void check_a_batch_in_a_child(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  pid_t child;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = config.threads = 2;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  child = fork();
  if (child == 0) {
    const int forked = mimo_batch_step(batch, NULL, 0, NULL, 0, NULL) == MIMO_E_FORKED;
    mimo_batch_destroy(batch);
    _exit(forked ? 0 : 1);
  }
  CHECK(status_of(child) == 0);
  CHECK_OK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
}

static int at_exit_calls = 0;

static void at_exit_of_the_host(void) { ++at_exit_calls; }

static void say_at_exit(void) {
  if (at_exit_calls == 1) _exit(33);
}

/* Draws a picture; 0 where OSMesa is not installed. */
static int draw(void) {
  mimo_env_config config;
  mimo_picture_config picture;
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  uint8_t rgb[3 * 16 * 16];
  mimo_status status;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.renderer = "osmesa";
  CHECK_OK(mimo_env_create(scene, &config, &env));
  CHECK_OK(mimo_picture_config_init(&picture, sizeof picture));
  picture.width = picture.height = 16;
  status = mimo_env_render(env, &picture, PICTURE(.rgb = rgb, .rgb_bytes = sizeof rgb));
  CHECK(status == MIMO_OK || status == MIMO_E_UNSUPPORTED);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return status == MIMO_OK;
}

/* exit() calls the host's functions in the child, and its status arrives. */
static void check_exit_after_osmesa(void) {
  pid_t child;
  CHECK(atexit(say_at_exit) == 0); /* called last */
  if (!draw()) {
    fprintf(stderr, "no OSMesa here: nothing to be said about a child that exits after it\n");
    return;
  }
  child = fork();
  if (child == 0) {
    alarm(100);
    exit(3);
  }
  CHECK(status_of(child) == 3);
  child = fork();
  if (child == 0) {
    alarm(100);
    atexit(at_exit_of_the_host);
    exit(3);
  }
  CHECK(status_of(child) == 33);
}

int main(void) {
  check_forks_during_first_use(); /* which is over with the next check */
  check_handles_in_a_child();
  check_a_batch_in_a_child();
  check_forks_while_compiling();
  check_exit_after_osmesa();
  return failures();
}
