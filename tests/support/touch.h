// Reading what the touch sensors of a world felt.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "support/block.h"

namespace mimo::test {

using senses::touch::Vec3;

inline const std::vector<senses::touch::Sensor>& sensors_of(const env::World& world, std::size_t agent = 0) {
  return world.agents().at(agent).skin->sensors();
}

inline Eigen::Matrix3d rotation_of(const mjData& data, int body) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.xmat + 9 * body);
}

// Sum of the forces that each body's sensors felt, as the field has them: body or world frame.
inline std::map<int, Vec3> sum_by_body(const env::World& world, const std::vector<float>& force,
                                       std::size_t agent = 0) {
  std::map<int, Vec3> sums;
  const auto& sensors = sensors_of(world, agent);
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const Vec3 own(static_cast<double>(force[3 * i]), static_cast<double>(force[3 * i + 1]),
                   static_cast<double>(force[3 * i + 2]));
    sums.try_emplace(sensors[i].body, Vec3::Zero()).first->second += own;
  }
  return sums;
}

// What the engine says that acts on a body, world frame; and the sum of magnitudes, which tells how exact a sum can be.
struct Load {
  Vec3 force = Vec3::Zero();
  double magnitude = 0;
};

inline std::map<int, Load> loads(const mjModel& model, const mjData& data) {
  std::map<int, Load> loads;
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    const auto force = engine::contact_force(model, data, i);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(contact.frame);
    const Vec3 on_second = frame.transpose() * Vec3(force.data());
    for (const auto& [geom, sign] : {std::pair(contact.geom1, -1.0), std::pair(contact.geom2, 1.0)}) {
      Load& load = loads[model.geom_bodyid[geom]];
      load.force += sign * on_second;
      load.magnitude += on_second.norm();
    }
  }
  return loads;
}

}  // namespace mimo::test
