#include "senses/vestibular.h"

#include <Eigen/Core>

#include "base/fail.h"
#include "base/header.h"
#include "base/numbers.h"
#include "engine/present.h"
#include "observation/sense.h"
#include "senses/labyrinth.h"

namespace mimo::senses {
namespace {

using engine::Kind;

static_assert((MIMO_VESTIBULAR_ACCELERATION | MIMO_VESTIBULAR_ANGULAR_VELOCITY | kLabyrinth) == header::kVestibular);

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
std::vector<observation::Signal> readings(const body::Body& body, const VestibularOptions& options) {
  std::vector<observation::Signal> signals;
  if (has_bit(options.wanted, MIMO_VESTIBULAR_ACCELERATION) && body.accelerometer) {
    signals.push_back(reading(acceleration("head"), *body.accelerometer));
  }
  if (has_bit(options.wanted, MIMO_VESTIBULAR_ANGULAR_VELOCITY) && body.gyroscope) {
    signals.push_back(reading(angular_velocity("head"), *body.gyroscope));
  }
  return signals;
}

// The same at any place of a model, which needs no sensors for it.
std::vector<observation::Signal> motions(const engine::Place& place, const VestibularOptions& options) {
  const char* frame = place.kind == Kind::kSite ? "site" : "body";
  const auto signal = [place](observation::Field field, Eigen::Vector3d engine::Motion::*part) {
    return observation::Signal{std::move(field), [place, part](const mjModel& model, const mjData& data, float* out) {
                                 narrow((engine::motion_of(model, data, place).*part).data(), out);
                               }};
  };
  std::vector<observation::Signal> signals;
  if (has_bit(options.wanted, MIMO_VESTIBULAR_ACCELERATION)) {
    signals.push_back(signal(acceleration(frame), &engine::Motion::acceleration));
  }
  if (has_bit(options.wanted, MIMO_VESTIBULAR_ANGULAR_VELOCITY)) {
    signals.push_back(signal(angular_velocity(frame), &engine::Motion::angular_velocity));
  }
  return signals;
}

// Sites come first, as they are made for sensors.
engine::Place find_place(const mjModel& model, const std::string& name) {
  const int body = engine::find(model, Kind::kBody, name.c_str());
  if (engine::find(model, Kind::kSite, name.c_str()) < 0 && body >= 0) return {Kind::kBody, body};
  return {Kind::kSite, engine::find_or_fail(model, Kind::kSite, name)};
}

// The head of an infant with both ears in it; of anything else a place where both are.
Labyrinth::Head head_of(const mjModel& model, const body::Body& body, const VestibularOptions& options) {
  if (options.at.empty()) return head_with_ears(model, body.head);
  const engine::Place place = find_place(model, options.at);
  return {place, place.kind == Kind::kSite ? "site" : "body"};
}

}  // namespace

std::unique_ptr<observation::Sense> make_vestibular(const mjModel& model, const body::Body& body,
                                                    const VestibularOptions& options, double tick) {
  require(body.infant || !options.at.empty(),
          "vestibular is on, but the agent is not an infant: set vestibular_at to the site or body that carries the "
          "organ, or vestibular to 0");
  std::vector<observation::Signal> signals =
      options.at.empty() ? readings(body, options) : motions(find_place(model, options.at), options);
  std::unique_ptr<Labyrinth> labyrinth;
  if (has_bit(options.wanted, kLabyrinth)) {
    labyrinth = std::make_unique<Labyrinth>(head_of(model, body, options), tick);
    for (observation::Signal& signal : labyrinth->signals(options.wanted)) signals.push_back(std::move(signal));
  }
  auto sense = std::make_unique<observation::Signals>(observation::Share::kVestibular, std::move(signals));
  if (labyrinth != nullptr) sense->keep(std::move(labyrinth));
  return sense;
}

}  // namespace mimo::senses
