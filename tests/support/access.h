// Named access to a world, with vectors.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "access/access.h"

namespace mimo::test {

using Ids = std::vector<std::int32_t>;
using Values = std::vector<double>;

inline Values get(const env::World& world, mimo_quantity quantity, const Ids& ids, bool now = false) {
  const access::Ids which{Span<const std::int32_t>(ids)};
  Values values(access::width(world, access::quantity_of(quantity), which));
  access::get(world, access::quantity_of(quantity), which, now, Span<double>(values));
  return values;
}

// Of all of its kind.
inline Values get(const env::World& world, mimo_quantity quantity) {
  const access::Ids all(access::quantity_of(quantity).kind().count(world));
  Values values(access::width(world, access::quantity_of(quantity), all));
  access::get(world, access::quantity_of(quantity), all, false, Span<double>(values));
  return values;
}

inline void set(env::World& world, mimo_quantity quantity, const Ids& ids, const Values& values) {
  const access::Ids which{Span<const std::int32_t>(ids)};
  ASSERT_EQ(access::width(world, access::quantity_of(quantity), which), values.size());
  access::set(world, access::quantity_of(quantity), which, Span<const double>(values));
}

inline std::int32_t id_of(const env::World& world, mimo_kind kind, const char* name) {
  return access::find_or_fail(world, access::kind_of(kind), name);
}

}  // namespace mimo::test
