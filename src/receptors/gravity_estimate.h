// Where up is, as a brain may work it out of canals and otoliths (Laurens and Angelaki 2011, Laurens et al. 2013): what
// is felt as force is believed slowly, and turned along with the head at once. Canals forget a turn and tell another
// one back when it ends; a store of velocity makes up for that, and what force and belief disagree about corrects the
// store. Shaking adds forces that do not last, so that it cannot forge gravity.
#pragma once

#include <Eigen/Core>

#include "base/bytes.h"

namespace mimo::receptors {

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
