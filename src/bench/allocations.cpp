#include <atomic>
#include <cstdlib>

#include "bench/measurements.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define MIMO_CLI_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MIMO_CLI_SANITIZED
#endif
#if defined(__GLIBC__) && !defined(MIMO_CLI_SANITIZED)
#define MIMO_CLI_COUNTS_ALLOCATIONS
#endif

namespace {

std::atomic<bool> counting{false};
std::atomic<std::uint64_t> allocations{0};

}  // namespace

namespace cli {

#if defined(MIMO_CLI_COUNTS_ALLOCATIONS)
bool AllocationCounter::countable() { return true; }
#else
bool AllocationCounter::countable() { return false; }
#endif
void AllocationCounter::start() { counting = true; }
void AllocationCounter::stop() { counting = false; }
std::uint64_t AllocationCounter::counted() { return allocations; }

}  // namespace cli

#if defined(MIMO_CLI_COUNTS_ALLOCATIONS)

// The dynamic linker looks into the program before it looks into libc, so these functions get every call, also
// those of shared libraries and of operator new. They hand on to glibc's own functions; free() stays glibc's.
extern "C" {

void* libc_malloc(std::size_t size) __asm__("__libc_malloc");
void* libc_calloc(std::size_t count, std::size_t size) __asm__("__libc_calloc");
void* libc_realloc(void* memory, std::size_t size) __asm__("__libc_realloc");
void* libc_memalign(std::size_t alignment, std::size_t size) __asm__("__libc_memalign");

static void count_allocation() {
  if (counting.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
}

#define MIMO_CLI_INTERPOSE __attribute__((visibility("default"), used))

MIMO_CLI_INTERPOSE void* malloc(std::size_t size) noexcept {
  count_allocation();
  return libc_malloc(size);
}

MIMO_CLI_INTERPOSE void* calloc(std::size_t count, std::size_t size) noexcept {
  count_allocation();
  return libc_calloc(count, size);
}

MIMO_CLI_INTERPOSE void* realloc(void* memory, std::size_t size) noexcept {
  count_allocation();
  return libc_realloc(memory, size);
}

MIMO_CLI_INTERPOSE void* memalign(std::size_t alignment, std::size_t size) noexcept {
  count_allocation();
  return libc_memalign(alignment, size);
}

MIMO_CLI_INTERPOSE void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}

// Zero, or the error number 12 (ENOMEM) or 22 (EINVAL).
MIMO_CLI_INTERPOSE int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  if (alignment % sizeof(void*) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0) return 22;
  void* result = memalign(alignment, size);
  if (result == nullptr) return 12;
  *memory = result;
  return 0;
}

}  // extern "C"

#endif
