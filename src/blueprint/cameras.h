// Cameras whose pictures are observed, though they belong to no agent.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "env/options.h"
#include "scene/scene.h"

namespace mimo::blueprint {

// Where a new camera stands, and where it looks.
struct Stand {
  std::string body;  // "": the world; both points are in its frame
  std::array<double, 3> position{};
  std::array<double, 3> look_at{};
};

struct CameraPlan {
  env::CameraOptions options;
  std::optional<Stand> placed;  // nothing: the scene has it already
};

class Cameras {
 public:
  const std::vector<env::CameraOptions>& all() const { return cameras_; }
  // No camera is observed twice, and none for nothing. The scene gets one that it does not have: of the same name, and
  // as wide as the picture where that says.
  void add(const CameraPlan& plan, scene::Scene& scene);

 private:
  std::vector<env::CameraOptions> cameras_;
};

}  // namespace mimo::blueprint
