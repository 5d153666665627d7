#include "observation/field.h"

namespace mimo::observation {
namespace {

using Position = Eigen::Map<Eigen::Vector3d>;
using Frame = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

void read(const Receptor& receptor, ReceptorQuantity quantity, double* values) {
  switch (quantity) {
    case ReceptorQuantity::kBody: *values = receptor.body; break;
    case ReceptorQuantity::kGeom: *values = receptor.geom; break;
    case ReceptorQuantity::kPosition: Position{values} = receptor.position; break;
    case ReceptorQuantity::kFrame: Frame{values} = receptor.frame; break;
  }
}

}  // namespace

std::size_t size_of(Type type) {
  switch (type) {
    case Type::kU8: return 1;
    case Type::kI32:
    case Type::kF32: return 4;
    case Type::kF64: return 8;
  }
  return 0;
}

std::size_t Field::count() const {
  std::size_t product = 1;
  for (const std::size_t extent : shape) product *= extent;
  return product;
}

const char* Field::label(std::size_t i) const { return i < labels.size() ? labels[i].c_str() : ""; }

const char* constant(ReceptorQuantity quantity) {
  switch (quantity) {
    case ReceptorQuantity::kBody: return "MIMO_RECEPTOR_BODY";
    case ReceptorQuantity::kGeom: return "MIMO_RECEPTOR_GEOM";
    case ReceptorQuantity::kPosition: return "MIMO_RECEPTOR_POSITION";
    case ReceptorQuantity::kFrame: return "MIMO_RECEPTOR_FRAME";
  }
  return "";
}

std::size_t width(ReceptorQuantity quantity) {
  switch (quantity) {
    case ReceptorQuantity::kBody:
    case ReceptorQuantity::kGeom: return 1;
    case ReceptorQuantity::kPosition: return 3;
    case ReceptorQuantity::kFrame: return 9;
  }
  return 0;
}

void read(Span<const Receptor> receptors, ReceptorQuantity quantity, double* values) {
  for (std::size_t i = 0; i < receptors.size(); ++i) read(receptors[i], quantity, values + i * width(quantity));
}

}  // namespace mimo::observation
