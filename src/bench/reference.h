// The unit of time of the benchmarks: one bare physics step of the benchmark scene as the original solves it (dense
// Jacobian), on Debian's build of MuJoCo.
#pragma once

#include <memory>

#include "bench/physics.h"
#include "programs/world.h"

namespace cli {

// Measured here where libmimo runs on Debian's MuJoCo, else in a child process that does. Where Debian's is not
// installed there are no samples.
class Reference {
 public:
  Reference(std::uint64_t seed, std::size_t room);
  ~Reference();

  void run(std::size_t steps);  // environment steps, with random actions
  void warm_up();
  const Samples& times() const { return times_; }

 private:
  class Here;
  class Child;

  std::unique_ptr<Here> here_;
  std::unique_ptr<Child> child_;
  Samples times_;
};

// What the child does, until its standard input ends.
void serve_reference(std::uint64_t seed);

}  // namespace cli
