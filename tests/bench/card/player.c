/*
 * Plays a step of mujoco_warp that card.py has captured, without Python, by Warp's C interface (apic.h, Warp 1.19):
 *
 *   gcc -O1 player.c -o player -ldl && ./player WARP/bin FOLDER cpu|cuda WORLDS NQ NV STEPS
 *
 * FOLDER is what "card.py graph" wrote: step.wrp, step_modules, and qpos before and after 20 steps.
 */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <dlfcn.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { kPath = 4096, kChecked = 20 };

static const char* (*wp_get_error_string)(void);

static void need(int ok, const char* what) {
  if (ok) return;
  fprintf(stderr, "player: %s: %s\n", what, wp_get_error_string != NULL ? wp_get_error_string() : "");
  exit(1);
}

static void* open_library(const char* folder, const char* name) {
  char path[kPath];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  void* library = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
  need(library != NULL, path);
  return library;
}

static void read_all(const char* folder, const char* name, void* to, size_t bytes) {
  char path[kPath];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE* file = fopen(path, "rb");
  need(file != NULL && fread(to, 1, bytes, file) == bytes, path);
  fclose(file);
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#define FIND(library, result, name, arguments)                          \
  result(*name) arguments = (result(*) arguments)dlsym(library, #name); \
  need(name != NULL, #name)

/* Kernels for the processor are object files, which Warp's compiler library links. */
static void load_kernels(void* core, const char* libraries, const char* folder, void* graph, int kernels) {
  void* clang = open_library(libraries, "warp-clang.so");
  FIND(clang, int, wp_load_obj, (const char*, const char*, char));
  FIND(clang, uint64_t, wp_lookup, (const char*, const char*));
  FIND(clang, int, wp_llvm_set_cpu_block_runtime, (const void*));
  FIND(core, void*, wp_cpu_block_runtime_get_api, (void));
  FIND(core, const char*, wp_apic_get_kernel_key, (void*, int));
  FIND(core, const char*, wp_apic_get_kernel_module_hash, (void*, int));
  FIND(core, const char*, wp_apic_get_kernel_module_binary_filename, (void*, int));
  FIND(core, const char*, wp_apic_get_kernel_forward_name, (void*, int));
  FIND(core, void, wp_apic_register_loaded_cpu_kernel, (void*, const char*, const char*, void*, void*));
  need(wp_llvm_set_cpu_block_runtime(wp_cpu_block_runtime_get_api()), "wp_llvm_set_cpu_block_runtime");
  char path[kPath];
  snprintf(path, sizeof path, "%s/step_modules", folder);
  DIR* modules = opendir(path);
  need(modules != NULL, path);
  for (struct dirent* entry; (entry = readdir(modules)) != NULL;) {
    if (strstr(entry->d_name, ".o") == NULL) continue;
    snprintf(path, sizeof path, "%s/step_modules/%s", folder, entry->d_name);
    need(wp_load_obj(path, entry->d_name, 0) == 0, path);
  }
  closedir(modules);
  for (int i = 0; i < kernels; ++i) {
    const char* key = wp_apic_get_kernel_key(graph, i);
    const uint64_t f =
        wp_lookup(wp_apic_get_kernel_module_binary_filename(graph, i), wp_apic_get_kernel_forward_name(graph, i));
    need(f != 0, key);
    wp_apic_register_loaded_cpu_kernel(graph, key, wp_apic_get_kernel_module_hash(graph, i), (void*)(uintptr_t)f, NULL);
  }
}

int main(int count, char** given) {
  if (count != 8) {
    fprintf(stderr, "usage: player WARP/bin FOLDER cpu|cuda WORLDS NQ NV STEPS\n");
    return 2;
  }
  const int cpu = strcmp(given[3], "cpu") == 0, worlds = atoi(given[4]), steps = atoi(given[7]);
  const size_t values = (size_t)worlds * (size_t)atoi(given[5]), bytes = sizeof(float) * values;
  const size_t speeds = sizeof(float) * (size_t)worlds * (size_t)atoi(given[6]);
  const double start = now();
  void* core = open_library(given[1], "warp.so");
  wp_get_error_string = (const char* (*)(void))dlsym(core, "wp_get_error_string");
  FIND(core, int, wp_init, (const char*));
  FIND(core, void*, wp_apic_load_graph, (void*, const char*, int));
  FIND(core, int, wp_apic_get_num_kernels, (void*));
  FIND(core, char, wp_apic_cpu_replay_graph, (void*));
  FIND(core, char, wp_apic_launch, (void*, void*));
  FIND(core, char, wp_apic_set_param, (void*, const char*, const void*, size_t));
  FIND(core, char, wp_apic_get_param, (void*, const char*, void*, size_t));
  FIND(core, void*, wp_cuda_device_get_primary_context, (int));
  FIND(core, void, wp_cuda_context_set_current, (void*));
  FIND(core, char, wp_cuda_context_synchronize, (void*));
  FIND(core, void*, wp_cuda_stream_create, (void*, int));
  need(wp_init("1.19.0") == 0, "wp_init");
  void *context = NULL, *stream = NULL;
  if (!cpu) {
    context = wp_cuda_device_get_primary_context(0);
    need(context != NULL, "wp_cuda_device_get_primary_context");
    wp_cuda_context_set_current(context);
    stream = wp_cuda_stream_create(context, 0);
  }
  char path[kPath];
  snprintf(path, sizeof path, "%s/step.wrp", given[2]);
  void* graph = wp_apic_load_graph(context, path, cpu);
  need(graph != NULL, path);
  const int kernels = wp_apic_get_num_kernels(graph);
  if (cpu) load_kernels(core, given[1], given[2], graph, kernels);
  const double loaded = now();

  float *qpos = malloc(bytes), *wanted = malloc(bytes), *qvel = calloc(1, speeds);
  need(qpos != NULL && wanted != NULL && qvel != NULL, "memory");
  read_all(given[2], "start.bin", qpos, bytes);
  read_all(given[2], "after.bin", wanted, bytes);
  need(wp_apic_set_param(graph, "start", qpos, bytes) && wp_apic_set_param(graph, "speed", qvel, speeds), "set_param");
  double begin = now(), most = 0;
  for (int i = 0; i < kChecked + steps; ++i) {
    if (i == kChecked) {
      need(wp_apic_get_param(graph, "qpos", qpos, bytes), "get_param");
      for (size_t k = 0; k < values; ++k) most = fmax(most, fabs((double)qpos[k] - (double)wanted[k]));
      begin = now();
    }
    need(cpu ? wp_apic_cpu_replay_graph(graph) : wp_apic_launch(graph, stream), "launch");
  }
  if (!cpu) need(wp_cuda_context_synchronize(context), "wp_cuda_context_synchronize");
  const double each = (now() - begin) / steps;
  printf(
      "%d kernels, loaded in %.2f s; after %d steps qpos differs from Python's by %g; %.0f us a step of all %d "
      "worlds\n",
      kernels, loaded - start, kChecked, most, 1e6 * each, worlds);
  fflush(stdout);
  _Exit(0); /* Warp's libraries cannot be unloaded in any order */
}
