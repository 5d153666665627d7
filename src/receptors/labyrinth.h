// What one head's two labyrinths share: where they lie, how they are turned, and how their afferents fire. A head's
// frame has x to the nose, y to the left ear, z up.
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace mimo::receptors {

// Regular afferents fire evenly and follow slow motion best; irregular ones tell the onset. Both are of macaques.
enum class Afferent { kRegular, kIrregular };
constexpr std::size_t kAfferents = 2;

// Rates while nothing moves, Hz.
double resting_rate_of_canal(Afferent type);
constexpr double kRestingRateOfMacula = 70;

// LA, LH, LP, RA, RH, RP: left and right; anterior, horizontal, posterior.
constexpr std::size_t kCanals = 6;
extern const char* const kCanalNames[kCanals];
// The unit vector about which a turn excites a canal (right-hand rule). Della Santina et al. 2005, JARO 6:191.
const Eigen::Vector3d& canal_axis(std::size_t canal);

// Left and right; utricle and saccule; two directions each.
constexpr std::size_t kSides = 2, kMaculae = 2, kDirections = 2;
constexpr std::size_t kPolarisations = kSides * kMaculae * kDirections;
extern const char* const kPolarisationNames[kPolarisations];
// The direction of the specific force (what an accelerometer reads) that excites these hair cells.
const Eigen::Vector3d& polarisation(std::size_t index);

// Where a labyrinth lies, given the sphere that a head is: its middle and radius, m.
Eigen::Vector3d labyrinth_place(bool left, const Eigen::Vector3d& middle, double radius);

}  // namespace mimo::receptors
