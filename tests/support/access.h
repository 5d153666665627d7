// Named access to a world, with vectors.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "env/access.h"

namespace mimo::test {

using Ids = std::vector<std::int32_t>;
using Values = std::vector<double>;

inline Values get(const env::World& world, env::Quantity quantity, const Ids& ids, bool now = false) {
  const env::Ids which{Span<const std::int32_t>(ids)};
  Values values(env::width(world, quantity, which));
  env::get(world, quantity, which, now, Span<double>(values));
  return values;
}

// Of all of its kind.
inline Values get(const env::World& world, env::Quantity quantity) {
  const env::Ids all(env::count(world, env::traits(quantity).kind()));
  Values values(env::width(world, quantity, all));
  env::get(world, quantity, all, false, Span<double>(values));
  return values;
}

inline void set(env::World& world, env::Quantity quantity, const Ids& ids, const Values& values) {
  const env::Ids which{Span<const std::int32_t>(ids)};
  ASSERT_EQ(env::width(world, quantity, which), values.size());
  env::set(world, quantity, which, Span<const double>(values));
}

inline std::int32_t id_of(const env::World& world, env::Kind kind, const char* name) {
  return env::find_or_fail(world, kind, name);
}

}  // namespace mimo::test
