// The labyrinths of a head: semicircular canals, otolith organs, and the estimate of where up is.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "base/bytes.h"

namespace mimo::receptors {

// Vectors in states.

inline void put(ByteWriter& to, const Eigen::Vector3d& vector) { to.put(Span<const double>(vector.data(), 3)); }

inline Eigen::Vector3d take(ByteReader& from, const char* what) {
  Eigen::Vector3d vector;
  for (double& number : vector) number = from.take_finite(what);
  return vector;
}

// What one head's two labyrinths share: where they lie, how they are turned, and how their afferents fire. A head's
// frame has x to the nose, y to the left ear, z up.

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

// The semicircular canals: a turn of the head as their afferents tell it.
//
// A canal is a torsion pendulum: what goes on turning evenly is forgotten with 5.7 s (Fernandez and Goldberg 1971), and
// when it stops, the opposite is told. Afferents of macaques (Schneider et al. 2015, after Hullar 2005): H(s) = K s
// (s + 1/T1) / ((s + 1/Tc)(s + 1/T2)), deg/s to spikes/s above rest.

constexpr double kCanalsForget = 5.7;  // s, Tc

class Canals {
 public:
  // `tick` is the time between two calls of advance, s.
  explicit Canals(double tick);

  // The head has turned like this for ever: nothing is told of it. rad/s, in the head's frame.
  void rest(const Eigen::Vector3d& angular_velocity);
  void advance(const Eigen::Vector3d& angular_velocity);

  // Hz, 0 or above.
  double rate(std::size_t canal, Afferent type) const;
  // What the canals together tell of the turn: right where it changes, forgotten where it goes on. rad/s.
  const Eigen::Vector3d& told() const { return passed_; }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  // The lead of one kind of afferents: the head's angular acceleration, as late as T2 makes it.
  struct Lead {
    double kept = 0, bend = 0;
    Eigen::Vector3d told = Eigen::Vector3d::Zero();  // rad/s^2
  };

  double tick_, kept_;
  // All canals are linear and alike, so that one filter of the head's turn serves them all.
  Eigen::Vector3d passed_ = Eigen::Vector3d::Zero();  // high-passed, rad/s
  Eigen::Vector3d before_ = Eigen::Vector3d::Zero();  // angular velocity at the last tick
  Eigen::Vector3d change_ = Eigen::Vector3d::Zero();  // its change in it
  std::array<Lead, kAfferents> leads_;
};

// The otolith organs: specific force (gravity and acceleration together) as afferents of utricles and saccules tell it.
//
// Afferents of macaques (Schneider et al. 2015): H(s) = K s^k1 (1 + a s)^k2 / (1 + b s), g to spikes/s. Its fractional
// power is a constant and four high-passes, fitted from 0.01 to 10 Hz within 1.3 % (regular) and 3.8 % (irregular).

// The afferents of the two maculae of one side.
class Maculae {
 public:
  Maculae(bool left, double tick);

  // The force has been like this for ever: what a standing head is told. m/s^2, head's frame, as an accelerometer at
  // the organ reads it: upright at rest it is (0, 0, 9.8).
  void rest(const Eigen::Vector3d& force);
  void advance(const Eigen::Vector3d& force);

  // Hz, 0 or above; macula 0 is the utricle, 1 the saccule.
  double rate(std::size_t macula, std::size_t direction, Afferent type) const;

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

  static constexpr std::size_t kPoles = 4;

 private:
  std::size_t first_;  // of its polarisations
  std::array<double, kPoles> kept_, taken_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();  // g
  std::array<Eigen::Vector3d, kPoles> passed_;       // high-passed, g
};

// Where up is, as a brain may work it out of canals and otoliths (Laurens and Angelaki 2011, Laurens et al. 2013): what
// is felt as force is believed slowly, and turned along with the head at once. Canals forget a turn and tell another
// one back when it ends; a store of velocity makes up for that, and what force and belief disagree about corrects the
// store. Shaking adds forces that do not last, so that it cannot forge gravity.

class GravityEstimate {
 public:
  explicit GravityEstimate(double tick);

  // m/s^2, head's frame, as an accelerometer reads it at rest: upright (0, 0, 9.8).
  void rest(const Eigen::Vector3d& force);
  // `told`: the turn as the canals tell it, rad/s.
  void advance(const Eigen::Vector3d& force, const Eigen::Vector3d& told);
  const Eigen::Vector3d& up() const { return up_; }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  double tick_, kept_;
  Eigen::Vector3d up_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d stored_ = Eigen::Vector3d::Zero();  // rad/s: of the turn that canals have forgotten
};

}  // namespace mimo::receptors
