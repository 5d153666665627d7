/* libmimo as a file that is loaded at run time: by name, with nothing linked. */
#ifndef MIMO_TESTS_LOADING_LIBRARY_H
#define MIMO_TESTS_LOADING_LIBRARY_H

#include <dlfcn.h>

#include "support/capi.h"

#define EACH_FUNCTION(DO) \
  DO(agent_config_init)   \
  DO(env_agent)           \
  DO(env_config_init)     \
  DO(env_create)          \
  DO(env_destroy)         \
  DO(env_layout)          \
  DO(env_make)            \
  DO(env_reset)           \
  DO(env_step)            \
  DO(env_time)            \
  DO(last_error)          \
  DO(layout_describe)     \
  DO(scene_add_agent)     \
  DO(scene_config_init)   \
  DO(scene_create)        \
  DO(scene_destroy)

typedef struct library {
  void* handle;
#define MEMBER(name) __typeof__(&mimo_##name) name;
  EACH_FUNCTION(MEMBER)
#undef MEMBER
} library;

/* ISO C knows no way from an address to a function. */
static inline void look_up(void* from, const char* name, void* function) {
  void* address = dlsym(from, name);
  if (address == NULL) {
    fprintf(stderr, "no %s\n", name);
    exit(1);
  }
  memcpy(function, &address, sizeof address);
}

static inline library open_library(const char* path) {
  library mimo;
  memset(&mimo, 0, sizeof mimo);
  mimo.handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (mimo.handle == NULL) {
    fprintf(stderr, "%s\n", dlerror());
    exit(1);
  }
#define LOOK_UP(name) look_up(mimo.handle, "mimo_" #name, &mimo.name);
  EACH_FUNCTION(LOOK_UP)
#undef LOOK_UP
  return mimo;
}

/* A world that makes a step: 10 ms later it is 10 ms later. */
static inline void use_library(const library* mimo) {
  mimo_env* env = NULL;
  double seconds = -1;
  CHECK(mimo->env_make("reach", &env) == MIMO_OK);
  CHECK(mimo->env_step(env, NULL, 0, NULL, 0, NULL) == MIMO_OK);
  CHECK(mimo->env_time(env, &seconds) == MIMO_OK);
  CHECK_NEAR(0.01, seconds, 1e-12);
  CHECK(mimo->env_make("nowhere", &env) == MIMO_E_NOT_FOUND);
  CHECK(strstr(mimo->last_error(), "nowhere") != NULL);
  mimo->env_destroy(env);
}

/* FNV-1a over the observations of a reset and a few steps. */
static inline uint64_t hash_of_life(const library* mimo, mimo_env* env, int steps) {
  const mimo_reset_config seeded = {.struct_size = sizeof seeded, .seeded = 1, .seed = 7};
  uint64_t hash = UINT64_C(14695981039346656037);
  const mimo_layout* layout = NULL;
  mimo_layout_info info = {.struct_size = sizeof info};
  size_t bytes, i;
  uint8_t* block;
  int step;
  CHECK(mimo->env_layout(env, &layout) == MIMO_OK);
  CHECK(mimo->layout_describe(layout, &info) == MIMO_OK);
  bytes = info.block_bytes;
  block = malloc(bytes);
  CHECK(mimo->env_reset(env, &seeded, block, bytes) == MIMO_OK);
  for (step = 0; step < steps; ++step) {
    CHECK(mimo->env_step(env, NULL, 0, block, bytes, NULL) == MIMO_OK);
    for (i = 0; i < bytes; ++i) hash = (hash ^ block[i]) * UINT64_C(1099511628211);
  }
  free(block);
  return hash;
}

#endif
