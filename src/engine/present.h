// What follows from where a world is now: poses, motion of places on bodies, and forces of muscles.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "engine/model.h"
#include "engine/physics.h"

namespace mimo::engine {

// What follows from where a world is now, beside what its last physics step computed from where it started.

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

typedef struct mjData_ mjData;

namespace mimo::engine {

// How places on bodies move: what MuJoCo's sensors would say if the model had any there.

// A site, or a body's own frame.
struct Place {
  Kind kind;  // kSite or kBody
  int id;
};

// In the place's own frame, as the last forward dynamics computed them.
struct Motion {
  Eigen::Vector3d acceleration;          // proper: what an accelerometer reads, m/s^2
  Eigen::Vector3d angular_velocity;      // rad/s
  Eigen::Vector3d angular_acceleration;  // rad/s^2
};

Motion motion_of(const mjModel& model, const mjData& data, const Place& place);

// What an accelerometer reads at a point of a body that moves so, given from the place, in its frame.
Eigen::Vector3d acceleration_at(const Motion& motion, const Eigen::Vector3d& point);

// MuJoCo's own muscle model, as functions.

struct MuscleShape {
  double short_end, long_end;  // normalised lengths at the ends of the range, which are their own scale
  double peak_force;
  double shortest, longest;  // lengths beyond which activation gives no force
  double fastest;            // shortening velocity, lengths a second
  double passive;            // passive force at the longest length, in peak forces
  double stretched;          // factor of the active force of a muscle that is stretched fast
};

// Active force at full activation and passive force; positive where the muscle pulls.
double muscle_active_force(const MuscleShape& shape, double length, double velocity);
double muscle_passive_force(const MuscleShape& shape, double length);

// Rate of the activation, 1/s, for a control signal from 0 to 1: it rises with one time constant (s) and falls with the
// other, both stretched or shortened by the activation itself.
double muscle_activation_rate(double control, double activation, double rise, double fall);

}  // namespace mimo::engine
