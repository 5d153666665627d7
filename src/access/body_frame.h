// The frame of a body, which moves along with it: what else is in space as seen from there.
#pragma once

#include <Eigen/Geometry>

#include "access/quantities.h"

namespace mimo::access {

class BodyFrame {
 public:
  BodyFrame(const mjModel& model, const mjData& data, int body);

  // Values of the world's frame become those of this one; `at` is where the element is that they belong to.
  void see(Spatial what, const Eigen::Vector3d& at, double* values) const;

 private:
  void see_position(double* values) const;
  void see_orientation(double* values) const;
  void see_velocity(const Eigen::Vector3d& at, double* values) const;

  Eigen::Vector3d position_;
  Eigen::Quaterniond from_world_;
  Eigen::Vector3d velocity_, spin_;
};

// Where an element of a quantity that can be seen from other frames is.
Eigen::Vector3d place_of(const mjData& data, mimo_kind kind, int id);

}  // namespace mimo::access
