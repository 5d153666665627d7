#include "engine/fingerprint.h"

#include <mujoco/mjxmacro.h>

#include <cmath>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "base/hash.h"
#include "compat/mujoco.h"

namespace mimo::engine {
namespace {

std::uint64_t rounded(double number) {
  constexpr double kNoise = 1e-9;  // what is left of a zero after other sums elsewhere
  const float single = std::abs(number) < kNoise ? 0.0f : static_cast<float>(number);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &single, sizeof bits);
  return bits;
}

template <typename T>
void add(Hash& hash, const T* values, std::size_t count) {
  if constexpr (std::is_floating_point_v<T>) {
    for (std::size_t i = 0; i < count; ++i) hash.add(rounded(static_cast<double>(values[i])));
  } else {
    hash.add(Span<const std::uint8_t>(reinterpret_cast<const std::uint8_t*>(values), count * sizeof(T)));
  }
}

void add_options(Hash& hash, const mjOption& opt) {
#if MIMO_MUJOCO_4
#define X(type, name, count) add(hash, &opt.name, 1);
#define XVEC(type, name, count) add(hash, opt.name, count);
  MJOPTION_FIELDS
#undef XVEC
#undef X
#else
#define X(type, name) add(hash, &opt.name, 1);
  MJOPTION_SCALARS
#undef X
#define X(name, count) add(hash, opt.name, count);
  MJOPTION_VECTORS
#undef X
#endif
}

}  // namespace

std::uint64_t shape(const mjModel& model) {
  Hash hash;
#define X(name) hash.add(static_cast<std::uint64_t>(model.name));
  MIMO_MODEL_SIZES
#undef X
  hash.add({reinterpret_cast<const std::uint8_t*>(model.names), static_cast<std::size_t>(model.nnames)});
  return hash.value();
}

std::uint64_t fingerprint(const mjModel& model) {
  Hash hash;
#define X(name) hash.add(static_cast<std::uint64_t>(model.name));
  MIMO_MODEL_SIZES
#undef X
  add_options(hash, model.opt);
  MJMODEL_POINTERS_PREAMBLE((&model))
#define X(type, name, rows, columns)                            \
  if constexpr (std::string_view(#name) != compat::kPixelsName) \
    add(hash, model.name, static_cast<std::size_t>(model.rows) * static_cast<std::size_t>(columns));
  MJMODEL_POINTERS
#undef X
  return hash.value();
}

}  // namespace mimo::engine
