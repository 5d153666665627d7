#include "movements/spontaneous.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "base/bytes.h"
#include "base/format.h"
#include "base/functions.h"
#include "base/numbers.h"

namespace mimo::movements {
namespace {

// What a number is drawn for, so that no two draws share one.
enum Purpose : std::uint64_t {
  kActivity,
  kTempo,
  kPhase,
  kDrift,
  kFidget,
  kKickComes,
  kKickOnset,
  kKickLength,
  kKickForce,
  kStartleComes,
  kStartleOnset,
  kTwitchComes,
  kTwitchOnset,
  kTwitchForce
};

// Uniform in [0, 1): SplitMix64 over what it depends on.
double draw(std::uint64_t seed, Purpose purpose, std::uint64_t key, std::int64_t slot = 0) {
  std::uint64_t mixed = seed;
  for (const std::uint64_t part : {static_cast<std::uint64_t>(purpose), key, static_cast<std::uint64_t>(slot)}) {
    mixed ^= part;
    mixed += 0x9e3779b97f4a7c15u;
    mixed = (mixed ^ mixed >> 30) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ mixed >> 27) * 0x94d049bb133111ebu;
    mixed ^= mixed >> 31;
  }
  return static_cast<double>(mixed >> 11) * 0x1.0p-53;
}

// -1 to 1: from one goal to the next in each period, smoothly.
double wander(std::uint64_t seed, Purpose purpose, std::uint64_t key, double time, double period) {
  const double at = time / period, slot = std::floor(at), share = at - slot;
  const double from = 2 * draw(seed, purpose, key, static_cast<std::int64_t>(slot)) - 1;
  const double to = 2 * draw(seed, purpose, key, static_cast<std::int64_t>(slot) + 1) - 1;
  return from + (to - from) * share * share * (3 - 2 * share);
}

// Between the points of a line, by age in months; beyond its ends as there.
double at_age(double age, std::initializer_list<std::pair<double, double>> line) {
  const std::pair<double, double>* last = line.begin();
  for (const auto& point : line) {
    if (age < point.first) {
      if (point.first == last->first) return point.second;
      return last->second + (point.second - last->second) * (age - last->first) / (point.first - last->first);
    }
    last = &point;
  }
  return last->second;
}

// A burst of a slot: how far it is, 0 to 1; negative outside of it. It may reach into the next slot.
double share_of_burst(double time, double slot_seconds, std::int64_t slot, double onset, double seconds) {
  const double since = time - slot_seconds * (static_cast<double>(slot) + onset);
  return since >= 0 && since < seconds ? since / seconds : -1;
}

bool has(const std::string& name, const char* part) { return name.find(part) != std::string::npos; }

// The name of a motor without its side, which kicks and startles do not tell apart.
std::string without_side(const std::string& motor) {
  for (const char* side : {"left_", "right_"}) {
    if (begins_with(motor, side)) return motor.substr(std::string(side).size());
  }
  return motor;
}

struct Share {
  const char* motor;
  double share;
};

// To the bent side: hips and knees bend to the negative, ankles pull the foot up to the positive.
constexpr Share kKick[] = {{"hip_flex", -1}, {"knee", -0.7}, {"foot_flexion", 0.3}};
// Arms to the side, elbows and knees straight.
constexpr Share kStartle[] = {
    {"shoulder_abduction", 0.8}, {"elbow", 0.5}, {"hip_flex", 0.4}, {"knee", 0.5}, {"hip_abduction", -0.5}};

template <std::size_t N>
double share_of(const Share (&shares)[N], const std::string& motor) {
  const std::string name = without_side(motor);
  for (const Share& one : shares) {
    if (name == one.motor) return one.share;
  }
  return 0;
}

std::uint64_t key_of(const std::string& name) {
  Hash hash;
  hash.add(name);
  return hash.value();
}

std::uint64_t key_of(Limb limb) { return static_cast<std::uint64_t>(limb) + 1; }

constexpr double kKickSlot = 2, kStartleSlot = 20, kTwitchSlot = 5;  // s; at most one a slot, limb or motor

}  // namespace

Limb limb_of(const std::string& motor) {
  if (has(motor, "_eye_")) return Limb::kNone;
  const bool left = begins_with(motor, "left_"), right = begins_with(motor, "right_");
  if (!left && !right)
    return begins_with(motor, "hip_") ? Limb::kTrunk : begins_with(motor, "head") ? Limb::kHead : Limb::kNone;
  const bool leg = has(motor, "hip") || has(motor, "knee") || has(motor, "foot") || has(motor, "toe");
  if (leg) return left ? Limb::kLeftLeg : Limb::kRightLeg;
  return left ? Limb::kLeftArm : Limb::kRightArm;
}

