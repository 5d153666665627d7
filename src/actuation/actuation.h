// From an agent's slice of the actions to motor commands.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/span.h"
#include "body/body.h"
#include "mimo/agent.h"
#include "observation/sense.h"

namespace mimo::actuation {

// What an infant feels of its own commands.

struct Feedback {
  std::vector<observation::Signal> commands;  // what its motors are told; a part of proprioception
  std::vector<observation::Signal> exertion;  // how its muscles work, and what that costs; after all other senses
};

// A field with one number for each of some actuators.
observation::Field actuator_field(const mjModel& model, const std::vector<int>& actuators, const char* name);

// Of the header.
enum class Mode : std::int32_t {
  kTorque = MIMO_ACTUATION_TORQUE,
  kPosition = MIMO_ACTUATION_POSITION,
  kMuscle = MIMO_ACTUATION_MUSCLE,
  kMujocoMuscle = MIMO_ACTUATION_MUJOCO_MUSCLE,
};

inline bool is_muscle(Mode mode) { return mode == Mode::kMuscle || mode == Mode::kMujocoMuscle; }

struct Options {
  Mode mode = Mode::kTorque;
  bool normalize = false;  // actions from -1 to 1 are mapped to the bounds, linearly
  bool none = false;       // the agent leaves its actuators to others
};

class Actuation {
 public:
  virtual ~Actuation() = default;

  std::size_t size() const { return low_.size(); }
  // Bounds of the actions; what lies outside is clipped.
  const std::vector<float>& low() const { return low_; }
  const std::vector<float>& high() const { return high_; }
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<const char*>& units() const { return units_; }  // static strings

  // Of them, first those that command motors; then those that set numbers of others.
  std::size_t commands() const { return low_.size() - controls_.size(); }
  // One action more, which sets a number of somebody else's: after all that command motors.
  void add_control(std::string name, double low, double high, const char* unit, std::shared_ptr<double> number);

  // Whether its actions move this lock.
  virtual bool holds(int) const { return false; }
  // The world has been reset to its start.
  virtual void reset(engine::Physics&) {}
  // Sets the commands for the coming step; actions are finite, or NaN for a command that stays as it is.
  void apply(Span<const float> actions, engine::Physics& physics);
  // Before each physics step, for what changes between actions.
  virtual void advance(engine::Physics&) {}

  // Of two muscles a motor, first those that pull to the negative side, the share of their largest force that they
  // pull with now; false where there are no such muscles.
  virtual bool pulls(const mjData&, double*) const { return false; }

  // What it takes in each action's command to pull a motor with that share of all it can do to that side, -1 to 1; is
  // added to one number for each command.
  virtual void pull(std::size_t motor, double share, double* offsets) const = 0;

  // What the present commands cost, 0 to 1: their squares, weighted by the strength of the motors.
  virtual double effort(const mjModel& model, const mjData& data) const = 0;
  // What the options want the agent to feel of its commands. This object outlives it.
  Feedback feedback(const mjModel& model, const body::Body& body, std::uint32_t felt) const;

  // What it remembers beside the physics: always the same number of bytes. A load that throws may leave it half
  // loaded; the world then loads what was there before.
  virtual void save(ByteWriter&) const {}
  virtual void load(ByteReader&) {}

 protected:
  struct Range {
    double low, high;
  };
  // Of the command of an action, in the order of the actions.
  const Range& range(std::size_t index) const { return ranges_[index]; }

  explicit Actuation(bool normalize) : normalize_(normalize) {}
  // One action after the other: its name, the range of its command, and its unit, "" for a share.
  void add(std::string name, double low, double high, const char* unit = "");

 private:
  friend class Additions;
  // All that there is to feel, of all actuators of a body: also of those that are left to others.
  virtual Feedback feel(const mjModel& model, const body::Body& body) const = 0;
  virtual void command(std::size_t index, double value, engine::Physics& physics) = 0;
  // What was commanded last, by whomever.
  virtual double commanded(std::size_t index, const engine::Physics& physics) const = 0;

  bool normalize_;
  std::vector<Range> ranges_;
  std::vector<std::shared_ptr<double>> controls_;
  std::vector<float> low_, high_;
  std::vector<std::string> names_;
  std::vector<const char*> units_;
};

std::unique_ptr<Actuation> make_actuation(const mjModel& model, const body::Body& body, const Options& options);

// What is added to an agent's commands on their way into its motors, by something in its body that it did not ask:
// reflexes. Nothing adds up to more than a motor can do, and a joint that a lock holds is left alone. The commands
// themselves come back when nothing is added any more, or what was commanded meanwhile.

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
