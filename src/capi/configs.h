// Configs of agents, growth, places and cameras: from the caller's form to the library's, and what scenes have by
// default.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/header.h"
#include "blueprint/aging_world.h"
#include "blueprint/blueprint.h"
#include "capi/check.h"
#include "document/attributes.h"
#include "growth/growth.h"
#include "mimo/experimental.h"
#include "mimo/growth.h"
#include "mimo/mimo.h"
#include "scene/scene.h"
#include "senses/vision.h"

namespace mimo::capi {

// Configs of agents, and what scenes have by default.

mimo_agent_config default_agent_config();
// What the scene gives its infant by default.
mimo_agent_config default_agent_config(const scene::Scene& scene);
// An infant as the scene has it.
blueprint::AgentPlan usual_agent(const scene::Scene& scene);
// A built-in scene with all its infants.
blueprint::Blueprint ready_world(const std::string& scene);

// mimo_growth, from the caller's form to ours.

// Throws for what is out of range.
growth::Growth growth_from(const mimo_growth& config, const char* argument);
// Of an array whose entries may be NULL: these stay.
blueprint::Ages ages_from(const mimo_growth* const* growth, std::size_t count, const char* argument);

// Positions and orientations of configs.

// Checked: finite, and a quaternion that is not zero.
inline document::Pose pose(const double (&position)[3], const double (&orientation)[4]) {
  check_finite(position, 3, "position");
  check_finite(orientation, 4, "orientation");
  const double square = orientation[0] * orientation[0] + orientation[1] * orientation[1] +
                        orientation[2] * orientation[2] + orientation[3] * orientation[3];
  require(square > 1e-18, "orientation is zero, expected a quaternion w x y z");
  document::Pose result;
  std::copy(std::begin(position), std::end(position), result.position.begin());
  std::copy(std::begin(orientation), std::end(orientation), result.orientation.begin());
  return result;
}

// What configs of eyes, of other cameras and of pictures have in common.

// A number of a config, and its range.
template <typename T>
struct Ranged {
  T value;
  const ranges::Range<T>& range;
};

inline void check_view(Ranged<std::uint32_t> width, Ranged<std::uint32_t> height, Ranged<double> fovy) {
  in_range(width.value, width.range);
  in_range(height.value, height.range);
  in_range_or_zero(fovy.value, fovy.range, " degrees", "the camera's own");
}

inline senses::VisionOptions vision(std::uint32_t outputs, const char* name, Ranged<std::uint32_t> width,
                                    Ranged<std::uint32_t> height, Ranged<double> fovy) {
  check_bits(outputs, header::kVision, name);
  senses::VisionOptions options;
  options.wanted = outputs;
  if (options.wanted == 0) return options;
  check_view(width, height, fovy);
  options.width = static_cast<int>(width.value);
  options.height = static_cast<int>(height.value);
  options.fovy = fovy.value;
  return options;
}

}  // namespace mimo::capi
