#include "blueprint/cameras.h"

#include "base/fail.h"

namespace mimo::blueprint {

namespace {

scene::Camera camera_of(const env::CameraOptions& options, const Stand& stand) {
  scene::Camera camera;
  camera.name = options.camera;
  camera.body = stand.body;
  camera.position = stand.position;
  camera.look_at = stand.look_at;
  if (options.vision.fovy > 0) camera.fovy = options.vision.fovy;
  return camera;
}

}  // namespace

void Cameras::add(const CameraPlan& plan, scene::Scene& scene) {
  require(plan.options.vision.wanted != 0, "outputs is 0, expected at least one of the MIMO_VISION_ bits");
  for (const env::CameraOptions& other : cameras_) {
    require(other.camera != plan.options.camera, "name: camera \"{}\" is observed already", other.camera);
  }
  if (plan.placed) scene.add_camera(camera_of(plan.options, *plan.placed));
  cameras_.push_back(plan.options);
}

}  // namespace mimo::blueprint
