/* A host that loads the library, makes worlds, and unloads it, again and again: its heap stays as large as it was.
 * Handles are made that outnumber what the library has room for at first. loading_leaks libmimo.so, with
 * GLIBC_TUNABLES=glibc.malloc.tcache_count=0: what is kept for each thread counts as in use otherwise. */
#define _GNU_SOURCE
#include <malloc.h>

#include "loading/library.h"

/* Bytes of the process's heap that are in use, with blocks that lie by themselves; -1 where the C library is too old to
 * count above 2 GB. */
static double heap_in_use(void) {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
  const struct mallinfo2 heap = mallinfo2();
  return (double)heap.uordblks + (double)heap.hblkhd;
#else
  return -1;
#endif
}

static void make_scenes(const library* mimo, int count) {
  while (count-- > 0) {
    mimo_scene_config config;
    mimo_scene* scene = NULL;
    CHECK(mimo->scene_config_init(&config, sizeof config) == MIMO_OK);
    config.xml = "<mujoco/>";
    CHECK(mimo->scene_create(&config, &scene) == MIMO_OK);
    mimo->scene_destroy(scene);
  }
}

int main(int argc, char** argv) {
  const int settling = 3, cycles = 8;
  const double most_each = 64; /* bytes; a handle's control block has more */
  double before = 0, grown;
  int cycle;
  if (argc != 2) return 2;
  if (heap_in_use() < 0) return 77;
  for (cycle = 0; cycle < settling + cycles; ++cycle) {
    library mimo;
    if (cycle == settling) before = heap_in_use();
    mimo = open_library(argv[1]);
    make_scenes(&mimo, 600);
    use_library(&mimo);
    CHECK(dlclose(mimo.handle) == 0);
  }
  grown = (heap_in_use() - before) / cycles;
  if (grown > most_each) fprintf(stderr, "%.0f bytes a cycle stay\n", grown);
  CHECK(grown <= most_each);
  return failures();
}
