// What is added to an agent's commands on their way into its motors, by something in its body that it did not ask:
// reflexes. Nothing adds up to more than a motor can do, and a joint that a lock holds is left alone. The commands
// themselves come back when nothing is added any more, or what was commanded meanwhile.
#pragma once

#include <vector>

#include "actuation/actuation.h"

namespace mimo::actuation {

class Additions {
 public:
  // The actuation outlives it.
  Additions(const mjModel& model, const body::Body& body, Actuation& actuation);

  std::size_t motors() const { return locks_.size(); }
  // Nothing has been added.
  void forget() { adding_ = false; }
  // The agent's actions have just been applied; what is no number was none.
  void follow(Span<const float> actions, const engine::Physics& physics);
  // For the coming physics step: for each motor a share of what it can do, -1 to 1.
  void add(Span<const double> shares, engine::Physics& physics);
  // Nothing, for the coming physics step.
  void stop(engine::Physics& physics);

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  void set(std::size_t action, double offset, engine::Physics& physics);
  bool held(std::size_t motor, const mjModel& model) const;

  Actuation& actuation_;
  std::vector<int> locks_;       // of the motors' joints; -1: none
  std::vector<double> offsets_;  // one for each command of an action
  bool adding_ = false;
  std::vector<double> asked_;  // what the agent commands, of each
  std::vector<double> given_;  // what stands there with the addition
};

}  // namespace mimo::actuation
