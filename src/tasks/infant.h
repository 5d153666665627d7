// What tasks read of a simulated infant (positions, contacts, controls), and turning its head and eyes to a point.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "body/body.h"
#include "engine/physics.h"

namespace mimo::tasks {

// Positions of bodies as Eigen sees them.

inline Eigen::Vector3d position(const mjData& data, int body) {
  return Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * body);
}
inline Eigen::Vector3d position(const engine::Physics& physics, int body) { return position(physics.data(), body); }

// The middle of the origins of some bodies, at least one.
inline Eigen::Vector3d center(const mjData& data, const std::vector<int>& bodies) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int body : bodies) sum += position(data, body);
  return sum / static_cast<double>(bodies.size());
}
inline Eigen::Vector3d center(const engine::Physics& physics, const std::vector<int>& bodies) {
  return center(physics.data(), bodies);
}

inline void put(const Eigen::Vector3d& vector, double* out) { Eigen::Map<Eigen::Vector3d>{out} = vector; }

// The thing that a task is about, body "target" of the infant's scene; `task` is its name, `what` what it has to be.
int target_of(const mjModel& model, const body::Body& body, const char* task, const char* what);

// Who touches whom, by the contacts that the last physics step found.

// Whether a contact presses, however weakly: its force is not 0.
bool presses(const mjModel& model, const mjData& data, int contact);

// Whether any of the bodies touches the other one.
bool touches(const engine::Physics& physics, const std::vector<int>& bodies, int other);

// Whether a contact presses on the body, however weakly: what its skin would feel.
bool feels(const engine::Physics& physics, int body);

// What motors are told.

// The sum of their squared control inputs.
inline double squared_controls(const engine::Physics& physics, const std::vector<int>& motors) {
  double sum = 0;
  for (const int motor : motors) sum += physics.data().ctrl[motor] * physics.data().ctrl[motor];
  return sum;
}

// Turns head and eyes to a point, as the original does: the joints are set, not driven.

class Tracking {
 public:
  Tracking(const mjModel& model, const body::Body& body);

  // From where the head is; angles beyond a joint's range are cut to it.
  void look_at(const Eigen::Vector3d& point, engine::Physics& physics) const;
  // Addresses in qpos of the joints that it sets.
  Span<const int> joints() const { return addresses_; }

 private:
  int head_;
  Eigen::Vector3d left_eye_;  // in the head's frame
  std::array<body::Joint, 9> joints_;
  std::array<int, 9> addresses_;
};

}  // namespace mimo::tasks
