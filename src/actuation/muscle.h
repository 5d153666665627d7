// Muscles: two antagonists turn each joint, one to its negative and one to its positive side. An action is the
// activation that a muscle is told to have. Both may pull at once, which stiffens the joint.
//
// Lengths are normalised and grow linearly with the joint's angle, in opposite directions, by how far the joint goes at
// 18 months (body::muscle_range). Torques go to the joint's motor, freed from its limits; the joint loses its spring,
// and nearly all of its damper, which stand for muscles elsewhere.
#pragma once

#include "actuation/actuation.h"

namespace mimo::actuation::curves {

// Force curves of the original MIMo's muscle model. Forces are shares of a muscle's peak force; length 1 is where it
// pulls best, velocity -1 is its fastest shortening.

// Lengths at and beyond which activation gives no force.
constexpr double kShortest = 0.5, kLongest = 1.6;
// Factor of the active force of a muscle that is stretched fast.
constexpr double kStretched = 1.2;
// Scale of the passive force.
constexpr double kPassive = 1.3;
// Lengths at the two ends of the joint's range of motion.
constexpr double kAtShortEnd = 0.75, kAtLongEnd = 1.05;

// Active force over length.
double force_length(double length);
// Factor of the active force over velocity; a positive one stretches.
double force_velocity(double velocity);
// Force of a stretched muscle without activation.
double passive_force(double length);

}  // namespace mimo::actuation::curves

namespace mimo::actuation {

class Muscle : public Actuation {
 public:
  // Throws Status::kUnsupported for a motor without the numbers of its muscles (see models/README.md).
  Muscle(const mjModel& model, const body::Body& body, bool normalize);

  void reset(engine::Physics& physics) override;
  void advance(engine::Physics& physics) override;
  // With the muscle of that side alone.
  void pull(std::size_t motor, double share, double* offsets) const override;
  bool pulls(const mjData& data, double* shares) const override;
  double effort(const mjModel& model, const mjData& data) const override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 protected:
  // One of the two muscles of a joint.
  struct Side {
    double slope = 0;   // length gained with the angle, 1/rad; also the lever by which force becomes torque
    double offset = 0;  // length where the spring rests
    double peak_force = 0;
    double activation = 0;
    double target = 0;
  };

 private:
  struct Joint {
    body::Joint joint;
    int motor = 0;
    double gear = 0;
    double rest = 0;     // angle, rad
    double fastest = 0;  // shortening velocity, lengths a second
    Side sides[2] = {};  // pulls to the negative side, to the positive side
  };
  struct Damper {
    int joint, dof;
    double damping;
  };

  virtual double activated(const Side& side, double seconds) const = 0;
  // What it pulls with, in torque per unit of slope.
  virtual double force(const Side& side, double length, double velocity, double fastest) const = 0;

  Feedback feel(const mjModel& model, const body::Body& body) const override;
  void command(std::size_t index, double value, engine::Physics& physics) override;
  double commanded(std::size_t index, const engine::Physics& physics) const override;
  const Joint& joint(std::size_t action) const { return joints_[action % joints_.size()]; }
  double force(const Joint& joint, const Side& side, const mjData& data) const;
  Side& side(std::size_t action) { return joints_[action % joints_.size()].sides[action / joints_.size()]; }
  const Side& side(std::size_t action) const { return const_cast<Muscle*>(this)->side(action); }

  std::vector<Joint> joints_;
  std::vector<Damper> dampers_;  // of all of the infant's joints, also those without motor
};

// The original MIMo's model.
class MimoMuscle : public Muscle {
 public:
  using Muscle::Muscle;

 private:
  double activated(const Side& side, double seconds) const override;
  double force(const Side& side, double length, double velocity, double fastest) const override;
};

// MuJoCo's built-in model with the same lengths, velocities and peak forces.
class MujocoMuscle : public Muscle {
 public:
  using Muscle::Muscle;

 private:
  double activated(const Side& side, double seconds) const override;
  double force(const Side& side, double length, double velocity, double fastest) const override;
};

}  // namespace mimo::actuation
