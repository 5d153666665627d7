#include "senses/vestibular.h"

#include <algorithm>

namespace mimo::senses {
namespace {

Field field(const char* name, const char* unit) {
  Field field;
  field.name = std::string("vestibular/") + name;
  field.shape = {3};
  field.unit = unit;
  field.frame = "head";
  field.labels = {"x", "y", "z"};
  return field;
}

}  // namespace

Vestibular::Vestibular(const body::Body& body) {
  if (body.accelerometer) {
    fields_.push_back(field("acceleration", "m/s^2"));
    addresses_.push_back(body.accelerometer->address);
  }
  if (body.gyroscope) {
    fields_.push_back(field("angular_velocity", "rad/s"));
    addresses_.push_back(body.gyroscope->address);
  }
}

void Vestibular::write(const mjModel&, const mjData& data, std::uint8_t* block) {
  for (std::size_t i = 0; i < addresses_.size(); ++i) {
    std::transform(data.sensordata + addresses_[i], data.sensordata + addresses_[i] + 3, at<float>(block, i),
                   [](double value) { return static_cast<float>(value); });
  }
}

}  // namespace mimo::senses
