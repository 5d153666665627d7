/* What fuzz targets share: taking values out of the fuzzer's bytes, and the promises that every call keeps. */
#ifndef MIMO_TESTS_FUZZ_INPUT_H
#define MIMO_TESTS_FUZZ_INPUT_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mimo/experimental.h"
#ifndef __cplusplus
#include "support/calls.h"
#endif

/* One run of a target; libFuzzer's name for it. */
int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

typedef struct input {
  const uint8_t* data;
  size_t left;
} input;

/* The next bytes, and zeros where there are no more. */
static inline void take(input* in, void* to, size_t bytes) {
  const size_t given = bytes < in->left ? bytes : in->left;
  memset(to, 0, bytes);
  if (given > 0) memcpy(to, in->data, given);
  in->data += given;
  in->left -= given;
}

static inline uint8_t take_byte(input* in) {
  uint8_t byte;
  take(in, &byte, 1);
  return byte;
}

static inline uint32_t take_below(input* in, uint32_t limit) {
  uint32_t number;
  take(in, &number, sizeof number);
  return number % limit;
}

static inline double take_double(input* in) {
  double number;
  take(in, &number, sizeof number);
  return number;
}

/* A struct in memory of as many bytes as its struct_size can say without being refused; the tail is zero. */
#define ROOMY(type, name)      \
  union {                      \
    type config;               \
    unsigned char bytes[4096]; \
  } name;                      \
  memset(&name, 0, sizeof name)

/* A broken promise stops the fuzzer, which then keeps the input. */
static inline void promise(int kept, const char* what, int line) {
  if (kept) return;
  fprintf(stderr, "line %d: broken: %s; last error: %s\n", line, what, mimo_last_error());
  abort();
}

/* Every call answers with one of the statuses of mimo.h, and MIMO_E_INTERNAL is a defect. */
static inline mimo_status known(mimo_status status, const char* what, int line) {
  promise(status == MIMO_OK || (status >= MIMO_E_END && status < 0 && status != MIMO_E_INTERNAL), what, line);
  return status;
}

#define PROMISE(condition) promise((condition) != 0, #condition, __LINE__)
#define CALL(call) known((call), #call, __LINE__)

static inline const mimo_layout* layout_of(const mimo_env* env) {
  const mimo_layout* layout = NULL;
  PROMISE(mimo_env_layout(env, &layout) == MIMO_OK);
  return layout;
}

static inline mimo_layout_info sizes_of(const mimo_env* env) {
  mimo_layout_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  PROMISE(mimo_layout_describe(layout_of(env), &info) == MIMO_OK);
  return info;
}

#endif
