#define _GNU_SOURCE
#include "faults/failing.h"

#include <errno.h>
#include <execinfo.h>
#include <pthread.h>
#include <stdint.h>
#include <string.h>

/* The C library's own, under the names that it has for this purpose. */
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
void __libc_free(void* block);

enum { SLOTS = 1 << 16 };

static allocation slots[SLOTS]; /* hashed by address; linear probing, block 1 marks a slot that was in use */
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static int watching, failed, fail_forever;
static long counted, fail_number;
static void* const kGone = (void*)1;
static __thread int inside;

static size_t slot_of(const void* block) { return (size_t)(((uintptr_t)block >> 4) * 0x9e3779b97f4a7c15u >> 48); }

static void keep(void* block, size_t size, long number, void* const* frames, int frame_count) {
  size_t at = slot_of(block);
  while (slots[at].block != NULL && slots[at].block != kGone) at = (at + 1) % SLOTS;
  slots[at].block = block;
  slots[at].size = size;
  slots[at].number = number;
  slots[at].frame_count = frame_count;
  memcpy(slots[at].frames, frames, sizeof slots[at].frames);
}

static void forget(const void* block) {
  size_t at = slot_of(block);
  for (; slots[at].block != NULL; at = (at + 1) % SLOTS) {
    if (slots[at].block != block) continue;
    slots[at].block = kGone;
    return;
  }
}

/* Counts an allocation; 0: it is to fail. Fills in its number. */
static int admit(long* number) {
  int good = 1;
  *number = 0;
  if (!watching || inside) return 1;
  pthread_mutex_lock(&mutex);
  if (watching) {
    *number = ++counted;
    good = fail_number == 0 || counted < fail_number || (counted > fail_number && !fail_forever);
    if (!good) failed = 1;
  }
  pthread_mutex_unlock(&mutex);
  if (!good) errno = ENOMEM;
  return good;
}

static void* admitted(void* block, size_t size, long number) {
  void* frames[MOST_FRAMES];
  int frame_count;
  if (number == 0 || block == NULL) return block;
  inside = 1;
  frame_count = backtrace(frames, MOST_FRAMES);
  inside = 0;
  pthread_mutex_lock(&mutex);
  keep(block, size, number, frames, frame_count);
  pthread_mutex_unlock(&mutex);
  return block;
}

static void released(const void* block) {
  if (block == NULL || counted == 0) return;
  pthread_mutex_lock(&mutex);
  forget(block);
  pthread_mutex_unlock(&mutex);
}

void* malloc(size_t size) {
  long number;
  return admit(&number) ? admitted(__libc_malloc(size), size, number) : NULL;
}

void* calloc(size_t count, size_t size) {
  long number;
  return admit(&number) ? admitted(__libc_calloc(count, size), count * size, number) : NULL;
}

void* realloc(void* block, size_t size) {
  long number;
  if (!admit(&number)) return NULL;
  released(block);
  return admitted(__libc_realloc(block, size), size, number);
}

void free(void* block) {
  released(block);
  __libc_free(block);
}

void* memalign(size_t alignment, size_t size) {
  long number;
  return admit(&number) ? admitted(__libc_memalign(alignment, size), size, number) : NULL;
}

void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }

int posix_memalign(void** block, size_t alignment, size_t size) {
  void* made = memalign(alignment, size);
  if (made == NULL) return ENOMEM;
  *block = made;
  return 0;
}

void watch_begin(long fail_at, int forever) {
  void* warm[1];
  backtrace(warm, 1); /* allocates the first time */
  memset(slots, 0, counted == 0 ? 0 : sizeof slots);
  counted = 0;
  failed = 0;
  fail_number = fail_at;
  fail_forever = forever;
  watching = 1;
}

void watch_end(void) { watching = 0; }
long watch_count(void) { return counted; }
int watch_failed(void) { return failed; }

void watch_lost(void (*visit)(const allocation* lost, void* user), void* user) {
  size_t i;
  for (i = 0; i < SLOTS; ++i) {
    if (slots[i].block != NULL && slots[i].block != kGone) visit(&slots[i], user);
  }
}
