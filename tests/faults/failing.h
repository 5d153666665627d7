/* malloc and its family in place of the C library's, for the whole process: they can be told to fail, and remember what
 * was allocated since, where, and whether it is still there. */
#ifndef MIMO_TESTS_FAULTS_FAILING_H
#define MIMO_TESTS_FAULTS_FAILING_H

#include <stddef.h>

enum { MOST_FRAMES = 20 };

typedef struct allocation {
  void* block;
  size_t size;
  long number;
  int frame_count;
  void* frames[MOST_FRAMES]; /* the stack, innermost first */
} allocation;

/* From now on allocations are counted and kept track of, until watch_end(). The fail_at-th fails, and with `forever`
 * all after it; 0: none. */
void watch_begin(long fail_at, int forever);
void watch_end(void);

long watch_count(void); /* allocations seen */
int watch_failed(void); /* whether one was made to fail */

/* Calls visit for each block that was allocated while watching and is still there. */
void watch_lost(void (*visit)(const allocation* lost, void* user), void* user);

#endif