// Ages at which kinds come and go: general movements until 18 weeks after term, later movements of the same looks are
// called voluntary; fidgets from 3 to 5 months (Einspieler et al. 2016, J Pediatr (Rio J) 92:S64). Kicks: ten thousands
// a day (Smith et al. 2015); their forces are fitted, so that an ankle's movements last 0.23 to 0.33 s with mean
// accelerations of 1.59 to 3.88 m/s^2 (Trujillo-Priego and Smith 2017). Rates of startles and twitches are estimates.
Spontaneous::Spontaneous(const std::vector<std::string>& motors, double age)
    : at_{at_age(age, {{0, 0.6}, {2, 0.6}, {3, 0.3}, {5, 0.24}}),
          at_age(age, {{1.5, 0}, {2.5, 0.06}, {4.5, 0.06}, {5.5, 0}}),
          at_age(age, {{0, 0.33}, {2, 0.55}, {6, 0.55}, {12, 0.44}, {24, 0.28}}),
          at_age(age, {{6, 1}, {12, 0.8}}),
          at_age(age, {{0, 0.3}, {2, 0.15}, {4, 0}}),
          at_age(age, {{0, 0.2}, {3, 0.1}, {12, 0.05}})} {
  for (const std::string& name : motors) {
    motors_.push_back({limb_of(name), key_of(name), share_of(kKick, name), share_of(kStartle, name)});
  }
}

void Spontaneous::command(std::uint64_t seed, double time, std::uint32_t which, Span<float> commands) const {
  time = std::clamp(time, 0.0, 1e12);  // slots are counted in whole numbers, and a state may hold any time
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const Motor& motor = motors_[i];
    double sum = 0;
    if (motor.limb != Limb::kNone) {
      if (has_bit(which, MIMO_MOVEMENT_GENERAL)) sum += general(motor, seed, time);
      if (has_bit(which, MIMO_MOVEMENT_FIDGETS)) sum += at_.fidgets * wander(seed, kFidget, motor.key, time, 0.22);
      if (has_bit(which, MIMO_MOVEMENT_KICKS)) sum += kick(motor, seed, time);
      if (has_bit(which, MIMO_MOVEMENT_STARTLES)) sum += startle(motor, seed, time);
      if (has_bit(which, MIMO_MOVEMENT_TWITCHES)) sum += twitch(motor, seed, time);
    }
    commands[i] = static_cast<float>(std::clamp(sum, -1.0, 1.0));
  }
}

// Joints of a limb swing at one tempo, each in its own phase and about a middle that drifts; the limb's activity comes
// and goes, about half of the time.
double Spontaneous::general(const Motor& motor, std::uint64_t seed, double time) const {
  const std::uint64_t limb = key_of(motor.limb);
  const double active = std::clamp((wander(seed, kActivity, limb, time, 1.5) + 0.15) / 0.5, 0.0, 1.0);
  if (active == 0) return 0;
  const double hertz = 0.35 + 0.5 * draw(seed, kTempo, limb);
  const double swing = fixed::sin(2 * kPi * (hertz * time + draw(seed, kPhase, motor.key)));
  return at_.general * active * 0.5 * (swing + wander(seed, kDrift, motor.key, time, 0.9));
}

// Bends and stretches in a movement of about half a second.
double Spontaneous::kick(const Motor& motor, std::uint64_t seed, double time) const {
  if (motor.kick == 0) return 0;
  const std::uint64_t limb = key_of(motor.limb);
  const auto now = static_cast<std::int64_t>(std::floor(time / kKickSlot));
  double sum = 0;
  for (const std::int64_t slot : {now - 1, now}) {
    if (slot < 0 || draw(seed, kKickComes, limb, slot) >= at_.kicks) continue;
    const double seconds = 0.5 + 0.3 * draw(seed, kKickLength, limb, slot);
    const double share = share_of_burst(time, kKickSlot, slot, draw(seed, kKickOnset, limb, slot), seconds);
    if (share < 0) continue;
    const double force = at_.kick_force * (0.5 + 0.5 * draw(seed, kKickForce, limb, slot));
    sum += force * motor.kick * fixed::sin(2 * kPi * share);
  }
  return sum;
}

// All limbs at once, within a second: up fast, down slowly.
double Spontaneous::startle(const Motor& motor, std::uint64_t seed, double time) const {
  if (motor.startled == 0) return 0;
  const auto now = static_cast<std::int64_t>(std::floor(time / kStartleSlot));
  double sum = 0;
  for (const std::int64_t slot : {now - 1, now}) {
    if (slot < 0 || draw(seed, kStartleComes, 0, slot) >= at_.startles) continue;
    const double share = share_of_burst(time, kStartleSlot, slot, draw(seed, kStartleOnset, 0, slot), 1);
    if (share >= 0) sum += motor.startled * (share < 0.15 ? share / 0.15 : (1 - share) / 0.85);
  }
  return sum;
}

double Spontaneous::twitch(const Motor& motor, std::uint64_t seed, double time) const {
  const auto now = static_cast<std::int64_t>(std::floor(time / kTwitchSlot));
  double sum = 0;
  for (const std::int64_t slot : {now - 1, now}) {
    if (slot < 0 || draw(seed, kTwitchComes, motor.key, slot) >= at_.twitches) continue;
    const double share = share_of_burst(time, kTwitchSlot, slot, draw(seed, kTwitchOnset, motor.key, slot), 0.12);
    const double force = 0.8 * draw(seed, kTwitchForce, motor.key, slot) - 0.4;
    if (share >= 0) sum += force * fixed::sin(kPi * share);
  }
  return sum;
}

}  // namespace mimo::movements
