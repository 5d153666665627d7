#include <stdlib.h>
#include <string.h>

typedef int (*Compare)(const void*, const void*, void*);

// Merges two sorted parts that lie one behind the other. The first is copied away; where both are equal, it goes first.
static void merge(char* elements, size_t first, size_t count, size_t size, Compare compare, void* context, char* copy) {
  char *left = copy, *const end = copy + first * size, *right = elements + first * size;
  char* const last = elements + count * size;
  memcpy(copy, elements, first * size);
  while (left != end) {
    char** const next = right == last || compare(left, right, context) <= 0 ? &left : &right;
    memmove(elements, *next, size);
    *next += size;
    elements += size;
  }
}

static void sort(char* elements, size_t count, size_t size, Compare compare, void* context, char* copy) {
  const size_t first = count / 2;
  if (count < 2) return;
  sort(elements, first, size, compare, context, copy);
  sort(elements + first * size, count - first, size, compare, context, copy);
  merge(elements, first, count, size, compare, context, copy);
}

void qsort_r(void* elements, size_t count, size_t size, Compare compare, void* context) {
  char few[4096];
  const size_t needed = count / 2 * size;
  char* const copy = needed <= sizeof few ? few : malloc(needed);
  if (copy == NULL) abort();
  sort(elements, count, size, compare, context, copy);
  if (copy != few) free(copy);
}
