#include "receptors/canals.h"

#include <algorithm>
#include <cmath>

#include "receptors/vectors.h"

namespace mimo::receptors {
namespace {

constexpr double kDegrees = 57.29577951308232;  // of a radian

// Gain K T2 / T1 in spikes/s per deg/s; T1 and T2, s.
struct Dynamics {
  double gain, lead, lag;
};
constexpr std::array<Dynamics, kAfferents> kDynamics = {
    {{2.83 * 0.0027 / 0.0175, 0.0175, 0.0027}, {27.09 * 0.0006 / 0.030, 0.030, 0.0006}}};

const Dynamics& dynamics_of(Afferent type) { return kDynamics[static_cast<std::size_t>(type)]; }

}  // namespace

// The difference of two ticks is the angular acceleration half a tick ago. Where T2 is longer than that, a low-pass
// makes it as late (the bilinear transform); where it is shorter, that low-pass would ring, and the last difference but
// one tells how the acceleration goes on.
Canals::Canals(double tick) : tick_(tick), kept_(std::exp(-tick / kCanalsForget)) {
  constexpr double kEnough = 0.1;  // ticks: closer than that costs below 1 % at 5 Hz
  for (std::size_t i = 0; i < kAfferents; ++i) {
    const double late = kDynamics[i].lag / tick - 0.5;
    if (late > kEnough) leads_[i].kept = late / (1 + late);
    if (late < -kEnough) leads_[i].bend = -late;
  }
}

void Canals::rest(const Eigen::Vector3d& angular_velocity) {
  passed_.setZero();
  change_.setZero();
  for (Lead& lead : leads_) lead.told.setZero();
  before_ = angular_velocity;
}

void Canals::advance(const Eigen::Vector3d& angular_velocity) {
  const Eigen::Vector3d change = angular_velocity - before_, bend = change - change_;
  passed_ = kept_ * passed_ + change;
  for (Lead& lead : leads_) {
    lead.told = lead.kept * lead.told + (1 - lead.kept) / tick_ * (change + lead.bend * bend);
  }
  change_ = change;
  before_ = angular_velocity;
}

double Canals::rate(std::size_t canal, Afferent type) const {
  const Dynamics& of = dynamics_of(type);
  const Eigen::Vector3d& acceleration = leads_[static_cast<std::size_t>(type)].told;
  const double drive = canal_axis(canal).dot(passed_ + (of.lead - of.lag) * acceleration) * kDegrees;
  return std::max(0.0, resting_rate_of_canal(type) + of.gain * drive);
}

void Canals::save(ByteWriter& to) const {
  for (const Eigen::Vector3d* vector : {&passed_, &before_, &change_}) put(to, *vector);
  for (const Lead& lead : leads_) put(to, lead.told);
}

void Canals::load(ByteReader& from) {
  for (Eigen::Vector3d* vector : {&passed_, &before_, &change_}) *vector = take(from, "a canal");
  for (Lead& lead : leads_) lead.told = take(from, "a canal");
}

}  // namespace mimo::receptors
