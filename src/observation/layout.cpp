#include "observation/layout.h"

#include <algorithm>

namespace mimo::observation {
namespace {

constexpr std::size_t kAlignment = 64;

std::size_t aligned(std::size_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

void Layout::add(Field& field) {
  field.offset = bytes_;
  bytes_ += aligned(field.bytes());
  fields_.push_back(&field);
}

void Layout::clear_gaps(std::uint8_t* block) const {
  for (const Field* field : fields_) {
    const std::size_t end = field->offset + field->bytes();
    std::fill(block + end, block + aligned(end), std::uint8_t{0});
  }
}

}  // namespace mimo::observation
