// What observations consist of, the same for environments and for attached senses.
#pragma once

#include "mimo/mimo.h"
#include "observation/layout.h"
#include "senses/touch/skin.h"

namespace mimo::capi {

void describe_size(const observation::Layout& layout, std::size_t* bytes, std::size_t* fields);
void describe_field(const observation::Layout& layout, std::size_t index, mimo_field* field);
const char* label_of(const observation::Layout& layout, std::size_t index, std::size_t element);

// The start of a caller's block that is long enough, or null.
std::uint8_t* block_of(const observation::Layout& layout, void* block, std::size_t bytes);

// Where the sensors of a skin go; all may be null.
struct SensorArrays {
  std::int32_t *bodies, *geoms;
  double *positions, *frames;

  bool any() const { return bodies != nullptr || geoms != nullptr || positions != nullptr || frames != nullptr; }
};

// The skin is null where there is no sense of touch.
void describe_skin(const senses::touch::Skin* skin, const SensorArrays& to, std::size_t capacity, std::size_t* count);

}  // namespace mimo::capi
