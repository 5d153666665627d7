#include "senses/vision.h"

#include <limits>

#include "base/fail.h"
#include "base/format.h"
#include "base/numbers.h"
#include "render/renderer.h"

namespace mimo::senses {
namespace {

using engine::Kind;

std::vector<Lens> carried_cameras(const mjModel& model, const body::Body& body) {
  std::vector<Lens> lenses;
  std::vector<std::string> others;
  for (int camera = 0; camera < model.ncam; ++camera) {
    const std::string own = engine::name(model, Kind::kCamera, camera);
    const std::string name = own.empty() ? "camera" + std::to_string(camera) : own;
    if (body.root == 0 || body.has(model.cam_bodyid[camera])) {  // the world's own as well, where it is all
      lenses.push_back({"vision/" + name, camera});
    } else {
      others.push_back(name);
    }
  }
  if (lenses.empty()) {
    fail(Status::kNotFound,
         "vision is on, but body \"{}\" carries no camera; vision = 0 switches eyes off; cameras elsewhere: {}",
         engine::name(model, Kind::kBody, body.root), others.empty() ? "none" : join(others, ", "));
  }
  return lenses;
}

}  // namespace

std::vector<Lens> eyes(const mjModel& model, const body::Body& body) {
  if (!body.infant) return carried_cameras(model, body);
  if (body.eye_left < 0 || body.eye_right < 0) {
    fail(Status::kNotFound, "vision is on, but the model has no cameras {0}eye_left and {0}eye_right", body.prefix);
  }
  return {{"vision/eye_left", body.eye_left}, {"vision/eye_right", body.eye_right}};
}

Vision::Vision(const mjModel& model, const std::vector<Lens>& lenses, const VisionOptions& options,
               render::Renderer& renderer)
    : options_(options), renderer_(renderer) {
  for (const Lens& lens : lenses) views_.push_back(view(model, lens));
}

Vision::View Vision::view(const mjModel& model, const Lens& lens) {
  const double far = model.vis.map.zfar * model.stat.extent;
  View view{lens.camera, kNone, kNone, kNone};
  if (has_bit(options_.wanted, MIMO_VISION_RGB)) {
    view.rgb = add(lens.path, observation::Type::kU8, "", 0, 255);
    fields_.back().foveation = options_.foveation;
  }
  if (has_bit(options_.wanted, MIMO_VISION_DEPTH)) {
    view.depth = add(lens.path + "_depth", observation::Type::kF32, "m", 0, far);
  }
  if (has_bit(options_.wanted, MIMO_VISION_SEGMENTATION)) {
    view.segmentation = add(lens.path + "_segmentation", observation::Type::kI32, "", -1, model.ngeom - 1);
  }
  const Pinhole pinhole =
      render::pinhole_of(render::lens_of(model, lens.camera, options_.fovy), options_.width, options_.height);
  for (observation::Field& field : fields_) {
    if (!field.is_picture()) field.pinhole = pinhole;  // those just added
  }
  return view;
}

int Vision::add(const std::string& name, observation::Type type, const char* unit, double low, double high) {
  observation::Field field;
  field.name = name;
  field.type = type;
  field.shape = {static_cast<std::size_t>(options_.height), static_cast<std::size_t>(options_.width)};
  if (type == observation::Type::kU8) field.shape.push_back(3);
  field.unit = unit;
  field.frame = "camera";
  field.low = low;
  field.high = high;
  fields_.push_back(std::move(field));
  return static_cast<int>(fields_.size()) - 1;
}

void Vision::write(const mjModel& model, const mjData& data, std::uint8_t* block) {
  for (const View& view : views_) {
    render::Picture picture;
    picture.width = options_.width;
    picture.height = options_.height;
    picture.rgb = pixels<std::uint8_t>(block, view.rgb);
    picture.depth = pixels<float>(block, view.depth);
    picture.segmentation = pixels<std::int32_t>(block, view.segmentation);
    renderer_.draw(model, data, render::camera_view(model, data, view.camera, options_.fovy), picture);
  }
}

}  // namespace mimo::senses
