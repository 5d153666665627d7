// Inertial sensors at the ankles, the wrists and the head, as studies of infants' movements strap on. A sense in one
// file, for mimo::Scene::load_sense or Scene.load_sense in Python.
//
// Noise, bias and range are typical values of the BMI160's data sheet (Bosch Sensortec, BST-BMI160-DS000-07, 2015):
// accelerometer 180 ug/sqrt(Hz), zero-g offset 40 mg, gyroscope 0.007 deg/s/sqrt(Hz), zero-rate offset 3 deg/s. A
// sensor's band is half its rate.
#include <algorithm>
#include <array>
#include <cmath>
#include <mimo/mimo.hpp>

namespace {

constexpr double kGravity = 9.80665, kDegree = 3.14159265358979323846 / 180;
const std::array<const char*, 5> kPlaces = {{"left_foot", "right_foot", "left_hand", "right_hand", "head"}};
constexpr std::size_t kAxes = 6;  // acceleration x y z, angular velocity x y z

enum Parameter { kRate, kAccelerationRange, kTurnRange, kNoise, kBias, kCount };

class Imu : public mimo::Sense {
 public:
  static std::vector<mimo_parameter> parameters() {
    using mimo::sense_parameter;
    std::vector<mimo_parameter> all(kCount);
    all[kRate] = sense_parameter("rate", "samples a second, at most one for each physics step", 100, 1, 1000);
    all[kAccelerationRange] = sense_parameter("acceleration_range", "largest value, g", 8, 2, 16);
    all[kTurnRange] = sense_parameter("turn_range", "largest value, degrees a second", 1000, 125, 2000);
    all[kNoise] = sense_parameter("noise", "factor of the data sheet's noise", 1, 0, 100);
    all[kBias] = sense_parameter("bias", "factor of the data sheet's offsets", 1, 0, 100);
    return all;
  }

  // Fields: imu/acceleration and imu/angular_velocity, places x samples of a step x 3 in the frame of the body, the
  // newest sample last.
  explicit Imu(mimo::SenseOpening& opening) {
    const double* set = opening.told.parameters;
    const double ticks = 1 / (set[kRate] * opening.told.timestep);
    every_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(ticks)));
    samples_ = std::max<std::size_t>(1, opening.told.step_ticks / every_);
    for (std::size_t i = 0; i < kPlaces.size(); ++i)
      bodies_[i] = opening.world.find(MIMO_BODY, opening.own(kPlaces[i]));
    add(opening, "acceleration", "m/s^2", set[kAccelerationRange] * kGravity);
    add(opening, "angular_velocity", "rad/s", set[kTurnRange] * kDegree);
    opening.memory_bytes = kPlaces.size() * samples_ * kAxes * sizeof(float);
  }

  void reset(const mimo::SenseMoment& now) const override {
    for (std::size_t i = 0; i < samples_; ++i) sample(now);
  }

  void advance(const mimo::SenseMoment& now) const override {
    if (now.told.tick % every_ == 0) sample(now);
  }

  void write(const mimo::SenseMoment& now) const override {
    const float* kept = &now.memory<float>();
    for (std::size_t i = 0; i < kPlaces.size() * samples_; ++i) {
      std::copy_n(kept + kAxes * i, 3, now.field(0) + 3 * i);
      std::copy_n(kept + kAxes * i + 3, 3, now.field(1) + 3 * i);
    }
  }

 private:
  void add(const mimo::SenseOpening& opening, const char* name, const char* unit, double range) const {
    mimo::SenseField field(name, {kPlaces.size(), samples_, 3}, unit, "body");
    for (const char* place : kPlaces) {
      for (std::size_t i = 0; i < 3 * samples_; ++i) field.labels.push_back(std::string(place) + "/" + "xyz"[i % 3]);
    }
    field.low = -range;
    field.high = range;
    opening.add(field);
  }

  // The oldest sample goes.
  void sample(const mimo::SenseMoment& now) const {
    const double* set = now.told.parameters;
    const double band = std::sqrt(0.5 / (static_cast<double>(every_) * now.told.timestep));
    const double noise[2] = {set[kNoise] * 180e-6 * kGravity * band, set[kNoise] * 0.007 * kDegree * band};
    const double bias[2] = {set[kBias] * 40e-3 * kGravity, set[kBias] * 3 * kDegree};
    const double range[2] = {set[kAccelerationRange] * kGravity, set[kTurnRange] * kDegree};
    double read[kPlaces.size()][9];  // acceleration, angular velocity, angular acceleration
    mimo::check(mimo_env_get(now.world.get(), MIMO_BODY_INERTIAL, bodies_.data(), bodies_.size(), &read[0][0],
                             9 * bodies_.size()));
    for (std::size_t place = 0; place < kPlaces.size(); ++place) {
      float* const all = &now.memory<float>() + place * samples_ * kAxes;
      std::copy(all + kAxes, all + samples_ * kAxes, all);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const std::size_t kind = axis / 3, number = place * kAxes + axis;
        const double offset = bias[kind] * mimo_sense_noise(now.told.seed, 0, number + kPlaces.size() * kAxes);
        const double value = read[place][axis] + offset + noise[kind] * now.noise(number);
        all[(samples_ - 1) * kAxes + axis] = static_cast<float>(std::max(-range[kind], std::min(value, range[kind])));
      }
    }
  }

  std::array<std::int32_t, kPlaces.size()> bodies_;
  std::size_t every_, samples_;  // physics steps of a sample; samples of a step
};

}  // namespace

MIMO_SENSE(mimo::sense<Imu>("imu"))
