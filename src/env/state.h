// The bytes of a saved world: a header that says what they are, then the parts of the world, then the physics.
#pragma once

#include <cstdint>

#include "base/bytes.h"
#include "base/span.h"

namespace mimo::env {

// What all states of one world have in common, and what a state to be loaded is compared with.
struct StateFormat {
  std::size_t bytes = 0;     // header included
  std::uint64_t layout = 0;  // hash of which parts there are and how long they are
  std::uint64_t model = 0;   // engine::fingerprint
};

constexpr std::size_t kStateHeaderBytes = 48;

// Fills in the header of a state whose other bytes are in place.
void seal_state(const StateFormat& format, Span<std::uint8_t> state);

// The bytes after the header. Throws Status::kInvalidArgument for anything that is no whole and sound state of this
// format.
Span<const std::uint8_t> open_state(const StateFormat& format, Span<const std::uint8_t> state);

}  // namespace mimo::env
