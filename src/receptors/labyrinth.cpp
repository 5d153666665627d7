#include "receptors/labyrinth.h"

#include <array>

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

}  // namespace mimo::receptors
