// The otolith organs: specific force (gravity and acceleration together) as afferents of utricles and saccules tell it.
//
// Afferents of macaques (Schneider et al. 2015): H(s) = K s^k1 (1 + a s)^k2 / (1 + b s), g to spikes/s. Its fractional
// power is a constant and four high-passes, fitted from 0.01 to 10 Hz within 1.3 % (regular) and 3.8 % (irregular).
#pragma once

#include <Eigen/Core>
#include <array>

#include "base/bytes.h"
#include "receptors/labyrinth.h"

namespace mimo::receptors {

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

}  // namespace mimo::receptors
