// The semicircular canals: a turn of the head as their afferents tell it.
//
// A canal is a torsion pendulum: what goes on turning evenly is forgotten with 5.7 s (Fernandez and Goldberg 1971), and
// when it stops, the opposite is told. Afferents of macaques (Schneider et al. 2015, after Hullar 2005): H(s) = K s
// (s + 1/T1) / ((s + 1/Tc)(s + 1/T2)), deg/s to spikes/s above rest.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "base/bytes.h"
#include "receptors/labyrinth.h"

namespace mimo::receptors {

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

}  // namespace mimo::receptors
