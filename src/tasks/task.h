// What an episode is about for one infant: how it starts, what is rewarded, when it ends.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/random.h"
#include "base/span.h"
#include "body/body.h"
#include "engine/physics.h"
#include "mimo/env.h"
#include "observation/sense.h"

namespace mimo::tasks {

// Numbers by which tasks can be changed: a name such as "reach/success_reward", a default, a range.

struct Parameter {
  const char* name;
  double standard;   // the default
  double low, high;  // allowed values, both included
  const char* description;
};

// Those of all tasks, one after the other.
std::vector<const Parameter*> parameters();
bool is_parameter(const std::string& name);
// With Status::kNotFound; `further` names are known elsewhere.
[[noreturn]] void fail_unknown_parameter(const std::string& name, std::vector<std::string> further = {});

class Settings {
 public:
  // Throws Status::kNotFound for an unknown name, kInvalidArgument for a value out of range.
  void set(const std::string& name, double value);
  // What was set, or the default. Throws Status::kNotFound for an unknown name.
  double operator[](const std::string& name) const;

 private:
  std::map<std::string, double> values_;
};

// A part of the reward; the reward is the sum of all terms.
struct Term {
  const char* name;
  double value;
};

// What happened in a step beside the physics, for its evaluation. It lasts until that is over.
struct Step {
  std::uint64_t number = 0;        // since the reset, with this one
  double effort = 0;               // what its commands cost (actuation::Actuation::effort)
  Span<const float> actions;       // the infant's, within their bounds; empty: the step had none
  Span<const std::uint8_t> block;  // the observation, for tasks that judge it; empty: not requested
};

// Whether a step was a success or a failure.
enum class Outcome : std::int32_t {
  kNone = MIMO_OUTCOME_NONE,
  kSuccess = MIMO_OUTCOME_SUCCESS,
  kFailure = MIMO_OUTCOME_FAILURE,
};

// How an episode opens, in physics steps: some without control, then some in which the infant does
// anything within its bounds, drawn anew for each of them.
struct Opening {
  int still = 0;
  int random = 0;
};

class Task {
 public:
  virtual ~Task() = default;

  // The world is at its start, at rest; the caller computes everything again afterwards.
  virtual void reset(engine::Physics&, Random&) {}
  // What comes then; whatever the infant acts with, and without reflexes. Motors keep their last commands.
  virtual Opening opening() const { return {}; }
  // Before a step: what becomes of the infant's actions. What is returned lasts until the next call.
  virtual Span<const float> disturb(Span<const float> actions, Random&) { return actions; }
  // After each physics step of an environment step, for what may be over when the last one is done.
  virtual void watch(const engine::Physics&) {}
  // Whether the senses come before the evaluation. What such a task tells the infant is added after it.
  virtual bool judges_senses() const { return false; }
  // Before the evaluation.
  void consider(const Step& step) { step_ = step; }
  // After the last physics step: terms and outcome. Positions of bodies are those of that step's start, as in the
  // original.
  virtual void evaluate(const engine::Physics&) {}
  // After the evaluation: what the task itself moves.
  virtual void follow(engine::Physics&) {}
  // What is wanted of the infant and what is so far, in as many numbers, of the data; none where a task has no such
  // thing.
  virtual int goal_size() const { return 0; }
  virtual void goal(const mjData&, double*) const {}
  virtual void achieved(const mjData&, double*) const {}
  // What it adds to the observation. The task outlives them.
  virtual std::vector<observation::Signal> signals(const mjModel&) const { return {}; }

  Span<const Term> terms() const { return terms_; }
  double reward() const;
  Outcome outcome() const;
  // Whether success or failure ends the episode.
  bool over() const { return ends_ && (success_ || failure_); }
  // Whether the task cuts the episode off here.
  bool cut_off() const { return cut_off_; }
  // Steps after which an episode is cut off; 0: never.
  std::uint64_t episode_steps() const { return episode_steps_; }
  // For the start of an episode, before reset.
  void clear();

  // What it remembers of the episode beside the physics: always the same number of bytes. Who overrides these calls
  // them first. A load that throws may leave the task half loaded; the world then loads what was there before.
  virtual void save(ByteWriter& to) const;
  virtual void load(ByteReader& from);

 protected:
  explicit Task(std::vector<Term> terms) : terms_(std::move(terms)) {}

  // No reward, no outcome.
  void withdraw();

  std::vector<Term> terms_;
  std::uint64_t episode_steps_ = 0;
  bool ends_ = false;
  bool cut_off_ = false;
  Step step_;
  bool success_ = false;
  bool failure_ = false;
};

// A kind of task: what a scene or a config names.
struct Definition {
  const char* name;
  Span<const Parameter> parameters;
  std::unique_ptr<Task> (*make)(const mjModel& model, const body::Body& body, const Settings& settings);
};

// All there are: none, reach, standup, selfbody, catch, rollover, selftouch, handregard, behaviour.
Span<const Definition* const> definitions();

// Throws Status::kNotFound for a name that is none; "" is none.
const Definition& definition(const std::string& name);

// Each in the file of its name.
extern const Definition kReach, kStandup, kSelfbody, kCatch, kRollover;
extern const Definition kSelftouch, kHandregard;  // as in BabyBench
extern const Definition kBehaviour;               // what the scene's document describes

}  // namespace mimo::tasks
