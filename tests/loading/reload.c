/* A host that knows libmimo only by its path: it loads it, makes a world, unloads it, and again, on threads that come
 * and go. Nothing of the library is left in between. loading_reload libmimo.so */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>

#include "loading/library.h"

static void* use_on_thread(void* mimo) {
  use_library(mimo);
  return NULL;
}

/* Whether a part of the file is mapped into this process. */
static int is_loaded(const char* path) {
  const char* name = strrchr(path, '/');
  char line[1024];
  int found = 0;
  FILE* maps = fopen("/proc/self/maps", "r");
  while (maps != NULL && fgets(line, sizeof line, maps) != NULL) found |= strstr(line, name) != NULL;
  if (maps != NULL) fclose(maps);
  return found;
}

int main(int argc, char** argv) {
  int round;
  if (argc != 2) return 2;
  for (round = 0; round < 3; ++round) {
    pthread_t thread;
    library mimo = open_library(argv[1]);
    CHECK(is_loaded(argv[1]));
    use_library(&mimo);
    CHECK(pthread_create(&thread, NULL, use_on_thread, &mimo) == 0);
    CHECK(pthread_join(thread, NULL) == 0);
    CHECK(dlclose(mimo.handle) == 0);
    CHECK(!is_loaded(argv[1]));
  }
  return failures();
}
