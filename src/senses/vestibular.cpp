#include "senses/vestibular.h"

#include <Eigen/Core>

#include "base/fail.h"
#include "engine/motion.h"
#include "observation/signals.h"

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

void narrow(const double* from, float* to) {
  Eigen::Map<Eigen::Vector3f>{to} = Eigen::Map<const Eigen::Vector3d>(from).cast<float>();
}

// What one of MuJoCo's sensors says.
observation::Signal reading(observation::Field field, const body::Sensor& sensor) {
  const int address = sensor.address;
  return {std::move(field),
          [address](const mjModel&, const mjData& data, float* out) { narrow(data.sensordata + address, out); }};
}

// An infant's: MuJoCo's accelerometer and gyroscope in its head.
std::vector<observation::Signal> readings(const body::Body& body) {
  std::vector<observation::Signal> signals;
  if (body.accelerometer) signals.push_back(reading(acceleration("head"), *body.accelerometer));
  if (body.gyroscope) signals.push_back(reading(angular_velocity("head"), *body.gyroscope));
  return signals;
}

// The same at any place of a model, which needs no sensors for it.
class Organ : public observation::Sense {
 public:
  explicit Organ(engine::Place place) : place_(place) {
    const char* frame = place.kind == Kind::kSite ? "site" : "body";
    fields_ = {acceleration(frame), angular_velocity(frame)};
  }
  observation::Part part() const override { return observation::Part::kVestibular; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override {
    const engine::Motion motion = engine::motion_of(model, data, place_);
    narrow(motion.acceleration.data(), at<float>(block, 0));
    narrow(motion.angular_velocity.data(), at<float>(block, 1));
  }

 private:
  engine::Place place_;
};

// Sites come first, as they are made for sensors.
engine::Place find_place(const mjModel& model, const std::string& name) {
  const int body = engine::find(model, Kind::kBody, name.c_str());
  if (engine::find(model, Kind::kSite, name.c_str()) < 0 && body >= 0) return {Kind::kBody, body};
  return {Kind::kSite, engine::find_or_fail(model, Kind::kSite, name)};
}

}  // namespace

std::unique_ptr<observation::Sense> make_vestibular(const mjModel& model, const body::Body& body,
                                                    const std::string& place) {
  if (!place.empty()) return std::make_unique<Organ>(find_place(model, place));
  require(
      body.infant,
      "vestibular is 1, but the agent is no infant: vestibular_at has to name a site or body that carries the organ, "
      "or vestibular = 0");
  return std::make_unique<observation::Signals>(observation::Part::kVestibular, readings(body));
}

}  // namespace mimo::senses
