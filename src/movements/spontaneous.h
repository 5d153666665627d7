// How infants move before they want anything: general movements, fidgets, kicks, startles and twitches, as commands of
// motors.
//
// A command is a function of a seed, the time, the motor and the age alone. There is no memory that a state would have
// to hold: bursts come from slots of time, in each of which the seed says whether, when and how hard.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/span.h"
#include "mimo/experimental/spontaneous.h"

namespace mimo::movements {

enum class Limb : std::uint8_t { kLeftArm, kRightArm, kLeftLeg, kRightLeg, kTrunk, kHead, kNone };

// A motor by its name without prefixes: "left_hip_flex". Eyes, and what the library does not know, have no limb and
// rest.
Limb limb_of(const std::string& motor);

class Spontaneous {
 public:
  // Motors by their names without prefixes; physiological age in months.
  Spontaneous(const std::vector<std::string>& motors, double age);

  // For each motor -1 to 1, as a share of what it can do in that direction, at a time since the episode began, s.
  // `which` are MIMO_MOVEMENT_ bits.
  void command(std::uint64_t seed, double time, std::uint32_t which, Span<float> commands) const;

 private:
  struct Motor {
    Limb limb;
    std::uint64_t key;      // of its name
    double kick, startled;  // its share of these, with the sign of its direction
  };
  // How strong each kind is at the age.
  struct Strength {
    double general, fidgets, kicks, kick_force, startles, twitches;
  };

  double general(const Motor& motor, std::uint64_t seed, double time) const;
  double kick(const Motor& motor, std::uint64_t seed, double time) const;
  double startle(const Motor& motor, std::uint64_t seed, double time) const;
  double twitch(const Motor& motor, std::uint64_t seed, double time) const;

  std::vector<Motor> motors_;
  Strength at_;
};

}  // namespace mimo::movements
