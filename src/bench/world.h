// A world with all its senses as users run it, step by step under the clock.
#pragma once

#include "bench/physics.h"
#include "programs/world.h"

namespace cli {

class FullWorld {
 public:
  FullWorld(const WorldOptions& options, std::size_t steps);

  // The first step of a world makes what later ones reuse; it is not measured.
  void warm_up(const Actions& actions);
  void run(const Actions& actions);
  void reset(std::uint64_t seed);

  const mimo::Env& env() const { return env_; }
  const Samples& times() const { return times_; }
  std::size_t contacts() const { return contacts_; }

 private:
  mimo::Env env_;
  mimo::Block block_;
  mimo::Results results_;
  Samples times_;
  std::size_t contacts_ = 0;
};

}  // namespace cli
