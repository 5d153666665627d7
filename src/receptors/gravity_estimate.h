// Where up is, as a brain may work it out of canals and otoliths: what is felt as force is believed slowly, and turned
// along with the head at once (Angelaki 1999 found such a use of canals in monkeys; the form and its time are a
// choice). Shaking adds forces that do not last, so that it cannot forge gravity.
#pragma once

#include <Eigen/Core>

#include "base/bytes.h"

namespace mimo::receptors {

class GravityEstimate {
 public:
  explicit GravityEstimate(double tick);

  // m/s^2, head's frame, as an accelerometer reads it at rest: upright (0, 0, 9.8).
  void rest(const Eigen::Vector3d& force) { up_ = force; }
  // `turning` as the canals tell it, rad/s.
  void advance(const Eigen::Vector3d& force, const Eigen::Vector3d& turning);
  const Eigen::Vector3d& up() const { return up_; }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  double tick_, kept_;
  Eigen::Vector3d up_ = Eigen::Vector3d::Zero();
};

}  // namespace mimo::receptors
