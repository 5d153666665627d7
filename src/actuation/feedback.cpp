#include "actuation/feedback.h"

namespace mimo::actuation {

Feedback::Feedback(const mjModel& model, const Actuation& actuation, bool own_fields, bool effort)
    : actuation_(actuation) {
  if (own_fields && actuation.size() > 0) fields_ = actuation.fields(model);
  own_ = fields_.size();
  if (!effort) return;
  senses::Field field;
  field.name = "proprioception/effort";
  field.shape = {1};
  field.time = senses::Time::kEnd;
  field.low = 0;
  field.labels = {"effort"};
  fields_.push_back(std::move(field));
}

void Feedback::write(const mjModel& model, const mjData& data, std::uint8_t* block) {
  for (std::size_t i = 0; i < own_; ++i) actuation_.feel(data, i, at<float>(block, i));
  if (fields_.size() > own_) *at<float>(block, own_) = static_cast<float>(actuation_.effort(model, data));
}

}  // namespace mimo::actuation
