// An infant's reflexes in a world: what sets them off is looked at after every physics step, and what they do is added
// to the agent's commands before every one.
#pragma once

#include <vector>

#include "actuation/additions.h"
#include "env/options.h"
#include "env/perception.h"
#include "env/stimuli.h"
#include "observation/process.h"
#include "observation/signals.h"
#include "reflexes/arc.h"
#include "reflexes/pattern.h"

namespace mimo::env {

class Reflexes : public observation::Process {
 public:
  // Throws Status::kUnsupported for a reflex that the body cannot do. The agent's body and actuation outlive it.
  Reflexes(const mjModel& model, const Perception& agent, const AgentOptions& options, double tick);

  // How strong they are: reflex/activation. Refers to this object.
  observation::Signal signal() const;

  // The agent's actions have just been applied; what is no number was none.
  void follow(Span<const float> actions, const engine::Physics& physics) { additions_.follow(actions, physics); }
  // Before a physics step.
  void act(engine::Physics& physics);

 private:
  struct Pulled {
    reflexes::Pull pull;
    std::size_t motor;
  };
  // A reflex of one side.
  struct One {
    reflexes::Reflex reflex;
    reflexes::Side side;
    double gain;  // by age
    reflexes::Arc arc;
    std::vector<Pulled> pulls;
    bool leads = false;  // of legs that step: this one is lifted first
  };

  void rest(const mjModel& model, const mjData& data) override;
  void go_on(const mjModel& model, const mjData& data) override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

  void tell(float* out) const;
  double activation(const One& one) const;
  bool pull();

  std::vector<reflexes::Reflex> felt_;  // that the field tells of
  double months_;
  std::vector<One> ones_;  // those that act, in the same order, of each left and right
  Stimuli stimuli_;
  actuation::Additions additions_;
  std::vector<double> shares_;  // one for each motor
};

// Null for an agent without any.
std::unique_ptr<Reflexes> make_reflexes(const mjModel& model, const Perception& agent, const AgentOptions& options,
                                        double tick);

}  // namespace mimo::env
