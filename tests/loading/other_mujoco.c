/* A host that has another MuJoCo in its process, of another version. Where that one hides its symbols, both work side
 * by side. Where it lies in the global scope, the dynamic linker gives it to libmimo in place of libmimo's own: then no
 * world can be made, with a message that says why, and nothing of the other one is called. loading_other_mujoco
 * local|global libmimo.so libother.so */
#include "loading/library.h"

int main(int argc, char** argv) {
  const int global = argc == 4 && strcmp(argv[1], "global") == 0;
  void* other;
  library mimo;
  mimo_env* env = NULL;
  if (argc != 4) return 2;
  other = dlopen(argv[3], RTLD_NOW | (global ? RTLD_GLOBAL : RTLD_LOCAL));
  CHECK(other != NULL);
  mimo = open_library(argv[2]);
  if (global) {
    CHECK(mimo.env_make("reach", &env) == MIMO_E_UNSUPPORTED);
    CHECK(strstr(mimo.last_error(), "MuJoCo 9.9.9") != NULL);
    CHECK(env == NULL);
  } else {
    use_library(&mimo);
  }
  return failures();
}
