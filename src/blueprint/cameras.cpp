#include "blueprint/cameras.h"

#include "base/fail.h"

namespace mimo::blueprint {

void Cameras::add(const CameraPlan& plan, scene::Scene& scene) {
  for (const env::CameraOptions& other : cameras_) {
    require(other.camera != plan.options.camera, "name: camera \"{}\" is observed already", other.camera);
  }
  if (plan.placed) scene.add_camera(*plan.placed);
  cameras_.push_back(plan.options);
}

}  // namespace mimo::blueprint
