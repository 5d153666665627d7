// What of hearing is wanted.
#pragma once

#include <cstddef>

namespace mimo::senses {

struct HearingOptions {
  bool ears = false;   // hearing/ear_left, hearing/ear_right
  bool bands = false;  // hearing/bands, hearing/time_difference

  bool any() const { return ears || bands; }
};

// How much of what hosts play is remembered.
struct PlayOptions {
  std::size_t sources = 4;  // bodies that play at once
  double seconds = 4;       // of what waits at one of them
};

}  // namespace mimo::senses
