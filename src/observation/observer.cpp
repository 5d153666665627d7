#include "env/observer.h"

#include "base/fail.h"
#include "senses/vision.h"

namespace mimo::env {

void Observer::add(senses::Sense& sense) {
  for (senses::Field& field : sense.fields()) {
    for (std::size_t i = 0; i < layout_.size(); ++i) {
      require(layout_[i].name != field.name, "there are two fields \"{}\"", field.name);
    }
    layout_.add(field);
  }
  senses_.push_back(&sense);
}

void Observer::add_camera(const mjModel& model, const CameraOptions& options, render::Renderer* renderer) {
  if (renderer == nullptr) {
    fail(Status::kInvalidArgument, "renderer \"none\": camera \"{}\" is to be observed; choose a renderer",
         options.camera);
  }
  const senses::Lens lens{"vision/" + options.camera,
                          engine::find_or_fail(model, engine::Kind::kCamera, options.camera)};
  cameras_.push_back(
      std::make_unique<senses::Vision>(model, std::vector<senses::Lens>{lens}, options.vision, *renderer));
  add(*cameras_.back());
}

void Observer::observe(const mjModel& model, const mjData& data, std::uint8_t* block, Timing* timing) const {
  Timing nobody;
  Timing& sums = timing != nullptr ? *timing : nobody;
  for (senses::Sense* sense : senses_) {
    const Stopwatch watch(timing != nullptr, sums.senses[static_cast<std::size_t>(sense->part())]);
    sense->write(model, data, block);
  }
  layout_.clear_gaps(block);
}

}  // namespace mimo::env
