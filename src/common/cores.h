// How many threads this process may run at the same time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

#if defined(__linux__)
#include <sched.h>

#include <cerrno>
#include <vector>
#elif defined(_WIN32)
#include <pthread.h>
#endif

namespace mimo {

// The cores that its affinity leaves to the calling thread (taskset, a batch queue, a container's cpuset); where the
// system has no affinity, all of the machine's.
inline std::size_t usable_cores() {
#if defined(__linux__)
  constexpr std::size_t kMostSets = 1024;  // of 1024 cores each; a kernel for more cores refuses fewer sets
  for (std::size_t sets = 1; sets <= kMostSets; sets *= 2) {
    std::vector<cpu_set_t> usable(sets);
    const std::size_t bytes = sets * sizeof(cpu_set_t);
    if (sched_getaffinity(0, bytes, usable.data()) == 0) {
      return std::max<std::size_t>(1, static_cast<std::size_t>(CPU_COUNT_S(bytes, usable.data())));
    }
    if (errno != EINVAL) break;
  }
#elif defined(_WIN32)
  return static_cast<std::size_t>(std::max(1, pthread_num_processors_np()));  // of GetProcessAffinityMask
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace mimo
