// What an agent's touch is made of: the inner form of the touch fields of mimo_agent_config.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "senses/touch/spread.h"

namespace mimo::senses {

// As mimo.h numbers them (MIMO_FRAME_BODY ...).
enum class TouchFrame : int { kBody = 1, kWorld = 2, kSkin = 3 };

// What the nerves of the skin tell, each sensor by itself; in Hz, and in degrees Celsius.
struct SkinReceptorOptions {
  bool sa1 = false, ra = false, pc = false, sa2 = false;
  bool temperature = false, cold = false, warm = false;
  bool nociception_fast = false, nociception_slow = false;
  bool units = false;  // how many afferents of the first four kinds each sensor stands for

  bool touch() const { return sa1 || ra || pc || sa2; }
  bool warmth() const { return temperature || cold || warm; }
  bool pain() const { return nociception_fast || nociception_slow; }
  bool any() const { return touch() || warmth() || pain() || units; }
};

struct TouchOptions {
  bool force = true;
  bool normal_force = false;  // instead of force
  bool slip = false;
  bool friction_use = false;
  SkinReceptorOptions receptors;
  touch::Response response = touch::Response::kLinear;
  TouchFrame frame = TouchFrame::kBody;
  double scale = 1;                       // divides the spacing of every body that has none of its own below
  double slip_threshold = 0.005;          // m/s; slower slip counts as none
  std::optional<double> everywhere;       // m; in place of the usual spacings
  std::map<std::string, double> spacing;  // m, by body name without the agent's prefix; 0: no skin there

  bool any() const { return force || normal_force || slip || friction_use || receptors.any(); }
};

// Throws Status::kInvalidArgument for outputs that exclude each other.
void check_outputs(const TouchOptions& options);

}  // namespace mimo::senses
