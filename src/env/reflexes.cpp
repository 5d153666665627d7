#include "env/reflexes.h"

#include <algorithm>

#include "base/bits.h"
#include "base/delay.h"
#include "base/fail.h"
#include "body/nerves.h"
#include "engine/flexes.h"
#include "growth/conduction.h"

namespace mimo::env {
namespace {

using reflexes::Limb;
using reflexes::Pull;
using reflexes::Reflex;
using reflexes::Side;

constexpr Side kBoth[] = {Side::kLeft, Side::kRight};

// Where a motor stands among the agent's; -1 for one that it does not have.
int motor_of(const mjModel& model, const Perception& agent, const Pull& pull, Side side) {
  const std::string name = agent.body.prefix + reflexes::motor_name(pull, side);
  const int id = engine::find(model, engine::Kind::kActuator, name.c_str());
  const std::vector<int>& motors = agent.body.actuators;
  const auto found = std::find(motors.begin(), motors.end(), id);
  return agent.actuation->commands() == 0 || found == motors.end() ? -1 : static_cast<int>(found - motors.begin());
}

// The motor that it would need; empty where the body can do it.
std::string lacking(const mjModel& model, const Perception& agent, Reflex reflex) {
  for (const Side side : kBoth) {
    for (const Pull& pull : reflexes::pattern(reflex)) {
      if (pull.needed && motor_of(model, agent, pull, side) < 0) return reflexes::motor_name(pull, side);
    }
  }
  return {};
}

std::vector<Reflex> wanted(const mjModel& model, const Perception& agent, const ReflexOptions& options) {
  std::vector<Reflex> reflexes;
  for (std::size_t i = 0; i < reflexes::kReflexes; ++i) {
    const auto reflex = static_cast<Reflex>(i);
    if (!has_bit(options.wanted, reflexes::rule(reflex).bit)) continue;
    const std::string motor = lacking(model, agent, reflex);
    if (motor.empty()) reflexes.push_back(reflex);
    if (motor.empty() || options.where_possible) continue;
    fail(Status::kUnsupported, "reflexes: this body cannot do \"{}\": it has no motor \"{}\"",
         reflexes::rule(reflex).name, motor);
  }
  return reflexes;
}

std::vector<Reflex> felt(const mjModel& model, const Perception& agent, const ReflexOptions& options) {
  if (!options.felt) return wanted(model, agent, options);
  std::vector<Reflex> reflexes;
  for (std::size_t i = 0; i < reflexes::kReflexes; ++i) {
    const auto reflex = static_cast<Reflex>(i);
    if (lacking(model, agent, reflex).empty()) reflexes.push_back(reflex);
  }
  return reflexes;
}

// Where its stimulus is felt.
std::string place_of(Reflex reflex, Side side) {
  const std::string its = reflexes::kSideNames[static_cast<std::size_t>(side)];
  switch (reflex) {
    case Reflex::kPalmarGrasp: return its + "_hand";
    case Reflex::kPlantarGrasp:
    case Reflex::kStepping:
    case Reflex::kWithdrawal: return its + "_foot";
    case Reflex::kRooting:
    case Reflex::kMoro:
    case Reflex::kTonicNeck: break;
  }
  return "head";
}

// To the farthest part that it moves.
double motor_length(const mjModel& model, const body::Body& body, Reflex reflex, Side side,
                    const std::vector<double>& lengths) {
  double farthest = 0;
  for (const Pull& pull : reflexes::pattern(reflex)) {
    const std::string name = body.prefix + reflexes::motor_name(pull, side);
    const int motor = engine::find(model, engine::Kind::kActuator, name.c_str());
    if (pull.needed) farthest = std::max(farthest, lengths[static_cast<std::size_t>(body::moved_by(model, motor))]);
  }
  return farthest;
}

}  // namespace

Reflexes::Reflexes(const mjModel& model, const Perception& agent, const AgentOptions& options, double tick)
    : Process("reflexes"),
      felt_(felt(model, agent, options.reflexes)),
      months_(options.growth.physiological_age),
      stimuli_(model, agent.body, months_, tick, wanted(model, agent, options.reflexes)),
      additions_(model, agent.body, *agent.actuation),
      shares_(additions_.motors()) {
  engine::require_told_forces(model);
  const std::vector<double> lengths = body::nerve_lengths(model, agent.body);
  const growth::Conduction nerves = growth::conduction_at(months_);
  for (const Reflex reflex : wanted(model, agent, options.reflexes)) {
    const reflexes::Rule& rule = reflexes::rule(reflex);
    for (const Side side : kBoth) {
      const int felt = engine::find_or_fail(model, engine::Kind::kBody, agent.body.prefix + place_of(reflex, side));
      const double seconds = reflexes::latency(rule, nerves, lengths[static_cast<std::size_t>(felt)],
                                               motor_length(model, agent.body, reflex, side, lengths));
      One one{reflex, side, reflexes::gain(rule, months_), {rule, steps_of_delay(seconds, tick), tick}, {}};
      for (const Pull& pull : reflexes::pattern(reflex)) {
        const int motor = motor_of(model, agent, pull, side);
        if (motor >= 0) one.pulls.push_back({pull, static_cast<std::size_t>(motor)});
      }
      ones_.push_back(std::move(one));
    }
  }
}

observation::Signal Reflexes::signal() const {
  observation::Field field;
  field.name = "reflex/activation";
  field.shape = {felt_.size(), reflexes::kSides};
  field.time = observation::Time::kEnd;
  field.low = 0;
  field.high = 1;
  for (const Reflex reflex : felt_) {
    for (const Side side : kBoth) {
      field.labels.push_back(reflexes::rule(reflex).name +
                             ("/" + std::string(reflexes::kSideNames[static_cast<std::size_t>(side)])));
    }
  }
  return {field, [this](const mjModel&, const mjData&, float* out) { tell(out); }};
}

// Both lists are in the order of reflexes.
void Reflexes::tell(float* out) const {
  auto one = ones_.begin();
  for (const Reflex reflex : felt_) {
    const bool acts = one != ones_.end() && one->reflex == reflex;
    for (std::size_t side = 0; side < reflexes::kSides; ++side) {
      *out++ = acts ? static_cast<float>(activation(*one++)) : 0.0F;
    }
  }
}

double Reflexes::activation(const One& one) const {
  const double all = one.gain * one.arc.activation();
  return one.reflex == Reflex::kStepping ? all * reflexes::swing(one.arc.seconds(), one.leads) : all;
}

// Whether any of them does anything now.
bool Reflexes::pull() {
  std::fill(shares_.begin(), shares_.end(), 0.0);
  bool any = false;
  for (const One& one : ones_) {
    const double strength = activation(one) * reflexes::rule(one.reflex).amplitude;
    if (strength == 0) continue;
    any = true;
    for (const Pulled& pulled : one.pulls) {
      shares_[pulled.motor] += strength * reflexes::share(pulled.pull, one.side, one.arc.seconds(), months_);
    }
  }
  return any;
}

void Reflexes::act(engine::Physics& physics) {
  if (begun() && pull()) {
    additions_.add(shares_, physics);
  } else {
    additions_.stop(physics);
  }
}

void Reflexes::rest(const mjModel& model, const mjData& data) {
  stimuli_.rest(model, data);
  additions_.forget();
  for (One& one : ones_) one.arc.rest();
}

void Reflexes::go_on(const mjModel& model, const mjData& data) {
  stimuli_.take_in(model, data);
  const Sides& load = stimuli_.load();
  for (One& one : ones_) {
    const auto side = static_cast<std::size_t>(one.side);
    // The foot that bears less is lifted first.
    const bool lighter = load[side] < load[1 - side] || (load[0] == load[1] && one.side == Side::kLeft);
    if (one.arc.activation() == 0) one.leads = lighter;
    one.arc.advance(stimuli_.of(one.reflex)[side]);
  }
}

void Reflexes::save(ByteWriter& to) const {
  stimuli_.save(to);
  additions_.save(to);
  for (const One& one : ones_) {
    one.arc.save(to);
    to.put(one.leads);
  }
}

void Reflexes::load(ByteReader& from) {
  stimuli_.load(from);
  additions_.load(from);
  for (One& one : ones_) {
    one.arc.load(from);
    one.leads = from.take_flag();
  }
}

std::unique_ptr<Reflexes> make_reflexes(const mjModel& model, const Perception& agent, const AgentOptions& options,
                                        double tick) {
  if (felt(model, agent, options.reflexes).empty()) return nullptr;
  return std::make_unique<Reflexes>(model, agent, options, tick);
}

}  // namespace mimo::env
