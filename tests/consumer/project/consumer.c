/* The smallest program of a user: is the library there, is it the one that the header describes, and does it work? */
#include <mimo/mimo.h>
#include <stdio.h>

static int complain(void) {
  fprintf(stderr, "%s\n", mimo_last_error());
  return 1;
}

int main(void) {
  mimo_env* env;
  double seconds = 0;
  printf("libmimo %s on MuJoCo %s\n", mimo_version(), mimo_mujoco_version());
  if (mimo_abi_version() != MIMO_ABI_VERSION) return 1;
  if (mimo_env_make("reach", &env) != MIMO_OK) return complain();
  if (mimo_env_step(env, NULL, 0, NULL, 0, NULL) != MIMO_OK) return complain();
  if (mimo_env_time(env, &seconds) != MIMO_OK) return complain();
  mimo_env_destroy(env);
  printf("one step, %.3f s\n", seconds);
  return seconds > 0.0099 && seconds < 0.0101 ? 0 : 1; /* two physics steps of 5 ms */
}
