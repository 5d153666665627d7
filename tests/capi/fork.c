/* A handle made before fork() answers MIMO_E_FORKED in the child, which can make its own; the parent goes on. */
#define _POSIX_C_SOURCE 200809L
#include <sys/wait.h>
#include <unistd.h>

#include "support/capi.h"

static void in_the_child(mimo_scene* scene, mimo_env* env) {
  mimo_env* own;
  size_t count = 77;
  CHECK_FAILS(MIMO_E_FORKED, "env was made before fork()", mimo_env_agent_count(env, &count));
  CHECK_FAILS(MIMO_E_FORKED, "env was made before fork()", mimo_env_step(env, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
  CHECK_FAILS(MIMO_E_FORKED, "scene was made before fork()", mimo_scene_xml(scene, NULL, 0, &count));
  CHECK(count == 77);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  CHECK_FAILS(MIMO_E_FORKED, "env was made before fork()", mimo_env_agent_count(env, &count));
  own = blind_env("free", NULL);
  CHECK_OK(mimo_env_step(own, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
  mimo_env_destroy(own);
}

int main(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = blind_env("free", NULL);
  int status = -1;
  const pid_t child = fork();
  if (child == 0) {
    in_the_child(scene, env);
    _exit(failures());
  }
  CHECK(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
  CHECK_OK(mimo_scene_xml(scene, NULL, 0, NULL));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return failures();
}
