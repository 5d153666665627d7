// An infant's reflexes in a world: what sets them off is evaluated after every physics step; what they do is added to
// the commands.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "actuation/actuation.h"
#include "base/bytes.h"
#include "body/body.h"
#include "body/face.h"
#include "env/options.h"
#include "env/perception.h"
#include "observation/sense.h"
#include "reflexes/arc.h"
#include "reflexes/pattern.h"
#include "reflexes/table.h"
#include "senses/touch/felt.h"

namespace mimo::env {

// What sets an infant's reflexes off, out of what physics knows: as shares of their thresholds. It needs none of the
// infant's senses. Touches of its own body are none; of what stands still in the world it feels the load, not a touch.

using Sides = std::array<double, reflexes::kSides>;

class Stimuli {
 public:
  // At an age in months. Of reflexes that are not wanted nothing is found out.
  Stimuli(const mjModel& model, const body::Body& body, double months, double tick,
          const std::vector<reflexes::Reflex>& wanted);

  // All has been as it is now for ever.
  void rest(const mjModel& model, const mjData& data);
  // A tick later.
  void take_in(const mjModel& model, const mjData& data);

  const Sides& of(reflexes::Reflex reflex) const { return shares_[static_cast<std::size_t>(reflex)]; }
  // The weight on its feet, N.
  const Sides& load() const { return load_; }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  enum class Part { kNone, kHand, kFoot, kToes, kLowerLeg, kThigh, kHead };
  struct Place {
    Part part = Part::kNone;
    std::size_t side = 0;
    bool own = false;  // of the infant
  };
  using Vec3 = Eigen::Vector3d;

  bool wants(reflexes::Reflex reflex) const { return wanted_[static_cast<std::size_t>(reflex)]; }
  Sides& share(reflexes::Reflex reflex) { return shares_[static_cast<std::size_t>(reflex)]; }
  void mark(const mjModel& model, const std::string& name, Part part, std::size_t side);
  Place place_of(const engine::Meeting& met, std::size_t side) const;
  void find_hands(const mjModel& model);
  void find_legs(const mjModel& model);
  void find_head(const mjModel& model, const body::Body& body);
  void touch(const mjModel& model, const mjData& data);
  void feel(const mjModel& model, const mjData& data, const senses::touch::Press& press);
  void feel_hand(const mjData& data, const senses::touch::Press& press, std::size_t side);
  void feel_foot(const mjModel& model, const mjData& data, const senses::touch::Press& press, const Place& place);
  void feel_leg(const mjModel& model, const senses::touch::Press& press, const Place& place);
  void feel_face(const mjData& data, const senses::touch::Press& press);
  void turn_neck(const mjData& data);
  void drop_head(const mjModel& model, const mjData& data);
  void stand(const mjModel& model, const mjData& data);

  std::string prefix_;
  int root_, head_, trunk_ = -1;
  std::array<bool, reflexes::kReflexes> wanted_{};
  double withdrawal_;          // N, on the sole
  double smoothed_, slow_;     // shares that the two filters of the otoliths' change take in with each tick
  std::vector<Place> places_;  // by body of the model
  std::array<int, reflexes::kSides> hand_{};     // bodies
  std::array<Vec3, reflexes::kSides> palm_;      // where the palm looks, in the hand's frame
  std::array<double, reflexes::kSides> ball_{};  // from there on the foot's ball begins, m along the foot
  body::Mouth mouth_{};
  int swivel_ = -1, tilt_ = -1;  // addresses in qpos and qvel

  std::array<Sides, reflexes::kReflexes> shares_{};
  Sides load_{};
  Vec3 quick_ = Vec3::Zero(), lasting_ = Vec3::Zero();  // what the otoliths feel, smoothed; m/s^2, in the head
};

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
