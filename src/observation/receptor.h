// Receptors: the places in a skin on which a field reports.
#pragma once

#include <Eigen/Core>

#include "base/span.h"

namespace mimo::observation {

struct Receptor {
  int body;
  int geom;
  Eigen::Vector3d position;  // body frame, m
  Eigen::Matrix3d frame;     // rows, body frame: outward normal, first tangent, second tangent

  auto normal() const { return frame.row(0).transpose(); }
};

// As mimo.h numbers them (MIMO_RECEPTOR_...).
enum class ReceptorQuantity : int { kBody = 1, kGeom, kPosition, kFrame };
constexpr int kReceptorQuantities = 4;

// How many numbers one receptor has of it.
std::size_t width(ReceptorQuantity quantity);
// Of all, one after the other.
void read(Span<const Receptor> receptors, ReceptorQuantity quantity, double* values);

}  // namespace mimo::observation
