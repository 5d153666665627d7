/* The smallest program of a user: is the library there, and is it the one that the header describes? */
#include <mimo/mimo.h>
#include <stdio.h>

int main(void) {
  printf("libmimo %s on MuJoCo %s\n", mimo_version(), mimo_mujoco_version());
  return mimo_abi_version() == MIMO_ABI_VERSION ? 0 : 1;
}
