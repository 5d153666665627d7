// What an agent's touch is made of: the inner form of the touch fields of mimo_agent_config.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "mimo/experimental/receptors.h"
#include "senses/touch/spread.h"

namespace mimo::senses {

// Of the header.
enum class TouchFrame : std::int32_t { kBody = MIMO_FRAME_BODY, kWorld = MIMO_FRAME_WORLD, kSkin = MIMO_FRAME_SKIN };

// Of MIMO_TOUCH_, what the nerves of the skin tell, each sensor by itself; in Hz, and in degrees Celsius.
constexpr std::uint32_t kTouchNerves = MIMO_TOUCH_SA1 | MIMO_TOUCH_RA | MIMO_TOUCH_PC | MIMO_TOUCH_SA2;
constexpr std::uint32_t kWarmthNerves = MIMO_TOUCH_TEMPERATURE | MIMO_TOUCH_COLD | MIMO_TOUCH_WARM;
constexpr std::uint32_t kPainNerves = MIMO_TOUCH_NOCICEPTION_FAST | MIMO_TOUCH_NOCICEPTION_SLOW;
constexpr std::uint32_t kSkinNerves = kTouchNerves | kWarmthNerves | kPainNerves | MIMO_TOUCH_UNITS;

struct TouchOptions {
  std::uint32_t wanted = MIMO_TOUCH_FORCE;  // MIMO_TOUCH_ bits
  touch::Response response = touch::Response::kLinear;
  TouchFrame frame = TouchFrame::kBody;
  double scale = 1;                       // divides the spacing of every body that has none of its own below
  double slip_threshold = 0.005;          // m/s; slower slip counts as none
  std::optional<double> everywhere;       // m; in place of the usual spacings
  std::map<std::string, double> spacing;  // m, by body name without the agent's prefix; 0: no skin there
};

// Throws Status::kInvalidArgument for outputs that exclude each other.
void check_outputs(const TouchOptions& options);

}  // namespace mimo::senses
