// Motors that are told a torque or an angle.
#pragma once

#include "actuation/actuation.h"

namespace mimo::actuation {

// An action is a motor's share of its largest torque; the joints' springs and dampers stand for tissue.

class Torque : public Actuation {
 public:
  // Ranges are the motors' force ranges: a motor may be weaker to one side.
  Torque(const mjModel& model, const body::Body& body, bool normalize);
  void pull(std::size_t motor, double share, double* offsets) const override;
  double effort(const mjModel& model, const mjData& data) const override;

 private:
  Feedback feel(const mjModel& model, const body::Body& body) const override;
  void command(std::size_t index, double value, engine::Physics& physics) override;
  double commanded(std::size_t index, const engine::Physics& physics) const override;

  std::vector<int> actuators_;
};

// Position control: an action is the angle at which a joint is to be. The joint's lock, a soft constraint, is switched
// on and follows the action; the motor itself does nothing. What the lock does to the joint is what muscles would.

class Position : public Actuation {
 public:
  // Ranges are the joints' ranges of motion. Throws Status::kUnsupported for a joint without a lock.
  Position(const mjModel& model, const body::Body& body, bool normalize);
  // Holds every joint where the world starts.
  void reset(engine::Physics& physics) override;
  bool holds(int lock) const override;
  // By that share of the joint's range of motion.
  void pull(std::size_t motor, double share, double* offsets) const override;
  // Locks may be stronger than any muscle: shares above 1.
  bool pulls(const mjData& data, double* shares) const override;
  // Locks cost nothing.
  double effort(const mjModel&, const mjData&) const override { return 0; }

 private:
  // The angles at which joints are held.
  Feedback feel(const mjModel& model, const body::Body& body) const override;
  void command(std::size_t index, double value, engine::Physics& physics) override;
  double commanded(std::size_t index, const engine::Physics& physics) const override;

  // The largest torques of a motor to both sides, the negative one below 0.
  struct Strength {
    double negative, positive;
  };

  std::vector<body::Motor> motors_;
  std::vector<Strength> strengths_;  // as the model was when this was made
  std::vector<int> by_lock_;         // index of a lock's motor; -1: none of these
};

}  // namespace mimo::actuation
