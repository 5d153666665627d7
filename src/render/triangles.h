// The triangles that a model's meshes and height fields consist of, in their own frames.
#pragma once

#include <mujoco/mjmodel.h>

#include <Eigen/Core>
#include <array>
#include <functional>

namespace mimo::render {

struct Corner {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  std::array<double, 2> texture{};
};
using Corners = std::array<Corner, 3>;  // counter-clockwise from outside
using TakeTriangle = std::function<void(const Corners&)>;

void each_triangle_of_mesh(const mjModel& model, int id, const TakeTriangle& take);
void each_triangle_of_field(const mjModel& model, int id, const TakeTriangle& take);

}  // namespace mimo::render
