// Counts the process's memory allocations between start() and stop(), on all threads.
#pragma once

#include <cstdint>

namespace cli {

class Allocations {
 public:
  // False where the program cannot stand between its libraries and malloc: not glibc, or under a sanitizer.
  static bool countable();
  static void start();
  static void stop();
  static std::uint64_t counted();  // in all stretches so far
};

}  // namespace cli
