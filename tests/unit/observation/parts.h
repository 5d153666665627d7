// A simulation without MuJoCo, of which the room knows but the names, and fields to sense of it.
#pragma once

#include "observation/sense.h"

struct mjModel_ {};
struct mjData_ {
  float value;
};

namespace mimo::observation {

inline Field field(const std::string& name, std::size_t count) {
  Field field;
  field.name = name;
  field.shape = {count};
  return field;
}

// All of its numbers are the data's value plus `offset`.
inline Signal signal(const std::string& name, std::size_t count, float offset = 0) {
  return {field(name, count), [count, offset](const mjModel&, const mjData& data, float* out) {
            for (std::size_t i = 0; i < count; ++i) out[i] = data.value + offset;
          }};
}

}  // namespace mimo::observation
