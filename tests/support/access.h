// Named access to a world, with vectors.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "access/access.h"

namespace mimo::test {

using Ids = std::vector<std::int32_t>;
using Values = std::vector<double>;

inline Values get(const env::World& world, access::Quantity quantity, const Ids& ids, bool now = false) {
  const access::Ids which{Span<const std::int32_t>(ids)};
  Values values(access::width(world, quantity, which));
  access::get(world, quantity, which, now, Span<double>(values));
  return values;
}

// Of all of its kind.
inline Values get(const env::World& world, access::Quantity quantity) {
  const access::Ids all(access::count(world, access::traits(quantity).kind()));
  Values values(access::width(world, quantity, all));
  access::get(world, quantity, all, false, Span<double>(values));
  return values;
}

inline void set(env::World& world, access::Quantity quantity, const Ids& ids, const Values& values) {
  const access::Ids which{Span<const std::int32_t>(ids)};
  ASSERT_EQ(access::width(world, quantity, which), values.size());
  access::set(world, quantity, which, Span<const double>(values));
}

inline std::int32_t id_of(const env::World& world, access::Kind kind, const char* name) {
  return access::find_or_fail(world, kind, name);
}

}  // namespace mimo::test
