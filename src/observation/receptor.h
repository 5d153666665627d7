// Receptors: the places in a skin on which a field reports.
#pragma once

#include <Eigen/Core>

#include "base/span.h"
#include "mimo/observation.h"

namespace mimo::observation {

struct Receptor {
  int body;
  int geom;
  Eigen::Vector3d position;  // body frame, m
  Eigen::Matrix3d frame;     // rows, body frame: outward normal, first tangent, second tangent

  auto normal() const { return frame.row(0).transpose(); }
};

// Of the header.
enum class ReceptorQuantity : mimo_quantity {
  kBody = MIMO_RECEPTOR_BODY,
  kGeom = MIMO_RECEPTOR_GEOM,
  kPosition = MIMO_RECEPTOR_POSITION,
  kFrame = MIMO_RECEPTOR_FRAME,
};

const char* constant(ReceptorQuantity quantity);  // "MIMO_RECEPTOR_POSITION"
// How many numbers one receptor has of it.
std::size_t width(ReceptorQuantity quantity);
// Of all, one after the other.
void read(Span<const Receptor> receptors, ReceptorQuantity quantity, double* values);

}  // namespace mimo::observation
