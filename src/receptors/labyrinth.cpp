#include "receptors/labyrinth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "base/functions.h"

namespace mimo::receptors {
namespace {

using Eigen::Vector3d;

// Table 1A of Della Santina et al.: normals of 44 labyrinths in Reid's frame; those of the right side are turned round,
// as a turn about them inhibits.
const std::array<Vector3d, kCanals> kCanalAxes = {
    Vector3d(-0.58954, 0.78750, -0.17971).normalized(),  Vector3d(-0.31645, -0.04108, 0.94772).normalized(),
    Vector3d(-0.69611, -0.66820, -0.26257).normalized(), Vector3d(0.58905, 0.78928, 0.17334).normalized(),
    Vector3d(0.32891, -0.03566, -0.94369).normalized(),  Vector3d(0.69248, -0.66561, 0.27826).normalized()};

// The utricle's plane is pitched nose up by 25 degrees, as its neighbour, the horizontal canal, is by some 20.
constexpr double kCos = 0.90630778703665, kSin = 0.42261826174070;
const std::array<Vector3d, kPolarisations> kPolarisations3d = {
    Vector3d(kCos, 0, kSin), Vector3d(0, 1, 0),  Vector3d(0, 0, 1), Vector3d(1, 0, 0),
    Vector3d(kCos, 0, kSin), Vector3d(0, -1, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)};

constexpr double kDegrees = 57.29577951308232;  // of a radian

// Gain K T2 / T1 in spikes/s per deg/s; T1 and T2, s.
struct Dynamics {
  double gain, lead, lag;
};
constexpr std::array<Dynamics, kAfferents> kDynamics = {
    {{2.83 * 0.0027 / 0.0175, 0.0175, 0.0027}, {27.09 * 0.0006 / 0.030, 0.030, 0.0006}}};

const Dynamics& dynamics_of(Afferent type) { return kDynamics[static_cast<std::size_t>(type)]; }

constexpr double kGravity = 9.80665;                             // m/s^2 of one g
constexpr double kCorners[Maculae::kPoles] = {0.1, 1, 10, 100};  // rad/s

// Spikes/s per g: static, and of each high-pass.
struct Gains {
  double still;
  double moving[Maculae::kPoles];
};
constexpr Gains kRegular = {46.165, {8.394, 8.539, 9.786, 14.278}};
constexpr Gains kIrregular = {30.558, {35.685, 68.376, 131.808, 377.814}};

// Laurens et al. 2013, fitted to monkeys. They store 0.247 a second of what canals of 4 s tell, nearly all that these
// forget; the same share of what ours forget.
constexpr double kBelief = 1 / 0.65;                   // s
constexpr double kStored = 0.247 * 4 / kCanalsForget;  // 1/s
constexpr double kLeak = 14;                           // s
constexpr double kCorrection = 0.38;                   // rad/s^2, where force and belief are at right angles

}  // namespace

const char* const kCanalNames[kCanals] = {"left_anterior",  "left_horizontal",  "left_posterior",
                                          "right_anterior", "right_horizontal", "right_posterior"};
const char* const kPolarisationNames[kPolarisations] = {
    "left_utricle/forward",  "left_utricle/outward",  "left_saccule/up",  "left_saccule/forward",
    "right_utricle/forward", "right_utricle/outward", "right_saccule/up", "right_saccule/forward"};

double resting_rate_of_canal(Afferent type) { return type == Afferent::kRegular ? 90 : 60; }

const Vector3d& canal_axis(std::size_t canal) { return kCanalAxes[canal]; }

const Vector3d& polarisation(std::size_t index) { return kPolarisations3d[index]; }

// Adults' vestibules lie 35 to 37 mm beside the midline, in the head of 18 months 33 mm; where they lie in a head grows
// with it. At 18 months the sphere's middle is 10 mm before the ears' axis.
Vector3d labyrinth_place(bool left, const Vector3d& middle, double radius) {
  constexpr double kBehind = 0.01 / 0.0735, kBeside = 0.45, kBelow = 0.1;  // radii
  return middle + radius * Vector3d(-kBehind, left ? kBeside : -kBeside, -kBelow);
}

// The difference of two ticks is the angular acceleration half a tick ago. Where T2 is longer than that, a low-pass
// makes it as late (the bilinear transform); where it is shorter, that low-pass would ring, and the last difference but
// one tells how the acceleration goes on.
Canals::Canals(double tick) : tick_(tick), kept_(fixed::exp(-tick / kCanalsForget)) {
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

// Between ticks the force goes in a straight line: then the filters are exact, however fast their corners are.
Maculae::Maculae(bool left, double tick) : first_(left ? 0 : kMaculae * kDirections) {
  for (std::size_t i = 0; i < kPoles; ++i) {
    kept_[i] = fixed::exp(-kCorners[i] * tick);
    taken_[i] = (1 - kept_[i]) / (kCorners[i] * tick);
    passed_[i].setZero();
  }
}

void Maculae::rest(const Eigen::Vector3d& force) {
  force_ = force / kGravity;
  for (Eigen::Vector3d& passed : passed_) passed.setZero();
}

void Maculae::advance(const Eigen::Vector3d& force) {
  const Eigen::Vector3d now = force / kGravity, change = now - force_;
  for (std::size_t i = 0; i < kPoles; ++i) passed_[i] = kept_[i] * passed_[i] + taken_[i] * change;
  force_ = now;
}

double Maculae::rate(std::size_t macula, std::size_t direction, Afferent type) const {
  const Gains& gains = type == Afferent::kRegular ? kRegular : kIrregular;
  Eigen::Vector3d drive = gains.still * force_;
  for (std::size_t i = 0; i < kPoles; ++i) drive += gains.moving[i] * passed_[i];
  const double along = polarisation(first_ + macula * kDirections + direction).dot(drive);
  return std::max(0.0, kRestingRateOfMacula + along);
}

void Maculae::save(ByteWriter& to) const {
  put(to, force_);
  for (const Eigen::Vector3d& passed : passed_) put(to, passed);
}

void Maculae::load(ByteReader& from) {
  force_ = take(from, "a macula");
  for (Eigen::Vector3d& passed : passed_) passed = take(from, "a macula");
}

GravityEstimate::GravityEstimate(double tick) : tick_(tick), kept_(fixed::exp(-tick / kBelief)) {}

void GravityEstimate::rest(const Eigen::Vector3d& force) {
  up_ = force;
  stored_.setZero();
}

// In the head's frame the world turns the other way.
void GravityEstimate::advance(const Eigen::Vector3d& force, const Eigen::Vector3d& told) {
  const Eigen::Vector3d turning = told + stored_;
  const double angle = turning.norm() * tick_;
  if (angle > 0) up_ = turn_about<Eigen::Quaterniond>(turning.normalized(), -angle) * up_;
  up_ = force + kept_ * (up_ - force);
  stored_ += tick_ * (kStored * told - stored_ / kLeak);
  const double lengths = force.norm() * up_.norm();
  if (lengths > 0) stored_ += tick_ * kCorrection / lengths * force.cross(up_);
}

void GravityEstimate::save(ByteWriter& to) const {
  put(to, up_);
  put(to, stored_);
}

void GravityEstimate::load(ByteReader& from) {
  up_ = take(from, "the estimate of gravity");
  stored_ = take(from, "the estimate of gravity");
}

}  // namespace mimo::receptors
