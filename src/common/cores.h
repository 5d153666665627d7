// How many threads this process may run at the same time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

#if defined(__linux__)
#include <sched.h>
#elif defined(_WIN32)
#include <pthread.h>
#endif

namespace mimo {

// The cores that its affinity leaves to the calling thread (taskset, a batch queue, a container's cpuset); where the
// system has no affinity, or more cores than a set of them can name, all of the machine's.
inline std::size_t usable_cores() {
#if defined(__linux__)
  cpu_set_t usable;
  if (sched_getaffinity(0, sizeof usable, &usable) == 0) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(CPU_COUNT(&usable)));
  }
#elif defined(_WIN32)
  return static_cast<std::size_t>(std::max(1, pthread_num_processors_np()));  // of GetProcessAffinityMask
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace mimo
