// What follows from where a world is now, beside what its last physics step computed from where it started.
#pragma once

#include <memory>
#include <vector>

#include "engine/physics.h"

namespace mimo::engine {

// The world's data, but with poses, and velocities of bodies, of the current positions. The world itself is only read,
// so that several threads can look at one. Throws Status::kSimulation for a world that has failed.
class Present {
 public:
  explicit Present(const Physics& physics);

  const mjData& data() const { return *data_; }

 private:
  std::vector<double> numbers_;
  std::unique_ptr<mjData> data_;  // MuJoCo's struct, whose poses and stack are our own
};

}  // namespace mimo::engine
