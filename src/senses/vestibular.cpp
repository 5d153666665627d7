#include "senses/vestibular.h"

#include <algorithm>

#include "base/fail.h"

namespace mimo::senses {
namespace {

using engine::Kind;

observation::Field field(const char* name, const char* unit, const char* frame) {
  observation::Field field;
  field.name = std::string("vestibular/") + name;
  field.shape = {3};
  field.unit = unit;
  field.frame = frame;
  field.labels = {"x", "y", "z"};
  return field;
}

observation::Field acceleration(const char* frame) { return field("acceleration", "m/s^2", frame); }
observation::Field angular_velocity(const char* frame) { return field("angular_velocity", "rad/s", frame); }

void copy(const double* from, float* to) {
  std::transform(from, from + 3, to, [](double value) { return static_cast<float>(value); });
}

// Sites come first, as they are made for sensors.
engine::Place find_place(const mjModel& model, const std::string& name) {
  const int body = engine::find(model, Kind::kBody, name.c_str());
  if (engine::find(model, Kind::kSite, name.c_str()) < 0 && body >= 0) return {Kind::kBody, body};
  return {Kind::kSite, engine::find_or_fail(model, Kind::kSite, name)};
}

}  // namespace

Vestibular::Vestibular(const body::Body& body) {
  if (body.accelerometer) {
    fields_.push_back(acceleration("head"));
    addresses_.push_back(body.accelerometer->address);
  }
  if (body.gyroscope) {
    fields_.push_back(angular_velocity("head"));
    addresses_.push_back(body.gyroscope->address);
  }
}

void Vestibular::write(const mjModel&, const mjData& data, std::uint8_t* block) {
  for (std::size_t i = 0; i < addresses_.size(); ++i) copy(data.sensordata + addresses_[i], at<float>(block, i));
}

Organ::Organ(engine::Place place) : place_(place) {
  const char* frame = place.kind == Kind::kSite ? "site" : "body";
  fields_ = {acceleration(frame), angular_velocity(frame)};
}

void Organ::write(const mjModel& model, const mjData& data, std::uint8_t* block) {
  const engine::Motion motion = engine::motion_of(model, data, place_);
  copy(motion.acceleration.data(), at<float>(block, 0));
  copy(motion.angular_velocity.data(), at<float>(block, 1));
}

std::unique_ptr<observation::Sense> make_vestibular(const mjModel& model, const body::Body& body,
                                                    const std::string& place) {
  if (!place.empty()) return std::make_unique<Organ>(find_place(model, place));
  require(
      body.infant,
      "vestibular is 1, but the agent is no infant: vestibular_at has to name a site or body that carries the organ, "
      "or vestibular = 0");
  return std::make_unique<Vestibular>(body);
}

}  // namespace mimo::senses
