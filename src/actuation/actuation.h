// From an agent's slice of the actions to motor commands.
#pragma once

#include <mujoco/mjdata.h>

#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/span.h"
#include "body/body.h"

namespace mimo::actuation {

class Actuation {
 public:
  virtual ~Actuation() = default;

  std::size_t size() const { return low_.size(); }
  const std::vector<float>& low() const { return low_; }
  const std::vector<float>& high() const { return high_; }
  const std::vector<std::string>& names() const { return names_; }

  // Sets the controls for the coming step; actions are finite and are clipped to their bounds.
  virtual void apply(Span<const float> actions, mjData& data) const = 0;

  // What it remembers beside the physics: always the same number of bytes. A load that throws may leave it half
  // loaded; the world then loads what was there before.
  virtual void save(ByteWriter&) const {}
  virtual void load(ByteReader&) {}

 protected:
  std::vector<float> low_, high_;
  std::vector<std::string> names_;
};

// Spring-damper muscles: an action is a motor's share of its largest torque, the joints' springs and dampers do the
// rest. Bounds are the actuators' force ranges.
class Torque : public Actuation {
 public:
  Torque(const mjModel& model, const body::Body& body);
  void apply(Span<const float> actions, mjData& data) const override;

 private:
  std::vector<int> actuators_;
};

}  // namespace mimo::actuation
