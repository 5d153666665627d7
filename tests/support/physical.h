// Comparing two compiled models in everything that physics sees.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mjmodel.h>
#include <mujoco/mjxmacro.h>

#include <set>
#include <string>

#include "support/numbers.h"

namespace mimo::test {

// How things look and what they are called is no physics.
inline bool is_physical(const std::string& array) {
  for (const char* prefix :
       {"tex_", "mat_", "name", "light_", "skin_", "text_", "mesh_texcoord", "numeric_", "cam_user", "paths",
        "mesh_path", "hfield_path", "mesh_contenttype", "hfield_contenttype"}) {
    if (array.rfind(prefix, 0) == 0) return false;
  }
  static const std::set<std::string> looks = {"geom_rgba",  "geom_matid",  "site_rgba",
                                              "site_matid", "tendon_rgba", "tendon_matid"};
  return looks.count(array) == 0;
}

// Every array of numbers of two models of the same structure.
inline void expect_same_physics(const mjModel& expected, const mjModel& actual, const Tolerance& tolerance = {0, 0}) {
  ASSERT_EQ(expected.nq, actual.nq);
  ASSERT_EQ(expected.nbody, actual.nbody);
  ASSERT_EQ(expected.ngeom, actual.ngeom);
  ASSERT_EQ(expected.nsensor, actual.nsensor);
  ASSERT_EQ(expected.neq, actual.neq);
  ASSERT_EQ(expected.ntendon, actual.ntendon);
  const auto compare = [&](const char* array, int count, int other_count, const auto* one, const auto* two) {
    if (!is_physical(array)) return;
    ASSERT_EQ(count, other_count) << array;
    for (int i = 0; i < count; ++i) {
      ASSERT_TRUE(close(static_cast<double>(one[i]), static_cast<double>(two[i]), tolerance))
          << array << "[" << i << "]";
    }
  };
  MJMODEL_POINTERS_PREAMBLE((&expected))
#define X(type, name, nr, nc)                                          \
  compare(#name, static_cast<int>(expected.nr) * static_cast<int>(nc), \
          static_cast<int>(actual.nr) * static_cast<int>(nc), expected.name, actual.name);
  MJMODEL_POINTERS
#undef X
}

}  // namespace mimo::test
