// How an episode starts, of worlds and of attached senses.
#pragma once

#include <cstdint>
#include <optional>

#include "capi/check.h"
#include "capi/structs.h"

namespace mimo::capi {

// None: the random numbers go on.
struct Seed {
  std::optional<std::uint64_t> value;
  const std::uint64_t* pointer() const { return value ? &*value : nullptr; }
};

inline Seed seed_of(const mimo_reset_config& ours) {
  check_flag(ours.seeded, "seeded");
  require(ours.seeded != 0 || ours.seed == 0, "seed is {}, but seeded is 0, expected 1", ours.seed);
  if (ours.seeded == 0) return {};
  return {ours.seed};
}

}  // namespace mimo::capi
