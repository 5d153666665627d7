// What MuJoCo's sources need and this C library lacks.
#ifndef MIMO_MUJOCO_SORT_H
#define MIMO_MUJOCO_SORT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

// As in glibc: equal elements keep their order, which decides about the order of contacts.
void qsort_r(void* elements, size_t count, size_t size, int (*compare)(const void*, const void*, void*), void* context);

#ifdef __cplusplus
}
#endif

#endif
