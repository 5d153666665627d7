#include "observation/field.h"

namespace mimo::observation {

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

}  // namespace mimo::observation
