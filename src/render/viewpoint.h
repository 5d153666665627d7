// From where somebody wants to look: by a camera of the model, or by a free one.
#pragma once

#include "render/renderer.h"

namespace mimo::render {

struct Viewpoint {
  int camera = -1;  // of the model; -1: the free one, which looks at a point
  double fovy = 0;  // degrees; 0: the camera's own, for the free one the model's
  Eigen::Vector3d look_at = Eigen::Vector3d::Zero();
  double distance = 1;
  double azimuth = 0, elevation = 0;  // degrees, as MuJoCo's free camera
};

// Cameras of the model are where `data` has them.
View view_from(const mjModel& model, const mjData& data, const Viewpoint& from);

}  // namespace mimo::render
