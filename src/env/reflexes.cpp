#include "env/reflexes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "body/body.h"
#include "engine/contacts.h"
#include "engine/present.h"
#include "growth/maturity.h"
#include "receptors/labyrinth.h"

namespace mimo::env {
namespace {

using engine::Kind;
using reflexes::kSideNames;
using reflexes::kSides;
using reflexes::Reflex;
using senses::touch::Press;
using Vec3 = Eigen::Vector3d;
using Rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kG = 9.81;  // m/s^2

// Moro. A neck that is thrown back so fast; and how quickly what the otoliths feel has to change: by 0.3 g in less than
// 0.1 s. It is what a mean over 0.02 s differs by from one over 0.1 s, which for a jump is at most 0.535 of it.
constexpr double kThrownBack = 2;                // rad/s
constexpr double kQuick = 0.02, kLasting = 0.1;  // s
constexpr double kDropped = 0.3 * kG * 0.535;    // m/s^2

// Stepping: how much of its weight the feet bear, and how the trunk stands.
constexpr double kBorne = 0.1;                                // of the weight
constexpr double kLeast = 5 * kDegree, kMost = 45 * kDegree;  // leaning forward
constexpr double kSideways = 30 * kDegree;
// How near to a corner of the mouth, as seen from the head's middle.
constexpr double kCorner = 20 * kDegree;
// Of the way from the ankle to the toes: from there on it is the ball of the foot.
constexpr double kBall = 0.65;

Rotation rotation(const mjData& data, int body) { return Rotation(data.xmat + 9 * body); }

// What stands still: the world, and what is fixed on it; a mocap body is moved by its host.
bool stands_still(const mjModel& model, int body) {
  const int welded = model.body_weldid[body];
  return welded == 0 && model.body_mocapid[model.body_rootid[body]] < 0;
}

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

Stimuli::Stimuli(const mjModel& model, const body::Body& body, double months, double tick,
                 const std::vector<Reflex>& wanted)
    : prefix_(body.prefix),
      root_(body.root),
      head_(body.head),
      withdrawal_(reflexes::withdrawal_force(months)),
      smoothed_(1 - fixed::exp(-tick / kQuick)),
      slow_(1 - fixed::exp(-tick / kLasting)),
      places_(static_cast<std::size_t>(model.nbody)) {
  for (const Reflex reflex : wanted) wanted_[static_cast<std::size_t>(reflex)] = true;
  for (const int own : body.bodies) places_[static_cast<std::size_t>(own)].own = true;
  palm_.fill(Vec3::Zero());
  trunk_ = engine::find(model, Kind::kBody, (prefix_ + "upper_body").c_str());
  if (wants(Reflex::kPalmarGrasp)) find_hands(model);
  if (wants(Reflex::kPlantarGrasp) || wants(Reflex::kStepping) || wants(Reflex::kWithdrawal)) find_legs(model);
  find_head(model, body);
}

void Stimuli::mark(const mjModel& model, const std::string& name, Part part, std::size_t side) {
  const int body = engine::find(model, Kind::kBody, (prefix_ + kSideNames[side] + "_" + name).c_str());
  if (body >= 0) places_[static_cast<std::size_t>(body)] = {part, side, true};
}

// The palm looks to where fingers bend.
void Stimuli::find_hands(const mjModel& model) {
  for (std::size_t side = 0; side < kSides; ++side) {
    for (const char* name : {"hand", "ffknuckle", "mfknuckle", "rfknuckle", "lfknuckle", "lfmetacarpal", "thbase"}) {
      mark(model, name, Part::kHand, side);
    }
    hand_[side] = engine::find_or_fail(model, Kind::kBody, prefix_ + kSideNames[side] + "_hand");
    const std::string its = prefix_ + "robot:" + kSideNames[side] + "_mf_knuckle";
    const int joint = engine::find_or_fail(model, Kind::kJoint, its);
    const std::string next = prefix_ + kSideNames[side] + "_mfmiddle";
    const int bone = engine::find_or_fail(model, Kind::kBody, next);
    palm_[side] = Vec3(model.jnt_axis + 3 * joint).cross(Vec3(model.body_pos + 3 * bone)).normalized();
  }
}

void Stimuli::find_legs(const mjModel& model) {
  for (std::size_t side = 0; side < kSides; ++side) {
    mark(model, "foot", Part::kFoot, side);
    mark(model, "toes", Part::kToes, side);
    mark(model, "big_toe", Part::kToes, side);
    mark(model, "lower_leg", Part::kLowerLeg, side);
    mark(model, "upper_leg", Part::kThigh, side);
    const int toes = engine::find(model, Kind::kBody, (prefix_ + kSideNames[side] + "_toes").c_str());
    if (toes >= 0) ball_[side] = kBall * model.body_pos[3 * toes];
  }
}

void Stimuli::find_head(const mjModel& model, const body::Body& body) {
  const int swivel = engine::find(model, Kind::kJoint, (prefix_ + "robot:head_swivel").c_str());
  const int tilt = engine::find(model, Kind::kJoint, (prefix_ + "robot:head_tilt").c_str());
  if (swivel >= 0) swivel_ = model.jnt_qposadr[swivel];
  if (tilt >= 0) tilt_ = model.jnt_dofadr[tilt];
  if (!wants(Reflex::kRooting) || head_ < 0) return;
  places_[static_cast<std::size_t>(head_)].part = Part::kHead;
  mouth_ = *body::find_mouth(model, body);
}

void Stimuli::rest(const mjModel& model, const mjData& data) {
  for (Sides& sides : shares_) sides = {};
  load_ = {};
  if (wants(Reflex::kMoro)) quick_ = lasting_ = engine::motion_of(model, data, {Kind::kBody, head_}).acceleration;
}

void Stimuli::take_in(const mjModel& model, const mjData& data) {
  for (Sides& sides : shares_) sides = {};
  load_ = {};
  touch(model, data);
  if (wants(Reflex::kTonicNeck)) turn_neck(data);
  if (wants(Reflex::kMoro)) drop_head(model, data);
  if (wants(Reflex::kStepping)) stand(model, data);
}

// What a flex is fastened to does not feel what touches the flex.
Stimuli::Place Stimuli::place_of(const engine::Meeting& met, std::size_t side) const {
  return met.geoms[side] < 0 ? Place() : places_[static_cast<std::size_t>(met.bodies[side])];
}

void Stimuli::touch(const mjModel& model, const mjData& data) {
  for (const engine::Meeting& met : engine::Contacts(model, data)) {
    const Place at_first = place_of(met, 0), at_second = place_of(met, 1);
    if (at_first.own == at_second.own) continue;
    if (at_first.part == Part::kNone && at_second.part == Part::kNone) continue;
    const auto force = senses::touch::pressing(model, data, met.number);
    if (!force) continue;
    using senses::touch::Side;
    const Side side = at_first.own ? Side::kFirst : Side::kSecond;
    feel(model, data, press_on(model, data, met, *force, side));
  }
}

void Stimuli::feel(const mjModel& model, const mjData& data, const Press& press) {
  const Place& place = places_[static_cast<std::size_t>(press.body)];
  switch (place.part) {
    case Part::kHand: return feel_hand(data, press, place.side);
    case Part::kHead: return feel_face(data, press);
    case Part::kFoot:
    case Part::kToes: feel_foot(model, data, press, place); [[fallthrough]];
    case Part::kLowerLeg:
    case Part::kThigh: return feel_leg(model, press, place);
    case Part::kNone: return;
  }
}

void Stimuli::feel_hand(const mjData& data, const Press& press, std::size_t side) {
  const Vec3 palm = rotation(data, hand_[side]) * palm_[side];
  if (press.normal.dot(palm) <= 0) return;  // the back of the hand
  share(Reflex::kPalmarGrasp)[side] += press.normal_force / reflexes::rule(Reflex::kPalmarGrasp).threshold;
}

void Stimuli::feel_foot(const mjModel& model, const mjData& data, const Press& press, const Place& place) {
  const Vec3 up = -Vec3(model.opt.gravity).normalized();
  load_[place.side] += std::max(0.0, press.force.dot(up));
  if (!wants(Reflex::kPlantarGrasp)) return;
  const Vec3 outward = rotation(data, press.body).transpose() * press.normal;
  const Vec3 at = rotation(data, press.body).transpose() * (press.point - Vec3(data.xpos + 3 * press.body));
  if (outward.z() > -0.5 || (place.part == Part::kFoot && at.x() < ball_[place.side])) return;
  share(Reflex::kPlantarGrasp)[place.side] += press.normal_force / reflexes::rule(Reflex::kPlantarGrasp).threshold;
}

// Of what stands still legs feel the load: who lies on a floor does not flee from it.
void Stimuli::feel_leg(const mjModel& model, const Press& press, const Place& place) {
  if (!wants(Reflex::kWithdrawal) || stands_still(model, press.other)) return;
  const double factor = place.part == Part::kThigh      ? reflexes::kThigh
                        : place.part == Part::kLowerLeg ? reflexes::kLowerLeg
                                                        : 1;
  share(Reflex::kWithdrawal)[place.side] += press.normal_force / (withdrawal_ * factor);
}

void Stimuli::feel_face(const mjData& data, const Press& press) {
  const Vec3 at = rotation(data, head_).transpose() * (press.point - Vec3(data.xpos + 3 * head_)) - mouth_.middle;
  for (std::size_t side = 0; side < kSides; ++side) {
    const bool its = (side == 0) == (at.y() > 0);
    if (!its || at.normalized().dot(mouth_.corners[side]) < fixed::cos(kCorner)) continue;
    share(Reflex::kRooting)[side] += press.normal_force / reflexes::rule(Reflex::kRooting).threshold;
  }
}

void Stimuli::turn_neck(const mjData& data) {
  const double turned = data.qpos[swivel_] / kDegree / reflexes::rule(Reflex::kTonicNeck).threshold;
  share(Reflex::kTonicNeck) = {std::max(0.0, turned), std::max(0.0, -turned)};
}

void Stimuli::drop_head(const mjModel& model, const mjData& data) {
  const Vec3 felt = engine::motion_of(model, data, {Kind::kBody, head_}).acceleration;
  quick_ += smoothed_ * (felt - quick_);
  lasting_ += slow_ * (felt - lasting_);
  const double back = tilt_ < 0 ? 0 : -data.qvel[tilt_] / kThrownBack;
  const double strongest = std::max({0.0, back, (quick_ - lasting_).norm() / kDropped});
  share(Reflex::kMoro) = {strongest, strongest};
}

// Upright, a little forward, with weight on the soles; how it leans is that of the trunk's long axis.
void Stimuli::stand(const mjModel& model, const mjData& data) {
  const Vec3 gravity(model.opt.gravity);
  const double weight = model.body_subtreemass[root_] * gravity.norm();
  if (trunk_ < 0 || !(weight > 0)) return;
  const Vec3 up = -gravity.normalized();
  const Vec3 along = rotation(data, trunk_).col(2), ahead = rotation(data, trunk_).col(0);
  const Vec3 left = up.cross(ahead).normalized();
  const Vec3 forward = left.cross(up);
  const double leaning = fixed::atan2(along.dot(forward), along.dot(up));
  if (leaning > kMost || std::abs(along.dot(left)) > fixed::sin(kSideways)) return;
  const double borne = (load_[0] + load_[1]) / (kBorne * weight);
  const double stimulus = std::max(0.0, std::min(borne, leaning / kLeast));
  share(Reflex::kStepping) = {stimulus, stimulus};
}

void Stimuli::save(ByteWriter& to) const {
  receptors::put(to, quick_);
  receptors::put(to, lasting_);
}

void Stimuli::load(ByteReader& from) {
  quick_ = receptors::take(from, "what otoliths felt");
  lasting_ = receptors::take(from, "what otoliths felt");
}

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
