// The caller's memory for observations.
#pragma once

#include "capi/check.h"
#include "observation/layout.h"

namespace mimo::capi {

// The start of a caller's block that is long enough, or null.
inline std::uint8_t* block_of(const observation::Layout& layout, void* block, std::size_t bytes) {
  auto* start = static_cast<std::uint8_t*>(block);
  check_buffer(start, bytes, layout.bytes(), "block");
  return start;
}

}  // namespace mimo::capi
