/* libmimo as a file that is loaded at run time: by name, with nothing linked. */
#ifndef MIMO_TESTS_LOADING_LIBRARY_H
#define MIMO_TESTS_LOADING_LIBRARY_H

#include <dlfcn.h>

#include "support/capi.h"

typedef struct library {
  void* handle;
  mimo_status (*env_make)(const char*, mimo_env**);
  mimo_status (*env_step)(mimo_env*, const float*, size_t, void*, size_t, double*, uint8_t*, uint8_t*, size_t);
  mimo_status (*env_time)(const mimo_env*, double*);
  void (*env_destroy)(mimo_env*);
  const char* (*last_error)(void);
} library;

/* ISO C knows no way from an address to a function. */
static inline void look_up(const library* from, const char* name, void* function) {
  void* address = dlsym(from->handle, name);
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
  look_up(&mimo, "mimo_env_make", &mimo.env_make);
  look_up(&mimo, "mimo_env_step", &mimo.env_step);
  look_up(&mimo, "mimo_env_time", &mimo.env_time);
  look_up(&mimo, "mimo_env_destroy", &mimo.env_destroy);
  look_up(&mimo, "mimo_last_error", &mimo.last_error);
  return mimo;
}

/* A world that makes a step: 10 ms later it is 10 ms later. */
static inline void use_library(const library* mimo) {
  mimo_env* env = NULL;
  double seconds = -1;
  CHECK(mimo->env_make("reach", &env) == MIMO_OK);
  CHECK(mimo->env_step(env, NULL, 0, NULL, 0, NULL, NULL, NULL, 0) == MIMO_OK);
  CHECK(mimo->env_time(env, &seconds) == MIMO_OK);
  CHECK_NEAR(0.01, seconds, 1e-12);
  CHECK(mimo->env_make("nowhere", &env) == MIMO_E_NOT_FOUND);
  CHECK(strstr(mimo->last_error(), "nowhere") != NULL);
  mimo->env_destroy(env);
}

#endif
