// What follows from where a world is now, beside what its last physics step computed from where it started.
#pragma once

#include <memory>
#include <vector>

#include "engine/physics.h"

namespace mimo::engine {

// Looks at worlds of one model. They are only read, so that several threads can look at one.
class Present {
 public:
  // The world's data, but with poses, and velocities of bodies, of the current positions; until the next look. Throws
  // Status::kSimulation for a world that has failed. Allocates the first time.
  const mjData& of(const Physics& physics);
  // The same of somebody else's.
  const mjData& of(const mjModel& model, const mjData& data);
  // For a first look that allocates nothing.
  void make_room(const mjModel& model);

 private:
  std::vector<double> numbers_;
  std::unique_ptr<mjData> data_;  // MuJoCo's struct, whose poses and stack are our own
};

}  // namespace mimo::engine
