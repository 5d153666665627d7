// Cameras whose pictures are observed, though they belong to no agent.
#pragma once

#include <optional>
#include <vector>

#include "env/options.h"
#include "scene/scene.h"

namespace mimo::blueprint {

struct CameraPlan {
  env::CameraOptions options;
  std::optional<scene::Camera> placed;  // nothing: the scene has it already
};

class Cameras {
 public:
  const std::vector<env::CameraOptions>& all() const { return cameras_; }
  // No camera is observed twice. The scene gets one that it does not have.
  void add(const CameraPlan& plan, scene::Scene& scene);

 private:
  std::vector<env::CameraOptions> cameras_;
};

}  // namespace mimo::blueprint
