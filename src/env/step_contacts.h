// What touched what in an environment step, also where it began and ended between two looks at the world.
#pragma once

#include <array>
#include <vector>

#include "base/span.h"
#include "engine/contacts.h"
#include "engine/physics.h"

namespace mimo::env {

// A pair of geoms or flexes, over all its contacts. Vectors are in the world frame, forces act on the second body.
struct StepContact {
  std::array<int, 2> geoms, flexes;                         // -1 where it is the other
  std::array<int, 2> bodies;                                // of a flex: where it touched first
  double start, end;                                        // s, since the step began
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();        // N s
  Eigen::Vector3d peak_force = Eigen::Vector3d::Zero();     // N, of the physics step in which it was largest
  Eigen::Vector3d peak_position = Eigen::Vector3d::Zero();  // m, of the strongest contact then
};

class StepContacts {
 public:
  explicit StepContacts(bool wanted) : wanted_(wanted) {}

  bool wanted() const { return wanted_; }
  // Throws Status::kUnsupported where they are not wanted.
  Span<const StepContact> all() const;

  // An environment step begins.
  void begin() {
    elapsed_ = 0;
    pairs_.clear();
  }
  // A physics step was done.
  void add(const engine::Physics& physics);

 private:
  // What one physics step does to a pair.
  struct Now {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    double strongest = -1;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
  };

  std::size_t find(const engine::Meeting& met);

  bool wanted_;
  double elapsed_ = 0;
  std::vector<StepContact> pairs_;
  std::vector<Now> now_;  // of the pairs
};

}  // namespace mimo::env
